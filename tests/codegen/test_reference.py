"""The 50-digit evaluator of verify and of the golden vectors, against SymPy's own arbitrary precision."""

import mpmath as mp
import pytest
import sympy as sp

from boresight import BoresightError
from boresight.codegen.functions.reference import evaluator

x, y = sp.symbols("x y", real=True)
EXPRESSIONS = sp.Matrix(
    [
        sp.Piecewise((x / y, y > 0), (sp.Abs(x), True)),
        sp.Float(0.1) * x - sp.Rational(1, 3) / y**2,
        sp.sqrt(x * x + y * y) ** 3 + 1 / sp.sqrt(2 + x),
        sp.atan2(x, -y) + sp.tan(x) * sp.sin(y) - sp.cos(sp.pi * x),
    ]
)


@pytest.mark.parametrize("point", [("0.3", "0.7"), ("2", "-1.25"), ("-1.5", "1e-20")])
def test_every_operation_is_right_to_fifty_digits(point):
    with mp.workdps(50):
        values = [mp.mpf(text) for text in point]
        (got,) = evaluator([x, y], [EXPRESSIONS])(values, 50)
        # SymPy would calculate with a Float's own fifteen digits
        exact = {sp.Float(0.1): sp.Rational(0.1)} | {
            s: sp.Rational(*mp_fraction(v)) for s, v in zip((x, y), values, strict=True)
        }
        for mine, expression in zip(got, EXPRESSIONS, strict=True):
            # SymPy would calculate with a Float's own fifteen digits
            rational = expression.replace(lambda e: e.is_Float, lambda e: sp.Rational(float(e)))
            theirs = mp.mpf(sp.N(rational.subs(exact), 60)._mpf_)
            assert abs(mine - theirs) <= mp.mpf(10) ** -49 * max(1, abs(theirs))


def mp_fraction(value):
    """Numerator and denominator of an mpf."""
    sign, man, exp, _ = value._mpf_
    man = -int(man) if sign else int(man)
    return (man << exp, 1) if exp >= 0 else (man, 1 << -exp)


def test_the_square_of_zero_is_zero():
    (got,) = evaluator([x], [sp.Matrix([x**2 + sp.sqrt(x)])])([mp.mpf(0)], 50)
    assert got[0] == 0


def test_a_quotient_by_zero_is_no_number():
    (got,) = evaluator([x], [sp.Matrix([1 / x])])([mp.mpf(0)], 50)
    assert not mp.isfinite(got[0])


def test_what_c_has_not_is_refused_by_name():
    with pytest.raises(BoresightError, match="exp"):
        evaluator([x], [sp.Matrix([sp.exp(x)])])
