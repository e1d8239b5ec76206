"""Names of quantities: to SymPy what they stand for, through everything that a model does with its expressions."""

import pickle

import mpmath
import numpy as np
import pytest
import sympy as sp

from boresight import BoresightError, constant, named
from boresight.codegen.text.equations import equations_text, read_equations
from boresight.derive.expressions import names_in, numeric, substituted, symbols_in, unnamed
from boresight.derive.mechanics.rotation import dcm_from_quaternion, skew
from boresight.derive.model import Function, Model, Output, Struct, variable

w, x, y, z = q = sp.symbols("q_w q_x q_y q_z", real=True)
PLAIN = dcm_from_quaternion(q)
C = named("C_b2n", PLAIN, "body to level")
f = sp.Matrix(sp.symbols("f_x f_y f_z", real=True))
POINT = dict(zip((*q, *f), (0.5, -0.5, 0.7, 0.1, 3.0, -2.0, 9.0), strict=True))


def test_a_name_is_what_it_stands_for_in_every_number():
    rate = C * f - skew(C * f) * C[:, 0]
    plain = PLAIN * f - skew(PLAIN * f) * PLAIN[:, 0]
    assert str(rate[0]).count("C_b2n_11") == 1 and unnamed(rate) == rate.doit() == plain
    for a, b in zip(rate, plain, strict=True):
        assert a.subs(POINT) == pytest.approx(float(b.subs(POINT)), rel=1e-14)
        assert a.evalf(30, subs=POINT) == pytest.approx(float(b.subs(POINT)), rel=1e-14)
        assert a.free_symbols == b.free_symbols and symbols_in([a]) == b.free_symbols
    for modules in ("math", "numpy", "mpmath"):
        given = [mpmath.mpf(v) if modules == "mpmath" else v for v in POINT.values()]
        found = sp.lambdify([*q, *f], list(rate), modules)(*given)
        assert np.allclose(np.array(found, float), [float(b.subs(POINT)) for b in plain], rtol=1e-14)


def test_derivatives_are_those_of_the_value_and_go_through_names_within_names():
    f_n = named("f_n", C * f, components="n e d")
    assert [str(one) for one in f_n] == ["f_n_n", "f_n_e", "f_n_d"]
    assert f_n.jacobian(f) == C  # of the named parts, by their names
    assert unnamed(f_n.jacobian(sp.Matrix(q)) - (PLAIN * f).jacobian(sp.Matrix(q))) == sp.zeros(3, 4)
    assert f_n[0].diff(sp.Symbol("t")) == 0


def test_a_substitution_goes_into_a_name_and_keeps_it():
    turned = {w: x + 1, x: y}
    for made in (C.subs(turned, simultaneous=True), C.xreplace(turned), substituted(C, turned)):
        assert [str(one) for one in made] == [str(one) for one in C]
        assert unnamed(made) == PLAIN.xreplace(turned)
    assert made != C and C.xreplace({f[0]: y}) == C
    assert C.xreplace({w: 1, x: 0, y: 0, z: 0}) == sp.eye(3)  # what is a number has no name


def test_what_is_a_number_or_a_symbol_has_no_name():
    level = named("omega", sp.Matrix([x, -y, 0, 2, x * y]))
    assert [str(one) for one in level] == ["q_x", "-q_y", "0", "2", "omega_5"]
    again = named("other", C[:, 0])
    assert again == C[:, 0]  # a name is not named once more


def test_equal_quantities_are_one():
    assert named("C_b2n", PLAIN, "body to level") == C
    assert named("D", PLAIN)[0] != C[0] and named("C_b2n", PLAIN.T, "body to level")[1] != C[1]
    assert pickle.loads(pickle.dumps(C * f)) == C * f
    assert C[0] - named("C_b2n", PLAIN, "body to level")[0] == 0


def test_constants_in_a_name_become_numbers():
    g = constant("g", "9.81", "m/s^2", "gravity")
    force = named("force", g * x)
    assert numeric(sp.Matrix([force + 1])) == sp.Matrix([sp.Rational(981, 100) * x + 1])
    (kept,) = names_in(numeric(sp.Matrix([force + 1]), names=True))
    assert kept.name == "force" and kept.value == sp.Rational(981, 100) * x


def test_names_within_names_cost_what_they_are_not_what_they_expand_to():
    """Sixty squares, each of the one before: expanded, 2^60 factors."""
    value = x + y
    for i in range(60):
        value = named(f"n_{i}", value * value + value)
    again = substituted(sp.Matrix([value]), {x: y, y: x})
    assert len(names_in(again)) == 60 and symbols_in(again) == {x, y}


@pytest.mark.parametrize(
    ("name", "value", "components", "words"),
    [
        ("2C", x * y, "", "cannot be a name in C"),
        ("C b", x * y, "", "cannot be a name in C"),
        ("C", sp.zeros(0, 0), "", "give an expression"),
        ("C", sp.Eq(x, y), "", "give an expression"),
        ("C", PLAIN, "x y z", "has 9 entries"),
    ],
)
def test_what_is_no_quantity_is_refused_at_its_line(name, value, components, words):
    with pytest.raises(BoresightError, match=rf"test_named\.py:\d+: .*{words}"):
        named(name, value, components=components)


def test_a_model_is_read_back_with_its_names_two_of_one_name_too():
    attitude = variable("q", "q_w q_x q_y q_z", "1", "attitude", -1, 1)
    force = variable("f", "f_x f_y f_z", "m/s^2", "force", -10, 10)
    f_n = named("f_n", C * f, "in the level", "n e d")
    other = named("f_n", C.T * f, "in the body", "n e d")
    model = Model(
        name="turn", c_prefix="tu", title="turn", frame="", states=(), measurements=(), card=(),
        structs=(Struct("given", "given", (attitude, force)),),
        functions=(Function("turn", "turn", (Output("out", f_n + 2 * other, "m/s^2", "force"),)),),
    )  # fmt: skip
    text = equations_text(model)
    back = read_equations(text, "turn").functions[0].outputs[0].value
    assert back == model.functions[0].outputs[0].value and equations_text(read_equations(text, "turn")) == text
    assert {one.quantity.meaning for one in names_in(back)} == {"body to level", "in the level", "in the body"}
