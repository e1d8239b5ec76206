"""The filter of the flights at sea, many runs at once: the plain extended Kalman filter of the generated C.

Attitude, then velocity, at each update; no gate and no other rule.  The delay is compensated as Kang and others (2025)
do it: the slave as it is now is moved back along its rates by lag = tau.
"""

from typing import Any

import numpy as np

from boresight.runtime.array import Array
from boresight.runtime.filter import CompiledFilter, Epoch
from boresight.runtime.library import Library
from boresight.runtime.status import Status

SPAN_S = 0.04  # of a rate at an update, the mean over it
GRAVITY = 9.798  # m/s^2; 0.02 more or less, over a delay of 10 ms, is 0.2 mm/s


class Matching:
    """A filter of each run, from one update to the next.

    s: the `flight.Scenario`.  nav: (runs, ...), P: (runs or 1, 16, 16).  constants, R (6,): as `flight.constants` and
    `flight.matching_variances` give them.  attitude: the measurement that is matched beside "velocity".

    samples: (runs, T + 1, 6) rad and m/s, the slave's increments from the newest to the oldest; the T of an interval
    are written by the caller into `newest`, and the one before stands behind them, as the C reads both.
    measured: by measurement; `rows` may be written, R is.  lost: (runs,) a step was refused, and left out.
    """

    def __init__(self, model: Library, s: Any, nav: dict[str, Array], P: Array, constants: dict[str, Any], R: Array,
                 attitude: str = "dcm"):  # fmt: skip
        n, steps = len(nav["v_n"]), s.covariance_hz // s.update_hz
        self.dt, self.lever = 1 / s.navigation_hz, constants["lever_b"]
        self.each, self.span = s.navigation_hz // s.covariance_hz, round(SPAN_S * s.navigation_hz)
        self.half, interval = self.each // 2, steps * self.each
        self.loop = loop = CompiledFilter(model, nav, P, np.zeros((n, P.shape[-1])))
        # The covariance takes each of its steps in the middle of it, where it is linearised.
        alike = {"dt", "R", *constants}
        self.before = Epoch(loop, self.half, feedback=False, shared=alike)
        self.after = Epoch(loop, self.each - self.half, predict=False, feedback=False, shared=alike)
        self.correction = Epoch(loop, 0, (attitude, "velocity"), predict=False, shared=alike)
        self.measured = self.correction.measured
        self.before.predict["dt"] = self.each * self.dt
        for name in self.before.predict.fields.keys() & constants.keys():
            self.before.predict[name] = constants[name]
        self.measured["velocity"]["lever_b"] = self.lever
        swung = swing_variance(constants["gyro_noise"][0], self.span * self.dt, self.lever)
        self.measured["velocity"]["R"], self.measured[attitude]["R"] = R[:3] + swung, R[3:]

        self.samples, self.first = np.zeros((n, interval + 1, 6)), True
        self.newest, self.lost = self.samples[:, :-1], np.zeros(n, bool)
        structs = loop.described["strapdown"]["structs"]
        self.increments = []
        for epoch in (self.before, self.after)[self.half == 0 :]:
            epoch.strapdown["dt"] = self.dt
            given = epoch.strapdown.given[structs.index("increments")]
            given.stride, given.step = self.samples[0].size, -6
            self.increments.append(given)

    def update(self, **master: Array) -> None:
        """Fly the interval whose samples stand in `newest`, and match what the master reports: fields (runs, ...)."""
        loop, each, samples = self.loop, self.each, self.samples
        if self.first:
            samples[:, -1], self.first = samples[:, -2], False
        step, at = max(1, each // 10), samples.ctypes.data
        for oldest in range(samples.shape[1] - 2, -1, -each):
            for given, row in zip(self.increments[::-1], (oldest - self.half, oldest), strict=False):
                given.at = at + row * 6 * samples.itemsize
            begin = oldest + 1 - each
            few = np.ascontiguousarray(samples[:, begin + step // 2 : oldest + 1 : step, 3:].T).swapaxes(0, 1)
            # F wants the force to a hundredth
            self.before.predict["f_b"] = (summed(few) / (len(few) * self.dt)).T - loop.nav.seen("accel_bias")
            self._call(self.before)
            self._call(self.after)
        bias = loop.nav.seen("gyro_bias"), loop.nav.seen("accel_bias")
        last = samples[:, : 2 * self.span]
        omega, a_n = moving(last, loop.nav.seen("q_b2n_wxyz"), *bias, self.dt, self.lever)
        master |= {"omega_ib_b": omega, "a_n": a_n, "lag": loop.nav.seen("tau")}
        for measured in self.measured.values():
            for name in master.keys() & measured.fields.keys():
                measured[name] = master[name]
        self._call(self.correction)
        samples[:, -1] = samples[:, 0]

    def _call(self, epoch: Epoch) -> None:
        if epoch():
            self.lost |= (epoch.status != Status.OK) & (epoch.status != Status.AT_CEILING)

    @property
    def nis(self) -> Array:
        """(2, runs) of the attitude and of the velocity at the last update."""
        return np.array([measured.nis for measured in self.measured.values()])


def swing_variance(gyro_noise: float, span_s: float, lever: Array) -> float:
    """(m/s)^2 of `moving`: the gyros' noise comes with the rate into the lever arm's velocity, two thirds about an
    axis."""
    return float(gyro_noise**2 * 2.5 / span_s * lever @ lever * 2 / 3)


def moving(
    last: Array, q_b2n: Array, gyro_bias: Array, accel_bias: Array, dt: float, lever: Array
) -> tuple[Array, Array]:
    """How the slave turns, and how its master is accelerated, (runs, 3) each; by its last samples (runs, 2 SPAN, 6)."""
    each = np.ascontiguousarray(last.T)  # components first: (6, 2 SPAN, runs)
    span = each.shape[1] // 2
    later, earlier = (summed(each[:, part].swapaxes(0, 1)) / (span * dt) for part in (slice(span), slice(span, None)))
    change = later - earlier
    rates = later + change / 2  # the later one is that of half a span ago
    omega, f_b, alpha = rates[:3] - gyro_bias.T, rates[3:] - accel_bias.T, change[:3] / (span * dt)
    a_n = turned(q_b2n.T, f_b - crossed(alpha, lever) - crossed(omega, crossed(omega, lever)))
    a_n[2] += GRAVITY
    return omega.T, a_n.T


def crossed(a: Array, b: Array) -> Array:
    """The cross product of (3, ...)."""
    out = np.empty_like(a)
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        np.subtract(a[j] * b[k], a[k] * b[j], out=out[i])
    return out


def summed(values: Array) -> Array:
    """Over the first axis, in an order that no other axis changes."""
    while len(values) > 1:
        half, odd = divmod(len(values), 2)
        rest = values[2 * half :]
        values = values[:half] + values[half : 2 * half]
        if odd:
            values[0] += rest[0]
    return values[0]


def turned(q: Array, vector: Array) -> Array:
    """C of q (4, runs) times a vector (3, runs)."""
    axis = q[1:]
    twice = 2 * crossed(axis, vector)
    return vector + q[0] * twice + crossed(axis, twice)
