"""The printed units of a model: for each, CasADi's function and a reference in 50 digits that shares nothing with it
but the SymPy expressions themselves."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np
import sympy as sp
from flint import arb

from boresight import BoresightError
from boresight.codegen.functions.convert import to_casadi
from boresight.codegen.functions.identities import identified
from boresight.codegen.functions.reference import Entries, evaluator, precise
from boresight.codegen.functions.samples import generator, sample
from boresight.codegen.functions.tape import BOUNDED, Tape, share_reciprocals, tape
from boresight.derive.checks import expressions, fail
from boresight.derive.model import Measurement, Model, Variable, symbols_in

TRIED = 8  # points, and as many small ones, at which the roundings of equal values are compared
Values = Mapping[str, Sequence[Any]]  # field name -> components, floats or balls


@dataclass(frozen=True)
class Result:
    """One output of a unit: a matrix, of which the kernel writes the non-zeros (row, column)."""

    name: str
    shape: tuple[int, int]
    nonzeros: tuple[tuple[int, int], ...]
    unit: str
    meaning: str
    angle: tuple[int, ...] = ()  # the rows that are angles
    low: tuple[float, ...] = ()
    high: tuple[float, ...] = ()


@dataclass(frozen=True)
class Unit:
    name: str
    meaning: str
    args: tuple[Variable, ...]  # what it reads, in the model's order; the state, if read, is `x` and comes first
    results: tuple[Result, ...]
    equations: tuple[str, ...]
    function: Any  # casadi.Function: the single source of both prints
    reference: Callable[[Values], list[Entries]]  # the non-zeros of each result, as balls
    guarded: bool = False  # whether the C answers with finite numbers only

    @cached_property
    def tape(self) -> Tape:
        return tape(self.function)


def described(name: str, unit: str, meaning: str, **rest: Any) -> Result:
    """A result before its shape is known."""
    return Result(name, (0, 0), (), unit, meaning, **rest)


def symmetric(matrix: Any) -> Any:
    """An SX matrix whose upper triangle is a copy of its lower one, to the bit."""
    return ca.tril2symm(ca.tril(matrix))


Rows = list[dict[int, Any]]  # a matrix as its non-zeros, row by row: F of a filter has few


def by_rows(entries: Entries, count: int) -> Rows:
    rows: Rows = [{} for _ in range(count)]
    for (i, j), value in entries.items():
        rows[i][j] = value
    return rows


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


def state_variable(model: Model) -> Variable:
    """The whole state as one input, named x."""
    parts = model.states
    low = tuple(value for part in parts for value in part.low)
    high = tuple(value for part in parts for value in part.high)
    meaning = model.kind.replace("-", " ")
    return Variable("x", tuple(model.x), ", ".join(part.unit for part in parts), meaning, low, high)


def units(model: Model) -> list[Unit]:
    """Every printed unit of the model, in a fixed order.  Raises BoresightError on an entry that C cannot hold."""
    maker = UnitMaker(model)
    try:
        made = maker.units()
    except BoresightError:
        for item in expressions(model):
            for (i, j), entry in item.matrix.todok().items():
                try:
                    maker.convert(sp.Matrix([entry]))
                    maker.numeric(sp.Matrix([entry]))
                except BoresightError as error:
                    fail(item.part, f"{item.entry(i, j)}: {error}")
        raise
    guarded = any(step.op in BOUNDED for unit in made for step in unit.tape.steps)
    return [replace(unit, guarded=guarded) for unit in made]


class UnitMaker:
    """Holds what the units of one model share: CasADi's symbols and the converted F."""

    def __init__(self, model: Model):
        self.model = model
        self.variables = (state_variable(model), *model.inputs)
        self.vectors = {v.name: ca.SX.sym(v.name, v.size) for v in self.variables}
        self.symbols = {s: self.vectors[v.name][i] for v in self.variables for i, s in enumerate(v.symbols)}
        rng = generator("roundings", model.name)
        drawn = [sample(self.variables, 0, TRIED, rng, small=small) for small in (False, True)]
        self.points = [np.vstack(both) for both in zip(*drawn, strict=True)]

    def convert(self, *matrices: sp.Matrix) -> list[Any]:
        return to_casadi(list(matrices), self.symbols)

    def numeric(self, *matrices: sp.Matrix, jacobian: bool = False) -> Callable[[Values], list[Entries]]:
        """The matrices, or the Jacobians of columns by the state, in 50 digits, straight from SymPy."""
        symbols = [s for v in self.variables for s in v.symbols]
        used = symbols_in(*matrices)
        order = [s for s in symbols if s in used]
        where = {s: (v.name, i) for v in self.variables for i, s in enumerate(v.symbols)}
        # A derivative may not depend on what its function reads; any value in the box will then do.
        anywhere = {v.name: [lo / 4 + hi * 3 / 4 for lo, hi in zip(v.low, v.high, strict=True)] for v in self.variables}
        by = self.variables[0].symbols if jacobian else ()
        compiled: list[Any] = []  # made on first use: a unit that did not change never needs it

        def evaluate(values: Values) -> list[Entries]:
            if not compiled:
                compiled.append(evaluator(order, matrices, by))
            return list(compiled[0]([values.get(name, anywhere[name])[i] for name, i in (where[s] for s in order)]))

        return evaluate

    def unit(
        self,
        name: str,
        meaning: str,
        results: list[tuple[Any, Result]],
        reference: Callable[[Values], list[Entries]],
        equations: tuple[str, ...],
    ) -> Unit:
        """results: each SX matrix with its description, whose shape and non-zeros are filled in here."""
        outputs = identified(list(self.vectors.values()), [value for value, _ in results], self.points)
        read = {s.name() for s in ca.symvar(ca.vertcat(*(ca.vec(ca.densify(out)) for out in outputs)))}
        args = tuple(v for v in self.variables if read & {self.vectors[v.name][i].name() for i in range(v.size)})
        # Row-major: CasADi keeps the non-zeros column by column, C readers expect them row by row.
        rows, places = [], []
        for out in outputs:
            order = sorted(zip(out.sparsity().row(), out.sparsity().get_col(), range(out.nnz()), strict=True))
            places.append(tuple((r, c) for r, c, _ in order))
            rows.append(ca.vertcat(*(out.nz[k] for _, _, k in order)) if order else ca.SX(0, 1))
        function = ca.Function(
            f"{self.model.c_prefix}_{name}_casadi",
            [self.vectors[v.name] for v in args],
            rows,
            [v.name for v in args],
            [f"out_{result.name}" for _, result in results],
        )
        return Unit(
            name,
            meaning,
            args,
            tuple(
                replace(result, shape=(value.size1(), value.size2()), nonzeros=place)
                for (value, result), place in zip(results, places, strict=True)
            ),
            equations,
            share_reciprocals(function),
            reference,
        )

    def units(self) -> list[Unit]:
        model = self.model
        made = self.dynamics() if model.n else []
        for measurement in model.measurements:
            made += self.measurement(measurement)
        for f in model.functions:
            values = self.convert(*(output.value for output in f.outputs))
            made.append(
                self.unit(
                    f.name,
                    f.meaning,
                    [
                        (
                            v,
                            described(
                                o.name, o.unit, o.meaning + (f", {o.frame}" if o.frame else ""), low=o.low, high=o.high
                            ),
                        )
                        for o, v in zip(f.outputs, values, strict=True)
                    ],
                    self.numeric(*(output.value for output in f.outputs)),
                    f.equations,
                )
            )
        return made

    def dynamics(self) -> list[Unit]:
        model = self.model
        if model.F is not None:
            (F,) = self.convert(model.F)
            F_exact = self.numeric(model.F)
        else:
            (f,) = self.convert(model.f)
            F = ca.jacobian(f, self.vectors["x"])
            F_exact = self.numeric(model.f, jacobian=True)
        G, noise = self.convert(model.G, model.noise)
        G_exact, dt = self.numeric(model.G, model.noise), self.symbols[model.dt]
        where = next(v.name for v in model.inputs if model.dt in v.symbols)
        n, source = model.n, model.equations
        A = F * dt
        spread = symmetric(G @ ca.diag(noise * noise) @ G.T)  # noise covariance per second
        FS = F @ spread
        FFS = F @ FS
        Q = spread * dt + (FS + FS.T) * (dt * dt / 2) + (FFS + FFS.T + 2 * FS @ F.T) * (dt * dt * dt / 6)

        identity: Rows = [{i: arb(1)} for i in range(n)]

        def spread_exact(values: Values) -> Rows:
            g, root = G_exact(values)
            rows = by_rows(g, n)
            noisy = [{j: value * root[j, 0] ** 2 for j, value in row.items() if (j, 0) in root} for row in rows]
            return times(noisy, transposed(rows, model.noise.rows))

        def density(values: Values) -> list[Entries]:
            with precise():
                return [weighted((1, spread_exact(values)))]

        def Phi_exact(values: Values) -> list[Entries]:
            with precise():
                f, h = by_rows(F_exact(values)[0], n), arb(values[where][0])
                return [weighted((1, identity), (h, f), (h * h / 2, times(f, f)))]

        def Q_exact(values: Values) -> list[Entries]:
            """The integral of Phi(s) S Phi(s)' over the step, Phi to second order, cut after the third power of dt."""
            with precise():
                f, h, s = by_rows(F_exact(values)[0], n), arb(values[where][0]), spread_exact(values)
                # Phi(s) = 1 + F s + F F s^2 / 2: each pair of its terms around S, with the power of its integral;
                # the pair (j, i) is (i, j) transposed, as S is symmetric.
                powers: list[tuple[Any, Rows]] = [(arb(1), identity), (arb(1), f), (arb(1) / 2, times(f, f))]
                terms = []
                for i, j in ((0, 0), (0, 1), (0, 2), (1, 1)):
                    (u, left), (v, right) = powers[i], powers[j]
                    weight, term = u * v * h ** (i + j + 1) / (i + j + 1), times(times(left, s), transposed(right, n))
                    terms += [(weight, term)] if i == j else [(weight, term), (weight, transposed(term, n))]
                return [weighted(*terms)]

        return [
            self.unit(
                "F",
                "system matrix, x' = F x + G w",
                [(F, described("F", "1/s and mixed", "system matrix"))],
                F_exact,
                source,
            ),
            self.unit(
                "Phi",
                "transition matrix over dt, I + F dt + (F dt)^2 / 2",
                [(ca.SX.eye(n) + A + A @ A / 2, described("Phi", "mixed", "transition matrix"))],
                Phi_exact,
                source,
            ),
            self.unit(
                "Qc",
                "noise covariance per second, G W G'",
                [(spread, described("Qc", "mixed", "density of the noise"))],
                density,
                source,
            ),
            self.unit(
                "Q",
                "covariance that the noise adds over dt",
                [(symmetric(Q), described("Q", "mixed", "covariance of the noise"))],
                Q_exact,
                source,
            ),
        ]

    def measurement(self, m: Measurement) -> list[Unit]:
        made = []
        rows = f"row{'s' if len(m.rows) > 1 else ''} {', '.join(m.rows)}"

        part = 0 < len(m.angles) < len(m.rows)
        names = [row + " (wrapped to [-pi, pi])" * (part and i in m.angles) for i, row in enumerate(m.rows)]

        def wrapped(matrix: sp.Matrix) -> sp.Matrix:
            return sp.Matrix([sp.atan2(sp.sin(a), sp.cos(a)) if i in m.angles else a for i, a in enumerate(matrix)])

        for label, matrix, meaning in (
            ("z", m.z, "z = H x + noise" if m.H is not None else "z = h(x) + noise"),
            ("h", m.h, "h(x), the z of an error state x without noise"),
        ):
            if matrix is not None and not (label == "h" and m.H is not None):
                printed = wrapped(matrix)
                made.append(
                    self.unit(
                        f"{m.name}_{label}",
                        f"{m.meaning}; {meaning}; {rows}",
                        [(self.convert(printed)[0], described(label, m.unit, ", ".join(names), angle=m.angles))],
                        self.numeric(printed),
                        m.equations,
                    )
                )
        if m.H is not None:
            value, reference = self.convert(m.H)[0], self.numeric(m.H)
        else:
            value = ca.jacobian(self.convert(m.h)[0], self.vectors["x"])
            reference = self.numeric(m.h, jacobian=True)
        slope = "d z / d x" if m.H is not None else "d h / d x at x"
        meaning = f"{m.meaning}; measurement matrix H = {slope}; {rows}"
        made.append(
            self.unit(
                f"{m.name}_H",
                meaning,
                [(value, described("H", f"{m.unit} per unit of state", rows))],
                reference,
                m.equations,
            )
        )
        return made
