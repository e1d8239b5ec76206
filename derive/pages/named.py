"""A model's expressions as a page shows them: letters for the names of its quantities, its constants and its inputs,
and for long numbers."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import count
from typing import Any

from sympy import Basic, Function, ImmutableMatrix, Matrix, Pow, S, Symbol

from boresight.derive.checks import expressions
from boresight.derive.constant import Constant, behind
from boresight.derive.expressions import constants_in, names_in, quantities_in
from boresight.derive.model import Model, Variable
from boresight.derive.named import Named as Entry
from boresight.derive.named import distinct

SMALL = 1000  # numerator and denominator of a number that is shown as it is
crossed = Function("skew", commutative=False)  # [v x], the matrix of the cross product


@dataclass(frozen=True)
class Named:
    """A letter that stands for an expression.

    letter: as a whole, a matrix or a vector or a number.  entries: its scalars, row by row.  value: what they are, in
    letters that come before.  shown: of a constant, its value as a reader wants it, perhaps as text.
    """

    letter: Symbol
    meaning: str
    value: ImmutableMatrix
    entries: ImmutableMatrix
    shown: Any = None

    @property
    def constant(self) -> bool:
        return self.shown is not None

    @property
    def letters(self) -> set[Symbol]:
        """Those that are its own."""
        return {self.letter, *(s for s, v in zip(self.entries, self.value, strict=True) if s != v)}


def constant(name: str, value: Any, meaning: str, shown: Any) -> Named:
    letter = Symbol(name, positive=True)
    return Named(letter, meaning, ImmutableMatrix([[value]]), ImmutableMatrix([[letter]]), shown)


def letter_of(one: Constant) -> Symbol:
    return Symbol(one.name, positive=True)


class Letters:
    """Puts letters into expressions; each part is looked at once."""

    def __init__(self, letters: dict[Any, Any]):
        self.known = letters

    def __call__(self, part: Any) -> Any:
        if part not in self.known:
            self.known[part] = rebuilt(part, [self(argument) for argument in part.args])
        return self.known[part]

    def matrix(self, matrix: Any) -> ImmutableMatrix:
        return ImmutableMatrix(matrix.applyfunc(self))


def rebuilt(expression, arguments: list):
    """The node with other arguments, which SymPy does not search for a simpler form: that takes seconds."""
    if all(new is old for new, old in zip(arguments, expression.args, strict=True)):
        return expression
    if expression.is_Add or expression.is_Mul:
        return expression.func(*arguments)
    if expression.is_Pow:
        return power(*arguments)
    return Basic.__new__(expression.func, *arguments)


def power(base, exponent):
    return Pow(base, exponent, evaluate=not base.is_Add or exponent is S.One)


def nodes(matrices: Iterable[Any]) -> list:
    """Every expression within the matrices, once, inner ones first."""
    seen: dict = {}

    def visit(expression) -> None:
        stack = [(expression, False)]
        while stack:
            part, left = stack.pop()
            if left:
                seen[part] = True
            elif part not in seen:
                stack.append((part, True))
                stack += [(argument, False) for argument in part.args if argument not in seen]

    for matrix in matrices:
        for entry in matrix:
            visit(entry)
    return list(seen)


def operations(expressions: Iterable[Any]) -> int:
    """How many operations a reader sees where they are written out."""
    expressions = list(expressions)
    seen: dict[Any, int] = {}
    for node in nodes([expressions]):
        seen[node] = sum(seen[part] for part in node.args) + len(node.args) - 1 + node.is_Function if node.args else 0
    return sum(seen[part] for part in expressions)


@dataclass
class Naming:
    """The expressions of a model in letters, group by group, and what the letters are.

    vectors: states and inputs by name.  named: all others, each after those in its value.
    """

    groups: dict[str, ImmutableMatrix]
    vectors: dict[str, Named]
    named: list[Named] = field(default_factory=list)


def naming(model: Model, groups: dict[str, Matrix]) -> Naming:
    called = component_letters(model)
    vectors = {}
    for v in (*model.states, *model.inputs):
        entries = ImmutableMatrix([called[s] for s in v.symbols])
        vectors[v.name] = Named(Symbol(v.name, commutative=v.size == 1), v.meaning, entries, entries)
    quantities = quantities_in(*groups.values())
    numbers = behind(constants_in(*groups.values(), *(one.value for one in quantities)))
    put = Letters({**called, **{one: letter_of(one) for one in numbers}})
    named = [
        constant(
            one.name,
            one.exact,
            one.meaning + f", {one.unit}" * (one.unit != "1"),
            _decimal(one.value) if one.value.is_Rational else put(one.value),
        )
        for one in numbers
    ]
    own = [entry for one in quantities for entry in one.entries if isinstance(entry, Entry) and entry.quantity is one]
    put.known |= {entry: Symbol(name) for entry, name in distinct(own).items()}
    count_of: dict[str, int] = {}
    for one in quantities:
        count_of[one.name] = count_of.get(one.name, 0) + 1
        whole = one.name + f"_{count_of[one.name]}" * (count_of[one.name] > 1)
        letter = Symbol(whole, commutative=one.value.shape == (1, 1))
        named.append(Named(letter, one.meaning, put.matrix(one.value), put.matrix(one.entries)))
    return _numbers(Naming({key: put.matrix(matrix) for key, matrix in groups.items()}, vectors, named))


def component_letters(model: Model) -> dict[Symbol, Symbol]:
    """What each component is called: where v_n is a vector, its component along n is v_N, and so for all such axes."""
    every = (*model.states, *model.inputs)
    matrices = [item.matrix for item in expressions(model)]
    entries = names_in(*matrices)
    names = {v.name for v in every if v.size > 1} | {entry.quantity.name for entry in entries}
    kept = {one.name for one in behind(constants_in(*matrices))} | {entry.name for entry in entries}

    def axes(v: Variable) -> tuple[str, ...]:
        """Suffixes of the components, if they have some."""
        return tuple(s.name.rpartition("_")[2] for s in v.symbols) if all("_" in s.name for s in v.symbols) else ()

    clashing = {axes(v) for v in every if v.size > 1 and any(s.name in names for s in v.symbols)} - {()}

    def letter(v: Variable, s: Symbol) -> Symbol:
        if axes(v) not in clashing:
            return Symbol(s.name + "_0" * (s.name in kept))
        base, _, axis = s.name.rpartition("_")
        return Symbol(f"{base}_{axis.upper()}")

    return {s: letter(v, s) for v in every for s in v.symbols}


def _numbers(made: Naming) -> Naming:
    """Decimals for decimal numbers, and a letter of its own for any other long number."""
    own: dict = {}
    taken = {s.name for one in (*made.vectors.values(), *made.named) for s in one.letters}
    known: dict = {}

    def number(value):
        if abs(value.p) < SMALL and value.q < SMALL and value.q not in (100, 1000):
            return value
        if value.q == 1 and abs(value.p) < 10**9:
            return value
        if abs(value) not in own:
            name = next(name for i in count(len(own) + 1) if (name := f"c_{i}") not in taken)
            own[abs(value)] = constant(name, abs(value), "a number of the model", _decimal(abs(value)))
        return (-1 if value < 0 else 1) * own[abs(value)].letter

    def visit(part):
        if part not in known:
            if part.is_Rational:
                known[part] = number(part)
            elif part.is_Pow:
                known[part] = power(visit(part.base), part.exp)
            else:
                known[part] = rebuilt(part, [visit(argument) for argument in part.args])
        return known[part]

    groups = {key: matrix.applyfunc(visit) for key, matrix in made.groups.items()}
    named = [one if one.constant else replace(one, value=one.value.applyfunc(visit)) for one in made.named]
    return Naming(groups, made.vectors, named + list(own.values()))


def _decimal(value) -> str:
    """A decimal number where there is one of few digits, or one over it, else a fraction."""
    exact = Fraction(int(value.p), int(value.q))
    texts = (format(float(number), ".12g") for number in (exact, 1 / exact))
    text, below = texts
    return text if Fraction(text) == exact else f"1/{below}" if 1 / Fraction(below) == exact else str(exact)
