"""From the wire into the loop: what comes in the wrong unit is named, what is right flies."""

import re
import runpy
import struct

import numpy as np
import pytest
from conftest import ROOT
from simulator import standard, turn_between

import boresight.runtime.driver
from boresight import BoresightError, Driver


def through(flight, gyro=lambda w: w, accel=lambda f: f, tag=lambda t: t, **changes):
    """The flight through a driver, as rates, the samples spoilt on their way."""
    setting = flight.setting
    given = {
        "velocity_sigma": setting.v_sigma,
        "attitude_sigma": setting.a_sigma,
        "sigmas": setting.sigmas(),
        "estimates": {"q_b2m_wxyz": flight.q_believed[0], "tau": setting.tau_believed},
        "rates": True,
        "check_s": 5.0,
    }
    driver = Driver("velocity-attitude", **(setting.constants() | given | changes))
    for kind, at_us, *what in flight.events(0):
        if kind == "sample":
            dt, dtheta, dv = what
            driver.sample(tag(1e-6 * at_us), gyro(dtheta / dt), accel(dv / dt))
        else:
            fields = {name: what[0][name] for name in ("v_m_n", "q_m2n_wxyz", "position")}
            driver.message(1e-6 * at_us, **fields)
    return driver


@pytest.fixture(scope="module")
def turning():
    return standard("s-turns", runs=1, seconds=9.0)


@pytest.mark.parametrize("check_s", [0.5, 2.0])
def test_what_is_right_flies_however_short_it_is_looked_at(turning, check_s):
    assert through(turning, check_s=check_s).flying


def test_what_is_right_flies_and_knows_how_well(turning):
    driver, last = through(turning), len(turning.end) - 1
    nav = driver.output(1e-6 * int(turning.end_us[last]))
    off = turn_between(nav["q_b2n_wxyz"], turning.truth(last)["q_b2n_wxyz"])
    assert driver.live.counts()["TAKEN"] > 20 and (np.abs(off) < 4 * nav["sigma"][:3]).all()
    assert nav["sigma"][:3].max() < 1e-3 and abs(nav["tau"] - 0.035) < 4 * nav["sigma"][15]


@pytest.mark.parametrize(
    ("spoilt", "named"),
    [
        ({"gyro": np.degrees}, "imu.gyro: .* degrees declared as radians"),
        ({"gyro": lambda w: -w}, "imu.body: .* left-handed"),
        ({"accel": lambda f: f / 9.80665}, r"imu.accel: .* 1\.\d+ m/s\^2, not about 9.81"),
        ({"accel": lambda f: -f}, "imu.accel: specific force less acceleration .* check axes, signs"),
        ({"tag": lambda t: 1e3 * t}, "is the unit of time right"),
        ({"rates": False}, r"imu.accel: the mean specific force is 777.* check its unit and kind"),
    ],
)
def test_first_seconds_that_do_not_fit_the_master_are_named(turning, spoilt, named):
    with pytest.raises(BoresightError, match=named):
        through(turning, **spoilt)


def test_a_slave_that_waits_long_for_its_master_keeps_a_bounded_past(monkeypatch):
    monkeypatch.setattr(boresight.runtime.driver, "MOST", 100)
    waiting = Driver("velocity-attitude", velocity_sigma=1, attitude_sigma=1, sigmas={}, check_s=1.0)
    for k in range(1, 1001):
        waiting.sample(0.01 * k, np.zeros(3), [0, 0, -0.098])
        assert len(waiting._past) <= 202


def test_sigmas_are_no_variances_and_are_above_zero(turning):
    with pytest.raises(BoresightError, match="attitude_sigma is 0; give one sigma or three, above zero"):
        through(turning, attitude_sigma=0)
    with pytest.raises(BoresightError, match="sigmas holds no 'tau'"):
        through(turning, sigmas={"q_b2m_wxyz": 0.02, "gyro_bias": 1e-5, "accel_bias": 1e-3})


def test_the_example_reads_what_a_socket_would_give(capsys):
    flying, sent = standard("ship", runs=1, seconds=16.0), []
    for kind, at_us, *what in flying.events(0):
        if kind == "sample":
            numbers = [*(what[1] / what[0]), *(what[2] / what[0])]
        else:
            numbers = [*what[0]["v_m_n"], *what[0]["q_m2n_wxyz"], *what[0]["position"]]
        sent.append(kind[:1].upper().encode() + struct.pack(f"<{1 + len(numbers)}d", 1e-6 * at_us, *numbers))
    main = runpy.run_path(str(ROOT / "examples" / "udp_driver.py"))["main"]
    main(iter([*sent, b""]).__next__)
    assert int(re.search(r"(\d+) messages taken", capsys.readouterr().out)[1]) > 20
