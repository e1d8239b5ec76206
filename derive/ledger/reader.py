"""From the LaTeX of a printed equation to relations, symbol by symbol: nobody types a printed form a second time.

It knows fractions, roots, elementary functions and their inverses, matrices (of blocks too, and diag), vectors in
brackets, transposes, inverses, conjugates, norms, cross-product matrices, products of quaternions, sums over a set of
samples, an entry (i,j) of a product, sums and products; every letter must stand in the paper's table of quantities.
What it does not know it refuses by name, and what can be read in two ways it asks for.  In derivations it also knows
\\vee(A), \\mathrm{E}[A], and \\flown{name}: the matrix of a function that flies.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cache
from types import MappingProxyType

from sympy import (
    Function,
    Integer,
    Mul,
    Rational,
    S,
    StrictLessThan,
    Symbol,
    acos,
    asin,
    atan,
    atan2,
    cos,
    cosh,
    exp,
    log,
    sin,
    sinh,
    sqrt,
    tan,
    tanh,
)
from sympy.functions.elementary.complexes import transpose
from sympy.matrices.exceptions import ShapeError

from boresight import BoresightError
from boresight.derive.ledger.equation import (
    Quantity,
    Relation,
    as_written,
    column,
    is_explicit,
    matrix,
    negative,
    product,
    total,
)

FUNCTIONS = {
    r"\sinh": sinh,
    r"\cosh": cosh,
    r"\tanh": tanh,
    r"\arcsin": asin,
    r"\arccos": acos,
    r"\arctan": atan,
    r"\sin": sin,
    r"\cos": cos,
    r"\tan": tan,
    r"\sec": lambda x: 1 / cos(x),
    r"\csc": lambda x: 1 / sin(x),
    r"\cot": lambda x: 1 / tan(x),
    r"\ln": log,
}
INVERSE = {sin: asin, cos: acos, tan: atan}
SKEW, CROSS = Function("skew", commutative=False), Function("cross", commutative=False)
OPERATORS = {
    r"\exp": Function("exp", commutative=False),
    r"\vee": Function("vee", commutative=False),
    r"\mathrm{E}": Function("E", commutative=False),
}
NORM, CONJUGATE = Function("norm"), Function("conj", commutative=False)
PRODUCTS = (r"\otimes", r"\odot", r"\circ")  # of quaternions
SUM_LATEX, SUM, SUM_OVER = r"\sum_{k\in\Omega_n}", Function("Σ"), "Ω_n"
ENTRY = re.compile(r"\((\d),(\d)\)")
NUMBER = re.compile(r"\d+(?:\.\d+)?")
BLOCK = re.compile(
    r"(?P<what>\\mathbf\{[0I]\}|\\mathbf[0I]|\\boldsymbol\{[0I]\}|[0I])"
    r"_(?:\{(?P<rows>\d+)(?:\\times(?P<columns>\d+))?\}|(?P<size>\d))"
)
ENDS = (
    "=",
    "<",
    "+",
    "-",
    "&",
    r"\\",
    r"\end",
    ")",
    "]",
    "}",
    r"\}",
    r"\|",
    r"\leq",
    r"\times]",
    r"\times)",
    ",",
    ";",
)  # of a product

# What only sets a formula, and the one spelling that is read in the place of others.
SETTING = (
    (r"\\left(?![a-z])|\\right(?![a-z])|\\therefore|\\(?:big|Big|bigg|Bigg)[lrm]?(?![a-zA-Z])|\\[,;:!]|~", ""),
    (r"(?<=\))_\{\d \\times \d\}", ""),
    (r"\\(?:triangleq|coloneqq|doteq|approx|simeq|equiv)(?![a-z])|:=|\\overset\{[^{}]*\}\{=\}", "="),
    (r"\\(?:top|intercal)(?![a-z])|\\(?:mathrm|mathsf|text|mathit)\s*(?:\{\s*T\s*\}|T(?![a-z]))", "T"),
    (r"\^\s*\{\s*T\s*\}", "^T"),
    (r"\\[td]frac(?![a-z])", r"\\frac"),
    (r"\\(begin|end)\{(?:pmatrix|matrix|smallmatrix)\}", r"\\\1{bmatrix}"),
    (r"\\begin\{array\}\s*\{[lcr|@{}\s]*?\}", r"\\begin{bmatrix}"),
    (r"\\end\{array\}", r"\\end{bmatrix}"),
    (r"\\[lr]floor(?![a-z])", lambda found: "[" if found[0] == r"\lfloor" else "]"),
    (r"\\(?:lVert|rVert|Vert)(?![a-z])", r"\\|"),
    (r"\\(?:lvert|rvert|vert)(?![a-z])", "|"),
    (r"\\(?:operatorname|mathrm|text)\s*\{(diag|atan2|atan|asin|acos|exp|ln)\}", r"\\\1"),
    (r"\\varepsilon", r"\\epsilon"),
)


def read(
    displays: Iterable[str], quantities: Iterable[Quantity], flown: Mapping[str, object] = MappingProxyType({})
) -> tuple[Relation, ...]:
    """The relations of an equation's displays; a display that begins with an operator continues the one before.

    A side that must be less than something, a = b < c, is read as b < c.  flown: what \\flown{name} stands for.
    Raises BoresightError at the first piece of LaTeX that is neither structure nor a quantity of the table.
    """
    joined: list[str] = []
    for text in (plain(row) for display in displays for row in _rows(display)):
        if joined and text[0] in "=+-":
            joined[-1] += text
        else:
            joined.append(text)
    # A letter with arguments is a letter of its own: \\hat{C}_b^n(...) beside \\hat{C}_b^n.
    table = {
        plain(quantity.latex) + mark: quantity
        for quantity in quantities
        for mark in (("(", "[") if quantity.function else ("",))
    }
    return tuple(_Reader(text, table, flown).relation() for text in joined)


UPPER = r"\^(\w|\{\w+\})$"


@cache
def turned_over(name: str) -> str:
    """C_b^{nT}: how the transpose of C_b^n is printed too."""
    return re.sub(UPPER, lambda found: f"^{{{found[1].strip('{}')}T}}", name)


def transposed(entry):
    return transpose(entry, evaluate=False) if not entry.is_commutative else entry


class UnreadError(BoresightError):
    """What is neither structure nor a letter of the table: `text`, as `plain` has it, from `at` on."""

    def __init__(self, text: str, at: int, why: str = ""):
        super().__init__(f"cannot read {text[at : at + 40]!r} in {text[:60]!r}: {why or 'add it to the table'}")
        self.text, self.at, self.why = text, at, why


def _rows(display: str) -> Iterator[str]:
    """The lines of a display: the rows of aligned, and what stands apart by a comma and a wide space."""
    inside = re.fullmatch(r"\s*\\begin\{aligned\}(.*)\\end\{aligned\}\s*", display, re.DOTALL)
    if not inside:
        yield from re.split(r",\s*\\quad", display)
        return
    row, depth = "", 0
    for piece in re.split(r"(\\begin\{bmatrix\}|\\end\{bmatrix\}|\\\\)", inside[1]):
        depth += piece.startswith(r"\begin") - piece.startswith(r"\end")
        if piece == r"\\" and not depth:
            yield row
            row = ""
        else:
            row += piece if depth or piece.startswith(r"\end") else piece.replace("&", "")
    yield row


@cache
def plain(latex: str) -> str:
    """LaTeX without what only sets it: spaces, the sizes of brackets and matrices, the two shapes of epsilon."""
    latex = re.sub(r"(\[[^\[\]]*(?<!\\);[^\[\]]*\])", r"\1^T", latex)  # [a; b; c] as in MATLAB: a column
    latex = re.sub(r"(?<!\\)\\ |\\quad", ";", latex)  # [a \ b \ c]^T: the spaces separate
    for pattern, spelling in SETTING:
        latex = re.sub(pattern, spelling, latex)
    return re.sub(r"\s+", "", latex).replace("&=", "=").rstrip(",")


def _minus(term):
    try:
        return negative(term)
    except ShapeError:
        first, *others = term.args
        return as_written(Mul, (-first, *others) if first.is_Number else (S.NegativeOne, *term.args))


class _Reader:
    """Recursive descent over one display; `at` is the position reached."""

    def __init__(self, text: str, table: dict[str, Quantity], flown: Mapping[str, object]):
        self.text, self.table, self.flown, self.at = text, table, flown, 0
        # The longest letter first: \hat{\phi}_b before \hat{\phi}.
        turned = {turned_over(name): quantity for name, quantity in table.items() if re.search(UPPER, name)}
        self.turned = {name: quantity for name, quantity in turned.items() if name not in table}
        self.letters = sorted((*table, *self.turned), key=len, reverse=True)
        self.shapes = {quantity.symbol: quantity.shape for quantity in table.values()}
        self.layout: dict = {}
        self.bars = 0  # that are open

    def ahead(self, *tokens: str) -> bool:
        return self.text.startswith(tokens, self.at)

    def take(self, token: str) -> bool:
        found = self.text.startswith(token, self.at)
        self.at += len(token) if found else 0
        return found

    def need(self, token: str) -> None:
        if not self.take(token):
            self.refuse()

    def refuse(self, why: str = "") -> None:
        raise UnreadError(self.text, self.at, why)

    def relation(self) -> Relation:
        sides = [self.sum()]
        while self.take("="):
            side = self.sum()
            sides.append(StrictLessThan(side, self.sum(), evaluate=False) if self.take("<") else side)
        if self.at < len(self.text):
            self.refuse()
        return Relation(tuple(sides), self.layout)

    def sum(self):
        terms = [_minus(self.product()) if self.take("-") else self.product()]
        while self.ahead("+", "-"):
            if self.take("+"):
                terms.append(self.product())
            else:
                self.need("-")
                terms.append(_minus(self.product()))
        return total(*terms)

    def product(self):
        factors = [self.factor()]
        while self.at < len(self.text) and not self.ahead(*ENDS) and not (self.bars and self.ahead("|")):
            entry = ENTRY.match(self.text, self.at)
            if self.take("/"):
                factors[-1] = self.divided(factors[-1], self.factor())
            elif self.ahead(r"\cdot") and not self.ahead(r"\cdots"):
                self.take(r"\cdot")
                factors.append(self.factor())
                if all(len(self.shape(one) or ()) == 1 and self.shape(one) != (4,) for one in factors[-2:]):
                    factors[-2] = transpose(factors[-2])
            elif self.ahead(*PRODUCTS):
                start = self.at
                any(map(self.take, PRODUCTS))
                factors.append(self.factor())
                if any(self.shape(one) not in (None, (4,)) for one in factors[-2:]):
                    self.at = start
                    self.refuse("this product is read of two quaternions alone")
            elif self.take(r"\times"):
                factors = [CROSS(product(*factors), self.factor())]
            elif entry:
                self.at = entry.end()
                factors = [Function("entry")(product(*factors), *map(Integer, entry.groups()))]
            else:
                factors.append(self.factor())
        try:
            whole = product(*factors)
        except ShapeError:  # the page has it so: it is read, and has no value
            return as_written(Mul, factors)
        if len(factors) > 1:
            self.keep(whole, [group for factor in factors for group in self.groups(factor)])
        return whole

    def shape(self, factor) -> tuple[int, ...] | None:
        """Of a letter, or of its conjugate or inverse; None of what is none."""
        while not isinstance(factor, Symbol):
            if not (factor.is_Pow or factor.func == CONJUGATE):
                return None
            factor = factor.args[0]
        return self.shapes.get(factor)

    def groups(self, expression) -> tuple:
        return self.layout.get(expression, ((expression,),))

    def keep(self, whole, groups) -> None:
        """Note how the page has a product of scalars."""
        if isinstance(whole, Mul) and whole.is_commutative:
            self.layout[whole] = tuple(groups)

    def divided(self, above, below):
        if not above.is_commutative and not below.is_number:
            return product(above, below**-1)
        whole = above / below
        over, under = (tuple(factor for group in self.groups(part) for factor in group) for part in (above, below))
        self.keep(whole, [(*over, *(factor**-1 for factor in under))])
        return whole

    def factor(self):
        for name in self.letters:
            if self.take(name):
                if name in self.turned:
                    return transpose(self.turned[name].symbol, evaluate=False)
                if self.table[name].function:
                    self.at -= 1
                    return self.power(self.call(self.table[name]))
                return self.power(self.table[name].symbol)
        for name, function in FUNCTIONS.items():
            if self.take(name):
                return self.elementary(function)
        if self.take(r"\atan2"):
            return atan2(*self.list("(", ")", ","))
        for name in ("max", "min"):
            if self.take(f"\\{name}"):
                return Function(name)(*self.list("(", ")", ","))
        if self.take(r"\diag"):
            return self.diagonal()
        if self.take(r"\frac"):
            return self.divided(self.argument(), self.argument())
        if self.take(r"\sqrt"):
            root = self.group("[", "]") if self.ahead("[") else Integer(2)
            return sqrt(self.group("{", "}")) if root == 2 else self.group("{", "}") ** (1 / root)
        if self.take("e^{") or self.take("\\mathrm{e}^{"):
            self.at -= 1
            return self.exponential(self.group("{", "}"))
        if self.take(r"\begin{bmatrix}"):
            return self.power(self.bmatrix())
        if self.take(r"\flown{"):
            name, _, _ = self.text[self.at :].partition("}")
            if name not in self.flown:
                raise BoresightError(f"nothing that flies is called {name!r}: there are {', '.join(self.flown)}")
            self.at += len(name) + 1
            return self.flown[name]
        if self.ahead(r"\exp("):
            self.take(r"\exp")
            return self.exponential(self.group("(", ")"))
        for name, function in OPERATORS.items():
            if self.take(name):
                return function(self.group("[", "]") if self.ahead("[") else self.group("(", ")"))
        if self.take(SUM_LATEX):
            return SUM(self.product())
        if self.ahead(r"\|"):
            return self.power(NORM(self.group(r"\|", r"\|")))
        if self.take("|"):
            self.bars += 1
            inside = self.sum()
            self.need("|")
            self.bars -= 1
            return self.power(NORM(inside))
        if self.take(r"\{"):
            return self.samples()
        if self.take("("):
            inside = self.sum()
            if self.take(r"\times)"):
                return self.power(SKEW(inside))
            self.need(")")
            return self.power(inside)
        if self.ahead("{"):
            return self.power(self.group("{", "}"))
        if self.ahead("["):
            start = self.at
            self.need("[")
            inside = self.sum()
            if self.take(r"\times]"):
                return self.power(SKEW(inside))
            self.at = start
            items = self.list("[", "]", ";")
            if len(items) == 1 and (self.take(r"_\times") or self.take(r"_{\times}")):
                return self.power(SKEW(items[0]))
            return column(*items) if self.take("^T") else items[0] if len(items) == 1 else matrix([items])
        if block := BLOCK.match(self.text, self.at):
            return self.block(block)
        number = NUMBER.match(self.text, self.at)
        if number:
            self.at = number.end()
            return self.power(Rational(number.group())) if self.ahead("^{") else Rational(number.group())
        return self.refuse()

    def elementary(self, function: Callable):
        """What follows a sine and its like: \\sin^2 x, \\tan^{-1} x, \\sin x, \\sin(x)."""
        if self.take("^{-1}"):
            if function not in INVERSE:
                self.refuse("write the inverse function by its name")
            return INVERSE[function](self.factor())
        exponent = self.argument() if self.take("^") else None
        bracket = self.ahead("(")
        start = self.at
        argument = self.group("(", ")") if bracket else self.factor()
        if bracket and self.ahead("^"):
            self.at = start
            self.refuse(r"write \sin^2(x), or \sin((x)^2): this can be either")
        return function(argument) if exponent is None else function(argument) ** exponent

    def exponential(self, inside):
        return exp(inside) if inside.is_commutative and not is_explicit(inside) else OPERATORS[r"\exp"](inside)

    def argument(self):
        """What stands in braces, or one digit, or one letter: \\frac12."""
        if self.ahead("{"):
            return self.group("{", "}")
        if self.text[self.at : self.at + 1].isdigit():
            self.at += 1
            return Integer(self.text[self.at - 1])
        for name in self.letters:
            if self.take(name):
                return self.table[name].symbol
        return self.refuse()

    def diagonal(self):
        """diag(a, b, c): a matrix, or of matrices one of blocks."""
        items = self.list("(", ")", ",") if self.ahead("(") else self.list("[", "]", ",")
        if len(items) == 1:
            self.refuse("write the entries of the diagonal, apart by commas")
        return matrix([[item if i == j else 0 for j in range(len(items))] for i, item in enumerate(items)])

    def block(self, found: re.Match):
        """The letter of a block of zeros, or of an identity, that says its size and is not in the table."""
        self.at = found.end()
        what = "I" if "I" in found["what"] else "0"
        rows = found["rows"] or found["size"]
        return Symbol(f"{what}_{rows}x{found['columns'] or rows}", commutative=False)

    def power(self, base):
        if self.take("^T"):
            if is_explicit(base):
                return matrix([[transposed(base[i, j]) for i in range(base.rows)] for j in range(base.cols)])
            return transpose(base, evaluate=False)  # of a sum it stays the transpose of the sum
        if self.take("^{-1}"):
            return base**-1
        if self.take(r"^\wedge") or self.take(r"^{\wedge}"):
            return SKEW(base)
        if self.take("^*") or self.take("^{*}"):
            return CONJUGATE(base)
        if not self.take("^"):
            return base
        exponent = self.group("{", "}") if self.ahead("{") else self.factor()
        if not exponent.is_number and not base.is_commutative:
            self.refuse("no letter of the table has this above it, and it is no power")
        return base**exponent

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
        rows = [[self.cell()]]
        while not self.take(r"\end{bmatrix}"):
            if self.take("&"):
                rows[-1].append(self.cell())
            else:
                self.need(r"\\")
                rows.append([self.cell()])
        if len({len(row) for row in rows}) > 1:
            self.refuse("the rows of the matrix before it are not equally long")
        if any(is_explicit(entry) for row in rows for entry in row):
            self.refuse("a matrix stands within the matrix before it: give it a letter, which another equation defines")
        return matrix(rows)

    def cell(self):
        """One entry, or a row of scalars apart by spaces as a block."""
        entries = [self.sum()]
        while self.take(";"):
            entries.append(self.sum())
        return entries[0] if len(entries) == 1 else Function("row")(*entries)

    def samples(self):
        """{a <= k <= b}, after its bracket."""
        bounds = [self.sum()]
        while self.take(r"\leq"):
            bounds.append(self.sum())
        self.need(r"\}")
        return Function("samples")(*bounds)

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
