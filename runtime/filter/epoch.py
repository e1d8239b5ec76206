"""All that a filter does from one epoch to the next in one call: its strapdown over the samples between, prediction,
measurements and correction.

A readable loop spends most of its time on the way from Python to C and back; an epoch goes that way once.
"""

import ctypes
from collections.abc import Collection, Iterator
from typing import Any

import numpy as np

from boresight.errors import BoresightError, did_you_mean
from boresight.runtime.arguments import whole
from boresight.runtime.array import Array
from boresight.runtime.filter.compiled import INFLATE, RELINEARIZE, CompiledFilter
from boresight.runtime.filter.memory import Blocks, Taking
from boresight.runtime.library import Given, Library
from boresight.runtime.status import Status


class Cycle(ctypes.Structure):
    """bs_epoch of boresight_lanes.h."""

    _fields_ = [
        ("samples", ctypes.c_size_t), ("strapdown", ctypes.c_void_p), ("propagate", ctypes.c_void_p),
        ("count", ctypes.c_int), ("which", ctypes.c_void_p), ("given", ctypes.c_void_p), ("taking", ctypes.c_void_p),
        ("correct", ctypes.c_int),
    ]  # fmt: skip


class Fixed:
    """What has arrays that the C finds by their place: one that is assigned is written into the one that is there."""

    def __setattr__(self, name: str, value: Any) -> None:
        there = self.__dict__.get(name)
        if isinstance(there, Inputs | dict):
            raise BoresightError(f"{name} stays what it is; write its fields, as {name}[FIELD] = value")
        if isinstance(there, np.ndarray):
            write(name, there, value)
        else:
            super().__setattr__(name, value)


def write(name: str, array: Array, value: Any) -> None:
    try:
        array[...] = value
    except ValueError:
        raise BoresightError(f"{name} has shape {np.shape(value)}; it must fit into {array.shape}") from None


class Inputs(Fixed):
    """What one function of the filter is given, in arrays that the C reads: `inputs["dt"][...] = 0.01`.

    A field is (..., size), or (...,) if it has one component; a field of the strapdown has an axis of samples in front.
    Where all fields of a struct of the C are shared, they have no axes of runs.
    """

    def __init__(self, library: Library, described: dict[str, Any], runs: tuple[int, ...], samples: int | None,
                 shared: Collection[str], vectors: dict[str, int]):  # fmt: skip
        front = () if samples is None else (samples,)
        self.fields: dict[str, Array] = {}
        self._arrays: list[Array] = []
        blocks = []
        for struct in described["structs"]:
            used = {n: part for n, part in library.layout[struct].items() if n in described["fields"]}
            alike = all(name in shared for name in used)
            array = np.zeros((*front, *(() if alike else runs), library.width[struct]))
            blocks.append((array, 0 if alike else array.shape[-1]))
            for name, part in used.items():
                self.fields[name] = array[..., part] if library.field[name]["size"] > 1 else array[..., part.start]
        for name, size in vectors.items():
            array = np.zeros((*(() if name in shared else runs), size))
            blocks.append((array, 0 if name in shared else size))
            self.fields[name] = array
        self._arrays = [array for array, _ in blocks]
        self.given = (Given * max(1, len(blocks)))(
            *(Given(a.ctypes.data, stride, a[0].size if front else 0) for a, stride in blocks)
        )

    def __getitem__(self, name: str) -> Array:
        if name not in self.fields:
            guess = did_you_mean(name, self.fields) or f"; it has {', '.join(self.fields) or 'none'}"
            raise BoresightError(f"an Epoch has no input {name!r} here{guess}")
        return self.fields[name]

    def __setitem__(self, name: str, value: Any) -> None:
        """Write into the array, by broadcasting; it stays the same array."""
        write(name, self[name], value)


class Measured(Inputs):
    """A measurement of an epoch: its inputs, R (..., m) and, where the caller brings it, z (..., m); how it is taken;
    and its innovation after a call, as `runtime.filter.Innovation` has it.

    rows: (..., m) not 0 for a row to be taken.  gates: (2,) that of a row in sigmas and the joint one, 0 for none.
    iterations: (1,) linearisations at most.  options: (1,) BS_INFLATE and BS_RELINEARIZE of boresight_filter.h.
    nu, S, used (..., m), nis (...); used is 3 where R was inflated.
    """

    def __init__(self, loop: CompiledFilter, name: str, runs: tuple[int, ...], shared: Collection[str]):
        described = loop.described["measurements"][name]
        m = described["m"]
        library = loop.memory.library
        size = m * m if library.measurements[name].get("correlated") else m
        super().__init__(
            library, described, runs, None, shared, {**({"z": m} if described["brings_z"] else {}), "R": size}
        )
        self.index: int = described["index"]
        alike = "rows" in shared
        self.rows = np.ones((*(() if alike else runs), m), dtype=np.uint8)
        self.gates, self.iterations = np.zeros(2), np.ones(1, dtype=np.intc)
        self.options = np.zeros(1, dtype=np.uintc)
        self.nu, self.S, self.nis = np.zeros((*runs, m)), np.zeros((*runs, m)), np.zeros(runs)
        self.used = np.zeros((*runs, m), dtype=np.uint8)
        taken = self.gates, self.iterations, self.options, self.nu, self.S, self.nis, self.used
        ends = (part.ctypes.data for part in taken)
        self.taking = Taking(self.rows.ctypes.data, 0 if alike else m, *ends)

    def recorded(self) -> dict[str, Any]:
        """What the last call took and found, in arrays of its own, by the names of `Filter.update` and Innovation."""
        gate, joint = (float(value) for value in self.gates)
        options = int(self.options[0])
        chosen = {"gate": gate, "joint": joint, "iterations": float(self.iterations[0]),
                  "inflate": float(options & INFLATE > 0), "relinearize": float(options & RELINEARIZE > 0)}  # fmt: skip
        return {
            **{name: np.array(value) for name, value in self.fields.items()}, **chosen,
            "nu": self.nu.copy(), "S": self.S.copy(), "nis": self.nis.copy(),
            "used": self.used % 2 == 1, "inflated": self.used > 1,
        }  # fmt: skip


class Epoch(Fixed):
    """All that a `CompiledFilter` does from one epoch to the next in one call, for all of its runs.

    Write `strapdown`, `predict` and `measured[NAME]`, call, look at `status`: the strapdown is
    called for each sample, then once the prediction, the measurements in their order, and the
    correction.  A run has the bits of these calls one by one.  A run that a step refuses stays as
    the step before it left it, and the others go on.

    Parameters
    ----------
    loop : CompiledFilter
        Its state is carried on, and can be read and assigned between calls as before.
    samples : int
        How many there are between two epochs; 0 for none.
    measurements : collection of str, optional
        Their names.  One can be left out of a call by `rows`; one that comes seldom is better in an
        Epoch of its own.
    predict, feedback : bool, optional
        Whether they are part of it.
    runs : tuple of int, optional
        The leading axes, by default those of the loop's x, P and nav.
    shared : collection of str, optional
        Fields, and "z", "R" or "rows", that are alike in all runs, and have no axes of them.

    Attributes
    ----------
    strapdown : mapping of str to (samples, ..., size) array
        What the strapdown is given, by field; (samples, ...) if it has one component.
    predict : mapping of str to (..., size) array
        What the prediction is given.
    measured : dict of str to Measured
        By measurement: its fields, R (..., m), z (..., m) where the caller brings it, `rows`,
        `gates` and `iterations`; after a call its innovation `nu`, `S`, `used` and `nis`.
    status : (...,) uint8 array
        Of each run, the number of a status of docs/conventions.md: 0 where all is well.  With
        BS_AT_CEILING the run went on.

    Raises
    ------
    BoresightError
        A measurement or field that the model does not have, a step that it lacks, a number of
        samples or runs that is none, a loop with considered or disabled states.

    Notes
    -----
    When not to use it: where the steps of an epoch change from one to the next, or to read a state
    between them; the methods of `CompiledFilter` do that.  Arrays are written in place and are
    never replaced: `epoch.predict["dt"][...] = 0.01` and `epoch.predict["dt"] = 0.01` are the same.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import CompiledFilter, Epoch, load
    >>> nav = {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}
    >>> loop = CompiledFilter(load("euler-matching"), nav, P=np.eye(6) * 1e-4)
    >>> epoch = Epoch(loop, samples=10, feedback=False)
    >>> epoch.strapdown["dt"] = 0.1
    >>> epoch.predict["dt"] = 1.0
    >>> epoch()
    0
    >>> print(np.sqrt(loop.variances()).round(4))
    [0.01 0.01 0.01 0.01 0.01 0.01]
    """

    def __init__(
        self,
        loop: CompiledFilter,
        samples: int,
        measurements: Collection[str] = (),
        *,
        predict: bool = True,
        feedback: bool = True,
        runs: tuple[int, ...] | None = None,
        shared: Collection[str] = (),
    ):
        described, memory = loop.described, loop.memory
        library, fields = memory.library, memory.library.field
        if isinstance(measurements, str) or len(set(measurements)) < len(measurements):
            raise BoresightError(f"measurements is {measurements!r}; give a list of names, each once")
        unknown = [name for name in measurements if name not in described["measurements"]]
        if unknown:
            known = ", ".join(described["measurements"])
            raise BoresightError(f"{loop.model.name} has no measurement {unknown[0]!r}; it has {known}")
        unknown = [name for name in shared if name not in {*fields, "z", "R", "rows"}]
        if unknown:
            raise BoresightError(f"{loop.model.name} has no input {unknown[0]!r}; it has {', '.join(fields)}")
        for what, wanted, function in (("strapdown", samples, "strapdown"), ("feedback", feedback, "correct")):
            if wanted and described[function] is None:
                raise BoresightError(f"{loop.model.name} has no function {what!r}")
        if not whole(samples) or samples < 0:
            raise BoresightError(f"samples is {samples!r}; it must be at least 0, and whole")
        self._corrects_all(loop)
        self.loop, self.runs = loop, memory.broadcast() if runs is None else runs
        if not isinstance(self.runs, tuple) or not all(whole(n) and n > 0 for n in self.runs):
            raise BoresightError(f"runs is {self.runs!r}; give the leading axes, as (5,), of one run or more")
        nothing: dict[str, Any] = {"structs": [], "fields": [], "written": []}
        strapdown = described["strapdown"] if samples else nothing
        propagate = described["propagate"] if predict else nothing
        correct = described["correct"] if feedback else nothing
        self.strapdown = Inputs(library, strapdown, self.runs, samples or None, shared, {})
        self.predict = Inputs(library, propagate, self.runs, None, shared, {})
        self.measured = {name: Measured(loop, name, self.runs, shared) for name in measurements}
        self.status = np.zeros(self.runs, dtype=np.uint8)
        flown = (strapdown, propagate, *(described["measurements"][name] for name in measurements), correct)
        self._carried = [name for name in memory.fields if any(name in one["fields"] for one in flown)]
        self._changed = ["x", "P"] if predict or measurements or feedback else []
        self._changed += strapdown["written"] + correct["written"]
        each = list(self.measured.values())
        self._which = (ctypes.c_int * max(1, len(each)))(*(one.index for one in each))
        self._given = (ctypes.c_void_p * max(1, len(each)))(*(ctypes.addressof(one.given) for one in each))
        self._taking = (Taking * max(1, len(each)))(*(one.taking for one in each))
        self._cycle = Cycle(
            samples, ctypes.addressof(self.strapdown.given), ctypes.addressof(self.predict.given) if predict else None,
            len(each), ctypes.addressof(self._which), ctypes.addressof(self._given), ctypes.addressof(self._taking),
            int(feedback),
        )  # fmt: skip
        self._bound: Any = None
        self._blocks: Blocks | None = None  # of the last call

    def __call__(self) -> int:
        """Carry all runs to the next epoch.

        Returns
        -------
        int
            How many runs a step refused; 0 where all is well.
        """
        memory = self.loop.memory
        if memory.lent or self._blocks is not memory.blocks:
            self._check()
        if self.loop.recorder is not None:
            return int(self.loop.recorder.epoch(self, self._fly))
        return self._fly()

    def _fly(self, step: Cycle | None = None) -> int:
        """All of it, or one of `steps`."""
        memory = self.loop.memory
        if memory.lent or self._blocks is not memory.blocks:
            blocks = memory.settle(self.runs)
            if self._blocks is not blocks:
                self._blocks, self._bound = blocks, self._bind(self._cycle)
        refused: int = self._bound() if step is None else self._bind(step)()
        if memory.copies:
            memory.forget(self._changed)
        return refused

    def _bind(self, cycle: Cycle) -> Any:
        status = ctypes.c_void_p.from_param(self.status.ctypes.data)
        return self.loop.memory.bind("epoch", ctypes.byref(cycle), status)

    def steps(self) -> Iterator[tuple[str, Cycle]]:
        """Its parts one after the other, for a record.

        Yields
        ------
        tuple of str and Cycle
            "strapdown", "predict", a measurement's name or "feedback", and what the C is given.
        """
        whole, which, given, taking = self._cycle, self._which, self._given, self._taking

        def part(samples: int = 0, predict: Any = None, count: int = 0, i: int = 0, correct: int = 0) -> Cycle:
            at = (ctypes.addressof(array) + i * ctypes.sizeof(array._type_) for array in (which, given, taking))
            return Cycle(samples, whole.strapdown, predict, count, *at, correct)

        if whole.samples:
            yield "strapdown", part(samples=whole.samples)
        if whole.propagate:
            yield "predict", part(predict=whole.propagate)
        for i, name in enumerate(self.measured):
            yield name, part(count=1, i=i)
        if whole.correct:
            yield "feedback", part(correct=1)

    @staticmethod
    def _corrects_all(loop: CompiledFilter) -> None:
        if loop.considered is not None or loop.disabled is not None:
            what = "considered" if loop.disabled is None else "disabled"
            raise BoresightError(f"an Epoch corrects every state; fly a filter with {what} states by its methods")

    def _check(self) -> None:
        """Raise BoresightError where the loop has states that it does not correct, other runs, or too little in nav."""
        self._corrects_all(self.loop)
        missing = [name for name in self._carried if name not in self.loop.nav]
        if missing:
            raise BoresightError(f"an Epoch of {self.loop.model.name} needs {', '.join(missing)}; give it in nav")
        theirs, ours = self.loop.memory.broadcast(), self.runs
        if len(theirs) > len(ours) or any(a not in (1, b) for a, b in zip(theirs[::-1], ours[::-1], strict=False)):
            raise BoresightError(f"the filter has the runs {theirs}, and the Epoch {ours}; make one of these runs")

    def refused(self) -> str:
        """What became of the first run that was refused.

        Returns
        -------
        str
            The run and the name of its status; empty where all is well.
        """
        bad = np.argwhere((self.status != Status.OK) & (self.status != Status.AT_CEILING))
        if not len(bad):
            return ""
        where = tuple(int(i) for i in bad[0])
        at = f"run {where[0] if len(where) == 1 else where}: " if where else ""
        return f"{at}BS_{Status(int(self.status[where])).name}"
