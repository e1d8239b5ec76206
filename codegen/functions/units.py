"""The printed units of a model: for each, CasADi's function and a reference in 50 digits that shares nothing with it
but the SymPy expressions themselves."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np
import sympy as sp

from boresight import BoresightError
from boresight.codegen.functions.convert import to_casadi
from boresight.codegen.functions.identities import identified
from boresight.codegen.functions.reference import Entries, evaluator
from boresight.codegen.functions.samples import generator, sample
from boresight.codegen.functions.tape import BOUNDED, Tape, share_reciprocals, tape
from boresight.derive.checks import expressions, fail
from boresight.derive.expressions import symbols_in
from boresight.derive.model import Function, Measurement, Model, Variable

TRIED = 128  # points, and as many small ones, at which the roundings of equal values are compared
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


def one_zero(matrix: Any) -> Any:
    """A zero matrix whose first entry is written: C has no empty array.  As F of a random walk."""
    written = ca.SX(*matrix.shape)
    written[0, 0] = ca.SX(0.0)
    return written


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
    return made


def guarded(part: list[Unit]) -> list[Unit]:
    """The units of one part of a model, which answer with finite numbers only if one of them has what may give none."""
    bounded = any(step.op in BOUNDED for unit in part for step in unit.tape.steps)
    return [replace(unit, guarded=bounded) for unit in part]


class UnitMaker:
    """Holds what the units of one model share: CasADi's symbols and the converted F."""

    def __init__(self, model: Model):
        self.model = model
        self.variables = (state_variable(model), *model.inputs)
        self.vectors = {v.name: ca.SX.sym(v.name, v.size) for v in self.variables}
        self.symbols = {s: self.vectors[v.name][i] for v in self.variables for i, s in enumerate(v.symbols)}
        # A derivative may not depend on what its function reads; any value in the box will then do.
        self.anywhere = {
            v.name: [lo / 4 + hi * 3 / 4 for lo, hi in zip(v.low, v.high, strict=True)] for v in self.variables
        }

    def points(self, unit: str) -> list[np.ndarray]:
        """(2 TRIED, size) of each variable, at which the roundings of a unit are compared.

        Each input and each block of states is drawn by its own name and the unit's, so that what the unit does not
        read moves none of its points.
        """

        def drawn(v: Variable) -> np.ndarray:
            rng = generator("roundings", unit, v.name)
            return np.vstack([sample((v,), 0, TRIED, rng, small=small)[0] for small in (False, True)])

        return [
            np.hstack(list(map(drawn, self.model.states)) or [np.empty((2 * TRIED, 0))]),
            *map(drawn, self.model.inputs),
        ]

    def convert(self, *matrices: sp.Matrix) -> list[Any]:
        return to_casadi(list(matrices), self.symbols)

    def numeric(self, *matrices: sp.Matrix, jacobian: bool = False) -> Callable[[Values], list[Entries]]:
        """The matrices, or the Jacobians of columns by the state, in 50 digits, straight from SymPy."""
        symbols = [s for v in self.variables for s in v.symbols]
        used = symbols_in(*matrices)
        order = [s for s in symbols if s in used]
        where = {s: (v.name, i) for v in self.variables for i, s in enumerate(v.symbols)}
        by = self.variables[0].symbols if jacobian else ()
        compiled: list[Any] = []  # made on first use: a unit that did not change never needs it

        def evaluate(values: Values) -> list[Entries]:
            if not compiled:
                compiled.append(evaluator(order, matrices, by))
            return list(
                compiled[0]([values.get(name, self.anywhere[name])[i] for name, i in (where[s] for s in order)])
            )

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
        outputs = identified(list(self.vectors.values()), [value for value, _ in results], self.points(name))
        outputs = [out if out.nnz() else one_zero(out) for out in outputs]
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
                replace(
                    result,
                    shape=value.shape,
                    nonzeros=place,
                    low=tuple(result.low[r * value.size2() + c] for r, c in place) if result.low else (),
                    high=tuple(result.high[r * value.size2() + c] for r, c in place) if result.low else (),
                )
                for (value, result), place in zip(results, places, strict=True)
            ),
            equations,
            share_reciprocals(function),
            reference,
        )

    def units(self) -> list[Unit]:
        from boresight.codegen.functions.dynamics import dynamics  # which makes units itself

        model = self.model
        parts = [dynamics(self)] if model.n else []
        parts += [self.measurement(measurement) for measurement in model.measurements]
        parts += [[self.function(f)] for f in model.functions]
        return [unit for part in parts for unit in guarded(part)]

    def function(self, f: Function) -> Unit:
        values = self.convert(*(output.value for output in f.outputs))
        return self.unit(
            f.name,
            f.meaning,
            [
                (
                    v,
                    described(o.name, o.unit, o.meaning + (f", {o.frame}" if o.frame else ""), low=o.low, high=o.high),
                )
                for o, v in zip(f.outputs, values, strict=True)
            ],
            self.numeric(*(output.value for output in f.outputs)),
            f.equations,
        )

    def measurement(self, m: Measurement) -> list[Unit]:
        made = []
        rows = f"row{'s' if len(m.rows) > 1 else ''} {', '.join(m.rows)}"
        error = self.model.kind == "error-state"

        part = 0 < len(m.angles) < len(m.rows)
        names = [row + " (wrapped to [-pi, pi])" * (part and i in m.angles) for i, row in enumerate(m.rows)]

        def wrapped(matrix: sp.Matrix) -> sp.Matrix:
            return sp.Matrix([sp.atan2(sp.sin(a), sp.cos(a)) if i in m.angles else a for i, a in enumerate(matrix)])

        for label, matrix, meaning in (
            ("z", m.z, "z = H x + noise" if m.H is not None else "z = h(x) + noise"),
            ("h", m.h, f"h(x), the z of {'an error' if error else 'a'} state x without noise"),
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
