"""Derivations on the terminal, in LaTeX, HTML and PDF, and the page made from them."""

import re
import shutil

import pytest

from boresight import BoresightError
from boresight.derive.pages.latex import latex_name
from boresight.derive.pages.render import pdf_from_latex, render
from boresight.derive.papers import paper

PAPER = paper("song-lee-2001")
needs_pdflatex = pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")


@pytest.mark.parametrize("columns", [80, 110])
def test_terminal_shows_print_derivation_steps_and_evidence_within_its_width(columns, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(columns))
    text = render(PAPER, "9")
    assert text.startswith("song-lee-2001 (9)  erratum: letter, transcription  [source line 74]")
    for piece in ("printed", "cos(φ)", "derived", "cos(ψ)", "1. invert:", "evidence: ", "note: Origin transcription"):
        assert piece in text
    assert max(map(len, text.splitlines())) <= columns


def test_all_equations_are_shown_with_the_counts_and_what_stands_beside_them():
    text = render(PAPER)
    assert text.startswith("song-lee-2001: 28 equations, 5 exact, 8 first-order, 6 definition, 9 erratum")
    assert all(f"song-lee-2001 ({number})" in text for number in range(1, 29))
    assert "Table 1: 13, 12, 21, 3 cells" in text


def test_html_stands_alone():
    page = render(PAPER, None, "html")
    assert "src=" not in page and "href=" not in page


def test_latex_carries_the_print_verbatim_and_no_letter_outside_ascii():
    document = render(PAPER, None, "latex")
    assert document.isascii()
    assert r"\hat{C}_b^n(\hat{\phi}, \hat{\theta}, \hat{\psi}) = C_n^{n'} C_b^n" in document
    assert document.count(r"\subsection*{(") == 28


@needs_pdflatex
def test_latex_of_every_equation_compiles():
    assert pdf_from_latex(render(PAPER, None, "latex")).startswith(b"%PDF")


@needs_pdflatex
def test_latex_that_does_not_compile_is_one_line():
    with pytest.raises(BoresightError, match=r"pdflatex failed: ! Undefined control sequence"):
        pdf_from_latex("\\documentclass{article}\\begin{document}\\nothing\\end{document}")


def test_without_pdflatex_one_line_says_what_to_install(monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(BoresightError, match="pdflatex is not installed: install"):
        pdf_from_latex("")


@pytest.mark.parametrize(
    "arguments, message",
    [
        (("29",), "song-lee-2001 has no equation '29'; it has 1, 2, "),
        (("9", "docx"), "the formats are text, latex, html and pdf"),
    ],
)
def test_a_wrong_number_or_format_lists_the_right_ones(arguments, message):
    with pytest.raises(BoresightError, match=re.escape(message)):
        render(PAPER, *arguments)


@pytest.mark.parametrize(
    "name, latex",
    [
        ("C_b2n'", "C_{b}^{n'}"),
        ("δφ̂_b", r"\delta \hat{\phi}_{b}"),
        ("[ω_ib_b x]", r"[\omega_{ib}^{b}\times]"),
        ("Ċ_b2n", r"\dot{C}_{b}^{n}"),
    ],
)
def test_latex_of_a_name(name, latex):
    assert latex_name(name) == latex
