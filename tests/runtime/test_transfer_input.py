"""Whatever a sensor or a master sends, the live loop raises nothing and is done in bounded time."""

import warnings

import numpy as np
import pytest

from boresight.evidence.flights.fly import fly
from boresight.evidence.flights.motion import swinging
from boresight.runtime.transfer import Message, Rules, Verdict

FINE, DOWN = np.zeros(3), np.array([0.0, 0.0, -0.0981])


def begun(**settings):
    """A loop half a second old, at 100 Hz."""
    return fly(swinging(seconds=12), **({"runs": 2, "seconds": 0.5, "imu_hz": 100, "lost": 0.0, "tau": 0.0,
                                         "tau_sigma": 5e-3} | settings)).loop  # fmt: skip


@pytest.fixture(scope="module")
def loop():
    return begun()


SAMPLES = {  # time and dt in samples of 10 ms behind the last one
    "no time": (None, FINE, DOWN, 0.01), "no length": (1, FINE, DOWN, None), "text": (1, "abc", DOWN, 0.01),
    "time as text": ("now", FINE, DOWN, 0.01), "length as text": (1, FINE, DOWN, "short"),
    "two axes": (1, np.zeros(2), DOWN, 0.01), "six axes": (1, np.zeros(6), DOWN, 0.01),
    "one number": (1, 0.0, DOWN, 0.01), "none": (1, None, None, 0.01), "a column": (1, np.zeros((3, 1)), DOWN, 0.01),
    "other runs": (1, np.zeros((3, 3)), DOWN, 0.01), "complex": (1, FINE + 1j, DOWN, 0.01), "ragged": (
        1, [[1, 2], [3]], DOWN, 0.01), "a huge whole number": (1, [10**400, 0, 0], DOWN, 0.01),
    "times in a list": ([1], FINE, DOWN, 0.01), "no intervals": (np.zeros(0), np.zeros((0, 2, 3)), np.zeros((0, 2, 3)),
                                                                np.zeros(0)),
    "one sample short": ([1, 2, 3], np.zeros((2, 2, 3)), np.zeros((3, 2, 3)), 0.01),
    "another axis": ([1, 2, 3], np.zeros((3, 2, 1, 3)), np.zeros((3, 2, 3)), 0.01),
    "lengths short": ([1, 2, 3], np.zeros((3, 2, 3)), np.zeros((3, 2, 3)), [0.01, 0.01]),
    "a table of times": ([[1, 2]], np.zeros((2, 2, 3)), np.zeros((2, 2, 3)), 0.01),
    "length of a thousand seconds": (1, FINE, DOWN, 1000.0), "length without end": (1, FINE, DOWN, np.inf),
    "time without end": (np.inf, FINE, DOWN, 0.01), "time of 1e300": (1e300, FINE, DOWN, 0.01),
}  # fmt: skip


@pytest.mark.parametrize("case", SAMPLES)
def test_a_sample_of_any_kind_raises_nothing_and_is_told(loop, case):
    time, dtheta, dv, dt = SAMPLES[case]
    told = len(loop.notes)
    loop.watch.noted_at.clear()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        if isinstance(time, list | np.ndarray):
            time = loop.time + 0.01 * np.array(time)
        elif isinstance(time, int):
            time = loop.time + 0.01 * time
        loop.slave(time, dtheta, dv, dt)
        loop.slave(loop.time + 0.01, FINE, DOWN, 0.01)
    assert np.isfinite(loop.P).all() and all(np.isfinite(value).all() for value in loop.nav.values())
    assert (len(loop.notes) > told) == (case != "no intervals")


@pytest.mark.parametrize("dt", [1e-9, 1e-6, 1e-5, 1e-4])
def test_a_wrong_length_of_an_interval_costs_no_more_than_a_bridge_of_milliseconds(monkeypatch, dt):
    loop, calls = begun(), []
    step = loop.filter.strapdown
    monkeypatch.setattr(loop.filter, "strapdown", lambda **given: calls.append(given["dt"]) or step(**given))
    loop.slave(loop.time + 0.01, FINE, DOWN * dt, dt)
    assert len(calls) <= 11 and (dt >= 1e-6) == bool(calls)
    loop.slave(loop.time + 0.01, FINE, DOWN, 0.01)
    assert any("left out" in note.text or "bridged" in note.text for note in loop.notes)


STAND_IN = {"R": np.full(6, 1e-4), "v_m_n": np.zeros((2, 3)), "q_m2n_wxyz": np.array([1.0, 0, 0, 0])}


@pytest.mark.parametrize("message", [
    None, "a message", 3.0, Message(None, None), Message(0.5 + 1j, **STAND_IN), Message(0.5, **STAND_IN, rows="all"),
    Message(0.5, **STAND_IN | {"v_m_n": np.zeros(3) + 1j}), Message(0.5, **STAND_IN | {"v_m_n": 1.0}),
    Message(0.5, **STAND_IN | {"R": 1e-4}),
])  # fmt: skip
def test_what_is_no_message_is_refused_in_one_line(loop, message):
    loop.watch.told_at[:] = -np.inf
    kept, told = loop.P.copy(), len(loop.notes)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        result = loop.master(message)
    assert (result.verdict == Verdict.INVALID).all()
    np.testing.assert_array_equal(loop.P[..., 6:, 6:], kept[..., 6:, 6:])
    assert len(loop.notes) == told + 1 and loop.notes[-1].text.startswith("message refused: it")


def test_a_lost_run_whose_messages_reach_beyond_the_kept_past_asks_for_a_larger_buffer():
    """A delay of 0.6 s in run 0, 0.5 s kept: refused by name; run 1 begins anew beside it."""
    lost = lambda time, d, v: None if 2.0 < time < 2.205 else (d, v)  # noqa: E731
    tau = np.array([0.6, 0.0])
    flight = fly(swinging(seconds=12), runs=2, seconds=4.0, imu_hz=50, lost=0.0, sensed=lost, tau=tau,
                 tau_believed=tau, tau_sigma=5e-3, rules=Rules(quiet_s=0.5))  # fmt: skip
    late = flight.time > 2.8
    assert (flight.verdict[late] == [Verdict.TOO_OLD, Verdict.TAKEN]).all()
    assert flight.loop.lost.tolist() == [True, False]
    assert any("raise buffer_s" in note.text and 0 in note.runs for note in flight.loop.notes if note.time > 2.8)
