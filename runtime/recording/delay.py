"""How old a master's data seems, by a look at the turns of both."""

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.recording.types import Inertial, Master


def attitude_steps(euler: Array) -> Array:
    """(M-1, 3, 3) the turn from each attitude to the next, in the body axes of the first."""
    C = rotation.matrix_from_euler(euler)
    return np.swapaxes(C[:-1], -1, -2) @ C[1:]


def best_delay(imu: Inertial, master: Master, span: float = 0.1, step: float = 0.0025) -> tuple[float, float]:
    """s, how old the master's data seems (within +-span), and how many times smaller the misfit is than at zero.

    The slave's turns are regressed on the master's (all three axes and a bias, so misalignment and scale do not matter)
    for each trial delay; the misfit's minimum is refined by a parabola.  A look at the data, without uncertainty.
    """
    start, end, dtheta, _ = imu.increments
    edges, angle = np.append(start[:1], end), np.vstack([np.zeros(3), np.cumsum(dtheta, axis=0)])
    inside = (master.time - span >= edges[0]) & (master.time + span <= edges[-1])
    time = master.time[inside]
    turn = rotation.vector_from_matrix(attitude_steps(master.euler[inside]))
    design = np.column_stack([turn, np.diff(time)])
    delays = np.arange(-round(span / step), round(span / step) + 1) * step
    misfit = np.empty(len(delays))
    for i, delay in enumerate(delays):
        at = np.stack([np.interp(time - delay, edges, component) for component in angle.T], axis=-1)
        slave = np.diff(at, axis=0)
        left = slave - design @ np.linalg.lstsq(design, slave, rcond=None)[0]
        misfit[i] = np.sum(left**2)
    k = int(np.argmin(misfit))
    best = delays[k]
    if 0 < k < len(delays) - 1:
        before, at_k, after = misfit[k - 1 : k + 2]
        best += step * 0.5 * (before - after) / (before - 2 * at_k + after)
    return float(best), float(np.sqrt(misfit[len(delays) // 2] / misfit[k]))


NEAR_S = 0.1  # a filter's delay


def clocks_apart(imu: Inertial, master: Master) -> tuple[float, float]:
    """s, by how much the master's tags are late, looked for over half of the recording; and what that is worth.

    Within NEAR_S it is a filter's delay, and worth 1.  Beyond, the turns must decide: fit 1.2 times better than at any
    delay within, or, more than half a second away, be explained to 95 % and twice as well; for a motion that repeats
    itself, as a walk or a swell, fits as well a period later.
    """
    start, end, dtheta, _ = imu.increments
    edges, angle = np.append(start[:1], end), np.vstack([np.zeros(3), np.cumsum(dtheta, axis=0)])
    turn, dt = rotation.vector_from_matrix(attitude_steps(master.euler)), np.diff(master.time)
    usual = np.median(dt)

    def unexplained(delay: float) -> float:
        """The part of the slave's turns that the master's do not explain, where both are there."""
        time = master.time - delay
        inside = (time[:-1] >= edges[0]) & (time[1:] <= edges[-1]) & (dt < 1.5 * usual)
        if inside.sum() < max(20, 0.4 * len(dt)):
            return 1.0
        at = np.stack([np.interp(time, edges, component) for component in angle.T], axis=-1)
        slave = np.diff(at, axis=0)[inside]
        design = np.column_stack([turn[inside], dt[inside]])
        left = slave - design @ np.linalg.lstsq(design, slave, rcond=None)[0]
        moving = slave - slave.mean(axis=0)
        return float(np.sum(left**2) / max(np.sum(moving**2), 1e-300))

    def best(delays: Array) -> tuple[float, float]:
        """The delay that explains most, and what it leaves."""
        misfit = [unexplained(delay) for delay in delays]
        return float(delays[int(np.argmin(misfit))]), min(misfit)

    near, here = best(np.linspace(-NEAR_S, NEAR_S, 41))
    near = near if here < 0.8 else 0.0  # noise alone has no delay
    if here < 0.02:
        far, there = best(np.arange(-50, 51) * 0.01)
        decided = there < here / 1.2**2
    else:
        reach, step = 0.5 * (master.time[-1] - master.time[0]), max(float(usual) / 2, 0.05)
        far, there = best(np.arange(-int(reach / step), int(reach / step) + 1) * step)
        for width in (step, step / 5, step / 25):
            far, there = best(far + np.linspace(-width, width, 11))
        decided = there < 0.05 and there < here / 4
    return (far, float(np.sqrt(here / there))) if decided and abs(far) > NEAR_S else (near, 1.0)


def drift(imu: Inertial, master: Master) -> tuple[float, float, float]:
    """By how much the master's clock runs fast, its sigma, and the s over which both are there.

    A delay d of the master takes d w off the slave's angle at each tag, w being its rate: so d and its slope are
    regressed beside misalignment, scale and bias.  0 and inf where there is too little.
    """
    _, end, dtheta, _ = imu.increments
    inside = (master.time > end[0] + 0.1) & (master.time < end[-1] - 0.1)
    if inside.sum() < 40:
        return 0.0, np.inf, 0.0
    master = master.cut(inside)
    delay, _ = best_delay(imu, master)
    angle = np.cumsum(dtheta, axis=0)
    time = master.time - delay

    def at(when: Array) -> Array:
        return np.stack([np.interp(when, end, component) for component in angle.T], axis=-1)

    h = max(2 * imu.dt, 0.02)
    rate = (at(time + h) - at(time - h)) / (2 * h)
    since = (time - time.mean())[:, None]
    # as levels: of differences, the white noise of an attitude hides what grows slowly
    turns = np.cumsum(rotation.vector_from_matrix(attitude_steps(master.euler)), axis=0)
    design = np.column_stack([turns, time[1:], np.ones(len(turns))])
    columns = [part[1:] for part in (at(time), rate, since * rate)]
    y, *known = [part - design @ np.linalg.lstsq(design, part, rcond=None)[0] for part in columns]
    Z = np.stack([part.ravel() for part in known], axis=-1)
    normal = Z.T @ Z
    if not np.linalg.cond(normal) < 1e12:
        return 0.0, np.inf, 0.0
    found = np.linalg.solve(normal, Z.T @ y.ravel())
    # what is left wanders: its scores are summed over a twelfth of the time and an axis each
    scores = (y - np.tensordot(found, np.array(known), 1))[None] * np.array(known)
    sums = np.concatenate([part.sum(axis=1) for part in np.array_split(scores, 12, axis=1)], axis=1)
    inverse = np.linalg.inv(normal)
    sigma = np.sqrt((inverse @ (sums @ sums.T) @ inverse)[1, 1])
    return float(found[1]), float(sigma), float(np.ptp(time))
