"""Where an expression has no value inside the boxes of what it reads, found before C is made of it.

What is not finite at a point has a step that is the first: a root, a logarithm, a division.  And a divisor that is
negative at one point of the boxes and positive at another is zero between them.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import product
from typing import Any

import casadi as ca
import numpy as np

from boresight.codegen.functions.elementary import norm
from boresight.codegen.functions.maker import UnitMaker
from boresight.codegen.functions.samples import generator, sample
from boresight.codegen.functions.tape import Tape, computed, tape
from boresight.codegen.functions.unit import Unit
from boresight.derive.checks import fail
from boresight.derive.model import Model, Variable

CORNERS, POINTS = 64, 512
HALVINGS = 80
LARGE = 1e9  # times the largest value at the points: what a division by zero gives that is met but to rounding
# Over a step the state may leave its box; what is singular inside of it is so in f or F too.
OVER_A_STEP = ("Phi", "Q", "next")
FACTORS = ("mul", "sq", "neg", "twice", "fabs", "sqrt")  # zero where an operand is
SHOWN = {"add": "({} + {})", "sub": "({} - {})", "mul": "{}*{}", "div": "{}/({})", "neg": "-{}", "sq": "({})**2",
         "twice": "2*{}", "inv": "1/({})"}  # fmt: skip
LONGEST = 60  # of an expression in a message
Points = list[np.ndarray]  # one (points, size) array an argument


@dataclass(frozen=True)
class Looked:
    """A list of operations to look at: of the part of the model it belongs to, with a name for each result."""

    part: Any
    tape: Tape
    args: tuple[Variable, ...]
    names: tuple[str, ...]  # in the order of the tape's results


def refuse_singular(model: Model, made: list[Unit]) -> None:
    """Raise BoresightError that names the entry, the point and the boxes, if one has no value inside of them."""
    for looked in (*of_flow(model), *(of_unit(model, unit) for unit in made if unit.name not in OVER_A_STEP)):
        found = not_finite(looked, points_of(looked)) or zero_divisor(looked)
        if found:
            refuse(model, looked, *found)


def of_flow(model: Model) -> Iterator[Looked]:
    """What the model states and no unit prints as it stands: f, next, G and noise."""
    maker = UnitMaker(model)
    for name in ("f", "next", "G", "noise"):
        matrix = getattr(model, name)
        if matrix is not None and len(matrix):
            (value,) = maker.convert(matrix)
            function = ca.Function(name, [maker.vectors[v.name] for v in maker.variables], [ca.densify(value)])
            rows = [str(part) for part in (model.noise if name == "noise" else model.x)]
            across = [[f", {part}" for part in model.noise] if name == "G" else [""], rows]  # results are column-major
            names = [f"{name}[{row}{column}]" for column, row in product(*across)]
            yield Looked(model, tape(function), maker.variables, tuple(names))


def of_unit(model: Model, unit: Unit) -> Looked:
    x = [str(symbol) for symbol in model.x]
    part, rows, label = next(
        ((m, m.rows, unit.name[-1]) for m in model.measurements if unit.name in (f"{m.name}_{one}" for one in "zhH")),
        (next((f for f in model.functions if f.name == unit.name), model), x, ""),
    )
    names = []
    for output, nz, _ in unit.tape.results:
        result = unit.results[output]
        i, j = result.nonzeros[nz]
        row = rows[i] if i < len(rows) and result.shape[0] == len(rows) else str(i)
        column = f", {x[j] if result.shape[1] == len(x) else j}" if result.shape[1] > 1 else ""
        names.append(f"{label or result.name}[{row}{column}]")
    return Looked(part, unit.tape, unit.args, tuple(names))


def points_of(looked: Looked) -> Points:
    """Corners of the boxes, points drawn in them, some of whose numbers are ends of their boxes or zero, and one that
    is zero where its box holds zero."""
    if not looked.args:
        return []
    rng = generator("singular")
    drawn = sample(looked.args, CORNERS, POINTS, rng)
    for v, part in zip(looked.args, drawn, strict=True):
        chance = rng.integers(0, 6, part[POINTS // 2 :].shape)
        for k, end in enumerate((v.low, v.high, np.clip(0.0, v.low, v.high)) if v.norm is None else ()):
            part[POINTS // 2 :] = np.where(chance == k, end, part[POINTS // 2 :])
    zeros = [np.clip(0.0 * part[-1:], v.low, v.high) if v.norm is None else part[-1:]
             for v, part in zip(looked.args, drawn, strict=True)]  # fmt: skip
    return [np.vstack(both) for both in zip(drawn, zeros, strict=True)]


def not_finite(looked: Looked, points: Points) -> tuple[str, int, list[np.ndarray]] | None:
    """The entry that has no value at one of the points, the step that is the first without one, and the point."""
    values = computed(looked.tape, points)
    lost: list[np.ndarray] = []  # where a step hangs on what has no value, which a comparison hides
    for step, value in zip(looked.tape.steps, values, strict=True):
        of = [lost[a] for a in step.args]
        if step.op == "if_else_zero":
            of[1] = of[1] & (values[step.args[0]] != 0)
        lost.append(np.any([np.isnan(value), *of], axis=0))
    for name, (_, _, position) in zip(looked.names, looked.tape.results, strict=True):
        for k in np.flatnonzero(lost[position] | ~np.isfinite(values[position]))[:1]:
            first = next(
                step
                for step in needed(looked.tape, position)
                if not np.isfinite(values[step][k])
                and all(np.isfinite(values[a][k]) for a in looked.tape.steps[step].args)
            )
            return name, first, [part[k] for part in points]
    return None


def zero_divisor(looked: Looked) -> tuple[str, int, list[np.ndarray]] | None:
    """The same for a divisor, or what a logarithm is taken of, that changes its sign, where it is zero."""
    points, steps = points_of(looked), looked.tape.steps
    values = computed(looked.tape, points)
    for step in (i for i, one in enumerate(steps) if one.op in ("div", "inv", "log")):
        for factor in factors(looked.tape, steps[step].args[-1]):
            v = values[factor]
            if not (v.min() < 0 < v.max()):
                continue
            point = between(looked, factor, points, int(v.argmin()), int(v.argmax()))
            there = computed(looked.tape, point)
            for name, (_, _, position) in zip(looked.names, looked.tape.results, strict=True):
                seen = abs(values[position]).max()
                if not abs(there[position][0]) <= LARGE * seen and step in needed(looked.tape, position):
                    return name, step, [part[0] for part in point]
            if found := not_finite(looked, exact_zeros(looked, factor, points, int(v.argmin()))):
                return found
    return None


def exact_zeros(looked: Looked, step: int, points: Points, base: int) -> Points:
    """Points at which a step is zero to the last bit, or nearly: where the dividend is zero too, no other shows it.

    From one point a single number moves, and the others keep a norm.
    """
    found = [[part[base]] for part in points]
    for i in (i for i in needed(looked.tape, step) if looked.tape.steps[i].op == "input"):
        argument, component = looked.tape.steps[i].source
        arg = looked.args[argument]

        def displaced(
            value: float, argument: int = argument, component: int = component, arg: Variable = arg
        ) -> list[np.ndarray]:
            part = points[argument][base].copy()
            length, part[component] = float(norm(part[None])[0, 0]), 0.0
            rest = float(norm(part[None])[0, 0])
            if arg.norm and rest:
                part *= max(length**2 - value**2, 0.0) ** 0.5 / rest
            part[component] = value
            return [part if k == argument else of[base] for k, of in enumerate(points)]

        def sign(value: float, displaced: Callable[[float], list[np.ndarray]] = displaced) -> float:
            return float(np.sign(computed(looked.tape, [part[None] for part in displaced(value)])[step][0]))

        ends = np.array([arg.low[component], arg.high[component]])
        if arg.norm:
            length = float(norm(points[argument][base][None])[0, 0])
            ends = ends.clip(-length, length)
        low, high = map(float, ends)
        below, above = sign(low), sign(high)
        if not below * above < 0:
            continue
        while low < (middle := (low + high) / 2) < high:
            here = sign(middle)
            if here == 0:
                low = high = middle
            elif here == below:
                low = middle
            else:
                high = middle
        for of, *values in zip(found, displaced(low), displaced(high), strict=True):
            of += values
    return [np.array(of) for of in found]


def needed(program: Tape, position: int) -> list[int]:
    """The steps that a step depends on, and itself, in order."""
    found, waiting = {position}, [position]
    while waiting:
        new = set(program.steps[waiting.pop()].args) - found
        found |= new
        waiting += new
    return sorted(found)


def factors(program: Tape, step: int) -> list[int]:
    """The steps at whose zeros this one is zero: the factors of a product, what is squared."""
    one = program.steps[step]
    return [f for a in one.args for f in factors(program, a)] if one.op in FACTORS else [step]


def between(looked: Looked, step: int, points: Points, a: int, b: int) -> Points:
    """The point between points a and b, of other signs, at which the step is zero; norms stay in their range."""
    low, high = 0.0, 1.0

    def at(share: float) -> Points:
        made = []
        for arg, part in zip(looked.args, points, strict=True):
            value = part[a : a + 1] * (1 - share) + part[b : b + 1] * share
            if arg.norm:
                value = value / norm(value) * sum(arg.norm) / 2
            made.append(value)
        return made

    for _ in range(HALVINGS):
        middle = (low + high) / 2
        if computed(looked.tape, at(middle))[step][0] <= 0:
            low = middle
        else:
            high = middle
    return at(low)


def refuse(model: Model, looked: Looked, name: str, step: int, point: list[np.ndarray]) -> None:
    one = looked.tape.steps[step]
    operand = one.args[-1] if one.op in ("div", "inv") else one.args[0]
    if one.op in ("div", "inv"):  # which of its factors is zero
        values = computed(looked.tape, [part[None] for part in point])
        operand = min(factors(looked.tape, operand), key=lambda factor: abs(values[factor][0]))
    by = shown(looked, operand)
    does = f"divides by {by}" if one.op in ("div", "inv") else f"takes {one.op} of {by}"
    sources = [s.source for i in needed(looked.tape, operand) if (s := looked.tape.steps[i]).op == "input"]
    owners = {s: v for v in (*model.states, *model.inputs) for s in v.symbols}
    at, boxes = [], {}
    for argument, component in sources:
        symbol = looked.args[argument].symbols[component]
        variable = owners[symbol]
        i = variable.symbols.index(symbol)
        at.append(f"{symbol} = {near_zero(point[argument][component], variable, i):.6g}")
        boxes[symbol] = f"{symbol} is {variable.low[i]:.6g} to {variable.high[i]:.6g} in {variable.where}"
    some = f"at {', '.join(at[:4])} it {does}" if at else f"it {does}"
    more = f"; {', '.join(list(boxes.values())[:4])}" if boxes else ""
    divisor = needed(looked.tape, one.args[-1]) if one.op in ("div", "inv") else []
    root = any(looked.tape.steps[k].op == "sqrt" and operand in needed(looked.tape, k) for k in divisor)
    form = "another form, as sqrt(Max(..., a constant))" if root else "another form"
    fail(looked.part, f"{name} has no value inside the boxes: {some}{more}; narrow the box, or write {form}")


def near_zero(value: float, variable: Variable, i: int) -> float:
    """The value, without what halving has left of a zero."""
    return 0.0 if abs(value) < 1e-12 * (variable.high[i] - variable.low[i]) else float(value)


def shown(looked: Looked, step: int) -> str:
    """The step as an expression of the model's symbols; `an expression` if it is long."""

    def text(step: int, room: int) -> str:
        one = looked.tape.steps[step]
        if room < 0:
            return ""
        if one.op == "input":
            return str(looked.args[one.source[0]].symbols[one.source[1]])
        if one.op == "const":
            return f"{one.constant:.6g}"
        inner = [text(a, room - 1) for a in one.args]
        return SHOWN.get(one.op, f"{one.op}({', '.join('{}' for _ in inner)})").format(*inner)

    made = text(step, 8)
    made = made[1:-1] if made.startswith("(") and made.endswith(")") and "(" not in made[1:-1] else made
    return made if len(made) <= LONGEST and "()" not in made else "an expression"
