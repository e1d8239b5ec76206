"""Replay by velocity and attitude: a recording with analytic truth gives it back, the real one its delay."""

import base64
import json
import re
from dataclasses import replace
from html import escape

import numpy as np
import pytest
from conftest import ROOT
from tools import real_recording

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.library import load
from boresight.runtime.recording import Inertial, Master, Recording, read
from boresight.runtime.simulation import hull, inertial
from boresight.runtime.transfer.score import Score
from boresight.runtime.transfer.sensors import CALIBRATION, MODEL, PROBE, Sensors, calibration
from boresight.runtime.units import STANDARD_GRAVITY as G
from boresight.runtime.units import UNITS, quantity
from boresight.studies.page import numbers_of, page
from boresight.studies.replays import passes
from boresight.studies.replays import velocity_attitude as tr
from boresight.studies.replays.innovations import consistency
from boresight.studies.study import Replay, document
from tests.drawing import drawn

DEG = np.pi / 180
DELAY = 0.03
LEVER_B = np.array([-0.3, 0.2, 0.5])
MU = np.array([0.2, -0.3, 0.8]) * DEG
BIAS_G, BIAS_A = np.array([200.0, -300.0, 100.0]) * DEG / 3600, np.array([-0.07, 0.03, 0.05])
NOISE = {"gyro": 0.2 * DEG / 60, "accel": 0.002, "velocity": [0.003, 0.004], "attitude": [1e-4, 2e-4], "delay": 1e-7,
         "gyro_walk": 0.0, "accel_walk": 0.0}  # fmt: skip


def simulate(seed, seconds=14.0, lever_b=LEVER_B):
    """A hull that rolls, pitches and yaws, exact by hull and strapdown; white noise and constant biases on top."""
    rng = np.random.default_rng(seed)
    dt, place = 0.01, np.array([0.6, 2.2, 20.0])
    motion = hull.sinusoids(
        amplitude=[0.3, 0.4, 0.5, 12 * DEG, 5 * DEG, 5 * DEG], phase=[0.0, 1.0, 2.0, 0.3, 1.2, 2.1], frequency_hz=0.2,
        heading=0.5, speed=4.0,
    )  # fmt: skip
    model = load("velocity-attitude")
    time = np.arange(round(seconds / dt) + 1) * dt
    mounting = rotation.turned(np.array([1.0, 0, 0, 0]), MU)
    slave = hull.carried(hull.ride(motion, time), lever_b, mounting)
    dtheta, dv, track = inertial.increments(model.strapdown, place, slave.v_n[:, None], slave.q_b2n_wxyz[:, None], dt)
    white = rng.standard_normal((2, len(dtheta), 3)) * np.sqrt(dt)
    imu = Inertial(
        "increments", "end", time[1:], dtheta[:, 0] + BIAS_G * dt + NOISE["gyro"] * white[0],
        dv[:, 0] + BIAS_A * dt + NOISE["accel"] * white[1],
    )  # fmt: skip
    every = np.arange(10, len(time), 10)
    pose = hull.ride(motion, time[every] - DELAY)
    turn = rng.standard_normal((len(every), 3)) * np.array(NOISE["attitude"])[[0, 0, 1]]  # about north, east, down
    C = rotation.matrix_from_vector(turn) @ rotation.matrix_from_quaternion(pose.q_b2n_wxyz)
    v_n = pose.v_n + rng.standard_normal((len(every), 3)) * np.array(NOISE["velocity"])[[0, 0, 1]]
    master = Master(time[every], rotation.euler_from_matrix(C), v_n, track.position[every, 0])
    truth = {"misalignment": MU, "gyro_bias": BIAS_G, "accel_bias": BIAS_A, "lever_arm": lever_b}
    return Recording("sea", imu, master, truth)


@pytest.fixture(scope="module")
def simulated(compiled_once):
    return simulate(1)


@pytest.fixture(scope="module")
def model(compiled_once):
    return load("velocity-attitude")


@pytest.fixture(scope="module")
def result(simulated, model):
    return tr.run(simulated, model, noise=NOISE, lever_b=LEVER_B)


def state(result, name):
    return [s for s in result["states"] if s["state"] == name]


# ---------------------------------------------------------------- truth is known


def off_by(result, sigma):
    """Of all quantities whose truth is known, in their sigmas."""
    off = [(s["estimate"] - s["reference"]) / s[sigma] for s in result["states"] if s["reference"] is not None]
    (delay,) = state(result, "delay")
    return np.array([*off, (delay["estimate"] - 1e3 * DELAY) / delay[sigma]])


def assert_truth(result):
    """The sensors are exactly as the model says, so that the noises are all there is."""
    (delay,) = state(result, "delay")
    off = off_by(result, "noise_sigma")
    assert np.abs(off).max() < 3.5
    assert 0.3 < np.sqrt(np.mean(np.square(off))) < 1.6
    assert delay["noise_sigma"] < 0.3
    assert max(s["noise_sigma"] / s["prior_sigma"] for s in result["states"]) < 0.1


def test_mounting_biases_and_delay_come_back_from_nothing(result):
    assert result["noise"]["passes"] == 0
    assert_truth(result)


def test_the_smoother_finds_the_truth_all_along_with_smaller_sigmas(simulated, model, result):
    """Its filter has the bits of the replay's, and the delay is considered where a message does not inform it."""
    found = tr.run(simulated, model, noise=NOISE, lever_b=LEVER_B, smooth=True)
    back = found["history"]["smoothed"]
    for part in ("estimate", "sigma"):
        assert np.array_equal(back[f"filter_{part}"][:, 6:16], result["history"]["with"][part][:, 6:16])
    assert (back["sigma"][:, :16] <= back["filter_sigma"][:, :16] * (1 + 1e-9)).all()
    truth = np.concatenate([BIAS_G, BIAS_A, MU, [DELAY]])
    off = (back["estimate"][:, 6:16] - truth) / back["sigma"][:, 6:16]
    assert np.abs(off).max() < 3.5 and np.sqrt(np.mean(off**2)) < 1.6
    early = np.abs(back["filter_estimate"][5, 6:16] - truth)
    assert (np.abs(back["estimate"][5, 6:16] - truth) < early).mean() > 0.7 and back["sigma"][5, 12] < 0.2 * (
        back["filter_sigma"][5, 12]
    )
    text = tr.report(found)
    (mean,) = [s for s in found["smoothed"] if s["state"] == "misalignment yaw"]
    row = next(line for line in text.splitlines() if line.startswith("| misalignment yaw") and "arcmin" in line
               and f"{mean['of_filter']:.2f}" in line)  # fmt: skip
    assert f"{mean['median_of_filter']:.2f}" in row and tr.number(mean["estimate"], mean["sigma"]) in row


def test_a_refused_message_leaves_nothing_in_the_record_and_goes_on_in_its_piece(simulated, model, monkeypatch):
    """As a message that has not come, but for its place: a run that would be driven off is set back."""
    start = np.zeros(19)
    start[15:] = DELAY, *LEVER_B
    noises, _ = tr.noise_vector(NOISE)
    prior, usual, calls = tr.PRIOR, passes.Pass.beyond, []

    def beyond(self):
        calls.append(len(calls))
        return usual(self) | (len(calls) == 40)

    monkeypatch.setattr(passes.Pass, "beyond", beyond)
    record = tr.fly(simulated, model, noises, start, prior, prior["delay"], recorded=True)["record"]
    monkeypatch.setattr(passes.Pass, "beyond", usual)
    (row,) = record.rows("withdrawn")
    assert not record.piece.any() and record.names[row - 2 : row].tolist() == ["dcm", "velocity"]
    assert np.array_equal(record.P[row], record.P[row - 3]) and not np.array_equal(record.P[row], record.P[row - 1])
    bare = tr.fly(simulated, model, noises, start, prior, prior["delay"], recorded=True)["record"]
    assert (tr.backwards(record)["sigma"] > 0.999999 * tr.backwards(bare)["sigma"]).mean() > 0.99


def test_sensors_off_by_what_is_assumed_stay_inside_the_sigmas(simulated, model):
    """Scale factors and axes of 1000 ppm and 1 mrad, which nothing tells, against sigmas with and without them."""
    rng = np.random.default_rng(11)
    off = rng.multivariate_normal(np.zeros(15), calibration(tr.ASSUMED))
    gyro, accel = np.diag(1 + off[:3]), np.diag(1 + off[3:6])
    gyro[[0, 0, 1, 1, 2, 2], [1, 2, 0, 2, 0, 1]] = off[6:12]
    accel[[1, 2, 2], [0, 0, 1]] = off[12:]
    imu = simulated.imu
    spoilt = replace(imu, gyro=imu.gyro @ gyro.T, accel=imu.accel @ accel.T)
    found = tr.run(replace(simulated, imu=spoilt), model, noise=NOISE, lever_b=LEVER_B)
    assert np.sqrt(np.mean(off_by(found, "noise_sigma") ** 2)) > 2.5
    assert np.sqrt(np.mean(off_by(found, "sigma") ** 2)) < 1.6
    assert np.abs(off_by(found, "sigma")).max() < 3.5
    assert "and by scale 1000 ppm and axes 1 mrad (assumed" in tr.report(found)


def test_what_is_noticed_counts_as_its_likeliest_size_and_as_none_that_no_sensor_has():
    P, score = np.zeros((46, 46)), Score(())
    P[12, CALIBRATION.start + 3] = PROBE**2  # a unit of an accelerometer's scale factor drives a state off by one
    score.information, score.gradient = 1e12 * np.eye(15), np.full(15, 1e9)
    assert tr.unknown(P, score, None)[12] == pytest.approx(1e-3, rel=1e-3)
    score.information, score.gradient = 25 * np.eye(15), np.full(15, 50.0)  # by these alone it would be 2
    assert tr.unknown(P, score, None)[12] < 2e-3
    assert tr.unknown(P, score, tr.ASSUMED)[12] == pytest.approx(1e-3, rel=0.2)


def test_nis_with_true_noises_is_consistent_with_the_delay_and_not_without(result):
    assert result["nis"]["with"]["consistent"]
    assert result["nis"]["with"]["white"]
    assert result["nis"]["without"]["mean"] > 5
    assert not result["nis"]["without"]["consistent"]
    known = result["minus_log_likelihood"]
    assert known["with"] < known["without"] - 1000


def test_lever_arm_comes_back_too_where_it_is_a_state(simulated):
    found = tr.run(simulated, load("velocity-attitude-lever"), noise=NOISE)
    assert len(state(found, "lever arm")) == 3
    assert_truth(found)
    assert found["nis"]["with"]["consistent"]


def test_lever_arm_of_the_wrong_sign_shows_in_the_nis(simulated, model):
    start = np.r_[np.zeros(16), -LEVER_B]
    track = tr.fly(tr.prepare(simulated, None), model, tr.noise_vector(NOISE)[0], start, tr.PRIOR, tr.PRIOR["delay"])
    per_row = np.mean(track["nu"] ** 2 / track["S"], axis=0)
    assert per_row.mean() > 5
    assert per_row[3:].max() < per_row[:3].max()


def test_noises_are_found(model):
    """10 s: 100 messages know a measurement's noise to 6 % at best; the gyros' is found within a half."""
    short = simulate(2, seconds=10.0, lever_b=np.zeros(3))
    found = tr.run(short, model, noise={name: NOISE[name] for name in ("delay", "gyro_walk", "accel_walk")})
    assert found["noise"]["passes"] > 0
    np.testing.assert_allclose(found["noise"]["velocity"]["value"], [3.0, 4.0], rtol=0.25)
    expected = np.array(NOISE["attitude"]) / DEG * 60
    np.testing.assert_allclose(found["noise"]["attitude"]["value"], expected, rtol=0.25)
    assert 0.1 < found["noise"]["gyro"]["value"][0] < 0.3
    assert found["noise"]["accel"]["value"][0] == pytest.approx(0.002 * 60, rel=0.5)
    assert found["nis"]["with"]["consistent"]
    assert not found["nis"]["without"]["consistent"]


# ---------------------------------------------------------------- the real recording


def printed():
    """What docs/recordings.md prints of given and of chosen noises: by row, the numbers in each of its cells."""
    text = (ROOT / "docs" / "recordings.md").read_text(encoding="utf-8")
    table = text[text.index("| noises | given |") :]
    rows = [line.strip("| ").split(" | ") for line in table[: table.index("\n\n")].splitlines()[2:]]
    return {name: [[float(x) for x in re.findall(r"-?\d+\.?\d*", cell)] for cell in cells] for name, *cells in rows}


@pytest.fixture(scope="module")
def fog_mems(compiled_once):
    """All of it, side by side: with the noises given, with those chosen, and with these and the delay held at 0.

    By run: states with what is printed of each, and consistency.
    """
    recording = tr.prepare(read(real_recording("fog_mems_transfer.npz")), None)
    lever, said = load("velocity-attitude-lever"), printed()
    noise: list[dict] = [{}, {}]
    for name, cells in said.items():
        kind = name.split(",")[0].removeprefix("noise ").replace(" ", "_")
        if name.startswith("noise "):
            unit = UNITS[tr.NOISES[kind].kind][tr.NOISES[kind].unit]
            for one, cell in zip(noise, cells[:2], strict=True):
                one[kind] = np.array(cell) * unit
    noises = np.array([tr.noise_vector(noise[i])[0] for i in (0, 1, 1)])
    held = np.array([tr.PRIOR["delay"], tr.PRIOR["delay"], 0.0])
    wide, probed, usual = load(MODEL), Sensors(lever=1.0, probed=True), tr.noise_vector({})[0]
    runs, passed = [], []
    for i in range(3):
        begun, first = usual.copy(), {"estimate": np.zeros((1, 19))}
        begun[2:6] = noises[i][2:6] if i == 0 else usual[2:6]  # of the master, which were given
        for _ in range(2):
            first = tr.fly(recording, lever, begun, first["estimate"][-1], tr.PRIOR, tr.PRIOR["delay"])
        start = np.where((np.arange(19) == 15) & (i == 2), 0.0, first["estimate"][-1])
        track = tr.fly(recording, wide, noises[i], start, tr.PRIOR, held[i], probed, first["pass"].informs)
        runs.append({part: track[part] for part in ("nu", "S", "used", "estimate", "sigma")})
        passed.append(track["pass"])
    out = []
    for i, run in enumerate(runs):
        more = tr.unknown(passed[i].loop.P, passed[i].score, tr.ASSUMED)
        both = {"with": run, "without": runs[2]}
        found = tr.states(lever, recording.master.time[passed[i].taken], both, recording.reference, tr.PRIOR, more[:19])
        out.append({"states": found, "nis": consistency(run["nu"] / np.sqrt(run["S"]), run["used"])})
    return out


def test_fog_mems_is_as_it_is_printed(fog_mems):
    said = printed()
    for column in range(2):
        for s in fog_mems[column]["states"]:
            value, sigma, by_noise = said[f"{tr.named(s)}, {s['unit']}"][column]
            assert s["estimate"] == pytest.approx(value, abs=0.15 * s["sigma"])
            assert s["sigma"] == pytest.approx(sigma, rel=0.1)
            assert s["noise_sigma"] == pytest.approx(by_noise, rel=0.1)
        assert fog_mems[column]["nis"]["mean"] == pytest.approx(
            said["mean NIS per row; by quarter"][column][0], abs=0.01
        )


def test_fog_mems_by_given_and_by_chosen_noises_agrees_within_the_sigmas(fog_mems):
    """By noise alone the lever arm down is some 4 sigmas apart, and an accelerometer's scale factor is why."""
    for given, chosen in zip(*(fog_mems[i]["states"] for i in range(2)), strict=True):
        assert abs(given["estimate"] - chosen["estimate"]) < 2 * np.hypot(given["sigma"], chosen["sigma"])
    apart, noise = given["estimate"] - chosen["estimate"], np.hypot(given["noise_sigma"], chosen["noise_sigma"])
    assert tr.named(given) == "lever arm down" and apart / noise > 3


def test_fog_mems_shows_its_delay_and_nis_needs_it(fog_mems):
    (delay,) = state(fog_mems[1], "delay")
    assert 14.0 < delay["estimate"] < 16.0
    assert delay["noise_sigma"] < 1.5  # its walk is one of the noises chosen
    assert 0.9 < fog_mems[1]["nis"]["mean"] < 1.1
    assert fog_mems[2]["nis"]["mean"] > 20


def test_fog_mems_agrees_with_its_author_where_it_does(fog_mems):
    found = fog_mems[1]
    differ = {tr.named(s) for s in found["states"] if s["reference"] is not None and abs(s["difference_sigmas"]) > 3}
    assert differ == {"gyro bias down"}
    assert np.linalg.norm([s["estimate"] for s in state(found, "lever arm")]) == pytest.approx(15, abs=3)


# ---------------------------------------------------------------- what the user sees


def test_what_was_refused_is_counted_and_in_no_figure(simulated, model, result):
    """For two seconds the master repeats itself, and its stamps go on."""
    v_n, euler = simulated.master.v_n.copy(), simulated.master.euler.copy()
    v_n[60:80], euler[60:80] = v_n[59], euler[59]
    frozen = replace(simulated, master=replace(simulated.master, v_n=v_n, euler=euler))
    said = tr.run(frozen, model, noise=NOISE, lever_b=LEVER_B)
    assert said["refused"] == {"twice": 20}
    assert said["used"] == said["updates"] - 20
    assert f"{said['updates']} messages of the master in " in tr.report(said)
    assert f"of which {said['used']} used; refused: twice 20;" in tr.report(said)
    assert said["nis"]["with"]["mean"] == pytest.approx(result["nis"]["with"]["mean"], abs=0.03)
    assert said["nis"]["with"]["by_quarter"][1] == pytest.approx(result["nis"]["with"]["by_quarter"][1], abs=0.2)
    assert_truth(said)


def test_the_page_holds_the_report_its_pictures_and_its_numbers_and_nothing_beside_it(result, tmp_path):
    assert "all of them used" in tr.report(result)
    one = tr.study(result["model"])
    *pictures, html = drawn(one, result, tmp_path)
    out = document(one, Replay(None), result, [*pictures, html])
    assert out["good"] and out["figures"] == [str(path) for path in (*pictures, html)]
    assert "history" not in out["result"]
    assert html.suffix == ".html" and len(pictures) == 2
    text = html.read_text()
    assert numbers_of(text) == out["result"]
    assert not re.search(r"""(src|href)="(?!data:)""", text) and "http" not in text
    assert [base64.b64decode(part) for part in re.findall(r"image/png;base64,([^\"]+)", text)] == [
        picture.read_bytes() for picture in pictures
    ]
    assert not one.good({**result, "nis": {**result["nis"], "with": result["nis"]["without"]}})


def test_what_the_page_shows_of_the_states_is_what_was_found(result):
    html = page("sea", tr.report(result))
    table = next(part for part in re.findall(r"<table>(.*?)</table>", html, re.DOTALL) if "by noise" in part)
    rows = [re.findall(r"<td>(.*?)</td>", row) for row in re.findall(r"<tr>(.*?)</tr>", table, re.DOTALL)[1:]]
    assert [row[0] for row in rows] == [f"{s['state']} {s['axis']}".strip() for s in result["states"]]
    for row, state in zip(rows, result["states"], strict=True):
        assert float(row[1]) == pytest.approx(state["estimate"], abs=state["sigma"] / 10)
        assert float(row[2]) == pytest.approx(state["sigma"], rel=0.06)
        assert float(row[3]) == pytest.approx(state["noise_sigma"], rel=0.06)
        assert row[4] == state["unit"]
    for finding in result["read"]:
        assert escape(f"{finding['level']}: {finding['where']}: {finding['text']}", quote=False) in html


def test_a_name_cannot_break_the_page(result):
    spoilt = {**result, "title": "</script><b>&"}
    html = page(spoilt["title"], tr.report(spoilt), numbers={"title": spoilt["title"]})
    assert "<b>" not in html and numbers_of(html)["title"] == spoilt["title"]


def test_a_walk_of_zero_is_one_that_is_not_seen():
    noises, free = tr.noise_vector({"delay": 0.0, "gyro_walk": 0.0, "accel_walk": 0.0})
    said = tr.said_noise(noises, free, np.zeros(len(noises)), 0)
    assert not any(said[name]["chosen"] or any(said[name]["seen"]) for name in ("delay", "gyro_walk", "accel_walk"))


def test_a_noise_that_the_innovations_do_not_tell_has_no_upper_end_and_json_takes_it():
    noises, free = tr.noise_vector({})
    said = tr.said_noise(noises, free, np.full(len(noises), 1e3), 1)
    assert said["gyro"]["low"] == [0.0] and said["gyro"]["high"] == [None]
    assert "(the innovations do not tell)" in tr._noise("gyro", said["gyro"])
    json.dumps(said, allow_nan=False)


def test_datasheet_units_are_read_by_name():
    assert quantity("0.15 deg/sqrt(h)", "gyro noise") == pytest.approx(quantity("9 deg/h/sqrt(Hz)", "gyro noise"))
    assert quantity("3.6 deg/h/sqrt(Hz)", "gyro noise") == pytest.approx(quantity("1 mdps/sqrt(Hz)", "gyro noise"))
    assert quantity("100 ug/sqrt(Hz)", "accelerometer noise") == pytest.approx([G * 1e-4])
    assert quantity("0.06 m/s/sqrt(h)", "accelerometer noise") == pytest.approx([1e-3])
    assert quantity("50 mg", "acceleration") == pytest.approx([0.05 * G])
    np.testing.assert_allclose(quantity("-8, 2,12 cm", "length", 3), [-0.08, 0.02, 0.12])
    np.testing.assert_allclose(quantity("2 mm/s", "velocity", 2), [0.002, 0.002])


@pytest.mark.parametrize(
    ("text", "kind", "count", "says"),
    [
        ("0.15", "gyro noise", 1, "deg/sqrt(h)"),
        ("0.15 deg", "gyro noise", 1, "deg/sqrt(h)"),
        ("a mg", "acceleration", 1, "not a number"),
        ("1, 2 cm", "length", 3, "one number or 3"),
        ("inf mg", "acceleration", 1, "finite"),
    ],
)
def test_what_is_no_quantity_is_one_line(text, kind, count, says):
    with pytest.raises(BoresightError) as error:
        quantity(text, kind, count)
    assert says in str(error.value)


@pytest.mark.parametrize(
    ("change", "options", "says"),
    [
        (lambda r: replace(r, master=None), {}, "has no master"),
        (lambda r: replace(r, master=replace(r.master, v_n=None)), {}, "euler-matching"),
        (lambda r: replace(r, master=replace(r.master, position=None)), {}, "position"),
        (lambda r: replace(r, master=r.master.cut(slice(0, 9))), {}, "needs 10"),
        (lambda r: r, {"noise": {"gyros": 1e-4}}, "there are gyro, accel"),
        (lambda r: r, {"noise": {"gyro": 1.0}}, "out of range"),
        (lambda r: r, {"rate_hz": 0.0}, "above zero"),
    ],
)
def test_what_cannot_be_replayed_is_one_line(simulated, model, change, options, says):
    with pytest.raises(BoresightError) as error:
        tr.run(change(simulated), model, **options)
    assert says in str(error.value)
    assert "\n" not in str(error.value)


def test_a_lever_arm_that_was_taken_as_zero_is_named_where_innovations_are_not_white(result):
    zero = {**result, "lever_given_m": None}
    coloured = {**result["nis"], "with": {**result["nis"]["with"], "white": False}}
    hint = "the lever arm was taken as zero: look whether it is there"
    assert hint in tr.report({**zero, "nis": coloured})
    assert hint not in tr.report(zero) and hint not in tr.report({**result, "nis": coloured})


@pytest.mark.parametrize(("value", "grade", "named"), [(1.0, None, 0), (3.0, None, 1), (1.0, "navigation", 1)])
def test_a_noise_that_no_such_sensor_has_begins_the_report_and_is_not_good(result, value, grade, named):
    """The walk of an accelerometer's bias, mg/sqrt(h): a heading that is off by degrees comes out as such a one."""
    noise = {**result["noise"], "accel_walk": {**result["noise"]["accel_walk"], "chosen": True, "value": [value]}}
    found = {**result, "noise": noise, "hidden": tr.hidden(noise, grade)}
    assert len(found["hidden"]) == named
    assert tr.study("velocity-attitude").good(found) == (not named)
    first = tr.report(found).splitlines()[2]
    assert ("accel walk noise came out as" in first) == bool(named)


def test_a_pass_is_the_same_whatever_flies_beside_it(simulated, model):
    cut, noises = tr.prepare(simulated, None), tr.noise_vector(NOISE)[0]
    start = np.r_[np.zeros(16), LEVER_B]
    alone = tr.fly(cut, model, noises, start, tr.PRIOR, tr.PRIOR["delay"])
    beside = tr.fly(cut, model, np.array([2 * noises, noises]), start, tr.PRIOR, tr.PRIOR["delay"])
    for part in ("nu", "S", "estimate", "sigma"):
        np.testing.assert_allclose(beside[part][:, 1], alone[part], rtol=1e-9, atol=1e-12)


def test_a_cut_sample_follows_its_neighbours_where_these_are_no_noise():
    t = 0.01 * np.arange(1, 201)
    sums = np.stack([np.sin(3 * t), t**2, np.cos(2 * t)], axis=-1)
    imu = Inertial("increments", "end", t, np.diff(sums, axis=0, prepend=[[0, 0, 1]]), np.zeros((200, 3)))
    cuts = np.array([0.103, 0.5, 0.9061])
    steps = passes.pieces(imu, cuts)
    exact = np.diff(np.stack([np.sin(3 * cuts), cuts**2, np.cos(2 * cuts)], axis=-1), axis=0)
    found = np.add.reduceat(steps.dtheta_ib_b, steps.first[:-1])
    np.testing.assert_allclose(found, exact, atol=3e-7)  # 1e-5 to 1e-4 where a sample is cut evenly
    noise = np.random.default_rng(2).standard_normal((400, 6))
    assert (passes.steadiness(noise) < 0.2).all() and (passes.steadiness(np.cumsum(noise, axis=0)) > 0.5).all()


def test_a_hole_goes_at_the_rate_of_what_follows_and_counts_as_doubt():
    imu = Inertial("rates", "end", np.array([0.1, 0.2, 0.3, 0.6, 0.7]), np.ones((5, 3)), np.zeros((5, 3)))
    steps = passes.pieces(imu, np.array([0.15, 0.4, 0.65]))
    assert steps.dt.sum() == pytest.approx(0.5)
    assert steps.dtheta_ib_b.sum(0) == pytest.approx([0.5] * 3)
    assert np.all(steps.dt[steps.first[1] : steps.first[2]].sum() == pytest.approx(0.25))
    gyro = np.array([1.0, 1, 1, 3, 3])[:, None] * np.ones(3)
    doubt = passes.doubts(Inertial("rates", "end", imu.time, gyro, np.zeros((5, 3))), np.array([0.15, 0.4, 0.65]))
    assert doubt[:, 0] == pytest.approx([0.0, 0.2 * 2 * np.sqrt(3)]) and not doubt[:, 1].any()
