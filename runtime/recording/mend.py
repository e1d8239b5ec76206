"""What may be done to a slave's samples before they are integrated: gaps bridged, samples at instants joined."""

from dataclasses import replace

import numpy as np

from boresight.runtime.array import Array
from boresight.runtime.recording.types import Inertial
from boresight.runtime.units import DEG

NEAR_S = 10.0  # how far around a gap the motion is taken to be like the one that is missing


def bridged(imu: Inertial, limit: float) -> tuple[Inertial, list[str]]:
    """Samples that are missing or not finite filled by straight lines, where no more than `limit` (s) is missing.

    What a straight line misses is seen on the recording itself: as many samples, left out wherever they are there,
    within NEAR_S of the gap.  The root mean square of that goes into `doubt` of the filled samples.
    Returns the samples, and a line for each length of gap.  Tags that repeat or go backwards are left as they are.
    """
    whole = np.isfinite(imu.time) & np.isfinite(imu.gyro).all(axis=1) & np.isfinite(imu.accel).all(axis=1)
    time, values = imu.time[whole], np.hstack([imu.gyro, imu.accel])[whole]
    if limit <= 0 or len(time) < 3 or (np.diff(time) <= 0).any():
        return imu, []
    dt, lost = _lost(time)
    share = (dt if imu.kind == "rates" else 1.0) * values
    total = np.vstack([np.zeros(6), np.cumsum(share, axis=0)])
    positions, doubts = [np.arange(len(time), dtype=float)], [np.zeros((len(time), 2))]
    gaps: dict[int, list[tuple[float, ...]]] = {}
    for k in np.flatnonzero((lost > 0) & (lost * dt <= limit * (1 + 1e-9))):
        m, reach = int(lost[k]), round(NEAR_S / dt)
        first = np.arange(max(0, int(k) - reach), min(len(time) - m - 1, int(k) + reach))
        breaks = np.concatenate([[0], np.cumsum(lost > 0)])
        first = first[breaks[first + m + 1] == breaks[first]]
        if len(first) < 10:
            continue  # nothing to judge it by: it stays a gap
        missed = total[first + m + 1] - total[first + 1] - m * (share[first] + share[first + m + 1]) / 2
        sigma = np.sqrt((missed**2).mean(axis=0)).reshape(2, 3).max(axis=1)
        positions.append(k + np.arange(1, m + 1) / (m + 1))
        doubts.append(np.tile(sigma / np.sqrt(m), (m, 1)))
        gaps.setdefault(m, []).append((float(time[k]), *sigma))
    position = np.concatenate(positions)
    order = np.argsort(position, kind="stable")
    at = position[order]
    rows = np.arange(len(time))
    filled = np.stack([np.interp(at, rows, column) for column in values.T], axis=-1)
    lines = [
        f"imu: {len(found)} gap{'s' * (len(found) > 1)} of {m * dt * 1e3:.4g} ms bridged, the first after "
        f"{found[0][0]:.3f} s; a straight line misses {max(gap[1] for gap in found) / DEG:.2g} deg and "
        f"{max(gap[2] for gap in found) * 1e3:.2g} mm/s of it"
        for m, found in sorted(gaps.items())
    ]
    doubt = np.concatenate(doubts)[order]
    out = replace(imu, time=np.interp(at, rows, time), gyro=filled[:, :3], accel=filled[:, 3:], doubt=doubt)
    return out, lines


def _lost(time: Array) -> tuple[float, Array]:
    """The usual interval (s), and how many samples are missing behind each but the last, (N-1,)."""
    step = np.diff(time)
    dt = float(np.median(step))
    return dt, np.where(step > 1.5 * dt, np.round(step / dt).astype(int) - 1, 0)


def joined(imu: Inertial) -> Inertial:
    """Rates at instants as increments between them, by the cubic through four neighbours; one sample less.

    Next to a gap, where two neighbours are missing, it is the straight line; behind a gap the sample itself.
    """
    w = np.hstack([imu.gyro, imu.accel])
    step = np.diff(imu.time)
    dt, lost = _lost(imu.time)
    mean = (w[:-1] + w[1:]) / 2
    even = np.abs(step - dt) < 0.1 * dt
    inner = even[:-2] & even[1:-1] & even[2:]
    mean[1:-1][inner] = ((-w[:-3] + 13 * w[1:-2] + 13 * w[2:-1] - w[3:]) / 24)[inner]
    mean[lost > 0] = w[1:][lost > 0]
    turned = mean * np.where(lost > 0, dt, step)[:, None]
    doubt = None if imu.doubt is None else np.sqrt((imu.doubt[:-1] ** 2 + imu.doubt[1:] ** 2) / 2)
    return Inertial("increments", "end", imu.time[1:], turned[:, :3], turned[:, 3:], doubt)
