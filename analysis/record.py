"""What a flight did, step by step: the state and its covariance, and by what each step changed them.

A step is written down as it was called, and what follows from that, Phi and the gain, is computed when it is asked for,
of all steps in one call.  So a flight hardly waits for its record.
"""

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.live_record import LiveSteps, Place, Recorded, Step
from boresight.errors import need
from boresight.runtime.array import Array
from boresight.runtime.filter import CompiledFilter, Filter, Innovation
from boresight.runtime.filter.memory import packed
from boresight.runtime.live import Live

STEPS = ("predict", "update", "feedback", "set_block", "inflate", "disable", "enable")
BLOCKS = STEPS[3:]
FOUND = ("nu", "S", "used", "nis", "inflated")  # of an Innovation
TAKING = ("R", "rows", "considered", "jacobian")  # arrays that an update is called with beside its inputs
LINEARISING = ("iterations", "relinearize")
OPTIONS = ("gate", "joint", "inflate", *LINEARISING)
CHUNK_BYTES, CHUNK_STEPS = 2**25, 1024  # what is kept as it came before it becomes arrays


@dataclass(frozen=True)
class Table:
    """Steps of one name that were given the same things.

    rows: (K,) their places in the record.  given: (K, ...) of each.  before: (K, ..., size) of nav, of a feedback.
    """

    name: str
    rows: Array
    given: dict[str, Array]


@dataclass(frozen=True)
class Chunk:
    """Steps that follow each other, of the same runs.  P (K, ..., n (n + 1) / 2): a triangle, as the C has it."""

    names: list[str]
    time: Array
    piece: Array
    x: Array
    P: Array
    nav: dict[str, Array]
    tables: list[Table]


class Record:
    """What a flight of a filter did, step by step; from now on, or of an earlier flight in a folder.

    Of a filter it records each `predict`, `update`, `feedback`, `set_block`, `inflate`, `disable` and `enable` of
    it, and those of an `Epoch` of it.  A step that raises leaves nothing.  Where x or P is assigned,
    a new piece begins; of an error state whose x alone is assigned, it is a feedback by hand; see
    `withdrawn`.  Of a live loop it records what each call of its background does, at the instant
    that the covariance has reached; a new piece begins where the loop begins, is restored, or could
    not read all samples.  Units and frames are those of the filter.

    Parameters
    ----------
    loop : Filter, CompiledFilter or Live
        Is flown as before, with the same bits.
    path : str or Path, optional
        A folder for Parquet files, so that the memory that is needed does not grow with the flight;
        in memory without.

    Attributes
    ----------
    model, states
        Of the filter.
    names : (K,) array of str
        Of each step: "begin" of a piece, "predict", the measurement's, "feedback", "set_block",
        "inflate", "disable", "enable" or "withdrawn".
    time, piece : (K,) array
        s, the sum of `dt` of the predictions, or of a live loop the instant by its own clock; and the
        number of the piece.
    x, P : (K, ..., n) and (K, ..., n, n) array
        After each step; before it they are those of the step before.
    nav : dict of str to (K, ..., size) array
        After each step; of a live loop the best that is known at that instant.

    Raises
    ------
    BoresightError
        No filter, or one that is recorded already, a folder that cannot be written or that holds files.

    Notes
    -----
    When not to use it: to learn what reached the newest sample of a live loop, and when; that is
    `Live.output`.  An `Epoch` in which a run is refused ends a piece.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Filter, Record, load
    >>> nav = {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}
    >>> loop = Filter(load("euler-matching"), nav, P=np.eye(6) * 1e-4)
    >>> record = Record(loop)
    >>> loop.predict(omega_in_n=np.zeros(3), gyro_noise=np.full(3, 1e-4), dt=1.0)
    >>> angles = {"euler_b": loop.call("euler_angles"), "euler_m": np.zeros(3)}
    >>> found = loop.update("euler_exact", R=np.full(3, 1e-6), **angles)
    >>> loop.feedback()
    >>> print(*record.names, record.Phi().shape, record.gain("euler_exact").shape)
    begin predict euler_exact feedback (1, 6, 6) (1, 6, 3)
    """

    def __init__(self, loop: Filter | Live, path: str | Path | None = None):
        if recorded(loop):
            raise BoresightError("this filter is recorded already; end that record by stop()")
        self.model: Any = loop.library if isinstance(loop, Live) else loop.model
        self.total: bool = not isinstance(loop, Live) and loop.total
        self.folder = None if path is None else Path(path)
        self._chunks: list[Any] = []  # a Chunk, steps as they came, or the Path of a file
        self._loaded: Chunk | None = None
        if self.folder is not None:
            need("parquet")
            try:
                self.folder.mkdir(parents=True, exist_ok=True)
                if any(self.folder.iterdir()):
                    raise BoresightError(f"{self.folder} is not empty; choose another folder for the record")
            except OSError as error:
                raise BoresightError(f"cannot write to {self.folder} ({error.strerror}); choose another one") from None
        self._steps: list[Any] = []  # as `_chunk` takes them, or (s, piece, Step) of a live loop
        self._raw = np.empty((0, 0, 0, 0))
        self._count, self._clock, self._piece = 0, 0.0, -1
        self._last: dict[str, Array] | None = None
        self._runs: tuple[int, ...] = ()
        self._live: LiveSteps | None = None
        self.loop: Filter | None = None
        if isinstance(loop, Live):
            self._live = LiveSteps(loop, self._came, self._known_better)
            return
        self.loop, self._runs = loop, loop.x.shape[:-1]
        loop.recorder = self
        for name in STEPS:
            setattr(loop, name, partial(self._step, name, getattr(loop, name)))
        setattr(loop, "strapdown", partial(self._passed, loop.strapdown))  # noqa: B010
        part = loop.memory.part if isinstance(loop, CompiledFilter) else {}
        self._in_C = all(name in part for name in loop.nav)  # all of nav, so that it lies among the numbers of the C
        self._layout = loop.x.shape[-1], {n: np.array(v) for n, v in self._nav()}, part
        self._begin()

    @classmethod
    def open(cls, path: str | Path, model: Any) -> "Record":
        """The record of an earlier flight.

        Parameters
        ----------
        path : str or Path
            The folder that it was given.
        model : Library
            Of that flight.

        Returns
        -------
        Record

        Raises
        ------
        BoresightError
            No such folder, or one of another model.
        """
        need("parquet")
        made = object.__new__(cls)
        made.model, made.folder, made.loop, made._live, made._loaded = model, Path(path), None, None, None
        made._steps = []
        made._chunks = sorted(made.folder.glob("steps-*.parquet"))
        if not made._chunks:
            raise BoresightError(f"{path} holds no record; give the folder that Record was given")
        made.total = bool(read_chunk(made._chunks[0], made.states)[1])
        return made

    @property
    def states(self) -> tuple[str, ...]:
        named = getattr(self.model, "states", None)
        n = self.loop.x.shape[-1] if named is None and self.loop is not None else 0
        return tuple(named) if named is not None else tuple(f"state {i}" for i in range(n))

    # ------------------------------------------------------------ while it flies

    def stop(self) -> None:
        """Record no longer; what was recorded stays."""
        self._close()
        if self._live is not None:
            self._live.stop()
        if self.loop is None:
            return
        for name in (*STEPS, "strapdown"):
            delattr(self.loop, name)
        self.loop.recorder = None
        self.loop = None

    def _step(self, name: str, method: Any, *args: Any, **inputs: Any) -> Any:
        loop = self.loop
        assert loop is not None
        self._look()
        given = self._given(name, args, inputs)
        found = method(*args, **inputs)  # raises, and nothing is left
        if isinstance(found, Innovation):
            name = args[0] if args else inputs["measurement"]
            given |= {part: getattr(found, part) for part in FOUND}
        self._add(name, given)
        return found

    def _passed(self, method: Any, **inputs: Any) -> None:
        self._look()  # after it the C has what was assigned
        method(**inputs)

    def epoch(self, epoch: Any, fly: Any) -> int:
        """Fly an `Epoch` step after step, with the bits of its one call; it calls this itself.

        Parameters
        ----------
        epoch : Epoch
            Of the filter.
        fly : callable
            Flies one of `epoch.steps()`, or all without an argument; returns how many runs were
            refused.

        Returns
        -------
        int
            How many runs were refused: then the epoch is flown in one call and a new piece begins.
        """
        assert isinstance(self.loop, CompiledFilter)
        self._look()
        memory, found, status = self.loop.memory, [], np.zeros_like(epoch.status)
        before = memory.settle(epoch.runs).numbers.copy()
        for name, step in epoch.steps():
            if name == "feedback":
                given = self._given(name, (), {})
            if fly(step):
                memory.blocks.numbers[...] = before
                memory.forget(memory.part)
                refused: int = fly()
                self._begin()
                return refused
            np.maximum(status, epoch.status, out=status)
            if name in epoch.measured:
                given = epoch.measured[name].recorded()
            elif name == "predict":
                given = {field: np.array(value) for field, value in epoch.predict.fields.items()}
            if name != "strapdown":
                state, runs, numbers = self._now()
                found.append((name, given, (state, runs, numbers.copy())))
        epoch.status[...] = status
        for one in found:
            self._add(*one)
        return 0

    def withdrawn(self) -> None:
        """Go on in this piece after x and P were assigned what they were before the last measurements.

        Of a run whose measurements were withdrawn; the others are as they were.  They count for
        nothing then, in the smoother too.

        Raises
        ------
        BoresightError
            By `smooth`, where x or P of a run is something else.
        """
        self._add("withdrawn", {})

    def _given(self, name: str, args: tuple[Any, ...], inputs: dict[str, Any]) -> dict[str, Any]:
        """What a step was called with, in arrays of its own."""
        loop = self.loop
        assert loop is not None
        words = inputs
        if name == "update":
            words = {**inputs, **dict(zip(("measurement", "R"), args, strict=False))}
            del words["measurement"]
            if words.get("considered") is None:
                words["considered"] = loop.considered
        elif name in BLOCKS:
            second = {"inflate": "variance", "disable": "count"}.get(name, "block")
            words = {"count": 1} | dict(zip(("first", second), args, strict=False)) | inputs
        given = {n: v if type(v) is float else np.array(v, float) for n, v in words.items() if v is not None}
        if name == "feedback":
            given |= {f"nav {n}": np.array(v) for n, v in self._nav()}
        if name == "predict" and loop.disabled is not None:
            given["disabled"] = loop.disabled.astype(float)
        return given

    def _nav(self) -> Iterator[tuple[str, Array]]:
        assert self.loop is not None
        nav: Any = self.loop.nav
        return ((n, nav.seen(n) if hasattr(nav, "seen") else nav[n]) for n in nav)

    def _add(self, name: str, given: dict[str, Any], now: Any = None) -> None:
        """A step, of what the filter is now, or was."""
        state, runs, numbers = self._now() if now is None else now
        if runs != self._runs or len(self._steps) == len(self._raw) or numbers.shape != self._raw.shape[1:]:
            self._close()
            self._runs = runs
            size = 2 * state["P"].nbytes if state else numbers.nbytes
            self._raw = np.empty((max(1, min(CHUNK_STEPS, CHUNK_BYTES // size)), *numbers.shape))
        if state is None:
            self._raw[len(self._steps)] = numbers
        if name == "predict":
            dt = given.get("dt", 0.0)
            self._clock += dt if isinstance(dt, float) else float(np.ravel(dt)[0])
        self._last = state
        self._steps.append((name, self._clock, self._piece, state, given))
        self._count += 1
        self._loaded = None

    def _came(self, step: Step | None) -> None:
        """A step of a live loop."""
        if step is None:
            self._piece += 1
            return
        if len(self._steps) == CHUNK_STEPS:
            self._close()
        self._steps.append((1e-6 * step.at_us, self._piece, step))
        self._count += 1
        self._loaded = None

    def _known_better(self, place: Place) -> None:
        """The navigation of the last step of a live loop, in place of the one that it came with."""
        if self._steps:
            time, piece, step = self._steps[-1]
            self._steps[-1] = time, piece, step._replace(place=place)

    def _now(self) -> tuple[dict[str, Array] | None, tuple[int, ...], Array]:
        """x, P and nav, where they do not lie among the numbers of the C; the runs; and these numbers, a view."""
        memory: Any = getattr(self.loop, "memory", None)
        if memory is not None and memory.settled and not memory.lent and self._in_C:
            return None, memory.runs, memory.blocks.numbers[:, : memory.part["P"].stop]
        return *self._state(), self._raw[0] if len(self._raw) else np.empty((0, 0, 0))

    def _begin(self) -> None:
        self._piece += 1
        self._add("begin", {})

    def _state(self) -> tuple[dict[str, Array], tuple[int, ...]]:
        """x, P and nav as they are now, and the runs."""
        loop = self.loop
        assert loop is not None
        read: Any = loop.memory.read if isinstance(loop, CompiledFilter) else partial(getattr, loop)
        x, P, nav = read("x"), read("P"), {n: np.array(v) for n, v in self._nav()}
        by_run = (v.shape[: v.ndim - axes_of(self.model, n)] for n, v in nav.items())
        return {"x": x.copy(), "P": P.copy(), **nav}, np.broadcast_shapes(x.shape[:-1], P.shape[:-2], *by_run)

    def _look(self) -> None:
        """Begin a new piece where x or P is no longer what the last step left."""
        loop = self.loop
        assert loop is not None
        if len(loop.nav) != len(self._layout[1]):
            raise BoresightError("nav has other fields than when its record began; give them all before, or stop()")
        if isinstance(loop, CompiledFilter):
            if loop.memory.lent.isdisjoint(("x", "P")):
                return
            there = {n: loop.memory.copies[n] for n in ("x", "P") if n in loop.memory.lent}
        else:
            there = {"x": loop.x, "P": loop.P}
        changed = {n for n, value in there.items() if not same(value, self._was(n))}
        if changed == {"x"} and not self.total:
            taken = self._was("x") - there["x"]
            self._add("feedback", {"taken": taken})
        elif changed:
            self._begin()

    def _was(self, name: str) -> Array:
        if self._last is not None:
            return self._last[name]
        loop = self.loop
        assert isinstance(loop, CompiledFilter)
        memory = loop.memory  # in which stands what the last step left
        numbers = memory.blocks.read(memory.part[name]).reshape(*memory.runs, -1)
        return numbers if name == "x" else numbers[..., packed(len(memory.library.states))[1]]

    def _close(self) -> None:
        """Put the steps that came beside those before: as they are, or as arrays into a file."""
        if not self._steps:
            return
        came = self._steps, self._raw[: len(self._steps)], self._count - len(self._steps), self._runs
        self._steps, self._raw = [], np.empty((0, 0, 0, 0))
        if self.folder is None:
            self._chunks.append(came)
        else:
            path = self.folder / f"steps-{len(self._chunks):06d}.parquet"
            write_chunk(path, self._chunk(*came), self.total, self.states)
            self._chunks.append(path)

    def _chunk(self, steps: list[Any], raw: Array, first: int, runs: tuple[int, ...]) -> Chunk:
        """The arrays of steps as they came."""
        if self._live is not None:
            time, piece, came = zip(*steps, strict=True)
            given: Sequence[dict[str, Any]]
            names, (x, P, nav, given) = tuple(step.name for step in came), self._live.arrays(came)
        else:
            names, time, piece, states, given = zip(*steps, strict=True)
            x, P, nav = self._stacked(states, raw, runs)
        alike: dict[Any, list[int]] = {}
        for i, (name, words) in enumerate(zip(names, given, strict=True)):
            shapes = tuple((n, np.shape(v), float(v) if n in LINEARISING else None) for n, v in words.items())
            alike.setdefault((name, shapes), []).append(i)
        tables = [
            Table(key[0], first + np.array(where), {n: np.array([given[i][n] for i in where]) for n, *_ in key[1]})
            for key, where in alike.items()
        ]
        return Chunk(list(names), np.array(time), np.array(piece), x, P, nav, tables)

    def _stacked(
        self, states: tuple[Any, ...], raw: Array, runs: tuple[int, ...]
    ) -> tuple[Array, Array, dict[str, Array]]:
        """x (K, ..., n), the triangle of P, and nav, of dicts of `_state`, or of numbers as they lie in the C."""
        n, nav, part = self._layout
        upper = packed(n)[0]
        out = {"x": np.empty((len(states), *runs, n)), "P": np.empty((len(states), *runs, n * (n + 1) // 2))}
        for name, value in nav.items():
            out[name] = np.empty((len(states), *runs, *np.shape(value)[np.ndim(value) - axes_of(self.model, name) :]))
        there = [i for i, state in enumerate(states) if state is None]
        if there:
            numbers = runs_of(raw[there], runs)
            for name, array in out.items():
                array[there] = numbers[..., part[name] if array.ndim == numbers.ndim else part[name].start]
        for i, state in enumerate(states):
            for name, array in () if state is None else out.items():
                array[i] = state["P"][(..., *upper)] if name == "P" else state[name]
        return out.pop("x"), out.pop("P"), out

    # ------------------------------------------------------------ what was recorded

    def _all(self) -> Chunk:
        """Every step, of all runs."""
        if self._loaded is None:
            self._close()
            if not self._chunks:
                raise BoresightError("nothing has been recorded yet; begin the loop, and give it samples")
            for i, one in enumerate(self._chunks):
                self._chunks[i] = self._chunk(*one) if isinstance(one, tuple) else one
            chunks = [read_chunk(c, self.states)[0] if isinstance(c, Path) else c for c in self._chunks]
            runs = np.broadcast_shapes(*(c.x.shape[1:-1] for c in chunks))

            def joined(parts: list[Array], axes: int) -> Array:
                return np.concatenate([
                    np.broadcast_to(
                        p.reshape(len(p), *(1,) * (len(runs) + 1 + axes - p.ndim), *p.shape[1:]),
                        (len(p), *runs, *p.shape[p.ndim - axes :]),
                    )
                    for p in parts
                ])  # fmt: skip

            first, nav = chunks[0], {}
            for name in first.nav:
                axes = first.nav[name].ndim - first.x.ndim + 1
                nav[name] = joined([c.nav[name] for c in chunks], axes)
            self._loaded = Chunk(
                [name for c in chunks for name in c.names],
                np.concatenate([c.time for c in chunks]), np.concatenate([c.piece for c in chunks]),
                joined([c.x for c in chunks], 1), joined([c.P for c in chunks], 1), nav,
                [table for c in chunks for table in c.tables],
            )  # fmt: skip
        return self._loaded

    @property
    def names(self) -> Array:
        return np.array(self._all().names)

    @property
    def time(self) -> Array:
        return self._all().time

    @property
    def piece(self) -> Array:
        return self._all().piece

    @property
    def x(self) -> Array:
        return self._all().x

    @property
    def P(self) -> Array:
        return self.covariance(slice(None))

    @property
    def nav(self) -> dict[str, Array]:
        return self._all().nav

    def covariance(self, rows: Any) -> Array:
        """P after some steps.

        Parameters
        ----------
        rows : index of steps

        Returns
        -------
        (..., n, n) array
        """
        return self._all().P[rows][..., packed(self.x.shape[-1])[1]]

    def rows(self, name: str) -> Array:
        """The places of the steps of a name.

        Parameters
        ----------
        name : str
            As in `names`.

        Returns
        -------
        (K,) array of int
        """
        return np.flatnonzero(self.names == name)

    def tables(self, name: str) -> list[Table]:
        """The steps of a name with what each was given.

        Parameters
        ----------
        name : str
            As in `names`.

        Returns
        -------
        list of Table
            Those together that were given the same things: `rows`, and `given` by name.
        """
        return [table for table in self._all().tables if table.name == name]

    def Phi(self) -> Array:
        """The transition of each prediction, as it was flown.

        Returns
        -------
        (K, ..., n, n) array
            K: `rows("predict")`.
        """
        return self._computed("Phi")

    def Q(self) -> Array:
        """What each prediction added to P.

        Returns
        -------
        (K, ..., n, n) array
            K: `rows("predict")`.
        """
        return self._computed("Q")

    def _computed(self, function: str) -> Array:
        rows, n = self.rows("predict"), self.x.shape[-1]
        out = np.empty((len(rows), *self.x.shape[1:], n))
        unit = getattr(self.model, function)
        for table in self.tables("predict"):
            where = np.searchsorted(rows, table.rows)
            if function in table.given:  # of a live loop
                out[where] = table.given[function]
                continue
            known = self._known(table.rows, table.given)
            if hasattr(self.model, "field"):
                out[where] = unit(**{name: known[name] for name in unit.fields})
            else:
                for k, row in enumerate(where):
                    out[row] = unit(**{name: known[name][k] for name in unit.fields})
        return out

    def _known(self, rows: Array, given: dict[str, Array]) -> dict[str, Array]:
        """Nav, x before the step, and what it was given, (K, ..., size) with the axes of the runs."""
        all_ = self._all()
        nav = {name: value[rows] for name, value in all_.nav.items()}
        return {**nav, "x": all_.x[rows - 1], **{name: spread(self, name, value) for name, value in given.items()}}

    def innovation(self, name: str) -> Innovation:
        """All innovations of a measurement, with the verdict on each row.

        Parameters
        ----------
        name : str
            Of the measurement.

        Returns
        -------
        Innovation
            Of (K, ..., m) arrays; K: `rows(name)`.

        Raises
        ------
        BoresightError
            A measurement that was not taken.
        """
        return Innovation(*(self._found(name, part, part in ("used", "inflated")) for part in FOUND))

    def _found(self, name: str, part: str, true: bool) -> Array:
        rows, tables = self.rows(name), self._taken(name)
        axes = 0 if part == "nis" else 1
        shape = (*self.x.shape[1:-1], *tables[0].given["nu"].shape[-axes:][:axes])
        out = np.empty((len(rows), *shape), bool if true else float)
        for table in tables:
            out[np.searchsorted(rows, table.rows)] = spread(self, "", table.given[part], axes)
        return out

    def _taken(self, name: str) -> list[Table]:
        tables = [table for table in self.tables(name) if "nu" in table.given]
        if not tables:
            there = sorted({t.name for t in self._all().tables if "nu" in t.given})
            raise BoresightError(f"no measurement {name!r} was recorded; there are {', '.join(there) or 'none'}")
        return tables

    def jacobian(self, name: str) -> Array:
        """H of each update of a measurement, at its last linearisation; of correlated rows, of L^-1 z.

        Of a live loop at its first one.

        Parameters
        ----------
        name : str
            Of the measurement.

        Returns
        -------
        (K, ..., m, n) array
        """
        rows, out = self.rows(name), None
        for table in self._taken(name):
            H = self._linearised(table)
            out = np.empty((len(rows), *H.shape[1:])) if out is None else out
            out[np.searchsorted(rows, table.rows)] = H
        assert out is not None
        return out

    def gain(self, name: str) -> Array:
        """The gain of each update of a measurement: x rose by K nu, row after row.

        Parameters
        ----------
        name : str
            Of the measurement.

        Returns
        -------
        (K, ..., n, m) array
            Zero in the column of a row that was not used, and in the row of a considered state.

        Raises
        ------
        BoresightError
            Of a live loop, which takes a part of the gain back and does not keep it.
        """
        if any("H" in table.given for table in self._taken(name)):
            raise BoresightError(
                "gain: a live loop takes a part of the gain back where errors of H alone may have made it, and does "
                "not keep that part; x of the row, innovation() and jacobian() are what it did"
            )
        found, H, rows = self.innovation(name), self.jacobian(name), self.rows(name)
        P, out = self.covariance(rows - 1), np.zeros(np.swapaxes(H, -1, -2).shape)
        for i in range(H.shape[-2]):
            h = H[..., i, :]
            Ph = np.einsum("...ij,...j->...i", P, h)
            S = found.S[..., i, None]
            gain = np.where(found.used[..., i, None], Ph / S, 0.0)
            R = S - np.sum(h * Ph, axis=-1, keepdims=True)
            P = P - gain[..., :, None] * Ph[..., None, :]
            b = np.einsum("...ij,...j->...i", P, h) - R * gain
            P = P - b[..., :, None] * gain[..., None, :]
            out[..., i] = gain
        for table in self._taken(name):
            if "considered" in table.given:
                kept = spread(self, "", table.given["considered"], 1) > 0
                where = np.searchsorted(rows, table.rows)
                out[where] = np.where(kept[..., None], 0.0, out[where])
        return out

    def _linearised(self, table: Table) -> Array:
        """H of the updates of a table: they are made once more, together, with the rows that were used."""
        if "H" in table.given:  # of a live loop
            return table.given["H"]
        given = dict(table.given)
        found = {part: given.pop(part) for part in FOUND}
        options = {name: given.pop(name)[0] for name in OPTIONS if name in given}
        taking = {name: given.pop(name) for name in TAKING if name in given}
        inputs = {name: spread(self, name, value, 1 if name == "z" else None) for name, value in given.items()}
        m = found["nu"].shape[-1]
        R = taking["R"]
        R = R.reshape(len(R), *R.shape[1:]) if R.ndim > 1 else R[:, None]
        axes = 2 if self._covariance(table.name, R, m) else 1
        again = Again(self, table.rows)
        known: dict[str, Any] = dict(inputs)
        if "jacobian" in taking:
            known["jacobian"] = spread(self, "", taking["jacobian"], 2)
        if "iterations" in options:
            known["iterations"] = int(options["iterations"])
        again.update(
            table.name,
            spread(self, "", R, axes),
            rows=spread(self, "", found["used"], 1) > 0,
            relinearize=bool(options.get("relinearize", 0)),
            **known,
        )
        after = self._all().x[table.rows]
        misses = np.array([np.abs(again.wrapped(x - after)).max(-1) for x, _ in again.linearised])
        H = np.array([np.broadcast_to(H, (*after.shape[:-1], m, after.shape[-1])) for _, H in again.linearised])
        return np.take_along_axis(H, misses.argmin(0)[None, ..., None, None], 0)[0]

    def _covariance(self, name: str, R: Array, m: int) -> bool:
        """Whether R (K, ..., m) or (K, ..., m, m) is a covariance, as `Filter.update` judges it."""
        correlated = getattr(self.model, "measurements", {}).get(name, {}).get("correlated")
        runs = self.x.shape[1:-1]
        one = R.shape[1:]
        return one[-2:] == (m, m) and bool(correlated or (m > 1 and one[:-1] != runs[1 - len(one) :]))

    def taken(self) -> Array:
        """What each feedback took out of the error state.

        Returns
        -------
        (K, ..., n) array
            K: `rows("feedback")`.
        """
        rows = self.rows("feedback")
        return self.x[rows - 1] - self.x[rows]


def recorded(loop: Any) -> bool:
    """Whether a filter is recorded by now.  Raises BoresightError where it is none."""
    if not isinstance(loop, (Filter, Live)):
        raise BoresightError(f"a {type(loop).__name__} cannot be recorded; give a Filter, a CompiledFilter or a Live")
    return isinstance(loop, Recorded) or getattr(loop, "recorder", None) is not None


def axes_of(model: Any, name: str) -> int:
    """How many axes of a field are none of runs."""
    field = getattr(model, "field", {}).get(name)
    return 1 if field is None or field["size"] > 1 else 0


def spread(record: Record, name: str, value: Array, axes: int | None = None) -> Array:
    """A thing that was given, (K, ..., size), with the axes of the runs that it lacks.  axes: those of one run."""
    lacking = record.x.ndim - 1 - (value.ndim - (axes_of(record.model, name) if axes is None else axes))
    return value.reshape(len(value), *(1,) * max(lacking, 0), *value.shape[1:])


class Again(Filter):
    """The filter as it was before some updates of a record, all of them side by side."""

    def __init__(self, record: Record, rows: Array):
        self.model, self.total, self._ceiling = record.model, record.total, None
        self.nav = {name: value[rows] for name, value in record.nav.items()}
        self.x, self.P = record.x[rows - 1], record.covariance(rows - 1)
        self.linearised: list[tuple[Array, Array]] = []

    def _rows(
        self, z: Array, H: Array, R: Array, rows: Array, gate: Any, kept: Any, inflate: bool = False, linear: Any = None
    ) -> Any:
        row_by_row = [H]

        def noted(x: Array) -> tuple[Array, Array]:
            z, H = linear(x)
            row_by_row.append(H)
            return z, H

        found = super()._rows(z, H, R, rows, gate, kept, inflate, None if linear is None else noted)
        if linear is not None:
            H = np.stack([each[..., i, :] for i, each in enumerate(row_by_row)], axis=-2)
        self.linearised.append((found[0], H))
        return found


def same(one: Array, other: Array) -> bool:
    """Whether two arrays are equal, of one shape: `array_equal` takes twice as long."""
    return one.shape == other.shape and bool((one == other).all())


def runs_of(numbers: Array, runs: tuple[int, ...]) -> Array:
    """(K, *runs, numbers) of blocks as `Blocks` has them, (K, blocks, numbers, width)."""
    count, blocks, size, width = numbers.shape
    n = int(np.prod(runs, dtype=int))
    return numbers.transpose(0, 1, 3, 2).reshape(count, blocks * width, size)[:, :n].reshape(count, *runs, size)


def write_chunk(path: Path, chunk: Chunk, total: bool, states: tuple[str, ...]) -> None:
    """A Parquet file of a row per step; what a step has not is null there."""
    import pyarrow
    import pyarrow.parquet as parquet

    count = len(chunk.names)
    columns = {"step": pyarrow.array(chunk.names), "time_s": chunk.time, "piece": chunk.piece}

    def lists(values: Array, rows: Array) -> Any:
        flat, there = values.reshape(len(rows), -1), np.zeros(count, bool)
        there[rows] = True
        ends = np.concatenate([[0], np.cumsum(there * flat.shape[1])]).astype(np.int32)
        offsets = pyarrow.array(ends, mask=np.append(~there, False))
        return pyarrow.ListArray.from_arrays(offsets, pyarrow.array(flat.ravel().astype(float)))

    every = np.arange(count)
    columns |= {"x": lists(chunk.x, every), "P": lists(chunk.P, every)}
    columns |= {f"nav {name}": lists(value, every) for name, value in chunk.nav.items()}
    first = min(int(table.rows.min()) for table in chunk.tables)
    described: dict[str, Any] = {"total": total, "states": states, "runs": chunk.x.shape[1:-1], "tables": []}
    described["nav"] = {name: value.shape[1:] for name, value in chunk.nav.items()}
    for i, table in enumerate(chunk.tables):
        columns |= {f"{i} {name}": lists(value, table.rows - first) for name, value in table.given.items()}
        shapes = {name: value.shape[1:] for name, value in table.given.items()}
        described["tables"].append({"name": table.name, "rows": table.rows.tolist(), "shapes": shapes})
    written = pyarrow.table(columns, metadata={b"record": json.dumps(described).encode()})
    try:
        parquet.write_table(written, path, use_dictionary=False)
    except OSError as error:
        raise BoresightError(f"{path} cannot be written ({error.strerror})") from None


def read_chunk(path: Path, states: tuple[str, ...]) -> tuple[Chunk, bool]:
    """What `write_chunk` wrote, and whether the state is total."""
    import pyarrow
    import pyarrow.parquet as parquet

    try:
        table = parquet.read_table(path)
        described = json.loads(table.schema.metadata[b"record"])
    except (OSError, LookupError, TypeError, ValueError, pyarrow.ArrowException) as error:
        raise BoresightError(f"{path} cannot be read ({str(error).partition(chr(10))[0][:80]})") from None
    runs, n = described["runs"], len(states)

    def values(name: str, shape: Any, count: int) -> Array:
        column = table[name].combine_chunks()
        return column.flatten().to_numpy(zero_copy_only=False).reshape(count, *shape)

    count = len(table)
    size = len(table["x"][0]) // int(np.prod(runs, dtype=int))
    if n and size != n:
        raise BoresightError(f"{path} is of a filter of {size} states, and this model has {n}")
    if n and (names := tuple(described.get("states", states))) != states:
        raise BoresightError(f"{path} is of a filter with the states {', '.join(names)}, and this model has others")
    tables = []
    for i, t in enumerate(described["tables"]):
        given = {name: values(f"{i} {name}", shape, len(t["rows"])) for name, shape in t["shapes"].items()}
        tables.append(Table(t["name"], np.array(t["rows"]), given))
    chunk = Chunk(
        table["step"].to_pylist(), table["time_s"].to_numpy(), table["piece"].to_numpy(),
        values("x", (*runs, size), count), values("P", (*runs, size * (size + 1) // 2), count),
        {name: values(f"nav {name}", shape, count) for name, shape in described["nav"].items()}, tables,
    )  # fmt: skip
    return chunk, described["total"]
