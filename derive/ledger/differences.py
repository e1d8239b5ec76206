"""Where a print and its derivation differ: the kind of each slip, and where it may come from."""

import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from itertools import zip_longest

from sympy import Add, Function, MatAdd, MatMul, Mul, S, Symbol
from sympy.matrices import MatrixBase

from boresight.derive.ledger.equation import Equation, Relation, children, is_explicit, negative
from boresight.derive.ledger.judge import judge, names
from boresight.derive.ledger.paper import Paper

# Letters which a scanner, or a tired eye, takes for one another.
LOOK_ALIKE = ({"φ", "ψ"}, {"ε", "e", "p", "o"})


Place = tuple[int, ...]  # a relation, a side of it, then from node to node as `children` counts them


@dataclass(frozen=True)
class Difference:
    """Where print and derivation differ: what each has there; place: of the node in which they do, in both forms."""

    kind: str
    printed: object
    derived: object
    place: Place


def differences(printed: Iterable[Relation], derived: Iterable[Relation]) -> list[Difference]:
    """The places where two forms differ, found by walking both trees."""
    found: list[Difference] = []
    for i, (a, b) in enumerate(zip_longest(printed, derived)):
        if a is None:  # what more the derivation says is no slip of the print
            continue
        if b is None or len(a.sides) != len(b.sides):
            # A shorter chain of equalities is compared side by side as far as it goes.
            found.append(Difference("structure", a, b, (i,)))
        else:
            for j, (left, right) in enumerate(zip(a.sides, b.sides, strict=True)):
                found += _compare(left, right, (i, j))
    return found


def _compare(a, b, place: Place) -> list[Difference]:
    if a == b:
        return []
    matrices = isinstance(a, MatrixBase) and isinstance(b, MatrixBase)
    if matrices and a.shape != b.shape:
        return [Difference("shape", a, b, place)]
    if not matrices:
        if _equal(a, negative(b)):
            return [Difference("sign", a, b, place)]
        if isinstance(a, Symbol) and isinstance(b, Symbol):
            return [Difference("shape" if _sized(a) and _sized(b) else "letter", a, b, place)]
        letters = _swapped_letters(a, b)
        if letters:
            return [Difference("letter", x, y, place) for x, y in letters]
    if matrices or (getattr(a, "func", a) == getattr(b, "func", b) and a.args and len(a.args) == len(b.args)):
        pairs = enumerate(zip(children(a), children(b), strict=True))
        return [difference for i, (x, y) in pairs for difference in _compare(x, y, (*place, i))]
    return [Difference("structure", a, b, place)]


def marks(forms: Iterable[Relation], found: Iterable[Difference], which: str) -> list[set[Place]]:
    """For each relation of the forms, `printed` or `derived`, the places (side, child, ...) that differ from the other.

    A letter is marked wherever it stands in its node; of a sum or a product only the parts that the other lacks.
    """
    forms = tuple(forms)
    result = [set[Place]() for _ in forms]
    for difference in found:
        mine, other = difference.printed, difference.derived
        if which == "derived":
            mine, other = other, mine
        relation, *path = difference.place
        if not path or relation >= len(forms):
            continue  # chains of unequal length: no place of theirs is the wrong one
        node = forms[relation].sides[path[0]]
        for index in path[1:]:
            node = children(node)[index]
        for start in _standing(node, mine):
            result[relation] |= {(*path, *start, *rest) for rest in _own(mine, other)}
    return result


def deciding(equation: Equation) -> set[int]:
    """The indices of the steps in which what the print has otherwise first stands.

    From the result back along the lines that each passage takes, for as long as one of them holds the marked part.
    """
    found = differences(equation.read(), equation.derived)
    steps, deciders = equation.derivation.steps, set[int]()
    for relation, places in zip(equation.derived, marks(equation.derived, found, "derived"), strict=True):
        for side, *path in places:
            part = relation.sides[side]
            for index in path:
                part = children(part)[index]
            holding = {
                i for i, step in enumerate(steps) for one in step.formulas for s in one.sides if _standing(s, part)
            }
            row = {i for i in holding if steps[i].result}
            while row:
                last = min(row)
                row = equation.derivation.taken(last) & holding
                deciders |= set() if row else {last}
    return deciders


def _standing(node, part) -> list[Place]:
    """Where `part` stands in the node."""
    if node == part:
        return [()]
    return [(i, *rest) for i, child in enumerate(children(node)) for rest in _standing(child, part)]


def _own(mine, other) -> list[Place]:
    """Which parts of a sum or a product the other lacks; the whole if all, or if sign or number differ."""
    if _is_minus(mine) != _is_minus(other):
        return [()]
    if not isinstance(mine, Add | MatAdd | Mul | MatMul):
        return [] if mine in children(other) and isinstance(other, Add | MatAdd | Mul | MatMul) else [()]
    kind = Add | MatAdd if isinstance(mine, Add | MatAdd) else Mul | MatMul
    theirs = list(other.args) if isinstance(other, kind) else [other]
    own: list[Place] = []
    for i, part in enumerate(mine.args):
        if part in theirs:
            theirs.remove(part)
        else:
            own.append((i,))
    numbers = any(mine.args[i].is_Number for (i,) in own)  # on the page part of a fraction
    return [()] if numbers or len(own) == len(mine.args) else own


def _is_minus(node) -> bool:
    return isinstance(node, Mul | MatMul) and node.args[0] == S.NegativeOne


def _equal(a, b) -> bool:
    plain = not any(is_explicit(side) or side.is_Relational for side in (a, b))
    return a == b or (plain and getattr(a - b, "is_zero", False) is True)


def _sized(letter: Symbol) -> bool:
    """Whether the letter is a block of zeros or ones that says its size, 0_3x18."""
    return re.fullmatch(r"[0I]_\d+x\d+", letter.name) is not None


def _swapped_letters(a, b) -> list[tuple[Symbol, Symbol]]:
    """The letters to be exchanged in a to make it b, if that is all that differs and the entries are scalars."""
    if is_explicit(a) or is_explicit(b) or not (a.is_commutative and b.is_commutative):
        return []
    lost, gained = a.free_symbols - b.free_symbols, b.free_symbols - a.free_symbols
    if len(lost) == len(gained) == 1:
        pair = (*lost, *gained)
        if a.subs(*pair) == b:
            return [pair]
    return []


def origin(paper: Paper, equation: Equation, found: list[Difference]) -> tuple[str, str]:
    """Where the slips are from, and why: `print`, `transcription` or `undecidable`; docs/decisions/0008.

    A scan can lose one mark and take look-alikes for one another; whatever else differs was printed.  What it can do
    is a slip of copying, not of the derivation, if an equation that the text makes from this one, or makes this one
    from, prints the right letter and holds; whose hand copied, the text cannot say.
    """
    marks = [lost_mark(difference) for difference in found]
    causes: dict[str, list[str]] = {}
    for mark in sorted(mark for mark in marks if mark):
        causes.setdefault(mark[1], []).append(mark[0])
    open_ = "; ".join(f"{', '.join(dict.fromkeys(what))} ({cause})" for cause, what in causes.items())
    printed = [difference for difference, mark in zip(found, marks, strict=True) if not mark]
    if printed:
        reasons = dict.fromkeys(BEYOND_A_SCAN.get(difference.kind, BEYOND_A_SCAN[""]) for difference in printed)
        return "print", " and ".join(reasons) + (f"; undecidable beside that: {open_}" if open_ else "")
    pairs = sorted({(str(d.printed), str(d.derived)) for d in found if d.kind == "letter"})
    for other in _connected(paper, equation) if pairs else ():
        right = names(other.printed)
        if all(b in right or f"{b}_b" in right for _, b in pairs) and _sound(paper, other):
            return "transcription", (
                f"{open_}: ({other.number}), which the text ties to this one by substitution, "
                "prints the right letter and holds; so the derivation was right and a copy of it is not"
            )
    return "undecidable", f"{open_}: a scan can do that, and no equation tied to this one shows the right form"


BEYOND_A_SCAN = {
    "sign": "no scan turns a sign",
    "letter": "no scan takes a letter for one that does not look alike",
    "": "no scan adds a term, or loses one",
}


def lost_mark(difference: Difference) -> tuple[str, str] | None:
    """What a scan may have done to make the printed form of the derived one, and how; None if no scan can."""
    a, b = difference.printed, difference.derived
    x, y = str(a), str(b)
    if difference.kind == "letter":
        if _look_alike(x, y):
            return f"{x} for {y}", "small scripts or look-alikes"
        return (f"{x} for {y}", "a letter lost") if _without_one(y, x) else None
    if difference.kind == "shape" and isinstance(a, Symbol) and isinstance(b, Symbol):
        return f"{x} for {y}", "digits"
    if difference.kind == "structure" and not isinstance(a, Relation) and not isinstance(b, Relation):
        if NORM(a) == b:
            return "a pair of bars", "lost"
        if _written(a) == _written(b):
            return "a pair of brackets", "lost"
    return None


NORM = Function("norm")


def _without_one(longer: str, shorter: str) -> bool:
    return any(longer[:i] + longer[i + 1 :] == shorter for i in range(len(longer)))


def _written(expression) -> Counter:
    """The letters, numbers and sums that are written in it: brackets move them, and neither add one nor take one."""
    inside = children(expression)
    own: list = [Add] if isinstance(expression, Add | MatAdd) else []
    own += [] if inside or expression in (1, -1) else [expression]
    return sum((_written(part) for part in inside), Counter(own))


def _look_alike(a: str, b: str) -> bool:
    if any({a[0], b[0]} <= group and a[1:] == b[1:] for group in LOOK_ALIKE):
        return True
    stem_a, stem_b = (name.replace("\u0108", "C").split("_")[0] for name in (a, b))
    return "_" in a and "_" in b and stem_a == stem_b


@cache
def _connected(paper: Paper, equation: Equation) -> tuple[Equation, ...]:
    """Those made from this one, and from those in turn; and those which this one is made from."""
    by_number = {other.number: other for other in paper.equations}
    ahead, queue = [], list(equation.leads_to)
    while queue:
        number = queue.pop(0)
        if number not in ahead:
            ahead.append(number)
            queue += by_number[number].leads_to
    behind = [other.number for other in by_number.values() if equation.number in other.leads_to]
    return tuple(by_number[number] for number in (*ahead, *behind))


@cache
def _sound(paper: Paper, equation: Equation) -> bool:
    return judge(paper, equation, equation.read()).status != "refuted"
