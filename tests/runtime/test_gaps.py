"""Samples of the slave that are lost or no numbers, flown on a motion that the filter does not share."""

import numpy as np
import pytest

from boresight import BoresightError
from boresight.evidence.flights.fly import band, fly
from boresight.evidence.flights.motion import DEG, swinging
from boresight.runtime.calibration import Calibration
from boresight.runtime.library import load
from boresight.runtime.transfer import Rules, Transfer, Verdict
from boresight.runtime.transfer.gaps import Gaps
from boresight.runtime.transfer.history import History
from boresight.runtime.transfer.rules import Watch

RUNS, AT = 20, 3.05  # s, when samples begin to be missing
FLOWN = {"runs": RUNS, "imu_hz": 100, "seconds": 4.2, "tau": 0.0, "tau_sigma": 1e-3, "lost": 0.0, "jitter": 0.0}


def without(count, runs=slice(0), axes=slice(None)):
    """So many samples from AT on are lost, or, in the runs given, no numbers in these axes of the gyros."""

    def sensed(time, dtheta, dv):
        if not AT - 1e-6 < time < AT + count / 100 - 1e-6:
            return dtheta, dv
        if runs == slice(0):
            return None
        dtheta = dtheta.copy()
        dtheta[runs, axes] = np.nan
        return dtheta, dv

    return sensed


@pytest.fixture(scope="module")
def motion():
    return swinging()


@pytest.fixture(scope="module")
def whole(motion):
    return fly(motion, **FLOWN)


def behind(flown):
    """NEES (runs,) of the messages behind what was missing, the first one and the mean of all."""
    later = flown.time > AT + 0.01
    return flown.nees[later][0].mean(), flown.nees[later].mean()


@pytest.mark.parametrize(
    "sensed",
    [without(1), without(10), without(1, runs=slice(None)), without(10, runs=slice(None), axes=1)],
    ids=["one lost", "ten lost", "one no number", "ten no numbers in one axis"],
)
def test_what_is_missing_up_to_the_stated_time_is_bridged_and_p_is_opened_by_it(motion, sensed):
    flown = fly(motion, sensed=sensed, **FLOWN)
    low, high = band(RUNS, 16)
    assert all(low < nees < high for nees in behind(flown))
    (note,) = [note for note in flown.loop.notes if "bridged" in note.text]
    assert "s of the slave were missing and are bridged; P is opened" in note.text
    assert not flown.loop.gaps.lost.any()


def test_p_is_opened_by_what_the_line_between_two_samples_misses():
    """Rates of constant curvature: the line misses the same everywhere, and P is opened by its square."""
    time = np.arange(51) / 100
    curve = np.array([0.3, -0.2, 0.0, 5.0, 1.0, 0.0])  # rad/s^3, m/s^4

    def between(begin, end):
        return curve * (end**3 - begin**3) / 3 + np.array([0.1, 0, 0, 0, 0, -9.8]) * (end - begin)

    gaps = Gaps(Watch(Rules(), (1,), 0.0), np.zeros((1, 6)))
    history = History(0.5, 1)
    for now in time[:-6]:
        sums = between(0.0, now)[None]
        history.append(now, angle=sums[:, :3], push=sums[:, 3:], v_n=np.zeros((1, 3)), q_b2n_wxyz=np.ones((1, 4)))
    gaps.rates = between(time[-8], time[-7])[None] * 100
    gaps.stand_in(np.ones(1, bool), gaps.rates, 0.05)  # five are missing, and the last one is there
    after = between(time[-2], time[-1])[None] * 100
    stood_in = gaps.stood_in.copy()
    more, variance = gaps.sample(np.ones(1, bool), after, 0.01, time[-1], history, np.eye(16)[None])
    missed = between(time[-7], time[-2]) - (stood_in + more)[0]
    assert np.sqrt(variance[0]) == pytest.approx(np.abs(missed), rel=1e-6, abs=1e-15)
    assert np.abs(missed[0]) < 0.05 * np.abs((between(time[-7], time[-2]) - stood_in[0])[0])  # held: far worse


def test_a_sample_that_is_no_number_in_one_run_leaves_the_others_as_they_were_to_the_bit(motion, whole):
    flown = fly(motion, sensed=without(1, runs=3, axes=1), **FLOWN)
    others = np.arange(RUNS) != 3
    assert np.array_equal(flown.errors[:, others], whole.errors[:, others])
    assert np.array_equal(flown.P[:, others], whole.P[:, others])
    assert not np.array_equal(flown.errors[-1, 3], whole.errors[-1, 3])
    assert [note.runs.tolist() for note in flown.loop.notes] == [[3]]


@pytest.mark.parametrize("runs", [slice(0), slice(None), 3], ids=["lost", "no numbers", "no numbers in one run"])
def test_beyond_it_the_filter_begins_anew_from_the_next_message_and_keeps_what_it_has_estimated(motion, runs):
    flown = fly(motion, sensed=without(300, runs=runs), **(FLOWN | {"seconds": 7.2}))
    begun = np.flatnonzero((flown.verdict == Verdict.BEGUN).any(1))
    assert len(begun) == 1 and AT + 3 < flown.time[begun[0]] < AT + 3.5
    low, high = band(RUNS, 16)
    nees = flown.nees[begun[0] :]
    assert low < nees[0].mean() < high and low < nees.mean() < high
    before = np.flatnonzero(flown.time < AT)[-1]
    which = slice(None) if isinstance(runs, slice) else runs
    sigma = [np.sqrt(flown.P[k, which][..., range(6, 16), range(6, 16)]) for k in (before, begun[0])]
    assert (sigma[1] < 1.01 * sigma[0]).all()
    texts = " ".join(str(note) for note in flown.loop.notes)
    assert "s of the slave are missing: the filter begins anew from the next message" in texts
    assert "the filter has begun anew, 3." in texts
    during = (flown.time > AT + 0.2) & (flown.time < AT + 3)
    assert np.isin(flown.verdict[during][:, which], [Verdict.MISSED, Verdict.AHEAD]).all()


def test_the_kept_block_of_p_grows_by_the_stated_walk(motion):
    walk = {"gyro_bias_noise": np.full(3, 1e-5), "accel_bias_noise": np.full(3, 1e-3)}
    flown = fly(motion, sensed=without(300), constants=walk, **(FLOWN | {"seconds": 6.5}))
    begun = np.flatnonzero((flown.verdict == Verdict.BEGUN).any(1))[0]
    before = np.flatnonzero(flown.time < AT)[-1]
    seconds = flown.time[begun] - flown.time[before]
    for states, name in ((range(6, 9), "gyro_bias_noise"), (range(9, 12), "accel_bias_noise")):
        grown = flown.P[begun][:, states, states] - flown.P[before][:, states, states]
        assert grown == pytest.approx(seconds * walk[name][0] ** 2, rel=0.02)


def test_one_sample_in_ten_may_be_lost(motion):
    lost = np.random.default_rng(3).random(421) < 0.1
    flown = fly(motion, sensed=lambda t, d, v: None if lost[round(max(t, 0) * 100)] and t > 0.1 else (d, v), **FLOWN)
    low, high = band(RUNS, 16)
    assert low < flown.nees[flown.time > 2].mean() < high
    assert np.mean(flown.verdict != Verdict.TAKEN) < 0.02


IMPOSSIBLE = [(1.005, 0.01), (np.nan, 0.01), (1.01, 0.0), (1.01, -0.01), (1.01, np.nan), (0.5, 0.01)]


def test_an_interval_that_cannot_be_is_left_out_and_told_once(motion):
    loop = fly(motion, **(FLOWN | {"seconds": 1.0, "runs": 2})).loop
    for k, (time, dt) in enumerate(IMPOSSIBLE):
        nav = {name: value.copy() for name, value in loop.nav.items()}
        for _ in range(3):
            loop.slave(time + 0.01 * k, np.zeros(3), np.zeros(3), dt)
        assert all(np.array_equal(nav[name], value) for name, value in loop.nav.items())
        told = [note for note in loop.notes if "begins before the last one ended, or is none" in note.text]
        assert len(told) == k + 1 and "left out" in told[-1].text
        loop.slave(1.01 + 0.01 * k, np.zeros(3), np.array([0, 0, -0.098]), 0.01)


def test_a_clock_of_the_slave_that_is_set_back_for_good_is_followed(motion):
    loop = fly(motion, **(FLOWN | {"seconds": 0.8, "runs": 2})).loop
    for k in range(30):
        loop.slave(0.2 + k / 100, np.zeros(3), np.array([0, 0, -0.098]), 0.01)
    assert loop.time == pytest.approx(0.49) and loop.gaps.lost.all()


KNOWN = Calibration(gyro_bias=np.array([2.0, -3.0, -2.0]) * DEG, accel_matrix=np.diag([1.02, 0.99, 1.0]))


def uncalibrated(time, dtheta, dv):
    return dtheta + KNOWN.gyro_bias / 100, dv @ np.linalg.inv(KNOWN.accel_matrix).T


def test_a_known_bias_beyond_the_models_range_is_taken_off_first(motion):
    flown = fly(motion, sensed=uncalibrated, known=KNOWN, **FLOWN)
    low, high = band(RUNS, 16)
    assert low < flown.nees[flown.time > 2].mean() < high


def test_full_scale_is_of_what_the_sensor_delivers_biases_in_it(motion):
    for known, told in ((KNOWN, True), (None, False)):
        rules = Rules(full_scale=(17 * DEG, np.inf))
        flown = fly(motion, sensed=uncalibrated if known else None, known=known, rules=rules,
                    **(FLOWN | {"seconds": 2.0}))  # fmt: skip
        assert any("gyro is at full scale" in note.text for note in flown.loop.notes) == told


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [("gyro_bias", [2 * DEG, 0, 0], r"gyro_bias\[0\] is 0.0349066.*give the known bias, known=Calibration"),
     ("lat_lon_height", [86 * DEG, 0, 0], r"latitude is 1.50098, and the model's range is -1.48353 to 1.48353$")],
)  # fmt: skip
def test_a_slave_beyond_the_models_range_is_refused_and_told_what_to_do(motion, name, value, said):
    loop = fly(motion, **(FLOWN | {"seconds": 0.1, "runs": 2})).loop
    with pytest.raises(BoresightError, match=said):
        Transfer(load("velocity-attitude"), loop.nav | {name: np.array(value)}, loop.P, loop.constants)
