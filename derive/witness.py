"""Numbers for every letter of an equation, from finite rotations, and the value of an expression at them.

Rotations here are sums of the power series of a skew matrix, in many digits; angles and rotation vectors are read back
from the matrices.  None of the formulas that a paper prints is used to make the numbers which judge it.
"""

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import reduce
from itertools import pairwise
from typing import Any

import mpmath as mp
from sympy import Add, Function, MatAdd, MatMul, Mul, Pow, StrictLessThan, Symbol, cos, sin, tan
from sympy.core.function import AppliedUndef
from sympy.functions.elementary.complexes import transpose
from sympy.matrices import MatrixBase

DIGITS = 50

Value = Any  # mp.mpf or mp.matrix: mpmath has no types

_ELEMENTARY: dict[type[Function], Callable] = {sin: mp.sin, cos: mp.cos, tan: mp.tan}


def vector(*entries) -> mp.matrix:
    return mp.matrix([[entry] for entry in entries])


def uniform(generator: random.Random, size) -> mp.matrix:
    """A 3-vector with components drawn from [-size, size]; `size` a number or three."""
    sizes = size if isinstance(size, tuple) else (size,) * 3
    return vector(*(mp.mpf(s) * mp.mpf(generator.uniform(-1, 1)) for s in sizes))


def skew(v) -> mp.matrix:
    return mp.matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def finite_rotation(v) -> mp.matrix:
    """exp([v x]): the power series of repeated cross products with v, on the three axes."""
    x, y, z = v
    columns = []
    for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)):
        term = result = tuple(mp.mpf(part) for part in axis)
        k = 0
        while any(term) and max(map(abs, term)) > mp.eps / 1000:
            k += 1
            a, b, c = term
            term = ((y * c - z * b) / k, (z * a - x * c) / k, (x * b - y * a) / k)
            result = tuple(r + t for r, t in zip(result, term, strict=True))
        columns.append(result)
    return mp.matrix(columns).T


def rotation_vector(C) -> mp.matrix:
    """The vector v, |v| < pi, with C = exp([v x])."""
    v = vector(C[2, 1] - C[1, 2], C[0, 2] - C[2, 0], C[1, 0] - C[0, 1]) / 2
    sine = mp.norm(v)
    return v if sine == 0 else v * (mp.atan2(sine, (C[0, 0] + C[1, 1] + C[2, 2] - 1) / 2) / sine)


def attitude(euler) -> mp.matrix:
    """C_b2n of roll, pitch, yaw: three finite rotations about the axes."""
    roll, pitch, yaw = euler
    return finite_rotation([0, 0, yaw]) * finite_rotation([0, pitch, 0]) * finite_rotation([roll, 0, 0])


def angles(C) -> mp.matrix:
    """Roll, pitch, yaw of C_b2n."""
    return vector(mp.atan2(C[2, 1], C[2, 2]), mp.asin(-C[2, 0]), mp.atan2(C[1, 0], C[0, 0]))


def quaternion(C) -> mp.matrix:
    """[w, x, y, z], w > 0, from the entries of a rotation that is no half turn: 4 w^2 = 1 + trace."""
    w = mp.sqrt(1 + C[0, 0] + C[1, 1] + C[2, 2]) / 2
    return vector(w, *((C[i, j] - C[j, i]) / (4 * w) for i, j in ((2, 1), (0, 2), (1, 0))))


def hamilton(p, q) -> mp.matrix:
    """The quaternion product, from scalar and vector parts."""
    u, v = p[1:4, 0], q[1:4, 0]
    turned = skew(u) * v + p[0] * v + q[0] * u
    return vector(p[0] * q[0] - (u.T * v)[0], *turned)


def rate(function: Callable) -> mp.matrix:
    """The derivative at zero of a matrix function of time, central difference: 30 digits of the 50."""
    step = mp.mpf(10) ** -16
    return (function(step) - function(-step)) / (2 * step)


@dataclass(frozen=True)
class Point:
    """Values of the letters, by name, and what has been computed from them: mutants of one formula share most of it."""

    values: Mapping[str, Any]
    memo: dict = field(default_factory=dict, compare=False, repr=False)


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
    if expression.is_Number:
        return mp.mpf(int(expression.p)) / int(expression.q)
    if isinstance(expression, MatrixBase):
        rows, columns = expression.shape
        return _assembled([[evaluate(expression[i, j], point) for j in range(columns)] for i in range(rows)])
    if isinstance(expression, AppliedUndef) and expression.func.__name__ == "Σ":
        # The world's Σ gives the letters at each sample.
        parts = [evaluate(expression.args[0], Point(values)) for values in point.values["Σ"](point.values)]
        if not parts:
            raise ValueError("a sum over no sample")
        return reduce(_sum, parts)
    arguments = [evaluate(argument, point) for argument in expression.args]
    if isinstance(expression, AppliedUndef):
        return point.values[expression.func.__name__](*arguments)
    if isinstance(expression, Add | MatAdd):
        return reduce(_sum, arguments)
    if isinstance(expression, Mul | MatMul):
        return reduce(_product, arguments)
    if isinstance(expression, transpose):
        return arguments[0].T
    if isinstance(expression, Pow):
        exponent = expression.exp
        return arguments[0] ** (int(exponent) if exponent.is_Integer else arguments[1])
    if isinstance(expression, StrictLessThan):
        return _bounded(*arguments)
    return _ELEMENTARY[expression.func](*arguments)


def _bounded(value, limit):
    """The value, if it is a number below the limit."""
    if _shape(_scalar(value)) is not None:
        raise ValueError(f"a {value.rows}x{value.cols} matrix is compared with a number")
    if not _scalar(value) < limit:
        raise ValueError("it is not below its limit")
    return value


def _assembled(rows) -> mp.matrix:
    """A matrix of numbers, or of blocks; a lone 0 is a block of zeros.  Raises ValueError if they do not fit."""
    if not any(isinstance(entry, mp.matrix) for row in rows for entry in row):
        return mp.matrix(rows)

    def extent(entries, axis: int) -> int:
        sizes = {(_shape(entry) or (1, 1))[axis] for entry in entries if _shape(entry) or entry != 0} or {1}
        if len(sizes) > 1:
            what = ("rows stand side by side", "columns stand over one another")[axis]
            raise ValueError(f"blocks of {' and '.join(map(str, sorted(sizes)))} {what}")
        return sizes.pop()

    heights = [extent(row, 0) for row in rows]
    widths = [extent(entries, 1) for entries in zip(*rows, strict=True)]
    result = mp.zeros(sum(heights), sum(widths))
    for i, row in enumerate(rows):
        for j, entry in enumerate(row):
            if _shape(entry) or entry != 0:
                block = entry if _shape(entry) else mp.matrix([[entry]])
                for a in range(heights[i]):
                    for b in range(widths[j]):
                        result[sum(heights[:i]) + a, sum(widths[:j]) + b] = block[a, b]
    return result


def _shape(value) -> tuple[int, int] | None:
    return (value.rows, value.cols) if isinstance(value, mp.matrix) else None


def _scalar(value):
    return value[0] if _shape(value) == (1, 1) else value


def _sum(a, b):
    a, b = _scalar(a), _scalar(b)
    if _shape(a) != _shape(b):
        raise ValueError(f"a sum of shapes {_shape(a)} and {_shape(b)}")
    return a + b


def _product(a, b):
    if _shape(a) == _shape(b) == (4, 1):
        return hamilton(a, b)
    if isinstance(a, mp.matrix) and isinstance(b, mp.matrix) and a.cols != b.rows:
        raise ValueError(f"a product of shapes {_shape(a)} and {_shape(b)}")
    return a * b


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
        result += list(difference) if isinstance(difference, mp.matrix) else [difference]
    return result


def solve(relations, unknown: Mapping[str, int], values: Mapping[str, object]) -> dict:
    """Values of the letters which linear relations define; `unknown` has the number of components of each.

    Raises ValueError or ZeroDivisionError where the relations do not determine them.
    """
    count = sum(unknown.values())

    def trial(parts) -> dict:
        rest, result = list(parts), dict(values)
        for name, size in unknown.items():
            result[name] = rest[0] if size == 1 else vector(*rest[:size])
            rest = rest[size:]
        return result

    def remainder(parts) -> mp.matrix:
        at = Point(trial(parts))
        return mp.matrix([entry for relation in relations for entry in residual(relation.sides, at)])

    origin = remainder([mp.mpf(0)] * count)
    if origin.rows != count:
        raise ValueError("a definition must have as many rows as it defines letters")
    columns = [remainder([mp.mpf(i == j) for i in range(count)]) - origin for j in range(count)]
    jacobian = mp.matrix(count, count)
    for j, change in enumerate(columns):
        jacobian[:, j] = change
    try:
        found = trial(list(mp.lu_solve(jacobian, -origin)))
    except TypeError:  # mpmath finds no pivot in a column of zeros
        raise ZeroDivisionError("the relations leave a letter open") from None
    return {name: found[name] for name in unknown}
