"""The simulator of the live loop against the strapdown and the measurements of velocity-attitude, without errors."""

import numpy as np
import pytest
from simulator import DEG, MOTIONS, omega_en_n, quaternion, standard, times, track, turn_between

from boresight import load


@pytest.fixture(scope="module")
def model():
    return load("velocity-attitude")


MOUNTING, LEVER = np.array([2.0, -3.0, 40.0]) * DEG, np.array([-2.4, 1.2, 1.75])


def drift(model, true):
    """Largest error of velocity (m/s), attitude (rad) and place (m, of height and of the level) along a track."""
    nav = {
        "lat_lon_height": true.place[0],
        "v_n": true.v_n[0],
        "q_b2n_wxyz": true.q_b2n_wxyz[0],
        "gyro_bias": np.zeros(3),
        "accel_bias": np.zeros(3),
    }
    dt, worst = true.time[1], np.zeros(3)
    for k in range(len(true.dtheta)):
        before = max(k - 1, 0)
        nav |= model.strapdown(
            dtheta_ib_b=true.dtheta[k],
            dv_b=true.dv[k],
            dtheta_before=true.dtheta[before],
            dv_before=true.dv[before],
            dt=dt,
            **nav,
        )
        place = nav["lat_lon_height"] - true.place[k + 1]
        worst = np.maximum(
            worst,
            [
                np.abs(nav["v_n"] - true.v_n[k + 1]).max(),
                np.abs(turn_between(nav["q_b2n_wxyz"], true.q_b2n_wxyz[k + 1])).max(),
                np.abs(place * [6.4e6, 6.4e6 * np.cos(true.place[0, 0]), 1]).max(),
            ],
        )
    return worst


# the third order of the strapdown's steps; what is 8 times as large at 50 Hz is the strapdown's
@pytest.mark.parametrize(("name", "rate_hz"), [("ship", 100), ("s-turns", 100), ("catapult", 100), ("loiter", 50)])
def test_the_strapdown_stays_with_the_truth(model, name, rate_hz):
    true = track(MOTIONS[name], 20, rate_hz, MOUNTING, LEVER)
    velocity, attitude, place = drift(model, true)
    assert velocity < 0.4e-6 and attitude < 4e-9 and place < 10e-6
    # an interval that is counted twice is no truth
    true.dv[500] *= 2
    assert drift(model, true)[0] > 1e-2


def test_the_error_of_the_strapdown_falls_with_the_third_power_of_the_step(model):
    coarse, fine = (drift(model, track(MOTIONS["s-turns"], 10, hz, MOUNTING, LEVER))[:2] for hz in (50, 100))
    assert (np.abs(coarse / fine - 8) < 0.1).all()


@pytest.mark.parametrize("name", list(MOTIONS))
def test_messages_without_errors_have_no_residual(model, name):
    true = track(MOTIONS[name], 30, 50, MOUNTING, LEVER)
    t = np.linspace(1, 29, 57)
    place = true.place_at(t)
    v, q, _ = true.master(t)
    nav = {
        "lat_lon_height": place,
        "v_n": true.motion.v_n(t),
        "q_b2n_wxyz": quaternion(true.attitude(t)[1]),
        "omega_ib_b": true.rates(t, place)[0],
        "lag": 0.0,
    }
    z = model.velocity_z(**nav, lever_b=LEVER, v_m_n=v, a_n=np.zeros(3))
    # the model takes the lever arm's velocity against the level, which turns with the slave: 3.2 m / 6.4e6 m of v
    neglected = np.cross(omega_en_n(place, true.motion.v_n(t)), times(true.attitude(t)[1], LEVER))
    assert np.abs(z - neglected).max() < 1e-10
    assert np.abs(model.dcm_z(**nav, q_b2m_wxyz=quaternion(true.C_b2m), q_m2n_wxyz=q)).max() < 1e-12


def test_the_slave_at_the_rim_circles_about_a_master_that_stands():
    true = track(MOTIONS["turntable"], 36, 50, lever_b=(3.0, 0, 0))
    v, _, place = true.master(np.arange(1.0, 35.0))
    assert np.abs(v).max() < 1e-5  # the Earth's transport rate on 3 m
    assert np.abs((place - place[0]) * [6.4e6, 5.3e6, 1]).max() < 5e-3


def test_a_flight_draws_what_its_setting_says():
    flight = standard("calm", seconds=30.0, runs=20)
    assert len(flight.messages.stamp_us) == len(set(flight.messages.after.tolist()))
    assert abs(flight.messages.came[1:].mean() - 0.9) < 0.02
    v, q, _ = flight.track.master(flight.messages.stamp_us * 1e-6 - 0.035)
    assert abs(np.std(flight.messages.v_m_n - v) / 0.02 - 1) < 0.03
    assert abs(np.std(turn_between(flight.messages.q_m2n_wxyz, q)) / 0.3e-3 - 1) < 0.03
    white = (flight.dtheta - flight.track.dtheta[:, None] - flight.gyro_bias * 0.02) / np.sqrt(0.02)
    assert abs(np.std(white) / 3e-5 - 1) < 0.01
    kinds = [event[0] for event in flight.events(3)]
    assert kinds.count("sample") == 1500 and kinds.count("message") == flight.messages.came[:, 3].sum()
    # a message is never there before its stamp, and soon behind it
    newest = 0
    for kind, at_us, *_ in flight.events(3):
        if kind == "sample":
            newest = at_us
        else:
            assert 0 <= newest - at_us < 40_000
