"""An experiment that is flown very often, and what its runs say: moments, percentiles with intervals, one SHA-256."""

import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from boresight.runtime.array import Array
from boresight.runtime.library import Library
from boresight.runtime.store import BLOCK, Store

SURE = 1.959963984540054  # sigmas to either side of a 95 % interval
PERCENTILES = (50.0, 95.0, 99.0)


@dataclass(frozen=True)
class Experiment:
    """What `many` flies.

    Parameters
    ----------
    name : str
        In reports and directories.
    model : str or Path
        Name or generated folder of the model, as of `load`.
    columns : mapping of str to str
        What `fly` returns: the unit of each column by its name.
    fly : function, optional
        fly(library, settings, seed, runs), with runs a range of numbers: final states (len(runs),
        columns), a row of NaN for a run that is lost.  A row may depend on the settings, the seed
        and its run's number, and on nothing else.  It is a function of a module, so that processes
        find it.  Without it `in_c` flies, one run after the other.
    settings : dataclass or dict, optional
        What JSON can hold; it is kept beside the runs.
    expected : mapping of str to float, optional
        Mean of a column, where the filter is consistent.
    percentiles : tuple of str, optional
        Columns of which percentiles are computed.
    in_c : str, optional
        The runs as C, for a GPU those of `fly` bit for bit: a file beside the module of `given`
        that defines `boresight_run` of boresight/runtime/gpu/run.h.
    given : function, optional
        given(library, settings, seed, runs): the float64 numbers that this C reads, the same for
        all of these runs.

    Raises
    ------
    BoresightError
        By `many`: settings that JSON cannot hold, a name that is no column, final states of another
        shape.

    Notes
    -----
    When not to use it: for results that are no row of numbers for each run, as time histories.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Experiment
    >>> def fly(library, settings, seed, runs):
    ...     return np.zeros((len(runs), 1))
    >>> Experiment("rest", "euler-matching", {"error": "m"}, fly).percentiles
    ()
    """

    name: str
    model: str | Path
    columns: Mapping[str, str]
    fly: Callable[[Library, Any, int, range], Array] | None = None
    settings: Any = field(default_factory=dict)
    expected: Mapping[str, float] = field(default_factory=dict)
    percentiles: tuple[str, ...] = ()
    in_c: str | None = None
    given: Callable[[Library, Any, int, range], Array] | None = None


@dataclass(frozen=True)
class Goal:
    """When `many` knows enough: a percentile whose 95 % interval is narrow.

    Parameters
    ----------
    column : str
        Of the experiment.
    within : float
        In the column's unit: how far the interval may reach to either side, on the mean of both.
    percentile : float, optional
        Between 0 and 100.

    Raises
    ------
    BoresightError
        By `many`: a percentile or width outside these bounds, a column that is not there.

    Notes
    -----
    When not to use it: to compare two designs; fly both with the same runs and seed.

    Examples
    --------
    >>> from boresight import Goal
    >>> Goal("error", within=0.05).percentile
    95.0
    """

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

    def report(self) -> str:
        """A table in text: the percentiles, and the means that a consistent filter is known to have."""
        lines = [f"{self.experiment}: {self.runs} runs, seed {self.seed}" + f", {self.lost} lost" * bool(self.lost)]
        width = max(map(len, (*self.percentiles, *self.columns)))
        for name, one in self.percentiles.items():
            unit = self.columns[name]["unit"]
            for p, numbers in one.items():
                value, low, high = ("beyond" if number is None else f"{number:.4g}" for number in numbers)
                lines.append(f"  {name:{width}} {p:>3} %  {value:>9} {unit}  ({low} to {high})")
        for name, column in self.columns.items():
            if "expected" in column and column["interval"] is not None:
                low, high = column["interval"]
                lines.append(
                    f"  {name:{width}}  mean  {column['mean']:9.4g} {column['unit']}  ({low:.4g} to {high:.4g}), "
                    f"{column['expected']:g} of a consistent filter"
                )
        if self.reached is not None:
            lines.append("the goal is reached" if self.reached else "the goal is NOT reached; give it more runs")
        return "\n".join([*lines, f"SHA-256 {self.digest}"])


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
        least, largest = np.minimum(self.least, other.least), np.maximum(self.largest, other.largest)
        return Moments(n, mean, square, least, largest)

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


class Known:
    """Summaries of the runs below a count, from a summary of each block."""

    def __init__(self, store: Store, watched: tuple[str, ...], experiment: Experiment):
        self.store, self.experiment, self.watched = store, experiment, watched
        self.moments: list[Moments] = []
        self.digests: list[bytes] = []
        self.values: dict[str, list[Array]] = {name: [] for name in watched}
        self.runs = 0
        self.needed = 0
        self.text = experiment.name

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
