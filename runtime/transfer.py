"""Transfer alignment in flight: a slave's increments in, a master's late and irregular messages in, corrections out.

`Transfer` flies the model `velocity-attitude`, or a composition of it.  It keeps the slave's last half second or so, so
that a message is held against the slave as it was when the master measured; what it does with a message that it cannot
use, and with a slave at full scale, are the rules of docs/transfer-alignment.md.  Nothing is printed: each message gets
a verdict, each change of verdict one line in `notes`.

Axes: `runs`, the leading axes of P, then components.  The slave's clock is one for all runs; the master's messages have
their own times, run by run.  Units SI and rad, NED and front-right-down.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import Any, Literal

import numpy as np
from scipy.special import chdtri

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.filter import Filter, Innovation

PHI, DV, TAU = slice(0, 3), slice(3, 6), 15  # of the error state
LARGEST = 0.45  # rad in one correction; the model's own range ends at 0.5


class Verdict(IntEnum):
    """What became of a message; from GATED on it was refused."""

    TAKEN = 0
    REOPENED = 1  # taken after several refused in a row, with velocity and attitude opened
    ABSENT = 2  # nothing came: every row is masked
    GATED = 3  # NIS beyond the gate
    INVALID = 4  # nothing usable in it: not finite, or no velocity and no attitude at all
    OUT_OF_ORDER = 5  # not newer than the last one
    AHEAD = 6  # measured later than the slave's newest sample
    TOO_OLD = 7  # measured before the oldest sample kept
    REPEATED = 8  # the same numbers again although the slave has moved
    SATURATED = 9  # measured while the slave was at full scale, or just before


@dataclass(frozen=True)
class Rules:
    """What the filter does with input that is not as it should be."""

    buffer_s: float = 0.5  # how much of the slave's past is kept
    ahead_s: float = 0.02  # how far beyond the newest sample a message may lie; the slave is extrapolated
    half_span_s: float = 0.02  # rates are means, and rates of change differences, over twice this
    gate: float = 1e-6  # a message is refused if its NIS would be exceeded by chance this often
    coarse_rad: float = 0.1  # at first the gate is open while the sigma of an angle is above this,
    coarse_s: float = 0.05  # or that of the delay above this,
    settle_s: float = 5.0  # and so long after that
    reopen_after: int = 5  # messages gated in a row
    silent_s: float = 1.0  # without a message taken, after which a note says so
    full_scale: tuple[float, float] | None = None  # of the slave: rad/s, m/s^2
    overshoot: float = 0.5  # one sigma of what a saturated axis misses, as a part of full scale
    quiet_s: float = 5.0  # the same verdict on the same run is told again only after this

    def __post_init__(self) -> None:
        for name in ("buffer_s", "half_span_s", "gate", "silent_s"):
            if not getattr(self, name) > 0:
                raise BoresightError(f"transfer: {name} is {getattr(self, name)}; it must be above zero")
        if self.reopen_after < 1:
            raise BoresightError(f"transfer: reopen_after is {self.reopen_after}; it must be at least 1")


@dataclass(frozen=True)
class Message:
    """What the master says.  R, rows: velocity's three rows, then attitude's (axes n, or roll pitch yaw for euler)."""

    time: Any  # (...,) s, slave's clock: when it was measured, or, where only that is known, when it arrived
    R: Any  # (..., 6) variances, (m/s)^2 and rad^2
    v_m_n: Any = None  # (..., 3) m/s
    q_m2n_wxyz: Any = None  # (..., 4)
    euler_m: Any = None  # (..., 3) rad, instead of the quaternion, for the measurement `euler`
    position: Any = None  # (..., 3) latitude, longitude, height
    rows: Any = True  # (..., 6) bool, False for what is missing; all False: nothing came to this run


@dataclass(frozen=True)
class Result:
    """What one message did, run by run."""

    verdict: Array  # (...,) of Verdict
    innovations: dict[str, Innovation]  # by measurement; also of what was then gated
    nis: Array  # (...,) of all rows together, before the gate
    rows: Array  # (...,) how many rows that is
    lag: Array  # (...,) s, how old the message was believed to be

    @property
    def taken(self) -> Array:
        """(...,) bool."""
        return self.verdict <= Verdict.REOPENED


@dataclass(frozen=True)
class Note:
    """One line for the user."""

    time: float
    runs: Array  # (K,) flat numbers of the runs it is about
    text: str

    def __str__(self) -> str:
        return f"{self.time:.3f} s: {self.text}"


SIZES = {"v_n": 3, "q_b2n_wxyz": 4, "angle": 3, "push": 3}  # angle, push: sums of the increments as delivered


class History:
    """The slave's last samples: (K, R, size) each, R runs, oldest first."""

    def __init__(self, seconds: float, runs: int):
        self.seconds, self.runs = seconds, runs
        self.start = self.end = 0
        self.times = np.empty(64)
        self.values = {name: np.empty((64, runs, size)) for name, size in SIZES.items()}

    def _allocate(self, rows: int) -> None:
        """Room for so many samples, those kept at its beginning."""
        count, times = len(self), np.empty(rows)
        values = {name: np.empty((rows, self.runs, size)) for name, size in SIZES.items()}
        times[:count] = self.time
        for name, array in values.items():
            array[:count] = self.recent(name)
        self.times, self.values, self.start, self.end = times, values, 0, count

    def append(self, time: float, **values: Array) -> None:
        """A sample; drops what is older than `seconds`, but for one sample, so that all of `seconds` is covered."""
        if self.end == len(self.times):  # twice the room that is used, so that this is rare
            self._allocate(max(64, 2 * (self.end - self.start) + 2))
        self.times[self.end] = time
        for name, value in values.items():
            self.values[name][self.end] = value.reshape(-1, SIZES[name])
        self.end += 1
        while self.end - self.start > 2 and self.times[self.start + 1] < time - self.seconds:
            self.start += 1

    def __len__(self) -> int:
        return self.end - self.start

    def recent(self, name: str) -> Array:
        """(K, R, size), a view."""
        return self.values[name][self.start : self.end]

    @property
    def time(self) -> Array:
        """(K,) s, a view."""
        return self.times[self.start : self.end]

    def at(self, name: str, times: Array) -> Array:
        """(..., R, size) at times (..., R), on the chord between two samples, extended beyond the first and last."""
        i = np.clip(np.searchsorted(self.time, times, "right") - 1, 0, len(self) - 2) + self.start
        part = ((times - self.times[i]) / (self.times[i + 1] - self.times[i]))[..., None]
        run = np.arange(self.runs)
        low, high = self.values[name][i, run], self.values[name][i + 1, run]
        if name == "q_b2n_wxyz":
            high = np.where(np.sum(low * high, axis=-1, keepdims=True) < 0, -high, high)
        value = low + part * (high - low)
        if name == "q_b2n_wxyz":  # 1 rad/s for 10 ms: the chord leaves the arc by 1e-8 rad
            value /= np.linalg.norm(value, axis=-1, keepdims=True)
        return value


@dataclass(frozen=True)
class LeverSeen:
    """How far the velocity residuals move with the turning of the hull: the sums of a least-squares fit, run by run.

    A lever arm that is wrong by d puts -C (omega x d) into them.  The filter follows part of it, so that the fit shows
    that a lever arm is wrong, and not by how much.  No message weighs more than one that just fits.
    """

    N: Array  # (..., 3, 3)
    b: Array  # (..., 3)
    square: Array  # (...,) of the residuals over their sigmas
    messages: Array  # (...,)
    large: Array  # (...,) messages beyond the 95 % bound

    @staticmethod
    def nothing(runs: tuple[int, ...]) -> "LeverSeen":
        return LeverSeen(np.zeros((*runs, 3, 3)), np.zeros((*runs, 3)), *(np.zeros(runs) for _ in range(3)))

    def with_message(self, z: Array, S: Array, rows: Array, C_b2n: Array, omega_ib_b: Array) -> "LeverSeen":
        """z, S, rows: (..., 3) residuals, variances, and which there are."""
        A = -C_b2n @ np.cross(omega_ib_b[..., None, :], -np.eye(3))  # omega x d is the matrix of rows -omega x e_i
        nis = np.sum(rows * z**2 / S, axis=-1)
        weight = rows / S / np.maximum(1.0, nis / 3)[..., None]
        return LeverSeen(
            self.N + np.einsum("...ij,...i,...ik->...jk", A, weight, A),
            self.b + np.einsum("...ij,...i,...i->...j", A, weight, z),
            self.square + np.sum(weight * z**2, axis=-1),
            self.messages + rows.any(-1),
            self.large + (nis > 7.81),
        )

    @property
    def share(self) -> Array:
        """(...,) of the residuals' squares that such a movement explains; about 0.01 where the lever arm is right."""
        scale = np.maximum(np.einsum("...ii->...", self.N), 1e-300)[..., None, None]
        d = np.linalg.solve(self.N / scale + 1e-9 * np.eye(3), (self.b / scale[..., 0])[..., None])[..., 0]
        explained: Array = np.einsum("...i,...i->...", self.b, d) / np.maximum(self.square, 1e-300)
        return explained

    @property
    def suspect(self) -> Array:
        """(...,) bool, after 50 messages, three times as many beyond the bound as there should be."""
        return (self.messages >= 50) & (self.large > 0.15 * self.messages) & (self.share > 0.15)


class Transfer:
    """The filter with its past.  `slave` takes increments, `master` takes messages.

    model: `load("velocity-attitude")` or a composition.  nav, P: as of `Filter`, at `time`; `first` makes them.
    constants: what else the model's functions ask for: lever_b and the root densities of the noises.
    matching: the velocity's and the attitude's measurement.
    way: "buffer" holds a message against the slave as it was then, lag = 0.  "extrapolate" is Kang's: the slave as it
    is now, moved back along its rate of change by lag = tau_hat + what the message's own time says.
    every: so many intervals of the slave for one step of the covariance, which besides comes up to date for a message.
    """

    def __init__(
        self,
        model: Any,
        nav: Mapping[str, Any],
        P: Any,
        constants: Mapping[str, Any],
        *,
        time: float = 0.0,
        matching: tuple[str, str] = ("velocity", "dcm"),
        way: Literal["buffer", "extrapolate"] = "buffer",
        every: int = 1,
        rules: Rules | None = None,
    ):
        if way not in ("buffer", "extrapolate"):
            raise BoresightError(f"transfer: no way {way!r}; there are buffer and extrapolate")
        self.rules, self.way, self.matching = rules or Rules(), way, matching
        self.every = every
        self.runs = np.shape(P)[:-2]
        whole = {name: np.asarray(value, float) for name, value in nav.items()}
        self.filter = Filter(
            model,
            {n: np.broadcast_to(v, (*self.runs, *v.shape[-1:])) if n != "tau" else np.broadcast_to(v, self.runs)
             for n, v in whole.items()},
            P,
        )  # fmt: skip
        self.constants = dict(constants)
        self.time = float(time)
        self.notes: list[Note] = []
        count = int(np.prod(self.runs, dtype=int))
        self.history = History(self.rules.buffer_s, count)
        self._angle, self._push = np.zeros((*self.runs, 3)), np.zeros((*self.runs, 3))
        self._keep()
        self._before: tuple[Array, Array] | None = None
        self._predicted = self.time  # of the covariance
        self._steps = 0
        self._saturated_s = np.zeros((*self.runs, 6))  # without a break
        self._at_full = np.zeros((*self.runs, 2), bool)  # told, and its end not yet
        self._saturated_at = np.full((*self.runs, 6), -np.inf)
        self._stamp = np.full(self.runs, -np.inf)  # of the last message looked at
        self._taken_at = np.full(self.runs, self.time)
        self._silent = np.zeros(self.runs, bool)
        self._gated = np.zeros(self.runs, int)  # in a row
        self._fine_at = np.full(self.runs, -np.inf)  # from when on the gate works
        self._acquired = np.zeros(self.runs, bool)
        self._refused = np.zeros(self.runs, int)  # in a row, for whatever reason
        self._told_at = np.full((len(Verdict), *self.runs), -np.inf)
        self._open = np.zeros(self.runs, bool)  # a refusal was told, its end not yet
        self._seen = LeverSeen.nothing(self.runs)
        self._lever_told = np.zeros(self.runs, bool)
        self._last: dict[str, Array] = {}  # what the last message said, and what was expected of it

    @property
    def nav(self) -> dict[str, Array]:
        """The slave as it is now."""
        return self.filter.nav

    @property
    def P(self) -> Array:
        """(..., n, n) as of the last message, or of the last step of the covariance."""
        return self.filter.P

    # ---- the slave

    def slave(self, time: float, dtheta_ib_b: Any, dv_b: Any, dt: float) -> None:
        """One interval of dt seconds that ends at `time`: increments (..., 3) rad and (..., 3) m/s, biases in them.

        Raises BoresightError where the interval does not begin where the last one ended.
        """
        if abs(time - dt - self.time) > 0.5 * dt:
            raise BoresightError(
                f"transfer: the slave's data goes from {self.time:.4f} s to {time - dt:.4f} s without what lies "
                "between; begin again behind the gap, with `first`"
            )
        dtheta, dv = (np.broadcast_to(np.asarray(part, float), (*self.runs, 3)) for part in (dtheta_ib_b, dv_b))
        before = self._before or (dtheta, dv)
        self.filter.strapdown(dtheta_ib_b=dtheta, dv_b=dv, dtheta_before=before[0], dv_before=before[1], dt=dt)
        self._before = (dtheta, dv)
        self.time = float(time)
        self._angle, self._push = self._angle + dtheta, self._push + dv
        self._keep()
        if self.rules.full_scale is not None:
            self._saturation(dtheta, dv, dt)
        self._steps += 1
        if self._steps >= self.every:
            self._covariance()

    def _keep(self) -> None:
        nav = self.filter.nav
        self.history.append(self.time, v_n=nav["v_n"], q_b2n_wxyz=nav["q_b2n_wxyz"], angle=self._angle, push=self._push)

    def _mean(self, name: str, begin: Array, end: Array) -> Array:
        """(..., *runs, 3) mean of the rate behind `angle` or `push` between two times (..., R); biases in it."""
        seconds = (end - begin)[..., None]
        value = (self.history.at(name, end) - self.history.at(name, begin)) / seconds
        return value.reshape((*value.shape[:-2], *self.runs, 3))

    def _over(self, seconds: Array) -> dict[str, Array]:
        """Mean f_b and omega_ib_b (biases removed) of the last `seconds` (R,), and the attitude in their middle."""
        now = np.full(self.history.runs, self.time)
        nav = self.filter.nav
        return {
            "f_b": self._mean("push", now - seconds, now) - nav["accel_bias"],
            "omega_ib_b": self._mean("angle", now - seconds, now) - nav["gyro_bias"],
            "q_b2n_wxyz": self.history.at("q_b2n_wxyz", now - seconds / 2).reshape((*self.runs, 4)),
        }

    def _covariance(self) -> None:
        """Carry P up to now."""
        dt = self.time - self._predicted
        self._steps = 0
        if dt <= 0:
            return
        self.filter.predict(**self._over(np.full(self.history.runs, dt)), dt=dt, **self.constants)
        self._predicted = self.time
        silent = self.time - self._taken_at > self.rules.silent_s
        self._note(silent & ~self._silent, f"no message of the master was taken for {self.rules.silent_s:g} s; "
                   "the slave goes on alone")  # fmt: skip
        self._silent = silent

    def _saturation(self, dtheta: Array, dv: Array, dt: float) -> None:
        """Where an axis is at full scale, what it misses goes into P: of one sign while it lasts, s t after t."""
        gyro, accel = self.rules.full_scale or (np.inf, np.inf)
        full = np.repeat([gyro, accel], 3)
        seen = np.abs(np.concatenate([dtheta, dv], axis=-1)) >= full * dt * (1 - 1e-9)
        before = self._saturated_s
        since = self.time - self._saturated_at
        for i, what in enumerate(("gyro", "accelerometer")):
            # an axis in noise crosses its full scale many times: told once, and its end after a while within
            axes = slice(3 * i, 3 * i + 3)
            now, told = seen[..., axes].any(-1), self._at_full[..., i]
            within = told & (since[..., axes].min(-1) > self.rules.silent_s) & ~now
            self._note(now & ~told, f"the slave's {what} is at full scale; its noise is opened")
            self._note(within, f"the slave's {what} has been within its range again for {self.rules.silent_s:g} s")
            self._at_full[..., i] = (told | now) & ~within
        if not (seen.any() or before.any()):
            return
        self._saturated_at = np.where(seen, self.time, self._saturated_at)
        self._saturated_s = np.where(seen, before + dt, 0.0)
        missed = self.rules.overshoot * np.where(seen, full, 0.0)  # full scale may be infinite: of a sensor without one
        variance = missed**2 * (self._saturated_s**2 - np.where(seen, before, 0.0) ** 2)
        C = rotation.matrix_from_quaternion(self.filter.nav["q_b2n_wxyz"])
        for block, axes in ((PHI, slice(0, 3)), (DV, slice(3, 6))):
            self.filter.P[..., block, block] += (C * variance[..., None, axes]) @ np.swapaxes(C, -1, -2)

    # ---- the master

    def master(self, message: Message) -> Result:
        """Hold a message against the slave and correct the slave by it, its past included."""
        self._covariance()
        loop, rules, runs = self.filter, self.rules, self.runs
        stamp = np.broadcast_to(np.asarray(message.time, float), runs)
        came = np.broadcast_to(np.asarray(message.rows), (*runs, 6)).any(-1)
        said, rows = self._usable(message)

        # A message that lies ahead is the clocks' fault; an estimate of the delay that says so is the filter's to mend.
        lag = self.time - stamp + loop.nav["tau"]
        lag = np.where(stamp <= self.time + rules.ahead_s, np.maximum(lag, -rules.ahead_s), lag)
        oldest = self.time - self.history.time[0]
        verdict = np.full(runs, int(Verdict.TAKEN))
        for code, where in (
            (Verdict.OUT_OF_ORDER, stamp <= self._stamp),
            (Verdict.TOO_OLD, lag > oldest),
            (Verdict.AHEAD, ~(lag >= -rules.ahead_s)),
            # what the slave missed since cannot be told from what it missed before, nor its rates be trusted
            (Verdict.SATURATED, self._saturated_at.max(-1) > self.time - lag - 3 * rules.half_span_s),
            (Verdict.INVALID, ~rows.any(-1) | ~np.isfinite(stamp)),
            (Verdict.ABSENT, ~came),
        ):
            verdict[where] = code
        if len(self.history) < 2:
            verdict[came] = Verdict.TOO_OLD
            return self._told(verdict, {}, np.zeros(runs), np.zeros(runs, int), lag, stamp)
        believed, lag = lag, np.where(verdict == Verdict.TAKEN, lag, 0.0)

        inputs, rate_factor = self._match(lag)
        expected = loop.call("expected", **inputs)
        said = self._filled(said, rows, expected)
        verdict[self._repeats(said, rows & (verdict == Verdict.TAKEN)[..., None], expected, message)] = Verdict.REPEATED
        rows = rows & (verdict == Verdict.TAKEN)[..., None]
        inputs |= said
        R = np.broadcast_to(np.asarray(message.R, float), (*runs, 6)).copy()
        # the gyros' own noise comes with the rate into the lever arm's velocity
        lever = inputs["lever_b"] if "lever_b" in inputs else loop.nav["lever_b"]
        noise = np.max(np.asarray(self.constants["gyro_noise"]), axis=-1)
        R[..., :3] += (np.sum(np.square(lever), axis=-1) * noise**2 * rate_factor)[..., None]

        # The residual speaks of the error at the message's time: the covariance goes there and comes back.
        # Neglected is the process noise of the lag, which stands in P already.
        F = loop.call("F", **{**inputs, **self._over(np.maximum(lag, 2 * rules.half_span_s).reshape(-1))})
        A = F * lag[..., None, None]
        half = A @ A / 2
        eye = np.eye(A.shape[-1])
        there, back = eye - A + half, eye + A + half
        P_now = loop.P
        P = there @ P_now @ np.swapaxes(there, -1, -2)
        innovations = self._update(P, R, rows, inputs)
        used = rows.sum(-1)
        # The gate presumes residuals that are linear in the errors: until angles and delay are known it is open.
        sigma = np.sqrt(np.einsum("...ii->...i", P_now))
        coarse = (sigma[..., self._angles()].max(-1) > rules.coarse_rad) | (sigma[..., TAU] > rules.coarse_s)
        self._fine_at = np.where(coarse & ~self._acquired & (used > 0), self.time + rules.settle_s, self._fine_at)
        fine = self.time >= self._fine_at
        self._acquired |= fine & (used > 0)  # what is opened later is opened on purpose
        if self.matching[0] in innovations:
            self._watch_lever(innovations[self.matching[0]], rows[..., :3] & fine[..., None], inputs)
        nis = np.sum([part.nis for part in innovations.values()], axis=0)
        gated = (nis > chdtri(np.maximum(used, 1), rules.gate)) & fine
        self._gated = np.where(gated, self._gated + 1, np.where(used > 0, 0, self._gated))
        reopen = gated & (self._gated >= rules.reopen_after)
        if reopen.any():
            P = P + self._opening(reopen, rows, inputs)
            self._update(P, R, rows, inputs)
            self._gated = np.where(reopen, 0, self._gated)
        verdict[gated] = Verdict.GATED
        verdict[reopen] = Verdict.REOPENED
        taken = verdict <= Verdict.REOPENED

        # A correction beyond the model's range is made in part, and the covariance stays as wide as it was.
        turn = np.abs(loop.x[..., self._angles()]).max(-1)
        part = np.where(taken, np.minimum(1.0, LARGEST / np.maximum(turn, 1e-300)), 0.0)
        x = part[..., None] * loop.x
        carried = back @ loop.P @ np.swapaxes(back, -1, -2)
        opened = back @ P @ np.swapaxes(back, -1, -2)
        whole = (part == 1.0)[..., None, None]
        loop.P = np.where(whole, carried, np.where(reopen[..., None, None], opened, P_now))
        loop.P = (loop.P + np.swapaxes(loop.P, -1, -2)) / 2
        loop.x = np.einsum("...ij,...j->...i", back, x)
        self._correct_past(F)
        loop.feedback()
        if message.position is not None:
            position = np.asarray(message.position, float)
            usable = taken & np.isfinite(position).all(-1)
            loop.nav["position"] = np.where(usable[..., None], position, loop.nav["position"])
        return self._told(verdict, innovations, nis, used, believed, stamp)

    def _watch_lever(self, innovation: Innovation, rows: Array, inputs: dict[str, Any]) -> None:
        C = rotation.matrix_from_quaternion(inputs["q_b2n_wxyz"])
        self._seen = self._seen.with_message(innovation.nu, innovation.S, rows, C, inputs["omega_ib_b"])
        suspect = self._seen.suspect
        self._note(suspect & ~self._lever_told, "the velocity residuals are too large and move with the turning of the "
                   "hull: compare the lever arm and its sign (from master to slave, in the slave's axes)")  # fmt: skip
        self._lever_told |= suspect

    def _update(self, P: Array, R: Array, rows: Array, inputs: dict[str, Any]) -> dict[str, Innovation]:
        """Attitude first: the residual of a large turn depends on x, and that of the velocity does not."""
        self.filter.x, self.filter.P = np.zeros(P.shape[:-1]), P
        out = {}
        for name, part, field in (
            (self.matching[1], slice(3, 6), self._attitude_field()),
            (self.matching[0], slice(0, 3), "v_m_n"),
        ):
            if field in inputs:
                out[name] = self.filter.update(name, R[..., part], rows=rows[..., part], **inputs)
        return out

    def _attitude_field(self) -> str:
        return "euler_m" if self.matching[1].startswith("euler") else "q_m2n_wxyz"

    def _angles(self) -> list[int]:
        """Where in the error state angles stand that the model bounds."""
        names = getattr(self.filter.model, "states", ())
        return [i for i, name in enumerate(names) if name.startswith(("phi", "dmu"))] or [0, 1, 2]

    def _usable(self, message: Message) -> tuple[dict[str, Array], Array]:
        """What a message says, and which of its rows can be used: given, finite and within the model's range."""
        rows = np.broadcast_to(np.asarray(message.rows, bool), (*self.runs, 6)).copy()
        said = {}
        attitude = self._attitude_field()
        for name, part in (("v_m_n", slice(0, 3)), (attitude, slice(3, 6))):
            value = getattr(message, name)
            if value is None:
                rows[..., part] = False
                continue
            value = np.asarray(value, float)
            said[name] = np.broadcast_to(value, (*self.runs, value.shape[-1]))
            if name == "q_m2n_wxyz":
                rows[..., part] &= (np.abs(np.linalg.norm(value, axis=-1) - 1) < 1e-3)[..., None]
            else:
                rows[..., part] &= np.abs(value) < (1000.0 if name == "v_m_n" else 2 * np.pi)
        if not said:
            raise BoresightError(
                f"transfer: the message holds neither v_m_n nor {attitude}, which {self.matching[1]} needs"
            )
        return said, rows

    def _filled(self, said: dict[str, Array], rows: Array, expected: dict[str, Array]) -> dict[str, Array]:
        """Where rows are missing, the expected values: masked, but within the model's range."""
        out = {}
        for name, value in said.items():
            if name == "q_m2n_wxyz":
                out[name] = np.where(rows[..., 3:].any(-1, keepdims=True), value, expected[name])
            elif name == "euler_m":
                euler = rotation.euler_from_matrix(rotation.matrix_from_quaternion(expected["q_m2n_wxyz"]))
                out[name] = np.where(rows[..., 3:], value, euler)
            else:
                out[name] = np.where(rows[..., :3], value, expected[name])
        return out

    def _match(self, lag: Array) -> tuple[dict[str, Any], Array]:
        """The slave at the message's time, or now, with its rates; and the rates' variance over the gyros' density.

        A rate is the mean over a span about its time.  Where the span would reach beyond now it ends there, and the
        rate is extended along its change over the two last spans.
        """
        h = self.rules.half_span_s
        now = np.full(self.history.runs, self.time)
        then = now - lag.reshape(-1)
        at = then if self.way == "buffer" else now

        def rate(times: Array) -> Array:
            centre = np.minimum(times, now - h)
            beyond = ((times - centre) / (2 * h)).reshape((*times.shape[:-1], *self.runs, 1))
            last, earlier = (self._mean("angle", c - h, c + h) for c in (centre, centre - 2 * h))
            return last + beyond * (last - earlier) - self.filter.nav["gyro_bias"]

        centre = np.minimum(at, now - h)
        times = np.stack([at, centre + h, centre - h, centre - 3 * h])
        state = {name: self.history.at(name, times) for name in ("v_n", "q_b2n_wxyz")}
        state = {name: value.reshape((4, *self.runs, value.shape[-1])) for name, value in state.items()}
        state["omega_ib_b"] = rate(times)
        _, v1, v2, v3 = self.filter.call("expected", **self.constants, **state)["v_m_n"]
        beyond = ((at - centre) / (2 * h)).reshape(self.runs)
        a_n = (v1 - v2) / (2 * h) + beyond[..., None] * (v1 - 2 * v2 + v3) / (2 * h)
        inputs: dict[str, Any] = {name: value[0] for name, value in state.items()}
        inputs |= {"a_n": a_n, "lag": np.zeros(self.runs) if self.way == "buffer" else lag, **self.constants}
        return inputs, ((1 + beyond) ** 2 + beyond**2) / (2 * h)

    def _repeats(self, said: dict[str, Array], rows: Array, expected: dict[str, Array], message: Message) -> Array:
        """(...,) bool: the same numbers as in the last message, while what was expected has moved by 3 sigma."""
        seen = rows.any(-1)
        new = said | {f"expected {name}": expected[name] for name in ("v_m_n", "q_m2n_wxyz")}
        last = self._last if self._last.keys() == new.keys() else {n: np.full_like(v, np.nan) for n, v in new.items()}
        same = seen & np.all([(value == last[name]).all(-1) for name, value in said.items()], axis=0)
        # what was expected when these numbers came first is kept, so that a slow motion shows too
        fresh = (seen & ~same)[..., None]
        self._last = {name: np.where(fresh, value, last[name]) for name, value in new.items()}
        if not same.any():
            return same
        sigma = np.sqrt(np.broadcast_to(np.asarray(message.R, float), (*self.runs, 6)))
        turn = np.zeros_like(expected["v_m_n"])
        turn[same] = rotation.attitude_error(last["expected q_m2n_wxyz"][same], expected["q_m2n_wxyz"][same])
        change = np.concatenate([expected["v_m_n"] - last["expected v_m_n"], turn], axis=-1)
        return same & (rows & (np.abs(change) > 3 * sigma)).any(-1)

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
        age = (self.time - history.time).reshape((-1, *(1 for _ in self.runs), 1))
        x = loop.x - age * np.einsum("...ij,...j->...i", F, loop.x)
        shape = (len(history), *self.runs)
        past = {name: history.recent(name).reshape((*shape, -1)) for name in ("v_n", "q_b2n_wxyz")}
        corrected = loop.call("feedback", x=x, **past)
        for name in past:
            history.recent(name)[:] = corrected[name].reshape((len(history), history.runs, -1))

    # ---- saying it

    def _told(self, verdict: Array, innovations: dict[str, Innovation], nis: Array, used: Array, lag: Array,
              stamp: Array) -> Result:  # fmt: skip
        taken, came = verdict <= Verdict.REOPENED, verdict != Verdict.ABSENT
        oldest = self.time - self.history.time[0]
        saying = {
            Verdict.REOPENED: f"{self.rules.reopen_after} messages in a row did not fit; the master has jumped, or the "
            "slave: velocity and attitude are opened and follow it",
            Verdict.GATED: "message refused: it does not fit (NIS {nis:.0f} with {used} rows)",
            Verdict.INVALID: "message refused: it holds no finite value within the model's range",
            Verdict.OUT_OF_ORDER: "message refused: its time, {stamp:.3f} s, is not later than the last one's",
            Verdict.AHEAD: "message refused: it lies {ahead:.3f} s ahead of the slave; compare the clocks",
            Verdict.TOO_OLD: f"message refused: it is {{lag:.3f}} s old and the past is known for {oldest:.3f} s"
            + ("; raise buffer_s" if oldest >= self.rules.buffer_s else ", so far"),
            Verdict.SATURATED: "message refused: the slave was at full scale when it was measured, or since",
            Verdict.REPEATED: "message refused: the master repeats its last one while the slave moves",
        }  # fmt: skip
        for code, text in saying.items():
            where = (verdict == code) & (self.time - self._told_at[code] >= self.rules.quiet_s)
            if where.any():
                first = np.unravel_index(np.argmax(where), where.shape)
                self._note(where, text.format(nis=float(nis[first]), used=int(used[first]), lag=float(lag[first]),
                                              ahead=-float(lag[first]), stamp=float(stamp[first])))  # fmt: skip
                self._told_at[code] = np.where(where, self.time, self._told_at[code])
                self._open |= where & (verdict > Verdict.REOPENED)
        returned = taken & self._silent
        if returned.any():
            longest = float(np.max(np.where(returned, self.time - self._taken_at, 0.0)))
            self._note(returned, f"the master is back after {longest:.1f} s")
        again = taken & self._open & ~returned
        if again.any():
            most = int(np.max(np.where(again, self._refused, 0)))
            self._note(again, f"messages are taken again, after {most} refused")
        self._open &= ~taken
        self._refused = np.where(taken, 0, self._refused + came)
        looked_at = came & (verdict != Verdict.AHEAD) & (verdict != Verdict.INVALID)
        self._stamp = np.where(looked_at, np.fmax(stamp, self._stamp), self._stamp)
        self._taken_at = np.where(taken, self.time, self._taken_at)
        self._silent = self._silent & ~taken
        return Result(verdict, innovations, np.asarray(nis), used, lag)

    def _note(self, where: Array, text: str) -> None:
        which = np.flatnonzero(where)
        if len(which):
            if self.runs:
                listed = ", ".join(str(run) for run in which[:5]) + (", ..." if len(which) > 5 else "")
                text += f" (run {listed})" if len(which) == 1 else f" (runs {listed}: {len(which)})"
            self.notes.append(Note(self.time, which, text))


def first(
    message: Message,
    *,
    q_b2m_wxyz: Any = (1.0, 0.0, 0.0, 0.0),
    tau: Any = 0.0,
    mounting_sigma: Any,
    velocity_sigma: Any,
    gyro_bias_sigma: Any,
    accel_bias_sigma: Any,
    tau_sigma: Any,
) -> tuple[dict[str, Array], Array]:
    """nav and P (..., 16, 16) of a slave that takes the master's velocity and attitude over, through its mounting.

    q_b2m_wxyz: (..., 4) believed mounting, mounting_sigma: (..., 3) rad about the master's axes.  velocity_sigma:
    (..., 3) m/s, which has to cover the lever arm's velocity.  The other sigmas: (..., 3) rad/s and m/s^2, (...,) s.
    The attitude's own noise comes from R.  What is wrong with the mounting is wrong with the attitude: phi = C_m2n dmu.
    """
    for name in ("position", "v_m_n", "q_m2n_wxyz"):
        if getattr(message, name) is None:
            raise BoresightError(f"transfer: the first message holds no {name}; wait for one that does")
    C = rotation.matrix_from_quaternion(message.q_m2n_wxyz)
    q = rotation.quaternion_from_matrix(C @ rotation.matrix_from_quaternion(q_b2m_wxyz))
    runs = np.broadcast_shapes(
        q.shape[:-1], np.shape(message.R)[:-1], np.shape(tau), np.shape(tau_sigma), np.shape(message.v_m_n)[:-1],
        *(np.shape(s)[:-1] for s in (mounting_sigma, velocity_sigma, gyro_bias_sigma, accel_bias_sigma)),
    )  # fmt: skip
    nav = {
        "position": np.asarray(message.position, float), "v_n": np.asarray(message.v_m_n, float), "q_b2n_wxyz": q,
        "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3), "q_b2m_wxyz": np.asarray(q_b2m_wxyz, float),
        "tau": np.broadcast_to(np.asarray(tau, float), runs),
    }  # fmt: skip
    R = np.broadcast_to(np.asarray(message.R, float), (*runs, 6))
    P = np.zeros((*runs, 16, 16))
    i = np.arange(3)
    for at, sigma in ((3, velocity_sigma), (6, gyro_bias_sigma), (9, accel_bias_sigma), (12, mounting_sigma)):
        P[..., i + at, i + at] = np.square(np.broadcast_to(np.asarray(sigma, float), (*runs, 3)))
    P[..., 15, 15] = np.square(tau_sigma)
    P[..., PHI, 12:15] = C @ P[..., 12:15, 12:15]
    P[..., 12:15, PHI] = np.swapaxes(P[..., PHI, 12:15], -1, -2)
    P[..., PHI, PHI] = C @ P[..., 12:15, PHI] + R[..., 3:, None] * np.eye(3)
    P[..., PHI, PHI] = (P[..., PHI, PHI] + np.swapaxes(P[..., PHI, PHI], -1, -2)) / 2
    return nav, P
