"""A line of a datasheet: its unit decides what it is, and each convention is named."""

import json

import numpy as np
import pytest

from boresight import BoresightError, cli
from boresight.analysis.datasheet import datasheet, unit_of

DEG = np.pi / 180
G = 9.80665


@pytest.mark.parametrize(
    ("text", "si"),
    [
        ("0.15 deg/sqrt(h)", 0.15 * DEG / 60),
        ("ARW 0.15 deg/rt-hr", 0.15 * DEG / 60),
        ("Angle Random Walk: 0.15 °/√hr typ", 0.15 * DEG / 60),
        ("0.15 °/√h", 0.15 * DEG / 60),
        ("ARW = 0.15 deg/hr^0.5", 0.15 * DEG / 60),
        ("0.15 deg/√hour (1σ)", 0.15 * DEG / 60),
        ("40 ug/sqrt(Hz) rms", 40e-6 * G),
        ("40 µg/√Hz", 40e-6 * G),
        ("0.003 deg/s/sqrt(Hz), bandwidth 80 Hz", 0.003 * DEG),
        ("0.003 dps/rtHz", 0.003 * DEG),
        ("3 mdps/√Hz", 0.003 * DEG),
        ("0.003 (deg/s)/√Hz", 0.003 * DEG),
        ("9 deg/hr/√Hz", 9 * DEG / 3600),
        ("VRW 0.06 m/sec/√hr", 0.001),
        ("3 deg/h/sqrt(h)", 3 * DEG / 3600 / 60),
    ],
)
def test_a_line_is_read_as_it_is_printed(text, si):
    assert datasheet(text).si == pytest.approx(si, rel=1e-12)


def by_name(line):
    return {name: value for name, value, _, _ in line.rows}


def test_one_number_as_steady_sigma_and_as_density():
    """The exact step of a first-order Gauss-Markov process, 300 s, at 100 Hz."""
    sigma = datasheet("1 deg/h", rate_hz=100, correlation_s=300)
    density = datasheet("1 deg/h/sqrt(s)", rate_hz=100, correlation_s=300)
    assert by_name(sigma)["per step of 0.01 s"] == pytest.approx(0.0081648, abs=5e-8)
    assert by_name(density)["per step of 0.01 s"] == pytest.approx(0.0999983, abs=5e-8)
    assert by_name(density)["steady sigma"] == pytest.approx(np.sqrt(150))
    # there and back
    driving = by_name(sigma)["density that drives it"]
    back = datasheet(f"{driving!r} deg/h/sqrt(s)", correlation_s=300)
    assert by_name(back)["steady sigma"] == pytest.approx(1, rel=1e-12)
    assert sigma.lines == ('gyro_instability = "1 deg/h"', 'correlation = "300 s"')


def test_the_step_is_the_scatter_of_a_process_that_is_simulated():
    rng, dt, T = np.random.default_rng(1), 0.5, 3.0
    step = by_name(datasheet("1 deg/h", rate_hz=1 / dt, correlation_s=T))["per step of 0.5 s"]
    x, all_of_it = 0.0, []
    for kick in step * rng.standard_normal(40_000):
        x = np.exp(-dt / T) * x + kick
        all_of_it.append(x)
    assert np.std(all_of_it) == pytest.approx(1, abs=0.03)


def test_a_density_there_and_back_by_the_rate():
    line = datasheet("0.15 deg/sqrt(h)", rate_hz=100)
    two, one = (value for name, value, _, _ in line.rows if name.startswith("per sample"))
    assert two == pytest.approx(0.15 / 60 * 10) and one == pytest.approx(two / np.sqrt(2))
    assert datasheet(f"{two!r} deg/s", rate_hz=100).rows[0][1] == pytest.approx(0.15)
    names = [note for _, _, _, note in line.rows if note]
    assert names == ["spectrum with two sides (IEEE 952)", "spectrum with one side"]
    assert line.lines == ('gyro = "0.15 deg/sqrt(h)"',)


def test_a_bandwidth_is_that_of_one_pole():
    """White noise through a pole of 80 Hz: of a one-sided density n the variance is n^2 pi/2 80 Hz; there and back."""
    line = datasheet("0.003 deg/s/sqrt(Hz), bandwidth 80 Hz")
    rows = [row for row in line.rows if row[0].startswith("within")]
    assert rows[1][1] == pytest.approx(0.003 * np.sqrt(np.pi / 2 * 80))
    back = datasheet(f"{rows[0][1]!r} deg/s rms, BW = 0.08 kHz")
    assert back.rows[0][1] == pytest.approx(0.003 * 60)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("1.0", "a number without a unit may be a density or a sigma; use one of rad/sqrt"),
        ("2 foo", "unit 'foo' is not known; use one of"),
        ("ARW", "there is no number in it"),
        ("0.1 deg/s", "a sigma of what.*give the rate.*bandwidth 80 Hz.*correlation time"),
        ("0 deg/sqrt(h)", "a noise must be above zero"),
        ("-1 deg/sqrt(h)", "a noise must be above zero"),
        ("0.1 deg/s, bandwidth 0 Hz", "the bandwidth is 0; it must be above zero"),
    ],
)
def test_what_is_no_noise_is_one_line(text, says):
    with pytest.raises(BoresightError, match=says) as error:
        datasheet(text)
    assert "\n" not in str(error.value)


def test_rates_and_times_below_zero_are_refused():
    for given in ({"rate_hz": 0.0}, {"correlation_s": -1.0}, {"rate_hz": np.nan}):
        with pytest.raises(BoresightError, match="must be above zero"):
            datasheet("1 deg/h", **given)


def test_units_are_spelled_as_people_do():
    for text in ("deg/rt-hr", "deg/root hour", "deg/√hr", "degrees/sqrt(hr)", "deg/hr^(1/2)", "°/√h", "deg / √ h"):
        assert unit_of(text) == "deg/sqrt(h)", text


def run(capsys, *words):
    with pytest.raises(SystemExit) as ended:
        cli.main(["noise", *words])
    out = capsys.readouterr()
    return ended.value.code or 0, out.out, out.err


def test_the_command_prints_both_conventions(capsys):
    status, out, _ = run(capsys, "--datasheet", "1 deg/h", "--rate", "100 Hz", "--correlation", "300 s")
    assert status == 0 and "0.00816483 deg/h" in out and 'correlation = "300 s"' in out
    status, out, _ = run(capsys, "--datasheet", "ARW 0.15 deg/rt-hr", "--json")
    assert status == 0 and json.loads(out)["si"] == pytest.approx(0.15 * DEG / 60)
    status, out, err = run(capsys, "--datasheet", "1.0")
    assert status == 1 and not out and err.count("\n") == 1
    status, _, err = run(capsys)
    assert status == 1 and "name a log at rest, or a line of a datasheet" in err
