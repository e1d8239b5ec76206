"""z of each measurement, held by what it must do whatever it is made of; that finds what h and H share with it.

No sensor knows by which axes somebody describes the body, or from where an azimuth is counted.  So z stays what it is,
as a vector in its own axes, where the axes of the body are turned in all that it reads, or those of the level about the
vertical.  What is measured is taken off once.  And a z in m grows by the velocity that the z in m/s beside it has.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import product
from math import inf
from typing import Any

import sympy as sp
from flint import arb

from boresight.codegen.functions.reference import precise
from boresight.codegen.functions.samples import generator
from boresight.codegen.mechanics import (
    EQUAL,
    NOTHING,
    STEP,
    Exact,
    MechanicsCheck,
    Values,
    Verdict,
    compiled,
    largest,
    points,
    rotation_of,
    size,
    slope,
    wrapped,
)
from boresight.codegen.points import nearest_zero
from boresight.derive.checks import expressions, mechanics_of
from boresight.derive.expressions import symbols_in
from boresight.derive.ledger.numbers import Matrix
from boresight.derive.ledger.witness import hamilton
from boresight.derive.mechanics.earth import FRAMES
from boresight.derive.model import Measurement, Model, Variable
from boresight.derive.units import units
from boresight.derive.within import within

MANY = 3  # points
FROM_BODY = re.compile(r"(?<!master )\bbody to\b")
TO_LEVEL = re.compile(rf"\bto (the )?(local )?(level|n|{'|'.join(FRAMES)})\b")
TO = re.compile(r"\bto\b")
OF_BODY, OF_LEVEL = (tuple("xyz"),), (*(frame.axes for frame in FRAMES.values()), ("n", "e"), ("e", "n"))
CLOSE = 1e-3  # of the largest: what keeps a divisor off zero, and radii at the antenna, are no fault
SHOWN = re.compile(r"\bmeasured - true\b")
LESS = re.compile(r"\bz = computed - measured\b")
ITERATIONS = 4
Turn = Callable[[Values], Values]


def check_residuals(model: Model) -> list[MechanicsCheck]:
    """A row of all z that stay in turned axes, one of all from which what is measured is taken off, one of each pair of
    which one is the rate of the other; and a row of each z of which nothing of that holds."""
    found, turned, less = list[MechanicsCheck](), Verdict(), Verdict()
    stays = {m.name: stays_in_turned_axes(model, m, turned) for m in model.measurements}
    if True in stays.values():
        found.append(turned.check(model, "z", "axes of the body or the level, turned in all that it reads"))
    why = "it changes where the axes of the body turn in all that it reads, and where those of the level do"
    found += [MechanicsCheck(model.name, f"{name}_z", "", why=why) for name, stay in stays.items() if stay is False]
    both = [(m, v) for m in model.measurements for v in signed(model, m)]
    found += [MechanicsCheck(model.name, f"{m.name}_z", "", why=f"it changes with the sign of {v.name}; q and -q are "
                             "one attitude") for m, v in both]  # fmt: skip
    if any([taken_off(model, m, less) for m in model.measurements]):
        found.append(less.check(model, "z", "computed - measured"))
    idle = unread(model)
    found += [MechanicsCheck(model.name, "inputs", "", why=f"nothing reads {', '.join(idle)}")] if idle else []
    return found + list(check_rates(model)) + list(check_step(model))


def signed(model: Model, m: Measurement) -> Iterator[Variable]:
    """The attitudes, as quaternions, by whose sign z or h changes."""
    z = m.z if m.z is not None else m.h
    read = symbols_in(z) if z is not None else set()
    for q in (v for v in (*model.inputs, *model.states) if attitude(v, TO) and read & {*v.symbols}):
        run = compiled(z)
        with precise():
            for here in points(model, "z", MANY):
                other = here | {s: -here[s] for s in q.symbols}
                change = [wrapped(e) if i in m.angles else e for i, e in enumerate(run(here)[0] - run(other)[0])]
                if not within(largest(change), NOTHING):
                    yield q
                    break


def unread(model: Model) -> list[str]:
    """The inputs that no expression of the model reads, dt apart: what should have been compared with them?

    None where a caller brings a z, who may read them.
    """
    if not all(m.z is not None for m in model.measurements):
        return []
    read = symbols_in(*(item.matrix for item in expressions(model)))
    read |= symbols_in(*(sp.Matrix(e) for _, e in model.mechanics.step)) if model.mechanics else set()
    return [v.name for v in model.inputs if not read & {*v.symbols} and model.dt not in v.symbols]


# ---------------------------------------------------------------- what is measured


def measured(model: Model, m: Measurement) -> list[tuple[Variable, float]]:
    """The inputs that this z alone reads, in its unit and of its size, and that number by which it changes z."""
    others = [e for name in ("F", "f", "next", "G", "Phi", "Q") if (e := getattr(model, name)) is not None]
    others += [o.value for f in model.functions for o in f.outputs]
    others += [e for one in model.measurements for e in (one.z, one.h, one.H) if e is not None and one is not m]
    others += [sp.Matrix(e) for _, e in model.mechanics.step] if model.mechanics else []
    return times_of(model, m, symbols_in(m.z) - symbols_in(*others))


def times_of(model: Model, m: Measurement, read: set[sp.Symbol]) -> list[tuple[Variable, float]]:
    """The inputs of those symbols in the unit and of the size of z, and the number of each by which it changes z."""
    found = []
    for v in model.inputs:
        if not {*v.symbols} <= read or v.size != len(m.rows) or units(v.unit, v.size) != units(m.unit, v.size):
            continue
        run, here = compiled(m.z), points(model, "z", 1)[0]

        def change(x: Sequence[Any], v: Variable = v, run: Any = run, here: Values = here) -> Matrix:
            there = run(here | {s: here[s] + e for s, e in zip(v.symbols, x, strict=True)})[0] - run(here)[0]
            return Matrix([wrapped(e) if i in m.angles else e for i, e in enumerate(there)])

        by = slope(change, [arb(1)] * v.size)
        times = by[0, 0]
        off = largest(by[i, j] - (times if i == j else 0) for i in range(v.size) for j in range(v.size))
        if within(off, EQUAL) and size(times) > NOTHING:
            found.append((v, float(times)))
    return found


def taken_off(model: Model, m: Measurement, verdict: Verdict) -> bool:
    """Whether z is said to be computed - measured, and something measured is known by its unit: taken off once."""
    if m.z is None or not LESS.search(m.meaning):
        return False
    with precise():
        found = measured(model, m)
        if found and not any(within(abs(times + 1), EQUAL) for _, times in found):
            v, times = found[0]
            verdict.entry = verdict.entry or f"{m.name}_z has {times:.6g} times {v.name}; computed - measured has -1"
        for v, times in times_of(model, m, symbols_in(m.z)) if found else ():
            if v in estimated(model) and SHOWN.search(v.meaning) and not within(abs(times - 1), EQUAL):
                says = f"{v.name} says measured - true; {m.name}_z has {times:.6g} times it, not 1"
                verdict.entry = verdict.entry or says
    return bool(found)


def estimated(model: Model) -> list[Variable]:
    """What feedback returns, or the states."""
    _, feedback = mechanics_of(model)
    names = {o.name for o in feedback.outputs} if feedback else set()
    return [*(v for v in model.inputs if v.name in names), *(model.states if model.kind == "total-state" else ())]


# ---------------------------------------------------------------- what a sensor shows over a step


def check_step(model: Model) -> Iterator[MechanicsCheck]:
    """A row for each sensor that `Mechanics.step` states, without errors, as a multiple of an input other than once."""
    _, feedback = mechanics_of(model)
    if model.mechanics is None or feedback is None or model.dt is None:
        return
    returned = {o.name for o in feedback.outputs}
    errors = [v for v in model.inputs if v.name in returned and v.norm is None]
    with precise():
        (values,) = points(model, "step", 1)
        here = values | {s: zero for v in errors for s, zero in zip(v.symbols, nearest_zero(v), strict=True)}
        for what, expression in model.mechanics.step:
            shown = compiled(sp.Matrix(expression))(here)[0] / here[model.dt]
            for v in (v for v in model.inputs if v.size == what.size and v.name not in returned):
                times = [a / here[s] for a, s in zip(shown, v.symbols, strict=True)]
                if within(largest(t - times[0] for t in times), EQUAL) and size(times[0]) > NOTHING < size(
                    times[0] - 1
                ):
                    why = f"it states {what.name} as {float(times[0]):.6g} times {v.name} over the step"
                    yield MechanicsCheck(model.name, "step", "", why=why)


# ---------------------------------------------------------------- a velocity and its integral


def check_rates(model: Model) -> Iterator[MechanicsCheck]:
    """Each z in m/s against the rate of the z in m of the same rows, as the strapdown carries it."""
    zs = [m for m in model.measurements if m.z is not None] if model.kind == "error-state" else []
    for p, v in product(zs, zs):
        if p.rows != v.rows or (p.unit, v.unit) != ("m", "m/s"):
            continue
        try:
            with precise():
                wrong, off = compare_rate(model, Exact(model), p, v)
        except LookupError:
            continue
        name, other = f"{v.name}_z", f"the rate of {p.name}_z"
        if wrong:
            yield MechanicsCheck(model.name, name, "", why=f"it is not {other}: {wrong}")
        else:
            yield MechanicsCheck(model.name, name, other, off)


def compare_rate(model: Model, exact: Exact, p: Measurement, v: Measurement) -> tuple[str, float]:
    """What is wrong, and by how much both differ at most.

    What is measured stands still, makes z in m zero, and is nothing in m/s; so is every delay.  Held with and without a
    velocity and the rates of the sensors, so that each term is once the largest.
    """
    place, speed = compiled(p.z), compiled(v.z)
    places = [one.unit for one in exact.carried if "m" in one.unit.split(", ")]
    fixes = [one for one in model.inputs if symbols_in(p.z) & {*one.symbols} and one not in exact.returned
             and one.unit in places and one.size == len(p.rows)]  # fmt: skip
    taken = [one for one, times in measured(model, v) if within(abs(times + 1), EQUAL)]
    if not fixes or not taken:
        raise LookupError("what is measured is not known")
    fix, velocities = fixes[0].symbols, [one for one in exact.carried if one.unit == "m/s"]
    free = [one for one in model.inputs if one not in exact.returned and model.dt not in one.symbols]
    rates = [one for one in free if any(symbols_in(e) & {*one.symbols} for _, e in exact.mechanics.step)]
    nothing = [one for one in free if one.unit == "s"] + taken[:1]
    wrong, worst = "", 0.0
    for values, more in product(points(model, "z", MANY), ((), velocities, rates, (*velocities, *rates))):
        still = {s: zero for one in (*nothing, *more) for s, zero in zip(one.symbols, nearest_zero(one), strict=True)}
        here = values | still

        def displaced(x: Sequence[Any], here: Values) -> Matrix:
            return place(here | {s: here[s] + e for s, e in zip(fix, x, strict=True)})[0]

        for _ in range(ITERATIONS):  # of Newton's method
            try:
                step = slope(partial(displaced, here=here), [arb(1)] * len(fix)).inv() * place(here)[0]
            except ZeroDivisionError:
                return f"no {fixes[0].name} makes that zero", inf
            here |= {s: (here[s] - e).mid() for s, e in zip(fix, step, strict=True)}
        grown = (place(exact.after(here, exact.sensed(here)))[0] - place(here)[0]) / STEP
        for row, mine, theirs in zip(v.rows, speed(here)[0], grown, strict=True):
            off = size(mine - theirs) / max(largest(grown), NOTHING)
            if not within(off, CLOSE):
                wrong = wrong or f"{row} is {float(mine):.6g}, and grows by {float(theirs):.6g}"
            worst = max(worst, off)
    return wrong, worst


# ---------------------------------------------------------------- axes that are turned


def stays_in_turned_axes(model: Model, m: Measurement, verdict: Verdict) -> bool | None:
    """Whether z does, of the body or of the level; None where it reads no attitude of the body, nor adds both axes."""
    z = m.z if m.z is not None else m.h
    if z is None:
        return None
    read = symbols_in(z)
    variables = [v for v in (*model.inputs, *model.states) if read & {*v.symbols}]
    mixed = any(letters(v) in OF_BODY and v.unit == m.unit for v in variables)
    mixed &= any(letters(v) in OF_LEVEL and v.unit == m.unit for v in variables)
    if not mixed and not any(attitude(v, FROM_BODY) for v in variables):
        return None
    run, here = compiled(z), points(model, "z", MANY)
    # scale factors, and the lean of single axes, belong to the axes of their sensor
    own = [v for v in variables if v.size > 4 or (v.unit == "1" and v.norm is None and letters(v) in OF_BODY)]
    without = {s: zero for v in own for s, zero in zip(v.symbols, nearest_zero(v), strict=True)}
    with precise():
        # where a latitude is read, north is a direction of the Earth
        turns = TURNS[:1] if any(v.frame == "WGS-84" for v in variables) else TURNS
        for values, (turn, rows) in product((here, [at | without for at in here]), turns):
            off = [turned_off(m, variables, run, at, turn, m.rows in rows) for at in values]
            if all(within(one, CLOSE) for one in off):
                verdict.difference = max(verdict.difference, *off)
                return True
    return False


def attitude(v: Variable, form: re.Pattern[str]) -> bool:
    """Whether it is a quaternion that maps so, by what its frame says, or its meaning."""
    return v.size == 4 and v.unit_norm and bool(form.search(v.frame or v.meaning))


def letters(v: Variable) -> tuple[str, ...]:
    return tuple(s.name.rpartition("_")[2] for s in v.symbols)


def turned_off(
    m: Measurement,
    variables: Sequence[Variable],
    run: Callable[[Values], list[Matrix]],
    values: Values,
    turn: Any,
    vector: bool,
) -> float:
    """What z changes by, of what it does where one variable alone turns; vector: its rows turn with the axes."""
    q = Matrix([arb(float(c)) for c in generator("axes").normal(size=4)])
    if turn is of_level:
        q[1, 0] = q[2, 0] = arb(0)
    q = q / sum((c * c for c in q), arb(0)).sqrt()
    after = {v.name: dict(turn(v, values, q)) for v in variables}
    before, now, *alone = (
        Matrix(list(run(values | {s: e for part in of for s, e in part.items()})[0]))
        for of in ((), after.values(), *([part] for part in after.values() if part))
    )
    scale = max(largest(wrapped(e) if i in m.angles else e for i, e in enumerate(z - before)) for z in alone)
    if vector:
        C = rotation_of(q).T if turn is of_body else rotation_of(q)
        before = C[: before.rows, : before.rows] * before
    change = [wrapped(e) if i in m.angles else e for i, e in enumerate(now - before)]
    if turn is of_level and not vector:  # an azimuth grows by the turn
        angle = 2 * arb.atan2(q[3, 0], q[0, 0])
        change = [min((e, wrapped(e - angle), wrapped(e + angle)), key=size) if i in m.angles else e
                  for i, e in enumerate(change)]  # fmt: skip
    return largest(change) / scale if scale else inf


def of_body(v: Variable, values: Values, q: Matrix) -> Iterator[tuple[Any, Any]]:
    """A variable in axes of the body that are turned by q."""
    column = Matrix([values[s] for s in v.symbols])
    if attitude(v, FROM_BODY):
        yield from zip(v.symbols, hamilton(column, q), strict=True)
    elif letters(v) in OF_BODY and v.frame in ("", "body"):
        yield from zip(v.symbols, rotation_of(q).T * column, strict=True)


def of_level(v: Variable, values: Values, q: Matrix) -> Iterator[tuple[Any, Any]]:
    """A variable in axes of the level that are turned by q, about the vertical."""
    column = Matrix([values[s] for s in v.symbols])
    if attitude(v, TO_LEVEL):
        yield from zip(v.symbols, hamilton(q, column), strict=True)
    elif letters(v) in OF_LEVEL and v.frame in ("", *FRAMES):
        yield from zip(v.symbols, rotation_of(q)[: v.size, : v.size] * column, strict=True)


TURNS = ((of_body, OF_BODY), (of_level, OF_LEVEL))
