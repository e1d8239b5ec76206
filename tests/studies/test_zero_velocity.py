"""Zero-velocity updates: on a walk that is simulated and so known, and on the real recording."""

import numpy as np
import pytest
from tools import real_recording

from boresight import BoresightError
from boresight.runtime.library import load
from boresight.runtime.recording import Inertial, Recording, read
from boresight.studies.replays import zero_velocity

SIGMA_GYRO, SIGMA_ACCEL = 1e-3, 4e-3


@pytest.fixture(scope="module")
def models(compiled_once):
    return load("azimuth-hold"), load("strapdown")


def walk(seconds=60.0, rate_hz=100, seed=3):
    """A sensor level and pointing north: 12 s of rest, then steps of 1 m north, 2 s each, with 2 s of rest between.

    Front-right-down rates and specific force at the samples; returns the recording and the true way north (m).
    """
    dt = 1 / rate_hz
    t = np.arange(round(seconds * rate_hz)) * dt
    phase = (t - 12.0) % 4.0
    moving = (t >= 12.0) & (phase < 2.0)
    accel_n = np.where(moving, np.pi / 2 * np.sin(np.pi * phase), 0.0)  # one metre in two seconds, from rest to rest
    way = np.cumsum(np.cumsum(accel_n) * dt) * dt
    rng = np.random.default_rng(seed)
    lat, g = np.radians(59.3), 9.8186
    earth = 7.292115e-5 * np.array([np.cos(lat), 0.0, -np.sin(lat)])
    gyro = earth + [2e-3, -1e-3, 5e-4] + SIGMA_GYRO * rng.standard_normal((len(t), 3))
    accel = np.stack([accel_n, 0 * t, 0 * t - g], axis=1) + SIGMA_ACCEL * rng.standard_normal((len(t), 3))
    imu = Inertial("rates", "middle", t, gyro, accel)
    return Recording("walk", imu, None, {}, "a walk"), way


def test_the_walk_is_followed_and_every_stop_is_seen(models):
    recording, way = walk()
    result = zero_velocity.run(recording, *models, rest=(0.0, 10.0))
    assert len(result["stops"]) == 12
    # the updates hold what pure inertial loses in a minute to noise and bias
    assert abs(result["history"]["track_m"][-1, 1] - way[-1]) < 0.15
    pure = zero_velocity.run(recording, *models, rest=(0.0, 10.0), updates=False)
    assert abs(pure["history"]["track_m"][-1, 1] - way[-1]) > 0.5
    assert max(stop["speed_m_s"] for stop in result["stops"]) < 0.1


def test_velocity_updates_while_moving_spoil_the_way(models):
    """What the detector is for: told to rest all the time, the filter holds a walker where he started."""
    recording, way = walk()
    blind = zero_velocity.run(recording, *models, rest=(0.0, 10.0), detector="accel_mean")
    assert abs(blind["history"]["track_m"][-1, 1] - way[-1]) > 1.0


def test_the_real_square_closes_and_its_stops_are_slow(models):
    recording = read(real_recording("foot_mounted_square.npz"))
    result = zero_velocity.run(recording, *models)
    first = result["detection"]["detectors"]["likelihood_ratio"]["first_rest_end_s"]
    assert abs(first - 16.0) <= 0.1
    assert result["end_from_start_m"] < 0.1
    assert max(stop["speed_m_s"] for stop in result["stops"]) < 0.1
    # mean NIS of first updates, three degrees of freedom each: the 99 % band of chi-square
    n = len(result["stops"])
    from scipy.stats import chi2

    low, high = chi2.ppf([0.005, 0.995], 3 * n) / n
    assert low < result["nis_mean"] < high


def test_a_recording_that_does_not_begin_at_rest_is_refused(models):
    recording, _ = walk()
    imu = recording.imu
    accel = imu.accel + np.where((imu.time > 0.8) & (imu.time < 1.2), 3.0, 0.0)[:, None]  # a knock
    knocked = Recording("knocked", Inertial("rates", "middle", imu.time, imu.gyro, accel), None, {}, "knocked")
    with pytest.raises(BoresightError, match="must begin with two seconds of rest"):
        zero_velocity.run(knocked, *models, rest=(3.0, 10.0))


def test_an_unknown_detector_lists_the_right_ones(models):
    with pytest.raises(BoresightError, match=r"there are .*likelihood_ratio"):
        zero_velocity.run(walk()[0], *models, rest=(0.0, 10.0), detector="ear")


def test_a_gap_is_reported_and_the_filter_recovers(models):
    recording, way = walk()
    imu = recording.imu
    keep = (imu.time < 30.5) | (imu.time > 31.0)  # half a second lost in the middle of a rest
    cut = Inertial("rates", "middle", imu.time[keep], imu.gyro[keep], imu.accel[keep])
    result = zero_velocity.run(Recording("cut", cut, None, {}, "cut"), *models, rest=(0.0, 10.0))
    assert len(result["gaps_s"]) == 1
    assert abs(result["gaps_s"][0] - 31.01) < 0.011
    assert "31.0" in zero_velocity.report(result)
    assert abs(result["history"]["track_m"][-1, 1] - way[-1]) < 0.3
