"""What is wrong with time tags, by the pattern of their differences: a counter, a format, a clock, an order."""

import numpy as np

from boresight.runtime.array import Array

WIDTHS = (16, 24, 32)  # bits of counters
TICKS = {"s": 1.0, "ms": 1e-3, "10 us": 1e-5, "us": 1e-6, "ns": 1e-9}
CLOCKS = {18.0: "leap seconds, GPS time beside UTC", 37.0: "leap seconds, TAI beside UTC", 604800.0: "a GPS week"}


def listed(times: Array) -> str:
    shown = ", ".join(f"{t:.4f}" for t in times[:3])
    return f"{shown} s" + (f" and {len(times) - 3} more" if len(times) > 3 else "")


def disorder(time: Array) -> str:
    """Why tags (N,) repeat or go backwards, and what to do; "" where they increase."""
    step = np.diff(time)
    back, same = step < 0, step == 0
    if not (back | same).any():
        return ""
    usual = float(np.median(step[step > 0])) if (step > 0).any() else 0.0
    if digits := coarse(time):
        return f"the tags have lost digits: {digits}; write them in double precision"
    if not back.any():
        text = f"{same.sum()} tags are repeated at {listed(time[:-1][same])}"
        return f"{text}; sort the rows and keep one for each instant"
    first = f"{back.sum()} tags go backwards after {listed(time[:-1][back])}"
    for bits in WIDTHS:
        for unit, tick in TICKS.items():
            span = 2.0**bits * tick
            if span > 4 * usual and (np.abs(step[back] + span - usual) < 0.6 * usual).all():
                return f"{first}: a counter of {bits} bits wraps, in {unit}; add {span:g} s from there on, do not sort"
    ordered = np.sort(time)
    shuffled = np.abs(time - ordered) > 0
    if not same.any() and (np.diff(ordered) > 0.5 * usual).all() and (np.abs(step[back]) < 100 * usual).all():
        return f"{first}: {shuffled.sum()} rows are out of order; sort the rows"
    lost = float(-step[back].min() + usual)
    return f"{first}: the clock was set back, by {lost:.6g} s; cut the recording there (from, to), do not sort"


def coarse(time: Array) -> str:
    """What tags in single precision have in common, or "".

    Their differences are whole multiples of 2^-k, though the interval is none.
    """
    step = np.diff(time)
    if (step > 0).sum() < 10:
        return ""
    kinds = np.unique(step)
    sizes = np.concatenate([kinds, np.diff(kinds)])
    least = float(sizes[sizes > 0].min())
    power = np.log2(least)
    usual = float(np.median(step[step > 0]))
    if power != round(power) or not usual / 16 < least or not (step % least == 0).all():
        return ""
    # an interval of 2^-k itself is a healthy clock's
    if np.mean(step != np.median(step)) < 0.1:
        return ""
    return f"all differences are multiples of 2^{round(power)} s, as in single precision (float32)"


def apart(seconds: float) -> str:
    """What clocks so far apart (s) are likely to be: "" where nothing is."""
    size = abs(seconds)
    for known, name in CLOCKS.items():
        if abs(size - known) < 0.3:
            return f" ({name}?)"
    hours = size / 3600
    if 0.4 < hours < 15 and abs(hours * 2 - round(hours * 2)) < 0.01:
        return f" (a time zone or summer time of {round(hours * 2) / 2:g} h?)"
    return f" ({round(size)} s exactly?)" if size > 0.9 and abs(size - round(size)) < 0.05 else ""
