"""The master's position against the slave's own way: what jumps is refused and told, what stays is followed."""

from dataclasses import replace

import numpy as np
import pytest

from boresight.evidence.flights.fly import fly
from boresight.evidence.flights.motion import DEG, swinging
from boresight.runtime.library import load

RUNS = 3
MOTION = swinging()


@pytest.fixture(scope="module")
def model(compiled_once):
    return load("velocity-attitude")


def flown(model, seconds, change=None, begin=2.0, end=np.inf):
    """Notes, and how many metres north of the truth the slave believes to be at the end."""

    def said(time, message):
        wrong = change is not None and begin <= time < end
        return replace(message, position=change(np.array(message.position))) if wrong else message

    done = fly(MOTION, model=model, runs=RUNS, seed=3, seconds=seconds, lost=0.0, said=said, imu_hz=50)
    north = 6.37e6 * (done.loop.nav["lat_lon_height"][:, 0] - MOTION.position(np.array(seconds))[0])
    return [str(note) for note in done.loop.notes], north, done


def test_a_degree_of_latitude_in_one_message_is_refused_and_the_rest_of_it_counts(model):
    notes, north, done = flown(model, 4, lambda p: p + np.array([DEG, 0, 0]), end=2.1)
    assert [note.split("s: ")[1].split(" (")[0].split(";")[0] for note in notes] == [
        "position refused: it lies 111.3 km from where the slave has come since the last one that was taken",
        "positions are taken again",
    ]
    assert (done.verdict == 0).all()
    assert np.abs(north).max() < 30


@pytest.mark.parametrize("change", [lambda p: p * [-1, 1, 1], lambda p: p * [1, -1, 1] + np.array([0, 2, 0])])
def test_a_latitude_or_longitude_that_runs_the_wrong_way_is_never_followed(model, change):
    notes, north, _ = flown(model, 13, change)
    assert len(notes) == 1 and "position refused" in notes[0]
    assert np.abs(north).max() < 30


def test_a_new_place_is_followed_when_it_has_agreed_with_itself_for_ten_seconds(model):
    notes, north, _ = flown(model, 13, lambda p: p + np.array([0.1 * DEG, 0, 0]))
    assert [note.split("s: ")[1].split(":")[0] for note in notes] == ["position refused", "position followed"]
    assert "12." in notes[1][:4]
    np.testing.assert_allclose(north, 0.1 * DEG * 6.37e6, atol=100)


def test_a_position_across_the_date_line_is_no_jump(model):
    east = swinging(place=np.array([0.7, np.pi - 2e-6, 50.0]))  # 10 m before it, at 4 m/s

    def said(time, message):
        lat, lon, height = np.moveaxis(message.position, -1, 0)
        return replace(message, position=np.stack([lat, (lon + np.pi) % (2 * np.pi) - np.pi, height], -1))

    done = fly(east, model=model, runs=RUNS, seed=3, seconds=5, lost=0.0, said=said)
    assert done.loop.notes == []
    assert (done.loop.nav["lat_lon_height"][:, 1] < -3).all()


def test_a_position_that_is_no_number_is_told_once(model):
    notes, north, _ = flown(model, 4, lambda p: p * np.nan)
    assert len(notes) == 1 and "position is not finite" in notes[0]
    assert np.abs(north).max() < 30


def test_a_position_of_another_kind_of_receiver_is_judged_by_its_own_sigma(model):
    def said(sigma):
        return lambda time, message: replace(
            message, position_sigma=sigma, position=message.position + np.array([(300.0 / 6.37e6) * (time > 2), 0, 0])
        )

    for sigma, notes in ((10.0, 1), (200.0, 0)):
        done = fly(MOTION, model=model, runs=RUNS, seed=3, seconds=4, lost=0.0, said=said(sigma))
        assert len(done.loop.notes) == notes
