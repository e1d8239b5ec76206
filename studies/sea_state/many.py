"""A transfer alignment at sea, flown as often as asked for: one motion, one sea state, one filter to each run.

The scenario is that of `flight`, and so is the filter's start.  Here the filter is the plain extended Kalman filter of
the generated C, without what `Transfer` watches and judges beside it: attitude, then velocity, once a second.

In a random sea the truth is one of `SEAS` seas, each of them shared by `TOGETHER` neighbouring runs; what is drawn for
each run is the delay, the biases and all noise.  An interval of the runner is one for these seas.
"""

from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.compiled import CompiledFilter
from boresight.runtime.library import Library, load
from boresight.runtime.runs import Experiment
from boresight.runtime.simulation import sensors
from boresight.runtime.transfer import Message
from boresight.runtime.units import DEG, HOUR, MIL, MILLI_G
from boresight.studies.consistency import nees
from boresight.studies.sea_state import flight as at_sea

MODEL = "velocity-attitude"
SEAS, TOGETHER = 32, 64
NODES = 6  # of the polynomial by which the master's pose depends on the delay
SPAN = 4  # samples of a rate at an update, the mean over them


@dataclass(frozen=True)
class Sea:
    """What is flown: a motion of `flight.MOTIONS` and a sea state of `flight.GRADES`."""

    motion: str = "sea"
    grade: int = 4
    scenario: at_sea.Scenario = field(default_factory=lambda: at_sea.Scenario(covariance_hz=1))


def experiment(sea: Sea) -> Experiment:
    """The final error of each of sixteen states and its sigma, the heading's error, NEES and NIS, of each run."""
    if sea.motion not in at_sea.MOTIONS:
        raise BoresightError(f"no motion {sea.motion!r}; there are {', '.join(at_sea.MOTIONS)}")
    if sea.grade not in at_sea.GRADES:
        raise BoresightError(f"no sea state {sea.grade}; there are {', '.join(map(str, at_sea.GRADES))}")
    s = at_sea.checked(sea.scenario)
    if s.covariance_hz != s.update_hz or s.seconds <= at_sea.SETTLED_S or s.bending_mrad or s.gyro_misalignment_mrad:
        raise BoresightError(
            f"many: the covariance goes with the updates, for more than {at_sea.SETTLED_S} s, over a hull that does "
            "not bend, with gyros at right angles"
        )
    states = load(MODEL).states
    units = [*["rad"] * 3, *["m/s"] * 3, *["rad/s"] * 3, *["m/s^2"] * 3, *["rad"] * 3, "s"]
    columns = dict(zip(states, units, strict=True))
    columns |= {f"sigma_{name}": unit for name, unit in columns.items()}
    columns |= {"heading_mil": "mil", "nees": "", "nis": ""}
    return Experiment(
        "sea", MODEL, columns, fly, sea, expected={"nees": 16.0, "nis": 6.0}, percentiles=("heading_mil",)
    )


# ---- truth, shared


@dataclass(frozen=True)
class Shared:
    """What is true for all runs of one sea.  N samples, U updates."""

    dtheta: Array  # (N, 3) rad
    dv: Array  # (N, 3) m/s
    position: Array  # (U + 1, 3) of the slave
    v_n: Array  # (3,) m/s of the slave, at the end
    q_b2n_wxyz: Array  # (4,)
    q_b2m_wxyz: Array  # (4,)
    delays: Array  # (NODES,) s, at which the master's pose is known
    master: Array  # (NODES, U + 1, 7): v_n and q_m2n_wxyz
    P: Array  # (16, 16) with which a filter begins


@lru_cache(maxsize=SEAS)
def shared(sea: Sea, seed: int, number: int) -> Shared:
    """The truth of a sea by its number; of a motion that is not random there is one."""
    s = replace(sea.scenario, height_m=(sea.scenario.height_m[sea.grade - 1],))
    model = load(MODEL)
    turn = np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES)  # Chebyshev's
    delays = 1e-3 * (sum(s.delay_ms) + (s.delay_ms[1] - s.delay_ms[0]) * turn) / 2
    stream = sensors.generator(seed, number)  # whose key is a hash, and no [seed, run]
    drawn = at_sea.Drawn(delays, np.zeros((1, 3)), np.zeros((1, 3)), np.eye(3)[None, None], (stream,))
    true = at_sea.truth(model, at_sea.motion_of(sea.motion, s, drawn.streams), s, drawn)
    per_update = s.navigation_hz // s.update_hz
    ends = true.slave.nav(slice(None, None, per_update))
    one = (slice(None), 0, 0)
    master = np.concatenate([true.master.v_n, true.master.q_b2n_wxyz], axis=-1)[:, 0]
    opening = Message(
        time=0.0, R=at_sea.matching_variances(s), rows=np.ones(6, bool), v_m_n=master[0, 0, :3],
        q_m2n_wxyz=master[0, 0, 3:], position=ends["position"][0, 0, 0],
    )  # fmt: skip
    _, P = at_sea.begin(model, opening, s, at_sea.Belief())
    return Shared(
        true.dtheta[one], true.dv[one], ends["position"][one], ends["v_n"][-1, 0, 0], ends["q_b2n_wxyz"][-1, 0, 0],
        true.q_b2m_wxyz[-1].reshape(4), delays, np.moveaxis(master, 1, 0), P,
    )  # fmt: skip


def late(true: Shared, delay: Array) -> tuple[Array, Array]:
    """The master's v_n (U + 1, runs, 3) and q_m2n_wxyz (U + 1, runs, 4), each run's as old as its delay (runs,)."""
    pose = np.zeros((true.master.shape[1], len(delay), 7))
    for i, node in enumerate(true.delays):
        weight = np.ones(len(delay))
        for other in np.delete(true.delays, i):
            weight *= (delay - other) / (node - other)
        pose += weight[:, None] * true.master[i][:, None]
    q = pose[..., 3:]
    return pose[..., :3], q / np.sqrt(summed(q * q))[..., None]


# ---- many flights over it


def fly(model: Library, sea: Sea, seed: int, runs: range) -> Array:
    """Final states (len(runs), columns), as `experiment` names them."""
    number = np.array(runs) // TOGETHER % SEAS if sea.motion == "sea" else np.zeros(len(runs), int)
    cuts = [0, *(np.flatnonzero(np.diff(number)) + 1).tolist(), len(runs)]
    parts = [over_one(model, sea, seed, runs[a:b], int(number[a])) for a, b in pairwise(cuts)]
    return np.concatenate(parts)


def over_one(model: Library, sea: Sea, seed: int, runs: range, number: int) -> Array:
    """The same for runs of one sea."""
    s, true = sea.scenario, shared(sea, seed, number)
    n, updates, per_update = len(runs), s.seconds * s.update_hz, s.navigation_hz // s.update_hz
    dt = 1 / s.navigation_hz
    streams = [np.random.Generator(np.random.Philox(key=[seed, run])) for run in runs]
    part = np.array([stream.random() for stream in streams])
    delay = 1e-3 * (s.delay_ms[0] + (s.delay_ms[1] - s.delay_ms[0]) * part)
    drawn = np.array([stream.standard_normal(6 * (updates + 2)) for stream in streams]).reshape(n, -1, 6)
    bias = drawn[:, 0] * np.repeat([s.gyro_bias_deg_h * DEG / HOUR, s.accel_bias_mg * MILLI_G], 3)
    noise = np.moveaxis(drawn[:, 1:], 1, 0)  # (U + 1, runs, 6)
    v_m_n, q_m2n = late(true, delay)
    v_m_n = v_m_n + s.velocity_noise_m_s * noise[..., :3]
    q_m2n = times(small(s.attitude_noise_deg * DEG * noise[..., 3:]), q_m2n)  # a turn in level axes

    given, R = at_sea.constants(s), at_sea.matching_variances(s)
    walk = np.repeat([given["gyro_noise"][0], given["accel_noise"][0]], 3) * np.sqrt(dt)
    swing = np.cross(true.dtheta[0] / dt, s.lever_b)
    nav = {
        "position": np.broadcast_to(true.position[0], (n, 3)), "q_b2n_wxyz": q_m2n[0],
        "v_n": v_m_n[0] + turned(q_m2n[0], swing), "gyro_bias": np.zeros((n, 3)), "accel_bias": np.zeros((n, 3)),
        "q_b2m_wxyz": np.broadcast_to([1.0, 0, 0, 0], (n, 4)), "tau": np.zeros(n),
    }  # fmt: skip
    loop = CompiledFilter(model, nav, np.broadcast_to(true.P, (n, 16, 16)))
    before = None
    ideal = np.concatenate([true.dtheta, true.dv], axis=-1)
    nis = np.zeros(n)
    for update in range(1, updates + 1):
        sensed = np.array([stream.standard_normal((per_update, 6)) for stream in streams])
        sensed *= walk
        sensed += ideal[(update - 1) * per_update : update * per_update]
        sensed += (bias * dt)[:, None]
        samples = np.ascontiguousarray(np.moveaxis(sensed, 1, 0))  # (samples, runs, 6)
        half = per_update // 2
        before = strapdown(loop, samples[:half], before, dt)
        f_b = summed_over(samples)[:, 3:] / (per_update * dt) - loop.nav["accel_bias"]
        loop.predict(f_b=f_b, dt=per_update * dt, **given)  # linearised in the middle of what it carries P over
        before = strapdown(loop, samples[half:], before, dt)
        loop.nav["position"] = np.broadcast_to(true.position[update], (n, 3)).copy()
        message = {"v_m_n": v_m_n[update], "q_m2n_wxyz": q_m2n[update], "lag": loop.nav["tau"]}
        now = moving(model, loop, samples[-2 * SPAN :], dt, given) | message | given
        one = loop.update("dcm", R[3:], **now)
        other = loop.update("velocity", R[:3], **now)
        loop.feedback()
        if update > at_sea.SETTLED_S * s.update_hz:
            nis += one.nis + other.nis
    error = np.concatenate(
        [
            rotation.attitude_error(loop.nav["q_b2n_wxyz"], true.q_b2n_wxyz),
            loop.nav["v_n"] - true.v_n,
            loop.nav["gyro_bias"] - bias[:, :3],
            loop.nav["accel_bias"] - bias[:, 3:],
            rotation.attitude_error(loop.nav["q_b2m_wxyz"], true.q_b2m_wxyz),
            (loop.nav["tau"] - delay)[:, None],
        ],
        axis=-1,
    )
    settled = updates - at_sea.SETTLED_S * s.update_hz
    sigma = np.sqrt(np.einsum("...ii->...i", loop.P))
    more = [np.abs(error[:, 2]) / MIL, nees(error, loop.P), nis / settled]
    return np.concatenate([error, sigma, np.stack(more, axis=-1)], axis=-1)


def strapdown(loop: CompiledFilter, samples: Array, before: Array | None, dt: float) -> Array:
    """Carry nav over samples (T, runs, 6); returns the last one."""
    for sample in samples:
        earlier = sample if before is None else before
        loop.strapdown(dtheta_ib_b=sample[:, :3], dv_b=sample[:, 3:], dtheta_before=earlier[:, :3],
                       dv_before=earlier[:, 3:], dt=dt)  # fmt: skip
        before = sample
    assert before is not None
    return before


def moving(model: Library, loop: CompiledFilter, last: Array, dt: float, given: dict[str, Any]) -> dict[str, Array]:
    """How the slave turns and how its master is accelerated now, by the last 2 SPAN samples (2 SPAN, runs, 6)."""
    earlier, later = (summed_over(part) / (SPAN * dt) for part in (last[:SPAN], last[SPAN:]))
    rates = later + (later - earlier) / 2  # the later one is that of SPAN / 2 samples ago
    omega, f_b = rates[:, :3] - loop.nav["gyro_bias"], rates[:, 3:] - loop.nav["accel_bias"]
    alpha = (later - earlier)[:, :3] / (SPAN * dt)
    lever = given["lever_b"]
    at_master = f_b - np.cross(alpha, lever) - np.cross(omega, np.cross(omega, lever))
    a_n = turned(loop.nav["q_b2n_wxyz"], at_master) + np.array([0.0, 0.0, 9.798])  # 0.01 m/s^2 for 10 ms are nothing
    return {"omega_ib_b": omega, "a_n": a_n}


def summed(values: Array) -> Array:
    """Over the last axis, one number after the other, whatever else there is."""
    total = values[..., 0]
    for i in range(1, values.shape[-1]):
        total = total + values[..., i]
    return total


def summed_over(values: Array) -> Array:
    """The same over the first."""
    total = values[0]
    for value in values[1:]:
        total = total + value
    return total


def small(turn: Array) -> Array:
    """exp([v x]) of a turn (..., 3) rad below a millirad, as a quaternion (..., 4)."""
    q = np.concatenate([np.ones((*turn.shape[:-1], 1)), turn / 2], axis=-1)
    return q / np.sqrt(summed(q * q))[..., None]


def times(p: Array, q: Array) -> Array:
    """Product of quaternions (..., 4)."""
    (a, b, c, d), (e, f, g, h) = np.moveaxis(p, -1, 0), np.moveaxis(q, -1, 0)
    return np.stack(
        [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g,
         a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e], axis=-1,
    )  # fmt: skip


def turned(q: Array, vector: Array) -> Array:
    """C of q (..., 4) times a vector (..., 3)."""
    w, axis = q[..., :1], q[..., 1:]
    twice = 2 * np.cross(axis, vector)
    return vector + w * twice + np.cross(axis, twice)
