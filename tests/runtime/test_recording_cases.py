"""Recordings that people asked about in public: each is read rightly, or ends in the right cause, in the first line.

One row a case: what was wrong with the file, what the first line holds, and what is then written into the description
(nothing where the data is to be measured anew).
"""

import numpy as np
import pytest
from recordings_falsified import DESCRIPTION, FAULTS, Plan, Written, complaints, fly

from boresight.runtime.recording import check, read

TIME, MASTER_TIME = 'time = { columns = "t", unit = "s" }', 'time = { columns = "tm", unit = "s" }'
RATES = [('"rates"', '"increments"'), ('"rad/s"', '"rad"'), ('"m/s^2"', '"m/s"')]


def fault(name):
    return FAULTS[name][0]


def tags(section, rows, by):
    def change(w):
        w.columns["t" if section == "imu" else "tm"][rows] += by

    return change


def gap(begin, seconds):
    def change(w):
        t = w.columns["t"]
        keep = (t <= begin) | (t > begin + seconds)
        for name in ("t", "gyro", "accel"):
            w.columns[name] = w.columns[name][keep]

    return change


def rates_as_increments(w):
    w.replace(*RATES)


def gravity_and_degrees(w):
    w.columns["accel"] /= 9.80665
    w.columns["gyro"] = np.degrees(w.columns["gyro"])


def six_rows_and_no_time(w):
    """A square walked stop and go, as MATLAB has it: 6 x N, and nothing else."""
    w.columns = {"u": np.vstack([w.columns["accel"].T, w.columns["gyro"].T])}
    w.toml = w.toml[: w.toml.index("[master]")]
    w.replace((TIME + "\n", ""), ('"gyro"', '["u[3]", "u[4]", "u[5]"]'), ('"accel"', '["u[0]", "u[1]", "u[2]"]'))


def quaternions_of_nothing(w):
    w.columns["attitude"] = np.zeros((len(w.columns["tm"]), 4))
    w.replace(('"attitude", unit = "rad"', '"attitude", unit = "1", order = "xyzw"'))


HALF = slice(1250, None)
CASES = {
    "every second message of increments logged": (fault("half_of_the_increments_lost"), ["one increment in 2"], []),
    "the clock jumps back 4 s": (
        tags("imu", HALF, -4.0), ["the clock was set back, by 4 s", "do not sort", "steps = [{"],
        [(TIME, TIME.replace(" }", ', steps = [{ after = "25 s", by = "-4 s" }] }'))],
    ),
    "the clock jumps on by years": (
        tags("imu", HALF, 1e8), ["1 gap after 25", "if the clock was set", "steps = [{"],
        [(TIME, TIME.replace(" }", ', steps = [{ after = "25 s", by = "1e8 s" }] }'))],
    ),
    "three epochs of the master a GPS week back": (
        tags("master", slice(90, 93), -604_800.0), ["master.time", "3 tags stand off", 'bad_rows = "drop"'],
        [('title = "a drive"', 'bad_rows = "drop"')],
    ),
    "0.3 s are missing": (gap(20.0, 0.3), ["1 gap ", "from, to"], [('title = "a drive"', 'bridge = "0.31 s"')]),
    "20 s are missing": (gap(20.0, 20.0), ["1 gap ", "20.02", "cut the"], [('title = "a drive"', "to = 20.0")]),
    "the master is late by 200 ms": (fault("master_200_ms_late"), ["+0.21", "--delay-ms 21"], None),
    "g and deg/s in a message of SI": (gravity_and_degrees, ["g declared as m/s^2"],
        [('"m/s^2"', '"g"'), ('"rad/s"', '"deg/s"')]),
    "deg/s in a message of SI": (fault("gyro_in_degrees"), ["deg/s declared as rad/s"], [('"rad/s"', '"deg/s"')]),
    "increments described as rates": (fault("increments_as_rates"), ["increments declared as rates"], RATES),
    "rates described as increments": (rates_as_increments, ["rates declared as increments"],
        [('"increments"', '"rates"'), ('"gyro", unit = "rad"', '"gyro", unit = "rad/s"'),
         ('"accel", unit = "m/s"', '"accel", unit = "m/s^2"')]),
    "a quaternion of zeros": (quaternions_of_nothing, ["no orientation is given"], []),
    "yaw falls when it turns right": (fault("heading_mirrored"), ["yaw", "counter-clockwise"],
        [('"attitude", unit = "rad"', '"attitude", unit = "rad", yaw_positive = "counter-clockwise"')]),
    "6 x N and no time": (
        six_rows_and_no_time, ["u is 6 x 2500", '"u.T[3]"'],
        [("u[", "u.T["), ("[imu]\n", '[imu]\nrate = "50 Hz"\n')],
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_a_case_ends_in_its_cause_and_its_remedy(case, tmp_path):
    change, words, written = CASES[case]
    w = Written({key: values.copy() for key, values in fly(Plan(), 1).columns.items()}, DESCRIPTION)
    change(w)
    first = complaints(w.write(tmp_path))[0]
    assert "\n" not in first
    for word in words:
        assert word in first, first
    if not written:
        assert written is None or first.startswith("error")
        return
    for old, new in written:
        assert old in w.toml, old
        w.toml = w.toml.replace(old, new)
    assert [one.text for one in check(read(w.write(tmp_path))) if one.level == "error"] == []


def test_a_lever_arm_that_nobody_gave_is_named_with_its_size(tmp_path):
    plan = Plan(lever=(0.75, 0, 0), heading=lambda t: np.radians(20 + 60 * np.sin(0.5 * t)))  # 30 deg/s
    notes = [one.text for one in check(read(fly(plan, 1).write(tmp_path))) if "lever arm of [" in one.text]
    found, sigma = (float(part) for part in notes[0].split("[")[1].split(",")[0].split(" +- "))
    assert found == pytest.approx(0.75, abs=3 * sigma) and sigma < 0.1
