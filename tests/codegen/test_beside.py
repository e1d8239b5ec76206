"""Functions beside the filter are held by exact mechanics too: a sign or a term that no F reads is named."""

from dataclasses import replace

import pytest
from sympy import Matrix, diag
from test_mechanics import function, model

from boresight.codegen.beside import check_beside
from boresight.derive.mechanics import earth
from boresight.derive.mechanics.earth import NED
from boresight.derive.models import MODELS, built_in
from boresight.derive.models import variables as var
from boresight.derive.models.phi_error import phi_error_ned
from boresight.derive.models.strapdown import strapdown_ned

HELD = {
    "strapdown": {"rates", "earth"},
    "euler-matching": {"strapdown", "euler_angles", "omega_in_n"},
    "phi-error": {"psi_from_phi"},
    "psi-error": {"phi_from_psi"},
}


def rows(made):
    return {check.unit: check for check in check_beside(made)}


@pytest.mark.parametrize("name", MODELS)
def test_what_is_known_by_its_name_is_held(name):
    found = rows(built_in(name))
    assert set(found) == HELD.get(name, set())
    assert all(check.ok and check.difference < 1e-20 for check in found.values())


@pytest.mark.parametrize("made", [phi_error_ned, strapdown_ned])
def test_it_holds_in_either_frame(made):
    found = check_beside(made())
    assert found and all(check.ok for check in found)


def level_rate(transport):
    """euler-matching with another rate of the level: the Earth's, and so many times the transport rate."""
    made = model("euler-matching")
    lat, height, v_n = made.structs[-1].fields
    rate = earth.omega_ie_n(lat.scalar) + transport * earth.omega_en_n(lat.scalar, height.scalar, v_n.vector)
    return function(made, "omega_in_n", "omega_in_n", lambda _: rate)


WRONG = {
    "the transport rate taken off": (lambda: level_rate(-1), "omega_in_n"),
    "no transport rate": (lambda: level_rate(0), "omega_in_n"),
    "roll for yaw": (
        lambda: function(model("euler-matching"), "euler_angles", "euler_b", lambda e: Matrix([e[2], e[1], e[0]])),
        "euler_angles"),
    "the level turned the other way": (
        lambda: function(model("euler-matching"), "strapdown", "q_b2n_wxyz",
                         lambda q: q.xreplace({s: -s for s in omega_in()})), "strapdown"),
    "the Earth's rate of another sign": (
        lambda: function(model("strapdown"), "earth", "omega_ie_n", lambda w: -w), "earth"),
    "gravity upwards": (lambda: function(model("strapdown"), "earth", "gravity_n", lambda g: -g), "earth"),
    "half of Coriolis": (
        lambda: function(model("strapdown"), "rates", "v_n_rate", lambda a: a + earth_rate().cross(V_N)), "rates"),
    "a map back": (
        lambda: function(model("phi-error"), "psi_from_phi", "T", lambda T: T * diag(*[1] * 6, -1, 1, 1)),
        "psi_from_phi"),
    "a map of the other sign": (
        lambda: function(model("psi-error"), "phi_from_psi", "T", lambda T: 2 * Matrix.eye(9) - T), "phi_from_psi"),
}  # fmt: skip
V_N = var.velocity(earth.ENU).vector


def earth_rate():
    return earth.omega_ie_n(var.position(earth.ENU).symbols[1], earth.ENU)


def omega_in():
    return next(v for v in model("euler-matching").inputs if v.name == "omega_in_n").symbols


@pytest.mark.parametrize("what", WRONG)
def test_what_is_wrong_is_named(what):
    made, unit = WRONG[what]
    check = rows(made())[unit]
    assert check.ok is False
    assert "stated" in check.entry


def test_a_function_with_an_output_that_nothing_knows_is_not_held():
    made = model("euler-matching")
    more = tuple(
        replace(f, outputs=(*f.outputs, replace(f.outputs[0], name="other"))) if f.name == "omega_in_n" else f
        for f in made.functions
    )
    assert "omega_in_n" not in rows(replace(made, functions=more))
    # nor is a rate that reads what is no part of a navigator
    odd = function(made, "omega_in_n", "omega_in_n", lambda w: w + Matrix(omega_in()))
    assert "omega_in_n" not in rows(odd)
    assert NED.name == made.frame[:3]
