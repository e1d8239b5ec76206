"""F, G, H and feedback of a model held against exact mechanics, in 50 digits.

An error x is put in by the model's own feedback: what it makes of the estimates and x is the truth.  Estimates and
truth are carried over a short step by the model's own strapdown, and the error is read out of them again by the inverse
of the feedback.  The rate of what is read out must be F x, and G w where the sensors are wrong by w; what is left must
fall fourfold when x is halved.  H is held in the same way against the exact h, or against z with the errors taken out.
A strapdown that gives position, velocity and attitude is held against Newton's law on the turning ellipsoid.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import product
from math import inf, isfinite
from typing import Any

import sympy as sp
from flint import arb

from boresight.codegen.functions.reference import evaluator, precise
from boresight.codegen.functions.samples import generator
from boresight.codegen.functions.unit import state_variable
from boresight.codegen.points import exact_points, nearest_zero
from boresight.derive.checks import ERRORS, mechanics_of
from boresight.derive.dimensions import ROOT_SECOND
from boresight.derive.expressions import symbols_in
from boresight.derive.ledger import ellipsoid
from boresight.derive.ledger.navigation import Navigator
from boresight.derive.ledger.numbers import Matrix, digits, zeros
from boresight.derive.ledger.witness import hamilton, quaternion, vector
from boresight.derive.linear import is_rate
from boresight.derive.mechanics.earth import FRAMES
from boresight.derive.model import Function, Measurement, Mechanics, Model, Variable
from boresight.derive.models.variables import INCREMENTS, position
from boresight.derive.units import Unit, units
from boresight.derive.within import within

POINTS, DIRECTIONS = 2, 3  # of F and of what is as dear, and of an error at each of them
MANY = 6  # points of what is cheap
# Powers of two, which are exact balls: s, the part of its box by which a state is moved for a derivative, and that of
# an error whose remainder is looked at.
STEP, MOVED, FINITE = arb((1, -83)), arb((1, -66)), arb((1, -13))
EQUAL = 1e-12  # of an entry, or AT_ALL of the largest of its row, each times the box of its state
AT_ALL = 1e-15
JUMP = 1e-15  # of the box of an estimate: what a strapdown adds to it over STEP is less
LEAST = 1e-9  # of the box of a state in a second: what is smaller measures no row
NOTHING = 1e-28
LEFT_OUT = 0.2  # of a row of h, or of its block: what z has besides, as from an estimate times a long lag
UNSEEN = 1e-4  # of a row of h: a block that it lacks, as of the radii, of gravity or of the level's turn
FOURFOLD = 0.26
ROUND = 0.01  # of what a metre is in rad: an Earth that is taken as a sphere is no fault
ITERATIONS, SETTLED = 40, 1e-72  # of Newton's method, and what it may leave

METRE = units("m", 1)[0]
Values = dict[sp.Symbol, Any]
Reference = Callable[[Mapping[str, Sequence[Any]]], list[Any]]  # of a printed unit: the non-zeros of its results


@dataclass(frozen=True)
class MechanicsCheck:
    """unit: F, G, next, Phi, Q, feedback, a strapdown or a measurement matrix.  against: what it is held against.

    difference: the largest between what is stated and what is exact, as a part of the largest of its row, each entry
    times the box of its state.  entry: the place and size of it, where it is one too many.  ratio: what is left of the
    remainder when the errors are halved; coefficient: the remainder over their square, or of next over dt^5.  order:
    the power of the step with which what is left falls.  Each is None where no remainder is.  why: what is missing for
    the check; then it says nothing, and `ok` is None.  unheld: the reason that the model gives for that, which counts
    as held.  stated: a value of the model that has no function, such as a constant; it is listed, and counts as held.
    """

    model: str
    unit: str
    against: str
    difference: float | None = None
    entry: str = ""
    ratio: float | None = None
    coefficient: float | None = None
    why: str = ""
    order: float | None = None
    unheld: str = ""
    stated: bool = False

    @property
    def ok(self) -> bool | None:
        return None if self.why and not (self.unheld or self.stated) else not self.entry

    @property
    def reason(self) -> str:
        """Why it is not ok."""
        return self.entry or self.why


def check_mechanics(model: Model, reference: Mapping[str, Reference]) -> list[MechanicsCheck]:
    """Every check of one model; reference: of its printed units, by name."""
    checks = [check_strapdown(model, f, level) for f, level in navigating(model)]
    if model.f is not None:
        checks.append(check_own_rate(model, reference["F"]))
        checks.append(
            MechanicsCheck(model.name, "G", "each noise drives one state by itself", 0.0)
            if not any(mixed for _, mixed in mixing(model))
            else MechanicsCheck(model.name, "G", "", why="f says nothing of the noise")
        )
    elif model.kind == "error-state":
        try:
            exact = Exact(model)
            checks += check_error_model(exact, reference["F"]) if model.F is not None else []
            checks.append(check_feedback(exact))
        except LookupError as missing:
            why, rates = str(missing.args[0]), ("F", "G") if model.F is not None else ()
            checks += [MechanicsCheck(model.name, unit, "", why=why) for unit in (*rates, "feedback")]
    checks += [check_measurement(model, m, reference[f"{m.name}_H"]) for m in model.measurements]
    return checks + [check for m in model.measurements if (check := check_residual(model, m))]


# ---------------------------------------------------------------- numbers


def compiled(*matrices: sp.Matrix) -> Callable[[Values], list[Matrix]]:
    """The matrices as functions of values of their symbols."""
    order = sorted(symbols_in(*matrices), key=str)
    run = evaluator(order, matrices)

    def at(values: Values) -> list[Matrix]:
        return [filled(m.shape, entries) for m, entries in zip(matrices, run([values[s] for s in order]), strict=True)]

    return at


def filled(shape: tuple[int, int], entries: Mapping[tuple[int, int], Any]) -> Matrix:
    matrix = zeros(*shape)
    for place, value in entries.items():
        matrix[place] = value
    return matrix


def points(model: Model, check: str, count: int = POINTS) -> list[Values]:
    """Values of all inputs in their boxes and norms, and of a total state; an error state is zero."""
    found: list[Values] = [dict.fromkeys(model.x, arb(0)) for _ in range(count)]
    for v in (*model.inputs, *(model.states if model.kind == "total-state" else ())):
        for values, column in zip(found, exact_points(v, count, check), strict=True):
            values.update(zip(v.symbols, column, strict=True))
    return found


def fields(model: Model, values: Values) -> dict[str, list[Any]]:
    """The inputs by name, and the state as x."""
    named = {v.name: [values[s] for s in v.symbols] for v in model.inputs}
    return named | {"x": [values[s] for s in symbols(model)]}


def symbols(model: Model) -> list[sp.Symbol]:
    """Those of the state; a matrix of them, as in model.x, takes SymPy longer than a strapdown step."""
    return [symbol for block in model.states for symbol in block.symbols]


def plus(values: Values, model: Model, x: Sequence[Any]) -> Values:
    """The values with x added to the state."""
    return values | {s: values[s] + e for s, e in zip(symbols(model), x, strict=True)}


def box(model: Model) -> list[arb]:
    """What each state is measured by."""
    x = state_variable(model)
    return [arb(max(abs(low), abs(high))) for low, high in zip(x.low, x.high, strict=True)]


def slope(function: Callable[[list[Any]], Matrix], scale: Sequence[Any]) -> Matrix:
    """The derivative at zero: a column for each argument, times its scale."""
    columns = []
    for j, size in enumerate(scale):
        unit = [arb(0)] * len(scale)
        ahead, behind = (function([*unit[:j], sign * MOVED * size, *unit[j + 1 :]]) for sign in (1, -1))
        columns.append(list((ahead - behind) / (2 * MOVED)))
    return Matrix([list(row) for row in zip(*columns, strict=True)])


def row_sizes(exact: Matrix, boxes: Sequence[Any] = ()) -> list[float]:
    """The largest of each row; of a row of zeros a part of the box of its state, if it has one."""
    least = [LEAST * float(b) for b in boxes] or [LEAST] * exact.rows
    return [max(largest(exact[i, j] for j in range(exact.cols)), floor) for i, floor in enumerate(least)]


def size(value: Any) -> float:
    """The largest magnitude that a ball allows; infinite where it is no number."""
    most = float(arb(value).abs_upper())
    return most if isfinite(most) else inf


def largest(values: Iterable[Any]) -> float:
    return max(map(size, values), default=0.0)


def apart(numbers: Sequence[float]) -> list[str]:
    """Two numbers in as many digits as it takes to tell them apart."""
    texts = [[f"{value:.{digits}g}" for value in numbers] for digits in (6, 9, 17)]
    return next((text for text in texts if text[0] != text[1]), texts[-1])


@dataclass
class Verdict:
    """The worst of what several points say.  wrong: the largest part by which an entry is off that is named."""

    difference: float = 0.0
    entry: str = ""
    ratio: float | None = None
    coefficient: float | None = None
    order: float | None = None
    wrong: float = 0.0

    def note(self, off: Any, limit: float, entry: str) -> None:
        self.difference = max(self.difference, size(off))
        if not within(size(off), limit) and not self.entry:
            self.entry = entry

    def compare(
        self, stated: Matrix, exact: Matrix, rows: Sequence[str], columns: Sequence[str], scale: Any, sizes: list[float]
    ) -> None:
        """Both times the scale of each column; sizes: of each row.  The entry named is the one that is most off."""
        for (i, row), whole in zip(enumerate(rows), sizes, strict=True):
            for j, column in enumerate(columns):
                off = size(stated[i, j] - exact[i, j])
                part = off / whole if isfinite(off) and isfinite(whole) else inf
                self.difference = max(self.difference, part)
                close = within(off, EQUAL * size(exact[i, j])) or within(part, AT_ALL)
                if not (isfinite(whole) and close) and part > self.wrong:
                    self.wrong = part
                    numbers = [float(m[i, j] / scale[j]) for m in (stated, exact)]
                    mine, theirs = apart(numbers)
                    self.entry = f"{row} by {column}: {mine} stated, {theirs} exact"

    def remainder(self, parts: Iterable[Matrix], sizes: Sequence[float]) -> None:
        """parts: what is left at a finite error and at half of it; sizes: what each row is measured by."""
        left, less = (largest(r / s for r, s in zip(part, sizes, strict=True)) for part in parts)
        if within(left, NOTHING) and within(less, NOTHING):
            return
        ratio = less / left if isfinite(left) and left > 0 else inf
        self.ratio = max(self.ratio or 0.0, ratio)
        self.coefficient = max(self.coefficient or 0.0, left / float(FINITE) ** 2)
        if not within(ratio, FOURFOLD) and not self.entry:
            self.entry = f"half the error leaves {ratio:.3f} of the remainder, not a quarter"

    def check(self, model: Model, unit: str, against: str, lacking: str = "") -> MechanicsCheck:
        """lacking: why a part of the unit could not be held, which is no right where all the rest is right."""
        if lacking and not self.entry:
            return MechanicsCheck(model.name, unit, "", why=lacking)
        return MechanicsCheck(
            model.name, unit, against, self.difference, self.entry, self.ratio, self.coefficient, order=self.order
        )


# ---------------------------------------------------------------- F, G and feedback


class Exact:
    """The strapdown of a model as a step, and its feedback as the way to put an error in.

    Raises LookupError with what the model does not say.
    """

    def __init__(self, model: Model):
        self.model, self.mechanics = model, model.mechanics or Mechanics()
        if model.dt is None:
            raise LookupError("the model names no dt, over which errors could be carried")
        self.fields = {v.name: v for v in model.inputs}
        strapdown, feedback = mechanics_of(model)
        if strapdown is None or feedback is None:
            lacking = " and ".join(name for name, f in (("strapdown", strapdown), ("feedback", feedback)) if f is None)
            raise LookupError(f"the model has no {lacking}")
        for f in (strapdown, feedback):
            for output in f.outputs:
                if output.name not in self.fields:
                    raise LookupError(f"{f.name} returns {output.name}, which is no input of the model")
        self.carried, self.returned = (self.outputs(f) for f in (strapdown, feedback))
        sums = [what for noise, what in self.mechanics.driven if what not in model.states and not is_rate(noise, what)]
        beside = (*INCREMENTS, *(v for v, _ in self.mechanics.step), *sums)
        read = symbols_in(*(o.value for o in strapdown.outputs))
        owners = {v.name: v for v in (*beside, *model.inputs)}
        self.idle = dict.fromkeys(read - {s for v in model.inputs for s in v.symbols}, arb(0))
        for v in beside:
            self.idle |= dict(zip(v.symbols, nearest_zero(v), strict=True))
        self.strapdown, self.feedback = (compiled(*(o.value for o in f.outputs)) for f in (strapdown, feedback))
        self.stepped = compiled(*(sp.Matrix(e) for _, e in self.mechanics.step)) if self.mechanics.step else None
        level = self.mechanics.level
        self.axes = compiled(level.axes) if level else None
        apart = {s for v in (*self.carried, *self.returned) for s in v.symbols} | {model.dt, *self.idle}
        rest = [v for v in model.inputs if read & {*v.symbols} and not apart & {*v.symbols}]
        self.driveable = [
            v for v in owners.values() if read & {*v.symbols} and v not in (*self.carried, *self.returned)
        ]
        self.unstated = self.increments(rest)

    def increments(self, read: Iterable[Variable]) -> list[Variable]:
        """What strapdown adds at once, however short the step; `step` does not state it, so it is put to nothing.

        Raises LookupError where strapdown moves the estimates at once by itself.
        """
        hat, found = points(self.model, "F", 1)[0], []
        boxes = [max(map(abs, ends)) for v in self.returned for ends in zip(v.low, v.high, strict=True)]

        def jumps(one: Values, other: Values) -> list[str]:
            parts = zip(list(self.seen(one) - self.seen(other)), boxes, strict=True)
            names = [s.name for v in self.returned for s in v.symbols]
            return [name for name, (off, most) in zip(names, parts, strict=True) if not within(size(off) / most, JUMP)]

        with precise():
            here = self.after(hat, self.sensed(hat))
            for v in read:
                still = hat | dict(zip(v.symbols, nearest_zero(v), strict=True))
                if jumps(here, self.after(still, self.sensed(still))):
                    found.append(v)
            for v in found:
                self.idle |= dict(zip(v.symbols, nearest_zero(v), strict=True))
            moved = jumps(self.after(hat, self.sensed(hat)), hat)
        if moved:
            raise LookupError(f"strapdown moves {moved[0]} at once, however short the step; see Mechanics.step")
        return found

    def outputs(self, f: Function) -> list[Variable]:
        return [self.fields[output.name] for output in f.outputs]

    def sensed(self, values: Values, dt: Any = STEP) -> Values:
        """What the strapdown reads over the step, the same for estimates and truth."""
        assert self.model.dt is not None
        at = values | self.idle | {self.model.dt: dt}
        if self.stepped:
            for (variable, _), column in zip(self.mechanics.step, self.stepped(at), strict=True):
                at.update(zip(variable.symbols, column, strict=True))
        return {s: at[s] for s in (*self.idle, self.model.dt)} | {
            s: at[s] for variable, _ in self.mechanics.step for s in variable.symbols
        }

    def after(self, values: Values, sensed: Values) -> Values:
        return self.updated(values, self.carried, self.strapdown(values | sensed))

    def updated(self, values: Values, variables: list[Variable], columns: list[Matrix]) -> Values:
        changed = dict(values)
        for variable, column in zip(variables, columns, strict=True):
            changed.update(zip(variable.symbols, column, strict=True))
        return changed

    def corrected(self, hat: Values, x: Sequence[Any]) -> Values:
        """The estimates once x is taken out, in the axes against which the errors stand."""
        return self.updated(hat, self.returned, self.feedback(hat | dict(zip(symbols(self.model), x, strict=True))))

    def true(self, hat: Values, x: Sequence[Any]) -> Values:
        """The same in the true axes."""
        found = self.corrected(hat, x)
        return self.turned(found, found, hat)

    def turned(self, values: Values, to: Values, from_: Values) -> Values:
        """What is resolved in the level of the place `from_`, resolved in that of the place `to`."""
        level = self.mechanics.level
        if level is None or self.axes is None:
            return values
        C = self.axes(to)[0].T * self.axes(from_)[0]
        v, q = (Matrix([values[s] for s in one.symbols]) for one in (level.vector, level.quaternion))
        return self.updated(values, [level.vector, level.quaternion], [C * v, hamilton(quaternion(C), q)])

    def seen(self, values: Values) -> Matrix:
        """What feedback returns, as one column."""
        return vector(*(values[s] for v in self.returned for s in v.symbols))

    def read_out(self, hat: Values, true: Values, inverse: Matrix) -> Matrix:
        """The x which feedback takes out of `hat` to have `true`: Newton's method with one slope, near to it."""
        wanted, x = self.seen(self.turned(true, hat, true)), zeros(self.model.n, 1)
        for _ in range(ITERATIONS):
            missing = self.seen(self.corrected(hat, list(x))) - wanted
            if within(largest(missing), SETTLED):
                break
            x = Matrix([value.mid() for value in x - inverse * missing])  # a correction needs no bound of its error
        return x


class Moving:
    """A model at one point, and how errors move there; in units of `scale` a state."""

    def __init__(self, exact: Exact, hat: Values, scale: Sequence[Any]):
        self.exact, self.hat, self.n = exact, hat, exact.model.n
        self.sensed = exact.sensed(hat)
        self.J = slope(lambda x: exact.seen(exact.corrected(hat, x)), scale)
        blind = [s.name for j, s in enumerate(exact.model.x) if within(largest(self.J[:, j]), NOTHING)]
        if blind:
            raise LookupError(f"feedback does not take out {', '.join(blind)}")
        left = (self.J.T * self.J).inv() * self.J.T
        self.inverse = Matrix([[(left[i, j] * scale[i]).mid() for j in range(left.cols)] for i in range(self.n)])
        self.driven = {
            n: (s, arb(1) if is_rate(noise, what) else STEP)
            for noise, what in exact.mechanics.driven
            for s, n in zip(what.symbols, noise.symbols, strict=True)
        }

    def rate(self, x: Sequence[Any]) -> Matrix:
        """Of the error x, with perfect sensors."""
        return (self.parted(x, self.sensed) - Matrix(list(x))) / STEP

    def parted(self, x: Sequence[Any], sensed: Values) -> Matrix:
        """What becomes of the error x over a step, which may go backwards in time."""
        after, true = (self.exact.after(values, sensed) for values in (self.hat, self.exact.true(self.hat, x)))
        return self.exact.read_out(after, true, self.inverse)

    def by_noise(self, n: sp.Symbol) -> Matrix:
        """The rate of no error, where what a noise adds to is wrong by 1: a rate, an integral a second, or a state."""
        s, over = self.driven[n]
        return self.wrong(s, self.sensed, over, STEP)

    def wrong(self, s: sp.Symbol, sensed: Values, over: Any = 1, step: Any = 1) -> Matrix:
        """What becomes of no error over a step where what strapdown reads is wrong by `over`; of a state by 1 alone."""
        states = symbols(self.exact.model)
        if s in states:
            return Matrix([arb(int(s == own)) for own in states])
        here = (self.hat | sensed)[s]

        def apart(w: Sequence[Any]) -> Matrix:
            after, true = (self.exact.after(self.hat, sensed | {s: here + part * w[0]}) for part in (over, 0))
            return self.exact.read_out(after, true, self.inverse) / step

        return slope(apart, [arb(1)])


def scaled(matrix: Matrix, scale: Sequence[Any]) -> Matrix:
    """Each column times its scale."""
    return Matrix([[matrix[i, j] * scale[j] for j in range(matrix.cols)] for i in range(matrix.rows)])


def finite_errors(model: Model, scale: Sequence[Any], *words: str) -> list[Matrix]:
    """Errors in directions that the words and the names of the states draw."""
    drawn = [generator("direction", *words, s.name).uniform(-1, 1, DIRECTIONS).tolist() for s in model.x]
    return [
        Matrix([arb(of[k]) * size * FINITE for of, size in zip(drawn, scale, strict=True)]) for k in range(DIRECTIONS)
    ]


def check_feedback(exact: Exact) -> MechanicsCheck:
    """That no error changes nothing, and what is an error of a number has the model's sign."""
    model, back, scale = exact.model, Verdict(), box(exact.model)
    with precise():
        for hat in points(model, "F"):
            compare_feedback(back, Moving(exact, hat, scale), scale)
    return back.check(model, "feedback", f"an error of {model.error}")


def check_error_model(exact: Exact, F_of: Reference) -> list[MechanicsCheck]:
    """F and G."""
    model, n = exact.model, exact.model.n
    names, scale = [s.name for s in model.x], box(model)
    F_verdict, G_verdict = Verdict(), Verdict()
    G_at = compiled(model.G)
    with precise():
        for k, hat in enumerate(points(model, "F")):
            moving = Moving(exact, hat, scale)
            F = filled((n, n), F_of(fields(model, hat))[0])
            found = slope(moving.rate, scale)
            sizes = row_sizes(found, scale)
            F_verdict.compare(scaled(F, scale), found, names, names, scale, sizes)
            for error in finite_errors(model, scale, "F", str(k)):
                F_verdict.remainder((moving.rate(list(e)) - F * e for e in (error, error / 2)), sizes)
            compare_noise(G_verdict, moving, G_at(hat)[0])
    if F_verdict.entry and exact.unstated:
        nothing = ", ".join(v.name for v in exact.unstated)
        F_verdict.entry += f"; Mechanics.step does not state {nothing}, which is put to nothing over the step"
    law = "strapdown and feedback"
    return [
        F_verdict.check(model, "F", law),
        G_verdict.check(model, "G", law, undriven(exact)),
    ]


def compare_feedback(back: Verdict, moving: Moving, scale: Sequence[Any]) -> None:
    """No error changes nothing, and what is an error of a number itself, in its own unit, has the model's sign.

    An error in another unit, such as metres of a latitude, is held by F and H, which read it out of what feedback does;
    so is one beside it in the same vector, such as metres down of a height.
    """
    exact, hat, J = moving.exact, moving.hat, moving.J
    sign = -1 if exact.model.error == ERRORS[0] else 1
    still = exact.seen(exact.corrected(hat, [arb(0)] * moving.n)) - exact.seen(hat)
    names = [(v, s.name, unit) for v in exact.returned for s, unit in zip(v.symbols, unit_of(v), strict=True)]
    errors = [unit for block in exact.model.states for unit in unit_of(block)]
    moved = [[j for j in range(J.cols) if not within(size(J[i, j]), NOTHING)] for i in range(len(names))]
    other = {
        v.name for (v, _, unit), moves in zip(names, moved, strict=True) if len(moves) == 1 and unit != errors[moves[0]]
    }
    for i, (v, name, _) in enumerate(names):
        moves = moved[i]
        back.note(still[i], NOTHING, f"{name} moves by {float(still[i]):.3g} where no error is taken out")
        if v.norm is None and len(moves) == 1 and v.name not in other:
            by = float(J[i, moves[0]] / scale[moves[0]])
            back.note(by - sign, EQUAL, f"{name} by {exact.model.x[moves[0]].name}: {by:.6g} stated, {sign} exact")
        level = next((one for key, one in ellipsoid.LEVELS.items() if position(FRAMES[key]).name == v.name), None)
        if level and v.norm is None and len(moves) == 1 and name in ("lat", "lon") and errors[moves[0]] == METRE:
            by, full = float(J[i, moves[0]] / scale[moves[0]]), sign * radians_per_metre(level, v, hat, name)
            text = f"{name} by {exact.model.x[moves[0]].name}: {by:.6g} stated, {full:.6g} exact"
            back.note(by / full - 1, ROUND, text)


def radians_per_metre(level: Any, v: Variable, hat: Values, name: str) -> float:
    """How much a latitude or a longitude grows for a metre to the north or the east."""
    with digits(ellipsoid.WORKING):
        place = Matrix([hat[s] for s in v.symbols])
        by = level.slope(place).inv() * level.axes(place)
        row = [s.name for s in v.symbols].index(name)
        return largest(by[row, j] for j in range(3))


def unit_of(v: Variable) -> list[Unit]:
    return units(v.unit, v.size)


def compare_noise(verdict: Verdict, moving: Moving, G: Matrix) -> None:
    """G, each column with either sign: white noise has none.  What drives no sensor is held where it drives one state,
    by itself and once; G of another cannot be known."""
    model = moving.exact.model
    names = list(map(str, model.noise))
    exact = zeros(G.rows, G.cols)
    for k, n in enumerate(model.noise):
        if n in moving.driven:
            column = moving.by_noise(n)
            exact[:, k] = column if float((G[:, k].T * column)[0]) >= 0 else -column
        else:
            exact[:, k] = G[:, k]
    verdict.compare(G, exact, [s.name for s in model.x], names, [1] * len(names), row_sizes(exact, box(model)))


def mixing(model: Model) -> list[tuple[Any, bool]]:
    """The noises, and of each whether it does more than to drive one state by itself, once."""
    columns = [[e for e in column if e != 0] for column in model.G.T.tolist()]
    return [(w, column not in ([1], [-1])) for w, column in zip(model.noise, columns, strict=True)]


def undriven(exact: Exact) -> str:
    """Why some columns of G cannot be held, and what to state; nothing where all can."""
    model, mechanics = exact.model, exact.mechanics
    stated = {s for noise, _ in mechanics.driven for s in noise.symbols}
    owners = {s: v for v in model.inputs for s in v.symbols}
    lost = [w for w, mixed in mixing(model) if mixed and w not in stated]
    names = list(dict.fromkeys(owners[w].name if w in owners else str(w) for w in lost))
    if not lost:
        return ""
    first = owners.get(lost[0])
    read = [v.name for v in exact.driveable if first and unit_of(v)[0].like(unit_of(first)[0] * ROOT_SECOND)]
    what = f"({names[0]}, {read[0] if read else 'what it adds to over a second'})"
    verb = "is" if len(names) == 1 else "are"
    return f"{', '.join(names)} {verb} not said to add to anything; state driven=({what},) of Mechanics"


def check_own_rate(model: Model, F_of: Reference) -> MechanicsCheck:
    """F against differences of the f that the model states."""
    n, scale, names, verdict = model.n, box(model), [s.name for s in model.x], Verdict()
    f = compiled(model.f)
    with precise():
        for here in points(model, "F", MANY):

            def displaced(x: Sequence[Any], here: Values = here) -> Matrix:
                return f(plus(here, model, x))[0]

            found = slope(displaced, scale)
            F = filled((n, n), F_of(fields(model, here))[0])
            verdict.compare(scaled(F, scale), found, names, names, scale, row_sizes(found, scale))
    return verdict.check(model, "F", "f")


# ---------------------------------------------------------------- H


class Corrected:
    """The inputs once `feedback` has taken an error out of the estimates.

    What feedback does not return stands still, such as a measured value.  What `Mechanics.step` states by an estimate
    follows it: increments stand still, and a rate from which the bias is removed changes with the bias.
    """

    def __init__(self, model: Model, feedback: Function):
        self.model, inputs = model, {v.name: v for v in model.inputs}
        self.returned = [inputs[o.name] for o in feedback.outputs if o.name in inputs]
        self.feedback = compiled(*(o.value for o in feedback.outputs if o.name in inputs))
        known = {s for v in self.returned for s in v.symbols}
        others = {s: v for v in model.inputs for s in v.symbols if s not in known and s != model.dt}
        self.following: list[tuple[list[Variable], Callable[[Values], list[Matrix]]]] = []
        done: set[str] = set()
        for _, expression in (model.mechanics or Mechanics()).step:
            read = symbols_in(expression)
            follow = list(dict.fromkeys(v for s, v in others.items() if s in read and v.name not in done))
            if read & known and follow and sum(v.size for v in follow) == len(expression):
                self.following.append((follow, compiled(sp.Matrix(expression))))
                done |= {v.name for v in follow}
        self.still = [
            v for v in model.inputs if v not in self.returned and v.name not in done and model.dt not in v.symbols
        ]

    def estimates(self, values: Values, x: Sequence[Any]) -> Values:
        """The values with what feedback returns alone."""
        after = dict(values)
        columns = self.feedback(values | dict(zip(symbols(self.model), x, strict=True)))
        for v, column in zip(self.returned, columns, strict=True):
            after.update(zip(v.symbols, column, strict=True))
        return after

    def __call__(self, values: Values, x: Sequence[Any]) -> Values:
        after = self.estimates(values, x)
        for follow, stated in self.following:
            order = [s for v in follow for s in v.symbols]
            scale = [arb(max(map(abs, ends))) for v in follow for ends in zip(v.low, v.high, strict=True)]

            def off(by: Sequence[Any], after: Values = after, order: Any = order, stated: Any = stated) -> Matrix:
                return stated(after | {s: after[s] + e for s, e in zip(order, by, strict=True)})[0] - stated(values)[0]

            try:
                inverse, by = slope(off, scale).inv(), zeros(len(order), 1)
            except ZeroDivisionError:
                raise LookupError(f"Mechanics.step does not determine {follow[0].name}") from None
            for _ in range(ITERATIONS):
                missing = off(list(by))
                if within(largest(missing), SETTLED):
                    break
                by = Matrix([(b - s * d).mid() for b, s, d in zip(by, scale, inverse * missing, strict=True)])
            after.update((s, after[s] + e) for s, e in zip(order, by, strict=True))
        return after


class Seen:
    """A measurement: what it sees of an error, and the points where its H holds.

    Raises LookupError where there is nothing exact.
    """

    def __init__(self, model: Model, m: Measurement):
        self.model, self.law = model, m.first_order
        inputs = {v.name: v for v in model.inputs}
        self.exact = next(o for o in model.measurements if o.name == self.law.of) if self.law and self.law.of else m
        (_, feedback), self.hint = mechanics_of(model), ""
        if self.exact.h is not None:
            self.against, h = "h", compiled(self.exact.h)
            self.left = lambda here, x: h(plus(here, model, x))[0]
        elif m.z is None or feedback is None:
            lacking = "feedback" if m.z is not None else "z, which the caller brings"
            raise LookupError(f"it has no {lacking}; state an h beside H, with first_order=FirstOrder()")
        else:
            self.against, z, corrected = "z and feedback", compiled(m.z), Corrected(model, feedback)
            self.left = lambda here, x: z(here)[0] - z(corrected(here, x))[0]
            still = [v.name for v in corrected.still if symbols_in(m.z) & set(v.symbols)]
            if still:
                names = ", ".join(still)
                self.hint = f"; {names} kept constant, as a measured value is; if it is none, give h and FirstOrder()"
        self.tied = [(inputs[name], compiled(sp.Matrix(e))) for name, e in self.law.tied] if self.law else []
        small = inputs[self.law.small] if self.law and self.law.small else None
        if small and any(zero != 0 for zero in nearest_zero(small)):
            raise LookupError(f"{small.name} is neglected, and its box does not hold 0; widen it")
        self.small = small.symbols if small else ()
        both = (self.exact, m) if self.exact is not m else (m,)  # what H neglects, its own z may neglect
        self.zs = {one.name: compiled(one.z) for one in both if self.small and one.z is not None}

    def less_turns(self, change: Matrix) -> Matrix:
        """A change of z, of an angle less whole turns."""
        return Matrix([wrapped(e) if i in self.exact.angles else e for i, e in enumerate(change)])

    def at(self, values: Values, part: Any) -> Values:
        """The point, what H neglects made a part of itself, and what is tied to the others with it."""
        here = values | {s: part * values[s] for s in self.small}
        for variable, expression in self.tied:
            here.update(zip(variable.symbols, expression(here)[0], strict=True))
        return here

    def residual(self, name: str, values: Values, part: Any) -> float:
        """The largest of a z there."""
        z = self.zs[name](self.at(values, part))[0]
        return largest(wrapped(part) if i in self.exact.angles else part for i, part in enumerate(z))


def check_measurement(model: Model, m: Measurement, H_of: Reference) -> MechanicsCheck:
    """H against the exact h, or z before and after feedback, where what H neglects is zero and what is tied to the
    others follows from them; and that z vanishes there, but for the second order of what is neglected.

    A total state is anywhere in its box, an error state zero.
    """
    try:
        seen = Seen(model, m)
        return compare_measurement(model, m, H_of, seen).check(model, f"{m.name}_H", seen.against)
    except LookupError as missing:
        return MechanicsCheck(model.name, f"{m.name}_H", "", why=str(missing.args[0]))


def compare_measurement(model: Model, m: Measurement, H_of: Reference, seen: Seen) -> Verdict:
    columns, scale, verdict = [s.name for s in model.x], box(model), Verdict()
    with precise():
        for k, values in enumerate(points(model, "H", MANY)):
            here = seen.at(values, 0)
            origin = seen.left(here, [arb(0)] * model.n)

            def change(x: Sequence[Any], here: Values = here, origin: Matrix = origin) -> Matrix:
                return seen.less_turns(seen.left(here, x) - origin)

            H = filled((len(m.rows), model.n), H_of(fields(model, here))[0])
            found = slope(change, scale)
            sizes = row_sizes(found)
            if model.kind == "error-state" and seen.exact.z is not None:  # both are zero where no error is
                for row, off, whole in zip(m.rows, seen.less_turns(origin), sizes, strict=True):
                    verdict.note(off / whole, AT_ALL, f"h of {row} is {float(off):.6g} where no error is")
            verdict.compare(scaled(H, scale), found, m.rows, columns, scale, sizes)
            for error in finite_errors(model, scale, "H", str(k)):
                verdict.remainder((change(list(e)) - H * e for e in (error, error / 2)), sizes)
            for name in seen.zs:
                whole, half = (seen.residual(name, values, part) for part in (FINITE, FINITE / 2))
                vanishes = within(whole, NOTHING) or (isfinite(whole) and within(half, FOURFOLD * whole))
                if not vanishes and not verdict.entry:
                    tied = " and ".join(v.name for v, _ in seen.tied)
                    part = largest(FINITE * values[s] for s in seen.small)
                    small = f"{name}_z is {whole:.3g} for a {m.first_order and m.first_order.small} of {part:.3g}"
                    verdict.entry = f"{small}, where {tied} should make it vanish to first order"
    if verdict.entry:
        verdict.entry += seen.hint
    return verdict


def check_residual(model: Model, m: Measurement) -> MechanicsCheck | None:
    """z against h, by every error that moves z as feedback takes it out.

    A row of the other sign is wrong, and so is an entry that is off by more than LEFT_OUT of its row, or of what is by
    the same block of states.  A block that one of them lacks is not held from UNSEEN of its row on.  What is closer is
    left out of h, or of what follows from an estimate: then None, as where z moves by nothing.
    """
    _, feedback = mechanics_of(model)
    if m.z is None or m.h is None or feedback is None:
        return None
    z, h, corrected, scale = compiled(m.z), compiled(m.h), Corrected(model, feedback), box(model)
    verdict, names, lacking = Verdict(), [s.name for s in model.x], ""

    def both(here: Values, x: Sequence[Any]) -> Matrix:
        return Matrix([*(z(here)[0] - z(corrected(here, x))[0]), *h(plus(here, model, x))[0]])

    try:
        with precise():
            for here in points(model, "z"):
                by = slope(partial(both, here), scale)
                by_z, by_h = by[: len(m.rows), :], by[len(m.rows) :, :]
                moved = [j for j in range(model.n) if not within(largest(by_z[:, j]), NOTHING)]
                if not moved:
                    return None
                by_z, by_h = (Matrix([[of[i, j] for j in moved] for i in range(of.rows)]) for of in (by_z, by_h))
                for i, row in enumerate(m.rows):
                    sum_of = largest(by_z[i, j] + by_h[i, j] for j in range(len(moved)))
                    if within(sum_of, EQUAL * largest(by_h[i, j] for j in range(len(moved)))) and sum_of < LEAST:
                        verdict.entry = f"{row} falls where h grows; z is computed - measured"
                        return verdict.check(model, f"{m.name}_z", "h and feedback")
                columns, sizes = [names[j] for j in moved], row_sizes(by_h)
                for row, off, whole in zip(m.rows, h(here)[0], sizes, strict=True):  # H is held where z is zero alone
                    if not within(size(off) / whole, AT_ALL):
                        verdict.entry = f"h of {row} is {float(off):.6g} where no error is"
                        return verdict.check(model, f"{m.name}_z", "h and feedback")
                verdict.compare(by_z, by_h, m.rows, columns, [scale[j] for j in moved], sizes)
                wrong, lacks = by_blocks(model, m.rows, by_z, by_h, columns, sizes)
                if wrong and within(verdict.wrong, LEFT_OUT):
                    verdict.entry, verdict.wrong = wrong, inf  # however small its part of the row
                lacking = lacking or lacks
    except LookupError:
        return None
    if verdict.entry and within(verdict.wrong, LEFT_OUT):
        why = f"h does not change as z does: {lacking}"
        return MechanicsCheck(model.name, f"{m.name}_z", "", why=why) if lacking else None
    if verdict.entry:
        still = [v.name for v in corrected.still if symbols_in(m.z) & set(v.symbols)]
        verdict.entry = f"z before and after feedback: {verdict.entry}" + (
            f"; {', '.join(still)} kept constant; Mechanics.step can state how it changes" if still else ""
        )
    return verdict.check(model, f"{m.name}_z", "h and feedback")


def by_blocks(
    model: Model, rows: Sequence[str], by_z: Matrix, by_h: Matrix, columns: Sequence[str], sizes: Sequence[float]
) -> tuple[str, str]:
    """What is off by more than LEFT_OUT of its row and block of states, and what of that one of both lacks."""
    wrong = lacking = ""
    scale = dict(zip((s.name for s in model.x), box(model), strict=True))
    for (i, row), block in product(enumerate(rows), model.states):
        at = [columns.index(s.name) for s in block.symbols if s.name in columns]
        parts = [largest(of[i, j] for j in at) for of in (by_z, by_h)]
        off, j = max(((size(by_z[i, j] - by_h[i, j]), j) for j in at), default=(0.0, 0))
        if within(off, LEFT_OUT * max(parts)):
            continue
        mine, theirs = (f"{float(of[i, j] / scale[columns[j]]):.6g}" for of in (by_z, by_h))
        if min(parts) > LEAST * sizes[i]:
            wrong = wrong or f"{row} by {columns[j]}: {mine} stated, {theirs} exact"
        elif not within(off, UNSEEN * sizes[i]):
            lacking = lacking or f"{row} by {columns[j]}: {mine} in z, {theirs} in h"
    return wrong, lacking


def wrapped(angle: arb) -> arb:
    turn = 2 * arb.pi()
    return angle - turn * round(float(angle / turn)) if angle.is_finite() else angle


# ---------------------------------------------------------------- strapdown


NAVIGATION = {name: (position(frame).name, "v_n", "q_b2n_wxyz") for name, frame in FRAMES.items()}


def navigating(model: Model) -> list[tuple[Function, ellipsoid.Level]]:
    """The functions that carry position, velocity and attitude, and the level that the model's frame names."""
    level = ellipsoid.LEVELS.get(model.frame[:3])
    functions = [f for f in (model.mechanics.strapdown if model.mechanics else None, *model.functions) if f]
    increments = set(INCREMENTS[0].symbols)
    return [
        (f, level)
        for f in functions
        if level
        and {o.name for o in f.outputs} >= set(NAVIGATION[model.frame[:3]])
        and increments <= symbols_in(*(o.value for o in f.outputs))
    ]


def check_strapdown(model: Model, f: Function, level: ellipsoid.Level) -> MechanicsCheck:
    """A short step against Newton's law; what else the function reads, such as biases, is zero."""
    fields, carried = {v.name: v for v in model.inputs}, NAVIGATION[model.frame[:3]]
    dt = next(v for v in model.inputs if v.name == "dt").scalar
    outputs = [next(o for o in f.outputs if o.name == name) for name in carried]
    run = compiled(*(o.value for o in outputs))
    rows = [s.name for name in carried for s in fields[name].symbols]
    verdict = Verdict()
    rng = generator("newton")
    for drawn in points(model, "strapdown"):
        now = [Matrix([drawn[s] for s in fields[name].symbols]) for name in carried]
        omega, force = (Matrix([arb(float(c)) for c in rng.uniform(-size, size, 3)]) for size in (1, 20))
        values: Values = {s: zero for v in model.inputs for s, zero in zip(v.symbols, nearest_zero(v), strict=True)}
        values |= {dt: STEP}
        for name, column in zip(carried, now, strict=True):
            values.update(zip(fields[name].symbols, column, strict=True))
        for variable, sensed in zip(INCREMENTS, (omega, force, omega, force), strict=True):
            values.update(zip(variable.symbols, sensed * STEP, strict=True))
        with precise():
            rates = [(after - before) / STEP for after, before in zip(run(values), now, strict=True)]
        with digits(ellipsoid.WORKING):
            p, v, q = now
            C = rotation_of(q)
            newton = Navigator(p, v, C, force, omega, level)
            exact = [newton.position_rate, newton.velocity_rate, quaternion_rate(q, omega, newton.omega_in_n)]
        for mine, theirs, part in zip(rates, exact, (0, 3, 6), strict=True):
            with precise():
                verdict.compare(mine, theirs, rows[part : part + mine.rows], ["t"], [1], row_sizes(theirs))
    return verdict.check(model, f.name, "Newton's law on the turning ellipsoid")


def quaternion_rate(q: Matrix, omega: Matrix, omega_in_n: Matrix) -> Matrix:
    """Of a body that turns by omega in its own axes, against a level that turns by omega_in_n in its own."""
    return (hamilton(q, vector(0, *omega)) - hamilton(vector(0, *omega_in_n), q)) / 2


def rotation_of(q: Matrix) -> Matrix:
    """C of a unit quaternion: each axis turned."""
    back = vector(q[0], -q[1], -q[2], -q[3])
    turned = [hamilton(hamilton(q, vector(0, *axis)), back) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    return Matrix([[turned[j][i + 1] for j in range(3)] for i in range(3)])
