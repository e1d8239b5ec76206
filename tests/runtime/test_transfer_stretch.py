"""Many intervals of the slave in one call: the same as one by one, whatever is wrong with some of them."""

import numpy as np
import pytest

from boresight.runtime.calibration import Calibration
from boresight.runtime.library import load
from boresight.runtime.transfer import Message, Rules, Transfer
from boresight.runtime.transfer.sensors import Sensors, carried
from boresight.runtime.transfer.start import first
from boresight.runtime.transfer.stretch import Stretch

DT, SECONDS, RUNS = 0.01, 3, (2, 3)
R = np.repeat([0.01, 1e-4], 3) ** 2
SIGMAS = {"q_b2m_wxyz": 0.02, "gyro_bias": 1e-4, "accel_bias": 1e-2, "tau": 0.01}
LEVER = np.array([3.0, 1.0, -1.0])
CONSTANTS = {
    "lever_b": LEVER, "gyro_noise": np.full(3, 4e-5), "accel_noise": np.full(3, 8e-4), "gyro_bias_noise": np.zeros(3),
    "accel_bias_noise": np.zeros(3), "mu_noise": np.zeros(3), "tau_noise": 0.0,
}  # fmt: skip


def message(time, **more):
    swing = 0.05 * np.sin(2 * np.pi * np.asarray(time) / 8)
    return Message(time, R, v_m_n=np.array([swing, 0.0, -swing]), q_m2n_wxyz=np.array([1.0, 0, 0, 0]),
                   position=np.array([0.6, 0.1, 20.0]), **more)  # fmt: skip


def begun(model="velocity-attitude", constants=CONSTANTS, sensors=None, **settings):
    library = load(model)
    start = {"sigmas": SIGMAS}
    if sensors is not None:
        constants, P, estimates, _ = carried(sensors, constants, SIGMAS, {})
        start = {"P": P, "estimates": estimates}
    nav, P, _ = first(message(0.0), library, constants, **start, rate_sigma=0.01, acceleration_sigma=0.1)
    nav = {name: np.broadcast_to(value, (*RUNS, *np.shape(value))).copy() for name, value in nav.items()}
    return Transfer(library, nav, np.broadcast_to(P, (*RUNS, *P.shape)), constants, every=10, **settings)


def stream():
    """time (K,), dtheta and dv (K, 2, 3, 3): a slave that is shaken."""
    rng = np.random.default_rng(3)
    time = DT * np.arange(1, SECONDS * 100 + 1)
    white = rng.standard_normal((2, len(time), *RUNS, 3))
    swing = np.sin(2 * np.pi * time / 3)[:, None, None, None] * np.array([1.0, 0.5, 0.2])
    return time, 2e-4 * swing + 1e-5 * white[0], 1e-3 * swing + 1e-4 * white[1] + np.array([0, 0, -9.8 * DT])


def no_number(time, dtheta, dv):
    dtheta[150, 1, 2, 0] = np.nan
    dv[220:223] = np.inf
    return time, dtheta, dv


def lost_samples(time, dtheta, dv):
    kept = np.r_[0:120, 124:200, 230 : len(time)]  # bridged, and too many
    return time[kept], dtheta[kept], dv[kept]


def twice(time, dtheta, dv):
    order = np.r_[0:130, 128:130, 130 : len(time)]
    return time[order], dtheta[order], dv[order]


def at_full_scale(time, dtheta, dv):
    dv[140:160, 0, 1, 2] = -50 * DT
    return time, dtheta, dv


def out_of_range(time, dtheta, dv):
    dv[150:250, 0, 0, 0] = 400 * DT  # the model knows 300 m/s or so
    return time, dtheta, dv


def as_it_should_be(time, dtheta, dv):
    return time, dtheta, dv


STREAMS = [as_it_should_be, no_number, lost_samples, twice, at_full_scale, out_of_range]


def flown(one_by_one, data, messages=True, **settings):
    loop, (time, dtheta, dv) = begun(**settings), data
    results = []
    for second in range(SECONDS):
        here = (time > second + DT / 2) & (time < second + 1 + DT / 2)
        if one_by_one:
            for sample in zip(time[here], dtheta[here], dv[here], strict=True):
                loop.slave(*sample, DT)
        else:
            loop.slave(time[here], dtheta[here], dv[here], DT)
        if messages:
            results.append(loop.master(message(loop.time - 0.02)))
    return loop, results


@pytest.mark.parametrize("change", STREAMS, ids=lambda change: change.__name__)
def test_many_intervals_at_once_are_those_one_by_one(change):
    settings = {"rules": Rules(full_scale=(5.0, 45.0))}
    (one, _), (many, _) = (flown(by, change(*stream()), messages=False, **settings) for by in (True, False))
    for name, value in one.nav.items():
        np.testing.assert_array_equal(many.nav[name], value)
    for name in ("v_n", "q_b2n_wxyz", "angle", "push"):
        np.testing.assert_array_equal(many.history.recent(name), one.history.recent(name))
    np.testing.assert_array_equal(many.history.time, one.history.time)
    for name in ("rates", "missing_s", "stood_in", "missed_at", "lost", "left"):
        np.testing.assert_array_equal(getattr(many.gaps, name), getattr(one.gaps, name))
    np.testing.assert_array_equal(many._earlier, one._earlier)
    assert (many.time, many._predicted, many._steps) == (one.time, one._predicted, one._steps)
    assert [str(note) for note in many.notes] == [str(note) for note in one.notes]
    # the generated filter and NumPy add up in another order
    sigma = np.sqrt(np.einsum("...ii->...i", one.P)) + 1e-300
    assert np.abs((many.P - one.P) / (sigma[..., :, None] * sigma[..., None, :])).max() < 1e-12


@pytest.mark.parametrize("change", STREAMS, ids=lambda change: change.__name__)
def test_messages_between_them_come_to_the_same(change):
    (one, singly), (many, together) = (flown(by, change(*stream()), rules=Rules(full_scale=(5.0, 45.0)))
                                       for by in (True, False))  # fmt: skip
    assert [str(note) for note in many.notes] == [str(note) for note in one.notes]
    for a, b in zip(singly, together, strict=True):
        np.testing.assert_array_equal(b.verdict, a.verdict)
        np.testing.assert_allclose(b.nis, a.nis, rtol=1e-9)
    for name, value in one.nav.items():
        np.testing.assert_allclose(many.nav[name], value, rtol=1e-9, atol=1e-12)


def test_the_calibration_is_taken_off_and_one_run_s_increments_serve_all():
    time, dtheta, dv = stream()
    alike = time, dtheta[:, 0, 0], dv[:, 0, 0]
    known = Calibration(gyro_bias=(1e-3, 0.0, 0.0), accel_matrix=np.eye(3) * 1.001)
    one, many = (flown(by, alike, messages=False, known=known)[0] for by in (True, False))
    np.testing.assert_array_equal(many.nav["v_n"], one.nav["v_n"])


def test_a_composition_flies_its_own_strapdown():
    sensors = Sensors(gyro_instability=1e-5, bending=1e-3, gyro_scale=1e-3)
    settings = {"model": "velocity-attitude-sensors", "sensors": sensors}
    one, many = (flown(by, stream(), messages=False, **settings)[0] for by in (True, False))
    assert many._stretch is not None
    for name, value in one.nav.items():
        np.testing.assert_array_equal(many.nav[name], value)


def test_healthy_intervals_are_flown_in_the_c_and_only_they(monkeypatch):
    counted = []
    fly = Stretch.fly
    monkeypatch.setattr(Stretch, "fly", lambda self, begin, end: counted.append(end - begin) or fly(self, begin, end))
    flown(False, stream())
    assert sum(counted) == SECONDS * 100
    counted.clear()
    flown(False, lost_samples(*stream()), messages=False)
    assert sum(counted) == 120 + 75 + 0  # behind the second gap the runs are lost until a message comes


def test_without_a_filter_in_c_they_are_flown_one_by_one():
    constants = {name: value for name, value in CONSTANTS.items() if name != "lever_b"} | {"lever_m": LEVER}
    one, many = (flown(by, stream(), messages=False, constants=constants)[0] for by in (True, False))
    assert many._stretch is None
    np.testing.assert_array_equal(many.nav["v_n"], one.nav["v_n"])
    np.testing.assert_array_equal(many.P, one.P)
