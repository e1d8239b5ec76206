"""Transfer alignment in flight: a slave's increments in, a master's late and irregular messages in, corrections out."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, Literal

import numpy as np
from scipy.special import chdtri

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.array import Array, carried
from boresight.runtime.calibration import Calibration
from boresight.runtime.filter import Filter, Innovation
from boresight.runtime.transfer.delay import (
    CLEAR,
    Explanation,
    Stamps,
    Suspects,
    by_rate,
    cause,
    rate_variances,
    uninformed,
)
from boresight.runtime.transfer.gaps import Gaps, of_runs
from boresight.runtime.transfer.guard import Guard, mixed, outside
from boresight.runtime.transfer.history import ACCEL_BIAS, DOWN, DV, MOUNT, PHI, TAU, History, moment
from boresight.runtime.transfer.lever import flown
from boresight.runtime.transfer.messages import Heard, Message, Note, Result, Verdict, heard
from boresight.runtime.transfer.position import PositionWatch, moved
from boresight.runtime.transfer.rules import Rules, Watch
from boresight.runtime.transfer.score import Score
from boresight.runtime.transfer.start import SHORTEST, Increments, again, straight
from boresight.runtime.transfer.stretch import Stretch
from boresight.runtime.units import STANDARD_GRAVITY

GYRO, ACCEL = slice(0, 3), slice(3, 6)  # of increments (..., 6)
EARLIER = ("before", "second", "third")
UNKNOWN = np.pi, 100.0  # rad, m/s: one sigma of a run that is lost
SWING_S = 1.0
LARGEST = 0.9  # of the model's range for the error state, in one correction


class Transfer:
    """Transfer alignment in flight: a filter with its past, and rules for faulty input.

    `slave` takes the slave's increments, `master` the master's messages, late, irregular and
    sometimes wrong; each message gets a verdict, and nothing is raised for what comes in.  Leading
    axes are runs.  NED and front-right-down, SI and rad.

    Parameters
    ----------
    model : Library
        `load("velocity-attitude")` or a composition of it.
    nav : mapping of str to array
        As of `Filter`, at `time`; `transfer.first` makes it.
    P : (..., n, n) array
        Covariance of the state at `time`.
    constants : mapping of str to array
        What else the model's functions ask for: `lever_b`, or `lever_m` in the master's axes, m,
        and the root densities of the noises.
    time : float, optional
        s, the slave's clock, of nav and P.
    past : History, optional
        That of `transfer.first`, until `time`; without it messages measured before are too old.
    matching : (str, str), optional
        The velocity's and the attitude's measurement: "velocity", and "dcm", "quaternion" or
        "euler".
    compensation : {"buffer", "extrapolate"}, optional
        Of the delay.  "buffer" compares a message with the slave as it was then, with lag 0;
        "extrapolate" is Kang's: the slave as it is now, carried back along its rate of change by
        lag = tau_hat + what the message's own time says.
    every : int, optional
        Intervals of the slave for one step of the covariance, which is also carried to each
        message.
    rules : Rules, optional
        Those of faulty input.
    known : Calibration, optional
        What is known of the slave's sensors, taken off first; the biases of nav are what is left.
    coning : function, optional
        `load("strapdown").compensated` for coning and sculling by four samples; the step alone does
        it by two.

    Attributes
    ----------
    filter : Filter
        Its x, P, nav and `considered`.
    time : float
        s, of the slave's newest sample.

    Raises
    ------
    BoresightError
        An unknown compensation, a start outside the model's boxes, and what `Filter` refuses.

    Notes
    -----
    When not to use it: for a model that is no velocity-attitude, or with messages that never come
    late; `CompiledFilter` is less and faster.  It exists in Python alone: what is exported as C is
    the filter without these rules.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Message, Transfer, load, transfer
    >>> model, R = load("velocity-attitude"), np.repeat([0.02, 1e-4], 3) ** 2
    >>> noises = {"gyro_noise": 6e-5, "accel_noise": 1e-3, "gyro_bias_noise": 1e-8,
    ...           "accel_bias_noise": 1e-6, "mu_noise": 1e-8}
    >>> constants = {name: np.full(3, density) for name, density in noises.items()}
    >>> constants |= {"tau_noise": 1e-7, "lever_b": np.zeros(3)}
    >>> here = {"v_m_n": [10.0, 0, 0], "q_m2n_wxyz": [1, 0, 0, 0], "position": [0.6, 0.1, 0]}
    >>> sigmas = {"q_b2m_wxyz": 0.02, "gyro_bias": 2e-3, "accel_bias": 0.05, "tau": 0.02}
    >>> nav, P, past = transfer.first(Message(0.0, R, **here), model, constants, sigmas=sigmas,
    ...                               rate_sigma=0.0, acceleration_sigma=0.0)
    >>> loop = Transfer(model, nav, P, constants, past=past)
    >>> for k in range(1, 51):
    ...     loop.slave(0.01 * k, [0, 0, 0], [0, 0, -0.0979], 0.01)
    >>> bool(loop.master(Message(0.45, R, **here)).taken)
    True
    """

    score: Score | None = None  # of a filter with `Sensors(probed=True)`

    def __init__(
        self,
        model: Any,
        nav: Mapping[str, Any],
        P: Any,
        constants: Mapping[str, Any],
        *,
        time: float = 0.0,
        past: History | None = None,
        matching: tuple[str, str] = ("velocity", "dcm"),
        compensation: Literal["buffer", "extrapolate"] = "buffer",
        every: int = 1,
        rules: Rules | None = None,
        known: Calibration | None = None,
        coning: Callable[..., Mapping[str, Array]] | None = None,
    ):
        if compensation not in ("buffer", "extrapolate"):
            raise BoresightError(f"transfer: compensation is {compensation!r}; give 'buffer' or 'extrapolate'")
        self.rules, self.compensation, self.matching = rules or Rules(), compensation, matching
        self.every = every
        self.runs = np.shape(P)[:-2]
        whole = {name: np.asarray(value, float) for name, value in nav.items()}
        self.guard = Guard(flown(model, constants), self.runs)
        self.filter = Filter(
            self.guard,
            {n: np.broadcast_to(v, (*self.runs, *v.shape[-1:])) if n != "tau" else np.broadcast_to(v, self.runs)
             for n, v in whole.items()},
            P,
        )  # fmt: skip
        self.constants = dict(constants)
        self.time = float(time)
        count = int(np.prod(self.runs, dtype=int))
        self.history = History(self.rules.buffer_s, count)
        self._angle, self._push = np.zeros((*self.runs, 3)), np.zeros((*self.runs, 3))
        for sample in past.samples() if past is not None else ():
            self.history.append(**sample)
            self._angle, self._push = (sample[name].reshape((*self.runs, 3)) for name in ("angle", "push"))
        if past is None:
            self._keep()
        self._earlier: list[Array] = []  # the increments of the last intervals, at most three, the newest first
        self._predicted = self.time  # of the covariance
        self._told_of = np.full(self.runs, -np.inf)  # (...,) s, when what was last taken was measured
        self._steps = 0
        self.position = PositionWatch(self.runs, self.time)
        self.watch = Watch(self.rules, self.runs, self.time)
        self.stamps, self.suspects = Stamps(self.runs), Suspects(self.runs, self.filter.P.shape[-1], self.rules)
        self.known, self.coning = known or Calibration(), coning
        standing = (
            np.swapaxes(rotation.matrix_from_quaternion(self.nav["q_b2n_wxyz"]), -1, -2)[..., 2] * -STANDARD_GRAVITY
        )
        self.gaps = Gaps(self.watch, np.concatenate([np.zeros_like(standing), standing], axis=-1))
        self._left_out = 0
        self._stretch: Stretch | None = None  # of many intervals at once, from the first time on
        where, why = outside(model, self.filter.nav, self.runs)
        if where.any():
            raise BoresightError(f"transfer: the slave's {why}")

    @property
    def notes(self) -> list[Note]:
        """One line for each change of verdict."""
        return self.watch.notes

    @property
    def counts(self) -> dict[Verdict, Array]:
        """(...,) by verdict: how many messages came to it."""
        return self.watch.counts

    @property
    def nav(self) -> dict[str, Array]:
        """The slave as it is now."""
        return self.filter.nav

    @property
    def P(self) -> Array:
        """(..., n, n) as of the last message, or of the last step of the covariance."""
        return self.filter.P

    @property
    def lost(self) -> Array:
        """(...,) bool: runs that stand still until a message comes to begin anew from."""
        return self.gaps.lost

    # ---- the slave

    def slave(self, time: Any, dtheta_ib_b: Any, dv_b: Any, dt: Any) -> None:
        """Take increments of the slave: one interval, or several one after the other.

        What is missing between two intervals, or is no number, is bridged up to `bridge_s`; beyond
        it the filter begins anew from the next message.  An interval that begins before the last
        one ended is left out.  Nothing is raised; a note says what happened.

        Parameters
        ----------
        time : float or (K,) array
            s, where the interval ends.
        dtheta_ib_b : (..., 3) or (K, ..., 3) array
            Integral of the measured angular rate over the interval, rad, slave body, biases in it.
        dv_b : (..., 3) or (K, ..., 3) array
            Integral of the measured specific force over the interval, m/s, likewise.
        dt : float or (K,) array
            s, the length of the interval.

        Notes
        -----
        K intervals in one call are the same as one by one, to rounding of P, and take a fraction of
        the time where the intervals are as they should be.
        """
        if np.ndim(time):
            self._intervals(time, dtheta_ib_b, dv_b, dt)
            return
        begin = time - dt
        if not (dt > 0 and begin > self.time - 0.5 * dt and np.isfinite([time, dt]).all()):
            self._overlapping(time, dt)
            return
        self._left_out = 0
        delivered = [np.broadcast_to(np.asarray(part, float), (*self.runs, 3)) for part in (dtheta_ib_b, dv_b)]
        raw = np.concatenate(delivered, axis=-1)
        increments = np.concatenate(self.known.increments(delivered[0], delivered[1], dt), axis=-1)
        good = self.gaps.usable(increments, dt)
        increments = np.where(good[..., None], increments, self.gaps.rates * dt)
        if begin > self.time + 0.5 * dt:
            self._missing(begin, dt, increments / dt)
        more, variance = self.gaps.sample(good, increments / dt, dt, time, self.history, self.P)
        self._interval(time, increments + more, dt)
        self._lose(self.gaps.missing_s > self.rules.bridge_s * (1 + 1e-9))
        self._open(variance)
        if self.rules.full_scale is not None:
            raw = np.where(np.isfinite(raw), raw, 0.0)
            self._open(self.watch.saturation(raw[..., :3], raw[..., 3:], dt))

    def _intervals(self, time: Any, dtheta_ib_b: Any, dv_b: Any, dt: Any) -> None:
        """Those that are as they should be together, the others one by one."""
        time, dt = np.asarray(time, float), np.broadcast_to(np.asarray(dt, float), np.shape(time))
        delivered = [np.asarray(part, float) for part in (dtheta_ib_b, dv_b)]
        if self._stretch is None and self.coning is None:
            self._stretch = Stretch.of(self.guard.model, self.nav, self.P, self.constants)
        sound, increments = self._sound(time, delivered, dt)
        k = 0
        while k < len(time):
            stop = k + int(np.argmin(np.append(sound[k:], False)))
            if stop > k and self._undisturbed(time[k] - dt[k], dt[k]):
                k += self._together(time[k:stop], increments[k:stop], dt[k:stop])
            if k < len(time):
                self.slave(float(time[k]), delivered[0][k], delivered[1][k], float(dt[k]))
                k += 1

    def _sound(self, time: Array, delivered: list[Array], dt: Array) -> tuple[Array, Array]:
        """(K,) bool: intervals with all that they should have, right behind the one before; the increments (K, ..., 6)
        without what is known."""
        behind, count = np.append(0.0, time[1:] - dt[1:] - time[:-1]), len(self.runs)
        sound = (dt > 0) & np.isfinite(dt) & np.isfinite(time) & (np.abs(behind) < 0.5 * dt)
        seconds = np.where(sound, dt, 1.0).reshape((-1, *(1 for _ in self.runs)))
        parts = [part.reshape((len(time), *(1 for _ in range(count + 2 - part.ndim)), *part.shape[1:]))
                 for part in delivered]  # fmt: skip
        dtheta, dv = self.known.increments(parts[0], parts[1], seconds)
        increments = np.concatenate(np.broadcast_arrays(dtheta, dv), axis=-1)
        sound &= self.gaps.usable(increments, seconds[..., None]).reshape(len(time), -1).all(-1)
        for part, full in zip(parts, self.rules.full_scale or (), strict=False):
            sound &= (np.abs(part) < full * seconds[..., None] * (1 - 1e-9)).reshape(len(time), -1).all(-1)
        return sound, increments

    def _undisturbed(self, begin: float, dt: float) -> bool:
        """Whether nothing of the past has a part in what becomes of an interval."""
        gaps, watch = self.gaps, self.watch
        disturbed = (gaps.missing_s, gaps.lost, watch.saturated_s, watch.at_full, self.guard.outside)
        behind = abs(begin - self.time) < 0.5 * dt
        return self._stretch is not None and behind and not any(one.any() for one in disturbed)

    def _together(self, time: Array, increments: Array, dt: Array) -> int:
        """How many of these intervals were flown, all of them but where the model's range ends: as one by one."""
        assert self._stretch is not None
        stretch, history = self._stretch, self.history
        given = np.empty((1 + len(time), *self.runs, 6))
        given[1:] = increments
        given[0] = np.concatenate([self._angle, self._push], axis=-1)
        sums = np.cumsum(given, axis=0)
        given[0] = (self._earlier or given[1:])[0]
        stretch.begin(self.nav, self.P, given, dt)
        k = 0
        while k < len(time):
            end = min(len(time), k + max(1, self.every - self._steps))
            states = stretch.fly(k, end)
            if not states:
                break
            kept = {"v_n": states["v_n"], "q_b2n_wxyz": states["q_b2n_wxyz"],
                    "angle": sums[k + 1 : end + 1, ..., GYRO], "push": sums[k + 1 : end + 1, ..., ACCEL]}  # fmt: skip
            history.extend(time[k:end], **kept)
            self.filter.nav.update({name: value[-1].copy() for name, value in states.items()})
            self.time = self.watch.time = float(time[end - 1])
            self._steps += end - k
            k = end
            if self._steps >= self.every and not self._covariance(stretch):
                break
        if k:
            self._left_out = 0
            self._angle, self._push = sums[k][..., GYRO], sums[k][..., ACCEL]
            self._earlier = [*given[max(1, k - 2) : k + 1][::-1], *self._earlier][:3]
            self.gaps.rates, self.gaps.stood_in = given[k] / dt[k - 1], np.zeros_like(given[k])
            self.filter.P = stretch.loop.P
            if self._steps >= self.every:
                self._covariance()
        return k

    def _missing(self, begin: float, dt: float, rates: Array) -> None:
        """Nothing came until `begin`; the rates (..., 6) are those of the interval that follows."""
        missing, everyone = begin - self.time, np.ones(self.runs, bool)
        if missing > self.rules.bridge_s * (1 + 1e-9) + 1e-9:
            self._lose(everyone, missing)
            self._skip(begin)
            return
        count = round(missing / dt)
        ramp = (rates - self.gaps.rates) / (count + 1)
        for i in range(count):
            between = self.gaps.rates + (i + 1) * ramp
            end = begin - (count - 1 - i) * missing / count
            self.gaps.stand_in(everyone, between, missing / count)
            self._interval(end, between * missing / count, missing / count)

    def _lose(self, where: Array, missing_s: float = 0.0, why: str = "") -> None:
        """These runs have lost their way: attitude and velocity are unknown until they begin anew."""
        new = self.gaps.lose(where, self.P, self.time, missing_s, why)
        if new.any():
            self._open(np.where(new[..., None], np.repeat(UNKNOWN, 3) ** 2, 0.0))

    def _overlapping(self, time: float, dt: float) -> None:
        """An interval begins before the last one ended: left out, unless this goes on; then the clock was set back."""
        everyone = np.ones(self.runs, bool)
        if self._left_out == 0:
            self.watch.note(everyone, f"the slave's interval of {dt:g} s that ends at {time:.4f} s begins before the "
                                      "last one ended, or is none; it is left out")  # fmt: skip
        self._left_out += 1
        if np.isfinite(time) and dt > 0 and self._left_out * dt > max(self.rules.bridge_s, dt):
            self._lose(everyone)
            self._skip(time)

    def _skip(self, time: float) -> None:
        """Time goes on, or back, and nothing of the past is left."""
        self.time = self.watch.time = self._predicted = float(time)
        self.history.clear()
        self._told_of = np.full(self.runs, -np.inf)
        self._earlier, self._steps = [], 0
        self._keep()

    def _interval(self, time: float, increments: Array, dt: float) -> None:
        """Carry the slave over an interval; increments (..., 6) rad and m/s, biases in them."""
        bias = np.concatenate([self.nav["gyro_bias"], self.nav["accel_bias"]], axis=-1) * dt
        earlier, held = [*self._earlier, *3 * [(self._earlier or [increments])[-1]]][:3], dict(self.filter.nav)
        used = increments
        if self.coning is not None:
            sensed = {f"{name}_{which}": (one - bias)[..., part] for which, one in zip(EARLIER, earlier, strict=True)
                      for name, part in (("dtheta", GYRO), ("dv", ACCEL))}  # fmt: skip
            own = (increments - bias)[..., GYRO], (increments - bias)[..., ACCEL]
            made = self.coning(dtheta_ib_b=own[0], dv_b=own[1], **sensed)
            used = np.concatenate([made["dtheta_ib_b"], made["dv_b"]], axis=-1) + bias
        self.filter.strapdown(
            dtheta_ib_b=used[..., GYRO], dv_b=used[..., ACCEL],
            dtheta_before=earlier[0][..., GYRO], dv_before=earlier[0][..., ACCEL], dt=dt, **self.constants,
        )  # fmt: skip
        self._earlier = [increments, *self._earlier[:2]]
        self.time = self.watch.time = float(time)
        self._range(held)
        self._angle, self._push = self._angle + increments[..., GYRO], self._push + increments[..., ACCEL]
        self._keep()
        self._steps += 1
        if self._steps >= self.every:
            self._covariance()

    def _range(self, held: Mapping[str, Array]) -> None:
        """Hold the runs that are lost where they were, those too that are lost from now on, at the range's edge."""
        left, why = self.guard.taken()
        if left.any():
            self._lose(left, why=why)
            held = self.guard.clipped(held)
        if self.lost.any():
            self.filter.nav = mixed(self.lost, held, self.filter.nav)

    def _keep(self) -> None:
        nav = self.filter.nav
        self.history.append(self.time, v_n=nav["v_n"], q_b2n_wxyz=nav["q_b2n_wxyz"], angle=self._angle, push=self._push)

    def _over(self, seconds: Array) -> dict[str, Array]:
        """Mean f_b and omega_ib_b (biases removed) of the last `seconds` (R,), and the attitude in their middle."""
        now = np.full(self.history.runs, self.time)
        nav = self.filter.nav
        f_b, omega_ib_b = (
            self.history.mean(name, now - seconds, now).reshape((*self.runs, 3)) for name in ("push", "angle")
        )
        return {
            "f_b": f_b - nav["accel_bias"],
            "omega_ib_b": omega_ib_b - nav["gyro_bias"],
            "q_b2n_wxyz": self.history.at("q_b2n_wxyz", now - seconds / 2).reshape((*self.runs, 4)),
        }

    def _covariance(self, stretch: Stretch | None = None) -> bool:
        """Carry P up to now, that of a stretch if it is flown; False where that refuses, and all is as it was."""
        dt = self.time - self._predicted
        if dt > 0:
            inputs = {**self._over(np.full(self.history.runs, dt)), **self.constants, "dt": dt}
            if stretch is None:
                self.filter.predict(**inputs)
            elif not stretch.predict(**inputs):
                return False
            self.guard.taken()  # a rate beyond the range is in the slave's own step, if it is
            self._predicted = self.time
            self.watch.silence()
        self._steps = 0
        return True

    def _open(self, variance: Array | None) -> None:
        """P gains so much (..., 6) rad^2 and (m/s)^2 about and along the slave's axes."""
        if variance is None or not variance.any():
            return
        C = rotation.matrix_from_quaternion(self.filter.nav["q_b2n_wxyz"])
        for block, axes in ((PHI, slice(0, 3)), (DV, slice(3, 6))):
            self.filter.P[..., block, block] += (C * variance[..., None, axes]) @ np.swapaxes(C, -1, -2)

    # ---- the master

    def master(self, message: Message) -> Result:
        """Hold a message against the slave, and correct the slave by it, its past included.

        Parameters
        ----------
        message : Message
            What the master reports.

        Returns
        -------
        Result
            `verdict` (...,), what became of it in each run; `taken` (...,) bool; `innovations` by
            measurement; `nis` (...,) and `rows` (...,) of the rows used; `lag` (...,) s, how old
            the message was believed to be.
        """
        self._covariance()
        loop, rules, runs = self.filter, self.rules, self.runs
        attitude = self._attitude_field()
        steepest = loop.model.field["euler_m"]["high"][1]
        given = heard(message, runs, attitude, steepest)
        rows, came = given.rows, given.came
        stamp = given.time + self.stamps.clock
        out_of_step, trial = self._out_of_step(stamp, came & rows.any(-1))
        given = replace(given, time=stamp + np.where(trial, self.stamps.trial, 0.0))
        stamp = given.time
        self.watch.partly(given, attitude)
        faults = list(given.faults)

        # A message that lies ahead is the clocks' fault; an estimate of the delay that says so is the filter's to mend.
        lag = self.time - stamp + loop.nav["tau"]
        lag = np.where(stamp <= self.time + rules.ahead_s, np.maximum(lag, -rules.ahead_s), lag)
        oldest = self.time - self.history.time[0]
        lag = np.where(trial & (self.time - stamp <= oldest), np.minimum(lag, oldest), lag)
        copied = came & (given.count == self.watch.count)
        faults.append((copied, "its counter, {count:.0f}, is that of the last one"))
        faults.append(
            (self.gaps.left, "the slave has left the model's range, and this is no message to begin anew from")
        )
        verdict = np.full(runs, int(Verdict.TAKEN))
        for code, where in (
            (Verdict.REPEATED, copied),
            (Verdict.OUT_OF_ORDER, (stamp <= self.watch.stamp) & ~trial),
            (Verdict.TOO_OLD, lag > oldest),
            (Verdict.AHEAD, ~(lag >= -rules.ahead_s)),
            # what the slave missed since cannot be told from what it missed before, nor its rates be trusted
            (
                Verdict.MISSED,
                (self.gaps.missing_s > 0) | (self.gaps.missed_at > self.time - lag - 3 * rules.half_span_s),
            ),
            (Verdict.SATURATED, self.watch.saturated_at.max(-1) > self.time - lag - 3 * rules.half_span_s),
            (Verdict.MISSED, self.gaps.lost),
            (Verdict.BEYOND, self.gaps.left),
            (Verdict.INVALID, ~rows.any(-1)),
            (Verdict.ABSENT, ~came),
        ):
            verdict[where] = code
        begun = self._begin_anew(given, lag)
        verdict[begun] = Verdict.BEGUN
        self.suspects.forget(begun)
        if len(self.history) < 2:
            verdict[came & ~self.gaps.lost] = Verdict.TOO_OLD
            return self.watch.result(
                verdict, {}, np.zeros(runs), np.zeros(runs, int), lag, given, oldest, faults, verdict
            )
        believed, lag = lag, np.where(verdict == Verdict.TAKEN, lag, 0.0)

        variance, step = loop.P[..., TAU, TAU], 2 * rules.half_span_s
        # 10 ms: a turn that changes by 1 rad/s^2 leaves 0.05 mrad
        curved = variance >= (step / 4) ** 2
        around, rate_factor = self._match(lag + np.array([0.0, -step, step][: 3 if curved.any() else 1]).reshape(
            (-1, *(1 for _ in runs))))  # fmt: skip
        inputs = self.constants | {name: value[0] for name, value in around.items()}
        expected = loop.call("expected", **inputs)
        said = self._filled(given.said, rows, expected)
        inputs |= said
        R = given.R.copy()
        # the gyros' own noise comes with the rate into the lever arm's velocity
        noise = np.max(np.asarray(self.constants["gyro_noise"]), axis=-1)
        R[..., :3] += (np.sum(np.square(self._lever()), axis=-1) * noise**2 * rate_factor)[..., None]
        Hs = {name: by_rate(loop, name, inputs, around) for name, _, field in self._measured() if field in inputs}
        if curved.any():
            R += self._curved(curved * variance**2, Hs, stamp - self.watch.stamp)

        # The residual speaks of the error at the message's time: the covariance goes there and comes back.
        # It says nothing of the noise since then, which leaves P for that time; by extrapolation that noise is in it.
        since = {**inputs, **self._over(np.maximum(lag, 2 * rules.half_span_s).reshape(-1))}
        F = loop.call("F", **since)
        # Of the noise before the last message that was taken P has been told: a delay found longer takes none out.
        noisy = np.maximum(np.minimum(lag, self.time - self._told_of), SHORTEST)
        Q = loop.call("Q", **{**since, "dt": noisy}) if self.compensation == "buffer" else np.zeros_like(F)
        # of a state that nothing moves the row is that of the identity, and so it is beyond the last that moves
        moving = slice(0, 1 + int(np.max(np.nonzero(F.any(-1))[-1], initial=0)))
        A = F[..., moving, :] * lag[..., None, None]
        half = A[..., moving] @ A / 2
        eye = np.eye(*A.shape[-2:])
        there, back = eye - A + half, eye + A + half
        P_before = loop.P
        P_now = P_before + self._tilted(F)
        P = carried(P_now - Q, moving, there)
        rows = rows & (verdict == Verdict.TAKEN)[..., None]
        repeated = self.watch.repeats(said, rows, expected, self._expected_variance(P, Hs, inputs), R)
        verdict[repeated] = Verdict.REPEATED
        faults.append((repeated, "the master repeats its last one while the slave moves"))
        rows = rows & ~repeated[..., None]
        variances = rate_variances(self.history, rules, P, F, inputs, rate_factor, self._lever())
        innovations = self._update(P, R, rows, inputs, Hs, variances)
        used = rows.sum(-1)
        # The gate presumes residuals that are linear in the errors: until angles and delay are known it is open.
        sigma = np.sqrt(np.einsum("...ii->...i", P_now))
        coarse = (sigma[..., self._angles()].max(-1) > rules.coarse_rad) | (sigma[..., TAU] > rules.coarse_s)
        fine = self.watch.fine(coarse, used > 0)
        if self.matching[0] in innovations:
            self.watch.lever(innovations[self.matching[0]], rows[..., :3] & fine[..., None], inputs)
        nis = np.sum([part.nis for part in innovations.values()], axis=0)
        none = np.zeros((*runs, 3))
        by_row = [np.where((one := innovations[name]).used, one.nu**2 / one.S, none) if name in innovations else none
                  for name in self.matching]  # fmt: skip
        worst = np.argmax(np.concatenate(by_row, axis=-1), axis=-1)
        gated = ((nis > chdtri(np.maximum(used, 1), rules.gate)) & fine) | (trial & (used > 0))
        self.suspects.forget((used > 0) & ~gated)
        reopen = by_delay = np.zeros(runs, bool)
        beyond, why = self.guard.taken()
        if gated.any():
            found = self._explain(gated, trial, P_now, F, R, rows, stamp, inputs)
            self.guard.taken()  # an explanation beyond the model's range is no fault of the message
            reopen, by_delay = found.decided & gated, found.decided & gated & (found.delay > CLEAR) & found.fits
            by_offset = reopen & ~by_delay & ~trial
            if by_offset.any():
                P = P + self._opening(by_offset, rows, inputs)
                self._update(P, R, rows, inputs, Hs, variances)
            failed = reopen & trial & ~by_delay
            self.suspects.forget(reopen)
            self.stamps.end(reopen & trial, by_delay)
            reopen = reopen & ~failed
        verdict[gated] = Verdict.GATED
        verdict[trial & gated] = out_of_step[trial & gated]
        verdict[reopen] = Verdict.REOPENED
        # A correction beyond the model's range is made in part, and the covariance stays as wide as it was.
        reach = np.max(np.abs(loop.x) / np.array(loop.model.field["x"]["high"]), axis=-1)
        part = np.where(
            beyond | (verdict > Verdict.REOPENED), 0.0, np.minimum(1.0, LARGEST / np.maximum(reach, 1e-300))
        )
        opened = carried(P, moving, back) + Q if reopen.any() else P_now
        corrected = np.where(
            (part == 1.0)[..., None, None], carried(loop.P, moving, back) + Q,
            np.where(reopen[..., None, None], opened, P_now),
        )  # fmt: skip
        loop.x = part[..., None] * loop.x
        loop.x[..., moving] = (back @ loop.x[..., None])[..., 0]
        if by_delay.any():
            corrected = np.where(by_delay[..., None, None], found.P + Q, corrected)
            loop.x = np.where(by_delay[..., None], found.x, loop.x)
        nav = loop.call("feedback")
        for where, reason in (self.guard.taken(), outside(loop.model, nav, runs)):
            beyond, why = beyond | where, why or reason
        faults.append((beyond, f"the slave, or what the message makes of it, is beyond the model's range: {why}"))
        verdict[beyond & (verdict <= Verdict.REOPENED)] = Verdict.BEYOND
        taken = verdict <= Verdict.REOPENED
        self.stamps.taken(taken, self.time - stamp)
        self._told_of = np.where(taken, self.time - lag, self._told_of)
        if self.score is not None:
            self.score.end(taken)
        loop.P = np.where(taken[..., None, None], self._turned(corrected, nav), P_before)
        loop.x = np.where(taken[..., None], loop.x, 0.0)
        self._correct_past(F)
        self.guard.taken()
        loop.nav = loop.nav | mixed(taken, nav, {name: loop.nav[name] for name in nav})
        loop.x = np.zeros_like(loop.x)
        if given.position is not None:
            self._position(given.position, given.position_sigma, taken & ~begun, believed)
        return self.watch.result(verdict, innovations, nis, used, believed, given, oldest, faults, worst)

    def _out_of_step(self, stamp: Array, came: Array) -> tuple[Array, Array]:
        """The verdict (...,) on stamps that do not fit the slave's time, and whether another clock is tried there."""
        rules = self.rules
        lag = self.time - stamp + self.filter.nav["tau"]
        verdict = np.full(self.runs, int(Verdict.TAKEN))
        verdict[stamp <= self.watch.stamp] = Verdict.OUT_OF_ORDER
        known = self.time - self.history.time[0]
        too_old = (lag > known) & (known >= rules.buffer_s)
        verdict[too_old] = Verdict.TOO_OLD
        verdict[stamp > self.time + rules.ahead_s] = Verdict.AHEAD
        came = came & np.isfinite(stamp)
        late = too_old & (stamp > self.watch.stamp) & (self.time - stamp <= known)
        self.stamps.refused(came & (verdict != Verdict.TAKEN), late, came, stamp, self.time, rules.reopen_after)
        trial: Array = came & (verdict != Verdict.TAKEN) & ~np.isnan(self.stamps.trial)
        return verdict, trial

    def _explain(
        self, gated: Array, trial: Array, P_now: Array, F: Array, R: Array, rows: Array, stamp: Array,
        inputs: dict[str, Any],
    ) -> Explanation:  # fmt: skip
        """What explains messages that do not fit, and a note where that is decided."""
        tau, age = self.filter.nav["tau"], self.time - stamp
        fields = (("v_m_n", slice(0, 3)), (self._attitude_field(), slice(3, 6)))
        measured = {name: (R[..., part], rows[..., part])
                    for name, (field, part) in zip(self.matching, fields, strict=True) if field in inputs}  # fmt: skip
        inputs = inputs | self._over(np.full(self.history.runs, 2 * self.rules.half_span_s))
        found = self.suspects.take(gated, trial, P_now, self.filter, self.history, age, F, measured, inputs,
                                   self.constants)  # fmt: skip
        change = found.tau - tau
        # stamps that have become older by as much as the delay has become shorter are a clock's
        older = age - np.nan_to_num(self.stamps.usual, nan=np.inf)
        clock = np.where(np.abs(older + change) < np.abs(change) / 2, change, 0.0)
        clock = np.where(trial, -self.stamps.trial, clock)
        told_at = self.watch.told_at[Verdict.REOPENED]
        again = self.time - told_at < self.rules.quiet_s
        tell = found.decided & gated & ~(again & ((found.delay < CLEAR) | ~found.fits))
        for run in map(tuple, np.argwhere(tell)):
            where = np.zeros(self.runs, bool)
            where[run] = True
            text = cause(found, run, float(tau[run]), float(clock[run]), self.rules, bool(trial[run]))
            self.watch.note(where, f"{self.suspects.count[run]} messages in a row did not fit: {text}")
            self.watch.told_at[(Verdict.REOPENED, *run)] = self.time
        return found

    def _begin_anew(self, given: Heard, lag: Array) -> Array:
        """(...,) bool: the lost runs that have begun anew from this message, which is used up by it."""
        gaps, loop, history, span = self.gaps, self.filter, self.history, 4 * self.rules.half_span_s
        said = {"position": given.position, **given.said}
        ready = gaps.lost & given.rows.all(-1) & (given.time > self.watch.stamp) & (lag >= 0)
        ready = ready & (self.time - lag - span >= gaps.back_at)
        if given.position is None or len(given.said) < 2:
            return np.zeros(self.runs, bool)
        there = {"lat_lon_height": given.position, "v_n": given.said["v_m_n"]}
        ready = ready & ~outside(loop.model, there, self.runs)[0]
        if not ready.any():
            return ready
        # what the other runs are given is finite, and what comes of it is not used
        place = {"position": loop.nav["lat_lon_height"], "v_m_n": loop.nav["v_n"], "q_m2n_wxyz": loop.nav["q_b2n_wxyz"],
                 "euler_m": np.zeros((*self.runs, 3))}  # fmt: skip
        whole = Message(
            np.where(ready, given.time, np.min(given.time[ready])), of_runs(ready, given.R, np.ones((*self.runs, 6))),
            **{name: of_runs(ready, value, place[name]) for name, value in said.items()},
        )  # fmt: skip
        sums = [history.recent(name).reshape((len(history), *self.runs, 3)) for name in ("angle", "push")]
        nav, P, past = again(
            whole, loop.model, self.constants, loop.nav, of_runs(ready, gaps.P, loop.P),
            seconds=np.where(ready, np.maximum(self.time - gaps.lost_at, 0.0), 0.0),
            increments=Increments(history.time[:-1], history.time[1:], *(np.diff(one, axis=0) for one in sums)),
            matching=self.matching, half_span_s=self.rules.half_span_s,
        )  # fmt: skip
        self.guard.taken()  # of runs that do not begin
        assert past is not None
        loop.nav = {name: of_runs(ready, nav[name], value) for name, value in loop.nav.items()}
        loop.P = of_runs(ready, P, loop.P)
        again_known = history.time >= past.time[0]
        times = np.broadcast_to(history.time[again_known, None], (int(again_known.sum()), history.runs))
        for name in ("v_n", "q_b2n_wxyz"):
            kept = history.recent(name)[again_known]
            history.recent(name)[again_known] = np.where(ready.reshape(-1, 1), past.at(name, times), kept)
        gaps.found(ready, past.time[0])
        self.position.begin(ready, self.time, loop.nav["lat_lon_height"], given.position_sigma)
        return ready

    def _update(
        self, P: Array, R: Array, rows: Array, inputs: dict[str, Any], Hs: dict[str, Array], variances: dict[str, Array]
    ) -> dict[str, Innovation]:
        """Attitude first: the residual of a large turn depends on x, and that of the velocity does not.

        Hs: of `by_rate`.  variances: of the rates in the delay's column, which decide whether a measurement informs the
        delay.
        """
        self.filter.x, self.filter.P = np.zeros(P.shape[:-1]), P
        C_b2m, C_b2n = rotation.matrix_from_quaternion(np.array([self.nav["q_b2m_wxyz"], inputs["q_b2n_wxyz"]]))
        heading = np.zeros(P.shape[:-1])  # of the mounting, which alone keeps it where the slave's attitude is opened
        heading[..., MOUNT] = (C_b2m @ C_b2n[..., DOWN, :, None])[..., 0]
        if self.score is not None:
            self.score.begin()
        out = {}
        for name, part, field in self._measured():
            if field in inputs:
                R_part, there, H = R[..., part], rows[..., part], Hs[name][0]
                kept = uninformed(name, Hs[name], R_part, there, variances, self.rules.delay_sigmas)
                if self.score is not None:
                    nu = self.filter.call(f"{name}_z", **inputs) - np.einsum("...ij,...j->...i", H, self.filter.x)
                    self.score.take(nu, H, self.filter.P, R_part, there)
                if self.filter.considered is not None:
                    kept = kept | self.filter.considered
                x, P = self.filter.x, self.filter.P
                out[name] = self.filter.update(name, R_part, rows=there, considered=kept, jacobian=H, **inputs)
                self._keep_heading(heading, x, P, H, R_part, there, kept)
        return out

    def _measured(self) -> tuple[tuple[str, slice, str], ...]:
        """Measurements in their order, the rows of each, and the field that the message says it by."""
        attitude, velocity = slice(3, 6), slice(0, 3)
        return (self.matching[1], attitude, self._attitude_field()), (self.matching[0], velocity, "v_m_n")

    def _attitude_field(self) -> str:
        return "euler_m" if self.matching[1].startswith("euler") else "q_m2n_wxyz"

    def _angles(self) -> list[int]:
        """Where in the error state angles stand that the model bounds."""
        names = getattr(self.filter.model, "states", ())
        return [i for i, name in enumerate(names) if name.startswith(("phi", "dmu"))] or [0, 1, 2]

    def _expected_variance(self, P: Array, Hs: dict[str, Array], inputs: dict[str, Any]) -> Array:
        """(..., 6) of the velocity and the attitude (about the axes n) that are expected of the master."""
        H = np.concatenate(
            [Hs[name][0] if name in Hs else self.filter.call(f"{name}_H", **inputs) for name in ("velocity", "dcm")],
            axis=-2,
        )
        variance: Array = np.sum((H @ P) * H, axis=-1)
        return variance

    def _filled(self, said: dict[str, Array], rows: Array, expected: dict[str, Array]) -> dict[str, Array]:
        """Where rows are missing, the expected values: masked, but within the model's range."""
        out = {}
        for name, value in said.items():
            if name == "q_m2n_wxyz":
                out[name] = np.where(rows[..., 3:].any(-1, keepdims=True), value, expected[name])
            elif name == "euler_m":
                box = self.filter.model.field[name]
                euler = rotation.euler_from_matrix(rotation.matrix_from_quaternion(expected["q_m2n_wxyz"]))
                euler = np.clip(euler, box["low"], box["high"])
                out[name] = np.where(rows[..., 3:], value, euler)
            else:
                out[name] = np.where(rows[..., :3], value, expected[name])
        return out

    def _match(self, lag: Array) -> tuple[dict[str, Any], Array]:
        """The slave so long ago (K, ...), or now, and its rates; and the variance of the first of these rates over the
        gyros' density."""
        kept = np.zeros_like(lag)
        back, lag = (lag, kept) if self.compensation == "buffer" else (kept[:1], lag)
        at = self.time - back.reshape(len(back), -1)
        state, rate_factor = moment(self.filter, self.history, at, self.rules.half_span_s, self.constants)
        return state | {"lag": lag}, rate_factor[0]

    def _position(self, said: Array, sigma: Array, taken: Array, lag: Array) -> None:
        """The master's position, carried to now, where it fits to the slave's own way since the last one."""
        loop = self.filter
        usable = (taken & np.isfinite(said).all(-1))[..., None]
        way = loop.nav["v_n"] * lag[..., None] * np.array([1.0, 1.0, -1.0])
        said = np.where(usable, moved(np.where(usable, said, 0.0), np.where(usable, way, 0.0)), np.nan)
        box = loop.model.field["lat_lon_height"]
        used = self.position.takes(
            self.time, said, sigma, loop.nav["lat_lon_height"],
            np.sqrt(np.einsum("...ii->...i", loop.P)[..., DV].max(-1)),
            np.linalg.norm(np.broadcast_to(self._lever(), said.shape), axis=-1),
            (np.array(box["low"]), np.array(box["high"])), self.watch.note,
        )  # fmt: skip
        loop.nav["lat_lon_height"] = np.where(used[..., None], said, loop.nav["lat_lon_height"])

    def _lever(self) -> Array:
        """(..., 3) m as it is believed, in the axes that it is given in."""
        for name in ("lever_m", "lever_b"):
            if name in self.constants:
                return np.asarray(self.constants[name], float)
        return self.filter.nav["lever_b"]

    def _tilted(self, F: Array) -> Array:
        """(..., n, n) to add to P: what the attitude's error does to the specific force in the second order.

        That is phi x (phi x f) / 2.  At rest it is constant, and the accelerometers' bias follows it.  So the rate of
        the velocity's error is known to twice its variance at best: it is off by that, and by what follows it.
        """
        P, out = self.filter.P, np.zeros_like(self.filter.P)
        f = F[..., (5, 3, 4), (1, 2, 0)]  # of [f x], which turns phi into the rate of the velocity's error
        A = np.eye(3)[:, :, None] * f[..., None, None, :]  # A[i] is the matrix of its i-th component in phi
        A = (A + np.swapaxes(A, -1, -2)) / 2 - f[..., :, None, None] * np.eye(3)
        by = A @ P[..., None, PHI, PHI]
        mean = np.einsum("...ijj->...i", by)
        square = (mean[..., :, None] * mean[..., None, :] + 2 * np.einsum("...ijk,...lkj->...il", by, by)) / 4
        known = F[..., DV, :] @ P @ np.swapaxes(F[..., DV, :], -1, -2)
        size, axes = np.linalg.eigh(2 * square - known)
        # about the slave's axes; a bias that is held on purpose has no variance and gets none
        axes = np.swapaxes(F[..., DV, ACCEL_BIAS], -1, -2) @ axes
        axes = axes * (np.einsum("...ii->...i", P)[..., ACCEL_BIAS, None] > 0)
        fine = np.einsum("...ii->...i", P)[..., PHI].max(-1) < self.rules.coarse_rad**2  # else no order says enough
        axes = axes * fine[..., None, None]
        out[..., ACCEL_BIAS, ACCEL_BIAS] = (axes * np.maximum(size, 0.0)[..., None, :]) @ np.swapaxes(axes, -1, -2)
        return out

    def _turned(self, P: Array, nav: Mapping[str, Array]) -> Array:
        """P with the errors of attitude and mounting about the axes of nav, corrected, as they were about the old ones.

        So phi - C_m2n dmu, which alone shows at rest, stays the same sum, whatever noise the corrections bring into C.
        """
        C = rotation.matrix_from_quaternion(
            np.array([[of[name] for of in (self.nav, nav)] for name in ("q_b2n_wxyz", "q_b2m_wxyz")])
        )
        for block, (old, new) in zip((PHI, MOUNT), C, strict=True):
            T = np.zeros((*P.shape[:-2], 3, P.shape[-1]))
            T[..., block] = (np.eye(3) + new @ np.swapaxes(old, -1, -2)) / 2
            P = carried(P, block, T)
        return P

    def _keep_heading(self, w: Array, x: Array, P: Array, H: Array, R: Array, rows: Array, kept: Array) -> None:
        """Take back what a measurement says of the heading by noise alone; as `uninformed` does with the delay.

        w: (..., n) the heading's row.  x, P: before.  H, R, rows: its own.  kept: (..., n) the states considered in it.
        The heading is here what turns slave and mounting about the vertical together.  It shows as the hull moves, and
        noise of the slave's sensors passes for that; so the residual's part by it has to be above the part by all else.
        """
        Pw, HP = (P @ w[..., None])[..., 0], H @ P
        level = np.sum(w * Pw, axis=-1)
        by = (HP @ w[..., None])[..., 0] / np.maximum(level, 1e-300)[..., None]
        rest = np.sum(H * HP, axis=-1) - by**2 * level[..., None]
        weight = rows * (R.min(-1, keepdims=True) / R)
        blind = np.sum(weight * by**2, axis=-1) <= self.rules.delay_sigmas**2 * np.sum(weight * rest, axis=-1)
        # an attitude that is unknown, or was opened, is corrected whatever else that does
        blind = blind & (np.einsum("...ii->...i", P)[..., PHI].max(-1) < self.rules.coarse_rad**2)
        if not blind.any():
            return
        u = np.where(blind[..., None] & ~kept, w + (np.arange(P.shape[-1]) == DOWN), 0.0)
        # the gain less u times its row of the heading: P gains S times the outer product of what is left out
        gained = Pw - (self.filter.P @ w[..., None])[..., 0]
        out = np.where(kept, gained, 0.0) + u * np.sum(w * gained, axis=-1, keepdims=True) / 2
        both = u[..., :, None] * out[..., None, :]
        self.filter.P = self.filter.P + both + np.swapaxes(both, -1, -2)
        self.filter.x = self.filter.x - u * np.sum(w * (self.filter.x - x), axis=-1, keepdims=True)

    def _curved(self, fourth: Array, Hs: dict[str, Array], since: Array) -> Array:
        """(..., 6) variance of the residuals by the delay's error d in the second order, E[d^4] = 3 sigma^4.

        It is one error in all messages of a swing, so that SWING_S of messages weigh as one.  fourth: (...,) sigma^4.
        Hs: of `by_rate`, at two other times, later and earlier.  since: (...,) s.
        """
        rows = [Hs[name][-2:, ..., TAU] if name in Hs else np.zeros(3) for name in self.matching]
        later, earlier = np.concatenate([np.broadcast_to(row, (2, *self.runs, 3)) for row in rows], axis=-1)
        messages = np.maximum(1.0, SWING_S / np.fmax(since, 1e-3))
        change = (later - earlier) / (4 * self.rules.half_span_s)
        curved: Array = 0.75 * (messages * fourth)[..., None] * np.square(change)
        return curved

    def _opening(self, reopen: Array, rows: Array, inputs: dict[str, Any]) -> Array:
        """(..., n, n) to add to P: velocity and attitude may be off by what the residuals are."""
        out = np.zeros((*self.runs, *self.filter.P.shape[-2:]))
        for name, part, block in zip(self.matching, (slice(0, 3), slice(3, 6)), (DV, PHI), strict=True):
            if (self._attitude_field() if part.start else "v_m_n") not in inputs:
                continue
            z = np.where(rows[..., part], self.filter.call(f"{name}_z", **inputs), 0.0)
            largest = np.where(reopen, np.square(z).max(-1), 0.0)
            out[..., block, block] = largest[..., None, None] * np.eye(3)
        return out

    def _correct_past(self, F: Array) -> None:
        """Take out of the kept samples what the feedback takes out of now: the error was x - F x age, age ago."""
        loop, history = self.filter, self.history
        age = (history.time - self.time).reshape((-1, *(1 for _ in self.runs), 1))
        x = age * (F @ loop.x[..., None])[..., 0]
        x += loop.x
        shape = (len(history), *self.runs)
        past = {name: history.recent(name).reshape((*shape, -1)) for name in ("v_n", "q_b2n_wxyz")}
        # what else is corrected has no past
        rest = {name: straight(loop.model, name) for name in loop.model.feedback.fields if name not in ("x", *past)}
        corrected = loop.call("feedback", x=x, **rest, **past)
        for name in past:
            history.recent(name)[:] = corrected[name].reshape((len(history), history.runs, -1))
