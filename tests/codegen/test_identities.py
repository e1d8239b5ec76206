"""What algebra makes zero, one or another value is not printed: the laws, and a search through every printed statement.

The search knows nothing of how identities are found: it reads the C text and evaluates it in balls of 60 digits.
"""

import re
from collections import defaultdict

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx

from boresight.codegen.folder import Folder, folders
from boresight.codegen.functions.convert import to_casadi
from boresight.codegen.functions.identities import domains, identified, numbers
from boresight.codegen.functions.maker import UnitMaker
from boresight.codegen.functions.tape import bounded, tape
from boresight.codegen.functions.units import measurement
from boresight.codegen.generate import load_model
from boresight.evidence.trace import OUTPUT, STATEMENT, statements

x, y, z = SYMBOLS = sp.symbols("x y z", real=True)
GUARDED = sp.sqrt(x**2 + sp.Rational(1, 10**30))


def values(*expressions):
    """The expressions, each as the SX that stays of it, and the inputs."""
    vector = ca.SX.sym("v", 3)
    (matrix,) = to_casadi([sp.Matrix(expressions)], {s: vector[i] for i, s in enumerate(SYMBOLS)})
    rng = np.random.default_rng(1)
    points = np.vstack([rng.uniform(-2, 2, (8, 3)), rng.uniform(-2, 2, (8, 3)) * 2.0**-12])
    (kept,) = identified([vector], [ca.densify(matrix)], [points])
    return [kept[i] for i in range(len(expressions))], vector


@pytest.mark.parametrize(
    ("first", "second", "at", "expected"),
    [
        # the same number by algebra, but one divides by what may be zero
        ((x**2 - y**2) / (x - y), x + y, (1.0, 1.0, 0.0), 2.0),
        ((sp.sqrt(1 + x) - 1) / x, 1 / (sp.sqrt(1 + x) + 1), (0.0, 0.0, 0.0), 0.5),
        # the same number by algebra, but one loses all its digits
        (sp.sqrt(1 + x) - 1, x / (sp.sqrt(1 + x) + 1), (1e-10, 0.0, 0.0), 4.9999999998750000e-11),
        (1 - sp.cos(x) ** 2, sp.sin(x) ** 2, (1e-9, 0.0, 0.0), 1e-18),
        # constants that a prime beside a power of two takes for small ones
        (sp.Float(2) ** 255 * x, 19 * x, (1.0, 0.0, 0.0), 19.0),
    ],
)
def test_a_value_that_fails_where_another_does_not_takes_the_place_of_none(first, second, at, expected):
    kept, vector = values(first, second)
    assert float(ca.Function("f", [vector], [kept[1]])(at)) == pytest.approx(expected, rel=1e-13)


def test_a_choice_keeps_the_branch_that_is_defined():
    guarded = sp.Piecewise(((sp.sqrt(1 + x) - 1) / x, sp.Abs(x) > 1e-6), (1 / (sp.sqrt(1 + x) + 1), True))
    kept, vector = values(guarded)
    function = ca.Function("f", [vector], [kept[0]])
    assert float(function((0.0, 0.0, 0.0))) == pytest.approx(0.5, rel=1e-15)


@pytest.mark.parametrize(
    ("expression", "constant"),
    [
        (sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1, 0),
        (sp.sin(x - y) + sp.sin(y - x), 0),
        ((x + y) * (x - y) - (x * x - y * y), 0),
        (1 / (x * y) - (1 / x) * (1 / y) + 1, 1),
        (sp.sqrt(x**2 + y**2) ** 3 / (x**2 + y**2) - sp.sqrt(x**2 + y**2) - 1, -1),
        (sp.Abs(x - y) - sp.Abs(y - x), 0),
    ],
    ids=str,
)
def test_what_algebra_makes_a_constant_is_that_constant(expression, constant):
    # z keeps SymPy from seeing it
    (kept,), _ = values(expression.subs(x, x + z, simultaneous=True))
    assert kept.is_constant() and float(kept) == constant


@pytest.mark.parametrize(
    "expression",
    [
        sp.sqrt((x * y) ** 2) - x * y,  # zero for one sign
        sp.sqrt((x * y) ** 2) + x * y,
        sp.Abs(x) - x,
        sp.Piecewise((x, y > 1000), (z, True)) - z,  # zero nearly everywhere
        GUARDED**2 / x**2 - 1,  # 1e-30 at x = 1, but what keeps x = 0 from being 0/0
        x / GUARDED - 1,
        sp.sin(x) ** 2 + sp.cos(y) ** 2 - 1,
        x + sp.Float(2.0**-60) * y - x,
    ],
    ids=str,
)
def test_what_is_zero_only_nearly_or_for_one_sign_stays(expression):
    (kept,), _ = values(expression)
    assert not kept.is_constant()


def test_equal_and_opposite_values_are_one():
    (a, b, c), vector = values((x + y) ** 2 * z, z * x * x + 2 * (x * y * z) + z * y * y, -((-x - y) ** 2) * z)
    program = tape(ca.Function("f", [vector], [a, b, c]))
    (_, _, first), (_, _, second), (_, _, third) = program.results
    assert first == second and program.steps[third].op == "neg" and program.steps[third].args == (first,)


# ---------------------------------------------------------------- every printed statement


PYTHON = {
    "BS_REAL": lambda number: arb(number),
    "BS_SQRT": lambda a: a.sqrt(),
    "BS_SIN": lambda a: a.sin(),
    "BS_COS": lambda a: a.cos(),
    "BS_ATAN2": lambda a, b: arb.atan2(a, b),
    "BS_FABS": lambda a: abs(a),
    "BS_TRUTH": lambda true: arb(int(true)),
    "BS_SELECT": lambda condition, value: value if condition > 0 else arb(0),
}
EXACT, ROUNDING = arb(10) ** -45, arb(10) ** -25
MODELS = [folder for folder in folders() if any(unit.described for unit in folder.units)]


def drawn(folder: Folder, size: float | None, rng: np.random.Generator) -> dict[str, list[arb]]:
    """Every field at random: inside twice its box, so that no angle's range hides that it is wrapped; a quaternion that
    declares its norm has the norm `size`, or any if that is None."""
    fields = [field for struct in folder.manifest["structs"].values() for field in struct]
    state = [bound for block in folder.manifest["blocks"] for bound in zip(block["low"], block["high"], strict=True)]
    point = {field["name"]: list(zip(field["low"], field["high"], strict=True)) for field in fields} | {"x": state}
    declared = {field["name"] for field in fields if field["norm"]}
    made = {}
    for name, box in point.items():
        made[name] = [arb(low + (high - low) * (2 * rng.random() - 0.5)) for low, high in box]
        if name in declared and size is not None:
            length = sum((a * a for a in made[name]), arb(0)).sqrt()
            made[name] = [a * size / length for a in made[name]]
    return made


def printed(folder: Folder):
    """Of each unit: its name, and of each statement the name that it defines and its text."""
    for unit in folder.units:
        if unit.described is not None:
            lines = statements(unit.path.with_name(f"{unit.name}_kernel.h"))
            found = [made.groups() for made in map(STATEMENT.match, lines) if made]
            assert len(found) == unit.operations
            yield unit.name, [(name, text.replace("shared->", "")) for name, text in found]


def evaluated(listed, points):
    """The value of each statement, and of each name in it, at every point."""
    programs = []
    for name, text in listed:
        text = re.sub(r"BS_REAL\(([^)]*)\)", r"BS_REAL('\1')", text)
        programs.append((name, compile(text, name, "eval")))
    columns = []
    for point in points:
        names = {**PYTHON, **point}
        for name, program in programs:
            names[name] = eval(program, names)
        columns.append(names)
    return columns


def near(a, b, tolerance):
    return abs(a - b) <= tolerance * (abs(a) + abs(b))


def same(one, other):
    return all(near(a, b, EXACT) for a, b in zip(one, other, strict=True))


@pytest.fixture
def sixty_digits():
    before, ctx.dps = ctx.dps, 60
    yield
    ctx.dps = before


def constant_or_equal(listed, columns):
    """Statements that are 0, 1 or -1 at every point, or what an earlier one is, as (name, what it is)."""
    buckets = defaultdict(list)
    buckets["1"], buckets["-1"] = ([(str(one), [arb(one)] * len(columns))] for one in (1, -1))
    for name, _ in listed:
        value = [column[name] for column in columns]
        if all(abs(v) < EXACT for v in value):
            yield name, "0"
            continue
        bucket = buckets[f"{float(value[0]):.12g}"]
        yield from ((name, other) for other, its in bucket if same(value, its))
        bucket.append((name, value))


def apart(folder, unit, found):
    """Whether of each two equal statements one is defined where the other is not, or errs by less than half."""
    maker = UnitMaker(load_model(folder.manifest["model"]))
    (its,) = (m for m in maker.model.measurements if f"{folder.manifest['c_prefix']}_{m.name}_H" == unit)
    (made,) = (u for u in measurement(maker, its) if u.name == f"{its.name}_H")
    points = [
        at for variable, at in zip(maker.variables, maker.points(made.name), strict=True) if variable in made.args
    ]
    errors = bounded(made.tape, points, np.float64)[1]
    needs = domains(made.tape, numbers(made.tape))

    def differ(i, k):
        return needs[i] & ~needs[k] or (errors[i] > 2 * errors[k])[np.isfinite(errors[k])].any()

    places = [[int(name[1:]) for name in pair] for pair in found]
    return all(differ(i, k) or differ(k, i) for k, i in places)


@pytest.mark.usefixtures("sixty_digits")
@pytest.mark.parametrize("folder", MODELS, ids=lambda folder: folder.name)
def test_no_statement_is_identically_zero_one_or_another(folder):
    rng = np.random.default_rng(1)
    few, many = ([drawn(folder, None, rng) for _ in range(count)] for count in (2, 60))
    for unit, listed in printed(folder):
        found = set(constant_or_equal(listed, evaluated(listed, few)))
        if found:  # a choice, or an angle that is wrapped, may change nothing at a few points
            found &= set(constant_or_equal(listed, evaluated(listed, many)))
        if not found:
            continue
        if unit == "em_euler_exact_hx" and len(found) == 1:  # two pitches differ by no turn, and are wrapped as all are
            continue
        # the other models have the same measurement, of an attitude's quaternion, of more states
        assert unit == f"{folder.manifest['c_prefix']}_quaternion_H" and len(found) <= 2, (unit, found)
        assert folder.name != "velocity_attitude" or apart(folder, unit, found), (unit, found)


@pytest.mark.usefixtures("sixty_digits")
@pytest.mark.parametrize("folder", MODELS, ids=lambda folder: folder.name)
def test_on_the_unit_sphere_only_norms_are_one_and_no_sum_is_rounding(folder):
    rng, size = np.random.default_rng(2), 0.999
    few, many = ([drawn(folder, 1.0, rng) for _ in range(count)] for count in (2, 60))
    inside = drawn(folder, size, rng)
    for unit, listed in printed(folder):
        columns, ones = evaluated(listed, few), []
        for name, text in listed:
            terms = re.fullmatch(r"(\w+(?:\[\d+\])?) [+-] (\w+(?:\[\d+\])?)", text)
            if terms:
                largest = [max(abs(eval(term, column)) for term in terms.groups()) for column in columns]
                small = [abs(column[name]) < ROUNDING * m for column, m in zip(columns, largest, strict=True)]
                assert not all(small), (unit, name, text)
            if same([column[name] for column in columns], [arb(1)] * len(columns)):
                ones.append(name)
        if ones:
            (off,), columns = evaluated(listed, [inside]), evaluated(listed, many)
            for name in ones:
                if same([column[name] for column in columns], [arb(1)] * len(columns)):
                    # a norm that a result is divided by: off the sphere it is a power of the declared one
                    power = float(abs(off[name]).log() / arb(size).log())
                    assert abs(power - round(power)) < 1e-9 and round(power) != 0, (unit, name)


@pytest.mark.parametrize("folder", MODELS, ids=lambda folder: folder.name)
def test_what_noise_adds_is_printed_as_one_triangle_and_its_copy(folder):
    """So Q and Qc are symmetric to the bit at every input."""
    for unit in folder.units:
        if unit.described is not None and unit.described["name"] in ("Q", "Qc"):
            lines = statements(unit.path.with_name(f"{unit.name}_kernel.h"))
            written = [made.groups() for made in map(OUTPUT.match, lines) if made]
            entries = {tuple(place.split(", ")): value for _, _, value, place in written}
            assert entries and all(entries[column, row] == value for (row, column), value in entries.items())
