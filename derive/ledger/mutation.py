"""Every single mutation of a relation: one sign, function, letter, transpose, order, term or factor changed.

A status that is really computed changes with each of them, but for the mutants which say the same thing; why a mutant
survives is computed too.
"""

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache
from random import Random

from sympy import Add, MatAdd, MatMul, Mul, Pow, S, Symbol, cos, sin, tan
from sympy.functions.elementary.complexes import transpose
from sympy.matrices import MatrixBase
from sympy.matrices.exceptions import ShapeError

from boresight.derive.ledger.equation import (
    Derivation,
    Equation,
    Quantity,
    Relation,
    children,
    negative,
    rebuild,
)
from boresight.derive.ledger.evaluate import DIGITS, Point, residual
from boresight.derive.ledger.free import free_point
from boresight.derive.ledger.judge import EXACT, FULL, SCALES, SEEDS, SLACK, judge, witness_point
from boresight.derive.ledger.lines import judge_line, line_point
from boresight.derive.ledger.numbers import Matrix, digits, exact, largest, middle
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.passages import judge_passage

SAME = "says the same: equal for any values of the letters"
ALIAS = "puts another name of the same quantity"
SECOND_ORDER = "differs in the second order alone, which the equation drops"
UNEXPLAINED = "unexplained"

OTHER_FUNCTIONS = {sin: (cos, tan), cos: (sin, tan), tan: (sin, cos)}


def mutants(relations: tuple[Relation, ...], quantities: Iterable[Quantity]) -> Iterator[tuple[str, tuple]]:
    """What is changed, and all relations with that one change."""
    letters = [quantity for quantity in quantities if not quantity.function]
    alike = {
        letter.symbol: tuple(o.symbol for o in letters if o.kind == letter.kind and o.symbol != letter.symbol)
        + ((transpose(letter.symbol),) if len(letter.shape) == 2 else ())
        for letter in letters
    }
    for r, relation in enumerate(relations):
        for i, side in enumerate(relation.sides):
            for what, changed in _side(side, alike):
                sides = (*relation.sides[:i], changed, *relation.sides[i + 1 :])
                yield what, (*relations[:r], Relation(sides), *relations[r + 1 :])


def _side(side, alike) -> Iterator[tuple[str, object]]:
    if side != 0 and not isinstance(side, Add | MatAdd | MatrixBase):
        with suppress(ShapeError):  # a print whose shapes do not fit
            yield f"-({short(side)})", negative(side)
    yield from _inside(side, alike)


def _inside(expression, alike) -> Iterator[tuple[str, object]]:
    """The mutants of an expression and of everything in it."""
    yield from _here(expression, alike)
    arguments = children(expression)
    for i, argument in enumerate(arguments):
        for what, changed in _inside(argument, alike):
            yield from _written(what, expression, (*arguments[:i], changed, *arguments[i + 1 :]))


def _here(expression, alike) -> Iterator[tuple[str, object]]:
    """The mutants of the node itself."""
    if isinstance(expression, Symbol):
        for other in alike.get(expression, ()):
            yield f"{expression} -> {other}", other
        return
    arguments = children(expression)

    def with_argument(what, i, *new):
        return _written(what, expression, (*arguments[:i], *new, *arguments[i + 1 :]))

    if isinstance(expression, MatrixBase):
        for i, entry in enumerate(arguments):
            place = f"entry {i // expression.cols + 1},{i % expression.cols + 1}"
            if entry != 0:
                yield from with_argument(f"{place}: {short(entry)} -> its negative", i, -entry)
            if entry in (0, 1, -1):
                yield from with_argument(f"{place}: {entry} -> {1 - abs(entry)}", i, 1 - abs(entry))
        if expression.rows == expression.cols > 1:
            yield "matrix -> its transpose", expression.T
    elif isinstance(expression, Add | MatAdd):
        for i, term in enumerate(arguments):
            with suppress(ShapeError):  # of a print whose shapes do not fit
                yield from with_argument(f"sign of {short(term)}", i, negative(term))
            yield from with_argument(f"without {short(term)}", i)
    elif isinstance(expression, Mul | MatMul):
        for i, factor in enumerate(arguments):
            if factor != S.NegativeOne and not isinstance(factor, MatrixBase):
                yield from with_argument(f"without factor {short(factor)}", i)
        for i in range(len(arguments) - 1):
            a, b = arguments[i : i + 2]
            if not (commutes(a) or commutes(b)):
                swapped = (*arguments[:i], b, a, *arguments[i + 2 :])
                yield from _written(f"{short(a)} and {short(b)} in the other order", expression, swapped)
    elif isinstance(expression, Pow):
        base, exponent = arguments
        yield f"{short(expression)} -> {short(base)}", base
        if exponent == 2:
            yield f"{short(expression)} -> cube", base**3
    elif expression.func == transpose:
        yield f"{short(expression)} -> not transposed", arguments[0]
    elif expression.func in OTHER_FUNCTIONS:
        for other in OTHER_FUNCTIONS[expression.func]:
            yield f"{short(expression)} -> {other.__name__}", other(*arguments)


def _written(what, expression, arguments) -> Iterator[tuple[str, object]]:
    """The node with other arguments; nothing if their shapes forbid even to write it."""
    with suppress(ShapeError):
        yield what, rebuild(expression, arguments)


def commutes(factor) -> bool:
    return not isinstance(factor, MatrixBase) and bool(factor.is_commutative)


def short(expression) -> str:
    text = " ".join(str(expression).replace("Matrix", "").split())
    return text if len(text) <= 40 else text[:37] + "..."


# ---- Survivors -------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Survivor:
    """A mutant that keeps the status, and why."""

    number: str
    what: str
    reason: str


def survivors(paper: Paper, equation: Equation) -> tuple[int, list[Survivor]]:
    """How many mutants the print of an equation has, of an erratum the corrected form, and those which survive."""
    with digits(DIGITS):
        form, verdict = equation.read(), judge(paper, equation, equation.read())
        if verdict.status == "refuted":
            form, verdict = equation.derived, judge(paper, equation, equation.derived)
        count, found = 0, []
        for what, mutant in mutants(form, equation.quantities):
            count += 1
            if judge(paper, equation, mutant).status == verdict.status:
                free = free_values(paper, equation)
                reason = _reason(form, mutant, free, lambda s: witness_point(paper, SEEDS[0], s, equation.small))
                found.append(Survivor(equation.number, what, reason))
    return count, found


def line_survivors(paper: Paper, equation: Equation, index: int) -> tuple[int, list[Survivor]]:
    """How many mutants the line `index` of a derivation has, and those that nothing refutes: neither its own claim, nor
    the passage to it, nor one from it, nor, of a definition, a later line."""
    one = equation.derivation.steps[index]
    assert one.relation is not None
    quantities = (*equation.quantities, *paper.letters())
    count, found = 0, []
    with digits(DIGITS):
        for what, (mutant,) in mutants((one.relation,), quantities):
            count += 1
            if not line_refuted(paper, equation, index, mutant):
                reason = _reason(
                    (one.relation,),
                    (mutant,),
                    free_point(paper, SEEDS[0]),
                    lambda s: line_point(paper, equation, index, s),
                )
                found.append(Survivor(f"{equation.number} line {index + 1}", what, reason))
    return count, found


def line_refuted(paper: Paper, equation: Equation, index: int, mutant: Relation) -> bool:
    """Whether a derivation with another relation in line `index` is refuted."""
    if not judge_line(paper, equation, index, mutant).holds:
        return True
    steps = equation.derivation.steps
    for at in range(index, len(steps)):
        step = steps[at]
        touched = index in equation.derivation.taken(at) or (at == index and step.passage)
        if touched and not judge_passage(paper, equation, at, {index: mutant}).holds:
            return True
    one = steps[index]
    if one.claim is not None and one.claim.kind == "definition":
        changed = Derivation((*steps[:index], replace(one, relation=mutant), *steps[index + 1 :]))
        other = replace(equation, derivation=changed)
        later = (i for i, s in enumerate(steps) if i > index and s.relation is not None)
        return any(not judge_line(paper, other, i).holds for i in later)
    return False


def _reason(form, mutant, free: Point, true: Callable[[float], Point]) -> str:
    """Why a mutant survives; free: values drawn freely, true: those of the witness at a scale of the errors."""

    def at(point: Point) -> tuple[list, list]:
        both = ([entry for relation in r for entry in residual(relation.sides, point)] for r in (form, mutant))
        first, second = both
        return first, second

    def same(first, second) -> bool:
        return any(
            all(abs(middle(a - sign * b)) < EXACT for a, b in zip(first, second, strict=True)) for sign in (1, -1)
        )

    with suppress(ValueError):  # values drawn freely may not be below their limits
        if same(*at(free)):
            return SAME
    if same(*at(true(FULL))):
        return ALIAS
    small, half = (largest(a - b for a, b in zip(*at(true(scale)), strict=True)) for scale in SCALES[:2])
    return SECOND_ORDER if half <= SLACK / 4 * small else UNEXPLAINED


@cache
def free_values(paper: Paper, equation: Equation) -> Point:
    """Values drawn for every letter by itself, as if no equation held; functions as the witness has them."""
    generator = Random(7)
    known = witness_point(paper, SEEDS[0], FULL).values

    def drawn(letter: Quantity):
        if letter.function:
            return known[letter.symbol.name]
        if not letter.shape:
            return exact(generator.uniform(0.2, 1.2))
        rows, columns = (*letter.shape, 1)[:2]
        return Matrix([[generator.uniform(0.2, 1.2) for _ in range(columns)] for _ in range(rows)])

    return Point({letter.symbol.name: drawn(letter) for letter in equation.quantities})
