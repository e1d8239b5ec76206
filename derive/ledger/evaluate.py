"""The value of an expression at a point, where every letter has one."""

from collections import ChainMap
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from functools import reduce
from itertools import pairwise
from math import prod
from typing import Any

from flint import arb, fmpq
from sympy import (
    Add,
    Function,
    MatAdd,
    MatMul,
    Mul,
    Pow,
    S,
    StrictLessThan,
    Symbol,
    acos,
    asin,
    atan,
    atan2,
    cos,
    cosh,
    exp,
    log,
    sin,
    sinh,
    tan,
    tanh,
)
from sympy.core.function import AppliedUndef
from sympy.functions.elementary.complexes import transpose
from sympy.matrices import MatrixBase

from boresight.derive.constant import Constant
from boresight.derive.ledger import numbers
from boresight.derive.ledger.numbers import Matrix, entries, zeros
from boresight.derive.ledger.rates import RATE, rate_of
from boresight.derive.ledger.witness import hamilton, skew, vector
from boresight.derive.named import Named

DIGITS = 60  # of which cancellation leaves the 28 that are asked for, and the balls prove it

Value = Any  # a fraction, a ball or a Matrix

_ELEMENTARY: dict[type[Function], Callable] = {
    atan2: numbers.atan2,
    **{one: getattr(numbers, one.__name__) for one in (sin, cos, tan, asin, acos, atan, exp, log, sinh, cosh, tanh)},
}


@dataclass(frozen=True)
class Point:
    """Values of the letters, by name, and what has been computed from them: mutants of one formula share most of it."""

    values: Mapping[str, Any]
    memo: dict = field(default_factory=dict, compare=False, repr=False)

    def changed(self, values: Mapping[str, Any]) -> "Point":
        """The point with other values of some letters; free values follow their changes."""
        if hasattr(self.values, "changed"):
            return Point(self.values.changed(values))
        return Point(ChainMap(dict(values), self.values))  # type: ignore[arg-type]


def evaluate(expression, point: Point) -> Value:
    """The value of an expression at a point, a number or a matrix.

    Raises ValueError where shapes do not fit, KeyError on a letter without a value.
    """
    if expression not in point.memo:
        point.memo[expression] = _evaluate(expression, point)
    return point.memo[expression]


def _evaluate(expression, point: Point) -> Value:
    if isinstance(expression, Symbol):
        return point.values[expression.name]
    if isinstance(expression, Constant):
        return evaluate(expression.exact, point)
    if isinstance(expression, Named):
        return evaluate(expression.value, point)
    if expression in (S.ComplexInfinity, S.NaN, S.Infinity, S.NegativeInfinity):
        raise ValueError("a quotient by zero")
    if expression.is_Number:
        return fmpq(int(expression.p), int(expression.q))
    if isinstance(expression, MatrixBase):
        rows, columns = expression.shape
        return assembled([[evaluate(expression[i, j], point) for j in range(columns)] for i in range(rows)])
    if isinstance(expression, AppliedUndef) and expression.func.__name__ == "Σ":
        # The world's Σ gives the letters at each sample.
        parts = [evaluate(expression.args[0], Point(values)) for values in point.values["Σ"](point.values)]
        if not parts:
            raise ValueError("a sum over no sample")
        return reduce(_sum, parts)
    if isinstance(expression, AppliedUndef) and expression.func.__name__ == "E":
        return _expected(expression.args[0], point)
    if isinstance(expression, AppliedUndef) and expression.func == RATE:
        return evaluate(rate_of(expression.args[0]), point)
    arguments = [evaluate(argument, point) for argument in expression.args]
    if isinstance(expression, AppliedUndef):
        return _applied(expression.func.__name__, arguments, point)
    if isinstance(expression, Add | MatAdd):
        return reduce(_sum, arguments)
    if isinstance(expression, Mul | MatMul):
        return reduce(multiplied, arguments)
    if isinstance(expression, transpose):
        return arguments[0].T if isinstance(arguments[0], Matrix) else arguments[0]
    if isinstance(expression, Pow):
        return power(arguments[0], expression.exp)
    if isinstance(expression, StrictLessThan):
        return _bounded(*arguments)
    arguments = [_scalar(argument) for argument in arguments]
    if any(isinstance(argument, Matrix) for argument in arguments):
        raise ValueError(f"{expression.func.__name__} of shape {_shape(arguments[0])}")
    return _ELEMENTARY[expression.func](*arguments)


def _applied(name: str, arguments: list, point: Point) -> Value:
    if name not in OPERATORS:
        if name in ("max", "min") and name not in point.values:
            return numbers.extreme(name, *arguments)
        return point.values[name](*arguments)
    try:
        return OPERATORS[name](*arguments)
    except (TypeError, AttributeError, IndexError):  # of a scalar where a vector is wanted, or of another shape
        raise ValueError(f"{name} of shape {' and '.join(str(_shape(a)) for a in arguments)}") from None


def _vee(M: Matrix) -> Matrix:
    """The vector of the skew-symmetric part."""
    return vector(M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]) / 2


OPERATORS: dict[str, Callable] = {
    "skew": skew,
    "vee": _vee,
    "cross": lambda a, b: skew(a) * b,
    "entry": lambda M, i, j: M[int(i) - 1, int(j) - 1],
    "norm": numbers.norm,
    "conj": lambda q: vector(q[0], -q[1], -q[2], -q[3]),
    "exp": lambda A: A.exp() if isinstance(A, Matrix) else arb(A).exp(),
}


def _expected(expression, point: Point):
    """The expectation of what is at most quadratic in the random letters, from their second moments, exactly.

    point.values["random"] has, by letter or by letters together, the columns of a root of their covariance; the means
    are the letters' values, but for those in point.values["mean"].
    """
    middle = point.changed(point.values.get("mean", {}))
    result = mean = evaluate(expression, middle)
    for names, columns in point.values["random"].items():
        names, columns = (names, columns) if isinstance(names, tuple) else ((names,), [(one,) for one in columns])
        for column in columns if _reads(expression, names, point) else ():
            for sign in (1, -1):
                moved = {name: middle.values[name] + part * sign for name, part in zip(names, column, strict=True)}
                result = _sum(result, (evaluate(expression, middle.changed(moved)) - mean) / 2)
    return result


def _reads(expression, names: Collection[str], point: Point) -> bool:
    """Whether a letter of the expression is one of these, or follows one."""
    follows = getattr(point.values, "follows", lambda name, letters: False)
    return any(symbol.name in names or follows(symbol.name, names) for symbol in expression.free_symbols)


def _bounded(value, limit):
    """The value, if it is a number below the limit."""
    if _shape(_scalar(value)) is not None:
        raise ValueError(f"a {value.rows}x{value.cols} matrix is compared with a number")
    if not _scalar(value) < limit:
        raise ValueError("it is not below its limit")
    return value


def assembled(rows) -> Matrix:
    """A matrix of numbers, or of blocks; a lone 0 is a block of zeros.  Raises ValueError if they do not fit."""
    if not any(isinstance(entry, Matrix) for row in rows for entry in row):
        return Matrix(rows)

    def extent(line, axis: int) -> int:
        sizes = {(_shape(entry) or (1, 1))[axis] for entry in line if _shape(entry) or entry != 0} or {1}
        if len(sizes) > 1:
            what = ("rows stand side by side", "columns stand over one another")[axis]
            raise ValueError(f"blocks of {' and '.join(map(str, sorted(sizes)))} {what}")
        return sizes.pop()

    heights = [extent(row, 0) for row in rows]
    widths = [extent(column, 1) for column in zip(*rows, strict=True)]
    result, top = zeros(sum(heights), sum(widths)), 0
    for row, height in zip(rows, heights, strict=True):
        left = 0
        for entry, width in zip(row, widths, strict=True):
            if _shape(entry) or entry != 0:
                result[top : top + height, left : left + width] = entry
            left += width
        top += height
    return result


def _shape(value) -> tuple[int, int] | None:
    return (value.rows, value.cols) if isinstance(value, Matrix) else None


def _scalar(value):
    return value[0] if _shape(value) == (1, 1) else value


def _sum(a, b):
    a, b = _scalar(a), _scalar(b)
    if _shape(a) != _shape(b):
        raise ValueError(f"a sum of shapes {_shape(a)} and {_shape(b)}")
    return a + b


def multiplied(a, b):
    if _shape(a) == _shape(b) == (4, 1):
        return hamilton(a, b)
    if isinstance(a, Matrix) and isinstance(b, Matrix) and a.cols != b.rows:
        a, b = _scalar(a), _scalar(b)  # (x^T y) z
        if isinstance(a, Matrix) and isinstance(b, Matrix):
            raise ValueError(f"a product of shapes {_shape(a)} and {_shape(b)}")
    return a * b


def power(base, exponent):
    if not exponent.is_Integer:
        base = _scalar(base)
        if isinstance(base, Matrix):
            raise ValueError(f"a root of shape {_shape(base)}")
        return arb(base) ** arb(fmpq(int(exponent.p), int(exponent.q)))
    # Multiplied out: FLINT's own power of a ball at zero knows nothing.
    result = reduce(multiplied, [base] * abs(int(exponent)))
    if exponent > 0 or not isinstance(result, Matrix):
        return result if exponent > 0 else 1 / result
    if _shape(result) == (4, 1):  # a quaternion
        return OPERATORS["conj"](result) / sum(entry * entry for entry in result)
    return result.inv()


def residual(sides, point: Point) -> list:
    """The differences of neighbouring sides, entry by entry.

    Raises ValueError if their shapes differ; a lone 0 equals a zero of any shape.
    """
    result: list = []
    for left, right in pairwise(sides):
        a, b = _scalar(evaluate(left, point)), _scalar(evaluate(right, point))
        if right == 0:
            difference = a
        elif _shape(a) != _shape(b):
            raise ValueError(f"shapes {_shape(a)} and {_shape(b)} are set equal")
        else:
            difference = a - b
        result += entries(difference)
    return result


def solve(relations, unknown: Mapping[str, Any], values: Mapping[str, Any]) -> dict:
    """Values of the letters which linear relations define; `unknown` has the number of components or the shape of each.

    Raises ValueError or ZeroDivisionError where the relations do not determine them.
    """
    shapes = {name: (shape if isinstance(shape, tuple) else (shape,)) for name, shape in unknown.items()}
    count, known = sum(map(prod, shapes.values())), Point(values)

    def trial(parts) -> dict:
        rest, result = list(parts), {}
        for name, shape in shapes.items():
            own, rest = rest[: prod(shape)], rest[prod(shape) :]
            columns = (*shape, 1)[1]
            rows = [own[i : i + columns] for i in range(0, len(own), columns)]
            result[name] = own[0] if len(own) == 1 else Matrix(rows)
        return result

    def remainder(parts) -> Matrix:
        at = known.changed(trial(parts))
        return Matrix([entry for relation in relations for entry in residual(relation.sides, at)])

    origin = remainder([fmpq(0)] * count)
    if origin.rows != count:
        raise ValueError("a definition must have as many rows as it defines letters")
    columns = [remainder([fmpq(int(i == j)) for i in range(count)]) - origin for j in range(count)]
    jacobian = Matrix([list(row) for row in zip(*columns, strict=True)])
    return trial(list(jacobian.solve(-origin)))
