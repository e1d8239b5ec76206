"""Numbers for every letter of Kang 2025 at a point: the witness of its ledger.

Two ends of a rigid lever arm move over the turning ellipsoid.  Velocities and rates are differences of places and of
axes in many digits; the delay is in them because the master is looked at earlier.  No formula of the paper makes the
numbers that judge it.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from functools import cache, lru_cache
from random import Random
from typing import Any

from boresight.derive import earth, ellipsoid
from boresight.derive.ellipsoid import WORKING
from boresight.derive.equation import Relation
from boresight.derive.numbers import Matrix, asin, cos, digits, exact, eye, norm, pi, sin
from boresight.derive.papers.kang_2025_print import AT_REST, ROLLING, TABLE_1, TABLE_2
from boresight.derive.witness import (
    DIGITS,
    attitude,
    finite_rotation,
    rotation_vector,
    skew,
    uniform,
    vector,
)


@dataclass(frozen=True, eq=False)
class Base:  # a key of the caches by itself: `draw` gives the same one for the same seed
    """What a point is made of; all else follows.  SI and rad; three components each, NED or slave body axes."""

    position: tuple  # longitude, latitude, height
    v_n: tuple
    acceleration: tuple  # of the slave over the ground
    jerk: tuple
    euler: tuple
    rate: tuple  # of the body against the Earth
    turn: tuple  # rate of change of that rate
    lever: tuple
    mounting: tuple
    velocity_error: tuple
    phi: tuple
    gyro_error: tuple
    dmu: tuple
    delay: tuple  # the first component alone
    step: tuple  # the first component alone
    wave: tuple  # height, frequency, time


@dataclass(frozen=True)
class Conditions:
    """The largest size of each part of a Base."""

    position: tuple = (3.0, 1.2, 100.0)
    v_n: float = 10.0
    acceleration: float = 2.0
    jerk: float = 2.0
    euler: tuple = (2.5, 1.2, 2.5)
    rate: float = 1.0
    turn: float = 1.0
    lever: float = 5.0
    mounting: float = 1.0
    velocity_error: float = 1.0
    phi: float = 0.05
    gyro_error: float = 0.02
    dmu: float = 0.05
    delay: float = 0.1
    step: float = 0.3
    wave: tuple = (4.0, 0.3, 20.0)

    def scaled(self, scale, parts=()) -> "Conditions":
        """The named parts, or all errors with delay and step, times `scale`; the motion as it is."""
        changes: dict[str, Any] = {part: getattr(self, part) * scale for part in parts or ERRORS}
        return replace(self, **changes)


ERRORS = ("velocity_error", "phi", "gyro_error", "dmu", "delay", "step")

DEGREE = math.pi / 180
MIL = 360 / 6400 * DEGREE
ROLL, WAVE_RATE, DELAY = 5 * DEGREE, 0.1, 0.01  # of a stated hull; Hz of Table 1; s, the longest of Table 2
SURGE = 2 * math.pi * WAVE_RATE  # rad/s
# Tables 1 and 2 at grade 6, and what the paper leaves open: a hull that rolls and pitches by 5 deg with the wave,
# 5 m/s, a lever arm of 3 m per axis.
CONDITIONS = Conditions(
    position=(3.0, 40 * DEGREE, 10.0),
    v_n=5.0,
    acceleration=4 * SURGE**2,
    jerk=4 * SURGE**3,
    euler=(ROLL, ROLL, 2.5),
    rate=ROLL * SURGE,
    turn=ROLL * SURGE**2,
    lever=3.0,
    mounting=2 * DEGREE,
    velocity_error=0.1,
    phi=2 * DEGREE,
    gyro_error=10 * DEGREE / 3600,
    dmu=2 * DEGREE,
    delay=DELAY,
    step=1.0,
    wave=(4.0, WAVE_RATE, 60.0),
)
POINTS = 8  # of these conditions, drawn for the sizes
CONDITIONS_TEXT = (
    "grade 6, a hull that rolls and pitches by 5 deg at 0.1 Hz, 5 m/s, lever arm 3 m per axis, errors to 2 deg, delay "
    "10 ms, k and k-1 apart by 1 s"
)
WITNESS = "finite motions"


def _degrees(*angles) -> tuple:
    return tuple(exact(float(angle) * math.pi / 180) for angle in angles)


def _numbers(*texts) -> tuple:
    return tuple(exact(text) for text in texts)


# The point at which an erratum's numbers are given.
STATED = Base(
    position=(*_degrees(127, 37), exact(10)),
    v_n=_numbers(3, 4, 0),
    acceleration=_numbers("0.2", "-0.1", 1),
    jerk=_numbers(0, 0, "0.6"),
    euler=_degrees(3, -2, 60),
    rate=_degrees(3, 2, 1),
    turn=_degrees(2, -1, "0.5"),
    lever=_numbers(3, 1, "-0.5"),
    mounting=_degrees(1, -1, 2),
    velocity_error=_numbers("0.1", "-0.1", "0.05"),
    phi=_degrees("0.1", "-0.2", 2),
    gyro_error=_degrees("0.003", "-0.003", "0.003"),
    dmu=_degrees("0.2", "0.1", "-0.1"),
    delay=_numbers("0.01", 0, 0),
    step=_numbers("0.01", 0, 0),
    wave=_numbers(4, "0.1", 2),
)
STATED_TEXT = (
    "roll, pitch, yaw 3, -2, 60 deg turning by 3, 2, 1 deg/s and 2, -1, 0.5 deg/s^2, accelerating by 0.2, -0.1, 1 "
    "m/s^2; lever arm 3, 1, -0.5 m; errors 0.1, -0.2, 2 deg in attitude, 0.2, 0.1, -0.1 deg in misalignment; delay and "
    "step 10 ms; a wave of 4 m at 0.1 Hz after 2 s"
)


@cache
def draw(seed: int, conditions: Conditions) -> Base:
    """A point of the conditions; the same seed at another scale gives the same directions."""
    generator = Random(seed)
    parts = {part.name: tuple(uniform(generator, getattr(conditions, part.name))) for part in fields(conditions)}
    for name in ("delay", "step"):
        parts[name] = tuple(map(abs, parts[name]))
    return Base(**parts)


# ---- Exact motion ----------------------------------------------------------------------------------------------------


def _ned(position) -> Matrix:
    """Columns: north, east and down in Earth's axes."""
    east, north, up = (ellipsoid.axes(position)[:, i] for i in range(3))
    return Matrix([[north[i], east[i], -up[i]] for i in range(3)])


def _after(function: Callable, t) -> Any:
    """The derivative of a function of time at t."""
    return ellipsoid.rate(lambda change: function(t + change))


def _turning(axes: Callable, t) -> Matrix:
    """Rate at t of axes (columns) against those in which they are given, in their own components."""
    W = axes(t).T * _after(axes, t)
    return vector(W[2, 1], W[0, 2], W[1, 0])


class Motion:
    """Slave and master on a rigid hull, from Earth's axes; t = 0 is k.

    v_n, acceleration, jerk: of the slave over the ground, in n at k.  rate, turn: of the body against the Earth at k.
    """

    def __init__(self, position, v_n, acceleration, jerk, C_b2n, rate, turn, lever):
        self.start, self.lever = position, lever
        level = _ned(position)
        self.path = [level * part for part in (v_n, acceleration / 2, jerk / 6)]
        self.origin, self.inverse = ellipsoid.point(position), ellipsoid.slope(position).inv()
        self.C_b2e, self.rate, self.turn = level * C_b2n, rate, turn

    def body(self, t) -> Matrix:
        """C_b2e."""
        return self.C_b2e * finite_rotation(self.rate * t + self.turn * t**2 / 2)

    def slave(self, t) -> Matrix:
        first, second, third = self.path
        return self.origin + first * t + second * t**2 + third * t**3

    def master(self, t) -> Matrix:
        return self.slave(t) - self.body(t) * self.lever

    def level(self, place: Matrix) -> Matrix:
        """North, east and down at a place near the start, by Newton's method with one slope."""
        position = self.start
        while norm(missing := place - ellipsoid.point(position)) > 1e-95:
            position = position + self.inverse * missing
        return _ned(position)

    def velocity(self, where: Callable, t) -> Matrix:
        """Over the ground, in the north, east and down of that place."""
        return self.level(where(t)).T * _after(where, t)

    def attitude(self, t) -> Matrix:
        """C_b2n, n at the slave."""
        return self.level(self.slave(t)).T * self.body(t)

    def lever_rate(self, t) -> Matrix:
        return _after(self.attitude, t) * self.lever

    def omega_in_n(self, t) -> Matrix:
        return _turning(lambda s: _inertial(s) * self.level(self.slave(s)), t)

    def omega_ib_b(self, t) -> Matrix:
        return _turning(lambda s: _inertial(s) * self.body(s), t)

    def omega_nb_b(self, t) -> Matrix:
        return _turning(self.attitude, t)


def _inertial(t) -> Matrix:
    """C_e2i."""
    return finite_rotation([0, 0, ellipsoid.defined(earth.EARTH_RATE) * t])


def _motion(base: Base, erring: bool) -> Motion:
    """The true motion, or the one that the slave computes."""
    parts = {part.name: Matrix(getattr(base, part.name)) for part in fields(base)}
    share = int(erring)
    return Motion(
        parts["position"],
        parts["v_n"] + parts["velocity_error"] * share,
        parts["acceleration"],
        parts["jerk"],
        finite_rotation(-parts["phi"] * share) * attitude(base.euler),
        parts["rate"] + parts["gyro_error"] * share,
        parts["turn"],
        parts["lever"],
    )


def world(base: Base, definitions: Mapping[str, tuple[Relation, ...]]) -> dict:
    """Values of every letter of the paper at one point; no equation of the paper is a definition that it needs.

    The letters of the slave are what it computes, those of the master what the master reports without error.
    """
    return dict(_world(base))


@lru_cache(maxsize=256)
def _world(base: Base) -> dict:
    with digits(WORKING):
        slave, truth = _motion(base, True), _motion(base, False)
        zero, delay, step = exact(0), base.delay[0], base.step[0]
        C_b2m = finite_rotation(base.mounting)
        C_M2S = (finite_rotation(-Matrix(base.dmu)) * C_b2m).T
        v_M, C_M2n = truth.velocity(truth.master, -delay), truth.attitude(-delay) * C_b2m.T
        C, v_k, v_old = slave.attitude(zero), slave.velocity(slave.slave, zero), slave.velocity(slave.slave, -delay)
        height, frequency, time = base.wave
        # A point on a wheel as high as the wave, which turns `frequency` times a second and rises at the start.
        wheel = finite_rotation([2 * pi() * frequency * time, 0, 0]) * vector(0, height / 2, 0)
        return {
            "v_m": slave.velocity(slave.master, zero),
            "v_s": v_k,
            "v_S": v_k,
            "v_s(k)": v_k,
            "v_s(k-1)": slave.velocity(slave.slave, -step),
            "v_s(k+α)": v_old,
            "v_M": v_M,
            "dL/dt": slave.lever_rate(zero),
            "u(k)": -slave.lever_rate(zero),
            "u(k-1)": -slave.lever_rate(-step),
            "z_v": v_old - slave.lever_rate(-delay) - v_M,
            "L": slave.lever,
            "[ω_in_n x]": skew(slave.omega_in_n(zero)),
            "[ω_ib_b x]": skew(slave.omega_ib_b(zero)),
            "ω_nb_b": slave.omega_nb_b(zero),
            "ω_nb_n": C * slave.omega_nb_b(zero),
            "C_S2n": C,
            "C_M2S": C_M2S,
            "C_M2n": C_M2n,
            "C_n2M": C_M2n.T,
            "A": skew(rotation_vector(C * C_M2S * C_M2n.T)),
            "z_DCM": rotation_vector(slave.attitude(-delay) * C_M2S * C_M2n.T),
            "I": eye(3),
            "dt": step,
            "δt_d": delay,
            "t": time,
            "Seawave": wheel[2],
            "a": height,
            "f": frequency,
            "π": pi(),
            "asin": asin,
            "entry": lambda M, i, j: M[int(i) - 1, int(j) - 1],
        }  # fmt: skip


# ---- Sizes of what is dropped, and what the errata do ----------------------------------------------------------------


def evidence(number: str) -> str:
    """What the ledger says beyond the status: sizes, and what the print does."""
    with digits(DIGITS):
        return "; " + _EVIDENCE[number]()


def lever_sizes() -> dict[str, float]:
    """Largest over the stated conditions, m/s: the lever-arm velocity, and what (1) and its variants leave.

    own, one: the master's velocity in its own north, east and down, or in those of the slave.
    """
    sizes = dict.fromkeys(("lever arm", "print, own", "print, one", "earth rate, own", "earth rate, one"), 0.0)
    for seed in range(POINTS):
        with digits(WORKING):
            slave, zero = _motion(draw(seed, CONDITIONS), False), exact(0)
            level = slave.level(slave.slave(zero))
            masters = {
                "own": slave.velocity(slave.master, zero),
                "one": level.T * _after(slave.master, zero),
            }
            spin = level.T * vector(0, 0, ellipsoid.defined(earth.EARTH_RATE))
            by_rate = {"print": slave.omega_in_n(zero), "earth rate": spin}
            C, L, v = slave.attitude(zero), slave.lever, slave.velocity(slave.slave, zero)
            for rate, omega in by_rate.items():
                arm = skew(omega) * C * L - C * skew(slave.omega_ib_b(zero)) * L
                sizes["lever arm"] = max(sizes["lever arm"], float(norm(arm)))
                for axes, v_m in masters.items():
                    key = f"{rate}, {axes}"
                    sizes[key] = max(sizes[key], float(norm(v + arm - v_m)))
    return sizes


def _lever() -> str:
    sizes = lever_sizes()
    exact = "nothing" if sizes["earth rate, one"] < 1e-28 else f"{sizes['earth rate, one']:.1g} m/s"
    return (
        f"there the lever-arm velocity is up to {sizes['lever arm']:.2g} m/s, v L / R is {5 * 3 / 6.37e6:.1g} m/s, and "
        f"the print leaves {sizes['print, own']:.2g} m/s; with the Earth's rate alone for ω_in it would leave "
        f"{sizes['earth rate, own']:.2g} m/s, and {exact} if both velocities were resolved in the slave's north, where "
        f"the print leaves {sizes['print, one']:.2g} m/s"
    )


def interpolation(height: float, step: float, delay: float = DELAY) -> tuple[float, float]:
    """Heave by (6) as printed, m/s: the largest error of (2), and the largest change during the delay."""

    def speed(t: float) -> float:
        return height * SURGE * math.cos(SURGE * t)

    error = change = 0.0
    for k in range(200):
        t = k / 20
        line = speed(t) + (speed(t - step) - speed(t)) * delay / step
        error = max(error, abs(speed(t - delay) - line))
        change = max(change, abs(speed(t - delay) - speed(t)))
    return error, change


def _interpolation() -> str:
    (slow, change), (bench, _), (fast, _) = (interpolation(4, *both) for both in ((1.0,), (0.1,), (0.01, 0.005)))
    return (
        f"k and k-1 are updates, by the text, so dt is 1 s in Table 2: at grade 6 the line errs by {slow * 1e3:.2g} "
        f"mm/s, {100 * slow / change:.2g} % of the {change * 1e3:.3g} mm/s which it is to take out at 10 ms, for it "
        f"takes the mean acceleration of the second before, by {bench * 1e3:.2g} mm/s with the 0.1 s of the bench, and "
        f"by {fast * 1e3:.2g} mm/s between steps of 10 ms of the navigator, at 5 ms"
    )


def dropped_by_3(roll: float, rate_hz: float, lever: float) -> float:
    """Largest change of the lever-arm velocity during 10 ms, m/s: a roll (rad) about an axis `lever` (m) away."""

    def speed(t: float) -> float:
        return lever * roll * 2 * math.pi * rate_hz * math.cos(2 * math.pi * rate_hz * t)

    return max(abs(speed(k / 20) - speed(k / 20 - DELAY)) for k in range(200))


def _dropped() -> str:
    kept = {grade: interpolation(float(height), 0.01)[1] for grade, height, *_ in TABLE_1}
    lost = dropped_by_3(ROLL, WAVE_RATE, 3.0)
    shares = ", ".join(f"{100 * lost / kept[grade]:.3g} % at grade {grade}" for grade in "3456")
    bench = dropped_by_3(1.18 * DEGREE, 1.0, 0.5)
    return (
        f"a hull that rolls by 5 deg at 0.1 Hz, 3 m from the axis: {lost * 1e3:.2g} mm/s are left out in 10 ms; of the "
        f"change that is kept, heave as (6) prints it, that is {shares}; on a bench that only rolls, the slave on the "
        f"axis, all is left out: {bench * 1e3:.2g} mm/s at 1.18 deg, if at 1 Hz and 0.5 m"
    )


def half_of_4() -> dict[str, float]:
    """The turn at the stated point, rad: the largest component, by (4) as derived and as printed, and what of the
    symmetric part is in the latter."""
    values = world(STATED, {})
    M = values["C_S2n"] * values["C_M2S"] * values["C_n2M"]
    X = M - eye(3)
    printed = X - X.T / 2

    def taken(B) -> Matrix:
        return vector(-B[1, 2], B[0, 2], -B[0, 1])

    derived, literal = taken((X - X.T) / 2), taken(printed)
    return {
        "derived": float(max(map(abs, derived))),
        "printed": float(max(map(abs, literal))),
        "symmetric": float(max(map(abs, literal - derived * exact("1.5")))),
    }


def _half() -> str:
    sizes = half_of_4()
    minutes = {name: size / DEGREE * 60 for name, size in sizes.items()}
    return (
        f"there a turn of {minutes['derived']:.4g} arcmin is read off the print as {minutes['printed']:.4g}: 1.5 times "
        f"it, and half of the symmetric part, {minutes['symmetric']:.2g} arcmin; H says 1, so a filter that trusts it "
        f"fully overshoots by half, and the NIS of the attitude is {1.5**2:.3g} times as large"
    )


def delay_by_attitude(form: str, heading_deg: int) -> float:
    """The delay (s) which least squares find from (5), printed or derived, the true one 10 ms: a ship that rolls."""
    above = below = 0
    roll, surge, heading = exact(ROLL), exact(SURGE), exact(heading_deg * DEGREE)

    def C(t) -> Matrix:
        return attitude((roll * sin(surge * t), 0, heading))

    with digits(DIGITS):
        for k in range(10):
            t = exact(k)
            turned = C(t) * C(t - exact(DELAY)).T
            turn = vector(*(turned[i, j] - turned[j, i] for i, j in ((2, 1), (0, 2), (1, 0)))) / 2
            rate_b = vector(roll * surge * cos(surge * t), 0, 0)
            column = -C(t) * rate_b if form == "derived" else C(t) * C(t) * rate_b
            above -= (column.T * turn)[0]
            below += (column.T * column)[0]
    return float(above / below)


def _delay() -> str:
    printed, derived = (
        [f"{round(delay_by_attitude(form, h) * 1e3, 2) + 0:g} ms at {h} deg" for h in (0, 90, 180)]
        for form in ("printed", "derived")
    )
    turn = ROLL * SURGE * DELAY
    return (
        f"a ship that rolls by 5 deg at 0.1 Hz, delay 10 ms: the term is up to {turn / MIL:.2g} mil; from the printed "
        f"form alone least squares find {', '.join(printed)} of heading, for C_S2n turns the rate once more; from the "
        f"derived one {', '.join(derived)}, and (3) finds it with its sign"
    )


BOUNDS = (0.0, 0.1, 0.5, 1.25, 2.5, 4.0, 6.0, 9.0, 14.0)  # m, of WMO-No. 306, code table 3700


def grade(height: float) -> int:
    """Sea state of a height (m) by code table 3700; a bounding height has the lower figure, 4 m is 5."""
    return sum(height > bound for bound in BOUNDS)


def _wave() -> str:
    heights = [float(height) for _, height, *_ in TABLE_1]
    twice = ", ".join(f"{2 * height:g} m ({grade(2 * height)})" for height in heights)
    return f"as printed the waves of grades 1 to 6 are, crest to trough (grade by code table 3700), {twice}"


_EVIDENCE: dict[str, Callable[[], str]] = {
    "1": _lever, "2": _interpolation, "3": _dropped, "4": _half, "5": _delay, "6": _wave,
}  # fmt: skip


def findings() -> tuple[str, ...]:
    """What was computed about the text and the tables beside the equations."""
    table = [(int(number), float(height)) for number, height, *_ in TABLE_1]
    lower = [number for number, height in table if height == BOUNDS[number - 1]]
    coded = ", ".join(str(grade(height)) for _, height in table)
    simulated = [number for number, _ in table]
    left = [float(text.rstrip("°")) * DEGREE / MIL for _, text in (AT_REST, ROLLING)]
    start = float(TABLE_2[1][2]) * DEGREE / MIL
    return (
        f"Table 1 has the lower edge of each grade of code table 3700 for grades {lower[0]} to {lower[-1]}, and "
        f"{table[0][1]:g} m for grade 1, whose lower edge is 0; a bounding height has the lower figure there, so the "
        f"six heights are of grades {coded}.",
        f"Grades {simulated[0]} to {simulated[-1]} are simulated, by the text over Table 1 and by the table; Fig. 3 is "
        "read from grade 0 on, which was not. Yaw and heading, misalignment (Table 2) and heading error (text), each "
        "2 deg, are one quantity by two names.",
        "The delay of Table 2, 5 to 10 ms, lies between k-1 and k whether these are updates, 1 s apart, or steps "
        "of the navigator, 10 ms apart; which of the two (2) and (3) mean makes a difference: see (2).",
        f"On the bench {left[0]:.3g} mil are left of {start:.3g} at rest and {left[1]:.2g} mil when it rolls; the "
        "simulation claims less than 2 mil from grade 3 on.",
        "How waves become motion of the ship, where the lever arm lies and how long it is, noise, Q, R and the start "
        "of P are nowhere given; nor are F and H, which follow from (3) and (5).",
    )
