"""The master's velocity, height and heading against what the slave feels: each fault has a shape of its own."""

from dataclasses import dataclass

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.recording.delay import best_delay
from boresight.runtime.recording.types import Finding, Inertial, Master
from boresight.runtime.units import DEG
from boresight.runtime.units import STANDARD_GRAVITY as G

BLOCKS = 12


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
    """What the level velocity shows: heading of the attitude less that of the velocity (rad), and its lag (s)."""

    heading: float
    heading_sigma: float
    lag: float
    lag_sigma: float
    scale: float


def level(imu: Inertial, master: Master) -> Level | None:
    """The level velocity beside the integral of the specific force in the master's axes; None where it hardly changes.

    Beside a turn and a lag it has what a bias of the accelerometers, a tilt and a lever arm do.
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
    parts = [np.cumsum(force, axis=0)[:, :, None], np.cumsum(C * seconds[:, :, None], axis=0), swept]
    parts.append(np.stack([np.convolve(part, np.full(width, 1 / width), "same") for part in (force / seconds).T], -1)[
        :, :, None
    ])  # fmt: skip
    flat = np.concatenate(parts, axis=-1)[:, :2]
    time = master.time - delay
    at = np.stack(
        [[np.interp(time, end, flat[:, i, j]) for j in range(flat.shape[-1])] for i in range(2)], axis=0
    ).transpose(2, 0, 1)  # fmt: skip
    one = np.tile(np.eye(2), (len(time), 1, 1))
    turned = np.stack([-at[:, 1, 0], at[:, 0, 0]], axis=-1)[:, :, None]
    X = np.concatenate([at[..., :1], turned, at[..., 1:], one, one * (time - time[0])[:, None, None]], axis=-1)
    y = master.v_n[:, :2]
    if np.std(y - y.mean(axis=0), axis=0).max() < 0.5:
        return None
    found, sigma = regressed(y, X)
    scale = float(np.hypot(found[0], found[1]))
    if scale < 0.3:
        return None
    lag = at[..., 7].std()
    return Level(
        float(-np.arctan2(found[1], found[0])), float(max(sigma[0], sigma[1]) / scale),
        float(-found[8]), float(sigma[8]) if lag > 0 else np.inf, scale,
    )  # fmt: skip


def yaw_of_mounting(slave: Array, turn: Array) -> tuple[float, float]:
    """rad, by how much the slave is turned about down beside its master, from turns of both (K, 3); and its sigma."""
    # mounted by mu: slave = turn - mu x turn
    about = np.stack([turn[:, 1], -turn[:, 0]], axis=-1)[..., None]
    y = (slave - turn)[:, :2]
    found, sigma = regressed(y - y.mean(axis=0), about - about.mean(axis=0))
    return float(found[0]), float(sigma[0])


def check_heading(imu: Inertial, master: Master, slave: Array, turn: Array) -> list[Finding]:
    """A heading that is off, a compass, and a velocity that lags; slave and turn: (K, 3) rad, the turns of both."""
    if found := _compass(imu, master):
        return found
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
        text += "; magnetic or grid north, or another axis?"
        if not known:
            text += "  Or the slave is mounted so: roll and pitch would tell, which hardly change"
        out.append(Finding("error" if abs(off) > 5 * DEG else "warning", "master.attitude", text, "heading"))
    if seen.lag > max(0.12, 6 * seen.lag_sigma):
        text = f"it is {seen.lag:.2f} +- {seen.lag_sigma:.2f} s older than the attitude: a velocity that is filtered"
        out.append(
            Finding("error", "master.velocity", text + " or averaged; take one that is not, or tag it earlier", "lag")
        )
    return out


def _compass(imu: Inertial, master: Master) -> list[Finding]:
    """A heading whose error is a sine and a cosine of the heading, beside what the slave's gyros turn."""
    heading = np.unwrap(master.euler[:, 2])
    start, end = imu.intervals()
    inside = (master.time > end[0]) & (master.time < end[-1])
    if inside.sum() < 30 or np.ptp(heading[inside]) < 30 * DEG:
        return []
    gyro = imu.rates()[0]
    roll, pitch, _ = (np.interp((start + end) / 2, master.time, a) for a in np.unwrap(master.euler, axis=0).T)
    down = np.stack([0 * roll, np.sin(roll), np.cos(roll)], axis=-1) / np.cos(pitch)[:, None] * (end - start)[:, None]
    # the rate of heading by the gyros, and by how much more a slave mounted by a radian about each axis would show
    rates = [np.sum(gyro * down, axis=1), *(np.sum(np.cross(gyro, axis) * down, axis=1) for axis in np.eye(3))]
    delay, _ = best_delay(imu, master)
    turned, *mounted = (np.interp(master.time - delay, end, np.cumsum(rate))[inside] for rate in rates)
    heading, time = heading[inside], master.time[inside]
    columns = np.stack([np.sin(heading), np.cos(heading), np.ones_like(time), time - time.mean(), *mounted], axis=-1)
    errs = heading - turned
    found, sigma = regressed(errs[:, None], columns[:, None])
    size, unsure = float(np.hypot(*found[:2])), float(sigma[:2].max())
    bare, *_ = np.linalg.lstsq(columns[:, 2:], errs, rcond=None)
    # over few headings a sine and a cosine are a line: they must explain most of what is left without them
    explained = 1 - np.sum((errs - columns @ found) ** 2) / np.sum((errs - columns[:, 2:] @ bare) ** 2)
    if size < max(2 * DEG, 6 * unsure) or explained < 0.5:
        return []
    text = f"its heading errs by {size / DEG:.1f} +- {unsure / DEG:.1f} deg times a sine and cosine of the heading, as"
    return [Finding("error", "master.attitude", text + " that of a compass beside iron does; calibrate it", "heading")]


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


def another_sequence(imu: Inertial, master: Master) -> str:
    """The order in which angles must turn the body so that the slave turns as its master; "" where they do as they are.

    By the sums of the turns of both: what an order changes is of the second order, and stays.
    """
    _, end, dtheta, _ = imu.increments
    delay, _ = best_delay(imu, master)
    inside = (master.time - delay > end[0]) & (master.time - delay < end[-1])
    if inside.sum() < 40:
        return ""
    master = master.cut(inside)
    time = master.time - delay
    angle = np.stack([np.interp(time, end, part) for part in np.cumsum(dtheta, axis=0).T], axis=-1)[1:]

    def left(C: Array) -> float:
        turns = np.cumsum(rotation.vector_from_matrix(np.swapaxes(C[:-1], -1, -2) @ C[1:]), axis=0)
        design = np.column_stack([turns, time[1:], np.ones(len(turns))])
        return float(np.sum((angle - design @ np.linalg.lstsq(design, angle, rcond=None)[0]) ** 2))

    def about(axis: int) -> Array:
        vectors = np.zeros_like(master.euler)
        vectors[:, axis] = master.euler[:, axis]
        return rotation.matrix_from_vector(vectors)

    roll, pitch, yaw = about(0), about(1), about(2)
    orders = {
        "yaw, roll, pitch": yaw @ roll @ pitch, "roll, pitch, yaw": roll @ pitch @ yaw,
        "pitch, roll, yaw": pitch @ roll @ yaw, "roll, yaw, pitch": roll @ yaw @ pitch,
        "pitch, yaw, roll": pitch @ yaw @ roll,
    }  # fmt: skip
    as_it_is = left(yaw @ pitch @ roll)
    others = {name: left(C) for name, C in orders.items()}
    best = min(others, key=others.__getitem__)
    return best if others[best] < 0.5 * as_it_is else ""
