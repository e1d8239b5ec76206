"""Sizes of what is dropped, what the errata do, and what was computed about the text beside the equations."""

from collections.abc import Callable, Iterator
from functools import cache
from itertools import product

import sympy as sp

from boresight.derive.ledger.numbers import exact, norm, shown
from boresight.derive.ledger.witness import angles, finite_rotation, quaternion, vector
from boresight.derive.papers.song_lee_2001 import results as paper
from boresight.derive.papers.song_lee_2001.witness import DEGREE

# Table 1, lines 210 to 216: a row for each set of matched angles, a column for each motion, both in the order of AXES;
# o: estimable, X: not, for the errors about n, e, d.
AXES = ("roll", "pitch", "yaw", "roll pitch", "roll yaw", "pitch yaw", "roll pitch yaw")
TABLE_1 = (
    "XXX XXo XoX XXo XoX Xoo Xoo",
    "XXo XXX oXX XXo oXo oXX oXo",
    "XoX oXX XXX ooX XoX oXX ooX",
    "XXo XXo ooX XXo ooo ooo ooo",
    "XoX oXo XoX ooo XoX ooo ooo",
    "Xoo oXX oXX ooo ooo oXX ooo",
    "Xoo oXo ooX ooo ooo ooo ooo",
)
TABLE_1_LINES = (210, 216)
# Line 224 and 262: cells with three, two, one, none estimable; cells with d estimable.
TABLE_1_COUNTS = ((13, 12, 21, 3), 28)

_IN_THE_LOOP = "in the loop: boresight study euler-table --switch as-printed-26-28"


def evidence(number: str) -> str:
    """What the ledger says beyond the status: sizes of dropped terms at the paper's numbers; "" for most equations."""
    if number in ("15", "18"):
        return "the dropped second-order term, largest over roll and a misalignment of 3 deg per axis: " + ", ".join(
            f"{_minutes(_largest_second_order(pitch))} at a pitch of {pitch} deg" for pitch in (0, 3, 30, 60, 80)
        )
    if number in ("26", "27", "28"):
        ours, theirs = (_minutes(error) for error in substitution(int(number) - 26))
        return (
            "with the slave's angles for the master's missing ones, as the text under (28) has it, the error of the "
            f"computed difference goes from {ours} to {theirs} (master level, 3 deg per axis): about as large, of the "
            "other sign, and above the noise of 1 arcmin, where the text calls it negligible; " + _IN_THE_LOOP
        )
    if number in ("8", "9"):
        return _IN_THE_LOOP
    if number == "25":
        return "in the loop: boresight study euler-table --switch as-printed-25"
    if number == "20":
        rate = 500e-6 * 9.8 * 120 / 6.37e6 / DEGREE * 3600
        return (
            "also dropped: the error of ω_in_n, from velocity and position; the paper's 500 ug give a velocity "
            f"error of 0.59 m/s in 120 s and so {rate:.2g} deg/h, against gyros of 1 deg/h"
        )
    if number == "23":
        return f"at zero the print is 0/0; its limit [1, eps/2] is off by {_limit()} at 1e-12 rad"
    return ""


def findings() -> tuple[str, ...]:
    """What was computed about the text beside the equations."""
    cells = [cell for row in TABLE_1 for cell in row.split()]
    estimable = [cell.count("o") for cell in cells]
    counts = tuple(estimable.count(k) for k in (3, 2, 1, 0)), sum(cell[2] == "o" for cell in cells)
    by_rule = sum(
        a == b for cell, ruled in zip(cells, composed(), strict=True) for a, b in zip(cell, ruled, strict=True)
    )
    agree = "as" if counts == TABLE_1_COUNTS else "other than"
    return (
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
