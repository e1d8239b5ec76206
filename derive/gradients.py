"""Derivatives of expressions in which much is held many times, and what is left of rotations by nothing."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import sympy as sp
from sympy import Matrix, S, Symbol

from boresight.derive.expressions import constants_in, substituted
from boresight.derive.mechanics.rotation import TINY_SQUARE
from boresight.derive.named import Named, Quantity, quantity

Slopes = dict[Symbol, Any]
BY = "_by_"  # in the name of a derivative


class Gradients:
    """The derivatives of expressions; what is held many times is differentiated once.

    seeds: those of the symbols, each by itself where only symbols are given.  short: how to write those of polynomials.
    """

    def __init__(self, seeds: Iterable[Symbol] | Mapping[Symbol, Slopes], short: Callable[[Any], Any] | None = None):
        self.seeds = seeds if isinstance(seeds, Mapping) else {s: {s: S.One} for s in seeds}
        self.short = short
        self.known: dict[Any, Slopes] = {}
        self.quantities: dict[Quantity, list[Slopes]] = {}

    def __call__(self, column: Matrix, by: Sequence[Symbol]) -> Matrix:
        """The Jacobian of a column."""
        rows = [self.slopes(entry) for entry in column]
        return Matrix(len(rows), len(by), [row.get(s, S.Zero) for row in rows for s in by])

    def slopes(self, e: Any) -> Slopes:
        if e not in self.known:
            found = self.found(e)
            if self.short and polynomial(e):
                found = {s: slope for s, by in found.items() if (slope := self.short(by)) != 0}
            self.known[e] = found
        return self.known[e]

    def found(self, e: Any) -> Slopes:
        if e.is_Symbol:
            return dict(self.seeds.get(e, {}))
        if isinstance(e, Named):
            return self.of_quantity(e.quantity)[e.index]
        if e.is_Add:
            return self.total((S.One, self.slopes(part)) for part in e.args)
        if e.is_Mul:
            rest = [sp.Mul(*(p for k, p in enumerate(e.args) if k != i)) for i in range(len(e.args))]
            return self.total(zip(rest, map(self.slopes, e.args), strict=True))
        if e.is_Pow and not self.slopes(e.exp):
            return self.total([(e.exp * e.base ** (e.exp - 1), self.slopes(e.base))])
        if isinstance(e, sp.Piecewise):
            parts = [(self.slopes(value), test) for value, test in e.args]
            by = dict.fromkeys(s for slopes, _ in parts for s in slopes)
            return {s: sp.Piecewise(*((slopes.get(s, S.Zero), test) for slopes, test in parts)) for s in by}
        if isinstance(e, sp.Max | sp.Min):
            first, *others = e.args
            other = e.func(*others)
            test = first > other if isinstance(e, sp.Max) else first < other
            return self.slopes(sp.Piecewise((first, test), (other, True)))
        if isinstance(e, sp.sign):
            return {}
        return self.total((e.fdiff(i + 1), self.slopes(part)) for i, part in enumerate(e.args) if self.slopes(part))

    def total(self, terms: Iterable[tuple[Any, Slopes]]) -> Slopes:
        sums: dict[Symbol, list[Any]] = {}
        for factor, slopes in terms:
            for s, slope in slopes.items():
                sums.setdefault(s, []).append(factor * slope)
        return {s: total for s, parts in sums.items() if (total := sp.Add(*parts)) != 0}

    def of_quantity(self, one: Quantity) -> list[Slopes]:
        """Slopes of all its entries: under a name of their own, where they are more than a polynomial of letters."""
        if one not in self.quantities:
            raw = [self.slopes(value) for value in one.value]
            by = dict.fromkeys(s for slopes in raw for s in slopes)
            made: list[Slopes] = [{} for _ in raw]
            for s in by:
                column = [slopes.get(s, S.Zero) for slopes in raw]
                if not all(map(polynomial, column)):
                    value = sp.ImmutableMatrix(*one.value.shape, column)
                    meaning = f"derivative of {one.name} by {s}"
                    column = list(quantity(f"{one.name}{BY}{s}", value, meaning, one.labels).entries)
                for slopes, entry in zip(made, column, strict=True):
                    if entry != 0:
                        slopes[s] = entry
            self.quantities[one] = made
        return self.quantities[one]


def polynomial(e: Any) -> bool:
    """Whether it is one of letters and names."""
    if e.is_Add or e.is_Mul:
        return all(map(polynomial, e.args))
    return not e.args or (e.is_Pow and e.exp.is_Integer and e.exp > 0 and polynomial(e.base))


def opened(matrix: Matrix) -> Matrix:
    """With polynomials themselves in the place of derivatives that have got a name."""

    def visit(e: Any) -> Any:
        if isinstance(e, Named):
            return visit(e.value) if BY in e.quantity.name and polynomial(e.value) else e
        args = tuple(map(visit, e.args))
        return e if args == e.args else e.func(*args)

    return matrix.applyfunc(visit)


def at_zero(matrix: Matrix, zero: Iterable[Symbol]) -> Matrix:
    """The matrix where these are zero, rotations by nothing being none at all."""
    return settled(substituted(matrix, dict.fromkeys(zero, S.Zero)))


def settled(matrix: Matrix) -> Matrix:
    """The matrix with numbers for what is left of TINY_SQUARE, in which a rotation by zero differs from 1 by 1e-30."""
    if TINY_SQUARE not in constants_in(matrix):
        return matrix
    known: dict[Any, Any] = {}

    def within(e: Any) -> bool:
        return TINY_SQUARE in constants_in([e])

    def visit(e: Any) -> Any:
        if e not in known:
            known[e] = inner(e)
        return known[e]

    def inner(e: Any) -> Any:
        if isinstance(e, Named):
            made = e.quantity.mapped(visit)
            entry = e.within(made)
            return entry
        if not e.args or not within(e):
            return e
        if not e.free_symbols and constants_in([e]) == {TINY_SQUARE}:
            return number(e)
        if e.is_Mul or e.is_Add:
            alone = [p for p in e.args if not p.free_symbols and constants_in([p]) == {TINY_SQUARE}]
            rest = [visit(p) for p in e.args if p not in alone]
            return e.func(number(e.func(*alone)), *rest) if alone else e.func(*rest)
        return e.func(*map(visit, e.args))

    return Matrix(*matrix.shape, [visit(e) for e in matrix])


def number(e: Any) -> Any:
    """A value that hangs on TINY_SQUARE alone, with what it is without it."""
    value = substituted(Matrix([e]), {TINY_SQUARE: TINY_SQUARE.exact}, names=False)[0].evalf(60)
    near = sp.nsimplify(value, rational=True, tolerance=sp.Float("1e-25"))
    return near if near != 0 and near.q <= 64 else e
