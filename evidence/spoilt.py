"""Formulas as they are shown against what was judged, at free random numbers; and every single change of a formula."""

import random
import re
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property, reduce
from html import escape
from itertools import pairwise, product
from pathlib import Path
from typing import Any

from flint import arb
from sympy import Add, MatAdd, MatMul, Mul, Symbol
from sympy.core.function import AppliedUndef
from sympy.matrices import MatrixBase

from boresight.derive.ledger.equation import Quantity, Relation, children
from boresight.derive.ledger.evaluate import OPERATORS, Point, evaluate
from boresight.derive.ledger.latex import latex_relation
from boresight.derive.ledger.numbers import Matrix, digits, norm
from boresight.derive.ledger.text import text_relation
from boresight.derive.pages.mathml import mathml_relation
from boresight.derive.papers import PAPERS, paper
from boresight.evidence.formula_tokens import (
    Node,
    RefusedError,
    Row,
    Spelling,
    latex_tokens,
    mathml_tokens,
    parsed,
    spelling,
    text_tokens,
)
from boresight.evidence.read_back import Broken, Formula, Values, equal, plus, times
from boresight.evidence.sources import Derivations

DIGITS = 30
DRAWS = 40  # of the letters, until every side has a value: not all may stand below a root or in a logarithm
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
    def judged(self) -> tuple[list, list, Values]:
        """The values of the sides, those of the matrices in them, and the free values at which they were computed."""
        shapes: dict[str, tuple[int, ...]] = {q.symbol.name: q.shape for q in self.quantities if not q.function}
        results = {name: () if commutes else (3, 3) for name, commutes in self.heads.items()}
        results |= {
            q.symbol.name: q.shape for q in self.quantities if q.function and q.shape and q.symbol.name in results
        }
        unknown = [name for name in self.symbols if name not in shapes]
        choices = [SHAPES[:: -1 if self.symbols[name].is_commutative else 1] for name in unknown]
        failed: Exception = ValueError()
        with digits(DIGITS):
            for found in product(*choices):
                known = {**shapes, **dict(zip(unknown, found, strict=True))}
                try:
                    for draw in range(DRAWS):
                        values = free(known, results, list(self.symbols), "'" * draw)
                        sides = [judged_value(side, values) for side in self.relation.sides]
                        if all(map(has_value, sides)):
                            break
                except (ValueError, TypeError) as error:
                    failed = error
                    continue
                if not unknown or all(alike(a, b) for a, b in pairwise(sides)):
                    return sides, [judged_value(node, values) for node in matrices(self.relation.sides)], values
        raise failed

    def tokens(self, form: str, text: str) -> Row:
        if form == "text":
            return text_tokens(text, tuple(self.spelled.text))
        return latex_tokens(text) if form == "latex" else mathml_tokens(text)

    def holds(self, form: str, text: str) -> bool:
        """Whether what is shown is what was judged.  Raises RefusedError."""
        row = self.tokens(form, text)
        with digits(DIGITS):
            sides, matrices, values = self.judged
            formula = Formula(row, self.spelled, values, self.symbols)
            try:
                found = formula.sides()
            except (ValueError, ZeroDivisionError) as error:
                raise RefusedError(str(error)) from error
            same = len(found) == len(sides) and len(formula.matrices) == len(matrices)
            return same and all(map(equal, [*found, *formula.matrices], [*sides, *matrices]))


def matrices(expressions: Iterable) -> Iterator:
    """The matrices that are written out, as one reads them; each after those within it."""
    for node in expressions:
        yield from matrices(children(node))
        row = isinstance(node, AppliedUndef) and node.func.__name__ == "row"
        if row or (isinstance(node, MatrixBase) and node.shape != (1, 1)):
            yield node


def nodes(relation: Relation) -> Iterator:
    queue = list(relation.sides)
    while queue:
        node = queue.pop()
        yield node
        queue += children(node)


def alike(a: Any, b: Any) -> bool:
    shapes = [(v.rows, v.cols) if isinstance(v, Matrix) else (1, 1) for v in (a, b)]
    return shapes[0] == shapes[1] or 0 in (a, b)


def has_value(value: Any) -> bool:
    if isinstance(value, Broken):
        return all(map(has_value, value.parts))
    return all(arb(entry).is_finite() for entry in (value if isinstance(value, Matrix) else [value]))


def free(
    shapes: Mapping[str, tuple[int, ...]],
    results: Mapping[str, tuple[int, ...]],
    present: Iterable[str],
    draw: str = "",
) -> Values:
    """Every letter drawn by itself; a function is a random linear one of its arguments, with a value of its shape.

    draw: another gives other letters.
    """
    letters = {name: drawn(name + draw, shape) for name, shape in shapes.items()}
    samples = tuple({**letters, **{name: drawn(f"{name} at {i}", shapes[name]) for name in present}} for i in range(3))
    scattered = {name: (drawn(f"{name} 1", shapes[name]), drawn(f"{name} 2", shapes[name])) for name in present}
    functions = {name: linear(name, (6,) if name == "samples" else shape) for name, shape in results.items()}
    return Values(letters, functions, samples, scattered)


@cache
def drawn(name: str, shape: tuple[int, ...]) -> Any:
    generator = random.Random(name)
    rows, columns = (*shape, 1, 1)[:2]
    numbers = [[arb(generator.randint(200, 1200)) / 997 for _ in range(columns)] for _ in range(rows)]
    return Matrix(numbers) if shape else numbers[0][0]


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


def rendered(shown: Shown, form: str, marks: Collection[tuple[int, ...]] = ()) -> str:
    """As the pages have it; text is 94 columns wide, for it is indented."""
    return WRITERS[form](shown.relation, shown.quantities, *([94] if form == "text" else []), marks)


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


# ---- Every single change ---------------------------------------------------------------------------------------------

# What a sign, a function, or a word of LaTeX may be taken for.
CONFUSED = (
    "+|- −|+ (|) [|] {|} _|^ =|< ⋅|× /|⋅ ∨|T φ|ψ φ|ϕ ε|e δ|Δ v|ν ω|w θ|Θ Φ|Ψ 0|O l|1 i|e b|n e|n x|y y|z n|r 1|2 2|3 "
    "3|4 0|2 \u0302|\u0307 \u0302|\u0304 ^|˙ ^|¯ sin|cos cos|tan"
)
WORDS = (
    r"\hat|\dot \hat|\bar \dot|\bar \sin|\cos \cos|\tan \phi|\psi \phi|\varphi \phi|\Phi \delta|\Delta "
    r"\theta|\Theta \omega|\Omega \psi|\Psi \nu|v \,|+ \times|\, \leq|< \dot| \hat| \left| \right|"
)
INSERTED = {"latex": "()-2_^'{}", "text": "()-2_^'⋅\u0302\u0307", "mathml": ""}


def others(sign: str) -> list[str]:
    """What a sign may be taken for: of another case, the next digit, one that looks alike."""
    found = taken_for(CONFUSED, sign)
    return [*dict.fromkeys([*found, *([sign.swapcase()] if sign.isalpha() else [])])]


def taken_for(pairs: str, word: str) -> list[str]:
    split = (pair.split("|") for pair in pairs.split())
    return [one if word == other else other for one, other in split if word in (one, other)]


def changes(form: str, text: str) -> Iterator[tuple[str, str]]:
    """Every single change of a rendered formula, each once: what is done, and the formula after it."""
    seen = {text}
    for what, changed in _elements(text) if form == "mathml" else _characters(form, text):
        if changed not in seen:
            seen.add(changed)
            yield what, changed


def _characters(form: str, text: str) -> Iterator[tuple[str, str]]:
    for i, sign in enumerate(text):
        yield "drop", text[:i] + text[i + 1 :]
        yield "double", text[:i] + sign + text[i:]
        for other in others(sign):
            yield "exchange", text[:i] + other + text[i + 1 :]
        for more in INSERTED[form]:
            yield "insert", text[:i] + more + text[i:]
    for left, right in _pairs(text):
        yield "drop a pair", text[:left] + text[left + 1 : right] + text[right + 1 :]
    if form == "text":
        for match in re.finditer(r"sin|cos|tan", text):
            for other in others(match[0]):
                yield "exchange", text[: match.start()] + other + text[match.end() :]
        for match in re.finditer(r"_\w+|\{[^{}]*\}|\([^()]*\)", text):
            yield "drop", text[: match.start()] + text[match.end() :]
        return
    for match in re.finditer(r"\\[A-Za-z]+|\\.", text):
        before, after = text[: match.start()], text[match.end() :]
        yield "drop", before + after
        for word in taken_for(WORDS, match[0]):
            yield "exchange", before + word + after
    for match in re.finditer(r"\\(?:hat|dot|bar|check|overline)\{([^{}]*)\}|[_^](?:\{[^{}]*\}|\w)", text):
        yield "drop", text[: match.start()] + (match[1] or "") + text[match.end() :]
    for match in re.finditer(r"\\left\(((?:(?!\\left|\\right).)*)\\right\)", text):
        yield "drop a pair", text[: match.start()] + match[1] + text[match.end() :]
    for match in re.finditer(r"\\frac(\{[^{}]*\})(\{[^{}]*\})", text):
        yield "exchange", text[: match.start()] + r"\frac" + match[2] + match[1] + text[match.end() :]


def _pairs(text: str) -> Iterator[tuple[int, int]]:
    """Where a bracket opens and where it closes."""
    for left, right in (("(", ")"), ("[", "]"), ("{", "}")):
        opened: list[int] = []
        for i, sign in enumerate(text):
            if sign == left:
                opened.append(i)
            elif sign == right and opened:
                yield opened.pop(), i


def _elements(text: str) -> Iterator[tuple[str, str]]:
    """Of MathML, changes of its elements and of their texts."""
    root = parsed(text)
    spans: dict[int, tuple[int, int]] = {}
    text = _spanned(root, spans, 0)

    def with_(place: Node, *instead: Node) -> str:
        start, end = spans[id(place)]
        return text[:start] + "".join(_spanned(node, {}, 0) for node in instead) + text[end:]

    for node in _below(root):
        for child in node.children:
            yield "drop", with_(child)
            yield "double", with_(child, child, child)
            for sign in ("−", "(", ")") if node.tag in ("math", "mrow", "mtd") else ():
                yield "insert", with_(child, Node("mo", False, [], sign), child)
            if child.children:
                yield "unwrap", with_(child, *child.children)
                if child.tag not in ("mrow", "mtd"):  # what stands in a row may commute
                    yield "exchange", with_(child, Node(child.tag, False, child.children[::-1]))
                for part in child.children if child.tag not in ("mrow", "mtable") else ():
                    yield "unwrap", with_(child, part)
                if child.tag in ("msub", "msup"):
                    other = "msup" if child.tag == "msub" else "msub"
                    yield "exchange", with_(child, Node(other, False, child.children))
                if child.tag == "msubsup":
                    base, below, above = child.children
                    yield "exchange", with_(child, Node("msubsup", False, [base, above, below]))
                    yield "drop", with_(child, Node("msub", False, [base, below]))
                    yield "drop", with_(child, Node("msup", False, [base, above]))
            for other in others(child.text) if child.text else ():
                yield "exchange", with_(child, Node(child.tag, child.upright, [], other))
        for left, right in _fences(node.children):
            parts = node.children
            kept = [*parts[:left], *parts[left + 1 : right], *parts[right + 1 :]]
            yield "drop a pair", with_(node, Node(node.tag, False, kept))


def _fences(nodes_: list[Node]) -> Iterator[tuple[int, int]]:
    for pair in ("()", "[]", "‖", "{}"):
        found = [i for i, node in enumerate(nodes_) if node.text and node.text in pair]
        yield from zip(found[::2], found[1::2], strict=False)


def _below(node: Node) -> Iterator[Node]:
    yield node
    for child in node.children:
        yield from _below(child)


def _spanned(node: Node, spans: dict[int, tuple[int, int]], start: int) -> str:
    """The node as HTML; where it and those below it stand in the text goes into `spans`."""
    upright = ' mathvariant="normal"' if node.upright else ""
    html = f"<{node.tag}{upright}>{escape(node.text)}"
    for child in node.children:
        html += _spanned(child, spans, start + len(html))
    html += f"</{node.tag}>"
    spans[id(node)] = (start, start + len(html))
    return html


REFUSED, UNEQUAL = "refused", "unequal"
SAME, BRACKET = "the same signs", "a bracket that changes nothing"
EVEN = "a minus that changes no value"
VALUE = "the same value"


def outcome(shown: Shown, form: str, text: str, changed: str) -> str:
    """What becomes of a changed formula; where it is taken for the judged one, why."""
    try:
        if not shown.holds(form, changed):
            return UNEQUAL
    except RefusedError:
        return REFUSED
    before, after = shown.tokens(form, text), shown.tokens(form, changed)
    if before == after:
        return SAME
    if _without("()", before) == _without("()", after):
        return BRACKET
    return EVEN if _without("()-", before) == _without("()-", after) else VALUE


def _without(signs: str, row: Any) -> Any:
    """The row and those in it without some signs."""
    if isinstance(row, tuple):
        return tuple(_without(signs, part) for part in row if part not in [("sign", sign) for sign in signs])
    return row


def places(node: Any, at: tuple[int, ...] = ()) -> Iterator[tuple[int, ...]]:
    """Every place of a relation that can be marked."""
    for i, child in enumerate(node.sides if isinstance(node, Relation) else children(node)):
        yield (*at, i)
        yield from places(child, (*at, i))


def spoilt(of: Derivations, out: Path) -> dict[str, dict[str, Any]]:
    """By format: how many formulas of a paper are read back, also with a place marked; and every change of each.

    same: changes that are taken for the judged formula, by their reason; left: those that have none.
    """
    found: dict[str, dict[str, Any]] = {}
    for form in WRITERS:
        outcomes: Counter[str] = Counter()
        left, wrong, marked = [], [], 0
        formulas = of_paper(of.name)
        for one in formulas:
            text = rendered(one, form)
            for place in places(one.relation):
                marked += 1
                if outcome(one, form, text, rendered(one, form, {place})) != SAME:
                    wrong.append(f"{one.where}, {place} marked")
            for what, changed in changes(form, text):
                outcomes[result := outcome(one, form, text, changed)] += 1
                if result == VALUE:
                    left.append(f"{one.where}, {what}: {changed}")
        found[form] = {
            "formulas": len(formulas), "marked": marked, "wrong": wrong, "tried": outcomes.total(),
            "refused": outcomes[REFUSED], "unequal": outcomes[UNEQUAL],
            "same": {reason: outcomes[reason] for reason in (SAME, BRACKET, EVEN)}, "left": left,
        }  # fmt: skip
    return found
