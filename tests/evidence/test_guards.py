"""Bad input is refused, whichever number it is in, and nothing is written."""

import pytest
from committed import LIVE, NAMES, committed, comparable, folder_of, spoilt

from boresight.evidence.guards import guards


@pytest.mark.parametrize("name", NAMES)
def test_every_bad_input_is_refused_and_every_guard_is_taken(name):
    found = committed(name, "guards")
    units = {unit.name: unit.described for unit in folder_of(name).units}
    assert set(found) == set(units)
    assert all(of["tried"] for unit, of in found.items() if units[unit] is not None)
    wrong = {unit: of["wrong"][:5] for unit, of in found.items() if of["wrong"]}
    assert not wrong, wrong
    # A function without arguments cannot fail; what the tests of the loops leave out is listed in the results.
    read = {unit for unit, described in units.items() if described is not None and described["fields"]}
    left = {unit: of["not_taken"][:5] for unit, of in found.items() if unit in read and of["not_taken"]}
    assert not left, left


@pytest.mark.digits
def test_a_live_run_finds_what_is_committed(tmp_path):
    assert guards(folder_of(LIVE), tmp_path) == comparable(LIVE, "guards")


@pytest.mark.parametrize(
    ("path", "right", "wrong"),
    [
        ("src/em_F.c", "BS_REAL(0.01), BS_REAL(0.01), BS_REAL(0.01)", "BS_REAL(0.01), BS_REAL(0.011), BS_REAL(0.01)"),
        ("src/em_F.c", "omega_in_n_high, 3)", "omega_in_n_high, 2)"),
        ("include/boresight.h", "return BS_NOT_FINITE;", "status = BS_OUT_OF_RANGE;"),
        (
            "src/em_feedback.c",
            "    status = bs_check(nav->mu",
            "    mu[0] = BS_REAL(0.0);\n    status = bs_check(nav->mu",
        ),
    ],
)
def test_a_guard_that_lets_something_pass_is_seen(path, right, wrong, em_copy, tmp_path):
    found = guards(spoilt(em_copy, path, right, wrong), tmp_path)
    assert any(unit["wrong"] for unit in found.values())
