"""Passages: the operation that leads from one line of a derivation to the next, carried out at free values.

At the witness both sides of true lines agree, so a wrong inference between two of them would pass.  Here the letters
are free: the operation is done to the numbers of the line before, and what results must be the numbers of the line
after, side by side.
"""

from collections.abc import Callable, Sequence
from itertools import pairwise, zip_longest
from typing import Any

from flint import arb
from sympy import S, Symbol
from sympy.core.function import AppliedUndef
from sympy.matrices import MatrixBase

from boresight import BoresightError
from boresight.derive.ledger.equation import Equation, Passage, Relation
from boresight.derive.ledger.evaluate import OPERATORS, Point, evaluate, multiplied, power, residual, solve
from boresight.derive.ledger.free import free_point
from boresight.derive.ledger.judge import LineVerdict
from boresight.derive.ledger.numbers import Matrix, digits, entries, exact, eye, magnitude, sqrt, zeros
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.reader import read
from boresight.derive.ledger.witness import quaternion, rotation_vector

Replaced = dict[int, Relation]  # other relations of steps, by index

SEEDS = (11, 12)
WORKING = 100  # digits, of which differentiating takes 60
STEP = exact("1e-20")  # for differences: they err by its square, 1e-40
SAME = arb("1e-25")  # relative

# What leads from the line `of`, or the one before, to this one.
OPERATIONS = {
    "substitute": (
        "each of `using`, in order, gives its letter a value: its first side if that is a letter or a column of "
        "letters, else its last one; or the letter of `letters`, for which it, linear in it, is solved"
    ),
    "multiply": "each side, by the factors `with`, from the left and from the right",
    "add": "the term `with` is added to each side",
    "add line": "side by side",
    "subtract line": "side by side",
    "transpose": "each side",
    "invert": "each side",
    "rearrange": "terms change sides: left less right stays, but for its sign",
    "multiply out": (
        "each side is written otherwise: equal for all values of the letters of their classes; the identities "
        "`using` say why"
    ),
    "chain": "sides of the lines `using` are equal to one another, since the lines have a side in common",
    "expand": "each side in powers of `letters` together, through `order`",
    "leave out": "`letters` are set to zero",
    "differentiate": "each side by a parameter, on which `letters` depend with the rates `with`, letters or numbers",
    "carry over": "the same of another time, point or quantity: `with` stand in the place of `letters`, all at once",
    "take the vector": "of skew-symmetric sides their vectors",
    "take the skew-symmetric part": "of each side",
    "take rows": "rows of the sides, `with` their numbers, counted from 1",
    "take an entry": "`with` the numbers of its row and its column",
    "put in": (
        "the first side of each of `using`, a letter, is replaced by the last one, all at once, within expectations too"
    ),
    "find the minimum": (
        "the line, of which the left is the rate of a cost, is zero at the minimum, whatever the direction `letters`"
    ),
    "stack": "the line and those of `using` over one another: their first sides, and their last ones",
    "take the root": "the positive square root of each side",
    "identify": (
        "both sides are equal whatever the vector `letters` is: so are their derivatives by its components, a matrix"
    ),
    "take the rotation vector": "of rotations by less than half a turn",
    "take the quaternion": "of rotations; q and -q are one",
    "solve": "the line, linear in the letter `letters`, gives it",
}
NEEDS = {  # keys of a step in derivation.toml
    **dict.fromkeys(("substitute", "add line", "subtract line", "chain", "put in", "stack"), ("using",)),
    **dict.fromkeys(("multiply", "add", "take rows", "take an entry"), ("with",)),
    **dict.fromkeys(("expand", "leave out", "identify", "solve"), ("letters",)),
    **dict.fromkeys(("differentiate", "carry over"), ("letters", "with")),
}
RATE = r"write in `with` for each of `letters` its rate, one letter as \dot{x}, or a number"
# What each key says, for who leaves it out.
NEEDED = {
    "letters": r"letters = ['\delta x'], which it is about",
    "using": 'using = ["1"] or ["(2)"], the steps or equations that it takes in',
    "with": "with = ['...'], the factor, the term or the numbers of rows",
}


# ---- Carrying out ----------------------------------------------------------------------------------------------------


def judge_passage(
    paper: Paper, equation: Equation, index: int, replaced: dict[int, Relation] | None = None
) -> LineVerdict:
    """Whether the passage of step `index` leads to its line; `replaced`: other relations of steps, by index."""
    one = equation.derivation.steps[index]
    assert one.passage is not None
    try:
        with digits(WORKING):
            return _judged(paper, equation, index, one.passage, replaced or {})
    except (ValueError, KeyError, ZeroDivisionError, BoresightError, TypeError, IndexError) as error:
        return LineVerdict(False, f"{one.passage.operation}: {error.args[0] if error.args else error}")


def _judged(paper: Paper, equation: Equation, index: int, passage: Passage, replaced: Replaced) -> LineVerdict:
    def relation_of(label: str) -> Relation:
        return _relation(paper, equation, index, label, replaced)

    after = replaced.get(index, equation.derivation.steps[index].formulas[0])
    if passage.operation == "chain":
        lines = [relation_of(row) for row in passage.using]
        return _all(_chained(lines, after, free_point(paper, seed)) for seed in SEEDS)
    before = relation_of(passage.of)
    if passage.operation == "find the minimum":
        if len(after.sides) != 2:
            raise ValueError("the line has more than two sides")
        points = [free_point(paper, seed) for seed in SEEDS]
        # the line is the rate but for one number, the same wherever the letters are
        first, second = (_factor(_gradient(paper, passage, before, at), _difference(after, at)) for at in points)
        return _said(None not in (first, second) and _same([first], [second]), passage.operation)
    return _all(_leads(paper, passage, before, after, relation_of, free_point(paper, seed)) for seed in SEEDS)


def _all(verdicts) -> LineVerdict:
    for verdict in verdicts:
        if not verdict.holds:
            return verdict
    return verdict


def _relation(paper: Paper, equation: Equation, index: int, label: str, replaced: Replaced) -> Relation:
    steps = equation.derivation.steps
    if label.startswith("("):
        number, _, part = label.removeprefix("(").partition(")")
        derived = paper.equation(number).derived
        return derived[int(part.removeprefix(".")) - 1 if part else 0]
    if label:
        at = int(label) - 1
        if not 0 <= at < index:
            raise BoresightError(f"line {label} does not stand before line {index + 1}")
    else:
        at = equation.derivation.before(index)
    return replaced[at] if at in replaced else steps[at].formulas[0]


def _leads(paper: Paper, passage: Passage, before: Relation, after: Relation, relation_of, point: Point) -> LineVerdict:
    if passage.operation == "rearrange" and len(after.sides) != 2:
        raise ValueError("the line has more than two sides")
    for identity in passage.using if passage.operation == "multiply out" else ():
        if not _same(_difference(relation_of(identity), point), [0] * len(_difference(relation_of(identity), point))):
            raise ValueError(f"{identity} is no identity")
    if passage.operation == "rearrange":
        first, second = (_difference(relation, point) for relation in (before, after))
        holds = any(_same(first, [entry * sign for entry in second]) for sign in (1, -1))
        return _said(holds and not _same(first, [entry * 0 for entry in first]), passage.operation)
    if passage.operation == "solve":
        (letter,) = _symbols(paper, passage.letters)
        point = point.changed(_solved(paper, before, letter, point))
        if letter not in (after.sides[0], after.sides[-1]):
            return LineVerdict(False, f"solve: {letter} is no side of the line")
        if _depends(paper, Relation(tuple(s for s in after.sides if s != letter)), letter, point):
            return LineVerdict(False, f"solve: {letter} is on both sides")
        values = [entries(evaluate(side, point)) for side in after.sides]
        return _said(all(_same(a, b) for a, b in pairwise(values)), passage.operation)
    if before.sides == after.sides:
        return LineVerdict(False, f"{passage.operation}: the line before says the same")
    if passage.operation == "substitute":
        if len(passage.letters) > len(passage.using):
            raise ValueError("more letters than rows are named")
        rows = list(zip_longest(passage.using, passage.letters, fillvalue=""))
        verdict = _substituted(paper, rows, before, after, relation_of, point)
        for k, (row, _) in enumerate(rows):
            if verdict.holds and _substituted(paper, rows[:k] + rows[k + 1 :], before, after, relation_of, point).holds:
                return LineVerdict(False, f"substitute: it follows without {row}")
        return verdict
    return _follows(_carried(paper, passage, before, relation_of, point), after, point, passage.operation)


def _gradient(paper: Paper, passage: Passage, before: Relation, point: Point) -> list:
    """The right side, and along each unit of the direction."""
    if not isinstance(before.sides[0], Symbol):
        raise ValueError(f"{before.sides[0]} is no letter of a rate")
    if not passage.letters:
        return entries(evaluate(before.sides[-1], point))
    (direction,) = _symbols(paper, passage.letters)
    (size,) = paper.letter(direction.name).shape
    units = [Matrix([int(i == j) for j in range(size)]) for i in range(size)]
    rates = (evaluate(before.sides[-1], point.changed({direction.name: unit})) for unit in units)
    return [entry for rate in rates for entry in entries(rate)]


def _factor(a: list, b: list):
    """The number that is b / a, entry by entry; None if there is none."""
    k = max(range(len(a)), key=lambda i: magnitude(a[i]))
    if len(a) != len(b) or _same(a, [0] * len(a)) or _same([b[k]], [0]):
        return None
    return b[k] / a[k] if _same([entry * b[k] / a[k] for entry in a], b) else None


def _substituted(
    paper: Paper, rows: Sequence[tuple[str, str]], before: Relation, after: Relation, relation_of, point: Point
) -> LineVerdict:
    for row, letter in rows:
        point = point.changed(_given(paper, relation_of(row), letter, point))
    return _follows([evaluate(side, point) for side in before.sides], after, point, "substitute")


def _follows(values: list, after: Relation, point: Point, operation: str) -> LineVerdict:
    """Whether each side of the line after is one of the values, and not all of them are the same one."""
    sides = [entries(value) for value in values]
    targets = [entries(evaluate(side, point)) for side in after.sides]
    if operation == "take the quaternion":
        targets = [[-part for part in target] if target[0] < 0 else target for target in targets]
    places = [next((i for i, side in enumerate(sides) if _same(side, target)), None) for target in targets]
    if None in places:
        return _said(False, operation, f"side {places.index(None) + 1} does not follow")
    if all(_same(sides[0], side) for side in sides):  # an identity: its sides are one at free values
        return _said(True, operation)
    return _said(len(set(places)) > 1, operation, "one side follows, and no other")


def _carried(paper: Paper, passage: Passage, before: Relation, relation_of, point: Point) -> list:
    """The values of the sides of the line before, after the operation."""
    values = [evaluate(side, point) for side in before.sides]
    name = passage.operation
    if name == "multiply out":
        return values
    if name == "multiply":
        left, right = (_expression(paper, text) if text else None for text in passage.with_)
        if left is not None:
            values = [multiplied(evaluate(left, point), value) for value in values]
        return values if right is None else [multiplied(value, evaluate(right, point)) for value in values]
    if name == "add":
        term = evaluate(_expression(paper, passage.with_[0]), point)
        return [value + term for value in values]
    if name in ("add line", "subtract line"):
        sign = 1 if name == "add line" else -1
        other = [evaluate(side, point) for side in relation_of(passage.using[0]).sides]
        return [a + b * sign for a, b in zip((values[0], values[-1]), (other[0], other[-1]), strict=True)]
    if name == "stack":
        rows = [before, *(relation_of(row) for row in passage.using)]
        return [Matrix([e for row in rows for e in entries(evaluate(row.sides[i], point))]) for i in (0, -1)]
    if name == "identify":
        (letter,) = (symbol.name for symbol in _symbols(paper, passage.letters))
        return [_jacobian(side, letter, point) for side in before.sides]
    if name == "expand":
        letters = [symbol.name for symbol in _symbols(paper, passage.letters)]

        def scaled(s) -> Point:
            return point.changed({letter: point.values[letter] * s for letter in letters})

        return [_series(lambda s, side=side: evaluate(side, scaled(s)), passage.order) for side in before.sides]
    if name == "leave out":
        letters = [symbol.name for symbol in _symbols(paper, passage.letters)]
        return [evaluate(side, point.changed({x: point.values[x] * 0 for x in letters})) for side in before.sides]
    if name == "carry over":
        others = [_expression(paper, text) for text in passage.with_]
        named = _symbols(paper, passage.letters)
        for letter, other in zip(named, others, strict=True):
            if isinstance(other, Symbol) and paper.letter(other.name).kind != paper.letter(letter.name).kind:
                raise ValueError(f"{other} is another kind of quantity than {letter}")
        renamed = before.replaced(dict(zip(named, others, strict=True)))
        return [evaluate(side, point) for side in renamed.sides]
    if name == "put in":
        rows = [relation_of(row) for row in passage.using]
        for row in rows:
            if not any(row.sides[0] in side.free_symbols for side in before.sides):
                raise ValueError(f"{row.sides[0]} does not stand in the line")
        renamed = before.replaced({row.sides[0]: row.sides[-1] for row in rows})
        return [evaluate(side, point) for side in renamed.sides]
    if name == "differentiate":
        letters = [symbol.name for symbol in _symbols(paper, passage.letters)]
        try:
            given = [_expression(paper, rate) for rate in passage.with_]
        except BoresightError as error:
            raise ValueError(f"{str(error).removesuffix(': add it to the table')}: {RATE}") from None
        for latex, rate in zip(passage.with_, given, strict=True):
            if not (isinstance(rate, Symbol) or rate.is_Number):
                raise ValueError(f"{latex} is no letter: {RATE}")
        rates = [evaluate(rate, point) for rate in given]

        def shifted(t) -> Point:
            return point.changed({x: point.values[x] + r * t for x, r in zip(letters, rates, strict=True)})

        return [(evaluate(side, shifted(STEP)) - evaluate(side, shifted(-STEP))) / (2 * STEP) for side in before.sides]
    return [_TAKE[name](value, passage) for value in values]


def _jacobian(side, letter: str, point: Point) -> Matrix:
    """The derivative by the components of a letter, a column for each."""
    at, columns = point.values[letter], []
    for i in range(at.rows):
        unit = at * 0
        unit[i, 0] = STEP
        up, down = (entries(evaluate(side, point.changed({letter: at + unit * sign}))) for sign in (1, -1))
        columns.append([(a - b) / (2 * STEP) for a, b in zip(up, down, strict=True)])
    return Matrix([list(row) for row in zip(*columns, strict=True)])


def _series(function: Callable, order: int):
    """The Taylor polynomial in s at 0 through `order` (1 or 2), at s = 1."""
    up, down = function(STEP), function(-STEP)
    middle_value = (up + down) / 2  # right to STEP^2, also where the function is 0/0 at zero
    result = middle_value + (up - down) / (2 * STEP)
    if order == 2:
        up2, down2 = function(2 * STEP), function(-2 * STEP)
        result = result + (up2 + down2 - up - down) / (6 * STEP * STEP)
    return result


def _vector(value, passage: Passage):
    if max(map(magnitude, value + value.T)) > SAME:
        raise ValueError("a side is not skew-symmetric")
    return OPERATORS["vee"](value)


def _of_rotation(take: Callable) -> Callable:
    def taken(value, passage: Passage):
        if max(map(magnitude, value * value.T - eye(value.rows))) > SAME:
            raise ValueError("a side is no rotation")
        return take(value)

    return taken


_TAKE: dict[str, Callable] = {
    "take the root": lambda value, passage: sqrt(value),
    "take the rotation vector": _of_rotation(rotation_vector),
    "take the quaternion": _of_rotation(quaternion),
    "transpose": lambda value, passage: value.T,
    "invert": lambda value, passage: power(value, S.NegativeOne),
    "take the vector": _vector,
    "take the skew-symmetric part": lambda value, passage: (value - value.T) / 2,
    "take rows": lambda value, passage: Matrix([list(value[int(k) - 1, :]) for k in passage.with_]),
    "take an entry": lambda value, passage: value[int(passage.with_[0]) - 1, int(passage.with_[1]) - 1],
}


def _solved(paper: Paper, row: Relation, letter: Symbol, point: Point) -> dict[str, Any]:
    """The value of the letter by the row.  Raises ValueError unless the row is linear in it."""
    found = solve((row,), {letter.name: paper.letter(letter.name).shape or 1}, point.values)
    left = residual(row.sides, point.changed(found))
    if not _same(left, [0] * len(left)):
        raise ValueError(f"the line is not linear in {letter}")
    return found


def _given(paper: Paper, row: Relation, letter: str, point: Point) -> dict[str, Any]:
    """Values of the letter, or letters, that a row gives."""
    if letter:
        (symbol,) = _symbols(paper, (letter,))
        for side, other in ((row.sides[0], row.sides[-1]), (row.sides[-1], row.sides[0])):
            if side == symbol:
                return {symbol.name: evaluate(other, point)}
        return _solved(paper, row, symbol, point)
    for side, other in ((row.sides[0], row.sides[-1]), (row.sides[-1], row.sides[0])):
        if isinstance(side, Symbol):
            shape = paper.letter(side.name).shape
            return {side.name: zeros(*(*shape, 1)[:2]) if shape and other == 0 else evaluate(other, point)}
        if isinstance(side, AppliedUndef) and side.func.__name__ not in OPERATORS:
            value = evaluate(other, point)
            return {side.func.__name__: lambda *arguments, value=value: value}
        if isinstance(side, MatrixBase) and all(isinstance(entry, Symbol) for entry in side):
            return {entry.name: value for entry, value in zip(side, evaluate(other, point), strict=True)}
    raise ValueError("the row gives no letter: name the letter for which it is solved")


def _chained(lines: list[Relation], after: Relation, point: Point) -> LineVerdict:
    """Sides of one value at free letters are one; each line ties its sides together."""
    groups: list[list] = []
    for relation in lines:
        sides = [entries(evaluate(side, point)) for side in relation.sides]
        meeting = [group for group in groups if any(_same(a, b) for a in group for b in sides)]
        groups = [group for group in groups if group not in meeting] + [
            [one for group in meeting for one in group] + sides
        ]
    targets = [entries(evaluate(side, point)) for side in after.sides]
    holds = any(all(any(_same(a, b) for b in group) for a in targets) for group in groups)
    trivial = all(_same(a, b) for a, b in pairwise(targets))
    return LineVerdict(
        holds and not trivial, "" if holds and not trivial else "chain: the lines do not tie these sides"
    )


def _said(holds: bool, operation: str, why: str = "it does not follow") -> LineVerdict:
    return LineVerdict(holds, "" if holds else f"{operation}: {why}")


def _depends(paper: Paper, relation: Relation, letter: Symbol, point: Point) -> bool:
    return any(letter in getattr(side, "free_symbols", ()) for side in relation.sides)


def _difference(relation: Relation, point: Point) -> list:
    return residual((relation.sides[0], relation.sides[-1]), point)


def _same(a: Sequence, b: Sequence) -> bool:
    if len(a) != len(b):
        return len(b) == 1 and bool(b[0] == 0) and _same(a, [0] * len(a))
    size = max(arb(1), *map(magnitude, (*a, *b)))
    return all(magnitude(x - y) < SAME * size for x, y in zip(a, b, strict=True))


def _symbols(paper: Paper, letters: Sequence[str]) -> list[Symbol]:
    result = [_expression(paper, letter) for letter in letters]
    for letter, symbol in zip(letters, result, strict=True):
        if not isinstance(symbol, Symbol):
            raise BoresightError(f"{letter!r} is no letter")
    return result


def _expression(paper: Paper, latex: str):
    (relation,) = read((latex,), (*paper.quantities(), *paper.letters()))
    return relation.sides[0]
