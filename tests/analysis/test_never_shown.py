"""Null vectors as formulas, beside flights of the C along motions of their class."""

import numpy as np
import pytest
import sympy as sp
from conftest import ROOT

from boresight import Measurement, Model, Struct, load, variable
from boresight.analysis import nominal, observability
from boresight.analysis.symbolic import never_shown as symbolic
from boresight.codegen.generate import load_model
from boresight.derive.mechanics.rotation import quaternion_from_rotation_vector
from boresight.runtime.simulation import motions

G = 9.80665


@pytest.fixture(scope="module")
def found():
    return {one.motion: one for one in symbolic.never_shown(load_model("velocity-attitude-lever"), 60.0)}


def test_the_formulas_are_the_known_ones(found):
    straight = [dict(v) for v in found["straight"].vectors]
    assert {"d_tau": "1"} in straight and all({f"d_lever_{axis}": "1"} in straight for axis in "xyz")
    heading = next(v for v in straight if "phi_d" in v)
    assert heading == {"phi_d": "1", "dmu_z": "1", "dbg_x": "omega_en_n_e", "dbg_y": "-omega_in_n_n"}
    assert len(straight) == 7
    turn = [dict(v) for v in found["steady turn"].vectors]
    assert sorted(turn, key=len) == [{"d_lever_z": "1"}, {"dmu_z": "1", "d_tau": "1/w", "d_lever_x": "-V/w"}]
    assert not any(one.unsolved for one in found.values())


@pytest.mark.parametrize(("motion", "speed", "w", "heading"), [
    ("still", 0.0, 0.0, 0.0), ("straight", 100.0, 0.0, 0.5), ("level turn", 100.0, np.radians(3), 0.0),
])  # fmt: skip
def test_a_flight_of_the_C_tells_nothing_of_them_and_much_of_a_wrong_one(motion, speed, w, heading, found, monkeypatch):
    """Over a few seconds, for which the place and the rate of the level hardly change."""
    monkeypatch.setitem(motions.MOTIONS, "level turn", lambda time: motions.underway(time, w * time, speed))
    model = load("velocity-attitude-lever")
    along = nominal.nominal(model, motion, 4.0, 20.0, 4.0)
    start, steps = nominal.flight(model, along, nominal.settings(model))
    sigma = np.sqrt(np.maximum(np.diag(sum(start.values())), 1e-12))
    information = observability.observe(model, np.diag(sigma**2), steps).information
    c, s = np.cos(heading), np.sin(heading)
    ahead = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])  # the formula's north is ahead
    rate = ahead.T @ along.inputs["omega_in_n"][0]
    letters = {"omega_in_n_n": rate[0], "omega_en_n_e": rate[1], "omega_in_n_d": rate[2], "g": G, "V": speed, "w": w}
    states = model.states
    for vector in found["steady turn" if w else "straight"].vectors:
        x = np.zeros(len(states))
        for state, text in vector:
            x[states.index(state)] = eval(text, {}, letters)
        x[:3] = ahead @ x[:3]
        x /= sigma
        told = np.sqrt(max(x @ information @ x, 0.0))
        each = np.sqrt(np.diag(information)) * np.abs(x)  # what each state would show by itself
        # some thousandths of its sigma, for the motion's Earth is a sphere; of several states what cancels, too
        assert told < 5e-3 + 2e-3 * each.max() * (len(vector) > 1), (vector, told, each.max())
        if len(vector) > 1:
            wrong = x * np.where(np.arange(len(x)) == each.argmax(), 1.02, 1.0)
            assert np.sqrt(wrong @ information @ wrong) > 5 * told


def test_models_of_ones_own_and_what_is_not_solved_is_said():
    pendulum = symbolic.never_shown(load_model(f"{ROOT / 'examples' / 'pendulum.py'}:PENDULUM"))
    assert [one.motion for one in pendulum] == ["constant inputs"] and not pendulum[0].vectors
    late = symbolic.never_shown(load_model("velocity-attitude"), 0.001)
    assert {one.unsolved for one in late} == {"not solved in 0.001 s"}
    assert "straight: not solved in 0.001 s" in symbolic.lines(late)


def test_what_a_flight_measures_is_what_the_formulas_are_of():
    p, v, dt, noise = (variable(name, letter, unit, name, 0.01, 1.0) for name, letter, unit in (
        ("place", "p", "m"), ("speed", "v", "m/s"), ("dt", "dt", "s"), ("noise", "q", "m/s/sqrt(s)")))  # fmt: skip
    model = Model("cart", "ca", "a cart", "none", states=(p, v), structs=(Struct("step", "one step", (dt, noise)),),
                  F=sp.Matrix([[0, 1], [0, 0]]), G=sp.Matrix([0, 1]), noise=noise.vector, dt=dt.scalar,
                  measurements=(Measurement("velocity", ("speed",), "m/s", "speed", H=sp.Matrix([[0, 1]])),
                                Measurement("position", ("place",), "m", "place", H=sp.Matrix([[1, 0]]))))  # fmt: skip
    (alone,), (both,) = (
        symbolic.never_shown(model, measured=names) for names in (["velocity"], ["velocity", "position"])
    )
    assert alone.vectors == ((("p", "1"),),) and not both.vectors


def test_no_tiny_angle_is_left_in_a_formula():
    x = sp.Matrix(sp.symbols("x:3"))
    q = symbolic.spelled(quaternion_from_rotation_vector(x), set())
    at_zero = dict.fromkeys(x, sp.Integer(0))
    value, slope = (symbolic.without_tiny(part.xreplace(at_zero)) for part in (q, q.jacobian(x)))
    assert value == sp.Matrix([1, 0, 0, 0])
    assert slope == sp.Matrix.vstack(sp.zeros(1, 3), sp.eye(3) / 2)
