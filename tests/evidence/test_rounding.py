"""The bound on rounding in single precision holds on the C, and a bound that is too small would be seen."""

import pytest
from committed import NAMES, committed, folder_of

from boresight.evidence import rounding


@pytest.mark.parametrize("name", NAMES)
def test_the_committed_runs_never_broke_the_bound(name):
    for unit, of in committed(name, "rounding").items():
        assert of["violations"] == 0, unit
        assert of["runs"] >= rounding.RUNS or of["drawn"] == 1, f"{unit}: {of['runs']} runs"


@pytest.fixture
def few(monkeypatch):
    monkeypatch.setattr(rounding, "RUNS", 4000)


def test_no_output_errs_by_more_than_its_bound(few, tmp_path):
    found = rounding.rounding(folder_of("strapdown"), tmp_path)
    assert all(of["violations"] == 0 and of["runs"] >= 4000 for of in found.values())
    # Loose by some tens at most, and never below one.
    assert all(1 <= of["loose"] < 100 for of in found.values())


def test_a_bound_that_forgets_most_roundings_is_broken(few, tmp_path, monkeypatch):
    true = rounding.evaluate
    monkeypatch.setattr(
        rounding, "evaluate", lambda *args: (lambda values, bounds: (values, [b / 20 for b in bounds]))(*true(*args))
    )
    found = rounding.rounding(folder_of("strapdown"), tmp_path)
    assert found["sd_step"]["violations"] > 0
