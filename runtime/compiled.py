"""The filter of `boresight.runtime.filter` with its algebra in the generated C, `src/PREFIX_filter.c`.

The same methods with the same meaning, for one run or many; each is one call of C, in which the runs follow
one another.  The results are those of the Python loop, to rounding.
"""

import ctypes
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.arguments import check_inputs, check_taking
from boresight.runtime.array import Array
from boresight.runtime.filter import Filter, Innovation
from boresight.runtime.library import Library
from boresight.runtime.status import Status


class CompiledFilter(Filter):
    """Predict, update by a named measurement, feed back.  model: a library of `boresight.runtime.library.load`.

    nav, P and x are as in `Filter`, and may be assigned between calls.
    """

    def __init__(self, model: Library, nav: dict[str, Array], P: Array, x: Any = None):
        described = model.manifest.get("filter") if isinstance(model, Library) else None
        if described is None:
            raise BoresightError(
                f"{getattr(model, 'name', model)!s} has no filter in C; give a library of a model that has measurements"
            )
        if model.precision != "double":
            raise BoresightError(f"{model.name} is compiled in {model.precision}; CompiledFilter carries P in double")
        super().__init__(model, nav, P, x)
        self.described = described
        n = len(model.states)
        size = getattr(model.dll, f"{model.manifest['c_prefix']}_filter_size")
        size.restype = ctypes.c_size_t
        self._width = int(size())
        self._memory, self._considering = np.zeros((0, self._width)), False
        self._carried: dict[str, slice] = {}
        start = 0
        for struct in described["carried"]:
            for name, part in model.layout[struct].items():
                self._carried[name] = slice(start + part.start, start + part.stop)
            start += model.width[struct]
        self._x, self._P = slice(start, start + n), slice(start + n, start + n + n * (n + 1) // 2)
        columns, rows = np.tril_indices(n)  # column after column of the upper triangle
        self._upper = rows, columns
        self._place = np.zeros((n, n), dtype=int)
        self._place[rows, columns] = self._place[columns, rows] = np.arange(len(rows))

    def predict(self, **inputs: Any) -> None:
        """Carry x and P over `dt`."""
        self._fly("propagate", self.described["propagate"], inputs)

    def update(
        self,
        measurement: str,
        R: Any,
        *,
        rows: Any = True,
        gate: float | None = None,
        joint: float | None = None,
        iterations: int = 1,
        considered: Any = None,
        **inputs: Any,
    ) -> Innovation:
        """Take one measurement, row after row: see `Filter.update`.  R is (..., m, m) of a correlated one alone."""
        check_taking(measurement, rows, gate, joint, iterations)
        kept = self._considered(measurement, considered)
        z = self._brought(measurement, inputs)
        described = self.described["measurements"][measurement]
        m = described["m"]
        R, rows = np.atleast_1d(np.asarray(R, dtype=float)), np.atleast_1d(np.asarray(rows, dtype=bool))
        _, L_inverse = self._noise(measurement, R, (m,) if z is None else z.shape, rows)
        if L_inverse is not None:
            if not self._described(measurement, "correlated"):
                raise BoresightError(
                    f"{measurement}: R has shape {R.shape}, and its C takes the variances of independent rows; give "
                    "these, generate the Measurement with correlated=True, or fly Filter"
                )
            R = R.reshape((*R.shape[:-2], m * m))
        vectors = {"R": R} if z is None else {"z": z, "R": R}
        gates = np.array([gate or 0.0, joint or 0.0])
        nu, S, nis, used = self._fly(
            f"measure_{measurement}", described, inputs, vectors, (rows, m, gates, iterations, kept)
        )
        return Innovation(nu, S, used, nis)

    def feedback(self) -> None:
        """Correct nav by the estimate and begin again from zero."""
        if self.described["correct"] is None:
            raise BoresightError(f"{self.model.name} has no function 'feedback'")
        self._fly("correct", self.described["correct"], {})

    def _fly(
        self,
        function: str,
        described: dict[str, Any],
        inputs: dict[str, Any],
        vectors: dict[str, Array] | None = None,
        measured: tuple[Array, int, Array, int, Array | None] | None = None,
    ) -> Any:
        """Call `function` of the C filter for all runs.  vectors: z if brought (..., m), and R.

        measured: rows (..., m) bool, m, the gates of a row and the joint one, iterations and the considered states
        (..., n) bool, or None, of a measurement, for which nu, S, nis and used are returned.
        """
        library: Library = self.model
        check_inputs(function, library, inputs, self.nav, self.P)
        values = {**self.nav, **inputs}
        missing = [name for name in described["fields"] if name not in values]
        if missing:
            raise BoresightError(f"{function} needs {', '.join(missing)}; pass it as a keyword")
        read = {name: values[name] for name in {*described["fields"], *self._carried} if name in values}
        given, runs = library.arrange(function, read)
        shapes = [runs, self.x.shape[:-1], self.P.shape[:-2], *(v.shape[:-1] for v in (vectors or {}).values())]
        if measured is not None:
            shapes += [each.shape[:-1] for each in (measured[0], measured[4]) if each is not None]
        runs = np.broadcast_shapes(*shapes)
        n = int(np.prod(runs, dtype=int))

        if self._memory.shape[:-1] != runs:  # kept from call to call: most of it is scratch
            self._memory, self._considering = np.zeros((*runs, self._width)), False
        memory = self._memory
        for name, part in self._carried.items():
            memory[..., part] = given[name] if name in given else inside(library.field[name])
        memory[..., self._x] = self.x
        memory[..., self._P] = self.P[(..., *self._upper)]
        arguments: list[Any] = [ctypes.c_size_t(n), ctypes.c_void_p(memory.ctypes.data)]
        kept: list[Any] = []
        for packed, stride in library.pack(described["structs"], given, runs):
            kept.append(packed)
            arguments += [ctypes.c_void_p(packed.ctypes.data), ctypes.c_size_t(stride)]
        out: tuple[Array, ...] = ()
        if measured is not None:
            rows, m, gates, iterations, kept_states = measured
            self._consider(n, runs, kept_states)
            for vector in (vectors or {}).values():
                kept.append(np.ascontiguousarray(np.broadcast_to(vector, (*runs, vector.shape[-1]))))
                arguments += [ctypes.c_void_p(kept[-1].ctypes.data), ctypes.c_size_t(vector.shape[-1])]
            kept.append(np.ascontiguousarray(np.broadcast_to(rows, (*runs, m)), dtype=np.uint8))
            arguments.append(ctypes.c_void_p(kept[-1].ctypes.data))
            arguments += [ctypes.c_void_p(gates.ctypes.data), ctypes.byref(ctypes.c_int(iterations))]
            out = np.zeros((*runs, m)), np.zeros((*runs, m)), np.zeros(runs), np.zeros((*runs, m), dtype=np.uint8)
            arguments += [ctypes.c_void_p(part.ctypes.data) for part in out]
        status = np.empty(n, dtype=np.uint8)
        arguments.append(ctypes.c_void_p(status.ctypes.data))
        called = getattr(library.dll, f"{library.manifest['c_prefix']}_filter_{function}_batch")
        called.restype = ctypes.c_size_t
        if called(*arguments):
            self._explain(function, given, runs, status.reshape(runs))
        if function == "propagate":
            self.at_ceiling = (status == Status.AT_CEILING).reshape(runs)
        self.x = memory[..., self._x].copy()
        self.P = memory[..., self._P][..., self._place]
        if function == "correct":
            for name in described["written"]:
                value = memory[..., self._carried[name]]
                self.nav[name] = value.copy() if library.field[name]["size"] > 1 else value[..., 0]
        return (*out[:3], out[3].astype(bool)) if out else None

    def _consider(self, n: int, runs: tuple[int, ...], considered: Array | None) -> None:
        """Tell the C of n runs which states (..., n) bool no measurement corrects; it keeps that in its memory."""
        if considered is None and not self._considering:
            return
        states = self.P.shape[-1]
        each = np.broadcast_to(False if considered is None else considered, (*runs, states))
        told = np.ascontiguousarray(each, dtype=np.uint8)
        called = getattr(self.model.dll, f"{self.model.manifest['c_prefix']}_filter_consider_batch")
        called.restype = ctypes.c_size_t
        status = np.empty(n, dtype=np.uint8)
        memory = (ctypes.c_void_p(array.ctypes.data) for array in (self._memory, told))
        called(ctypes.c_size_t(n), *memory, ctypes.c_size_t(states), ctypes.c_void_p(status.ctypes.data))
        self._considering = considered is not None

    def _explain(self, function: str, given: dict[str, Array], runs: tuple[int, ...], status: Array) -> None:
        bad = (status != Status.OK) & (status != Status.AT_CEILING)
        where = tuple(int(i) for i in np.argwhere(bad)[0])
        held = [np.broadcast_to(self.P, (*runs, *self.P.shape[-2:]))[where]]
        held.append(np.broadcast_to(self.x, (*runs, self.x.shape[-1]))[where])
        if status[where] == Status.NOT_POSITIVE or not all(np.isfinite(part).all() for part in held):
            at = f" of run {where[0] if len(where) == 1 else where}" if where else ""
            raise BoresightError(
                f"{function}: an innovation or its variance{at} is no number, or a variance is negative; start again "
                "from a new P"
            )
        self.model.explain(function, {**given, "x": self.x}, runs, np.where(bad, status, Status.OK))


def inside(field: dict[str, Any]) -> Array:
    """A value of a field that the filter carries and nobody has given: it stands in no function that is called."""
    low, high = np.array(field["low"]), np.array(field["high"])
    value = np.where((low <= 0) & (high >= 0), 0.0, (low + high) / 2)
    if field["norm"]:
        value[0] = sum(field["norm"]) / 2
    return value
