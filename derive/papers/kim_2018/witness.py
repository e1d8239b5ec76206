"""Numbers for every letter of Kim 2018 at a point: the witness of its ledger.

Rates come from Newton's law on the turning ellipsoid and from finite rotations, in many digits; radii, transport rate
and the matrices F and H are differentiated from them, so none of the paper's formulas judges itself.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from random import Random
from typing import Any
from unicodedata import normalize

from boresight.derive.ledger import ellipsoid, navigation
from boresight.derive.ledger.ellipsoid import WORKING
from boresight.derive.ledger.equation import Relation
from boresight.derive.ledger.evaluate import Point, assembled, evaluate, solve
from boresight.derive.ledger.free import Kind, of, positive, positive_number, rotation
from boresight.derive.ledger.navigation import Truth, stack
from boresight.derive.ledger.numbers import Matrix, cos, digits, exact, eye, norm, sqrt, zeros
from boresight.derive.ledger.paper import Stated, Witness
from boresight.derive.ledger.witness import (
    Letters,
    attitude,
    degrees,
    finite_rotation,
    quaternion,
    rotation_vector,
    skew,
    uniform,
    vector,
)

SHAPES = ((3, 3), (3, 4), (4, 3), (4, 4), (3, 9), (3, 18), (3, 6), (3, 15), (1, 3), (1, 6), (1, 15))
BLOCKS = {**{f"0_{rows}x{columns}": zeros(rows, columns) for rows, columns in SHAPES}, "I_3x3": eye(3)}
SAMPLES, WINDOW_AT, WINDOW_OF, NOW = 6, 2, 3, 3  # of the detector's record: its length, a window's start and length


@dataclass(frozen=True, eq=False)
class Base:  # a key of the caches by itself: `draw` gives the same one for the same seed
    """What a point is made of; all else follows.  SI and rad; three components each, east north up or body axes."""

    position: tuple  # longitude, latitude, height
    v_n: tuple
    euler: tuple
    f_b: tuple
    omega_ib_b: tuple
    position_error: tuple
    velocity_error: tuple
    phi: tuple
    gyro_bias: tuple
    accel_bias: tuple
    gyro_noise: tuple
    accel_noise: tuple
    mounting: tuple
    theta: tuple
    delay: tuple  # the first component alone
    jerk: tuple
    master_velocity_error: tuple
    master_attitude_error: tuple
    step: tuple  # the first component alone


@dataclass(frozen=True)
class Conditions:
    """The largest size of each part of a Base."""

    position: tuple = (3.0, 1.2, 3000.0)
    v_n: tuple = (300.0, 300.0, 30.0)
    euler: tuple = (2.5, 1.2, 2.5)
    f_b: tuple = (12.0, 12.0, 12.0)
    omega_ib_b: float = 1.0
    position_error: tuple = (0.05, 0.05, 500.0)
    velocity_error: float = 2.0
    phi: float = 0.05
    gyro_bias: float = 0.02
    accel_bias: float = 0.5
    gyro_noise: float = 0.01
    accel_noise: float = 0.3
    mounting: float = 1.0
    theta: float = 0.05
    delay: float = 0.1
    jerk: float = 5.0
    master_velocity_error: float = 0.3
    master_attitude_error: float = 0.01
    step: float = 0.3


ERRORS = (
    "position_error", "velocity_error", "phi", "gyro_bias", "accel_bias", "gyro_noise", "accel_noise",
    "theta", "delay", "master_velocity_error", "master_attitude_error", "step",
)  # fmt: skip

PARTS = {
    "position_error": "the position error",
    "velocity_error": "the velocity error",
    "phi": "the attitude error",
    "gyro_bias": "the gyro bias",
    "accel_bias": "the accelerometer bias",
    "gyro_noise": "the gyros' noise",
    "accel_noise": "the accelerometers' noise",
    "theta": "the error of the mounting",
    "delay": "the delay",
    "master_velocity_error": "the master's velocity error",
    "master_attitude_error": "the master's attitude error",
    "step": "the step",
}

DEGREE, HOUR, G = math.pi / 180, 3600.0, 9.80665
MILE = 1852.0
# Table 1, and what the paper leaves open: a bench at rest but for the rocking of the transfer alignment, where a master
# of one nautical mile per hour has been for an hour.
CONDITIONS = Conditions(
    position=(3.0, 45 * DEGREE, 100.0),
    v_n=(0.5, 0.5, 0.1),
    euler=(5 * DEGREE, 5 * DEGREE, 2.5),
    f_b=(0.5, 0.5, 10.0),
    omega_ib_b=5 * DEGREE,
    position_error=(MILE / 6.4e6, MILE / 6.4e6, 10.0),
    velocity_error=1.0,
    phi=5e-3,
    gyro_bias=DEGREE / HOUR,
    accel_bias=1e-3 * G,
    gyro_noise=0.0,
    accel_noise=0.0,
    mounting=5 * DEGREE,
    theta=5e-3,
    delay=0.05,
    jerk=0.5,
    master_velocity_error=0.01,
    master_attitude_error=1e-4,
    step=0.01,
)
CONDITIONS_TEXT = (
    "sensors of Table 1, errors to 5 mrad, 1 m/s, 1 nmi per axis, delay 50 ms on a bench that moves at 0.5 m/s and "
    "5 deg/s, step 10 ms"
)


# The point at which an erratum's numbers are given.
STATED = Base(
    position=(*degrees(127, 37), exact(1000)),
    v_n=(exact(60), exact(80), exact(0)),
    euler=degrees(2, 3, 40),
    f_b=(exact("0.5"), exact(1), exact("9.8")),
    omega_ib_b=degrees(1, 2, 10),
    position_error=(*degrees("0.02", "0.02"), exact(100)),
    velocity_error=(exact(1), exact(-1), exact("0.5")),
    phi=degrees("0.1", "-0.2", "0.3"),
    gyro_bias=tuple(angle / 3600 for angle in degrees(1, -1, 1)),
    accel_bias=tuple(exact(x) * exact("9.80665e-3") for x in (1, -1, 1)),
    gyro_noise=(exact(0),) * 3,
    accel_noise=(exact(0),) * 3,
    mounting=degrees(1, 2, -1),
    theta=degrees("0.2", "-0.1", "0.1"),
    delay=(exact("0.05"), exact(0), exact(0)),
    jerk=(exact(0),) * 3,
    master_velocity_error=(exact(0),) * 3,
    master_attitude_error=(exact(0),) * 3,
    step=(exact("0.01"), exact(0), exact(0)),
)
STATED_TEXT = (
    "latitude 37 deg, height 1 km, 60 m/s east, 80 m/s north; errors 0.02 deg in position, 100 m in height, 1, -1, "
    "0.5 m/s, 0.1, -0.2, 0.3 deg in attitude; 1 deg/h, 1 mg; mounting error 0.2, -0.1, 0.1 deg, delay 50 ms"
)


# ---- Exact mechanics -------------------------------------------------------------------------------------------------


@lru_cache(maxsize=64)
def _truth(position, v_n, euler, f_b, omega) -> Truth:
    return navigation.truth(position, v_n, attitude(euler), f_b, omega)


@lru_cache(maxsize=256)
def truth(base: Base) -> Truth:
    with digits(WORKING):
        return _truth(base.position, base.v_n, base.euler, base.f_b, base.omega_ib_b)


def position_known(true: Truth, x) -> Matrix:
    """(6) rates of velocity and attitude error against the computed axes, which agree with the true ones now."""
    return true.psi_rates(stack(zeros(3, 1), x))[3:9, 0]


def errors(base: Base) -> Matrix:
    return stack(base.position_error, base.velocity_error, base.phi, base.gyro_bias, base.accel_bias)


# ---- Letters ---------------------------------------------------------------------------------------------------------


def values(base: Base, definitions: Mapping[str, tuple[Relation, ...]]) -> Letters:
    """Values of every letter of the paper at one point.

    definitions: the relations of the equations which define a letter, by number; the witness takes them as given.
    Raises ValueError, KeyError or ZeroDivisionError where a definition does not define, when its letter is asked for.
    """
    given = {
        **BLOCKS,
        "I": eye(3), "I_15x15": eye(15),
        "N": exact(WINDOW_OF), "n": exact(WINDOW_AT), "index": exact(0),
        "m": exact(WINDOW_AT + WINDOW_OF - 1), "η": zeros(15, 1), "ζ": zeros(4, 1), "u": Matrix([exact(1)] * 15),
        "θ̇": zeros(3, 1), "Δṫ": exact(0), "ΔT": base.step[0], "Δt": base.delay[0],
        "norm": norm, "samples": _between, "vee": _vee,
        "entry": lambda M, i, j: M[int(i) - 1, int(j) - 1],
        "row": lambda *entries: Matrix([entries]),
        "Σ": lambda values: _samples(base, values),
    }  # fmt: skip
    for names, parts in (
        ("l|L|h", base.position),
        ("l̂|L̂|ĥ", [a + b for a, b in zip(base.position, base.position_error, strict=True)]),
        ("v_e|v_n|v_u", base.v_n),
        ("v̂_e|v̂_n|v̂_u", [a + b for a, b in zip(base.v_n, base.velocity_error, strict=True)]),
        ("φ_e|φ_n|φ_u", base.phi),
        ("θ_x|θ_y|θ_z", base.theta),
    ):
        given |= dict(zip(names.split("|"), parts, strict=True))
    vectors = {"v": "v_n", "δv": "velocity_error", "φ": "phi", "θ": "theta", "Δv_MINS": "master_velocity_error",
               "x_p": "position_error", "x_v": "velocity_error", "x_φ": "phi", "x_Cb": "gyro_bias",
               "x_Ab": "accel_bias", "ν_z": "v_n", "s_a": "f_b", "f_b": "f_b", "s_w": "omega_ib_b",
               "ω_ib_b": "omega_ib_b", "w_f": "accel_noise", "w_ω": "gyro_noise"}  # fmt: skip
    given |= {name: Matrix(getattr(base, part)) for name, part in vectors.items()}

    def defined(number: str, **unknown: int) -> Callable:
        return lambda letters: _defined(base, definitions[number], tuple(unknown.items()), letters)

    def position_error_rates(letters: Letters) -> list:
        """The definition of the errors is linear: of rates it makes their rates."""
        exact, error = truth(base).exact.position_rate, letters["ẋ_k"][0:3, 0]
        rates = dict(zip(("l", "L", "h"), exact, strict=True)) | dict(zip(("l̂", "L̂", "ĥ"), exact + error, strict=True))
        return _defined(base, definitions["27"], (("δl", 1), ("δL", 1), ("δh", 1)), Letters((), rates), "rates")

    groups: tuple[tuple[str, Callable], ...] = (
        ("X", defined("1", X=10)),
        ("x", defined("8", x=15)),
        ("x_k", lambda a: [a["x"]]),
        ("z_v", defined("16", z_v=3)),
        ("z", defined("22", z=4)),
        ("δl|δL|δh", defined("27", δl=1, δL=1, δh=1)),
        ("δv_e|δv_n|δv_u", defined("28", δv_e=1, δv_n=1, δv_u=1)),
        ("y_k|s_k|ν_y", defined("30", y_k=6, s_k=6, ν_y=6)),
        ("Ω_n", lambda a: [evaluate(definitions["Ω_n"][0].sides[1], Point(a))]),
        ("y_a|y_w", lambda a: [a["y_k"][0:3, 0], a["y_k"][3:6, 0]]),
        ("ν_a|ν_w", lambda a: _noise(base, NOW)),
        ("T_a|T_w|ȳ_a|ȳ_w|γ_a|γ_w", lambda a: _detector(base)),
        ("δl̇|δL̇|δḣ", position_error_rates),
        ("ẋ_k|w_k|δv̇|φ̇|δv̇_c|ψ̇|Ẋ", lambda a: _error_rates(base)),
        (RATES, lambda a: _rates(base)),
        (TRUE_MOTION, lambda a: _true_motion(base)),
        (COMPUTED_MOTION, lambda a: _computed_motion(base)),
        (COMPUTED_AXES, lambda a: _in_computed_axes(base)),
        ("W_ie|W_ep|W_ev|W_g", lambda a: _slopes(truth(base))),
        ("∂l̇/∂L|∂l̇/∂h|∂l̇/∂v|∂L̇/∂L|∂L̇/∂h|∂L̇/∂v", lambda a: [a["F_k"][i, j] for i in (0, 1) for j in (1, 2, 3 + i)]),
        ("R_E|R_N|R_EE|R_NN|ρ_e|ρ_n|ρ_u", lambda a: curvature(base)),
        ("F_k|F_X|H_k|H_v|Γ_k", lambda a: matrices(truth(base))),
        ("Φ_k", lambda a: [transition(truth(base), base.step[0])]),
        (FILTER, lambda a: _filter(truth(base))),
        ("x(k-1+)|x(k-)", lambda a: _predicted(base)),
        ("x(k+)", lambda a: [_least_squares(base)]),
        ("ν", lambda a: [stack(base.v_n, exact(0))]),
        ("random", lambda a: [_moments(truth(base))]),
        ("ξ_k-1", lambda a: [a["x(k-1+)"]]),
        ("ξ_k", lambda a: [a["x(k-)"]]),
        (TRANSFER, lambda a: _transfer(base)),
        (ATTITUDES, lambda a: attitudes(base)),
        ("V|V̄", lambda a: [quaternion(finite_rotation(sign * Matrix(base.phi))) for sign in (-1, 1)]),
    )
    return Letters(groups, given)


TRUE_MOTION = "ω_ie_n|ω_en_n|ω_in_n|g_n|C_n2b|Ċ_b2n|Ċ_n2b|l̇|L̇|ḣ"
COMPUTED_MOTION = "v̂|v̂̇|f̂_b|ĝ_n|ω̂_ie_n|ω̂_en_n|ω̂_in_n|δω_in_n|ω̂_ib_b|Ĉ_b2n|Ĉ̇_b2n"
COMPUTED_AXES = "v̂_c|v̂̇_c|ω̂_en_c|ω̂_in_c|Ĉ_b2c|Ĉ̇_b2c|C_n2c|C_c2n|Ċ_n2c|Ċ_c2n"
RATES = "[ω_ie_n x]|[ω_en_n x]|[δω_ie_n x]|[δω_en_n x]|[f_n x]|δω_ie_n|δω_en_n|f_n|v̇|δg_n|δf_b|δω_ib_b"
FILTER = "Φ_k-1|P(k-1+)|Q_k|P(k-)|R|K_k|P(k+)|W|Ṗ"
TRANSFER = (
    "C_r2n|C_r2n(k-δt)|Ĉ_r2n|Ĉ_b2r|Ĉ_n2b|Z_dcm|ν_dcm|v̂_SINS|v̂_MINS|Z_v|ν_v|d|H_X|ω_nr_n|q_r2n|q̂_r2n|μ̂|v_old|C_b2r|C_n2r"
)
ATTITUDES = "C_b2n|C_b2p|C̄_n2b|Φ̌|X_b|Y_b|Z_b|X_p|Y_p|Z_p|q_0|q_1|q_2|q_3|Q̂_b2n|Q_b2n|ΔQ"


_SOLVED: dict = {}


def _defined(base: Base, relations: tuple[Relation, ...], unknown: tuple, letters: Mapping, what: str = "") -> list:
    """Values of the letters that the relations define; mutants of one definition leave the others as they were."""
    key = base, relations, unknown, what
    if key not in _SOLVED:
        sizes = {normalize("NFC", name): size for name, size in unknown}
        used = {s.name for relation in relations for side in relation.sides for s in getattr(side, "free_symbols", ())}
        found = solve(relations, sizes, {name: letters[name] for name in used - set(sizes)})
        _SOLVED[key] = [found[name] for name in sizes]
    return _SOLVED[key]


def _vee(M) -> Matrix:
    return vector(M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]) / 2


# Section 2.2: the fifteen states.


@lru_cache(maxsize=256)
def _error_rates(base: Base) -> list:
    with digits(WORKING):
        noise = stack(base.gyro_noise, base.accel_noise)
        phi_rates = truth(base).phi_rates(errors(base), noise)
        psi_rates = against_computed_axes(base)
        return [
            phi_rates,
            truth(base).phi_rates(zeros(15, 1), noise),
            phi_rates[3:6, 0],
            phi_rates[6:9, 0],
            psi_rates[0:3, 0],
            psi_rates[3:6, 0],
            stack(psi_rates, zeros(4, 1)),
        ]


@lru_cache(maxsize=256)
def _rates(base: Base) -> list:
    with digits(WORKING):
        noise = stack(base.gyro_noise, base.accel_noise)
        exact, hat = truth(base).exact, truth(base).hat(errors(base), noise)
        ie, en = hat.omega_ie_n - exact.omega_ie_n, hat.omega_en_n - exact.omega_en_n
        return [
            *map(skew, (exact.omega_ie_n, exact.omega_en_n, ie, en, exact.f_n)),
            ie,
            en,
            exact.f_n,
            exact.velocity_rate,
            hat.gravity_n - exact.gravity_n,
            Matrix(base.accel_bias) + Matrix(base.accel_noise),
            Matrix(base.gyro_bias) + Matrix(base.gyro_noise),
        ]


def _true_motion(base: Base) -> list:
    exact = truth(base).exact
    rate = exact.C_rate
    return [
        exact.omega_ie_n, exact.omega_en_n, exact.omega_in_n, exact.gravity_n, exact.C_b2n.T, rate, rate.T,
        *exact.position_rate,
    ]  # fmt: skip


@lru_cache(maxsize=256)
def _computed_motion(base: Base) -> list:
    with digits(WORKING):
        noise = stack(base.gyro_noise, base.accel_noise)
        true, hat = truth(base), truth(base).hat(errors(base), noise)
        return [
            hat.v_n, hat.velocity_rate, true.f_b + errors(base)[12:15, 0] + noise[3:6, 0], hat.gravity_n,
            hat.omega_ie_n, hat.omega_en_n, hat.omega_in_n, hat.omega_in_n - true.exact.omega_in_n,
            true.omega + errors(base)[9:12, 0] + noise[0:3, 0], hat.C_b2n, hat.C_rate,
        ]  # fmt: skip


MOVED = exact(60)  # s, in which the velocity error has moved the computed place


@lru_cache(maxsize=256)
def _computed_axes(base: Base) -> tuple[navigation.Navigator, Matrix, Matrix, Matrix]:
    """Perfect sensors, and gravity as it is, but the computed velocity and attitude, and axes c where these lead to.

    The navigator, the rate of its velocity, C_n2c and the rate of that.
    """
    with digits(WORKING):
        true, exact = truth(base), truth(base).exact
        moved = exact.slope.solve(exact.axes * Matrix(base.velocity_error) * MOVED)
        hat = true.psi_hat(stack(moved, errors(base)[3:9, 0]))
        turn, rate = hat.axes.T * exact.axes, hat.axes_rate.T * exact.axes + hat.axes.T * exact.axes_rate
        return hat, hat.velocity_rate - hat.gravity_n + turn * exact.gravity_n, turn, rate


def against_computed_axes(base: Base) -> Matrix:
    """(6) rates of velocity and attitude error against the axes c."""
    true, (hat, velocity_rate, turn, rate) = truth(base), _computed_axes(base)
    C_b2c, C_b2c_rate = turn * true.C, rate * true.C + turn * true.exact.C_rate
    return stack(
        velocity_rate - rate * true.v_n - turn * true.exact.velocity_rate,
        navigation.rotation_rate(hat.C_b2n * C_b2c.T, hat.C_rate * C_b2c.T + hat.C_b2n * C_b2c_rate.T),
    )


def _in_computed_axes(base: Base) -> list:
    hat, velocity_rate, turn, rate = _computed_axes(base)
    return [hat.v_n, velocity_rate, hat.omega_en_n, hat.omega_in_n, hat.C_b2n, hat.C_rate, turn, turn.T, rate, rate.T]


@lru_cache(maxsize=64)
def _slopes(true: Truth) -> list:
    with digits(WORKING):

        def displaced(x) -> navigation.Navigator:
            return true.hat(stack(x, zeros(9, 1)), zeros(6, 1))

        names = ("omega_ie_n", "omega_en_n", "gravity_n")
        ie, en, g = (ellipsoid.jacobian(lambda x, name=name: getattr(displaced(x), name), 6) for name in names)
        return [ie[:, 0:3], en[:, 0:3], en[:, 3:6], g[:, 0:3]]


@lru_cache(maxsize=64)
def curvature(base: Base) -> list:
    with digits(WORKING):
        lat = base.position[1]

        def radii(change) -> Matrix:
            """Transverse and meridian radius: how far the ground is moved along by a change of an angle."""
            slope = ellipsoid.slope(vector(0, lat + change, 0))
            return vector(norm(slope[:, 0]) / cos(lat + change), norm(slope[:, 1]))

        return [*radii(0), *ellipsoid.rate(radii), *truth(base).exact.omega_en_n]


@lru_cache(maxsize=64)
def matrices(true: Truth) -> list:
    with digits(WORKING):

        def measured(x) -> Matrix:
            M = finite_rotation(-x[6:9, 0])  # the computed attitude against that of the transfer alignment
            return stack(true.v_n + x[3:6, 0], (M[0, 1] - M[1, 0]) / 2)

        F_X = zeros(10)
        F_X[0:6, 0:6] = ellipsoid.jacobian(partial(position_known, true), 6)
        H = ellipsoid.jacobian(measured, 15)
        noise = ellipsoid.jacobian(lambda sensors: true.phi_rates(zeros(15, 1), sensors), 6)
        return [ellipsoid.jacobian(true.phi_rates, 15), F_X, H, H[0:3, :], noise]


def series(first, following: Callable, step) -> Matrix:
    """Taylor series in time: first + step following(first) + step^2/2 following(following(first)) + ..."""
    term, result, k = first, first, 0
    while max(map(abs, term)) > 1e-40:
        k += 1
        term = following(term) * (step / k)
        result += term
    return result


@lru_cache(maxsize=64)
def transition(true: Truth, step) -> Matrix:
    F = matrices(true)[0]
    with digits(WORKING):
        return series(eye(15), lambda term: F * term, step)


PREDICTED = exact("0.5")  # s, of (13) and (14)


@lru_cache(maxsize=256)
def _predicted(base: Base) -> list:
    before, F = errors(base), matrices(truth(base))[0]

    def displaced(x) -> Matrix:
        return series(x, lambda term: F * term, PREDICTED / 4)

    with digits(WORKING):
        return [before, displaced(displaced(displaced(displaced(before))))]


@lru_cache(maxsize=64)
def _filter(true: Truth) -> list:
    """A covariance through one prediction, by its differential equation, and one update, in information form."""
    F, _, H, *_ = matrices(true)
    generator = Random(5)

    def positive(size: int) -> Matrix:
        S = Matrix([[generator.uniform(-1, 1) for _ in range(size)] for _ in range(size)])
        return S * S.T + eye(size)

    def grown(P, forced: bool) -> Matrix:
        """P' = F P + P F' + noise; the noise enters the series once, with its first power of time."""

        def following(term) -> Matrix:
            half = F * term
            return half + half.T

        result = series(P, following, PREDICTED) if not forced else zeros(15)
        term, k = noise * PREDICTED, 1
        while max(map(abs, term)) > 1e-40:
            result += term
            k += 1
            term = following(term) * (PREDICTED / k)
        return result

    def at(time) -> Matrix:
        """The covariance after this time, by one exponential of twice the size (van Loan)."""
        both = zeros(30)
        both[0:15, 0:15], both[0:15, 15:30], both[15:30, 15:30] = -F * time, noise * time, F.T * time
        grown = both.exp()
        Phi = grown[15:30, 15:30].T
        return Phi * before * Phi.T + Phi * grown[0:15, 15:30]

    with digits(WORKING):
        before, noise = positive(15), positive(15)
        after, Q = grown(before, False), grown(zeros(15), True)
        R = positive(4)
        updated = (after.inv() + H.T * R.inv() * H).inv()
        gain = updated * H.T * R.inv()
        return [transition(true, PREDICTED), before, Q, after, R, gain, updated, noise, ellipsoid.rate(at)]


@lru_cache(maxsize=64)
def _moments(true: Truth) -> dict:
    """Columns of a root of each random letter's covariance, which the filter has."""
    _, before, Q, after, R, *_ = _filter(true)
    with digits(WORKING):
        roots = {"ξ_k-1": before, "ξ_k": after, "η": Q, "ζ": R}
        return {
            name: [root[:, j] for j in range(root.cols)]
            for name, root in zip(roots, map(cholesky, roots.values()), strict=True)
        }


def cholesky(P: Matrix) -> Matrix:
    """The lower root L of P = L L'."""
    L = zeros(P.rows)
    for j in range(P.rows):
        L[j, j] = sqrt(P[j, j] - sum(L[j, k] ** 2 for k in range(j)))
        for i in range(j + 1, P.rows):
            L[i, j] = (P[i, j] - sum(L[i, k] * L[j, k] for k in range(j))) / L[j, j]
    return L


@lru_cache(maxsize=256)
def _least_squares(base: Base) -> Matrix:
    """The x which is nearest to prediction and measurement, each weighted by its covariance: normal equations."""
    _, _, H, *_ = matrices(truth(base))
    _, _, _, P, R, _, P_after, *_ = _filter(truth(base))
    measured = stack(*(a + b for a, b in zip(base.v_n, base.velocity_error, strict=True)), base.phi[2])
    with digits(WORKING):
        return P_after * (P.solve(_predicted(base)[1]) + H.T * R.inv() * measured)


# Section 2.1: the master.


@lru_cache(maxsize=256)
def _transfer(base: Base) -> list:
    with digits(WORKING):
        true = truth(base)
        C_b2r = finite_rotation(base.mounting)
        C_r2n = true.C * C_b2r.T
        omega_r = C_b2r * true.omega
        none = zeros(3, 1)

        def delayed(delay) -> Matrix:
            return finite_rotation(true.exact.omega_in_n * delay) * C_r2n * finite_rotation(-omega_r * delay)

        def seen(x, master_velocity, master_attitude) -> tuple:
            """x: velocity error, attitude error, mounting error, delay."""
            delay = x[9]
            C_hat_r2n = finite_rotation(-master_attitude) * delayed(delay)
            C_hat_b2r = finite_rotation(-x[6:9, 0]) * C_b2r
            C_hat_n2b = (finite_rotation(-x[3:6, 0]) * true.C).T
            old = true.v_n - true.exact.velocity_rate * delay + Matrix(base.jerk) * delay**2 / 2
            slave, master = true.v_n + x[0:3, 0], old + master_velocity
            return C_hat_r2n, C_hat_b2r, C_hat_n2b, _vee(C_hat_r2n * C_hat_b2r * C_hat_n2b), slave, master

        x = stack(base.velocity_error, base.phi, base.theta, base.delay[0])
        noise = Matrix(base.master_velocity_error), Matrix(base.master_attitude_error)
        C_hat_r2n, C_hat_b2r, C_hat_n2b, Z_dcm, slave, master = seen(x, *noise)

        def Z(x) -> Matrix:
            *_, attitude, slave, master = seen(x, none, none)
            return stack(slave - master, attitude)

        H = ellipsoid.jacobian(Z, 10)
        return [
            C_r2n, delayed(base.delay[0]), C_hat_r2n, C_hat_b2r, C_hat_n2b, Z_dcm, -noise[1],
            slave, master, slave - master, -noise[0], H[3:6, 9], H,
            C_r2n * omega_r - true.exact.omega_in_n,
            quaternion(C_r2n), quaternion(C_hat_r2n), rotation_vector(C_hat_b2r),
            seen(stack(zeros(9, 1), base.delay[0]), none, none)[5], C_b2r, C_r2n.T,
        ]  # fmt: skip


# The axes of section 2.2.2 and the quaternion of (29).


@lru_cache(maxsize=256)
def attitudes(base: Base) -> list:
    C = truth(base).C
    C_hat = finite_rotation(-Matrix(base.phi)) * C
    u = vector(exact("0.3"), exact("-0.7"), exact("0.5"))
    computed, true = quaternion(C_hat), quaternion(C)
    true = true if (true.T * computed)[0] > 0 else -true  # q and -q are one attitude
    return [C, C_hat, C.T, skew(base.phi), *u, *(C_hat * u), *computed, computed, true, computed - true]


# Section 2.2.4: a record of both sensors at rest but for noise.


def _noise(base: Base, k: int) -> list:
    generator = Random(17 + k)
    return [vector(*uniform(generator, size)) for size in ("0.1", "0.02")]


def _outputs(base: Base, k: int) -> list:
    a, w = _noise(base, k)
    return [Matrix(base.f_b) + a, Matrix(base.omega_ib_b) + w]


def _samples(base: Base, values: Mapping) -> list[dict]:
    """The letters of the detector at each sample of the window; those of NOW as they are defined."""
    names = ("norm", "ȳ_a", "N", "n", "y_a", "y_w")
    common = {normalize("NFC", n): values[normalize("NFC", n)] for n in names}
    result = []
    for k in range(SAMPLES):
        if values["Ω_n"][k] != 0:
            own = dict(zip(("y_a", "y_w"), _outputs(base, k), strict=True)) if k != NOW else {}
            noise = dict(zip(("ν_a", "ν_w"), _noise(base, k), strict=True))
            result.append({**common, **{n: values[n] for n in ("s_a", "s_w")}, **noise, **own})
    return result


def _between(lower, index, upper) -> Matrix:
    return vector(*(exact(int(lower <= k <= upper)) for k in range(SAMPLES)))


@lru_cache(maxsize=64)
def _detector(base: Base) -> list:
    """Statistics of a window by its pairs: no mean is taken first."""
    a, w = zip(*(_outputs(base, k) for k in range(WINDOW_AT, WINDOW_AT + WINDOW_OF)), strict=True)
    pairs = [(i, j) for i in range(WINDOW_OF) for j in range(WINDOW_OF)]
    spread = sqrt(sum(norm(a[i] - a[j]) ** 2 for i, j in pairs) / 2) / WINDOW_OF
    mean = sqrt(sum((w[i].T * w[j])[0] for i, j in pairs)) / WINDOW_OF
    centers = [vector(*(sum(v[i] for v in record) / WINDOW_OF for i in range(3))) for record in (a, w)]
    return [spread, mean, *centers, 10 * spread, 10 * mean]


# ---- What letters are by their nature --------------------------------------------------------------------------------


def transposed(C: Matrix) -> Matrix:
    return C.T


def over(*parts: Any) -> Matrix:
    return assembled([[part] for part in parts])


def conjugate(q: Matrix) -> Matrix:
    return vector(q[0], -q[1], -q[2], -q[3])


def drawn_quaternion(generator: Random) -> Matrix:
    q = Matrix([exact(generator.uniform(0.2, 1.2)) for _ in range(4)])
    return q / norm(q)


unit_quaternion = Kind(drawn_quaternion, lambda q: abs(norm(q) - 1) < 1e-28)
far_limit = Kind(lambda generator: exact(1000), lambda x: x > 0)


def moments(generator: Random) -> dict[str, list[Matrix]]:
    """Of each random letter the columns of a root of its covariance."""

    def root(size: int) -> list[Matrix]:
        return [Matrix([exact(generator.uniform(-1, 1)) for _ in range(size)]) for _ in range(size)]

    return {"ξ_k-1": root(15), "ξ_k": root(15), "η": root(15), "ζ": root(4)}


def constant(value: Any) -> Callable[[Random], Any]:
    return lambda generator: value


def _structure() -> Iterator[tuple[str, Any]]:
    for name, block in BLOCKS.items():
        yield name, constant(block)
    yield from {"I": constant(eye(3)), "I_15x15": constant(eye(15))}.items()
    for name in ("C_b2n", "C̄_n2b", "C_r2n(k-δt)", "C_n2c", "C_b2r", "C_r2n", "Ĉ_r2n", "Ĉ_b2r", "Ĉ_n2b"):
        yield name, rotation
    for name, other in (
        ("C_n2b", "C_b2n"),
        ("C_c2n", "C_n2c"),
        ("C_n2r", "C_r2n"),
        ("Ċ_n2b", "Ċ_b2n"),
        ("Ċ_c2n", "Ċ_n2c"),
    ):
        yield name, of(other, transposed)
    for name in ("ω_ie_n", "ω_en_n", "δω_ie_n", "δω_en_n", "f_n"):
        yield f"[{name} x]", of(name, skew)
    yield from {
        "δv": of("δv_e|δv_n|δv_u", vector),
        "v": of("v_e|v_n|v_u", vector),
        "φ": of("φ_e|φ_n|φ_u", vector),
        "X": of("δv|φ|θ|Δt", over),
        "x_p": of("δl|δL|δh", vector),
        "x_v": of("δv_e|δv_n|δv_u", vector),
        "x_φ": of("φ_e|φ_n|φ_u", vector),
        "x": of("x_p|x_v|x_φ|x_Cb|x_Ab", over),
        "x_k": of("x_p|x_v|x_φ|x_Cb|x_Ab", over),
        "z_v": of("z", lambda z: z[0:3, 0]),
        "ν_z": of("ν", lambda noise: noise[0:3, 0]),
        "H_v": of("H_k", lambda H: H[0:3, :]),
        "P(k-)": positive(15),
        "R": positive(4),
        "Q̂_b2n": of("q_0|q_1|q_2|q_3", vector),
        "V": unit_quaternion,
        "V̄": of("V", conjugate),
        "random": moments,
        "T_a": positive_number,
        "N": constant(exact(3)),
        "n": constant(exact(2)),
        "γ_a": far_limit,
        "γ_w": far_limit,
    }.items()


STRUCTURE: Mapping[str, Any] = {
    normalize("NFC", name): replace(rule, letters=tuple(normalize("NFC", n) for n in rule.letters))
    if hasattr(rule, "letters")
    else rule
    for name, rule in _structure()
}

WITNESS = Witness(Base, values, Conditions(), ERRORS, "finite errors", PARTS)
SIZES = Stated(CONDITIONS, CONDITIONS_TEXT, 4)
POINT = Stated(STATED, STATED_TEXT)
