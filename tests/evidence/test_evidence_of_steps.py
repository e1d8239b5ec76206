"""Every single mutation of every step of every paper is refuted, or says the same for a reason that is computed."""

import pytest

from boresight.derive.ledger.lines import count_steps
from boresight.derive.ledger.mutation import UNEXPLAINED, line_survivors
from boresight.derive.papers import paper
from boresight.evidence import results
from boresight.evidence.sources import derivations

by_name = pytest.mark.parametrize("of", derivations(), ids=lambda of: of.name)


def committed(of):
    kept = results.read(of).get("steps")
    assert kept, f"no steps are committed of {of.name}: run 'make evidence'"
    return kept["units"]


@by_name
def test_the_committed_run_left_no_mutant_of_a_step_unexplained(of):
    found = committed(of)
    assert list(found) == sorted(e.number for e in paper(of.name).equations)
    left = [what for unit in found.values() for what in unit["unexplained"]]
    assert not left and not any(UNEXPLAINED in unit["survivors"] for unit in found.values()), left


@by_name
def test_the_committed_run_tried_every_step(of):
    counted = count_steps(paper(of.name).equations)
    found = committed(of).values()
    assert [sum(unit[name] for unit in found) for name in ("steps", "evaluated", "prose")] == [
        counted.steps,
        counted.evaluated,
        counted.prose,
    ]
    assert all(unit["tried"] for unit in found if unit["evaluated"])


@pytest.mark.digits
@by_name
def test_one_equation_tried_here_has_the_survivors_of_the_committed_run(of):
    """The one of the fewest mutants."""
    found = committed(of)
    number = min((n for n in found if found[n]["tried"]), key=lambda n: found[n]["tried"])
    one, tried, survived = paper(of.name), 0, 0
    for index, step in enumerate(one.equation(number).derivation.steps):
        if step.formulas:
            count, survivors = line_survivors(one, one.equation(number), index)
            tried, survived = tried + count, survived + len(survivors)
    assert (tried, survived) == (found[number]["tried"], sum(found[number]["survivors"].values()))
