"""A transfer alignment flown on a motion of `motion`, and how far it is wrong beside what it claims."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.stats import chi2

from boresight.evidence.flights import imperfect
from boresight.evidence.flights.motion import Motion, matrix, quaternion, turn, turn_between
from boresight.runtime import transfer
from boresight.runtime.array import Array
from boresight.runtime.calibration import Calibration
from boresight.runtime.library import load
from boresight.runtime.transfer.score import Score
from boresight.runtime.transfer.sensors import MODEL, Sensors, carried
from boresight.runtime.units import DEG, HOUR, STANDARD_GRAVITY


@dataclass(frozen=True)
class Unit:
    """One sigma of what a slave and a master are like."""

    gyro_bias: float = 10 * DEG / HOUR  # rad/s
    accel_bias: float = 1e-3 * STANDARD_GRAVITY  # m/s^2
    gyro_noise: float = 3e-5  # rad/sqrt(s)
    accel_noise: float = 1e-3  # m/s/sqrt(s)
    mounting: tuple[float, float, float] = (0.6 * DEG, 0.6 * DEG, 2 * DEG)
    velocity: float = 0.02  # m/s
    attitude: float = 0.3e-3  # rad


@dataclass
class Flown:
    """Of K messages handed over to so many runs."""

    loop: transfer.Transfer
    start_errors: Array  # (runs, n) before the first message after the hand-over
    start_P: Array
    time: Array  # (K,) s
    errors: Array  # (K, runs, n) estimated - true, after each message; n is 16, or 46 of a filter that carries sensors
    P: Array  # (K, runs, n, n)
    nis: Array  # (K, runs) of the messages taken, else nan
    verdict: Array  # (K, runs)

    @property
    def nees(self) -> Array:
        """(K, runs) of the states that have a variance."""
        return self.nees_of(self.states)

    @property
    def start_nees(self) -> Array:
        """(runs,)"""
        return nees(self.start_errors[..., self.states], self.start_P[..., self.states, :][..., self.states])

    @property
    def states(self) -> list[int]:
        """Those that have a variance."""
        return [int(i) for i in np.flatnonzero(np.diagonal(self.start_P, axis1=-2, axis2=-1).min(0) > 0)]

    def nees_of(self, states: list[int]) -> Array:
        """(K, runs) of these states alone."""
        return nees(self.errors[..., states], self.P[..., states, :][..., states])


def nees(errors: Array, P: Array) -> Array:
    """(...,) of errors (..., n) by their covariance (..., n, n)."""
    out: Array = np.einsum("...i,...i->...", errors, np.linalg.solve(P, errors[..., None])[..., 0])
    return out


def followed(loop: Any) -> Any:
    """s by which a loop takes the stamps for ahead; candidates side by side take them as they are."""
    return loop.stamps.clock if hasattr(loop, "stamps") else 0.0


def band(mean_of: int, dof: int, level: float = 0.999) -> Array:
    """The interval in which the mean of so many independent chi-squares lies with this probability."""
    rest = (1 - level) / 2
    limits: Array = chi2.ppf([rest, 1 - rest], dof * mean_of) / mean_of
    return limits


def started(
    message: transfer.Message, model: Any, constants: dict[str, Any], *, sigmas: Any, estimates: Any,
    increments: transfer.Increments, carrying: Sensors | None = None, **settings: Any,
) -> transfer.Transfer:  # fmt: skip
    """The loop as a user begins it."""
    begin, considered = {"sigmas": sigmas}, None
    if carrying is not None:
        constants, widened, estimates, considered = carried(carrying, constants, sigmas, estimates)
        begin = {"P": widened}
    nav, P, past = transfer.first(message, model, constants, **begin, estimates=estimates, increments=increments)
    loop = transfer.Transfer(model, nav, P, constants, time=increments.end[-1], past=past, **settings)
    loop.filter.considered = considered
    loop.score = Score(loop.runs) if carrying is not None and carrying.probed else None
    return loop


def fly(
    motion: Motion,
    *,
    runs: int = 30,
    seed: int = 1,
    unit: Unit | None = None,
    model: Any = "velocity-attitude",
    imu_hz: float = 50,
    master_hz: float = 5,
    seconds: float = 40.0,
    tau: Any = 0.035,
    tau_believed: Any = 0.0,
    tau_sigma: float = 0.05,
    lost: float = 0.1,
    jitter: float = 0.003,
    hand_over: float = 0.02,
    clock: Callable[[float], Any] = lambda time: 0.0,
    lever_b: Any = (1.2, -2.4, 1.8),
    C_b2m: Any = None,
    R: Any = None,
    sensed: Callable[..., Any] | None = None,
    said: Callable[..., Any] | None = None,
    start: Callable[..., Any] | None = None,
    sensors: Sensors | None = None,
    sine: bool = False,
    carrying: Sensors | None = None,
    sigmas: dict[str, Any] | None = None,
    estimates: dict[str, Any] | None = None,
    constants: dict[str, Any] | None = None,
    **settings: Any,
) -> Flown:
    """Fly the transfer alignment on a motion: a Flown.

    tau: s, true, () or (runs,), or that as a function of time.  lost: part of the messages.
    jitter: s, of their times, which the stamps tell.
    clock: s, () or (runs,), by which the stamps are ahead, as a function of time: so much longer is the delay.
    hand_over: s after which a message is handed over beyond the master's own delay.
    sensed(time, dtheta, dv) changes what the slave delivers in an interval (runs, 3), or loses it by None.
    said(time, message) changes what the master says, or loses it by None.
    start: makes what flies, with `slave`, `master`, nav and P, in place of `started`.
    sensors: how far those of the slave and its seat are from ideal; sine: the seat bends as one.  carrying: what the
    filter carries of that, which flies the model with states for it.
    sigmas, estimates: what `first` is given besides.  settings: of `Transfer`.
    """
    unit = unit or Unit()
    rng = np.random.default_rng([seed, runs])
    loaded = load(MODEL if carrying else model) if isinstance(model, str) else model
    C_b2m = matrix(np.array([0.4, -0.3, 2.0]) * DEG) if C_b2m is None else np.asarray(C_b2m)
    lever_b = np.asarray(lever_b, float)

    def delay(time: float) -> Array:
        return np.broadcast_to(np.asarray(tau(time) if callable(tau) else tau, float), (runs,))

    R = np.repeat([unit.velocity, unit.attitude], 3) ** 2 if R is None else np.asarray(R, float)
    dt, steps = 1 / imu_hz, round(seconds * imu_hz)
    lead = round((0.3 + np.max(np.abs(tau_believed))) * imu_hz)  # what the slave delivered before the first stamp, 0
    edges = np.arange(-lead, steps + 1) * dt
    dtheta, dv = motion.increments(edges)
    truth = imperfect.drawn(sensors or Sensors(), np.random.default_rng([seed, runs, 1]), runs, edges[1:], sine=sine)
    C_b2m_true, lever_true = C_b2m @ np.swapaxes(truth.Q, -1, -2), truth.Q @ lever_b
    bias_g, bias_a = unit.gyro_bias * rng.standard_normal((runs, 3)), unit.accel_bias * rng.standard_normal((runs, 3))
    known = {"lever_b": lever_b, "gyro_noise": np.full(3, unit.gyro_noise), "accel_noise": np.full(3, unit.accel_noise),
             "gyro_bias_noise": np.full(3, 1e-9), "accel_bias_noise": np.full(3, 1e-9), "mu_noise": np.full(3, 1e-9),
             "tau_noise": 1e-9} | (constants or {})  # fmt: skip
    if "lever_m" in known:
        del known["lever_b"]

    def message(stamp: Array, tau: Array) -> transfer.Message:
        """What the master says that is stamped so (runs,): it saw `stamp - tau`."""
        bend, rate = truth.bend(stamp - tau), truth.bend_rate(stamp - tau)
        v, C = motion.master(stamp - tau, lever_b, turn(bend) @ C_b2m, rate @ C_b2m)
        v = v + unit.velocity * rng.standard_normal((runs, 3))
        C = turn(unit.attitude * rng.standard_normal((runs, 3))) @ C
        return transfer.Message(stamp, R, v_m_n=v, q_m2n_wxyz=quaternion(C), position=motion.position(stamp - tau),
                                rows=np.repeat(rng.random((runs, 1)) >= lost, 6, 1))  # fmt: skip

    def deliver(k: int) -> tuple[Array, Array] | None:
        """What the slave delivers in its k-th interval, (runs, 3) each."""
        (turned, drift_g), (pushed, drift_a) = (
            (shown @ part[k], drift[k])
            for shown, part, drift in zip((truth.gyro, truth.accel), (dtheta, dv), truth.drift, strict=True)
        )
        d = turned + (bias_g + drift_g) * dt + unit.gyro_noise * np.sqrt(dt) * rng.standard_normal((runs, 3))
        f = pushed + (bias_a + drift_a) * dt + unit.accel_noise * np.sqrt(dt) * rng.standard_normal((runs, 3))
        out: tuple[Array, Array] | None = (d, f) if sensed is None else sensed(edges[k + 1], d, f)
        return out

    def errors(nav: dict[str, Array], time: float, stamped: Any = 0.0) -> Array:
        """(runs, n) estimated - true, in the axes of the accelerometers.  stamped: s, how far stamps are ahead."""
        now = np.array(time)
        C_b2n = motion.C_b2n(now) @ np.swapaxes(truth.Q, -1, -2)
        drift_g, drift_a = (part[round(time * imu_hz) + lead - 1] for part in truth.drift)
        parts = [turn_between(nav["q_b2n_wxyz"], C_b2n), nav["v_n"] - motion.velocity(now)[0],
                 nav["gyro_bias"] - bias_g - drift_g, nav["accel_bias"] - bias_a - drift_a,
                 turn_between(nav["q_b2m_wxyz"], C_b2m_true),
                 (nav["tau"] - delay(time) - stamped)[:, None]]  # fmt: skip
        if carrying is not None:
            shown = [nav[name] for name in ("gyro_scale", "accel_scale", "gyro_axes", "accel_axes")]
            parts += [nav["lever_b"] - lever_true, nav["flexure"] - truth.bend(now),
                      nav["flexure_rate"] - truth.bend_rate(now), np.concatenate(shown, axis=-1) - truth.calibration,
                      nav["gyro_turn_on"] - bias_g, nav["accel_turn_on"] - bias_a]  # fmt: skip
        return np.concatenate(parts, axis=-1)

    opening = replace(message(np.zeros(runs), delay(0.0)), rows=True)
    begun = lead + int(np.ceil(hand_over * imu_hz - 1e-9))
    known_past = [part for part in map(deliver, range(begun)) if part is not None]
    calibration = settings.get("known") or Calibration()
    d_past, f_past = np.array(known_past).swapaxes(0, 1)
    past = calibration.increments(d_past, f_past, dt)
    sigma = np.asarray(unit.mounting)
    begin: dict[str, Any] = dict(
        sigmas={"q_b2m_wxyz": sigma, "gyro_bias": unit.gyro_bias, "accel_bias": unit.accel_bias, "tau": tau_sigma}
        | (sigmas or {}),
        estimates={"q_b2m_wxyz": quaternion(turn(sigma * rng.standard_normal((runs, 3))) @ C_b2m), "tau": tau_believed}
        | (estimates or {}),
        increments=transfer.Increments(edges[:begun], edges[1 : begun + 1], *past),
    )  # fmt: skip
    if carrying is not None:
        begin["carrying"] = carrying
    loop = (start or started)(opening, loaded, known, **begin, **settings)
    start_errors = errors(loop.nav, edges[begun])
    start_P = loop.P[..., : start_errors.shape[-1], : start_errors.shape[-1]].copy()
    gap = 1 / master_hz
    out: dict[str, list[Any]] = {"time": [], "errors": [], "P": [], "nis": [], "verdict": []}
    due = 1
    for k in range(begun, lead + steps):
        time = float(edges[k + 1])
        delivered = deliver(k)
        if delivered is not None:
            loop.slave(time, *delivered, dt)
        while due * gap + hand_over <= time + 1e-9:
            given = message(due * gap + jitter * rng.uniform(-1, 1, runs), delay(due * gap))
            due += 1
            given = replace(given, time=given.time + clock(time))
            given = given if said is None else said(time, given)
            if given is None:
                continue
            result = loop.master(given)
            out["time"].append(time)
            out["errors"].append(errors(loop.nav, loop.time, clock(loop.time) + followed(loop)))
            out["P"].append(loop.P[..., : start_P.shape[-1], : start_P.shape[-1]].copy())
            out["nis"].append(np.where(result.taken, result.nis, np.nan))
            out["verdict"].append(result.verdict)
    return Flown(loop, start_errors, start_P, **{name: np.array(value) for name, value in out.items()})
