"""The master's delay: which messages inform it, and whether it or the master's clock has changed."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.special import chdtri

from boresight.runtime.array import Array, wrapped
from boresight.runtime.filter import Filter
from boresight.runtime.transfer.history import DV, GYRO_BIAS, PHI, TAU, History, moment
from boresight.runtime.transfer.rules import Rules

LONGEST = 0.95  # s, a delay; the model's own range ends at 1
CLEAR = 1e-3  # the part of the weight that another explanation may have
STRETCH_S = 0.5  # of the slave's past, in which the noise of its rates is seen


def scatter(history: History, name: str, now: float, span_s: float) -> Array:
    """(R,) variance by axis of the noise of means over `span_s` of the rate behind `angle` or `push`: what is seen.

    Third differences of neighbouring means take a motion of up to 2 Hz out (span 40 ms) and leave white noise and
    vibration, with 20 times their variance.
    """
    count = int(min(now - history.time[0], STRETCH_S) / span_s + 1e-6)
    if count < 4:
        return np.zeros(history.runs)
    times = now - span_s * np.arange(count + 1)[:, None]
    rate = np.diff(history.at(name, np.broadcast_to(times, (count + 1, history.runs))), axis=0) / span_s
    variance: Array = np.square(np.diff(rate, 3, axis=0)).mean((0, 2)) / 20
    return variance


def rate_variances(
    history: History, rules: Rules, P: Array, F: Array, inputs: dict[str, Any], factor: Array, lever: Array
) -> dict[str, Array]:
    """Variances by axis (..., 3) of omega_ib_b and a_n as `inputs` has them: noise, and what P says of their biases.

    P, F: at the message's time.  factor: variance of such a rate over the gyros' density squared.  lever: (..., 3) m.
    """
    runs, span, now = P.shape[:-2], 2 * rules.half_span_s, float(history.time[-1])
    gyro, accel = (
        np.maximum(np.max(np.square(inputs[density]), axis=-1), span * scatter(history, name, now, span).reshape(runs))
        for density, name in (("gyro_noise", "angle"), ("accel_noise", "push"))
    )
    # the lever arm's part of the acceleration is a difference of two rates
    white = accel * factor + np.sum(np.square(lever), axis=-1) * gyro * 2 * factor / span**2
    error = np.sum((F[..., DV, :] @ P) * F[..., DV, :], axis=-1)
    return {
        "omega_ib_b": (gyro * factor)[..., None] + np.einsum("...ii->...i", P[..., GYRO_BIAS, GYRO_BIAS]),
        "a_n": white[..., None] + error,
    }


def rate_of(measurement: str) -> str:
    """In which the delay's column is linear: attitude turns with the rate, velocity with the acceleration."""
    return "a_n" if measurement == "velocity" else "omega_ib_b"


def by_rate(loop: Filter, measurement: str, inputs: dict[str, Any], around: dict[str, Array]) -> Array:
    """H (4 + K, ..., m, n) of the measurement: as the filter is; with 1e-3 more of the rate about or along each axis;
    and as it is at the K other times of `around`, whose first one is that of the inputs.
    """
    others, name = len(around["lag"]) - 1, rate_of(measurement)
    steps = 1e-3 * np.concatenate([np.zeros((1, 3)), np.eye(3), np.zeros((others, 3))])
    at = {n: value.take([0, 0, 0, 0, *range(1, others + 1)], axis=0, mode="clip") for n, value in around.items()}
    at[name] = at[name] + steps.reshape((len(steps), *(1 for _ in loop.P.shape[:-2]), 3))
    H: Array = loop.call(f"{measurement}_H", **{**inputs, **at})
    return H


def uninformed(measurement: str, H: Array, R: Array, rows: Array, variances: dict[str, Array], sigmas: float) -> Array:
    """(..., n) bool: the delay, where the rates that make up its column are not clearly above their noise.

    H: of `by_rate`.  R, rows: (..., m).  variances: of `rate_variances`.

    The noise of such a rate passes for a motion that the residual does not follow: for a delay without error, and so
    for knowledge of it.  What it adds is its variance over R, what the motion adds the rate's square over R; over all
    rows that has to be sigmas^2 times as much.  Noise alone gets there once in 1e10 messages, so that the choice of
    messages does not depend on it.
    """
    now, by_axis = H[0, ..., TAU], (H[1:4, ..., TAU] - H[0, ..., TAU]) / 1e-3
    variance = np.einsum("a...m,...a->...m", by_axis**2, variances[rate_of(measurement)])
    weight = rows * (R.min(-1, keepdims=True) / R)  # by the smallest, so that none overflows
    out = np.zeros((*now.shape[:-1], H.shape[-1]), bool)
    out[..., TAU] = np.sum(weight * now**2, axis=-1) <= sigmas**2 * np.sum(weight * variance, axis=-1)
    return out


@dataclass(frozen=True)
class Explanation:
    """Why messages in a row do not fit, run by run."""

    decided: Array  # (...,) bool
    delay: Array  # (...,) weight of all delays, from 0 to 1
    fits: Array  # (...,) bool: the best explanation is as good as chance makes it
    tau: Array  # (...,) s, the delay: mean over all explanations, by weight
    x: Array  # (..., n) mean error of the slave now, and of the delay estimated so far
    P: Array  # (..., n, n)
    offset: Array  # (..., n) error, were it an offset


class Suspects:
    """Explanations of messages that do not fit, each a filter that takes them all, side by side.

    One for each delay on a grid over the kept past, and three for an offset: of velocity, of attitude, of both.  An
    offset may be the master's or the slave's.  Each has the innovations' chi-square, and is charged what so many free
    parameters gain by chance as rarely as the gate opens by chance.
    """

    OFFSETS = (((DV, 100.0),), ((PHI, 1.0),), ((DV, 100.0), (PHI, 1.0)))  # with its sigma, m/s or rad

    def __init__(self, runs: tuple[int, ...], n: int, rules: Rules):
        self.runs, self.n, self.rules = runs, n, rules
        self.lags = np.arange(0.0, rules.buffer_s + 1e-9, rules.half_span_s)
        self.count = np.zeros(runs, int)  # of messages in a row
        self.rows = np.zeros(runs, int)
        self.at = np.zeros(runs)  # s, of the last
        shape = (len(self.lags) + len(self.OFFSETS), *runs)
        self.tau = np.zeros(shape)  # s: the delays of the grid, then for each offset the one estimated
        self.chi2, self.x, self.P = np.zeros(shape), np.zeros((*shape, n)), np.zeros((*shape, n, n))

    def _begin(self, first: Array, P_now: Array, tau_hat: Array, age: Array, now: float) -> None:
        """Anew in the runs (...,) of `first`."""
        grid = len(self.lags)
        tau = np.broadcast_to(tau_hat, self.tau.shape).copy()
        lags = self.lags.reshape((-1, *(1 for _ in self.runs)))
        tau[:grid] = np.clip(lags - age, -LONGEST, LONGEST)
        P = np.broadcast_to(P_now, self.P.shape).copy()
        P[:grid, ..., TAU, :] = P[:grid, ..., :, TAU] = 0.0
        P[:grid, ..., TAU, TAU] = self.rules.half_span_s**2
        for e, offset in enumerate(self.OFFSETS, grid):
            for block, sigma in offset:
                P[e, ..., block, block] += sigma**2 * np.eye(3)
        self.tau, self.chi2 = np.where(first, tau, self.tau), np.where(first, 0.0, self.chi2)
        self.x = np.where(first[..., None], 0.0, self.x)
        self.P = np.where(first[..., None, None], P, self.P)
        self.rows, self.at = np.where(first, 0, self.rows), np.where(first, now, self.at)

    def take(
        self, suspect: Array, late: Array, P_now: Array, loop: Filter, history: History, age: Array, F: Array,
        measured: Mapping[str, tuple[Array, Array]], inputs: dict[str, Any], constants: Mapping[str, Any],
    ) -> Explanation:  # fmt: skip
        """Try the explanations on a message that does not fit in the runs (...,) of `suspect`.

        late: (...,) bool, where it is the stamps that do not fit, so that only delays are tried.
        P_now: of the slave before the message.  age: (...,) s, now less the stamp.  F: as of now.
        measured: by measurement (variances, rows), each (..., m).  inputs: what the message says.
        """
        rules, now = self.rules, float(history.time[-1])
        self._begin(suspect & (self.count == 0), P_now, loop.nav["tau"], age, now)
        eye, dt = np.eye(self.n), (now - self.at)[..., None, None]
        Phi = eye + F * dt + F @ F * dt**2 / 2
        Q = loop.call("Q", **{**inputs, "dt": rules.half_span_s}) * dt / rules.half_span_s
        x, P = np.einsum("...ij,...j->...i", Phi, self.x), Phi @ self.P @ np.swapaxes(Phi, -1, -2) + Q

        lag = np.clip(age + self.tau, -rules.ahead_s, now - history.time[0])
        then = moment(loop, history, now - lag.reshape((len(lag), -1)), rules.half_span_s, constants)[0]
        A = F * lag[..., None, None]
        there = eye - A + A @ A / 2
        given = {**inputs, **then, "lag": np.zeros(lag.shape), "x": np.zeros(self.n)}
        nus, Hs, variances, rows = [], [], [], []
        for name, (variance, there_are) in measured.items():
            z = loop.call(f"{name}_z", **given)
            nus.append(wrapped(z) if name == "euler" else z)
            Hs.append(loop.call(f"{name}_H", **given))
            variances.append(variance)
            rows.append(there_are)
        used = np.concatenate(rows, axis=-1) & suspect[..., None]
        R = np.where(used, np.concatenate(variances, axis=-1), 1.0)
        H = np.where(used[..., None], np.concatenate(Hs, axis=-2) @ there, 0.0)
        nu = np.where(used, np.concatenate(nus, axis=-1), 0.0) - np.einsum("...ij,...j->...i", H, x)
        S = H @ P @ np.swapaxes(H, -1, -2) + R[..., None] * np.eye(R.shape[-1])
        K = np.swapaxes(np.linalg.solve(S, H @ P), -1, -2)
        left = eye - K @ H
        self.x = x + np.einsum("...ij,...j->...i", K, nu)
        self.P = left @ P @ np.swapaxes(left, -1, -2) + (K * R[..., None, :]) @ np.swapaxes(K, -1, -2)
        self.chi2 = self.chi2 + np.einsum("...i,...i->...", nu, np.linalg.solve(S, nu[..., None])[..., 0])
        self.at = np.full(self.runs, now)
        self.count = self.count + suspect
        self.rows = self.rows + used.sum(-1)
        # a delay without a variance is held on purpose, and only a clock set anew may move it
        return self._explanation(loop, late, (P_now[..., TAU, TAU] == 0.0) & ~late)

    def forget(self, where: Array) -> None:
        """The next message that does not fit is the first."""
        self.count = np.where(where, 0, self.count)

    def _explanation(self, loop: Filter, late: Array, held: Array) -> Explanation:
        rules, offsets = self.rules, len(self.OFFSETS)
        parameters = np.array([1] * len(self.lags) + [3 * len(offset) for offset in self.OFFSETS])
        score = self.chi2 + chdtri(parameters, rules.gate).reshape((-1, *(1 for _ in self.runs)))
        tried = np.concatenate([np.where(held, np.inf, score[:-offsets]), np.where(late, np.inf, score[-offsets:])])
        weight = np.exp(-(tried - tried.min(0)) / 2)
        weight /= weight.sum(0)
        delay = weight[:-offsets].sum(0)
        chi2 = np.take_along_axis(self.chi2, np.argmin(tried, axis=0)[None], axis=0)[0]
        fits = chi2 <= chdtri(np.maximum(self.rows, 1), rules.gate)
        # each explanation's error of the delay, as that of the estimate so far
        x = self.x.copy()
        x[..., TAU] += loop.nav["tau"] - self.tau
        mean = np.einsum("e...,e...i->...i", weight, x)
        apart = x - mean
        P = np.einsum("e...,e...ij->...ij", weight, self.P + apart[..., :, None] * apart[..., None, :])
        best = np.argmin(score[-offsets:], axis=0)
        offset = np.take_along_axis(self.x[-offsets:], best[None, ..., None], axis=0)[0]
        clear = ~fits | (np.minimum(delay, 1 - delay) < CLEAR)
        decided = (self.count >= rules.reopen_after) & (clear | (self.count >= 2 * rules.reopen_after))
        return Explanation(decided, delay, fits, loop.nav["tau"] - mean[..., TAU], mean, P, offset)


class Stamps:
    """What the messages' stamps say among themselves: a clock that is set anew for good is followed.

    clock: (...,) s, added to the stamps.  trial: what is to be added besides, while it is looked at, else nan.
    """

    SPREAD_S, SPAN_S = 0.1, 0.4  # how well the ages of refused messages agree, and over how long

    def __init__(self, runs: tuple[int, ...]):
        self.clock, self.trial = np.zeros(runs), np.full(runs, np.nan)
        self.usual = np.full(runs, np.nan)  # s, how old the stamps of messages taken are
        self.count = np.zeros(runs, int)
        self.began, self.age, self.last = (np.zeros(runs) for _ in range(3))

    def refused(self, where: Array, late: Array, came: Array, stamp: Array, now: float, after: int) -> None:
        """Look at the stamps (...,), `clock` in them, that are refused in some runs; begins and ends a trial.

        late: (...,) bool, where a stamp lies in the kept past and only the delay's estimate does not: no clock is set.
        """
        if not (where.any() or self.count.any()):
            return
        age = now - stamp
        goes_on = where & (self.count > 0) & (stamp > self.last) & (np.abs(age - self.age) < self.SPREAD_S)
        first = where & ~goes_on
        self.count = np.where(first, 1, np.where(goes_on, self.count + 1, np.where(came, 0, self.count)))
        self.began, self.age = np.where(first, now, self.began), np.where(first, age, self.age)
        self.last = np.where(where, stamp, self.last)
        self.trial = np.where(came & ~goes_on, np.nan, self.trial)
        due = goes_on & np.isnan(self.trial) & (self.count >= after) & (now - self.began >= self.SPAN_S)
        self.trial = np.where(due, np.where(late, 0.0, self.age - np.nan_to_num(self.usual)), self.trial)

    def end(self, where: Array, follow: Array) -> None:
        """A trial has ended; follow: (...,) bool, the clock is set."""
        self.clock = self.clock + np.where(where & follow, self.trial, 0.0)
        self.trial, self.count = np.where(where, np.nan, self.trial), np.where(where, 0, self.count)

    def taken(self, where: Array, age: Array) -> None:
        usual = np.where(np.isnan(self.usual), age, 0.9 * self.usual + 0.1 * age)
        self.usual = np.where(where, usual, self.usual)


def cause(found: Explanation, run: tuple[int, ...], tau: float, clock_s: float, rules: Rules, late: bool) -> str:
    """What has been found, in words: of one run.

    tau: s, before.  clock_s: by how much the master's clock has been set forward, 0: not.
    late: it was its stamps that did not fit.
    """
    delay, x, ms = found.delay[run], found.offset[run], 1e3 * float(found.tau[run])
    sigma_ms = 1e3 * float(np.sqrt(found.P[run][TAU, TAU]))
    searched = f"another delay (all within buffer_s = {rules.buffer_s:g} s are tried)"
    if late and not found.fits[run]:
        return f"not even with another clock and {searched}: they stay refused; raise buffer_s, or give the delay"
    if not found.fits[run]:
        return f"neither {searched} nor an offset explains them: velocity and attitude are opened and follow the master"
    parts = []
    velocity, turn = x[DV], np.rad2deg(x[PHI])
    if np.linalg.norm(velocity) > 0.1:
        parts.append("the velocity by {:.2f} {:.2f} {:.2f} m/s".format(*-velocity))
    if np.linalg.norm(turn) > 0.1:
        what = "heading" if abs(turn[2]) > 0.9 * np.linalg.norm(turn) else "attitude"
        parts.append(f"the {what} by {{:.2f}} {{:.2f}} {{:.2f}} deg".format(*turn))
    offset = (f"the master is off the slave, {' and '.join(parts) or 'by little'} (north, east, down), by its own "
              "jump or the slave's, which cannot be told apart")  # fmt: skip
    now = f"{ms:.0f} ms" if sigma_ms < 20 else (
        f"{ms:.0f} +- {sigma_ms:.0f} ms, which gets better only as the slave turns or accelerates")  # fmt: skip
    if clock_s:
        way = "forward" if clock_s > 0 else "back"
        change = (f"the master's clock has gone {way} by {abs(clock_s):.3f} s; the delay against its stamps was "
                  f"{1e3 * tau:.0f} ms and is {now}")  # fmt: skip
    elif late:
        change = f"the master's delay is {now}, not the {1e3 * tau:.0f} ms by which its messages were too old"
    else:
        change = f"the master's delay has changed from {1e3 * tau:.0f} to {now}"
    if delay > 1 - CLEAR:
        return change
    if delay < CLEAR:
        return f"{offset}; velocity and attitude are opened and follow the master"
    return f"either {change}, or {offset}: rate and acceleration are too constant to tell, and all of them are opened"
