"""Passes of the C filter over a recording: all messages are known beforehand, each is taken at its own instant.

Nothing comes late here, so that no past is kept: the strapdown goes to the instant of a message, which is its stamp
less the delay that the pass begins with, and the measurement is taken there.  What the delay's estimate differs from
that one is the `lag` of the model.
"""

import json
from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.compiler import in_lanes, open_library, shared_library
from boresight.runtime.filter import CompiledFilter, Epoch
from boresight.runtime.library import Library
from boresight.runtime.live import Fate
from boresight.runtime.manifest import folder_of, read_manifest
from boresight.runtime.recording import Inertial
from boresight.runtime.simulation.sensors import EARTH_RATE_RAD_S
from boresight.runtime.transfer.history import ACCEL_BIAS, GYRO_BIAS, TAU
from boresight.runtime.transfer.score import Score

COVARIANCE_S = 0.1  # at most, between two steps of it
HALF_SPAN_S = 0.02  # rates at a message are means over twice this
SHORTEST_S = 2e-6  # what is shorter is left out
STRETCH_S = 0.5  # of the past, in which the noise of rates is seen
INFORMS = 8.0  # how far above its noise a rate is that informs the delay
JOINT = 1400.0  # NIS of three rows that no filter which is nearly right comes to
FOUND = {"gyro_bias": GYRO_BIAS, "accel_bias": ACCEL_BIAS, "tau": slice(TAU, TAU + 1)}  # in x
TURNS, MOST_TURN = np.r_[0:3, 12:15], 0.45  # rad; the box of x ends at .5
STILL = 0.02, 0.01  # rad/s and m/s
SENSED = ("dtheta_ib_b", "dv_b", "dtheta_before", "dv_before")
SIDE_BY_SIDE = 2  # runs that a replay's C computes at a time


class Replayed(Library):
    """A model whose C for one run and for several side by side is one library: `load` compiles one for each."""

    def lanes(self, runs: int) -> tuple[int, Any]:
        return SIDE_BY_SIDE, self.dll


def compiled(model: str) -> Replayed:
    """The functions and the filter of a built-in model, as `load` gives them, in half of the time that it compiles."""
    folder = folder_of(model)
    manifest = read_manifest(folder)
    files = [path for path in manifest["files"] if path.endswith(".c") and path.startswith(("src/", "batch/"))]
    sources = {folder / path: in_lanes(SIDE_BY_SIDE) if path.endswith("_lanes.c") else () for path in files}
    contents = json.dumps(manifest["files"], sort_keys=True)
    made = shared_library(f"{folder.name}-replay", contents, sources, folder / "include")
    return Replayed(manifest, open_library(*made), folder=folder, widest=SIDE_BY_SIDE)


@dataclass(frozen=True)
class Steps:
    """What the sensors delivered, cut at instants; the same for all runs."""

    first: Array  # (J + 1,) of each part the number of its first piece
    dt: Array  # (M,) s of each piece
    dtheta_ib_b: Array  # (M, 3) rad
    dv_b: Array  # (M, 3) m/s
    dtheta_before: Array  # (M, 3) as long, at the rate of the sample before
    dv_before: Array


def pieces(imu: Inertial, cuts: Array) -> Steps:
    """Between neighbours of `cuts` (J + 1,) s, which lie inside the data.  A hole goes at the rate of what follows.

    In a sample that an instant cuts, the rate changes as from the sample before to the one behind, by the part of such
    changes that is no noise.
    """
    start, end, dtheta, dv = imu.increments
    rates = np.concatenate([dtheta, dv], axis=-1) / own_length(imu)[:, None]
    inside = end[(end > cuts[0]) & (end < cuts[-1])]
    edges = np.unique(np.concatenate([cuts, inside]))
    dt = np.diff(edges)
    sample = np.minimum(np.searchsorted(end, edges[:-1] + dt / 2), len(end) - 1)
    keep = dt > SHORTEST_S
    edges, dt, sample = edges[:-1][keep], dt[keep], sample[keep]
    slope = (np.gradient(rates, (start + end) / 2, axis=0) * steadiness(rates))[sample]
    off = edges + dt / 2 - (start + end)[sample] / 2
    whole = (np.abs(off) < SHORTEST_S)[:, None]
    now = np.where(whole, rates[sample], rates[sample] + slope * off[:, None]) * dt[:, None]
    before = np.where(whole, rates[np.maximum(sample - 1, 0)] * dt[:, None], now - slope * np.square(dt)[:, None])
    first = np.searchsorted(edges, cuts - SHORTEST_S / 2)
    return Steps(first, dt, now[:, :3], now[:, 3:], before[:, :3], before[:, 3:])


def steadiness(rates: Array) -> Array:
    """(6,) the part of the changes over two samples of rates (M, 6) that is no noise, by their third differences."""
    white = np.square(np.diff(rates, 3, axis=0)).mean(axis=0) / 20
    changes = np.square(rates[2:] - rates[:-2]).mean(axis=0)
    return np.clip(1 - 2 * white / np.maximum(changes, 1e-300), 0.0, 1.0)


def own_length(imu: Inertial) -> Array:
    start, end = imu.intervals()
    return end - start


@dataclass(frozen=True)
class Rates:
    """Of the slave at instants (K,): biases in them."""

    omega: Array  # (K, 3) rad/s
    f: Array  # (K, 3) m/s^2
    alpha: Array  # (K, 3) rad/s^2
    gyro: Array  # (K,) rad^2/s, density of the noise of the gyros as it is seen
    accel: Array  # (K,) m^2/s^3
    span: float  # s


def rates(imu: Inertial, at: Array) -> Rates:
    """Means about `at`, and the noise in them by third differences, which take a motion of up to 2 Hz out."""
    start, end, dtheta, dv = imu.increments
    h = max(HALF_SPAN_S, imu.dt)
    times = np.append(start[0], end)
    sums = np.concatenate([np.zeros((1, 6)), np.cumsum(np.concatenate([dtheta, dv], axis=-1), axis=0)])

    def swept(t: Array) -> Array:
        clipped = np.clip(t, times[0], times[-1])
        return np.stack([np.interp(clipped, times, sums[:, i]) for i in range(6)], axis=-1)

    ahead = np.minimum(at + 2 * h, times[-1])
    mean = (swept(ahead - h) - swept(ahead - 3 * h)) / (2 * h)
    change = (swept(ahead) - 2 * swept(ahead - 2 * h) + swept(ahead - 4 * h))[:, :3] / (4 * h * h)
    count = int(STRETCH_S / (2 * h))
    back = swept(at[:, None] - 2 * h * np.arange(count + 1))
    third = np.diff(np.diff(back, axis=1) / (2 * h), 3, axis=1)
    seen = 2 * h * np.square(third).reshape(*third.shape[:2], 2, 3).mean((1, 3)) / 20
    return Rates(mean[:, :3], mean[:, 3:], change, seen[:, 0], seen[:, 1], 2 * h)


def cross(a: Array, b: Array) -> Array:
    """(..., 3), as np.cross, which takes ten times as long."""
    out: Array = a[..., [1, 2, 0]] * b[..., [2, 0, 1]] - a[..., [2, 0, 1]] * b[..., [1, 2, 0]]
    return out


def gravity(position: Array) -> Array:
    """(...,) m/s^2 at (..., 3) lat_lon_height, to 1e-4: what the delay's column needs."""
    sine = np.sin(position[..., 0]) ** 2
    out: Array = 9.780327 * (1 + 0.0053024 * sine) - 3.086e-6 * position[..., 2]
    return out


class Pass:
    """One pass of a filter, of one run or of many side by side.

    loop: as it begins, at `begin` (s).  messages: time (K,) s, v_m_n (K, 3), q_m2n_wxyz (K, 4), position (K, 3).
    delay: s, of their stamps.  constants: of the model's noises and, where it is no state, lever_b.  R: (..., 6)
    variances of velocity and attitude.  considered: (n,) bool.  score: takes part where it is given.
    informs: (K, ..., 2) bool, whether attitude and velocity of a message inform the delay; found here where it is not
    given.  What is compared by likelihood is to have the same.
    After `fly`: taken, the numbers (K,) of the messages that the recording covers, and of each nu, S and used
    (K, ..., 6), verdict (K, ...), variance (K, ..., n) and nav, by field (K, ..., size).
    """

    def __init__(
        self, loop: CompiledFilter, imu: Inertial, begin: float, messages: dict[str, Array], delay: float,
        constants: dict[str, Any], R: Array, considered: Array | None = None, score: Score | None = None,
        informs: Array | None = None,
    ):  # fmt: skip
        self.loop, self.delay, self.constants, self.R = loop, delay, constants, R
        self.considered, self.score = considered, score
        at = messages["time"] - delay
        self.taken = np.flatnonzero((at > begin + SHORTEST_S) & (at <= imu.increments[1][-1]))
        at, self.messages = at[self.taken], {name: value[self.taken] for name, value in messages.items()}
        cuts, self.ends = [begin], [0]
        for t in at:  # steps of the covariance, each with its middle
            a, parts = cuts[-1], max(1, int(np.ceil((t - cuts[-1]) / COVARIANCE_S - 0.01)))
            cuts += [a + (t - a) * i / (2 * parts) for i in range(1, 2 * parts)] + [t]
            self.ends.append(len(cuts) - 1)
        self.steps, self.rates = pieces(imu, np.array(cuts)), rates(imu, at)
        self.doubt = doubts(imu, np.array(cuts)[self.ends])
        self.same = repeated(self.messages, self.rates)
        self.epochs: dict[int, Epoch] = {}
        self.given = None if informs is None else informs[self.taken]
        self.runs, self.n = loop.P.shape[:-2], len(loop.model.states)
        self.gyro, self.accel = (np.max(np.square(constants[n]), axis=-1) for n in ("gyro_noise", "accel_noise"))
        count = len(at)
        self.nu, self.S = np.zeros((count, *self.runs, 6)), np.ones((count, *self.runs, 6))
        self.used = np.zeros((count, *self.runs, 6), bool)
        self.verdict, self.variance = np.zeros((count, *self.runs), int), np.zeros((count, *self.runs, self.n))
        self.informs = np.zeros((len(messages["time"]), *self.runs, 2), bool)  # of all messages
        self.nav: dict[str, Array] = {}

    def fly(self) -> "Pass":
        nav = []
        for k in range(len(self.taken)):
            for cut in range(self.ends[k], self.ends[k + 1], 2):
                self.step(cut)
            if self.doubt[k].any():
                self.loop.inflate(0, np.repeat(self.doubt[k] ** 2, 3))
            if self.same[k]:
                self.verdict[k] = Fate.TWICE
            else:
                self.take(k)
            self.variance[k] = self.loop.variances()
            nav.append({name: self.loop.nav.seen(name) for name in self.loop.nav})
        self.nav = {name: np.array([one[name] for one in nav]) for name in self.loop.nav}
        return self

    def of(self, function: str) -> dict[str, Any]:
        """What a function of the filter reads of the constants."""
        return {n: self.constants[n] for n in self.loop.described[function]["fields"] if n in self.constants}

    def step(self, cut: int) -> None:
        """The covariance is carried over two parts in the middle between them, where it is linearised."""
        first, middle, last = self.steps.first[cut : cut + 3]
        self.strapdown(first, middle)
        span = self.steps.dt[first:last].sum()
        means = {
            "f_b": self.steps.dv_b[first:last].sum(0) / span - self.loop.nav.seen("accel_bias"),
            "omega_ib_b": self.steps.dtheta_ib_b[first:last].sum(0) / span - self.loop.nav.seen("gyro_bias"),
        }
        fields = self.loop.described["propagate"]["fields"]
        read = {name: value for name, value in means.items() if name in fields}
        self.loop.predict(dt=span, **read, **self.of("propagate"))
        self.strapdown(middle, last)

    def strapdown(self, first: int, last: int) -> None:
        if last == first:
            return
        epoch = self.epochs.get(last - first)
        if epoch is None:
            epoch = Epoch(self.loop, last - first, predict=False, feedback=False, shared=("dt", *SENSED))
            self.epochs[last - first] = epoch
            for name, value in self.of("strapdown").items():
                epoch.strapdown[name] = value
        epoch.strapdown["dt"] = self.steps.dt[first:last]
        for name in SENSED:
            epoch.strapdown[name] = getattr(self.steps, name)[first:last]
        if epoch():
            raise BoresightError("the strapdown refused a sample: a rate or the navigation is outside its box")

    def take(self, k: int) -> None:
        """A message: attitude first, whose residual depends on x, and that of the velocity does not."""
        loop, constants = self.loop, self.constants
        before = loop.memory.read("P")
        given, noise = self.moving(k)
        if self.score is not None:
            self.score.begin()
        informs = self.informs[self.taken[k]]
        informs[...] = (
            np.stack([noise["dcm informs"], noise["velocity informs"]], -1) if self.given is None else (self.given[k])
        )
        for i, (name, rows) in enumerate((("dcm", slice(3, 6)), ("velocity", slice(0, 3)))):
            fields = loop.described["measurements"][name]["fields"]
            inputs = {f: given[f] if f in given else constants[f] for f in fields if f not in loop.nav}
            kept = np.zeros((*self.runs, self.n), bool)
            kept[..., TAU] = ~informs[..., i]
            if self.score is not None:
                H, z = (loop.call(f"{name}_{part}", **inputs) for part in "Hz")
                nu = z - np.einsum("...ij,...j->...i", H, loop.x)
                self.score.take(nu, H, loop.P, noise[name], np.ones((*self.runs, 3), bool))
            if self.considered is not None:
                kept = kept | self.considered
            taken = loop.update(name, noise[name], joint=JOINT, considered=kept, **inputs)
            for part, value in (("nu", taken.nu), ("S", taken.S), ("used", taken.used)):
                getattr(self, part)[k][..., rows] = value
        off = self.beyond()
        if off.any():  # one run that is driven off ends no batch
            loop.x, loop.P = np.where(off[..., None], 0.0, loop.x), np.where(off[..., None, None], before, loop.P)
            if loop.recorder is not None:
                loop.recorder.withdrawn()
            self.used[k][off] = False
        if self.score is not None:
            self.score.end(self.used[k].all(-1))
        loop.feedback()
        loop.nav["lat_lon_height"] = np.broadcast_to(self.messages["position"][k], (*self.runs, 3))
        gated = np.where(off, Fate.REFUSED, Fate.GATED)
        self.verdict[k] = np.where(self.used[k].any(-1), Fate.TAKEN, gated)

    def beyond(self) -> Array:
        """(...,) bool: runs that what they have found would lead out of the model's range."""
        loop, off, x = self.loop, np.zeros(self.runs, bool), self.loop.memory.read("x")
        for name, part in FOUND.items():
            box = loop.model.field[name]
            left = loop.nav.seen(name) - (x[..., part] if box["size"] > 1 else x[..., part.start])
            there = (left > np.array(box["low"]).squeeze()) & (left < np.array(box["high"]).squeeze())
            off |= ~(there.all(-1) if box["size"] > 1 else there)
        off |= (np.abs(x[..., TURNS]) > MOST_TURN).any(-1)
        return off

    def moving(self, k: int) -> tuple[dict[str, Any], dict[str, Array]]:
        """What the measurements read at message k; R of each, and whether it informs the delay.

        The gyros' noise comes with the rate into the velocity of the lever arm, two thirds about an axis.  The noise of
        a rate passes for a motion that the residual does not follow, and so for knowledge of the delay: a rate has to
        be far above it.
        """
        nav, variance, rates, span = self.loop.nav.seen, self.loop.variances(), self.rates, self.rates.span
        position = self.messages["position"][k]
        lever = np.asarray(self.constants["lever_b"] if "lever_b" in self.constants else nav("lever_b"))
        C = rotation.matrix_from_quaternion(nav("q_b2n_wxyz"))
        omega, f_b = rates.omega[k] - nav("gyro_bias"), rates.f[k] - nav("accel_bias")
        arm = cross(rates.alpha[k], lever) + cross(omega, cross(omega, lever))
        g = gravity(position)
        a_n = np.einsum("...ij,...j->...i", C, f_b - arm) + np.array([0.0, 0.0, g])
        earth = EARTH_RATE_RAD_S * np.array([np.cos(position[0]), 0.0, -np.sin(position[0])])
        turning = np.einsum("...ij,...j->...i", C, omega) - earth
        white, pushed = np.maximum(self.gyro, rates.gyro[k]) / span, np.maximum(self.accel, rates.accel[k]) / span
        arms = np.sum(np.square(lever), axis=-1)
        by_rate = white + variance[..., 6:9].mean(-1)
        by_push = pushed + arms * white * 2 / span**2
        by_push = by_push + variance[..., 9:12].mean(-1) + g**2 * variance[..., :2].mean(-1)
        swung = self.gyro / span * arms * 2 / 3
        noise: dict[str, Array] = {"dcm": self.R[..., 3:], "velocity": self.R[..., :3] + swung[..., None]}
        for name, rate, off in (("dcm", turning, by_rate), ("velocity", a_n, by_push)):
            weight = 1 / noise[name]
            noise[f"{name} informs"] = (weight * rate**2).sum(-1) > INFORMS**2 * off * weight.sum(-1)
        given = {"omega_ib_b": omega, "a_n": a_n, "lag": nav("tau") - self.delay}
        return given | {name: self.messages[name][k] for name in ("v_m_n", "q_m2n_wxyz")}, noise


def doubts(imu: Inertial, ends: Array) -> Array:
    """(K, 2) one sigma, rad and m/s, of what bridged samples and holes between `ends` (K + 1,) may have missed."""
    start, end = imu.intervals()
    hole = np.append(0.0, start[1:] - end[:-1])
    hole = np.where(hole > 0.5 * imu.dt, hole, 0.0)[:, None]
    change = np.diff(np.concatenate(imu.rates(), axis=-1), axis=0, prepend=np.nan)
    change[0] = 0.0
    variance = np.square(hole * np.linalg.norm(change.reshape(-1, 2, 3), axis=-1))
    if imu.doubt is not None:
        variance = variance + np.square(imu.doubt)
    total = np.concatenate([np.zeros((1, 2)), np.cumsum(variance, axis=0)])
    out: Array = np.sqrt(np.maximum(0.0, np.diff(total[np.searchsorted(end, ends, "right")], axis=0)))
    return out


def repeated(messages: dict[str, Array], rates: Rates) -> Array:
    """(K,) bool: velocity and attitude are those of the message before, to the bit, and the slave moves."""
    given = np.concatenate([messages["v_m_n"], messages["q_m2n_wxyz"]], axis=-1)
    same = np.append(False, (given[1:] == given[:-1]).all(-1))[: len(given)]
    moves = (np.linalg.norm(rates.omega, axis=-1) > STILL[0]) | (np.linalg.norm(given[:, :3], axis=-1) > STILL[1])
    return same & moves
