"""The filter of `boresight.runtime.filter` with its algebra in the generated C, `batch/PREFIX_lanes.c`.

The same methods with the same meaning, for one run or many; each is one call of C, in which blocks of runs follow one
another.  The state stays in the C between calls.  A run has the bits that the scalar functions of `src/PREFIX_filter.c`
give it, whatever stands beside it; they are those of the Python loop, to rounding.
"""

import ctypes
import functools
from collections.abc import Callable, Iterator, MutableMapping
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.arguments import check_inputs, check_nav, check_shape, check_state, check_taking
from boresight.runtime.array import Array
from boresight.runtime.filter.filter import Filter, Innovation, check_symmetric, of_unit_variances
from boresight.runtime.library import Given, Library
from boresight.runtime.status import Status

AT_CEILING = int(Status.AT_CEILING)  # compared with an array, the enum takes five times as long
ALIGNED = 64  # bytes: the widest block of numbers that C reads at once


class Taking(ctypes.Structure):
    """bs_taking of boresight_lanes.h."""

    _fields_ = [
        ("rows", ctypes.c_void_p), ("stride", ctypes.c_size_t), ("gates", ctypes.c_void_p),
        ("iterations", ctypes.c_void_p), ("nu", ctypes.c_void_p), ("S", ctypes.c_void_p), ("nis", ctypes.c_void_p),
        ("used", ctypes.c_void_p),
    ]  # fmt: skip


class Memory:
    """The state of n runs as the C has it: blocks of `width` runs, number after number, each of all runs of a block."""

    def __init__(self, n: int, numbers: int, width: int):
        self.n, self.width = n, width
        blocks = -(-n // width)
        room = np.zeros(blocks * numbers * width + ALIGNED // 8)
        start = -room.ctypes.data % ALIGNED // 8
        self.blocks = room[start : start + blocks * numbers * width].reshape(blocks, numbers, width)
        self.address = self.blocks.ctypes.data
        self._backup = np.empty_like(self.blocks)

    def read(self, part: slice) -> Array:
        """(n, size), a copy."""
        runs = self.blocks[:, part].transpose(0, 2, 1)
        return runs.reshape(-1, runs.shape[-1])[: self.n].copy()

    def write(self, part: slice, value: Array) -> None:
        """value: (n, size)."""
        if self.n % self.width:  # lanes beyond the last run are as that, so that nothing odd is computed there
            value = np.concatenate([value, np.repeat(value[-1:], -self.n % self.width, axis=0)])
        self.blocks[:, part] = value.reshape(len(self.blocks), self.width, -1).transpose(0, 2, 1)

    def keep(self, part: slice) -> None:
        """Remember what stands there for `give_back`."""
        np.copyto(self._backup[:, part], self.blocks[:, part])

    def give_back(self, part: slice) -> None:
        np.copyto(self.blocks[:, part], self._backup[:, part])


class Held(MutableMapping[str, Array]):
    """`nav` of a CompiledFilter: what is read comes out of the C, and is looked at again by the next call."""

    def __init__(self, loop: "CompiledFilter", names: list[str]):
        self._loop, self._names = loop, names

    def __getitem__(self, name: str) -> Array:
        if name not in self._names:
            raise KeyError(name)
        return self._loop._lend(name)

    def seen(self, name: str) -> Array:
        """A field to be read alone, which the next call need not look at."""
        if name not in self._names:
            raise KeyError(name)
        value = self._loop._seen(name).view()
        value.flags.writeable = False
        return value

    def __setitem__(self, name: str, value: Any) -> None:
        value = np.asarray(value, dtype=float)
        check_nav(self._loop.model, {name: value}, np.empty(0))
        if name not in self._names:
            self._names.append(name)
        self._loop._take(name, value)

    def __delitem__(self, name: str) -> None:
        self._loop._lend(name)
        self._names.remove(name)
        self._loop._forget([name])

    def __contains__(self, name: object) -> bool:
        return name in self._names

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __or__(self, other: Any) -> dict[str, Array]:
        return {**self, **other}

    def __ror__(self, other: Any) -> dict[str, Array]:
        return {**other, **self}

    def __repr__(self) -> str:
        return repr(dict(self))


class Prepared:
    """What one function is called with, for names and shapes that have been looked at: arrays that the C reads.

    runs: of the call.  own: carried fields that are given, for this call alone.
    """

    def __init__(self, loop: "CompiledFilter", function: str, described: dict[str, Any], inputs: dict[str, Any],
                 vectors: dict[str, Array], measured: list[Array]):  # fmt: skip
        library = loop._library
        check_inputs(function, library, inputs, loop.nav, np.empty((*loop._runs, 0, 0)))
        missing = [name for name in described["fields"] if name not in inputs and name not in loop.nav]
        if missing:
            raise BoresightError(f"{function} needs {', '.join(missing)}; pass it as a keyword")
        self.own = [name for name in loop._carried if name in inputs]
        self._read = [name for name in described["fields"] if name not in loop._carried]
        given, runs = library.arrange(function, {n: self.value(loop, n, inputs) for n in [*self._read, *self.own]})
        shapes = [runs, loop._broadcast(), *(v.shape[:-1] for v in [*vectors.values(), *measured])]
        self.runs = np.broadcast_shapes(*shapes)

        self._fields: list[tuple[str, Array]] = []
        blocks = []
        for struct, (packed, stride) in zip(
            described["structs"], library.pack(described["structs"], given, self.runs), strict=True
        ):
            blocks.append((packed, stride * packed.shape[-1]))
            for name, part in library.layout[struct].items():
                if name in given:
                    view = packed[..., part if library.field[name]["size"] > 1 else part.start]
                    self._fields.append((name, view))
        for name, vector in vectors.items():
            shared, m = vector.ndim == 1, vector.shape[-1]
            blocks.append((np.zeros(m if shared else (*self.runs, m)), 0 if shared else m))
            self._fields.append((name, blocks[-1][0]))
        self._blocks = blocks  # from the collector
        self.given = (Given * max(1, len(blocks)))(*(Given(each.ctypes.data, stride, 0) for each, stride in blocks))
        self.status = np.zeros(int(np.prod(self.runs, dtype=int)), dtype=np.uint8)
        self.bound: Any = None
        self.memory: Memory | None = None  # of the last call
        taking: tuple[Any, ...] = ()
        if measured:
            m = described["m"]
            self.rows, self.gates = np.zeros((*self.runs, m), dtype=np.uint8), np.zeros(2)
            self.iterations = np.zeros(1, dtype=np.intc)
            self.out = np.zeros((*self.runs, m)), np.zeros((*self.runs, m)), np.zeros(self.runs)
            self.used = np.zeros((*self.runs, m), dtype=np.uint8)
            ends = (part.ctypes.data for part in (self.gates, self.iterations, *self.out, self.used))
            taking = (ctypes.byref(Taking(self.rows.ctypes.data, m, *ends)),)
        self.asked = (ctypes.byref(self.given), *taking, ctypes.c_void_p.from_param(self.status.ctypes.data))

    @staticmethod
    def value(loop: "CompiledFilter", name: str, inputs: dict[str, Any]) -> Any:
        return inputs[name] if name in inputs else loop._seen(name)

    def fill(self, loop: "CompiledFilter", inputs: dict[str, Any]) -> None:
        for name, view in self._fields:
            view[...] = self.value(loop, name, inputs)

    def arranged(self, loop: "CompiledFilter", function: str, inputs: dict[str, Any]) -> dict[str, Array]:
        """What was given, as `Library.arrange` has it."""
        names = [*self._read, *self.own]
        return loop._library.arrange(function, {name: self.value(loop, name, inputs) for name in names})[0]


class CompiledFilter(Filter):
    """Predict, update by a named measurement, feed back.  model: a library of `boresight.runtime.library.load`.

    nav, P and x are as in `Filter`, and may be assigned, or changed in place, between calls.  They stay in the C: an
    array that was read holds what the filter held then, and only until the next call what it holds.  `variances` costs
    less than P.
    """

    def __init__(self, model: Library, nav: dict[str, Array], P: Array, x: Any = None):
        described = model.manifest.get("filter") if isinstance(model, Library) else None
        if described is None:
            raise BoresightError(
                f"{getattr(model, 'name', model)!s} has no filter in C; give a library of a model that has measurements"
            )
        if model.precision != "double":
            raise BoresightError(f"{model.name} is compiled in {model.precision}; CompiledFilter carries P in double")
        self.described, self._library = described, model
        self._held: dict[str, Array] = {}  # as the caller sees them; what is not there, or in _lent, is as in the C
        self._lent: set[str] = set()  # what the caller may have changed since the last call
        self._runs: tuple[int, ...] = ()
        self._memory: Memory | None = None
        self._prepared: dict[Any, Prepared] = {}  # by names and shapes
        self._places(model)
        super().__init__(model, nav, P, x)
        self._runs = np.broadcast_shapes(self._held["P"].shape[:-2], self._held["x"].shape[:-1])

    def _places(self, model: Library) -> None:
        """Where what stands in the C of a run."""
        n = len(model.states)
        self._part: dict[str, slice] = {}
        start = 0
        for struct in self.described["carried"]:
            for name, part in model.layout[struct].items():
                self._part[name] = slice(start + part.start, start + part.stop)
            start += model.width[struct]
        self._carried = tuple(self._part)
        start = max(1, start)
        sizes = {"x": n, "P": n * (n + 1) // 2, "counts": len(self.described["measurements"]) + 1, "considered": 1 + n}
        for name, size in sizes.items():
            self._part[name] = slice(start, start + size)
            start += size
        self._size = start
        self._upper, self._place = packed(n)
        self._diagonal = self._part["P"].start + self._place.diagonal()

    # ------------------------------------------------------------ what the caller sees

    @property  # type: ignore[override]
    def P(self) -> Array:
        """(..., n, n) covariance of the state."""
        return self._lend("P")

    @P.setter
    def P(self, value: Array) -> None:
        value = np.asarray(value, dtype=float)
        check_shape(self.model, value)
        with np.errstate(invalid="ignore", over="ignore"):  # the C judges what is not finite
            check_symmetric("P", of_unit_variances(value))  # of which the C has one triangle
        self._take("P", value)

    @property  # type: ignore[override]
    def x(self) -> Array:
        """(..., n) the state."""
        return self._lend("x")

    @x.setter
    def x(self, value: Array) -> None:
        value = np.asarray(value, dtype=float)
        check_state(value, len(self._library.states))
        self._take("x", value)

    @property  # type: ignore[override]
    def nav(self) -> Held:
        return self._nav

    @nav.setter
    def nav(self, value: dict[str, Array]) -> None:
        self._nav = Held(self, [])
        self._nav.update(value)

    def variances(self) -> Array:
        """(..., n) the diagonal of P."""
        if "P" in self._lent or self._memory is None:
            return np.diagonal(self.P, axis1=-2, axis2=-1).copy()
        return self._shaped(self._memory.blocks[:, self._diagonal].transpose(0, 2, 1))

    def _shaped(self, blocks: Array) -> Array:
        """(blocks, width, size) as (..., size)."""
        assert self._memory is not None
        return blocks.reshape(-1, blocks.shape[-1])[: self._memory.n].reshape(*self._runs, -1)

    def _lend(self, name: str) -> Array:
        self._lent.add(name)
        return self._seen(name)

    def _take(self, name: str, value: Array) -> None:
        self._held[name] = value
        self._lent.add(name)

    def _forget(self, names: Any) -> None:
        """What these are stands in the C alone."""
        if not self._held.keys().isdisjoint(names):
            for name in names:
                if self._held.pop(name, None) is not None:
                    self._lent.discard(name)

    def _seen(self, name: str) -> Array:
        """x, P or a field of nav."""
        if name not in self._held:
            assert self._memory is not None
            value = self._memory.read(self._part[name]).reshape(*self._runs, -1)
            if name == "P":
                value = value[..., self._place]
            elif name != "x" and self._library.field[name]["size"] == 1:
                value = value[..., 0]
            self._held[name] = value
        return self._held[name]

    def _leading(self) -> tuple[int, ...]:
        return self._runs

    def _broadcast(self) -> tuple[int, ...]:
        """The runs of x, P and nav together, as the caller sees them."""
        held = {name: value.shape[: -self._axes(name) or None] for name, value in self._held.items()
                if name in self._part}  # fmt: skip
        try:
            return np.broadcast_shapes(self._runs, *held.values())
        except ValueError:
            listed = ", ".join(f"{name} {runs}" for name, runs in held.items())
            raise BoresightError(f"the runs of a filter do not go together: {listed}, before {self._runs}") from None

    # ------------------------------------------------------------ into the C and back

    def _settle(self, runs: tuple[int, ...]) -> Memory:
        """The memory of so many runs, with all that the caller has changed."""
        if self._memory is None or self._runs != runs:
            for name in (*self._carried, "x", "P"):
                if self._memory is not None or name in self._held:
                    self._lend(name)
            width, self._dll = self._library.lanes(int(np.prod(runs, dtype=int)))
            self._memory, self._runs = Memory(int(np.prod(runs, dtype=int)), self._size, width), runs
            for name in self._carried:
                if name not in self._held:  # it stands in no function that is called
                    self._write(name, inside(self._library.field[name]))
        for name in self._lent:
            if name in self._part:
                self._write(name, self._held[name])
        self._lent.clear()
        return self._memory

    def _write(self, name: str, value: Array) -> None:
        assert self._memory is not None
        if name == "P":
            value = value[(..., *self._upper)]
        part = self._part[name]
        size = part.stop - part.start
        if name in self._carried and size == 1:
            value = value[..., None]
        self._memory.write(part, np.broadcast_to(value, (*self._runs, size)).reshape(-1, size))

    def strapdown(self, **inputs: Any) -> None:
        """Carry nav over one interval of inertial data."""
        if self.described["strapdown"] is None:
            raise BoresightError(f"{self.model.name} has no function 'strapdown'")
        self._fly("strapdown", self.described["strapdown"], inputs)

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
        jacobian: Any = None,
        **inputs: Any,
    ) -> Innovation:
        """Take one measurement, row after row: see `Filter.update`.  R is (..., m, m) of a correlated one alone.

        jacobian: is not looked at, for the C makes its own.
        """
        check_taking(measurement, rows, gate, joint, iterations)
        kept = self._considered(measurement, considered)
        z = self._brought(measurement, inputs)
        described = self.described["measurements"][measurement]
        m = described["m"]
        R, rows = np.atleast_1d(np.asarray(R, dtype=float)), np.atleast_1d(np.asarray(rows, dtype=bool))
        L_inverse, correlated = None, self._described(measurement, "correlated")
        plain = R.shape == (m,) and rows.shape[-1] in (1, m) and not correlated
        if not (plain and all([0 < variance < np.inf for variance in R.tolist()])):
            _, L_inverse = self._noise(measurement, R, (m,) if z is None else z.shape, rows)
        if L_inverse is not None:
            if not correlated:
                raise BoresightError(
                    f"{measurement}: R has shape {R.shape}, and its C takes the variances of independent rows; give "
                    "these, generate the Measurement with correlated=True, or fly Filter"
                )
            R = R.reshape((*R.shape[:-2], m * m))
        vectors = {"R": R} if z is None else {"z": z, "R": R}
        gates = gate or 0.0, joint or 0.0
        nu, S, nis, used = self._fly(
            f"measure_{measurement}", described, inputs, vectors, (rows, gates, iterations, kept)
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
        measured: tuple[Array, tuple[float, float], int, Array | None] | None = None,
    ) -> Any:
        """Call `function` of the C filter for all runs.  vectors: z if brought (..., m), and R.

        measured: rows (..., m) bool, the gates of a row and the joint one, iterations and the considered states
        (..., n) bool, or None, of a measurement, for which nu, S, nis and used are returned.
        Where a run is refused, all are as they were, and BoresightError names it.
        """
        vectors = vectors or {}
        by_run = [] if measured is None else [each for each in (measured[0], measured[3]) if each is not None]
        key = (
            function, self._runs, tuple(self._nav), tuple([(name, value.shape) for name, value in self._held.items()]),
            tuple([(name, np.shape(value)) for name, value in inputs.items()]),
            tuple([value.shape for value in vectors.values()]), tuple([value.shape for value in by_run]),
        )  # fmt: skip
        call = self._prepared.get(key)
        if call is None:
            call = self._prepared[key] = Prepared(self, function, described, inputs, vectors, by_run)
        call.fill(self, {**inputs, **vectors} if vectors else inputs)
        memory = self._settle(call.runs)
        for name in call.own:  # for this call alone
            if name in self.nav:
                self._lend(name)
            self._write(name, np.asarray(inputs[name], dtype=float))
        name = function
        if measured is not None:
            call.rows[...], call.gates[...], call.iterations[0] = measured[:3]
            self._consider(measured[3])
            name = "measure"
        if call.memory is not memory:
            which = () if measured is None else (ctypes.c_int.from_param(described["index"]),)
            call.memory, call.bound = memory, self._bind(name, *which, *call.asked)
        changed = self._changed(name)
        memory.keep(changed)
        call.status.fill(0)
        if call.bound():
            memory.give_back(changed)
            given = call.arranged(self, function, inputs)
            self._explain(function, {**{n: self._column(n) for n in self.nav if n in self._part}, **given}, call.status)
        if function == "propagate":
            self.at_ceiling = (call.status == AT_CEILING).reshape(call.runs)
        self._forget((*described.get("written", ()), *(("x", "P") if name != "strapdown" else ())))
        return (*(part.copy() for part in call.out), call.used.astype(bool)) if measured is not None else None

    def _axes(self, name: str) -> int:
        """How many axes of a value are none of runs."""
        return 2 if name == "P" else 1 if name == "x" or self._library.field[name]["size"] > 1 else 0

    def _bind(self, name: str, *asked: Any) -> Callable[[], int]:
        """The C function PREFIX_lanes_NAME for the runs as they are settled; a call of it converts no argument.

        asked: its parameters after the state, made by `byref` or `from_param`.
        """
        assert self._memory is not None
        function = getattr(self._dll, f"{self._library.manifest['c_prefix']}_lanes_{name}")
        function.restype = ctypes.c_size_t
        n, address = ctypes.c_size_t.from_param(self._memory.n), ctypes.c_void_p.from_param(self._memory.address)
        return functools.partial(function, n, address, *asked)

    def _changed(self, name: str) -> slice:
        """What of a run a function changes."""
        carried = slice(0, self._part["x"].start)
        if name == "strapdown":
            return carried
        return slice(0 if name == "correct" else carried.stop, self._part["counts"].stop)

    def _column(self, name: str) -> Array:
        """A carried field as `Library.arrange` makes it."""
        assert self._memory is not None
        return self._memory.read(self._part[name]).reshape(*self._runs, -1)

    def _consider(self, considered: Array | None) -> None:
        """Tell the C which states (..., n) bool no measurement corrects."""
        assert self._memory is not None
        part = self._part["considered"]
        if considered is None:
            if self._memory.blocks[:, part.start].any():
                self._memory.blocks[:, part] = 0.0
            return
        told = np.concatenate([considered.any(axis=-1, keepdims=True), considered], axis=-1)
        self._write("considered", told.astype(float))

    def _explain(self, function: str, given: dict[str, Array], status: Array) -> None:
        status = status.reshape(self._runs)
        bad = (status != Status.OK) & (status != Status.AT_CEILING)
        where = tuple(int(i) for i in np.argwhere(bad)[0])
        held = [self._column("P")[where], self._column("x")[where]]
        if status[where] == Status.NOT_POSITIVE or not all(np.isfinite(part).all() for part in held):
            at = f" of run {where[0] if len(where) == 1 else where}" if where else ""
            raise BoresightError(
                f"{function}: an innovation or its variance{at} is no number, or a variance is negative; start again "
                "from a new P"
            )
        self.model.explain(function, {**given, "x": self._column("x")}, self._runs, np.where(bad, status, Status.OK))


@functools.cache
def packed(n: int) -> tuple[tuple[Array, Array], Array]:
    """Rows and columns of a packed symmetric matrix, and (n, n) the place of each element in it."""
    columns, rows = np.tril_indices(n)  # column after column of the upper triangle
    place = np.zeros((n, n), dtype=int)
    place[rows, columns] = place[columns, rows] = np.arange(len(rows))
    return (rows, columns), place


def inside(field: dict[str, Any]) -> Array:
    """A value of a field that the filter carries and nobody has given: it stands in no function that is called."""
    low, high = np.array(field["low"]), np.array(field["high"])
    value = np.where((low <= 0) & (high >= 0), 0.0, (low + high) / 2)
    if field["norm"]:
        value[0] = sum(field["norm"]) / 2
    return value if field["size"] > 1 else value[0]
