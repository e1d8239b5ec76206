"""The master's delay: at rest it is not learned, and a step of it or of the master's clock is found and told."""

import re

import numpy as np
import pytest

from boresight.evidence.flights.conditions import turned, with_field
from boresight.evidence.flights.fly import Unit, band, fly
from boresight.evidence.flights.motion import DEG, Motion, after, swinging, waves
from boresight.runtime.transfer import Verdict

RUNS = 8


def at_10_s(before, behind):
    return lambda time: before if time < 10 else behind


def said_of(flight, run):
    """What the notes say of a run that has been found."""
    return [note.text for note in flight.loop.notes if "did not fit" in note.text and run in note.runs]


def consistent(flight, since):
    """NEES of all states, and of the delay alone, of every message since then."""
    late = flight.time >= since
    return (
        band(RUNS, 16)[0] < flight.nees[late].mean() < band(RUNS, 16)[1]
        and flight.nees_of([15])[late].mean() < band(RUNS, 1)[1]
        and (flight.verdict[late] <= Verdict.ABSENT).all()
    )


def numbers(text, pattern):
    return [float(part) for part in re.search(pattern, text).groups()]


@pytest.mark.parametrize("vibrating", [False, True])
def test_the_delay_is_not_learned_at_rest_and_is_found_when_motion_begins(vibrating):
    unit = Unit(gyro_bias=0.1 * DEG, accel_bias=0.05, gyro_noise=1e-4, accel_noise=2e-3) if vibrating else Unit()

    def shaken(time, d, f):  # by the sensors alone, at 17 Hz: .3 deg/s and 1 m/s^2
        wave = np.cos(2 * np.pi * 17.3 * (time + np.array([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]])))
        return d + 0.02 * 0.3 * DEG * wave[0], f + 0.02 * wave[1]

    motion = Motion(swing=after(22.0, waves(([6 * DEG, 3 * DEG, 3 * DEG], 0.17, [0.0, 1.2, 2.1]))), seconds=32)
    tau = 0.06 + 0.03 * np.linspace(-1.5, 1.5, RUNS)
    flight = fly(motion, runs=RUNS, unit=unit, seconds=30.0, master_hz=10, tau=tau, tau_believed=0.06, tau_sigma=0.03,
                 sensed=shaken if vibrating else None)  # fmt: skip
    sigma = np.sqrt(flight.P[..., 15, 15])
    assert (sigma[flight.time < 20][-1] > 0.98 * 0.03).all()
    assert (sigma[-1] < 0.1 * 0.03).all()
    tau_nees = flight.nees_of([15]).mean(1)
    assert tau_nees[flight.time > 26].mean() < band(RUNS, 1)[1]


def test_in_a_slow_swing_the_delay_is_as_wrong_as_it_says():
    rate = 5 * Unit().gyro_noise / np.sqrt(0.04)
    motion = Motion(swing=waves(([rate / (2 * np.pi * 0.1)] * 3, 0.1, [0, 1.2, 2.1])), seconds=42)
    tau = 0.12 + 0.05 * np.linspace(-1.5, 1.5, RUNS)
    flight = fly(motion, runs=RUNS, master_hz=10, tau=tau, tau_believed=0.12)
    tau_nees = flight.nees_of([15]).mean(1)
    assert tau_nees.max() < band(RUNS, 1)[1]


@pytest.mark.parametrize("way", ["buffer", "extrapolate"])
@pytest.mark.parametrize(("before_ms", "behind_ms"), [(35, 135), (135, 35)])
def test_a_delay_that_steps_is_found_and_told_with_its_numbers(before_ms, behind_ms, way):
    if way == "extrapolate" and behind_ms > 100:
        pytest.skip("extrapolation is not consistent at 135 ms: docs/transfer-alignment.md")
    flight = fly(swinging(), runs=RUNS, seconds=20.0, tau=at_10_s(before_ms / 1e3, behind_ms / 1e3), way=way,
                 tau_believed=before_ms / 1e3, tau_sigma=0.01)  # fmt: skip
    assert way == "extrapolate" or consistent(flight, 13.0)
    assert np.abs(flight.errors[flight.time > 13, :, 15]).max() < 3e-3
    for run in range(RUNS):
        (text,) = said_of(flight, run)
        before, behind = numbers(text, r"the master's delay has changed from (\d+) to (\d+) ms")
        assert before == pytest.approx(before_ms, abs=2) and behind == pytest.approx(behind_ms, abs=3)
        assert "off the slave" not in text


@pytest.mark.parametrize(("step", "words"), [(-0.3, "back by 0.3"), (0.3, "forward by 0.3"), (-15.0, "back by 15.0")])
def test_a_master_whose_clock_steps_is_followed_and_told(step, words):
    flight = fly(swinging(), runs=RUNS, seconds=20.0, clock=at_10_s(0.0, step), tau_believed=0.035, tau_sigma=0.01)
    assert consistent(flight, 14.0)
    for run in range(RUNS):
        (text,) = said_of(flight, run)
        (found,) = numbers(text, r"the master's clock has gone (?:back|forward) by ([\d.]+) s")
        assert found == pytest.approx(abs(step), abs=0.02) and words.split()[0] in text
        assert "delay" in text


@pytest.mark.parametrize(("change", "pattern", "size"), [
    (turned([0, 0, 5]), r"the heading by \S+ \S+ (\S+) deg", 5.0),
    (with_field(v_m_n=lambda v: v + [3.0, 0, 0]), r"the velocity by (\S+) \S+ \S+ m/s", 3.0),
])  # fmt: skip
def test_an_offset_for_good_is_not_taken_for_a_delay(change, pattern, size):
    flight = fly(swinging(), runs=RUNS, seconds=13.0, tau_believed=0.035, tau_sigma=0.01,
                 said=lambda time, message: message if time < 10 else change(time, message))  # fmt: skip
    for run in range(RUNS):
        text = said_of(flight, run)[0]
        assert numbers(text, pattern)[0] == pytest.approx(size, rel=0.02)
        assert "cannot be told apart" in text and "delay" not in text


def test_where_the_turn_is_constant_a_delay_and_an_offset_are_both_said():
    circle = Motion(yaw_rate=4 * DEG)
    flight = fly(circle, runs=RUNS, seconds=14.0, tau=at_10_s(0.035, 0.135), tau_believed=0.035, tau_sigma=0.01,
                 lever_b=np.zeros(3))  # fmt: skip
    for run in range(RUNS):
        text = said_of(flight, run)[0]
        assert "delay" in text and "off the slave" in text and "all of them are opened" in text


def test_a_delay_beyond_the_kept_past_is_asked_for():
    flight = fly(swinging(), runs=RUNS, seconds=14.0, tau=at_10_s(0.035, 0.9), tau_believed=0.035, tau_sigma=0.01)
    for run in range(RUNS):
        assert "neither another delay (all within buffer_s = 0.5 s are tried)" in said_of(flight, run)[0]


def test_a_backlog_of_old_messages_is_no_clock():
    """After a break the link delivers what it has kept, at once: refused, and no clock is set."""
    kept = []

    def broken(time, message):
        if 5 <= time < 10:
            kept.append(message)
            return None
        return message

    flight = fly(swinging(), runs=RUNS, seconds=10.0, tau_believed=0.035, tau_sigma=0.01, said=broken)
    loop = flight.loop
    for message in kept:
        loop.master(message)
    assert len(kept) > 20 and (loop.stamps.clock == 0).all() and (loop.stamps.trial == 0).all()
