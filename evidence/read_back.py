"""Formulas read back from where a person reads them, and evaluated.

The tokens of three formats feed one strict grammar with ordinary precedence: products and applications stand there,
brackets match, an unknown letter or sign is refused.
"""

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import reduce
from typing import Any

from flint import arb

from boresight.derive.ledger import numbers
from boresight.derive.ledger.numbers import Matrix, cos, norm, sin, sqrt, tan, zeros
from boresight.evidence.formula_tokens import RefusedError, Row, Spelling

# ---- The grammar -----------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Values:
    """What letters and functions are, by name.

    samples: the values at each sample, for sums.  random: columns of a root of the covariance of some letters.
    """

    letters: Mapping[str, Any]
    functions: Mapping[str, Callable]
    samples: tuple[Mapping[str, Any], ...] = ()
    random: Mapping[str, tuple] | None = None

    def changed(self, letters: Mapping[str, Any]) -> "Values":
        return Values({**self.letters, **letters}, self.functions, self.samples, self.random)


class Formula:
    """Recursive descent over one row, which gives values."""

    def __init__(self, row: Row, spelled: Spelling, values: Values, meant: Collection[str]):
        """meant: the names that are taken where a spelling has several."""
        self.row, self.spelled, self.values, self.meant = row, spelled, values, meant
        self.at = 0
        self.matrices: list = []  # the values of those that are written out, so that no 0 hides an entry

    def inside(self, row: Row, rule: Callable[["Formula"], Any]) -> Any:
        inner = Formula(row, self.spelled, self.values, self.meant)
        inner.matrices = self.matrices
        value = rule(inner)
        inner.end()
        return value

    def end(self) -> None:
        if self.at < len(self.row):
            raise RefusedError(f"{self.row[self.at]} is one too many")

    def ahead(self, *signs: str) -> bool:
        return self.at < len(self.row) and self.row[self.at][0] == "sign" and self.row[self.at][1] in signs

    def take(self, sign: str) -> bool:
        found = self.ahead(sign)
        self.at += found
        return found

    def need(self, sign: str) -> None:
        if not self.take(sign):
            raise RefusedError(f"{sign} is missing")

    def sides(self) -> list:
        """The values of a chain of equalities."""
        values = [self.side()]
        while self.take("="):
            values.append(self.side())
        self.end()
        return values

    def side(self) -> Any:
        value = self.sum()
        return Broken("<", (value, self.sum())) if self.take("<") else value

    def sum(self) -> Any:
        value = self.subtracted() if self.take("-") else self.product()
        while self.ahead("+", "-"):
            if self.take("+"):
                value = plus(value, self.product())
            else:
                self.need("-")
                value = plus(value, self.subtracted())
        return value

    def subtracted(self) -> Any:
        """The negative of the product that follows a minus, which is not 0."""
        if self.row[self.at : self.at + 1] == (("number", "0"),):
            raise RefusedError("-0 is no number")
        return times(-1, self.product())

    def product(self) -> Any:
        value = self.factor()
        while self.ahead("*", "/", "×"):
            if self.take("/"):
                value = divided(value, self.factor())
            elif self.take("×"):
                if self.ahead("]"):
                    self.at -= 1
                    break
                value = times(turning(value), self.factor())
            else:
                self.need("*")
                value = times(value, self.factor())
        return value

    def factor(self) -> Any:
        value = self.primary()
        if self.at < len(self.row) and self.row[self.at][0] == "down":
            value = self.entry(value, self.row[self.at][1])
        if self.at < len(self.row) and self.row[self.at][0] == "up":
            value = raised(value, self.exponent())
        return value

    def entry(self, value: Any, script: Row) -> Any:
        (kind, i), comma, (other, j) = script if len(script) == 3 else (("", 0), "", ("", 0))
        if (kind, other) != ("number", "number") or comma != ("sign", ","):
            raise RefusedError("an index belongs to no letter")
        self.at += 1
        if not isinstance(value, Matrix) or not (0 < int(i) <= value.rows and 0 < int(j) <= value.cols):
            raise RefusedError("there is no such entry")
        return value[int(i) - 1, int(j) - 1]

    def exponent(self) -> Any:
        script = self.row[self.at][1]
        self.at += 1
        if script in ((("glyph", "T"),), (("sign", "∨"),)):
            return script[0][1]
        parts = [("number", what) if kind == "number" else (kind, what) for kind, what in script]
        minus = parts[:1] == [("sign", "-")]
        match parts[minus:]:
            case [("number", whole)]:
                return -int(whole) if minus else int(whole)
            case [("fraction", ((("number", above),), (("number", below),)))]:
                pass
            case [("number", above), ("sign", "/"), ("number", below)]:
                pass
            case _:
                raise RefusedError("an exponent is no number")
        return (-1 if minus else 1) * int(above), int(below)

    def primary(self) -> Any:
        if self.at == len(self.row):
            raise RefusedError("it ends too early")
        name = self.letter()
        if name is not None:
            return self.values.letters[name]
        head = self.head()
        if head is not None:
            return self.values.functions[head](*map(whole, self.arguments()))
        kind, what = self.row[self.at]
        self.at += 1
        if kind == "number":
            if len(what) > 1 and what[0] == "0":
                raise RefusedError(f"{what} is no number")
            return int(what)
        if kind == "fraction":
            return divided(self.inside(what[0], Formula.sum), self.inside(what[1], Formula.sum))
        if kind == "root":
            return root(whole(self.inside(what, Formula.sum)))
        if kind == "named":
            return self.elementary(what)
        if kind == "upright" and what == (("glyph", "E"),):
            return self.expectation()
        if kind == "table":
            self.matrices.append(assembled([[self.inside(cell, Formula.sum) for cell in row] for row in what]))
            return self.matrices[-1]
        if kind == "sum":
            return self.over_samples(what)
        if kind == "sign":
            return self.fenced(what)
        raise RefusedError(f"{kind} {what} is no formula")

    def longest_match(self, table: Mapping[Row, Any]) -> tuple[int, Any]:
        for size in range(min(self.spelled.longest, len(self.row) - self.at), 0, -1):
            found = table.get(self.row[self.at : self.at + size])
            if found is not None:
                return size, found
        return 0, None

    def letter(self) -> str | None:
        """The name of the letter that stands here, which is taken; none if it is the head of a function."""
        if self.row[self.at][0] == "letter":
            name = self.spelled.text[self.row[self.at][1]]
            self.at += name not in self.values.functions
            return None if name in self.values.functions else name
        size, names = self.longest_match(self.spelled.letters)
        head, _ = self.longest_match(self.spelled.functions)
        self.at += size
        if not size or head > size or self.ahead("(", "["):
            self.at -= size
            return None
        meant = [name for name in names if name in self.meant] or [names[-1]]
        if len(meant) > 1:
            raise RefusedError(f"{' and '.join(meant)} are spelled alike")
        return meant[0]

    def head(self) -> str | None:
        """The name of the function whose arguments follow."""
        if self.row[self.at][0] == "letter":
            self.at += 1
            return self.spelled.text[self.row[self.at - 1][1]]
        size, name = self.longest_match(self.spelled.functions)
        self.at += size
        return name

    def arguments(self) -> list:
        """(a, b), or [(a, b), (c, d)]."""
        if self.take("["):
            values = self.arguments()
            while self.take(","):
                values += self.arguments()
            self.need("]")
            return values
        self.need("(")
        values = [self.sum()]
        while self.take(","):
            values.append(self.sum())
        self.need(")")
        return values

    def elementary(self, name: str) -> Any:
        power = None
        if self.at < len(self.row) and self.row[self.at][0] == "up":
            power = self.exponent()
            if not isinstance(power, int) or power < 1:
                raise RefusedError("a power of a function")
        if self.take("("):
            value = self.sum()
            self.need(")")
        else:
            bare = self.at < len(self.row) and self.row[self.at][0] in ("glyph", "accent")
            found = self.letter() if bare else None
            if found is None:
                raise RefusedError(f"{name} of nothing")
            value = self.values.letters[found]
        value = whole(value)
        if isinstance(value, Matrix) and (name != "exp" or value.rows != value.cols):
            raise RefusedError(f"{name} of a matrix")
        value = FUNCTIONS[name](value)
        return value if power is None else raised(value, power)

    def expectation(self) -> Any:
        """Of what is at most quadratic in the random letters."""
        start, given = self.at, self.values

        def inside() -> Any:
            self.at = start
            self.need("[")
            value = self.sum()
            self.need("]")
            return value

        middle = result = inside()
        for name, columns in (given.random or {}).items():
            for column in columns:
                for sign in (1, -1):
                    self.values = given.changed({name: plus(given.letters[name], times(sign, column))})
                    result = plus(result, divided(plus(inside(), times(-1, middle)), 2))
        self.values = given
        return result

    def over_samples(self, index: Row) -> Any:
        if index != self.spelled.samples:
            raise RefusedError("the index of a sum is unknown")
        start, given, parts = self.at, self.values, []
        for sample in given.samples:
            self.at, self.values = start, given.changed(sample)
            parts.append(self.product())
        self.values = given
        return reduce(plus, parts)

    def fenced(self, sign: str) -> Any:
        if sign == "(":
            value = self.sum()
            self.need(")")
            return value
        if sign == "‖":
            value = self.sum()
            self.need("‖")
            return norm(whole(value))
        if sign == "[":
            value = turning(self.product())
            self.need("×")
            self.need("]")
            return value
        if sign == "{":
            bounds = [self.sum()]
            while self.take("≤"):
                bounds.append(self.sum())
            self.need("}")
            if "samples" not in self.values.functions:
                raise RefusedError("no samples are meant")
            return self.values.functions["samples"](*map(whole, bounds))
        raise RefusedError(f"{sign} begins nothing")


# ---- Values ----------------------------------------------------------------------------------------------------------


def number(value: Any) -> Any:
    """The number, if it is one or a 1x1 matrix."""
    return value[0, 0] if isinstance(value, Matrix) and (value.rows, value.cols) == (1, 1) else value


def shape(value: Any) -> tuple[int, int] | None:
    return (value.rows, value.cols) if isinstance(value, Matrix) else None


@dataclass(frozen=True)
class Broken:
    """What does not fit together and so has no value, though its parts have."""

    operation: str
    parts: tuple


def plus(a: Any, b: Any) -> Any:
    a, b = number(a), number(b)
    if _broken(a, b) or shape(a) != shape(b):
        return Broken("+", (a, b))
    return a + b


def times(a: Any, b: Any) -> Any:
    if isinstance(b, Broken) and not isinstance(a, Matrix | Broken):
        first, *others = b.parts
        return Broken(b.operation, (times(a, first), *(times(a, x) if b.operation == "+" else x for x in others)))
    if _broken(a, b) or (isinstance(a, Matrix) and isinstance(b, Matrix) and not _chained(a, b)):
        return Broken("*", (a, b))
    return quaternion(a, b) if shape(a) == shape(b) == (4, 1) else a * b


def whole(value: Any) -> Any:
    """The value, which must be one."""
    if _broken(value):
        raise RefusedError("it has no value")
    return number(value)


def _chained(a: Matrix, b: Matrix) -> bool:
    return a.cols == b.rows or shape(a) == shape(b) == (4, 1)


def _broken(*values: Any) -> bool:
    return any(isinstance(value, Broken) for value in values)


def divided(a: Any, b: Any) -> Any:
    b = number(b)
    if isinstance(b, Matrix) or _broken(a, b):
        raise RefusedError("divided by a matrix")
    if arb(b).contains(0):
        raise RefusedError("divided by 0")
    return exact(a) / exact(b)


def exact(value: Any) -> Any:
    return arb(value) if isinstance(value, int) else value


def root(value: Any) -> Any:
    if isinstance(value, Matrix):
        raise RefusedError("the root of a matrix")
    return sqrt(value)


def quaternion(p: Matrix, q: Matrix) -> Matrix:
    """Hamilton's product, scalar part first."""
    a, b, c, d = p
    left = [[a, -b, -c, -d], [b, a, -d, c], [c, d, a, -b], [d, -c, b, a]]
    return Matrix(left) * q


def turning(value: Any) -> Matrix:
    if shape(value) != (3, 1):
        raise RefusedError("a cross product without a vector")
    x, y, z = value
    return Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def raised(value: Any, power: Any) -> Any:
    value = whole(value)
    if power in ("T", "∨"):
        if not isinstance(value, Matrix) or (power == "∨" and shape(value) != (3, 3)):
            raise RefusedError(f"{power} of a number")
        M = value
        return M.T if power == "T" else Matrix([M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]]) / 2
    if isinstance(power, tuple):
        if isinstance(value, Matrix):
            raise RefusedError("a root of a matrix")
        return arb(value) ** (arb(power[0]) / power[1])
    if not power or (isinstance(value, Matrix) and value.rows != value.cols and shape(value) != (4, 1)):
        raise RefusedError("a power of what is not square")
    result = reduce(times, [value] * abs(power))
    if power > 0:
        return result
    return result.inv() if isinstance(result, Matrix) else divided(1, result)


def assembled(rows: list[list]) -> Any:
    """A matrix of numbers or of blocks, of which a 0 has any shape."""
    if len({len(row) for row in rows}) != 1 or not rows[0]:
        raise RefusedError("the rows of a matrix are not equally long")
    if any(_broken(*row) for row in rows):
        raise RefusedError("an entry has no value")
    sizes = [[shape(value) for value in row] for row in rows]
    if not any(size for row in sizes for size in row):
        return Matrix(rows)

    def extents(lines: Iterable, axis: int) -> list[int] | None:
        found = []
        for line in lines:
            known = {(size or (1, 1))[axis] for size, value in line if size or not _is_zero(value)} or {1}
            found.append(known.pop() if len(known) == 1 else 0)
        return found if all(found) else None

    paired = [list(zip(a, b, strict=True)) for a, b in zip(sizes, rows, strict=True)]
    heights, widths = extents(paired, 0), extents(zip(*paired, strict=True), 1)
    if heights is None or widths is None:
        return Broken(f"{len(rows)} rows", tuple(value for row in rows for value in row))
    result = zeros(sum(heights), sum(widths))
    for i, row in enumerate(rows):
        for j, value in enumerate(row):
            if sizes[i][j] or not _is_zero(value):
                top, left = sum(heights[:i]), sum(widths[:j])
                result[top : top + heights[i], left : left + widths[j]] = value
    return result


def _is_zero(value: Any) -> bool:
    return isinstance(value, int) and value == 0


FUNCTIONS: dict[str, Callable] = {
    "sin": sin, "cos": cos, "tan": tan, "√": root, "ln": numbers.log, "arcsin": numbers.asin, "arccos": numbers.acos,
    "arctan": numbers.atan, "sinh": numbers.sinh, "cosh": numbers.cosh, "tanh": numbers.tanh,
    "exp": lambda value: value.exp() if isinstance(value, Matrix) else arb(value).exp(),
}  # fmt: skip


def equal(a: Any, b: Any) -> bool:
    """Whether two values are the same, as far as the balls can tell."""
    a, b = number(a), number(b)
    if _broken(a) or _broken(b):
        same = isinstance(a, Broken) and isinstance(b, Broken) and a.operation == b.operation
        return same and len(a.parts) == len(b.parts) and all(map(equal, a.parts, b.parts))
    if shape(a) != shape(b):
        return False
    pairs = zip(a, b, strict=True) if isinstance(a, Matrix) else [(a, b)]
    return all(_same(arb(x), arb(y)) for x, y in pairs)


def _same(x: arb, y: arb) -> bool:
    """Whether they agree to 12 digits at least; a ball that is too wide to tell does not."""
    return bool(x.overlaps(y) and (x - y).rad() < 1e-12 * (1 + abs(y.mid())))
