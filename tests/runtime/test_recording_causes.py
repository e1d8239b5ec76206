"""Each falsified recording ends in its cause, in the first line; a healthy one in none.

tests/recordings_falsified.py makes them, and prints the table for as many healthy ones as asked for.
"""

import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import recordings_healthy
from recordings_falsified import FAULTS, Plan, Written, complaints, fly, healthy

from boresight.runtime.recording import Inertial, patterns, tags


@cache
def drive():
    return fly(Plan(), 1)


@pytest.mark.parametrize("name", FAULTS)
def test_the_first_line_names_the_cause(name, tmp_path):
    change, cause, limit = FAULTS[name]
    falsified = Written({key: values.copy() for key, values in drive().columns.items()})
    change(falsified)
    texts = complaints(falsified.write(tmp_path))
    assert not any("\n" in text for text in texts)
    if limit:
        assert not texts or re.search(cause, texts[0]), texts
    else:
        assert texts and re.search(cause, texts[0]), texts


def test_what_the_data_cannot_tell_are_six_at_most():
    assert sum(bool(limit) for _, _, limit in FAULTS.values()) <= 6 and len(FAULTS) >= 60


@pytest.mark.parametrize("seed", range(6))
def test_a_healthy_recording_has_no_error(seed, tmp_path):
    """More of them: python tests/recordings_falsified.py 1000."""
    assert [text for text in complaints(healthy(seed).write(tmp_path)) if text.startswith("error")] == []


@pytest.mark.parametrize("seed", [40060, 40285, 70178, 70520, 70674, 90218])
def test_a_healthy_recording_that_was_once_called_wrong_has_no_error(seed, tmp_path):
    """A mounting in a bank, a compass of hundredths of a degree, circles, steps that a slow master sums up, a swell."""
    path = recordings_healthy.write(recordings_healthy.healthy(seed)[0], tmp_path)
    assert [text for text in complaints(path) if text.startswith("error")] == []


# ---------------------------------------------------------------- tags alone


def test_a_counter_that_wraps_is_named_by_its_bits_and_its_unit():
    t = np.arange(4000) * 0.02
    for bits, unit, tick in ((16, "ms", 1e-3), (32, "ns", 1e-9), (16, "us", 1e-6)):
        span = 2**bits * tick
        wrapped = (np.arange(4000) * span / 500) % span if span < 1 else t % span
        found = tags.disorder(wrapped)
        assert f"a counter of {bits} bits wraps, in {unit}" in found and "do not sort" in found


def test_a_clock_that_was_set_back_is_not_to_be_sorted_and_rows_out_of_order_are():
    t = np.arange(3000) * 0.02
    back = np.where(np.arange(3000) < 1000, t, t - 7.3)
    assert "the clock was set back, by 7.3 s; cut the recording there" in tags.disorder(back)
    shuffled = t.copy()
    shuffled[[5, 6, 200, 203]] = shuffled[[6, 5, 203, 200]]
    assert "4 rows are out of order; sort the rows" in tags.disorder(shuffled)
    assert tags.disorder(t) == ""


def test_single_precision_is_seen_and_a_clock_of_a_binary_rate_is_none():
    t = np.arange(2000) * 0.02
    assert "multiples of 2^-7 s" in tags.coarse((t + 1e5).astype(np.float32).astype(float))
    assert tags.coarse(np.arange(2000) / 64) == "" and tags.coarse(t) == ""
    jittery = t + 1e-4 * np.random.default_rng(1).standard_normal(2000)
    assert tags.coarse(jittery) == ""


def test_clocks_that_are_apart_by_what_people_get_wrong():
    assert "time zone or summer time of 2 h" in tags.apart(-7200.3)
    assert "GPS time beside UTC" in tags.apart(18.01) and "1 s exactly" in tags.apart(1.01)
    assert tags.apart(0.37) == "" and tags.apart(12.4) == ""


# ---------------------------------------------------------------- patterns of samples


def still(rows=4000, step=0.0):
    """A slave at rest, its numbers rounded to so many sigmas."""
    rng = np.random.default_rng(2)
    gyro, accel = rng.standard_normal((2, rows, 3))
    if step:
        gyro, accel = (np.round(part / step) * step for part in (gyro, accel))
    return Inertial("rates", "end", np.arange(rows) * 0.01, 1e-4 * gyro, 0.01 * accel + [0, 0, -9.81])


def names(imu):
    return [one.name for one in patterns.of_samples(imu)]


def test_a_coarse_sensor_at_rest_repeats_numbers_and_copies_nothing():
    for step in (0.0, 0.5, 1.0, 2.0, 3.0):
        assert names(still(step=step)) == [], step
    copied = still()
    for part in (copied.gyro, copied.accel):
        part[[100, 700, 900]] = part[[99, 699, 899]]
    assert names(copied) == ["copies"]


def test_samples_that_were_bridged_are_no_interpolation():
    imu = still(2000)
    at = np.arange(0, 2000, 4)
    every = np.arange(2000)
    gyro, accel = (
        np.stack([np.interp(every, at, column[at]) for column in part.T], axis=-1) for part in (imu.gyro, imu.accel)
    )
    filled = replace(imu, gyro=gyro, accel=accel)
    assert names(filled) == ["interpolated"]
    doubt = np.ones((2000, 2))
    doubt[at] = 0
    assert names(replace(filled, doubt=doubt)) == []


def test_an_axis_that_saturates_is_told_from_one_that_swings():
    imu = still()
    swing = np.sin(np.arange(4000) / 100)
    coarse = np.round(200 * swing) / 200
    assert names(replace(imu, gyro=imu.gyro + coarse[:, None] * [1, 0, 0])) == []
    assert names(replace(imu, gyro=np.round(coarse[:, None] * [1, 1, 1], 2))) == []
    clipped = np.clip(imu.gyro + swing[:, None], -0.8, 0.8)
    assert names(replace(imu, gyro=clipped)) == ["saturated"] * 3
