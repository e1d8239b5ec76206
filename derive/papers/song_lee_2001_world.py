"""Numbers for every letter of Song and Lee 2001 at a point, by finite rotations: the witness of its ledger."""

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from functools import lru_cache
from math import pi
from random import Random
from unicodedata import normalize

import mpmath as mp

from boresight.derive.equation import Relation
from boresight.derive.witness import (
    angles,
    attitude,
    finite_rotation,
    quaternion,
    rate,
    rotation_vector,
    skew,
    solve,
    uniform,
)


@dataclass(frozen=True)
class Base:
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

    def scaled(self, scale, parts=()) -> "Conditions":
        """The named errors, or all of them and the misalignment, times `scale`; attitudes and rates as they are."""
        parts = parts or ("euler_error", "master_error", "mu", "mu_error", "gyro_error")
        return replace(self, **{part: getattr(self, part) * scale for part in parts})


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
CONDITIONS_TEXT = "attitudes and misalignments to 3 deg an axis, gyro error 1 deg/h, master noise 1 arcmin"

# The point at which an erratum's numbers are given.
STATED = Base(
    euler_r=tuple(mp.mpf(x) * mp.pi / 180 for x in (10, 20, 30)),
    euler_error=tuple(mp.mpf(x) * mp.pi / 180 for x in ("0.1", "-0.2", "0.3")),
    master_error=(mp.mpf(0),) * 3,
    mu=tuple(mp.mpf(x) * mp.pi / 180 for x in ("0.3", "-0.1", "0.2")),
    mu_error=tuple(mp.mpf(x) * mp.pi / 180 for x in ("-0.1", "0.2", "0.15")),
    gyro_error=(mp.mpf(0),) * 3,
    omega_ib_b=(mp.mpf(0),) * 3,
    omega_in_n=(mp.mpf(0),) * 3,
)
STATED_TEXT = (
    "master at roll, pitch, yaw 10, 20, 30 deg; slave's angle errors 0.1, -0.2, 0.3 deg; "
    "misalignment 0.3, -0.1, 0.2 deg, its error -0.1, 0.2, 0.15 deg"
)


def draw(seed: int, conditions: Conditions) -> Base:
    """A point of the conditions; the same seed at another scale gives the same directions."""
    generator = Random(seed)
    return Base(**{part.name: tuple(uniform(generator, getattr(conditions, part.name))) for part in fields(conditions)})


def world(base: Base, definitions: Mapping[str, tuple[Relation, ...]]) -> dict:
    """Values of every letter of the paper at one point, by finite rotations.

    definitions: the relations of the equations which define a letter, by number; the witness takes them as given.
    Raises ValueError, KeyError or ZeroDivisionError where a definition does not define.
    """
    values = dict(_attitudes(base, tuple(definitions[number] for number in ("1", "2", "3"))))
    for number, unknown in (("14", {"Δφ": 1, "Δθ": 1, "Δψ": 1}), ("16", {"Z": 3}), ("22", {"X": 6})):
        values |= solve(definitions[number], unknown, values)
    values |= {f"X_{i + 1}": values["X"][i] for i in range(6)}
    values |= {f"Z_{word}": values["Z"][i] for i, word in enumerate(("roll", "pitch", "yaw"))}
    return values


@lru_cache(maxsize=512)
def _attitudes(base: Base, definitions: tuple[tuple[Relation, ...], ...]) -> dict:
    values: dict = {}

    def put(names: str, vector) -> None:
        values.update(zip(normalize("NFC", names).split(), vector, strict=True))

    # The master, and the slave turned from it by mu.  Section II speaks of the slave.
    mu, mu_hat = mp.matrix(base.mu), mp.matrix(base.mu) + mp.matrix(base.mu_error)
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
        "C_b2b": mp.eye(3),
        "I": mp.eye(3),
        "E": skew(eps),
        "B": skew(beta),
        "Ω_in_n": skew(base.omega_in_n),
        "Ĉ": lambda *euler: attitude(euler),
        "ΔC": _first_order_change,
        "ε": eps,
        "β": beta,
        "ε_o": mp.norm(eps),
        "δω_b": mp.matrix(base.gyro_error),
    }
    put("ε_n ε_e ε_d", eps)
    put("β_x β_y β_z", beta)
    put("μ_x μ_y μ_z", mu)
    put("μ̂_x μ̂_y μ̂_z", mu_hat)
    put("δμ_x δμ_y δμ_z", base.mu_error)
    put("Δφ̂ Δθ̂ Δψ̂", angles(C_r * finite_rotation(mu_hat)) - mp.matrix(base.euler_r))

    # (20), (21)  rates, along the exact motion of n and b; the mounting is rigid.
    omega_in_n, omega_ib_b = mp.matrix(base.omega_in_n), mp.matrix(base.omega_ib_b)

    def moved(matrix, body_rate, t):
        return finite_rotation(-omega_in_n * t) * matrix * finite_rotation(body_rate * t)

    def eps_at(t):
        return -rotation_vector(moved(C_hat, omega_ib_b + values["δω_b"], t) * moved(C, omega_ib_b, t).T)

    def mu_error_at(t):
        master_rate = finite_rotation(mu) * omega_ib_b
        return mu_hat - rotation_vector(moved(C_r, master_rate, t).T * moved(C, omega_ib_b, t))

    values |= {"ε̇": rate(eps_at), normalize("NFC", "δμ̇"): rate(mu_error_at)}

    # (23) to (25)  a correction by the error itself ends at the truth.
    before, after = quaternion(C_hat), quaternion(C)
    after = after if (before.T * after)[0] > 0 else -after  # q and -q are one attitude
    turn = quaternion(C * C_hat.T)
    values |= {"ΔQ": turn, "ΔQ(k)": turn, "Q̂(k-)": before, "Q̂(k+)": after}
    put("Δq_0 Δq_1 Δq_2 Δq_3", turn)
    values |= {"μ(k+)": mu, "μ(k-)": mu, "μ̂(k-)": mu_hat, "μ̂(k+)": mu, "δμ(k)": mp.matrix(base.mu_error)}
    return values


def _first_order_change(phi, theta, psi, *errors) -> mp.matrix:
    """d C_b2n(angles + t errors) / dt at t = 0."""
    return rate(lambda t: attitude([a + t * e for a, e in zip((phi, theta, psi), errors, strict=True)]))
