"""What may be wrong with the turns of a slave or its master, as guesses that compete."""

from collections.abc import Iterator
from itertools import permutations, product

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.frames import AXES
from boresight.runtime.recording.explain import (
    Fit,
    Freedom,
    Guess,
    axes_named,
    decided,
    known,
    plain,
    ranked,
    turn_named,
)
from boresight.runtime.recording.types import Inertial, Master
from boresight.runtime.units import DEG, UNITS

RANGE = "another range of the sensor"
FACTORS = {
    1 / DEG: "deg/s declared as rad/s", DEG: "rad/s declared as deg/s", 3600.0: "deg/s declared as deg/h",
    1 / 3600: "deg/h declared as deg/s", 1 / 6: "rpm declared as deg/s", 30 / np.pi: "rpm declared as rad/s",
    1 / 360: "turns/s declared as deg/s", 1 / (2 * np.pi): "turns/s declared as rad/s",
    0.5: RANGE, 2.0: RANGE, 0.25: RANGE, 4.0: RANGE,
}  # fmt: skip
ANGLES = {
    DEG: "degrees declared as radians", 1 / DEG: "radians declared as degrees", 0.9: "gradians declared as degrees",
    UNITS["angle"]["mil"] / DEG: "mils declared as degrees", 180.0: "semicircles declared as degrees",
    0.01: "hundredths of a degree declared as degrees",
}  # fmt: skip
SEQUENCES = {
    "yaw, roll, pitch": (2, 0, 1), "roll, pitch, yaw": (0, 1, 2), "pitch, roll, yaw": (1, 0, 2),
    "roll, yaw, pitch": (0, 2, 1), "pitch, yaw, roll": (1, 2, 0),
}  # fmt: skip
MILD = (
    "warm",
    "clock",
    "mounting",
    "factor",
    *(f"factor {name}" for name in AXES),
)  # a replay may begin with so little of it
# Of findings; the others are turns.
NAME = {"warm": "bias", "high": "bias", "mean": "bias", "Euler": "bias", "compass": "heading", "clock": "clock",
        "attitude": "order"}  # fmt: skip
LOW, TAUS = "it is filtered, by a low-pass of about {:.2g} s", np.geomspace(0.05, 2, 24)
E = np.eye(3)
LEAST = 12  # instants of the master of which anything is judged


class Turned:
    """The turns of slave and master, summed up at the master's instants."""

    def __init__(self, imu: Inertial, master: Master, delay: float):
        """delay: s, that was taken off the master's tags."""
        start, end, dtheta, _ = imu.increments
        self.end, self.angle, self.dt = end, np.cumsum(dtheta, axis=0), imu.dt
        self.rates, self.kind = dtheta / (end - start)[:, None], imu.kind
        edge = min(2.0, 0.05 * (end[-1] - end[0]))
        self.master = master.cut((master.time > end[0] + edge) & (master.time < end[-1] - edge))
        self.time, self.delay = self.master.time.astype(float), delay
        self.since = (self.time - self.time[:1])[:, None]
        # what a turn from one tag to the next is more than the sum of its pieces
        swept = np.cumsum(np.cross(self.angle - dtheta / 2, dtheta) / 2, axis=0)
        angle, swept = self.at(0.0, self.angle), self.at(0.0, swept)
        more = np.diff(swept, axis=0) - np.cross(angle[:-1], np.diff(angle, axis=0)) / 2
        self.coning = np.cumsum(np.vstack([np.zeros((1, 3)), more]), axis=0)

    def at(self, shift: Array | float, values: Array, end: Array | None = None) -> Array:
        """(K, 3) of values (N, 3) that stand at `end`, later than the master's tags by a shift, or by one an axis."""
        every = np.broadcast_to(np.asarray(shift, float), 3)
        ends = self.end if end is None else end
        return np.stack([np.interp(self.time + by, ends, x) for by, x in zip(every, values.T, strict=True)], axis=-1)

    def slave(self, shift: Array | float = 0.0) -> Array:
        return self.at(shift, self.angle) + self.coning

    def rate(self, shift: float = 0.0) -> Array:
        h = max(2 * self.dt, 0.02)
        return (self.slave(shift + h) - self.slave(shift - h)) / (2 * h)


def summed(C: Array) -> Array:
    """(K, 3) sums of the turns from each attitude (K, 3, 3) to the next."""
    turns = rotation.vector_from_matrix(np.swapaxes(C[:-1], -1, -2) @ C[1:])
    return np.concatenate([np.zeros((1, 3)), np.cumsum(turns, axis=0)])


def off_line(x: Array, since: Array) -> Array:
    """x (K, 3) less a line in time."""
    X = np.column_stack([since, np.ones(len(since))])
    out: Array = x - X @ np.linalg.lstsq(X, x, rcond=None)[0]
    return out


def of_turns(imu: Inertial, master: Master, delay: float) -> tuple[Iterator[Guess], Freedom] | None:
    """Guesses of the sums of turns; None of a recording that is too short.  master: with `delay` taken off its tags."""
    T = Turned(imu, master, delay)
    if len(T.time) < LEAST:
        return None
    return guesses(T), freedom(T)


def near(imu: Inertial, master: Master) -> float:
    """rad^2, mean square of what the turns of both do not share, at the best delay within a tenth of a second."""
    T = Turned(imu, master, 0.0)
    if len(T.time) < LEAST:
        return np.inf
    S = summed(rotation.matrix_from_euler(T.master.euler))
    tried = [Guess("", "", "", T.slave(by), S) for by in np.arange(-8, 9) * 0.0125]
    free = freedom(T)
    return ranked([Fit(one, free) for one in tried], free)[0].left


def late(imu: Inertial, master: Master, delay: float) -> tuple[float, float, list[str]]:
    """s, by how much the master's tags are late where that explains its turns, and how many times better they then fit.

    delay: s, what is found otherwise.  And what else explains them: a gyro that is filtered, which is late as well.
    """
    T = Turned(imu, master, 0.0)
    if len(T.time) < 20 or abs(delay) > 1:
        return delay, 1.0, []
    S, rate = summed(rotation.matrix_from_euler(T.master.euler)), T.rate()
    tried = [Guess("", "", "", T.slave(), S)]
    tried += [Guess("late", "", str(by), T.slave(by), S) for by in np.arange(-48, 49) * 0.0125 - delay if by]
    tried += [Guess("low", "imu.gyro", LOW.format(tau), T.slave() + tau * rate, S) for tau in TAUS]
    as_is, found = decided(tried, freedom(T))
    shifts = [one for one in found if one.guess.kind == "late"]
    others = [one.text for one in found if one.guess.kind == "low"]
    if not found:
        return delay, 1.0, []
    return -float(shifts[0].text) if shifts else 0.0, float(np.sqrt(as_is.misfit / found[0].misfit)), others


def freedom(T: Turned) -> Freedom:
    columns = [one * axis for one in (T.since, np.ones_like(T.since)) for axis in E]
    return Freedom((*columns, T.rate()), (0.3 * DEG,) * 3 + (1.0,) * 3 + (0.02,), 0.03 * DEG, 0.01)


def guesses(T: Turned) -> Iterator[Guess]:
    C = rotation.matrix_from_euler(T.master.euler)
    Y, S = T.slave(), summed(C)
    yield Guess("", "", "", Y, S)
    for text, one in attitudes(T.master):
        of = summed(one)
        # where all of the motion shrinks, less is left, and explains nothing
        by = max(1.0, np.std(S, axis=0).max() / (np.std(of, axis=0).max() + 1e-300)) if "its angles" in text else 1.0
        yield Guess("attitude", "master.attitude", text, by * Y, by * of)
    turns = np.einsum("kij,kj->ki", C[:-1], np.diff(S, axis=0))
    text = "its rates are in navigation axes already, declared as of the body"
    yield Guess("level", "imu.gyro", text, Y, np.concatenate([np.zeros((1, 3)), np.cumsum(turns, axis=0)]))
    text = "the rates of roll, pitch and yaw stand there, of Euler angles, and not those of the body"
    yield Guess("Euler", "imu.gyro", text, Y, np.unwrap(T.master.euler, axis=0))
    yield from of_factors(T, Y, S)
    yield from of_axes(T, Y, S)
    text = "they are angles, sums of rates, and not rates"
    yield Guess("angles", "imu.gyro", text, T.at(0.0, T.rates), S)
    yield from of_filters(T, S)
    yield from of_drifts(T, Y, S)
    yield from of_clocks(T, Y, S)
    down, heading = C[:, 2, :] * DEG, T.master.euler[:, 2:]
    text = "its heading errs by {0:+.1f} deg times a sine and {1:+.1f} deg times a cosine of the heading, as that of a"
    yield Guess("compass", "master.attitude", text + " compass beside iron does; calibrate it", Y, S,
                (down * np.sin(heading), down * np.cos(heading)), most=60)  # fmt: skip


def of_factors(T: Turned, Y: Array, S: Array) -> Iterator[Guess]:
    y, s = off_line(Y, T.since), off_line(S, T.since)
    names = dict(FACTORS) if T.kind == "rates" else {1 / n: f"one increment in {n} is there" for n in (2, 3, 4, 5, 10)}
    names |= {T.dt: "increments declared as rates"} if T.kind == "rates" else {1 / T.dt: "rates declared as increments"}
    factor = float(np.sum(y * s) / (np.sum(s * s) + 1e-300))
    if abs(factor) > 1e-5:
        text = f"it turns {factor:.4g} times as much as its master{known(factor, names)}"
        yield Guess("factor", "imu.gyro", text, Y / factor, S)
    for i, name in enumerate(AXES):
        alone = float(y[:, i] @ s[:, i] / (s[:, i] @ s[:, i] + 1e-300))
        if abs(abs(alone) - 1) > 0.05 and abs(alone) > 1e-5:
            text = f"turns about {name} alone are {alone:.4g} times its master's{known(alone, names)}"
            yield Guess(f"factor {name}", "imu.gyro", text, Y / np.where(np.arange(3) == i, alone, 1), S)


def of_axes(T: Turned, Y: Array, S: Array) -> Iterator[Guess]:
    says = "the slave's turns are its master's where"
    for order in permutations(range(3)):
        for signs in product((1, -1), repeat=3):
            M = E[list(order)] * np.array(signs)[:, None]
            if not np.array_equal(M, E):
                yield Guess("axes", "imu.body", f"{says} {axes_named(M)} (body)", Y, S @ M.T)
    U, _, Vt = np.linalg.svd(np.diff(off_line(Y, T.since), axis=0).T @ np.diff(off_line(S, T.since), axis=0))
    M = U @ np.diag([1.0, 1.0, np.linalg.det(U @ Vt)]) @ Vt
    if not plain(M):
        text = f"{says} it is turned by {turn_named(M)} beside its master: mounted so, or another body (body)"
        yield Guess("axes", "imu.body", text, Y, S @ M.T)
    elif np.array_equal(np.round(M), E):
        text = (
            f"{says} it is turned by {turn_named(M)} beside its master: mounted so, or the attitude is off by so much"
        )
        yield Guess("mounting", "imu.body", text, Y, S @ M.T)


def attitudes(master: Master) -> Iterator[tuple[str, Array]]:
    """What somebody may have done to attitudes, and the matrices (K, 3, 3) where it is undone."""
    euler = np.unwrap(master.euler, axis=0)
    q, C = rotation.quaternion_from_euler(euler), rotation.matrix_from_euler(euler)
    where = "the turns of both fit where"
    yield (
        f"{where} roll and pitch are exchanged: another order of the angles (order)",
        rotation.matrix_from_euler(euler[:, [1, 0, 2]]),
    )
    yield f"{where} its quaternion is the conjugate: navigation to body", np.swapaxes(C, -1, -2)
    for by, names in ((1, "xyzw declared as wxyz"), (-1, "wxyz declared as xyzw")):
        text = f"{where} its quaternion is in another order: {names} (order)"
        yield text, rotation.matrix_from_quaternion(np.roll(q, by, 1))
    advice = ("its right side goes up", 'pitch_positive = "down"', "yaw_positive")
    for i, name in enumerate(("roll", "pitch", "yaw")):
        alone = np.arange(3) == i
        sign = "yaw is counter-clockwise" if i == 2 else f"its {name} has the other sign"
        yield f"{where} {sign} ({advice[i]})", rotation.matrix_from_euler(euler * np.where(alone, -1, 1))
        text = f"{where} its {name} alone is in degrees, declared as radians"
        yield text, rotation.matrix_from_euler(euler * np.where(alone, DEG, 1))
    for size, names in ANGLES.items():
        yield f"{where} its angles are in {names} (unit)", rotation.matrix_from_euler(euler * size)
    about = [rotation.matrix_from_vector(euler * axis) for axis in E]
    for name, (a, b, c) in SEQUENCES.items():
        text = f"{where} its angles are applied as {name}, and not as yaw, pitch, roll"
        yield text + "; write quaternions, or angles of an aircraft", about[a] @ about[b] @ about[c]


def of_filters(T: Turned, S: Array) -> Iterator[Guess]:
    """Delays of one axis, and filters of one of both."""
    from scipy.signal import lfilter

    X = np.column_stack([S, T.since, np.ones(len(S))])

    def late(axis: int) -> float:
        def left(shift: float) -> float:
            y = np.interp(T.time + shift, T.end, T.angle[:, axis])
            return float(np.sum((y - X @ np.linalg.lstsq(X, y, rcond=None)[0]) ** 2))

        return float(min(np.arange(-40, 41) * 0.0125, key=left))

    shifts = np.array([late(axis) for axis in range(3)])
    shown = ", ".join(f"{by - T.delay:+.2f}" for by in shifts)
    text = f"its axes are of different times: front, right and down are [{shown}] s behind the master's angles"
    if np.ptp(shifts) > 0.03:
        yield Guess("delays", "imu.gyro", text, T.slave(shifts), S)
    for tau in TAUS:
        yield Guess("low", "imu.gyro", LOW.format(tau), T.slave(T.delay) + tau * T.rate(T.delay), S)
    whole = np.cumsum(T.angle, axis=0) * T.dt
    for wide in np.geomspace(max(0.2, float(np.median(np.diff(T.time)))), 10, 20):
        text = f"its attitude is smoothed, over about {wide:.2g} s"
        yield Guess("smooth", "master.attitude", text, (T.at(wide / 2, whole) - T.at(-wide / 2, whole)) / wide, S)
    for tau in np.geomspace(0.1, 3, 12):
        a = 1 - np.exp(-T.dt / tau)
        text = f"its attitude is filtered, by a low-pass of about {tau:.2g} s"
        low = lfilter([a], [1, a - 1], T.angle - T.angle[0], axis=0)
        yield Guess("low attitude", "master.attitude", text, T.at(T.delay, low), S)


def of_drifts(T: Turned, Y: Array, S: Array) -> Iterator[Guess]:
    """Biases that are no constants."""
    from scipy.signal import lfilter

    since, usual, turns = T.since[:, 0], float(np.median(np.diff(T.time))), np.diff(S, axis=0)
    none, dt = np.zeros((1, 3)), np.diff(T.time)[:, None]
    constant = tuple(T.since * axis for axis in E)
    yield Guess("constant", "", "", Y, S, constant)
    for tau in np.geomspace(max(1.0, 2 * usual), 2 * since[-1], 25):
        fading = np.exp(-T.since / tau)
        scale = float(fading[0, 0] - fading[-1, 0]) / tau / DEG
        text = "its bias drifts by [{0:+.2f}, {1:+.2f}, {2:+.2f}] deg/s (front, right, down), as of one that warms up"
        yield Guess("warm", "imu.gyro", text, Y, S, (*(fading * axis / scale for axis in E), *constant), cost=1.5)
        if tau > since[-1] / 2:
            continue
        a = 1 - np.exp(-usual / tau)
        slow = np.cumsum(np.vstack([none, lfilter([a / 2, a / 2], [1, a - 1], turns, axis=0)]), axis=0)
        text = f"slow turns are missing, as behind a high-pass of about {tau:.2g} s"
        yield Guess("high", "imu.gyro", text, Y, S - slow, tuple(fading * axis for axis in E))
        behind = np.stack([np.interp(since - tau, since, part) for part in S.T], axis=-1)
        mean = np.cumsum(np.vstack([none, (S - behind)[1:] * dt]), axis=0) / tau
        text = f"slow turns are missing, as where a running mean of about {tau:.2g} s was taken off"
        more = tuple(np.minimum(T.since, tau) ** 2 * axis for axis in E)
        yield Guess("mean", "imu.gyro", text, Y, S - mean, more)


def of_clocks(T: Turned, Y: Array, S: Array) -> Iterator[Guess]:
    """Tags of another rate, a clock that runs apart, a mount that moves: from the beginning on, or from an instant."""
    factor, ends = running(T, S)
    if abs(factor - 1) > 0.005:
        hz = 1 / T.dt
        text = f"the turns of both fit where its tags run at {factor:.4g} times their rate: "
        text += f"{hz / factor:.4g} Hz, not {hz:.4g}" + "; or rows are lost, and tags were counted" * int(factor > 1)
        yield Guess("tags", "imu.time", text, T.at(0.0, T.angle, ends), S)
    before, after = of_part(T, S, slice(0, len(S) // 4)), of_part(T, S, slice(3 * len(S) // 4, None))
    middle = T.time[0] + np.linspace(0.25, 0.75, 41) * T.since[-1, 0]
    for at in middle if abs(after - before) > 0.1 else ():
        text = f"from {at:.0f} s on its tags are {before - after:+.2f} s off: samples are lost there, and tags go on as"
        gone = (T.time > at)[:, None]
        tags = np.where(gone[:, 0], np.maximum(T.time + after, min(at + before, at + after)), T.time + before)
        seen = np.stack([np.interp(tags, T.end, part) for part in T.angle.T], axis=-1)
        text += " if none were, or the clock was set; cut the recording there (from, to)"
        yield Guess("step", "imu.time", text, seen, S, tuple(gone * axis for axis in E))
    rate = T.rate()
    for at in T.time[0] + np.linspace(0, 0.85, 18) * T.since[-1, 0]:
        behind = np.maximum(T.time - at, 0)[:, None]
        begins = "" if at == T.time[0] else f" from {at:.0f} s on"
        text = f"the clocks run apart{begins}, by {{0:.0f}} ppm"
        yield Guess("clock", "imu.time", text, Y, S, (rate * behind * 1e-6, rate), most=5e4)
        if begins:
            moved = np.where(behind > 0, S - S[np.searchsorted(T.time, at)], 0.0) * DEG
            text = f"the slave is turned otherwise{begins}, by [{{0:.1f}}, {{1:.1f}}, {{2:.1f}}] deg about front, right"
            text += " and down: it moved in its mount; cut the recording there (from, to)"
            yield Guess("loose", "imu", text, Y, S, tuple(np.cross(moved, axis) for axis in E))
            text = f"the turns fit until {at:.0f} s and not behind it: what was logged has changed; cut the recording"
            more = tuple(moved[:, [i]] * axis for i in range(3) for axis in E)
            yield Guess("changed", "imu.gyro", text + " there (from, to)", Y, S, more, cost=10)


def of_part(T: Turned, S: Array, rows: slice) -> float:
    """s, by how much later the slave's turns fit in some rows."""
    X = np.column_stack([S, T.since, np.ones(len(S))])[rows]

    def left(shift: float) -> float:
        y = T.at(shift, T.angle)[rows]
        return float(np.sum((y - X @ np.linalg.lstsq(X, y, rcond=None)[0]) ** 2))

    return float(min(np.arange(-100, 101) * 0.05, key=left))


def running(T: Turned, S: Array) -> tuple[float, Array]:
    """The factor on the slave's time with which its turns fit those of the master best, and the times (N,)."""
    X = np.column_stack([S, T.since, np.ones(len(S))])

    def ends(factor: float, shift: float) -> Array:
        out: Array = T.end[0] + shift + (T.end - T.end[0]) * factor
        return out

    def left(one: tuple[float, float]) -> float:
        at = ends(*one)
        keep = T.time <= at[-1]
        if keep.sum() < 0.4 * len(S):
            return np.inf
        y = T.at(0.0, T.angle, at)[keep]
        return float(np.mean((y - X[keep] @ np.linalg.lstsq(X[keep], y, rcond=None)[0]) ** 2))

    tried = [(float(one), 0.0) for one in np.exp(np.linspace(-0.7, 0.7, 281))]
    for width in (0.005, 0.0005):
        factor, shift = min(tried, key=left)
        spans = np.linspace(-1, 1, 11)
        tried = [(factor * (1 + width * a), shift + 20 * width * b) for a in spans for b in spans]
    factor, shift = min(tried, key=left)
    return factor, ends(factor, shift)
