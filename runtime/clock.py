"""The clock of a regular sensor, out of tags that jitter: a line through them, and the samples that are missing.

A sensor delivers at the regular intervals of its own crystal; the tags are put on by another clock when the data
arrive, late by turns.  Differences of such tags are no intervals.  What is fitted here is a line, tag = begin +
interval x number, which may bend slowly, as crystals drift.  A step by whole intervals means lost samples.  `Clock` is
for live loops, sample by sample; `regular` for recordings, where what comes later is known too.
"""

import math
from collections import deque
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.interpolate import make_lsq_spline
from scipy.ndimage import median_filter

from boresight import BoresightError
from boresight.runtime.array import Array

NOMINAL = 1e-3  # one sigma of a nominal interval, as a part of it
LONGEST = 600  # samples that a live step is looked for in


@dataclass(frozen=True)
class Regular:
    """The samples of a recording on their clock."""

    time: Array  # (K,) s, on the line
    missing: Array  # (K,) int, intervals lost before each sample
    interval_s: float  # mean; the length that a sample's increments cover
    jitter_s: float  # one sigma of tag - line


def regular(tags: Any, *, memory_s: float = 60.0) -> Regular:
    """The tags (K,) s of a regular sensor, put on the line of its clock, which bends once in memory_s / 2.

    Lost samples are found where the tags stay off by whole intervals.  Where one sigma of the jitter is s, two losses
    are told apart from 200 (s / interval)^2 samples on.  Raises BoresightError where the tags lie on no such line.
    """
    tags = np.asarray(tags, float)
    if tags.ndim != 1 or len(tags) < 10 or not np.isfinite(tags).all():
        raise BoresightError(f"clock: the tags have shape {tags.shape}; give at least 10 finite times")
    count = np.arange(len(tags))
    step = np.diff(tags)
    noise = 1.4826 * float(np.median(np.abs(step - np.median(step)))) / np.sqrt(2)
    span = 1  # over which a median of differences is an interval to 1e-4
    while (interval := float(np.median(tags[span:] - tags[:-span])) / span) > 0 and (
        2 * noise > 1e-4 * span * interval * np.sqrt(len(tags)) and span < len(tags) // 4
    ):
        span += 1
    if not interval > 0:
        raise BoresightError("clock: the tags do not grow; give those of one sensor, in their order")
    n = max(1, math.ceil(200 * (noise / interval) ** 2))
    level = tags - interval * count
    usual, near = median_filter(level, 2 * n + 3), interval + 4 * noise if n > 1 else 0.0
    level = usual + np.clip(level - usual, -near, near)  # a tag that is late alone would be seen in n means
    index = count + _steps(level, interval, n)
    # a tag that is late alone is no loss: those behind it have no room
    index = np.minimum.accumulate((index - count)[::-1])[::-1] + count
    index -= index[0]

    weight = np.ones(len(tags))
    pieces = max(1, round(2 * interval * index[-1] / memory_s))
    ends = np.interp(np.linspace(0, 1, pieces + 1), np.linspace(0, 1, len(index)), index)
    knots = np.r_[ends[0], ends, ends[-1]]
    for _ in range(3):  # a tag far off, of a busy host, has no weight
        line = make_lsq_spline(index, tags, knots, k=1, w=weight)(index)
        off = np.abs(tags - line)
        weight = np.where(off <= 5 * np.median(off) + 1e-9 * interval, 1.0, 1e-6)
    jitter = float(np.sqrt(np.average(off**2, weights=weight)))
    mean = float((line[-1] - line[0]) / index[-1])
    if jitter > max(2 * noise, 0.2 * mean) or not (np.diff(line) > 0).all():
        raise BoresightError(
            f"clock: the tags leave the line of a regular clock by {jitter:.3g} s at intervals of {mean:.3g} s; "
            "say that they are no regular sensor's"
        )
    return Regular(line, np.diff(index, prepend=-1) - 1, mean, jitter)


def _steps(level: Array, interval: float, n: int) -> Array:
    """(K,) int: by how many intervals the level (K,) has stepped so far, seen between means over n samples."""
    if n == 1:
        return np.r_[0, np.cumsum(np.round(np.diff(level) / interval).astype(int))]
    out = np.zeros(len(level), int)
    for _ in range(20):  # two losses close together are seen one after the other
        total = np.r_[0.0, np.cumsum(level - interval * out)]
        change = (total[2 * n :] - 2 * total[n:-n] + total[: -2 * n]) / n  # at samples n, n + 1, ...
        beyond = np.flatnonzero(np.abs(change) > interval / 2)
        if not len(beyond):
            break
        for part in np.split(beyond, np.flatnonzero(np.diff(beyond) > n) + 1):
            at = part[np.argmax(np.abs(change[part]))]
            out[at + n :] += max(1, round(abs(change[at]) / interval)) * int(np.sign(change[at]))
    return out


@dataclass(frozen=True)
class Tick:
    """One sample on its clock: an interval of `dt` that ends at `time`, `missing` intervals behind the last one."""

    time: float  # s, by the clock that puts on the tags
    dt: float  # s, what the sample's increments cover
    missing: int  # intervals; below 0: one that was there already


class Clock:
    """The regular clock of a live sensor, from time tags that jitter; lost samples are found.

    A line through the tags by least squares that forget, and its steps by whole intervals.

    Parameters
    ----------
    interval_s : float
        Nominal interval of the sensor, to 0.1 %.
    memory_s : float, optional
        Of the line, by which it follows a drift.
    modulo : int, optional
        Of the sensor's counter, if it has one that wraps.

    Attributes
    ----------
    interval_s : float
        As found so far.
    jitter_s : float
        One sigma of tag - line.

    Raises
    ------
    BoresightError
        An interval that is not above zero, or not below memory_s.

    Notes
    -----
    With a counter lost samples are known at once, and tags that stay off say that their own clock
    was set.  Without one a step is believed when the mean of the last samples is off by an interval
    and they agree: 3 samples, or (12 s / interval)^2 where one sigma s of the jitter asks for more.
    A mean latency of the tags stays in the time.  When not to use it: for a recording, where later
    tags are known too (`read(..., regular=True)`), or for a sensor that samples at no regular
    interval.

    Examples
    --------
    >>> from boresight import Clock
    >>> clock = Clock(0.01, modulo=256)
    >>> for tag, count in [(0.0, 254), (0.0103, 255), (0.0298, 1)]:
    ...     tick = clock.sample(tag, count)
    >>> tick.missing
    1
    """

    def __init__(self, interval_s: float, *, memory_s: float = 60.0, modulo: int | None = None):
        if not (0 < interval_s < memory_s):
            raise BoresightError(f"clock: interval_s is {interval_s}, memory_s {memory_s}; give 0 < interval < memory")
        self.interval_s, self.modulo = float(interval_s), modulo
        self.jitter_s = interval_s / 2  # until it is known better
        self._forget = math.exp(-interval_s / memory_s)
        self._prior = (0.5 / NOMINAL) ** 2  # of the interval, in samples squared
        self._sums = (0.0, 0.0, 0.0)  # of weight, weight x number, weight x number^2; the newest sample is number 0
        self._time: float | None = None
        self._count: int | None = None
        self._looked = 0
        self._off: deque[float] = deque(maxlen=LONGEST)

    def sample(self, tag: float, count: int | None = None) -> Tick:
        """Take the tag of one sample.

        Parameters
        ----------
        tag : float
            s, by the clock of the host; one that is not finite stands on the line.
        count : int, optional
            Of the sensor.

        Returns
        -------
        Tick
            `time`, s on the line, where the sample's interval ends; `dt`, s, what its increments
            cover; `missing`, intervals lost before it, below 0 for a sample that was there already.
        """
        missing = 0
        if self._time is None:
            if not math.isfinite(tag):
                return Tick(math.nan, self.interval_s, 0)
            self._time = tag - self.interval_s
        if count is not None:
            if self._count is not None:
                missing = (count - self._count) % self.modulo - 1 if self.modulo else count - self._count - 1
            self._count = count
        if missing < 0:
            return Tick(self._time, self.interval_s, missing)
        self._advance(1 + missing)
        off = tag - self._time if math.isfinite(tag) else 0.0
        stepped = self._step(off)
        if stepped:
            whole = round(stepped / self.interval_s)
            if count is None and whole > 0:
                missing += whole
                self._advance(whole)
            else:  # the clock of the tags was set
                self._time += stepped
            off = tag - self._time
        self._follow(off)
        return Tick(self._time, self.interval_s, missing)

    def _advance(self, number: int) -> None:
        """The line goes on by so many intervals."""
        S0, S1, S2 = (self._forget**number * part for part in self._sums)
        self._sums = (S0, S1 - number * S0, S2 - 2 * number * S1 + number**2 * S0)
        self._time = (self._time or 0.0) + number * self.interval_s

    def _step(self, off: float) -> float:
        """By how much the tags have left the line for good, s, or 0."""
        self._off.append(off)
        n = min(max(3, math.ceil((12 * self.jitter_s / self.interval_s) ** 2)), LONGEST - 1) | 1
        self._looked += 1
        if len(self._off) < n or self._looked < n // 8 or (n == 3 and abs(off) <= self.interval_s / 2):
            return 0.0
        self._looked = 0
        last = sorted(list(self._off)[-n:])
        middle = last[n // 8 : n - n // 8]
        mean = sum(middle) / len(middle)
        # tags that catch up after a stall go down by an interval each: they do not agree
        agree = last[-1 - n // 5] - last[n // 5] < 2 * self.jitter_s + self.interval_s / 4
        if abs(mean) <= self.interval_s / 2 or not agree:
            return 0.0
        self._off.clear()
        return mean

    def _follow(self, off: float) -> None:
        """Move the line towards a tag; one that is far off pulls as one at 3 sigma."""
        if self.jitter_s < self.interval_s / 8:  # what lost and late samples leave over shows the phase
            off -= self.interval_s * round(off / self.interval_s)
        off = max(-3 * self.jitter_s, min(3 * self.jitter_s, off))
        S0, S1, S2 = self._sums
        S0 += 1
        self._sums = (S0, S1, S2)
        gain = 1 / (S0 * (S2 + self._prior) - S1**2)
        self._time = (self._time or 0.0) + (S2 + self._prior) * gain * off
        self.interval_s -= S1 * gain * off
        variance = self.jitter_s**2 + (off**2 - self.jitter_s**2) / min(S0 + 1, 100)
        self.jitter_s = max(math.sqrt(variance), 1e-3 * self.interval_s)
