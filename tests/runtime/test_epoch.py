"""An Epoch, and a filter that keeps its state in the C: the same bits as the calls one by one."""

import numpy as np
import pytest

from boresight import BoresightError
from boresight.runtime.compiled import CompiledFilter
from boresight.runtime.epoch import Epoch
from boresight.runtime.filter import Filter
from boresight.runtime.library import load

pytestmark = pytest.mark.usefixtures("quickly")
NOISE = {"gyro_noise": 1e-4, "accel_noise": 5e-3, "gyro_bias_noise": 1e-7, "accel_bias_noise": 1e-5}
SIGMA = np.array([1e-6, 1e-6, 5, 0.1, 0.1, 0.1, 0.01, 0.01, 0.02, *3 * (1e-5,), *3 * (0.01,)])
F_B, REFERENCE = np.array([0, 0, 9.8]), np.array([1.0, 0, 0, 1e-3])


def begun(runs, kind=CompiledFilter, **more):
    nav = {"position": np.array([0.5, 0.75, 100.0]), "v_n": np.full((*runs, 3), 0.01),
           "q_b2n_wxyz": np.array([1.0, 0, 0, 0]), "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3)}  # fmt: skip
    return kind(load("azimuth-hold", **more), nav, np.diag(SIGMA**2))


def increments(runs, samples, seed):
    rng = np.random.default_rng(seed)
    made = {"dtheta_ib_b": rng.normal(0, 1e-5, (samples, *runs, 3)), "dv_b": rng.normal(0, 1e-4, (samples, *runs, 3))}
    made["dv_b"][..., 2] += 0.098
    before = {f"{name.split('_')[0]}_before": np.roll(value, 1, axis=0) for name, value in made.items()}
    return made | before


@pytest.mark.parametrize("runs, lanes", [((), None), ((5,), 4), ((2, 3), 8), ((1,), 1)])
def test_an_epoch_has_the_bits_of_its_calls_one_by_one(runs, lanes):
    one, other = begun(runs, lanes=lanes), begun(runs, lanes=lanes)
    epoch = Epoch(one, 10, ["zupt", "azimuth"], runs=runs, shared=["dt"])
    epoch.strapdown["dt"], epoch.predict["dt"], epoch.predict["f_b"] = 0.01, 0.1, F_B
    for name, value in NOISE.items():
        epoch.predict[name] = value
    epoch.measured["zupt"]["R"], epoch.measured["azimuth"]["R"] = 1e-4, 1e-6
    epoch.measured["azimuth"]["q_ref_wxyz"] = REFERENCE
    epoch.measured["zupt"].rows[..., 1] = 0
    epoch.measured["azimuth"].gates[0] = 4
    for k in range(4):
        given = increments(runs, 10, k)
        for name, value in given.items():
            epoch.strapdown[name] = value
        assert epoch() == 0 and epoch.status.shape == runs
        for i in range(10):
            other.strapdown(dt=0.01, **{name: value[i] for name, value in given.items()})
        other.predict(dt=0.1, f_b=F_B, **{name: np.full(3, value) for name, value in NOISE.items()})
        zupt = other.update("zupt", np.full(3, 1e-4), rows=[True, False, True])
        azimuth = other.update("azimuth", [1e-6], q_ref_wxyz=REFERENCE, gate=4)
        other.feedback()
        for name, innovation in (("zupt", zupt), ("azimuth", azimuth)):
            for part in ("nu", "S", "used", "nis"):
                assert np.array_equal(getattr(epoch.measured[name], part), getattr(innovation, part)), part
        assert np.array_equal(one.P, other.P) and not one.x.any()
        assert all(np.array_equal(one.nav[name], other.nav[name]) for name in one.nav)
        assert np.array_equal(one.variances(), np.diagonal(one.P, axis1=-2, axis2=-1))


def test_what_is_assigned_or_changed_in_place_is_flown():
    loops = begun((3,)), begun((3,), Filter)
    for loop in loops:
        loop.predict(dt=0.1, f_b=F_B, **{name: np.full(3, value) for name, value in NOISE.items()})
        loop.nav["v_n"][1] = [0.1, 0.2, 0.3]
        loop.P[..., 8, 8] += 1e-4
        loop.update("zupt", np.full(3, 1e-4))
        loop.nav["gyro_bias"] = np.full(3, 1e-6)
        loop.x[2] = 0.0
        loop.P = loop.P * 2
        loop.feedback()
        loop.nav |= {"accel_bias": np.zeros(3)}
    sigma = np.sqrt(np.diagonal(loops[1].P, axis1=-2, axis2=-1))
    assert (np.abs(loops[0].P - loops[1].P) < 1e-9 * sigma[..., :, None] * sigma[..., None, :]).all()
    for name, value in loops[1].nav.items():
        assert np.allclose(loops[0].nav[name], value, rtol=1e-12, atol=1e-15)
    assert np.allclose(loops[0].variances(), np.diagonal(loops[1].P, axis1=-2, axis2=-1), rtol=1e-12)


def test_what_is_seen_is_what_stands_there_and_cannot_be_changed():
    loop = begun((5,), lanes=4)
    epoch = Epoch(loop, 1, predict=False, feedback=False, runs=(5,))
    epoch.strapdown["dt"], epoch.strapdown["dv_b"] = 0.01, np.array([0.01, 0, 0.098])
    for _ in range(3):
        before = loop.nav.seen("v_n").copy()
        assert epoch() == 0
        seen = loop.nav.seen("v_n")
        assert np.array_equal(seen, loop.nav["v_n"]) and not np.array_equal(seen, before)
        with pytest.raises(ValueError):
            seen[0] = 1.0
        loop.nav["v_n"][1] = 0.5
    with pytest.raises(KeyError):
        loop.nav.seen("nothing")


def test_an_epoch_without_a_part_leaves_it_out():
    loop = begun((2,))
    step = Epoch(loop, 1, predict=False, feedback=False, runs=(2,))
    step.strapdown["dt"], step.strapdown["dv_b"] = 0.01, [0, 0, 0.098]
    P = loop.P
    assert step() == 0
    assert np.array_equal(loop.P, P)
    assert loop.nav["v_n"].shape == (2, 3) and (loop.nav["v_n"] != 0.01).any()


def test_what_an_epoch_cannot_be_is_named():
    loop = begun((2,))
    with pytest.raises(BoresightError, match="no measurement 'zpt'; it has azimuth, zaru, zupt"):
        Epoch(loop, 1, ["zpt"])
    with pytest.raises(BoresightError, match="no input 'zero'"):
        Epoch(loop, 1, shared=["zero"])
    with pytest.raises(BoresightError, match="samples is -1"):
        Epoch(loop, -1)
    loop.considered = np.ones(15, dtype=bool)
    with pytest.raises(BoresightError, match="considered"):
        Epoch(loop, 1)
    with pytest.raises(BoresightError, match="no 3 lanes; there are 1, 2, 4, 8"):
        load("azimuth-hold", lanes=3)
