"""The printed units that carry the state of a model and its covariance over a step.

Each has a reference in balls that shares the SymPy expressions with it and nothing else: where CasADi differentiates a
whole step, the reference puts the step together from values and Jacobians of f, by the chain rule.
"""

from collections.abc import Callable, Iterator, Sequence
from math import factorial
from typing import Any

import casadi as ca
from flint import arb

from boresight.codegen.functions.maker import UnitMaker
from boresight.codegen.functions.reference import Entries, precise
from boresight.codegen.functions.unit import Unit, Values, described
from boresight.derive.model import SPREAD

Rows = list[dict[int, Any]]  # a matrix as its non-zeros, row by row: F of a filter has few
TRANSITION = ("mechanics (transition-1)", "mechanics (transition-2)")  # Phi and Q of the second order
LARGEST = 3e38  # a float holds it: what is not below it counts as not finite


def dynamics(maker: UnitMaker) -> list[Unit]:
    """F and what follows from it over dt, or the step of a total state with its derivative and its noise."""
    if maker.model.F is not None:
        return error_state(maker)
    return list(total_state(maker) if maker.model.f is not None else discrete(maker))


# ---------------------------------------------------------------- matrices of balls


def by_rows(entries: Entries, count: int) -> Rows:
    rows: Rows = [{} for _ in range(count)]
    for (i, j), value in entries.items():
        rows[i][j] = value
    return rows


def identity(n: int) -> Rows:
    return [{i: arb(1)} for i in range(n)]


def times(a: Rows, b: Rows) -> Rows:
    product: Rows = []
    for row in a:
        total: dict[int, Any] = {}
        for k, left in row.items():
            for j, right in b[k].items():
                total[j] = total[j] + left * right if j in total else left * right
        product.append(total)
    return product


def transposed(a: Rows, columns: int) -> Rows:
    turned: Rows = [{} for _ in range(columns)]
    for i, row in enumerate(a):
        for j, value in row.items():
            turned[j][i] = value
    return turned


def weighted(*terms: tuple[Any, Rows]) -> Entries:
    """The sum of weight times matrix."""
    total: Entries = {}
    for weight, rows in terms:
        for i, row in enumerate(rows):
            for j, value in row.items():
                total[i, j] = total[i, j] + weight * value if (i, j) in total else weight * value
    return total


def symmetric(matrix: Any) -> Any:
    """An SX matrix whose upper triangle is a copy of its lower one, to the bit."""
    return ca.tril2symm(ca.tril(matrix))


# ---------------------------------------------------------------- an error state


def error_state(maker: UnitMaker) -> list[Unit]:
    """F, Phi to the model's order of F dt, and Q to one more of dt."""
    model = maker.model
    n, order, source = model.n, model.order, model.equations
    (F,) = maker.convert(model.F)
    F_exact = maker.numeric(model.F)
    dt, dt_exact = maker.symbols[model.dt], step(maker)
    A = F * dt
    G, noise = maker.convert(model.G, model.noise)
    root_exact = root(maker)
    Phi = ca.SX.eye(n) + A
    if order > 1:
        Phi += A @ A / 2
    if order > 2:
        Phi += A @ A @ A / 6
    Q, S = ca.SX.zeros(n, n), G @ ca.diag(noise)
    for weight, factors in SPREAD[order]:
        column, columns, power = S, ca.SX.zeros(*S.shape), ca.SX(1)
        for factor in factors:
            if factor:
                columns += column * (factor.numerator * power / factor.denominator)
            column, power = F @ column, power * dt
        Q += weight.numerator * dt / weight.denominator * (columns @ columns.T)

    def powers(values: Values) -> list[tuple[Any, Rows]]:
        """1, F, F F / 2, ...: what stands with the powers of dt in Phi."""
        f, terms = by_rows(F_exact(values)[0], n), [identity(n)]
        for _ in range(order):
            terms.append(times(terms[-1], f))
        return [(arb(1) / factorial(i), term) for i, term in enumerate(terms)]

    def Phi_exact(values: Values) -> list[Entries]:
        with precise():
            h = dt_exact(values)
            return [weighted(*((u * h**i, term) for i, (u, term) in enumerate(powers(values))))]

    def Q_exact(values: Values) -> list[Entries]:
        """The same squares, of the powers of F and not, as in C, of columns that F is taken to one after another."""
        with precise():
            h, s, f = dt_exact(values), root_exact(values), by_rows(F_exact(values)[0], n)
            powers, terms = [identity(n)], []
            for _ in range(order):
                powers.append(times(powers[-1], f))
            for weight, factors in SPREAD[order]:
                scaled = ((arb(a.numerator) / a.denominator * h**k, powers[k]) for k, a in enumerate(factors))
                columns = times(by_rows(weighted(*scaled), n), s)
                square = times(columns, transposed(columns, model.noise.rows))
                terms.append((arb(weight.numerator) / weight.denominator * h, square))
            return [weighted(*terms)]

    return [
        maker.unit(
            "F",
            "system matrix, x' = F x + G w",
            [(F, described("F", "1/s and mixed", "system matrix"))],
            F_exact,
            source,
            (model.F,),
        ),
        maker.unit(
            "Phi",
            f"transition matrix over dt, {series(order)}, with F as it is at the start",
            [(Phi, described("Phi", "mixed", "transition matrix"))],
            Phi_exact,
            (*source, *TRANSITION[:1] * (order == 2)),
            (model.F,),
        ),
        noise_per_second(maker),
        maker.unit(
            "Q",
            f"covariance that the noise adds over dt, to dt^{order + 1}, as squares, with F as it is at the start",
            [(symmetric(Q), described("Q", "mixed", "covariance of the noise"))],
            Q_exact,
            (*source, *TRANSITION[1:] * (order == 2)),
            (model.F, model.G, model.noise),
        ),
    ]


def series(order: int) -> str:
    """Phi of an error state as text."""
    return " + ".join(["I", "F dt", "(F dt)^2 / 2", "(F dt)^3 / 6"][: order + 1])


def left_out(order: int) -> str:
    """What is left out of Phi begins with this, where F stands; and where it moves."""
    return f"(F dt)^{order + 1} / {factorial(order + 1)}, and dt^2 / 2 times the rate of F"


def spread(order: int) -> str:
    """Q of an error state as text, with S S' = Qc dt and A = F dt."""
    return (
        "B S S' B', B = I + A / 2",
        "S S' / 4 + 3/4 B S S' B', B = I + 2/3 A + 2/9 A^2",
        "B S S' B' + 1/3 C S S' C', B = I + A / 2 + A^2 / 6 + A^3 / 24, C = A / 2 + A^2 / 4",
    )[order - 1]


def left_of_Q(order: int) -> str:
    """What Q leaves out of the integral over a step in which F stands: the lowest power of dt, with W = Qc dt."""
    return (
        "(A^2 W + W A'^2) / 6 + A W A' / 12",
        "(A^3 W + W A'^3) / 24 + (A^2 W A' + A W A'^2) / 72",
        "(A^4 W + W A'^4) / 120 + (A^3 W A' + A W A'^3) / 80 + A^2 W A'^2 / 720",
    )[order - 1]


def step(maker: UnitMaker) -> Callable[[Values], Any]:
    """dt as a ball."""
    variable = next(v for v in maker.model.inputs if maker.model.dt in v.symbols)
    place = variable.symbols.index(maker.model.dt)
    return lambda values: arb(values.get(variable.name, maker.anywhere[variable.name])[place])


def root(maker: UnitMaker) -> Callable[[Values], Rows]:
    """G times the roots of the densities, of which times its transpose is the noise covariance per second."""
    model = maker.model
    exact = maker.numeric(model.G, model.noise)

    def evaluate(values: Values) -> Rows:
        g, densities = exact(values)
        rows = by_rows(g, model.n)
        return [{j: value * densities[j, 0] for j, value in row.items() if (j, 0) in densities} for row in rows]

    return evaluate


def density(maker: UnitMaker) -> tuple[Any, Callable[[Values], Rows]]:
    """The noise covariance per second, G W G'."""
    G, noise = maker.convert(maker.model.G, maker.model.noise)
    root_exact = root(maker)

    def exact(values: Values) -> Rows:
        rows = root_exact(values)
        return times(rows, transposed(rows, maker.model.noise.rows))

    return symmetric(G @ ca.diag(noise * noise) @ G.T), exact


def noise_per_second(maker: UnitMaker) -> Unit:
    spread, spread_exact = density(maker)

    def exact(values: Values) -> list[Entries]:
        with precise():
            return [weighted((1, spread_exact(values)))]

    return maker.unit(
        "Qc",
        "noise covariance per second, G W G'",
        [(spread, described("Qc", "mixed", "density of the noise"))],
        exact,
        maker.model.equations,
        (maker.model.G, maker.model.noise),
    )


# ---------------------------------------------------------------- a total state


def total_state(maker: UnitMaker) -> Iterator[Unit]:
    """F, and over a step with the inputs held: next by Runge and Kutta, Phi its derivative, Q by Radau."""
    model, x, h = maker.model, maker.vectors["x"], maker.symbols[maker.model.dt]
    n, source = model.n, model.equations
    f, G, noise = maker.convert(model.f, model.G, model.noise)
    F = ca.jacobian(f, x)
    read = list(maker.vectors.values())
    at = ca.Function("at", read, [f, F, G @ ca.diag(noise)])

    def given(state: Any) -> Any:
        return at(state, *read[1:])

    k1, *_ = given(x)
    k2, *_ = given(x + h / 2 * k1)
    k3, *_ = given(x + h / 2 * k2)
    k4, *_ = given(x + h * k3)
    after = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)

    # Of Radau's two nodes one is the end, the other lies at dt / 3: a midpoint step leads there, and one on to the end.
    half, *_ = given(x + h / 6 * k1)
    node = x + h / 3 * half
    onward, slope, root_node = given(node)
    _, middle, _ = given(node + h / 3 * onward)
    B = ca.SX.eye(n) + 2 * h / 3 * middle @ (ca.SX.eye(n) + h / 3 * slope)
    from_node, from_end = B @ root_node, given(after)[2]
    Q = h / 4 * (from_end @ from_end.T) + 3 * h / 4 * (from_node @ from_node.T)

    f_exact, F_exact = maker.numeric(model.f), maker.numeric(model.f, jacobian=True)
    root_exact, dt_exact = root(maker), step(maker)

    def rate(values: Values, state: Sequence[Any]) -> list[Any]:
        entries = f_exact({**values, "x": state})[0]
        return [entries.get((i, 0), arb(0)) for i in range(n)]

    def slopes(values: Values, state: Sequence[Any]) -> Rows:
        return by_rows(F_exact({**values, "x": state})[0], n)

    def displaced(state: Sequence[Any], weight: Any, by: Sequence[Any]) -> list[Any]:
        return [arb(a) + weight * b for a, b in zip(state, by, strict=True)]

    def stages(values: Values) -> tuple[list[list[Any]], list[list[Any]]]:
        """Where f is taken in a step of Runge and Kutta, and what it is there."""
        h, x = dt_exact(values), start(values)
        states, rates = [x], [rate(values, x)]
        for share in (h / 2, h / 2, h):
            states.append(displaced(x, share, rates[-1]))
            rates.append(rate(values, states[-1]))
        return states, rates

    def start(values: Values) -> list[Any]:
        return [arb(v) for v in values.get("x", maker.anywhere["x"])]

    def end(values: Values) -> list[Any]:
        h, (states, rates) = dt_exact(values), stages(values)
        total = [a + 2 * b + 2 * c + d for a, b, c, d in zip(*rates, strict=True)]
        return displaced(states[0], h / 6, total)

    def next_exact(values: Values) -> list[Entries]:
        with precise():
            return [{(i, 0): value for i, value in enumerate(end(values))}]

    def Phi_exact(values: Values) -> list[Entries]:
        """d k_i / d x = F (1 + share d k_(i-1) / d x), stage after stage."""
        with precise():
            h, (states, _) = dt_exact(values), stages(values)
            grown = [slopes(values, states[0])]
            for share, state in zip((h / 2, h / 2, h), states[1:], strict=True):
                inner = by_rows(weighted((1, identity(n)), (share, grown[-1])), n)
                grown.append(times(slopes(values, state), inner))
            weights = (h / 6, h / 3, h / 3, h / 6)
            return [weighted((1, identity(n)), *zip(weights, grown, strict=True))]

    def Q_exact(values: Values) -> list[Entries]:
        with precise():
            h, x = dt_exact(values), start(values)
            node = displaced(x, h / 3, rate(values, displaced(x, h / 6, rate(values, x))))
            middle = slopes(values, displaced(node, h / 3, rate(values, node)))
            inner = by_rows(weighted((1, identity(n)), (h / 3, slopes(values, node))), n)
            B = by_rows(weighted((1, identity(n)), (2 * h / 3, times(middle, inner))), n)
            terms = []
            for weight, state, onward in ((3 * h / 4, node, B), (h / 4, end(values), identity(n))):
                rows = times(onward, root_exact({**values, "x": state}))
                terms.append((weight, times(rows, transposed(rows, model.noise.rows))))
            return [weighted(*terms)]

    yield maker.unit(
        "F",
        "system matrix, F = d f / d x, x' = f(x) + G w",
        [(F, described("F", "1/s and mixed", "system matrix"))],
        F_exact,
        source,
        (model.f,),
    )
    if model.loops:  # what the loops of the filter in C are over
        per_second = ", ".join(f"({block.unit}) per s" for block in model.states)
        yield maker.unit(
            "f",
            "rate of the state, x' = f(x) + G w",
            [(f, described("f", per_second, "rate of the state"))],
            f_exact,
            source,
            (model.f,),
        )
        yield noise_per_second(maker)
    yield from carried(
        maker,
        (model.f,),
        (model.f, model.G, model.noise),
        (after, next_exact, "one step of the fourth-order Runge-Kutta method, inputs held"),
        (ca.jacobian(after, x), Phi_exact),
        (Q, Q_exact, "covariance that the noise adds over dt, by the two nodes of Radau, at dt / 3 and at dt"),
    )


def discrete(maker: UnitMaker) -> Iterator[Unit]:
    """next or Phi and Q as the model gives them, and the other of the two."""
    model = maker.model
    if model.Phi is not None:
        Phi, Q = maker.convert(model.Phi, model.Q)
        Phi_exact, x = maker.numeric(model.Phi), maker.vectors["x"]

        def next_exact(values: Values) -> list[Entries]:
            with precise():
                state = [{0: arb(v)} for v in values.get("x", maker.anywhere["x"])]
                return [weighted((1, times(by_rows(Phi_exact(values)[0], model.n), state)))]

        return carried(
            maker,
            (model.Phi,),
            (model.Q,),
            (Phi @ x, next_exact, "Phi x"),
            (Phi, Phi_exact),
            (Q, maker.numeric(model.Q), "covariance that the noise adds over one step, as the model gives it"),
        )
    after, Q = maker.convert(model.next, model.Q)
    return carried(
        maker,
        (model.next,),
        (model.Q,),
        (after, maker.numeric(model.next), "as the model gives it"),
        (ca.jacobian(after, maker.vectors["x"]), maker.numeric(model.next, jacobian=True)),
        (Q, maker.numeric(model.Q), "covariance that the noise adds over one step, as the model gives it"),
    )


def carried(
    maker: UnitMaker,
    of_step: tuple[Any, ...],
    of_noise: tuple[Any, ...],
    after: tuple[Any, Any, str],
    Phi: tuple[Any, Any],
    Q: tuple[Any, Any, str],
) -> Iterator[Unit]:
    """next, Phi and Q, each from its SX matrix, its reference and how it is made.

    of_step, of_noise: the matrices of the model that next and Phi are made of, and Q.

    The state must end in its box; an angle that wraps may end anywhere, and is wrapped by the filter.  Where f is taken
    within the step the state may have left its box, so that any of them may be no number: then there is no answer.
    """
    model = maker.model
    anywhere = model.kind == "error-state"
    sides = [
        (-LARGEST, LARGEST) if block.wraps or anywhere else side
        for block in model.states
        for side in zip(block.low, block.high, strict=True)
    ]
    low, high = zip(*sides, strict=True)
    units = ", ".join(block.unit for block in model.states)
    for name, matrix, exact, meaning, result in (
        ("next", ca.densify(after[0]), after[1], f"state one step later: {after[2]}", ("next", units, "state")),
        ("Phi", Phi[0], Phi[1], "transition matrix over one step, d next / d x", ("Phi", "mixed", "transition matrix")),
        ("Q", symmetric(Q[0]), Q[1], Q[2], ("Q", "mixed", "covariance of the noise")),
    ):
        size = matrix.numel()
        box = {"low": low, "high": high} if name == "next" else {"low": (-LARGEST,) * size, "high": (LARGEST,) * size}
        of = of_noise if name == "Q" else of_step
        yield maker.unit(name, meaning, [(matrix, described(*result, **box))], exact, model.equations, of)
