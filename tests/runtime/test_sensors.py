"""Sensors' errors from their sizes: what a filter begins with is what such sensors are, and it stays consistent."""

import numpy as np
import pytest

from boresight import BoresightError
from boresight.runtime.library import load
from boresight.runtime.transfer import sensors
from boresight.runtime.transfer.score import Score
from boresight.runtime.transfer.sensors import CALIBRATION, GRADES, PROBE, Sensors, calibration, carried, sized
from boresight.runtime.units import DEG_H, STANDARD_GRAVITY

ALL = Sensors(1e-3, 1e-3, 1e-3, 1e-3, 3 * DEG_H, 1e-4 * STANDARD_GRAVITY, 100.0, 3e-4, 1.0)
SIGMAS = {"q_b2m_wxyz": np.full(3, 0.1), "gyro_bias": np.full(3, 1e-3), "accel_bias": 0.02, "tau": 0.05}


def test_states_stand_where_the_model_has_them(compiled_once):
    names = load(sensors.MODEL).states
    first = {"lever_b": "d_lever_x", "flexure": "d_bend_x", "flexure_rate": "d_bend_rate_x", "gyro_scale": "dkg_x",
             "accel_scale": "dka_x", "gyro_axes": "dkg_xy", "accel_axes": "dka_yx", "gyro_turn_on": "dbg0_x",
             "accel_turn_on": "dba0_x"}  # fmt: skip
    assert len(names) == sensors.N
    assert {name: part.start for name, part in sensors.ADDED.items()} == {n: names.index(s) for n, s in first.items()}
    assert sorted(i for part in sensors.ADDED.values() for i in range(sensors.N)[part]) == list(range(16, sensors.N))


def calibrations(sizes, units):
    """(units, 15) K of both triads, true = (I - K) shown, in the order of the filter's states, of axes each of which
    leaves its place in the case by itself; in the axes of the accelerometers, x' = Q x."""
    rng = np.random.default_rng(1)
    gyro, accel = (
        np.eye(3) + axes * rng.standard_normal((units, 3, 3)) * (1 - np.eye(3))
        + scale * rng.standard_normal((units, 3, 1)) * np.eye(3)
        for scale, axes in ((sizes.gyro_scale, sizes.gyro_axes), (sizes.accel_scale, sizes.accel_axes))
    )  # fmt: skip
    q, r = np.linalg.qr(np.swapaxes(accel, -1, -2))  # accel = L Q, L with a positive diagonal
    sign = np.sign(np.diagonal(r, axis1=-2, axis2=-1))
    L, Q = np.swapaxes(r * sign[..., None], -1, -2), np.swapaxes(q * sign[:, None, :], -1, -2)
    K_g, K_a = np.eye(3) - np.linalg.inv(gyro @ np.swapaxes(Q, -1, -2)), np.eye(3) - np.linalg.inv(L)
    return np.concatenate([
        np.diagonal(K_g, axis1=1, axis2=2), np.diagonal(K_a, axis1=1, axis2=2), K_g[:, ~np.eye(3, dtype=bool)],
        K_a[:, [1, 2, 2], [0, 0, 1]],
    ], axis=-1)  # fmt: skip


def test_the_covariance_of_the_calibration_is_that_of_axes_that_leave_their_places():
    """K of 20000 units, of which each axis has moved by itself; the axes of gyros and accelerometers by different."""
    sizes = Sensors(1e-3, 2e-3, 1e-3, 2e-3)
    drawn = calibrations(sizes, 20000)
    expected = calibration(sizes)
    sigma = np.sqrt(np.diag(expected))
    np.testing.assert_allclose(drawn.T @ drawn / len(drawn) / np.outer(sigma, sigma),
                               expected / np.outer(sigma, sigma), atol=5 / np.sqrt(20000))  # fmt: skip
    assert sigma[6] == pytest.approx(np.hypot(1e-3, 2e-3))


def test_what_has_no_size_has_neither_variance_nor_noise():
    constants, P, estimates, _ = carried(Sensors(), {"lever_b": np.ones(3)}, SIGMAS, {})
    np.testing.assert_allclose(np.sqrt(np.diag(P)), np.repeat([0, 1e-3, 0.02, 0.1, 0.05, 0], [6, 3, 3, 3, 1, 30]))
    assert not any(np.any(constants[name]) for name in ("gyro_bias_noise", "accel_bias_noise", "flexure_noise"))
    assert "lever_b" not in constants and (estimates["lever_b"] == 1).all()


def test_scale_factors_and_axes_are_considered_and_estimated_by_choice():
    np.testing.assert_array_equal(np.flatnonzero(carried(ALL, {}, SIGMAS, {}).considered), range(25, 40))
    assert not carried(Sensors(1e-3, estimated=True), {}, SIGMAS, {}).considered.any()


def test_a_bias_is_its_constant_and_what_wanders_about_it():
    sizes = Sensors(gyro_instability=4e-3, correlation_s=2)
    constants, P, estimates, _ = carried(
        sizes, {"gyro_bias_noise": np.full(3, 3e-3)}, SIGMAS, {"gyro_bias": np.ones(3)}
    )
    np.testing.assert_allclose(constants["gyro_bias_noise"], 5e-3)
    np.testing.assert_allclose(np.diag(P)[6:9], 17e-6)
    np.testing.assert_allclose(P[6:9, 40:43], 1e-6 * np.eye(3))
    np.testing.assert_array_equal(estimates["gyro_turn_on"], 1.0)


def test_a_sigma_of_nothing_is_refused():
    with pytest.raises(BoresightError, match="no sigma of 'bias'; there are gyro_bias"):
        carried(ALL, {}, {"bias": 1.0}, {})


def test_sizes_are_read_in_words_upon_those_of_a_grade():
    assert sized(grade="tactical") == GRADES["tactical"]
    said = sized(["scale 0.2 %", "axes 2 mrad", "bending 3 mrad 0.5 Hz"], "navigation", "1 deg/h", correlation="50 s")
    assert (said.gyro_scale, said.accel_axes, said.bending, said.bending_hz) == (0.002, 0.002, 0.003, 0.5)
    assert said.gyro_instability == pytest.approx(DEG_H) and said.correlation_s == 50
    assert said.accel_instability == GRADES["navigation"].accel_instability


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"words": ["gain 3 ppm"]}, "give scale, axes or bending"),
        ({"words": ["bending 3 mrad"]}, "bending 2 mrad 0.1 Hz"),
        ({"words": ["scale 3 mrad"]}, "units 1, %, ppm"),
        ({"words": ["axes 100 mrad"]}, "0.02 at most"),
        ({"words": ["axes -1 mrad"]}, "zero or more"),
        ({"grade": "marine"}, "there are mems, industrial, tactical, navigation"),
        ({"estimated": True}, "have no size"),
        ({"correlation": "3 s"}, "of an instability"),
    ],
)
def test_sizes_that_say_nothing_are_refused(arguments, says):
    with pytest.raises(BoresightError, match=says):
        sized(**arguments)


@pytest.mark.parametrize("larger", [0.3, 1.0, 4.0])
def test_the_score_is_not_larger_than_chi_square_whatever_r_is(larger, monkeypatch):
    """Innovations so many times larger than the filter says; 300 flights of 200 messages that show all parameters."""
    monkeypatch.setattr("boresight.runtime.transfer.score.detectable", lambda *_: 0.0)  # dear, and not asked here
    rng, runs = np.random.default_rng(6), 300
    score = Score((runs,))
    P = np.eye(46) * 1e-30
    for _ in range(200):
        H = np.zeros((3, 46))
        H[:, :3] = np.linalg.qr(rng.standard_normal((3, 3)))[0]
        P[CALIBRATION, :3] = rng.standard_normal((15, 3)) * PROBE**2
        score.begin()
        score.take(larger * rng.standard_normal((runs, 3)), H, P, np.ones(3), np.ones((runs, 3), bool))
        score.end(np.ones(runs, bool))
    for one in score.noticed().values():
        # each of four groups has its share of the one in a hundred
        assert (one.statistic > one.bound).sum() <= 5
        dof = {14.3: 3, 20.2: 6}[round(one.bound, 1)]
        assert one.statistic.mean() < dof * 1.15
        assert larger < 1 or one.statistic.mean() > dof * 0.7
