"""Lines of a derivation: how they are read, and the judge of what each claims of itself.

A line is LaTeX in the paper's letters.  It is evaluated at the witness, where the value of each letter comes from
kinematics and never from the line; only a definition gives its letter the value of its right side.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace
from functools import cache
from itertools import pairwise
from types import MappingProxyType

import mpmath as mp

from boresight import BoresightError
from boresight.derive.ledger.equation import Claim, Derivation, Equation, Line, Quantity, Relation, total
from boresight.derive.ledger.evaluate import DIGITS, Point, evaluate, residual
from boresight.derive.ledger.free import free_point
from boresight.derive.ledger.judge import (
    EXACT,
    FULL,
    SCALES,
    SEEDS,
    SLACK,
    LineVerdict,
    falls,
    names,
    paper_points,
    witness_point,
)
from boresight.derive.ledger.numbers import digits, largest, middles
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.passages import judge_passage
from boresight.derive.ledger.reader import read


def read_lines(
    lines: Iterable[Line],
    quantities: Iterable[Quantity],
    flown: Mapping[str, object] = MappingProxyType({}),
) -> tuple[Line, ...]:
    """The lines with their relations; one line is one relation, a chain of sides that are equal."""
    quantities, result = tuple(quantities), []
    for one in lines:
        if one.latex:
            relations = read((one.latex,), quantities, flown)
            if len(relations) != 1:
                raise BoresightError(f"{one.latex!r} is {len(relations)} relations: write a line for each")
            one = replace(one, relation=relations[0])
        result.append(one)
    return tuple(result)


# ---- Judging ---------------------------------------------------------------------------------------------------------


def judge_line(paper: Paper, equation: Equation, index: int, relation: Relation | None = None) -> LineVerdict:
    """The verdict on the claim of step `index`, or on another relation in its place."""
    one = equation.derivation.steps[index]
    assert one.claim is not None and one.relation is not None
    relation = one.relation if relation is None else relation
    unknown = {*one.claim.small} - {part.name for part in fields(paper.witness.base)}
    if unknown:
        return LineVerdict(False, f"the witness has no error {', '.join(sorted(unknown))}")
    try:
        verdict = _judged(paper, equation, one.claim, relation, _given(equation, index))
        if verdict.holds and one.claim.kind not in ("definition", "identity") and _holds_freely(paper, relation):
            return LineVerdict(False, "it holds for any values of its letters: it is an identity")
        return verdict
    except (ValueError, KeyError, ZeroDivisionError, BoresightError, TypeError) as error:
        return LineVerdict(False, f"it has no meaning: {error.args[0] if error.args else error}")


def _given(equation: Equation, index: int) -> tuple[Relation, ...]:
    """The definitions of this derivation's earlier lines, in order."""
    earlier = equation.derivation.steps[:index]
    return tuple(one.relation for one in earlier if one.relation and one.claim and one.claim.kind == "definition")


def _at(paper: Paper, seed: int, scale: float, small: tuple[str, ...], given: Iterable[Relation]) -> Point:
    point = witness_point(paper, seed, scale, small)
    for definition in given:
        point = point.changed({definition.sides[0].name: evaluate(definition.sides[-1], point)})
    return point


def line_point(paper: Paper, equation: Equation, index: int, scale: float) -> Point:
    """The witness's values at which line `index` is judged, with the definitions before it."""
    one = equation.derivation.steps[index]
    assert one.claim is not None
    return _at(paper, SEEDS[0], scale, one.claim.small or equation.small, _given(equation, index))


def _judged(paper: Paper, equation: Equation, claim: Claim, relation: Relation, given: tuple) -> LineVerdict:
    if any(left == right for left, right in pairwise(relation.sides)):
        return LineVerdict(False, "both sides are written the same")
    small = claim.small or equation.small

    def point(seed: int, scale: float, parts: tuple[str, ...] = small) -> Point:
        return _at(paper, seed, scale, parts, given)

    if claim.kind == "definition":
        letter = relation.sides[0]
        if not letter.is_Symbol:
            return LineVerdict(False, f"{letter} is no letter")
        if letter.name in names((Relation(relation.sides[1:]),)):
            return LineVerdict(False, f"{letter} is defined by itself")
        for definition in given:
            if definition.sides[0] == letter:
                return LineVerdict(False, f"{letter} was defined before")
        if _known(letter.name, point(SEEDS[0], FULL)):
            return LineVerdict(False, f"the witness has a value for {letter}: the line is no definition")
        evaluate(relation.sides[-1], point(SEEDS[0], FULL))
        if len(relation.sides) > 2:
            rest = _exactly(Relation(relation.sides[1:]), (point(seed, FULL) for seed in SEEDS))
            if not rest.holds:
                return rest
        return LineVerdict(True, f"gives {letter} its value")
    if claim.kind == "identity":
        free = (free_point(paper, seed) for seed in SEEDS)
        return _exactly(relation, free)
    if claim.kind == "exact":
        return _exactly(relation, (point(seed, FULL) for seed in SEEDS))
    if claim.kind == "approximation":
        (dropped,) = read((claim.dropped,), (*paper.quantities(), *paper.letters()))
        (term,) = dropped.sides
        whole = Relation((relation.sides[0], *(total(side, term) for side in relation.sides[1:])))
        verdict = _falls(whole, point, 2) if claim.small else _exactly(whole, (point(seed, FULL) for seed in SEEDS))
        if not verdict.holds:
            more = "" if claim.small else "; where it is of first order only, name the errors as `small`"
            return LineVerdict(False, f"with what is dropped on the right, {verdict.why}{more}")
        if _exactly(relation, (point(seed, FULL) for seed in SEEDS)).holds:
            return LineVerdict(False, "nothing is dropped")
        size, side = (_size(paper, part, given) for part in (term, relation.sides[0]))
        if size > side / 100:
            return LineVerdict(False, f"what is dropped, {mp.nstr(size, 3)}, is no small part of {mp.nstr(side, 3)}")
        return replace(verdict, size=mp.nstr(size, 3))
    power = {"first-order": 2, "limit": 1}.get(claim.kind, claim.order + 1)
    verdict = _falls(relation, point, power)
    if verdict.holds and _exactly(relation, (point(seed, FULL) for seed in SEEDS)).holds:
        return LineVerdict(False, f"it is exact: {claim.kind} says less")
    if verdict.holds and claim.kind == "limit" and _falls(relation, point, 2).holds:
        return LineVerdict(False, "it is right to first order: a limit says less")
    return verdict


def _holds_freely(paper: Paper, relation: Relation) -> bool:
    try:
        return _exactly(relation, (free_point(paper, seed) for seed in SEEDS)).holds
    except (ValueError, KeyError, ZeroDivisionError):
        return False


def _known(name: str, point: Point) -> bool:
    try:
        return point.values[name] is not None
    except KeyError:
        return False


def _exactly(relation: Relation, points: Iterable[Point]) -> LineVerdict:
    for point in points:
        worst = largest(residual(relation.sides, point))
        if worst > EXACT:
            return LineVerdict(False, f"the sides differ by {mp.nstr(worst, 3)}")
    return LineVerdict(True, "both sides agree to 28 digits")


def _falls(relation: Relation, point, power: int) -> LineVerdict:
    """As `falls` has it at all seeds; and each row whose sides differ at all states something of that order."""
    stated = False
    for seed in SEEDS:
        at = [point(seed, scale) for scale in SCALES]
        fall = falls(relation, at, power)
        if fall.why:
            return LineVerdict(False, fall.why)
        sides = list(zip(*(_entries(relation.sides[-1], p) for p in at), strict=True))
        columns = getattr(evaluate(relation.sides[-1], at[0]), "cols", 1)
        states = [
            any(_moves(entry, SLACK / 2**power) for entry in sides[i : i + columns])
            for i in range(0, len(sides), columns)
        ]
        stated |= any(states)
        for row in sorted(fall.rows):
            if not states[min(row, len(states) - 1)]:
                return LineVerdict(False, f"row {row + 1} states nothing of that order")
    if not stated:
        return LineVerdict(False, "the part that it states is zero")
    return LineVerdict(True, f"the remainder falls {2**power}-fold when the errors are halved")


def _entries(side, point: Point) -> list:
    return middles(evaluate(side, point))


def _moves(values: tuple, most) -> bool:
    """Whether an entry falls more slowly than what is dropped, or not at all."""
    return abs(values[0]) > EXACT and abs(values[1]) > most * abs(values[0])


def _size(paper: Paper, term, given: tuple) -> mp.mpf:
    """The largest entry at the paper's own numbers."""
    worst = mp.mpf(0)
    for point in paper_points(paper):
        for definition in given:
            point = point.changed({definition.sides[0].name: evaluate(definition.sides[-1], point)})
        worst = max(worst, *(abs(entry) for entry in _entries(term, point)))
    return worst


# ---- All lines of an equation ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Steps:
    """How many steps a paper's derivations have; how many are evaluated, of these carried out on earlier lines, and how
    many are prose.  A line that is not carried out begins from kinematics, an identity or a definition."""

    steps: int
    evaluated: int
    carried: int
    prose: int

    def __str__(self) -> str:
        carried = f"of these {self.carried} carried out on earlier lines"
        return f"steps: {self.steps}, evaluated {self.evaluated}, {carried}, prose {self.prose}"


def count_steps(equations: Iterable[Equation]) -> Steps:
    steps = [step for equation in equations for step in equation.derivation.steps]
    evaluated = sum(step.claim is not None for step in steps)
    carried = sum(step.passage is not None for step in steps)
    return Steps(len(steps), evaluated, carried, sum(not step.formulas for step in steps))


def check_derivation(paper: Paper, equation: Equation) -> None:
    """Raises BoresightError at the first line or passage that does not hold, and at a definition that nothing uses."""
    if equation.number in _stands_on(paper, equation):
        raise BoresightError(f"{paper.name} ({equation.number}): its derivation stands on itself")
    steps = equation.derivation.steps
    if steps and not (equation.derivation.lines or equation.defines or equation.introduces):
        raise BoresightError(f"{paper.name} ({equation.number}): prose derives nothing")
    derived = {symbol for relation in equation.derived for side in relation.sides for symbol in _letters(side)}
    for printed, ours in zip(equation.read(), equation.derived, strict=False):
        if not (set(printed.sides) & set(ours.sides) or _letters(printed.sides[0]) <= derived):
            raise BoresightError(f"{paper.name} ({equation.number}): {printed.sides[0]} is not what is derived")
    for index, step in enumerate(steps):
        if step.relation is None:
            continue
        name = f"{paper.folder}/derivation.toml," if paper.folder else paper.name
        latex = f"`{step.latex}`" if paper.folder else step.latex
        where = f"{name} ({equation.number}), line {index + 1}, {latex}"
        verdict = judge_line(paper, equation, index)
        if verdict.holds and step.passage is not None:
            verdict = judge_passage(paper, equation, index)
        if not verdict.holds:
            raise BoresightError(f"{where}: {verdict.why}")
        if step.claim is not None and step.claim.kind == "definition":
            letter = step.relation.sides[0]
            later = range(index + 1, len(steps))
            used = names([relation for i in later for relation in steps[i].formulas])
            if letter.name not in used and not any(index in equation.derivation.taken(i) for i in later):
                raise BoresightError(f"{where}: nothing uses {letter}")


@cache
def standing(paper: Paper, equation: Equation) -> Equation:
    """The equation; of a paper of one's own, where its derivation does not stand, without it, `refused` saying why.

    Raises BoresightError where that of another paper does not.
    """
    if not equation.derivation.steps and not paper.folder:
        return equation
    with digits(DIGITS):
        try:
            check_derivation(paper, equation)
            for number in _stands_on(paper, equation):
                if standing(paper, paper.equation(number)).refused:
                    raise BoresightError(f"it stands on ({number}), whose derivation is refused")
        except BoresightError as error:
            if not paper.folder:
                raise
            return without_steps(equation, str(error))
    return equation


def without_steps(equation: Equation, why: str) -> Equation:
    return replace(equation, derivation=Derivation(()), derived=equation.read(), refused=why)


def sound(paper: Paper) -> Paper:
    """Of a paper of one's own the same, but that a definition whose derivation is refused gives its letter the value
    that it prints, and not what was derived."""
    equations = tuple(standing(paper, e) if e.defines and e.derivation.lines else e for e in paper.equations)
    return paper if equations == paper.equations else sound(replace(paper, make_equations=lambda: equations))


def fallen_definitions(paper: Paper, equation: Equation) -> list[Equation]:
    """The definitions, with a derivation that is refused, on which a letter of the equation hangs."""
    defines = {symbol.name: one for one in paper.equations if one is not equation for symbol in one.defines}
    seen, found = set[str](), list[Equation]()
    left = [*equation.read(), *(relation for line in equation.derivation.lines for relation in line.formulas)]
    while new := (names(left) & defines.keys()) - seen:
        seen |= new
        left = [relation for name in new for relation in defines[name].derived]
        found += [defines[name] for name in sorted(new) if defines[name].refused]
    return found


def _letters(side) -> set:
    return getattr(side, "free_symbols", set())


def _stands_on(paper: Paper, equation: Equation) -> set[str]:
    """The numbers of the equations on which a derivation stands, and those on which theirs do."""
    found: set[str] = set()
    left = [equation]
    while left:
        new = left.pop().derivation.equations - found
        found |= new
        left += [paper.equation(number) for number in new]
    return found
