"""What a notebook shows of a model, an equation or a derivation; `boresight.notebook` registers it with IPython."""

from functools import singledispatch
from typing import Any

from boresight.derive.ledger.equation import Derivation, Equation
from boresight.derive.linear import completed
from boresight.derive.model import Model
from boresight.derive.pages.blocks import Page, Section
from boresight.derive.pages.booklet import latex_cell
from boresight.derive.pages.html import html_cell
from boresight.derive.pages.model import formulas, model_page
from boresight.derive.pages.page import equations_page, steps
from boresight.derive.papers import paper


@singledispatch
def page(value: Any) -> Page:
    """Its page, as `boresight show` has it.  Raises TypeError on a value of another kind."""
    raise TypeError(f"a notebook shows no page of {type(value).__name__}")


@page.register
def _(model: Model) -> Page:
    return model_page(completed(model))


@page.register
def _(equation: Equation) -> Page:
    return equations_page(equation.paper, [(paper(equation.paper), equation)], {})


@page.register
def _(derivation: Derivation) -> Page:
    return Page("", (Section("", steps(derivation, ())),))


def html(value: Any) -> str:
    """The sections of its page."""
    return html_cell(page(value))


@singledispatch
def latex(value: Any) -> str:
    """Of a model its F block by block, of an equation what is derived, of a derivation its lines: for a notebook that
    shows no HTML.  Raises TypeError on a value of another kind."""
    raise TypeError(f"a notebook shows no formulas of {type(value).__name__}")


@latex.register
def _(model: Model) -> str:
    shown = formulas(completed(model))
    return latex_cell([form.relation for form in shown], shown[0].quantities)


@latex.register
def _(equation: Equation) -> str:
    return latex_cell(equation.derived, equation.page_letters)


@latex.register
def _(derivation: Derivation) -> str:
    return latex_cell([relation for step in derivation.steps for relation in step.formulas], ())
