"""What is wrong with time tags, by the pattern of their differences: a counter, a format, a clock, an order."""

import numpy as np

from boresight.runtime.array import Array
from boresight.runtime.recording.rows import alone

WIDTHS = (16, 24, 32)  # bits of counters
TICKS = {"s": 1.0, "ms": 1e-3, "10 us": 1e-5, "us": 1e-6, "ns": 1e-9}
CLOCKS = {18.0: "leap seconds, GPS time beside UTC", 37.0: "leap seconds, TAI beside UTC", 604800.0: "a GPS week"}


def listed(times: Array) -> str:
    shown = ", ".join(f"{t:.4f}" for t in times[:3])
    return f"{shown} s" + (f" and {len(times) - 3} more" if len(times) > 3 else "")


def disorder(time: Array, where: str = "time") -> str:
    """Why tags (N,) of `where` repeat or go backwards, and what to write; "" where they increase."""
    step = np.diff(time)
    back, same = step < 0, step == 0
    if not (back | same).any():
        return ""
    usual = float(np.median(step[step > 0])) if (step > 0).any() else 0.0
    if digits := coarse(time):
        return f'the tags have lost digits: {digits}; write them in double precision, or say clock = "regular"'
    if back.any() and (text := unpadded(time)):
        return f"{back.sum()} tags go backwards after {listed(time[:-1][back])}: {text}"
    lone = alone(time)
    spoilt = (
        f"{lone.sum()} tags stand off their neighbours (row {', '.join(map(str, np.flatnonzero(lone)[:3]))}): spoilt"
    )
    spoilt += '; bad_rows = "drop" leaves these rows out, do not sort'
    sound = lone.any() and bool((np.diff(time[~lone]) > 0).all())
    if not back.any() and sound:
        return spoilt
    if not back.any():
        text = f"{same.sum()} tags are repeated at {listed(time[:-1][same])}"
        advice = 'where the samples are regular and came in groups, clock = "regular"'
        return f"{text}, with other values: sort the rows and keep one for each instant; or, {advice}"
    first = f"{back.sum()} tags go backwards after {listed(time[:-1][back])}"
    for bits in WIDTHS:
        for unit, tick in TICKS.items():
            span = 2.0**bits * tick
            if span > 4 * usual and (np.abs(step[back] + span - usual) < 0.6 * usual).all():
                text = f'a counter of {bits} bits wraps, in {unit}: wraps = "{span:.10g} s" in {where}'
                return f"{first}: {text}; do not sort"
    if sound:
        return f"{first}: {spoilt}"
    for name, span in SPANS.items():
        if (np.abs(step[back] + span - usual) < max(0.6 * usual, 1e-6)).all():
            return f'{first}: {name}: wraps = "{span:g} s" in {where}; do not sort'
    ordered = np.sort(time)
    shuffled = np.abs(time - ordered) > 0
    if not same.any() and (np.diff(ordered) > 0.5 * usual).all() and (np.abs(step[back]) < 100 * usual).all():
        return f"{first}: {shuffled.sum()} rows are out of order; sort the rows"
    if (np.abs(np.diff(ordered) - usual) < 0.6 * usual).all():
        text = f"sorted they run on without a gap: the rows are in {back.sum() + 1} blocks out of order"
        by_text = " as text is, 10 before 9" if as_text(time) else ""
        return f"{first}: {text}{by_text and ', sorted' + by_text}; sort the rows by number"
    lost = float(-step[back].min() + usual)
    steps = ", ".join(set_by(time[k], step[k] - usual) for k in np.flatnonzero(back)[:3])
    text = f"the clock was set back, by {lost:.6g} s; cut the recording there (from, to), do not sort"
    return f"{first}: {text}; or, if nothing is missing, steps = [{steps}] in {where}"


def as_text(time: Array) -> bool:
    """Whether tags (N,) are in the order of their digits."""
    texts = [f"{t:.9f}" for t in time]
    return texts == sorted(texts)


def unpadded(time: Array) -> str:
    """Whether behind the point of tags (N,) s stand counts of ms or us without leading zeros: 0.010 as 0.10."""
    whole, row = np.unique(np.floor(time + 1e-7), return_inverse=True)
    count = np.bincount(row)
    if len(whole) < 3 or (np.diff(row) < 0).any():
        return ""
    each = int(np.median(count))
    begin = np.concatenate([[0], np.cumsum(count)[:-1]])
    nth = np.arange(len(time)) - begin[row]
    nth[row == 0] += each - count[0]  # the first second may be cut
    for name, places in (("milliseconds", 3), ("microseconds", 6)):
        ticks = np.round((time - whole[row]) * 10**places).astype(np.int64)
        # what the digits may have counted: 0.1 is 1, 10 or 100 ms
        possible = [np.where(ticks % 10**k == 0, ticks // 10**k, -(10**9)) for k in range(places)]
        meant = (nth + 0.5) / each * 10**places
        off = np.abs(np.stack(possible) - meant)
        counts = np.take_along_axis(np.stack(possible), off.argmin(axis=0)[None], axis=0)[0]
        rebuilt = whole[row] + counts / 10**places
        steps = np.diff(rebuilt) * each
        if (steps > 0).all() and np.mean(np.abs(steps - 1) < 0.5) > 0.98:
            text = f"{name} stand behind the point without their leading zeros, 0.{10 ** (places - 2)} for "
            text += f"{0.01:.{places}f}"
            return f"{text}; write {places} digits, or say rate and start in place of the tags"
    return ""


SPANS = {"the time of a day begins at midnight": 86400.0, "the time of a week begins on Sunday": 604800.0,
         "the time of an hour begins at its full": 3600.0, "the time of a minute begins at its full": 60.0}  # fmt: skip


def set_by(after: float, by: float) -> str:
    """A step of a clock, as a description has it."""
    return f'{{ after = "{after:.6f} s", by = "{by:+.6g} s" }}'


def coarse(time: Array) -> str:
    """What tags in single precision have in common, or ""."""
    least = grain(time)
    return (
        f"all differences are multiples of 2^{round(np.log2(least))} s, as in single precision (float32)"
        if least
        else ""
    )


def grain(time: Array) -> float:
    """s, of which all differences of tags are multiples: 2^-k, though the interval is none; 0 where there is none."""
    step = np.diff(time)
    if (step > 0).sum() < 10:
        return 0.0
    kinds = np.unique(step)
    sizes = np.concatenate([kinds, np.diff(kinds)])
    least = float(sizes[sizes > 0].min())
    power = np.log2(least)
    usual = float(np.median(step[step > 0]))
    if power != round(power) or not usual / 16 < least or not (step % least == 0).all():
        return 0.0
    # an interval of 2^-k itself is a healthy clock's
    if np.mean(step != np.median(step)) < 0.1:
        return 0.0
    return least


def shift(seconds: float) -> str:
    """The key that brings a master to the slave's clock where it is so late, s."""
    size = abs(seconds)
    exact = [known for known in CLOCKS if abs(size - known) < 0.3]
    if not exact and 0.4 < size / 3600 < 15:
        exact = [round(size / 1800) * 1800.0]
    if not exact and size > 0.9 and abs(size - round(size)) < 0.05:
        exact = [float(round(size))]
    value = -np.sign(seconds) * (exact[0] if exact else round(size, 3))
    return f'shift = "{value:+.10g} s" in master.time'


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
