"""Numbers of the witness: FLINT's balls, which carry a bound of their own error, and matrices of them.

What is given is exact, a fraction; what is computed from it is a ball.  `middle` refuses a ball too wide to tell
anything, so digits lost by cancellation are never taken for a result.
"""

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import reduce
from math import isfinite
from typing import Any

import mpmath as mp
from flint import arb, arb_mat, ctx, fmpq
from mpmath.libmp import from_man_exp

from boresight import BoresightError

BITS = 99  # of a ball that is a result, some 1e-30: absolute below 1, relative above

digits = ctx.workdps  # with digits(50): balls are as narrow as 50 digits allow


class Matrix:
    """A matrix of balls; a vector is a column, and v[i] its entry."""

    __slots__ = ("balls",)

    def __init__(self, rows: Any):
        """rows: lists of entries, the entries of a column, or an arb_mat."""
        if not isinstance(rows, arb_mat):
            listed = [row if isinstance(row, list | tuple) else [row] for row in rows]
            rows = arb_mat(len(listed), len(listed[0]), [entry for row in listed for entry in row])
        self.balls = rows

    rows = property(lambda self: self.balls.nrows())
    cols = property(lambda self: self.balls.ncols())
    T = property(lambda self: Matrix(self.balls.transpose()))

    def __getitem__(self, at: Any) -> Any:
        if not isinstance(at, tuple):
            return self.balls[at, 0] if self.balls.ncols() == 1 else self.balls[0, at]
        i, j = at
        if isinstance(i, int) and isinstance(j, int):
            return self.balls[i, j]
        rows, columns = _indices(i, self.rows), _indices(j, self.cols)
        return Matrix(arb_mat(len(rows), len(columns), [self.balls[a, b] for a in rows for b in columns]))

    def __setitem__(self, at: tuple, block: Any) -> None:
        rows, columns = _indices(at[0], self.rows), _indices(at[1], self.cols)
        parts = iter(entries(block))
        for i in rows:
            for j in columns:
                self.balls[i, j] = next(parts)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.balls.entries())

    def __add__(self, other: "Matrix") -> "Matrix":
        return Matrix(self.balls + other.balls)

    def __sub__(self, other: "Matrix") -> "Matrix":
        return Matrix(self.balls - other.balls)

    def __neg__(self) -> "Matrix":
        return Matrix(-self.balls)

    def __mul__(self, other: Any) -> "Matrix":
        return Matrix(self.balls * (other.balls if isinstance(other, Matrix) else arb(other)))

    def __rmul__(self, other: Any) -> "Matrix":
        return self * other

    def __truediv__(self, other: Any) -> "Matrix":
        return Matrix(self.balls / arb(other))

    def inv(self) -> "Matrix":
        return Matrix(self.balls.inv())

    def det(self) -> Any:
        return self.balls.det()

    def solve(self, right: "Matrix") -> "Matrix":
        """The x of self x = right.  Raises ZeroDivisionError where the balls do not determine it."""
        return Matrix(self.balls.solve(right.balls))

    def copy(self) -> "Matrix":
        return Matrix(arb_mat(self.balls))

    def exp(self) -> "Matrix":
        return Matrix(self.balls.exp())


def _indices(at: Any, size: int) -> Sequence[int]:
    return (at,) if isinstance(at, int) else range(size)[at]


def zeros(rows: int, columns: int | None = None) -> Matrix:
    return Matrix(arb_mat(rows, rows if columns is None else columns))


def eye(size: int) -> Matrix:
    return Matrix([[int(i == j) for j in range(size)] for i in range(size)])


def exact(value: Any) -> fmpq:
    """A whole number, a float, a fraction or a decimal in a string, as it is."""
    if isinstance(value, fmpq):
        return value
    return fmpq(*(value if isinstance(value, int | float) else Fraction(value)).as_integer_ratio())


def pi() -> arb:
    return arb.pi()


def sin(x: Any) -> arb:
    return arb(x).sin()


def cos(x: Any) -> arb:
    return arb(x).cos()


def tan(x: Any) -> arb:
    return arb(x).tan()


def asin(x: Any) -> arb:
    return arb(x).asin()


def atan(x: Any) -> arb:
    return arb(x).atan()


def acos(x: Any) -> arb:
    return arb(x).acos()


def exp(x: Any) -> arb:
    return arb(x).exp()


def log(x: Any) -> arb:
    return arb(x).log()


def sinh(x: Any) -> arb:
    return arb(x).sinh()


def cosh(x: Any) -> arb:
    return arb(x).cosh()


def tanh(x: Any) -> arb:
    return arb(x).tanh()


def extreme(which: str, *numbers: Any) -> arb:
    """The largest or the smallest of numbers; which: "max" or "min"."""
    return reduce(lambda a, b: getattr(a, which)(b), map(arb, numbers))


def atan2(y: Any, x: Any) -> arb:
    return arb.atan2(arb(y), arb(x))


def sqrt(x: Any) -> arb:
    """Of a number that is not negative, though its ball may reach below zero."""
    return arb(x).nonnegative_part().sqrt()


def norm(x: Any) -> arb:
    """Euclidean, of a vector; the magnitude of a scalar."""
    return sqrt(sum(entry * entry for entry in x)) if isinstance(x, Matrix) else abs(x)


def middle(value: Any) -> mp.mpf:
    """The middle of a ball, exactly.

    Raises ZeroDivisionError if the value is not finite or too large to be known, BoresightError if the ball is too
    wide otherwise.
    """
    man, exp = _judged(value).man_exp()
    return mp.mp.make_mpf(from_man_exp(int(man), int(exp)))


def near(value: Any) -> Any:
    """The middle of a ball as a float, or exactly where no float is as large.  Raises as `middle` does."""
    found = float(_judged(value))
    return found if isfinite(found) else middle(value)


def entries(value: Any) -> list:
    """Of a matrix row by row; a number is its own."""
    return list(value) if isinstance(value, Matrix) else [value]


def middles(value: Any) -> list[mp.mpf]:
    """Of each entry.  Raises as `middle` does."""
    return [middle(entry) for entry in entries(value)]


def magnitude(value: Any) -> arb:
    """Of the middle of a ball, exactly.  Raises as `middle` does."""
    return abs(_judged(value))


def largest(values: Iterable[Any]) -> mp.mpf:
    """The largest magnitude.  Raises as `middle` does."""
    return middle(max(map(magnitude, values)))


def _judged(value: Any) -> arb:
    ball = arb(value)
    if not ball.is_finite():
        raise ZeroDivisionError("a value is not finite")
    if ball.rel_one_accuracy_bits() < BITS:
        if ball.rad() > 1:
            raise ZeroDivisionError("a value is too large to be known")
        raise BoresightError(f"a value is known to {float(ball.rad()):.0e} only: compute it with more digits")
    return ball.mid()


def shown(value: Any, count: int) -> str:
    """A value with `count` digits."""
    return mp.nstr(middle(value), count)
