"""The master's velocity, height and heading against what the slave feels: each fault has a shape of its own."""

from dataclasses import dataclass, replace

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.recording.delay import best_delay
from boresight.runtime.recording.types import Finding, Inertial, Master
from boresight.runtime.units import DEG
from boresight.runtime.units import STANDARD_GRAVITY as G

BLOCKS = 12
SEEN = 0.25 * DEG  # rms of a heading that a compass adds to a line in time and a mounting


def regressed(y: Array, X: Array) -> tuple[Array, Array]:
    """Coefficients (n,) of y (K, m) by columns X (K, m, n), and a sigma of each (n,).

    What is left wanders: its scores are summed over a twelfth of the time and a component each.
    """
    flat = X.reshape(-1, X.shape[-1])
    inverse = np.linalg.pinv(flat.T @ flat, rcond=1e-12, hermitian=True)
    found = inverse @ (flat.T @ y.ravel())
    scores = (y - X @ found)[..., None] * X
    sums = np.concatenate([part.sum(axis=0) for part in np.array_split(scores, BLOCKS)])
    V = inverse @ (sums.T @ sums) @ inverse
    # as many coefficients as there are took as much out of what is left
    free = max(1, len(sums) - len(found))
    return found, np.sqrt(np.diagonal(V) * len(sums) / free)


@dataclass(frozen=True)
class Level:
    """What the level velocity shows: heading of the attitude less that of the velocity (rad), and its lag (s).

    behind: s, of the accelerometers behind the gyros, if the velocity does not lag.  lever: (3,) m, master to slave.
    """

    heading: float
    heading_sigma: float
    lag: float
    lag_sigma: float
    scale: float
    behind: float
    behind_sigma: float
    lever: Array
    lever_sigma: Array


def level(imu: Inertial, master: Master) -> Level | None:
    """The level velocity beside the integral of the specific force in the master's axes; None where it hardly changes.

    Beside a turn and a lag it has what a bias of the accelerometers, their mounting, a tilt and a lever arm do.
    """
    assert master.v_n is not None
    start, end, dtheta, dvel = imu.increments
    inside = (master.time > end[0] + 0.5) & (master.time < end[-1] - 0.5)
    if inside.sum() < 30:
        return None
    master = master.cut(inside)
    assert master.v_n is not None
    delay, _ = best_delay(imu, master)
    C = rotation.matrix_from_euler(
        np.stack([np.interp((start + end) / 2 + delay, master.time, a) for a in np.unwrap(master.euler, axis=0).T], -1)
    )
    seconds = (end - start)[:, None]
    force = np.einsum("kij,kj->ki", C, dvel)
    force[:, 2] += G * seconds[:, 0]
    # the turn of one sample and its neighbours, for the lever arm
    width = max(1, round(0.1 / imu.dt))
    smooth = np.stack([np.convolve(part, np.full(width, 1 / width), "same") for part in (dtheta / seconds).T], axis=-1)
    swept = np.einsum("kij,kjl->kil", C, np.cross(smooth[:, None], np.eye(3)).swapaxes(-1, -2))
    # a mounting is no bias where the force on the body changes, as in a bank
    tilt = np.einsum("kij,kjl->kil", C, np.cross(dvel[:, None], np.eye(3)[:2]).swapaxes(-1, -2))
    parts = [np.cumsum(part, axis=0) for part in (force[:, :, None], C * seconds[:, :, None], tilt)] + [swept]
    parts.append(np.stack([np.convolve(part, np.full(width, 1 / width), "same") for part in (force / seconds).T], -1)[
        :, :, None
    ])  # fmt: skip
    parts.append(np.cumsum(np.einsum("kij,kj->ki", C, np.gradient(dvel / seconds, axis=0)), axis=0)[:, :, None])
    flat = np.concatenate(parts, axis=-1)[:, :2]
    time = master.time - delay
    at = np.stack(
        [[np.interp(time, end, flat[:, i, j]) for j in range(flat.shape[-1])] for i in range(2)], axis=0
    ).transpose(2, 0, 1)  # fmt: skip
    one = np.tile(np.eye(2), (len(time), 1, 1))
    turned = np.stack([-at[:, 1, 0], at[:, 0, 0]], axis=-1)[:, :, None]
    line = [one, one * (time - time[0])[:, None, None]]
    X = np.concatenate([at[..., :1], turned, at[..., 1:-1], *line], axis=-1)
    y = master.v_n[:, :2]
    if np.std(y - y.mean(axis=0), axis=0).max() < 0.5:
        return None
    found, sigma = regressed(y, X)
    scale = float(np.hypot(found[0], found[1]))
    if scale < 0.3:
        return None
    lag = at[..., 9].std()
    late, unsure = regressed(y, np.concatenate([at[..., :1], turned, at[..., 1:9], at[..., -1:], *line], axis=-1))
    return Level(
        float(-np.arctan2(found[1], found[0])), float(max(sigma[0], sigma[1]) / scale),
        float(-found[10]), float(sigma[10]) if lag > 0 else np.inf, scale, float(late[10]), float(unsure[10]),
        -found[7:10], sigma[7:10],
    )  # fmt: skip


def yaw_of_mounting(slave: Array, turn: Array) -> tuple[float, float]:
    """rad, by how much the slave is turned about down beside its master, from turns of both (K, 3); and its sigma."""
    # mounted by mu: slave = turn - mu x turn
    about = np.stack([turn[:, 1], -turn[:, 0]], axis=-1)[..., None]
    y = (slave - turn)[:, :2]
    found, sigma = regressed(y - y.mean(axis=0), about - about.mean(axis=0))
    return float(found[0]), float(sigma[0])


WILD = 4 * DEG  # of an attitude that stands off its neighbours


def check_jumps(time: Array, slave: Array, turn: Array, kept: Array) -> list[Finding]:
    """Attitudes that stand off, and a heading that was interpolated across 360 deg.

    slave, turn: (K, 3) rad, the turns of both over the master's intervals `kept` (K,); time: (M,) s of its messages.
    """
    off = slave - turn
    off = off - np.median(off, axis=0)
    size = np.linalg.norm(off, axis=1)
    wild = np.flatnonzero(size > max(WILD, 12 * float(np.median(size))))
    if not len(wild) or len(wild) > 0.1 * len(size):
        return []
    groups = np.split(wild, np.flatnonzero(np.diff(wild) > 1) + 1)
    about, sums = 360 * DEG, [off[group].sum(axis=0) for group in groups]
    rounds = [k for k, one in enumerate(sums) if abs(abs(one[2]) / about - 1) < 0.05 and len(groups[k]) > 1]
    if rounds:
        first, last = (time[kept[groups[rounds[0]][i]] + (i < 0)] for i in (0, -1))
        text = f"from {first:.2f} to {last:.2f} s the heading goes the other way round, by 360 deg: interpolated across"
        text += " north as if 0 and 360 deg were far apart; interpolate it unwrapped, or cut there (from, to)"
        return [Finding("error", "master.attitude", text, "turns")]
    lone = [
        k for k, one in enumerate(sums) if len(groups[k]) == 2 and np.linalg.norm(one) < 0.2 * size[groups[k]].max()
    ]
    if lone and len(lone) == len(groups):
        many = "1 attitude stands" if len(lone) == 1 else f"{len(lone)} attitudes stand"
        first = time[kept[groups[0][0]] + 1]
        text = f"{many} off by up to {size[wild].max() / DEG:.3g} deg from those beside, the first at {first:.3f} s"
        return [Finding("warning", "master.attitude", text + ": wild ones, which a filter refuses; leave them out")]
    if len(groups) <= 3 and all(len(group) == 1 for group in groups):
        k = groups[0][0]
        text = f"it steps by [{{:.1f}}, {{:.1f}}, {{:.1f}}] deg at {time[kept[k] + 1]:.2f} s".format(*(-off[k] / DEG))
        text += f" and {len(groups) - 1} times more, and the slave does not: it was aligned anew, or the slave moved in"
        text += " its mount; cut it there (from, to)"
        return [Finding("error", "master.attitude", text, "turns")]
    return []


def crab(master: Master, heading: Array) -> tuple[float, float]:
    """Course less heading, its mean in rad, and how well it keeps that, 0 to 1; nan and 0 of a master that stands."""
    if master.v_n is None or (fast := np.hypot(*master.v_n[:, :2].T) > 2).sum() < 10:
        return np.nan, 0.0
    mean = np.mean(np.exp(1j * (np.arctan2(master.v_n[fast, 1], master.v_n[fast, 0]) - heading[fast])))
    return float(np.angle(mean)), float(np.abs(mean))


def check_course(master: Master, slave: Array, turn: Array, kept: Array) -> list[Finding]:
    """A heading that is the course of the velocity, and so no heading: it goes with it where the slave does not.

    slave, turn: (K, 3) rad, turns of both over the master's intervals `kept` (K,).
    """
    if master.v_n is None:
        return []
    fast = np.hypot(*master.v_n[:, :2].T) > 1
    crab = np.angle(np.exp(1j * (np.arctan2(master.v_n[:, 1], master.v_n[:, 0]) - master.euler[:, 2])))
    moving = fast[kept] & fast[kept + 1]
    if moving.sum() < 40:
        return []
    away, slave = np.diff(np.unwrap(crab))[kept][moving], slave[moving] - slave[moving].mean(axis=0)
    off = turn[moving, 2] - turn[moving, 2].mean()
    off = off - slave @ np.linalg.lstsq(slave, off, rcond=None)[0]  # but for a mounting and a scale
    size = float(np.sqrt(np.mean(off**2)))
    # a car keeps its course: its heading differs from what the slave turns by a gyro's white noise at most
    once = float(off[1:] @ off[:-1]) / max(float(off @ off), 1e-300)
    if np.sqrt(np.mean(away**2)) > 0.1 * size or size < 1e-4 or abs(once) < 0.25:
        return []
    text = f"its heading is the course of the velocity in every row (apart by {np.median(np.abs(crab[fast])) / DEG:.1g}"
    text += f" deg), and the slave turns otherwise, by {size / DEG:.2g} deg a row: a receiver's course is no heading"
    return [Finding("error", "master.attitude", text, "heading")]


def counted_from_east(master: Master) -> str:
    """What a yaw of the other sign is counted from besides, by the course."""
    mean, steady = crab(master, -master.euler[:, 2])
    return ' and counted from east (yaw_from = "east")' if steady > 0.9 and abs(mean - np.pi / 2) < 0.5 else ""


def check_heading(imu: Inertial, master: Master, slave: Array, turn: Array, delay: float) -> list[Finding]:
    """A heading that is off, a velocity that lags, a lever arm; slave and turn: (K, 3) rad, turns of both.

    delay: s, of the master's attitude, which was taken off its time.
    """
    seen = None if master.v_n is None else level(imu, master)
    if seen is None:
        return []
    assert master.v_n is not None
    mounted, unsure = yaw_of_mounting(slave, turn)
    known = unsure < 1 * DEG
    off, sigma = seen.heading + mounted * known, float(np.hypot(seen.heading_sigma, unsure * known))
    out = []
    if abs(off) > max(5 * sigma, 3 * DEG) and abs(seen.heading) > 5 * seen.heading_sigma:
        text = f"the heading is off by {off / DEG:.1f} +- {sigma / DEG:.1f} deg: by so much the level force in the"
        text += " master's axes is turned against the change of its velocity"
        speed = np.hypot(*master.v_n[:, :2].T)
        if (speed > 2).mean() > 0.5:
            crab = np.arctan2(master.v_n[:, 1], master.v_n[:, 0]) - master.euler[:, 2]
            mean = np.angle(np.mean(np.exp(1j * crab[speed > 2])))
            text += f", and course less heading is {mean / DEG:.0f} deg"
        text += "; magnetic or grid north, a compass beside iron, or another axis?"
        if not known:
            text += "  Or the slave is mounted so: roll and pitch would tell, which hardly change"
        out.append(Finding("error" if abs(off) > 5 * DEG else "warning", "master.attitude", text, "heading"))
    surer = seen.lag / seen.lag_sigma > abs(seen.behind) / seen.behind_sigma
    if seen.lag > max(0.12, 8 * seen.lag_sigma) and surer:
        text = f"it is {seen.lag:.2f} +- {seen.lag_sigma:.2f} s older than the attitude: a velocity that is filtered"
        out.append(
            Finding("error", "master.velocity", text + " or averaged; take one that is not, or tag it earlier", "lag")
        )
    elif seen.lag < -max(0.12, 6 * seen.lag_sigma) and abs(delay + seen.lag) < 0.05 + 3 * seen.lag_sigma:
        text = (
            f"its attitude is {-seen.lag:.2f} +- {seen.lag_sigma:.2f} s older than its velocity, which fits at its tags"
        )
        out.append(Finding("error", "master.attitude", text + ": give it a time of its own (attitude.time)", "lag"))
    elif abs(seen.behind) > max(0.04, 8 * seen.behind_sigma) and turns_refuse(imu, master, seen.behind):
        order = "behind" if seen.behind > 0 else "ahead of"
        if seen.behind < 0 and abs(delay - seen.behind) < 0.05 + 3 * seen.behind_sigma:
            text = f"they are {-seen.behind:.2f} +- {seen.behind_sigma:.2f} s behind the accelerometers and the master:"
            return [Finding("error", "imu.gyro", f"{text} a gyro that is filtered, or tagged otherwise", "lag"), *out]
        text = (
            f"they are {abs(seen.behind):.3f} +- {seen.behind_sigma:.3f} s {order} the gyros: accel that is filtered or"
        )
        text += " tagged otherwise, or a master's velocity that is so beside its attitude"
        out.append(Finding("error", "imu.accel", text, "lag"))
    seen_by = np.abs(seen.lever) > np.maximum(0.2, 5 * seen.lever_sigma)
    if seen_by.any() and not out:
        parts = [f"{one:+.2f} +- {unsure:.2f}" for one, unsure in zip(seen.lever, seen.lever_sigma, strict=True)]
        text = f"its velocity shows a lever arm of [{', '.join(parts)}] m (front, right, down) to the slave"
        out.append(Finding("note", "master.velocity", text + ": a model without one would need it (--lever-arm)"))
    return out


def turns_refuse(imu: Inertial, master: Master, shift: float) -> bool:
    """Whether the turns of both say that the master is not earlier by `shift`: those of a slow swell do not."""
    delay, _ = best_delay(imu, master)
    shifted = replace(master, time=master.time - delay + shift)
    return best_delay(imu, shifted, span=max(0.1, 1.2 * abs(shift)), step=abs(shift) / 10)[1] > 1.3


def check_place(master: Master) -> list[Finding]:
    """A position that is older than the velocity: it lies behind by the speed times that."""
    assert master.v_n is not None and master.position is not None
    lat, lon, height = master.position.T
    place = np.column_stack([lat, lon * np.cos(lat[0])]) * (6371e3 + height[0])
    v, dt = master.v_n[:, :2], np.diff(master.time)[:, None]
    if len(dt) < 30 or np.std(v, axis=0).max() < 0.5:
        return []
    summed = np.concatenate([np.zeros((1, 2)), np.cumsum((v[1:] + v[:-1]) / 2 * dt, axis=0)])
    since = (master.time - master.time[0])[:, None, None]
    one = np.tile(np.eye(2), (len(since), 1, 1))
    found, sigma = regressed(
        place - summed, np.concatenate([v[..., None], one, one * since, summed[..., None]], axis=-1)
    )
    if not -found[0] > max(0.5, 8 * sigma[0]):
        return []
    text = (
        f"it is {-found[0]:.2f} +- {sigma[0]:.2f} s older than the velocity, along the path; give it a time of its own"
    )
    return [Finding("warning", "master.position", text + " (position.time)")]


def check_vertical(master: Master) -> list[Finding]:
    """A level velocity that was declared as one of the body: off by the speed times the sine of the pitch."""
    assert master.v_n is not None and master.position is not None
    dt = np.diff(master.time)
    v = (master.v_n[1:] + master.v_n[:-1]) / 2
    left = -np.diff(master.position[:, 2]) - v[:, 2] * dt
    C = rotation.matrix_from_euler(master.euler)
    forward = np.einsum("ki,ki->k", (C[1:, :, 0] + C[:-1, :, 0]) / 2, v)
    climb = forward * np.sin((master.euler[1:, 1] + master.euler[:-1, 1]) / 2) * dt
    if len(dt) < 30 or np.sqrt(np.mean(climb**2)) < 0.02 * np.median(dt):
        return []
    # what the rule of trapezoids misses of a swell goes with the bend of the velocity
    second: Array = np.gradient(np.gradient(master.v_n[:, 2]))
    bend = (second[1:] + second[:-1]) / 2 * dt
    found, sigma = regressed(left[:, None], np.stack([climb, bend], axis=-1)[:, None])
    if not (abs(found[0] - 1) < 0.2 and sigma[0] < 0.04):
        return []
    text = "the height does not follow its vertical part, by the speed times the sine of the pitch: a level velocity"
    return [Finding("error", "master.velocity", text + " declared as one of the body (axes)?", "path")]
