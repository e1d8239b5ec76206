"""Sizes of what is dropped, what the errata do, and what was computed about the text beside the equations."""

import math
from collections.abc import Callable
from functools import cache

import sympy as sp
from flint import arb

from boresight.derive.ledger.ellipsoid import WORKING
from boresight.derive.ledger.evaluate import DIGITS
from boresight.derive.ledger.navigation import Navigator, Truth, stack, truth
from boresight.derive.ledger.numbers import Matrix, atan2, digits, exact, eye, norm, pi, shown, zeros
from boresight.derive.ledger.witness import hamilton, vector
from boresight.derive.mechanics import earth
from boresight.derive.papers.kim_2018 import results as paper
from boresight.derive.papers.kim_2018.witness import (
    DEGREE,
    HOUR,
    MILE,
    STATED,
    G,
    attitudes,
    curvature,
    matrices,
    series,
    transition,
)

# The text between the equations: line, and what it says.
DETECTORS = (198, "각속도 이동평균값과 각속도의 이동표준편차")  # the moving mean of the rate and its moving deviation

# Table 1, lines 217 to 224: repeatability of bias, stability of scale factor, misalignment, random walk.
TABLE_1_LINES = (217, 224)
TABLE_1 = {"gyro": ("1", "150", "100", "0.125"), "accelerometer": ("1", "300", "100", "0.065")}
TABLE_1_UNITS = {"gyro": ("deg/hr", "ppm", "urad", "deg/√hr"), "accelerometer": ("mg", "ppm", "urad", "ft/sec/√hr")}


LATITUDE = 37  # deg, where the sizes are given, at rest unless they say otherwise


def evidence(number: str) -> str:
    """What the ledger says beyond the status: sizes, and runs of the print's own dynamics; "" for most equations."""
    if number not in _EVIDENCE:
        return ""
    with digits(DIGITS):
        return _EVIDENCE[number]()


def findings() -> tuple[str, ...]:
    """What was computed about the text beside the equations."""
    earth_rate = float(earth.EARTH_RATE) / DEGREE * HOUR
    north = 1 / (earth_rate * math.cos(LATITUDE * DEGREE)) / DEGREE
    return (
        f"Line {DETECTORS[0]} has the detector of mean and deviation both of the angular rate; its reasons, and (31), "
        "want the deviation of the specific force; in Korean the two words differ in one syllable.",
        "The letter φ is two states: psi in (1) to (6), phi in (8) to (29); between them lies the turn of the level by "
        f"the position error, 1 arcmin per nautical mile, and psi does not see δω_in_n, {_level_rate()} deg/h per m/s.",
        "(17) and (23) are written for 24 states, nine more than (8): scale factors and misalignments of Table 1 "
        "would fill them.",
        f"Table 1 beside the Earth's rate of {earth_rate:.4g} deg/h: a gyro of 1 deg/h finds north at "
        f"latitude {LATITUDE} deg to {north:.2g} deg, 1 mg tilts the level by 1 mrad = 3.4 arcmin.",
    )


@cache
def _at_rest() -> Truth:
    C = eye(3)
    with digits(WORKING):
        position = vector(0, exact(LATITUDE) * pi() / 180, 0)
        still = Navigator(position, zeros(3, 1), C, zeros(3, 1), zeros(3, 1))
        return truth(position, zeros(3, 1), C, -still.gravity_n, still.omega_ie_n)


def level_dynamics(sign: int) -> Matrix:
    """F at rest without the vertical channel, 7x7: longitude, latitude, level velocities, attitude.

    sign: of δω_in_n in (11); +1 is right, -1 as printed.
    """
    F = matrices(_at_rest())[0].copy()
    F[6:9, 0:6] = F[6:9, 0:6] * sign
    kept = (0, 1, 3, 4, 6, 7, 8)
    return Matrix([[F[i, j] for j in kept] for i in kept])


def _growth(sign: int) -> arb:
    return max(value.real for value in level_dynamics(sign).balls.eig(multiple=True))


def _level_rate() -> str:
    return f"{1 / 6.37e6 / DEGREE * HOUR:.2g}"


def _psi_sizes() -> str:
    return (
        f"not in it: sensors of Table 1, {1e-3 * G:.2g} m/s^2 and 1 deg/h, for which the filter has noise; gravity at "
        f"a position 1 nmi off, {G / 6.37e6 * MILE:.2g} m/s^2; as a phi model, δω_in_n of {_level_rate()} deg/h per m/s"
    )


def delay_estimate(column: str) -> tuple[float, float]:
    """The delay (s) which least squares find in Z_v from a column of (6), the true one 50 ms: level and vertical.

    A bench rocks with 1 m/s^2 at 1 Hz; column: derived (the acceleration), or printed (minus the specific force).
    """
    times = [k / 100 for k in range(100)]
    acceleration = [math.sin(2 * math.pi * t) for t in times]

    def fit(steady: float) -> float:
        model = acceleration if column == "derived" else [-(a + steady) for a in acceleration]
        return 0.05 * sum(a * m for a, m in zip(acceleration, model, strict=True)) / sum(m * m for m in model)

    return fit(0.0), fit(G)


def _delay() -> str:
    level, vertical = delay_estimate("printed")
    return (
        f"on a bench that rocks with 1 m/s^2 a delay of 50 ms is estimated as {level * 1e3:.3g} ms with the printed "
        f"column along the level, so that correcting doubles it, and as {vertical * 1e3:.2g} ms along the vertical, "
        f"where f is {G:.3g} m/s^2 even at rest; with the derived one as {delay_estimate('derived')[0] * 1e3:.3g} ms"
    )


def _position_run() -> str:
    base = STATED
    R_E, R_N, _, R_NN, rho_e, rho_n, _ = (float(x) for x in curvature(base))
    (_, lat, height), (_, dlat, dh) = ((float(x) for x in part) for part in (base.position, base.position_error))
    east = (rho_e - rho_n) * math.tan(lat) / math.cos(lat) * dlat * (R_E + height) * math.cos(lat)
    radius = rho_e * R_NN * (1 / (R_E + height) - 1 / (R_N + height)) * dlat * (R_N + height)
    sign = -2 * rho_e * dh
    return (
        f"in 1000 s there the print puts {1000 * east:.3g} m into the longitude by ρ_e for ρ_n, {1000 * sign:.3g} m "
        f"into the latitude by the sign of δh and {1000 * radius:.2g} m by R_E for R_N; at rest ρ is 0 and nothing "
        "is wrong: the paper's experiment does not see it"
    )


def _schuler() -> str:
    right, wrong = _growth(1), _growth(-1)

    def tilt(sign: int) -> float:
        """Level velocity (m/s) per hour after a tilt of 0.1 mrad about east."""
        F = level_dynamics(sign)
        return float(series(Matrix([0, 0, 0, 0, 1e-4, 0, 0]), lambda term: F * term, 3600)[3])

    return (
        f"at rest the level channels' eigenvalues have real parts below {shown(max(right, 1e-20), 1)} 1/s "
        f"as derived, and up to {shown(wrong, 4)} 1/s as printed: instead of an oscillation of 84 min errors grow "
        f"e-fold in {float(1 / wrong):.0f} s; a tilt of 0.1 mrad makes a velocity of {tilt(1):.2g} m/s after an hour "
        f"as derived, {tilt(-1):.3g} m/s as printed"
    )


def transition_error(step) -> dict[str, arb]:
    """The largest entry of exp(F step) - I - F step by block, row from column, at rest."""
    F = matrices(_at_rest())[0]
    missing = transition(_at_rest(), exact(step)) - eye(15) - F * step
    names = ("position", "velocity", "attitude", "gyro bias", "accelerometer bias")
    sizes = {}
    for i, row in enumerate(names):
        for j, col in enumerate(names):
            largest = max(abs(missing[3 * i + a, 3 * j + b]) for a in range(3) for b in range(3))
            if largest:
                sizes[f"{row} from {col}"] = largest
    return sizes


def _steps() -> str:
    parts = []
    for step, rate in (("0.01", "100 Hz"), ("1", "1 Hz")):
        sizes = transition_error(exact(step))
        parts.append(
            f"{rate}: "
            + ", ".join(
                f"{name} {float(sizes[name]):.2g} {unit}"
                for name, unit in (
                    ("velocity from gyro bias", "(m/s)/(rad/s)"),
                    ("velocity from attitude", "(m/s)/rad"),
                    ("attitude from attitude", ""),
                )
            ).rstrip()
        )
    schuler = G / 6.37e6
    growth = ", ".join(
        f"{math.expm1(schuler * step * 1800):.2g} at {rate}" for step, rate in ((0.01, "100 Hz"), (1, "1 Hz"))
    )
    drift = float(transition_error(exact(1))["velocity from gyro bias"]) * DEGREE / HOUR
    return (
        f"dropped against the matrix exponential, largest entries of blocks, at rest: {'; '.join(parts)}; with 1 deg/h "
        f"that is {drift:.2g} m/s per step at 1 Hz; Schuler's oscillation, which must not grow, grows in an hour by "
        f"{growth}"
    )


def held_azimuth(share: float) -> float:
    """Azimuth error (arcmin) after 1000 s at 1 Hz, gain 0.1, against 1 deg/h; share: of φ_u in the residual."""
    error = 0.0
    for _ in range(1000):
        error += 1 / 60  # arcmin per second
        error -= 0.1 * share * error
    return error


def _held(share: float, what: str) -> str:
    return (
        f"{what}, and H says 1: a hold with gain 0.1 at 1 Hz against 1 deg/h keeps {held_azimuth(share):.3g} arcmin, "
        f"as derived {held_azimuth(1):.3g}"
    )


def feedback_readings() -> dict[str, arb]:
    """The attitude error (rad) that is left by each way of reading (29), at the stated point."""
    letters = attitudes(STATED)
    computed, true = letters[-3], letters[-2]
    phi = Matrix(STATED.phi)
    change = -hamilton(stack(exact(0), phi), computed) / 2

    def left(q) -> arb:
        turn = hamilton(vector(true[0], *-true[1:4, 0]), q)
        return 2 * atan2(norm(turn[1:4, 0]), abs(turn[0]))

    return {
        "nothing": left(computed),
        "a 0 put before φ, the product kept": left(hamilton(change, computed)),
        "[1, -φ/2] for ΔQ": left(hamilton(stack(exact(1), -phi / 2), computed)),
        "[1, +φ/2] for ΔQ": left(hamilton(stack(exact(1), phi / 2), computed)),
        "the sum, as derived": left(computed - change),
    }


def _feedback() -> str:
    sizes = feedback_readings()
    return "attitude error left at that point: " + ", ".join(
        f"{float(value) / DEGREE:.2g} deg by {name}" for name, value in sizes.items()
    )


def printed_window(n: int, N: int) -> range:
    """The samples of {n <= l <= N-1}."""
    return range(n, N)


def _window() -> str:
    half, none = (len(printed_window(n, 100)) for n in (50, 100))
    return (
        f"with N = 100 the printed set has {half} samples at n = 50, so that T_w is halved, {none} from n = 100 on: "
        "both statistics are 0 and the platform is at rest for ever"
    )


def _length() -> str:
    turning = [(0, 0, -10)] * 3  # deg/s
    sums = [sp.Rational(sum(sample[i] for sample in turning), 3) for i in range(3)]
    return (
        "without a norm a turn of -10 deg/s about one axis "
        f"has components of at most {max(sums)} deg/s, below any threshold, where the derived T_w is "
        f"{paper.moving_mean(turning)} deg/s"
    )


_EVIDENCE: dict[str, Callable[[], str]] = {
    "2": _psi_sizes,
    "6": _delay,
    "9": _position_run,
    "11": _schuler,
    "12": _steps,
    "20": lambda: _held(0.5, "solved for φ_u the printed product, I - 2 Φ̌, gives half of it"),
    "21": lambda: _held(0.5, "C_b2n for C_b2p leaves half of φ_u"),
    "29": _feedback,
    "32": _length,
    "Ω_n": _window,
}
