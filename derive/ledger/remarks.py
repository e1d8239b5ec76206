"""What is measured beside the status of a true equation, such as a term of second order that is of no use."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from itertools import chain
from random import Random
from typing import Any

from sympy import Add, MatAdd, Symbol, preorder_traversal
from sympy.core.function import AppliedUndef
from sympy.matrices.exceptions import ShapeError

from boresight.derive.ledger.equation import Equation, Relation, children, rebuild, total
from boresight.derive.ledger.evaluate import Point, evaluate, residual
from boresight.derive.ledger.judge import (
    EXACT,
    FULL,
    SCALES,
    SEEDS,
    SLACK,
    judge_at,
    names,
    paper_points,
    witness_point,
)
from boresight.derive.ledger.numbers import Matrix, entries, exact, largest, middle, middles
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


# ---- Letters that the witness has as zero ----------------------------------------------------------------------------


@cache
def vanishes(paper: Paper, name: str, small: tuple[str, ...]) -> bool:
    """Whether a letter, not a zero by its name, is zero at every point; small: errors of the equation."""
    with suppress(ValueError, KeyError, ZeroDivisionError):
        points = chain([(SEEDS[0], SCALES[0])], ((seed, FULL) for seed in SEEDS))  # the first is known, others are dear
        return not name.startswith("0_") and all(_zero(witness_point(paper, *at, small), name) for at in points)
    return False


def _zero(point: Point, name: str) -> bool:
    value = point.values[name]
    random = (of if isinstance(of, tuple) else (of,) for of in point.values.get("random", ()))
    return not callable(value) and largest(entries(value)) < EXACT and not any(name in of for of in random)


def shows_zero(paper: Paper, equation: Equation, relations: tuple[Relation, ...]) -> bool:
    """Whether an edit of the print puts a letter in that is zero everywhere, or makes the sides of a relation zero."""
    before = equation.read()
    zeros = {name for name in names(relations) if vanishes(paper, name, equation.small)}
    if zeros and _count(relations, zeros) > _count(before, zeros):
        return True
    points = [witness_point(paper, seed, FULL, equation.small) for seed in SEEDS]
    return any(
        all(largest(entries(evaluate(side, point))) < EXACT for side in one.sides for point in points)
        for one in relations
        if one not in before
    )


def _count(relations: Iterable[Relation], letters: set[str]) -> int:
    nodes = (node for relation in relations for side in relation.sides for node in preorder_traversal(side))
    return sum(isinstance(node, Symbol) and node.name in letters for node in nodes)


def leans_on_zero(paper: Paper, equation: Equation, form: tuple[Relation, ...]) -> list[str]:
    """The letters but for whose being zero everywhere the form would not hold; not one that is a side by itself, of
    which the form says it, nor one that stands in a rate of brackets alone."""
    alone = {side.name for relation in form for side in relation.sides if isinstance(side, Symbol)}
    printed = sorted(names(form) - {name for name in alone if _count(form, {name}) == 1})
    zeros = [name for name in printed if vanishes(paper, name, equation.small) and _count(form, {name})]
    return [name for name in zeros if not _holds_with(paper, equation, form, name)]


def _holds_with(paper: Paper, equation: Equation, form: tuple[Relation, ...], name: str) -> bool:
    """Whether the form holds with the letter at will, or at will and as small as the errors."""
    generator, zero = Random(7), witness_point(paper, SEEDS[0], FULL).values[name]
    drawn = [exact(generator.uniform(0.2, 1.2)) for _ in entries(zero)]
    columns = getattr(zero, "cols", 1)
    rows = [drawn[i : i + columns] for i in range(0, len(drawn), columns)]
    value: Any = Matrix(rows) if isinstance(zero, Matrix) else drawn[0]

    def at(power: int) -> Callable[[int, float], Point]:
        return lambda seed, scale: witness_point(paper, seed, scale, equation.small).changed(
            {name: value * exact(scale) ** power}
        )

    return any(judge_at(form, at(power), constant=bool(paper.folder)).status != "refuted" for power in (0, 1))
