"""What becomes of messages that are not as they should be, on flights of an independent simulator."""

from dataclasses import replace

import numpy as np
import pytest

from boresight import BoresightError
from boresight.evidence.flights import fly as flights
from boresight.evidence.flights.conditions import MEMS, printed
from boresight.evidence.flights.fly import band
from boresight.evidence.flights.motion import DEG, Motion, parked, swinging, waves
from boresight.runtime.transfer import Message, Verdict
from boresight.runtime.transfer.messages import heard

ROWS = ("v_n", "q_b2n_wxyz", "gyro_bias", "accel_bias", "q_b2m_wxyz", "tau")


@pytest.fixture(scope="module")
def swing():
    return swinging(seconds=12)


def fly(motion, **settings):
    """A delay that is known to 5 ms: what is asked here is asked of the rules."""
    return flights.fly(motion, **({"tau": 0.0, "tau_sigma": 5e-3} | settings))


def texts(flight):
    return [note.text for note in flight.loop.notes]


def at(message_number, change):
    """Messages are changed from their number on, one by one: change(k, message), k from 0."""
    count = iter(range(10**6))

    def said(time, message):
        k = next(count) - message_number
        return change(k, message) if k >= 0 else message

    return said


def of_one(run, **values):
    """In one message of one run, these fields."""

    def change(k, message):
        if k:
            return message
        out = {}
        for name, value in values.items():
            whole = np.array(getattr(message, name))
            if name in ("R", "rows"):
                whole = np.array(np.broadcast_to(whole, (len(message.time), 6)))
            whole[run] = value(whole[run]) if callable(value) else value
            out[name] = whole
        return replace(message, **out)

    return change


# ---------------------------------------------------------------- one bad number

FIRST = 3  # the message with the first fault; the next ones have the others
# What is spoilt in one message of one run, what of it is left, the verdict, and what is said.
BAD = {
    "R-nan": ({"R": np.nan}, {"rows": False}, Verdict.INVALID, "a variance in R is nan"),
    "R-zero": ({"R": 0.0}, {"rows": False}, Verdict.INVALID, "a variance in R is 0"),
    "R-negative": (
        {"R": lambda R: R * [1, 1, -1, 1, 1, 1]}, {"rows": False}, Verdict.INVALID, "a variance in R is -0.0004"
    ),
    "time": ({"time": np.nan}, {"rows": False}, Verdict.INVALID, "its time is nan"),
    "velocity": ({"v_m_n": np.nan}, {"rows": [0, 0, 0, 1, 1, 1]}, Verdict.TAKEN, "velocity is not finite or beyond"),
    "one-velocity": (
        {"v_m_n": lambda v: v * [1, 1e4, 1]}, {"rows": [1, 0, 1, 1, 1, 1]}, None,
        "velocity east is not finite or beyond",
    ),
    "norm": (
        {"q_m2n_wxyz": lambda q: 2 * q}, {"rows": [1, 1, 1, 0, 0, 0]}, Verdict.TAKEN, "attitude is not finite or"
    ),
    "position": ({"position": np.nan}, {}, Verdict.TAKEN, "position"),
    "all": ({"v_m_n": np.nan, "q_m2n_wxyz": np.nan}, {"rows": False}, Verdict.INVALID, "no finite value"),
}  # fmt: skip


@pytest.fixture(scope="module")
def spoilt(swing):
    """Three flights: without a fault; with the k-th fault in run k alone; and with what is left of each."""

    def each(which):
        changes = [of_one(run, **case[which]) for run, case in enumerate(BAD.values())]
        return at(FIRST, lambda k, message: changes[k](0, message) if k < len(BAD) else message)

    settings = {"runs": len(BAD) + 1, "seconds": 2.6, "lost": 0.0, "imu_hz": 25}
    return [fly(swing, said=said, **settings) for said in (None, each(0), each(1))]


@pytest.mark.parametrize("fault", BAD)
def test_one_bad_number_costs_that_message_of_that_run_and_leaves_nothing_behind(spoilt, fault):
    clean, flight, masked = spoilt
    run, (_, as_if, verdict, says) = list(BAD).index(fault), BAD[fault]
    pairs = [(len(BAD), clean), (run, masked)]
    for which, then in pairs[: 1 if fault == "position" else 2]:  # instead of a position the slave's own stands there
        for name in ROWS:
            np.testing.assert_array_equal(flight.loop.nav[name][which], then.loop.nav[name][which])
        np.testing.assert_array_equal(flight.loop.P[which], then.loop.P[which])
        np.testing.assert_array_equal(flight.errors[:, which], then.errors[:, which])
        for name in ("v_n", "q_b2n_wxyz"):
            ours, theirs = (one.loop.history.recent(name)[:, which] for one in (flight, then))
            np.testing.assert_array_equal(ours, theirs)
    if verdict is not None:
        assert flight.verdict[FIRST + run, run] == verdict
        assert flight.loop.counts[verdict][run] == (1 if verdict else len(flight.time))
    assert (flight.verdict[:, len(BAD)] == Verdict.TAKEN).all()
    (note,) = [note for note in flight.loop.notes if says in note.text]
    assert note.runs.tolist() == [run] and f"(run {run})" in note.text
    if as_if == {"rows": False}:
        assert np.isnan(flight.nis[FIRST + run, run])


def test_of_several_runs_with_a_bad_number_each_the_line_names_the_first_ones(swing):
    def bad(k, message):
        R = np.tile(message.R, (3, 1))
        R[1:, 4] = [-1.0, -2.0]
        return replace(message, R=R) if k == 0 else message

    flight = fly(swing, runs=3, seconds=1.6, lost=0.0, imu_hz=25, said=at(3, bad))
    assert [text.split(": ", 1)[1] for text in texts(flight) if "refused:" in text] == [
        "a variance in R is -1; each must be finite and above zero (runs 1, 2: 2; numbers of the first of them)"
    ]


@pytest.mark.parametrize(("runs", "sigma", "read"), [
    ((3,), [1.0, 2.0, 3.0], [[1.0, 2.0, 3.0]] * 3), ((2,), [[1.0], [2.0]], [[1.0] * 3, [2.0] * 3]),
    ((), 5.0, [5.0] * 3),
])  # fmt: skip
def test_three_position_sigmas_are_of_axes_and_one_of_each_run_stands_in_a_column(runs, sigma, read):
    said = {"v_m_n": np.zeros(3), "q_m2n_wxyz": np.eye(4)[0], "position": np.zeros(3)}
    given = heard(Message(0.0, np.ones(6), position_sigma=sigma, **said), runs, "q_m2n_wxyz", 1.4)
    np.testing.assert_array_equal(given.position_sigma, read)
    assert not any(where.any() for where, _ in given.faults)
    flat = heard(Message(0.0, np.ones(6), position_sigma=np.ones(4), **said), (4,), "q_m2n_wxyz", 1.4)
    assert [why for where, why in flat.faults if where.any()] == [
        "its position_sigma is no array of numbers (..., 3) or (..., 1)"
    ]


def test_a_run_whose_delay_stays_unknown_leaves_the_others_as_they_were(swing):
    """Run 1 hears nothing after the second message, while the others learn their delay to less than 10 ms."""

    def deaf(k, message):
        return of_one(1, rows=False)(0, message)

    settings = {"runs": 3, "seconds": 2.6, "lost": 0.0, "tau_sigma": 0.05}
    clean, flight = (fly(swing, said=how, **settings) for how in (None, at(1, deaf)))
    sigma = np.sqrt(flight.loop.P[:, 15, 15])
    assert sigma[1] > 0.01 > sigma[[0, 2]].max()
    for name in ROWS:
        np.testing.assert_array_equal(flight.loop.nav[name][[0, 2]], clean.loop.nav[name][[0, 2]])
    np.testing.assert_array_equal(flight.loop.P[[0, 2]], clean.loop.P[[0, 2]])


def test_a_live_loop_raises_nothing_whatever_a_message_holds(swing):
    """Numbers of every kind in every field, in one run of two, and arrays of the wrong shape or of no numbers."""
    rng = np.random.default_rng(5)
    strange = [np.nan, np.inf, -np.inf, 0.0, -1.0, 1e-320, 1e-30, 1e3, 1e30, 1.7e308]
    flight = fly(swing, runs=2, seconds=2.0, lost=0.0)
    loop, last = flight.loop, None

    def keep(time, message):
        nonlocal last
        last = message

    fly(swing, runs=2, seconds=0.5, lost=0.0, said=keep)
    before = [loop.P.copy(), *(loop.nav[name].copy() for name in ROWS)]
    for k in range(150):
        message = replace(last, time=np.full(2, 2.0 + 1e-4 * k))
        for name in rng.choice(["time", "R", "v_m_n", "q_m2n_wxyz", "position"], size=rng.integers(1, 4)):
            value = np.array(np.broadcast_to(getattr(message, name), (2, *np.shape(getattr(last, name))[-1:])))
            if name == "time":
                value = np.array(message.time)
                value[1] = rng.choice(strange)
            else:
                value[1, rng.integers(value.shape[1])] = rng.choice(strange)
            message = replace(message, **{name: value})
        loop.master(message)
        assert np.isfinite(loop.P).all() and all(np.isfinite(loop.nav[name]).all() for name in ROWS)
    for wrong in (
        {"v_m_n": np.zeros(2)}, {"v_m_n": None, "q_m2n_wxyz": None}, {"R": np.ones(5)}, {"R": None}, {"time": "now"},
        {"time": None}, {"q_m2n_wxyz": np.ones((3, 4))}, {"rows": np.ones((3, 6))}, {"position": "here"},
        {"v_m_n": ["a", "b", "c"]}, {"v_m_n": [[1, 2], [3]]}, {"count": "one"},
    ):  # fmt: skip
        kept = [loop.P.copy(), *(loop.nav[name].copy() for name in ROWS)]
        result = loop.master(replace(last, **({"time": np.full(2, 2.04)} | wrong)))
        if set(wrong) - {"position", "count"}:
            assert (result.verdict > Verdict.REOPENED).all(), wrong
            for now, then in zip([loop.P, *(loop.nav[name] for name in ROWS)], kept, strict=True):
                np.testing.assert_array_equal(now, then)
    assert not np.array_equal(before[0], loop.P)


def test_rows_that_are_missing_are_told_once_until_they_are_back(swing):
    masked = np.array([True, True, False, True, True, False])
    flight = fly(swing, runs=3, seconds=8.0, lost=0.0, imu_hz=25,
                 said=at(5, lambda k, m: replace(m, rows=masked) if k < 5 else m))  # fmt: skip
    said = texts(flight)
    assert len(said) == 2
    assert "come without velocity down, attitude down" in said[0]
    assert "holds velocity down, attitude down again" in said[1]
    # a master whose velocity comes five times as often as its attitude
    flight = fly(swing, runs=3, seconds=8.0, lost=0.0, imu_hz=25,
                 said=at(5, lambda k, m: replace(m, q_m2n_wxyz=None) if k % 5 else m))  # fmt: skip
    assert len(texts(flight)) == 1 and "come without attitude" in texts(flight)[0]


# ---------------------------------------------------------------- a master that stands still, and one that is frozen

LEVEL = {"runs": 10, "imu_hz": 25, "jitter": 0.0, "lost": 0.0, "unit": replace(MEMS, velocity=0.0, attitude=0.0),
         "R": np.repeat([0.01, 0.01 * DEG], 3) ** 2 / 12}  # fmt: skip


def test_a_master_that_stands_still_is_taken_at_every_message():
    """Parked, a MEMS slave: the same numbers again and again, printed in half of the runs, and each of them is taken.

    So long that its gyro bias alone would carry the slave to 7 m/s.
    """

    heard = []

    def of_half(time, message):
        heard.append(message)
        q, v = (np.array(getattr(message, name)) for name in ("q_m2n_wxyz", "v_m_n"))
        read = printed(0.01, 0.01)(time, message)
        q[:5], v[:5] = read.q_m2n_wxyz[:5], read.v_m_n[:5]
        return replace(message, q_m2n_wxyz=q, v_m_n=v)

    flight = fly(parked(seconds=22), said=of_half, seconds=20.0, **LEVEL)
    for name in ("v_m_n", "q_m2n_wxyz"):  # without noise: the same number, bit by bit
        assert all(np.array_equal(getattr(message, name), getattr(heard[0], name)) for message in heard)
    assert flight.verdict.shape[0] >= 99
    assert (flight.verdict == Verdict.TAKEN).all()
    assert np.abs(flight.errors[-1, :, 3:6]).max() < 0.05
    assert not texts(flight)


def test_a_master_that_flies_straight_and_repeats_its_printed_numbers_is_taken():
    straight = Motion(steady=np.array([80.0, 60.0, 0.0]), seconds=12)
    flight = fly(straight, said=printed(0.01, 0.01), seconds=10.0, **LEVEL)
    assert (flight.verdict == Verdict.TAKEN).all()


def frozen():
    kept = []

    def change(k, message):
        kept.append(message)
        return replace(message, v_m_n=kept[0].v_m_n, q_m2n_wxyz=kept[0].q_m2n_wxyz) if k < 15 else message

    return change


@pytest.mark.parametrize("unit", [None, MEMS], ids=["tactical", "MEMS"])
def test_a_frozen_master_is_told_while_the_hull_moves_though_its_stamps_go_on(swing, unit):
    flight = fly(swing, runs=5, seconds=9.0, lost=0.0, imu_hz=25, unit=unit, said=at(15, frozen()))
    assert (flight.verdict[16:30] == Verdict.REPEATED).mean() > 0.9
    assert "repeats its last one" in texts(flight)[0]
    assert (flight.verdict[31:] == Verdict.TAKEN).all()
    assert (flight.loop.counts[Verdict.REPEATED] == (flight.verdict == Verdict.REPEATED).sum(0)).all()
    assert np.nanmean(flight.nis[31:]) == pytest.approx(6, abs=4 * np.sqrt(12 / np.isfinite(flight.nis[31:]).sum()))


def test_a_stamp_or_a_counter_that_repeats_is_refused_though_nothing_moves():
    kept = []

    def twice(k, message):
        kept.append(message)
        return replace(kept[0], time=message.time + 0.01) if k == 2 else kept[0] if k == 1 else message

    flight = fly(parked(seconds=12), runs=3, lost=0.0, seconds=4.0, imu_hz=25, said=at(10, twice))
    assert (flight.verdict[11] == Verdict.OUT_OF_ORDER).all()
    assert (np.delete(flight.verdict, 11, 0) == Verdict.TAKEN).all()

    def counted(k, message):
        return replace(message, count=np.full(3, (k + 1) // 2))  # each comes twice but for the first

    flight = fly(parked(seconds=12), runs=3, lost=0.0, seconds=5.0, imu_hz=25, said=at(0, counted))
    assert (flight.verdict[0:24:2][1:] == Verdict.REPEATED).all()
    assert (flight.verdict[1:24:2] == Verdict.TAKEN).all()
    assert "its counter, 1, is that of the last one" in texts(flight)[0]


# ---------------------------------------------------------------- slow masters, steep hulls, the model's range


@pytest.mark.parametrize(("master_hz", "seconds"), [(1.0, 25.0), (0.2, 50.0)])
def test_a_slow_master_is_not_called_silent_between_its_messages(master_hz, seconds):
    flight = fly(swinging(seconds=seconds + 2), runs=3, master_hz=master_hz, seconds=seconds, lost=0.0, imu_hz=10)
    assert (flight.verdict == Verdict.TAKEN).all()
    assert not texts(flight)


def test_a_slow_master_that_stops_is_told_after_a_few_of_its_intervals(swing):
    flight = fly(swinging(seconds=26), runs=3, master_hz=1, seconds=24.0, lost=0.0, imu_hz=10,
                 said=lambda time, m: None if 10 < time < 22 else m)  # fmt: skip
    silent, back = flight.loop.notes
    assert "no message" in silent.text and 12 < silent.time < 16
    assert "is back" in back.text


STEEP = Motion(euler=np.array([0.0, 80 * DEG, 0.6]), seconds=42,
               swing=waves(([6 * DEG, 7 * DEG, 8 * DEG], 0.17, [0.3, 1.2, 2.1])),
               sway=waves(([1.5, 1.2, 0.8], 0.13, [0.1, 0.9, 2.5])))  # fmt: skip


@pytest.mark.parametrize("matching", ["dcm", "quaternion"])
def test_a_hull_that_pitches_to_87_degrees_is_flown_without_euler_angles(matching):
    flight = fly(STEEP, runs=30, seconds=6.0, matching=("velocity", matching))
    low, high = band(30, 16)
    assert flight.verdict.max() <= Verdict.ABSENT
    assert low < flight.nees[-1].mean() < high and not texts(flight)


def test_euler_angles_beyond_80_degrees_are_left_out_and_the_velocity_is_taken():
    from boresight.runtime import rotation

    def euler(time, message):
        said = rotation.euler_from_matrix(rotation.matrix_from_quaternion(message.q_m2n_wxyz))
        return replace(message, euler_m=said + np.array([0, 0, 2 * np.pi]), q_m2n_wxyz=None)

    flight = fly(STEEP, runs=3, seconds=6.0, lost=0.0, matching=("velocity", "euler"), said=euler,
                 R=np.repeat([0.02, 0.02], 3) ** 2)  # fmt: skip
    assert (flight.verdict <= Verdict.REOPENED).mean() > 0.95
    assert any("attitude" in text and "range" in text for text in texts(flight))


def test_a_slave_that_leaves_the_models_range_begins_anew_and_the_others_fly_on(swing):
    """Run 1 is pushed by 450 m/s^2 until its velocity leaves the model's range; nothing is raised.

    Of the messages that come later the first one says a latitude beyond that range, and the second one is sound.
    """

    def pushed(time, dtheta, dv):
        dv = dv.copy()
        if 2 < time < 4.8:
            dv[1, 0] += 450 * 0.02
        return dtheta, dv

    standing, first = [], []

    def said(time, message):
        if 2 < time < 5.1:
            return None
        first.extend([time] if time > 5 and not first else [])
        there = np.array(message.position * np.ones((3, 1)))
        there[1, 0] = 89 * DEG if [time] == first else there[1, 0]
        return replace(message, position=there)

    def watched(*args, **more):
        loop = flights.started(*args, **more)
        deliver = loop.slave

        def slave(*increments):
            deliver(*increments)
            standing.extend([np.abs(loop.nav["v_n"][1]).max()] if loop.lost[1] else [])
            assert loop.lost[[0, 2]].tolist() == [False, False]

        loop.slave = slave
        return loop

    settings = {"runs": 3, "seconds": 7.0, "lost": 0.0, "said": said}
    flight = fly(swing, sensed=pushed, start=watched, **settings)
    first.clear()
    clean = fly(swing, **settings)
    assert len(standing) > 25 and set(standing) == {1000.0}
    (note,) = [note for note in flight.loop.notes if "v_n" in note.text]
    assert note.runs.tolist() == [1] and "the filter begins anew from the next message" in note.text
    late = flight.time > 5
    assert flight.verdict[late, 1].tolist() == [Verdict.BEYOND, Verdict.BEGUN] + [Verdict.TAKEN] * (late.sum() - 2)
    assert not flight.loop.lost.any()
    assert band(1, 16)[0] < flight.nees[-1, 1] < band(1, 16)[1]
    for name in ROWS:
        np.testing.assert_array_equal(flight.loop.nav[name][[0, 2]], clean.loop.nav[name][[0, 2]])
    np.testing.assert_array_equal(flight.loop.P[[0, 2]], clean.loop.P[[0, 2]])


def test_a_correction_that_leads_out_of_the_models_range_is_refused_by_name(swing):
    """A gyro bias of 2 deg/s: the model's range ends at 1."""
    flight = fly(swing, runs=3, seconds=5.0, lost=0.0, unit=replace(MEMS, gyro_bias=2 * DEG))
    assert np.abs(flight.loop.nav["gyro_bias"]).max() <= 1 * DEG
    assert any("gyro_bias" in text and "range" in text for text in texts(flight))
    assert flight.loop.counts[Verdict.BEYOND].max() > 0
    assert not flight.loop.lost.any()


def test_a_start_beyond_the_models_latitude_is_refused():
    with pytest.raises(BoresightError, match="latitude"):
        fly(swinging(seconds=3, place=np.array([86 * DEG, 0.2, 50.0])), runs=2, seconds=1.0)
