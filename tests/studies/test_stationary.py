"""The detectors on recordings: one that is made, whose motion is known, and the real foot-mounted one."""

import json
from dataclasses import replace

import numpy as np
import pytest
from tools import real_recording

from boresight import BoresightError
from boresight.analysis.figures import Sheets
from boresight.runtime import detector as d
from boresight.runtime.recording import Inertial, Recording, read
from boresight.studies.replays import stationary

DT, SW, SA = 0.01, 8e-4, 4e-3
BIAS = np.array([1.6e-3, -1.3e-3, 1e-4])
MOVES = ((20.0, 24.0), (30.0, 31.5))  # s


def made(seed=0, duration=40.0):
    """A sensor that lies still but for MOVES, with a bias and in a gravity of its own."""
    rng = np.random.default_rng(seed)
    t = np.arange(round(duration / DT)) * DT
    gyro = BIAS + SW * rng.standard_normal((len(t), 3))
    accel = [0.1, -0.2, -9.83] + SA * rng.standard_normal((len(t), 3))
    for t0, t1 in MOVES:
        at = (t >= t0 - DT / 2) & (t < t1 - DT / 2)
        gyro[at] += 0.3 * np.sin(9 * t[at, None] + [1, 2, 3])
        accel[at] += 1.5 * np.sin(7 * t[at, None] + [1, 2, 3])
    return Recording("made", Inertial("rates", "middle", t, gyro, accel))


def test_the_noise_is_that_which_went_in():
    noise = stationary.noise(made().imu, (0, 15))
    assert noise["sigma_gyro"] == pytest.approx(SW, rel=0.1)
    assert noise["sigma_accel"] == pytest.approx(SA, rel=0.1)
    np.testing.assert_allclose(noise["gyro_bias"], BIAS, rtol=0, atol=5 * SW / np.sqrt(1500))
    assert noise["gravity"] == pytest.approx(np.linalg.norm([0.1, -0.2, -9.83]), abs=1e-3)
    assert noise["rest_rate"] < 5 * SW / 10 and noise["gravity_error"] < 5 * SA / 10
    assert np.abs(noise["lag1_gyro"] + noise["lag1_accel"]).max() < 4 / np.sqrt(1500)


def test_rates_and_increments_are_one():
    rates = made()
    imu = rates.imu
    increments = replace(rates, imu=Inertial("increments", "end", imu.time, imu.gyro * DT, imu.accel * DT))
    a, b = stationary.run(rates), stationary.run(increments)
    assert a["noise"]["sigma_accel"] == pytest.approx(b["noise"]["sigma_accel"], rel=1e-9)
    for name in stationary.NAMES:
        assert np.mean(a["history"]["rest"][name] != b["history"]["rest"][name]) < 1e-3


@pytest.mark.parametrize("window", [10, 25, 50])
def test_each_movement_is_found_when_it_begins_and_left_a_window_after_it_ends(window):
    found = stationary.run(made(1), window=window)["detectors"]
    for name in ("gyro_mean", "gyro_std", "accel_std", "likelihood_ratio", stationary.KIM):
        segments = found[name]["segments"]
        assert [len(part) for part in segments] == [2, 2, 2], name
        for (t0, t1), before, after in zip(MOVES, segments, segments[1:], strict=False):
            assert t0 <= before[1] < t0 + 0.1, name
            # the mean of a swing may vanish some samples before the window has left it
            assert t1 - DT <= after[0] <= t1 + window * DT + 0.05 or name == "gyro_mean", name
        assert found[name]["movement_in_stated_rest"] < 0.01
        still = 40 - sum(t1 - t0 for t0, t1 in MOVES) - len(MOVES) * window * DT
        assert found[name]["share"] == pytest.approx(still / 40, abs=0.03)


def test_nothing_looks_ahead():
    """What is declared up to a sample is the same whatever comes after it."""
    whole = made(2)
    imu, cut = whole.imu, 2100
    part = replace(whole, imu=Inertial("rates", "middle", imu.time[:cut], imu.gyro[:cut], imu.accel[:cut]))
    a, b = (stationary.run(recording)["history"]["rest"] for recording in (whole, part))
    for name in stationary.NAMES:
        np.testing.assert_array_equal(a[name][:cut], b[name])


def test_the_papers_decision_has_the_asked_rate_as_a_whole():
    rng = np.random.default_rng(5)
    rate, window, count = 1e-2, 10, 40_000
    half = d.settings(window, SA, SW, 1 - np.sqrt(1 - rate), gravity=9.83)
    gyro = SW * rng.standard_normal((count, window, 3))
    accel = SA * rng.standard_normal((count, window, 3)) + [0, 0, -9.83]
    rest = d.evaluate(half, gyro, accel, every=window).rest_by("accel_std", "gyro_mean")
    assert abs((~rest).mean() - rate) < 4 * np.sqrt(rate / count)


def test_a_gap_and_a_bad_sample_are_reported_and_begin_a_new_window():
    recording = made(3)
    imu = recording.imu
    time, gyro = imu.time.copy(), imu.gyro.copy()
    time[1800:] += 0.3
    gyro[1700] = np.nan
    result = stationary.run(replace(recording, imu=Inertial("rates", "middle", time, gyro, imu.accel)))
    assert result["gaps_s"] == [pytest.approx(18.3)]
    assert result["refused_s"] == [pytest.approx(17.0)]
    assert result["undecided"] == 49 + 50 + 49
    for text in ("1 gaps, the first at 18.300 s", "1 refused samples, the first at 17.000 s"):
        assert text in stationary.report(result)
    for mask in result["history"]["rest"].values():
        assert not mask[1700:1749].any() and not mask[1800:1849].any()


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"rest": (0, 1.5)}, "needs 2 s"),
        ({"rest": (100, 200)}, "holds 0 samples"),
        ({"window": 300}, "2 to 256"),
        ({"false_alarm_rate": 2.0}, "between 0 and 1"),
    ],
)
def test_bad_questions_are_one_line(change, said):
    with pytest.raises(BoresightError, match=said):
        stationary.run(made(), **change)


def test_bad_recordings_are_one_line():
    recording = made(4)
    imu = recording.imu
    short = replace(recording, imu=Inertial("rates", "middle", imu.time[:240], imu.gyro[:240], imu.accel[:240]))
    with pytest.raises(BoresightError, match=r"window of 250 samples is longer than the data \(240 samples\)"):
        stationary.run(short, rest=(0, 3), window=250)
    silent = replace(recording, imu=Inertial("rates", "middle", imu.time, 0 * imu.gyro, imu.accel))
    with pytest.raises(BoresightError, match="no noise"):
        stationary.run(silent)
    spoilt = imu.gyro.copy()
    spoilt[100] = np.inf
    with pytest.raises(BoresightError, match="not finite"):
        stationary.run(replace(recording, imu=Inertial("rates", "middle", imu.time, spoilt, imu.accel)))


# ---------------------------------------------------------------- the real recording


@pytest.fixture(scope="module")
def foot():
    return read(real_recording("foot_mounted_square.npz"))


@pytest.fixture(scope="module")
def result(foot, compiled_once):
    return stationary.run(foot)


def test_the_likelihood_ratio_ends_the_first_rest_at_16_seconds(result):
    of = result["detectors"]["likelihood_ratio"]
    assert abs(of["first_rest_end_s"] - 16.0) <= 0.1
    assert of["segments"][0][0] == pytest.approx(0.49, abs=0.1), "the first rest begins with the first full window"


@pytest.mark.parametrize("window", [10, 25, 50, 100])
@pytest.mark.parametrize("rate", [1e-2, 1e-3, 1e-4])
def test_it_does_so_whatever_the_window_and_the_rate(foot, window, rate):
    found = stationary.run(foot, window=window, false_alarm_rate=rate)["detectors"]
    assert abs(found["likelihood_ratio"]["first_rest_end_s"] - 16.0) <= 0.1
    for name in ("gyro_std", "gyro_mean", "accel_std", stationary.KIM):
        assert abs(found[name]["first_rest_end_s"] - 16.0) <= 0.1, name


def test_numbers_of_the_documentation(result):
    shares = {name: round(100 * of["share"], 1) for name, of in result["detectors"].items()}
    assert shares == {
        "gyro_mean": 48.6, "gyro_std": 47.0, "accel_mean": 80.9, "accel_std": 34.8, "likelihood_ratio": 33.8,
        "kim-2018": 33.0,
    }  # fmt: skip
    # the mean force is blind to what a foot does: it calls most of the walk rest
    assert result["detectors"]["accel_mean"]["first_rest_end_s"] > 20
    assert len(result["detectors"]["likelihood_ratio"]["segments"]) == 8
    for name in ("gyro_mean", "gyro_std", "likelihood_ratio"):
        assert result["detectors"][name]["movement_in_stated_rest"] < 3e-3


def test_a_rest_that_was_quieter_than_the_floor_ends_early(foot):
    """From 10 s on the floor shakes: to the noise of the first 10 s alone that is movement, and rightly."""
    found = stationary.run(foot, rest=(0, 10))["detectors"]
    assert found["likelihood_ratio"]["first_rest_end_s"] == pytest.approx(12.0, abs=0.1)
    assert abs(found["gyro_std"]["first_rest_end_s"] - 16.0) <= 0.1


def test_where_it_declares_rest_the_sensor_hardly_moves(foot, result):
    """The mask against the raw signal over the window: a plausibility that needs no threshold."""
    gyro, _ = foot.imu.rates()
    rest = result["history"]["rest"]["likelihood_ratio"]
    norm = np.linalg.norm(gyro - result["noise"]["gyro_bias"], axis=1)
    assert np.abs(norm[rest]).max() < 0.01
    assert norm[~rest].max() > 1


def test_report_and_figure(result, tmp_path):
    text = stationary.report(result)
    for name in stationary.NAMES:
        assert name in text
    sheets = Sheets(tmp_path / "out")
    stationary.figures(result, sheets)
    assert sheets.written[0].stat().st_size > 20_000
    (tmp_path / "file").write_text("")
    with pytest.raises(BoresightError, match="cannot write"):
        stationary.figures(result, Sheets(tmp_path / "file"))
    json.dumps({key: value for key, value in result.items() if key != "history"}, allow_nan=False)
