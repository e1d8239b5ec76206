"""What holds of every paper: its print is the source's, its pages are well formed, its import derives nothing."""

import re
import subprocess
import sys

import pytest
from conftest import ROOT
from sources import needs_source, source

from boresight.derive.ledger.differences import differences
from boresight.derive.ledger.entries import ledger
from boresight.derive.papers import PAPERS, paper

CITED = {"kim-2018": ("21",)}  # numbers that the text cites and no display is tagged with


@needs_source
@pytest.mark.parametrize("name", PAPERS)
def test_printed_latex_stands_at_its_lines_of_the_source(name):
    for equation in paper(name).equations:
        (first, last), shown, number = equation.lines, equation.latex, equation.number
        lines = source(name)[first - 1 : last]
        text = "\n".join(lines)
        assert shown[0] in lines[0] and shown[-1] in lines[-1], number
        assert all(display in text for display in shown), number
        untagged = number in CITED.get(name, ()) or not number.isdigit()
        assert untagged or re.search(rf"\\tag\{{{number}\}}|\({number}\)", text), number


@pytest.mark.parametrize("name", PAPERS)
def test_the_errata_table_of_the_documentation_is_fresh(name):
    document = ROOT / "docs" / "derivations" / f"{name}.md"
    assert errata_table(paper(name)) in document.read_text(encoding="utf-8")


def errata_table(one):
    """The errata of a paper as a Markdown table."""
    lines = ["| equation | kind | origin | printed | derived |", "|---|---|---|---|---|"]
    for equation, entry in zip(one.equations, ledger(one), strict=True):
        if entry.status == "erratum":
            found = differences(equation.read(), equation.derived)
            printed, derived = (changed(getattr(d, which) for d in found) for which in ("printed", "derived"))
            lines.append(f"| {equation.label} | {entry.kind} | {entry.origin} | {printed} | {derived} |")
    return "\n".join(lines) + "\n"


def changed(places):
    texts = (" ".join(str(place).replace("Matrix", "").split()) for place in places)
    return ", ".join(f"`{text}`" for text in dict.fromkeys(texts))


def test_naming_the_papers_derives_nothing():
    code = (
        "import sys; from boresight.derive.papers import PAPERS, paper; "
        "made = [paper(name) for name in PAPERS]; "
        "assert all('equations' not in vars(one) for one in made); "
        "assert 'boresight.derive.ledger.entries' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True, cwd=ROOT)
