"""Formulas as they are shown against what was judged, at free random numbers; and every single change of a formula."""

import random
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, reduce
from itertools import pairwise, product
from typing import Any

from flint import arb
from sympy import Add, MatAdd, MatMul, Mul, Symbol
from sympy.core.function import AppliedUndef
from sympy.matrices import MatrixBase

from boresight.derive.ledger.equation import Quantity, Relation, children
from boresight.derive.ledger.evaluate import OPERATORS, Point, evaluate
from boresight.derive.ledger.numbers import Matrix, digits, norm
from boresight.derive.pages.latex import latex_relation
from boresight.derive.pages.mathml import mathml_relation
from boresight.derive.pages.text import text_relation
from boresight.derive.papers import PAPERS, paper
from boresight.evidence.read_back import (
    Broken,
    Formula,
    RefusedError,
    Row,
    Spelling,
    Values,
    equal,
    latex_tokens,
    mathml_tokens,
    plus,
    spelling,
    text_tokens,
    times,
)

DIGITS = 30
WRITERS: dict[str, Callable[..., str]] = {"latex": latex_relation, "mathml": mathml_relation, "text": text_relation}
INNER = {"Σ", "norm", "entry", "row", "E", *OPERATORS}  # functions that have a sign of their own
SHAPES: tuple[tuple[int, ...], ...] = ((3, 3), (3,), (4, 4), (4,), (15, 15), (15,), ())


@dataclass(frozen=True, eq=False)
class Shown:
    """One relation of a paper or a page, and the letters in which it is shown."""

    where: str
    relation: Relation
    quantities: tuple[Quantity, ...]

    @cached_property
    def symbols(self) -> dict[str, Symbol]:
        return {node.name: node for node in nodes(self.relation) if isinstance(node, Symbol)}

    @cached_property
    def heads(self) -> dict[str, bool]:
        """The functions that are letters with arguments, and whether their values commute."""
        calls = (node for node in nodes(self.relation) if isinstance(node, AppliedUndef))
        return {node.func.__name__: bool(node.is_commutative) for node in calls if node.func.__name__ not in INNER}

    @cached_property
    def spelled(self) -> Spelling:
        latex = {q.symbol.name + "(" * q.function: q.latex for q in self.quantities}
        names = [q.symbol.name for q in self.quantities if not q.function]
        return spelling(dict.fromkeys([*names, *self.symbols]), self.heads.keys() - {"samples"}, latex)

    @cached_property
    def judged(self) -> tuple[list, Values]:
        """The values of the sides, and the free values of the letters at which they were computed."""
        shapes: dict[str, tuple[int, ...]] = {q.symbol.name: q.shape for q in self.quantities if not q.function}
        unknown = [name for name in self.symbols if name not in shapes]
        choices = [SHAPES[:: -1 if self.symbols[name].is_commutative else 1] for name in unknown]
        failed: Exception = ValueError()
        with digits(DIGITS):
            for found in product(*choices):
                values = free({**shapes, **dict(zip(unknown, found, strict=True))}, self.heads, list(self.symbols))
                try:
                    sides = [judged_value(side, values) for side in self.relation.sides]
                except (ValueError, TypeError) as error:
                    failed = error
                    continue
                if not unknown or all(alike(a, b) for a, b in pairwise(sides)):
                    return sides, values
        raise failed

    def tokens(self, form: str, text: str) -> Row:
        if form == "text":
            return text_tokens(text, tuple(self.spelled.text))
        return latex_tokens(text) if form == "latex" else mathml_tokens(text)

    def read_back(self, form: str, text: str) -> list:
        """The values of the sides of a rendered formula.  Raises RefusedError."""
        row = self.tokens(form, text)
        with digits(DIGITS):
            try:
                return Formula(row, self.spelled, self.judged[1], self.symbols).sides()
            except (ValueError, ZeroDivisionError) as error:
                raise RefusedError(str(error)) from error

    def holds(self, form: str, text: str) -> bool:
        """Whether what is shown is what was judged.  Raises RefusedError."""
        values, judged = self.read_back(form, text), self.judged[0]
        return len(values) == len(judged) and all(map(equal, values, judged))


def nodes(relation: Relation) -> Iterator:
    queue = list(relation.sides)
    while queue:
        node = queue.pop()
        yield node
        queue += children(node)


def alike(a: Any, b: Any) -> bool:
    shapes = [(v.rows, v.cols) if isinstance(v, Matrix) else (1, 1) for v in (a, b)]
    return shapes[0] == shapes[1] or 0 in (a, b)


def free(shapes: Mapping[str, tuple[int, ...]], heads: Mapping[str, bool], present: Iterable[str]) -> Values:
    """Every letter drawn by itself; a function is a random linear one of its arguments."""
    generator = random.Random(1)

    def drawn(shape: tuple[int, ...]) -> Any:
        if not shape:
            return arb(generator.randint(200, 1200)) / 997
        rows, columns = (*shape, 1)[:2]
        return Matrix([[arb(generator.randint(200, 1200)) / 997 for _ in range(columns)] for _ in range(rows)])

    letters = {name: drawn(shape) for name, shape in shapes.items()}
    samples = tuple({**letters, **{name: drawn(shapes[name]) for name in present}} for _ in range(3))
    scattered = {name: (drawn(shapes[name]), drawn(shapes[name])) for name in present}
    functions = {
        name: linear(name, (6,) if name == "samples" else () if commutes else (3, 3))
        for name, commutes in heads.items()
    }
    return Values(letters, functions, samples, scattered)


def linear(name: str, shape: tuple[int, ...]) -> Any:
    rows, columns = (*shape, 1, 1)[:2]

    def function(*arguments: Any) -> Any:
        generator = random.Random(name)
        total = Matrix([[arb(0)] * columns for _ in range(rows)])
        for argument in arguments:
            for entry in argument if isinstance(argument, Matrix) else [argument]:
                direction = [[arb(generator.randint(1, 999)) for _ in range(columns)] for _ in range(rows)]
                total = total + Matrix(direction) * entry
        return total if shape else total[0, 0]

    return function


def judged_value(side: Any, values: Values) -> Any:
    """By the ledger's own evaluation; of a matrix whose blocks do not fit, block by block."""
    point = Point({
        **values.letters, **values.functions, "random": values.random, "norm": norm,
        "Σ": lambda given: [{**given, **sample} for sample in values.samples],
        "entry": lambda M, i, j: M[int(i) - 1, int(j) - 1], "row": lambda *numbers: Matrix([list(numbers)]),
    })  # fmt: skip
    return _in_parts(side, point)


def _in_parts(side: Any, point: Point) -> Any:
    """The value, or what has one where the print does not fit together."""
    if side.is_Relational:
        return Broken("<", tuple(evaluate(argument, point) for argument in side.args))
    try:
        return evaluate(side, point)
    except ValueError:
        if isinstance(side, MatrixBase):
            return Broken(f"{side.rows} rows", tuple(evaluate(cell, point) for cell in children(side)))
        if not isinstance(side, Add | MatAdd | Mul | MatMul):
            raise
        parts = (_in_parts(argument, point) for argument in side.args)
        return reduce(plus if isinstance(side, Add | MatAdd) else times, parts)


def rendered(shown: Shown, form: str) -> str:
    """As the pages have it; text is 94 columns wide, for it is indented."""
    return WRITERS[form](shown.relation, shown.quantities, *([94] if form == "text" else []))


def of_paper(name: str) -> list[Shown]:
    """Every formula of a paper, once."""
    found: dict[Relation, Shown] = {}
    for equation in paper(name).equations:
        steps = (relation for step in equation.derivation.steps for relation in step.formulas)
        for kind, relations in (
            ("printed", equation.printed),
            ("read", equation.read()),
            ("derived", equation.derived),
            ("line", steps),
        ):
            for relation in relations:
                found.setdefault(relation, Shown(f"{name} ({equation.number}) {kind}", relation, equation.alphabet))
    return list(found.values())


def of_papers() -> list[Shown]:
    return [shown for name in PAPERS for shown in of_paper(name)]
