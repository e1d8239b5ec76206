"""A transfer alignment at sea, flown as often as asked for: one motion, one sea state, one filter to each run.

The scenario is that of `flight`, and so are the filter and its start; the covariance goes with the updates.

In a random sea the truth is one of `SEAS` seas, each of them shared by `TOGETHER` neighbouring runs; what is drawn for
each run is the delay, the biases and all noise.  An interval of the runner is one for these seas.
"""

import ctypes
import math
from dataclasses import astuple, dataclass, field
from decimal import Decimal
from functools import lru_cache
from itertools import pairwise
from pathlib import Path

import numpy as np

from boresight import BoresightError
from boresight.runtime import random
from boresight.runtime.array import Array
from boresight.runtime.gpu import text
from boresight.runtime.library import Library, load
from boresight.runtime.manifest import folder_of
from boresight.runtime.runs import Experiment
from boresight.runtime.simulation import hull
from boresight.runtime.status import Status
from boresight.runtime.units import DEG, HOUR, MILLI_G
from boresight.studies.sea_state import flight as at_sea
from boresight.studies.sea_state.matching import GRAVITY, SPAN_S, Matching, swing_variance, turned

MODEL = "velocity-attitude"
SEAS, TOGETHER = 32, 256
DRAWN = 8  # samples at a time, in C: the numbers of three groups
NODES = 6  # of the polynomial by which the master's pose depends on the delay
SLAVE, MASTER, DELAY = 0, 1, 2  # streams of random numbers of a run
NAV = ("lat_lon_height", "v_n", "q_b2n_wxyz", "gyro_bias", "accel_bias", "q_b2m_wxyz", "tau")
SOURCE, TRUTH, MOST_SPAN = Path(__file__).with_name("many.c"), Path(__file__).with_name("truth.c"), 16
OF_SEA = {"P": (16, 16), "position": (3,), "swing": (3,), "v_n": (3,), "q_b2n_wxyz": (4,), "q_b2m_wxyz": (4,),
          "delays": (NODES,)}  # fmt: skip


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
            f"many: covariance_hz must be update_hz, seconds above {at_sea.SETTLED_S}, and bending_mrad and "
            "gyro_misalignment_mrad zero"
        )
    states = load(MODEL).states
    units = [*["rad"] * 3, *["m/s"] * 3, *["rad/s"] * 3, *["m/s^2"] * 3, *["rad"] * 3, "s"]
    columns = dict(zip(states, units, strict=True))
    columns |= {f"sigma_{name}": unit for name, unit in columns.items()}
    columns |= {"heading_mil": "mil", "nees": "", "nis": ""}
    return Experiment(
        "sea", MODEL, columns, fly, sea, expected={"nees": 16.0, "nis": 6.0}, percentiles=("heading_mil",),
        in_c=SOURCE.name, given=numbers,
    )  # fmt: skip


# ---- truth, shared


@dataclass(frozen=True)
class Shared:
    """What is true for all runs of one sea, as truth.c writes it and many.c reads it.  N samples, U updates."""

    numbers: Array  # all that follows
    updates: int

    def __post_init__(self) -> None:
        at = 0
        for name, shape in OF_SEA.items():
            size = math.prod(shape)
            object.__setattr__(self, name, self.numbers[at : at + size].reshape(shape))
            at += size
        poses = NODES * (self.updates + 1) * 7
        object.__setattr__(self, "master", self.numbers[at : at + poses].reshape(NODES, -1, 7))
        object.__setattr__(self, "ideal", self.numbers[at + poses :].reshape(self.updates, -1))

    P: Array = field(init=False)  # (16, 16) with which a filter begins
    position: Array = field(init=False)  # (3,) of the slave, at the start
    swing: Array = field(init=False)  # (3,) m/s in the slave's axes: its velocity about the master, at the start
    v_n: Array = field(init=False)  # (3,) m/s of the slave, at the end
    q_b2n_wxyz: Array = field(init=False)  # (4,)
    q_b2m_wxyz: Array = field(init=False)  # (4,)
    delays: Array = field(init=False)  # (NODES,) s, at which the master's pose is known
    master: Array = field(init=False)  # (NODES, U + 1, 7): v_n and q_m2n_wxyz
    ideal: Array = field(init=False)  # (U, N / U * 6) rad, m/s: samples, in each the components from the last on


@lru_cache(maxsize=SEAS)
def shared(sea: Sea, seed: int, number: int) -> Shared:
    """The truth of a sea by its number; of a motion that is not random there is one."""
    s = sea.scenario
    updates, samples = s.seconds * s.update_hz, s.navigation_hz // s.update_hz
    out = np.empty(sum(map(math.prod, OF_SEA.values())) + NODES * (updates + 1) * 7 + 6 * updates * samples)
    at = [array.ctypes.data_as(ctypes.c_void_p) for array in (common(sea), scene(sea), out)]
    function = text.library(folder_of(MODEL), TRUTH).sea_truth
    status = function(*at[:2], ctypes.c_uint64(seed), ctypes.c_uint64(number), at[2])
    if status:
        raise BoresightError(
            f"many: no sensor increments make this motion in sea state {sea.grade} ({Status(status).name})"
            if status > 0
            else f"many: no sensor increments make this motion in sea state {sea.grade}; sample it more often"
        )
    return Shared(out, updates)


def late(true: Shared, delay: Array) -> tuple[Array, Array]:
    """The master's v_n (U + 1, runs, 3) and q_m2n_wxyz (U + 1, runs, 4), each run's as old as its delay (runs,)."""
    pose = np.zeros((true.master.shape[1], 7, len(delay)))
    for i, node in enumerate(true.delays):
        weight = np.ones(len(delay))
        for other in np.delete(true.delays, i):
            weight *= (delay - other) / (node - other)
        pose += weight * true.master[i][..., None]
    pose = pose.swapaxes(1, 2)
    return pose[..., :3], normal(pose[..., 3:])


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
    every = np.array(runs)
    part = (random.words(seed, every, 1, stream=DELAY)[:, 0] >> np.uint64(11)) * 2.0**-53
    delay = 1e-3 * (s.delay_ms[0] + (s.delay_ms[1] - s.delay_ms[0]) * part)
    drawn = random.normals(seed, every, 6 * (updates + 2), stream=MASTER).reshape(n, -1, 6)
    # Nothing depends on a bias but its estimate's error: the sensors have none, and the estimate begins with the error.
    bias = drawn[:, 0] * bias_sigmas(s)
    noise = np.moveaxis(drawn[:, 1:], 1, 0)  # (U + 1, runs, 6)
    v_m_n, q_m2n = late(true, delay)
    v_m_n = v_m_n + s.velocity_noise_m_s * noise[..., :3]
    q_m2n = times(small(s.attitude_noise_deg * DEG * noise[..., 3:]), q_m2n)  # a turn in level axes

    given = at_sea.constants(s)
    swing = np.repeat(true.swing[:, None], n, axis=1)
    nav = {
        "lat_lon_height": np.broadcast_to(true.position, (n, 3)), "q_b2n_wxyz": q_m2n[0],
        "v_n": v_m_n[0] + turned(q_m2n[0].T, swing).T, "gyro_bias": bias[:, :3], "accel_bias": bias[:, 3:],
        "q_b2m_wxyz": np.broadcast_to([1.0, 0, 0, 0], (n, 4)), "tau": np.zeros(n),
    }  # fmt: skip
    flown = Matching(model, s, nav, true.P[None], given, at_sea.matching_variances(s))  # one P of all, checked once
    loop = flown.loop

    # from the oldest to the newest, and in each sample from the last component to the first
    oldest = flown.samples.reshape(n, -1)[:, 6 * per_update - 1 :: -1]
    scale = np.tile(walk(s), per_update)
    width, nis = model.lanes(n)[0], np.zeros(n)
    for k in range(updates):
        random.normals(seed, every, 6 * per_update, 6 * per_update * k, SLAVE, oldest, width, scale, true.ideal[k])
        flown.update(q_m2n_wxyz=q_m2n[k + 1], v_m_n=v_m_n[k + 1])
        if k >= at_sea.SETTLED_S * s.update_hz:
            nis += flown.nis.sum(0)
    ends = np.concatenate([loop.nav.seen(name).reshape(n, -1) for name in NAV], axis=-1)
    nis /= updates - at_sea.SETTLED_S * s.update_hz
    rows, P = np.empty((n, 35)), np.ascontiguousarray(loop.P)
    at = (ctypes.c_void_p(part.ctypes.data) for part in (ends, P, true.numbers, delay, nis, rows))
    text.host(folder_of(MODEL), SOURCE).sea_rows(ctypes.c_size_t(n), *at)
    rows[flown.lost] = np.nan
    return rows


def bias_sigmas(s: at_sea.Scenario) -> Array:
    """(6,) rad/s and m/s^2."""
    return np.repeat([s.gyro_bias_deg_h * DEG / HOUR, s.accel_bias_mg * MILLI_G], 3)


def walk(s: at_sea.Scenario) -> Array:
    """(6,) m/s and rad, the sigmas of a sample from its last component to the first."""
    given = at_sea.constants(s)
    return np.repeat([given["accel_noise"][0], given["gyro_noise"][0]], 3) * np.sqrt(1 / s.navigation_hz)


# ---- the same in C


def numbers(model: Library, sea: Sea, seed: int, runs: range) -> Array:
    """What many.c reads: the scenario, and the seas of these runs, the others zero."""
    seas, together = together_of(sea)
    lots = range(runs.start // together, (runs.stop - 1) // together + 1)[:seas]
    parts = {lot % seas: shared(sea, seed, lot % seas).numbers for lot in lots}
    nothing = np.zeros_like(next(iter(parts.values())))
    return np.concatenate([common(sea), *(parts.get(number, nothing) for number in range(seas))])


def together_of(sea: Sea) -> tuple[int, int]:
    """How many seas there are, and how many neighbouring runs share one."""
    return (SEAS, TOGETHER) if sea.motion == "sea" else (1, 1)


def common(sea: Sea) -> Array:
    """The scenario, as sea.h has it."""
    s, known = sea.scenario, at_sea.constants(sea.scenario)
    lever, dt, span = known["lever_b"], 1 / s.navigation_hz, round(SPAN_S * s.navigation_hz)
    if span > MOST_SPAN:
        raise BoresightError(f"many: a rate of change over {span} samples; the C takes at most {MOST_SPAN}")
    R = at_sea.matching_variances(s)
    swung = swing_variance(known["gyro_noise"][0], span * dt, lever)
    parts = [
        s.seconds * s.update_hz, at_sea.SETTLED_S * s.update_hz, s.navigation_hz // s.update_hz, span,
        *together_of(sea), dt, GRAVITY, s.delay_ms[0], s.delay_ms[1] - s.delay_ms[0], *bias_sigmas(s),
        s.velocity_noise_m_s, s.attitude_noise_deg * DEG, *lever, *known["gyro_noise"], *known["accel_noise"],
        *known["mu_noise"], *R[3:], *(R[:3] + swung), *np.tile(walk(s), DRAWN),
    ]  # fmt: skip
    return np.array(parts, float)


def scene(sea: Sea) -> Array:
    """What truth.c reads beside it."""
    s = sea.scenario
    sigmas = s.level_misalignment_deg * DEG, s.level_misalignment_deg * DEG, s.misalignment_deg * DEG
    slopes = s.slope_ratio if sea.motion == "slope" else np.zeros(3)
    parts = [
        [*at_sea.MOTIONS].index(sea.motion), s.height_m[sea.grade - 1], float(Decimal(s.spectrum_gamma).ln()),
        s.frequency_hz, *slopes, *np.array(s.slope_phase_deg) * DEG,
        s.waves_deg * DEG, s.speed_m_s, s.heading_deg * DEG, s.latitude_deg * DEG, s.misalignment_deg * DEG,
        *bias_sigmas(s), *sigmas, s.delay_sigma_ms * 1e-3, s.start_velocity_m_s, s.start_angle_deg * DEG,
        *astuple(hull.Hull()),
    ]  # fmt: skip
    return np.array(parts, float)


def small(turn: Array) -> Array:
    """exp([v x]) of a turn (..., 3) rad below a millirad, as a quaternion (..., 4)."""
    q = np.concatenate([np.ones((*turn.shape[:-1], 1)), turn / 2], axis=-1)
    return normal(q)


def normal(q: Array) -> Array:
    """(..., 4) of norm 1."""
    w, x, y, z = np.moveaxis(q, -1, 0)
    return q / np.sqrt(w * w + x * x + y * y + z * z)[..., None]


def times(p: Array, q: Array) -> Array:
    """Product of quaternions (..., 4)."""
    (a, b, c, d), (e, f, g, h) = np.moveaxis(p, -1, 0), np.moveaxis(q, -1, 0)
    return np.stack(
        [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g,
         a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e], axis=-1,
    )  # fmt: skip
