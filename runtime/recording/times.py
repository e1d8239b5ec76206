"""Time tags of any kind as seconds: of the recording's own clock, or counted from one epoch where they are dates."""

from datetime import UTC, datetime

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.units import UNITS

ISO = "iso"  # the unit of a column of dates as ISO 8601 has them
DATE = 1e8  # s: a clock that shows more is no stopwatch but counts from 1970 (UNIX), 1980 (GPS) or so
NS = 10**9


def epoch(values: Array, unit: str) -> int:
    """Whole seconds from which tags in this unit are to be counted: 0 unless they are dates.

    Raises BoresightError for text that is no date.
    """
    whole, factor = _counts(values, unit)
    finite = whole[np.isfinite(whole)]
    if not len(finite):
        return 0
    usual = float(np.median(finite[:15])) * factor  # a first tag may be spoilt
    if abs(usual) < DATE:
        return 0
    firsts = np.asarray(finite[:15], float) * factor
    return int(np.floor(firsts[np.abs(firsts - usual) < DATE][0]))


def seconds(values: Array, unit: str, since: int) -> Array:
    """(N,) s since an epoch (s), nan where there is no tag; a count in ns keeps its digits."""
    whole, factor = _counts(values, unit)
    if whole.dtype.kind in "iu":
        per_second = round(1 / factor)
        return np.asarray(whole.astype(np.int64) - since * per_second, float) * factor
    return np.asarray((whole - since / factor) * factor)


def _counts(values: Array, unit: str) -> tuple[Array, float]:
    if unit != ISO:
        return values, UNITS["time"][unit]
    import pandas

    try:
        stamps = pandas.DatetimeIndex(
            pandas.to_datetime(values, utc=True, format=None if _dates(values) else "ISO8601")
        )
    except (ValueError, TypeError) as error:
        raise BoresightError(f"{str(error).splitlines()[0]}; a date is written 2024-05-01T12:00:00.25+02:00") from None
    whole = stamps.as_unit("ns").asi8
    return np.where(stamps.isna(), np.nan, whole) if stamps.isna().any() else whole, 1 / NS


def _dates(values: Array) -> bool:
    return bool(np.issubdtype(values.dtype, np.datetime64))


def shown(since: int) -> str:
    """The epoch as a date, if it counts from 1970."""
    return datetime.fromtimestamp(since, UTC).isoformat().replace("+00:00", "Z")


def instant(given: float | str | datetime, since: int, what: str) -> float:
    """s, an instant that a person names: "12.5 s" as tables show it, or a date or UNIX time as the file has it."""
    original = given
    if isinstance(given, str):
        given = _read(given.strip(), what)
    if isinstance(given, datetime):
        if not since:
            raise BoresightError(f"{what} is a date and the recording's times are not; give it in s")
        given = (given if given.tzinfo else given.replace(tzinfo=UTC)).timestamp()
    if not np.isfinite(value := float(given)):
        raise BoresightError(f"{what} is {original!r}, not finite")
    # Dates were counted anew from the epoch; what is as large as a date is one.
    return value - (since if abs(value) >= DATE else 0)


def _read(text: str, what: str) -> float | datetime:
    number, _, unit = text.rpartition(" ")
    try:
        return float(number) * UNITS["time"][unit] if unit in UNITS["time"] else float(text)
    except ValueError:
        pass
    try:
        return datetime.fromisoformat(text)
    except ValueError:
        known = ", ".join(UNITS["time"])
        raise BoresightError(
            f"{what} is {text!r}; give a time with its unit ({known}), as '12.5 s', or a date, as "
            "'2024-05-01T12:00:00Z'"
        ) from None
