"""The clock of a regular sensor out of jittered tags, and what raw differences of the tags make of a flight."""

import numpy as np
import pytest

from boresight import BoresightError
from boresight.evidence.flights.motion import DEG, quaternion, swinging, turn_between
from boresight.runtime.clock import Clock, regular
from boresight.runtime.library import load


def tags(count, interval, jitter, lost=(), drift=0.0, late=(), seed=1):
    """(K,) numbers of the intervals, their true ends s, and the tags, uniformly within +-jitter."""
    rng = np.random.default_rng(seed)
    number = np.setdiff1d(np.arange(count), lost)
    true = 3 + interval * number + drift * (interval * number) ** 2 / 2
    tag = true + jitter * rng.uniform(-1, 1, len(number))
    tag[np.asarray(late, int)] += 0.05
    return number, true, tag


@pytest.mark.parametrize(
    ("jitter", "lost", "late"),
    [(0.0, (), ()), (1e-6, range(70, 1000, 7), ()), (5e-4, (300, 301, 302, 2500), (500, 1700)), (6e-3, (1500,), ())],
)
def test_tags_of_a_recording_lie_on_the_line_of_their_clock(jitter, lost, late):
    number, true, tag = tags(3000, 0.01, jitter, list(lost), late=late)
    found = regular(tag)
    assert found.missing.sum() == len(lost)
    # where the jitter is a third of an interval a loss is placed to some samples
    assert np.count_nonzero(np.cumsum(found.missing + 1) - 1 != number) <= (10 if jitter > 0.003 else 0)
    assert found.interval_s == pytest.approx(0.01, rel=1e-4 if jitter else 1e-9)
    assert np.median(np.abs(found.time - true)) <= jitter / 10 + 1e-9
    assert found.jitter_s == pytest.approx(jitter / np.sqrt(3), rel=0.1, abs=1e-9)


def test_a_slow_drift_bends_the_line():
    _, true, tag = tags(6000, 0.1, 0.02, drift=3e-7)  # 18 ppm in a minute, 54 ms in ten
    assert np.abs(regular(tag).time - true).max() < 5e-3
    clock = Clock(0.1)
    live = np.array([clock.sample(t).time for t in tag])
    assert np.abs(live - true)[500:].max() < 5e-3
    straight = np.polyval(np.polyfit(np.arange(6000), tag, 1), np.arange(6000))
    assert np.abs(straight - true).max() > 9e-3


@pytest.mark.parametrize("bad", [[1.0, 2.0], np.r_[np.arange(20.0), np.nan], -np.arange(20.0)])
def test_tags_that_cannot_be_a_sensors_are_refused(bad):
    with pytest.raises(BoresightError, match="clock: the tags"):
        regular(bad)


def test_tags_of_events_are_refused():
    with pytest.raises(BoresightError, match="leave the line of a regular clock"):
        regular(np.cumsum(np.random.default_rng(3).exponential(1.0, 500)))


def test_a_counter_tells_lost_samples_at_once_and_may_wrap():
    number, true, tag = tags(1000, 0.01, 0.006, lost=[255, 256, 700])
    clock = Clock(0.01 * 1.0005, modulo=256)
    ticks = [clock.sample(t, int(n) % 256) for t, n in zip(tag, number, strict=True)]
    assert np.array_equal(np.cumsum([tick.missing + 1 for tick in ticks]) - 1, number)
    assert np.abs(np.array([tick.time for tick in ticks]) - true)[100:].max() < 0.002
    assert np.abs(np.array([tick.dt for tick in ticks]) - 0.01).max() < 1e-5
    again = clock.sample(tag[-1], int(number[-1]) % 256)
    assert again.missing == 255 or again.time <= ticks[-1].time + 1e-3


@pytest.mark.parametrize(("jitter", "within"), [(5e-4, 3), (6e-3, 25)])
def test_without_a_counter_a_lost_sample_is_a_step_seen_after_some_samples(jitter, within):
    _, true, tag = tags(4000, 0.01, jitter, lost=[2000])
    clock = Clock(0.01)
    ticks = [clock.sample(t) for t in tag]
    seen = np.flatnonzero([tick.missing for tick in ticks])
    assert [ticks[k].missing for k in seen] == [1]
    assert 2000 <= seen[0] < 2000 + within
    assert np.abs(np.array([tick.time for tick in ticks]) - true)[seen[0] :].max() < jitter / 3


def test_a_host_that_stalls_and_catches_up_has_lost_nothing():
    _, _, tag = tags(2000, 0.01, 5e-4)
    stalled = np.maximum(tag, np.where((tag > 13) & (tag < 13.3), 13.3, tag))
    clock = Clock(0.01)
    ticks = [clock.sample(t) for t in stalled]
    assert not any(tick.missing for tick in ticks)
    assert np.abs(np.array([tick.time for tick in ticks]) - tag)[200:].max() < 1.5e-3


def test_a_clock_that_is_set_moves_the_line_and_a_tag_that_is_no_number_stands_on_it():
    number, _, tag = tags(600, 0.01, 5e-4)
    clock = Clock(0.01)
    tag[300:] += 7.0
    tag[100] = np.nan
    ticks = [clock.sample(t, int(n)) for t, n in zip(tag, number, strict=True)]
    assert not any(tick.missing for tick in ticks)
    assert ticks[100].time == pytest.approx(4.0, abs=2e-4)
    assert ticks[-1].time == pytest.approx(7 + 3 + 0.01 * 599, abs=2e-3)


def test_raw_differences_spoil_a_flight_and_the_line_does_not():
    """Rates with jittered tags, 100 Hz, a minute known: rms over 3 s of attitude, deg, and velocity, m/s."""
    motion, model = swinging(), load("velocity-attitude")
    _, true, tag = tags(6301, 0.01, 0.006)
    true, tag = true - 63, tag - 63
    clock = Clock(0.01)
    ticks = [clock.sample(t) for t in tag]
    lengths = {"raw": np.diff(tag[-301:]), "live": np.array([tick.dt for tick in ticks])[-300:],
               "recording": np.full(300, regular(tag).interval_s)}  # fmt: skip
    dtheta, dv = (part / 0.01 for part in motion.increments(true[-301:]))
    start = {"lat_lon_height": motion.position(0.0), "v_n": motion.velocity(np.array(0.0))[0],
             "q_b2n_wxyz": quaternion(motion.C_b2n(np.array(0.0))), "gyro_bias": np.zeros(3),
             "accel_bias": np.zeros(3)}  # fmt: skip
    C, v = motion.C_b2n(true[-300:]), motion.velocity(true[-300:])[0]
    off = {}
    for name, dt in lengths.items():
        dt = np.maximum(dt, 1e-4)  # a raw difference may be below zero
        nav, track = dict(start), []
        for k in range(300):
            before = max(k - 1, 0)
            nav |= model.strapdown(
                **nav, dtheta_ib_b=dtheta[k] * dt[k], dv_b=dv[k] * dt[k], dtheta_before=dtheta[before] * dt[k],
                dv_before=dv[before] * dt[k], dt=dt[k],
            )  # fmt: skip
            track.append((nav["q_b2n_wxyz"], nav["v_n"]))
        q, v_n = (np.array(part) for part in zip(*track, strict=True))
        off[name] = np.sqrt(np.mean(turn_between(q, C) ** 2)) / DEG, np.sqrt(np.mean((v_n - v) ** 2))
    assert round(off["raw"][0], 2) == 0.03 and max(off["live"][0], off["recording"][0]) < 4e-5
    for i in range(2):
        assert off["raw"][i] > 20 * off["live"][i] and off["raw"][i] > 50 * off["recording"][i]
