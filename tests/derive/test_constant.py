"""A named constant is a number to SymPy and to what is printed, and has a name, a unit and a meaning."""

import copy
import pickle

import numpy as np
import pytest
import sympy as sp
from flint import arb

from boresight import BoresightError
from boresight.codegen.functions.reference import evaluator
from boresight.derive.constant import behind, constant
from boresight.derive.expressions import numeric
from boresight.derive.mechanics import earth

x = sp.Symbol("x", real=True)
g = constant("g", "9.81", "m/s^2", "gravity")
w = constant("omega", 7.292115e-5, "rad/s", "a rate")
k = constant("k", w**2 / g, "1/m", "made of both")
FORM = sp.sqrt(2 * g * x**2) + k


@pytest.mark.parametrize("modules", ["numpy", "math", "mpmath"])
def test_a_constant_has_its_value_wherever_expressions_are_evaluated(modules):
    value = (2 * 9.81 * 4) ** 0.5 + 7.292115e-5**2 / 9.81
    assert FORM.free_symbols == {x}
    assert float(FORM.subs(x, 2)) == pytest.approx(value, rel=1e-15)
    assert float(sp.lambdify(x, FORM, modules)(2.0)) == pytest.approx(value, rel=1e-15)
    assert sp.lambdify(x, FORM, "numpy", cse=True)(np.array([2.0]))[0] == pytest.approx(value, rel=1e-15)
    (entries,) = evaluator([x], [sp.Matrix([FORM])])([2.0])
    assert abs(entries[0, 0] - (arb("78.48").sqrt() + arb("7.292115e-5") ** 2 / arb("9.81"))) < 1e-14


def test_a_float_is_taken_for_the_decimal_number_that_it_shows():
    assert w.exact == sp.Rational("7.292115e-5")
    assert constant("f", "1/298.257223563", "1", "").exact == 1 / sp.Rational("298.257223563")


def test_numbers_stand_for_constants_in_what_is_printed_and_nothing_else_changes():
    plain = sp.Matrix([sp.sin(x) / 3])
    assert numeric(plain) is plain
    assert numeric(sp.Matrix([2 * g * x + k])) == sp.Matrix([sp.Rational("19.62") * x + k.exact])
    assert str(FORM) == "sqrt(2)*sqrt(g)*Abs(x) + k"


def test_a_constant_is_the_same_after_a_copy_and_another_value_is_another_constant():
    assert pickle.loads(pickle.dumps(FORM)) == copy.deepcopy(FORM) == FORM
    assert constant("g", "9.81", "m/s^2", "gravity") == g != constant("g", "9.80", "m/s^2", "gravity")
    assert g not in (w, sp.Rational("9.81"), constant("g", "9.81", "rad", "gravity"))


def test_a_constant_comes_after_those_that_its_value_is_made_of():
    assert [one.name for one in behind([k])] == ["g", "omega", "k"]
    found = [one.name for one in behind([earth.SOMIGLIANA, earth.CENTRIFUGAL_RATIO])]
    assert found == ["f_ell", "g_e", "g_p", "k", "GM", "a", "omega_ie", "m"]


@pytest.mark.parametrize("value", [0, "0", float("nan"), float("inf"), "x", x, None, sp.I])
def test_a_value_that_is_no_number_or_zero_is_refused(value):
    with pytest.raises(BoresightError, match=r"test_constant\.py:\d+: the constant c is "):
        constant("c", value, "1", "nothing")
