"""Files as people have them: each is named with the one key that reads it, and read with it as what was flown.

Flown by tests/recordings_falsified.py; a fault is written into the columns, and the key that the message proposes into
the description.
"""

import re

import numpy as np
import pytest
from recordings_falsified import DESCRIPTION, FAULTS, Plan, Written, complaints, fly

from boresight import BoresightError
from boresight.runtime.recording import check, read

FLOWN = fly(Plan(), 1)
TIME = 'time = { columns = "t", unit = "s" }'
MASTER_TIME = 'time = { columns = "tm", unit = "s" }'
IMU, MASTER = "[imu]\n", "[master]\n"


def written(fault=None, toml=DESCRIPTION):
    out = Written({key: values.copy() for key, values in FLOWN.columns.items()}, toml)
    if fault:
        FAULTS[fault][0](out)
    return out


def named(path, *words):
    """The first complaint holds the words; one line."""
    text = complaints(path)[0]
    assert "\n" not in text
    for word in words:
        assert word in text, text
    return text


def healthy(path):
    recording = read(path)
    assert [one.text for one in check(recording) if one.level == "error"] == []
    return recording


def is_what_was_flown(recording, atol=1e-12):
    np.testing.assert_allclose(recording.imu.gyro, FLOWN.columns["gyro"], atol=atol)
    np.testing.assert_allclose(recording.imu.time - recording.imu.time[0], FLOWN.columns["t"] - 0.02, atol=1e-6)


# ---------------------------------------------------------------- time


@pytest.mark.parametrize("name", ["sampling_rate", "fs"])
def test_a_file_without_times_has_a_rate_which_the_message_finds(tmp_path, name):
    w = written()
    del w.columns["t"]
    w.columns[name] = np.array(50.0)
    w.replace((f"{TIME}\n", ""))
    named(w.write(tmp_path), "imu has no time", 'rate = "50 Hz"', repr(name))
    for rate in ("50 Hz", name):
        w.toml = DESCRIPTION.replace(TIME, f'rate = "{rate}"\nstart = "20 ms"')
        recording = healthy(w.write(tmp_path))
        is_what_was_flown(recording)
        assert any("no time tags; assumed from 0.02 s on at 50 Hz" in note for note in recording.notes)
    w.toml = DESCRIPTION.replace(TIME, f'{TIME}\nrate = "50 Hz"')
    named(w.write(tmp_path), "a time and a rate")
    w.toml = DESCRIPTION.replace(TIME, 'rate = "0 Hz"')
    named(w.write(tmp_path), "above zero")


def test_a_master_may_have_a_rate_too(tmp_path):
    w = written()
    w.replace((MASTER_TIME, 'rate = "4 Hz"\nstart = "0.25 s"'))
    np.testing.assert_allclose(healthy(w.write(tmp_path)).master.time, FLOWN.columns["tm"])


@pytest.mark.parametrize(("bits", "unit", "factor"), [(16, "ms", 1e3), (24, "us", 1e6), (16, "10 us", 1e5)])
def test_a_counter_that_wraps_goes_on(tmp_path, bits, unit, factor):
    """Of 16 and more bits, several times; the master by the same counter, which begins behind the first wrap."""
    w = written()
    span = 2**bits / factor
    tick = 1.0 if unit == "10 us" else factor  # a unit that no description has: written in s
    for name, since in (("t", 0.9 * span), ("tm", 0.9 * span)):
        w.columns[name] = np.round((w.columns[name] + since) * factor) % 2**bits / factor * tick
    keep = FLOWN.columns["tm"] > 0.3 * span if span < 20 else FLOWN.columns["tm"] > 0
    for name in ("tm", "attitude", "velocity", "position"):
        w.columns[name] = w.columns[name][keep]
    w.replace(*((text, text.replace('"s"', f'"{unit}"')) for text in (TIME, MASTER_TIME) if tick > 1))
    text = named(w.write(tmp_path), f"a counter of {bits} bits wraps, in {unit}", "do not sort")
    key = re.search(r'wraps = "[^"]+"', text)[0]
    w.toml = w.toml.replace(f'"{unit if tick > 1 else "s"}" }}\n', f'"{unit if tick > 1 else "s"}", {key} }}\n')
    recording = healthy(w.write(tmp_path))
    is_what_was_flown(recording)
    assert abs(recording.master.time[0] - recording.imu.time[0] - (FLOWN.columns["tm"][keep][0] - 0.02)) < 1e-3


@pytest.mark.parametrize("span", [86400.0, 604800.0])
def test_midnight_and_the_end_of_a_gps_week_are_wraps(tmp_path, span):
    w = written()
    for name in ("t", "tm"):
        w.columns[name] = (w.columns[name] + span - 20) % span
    named(w.write(tmp_path), f'wraps = "{span:g} s" in imu.time')
    w.toml = w.toml.replace('unit = "s" }', f'unit = "s", wraps = "{span:g} s" }}')
    is_what_was_flown(healthy(w.write(tmp_path)))


def test_tags_of_single_precision_are_put_on_their_line(tmp_path):
    w = written("time_tags_in_float32")
    named(w.write(tmp_path), "float32", 'clock = "regular"')
    w.replace((IMU, f'{IMU}clock = "regular"\n'))
    recording = healthy(w.write(tmp_path))
    np.testing.assert_allclose(np.diff(recording.imu.time), 0.02, atol=2e-5)


@pytest.mark.parametrize("how", ["groups of five", "held at 30 Hz"])
def test_samples_that_came_in_groups_are_put_on_their_line(tmp_path, how):
    w = written()
    keys = 'clock = "regular"\n'
    if "five" in how:
        w.columns["t"] = np.floor(w.columns["t"] * 10 + 1e-6) / 10
    else:
        keys += 'repeats = "drop"\n'
        for name in ("gyro", "accel"):
            x = w.columns[name]
            even = np.cumsum(np.vstack([np.zeros(3), x]), axis=0) / 50  # its integral, and means at 30 Hz
            at = np.arange(0, 50, 1 / 30)
            means = np.diff([np.interp(at, np.arange(2501) / 50, part) for part in even.T], axis=1).T * 30
            w.columns[name] = means[np.minimum((w.columns["t"] * 30 - 1e-6).astype(int), len(means) - 1)]
    named(w.write(tmp_path), 'clock = "regular"')
    w.replace((IMU, f"{IMU}{keys}"))
    np.testing.assert_allclose(
        np.diff(healthy(w.write(tmp_path)).imu.time), 1 / (50 if "five" in how else 30), rtol=2e-3
    )


@pytest.mark.parametrize("sensor", ["gyro", "accel"])
def test_one_sensor_that_is_held_is_named(tmp_path, sensor):
    w = written()
    w.columns[sensor] = np.repeat(w.columns[sensor][::5], 5, axis=0)
    named(w.write(tmp_path), f"imu.{sensor}", "80% of its samples repeat", "held at 9.98 Hz")


def test_tags_of_a_clock_that_was_not_set_yet_are_left_out(tmp_path):
    w = written()
    for name in ("t", "tm"):
        w.columns[name] += 1.7e9
    w.columns["t"][:3] = 0.0
    named(w.write(tmp_path), "3 tags stand off", 'bad_rows = "drop"')
    w.toml = f'bad_rows = "drop"\n{w.toml}'
    assert len(healthy(w.write(tmp_path)).imu.time) == len(FLOWN.columns["t"]) - 3


@pytest.mark.parametrize("row", [0, -1])
def test_a_spoilt_tag_at_an_end_is_left_out(tmp_path, row):
    w = written()
    w.columns["t"][row] = -1e9 if row == 0 else 1e9
    named(w.write(tmp_path), 'bad_rows = "drop"')
    w.toml = f'bad_rows = "drop"\n{w.toml}'
    assert len(healthy(w.write(tmp_path)).imu.time) == len(FLOWN.columns["t"]) - 1


@pytest.mark.parametrize(("by", "of"), [(-7.3, ("t", "tm")), (3600.0, ("t", "tm")), (-4.0, ("t", "tm"))])
def test_a_clock_that_was_set_once_goes_on_as_before(tmp_path, by, of):
    w = written()
    for name in of:
        w.columns[name][FLOWN.columns[name] > 25.0] += by
    text = named(w.write(tmp_path), "imu.time", "steps = [{")
    steps = {"imu": re.search(r"steps = \[.*?\]", text)[0]}
    w.replace((TIME, TIME.replace(" }", f", {steps['imu']} }}")))
    text = named(w.write(tmp_path), "master.time", "steps = [{") if by < 0 else ""
    steps["master"] = (
        re.search(r"steps = \[.*?\]", text)[0] if text else f'steps = [{{ after = "25 s", by = "{by} s" }}]'
    )
    w.replace((MASTER_TIME, MASTER_TIME.replace(" }", f", {steps['master']} }}")))
    recording = healthy(w.write(tmp_path))
    is_what_was_flown(recording)
    np.testing.assert_allclose(recording.master.time, FLOWN.columns["tm"], atol=1e-3)


def test_a_pause_and_a_clock_that_was_set_on_by_seconds_are_named_both(tmp_path):
    w = written()
    w.columns["t"][FLOWN.columns["t"] > 25.0] += 2.0
    text = named(w.write(tmp_path), "1 gap after 25.0000 s", "cut the recording there", "if the clock was set")
    w.replace((TIME, TIME.replace(" }", f", {re.search(r'steps = .*?]', text)[0]} }}")))
    is_what_was_flown(healthy(w.write(tmp_path)))


def test_the_known_rest_of_a_walk_is_described(tmp_path):
    w = written()
    w.toml = w.toml[: w.toml.index(MASTER)] + '[stops]\nrest = ["0 s", "9500 ms"]\nwindow = "0.4 s"\nsway = 3\n'
    assert read(w.write(tmp_path)).stops == {"rest": (0.0, 9.5), "window": 20, "sway_factor": 3.0}
    w.replace(('"0 s", ', ""))
    named(w.write(tmp_path), "stops.rest holds 1 times")


def test_a_step_that_is_not_there_is_one_line(tmp_path):
    w = written()
    w.replace((TIME, TIME.replace(" }", ', steps = [{ after = "25 s", by = "-7 s" }] }')))
    named(w.write(tmp_path), "no tag steps by -7 s after 25 s")


@pytest.mark.parametrize("fault", ["time_zone_missing", "leap_seconds", "one_second_late"])
def test_clocks_that_are_apart_are_shifted_by_what_the_message_says(tmp_path, fault):
    w = written(fault)
    key = re.search(r'shift = "[^"]+"', named(w.write(tmp_path), "shift = "))[0]
    w.replace((MASTER_TIME, MASTER_TIME.replace(" }", f", {key} }}")))
    np.testing.assert_allclose(healthy(w.write(tmp_path)).master.time, FLOWN.columns["tm"], atol=1e-9)


def test_increments_whose_own_interval_is_shorter_than_their_tags_are_rates(tmp_path):
    """4.0 ms of 4.4: what was not integrated is taken as turning on."""
    w = written()
    own = np.full(len(w.columns["t"]), 0.02 * 4.0 / 4.4)
    w.columns |= {"dt": own, "gyro": w.columns["gyro"] * own[:, None], "accel": w.columns["accel"] * own[:, None]}
    w.replace(('"rates"', '"increments"'), ('"rad/s"', '"rad"'), ('"m/s^2"', '"m/s"'))
    named(w.write(tmp_path), "90.5% of gravity: do they cover less than the time", "interval = {")
    w.replace((IMU, f'{IMU}interval = {{ columns = "dt", unit = "s" }}\n'))
    recording = healthy(w.write(tmp_path))
    is_what_was_flown(recording)
    assert any("90.9% of the time between tags" in note for note in recording.notes)


# ---------------------------------------------------------------- rows


@pytest.mark.parametrize("twice", ["each row", "some rows", "a block behind the end"])
def test_equal_rows_are_left_out_and_counted(tmp_path, twice):
    w = written()
    n = len(w.columns["t"])
    rows = {"each row": np.repeat(np.arange(n), 2), "some rows": np.sort([*range(n), 5, 90, 91]),
            "a block behind the end": np.r_[np.arange(n), np.arange(n - 300, n)]}[twice]  # fmt: skip
    for name in ("t", "gyro", "accel"):
        w.columns[name] = w.columns[name][rows]
    named(w.write(tmp_path), f"{len(rows) - n} equal rows, alike in every column, are left out")
    is_what_was_flown(healthy(w.write(tmp_path)))


def test_a_tag_that_stands_twice_with_other_values_stays_an_error(tmp_path):
    w = written()
    w.columns["t"][100] = w.columns["t"][99]
    named(w.write(tmp_path), "error imu.time", "1 tags are repeated", "with other values")


@pytest.mark.parametrize("fault", ["slave_held_at_25_hz", "one_sample_in_50_a_copy", "master_held_at_1_hz"])
def test_rows_that_repeat_the_one_before_are_no_samples(tmp_path, fault):
    w = written(fault)
    named(w.write(tmp_path), 'repeats = "drop"')
    section = MASTER if "master" in fault else IMU
    w.replace((section, f'{section}repeats = "drop"\n'))
    w.toml = w.toml.replace("[imu]", 'bridge = "25 ms"\n[imu]', 1)
    recording = healthy(w.write(tmp_path))
    if "held_at_25" in fault:
        np.testing.assert_allclose(recording.imu.gyro, FLOWN.columns["gyro"][::2], atol=1e-12)
    if "master" in fault:
        np.testing.assert_array_equal(recording.master.time, FLOWN.columns["tm"][::4])


@pytest.mark.parametrize(("mean", "every"), [(True, 5), (False, 5), (False, 2)])
def test_of_samples_that_a_line_was_drawn_between_those_of_the_sensor_stay(tmp_path, mean, every):
    w = written()
    t = w.columns["t"]
    for name in ("gyro", "accel"):
        x = w.columns[name]
        coarse = x.reshape(-1, every, 3).mean(axis=1) if mean else x[every - 1 :: every]
        w.columns[name] = np.stack([np.interp(t, t[every - 1 :: every], part) for part in coarse.T], axis=-1)
    text = named(w.write(tmp_path), f'interpolated_from = "{50 / every:g} Hz"')
    w.replace((IMU, f"{IMU}{re.search('interpolated_from = .*? Hz.', text)[0]}\n"))
    recording = healthy(w.write(tmp_path))
    np.testing.assert_allclose(recording.imu.gyro, coarse_of(FLOWN.columns["gyro"], every, mean), atol=1e-12)


def coarse_of(x, every, mean):
    return x.reshape(-1, every, 3).mean(axis=1) if mean else x[every - 1 :: every]


@pytest.mark.parametrize("spoil", ["a tag", "tags of three rows", "a value", "not finite"])
def test_a_corrupt_row_is_named_and_left_out(tmp_path, spoil):
    w = written()
    bad = [700, 701, 702] if "three" in spoil else [700]
    if "tag" in spoil:
        w.columns["t"][bad] -= 604_800
    else:
        w.columns["gyro"][700, 1] = np.nan if spoil == "not finite" else 1e30
    named(w.write(tmp_path), 'bad_rows = "drop"', *(["row 700"] if spoil != "a value" else ["1 sample"]))
    w.toml = f'bad_rows = "drop"\nbridge = "80 ms"\n{w.toml}'
    recording = healthy(w.write(tmp_path))
    assert len(recording.imu.time) == len(FLOWN.columns["t"])  # bridged
    assert any("left out" in line for line in recording.left_out)


# ---------------------------------------------------------------- arrays and text


def test_samples_along_the_second_axis_are_named_by_their_row(tmp_path):
    w = written()
    w.columns["u"] = np.vstack([w.columns.pop("accel").T, w.columns.pop("gyro").T])  # 6 x N
    gyro, accel = [f"u[{k}]" for k in (3, 4, 5)], [f"u[{k}]" for k in (0, 1, 2)]
    w.replace(('columns = "gyro"', f"columns = {gyro}"), ('columns = "accel"', f"columns = {accel}"))
    named(w.write(tmp_path), "u is 6 x 2500", '"u.T[3]"')
    w.toml = w.toml.replace("u[", "u.T[")
    is_what_was_flown(healthy(w.write(tmp_path)))


def test_an_array_of_three_rows_is_named_turned(tmp_path):
    w = written()
    w.columns["gyro"] = w.columns["gyro"].T
    named(w.write(tmp_path), "samples run along its second axis", '"gyro.T"')
    w.replace(('columns = "gyro"', 'columns = "gyro.T"'))
    is_what_was_flown(healthy(w.write(tmp_path)))


HEADERS = {
    2: ["Time;Gyroscope;;;Accelerometer;;", "[s];x;y;z;x;y;z"],
    3: ["some logger, firmware 1.2", "Time;Gyroscope;;;Accelerometer;;", "[s];x;y;z;x;y;z"],
    4: ["a title", "", "t;gx;gy;gz;ax;ay;az", "s;rad/s;rad/s;rad/s;m/s^2;m/s^2;m/s^2"],
    1: ["# t;gx;gy;gz;ax;ay;az"],
}


@pytest.mark.parametrize("lines", HEADERS)
def test_several_lines_of_header_are_counted_and_their_names_joined(tmp_path, lines):
    w = written()
    rows = np.column_stack([w.columns["t"], w.columns["gyro"], w.columns["accel"]])
    text = [*HEADERS[lines], *(";".join(f"{x:.15g}" for x in row) for row in rows)]
    (tmp_path / "imu.csv").write_text("\n".join(text) + "\n")
    w.replace(
        (IMU, f'{IMU}file = "imu.csv"\n'), ('file = "drive.npz"\n', ""), (MASTER, f'{MASTER}file = "drive.npz"\n')
    )
    held = named(w.write(tmp_path), 'delimiter = ";"', f"header = {lines}", f"begin in line {lines + 1}")
    names = re.search(r"\(columns (.*)\)", held)[1].split(", ")
    w.toml = f'delimiter = ";"\nheader = {lines}\n{w.toml}'
    w.replace(('columns = "t"', f'columns = "{names[0]}"'), ('columns = "gyro"', f"columns = {names[1:4]}"),
              ('columns = "accel"', f"columns = {names[4:7]}"))  # fmt: skip
    is_what_was_flown(healthy(w.write(tmp_path)), 1e-13)


def test_text_in_a_row_is_left_out_where_it_is_asked_for(tmp_path):
    w = written()
    rows = np.column_stack([w.columns["t"], w.columns["gyro"], w.columns["accel"]])
    text = [",".join(f"{x:.15g}" for x in row) for row in rows]
    text[700] = ",".join([*text[700].split(",")[:3], "ERR", *text[700].split(",")[4:]])
    (tmp_path / "imu.csv").write_text("\n".join(["t,gx,gy,gz,ax,ay,az", *text]) + "\n")
    w.replace(
        (IMU, f'{IMU}file = "imu.csv"\n'), ('file = "drive.npz"\n', ""), (MASTER, f'{MASTER}file = "drive.npz"\n')
    )
    for name in ("gyro", "accel"):
        w.replace((f'columns = "{name}"', f"columns = {[f'{name[0]}{axis}' for axis in 'xyz']}"))
    named(w.write(tmp_path), "row 700 holds 'ERR'", 'bad_rows = "drop"')
    text[900] += ",7,8"
    (tmp_path / "imu.csv").write_text("\n".join(["t,gx,gy,gz,ax,ay,az", *text]) + "\n")
    named(w.write(tmp_path), 'bad_rows = "drop"')
    w.toml = f'bad_rows = "drop"\nbridge = "25 ms"\n{w.toml}'
    recording = healthy(w.write(tmp_path))
    assert sum("1 rows" in line for line in recording.left_out) == 2, recording.left_out


# ---------------------------------------------------------------- axes


def test_columns_named_north_east_up_stand_beside_the_frame(tmp_path):
    w = written()
    w.columns["velocity"] *= [1, 1, -1]
    named(w.write(tmp_path), 'order = "north east up"')
    refused = DESCRIPTION.replace('navigation = "NED"', 'navigation = "NEU"')
    named(Written(w.columns, refused).write(tmp_path), "not a right-handed", 'add order = "north east up"')
    w.replace(('columns = "velocity", unit = "m/s"', 'columns = "velocity", unit = "m/s", order = "north east up"'))
    np.testing.assert_allclose(healthy(w.write(tmp_path)).master.v_n, FLOWN.columns["velocity"])
    w.toml = w.toml.replace("north east up", "north east north")
    named(w.write(tmp_path), "three different axes")


def test_a_velocity_whose_columns_are_east_north_up_is_proposed(tmp_path):
    w = written("velocity_in_enu")
    named(w.write(tmp_path), 'order = "east north up" beside the velocity fits')
    w.replace(('columns = "velocity", unit = "m/s"', 'columns = "velocity", unit = "m/s", order = "east north up"'))
    healthy(w.write(tmp_path))


def test_longitude_may_stand_before_latitude(tmp_path):
    w = written()
    w.columns["position"] = w.columns["position"][:, [1, 0, 2]]
    w.replace(('columns = "position", unit = "rad"',
               'columns = "position", unit = "rad", order = "longitude latitude altitude"'))  # fmt: skip
    np.testing.assert_allclose(healthy(w.write(tmp_path)).master.position, FLOWN.columns["position"])


@pytest.mark.parametrize("body", ["FUR", "FLU", "RFU", "BLD", "DRB"])
@pytest.mark.parametrize("alone", [False, True])
def test_the_axes_that_fit_are_proposed(tmp_path, body, alone):
    """Without a master which of them is up; with one, which is front too."""
    from boresight.runtime.frames import body_to_frd

    w = written()
    for name in ("gyro", "accel"):
        w.columns[name] = w.columns[name] @ body_to_frd(body)
    if alone:
        w.toml = w.toml[: w.toml.index(MASTER)]
    path = w.write(tmp_path)
    if alone and body in ("BLD",):
        healthy(path)  # nothing shows it
        return
    said = " ".join(complaints(path))
    assert (
        f'body = "{body}" fits' in said if not alone else re.search(rf'body = "\w+" fits.*{body}|"{body}" fits', said)
    ), said
    w.replace(('body = "FRD"\ntime = { columns = "t"', f'body = "{body}"\ntime = {{ columns = "t"'))
    is_what_was_flown(healthy(w.write(tmp_path)))


@pytest.mark.parametrize("fault", ["left_handed", "roll_and_pitch_swapped", "one_gyro_axis_mirrored"])
def test_no_axes_are_proposed_where_none_fit(tmp_path, fault):
    assert 'body = "' not in " ".join(complaints(written(fault).write(tmp_path)))


# ---------------------------------------------------------------- messages that say that they have none


@pytest.mark.parametrize("how", ["zero", "covariance"])
def test_an_orientation_that_is_not_given_is_none(tmp_path, how):
    from scipy.spatial.transform import Rotation

    w = written()
    q = Rotation.from_euler("ZYX", w.columns["attitude"][:, ::-1]).as_quat()
    w.columns["attitude"] = q
    w.replace(('"attitude", unit = "rad"', '"attitude", unit = "1", order = "xyzw"'))
    some = np.arange(len(q)) % 10 == 3
    covariance = np.zeros((len(q), 9))
    if how == "zero":
        w.columns["attitude"] = np.where(some[:, None], 0.0, q)
    else:
        w.columns["attitude_covariance"] = covariance
        covariance[some, 0] = -1
    recording = healthy(w.write(tmp_path))
    np.testing.assert_array_equal(recording.master.time, FLOWN.columns["tm"][~some])
    assert any(f"{some.sum()} " in line for line in recording.left_out)
    w.columns["attitude"] = np.zeros_like(q) if how == "zero" else q
    covariance[:, 0] = -1
    with pytest.raises(BoresightError, match=r"no orientation is given|covariance\[0\] = -1"):
        read(w.write(tmp_path))
