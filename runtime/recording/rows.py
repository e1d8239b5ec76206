"""Rows as people have them: tags that a rate makes or that a clock broke, and rows that are no samples of the sensor.

Each is asked for by one key of the description, which `--check` proposes with its value; rows that are equal in every
column are left out without being asked for.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from boresight.errors import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.units import quantity

if TYPE_CHECKING:
    from boresight.runtime.recording.description import Time, Timed

NEAR = 15  # rows, in which one to seven that stand apart are not the usual ones
FAR = 10  # intervals by which they do


def seconds(value: float | str, what: str, kind: str = "time") -> float:
    """A number in s (or in Hz), or a quantity with its unit."""
    try:
        out = float(quantity(value, kind)[0]) if isinstance(value, str) else float(value)
    except BoresightError as error:
        raise BoresightError(f"{what}: {error}") from None
    if not np.isfinite(out):
        raise BoresightError(f"{what} is {value}, not finite")
    return out


def positive(value: float | str, what: str, kind: str) -> float:
    out = seconds(value, what, kind)
    if out <= 0:
        raise BoresightError(f"{what} is {value!r}; it must be above zero")
    return out


# ---------------------------------------------------------------- tags


def mended(time: Array, column: "Time", what: str, notes: list[str]) -> Array:
    """Tags (N,) s with the wraps of a counter undone, the steps of its clock taken off, and all of them shifted."""
    if column.wraps is not None:
        span = positive(column.wraps, f"{what}.wraps", "time")
        whole = np.isfinite(time)
        back = np.diff(time[whole]) < -span / 2
        time = time.copy()
        time[whole] += span * np.concatenate([[0], np.cumsum(back)])
        notes.append(f"{what}: a counter that wraps after {span:.6g} s, {back.sum()} times")
    for step in column.steps:
        after, by = seconds(step.after, f"{what}.steps.after"), seconds(step.by, f"{what}.steps.by")
        usual = float(np.median(np.abs(np.diff(time)))) if len(time) > 1 else 0.0
        near = np.flatnonzero(np.abs(time[:-1] - after) <= 0.6 * usual + 1e-4)
        # of tags that stand twice, where a clock was set back, the one behind which it was
        at = min(near, key=lambda k: abs(time[k + 1] - time[k] - by), default=None)
        if at is None or abs(time[at + 1] - time[at] - by) > max(3 * usual, 0.1 * abs(by)):
            raise BoresightError(f"{what}.steps: no tag steps by {by:+g} s after {after:g} s; --check names them")
        time = np.where(np.arange(len(time)) > at, time - by, time)
        notes.append(f"{what}: the clock was set by {by:+g} s after {after:g} s; taken off the tags that follow")
    if shift := seconds(column.shift, f"{what}.shift"):
        time = time + shift
        notes.append(f"{what}: shifted by {shift:+g} s")
    return time


def alike(time: Array, other: Array, column: "Time", what: str) -> Array:
    """Tags of a counter that wraps, on the turn of the counter on which another section's tags (of the same) are."""
    if column.wraps is None or not len(time) or not len(other):
        return time
    span = positive(column.wraps, f"{what}.wraps", "time")
    return time + span * np.round((np.nanmean(other[[0, -1]]) - np.nanmean(time[[0, -1]])) / span)


def regular(part: "Timed", what: str, count: int, rate: float, notes: list[str]) -> Array:
    """(count,) s: the tags that a sampling rate makes."""
    start = seconds(part.start, f"{what}.start")
    notes.append(f"{what}: no time tags; assumed from {start:g} s on at {rate:.6g} Hz")
    return start + np.arange(count) / rate


def alone(time: Array) -> Array:
    """(N,) whether a tag, or a few of them, stand far off their neighbours on both sides: rows that were spoilt."""
    if len(time) < NEAR or not np.isfinite(time).all():
        return np.zeros(len(time), bool)
    from scipy.ndimage import median_filter

    step = np.diff(time)
    usual = float(np.median(step[step > 0])) if (step > 0).any() else 0.0
    level = time - usual * np.arange(len(time))
    off: Array = np.abs(level - median_filter(level, NEAR, mode="reflect")) > FAR * usual
    return off if usual > 0 else np.zeros(len(time), bool)


def wild(gyro: Array, accel: Array) -> Array:
    """(N,) which samples (rad/s, m/s^2) are beyond what any sensor gives, where they are a few alone."""
    size = np.hstack([np.abs(gyro) / 70, np.abs(accel) / 2000]).max(axis=1)
    off: Array = size > 1
    few = 0 < off.sum() <= max(3, len(off) // 1000) and size[off].min() > 20 * size[~off].max()
    return off if few else np.zeros(len(off), bool)


# ---------------------------------------------------------------- rows that are no samples


def zero(gyro: Array, accel: Array) -> Array:
    """(N,) whether a read failed and left zeros: in both sensors, in the accelerometer, or in the gyro alone.

    Coarse increments are zero as well: what failed is far from what is read before and behind, a gyro's by its noise.
    """
    out: Array = _dropped(accel, 0.0) | _dropped(gyro, 8.0)
    return out if not out.all() else ~out


def _dropped(values: Array, noise: float) -> Array:
    size = np.abs(values).max(axis=1)
    read = np.flatnonzero(size)
    if len(read) < 2:
        return np.zeros(len(size), bool)
    k = np.searchsorted(read, np.arange(len(size))).clip(1, len(read) - 1)
    least = float(np.abs(values[values != 0]).min())
    beside = np.minimum(size[read[k - 1]], size[read[k]])
    usual = float(np.median(np.abs(np.diff(values[read], axis=0)).max(axis=1)))
    out: Array = (size == 0) & (beside > max(noise * usual, 3 * least))
    return out


def kept(
    part: "Timed", where: str, drop_bad: bool, time: Array, values: Array, failed: Array, left_out: list[str]
) -> Array:
    """(N,) bool: the rows that are samples; what is left out is counted, one line a kind.

    time: (N,) s; values: (N, m) all quantities of the section; failed: (N,) rows of zeros that a failed read left.
    """
    keep: Array = np.ones(len(time), bool)

    def without(rows: Array, text: str) -> None:
        if rows.any():
            left_out.append(f"{where}: {text.format(int(rows.sum()))}")
            keep[np.flatnonzero(keep)[rows]] = False

    if (np.diff(time) <= 0).any():
        without(twins(time, values), "{} equal rows, alike in every column, are left out")
    if drop_bad:
        finite = np.isfinite(time) & np.isfinite(values).all(axis=1)
        without(~finite[keep], "{} rows that are not finite are left out (bad_rows)")
        without(failed[keep], "{} rows of zeros are left out (bad_rows)")
        without(alone(time[keep]), "{} rows whose tags stand off their neighbours are left out (bad_rows)")
        if where == "imu" and getattr(part, "kind", "") == "rates":
            without(
                wild(values[keep, :3], values[keep, 3:6]), "{} rows beyond any sensor's range are left out (bad_rows)"
            )
    if part.repeats == "drop":
        one = values[keep]
        same = np.concatenate([[False], (one[1:] == one[:-1]).all(axis=1)])
        without(same, "{} rows that repeat the values of the one before are left out (repeats)")
    if part.interpolated_from is not None:
        rate = positive(part.interpolated_from, f"{where}.interpolated_from", "frequency")
        without(~knots(time[keep], values[keep], rate, where), f"{{}} rows between samples of {rate:g} Hz are left out")
    if keep.sum() < 2:
        raise BoresightError(f"{where}: {keep.sum()} rows are left of {len(keep)}; at least 2 are needed")
    return keep


def twins(time: Array, values: Array) -> Array:
    """(N,) whether a row is equal to an earlier one in its tag and in every value."""
    import pandas

    out: Array = pandas.DataFrame(np.column_stack([time, values])).duplicated().to_numpy()
    return out


def knots(time: Array, values: Array, rate: float, where: str) -> Array:
    """(N,) the rows between which lines were drawn: every n-th from where they bend."""
    usual = float(np.median(np.diff(time)))
    n = 1 / (rate * usual)
    if n < 1.5:
        raise BoresightError(f"{where}.interpolated_from is {rate:g} Hz, and the rows come at {1 / usual:.6g} Hz")
    bend = np.abs(np.diff(values, 2, axis=0)).sum(axis=1)
    whole = round(n)
    if abs(n - whole) < 0.02 * n:
        phase = max(range(whole), key=lambda one: float(np.median(bend[one::whole]))) + 1
        rows: Any = np.arange(phase % whole, len(time), whole)
    else:  # the row next to each sample
        rows = np.unique(np.round(np.arange(0, (len(time) - 1) / n) * n).astype(int))
    out: Array = np.zeros(len(time), bool)
    out[rows] = True
    return out
