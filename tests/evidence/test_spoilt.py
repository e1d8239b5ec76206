"""Formulas as they are shown: the committed results of every single change of every formula are judged."""

import pytest

from boresight.derive.papers import PAPERS
from boresight.evidence import results
from boresight.evidence.sources import Derivations
from boresight.evidence.spoilt import WRITERS


@pytest.mark.parametrize("form", WRITERS)
@pytest.mark.parametrize("name", PAPERS)
def test_no_changed_formula_is_taken_for_the_judged_one_without_a_reason(name, form):
    of = results.read(Derivations(name))["shown"]["units"][form]
    assert of["left"] == of["wrong"] == []
    assert of["tried"] == of["refused"] + of["unequal"] + sum(of["same"].values())
    assert of["tried"] > 100 * of["formulas"] and of["unequal"] > of["formulas"]
