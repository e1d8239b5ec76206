"""Numbers for every letter of strapdown navigation and its errors: the witness of our own derivations.

A navigator and the truth are carried by Newton's law on the turning ellipsoid, errors are finite rotations, and every
matrix is a Jacobian of exact rates by differences.  No function of derive/mechanics makes a number here.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache, partial
from random import Random
from typing import Any

from boresight.derive.ledger import ellipsoid, navigation
from boresight.derive.ledger.ellipsoid import ENU, NED, SPIN, WORKING, Level
from boresight.derive.ledger.equation import Relation
from boresight.derive.ledger.free import of, rotation
from boresight.derive.ledger.navigation import Navigator, Truth, stack
from boresight.derive.ledger.numbers import Matrix, cos, digits, eye, zeros
from boresight.derive.ledger.paper import Stated, Witness
from boresight.derive.ledger.witness import (
    Letters,
    angles,
    attitude,
    finite_rotation,
    quaternion,
    rotation_vector,
    skew,
    vector,
)

DEGREE = math.pi / 180


@dataclass(frozen=True, eq=False)
class Base:  # a key of the caches by itself: `draw` gives the same one for the same seed
    """What a point is made of; all else follows.  SI and rad; three components each, north east down or body axes."""

    position: tuple  # latitude, longitude, height
    v_n: tuple
    euler: tuple
    f_b: tuple
    omega_ib_b: tuple
    position_error: tuple
    velocity_error: tuple
    phi: tuple
    gyro_error: tuple
    accel_error: tuple
    mounting: tuple
    mu: tuple
    lever: tuple
    acceleration: tuple
    step: tuple  # the first component alone


@dataclass(frozen=True)
class Conditions:
    """The largest size of each part of a Base."""

    position: tuple = (1.2, 3.0, 3000.0)
    v_n: tuple = (300.0, 300.0, 30.0)
    euler: tuple = (2.5, 1.2, 2.5)
    f_b: float = 12.0
    omega_ib_b: float = 1.0
    position_error: tuple = (0.05, 0.05, 500.0)
    velocity_error: float = 2.0
    phi: float = 0.05
    gyro_error: float = 0.02
    accel_error: float = 0.5
    mounting: float = 1.0
    mu: float = 0.4
    lever: float = 5.0
    acceleration: float = 5.0
    step: float = 0.3


ERRORS = ("position_error", "velocity_error", "phi", "gyro_error", "accel_error")
# A ship or a car: errors of 1 nmi, 1 m/s, 5 mrad, of sensors 1 deg/h and 1 mg.
CONDITIONS = Conditions(
    position=(45 * DEGREE, 3.0, 100.0),
    v_n=(20.0, 20.0, 1.0),
    euler=(5 * DEGREE, 5 * DEGREE, 2.5),
    f_b=10.0,
    omega_ib_b=5 * DEGREE,
    position_error=(1852 / 6.4e6, 1852 / 6.4e6, 10.0),
    velocity_error=1.0,
    phi=5e-3,
    gyro_error=DEGREE / 3600,
    accel_error=1e-2,
    mounting=5 * DEGREE,
    mu=3 * DEGREE,
    lever=3.0,
    acceleration=1.0,
    step=0.01,
)
CONDITIONS_TEXT = "20 m/s, errors to 1 nmi, 1 m/s, 5 mrad, 1 deg/h and 1 mg per axis, steps of 10 ms"

TO_ENU = Matrix([[0, 1, 0], [1, 0, 0], [0, 0, -1]])  # of components; of coordinates the third stays
SWAPPED = Matrix([[0, 1, 0], [1, 0, 0], [0, 0, 1]])


def values(base: Base, definitions: Mapping[str, tuple[Relation, ...]]) -> Letters:
    """Values of every letter at one point; no equation is a definition that it needs."""
    return _world(base)


def truth(base: Base, level: Level) -> Truth:
    """The true navigator, in either level."""
    C, v, p = attitude(base.euler), Matrix(base.v_n), Matrix(base.position)
    if level is ENU:
        C, v, p = TO_ENU * C, TO_ENU * v, SWAPPED * p
    return navigation.truth(p, v, C, base.f_b, base.omega_ib_b, level)


@lru_cache(maxsize=64)
def _world(base: Base) -> Letters:
    with digits(WORKING):
        found = {**_rates(base), **_earth(base), **_partials(base), **_alignment(base), **_transition(base)}
        found |= {"I": eye(3), "I_9": eye(9), "0_3": zeros(3), "[J]": turned_frame()}
        found |= {f"e_{k + 1}": eye(9)[:, k] for k in range(9)}
    later = tuple((names, partial(_made, make)) for names, make in found.items() if callable(make))
    return Letters(later, {name: value for name, value in found.items() if not callable(value)})


def _made(make: Callable[[], Any], letters: Letters) -> list:
    """A letter, or several, that take time: made when they are asked for."""
    with digits(WORKING):
        found = make()
    return found if isinstance(found, list) else [found]


def turned_frame() -> Matrix:
    """9x9, states in NED to those in ENU."""
    J = zeros(9)
    J[0:3, 0:3], J[3:6, 3:6], J[6:9, 6:9] = SWAPPED, TO_ENU, TO_ENU
    return J


def _rates(base: Base) -> dict:
    """The true navigator and the erring one, and their errors against the true and against the computed level."""
    true = truth(base, NED)
    exact = true.exact
    x = stack(base.position_error, base.velocity_error, base.phi, zeros(6, 1))
    noise = stack(base.gyro_error, base.accel_error)
    hat, phi_rates = true.hat(x, noise), true.phi_rates(x, noise)
    # the same navigator against the level of its position
    C_n2c = true.computed_level(x[0:3, 0])
    C_n2c_rate = hat.axes_rate.T * exact.axes + hat.axes.T * exact.axes_rate
    C_b2c, C_b2c_rate = C_n2c * true.C, C_n2c_rate * true.C + C_n2c * exact.C_rate
    E, E_rate = hat.C_b2n * true.C.T, hat.C_rate * true.C.T + hat.C_b2n * exact.C_rate.T
    psi_rate = navigation.rotation_rate(hat.C_b2n * C_b2c.T, hat.C_rate * C_b2c.T + hat.C_b2n * C_b2c_rate.T)
    return {
        "p": true.position, "ṗ": exact.position_rate, "p̂": true.position + x[0:3, 0], "ṗ̂": hat.position_rate,
        "δp": x[0:3, 0], "δṗ": phi_rates[0:3, 0],
        "v": true.v_n, "v̇": exact.velocity_rate, "v̂": hat.v_n, "v̂̇": hat.velocity_rate,
        "δv": x[3:6, 0], "δv̇": phi_rates[3:6, 0],
        "C": true.C, "Ċ": exact.C_rate, "Ĉ": hat.C_b2n, "Ĉ̇": hat.C_rate, "E": E, "Ė": E_rate,
        "φ": x[6:9, 0], "φ̇": phi_rates[6:9, 0],
        "f_b": true.f_b, "f": exact.f_n, "f̂": hat.f_n, "δf": Matrix(base.accel_error),
        "ω_ib": true.omega, "ω̂_ib": true.omega + Matrix(base.gyro_error), "δω": Matrix(base.gyro_error),
        "g": exact.gravity_n, "ĝ": hat.gravity_n, "δg": hat.gravity_n - exact.gravity_n,
        "ω_ie": exact.omega_ie_n, "ω̂_ie": hat.omega_ie_n, "δω_ie": hat.omega_ie_n - exact.omega_ie_n,
        "ω_en": exact.omega_en_n, "ω̂_en": hat.omega_en_n, "δω_en": hat.omega_en_n - exact.omega_en_n,
        "ω_in": exact.omega_in_n, "ω̂_in": hat.omega_in_n, "δω_in": hat.omega_in_n - exact.omega_in_n,
        "C_n2e": exact.axes, "Ċ_n2e": exact.axes_rate, "ṙ_e": exact.axes * true.v_n,
        "r̈_e": exact.axes_rate * true.v_n + exact.axes * exact.velocity_rate,
        "ω_ie_e": vector(0, 0, SPIN), "g_e": exact.axes * exact.gravity_n, "f_e": exact.axes * exact.f_n,
        "D": _D(true.position, NED),
        "q": quaternion(true.C), "q̇": ellipsoid.rate(lambda t: quaternion(true.C + t * exact.C_rate)),
        "C_n2c": C_n2c, "δθ": -rotation_vector(C_n2c), "δθ̇": navigation.rotation_rate(C_n2c, C_n2c_rate),
        "ψ": -rotation_vector(hat.C_b2n * C_b2c.T), "ψ̇": psi_rate,
        "δv_c": hat.v_n - C_n2c * true.v_n,
        "δv̇_c": hat.velocity_rate - C_n2c_rate * true.v_n - C_n2c * exact.velocity_rate,
        "δg_c": hat.gravity_n - C_n2c * exact.gravity_n,
    }  # fmt: skip


def _D(position, level: Level) -> Matrix:
    """Rates of the coordinates by velocity."""
    return level.slope(position).solve(level.axes(position))


def _earth(base: Base) -> dict:
    """Scalars of the place: radii by how far the ground is moved along, gravity, and how they change."""
    lat, lon, height = base.position
    north, east, down = base.v_n
    force = list(attitude(base.euler) * Matrix(base.f_b))

    def radii(change) -> Matrix:
        slope = ellipsoid.axes((0, lat + change, 0)).T * ellipsoid.slope(vector(0, lat + change, 0))
        return vector(slope[1, 1], slope[0, 0] / cos(lat + change))

    (R_N, R_E), (R_NN, R_EE) = radii(0), ellipsoid.rate(radii)
    return {
        "L": lat, "λ": lon, "h": height, "v_N": north, "v_E": east, "v_U": -down,
        "f_N": force[0], "f_E": force[1], "f_U": -force[2], "Ω": SPIN,
        "R_N": R_N, "R_E": R_E, "R_NN": R_NN, "R_EE": R_EE, "γ": ellipsoid.gravity(lat, height),
        "γ_L": ellipsoid.rate(lambda t: ellipsoid.gravity(lat + t, height)),
        "γ_h": ellipsoid.rate(lambda t: ellipsoid.gravity(lat, height + t)),
    }  # fmt: skip


def _partials(base: Base) -> dict:
    """F, G and T of both models in both levels, and what they are made of, by differences of exact rates."""
    result: dict[str, Any] = {}
    for level in (NED, ENU):
        true = truth(base, level)

        def mapped(x, true=true) -> Matrix:
            """Errors against the computed level, of the errors against the true one."""
            C_n2c = true.computed_level(x[0:3, 0])
            return stack(
                x[0:3, 0],
                true.v_n + x[3:6, 0] - C_n2c * true.v_n,
                -rotation_vector(finite_rotation(-x[6:9, 0]) * C_n2c.T),
            )

        result[f"F_φ {level.name}"] = _by(lambda x, t=true: t.phi_rates(stack(x, zeros(6, 1)))[0:9, 0], 9)
        result[f"F_ψ {level.name}"] = _by(true.psi_rates, 9)
        result[f"G {level.name}"] = _by(lambda e, t=true: t.phi_rates(zeros(15, 1), e)[0:9, 0], 6)
        result[f"T {level.name}"] = _by(mapped, 9)
        if level is ENU:
            result |= {"p ENU": true.position, "v ENU": true.v_n, "f ENU": true.exact.f_n, "C ENU": true.C,
                       "q ENU": quaternion(true.C)}  # fmt: skip
            continue

        def at(p, v, true=true) -> Navigator:
            return Navigator(true.position + p, true.v_n + v, true.C, true.f_b, true.omega, NED)

        result |= {
            "P_p": _by(lambda p, at=at: at(p, zeros(3, 1)).position_rate, 3),
            "Ω_p": _by(lambda p, at=at: at(p, zeros(3, 1)).omega_ie_n, 3),
            "W_p": _by(lambda p, at=at: at(p, zeros(3, 1)).omega_en_n, 3),
            "W_v": _by(lambda v, at=at: at(zeros(3, 1), v).omega_en_n, 3),
            "G_p": _by(lambda p, at=at: at(p, zeros(3, 1)).gravity_n, 3),
            "Θ": _by(lambda p, true=true: -rotation_vector(true.computed_level(p)), 3),
        }

        def T_after(t, true=true) -> Matrix:
            moved = Truth(true.position + t * true.exact.position_rate, true.v_n + t * true.exact.velocity_rate,
                          true.C, true.f_b, true.omega, true.exact, NED)  # fmt: skip
            here = NED.axes(moved.position)
            result = eye(9)
            turn = ellipsoid.jacobian(lambda p: -rotation_vector(NED.axes(moved.position + p).T * here), 3)
            result[3:6, 0:3], result[6:9, 0:3] = -skew(moved.v_n) * turn, -turn
            return result

        result["Ṫ NED"] = partial(_rate, T_after)
    return result


def _rate(function: Callable) -> Matrix:
    step = ellipsoid.exact("1e-12")
    return (function(step) - function(-step)) / (2 * step)


def _by(function: Callable, size: int) -> Callable[[], Matrix]:
    """The derivative by so many errors, when it is asked for."""
    return lambda: ellipsoid.jacobian(function, size)


def _alignment(base: Base) -> dict:
    """Sixteen states of a slave on a lever arm: phi, velocity, biases, mounting, delay; the letters of the slave are
    what it computes, and the master reports what it expects."""
    true = truth(base, NED)
    C, omega, L, a = true.C, true.omega, Matrix(base.lever), Matrix(base.acceleration)
    omega_in, C_b2m = true.exact.omega_in_n, finite_rotation(base.mounting)
    C_m2n = C * C_b2m.T

    def rates(x) -> Matrix:
        """x: phi, velocity error, what the biases' estimates have too much."""
        found = true.phi_rates(stack(zeros(3, 1), x[3:6, 0], x[0:3, 0], -x[6:12, 0]))
        return stack(found[6:9, 0], found[3:6, 0], zeros(10, 1))

    def expected(x) -> tuple[Matrix, Matrix]:
        """Velocity and attitude of the master once x is taken out, and moved back by the delay's error."""
        C_true, rate = finite_rotation(x[0:3, 0]) * C, omega + x[6:9, 0]
        v = true.v_n - x[3:6, 0] + skew(omega_in) * C_true * L - C_true * skew(rate) * L + a * x[15]
        mount = finite_rotation(x[12:15, 0]) * C_b2m
        turn = (C_true * rate - omega_in) * x[15]
        return v, finite_rotation(turn) * C_true * mount.T

    def z_v(x) -> Matrix:
        return expected(zeros(16, 1))[0] - expected(x)[0]

    def z_a(x) -> Matrix:
        return -rotation_vector(expected(x)[1] * C_m2n.T)

    euler_m = angles(C * finite_rotation(-Matrix(base.mu)))

    def z_e(x) -> Matrix:
        """x: eps, error of the misalignment."""
        C_true = finite_rotation(x[0:3, 0]) * C * finite_rotation(x[3:6, 0] - Matrix(base.mu))
        return euler_m - angles(C_true)

    return {
        "F_16": _by(rates, 16), "H_v": _by(z_v, 16), "H_a": _by(z_a, 16), "H_e": _by(z_e, 6),
        "r": C * L, "u": C * skew(omega) * L, "lever": L, "a": a, "C_m2n": C_m2n, "C_b2m": C_b2m,
        "ω_nb": C * omega - omega_in, "μ": Matrix(base.mu),
        "J": _mean_turn(base.mu),
        "q_b2m": quaternion(C_b2m), "φ_b": base.euler[0], "θ_b": base.euler[1], "ψ_b": base.euler[2],
        "φ_m": euler_m[0], "θ_m": euler_m[1], "ψ_m": euler_m[2],
    }  # fmt: skip


def _mean_turn(mu) -> Matrix:
    """The mean of exp(-s [mu x]) for s from 0 to 1: its series."""
    A = -skew(Matrix(mu))
    term, result, k = eye(3), eye(3), 1
    while max(map(abs, term)) > 1e-100:
        k += 1
        term = term * A / k
        result += term
    return result


def _transition(base: Base) -> dict:
    """Phi and Q of the phi model by the matrix exponential; Q by van Loan's."""
    dt = base.step[0]

    def grown() -> list[Matrix]:
        true = truth(base, NED)
        F = ellipsoid.jacobian(lambda x: true.phi_rates(stack(x, zeros(6, 1)))[0:9, 0], 9)
        generator = Random(5)
        root = Matrix([[generator.uniform(-1, 1) for _ in range(9)] for _ in range(9)])
        S = root * root.T
        block = zeros(18)
        block[0:9, 0:9], block[0:9, 9:18], block[9:18, 9:18] = -F, S, F.T
        grown = (block * dt).exp()
        Phi = grown[9:18, 9:18].T
        return [(F * dt).exp(), Phi * grown[0:9, 9:18], S, F]

    return {"Φ|Q|S|F": grown, "Δt": dt}


# What letters are by their nature.
STRUCTURE = {
    **dict.fromkeys(("C", "Ĉ", "C_n2c", "C_n2e", "C_m2n", "C_b2m", "E"), rotation),
    "I": lambda generator: eye(3),
    "0_3": lambda generator: zeros(3),
    "I_9": lambda generator: eye(9),
    **{f"e_{k}": lambda generator, k=k: eye(9)[:, k - 1] for k in range(1, 10)},
    "ω_in": of("ω_ie|ω_en", lambda a, b: a + b),
    "δω_in": of("δω_ie|δω_en", lambda a, b: a + b),
}

WITNESS = Witness(Base, values, Conditions(), ERRORS, "exact rates and finite rotations")
SIZES = Stated(CONDITIONS, CONDITIONS_TEXT, 4)
POINT = Stated(CONDITIONS, CONDITIONS_TEXT)
