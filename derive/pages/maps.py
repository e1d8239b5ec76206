"""A paper's maps as sentences."""

from sympy import Symbol
from sympy.matrices import MatrixBase

from boresight.derive.ledger.map import Map, Row
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.reader import read


def remarks(paper: Paper) -> tuple[str, ...]:
    """One for each model that makes C from the paper, and one on the equations that no function computes."""
    carried = tuple(_remark(paper, one) for one in paper.maps)
    numbers = {why: [n for n, same in paper.unflown.items() if same == why] for why in paper.unflown.values()}
    left = "; ".join(", ".join(f"({n})" for n in listed) + f": {why}" for why, listed in numbers.items())
    return (*carried, f"Equations of which no function that flies computes a side: {left}.") if left else carried


def _remark(paper: Paper, one: Map) -> str:
    rows = "; ".join(_row(paper, row) for row in (*one.states, *one.noises, *one.measurements))
    numbers = ", ".join(dict.fromkeys(f"({match.equation})" for match in one.matches))
    return f"The C of {one.model().name} has {rows}; with these {numbers} are the model's own matrices and residuals."


def _row(paper: Paper, row: Row) -> str:
    factor = {"1": "", "-1": "-"}.get(row.factor) if row.factor in ("1", "-1") else f"{_text(paper, row.factor)} "
    return f"{_text(paper, row.paper)} = {factor}{row.ours}" + (f" ({row.why})" if row.why else "")


def _text(paper: Paper, latex: str) -> str:
    (relation,) = read((latex,), (*paper.quantities(), *paper.letters()))
    side = relation.sides[0]
    if isinstance(side, MatrixBase) and all(isinstance(entry, Symbol) for entry in side):
        return ", ".join(entry.name for entry in side)
    return " ".join(str(side).split())
