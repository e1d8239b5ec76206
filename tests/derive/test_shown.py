"""What is shown is what was judged: every formula is read back from each format and evaluated."""

import random
import re
from functools import cache
from textwrap import dedent

import pytest
from sympy import Function, ImmutableMatrix, Rational, S, Symbol, cos, symbols

from boresight.derive.ledger.equation import Relation, column, negative, product, total
from boresight.derive.pages.blocks import Form, Formulas, Page, Section
from boresight.derive.pages.render import write
from boresight.derive.papers import PAPERS
from boresight.evidence.formula_tokens import RefusedError
from boresight.evidence.spoilt import VALUE, WRITERS, Shown, changes, of_paper, outcome, places, rendered

formulas = cache(of_paper)


def found(name, where):
    return next(shown for shown in formulas(name) if shown.where == f"{name} {where}")


def on_page(shown, form):
    """The formulas as a page in one of the formats has them, in order."""
    forms = tuple(Form(one.relation, one.quantities) for one in shown)
    if form == "text":
        pages = (Page("", (Section("", (Formulas((one,)),)),)) for one in forms)
        return [dedent(write(page, "text")).rstrip() for page in pages]
    document = write(Page("", (Section("", (Formulas(forms),)),)), {"mathml": "html"}.get(form, form))
    if form == "latex":
        formulas = re.findall(r"\\begin\{formula\}(.*?)\\end\{formula\}", document, re.DOTALL)
        return [" ".join(re.findall(r"\\piece\{(?:\{\})?(.*)\}%", formula)) for formula in formulas]
    formulas = re.findall(r'<div class="formula">(<math.*?)</div>', document)
    return [f"<math>{''.join(re.findall('<math[^>]*>(.*?)</math>', formula))}</math>" for formula in formulas]


@pytest.mark.parametrize("form", WRITERS)
@pytest.mark.parametrize("name", [*PAPERS, "mechanics"])
def test_every_formula_of_a_paper_stands_on_its_page_as_it_was_judged(name, form):
    assert len(formulas(name)) > 20
    pairs = zip(formulas(name), on_page(formulas(name), form), strict=True)
    assert [one.where for one, text in pairs if not one.holds(form, text)] == []


@pytest.mark.parametrize("form", WRITERS)
def test_a_change_of_any_formula_is_refused_or_says_something_else(form):
    generator = random.Random(form)
    left = []
    for one in generator.sample([one for name in PAPERS for one in formulas(name)], 20):
        text = rendered(one, form)
        for what, changed in generator.sample(list(changes(form, text)), 6):
            if outcome(one, form, text, changed) == VALUE:
                left.append((one.where, what, changed))
    assert left == []


@pytest.mark.parametrize("form", WRITERS)
def test_the_sign_that_kim_11_has_wrong_is_seen_and_every_change_of_it(form):
    printed, derived = found("kim-2018", "(11) printed"), found("kim-2018", "(11) derived")
    assert not printed.holds(form, rendered(derived, form))
    text = rendered(printed, form)
    some = random.Random(form).sample(list(changes(form, text)), 80)
    assert VALUE not in [outcome(printed, form, text, changed) for _, changed in some]


@pytest.mark.parametrize("form", WRITERS)
def test_a_mark_at_any_place_changes_nothing_of_what_is_read(form):
    shown = found("kim-2018", "(9) printed")
    marked = [rendered(shown, form, {place}) for place in places(shown.relation)]
    assert len(set(marked)) > 30
    assert all(shown.holds(form, text) for text in marked)


a, b, c = symbols("a b c")
A, B, v, w = symbols("A B v w", commutative=False)
skew, cross, vee, exp, mean = (Function(name, commutative=False) for name in ("skew", "cross", "vee", "exp", "E"))


@pytest.mark.parametrize("form", WRITERS)
@pytest.mark.parametrize(
    "sides",
    [
        (A, negative(total(product(S(2), A), B))),
        (A, product(B, total(A, negative(product(A, B))))),
        (A, total(A, negative(total(B, negative(A))))),
        (a, (a - b) / (b * c), a / b / c, a**-2, (a + b) ** 3 * cos(b) ** 2 / 3, -a / 2),
        (A, product(A, (a + b) / c, B), product(A**-1, B), (A + B) ** -1, A**2),
        (A, exp(negative(skew(v))), product(skew(v), skew(w)), skew(total(v, w))),
        (v, cross(v, w), total(v, negative(cross(product(A, v), w))), product(A, cross(v, w)), vee(A)),
        (A, product(Rational(-2, 3), A, B), product(A, Rational(5, 7)), negative(product(A, B))),
        (A, mean(product(A, B, A)), product(mean(A), mean(B))),
        (v, column(a, b + c, -b), product(ImmutableMatrix([[a, b, 0], [b, -c, 1], [0, 0, a / b]]), v)),
    ],
)
def test_a_tree_of_any_kind_is_shown_as_it_is_evaluated(sides, form):
    shown = Shown("here", Relation(sides), ())
    assert shown.holds(form, rendered(shown, form))
    for i, side in enumerate(sides[1:], 1):
        other = Shown("here", Relation((*sides[:i], sides[0], *sides[i + 1 :])), ())
        assert side == sides[0] or not shown.holds(form, rendered(other, form))


def test_factors_stand_as_on_the_page_though_sympy_sorts_them():
    shown = found("kim-2018", "(9) printed")
    assert rendered(shown, "text").startswith("δl̇ = (ρ_e⋅tan(L)/cos(L) - ρ_n/((R_E + h)⋅cos(L))⋅R_EE)⋅δL - ρ_n/(")
    seawave = rendered(found("kang-2025", "(6) printed"), "latex")
    assert seawave == r"Seawave = asin\left(2 \, \pi \, f \, t\right)"


def test_names_of_a_model_are_shown_as_letters():
    relation = Relation((Symbol("omega_ie"), Symbol("R_N") * Symbol("tau") * Symbol("dphi_n")))
    assert WRITERS["latex"](relation, ()) == r"\omega_{ie} = R_{N} \, \delta \phi_{n} \, \tau"
    assert all(Shown("here", relation, ()).holds(form, rendered(Shown("here", relation, ()), form)) for form in WRITERS)


@pytest.mark.parametrize(
    "form, text, why",
    [
        ("latex", r"a = b c", "one too many"),
        ("latex", r"a = - - b", "begins nothing"),
        ("latex", r"a = \left(b", "missing"),
        ("latex", r"a = \hat{b}", "is no formula"),
        ("latex", r"a = \bold{b}", "unknown"),
        ("text", "a = b c", "one too many"),
        ("text", "a = B", "unknown"),
        ("text", "a = (b", "missing"),
        ("mathml", "<math><mi>a</mi><mo>=</mo><mi>b</mi><mi>c</mi></math>", "one too many"),
        ("mathml", "<math><mi>a</mi><mo>=</mo><msub><mi>b</mi></msub></math>", "<msub> of 1"),
        ("mathml", "<math><mi>a</mi><mo>=</mo><mi>b</mi></mrow>", "closes nothing"),
        ("mathml", "<math><mi>a</mi><mo>=</mo><mi>b</mi>", "is not one element"),
    ],
)
def test_what_is_no_formula_is_refused(form, text, why):
    with pytest.raises(RefusedError, match=why):
        Shown("here", Relation((a, b * c)), ()).holds(form, text)
