"""A paper's maps to the models that make C from it, as tables."""

from sympy import Symbol
from sympy.matrices import MatrixBase

from boresight.derive.ledger.carried import beside, model_of
from boresight.derive.ledger.equation import Relation
from boresight.derive.ledger.map import Map, Row
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.reader import read
from boresight.derive.pages.blocks import Block, Form, Prose, Section, Table


def sections(paper: Paper) -> tuple[Section, ...]:
    """One for each model that makes C from the paper, and one on the equations that no function computes."""
    mapped = tuple(_section(paper, one) for one in paper.maps)
    why = {why: [n for n, same in paper.unflown.items() if same == why] for why in paper.unflown.values()}
    left = tuple(Prose(f"{', '.join(f'({n})' for n in numbers)}: {reason}.") for reason, numbers in why.items())
    return (*mapped, Section("Equations of which no function that flies computes a side", left)) if left else mapped


def _section(paper: Paper, one: Map) -> Section:
    numbers = ", ".join(dict.fromkeys(f"({match.equation})" for match in one.matches))
    kinds = {"state": one.states, "noise": one.noises, "measurement": one.measurements}
    rows = tuple(_row(paper, kind, row) for kind, listed in kinds.items() for row in listed)
    if paper.folder:
        rows += tuple(("input", paper.letter(f"input {name}").meaning, "", name, "") for name in one.inputs)
    if paper.folder:  # one's own may differ
        text = list(beside(paper))
    else:
        text = [f"With these {numbers} are what the model makes: its matrices, residuals and functions."]
    blocks: tuple[Block, ...] = (Table(("", "paper", "times", "ours", "why"), rows, prose=4), *map(Prose, text))
    return Section(f"In C: {model_of(one).name}", blocks)


def _row(paper: Paper, kind: str, row: Row) -> tuple[str | tuple[Form, ...], ...]:
    theirs = row.paper if paper.folder else _form(paper, row.paper)  # of one's own they stand in that order
    return kind, theirs, _form(paper, row.factor), row.ours, row.why


def _form(paper: Paper, latex: str) -> tuple[Form, ...]:
    """An expression, or the letters of a column of them."""
    letters = (*paper.quantities(), *paper.letters())
    (relation,) = read((latex,), letters)
    (side,) = relation.sides
    column = isinstance(side, MatrixBase) and all(isinstance(entry, Symbol) for entry in side)
    return tuple(Form(Relation((entry,)), letters) for entry in (side if column else (side,)))
