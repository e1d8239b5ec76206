"""What holds of every paper: its print is the source's, its pages are well formed, its import derives nothing."""

import re
import subprocess
import sys
import xml.dom.minidom
from importlib import import_module

import pytest
from conftest import ROOT
from sources import needs_source, source

from boresight.derive.ledger.entries import differences, equations, ledger
from boresight.derive.pages.render import render
from boresight.derive.papers import PAPERS

PRINTS = {paper: import_module(module + "_print") for paper, module in PAPERS.items()}


@needs_source
@pytest.mark.parametrize(("paper", "number"), [(paper, n) for paper in PRINTS for n in PRINTS[paper].PRINTED])
def test_printed_latex_stands_at_its_lines_of_the_source(paper, number):
    (first, last), displays = PRINTS[paper].PRINTED[number]
    lines = source(paper)[first - 1 : last]
    text = "\n".join(lines)
    assert displays[0] in lines[0] and displays[-1] in lines[-1]
    assert all(display in text for display in displays)
    cited = getattr(PRINTS[paper], "CITED", ())
    assert number in cited or re.search(rf"\\tag\{{{number}\}}|\({number}\)", text)


@pytest.mark.parametrize("paper", PAPERS)
def test_pages_hold_every_equation_and_are_well_formed(paper):
    page = render(paper, None, "html")
    formulas = re.findall(r"<math.*?</math>", page, re.DOTALL)
    assert len(formulas) >= 2 * len(equations(paper))
    for formula in formulas:
        xml.dom.minidom.parseString(formula.replace("&InvisibleTimes;", ""))
    assert re.findall(r'<section id="eq-(\d+)">', page) == [equation.number for equation in equations(paper)]
    assert max(map(len, render(paper).splitlines())) <= 110


@pytest.mark.parametrize("paper", PAPERS)
def test_the_errata_table_of_the_documentation_is_fresh(paper):
    document = ROOT / "docs" / "derivations" / f"{paper}.md"
    assert errata_table(paper) in document.read_text(encoding="utf-8")


def errata_table(paper):
    """The errata of a paper as a Markdown table."""
    lines = ["| equation | kind | origin | printed | derived |", "|---|---|---|---|---|"]
    for equation, entry in zip(equations(paper), ledger(paper), strict=True):
        if entry.status == "erratum":
            found = differences(equation.read(), equation.derived)
            printed, derived = (changed(getattr(d, which) for d in found) for which in ("printed", "derived"))
            lines.append(f"| ({entry.number}) | {entry.kind} | {entry.origin} | {printed} | {derived} |")
    return "\n".join(lines) + "\n"


def changed(places):
    texts = (" ".join(str(place).replace("Matrix", "").split()) for place in places)
    return ", ".join(f"`{text}`" for text in dict.fromkeys(texts))


def test_importing_the_papers_derives_nothing():
    code = (
        "import sys; from importlib import import_module; "
        f"papers = [import_module(name) for name in {list(PAPERS.values())}]; "
        "assert all(paper.equations.cache_info().currsize == 0 for paper in papers); "
        "assert not [name for name in sys.modules if name.endswith(('_world', 'derive.ledger'))]"
    )
    subprocess.run([sys.executable, "-c", code], check=True, cwd=ROOT)
