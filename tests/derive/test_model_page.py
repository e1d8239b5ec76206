"""The page of a model: what it shows is what the model states, read back from the page and evaluated."""

import random
import re
from dataclasses import replace
from fractions import Fraction
from functools import reduce

import numpy as np
import pytest
from conftest import PENDULUM, ROOT
from flint import arb, fmpq
from sympy import diag, eye, zeros

from boresight.codegen.functions.reference import evaluator
from boresight.codegen.functions.units import units
from boresight.codegen.generate import load_model
from boresight.derive.ledger import numbers
from boresight.derive.ledger.equation import Relation
from boresight.derive.ledger.evaluate import Point, evaluate
from boresight.derive.ledger.latex import latex_relation
from boresight.derive.ledger.numbers import Matrix
from boresight.derive.pages import notebook
from boresight.derive.pages.blocks import Formulas
from boresight.derive.pages.model import forms, model_page
from boresight.derive.pages.named import component_letters
from boresight.derive.pages.render import write
from boresight.evidence.spoilt import WRITERS, Shown, rendered

SWING = f"{ROOT / 'examples' / 'pendulum.py'}:PENDULUM"
TANK = f"{ROOT / 'examples' / 'own_model.py'}:TANK"
SONDE = f"{ROOT / 'tests' / 'codegen' / 'sonde.py'}:SONDE"
MODELS = (SONDE, "euler-matching", "phi-error", "velocity-attitude", TANK, PENDULUM)
FUNCTIONS = {
    "atan2": numbers.atan2,
    "abs": abs,
    "sign": lambda a: a.sgn(),
    "max": lambda *some: reduce(arb.max, map(arb, some)),
    "min": lambda *some: reduce(arb.min, map(arb, some)),
    "below": lambda a, b, then, otherwise: then if a < b else otherwise,
}


class Read(dict):
    """Values of letters at a point, those that the page defines computed when they are asked for."""

    def __init__(self, given, relations):
        super().__init__(given)
        self.defined = {}
        for relation in relations:
            first, *others = relation.sides
            self.defined[first.name] = others[0]
            if len(others) > 1:  # a vector by a product, then its components
                for i, letter in enumerate(others[1]):
                    self.defined[letter.name] = others[0], i

    def __missing__(self, name):
        if identity := re.fullmatch(r"I_(\d+)", name):
            self[name] = numbers.eye(int(identity[1]))
        else:
            found = self.defined[name]
            part = found[1] if isinstance(found, tuple) else None
            value = evaluate(found if part is None else found[0], Point(self))
            self[name] = value if part is None else value[part, 0]
        return self[name]


def relations(sections):
    return [form.relation for s in sections for b in s.blocks if isinstance(b, Formulas) for form in b.forms]


def constants(page):
    """The constants of the page: numbers from their text, the others by what is shown of them."""
    given, derived = {}, []
    for table in (b for s in page.sections if s.anchor == "constants" for b in s.blocks):
        for (letter,), value, _ in table.rows:
            name = letter.relation.sides[0]
            if isinstance(value, str):
                above, _, below = value.partition("/")
                exact = Fraction(above) / Fraction(below or "1")
                given[name.name] = fmpq(exact.numerator, exact.denominator)
            else:
                derived.append(Relation((name, value[0].relation.sides[0])))
    return given, derived


def point(model, seed):
    """Random numbers in the boxes, by the name of the component."""
    drawn = random.Random(seed)
    values = {}
    for v in (*model.states, *model.inputs):
        parts = [low + (high - low) * drawn.randint(1, 999) / 1000 for low, high in zip(v.low, v.high, strict=True)]
        if v.norm:
            parts = [part / sum(other**2 for other in parts) ** 0.5 for part in parts]
        values |= {s: arb(part) for s, part in zip(v.symbols, parts, strict=True)}
    return values


def read(model, page, section, at):
    """What the letters of one section are."""
    called = component_letters(model)
    values = {called[s].name: value for s, value in at.items()}
    values |= {v.name: Matrix([at[s] for s in v.symbols]) for v in (*model.states, *model.inputs) if v.size > 1}
    given, derived = constants(page)
    return Read({**values, **given, **FUNCTIONS}, [*derived, *relations(page.sections), *relations([section])])


def own(model, matrix, at, by=()):
    """The value of the model's own expressions, {place: number}."""
    symbols = list(at)
    (found,) = evaluator(symbols, [matrix], by)([at[s] for s in symbols])
    return found


def parts(names):
    """Where each row, or block of rows, begins, and its size."""
    found, start = {}, 0
    for name, letters in names:
        found |= {letter: (start + i, 1) for i, letter in enumerate(letters)}
        found[name] = start, len(letters)
        start += len(letters)
    return found


def blocks_of(model, columns=None):
    called = component_letters(model)
    return parts([(v.name, [called[s].name for s in v.symbols]) for v in columns or model.states])


def assembled(letter, values, rows, columns, section):
    """The matrix put together from the page's blocks, {place: number}."""
    found = {}
    for relation in relations([section]):
        if match := re.fullmatch(rf"{letter}_(\w+),(\w+)", relation.sides[0].name):
            (top, height), (left, width) = rows[match[1]], columns[match[2]]
            block = values[match[0]]
            for i in range(height):
                for j in range(width):
                    entry = block if (height, width) == (1, 1) else block[i, j]
                    assert (top + i, left + j) not in found, f"{match[0]} stands twice"
                    if entry != 0:
                        found[top + i, left + j] = entry
    return found


def differences(shown, stated):
    places = shown.keys() | stated.keys()
    return [place for place in places if not abs(shown.get(place, arb(0)) - stated.get(place, arb(0))) < 1e-25]


def vector(letter, values, rows, section):
    """z or h: as a whole, or row by row."""
    names = {relation.sides[0].name for relation in relations([section])}
    if letter in names:
        whole = values[letter]
        return {(i, 0): whole[i, 0] if isinstance(whole, Matrix) else whole for i in range(len(rows))}
    return {(i, 0): values[f"{letter}_{row}"] for i, row in enumerate(rows)}


def wrong(model, page, seed=1):
    """Every entry of F, G, z, h and H that the page does not show as the model states it."""
    at, found = point(model, seed), []
    section = {one.anchor: one for one in page.sections}
    with numbers.digits(60):
        states = blocks_of(model)
        if model.n:
            values = read(model, page, section["F"], at)
            stated = own(model, model.F, at) if model.f is None else own(model, model.f, at, tuple(model.x))
            found += [("F", *p) for p in differences(assembled("F", values, states, states, section["F"]), stated)]
            values = read(model, page, section["G"], at)
            noises = [v for v in model.inputs if set(v.symbols) & set(model.noise)]
            G = assembled("G", values, states, blocks_of(model, noises), section["G"])
            found += [("G", *p) for p in differences(G, own(model, model.G, at))]
        for m in model.measurements:
            here = section[m.name]
            values = read(model, page, here, at)
            for letter, stated in (("z", m.z), ("h", m.h)):
                if stated is not None:
                    shown = vector(letter, values, m.rows, here)
                    found += [(m.name, letter, *p) for p in differences(shown, own(model, stated, at))]
            if m.H is not None or "The Jacobian" in str(here):
                H = assembled("H", values, parts([(m.name, m.rows)]), states, here)
                stated = own(model, m.H, at) if m.H is not None else own(model, m.h, at, tuple(model.x))
                found += [(m.name, "H", *p) for p in differences(H, stated)]
    return found


@pytest.fixture(scope="module")
def made():
    kept = {}

    def one(target):
        if target not in kept:
            model = load_model(target)
            kept[target] = model, model_page(model)
        return kept[target]

    return one


@pytest.mark.parametrize("target", MODELS)
def test_a_page_shows_every_entry_of_the_model_as_the_model_states_it(made, target):
    assert wrong(*made(target)) == []


@pytest.mark.parametrize("block", ["F_phi,phi", "F_dv_E,dv_N", "G_dv_n,accel_noise"])
def test_a_sign_that_is_flipped_in_one_block_is_seen(made, block):
    model, page = made("phi-error")

    def flipped(form):
        name, *right = form.relation.sides
        return replace(form, relation=Relation((name, -right[0]))) if name.name == block else form

    def spoilt(part):
        return replace(part, forms=tuple(map(flipped, part.forms))) if isinstance(part, Formulas) else part

    sections = tuple(replace(s, blocks=tuple(map(spoilt, s.blocks))) for s in page.sections)
    found = wrong(model, replace(page, sections=sections))
    assert found and {place[0] for place in found} == {block[0]}


@pytest.mark.parametrize("form", WRITERS)
@pytest.mark.parametrize("target", ["euler-matching", "phi-error", TANK, SWING, SONDE])
def test_every_formula_of_a_page_is_shown_as_it_is(made, target, form):
    _, page = made(target)
    shown = {one.relation: Shown(str(one.relation.sides[0]), one.relation, one.quantities)
             for s in page.sections for one in forms(s) if len(one.relation.sides) > 1}  # fmt: skip
    assert len(shown) > 8
    assert [one.where for one in shown.values() if not one.holds(form, rendered(one, form))] == []


@pytest.mark.parametrize("format", ["html", "latex", "text"])
def test_a_page_has_each_name_that_is_typed_as_the_headers_have_it(made, library, format):
    """States, places in x, inputs and functions: as code where letters are set as such, and in that order."""
    text = (
        write(model_page(made("euler-matching")[0], library.manifest), format)
        .replace(r"\allowbreak{}", "")
        .replace(r"\_", "_")
    )
    mark = {"html": r"<code>([^<]+)</code>", "latex": r"\\texttt{\\small ([^}]+)}", "text": r"([\w\[\]>-]+)"}[format]
    typed = re.findall(mark, text.replace("&gt;", ">"))
    (header,) = (path.read_text() for path in library.folder.glob("include/euler_matching.h"))
    states = re.findall(r"#define EM_IX_(\w+) \d+", header)
    assert len(states) == 6
    first = typed.index(states[0].lower())
    assert typed[first : first + 6] == [state.lower() for state in states]
    (macro,) = (name for name in typed if name.startswith("x["))
    assert macro == f"x[EM_IX_{states[0]}]"
    fields = re.findall(r"^    bs_real (\w+)[\[;]", header, re.MULTILINE)
    functions = re.findall(r"^bs_status (em_\w+)(?<!_nz)\(", header, re.MULTILINE)
    assert len(fields) == 11 and len(functions) == 13 and {*fields, *functions} <= set(typed)


def test_a_notebook_shows_the_page_and_the_formulas_of_F(made):
    model, page = made(TANK)
    assert "<math" in notebook.html(model) and "Measurement reading" in notebook.html(model)
    (section,) = (s for s in page.sections if s.anchor == "F")
    latex = notebook.latex(model)
    assert all(latex_relation(one.relation, one.quantities) in latex for one in forms(section))


@pytest.mark.parametrize("columns", [80, 100])
def test_text_of_a_page_fits_and_names_every_long_number(made, columns, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(columns))
    for target in ("velocity-attitude", "euler-matching", TANK):
        text = write(made(target)[1], "text")
        assert not [line for line in text.splitlines() if len(line) > columns]
        assert not re.search(r"(?<![\d.])\d{8}", text)


def test_the_steps_of_the_noise_are_those_of_the_c(made, library):
    model, page = made("euler-matching")
    at = point(model, 2)
    section = {one.anchor: one for one in page.sections}
    with numbers.digits(40):
        values = read(model, page, section["F"], at)
        states = blocks_of(model)
        noises = [v for v in model.inputs if set(v.symbols) & set(model.noise)]
        F, G = numbers.zeros(model.n), numbers.zeros(model.n, model.noise.rows)
        for (i, j), value in assembled("F", values, states, states, section["F"]).items():
            F[i, j] = value
        for (i, j), value in assembled("G", values, states, blocks_of(model, noises), section["G"]).items():
            G[i, j] = value
        S = numbers.zeros(model.noise.rows)
        for i, s in enumerate(model.noise):
            S[i, i] = at[s] ** 2
        values = read(model, page, section["step"], at)
        values |= {"F": F, "G": G, "S": S}
        n = range(model.n)
        shown = {name: [[float(arb(values[name][i, j]).mid()) for j in n] for i in n] for name in ("Phi", "Q")}
    inputs = {v.name: [[float(at[s].mid()) for s in v.symbols]] for v in model.inputs}
    for name, value in shown.items():
        unit = library.manifest["units"][name]
        given = {field: inputs[field] if len(inputs[field][0]) > 1 else inputs[field][0] for field in unit["fields"]}
        assert getattr(library, name)(**given)[0] == pytest.approx(np.array(value), rel=1e-12, abs=1e-18)


def matrix(shape, entries):
    made = numbers.zeros(*shape)
    for place, value in entries.items():
        made[place] = value
    return made


def carried(model, at):
    """What the letters of a step stand for: values at the point, and functions of the state."""

    def along(expression, by=()):
        shape = (model.n, len(by) or expression.cols)
        return lambda x: matrix(shape, own(model, expression, at | {s: x[i, 0] for i, s in enumerate(model.x)}, by))

    x = Matrix([at[s] for s in model.x])
    spread = along(model.G * diag(*(s**2 for s in model.noise)) * model.G.T)
    if model.f is None:
        return {"F": along(model.F)(x), "Q_c": spread(x)}
    return {"x": x, "f": along(model.f), "F": along(model.f, tuple(model.x)), "Q_c": spread}


@pytest.mark.parametrize(
    ("target", "order", "names"),
    [
        ("euler-matching", 1, ("Phi", "Q")),
        ("euler-matching", 3, ("Phi", "Q")),
        (TANK, 2, ("x_next", "Q")),
        (SWING, 2, ("x_next", "Q")),
    ],
)
def test_the_step_that_is_shown_is_the_one_that_is_printed(target, order, names):
    """Every formula of the step evaluated from the page, against the references of the C."""
    model = replace(load_model(target), order=order)
    page, at = model_page(model), point(model, 3)
    at |= {s: arb(float(value) / 16) for s, value in at.items() if s == model.dt}
    section = {one.anchor: one for one in page.sections}["step"]
    fields = {v.name: [float(at[s].mid()) for s in v.symbols] for v in model.inputs}
    fields["x"] = [float(at[s].mid()) for s in model.x]
    references = {unit.name: unit.reference for unit in units(model)}
    with numbers.digits(60):
        called = component_letters(model)
        given = {called[s].name: value for s, value in at.items()} | carried(model, at)
        values = Read(given, relations([section]))
        for name in names:
            (printed,) = references[name.removeprefix("x_")](fields)
            for (i, j), value in printed.items():
                assert abs(values[name][i, j] - value) < 1e-25 + 1e-25 * abs(value)


def test_a_total_state_is_flown_by_next_and_a_model_in_discrete_time_shows_it(made):
    model, page = made(SWING)
    text = write(page, "text")
    assert "Predict: x becomes next(x)" in " ".join(text.split()) and "theta is put in [-pi, pi)" in " ".join(
        text.split()
    )
    given = {"f": None, "G": zeros(0, 0), "noise": zeros(0, 1)}
    turned = replace(model, **given, next=model.x + model.dt * model.f, Q=eye(2) * model.noise[0] ** 2)
    assert "x_" in notebook.latex(turned)
    page = model_page(turned)
    at, (section,) = point(model, 4), [one for one in page.sections if one.anchor == "step"]
    with numbers.digits(60):
        values = read(model, page, section, at)
        places = blocks_of(model)
        shown = {name: assembled(name, values, places, places, section) for name in ("Phi", "Q")}
        next_ = own(model, model.x + model.dt * model.f, at)
        assert differences(vector("x_next", values, ["theta", "omega"], section), next_) == []
        Phi = own(model, model.x + model.dt * model.f, at, tuple(model.x))
        assert differences(shown["Phi"], Phi) == []
        assert differences(shown["Q"], own(model, eye(2) * model.noise[0] ** 2, at)) == []
