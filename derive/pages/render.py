"""Derivations for people: the terminal, LaTeX, HTML, made from the equations and the ledger."""

from collections.abc import Iterable
from dataclasses import replace
from types import MappingProxyType

from boresight import BoresightError
from boresight.derive.ledger.equation import Equation
from boresight.derive.ledger.paper import Paper
from boresight.derive.pages.blocks import Page
from boresight.derive.pages.page import Functions, equations_page, paper_page

FORMATS = ("text", "latex", "html")
NONE: Functions = MappingProxyType({})


def render(paper: Paper, number: str | None = None, format: str = "text", functions: Functions = NONE) -> str:
    """One equation of a paper, or all of them, as text, as a LaTeX document or as an HTML page.

    functions: the C functions that an equation is flown in.  Raises BoresightError on a number or a format that does
    not exist.
    """
    if number is None:
        return write(paper_page(paper, functions), format)
    page = equations_page(paper.name, [(paper, paper.equation(number))], functions)
    return write(replace(page, title=paper.reference), format)


def render_equations(
    title: str, chosen: Iterable[tuple[Paper, Equation]], format: str, functions: Functions = NONE
) -> str:
    """Equations of one or more papers, in one of FORMATS."""
    return write(equations_page(title, chosen, functions), format)


def write(page: Page, format: str) -> str:
    """The page in one of FORMATS; a format is imported when it is asked for."""
    if format == "text":
        from boresight.derive.pages.plain import text_page as writer
    elif format == "latex":
        from boresight.derive.pages.booklet import latex_page as writer
    elif format == "html":
        from boresight.derive.pages.html import html_page as writer
    else:
        raise BoresightError(f"no format {format!r}: the formats are {', '.join(FORMATS)} and pdf")
    return writer(page)
