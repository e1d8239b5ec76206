"""Every page of a paper or a model is written in every format, and its LaTeX compiles."""

import pytest
from tools import needs

from boresight import BoresightError
from boresight.codegen.folder import folders
from boresight.codegen.generate import COMPONENTS
from boresight.derive.pages.render import render
from boresight.derive.papers import paper
from boresight.evidence import results
from boresight.evidence.pages import pages, written
from boresight.evidence.sources import Derivations, derivations

MODELS = [folder for folder in folders() if folder.manifest["model"] not in COMPONENTS]


@pytest.mark.parametrize("subject", [*derivations(), *MODELS], ids=lambda subject: subject.name)
def test_the_committed_page_compiles_and_its_prose_ends_by_its_width(subject):
    kept = results.read(subject).get("pages")
    if not kept:  # what is not held is listed as not held
        assert f"pages of {subject.name}: " in results.OPEN.read_text(), f"run 'make evidence' for {subject.name}"
        return
    (page,) = kept["units"].values()
    assert page["pdf"] and page["latex"]["ascii formulas"] and page["html"] > 1000
    assert page["text 60"]["lines"] > page["text 100"]["lines"] > 50


@needs("pdflatex")
def test_the_smallest_page_is_written_and_compiles(tmp_path):
    (page,) = pages(Derivations("delay-error"), tmp_path).values()
    assert page["pdf"] and page["latex"]["ascii formulas"] and page["text 60"]["lines"] > 200


@needs("pdflatex")
def test_a_page_with_a_letter_as_itself_fails():
    def page(form):
        text = render(paper("delay-error"), "5", form)
        return text.replace(r"\phi", "ж") if form == "latex" else text

    with pytest.raises(BoresightError, match="pdflatex has no sign 'ж'"):
        written(page)
