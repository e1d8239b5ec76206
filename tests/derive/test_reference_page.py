"""The reference page is of the functions that are there, and says what each takes and returns."""

import inspect
import re

import pytest
from conftest import ROOT

from boresight.derive.pages import reference
from boresight.derive.papers import paper

PAGE = ROOT / "docs" / "reference" / "mechanics.md"
FUNCTIONS = [
    pytest.param(module, name, value, id=f"{module.__name__.rsplit('.', 1)[1]}.{name}")
    for module in reference.MODULES
    for name, value in reference.public(module)
]


def test_the_committed_page_is_made_of_the_docstrings_here():
    assert PAGE.read_text() == reference.page(), f"run python -m boresight.derive.pages.reference > {PAGE}"


@pytest.mark.parametrize(("module", "name", "value"), FUNCTIONS)
def test_every_function_is_there_with_its_shapes_or_units_and_its_rows(module, name, value):
    page = PAGE.read_text()
    said = page.split(f"\n### `{name}(", 1)[1].split("\n### ", 1)[0]
    assert re.search(r"\d+x\d+|\(\d|\(m|\brad\b|\[w, x, y, z\]", said), said
    doc = inspect.getdoc(value)
    judged = {match.equation for one in paper("mechanics").maps for match in one.matches}
    for row in re.findall(r"[a-z]+-\d+", " ".join(reference.ROW.findall(doc))):
        assert row in judged and f"`{row}`" in said


def test_every_judged_row_of_mechanics_is_named_by_a_function_that_flies():
    docs = "\n".join(inspect.getdoc(value) for _, _, value in (p.values for p in FUNCTIONS))
    named = set(re.findall(r"[a-z]+-\d+", " ".join(reference.ROW.findall(docs))))
    assert named == {"strapdown-1", "phi-3", "phi-4", "phi-5", "psi-3", "psi-4", "map-2", "map-3"}
