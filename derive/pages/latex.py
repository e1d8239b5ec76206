"""LaTeX of relations and of the names of quantities."""

import re
from collections.abc import Iterable
from unicodedata import name as name_of
from unicodedata import normalize

from sympy import S
from sympy.core.function import AppliedUndef
from sympy.printing.latex import LatexPrinter
from sympy.printing.precedence import PRECEDENCE

from boresight.derive.ledger.equation import Quantity, Relation, holds_matrix, terms


def latex_relations(relations: Iterable[Relation], quantities: Iterable[Quantity]) -> str:
    """LaTeX of relations, with the paper's letters."""
    quantities = tuple(quantities)
    return r" \\ ".join(latex_relation(relation, quantities) for relation in relations)


def latex_relation(relation: Relation, quantities: Iterable[Quantity]) -> str:
    letters = {quantity.symbol.name + ("(" if quantity.function else ""): quantity.latex for quantity in quantities}
    printer = _Latex(letters)
    text = ""
    for sign, term in terms(relation):
        text += f" {sign} {printer.doprint(term)}" if sign else printer.doprint(term)
    return text


class _Latex(LatexPrinter):
    def __init__(self, letters: dict[str, str]):
        super().__init__({"order": "none", "mat_str": "bmatrix", "mat_delim": "", "fold_func_brackets": True})
        self.letters = letters

    def _print_Symbol(self, expr, style="plain"):
        return self.letters.get(expr.name) or latex_name(expr.name)

    def _print_Function(self, expr, exp=None):
        if not isinstance(expr, AppliedUndef):
            return super()._print_Function(expr, exp)
        return self._print_call(expr)

    def _print_transpose(self, expr, exp=None):
        return rf"{{{self.parenthesize(expr.args[0], PRECEDENCE['Pow'])}}}^{{T}}"

    def _print_call(self, expr):
        name = expr.func.__name__
        arguments = ", ".join(self._print(argument) for argument in expr.args)
        head = r"\exp" if name == "exp" else self.letters.get(name + "(") or latex_name(name)
        return rf"{head}\left({arguments}\right)"

    def _print_Mul(self, expr):
        if not holds_matrix(expr):
            return super()._print_Mul(expr)
        # As written: SymPy would multiply the explicit matrices.
        signs = "-" * (expr.args[0] == S.NegativeOne)
        return signs + " ".join(self.parenthesize(f, PRECEDENCE["Mul"]) for f in expr.args[len(signs) :])

    def _print_MatrixBase(self, expr):
        return self._print(expr[0]) if expr.shape == (1, 1) else super()._print_MatrixBase(expr)

    _print_ImmutableDenseMatrix = _print_MatrixBase


SIGNS = {"→": r"\to", "∂": r"\partial"}
MARKS = {"\u0302": "hat", "\u0307": "dot", "\u0304": "bar", "\u030c": "check"}


def latex_name(name: str) -> str:
    """LaTeX of a symbol's name: Greek letters, hats and dots, scripts, C_b2n, [v x]."""
    transformation = re.fullmatch(r"(.*?)_(\w'?)2(\w'?)", name)
    if transformation:
        letter, source, target = transformation.groups()
        return f"{latex_name(letter)}_{{{source}}}^{{{target}}}"
    turning = re.fullmatch(r"\[(.*) x\]", name)
    if turning:
        return rf"[{latex_name(turning[1])}\times]"
    text, _, scripts = name.partition("_")
    result = ""
    for character in normalize("NFD", text):
        if character in MARKS:
            letter = re.search(r"(\\[A-Za-z]+ |.)$", result)
            assert letter is not None
            result = result[: letter.start()] + rf"\{MARKS[character]}{{{letter.group().strip()}}}"
        else:
            result += _character(character)
    below, _, above = scripts.partition("_")
    return result.strip() + (f"_{{{below}}}" if below else "") + (f"^{{{above}}}" if above else "")


def _character(character: str) -> str:
    """LaTeX of one letter or sign, in a formula."""
    greek = re.fullmatch(r"GREEK (SMALL|CAPITAL) LETTER (FINAL )?(\w+)", name_of(character, ""))
    if greek:
        word = greek[3].lower().replace("lamda", "lambda")
        return "\\" + (word.capitalize() if greek[1] == "CAPITAL" else word) + " "
    return SIGNS[character] + " " if character in SIGNS else character
