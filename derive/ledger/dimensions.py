"""Whether the terms of a paper's equations have units that fit, by the algebra of derive/units.

A letter's unit ends its meaning, as in `velocity of the slave, m/s`.  Vectors and matrices of several units are in
`Paper.units`; every other letter without a unit is a number: an attitude, a quaternion, a count.
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, reduce
from itertools import pairwise
from typing import Any

from sympy import Add, MatAdd, MatMul, Mul, Pow, StrictLessThan, Symbol
from sympy import Function as SymPyFunction
from sympy.core.function import AppliedUndef
from sympy.functions.elementary.complexes import transpose
from sympy.matrices import MatrixBase

from boresight import BoresightError
from boresight.derive.dimensions import SECOND, Mismatch
from boresight.derive.ledger.equation import Quantity
from boresight.derive.ledger.paper import Paper
from boresight.derive.units import ONE, RADIAN, Unit, of_base_units, unit

Entry = Unit | None  # None of zero, which has every unit
UNKNOWN = "?"  # in `Paper.units`, of a letter of which nobody has said a unit


@dataclass(frozen=True)
class Grid:
    """The units of a matrix's entries, row by row; of a scalar there is one."""

    rows: tuple[tuple[Entry, ...], ...]
    scalar: bool = False

    @property
    def shape(self) -> tuple[int, int]:
        return len(self.rows), len(self.rows[0])

    @property
    def T(self) -> "Grid":
        return Grid(tuple(zip(*self.rows, strict=True)), self.scalar)

    def __iter__(self) -> Iterator[Entry]:
        return (entry for row in self.rows for entry in row)


def scalar(entry: Entry) -> Grid:
    return Grid(((entry,),), True)


def filled(shape: Sequence[int], entry: Entry) -> Grid:
    rows, columns = (*shape, 1)[:2]
    return Grid(((entry,) * columns,) * rows)


def outer(rows: Iterable[Unit], columns: Iterable[Unit] = (ONE,)) -> Grid:
    columns = tuple(columns)
    return Grid(tuple(tuple(r * c for c in columns) for r in rows))


# ---------------------------------------------------------------- letters


def listed(text: str) -> tuple[Unit, ...]:
    """`3 rad, m` as rad, rad, rad, m."""
    parts = (part.split() for part in text.split(", "))
    return tuple(unit(part[-1]) for part in parts for _ in range(int(part[0]) if len(part) > 1 else 1))


def over(units: Iterable[Unit]) -> tuple[Unit, ...]:
    return tuple(ONE / one for one in units)


def of_letter(mixed: Mapping[str, str], letter: Quantity) -> Grid:
    """Of a vector or matrix, of each entry.  mixed: `Paper.units`."""
    key = letter.symbol.name if letter.symbol.name in mixed else letter.kind
    if key in mixed:
        rows, word, columns = re.split("( by | times |$)", mixed[key], maxsplit=1)
        units = listed(columns) if columns else (ONE,)
        return outer(listed(rows), units if word == " times " else over(units))
    kind = letter.meaning.split(",")[0]
    if kind == "zeros":
        return filled(letter.shape, None)
    if kind == "identity":
        size = letter.shape[0]
        return Grid(tuple(tuple(ONE if i == j else None for j in range(size)) for i in range(size)))
    if column := re.match(r"column (\d+) of the identity", letter.meaning):
        return Grid(tuple((ONE if i == int(column[1]) else None,) for i in range(1, letter.shape[0] + 1)))
    own = of_meaning(letter.meaning)
    return filled(letter.shape, own) if letter.shape else scalar(own)


WORD = re.compile("[a-z]{2,}")  # which is no unit: pint would have to be read to say so


@cache
def of_meaning(meaning: str) -> Unit:
    """The unit that ends it, perhaps before a remark on conventions; else that of a number."""
    for part in reversed(meaning.split(", ")):
        if " " in part or (WORD.fullmatch(part) and of_base_units(part) is None):
            continue
        try:
            return unit(part)
        except BoresightError:
            continue
    return ONE


# ---------------------------------------------------------------- expressions


class Terms:
    """The units of an expression of a paper's letters."""

    def __init__(self, letters: dict[str, Grid]):
        self.letters = letters
        self.known: dict[Any, Grid] = {}

    def __call__(self, e: Any) -> Grid:
        if e not in self.known:
            self.known[e] = self.of(e)
        return self.known[e]

    def of(self, e: Any) -> Grid:
        if isinstance(e, Symbol):
            return self.letters[e.name]
        if isinstance(e, MatrixBase):
            return assembled([[self(e[i, j]) for j in range(e.cols)] for i in range(e.rows)])
        if e.is_Number or e.is_NumberSymbol:
            return scalar(None if e == 0 else ONE)
        if isinstance(e, AppliedUndef):
            return self.applied(e)
        parts = [self(part) for part in e.args]
        if isinstance(e, Add | MatAdd | StrictLessThan):
            return reduce(added, parts)
        if isinstance(e, Mul | MatMul):
            return reduce(multiplied, parts)
        if isinstance(e, transpose):
            return parts[0].T
        if isinstance(e, Pow):
            return power(parts[0], e.exp)
        return self.function(e, parts)

    def function(self, e: SymPyFunction, parts: list[Grid]) -> Grid:
        name = e.func.__name__
        if name == "atan2":
            added(*parts)
            return scalar(RADIAN)
        number(parts[0], name)
        return scalar(RADIAN if name in ("asin", "acos", "atan") else ONE)

    def applied(self, e: Any) -> Grid:
        name = e.func.__name__
        if name in ("E", "Σ"):
            return self(e.args[0])
        if name == "entry":
            whole, i, j = self(e.args[0]), int(e.args[1]), int(e.args[2])
            return scalar(whole.rows[i - 1][j - 1])
        parts = [self(part) for part in e.args]
        if name == "skew":
            return skew(parts[0])
        if name == "cross":
            return multiplied(skew(parts[0]), parts[1])
        if name == "vee":
            M = parts[0].rows
            pairs = ((M[2][1], M[1][2]), (M[0][2], M[2][0]), (M[1][0], M[0][1]))
            return Grid(tuple((alike(a, b),) for a, b in pairs))
        if name in ("max", "min"):
            return reduce(added, parts)
        if name == "rate":
            return Grid(
                tuple(tuple(entry and entry / SECOND for entry in row) for row in parts[0].rows), parts[0].scalar
            )
        if name == "norm":
            return scalar(reduce(alike, parts[0]))
        if name == "conj":
            return parts[0]
        if name == "row":
            return Grid((tuple(entry for part in parts for entry in part),))
        if name == "samples":
            return self.letters["y_k"]
        if name == "exp":
            return exponential(parts[0])
        for part in parts:
            number(part, name)
        return filled((3, 3), ONE)


def exponential(A: Grid) -> Grid:
    """I + A + A A / 2 + ..."""
    number(Grid(tuple((row[i],) for i, row in enumerate(A.rows))), "exp")
    added(A, multiplied(A, A))
    return Grid(tuple(tuple(ONE if i == j else entry for j, entry in enumerate(row)) for i, row in enumerate(A.rows)))


def number(value: Grid, name: str) -> None:
    for entry in value:
        if entry is not None and entry.powers:
            raise Mismatch(f"{name} takes an angle or a number, not {entry}")


def alike(a: Entry, b: Entry) -> Entry:
    if a is None or b is None:
        return b if a is None else a
    if not a.like(b):
        raise Mismatch(f"{a} and {b}")
    return a if a.rad == b.rad else Unit(a.powers, None)


def added(a: Grid, b: Grid) -> Grid:
    if a.shape != b.shape:  # a lone 0, or 1x1 beside a scalar
        a, b = (b, a) if all(entry is None for entry in a) else (a, b)
        if not all(entry is None for entry in b):
            raise Mismatch(f"shapes {a.shape} and {b.shape}")
        return a
    rows = tuple(tuple(map(alike, x, y)) for x, y in zip(a.rows, b.rows, strict=True))
    return Grid(rows, a.scalar and b.scalar)


def times(a: Entry, b: Entry) -> Entry:
    return None if a is None or b is None else a * b


def multiplied(a: Grid, b: Grid) -> Grid:
    if a.scalar or b.scalar or (a.shape[1] != b.shape[0] and (1, 1) in (a.shape, b.shape)):
        one, other = (a, b) if a.shape == (1, 1) else (b, a)
        factor = one.rows[0][0]
        return Grid(tuple(tuple(times(factor, entry) for entry in row) for row in other.rows), a.scalar and b.scalar)
    if a.shape == b.shape == (4, 1):  # quaternions
        return filled((4,), times(reduce(alike, a), reduce(alike, b)))
    columns = tuple(zip(*b.rows, strict=True))
    return Grid(tuple(tuple(reduce(alike, map(times, row, column)) for column in columns) for row in a.rows))


def power(base: Grid, exponent: Any) -> Grid:
    if base.shape == (1, 1):
        (entry,) = base
        return scalar(None if entry is None else entry ** Fraction(int(exponent.p), int(exponent.q)))
    if exponent > 0:
        return reduce(multiplied, [base] * int(exponent))
    return Grid(tuple(tuple(entry and ONE / entry for entry in row) for row in base.T.rows))


def skew(v: Grid) -> Grid:
    x, y, z = v
    return Grid(((None, z, y), (z, None, x), (y, x, None)))


def assembled(rows: list[list[Grid]]) -> Grid:
    """A matrix of blocks; a lone 0 is a block of zeros."""
    heights = [max(block.shape[0] for block in row) for row in rows]
    widths = [max(block.shape[1] for block in column) for column in zip(*rows, strict=True)]
    made = []
    for row, height in zip(rows, heights, strict=True):
        blocks = [
            filled((height, width), None) if block.shape == (1, 1) != (height, width) else block
            for block, width in zip(row, widths, strict=True)
        ]
        made += [tuple(entry for block in blocks for entry in block.rows[i]) for i in range(height)]
    return Grid(tuple(made))


# ---------------------------------------------------------------- a paper


def grids(paper: Paper, letters: Iterable[Quantity]) -> dict[str, Grid]:
    """Of each letter whose units are known."""
    found = {one.symbol.name: one for one in letters}
    units = inferred(paper)
    known = {name: of_letter(paper.units, one) for name, one in found.items() if paper.units.get(name) != UNKNOWN}
    return known | {name: units[name] for name in found.keys() & units.keys()}


@cache
def inferred(paper: Paper) -> dict[str, Grid]:
    """Units of letters of which none are said, by the equations in which they stand alone on the left."""
    known: dict[str, Grid] = {}
    open_ = {name for name, text in paper.units.items() if text == UNKNOWN}
    again = bool(open_)
    while again:
        again = False
        for one in paper.equations:
            letters = {q.symbol.name: of_letter(paper.units, q) for q in one.alphabet if q.symbol.name not in open_}
            for relation in one.read():
                name = getattr(relation.sides[0], "name", "")
                if name in open_ - known.keys():
                    with suppress(Mismatch, LookupError, ValueError, TypeError):
                        known[name] = Terms(letters | known)(relation.sides[1])
                        again = True
    return known


def misfits(paper: Paper) -> tuple[int, list[tuple[str, str, str]]]:
    """How many relations there are, and of those that do not fit the equation, the line (0: the equation), and why."""
    count, found = 0, []
    for one in paper.equations:
        terms = Terms(grids(paper, one.alphabet))
        for at, _, relation in one.stated:
            count += 1
            try:
                for left, right in pairwise(relation.sides):
                    added(terms(left), terms(right))
            except Mismatch as error:
                found.append((one.number, at, str(error)))
            # shapes that do not fit, which the judge of numbers names; or a letter of which no unit is known
            except (LookupError, ValueError, TypeError):
                continue
    return count, found
