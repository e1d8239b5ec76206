"""The shipped self-test sees what goes wrong in the C, and the mutation that says so can be trusted."""

import pytest
from committed import SMALL, committed, folder_of, spoilt

from boresight.evidence.mutants import Types, candidates, mutants, parsed

BAR = 0.99
# Below the bar, as far as the self-test reaches today; what survives is told under "What fell short" in
# docs/evidence.md: ends of norms, ties, one number more, what only saves work.
BELOW = {"filter": 0.86, "covariance": 0.815, "digest": 0.945, "live": 0.725, "detector": 0.945}


def share(of):
    """Killed of those that differ from the unit."""
    return of["killed"] / max(1, of["tried"] - of["equivalent"])


@pytest.mark.parametrize("name", SMALL)
def test_the_committed_run_killed_99_of_100(name):
    found = {unit: share(of) for unit, of in committed(name, "mutants").items()}
    low = {unit: killed for unit, killed in found.items() if killed < BELOW.get(unit.rsplit("_", 1)[1], BAR)}
    assert not low, low


@pytest.mark.digits
@pytest.mark.parametrize("name", ["strapdown", "stationary_detector"])
def test_what_survives_of_a_sample_survived_the_committed_run(name, tmp_path):
    """The mutants drawn here are among those drawn there."""
    before = committed(name, "mutants")
    for unit, of in mutants(folder_of(name), tmp_path, 60).items():
        assert min(60, of["candidates"]) <= of["tried"] <= 120 and of["killed"] > 30  # 60 a form, of loops two
        assert set(of["survivors"]) <= set(before[unit]["survivors"])


def test_mutants_are_those_of_the_text():
    unit = next(unit for unit in folder_of("euler_matching").units if unit.name == "em_F")
    words = [word.split(": ", 1)[1].split(", in `")[0] for word in candidates(unit)]
    # the kernel has three signs; the box has twelve ends, half of them negative
    assert words.count("0.01 * 1.001") == words.count("0.01 * 0.999") == 6
    assert words.count("minus dropped") == 6
    types = Types(parsed(unit))
    assert types.real["omega_in_n"] == types.real["F_nz"] == 1 and "status" not in types.real


def test_of_loops_checks_integers_bits_calls_and_arguments_are_mutated_and_the_form_of_float():
    unit = next(unit for unit in folder_of("euler_matching").units if unit.name == "em_filter")
    made = {precision: candidates(unit, precision) for precision in ("double", "float")}
    words = [word.split(": ", 1)[1].split(", in `")[0] for word in made["double"]]
    kinds = {"check passed", "statement dropped", "& to |", ">> to <<", "! dropped", "1U + 1", "|= to &="}
    assert kinds - set(words) == set()
    assert "sound filter->x and filter->P swapped" in words
    branches = [word for word in made["float"] if word.startswith("variances: ") and word not in made["double"]]
    assert len(branches) > 20, "the branches of UD"


def test_a_function_of_a_header_is_mutated_where_the_unit_calls_it_itself_or_through_others():
    units = {unit.name: unit for unit in folder_of("euler_matching").units}
    by_filter, by_digest = (Types(parsed(units[name])).called for name in ("em_filter", "em_digest"))
    assert "bs_clamp" in by_filter and "bs_clamp" not in by_digest


def test_a_self_test_that_compares_nothing_kills_nothing_of_the_numbers(sd_copy, tmp_path):
    right, wrong = "allowed = printed ? (double)tolerance[k] : 0.0;", "allowed = 1e300;"
    for unit, of in mutants(spoilt(sd_copy, "selftest/selftest.c", right, wrong), tmp_path, 30).items():
        # what is killed are guards: bad input is still refused or not
        assert share(of) < 0.6 and any(" to " in word for word in of["survivors"]), unit
