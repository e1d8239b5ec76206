"""The status of a form of an equation, computed at finite errors: exact, first-order, a definition, or refuted."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

import mpmath as mp

from boresight.derive.ledger.equation import Equation, Relation
from boresight.derive.ledger.evaluate import Point, residual
from boresight.derive.ledger.numbers import Matrix, largest
from boresight.derive.ledger.paper import Paper

EXACT = mp.mpf("1e-28")
FOURFOLD = mp.mpf("0.25025")  # a quarter; at errors of 5e-8 rad the next order changes it by far less than 0.1 %
SEEDS = (1, 2, 3)
FULL, SMALL, HALF = 1.0, 1e-6, 5e-7


@dataclass(frozen=True)
class Verdict:
    """What the witness says: exact, first-order, definition or refuted; why, in a few words."""

    status: str
    why: str = ""


def judge(paper: Paper, equation: Equation, relations: tuple[Relation, ...]) -> Verdict:
    """The verdict on `relations` in the place of the equation's own."""
    if equation.defines:
        return _judge_definition(paper, equation, relations)
    return _judge_at(relations, lambda seed, scale: witness_point(paper, seed, scale, equation.small))


def _judge_at(relations, point, seeds=SEEDS) -> Verdict:
    """exact, first-order or refuted, from the residuals at points of three sizes."""
    order = 0
    for seed in seeds:
        try:
            small, half = (largest_residual(relations, point(seed, scale)) for scale in (SMALL, HALF))
            if small > EXACT and half > FOURFOLD * small:
                return Verdict("refuted", f"halving the errors leaves {mp.nstr(half / small, 4)} of the difference")
            if small > EXACT or largest_residual(relations, point(seed, FULL)) > EXACT:
                order = 1
        except (ValueError, KeyError, ZeroDivisionError) as error:
            return Verdict("refuted", f"it has no meaning: {error.args[0] if error.args else error}")
    return Verdict(("exact", "first-order")[order])


def _judge_definition(paper: Paper, equation: Equation, relations: tuple[Relation, ...]) -> Verdict:
    """definition, unless another equation of the paper, in its derived form, fails with what this one defines."""
    seed, changed = SEEDS[0], ((equation.number, relations),)
    try:
        given, usual = witness_point(paper, seed, FULL, (), changed), witness_point(paper, seed, FULL)
        moved = {
            name for name, value in usual.values.items() if not callable(value) and _differs(value, given.values[name])
        }
    except (ValueError, KeyError, ZeroDivisionError) as error:
        return Verdict("refuted", f"it does not define {', '.join(map(str, equation.defines))}: {error}")
    users = [e for e in paper.equations if e.number != equation.number and moved & names(e.derived)]
    # What held exactly must hold exactly still: one point tells, and most contradictions show here.
    for user in users:
        try:
            contradicted = largest_residual(user.derived, usual) < EXACT < largest_residual(user.derived, given)
        except ValueError:
            contradicted = True
        if contradicted:
            return Verdict("refuted", f"contradicted by ({user.number})")
    for user in users:

        def point(seed, scale, small=user.small):
            return witness_point(paper, seed, scale, small, changed)

        if _judge_at(user.derived, point, (seed,)).status == "refuted":
            return Verdict("refuted", f"contradicted by ({user.number})")
    return Verdict("definition")


@cache
def witness_point(paper: Paper, seed: int, scale: float, small: tuple = (), changed: tuple = ()) -> Point:
    """The witness's values at a random point, the errors `small` times `scale`; `changed`: other definitions."""
    return Point(paper.witness.at(seed, scale, small, paper.definitions | dict(changed)))


def largest_residual(relations: Iterable[Relation], point: Point) -> mp.mpf:
    return largest(entry for relation in relations for entry in residual(relation.sides, point))


def _differs(a, b) -> bool:
    if a is b:
        return False
    difference = a - b
    return largest(difference if isinstance(difference, Matrix) else [difference]) > EXACT


def names(relations: Iterable[Relation]) -> set[str]:
    return {
        symbol.name for relation in relations for side in relation.sides for symbol in getattr(side, "free_symbols", ())
    }
