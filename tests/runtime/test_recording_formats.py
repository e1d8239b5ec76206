"""Formats: each is read from a file that its reader's library did not write.

Where a package that is installed brings such a file it is read from there; else the bytes are put together here, from
the format's own description.  Only the ROS 1 bag is written by the library that reads it.
"""

import sqlite3
import struct
import tomllib
import zipfile
from importlib.util import find_spec
from pathlib import Path
from xml.sax.saxutils import escape

import numpy as np
import pytest
from tools import lacks

from boresight import BoresightError
from boresight.cli import main
from boresight.runtime import rotation
from boresight.runtime.recording import read
from boresight.runtime.recording.read import template
from boresight.runtime.recording.tables import table
from boresight.runtime.units import DEG

T = np.arange(1, 501) * 0.01  # s, of the slave
TM = np.arange(1, 50) * 0.1  # of the master
ROLL = 0.2 * np.sin(1.3 * T)
RATE = 0.2 * (np.sin(1.3 * T) - np.sin(1.3 * (T - 0.01))) / 0.01
FORCE = np.stack([0 * T, -9.81 * np.sin(ROLL), -9.81 * np.cos(ROLL)], -1)
GYRO = np.stack([RATE, 0 * T, 0 * T], -1)
EULER = np.stack([0.2 * np.sin(1.3 * TM), 0 * TM, 0 * TM + 0.5], -1)
BEGAN = 1_700_000_000 * 10**9  # ns


def installed(package, *path):
    spec = find_spec(package)
    file = Path(spec.origin).parent.joinpath(*path)
    if not file.is_file():
        lacks(f"the test data of {package}", "a release that brings it")
    return file


def said(capsys, *words):
    """What the command line says of a recording, and its exit status."""
    with pytest.raises(SystemExit) as ended:
        main(["replay", *map(str, words)])
    return capsys.readouterr(), ended.value.code


def is_the_drive(recording):
    np.testing.assert_allclose(np.diff(recording.imu.time), 0.01, atol=1e-8)
    np.testing.assert_allclose(recording.imu.gyro, GYRO, atol=1e-6)
    np.testing.assert_allclose(recording.imu.accel, FORCE, atol=1e-5)
    master, began = recording.master, recording.imu.time[0] - 0.01
    np.testing.assert_allclose(master.time - began, TM, atol=1e-8)
    np.testing.assert_allclose(master.euler, EULER, atol=1e-6)
    np.testing.assert_allclose(master.v_n, np.tile([3.0, 4.0, 0.0], (len(TM), 1)), atol=1e-5)
    np.testing.assert_allclose(np.degrees(master.position[:, :2]), [[47.4, 8.5]] * len(TM))


# ---------------------------------------------------------------- arrays


def test_matlab_7_3_is_read_as_matlab_wrote_it():
    """SciPy's test data, written by MATLAB 7.4, where it is a file that SciPy itself does not read."""
    got = table(installed("scipy", "io", "matlab", "tests", "data", "testhdf5_7.4_GLNX86.mat"))
    np.testing.assert_allclose(got["testdouble"], np.pi / 4 * np.arange(9))


def test_a_struct_of_matlab_is_its_fields():
    got = table(installed("scipy", "io", "matlab", "tests", "data", "teststructnest_7.4_GLNX86.mat"))
    assert got["teststructnest/one"] == 1 and got["teststructnest/two/three"] == "number 3"


def test_hdf5_is_read_in_either_order_of_bytes():
    """h5py's test data, written on a big-endian machine."""
    got = table(installed("h5py", "tests", "data_files", "vlen_string_s390x.h5"))
    np.testing.assert_array_equal(got["DSBEfloat"], got["DSLEfloat"])
    assert len(got["DSBEint"]) == 5


def test_a_matrix_of_matlab_7_3_is_not_on_its_side(tmp_path):
    import h5py

    with h5py.File(tmp_path / "a.mat", "w", userblock_size=512) as file:
        file["imu/gyro"] = GYRO.T  # as MATLAB lays a matrix of 500 rows out
    with (tmp_path / "a.mat").open("r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file".ljust(128))
    np.testing.assert_array_equal(table(tmp_path / "a.mat")["imu/gyro"], GYRO)


def test_excel_is_read_by_the_names_of_its_columns(tmp_path):
    """A workbook as the standard has it (ECMA-376), of two sheets."""

    def sheet(names, columns):
        cells = [[f'<c t="inlineStr"><is><t>{escape(name)}</t></is></c>' for name in names]]
        cells += [[f"<c><v>{value!r}</v></c>" for value in row] for row in columns.tolist()]
        rows = "".join(f"<row>{''.join(row)}</row>" for row in cells)
        return f'<worksheet xmlns="{MAIN}"><sheetData>{rows}</sheetData></worksheet>'

    MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
    REL = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    PACKAGE = "http://schemas.openxmlformats.org/package/2006"
    kinds = {"workbook": "sheet.main", "worksheets/sheet1": "worksheet", "worksheets/sheet2": "worksheet"}
    overrides = "".join(
        f'<Override PartName="/xl/{part}.xml" ContentType="application/vnd.openxmlformats-officedocument.'
        f'spreadsheetml.{kind}+xml"/>' for part, kind in kinds.items()
    )  # fmt: skip
    sheets = "".join(f'<sheet name="{n}" sheetId="{i}" r:id="r{i}"/>' for i, n in ((1, "imu"), (2, "ins")))
    link = '<Relationship Id="{0}" Type="{1}/{2}" Target="{3}"/>'
    links = "".join(link.format(f"r{i}", REL, "worksheet", f"worksheets/sheet{i}.xml") for i in (1, 2))
    whole = link.format("w", REL, "officeDocument", "xl/workbook.xml")
    rels = "application/vnd.openxmlformats-package.relationships+xml"
    parts = {
        "[Content_Types].xml": f'<Types xmlns="{PACKAGE}/content-types"><Default Extension="rels" '
        f'ContentType="{rels}"/>{overrides}</Types>',
        "_rels/.rels": f'<Relationships xmlns="{PACKAGE}/relationships">{whole}</Relationships>',
        "xl/_rels/workbook.xml.rels": f'<Relationships xmlns="{PACKAGE}/relationships">{links}</Relationships>',
        "xl/workbook.xml": f'<workbook xmlns="{MAIN}" xmlns:r="{REL}"><sheets>{sheets}</sheets></workbook>',
        "xl/worksheets/sheet1.xml": sheet(["t", "gx"], np.stack([T, GYRO[:, 0]], -1)[:20]),
        "xl/worksheets/sheet2.xml": sheet(["t"], TM[:5, None]),
    }
    with zipfile.ZipFile(tmp_path / "a.xlsx", "w") as book:
        for name, text in parts.items():
            book.writestr(name, text)
    got = table(tmp_path / "a.xlsx")
    np.testing.assert_array_equal(got["gx"], GYRO[:20, 0])
    np.testing.assert_array_equal(got["t"], got["imu/t"])
    np.testing.assert_array_equal(got["ins/t"], TM[:5])


# ---------------------------------------------------------------- PX4


def ulog(path, began_us=5_000_000, fields=None):
    """A log as the PX4 User Guide describes ULog: header, flags, formats, subscriptions, data."""
    formats = {
        "sensor_combined": "uint64_t timestamp;float[3] gyro_rad;float[3] accelerometer_m_s2;",
        "vehicle_attitude": "uint64_t timestamp;float[4] q;",
        "vehicle_local_position": "uint64_t timestamp;double ref_lat;double ref_lon;float ref_alt;"
        "float x;float y;float z;float vx;float vy;float vz;",
    }
    if fields:
        formats = {name: text for name, text in formats.items() if name in fields}

    def message(kind, body):
        return struct.pack("<Hc", len(body), kind.encode()) + body

    out = b"ULog\x01\x12\x35\x01" + struct.pack("<Q", began_us) + message("B", bytes(40))
    out += b"".join(message("F", f"{name}:{text}".encode()) for name, text in formats.items())
    ids = {name: i for i, name in enumerate(formats)}
    out += b"".join(message("A", struct.pack("<BH", 0, i) + name.encode()) for name, i in ids.items())
    q = rotation.quaternion_from_euler(EULER)
    rows = [(t, "sensor_combined", struct.pack("<6f", *w, *f)) for t, w, f in zip(T, GYRO, FORCE, strict=True)]
    rows += [(t, "vehicle_attitude", struct.pack("<4f", *one)) for t, one in zip(TM, q, strict=True)]
    rows += [(t, "vehicle_local_position", struct.pack("<2d7f", 47.4, 8.5, 100, 0, 0, 0, 3, 4, 0)) for t in TM]
    for t, name, body in sorted(rows, key=lambda row: row[0]):
        if name in ids:
            out += message("D", struct.pack("<HQ", ids[name], began_us + round(t * 1e6)) + body)
    path.write_bytes(out)
    return path


def test_a_log_of_px4_is_read_by_its_topics(tmp_path, capsys):
    recording = read(ulog(tmp_path / "flight.ulg"))
    assert recording.title == "PX4 log"
    assert recording.imu.time[0] == pytest.approx(5.01)
    is_the_drive(recording)
    out, status = said(capsys, tmp_path / "flight.ulg", "--check")
    assert status == 0 and "metres from 47.40000, 8.50000 deg, 100.0 m" in out.out


def test_a_topic_that_is_missing_is_one_line(tmp_path):
    path = ulog(tmp_path / "flight.ulg", fields=("sensor_combined", "vehicle_attitude"))
    with pytest.raises(BoresightError, match=r"it lacks vehicle_local_position/timestamp; write flight.toml beside it"):
        read(path)
    path.with_suffix(".toml").write_text(
        (Path(template.__code__.co_filename).parent / "built_in" / "px4.toml").read_text().replace("/gyro_rad", "/gyro")
    )
    with pytest.raises(BoresightError, match=r"no column 'sensor_combined/gyro'; did you mean .*gyro_rad.*it has"):
        read(path)


# ---------------------------------------------------------------- ArduPilot


def dataflash(path, names=("IMU", "XKF1", "POS"), instance=None):
    """A log of ArduPilot: messages behind A3 95 and a number, described by FMT messages."""
    formats = {
        "IMU": (1, "Qffffff" if instance is None else "QBffffff",
                "TimeUS," + ("" if instance is None else "I,") + "GyrX,GyrY,GyrZ,AccX,AccY,AccZ"),
        "XKF1": (2, "Qccfffff", "TimeUS,Roll,Pitch,Yaw,VN,VE,VD,X"),
        "POS": (3, "QLLf", "TimeUS,Lat,Lng,Alt"),
        "FMTU": (4, "QBNN", "TimeUS,FmtType,UnitIds,MultIds"),
    }  # fmt: skip
    sizes = {letter: struct.calcsize("<" + code) for letter, code in CODES.items()}

    def message(number, body):
        return b"\xa3\x95" + bytes([number]) + body

    def fmt(number, name, length, kinds, columns):
        return message(128, struct.pack("<BB4s16s64s", number, length, name.encode(), kinds.encode(), columns.encode()))

    out = fmt(128, "FMT", 89, "BBnNZ", "Type,Length,Name,Format,Columns")
    for name in (*names, "FMTU"):
        number, kinds, columns = formats[name]
        out += fmt(number, name, 3 + sum(sizes[kind] for kind in kinds), kinds, columns)
    if instance is not None:
        out += message(4, struct.pack("<QB16s16s", 0, 1, b"s#EEEooo", b"F-000000"))

    def packed(name, *values):
        number, kinds, _ = formats[name]
        return message(number, struct.pack("<" + "".join(CODES[kind] for kind in kinds), *values))

    rows = []
    for t, w, f in zip(T, GYRO, FORCE, strict=True):
        for which in (None,) if instance is None else (0, 1):
            said = (round(t * 1e6), *(() if which is None else (which,)))
            rows.append((t, packed("IMU", *said, *(w + 0.1 * (which or 0)), *f)))
    for t, euler in zip(TM, EULER, strict=True):
        roll, pitch = (round(angle / DEG * 100) for angle in euler[:2])
        rows.append((t, packed("XKF1", round(t * 1e6), roll, pitch, euler[2] / DEG, 3, 4, 0, 0)))
        rows.append((t, packed("POS", round(t * 1e6), 474000000, 85000000, 100.0)))
    path.write_bytes(out + b"".join(body for _, body in sorted(rows, key=lambda row: row[0])))
    return path


CODES = {"Q": "Q", "B": "B", "f": "f", "c": "h", "L": "i", "n": "4s", "N": "16s", "Z": "64s"}


@pytest.mark.parametrize("instance", [None, 0])
def test_a_log_of_ardupilot_is_read_by_its_messages(tmp_path, instance):
    """Roll and pitch in hundredths of a degree; where messages come by instance the first is the slave."""
    path = dataflash(tmp_path / "flight.bin", instance=instance)
    recording = read(path)
    assert recording.title == "ArduPilot log"
    np.testing.assert_allclose(recording.imu.gyro, GYRO, atol=1e-6)
    np.testing.assert_allclose(recording.imu.accel, FORCE, atol=1e-5)
    np.testing.assert_allclose(recording.master.euler, EULER, atol=0.006 * DEG)
    np.testing.assert_allclose(np.degrees(recording.master.position[:, :2]), [[47.4, 8.5]] * len(TM), atol=1e-9)
    if instance is not None:
        np.testing.assert_allclose(table(path)["IMU_1/GyrX"], GYRO[:, 0] + 0.1, atol=1e-6)


# ---------------------------------------------------------------- ROS


class Cdr:
    """Little-endian CDR as ROS 2 serializes a message."""

    def __init__(self):
        self.bytes = b"\x00\x01\x00\x00"

    def put(self, code, *values):
        for value in values:
            size = struct.calcsize(code)
            self.bytes += bytes(-(len(self.bytes) - 4) % size) + struct.pack("<" + code, value)
        return self

    def header(self, stamp, frame):
        self.put("i", stamp // 10**9).put("I", stamp % 10**9)
        return self.text(frame)

    def text(self, text):
        self.put("I", len(text) + 1)
        self.bytes += text.encode() + b"\0"
        return self


def ros2(folder):
    """A bag of ROS 2 with SQLite: its tables, and metadata.yaml."""
    flu = np.array([1.0, -1.0, -1.0])
    enu = np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]])
    C = enu @ rotation.matrix_from_euler(EULER) @ np.diag(flu)
    q = np.roll(rotation.quaternion_from_matrix(C), -1, axis=1)
    body = np.einsum("kji,j->ki", C, [4.0, 3.0, 0.0])
    rows = []
    for t, w, f in zip(T, GYRO * flu, FORCE * flu, strict=True):
        stamp = BEGAN + round(t * 1e9)
        imu = Cdr().header(stamp, "imu").put("d", 0, 0, 0, 1, *[0] * 9, *w, *[0] * 9, *f, *[0] * 9)
        rows.append((1, stamp, imu.bytes))
    for t, one, v in zip(TM, q, body, strict=True):
        stamp = BEGAN + round(t * 1e9)
        odometry = Cdr().header(stamp, "odom").text("base").put("d", 0, 0, 0, *one, *[0] * 36, *v, 0, 0, 0, *[0] * 36)
        rows.append((2, stamp, odometry.bytes))
        fix = Cdr().header(stamp, "gps").put("b", 0).put("H", 1).put("d", 47.4, 8.5, 100, *[0] * 9).put("B", 0)
        rows.append((3, stamp, fix.bytes))
    folder.mkdir()
    kinds = {"/imu/data": "sensor_msgs/msg/Imu", "/odom": "nav_msgs/msg/Odometry", "/fix": "sensor_msgs/msg/NavSatFix"}
    base = sqlite3.connect(folder / "drive.db3")
    base.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT, "
                 "offered_qos_profiles TEXT)")  # fmt: skip
    base.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB)")
    for i, (topic, kind) in enumerate(kinds.items(), 1):
        base.execute("INSERT INTO topics VALUES (?, ?, ?, 'cdr', '')", (i, topic, kind))
    base.executemany(
        "INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)", sorted(rows, key=lambda r: r[1])
    )
    base.commit()
    base.close()
    counts = [sum(row[0] == i for row in rows) for i in (1, 2, 3)]
    topics = "".join(
        f"    - message_count: {count}\n      topic_metadata: {{name: {topic}, type: {kind}, "
        "serialization_format: cdr, offered_qos_profiles: ''}\n"
        for count, (topic, kind) in zip(counts, kinds.items(), strict=True)
    )
    (folder / "metadata.yaml").write_text(
        "rosbag2_bagfile_information:\n  version: 4\n  storage_identifier: sqlite3\n"
        "  relative_file_paths: [drive.db3]\n"
        f"  duration: {{nanoseconds: 5000000000}}\n  starting_time: {{nanoseconds_since_epoch: {BEGAN}}}\n"
        f"  message_count: {len(rows)}\n  compression_format: ''\n  compression_mode: ''\n"
        f"  topics_with_message_count:\n{topics}"
    )
    return folder


def test_a_bag_of_ros_2_is_read_by_the_types_of_its_topics(tmp_path):
    """Named as a folder or as the file in it; stamps are dates, velocity is in body axes."""
    folder = ros2(tmp_path / "drive")
    for path in (folder, folder / "drive.db3"):
        recording = read(path)
        assert recording.title == "ROS bag" and recording.epoch == BEGAN // 10**9
        is_the_drive(recording)
    got = table(folder)
    np.testing.assert_array_equal(got["/imu/data/header.stamp"], BEGAN + np.round(T * 1e9).astype(int))
    np.testing.assert_array_equal(got["/odom/twist.twist.linear"], got["nav_msgs/Odometry/twist.twist.linear"])


def test_a_bag_of_ros_1_is_read_by_the_names_of_its_topics(tmp_path):
    """Written by the library that reads it."""
    from rosbags.rosbag1 import Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS1_NOETIC)
    names = ("geometry_msgs/msg/Vector3Stamped", "std_msgs/msg/Header", "builtin_interfaces/msg/Time")
    kind, header, stamp = (store.types[name] for name in names)
    vector = store.types["geometry_msgs/msg/Vector3"]
    with Writer(tmp_path / "a.bag") as bag:
        topics = [bag.add_connection(f"/{name}", kind.__msgtype__, typestore=store) for name in ("gyro", "accel")]
        for k in range(20):
            at = BEGAN + round(T[k] * 1e9)
            for topic, values in zip(topics, (GYRO, FORCE), strict=True):
                message = kind(header(k, stamp(at // 10**9, at % 10**9), "imu"), vector(*map(float, values[k])))
                bag.write(topic, at, store.serialize_ros1(message, kind.__msgtype__))
    got = table(tmp_path / "a.bag")
    np.testing.assert_array_equal(got["/gyro/vector"], GYRO[:20])
    np.testing.assert_array_equal(got["/accel/header.stamp"], BEGAN + np.round(T[:20] * 1e9).astype(int))
    # two topics of one type: the type names neither
    assert "geometry_msgs/Vector3Stamped/vector" not in got


# ---------------------------------------------------------------- what is no such file, and a description to begin with


@pytest.mark.parametrize("ending", ["ulg", "bin", "bag", "mcap", "db3", "h5", "mat", "xlsx", "parquet", "npz"])
def test_a_file_that_is_none_of_its_kind_is_one_line(tmp_path, ending):
    for content in (b"", b"this is no such file " * 30):
        (tmp_path / f"a.{ending}").write_bytes(content)
        with pytest.raises(BoresightError) as error:
            table(tmp_path / f"a.{ending}")
        assert str(error.value).startswith(f"{tmp_path / f'a.{ending}'}: ") and "\n" not in str(error.value)


def test_an_ending_that_is_not_known_names_the_ones_that_are(tmp_path):
    (tmp_path / "a.ulog").write_bytes(b"")
    with pytest.raises(BoresightError, match=r"a \.ulog file cannot be read.*did you mean '\.ulg'.*\.bag"):
        table(tmp_path / "a.ulog")


def test_a_template_has_the_layout_of_the_text_that_it_is_for(tmp_path, capsys):
    path = tmp_path / "a.csv"
    path.write_text("Zeit [ms];wx\n0;0,5\n10;0,25\n")
    out, _ = said(capsys, "--template", path)
    described = tomllib.loads(out.out)
    assert (described["delimiter"], described["decimal"]) == (";", ",")
    assert "#   Zeit [ms] 2\n#   wx 2\n" in out.out


def test_a_template_names_the_file_and_what_it_holds(tmp_path, capsys):
    """The map of its topics where there is one; what is printed is a description that serves."""
    path = ulog(tmp_path / "flight.ulg")
    out, status = said(capsys, "--template", path)
    assert status == 0 and 'file = "flight.ulg"' in out.out
    assert "#   sensor_combined/gyro_rad 500x3" in out.out
    (tmp_path / "mine.toml").write_text(out.out)
    is_the_drive(read(tmp_path / "mine.toml"))

    np.savez(tmp_path / "a.npz", omega=GYRO, t=T)
    out, status = said(capsys, "--template", tmp_path / "a.npz")
    assert status == 0 and "#   omega 500x3" in out.out and 'file = "a.npz"' in out.out and "time_marks" in out.out
    out, status = said(capsys, "--template")
    assert status == 0 and "[imu]" in out.out


# ---------------------------------------------------------------- logs that are not whole


def ros2_written(folder, spoil=()):
    """A bag by the library that reads it: an Imu at 50 Hz with orientation, a topic of unknown type; rows to spoil."""
    from rosbags.rosbag2 import Writer
    from rosbags.rosbag2.enums import StoragePlugin
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_HUMBLE)
    imu, header, stamp = (store.types[name] for name in (
        "sensor_msgs/msg/Imu", "std_msgs/msg/Header", "builtin_interfaces/msg/Time"))  # fmt: skip
    vector, quaternion = store.types["geometry_msgs/msg/Vector3"], store.types["geometry_msgs/msg/Quaternion"]
    none = np.zeros(9)
    none[0] = -1
    with Writer(folder, version=9, storage_plugin=StoragePlugin.SQLITE3) as bag:
        known = bag.add_connection("/imu/data", imu.__msgtype__, typestore=store)
        other = bag.add_connection(
            "/secret", "acme_msgs/msg/Thing", msgdef="acme_msgs/Other what", rihs01="RIHS01_" + "0" * 64
        )
        for k in range(len(T)):
            at = BEGAN + round(T[k] * 1e9)
            message = imu(
                header(stamp(at // 10**9, at % 10**9), "imu"), quaternion(0.0, 0.0, 0.0, 0.0), none,
                vector(*map(float, GYRO[k])), np.zeros(9), vector(*map(float, FORCE[k])), np.zeros(9),
            )  # fmt: skip
            raw = bytes(store.serialize_cdr(message, imu.__msgtype__))
            bag.write(known, at, raw[: len(raw) // 2] if k in spoil else raw)
            if k % 50 == 0:
                bag.write(other, at, b"\x00\x01\x00\x00\x07\x00\x00\x00")
    return folder


def test_topics_of_unknown_type_and_spoilt_messages_are_left_out_and_counted(tmp_path):
    folder = ros2_written(tmp_path / "drive", spoil=(100, 300))
    (tmp_path / "drive.toml").write_text(ALONE)
    recording = read(tmp_path / "drive.toml")
    measured = (recording.imu.doubt == 0).all(axis=1)  # the others were bridged
    assert list(np.flatnonzero(~measured)) == [100, 300]
    np.testing.assert_allclose(recording.imu.gyro[measured], GYRO[measured], atol=1e-9)
    left = " ".join(recording.left_out)
    assert "1 topics of unknown type: /secret (acme_msgs/msg/Thing)" in left
    assert "/imu/data: 2 messages that cannot be read" in left and str(folder.name) in left


ALONE = """file = "drive"
bridge = "25 ms"
[imu]
kind = "rates"
time_marks = "end"
body = "FRD"
time = { columns = "/imu/data/header.stamp", unit = "ns" }
gyro = { columns = "/imu/data/angular_velocity", unit = "rad/s" }
accel = { columns = "/imu/data/linear_acceleration", unit = "m/s^2" }
"""


def test_an_imu_that_gives_no_orientation_is_no_master(tmp_path):
    ros2_written(tmp_path / "drive")
    (tmp_path / "drive.toml").write_text(
        ALONE
        + """[master]
body = "FLU"
navigation = "ENU"
time = { columns = "/imu/data/header.stamp", unit = "ns" }
attitude = { columns = "/imu/data/orientation", unit = "1", order = "xyzw" }
"""
    )
    with pytest.raises(BoresightError, match=r"orientation_covariance\[0\] = -1\); name another topic"):
        read(tmp_path / "drive.toml")


def test_a_bag_without_a_place_says_what_to_write_and_the_template_has_the_line(tmp_path, capsys):
    folder = ros2(tmp_path / "drive")
    base = sqlite3.connect(folder / "drive.db3")
    base.execute("DELETE FROM messages WHERE topic_id = 3")
    base.execute("DELETE FROM topics WHERE id = 3")
    base.commit()
    base.close()
    with pytest.raises(BoresightError, match=r"origin = \{ latitude = 47.4 \}.*--template"):
        read(folder)
    out, _ = said(capsys, "--template", folder)
    assert "latitude = 47.4" in out.out and "NavSatFix" not in out.out.partition("# What")[0].partition("[imu]")[2]
    (tmp_path / "mine.toml").write_text(out.out.replace("latitude = 47.4", "latitude = 47.4\nlongitude = 8.5"))
    is_the_drive(read(tmp_path / "mine.toml"))


@pytest.mark.parametrize("kind", ["ulg", "bin"])
@pytest.mark.parametrize("fill", [b"\xff", b"\x00", b"D"])
def test_a_log_with_one_spoilt_message_is_read_but_for_it(tmp_path, kind, fill):
    path = ulog(tmp_path / "flight.ulg") if kind == "ulg" else dataflash(tmp_path / "flight.bin")
    raw = bytearray(path.read_bytes())
    at = len(raw) // 2
    raw[at : at + 20] = fill * 20
    path.write_bytes(raw)
    recording = read(path, strict=False, bridge="100 ms")
    assert abs(len(recording.imu.time) - len(T)) <= 3
    assert recording.left_out
