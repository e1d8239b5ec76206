"""A hull that swings, exactly; what a filter that does not know the delay makes of it, by least squares of samples.

The attitude is three finite rotations, and the master's data that of an earlier time.  The filter weighs all over a
period; its least squares are solved as numbers, and none of the formulas that are derived makes them.
"""

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass
from functools import cache
from typing import Any

from boresight.derive.ledger import ellipsoid
from boresight.derive.ledger.equation import Relation
from boresight.derive.ledger.free import of, rotation
from boresight.derive.ledger.numbers import Matrix, cos, digits, exact, eye, pi, sin, sqrt, zeros
from boresight.derive.ledger.paper import Stated, Witness
from boresight.derive.ledger.witness import angles, attitude, degrees, finite_rotation, rotation_vector, uniform, vector

WORKING = 120  # digits: least squares of angles of 1e-7 rad lose 28
SAMPLES = 8  # of a period: the mean of what has no fifth harmonic is exact


@dataclass(frozen=True, eq=False)
class Base:
    """What a point is made of; SI and rad; three components each."""

    swing: tuple  # amplitudes of roll, pitch, yaw
    phase: tuple
    wave: tuple  # frequency in rad/s, time, heading
    surge: tuple  # amplitudes of the velocity, north and east
    surge_phase: tuple
    phi: tuple
    dmu: tuple
    delay: tuple  # the first component alone
    noise: tuple  # of an angle, and of a velocity


@dataclass(frozen=True)
class Conditions:
    """The largest size of each part of a Base."""

    swing: float = 0.2
    phase: float = 3.0
    wave: tuple = (1.5, 10.0, 3.0)
    surge: float = 2.0
    surge_phase: float = 3.0
    phi: float = 0.1
    dmu: float = 0.1
    delay: float = 0.1
    noise: tuple = (0.5, 2.0, 1.0)


ERRORS = ("swing", "surge", "phi", "dmu", "delay")
PARTS = {
    "swing": "the swing",
    "surge": "the hull's velocity",
    "delay": "the delay",
    "phi": "the attitude error",
    "dmu": "the misalignment error",
}
(ROLL,) = degrees(5)
CONDITIONS = Conditions(
    swing=float(ROLL), wave=(0.7, 60.0, 3.0), surge=2.0, phi=float(ROLL) / 2.5, dmu=float(ROLL) / 2.5, delay=0.01
)
CONDITIONS_TEXT = "a hull that rolls, pitches and yaws by 5 deg at 0.7 rad/s, errors to 2 deg, delay 10 ms"


class Hull:
    """Roll, pitch and yaw of one frequency; with `second`, of its double as well.  Heading apart."""

    def __init__(self, base: Base, second: bool):
        self.omega, _, self.heading = base.wave
        self.waves = [(base.swing if second else (*base.swing[:2], exact(0)), base.phase, 1)]
        if second:
            self.waves.append((tuple(a / 2 for a in base.swing[::-1]), base.phase[::-1], 2))
        self.surges = ((*base.surge[:2], exact(0)), base.surge_phase)

    def euler(self, t) -> Matrix:
        return self._moved(t, sin)

    def rate(self, t) -> Matrix:
        return self._moved(t, cos, 1)

    def _moved(self, t, function, power: int = 0) -> Matrix:
        return vector(*(
            sum(a[i] * (n * self.omega) ** power * function(n * self.omega * t + b[i]) for a, b, n in self.waves)
            for i in range(3)
        ))  # fmt: skip

    def about_heading(self, t) -> Matrix:
        return attitude(tuple(self.euler(t)))

    def attitude(self, t) -> Matrix:
        return finite_rotation([0, 0, self.heading]) * self.about_heading(t)

    def velocity(self, t) -> Matrix:
        size, phase = self.surges
        return vector(*(size[i] * sin(self.omega * t + phase[i]) for i in range(3)))

    def acceleration(self, t) -> Matrix:
        size, phase = self.surges
        return vector(*(size[i] * self.omega * cos(self.omega * t + phase[i]) for i in range(3)))

    def only(self, wave) -> "Hull":
        """The same with one of its waves."""
        one = copy(self)
        one.waves = [wave]
        return one

    def times(self) -> list:
        period = 2 * pi() / self.omega
        return [period * exact(k) / SAMPLES for k in range(SAMPLES)]


def least_squares(hull: Hull, delay, weights: Sequence) -> tuple[Matrix, Matrix]:
    """phi and dmu with which the filter explains best that the master's attitude is old: its z = -phi + C dmu.

    weights: of an angle and, if the velocity is matched, of a velocity, whose error is v x phi about the vertical.
    """
    normal, right = zeros(6, 6), zeros(6, 1)
    for t in hull.times():
        C = hull.attitude(t)
        seen = Matrix([[*(-eye(3))[i, :], *C[i, :]] for i in range(3)])
        rows = [(seen, rotation_vector(C * hull.attitude(t - delay).T))]
        if len(weights) > 1:
            v = hull.velocity(t)
            turned = Matrix([[0, 0, v[1], 0, 0, 0], [0, 0, -v[0], 0, 0, 0]])
            rows.append((turned, (v - hull.velocity(t - delay))[0:2, 0]))
        for weight, (A, z) in zip(weights, rows, strict=True):
            normal, right = normal + A.T * A * weight, right - A.T * z * weight
    x = normal.solve(right)
    return x[0:3, 0], x[3:6, 0]


def values(base: Base, definitions: Mapping[str, tuple[Relation, ...]]) -> Mapping[str, Any]:
    return _world(base)


@cache
def _world(base: Base) -> dict:
    with digits(WORKING):
        omega, t, heading = base.wave
        delay, (sigma_a, sigma_v, _) = base.delay[0], base.noise
        phi, dmu = Matrix(base.phi), Matrix(base.dmu)
        hull, plain = Hull(base, True), Hull(base, False)
        C, C_e = hull.attitude(t), hull.about_heading(t)
        C_late = hull.attitude(t - delay)
        C_e_rate = ellipsoid.rate(lambda s: hull.about_heading(t + s))
        turning = C_e_rate * C_e.T
        omega_e = vector(turning[2, 1], turning[0, 2], turning[1, 0])
        C_psi = finite_rotation([0, 0, heading])
        phi_hat, dmu_hat = least_squares(hull, delay, [1])
        phi_plain, dmu_plain = least_squares(plain, delay, [1])
        _, dmu_both = least_squares(plain, delay, [sigma_a**-2, sigma_v**-2])
        e, e_rate, e_0, e_0_rate = hull.euler(t), hull.rate(t), plain.euler(t), plain.rate(t)
        v, a = plain.velocity(t), plain.acceleration(t)
        level = vector(0, 0, phi[2])
        (R, P, _), (alpha, beta, _) = base.swing, base.phase
        return {
            "z": rotation_vector(finite_rotation(-phi) * C * finite_rotation(dmu) * C_late.T),
            "φ": phi,
            "δμ": dmu,
            "τ": delay,
            "0": zeros(9, 1),
            "I": eye(3),
            "C": C,
            "C_ψ": C_psi,
            "C_e": C_e,
            "Ċ_e": C_e_rate,
            "ω": C_psi * omega_e,
            "ω_e": omega_e,
            "e": e,
            "ė": e_rate,
            "r": e[0], "p": e[1], "s": e[2],
            "φ̂": phi_hat,
            "μ̂": dmu_hat,
            "e_0": e_0,
            "ė_0": e_0_rate,
            "r_0": e_0[0], "p_0": e_0[1], "ṙ_0": e_0_rate[0], "ṗ_0": e_0_rate[1],
            "μ̂_0": dmu_plain,
            "φ̂_0": phi_plain,
            "φ̂_d": phi_plain[2],
            "μ̂_x": dmu_plain[0], "μ̂_y": dmu_plain[1], "μ̂_z": dmu_plain[2],
            "d": Matrix(base.phase),
            "δψ": angles(finite_rotation(-phi_plain) * C_psi)[2] - heading,
            "R": R, "P": P, "Ω": omega, "ε": beta - alpha,
            "q_s": sin(omega * t + alpha), "q_c": cos(omega * t + alpha),
            "q̇_s": ellipsoid.rate(lambda s: sin(omega * (t + s) + alpha)),
            "q̇_c": ellipsoid.rate(lambda s: cos(omega * (t + s) + alpha)),
            "v": v,
            "a": a,
            "v_n": v[0], "v_e": v[1], "a_n": a[0], "a_e": a[1],
            "φ_d": phi[2],
            "δv": finite_rotation(-level) * v - v,
            "δv̇": finite_rotation(-level) * a - a,
            "z_v": finite_rotation(-level) * v - plain.velocity(t - delay),
            "v_old": plain.velocity(t - delay),
            "σ_a": sigma_a, "σ_v": sigma_v,
            "μ̂_v": dmu_both[2],
            **_moments(hull, plain),
        }  # fmt: skip


MOVING = ("r_0", "p_0", "ṙ_0", "ṗ_0", "v_n", "v_e", "a_n", "a_e")


def _moments(hull: Hull, plain: Hull) -> dict[str, Any]:
    """The random letters: over a period their means are zero; each wave, a quarter of its own period apart, divided by
    the root of 2, is a root of their second moments."""
    share = 1 / sqrt(exact(2))

    def columns(of: Hull, parts: Callable) -> list[tuple]:
        quarter = pi() / (2 * of.omega)
        return [
            tuple(part * share for part in parts(one, t))
            for one, n in ((of.only(wave), wave[2]) for wave in of.waves)
            for t in (exact(0), quarter / n)
        ]

    def plane(one: Hull, t) -> tuple:
        e, e_rate, v, a = one.euler(t), one.rate(t), one.velocity(t), one.acceleration(t)
        return (*e[0:2, 0], *e_rate[0:2, 0], *v[0:2, 0], *a[0:2, 0], e, e_rate, v, a)

    zero, none = exact(0), zeros(3, 1)
    vectors = ("e_0", "ė_0", "v", "a")
    return {
        "random": {
            ("e", "ė"): columns(hull, lambda one, t: (one.euler(t), one.rate(t))),
            (*MOVING, *vectors): columns(plain, plane),
            ("q_s", "q_c"): [(share, zero), (zero, share)],
        },
        "mean": {
            **dict.fromkeys(("e", "ė", *vectors), none),
            **dict.fromkeys((*MOVING, "q_s", "q_c"), zero),
        },
    }


# ---- What letters are by their nature --------------------------------------------------------------------------------


def _level(*two) -> Matrix:
    return vector(*two, 0)


def _random(generator) -> dict:
    """Second moments of any size: three columns each."""
    share = 1 / sqrt(exact(2))

    def columns(count: int, sized) -> list[tuple]:
        return [tuple(sized() for _ in range(count)) for _ in range(3)]

    return {
        ("e", "ė"): columns(2, lambda: vector(*uniform(generator, 1))),
        MOVING: columns(len(MOVING), lambda: uniform(generator, 1)[0]),
        ("q_s", "q_c"): [(share, exact(0)), (exact(0), share)],
    }


STRUCTURE = {
    **dict.fromkeys(("C_e",), rotation),
    "C_ψ": of("ψ", lambda psi: finite_rotation([0, 0, psi])),
    "I": lambda generator: eye(3),
    "0": lambda generator: zeros(9, 1),
    "e_0": of("r_0|p_0", _level),
    "ė_0": of("ṙ_0|ṗ_0", _level),
    "v": of("v_n|v_e", _level),
    "a": of("a_n|a_e", _level),
    "μ̂_0": of("μ̂_x|μ̂_y|μ̂_z", vector),
    "φ̂_0": of("μ̂_x|μ̂_y|φ̂_d", vector),
    "random": _random,
    "mean": lambda generator: {
        **dict.fromkeys(("e", "ė"), zeros(3, 1)),
        **dict.fromkeys((*MOVING, "q_s", "q_c"), exact(0)),
    },
}


WITNESS = Witness(Base, values, Conditions(), ERRORS, "finite rotations", PARTS)
SIZES = Stated(CONDITIONS, CONDITIONS_TEXT, 4)
POINT = Stated(CONDITIONS, CONDITIONS_TEXT)
