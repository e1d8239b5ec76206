"""What makes the units of one model: its SymPy expressions in CasADi's symbols, and in 50 digits."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import casadi as ca
import numpy as np
import sympy as sp

from boresight.codegen.functions.convert import to_casadi
from boresight.codegen.functions.identities import identified
from boresight.codegen.functions.reference import Entries, evaluator
from boresight.codegen.functions.samples import generator, sample
from boresight.codegen.functions.tape import share_reciprocals
from boresight.codegen.functions.unit import Result, Unit, Values, state_variable
from boresight.derive.expressions import names_in, numeric, symbols_in
from boresight.derive.model import Model, Variable
from boresight.derive.named import Named, distinct

TRIED = 128  # points, and as many small ones, at which the roundings of equal values are compared


def one_zero(matrix: Any) -> Any:
    """A zero matrix whose first entry is written: C has no empty array.  As F of a random walk."""
    written = ca.SX(*matrix.shape)
    written[0, 0] = ca.SX(0.0)
    return written


class UnitMaker:
    """Holds what the units of one model share: CasADi's symbols and the converted F."""

    def __init__(self, model: Model):
        self.model = model
        self.variables = (state_variable(model), *model.inputs)
        self.vectors = {v.name: ca.SX.sym(v.name, v.size) for v in self.variables}
        self.symbols = {s: self.vectors[v.name][i] for v in self.variables for i, s in enumerate(v.symbols)}
        # A derivative may not depend on what its function reads; any value in the box will then do.
        self.entries: dict[Named, Any] = {}  # as it was converted last
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
        return to_casadi(list(matrices), self.symbols, self.entries)

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

    def named(self, of: Sequence[sp.Matrix], args: Sequence[Variable]) -> dict[str, Any]:
        """The named entries that the matrices read and that read nothing else than args, by name.

        Of several quantities of one name the second gets a 2 behind the names of its entries.
        """
        read = {s for v in args for s in v.symbols}
        numbers = [numeric(matrix, names=True) for matrix in of]
        listed = [entry for entry in names_in(*numbers) if symbols_in([entry]) <= read]
        return {name: self.entries[entry] for entry, name in distinct(listed).items()}

    def with_names(self, of: Sequence[sp.Matrix], args: Sequence[Variable]) -> tuple[Any, tuple[str, ...]]:
        """A function of args that gives all named values, and their names."""
        found = self.named(of, args)
        inputs = [self.vectors[v.name] for v in args]
        return ca.Function("named", inputs, [ca.vertcat(*found.values())]) if found else None, tuple(found)

    def unit(
        self,
        name: str,
        meaning: str,
        results: list[tuple[Any, Result]],
        reference: Callable[[Values], list[Entries]],
        equations: tuple[str, ...],
        of: tuple[sp.Matrix, ...],
    ) -> Unit:
        """results: each SX matrix with its description, whose shape and non-zeros are filled in here.

        of: the matrices of the model that it is made of, whose names it gets.
        """
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
            *self.with_names(of, args),
        )
