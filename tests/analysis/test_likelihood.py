"""The likelihood of innovations: against flights with other noises, and against noises that are known."""

import json

import flights
import numpy as np
import pytest
from at_rest import least

from boresight import BoresightError, Filter, Record, load, noise
from boresight.analysis.likelihood import Linearised, damped_step, settled
from boresight.cli import main


def named(function, *fields):
    function.fields = fields
    return function


class Linear:
    """Two states, two noises and a measurement of both rows, all linear."""

    states = ("a", "b")
    Phi = staticmethod(named(lambda phi: phi, "phi"))
    Q = staticmethod(
        named(lambda u, v: u[..., :1, None] ** 2 * np.diag([1.0, 0]) + v[..., :1, None] ** 2 * B, "u", "v")
    )
    name = "linear"


B = np.array([[0.1, 0.05], [0.05, 0.2]])


def flown(u, v, sigma, seed=3):
    """Minus the log likelihood of a flight with these noises, and its record; the same measurements for all."""
    rng = np.random.default_rng(seed)
    loop = Filter(Linear(), {}, np.diag([1.0, 4.0]), x=np.zeros(2))
    record, cost = Record(loop), 0.0
    phi, H = np.array([[1, 0.1], [-0.05, 0.97]]), np.array([[1.0, 0.3], [0.2, 1.0]])
    for k in range(60):
        loop.predict(phi=phi, u=np.array([u]), v=np.array([v]), dt=1.0)
        rows = np.array([k % 7 != 0, k % 3 != 0])
        z = rng.standard_normal(2) * [1.0, 2.0]
        found = loop.update("seen", np.full(2, sigma**2), z=z, h=H, rows=rows)
        cost += 0.5 * np.sum(np.where(found.used, np.log(found.S) + found.nu**2 / found.S, 0))
        if k == 30:
            loop.inflate(1, np.array([0.5]))
    return cost, record


Linear.seen_H = staticmethod(named(lambda h: h, "h"))


def test_a_linear_flight_with_other_noises_has_the_likelihood_that_is_computed():
    """Flown with (0.3, 0.5, 0.8): the cost of five other triples is that of flights with these."""
    _, record = flown(0.3, 0.5, 0.8)
    walk = Linearised(record)
    assert walk.names == ("u", "v", "R of seen")
    for others in ((0.3, 0.5, 0.8), (1.0, 0.5, 0.8), (0.3, 2.0, 0.8), (0.3, 0.5, 0.1), (0.05, 1.5, 3.0)):
        cost, gradient, _ = walk(np.log(np.array(others) / (0.3, 0.5, 0.8)))
        assert cost == pytest.approx(flown(*others)[0], rel=1e-11)
        for i in range(3):
            bump = np.exp(1e-4 * np.eye(3)[i])
            difference = (flown(*others * bump)[0] - flown(*others / bump)[0]) / 2e-4
            assert gradient[i] == pytest.approx(difference, rel=1e-5, abs=1e-5)


@pytest.mark.parametrize("fly", [flights.matching, flights.hold])
def test_the_gradient_is_that_of_the_cost_and_as_flown_the_cost_is_the_flights(fly):
    p = len(flights.HOLD if fly is flights.hold else flights.MATCHING)
    record = fly(2, np.linspace(0.7, 1.5, p))
    walk = Linearised(record)
    found = record.innovation(walk.names[-1].removeprefix("R of "))
    assert walk(np.zeros(p))[0] == pytest.approx(0.5 * np.sum(np.log(found.S) + found.nu**2 / found.S), rel=1e-9)
    at = np.linspace(-0.4, 0.5, p)
    _, gradient, _ = walk(at)
    for i in range(p):
        bump = 1e-4 * np.eye(p)[i]
        assert gradient[i] == pytest.approx((walk(at + bump)[0] - walk(at - bump)[0]) / 2e-4, rel=1e-5, abs=1e-3)


def test_the_intervals_hold_the_truth_in_their_band():
    """100 runs of two models that were flown with noises off by up to 1.5 times: 95 % of the intervals hold it."""
    hits = []
    for fly, believed in ((flights.matching, (1.5, 0.7)), (flights.hold, (0.7, 1.4, 1.5))):
        inside, _ = flights.held(fly(100, believed), believed)
        assert inside.sum(axis=0).min() >= least(100, 0.95) >= 86
        hits.append(inside)
    hits = np.hstack(hits)
    assert abs(hits.mean() - 0.95) < 3.3 * np.sqrt(0.95 * 0.05 / hits.size)


def test_what_the_flight_does_not_show_has_a_limit_alone():
    """The limit is where the likelihood has fallen by two sigmas."""
    _, record = flown(1e-3, 0.5, 2.0)
    found = noise.likeliest(record)
    assert not found.seen[0] and found.low[0] == 0 and "below" in found.report()
    walk = Linearised(record)
    logs, _, lowest, _ = settled(walk)
    logs[0] = np.log(found.high[0] / walk.sizes[0])
    assert walk(logs)[0] - lowest == pytest.approx(1.96**2 / 2, abs=0.01)


def test_all_runs_together_know_more_than_one():
    record = flights.matching(20, (1.5, 0.7))
    found = noise.likeliest(record)
    truth = np.array(list(flights.MATCHING.values()))
    assert (found.low < truth).all() and (truth < found.high).all()
    assert found.high[1] / found.low[1] < 1.06 and found.cost[1] < found.cost[0]
    assert "flown with a size outside its interval: gyro_noise, R of euler_exact" in found.report()


def test_considered_states_are_refused():
    nav = {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}
    loop = Filter(load("euler-matching"), nav, P=np.eye(6) * 1e-4)
    record = Record(loop)
    loop.predict(omega_in_n=np.zeros(3), gyro_noise=np.full(3, 1e-4), dt=1.0)
    angles = {"euler_b": loop.call("euler_angles"), "euler_m": np.zeros(3)}
    loop.update("euler_exact", R=np.full(3, 1e-6), considered=np.arange(6) > 2, **angles)
    with pytest.raises(BoresightError, match="considered"):
        noise.likeliest(record)


def test_a_step_is_no_longer_than_its_radius_and_goes_down():
    gradient, information = np.array([30.0, -1e-3]), np.array([[2.0, 1.9], [1.9, 2.0]])
    step = damped_step(gradient, information, 0.5)
    assert np.abs(step).max() <= 0.5 and gradient @ step < 0


def test_the_command_finds_the_noises_of_a_flight_in_a_folder(tmp_path, monkeypatch, capsys):
    held = []
    monkeypatch.setattr(flights, "Record", lambda loop: held.append(Record(loop, tmp_path / "flight")) or held[-1])
    flights.matching(1, (1.5, 0.7))
    held[0].stop()
    command = ["noise", str(tmp_path / "flight"), "--model", "euler-matching", "-o", str(tmp_path / "out")]
    with pytest.raises(SystemExit) as ended:
        main([*command, "--json"])
    document = json.loads(capsys.readouterr().out)
    assert not ended.value.code and (tmp_path / "out" / "noise-flight.png").is_file()
    assert document["figures"] == [str(tmp_path / "out" / "noise-flight.png")]
    walk, sigma = flights.MATCHING.values()
    for one, truth, factor in zip(document["noises"], (walk, sigma), (1.5, 0.7), strict=True):
        assert one["low"] < truth < one["high"] and one["given"] == pytest.approx(truth * factor)
    for words in (["--datasheet", "0.1 deg/sqrt(h)"], ["--to", "3 s"]):
        with pytest.raises(SystemExit) as ended:
            main([*command, *words])
        assert ended.value.code and "--model needs the folder of a Record" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["noise", str(tmp_path), "--model", "euler-matching"])
    assert "holds no record" in capsys.readouterr().err
