"""Recordings: the border is crossed rightly, every kind of file says the same, each bad input gets its one line."""

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
from conftest import ROOT
from scipy.io import savemat
from scipy.spatial.transform import Rotation
from tools import real_recording

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.recording import (
    Inertial,
    Master,
    Recording,
    best_delay,
    check,
    description,
    gravity_in_ned,
    read,
    shifted,
)

DEG = np.pi / 180
TOML = """
file = "{file}"
[imu]
kind = "rates"
time_marks = "end"
body = "FLU"
time = {{ columns = "t", unit = "ms" }}
gyro = {{ columns = ["wx", "wy", "wz"], unit = "deg/s" }}
accel = {{ columns = ["fx", "fy", "fz"], unit = "g" }}
"""
MASTER = """
[master]
file = "master.csv"
body = "FRD"
navigation = "NED"
time = {{ columns = "t", unit = "s" }}
attitude = {{ columns = ["roll", "pitch", "heading"], unit = "deg" }}
velocity = {{ columns = ["vn", "ve", "vd"], unit = "m/s" }}
position = {{ columns = ["lat", "lon", "h"], unit = "deg" }}
"""


def table(rows=200):
    """A slave at rest but for a gentle roll, in FLU, deg/s and g, 100 Hz."""
    t = np.arange(1, rows + 1) * 10.0
    roll_rate = 5 * np.sin(t / 200)
    return pd.DataFrame(
        {"t": t, "wx": roll_rate, "wy": 0.01, "wz": -0.02, "fx": 0.001 * np.cos(t), "fy": 0.002, "fz": 1.0}
    )


def master_table(rows=20):
    t = np.arange(rows) * 0.1
    roll = 5 * 0.2 * (1 - np.cos(t * 5))  # deg: the integral of the slave's roll rate
    out = pd.DataFrame({"t": t, "roll": roll, "pitch": 1.0, "heading": 350.0})
    return out.assign(vn=10.0, ve=0.0, vd=0.0, lat=45 + 10 * t / 111195, lon=7.0, h=200.0)


@pytest.fixture
def describe(tmp_path):
    """Write slave.csv, master.csv and a description with some words replaced; returns the description's path."""

    def write(*replaced, slave=None, master=None, toml=TOML + MASTER):
        (table() if slave is None else slave).to_csv(tmp_path / "slave.csv", index=False)
        (master_table() if master is None else master).to_csv(tmp_path / "master.csv", index=False)
        text = toml.format(file="slave.csv")
        for old, new in replaced:
            assert old in text
            text = text.replace(old, new)
        path = tmp_path / "drive.toml"
        path.write_text(text)
        return path

    return write


def levels(recording, level):
    return [f"{finding.where}: {finding.text}" for finding in check(recording) if finding.level == level]


# ---------------------------------------------------------------- the border


def test_units_and_axes_are_converted(describe):
    recording = read(describe())
    np.testing.assert_allclose(recording.imu.time[:2], [0.01, 0.02])
    np.testing.assert_allclose(recording.imu.gyro[0], [5 * np.sin(0.05) * DEG, -0.01 * DEG, 0.02 * DEG])
    np.testing.assert_allclose(recording.imu.accel[0, 1:], [-0.002 * 9.80665, -9.80665])
    np.testing.assert_allclose(recording.master.euler[0], [0, 1 * DEG, -10 * DEG])
    np.testing.assert_allclose(recording.master.position[0], [45 * DEG, 7 * DEG, 200])
    assert levels(recording, "error") == []


@pytest.mark.parametrize("kind", ["npz", "mat", "parquet", "txt", "matrix", "no header"])
def test_every_kind_of_file_says_the_same_as_csv(describe, tmp_path, kind):
    expected = read(describe()).imu
    frame = table()
    arrays = {name: frame[name].to_numpy() for name in frame}
    replaced = [("slave.csv", f"slave.{kind}")]
    if kind == "npz":
        np.savez(tmp_path / "slave.npz", **arrays)
    elif kind == "mat":
        savemat(tmp_path / "slave.mat", arrays)
    elif kind == "parquet":
        frame.to_parquet(tmp_path / "slave.parquet")
    elif kind == "txt":
        frame.to_csv(tmp_path / "slave.txt", sep=";", index=False)
        replaced.append(("[imu]", 'delimiter = ";"\n[imu]'))
    else:  # columns by number
        replaced = [(f'"{name}"', f'"imu[{i}]"' if kind == "matrix" else f'"{i}"') for i, name in enumerate(frame)]
        if kind == "matrix":
            savemat(tmp_path / "slave.mat", {"imu": frame.to_numpy()})
            replaced.append(("slave.csv", "slave.mat"))
        else:
            frame.to_csv(tmp_path / "bare.txt", header=False, index=False)
            replaced += [("slave.csv", "bare.txt"), ("[imu]", "header = false\n[imu]")]
    got = read(describe(*replaced, toml=TOML)).imu
    for name in ("time", "gyro", "accel"):
        np.testing.assert_allclose(getattr(got, name), getattr(expected, name), rtol=1e-14)


def test_a_quaternion_says_the_same_as_angles(describe):
    expected = read(describe()).master.euler
    for order in ("wxyz", "xyzw"):
        q = np.roll(rotation.quaternion_from_euler(expected), 0 if order == "wxyz" else -1, axis=1)
        master = master_table().assign(**{f"q{i}": q[:, i] for i in range(4)})
        angles = '["roll", "pitch", "heading"], unit = "deg"'
        quaternion = f'["q0", "q1", "q2", "q3"], unit = "1", order = "{order}"'
        got = read(describe((angles, quaternion), master=master)).master.euler
        np.testing.assert_allclose(got, expected, atol=1e-14)


@pytest.mark.parametrize(("body", "navigation"), [("FLU", "ENU"), ("FLU", "NWU"), ("RFU", "ENU"), ("FRD", "NED")])
def test_three_angles_of_other_axes_say_the_same_as_the_quaternion_of_their_turns(describe, body, navigation):
    """Turned about the vertical, the lateral and the front axis of the body, from where the axes of both coincide."""
    frame = master_table()
    turns = frame[["heading", "pitch", "roll"]].to_numpy()
    order = "".join("XYZ"[next(i for i, axis in enumerate(body) if axis in pair)] for pair in ("DU", "RL", "F"))
    quaternions = Rotation.from_euler(order, turns, degrees=True).as_quat()
    frame[["x", "y", "z", "w"]] = quaternions
    frames = (('body = "FRD"', f'body = "{body}"'), ('"NED"', f'"{navigation}"'))
    lines = {
        "angles": ', pitch_positive = "{}", yaw_positive = "{}", yaw_from = "{}"'.format(
            "down" if "L" in body else "up",
            "counter-clockwise" if "U" in body else "clockwise",
            {"N": "north", "E": "east"}[navigation[body.index("F")]],
        ),
        "quaternion": ', order = "xyzw"',
    }
    said = []
    for kind, words in lines.items():
        old = '"roll", "pitch", "heading"], unit = "deg"'
        new = f'"x", "y", "z", "w"], unit = "1"{words}' if kind == "quaternion" else old + words
        said.append(read(describe((old, new), *frames, master=frame), strict=False).master.euler)
    np.testing.assert_allclose(said[0], said[1], atol=1e-12)


def test_a_csv_of_utf_16_is_read_by_its_first_bytes(describe, tmp_path):
    path = describe()
    plain = read(path).imu
    for encoding in ("utf-16", "utf-8-sig"):
        (tmp_path / "slave.csv").write_text(table().to_csv(index=False), encoding=encoding)
        np.testing.assert_array_equal(read(path).imu.gyro, plain.gyro)
    (tmp_path / "slave.csv").write_text("t,wx,°\n1,2,3\n", encoding="latin-1")
    refused(path, "slave.csv", "save it as UTF-8")
    path.write_text(path.read_text(), encoding="utf-16")
    refused(path, "drive.toml", "save it as UTF-8")


def test_rates_and_increments_are_two_words_for_one_thing():
    t = np.array([0.1, 0.2, 0.3, 0.6, 0.7])  # a gap of 0.3 s
    rates = Inertial("rates", "end", t, np.full((5, 3), 2.0), np.full((5, 3), 3.0))
    increments = Inertial("increments", "end", t, np.full((5, 3), 0.2), np.full((5, 3), 0.3))
    for a, b in zip(rates.increments, increments.increments, strict=True):
        np.testing.assert_allclose(a, b)
    np.testing.assert_allclose(increments.rates()[0], rates.gyro)


@pytest.mark.parametrize(("marks", "first"), [("end", 0.9), ("middle", 0.95), ("start", 1.0)])
def test_a_time_tag_marks_the_instant_it_says(marks, first):
    imu = Inertial("rates", marks, 1 + 0.1 * np.arange(20), np.zeros((20, 3)), np.zeros((20, 3)))
    start, end = imu.intervals()
    assert start[0] == pytest.approx(first)
    np.testing.assert_allclose(end - start, 0.1)
    np.testing.assert_allclose(start[1:], end[:-1])


def test_pieces_between_two_instants_add_up_wherever_they_cut():
    rng = np.random.default_rng(3)
    imu = Inertial("increments", "end", 0.01 * np.arange(1, 101), rng.normal(size=(100, 3)), np.zeros((100, 3)))
    cumulative = np.vstack([np.zeros(3), np.cumsum(imu.gyro, axis=0)])
    for t0, t1 in ((0.1, 0.2), (0.103, 0.207), (0.5, 0.504), (0.0, 1.0)):
        dt, dtheta = imu.between(t0, t1)
        assert dt.sum() == pytest.approx(t1 - t0)
        for axis in range(3):
            at = np.interp([t0, t1], np.arange(101) * 0.01, cumulative[:, axis])
            assert dtheta[:, axis].sum() == pytest.approx(at[1] - at[0])
    assert len(imu.between(0.1, 0.2)[0]) == 10  # no slivers from the rounding of time tags
    with pytest.raises(BoresightError, match=r"does not cover 0.9500 s to 1.0500 s .0.0500 s"):
        imu.between(0.95, 1.05)


def test_importing_recordings_is_light():
    code = "import sys, boresight.runtime.recording; print(*{m.split('.')[0] for m in sys.modules})"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"pandas", "pyarrow", "scipy.stats", "pydantic", "matplotlib", "sympy", "casadi"} & set(loaded)


# ---------------------------------------------------------------- the real recordings


def test_fog_mems_specific_force_is_gravity():
    """In the master's NED, less its acceleration and the author's bias, what is left is gravity, upwards."""
    recording = read(real_recording("fog_mems_transfer.npz"))
    mean = recording.imu.rates()[1].mean(axis=0)
    assert mean[2] == pytest.approx(-9.466, abs=0.001)  # along body down, rolling to 33 deg
    gravity = gravity_in_ned(recording.imu, recording.master)
    np.testing.assert_allclose(gravity, [0, 0, -9.7966], atol=0.07)  # normal gravity at 34.4 deg and 170 m
    bias = recording.reference["accel_bias"]
    unbiased = replace(recording.imu, accel=recording.imu.accel - bias * recording.imu.dt)
    _, east, down = gravity_in_ned(unbiased, recording.master)
    assert abs(down + 9.7966) < 0.02
    assert abs(east) < 0.03


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_fog_mems_slave_turns_as_its_master_axis_by_axis(axis):
    """Slope and correlation near one on every axis, once the 15 ms that the master is late are taken off."""
    recording = read(real_recording("fog_mems_transfer.npz"))
    recording = shifted(recording, 0.0155)
    imu, master = recording.imu, recording.master
    # The slave's increments are simply summed: over 0.1 s the order of such small turns does not matter.
    C = Rotation.from_matrix(rotation.matrix_from_euler(master.euler))
    turn = (C[:-1].inv() * C[1:]).as_rotvec()[5:-5]
    edges = zip(master.time[5:-6], master.time[6:-5], strict=True)
    slave = np.array([imu.between(a, b)[1].sum(axis=0) for a, b in edges])
    slope, _ = np.polyfit(turn[:, axis], slave[:, axis], 1)
    assert slope == pytest.approx(1, abs=0.01)
    assert np.corrcoef(turn[:, axis], slave[:, axis])[0, 1] > 0.997
    for other in {0, 1, 2} - {axis}:
        assert abs(np.corrcoef(turn[:, other], slave[:, axis])[0, 1]) < 0.4


def test_fog_mems_is_free_of_errors_and_its_master_is_seen_to_be_late():
    recording = read(real_recording("fog_mems_transfer.npz"), strict=False)
    assert levels(recording, "error") == levels(recording, "warning") == []
    delay, gain = best_delay(recording.imu, recording.master)
    assert delay == pytest.approx(0.0155, abs=0.001)
    assert gain > 5


@pytest.mark.parametrize(
    ("spoil", "says"),
    [
        (lambda r: replace(r, imu=replace(r.imu, kind="rates")), "increments declared as rates"),
        (lambda r: replace(r, imu=replace(r.imu, gyro=r.imu.gyro / DEG)), "unit"),
        (lambda r: replace(r, imu=replace(r.imu, gyro=-r.imu.gyro)), "sign"),
        (lambda r: replace(r, imu=replace(r.imu, gyro=r.imu.gyro[:, [1, 0, 2]])), "axes"),
        (lambda r: replace(r, imu=replace(r.imu, accel=-r.imu.accel)), "imu.body or the sign"),
        (lambda r: replace(r, imu=replace(r.imu, accel=r.imu.accel / 9.80665)), "g declared as m/s"),
        (lambda r: replace(r, master=replace(r.master, euler=r.master.euler / DEG)), "degrees declared as radians"),
        (lambda r: replace(r, master=replace(r.master, euler=r.master.euler * [1, 1, -1])), "yaw"),
        (lambda r: replace(r, master=replace(r.master, v_n=r.master.v_n[:, [1, 0, 2]])), "exchanged"),
        (lambda r: replace(r, master=replace(r.master, position=r.master.position / DEG)), "latitude"),
        (lambda r: shifted(r, 1000.0), "no overlap"),
    ],
)
def test_each_wrong_reading_of_the_fog_mems_recording_is_seen(spoil, says):
    recording = read(real_recording("fog_mems_transfer.npz"))
    assert any(says in text for text in levels(spoil(recording), "error"))


def test_the_foot_mounted_imu_needs_no_master():
    recording = read(real_recording("foot_mounted_square.npz"))
    assert recording.master is None
    notes = levels(recording, "note")
    assert any("quiet for" in text and "specific force 9.82" in text for text in notes)


def test_a_bare_name_is_looked_up_under_boresight_data(tmp_path, describe, monkeypatch):
    describe()
    monkeypatch.setenv("BORESIGHT_DATA", str(tmp_path))
    monkeypatch.chdir(tmp_path.parent)
    assert read("drive.toml").name == "drive"


# ---------------------------------------------------------------- bad input


def refused(path, *words):
    with pytest.raises(BoresightError) as error:
        read(path)
    text = str(error.value)
    assert "\n" not in text
    for word in words:
        assert word in text


@pytest.mark.parametrize(
    ("replaced", "words"),
    [
        (("fz", "up"), ["slave.csv", "imu.accel", "'up'", "it has t, wx"]),
        (('"deg/s"', '"furlongs"'), ["imu.gyro", "'furlongs'", "deg/h"]),
        (('"g"', '"g" , scale = 2'), ["drive.toml", "imu.accel.scale", "not a key"]),
        (('kind = "rates"', 'kind = "raw"'), ["drive.toml", "imu.kind", "'raw'"]),
        (('kind = "rates"\n', ""), ["drive.toml", "imu.kind", "missing"]),
        (('time_marks = "end"\n', ""), ["imu.time_marks", "missing"]),
        (('"FLU"', '"FRU"'), ["imu.body", "'FRU'", "right-handed"]),
        (('"NED"', '"EEE"'), ["master.navigation", "'EEE'"]),
        (('"wx", "wy", "wz"', '"wx", "wy"'), ["imu.gyro", "3 columns"]),
        (("[imu]", "[imu"), ["drive.toml", "not TOML"]),
        (('file = "slave.csv"\n', ""), ["drive.toml", "no data file"]),
        (("slave.csv", "other.csv"), ["other.csv", "no such file"]),
        (("slave.csv", "drive.toml"), ["drive.toml", "cannot be read; use"]),
        (('unit = "deg" }\nvelocity', 'unit = "deg", order = "yaw pitch" }\nvelocity'), ["master.attitude", "order"]),
        (('"roll", "pitch", "heading"', '"roll", "roll", "heading"'), ["master.attitude", "'roll'", "twice"]),
        (('["fx", "fy", "fz"]', '["wx", "fy", "fz"]'), ["imu.gyro and imu.accel", "'wx'"]),
        (('["vn", "ve", "vd"]', '["t", "ve", "vd"]'), ["master.time and master.velocity", "'t'"]),
        # three angles are those of an aircraft; where the axes would have others the description says which
        (('body = "FRD"', 'body = "FLU"'), ["master.attitude", "FLU", 'pitch_positive = "up"']),
        (('"NED"', '"ENU"'), ["master.attitude", "FRD", "ENU", 'yaw_from = "north"']),
        (('body = "FRD"', 'body = "BLD"'), ["master.attitude", "BLD", "quaternion"]),
    ],
)
def test_a_bad_description_is_one_line(describe, replaced, words):
    refused(describe(replaced), *words)


def spoilt(frame, row, column, value):
    out = frame.copy()
    out.loc[row, column] = value
    return out


@pytest.mark.parametrize(
    ("frame", "words"),
    [
        (spoilt(table(), 50, "t", np.nan), ["imu.time", "row 50"]),
        (spoilt(table(), 50, "t", 100.0), ["imu.time", "backwards after 0.5000 s", "sort"]),
        (spoilt(table(), 50, "t", 500.0), ["imu.time", "repeated at 0.5000 s"]),
        (spoilt(table(), 50, "wy", np.nan), ["imu.gyro", "row 50"]),
        (spoilt(table(), 50, "wy", np.inf), ["imu.gyro", "row 50"]),
        (table().drop(index=range(80, 90)), ["imu.time", "1 gap after 0.8000 s", "0.1100 s"]),
        (table().assign(wx="left"), ["imu.gyro", "'wx'", "not numeric"]),
        (table(1), ["imu.time", "at least 2"]),
        (table().assign(t=table().t / 1e6), ["imu.time", "unit of time"]),
        (table().assign(fz=9.8), ["imu.accel", "m/s^2 declared as g"]),
        (table().assign(fz=-1.0), ["imu.accel", "sign"]),
    ],
)
def test_bad_inertial_data_is_one_line(describe, frame, words):
    refused(describe(slave=frame), *words)


@pytest.mark.parametrize(
    ("frame", "words"),
    [
        (spoilt(master_table(), 5, "pitch", np.nan), ["master.attitude", "row 5"]),
        (spoilt(master_table(), 5, "t", 0.1), ["master.time", "backwards after 0.4000 s"]),
        (master_table().assign(t=master_table().t + 100), ["master.time", "no overlap"]),
        (master_table().drop(columns="vn"), ["master.csv", "master.velocity", "'vn'"]),
    ],
)
def test_a_bad_master_is_one_line(describe, frame, words):
    refused(describe(master=frame), *words)


@pytest.mark.parametrize("wrong", [False, True])
def test_a_height_that_goes_against_the_vertical_velocity_is_an_error(describe, wrong):
    frame = master_table()
    omega = 2 * np.pi / frame.t.iloc[-1]
    climbs = 10 * np.sin(omega * frame.t)  # m/s
    frame = frame.assign(vd=climbs if wrong else -climbs, h=200 + 10 / omega * (1 - np.cos(omega * frame.t)))
    path = describe(master=frame)
    if wrong:
        refused(path, "master.position", "height", "--allow path")
    else:
        read(path)


def test_a_gap_of_the_master_is_a_warning_with_its_time(describe):
    recording = read(describe(master=master_table().drop(index=[7, 8])))
    assert any("1 gap after 0.6000 s" in text for text in levels(recording, "warning"))


def test_a_missing_file_an_undescribed_one_and_a_broken_one(tmp_path):
    refused(tmp_path / "none.npz", "none.npz", "no such file", "BORESIGHT_DATA")
    folder = tmp_path / "folder"
    folder.mkdir()
    refused(folder, "a folder", "no description")
    for name, words in (
        ("a.toml", ["a folder; did you mean", "folder/a.toml?"]),
        ("b.toml", ["one of a.toml, b.toml"]),
    ):
        (folder / name).touch()
        refused(folder, *words)
    np.savez(tmp_path / "unknown.npz", time=np.arange(3), gyro=np.zeros((3, 3)), accel=np.zeros((3, 3)))
    refused(tmp_path / "unknown.npz", "not described", "unknown.toml")
    (tmp_path / "broken.npz").write_bytes(b"not a zip")
    refused(tmp_path / "broken.npz", "cannot be read as npz")


def test_arrays_of_wrong_shape_are_one_line(tmp_path):
    toml = TOML.replace('["wx", "wy", "wz"]', '"gyro"').replace('["fx", "fy", "fz"]', '"accel"')
    (tmp_path / "a.toml").write_text(toml.format(file="a.npz"))
    np.savez(tmp_path / "a.npz", t=np.arange(5.0), gyro=np.zeros((5, 4)), accel=np.zeros((5, 3)))
    refused(tmp_path / "a.toml", "imu.gyro needs 3 columns", "(5, 4)")
    np.savez(tmp_path / "a.npz", t=np.arange(5.0), gyro=np.zeros((4, 3)), accel=np.zeros((5, 3)))
    refused(tmp_path / "a.toml", "imu.gyro has 4 rows and imu.time 5")


def test_a_recording_made_by_hand_checks_its_shapes():
    with pytest.raises(BoresightError, match=r"gyro has shape \(5, 2\)"):
        Inertial("rates", "end", np.arange(5.0), np.zeros((5, 2)), np.zeros((5, 3)))
    imu = Inertial("rates", "end", np.arange(1, 101) * 0.01, np.zeros((100, 3)), np.tile([0, 0, -9.8], (100, 1)))
    still = Recording("bench", imu, Master(np.arange(10) * 0.1, np.zeros((10, 3))))
    assert levels(still, "error") == []


def test_the_example_is_a_description():
    said = description.load(ROOT / "runtime" / "recording" / "built_in" / "template.toml")
    assert said.master is not None
    assert said.master.attitude.order == "yaw pitch roll"
