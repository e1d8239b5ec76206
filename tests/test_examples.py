"""The examples fly right: their errors are as large as their covariance says, and their innovations too."""

import importlib
import sys

import numpy as np
import pytest
from conftest import ROOT
from scipy.stats import chi2

from boresight.codegen.generate import generate
from boresight.runtime.library import load

EXAMPLES = ROOT / "examples"
RARE = 1e-3  # of right filters fail this


@pytest.fixture(scope="module")
def flown(compiled_once, tmp_path_factory):
    """By name: the script of an example, its library, and what its flight leaves to be judged."""
    known = {}
    sys.path.insert(0, str(EXAMPLES))

    def flown(name):
        if name not in known:
            folder = tmp_path_factory.mktemp("examples") / name
            generate(f"{EXAMPLES / name}.py:{name.upper()}", folder)
            script, library = importlib.import_module(f"fly_{name}"), load(folder)
            known[name] = script, library, script.fly(library)
        return known[name]

    yield flown
    sys.path.remove(str(EXAMPLES))


def rare(total, freedom):
    """Whether a chi-square number of so many degrees of freedom is seldom so far out, on either side."""
    return min(chi2.cdf(total, freedom), chi2.sf(total, freedom)) < RARE / 2


def consistent(judged):
    """Whether errors are as large as the covariance says, and innovations as the filter expects."""
    runs, n = judged.errors.shape[1:]
    for at in (len(judged.nees) // 3, -1):
        assert not rare(judged.nees[at] * runs, n * runs), judged.report()
    for measurement, taken in judged._innovations.items():
        _, nis, rows = map(np.array, zip(*taken, strict=True))
        assert not rare(nis.sum(), rows.sum()), (measurement, judged.report())
    return True


@pytest.mark.parametrize("name", ["gnss_ins", "radar"])
def test_errors_and_innovations_are_as_large_as_the_filter_says(flown, name):
    assert consistent(flown(name)[2])


def test_a_delay_that_the_filter_does_not_know_is_seen_in_its_innovations(flown, monkeypatch):
    script, library, _ = flown("gnss_ins")
    monkeypatch.setattr(script, "SECONDS", 20)
    right = script.fly(library)
    update = script.CompiledFilter.update
    monkeypatch.setattr(script.CompiledFilter, "update", lambda *a, lag, **k: update(*a, lag=0.0, **k))
    late = script.fly(library)
    assert right.nis("velocity")[0] < 1.1 < 1.3 < late.nis("velocity")[0]


def test_the_radar_rejects_what_is_no_echo_of_its_target_and_tracks_it_past_180_degrees(flown):
    script, _, judged = flown("radar")
    _, _, rows = map(np.array, zip(*judged._innovations["echo"], strict=True))
    assert abs(np.mean(rows / 2) - (1 - script.CLUTTER)) < 0.01
    east = script.BEGIN[1]
    crossed = script.moved(np.tile(script.BEGIN, (20, 1)), np.random.default_rng(0))
    for _ in range(round(15 / script.DT)):
        crossed = script.moved(crossed, np.random.default_rng(0))
    assert east > 0 > crossed[:, 1].max() and crossed[:, 0].max() < 0  # south of the radar, from east to west
