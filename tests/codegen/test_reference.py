"""The 50-digit evaluator of verify and of the golden vectors, against SymPy's own arbitrary precision."""

import pytest
import sympy as sp
from flint import arb

from boresight import BoresightError
from boresight.codegen.functions.reference import evaluator, precise

x, y = sp.symbols("x y", real=True)
EXPRESSIONS = sp.Matrix(
    [
        sp.Piecewise((x / y, y > 0), (sp.Abs(x), True)),
        sp.Float(0.1) * x - sp.Rational(1, 3) / y**2,
        sp.sqrt(x * x + y * y) ** 3 + 1 / sp.sqrt(2 + x),
        sp.atan2(x, -y) + sp.tan(x) * sp.sin(y) - sp.cos(sp.pi * x),
        sp.exp(-x) * sp.log(2 + y) - (x + 2) ** (y / 3) + (2 + y) ** sp.Rational(7, 3) + sp.E,
        sp.asin(x / 4) - sp.acos(y / 2) * sp.atan(x) + (x - y) ** 19,
        sp.sinh(x) * sp.cosh(y) - sp.tanh(x - y),
        sp.Max(x, y, 0) * sp.Min(sp.sin(x), y) + sp.sign(x - y) * x**2.0,
    ]
)


POINTS = [("0.3", "0.7"), ("2", "-1.25"), ("-1.5", "1e-20")]


def theirs(expression, point):
    """SymPy's own value at a point of doubles; it would calculate with a Float's own fifteen digits."""
    rational = expression.replace(lambda e: e.is_Float, lambda e: sp.Rational(float(e)))
    exact = {s: sp.Rational(float(v)) for s, v in zip((x, y), point, strict=True)}
    return arb(str(sp.N(rational.subs(exact), 65)))


def agree(found, expected):
    with precise():
        assert abs(found - expected) < arb("1e-59") * max(1, abs(float(expected)))
        assert found.rad() < arb("1e-60") * max(1, abs(float(expected)))


@pytest.mark.parametrize("point", POINTS)
def test_every_operation_is_right_to_fifty_digits(point):
    (got,) = evaluator([x, y], [EXPRESSIONS])([float(v) for v in point])
    for i, expression in enumerate(EXPRESSIONS):
        with precise():
            agree(got[i, 0], theirs(expression, point))


@pytest.mark.parametrize("point", POINTS)
def test_every_derivative_is_right_to_fifty_digits(point):
    (got,) = evaluator([x, y], [EXPRESSIONS], by=[x, y])([float(v) for v in point])
    for i, expression in enumerate(EXPRESSIONS):
        for j, symbol in enumerate((x, y)):
            with precise():
                agree(got.get((i, j), arb(0)), theirs(expression.diff(symbol), point))


def test_the_square_of_zero_is_zero():
    (got,) = evaluator([x], [sp.Matrix([x**2 + sp.sqrt(x)])])([0.0])
    assert got == {}


def test_a_quotient_by_zero_is_no_number():
    (got,) = evaluator([x], [sp.Matrix([1 / x])])([0.0])
    assert not got[0, 0].is_finite()


def test_what_c_has_not_is_refused_by_name():
    with pytest.raises(BoresightError, match="erf"):
        evaluator([x], [sp.Matrix([sp.erf(x)])])
