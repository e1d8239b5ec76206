"""Numbers for every letter of Kim 2018 at a point: the witness of its ledger.

Rates come from Newton's law on the turning ellipsoid and from finite rotations, in many digits; radii, transport rate
and the matrices F and H are differentiated from them, so none of the paper's formulas judges itself.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields, replace
from functools import cache, lru_cache
from random import Random
from typing import Any
from unicodedata import normalize

import sympy as sp
from flint import arb

from boresight.derive import earth, ellipsoid
from boresight.derive.ellipsoid import WORKING
from boresight.derive.equation import Relation
from boresight.derive.numbers import Matrix, atan2, cos, digits, exact, eye, norm, pi, shown, sqrt, zeros
from boresight.derive.papers import kim_2018 as paper
from boresight.derive.papers.kim_2018_print import DETECTORS, quantities
from boresight.derive.witness import (
    DIGITS,
    Point,
    attitude,
    evaluate,
    finite_rotation,
    hamilton,
    quaternion,
    rotation_vector,
    skew,
    solve,
    uniform,
    vector,
)

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

    def scaled(self, scale, parts=()) -> "Conditions":
        """The named errors, or all of them with delay and step, times `scale`; motion and attitude as they are."""
        sizes = {part: getattr(self, part) for part in parts or ERRORS}
        changes: dict[str, Any] = {
            part: tuple(s * scale for s in size) if isinstance(size, tuple) else size * scale
            for part, size in sizes.items()
        }
        return replace(self, **changes)


ERRORS = (
    "position_error", "velocity_error", "phi", "gyro_bias", "accel_bias", "gyro_noise", "accel_noise",
    "theta", "delay", "master_velocity_error", "master_attitude_error", "step",
)  # fmt: skip

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
WITNESS = "finite errors"
POINTS = 4  # of these conditions, drawn for the sizes
CONDITIONS_TEXT = (
    "sensors of Table 1, errors to 5 mrad, 1 m/s, 1 nmi per axis, delay 50 ms on a bench that moves at 0.5 m/s and "
    "5 deg/s, step 10 ms"
)


def _degrees(*angles) -> tuple:
    return tuple(exact(float(angle) * math.pi / 180) for angle in angles)


# The point at which an erratum's numbers are given.
STATED = Base(
    position=(*_degrees(127, 37), exact(1000)),
    v_n=(exact(60), exact(80), exact(0)),
    euler=_degrees(2, 3, 40),
    f_b=(exact("0.5"), exact(1), exact("9.8")),
    omega_ib_b=_degrees(1, 2, 10),
    position_error=(*_degrees("0.02", "0.02"), exact(100)),
    velocity_error=(exact(1), exact(-1), exact("0.5")),
    phi=_degrees("0.1", "-0.2", "0.3"),
    gyro_bias=tuple(angle / 3600 for angle in _degrees(1, -1, 1)),
    accel_bias=tuple(exact(x) * exact("9.80665e-3") for x in (1, -1, 1)),
    gyro_noise=(exact(0),) * 3,
    accel_noise=(exact(0),) * 3,
    mounting=_degrees(1, 2, -1),
    theta=_degrees("0.2", "-0.1", "0.1"),
    delay=(exact("0.05"), exact(0), exact(0)),
    jerk=(exact(0),) * 3,
    master_velocity_error=(exact(0),) * 3,
    master_attitude_error=(exact(0),) * 3,
    step=(exact("0.01"), exact(0), exact(0)),
)
STATED_TEXT = (
    "latitude 37 deg, height 1 km, 100 m/s to the north-east; errors 0.02 deg in position, 100 m in height, 1, -1, "
    "0.5 m/s, 0.1, -0.2, 0.3 deg in attitude; 1 deg/h, 1 mg; mounting error 0.2, -0.1, 0.1 deg, delay 50 ms"
)


@cache
def draw(seed: int, conditions: Conditions) -> Base:
    """A point of the conditions; the same seed at another scale gives the same directions."""
    generator = Random(seed)
    parts = {part.name: tuple(uniform(generator, getattr(conditions, part.name))) for part in fields(conditions)}
    for name in ("delay", "step"):
        parts[name] = tuple(map(abs, parts[name]))
    return Base(**parts)


# ---- Exact mechanics -------------------------------------------------------------------------------------------------


class Mechanics:
    """What a perfect or an erring navigator at one state computes: rates by Newton's law on the turning ellipsoid."""

    def __init__(self, position, v_n, C_b2n, f_b, omega_ib_b):
        self.C_b2n, self.v_n = C_b2n, v_n
        axes, slope = ellipsoid.axes(position), ellipsoid.slope(position)
        self.position_rate = slope.solve(axes * v_n)
        self.axes, self.axes_rate = axes, ellipsoid.rate(lambda t: ellipsoid.axes(position + t * self.position_rate))
        turning = axes.T * self.axes_rate
        self.omega_en_n = vector(turning[2, 1], turning[0, 2], turning[1, 0])
        spin = vector(0, 0, ellipsoid.defined(earth.EARTH_RATE))
        self.omega_ie_n = axes.T * spin
        self.omega_in_n = self.omega_ie_n + self.omega_en_n
        self.gravity_n = vector(0, 0, -evaluate(_gravity(), Point({"lat": position[1], "height": position[2]})))
        self.f_n = C_b2n * f_b
        # Velocity over the ground in turning axes: gravity has the centrifugal part, Coriolis twice the spin.
        self.velocity_rate = (
            self.f_n + self.gravity_n - axes.T * (2 * skew(spin) * axes * v_n) + self.axes_rate.T * axes * v_n
        )
        self.C_rate = C_b2n * skew(omega_ib_b) - skew(self.omega_in_n) * C_b2n


@cache
def _gravity() -> sp.Expr:
    return earth.normal_gravity(*sp.symbols("lat height"))


def _stack(*parts) -> Matrix:
    return vector(*(entry for part in parts for entry in (part if isinstance(part, Matrix | tuple) else (part,))))


def _rotation_rate(matrix, rate) -> Matrix:
    """The rate of e in exp(-[e x]) = matrix, whose rate is given."""
    return ellipsoid.rate(lambda t: -rotation_vector(matrix + t * rate))


@dataclass(frozen=True, eq=False)
class Truth:
    """The true state of the slave, and what follows from it alone."""

    position: Matrix
    v_n: Matrix
    C: Matrix
    f_b: Matrix
    omega: Matrix
    exact: Mechanics

    def hat(self, x, noise) -> Mechanics:
        """The navigator with the errors x: position, velocity, phi, gyro and accelerometer bias; noise (6)."""
        return Mechanics(
            self.position + x[0:3, 0],
            self.v_n + x[3:6, 0],
            finite_rotation(-x[6:9, 0]) * self.C,
            self.f_b + x[12:15, 0] + noise[3:6, 0],
            self.omega + x[9:12, 0] + noise[0:3, 0],
        )

    def phi_rates(self, x, noise=None) -> Matrix:
        """(15) rates of the states of section 2.2: against the true axes."""
        hat, exact = self.hat(x, zeros(6, 1) if noise is None else noise), self.exact
        turned, rate = hat.C_b2n * self.C.T, hat.C_rate * self.C.T + hat.C_b2n * exact.C_rate.T
        return _stack(
            hat.position_rate - exact.position_rate,
            hat.velocity_rate - exact.velocity_rate,
            _rotation_rate(turned, rate),
            zeros(6, 1),
        )

    def psi_rates(self, x) -> Matrix:
        """(6) rates of velocity and attitude error against the computed axes, where the position is known.

        x: velocity error and psi; perfect sensors.  The computed axes agree with the true ones now, not in a moment.
        """
        full = _stack(zeros(3, 1), x, zeros(6, 1))
        hat, exact = self.hat(full, zeros(6, 1)), self.exact
        C_n2c_rate = hat.axes_rate.T * exact.axes + hat.axes.T * exact.axes_rate
        turned = hat.C_b2n * self.C.T
        rate = hat.C_rate * self.C.T + hat.C_b2n * exact.C_rate.T + turned * C_n2c_rate.T
        return _stack(hat.velocity_rate - exact.velocity_rate - C_n2c_rate * self.v_n, _rotation_rate(turned, rate))


@lru_cache(maxsize=64)
def _truth(position, v_n, euler, f_b, omega) -> Truth:
    parts = [Matrix(part) for part in (position, v_n, f_b, omega)]
    C = attitude(euler)
    return Truth(parts[0], parts[1], C, parts[2], parts[3], Mechanics(parts[0], parts[1], C, parts[2], parts[3]))


@lru_cache(maxsize=256)
def truth(base: Base) -> Truth:
    with digits(WORKING):
        return _truth(base.position, base.v_n, base.euler, base.f_b, base.omega_ib_b)


def errors(base: Base) -> Matrix:
    return _stack(base.position_error, base.velocity_error, base.phi, base.gyro_bias, base.accel_bias)


# ---- Letters ---------------------------------------------------------------------------------------------------------


class Letters(Mapping):
    """Values by name, each group worked out when one of its letters is asked for."""

    def __init__(self, groups: tuple[tuple[str, Callable], ...], given: Mapping):
        split = [(tuple(normalize("NFC", names).split("|")), make) for names, make in groups]
        self._of = {name: (names, make) for names, make in split for name in names}
        self._known = {normalize("NFC", name): value for name, value in given.items()}
        self._open: set[str] = set()

    def __getitem__(self, name):
        if name not in self._known:
            if name not in self._of:
                raise KeyError(f"the paper does not define {name}")
            if name in self._open:
                raise KeyError(f"{name} is defined by itself")
            self._open.add(name)
            names, make = self._of[name]
            self._known.update(zip(names, make(self), strict=True))
        return self._known[name]

    def __iter__(self) -> Iterator[str]:
        return iter({*self._known, *self._of})

    def __len__(self) -> int:
        return len({*self._known, *self._of})


def world(base: Base, definitions: Mapping[str, tuple[Relation, ...]]) -> Letters:
    """Values of every letter of the paper at one point.

    definitions: the relations of the equations which define a letter, by number; the witness takes them as given.
    Raises ValueError, KeyError or ZeroDivisionError where a definition does not define, when its letter is asked for.
    """
    given = {
        **{q.symbol.name: zeros(*q.shape) for q in quantities() if q.kind == "block"},
        "I": eye(3), "I_3x3": eye(3), "I_15x15": eye(15),
        "N": exact(WINDOW_OF), "n": exact(WINDOW_AT), "index": exact(0),
        "Ω_n": _between(WINDOW_AT, 0, WINDOW_AT + WINDOW_OF - 1),
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
               "x_Ab": "accel_bias", "ν_z": "v_n", "s_a": "f_b", "s_w": "omega_ib_b"}  # fmt: skip
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
        ("y_a|y_w", lambda a: [a["y_k"][0:3, 0], a["y_k"][3:6, 0]]),
        ("ν_a|ν_w", lambda a: _noise(base, NOW)),
        ("T_a|T_w|ȳ_a|γ_a|γ_w", lambda a: _detector(base)),
        ("δl̇|δL̇|δḣ", position_error_rates),
        ("ẋ_k|w_k|δv̇|φ̇|δv̇_c|ψ̇|Ẋ", lambda a: _error_rates(base)),
        (RATES, lambda a: _rates(base)),
        ("R_E|R_N|R_EE|R_NN|ρ_e|ρ_n|ρ_u", lambda a: _curvature(base)),
        ("F_k|F_X|H_k|H_v", lambda a: _matrices(truth(base))),
        ("Φ_k", lambda a: [_transition(truth(base), base.step[0])]),
        (FILTER, lambda a: _filter(truth(base))),
        ("x(k-1+)|x(k-)", lambda a: _predicted(base)),
        ("x(k+)", lambda a: [_least_squares(base)]),
        ("ν", lambda a: [_stack(base.v_n, exact(0))]),
        (TRANSFER, lambda a: _transfer(base)),
        (ATTITUDES, lambda a: _attitudes(base)),
    )
    return Letters(groups, given)


RATES = "[ω_ie_n x]|[ω_en_n x]|[δω_ie_n x]|[δω_en_n x]|[f_n x]|δω_ie_n|δω_en_n|f_n|v̇|δg_n|δf_b|δω_ib_b"
FILTER = "Φ_k-1|P(k-1+)|Q_k|P(k-)|R|K_k|P(k+)"
TRANSFER = "C_r2n|C_r2n(k-δt)|Ĉ_r2n|Ĉ_b2r|Ĉ_n2b|Z_dcm|ν_dcm|v̂_SINS|v̂_MINS|Z_v|ν_v|d|H_X"
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
        noise = _stack(base.gyro_noise, base.accel_noise)
        phi_rates = truth(base).phi_rates(errors(base), noise)
        psi_rates = truth(base).psi_rates(errors(base)[3:9, 0])
        return [
            phi_rates,
            truth(base).phi_rates(zeros(15, 1), noise),
            phi_rates[3:6, 0],
            phi_rates[6:9, 0],
            psi_rates[0:3, 0],
            psi_rates[3:6, 0],
            _stack(psi_rates, zeros(4, 1)),
        ]


@lru_cache(maxsize=256)
def _rates(base: Base) -> list:
    with digits(WORKING):
        noise = _stack(base.gyro_noise, base.accel_noise)
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


@lru_cache(maxsize=64)
def _curvature(base: Base) -> list:
    with digits(WORKING):
        lat = base.position[1]

        def radii(change) -> Matrix:
            """Transverse and meridian radius: how far the ground is moved along by a change of an angle."""
            slope = ellipsoid.slope(vector(0, lat + change, 0))
            return vector(norm(slope[:, 0]) / cos(lat + change), norm(slope[:, 1]))

        return [*radii(0), *ellipsoid.rate(radii), *truth(base).exact.omega_en_n]


@lru_cache(maxsize=64)
def _matrices(true: Truth) -> list:
    with digits(WORKING):

        def measured(x) -> Matrix:
            M = finite_rotation(-x[6:9, 0])  # the computed attitude against that of the transfer alignment
            return _stack(true.v_n + x[3:6, 0], (M[0, 1] - M[1, 0]) / 2)

        F_X = zeros(10)
        F_X[0:6, 0:6] = ellipsoid.jacobian(true.psi_rates, 6)
        H = ellipsoid.jacobian(measured, 15)
        return [ellipsoid.jacobian(true.phi_rates, 15), F_X, H, H[0:3, :]]


def _series(first, following: Callable, step) -> Matrix:
    """Taylor series in time: first + step following(first) + step^2/2 following(following(first)) + ..."""
    term, result, k = first, first, 0
    while max(map(abs, term)) > 1e-40:
        k += 1
        term = following(term) * (step / k)
        result += term
    return result


@lru_cache(maxsize=64)
def _transition(true: Truth, step) -> Matrix:
    F = _matrices(true)[0]
    with digits(WORKING):
        return _series(eye(15), lambda term: F * term, step)


PREDICTED = exact("0.5")  # s, of (13) and (14)


@lru_cache(maxsize=256)
def _predicted(base: Base) -> list:
    before, F = errors(base), _matrices(truth(base))[0]

    def moved(x) -> Matrix:
        return _series(x, lambda term: F * term, PREDICTED / 4)

    with digits(WORKING):
        return [before, moved(moved(moved(moved(before))))]


@lru_cache(maxsize=64)
def _filter(true: Truth) -> list:
    """A covariance through one prediction, by its differential equation, and one update, in information form."""
    F, _, H, _ = _matrices(true)
    generator = Random(5)

    def positive(size: int) -> Matrix:
        S = Matrix([[generator.uniform(-1, 1) for _ in range(size)] for _ in range(size)])
        return S * S.T + eye(size)

    noise = zeros(15)
    noise[3:6, 3:6] = eye(3)
    noise[6:9, 6:9] = eye(3) * 2

    def grown(P, forced: bool) -> Matrix:
        """P' = F P + P F' + noise; the noise enters the series once, with its first power of time."""

        def following(term) -> Matrix:
            half = F * term
            return half + half.T

        result = _series(P, following, PREDICTED) if not forced else zeros(15)
        term, k = noise * PREDICTED, 1
        while max(map(abs, term)) > 1e-40:
            result += term
            k += 1
            term = following(term) * (PREDICTED / k)
        return result

    with digits(WORKING):
        before = positive(15)
        after, Q = grown(before, False), grown(zeros(15), True)
        R = positive(4)
        updated = (after.inv() + H.T * R.inv() * H).inv()
        return [_transition(true, PREDICTED), before, Q, after, R, updated * H.T * R.inv(), updated]


@lru_cache(maxsize=256)
def _least_squares(base: Base) -> Matrix:
    """The x which is nearest to prediction and measurement, each weighted by its covariance: normal equations."""
    _, _, H, _ = _matrices(truth(base))
    _, _, _, P, R, _, P_after = _filter(truth(base))
    measured = _stack(*(a + b for a, b in zip(base.v_n, base.velocity_error, strict=True)), base.phi[2])
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

        x = _stack(base.velocity_error, base.phi, base.theta, base.delay[0])
        noise = Matrix(base.master_velocity_error), Matrix(base.master_attitude_error)
        C_hat_r2n, C_hat_b2r, C_hat_n2b, Z_dcm, slave, master = seen(x, *noise)

        def Z(x) -> Matrix:
            *_, attitude, slave, master = seen(x, none, none)
            return _stack(slave - master, attitude)

        H = ellipsoid.jacobian(Z, 10)
        return [
            C_r2n, delayed(base.delay[0]), C_hat_r2n, C_hat_b2r, C_hat_n2b, Z_dcm, -noise[1],
            slave, master, slave - master, -noise[0], H[3:6, 9], H,
        ]  # fmt: skip


# The axes of section 2.2.2 and the quaternion of (29).


@lru_cache(maxsize=256)
def _attitudes(base: Base) -> list:
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
    center = vector(*(sum(v[i] for v in a) / WINDOW_OF for i in range(3)))
    return [spread, mean, center, 10 * spread, 10 * mean]


# ---- Sizes of what is dropped, and what a wrong sign does ------------------------------------------------------------

LATITUDE = 37  # deg, where the sizes are given, at rest unless they say otherwise


def evidence(number: str) -> str:
    """What the ledger says beyond the status: sizes, and runs of the print's own dynamics; "" for most equations."""
    if number not in _EVIDENCE:
        return ""
    with digits(DIGITS):
        return "; " + _EVIDENCE[number]()


def findings() -> tuple[str, ...]:
    """What was computed about the text beside the equations."""
    earth_rate = float(sp.Rational(earth.EARTH_RATE)) / DEGREE * HOUR
    north = 1 / (earth_rate * math.cos(LATITUDE * DEGREE)) / DEGREE
    return (
        f"Line {DETECTORS[0]} has the detector of mean and deviation both of the angular rate; its reasons, and (31), "
        "want the deviation of the specific force; in Korean the two words differ in one syllable.",
        "The letter φ is two states: psi in (1) to (6), phi in (8) to (29); between them lies the turn of the level by "
        f"the position error, 1 arcmin per nautical mile, and psi does not see δω_in_n, {_level_rate()} deg/h per m/s.",
        "(17) and (23) are written for 24 states, nine more than (8): scale factors and misalignments of Table 1 "
        "would fill them.",
        f"Table 1 beside the Earth's rate of {earth_rate:.4g} deg/h: a gyro of 1 deg/h finds north to "
        f"{north:.2g} deg, 1 mg tilts the level by 1 mrad = 3.4 arcmin.",
    )


@cache
def _at_rest() -> Truth:
    C = eye(3)
    with digits(WORKING):
        position = vector(0, exact(LATITUDE) * pi() / 180, 0)
        still = Mechanics(position, zeros(3, 1), C, zeros(3, 1), zeros(3, 1))
        f, omega = -still.gravity_n, still.omega_ie_n
        return Truth(position, zeros(3, 1), C, f, omega, Mechanics(position, zeros(3, 1), C, f, omega))


def level_dynamics(sign: int) -> Matrix:
    """F at rest without the vertical channel, 7x7: longitude, latitude, level velocities, attitude.

    sign: of δω_in_n in (11); +1 is right, -1 as printed.
    """
    F = _matrices(_at_rest())[0].copy()
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
    R_E, R_N, _, R_NN, rho_e, rho_n, _ = (float(x) for x in _curvature(base))
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
        return float(_series(Matrix([0, 0, 0, 0, 1e-4, 0, 0]), lambda term: F * term, 3600)[3])

    return (
        f"at rest the level channels' eigenvalues have real parts below {shown(max(right, 1e-20), 1)} 1/s "
        f"as derived, and up to {shown(wrong, 4)} 1/s as printed: instead of an oscillation of 84 min errors grow "
        f"e-fold in {float(1 / wrong):.0f} s; a tilt of 0.1 mrad makes a velocity of {tilt(1):.2g} m/s after an hour "
        f"as derived, {tilt(-1):.3g} m/s as printed"
    )


def transition_error(step) -> dict[str, arb]:
    """The largest entry of exp(F step) - I - F step by block, row from column, at rest."""
    F = _matrices(_at_rest())[0]
    missing = _transition(_at_rest(), exact(step)) - eye(15) - F * step
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
    letters = _attitudes(STATED)
    computed, true = letters[-3], letters[-2]
    phi = Matrix(STATED.phi)
    change = -hamilton(_stack(exact(0), phi), computed) / 2

    def left(q) -> arb:
        turn = hamilton(vector(true[0], *-true[1:4, 0]), q)
        return 2 * atan2(norm(turn[1:4, 0]), abs(turn[0]))

    return {
        "nothing": left(computed),
        "a 0 put before φ, the product kept": left(hamilton(change, computed)),
        "[1, -φ/2] for ΔQ": left(hamilton(_stack(exact(1), -phi / 2), computed)),
        "[1, +φ/2] for ΔQ": left(hamilton(_stack(exact(1), phi / 2), computed)),
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
    turning = [(0, 0, -10)] * 3  # deg/s
    sums = [sp.Rational(sum(sample[i] for sample in turning), 3) for i in range(3)]
    return (
        f"with N = 100 the printed set has {half} samples at n = 50, so that T_w is halved, {none} from n = 100 on: "
        "both statistics are 0 and the platform is at rest for ever; without a norm a turn of -10 deg/s about one axis "
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
    "32": _window,
}
