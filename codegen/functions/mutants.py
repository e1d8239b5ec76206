"""Which points of a unit tell it from its mutants: few, so that its golden vectors are few.

A mutant is the instruction list with one operation swapped, one result's sign flipped, or one constant off by 1e-3 in
one place.  A point tells it from the list if some result moves by more than twice what the self-test grants.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from boresight.codegen.functions.tape import COMPUTE, Tape, computed

OFF = 1e-3
PAIRS = ("add sub", "mul div", "sin cos", "asin acos", "sinh cosh", "exp log", "fmin fmax", "lt le")
SWAPS = {one: other for pair in PAIRS for one, other in (pair.split(), pair.split()[::-1])}
SPELT: dict[str, Callable[..., Any]] = {  # operations that C spells with another one or with a constant
    "sq": lambda x: x / x,
    "twice": lambda x: 2 / x,
    "inv": lambda x: 1 * x,
    "if_else_zero": lambda x, y: y,
}
SCALED = ("twice", "inv")
TRUTHS = ("lt", "le", "eq", "ne", "not", "and", "or")
LEAST = 2  # vectors of a unit
NUMBERS, MEMORY = 2**11, 2**24  # of one step of the mutants that are run side by side, and of all steps

Mutant = tuple[int, Callable[..., Any]]  # position of a step, and what is computed there instead from its operands


def scaled(operation: Callable[..., Any], share: float, *operands: Any) -> Any:
    return share * operation(*operands)


def altered(operation: Callable[..., Any], share: float, i: int, *operands: Any) -> Any:
    """With a share of operand i."""
    return operation(*(x * share if j == i else x for j, x in enumerate(operands)))


def mutants(program: Tape) -> list[Mutant]:
    """All mutants of the list, in its order."""
    made: list[Mutant] = []
    for k, step in enumerate(program.steps):
        if step.op not in COMPUTE:
            continue
        plain = COMPUTE[step.op]
        sign = 0.0 if step.op in TRUTHS else -1.0  # minus true is not true
        changed: list[Callable[..., Any]] = [partial(scaled, plain, sign)]
        changed += [COMPUTE[SWAPS[step.op]]] if step.op in SWAPS else []
        changed += [SPELT[step.op]] if step.op in SPELT else []
        for share in (1 - OFF, 1 + OFF):
            changed += [partial(scaled, plain, share)] if step.op in SCALED else []
            constants = (i for i, arg in enumerate(step.args) if program.steps[arg].op == "const")
            changed += [partial(altered, plain, share, i) for i in constants]
        made += [(k, change) for change in changed]
    return made


@np.errstate(all="ignore")
def distinguished(
    program: Tape, tried: list[Mutant], points: list[np.ndarray], granted: list[np.ndarray], turning: list[bool]
) -> np.ndarray:
    """(mutants, points) whether the point tells the mutant from the list.

    granted: by how much each result may move, (points,) each; turning: which results are angles, alike after a turn.
    """
    plain = computed(program, points)
    found = np.zeros((len(tried), len(plain[0])), dtype=bool)
    rows = max(1, min(NUMBERS, MEMORY // len(plain)) // found.shape[1])
    for start in range(0, len(tried), rows):
        part = tried[start : start + rows]
        here: dict[int, list[int]] = {}
        for row, (k, _) in enumerate(part):
            here.setdefault(k, []).append(row)
        other: dict[int, np.ndarray] = {}  # values that differ from those of the list, (mutants, points)
        for k in range(part[0][0], len(program.steps)):
            args = program.steps[k].args
            if k not in here and not any(arg in other for arg in args):
                continue
            # a truth value is a number, as in C
            value = COMPUTE[program.steps[k].op](*(other.get(arg, plain[arg]) for arg in args)) + 0.0
            if k in here:
                value = np.array(np.broadcast_to(value, (len(part), found.shape[1])), dtype=float)
                for row in here[k]:
                    value[row] = part[row][1](*(plain[arg] for arg in args))
            other[k] = value
        for (_, _, position), limit, turns in zip(program.results, granted, turning, strict=True):
            if position in other:
                off = abs(other[position] - plain[position])
                off = np.where(off > 3, abs(off - 2 * np.pi), off) if turns else off
                found[start : start + len(part)] |= ~(off <= limit)
    return found


def cover(told_by: np.ndarray) -> list[int]:
    """Columns that together have a true in each row which has any: each the one with most rows not covered yet."""
    chosen: list[int] = []
    while told_by.any():
        chosen.append(int(told_by.sum(axis=0).argmax()))
        told_by = told_by[~told_by[:, chosen[-1]]]
    return sorted(chosen)


def telling(
    program: Tape, points: list[np.ndarray], granted: list[np.ndarray], turning: list[bool], needs: np.ndarray
) -> list[int]:
    """The first LEAST points, and of the others those few that tell a mutant from the list which the first do not.

    needs: (needs, points) of what else is wanted of a point; each that any point serves is served.
    """
    left, count = mutants(program), len(points[0])
    for start, stop in ((0, 1), (1, LEAST), (LEAST, count)):
        some = slice(start, stop)
        found = distinguished(
            program, left, [part[some] for part in points], [limit[some] for limit in granted], turning
        )
        if stop < count:
            left = [mutant for mutant, row in zip(left, found, strict=True) if not row.any()]
    needs = needs[~needs[:, :LEAST].any(axis=1), LEAST:]
    return [*range(LEAST), *(LEAST + i for i in cover(np.vstack([found, needs])))]
