"""An Epoch, and a filter that keeps its state in the C: the same bits as the calls one by one."""

import numpy as np
import pytest

from boresight import BoresightError
from boresight.runtime.filter import CompiledFilter, Epoch, Filter
from boresight.runtime.library import load

NOISE = {"gyro_noise": 1e-4, "accel_noise": 5e-3, "gyro_bias_noise": 1e-7, "accel_bias_noise": 1e-5}
SIGMA = np.array([1e-6, 1e-6, 5, 0.1, 0.1, 0.1, 0.01, 0.01, 0.02, *3 * (1e-5,), *3 * (0.01,)])
F_B, REFERENCE = np.array([0, 0, 9.8]), np.array([1.0, 0, 0, 1e-3])


def begun(runs, kind=CompiledFilter, **more):
    nav = {"lon_lat_height": np.array([0.5, 0.75, 100.0]), "v_n": np.full((*runs, 3), 0.01),
           "q_b2n_wxyz": np.array([1.0, 0, 0, 0]), "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3)}  # fmt: skip
    return kind(load("azimuth-hold", **more), nav, np.diag(SIGMA**2))


def increments(runs, samples, seed):
    rng = np.random.default_rng(seed)
    made = {"dtheta_ib_b": rng.normal(0, 1e-5, (samples, *runs, 3)), "dv_b": rng.normal(0, 1e-4, (samples, *runs, 3))}
    made["dv_b"][..., 2] += 0.098
    before = {f"{name.split('_')[0]}_before": np.roll(value, 1, axis=0) for name, value in made.items()}
    return made | before


@pytest.mark.parametrize("runs, lanes", [((), None), ((5,), 4), ((2, 3), 2), ((1,), 1)])
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
    for lanes in (3, 8.0, True):
        with pytest.raises(BoresightError, match=f"no {lanes} lanes; there are 1, 2, 4, 8"):
            load("azimuth-hold", lanes=lanes)


def test_what_is_assigned_to_an_epoch_is_written_where_the_c_reads_it():
    loop = begun((2,))
    epoch = Epoch(loop, 0, ["zupt"], predict=False, feedback=False, runs=(2,), shared=["R"])
    zupt = epoch.measured["zupt"]
    zupt["R"], places = 1e-4, {name: getattr(zupt, name).ctypes.data for name in ("rows", "gates", "nu", "used")}
    zupt.rows, zupt.nu, zupt.iterations = [[1, 0, 1], [0, 0, 0]], np.zeros((2, 3)), 1
    assert epoch() == 0 and zupt.used.tolist() == [[1, 0, 1], [0, 0, 0]] and zupt.nu[0, 0] != 0
    zupt.rows, zupt.gates = True, np.array([1e-9, 0.0])
    assert epoch() == 0 and not zupt.used.any()
    epoch.status = np.full(2, 9)
    assert epoch() == 0 and not epoch.status.any()
    assert places == {name: getattr(zupt, name).ctypes.data for name in places}
    with pytest.raises(BoresightError, match=r"rows has shape \(4,\); it must fit into \(2, 3\)"):
        zupt.rows = np.ones(4)
    with pytest.raises(BoresightError, match=r"R has shape \(4,\); it must fit into \(3,\)"):
        zupt["R"] = np.ones(4)
    with pytest.raises(BoresightError, match="predict stays what it is"):
        epoch.predict = {"dt": 0.1}
    with pytest.raises(BoresightError, match="no input 'RR' here"):
        zupt["RR"] = 1.0


@pytest.mark.parametrize("name", ["lon_lat_height", "v_n", "q_b2n_wxyz", "gyro_bias"])
def test_an_epoch_flies_no_field_that_nobody_gave(name):
    whole = begun(())
    nav = {n: value for n, value in whole.nav.items() if n != name}
    loop = CompiledFilter(whole.model, nav, np.diag(SIGMA**2))
    epoch = Epoch(loop, 1, predict=False, feedback=False)
    epoch.strapdown["dt"] = 0.01
    with pytest.raises(BoresightError, match=f"needs {name}; give it in nav"):
        epoch()
    loop.nav[name] = whole.nav[name]
    assert epoch() == 0


def test_the_runs_of_an_epoch_are_those_of_all_that_the_filter_has():
    loop = CompiledFilter(load("azimuth-hold"), dict(begun((4,)).nav), np.diag(SIGMA**2))
    assert Epoch(loop, 1).runs == (4,)
    with pytest.raises(BoresightError, match=r"runs \(4,\), and the Epoch \(2,\)"):
        Epoch(loop, 0, predict=False, runs=(2,))()
    for runs in ((0,), 4, (2.0,)):
        with pytest.raises(BoresightError, match="give the leading axes"):
            Epoch(loop, 1, runs=runs)
    for samples in (2.0, "3", True):
        with pytest.raises(BoresightError, match="and whole"):
            Epoch(loop, samples)
    assert Epoch(loop, np.int64(2), runs=(np.int64(4),)).runs == (4,)
    for names in ("zupt", ["zupt", "zupt"]):
        with pytest.raises(BoresightError, match="give a list of names, each once"):
            Epoch(loop, 0, names)
    loop.nav["gyro_bias"], loop.nav["v_n"] = np.zeros((4, 3)), np.zeros((3, 3))
    with pytest.raises(BoresightError, match="do not go together"):
        Epoch(loop, 1)


def test_what_is_assigned_to_a_filter_has_the_shape_that_it_began_with():
    loop = begun(())
    loop.predict(dt=0.1, f_b=F_B, **{name: np.full(3, value) for name, value in NOISE.items()})
    before = loop.P.copy(), loop.x.copy(), loop.nav["v_n"].copy()
    askew = loop.P.copy()
    askew[9, 0] += 1e-6 * np.sqrt(askew[9, 9] * askew[0, 0])
    for value, match in ((np.eye(16), r"P has shape \(16, 16\); it must be \(..., 15, 15\)"),
                         (np.ones(15), r"P has shape \(15,\)"), (askew, "P is not symmetric, by 1.0e-06")):  # fmt: skip
        with pytest.raises(BoresightError, match=match):
            loop.P = value
    for wrong in (0.0, np.full(1, 1e-3), np.zeros(16)):
        with pytest.raises(BoresightError, match="x has shape"):
            loop.x = wrong
    for wrong in (7.0, np.zeros((4, 1)), np.array([7.0])):
        with pytest.raises(BoresightError, match=r"v_n has shape .*; its last axis must be 3 long"):
            loop.nav["v_n"] = wrong
    with pytest.raises(BoresightError, match="no input 'foo'"):
        loop.nav["foo"] = 1.0
    assert all(np.array_equal(a, b) for a, b in zip(before, (loop.P, loop.x, loop.nav["v_n"]), strict=True))
