"""What is shown is what was judged: every formula is read back from each format and evaluated."""

import pytest

from boresight.derive.papers import PAPERS
from boresight.evidence.spoilt import WRITERS, of_paper, rendered


@pytest.mark.parametrize("form", WRITERS)
@pytest.mark.parametrize("name", PAPERS)
def test_every_formula_of_a_paper_is_shown_as_it_was_judged(name, form):
    shown = of_paper(name)
    assert len(shown) > 20
    assert [one.where for one in shown if not one.holds(form, rendered(one, form))] == []
