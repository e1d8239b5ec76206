"""Files as tables: name -> array, whatever the format.  One small reader for each; the libraries come with extras.

Logs of many topics name a column "TOPIC/field": "sensor_combined/gyro_rad", "IMU/GyrX", "/imu/data/angular_velocity".
"""

import codecs
import io
import json
import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

import numpy as np

from boresight.errors import BoresightError, did_you_mean, need
from boresight.runtime.array import Array

LARGE = 4096  # bytes of a message in a bag; beyond it are pictures, clouds and maps
DELIMITERS = {"tab": "\t", "whitespace": r"\s+"}
LINES = 60  # of a text, among which its header ends


class Table(dict[str, Array]):
    """Columns by name; left_out: what of the file is in none of them, one line a kind, with its count."""

    def __init__(self, columns: Iterable[tuple[str, Array]] = (), left_out: Iterable[str] = ()):
        super().__init__(columns)
        self.left_out = list(left_out)


def table(
    path: Path, delimiter: str = ",", decimal: str = ".", header: bool | int = True, *, bad_rows: str = "refuse"
) -> Table:
    """All columns of a file by name; delimiter, decimal, header, bad_rows: of csv, txt, dat.  Raises BoresightError."""
    kind = kind_of(path)
    if kind not in READERS:
        known = ", ".join(READERS)
        raise BoresightError(
            f"{path}: a {kind or 'nameless'} file cannot be read{did_you_mean(kind, READERS)}; use {known}"
        )
    extra, reader = READERS[kind]
    if extra is not None:
        need(extra)
    try:
        if reader is _text:
            return _text(path, delimiter, decimal, header, bad_rows == "drop")
        found = reader(path)
        return found if isinstance(found, Table) else Table(found.items())
    except BoresightError:
        raise
    except UnicodeDecodeError:
        raise BoresightError(
            f"{path}: cannot be read as {kind[1:]}: it is not text in UTF-8; save it as UTF-8"
        ) from None
    except Exception as error:  # each library fails in its own ways; the user needs one line
        reason = str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__
        if reader is _text:
            broken = 'a row with another number of cells? bad_rows = "drop" leaves it out'
            reason += f"; {layout(path, delimiter, decimal, header) or broken}"
        raise BoresightError(f"{path}: cannot be read as {kind[1:]}: {reason}") from None


def kind_of(path: Path) -> str:
    """The ending; a folder is a bag."""
    return ".db3" if path.is_dir() else path.suffix.lower()


# ---------------------------------------------------------------- arrays


def _npz(path: Path) -> dict[str, Array]:
    with np.load(path, allow_pickle=False) as data:
        return dict(data)


def _mat(path: Path) -> dict[str, Array]:
    with path.open("rb") as file:
        # A header of text stands before the HDF5 signature; so it does where a file is nothing else but HDF5.
        if b"MATLAB 7.3" in file.read(128) or _is_hdf5(path):
            need("hdf5")
            return {name: value.T for name, value in _hdf5(path).items()}  # Fortran order
    from scipy.io import loadmat

    out: dict[str, Array] = {}
    for name, value in loadmat(path, squeeze_me=True).items():
        if not name.startswith("__"):
            _unpack(out, name, np.asarray(value))
    return out


def _is_hdf5(path: Path) -> bool:
    signature = b"\x89HDF\r\n\x1a\n"
    with path.open("rb") as file:
        start = file.read(520)
    return start[:8] == signature or start[512:520] == signature


def _unpack(out: dict[str, Array], name: str, value: Array) -> None:
    """A struct's fields as NAME/field, nested as it may be."""
    if value.dtype.names and value.ndim == 0:
        for field in value.dtype.names:
            _unpack(out, f"{name}/{field}", np.asarray(value[field].item()))
    elif value.dtype.names:
        for field in value.dtype.names:
            out[f"{name}/{field}"] = np.asarray(value[field].tolist())
    else:
        out[name] = value


def _hdf5(path: Path) -> dict[str, Array]:
    import h5py

    out: dict[str, Array] = {}

    def visit(name: str, node: Any) -> None:
        if isinstance(node, h5py.Dataset) and node.shape is not None and not name.startswith("#"):
            strings = h5py.check_string_dtype(node.dtype) is not None
            if strings or node.dtype.kind in "biufSUV":
                _unpack(out, name, np.asarray(node.asstr()[...] if strings else node[...]))

    with h5py.File(path, "r") as file:
        file.visititems(visit)
    return {name: np.squeeze(value) if value.ndim > 1 else value for name, value in out.items()}


# ---------------------------------------------------------------- columns


def _text(path: Path, delimiter: str, decimal: str, header: bool | int, drop: bool) -> Table:
    import pandas

    names, skip = None, 0
    if not isinstance(header, bool):
        names, skip = _names(path, delimiter, header), header
    settings: dict[str, Any] = {
        "sep": DELIMITERS.get(delimiter, delimiter), "decimal": decimal, "names": names, "skiprows": skip,
        "header": 0 if header is True else None, "comment": "#", "skipinitialspace": True, "encoding": _encoding(path),
    }  # fmt: skip
    left_out: list[str] = []
    try:
        frame = pandas.read_csv(path, **settings)
    except pandas.errors.ParserError:
        if not drop:
            raise
        long: list[Any] = []
        frame = pandas.read_csv(path, **settings, engine="python", on_bad_lines=lambda cells: long.append(cells))
        left_out.append(f"{path.name}: {len(long)} rows of another number of cells are left out (bad_rows)")
    if not isinstance(frame.index, pandas.RangeIndex):  # pandas would take the first cells for names of the rows
        text = layout(path, delimiter, decimal, header) or "name every column"
        raise BoresightError(f"{path}: a row has more cells than its header has names; {text}")
    if drop:
        numbers = frame.apply(pandas.to_numeric, errors="coerce")
        mostly = numbers.columns[numbers.notna().mean() > 0.9]
        bad = (numbers[mostly].isna() & frame[mostly].notna()).any(axis=1)
        frame = frame.assign(**{name: numbers[name] for name in mostly})[~bad]
        if bad.any():
            left_out.append(f"{path.name}: {bad.sum()} rows with text among their numbers are left out (bad_rows)")
    return Table(_columns(frame).items(), left_out)


def _encoding(path: Path) -> str:
    with path.open("rb") as file:
        marked = file.read(2) in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
    return "utf-16" if marked else "utf-8-sig"


def _cells(path: Path, delimiter: str) -> list[list[str]]:
    """The cells of the first lines of a text; a line's # is none of its."""
    out = []
    with path.open(encoding=_encoding(path), errors="replace") as file:
        for _, line in zip(range(LINES), file, strict=False):
            line = line.rstrip("\r\n").lstrip("# ")
            parts = line.split() if delimiter == "whitespace" else line.split(DELIMITERS.get(delimiter, delimiter))
            out.append([part.strip().strip('"') for part in parts])
    return out


def _names(path: Path, delimiter: str, lines: int) -> list[str] | None:
    """Names of columns in some lines: what stands above one another, a cell that is empty as the one to its left.

    A line of one cell is a title and names nothing.
    """
    if lines < 0:
        raise BoresightError(f"{path}: header is {lines}; give its number of lines")
    rows = [row for row in _cells(path, delimiter)[:lines] if sum(bool(cell) for cell in row) > 1]
    if not rows:
        return None
    width = max(len(row) for row in rows)
    parts: list[list[str]] = [[] for _ in range(width)]
    for number, row in enumerate(rows):
        left = ""
        for column in range(width):
            cell = row[column] if column < len(row) else ""
            left = cell or (left if number < len(rows) - 1 else "")
            if left:
                parts[column].append(left)
    names = [" ".join(part) or str(column) for column, part in enumerate(parts)]
    twice = [name for name, count in Counter(names).items() if count > 1]
    if twice:
        raise BoresightError(
            f"{path}: {len(rows)} lines of header name {twice[0]!r} twice; give the number of header lines"
        )
    return names


def layout(path: Path, delimiter: str, decimal: str, header: bool | int) -> str:
    """How a text stands, where it is not as it is described: what to write; "" where it is, and for other files."""
    keys, lines, separator = layout_keys(path, delimiter, decimal, header)
    if not keys:
        return ""
    held = f" (columns {', '.join(_names(path, separator, lines) or [])[:300]})" if lines else ""
    return f"the numbers begin in line {lines + 1}: {' and '.join(written(keys))} reads them{held}"


def written(keys: Mapping[str, str | int]) -> list[str]:
    """The keys as lines of a description."""
    return [f"{key} = {json.dumps(value)}" for key, value in keys.items()]


def layout_keys(
    path: Path, delimiter: str = ",", decimal: str = ".", header: bool | int = True
) -> tuple[dict[str, Any], int, str]:
    """The keys that read a text and differ from those given, the lines of its header, and its delimiter."""
    if READERS.get(kind_of(path), (None, None))[1] is not _text:
        return {}, 0, delimiter
    for separator in (delimiter, ",", ";", "tab", "whitespace"):
        for point in (decimal, ".", ","):
            if point == separator:
                continue
            rows = _cells(path, separator)
            full = [_numeric(row, point) for row in rows]
            begins = [k for k in range(len(rows) - 1) if full[k] and full[k + 1] and len(rows[k]) == len(rows[k + 1])]
            if not begins:
                continue
            lines = begins[0]
            keys: dict[str, Any] = {"delimiter": separator} if separator != delimiter else {}
            keys |= {"decimal": point} if point != decimal else {}
            if lines != int(header) or (lines == 1 and header is True and _hidden(path)):
                keys["header"] = lines or False
            return keys, lines, separator
    return {}, 0, delimiter


def _hidden(path: Path) -> bool:
    """Whether the first line, of names, is a comment."""
    with path.open(encoding=_encoding(path), errors="replace") as file:
        return file.readline().startswith("#")


def _numeric(cells: list[str], decimal: str) -> bool:
    """Whether a row holds numbers alone, or dates beside them; at least two cells."""
    number = re.compile(
        r"[+-]?(\d+([.]\d*)?|[.]\d+)(e[+-]?\d+)?|[+-]?(nan|inf)".replace("[.]", re.escape(decimal)), re.I
    )
    full = [cell for cell in cells if cell]
    found = [bool(number.fullmatch(cell)) for cell in full]
    dates = [bool(re.match(r"\d{4}-\d\d-\d\d", cell)) for cell in full]
    return len(full) > 1 and sum(found) > 0 and all(a or b for a, b in zip(found, dates, strict=True))


def _columns(frame: Any) -> dict[str, Array]:
    return {str(name).strip(): frame[name].to_numpy() for name in frame.columns}


def _parquet(path: Path) -> dict[str, Array]:
    import pandas

    return _columns(pandas.read_parquet(path).reset_index())


def _excel(path: Path) -> dict[str, Array]:
    """Columns of the first sheet by their names, and of each sheet as SHEET/column."""
    import pandas

    out: dict[str, Array] = {}
    for number, (sheet, frame) in enumerate(pandas.read_excel(path, sheet_name=None).items()):
        columns = _columns(frame)
        out |= {f"{sheet}/{name}": value for name, value in columns.items()} | (columns if number == 0 else {})
    return out


# ---------------------------------------------------------------- logs of many topics


def _gathered(columns: Iterable[tuple[str, Array]]) -> dict[str, Array]:
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

    raw, lost = _ulog_messages(path.read_bytes())
    try:
        with redirect_stdout(io.StringIO()):  # it prints what it meets
            log = ULog(io.BytesIO(raw))
    except TypeError as error:  # how it fails at a file that is none
        raise BoresightError(f"{path}: cannot be read as ulg: {error}") from None
    columns = _gathered(
        (f"{topic.name}_{topic.multi_id}/{name}" if topic.multi_id else f"{topic.name}/{name}", np.asarray(values))
        for topic in log.data_list
        for name, values in topic.data.items()
    )
    left_out = [f"{path.name}: {lost} bytes that are no messages"] if lost else []
    left_out += [f"{path.name}: messages of topics that nobody announced"] if log.file_corruption else []
    return Table(columns.items(), left_out)


def _ulog_messages(raw: bytes) -> tuple[bytes, int]:
    """A log of PX4 without what is no message in it, and how many bytes that is.

    A message is one where its type is known and so are those of the three that follow.
    """

    def follows(at: int, count: int) -> bool:
        for _ in range(count):
            if at + 3 > len(raw):
                return at == len(raw)
            if raw[at + 2] not in b"BFIMPQARDLCSO":
                return False
            at += 3 + int.from_bytes(raw[at : at + 2], "little")
        return at <= len(raw)

    at, begin, parts, sound = 16, 0, [], True
    while at < len(raw):
        if follows(at, 1) and ((sound and follows(at, 2)) or follows(at, 4)):
            begin, sound = (begin, True) if sound else (at, True)
            at += 3 + int.from_bytes(raw[at : at + 2], "little")
        else:
            if sound:
                parts.append(raw[begin:at])
            at, sound = at + 1, False
    parts += [raw[begin:]] if sound else []
    out = b"".join(parts)
    return out, len(raw) - len(out)


def _dataflash(path: Path) -> Table:
    """Messages of an ArduPilot log; a second instance of a message is NAME_1."""
    from pymavlink import DFReader

    rows: dict[tuple[str, Any], list[Any]] = {}
    printed = io.StringIO()  # it prints what it meets
    lost = path.stat().st_size
    with redirect_stdout(printed), redirect_stderr(printed):
        log = DFReader.DFReader_binary(str(path))
        while (message := log.recv_msg()) is not None:
            instance = message.fmt.instance_field
            rows.setdefault((message.get_type(), instance and message.__getattr__(instance)), []).append(message)
            lost -= message.fmt.len
    out = Table((), [f"{path.name}: {lost} bytes that are no messages"] if lost else [])
    for (name, instance), messages in rows.items():
        topic = f"{name}_{instance}" if instance else name
        for field in messages[0].get_fieldnames():
            values = [getattr(message, field) for message in messages]
            if all(isinstance(value, int | float) for value in values):
                out[f"{topic}/{field}"] = np.array(values)
    if not out:
        raise BoresightError(f"{path}: it has no ArduPilot messages")
    return out


def _bag(path: Path) -> Table:
    """Topics of a ROS 1 or ROS 2 bag, times as whole nanoseconds; beside "/imu/data/..." a topic that is the only one
    of its type is found by that as well: "sensor_msgs/Imu/...".  What has no known type, or is spoilt, is left out."""
    from rosbags import rosbag1, rosbag2
    from rosbags.typesys import Stores, get_typestore

    # A folder holds a ROS 2 bag with its metadata; so does the folder around a file of one.
    whole = path.parent if path.suffix != ".bag" and (path.parent / "metadata.yaml").is_file() else path
    rows: dict[tuple[str, str], list[dict[str, Any]]] = {}
    unknown: set[str] = set()
    spoilt: Counter[str] = Counter()
    usual, own = get_typestore(Stores.LATEST), get_typestore(Stores.EMPTY)
    with rosbag1.Reader(whole) if whole.suffix == ".bag" else rosbag2.Reader(whole) as bag:
        for connection in bag.connections:
            _register(own, connection)
        for connection, received, raw in bag.messages():
            topic, kind = connection.topic, connection.msgtype
            if len(raw) > LARGE:
                continue
            store = own if kind in own.fielddefs else usual
            if kind not in store.fielddefs:
                unknown.add(f"{topic} ({kind})")
                continue
            try:
                message = (store.deserialize_ros1 if whole.suffix == ".bag" else store.deserialize_cdr)(raw, kind)
                fields = {"received": received} | dict(_fields(message))
            except KeyError:  # a part of it has no known type
                unknown.add(f"{topic} ({kind})")
                continue
            except Exception:  # a message that is cut or spoilt fails in many ways
                spoilt[topic] += 1
                continue
            rows.setdefault((topic, kind.replace("/msg/", "/")), []).append(fields)
    left_out = [f"{len(unknown)} topics of unknown type: {', '.join(sorted(unknown))}"] if unknown else []
    left_out += [f"{topic}: {count} messages that cannot be read" for topic, count in spoilt.items()]
    out = Table((), [f"{path.name}: {line}" for line in left_out])
    kinds = [kind for _, kind in rows]
    for (topic, kind), messages in rows.items():
        for field, first in messages[0].items():
            values: list[Any] = [message.get(field) for message in messages]
            if all(value is not None and np.shape(value) == np.shape(first) for value in values):
                out[f"{topic}/{field}"] = np.array(values)
                if kinds.count(kind) == 1:
                    out[f"{kind}/{field}"] = out[f"{topic}/{field}"]
    return out


def _register(store: Any, connection: Any) -> None:
    """The types that a bag brings along; a definition that cannot be read leaves its topic unknown."""
    from rosbags.typesys import get_types_from_idl, get_types_from_msg

    text = connection.msgdef.data
    try:
        if connection.msgdef.format.name == "MSG":
            store.register(get_types_from_msg(text, connection.msgtype))
        elif connection.msgdef.format.name == "IDL":
            for part in text.split("=" * 80 + "\n"):
                if part.strip():
                    store.register(get_types_from_idl(part.split("\n", 1)[1] if part.startswith("IDL: ") else part))
    except Exception:  # each of its parsers fails in its own way
        store.fielddefs.pop(connection.msgtype, None)


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


READERS: dict[str, tuple[str | None, Callable[..., dict[str, Array]]]] = {
    ".csv": ("replay", _text), ".txt": ("replay", _text), ".dat": ("replay", _text), ".npz": (None, _npz),
    ".mat": (None, _mat), ".h5": ("hdf5", _hdf5), ".hdf5": ("hdf5", _hdf5), ".parquet": ("parquet", _parquet),
    ".xlsx": ("excel", _excel), ".ulg": ("ulog", _ulog), ".bin": ("ardupilot", _dataflash), ".bag": ("ros", _bag),
    ".mcap": ("ros", _bag), ".db3": ("ros", _bag),
}  # fmt: skip
