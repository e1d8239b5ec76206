"""Flights of a transfer alignment at sea, after Kang and others (2025): hull, sensors, filter, many runs at once.

A MEMS slave beside a good master on one hull, turned by 2 degrees in heading; the master's data is 5 to 10 ms late.
Sixteen states, velocity and attitude matched once a second for a minute.  The paper gives wave heights and (6), and not
how a wave moves its platform: `MOTIONS` are three answers.  docs/sea-state.md says what else it leaves open.

Axes of arrays: time, then filter (with compensation, without), sea state, run; then components.
"""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any, Literal

import numpy as np

from boresight import BoresightError
from boresight.runtime import rotation, transfer
from boresight.runtime.array import Array
from boresight.runtime.simulation import hull, inertial, sea, sensors
from boresight.runtime.transfer import Message, Rules, Transfer
from boresight.runtime.units import DEG, HOUR, MILLI_G

GRADES = (1, 2, 3, 4, 5, 6)
HEIGHT_M = (0.01, 0.1, 0.5, 1.25, 2.5, 4.0)  # the paper's Table 1: the lower ends of the WMO's code 3700
FILTERS = ("with", "without")  # compensation of the delay
MOTIONS = {
    "wave": "(a) equation (6) as heave, and nothing else",
    "slope": "(b) heave by (6), and roll, pitch, yaw by the slope of that wave",
    "sea": "(c) a Pierson-Moskowitz sea through the response of a 40 m hull",
}
PHI, DV = slice(0, 3), slice(3, 6)
# Every message is taken: without compensation nothing fits, and what becomes of that is the question.
RULES = Rules(gate=1e-300, ahead_s=0.2)


@dataclass(frozen=True)
class Scenario:
    """One experiment.  What is random is one sigma, drawn for each run and constant in it."""

    # The paper's: Tables 1 and 2, and its text.
    height_m: tuple[float, ...] = HEIGHT_M
    frequency_hz: float = 0.1
    misalignment_deg: float = 2.0  # in heading, of every run
    delay_ms: tuple[float, float] = (5.0, 10.0)
    navigation_hz: int = 100
    update_hz: int = 1
    seconds: int = 60
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


def checked(scenario: Scenario) -> Scenario:
    """The scenario; raises BoresightError for a value that has no meaning."""
    signed = ("slope_ratio", "slope_phase_deg", "waves_deg", "heading_deg", "latitude_deg", "lever_b", "speed_m_s",
              "misalignment_deg")  # fmt: skip
    for name, value in asdict(scenario).items():
        numbers = np.asarray(value, float)
        if not np.isfinite(numbers).all() or (name not in signed and (numbers < 0).any()):
            raise BoresightError(
                f"sea-state: {name} is {value}; it must be finite" + " and not negative" * (name not in signed)
            )
    for name in ("velocity_noise_m_s", "attitude_noise_deg", "frequency_hz", "seconds"):
        if getattr(scenario, name) == 0:
            raise BoresightError(f"sea-state: {name} is 0; it must be above zero")
    s = scenario
    if s.covariance_hz < 1 or s.navigation_hz % s.covariance_hz or s.update_hz < 1 or s.covariance_hz % s.update_hz:
        raise BoresightError(
            f"sea-state: navigation_hz {s.navigation_hz} must be a multiple of covariance_hz {s.covariance_hz}, "
            f"and that of update_hz {s.update_hz}"
        )
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
    gyro_gain: Array  # (1 or states, runs, 3, 3): axes of the gyros that are not quite at right angles
    streams: tuple[np.random.Generator, ...]


def draw(scenario: Scenario, seed: int, runs: int, first_run: int = 0) -> Drawn:
    """Keyed by [seed, run], whatever runs are flown beside it; the same in every sea state and motion."""
    s = scenario
    streams = tuple(sensors.generator(seed, run) for run in range(first_run, first_run + runs))
    part = np.array([stream.random() for stream in streams])
    n = np.array([stream.standard_normal(12) for stream in streams])
    askew = np.zeros((runs, 3, 3))
    askew[:, [0, 0, 1, 1, 2, 2], [1, 2, 0, 2, 0, 1]] = 1e-3 * n[:, 6:]
    gain = np.eye(3) + np.atleast_1d(s.gyro_misalignment_mrad)[:, None, None, None] * askew
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


def truth(model: Any, motion: hull.Motion, scenario: Scenario, drawn: Drawn) -> Truth:
    """The slave's ideal increments and the master's late reports."""
    s = scenario
    dt, per_update = 1 / s.navigation_hz, s.navigation_hz // s.update_hz
    time = np.arange(s.seconds * s.navigation_hz + 1) * dt
    mounting = rotation.quaternion_from_euler(np.array([0.0, 0.0, s.misalignment_deg]) * DEG)
    bending, q_b2m = None, np.broadcast_to(mounting, (len(time[::per_update]), 1, 1, 4))
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


def start(model: Any, scenario: Scenario, first: Message) -> tuple[dict[str, Array], Array]:
    """nav and P of both filters, (2, 6, runs, ...), from the master's first message."""
    s = scenario
    sigma = np.array([s.delay_sigma_ms * 1e-3, 0.0])[:, None, None]  # without compensation the delay is known, and zero
    nav, P, _ = transfer.first(
        first,
        model,
        constants(s),
        sigmas={
            "q_b2m_wxyz": np.array([s.level_misalignment_deg, s.level_misalignment_deg, s.misalignment_deg]) * DEG,
            "gyro_bias": s.gyro_bias_deg_h * DEG / HOUR,
            "accel_bias": s.accel_bias_mg * MILLI_G,
            "tau": sigma,
        },
        rate_sigma=0.0,
        acceleration_sigma=0.0,
    )
    # The scenario says what the motion and the delay do to the start.
    P[..., DV, DV] += np.eye(3) * s.start_velocity_m_s**2
    P[..., PHI, PHI] += np.eye(3) * (s.start_angle_deg * DEG) ** 2
    return nav, P


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
class Flight:
    """(U + 1, 2 filters, 6 states of the sea, runs, ...); nis, of an update, is U long."""

    error: Array  # (U + 1, ..., 16) computed - true, in the order of the model's states
    P: Array  # (U + 1, ..., 16, 16)
    nis: Array  # (U, ..., 2): velocity and attitude, three rows each
    delay: Array  # (runs,) s, true

    @property
    def heading(self) -> Array:
        """yaw_hat - yaw of the slave, rad: minus the third part of phi."""
        return -self.error[..., 2]

    @property
    def heading_sigma(self) -> Array:
        return np.sqrt(self.P[..., 2, 2])


def fly(
    model: Any,
    kind: str | hull.Motion,
    scenario: Scenario,
    *,
    runs: int,
    seed: int,
    first_run: int = 0,
    way: Literal["extrapolate", "buffer"] = "extrapolate",
    matching: tuple[str, str] = ("velocity", "dcm"),
    delay_s: Any = None,
    noise: float = 1.0,
) -> Flight:
    """Both filters in every sea state, each run with its own delay, biases and noise, keyed by [seed, run].

    kind: one of MOTIONS, or a motion of shape (states, 1) or (states, runs) in the place of the six sea states.
    way, matching: of `transfer.Transfer`; "extrapolate" and "dcm" are the paper's.  delay_s: instead of the drawn one,
    as (states, runs) broadcasts.  noise: a factor on all that is drawn but the delay; the filter is told the same.
    """
    s = checked(scenario)
    dt, per_update = 1 / s.navigation_hz, s.navigation_hz // s.update_hz
    drawn = draw(s, seed, runs, first_run)
    if delay_s is not None:
        drawn = replace(drawn, delay=np.asarray(delay_s, float))
    motion = motion_of(kind, s, drawn.streams) if isinstance(kind, str) else kind
    true = truth(model, motion, s, drawn)
    q_late = true.master.q_b2n_wxyz
    R = np.repeat([s.velocity_noise_m_s, s.attitude_noise_deg * DEG], 3) ** 2

    def message(update: int) -> Message:
        n = noise * np.array([stream.standard_normal(6) for stream in drawn.streams])
        # a turn in level axes, as the master's axes see it
        C = rotation.matrix_from_quaternion(q_late[update])
        turn = np.einsum("...ji,...j->...i", C, s.attitude_noise_deg * DEG * n[:, 3:])
        return Message(
            time=update / s.update_hz,  # when it arrives
            R=R,
            v_m_n=true.master.v_n[update] + s.velocity_noise_m_s * n[:, :3],
            q_m2n_wxyz=rotation.turned(q_late[update], turn),
            position=true.slave.position[update * per_update],  # 3 m from the master's
        )

    first = message(0)
    nav, P0 = start(model, s, first)
    swing = np.cross(true.dtheta[0] / dt, s.lever_b)
    nav["v_n"] = first.v_m_n + np.einsum("...ij,...j->...i", rotation.matrix_from_quaternion(first.q_m2n_wxyz), swing)
    given = constants(s)
    every = s.navigation_hz // s.covariance_hz
    loop = Transfer(model, nav, P0, given, way=way, matching=matching, every=every, rules=RULES)
    walk = np.repeat([given["gyro_noise"][0], given["accel_noise"][0]], 3) * np.sqrt(dt) * noise
    bias_g, bias_a = noise * drawn.gyro_bias, noise * drawn.accel_bias
    gain = np.eye(3) + noise * (drawn.gyro_gain - np.eye(3))
    error, P, nis = [], [], []

    def keep(update: int) -> None:
        at, now = update * per_update, loop.nav
        parts = (
            rotation.attitude_error(now["q_b2n_wxyz"], true.slave.q_b2n_wxyz[at]),
            now["v_n"] - true.slave.v_n[at],
            now["gyro_bias"] - bias_g,
            now["accel_bias"] - bias_a,
            rotation.attitude_error(now["q_b2m_wxyz"], true.q_b2m_wxyz[update]),
            (now["tau"] - drawn.delay)[..., None],
        )
        error.append(np.concatenate(parts, axis=-1))
        P.append(loop.P)

    keep(0)
    for update in range(1, s.seconds * s.update_hz + 1):
        n = walk * np.array([stream.standard_normal((per_update, 6)) for stream in drawn.streams])
        for k in range(per_update):
            at = (update - 1) * per_update + k
            dtheta = np.einsum("...ij,...j->...i", gain, true.dtheta[at]) + bias_g * dt + n[:, k, :3]
            loop.slave((at + 1) * dt, dtheta, true.dv[at] + bias_a * dt + n[:, k, 3:], dt)
        taken = loop.master(message(update))
        nis.append(np.stack([one.nis for one in taken.innovations.values()], axis=-1))
        keep(update)
    return Flight(np.array(error), np.array(P), np.array(nis), drawn.delay)
