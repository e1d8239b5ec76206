"""What the slave misses: up to `bridge_s` it is bridged; beyond that a run waits for a message to begin anew.

A run whose slave has left the model's range waits for one too.
"""

from typing import Any

import numpy as np

from boresight.runtime.array import Array
from boresight.runtime.transfer.history import History
from boresight.runtime.transfer.rules import Watch

# The models' range: a sample beyond it is none.
RATES, INCREMENTS = np.repeat([20.0, 500.0], 3), np.repeat([0.5, 100.0], 3)  # rad/s, m/s^2; rad, m/s
FELT = 0.01  # of P: what is opened by less is as good as known


class Gaps:
    """Run by run what is missing of the slave, what stands in for it, and which runs have lost their way.

    A missing interval has the rates of the last sample, or, where the next one is known, those on the line between the
    two; when the next one comes, the mean of both holds for all that was missing.  P is opened by the mean square of
    what the same rule would have missed, axis by axis, had as many samples been missing anywhere in the kept past.
    """

    def __init__(self, watch: Watch, rates: Array):
        """rates: (..., 6) rad/s and m/s^2 that stand in before the first sample."""
        runs = rates.shape[:-1]
        self.watch, self.rates = watch, rates
        self.missing_s = np.zeros(runs)  # since the last sample
        self.stood_in = np.zeros((*runs, 6))  # rad and m/s, since then
        self.missed_at = np.full(runs, -np.inf)  # the end of what was bridged
        self.told_at = np.full(runs, -np.inf)
        self.lost = np.zeros(runs, bool)
        self.left = np.zeros(runs, bool)  # of the lost ones those that have left the model's range
        # of a lost run: how long its state was known, P then, and from when on there are samples again
        self.lost_at, self.P, self.back_at = np.zeros(runs), np.zeros(()), np.full(runs, np.inf)

    def usable(self, increments: Array, dt: Any) -> Array:
        """(...,) bool: whether the increments (..., 6) are numbers in the models' range."""
        return np.asarray((np.abs(increments) <= np.minimum(RATES * dt, INCREMENTS)).all(-1))

    def stand_in(self, where: Array, rates: Array, seconds: float) -> None:
        """These rates stand in for an interval."""
        self.missing_s = np.where(where, self.missing_s + seconds, self.missing_s)
        self.stood_in += np.where(where[..., None], rates * seconds, 0.0)
        self.back_at = np.where(where, np.inf, self.back_at)

    def sample(self, good: Array, rates: Array, dt: float, time: float, history: History, P: Array
               ) -> tuple[Array, Array]:  # fmt: skip
        """A sample (..., 6) that ends at `time` is there (...,) or stands in; history: without it.

        Returns rad and m/s (..., 6) to add to it, which are what was wrong with what stood in, and variances for P.
        """
        self.stand_in(~good, rates, dt)
        more, variance = np.zeros((2, *rates.shape))
        ends = good & (self.missing_s > 0) & ~self.lost
        if ends.any():
            more[ends] = (self.missing_s[..., None] * (self.rates + rates) / 2 - self.stood_in)[ends]
            variance[ends] = self._missed(rates, dt, time, history)[ends]
            told = ends & (time - self.told_at >= self.watch.rules.quiet_s)
            longest = float(self.missing_s[ends].max())
            self.watch.note(told, f"{longest:.3f} s of the slave were missing and are bridged; P is opened")
            self.told_at = np.where(told, time, self.told_at)
            # messages from before are refused, unless P hardly feels what was opened
            level = np.diagonal(P, axis1=-2, axis2=-1)[..., :6].reshape((*rates.shape[:-1], 2, 3)).min(-1)
            felt = (variance.reshape((*rates.shape[:-1], 2, 3)).max(-1) > FELT * level).any(-1)
            self.missed_at = np.where(ends & felt, time, self.missed_at)
        self.back_at = np.where(good & self.lost, np.minimum(self.back_at, time - dt), self.back_at)
        self.missing_s = np.where(good, 0.0, self.missing_s)
        self.stood_in = np.where(good[..., None], 0.0, self.stood_in)
        self.rates = rates  # of a run without a sample those of its last
        return more, variance

    def _missed(self, rates: Array, seconds: float, time: float, history: History) -> Array:
        """(..., 6) rad^2 and (m/s)^2 that the line between the two samples may have missed."""
        count = np.round(self.missing_s / seconds).astype(int)
        out = (count[..., None] * (rates - self.rates) * seconds / 2) ** 2  # a past too short to look at
        known = time - seconds - self.missing_s  # until then
        for m in np.unique(count[count > 0]):
            here = count == m
            kept = history.time <= known[here].min() + seconds / 2
            sums = np.concatenate([history.recent(name)[kept] for name in ("angle", "push")], axis=-1)
            each = np.diff(sums, axis=0)
            places = len(each) - m - 1
            if places >= 3:
                between = sums[1 + m : 1 + m + places] - sums[1 : 1 + places]
                off = between - m / 2 * (each[:places] + each[m + 1 : m + 1 + places])
                out[here] = np.mean(off**2, axis=0).reshape(self.rates.shape)[here]
        return np.asarray(out)

    def lose(self, where: Array, P: Array, time: float, missing_s: float = 0.0, left: str = "") -> Array:
        """Which of these runs lose their way now; P at `time`, behind which another missing_s are missing.

        left: how they have left the model's range, where nothing is missing.
        """
        new = where & ~self.lost
        if not new.any():
            return new
        self.P = of_runs(new, P, np.broadcast_to(self.P, P.shape))
        self.lost_at = np.where(new, time, self.lost_at)
        self.back_at = np.where(new, np.inf, self.back_at)
        self.lost = self.lost | new
        self.left = self.left | (new & bool(left))
        longest = float(np.max(self.missing_s[new])) + missing_s
        cause = (
            f"the slave is beyond the model's range ({left})" if left else f"{longest:.3f} s of the slave are missing"
        )
        self.watch.note(new, f"{cause}: the filter begins anew from the next message, and keeps biases, mounting, "
                             "lever arm and delay")  # fmt: skip
        return new

    def found(self, where: Array, known_from: float) -> None:
        """These runs have begun anew; their past is known from then on."""
        away = float(np.max(self.watch.time - self.lost_at[where]))
        self.watch.note(where, f"the filter has begun anew, {away:.2f} s after the slave was known last")
        self.lost, self.left = self.lost & ~where, self.left & ~where
        self.missed_at = np.where(where, known_from, self.missed_at)


def of_runs(where: Array, new: Any, old: Any) -> Array:
    """Of the runs (...,) in `where` the new array, of the others the old one."""
    return np.where(where.reshape(where.shape + (1,) * (np.ndim(old) - where.ndim)), new, old)
