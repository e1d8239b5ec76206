"""What a formula looks like, whatever the format: the order of the tree, brackets where precedence asks for them.

A place in a relation is the tuple of indices that lead to it: of the side, then of `children` at each node.
"""

from collections.abc import Collection, Iterable, Mapping
from itertools import groupby

from sympy import Add, Expr, Float, MatAdd, MatMul, MatPow, Mul, Pow, Rational, S, StrictLessThan, Symbol
from sympy.core.function import Application
from sympy.functions.elementary.complexes import transpose
from sympy.matrices import MatrixBase

from boresight import BoresightError
from boresight.derive.ledger.equation import Quantity, Relation, children, is_explicit

# How strongly a piece holds together: a < b, a + b and -a, a b, a / b, sin a, (a).
COMPARED, SUM, PRODUCT, FRACTION, PREFIX, ATOM = range(6)
Place = tuple[int, ...]
Piece = tuple[str, int]

ELEMENTARY = {
    "sin": "sin", "cos": "cos", "tan": "tan", "asin": "arcsin", "acos": "arccos", "atan": "arctan", "exp": "exp",
    "log": "ln", "sinh": "sinh", "cosh": "cosh", "tanh": "tanh",
}  # fmt: skip


class Writer:
    """The walk over a tree; a format says what each piece looks like."""

    TIMES = FENCES = OPEN_MARK = CLOSE_MARK = ""

    def __init__(self, quantities: Iterable[Quantity], marks: Collection[Place]):
        self.letters = {q.symbol.name + "(" * q.function: q.latex for q in quantities}
        self.marks = frozenset(marks)
        self.layout: Mapping = {}

    def pieces(self, relation: Relation) -> list[tuple[str, str]]:
        """The terms of the chain, each with what stands before it: =, +, - or, at the start, nothing."""
        result: list[tuple[str, str]] = []
        self.layout = relation.layout
        for i, side in enumerate(relation.sides):
            (_, first), *others = self._terms(side, (i,))
            terms = [("=" * bool(i), first), *others]
            if (i,) in self.marks and isinstance(side, Add | MatAdd):
                terms[0] = (terms[0][0], self.OPEN_MARK + terms[0][1])
                terms[-1] = (terms[-1][0], terms[-1][1] + self.CLOSE_MARK)
            result += terms
        return result

    # ---- what a format may say otherwise ---------------------------------------------------------------------------

    def letter(self, name: str) -> Piece:
        raise NotImplementedError

    def head(self, name: str) -> str:
        """A letter that is written with arguments."""
        raise NotImplementedError

    def bracketed(self, text: str, left: str = "(", right: str = ")") -> str:
        return f"{left}{text}{right}"

    def minus(self, text: str) -> str:
        return "-" + text

    def fraction(self, above: list[Piece], below: list[Piece]) -> Piece:
        raise NotImplementedError

    def root(self, text: str) -> str:
        raise NotImplementedError

    def raised(self, base: str, exponent: str) -> str:
        raise NotImplementedError

    def applied(self, name: str, argument: Piece, exponent: str) -> Piece:
        """An elementary function, perhaps with a power of its value."""
        raise NotImplementedError

    def grid(self, rows: list[list[str]]) -> str:
        raise NotImplementedError

    def summed(self, name: str, argument: str) -> Piece:
        """A sum over samples."""
        raise NotImplementedError

    def entry(self, base: str, row: str, column: str) -> Piece:
        raise NotImplementedError

    def expectation(self, text: str) -> str:
        return "E" + self.bracketed(text, "[", "]")

    NORM = CURLY = ("", "")
    RATE = "d/dt"
    AT_MOST = CROSS = TRANSPOSED = VECTOR = ""

    # ---- the walk --------------------------------------------------------------------------------------------------

    def write(self, expression, at: Place) -> Piece:
        text, level = self._written(expression, at)
        return (self.OPEN_MARK + text + self.CLOSE_MARK, level) if at in self.marks else (text, level)

    def held(self, expression, at: Place, level: int) -> str:
        """Its text, in brackets if it does not hold together as strongly as `level`."""
        return self.hold(self.write(expression, at), level)

    def hold(self, piece: Piece, level: int) -> str:
        return piece[0] if piece[1] >= level else self.bracketed(piece[0])

    def _written(self, expression, at: Place) -> Piece:
        if isinstance(expression, Symbol):
            return self.letter(expression.name)
        if expression is S.Pi:
            return self.letter("π")
        if isinstance(expression, Float):
            return (f"{float(expression):.15g}", ATOM) if expression >= 0 else (f"-{float(-expression):.15g}", SUM)
        if isinstance(expression, Rational):
            if expression < 0:
                return self.minus(self._written(-expression, at)[0]), SUM
            above, below = (str(expression.p), ATOM), (str(expression.q), ATOM)
            return above if expression.q == 1 else self.fraction([above], [below])
        if isinstance(expression, MatrixBase):
            return self._matrix(expression, at)
        if isinstance(expression, Add | MatAdd):
            return " ".join(part for term in self._terms(expression, at) for part in term if part), SUM
        if isinstance(expression, Mul | MatMul):
            minus, text, level = self._product(expression, at)
            return (self.minus(text), SUM) if minus else (text, level)
        if isinstance(expression, Pow | MatPow):
            return self._power(expression.args[0], expression.args[1], at)
        if isinstance(expression, transpose):
            return self.raised(self.held(expression.args[0], (*at, 0), ATOM), self.TRANSPOSED), PREFIX
        if isinstance(expression, StrictLessThan):
            left, right = (self.held(argument, (*at, i), SUM) for i, argument in enumerate(expression.args))
            return f"{left} {self.LESS} {right}", COMPARED
        if isinstance(expression, Application):
            return self._call(expression, at)
        raise BoresightError(f"no way to write a {type(expression).__name__}: {expression}")

    LESS = "<"

    def _terms(self, expression, at: Place) -> list[tuple[str, str]]:
        """Of a sum or a single term: the sign before each term, and its text; a mark holds a minus too."""
        terms, level = [(expression, at)], COMPARED
        if isinstance(expression, Add | MatAdd):
            terms, level = [(argument, (*at, i)) for i, argument in enumerate(expression.args)], PRODUCT
        result: list[tuple[str, str]] = []
        for term, place in terms:
            minus, text = self._term(term, place, level)
            sign = ("-" if minus else "+") if result else ""
            text = self.minus(text) if minus and not result else text
            if place in self.marks:
                text = f"{'- ' * (sign == '-')}{text}"
                text, sign = f"{self.OPEN_MARK}{text}{self.CLOSE_MARK}", sign.strip("-")
            result.append((sign, text))
        return result

    def _term(self, expression, at: Place, level: int) -> tuple[bool, str]:
        """Whether it is negative, and the text of the rest."""
        if isinstance(expression, Rational) and expression < 0:
            return True, self._written(-expression, at)[0]
        if isinstance(expression, Mul | MatMul):
            minus, text, _ = self._product(expression, at)
            return minus, text
        return False, self.hold(self._written(expression, at), level)

    def _product(self, expression, at: Place) -> tuple[bool, str, int]:
        """Whether it is negative, the text of the rest, and how strongly that holds together.

        Scalars that stand side by side are one fraction, if any of them divides.
        """
        factors = [(factor, (*at, i)) for i, factor in enumerate(expression.args)]
        minus = expression.args[0].is_Number and expression.args[0] < 0
        if minus:
            first = -expression.args[0]
            factors[:1] = [(first, factors[0][1])] if first != 1 else []
        texts: list[Piece] = []
        groups = self.layout.get(expression) or (minus and self.layout.get(-expression))
        if groups:
            minus &= expression not in self.layout
            at_factor = dict(factors)
            for group in groups:
                texts += self._fraction([(factor, at_factor.get(factor, (*at, -1))) for factor in group])
        else:
            for scalar, run in groupby(factors, lambda factor: _is_scalar(factor[0])):
                listed = list(run)
                texts += self._fraction(listed) if scalar else [self.write(*factor) for factor in listed]
        if len(texts) == 1:
            return minus, self.hold(texts[0], PRODUCT), max(texts[0][1], PRODUCT)
        last = len(texts) - 1
        held = [self.factor(piece, i, i == last) for i, piece in enumerate(texts)]
        return minus, self.TIMES.join(held), PRODUCT

    def factor(self, piece: Piece, index: int, last: bool) -> str:
        """One of several factors."""
        return self.hold(piece, PREFIX)

    def _fraction(self, factors: list) -> list[Piece]:
        above: list[Piece] = []
        below: list[Piece] = []
        for factor, at in factors:
            if isinstance(factor, Pow) and factor.exp.is_number and factor.exp < 0:
                if factor.exp == -1:
                    below.append(self.write(factor.base, (*at, 0)))
                else:
                    below.append(self._power(factor.base, -factor.exp, at))
            elif isinstance(factor, Rational) and factor.q != 1:
                above += [(str(factor.p), ATOM)] if factor.p != 1 else []
                below.append((str(factor.q), ATOM))
            else:
                above.append(self.write(factor, at))
        return [self.fraction(above, below)] if below else above

    def multiplied(self, pieces: list[Piece]) -> str:
        if not pieces:
            return "1"
        return pieces[0][0] if len(pieces) == 1 else self.TIMES.join(self.hold(piece, PREFIX) for piece in pieces)

    def _power(self, base, exponent, at: Place) -> Piece:
        if _is_scalar(base) and exponent.is_number and exponent < 0:
            return self._fraction([(Pow(base, exponent, evaluate=False), at)])[0]
        if exponent == S.Half:
            return self.root(self.write(base, (*at, 0))[0]), ATOM
        power = self.write(exponent, (*at, 1))[0]
        function = base.func.__name__ if isinstance(base, Application) and (*at, 0) not in self.marks else ""
        if function in ELEMENTARY and exponent.is_Integer:
            return self.applied(function, self.write(base.args[0], (*at, 0, 0)), power)
        return self.raised(self.held(base, (*at, 0), ATOM), power), PREFIX

    def _matrix(self, expression, at: Place) -> Piece:
        columns = expression.cols
        cells = [self.write(entry, (*at, i)) for i, entry in enumerate(children(expression))]
        if len(cells) == 1:  # the product of a row and a column is added to scalars
            return cells[0]
        texts = [text for text, _ in cells]
        return self.grid([texts[i : i + columns] for i in range(0, len(texts), columns)]), ATOM

    def _call(self, expression, at: Place) -> Piece:
        name = expression.func.__name__
        places = [(argument, (*at, i)) for i, argument in enumerate(expression.args)]
        if name == "transpose":
            return self.raised(self.held(*places[0], ATOM), self.TRANSPOSED), PREFIX
        if name == "vee":
            return self.raised(self.held(*places[0], ATOM), self.VECTOR), PREFIX
        if name == "cross":
            return " ".join([self.held(*places[0], PREFIX), self.CROSS, self.held(*places[1], PREFIX)]), PRODUCT
        if name == "skew":
            return f"[{self.held(*places[0], PREFIX)} {self.CROSS}]", ATOM
        if name == "E":
            return self.expectation(self.write(*places[0])[0]), ATOM
        if name == "entry":
            row, column = (self.write(*place)[0] for place in places[1:])
            return self.entry(self.held(*places[0], ATOM), row, column)
        if name == "rate":
            return f"{self.RATE} {self.bracketed(self.write(*places[0])[0])}", PRODUCT
        if name == "norm":
            return self.bracketed(self.write(*places[0])[0], *self.NORM), ATOM
        if name == "Σ":
            return self.summed(name, self.held(*places[0], PRODUCT))
        if name == "row":
            return self.grid([[self.write(*place)[0] for place in places]]), ATOM
        if name == "samples":
            chain = f" {self.AT_MOST} ".join(self.held(*place, SUM) for place in places)
            return self.bracketed(chain, *self.CURLY), ATOM
        if name in ELEMENTARY and name + "(" not in self.letters:
            return self.applied(name, self.write(*places[0]), "")
        texts = [self.write(*place)[0] for place in places]
        if len(texts) == 6:  # three angles and their errors
            triples = (self.bracketed(", ".join(texts[i : i + 3])) for i in (0, 3))
            return self.head(name) + self.bracketed(", ".join(triples), "[", "]"), ATOM
        return self.head(name) + self.bracketed(", ".join(texts)), ATOM


def _is_scalar(expression) -> bool:
    """Whether it commutes with what stands beside it: no matrix, and no sum over samples, which takes what follows."""
    if is_explicit(expression) or (isinstance(expression, Application) and expression.func.__name__ in ("Σ", "vee")):
        return False
    return isinstance(expression, Expr) and bool(expression.is_commutative)
