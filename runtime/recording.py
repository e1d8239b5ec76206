"""Recordings: inertial data of a slave and, if there is one, the navigation of its master.

`read` turns a file and its TOML description into a `Recording` in NED/FRD, SI and radians; `check` says what is
suspicious about it.  What a description may say: docs/recordings.md.  Only NumPy is imported before a file is read.
"""

import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from boresight import BoresightError, need
from boresight.runtime import frames, rotation
from boresight.runtime.array import Array
from boresight.runtime.units import DEG, HOUR, UNITS
from boresight.runtime.units import STANDARD_GRAVITY as G

if TYPE_CHECKING:
    from boresight.runtime.description import Column, Description


@dataclass(frozen=True)
class Inertial:
    """A three-axis gyro and accelerometer, in FRD body axes.

    kind: "rates" (rad/s, m/s^2: the mean over each sample's interval) or "increments" (rad, m/s over it).
    time: (N,) s; time_marks says which instant of a sample's interval its tag is: "start", "middle" or "end".
    """

    kind: Literal["rates", "increments"]
    time_marks: Literal["start", "middle", "end"]
    time: Array
    gyro: Array  # (N, 3)
    accel: Array  # (N, 3)

    @cached_property
    def dt(self) -> float:
        """s, the usual interval between samples: the median."""
        return float(np.median(np.diff(self.time)))

    def intervals(self) -> tuple[Array, Array]:
        """(N,), (N,) s: start and end of each sample's interval.  After a gap a sample covers the usual dt."""
        dt, before = self.dt, np.diff(self.time)
        length = np.where(np.abs(before - dt) < 0.5 * dt, before, dt)
        if self.time_marks == "start":
            return self.time, self.time + np.append(length, dt)
        if self.time_marks == "middle":
            return self.time - np.insert(length, 0, dt) / 2, self.time + np.append(length, dt) / 2
        return self.time - np.insert(length, 0, dt), self.time

    @cached_property
    def increments(self) -> tuple[Array, Array, Array, Array]:
        """start (N,), end (N,) s, dtheta (N, 3) rad, dvel (N, 3) m/s, whatever the kind."""
        start, end = self.intervals()
        scale = (end - start)[:, None] if self.kind == "rates" else 1.0
        return start, end, self.gyro * scale, self.accel * scale

    def rates(self) -> tuple[Array, Array]:
        """gyro (N, 3) rad/s, specific force (N, 3) m/s^2, whatever the kind."""
        start, end = self.intervals()
        scale = 1.0 if self.kind == "rates" else 1 / (end - start)[:, None]
        return self.gyro * scale, self.accel * scale

    def between(self, t0: float, t1: float) -> tuple[Array, Array]:
        """dt (K,) s and dtheta (K, 3) rad of the pieces of samples that cover t0 to t1; a cut sample is shared by time.

        Raises BoresightError where more than half a sample of the time between is not covered.
        """
        start, end, dtheta, _ = self.increments
        first, last = np.searchsorted(end, t0, "right"), np.searchsorted(start, t1, "left")
        piece = np.minimum(end[first:last], t1) - np.maximum(start[first:last], t0)
        missing = (t1 - t0) - piece.sum()
        if abs(missing) > 0.5 * self.dt:
            raise BoresightError(
                f"the inertial data does not cover {t0:.4f} s to {t1:.4f} s ({missing:.4f} s are missing); "
                "cut the recording there"
            )
        keep = piece > 1e-6 * self.dt  # a time tag's own rounding leaves slivers
        share = piece / (end[first:last] - start[first:last])
        return piece[keep], (dtheta[first:last] * share[:, None])[keep]

    def __post_init__(self) -> None:
        for name in ("gyro", "accel"):
            shape, wanted = np.shape(getattr(self, name)), (len(self.time), 3)
            if shape != wanted:
                raise BoresightError(f"{name} has shape {shape}; with {wanted[0]} times it must be {wanted}")
        if len(self.time) < 2:
            raise BoresightError(f"the inertial data has {len(self.time)} samples; it needs at least 2")


@dataclass(frozen=True)
class Master:
    """The navigation of a master, in NED and FRD."""

    time: Array  # (M,) s, on the slave's clock
    euler: Array  # (M, 3) rad roll, pitch, yaw
    v_n: Array | None = None  # (M, 3) m/s north, east, down
    position: Array | None = None  # (M, 3) latitude rad, longitude rad, height m

    def cut(self, keep: Any) -> "Master":
        """Only the rows that KEEP selects: a slice, a mask or indices."""
        v_n, position = (None if part is None else part[keep] for part in (self.v_n, self.position))
        return Master(self.time[keep], self.euler[keep], v_n, position)


@dataclass(frozen=True)
class Recording:
    """One drive, flight or walk; made by `read`, or by hand from arrays that are NED/FRD, SI and radians already.

    reference: what is known from elsewhere, in FRD: "gyro_bias" rad/s, "accel_bias" m/s^2 (measured = true + bias),
    "misalignment" rad (mu, C_b2n = C_m2n exp([mu x])), "lever_arm" m (master to slave); each (3,).
    """

    name: str
    imu: Inertial
    master: Master | None = None
    reference: Mapping[str, Array] = field(default_factory=dict)
    title: str = ""


@dataclass(frozen=True)
class Finding:
    """One thing that `check` saw.  An "error" stops a replay; a "warning" may be meant so; a "note" is a number."""

    level: Literal["note", "warning", "error"]
    where: str
    text: str


# ---------------------------------------------------------------- reading


def find(path: str | Path) -> Path:
    """The file at PATH, or of that name under the folder BORESIGHT_DATA; raises BoresightError."""
    folder = os.environ.get("BORESIGHT_DATA")
    for candidate in (Path(path), *([Path(folder) / path] if folder else [])):
        if candidate.is_file():
            return candidate
    where = f"here or under {folder}" if folder else "here"
    raise BoresightError(f"{path}: no such file {where}; give its path, or set BORESIGHT_DATA to its folder")


def read(path: str | Path, *, strict: bool = True) -> Recording:
    """A recording from its TOML description, or from a data file that has one.

    A data file is described by the TOML of the same name beside it, or by a description that comes with Boresight and
    knows all its arrays.  strict: refuse what `check` calls an error.
    Raises BoresightError naming the file, the column and what to do.
    """
    need("replay")
    from boresight.runtime import description

    found = find(path)
    tables: dict[Path, dict[str, Array]] = {}
    if found.suffix == ".toml":
        said = description.load(found)
        default = _beside(found, said.file) if said.file else None
    elif found.with_suffix(".toml").is_file():
        said, default = description.load(found.with_suffix(".toml")), found
    else:
        tables[found] = _table(found, ",", True)
        said, default = _built_in(found, set(tables[found])), found

    def table(section: Any) -> tuple[Path, dict[str, Array]]:
        source = _beside(found, section.file) if section.file else default
        if source is None:
            raise BoresightError(f'{found}: no data file is named; add file = "NAME" at the top or in each section')
        if source not in tables:
            tables[source] = _table(source, said.delimiter, said.header)
        return source, tables[source]

    recording = Recording(
        name=found.stem,
        title=said.title,
        imu=_imu(said, *table(said.imu)),
        master=_master(said, *table(said.master)) if said.master else None,
        reference=_reference(said, *table(said.reference)) if said.reference else {},
    )
    if strict:
        wrong = [finding for finding in check(recording) if finding.level == "error"]
        if wrong:
            more = f" ({len(wrong) - 1} more: --check lists them)" if len(wrong) > 1 else ""
            raise BoresightError(f"{found}: {wrong[0].where}: {wrong[0].text}{more}")
    return recording


def _beside(description: Path, file: str) -> Path:
    """A file that a description names stands beside the description, or where `find` looks."""
    return description.parent / file if (description.parent / file).is_file() else find(file)


def _built_in(path: Path, keys: set[str]) -> "Description":
    from boresight.runtime import description

    for candidate in sorted((Path(__file__).parent / "recordings").glob("*.toml")):
        said = description.load(candidate)
        if keys and set(said.recognised_by) == keys:
            return said
    toml = path.with_suffix(".toml").name
    raise BoresightError(
        f"{path}: its columns are not described; write {toml} beside it, as 'boresight replay --template' shows"
    )


def _table(path: Path, delimiter: str, header: bool) -> dict[str, Array]:
    """All columns of a file by name: arrays of any shape from npz and mat, single columns from csv and parquet."""
    kind = path.suffix.lower()
    try:
        if kind == ".npz":
            with np.load(path, allow_pickle=False) as data:
                return dict(data)
        if kind == ".mat":
            from scipy.io import loadmat

            data = loadmat(path, squeeze_me=True)
            return {name: np.asarray(value) for name, value in data.items() if not name.startswith("__")}
        if kind in (".csv", ".txt", ".dat"):
            need("replay")
            import pandas

            first = 0 if header else None
            frame = pandas.read_csv(path, sep=delimiter, header=first, comment="#", skipinitialspace=True)
            return {str(name).strip(): frame[name].to_numpy() for name in frame.columns}
        if kind == ".parquet":
            need("parquet")
            import pandas

            frame = pandas.read_parquet(path).reset_index()
            return {str(name): frame[name].to_numpy() for name in frame.columns}
    except BoresightError:
        raise
    except NotImplementedError:
        raise BoresightError(f"{path}: a mat file of version 7.3; save it with -v7") from None
    except Exception as error:  # each reader fails in its own ways; the user needs one line
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise BoresightError(f"{path}: cannot be read as {kind[1:]}: {reason}") from None
    raise BoresightError(f"{path}: a {kind or 'nameless'} file is not read; use npz, mat, csv, txt, dat or parquet")


def _column(path: Path, table: dict[str, Array], what: str, column: "Column", quantity: str, width: int) -> Array:
    """One quantity in SI and radians: (N,) where width is 1, else (N, width)."""
    factor = _factor(path, what, column.unit, quantity)
    names = [column.columns] if isinstance(column.columns, str) else column.columns
    parts = []
    for name in names:
        # A column of a matrix may be named as "imu[0]": that is how mat files are usually laid out.
        base, _, index = name.partition("[") if name not in table else (name, "", "")
        if base not in table:
            raise BoresightError(f"{path}: {what}: there is no column {name!r}; it has {', '.join(table)}")
        values = table[base]
        if index:
            number = index.rstrip("]")
            if values.ndim != 2 or not number.isdecimal() or int(number) >= values.shape[1]:
                raise BoresightError(f"{path}: {what}: {name!r} does not exist: {base} has shape {values.shape}")
            values = values[:, int(number)]
        if not (np.issubdtype(values.dtype, np.number) and np.isrealobj(values)):
            raise BoresightError(f"{path}: {what}: column {name!r} is not numeric; remove the text from it")
        parts.append(values.astype(float))
    out = np.stack(parts, axis=-1) if len(parts) > 1 and len({p.shape for p in parts}) == 1 else parts[0]
    wanted = "one column" if width == 1 else f"{width} columns"
    if width == 1 and out.ndim == 2 and 1 in out.shape:
        out = out.ravel()
    if out.ndim != (1 if width == 1 else 2) or (width > 1 and out.shape[1] != width) or len(parts) not in (1, width):
        shapes = ", ".join(f"{name} {part.shape}" for name, part in zip(names, parts, strict=True))
        raise BoresightError(f"{path}: {what} needs {wanted} of one length; found {shapes}")
    return out * factor


def _factor(path: Path, what: str, unit: str, quantity: str) -> float:
    if unit not in UNITS[quantity]:
        known = ", ".join(UNITS[quantity])
        raise BoresightError(f"{path}: {what}: unit {unit!r} is not known for {quantity}; use one of {known}")
    return UNITS[quantity][unit]


def _same_length(path: Path, section: str, time: Array, **parts: Array | None) -> None:
    for name, part in parts.items():
        if part is not None and len(part) != len(time):
            text = f"{section}.{name} has {len(part)} rows and {section}.time {len(time)}"
            raise BoresightError(f"{path}: {text}; they must agree")
    if len(time) < 2:
        raise BoresightError(f"{path}: {section}.time has {len(time)} rows; at least 2 are needed")


def _imu(said: "Description", path: Path, table: dict[str, Array]) -> Inertial:
    part = said.imu
    quantities = ("angular rate", "acceleration") if part.kind == "rates" else ("angle", "velocity")
    to_frd = _framed(path, "imu.body", frames.body_to_frd, part.body)
    time = _column(path, table, "imu.time", part.time, "time", 1)
    gyro = _column(path, table, "imu.gyro", part.gyro, quantities[0], 3)
    accel = _column(path, table, "imu.accel", part.accel, quantities[1], 3)
    _same_length(path, "imu", time, gyro=gyro, accel=accel)
    with np.errstate(invalid="ignore"):  # an infinite value is `check`'s to report
        gyro, accel = gyro @ to_frd.T, accel @ to_frd.T
    return Inertial(part.kind, part.time_marks, time, gyro, accel)


def _master(said: "Description", path: Path, table: dict[str, Array]) -> Master:
    part = said.master
    assert part is not None
    to_ned = _framed(path, "master.navigation", frames.navigation_to_ned, part.navigation)
    to_frd = _framed(path, "master.body", frames.body_to_frd, part.body)
    time = _column(path, table, "master.time", part.time, "time", 1)
    if part.attitude.order in ("wxyz", "xyzw"):
        q = _column(path, table, "master.attitude", part.attitude, "quaternion", 4)
        if np.any(np.abs(np.linalg.norm(q, axis=1) - 1) > 0.01):
            raise BoresightError(f"{path}: master.attitude: the quaternions are not of length 1; check the columns")
        q = q if part.attitude.order == "wxyz" else np.roll(q, 1, axis=1)
        euler = rotation.euler_from_matrix(to_ned @ rotation.matrix_from_quaternion(q) @ to_frd.T)
    else:
        angles = _column(path, table, "master.attitude", part.attitude, "angle", 3)
        try:
            euler = frames.euler_from_angles(angles, part.attitude.order.split(), part.attitude.yaw_positive)
        except BoresightError as error:
            raise BoresightError(f"{path}: master.attitude: {error}; or name a quaternion, wxyz or xyzw") from None
    v_n = position = None
    if part.velocity:
        with np.errstate(invalid="ignore"):
            v_n = _column(path, table, "master.velocity", part.velocity, "velocity", 3) @ to_ned.T
    if part.position:
        position = _column(path, table, "master.position", part.position, "angle", 3)
        height_factor = _factor(path, "master.position", part.position.height_unit, "length")
        position[:, 2] *= height_factor / UNITS["angle"][part.position.unit]
    _same_length(path, "master", time, attitude=euler, velocity=v_n, position=position)
    return Master(time, euler, v_n, position)


def _reference(said: "Description", path: Path, table: dict[str, Array]) -> dict[str, Array]:
    to_frd = frames.body_to_frd(said.imu.body)
    quantities = {
        "gyro_bias": "angular rate", "accel_bias": "acceleration", "misalignment": "angle", "lever_arm": "length"
    }  # fmt: skip
    out = {}
    for name, quantity in quantities.items():
        column = getattr(said.reference, name)
        if column:
            factor = _factor(path, f"reference.{name}", column.unit, quantity)
            values = table.get(column.columns) if isinstance(column.columns, str) else None
            if values is None or values.shape != (3,):
                found = "no such array" if values is None else f"shape {values.shape}"
                text = f"reference.{name} needs one array of 3 numbers; {column.columns!r}: {found}"
                raise BoresightError(f"{path}: {text}")
            out[name] = to_frd @ values.astype(float) * factor
    return out


def _framed(path: Path, what: str, convert: Any, frame: str) -> Array:
    try:
        matrix: Array = convert(frame)
        return matrix
    except BoresightError as error:
        raise BoresightError(f"{path}: {what}: {error}") from None


# ---------------------------------------------------------------- checking


def check(recording: Recording) -> list[Finding]:
    """What is wrong or suspicious in a recording, worst first; always some notes (rates, norms, biases at rest).

    Nothing here changes or repairs the data.  An empty list of "error" findings means that a replay may begin.
    """
    out = _check_time("imu", recording.imu.time, gap_level="error")
    out += _check_finite("imu", gyro=recording.imu.gyro, accel=recording.imu.accel)
    master = recording.master
    if master:
        out += _check_time("master", master.time, gap_level="warning")
        out += _check_finite("master", attitude=master.euler, velocity=master.v_n, position=master.position)
    for name, value in recording.reference.items():
        out += _check_finite("reference", **{name: value[None]})
    # What follows computes with the numbers, so it needs sorted times and finite values; gaps it can live with.
    parts = [recording.imu.time, recording.imu.gyro, recording.imu.accel]
    parts += [part for part in vars(master).values() if part is not None] if master else []
    times = [recording.imu.time] + ([master.time] if master else [])
    if all(np.isfinite(part).all() for part in parts) and all((np.diff(time) > 0).all() for time in times):
        out += _check_imu(recording.imu)
        if master:
            out += _check_master(master)
            out += _check_pair(recording.imu, master)
    return sorted(out, key=lambda finding: ("error", "warning", "note").index(finding.level))


def _listed(times: Array) -> str:
    shown = ", ".join(f"{t:.4f}" for t in times[:3])
    return f"{shown} s" + (f" and {len(times) - 3} more" if len(times) > 3 else "")


def _check_time(where: str, time: Array, gap_level: Literal["warning", "error"]) -> list[Finding]:
    where = f"{where}.time"
    if not np.isfinite(time).all():
        rows = np.flatnonzero(~np.isfinite(time))
        text = f"{len(rows)} tags are missing or not finite, first in row {rows[0]}; remove those rows"
        return [Finding("error", where, text)]
    step = np.diff(time)
    out = []
    for bad, what in ((step < 0, "go backwards after"), (step == 0, "are repeated at")):
        if bad.any():
            text = f"{bad.sum()} tags {what} {_listed(time[:-1][bad])}; sort the rows and keep one for each instant"
            out.append(Finding("error", where, text))
    dt = float(np.median(step))
    if dt <= 0:
        return out
    gap = step > 1.5 * dt
    if gap.any():
        advice = "; cut the recording there" if gap_level == "error" else ""
        text = f"{gap.sum()} gaps after {_listed(time[:-1][gap])}, the longest {step.max():.4f} s{advice}"
        out.append(Finding(gap_level, where, text))
    jitter = float(np.std(step[(step > 0) & ~gap]))
    text = f"{1 / dt:.6g} Hz, {time[0]:.3f} s to {time[-1]:.3f} s, jitter {jitter * 1e3:.3f} ms"
    out.append(Finding("note", where, text))
    if not 0.1 <= 1 / dt <= 20000:
        out.append(Finding("error", where, f"a rate of {1 / dt:.4g} Hz: is the unit of time right?"))
    return out


def _check_finite(where: str, **parts: Array | None) -> list[Finding]:
    out = []
    for name, part in parts.items():
        if part is not None and not np.isfinite(part).all():
            rows = np.flatnonzero(~np.isfinite(part).all(axis=1))
            text = f"{len(rows)} rows are not finite, first row {rows[0]}; remove or fill them"
            out.append(Finding("error", f"{where}.{name}", text))
    return out


def _windows(values: Array, length: int) -> Array:
    """(K, length, 3): VALUES cut into whole windows, or one window of all."""
    length = min(length, len(values))
    count = len(values) // length
    return values[: count * length].reshape(count, length, -1)


def _check_imu(imu: Inertial) -> list[Finding]:
    gyro, f = imu.rates()
    out = []
    second = max(1, round(1 / imu.dt))
    norm = float(np.linalg.norm(np.median(_windows(f, second).mean(axis=1), axis=0)))
    rate_hz = 1 / imu.dt
    if not 0.8 * G < norm < 1.2 * G:
        guesses = {
            "g declared as m/s^2": norm * G,
            "m/s^2 declared as g": norm / G,
            "rates declared as increments": norm / rate_hz,
            "increments declared as rates": norm * rate_hz,
        }
        fits = [guess for guess, value in guesses.items() if 0.9 * G < value < 1.1 * G]
        text = f"the mean specific force is {norm:.4g} m/s^2, not about {G:.2f}"
        out.append(Finding("error", "imu.accel", f"{text}: {fits[0] if fits else 'check its unit and kind'}"))
    down = float(np.mean(f[:, 2]))
    if 0.8 * G < norm < 1.2 * G and down > 0.5 * G:
        text = f"the mean specific force along body down is {down:+.3f} m/s^2; at rest it is -{G:.2f}"
        out.append(Finding("error", "imu.accel", text + ": check imu.body or the sign"))
    fastest = float(np.abs(gyro).max())
    typical = float(np.median(np.linalg.norm(gyro, axis=1)))
    if fastest > 70 or typical > 5:
        text = f"turns at {typical:.3g} rad/s (median), {fastest:.3g} (largest)"
        out.append(Finding("error", "imu.gyro", text + ": degrees declared as radians, or rates as increments?"))
    mean_f = ", ".join(f"{x:+.3f}" for x in f.mean(axis=0))
    out.append(Finding("note", "imu.accel", f"mean specific force [{mean_f}] m/s^2 (front, right, down)"))
    turn = ", ".join(f"{x:.3f}" for x in np.degrees(np.sqrt(np.mean(gyro**2, axis=0))))
    out.append(Finding("note", "imu.gyro", f"rms rate [{turn}] deg/s (front, right, down)"))
    return out + _check_rest(gyro, f, second)


REST_GYRO = 0.5 * DEG  # rad/s, standard deviation in one second below which an IMU may be at rest
REST_ACCEL = 0.15  # m/s^2, the same


def _check_rest(gyro: Array, f: Array, second: int) -> list[Finding]:
    windows_gyro, windows_f = _windows(gyro, second), _windows(f, second)
    rest = (windows_gyro.std(axis=1) < REST_GYRO).all(axis=1) & (windows_f.std(axis=1) < REST_ACCEL).all(axis=1)
    if not rest.any():
        return [Finding("note", "imu", "never at rest: no norm of gravity and no static gyro bias to be had")]
    bias = windows_gyro[rest].mean(axis=(0, 1))
    norm = float(np.linalg.norm(windows_f[rest].mean(axis=1), axis=-1).mean())
    shown = ", ".join(f"{x:+.1f}" for x in np.degrees(bias) * HOUR)
    text = f"quiet for {rest.sum()} s: specific force {norm:.4f} m/s^2, mean rate [{shown}] deg/h"
    out = [Finding("note", "imu", text + " (static bias and Earth rate)")]
    if np.abs(bias).max() > 1 * DEG:
        text = "more than 1 deg/s while quiet: a large bias, a steady turn, or a wrong unit"
        out.append(Finding("warning", "imu.gyro", text))
    return out


def _check_master(master: Master) -> list[Finding]:
    out = []
    largest = np.abs(master.euler[:, :2]).max(axis=0)
    if largest[0] > 2 * np.pi or largest[1] > np.pi / 2 + 1e-6:
        text = f"roll to {largest[0]:.3g} and pitch to {largest[1]:.3g} rad"
        out.append(Finding("error", "master.attitude", text + ": degrees declared as radians, or another order?"))
    elif largest[1] > 80 * DEG:
        text = f"pitch to {np.degrees(largest[1]):.1f} deg: Euler angles are singular at 90, filters refuse 80; cut it"
        out.append(Finding("error", "master.attitude", text))
    turn = np.degrees(np.linalg.norm(rotation.vector_from_matrix(_steps(master.euler)), axis=1))
    jump = turn > 30
    if jump.any():
        text = f"{jump.sum()} steps of more than 30 deg after {_listed(master.time[:-1][jump])}"
        out.append(Finding("warning", "master.attitude", text + ": too slow a rate, or a wrong unit?"))
    spans = ", ".join(
        f"{name} {lo:.2f} to {hi:.2f}"
        for name, lo, hi in zip(
            frames.ANGLES, *np.degrees([master.euler.min(axis=0), master.euler.max(axis=0)]), strict=True
        )
    )
    out.append(Finding("note", "master.attitude", f"{spans} deg"))
    if master.v_n is not None:
        speed = np.linalg.norm(master.v_n, axis=1)
        out.append(Finding("note", "master.velocity", f"speed {speed.min():.2f} to {speed.max():.2f} m/s"))
    if master.position is not None:
        latitude = np.abs(master.position[:, 0]).max()
        if latitude > np.pi / 2:
            text = f"latitude to {latitude:.4g} rad: degrees declared as radians, or another order of columns?"
            out.append(Finding("error", "master.position", text))
        elif master.v_n is not None:
            out += _check_velocity(master)
    return out


def _check_velocity(master: Master) -> list[Finding]:
    """Displacement from position against the integral of velocity: tells a swapped or badly scaled axis."""
    assert master.v_n is not None and master.position is not None
    lat, lon, height = master.position.T
    radius = 6371e3 + height[0]
    moved = np.array([lat[-1] - lat[0], (lon[-1] - lon[0]) * np.cos(lat[0]), 0]) * radius
    moved[2] = height[0] - height[-1]
    summed = np.sum((master.v_n[1:] + master.v_n[:-1]) / 2 * np.diff(master.time)[:, None], axis=0)
    path = float(np.linalg.norm(moved))
    if path < 20:
        return []
    # A sphere in place of the ellipsoid is wrong by half a percent; 10 % is a wrong unit or a swapped axis.
    if float(np.linalg.norm(moved - summed)) > 0.1 * path:
        shown = ["[{:.0f}, {:.0f}, {:.0f}]".format(*v) for v in (moved, summed)]
        text = f"position moved {shown[0]} m (north, east, down), velocity sums to {shown[1]}"
        return [Finding("error", "master.velocity", text + ": check navigation, the order of columns and the units")]
    return []


def _steps(euler: Array) -> Array:
    """(M-1, 3, 3) the turn from each attitude to the next, in the body axes of the first."""
    C = rotation.matrix_from_euler(euler)
    return np.swapaxes(C[:-1], -1, -2) @ C[1:]


def attitude_increments(imu: Inertial, master: Master) -> tuple[Array, Array, Array]:
    """The slave's turns and the master's over the same intervals, for as long as both run.

    Returns dt (K,) s, slave (K, 3) rad (gyro, so relative to inertial space) and master (K, 3) rad (relative to the
    Earth; 15 deg/h do not matter here), rotation vectors in FRD.  Intervals that the slave does not cover are left out.
    """
    dts, slave, keep = [], [], []
    for k, (t0, t1) in enumerate(zip(master.time[:-1], master.time[1:], strict=True)):
        try:
            _, dtheta = imu.between(t0, t1)
        except BoresightError:
            continue
        C = np.eye(3)
        for piece in rotation.matrix_from_vector(dtheta):
            C = C @ piece
        dts.append(t1 - t0)
        slave.append(rotation.vector_from_matrix(C))
        keep.append(k)
    turns = rotation.vector_from_matrix(_steps(master.euler))
    return np.array(dts), np.array(slave).reshape(-1, 3), turns[keep]


def _check_pair(imu: Inertial, master: Master) -> list[Finding]:
    """The slave's turns against the master's, axis by axis: the test that sees every wrong sign, unit and axis."""
    start, end = imu.intervals()
    common = min(end[-1], master.time[-1]) - max(start[0], master.time[0])
    if common <= 0:
        spans = f"{master.time[0]:.3f} to {master.time[-1]:.3f} s, imu {start[0]:.3f} to {end[-1]:.3f} s"
        return [Finding("error", "master.time", f"master {spans}: no overlap; bring both to one clock")]
    out = [] if master.v_n is None else _check_gravity(imu, master)
    _, slave, turn = attitude_increments(imu, master)
    if len(turn) < 10:
        return out
    slave, turn = slave - slave.mean(axis=0), turn - turn.mean(axis=0)
    for axis, name in enumerate(("front", "right", "down")):
        power = float(turn[:, axis] @ turn[:, axis])
        # 0.02 deg between samples: less motion than this is noise, and its slope says nothing.
        if power < len(turn) * (0.02 * DEG) ** 2:
            continue
        slope = float(slave[:, axis] @ turn[:, axis]) / power
        correlation = slope * np.sqrt(power / max(float(slave[:, axis] @ slave[:, axis]), 1e-300))
        text = f"turns about {name}: slave over master {slope:.4g}, correlation {correlation:.4f}"
        wrong = not 0.8 < slope < 1.25 or correlation < 0.8
        hint = "; check unit, kind, body axes and the sign of yaw" if wrong else ""
        out.append(Finding("error" if wrong else "note", "imu.gyro", text + hint))
    return out


def gravity_in_ned(imu: Inertial, master: Master) -> Array:
    """(3,) m/s^2: the slave's specific force in the master's NED, averaged, less the master's mean acceleration.

    It is [0, 0, -g] but for accelerometer bias, Coriolis acceleration and misalignment, whatever the vehicle does.
    """
    assert master.v_n is not None
    start, end, _, dvel = imu.increments
    inside = (start >= master.time[0]) & (end <= master.time[-1])
    middle = ((start + end) / 2)[inside]
    C = rotation.matrix_from_euler(
        np.stack([np.interp(middle, master.time, a) for a in np.unwrap(master.euler, axis=0).T], axis=-1)
    )
    span = (end - start)[inside].sum()
    v = [np.array([np.interp(t, master.time, c) for c in master.v_n.T]) for t in (start[inside][0], end[inside][-1])]
    force: Array = np.einsum("kij,kj->i", C, dvel[inside]) / span - (v[1] - v[0]) / (end[inside][-1] - start[inside][0])
    return force


def _check_gravity(imu: Inertial, master: Master) -> list[Finding]:
    force = gravity_in_ned(imu, master)
    wrong = np.linalg.norm(force - [0, 0, -G]) > 0.05 * G
    text = "specific force less acceleration [{:+.3f}, {:+.3f}, {:+.3f}] m/s^2 (north, east, down)".format(*force)
    hint = f", not about [0, 0, -{G:.2f}]: check axes, signs and units of accel, attitude and velocity" if wrong else ""
    return [Finding("error" if wrong else "note", "imu.accel", text + hint)]


def best_delay(imu: Inertial, master: Master, span: float = 0.1, step: float = 0.0025) -> tuple[float, float]:
    """s, how old the master's data seems (within +-span), and how many times smaller the misfit is than at zero.

    The slave's turns are regressed on the master's (all three axes and a bias, so misalignment and scale do not matter)
    for each trial delay; the misfit's minimum is refined by a parabola.  A look at the data, without uncertainty.
    """
    start, end, dtheta, _ = imu.increments
    edges, angle = np.append(start[:1], end), np.vstack([np.zeros(3), np.cumsum(dtheta, axis=0)])
    inside = (master.time - span >= edges[0]) & (master.time + span <= edges[-1])
    time = master.time[inside]
    turn = rotation.vector_from_matrix(_steps(master.euler[inside]))
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


def shifted(recording: Recording, delay: float) -> Recording:
    """The recording with its master's data taken as DELAY seconds old: each tag moved back by it."""
    if recording.master is None or delay == 0:
        return recording
    return replace(recording, master=replace(recording.master, time=recording.master.time - delay))


def thinned(master: Master, rate_hz: float | None) -> Master:
    """Every n-th sample of the master, so that it comes at rate_hz or just above."""
    if rate_hz is None:
        return master
    if not rate_hz > 0:
        raise BoresightError(f"the master's rate is {rate_hz} Hz; it must be above zero")
    usual = float(np.median(np.diff(master.time)))
    return master.cut(slice(None, None, max(1, int(1 / (rate_hz * usual) + 1e-9))))
