"""Lines of derivations and passages between them, as a test writes them."""

from collections.abc import Sequence

from boresight.derive.ledger.equation import Claim, Line, Passage

EXACT_LINE = Claim("exact")
DEFINITION = Claim("definition")
IDENTITY = Claim("identity")


def first_order(*small: str) -> Claim:
    """Right to first order in these parts of the conditions; in the equation's own if none is named."""
    return Claim("first-order", small)


def of_order(order: int, *small: str) -> Claim:
    """Right through this order in these parts together; in the equation's own if none is named."""
    return Claim("order", small, order)


def limit(*small: str) -> Claim:
    """A limit: what differs vanishes with these parts."""
    return Claim("limit", small)


def approximately(dropped: str, condition: str, *small: str) -> Claim:
    """Right, exactly or to first order in the parts `small` if any, with the term `dropped` (LaTeX) on its right."""
    return Claim("approximation", small, dropped=dropped, condition=condition)


def line(latex: str, claim: Claim, why: str, passage: Passage | None = None, *, result: bool = False) -> Line:
    return Line(latex, claim, why, passage, result)


def prose(why: str) -> Line:
    """A remark: it proves nothing."""
    return Line("", None, why)


# ---- Passages --------------------------------------------------------------------------------------------------------


def substitute(*rows: str, of: str = "", letters: Sequence[str] = ()) -> Passage:
    """Each row, in order, gives its letter a value: its first side if that is a letter or a column of letters, else its
    last one; or the letter named, for which the row, linear in it, is solved."""
    return Passage("substitute", of, rows, tuple(letters))


def multiply(*, left: str = "", right: str = "", of: str = "") -> Passage:
    return Passage("multiply", of, with_=(left, right))


def add(term: str, *, of: str = "") -> Passage:
    """The term is added to each side."""
    return Passage("add", of, with_=(term,))


def add_line(row: str, *, of: str = "") -> Passage:
    """Side by side."""
    return Passage("add line", of, (row,))


def subtract_line(row: str, *, of: str = "") -> Passage:
    """Side by side."""
    return Passage("subtract line", of, (row,))


def transpose(of: str = "") -> Passage:
    return Passage("transpose", of)


def invert(of: str = "") -> Passage:
    return Passage("invert", of)


def rearrange(of: str = "") -> Passage:
    """Terms change sides: left less right stays, but for its sign."""
    return Passage("rearrange", of)


def multiply_out(*identities: str, of: str = "") -> Passage:
    """Each side is written otherwise: equal for all values of the letters of their classes; `identities` say why."""
    return Passage("multiply out", of, identities)


def chain(*rows: str) -> Passage:
    """Sides of several lines are equal to one another, since the lines have a side in common."""
    return Passage("chain", "", rows)


def expand(*letters: str, order: int = 1, of: str = "") -> Passage:
    """Each side in powers of the letters together, through `order`."""
    return Passage("expand", of, (), letters, order=order)


def leave_out(*letters: str, of: str = "") -> Passage:
    """The letters are set to zero."""
    return Passage("leave out", of, (), letters)


def differentiate(rates: dict[str, str], of: str = "") -> Passage:
    """Each side by a parameter, on which the letters depend with these rates, letters or numbers; both in LaTeX."""
    return Passage("differentiate", of, (), tuple(rates), tuple(rates.values()))


def elsewhere(letters: dict[str, str], of: str = "") -> Passage:
    """The same of another time, point or quantity: other letters, all at once, stand in the place of these."""
    return Passage("carry over", of, (), tuple(letters), tuple(letters.values()))


def take_vector(of: str = "") -> Passage:
    """Of skew-symmetric sides their vectors."""
    return Passage("take the vector", of)


def take_skew_part(of: str = "") -> Passage:
    return Passage("take the skew-symmetric part", of)


def take_rows(*numbers: int, of: str = "") -> Passage:
    """Rows of the sides, counted from 1."""
    return Passage("take rows", of, with_=tuple(map(str, numbers)))


def take_entry(row: int, column: int, of: str = "") -> Passage:
    return Passage("take an entry", of, with_=(str(row), str(column)))


def put_in(*rows: str, of: str = "") -> Passage:
    """The first side of each row, a letter, is replaced by the last one, all at once, within expectations too."""
    return Passage("put in", of, rows)


def find_minimum(direction: str = "", of: str = "") -> Passage:
    """The line before, of which the left is the rate of a cost, is zero at the minimum, whatever the direction."""
    return Passage("find the minimum", of, (), (direction,) if direction else ())


def stack(first: str, *others: str) -> Passage:
    """The lines over one another: their first sides, and their last ones."""
    return Passage("stack", first, others)


def take_root(of: str = "") -> Passage:
    """The positive square root of each side."""
    return Passage("take the root", of)


def identify(letter: str, of: str = "") -> Passage:
    """Both sides are equal whatever the letter, a vector, is: so are their derivatives by its components, a matrix."""
    return Passage("identify", of, (), (letter,))


def take_rotation_vector(of: str = "") -> Passage:
    """Of rotations by less than half a turn their rotation vectors."""
    return Passage("take the rotation vector", of)


def take_quaternion(of: str = "") -> Passage:
    """Of rotations their quaternions; q and -q are one."""
    return Passage("take the quaternion", of)


def solve_for(letter: str, of: str = "") -> Passage:
    """The line before, linear in the letter, gives it."""
    return Passage("solve", of, (), (letter,))
