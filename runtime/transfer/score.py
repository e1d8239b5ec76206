"""Whether a filter's innovations show what it does not carry: Rao's score test of scale factors and axes.

The model with states for them is flown with a variance so small that no estimate changes.  A considered state's
covariance with the others, over its variance, is then how far one unit of it drives them off: the sensitivity.  What
that makes of an innovation is regressed on; the sum of the squares explained is chi-square where nothing is there.

That holds where the innovations are white and as large as the filter says.  Where R is another one, or a master without
noise leaves what is no noise at all, the scatter of the scores from one part of the flight to the next says how far
they stray; of both statistics the smaller one counts.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.special import chdtri, chndtr, fdtrc

from boresight.runtime.array import Array
from boresight.runtime.transfer.sensors import CALIBRATION, PROBE

GROUPS = {
    "gyro scale factors": slice(0, 3), "accelerometer scale factors": slice(3, 6), "gyro axes": slice(6, 12),
    "accelerometer axes": slice(12, 15),
}  # fmt: skip
ALARMS, POWER = 0.01, 0.95
PARTS = 32  # of a flight at least, once it has so many messages; twice as many are joined in pairs


@dataclass(frozen=True)
class Noticed:
    """Of one group, run by run (...,)."""

    statistic: Array  # chi-square with as many degrees of freedom as it has parameters, where they are zero
    bound: float  # exceeded by chance in one of a hundred flights by any of the groups
    smallest: Array  # 1 or rad, one sigma of each parameter, that is noticed in 95 % of flights


class Score:
    """Of a filter that carries `Sensors(probed=True)`: `begin`, `take` each measurement, `end`, message by message."""

    def __init__(self, runs: tuple[int, ...]):
        self.gradient, self.information = np.zeros((*runs, 15)), np.zeros((*runs, 15, 15))
        self._gradient, self._information = self.gradient, self.information
        self._parts: list[tuple[Array, Array]] = []
        self._in_last, self._each = 0, 1  # messages in the last part, and in each

    def begin(self) -> None:
        """Of a message, which may yet be refused."""
        self._gradient, self._information = np.zeros_like(self.gradient), np.zeros_like(self.information)

    def take(self, nu: Array, H: Array, P: Array, R: Array, rows: Array) -> None:
        """One measurement before its update: innovations (..., m), H (..., m, n), P, variances R and rows (..., m)."""
        PH = P @ np.swapaxes(H, -1, -2)
        S = H @ PH + R[..., None] * np.eye(R.shape[-1])
        both = rows[..., :, None] & rows[..., None, :]
        S = np.where(both, S, np.eye(R.shape[-1]))
        s = np.where(rows[..., None], np.swapaxes(PH[..., CALIBRATION, :], -1, -2) / PROBE**2, 0.0)
        nu = np.where(rows, nu, 0.0)
        by = np.linalg.solve(S, np.concatenate([s, nu[..., None]], axis=-1))
        self._gradient = self._gradient + np.einsum("...ik,...i->...k", s, by[..., -1])
        self._information = self._information + np.swapaxes(s, -1, -2) @ by[..., :-1]

    def end(self, taken: Array) -> None:
        came = np.where(taken[..., None], self._gradient, 0.0), np.where(taken[..., None, None], self._information, 0.0)
        self.gradient, self.information = self.gradient + came[0], self.information + came[1]
        if self._parts and self._in_last < self._each:
            self._parts[-1] = (self._parts[-1][0] + came[0], self._parts[-1][1] + came[1])
            self._in_last += 1
            return
        if len(self._parts) == 2 * PARTS:
            pairs = zip(self._parts[::2], self._parts[1::2], strict=True)
            self._parts = [(one[0] + next_to[0], one[1] + next_to[1]) for one, next_to in pairs]
            self._each *= 2
        self._parts.append(came)
        self._in_last = 1

    def scattered(self, part: slice) -> tuple[Array, Array] | None:
        """The statistic of a group by the scatter of its scores, and the information that they have by it.

        The statistic is the number of a chi-square law that is as rare as Hotelling's is, of so many parts.  None of a
        flight with fewer than PARTS of them.
        """
        count = len(self._parts)
        if count < PARTS:
            return None
        g, information = self.gradient[..., part], self.information[..., part, part]
        k = g.shape[-1]
        found = np.linalg.pinv(information) @ g[..., None]
        each = np.stack([one[0][..., part] - (one[1][..., part, part] @ found)[..., 0] for one in self._parts], axis=-2)
        stray = np.linalg.pinv(np.swapaxes(each, -1, -2) @ each * (count / (count - 1)))
        hotelling = (g[..., None, :] @ stray @ g[..., None])[..., 0, 0]
        rare = fdtrc(k, count - k, hotelling * (count - k) / (k * (count - 1)))
        return chdtri(k, np.maximum(rare, 1e-300)), information @ stray @ information

    def noticed(self) -> dict[str, Noticed]:
        """By group, each tested as if the others were zero."""
        out = {}
        for name, part in GROUPS.items():
            g, information = self.gradient[..., part], self.information[..., part, part]
            k = g.shape[-1]
            statistic = np.einsum("...i,...i->...", g, (np.linalg.pinv(information) @ g[..., None])[..., 0])
            bound = float(chdtri(k, ALARMS / len(GROUPS)))
            smallest = np.apply_along_axis(detectable, -1, np.linalg.eigvalsh(information), bound)
            if scattered := self.scattered(part):
                statistic = np.minimum(statistic, scattered[0])
                by_scatter = np.apply_along_axis(detectable, -1, np.linalg.eigvalsh(scattered[1]), bound)
                smallest = np.maximum(smallest, by_scatter)
            out[name] = Noticed(statistic, bound, smallest)
        return out


def detectable(eigenvalues: Array, bound: float, draws: int = 2000) -> float:
    """The sigma of independent parameters at which the statistic exceeds `bound` in POWER of all flights."""
    unit = np.random.default_rng(0).standard_normal((draws, len(eigenvalues))) ** 2 @ np.maximum(eigenvalues, 0.0)
    if not (unit > 0).all():
        return np.inf
    low, high = np.log(1e-9), np.log(1e3)
    while high - low > 1e-3:
        middle = (low + high) / 2
        seen = 1 - chndtr(bound, len(eigenvalues), np.minimum(np.exp(2 * middle) * unit, 1e4))
        low, high = (low, middle) if seen.mean() > POWER else (middle, high)
    return float(np.exp(high))


def driven(P: Any) -> Array:
    """(..., n, 15) by how much a unit of each parameter drives the states off, of a P with `Sensors(probed=True)`."""
    sensitivity: Array = np.asarray(P)[..., :, CALIBRATION] / PROBE**2
    return sensitivity
