"""Recordings as they are: cut, bridged, jittered, dated, in metres, uncalibrated, of points, noisy; each read rightly.

Flown by the independent motion of `evidence.flights`: what a slave's samples are is known without the reader.
"""

import re
from dataclasses import replace
from datetime import UTC, datetime, timedelta, timezone
from functools import cache

import numpy as np
import pandas as pd
import pymap3d
import pytest

from boresight import BoresightError
from boresight.analysis.figures import Sheets
from boresight.cli import main
from boresight.evidence.flights.motion import Motion, swinging, waves
from boresight.runtime import rotation
from boresight.runtime.library import load
from boresight.runtime.recording import attitude_increments, best_delay, check, read
from boresight.runtime.recording.check import slope_of
from boresight.runtime.units import ARCMIN, DEG
from boresight.studies.replays import euler_matching, stationary, velocity_attitude
from boresight.studies.replays.innovations import most_likely

SECONDS = 30.0
BEGAN = 1714557600  # 2024-05-01T10:00:00Z
TOML = """
title = "drive"
[imu]
file = "imu.npz"
kind = "rates"
time_marks = "end"
body = "FRD"
time = { columns = "t", unit = "s" }
gyro = { columns = "gyro", unit = "rad/s" }
accel = { columns = "accel", unit = "m/s^2" }
[master]
file = "ins.npz"
body = "FRD"
navigation = "NED"
time = { columns = "t", unit = "s" }
attitude = { columns = "euler", unit = "rad" }
velocity = { columns = "v_n", unit = "m/s" }
position = { columns = "position", unit = "rad" }
"""


def flown(motion, imu_hz=100, master_hz=10, seconds=SECONDS):
    """Arrays of a slave's mean rates, tagged at the end of each sample, and of its master; aligned, on one clock."""
    edges = np.arange(round(seconds * imu_hz) + 1) / imu_hz
    dtheta, dv = motion.increments(edges)
    t = np.arange(1, round(seconds * master_hz)) / master_hz
    v_n, C = motion.master(t, np.zeros(3), np.eye(3))
    ins = {"t": t, "euler": rotation.euler_from_matrix(C), "v_n": v_n, "position": motion.position(t)}
    return {"t": edges[1:], "gyro": dtheta * imu_hz, "accel": dv * imu_hz}, ins


IMU, INS = flown(swinging(seconds=SECONDS))


@pytest.fixture
def describe(tmp_path):
    """Write a slave, a master and a description with some words replaced; returns the description's path."""

    def write(*replaced, imu=IMU, ins=INS, toml=TOML):
        for name, arrays in (("imu", imu), ("ins", ins)):
            np.savez(tmp_path / f"{name}.npz", **arrays)
        for old, new in replaced:
            assert old in toml, old
            toml = toml.replace(old, new)
        path = tmp_path / "drive.toml"
        path.write_text(toml)
        return path

    return write


TOP = 'title = "drive"'


def refused(path, *words, **settings):
    with pytest.raises(BoresightError) as error:
        read(path, **settings)
    assert "\n" not in str(error.value)
    for word in words:
        assert word in str(error.value)


def found(recording, level):
    return [f"{finding.where}: {finding.text}" for finding in check(recording) if finding.level == level]


def without(arrays, rows):
    return {name: np.delete(value, rows, axis=0) for name, value in arrays.items()}


def test_what_is_flown_is_healthy(describe):
    recording = read(describe())
    assert found(recording, "error") == found(recording, "warning") == []
    assert recording.epoch == 0 and recording.notes == ()


# ---------------------------------------------------------------- cut


@pytest.mark.parametrize("where", ["in the description", "by the caller"])
@pytest.mark.parametrize(
    ("begin", "end"),
    [
        (5.0, 20.0),
        ("5 s", "20000 ms"),
        (f"{BEGAN + 5} s", float(BEGAN + 20)),
        ("2024-05-01T12:00:05+02:00", "2024-05-01T10:00:20Z"),
        (datetime(2024, 5, 1, 10, 0, 5, tzinfo=UTC), "20"),
    ],
)
def test_a_recording_is_cut_in_the_time_that_is_shown_and_in_its_own(describe, where, begin, end):
    dated = [{**arrays, "t": arrays["t"] + BEGAN} for arrays in (IMU, INS)]
    toml = "\n".join(f"{key} = {v.isoformat() if isinstance(v, datetime) else repr(v)}"
                     for key, v in (("from", begin), ("to", end))).replace("'", '"')  # fmt: skip
    said = [(TOP, f"{TOP}\n{toml}")] if where == "in the description" else []
    recording = read(describe(*said, imu=dated[0], ins=dated[1]), **({} if said else {"begin": begin, "end": end}))
    for time in (recording.imu.time, recording.master.time):
        assert time[0] == pytest.approx(5.0, abs=2e-6) and time[-1] == pytest.approx(20.0, abs=2e-6)
    assert recording.epoch == BEGAN
    assert any(note.startswith("cut to 5.000 s to 20.000 s") for note in recording.notes)


def test_a_cut_that_leaves_nothing_and_one_that_is_no_time_are_one_line(describe):
    refused(describe(), "from and to leave 0 samples", "0.010 s to 30.000 s", begin="100 s")
    refused(describe(), "from is 'noon'", "12.5 s", begin="noon")
    refused(describe(), "from is a date", begin="2024-05-01T10:00:00Z")
    refused(describe(), "from is 'nan s'", "not finite", begin="nan s")


@pytest.mark.parametrize("bridge", ["-3 ms", -0.003, float("nan")])
def test_a_bridge_that_is_no_time_is_one_line(describe, bridge):
    refused(describe(), "bridge", "0 or more", bridge=bridge)


# ---------------------------------------------------------------- bridged


def test_one_missing_sample_is_bridged_only_where_it_is_stated(describe):
    path = describe(imu=without(IMU, [1000]))
    refused(path, "1 gap after 10.0000 s", 'bridge = "10 ms"', "--allow gap")
    refused(path, "1 gap", bridge="9 ms")
    recording = read(path, bridge="10 ms")
    np.testing.assert_allclose(recording.imu.time, IMU["t"], atol=1e-12)
    assert np.flatnonzero(recording.imu.doubt.any(axis=1)).tolist() == [1000]
    assert any("1 gap of 10 ms bridged, the first after 10.000 s" in note for note in found(recording, "note"))


def test_a_sample_that_is_no_number_is_bridged_like_one_that_is_missing(describe):
    spoilt = {**IMU, "gyro": IMU["gyro"].copy()}
    spoilt["gyro"][1000, 1] = np.nan
    refused(describe(imu=spoilt), "imu.gyro", "row 1000")
    again, missing = read(describe(imu=spoilt), bridge=0.01).imu, read(describe(imu=without(IMU, [1000])), bridge=0.01)
    for name in ("time", "gyro", "accel", "doubt"):
        np.testing.assert_array_equal(getattr(again, name), getattr(missing.imu, name))


def test_what_a_bridge_misses_is_as_large_as_it_doubts(describe):
    """Sixty gaps of five samples in a lively motion: what is filled in against what truly was, in its own sigmas."""
    motion = Motion(swing=waves(([0.1, 0.05, 0.1], [0.9, 1.3, 0.7], [0.3, 1.2, 2.1])),
                    sway=waves(([0.5, 0.4, 0.3], [0.8, 1.1, 1.5], [0, 1, 2])), seconds=SECONDS)  # fmt: skip
    imu, ins = flown(motion)
    starts = np.arange(20, 2980, 49)
    rows = (starts[:, None] + np.arange(5)).ravel()
    recording = read(describe(imu=without(imu, rows), ins=ins), bridge="50 ms").imu
    np.testing.assert_allclose(recording.time, imu["t"], atol=1e-12)
    for part, name in enumerate(("gyro", "accel")):
        missed = (imu[name] - getattr(recording, name))[rows].reshape(-1, 5, 3).sum(axis=1) * 0.01
        doubt = np.sqrt((recording.doubt[rows, part] ** 2).reshape(-1, 5).sum(axis=1))
        worst = np.sqrt(np.mean((missed / doubt[:, None]) ** 2, axis=0)).max()
        assert 0.8 < worst < 1.25
    assert not recording.doubt[np.setdiff1d(np.arange(3000), rows)].any()


def test_a_filter_opens_its_covariance_by_what_a_bridge_may_have_missed(describe, library):
    recording = read(describe(imu=without(IMU, [1000, 1001, 1002])), bridge="30 ms")
    leg = euler_matching.prepare(recording, library, np.zeros(3))
    k = np.flatnonzero(leg.doubt)
    assert leg.time[k[0]] == pytest.approx(10.0) and leg.doubt.sum() == pytest.approx(
        (recording.imu.doubt[:, 0] ** 2).sum()
    )
    sure = euler_matching.Leg(**{**vars(leg), "doubt": 0 * leg.doubt})
    opened, shut = (euler_matching.fly(one, library, np.full(3, 1e-7), np.full(3, 1e-5), "euler_exact")["sigma"]
                    for one in (leg, sure))  # fmt: skip
    assert (opened[k[0], :3] > shut[k[0], :3]).all()
    np.testing.assert_array_equal(opened[: k[0]], shut[: k[0]])


def test_transfer_alignment_opens_its_covariance_by_what_a_bridge_may_have_missed(describe):
    recording = read(describe(imu=without(IMU, np.arange(1000, 1010))), bridge="100 ms", begin=9.0, end=11.2)
    given = {"gyro": 1e-6, "accel": 1e-5, "velocity": 0.01, "attitude": 1e-4, "delay": 1e-6}
    noises, _ = velocity_attitude.noise_vector(given)
    sigmas = []
    for one in (recording, replace(recording, imu=replace(recording.imu, doubt=None))):
        cut = velocity_attitude.prepare(one, None)
        track = velocity_attitude.fly(
            cut, load("velocity-attitude"), noises, np.zeros(19), velocity_attitude.PRIOR, 0.0
        )
        sigmas.append(track["sigma"])
    opened, shut = sigmas
    k = int(np.searchsorted(track["time"], 9.95))  # handed over behind the gap
    np.testing.assert_allclose(opened[: k - 2], shut[: k - 2], rtol=1e-12)
    assert (opened[k + 1, :6] > 1.0001 * shut[k + 1, :6]).all()


def test_jittered_tags_of_a_regular_clock_are_no_gaps(describe):
    rng = np.random.default_rng(5)
    late = {**IMU, "t": IMU["t"] + rng.uniform(0, 9.9e-3, len(IMU["t"]))}  # and none overtakes another
    refused(describe(imu=late), "gaps", 'clock = "regular"')
    said = read(describe(("[imu]", '[imu]\nclock = "regular"'), imu=late))
    for recording in (read(describe(imu=late), regular=True), said):
        behind = recording.imu.time - IMU["t"]
        assert np.std(behind) < 0.5e-3  # what is late on average stays: a delay
        assert np.diff(recording.imu.time).std() < 1e-5
        assert any("regular clock of" in note for note in recording.notes)


# ---------------------------------------------------------------- dates


def stamped(unit, seconds, zone=UTC):
    if unit == "iso":
        first = datetime.fromtimestamp(BEGAN, zone)
        return np.array([(first + timedelta(microseconds=round(s * 1e6))).isoformat() for s in seconds])
    whole = np.array([BEGAN * 10**9 + round(s * 1e9) for s in seconds], np.int64)
    return {"s": whole / 1e9, "ms": whole / 1e6, "us": whole // 1000, "ns": whole}[unit]


@pytest.mark.parametrize("unit", ["s", "ms", "us", "ns", "iso"])
def test_dates_of_any_unit_count_from_one_epoch(describe, unit):
    """The master's are dates with a zone of their own."""
    zone = timezone(timedelta(hours=-7))
    imu_part, master_part = TOML.split("[master]")
    toml = imu_part.replace('unit = "s"', f'unit = "{unit}"') + "[master]" + master_part.replace('"s"', '"iso"')
    imu, ins = ({**arrays, "t": stamped(kind, arrays["t"], where)}
                for arrays, kind, where in ((IMU, unit, UTC), (INS, "iso", zone)))  # fmt: skip
    recording = read(describe(imu=imu, ins=ins, toml=toml))
    np.testing.assert_allclose(recording.imu.time, IMU["t"], atol=5e-7)
    np.testing.assert_allclose(recording.master.time, INS["t"], atol=1e-12)
    assert recording.notes[0].startswith("times count from 2024-05-01T10:00:00Z")
    assert any("0.010 s to 30.000 s" in note for note in found(recording, "note"))
    gap = without(imu, [1000])
    refused(describe(imu=gap, ins=ins, toml=toml), "gap after 10.0000 s")


def ticks(recording, folder):
    """The words and numbers in the figure of a replay."""
    sheets = Sheets(folder, svg=True)
    stationary.figures(stationary.run(recording, rest=tuple(recording.imu.time[[0, 300]])), sheets)
    return re.findall(r"<text[^>]*>([^<]+)</text>", sheets.written[0].read_text())


def test_the_time_axis_of_a_replay_counts_from_the_epoch_of_its_dates(describe, tmp_path):
    imu, ins = ({**arrays, "t": BEGAN + arrays["t"]} for arrays in (IMU, INS))
    recording = read(describe(imu=imu, ins=ins))
    shown = ticks(recording, tmp_path)
    assert {"10", "20", "30"} <= set(shown) and not any("e9" in word for word in shown)
    dates = replace(recording, imu=replace(recording.imu, time=BEGAN + recording.imu.time))
    assert any("e9" in word for word in ticks(dates, tmp_path))  # an axis that was not would say so


def test_a_clock_that_shows_dates_and_one_that_does_not_are_one_line(describe):
    refused(describe(imu={**IMU, "t": IMU["t"] + BEGAN}), "imu.time shows dates and master.time does not")
    text = {**IMU, "t": stamped("iso", IMU["t"])}
    refused(describe(imu=text), "imu.time", "begins with '2024-05-01T10:00:00", 'unit = "iso"')
    text["t"][5] = "later"
    refused(
        describe(('"t", unit = "s" }\ngyro', '"t", unit = "iso" }\ngyro'), imu=text), "imu.time", "a date is written"
    )


# ---------------------------------------------------------------- places


@pytest.mark.parametrize("frame", ["NED", "ENU"])
def test_local_metres_become_a_place_by_one_latitude(describe, frame):
    """Against the local tangent plane of pymap3d, which bends away by 1e-6 of the way here."""
    lat, lon, height = (float(x) for x in (*np.degrees(INS["position"][0, :2]), INS["position"][0, 2]))
    degrees = np.degrees(INS["position"])
    enu = np.stack(pymap3d.geodetic2enu(degrees[:, 0], degrees[:, 1], INS["position"][:, 2], lat, lon, height), -1)
    to = np.array([[0, 1, 0], [1, 0, 0], [0, 0, -1]])  # either way
    ins = {**INS, "position": enu, "v_n": INS["v_n"] @ to}
    if frame == "NED":
        ins = {**INS, "position": enu @ to}
    origin = f"origin = {{ latitude = {lat!r}, longitude = {lon!r}, height = {height!r} }}"
    metres = ('"position", unit = "rad" }', f'"position", unit = "m" }}\n{origin}')
    changes = [metres, ('navigation = "NED"', f'navigation = "{frame}"')]
    changes.append(('"euler", unit = "rad"', '"euler", unit = "rad", yaw_from = "north"'))
    got = read(describe(*changes, ins=ins)).master
    np.testing.assert_allclose(got.position[:, :2], INS["position"][:, :2], atol=2e-9)  # 1 cm
    np.testing.assert_allclose(got.position[:, 2], INS["position"][:, 2], atol=0.02)
    np.testing.assert_allclose(got.v_n, INS["v_n"], atol=1e-12)
    refused(describe(('"position", unit = "rad"', '"position", unit = "m"'), ins=ins), "metres", "origin", "latitude")


def test_a_master_that_never_says_where_it_is_takes_the_origin(describe):
    alone = ('position = { columns = "position", unit = "rad" }', "origin = { latitude = 40.1 }")
    recording = read(describe(alone))
    np.testing.assert_allclose(recording.master.position, np.tile([np.radians(40.1), 0, 0], (len(INS["t"]), 1)))
    refused(describe((alone[0], "origin = { latitude = 140.1 }")), "origin.latitude is 140.1 deg")


# ---------------------------------------------------------------- calibrated


BIAS = np.array([0.5, -3.0, 1.4]) * DEG  # rad/s, beyond what a model's gyro bias may be
SCALE = np.array([0.02, -0.01, 0.005])
AXES = np.array([[1, 0.01, -0.02], [0, 1, 0.015], [0.005, 0, 1]])


@pytest.mark.parametrize("kind", ["rates", "increments"])
def test_a_known_calibration_is_taken_off_every_sample(describe, kind):
    """In the body axes of the file: here right, front, up."""
    to_rfu = np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]])
    share = 1.0 if kind == "rates" else 0.01
    delivered = {"t": IMU["t"], "accel": IMU["accel"] @ to_rfu.T * share}
    delivered["gyro"] = ((IMU["gyro"] @ to_rfu.T) @ np.linalg.inv(AXES).T * (1 + SCALE) + BIAS) * share
    calibration = f"""
[calibration]
gyro_bias = {{ values = {(BIAS / DEG).tolist()}, unit = "deg/s" }}
gyro_scale = {{ values = {(SCALE * 1e6).tolist()}, unit = "ppm" }}
gyro_matrix = {{ values = {AXES.tolist()}, unit = "1" }}
"""
    units = [] if kind == "rates" else [('"rates"', '"increments"'), ('"rad/s"', '"rad"'), ('"m/s^2"', '"m/s"')]
    toml = TOML.replace("FRD", "RFU", 1) + calibration
    recording = read(describe(*units, imu=delivered, toml=toml))
    np.testing.assert_allclose(recording.imu.gyro, IMU["gyro"] * share, atol=1e-12)
    np.testing.assert_allclose(recording.imu.accel, IMU["accel"] * share, atol=1e-12)
    assert "imu: gyro_matrix, gyro_scale, gyro_bias taken off" in recording.notes


def test_a_bias_that_no_model_takes_says_what_it_is_and_what_to_do(describe):
    """Within 0.05 deg/s: the recording is half a minute, and the master's own noise is none."""
    path = describe(imu={**IMU, "gyro": IMU["gyro"] + BIAS})
    refused(path, "turns by [+0.50", "-3.00", "+1.39", "[calibration] gyro_bias", "--allow bias")
    known = f"\n[calibration]\ngyro_bias = {{ values = {BIAS.tolist()}, unit = 'rad/s' }}\n"
    assert found(read(describe(toml=TOML + known, imu={**IMU, "gyro": IMU["gyro"] + BIAS})), "error") == []


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ("gyro_bias = { values = [1, 2], unit = 'deg/s' }", ["calibration.gyro_bias", "3 numbers", "(2,)"]),
        ("gyro_bias = { columns = 'b', unit = 'deg/s' }", ["calibration.gyro_bias", "'b'", "no such array"]),
        ("gyro_bias = { unit = 'deg/s' }", ["calibration.gyro_bias", "columns or values"]),
        ("gyro_scale = { values = [1, 2, 3], unit = 'pmm' }", ["did you mean 'ppm'"]),
        ("gyro_matrix = { values = [[1, 0], [0, 1]], unit = '1' }", ["3 rows of 3 numbers"]),
        ("gyro_scale = { values = [-1, 0, 0], unit = '1' }", ["calibration.gyro_scale", "-1", "every sample zero"]),
        ("gyro_bias = { values = [nan, 0, 0], unit = 'deg/s' }", ["calibration.gyro_bias", "not finite"]),
    ],
)
def test_a_calibration_that_cannot_be_is_one_line(describe, said, words):
    refused(describe(toml=f"{TOML}\n[calibration]\nfile = 'imu.npz'\n{said}\n"), *words)


# ---------------------------------------------------------------- text as it is written


@pytest.mark.parametrize(
    ("delimiter", "decimal", "sep"),
    [(";", ",", ";"), (";", ".", ";"), ("tab", ",", "\t"), ("whitespace", ".", "   "), ("\\t", ".", "\t")],
)
def test_separators_and_decimal_commas(describe, tmp_path, delimiter, decimal, sep):
    frame = pd.DataFrame({"t": IMU["t"]} | {f"{n}{i}": IMU[n][:, i] for n in ("gyro", "accel") for i in range(3)})
    text = [sep.join(frame), *(sep.join(f"{x:.12g}".replace(".", decimal) for x in row) for row in frame.to_numpy())]
    (tmp_path / "imu.txt").write_text("\ufeff" + "\n".join(text))
    three = [(f'"{name}"', str([f"{name}{i}" for i in range(3)])) for name in ("gyro", "accel")]
    said = (TOP, f'{TOP}\ndelimiter = "{delimiter}"\ndecimal = "{decimal}"')
    recording = read(describe(said, ("imu.npz", "imu.txt"), *three))
    np.testing.assert_allclose(recording.imu.gyro, IMU["gyro"], atol=1e-11)
    if decimal == ",":
        refused(describe((TOP, f'{TOP}\ndelimiter = "{delimiter}"'), ("imu.npz", "imu.txt"), *three), 'decimal = ","')


@pytest.mark.parametrize(
    ("line", "words"),
    [
        (lambda row, cells: "" if row else None, ["'t'", "no rows"]),
        (lambda row, cells: [*cells, ""] if row else cells, ["more cells than its header has names"]),
        (lambda row, cells: [*cells[:2], "--", *cells[3:]] if row == 8 else cells, ["'gyro1'", "row 7", "'--'"]),
        (lambda row, cells: cells, ['decimal = "."']),
    ],
)
def test_text_that_is_not_what_is_said_is_told_by_its_cause(describe, tmp_path, line, words):
    frame = pd.DataFrame({"t": IMU["t"]} | {f"{n}{i}": IMU[n][:, i] for n in ("gyro", "accel") for i in range(3)})
    rows = [list(frame), *([f"{x:.12g}" for x in row] for row in frame.to_numpy()[:20])]
    rows = [line(row, cells) if line(row, cells) is not None else cells for row, cells in enumerate(rows)]
    (tmp_path / "imu.csv").write_text("\n".join(";".join(cells) for cells in rows if cells) + "\n")
    three = [(f'"{name}"', str([f"{name}{i}" for i in range(3)])) for name in ("gyro", "accel")]
    decimal = "," if "decimal" in words[0] else "."
    said = (TOP, f'{TOP}\ndelimiter = ";"\ndecimal = "{decimal}"')
    refused(describe(said, ("imu.npz", "imu.csv"), *three), *words)


@pytest.mark.parametrize(
    ("replaced", "words"),
    [
        ((TOP, "tittle = 'drive'"), ["tittle is not a key", "did you mean 'title'", "bridge"]),
        (("kind =", "kinds ="), ["imu.kinds is not a key", "did you mean 'kind'", "time_marks"]),
        (("navigation =", "frame ="), ["master.frame is not a key", "there are file, time, rate"]),
        (('"euler", unit', '"euler", units'), ["master.attitude.units", "did you mean 'unit'", "yaw_positive"]),
        (("gyro = {", "gyros = {"), ["imu.gyros", "did you mean 'gyro'"]),
        (('"rad/s"', '"deg/sec"'), ["imu.gyro", "'deg/sec'", "did you mean 'deg/s'"]),
        (('"m/s^2"', '"m/s2"'), ["imu.accel", "did you mean 'm/s^2'"]),
        (('"gyro"', '"gyroo"'), ["no column 'gyroo'", "did you mean 'gyro'", "it has t, gyro, accel"]),
        (('"end"', '"ends"'), ["imu.time_marks", "'ends'", "'point'"]),
    ],
)
def test_what_is_not_known_is_named_with_what_was_meant(describe, replaced, words):
    refused(describe(replaced), *words)


def test_of_many_columns_forty_are_named(describe):
    names = ["t", "gyro", "accel", *(f"spare{i}" for i in range(42))]
    imu = {name: np.arange(3.0) if name == "t" else np.zeros((3, 3)) for name in names}
    refused(describe(('"gyro"', '"gyroo"'), imu=imu), f"{names[39]} and 5 more")


# ---------------------------------------------------------------- samples at instants


def test_samples_at_instants_are_joined_without_half_a_sample_of_delay(describe):
    """50 Hz: taken for means that end at their tag, they make the master 10 ms older than it is."""
    motion = swinging(seconds=SECONDS)
    t = np.arange(round(SECONDS * 50) + 1) / 50
    omega, force, _ = motion.rates(t)
    ideal = motion.increments(t)
    imu = {"t": t, "gyro": omega, "accel": force}
    point = read(describe(('"end"', '"point"'), imu=imu)).imu
    assert point.kind == "increments" and point.time_marks == "end"
    _, _, dtheta, dv = point.increments
    for got, true, trapezoid in ((dtheta, ideal[0], omega), (dv, ideal[1], force)):
        worst = np.abs(got - true)[2:-2].max()
        line = np.abs((trapezoid[1:] + trapezoid[:-1]) / 2 / 50 - true)[2:-2].max()
        assert worst < line / 50  # fourth order beside second: measured 400 times better
    as_end = read(describe(imu=imu))
    late = [best_delay(imu, as_end.master)[0] for imu in (point, as_end.imu)]
    assert late[0] == pytest.approx(0.0, abs=0.3e-3)
    assert late[1] == pytest.approx(0.01, abs=0.3e-3)
    refused(describe(('"end"', '"point"'), ('"rates"', '"increments"'), ('"rad/s"', '"rad"'), ('"m/s^2"', '"m/s"')),
            "time_marks", "an increment has no instant")  # fmt: skip


def test_a_quantity_with_tags_of_its_own_is_brought_to_the_sections(describe):
    """Accelerometers at 62 Hz, attitude at 37 Hz, position once per second."""
    motion = swinging(seconds=SECONDS)
    ta, te, tp = (np.arange(0.0, SECONDS, step) for step in (1 / 62, 1 / 37, 1.0))
    imu = {**IMU, "accel": motion.rates(ta)[1], "ta": ta}
    ins = {**INS, "euler": motion.attitude(te)[0], "te": te, "position": motion.position(tp), "tp": tp}
    tagged = (("accel", "m/s^2", "ta"), ("euler", "rad", "te"), ("position", "rad", "tp"))
    changes = [(f'"{name}", unit = "{unit}"', f'"{name}", unit = "{unit}", time = "{t}"') for name, unit, t in tagged]
    got = read(describe(*changes, imu=imu, ins=ins))
    t = got.master.time
    turn = np.swapaxes(motion.C_b2n(t), -1, -2) @ rotation.matrix_from_euler(got.master.euler)
    assert np.abs(rotation.vector_from_matrix(turn)).max() < 0.05 * DEG
    np.testing.assert_allclose(got.master.position[:, :2], motion.position(t)[:, :2], atol=1e-7)
    np.testing.assert_allclose(got.imu.accel, motion.rates(got.imu.time)[1], atol=0.02)
    assert any("attitude and position: brought to the tags of master.time" in note for note in got.notes)
    refused(describe(*changes, imu={**imu, "ta": ta[:-1]}, ins=ins), "imu.accel has 1860 rows and its time 1859")


# ---------------------------------------------------------------- judged with noise in both


# Its heading moves by a tenth of a degree per second: by 1.1 arcmin between two messages at 5 Hz.
QUIET_TURNS = Motion(
    swing=waves(([2 * DEG, 0.5 * DEG, 0.19 * DEG], [0.17, 0.21, 0.11], [0.3, 1.2, 2.1])),
    steady=np.array([8.0, 3.0, 0.0]),
    seconds=120.0,
)


@cache
def quiet():
    return flown(QUIET_TURNS, master_hz=5, seconds=120.0)


def noisy(seed, arcmin):
    imu, ins = quiet()
    rng = np.random.default_rng(seed)
    return imu, {**ins, "euler": ins["euler"] + rng.normal(0, arcmin * ARCMIN, ins["euler"].shape)}


@pytest.mark.parametrize("arcmin", [0.0, 0.1, 0.5])
def test_a_healthy_recording_passes_whatever_noise_its_master_has(describe, arcmin):
    """At .5 arcmin the plain slope about down is .72."""
    imu, ins = noisy(3, arcmin)
    recording = read(describe(imu=imu, ins=ins))
    _, slave, turn = attitude_increments(recording.imu, recording.master)
    if arcmin == 0.5:
        assert np.polyfit(turn[:, 2], slave[:, 2], 1)[0] < 0.8
    lines = [line for line in found(recording, "note") if "slave over master" in line]
    assert len(lines) == (3 if arcmin == 0.5 else 2)  # with less it turns too little about down to be looked at
    for line in lines:
        slope, sigma, correlation = (
            float(line.split(word)[1].split()[0].strip(",")) for word in ("master ", "+- ", "correlation ")
        )
        assert abs(slope - 1) < 3 * sigma < 0.3 and correlation > 0.95


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (np.diag([1, 1, -1]), "down of its axes is mirrored"),
        (np.eye(3)[[0, 2, 1]], "right and down of its axes are exchanged"),
        (np.diag([1, 1, 2.0]), "turns about down"),
    ],
)
def test_a_wrong_axis_sign_or_unit_stays_an_error_with_noise_in_it(describe, spoil, words):
    imu, ins = noisy(3, 0.5)
    refused(describe(imu={**imu, "gyro": imu["gyro"] @ spoil.T}, ins=ins), words, "--allow turns")


def test_a_slope_with_noise_in_both_is_unbiased_and_knows_its_sigma():
    """200 recordings of 500 turns: as much noise as motion in half of them, a tenth as much in the others."""
    rng = np.random.default_rng(0)
    t = np.arange(501) * 0.2
    for noise, worst in ((0.5, 0.6), (0.16, 1.05)):
        got, plain = [], []
        for _ in range(100):
            angle = 9 * np.sin(0.5 * t + rng.uniform(0, 6)) + 1.6 * np.sin(1.7 * t)  # arcmin
            x = np.diff(angle + noise * rng.standard_normal(501))
            y = 1.1 * np.diff(angle) + 0.1 * rng.standard_normal(500)
            got.append(slope_of(x, y))
            plain.append(np.polyfit(x, y, 1)[0])
        slopes, sigmas = np.array([one.slope for one in got]), np.array([one.sigma for one in got])
        assert np.mean(plain) < worst
        assert np.mean(slopes) == pytest.approx(1.1, abs=3 * np.std(slopes) / 10)
        assert 0.6 < np.std(slopes) / np.mean(sigmas) < 1.2
        assert np.mean([one.noise for one in got]) == pytest.approx(noise, rel=0.05)


def test_each_judgement_is_overruled_by_its_name(describe):
    imu, ins = noisy(3, 0.5)
    turned = {**imu, "gyro": imu["gyro"] * [1, 1, -1]}
    refused(describe(imu=turned, ins=ins), "--allow turns", allow=["path"])
    for recording in (read(describe(imu=turned, ins=ins), allow=["turns"]),
                      read(describe((TOP, f'{TOP}\nallow = ["turns"]'), imu=turned, ins=ins))):  # fmt: skip
        assert any("(allowed: turns)" in line for line in found(recording, "warning"))
        assert found(recording, "error") == []
    refused(describe(), "allow: 'turn' is not the name of an error", "did you mean 'turns'", allow=["turn"])
    # nothing can be computed with these, whatever one allows
    backwards = {**IMU, "t": IMU["t"][::-1]}
    with pytest.raises(BoresightError, match="go backwards") as error:
        read(describe(imu=backwards))
    assert "--allow" not in str(error.value)


def test_a_vehicle_that_pitches_up_and_down_has_the_specific_force_of_gravity(describe):
    euler = waves(([0.1, 1.3, 0.0], 0.1, [0.0, 0.3, 0.0]))
    imu, ins = flown(Motion(swing=euler, steady=np.array([7.0, 4.0, 0.0])))
    assert found(read(describe(imu=imu, ins=ins)), "error") == []
    refused(describe(("m/s^2", "g"), imu=imu, ins=ins), "m/s^2 declared as g")


def test_a_vehicle_that_drives_evenly_is_not_at_rest(describe):
    """16 m/s straight ahead shakes no more than a parked one; its turning is no bias."""
    steady = Motion(steady=np.array([16.0, 0.0, 0.0]), yaw_rate=0.0, seconds=SECONDS)
    turning = Motion(steady=np.zeros(3), yaw_rate=1.35 * DEG, seconds=SECONDS)
    parked = Motion(seconds=SECONDS)
    for motion, rests in ((steady, False), (turning, False), (parked, True)):
        imu, ins = flown(motion)
        lines = found(read(describe(imu=imu, ins=ins)), "note")
        assert any("never at rest" in line for line in lines) != rests
        assert any("static bias" in line for line in lines) == rests


@pytest.mark.parametrize("hz", [100, 14.7])
def test_seconds_of_rest_are_seconds(describe, hz):
    """Windows of a second hold a whole number of samples, which is not a second at 14.7 Hz."""
    imu, ins = flown(Motion(seconds=SECONDS), imu_hz=hz)
    (line,) = [line for line in found(read(describe(imu=imu, ins=ins)), "note") if "quiet for" in line]
    assert float(line.split("quiet for ")[1].split(" s")[0]) == pytest.approx(SECONDS, abs=2.1)
    assert float(line.split("quiet for ")[1].split(" s")[0]) <= SECONDS


def test_pitch_beyond_80_deg_is_refused_by_models_that_match_euler_angles_alone(describe, library):
    steep = Motion(euler=np.array([0.1, 84 * DEG, 0.3]), swing=swinging().swing, seconds=SECONDS)
    imu, ins = flown(Motion(euler=steep.euler, swing=waves(([0.1, 0.04, 0.1], 0.2, [0, 1, 2])), seconds=SECONDS))
    recording = read(describe(imu=imu, ins=ins))
    assert any("pitch to 86" in line for line in found(recording, "warning"))
    with pytest.raises(BoresightError, match=r"pitches to 86\.\d deg.*velocity-attitude"):
        euler_matching.run(recording, library)


# ---------------------------------------------------------------- noises at their limit


def test_a_noise_that_ends_at_its_limit_is_one_that_may_be_given():
    """exp(log(1e-7)) is 9.999999999999994e-08, which nothing takes as 1e-7."""

    def flat(noises):  # less noise is always likelier
        S = np.tile(noises**2, (5, 1, 1))
        return {"nu": 0 * S, "S": S}

    noises, *_ = most_likely(flat, np.full(2, 1e-6), np.array([True, True]), (1e-7, 0.03))
    np.testing.assert_array_equal(noises, 1e-7)


def test_a_recording_without_noise_is_replayed_by_euler_angles(describe, capsys):
    """With a bias that is known: the noises that are chosen, all at their limit, fly the run without it too."""
    bias = np.array([1e-3, -2e-3, 5e-4])
    toml = f"{TOML}[reference]\ngyro_bias = {{ values = {bias.tolist()}, unit = 'rad/s' }}\n"
    path = describe(imu={**IMU, "gyro": IMU["gyro"] + bias}, toml=toml)
    with pytest.raises(SystemExit):
        main(["replay", str(path), "--model", "euler-matching", "--to", "3 s"])
    out, err = capsys.readouterr()
    assert set(err.splitlines()) <= {"without the bias calibration"}  # how far it is, on a machine that takes 5 s
    assert "Without the bias calibration, same noises" in out
    assert "cut to 0.010 s to 3.000 s" in out and "master's roll, pitch, yaw [0.000, 0.000, 0.000] arcmin" in out


def test_the_command_line_cuts_bridges_and_allows(describe, capsys):
    path = str(describe(imu=without({**IMU, "gyro": IMU["gyro"] * [1, 1, -1]}, [1000])))
    with pytest.raises(SystemExit) as ended:
        main(["replay", path, "--check", "--from", "2 s", "--to", "20 s", "--bridge", "10 ms"])
    out = capsys.readouterr().out
    assert ended.value.code == 1 and "[turns]" in out and "2.000 s to 20.000 s" in out and "[gap]" not in out
    with pytest.raises(SystemExit) as ended:
        main(["replay", path, "--check", "--bridge", "10 ms", "--allow", "turns"])
    assert ended.value.code == 0 and "(allowed: turns)" in capsys.readouterr().out
