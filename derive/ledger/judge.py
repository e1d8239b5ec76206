"""The status of a form of an equation, computed at finite errors: exact, first-order, a definition, or refuted."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any
from unicodedata import normalize

import mpmath as mp
from sympy import Symbol
from sympy.core.function import AppliedUndef

from boresight.derive.ledger.equation import Equation, Relation
from boresight.derive.ledger.evaluate import Point, evaluate, residual
from boresight.derive.ledger.numbers import entries, largest, middle, middles, near
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.rates import RATE, rate_of
from boresight.derive.ledger.reader import SUM, SUM_OVER, read
from boresight.derive.ledger.witness import draw, scaled

EXACT = mp.mpf("1e-28")
SEEDS = (1, 2, 3)
FULL = 1.0
SCALES = (1e-6, 5e-7, 2.5e-7)  # each half of the one before
SLACK = 1.001  # of the ratio that an order asks for: the next order is below 1e-6 of it

Sense = tuple[str, tuple[tuple[str, str], ...]]  # of a Meaning


@dataclass(frozen=True)
class Verdict:
    """What the witness says: exact, first-order, definition or refuted; why, in a few words.

    empty: it is refuted because it has no meaning, or states nothing of first order.
    """

    status: str
    why: str = ""
    empty: bool = False


@dataclass(frozen=True)
class LineVerdict:
    """Whether it holds; why not, or what was seen; size of the term that is dropped, SI, at the paper's numbers."""

    holds: bool
    why: str
    size: str = ""


def judge(paper: Paper, equation: Equation, relations: tuple[Relation, ...], senses: Sequence[Sense] = ()) -> Verdict:
    """The verdict on `relations` in the place of the equation's own; senses: of its meanings, those taken if empty."""
    relations = meant(equation, relations, senses or tuple(meaning.senses[0] for meaning in equation.meanings))
    if equation.defines:
        return _judge_definition(paper, equation, relations)
    verdict = judge_with(paper, equation, (), relations)
    if verdict.status == "refuted" and not verdict.empty and not holds_errors(paper, equation, relations):
        return Verdict("refuted", "the sides differ, and no error is in them")
    if not equation.introduces or verdict.status == "refuted":
        return verdict
    return Verdict("definition") if verdict.status == "exact" else Verdict("refuted", "its sides are not the same")


def judge_with(
    paper: Paper, equation: Equation, changed: tuple = (), relations: tuple[Relation, ...] | None = None
) -> Verdict:
    """The verdict of the witness on what is read, or on `relations`; changed: other definitions, by number."""

    def point(seed: int, scale: float) -> Point:
        return witness_point(paper, seed, scale, equation.small, changed)

    return judge_at(equation.read() if relations is None else relations, point, constant=bool(paper.folder))


def holds_errors(paper: Paper, equation: Equation, relations: Iterable[Relation]) -> bool:
    """Whether a letter of the relations changes with the errors."""
    full, half = (witness_point(paper, SEEDS[0], scale, equation.small).values for scale in SCALES[:2])
    return any(callable(full[name]) or differs(full[name], half[name]) for name in names(relations))


def meant(equation: Equation, relations: Iterable[Relation], senses: Iterable[Sense]) -> tuple[Relation, ...]:
    """Relations with letters in these senses."""
    mapping: dict = {}
    for _, values in senses:
        mapping |= dict(_substitute(equation.quantities, name, latex) for name, latex in values)
    return tuple(relation.replaced(mapping) for relation in relations) if mapping else tuple(relations)


@cache
def _substitute(quantities: tuple, name: str, latex: str) -> tuple[Symbol, Any]:
    (relation,) = read((latex,), quantities)
    name = normalize("NFC", name)
    return next(q.symbol for q in quantities if q.symbol.name == name), relation.sides[0]


def judge_at(
    relations: Iterable[Relation],
    point: Callable[[int, float], Point],
    seeds: Iterable[int] = SEEDS,
    constant: bool = False,
) -> Verdict:
    """exact, first-order or refuted, from the residuals at points of four sizes.

    constant: whether a row states something that tends to a number other than zero and has no part of first order, as
    the first of [1, θ/2]; of the papers that come with Boresight it is empty.
    """
    order, relations = 0, tuple(relations)
    for seed in seeds:
        try:
            at = [point(seed, scale) for scale in SCALES[:2]]
            for relation in relations:  # what does not hold shows at two sizes, and a point is dear
                fall = falls(relation, at, 2)
                if fall.why:
                    return Verdict("refuted", fall.why)
            at.append(point(seed, SCALES[2]))
            for relation in relations:
                fall = falls(relation, at, 2)
                if fall.why:
                    return Verdict("refuted", fall.why)
                changes = _changes(relation, at, constant) if fall.rows else []
                for row in sorted(fall.rows):
                    if not changes[min(row, len(changes) - 1)]:  # a lone 0 has one row
                        return Verdict("refuted", f"row {row + 1} has no part of first order", True)
                order |= bool(fall.rows)
            order = order or largest_residual(relations, point(seed, FULL)) > EXACT
        except (ValueError, KeyError, ZeroDivisionError) as error:
            return Verdict("refuted", f"it has no meaning: {error.args[0] if error.args else error}", True)
    return Verdict("first-order" if order else "exact")


@dataclass(frozen=True)
class Fall:
    """How a remainder falls: why not as asked for, and the rows in which there is one."""

    why: str = ""
    rows: frozenset[int] = frozenset()


def falls(relation: Relation, at: Sequence[Point], power: int) -> Fall:
    """Whether each entry's remainder falls 2^power-fold when the errors are halved, twice; `at`: points of SCALES."""
    columns = getattr(evaluate(relation.sides[-1], at[0]), "cols", 1)
    rows, most = set(), SLACK / 2**power
    larger = [abs(near(entry)) for entry in residual(relation.sides, at[0])]
    size = len(larger) // (len(relation.sides) - 1)
    for point in at[1:]:
        smaller = [abs(near(entry)) for entry in residual(relation.sides, point)]
        for k, (before, after) in enumerate(zip(larger, smaller, strict=True)):
            if before > EXACT:
                rows.add(k % size // columns)
                if after > most * before:
                    share, row = mp.nstr(mp.mpf(after / before), 4), k % size // columns + 1
                    right = f"{0.5**power:g} or less would be right"
                    return Fall(f"halving the errors leaves {share} of the difference in row {row}, and {right}")
        larger = smaller
    return Fall("", frozenset(rows))


def _changes(relation: Relation, at: Sequence[Point], constant: bool) -> list[bool]:
    """Of each row of the last side, whether an entry has a part of first order: what it changes by halves; or one that
    does not fall, if that is asked for."""
    values: list[Any] = [evaluate(relation.sides[-1], point) for point in at]
    columns = getattr(values[0], "cols", 1)
    found = [
        abs(b - c) > abs(a - b) * SLACK / 4 or (constant and abs(c) > abs(b) * SLACK / 2)
        for a, b, c in zip(*map(middles, values), strict=True)
    ]
    return [any(found[i : i + columns]) for i in range(0, len(found), columns)]


def _judge_definition(paper: Paper, equation: Equation, relations: tuple[Relation, ...]) -> Verdict:
    """definition, unless another equation of the paper, in its derived form, fails with what this one defines."""
    seed, changed = SEEDS[0], ((equation.number, relations),)
    try:
        given, usual = witness_point(paper, seed, FULL, (), changed), witness_point(paper, seed, FULL)
        moved = {
            name for name, value in usual.values.items() if not callable(value) and differs(value, given.values[name])
        }
    except (ValueError, KeyError, ZeroDivisionError) as error:
        what = ", ".join(map(str, equation.defines))
        return Verdict("refuted", f"it does not define {what}: {error.args[0] if error.args else error}", True)
    users = [e for e in paper.equations if e.number != equation.number and moved & names(e.derived)]
    # What held exactly must hold exactly still: one point tells, and most contradictions show here.
    for user in users:
        try:
            contradicted = largest_residual(user.derived, usual) < EXACT < largest_residual(user.derived, given)
        except ValueError:
            contradicted = True
        if contradicted:
            return Verdict("refuted", f"contradicted by {user.label}")
    for user in users:

        def point(seed, scale, small=user.small):
            return witness_point(paper, seed, scale, small, changed)

        if judge_at(user.derived, point, (seed,)).status == "refuted":
            return Verdict("refuted", f"contradicted by {user.label}")
    return Verdict("definition")


@cache
def witness_point(paper: Paper, seed: int, scale: float, small: tuple = (), changed: tuple = ()) -> Point:
    """The witness's values at a random point, the errors `small` times `scale`; `changed`: other definitions."""
    return Point(paper.witness.at(seed, scale, small, paper.definitions | dict(changed)))


@cache
def paper_points(paper: Paper) -> tuple[Point, ...]:
    """The witness's values at the paper's own numbers."""
    witness, conditions = paper.witness, paper.conditions
    bases = (draw(witness.base, seed, conditions.at) for seed in range(conditions.count))
    return tuple(Point(witness.values(base, paper.definitions)) for base in bases)


def shares(paper: Paper, equation: Equation) -> list[mp.mpf]:
    """By which part of what it says, or, if errors are in it, of what they make of it, each row is off, at most.

    At the paper's own numbers, of what is read; the part of first order is twice what halving the errors takes away.
    """
    witness, conditions = paper.witness, paper.conditions
    halved = scaled(conditions.at, 0.5, equation.small or witness.errors)
    small, found = holds_errors(paper, equation, equation.read()), dict[int, mp.mpf]()
    for seed in range(conditions.count):
        whole, half = (Point(witness.values(draw(witness.base, seed, at), paper.definitions))
                       for at in (conditions.at, halved))  # fmt: skip
        begins = 0
        for relation in equation.read():
            last, less = (evaluate(relation.sides[-1], at) for at in (whole, half))
            left, columns = residual(relation.sides[-2:], whole), getattr(last, "cols", 1)
            one, other = map(middles, (last, less))
            one, other = (v * len(left) if len(v) < len(left) else v for v in (one, other))  # a lone 0
            for row in range(0, len(left), columns):
                at = slice(row, row + columns)
                own = max(abs(2 * (a - b)) if small else abs(a) for a, b in zip(one[at], other[at], strict=True))
                off = max(abs(middle(entry)) for entry in left[at])
                part = off / own if own else mp.inf if off > EXACT else mp.mpf(0)
                found[begins + row // columns] = max(found.get(begins + row // columns, mp.mpf(0)), part)
            begins += len(left) // columns
    return list(found.values())


def largest_residual(relations: Iterable[Relation], point: Point) -> mp.mpf:
    return largest(entry for relation in relations for entry in residual(relation.sides, point))


def differs(a, b) -> bool:
    if a is b:
        return False
    difference = a - b
    return largest(entries(difference)) > EXACT


def names(relations: Iterable[Relation]) -> set[str]:
    """The letters of relations; a sum is over the samples of its window, and a rate is made of those of its letters."""
    sides = [side for relation in relations for side in relation.sides]
    found = {symbol.name for side in sides for symbol in getattr(side, "free_symbols", ())}
    applied = [node for side in sides for node in side.atoms(AppliedUndef)]
    found |= {SUM_OVER for node in applied if node.func == SUM}
    return found | {s.name for node in applied if node.func == RATE for s in rate_of(node.args[0]).free_symbols}
