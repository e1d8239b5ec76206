"""The stationary detectors: the C against their definitions, thresholds against counted false alarms, bad input."""

import importlib

import numpy as np
import pytest

from boresight import BoresightError
from boresight.runtime import detector as d
from boresight.runtime.status import Status

SA, SW = 2e-3, 8e-4
WINDOWS = 100_000


def definitions(gyro, accel, settings):
    """The five statistics of one window in NumPy, from how they are defined and not from how the C computes them."""
    u = accel.mean(axis=0) / np.linalg.norm(accel.mean(axis=0))
    return [
        np.linalg.norm(gyro.mean(axis=0)),
        np.sqrt(np.mean(np.sum((gyro - gyro.mean(axis=0)) ** 2, axis=1))),
        abs(np.linalg.norm(accel.mean(axis=0)) - settings.gravity),
        np.sqrt(np.mean(np.sum((accel - accel.mean(axis=0)) ** 2, axis=1))),
        np.mean(
            np.sum((accel - settings.gravity * u) ** 2, axis=1) / settings.sigma_accel**2
            + np.sum(gyro**2, axis=1) / settings.sigma_gyro**2
        ),
    ]


def at_rest(shape, seed, rate=(0, 0, 0), force=(0, 0, -9.81)):
    rng = np.random.default_rng(seed)
    return SW * rng.standard_normal((*shape, 3)) + rate, SA * rng.standard_normal((*shape, 3)) + force


def moving(samples, seed):
    """Rest, then motion, then rest."""
    gyro, accel = at_rest((samples,), seed)
    middle = slice(samples // 3, 2 * samples // 3)
    t = np.arange(samples)[middle, None]
    gyro[middle] += 0.2 * np.sin(0.3 * t + [0, 1, 2])
    accel[middle] += np.cos(0.2 * t + [0, 1, 2])
    return gyro, accel


@pytest.mark.parametrize("window", [2, 7, 50, 256])
def test_the_c_computes_the_definitions(window):
    gyro, accel = moving(900, window)
    settings = d.settings(window, SA, SW, 1e-3, gravity=9.81)
    decisions = d.evaluate(settings, gyro, accel)
    assert (decisions.status[: window - 1] == Status.NOT_READY).all()
    assert (decisions.status[window - 1 :] == Status.OK).all()
    assert np.isnan(decisions.statistic[: window - 1]).all()
    assert not decisions.rest[: window - 1].any()
    expected = [definitions(gyro[k - window : k], accel[k - window : k], settings) for k in range(window, 901)]
    # gyro_mean of a window that cancels is small; 1e-12 of what was added up
    np.testing.assert_allclose(decisions.statistic[window - 1 :], expected, rtol=1e-11, atol=1e-13)
    limit = [settings.threshold[name] for name in d.DETECTORS]
    np.testing.assert_array_equal(decisions.rest[window - 1 :], decisions.statistic[window - 1 :] < limit)
    assert decisions.rest.any(axis=0).all() and not decisions.rest[window - 1 :].all(axis=0).any()


def test_the_bound_on_rounding_errors_holds_and_is_not_idle():
    exact = importlib.import_module("boresight.codegen.text.stationary_detector").statistics
    rng = np.random.default_rng(3)
    looseness = []
    for _ in range(40):
        window = int(rng.integers(2, 40))
        scale = 10.0 ** rng.uniform(-6, 1, 6)
        samples = scale * rng.standard_normal((window, 6)) + 10.0 ** rng.uniform(-3, 1.9, 6)
        settings = d.Settings(window, SA, SW, {})
        got = d.evaluate(settings, samples[:, :3], samples[:, 3:]).statistic[-1]
        expected = exact([tuple(map(float, row)) for row in samples], settings.gravity, SA, SW)
        for value, (reference, bound) in zip(got, expected, strict=True):
            error = abs(reference - float(value))
            assert error <= bound
            looseness.append(float(bound / error) if error else np.inf)
    assert min(looseness) < 30, "a bound this wide would see no error"


def test_nothing_drifts_and_nothing_old_remains():
    """After a shock of the largest force allowed, a full window gives the bits of one that never saw it."""
    window = 25
    settings = d.settings(window, SA, SW, 1e-3)
    gyro, accel = at_rest((40 * window,), 5)
    shocked_gyro, shocked_accel = gyro.copy(), accel.copy()
    shocked_gyro[: 39 * window], shocked_accel[: 39 * window] = 99.9, -9999.9
    alone = d.evaluate(settings, gyro[39 * window :], accel[39 * window :]).statistic[-1]
    after = d.evaluate(settings, shocked_gyro, shocked_accel).statistic[-1]
    assert after.tobytes() == alone.tobytes()


def test_one_sample_at_a_time_gives_the_bits_of_the_whole_recording():
    gyro, accel = moving(200, 8)
    settings = d.settings(20, SA, SW, 1e-3)
    whole, loop = d.evaluate(settings, gyro, accel), d.Detector(settings)
    for k in range(200):
        status = loop.push(gyro[k], accel[k])
        assert status == whole.status[k]
        if status == Status.OK:
            assert loop.statistic.tobytes() == whole.statistic[k].tobytes()
            assert list(loop.rest.values()) == list(whole.rest[k])
    loop.restart()
    assert loop.push(gyro[0], accel[0]) == Status.NOT_READY


def test_runs_and_thinned_decisions_are_those_of_each_run_alone():
    gyro, accel = at_rest((2, 3, 100), 9)
    settings = d.settings(10, SA, SW, 1e-3)
    many = d.evaluate(settings, gyro, accel, every=10)
    assert many.statistic.shape == (2, 3, 10, 5) and many.status.shape == (2, 3, 10)
    one = d.evaluate(settings, gyro[1, 2], accel[1, 2])
    assert many.statistic[1, 2].tobytes() == one.statistic[9::10].tobytes()
    both = many.rest[..., d.DETECTORS.index("gyro_mean")] & many.rest[..., d.DETECTORS.index("accel_std")]
    np.testing.assert_array_equal(many.rest_by("gyro_mean", "accel_std"), both)


# ---------------------------------------------------------------- thresholds


def counted(settings, seed, **more):
    """The share of WINDOWS independent windows at rest in which each detector declares movement."""
    alarms, parts = np.zeros(len(d.DETECTORS)), 10
    for part in range(parts):
        gyro, accel = at_rest((WINDOWS // parts, settings.window), (seed, part), **more)
        alarms += (~d.evaluate(settings, gyro, accel, every=settings.window).rest).sum(axis=(0, 1))
    return alarms / WINDOWS


@pytest.mark.parametrize(("window", "rate"), [(2, 1e-2), (5, 1e-3), (25, 1e-2), (50, 1e-3)])
def test_false_alarms_come_at_the_rate_that_was_asked_for(window, rate):
    share = counted(d.settings(window, SA, SW, rate, gravity=9.81), window)
    # ten numbers of one binomial law: four sigmas leave one in 1500 to chance
    np.testing.assert_allclose(share, rate, rtol=0, atol=4 * np.sqrt(rate / WINDOWS))


def test_a_bias_and_an_error_of_gravity_are_part_of_the_law():
    rate, bias, off = 1e-2, 1.5e-3, 4e-3
    where = {"rate": (0, 0, bias), "force": (0, 0, -9.81 - off)}
    share = counted(d.settings(10, SA, SW, rate, gravity=9.81, rest_rate=bias, gravity_error=off), 1, **where)
    np.testing.assert_allclose(share, rate, rtol=0, atol=4 * np.sqrt(rate / WINDOWS))
    # and left out, they are movement
    share = dict(zip(d.DETECTORS, counted(d.settings(10, SA, SW, rate, gravity=9.81), 1, **where), strict=True))
    assert min(share["gyro_mean"], share["accel_mean"], share["likelihood_ratio"]) > 0.5


@pytest.mark.parametrize("detector", d.DETECTORS)
def test_rest_is_declared_while_moving_as_often_as_the_law_says(detector):
    window, phase = 20, np.arange(20)[:, None] * 2 * np.pi / 20
    settings = d.settings(window, SA, SW, 1e-3, gravity=9.81)
    rate, force, swing = 4.5e-4, 1e-3, 1.0
    gyro, accel = at_rest((20_000, window), 12, rate=(rate, 0, 0), force=(0, 0, -9.81 - force))
    gyro[..., 1] += swing * SW * np.sqrt(2) * np.sin(phase[:, 0])
    accel[..., 0] += swing * SA * np.sqrt(2) * np.sin(phase[:, 0])
    share = d.evaluate(settings, gyro, accel, every=window).rest_by(detector).mean()
    said = d.rest_declared(
        detector, settings.threshold[detector], window, SA, SW,
        rate=rate, force=force, swing_rate=swing * SW, swing_force=swing * SA,
    )  # fmt: skip
    assert 0.02 < said < 0.98
    assert abs(share - said) < 4 * np.sqrt(said * (1 - said) / 20_000)


def test_a_steady_turn_is_seen_by_the_mean_rate_and_not_by_its_spread():
    settings = d.settings(50, SA, SW, 1e-3, gravity=9.81)
    for sign in (-1, 1):  # the mean without its norm would call every negative rate rest
        gyro, accel = at_rest((50,), 4, rate=(0, 0, sign * 0.02))
        rest = dict(zip(d.DETECTORS, d.evaluate(settings, gyro, accel).rest[-1], strict=True))
        assert rest == {
            "gyro_mean": False, "gyro_std": True, "accel_mean": True, "accel_std": True, "likelihood_ratio": False,
        }  # fmt: skip


def test_a_steady_acceleration_is_seen_by_the_mean_force_and_not_by_its_spread():
    settings = d.settings(50, SA, SW, 1e-3, gravity=9.81)
    gyro, accel = at_rest((50,), 4, force=(0, 0, -9.85))
    rest = dict(zip(d.DETECTORS, d.evaluate(settings, gyro, accel).rest[-1], strict=True))
    assert [name for name, at in rest.items() if not at] == ["accel_mean", "likelihood_ratio"]


@pytest.mark.parametrize("detector", d.DETECTORS)
def test_thresholds_rise_as_alarms_get_rarer_and_undo_the_law(detector):
    rates = [0.5, 1e-2, 1e-4, 1e-8]
    limits = [d.threshold(detector, 20, SA, SW, rate) for rate in rates]
    assert limits == sorted(limits)
    for rate, limit in zip(rates, limits, strict=True):
        # 1 - probability loses digits as it nears one
        assert 1 - d.rest_declared(detector, limit, 20, SA, SW) == pytest.approx(rate, rel=1e-6, abs=1e-14)
    scaled = d.threshold(detector, 20, 3 * SA, 3 * SW, 1e-4)
    assert scaled == pytest.approx(limits[2] * (1 if detector == "likelihood_ratio" else 3))


# ---------------------------------------------------------------- bad input


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e9])
@pytest.mark.parametrize("signal", [0, 1])
def test_a_bad_sample_is_reported_and_no_window_reaches_across(value, signal):
    recording = at_rest((60,), 6)
    recording[signal][25, 1] = value
    decisions = d.evaluate(d.settings(10, SA, SW, 1e-3), *recording)
    assert decisions.status[25] == (Status.OUT_OF_RANGE if value == 1e9 else Status.NOT_FINITE)
    assert (decisions.status[26:35] == Status.NOT_READY).all()
    assert (decisions.status[[*range(9, 25), *range(35, 60)]] == Status.OK).all()
    assert np.isnan(decisions.statistic[25:35]).all() and not decisions.rest[25:35].any()
    assert np.isfinite(decisions.statistic[35:]).all()


def test_a_refused_sample_changes_nothing_in_the_loop():
    gyro, accel = at_rest((11,), 7)
    spoilt, clean = (d.Detector(d.settings(10, SA, SW, 1e-3)) for _ in range(2))
    for k in range(10):
        assert spoilt.push(gyro[k], accel[k]) == clean.push(gyro[k], accel[k])
        before = spoilt.statistic.copy(), spoilt.rest
        assert spoilt.push([0, np.nan, 0], accel[k]) == Status.NOT_FINITE
        assert spoilt.push(gyro[k], [0, 0, 1e9]) == Status.OUT_OF_RANGE
        assert (spoilt.statistic.tobytes(), spoilt.rest) == (before[0].tobytes(), before[1])
    assert spoilt.push(gyro[10], accel[10]) == clean.push(gyro[10], accel[10]) == Status.OK
    assert spoilt.statistic.tobytes() == clean.statistic.tobytes()


def test_a_gap_or_a_repeated_time_begins_a_new_window():
    time = np.arange(60) * 0.01
    time[30:] += 0.5
    time[45] = time[44]
    found = d.gaps(time)
    assert np.flatnonzero(found).tolist() == [30, 45, 46]
    decisions = d.evaluate(d.settings(10, SA, SW, 1e-3), *at_rest((60,), 6), restart=found)
    assert np.flatnonzero(decisions.status == Status.OK).tolist() == [*range(9, 30), *range(39, 45), *range(55, 60)]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"window": 1}, "window of 1 samples"),
        ({"window": 257}, "2 to 256"),
        ({"window": 10.0}, "whole number"),
        ({"sigma_accel": 0.0}, "sigma_accel is 0.0"),
        ({"sigma_gyro": -1e-3}, "must be positive"),
        ({"sigma_gyro": np.nan}, "sigma_gyro is nan"),
        ({"false_alarm_rate": 0.0}, "between 0 and 1"),
        ({"false_alarm_rate": 1.0}, "between 0 and 1"),
        ({"gravity": np.nan}, "gravity is nan"),
        ({"gravity": 0.0}, "gravity is 0.0"),
        ({"rest_rate": -1e-3}, "rest_rate is -0.001"),
        ({"gravity_error": np.inf}, "gravity_error is inf"),
    ],
)
def test_bad_settings_are_one_line(change, said):
    good = {"window": 10, "sigma_accel": SA, "sigma_gyro": SW, "false_alarm_rate": 1e-3}
    with pytest.raises(BoresightError, match=said):
        d.settings(**{**good, **change})


@pytest.mark.parametrize(
    ("gyro", "accel", "more", "said"),
    [
        ((9, 3), (9, 3), {}, r"window of 10 samples is longer than the data \(9 samples\)"),
        ((20, 3), (19, 3), {}, "shape"),
        ((20,), (20,), {}, "samples, 3"),
        ((20, 3), (20, 3), {"every": 0}, "every is 0"),
        ((20, 3), (20, 3), {"every": 21}, "every is 21"),
        ((20, 3), (20, 3), {"restart": [True]}, "restart has shape"),
    ],
)
def test_bad_recordings_are_one_line(gyro, accel, more, said):
    with pytest.raises(BoresightError, match=said):
        d.evaluate(d.settings(10, SA, SW, 1e-3), np.zeros(gyro), np.zeros(accel), **more)


def test_a_wrong_name_lists_the_right_ones():
    with pytest.raises(BoresightError, match="there are gyro_mean"):
        d.threshold("shoe", 10, SA, SW, 1e-3)
    with pytest.raises(BoresightError, match="there are gyro_mean"):
        d.Settings(10, SA, SW, {"shoe": 1.0})


def test_a_detector_without_threshold_never_says_rest():
    decisions = d.evaluate(d.Settings(10, SA, SW, {"gyro_std": 1.0}), *at_rest((30,), 2))
    assert decisions.rest_by("gyro_std")[9:].all()
    assert not decisions.rest[:, [0, 2, 3, 4]].any()
