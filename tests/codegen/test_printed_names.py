"""Names of quantities in the printed C: what has one bears it, and no name means two things."""

import re

import numpy as np
import pytest
import sympy as sp
from conftest import ROOT

from boresight import named
from boresight.codegen.functions.tape import evaluate
from boresight.codegen.functions.units import units
from boresight.codegen.text.statements import parts
from boresight.derive.mechanics.rotation import dcm_from_quaternion
from boresight.derive.model import Function, Model, Output, Struct, variable
from boresight.derive.models import built_in

Q = variable("q", "q_w q_x q_y q_z", "1", "attitude", -1, 1)
F = variable("f_b", "f_x f_y f_z", "m/s^2", "force", -10, 10)
X = variable("a", "a_x a_y", "1", "two numbers", -1, 1)
x, y = X.symbols
DECLARED = re.compile(r"const bs_real (\w+) = (.*);")


def model_of(outputs):
    return Model(
        name="turn", c_prefix="tu", title="turn", frame="", states=(), measurements=(), card=(),
        structs=(Struct("given", "given", (Q, F, X)),),
        functions=(Function("turn", "a function", tuple(
            Output(f"out_{i}", one if isinstance(one, sp.MatrixBase) else sp.Matrix([one]), "mixed", "result")
            for i, one in enumerate(outputs))),),
    )  # fmt: skip


def unit_of(*outputs):
    (unit,) = units(model_of(outputs))
    return unit


def lines(*outputs):
    """The statements of a function with these outputs."""
    made, _ = parts(model_of(outputs), unit_of(*outputs))
    return [line for part in made for line in part.lines]


def declared(*outputs):
    return dict(match.groups() for line in lines(*outputs) if (match := DECLARED.fullmatch(line)))


def test_entries_bear_their_names_and_the_rest_is_counted_without_gaps():
    C = named("C_b2n", dcm_from_quaternion(Q.vector))
    f_n = named("f_n", C * F.vector, components="n e d")
    found = declared(f_n, C[1, 0] * x)
    assert found["C_b2n_21"] and {"f_n_n", "f_n_e", "f_n_d"} <= set(found)
    counted = [name for name in found if re.fullmatch(r"t\d+", name)]
    assert counted == [f"t{i}" for i in range(1, len(counted) + 1)]


def test_what_no_result_needs_is_not_there():
    unused = named("unused", x * y + 1)
    assert "unused" not in declared(unused - unused + x**2)
    C = named("C_b2n", dcm_from_quaternion(Q.vector))
    assert [name for name in declared(C[2, 2]) if name.startswith("C_")] == ["C_b2n_33"]


def test_minus_a_name_says_so():
    found = declared(named("growth", x - y) * -1)
    assert found == {"minus_growth": "a[1] - a[0]"}


def test_a_name_keeps_its_place_where_derivatives_are_printed():
    theta = named("theta", x * sp.sin(y) + 2)
    assert declared(sp.cos(theta), theta.diff(x) * sp.cos(theta))["theta"]


@pytest.mark.parametrize(
    ("name", "printed"),
    [("a", "a_2"), ("out_0_nz", "out_0_nz_2"), ("double", "double_2"), ("shared", "shared_2"), ("sqrt", "sqrt_2"),
     ("t7", "named_t7"), ("BS_REAL", "named_BS_REAL"), ("tu_turn_kernel", "named_tu_turn_kernel"), ("R", "R")],
)  # fmt: skip
def test_a_name_that_is_taken_gets_another(name, printed):
    assert printed in declared(named(name, x * y + 1) ** 2)


def test_two_quantities_of_one_name_are_told_apart():
    one, other = (named("g", value) for value in (x * y, x + y))
    found = declared(sp.Matrix([one * y, other * x]))
    assert found["g"] == "a[0] * a[1]" and found["g_2"] == "a[0] + a[1]"


def test_names_change_no_result():
    points = [np.random.default_rng(0).uniform(-1, 1, (50, v.size)) for v in (Q, F)]
    found = []
    for make in (named, lambda _, value: value):
        C = make("C", dcm_from_quaternion(Q.vector))
        f_n = make("f_n", C * F.vector)
        values, bounds = evaluate(unit_of(f_n.T * f_n, -C.T * f_n).tape, points)
        found.append((np.array(values), np.array(bounds)))
    (a, of_a), (b, of_b) = found
    assert a.shape == (4, 50) and (abs(a - b) <= of_a + of_b).all() and abs(a).max() > 0.1


KERNELS = sorted((ROOT / "generated").glob("*/src/*_kernel.h"))


def test_no_function_declares_a_name_twice_or_that_of_an_argument():
    """Nor two of one kernel.  Of what is committed, which is what its source makes."""
    assert len(KERNELS) > 100
    for path in KERNELS:
        text = path.read_text()
        arguments = re.findall(r"(\w+)\[\d+\][,)]", text)
        names = re.findall(r"^ +(?:const )?bs_real (\w+)\b.*;", text, re.MULTILINE)
        assert arguments and len(names) == len(set(names)) and not set(names) & set(arguments), path


def test_a_comment_stands_before_the_rows_of_each_state():
    model = built_in("phi-error")
    (unit,) = [unit for unit in units(model) if unit.name == "F"]
    (part,) = parts(model, unit)[0]
    blocks = [line for line in part.lines if line.startswith("/*")]
    assert blocks == [
        "/* d_position by d_position, dv_n */",
        "/* dv_n by d_position, dv_n, phi */",
        "/* phi by d_position, dv_n, phi */",
    ]
