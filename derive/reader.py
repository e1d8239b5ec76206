"""From the LaTeX of a printed equation to relations, symbol by symbol: nobody types a printed form a second time.

It knows fractions, roots, sines, cosines, tangents, bmatrix, vectors in brackets, sums and products; every letter must
stand in the paper's table of quantities.  What it does not know it refuses by name.
"""

import re
from collections.abc import Iterable

from sympy import Function, Integer, cos, sin, sqrt, tan

from boresight import BoresightError
from boresight.derive.equation import Quantity, Relation, column, matrix, negative, product, total

FUNCTIONS = {r"\sin": sin, r"\cos": cos, r"\tan": tan}


def read(displays: Iterable[str], quantities: Iterable[Quantity]) -> tuple[Relation, ...]:
    """The relations of an equation's displays; a display that begins with an operator continues the one before.

    Raises BoresightError at the first piece of LaTeX that is neither structure nor a quantity of the table.
    """
    joined: list[str] = []
    for display in displays:
        text = _plain(display)
        if joined and text[0] in "=+-":
            joined[-1] += text
        else:
            joined.append(text)
    # A letter with arguments is a letter of its own: \\hat{C}_b^n(...) beside \\hat{C}_b^n.
    table = {
        _plain(quantity.latex) + mark: quantity
        for quantity in quantities
        for mark in (("(", "[") if quantity.function else ("",))
    }
    return tuple(_Reader(text, table).relation() for text in joined)


def _plain(latex: str) -> str:
    """LaTeX without what only sets it: spaces, alignment, the two shapes of epsilon."""
    vector = re.search(r"\[([^\[\]]*\\ [^\[\]]*)\]\^T", latex)
    if vector:  # [a \ b \ c]^T: the spaces separate
        latex = latex.replace(vector.group(0), "[" + vector.group(1).replace(r"\ ", ";") + "]")
    latex = re.sub(r"\\begin\{aligned\}|\\end\{aligned\}", "", latex)
    latex = re.sub(r"\\\\\s*&\s*\\equiv|&\s*\\equiv|\\equiv", "=", latex)
    latex = latex.replace(r"\varepsilon", r"\epsilon")
    return re.sub(r"\s+", "", latex).rstrip(",")


class _Reader:
    """Recursive descent over one display; `at` is the position reached."""

    def __init__(self, text: str, table: dict[str, Quantity]):
        self.text, self.table, self.at = text, table, 0
        # The longest letter first: \hat{\phi}_b before \hat{\phi}.
        self.letters = sorted(table, key=len, reverse=True)

    def ahead(self, *tokens: str) -> bool:
        return self.text.startswith(tokens, self.at)

    def take(self, token: str) -> bool:
        found = self.text.startswith(token, self.at)
        self.at += len(token) if found else 0
        return found

    def need(self, token: str) -> None:
        if not self.take(token):
            self.refuse()

    def refuse(self) -> None:
        raise BoresightError(
            f"cannot read {self.text[self.at : self.at + 40]!r} in {self.text[:60]!r}: add it to the table"
        )

    def relation(self) -> Relation:
        sides = [self.sum()]
        while self.take("="):
            sides.append(self.sum())
        if self.at < len(self.text):
            self.refuse()
        return Relation(tuple(sides))

    def sum(self):
        terms = [negative(self.product()) if self.take("-") else self.product()]
        while self.ahead("+", "-"):
            if self.take("+"):
                terms.append(self.product())
            else:
                self.need("-")
                terms.append(negative(self.product()))
        return total(*terms)

    def product(self):
        factors = [self.factor()]
        while self.at < len(self.text) and not self.ahead("=", "+", "-", "&", r"\\", r"\end", ")", "]", "}", ",", ";"):
            if self.take("/"):
                factors[-1] = factors[-1] / self.factor()
            else:
                factors.append(self.factor())
        return product(*factors)

    def factor(self):
        for name in self.letters:
            if self.take(name):
                if self.table[name].function:
                    self.at -= 1
                    return self.call(self.table[name])
                return self.power(self.table[name].symbol)
        for name, function in FUNCTIONS.items():
            if self.take(name):
                return function(self.factor())
        if self.take(r"\frac"):
            return self.group("{", "}") / self.group("{", "}")
        if self.take(r"\sqrt"):
            return sqrt(self.group("{", "}"))
        if self.take(r"\begin{bmatrix}"):
            return self.bmatrix()
        if self.ahead("("):
            return self.group("(", ")")
        if self.ahead("["):
            return column(*self.list("[", "]", ";"))
        number = re.compile(r"\d+").match(self.text, self.at)
        if number:
            self.at = number.end()
            return Integer(number.group())
        return self.refuse()

    def power(self, base):
        return base ** self.factor() if self.take("^") else base

    def group(self, left: str, right: str):
        self.need(left)
        inside = self.sum()
        self.need(right)
        return inside

    def list(self, left: str, right: str, separator: str) -> list:
        self.need(left)
        items = [self.sum()]
        while self.take(separator):
            items.append(self.sum())
        self.need(right)
        return items

    def bmatrix(self):
        rows = [[self.sum()]]
        while not self.take(r"\end{bmatrix}"):
            if self.take("&"):
                rows[-1].append(self.sum())
            else:
                self.need(r"\\")
                rows.append([self.sum()])
        return matrix(rows)

    def call(self, quantity: Quantity):
        """C(a, b, c), or dC[(a, b, c), (d, e, f)] with its arguments in one row."""
        if self.take("["):
            arguments = self.list("(", ")", ",")
            self.need(",")
            arguments += self.list("(", ")", ",")
            self.need("]")
        else:
            arguments = self.list("(", ")", ",")
        return Function(quantity.symbol.name, commutative=False)(*arguments)
