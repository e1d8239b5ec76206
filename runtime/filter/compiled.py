"""The filter of `boresight.runtime.filter` with its algebra in the generated C, `batch/PREFIX_lanes.c`.

The same methods with the same meaning, for one run or many; each is one call of C, in which blocks of runs follow one
another.  The state stays in the C between calls.  A run has the bits that the scalar functions of `src/PREFIX_filter.c`
give it, whatever stands beside it; they are those of the Python loop, to rounding.
"""

import ctypes
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.arguments import check_inputs, check_own_state, check_shape, check_state, check_taking
from boresight.runtime.array import Array
from boresight.runtime.filter.filter import Filter, Innovation, check_symmetric, of_unit_variances
from boresight.runtime.filter.memory import Blocks, Memory, Nav, Taking
from boresight.runtime.library import Given, Library
from boresight.runtime.status import Status

INFLATE, RELINEARIZE = 1, 2  # BS_INFLATE and BS_RELINEARIZE of boresight_filter.h
AT_CEILING = int(Status.AT_CEILING)  # compared with an array, the enum takes five times as long


class Prepared:
    """What one function is called with, for names and shapes that have been looked at: arrays that the C reads.

    runs: of the call.  own: carried fields that are given, for this call alone.
    """

    def __init__(self, memory: Memory, function: str, described: dict[str, Any], inputs: dict[str, Any],
                 vectors: dict[str, Array], measured: list[Array]):  # fmt: skip
        library = memory.library
        check_inputs(function, library, inputs, memory.nav, np.empty((*memory.runs, 0, 0)))
        missing = [name for name in described["fields"] if name not in inputs and name not in memory.nav]
        if missing:
            raise BoresightError(f"{function} needs {', '.join(missing)}; pass it as a keyword")
        self.own = [name for name in memory.fields if name in inputs]
        self._read = [name for name in described["fields"] if name not in memory.fields]
        given, runs = library.arrange(function, {n: self.value(memory, n, inputs) for n in [*self._read, *self.own]})
        shapes = [runs, memory.broadcast(), *(v.shape[:-1] for v in [*vectors.values(), *measured])]
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
        self.blocks: Blocks | None = None  # of the last call
        taking: tuple[Any, ...] = ()
        if measured:
            m = described["m"]
            self.rows, self.gates = np.zeros((*self.runs, m), dtype=np.uint8), np.zeros(2)
            self.iterations, self.options = np.zeros(1, dtype=np.intc), np.zeros(1, dtype=np.uintc)
            self.out = np.zeros((*self.runs, m)), np.zeros((*self.runs, m)), np.zeros(self.runs)
            self.used = np.zeros((*self.runs, m), dtype=np.uint8)
            ends = (part.ctypes.data for part in (self.gates, self.iterations, self.options, *self.out, self.used))
            taking = (ctypes.byref(Taking(self.rows.ctypes.data, m, *ends)),)
        self.asked = (ctypes.byref(self.given), *taking, ctypes.c_void_p.from_param(self.status.ctypes.data))

    @staticmethod
    def value(memory: Memory, name: str, inputs: dict[str, Any]) -> Any:
        return inputs[name] if name in inputs else memory.read(name)

    def fill(self, memory: Memory, inputs: dict[str, Any]) -> None:
        for name, view in self._fields:
            view[...] = self.value(memory, name, inputs)

    def arranged(self, memory: Memory, function: str, inputs: dict[str, Any]) -> dict[str, Array]:
        """What was given, as `Library.arrange` has it."""
        names = [*self._read, *self.own]
        return memory.library.arrange(function, {name: self.value(memory, name, inputs) for name in names})[0]


class CompiledFilter(Filter):
    """The filter of the generated C: `Filter` with the same methods and meaning, equal to rounding.

    One run or many: each method is one call of C, in which blocks of runs follow one another.  A
    run has the bits of the scalar C that is exported, whatever stands beside it.  Units, frames and
    shapes are those of `Filter`.

    Parameters
    ----------
    model : Library
        Of `load`, in double, of a model that has measurements.
    nav : dict of str to (..., size) array
        What the strapdown carries and the feedback corrects, by field name; {} for a model without.
    P : (..., n, n) array
        Covariance of the state at the start.
    x : (..., n) array, optional
        Where a total state begins; an error state begins at zero.

    Attributes
    ----------
    x, P, nav
        As above, now.  They may be assigned, or changed in place, between calls.  They stay in the
        C: an array that was read holds what the filter held then, and a change of it counts until
        the next call.
    considered, disabled, at_ceiling
        As of `Filter`.

    Raises
    ------
    BoresightError
        As `Filter`; and a library in float or by CasADi, a jacobian, or R with correlated rows of a
        measurement that does not declare `correlated=True`.  Where one run is refused, all stay as
        they were, and the line names the run.

    See Also
    --------
    Epoch : all steps between two epochs in one call.

    Notes
    -----
    When not to use it: for a model that is a Python object of one's own, for float (export it and
    fly the C), or where the caller brings a Jacobian; `Filter` takes these.  `variances` costs less
    than P.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import CompiledFilter, load
    >>> nav = {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}
    >>> loop = CompiledFilter(load("euler-matching"), nav, P=np.eye(6) * 1e-4)
    >>> loop.predict(omega_in_n=np.zeros(3), gyro_noise=np.full(3, 1e-4), dt=1.0)
    >>> print(np.sqrt(loop.variances()).round(4))
    [0.01 0.01 0.01 0.01 0.01 0.01]
    """

    def __init__(self, model: Library, nav: dict[str, Array], P: Array, x: Any = None):
        described = model.manifest.get("filter") if isinstance(model, Library) else None
        if described is None:
            raise BoresightError(
                f"{getattr(model, 'name', model)!s} has no filter in C; give a library of a model that has measurements"
            )
        if model.precision != "double":
            raise BoresightError(f"{model.name} is compiled in {model.precision}; CompiledFilter carries P in double")
        self.described, self.memory = described, Memory(model, described)
        self._prepared: dict[Any, Prepared] = {}  # by names and shapes
        super().__init__(model, nav, P, x)
        copies = self.memory.copies
        self.memory.runs = np.broadcast_shapes(copies["P"].shape[:-2], copies["x"].shape[:-1])

    # ------------------------------------------------------------ what the caller sees

    @property  # type: ignore[override]
    def P(self) -> Array:
        """(..., n, n) covariance of the state."""
        return self.memory.lend("P")

    @P.setter
    def P(self, value: Array) -> None:
        value = np.asarray(value, dtype=float)
        check_shape(self.model, value)
        with np.errstate(invalid="ignore", over="ignore"):  # the C judges what is not finite
            check_symmetric("P", of_unit_variances(value))  # of which the C has one triangle
        self.memory.assign("P", value)

    @property  # type: ignore[override]
    def x(self) -> Array:
        """(..., n) the state."""
        return self.memory.lend("x")

    @x.setter
    def x(self, value: Array) -> None:
        value = np.asarray(value, dtype=float)
        check_state(value, len(self.memory.library.states))
        self.memory.assign("x", value)

    @property  # type: ignore[override]
    def nav(self) -> Nav:
        return self.memory.nav

    @nav.setter
    def nav(self, value: dict[str, Array]) -> None:
        self.memory.nav = Nav(self.memory)
        self.memory.nav.update(value)

    def variances(self) -> Array:
        """The diagonal of P, without the rest of it.

        Returns
        -------
        (..., n) array
            A copy, in the squares of the states' units.
        """
        return self.memory.variances()

    def _leading(self) -> tuple[int, ...]:
        return self.memory.runs

    def strapdown(self, **inputs: Any) -> None:
        check_own_state("strapdown", inputs)
        if self.described["strapdown"] is None:
            raise BoresightError(f"{self.model.name} has no function 'strapdown'")
        self._fly("strapdown", self.described["strapdown"], inputs)

    def predict(self, **inputs: Any) -> None:
        check_own_state("predict", inputs)
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
        inflate: bool = False,
        relinearize: bool = False,
        considered: Any = None,
        jacobian: Any = None,
        **inputs: Any,
    ) -> Innovation:
        check_taking(measurement, rows, gate, joint, iterations, inflate, relinearize)
        check_own_state(measurement, inputs)
        if jacobian is not None:
            raise BoresightError(f"{measurement}: the C makes its own jacobian; leave it out, or fly Filter")
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
        options = INFLATE * inflate + RELINEARIZE * relinearize
        nu, S, nis, used = self._fly(
            f"measure_{measurement}", described, inputs, vectors, (rows, gates, iterations, kept, options)
        )
        return Innovation(nu, S, used % 2 == 1, nis, used > 1)

    def feedback(self) -> None:
        if self.described["correct"] is None:
            raise BoresightError(f"{self.model.name} has no function 'feedback'")
        self._fly("correct", self.described["correct"], {})

    def _fly(
        self,
        function: str,
        described: dict[str, Any],
        inputs: dict[str, Any],
        vectors: dict[str, Array] | None = None,
        measured: tuple[Array, tuple[float, float], int, Array | None, int] | None = None,
    ) -> Any:
        """Call `function` of the C filter for all runs.  vectors: z if brought (..., m), and R.

        measured: rows (..., m) bool, the gates of a row and the joint one, iterations, the considered states (..., n)
        bool, or None, and options of a measurement, for which nu, S, nis and used, as bs_taking has it, are returned.
        Where a run is refused, all are as they were, and BoresightError names it.
        """
        vectors, memory = vectors or {}, self.memory
        by_run = [] if measured is None else [each for each in (measured[0], measured[3]) if each is not None]
        key = (
            function, memory.runs, tuple(memory.nav),
            tuple([(name, value.shape) for name, value in memory.copies.items()]),
            tuple([(name, np.shape(value)) for name, value in inputs.items()]),
            tuple([value.shape for value in vectors.values()]), tuple([value.shape for value in by_run]),
        )  # fmt: skip
        call = self._prepared.get(key)
        if call is None:
            call = self._prepared[key] = Prepared(memory, function, described, inputs, vectors, by_run)
        call.fill(memory, {**inputs, **vectors} if vectors else inputs)
        blocks = memory.settle(call.runs)
        for name in call.own:  # for this call alone
            if name in memory.nav:
                memory.lend(name)
            memory.write(name, np.asarray(inputs[name], dtype=float))
        name = function
        if measured is not None:
            call.rows[...], call.gates[...], call.iterations[0] = measured[:3]
            call.options[0] = measured[4]
            memory.consider(measured[3], self.disabled)
            name = "measure"
        elif function == "propagate":
            memory.consider(None, self.disabled)
        if call.blocks is not blocks:
            which = () if measured is None else (ctypes.c_int.from_param(described["index"]),)
            call.blocks, call.bound = blocks, memory.bind(name, *which, *call.asked)
        changed = memory.changed(name)
        blocks.keep(changed)
        call.status.fill(0)
        if call.bound():
            blocks.give_back(changed)
            given = {n: memory.column(n) for n in memory.nav if n in memory.part}
            self._explain(function, {**given, **call.arranged(memory, function, inputs)}, call.status)
        if function == "propagate":
            self.at_ceiling = (call.status == AT_CEILING).reshape(call.runs)
        memory.forget((*described.get("written", ()), *(("x", "P") if name != "strapdown" else ())))
        return (*(part.copy() for part in call.out), call.used.copy()) if measured is not None else None

    def _explain(self, function: str, given: dict[str, Array], status: Array) -> None:
        memory = self.memory
        status = status.reshape(memory.runs)
        bad = (status != Status.OK) & (status != Status.AT_CEILING)
        where = tuple(int(i) for i in np.argwhere(bad)[0])
        held = [memory.column("P")[where], memory.column("x")[where]]
        if status[where] == Status.NOT_POSITIVE or not all(np.isfinite(part).all() for part in held):
            at = f" of run {where[0] if len(where) == 1 else where}" if where else ""
            raise BoresightError(
                f"{function}: an innovation or its variance{at} is no number, or a variance is negative; start again "
                "from a new P"
            )
        self.model.explain(function, {**given, "x": memory.column("x")}, memory.runs, np.where(bad, status, Status.OK))
