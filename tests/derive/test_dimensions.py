"""Units are read, and every term of every model and of every equation has the unit that it must have."""

from collections import Counter
from dataclasses import replace

import pytest
from conftest import ROOT
from sympy import Float, Matrix, Mul, Piecewise, Symbol, acos, atan2, exp, log, pi, sign, sin, sqrt, symbols

from boresight import BoresightError
from boresight.codegen.generate import load_model
from boresight.derive.constant import Constant, constant
from boresight.derive.dimensions import Mismatch, Terms, check_units
from boresight.derive.expressions import unnamed
from boresight.derive.ledger import dimensions
from boresight.derive.model import variable
from boresight.derive.papers import DERIVATIONS, PAPERS, paper
from boresight.derive.units import ONE, RADIAN, SECOND, by_pint, of_base_units, unit, units

# In the other frame than the built-in ones.  The examples are loaded, and so held, by their own tests.
OTHERS = [
    f"{ROOT / 'derive' / 'models' / other}"
    for other in ("strapdown.py:strapdown_ned", "phi_error.py:phi_error_ned", "psi_error.py:psi_error_ned")
]


# ---------------------------------------------------------------- units


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("rad/sqrt(s)", "rad/sqrt(s)"),
        ("m/s^2/sqrt(s)", "m/s^2/sqrt(s)"),
        ("rad/s/sqrt(Hz)", "rad/sqrt(s)"),
        ("sqrt(m^2/s)", "m/sqrt(s)"),
        ("N/kg", "m/s^2"),
        ("Pa", "kg/m/s^2"),
        ("1", "1"),
        ("K", "K"),
        ("V/A", "kg*m^2/s^3/A^2"),
    ],
)
def test_a_coherent_unit_is_read_and_written(text, meant):
    assert str(unit(text)) == meant
    assert unit(meant) == unit(text)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("deg", "deg is 0.0174533 rad; declare rad and convert at the border"),
        ("mil", "mil is 0.000981748 rad"),  # 2 pi / 6400
        ("g", "g is 9.80665 m/s^2"),
        ("mg", "mg is 0.00980665 m/s^2"),
        ("ug/sqrt(Hz)", "ug/sqrt(Hz) is 9.80665e-06 m/s/sqrt(s); declare m/s/sqrt(s)"),
        ("deg/h", "deg/h is 4.84814e-06 rad/s"),
        ("km", "km is 1000 m"),
        ("%", "% is 0.01; declare 1"),
        ("degC", "'degC' has a zero of its own; declare K"),
        ("furlong", "furlong is 201.168 m"),
        ("furlog", "'furlog' (did you mean 'furlong'?) is not known"),
        ("m/furlog", "'furlog' (did you mean 'furlong'?) in 'm/furlog' is not known"),
        ("", "'' is not known"),
        ("m/(s", "'m/(s' is not known"),
        ("2 m", "'2 m' is not known"),
        ("bit", "'bit' counts bit, which is no SI unit"),
    ],
)
def test_any_other_unit_is_refused_in_one_line(text, says):
    with pytest.raises(BoresightError) as refused:
        unit(text)
    assert says in str(refused.value) and "\n" not in str(refused.value)


def test_there_is_one_unit_for_all_components_or_one_for_each():
    assert units("m", 3) == [unit("m")] * 3
    assert units("rad, rad, m", 3) == [RADIAN, RADIAN, unit("m")]
    for count in (1, 2, 4):
        with pytest.raises(BoresightError, match=rf"^3 units \(rad, rad, m\) for {count} component"):
            units("rad, rad, m", count)


# ---------------------------------------------------------------- terms

x, y, t, a, n = symbols("x y t a n", real=True)
TERMS = {x: unit("m"), y: unit("m"), t: unit("s"), a: RADIAN, n: ONE}
g = constant("g", "9.81", "m/s^2", "gravity")


@pytest.mark.parametrize(
    ("expression", "meant"),
    [
        (x + y, "m"),
        (x / t + g * t, "m/s"),
        (sqrt(2 * g * x), "m/s"),
        (x ** Float(0.5), "sqrt(m)"),
        (sin(a) + sin(n) + n, "1"),
        (a + n, "1"),  # angle is weak
        (a + pi, "1"),
        (atan2(x, y), "rad"),
        (acos(x / y), "rad"),
        (exp(-x / y) * t, "s"),
        (log(n) + abs(n), "1"),
        (abs(x) * sign(t), "m"),
        (Piecewise((x, t < 0), (0, x > y), (y, True)), "m"),
        ((a / t) ** 2 * x, "rad^2*m/s^2"),
        (2**n, "1"),
    ],
)
def test_the_unit_of_an_expression_follows_from_its_letters(expression, meant):
    assert str(Terms(TERMS)(expression)) == meant


@pytest.mark.parametrize(
    ("expression", "says"),
    [
        (x + t, "adds t, which is s, and x, which is m"),
        (x + 1, "make it a constant"),
        (x * (1 + t), "adds 1, which is 1, and t, which is s"),
        (sin(x), "sin takes an angle or a number, and x is m"),
        (exp(a), "exp takes a number, and a is rad"),
        (log(x / t), "log takes a number, and x/t is m/s"),
        (atan2(x, t), "has atan2 of x, which is m, and t, which is s"),
        (Piecewise((x, t < 0), (t, True)), "has Piecewise of x, which is m, and t, which is s"),
        (Piecewise((x, t < x), (y, True)), "compares t, which is s, and x, which is m"),
        (2**x, "exponent x, which is m"),
        (x**n, "raises x, which is m, to n"),
        (sin(pi * n / 180), "turns degrees into rad, or back, by pi/180"),
        (a * 180 / pi, "turns degrees into rad, or back, by pi/180"),
        (0.017453292519943295 * a, "turns degrees into rad, or back, by pi/180"),
        (a * 3600 * 180 / pi, "turns degrees into rad, or back, by pi/180"),
        (Symbol("z") + x, "reads z, of which no unit is known"),
    ],
    ids=str,
)
def test_terms_that_do_not_fit_are_named_with_their_units(expression, says):
    with pytest.raises(Mismatch) as refused:
        Terms(TERMS)(expression)
    assert says in str(refused.value)


# ---------------------------------------------------------------- models


# Every built-in model is loaded, and so held, by tests/test_promises.py.
@pytest.mark.parametrize("target", ["euler-matching", *OTHERS])
def test_every_term_of_a_model_of_ours_fits(target):
    load_model(target)


def test_a_model_is_held_when_it_is_loaded(tmp_path):
    (tmp_path / "wrong.py").write_text(
        (ROOT / "examples" / "pendulum.py").read_text().replace("damping * omega", "damping * theta")
    )
    with pytest.raises(BoresightError, match=r"wrong\.py:\d+: model pendulum: f\[omega\] adds .*which is rad/s"):
        load_model(f"{tmp_path / 'wrong.py'}:PENDULUM")


def parts(model):
    """What the entries of F are, and what they must be."""
    known = {v.name: units(v.unit, v.size) for v in (*model.states, *model.inputs)}
    terms = Terms({s: u for v in (*model.states, *model.inputs) for s, u in zip(v.symbols, known[v.name], strict=True)})
    states = [u for v in model.states for u in known[v.name]]
    return terms, {(i, j): (e, states[i] / states[j] / SECOND) for (i, j), e in model.F.todok().items()}


@pytest.mark.parametrize(("name", "count"), [("phi-error", 42), ("psi-error", 33)])
def test_angle_must_be_weak(name, count):
    """With rad as strict as m, most entries of right models would be refused."""
    terms, entries = parts(load_model(name))
    weak = [terms(e).like(need) for e, need in entries.values()]
    strict = [terms(e) == need for e, need in entries.values()]
    assert len(weak) == count and all(weak)
    assert sum(strict) < count / 2


def dropped(e):
    """Each form of an expression that lacks one factor of one of its products, and that factor."""
    for k, part in enumerate(e.args):
        if e.is_Mul and not part.is_Number:
            yield part, Mul(*e.args[:k], *e.args[k + 1 :])
        for factor, changed in dropped(part):
            yield factor, e.func(*e.args[:k], changed, *e.args[k + 1 :])


def test_a_factor_of_length_or_time_that_is_lost_is_seen():
    found = Counter()
    for name in ("psi-error", "euler-matching", "velocity-dcm"):
        terms, entries = parts(load_model(name))
        for e, need in ((unnamed(e), need) for e, need in entries.values()):
            for factor, changed in dropped(e):
                if terms(factor).powers:
                    try:
                        unseen = terms(changed) is None or terms(changed).like(need)
                    except Mismatch:
                        unseen = False
                    found[unseen] += 1
    assert not found[True] and found[False] > 150


def test_what_units_do_not_show_is_not_seen():
    """A sign, a number as factor, and rad."""
    model = load_model(f"{ROOT / 'examples' / 'pendulum.py'}:PENDULUM")
    for changed in (Matrix([-model.f[0], model.f[1]]), 2 * model.f):
        check_units(replace(model, f=changed))
    rates = (model.states[0], replace(model.states[1], unit="1/s"))
    check_units(replace(model, states=rates))


def test_a_box_beyond_two_turns_needs_a_word():
    model = load_model(f"{ROOT / 'examples' / 'pendulum.py'}:PENDULUM")
    for wide in (False, True):
        angle = variable("angle", "theta", "rad", "angle", -180, 180, wide=wide)
        changed = replace(model, states=(angle, model.states[1]))
        if wide:
            check_units(changed)
        else:
            with pytest.raises(BoresightError, match=r"theta goes to 180 rad, 28\.6 turns; .* radians\(\.\.\.\)"):
                check_units(changed)


def test_a_constant_has_the_unit_of_its_value_and_a_name_of_its_own():
    model = load_model(f"{ROOT / 'examples' / 'pendulum.py'}:PENDULUM")
    omega, theta = model.x[1], model.x[0]
    wrong = constant("k", g**2, "m/s^2", "a square")
    other = Constant("g", Float(9.8), "m/s^2", "gravity elsewhere")
    for one, says in ((wrong, "constant k: its value is g"), (other, "constant g: it is 9.8")):
        f = Matrix([omega, -(g + one) / model.inputs[0].symbols[0] * sin(theta)])
        with pytest.raises(BoresightError, match=says):
            check_units(replace(model, f=f))


# ---------------------------------------------------------------- papers


@pytest.mark.parametrize("name", [*PAPERS, *DERIVATIONS])
def test_every_equation_and_every_line_of_a_derivation_fits(name):
    count, found = dimensions.misfits(paper(name))
    assert count > 60 and not found


@pytest.mark.parametrize(
    ("name", "letter"),
    [("song-lee-2001", "ω_e"), ("kang-2025", "L"), ("delay-error", "τ")],
)
def test_a_letter_of_another_unit_is_seen_in_the_equations(name, letter, monkeypatch):
    of_letter = dimensions.of_letter

    def changed(mixed, quantity):
        grid = of_letter(mixed, quantity)
        slower = dimensions.multiplied(dimensions.scalar(SECOND), grid)
        return slower if quantity.symbol.name == letter else grid

    monkeypatch.setattr(dimensions, "of_letter", changed)
    _, found = dimensions.misfits(paper(name))
    assert found


def test_units_alone_show_an_erratum_of_a_print():
    """Kim (6) adds a rotation and a rate."""
    (one,) = (e for e in paper("kim-2018").equations if e.number == "6")
    terms = dimensions.Terms({q.symbol.name: dimensions.of_letter(paper("kim-2018").units, q) for q in one.alphabet})
    with pytest.raises(Mismatch, match="1 and rad/s"):
        for relation in one.read():
            dimensions.added(*map(terms, relation.sides))


@pytest.mark.parametrize("text", [
    "1", "m", "rad", "s", "Hz", "1/s", "rad/s", "m/s^2", "rad/s/sqrt(s)", "m/s/sqrt(Hz)", "m^2/s^4", "rad/s/m",
    "kg*m/s^2",
    "1/sqrt(s)", "m/rad", "kg/m^3", "A*s", "mol/K", "rad^2/s",
])  # fmt: skip
def test_a_unit_of_base_units_is_read_as_pint_reads_it(text):
    assert of_base_units(text) == by_pint(text)


@pytest.mark.parametrize(
    "text", ["deg", "g", "N", "m s", "m**2", "1e3*m", "2", "", "m//s", "sqrt(m", "km", "s^-1", "mm/s"]
)
def test_what_is_more_is_left_to_pint(text):
    assert of_base_units(text) is None
