"""The printed units of a model: for each, CasADi's function and a reference in 50 digits that shares nothing with it
but the SymPy expressions themselves."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import casadi as ca
import mpmath as mp
import sympy as sp

from boresight.codegen.functions.convert import to_casadi
from boresight.codegen.functions.reference import evaluator
from boresight.codegen.functions.tape import Tape, share_reciprocals, tape
from boresight.derive.model import Measurement, Model, Variable, symbols_in

Values = dict[str, list[Any]]  # field name -> components as mpf
DIGITS = 50


@dataclass(frozen=True)
class Result:
    """One output of a unit: a matrix, of which the kernel writes the non-zeros (row, column)."""

    name: str
    shape: tuple[int, int]
    nonzeros: tuple[tuple[int, int], ...]
    unit: str
    meaning: str
    angle: bool = False
    low: tuple[float, ...] = ()
    high: tuple[float, ...] = ()


@dataclass(frozen=True)
class Unit:
    name: str
    meaning: str
    args: tuple[Variable, ...]  # what it reads, in the model's order; the error state, if read, is `x` and comes first
    results: tuple[Result, ...]
    equations: tuple[str, ...]
    function: Any  # casadi.Function: the single source of both prints
    reference: Callable[[Values], list[Any]]  # -> one mp.matrix a result, to DIGITS digits

    @cached_property
    def tape(self) -> Tape:
        return tape(self.function)


def described(name: str, unit: str, meaning: str, **rest: Any) -> Result:
    """A result before its shape is known."""
    return Result(name, (0, 0), (), unit, meaning, **rest)


Rows = list[dict[int, Any]]  # a matrix as its non-zeros, row by row: F of a filter has few


def sparse(matrix: Any) -> Rows:
    return [{j: value for j, value in enumerate(row) if value} for row in matrix.tolist()]


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
    return [{i: row[j] for i, row in enumerate(a) if j in row} for j in range(columns)]


def weighted(n: int, *terms: tuple[Any, Rows]) -> Any:
    """The sum of weight times matrix as an mp.matrix, n x n."""
    total = mp.zeros(n)
    for weight, rows in terms:
        for i, row in enumerate(rows):
            for j, value in row.items():
                total[i, j] += weight * value
    return total


def state_variable(model: Model) -> Variable:
    """The whole error state as one input, named x."""
    parts = model.states
    low = tuple(value for part in parts for value in part.low)
    high = tuple(value for part in parts for value in part.high)
    return Variable("x", tuple(model.x), ", ".join(part.unit for part in parts), "error state", low, high)


def units(model: Model) -> list[Unit]:
    """Every printed unit of the model, in a fixed order."""
    return UnitMaker(model).units()


class UnitMaker:
    """Holds what the units of one model share: CasADi's symbols and the converted F."""

    def __init__(self, model: Model):
        self.model = model
        self.variables = (state_variable(model), *model.inputs)
        self.vectors = {v.name: ca.SX.sym(v.name, v.size) for v in self.variables}
        self.symbols = {s: self.vectors[v.name][i] for v in self.variables for i, s in enumerate(v.symbols)}

    def convert(self, *matrices: sp.Matrix) -> list[Any]:
        return to_casadi(list(matrices), self.symbols)

    def numeric(self, *matrices: sp.Matrix) -> Callable[[Values], list[Any]]:
        """The matrices as functions of 50-digit numbers, straight from SymPy."""
        symbols = [s for v in self.variables for s in v.symbols]
        used = symbols_in(*matrices)
        order = [s for s in symbols if s in used]
        where = {s: (v.name, i) for v in self.variables for i, s in enumerate(v.symbols)}
        # A derivative may not depend on what its function reads; any value in the box will then do.
        anywhere = {
            v.name: [mp.mpf(lo / 4 + hi * 3 / 4) for lo, hi in zip(v.low, v.high, strict=True)] for v in self.variables
        }
        compiled: list[Any] = []  # made on first use: a unit that did not change never needs it

        def evaluate(values: Values) -> list[Any]:
            if not compiled:
                compiled.append(evaluator(order, matrices))
            given = [values.get(name, anywhere[name])[i] for name, i in (where[s] for s in order)]
            return list(compiled[0](given, max(mp.mp.dps, DIGITS)))

        return evaluate

    def unit(
        self,
        name: str,
        meaning: str,
        results: list[tuple[Any, Result]],
        reference: Callable[[Values], list[Any]],
        equations: tuple[str, ...],
    ) -> Unit:
        """results: each SX matrix with its description, whose shape and non-zeros are filled in here."""
        outputs = [ca.sparsify(value) for value, _ in results]
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
            {"cse": True},
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
            F_exact = self.differentiate(model.f)
        G, noise = self.convert(model.G, model.noise)
        G_exact, dt = self.numeric(model.G, model.noise), self.symbols[model.dt]
        where = next(v.name for v in model.inputs if model.dt in v.symbols)
        n, source = model.n, model.equations
        A = F * dt
        spread = G @ ca.diag(noise * noise) @ G.T  # what the noise adds a second
        FS = F @ spread
        FFS = F @ FS
        Q = spread * dt + (FS + FS.T) * (dt * dt / 2) + (FFS + FFS.T + 2 * FS @ F.T) * (dt * dt * dt / 6)

        identity = sparse(mp.eye(n))

        def density(values: Values) -> list[Any]:
            with mp.workdps(DIGITS):
                g, root = G_exact(values)
                return [g * mp.diag([w * w for w in root]) * g.T]

        def Phi_exact(values: Values) -> list[Any]:
            with mp.workdps(DIGITS):
                f, h = sparse(F_exact(values)[0]), values[where][0]
                return [weighted(n, (1, identity), (h, f), (h * h / 2, times(f, f)))]

        def Q_exact(values: Values) -> list[Any]:
            """The integral of Phi(s) S Phi(s)' over the step, Phi to second order, cut after the third power of dt."""
            with mp.workdps(DIGITS):
                g, root = G_exact(values)
                f, h, g = sparse(F_exact(values)[0]), values[where][0], sparse(g)
                noisy = [{j: value * root[j] ** 2 for j, value in row.items()} for row in g]
                s = times(noisy, transposed(g, len(root)))
                # Phi(s) = 1 + F s + F F s^2 / 2: each pair of its terms around S, with the power of its integral.
                powers = [(1, identity), (1, f), (mp.mpf(1) / 2, times(f, f))]
                left = [(weight, times(power, s)) for weight, power in powers]
                return [
                    weighted(
                        n,
                        *(
                            (u * v * h ** (i + j + 1) / (i + j + 1), times(a, transposed(b, n)))
                            for i, (u, a) in enumerate(left)
                            for j, (v, b) in enumerate(powers[: 3 - i])
                        ),
                    )
                ]

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
                [(Q, described("Q", "mixed", "covariance of the noise"))],
                Q_exact,
                source,
            ),
        ]

    def differentiate(self, matrix: sp.Matrix) -> Callable[[Values], list[Any]]:
        """The Jacobian of a column by the error state, by central differences in 110 digits: 60 survive, and what is
        smaller than that is zero."""
        state, function = self.variables[0], self.numeric(matrix)
        used = symbols_in(matrix)
        seen = [i for i, symbol in enumerate(state.symbols) if symbol in used]
        anywhere = [mp.mpf(lo / 4 + hi * 3 / 4) for lo, hi in zip(state.low, state.high, strict=True)]

        def jacobian(values: Values) -> list[Any]:
            with mp.workdps(110):
                step, least = mp.mpf(10) ** -35, mp.mpf(10) ** -60
                result = mp.zeros(matrix.rows, self.model.n)
                for i in seen:
                    sides = []
                    for sign in (1, -1):
                        x = list(values.get("x", anywhere))
                        x[i] = x[i] + sign * step
                        sides.append(function({**values, "x": x})[0])
                    slope = (sides[0] - sides[1]) / (2 * step)
                    for row in range(matrix.rows):
                        result[row, i] = slope[row] if abs(slope[row]) > least else 0
                return [result]

        return jacobian

    def measurement(self, m: Measurement) -> list[Unit]:
        made = []
        rows = ", ".join(m.rows)

        def wrapped(matrix: sp.Matrix) -> sp.Matrix:
            return matrix.applyfunc(lambda a: sp.atan2(sp.sin(a), sp.cos(a))) if m.angle else matrix

        for label, matrix, meaning in (
            ("z", m.z, "z = H x + noise" if m.H is not None else "z = h(x) + noise"),
            ("h", m.h, "h(x), the z of an error state x without noise"),
        ):
            if matrix is not None and not (label == "h" and m.H is not None):
                printed = wrapped(matrix)
                made.append(
                    self.unit(
                        f"{m.name}_{label}",
                        f"{m.meaning}; {meaning}; rows {rows}",
                        [(self.convert(printed)[0], described(label, m.unit, ", ".join(m.rows), angle=m.angle))],
                        self.numeric(printed),
                        m.equations,
                    )
                )
        if m.H is not None:
            value, reference = self.convert(m.H)[0], self.numeric(m.H)
        else:
            value = ca.jacobian(self.convert(m.h)[0], self.vectors["x"])
            reference = self.differentiate(m.h)
        meaning = f"{m.meaning}; measurement matrix H = d z / d x; rows {rows}"
        made.append(
            self.unit(
                f"{m.name}_H",
                meaning,
                [(value, described("H", f"{m.unit} per unit of x", f"rows {rows}"))],
                reference,
                m.equations,
            )
        )
        return made
