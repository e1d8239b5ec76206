"""What notices a disturbance of the hold, and that a platform that turned is not pulled back silently."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from boresight import BoresightError
from boresight.runtime import detector
from boresight.studies.azimuth_hold import alignment
from boresight.studies.azimuth_hold import shock as study
from tests.drawing import drawn

TIMES = (60, 110)
SHORT = study.Disturbed(runs=4, seconds=130, times_s=TIMES)


@pytest.fixture(scope="module")
def result():
    return study.run(SHORT)


def row(result, event, azimuth, motion, gate):
    (found,) = (
        r
        for r in result["rows"]
        if (r["event"], r["azimuth"], r["detector"], r["gate"]) == (event, azimuth, motion, gate)
    )
    return found


BOTH = ("white", "state")


def test_nothing_is_stopped_or_called_stale_when_nothing_happens(result):
    for r in result["rows"]:
        if r["event"] == "none":
            assert r["stopped_s"] == 0 and r["stale"] == 0 and r["resets"] == 0


@pytest.mark.parametrize("event", [name for name in study.EVENTS if name != "none"])
def test_the_detector_stops_the_updates_in_every_event_and_for_no_longer(result, event):
    least, most = {"handling": (6, 9)}.get(event, (2, 5))
    for azimuth in BOTH:
        assert least <= row(result, event, azimuth, True, False)["stopped_s"] <= most


@pytest.mark.parametrize("azimuth", BOTH)
def test_a_turned_platform_is_pulled_back_silently_without_the_gate(result, azimuth):
    for motion in (False, True):
        r = row(result, "turn", azimuth, motion, False)
        assert r["after_arcmin"][0] > 25 and r["silent"] == 4 and r["stale"] == 0


@pytest.mark.parametrize("azimuth", BOTH)
def test_with_the_gate_the_filter_says_that_its_azimuth_is_stale_and_claims_no_more_than_it_knows(result, azimuth):
    for motion in (False, True):
        r = row(result, "turn", azimuth, motion, True)
        assert r["stale"] == 4 and r["silent"] == 0
        assert r["after_arcmin"][0] < 8  # the gyros measured the turn
        assert 25 < r["after_arcmin"][1] < 35  # but it might as well have been their own upset
        assert r["end_arcmin"][0] < 6 and r["end_arcmin"][1] < 3.5  # acquired anew


@pytest.mark.parametrize("azimuth", BOTH)
def test_an_upset_of_the_unit_looks_like_a_turn_to_the_gate_and_is_recovered(result, azimuth):
    r = row(result, "upset", azimuth, True, True)
    assert r["stale"] == 4 and r["silent"] == 0 and r["resets"] == 1
    assert r["after_arcmin"][0] > 40 and r["after_arcmin"][1] > 40
    assert r["end_arcmin"][0] < 6 and r["end_arcmin"][1] < 3.5


def test_handling_without_a_guard_spoils_the_hold_that_trusts_its_reference(result):
    spoiled, guarded = (row(result, "handling", "state", guard, guard) for guard in (False, True))
    assert spoiled["nees"] > 1.5 * guarded["nees"]
    quiet = row(result, "none", "state", True, True)
    assert guarded["after_arcmin"][0] == pytest.approx(quiet["after_arcmin"][0], rel=0.1)


def test_thresholds_come_from_the_noise_alone_and_rest_passes():
    models, scenario = alignment.load_models(), alignment.Scenario()
    start = alignment.align(models, alignment.Scenario(align_s=15.0), runs=2, seed=1)
    settings = study.thresholds(scenario, start)
    f_b = alignment.rest_specific_force(models, start.position, start.q_b2n_wxyz)
    dtheta, dv = start.drawn.sensors.measured(np.zeros((2, 3)), f_b * 0.01, 0.01, 20_000)
    said = detector.evaluate(settings, np.moveaxis(dtheta, 0, 1) * 100, np.moveaxis(dv, 0, 1) * 100)
    assert said.rest_by(*study.SAYS_MOTION)[:, study.WINDOW :].all()


def test_the_reset_begins_velocity_and_level_anew():
    P = np.random.default_rng(0).normal(size=(2, 16, 16))
    P = P @ np.swapaxes(P, -1, -2)
    loop = SimpleNamespace(P=P.copy())
    study.reset(loop, np.array([True, False]))
    assert np.array_equal(loop.P[1], P[1])
    assert np.allclose(np.diag(loop.P[0])[3:8], [1, 1, 1, study.RESET_TILT**2, study.RESET_TILT**2])
    assert np.linalg.eigvalsh(loop.P[0])[0] > 0
    assert np.array_equal(loop.P[0, 8:, 8:], P[0, 8:, 8:])


def test_the_report_has_a_line_for_each_event_and_configuration_and_every_claim_holds(result, tmp_path):
    lines = study.report(result).splitlines()
    assert lines.index("") == 2 + len(study.EVENTS) * len(study.CONFIGS)
    assert all(claim.holds for claim in study.claims(result))
    assert "  NOT SO" not in study.report(result)
    assert len(drawn(study.STUDY, result, tmp_path)) == 1


def test_bad_times_are_named():
    with pytest.raises(BoresightError, match="26 s from it"):
        study.run(study.Disturbed(times_s=(60, 70)))


def test_the_hold_ends_when_it_is_asked_to(result):
    assert result["end_s"] == SHORT.seconds
    assert [option.name for option in study.STUDY.options()] == ["runs", "seed", "seconds"]
    with pytest.raises(BoresightError, match="got 60, 110 and 100 s"):
        study.run(replace(SHORT, seconds=100))
