"""What is measured beside the status of a true equation, as a term of second order that is wrong."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from sympy import Add, MatAdd
from sympy.core.function import AppliedUndef
from sympy.matrices.exceptions import ShapeError

from boresight.derive.ledger.equation import Equation, Relation, children, rebuild, total
from boresight.derive.ledger.evaluate import evaluate, residual
from boresight.derive.ledger.judge import EXACT, SCALES, SEEDS, SLACK, paper_points, witness_point
from boresight.derive.ledger.numbers import middle, middles
from boresight.derive.ledger.paper import Paper

# Of the remainder without a term, what is left with it where it is clearly of use, and where it is of none.
NEARER, NO_LESS = 0.49, 0.99
TOGETHER = 0.99  # squared cosine
OF_ITS_OWN = ("Σ", "E", "rate")  # functions in which letters have other values than at the point


@dataclass(frozen=True)
class Needless:
    """A term of second order with which most of the entries that it changes are not clearly nearer to the truth.

    at: the number of its relation; without: that relation without it; changed: the entries of that relation's residual.
    """

    term: Any
    at: int
    without: Relation
    changed: frozenset[int]


def needless(paper: Paper, equation: Equation, form: tuple[Relation, ...]) -> Iterator[Needless]:
    """The terms of sums anywhere in `form`, which is of first order, that are of second order or more and of no use."""
    given = (equation.neglected, *getattr(equation.neglected, "args", ()))
    points = [witness_point(paper, SEEDS[0], scale, equation.small) for scale in SCALES[:2]]

    def small(term) -> bool:
        if term in given or not getattr(term, "free_symbols", ()):
            return False
        with suppress(ValueError, KeyError, ZeroDivisionError):
            whole, half = (middles(evaluate(term, point)) for point in points)
            falls = all(abs(b) <= abs(a) * SLACK / 4 for a, b in zip(whole, half, strict=True))
            return falls and max(map(abs, whole)) > EXACT
        return False

    for r, relation in enumerate(form):
        for i, side in enumerate(relation.sides):
            for term, rest in _without(side, small):
                without = Relation((*relation.sides[:i], rest, *relation.sides[i + 1 :]))
                with suppress(ValueError, KeyError, ZeroDivisionError):
                    if changed := _no_nearer(paper, relation, without):
                        yield Needless(term, r, without, changed)


def _without(node, which: Callable[[Any], bool]) -> Iterator[tuple[Any, Any]]:
    """Each of these terms of sums in an expression, and the expression without it."""
    if isinstance(node, AppliedUndef) and node.func.__name__ in OF_ITS_OWN:
        return
    arguments = children(node)
    for i, argument in enumerate(arguments):
        if isinstance(node, Add | MatAdd) and which(argument):
            yield argument, total(*arguments[:i], *arguments[i + 1 :])
        else:
            for term, changed in _without(argument, which):
                with suppress(ShapeError):
                    yield term, rebuild(node, (*arguments[:i], changed, *arguments[i + 1 :]))


def _no_nearer(paper: Paper, relation: Relation, without: Relation) -> frozenset[int]:
    """The entries that a term changes, at the paper's own numbers, if most of them are not clearly nearer with it."""
    forms = (relation, without)
    both = [zip(*([middle(e) for e in residual(form.sides, at)] for form in forms), strict=True)
            for at in paper_points(paper)]  # fmt: skip
    by_entry = [tuple(zip(*pairs, strict=True)) for pairs in zip(*both, strict=True)]
    changed = {
        k: pair for k, pair in enumerate(by_entry) if max(abs(a - b) for a, b in zip(*pair, strict=True)) > EXACT
    }
    return frozenset(changed) if 2 * sum(_in_vain(*pair) for pair in changed.values()) > len(changed) else frozenset()


def _in_vain(one: Sequence[Any], other: Sequence[Any]) -> bool:
    """Whether a term leaves an entry as far off as it is without it; or more than half as far, and all by a factor that
    it lacks, for the two differences go together from point to point."""

    def along(a: Sequence[Any], b: Sequence[Any]) -> Any:
        return sum(x * y for x, y in zip(a, b, strict=True))

    share = max(map(abs, one)) / max(EXACT, *map(abs, other))
    together = along(one, other) ** 2 > TOGETHER * along(one, one) * along(other, other)
    return share > NO_LESS or (share > NEARER and together)
