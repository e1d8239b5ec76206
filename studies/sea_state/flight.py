"""Flights of a transfer alignment at sea, after Kang and others (2025): hull, sensors, filter, many runs at once.

A MEMS slave beside a good master on one hull, turned by 2 degrees in heading; the master's data is 5 to 10 ms late.
Sixteen states, velocity and attitude matched once a second for a minute.  The paper gives wave heights and (6), and not
how a wave moves its platform: `MOTIONS` are three answers.  docs/sea-state.md says what else it leaves open.

Axes of arrays: time, then filter (with compensation, without), sea state, run; then components.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.consistency import nees
from boresight.runtime import rotation, transfer
from boresight.runtime.array import Array
from boresight.runtime.simulation import hull, inertial, sea, sensors
from boresight.runtime.simulation.motions import HEIGHT_M
from boresight.runtime.transfer import Message
from boresight.runtime.units import DEG, HOUR, MILLI_G
from boresight.studies import study
from boresight.studies.sea_state.matching import SPAN_S, Matching
from boresight.studies.study import Seeded, option

GRADES = (1, 2, 3, 4, 5, 6)
FILTERS = ("with", "without")  # compensation of the delay
MOTIONS = {
    "wave": "(a) equation (6) as heave, and nothing else",
    "slope": "(b) heave by (6), and roll, pitch, yaw by the slope of that wave",
    "sea": "(c) a Pierson-Moskowitz sea through the response of a 40 m hull",
}
PHI, DV = slice(0, 3), slice(3, 6)
LEVER_SIGMA_M = 0.1
SETTLED_S = 10  # NIS counts from here on: at first the filter makes use of a start that is better than it was told


@dataclass(frozen=True)
class Scenario(Seeded):
    """One experiment.  What is random is one sigma, drawn for each run and constant in it."""

    seconds: int = option(60, "Length of a run.")
    bench_runs: int = option(10, "Runs on the bench; 0 leaves out the bench and the comparison of two compensations.")
    motions: tuple[str, ...] = tuple(MOTIONS)
    # The paper's: Tables 1 and 2, and its text.
    height_m: tuple[float, ...] = HEIGHT_M
    frequency_hz: float = 0.1
    misalignment_deg: float = 2.0  # in heading, of every run
    delay_ms: tuple[float, float] = (5.0, 10.0)
    navigation_hz: int = 100
    update_hz: int = 1
    # How the wave moves the hull, which the paper leaves open.
    slope_ratio: tuple[float, float, float] = (1.0, 0.5, 0.1)  # roll, pitch, yaw, of the wave's slope
    slope_phase_deg: tuple[float, float, float] = (0.0, 90.0, 45.0)  # ahead of the elevation: roll near its resonance
    spectrum_gamma: float = 1.0  # 1 Pierson-Moskowitz, 3.3 JONSWAP
    waves_deg: float = 135.0  # where the waves run to, from the bow
    speed_m_s: float = 0.0
    heading_deg: float = 30.0
    latitude_deg: float = 36.0
    lever_b: tuple[float, float, float] = (3.0, 1.0, -1.0)  # m, from master to slave
    bending_mrad: float = 0.0  # flexure, about each axis; the filter has no state for it
    bending_s: float = 1.0
    # A MEMS unit for the slave, and a good master, which the paper names and does not describe.
    gyro_bias_deg_h: float = 20.0
    gyro_walk_deg_sqrt_h: float = 0.15
    # Of each gyro's axis towards each other one, for which the filter has no state; or one number a sea state.
    gyro_misalignment_mrad: float | tuple[float, ...] = 0.0
    accel_bias_mg: float = 2.0
    accel_walk_m_s_sqrt_h: float = 0.05
    velocity_noise_m_s: float = 0.01  # of the master, white from update to update
    attitude_noise_deg: float = 0.003
    # What the filter is told beyond these.
    level_misalignment_deg: float = 0.5
    start_velocity_m_s: float = 0.05
    start_angle_deg: float = 0.05
    delay_sigma_ms: float = 10.0  # about an estimate of zero
    mounting_walk_urad_sqrt_s: float = 0.0  # of a mounting that moves, which it does not
    covariance_hz: int = 10


SIGNED = ("slope_ratio", "slope_phase_deg", "waves_deg", "heading_deg", "latitude_deg", "lever_b", "speed_m_s",
          "misalignment_deg", "seed")  # fmt: skip
LIMITS = dict.fromkeys(("velocity_noise_m_s", "attitude_noise_deg", "frequency_hz", "seconds"), (1e-9, np.inf))


def checked(scenario: Scenario) -> Scenario:
    """The scenario; raises BoresightError for a value that has no meaning."""
    study.checked("sea-state", scenario, SIGNED, LIMITS)
    s = scenario
    if s.covariance_hz < 1 or s.navigation_hz % s.covariance_hz or s.update_hz < 1 or s.covariance_hz % s.update_hz:
        raise BoresightError(
            f"sea-state: navigation_hz {s.navigation_hz} must be a multiple of covariance_hz {s.covariance_hz}, "
            f"and that of update_hz {s.update_hz}"
        )
    if s.update_hz > 1 / (2 * SPAN_S):
        raise BoresightError(f"sea-state: update_hz is {s.update_hz}; it must be at most {1 / (2 * SPAN_S):g}")
    return scenario


# ---- truth


def motion_of(kind: str, scenario: Scenario, streams: Sequence[np.random.Generator]) -> hull.Motion:
    """The hull in every sea state: runs (6, 1) where all runs see one motion, (6, runs) in a random sea."""
    s = scenario
    a = np.array(s.height_m)[:, None]
    heading = np.array(s.heading_deg * DEG)
    if kind == "wave":
        return hull.by_slope(a, s.frequency_hz, np.zeros(3), np.zeros(3), heading)
    if kind == "slope":
        return hull.by_slope(a, s.frequency_hz, np.array(s.slope_ratio), np.array(s.slope_phase_deg) * DEG, heading)
    if kind == "sea":
        omega, elevation = sea.components(a, gamma=s.spectrum_gamma)
        phases = hull.phases(streams, omega.shape[-1])
        towards = heading + s.waves_deg * DEG
        return hull.in_sea(hull.Hull(), omega, elevation, phases, towards=towards, heading=heading, speed=s.speed_m_s)
    raise BoresightError(f"no motion {kind!r} in sea-state; there are: {', '.join(MOTIONS)}")


@dataclass(frozen=True)
class Drawn:
    """The constants of each run, and its stream of random numbers for all that follows."""

    delay: Array  # (runs,) s
    gyro_bias: Array  # (runs, 3) rad/s
    accel_bias: Array  # (runs, 3) m/s^2
    gyro_gain: Array  # (1 or states, runs, 3, 3): what gyros at right angles do not have
    streams: tuple[np.random.Generator, ...]


def draw(scenario: Scenario, seed: int, runs: int, first_run: int = 0) -> Drawn:
    """Keyed by [seed, run], whatever runs are flown beside it; the same in every sea state and motion."""
    s = scenario
    streams = tuple(sensors.generator(seed, run) for run in range(first_run, first_run + runs))
    part = np.array([stream.random() for stream in streams])
    n = np.array([stream.standard_normal(12) for stream in streams])
    askew = np.zeros((runs, 3, 3))
    askew[:, [0, 0, 1, 1, 2, 2], [1, 2, 0, 2, 0, 1]] = 1e-3 * n[:, 6:]
    gain = np.atleast_1d(s.gyro_misalignment_mrad)[:, None, None, None] * askew
    return Drawn(
        delay=1e-3 * (s.delay_ms[0] + (s.delay_ms[1] - s.delay_ms[0]) * part),
        gyro_bias=s.gyro_bias_deg_h * DEG / HOUR * n[:, 0:3],
        accel_bias=s.accel_bias_mg * MILLI_G * n[:, 3:6],
        gyro_gain=gain,
        streams=streams,
    )


@dataclass(frozen=True)
class Truth:
    """What is true, and what the sensors deliver but for their errors.  N navigation steps, U updates."""

    dtheta: Array  # (N, 6, 1 or runs, 3) rad
    dv: Array  # (N, 6, 1 or runs, 3) m/s
    slave: inertial.Trajectory  # (N + 1, 6, 1 or runs, ...)
    master: hull.Pose  # at the updates, and as old as the delay says: (U + 1, 6, runs, ...)
    q_b2m_wxyz: Array  # (U + 1, 1, 1 or runs, 4) at the updates


def truth(model: Any, motion: hull.Motion, scenario: Scenario, drawn: Drawn, mounting: Array | None = None) -> Truth:
    """The slave's ideal increments and the master's late reports.  mounting: q_b2m_wxyz; the scenario's if left out."""
    s = scenario
    dt, per_update = 1 / s.navigation_hz, s.navigation_hz // s.update_hz
    time = np.arange(s.seconds * s.navigation_hz + 1) * dt
    if mounting is None:
        mounting = rotation.quaternion_from_euler(np.array([0.0, 0.0, s.misalignment_deg]) * DEG)
    bending, q_b2m = None, np.broadcast_to(mounting, (len(time[::per_update]), *np.shape(mounting)))
    if s.bending_mrad:
        bending = hull.bending(np.full(3, s.bending_mrad * 1e-3), s.bending_s, hull.phases(drawn.streams, 3 * 40)[None])
        bent = rotation.matrix_from_vector(bending.at(time[::per_update]))
        q_b2m = rotation.quaternion_from_matrix(bent @ rotation.matrix_from_quaternion(mounting))
    slave = hull.carried(hull.ride(motion, time), np.array(s.lever_b), mounting, bending)
    place = np.array([s.latitude_deg * DEG, 0.0, 0.0])
    dtheta, dv, trajectory = inertial.increments(model.strapdown, place, slave.v_n, slave.q_b2n_wxyz, dt)
    master = hull.ride(motion, time[::per_update, None, None] - drawn.delay)
    return Truth(dtheta=dtheta, dv=dv, slave=trajectory, master=master, q_b2m_wxyz=q_b2m)


# ---- the filter


def matching_variances(scenario: Scenario) -> Array:
    """(6,) of the master's velocity and attitude."""
    return np.repeat([scenario.velocity_noise_m_s, scenario.attitude_noise_deg * DEG], 3) ** 2


@dataclass(frozen=True)
class Belief:
    """How a filter begins; leading axes are filters beside each other over the same flights.

    q_b2m_wxyz: (..., 4) mounting.  heading_sigma: (...,) rad, of the mounting about the master's down axis, and
    velocity_sigma, m/s: the scenario's where they are None.  compensated: (...,) bool, whether the delay is a state;
    otherwise it is known, and zero.
    """

    q_b2m_wxyz: Array = field(default_factory=lambda: np.array([1.0, 0, 0, 0]))
    heading_sigma: Any = None
    velocity_sigma: float | None = None
    compensated: Any = True


def only(name: str) -> Belief:
    """One of the paper's two filters alone: the axis of filters has a length of 1."""
    return Belief(compensated=np.full((1, 1, 1), name == "with"))


def begin(model: Any, scenario: Scenario, belief: Belief, **reported: Array) -> tuple[dict[str, Array], Array]:
    """nav and P (..., n, n) by what masters report at first: v_m_n, q_m2n_wxyz, position."""
    message = Message(time=0.0, R=matching_variances(scenario), **reported)
    sigmas, estimates = believed(scenario, belief)
    # the scenario says what motion and delay do to the start
    nav, P = transfer.first(message, model, constants(scenario), sigmas=sigmas, estimates=estimates,
                               rate_sigma=0.0, acceleration_sigma=0.0)  # fmt: skip
    P[..., DV, DV] += np.eye(3) * (belief.velocity_sigma or scenario.start_velocity_m_s) ** 2
    P[..., PHI, PHI] += np.eye(3) * (scenario.start_angle_deg * DEG) ** 2
    return nav, P


def believed(scenario: Scenario, belief: Belief) -> tuple[dict[str, Any], dict[str, Any]]:
    """What a start is told of the slave: sigmas and estimates, as of `transfer.first`."""
    s = scenario
    heading = np.asarray(s.misalignment_deg * DEG if belief.heading_sigma is None else belief.heading_sigma, float)
    level = np.full_like(heading, s.level_misalignment_deg * DEG)
    sigmas = {
        "q_b2m_wxyz": np.stack([level, level, heading], axis=-1),
        "gyro_bias": s.gyro_bias_deg_h * DEG / HOUR,
        "accel_bias": s.accel_bias_mg * MILLI_G,
        "tau": np.asarray(belief.compensated, float) * s.delay_sigma_ms * 1e-3,
        "lever_b": LEVER_SIGMA_M,  # of a state alone: on a hull that stands still it moves nothing
    }
    return sigmas, {"q_b2m_wxyz": belief.q_b2m_wxyz}


def constants(scenario: Scenario) -> dict[str, Any]:
    """Lever arm, and the noise that the filter is told; biases and delay are constants."""
    nothing = dict.fromkeys(("gyro_bias_noise", "accel_bias_noise"), np.zeros(3))
    return {
        "lever_b": np.array(scenario.lever_b),
        "gyro_noise": np.full(3, scenario.gyro_walk_deg_sqrt_h * DEG / np.sqrt(HOUR)),
        "accel_noise": np.full(3, scenario.accel_walk_m_s_sqrt_h / np.sqrt(HOUR)),
        **nothing,
        "mu_noise": np.full(3, scenario.mounting_walk_urad_sqrt_s * 1e-6),
        "tau_noise": 0.0,
    }


@dataclass(frozen=True)
class Signals:
    """What the slave's sensors and its master deliver in each run, and the truth behind it."""

    drawn: Drawn  # its biases times `noise`
    true: Truth
    v_m_n: Array  # (U + 1, cases, runs, 3) m/s at the updates
    q_m2n_wxyz: Array  # (U + 1, cases, runs, 4)
    errors: Array  # (runs, U, T, 6) rad and m/s, of the increments: noise and biases

    def increments(self, update: int) -> Array:
        """(T, cases, runs, 6) between the update before and this one."""
        samples = self.errors.shape[2]
        part = slice((update - 1) * samples, update * samples)
        out: Array = np.moveaxis(self.errors[:, update - 1], 0, 1)[:, None]
        if self.drawn.gyro_gain.any():
            turned = np.einsum("...ij,...j->...i", self.drawn.gyro_gain, self.true.dtheta[part])
            out = out + np.concatenate([turned, np.zeros_like(turned)], axis=-1)
        return out + np.concatenate([self.true.dtheta[part], self.true.dv[part]], axis=-1)

    def error(self, nav: Mapping[str, Array], update: int) -> Array:
        """(..., 16) computed - true, of nav (..., cases, runs, size) at an update."""
        true, at = self.true, update * self.errors.shape[2]
        parts = (
            rotation.attitude_error(nav["q_b2n_wxyz"], true.slave.q_b2n_wxyz[at]),
            nav["v_n"] - true.slave.v_n[at],
            nav["gyro_bias"] - self.drawn.gyro_bias,
            nav["accel_bias"] - self.drawn.accel_bias,
            rotation.attitude_error(nav["q_b2m_wxyz"], true.q_b2m_wxyz[update]),
            (nav["tau"] - self.drawn.delay)[..., None],
        )
        return np.concatenate(parts, axis=-1)


def signals(model: Any, kind: str | hull.Motion, scenario: Scenario, *, runs: int, seed: int, first_run: int = 0,
            mounting: Array | None = None, delay_s: Any = None, noise: float = 1.0) -> Signals:  # fmt: skip
    """Of every run, keyed by [seed, run] in every case.

    kind: one of MOTIONS, or a motion of shape (cases, 1) or (cases, runs) in the place of the six sea states.
    mounting: true q_b2m_wxyz, (cases, runs, 4) as it broadcasts; the scenario's if left out.
    delay_s: instead of the drawn one, as (cases, runs) broadcasts.
    noise: a factor on all that is drawn but the delay; the filter is given the same.
    """
    s = checked(scenario)
    dt, samples, updates = 1 / s.navigation_hz, s.navigation_hz // s.update_hz, s.seconds * s.update_hz
    drawn = draw(s, seed, runs, first_run)
    motion = motion_of(kind, s, drawn.streams) if isinstance(kind, str) else kind
    drawn = replace(
        drawn, delay=drawn.delay if delay_s is None else np.asarray(delay_s, float), gyro_bias=noise * drawn.gyro_bias,
        accel_bias=noise * drawn.accel_bias, gyro_gain=noise * drawn.gyro_gain,
    )  # fmt: skip
    true = truth(model, motion, s, drawn, mounting)
    # of each update in turn the slave's noise, then the master's
    n = noise * np.array([stream.standard_normal(6 + updates * (samples + 1) * 6) for stream in drawn.streams])
    each = n[:, 6:].reshape(runs, updates, samples + 1, 6)
    reported = np.moveaxis(np.concatenate([n[:, None, :6], each[:, :, -1]], axis=1), 0, 1)[:, None]
    # a turn in level axes, as the master's axes see it
    C = rotation.matrix_from_quaternion(true.master.q_b2n_wxyz)
    turn = np.einsum("...ji,...j->...i", C, s.attitude_noise_deg * DEG * reported[..., 3:])
    given = constants(s)
    walk = np.repeat([given["gyro_noise"][0], given["accel_noise"][0]], 3) * np.sqrt(dt)
    bias = np.concatenate([drawn.gyro_bias, drawn.accel_bias], axis=-1)
    return Signals(
        drawn, true, true.master.v_n + s.velocity_noise_m_s * reported[..., :3],
        rotation.turned(true.master.q_b2n_wxyz, turn), walk * each[:, :, :-1] + bias[:, None, None] * dt,
    )  # fmt: skip


@dataclass(frozen=True)
class Flight:
    """(U + 1, filters, cases, runs, ...); what belongs to an update is U long."""

    error: Array  # (U + 1, ..., 16) computed - true, in the order of the model's states
    sigma: Array  # (U + 1, ..., 16) of the filter
    P: Array  # (..., 16, 16) at the end
    nis: Array  # (U, ..., 2): attitude and velocity
    rows: Array  # (U, ...) taken
    lost: Array  # (...,) bool: an update left the model's boxes, and was left out
    delay: Array  # (runs,) s, true
    update_hz: int

    @property
    def settled_nis(self) -> Array:
        """(filters, cases) of all rows: the mean from SETTLED_S on."""
        mean: Array = self.nis[SETTLED_S * self.update_hz :].sum(-1).mean((0, -1))
        return mean

    @property
    def heading(self) -> Array:
        """yaw_hat - yaw of the slave, rad: minus the third part of phi."""
        wrapped: Array = (np.pi - self.error[..., 2]) % (2 * np.pi) - np.pi
        return wrapped

    @property
    def heading_sigma(self) -> Array:
        return self.sigma[..., 2]

    @property
    def nees(self) -> Array:
        """Of all sixteen states at the end."""
        return nees(self.error[-1], self.P)


def fly(model: Any, kind: str | hull.Motion, scenario: Scenario, *, attitude: str = "dcm", rows: Any = True,
        belief: Belief | None = None, **drawn: Any) -> Flight:  # fmt: skip
    """Closed loops, each run with its own delay, biases and noise.

    kind, drawn (runs, seed, ...): as of `signals`.  attitude: the measurement, "dcm" as the paper's, "quaternion" or
    "euler"; rows: (3,) bool of it.  Euler angles of a master that is steeper than the model's box are left out.
    belief: how the filters begin: the paper's two, FILTERS, if left out.
    """
    came, s = signals(model, kind, scenario, **drawn), scenario
    nav, P = start(model, came, s, belief or Belief(compensated=np.array([True, False])[:, None, None]))
    shape = np.broadcast_shapes(nav["v_n"].shape[:-1], P.shape[:-2], came.v_m_n.shape[1:-1])

    def flat(values: Array, size: tuple[int, ...]) -> Array:
        return np.broadcast_to(values, (*shape, *size)).reshape(-1, *size)

    one = {name: flat(value, np.shape(value)[-1:] if name != "tau" else ()) for name, value in nav.items()}
    flown = Matching(model, s, one, flat(P, P.shape[-2:]), constants(s), matching_variances(s), attitude)
    loop, newest = flown.loop, flown.newest.reshape(*shape, *flown.newest.shape[1:])
    reported = {"v_m_n": came.v_m_n, "q_m2n_wxyz": came.q_m2n_wxyz}
    rows = np.broadcast_to(rows, (*came.v_m_n.shape[:-1], 3))
    if attitude == "euler":
        box = model.field["euler_m"]
        euler = rotation.euler_from_matrix(rotation.matrix_from_quaternion(came.q_m2n_wxyz))
        reported["euler_m"] = np.clip(euler, box["low"], box["high"])
        rows = rows & (np.abs(euler[..., 1:2]) <= box["high"][1])
    error, sigma, nis, used = [], [], [], []
    for update in range(len(came.v_m_n)):
        if update:
            newest[...] = np.moveaxis(came.increments(update)[::-1], 0, -2)
            flown.measured[attitude].rows[...] = flat(rows[update], (3,))
            flown.update(**{name: flat(value[update], value.shape[-1:]) for name, value in reported.items()})
            nis.append(flown.nis.T.reshape(*shape, 2))
            used.append(sum(measured.used.sum(-1) for measured in flown.measured.values()).reshape(shape))
        now = {name: loop.nav.seen(name).reshape(*shape, *value.shape[1:]) for name, value in one.items()}
        error.append(came.error(now, update))
        sigma.append(np.sqrt(loop.variances()).reshape(*shape, -1))
    P_end = loop.P.reshape(*shape, *P.shape[-2:])
    return Flight(np.array(error), np.array(sigma), P_end, np.array(nis), np.array(used), flown.lost.reshape(shape),
                  came.drawn.delay, s.update_hz)  # fmt: skip


def start(model: Any, came: Signals, scenario: Scenario, belief: Belief) -> tuple[dict[str, Array], Array]:
    """nav and P (..., 16, 16) of slaves that take over what their masters report at first, and turn as they do."""
    nav, P = begin(model, scenario, belief, v_m_n=came.v_m_n[0], q_m2n_wxyz=came.q_m2n_wxyz[0],
                   position=came.true.slave.position[0])  # fmt: skip
    swing = np.cross(came.true.dtheta[0] * scenario.navigation_hz, scenario.lever_b)
    C_b2n = rotation.matrix_from_quaternion(nav["q_b2n_wxyz"])
    return nav | {"v_n": came.v_m_n[0] + np.einsum("...ij,...j->...i", C_b2n, swing)}, P
