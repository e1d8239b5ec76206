"""A unit's noises from a log at rest: found, pasted, drawn; and a log that is none of noise is named."""

import json
import re
import tomllib
from contextlib import contextmanager
from dataclasses import replace

import numpy as np
import pytest
from at_rest import ACCEL, KINDS, SI, log

from boresight import BoresightError, cli
from boresight.analysis import figures, noise
from boresight.runtime.recording import read
from boresight.runtime.recording.read import read_at_rest
from boresight.runtime.simulation import drive
from boresight.runtime.units import quantity

DEG, G = np.pi / 180, 9.80665
DESCRIPTION = """
file = "log.npz"
[imu]
kind = "rates"
time_marks = "{marks}"
body = "FRD"
time = {{ columns = "t", unit = "s" }}
gyro = {{ columns = "gyro", unit = "deg/s" }}
accel = {{ columns = "accel", unit = "m/s^2" }}
temperature = {{ columns = "warm", unit = "degC" }}
"""


@pytest.fixture(scope="module")
def healthy():
    return log()


def changed(recording, gyro=None, accel=None, **more):
    imu = recording.imu
    gyro = imu.gyro if gyro is None else gyro(imu.gyro.copy(), imu.time)
    accel = imu.accel if accel is None else accel(imu.accel.copy(), imu.time)
    return replace(recording, imu=replace(imu, gyro=gyro, accel=accel), **more)


def test_a_healthy_log_has_its_noises_and_no_fault(healthy):
    found = noise.identify(healthy)
    assert found.good and not any(one.level == "error" for one in found.findings)
    for fits, truth in ((found.gyro, np.array(KINDS["industrial"]) * SI), (found.accel, ACCEL)):
        for fit in fits:
            assert (fit.low[1:3] / 1.01 <= truth[1:3]).all() and (truth[1:3] <= fit.high[1:3] * 1.01).all()


@pytest.mark.parametrize("kind", KINDS)
def test_logs_of_every_kind_are_no_fault(kind):
    assert noise.identify(log(3, 24_000, kind)).good


def knocked(f, t):
    f[20_000:20_010] += [1.0, 0, 0]
    return f


def tilted(f, t):
    f[18_000:, 0] += 0.5
    return f


def clipped(w, t):
    return np.clip(w, w.mean(0) - 2 * w.std(0), w.mean(0) + 2 * w.std(0))


FAULTS = {
    "knocked": ({"accel": knocked}, "imu.accel", "static: at 1000 s it shakes"),
    "tilted": ({"accel": tilted}, "imu.accel", "static: front: at 900 s its mean changes, by 5.* mg"),
    "a swing": (
        {"gyro": lambda w, t: w + 0.05 * DEG * np.sin(2 * np.pi * t / 8)[:, None]}, "imu.gyro",
        r"static: \w+ shakes at 0.12\d Hz, amplitude 18\d deg/h",
    ),
    "an engine": (
        {"accel": lambda f, t: f + [0, 0, 0.05] * np.sin(2 * np.pi * 4.3 * t)[:, None]}, "imu.accel",
        "static: down shakes at 4.3 Hz, amplitude 5.*e.03 ug",
    ),
    "clipped": ({"gyro": clipped}, "imu.gyro", "front: clipped: .* samples are"),
    "quantised": (
        {"gyro": lambda w, t: np.round(w / (3 * w.std(0))) * 3 * w.std(0)}, "imu.gyro", "quantised: . different",
    ),
    "warming up": (
        {"gyro": lambda w, t: w + 0.05 * DEG * np.exp(-t / 300)[:, None] * [1, 0, 0]}, "imu.gyro",
        "driven by temperature: front drifts by -.* deg/h in its first quarter",
    ),
    "two axes drift": (
        {"gyro": lambda w, t: w + 0.02 * DEG * np.sin(t / 400)[:, None] * [1, -0.7, 0]}, "imu.gyro",
        "driven by temperature: front drifts together with gyro right",
    ),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS)
def test_a_log_that_is_not_one_of_noise_is_named_in_one_line(healthy, fault):
    how, where, text = FAULTS[fault]
    found = noise.identify(changed(healthy, **how))
    wrong = [one for one in found.findings if one.level == "error"]
    assert not found.good and {one.where for one in wrong} == {where}
    assert len({one.name for one in wrong}) == 1 and not any("\n" in one.text for one in wrong)
    assert re.search(text, wrong[0].text), wrong[0].text


def test_a_temperature_that_drives_is_named_with_its_slope(healthy):
    t = healthy.imu.time
    warm = 25 + 10 * np.sin(t / 500)
    driven = changed(healthy, accel=lambda f, t: f + 1e-3 * G * warm[:, None] * [0, 0.5, 0],
                     temperature=np.column_stack([t, warm])[::20])  # fmt: skip
    (one,) = [one for one in noise.identify(driven).findings if one.level == "error"]
    assert (
        one.where == "imu.accel"
        and re.search("right follows it by (499|50.) ug", one.text)
        and one.name == "temperature"
    )
    steady = replace(healthy, temperature=np.column_stack([t, warm]))
    assert noise.identify(steady).good


def test_a_log_that_is_too_short_or_stands_still_is_refused(healthy):
    imu = healthy.imu
    short = replace(imu, time=imu.time[:1000], gyro=imu.gyro[:1000], accel=imu.accel[:1000])
    with pytest.raises(BoresightError, match="log: 50 s are too short"):
        noise.identify(replace(healthy, imu=short))
    with pytest.raises(BoresightError, match=r"imu\.gyro right: all samples are the same number"):
        noise.identify(changed(healthy, gyro=lambda w, t: w * [1, 0, 1]))


def test_a_gauss_markov_process_has_the_allan_variance_of_its_autocovariance():
    """Half the mean square difference of two neighbouring means, of a process whose covariance is exp(-|t|/T)."""
    T, fine = 20.0, 400
    for tau in (2.0, 40.0, 300.0):
        t = (np.arange(2 * fine) + 0.5) * tau / fine
        w = np.repeat([-1.0, 1.0], fine) / fine
        expected = w @ np.exp(-np.abs(t[:, None] - t) / T) @ w / 2
        assert noise.gauss_markov(np.array([tau]), 1.0, T)[0] == pytest.approx(expected, rel=2e-3)


# ---------------------------------------------------------------- from a file, and back into one


def written(folder, marks="end", **more):
    made = log(5, 24_000)
    imu = made.imu
    arrays = {"t": imu.time, "gyro": imu.gyro / DEG, "accel": imu.accel, "warm": np.full(len(imu.time), 30.0)}
    np.savez(folder / "log.npz", **arrays | more)
    (folder / "log.toml").write_text(DESCRIPTION.format(marks=marks))
    return folder / "log.toml"


def run(capsys, *words):
    with pytest.raises(SystemExit) as ended:
        cli.main(["noise", *map(str, words)])
    out = capsys.readouterr()
    return ended.value.code or 0, out.out, out.err


def test_the_command_reports_and_draws(tmp_path, capsys):
    status, out, _ = run(capsys, written(tmp_path), "-o", tmp_path / "out")
    assert status == 0 and "angle random walk, deg/sqrt(h)" in out and "read from, s" in out
    assert max(map(len, out.splitlines())) <= 100
    assert (tmp_path / "out" / "noise.png").stat().st_size > 20_000
    status, out, _ = run(capsys, tmp_path / "log.toml", "--json")
    found = json.loads(out)
    walk = found["gyro"][0]["terms"][1]
    assert walk["unit"] == "deg/sqrt(h)" and walk["low"] < 0.15 < walk["high"] and walk["seen"] is True
    assert found["good"] and found["rate_hz"] == pytest.approx(20) and len(found["accel"][2]["curve"]["tau_s"]) > 8


def test_a_fault_ends_with_one(tmp_path, capsys):
    bad = log(5, 24_000).imu
    status, out, _ = run(capsys, written(tmp_path, accel=tilted(bad.accel.copy(), None)))
    assert status == 1 and out.startswith("error: imu.accel: not static: front: at 900 s")
    assert "[noise]" not in out and out.rstrip().endswith("no lines to paste: this is no log of noise alone")


def test_the_lines_to_paste_are_read_by_a_replay(tmp_path):
    lines = noise.identify(read_at_rest(written(tmp_path))).lines()
    pasted = lines.split("# constants")[0]
    (tmp_path / "log.toml").write_text(DESCRIPTION.format(marks="end") + pasted)
    known = read(tmp_path / "log.toml", allow=["down"]).noise
    assert known == tomllib.loads(pasted)["noise"]
    assert set(known) == {"gyro", "accel", "gyro_instability", "accel_instability", "correlation"}
    assert quantity(known["gyro"], "gyro noise")[0] == pytest.approx(0.15 * DEG / 60, rel=0.02)
    # and what is pasted into a model's constants
    constants = {}
    exec(lines.split("random walks\n")[1], constants)
    assert constants["accel_noise"] == pytest.approx(60e-6 * G, rel=0.02)


def test_rates_at_instants_are_not_joined_and_the_side_that_is_up_does_not_matter(tmp_path):
    plain = read_at_rest(written(tmp_path))
    turned = -log(5, 24_000).imu.accel
    points = read_at_rest(written(tmp_path, marks="point", accel=turned))
    assert np.array_equal(points.imu.gyro, plain.imu.gyro) and points.imu.kind == "rates"
    assert np.array_equal(points.imu.accel, -plain.imu.accel)
    assert points.temperature.shape == (24_000, 2) and points.temperature[0, 1] == 30.0


def test_the_figure_holds_what_was_measured_and_what_a_filter_expects(healthy, tmp_path, monkeypatch):
    found, panels = noise.identify(healthy), []

    @contextmanager
    def kept(*args, **more):
        with figures.figure(*args, **more) as (drawing, axes):
            panels.extend(axes)
            yield drawing, axes

    monkeypatch.setattr(noise, "figure", kept)
    found.draw(tmp_path / "noise.png")
    gyro, accel = panels
    measured = [line for line in gyro.get_lines() if line.get_marker() == "o"]
    assert len(measured) == 3
    for line, fit in zip(measured, found.gyro, strict=True):
        assert line.get_xdata() == pytest.approx(fit.tau)
        assert line.get_ydata() == pytest.approx(np.degrees(fit.deviation) * 3600)
    (expected,) = (line for line in accel.get_lines() if line.get_linestyle() == "--")
    T, sigmas = found.bias
    tau = found.accel[0].tau
    model = found.walk(found.accel) ** 2 / tau + noise.gauss_markov(tau, sigmas["accel"], T)
    assert expected.get_ydata() == pytest.approx(np.sqrt(model) / (G * 1e-6))
    # it expects what is measured, by the width of a Gauss-Markov process's dips about a flat floor
    assert np.abs(np.log(expected.get_ydata() * G * 1e-6 / found.accel[0].model)).max() < 0.5


def test_a_replay_takes_the_noises_of_the_description_unless_an_option_differs(tmp_path, monkeypatch):
    path = drive.simulate(tmp_path / "drive", seed=1, duration=12.0)
    path.write_text(path.read_text() + '\n[noise]\ngyro = "0.3 deg/sqrt(h)"\naccel = "60 ug/sqrt(Hz)"\n')
    flown = []
    monkeypatch.setattr(cli, "fly", lambda one, scenario, *more: flown.append(scenario.settings["noise"]))
    for words in ([], ["--gyro-noise", "0.2 deg/sqrt(h)"]):
        with pytest.raises(SystemExit):
            cli.main(["replay", str(path), *words])
    by_description, by_option = flown
    assert by_description["gyro"] == pytest.approx(0.3 * DEG / 60) and by_option["gyro"] == pytest.approx(
        0.2 * DEG / 60
    )
    assert by_description["accel"] == by_option["accel"] == pytest.approx(60e-6 * G)
