"""What a card and a meaning say of a sign is what feedback does; the other sign is named with both forms."""

from dataclasses import replace

import pytest
from conftest import ROOT
from test_mechanics import model

from boresight.codegen.generate import load_model
from boresight.codegen.words import check_words
from boresight.derive.models import MODELS, built_in
from boresight.derive.models.euler_matching import euler_matching


def row(made):
    (check,) = check_words(made)
    return check


@pytest.mark.parametrize("name", [name for name in MODELS if name != "strapdown"])
def test_the_words_of_a_model_are_the_signs_of_its_feedback(name):
    assert row(built_in(name)).ok


@pytest.mark.parametrize("name", ["vertical", "gnss_ins", "autopilot"])
def test_those_of_an_example_too(name):
    assert row(load_model(f"{ROOT / 'examples' / name}.py:{name.upper()}")).ok


def carded(made, old, new):
    card = tuple(line.replace(old, new) for line in made.card)
    assert card != made.card
    return replace(made, card=card)


def meaning(made, name, text):
    return replace(made, states=tuple(replace(b, meaning=text) if b.name == name else b for b in made.states))


PLUS, MINUS = "C_hat = (I + [phi x]) C", "C_hat = (I - [phi x]) C"
WRONG = {
    "the card": (lambda: carded(model("azimuth-hold"), MINUS, PLUS),
                 f"card says {PLUS}; feedback means {MINUS}"),
    "a meaning": (lambda: meaning(euler_matching(), "eps", "attitude error, C_hat = (I + [eps x]) C"),
                  "eps says C_hat = (I + [eps x]) C; feedback means C_hat = (I - [eps x]) C"),
    "the mounting": (lambda: carded(model("velocity-attitude"), "(I - [dmu x])", "(I + [dmu x])"),
                     "card says C_hat_b2m = (I + [dmu x]) C_b2m; feedback means C_hat_b2m = (I - [dmu x]) C_b2m"),
    "a delay": (lambda: meaning(model("velocity-dcm"), "d_tau", "error of the delay, tau - tau_hat"),
                "d_tau says true - computed; feedback of tau by d_tau means computed - true"),
    "all errors": (lambda: carded(model("azimuth-hold"), "Error = computed - true", "Error = true - computed"),
                   "card says true - computed; feedback of lon by d_lon means computed - true"),
}  # fmt: skip


@pytest.mark.parametrize("what", WRONG)
def test_the_other_sign_in_words_is_named(what):
    made, entry = WRONG[what]
    check = row(made())
    assert (check.unit, check.ok, check.entry) == ("words", False, entry)


def test_a_feedback_of_the_other_sign_makes_the_same_words_wrong():
    made = model("azimuth-hold")
    phi = {s: -s for s in next(b for b in made.states if b.name == "phi").symbols}
    turned = tuple(
        replace(f, outputs=tuple(replace(o, value=o.value.xreplace(phi)) for o in f.outputs))
        if f.name == "feedback" else f
        for f in made.functions
    )  # fmt: skip
    assert row(replace(made, functions=turned)).entry == f"card says {MINUS}; feedback means {PLUS}"
    assert row(carded(replace(made, functions=turned), MINUS, PLUS)).entry.startswith("phi says")


def test_an_error_on_the_other_side_is_read_there():
    made = euler_matching()
    # an error in the level is none of the body
    bare = meaning(replace(made, card=()), "dmu", "of the mounting")
    assert row(bare).ok  # eps stands in its meaning
    other = meaning(bare, "eps", "attitude error, C_hat = C (I - [eps x])")
    assert row(other).entry == "eps says C_hat = C (I - [eps x]); feedback means C_hat = (I - [eps x]) C"


def test_where_nothing_is_said_nothing_is_held():
    assert check_words(built_in("strapdown")) == []
    made = load_model(f"{ROOT / 'examples' / 'vertical.py'}:VERTICAL")
    (nav, *rest) = meaning(made, "d_bias", "error of the bias").structs
    silent = tuple(replace(v, meaning=v.meaning.replace(", measured - true", "")) for v in nav.fields)
    bare = replace(meaning(made, "d_bias", "error of the bias"), structs=(replace(nav, fields=silent), *rest))
    assert check_words(bare) == []
