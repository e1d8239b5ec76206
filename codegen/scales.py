"""How much z grows for each by which what it reads grows or turns: a factor that z, h and H have in common shows there.

Held is what is the same at every point: a radian for each of a turn, a metre for each of a place, the length of a
direction.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from itertools import product
from typing import Any

from flint import arb

from boresight.codegen.flat import GRAVITY
from boresight.codegen.functions.reference import precise
from boresight.codegen.mechanics import (
    NOTHING,
    MechanicsCheck,
    Values,
    compiled,
    largest,
    points,
    rotation_of,
    size,
    slope,
)
from boresight.codegen.points import nearest_zero
from boresight.codegen.residuals import (
    CLOSE,
    FROM_BODY,
    MANY,
    OF_LEVEL,
    attitude,
    estimated,
    letters,
    measured,
    of_body,
    of_level,
)
from boresight.derive.expressions import symbols_in
from boresight.derive.ledger.numbers import Matrix
from boresight.derive.ledger.witness import hamilton
from boresight.derive.mechanics.earth import FRAMES
from boresight.derive.model import Measurement, Model, Variable
from boresight.derive.units import units
from boresight.derive.within import within

STARTS, SEARCH, LONGEST = 24, 12, 1.0  # points from which z = 0 is looked for, steps of one search, and rad of a step
DIRECTION, FORCE = re.compile(r"\bdirection of\b"), re.compile(r"\bspecific force\b")
G = sum(GRAVITY) / 2
FLOW = re.compile(r"\boptical flow\b")
At = Callable[[Values], list[Matrix]]


def check_scales(model: Model) -> list[MechanicsCheck]:
    """A row of all z that grow as what they read does, and a row of each that grows by more or less."""
    found, wrong = list[float](), dict[str, str]()
    for m in model.measurements:
        with precise():
            for times, what in scales(model, m):
                found.append(times)
                if not within(abs(times - 1), CLOSE):
                    wrong.setdefault(f"{m.name}_z", f"{what} {times:.6g}, not 1")
    rows = [MechanicsCheck(model.name, name, "", why=why) for name, why in wrong.items()]
    if found and not wrong:
        most = max(abs(times - 1) for times in found)
        rows.append(MechanicsCheck(model.name, "z", "what it reads, as that grows or turns", most))
    return rows


def scales(model: Model, m: Measurement) -> Iterator[tuple[float, str]]:
    """What should be 1, and what it is of."""
    z = m.z if m.z is not None else m.h
    if z is None:
        return
    run, read = compiled(z), symbols_in(z)
    variables = [v for v in (*model.inputs, *model.states) if read & {*v.symbols}]
    own = [v for v in variables if v.unit == "1" and v.norm is None]  # scale factors
    without = {s: zero for v in own for s, zero in zip(v.symbols, nearest_zero(v), strict=True)}
    here = [values | without for values in points(model, "z", MANY)]
    if m.z is not None and (k := by_measured_attitude(model, m, run)):
        yield k, "for a turn of the measured attitude by 1 rad it grows by"
    yield from by_turns(m, variables, run, here)
    yield from by_vectors(m, variables, run, here)
    yield from by_length(model, m, run, here)
    yield from by_passing(m, variables, run, here)


def by_turns(m: Measurement, variables: Sequence[Variable], run: At, here: list[Values]) -> Iterator[tuple[float, str]]:
    """Rows that are angles, as the axes of the body turn about one of them, or those of the level."""
    for turn, axes in ((of_body, 3), (of_level, 1)) if m.angles else ():

        def turned(r: Sequence[Any], values: Values, turn: Any = turn) -> Matrix:
            q = small_turn(r if turn is of_body else [0, 0, *r])
            return run(values | dict(part for v in variables for part in turn(v, values, q)))[0]

        by = [slope(lambda r, at=values, by=turned: by(r, at), [arb(1)] * axes) for values in here]  # type: ignore[misc]
        for i, j in product(m.angles, range(axes)):
            if k := constant([abs(float(J[i, j])) for J in by]):
                yield k, f"for a turn of the axes by 1 rad {m.rows[i]} grows by"


def by_vectors(
    m: Measurement, variables: Sequence[Variable], run: At, here: list[Values]
) -> Iterator[tuple[float, str]]:
    """Rows by a vector of their own unit, of any direction."""
    own = units(m.unit, len(m.rows))
    for v in variables:
        unit = set(units(v.unit, v.size))
        if v.size not in (2, 3) or len(unit) > 1 or m.unit == "1":
            continue

        def displaced(x: Sequence[Any], values: Values, v: Variable = v) -> Matrix:
            return run(values | {s: values[s] + e for s, e in zip(v.symbols, x, strict=True)})[0]

        by = [slope(lambda x, at=values, by=displaced: by(x, at), [arb(1)] * v.size) for values in here]  # type: ignore[misc]
        for i, row in enumerate(m.rows):
            lengths = [float(sum((J[i, j] * J[i, j] for j in range(v.size)), arb(0)).sqrt()) for J in by]
            if own[i] in unit and (k := constant(lengths)):
                yield k, f"for each {m.unit} of {v.name} {row} grows by"


def by_length(model: Model, m: Measurement, run: At, here: list[Values]) -> Iterator[tuple[float, str]]:
    """The length of a direction, and of the specific force of what does not accelerate, beside that of gravity."""
    says = DIRECTION if m.unit == "1" else FORCE if m.unit == "m/s^2" else None
    if len(m.rows) != 3 or says is None or not says.search(m.meaning):
        return
    taken = [v for v, _ in measured(model, m)] if m.z is not None else []
    bare = [values | dict.fromkeys((s for v in taken for s in v.symbols), arb(0)) for values in here]
    computed = [run(values)[0] for values in bare]
    k = constant([float(sum((e * e for e in one), arb(0)).sqrt()) for one in computed])
    if k and says is DIRECTION:
        yield k, "the length of the direction is"
    elif k:
        upwards = up(model, m, bare, computed)
        yield (
            1.0 if GRAVITY[0] <= upwards * k <= GRAVITY[1] else upwards * k / G,
            f"upwards, in parts of {G} m/s^2, it is",
        )


def up(model: Model, m: Measurement, here: Sequence[Values], computed: Sequence[Matrix]) -> int:
    """-1, if a force in axes of the body points downwards in a level whose axes are known; else 1."""
    z: Any = m.z if m.z is not None else m.h
    read = symbols_in(z)
    attitudes = [v for v in (*model.inputs, *model.states) if attitude(v, FROM_BODY) and read & {*v.symbols}]
    if len(attitudes) != 1:
        return 1
    (q,) = attitudes
    level = next((f.axes for f in FRAMES.values() if f.name in (q.frame or f"{q.meaning} {model.frame}")), None)
    if level is None:
        return 1
    turned = [rotation_of(Matrix([at[s] for s in q.symbols])) * force for at, force in zip(here, computed, strict=True)]
    signs = [float(force[2, 0]) * (1 if level[2] == "u" else -1) for force in turned]
    return -1 if all(sign < 0 for sign in signs) else 1


def by_passing(
    m: Measurement, variables: Sequence[Variable], run: At, here: list[Values]
) -> Iterator[tuple[float, str]]:
    """What passes below a level body turns by its speed over the distance, which grows by a metre for each metre."""
    attitudes = [v for v in variables if attitude(v, FROM_BODY)]
    speeds = [v for v in variables if v.unit == "m/s" and letters(v) in OF_LEVEL]
    if not (FLOW.search(m.meaning) and m.unit == "rad/s" and len(attitudes) == len(speeds) == 1):
        return
    level = dict(zip(attitudes[0].symbols, map(arb, (1, 0, 0, 0)), strict=True))
    level |= {s: arb(0) for s, letter in zip(speeds[0].symbols, letters(speeds[0]), strict=True) if letter in "du"}
    other = {s: arb(0) for v in variables if v.unit == m.unit for s in v.symbols}  # what is measured
    speed = [s for s in speeds[0].symbols if s not in level]
    for s in (s for v in variables if v.unit == "m" for s in v.symbols):

        def distance(x: Sequence[Any], values: Values, s: Any = s) -> Matrix:
            turn = run(values | {s: values[s] + x[0]})[0]
            square = sum((values[one] * values[one] for one in speed), arb(0))
            return Matrix([(square / sum((e * e for e in turn), arb(0))).sqrt()])

        by = [slope(lambda x, at=values, by=distance: by(x, at), [arb(1)])  # type: ignore[misc]
              for values in (at | level | other for at in here)]  # fmt: skip
        if k := constant([abs(float(J[0, 0])) for J in by]):
            yield k, f"the distance at which it sees what passes grows, for each metre of {s}, by"


def constant(numbers: Sequence[float]) -> float:
    """The number that they all are, within CLOSE; 0 where they differ."""
    return numbers[0] if within(max(numbers) - min(numbers), CLOSE * abs(numbers[0])) else 0.0


def small_turn(r: Sequence[Any]) -> Matrix:
    """A unit quaternion that turns by r, to second order."""
    q = Matrix([arb(1), *(arb(e) / 2 for e in r)])
    return q / sum((c * c for c in q), arb(0)).sqrt()


def by_measured_attitude(model: Model, m: Measurement, run: At) -> float:
    """What three rows in rad grow by for a turn of the attitude that is measured, if it is the same about all axes."""
    read = symbols_in(m.z)
    estimates = estimated(model)
    taken = [v for v in model.inputs if v.size == 4 and v.unit_norm and read & {*v.symbols} and v not in estimates]
    if len(m.rows) != 3 or m.unit != "rad" or len(taken) != 1:
        return 0.0
    (q,) = taken
    delays = [s for v in model.inputs if v.unit == "s" for s in v.symbols]
    for values in points(model, "z", STARTS):
        here = values | dict.fromkeys(delays, arb(0))

        def turned(r: Sequence[Any], here: Values = here) -> Matrix:
            after = hamilton(Matrix([here[s] for s in q.symbols]), small_turn(r))
            return run(here | dict(zip(q.symbols, after, strict=True)))[0]

        try:
            for _ in range(SEARCH):  # for where z is zero
                J, off = slope(turned, [arb(1)] * 3), turned([arb(0)] * 3)
                if within(largest(off), NOTHING):
                    if k := same_about_all_axes(J):
                        return k
                    break  # half a turn away, where a residual by sines is zero too
                step = J.inv() * off
                step = step * min(1.0, LONGEST / largest(step))
                after = hamilton(Matrix([here[s] for s in q.symbols]), small_turn([-e.mid() for e in step]))
                here |= dict(zip(q.symbols, (e.mid() for e in after), strict=True))
        except ZeroDivisionError:
            continue
    return 0.0


def same_about_all_axes(J: Matrix) -> float:
    square = J.T * J
    k = square[0, 0]
    off = largest(square[i, j] - (k if i == j else 0) for i in range(3) for j in range(3))
    return float(k.sqrt()) if within(off, CLOSE * size(k)) else 0.0
