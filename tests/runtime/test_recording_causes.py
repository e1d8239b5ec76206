"""Each falsified recording ends in its cause, in the first line; a healthy one in none.

tests/recordings_falsified.py makes them, and prints the table for as many healthy ones as asked for.
"""

import re
from functools import cache

import numpy as np
import pytest
from recordings_falsified import FAULTS, Plan, Written, complaints, fly, healthy

from boresight.runtime.recording import tags

NOT_YET = {
    "gyro_in_degrees", "leap_seconds", "one_second_late", "clock_steps_by_an_hour", "height_steps_by_the_geoid",
    "gyro_saturates", "master_held_at_1_hz", "heading_off_by_30", "heading_off_by_90", "heading_off_by_180",
    "heading_mirrored", "magnetic_heading_12", "compass_of_soft_iron", "level_velocity_as_body",
    "another_euler_sequence", "slave_held_at_25_hz", "means_of_10_hz_interpolated", "points_of_10_hz_interpolated",
    "one_sample_in_50_a_copy", "clocks_500_ppm_apart", "angles_rounded_to_1_deg", "angles_rounded_to_a_tenth",
    "velocity_averaged_over_a_second", "height_in_feet", "half_of_the_increments_lost", "master_never_moves",
}  # fmt: skip


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
        assert (bool(texts) and bool(re.search(cause, texts[0]))) is (name not in NOT_YET), texts


def test_what_the_data_cannot_tell_are_six_at_most():
    assert sum(bool(limit) for _, _, limit in FAULTS.values()) <= 6 and len(FAULTS) >= 60


@pytest.mark.parametrize("seed", range(12))
def test_a_healthy_recording_has_no_error(seed, tmp_path):
    """More of them: python tests/recordings_falsified.py 1000."""
    assert [text for text in complaints(healthy(seed).write(tmp_path)) if text.startswith("error")] == []


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
    assert "GPS time beside UTC" in tags.apart(18.01) and "1 whole seconds" in tags.apart(1.01)
    assert tags.apart(0.37) == "" and tags.apart(12.4) == ""
