"""Over steps of time: Phi, Q and the strapdown fall short of the flow of the equation by the power that is claimed, and
a sign that no short step shows is named."""

import re
from dataclasses import replace
from functools import cache

import pytest
from conftest import ROOT
from sympy import Matrix
from test_dynamics import TURN

from boresight.codegen.flown import check_flown
from boresight.codegen.functions.dynamics import dynamics
from boresight.codegen.functions.maker import UnitMaker
from boresight.codegen.functions.reference import precise
from boresight.codegen.generate import load_model
from boresight.derive.mechanics import mechanization
from boresight.derive.mechanics.rotation import skew

FLIGHTS, STILL, LYAPUNOV = "two flights of strapdown and feedback", "exp(F dt)", "the integrated Lyapunov equation"
UNEVEN = "a body that turns and accelerates unevenly"
WITH_FLIGHTS = ("euler-matching", "phi-error", "velocity-dcm")


@cache
def model(name):
    return load_model(name)


@cache
def references(name):
    return {unit.name: unit.reference for unit in dynamics(UnitMaker(model(name)))}


def checked(made, reference):
    """The checks by unit and what it is held against."""
    return {(check.unit, check.against): check for check in check_flown(made, reference)}


@pytest.mark.parametrize("name", WITH_FLIGHTS)
def test_two_flights_part_as_Phi_says_to_its_order_and_fourfold_in_the_error(name):
    checks = checked(model(name), references(name))
    assert [check for check in checks.values() if not check.ok] == []
    assert checks["Phi", FLIGHTS].order == pytest.approx(3, abs=1e-4)
    assert checks["Phi", STILL].order == pytest.approx(3, abs=1e-4)
    assert checks["Q", LYAPUNOV].order == pytest.approx(4, abs=1e-3)
    if name != "euler-matching":  # whose error is linear
        assert checks["Phi", FLIGHTS].ratio == pytest.approx(0.25, rel=1e-3)
        assert checks["Phi", FLIGHTS].coefficient > 0.01


def test_a_strapdown_is_right_to_the_third_power_of_an_uneven_motion():
    check = checked(model("strapdown"), {})["step", UNEVEN]
    assert check.ok
    assert check.order == pytest.approx(4, abs=0.01)


def transposed(entries):
    return {(j, i): value for (i, j), value in entries.items()}


def spoilt(unit, change):
    """The references of azimuth-hold with one unit changed."""
    known = references("phi-error")

    def changed(values):
        with precise():
            (entries,) = known[unit](values)
            return [change(entries, values)]

    return known | {unit: changed}


def squared(factor):
    """Phi with the square of F dt times another factor."""

    def change(entries, values):
        (F,), dt = references("phi-error")["F"](values), values["dt"][0]
        more = {}
        for (i, k), left in F.items():
            for (m, j), right in F.items():
                if m == k:
                    more[i, j] = more.get((i, j), 0) + left * right * dt * dt * (factor - 0.5)
        return {at: entries.get(at, 0) + more.get(at, 0) for at in {*entries, *more}}

    return change


BROKEN_UNITS = {
    "Phi transposed": (
        "Phi", lambda entries, _: transposed(entries), FLIGHTS, r" by \w+ is \S+ too large over 0.00781 s; .*dt\^1.00"),
    "Phi with the whole square": ("Phi", squared(1), FLIGHTS, r"dt\^2.00, not dt\^3"),
    "Phi without the square": ("Phi", squared(0), STILL, r"dt\^2.00, not dt\^3"),
    "one noise of Q": (
        "Q", lambda entries, _: entries | {(4, 4): 2 * entries[4, 4]}, LYAPUNOV,
        r"dv_n by dv_n: .*dt\^1.00, not dt\^4"),
    "a small term of Q": (
        "Q", lambda entries, v: entries | {(0, 0): entries[0, 0] + v["dt"][0] ** 3 * 1e-12}, LYAPUNOV,
        r"d_lon by d_lon: .*dt\^3.00, not dt\^4"),
}  # fmt: skip


@pytest.mark.parametrize("what", BROKEN_UNITS)
def test_a_unit_that_is_not_the_flow_is_named(what):
    unit, change, against, entry = BROKEN_UNITS[what]
    check = checked(model("phi-error"), spoilt(unit, change))[unit, against]
    assert check.ok is False
    assert re.search(entry, check.entry), check.entry


OTHER_SIGN = {
    "coning": ("rotation_increment", lambda a, before: a - skew(before) * a / 12, "q_"),
    "sculling": (
        "velocity_increment",
        lambda a, v, a_before, v_before: (
            v + skew(a) * v / 2 + skew(a) * skew(a) * v / 6 - (skew(a_before) * v + skew(v_before) * a) / 12
        ),
        "v_",
    ),
}


@pytest.mark.parametrize("what", OTHER_SIGN)
def test_the_other_sign_of_coning_or_sculling_is_found(what, monkeypatch):
    name, wrong, row = OTHER_SIGN[what]
    monkeypatch.setattr(mechanization, name, wrong)
    check = checked(load_model("strapdown"), {})["step", UNEVEN]
    assert check.ok is False
    assert re.match(row + r"\w: what is left falls with dt\^3.00, not dt\^4", check.entry), check.entry


# ---------------------------------------------------------------- total states


PENDULUM = f"{ROOT / 'examples' / 'pendulum.py'}:PENDULUM"
FLOW, DIFFERENCES = "the flow of f", "differences of next"


def test_a_step_of_a_total_state_is_the_flow_of_f_to_its_order():
    checks = checked(model(PENDULUM), references(PENDULUM))
    assert [check for check in checks.values() if not check.ok] == []
    assert checks["next", FLOW].order == pytest.approx(5, abs=1e-3)
    assert checks["next", FLOW].coefficient > 0.01
    assert checks["Q", LYAPUNOV].order == pytest.approx(4, abs=1e-3)
    assert checks["Phi", DIFFERENCES].difference < 1e-30


def of_another_f(row, factor):
    """next of the pendulum whose f has another row."""
    f = Matrix(model(PENDULUM).f)
    f[row] = f[row].xreplace({symbol: factor * symbol for symbol in f[row].free_symbols if symbol.name == "damping"})
    return dynamics(UnitMaker(replace(model(PENDULUM), f=f)))[1].reference


def runge_kutta(*shares):
    """next by four stages, each a share of dt from the start along the one before it."""
    f = UnitMaker(model(PENDULUM)).numeric(model(PENDULUM).f)

    def after(values):
        with precise():
            h, x, rates = values["dt"][0], values["x"], []
            for share in (0, *shares):
                at = [a + h * share * k for a, k in zip(x, rates[-1], strict=True)] if rates else x
                rates.append([v for _, v in sorted(f({**values, "x": at})[0].items())])
            steps = zip(x, *rates, strict=True)
            return [{(i, 0): a + h * (k1 + 2 * k2 + 2 * k3 + k4) / 6 for i, (a, k1, k2, k3, k4) in enumerate(steps)}]

    return after


def changed(unit, change):
    return lambda values: [change(references(PENDULUM)[unit](values)[0])]


WRONG_STEPS = {
    "a sign in the f of next": ("next", lambda: of_another_f(1, -1), FLOW, r"omega is \S+ too large .*dt\^1.00, not"),
    "k3 over the whole step": ("next", lambda: runge_kutta(0.5, 1, 1), FLOW, r"too large over 0.00781 s; .*dt\^2.00"),
    "Phi transposed": ("Phi", lambda: changed("Phi", transposed), DIFFERENCES, r"by \w+: \S+ stated, \S+ exact"),
    "Q of the angle": (
        "Q", lambda: changed("Q", lambda entries: entries | {(0, 0): entries[0, 0] * 2}), LYAPUNOV,
        r"theta by theta: .*dt\^3.00, not dt\^4"),
}  # fmt: skip


@pytest.mark.parametrize("what", WRONG_STEPS)
def test_a_step_that_is_not_the_flow_is_named(what):
    unit, wrong, against, entry = WRONG_STEPS[what]
    check = checked(model(PENDULUM), references(PENDULUM) | {unit: wrong()})[unit, against]
    assert check.ok is False
    assert re.search(entry, check.entry), check.entry


def test_the_four_stages_of_the_test_are_those_of_next():
    right = checked(model(PENDULUM), references(PENDULUM) | {"next": runge_kutta(0.5, 0.5, 1)})
    assert right["next", FLOW] == checked(model(PENDULUM), references(PENDULUM))["next", FLOW]


def test_a_step_that_the_model_gives_is_not_checked_but_its_derivative_is():
    checks = checked(TURN, {unit.name: unit.reference for unit in dynamics(UnitMaker(TURN))})
    assert {key: check.ok for key, check in checks.items()} == {
        ("next", ""): None, ("Phi", DIFFERENCES): True, ("Q", ""): None,
    }  # fmt: skip
    assert checks["next", ""].why == "it is what the model gives"
