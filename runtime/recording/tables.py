"""Files as tables: name -> array, whatever the format.  One small reader for each; the libraries come with extras.

Logs of many topics name a column "TOPIC/field": "sensor_combined/gyro_rad", "IMU/GyrX", "/imu/data/angular_velocity".
"""

import codecs
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np

from boresight.errors import BoresightError, did_you_mean, need
from boresight.runtime.array import Array

Table = dict[str, Array]
LARGE = 4096  # bytes of a message in a bag; beyond it are pictures, clouds and maps


def table(path: Path, *, delimiter: str = ",", decimal: str = ".", header: bool = True) -> Table:
    """All columns of a file by name; delimiter, decimal and header: of csv, txt and dat.  Raises BoresightError."""
    kind = kind_of(path)
    if kind not in READERS:
        known = ", ".join(READERS)
        raise BoresightError(
            f"{path}: a {kind or 'nameless'} file is not read{did_you_mean(kind, READERS)}; use {known}"
        )
    extra, reader = READERS[kind]
    if extra is not None:
        need(extra)
    try:
        if reader is _text:
            return _text(path, delimiter, decimal, header)
        return reader(path)
    except BoresightError:
        raise
    except UnicodeDecodeError:
        raise BoresightError(
            f"{path}: cannot be read as {kind[1:]}: it is not text in UTF-8; save it as UTF-8"
        ) from None
    except Exception as error:  # each library fails in its own ways; the user needs one line
        reason = str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__
        raise BoresightError(f"{path}: cannot be read as {kind[1:]}: {reason}") from None


def kind_of(path: Path) -> str:
    """The ending; a folder is a bag."""
    return ".db3" if path.is_dir() else path.suffix.lower()


# ---------------------------------------------------------------- arrays


def _npz(path: Path) -> Table:
    with np.load(path, allow_pickle=False) as data:
        return dict(data)


def _mat(path: Path) -> Table:
    with path.open("rb") as file:
        # A header of text stands before the HDF5 signature; so it does where a file is nothing else but HDF5.
        if b"MATLAB 7.3" in file.read(128) or _is_hdf5(path):
            need("hdf5")
            return {name: value.T for name, value in _hdf5(path).items()}  # Fortran order
    from scipy.io import loadmat

    out: Table = {}
    for name, value in loadmat(path, squeeze_me=True).items():
        if not name.startswith("__"):
            _unpack(out, name, np.asarray(value))
    return out


def _is_hdf5(path: Path) -> bool:
    signature = b"\x89HDF\r\n\x1a\n"
    with path.open("rb") as file:
        start = file.read(520)
    return start[:8] == signature or start[512:520] == signature


def _unpack(out: Table, name: str, value: Array) -> None:
    """A struct's fields as NAME/field, nested as it may be."""
    if value.dtype.names and value.ndim == 0:
        for field in value.dtype.names:
            _unpack(out, f"{name}/{field}", np.asarray(value[field].item()))
    elif value.dtype.names:
        for field in value.dtype.names:
            out[f"{name}/{field}"] = np.asarray(value[field].tolist())
    else:
        out[name] = value


def _hdf5(path: Path) -> Table:
    import h5py

    out: Table = {}

    def visit(name: str, node: Any) -> None:
        if isinstance(node, h5py.Dataset) and node.shape is not None and not name.startswith("#"):
            strings = h5py.check_string_dtype(node.dtype) is not None
            if strings or node.dtype.kind in "biufSUV":
                _unpack(out, name, np.asarray(node.asstr()[...] if strings else node[...]))

    with h5py.File(path, "r") as file:
        file.visititems(visit)
    return {name: np.squeeze(value) if value.ndim > 1 else value for name, value in out.items()}


# ---------------------------------------------------------------- columns


def _text(path: Path, delimiter: str, decimal: str, header: bool) -> Table:
    import pandas

    with path.open("rb") as file:
        marked = file.read(2) in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
    words = {"tab": "\t", "whitespace": r"\s+"}
    frame = pandas.read_csv(
        path, sep=words.get(delimiter, delimiter), decimal=decimal, header=0 if header else None, comment="#",
        skipinitialspace=True, encoding="utf-16" if marked else "utf-8-sig",
    )  # fmt: skip
    if not isinstance(frame.index, pandas.RangeIndex):  # pandas would take the first cells for names of the rows
        raise BoresightError(f"{path}: a row has more cells than its header has names; name every column")
    return _columns(frame)


def _columns(frame: Any) -> Table:
    return {str(name).strip(): frame[name].to_numpy() for name in frame.columns}


def _parquet(path: Path) -> Table:
    import pandas

    return _columns(pandas.read_parquet(path).reset_index())


def _excel(path: Path) -> Table:
    """Columns of the first sheet by their names, and of each sheet as SHEET/column."""
    import pandas

    out: Table = {}
    for number, (sheet, frame) in enumerate(pandas.read_excel(path, sheet_name=None).items()):
        columns = _columns(frame)
        out |= {f"{sheet}/{name}": value for name, value in columns.items()} | (columns if number == 0 else {})
    return out


# ---------------------------------------------------------------- logs of many topics


def _gathered(columns: Iterable[tuple[str, Array]]) -> Table:
    """With "q[0]", "q[1]", ... there is also "q", (N, width)."""
    out = dict(columns)
    widths: dict[str, int] = {}
    for name in out:
        base, _, index = name.partition("[")
        if index:
            widths[base] = widths.get(base, 0) + 1
    for base, width in widths.items():
        parts = [f"{base}[{i}]" for i in range(width)]
        if all(part in out for part in parts):
            out[base] = np.stack([out[part] for part in parts], axis=-1)
    return out


def _ulog(path: Path) -> Table:
    """Topics of a PX4 log; a second instance of a topic is TOPIC_1."""
    from pyulog import ULog

    try:
        log = ULog(str(path))
    except TypeError as error:  # how it fails at a file that is none
        raise BoresightError(f"{path}: cannot be read as ulg: {error}") from None
    return _gathered(
        (f"{topic.name}_{topic.multi_id}/{name}" if topic.multi_id else f"{topic.name}/{name}", np.asarray(values))
        for topic in log.data_list
        for name, values in topic.data.items()
    )


def _dataflash(path: Path) -> Table:
    """Messages of an ArduPilot log; a second instance of a message is NAME_1."""
    from pymavlink import DFReader

    rows: dict[tuple[str, Any], list[Any]] = {}
    log = DFReader.DFReader_binary(str(path))
    while (message := log.recv_msg()) is not None:
        instance = message.fmt.instance_field
        rows.setdefault((message.get_type(), instance and message.__getattr__(instance)), []).append(message)
    out: Table = {}
    for (name, instance), messages in rows.items():
        topic = f"{name}_{instance}" if instance else name
        for field in messages[0].get_fieldnames():
            values = [getattr(message, field) for message in messages]
            if all(isinstance(value, int | float) for value in values):
                out[f"{topic}/{field}"] = np.array(values)
    if not out:
        raise BoresightError(f"{path}: no messages of ArduPilot are in it")
    return out


def _bag(path: Path) -> Table:
    """Topics of a ROS 1 or ROS 2 bag, times as whole nanoseconds; beside "/imu/data/..." a topic that is the only one
    of its type is found by that as well: "sensor_msgs/Imu/..."."""
    from rosbags.highlevel import AnyReader
    from rosbags.typesys import Stores, get_typestore

    # A folder holds a ROS 2 bag with its metadata; so does the folder around a file of one.
    whole = path.parent if path.suffix != ".bag" and (path.parent / "metadata.yaml").is_file() else path
    rows: dict[tuple[str, str], list[dict[str, Any]]] = {}
    with AnyReader([whole], default_typestore=get_typestore(Stores.LATEST)) as bag:
        for connection, received, raw in bag.messages():
            if len(raw) <= LARGE:
                message = bag.deserialize(raw, connection.msgtype)
                fields = {"received": received} | dict(_fields(message))
                rows.setdefault((connection.topic, connection.msgtype.replace("/msg/", "/")), []).append(fields)
    out: Table = {}
    kinds = [kind for _, kind in rows]
    for (topic, kind), messages in rows.items():
        for field, first in messages[0].items():
            values: list[Any] = [message.get(field) for message in messages]
            if all(value is not None and np.shape(value) == np.shape(first) for value in values):
                out[f"{topic}/{field}"] = np.array(values)
                if kinds.count(kind) == 1:
                    out[f"{kind}/{field}"] = out[f"{topic}/{field}"]
    return out


def _fields(message: Any, prefix: str = "") -> Iterable[tuple[str, Any]]:
    """Numbers of a message by path; a stamp is whole nanoseconds, x, y, z (and w) are one array."""
    parts = {name: value for name, value in vars(message).items() if not name.startswith("_")}
    names = tuple(parts)
    if names in (("sec", "nanosec"), ("secs", "nsecs")):
        seconds, rest = parts.values()
        yield prefix, int(seconds) * 10**9 + int(rest)
    elif names in (("x", "y", "z"), ("x", "y", "z", "w")):
        yield prefix, np.array([float(value) for value in parts.values()])
    else:
        for name, value in parts.items():
            path = f"{prefix}.{name}" if prefix else name
            if isinstance(value, bool | int | float | np.number) or (
                isinstance(value, np.ndarray) and value.dtype.kind in "biuf"
            ):
                yield path, value
            elif hasattr(value, "__dataclass_fields__"):
                yield from _fields(value, path)


READERS: dict[str, tuple[str | None, Callable[..., Table]]] = {
    ".csv": ("replay", _text), ".txt": ("replay", _text), ".dat": ("replay", _text), ".npz": (None, _npz),
    ".mat": (None, _mat), ".h5": ("hdf5", _hdf5), ".hdf5": ("hdf5", _hdf5), ".parquet": ("parquet", _parquet),
    ".xlsx": ("excel", _excel), ".ulg": ("ulog", _ulog), ".bin": ("ardupilot", _dataflash), ".bag": ("ros", _bag),
    ".mcap": ("ros", _bag), ".db3": ("ros", _bag),
}  # fmt: skip
