"""MathML of relations."""

import re
from collections.abc import Collection, Iterable

from sympy import S, Symbol
from sympy.printing.mathml import MathMLPresentationPrinter
from sympy.printing.precedence import PRECEDENCE

from boresight.derive.ledger.equation import Quantity, Relation, holds_matrix, terms


class _MathML(MathMLPresentationPrinter):
    def __init__(self) -> None:
        super().__init__({"order": "none", "mat_delim": "["})

    def _print_Symbol(self, sym, style="plain"):
        return super()._print_Symbol(Symbol(re.sub(r"_(\w'?)2(\w'?)$", r"_\1^\2", sym.name)), style)

    def _print_Mul(self, expr):
        if not holds_matrix(expr):
            return super()._print_Mul(expr)
        row = self.dom.createElement("mrow")
        for factor in expr.args:
            if factor == S.NegativeOne:
                operator = self.dom.createElement("mo")
                operator.appendChild(self.dom.createTextNode("-"))
                row.appendChild(operator)
            else:
                row.appendChild(self.parenthesize(factor, PRECEDENCE["Mul"]))
        return row

    def _print_StrictLessThan(self, expr):
        row = self.dom.createElement("mrow")
        operator = self.dom.createElement("mo")
        operator.appendChild(self.dom.createTextNode("&lt;"))  # SymPy writes text as it is
        for part in (self._print(expr.lhs), operator, self._print(expr.rhs)):
            row.appendChild(part)
        return row

    def _print_MatrixBase(self, m):
        return self._print(m[0]) if m.shape == (1, 1) else super()._print_MatrixBase(m)

    _print_ImmutableDenseMatrix = _print_MatrixBase


def mathml_relation(relation: Relation, quantities: Iterable[Quantity] = (), marks: Collection = ()) -> str:
    """One <math> element."""
    printer = _MathML()
    row = ""
    for sign, term in terms(relation):
        if sign:
            row += f"<mo>{'&#8722;' if sign == '-' else sign}</mo>"
        row += printer._print(term).toxml()
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow>{row}</mrow></math>'
