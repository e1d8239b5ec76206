"""From a file and its TOML description to a `Recording` in NED/FRD, SI and radians.

What a description may say: docs/recordings.md.  Only NumPy is imported before a file is read.
"""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from boresight import BoresightError, need
from boresight.runtime import frames, rotation
from boresight.runtime.array import Array
from boresight.runtime.recording.check import check
from boresight.runtime.recording.types import Inertial, Master, Recording
from boresight.runtime.units import UNITS

if TYPE_CHECKING:
    from boresight.runtime.recording.description import Column, Description


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
    from boresight.runtime.recording import description

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
    from boresight.runtime.recording import description

    for candidate in sorted((Path(__file__).parent / "built_in").glob("*.toml")):
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
