"""Replays: a simulated recording gives its truth back, and the real one what its author states, within their sigmas."""

import json
from dataclasses import replace

import numpy as np
import numpy_euler_matching
import pytest
from tools import real_recording

from boresight import BoresightError
from boresight.cli import main
from boresight.runtime import rotation
from boresight.runtime.recording import best_delay, read
from boresight.runtime.recording.check import shown
from boresight.runtime.simulation.drive import simulate
from boresight.runtime.units import ARCMIN
from boresight.studies.replays import euler_matching as replay
from tests.drawing import drawn

FOG_MEMS = "fog_mems_transfer.npz"


@pytest.fixture(scope="module")
def simulated(tmp_path_factory):
    return read(simulate(tmp_path_factory.mktemp("simulated") / "drive", seed=1))


@pytest.fixture(scope="module")
def simulated_result(simulated, library):
    return replay.run(simulated, library)


@pytest.fixture(scope="module")
def fog_mems():
    return read(real_recording(FOG_MEMS))


@pytest.fixture(scope="module")
def fog_mems_result(fog_mems, library):
    return replay.run(fog_mems, library)


# ---------------------------------------------------------------- a simulated recording: truth is known


def test_simulated_misalignment_comes_back_within_three_sigmas(simulated_result):
    assert np.abs(simulated_result["misalignment"]["difference_sigmas"]).max() < 3
    assert max(simulated_result["misalignment"]["sigma_arcmin"][1:]) < 0.4


def test_simulated_noises_are_found(simulated_result):
    """0.2 deg/sqrt(h) and 0.2 arcmin went in; 599 updates know them to a few percent, the gyro's to a quarter."""
    np.testing.assert_allclose(simulated_result["noise"]["angle_arcmin"], 0.2, rtol=0.12)
    np.testing.assert_allclose(simulated_result["noise"]["gyro_deg_sqrt_h"], 0.2, rtol=0.3)


def test_simulated_innovations_are_consistent_and_white(simulated_result):
    nis = simulated_result["nis"]
    assert nis["consistent"]
    assert np.abs(nis["lag1"]).max() < 1.5 * nis["lag1_bound"]
    assert 0.8 < min(nis["by_quarter"]) < max(nis["by_quarter"]) < 1.25


def test_true_noises_give_consistent_nis_without_any_choice(simulated, library):
    """Nothing is fitted here, so that NIS is free to be wrong."""
    gyro, angle = np.full(3, 0.2 * replay.DEG_SQRT_H), np.full(3, 0.2 * ARCMIN)
    honest = replay.run(simulated, library, gyro_noise=gyro, angle_noise=angle)
    assert honest["noise"]["passes"] == 0
    assert honest["nis"]["consistent"]
    assert not replay.run(simulated, library, gyro_noise=gyro, angle_noise=angle / 2)["nis"]["consistent"]


def test_exact_residual_keeps_its_sigma_where_the_papers_does_not(tmp_path, library):
    """Roll is hardly seen in this motion, and the second-order error of Song-Lee (18) is enough to push it off."""
    recording = read(simulate(tmp_path / "drive", seed=2))
    noises = {"gyro_noise": np.full(3, 0.2 * replay.DEG_SQRT_H), "angle_noise": np.full(3, 0.2 * ARCMIN)}
    exact = replay.run(recording, library, measurement="euler_exact", **noises)["misalignment"]["difference_sigmas"]
    paper = replay.run(recording, library, measurement="euler", **noises)["misalignment"]["difference_sigmas"]
    assert np.abs(exact).max() < 1.5
    assert paper[0] > 3
    np.testing.assert_allclose(paper[1:], exact[1:], atol=0.1)


def test_delay_of_the_simulated_master_is_seen_and_taken_off(tmp_path, library):
    late = read(simulate(tmp_path / "late", seed=1, delay=0.03, duration=40.0))
    assert best_delay(late.imu, late.master)[0] == pytest.approx(0.03, abs=0.002)
    straight = replay.run(late, library, delay=0.03)
    assert np.abs(straight["misalignment"]["difference_sigmas"]).max() < 3
    late_as_is = replay.run(late, library)
    # A hundred is odds of 1e43 to one.
    assert late_as_is["minus_log_likelihood"] > straight["minus_log_likelihood"] + 100
    assert late_as_is["noise"]["gyro_deg_sqrt_h"][0] > 5 * straight["noise"]["gyro_deg_sqrt_h"][0]


# ---------------------------------------------------------------- the filter that flies


def test_one_turn_an_interval_is_every_sample_and_numpy_flies_as_the_compiled_model(simulated, library):
    short = replace(simulated, master=simulated.master.cut(slice(0, 40)))
    leg = replay.prepare(short, library, simulated.reference["gyro_bias"])
    noises = np.full(3, 1e-4), np.full(3, 1e-4)
    every = replay.fly(leg, library, *noises, "euler")
    for other in (
        replay.fly(leg, library, *noises, "euler", every_sample=False),
        replay.fly(leg, numpy_euler_matching.model(), *noises, "euler"),
    ):
        for name in ("mu", "sigma", "nu", "P"):
            np.testing.assert_allclose(other[name], every[name], rtol=1e-7, atol=1e-11)


def test_initial_covariance_ties_attitude_error_to_misalignment(simulated, library):
    """Before anything is learnt, eps = -C dmu: their sum is known as well as the master's angles, each alone is not."""
    leg = replay.prepare(replace(simulated, master=simulated.master.cut(slice(0, 3))), library, np.zeros(3))
    angle = np.full(3, 1 * ARCMIN)
    track = replay.fly(leg, library, np.full(3, 1e-6), angle, "euler")
    C = rotation.matrix_from_euler(leg.euler[-1])
    both = np.hstack([C.T, np.eye(3)])
    known = np.sqrt(np.diag(both @ track["P"] @ both.T))
    assert known.max() < 1.1 * angle[0]
    assert np.sqrt(np.diag(track["P"])).min() > 10 * angle[0]


# ---------------------------------------------------------------- the real recording


def test_fog_mems_pitch_and_yaw_are_what_the_author_states(fog_mems_result):
    m = fog_mems_result["misalignment"]
    for axis in (1, 2):
        assert abs(m["difference_sigmas"][axis]) < 2
        assert abs(m["difference_arcmin"][axis]) < 3


def test_fog_mems_nis_is_consistent_in_the_mean_but_shows_the_delay(fog_mems, fog_mems_result, library):
    nis = fog_mems_result["nis"]
    assert nis["consistent"]
    assert not nis["white"]
    assert nis["lag1"][1] > 0.3
    late = replay.run(fog_mems, library, delay=0.0155, measurement="euler")
    assert late["nis"]["consistent"]
    assert late["nis"]["white"]
    assert late["minus_log_likelihood"] < fog_mems_result["minus_log_likelihood"] - 4000
    assert abs(late["misalignment"]["difference_arcmin"][0]) < 3  # now roll too
    assert np.abs(late["misalignment"]["difference_arcmin"]).max() < 1.5


def test_fog_mems_roll_is_badly_known_because_its_axis_hardly_moves(fog_mems_result):
    o = fog_mems_result["observability"]
    roll, pitch, yaw = o["misalignment_sigma_arcmin"]
    assert roll > 4 * max(pitch, yaw)
    assert o["correlation"][0] < -0.99
    assert o["correlation"][0] < min(o["correlation"][1:]) - 0.03
    front, right, down = o["axis_stray_deg"]
    assert 7 * front < min(right, down)


def test_fog_mems_without_bias_calibration_fails_loudly(fog_mems, fog_mems_result, library):
    noise = fog_mems_result["noise"]
    bare = replay.run(
        fog_mems,
        library,
        gyro_bias=np.zeros(3),
        gyro_noise=np.array(noise["gyro_deg_sqrt_h"]) * replay.DEG_SQRT_H,
        angle_noise=np.array(noise["angle_arcmin"]) * ARCMIN,
    )
    assert not bare["nis"]["consistent"]
    assert bare["nis"]["mean"] > 20
    # The last estimate may come near by chance; on the way it is far off and sure of itself.
    off, _, _, claimed = replay.worst_excursion(bare, bare["misalignment"]["reference_arcmin"])
    assert abs(off) > 10 * claimed
    calibrated = replay.worst_excursion(fog_mems_result, bare["misalignment"]["reference_arcmin"])
    assert abs(calibrated[0]) < 5 * calibrated[3]


# ---------------------------------------------------------------- what the user sees


def test_result_is_json_and_the_report_says_it(simulated_result):
    again = json.loads(json.dumps(simulated_result))
    beside = {**again, "excursion": replay.worst_excursion(again, again["misalignment"]["estimate_arcmin"])}
    text = replay.report({**again, "without_bias": beside})
    for word in ("roll", "pitch", "yaw", "NIS", "95 % band", "deg/sqrt(h)", "Without the bias"):
        assert word in text


def test_a_replay_is_printed_and_drawn_as_every_study_is(tmp_path, capsys, library):
    toml = simulate(tmp_path / "drive", seed=1, duration=20.0)
    with pytest.raises(SystemExit) as ended:
        main(["replay", str(toml), "--model", "euler-matching", "--json", "-o", str(tmp_path / "out")])
    out = json.loads(capsys.readouterr().out)
    assert set(out) == {"study", "made_from", "scenario", "good", "claims", "result", "figures"}
    assert (out["study"], out["good"], ended.value.code) == ("replay euler-matching", True, 0)
    assert out["scenario"] == {"recording": "drive", "settings": {"delay": 0.0, "rate_hz": None,
                                                                  "measurement": "euler_exact"}}  # fmt: skip
    assert "history" not in out["result"] and {"without_bias", "delay_seen_s"} <= set(out["result"])
    assert (tmp_path / "out" / "replay_drive.png").stat().st_size > 10000


def test_check_returns_one_if_something_is_wrong(tmp_path, capsys):
    toml = simulate(tmp_path / "drive", seed=1, duration=20.0)
    assert shown(read(toml, strict=False)) == 0
    toml.write_text(toml.read_text().replace('"deg" }\naccel', '"rad" }\naccel'))
    assert shown(read(toml, strict=False)) == 1
    assert capsys.readouterr().out.splitlines()[-1].startswith("note")
    assert shown(read(toml, strict=False), as_json=True) == 1
    assert {"level", "where", "text", "name"} == set(json.loads(capsys.readouterr().out)["findings"][0])


@pytest.mark.parametrize(
    ("change", "options", "says"),
    [
        (lambda r: replace(r, master=None), {}, "has no master"),
        (lambda r: replace(r, master=replace(r.master, position=None)), {}, "position"),
        (lambda r: replace(r, master=r.master.cut(slice(0, 2))), {}, "needs 3"),
        (lambda r: r, {"gyro_bias": [0.0, np.nan, 0.0]}, "gyro_bias"),
        (lambda r: r, {"angle_noise": [0.0, 1e-4, 1e-4]}, "angle_noise"),
        (lambda r: r, {"rate_hz": 0.0}, "above zero"),
        (lambda r: r, {"measurement": "quaternion"}, "euler_exact or euler"),
        (lambda r: replace(r, imu=replace(r.imu, time=r.imu.time + (r.imu.time > 30))), {}, "does not cover 30.0000 s"),
    ],
)
def test_what_cannot_be_replayed_is_one_line(simulated, library, change, options, says):
    with pytest.raises(BoresightError) as error:
        replay.run(change(simulated), library, **options)
    assert says in str(error.value)
    assert "\n" not in str(error.value)


def test_a_folder_that_cannot_be_written_to_is_one_line(simulated_result, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(BoresightError, match="cannot write"):
        drawn(replay.STUDY, simulated_result, tmp_path / "file" / "out")
