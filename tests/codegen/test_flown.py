"""Over steps of time: Phi, Q and the strapdown fall short of the flow of the equation by the power that is claimed, and
a sign that no short step shows is named."""

import re
from functools import cache

import pytest

from boresight.codegen.flown import check_flown
from boresight.codegen.functions.dynamics import dynamics
from boresight.codegen.functions.reference import precise
from boresight.codegen.functions.units import UnitMaker
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
