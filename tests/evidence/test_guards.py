"""Bad input is refused, whichever number it is in, and nothing is written."""

import pytest
from committed import NAMES, committed, folder_of, spoilt

from boresight.evidence.guards import guards


@pytest.mark.parametrize("name", NAMES)
def test_every_bad_input_is_refused_and_every_guard_is_taken(name, tmp_path):
    found = guards(folder_of(name), tmp_path)
    printed = {unit.name for unit in folder_of(name).units if unit.described is not None}
    assert all(of["tried"] for unit, of in found.items() if unit in printed)
    wrong = {unit: of["wrong"][:5] for unit, of in found.items() if of["wrong"]}
    assert not wrong, wrong
    # A function without arguments cannot fail; what the tests of the templates leave out is listed in the results.
    read = {unit.name for unit in folder_of(name).units if unit.name in printed and unit.described["fields"]}
    before = committed(name, "guards")
    left = {
        unit: of["not_taken"][:5]
        for unit, of in found.items()
        if len(of["not_taken"]) > (0 if unit in read else len(before[unit]["not_taken"]))
    }
    assert not left, left


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
