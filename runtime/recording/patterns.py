"""What somebody did to samples before they were written: held, copied, interpolated, clipped, rounded."""

from typing import Literal

import numpy as np

from boresight.runtime import frames
from boresight.runtime.array import Array
from boresight.runtime.recording.types import Finding, Inertial, Master
from boresight.runtime.units import DEG

LONGEST = 30  # rows


def _together(columns: Array) -> tuple[float, Array]:
    """The share of rows (K, m) that are true in all columns, and which; 0 where columns are so by chance.

    A coarse sensor at rest repeats a number in one axis and another one in the next; what repeats a row does so in all.
    A long run of them is no pattern, but a motion that is even, of a simulation without noise.
    """
    rows: Array = np.all(columns, axis=1)
    share, least = float(rows.mean()), float(columns.mean(axis=0).min())
    ends = np.flatnonzero(~np.concatenate([[False], rows, [False]]))
    found = rows.sum() >= 3 and share > 0.3 * least and np.diff(ends).max() <= LONGEST
    return (share if found else 0.0), rows


def of_samples(imu: Inertial) -> list[Finding]:
    """Held, copied or interpolated samples, and axes at the end of their range."""
    values = np.hstack([imu.gyro, imu.accel])
    measured: Array = np.ones(len(values), bool)
    if imu.doubt is not None:
        measured &= (imu.doubt == 0).all(axis=1)
    out = []
    rate = 1 / imu.dt
    # to rounding: what a simulation without noise gives of an even motion
    same = np.abs(np.diff(values, axis=0)) <= 1e-10 * np.abs(values).max(axis=0)
    bend, size = np.abs(np.diff(values, 2, axis=0)), np.diff(values, axis=0).std(axis=0)
    between, _ = _together((bend <= 1e-6 * size)[measured[1:-1]])
    copied, rows = _together(same[measured[1:]])
    if between > 0.3:
        text = f"{between:.0%} of the samples lie on the line between their neighbours: interpolated from about "
        from_hz = f"{rate / round(1 / (1 - between)) if between < 0.99 else rate * (1 - between):.4g} Hz"
        text += f'{from_hz}; interpolated_from = "{from_hz}" in imu keeps the samples of the sensor'
        out.append(Finding("error", "imu", text, "interpolated"))
    elif copied > 0.3:
        text = f"{copied:.0%} of the samples repeat the one before: the slave is held at {rate * (1 - copied):.3g} Hz"
        rows_each = 1 / (1 - copied)
        line = ', and clock = "regular" puts them on their line' if abs(rows_each - round(rows_each)) > 0.05 else ""
        out.append(Finding("error", "imu", f'{text}; repeats = "drop" in imu keeps each sample once{line}', "copies"))
    elif copied:
        first = imu.time[1:][measured[1:]][int(np.argmax(rows))]
        text = f"{rows.sum()} samples are copies of the one before, the first at {first:.3f} s: lost ones filled in"
        advice = f'repeats = "drop" in imu leaves them out, and bridge = "{1e3 / rate:.3g} ms" fills the gaps'
        out.append(Finding("error", "imu", f"{text}; {advice}", "copies"))
    for name, columns in (("gyro", same[:, :3]), ("accel", same[:, 3:])):
        alone, repeated = _together(columns[measured[1:]])
        apart = np.diff(np.flatnonzero(~repeated))
        beat = len(apart) > 10 and np.mean(np.abs(apart - np.median(apart)) <= 1) > 0.9
        # of a coarse sensor at rest each axis repeats for itself
        most = float(columns[measured[1:]].mean(axis=0).max())
        if not copied and beat and most < 0.97 and alone > max(0.3, 0.9 * most):
            text = f"{alone:.0%} of its samples repeat the one before, and the other sensor's do not: it is held at "
            text += (
                f"{rate * (1 - alone):.3g} Hz; give it a time of its own, of the rows in which it is new ({name}.time)"
            )
            out.append(Finding("error", f"imu.{name}", text, "copies"))
    if between <= 0.3:
        out = _stuck(imu, values, same) + out
    out += [] if copied or between > 0.3 else _twice(imu, values)
    out += [] if between > 0.3 else _spikes(imu)
    unit = rate if imu.kind == "increments" else 1.0  # as delivered: the steps of a converter are none of dv / dt
    for name, sensor in (("gyro", imu.gyro), ("accel", imu.accel)):
        for axis, label in enumerate(frames.AXES):
            out += _wrapped(f"imu.{name}", label, sensor[:, axis], name, unit)
            out += _clipped(f"imu.{name}", label, sensor[1:, axis][~same.all(axis=1)], name, unit)
    return out


def _stuck(imu: Inertial, values: Array, same: Array) -> list[Finding]:
    """Axes of a noisy sensor that keep one value, to the last digit, through more than LONGEST rows."""
    found: dict[tuple[str, int, int], list[str]] = {}
    for k in range(values.shape[1]):
        ends = np.flatnonzero(~np.concatenate([[False], same[:, k], [False]]))
        longest = int(np.argmax(np.diff(ends)))
        first, last = int(ends[longest]), int(ends[longest + 1]) - 1
        rail = values[first, k] in (values[:, k].min(), values[:, k].max()) and last + 1 < len(values)
        moving: Array = np.ones(len(same), bool)
        moving[max(0, first - 1) : last + 1] = False
        bend = np.diff(values[:, k], 2)[moving[1:] & moving[:-1]]
        if last - first < max(LONGEST, 1 / imu.dt) or rail or len(bend) < LONGEST or same[moving, k].mean() > 0.2:
            continue
        # second differences of white noise go to and fro, those of a motion do not
        if bend[1:] @ bend[:-1] < -0.3 * (bend @ bend):
            found.setdefault((("gyro", "accel")[k // 3], first, last), []).append(frames.AXES[k % 3])
    out = []
    for (name, first, last), labels in found.items():
        until = "on" if last + 1 == len(values) else f"to {imu.time[last]:.3f} s"
        text = (
            f"{' and '.join(labels)} stuck at one value from {imu.time[first]:.3f} s {until}, while it was noisy before"
        )
        text = text.replace("before", "behind") if first == 0 else text
        out.append(Finding("error", f"imu.{name}", text + ": cut the recording there (from, to)", "stuck"))
    return out


def _spikes(imu: Inertial) -> list[Finding]:
    """Single samples that stand off both of their neighbours, which go on as before, far beyond any shock."""
    out = []
    for name, values, least, unit, shown in (
        ("gyro", imu.rates()[0], 200 * DEG, DEG, "deg/s"), ("accel", imu.rates()[1], 30.0, 1.0, "m/s^2")
    ):  # fmt: skip
        off = values[1:-1] - (values[2:] + values[:-2]) / 2
        beside = np.abs(values[2:] - values[:-2])
        usual = 1.5 * np.median(np.abs(off), axis=0)
        rows = ((np.abs(off) > np.maximum(least, 50 * usual)) & (beside < 0.1 * np.abs(off))).any(axis=1)
        if rows.any() and rows.mean() < 0.01 and (values < 0).any():
            many = "1 sample stands" if rows.sum() == 1 else f"{rows.sum()} samples stand"
            first, most = imu.time[1:-1][np.argmax(rows)], np.abs(off[rows]).max() / unit
            text = f"{many} alone, off by up to {most:.3g} {shown} from both neighbours, the first at {first:.3f} s"
            out.append(
                Finding("error", f"imu.{name}", text + ": spikes of a bad read or line; leave them out", "spikes")
            )
    return out


def coarse_gyro(imu: Inertial) -> list[Finding]:
    """A gyro whose steps are coarse beside what it turns."""
    for axis, values in zip(frames.AXES, imu.rates()[0].T, strict=True):
        levels = np.unique(np.round(values, 9))
        step = float(np.diff(levels).min()) if 3 < len(levels) < len(values) / 10 else 0.0
        if step > 0.2 * DEG and np.abs(np.diff(levels) / step % 1 - 0.5).min() > 0.49:
            text = f"{axis} has {len(levels)} values alone, {step / DEG:.3g} deg/s apart: rounded, or a range too large"
            return [Finding("warning", "imu.gyro", text)]
    return []


def _twice(imu: Inertial, values: Array) -> list[Finding]:
    """A stretch that stands there twice, to the last digit."""
    _, number, count = np.unique(values, axis=0, return_inverse=True, return_counts=True)
    again = np.flatnonzero(count[number.ravel()] > 1)
    if len(again) < LONGEST:
        return []
    order = again[np.lexsort((again, number.ravel()[again]))]
    pairs = np.stack([order[:-1], order[1:]])[:, np.diff(number.ravel()[order]) == 0]
    pairs = pairs[:, np.argsort(pairs[1])]
    apart = pairs[1] - pairs[0]
    # one after the other, as far apart, and not a sensor at rest that repeats its numbers at once
    ends = np.flatnonzero(np.append((np.diff(apart) != 0) | (np.diff(pairs[1]) != 1), True)) + 1
    begins = np.append(0, ends[:-1])
    longest = int(np.argmax((ends - begins) * (apart[begins] > LONGEST)))
    first, length = pairs[1, begins[longest]], ends[longest] - begins[longest]
    if (
        length < LONGEST
        or apart[begins[longest]] <= LONGEST
        or not np.ptp(values[first : first + length], axis=0).all()
    ):
        return []
    text = f"the {length * imu.dt:.2f} s from {imu.time[first]:.2f} s on repeat, to the last digit, what was there "
    text += (
        f"{apart[begins[longest]] * imu.dt:.2f} s before: a buffer written twice; cut the recording there (from, to)"
    )
    return [Finding("error", "imu", text, "copies")]


def of_axes(gyro: Array) -> str:
    """What is wrong with the numbers (N, 3) of one axis beside the others, "" where nothing is."""
    still = np.ptp(gyro, axis=0) == 0
    if still.any():
        axis = int(np.argmax(still))
        return f"{frames.AXES[axis]} is {gyro[0, axis]:.4g} all the time, and the others change: a dead axis?"
    if (gyro >= 0).all():
        return "no rate is ever below zero: the signs are lost, or a bit of them"
    for i, j in ((0, 1), (0, 2), (1, 2)):
        if any(np.array_equal(gyro[:, i], sign * gyro[:, j]) for sign in (1, -1)):
            return f"{frames.AXES[i]} and {frames.AXES[j]} are the same numbers: one column named twice?"
    return ""


def _wrapped(where: str, axis: str, values: Array, name: str, unit: float) -> list[Finding]:
    """An axis that goes on at the other end of its range: a count of too few bits."""
    top, end = float(values.max()), float(values.min())
    span = top - end
    if (np.abs(np.diff(values)) > 0.8 * span).sum() < 2 or abs(top + end) > 0.05 * span:
        return []
    whole = np.unwrap(values, period=span)
    if np.abs(np.diff(whole)).max() > 0.3 * span or np.sum(np.abs(whole) > 0.6 * span) < 4:
        return []
    size = f"{span / 2 * unit / DEG:.3g} deg/s" if name == "gyro" else f"{span / 2 * unit:.3g} m/s^2"
    text = f"{axis} wraps at about {size} and goes on with the other sign: the range is too small, or the bits too few"
    return [Finding("error", where, text + "; cut the recording there (from, to)", "saturated")]


def _clipped(where: str, axis: str, values: Array, name: str, unit: float) -> list[Finding]:
    levels, counts = np.unique(values, return_counts=True)
    if len(levels) < 10:
        return []
    for end, beside in ((0, 1), (-1, -2)):
        most = int(counts[end])
        step = abs(levels[end] - levels[beside])
        alone = step > 1e-9 * abs(levels[end])  # not an even motion, to rounding
        often = most >= 8 and most > 4 * counts[beside] and levels[end] != 0 and alone
        if often and _beyond(values, levels[end]) > 4 * step:
            rail = levels[end] * unit
            size = f"{rail / DEG:.4g} deg/s" if name == "gyro" else f"{rail:.4g} m/s^2"
            text = f"{axis}: {most} samples are {size} and none is beyond: the sensor saturates, or was clipped"
            return [Finding("error", where, text + "; cut the recording there (from, to)", "saturated")]
    return []


def _beyond(values: Array, rail: float) -> float:
    """How far beyond the end of their range samples would have gone, by the longest stay there and the slope before it.

    The crest of a smooth motion, in the steps of a converter, goes no further than some steps.
    """
    there = np.flatnonzero(np.diff(np.concatenate([[False], values == rail, [False]]).astype(int)))
    begins, ends = there[::2], there[1::2]
    stay = np.minimum(ends - begins, begins)
    if not (stay > 0).any():
        return np.inf
    begin, length = (int(part[stay.argmax()]) for part in (begins, stay))
    return float(abs(rail - values[begin - length])) / 4  # half of the way, at a slope that falls to nothing


def of_master(imu: Inertial, master: Master) -> list[Finding]:
    """A master that does not move, that repeats its rows, or whose angles are rounded."""
    gyro = imu.rates()[0]
    turned = float(np.sqrt(np.mean((gyro - gyro.mean(axis=0)) ** 2)))
    if len(master.time) > 10 and np.ptp(master.euler, axis=0).max() < 1e-9 and turned > 0.3 * DEG:
        text = f"its attitude never moves, while the slave turns by {turned / DEG:.3g} deg/s rms"
        return [Finding("error", "master.attitude", text + ": a reference that was never filled in?", "still")]
    parts = [part for part in (master.euler, master.v_n, master.position) if part is not None]
    out = _zero_angles(master, gyro) + _coarse_place(master)
    held, _ = _together(np.hstack([part[1:] == part[:-1] for part in parts]))
    if 0.3 < held < 0.97:
        rate = 1 / float(np.median(np.diff(master.time)))
        text = f"{held:.0%} of its rows repeat the one before: it is held at {rate * (1 - held):.3g} Hz"
        out.append(Finding("error", "master", f'{text}; repeats = "drop" in master keeps each row once', "copies"))
    each = master.euler[1:] == master.euler[:-1]
    still, _ = _together(each)
    # of rounded angles each repeats for itself
    if 0.3 < still < 0.97 and not held and still > 0.95 * float(each.mean(axis=0).max()):
        rate = 1 / float(np.median(np.diff(master.time)))
        text = (
            f"it repeats in {still:.0%} of the rows, and the rest does not: it is held at {rate * (1 - still):.3g} Hz"
        )
        text += "; give it a time of its own, of the rows in which it is new (attitude.time)"
        new: Array = np.cumsum(~each.all(axis=1))
        even = np.abs(new - np.linspace(0, new[-1], len(new))).max() < max(2.0, 0.02 * len(new))
        if not even:  # what turns slowly repeats, and what turns fast does not
            turned = np.linalg.norm(np.diff(master.euler, axis=0), axis=1)
            step = float(np.median(turned[turned > 0])) / DEG
            text = (
                f"it repeats in {still:.0%} of the rows, where it turns slowly: rounded to few digits, about {step:.2g}"
            )
            text += " deg apart; or held, and not evenly; write more digits"
        out.append(Finding("error", "master.attitude", text, "copies" if even else "rounded"))
    bend = np.abs(np.diff(np.unwrap(master.euler, axis=0), 2, axis=0)).max(axis=1)
    between = float((bend < 1e-9).mean())
    if 0.5 < between < 0.97 and still < 0.3 and np.ptp(master.euler[:, 2]) > 1 * DEG:
        text = f"{between:.0%} of its rows lie on the line between their neighbours: interpolated from a lower rate"
        out.append(Finding("error", "master.attitude", text + "; use the rows that were measured", "interpolated"))
    if master.v_n is not None and not held:
        kept, _ = _together((master.v_n[1:] == master.v_n[:-1]) | (master.v_n[1:] == 0))
        moving = float((master.v_n[1:] != 0).any(axis=1).mean())
        if 0.3 < kept < 0.97 and moving > 0.9:
            rate = 1 / float(np.median(np.diff(master.time)))
            text = f"its velocity repeats in {kept:.0%} of the rows, and its attitude does not: it is held at "
            text += f"{rate * (1 - kept):.3g} Hz; give it a time of its own, of the rows in which it is new"
            out.append(Finding("error", "master.velocity", text + " (velocity.time)", "copies"))
    degrees = np.degrees(master.euler)
    for step in (1.0, 0.5, 0.1):
        places = degrees / step
        if np.abs(places - np.round(places)).max() < 1e-6:
            if len(np.unique(np.round(places), axis=0)) >= 10:
                level: Literal["error", "warning"] = "error" if step >= 0.5 else "warning"
                text = f"its angles are rounded to {step:g} deg, a noise of {step / np.sqrt(12):.2g} deg that is none"
                out.append(Finding(level, "master.attitude", text + "; write more digits", "rounded"))
            break
    return out


def _zero_angles(master: Master, gyro: Array) -> list[Finding]:
    """Roll or pitch that nobody measured."""
    swings = np.std(gyro, axis=0) > 0.3 * DEG
    zero = [name for i, name in enumerate(("roll", "pitch")) if swings[i] and np.abs(master.euler[:, i]).max() < 1e-9]
    if not zero or len(master.time) < 10:
        return []
    text = (
        f"its {' and '.join(zero)} {'are' if zero[1:] else 'is'} 0 all the time, while the slave turns about such axes:"
    )
    return [
        Finding("error", "master.attitude", text + " a heading of two antennas alone, or columns left empty", "still")
    ]


def _coarse_place(master: Master) -> list[Finding]:
    """A latitude or longitude of few digits."""
    if master.position is None:
        return []
    for i, name in enumerate(("latitude", "longitude")):
        steps = np.diff(np.unique(master.position[:, i]))
        steps = steps[steps > 1e-13]
        if len(steps) < 4:
            continue
        size = float(steps.min())
        metres = size * 6371e3
        if metres > 0.3 and np.abs(steps / size - np.round(steps / size)).max() < 1e-3:
            text = f"its {name} is rounded to steps of {metres:.2g} m ({np.degrees(size):.2g} deg); write more digits"
            return [Finding("warning", "master.position", text)]
    return []
