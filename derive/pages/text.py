"""Relations as text for the terminal."""

import shutil
from collections.abc import Collection, Iterable

from sympy.printing.pretty.pretty import PrettyPrinter
from sympy.printing.pretty.stringpict import prettyForm, stringPict

from boresight.derive.ledger.equation import Quantity, Relation, terms


def columns() -> int:
    """Columns of the terminal, or of COLUMNS, 100 at most; 80 in a pipe."""
    return min(100, shutil.get_terminal_size((80, 24)).columns)


class _Pretty(PrettyPrinter):
    def _print_MatrixBase(self, expr):
        # The 1x1 product of a row and a column is added to scalars: no brackets round those.
        return self._print(expr[0]) if expr.shape == (1, 1) else super()._print_MatrixBase(expr)

    _print_ImmutableDenseMatrix = _print_MatrixBase

    def _print_Symbol(self, expr, bold_name=False):
        return prettyForm(expr.name)  # names are as a reader wants them: C_b2n, not C with scripts that no font has

    def _print_AppliedUndef(self, expr):
        return prettyForm(f"{expr.func.__name__}({', '.join(str(argument) for argument in expr.args)})")

    _print_Function = _print_AppliedUndef


def text_relation(
    relation: Relation, quantities: Iterable[Quantity] = (), width: int | None = None, marks: Collection = ()
) -> str:
    """The chain, broken before a term where a line would be too long."""
    width = columns() if width is None else width
    printer = _Pretty({"order": "none", "use_unicode": True, "wrap_line": False})
    lines: list[stringPict] = []
    line: stringPict | None = None
    for sign, term in terms(relation):
        piece = printer._print(term)
        piece = piece if not sign else prettyForm(*stringPict.next(prettyForm(f" {sign} "), piece))
        joined = piece if line is None else prettyForm(*stringPict.next(line, piece))
        if line is not None and joined.width() > width:
            lines.append(line)
            joined = piece
        line = joined
    lines += [] if line is None else [line]
    rows = [row.rstrip() for block in lines for row in block.render(wrap_line=False).splitlines()]
    return "\n".join(rows)
