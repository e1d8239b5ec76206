"""What h, H and F share with z and strapdown, which follow from them, is found by what these must do in any case."""

import sys
from dataclasses import replace

import pytest
from conftest import ROOT
from sympy import Matrix

from boresight import Measurement, variable
from boresight.codegen.flat import check_flat
from boresight.codegen.mechanics import Exact, check_feedback, check_residual
from boresight.codegen.noises import check_noise
from boresight.codegen.origins import check_origins
from boresight.codegen.residuals import check_residuals
from boresight.codegen.scales import check_scales
from boresight.codegen.words import check_words
from boresight.derive.mechanics.rotation import dcm_from_quaternion
from boresight.derive.models import built_in

sys.path.insert(0, str(ROOT / "examples"))
import ahrs
import autopilot
import gnss_ins
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
    checks = (*check_residuals(made), *check_origins(made), *check_scales(made), *check_noise(made))
    assert [check for check in checks if check.ok is not True] == []


C_b2n = dcm_from_quaternion(ahrs.q.vector)
shown = autopilot.nav["mag_i"].vector, autopilot.nav["mag_b"].vector
exchanged = {s: -s for s in gnss_ins_21.var.OMEGA_IB_B.symbols}
TURNED = {
    "a transposed attitude": (lambda: measured(AHRS, "accelerometer", z=C_b2n**2 * z(AHRS, "accelerometer")),
                              "accelerometer_z"),
    "a vector of the level for one of the body": (
        lambda: measured(AUTOPILOT, "mag", z=z(AUTOPILOT, "mag").xreplace(dict(zip(shown[1], shown[0], strict=True)))),
        "mag_z"),
    "a vector of the level beside one of the body": (
        lambda: measured(AUTOPILOT, "mag", z=shown[0] + shown[1] - autopilot.m_mag.vector), "mag_z"),
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


# ---------------------------------------------------------------- places, velocities, scales and noise

pos, terrain = autopilot.nav["pos"].vector, autopilot.nav["terrain"].vector
wind = autopilot.nav["wind"].symbols
ORIGINS = {
    "the sign of a ground": ("height", terrain + pos[2:, :] - autopilot.m_height.vector),
    "no ground": ("height", -pos[2:, :] - autopilot.m_height.vector),
    "the sign of a wind": ("airspeed", z(AUTOPILOT, "airspeed").xreplace({s: -s for s in wind})),
    "an axis of a place": ("position", z(AUTOPILOT, "position").xreplace({pos[0]: pos[1], pos[1]: pos[0]})),
}  # fmt: skip


@pytest.mark.parametrize("what", ORIGINS)
def test_a_z_that_hangs_on_an_origin_of_places_or_of_velocities_is_not_held(what):
    name, value = ORIGINS[what]
    (check,) = check_origins(measured(AUTOPILOT, name, z=Matrix(value)))
    assert (check.unit, check.ok) == (f"{name}_z", None)


def meant(made, name, text):
    """The model with another meaning of an input."""
    return replace(made, structs=tuple(
        replace(s, fields=tuple(replace(v, meaning=text) if v.name == name else v for v in s.fields))
        for s in made.structs
    ))  # fmt: skip


def test_a_bias_of_what_is_measured_adds_to_what_is_computed():
    bias = {s: -s for s in autopilot.nav["mag_b"].symbols}
    says = meant(AUTOPILOT, "mag_b", "bias of the magnetometer, measured - true")
    assert all(check.ok for check in check_residuals(says))
    entries = [
        c.entry for c in check_residuals(measured(says, "mag", z=z(says, "mag").xreplace(bias))) if c.ok is False
    ]
    assert entries == ["mag_b says measured - true; mag_z has -1 times it, not 1"]


def test_a_height_above_a_ground_that_nobody_estimates_is_a_height():
    above = measured(AUTOPILOT, "height", z=-pos[2:, :] - autopilot.m_height.vector)
    ground = meant(above, "terrain", "a number, down from the origin")
    assert [check.ok for check in check_origins(ground)] == [True]


def beacon(*places):
    """The autopilot with the distance to a constant place, or the difference of two such."""
    m = variable("measured", "measured", "m", "range to a beacon", -1e4, 1e4)
    metre = autopilot.constant("metre", "1", "m", "a metre")
    far = [Matrix([(p - c * metre) ** 2 for p, c in zip(pos, place, strict=True)]) for place in places]
    value = sum(sign * (sum(of) ** 0.5) for sign, of in zip((1, -1), far, strict=False)) - m.scalar
    seen = Measurement("beacon", ("range",), "m", "range: z = computed - measured", z=Matrix([value]), at_zero=True)
    return replace(AUTOPILOT, structs=(*AUTOPILOT.structs, autopilot.Struct("radio", "a beacon", (m,))),
                   measurements=(*AUTOPILOT.measurements, seen))  # fmt: skip


@pytest.mark.parametrize("places", [((7, 5, 3),), ((7, 5, 3), (2e4, 1, 9))])
def test_a_range_to_constant_places_is_none_of_these_faults(places):
    made = beacon(*places)
    assert [check.ok for check in (*check_origins(made), *check_scales(made))] == [True, True]


VELOCITY_ATTITUDE = built_in("velocity-attitude")
SCALES = {
    "a turn": (VELOCITY_ATTITUDE, "quaternion", lambda z: 2 * z,
               "for a turn of the measured attitude by 1 rad it grows by 2, not 1"),
    "a row that is an angle": (AUTOPILOT, "sideslip", lambda z: 2 * z,
                               "for a turn of the axes by 1 rad beta grows by 2, not 1"),
    "a speed": (AUTOPILOT, "airspeed", lambda z: 2 * z + autopilot.m_airspeed.vector,
                "for each m/s of vel tas grows by 2, not 1"),
    "an optical flow": (AUTOPILOT, "flow", lambda z: 2 * z + autopilot.m_flow.vector,
                        "the distance at which it sees what passes grows, for each metre of p_d, by 0.5, not 1"),
    "a direction": (AHRS, "magnetometer", lambda z: 2 * z + ahrs.mag.vector, "the length of the direction is 2, not 1"),
    "gravity": (AHRS, "accelerometer", lambda z: 2 * z + ahrs.accel.vector,
                "upwards, in parts of 9.8 m/s^2, it is 2.00204, not 1"),
    "the sign of gravity": (AHRS, "accelerometer", lambda z: -z - 2 * ahrs.accel.vector,
                            "upwards, in parts of 9.8 m/s^2, it is -1.00102, not 1"),
}  # fmt: skip


@pytest.mark.parametrize("what", SCALES)
def test_a_factor_of_a_whole_z_is_not_held(what):
    made, name, twice, why = SCALES[what]
    (check,) = check_scales(measured(made, name, z=twice(z(made, name))))
    assert (check.unit, check.ok, check.why) == (f"{name}_z", None, why)


def test_q_and_its_negative_are_one_attitude():
    half = Matrix([2 * e for e in ahrs.q.symbols[1:]])
    made = measured(AHRS, "accelerometer", z=half * autopilot.GRAVITY - ahrs.accel.vector)
    assert "it changes with the sign of q; q and -q are one attitude" in [check.why for check in check_residuals(made)]


noise = list(AUTOPILOT.noise)
states = AUTOPILOT.mechanics.driven
NOISE = {
    "twice a density": ({"noise": Matrix([2 * noise[0], *noise[1:]])}, "ng_x is taken 2 times"),
    "one that stands twice": ({"noise": Matrix([noise[1], *noise[1:]])},
                              "ng_y stands 2 times; ng_x drives nothing, gyro_noise else does"),
    "two exchanged": ({"mechanics": replace(AUTOPILOT.mechanics, driven=(
        *states[:4], (states[4][0], states[5][1]), (states[5][0], states[4][1]), *states[6:]))},
        "mag_i_noise is along n, e, d, and drives d_mag_b along x, y, z; "
        "mag_b_noise is along x, y, z, and drives d_mag_i along n, e, d"),
}  # fmt: skip


@pytest.mark.parametrize("what", NOISE)
def test_a_noise_that_is_not_what_its_words_say_is_not_held(what):
    change, why = NOISE[what]
    assert [(check.ok, check.why) for check in check_noise(replace(AUTOPILOT, **change))] == [(None, why)]


def test_two_noises_that_are_called_by_each_other_s_states_are_named():
    driven = list(GNSS.mechanics.driven)
    i, j = (
        next(k for k, (w, _) in enumerate(driven) if w.name == name)
        for name in ("gyro_scale_noise", "accel_scale_noise")
    )
    driven[i], driven[j] = (driven[i][0], driven[j][1]), (driven[j][0], driven[i][1])
    (check,) = check_noise(replace(GNSS, mechanics=replace(GNSS.mechanics, driven=tuple(driven))))
    assert check.why.startswith("gyro_scale_noise drives d_accel_scale, and accel_scale_noise what it is called by")


BLOCKS = {"the other sign": (-1, False), "twice": (2, False), "left out": (0, None), "as it is": (1, ())}


@pytest.mark.parametrize("what", BLOCKS)
def test_a_small_part_of_h_is_held_too(what):
    times, ok = BLOCKS[what]
    made = gnss_ins.GNSS_INS
    changed = {s: times * s for s in gnss_ins.var.D_BA.symbols}  # 1e-4 of a row
    for m in made.measurements:
        check = check_residual(made, replace(m, h=m.h.xreplace(changed)))
        assert (check.ok if check else ()) is ok


def test_h_is_zero_for_no_error_where_z_is_not_too():
    m = next(m for m in VELOCITY_ATTITUDE.measurements if m.name == "dcm")
    check = check_residual(VELOCITY_ATTITUDE, replace(m, h=m.h + m.z))
    assert (check.ok, check.entry[:10], check.entry[-17:]) == (False, "h of n is ", "where no error is")


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


def first_two(symbols):
    return dict(zip(symbols, (symbols[1], symbols[0], symbols[2]), strict=True))


def test_an_axis_is_the_same_of_an_error_and_its_estimate():
    other = function(GNSS, "feedback", "v_n", lambda v: v.xreplace(first_two(gnss_ins_21.dv.symbols)))
    (check,) = check_words(other)
    assert check.entry == "dv_e is by its name of axis e; feedback takes it off v_n"


def test_an_axis_is_the_same_of_a_bias_and_its_sensor():
    bias = autopilot.nav["accel_bias"].symbols
    (check,) = check_words(function(AUTOPILOT, "strapdown", "vel", lambda v: v.xreplace(first_two(bias))))
    assert check.entry == "accel_bias says measured - true; strapdown takes ba_y off its sensor along x"


def test_metres_of_a_latitude_are_metres_to_the_north():
    errors = {s: -s for s in gnss_ins_21.d_position.symbols[:2]}
    position = gnss_ins_21.p.name
    check = check_feedback(Exact(function(GNSS, "feedback", position, lambda p: p.xreplace(errors))))
    assert check.entry.startswith("lat by dr_n: ")
