"""What is flown over steps of time held against the flow of the equation, in many digits: next, Phi, Q, the strapdown.

Of a total state the flow is that of f, by Gauss and Legendre's method of the sixth order.  Of an error state it is that
of two flights of the strapdown: they part from a small error, which `feedback` puts in and its inverse reads out, as
Phi at the middle of the step says.  Q is the integral of Lyapunov's equation.  Over an instant too short for the Earth
to be felt, a strapdown gives what a body does that turns and accelerates unevenly: coning, sculling and scrolling.
What is left of each must fall with the power of the step that is claimed.
"""

from collections.abc import Callable, Mapping, Sequence
from math import inf, isfinite, log2
from typing import Any

from flint import arb

from boresight.codegen.functions.reference import precise
from boresight.codegen.functions.samples import generator
from boresight.codegen.mechanics import (
    FINITE,
    LEAST,
    MANY,
    MOVED,
    NAVIGATION,
    STEP,
    Exact,
    MechanicsCheck,
    Moving,
    Reference,
    Values,
    Verdict,
    box,
    compiled,
    fields,
    filled,
    finite_errors,
    largest,
    navigating,
    points,
    row_sizes,
    scaled,
    size,
    slope,
)
from boresight.codegen.points import nearest_zero
from boresight.derive.expressions import symbols_in
from boresight.derive.ledger import ellipsoid
from boresight.derive.ledger.numbers import Matrix, digits, zeros
from boresight.derive.ledger.witness import hamilton, vector
from boresight.derive.linear import is_rate
from boresight.derive.model import Function, Model
from boresight.derive.models.variables import INCREMENTS
from boresight.derive.within import within

SHORT = arb((1, -32))  # s, a step whose remainder is looked at, of an error state
FLIGHT = arb((1, -24))  # s, one of a total state, whose remainder falls faster
SEEN = arb((1, -7))  # s, a step at which a wrong entry of Phi is named
TURNED = arb((1, -13))  # rad and m/s over one interval of the uneven motion, about
TERMS = 24  # of its power series: TURNED to this power is beyond the digits
FELT = 1e-15  # of the motion: what the Earth adds is less
NOTHING = 1e-40  # of a row: what is less is no remainder
FLOWN, ADDED = 5, 4  # the powers of dt with which one step of a total state and its Q err
TRIED = 4  # points for each that is looked at, where some have no answer
ITERATIONS = 12  # each wins a factor of dt
SLACK = 0.01  # of a power


def check_flown(model: Model, reference: Mapping[str, Reference]) -> list[MechanicsCheck]:
    """Every check of one model; reference: of its printed units, by name."""
    checks = [check_motion(model, f, level) for f, level in navigating(model)]
    if model.kind == "error-state":
        check = check_transition if model.F is not None else check_step
        try:
            checks.append(check(Exact(model), reference))
        except LookupError as missing:
            checks.append(MechanicsCheck(model.name, "Phi", "", why=str(missing.args[0])))
        checks += check_still(model, reference) if model.F is not None else [check_added(model, reference)]
    elif model.f is not None:
        checks += [check_derivative(model, reference), *check_flow(model, reference)]
    elif model.next is not None:
        given = [MechanicsCheck(model.name, unit, "", why="it is what the model gives") for unit in ("next", "Q")]
        checks += [check_derivative(model, reference), *given]
    return checks


def falls(
    verdict: Verdict,
    parts: Sequence[Matrix],
    sizes: Sequence[float],
    power: int,
    rows: Sequence[str],
    columns: Sequence[str] = (),
    nothing: float = NOTHING,
) -> None:
    """That every entry of what a step leaves falls with this power of it, or a higher one.

    parts: what a step and half of it leave; sizes: what each row is measured by.
    """
    left, less = parts
    for i, row in enumerate(rows):
        for j in range(left.cols):
            off, half = (size(part[i, j]) / sizes[i] if isfinite(sizes[i]) else inf for part in (left, less))
            if within(off, nothing) and within(half, nothing):
                continue
            verdict.difference = max(verdict.difference, off)
            found = power_of(off, half)
            if verdict.order is None or found < verdict.order:
                verdict.order = found
                if not within(power - found, SLACK):
                    where = f"{row} by {columns[j]}" if columns else row
                    verdict.entry = f"{where}: what is left falls with dt^{found:.2f}, not dt^{power}"


def power_of(off: float, half: float) -> float:
    """The power of the step with which what is left falls; -inf where one of both is no number."""
    if not (isfinite(off) and isfinite(half)):
        return -inf
    return log2(off / half) if off and half else (-inf if half else inf)


# ---------------------------------------------------------------- error states


def check_transition(exact: Exact, reference: Mapping[str, Reference]) -> MechanicsCheck:
    """Phi at the middle of a step against two flights, which part there and are followed to both of its ends."""
    model, n = exact.model, exact.model.n
    scale, names, verdict = box(model), [s.name for s in model.x], Verdict()
    with precise():
        for k, middle in enumerate(points(model, "Phi")):
            moving = Moving(exact, middle, scale)
            error = finite_errors(model, scale, "Phi", str(k))[0]
            rates = scaled(filled((n, n), reference["F"](fields(model, middle))[0]), scale)
            sizes = [float(SHORT) * size for size in row_sizes(rates, scale)]

            def left(x: Sequence[Any], dt: Any, moving: Moving = moving) -> Matrix:
                """The error at the end of the step, less Phi times that at its start."""
                middle = moving.hat
                start, end = (moving.parted(x, exact.sensed(middle, sign * dt / 2)) for sign in (-1, 1))
                Phi = filled((n, n), reference["Phi"](fields(model, middle | {model.dt: dt}))[0])
                return end - Phi * start

            def first_order(dt: Any, error: Matrix = error) -> Matrix:
                ahead, behind = (left(list(sign * MOVED * error), dt) for sign in (1, -1))
                return (ahead - behind) / (2 * MOVED)

            at_whole, at_half = first_order(SHORT), first_order(SHORT / 2)
            falls(verdict, (at_whole / FINITE, at_half / FINITE), sizes, min(model.order, 2) + 1, names)
            if verdict.entry:
                off = slope(lambda x: left(x, SEEN), scale)
                verdict.entry = f"{most_off(off, rates, scale, names)}; {verdict.entry}"
                break
            verdict.remainder((left(list(part * error), SHORT) - part * at_whole for part in (1, arb(1) / 2)), sizes)
    return verdict.check(model, "Phi", "two flights of strapdown and feedback")


def over_step(exact: Exact, hat: Values, scale: Sequence[Any]) -> tuple[Moving, Values]:
    """The model at a point, with errors read out where a whole step leads; and what of that no input has."""
    still = {s: zero for s, zero in exact.idle.items() if s not in hat}
    moving = Moving(exact, hat, scale)
    moving.inverse = Moving(exact, exact.after(hat, still), scale).inverse
    return moving, still


def check_step(exact: Exact, reference: Mapping[str, Reference]) -> MechanicsCheck:
    """Phi of a model in discrete time against the step of its strapdown, with what that reads as it is."""
    model, n = exact.model, exact.model.n
    scale, names, verdict = box(model), [s.name for s in model.x], Verdict()
    with precise():
        for hat in points(model, "Phi"):
            moving, still = over_step(exact, hat, scale)
            found = slope(lambda x, m=moving, s=still: m.parted(x, s), scale)  # type: ignore[misc]
            Phi = filled((n, n), reference["Phi"](fields(model, hat))[0])
            verdict.compare(scaled(Phi, scale), found, names, names, scale, row_sizes(found, scale))
    return verdict.check(model, "Phi", "the step of strapdown, and feedback")


def check_added(model: Model, reference: Mapping[str, Reference]) -> MechanicsCheck:
    """Q of a model in discrete time: of what each noise adds to in a step, where the model says it."""
    mechanics = model.mechanics
    if mechanics is None or not mechanics.driven:
        return MechanicsCheck(
            model.name, "Q", "", why="it is what the model gives; Mechanics(driven=...) would hold it"
        )
    exact, n, verdict = Exact(model), model.n, Verdict()
    scale, names = box(model), [s.name for s in model.x]
    with precise():
        for hat in points(model, "Q"):
            moving, still = over_step(exact, hat, scale)
            dt, found = hat[model.dt], zeros(n, n)
            for noise, what in mechanics.driven:
                variance = [hat[w] ** 2 * (1 / dt if is_rate(noise, what) else dt) for w in noise.symbols]
                for s, added in zip(what.symbols, variance, strict=True):
                    column = moving.wrong(s, still)
                    found += column * column.T * added
            Q = filled((n, n), reference["Q"](fields(model, hat))[0])
            verdict.compare(Q, found, names, names, [1] * n, row_sizes(found))
    return verdict.check(model, "Q", "the noises of a step")


def most_off(off: Matrix, rates: Matrix, scale: Sequence[Any], names: Sequence[str]) -> str:
    """The entry of Phi that is most off; off: exact - stated, and rates: F, each column times the box of its state."""
    sizes = row_sizes(rates, scale)
    places = [(i, j) for i in range(off.rows) for j in range(off.cols)]
    i, j = max(places, key=lambda at: abs(float(off[at])) / sizes[at[0]])
    return f"{names[i]} by {names[j]} is {-float(off[i, j] / scale[j]):.3g} too large over {float(SEEN):.3g} s"


def check_still(model: Model, reference: Mapping[str, Reference]) -> list[MechanicsCheck]:
    """Phi and Q where F and the noise stand still over the step."""
    n, names, transition, noise = model.n, [s.name for s in model.x], Verdict(), Verdict()
    with precise():
        for values in points(model, "Q"):
            F, S = (filled((n, n), reference[unit](fields(model, values))[0]) for unit in ("F", "Qc"))
            parts = []
            for dt in (SHORT, SHORT / 2):
                now = fields(model, values | {model.dt: dt})
                stated = [filled((n, n), reference[unit](now)[0]) for unit in ("Phi", "Q")]
                exact = transition_and_noise(F, S, dt)
                parts.append([mine - theirs for mine, theirs in zip(stated, exact, strict=True)])

            for verdict, two, whole, power in zip(
                (transition, noise), zip(*parts, strict=True), (F, S), (model.order + 1, model.order + 2), strict=True
            ):
                sizes = [float(SHORT) * size for size in row_sizes(whole, box(model))]
                falls(verdict, two, sizes, power, names, names)
    return [
        transition.check(model, "Phi", "exp(F dt)"),
        noise.check(model, "Q", "the integrated Lyapunov equation"),
    ]


def transition_and_noise(F: Matrix, S: Matrix, dt: Any) -> tuple[Matrix, Matrix]:
    """exp(F dt) and the integral of exp(F s) S exp(F s)' over dt, by one exponential: Van Loan 1978."""
    n = F.rows
    both = zeros(2 * n, 2 * n)
    both[:n, :n], both[:n, n:], both[n:, n:] = -F, S, F.T
    grown = (both * dt).exp()
    Phi = grown[n:, n:].T
    return Phi, Phi * grown[:n, n:]


# ---------------------------------------------------------------- total states


def read(model: Model, values: Values, x: Matrix, dt: Any = None) -> dict[str, Any]:
    """What a unit is called with."""
    moved = values if dt is None else values | {model.dt: dt}
    return fields(model, moved) | {"x": list(x)}


def state(model: Model, values: Values) -> Matrix:
    return Matrix([values[s] for s in model.x])


def answered(model: Model, next_of: Reference) -> list[Values]:
    """Points at which next has a value, as the C answers: over a step a state may leave its box, as a tank runs dry."""
    drawn = points(model, "Phi", TRIED * MANY)
    kept = [v for v in drawn if all(e.is_finite() for e in next_of(read(model, v, state(model, v)))[0].values())]
    return (kept or drawn)[:MANY]


def check_derivative(model: Model, reference: Mapping[str, Reference]) -> MechanicsCheck:
    """Phi against differences of next."""
    n, scale, names, verdict = model.n, box(model), [s.name for s in model.x], Verdict()
    with precise():
        for values in answered(model, reference["next"]):
            x = state(model, values)

            def after(error: Sequence[Any], values: Values = values, x: Matrix = x) -> Matrix:
                return filled((n, 1), reference["next"](read(model, values, x + Matrix(list(error))))[0])

            Phi, found = filled((n, n), reference["Phi"](read(model, values, x))[0]), slope(after, scale)
            verdict.compare(scaled(Phi, scale), found, names, names, scale, row_sizes(found, scale))
    return verdict.check(model, "Phi", "differences of next")


def check_flow(model: Model, reference: Mapping[str, Reference]) -> list[MechanicsCheck]:
    """next against the flow of f, and Q against the integral of Lyapunov's equation along it."""
    n, scale, names, step, noise = model.n, box(model), [s.name for s in model.x], Verdict(), Verdict()
    f, driven = compiled(model.f), compiled(model.G, model.noise)

    def parted(both: Matrix) -> tuple[Matrix, Matrix]:
        """The state, and the covariance that stands below it row by row."""
        entries = list(both)
        return Matrix(entries[:n]), Matrix([entries[n * i : n * (i + 1)] for i in range(1, n + 1)])

    with precise():
        for values in points(model, "next"):
            x = state(model, values)
            start = Matrix([*x, *zeros(n * n, 1)])

            def rate(both: Matrix, values: Values = values) -> Matrix:
                state, P = parted(both)
                here = values | dict(zip(model.x, state, strict=True))
                (G, roots), F = driven(here), filled((n, n), reference["F"](read(model, values, state))[0])
                GW = scaled(G, list(roots))
                return Matrix([*f(here)[0], *(F * P + (F * P).T + GW * GW.T)])

            def left(dt: Any, values: Values = values, x: Matrix = x, rate: Any = rate, start: Any = start) -> Any:
                """What next and Q have too much."""
                state, P = parted(flow(rate, start, dt))
                now = read(model, values, x, dt)
                return filled((n, 1), reference["next"](now)[0]) - state, filled((n, n), reference["Q"](now)[0]) - P

            speed, spread = parted(rate(start))
            (x_whole, Q_whole), (x_half, Q_half) = left(FLIGHT), left(FLIGHT / 2)
            moved = [max(size(v), LEAST * float(b)) for v, b in zip(speed, scale, strict=True)]
            falls(step, (x_whole, x_half), [float(FLIGHT) * v for v in moved], FLOWN, names)
            falls(noise, (Q_whole, Q_half), [float(FLIGHT) * v for v in row_sizes(spread, scale)], ADDED, names, names)
            if step.entry:
                off = left(SEEN)[0]
                i = max(range(n), key=lambda i: abs(float(off[i])) / moved[i])
                step.entry = f"{names[i]} is {float(off[i]):.3g} too large over {float(SEEN):.3g} s; {step.entry}"
                break
            off_box = largest(v / b / FLIGHT**FLOWN for v, b in zip(x_whole, scale, strict=True))
            step.coefficient = max(step.coefficient or 0.0, off_box)
    return [
        step.check(model, "next", "the flow of f"),
        noise.check(model, "Q", "the integrated Lyapunov equation"),
    ]


def flow(rate: Callable[[Matrix], Matrix], start: Matrix, dt: Any) -> Matrix:
    """The state after dt by the three stages of Gauss and Legendre, which err with dt^7; found by iteration."""
    root = arb(15).sqrt()
    stages = (
        (arb(5) / 36, arb(2) / 9 - root / 15, arb(5) / 36 - root / 30),
        (arb(5) / 36 + root / 24, arb(2) / 9, arb(5) / 36 - root / 24),
        (arb(5) / 36 + root / 30, arb(2) / 9 + root / 15, arb(5) / 36),
    )

    def after(weights: Sequence[Any]) -> Matrix:
        return start + dt * (weights[0] * rates[0] + weights[1] * rates[1] + weights[2] * rates[2])

    rates = [rate(start)] * 3
    for _ in range(ITERATIONS):
        rates = [rate(after(weights)) for weights in stages]
    return after((arb(5) / 18, arb(4) / 9, arb(5) / 18))


# ---------------------------------------------------------------- strapdown


Series = list[Matrix]  # the coefficients of a power series


def product(of: Callable[[Matrix, Matrix], Matrix], left: Series, right: Series, k: int) -> Matrix:
    """Coefficient k of the product of two series."""
    terms = [of(left[i], right[k - i]) for i in range(k + 1) if i < len(left) and k - i < len(right)]
    return sum(terms[1:], terms[0])


def integrated(series: Series) -> Series:
    return [0 * series[0], *(part / (k + 1) for k, part in enumerate(series))]


def at(series: Series, s: Any) -> Matrix:
    total = series[-1]
    for part in reversed(series[:-1]):
        total = total * s + part
    return total


def uneven(q: Matrix, omega: Series, force: Series) -> tuple[Series, Series]:
    """Attitude of a body that turns by omega, and the velocity that the force gives it; all resolved in its own axes
    but for what is returned, which starts from q and from rest."""
    turning = [q]
    for k in range(TERMS):
        turning.append(product(hamilton, turning, [vector(0, *rate) for rate in omega], k) / (2 * (k + 1)))
    back = [vector(p[0], -p[1], -p[2], -p[3]) for p in turning]
    turned = [product(hamilton, turning, [vector(0, *f) for f in force], k) for k in range(TERMS)]
    acceleration = [product(hamilton, turned, back, k)[1:4, 0] for k in range(TERMS)]
    return turning, integrated(acceleration)


def check_motion(model: Model, f: Function, level: ellipsoid.Level) -> MechanicsCheck:
    """One step of uneven motion, over an instant too short for the Earth to be felt.

    What reads the interval before is right to the third power of the step: coning, sculling, scrolling.  What does not
    read it is right to the second.
    """
    inputs, carried = {v.name: v for v in model.inputs}, NAVIGATION[model.frame[:3]]
    outputs = [next(o for o in f.outputs if o.name == name) for name in carried]
    run = compiled(*(o.value for o in outputs))
    before = {s for v in INCREMENTS[2:] for s in v.symbols}
    verdict, rng = Verdict(), generator("uneven")
    rest: Values = {s: zero for v in model.inputs for s, zero in zip(v.symbols, nearest_zero(v), strict=True)}
    for values in points(model, "strapdown"):
        p, v, q = (Matrix([values[s] for s in inputs[name].symbols]) for name in carried)
        rate, force = ([Matrix([arb(float(c)) for c in rng.uniform(-1, 1, 3)]) for _ in range(3)] for _ in range(2))
        parts: list[list[Matrix]] = []
        with precise():
            turning, velocity = uneven(q, rate, force)
            distance, sums = integrated(velocity), [integrated(series) for series in (rate, force)]
            for s in (TURNED, TURNED / 2):
                now: Values = rest | {inputs["dt"].scalar: STEP}
                increments = [at(series, s) for series in sums] + [-at(series, -s) for series in sums]
                columns = zip((*(inputs[name] for name in carried), *INCREMENTS), (p, v, q, *increments), strict=True)
                for variable, column in columns:
                    now.update(zip(variable.symbols, column, strict=True))
                made = run(now)
                mean = position_rate(p, v + at(distance, s) / s, level)
                exact = (mean, v + at(velocity, s), at(turning, s))
                found = ((made[0] - p) / STEP, *made[1:])
                parts.append([mine - theirs for mine, theirs in zip(found, exact, strict=True)])
            sizes = [largest(exact[0] - position_rate(p, v, level)), largest(exact[1] - v), largest(exact[2] - q)]
            parts = [[s * part[0], *part[1:]] for s, part in zip((1, arb(1) / 2), parts, strict=True)]
        for output, whole, *two in zip(outputs, sizes, *parts, strict=True):
            rows = [s.name for s in inputs[output.name].symbols]
            power = 4 if symbols_in(output.value) & before else 3
            falls(verdict, two, [whole] * len(rows), power, rows, nothing=FELT)
    return verdict.check(model, f.name, "a body that turns and accelerates unevenly")


def position_rate(position: Matrix, v_n: Matrix, level: ellipsoid.Level) -> Matrix:
    """Of the coordinates, by the velocity over the ground."""
    with digits(ellipsoid.WORKING):
        return level.slope(position).solve(level.axes(position) * v_n)
