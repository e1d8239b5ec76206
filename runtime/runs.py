"""One experiment flown very often: in chunks, in processes or on a cluster, kept as it comes, until enough is known.

    found = many(EXPERIMENT, runs=1_000_000, seed=1, jobs=2, directory="out")

What comes out depends on the experiment and its seed alone: not on the chunks, the processes, the machines or on how
often the work was stopped.  A run draws its numbers by [seed, run]; sums are taken in a tree over the run numbers;
whether enough is known is asked after fixed counts of runs.
"""

import hashlib
import inspect
import json
import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, Executor, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, dataclass, field
from functools import lru_cache
from pathlib import Path
from time import monotonic
from typing import Any

import numpy as np

from boresight import BoresightError, did_you_mean, need
from boresight.runtime.array import Array
from boresight.runtime.library import Library, load
from boresight.runtime.manifest import folder_of, read_manifest

BLOCK = 1024  # runs of a file; a power of two, so that each is a node of the tree of sums
GROWTH = 1.25  # from one count of runs, at which it is asked whether enough is known, to the next
KEPT_S = 30.0  # what is flown waits no longer to be written
SURE = 1.959963984540054  # sigmas to either side of a 95 % interval
PERCENTILES = (50.0, 95.0, 99.0)

Progress = Callable[[int, int, str], None]  # runs that are done, runs in all as far as is known, and what is found


@dataclass(frozen=True)
class Experiment:
    """What is flown.

    fly: a function of a module, fly(library, settings, seed, runs), of `settings`, a dataclass or a dictionary that
    JSON can hold, and of run numbers, a range: final states (len(runs), columns), a row of NaN for a run that is lost.
    A row may depend on the settings, the seed and its run's number, and on nothing else.
    model: name or generated folder of the model, as of `load`.  columns: the unit of each column.
    expected: mean of a column, where the filter is consistent.  percentiles: columns of which they are told.
    """

    name: str
    model: str | Path
    columns: Mapping[str, str]
    fly: Callable[[Library, Any, int, range], Array]
    settings: Any = field(default_factory=dict)
    expected: Mapping[str, float] = field(default_factory=dict)
    percentiles: tuple[str, ...] = ()


@dataclass(frozen=True)
class Goal:
    """Enough is known when the 95 % interval of this percentile reaches no further than `within` to either side."""

    column: str
    within: float  # in the column's unit
    percentile: float = 95.0


@dataclass(frozen=True)
class Outcome:
    """What many runs say.

    columns: NAME -> unit, mean, its 95 % interval, sd, least, largest, and expected where the experiment says so; all
    None if every run is lost.  percentiles: NAME -> percentile -> value and its 95 % interval, (3,).
    reached: whether the goal was, None without one.  digest: SHA-256 of all final states and of these numbers.
    values: (runs, columns), where no directory keeps them.
    """

    experiment: str
    seed: int
    runs: int
    lost: int
    columns: dict[str, dict[str, Any]]
    percentiles: dict[str, dict[str, list[float | None]]]
    reached: bool | None
    digest: str
    values: Array | None = field(default=None, repr=False, compare=False)

    def document(self) -> dict[str, Any]:
        """For JSON."""
        return {name: value for name, value in vars(self).items() if name != "values"}


def many(
    experiment: Experiment,
    *,
    runs: int,
    seed: int = 0,
    chunk: int = 64,
    jobs: int = 1,
    dask: str | None = None,
    directory: str | Path | None = None,
    goal: Goal | None = None,
    progress: Progress = lambda done, total, text: None,
) -> Outcome:
    """Fly runs 0 to `runs` - 1, or as many of them as the goal asks for.

    chunk: runs of one call of `experiment.fly`.  jobs: processes.  dask: address of a cluster's scheduler, whose
    workers then fly.  directory: keeps final states as Parquet, a file for each BLOCK of runs; those that it holds
    already are not flown again.
    Raises BoresightError on what has no meaning, and on a directory of another experiment, seed or model.  On Ctrl-C
    what is in flight is finished and kept before KeyboardInterrupt is raised; a second Ctrl-C ends at once.
    """
    for name, value, low in (("runs", runs, 1), ("chunk", chunk, 1), ("jobs", jobs, 1), ("seed", seed, 0)):
        if isinstance(value, bool) or not isinstance(value, int | np.integer) or not low <= value < 2**63:
            raise BoresightError(f"many: {name} is {value!r}; it must be a whole number from {low} to 2^63")
    watched = _watched(experiment, goal)
    folder = folder_of(experiment.model)
    store = Store(directory, list(experiment.columns), _identity(experiment, read_manifest(folder), seed))
    known, reached = _Known(store, watched, experiment), None
    with ExitStack() as stack:
        asked = stack.enter_context(_interruptible())
        executor: Executor | None = None
        where, window = str(folder.resolve()), 2 * jobs + 1
        for count in _counts(runs, goal):
            pieces = list(store.missing(count, chunk))
            if pieces and executor is None:  # only where there is something to fly
                if dask is not None:
                    from boresight.runtime.cluster import connected

                    executor, where, window = stack.enter_context(connected(dask, folder))
                elif jobs > 1:
                    executor = stack.enter_context(_processes(jobs))
            flown = _flown(pieces, executor, window, asked, (experiment, where, seed))
            try:
                for piece, rows in flown:
                    store.take(piece, rows)
                    progress(store.held, max(count, min(runs, known.needed)) if goal else runs, known.text)
            finally:
                store.keep()
            if asked:
                raise KeyboardInterrupt(f"{store.held} runs are flown" + f" and kept in {directory}" * bool(directory))
            known.read(count)
            if goal is not None:
                reached = known.reaches(goal)
                if reached:
                    break
    return known.outcome(seed, reached)


# ---- which runs


def _counts(runs: int, goal: Goal | None) -> Iterator[int]:
    """Counts of runs up to which is flown before it is asked whether enough is known: the same in every call."""
    count = BLOCK
    while goal is not None and count < runs:
        yield count
        count = BLOCK * int(np.ceil(GROWTH * count / BLOCK))
    yield runs


def _watched(experiment: Experiment, goal: Goal | None) -> tuple[str, ...]:
    """The columns of which percentiles are told; raises BoresightError on a name that is no column."""
    asked = dict.fromkeys((*experiment.percentiles, *([goal.column] if goal else [])))
    for name in (*asked, *experiment.expected):
        if name not in experiment.columns:
            close = did_you_mean(name, experiment.columns)
            raise BoresightError(f"{experiment.name} has no column {name!r}{close}")
    if goal is not None and not (0 < goal.percentile < 100 and 0 < goal.within < np.inf):
        raise BoresightError(
            f"many: a goal has a percentile within 0 to 100 and a width above 0; got {goal.percentile:g} and "
            f"{goal.within:g}"
        )
    return tuple(asked)


def _identity(experiment: Experiment, manifest: Mapping[str, Any], seed: int) -> dict[str, Any]:
    """All that the final states depend on, as JSON gives it back."""
    settings, fly = experiment.settings, experiment.fly
    try:
        # of a script only the function: its last lines are changed from call to call
        code = inspect.getsource(fly if fly.__module__ == "__main__" else sys.modules[fly.__module__])
    except (OSError, TypeError):  # typed at a prompt
        code = ""
    contents = json.dumps(manifest["files"], sort_keys=True)
    identity = {
        "experiment": experiment.name,
        "settings": settings if isinstance(settings, dict) else asdict(settings),
        "seed": int(seed),
        "model": hashlib.sha256(contents.encode()).hexdigest(),
        "code": hashlib.sha256(code.encode()).hexdigest(),
        "columns": dict(experiment.columns),
        "block": BLOCK,
    }
    try:
        return dict(json.loads(json.dumps(identity, allow_nan=False)))
    except (TypeError, ValueError) as error:
        raise BoresightError(f"{experiment.name}: its settings cannot be written as JSON ({error})") from None


# ---- flying


def _flown(
    pieces: Iterable[range],
    executor: Executor | None,
    window: int,
    asked: list[bool],
    task: tuple[Experiment, str, int],
) -> Iterator[tuple[range, Array]]:
    """Pieces and their final states as they come.  Once `asked` is not empty nothing more is begun."""
    if executor is None:
        for piece in pieces:
            if asked:
                return
            yield piece, fly_piece(*task, piece)
        return
    flying: dict[Any, range] = {}
    waiting = iter(pieces)
    while True:
        while len(flying) < window and not asked and (begun := next(waiting, None)) is not None:
            flying[executor.submit(fly_piece, *task, begun)] = begun
        if not flying:
            return
        for done in wait(flying, return_when=FIRST_COMPLETED).done:
            piece = flying.pop(done)
            try:
                rows = done.result()
            except BrokenProcessPool:
                raise BoresightError(
                    "many: a process was killed, perhaps for want of memory; the same command goes on"
                ) from None
            yield piece, rows


def fly_piece(experiment: Experiment, where: str, seed: int, piece: range) -> Array:
    """Final states (len(piece), columns) of a few runs.  where: the folder of the model, or its hash on a cluster."""
    rows = np.asarray(experiment.fly(_library(where), experiment.settings, seed, piece), float)
    shape = len(piece), len(experiment.columns)
    if rows.shape != shape:
        raise BoresightError(f"{experiment.name}: fly gave an array of shape {rows.shape} in place of {shape}")
    lost = ~np.isfinite(rows).all(-1)
    rows[lost] = np.nan
    return rows


@lru_cache(maxsize=4)
def _library(where: str) -> Library:
    if os.sep in where:
        return load(Path(where))
    from boresight.runtime.cluster import unpacked

    return load(unpacked(where))


@contextmanager
def _processes(jobs: int) -> Iterator[Executor]:
    context = multiprocessing.get_context("fork")
    with ProcessPoolExecutor(jobs, context, initializer=_serve) as executor:
        yield executor


def _serve() -> None:
    """A process of the pool: Ctrl-C is the parent's to hear, and it does not outlive its parent."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()

    def end() -> None:
        if parent is not None:
            parent.join()
            os._exit(1)

    threading.Thread(target=end, daemon=True).start()


@contextmanager
def _interruptible() -> Iterator[list[bool]]:
    """A list that the first Ctrl-C fills; the second acts as ever."""
    asked: list[bool] = []
    if threading.current_thread() is not threading.main_thread():
        yield asked
        return
    before = signal.getsignal(signal.SIGINT)

    def note(number: int, frame: Any) -> None:
        asked.append(True)
        signal.signal(signal.SIGINT, before)

    signal.signal(signal.SIGINT, note)
    try:
        yield asked
    finally:
        signal.signal(signal.SIGINT, before)


# ---- what is kept


class Store:
    """Final states by block: in files of a directory, or in memory without one.

    A file is written aside and put in its place whole.  `held` counts the runs that are there.
    """

    def __init__(self, directory: str | Path | None, columns: list[str], identity: dict[str, Any]):
        self.columns = columns
        self.folder = None if directory is None else Path(directory)
        self.tables: dict[int, tuple[Array, Array]] = {}  # of a block the rows, and (BLOCK,) bool which are there
        self.whole: set[int] = set()  # blocks that are on the disk
        self.unwritten: set[int] = set()
        self.written = monotonic()
        self.held = 0
        if self.folder is None:
            return
        need("parquet")
        try:
            (self.folder / "runs").mkdir(parents=True, exist_ok=True)
            self._claim(self.folder, identity)
            for path in (self.folder / "runs").glob("block-*.parquet"):
                self._found(path)
        except OSError as error:
            raise BoresightError(f"cannot write to {self.folder} ({error.strerror}); choose another folder") from None

    def _claim(self, folder: Path, identity: dict[str, Any]) -> None:
        """The directory is this experiment's from now on; raises BoresightError where it is another's."""
        path = folder / "experiment.json"
        if not path.exists():
            if any((folder / "runs").iterdir()):
                raise BoresightError(f"{folder} holds runs and no experiment.json; choose another folder")
            _replace(path, (json.dumps(identity, indent=2) + "\n").encode())
            return
        try:
            there = json.loads(path.read_text())
        except ValueError:
            raise BoresightError(f"{path} cannot be read; choose another folder") from None
        differing = [name for name, value in identity.items() if there.get(name) != value]
        if not differing:
            return
        name = differing[0]
        ours, theirs = identity[name], there.get(name)
        if isinstance(ours, dict) and isinstance(theirs, dict):
            inner = next(key for key in {**ours, **theirs} if ours.get(key) != theirs.get(key))
            name, ours, theirs = f"{name}, {inner}", ours.get(inner), theirs.get(inner)
        said = f": {theirs!s:.40} there, {ours!s:.40} here"
        raise BoresightError(f"{folder} holds runs of another {name}{said}; choose another folder")

    def _found(self, path: Path) -> None:
        block = int(path.stem.removeprefix("block-"))
        rows, there = self._read(path, block)
        self.held += int(there.sum())
        if there.all():
            self.whole.add(block)
        else:
            self.tables[block] = rows, there

    def _read(self, path: Path, block: int) -> tuple[Array, Array]:
        import pyarrow
        import pyarrow.parquet as parquet

        rows, there = np.full((BLOCK, len(self.columns)), np.nan), np.zeros(BLOCK, bool)
        try:
            table = parquet.read_table(path, partitioning=None)
            number = table["run"].to_numpy() - block * BLOCK
            values = np.stack([table[name].to_numpy() for name in self.columns], axis=-1)
            rows[number], there[number] = values, True
        except (pyarrow.ArrowException, KeyError, IndexError) as error:
            reason = str(error).splitlines()[0][:80]
            raise BoresightError(f"{path} cannot be read ({reason}); delete it, and its runs are flown again") from None
        return rows, there

    def _path(self, block: int) -> Path:
        assert self.folder is not None
        return self.folder / "runs" / f"block-{block:06d}.parquet"

    def block(self, block: int) -> tuple[Array, Array]:
        """Rows (BLOCK, columns) and which of them are there, (BLOCK,) bool."""
        if block in self.tables:
            return self.tables[block]
        if block in self.whole:
            return self._read(self._path(block), block)
        return np.full((BLOCK, len(self.columns)), np.nan), np.zeros(BLOCK, bool)

    def missing(self, count: int, chunk: int) -> Iterator[range]:
        """Runs below `count` that are not there, in pieces of at most `chunk`, none across two blocks."""
        for block in range(-(-count // BLOCK)):
            if block in self.whole:
                continue
            first, there = block * BLOCK, self.block(block)[1]
            run, end = 0, min(BLOCK, count - first)
            while run < end:
                if there[run]:
                    run += 1
                    continue
                stop = run
                while stop < min(run + chunk, end) and not there[stop]:
                    stop += 1
                yield range(first + run, first + stop)
                run = stop

    def take(self, piece: range, rows: Array) -> None:
        """Final states of runs that were flown."""
        block = piece.start // BLOCK
        table, there = self.tables.setdefault(block, self.block(block))
        part = slice(piece.start % BLOCK, piece.start % BLOCK + len(piece))
        table[part], there[part] = rows, True
        self.held += len(piece)
        self.unwritten.add(block)
        if there.all() and self.folder is not None:
            self._write(block)
        elif monotonic() - self.written > KEPT_S:
            self.keep()

    def keep(self) -> None:
        """Write what is not written yet."""
        self.written = monotonic()
        for block in sorted(self.unwritten) if self.folder is not None else ():
            self._write(block)

    def _write(self, block: int) -> None:
        import pyarrow
        import pyarrow.parquet as parquet

        rows, there = self.tables[block]
        columns = {"run": block * BLOCK + np.flatnonzero(there)}
        columns |= {name: rows[there, i] for i, name in enumerate(self.columns)}
        sink = pyarrow.BufferOutputStream()
        parquet.write_table(pyarrow.table(columns), sink, compression="none", use_dictionary=False)
        try:
            _replace(self._path(block), sink.getvalue().to_pybytes())
        except OSError as error:
            raise BoresightError(f"{self._path(block)} cannot be written ({error.strerror})") from None
        self.unwritten.discard(block)
        if there.all():
            self.whole.add(block)
            del self.tables[block]


def _replace(path: Path, content: bytes) -> None:
    """The file has its content whole, or is as it was."""
    aside = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        with open(aside, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        os.replace(aside, path)
    finally:
        aside.unlink(missing_ok=True)


# ---- what is known


@dataclass(frozen=True)
class Moments:
    """Of lots of runs: how many (...,), and of each column (..., columns) mean, sum of squares about it, range."""

    n: Array
    mean: Array
    square: Array
    least: Array
    largest: Array

    @classmethod
    def of_runs(cls, rows: Array) -> "Moments":
        """Each run (R, columns) a lot of its own; those of a lost run count none."""
        there = np.isfinite(rows).all(-1)
        each = np.where(there[:, None], rows, 0.0)
        outside = [np.where(there[:, None], rows, bound) for bound in (np.inf, -np.inf)]
        return cls(there.astype(float), each, np.zeros_like(rows), *outside)

    def __getitem__(self, lots: slice) -> "Moments":
        return Moments(*(part[lots] for part in vars(self).values()))

    def and_then(self, other: "Moments") -> "Moments":
        """Two lots as one."""
        n = self.n + other.n
        part = np.where(n > 0, other.n / np.maximum(n, 1.0), 0.0)[..., None]
        apart = other.mean - self.mean
        both = (self.n * other.n / np.maximum(n, 1.0))[..., None]
        # of an empty lot the mean is that of the other
        mean = np.where(self.n[..., None] > 0, self.mean + apart * part, other.mean)
        square = self.square + other.square + apart * apart * both
        return Moments(
            n, mean, square, np.minimum(self.least, other.least), np.maximum(self.largest, other.largest)
        )  # fmt: skip

    def whole(self) -> "Moments":
        """All lots (R, ...) as one, (1, ...): neighbours first, a last one without a neighbour goes up as it is."""
        lots = self
        while len(lots.n) > 1:
            even = len(lots.n) // 2 * 2
            pairs = lots[0:even:2].and_then(lots[1:even:2])
            lots = pairs.together(lots[even:]) if even < len(lots.n) else pairs
        return lots

    def together(self, other: "Moments") -> "Moments":
        """The lots of both, one behind the other."""
        pairs = zip(vars(self).values(), vars(other).values(), strict=True)
        return Moments(*(np.concatenate(pair) for pair in pairs))


class _Known:
    """Summaries of the runs below a count, from a summary of each block."""

    def __init__(self, store: Store, watched: tuple[str, ...], experiment: Experiment):
        self.store, self.experiment, self.watched = store, experiment, watched
        self.moments: list[Moments] = []
        self.digests: list[bytes] = []
        self.values: dict[str, list[Array]] = {name: [] for name in watched}
        self.runs = 0
        self.needed = 0
        self.text = ""

    def read(self, count: int) -> None:
        """Take the runs up to `count` in; blocks that were whole are not read again."""
        for block in range(self.runs // BLOCK, -(-count // BLOCK)):
            rows = self.store.block(block)[0][: count - block * BLOCK]
            self.moments.append(Moments.of_runs(rows).whole())
            self.digests.append(hashlib.sha256(rows.astype("<f8").tobytes()).digest())
            for name, values in self.values.items():
                values.append(rows[:, self.store.columns.index(name)].copy())
        self.runs = count

    def percentile(self, name: str, percentile: float) -> list[float | None]:
        """The value and its 95 % interval, by order; a lost run counts as beyond every value, which is None."""
        values = np.concatenate(self.values[name])
        values = np.where(np.isnan(values), np.inf, values)
        n, p = len(values), percentile / 100
        spread = SURE * np.sqrt(n * p * (1 - p))
        ranks = [int(np.ceil(n * p)) - 1, int(np.floor(n * p - spread)) - 1, int(np.ceil(n * p + spread))]
        ranks = [min(max(rank, 0), n - 1) for rank in ranks]
        found = np.partition(values, ranks)[ranks]
        return [float(value) if np.isfinite(value) else None for value in found]

    def reaches(self, goal: Goal) -> bool:
        """Whether the interval is narrow enough; how many runs are needed, as it looks now."""
        value, low, high = self.percentile(goal.column, goal.percentile)
        if value is None or low is None or high is None:
            return False
        half = (high - low) / 2
        unit = self.experiment.columns[goal.column]
        self.text = f"{goal.percentile:g} % of {goal.column} {value:.4g} +- {half:.2g} {unit}, wanted {goal.within:.2g}"
        self.needed = int(self.runs * (half / goal.within) ** 2)
        return half <= goal.within

    def outcome(self, seed: int, reached: bool | None) -> Outcome:
        lots = self.moments[0]
        for one in self.moments[1:]:
            lots = lots.together(one)
        whole = lots.whole()
        n = int(whole.n[0])
        columns: dict[str, dict[str, Any]] = {}
        for i, (name, unit) in enumerate(self.experiment.columns.items()):
            mean, square, least, largest = (
                float(part[0, i]) for part in (whole.mean, whole.square, whole.least, whole.largest)
            )
            sd = float(np.sqrt(square / (n - 1))) if n > 1 else None
            half = None if sd is None else SURE * sd / np.sqrt(n)
            columns[name] = {
                "unit": unit,
                "mean": mean if n else None,
                "interval": None if half is None else [mean - half, mean + half],
                "sd": sd,
                "least": least if n else None,
                "largest": largest if n else None,
            }
            if name in self.experiment.expected:
                columns[name]["expected"] = float(self.experiment.expected[name])
        asked = {p: f"{p:g}" for p in PERCENTILES}
        percentiles = {
            name: {text: self.percentile(name, p) for p, text in asked.items()} for name in self.watched
        }  # fmt: skip
        summary: dict[str, Any] = {
            "runs": self.runs,
            "lost": self.runs - n,
            "columns": columns,
            "percentiles": percentiles,
        }
        digest = hashlib.sha256(b"".join(self.digests) + json.dumps(summary, sort_keys=True).encode()).hexdigest()
        values = None
        if self.store.folder is None:
            values = np.concatenate([self.store.block(block)[0] for block in range(len(self.digests))])[: self.runs]
        return Outcome(self.experiment.name, int(seed), **summary, reached=reached, digest=digest, values=values)


def report(found: Outcome) -> str:
    """A table in text: the percentiles, and the means that a consistent filter is known to have."""
    lines = [f"{found.experiment}: {found.runs} runs, seed {found.seed}" + f", {found.lost} lost" * bool(found.lost)]
    width = max(map(len, (*found.percentiles, *found.columns)))
    for name, one in found.percentiles.items():
        unit = found.columns[name]["unit"]
        for p, numbers in one.items():
            value, low, high = ("beyond" if number is None else f"{number:.4g}" for number in numbers)
            lines.append(f"  {name:{width}} {p:>3} %  {value:>9} {unit}  ({low} to {high})")
    for name, column in found.columns.items():
        if "expected" in column and column["interval"] is not None:
            low, high = column["interval"]
            lines.append(
                f"  {name:{width}}  mean  {column['mean']:9.4g} {column['unit']}  ({low:.4g} to {high:.4g}), "
                f"{column['expected']:g} of a consistent filter"
            )
    if found.reached is not None:
        lines.append("the goal is reached" if found.reached else "the goal is NOT reached; give it more runs")
    return "\n".join([*lines, f"SHA-256 {found.digest}"])
