"""What h, H and F share with z and strapdown, which follow from them, is found by what these must do in any case."""

import sys
from dataclasses import replace

import pytest
from conftest import ROOT
from sympy import Matrix

from boresight.codegen.flat import check_flat
from boresight.codegen.mechanics import Exact, check_feedback
from boresight.codegen.residuals import check_residuals
from boresight.codegen.words import check_words
from boresight.derive.mechanics.rotation import dcm_from_quaternion

sys.path.insert(0, str(ROOT / "examples"))
import ahrs
import autopilot
import gnss_ins_21

AHRS, AUTOPILOT, GNSS = ahrs.SIX, autopilot.AUTOPILOT, gnss_ins_21.GNSS_INS_21


def measured(made, name, **change):
    return replace(made, measurements=tuple(replace(m, **change) if m.name == name else m for m in made.measurements))


def z(made, name):
    return next(m.z for m in made.measurements if m.name == name)


def function(made, name, output, value):
    """The model with another value of one output of a function."""
    return replace(made, functions=tuple(
        replace(f, outputs=tuple(replace(o, value=Matrix(value(o.value))) if o.name == output else o
                                 for o in f.outputs)) if f.name == name else f
        for f in made.functions
    ))  # fmt: skip


@pytest.mark.parametrize("made", [AHRS, AUTOPILOT, GNSS], ids=lambda made: made.name)
def test_of_a_right_model_nothing_is_left_over(made):
    assert [check for check in check_residuals(made) if check.ok is not True] == []


C_b2n = dcm_from_quaternion(ahrs.q.vector)
shown = autopilot.nav["mag_i"].vector, autopilot.nav["mag_b"].vector
exchanged = {s: -s for s in gnss_ins_21.var.OMEGA_IB_B.symbols}
TURNED = {
    "a transposed attitude": (lambda: measured(AHRS, "accelerometer", z=C_b2n**2 * z(AHRS, "accelerometer")),
                              "accelerometer_z"),
    "a vector of the level for one of the body": (
        lambda: measured(AUTOPILOT, "mag", z=z(AUTOPILOT, "mag").xreplace(dict(zip(shown[1], shown[0], strict=True)))),
        "mag_z"),
    "two axes exchanged": (
        lambda: measured(GNSS, "velocity", z=z(GNSS, "velocity").xreplace(
            dict(zip(gnss_ins_21.lever.symbols[:2], gnss_ins_21.lever.symbols[1::-1], strict=True)))),
        "velocity_z"),
}  # fmt: skip


@pytest.mark.parametrize("what", TURNED)
def test_a_z_that_hangs_on_the_choice_of_axes_is_not_held(what):
    made, unit = TURNED[what]
    check = next(check for check in check_residuals(made()) if check.ok is None)
    assert check.unit == unit
    assert "where the axes of the body turn" in check.why


def test_a_measured_value_is_taken_off_once():
    twice = measured(AHRS, "magnetometer", z=z(AHRS, "magnetometer") - ahrs.mag.vector)
    entries = [check.entry for check in check_residuals(twice) if check.ok is False]
    assert entries == ["magnetometer_z has -2 times mag; computed - measured has -1"]


def test_a_velocity_of_the_antenna_that_is_not_the_rate_of_its_position_is_not_held():
    other = measured(GNSS, "velocity", z=z(GNSS, "velocity").xreplace(exchanged))
    assert ["it is not the rate of position_z" in check.why for check in check_residuals(other) if not check.ok] == [
        True
    ]


def test_a_measured_value_that_nothing_reads_is_named():
    without = measured(AUTOPILOT, "height", z=z(AUTOPILOT, "height") + autopilot.m_height.vector)
    assert [check.why for check in check_residuals(without) if not check.ok] == ["nothing reads hagl"]


def test_a_sensor_that_step_states_twice_is_named():
    step = tuple((what, 2 * column) for what, column in AUTOPILOT.mechanics.step)
    twice = replace(AUTOPILOT, mechanics=replace(AUTOPILOT.mechanics, step=step))
    assert [check.why for check in check_residuals(twice) if not check.ok] == [
        "it states delta_vel as 2 times accel over the step"
    ]


# ---------------------------------------------------------------- a flat Earth

v_n, p_n, dt = autopilot.nav["vel"].vector, autopilot.nav["pos"].vector, autopilot.step
FALLS = Matrix([0, 0, autopilot.GRAVITY]) * dt
FLAT = {
    "gravity upwards": ("vel", lambda v: v - 2 * FALLS, "v_d has gravity -9.81 downwards"),
    "a place that moves twice": ("pos", lambda p: p + v_n * dt, "p_n by t: "),
    "a force that is not turned": ("vel", lambda v: v_n + FALLS + autopilot.gain.vector, "v_d has gravity "),
    "a turn back": ("q", lambda q: q.xreplace({s: -s for s in autopilot.turn.symbols}), "q_w by t: "),
}


def test_a_right_strapdown_over_a_flat_earth_is_held():
    assert [check.ok for made in (AHRS, AUTOPILOT) for check in check_flat(made)] == [True, True]
    assert check_flat(GNSS) == []  # it reads a latitude


@pytest.mark.parametrize("what", FLAT)
def test_one_that_is_none_is_not_held(what):
    output, value, why = FLAT[what]
    (check,) = check_flat(function(AUTOPILOT, "strapdown", output, value))
    assert check.ok is None
    assert f"it is not a body over a flat Earth: {why}" in check.why


# ---------------------------------------------------------------- words and metres


def test_a_bias_that_strapdown_adds_is_none_of_measured_minus_true():
    added = function(AHRS, "strapdown", "q", lambda q: q.xreplace({s: -s for s in ahrs.bias.symbols}))
    (check,) = check_words(added)
    assert check.entry == "gyro_bias says measured - true; strapdown takes it off its sensor -1 times"


def test_metres_of_a_latitude_are_metres_to_the_north():
    errors = {s: -s for s in gnss_ins_21.d_position.symbols[:2]}
    position = gnss_ins_21.p.name
    check = check_feedback(Exact(function(GNSS, "feedback", position, lambda p: p.xreplace(errors))))
    assert check.entry.startswith("lat by dr_n: ")
