"""Numbers for every letter of Song and Lee 2001 at a point, by finite rotations: the witness of its ledger."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields, replace
from functools import cache, lru_cache
from itertools import product
from math import pi
from random import Random
from unicodedata import normalize

import sympy as sp

from boresight.derive.equation import Relation
from boresight.derive.numbers import Matrix, exact, eye, norm, shown
from boresight.derive.papers import song_lee_2001 as paper
from boresight.derive.papers.song_lee_2001_print import AXES, PROSE_FORMULA, TABLE_1, TABLE_1_COUNTS
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
CONDITIONS_TEXT = "attitudes and misalignments to 3 deg per axis, gyro error 1 deg/h, master noise 1 arcmin"

# The point at which an erratum's numbers are given.
STATED = Base(
    euler_r=tuple(exact(float(x) * pi / 180) for x in (10, 20, 30)),
    euler_error=tuple(exact(float(x) * pi / 180) for x in ("0.1", "-0.2", "0.3")),
    master_error=(exact(0),) * 3,
    mu=tuple(exact(float(x) * pi / 180) for x in ("0.3", "-0.1", "0.2")),
    mu_error=tuple(exact(float(x) * pi / 180) for x in ("-0.1", "0.2", "0.15")),
    gyro_error=(exact(0),) * 3,
    omega_ib_b=(exact(0),) * 3,
    omega_in_n=(exact(0),) * 3,
)
STATED_TEXT = (
    "master at roll, pitch, yaw 10, 20, 30 deg; slave's angle errors 0.1, -0.2, 0.3 deg; "
    "misalignment 0.3, -0.1, 0.2 deg, its error -0.1, 0.2, 0.15 deg"
)


@cache
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
    }
    put("ε_n ε_e ε_d", eps)
    put("β_x β_y β_z", beta)
    put("μ_x μ_y μ_z", mu)
    put("μ̂_x μ̂_y μ̂_z", mu_hat)
    put("δμ_x δμ_y δμ_z", base.mu_error)
    put("Δφ̂ Δθ̂ Δψ̂", angles(C_r * finite_rotation(mu_hat)) - Matrix(base.euler_r))

    # (20), (21)  rates, along the exact motion of n and b; the mounting is rigid.
    omega_in_n, omega_ib_b = Matrix(base.omega_in_n), Matrix(base.omega_ib_b)

    def moved(matrix, body_rate, t):
        return finite_rotation(-omega_in_n * t) * matrix * finite_rotation(body_rate * t)

    def eps_at(t):
        return -rotation_vector(moved(C_hat, omega_ib_b + values["δω_b"], t) * moved(C, omega_ib_b, t).T)

    def mu_error_at(t):
        master_rate = finite_rotation(mu) * omega_ib_b
        return mu_hat - rotation_vector(moved(C_r, master_rate, t).T * moved(C, omega_ib_b, t))

    values |= {"ε̇": rate(eps_at), normalize("NFC", "δμ̇"): rate(mu_error_at)}

    # (23), (24)  a correction by the error itself ends at the truth.
    before, after = quaternion(C_hat), quaternion(C)
    after = after if (before.T * after)[0] > 0 else -after  # q and -q are one attitude
    turn = quaternion(C * C_hat.T)
    values |= {"ΔQ": turn, "ΔQ(k)": turn, "Q̂(k-)": before, "Q̂(k+)": after}
    put("Δq_0 Δq_1 Δq_2 Δq_3", turn)
    # (25)  the true misalignment stands; the estimate is left with what of its error was not estimated.
    missed = [error * exact(share) for error, share in zip(base.mu_error, (0.1, -0.2, 0.3), strict=True)]
    values |= {
        "μ(k+)": mu,
        "μ(k-)": mu,
        "μ̂(k-)": mu_hat,
        "μ̂(k+)": mu + Matrix(missed),
        "δμ(k)": Matrix(base.mu_error) - Matrix(missed),
    }
    return values


def _first_order_change(phi, theta, psi, *errors) -> Matrix:
    """d C_b2n(angles + t errors) / dt at t = 0."""
    return rate(lambda t: attitude([a + t * e for a, e in zip((phi, theta, psi), errors, strict=True)]))


# ---- Sizes of what is dropped, and the text beside the equations -----------------------------------------------------


_IN_THE_LOOP = "; in the loop: boresight study euler-table --switch as-printed-26-28"


def evidence(number: str) -> str:
    """What the ledger says beyond the status: sizes of dropped terms at the paper's numbers; "" for most equations."""
    if number in ("15", "18"):
        return "; the dropped second-order term, largest over roll and a misalignment of 3 deg per axis: " + ", ".join(
            f"{_minutes(_largest_second_order(pitch))} at a pitch of {pitch} deg" for pitch in (0, 3, 30, 60, 80)
        )
    if number in ("26", "27", "28"):
        ours, theirs = (_minutes(error) for error in substitution(int(number) - 26))
        return (
            "; with the slave's angles for the master's missing ones, as the text under (28) has it, the error of the "
            f"computed difference goes from {ours} to {theirs} (master level, 3 deg per axis): about as large, of the "
            "other sign, and above the noise of 1 arcmin, where the text calls it negligible" + _IN_THE_LOOP
        )
    if number in ("8", "9"):
        return _IN_THE_LOOP
    if number == "25":
        return "; in the loop: boresight study euler-table --switch as-printed-25"
    if number == "20":
        rate = 500e-6 * 9.8 * 120 / 6.37e6 / DEGREE * 3600
        return (
            "; also dropped: the error of ω_in_n, from velocity and position; the paper's 500 ug give a velocity "
            f"error of 0.59 m/s in 120 s and so {rate:.2g} deg/h, against gyros of 1 deg/h"
        )
    if number == "23":
        return f"; at zero the print is 0/0; its limit [1, eps/2] is off by {_limit()} at 1e-12 rad"
    return ""


def findings() -> tuple[str, ...]:
    """What was computed about the text beside the equations."""
    values = world(STATED, {e.number: e.read() for e in paper.equations() if e.defines})
    E, C, C_n2n1 = values["E"], values["C_b2n"], values["C_n2n'"]
    gaps = (values["B"] + left * E * C for left in (C_n2n1, C.T))
    printed, derived = (max(sum(map(abs, gap[i, :])) for i in range(3)) for gap in gaps)
    cells = [cell for row in TABLE_1 for cell in row.split()]
    estimable = [cell.count("o") for cell in cells]
    counts = tuple(estimable.count(k) for k in (3, 2, 1, 0)), sum(cell[2] == "o" for cell in cells)
    by_rule = sum(
        a == b for cell, ruled in zip(cells, composed(), strict=True) for a, b in zip(cell, ruled, strict=True)
    )
    agree = "as" if counts == TABLE_1_COUNTS else "other than"
    return (
        f"Line {PROSE_FORMULA[0]}, B = -C_n2n' E C_b2n: off by {shown(printed, 3)} at the stated point; "
        f"-C_n2b E C_b2n {'holds' if derived < 1e-28 else 'does not either'}: the slip of (11), in its matrix form.",
        f"Table 1: {counts[0][0]}, {counts[0][1]}, {counts[0][2]}, {counts[0][3]} cells with three, two, one, none "
        f"estimable, d in {counts[1]}: {agree} the conclusion says; {by_rule} of 147 marks follow its own rule.",
        "Table 1's head reads ε_p for ε_e in four of seven columns, line 197 y motion for ψ: labels.",
        "Under (28) the modelling error of missing master angles is called negligible: see (26) to (28).",
    )


def composed() -> list[str]:
    """Table 1 by the paper's rule: matching one angle under the motion of another shows the error about the third axis;
    of sets of angles and motions, what any pair of them shows."""

    def cell(matched: str, moved: str) -> str:
        single = AXES[:3]
        shown = {
            ({0, 1, 2} - {single.index(m), single.index(n)}).pop()
            for m in matched.split()
            for n in moved.split()
            if m != n
        }
        return "".join("o" if axis in shown else "X" for axis in range(3))

    return [cell(matched, moved) for matched in AXES for moved in AXES]


def _minutes(angle: float) -> str:
    return f"{angle / DEGREE * 60:.3g} arcmin"


def _corners(size: float) -> Iterator[tuple[float, ...]]:
    return product((-size, size), repeat=3)


@cache
def _second_order() -> Callable:
    letters = sp.symbols("phi theta psi x y z")
    return sp.lambdify(letters, list(paper.relative_euler_second_order(letters[:3], letters[3:])), "math", cse=True)


def _largest_second_order(pitch_deg: int) -> float:
    return max(
        abs(part)
        for roll in range(0, 360, 15)
        for mu in _corners(3 * DEGREE)
        for part in _second_order()(roll * DEGREE, pitch_deg * DEGREE, 0.0, *mu)
    )


@cache
def substitution(row: int) -> tuple[float, float]:
    """The largest error of one row of (18), signed: with the master's angles, and as the text under (28) replaces them.

    rad; the master level, misalignments of 3 deg per axis.  A roll matching has the master's roll.
    """

    def error(mu, with_slave: bool) -> float:
        euler_b = angles(finite_rotation(mu))
        phi, theta = (0 if row == 0 else euler_b[0], euler_b[1]) if with_slave else (0, 0)
        estimate = paper.relative_euler((sp.Float(phi), sp.Float(theta), 0), mu)[row]
        return float(estimate) - float(euler_b[row])

    worst = max(_corners(3 * DEGREE), key=lambda mu: abs(error(mu, False)))
    return error(worst, False), error(worst, True)


@cache
def _limit() -> str:
    turn = quaternion(finite_rotation((exact("6e-13"), exact("8e-13"), exact(0))))
    return shown(norm(turn - vector(1, exact("3e-13"), exact("4e-13"), 0)), 2)
