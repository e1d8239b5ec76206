"""The master's delay: at rest it is not learned, and a step of it or of the master's clock is found and told."""

import re
from dataclasses import replace

import numpy as np
import pytest

from boresight.evidence.flights.fly import Unit, band, fly
from boresight.evidence.flights.motion import DEG, Motion, after, quaternion, swinging, turn, waves
from boresight.runtime.rotation import matrix_from_quaternion
from boresight.runtime.transfer import Verdict

RUNS = 8
CASES = {  # by run: delay before and behind, s; step of the clock, s; offset of heading, deg, and of velocity, m/s
    "longer": (0.035, 0.135, 0.0, 0.0, 0.0), "shorter": (0.135, 0.035, 0.0, 0.0, 0.0),
    "clock back": (0.035, 0.035, -0.3, 0.0, 0.0), "clock forward": (0.035, 0.035, 0.3, 0.0, 0.0),
    "clock set anew": (0.035, 0.035, -15.0, 0.0, 0.0), "heading": (0.035, 0.035, 0.0, 5.0, 0.0),
    "velocity": (0.035, 0.035, 0.0, 0.0, 3.0), "beyond": (0.035, 0.9, 0.0, 0.0, 0.0),
    "healthy": (0.035, 0.035, 0.0, 0.0, 0.0),
}  # fmt: skip
MENDED = ("longer", "shorter", "clock back", "clock forward", "clock set anew", "healthy")


def said_of(flight, run):
    """What the notes say of a run that has been found."""
    return [note.text for note in flight.loop.notes if "did not fit" in note.text and run in note.runs]


def numbers(text, pattern):
    return [float(part) for part in re.search(pattern, text).groups()]


@pytest.fixture(scope="module")
def stepped():
    """All cases side by side, four runs each; what steps does so at 6 s."""
    before, behind, clock, heading, velocity = np.repeat(np.array(list(CASES.values())), 4, axis=0).T
    C = turn(np.stack([0 * heading, 0 * heading, heading * DEG], -1))

    def off(time, message):
        if time < 6:
            return message
        q = quaternion(C @ matrix_from_quaternion(message.q_m2n_wxyz))
        return replace(message, q_m2n_wxyz=q, v_m_n=message.v_m_n + velocity[:, None] * np.array([1, 0, 0]))

    return fly(swinging(), runs=len(before), seconds=12.0, tau=lambda time: before if time < 6 else behind,
               clock=lambda time: 0 * clock if time < 6 else clock, said=off, tau_believed=before, tau_sigma=0.01,
               lost=0.0, imu_hz=25)  # fmt: skip


def runs_of(case):
    return 4 * list(CASES).index(case) + np.arange(4)


def test_five_seconds_after_a_step_of_delay_or_clock_the_errors_are_as_large_as_the_filter_says(stepped):
    late = stepped.time >= 11.0
    for case in MENDED:
        runs = runs_of(case)
        low, high = band(len(runs), 16)
        assert low < stepped.nees[late][:, runs].mean() < high, case
        assert stepped.nees_of([15])[late][:, runs].mean() < band(len(runs), 1)[1], case
        assert (stepped.verdict[late][:, runs] == Verdict.TAKEN).all(), case


@pytest.mark.parametrize("case", ["longer", "shorter"])
def test_a_delay_that_steps_is_told_with_its_numbers(stepped, case):
    for run in runs_of(case):
        (text,) = said_of(stepped, run)
        found = numbers(text, r"the master's delay has changed from (\d+) to (\d+) ms \(run")
        assert found == pytest.approx([1e3 * part for part in CASES[case][:2]], abs=4)


@pytest.mark.parametrize("case", ["clock back", "clock forward", "clock set anew"])
def test_a_masters_clock_that_steps_is_followed_and_told(stepped, case):
    step = CASES[case][2]
    for run in runs_of(case):
        (text,) = said_of(stepped, run)
        way = "forward" if step > 0 else "back"
        (found,) = numbers(text, rf"the master's clock has gone {way} by ([\d.]+) s; the delay")
        assert found == pytest.approx(abs(step), abs=0.02)


@pytest.mark.parametrize(("case", "pattern", "size"), [
    ("heading", r"the heading by \S+ \S+ (\S+) deg", 5.0), ("velocity", r"the velocity by (\S+) \S+ \S+ m/s", 3.0),
])  # fmt: skip
def test_an_offset_for_good_is_not_taken_for_a_delay(stepped, case, pattern, size):
    for run in runs_of(case):
        text = said_of(stepped, run)[0]
        assert numbers(text, pattern)[0] == pytest.approx(size, rel=0.02)
        assert "cannot be told apart" in text and "delay" not in text


def test_a_delay_beyond_the_kept_past_is_asked_for(stepped):
    for run in runs_of("beyond"):
        assert "neither another delay (all within buffer_s = 0.5 s are tried)" in said_of(stepped, run)[0]


def test_a_healthy_flight_says_nothing(stepped):
    assert not any(said_of(stepped, run) for run in runs_of("healthy"))


def test_extrapolation_finds_a_delay_that_steps_too():
    flight = fly(swinging(), runs=RUNS, seconds=10.0, tau=lambda time: 0.01 if time < 6 else 0.05,
                 compensation="extrapolate", tau_believed=0.01, tau_sigma=0.01, imu_hz=25)  # fmt: skip
    assert np.abs(flight.errors[-1, :, 15]).max() < 5e-3
    for run in range(RUNS):
        found = numbers(said_of(flight, run)[0], r"the master's delay has changed from (\d+) to (\d+) ms")
        assert found == pytest.approx([10, 50], abs=5)


@pytest.mark.parametrize("vibrating", [False, True])
def test_the_delay_is_not_learned_at_rest_and_is_found_when_motion_begins(vibrating):
    unit = Unit(gyro_bias=0.1 * DEG, accel_bias=0.05, gyro_noise=1e-4, accel_noise=2e-3) if vibrating else Unit()

    def shaken(time, d, f):  # by the sensors alone, at 17 Hz: .3 deg/s and 1 m/s^2
        wave = np.cos(2 * np.pi * 17.3 * (time + np.array([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]])))
        return d + 0.02 * 0.3 * DEG * wave[0], f + 0.02 * wave[1]

    motion = Motion(swing=after(6.0, waves(([6 * DEG, 3 * DEG, 3 * DEG], 0.17, [0.0, 1.2, 2.1]))), seconds=12)
    tau = 0.06 + 0.03 * np.linspace(-1.5, 1.5, RUNS)
    flight = fly(motion, runs=RUNS, unit=unit, seconds=10.0, master_hz=10, tau=tau, tau_believed=0.06, tau_sigma=0.03,
                 sensed=shaken if vibrating else None)  # fmt: skip
    sigma = np.sqrt(flight.P[..., 15, 15])
    assert (sigma[flight.time < 6][-1] > 0.98 * 0.03).all()
    assert (sigma[-1] < 0.1 * 0.03).all()
    assert flight.nees_of([15])[flight.time > 8.5].mean() < band(RUNS, 1)[1]


def test_in_a_slow_swing_the_delay_is_as_wrong_as_it_says():
    rate = 5 * Unit().gyro_noise / np.sqrt(0.04)
    motion = Motion(swing=waves(([rate / (2 * np.pi * 0.1)] * 3, 0.1, [0, 1.2, 2.1])), seconds=22)
    tau = 0.12 + 0.05 * np.linspace(-1.5, 1.5, RUNS)
    flight = fly(motion, runs=RUNS, master_hz=10, imu_hz=25, seconds=20.0, tau=tau, tau_believed=0.12)
    assert flight.nees_of([15]).mean(1).max() < band(RUNS, 1)[1]


def test_where_the_turn_is_constant_a_delay_and_an_offset_are_both_said():
    circle = Motion(yaw_rate=4 * DEG)
    flight = fly(circle, runs=RUNS, seconds=9.0, tau=lambda time: 0.035 if time < 5 else 0.135, tau_believed=0.035,
                 tau_sigma=0.01, lever_b=np.zeros(3), imu_hz=25)  # fmt: skip
    for run in range(RUNS):
        text = said_of(flight, run)[0]
        assert "delay" in text and "off the slave" in text and "all of them are opened" in text


def test_a_backlog_of_old_messages_is_no_clock():
    """After a break the link delivers what it has kept, at once: refused, and no clock is set."""
    kept = []

    def broken(time, message):
        if 3 <= time < 8:
            kept.append(message)
            return None
        return message

    flight = fly(swinging(), runs=RUNS, seconds=8.0, tau_believed=0.035, tau_sigma=0.01, said=broken, imu_hz=25)
    loop = flight.loop
    for message in kept:
        loop.master(message)
    assert len(kept) > 20 and (loop.stamps.clock == 0).all() and np.isnan(loop.stamps.trial).all()


def test_a_delay_that_is_held_stays_where_it_is_whatever_does_not_fit(compiled_once):
    """Of two runs that both should find 135 ms, the one whose delay has no variance keeps its 0."""
    flight = fly(
        swinging(seconds=12), runs=2, seed=4, seconds=10.0, imu_hz=25, lost=0.0, tau_sigma=np.array([0.05, 0.0]),
        tau=np.array([0.035, 0.135]), constants={"tau_noise": 0.0},
    )  # fmt: skip
    assert (flight.verdict[:, 1] >= Verdict.GATED).any()
    assert flight.loop.nav["tau"][1] == 0.0 and (flight.P[:, 1, 15, 15] == 0.0).all()
    assert abs(flight.loop.nav["tau"][0] - 0.035) < 0.002


def test_messages_too_old_by_a_wrong_estimate_of_the_delay_are_no_clock_set_anew():
    """In run 0 the delay is believed 3.3 sigma too long, so that messages 0.3 s late seem older than the buffer."""
    flight = fly(swinging(), runs=3, seconds=4.0, tau=0.05, tau_believed=np.array([0.25, 0.05, 0.06]), tau_sigma=0.06,
                 hand_over=0.3, lost=0.0, imu_hz=25)  # fmt: skip
    assert (flight.verdict[0] == [Verdict.TOO_OLD, Verdict.TAKEN, Verdict.TAKEN]).all()
    (text,) = said_of(flight, 0)
    assert "clock" not in text
    found = numbers(text, r"the master's delay is (\d+) ms, not the (\d+) ms by which its messages were too old")
    assert found == pytest.approx([50, 250], abs=5)
    assert (flight.loop.stamps.clock == 0).all() and (flight.verdict[-1] == Verdict.TAKEN).all()
    assert abs(flight.errors[-1, 0, 15]) < 4 * np.sqrt(flight.P[-1, 0, 15, 15])


def test_behind_a_late_message_of_a_fine_master_the_noise_since_then_stays_in_p():
    """50 urad and 3 mm/s, 0.3 s late; by then the gyros' noise has turned the slave by 55 urad."""
    fine = Unit(gyro_noise=1e-4, accel_noise=2e-3, velocity=3e-3, attitude=5e-5)
    flight = fly(swinging(), runs=20, seconds=5.0, unit=fine, tau=0.05, tau_believed=0.05, tau_sigma=1e-3,
                 hand_over=0.3, lost=0.0, imu_hz=25)  # fmt: skip
    low, high = band(20, 16)
    assert low < flight.nees[12:].mean() < high
