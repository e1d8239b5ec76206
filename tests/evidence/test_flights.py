"""The transfer alignment in every condition that it was tried in: the committed results are what was asked."""

import re

import pytest
from conftest import ROOT

from boresight.evidence import results
from boresight.evidence.flights.conditions import CONDITIONS
from boresight.evidence.sources import Flights


@pytest.mark.parametrize("condition", CONDITIONS, ids=lambda condition: condition.name)
def test_a_flight_is_consistent_or_what_is_wrong_is_told(condition):
    found = results.read(Flights())["tried"]["units"][condition.name]
    if condition.asked == "refused":
        assert condition.told in found["error"]
        return
    assert "error" not in found
    low, high = found["band"]
    if condition.asked == "delay":
        low, high = found["delay"]["band"]
        assert low < found["delay"]["second half"] < high and low < found["delay"]["end"] < high
    if condition.asked == "taken":
        assert found["refused"] == 0
    if condition.asked == "consistent":
        assert low < found["nees"]["second half"] < high
    if condition.asked in ("consistent", "heals"):
        assert low < found["nees"]["end"] < high
    assert condition.told or condition.asked != "told", "what should be told?"
    assert not condition.told or any(condition.told in note for note in found["notes"]), found["notes"]


CARRIED = re.compile(r"^\| (.+, carried) \| (.+) of (\d+) \| (.+) to (.+) \| (.+) \| (.+) \|$", re.MULTILINE)


def test_the_page_tells_of_carried_sensors_what_was_flown():
    found = results.read(Flights())["tried"]["units"]
    rows = CARRIED.findall((ROOT / "docs" / "transfer-alignment.md").read_text())
    assert {name for name, *_ in rows} == {name for name in found if name.endswith(", carried")}
    for name, *shown in rows:
        of = found[name]
        numbers = of["nees"]["end"], of["states"], *of["band"]
        attitude = (" ".join(f"{value:.2f}" for value in of["attitude"][which]) for which in ("is", "claimed"))
        assert shown == [*(f"{number:.3g}" for number in numbers), *attitude], name
