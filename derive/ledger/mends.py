"""What a misprint may have been: single edits of the print that make it true, the likeliest first.

The edits are those of ledger/mutation.py, taken back, and factors and terms that a print may have lost.
"""

import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from difflib import SequenceMatcher
from functools import cache
from itertools import pairwise
from typing import Any

import mpmath as mp
from sympy import Add, Function, Integer, MatAdd, MatMul, Mul, Rational, StrictLessThan, Symbol
from sympy.functions.elementary.complexes import transpose
from sympy.matrices import MatrixBase
from sympy.matrices.exceptions import ShapeError

from boresight.derive.ledger.differences import NORM
from boresight.derive.ledger.equation import (
    Equation,
    Quantity,
    Relation,
    children,
    is_explicit,
    negative,
    plus,
    product,
    rebuild,
    replaced,
    total,
)
from boresight.derive.ledger.evaluate import DIGITS, Point, residual
from boresight.derive.ledger.judge import EXACT, judge, judge_with, names
from boresight.derive.ledger.mutation import commutes, free_values, mutants, short
from boresight.derive.ledger.numbers import digits, middle
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.remarks import shows_zero

SHOWN = 3
# How likely a slip is, by the first words of what takes it back; what is not here comes last.
LIKELY = ("sign", "-(", "letter", "transpose", "brackets", "bars", "order", "without", "with")
LIKE = 0.6  # of letters of two kinds, how much alike they must be written


@dataclass(frozen=True)
class Mend:
    """what: the edit, in words.  relations: the print with it.  status: what that is, exact or first-order."""

    what: str
    relations: tuple[Relation, ...]
    status: str


@cache
def mends(paper: Paper, equation: Equation) -> tuple[Mend, ...]:
    """All single edits of the print that make it true, the likeliest first; of those that say the same the first.
    None puts in a letter that the witness has as zero everywhere, or makes both sides zero.

    A definition is true if with it every equation holds that uses what it defines.
    """
    with digits(DIGITS):
        print_ = equation.read()
        used = names(print_)
        tried = sorted(_edits(print_, equation.quantities), key=lambda edit: _rank(edit[0], used))
        free = free_values(paper, equation)
        found: list[Mend] = []
        for what, relations in tried:
            if _says_nothing(relations, free) or any(same(relations, mend.relations, free) for mend in found):
                continue
            with suppress(ValueError, KeyError, ZeroDivisionError):
                status = _status(paper, equation, relations)
                if status != "refuted" and not shows_zero(paper, equation, relations):
                    found.append(Mend(_in_words(what), relations, status))
        return tuple(found)


def _status(paper: Paper, equation: Equation, relations: tuple[Relation, ...]) -> str:
    if not (paper.folder and equation.defines):
        return judge(paper, equation, relations).status
    changed = ((equation.number, relations),)
    broken = any(judge_with(paper, user, changed).status == "refuted" for user in users(paper, equation))
    return "refuted" if broken else "definition"


@cache
def users(paper: Paper, equation: Equation) -> tuple[Equation, ...]:
    """The equations in which a letter stands that this one defines, or one that is defined by it in turn."""
    moved, more = set[str](), {symbol.name for symbol in equation.defines}
    while more - moved:
        moved |= more
        more = {s.name for e in paper.equations if e.defines and moved & names(e.read()) for s in e.defines}
    return tuple(e for e in paper.equations if e is not equation and not e.defines and moved & names(e.read()))


def contradicted(paper: Paper, equation: Equation) -> tuple[Equation, ...]:
    """The equations that use what this one of a paper of one's own defines, and are refuted."""
    return tuple(user for user in users(paper, equation) if judge(paper, user, user.read()).status == "refuted")


@cache
def may_be_to_blame(paper: Paper, equation: Equation) -> tuple[Mend, ...]:
    """The edits of a definition with which all hold that use it, where several fail, or one that no edit of its own
    mends."""
    failing = contradicted(paper, equation)
    if not failing or (len(failing) == 1 and mends(paper, failing[0])):
        return ()
    return mends(paper, equation)


def rivals(paper: Paper, equation: Equation) -> tuple[Equation, ...]:
    """The other definitions that may be to blame for what fails with this one, or those for what this one fails by."""
    failing = {user.number for user in contradicted(paper, equation)} or {equation.number}
    return tuple(
        other
        for other in paper.equations
        if other.defines
        and other is not equation
        and failing & {user.number for user in users(paper, other)}
        and may_be_to_blame(paper, other)
    )


def definition_mends(paper: Paper, equation: Equation) -> tuple[Mend, ...]:
    """The edits of a definition that alone is to blame."""
    return () if equation.defines and rivals(paper, equation) else may_be_to_blame(paper, equation)


def _in_words(what: str) -> str:
    """Without the names of functions: skew(a)*b is [a x] b."""
    for name, left, right in (("skew", "[", " x]"), ("transpose", "(", ")^T")):
        while (at := what.find(f"{name}(")) >= 0:
            begin = end = at + len(name) + 1
            depth = 1
            while depth and end < len(what):
                depth += (what[end] == "(") - (what[end] == ")")
                end += 1
            inside = what[begin : end - 1] if not depth else what[begin:]
            simple = left == "(" and re.fullmatch(r"[\w\u0300-\u036f]+", inside)
            what = what[:at] + (f"{inside}^T" if simple else f"{left}{inside}{right}") + what[end:]
    return re.sub(r"^-\((.*)\)$", r"the other sign of \1", what).replace("*", " ")


def _edits(relations: tuple[Relation, ...], quantities: tuple[Quantity, ...]) -> Iterator[tuple[str, tuple]]:
    seen = set()
    quantities = tuple({q.symbol: q for q in quantities}.values())
    every = (mutants, _letters_everywhere, _additions, _groupings, _terms)
    for what, changed in (edit for edits in every for edit in edits(relations, quantities)):
        if changed not in seen:
            seen.add(changed)
            yield what, changed


def _rank(what: str, used: set[str]) -> tuple:
    """The kind of slip, and of a letter how much it is like the one in its place, and whether the equation has it."""
    before, arrow, after = what.partition(" -> ")
    if arrow and "(" not in after:
        if after.startswith("transpose"):
            return LIKELY.index("transpose"), 0.0, what
        return LIKELY.index("letter"), -_likeness(before, after) - 0.1 * (after in used), what
    turned = what.endswith(("-> transpose", "its transpose", "not transposed"))
    word = "order" if what.endswith("other order") else "transpose" if turned else what
    place = next((i for i, start in enumerate(LIKELY) if word.startswith(start)), len(LIKELY))
    factor = re.match(r"with factor ([^ ^]+)", what)
    return place, float(factor is not None and factor[1] not in used), what


def _likeness(a: str, b: str) -> float:
    return SequenceMatcher(None, a, b).ratio()


# ---- What a print may have lost -------------------------------------------------------------------------------------


def _places(relations: tuple[Relation, ...], change: Callable[[Any], Iterator]) -> Iterator[tuple[str, tuple]]:
    """What `change` makes of each side and of each node in it, one at a time."""

    def inside(node) -> Iterator[tuple[str, Any]]:
        yield from change(node)
        arguments = children(node)
        for i, argument in enumerate(arguments):
            for what, changed in inside(argument):
                with suppress(ShapeError, TypeError):
                    yield what, rebuild(node, (*arguments[:i], changed, *arguments[i + 1 :]))

    for r, relation in enumerate(relations):
        for i, side in enumerate(relation.sides):
            for what, changed in inside(side):
                sides = (*relation.sides[:i], changed, *relation.sides[i + 1 :])
                yield what, (*relations[:r], Relation(sides), *relations[r + 1 :])


def _letters_everywhere(relations: tuple[Relation, ...], quantities: Iterable[Quantity]) -> Iterator[tuple[str, tuple]]:
    """A letter for another of its kind, or of its shape and written much alike, wherever it stands in a side, or in a
    matrix, or in all of the equation."""
    letters = [q for q in quantities if not q.function]
    pairs = [
        (a.symbol, b.symbol)
        for a in letters
        for b in letters
        if a is not b and a.shape == b.shape and (a.kind == b.kind or _likeness(a.symbol.name, b.symbol.name) > LIKE)
    ]

    def change(node) -> Iterator[tuple[str, Any]]:
        for a, b in pairs if isinstance(node, MatrixBase | Symbol | Add | MatAdd | Mul | MatMul) else ():
            if a in node.free_symbols:
                with suppress(ShapeError):
                    yield f"{a} -> {b}", replaced(node, {a: b})

    yield from _places(relations, change)
    for a, b in pairs:
        if any(a in side.free_symbols for relation in relations for side in relation.sides):
            with suppress(ShapeError):
                yield f"{a} -> {b}", tuple(relation.replaced({a: b}) for relation in relations)


def _groupings(relations: tuple[Relation, ...], quantities: Iterable[Quantity]) -> Iterator[tuple[str, tuple]]:
    """A pair of brackets around a sum, so that a number divides all of it; a sum transposed; the sign of an argument of
    a function; bars around a vector; one term more of a letter."""
    scalars = [q.symbol for q in quantities if not q.function and not q.shape]

    def change(node) -> Iterator[tuple[str, Any]]:
        if isinstance(node, Add | MatAdd):
            for i, term in enumerate(node.args):
                numbers = [f for f in getattr(term, "args", ()) if f.is_Number and abs(f) != 1]
                if isinstance(term, Mul | MatMul) and numbers:
                    rest = product(*(f for f in term.args if f not in numbers))
                    inside = total(*node.args[:i], rest, *node.args[i + 1 :])
                    yield "brackets around the sum", product(*numbers, inside)
        if isinstance(node, Mul | MatMul):
            for i, factor in enumerate(node.args):
                if isinstance(factor, Add | MatAdd) and not factor.is_commutative:
                    turned = transpose(factor, evaluate=False)
                    yield f"{short(factor)} -> transpose", product(*node.args[:i], turned, *node.args[i + 1 :])
        if isinstance(node, Function):
            for i, argument in enumerate(node.args):
                other = negative(argument)
                what = min(argument, other, key=lambda form: len(str(form)))
                if not argument.is_Number:
                    new = (*node.args[:i], other, *node.args[i + 1 :])
                    yield f"sign of {short(what)} in {node.func.__name__}", node.func(*new)
        if isinstance(node, StrictLessThan):
            yield f"bars around {node.lhs}", StrictLessThan(NORM(node.lhs), node.rhs, evaluate=False)
        if isinstance(node, Add) and node.is_commutative:
            for scalar in scalars:
                for sign, text in ((1, "+"), (-1, "-")):
                    yield f"with term {text} {scalar}", total(*node.args, sign * scalar)

    yield from _places(relations, change)


def _additions(relations: tuple[Relation, ...], quantities: Iterable[Quantity]) -> Iterator[tuple[str, tuple]]:
    """A number, a letter or its transpose as one more factor of a term."""
    letters = {q.symbol: q for q in quantities if not q.function}
    used = names(relations)
    numbers = (Integer(2), Rational(1, 2))
    scalars = [s for s, q in letters.items() if not q.shape and s.name in used]
    square = [
        s
        for s, q in letters.items()
        if q.shape[1:] == q.shape[:1] != () and not s.name.startswith("0_")  # no zeros
    ]
    matrices = [(text, form) for s in square for text, form in ((str(s), s), (f"{s}^T", transpose(s)))]
    factors = [(str(s), s) for s in (*numbers, *scalars)] + [(f"1/{s}", 1 / s) for s in scalars]

    def change(node) -> Iterator[tuple[str, Any]]:
        parts = node.args if isinstance(node, Mul | MatMul) else (node,)
        if isinstance(node, MatrixBase | Add | MatAdd) or node.is_Number:
            return
        for text, scalar in factors:
            with suppress(ShapeError, TypeError):
                yield f"with factor {text} before {short(node)}", product(scalar, *parts)
        for text, matrix in () if node.is_commutative else matrices:
            for at in (i for i in range(len(parts) + 1) if i == len(parts) or not commutes(parts[i])):
                place = f"before {short(parts[at])}" if at < len(parts) else f"after {short(parts[-1])}"
                with suppress(ShapeError, TypeError):
                    yield f"with factor {text} {place}", product(*parts[:at], matrix, *parts[at:])

    yield from _places(relations, change)


def _terms(relations: tuple[Relation, ...], quantities: Iterable[Quantity]) -> Iterator[tuple[str, tuple]]:
    """A letter as one more term of a side, of the shape of the vector or matrix that stands alone on another."""
    shapes = {q.symbol: q.shape for q in quantities if not q.function and q.kind != "block"}
    for r, relation in enumerate(relations):
        shape = next((shapes[side] for side in relation.sides if shapes.get(side)), None)
        alike = [symbol for symbol, own in shapes.items() if own == shape and symbol not in relation.sides]
        last = relation.sides[-1]
        for symbol in alike if not is_explicit(last) else ():
            for sign, term in (("+", symbol), ("-", negative(symbol))):
                longer = Relation((*relation.sides[:-1], plus(last, term)))
                yield f"with term {sign} {symbol}", (*relations[:r], longer, *relations[r + 1 :])


# ---- What two forms say ----------------------------------------------------------------------------------------------


def _differences(relations: tuple[Relation, ...], free: Point) -> list | None:
    with suppress(ValueError, KeyError, ZeroDivisionError, TypeError):
        return [middle(entry) for relation in relations for entry in residual(relation.sides, free)]
    return None


def _says_nothing(relations: tuple[Relation, ...], free: Point) -> bool:
    """Whether a side is written twice, or it holds for any values of its letters."""
    if any(left == right for relation in relations for left, right in pairwise(relation.sides)):
        return True
    found = [_differences((relation,), free) for relation in relations]
    return any(entries is not None and all(abs(entry) < EXACT for entry in entries) for entries in found)


def same(a: tuple[Relation, ...], b: tuple[Relation, ...], free: Point) -> bool:
    """Whether two forms differ by a factor at most: the same equation, written otherwise."""
    first, second = _differences(a, free), _differences(b, free)
    if first is None or second is None or len(first) != len(second):
        return False
    most = max(range(len(first)), key=lambda i: abs(first[i]))
    with mp.workdps(DIGITS):
        ratio = second[most] / first[most] if first[most] else 0
        return ratio != 0 and all(abs(y - ratio * x) < EXACT for x, y in zip(first, second, strict=True))
