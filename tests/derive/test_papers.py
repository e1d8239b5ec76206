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
from boresight.derive.papers.kang_2025 import printed as kang_2025
from boresight.derive.papers.kim_2018 import printed as kim_2018
from boresight.derive.papers.song_lee_2001 import printed as song_lee_2001

PRINTS = dict(zip(PAPERS, (song_lee_2001, kim_2018, kang_2025), strict=True))


@needs_source
@pytest.mark.parametrize(("name", "number"), [(name, n) for name in PRINTS for n in PRINTS[name].PRINTED])
def test_printed_latex_stands_at_its_lines_of_the_source(name, number):
    (first, last), displays = PRINTS[name].PRINTED[number]
    lines = source(name)[first - 1 : last]
    text = "\n".join(lines)
    assert displays[0] in lines[0] and displays[-1] in lines[-1]
    assert all(display in text for display in displays)
    untagged = number in getattr(PRINTS[name], "CITED", ()) or not number.isdigit()
    assert untagged or re.search(rf"\\tag\{{{number}\}}|\({number}\)", text)


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
