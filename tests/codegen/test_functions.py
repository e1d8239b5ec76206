"""A model with every function that a kernel may use: its C, its corners, its domains and its evidence."""

import ctypes
import re
from dataclasses import replace

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from building import passed
from conftest import ROOT
from sonde import SONDE, b, v, y

from boresight import BoresightError
from boresight.codegen.difference import compared
from boresight.codegen.folder import Folder
from boresight.codegen.functions import tape
from boresight.codegen.functions.convert import FUNCTIONS, to_casadi
from boresight.codegen.functions.singular import refuse_singular
from boresight.codegen.functions.units import units
from boresight.codegen.generate import generate
from boresight.codegen.text.equations import equations_text, read_equations
from boresight.codegen.verify import UnitCheck, verify
from boresight.derive.model import Measurement
from boresight.evidence import rounding
from boresight.evidence.calls import callable_units, shared_library
from boresight.evidence.mutants import candidates
from boresight.evidence.targets import GCC, compile_units
from boresight.evidence.trace import trace
from boresight.runtime.compiler import run
from boresight.runtime.library import load
from boresight.runtime.status import Status

SOURCE = f"{__file__.replace('test_functions', 'sonde')}:SONDE"
A_POINT = {"x": [4000.0, 7.0, -3.0], "air": [3e-3, 12.0], "dt": 0.5, "gust": [0.3, 0.4]}


@pytest.fixture(scope="module")
def folder(folder_of):
    return folder_of(SOURCE)


@pytest.fixture(scope="module")
def made():
    return {unit.name: unit for unit in units(SONDE)}


@pytest.fixture(scope="module")
def in_float(folder, tmp_path_factory):
    """The objects of the C in float, by unit."""
    return compile_units(Folder(folder), GCC, "float", tmp_path_factory.mktemp("float"), "-O0")


# ---------------------------------------------------------------- the C


def test_the_model_uses_every_function(made):
    used = {step.op for unit in made.values() for step in unit.tape.steps}
    assert used >= tape.LIBRARY - {"sin", "cos"} | {"sign", "fmin", "fmax", "fabs"}


def test_the_page_lists_what_a_kernel_may_use():
    """Each name of docs/own-model.md is taken, and whatever the converter takes is named."""
    page = (ROOT / "docs" / "own-model.md").read_text()
    named = set(re.findall(r"`(\w+)`", page.partition("What a kernel may use:")[2].partition("refused by name")[0]))
    x = sp.Symbol("x", positive=True)
    arguments = {"atan2": (x, 2), "Max": (x, 2), "Min": (x, 2), "Piecewise": ((x, x > 2), (2, True))}
    for name in named:
        to_casadi([sp.Matrix([getattr(sp, name)(*arguments.get(name, (x / 3,)))])], {x: ca.SX.sym("x")})
    assert named == {one.__name__ for one in FUNCTIONS} | {"sqrt", "tan", "Max", "Min", "Piecewise"}


@pytest.mark.digits
def test_both_prints_agree_in_bits_and_lie_within_the_bound_of_fifty_digits(folder):
    checks = verify(SOURCE, folder, 40)
    assert not [check for check in checks if check.ok is False]
    of_units = [check for check in checks if isinstance(check, UnitCheck)]
    assert len(of_units) >= 9 and all(check.looseness < 100 for check in of_units if check.largest_error > 0)


def test_the_kernel_calls_one_macro_a_function(folder):
    text = "".join(path.read_text() for path in folder.glob("src/*_kernel.h"))
    for name in ("EXP", "LOG", "ASIN", "ACOS", "ATAN", "SINH", "COSH", "TANH", "FMIN", "FMAX", "SIGN"):
        assert f"BS_{name}(" in text, name


def test_a_batch_gives_the_bits_of_single_calls(folder):
    library = load(folder)
    rng = np.random.default_rng(1)
    x = rng.uniform([-400, -60, -30], [9000, 60, 30], (50, 3))
    many = library.kite_h(x=x)
    assert all(library.kite_h(x=x[k]).tobytes() == many[k].tobytes() for k in range(50))
    assert library.kite_h(**{"x": A_POINT["x"]}) == pytest.approx(
        [np.cosh(0.2), np.sinh(-0.3), np.arcsin(0.07), np.arccos(0.4), np.arctan(-0.021), 0.07], rel=1e-15
    )


def test_the_self_test_passes_in_float(folder, in_float, tmp_path):
    program = tmp_path / "selftest"
    flags = ["-DBORESIGHT_FLOAT", "-I", folder / "include", "-I", folder / "selftest"]
    run(
        [
            "gcc",
            "-O0",
            *flags,
            *folder.glob("selftest/*.c"),
            *Folder(folder).identity,
            *in_float.values(),
            "-lm",
            "-o",
            program,
        ]
    )
    assert run([program]).splitlines()[-1] == passed(folder)


# ---------------------------------------------------------------- corners and derivatives


@pytest.mark.parametrize(
    ("entry", "rows"),
    [
        # of two alike, half of either slope; one that is constant has none
        (sp.Max(v, b), {(1.0, 1.0): (0.5, 0.5), (2.0, 1.0): (1, 0), (1.0, 2.0): (0, 1)}),
        (sp.Min(v, 3), {(3.0, 0.0): (0.5, 0), (2.0, 0.0): (1, 0), (4.0, 0.0): (0, 0)}),
        (sp.Abs(v) + sp.sign(v) * b, {(0.0, 5.0): (0, 0), (-2.0, 5.0): (-1, -1), (2.0, 5.0): (1, 1)}),
    ],
    ids=str,
)
def test_at_a_corner_a_derivative_is_the_mean_of_both_sides(entry, rows):
    model = measuring(entry)
    unit = next(unit for unit in units(model) if unit.name == "one_H")
    for (at_v, at_b), slopes in rows.items():
        point = {"x": [0.0, at_v, at_b]}
        values, bounds = tape.evaluate(unit.tape, [np.array([point["x"]])])
        (exact,) = unit.reference(point)
        in_c = np.zeros(3)
        for (_, nz, _), value, bound in zip(unit.tape.results, values, bounds, strict=True):
            in_c[unit.results[0].nonzeros[nz][1]] = value[0]
            assert bound[0] < 1e-15
        assert in_c.tolist() == [float(exact.get((0, j), 0)) for j in range(3)] == [0, *slopes]


def measuring(entry):
    """A model of the sonde's states whose one measurement is this."""
    one = Measurement("one", ("r0",), "1", "of the state", h=sp.Matrix([entry]))
    return replace(SONDE, measurements=(one,), functions=())


def test_a_change_of_such_a_model_is_shown():
    """Its equations are read back from their file, and a minimum that becomes a maximum is named with its slope."""
    text = equations_text(SONDE)
    assert read_equations(text, "sonde").f == SONDE.f
    changed = replace(SONDE, f=SONDE.f.replace(sp.Min, sp.Max))
    found = compared("sonde", "before", read_equations(text, "sonde"), changed)
    assert {(entry.matrix, entry.place) for entry in found.entries} == {("f", "v"), ("F", "v by y"), ("F", "v by v")}


# ---------------------------------------------------------------- domains


@pytest.mark.parametrize(
    ("entry", "why"),
    [
        (sp.log(v), r"measurement one: h\[r0\] has no value .*: at v = -?\d\S* it takes log of v; v is -60 to 60 in"),
        (sp.Max(sp.log(y + 300), -9), r"at y = -?\d\S* it takes log of 300 . y"),
        (sp.Piecewise((y, sp.log(v) > 1), (b, True)), "takes log of v"),
        (sp.asin(v / 50), "takes asin of 0.02.v"),
        (sp.acos(y / 8000 - 1), "takes acos of "),
        ((y + 350) ** sp.Rational(1, 3), "takes log of 350 . y"),
        (v**b, "takes log of v"),
        (sp.exp(y), "takes exp of y"),
        (sp.cosh(v * b), r"at b = \S* v = \S* it takes cosh of b.v"),
        (1 / (v - 7), "at v = 7 it divides by v - 7"),
        # where the dividend is zero too
        ((v**2 - 49) / (v - 7) * y, "at v = 7 it divides by v - 7"),
        (sp.log((v - 7) ** 2) - 2 * sp.log(abs(v - 7)) + y, "at v = 7 it takes log of "),
        (sp.sqrt(y), "takes sqrt of y"),
        # asin itself is defined at the end of its box, its slope is not
        (sp.asin(v / 60), r"H\[r0, v\] has no value .*: at v = -?60 it divides by"),
    ],
    ids=str,
)
def test_a_function_that_is_not_defined_throughout_its_box_is_refused_in_one_line(entry, why):
    model = measuring(entry)
    with pytest.raises(BoresightError, match=why) as said:
        refuse_singular(model, units(model))
    assert "\n" not in str(said.value) and "narrow the box" in str(said.value)


def test_nothing_is_written_of_what_is_refused(tmp_path):
    source = tmp_path / "wrong.py"
    source.write_text(
        "from dataclasses import replace\nfrom sonde import SONDE, fastest, v\nfrom sympy import Matrix, log\n"
        "m = SONDE.measurements[0]\n"
        "WRONG = replace(SONDE, measurements=(replace(m, unit='1', h=Matrix([log(v / fastest)])),))\n"
    )
    with pytest.raises(BoresightError, match=r"wrong.py:5: measurement baro: h\[p\].*log of 0.01.v"):
        generate(f"{source}:WRONG", tmp_path / "out")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    "entry",
    [
        sp.Piecewise((sp.log(v), v > 1), (v, True)),
        sp.log(sp.Max(v, 1)),
        sp.asin(sp.Min(sp.Max(v, -50), 50) / 51),
        1 / (1 + sp.exp(-y)),  # overflows, and its inverse is zero
    ],
    ids=str,
)
def test_a_function_that_is_kept_within_its_domain_is_taken(entry):
    model = measuring(entry)
    refuse_singular(model, [unit for unit in units(model) if unit.name == "one_h"])


HIDDEN = """
from sympy import Matrix, Rational, log
from boresight.derive.model import Function, Model, Output, Struct, variable

speed = variable("speed", "v", "1", "a speed over 1 m/s", -60.0, 60.0)
value = log((speed.scalar - Rational("31.4159")) ** 2 - Rational("1e-10"))
HIDDEN = Model(
    name="hidden", c_prefix="hi", title="one function", frame="none", states=(),
    structs=(Struct("given", "what is read", (speed,)),),
    functions=(Function("level", "a logarithm", (Output("level", Matrix([value]), "1", "a level"),)),),
)
"""


def test_what_no_search_finds_is_a_status_and_nothing_is_written(tmp_path):
    """The argument leaves the domain of a logarithm in a millionth of the box alone."""
    source = tmp_path / "hidden.py"
    source.write_text(HIDDEN)
    generate(f"{source}:HIDDEN", tmp_path / "out")
    library = load(tmp_path / "out")
    assert library.level(speed=31.0)[0] == pytest.approx(np.log(0.4159**2))
    out = np.full(2, 7.0)
    speed = (ctypes.c_double * 1)(31.4159)
    assert library.dll.hi_level(speed, out.ctypes.data_as(ctypes.c_void_p)) == Status.NOT_FINITE
    assert out.tolist() == [7.0, 7.0]
    with pytest.raises(BoresightError, match=r"level: what it gives .* is no number: BS_NOT_FINITE"):
        library.level(speed=31.4159)


# ---------------------------------------------------------------- evidence


def test_the_evidence_is_made_of_these_functions_too(folder, made, in_float, tmp_path, monkeypatch):
    committed = Folder(folder)
    H = next(unit for unit in committed.units if unit.name == "sn_kite_H")
    assert {line.partition(": ")[2].partition(", in `")[0] for line in candidates(H)} >= {
        "sinh to cosh", "cosh to sinh", "* to /", "> to >="
    }  # fmt: skip
    assert not [missing for of in trace(committed, tmp_path).values() for missing in of["missing"]]
    monkeypatch.setattr(rounding, "RUNS", 1000)
    compiled = callable_units(committed, shared_library(committed, "float", tmp_path, in_float), "float")
    for unit in (unit for unit in committed.units if unit.described is not None):
        found = rounding.of_unit(unit, made[unit.described["name"]], compiled[unit.name])
        assert found["violations"] == 0 and found["runs"] >= 1000, (unit.name, found)
