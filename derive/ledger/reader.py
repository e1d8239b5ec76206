"""From the LaTeX of a printed equation to relations, symbol by symbol: nobody types a printed form a second time.

It knows fractions, roots, elementary functions and their inverses, matrices (of blocks too, and diag), vectors in
brackets, transposes, inverses, conjugates, norms, cross-product matrices, products of quaternions, sums over a set of
samples, an entry (i,j) of a product, sums and products; every letter must stand in the paper's table of quantities.
What it does not know it refuses by name, and what can be read in two ways it asks for.  In derivations it also knows
\\vee(A), \\mathrm{E}[A], and \\flown{name}: the matrix of a function that flies.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cache, cached_property
from types import MappingProxyType

from sympy import (
    Add,
    Dummy,
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
    replaced,
    total,
)
from boresight.derive.ledger.rates import RATE, rate_of
from boresight.derive.ledger.tokens import COMMAND, TOKEN, joined, tokens

LARGEST_POWER = 100
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
IDENTITY = re.compile(r"\\(?:mathbf|boldsymbol|mathbb|mathrm)\{I\}|I(?![A-Za-z_])")
IDENTITY_OF_ITS_PLACE = Dummy("I", commutative=False)  # until its size is known
D = r"(?P<d>d|\\mathrm\{d\}|\{\\rm d\})"
BY_TIME = re.compile(rf"\\frac\{{{D}\}}\{{(?P=d)t\}}")
OVER_TIME = re.compile(rf"\\frac\{{{D}(?=[(\[])")  # \frac{d(C v)}{dt}
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
    r"\times\}",
    ",",
    ";",
)  # of a product

BREAK = r"\\\\(?:\*|\s*\[\s*-?[\d.]+\s*\\?[a-z]+\s*\])?"  # of a row
# What only sets a formula, and the one spelling that is read in the place of others.
SETTING = (
    (r"\\(?:left|right)\s*\.", ""),
    (BREAK, r"\\\\"),
    (r"\\left(?![a-z])|\\right(?![a-z])|\\therefore|\\(?:big|Big|bigg|Bigg)[lrm]?(?![a-zA-Z])|\\[,;:!]|~", ""),
    (r"(?<=\))_\{\d \\times \d\}", ""),
    (r"\\ast(?![a-z])", "*"),
    (r"\\boxed(?![a-z])", ""),
    (r"\\mathbb\s*(?:\{\s*I\s*\}|I(?![a-z]))", r"\\mathbf{I}"),
    (r"\\(?:triangleq|coloneqq|doteq|approx|simeq|cong|equiv)(?![a-z])|:=|\\overset\{[^{}]*\}\{=\}", "="),
    (r"\\(?:top|intercal)(?![a-z])|\\(?:mathrm|mathsf|text|mathit)\s*(?:\{\s*T\s*\}|T(?![a-z]))", "T"),
    (r"\^\s*\{\s*T\s*\}", "^T"),
    (r"\\[td]frac(?![a-z])", r"\\frac"),
    (r"\\(begin|end)\{(?:pmatrix|matrix|smallmatrix)\}", r"\\\1{bmatrix}"),
    (r"\\begin\{array\}\s*\{[lcr|@{}\s]*?\}", r"\\begin{bmatrix}"),
    (r"\\end\{array\}", r"\\end{bmatrix}"),
    (r"\\[lr]floor(?![a-z])", lambda found: "[" if found[0] == r"\lfloor" else "]"),
    (r"\\(?:lVert|rVert|Vert)(?![a-z])", r"\\|"),
    (r"\\lbrace(?![a-z])", r"\\{"),
    (r"\\rbrace(?![a-z])", r"\\}"),
    (r"\\[lr]brack(?![a-z])", lambda found: "[" if found[0] == r"\lbrack" else "]"),
    (r"\\(?:bm|pmb)(?![a-z])", r"\\boldsymbol"),
    (r"\\(?:lvert|rvert|vert)(?![a-z])", "|"),
    (r"\\(?:operatorname|mathrm|text)\s*\{(diag|atan2|atan|asin|acos|exp|ln)\}", r"\\\1"),
    (r"\\varepsilon", r"\\epsilon"),
)
FONTS = (
    "mathbf|boldsymbol|mathbb|mathcal|mathsf|mathrm|mathit|vec|hat|widehat|tilde|widetilde|bar|dot|ddot|check|overline"
)
# One spelling of what LaTeX sets alike: \mathbf v, v_{N}, C^n_b, {a \over b}.
ALIKE = (
    (rf"\\({FONTS})(?![a-zA-Z])\s*(\\(?!(?:{FONTS})(?![a-zA-Z]))[a-zA-Z]+|[a-zA-Z0-9])", r"\\\1{\2}"),
    (r"([_^])\s*\{\s*(\\[a-zA-Z]+|[^\\{}\s])\s*\}", r"\1\2"),
    (r"\^\s*([a-zA-Z0-9]|\\[a-zA-Z]+|[*+-]|\{[^{}]*\})\s*_\s*([a-zA-Z0-9]|\\[a-zA-Z]+|\{[^{}]*\})", r"_\2^\1"),
    (r"\{([^{}]*?)\\over(?![a-z])([^{}]*)\}", r"{\\frac{\1}{\2}}"),
)


def read(
    displays: Iterable[str], quantities: Iterable[Quantity], flown: Mapping[str, object] = MappingProxyType({})
) -> tuple[Relation, ...]:
    """The relations of an equation's displays; a display that begins with an operator continues the one before.

    A side that must be less than something, a = b < c, is read as b < c.  flown: what \\flown{name} stands for.
    Raises BoresightError at the first piece of LaTeX that is neither structure nor a quantity of the table.
    """
    displays = tuple(displays)
    rows: list[str] = []
    for text in (plain(row).lstrip(";") for display in displays for row in _rows(display)):
        if rows and text.startswith(("=", "+", "-", r"\times", r"\cdot")):
            rows[-1] += text
        else:
            rows.append(text)
    alphabet = _alphabet(tuple(quantities))
    try:
        return tuple(_Reader(text, alphabet, flown).relation() for text in rows)
    except UnreadError as error:
        error.displays = displays
        raise


class Alphabet:
    """The letters of a table by their LaTeX, as `plain` has it.

    A letter with arguments is one of its own: \\hat{C}_b^n(...) beside \\hat{C}_b^n.
    """

    def __init__(self, quantities: tuple[Quantity, ...]):
        self.quantities = quantities
        marks = {True: ("(", "["), False: ("",)}
        self.table = {plain(one.latex) + mark: one for one in quantities for mark in marks[one.function]}
        turned = {turned_over(name): one for name, one in self.table.items() if UPPER.search(name)}
        self.turned = {name: one for name, one in turned.items() if name not in self.table}
        self.shapes = {one.symbol: one.shape for one in self.table.values()}
        self.names: dict[
            str, list[str]
        ] = {}  # by their first token, the longest first: \\hat{\\phi}_b before \\hat{\\phi}
        for name in sorted((*self.table, *self.turned), key=len, reverse=True):
            self.names.setdefault(first_token(name, 0), []).append(name)


_ALPHABETS: dict[tuple[int, ...], Alphabet] = {}  # by which objects the letters are: one table reads many lines


def _alphabet(quantities: tuple[Quantity, ...]) -> Alphabet:
    key = tuple(map(id, quantities))
    if key not in _ALPHABETS:
        _ALPHABETS[key] = Alphabet(quantities)
    return _ALPHABETS[key]


def first_token(text: str, at: int) -> str:
    found = TOKEN.match(text, at)
    return found[0] if found else ""


@cache
def ends_in_command(latex: str) -> bool:
    return COMMAND.fullmatch(tokens(latex)[-1]) is not None


UPPER = re.compile(r"\^(\w|\{\w+\})$")


@cache
def turned_over(name: str) -> str:
    """C_b^{nT}: how the transpose of C_b^n is printed too."""
    return UPPER.sub(lambda found: f"^{{{found[1].strip('{}')}T}}", name)


def transposed(entry):
    return transpose(entry, evaluate=False) if not entry.is_commutative else entry


def turned(base):
    """Its transpose; of a sum it stays the transpose of the sum."""
    if is_explicit(base):
        return matrix([[transposed(base[i, j]) for i in range(base.rows)] for j in range(base.cols)])
    return transpose(base, evaluate=False)


def untransposed(entry):
    """Of a column that is printed as [a^T b^T]^T."""
    return entry.args[0] if isinstance(entry, transpose) else entry


HINTS = (
    (r"\\i*nt(?![a-z])|\\sum|\\prod", "no integral and no sum is read: give it a letter with a value"),
    (r"\\partial|\\nabla", "no derivative is read but a rate: give it a letter with a value"),
    (
        r"(?:\\frac\{)?(?:\\mathrm\{)?d[^/={}]*\}?[^/={}]*(?:/|\}\{)(?:\\mathrm\{)?d",
        r"a rate is read of one letter that has a value, or of brackets: \dot{x}, \frac{dx}{dt}, \frac{d}{dt}(C x)",
    ),
    (r"\\begin\{cases\}", "write an equation for each case"),
    (r"\\begin\{[a-z]*\}", "of environments within an equation are read: aligned, split, bmatrix, pmatrix and array"),
    (r"\\[pm][pm](?![a-z])", "write an equation for each sign"),
    (r"\\[lg]eq?(?![a-z])|[<>]", "what is no equation is not judged: leave it out, or write it as \\text{for } ..."),
    (r"\\wedge", r"write \times for a cross product"),
    (r"\\[cl]?dots", "of a sum that goes on only the end may be left out, as + \\cdots"),
    (",", "write an equation for each, apart by a comma and \\quad"),
)


class UnreadError(BoresightError):
    """What is neither structure nor a letter of the table: `text`, as `plain` has it, from `at` on.

    displays: in one of which it stands, as they are typed.
    """

    def __init__(self, text: str, at: int, why: str = ""):
        self.text, self.at, self.why = text, at, why
        self.displays: tuple[str, ...] = ()

    @cached_property
    def found(self) -> tuple[int, str]:
        """Where it stands in a display, and that display; looked for when somebody asks."""
        places = ((place_of(display, self), display) for display in self.displays)
        return next(((place, display) for place, display in places if place is not None), (self.at, self.text))

    @property
    def place(self) -> int:
        return self.found[0]

    @property
    def typed(self) -> str:
        """What stands there."""
        place, display = self.found
        return display[place:]

    def __str__(self) -> str:
        whole, why = f"'{short(self.found[1], 60)}'", self.why or self.hint or "add it to the table"
        what = f"'{short(self.typed)}' in {whole}: {why}" if self.text[self.at :] else f"{whole}: it ends too early"
        return f"cannot read {what}"

    @property
    def hint(self) -> str:
        """What to write in the place of what is not read."""
        return next((hint for pattern, hint in HINTS if re.match(pattern, self.text[self.at :])), "")


def short(latex: str, most: int = 24) -> str:
    """The beginning of LaTeX, to an end of a word of it."""
    text = " ".join(latex.split())
    return text if len(text) <= most else re.sub(r"\\[A-Za-z]*$|\s+$", "", text[:most])


def place_of(latex: str, error: UnreadError, expanded: Callable[[str], str] = str) -> int | None:
    """Where in LaTeX, as it is typed, stands what was not read; expanded: puts macros in their places."""

    def bare(text: str) -> str:
        return text.replace("&", "").replace("\\\\", "").lstrip(";").rstrip(" ")

    so_far = bare(error.text[: error.at])
    starts = (found.end() for found in re.finditer(r"^|\\\\|\\begin\{\w+\}|,|\\q?quad(?![a-z])", latex))
    for start in starts:
        for at in range(start, len(latex)):
            if not latex[at].isspace() and bare(plain(expanded(latex[start:at]))) == so_far:
                return at
    return None


WIDE = r"(?:\\q?quad(?![a-z])|\\enspace(?![a-z])|\\hspace\*?\{[^{}]*\}|\\ )"
BETWEEN = re.compile(  # two equations of a row
    rf"[,;]\s*(?:{WIDE}\s*)*\\(?:text|mbox|textrm)\s*\{{\s*and\s*\}}(?:\s*{WIDE})*|[,;](?:\s*{WIDE})*|{WIDE}(?:\s*{WIDE})*"
    rf"|(?:{WIDE}\s*)*\\(?:text|mbox|textrm)\s*\{{\s*and\s*\}}(?:\s*{WIDE})*"
)
OPENING = re.compile(r"\\begin\{|\\end\{|\\[{}]|[()\[\]{}]|" + BETWEEN.pattern)
SIGN = re.compile(r"=|<|\\(?:approx|triangleq|coloneqq|doteq|simeq|equiv|leq)(?![a-z])")


def _rows(display: str) -> Iterator[str]:
    """The lines of a display: the rows of aligned, and in each the equations that stand apart by a comma or a space."""
    inside = re.fullmatch(r"\s*(?:\\left\s*\\\{\s*)?\\begin\{aligned\}(.*)\\end\{aligned\}\s*(?:\\right\s*\.\s*)?",
                          display, re.DOTALL)  # fmt: skip
    if not inside:
        yield from _apart(display)
        return
    row, depth = "", 0
    for piece in re.split(rf"(\\begin\{{|\\end\{{|{BREAK})", inside[1]):
        depth += (piece == r"\begin{") - (piece == r"\end{")
        if piece.startswith("\\\\") and not depth:
            yield from _apart(row)
            row = ""
        else:
            row += piece if depth or piece.startswith(r"\end") else piece.replace("&", "")
    yield from _apart(row)


def _apart(row: str) -> Iterator[str]:
    """The equations of a row."""
    parts, begins, depth = [], 0, 0
    for found in OPENING.finditer(row):
        if BETWEEN.fullmatch(found[0]):
            if not depth:
                parts.append(row[begins : found.start()])
                begins = found.start()
        else:
            depth += 1 if found[0] in ("(", "[", "{", r"\{", r"\begin{") else -1
            depth += found[0] in (r"\begin{", r"\end{")  # its name closes a bracket too
    whole = ""
    for part in (*parts, row[begins:]):
        if whole and SIGN.search(BETWEEN.sub("", part, count=1)) and SIGN.search(whole):
            yield whole
            whole = BETWEEN.sub("", part, count=1)
        else:
            whole += part
    yield whole


@cache
def plain(latex: str) -> str:
    """LaTeX without what only sets it: spaces, the sizes of brackets and matrices, the two shapes of epsilon."""
    latex = re.sub(r"(\[[^\[\]]*(?<!\\);[^\[\]]*\])", r"\1^T", latex)  # [a; b; c] as in MATLAB: a column
    latex = re.sub(r"(?<!\\)\\ |\\q?quad", ";", latex)  # [a \ b \ c]^T: the spaces separate
    for pattern, spelling in (*SETTING, *ALIKE):
        latex = re.sub(pattern, spelling, latex)
    return joined(tokens(latex)).replace("&=", "=").rstrip(",.;")


def _minus(term):
    try:
        return negative(term)
    except ShapeError:
        first, *others = term.args
        return as_written(Mul, (-first, *others) if first.is_Number else (S.NegativeOne, *term.args))


def is_identity(part) -> bool:
    """Whether it is an identity of open size, or what keeps that size: a multiple, a sum, a power, a transpose."""
    if isinstance(part, Mul):
        others = [factor for factor in part.args if not factor.is_commutative]
        return len(others) == 1 and is_identity(others[0])
    if isinstance(part, Add):
        return all(map(is_identity, part.args))
    return is_identity(part.args[0]) if part.is_Pow or isinstance(part, transpose) else part == IDENTITY_OF_ITS_PLACE


def identity_of(part, sizes: set[int]):
    """The part, if it is an identity of open size, in the one size that there is."""
    if len(sizes) != 1 or not is_identity(part):
        return part
    (size,) = sizes
    return replaced(part, {IDENTITY_OF_ITS_PLACE: Symbol(f"I_{size}x{size}", commutative=False)})


class _Reader:
    """Recursive descent over one display; `at` is the position reached."""

    def __init__(self, text: str, alphabet: Alphabet, flown: Mapping[str, object]):
        self.text, self.flown, self.at = text, flown, 0
        self.table, self.turned, self.shapes = alphabet.table, alphabet.turned, alphabet.shapes
        self.names = alphabet.names
        self.layout: dict = {}
        self.bars = 0  # that are open
        self.identity_at = 0  # where the last one stands whose size is open

    def ahead(self, *parts: str) -> bool:
        """Whether one of these stands here, as whole tokens."""
        return self.text.startswith(parts, self.at) and any(map(self.after, parts))

    def after(self, part: str) -> int:
        """The place behind this, with the space that sets it apart; 0 if it does not stand here."""
        if not self.text.startswith(part, self.at):
            return 0
        end = self.at + len(part)
        beside = self.text[end : end + 1]
        if beside == " ":
            return end + 1
        return 0 if beside.isalpha() and ends_in_command(part) else end

    def take(self, part: str) -> bool:
        end = self.after(part)
        self.at = end or self.at
        return end > 0

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
        sides = self.sized(sides, [self.size(side) for side in sides])
        if any(IDENTITY_OF_ITS_PLACE in getattr(side, "free_symbols", ()) for side in sides):
            self.at = next(IDENTITY.finditer(self.text)).start()
            self.refuse("no letter is written so, and as an identity its size is open: write I_3")
        return Relation(tuple(sides), self.layout)

    def sized(self, parts: list, sizes: Iterable) -> list:
        """Parts of a sum, or sides, with the size of an identity among them where the others have one."""
        square = {size for size in sizes if size and size[0] == size[1]}
        return [identity_of(part, {rows for rows, _ in square}) for part in parts]

    def sized_factors(self, factors: list) -> list:
        """Factors with the size of an identity among them by what stands beside it."""
        found = [factor for factor in factors if not factor.is_commutative or is_explicit(factor)]
        for one in [one for one in found if is_identity(one)]:
            i = next(i for i, other in enumerate(found) if other is one)
            left, right = (self.size(beside[0]) if beside else None for beside in (found[:i][-1:], found[i + 1 :][:1]))
            if (left and left[0] == 1) or (right and right[1] == 1):
                self.at = self.identity_at
                n = left[1] if left else right[0] if right else 3
                self.refuse(f"before a vector it can be an identity, or a letter, as of inertia: write I_{n}, or add "
                            "the letter to the table")  # fmt: skip
            made = identity_of(one, {size for size in (left and left[1], right and right[0]) if size})
            factors = [made if factor is one else factor for factor in factors]
        return factors

    def sized_blocks(self, rows: list[list]) -> list[list]:
        """Blocks with the sizes of identities among them by those in the same rows and columns."""
        changed = any(map(is_identity, (block for row in rows for block in row)))
        while changed:
            before, sizes = rows, [[self.size(block) or self.of_scalar(block) for block in row] for row in rows]
            heights = [{size[0] for size in row if size} for row in sizes]
            widths = [{size[1] for size in column if size} for column in zip(*sizes, strict=True)]
            rows = [[identity_of(block, height | width) for block, width in zip(row, widths, strict=True)]
                    for row, height in zip(rows, heights, strict=True)]  # fmt: skip
            changed = rows != before
        return rows

    @staticmethod
    def of_scalar(block) -> tuple[int, int] | None:
        """A number among blocks is one entry, and 0 a block of zeros of any size."""
        return (1, 1) if block.is_commutative and not is_explicit(block) and block != 0 else None

    def size(self, part) -> tuple[int, int] | None:
        """Rows and columns; None of a number, and of what is not known."""
        if is_identity(part):
            return None
        if isinstance(part, Symbol):
            if block := re.fullmatch(r"[0I]_(\d+)x(\d+)", part.name):
                return int(block[1]), int(block[2])
            shape = self.shapes.get(part)
            return (shape[0], (*shape, 1)[1]) if shape else None
        if is_explicit(part):
            return part.shape if all(self.size(entry) is None for entry in part) else None
        if isinstance(part, transpose):
            size = self.size(part.args[0])
            return size and size[::-1]
        if part.func == SKEW:
            return 3, 3
        if part.is_Pow or part.func in (OPERATORS[r"\exp"], CONJUGATE, RATE):
            return self.size(part.args[0])
        if isinstance(part, Add):
            return next(filter(None, map(self.size, part.args)), None)
        if isinstance(part, Mul):
            sizes = [self.size(factor) or (0, 0) for factor in part.args if not factor.is_commutative]
            return (sizes[0][0], sizes[-1][1]) if sizes and (0, 0) not in sizes else None
        return None

    def sum(self):
        self.take("+")
        terms = [_minus(self.product()) if self.take("-") else self.product()]
        while self.ahead("+", "-"):
            if self.take("+"):
                terms.append(self.product())
            else:
                self.need("-")
                terms.append(_minus(self.product()))
        return total(*self.sized(terms, [self.size(term) for term in terms]))

    def product(self):
        factors = [self.factor()]
        while self.at < len(self.text) and not self.ahead(*ENDS) and not (self.bars and self.ahead("|")):
            entry = ENTRY.match(self.text, self.at)
            if self.take("/"):
                factors[-1] = self.divided(factors[-1], self.factor())
            elif self.take(r"\cdot"):
                factors.append(self.factor())
                if sum(not one.is_commutative or is_explicit(one) for one in factors[:-1]) > 1:
                    factors = [product(*factors[:-1]), factors[-1]]  # C f . v
                if all(self.shape(one) != (4,) and (self.size(one) or ())[1:] == (1,) for one in factors[-2:]):
                    factors[-2] = turned(factors[-2])
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
        factors = self.sized_factors(factors)
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
        token = first_token(self.text, self.at)
        for name in self.names.get(token, ()):
            if self.take(name):
                if name in self.turned:
                    return transpose(self.turned[name].symbol, evaluate=False)
                if self.table[name].function:
                    self.at -= 1
                    return self.power(self.call(self.table[name]))
                if BY_TIME.match(name):
                    self.alone(r"\dot{x} y, or \frac{d}{dt}(x y)")
                return self.power(self.table[name].symbol)
        if found := BY_TIME.match(self.text, self.at):
            if {found["d"], "t"} <= self.table.keys():
                self.refuse(
                    rf"it can be a rate, or a quotient of letters: write \frac{{{found['d']}}}{{t d}}, or rename"
                )
            return self.rate(found.end(), "")
        if (found := OVER_TIME.match(self.text, self.at)) and found["d"] not in self.table:
            return self.rate(found.end(), f"}}{{{found['d']}t}}")
        if token in FUNCTIONS:
            self.take(token)
            return self.elementary(FUNCTIONS[token])
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
        if self.take("e^") or self.take(r"\mathrm{e}^"):
            return self.exponential(self.argument())
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
        if self.ahead(r"\{"):
            return self.curly()
        if self.ahead("(", "["):
            return self.bracket()
        if self.ahead("{"):
            return self.power(self.group("{", "}"))
        if block := BLOCK.match(self.text, self.at):
            return self.block(block)
        if identity := IDENTITY.match(self.text, self.at):
            self.identity_at, self.at = self.at, identity.end()
            return self.power(IDENTITY_OF_ITS_PLACE)
        if self.take(r"\mathbf{0}") or self.take(r"\boldsymbol{0}"):
            return Integer(0)
        number = NUMBER.match(self.text, self.at)
        if number:
            self.at = number.end()
            return self.power(Rational(number.group()))
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

    def rate(self, at: int, ends: str):
        """Of what stands in brackets, up to what ends the fraction that they stand in."""
        start, self.at = self.at, at
        left = next((one for one in ("(", "[", r"\{") if self.take(one)), "")
        if not left:
            self.at = start
            self.refuse()
        right = {"(": ")", "[": "]", r"\{": r"\}"}[left]
        inside = self.sum()
        if self.take(r"\times" + right):
            inside = SKEW(inside)
        else:
            self.need(right)
        if ends:
            self.need(ends)
        else:
            inside = turned(inside) if self.take("^T") else inside
            self.alone(r"\left(\frac{d}{dt}(x)\right) y, or \frac{d}{dt}(x y)")
        try:
            letters = rate_of(inside).free_symbols - inside.free_symbols
        except ValueError as error:
            self.at = start
            self.refuse(f"{error}")
        if lost := [one.name for one in letters if one not in self.shapes]:
            self.at = start
            self.refuse(f"{', '.join(sorted(lost))} is no letter of the table, and the rate is made of it")
        return RATE(inside)

    def alone(self, readings: str) -> None:
        """That no factor follows, nor a power."""
        if self.at < len(self.text) and not self.ahead(*ENDS, *("|",) * bool(self.bars)):
            self.refuse(f"write {readings}: this can be either")

    def exponential(self, inside):
        return exp(inside) if inside.is_commutative and not is_explicit(inside) else OPERATORS[r"\exp"](inside)

    def argument(self):
        """What stands in braces, or one digit, or one letter: \\frac12."""
        if self.ahead("{"):
            return self.group("{", "}")
        if self.text[self.at : self.at + 1].isdigit():
            self.at += 1
            return Integer(self.text[self.at - 1])
        for name in self.names.get(first_token(self.text, self.at), ()):
            if name in self.table and self.take(name):
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
        base = SKEW(base) if self.take(r"_\times") else base
        if self.take("^T"):
            return turned(base)
        if self.take("^{-1}"):
            return base**-1
        if self.take("^{-T}"):
            return transpose(base**-1, evaluate=False)
        if self.take(r"^\wedge") or self.take(r"^\times"):
            return SKEW(base)
        if self.take("^*"):
            return CONJUGATE(base)
        if not self.take("^"):
            return base
        at, exponent = self.at, self.argument()
        if not exponent.is_number and not base.is_commutative:
            self.refuse("no letter of the table has this above it, and it is no power")
        if exponent.is_number and abs(exponent) > LARGEST_POWER:
            self.at = at
            self.refuse(f"a power above {LARGEST_POWER}")
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
        return matrix(self.sized_blocks(rows))

    def cell(self):
        """One entry, or a row of scalars apart by spaces as a block."""
        entries = [self.sum()]
        while self.take(";"):
            entries.append(self.sum())
        return entries[0] if len(entries) == 1 else Function("row")(*entries)

    def curly(self):
        """{a <= k <= b}, or what plain brackets hold."""
        self.need(r"\{")
        bounds = [self.sum()]
        while self.take(r"\leq"):
            bounds.append(self.sum())
        if len(bounds) == 1 and self.take(r"\times\}"):
            return self.power(SKEW(bounds[0]))
        self.need(r"\}")
        return self.power(bounds[0]) if len(bounds) == 1 else Function("samples")(*bounds)

    def bracket(self):
        """(a), [a], [a x]; and [a b], [a, b] or (a, b): a row, whose transpose is a column."""
        start, right = self.at, ")" if self.ahead("(") else "]"
        self.at += 1
        items = [self.sum()]
        if self.take(r"\times" + right):
            return self.power(SKEW(items[0]))
        separators = set()
        while self.ahead(",", ";") and len(separators) < 2:
            separators.add(self.text[self.at])
            self.at += 1
            items.append(self.sum())
        self.need(right)
        if len(items) == 1:
            return self.power(items[0])
        if self.take("^T"):
            return column(*map(untransposed, items))
        if "," in separators:
            self.at = start
            self.refuse(
                r"write (a, b)^T for a column, [a \quad b] for a row, a b - b a for a commutator: it can be each"
            )
        return matrix([items])

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
