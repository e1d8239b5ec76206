"""One experiment flown very often: in chunks, in processes or on a cluster, kept as it comes, until enough is known.

    found = many(EXPERIMENT, runs=1_000_000, seed=1, jobs=2, directory="out")

What comes out depends on the experiment and its seed alone: not on the chunks, the processes, or on how often the work
was stopped; nor on the machines, where the experiment's own arithmetic does not.  A run draws its numbers by [seed,
run]; sums are taken in a tree over the run numbers; whether enough is known is asked after fixed counts of runs.
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
from concurrent.futures import FIRST_COMPLETED, Executor, ProcessPoolExecutor, ThreadPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import ExitStack, contextmanager
from dataclasses import asdict
from functools import lru_cache
from itertools import chain, islice
from pathlib import Path
from typing import Any

import numpy as np

from boresight.errors import BoresightError, did_you_mean
from boresight.runtime.arguments import whole
from boresight.runtime.array import Array
from boresight.runtime.gpu import text
from boresight.runtime.library import Library, load
from boresight.runtime.manifest import folder_of, read_manifest
from boresight.runtime.store import BLOCK, Store
from boresight.runtime.summary import Experiment, Goal, Known, Outcome

__all__ = ["Experiment", "Goal", "Outcome", "many"]

DEVICES = {"cpu": 512, "gpu": 2**18}  # what flies, and runs of one call: an H100 flies some 33 000 at a time
GROWTH = 1.25  # from one count of runs, at which it is asked whether enough is known, to the next

Progress = Callable[[int, int, str], None]  # runs that are done, runs in all as far as is known, and what is found


def many(
    experiment: Experiment,
    *,
    runs: int,
    seed: int = 0,
    chunk: int | None = None,
    jobs: int = 1,
    dask: str | None = None,
    device: str = "cpu",
    directory: str | Path | None = None,
    goal: Goal | None = None,
    progress: Progress = lambda done, total, text: None,
) -> Outcome:
    """Fly runs 0 to `runs` - 1 of an experiment, or as many of them as the goal asks for.

    What comes out depends on the experiment and the seed alone: not on chunks, processes, processors
    or how often the work was stopped.

    Parameters
    ----------
    experiment : Experiment
        What is flown.
    runs : int
        How many at most.
    seed : int, optional
        A run draws its numbers by [seed, run].
    chunk : int, optional
        Runs of one call of `experiment.fly`, by default 512; on a GPU those that it is given at a
        time, by default 262 144.
    jobs : int, optional
        Processes on this machine.
    dask : str, optional
        Address of a Dask scheduler, whose workers then fly in the place of processes.
    device : str, optional
        "cpu", or "gpu" for the experiment's C with a thread for each run: the first GPU that the
        variable CUDA_VISIBLE_DEVICES leaves, on a cluster that of each worker.
    directory : str or Path, optional
        Keeps final states as Parquet, a file for each 1024 runs; those that it holds already are
        not flown a second time.
    goal : Goal, optional
        When enough is known.
    progress : function, optional
        Called with the runs that are done, those in all as far as is known, and what is found.

    Returns
    -------
    Outcome
        Moments of each column, percentiles with 95 % intervals, `reached`, and `digest`, a SHA-256
        of all of it; `report()` is a table in text.

    Raises
    ------
    BoresightError
        A number that has no meaning, jobs beside a cluster or a GPU, a column that is not there, a
        directory of another experiment, seed or model; no GPU, no driver, too little memory.
    KeyboardInterrupt
        After Ctrl-C, once what is in flight is finished and kept; a second Ctrl-C ends at once.

    Notes
    -----
    When not to use it: for some hundred runs; one `CompiledFilter` flies them side by side, and
    `Consistency` judges every epoch of them.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Experiment, many
    >>> def fly(library, settings, seed, runs):
    ...     drawn = [np.random.Generator(np.random.Philox(key=[seed, run])) for run in runs]
    ...     return np.array([[one.standard_normal()] for one in drawn])
    >>> walk = Experiment("walk", "euler-matching", {"error": "m"}, fly, percentiles=("error",))
    >>> found = many(walk, runs=100, seed=1)
    >>> found.runs, found.digest == many(walk, runs=100, seed=1, chunk=7).digest
    (100, True)
    """
    if device not in DEVICES:
        raise BoresightError(f"many: device is {device!r}; it is {' or '.join(DEVICES)}")
    chunk = DEVICES[device] if chunk is None else chunk
    for name, value, low in (("runs", runs, 1), ("chunk", chunk, 1), ("jobs", jobs, 1), ("seed", seed, 0)):
        if not whole(value) or not low <= value < 2**63:
            raise BoresightError(f"many: {name} is {value!r}; it must be a whole number from {low} to 2^63")
    if dask is not None and jobs != 1:
        raise BoresightError("many: jobs are processes here, and dask flies on a cluster; leave one of them out")
    if experiment.fly is None and (experiment.in_c is None or experiment.given is None):
        raise BoresightError(f"{experiment.name} has nothing that flies: give fly, or in_c with given")
    if device == "gpu":
        _on_a_gpu(experiment, jobs, here=dask is None)
    if directory == "":  # as a Path it would be the current folder
        raise BoresightError("many: directory is ''; give a folder, '.' for the current one")
    watched = _watched(experiment, goal)
    folder = folder_of(experiment.model)
    store = Store(directory, list(experiment.columns), _identity(experiment, read_manifest(folder), seed))
    known, reached = Known(store, watched, experiment), None
    with ExitStack() as stack:
        asked = stack.enter_context(_interruptible())
        executor: Executor | None = None
        where, window = str(folder.resolve()), 2 * jobs + 1
        for count in _counts(runs, goal):
            pieces = _together(store.missing(count, min(chunk, BLOCK)), chunk)
            first = list(islice(pieces, 1))
            if first and executor is None:  # only where there is something to fly
                if dask is not None:
                    from boresight.runtime.cluster import connected

                    executor, where, window = stack.enter_context(connected(dask, folder))
                elif device == "gpu":
                    executor, window = stack.enter_context(ThreadPoolExecutor(1)), 2
                elif jobs > 1:
                    executor = stack.enter_context(_processes(jobs))
            flown = _flown(chain(first, pieces), executor, window, asked, (experiment, where, seed, device))
            try:
                for piece, rows in flown:
                    for part in _apart(piece):
                        store.take(part, rows[part.start - piece.start : part.stop - piece.start])
                    while executor and known.runs + BLOCK <= count and store.has(known.runs // BLOCK):
                        known.read(known.runs + BLOCK)  # while others fly
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


def _together(pieces: Iterable[range], chunk: int) -> Iterator[range]:
    """Pieces that follow each other as one, of at most `chunk` runs."""
    held = range(0)
    for piece in pieces:
        if held and (held.stop != piece.start or len(held) + len(piece) > chunk):
            yield held
            held = range(0)
        held = range(held.start, piece.stop) if held else piece
    if held:
        yield held


def _apart(piece: range) -> Iterator[range]:
    """Its parts in each block."""
    while piece:
        end = min(piece.stop, (piece.start // BLOCK + 1) * BLOCK)
        yield range(piece.start, end)
        piece = range(end, piece.stop)


def _on_a_gpu(experiment: Experiment, jobs: int, here: bool) -> None:
    """Raise BoresightError where this experiment cannot fly there, before anything is begun."""
    if experiment.in_c is None or experiment.given is None:
        raise BoresightError(
            f"{experiment.name} is written in Python, which flies on the host; a GPU needs it in C, see 'in_c' of "
            "Experiment"
        )
    if jobs != 1:
        raise BoresightError("many: a GPU is given all runs by one process; leave jobs out")
    if here:
        from boresight.runtime.gpu.card import card

        card()


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
    settings, flies = experiment.settings, experiment.fly or experiment.given
    assert flies is not None  # `many` has looked
    try:
        # of a script only the function: its last lines are changed from call to call
        code = inspect.getsource(flies if flies.__module__ == "__main__" else sys.modules[flies.__module__])
    except (OSError, TypeError):  # typed at a prompt
        code = ""
    if experiment.in_c is not None:
        beside = (*text.HEADERS, _source(experiment).parent)
        code += "".join(file.read_text() for place in beside for file in sorted(place.glob("*.[ch]")))
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
    task: tuple[Experiment, str, int, str],
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
            with _whole():
                flying[executor.submit(fly_piece, *task, begun)] = begun
        if not flying:
            return
        for done in wait(flying, return_when=FIRST_COMPLETED).done:
            piece = flying.pop(done)
            with _whole():
                rows = done.result()
            yield piece, rows


@contextmanager
def _whole() -> Iterator[None]:
    """That a process was killed is found by what the pool was given, or by giving it more."""
    try:
        yield
    except BrokenProcessPool:
        raise BoresightError(
            "many: a process was killed, perhaps for want of memory; the same command goes on"
        ) from None


def fly_piece(experiment: Experiment, where: str, seed: int, device: str, piece: range) -> Array:
    """Final states (len(piece), columns) of a few runs.  where: the folder of the model, or its hash on a cluster."""
    if device == "gpu" or experiment.fly is None:
        rows = _in_c(experiment, _library(where), seed, piece, device)
    else:
        rows = np.asarray(experiment.fly(_library(where), experiment.settings, seed, piece), float)
    shape = len(piece), len(experiment.columns)
    if rows.shape != shape:
        raise BoresightError(f"{experiment.name}: fly gave an array of shape {rows.shape} in place of {shape}")
    lost = ~np.isfinite(rows).all(-1)
    rows[lost] = np.nan
    return rows


def _in_c(experiment: Experiment, library: Library, seed: int, piece: range, device: str) -> Array:
    assert experiment.given is not None and library.folder is not None
    given = np.ascontiguousarray(experiment.given(library, experiment.settings, seed, piece), float)
    flown = given, seed, piece, len(experiment.columns)
    if device == "cpu":
        rows, status = text.fly(text.host(library.folder, _source(experiment)), *flown)
    else:
        from boresight.runtime.gpu.card import card

        rows, status = card().fly(card().kernel(library.folder, _source(experiment)), *flown)
    rows[status != 0] = np.nan
    return rows


def _source(experiment: Experiment) -> Path:
    """The experiment in C, which lies beside its Python."""
    assert experiment.given is not None and experiment.in_c is not None
    file = inspect.getsourcefile(experiment.given)
    assert file is not None
    return Path(file).with_name(experiment.in_c)


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
