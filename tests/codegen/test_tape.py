"""From SymPy to an instruction list: same values, shared reciprocals, an error bound that holds and is not loose."""

import casadi as ca
import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from boresight import BoresightError
from boresight.codegen.functions.convert import to_casadi
from boresight.codegen.functions.tape import COMPUTE, LIBRARY, carried, evaluate, share_reciprocals, tape

x, y, z = symbols = sp.symbols("x y z", real=True)
EXPRESSIONS = [
    x * y / z + y / z - 1 / z,
    sp.sqrt(x**2 + y**2) * sp.sin(z) ** 3,
    sp.tan(x) * sp.cos(y) - sp.atan2(x, z),
    (x + y) ** sp.Rational(3, 2) / (x + z) ** sp.Rational(1, 2),
    sp.Abs(x - y) * sp.pi + sp.Rational(1, 3) * z**-3,
    sp.Piecewise((x - 2, x > 1), (x + 2, x < sp.Rational(1, 2)), (x, True)),
    x**5 - (y / 2) ** 19,
    sp.exp(-x * y) - sp.log(z, 10) + (x + y) ** z - y ** sp.Rational(1, 3) + 3.0**x + x**2.0,
    sp.asin(x / 3) + sp.acos(y / z / 20) * sp.atan(x - y),
    sp.sinh(x - y) * sp.tanh(y - z) + sp.cosh(z),
    sp.Max(x, y, 1) * sp.sign(y - z) - sp.Min(z, sp.Rational(4, 3)),
]


def function(*expressions, cse=True):
    vector = ca.SX.sym("v", 3)
    (matrix,) = to_casadi([sp.Matrix(expressions)], {s: vector[i] for i, s in enumerate(symbols)})
    return ca.Function("f", [vector], [ca.densify(matrix)], {"cse": cse})


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_conversion_keeps_the_value_and_the_bound_holds(expression):
    rng = np.random.default_rng(1)
    points = rng.uniform(0.2, 2.0, (200, 3))
    program = tape(share_reciprocals(function(expression)))
    values, bounds = evaluate(program, [points])
    exact = sp.lambdify(symbols, expression, "mpmath")
    with mp.workdps(50):
        errors = np.array([
            float(abs(mp.mpf(v) - exact(*map(mp.mpf, p)))) for v, p in zip(values[0], points, strict=True)
        ])  # fmt: skip
    assert (errors <= bounds[0]).all()
    assert bounds[0].max() < 1e-12  # a bound that proves nothing would pass the line above


@pytest.mark.parametrize("op", sorted(LIBRARY))
def test_a_function_moves_by_what_is_said_at_most(op):
    """Where its argument moves to either side; and the bound is not twice that where it moves by little."""
    rng = np.random.default_rng(2)
    x = rng.uniform(0.05, 0.95, 500) * (1 if op == "log" else rng.choice([-1, 1], 500))
    exact = np.vectorize(lambda v: float(getattr(mp, op)(mp.mpf(v))))
    for by in (1e-6, 0.04):
        value = COMPUTE[op](x)
        moved = np.maximum(*(abs(exact(x + sign * by) - value) for sign in (-1, 1)))
        bound = carried(op, x, value, np.full(500, by))
        assert (moved <= bound * (1 + 1e-9)).all()
        assert by > 1e-3 or (bound <= 2 * moved + 2 * by * by).all()


def test_an_argument_that_may_leave_the_domain_has_no_bound():
    for op, x in (("log", 1e-9), ("asin", 1 - 1e-9), ("acos", 1e-9 - 1)):
        at = np.array([x])
        with np.errstate(divide="ignore"):
            assert np.isinf(carried(op, at, COMPUTE[op](at), np.array([1e-8])))


def test_a_shared_divisor_is_inverted_once():
    f = function(*(s / (x + y + 3) for s in symbols), 1 / (x + y + 3))
    before, after = tape(f), tape(share_reciprocals(f))
    assert sum(step.op in ("div", "inv") for step in before.steps) == 4
    assert sum(step.op in ("div", "inv") for step in after.steps) == 1
    point = [np.array([[0.3, -0.7, 1.1]])]
    np.testing.assert_allclose(evaluate(after, point)[0], evaluate(before, point)[0], rtol=4e-16)


def test_choices_survive_the_rebuild():
    f = function(sp.Piecewise((x / z, y > 0), (y / z, True)))
    program = tape(share_reciprocals(f))
    assert sum(step.op == "if_else_zero" for step in program.steps) == 2
    values, _ = evaluate(program, [np.array([[6.0, 1.0, 2.0], [6.0, -1.0, 2.0]])])
    assert values[0].tolist() == [3.0, -0.5]


def test_simplification_is_left_switched_on():
    before = ca.GlobalOptions.getSimplificationOnTheFly()
    share_reciprocals(function(x / z, y / z))
    assert ca.GlobalOptions.getSimplificationOnTheFly() == before


@pytest.mark.parametrize(
    ("expression", "said"),
    [
        (sp.erf(x), "erf in erf.x. is no operation of flight C, which has"),
        (sp.Mod(x, y), "Mod"),
        (sp.Integer(-2) ** x, "positive"),
        (x * sp.asin(3), "asin.3. is no real number"),
        (sp.Symbol("w"), "w"),
    ],
)
def test_what_flight_c_does_not_have_is_refused_by_name(expression, said):
    with pytest.raises(BoresightError, match=said):
        function(expression)


def test_the_hash_is_of_operations_alone():
    assert tape(function(x * y + z)).hash() == tape(function(x * y + z)).hash()
    assert tape(function(x * y + z)).hash() != tape(function(x * y - z)).hash()
    assert tape(function(2 * x)).hash() != tape(function(3 * x)).hash()
