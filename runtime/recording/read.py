"""From a file and its TOML description to a `Recording` in NED/FRD, SI and radians.

What a description may say: docs/recordings.md.  Only NumPy is imported before a file is read.
"""

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from boresight.errors import BoresightError, did_you_mean, need
from boresight.runtime import frames, rotation
from boresight.runtime.array import Array
from boresight.runtime.calibration import Calibration
from boresight.runtime.recording import rows, tags, times
from boresight.runtime.recording.check import check
from boresight.runtime.recording.mend import bridged, joined
from boresight.runtime.recording.tables import Table, kind_of, layout, layout_keys, table, written
from boresight.runtime.recording.types import Inertial, Master, Recording
from boresight.runtime.units import UNITS, quantity

if TYPE_CHECKING:
    from boresight.runtime.recording.description import Column, Description, Known, MasterPart, Timed

PLACE = ("latitude", "longitude", "altitude", "ref_lat", "ref_lon", "ref_alt")  # fields that say where an origin is
BUILT_IN = Path(__file__).parent / "built_in"
EXAMPLE = Path(__file__).parent / "example" / "simulated.npz"  # its truth is known; made by a simulator of flights


def find(path: str | Path) -> Path:
    """The file at PATH, or of that name under the folder BORESIGHT_DATA; raises BoresightError.

    A ROS 2 bag may be a folder.
    """
    folder = os.environ.get("BORESIGHT_DATA")
    for candidate in (Path(path), *([Path(folder) / path] if folder else [])):
        if candidate.is_file() or (candidate / "metadata.yaml").is_file():
            return candidate
    if Path(path).is_dir():
        inside = sorted(one.name for one in Path(path).glob("*.toml"))
        hint = f"did you mean {Path(path) / inside[0]}?" if len(inside) == 1 else f"name one of {', '.join(inside)}"
        raise BoresightError(f"{path}: a folder; {hint if inside else 'there is no description (.toml) in it'}")
    where = f"here or under {folder}" if folder else "here"
    raise BoresightError(f"{path}: no such file {where}; give its path, or set BORESIGHT_DATA to its folder")


def read(
    path: str | Path,
    *,
    strict: bool = True,
    begin: float | str | datetime | None = None,
    end: float | str | datetime | None = None,
    bridge: float | str | None = None,
    regular: bool = False,
    allow: Sequence[str] = (),
) -> Recording:
    """A recording of a slave and, if there is one, its master, in NED, FRD, SI and rad.

    Parameters
    ----------
    path : str or Path
        A TOML description, or a data file that has one: of the same name beside it, or one that
        comes with Boresight and knows all its arrays or topics.  A file that is not found here is
        looked for in the folder BORESIGHT_DATA.
    strict : bool, optional
        Refuse what `boresight replay --check` calls an error.
    begin, end : float, str or datetime, optional
        Cut to these times, above what the description says: s as the check shows the time, "12 s",
        or a date.
    bridge : float or str, optional
        s, or "20 ms": up to this much missing is filled.
    regular : bool, optional
        The slave's clock is regular, whatever its tags say.
    allow : sequence of str, optional
        Names of errors that are none here.

    Returns
    -------
    Recording
        `imu`: times and increments of the slave; `master`: times, velocity, attitude and position,
        or None; `reference`: what is known as truth, by name; `notes`: what was done to the data.

    Raises
    ------
    BoresightError
        A file or column that is missing, a value that cannot be, an unknown unit or format, an
        extra that is not installed: the file, the column and what to do.

    Notes
    -----
    When not to use it: for arrays that you have; `Live` and the filters take them as they are.
    With strict=False look at `boresight replay --check` first: errors of axes and units are seen
    there alone.

    Examples
    --------
    >>> from pathlib import Path
    >>> from boresight import read, simulation
    >>> description = simulation.drive.simulate("drive", seed=1, duration=5.0)
    >>> drive = read(description)
    >>> drive.imu.rates()[0].shape[1], drive.master.v_n.shape[1]
    (3, 3)
    """
    need("replay")
    found = find(path)
    recording = _read(found, begin, end, bridge, regular, allow, join=True)
    if strict:
        refuse_wrong(recording, found)
    return recording


def read_at_rest(
    path: str | Path,
    *,
    begin: float | str | datetime | None = None,
    end: float | str | datetime | None = None,
    bridge: float | str | None = None,
    regular: bool = False,
    allow: Sequence[str] = (),
) -> Recording:
    """The slave of a recording at rest, for a look at its noise: whatever side is up, and no master.

    Rates at instants stay such: a cubic between them is a filter.  Arguments and errors are those of `read`.
    """
    need("replay")
    found = find(path)
    recording = _read(found, begin, end, bridge, regular, allow, join=False)
    recording = replace(recording, master=None, allow=(*recording.allow, "down"))
    refuse_wrong(recording, found)
    return recording


def refuse_wrong(recording: Recording, found: Path) -> None:
    """Raises BoresightError where the check calls something an error."""
    wrong = [finding for finding in check(recording) if finding.level == "error"]
    if wrong:
        more = f" ({len(wrong) - 1} more: --check lists them)" if len(wrong) > 1 else ""
        meant = f"; if it is meant so: --allow {wrong[0].name}" if wrong[0].name else ""
        raise BoresightError(f"{found}: {wrong[0].where}: {wrong[0].text}{more}{meant}")


def _read(
    found: Path,
    begin: float | str | datetime | None,
    end: float | str | datetime | None,
    bridge: float | str | None,
    regular: bool,
    allow: Sequence[str],
    join: bool,
) -> Recording:
    """What `read` returns, unjudged.  join: rates at instants become increments between them."""
    from boresight.runtime.recording import description

    tables: dict[Path, Table] = {}
    if found.suffix == ".toml":
        described = description.load(found)
        default = _beside(found, described.file) if described.file else None
    elif found.with_suffix(".toml").is_file():
        described, default = description.load(found.with_suffix(".toml")), found
    else:
        columns = table(found)
        described, default = _built_in(found, columns), found
        tables[found] = columns

    if wrong_columns := description.shared(described):
        raise BoresightError(f"{found}: {wrong_columns}")

    def source(section: Any) -> _Source:
        if not description.named(section):
            return _Source(found, {})  # all numbers stand in the description
        file = _beside(found, section.file) if section.file else default
        if file is None:
            raise BoresightError(f'{found}: no data file is named; add file = "NAME" at the top or in each section')
        text = (described.delimiter, described.decimal, described.header)
        if file not in tables:
            tables[file] = table(file, *text, bad_rows=described.bad_rows)
        return _Source(file, tables[file], text)

    at = source(described.imu)
    since = at.epoch("imu.time", described.imu.time) if described.imu.time and not described.imu.rate else 0
    notes = [f"times count from {times.shown(since)}, if the file's count from 1970"] if since else []
    left_out: list[str] = []
    failed: dict[str, tuple[int, int]] = {}
    imu = _imu(described, at, since, notes, left_out, failed)
    master = None
    if described.master:
        master = _master(described, source(described.master), imu.time, since, notes, left_out, failed)
    left_out = [line for held in tables.values() for line in held.left_out] + left_out
    span = [
        times.instant(value, since, f"{found}: {key}") if value is not None else None
        for key, value in (
            ("from", described.begin if begin is None else begin),
            ("to", described.end if end is None else end),
        )
    ]
    if any(value is not None for value in span):
        low, high = (limit if value is None else value for limit, value in zip((-np.inf, np.inf), span, strict=True))
        imu, master = _cut(found, imu, master, low, high)
        notes.append(f"cut to {imu.time[0]:.3f} s to {imu.time[-1]:.3f} s")
    if regular or described.imu.clock == "regular":
        time, line = _fitted("imu", imu.time)
        imu = replace(imu, time=time)
        notes.append(line)
    if master and described.master and described.master.clock == "regular":
        time, line = _fitted("master", master.time)
        master = replace(master, time=time)
        notes.append(line)
    limit = described.bridge if bridge is None else bridge
    limit = float(quantity(limit, "time")[0]) if isinstance(limit, str) else limit
    if not 0 <= limit < np.inf:
        raise BoresightError(f"{found}: bridge is {limit:g} s; it must be 0 or more")
    imu, lines = bridged(imu, limit)
    notes += lines
    if described.calibration:
        imu = _calibrated(described, source(described.calibration), imu, notes)
    if described.imu.time_marks == "point" and join:
        imu = joined(imu)
        notes.append("imu: rates at instants joined to increments between them, by cubics")
    return Recording(
        name=found.stem,
        title=described.title,
        imu=imu,
        master=master,
        reference=_reference(described, source(described.reference)) if described.reference else {},
        epoch=since,
        notes=tuple(notes),
        left_out=tuple(left_out),
        axes=_named_axes(described),
        allow=(*described.allow, *allow),
        noise=described.noise.model_dump(exclude_none=True) if described.noise else {},
        stops=_stops(found, described, since, imu.dt),
        failed=failed,
        temperature=_temperature(described.imu, at, since),
    )


def _stops(found: Path, described: "Description", since: int, dt: float) -> dict[str, Any]:
    """[stops] as settings of the replay."""
    part = described.stops
    if part is None:
        return {}
    out: dict[str, Any] = {"sway_factor": part.sway, "latitude_deg": part.latitude}
    if part.rest is not None:
        if len(part.rest) != 2:
            raise BoresightError(f'{found}: stops.rest holds {len(part.rest)} times; give two, as ["0 s", "12 s"]')
        out["rest"] = tuple(times.instant(value, since, f"{found}: stops.rest") for value in part.rest)
    if part.window is not None:
        out["window"] = max(2, round(rows.positive(part.window, f"{found}: stops.window", "time") / dt))
    return {name: value for name, value in out.items() if value is not None}


def template(path: str | None = None) -> str:
    """A description to be filled in; with the columns of a file, and as the map of its topics where there is one."""
    if path is None:
        return (BUILT_IN / "template.toml").read_text(encoding="utf-8")
    need("replay")
    from boresight.runtime.recording import description

    found = find(path)
    keys = layout_keys(found)[0]
    columns = table(found, **keys)
    maps = [file for file in sorted(BUILT_IN.glob("*.toml")) if kind_of(found) in description.load(file).serves]
    described = (maps[0] if maps else BUILT_IN / "template.toml").read_text(encoding="utf-8")
    if (lines_of := described.find("[master.origin]")) >= 0 and not all(
        name in columns for name in _origins(described)
    ):
        described = (
            described[:lines_of] + "[master.origin]\nlatitude = 47.4                  # deg, where it was: yours\n"
        )
    held = [f"#   {name} {'x'.join(map(str, values.shape))}" for name, values in columns.items()]
    lines = [line for line in described.splitlines() if not line.startswith(("serves", "file", *keys))]
    named = [*written(keys), f'file = "{found.name}"', ""]
    at = next(i for i, line in enumerate(lines) if line.startswith("["))
    return "\n".join([*lines[:at], *named, *lines[at:], "", f"# What {found.name} holds:", *held, ""])


def _origins(described: str) -> list[str]:
    """The columns of an origin in a map of topics, where it stands last."""
    return [line.split('"')[1] for line in described.partition("[master.origin]")[2].splitlines() if '"' in line]


def _beside(description: Path, file: str) -> Path:
    """A file that a description names stands beside the description, or where `find` looks."""
    beside = description.parent / file
    return beside if beside.is_file() or (beside / "metadata.yaml").is_file() else find(file)


def _built_in(path: Path, columns: dict[str, Array]) -> "Description":
    """The description that knows all arrays of a file, or whose topics a log has."""
    from boresight.runtime.recording import description

    lacking: list[str] = []
    for candidate in sorted(BUILT_IN.glob("*.toml")):
        described = description.load(candidate)
        if columns and set(described.recognised_by) == set(columns):
            return described
        if kind_of(path) in described.serves:
            lacking = [name for name in description.named(described) if name not in columns]
            if not lacking:
                return described
    toml = path.with_suffix(".toml").name
    lacks = f"it lacks {lacking[0]}" if lacking else "its columns are not described"
    if lacking and all("/" in name and name.rpartition("/")[2] in PLACE for name in lacking):
        lacks += ", and so no place; with origin = { latitude = 47.4 } (deg, where it was) in place of [master.origin]"
        toml = path.with_suffix(".toml").name
        begins = f"'boresight replay --template {path.name}' begins {toml}, with that line to be filled in"
        raise BoresightError(f"{path}: {lacks} it flies: {begins}")
    raise BoresightError(
        f"{path}: {lacks}; write {toml} beside it: 'boresight replay --template {path.name}' begins it"
    )


# ---------------------------------------------------------------- columns


@dataclass(frozen=True)
class _Source:
    """A file's columns; text: delimiter, decimal and header that a file of text was read with."""

    path: Path
    table: dict[str, Array]
    text: tuple[str, str, bool | int] = (",", ".", True)

    def array(self, what: str, name: str) -> Array:
        # A column of a matrix may be named as "imu[0]", its row as "imu.T[0]": so mat files are usually laid out.
        base, _, index = name.partition("[") if name not in self.table else (name, "", "")
        turned = base not in self.table and base.endswith(".T")
        base = base.removesuffix(".T") if turned else base
        if base not in self.table:
            hint = layout(self.path, *self.text)
            raise BoresightError(f"{self.path}: {what}: there is no column {name!r}; {hint or self._has(name)}")
        values = self.table[base].T if turned else self.table[base]
        if index:
            number = index.rstrip("]")
            if values.ndim == 2 and values.shape[0] < 25 and values.shape[1] > 10 * values.shape[0] and not turned:
                text = f"{base} is {values.shape[0]} x {values.shape[1]}, and samples run along its second axis"
                raise BoresightError(f'{self.path}: {what}: {text}: write "{base}.T[{number}]"')
            if values.ndim != 2 or not number.isdecimal() or int(number) >= values.shape[1]:
                raise BoresightError(f"{self.path}: {what}: {name!r} does not exist: {base} has shape {values.shape}")
            values = values[:, int(number)]
        return values

    def number(self, what: str, name: str) -> float:
        """The first finite number of a column."""
        values = np.ravel(self.numbers(what, name).astype(float))
        values = values[np.isfinite(values)]
        if len(values) == 0:
            raise BoresightError(f"{self.path}: {what}: {name!r} holds no number; give one")
        return float(values[0])

    def rate(self, what: str, rate: float | str) -> float:
        """Hz: a number, a quantity, or a number of the file."""
        if isinstance(rate, str) and (rate in self.table or " " not in rate.strip()):
            return rows.positive(self.number(what, rate), f"{self.path}: {what}", "frequency")
        return rows.positive(rate, f"{self.path}: {what}", "frequency")

    def no_time(self, section: str) -> BoresightError:
        """What to write where there are no tags, with a rate that the file holds."""
        held = [name for name, values in self.table.items() if np.size(values) == 1 and _of_rates(name)]
        found = f'rate = "{self.number(section, held[0]):.6g} Hz" ({held[0]!r} holds it)' if held else 'rate = "100 Hz"'
        text = "has no time: name its column, time = { columns = ..., unit = ... }; or, where the file has none and "
        return BoresightError(f"{self.path}: {section} {text}the samples are regular, {found}")

    def _has(self, name: str) -> str:
        """What there is: the fields of the topic, else the topics, else the columns."""
        topic, _, field = name.rpartition("/")
        mates = [one for one in self.table if field and one.rpartition("/")[0] == topic]
        topics = list(dict.fromkeys(one.rpartition("/")[0] for one in self.table if field))
        known = mates or ([one for one in topics if one] or list(self.table))
        close = did_you_mean(name, self.table).strip(" ()").rstrip("?")
        more = f" and {len(known) - 40} more" if len(known) > 40 else ""
        return f"{close + '? ' if close else ''}it has {', '.join(known[:40])}{more}"

    def numbers(self, what: str, name: str) -> Array:
        values = self.array(what, name)
        if not (np.issubdtype(values.dtype, np.number) and np.isrealobj(values)):
            hint = layout(self.path, *self.text) or _advice(values)
            raise BoresightError(f"{self.path}: {what}: column {name!r} is not numeric; {hint}")
        return values

    def column(self, what: str, column: "Column", kind: str, width: int) -> Array:
        """(N, width) of one quantity in SI and radians."""
        factor = self.factor(what, column.unit, kind)
        names = [column.columns] if isinstance(column.columns, str) else column.columns
        parts = [self.numbers(what, name).astype(float) for name in names]
        parts = [part.ravel() if len(parts) > 1 and 1 in part.shape[1:] else part for part in parts]
        out = np.stack(parts, axis=-1) if len(parts) > 1 and len({p.shape for p in parts}) == 1 else parts[0]
        if out.ndim != 2 or out.shape[1] != width or len(parts) not in (1, width):
            shapes = ", ".join(f"{name} {part.shape}" for name, part in zip(names, parts, strict=True))
            advice = ""
            if len(parts) == 1 and out.ndim == 2 and out.shape[0] == width:
                advice = f'; samples run along its second axis: write "{names[0]}.T"'
            raise BoresightError(f"{self.path}: {what} needs {width} columns of one length; found {shapes}{advice}")
        return out * factor

    def factor(self, what: str, unit: str, kind: str) -> float:
        if unit not in UNITS[kind]:
            close = did_you_mean(unit, UNITS[kind])
            known = ", ".join(UNITS[kind])
            raise BoresightError(
                f"{self.path}: {what}: unit {unit!r} is not known for {kind}{close}; use one of {known}"
            )
        return UNITS[kind][unit]

    def stamps(self, what: str, column: "Column") -> Array:
        """(N,) the column of time as it stands in the file."""
        if column.unit != times.ISO:
            self.factor(what, column.unit, "time")
        name = column.columns if isinstance(column.columns, str) else column.columns[0]
        values = (self.array if column.unit == times.ISO else self.numbers)(what, name)
        values = values.ravel() if values.ndim == 2 and 1 in values.shape else values
        if values.ndim != 1 or not (isinstance(column.columns, str) or len(column.columns) == 1):
            raise BoresightError(f"{self.path}: {what} needs one column of one length; found {name} {values.shape}")
        return values

    def epoch(self, what: str, column: "Column") -> int:
        try:
            return times.epoch(self.stamps(what, column), column.unit)
        except BoresightError as error:
            raise self._here(what, error) from None

    def time(self, what: str, column: "Column", since: int) -> Array:
        """(N,) s since the recording's epoch."""
        values = self.stamps(what, column)
        own = self.epoch(what, column)
        if bool(own) != bool(since):
            dates = (what, "imu.time") if own else ("imu.time", what)
            raise BoresightError(
                f"{self.path}: {dates[0]} shows dates and {dates[1]} does not; bring both to one clock"
            )
        return times.seconds(values, column.unit, since)

    def _here(self, what: str, error: BoresightError) -> BoresightError:
        text = str(error)
        return error if text.startswith(str(self.path)) else BoresightError(f"{self.path}: {what}: {text}")

    def same_length(self, section: str, time: Array, **parts: Array | None) -> None:
        for name, part in parts.items():
            if part is not None and len(part) != len(time):
                text = f"{section}.{name} has {len(part)} rows and {section}.time {len(time)}"
                raise BoresightError(f"{self.path}: {text}; they must agree, or {name} has a time of its own")
        if len(time) < 2:
            raise BoresightError(f"{self.path}: {section}.time has {len(time)} rows; at least 2 are needed")

    def known(self, what: str, known: "Known", kind: str, shape: tuple[int, ...] = (3,)) -> Array:
        """Numbers of a description, or of an array of the file, in SI and radians."""
        factor = self.factor(what, known.unit, kind)
        if (known.columns is None) == (known.values is None):
            raise BoresightError(f"{self.path}: {what} needs columns or values, and not both")
        values = self.table.get(known.columns) if known.columns is not None else np.array(known.values, object)
        try:
            values = None if values is None else np.array(values.tolist(), float)
        except ValueError:  # rows of different lengths, or text
            values = None
        if values is None or values.shape != shape:
            found = "no such array of numbers" if values is None else f"shape {values.shape}"
            wanted = "3 numbers" if shape == (3,) else "3 rows of 3 numbers"
            listed = repr(known.columns) if known.columns is not None else "values"
            raise BoresightError(f"{self.path}: {what} needs {wanted}; {listed}: {found}")
        if not np.isfinite(values).all():
            raise BoresightError(f"{self.path}: {what} is not finite: {values.tolist()}")
        return values * factor


def _of_rates(name: str) -> bool:
    """Whether a name is one that people give to a sampling rate."""
    words = name.lower().replace("/", "_").replace("-", "_").split("_")
    return bool({"rate", "fs", "hz", "frequency", "freq", "samplingrate", "samplerate"} & set(words))


def _advice(values: Array) -> str:
    """What text in a column of numbers hints at."""
    if not values.size:
        return "it has no rows"
    first = str(values.ravel()[0])
    if first.replace(",", "", 1).lstrip("+-").isdigit() and "," in first:
        return f'it begins with {first!r}: decimal = "," reads it'
    if first[:4].isdigit() and ("-" in first or ":" in first):
        return f'it begins with {first!r}: unit = "iso" reads dates'
    text = []
    for row, value in enumerate(values.tolist()):
        try:
            float(value)
        except (TypeError, ValueError):
            text.append(row)
    if text and len(text) < len(values) / 2:
        more = f", and {len(text) - 1} more such rows" if len(text) > 1 else ""
        return f'row {text[0]} holds {values[text[0]]!r}{more}; remove them, or bad_rows = "drop" leaves them out'
    return f'it begins with {first!r}: decimal = "." reads it'


# ---------------------------------------------------------------- sections


def _failed(rows: Array, where: str, dropped: bool, failed: dict[str, tuple[int, int]]) -> Array:
    """The rows (N,) of zeros, and a line of them where they are not dropped."""
    if rows.any() and not dropped:
        failed[where] = int(rows.sum()), int(np.argmax(rows))
    return rows


def _imu(
    described: "Description", at: _Source, since: int, notes: list[str], left_out: list[str],
    failed: dict[str, tuple[int, int]],
) -> Inertial:  # fmt: skip
    part = described.imu
    kinds = ("angular rate", "acceleration") if part.kind == "rates" else ("angle", "velocity")
    if part.kind == "increments" and part.time_marks == "point":
        raise BoresightError(f"{at.path}: imu.time_marks: an increment has no instant; use start, middle or end")
    to_frd = _framed(at, "imu.body", frames.body_to_frd, part.body)
    values = {}
    for name, column, kind in (("gyro", part.gyro, kinds[0]), ("accel", part.accel, kinds[1])):
        values[name] = at.column(f"imu.{name}", column, kind, 3)
        values[name][_absent(at, f"imu.{name}", column, len(values[name]), left_out)] = np.nan
    time = _clock(at, "imu", part, len(values["gyro"]), since, notes)
    for name, column in (("gyro", part.gyro), ("accel", part.accel)):
        if column.time is not None:
            if part.kind == "increments":
                raise BoresightError(
                    f"{at.path}: imu.{name}.time: increments cannot be interpolated to other tags; use rates"
                )
            own, values[name] = _tagged(at, f"imu.{name}", column, part, since, values[name], slice(None), left_out)
            near = _near(own, time)
            values[name] = np.stack([np.interp(time, own, axis) for axis in values[name].T], axis=-1)
            values[name][~near] = np.nan
            notes.append(f"imu.{name} has tags of its own: brought to those of imu.time")
    if any(column.time is not None for column in (part.gyro, part.accel)):
        both = np.isfinite(values["gyro"]).all(axis=1) & np.isfinite(values["accel"]).all(axis=1)
        inside = slice(int(np.argmax(both)), len(both) - int(np.argmax(both[::-1])))
        time, values = time[inside], {name: value[inside] for name, value in values.items()}
    at.same_length("imu", time, **values)
    if part.interval is not None:
        values = _own_intervals(at, part, time, values, notes)
    with np.errstate(invalid="ignore"):  # an infinite value is `check`'s to report
        gyro, accel = (value @ to_frd.T for value in values.values())
    drop = described.bad_rows == "drop"
    zero = _failed(rows.zero(gyro, accel), "imu", drop, failed)
    keep = rows.kept(part, "imu", drop, time, np.hstack([gyro, accel]), zero, left_out)
    # Samples at instants are joined once they are all there; until then only their tags count.
    marks = "end" if part.time_marks == "point" else part.time_marks
    return Inertial("rates" if part.interval else part.kind, marks, time[keep], gyro[keep], accel[keep])


def _clock(at: _Source, section: str, part: "Timed", count: int, since: int, notes: list[str]) -> Array:
    """(N,) s: the tags of a section as its clock was meant, or those of its sampling rate."""
    if part.rate is not None:
        if part.time is not None:
            raise BoresightError(f"{at.path}: {section} has a time and a rate; give one of them")
        return rows.regular(part, section, count, at.rate(f"{section}.rate", part.rate), notes)
    if part.time is None:
        raise at.no_time(section)
    return rows.mended(at.time(f"{section}.time", part.time, since), part.time, f"{section}.time", notes)


def _own_intervals(at: _Source, part: Any, time: Array, values: dict[str, Array], notes: list[str]) -> dict[str, Array]:
    """Increments as rates, by what each of them covers."""
    if part.kind != "increments":
        raise BoresightError(f"{at.path}: imu.interval applies to increments, and these are rates; leave it out")
    factor = at.factor("imu.interval", part.interval.unit, "time")
    name = part.interval.columns
    own = np.ravel(at.numbers("imu.interval", name if isinstance(name, str) else name[0]).astype(float)) * factor
    at.same_length("imu", time, interval=own)
    if not (own > 0).all():
        raise BoresightError(
            f"{at.path}: imu.interval: row {int(np.argmin(own > 0))} is {own.min():g} s; it must be > 0"
        )
    share = float(np.median(own)) / float(np.median(np.diff(time)))
    text = f"increments cover {np.median(own) * 1e3:.4g} ms each, {share:.1%} of the time between tags"
    notes.append(f"imu: {text}; made rates by their own interval")
    return {name: value / own[:, None] for name, value in values.items()}


def _absent(at: _Source, what: str, column: "Column", count: int, left_out: list[str]) -> Array:
    """(N,) the rows of messages that say they have no such quantity: X_covariance[0] is -1, as ROS has it."""
    name = column.columns
    covariance = at.table.get(f"{name}_covariance") if isinstance(name, str) else None
    if covariance is None or covariance.ndim != 2 or len(covariance) != count:
        return np.zeros(count, bool)
    absent: Array = covariance[:, 0] == -1
    if absent.all():
        text = f"{name} is given in no message ({str(name).rpartition('/')[2]}_covariance[0] = -1)"
        raise BoresightError(f"{at.path}: {what}: {text}; name another topic, or leave this out")
    if absent.any():
        left_out.append(f"{what}: {absent.sum()} messages do not give it (its covariance[0] is -1)")
    return absent


def _temperature(part: Any, at: _Source, since: int) -> Array | None:
    """(N, 2) s and degC of the slave, rows that are finite."""
    if part.temperature is None:
        return None
    names = part.temperature.columns
    factor = at.factor("imu.temperature", part.temperature.unit, "temperature")
    values = at.numbers("imu.temperature", names if isinstance(names, str) else names[0]).astype(float) * factor
    if part.time is None or part.temperature.time is None:
        time = _clock(at, "imu", part, len(values), since, [])
    else:
        time = at.time("imu.temperature.time", part.time.model_copy(update={"columns": part.temperature.time}), since)
    at.same_length("imu", time, temperature=values)
    both = np.column_stack([time, np.ravel(values)])
    return both[np.isfinite(both).all(axis=1)]


def _tagged(
    at: _Source,
    what: str,
    column: "Column",
    section: "Timed",
    since: int,
    values: Array,
    given: Any,
    left_out: list[str],
) -> tuple[Array, Array]:
    """A quantity's own tags (N,) s, and its values at them: rows that are given, and once each."""
    assert column.time is not None
    if section.time is None:
        raise BoresightError(f"{at.path}: {what}.time: the section has a rate and no time; give it a time")
    of = section.time.model_copy(update={"columns": column.time})
    own = rows.mended(at.time(f"{what}.time", of, since), of.model_copy(update={"steps": []}), f"{what}.time", [])
    if len(own) != len(values):
        raise BoresightError(f"{at.path}: {what} has {len(values)} rows and its time {len(own)}; they must agree")
    own, values = own[given], values[given]
    if (np.diff(own) <= 0).any():
        twice = rows.twins(own, values)
        own, values = own[~twice], values[~twice]
        if twice.any():
            left_out.append(f"{what}: {twice.sum()} equal rows, alike in every column, are left out")
    if len(own) < 2 or not (np.diff(own) > 0).all():
        raise BoresightError(f"{at.path}: {what}.time: the tags do not increase; sort the rows, keep one of each")
    return own, values


def _near(own: Array, time: Array) -> Array:
    """(N,) whether neighbours of a column's own tags stand around: no more than two of its usual intervals apart."""
    k = np.clip(np.searchsorted(own, time), 1, len(own) - 1)
    inside = (time >= own[0]) & (time <= own[-1])
    near: Array = inside & (own[k] - own[k - 1] <= 2 * np.median(np.diff(own)))
    return near


def _master(
    described: "Description", at: _Source, slave: Array, since: int, notes: list[str], left_out: list[str],
    failed: dict[str, tuple[int, int]],
) -> Master:  # fmt: skip
    part = described.master
    assert part is not None
    to_ned = _framed(at, "master.navigation", frames.navigation_to_ned, part.navigation)
    to_frd = _framed(at, "master.body", frames.body_to_frd, part.body)
    q, absent = _attitude(at, part, to_ned, to_frd, left_out)
    time = _clock(at, "master", part, len(q), since, notes)
    if part.time is not None:
        time = rows.alike(time, slave, part.time, "master.time")
    lost = ~np.isfinite(q).all(axis=1) & ~absent  # `check`'s to report
    q[lost | absent] = [1.0, 0.0, 0.0, 0.0]
    velocity = None if part.velocity is None else at.column("master.velocity", part.velocity, "velocity", 3)
    position = None
    if part.position is not None:
        local = part.position.unit in UNITS["length"]
        position = at.column("master.position", part.position, "length" if local else "angle", 3)
        if local:
            order = part.position.order
            axes = _framed(at, "master.position", frames.columns_to_ned, order) if order else to_ned
            with np.errstate(invalid="ignore"):
                position = _geodetic(at, part.origin, position @ axes.T, notes)
        else:
            position = position[:, _place_order(at, part.position.order)]
            factor = at.factor("master.position", part.position.height_unit, "length")
            position[:, 2] *= factor / UNITS["angle"][part.position.unit]
    whole: Array = np.ones(len(time), dtype=bool)
    if part.attitude.time is None and len(absent) == len(time):
        whole &= ~absent
    moved = []
    for name, column in (("attitude", part.attitude), ("velocity", part.velocity), ("position", part.position)):
        if column is None or column.time is None:
            continue
        values = {"attitude": np.column_stack([q, lost]), "velocity": velocity, "position": position}[name]
        assert values is not None
        given = ~absent if name == "attitude" else slice(None)
        own, values = _tagged(at, f"master.{name}", column, part, since, values, given, left_out)
        whole &= _near(own, time)
        if name == "attitude":
            q, lost = _turned_between(own, values[:, :4], time), np.interp(time, own, values[:, 4]) > 0
        else:
            values = np.stack([np.interp(time, own, axis) for axis in values.T], axis=-1)
            velocity, position = (values, position) if name == "velocity" else (velocity, values)
        moved.append(name)
    if moved:
        notes.append(
            f"master.{' and '.join(moved)}: brought to the tags of master.time, {np.sum(~whole)} rows left out"
        )
    at.same_length("master", time, attitude=q, velocity=velocity, position=position)
    v_n = None
    if velocity is not None:
        assert part.velocity is not None
        with np.errstate(invalid="ignore"):
            body = part.velocity.axes == "body"
            axes = to_frd if body else to_ned
            if part.velocity.order:
                convert = frames.columns_to_frd if body else frames.columns_to_ned
                axes = _framed(at, "master.velocity", convert, part.velocity.order)
            v_n = velocity @ axes.T
            if body:
                v_n = np.einsum("kij,kj->ki", rotation.matrix_from_quaternion(q), v_n)
    if position is None and part.origin is not None:
        position = np.tile(_origin(at, part.origin), (len(time), 1))
        notes.append("master.position: taken as that of master.origin all the time")
    euler = rotation.euler_from_matrix(rotation.matrix_from_quaternion(q))
    euler[lost] = np.nan
    master = Master(time, euler, v_n, position)
    master = master if whole.all() else master.cut(whole)
    drop = described.bad_rows == "drop"
    nowhere: Array = np.zeros(len(master.time), bool)
    if master.position is not None and part.position is not None and part.position.unit not in UNITS["length"]:
        nowhere |= ~np.any(master.position[:, :2], axis=1)
    nowhere = _failed(nowhere if not np.all(nowhere) else ~nowhere, "master", drop, failed)
    values = np.hstack([values for values in (master.euler, master.v_n, master.position) if values is not None])
    keep = rows.kept(part, "master", drop, master.time, values, nowhere, left_out)
    return master if keep.all() else master.cut(keep)


def _place_order(at: _Source, order: str | None) -> list[int]:
    """Where latitude, longitude and height stand among three columns."""
    names = ["latitude", "longitude", "height"]
    given = (order or " ".join(names)).lower().replace("altitude", "height").split()
    if sorted(given) != sorted(names):
        raise BoresightError(f"{at.path}: master.position: the order {order!r} must hold {', '.join(names)} once each")
    return [given.index(name) for name in names]


def _attitude(
    at: _Source, part: "MasterPart", to_ned: Array, to_frd: Array, left_out: list[str]
) -> tuple[Array, Array]:
    """(N, 4) quaternions FRD to NED from what the file has, nan where it has none; where it says that there is none."""
    column = part.attitude
    if column.order in ("wxyz", "xyzw"):
        q = at.column("master.attitude", column, "quaternion", 4)
        absent = _absent(at, "master.attitude", column, len(q), left_out)
        zero = (q == 0).all(axis=1) & ~absent
        if zero.all():
            raise BoresightError(
                f"{at.path}: master.attitude: every quaternion is 0 0 0 0: no orientation is given; name another column"
            )
        if zero.any():
            left_out.append(f"master.attitude: {zero.sum()} quaternions are 0 0 0 0: no orientation is given there")
        absent |= zero
        q[absent] = np.nan
        if np.any(np.abs(np.linalg.norm(q, axis=1) - 1) > 0.01):
            raise BoresightError(f"{at.path}: master.attitude: the quaternions are not of length 1; check the columns")
        q = q if column.order == "wxyz" else np.roll(q, 1, axis=1)
        whole = np.isfinite(q).all(axis=1)
        q[whole] = rotation.quaternion_from_matrix(to_ned @ rotation.matrix_from_quaternion(q[whole]) @ to_frd.T)
        return q, absent
    # Angles are those of an aircraft in any axes, but somebody may have turned about the axes that are named.
    meant = f"{at.path}: master.attitude: three angles in {part.body} and {part.navigation}"
    if "B" in part.body:
        raise BoresightError(f"{meant}: they need a body frame with F, front; or name a quaternion")
    if column.pitch_positive is None and "L" in part.body:
        raise BoresightError(f'{meant}: say which pitch is positive: pitch_positive = "up" or "down", of the nose')
    if column.yaw_from is None and part.navigation[part.body.index("F")] != "N":
        raise BoresightError(f'{meant}: say where yaw is zero: yaw_from = "north" or "east"')
    angles = at.column("master.attitude", column, "angle", 3)
    try:
        euler = frames.euler_from_angles(
            angles, column.order.split(), column.yaw_positive, column.pitch_positive or "up", column.yaw_from or "north"
        )
    except BoresightError as error:
        raise BoresightError(f"{at.path}: master.attitude: {error}; or name a quaternion, wxyz or xyzw") from None
    return rotation.quaternion_from_euler(euler), np.zeros(len(euler), bool)


def _turned_between(own: Array, q: Array, time: Array) -> Array:
    """(N, 4) attitude at `time`, turning evenly between its own tags."""
    k = np.clip(np.searchsorted(own, time), 1, len(own) - 1)
    before, after = rotation.matrix_from_quaternion(q[k - 1]), rotation.matrix_from_quaternion(q[k])
    turn = rotation.vector_from_matrix(np.swapaxes(before, -1, -2) @ after)
    part = np.clip((time - own[k - 1]) / (own[k] - own[k - 1]), 0, 1)
    return rotation.turned(q[k - 1], turn * part[:, None])


def _origin(at: _Source, origin: Any) -> Array:
    """(3,) latitude, longitude (rad), height (m)."""
    out = []
    for name in ("latitude", "longitude", "height"):
        value = getattr(origin, name)
        if isinstance(value, str):
            value = at.number(f"master.origin.{name}", value)
        out.append(float(value))
    if abs(out[0]) > 90:
        raise BoresightError(f"{at.path}: master.origin.latitude is {out[0]:g} deg; it must be within +-90")
    return np.array([*np.radians(out[:2]), out[2]])


def _geodetic(at: _Source, origin: Any, ned: Array, notes: list[str]) -> Array:
    """(N, 3) latitude, longitude, height of metres north, east, down of an origin, on the ellipsoid."""
    if origin is None:
        raise BoresightError(
            f"{at.path}: master.position is in metres; say from where: [master] origin = {{ latitude = 47.4 }} (deg), "
            "and longitude, height (m) if they matter"
        )
    lat, lon, height = _origin(at, origin)
    far = np.nanmax(np.abs(ned[:, :2]), initial=0.0)
    if far > 50e3:
        raise BoresightError(
            f"{at.path}: master.position: {far / 1e3:.0f} km from its origin; local metres end at 50 km"
        )
    e2 = 0.00669437999014  # WGS 84
    root = np.sqrt(1 - e2 * np.sin(lat) ** 2)
    meridian, normal = 6378137 * (1 - e2) / root**3 + height, 6378137 / root + height
    notes.append(f"master.position: metres from {np.degrees(lat):.5f}, {np.degrees(lon):.5f} deg, {height:.1f} m")
    return np.column_stack([
        lat + ned[:, 0] / meridian, lon + ned[:, 1] / (normal * np.cos(lat)), height - ned[:, 2],
    ])  # fmt: skip


def _cut(path: Path, imu: Inertial, master: Master | None, low: float, high: float) -> tuple[Inertial, Master | None]:
    """Samples from `low` to `high`, s."""
    inside = (imu.time >= low) & (imu.time <= high)
    within = None if master is None else (master.time >= low) & (master.time <= high)
    fewest = min(int(part.sum()) for part in (inside, within) if part is not None)
    if fewest < 2:
        span = f"{imu.time[0]:.3f} s to {imu.time[-1]:.3f} s"
        raise BoresightError(f"{path}: from and to leave {fewest} samples; the recording goes from {span}")
    out = replace(imu, time=imu.time[inside], gyro=imu.gyro[inside], accel=imu.accel[inside])
    return out, None if master is None else master.cut(within)


def _fitted(where: str, time: Array) -> tuple[Array, str]:
    """The tags of a regular clock on their line."""
    from boresight.runtime.clock import regular  # not every recording needs SciPy's splines

    text = f"{where}: tags of a regular clock of {{:.6g}} Hz, put on its line; they scattered by {{:.3f}} ms"
    step = np.diff(time)
    if grain := tags.grain(time) or (float(step.max()) if (step == 0).any() else 0.0):
        number = np.arange(len(time))
        interval, begin = np.polyfit(number, time, 1)
        line = begin + interval * number
        if np.abs(time - line).max() <= grain:
            return line, text.format(1 / interval, np.std(time - line) * 1e3)
    fitted = regular(time)
    return fitted.time, text.format(1 / fitted.interval_s, fitted.jitter_s * 1e3)


def _calibrated(described: "Description", at: _Source, imu: Inertial, notes: list[str]) -> Inertial:
    """true = matrix @ ((delivered - bias) / (1 + scale)), in the body axes of the file."""
    assert described.calibration is not None
    to_frd = frames.body_to_frd(described.imu.body)
    done: list[str] = []
    known: dict[str, Array] = {}
    for sensor, kind in (("gyro", "angular rate"), ("accel", "acceleration")):
        matrix, bias = np.eye(3), np.zeros(3)
        for name, what, shape in (("matrix", "matrix", (3, 3)), ("scale", "scale factor", (3,)), ("bias", kind, (3,))):
            given = getattr(described.calibration, f"{sensor}_{name}")
            if given is None:
                continue
            value = at.known(f"calibration.{sensor}_{name}", given, what, shape)
            done.append(f"{sensor}_{name}")
            if name == "matrix":
                matrix = value
            elif name == "scale":
                if (value == -1).any():
                    raise BoresightError(
                        f"{at.path}: calibration.{sensor}_scale: a scale factor of -1 would make every sample zero"
                    )
                matrix = matrix @ np.diag(1 / (1 + value))
            else:
                bias = value
        known |= {f"{sensor}_bias": to_frd @ bias, f"{sensor}_matrix": to_frd @ matrix @ to_frd.T}
    start, end = imu.intervals()
    seconds = np.ones(len(start)) if imu.kind == "rates" else end - start
    gyro, accel = Calibration(**known).increments(imu.gyro, imu.accel, seconds)
    notes.append(f"imu: {', '.join(done)} taken off")
    return replace(imu, gyro=gyro, accel=accel)


def _reference(described: "Description", at: _Source) -> dict[str, Array]:
    to_frd = frames.body_to_frd(described.imu.body)
    kinds = {
        "gyro_bias": "angular rate", "accel_bias": "acceleration", "misalignment": "angle", "lever_arm": "length"
    }  # fmt: skip
    given = {name: getattr(described.reference, name) for name in kinds}
    return {
        name: to_frd @ at.known(f"reference.{name}", known, kinds[name])
        for name, known in given.items()
        if known is not None
    }


def _named_axes(described: "Description") -> dict[str, Array]:
    """The matrices of `Recording.axes`; those of a master without velocity in navigation axes are left out."""
    axes = {"imu": frames.body_to_frd(described.imu.body)}
    master = described.master
    if master and master.velocity and master.velocity.axes == "navigation":
        order = master.velocity.order
        axes["velocity"] = frames.columns_to_ned(order) if order else frames.navigation_to_ned(master.navigation)
    return axes


def _framed(at: _Source, what: str, convert: Any, frame: str) -> Array:
    try:
        matrix: Array = convert(frame)
        return matrix
    except BoresightError as error:
        raise BoresightError(f"{at.path}: {what}: {error}") from None
