"""What a model says in words about the signs of its errors, held against what its `feedback` does.

The card and the meanings of the states are printed in headers and pages.  Read are `C_hat = (I - [e x]) C`, also with
the factors exchanged, and what an error is: computed - true, estimated - true, a_hat - a, or the other one.  A bias
that is measured - true is what `strapdown` takes off its sensor.  An axis that ends a name is the same of an error and
of its estimate, of a bias and of its sensor.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from flint import arb

from boresight.codegen.functions.reference import precise
from boresight.codegen.mechanics import (
    EQUAL,
    NOTHING,
    Corrected,
    MechanicsCheck,
    Values,
    Verdict,
    compiled,
    largest,
    points,
    rotation_of,
    size,
    slope,
    symbols,
    unit_of,
)
from boresight.codegen.residuals import SHOWN
from boresight.derive.checks import mechanics_of
from boresight.derive.expressions import symbols_in
from boresight.derive.ledger.numbers import Matrix, eye
from boresight.derive.ledger.witness import rotation_vector
from boresight.derive.model import Model, Variable
from boresight.derive.units import Unit, units
from boresight.derive.within import within

TURN = re.compile(r"(?P<hat>C_hat\w*) = (?P<before>C\w* )?\(I (?P<sign>[-+]) \[(?P<error>\w+) x\]\)(?P<after> C\w*)?")
COMPUTED = re.compile(r"\b(computed|estimated|nominal) - true\b|\b(\w+)_hat - \2\b")
TRUE = re.compile(r"\btrue - (computed|estimated|nominal)\b|\b(\w+) - \2_hat\b")
AXES = ("xyz", "ned", "enu")  # by the last letter of a name
ASKEW = 0.5  # of what a bias does along its own axis
OF_ALL = re.compile(r"\bError = ")


def check_words(model: Model) -> list[MechanicsCheck]:
    """One row for all that is read; none where nothing is."""
    _, feedback = mechanics_of(model)
    if model.kind != "error-state" or feedback is None:
        return []
    verdict, signs = Verdict(), Signs(model)
    count = 0
    for where, text in (*((f"card: {line}", line) for line in model.card), *meanings(model)):
        for found in TURN.finditer(text):
            count += turned(verdict, signs, where, found)
        stated = -1 if COMPUTED.search(text) else 1 if TRUE.search(text) else 0
        blocks = [block for block in model.states if where == block.name]
        if stated and (blocks or OF_ALL.search(text)):
            count += subtracted(verdict, signs, where, stated, blocks or model.states)
    count += sum(biased(verdict, model, signs.hat, v) for v in signs.corrected.returned if SHOWN.search(v.meaning))
    count += sum(along_its_axis(verdict, signs, v) for v in signs.corrected.returned if v.norm is None)
    return [verdict.check(model, "words", "the signs of feedback")] if count else []


def biased(verdict: Verdict, model: Model, hat: Values, bias: Variable) -> int:
    """Of a bias that is measured - true: 1 if strapdown reads a sensor of its unit, from which it must be taken off."""
    strapdown, _ = mechanics_of(model)
    outputs = [o.value for o in strapdown.outputs if o.name != bias.name] if strapdown else []
    read = symbols_in(*outputs)
    (unit, *_), second = unit_of(bias), units("s", 1)[0]
    of_rate, of_sum = (
        [v for v in sensors(model) if read & {*v.symbols} and v.size == bias.size and unit_of(v)[0] == one]
        for one in (unit, unit * second)
    )
    if model.dt is None or not read & {*bias.symbols} or not (of_rate or of_sum):
        return 0
    run = compiled(*outputs)

    def by(moved: Mapping[Variable, Any]) -> Matrix:
        def after(x: Sequence[Any]) -> Matrix:
            there = {s: hat[s] + part * e for v, part in moved.items() for s, e in zip(v.symbols, x, strict=True)}
            return Matrix([e for column in run(hat | there) for e in column])

        return slope(after, [arb(1)] * bias.size)

    with precise():
        mine = by({bias: 1})
        sensor = by(dict.fromkeys(of_rate, 1) | dict.fromkeys(of_sum, hat[model.dt]))
        whole = largest(sensor)
        share = sum((m * s for m, s in zip(mine, sensor, strict=True)), arb(0)) / sum((s * s for s in sensor), arb(0))
        alike = within(largest(mine - share * sensor), EQUAL * whole)
        if not alike and (other := other_axis(mine, sensor)):
            s, axis = bias.symbols[other[0]], bias.symbols[other[1]].name.rpartition("_")[2]
            says = f"{bias.name} says measured - true; strapdown takes {s} off its sensor along {axis}"
            verdict.entry = verdict.entry or says
            return 1
        if alike and not within(size(share + 1), EQUAL):
            says = f"{bias.name} says measured - true; strapdown takes it off its sensor {-float(share):.6g} times"
            verdict.entry = verdict.entry or says
    return int(alike)


def other_axis(mine: Matrix, sensor: Matrix) -> tuple[int, int] | None:
    """Of a bias that is taken off its sensor through a matrix: a component, and the axis at which it shows instead."""
    A = (sensor.T * sensor).solve(-(sensor.T * mine))
    if not within(largest(mine + sensor * A), EQUAL * largest(mine)):
        return None
    off = [(size(A[i, j]) - size(A[j, j]) * ASKEW, j, i) for i in range(A.rows) for j in range(A.cols) if i != j]
    most, j, i = max(off)
    return (j, i) if most > 0 else None


def sensors(model: Model) -> list[Variable]:
    """The inputs that strapdown and feedback do not return, and what `step` states."""
    given = {o.name for f in mechanics_of(model) if f for o in f.outputs}
    more = tuple(v for v, _ in model.mechanics.step) if model.mechanics else ()
    return [v for v in dict.fromkeys((*model.inputs, *more)) if v.name not in given]


def meanings(model: Model) -> Iterator[tuple[str, str]]:
    for block in model.states:
        yield block.name, block.meaning


class Signs:
    """How the estimates change as feedback takes an error out, at one point."""

    def __init__(self, model: Model):
        _, feedback = mechanics_of(model)
        assert feedback is not None
        self.model, self.states = model, symbols(model)
        self.corrected = Corrected(model, feedback)
        (self.hat,) = points(model, "words", 1)
        self.one = [arb(1)] * model.n
        self.units: list[Unit] = [unit for block in model.states for unit in unit_of(block)]
        self.returned = [s for v in self.corrected.returned for s in v.symbols]
        with precise():
            self.numbers = slope(lambda x: self.after(x, self.returned), self.one)

    def after(self, x: Sequence[Any], of: Sequence[Any]) -> Matrix:
        estimates = self.corrected.estimates(self.hat, x)
        return Matrix([estimates[s] for s in of])

    def of(self, v: Variable) -> Matrix:
        """(size, n) of an estimate by the errors."""
        at = self.returned.index(v.symbols[0])
        return self.numbers[at : at + v.size, :]

    def turn(self, q: Variable, left: bool) -> Matrix:
        """(3, n) of the rotation from the estimate to what is left of it, in the axes on that side, by the errors."""

        def by(x: Sequence[Any]) -> Matrix:
            true = rotation_of(self.after(x, q.symbols))
            return rotation_vector(true * C.T if left else C.T * true)

        with precise():
            C = rotation_of(Matrix([self.hat[s] for s in q.symbols]))
            return slope(by, self.one)

    def place(self, block: Variable) -> slice:
        at = self.states.index(block.symbols[0])
        return slice(at, at + block.size)


def turned(verdict: Verdict, signs: Signs, where: str, found: re.Match[str]) -> int:
    """Of an attitude error; 1 if feedback turns a quaternion by it, which must be such a turn of one of them."""
    error, left = found["error"], found["after"] is not None
    block = next((b for b in signs.model.states if b.size == 3 and (b.name == error or alike(b, error))), None)
    if block is None:
        return 0
    means: list[str] = []
    for q in (v for v in signs.corrected.returned if v.norm and v.size == 4):
        for side in (left, not left):
            by = signs.turn(q, side)[:, signs.place(block)]
            if within(largest(by), NOTHING):
                break  # not a turn of this one
            sign = next((sign for sign in (1, -1) if within(largest(by - sign * eye(3)), EQUAL)), 0)
            if side == left and sign == (1 if found["sign"] == "-" else -1):
                return 1
            if sign:
                C = (found["after"] or found["before"]).strip()
                turn = f"(I {'-' if sign == 1 else '+'} [{error} x])"
                means.append(f"{found['hat']} = {turn} {C}" if side else f"{found['hat']} = {C} {turn}")
        else:
            means = means or [f"another turn of {q.name}"]
    if means:
        verdict.entry = verdict.entry or f"{where.split(':')[0]} says {found[0]}; feedback means {means[0]}"
    return len(means[:1])


def alike(block: Variable, error: str) -> bool:
    """Whether the components have this name before their axis."""
    return all(s.name.startswith(f"{error}_") for s in block.symbols)


def subtracted(verdict: Verdict, signs: Signs, where: str, stated: int, blocks: Sequence[Variable]) -> int:
    """Of errors of numbers: how many components feedback takes off, or adds to, one estimate of the same unit."""
    count = 0
    for v in (v for v in signs.corrected.returned if v.norm is None):
        by = signs.of(v)
        alone = {i: signs.units[j] for i, j in moved_alone(by)}
        if any(unit_of(v)[i] != own for i, own in alone.items()):
            continue
        for block in blocks:
            columns = by[:, signs.place(block)]
            for i, (s, unit) in enumerate(zip(v.symbols, unit_of(v), strict=True)):
                for j, (e, own) in enumerate(zip(block.symbols, unit_of(block), strict=True)):
                    if unit != own or within(size(columns[i, j]), NOTHING) or i not in alone:
                        continue
                    count += 1
                    sign = 1 if float(columns[i, j]) > 0 else -1
                    if sign != stated:
                        words = {-1: "computed - true", 1: "true - computed"}
                        text = f"{where.split(':')[0]} says {words[stated]}"
                        verdict.entry = verdict.entry or f"{text}; feedback of {s} by {e} means {words[sign]}"
    return count


def along_its_axis(verdict: Verdict, signs: Signs, v: Variable) -> int:
    """How many numbers of an estimate one error alone moves, of its unit and of its kind of axes: it is of theirs."""
    by, count = signs.of(v), 0
    for i, j in moved_alone(by):
        e, s = signs.states[j], v.symbols[i]
        mine, theirs = (one.name.rpartition("_")[2] for one in (e, s))
        if signs.units[j] == unit_of(v)[i] and any({mine, theirs} <= {*axes} for axes in AXES):
            count += 1
            if mine != theirs:
                verdict.entry = verdict.entry or f"{e} is by its name of axis {mine}; feedback takes it off {s}"
    return count


def moved_alone(by: Matrix) -> Iterator[tuple[int, int]]:
    """The components that one error alone moves, and which."""
    for i in range(by.rows):
        moves = [j for j in range(by.cols) if not within(size(by[i, j]), NOTHING)]
        if len(moves) == 1:
            yield i, moves[0]
