"""Numbers for every letter of Song and Lee 2001 at a point, by finite rotations: the witness of its ledger."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import pi
from typing import Any
from unicodedata import normalize

from boresight.derive.ledger.equation import Relation
from boresight.derive.ledger.evaluate import solve
from boresight.derive.ledger.free import of, rotation
from boresight.derive.ledger.numbers import Matrix, exact, eye, norm
from boresight.derive.ledger.paper import Stated, Witness
from boresight.derive.ledger.witness import (
    angles,
    attitude,
    degrees,
    finite_rotation,
    quaternion,
    rate,
    rotation_vector,
    skew,
    vector,
)


@dataclass(frozen=True, eq=False)
class Base:  # a key of the caches by itself: `draw` gives the same one for the same seed
    """What a point is made of; all else follows.  rad and rad/s; three components each."""

    euler_r: tuple
    euler_error: tuple
    master_error: tuple
    mu: tuple
    mu_error: tuple
    gyro_error: tuple
    omega_ib_b: tuple
    omega_in_n: tuple


@dataclass(frozen=True)
class Conditions:
    """The largest size of each part of a Base, rad and rad/s."""

    euler_r: tuple = (2.5, 1.2, 2.5)
    euler_error: float = 0.05
    master_error: float = 0.05
    mu: float = 0.05
    mu_error: float = 0.05
    gyro_error: float = 0.05
    omega_ib_b: float = 1.0
    omega_in_n: float = 1.0


ERRORS = ("euler_error", "master_error", "mu", "mu_error", "gyro_error")

PARTS = {
    "euler_error": "the slave's attitude error",
    "master_error": "the master's attitude error",
    "mu": "the misalignment",
    "mu_error": "the error of its estimate",
    "gyro_error": "the gyro error",
}
DEGREE = pi / 180
# The paper's simulation: motion and misalignment of 3 degrees on each axis, the slave's attitude taken from the master,
# master noise of 1 arcmin, gyros of 1 deg/h; Earth rate.
CONDITIONS = Conditions(
    euler_r=(3 * DEGREE, 3 * DEGREE, 2.5),
    euler_error=3 * DEGREE,
    master_error=DEGREE / 60,
    mu=3 * DEGREE,
    mu_error=3 * DEGREE,
    gyro_error=DEGREE / 3600,
    omega_ib_b=5 * DEGREE,
    omega_in_n=7.3e-5,
)
CONDITIONS_TEXT = "attitudes and misalignments to 3 deg per axis, gyro error 1 deg/h, master noise 1 arcmin"

# The point at which an erratum's numbers are given.
STATED = Base(
    euler_r=degrees(10, 20, 30),
    euler_error=degrees("0.1", "-0.2", "0.3"),
    master_error=(exact(0),) * 3,
    mu=degrees("0.3", "-0.1", "0.2"),
    mu_error=degrees("-0.1", "0.2", "0.15"),
    gyro_error=(exact(0),) * 3,
    omega_ib_b=(exact(0),) * 3,
    omega_in_n=(exact(0),) * 3,
)
STATED_TEXT = (
    "master at roll, pitch, yaw 10, 20, 30 deg; slave's angle errors 0.1, -0.2, 0.3 deg; "
    "misalignment 0.3, -0.1, 0.2 deg, its error -0.1, 0.2, 0.15 deg"
)


def values(base: Base, definitions: Mapping[str, tuple[Relation, ...]]) -> dict:
    """Values of every letter of the paper at one point, by finite rotations.

    definitions: the relations of the equations which define a letter, by number; the witness takes them as given.
    Raises ValueError, KeyError or ZeroDivisionError where a definition does not define.
    """
    found = dict(_attitudes(base, tuple(definitions[number] for number in ("1", "2", "3"))))
    for number, unknown in (
        ("14", {"Δφ": 1, "Δθ": 1, "Δψ": 1}),
        ("δμ", {"δμ_x": 1, "δμ_y": 1, "δμ_z": 1}),
        ("16", {"Z": 3}),
        ("22", {"X": 6}),
    ):
        found |= solve(definitions[number], unknown, found)
    found |= {f"X_{i + 1}": found["X"][i] for i in range(6)}
    found |= {f"Z_{word}": found["Z"][i] for i, word in enumerate(("roll", "pitch", "yaw"))}
    return found


@lru_cache(maxsize=512)
def _attitudes(base: Base, definitions: tuple[tuple[Relation, ...], ...]) -> dict:
    values: dict = {}

    def put(names: str, vector) -> None:
        values.update(zip(normalize("NFC", names).split(), vector, strict=True))

    # The master, and the slave turned from it by mu.  Section II speaks of the slave.
    mu, mu_hat = Matrix(base.mu), Matrix(base.mu) + Matrix(base.mu_error)
    C_r = attitude(base.euler_r)
    C = C_r * finite_rotation(mu)
    euler = angles(C)
    for names, angle, error in (
        ("φ_r θ_r ψ_r", base.euler_r, base.master_error),
        ("φ_b θ_b ψ_b", euler, base.euler_error),
        ("φ θ ψ", euler, base.euler_error),
    ):
        put(names, angle)
        put(" ".join("δ" + name for name in names.split()), error)
    # (1) to (3) give the computed angles, once for each owner.
    for script in ("", "_b", "_r"):
        plain = {f"{mark}{letter}": values[f"{mark}{letter}{script}"] for letter in "φθψ" for mark in ("", "δ")}
        for letter, definition in zip("φθψ", definitions, strict=True):
            found = solve(definition, {f"{letter}\u0302": 1}, values | plain)
            values[f"{letter}\u0302{script}"] = found[f"{letter}\u0302"]
    C_hat = attitude([values[f"{letter}\u0302"] for letter in "φθψ"])

    # Seen from n' the body stands where the computer has it: n' is n turned by eps.  Or the body is b', turned by beta.
    eps, beta = -rotation_vector(C_hat * C.T), rotation_vector(C.T * C_hat)
    n_axes, b_axes = finite_rotation(eps), finite_rotation(beta)  # columns: the axes of n' in n, of b' in b
    values |= {
        "C_b2n": C,
        "C_n2b": C.T,
        "Ĉ_b2n": C_hat,
        "C_n2n'": n_axes.T,
        "C_b2n'": n_axes.T * C,
        "C_b'2n": C * b_axes,
        "C_b'2b": b_axes,
        "C_b2b'": b_axes.T,
        "Ĉ_b2b'": b_axes.T,
        "C_b2b": eye(3),
        "I": eye(3),
        "E": skew(eps),
        "B": skew(beta),
        "Ω_in_n": skew(base.omega_in_n),
        "Ĉ": lambda *euler: attitude(euler),
        "ΔC": _first_order_change,
        "ε": eps,
        "β": beta,
        "ε_o": norm(eps),
        "δω_b": Matrix(base.gyro_error),
        "C_r2n": C_r,
        "C_n2r": C_r.T,
        "C_n'2n": n_axes,
        "ω_ib_b": Matrix(base.omega_ib_b),
        "ω_in_n": Matrix(base.omega_in_n),
        "μ": mu,
        "μ\u0302": mu_hat,
        "δμ": Matrix(base.mu_error),
        "A_1": _axes_before_roll,
        "A_3": _axes_after_yaw,
    }
    put("ω_n ω_e ω_d", base.omega_in_n)
    _, pitch, yaw = euler
    for i, letter in enumerate("φθψ"):
        values |= {
            f"∂C/∂{letter}": _change(i)(*euler),
            f"u_{letter}": _axis(i)(pitch, yaw),
            f"R_{i + 1}": _turns(i + 1),
        }
    put("ε_n ε_e ε_d", eps)
    put("β_x β_y β_z", beta)
    put("μ_x μ_y μ_z", mu)
    put("μ̂_x μ̂_y μ̂_z", mu_hat)
    put("Δφ̂ Δθ̂ Δψ̂", angles(C_r * finite_rotation(mu_hat)) - Matrix(base.euler_r))

    # (20), (21)  rates, along the exact motion of n and b; the mounting is rigid.
    omega_in_n, omega_ib_b = Matrix(base.omega_in_n), Matrix(base.omega_ib_b)

    def displaced(matrix, body_rate, t):
        return finite_rotation(-omega_in_n * t) * matrix * finite_rotation(body_rate * t)

    def C_at(t):
        return displaced(C, omega_ib_b, t)

    def C_hat_at(t):
        return displaced(C_hat, omega_ib_b + values["δω_b"], t)

    def mu_at(t):
        return rotation_vector(displaced(C_r, finite_rotation(mu) * omega_ib_b, t).T * C_at(t))

    eps_rate, mu_rate = rate(lambda t: -rotation_vector(C_hat_at(t) * C_at(t).T)), rate(mu_at)
    rates = {
        "C\u0307_b2n": rate(C_at),
        "C\u0302\u0307_b2n": rate(C_hat_at),
        "ε\u0307": eps_rate,
        "E\u0307": skew(eps_rate),
        "μ\u0307": mu_rate,
        "μ\u0302\u0307": mu_rate * 0,  # between corrections the filter keeps its estimate
        "δμ\u0307": rate(lambda t: mu_hat - mu_at(t)),
    }
    values |= {normalize("NFC", name): value for name, value in rates.items()}

    # (23), (24)  a correction by the error itself ends at the truth.
    before, after = quaternion(C_hat), quaternion(C)
    after = after if (before.T * after)[0] > 0 else -after  # q and -q are one attitude
    turn = quaternion(C * C_hat.T)
    values |= {"ΔQ": turn, "ΔQ(k)": turn, "Q̂(k-)": before, "Q̂(k+)": after}
    put("Δq_0 Δq_1 Δq_2 Δq_3", turn)
    put("q̂_0 q̂_1 q̂_2 q̂_3", before)
    # (25)  the true misalignment stands; the estimate is left with what of its error was not estimated.
    missed = [error * exact(share) for error, share in zip(base.mu_error, (0.1, -0.2, 0.3), strict=True)]
    values |= {
        "μ(k+)": mu,
        "μ(k-)": mu,
        "μ̂(k-)": mu_hat,
        "μ̂(k+)": mu + Matrix(missed),
        "δμ(k)": Matrix(base.mu_error) - Matrix(missed),
        "δμ(k-)": Matrix(base.mu_error),
        "δμ(k+)": Matrix(missed),
    }
    return values


def _first_order_change(phi, theta, psi, *errors) -> Matrix:
    """d C_b2n(angles + t errors) / dt at t = 0."""
    return rate(lambda t: attitude([a + t * e for a, e in zip((phi, theta, psi), errors, strict=True)]))


# ---- What letters are by their nature --------------------------------------------------------------------------------


def _turns(first: int):
    """The rotation by an angle about an axis, counted from 1."""
    return lambda angle: finite_rotation([angle if axis == first else 0 for axis in (1, 2, 3)])


def _change(which: int):
    """The derivative of C_b2n by one of its angles: roll 0, pitch 1, yaw 2."""
    return lambda *euler: rate(lambda t: attitude([a + (i == which) * t for i, a in enumerate(euler)]))


def _axes_after_yaw(pitch):
    axes = eye(3)
    axes[:, 0] = _turns(2)(pitch)[:, 0]
    return axes


def _axes_before_roll(pitch):
    axes = eye(3)
    axes[:, 2] = _turns(2)(pitch).T[:, 2]
    return axes


def _axis(which: int):
    """The axis about which an angle turns, in n: where the turns before it have taken the axis of the body."""

    def of_angles(pitch, yaw):
        before = (_turns(3)(yaw) * _turns(2)(pitch), _turns(3)(yaw), eye(3))[which]
        return before[:, which]

    return of_angles


def _transpose(C):
    return C.T


def _component(i: int):
    return lambda v: v[i]


def _structure() -> dict[str, Any]:
    rotations = ("C_b2n", "Ĉ_b2n", "C_n2n'", "C_b2n'", "C_b'2n", "C_b'2b", "C_r2n")
    rules: dict[str, Any] = dict.fromkeys(rotations, rotation)
    rules |= {"I": lambda generator: eye(3), "C_b2b": lambda generator: eye(3)}
    for name, inverse in (("C_n2b", "C_b2n"), ("C_n'2n", "C_n2n'"), ("C_n2r", "C_r2n"), ("C_b2b'", "C_b'2b")):
        rules[name] = of(inverse, _transpose)
    for name, parts in (("ε", "ε_n|ε_e|ε_d"), ("β", "β_x|β_y|β_z"), ("ω_in_n", "ω_n|ω_e|ω_d")):
        rules[name] = of(parts, vector)
    for name in ("μ", "μ\u0302", "δμ"):
        rules[name] = of("|".join(f"{name}_{axis}" for axis in "xyz"), vector)
    for name, of_vector in (("E", "ε"), ("B", "β"), ("Ω_in_n", "ω_in_n"), ("E\u0307", "ε\u0307")):
        rules[name] = of(of_vector, skew)
    for i, (angle, word) in enumerate((("φ", "roll"), ("θ", "pitch"), ("ψ", "yaw"))):
        rules[f"∂C/∂{angle}"] = of("φ|θ|ψ", _change(i))
        rules[f"u_{angle}"] = of("θ|ψ", _axis(i))
        rules[f"Z_{word}"] = of("Z", _component(i))
    rules["ε_o"] = of("ε", norm)
    rules |= {"ΔQ": of("C_n'2n", quaternion), "ΔQ(k)": of("E", lambda E: quaternion(E.exp()))}
    rules |= {"Q̂(k+)": of("C_b2n", quaternion), "Q̂(k-)": of("Ĉ_b2n", quaternion)}
    rules |= {f"Δq_{i}": of("ΔQ", _component(i)) for i in range(4)}
    rules |= {f"q\u0302_{i}": of("Q̂(k-)", _component(i)) for i in range(4)}
    rules |= {f"X_{i + 1}": of("X", _component(i)) for i in range(6)}
    return {normalize("NFC", name): rule for name, rule in rules.items()}


STRUCTURE = _structure()
WITNESS = Witness(Base, values, Conditions(), ERRORS, parts=PARTS)
SIZES = Stated(CONDITIONS, CONDITIONS_TEXT, 16)
POINT = Stated(STATED, STATED_TEXT)
