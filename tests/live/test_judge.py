"""The judge of the live loop: its F and H against the model's, its information against least squares."""

import numpy as np
import pytest
from judge import ACCEL_BIAS, DV, GYRO_BIAS, MOUNT, PHI, TAU, N, information, inside, judged, nees, observed, system
from loops import fly_live
from simulator import MOTIONS, derivative, quaternion, standard, track

from boresight import load

MOUNTING, LEVER = np.array([0.03, -0.05, 0.7]), np.array([-2.4, 1.2, 1.75])


@pytest.mark.parametrize("name", ["ship", "s-turns", "loiter"])
def test_what_is_linear_here_is_so_in_the_model(name):
    model, true = load("velocity-attitude"), track(MOTIONS[name], 20, 50, MOUNTING, LEVER)
    t = np.linspace(1, 19, 7)
    place = true.place_at(t)
    omega_ib_b, _, f_b = true.rates(t, place)
    nav = {"lat_lon_height": place, "v_n": true.motion.v_n(t), "q_b2n_wxyz": quaternion(true.attitude(t)[1])}
    assert np.abs(system(true, t)[0] - model.F(**nav, f_b=f_b)).max() < 1e-12
    H, q_b2m, a_n = observed(true, t), quaternion(true.C_b2m), derivative(lambda s: true.master(s)[0], t)
    assert np.abs(H[:, 3:] - model.dcm_H(**nav, q_b2m_wxyz=q_b2m, omega_ib_b=omega_ib_b)).max() < 1e-12
    # as in the residual, but for the level's rate on the lever arm
    slow = 3.2 * np.abs(true.motion.v_n(t)).max() / 6.3e6
    assert np.abs(H[:, :3] - model.velocity_H(**nav, omega_ib_b=omega_ib_b, lever_b=LEVER, a_n=a_n)).max() < slow


def test_information_is_that_of_least_squares():
    """Of all messages at once, over one long product of transition matrices, without noise of the slave."""
    flight = standard("loiter", seconds=15.0, runs=1, gyro_noise=0.0, accel_noise=0.0, tau_noise=0.0)
    sent, setting = flight.messages, flight.setting
    measured, came = sent.measured[:, 0], sent.came[:, 0]
    sigmas = setting.sigmas()
    start = np.zeros(N)
    start[PHI], start[DV], start[GYRO_BIAS], start[ACCEL_BIAS] = 10, 100, sigmas["gyro_bias"], sigmas["accel_bias"]
    start[MOUNT], start[TAU] = sigmas["q_b2m_wxyz"], setting.tau_sigma
    rows, Phi, now = [np.diag(1 / start)], np.eye(N), measured[0]
    for m in np.argsort(measured):
        steps = 40
        dt = (measured[m] - now) / steps
        for F in system(flight.track, now + dt * (np.arange(steps) + 0.5))[0]:
            Phi = (np.eye(N) + F * dt + F @ F * dt**2 / 2) @ Phi
        now = measured[m]
        if came[m]:
            rows.append(observed(flight.track, measured[m : m + 1])[0] @ Phi / np.sqrt(sent.R[m, 0])[:, None])
    # orthogonal triangles instead of normal equations: nothing is squared
    inverse = np.linalg.inv(np.linalg.qr(np.concatenate(rows), mode="r"))
    sigma = np.sqrt(np.diagonal(Phi @ inverse @ inverse.T @ Phi.T))
    np.testing.assert_allclose(information(flight, runs=1)[1][-1, 0], sigma, rtol=2e-3)


def test_rest_and_a_steady_turn_say_nothing_of_the_delay_and_a_small_roll_does():
    last = {}
    for name in ("parked", "steady turn", "small roll", "ship"):
        last[name] = information(standard(name, seconds=40.0, runs=1), runs=1)[1][-1, 0, TAU]
    assert last["parked"] > 0.04999 and last["steady turn"] > 0.0499
    assert 8e-3 < last["small roll"] < 11e-3 and 0.2e-3 < last["ship"] < 0.3e-3


def test_the_band_is_that_of_thirty_runs():
    """That of the figures on record, 12.8 to 19.6, and as chance has it."""
    assert [inside(mean, 30) for mean in (12.7, 12.9, 19.5, 19.7)] == [False, True, True, False]
    means = np.random.default_rng(5).chisquare(N * 30, 100_000) / 30
    assert 50 < sum(not inside(mean, 30) for mean in means) < 150


def test_nees_of_what_is_drawn_from_P_is_sixteen():
    random = np.random.default_rng(4)
    root = random.standard_normal((N, N)) * np.logspace(-6, 2, N)[:, None]
    errors = (root @ random.standard_normal((20000, N, 1)))[..., 0]
    assert abs(nees(errors, np.broadcast_to(root @ root.T, (20000, N, N))).mean() - N) < 0.2


def test_a_healthy_flight_is_consistent_and_knows_no_more_than_there_is():
    flight = standard("ship", seconds=20.0, runs=10)
    record = fly_live(flight)
    found = judged(record, 20.0)
    assert not record.raised and not record.notes
    assert 12 < found.nees < 21
    of = information(flight, runs=1)[1][-1, 0]
    assert (found.claimed > 0.95 * of).all() and found.claimed[TAU] < 1.3 * of[TAU]
    # the judge sees an error that is not in P
    record.errors[-1][:, TAU] += 5 * found.claimed[TAU]
    assert judged(record, 20.0).nees_end > found.nees_end + 0.5
