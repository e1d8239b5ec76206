"""The file of a model's equations: nothing of them is lost in it, and nothing else is read from it."""

from dataclasses import replace

import pytest
from conftest import PENDULUM, ROOT
from sympy import (
    Abs,
    Matrix,
    Max,
    Piecewise,
    Rational,
    Symbol,
    acos,
    atan2,
    cos,
    exp,
    log,
    pi,
    sign,
    sin,
    sqrt,
    tan,
    tanh,
)

from boresight import BoresightError
from boresight.codegen.generate import load_model
from boresight.codegen.text.equations import equations_text, read_equations
from boresight.derive.model import Function, Model, Output, Struct, variable

TANK = f"{ROOT / 'examples' / 'own_model.py'}:TANK"
SWUNG = f"{ROOT / 'examples' / 'pendulum.py'}:PENDULUM"


@pytest.mark.parametrize("target", ["euler-matching", "phi-error", "azimuth-hold", TANK, PENDULUM, SWUNG])
def test_a_model_is_read_back_node_by_node(target):
    model = load_model(target)
    text = equations_text(model)
    assert read_equations(text, target) == replace(model, mechanics=None)
    assert equations_text(read_equations(text, target)) == text
    assert len(text) < 50_000
    assert all(ord(character) >= 32 or character == "\n" for character in text)


def of_values(*values):
    """A model of nothing but these functions of a, b and of names that mean something in Python."""
    every = variable("every", "a b pi lambda E sin", "1", "numbers", -1, 1)
    outputs = tuple(Output(f"y{i}", Matrix([[value]]), "1", "a value") for i, value in enumerate(values))
    return Model(
        "numbers", "nu", "t", "none", (), (Struct("all", "", (every,)),), functions=(Function("f", "", outputs),)
    )


a, b, pi_, lambda_, E_, sin_ = (Symbol(name, real=True) for name in ["a", "b", "pi", "lambda", "E", "sin"])
VALUES = (
    a - b - 1,
    -a * (a + b) * (a - b) * Rational(2, 3),
    -((a + b) ** 2) / 2,
    a / b / (a + b) / sqrt(a + 2) * Rational(1, 3),
    (a + b) ** Rational(-3, 2) - (a + 3) ** -2,
    (a + 2) ** b + 2**a + (-a) ** 3,
    0.1 * a + 1e-30,
    -1.5 * sin(a) + 1.5e300,
    Rational(10**40 + 1, 10**39),
    pi * pi_ + lambda_ / E_ + sin(sin_) ** 2,
    atan2(-a, b) + Abs(a - b) + sign(b) + Max(a, b, 0),
    exp(-a) + log(a + 2) + acos(b / 2) + tanh(a) - tan(a * pi / 4),
    Piecewise((a + b, a < b), (a - b, a + b <= 1), (cos(a), a > 0), (-a, b >= 2), (0, True)),
)


@pytest.mark.parametrize("value", VALUES, ids=str)
def test_every_kind_of_expression_is_read_back(value):
    """Twice in a sum, so that it stands under a name of its own too."""
    model = of_values(value, sin(value) if not value.is_number else value, value + a)
    assert read_equations(equations_text(model), "") == model


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("- g*sin(theta)", "- g*sin(theata)"),
        ("- g*sin(theta)", "- __import__('os')"),
        ("- g*sin(theta)", "- theta.real"),
        ("- g*sin(theta)", "- "),
        ('"format": 1', '"format": 2'),
        ('"theta": "omega"', '"theta": "omega'),
        ('"theta": "omega"', '"angle": "omega"'),
        ('"symbols": ["theta"]', '"letters": ["theta"]'),
    ],
)
def test_what_is_no_such_file_is_refused_in_one_line(right, wrong):
    text = equations_text(load_model(SWUNG))
    assert right in text
    with pytest.raises(BoresightError, match=r"^HEAD cannot be read \(.*\); generate the model again$"):
        read_equations(text.replace(right, wrong), "HEAD")
