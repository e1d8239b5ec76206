"""The live loop in every condition that it was tried in: the committed results are what was asked."""

import sys

import pytest
from conftest import ROOT

from boresight.evidence import results
from boresight.evidence.sources import Flights

sys.path.append(str(ROOT / "tests" / "live"))
from conditions import CONDITIONS


@pytest.mark.parametrize("condition", [one for one in CONDITIONS if one.asked != "named"], ids=lambda one: one.name)
def test_a_flight_is_what_is_asked_of_it_or_the_list_says_that_it_is_not(condition):
    found = results.read(Flights())["tried"]["units"][condition.name]
    assert not found["raised"]
    assert found["ok"] == condition.held
    if condition.asked == "consistent" and condition.held:
        assert found["low"] < found["nees"] < found["high"]


def test_what_nothing_names_is_counted():
    """Errors that are not white: docs/live.md says how many of these conditions end without a code and off."""
    kept = results.read(Flights())["tried"]["units"]
    assert set(kept) == {one.name for one in CONDITIONS}
    named = [one.name for one in CONDITIONS if one.asked == "named"]
    silent = sum(not kept[name]["ok"] for name in named)
    page = (ROOT / "docs" / "live.md").read_text()
    assert f"Of {len(named)} conditions in which it may leave its band {silent} are silent" in page
