"""How a measurement is taken: with a larger R beyond its gate, its rows linearised one after another, or not at all.
Filter, CompiledFilter and each form of C, against matrices."""

import numpy as np
import pytest
from c_filter import FORMS, Flown

from boresight import BoresightError
from boresight.runtime.filter import CompiledFilter, Filter
from boresight.runtime.library import load

KINDS = pytest.mark.parametrize("kind", ["python", "compiled", *FORMS])
AT = np.array([300.0, -400.0, 3.0, -2.0, 0.2])
SIGMA = np.array([4.0, 3.0, 1.0, 2.0, 0.01])
ROOT = np.random.default_rng(12).standard_normal((5, 7)) * SIGMA[:, None]
P0 = ROOT @ ROOT.T
NOISE = np.array([1.0, 1e-4])
SMEARED = np.array([[1.0, 5e-3], [5e-3, 1e-4]])


@pytest.fixture(scope="module")
def begun(radar_folder):
    library = load(radar_folder)

    def begin(kind, P=P0, x=AT):
        if kind in FORMS:
            return Flown(radar_folder, kind, {}, P, x)
        return {"python": Filter, "compiled": CompiledFilter}[kind](library, {}, P, x)

    return begin


def seen(x):
    """Range and bearing, by hand."""
    return np.array([np.hypot(x[0], x[1]), np.arctan2(x[0], x[1]) - x[4]])


def slope(x):
    """Their derivatives, by hand."""
    r2 = x[0] ** 2 + x[1] ** 2
    return np.array([[x[0] / r2**0.5, x[1] / r2**0.5, 0, 0, 0], [x[1] / r2, -x[0] / r2, 0, 0, -1.0]])


def plain(x, P, H, nu, R):
    """One row, or several, of the textbook."""
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ nu, P - K @ H @ P


def near(loop, x, P, kind):
    parts, sigma = (2e-4 if kind == "float" else 1e-9), np.sqrt(np.diagonal(P))
    assert (np.abs(loop.x - x) <= parts * sigma + 1e-7 * np.abs(x) * (kind == "float")).all()
    assert (np.abs(loop.P - P) <= parts * np.outer(sigma, sigma)).all()


def same_innovation(said, wanted, kind):
    """wanted: (m, 2) nu and S."""
    parts, S = (2e-4 if kind == "float" else 1e-9), wanted[:, 1]
    assert (np.abs(said.S / S - 1) <= parts).all() and (np.abs(said.nu - wanted[:, 0]) <= parts * np.sqrt(S)).all()


@KINDS
@pytest.mark.parametrize("off", [(500.0, 0.001), (0.1, -0.5), (500.0, 0.5), (0.1, 0.001)])
def test_a_row_beyond_its_gate_is_taken_with_the_r_that_brings_it_there(kind, off, begun):
    gate, x, P, wanted = 3.0, AT, P0, []
    nus = []
    for i, row in enumerate(slope(AT)):
        h, R = row[None], NOISE[i]
        nu = seen(AT)[i] + off[i] - seen(AT)[i] - row @ (x - AT)
        before = h @ P @ h.T + R
        S = max(float(before.item()), (nu / gate) ** 2)
        wanted.append(before.item() < S)
        nus.append((nu, S))
        x, P = plain(x, P, h, np.array([nu]), np.array([[R + S - before.item()]]))
    loop = begun(kind)
    said = loop.update("radar", NOISE, z=seen(AT) + off, gate=gate, inflate=True)
    near(loop, x, P, kind)
    assert said.used.all() and said.inflated.tolist() == wanted and any(wanted) == (off != (0.1, 0.001))
    same_innovation(said, np.array(nus), kind)
    for i in np.flatnonzero(wanted):
        assert abs(said.nu[i]) == pytest.approx(gate * np.sqrt(said.S[i]), rel=1e-5)


@KINDS
def test_of_correlated_rows_each_is_judged_by_itself(kind, begun):
    off, gate, H = np.array([500.0, 0.001]), 3.0, slope(AT)
    own = H @ P0 @ H.T + SMEARED
    R = SMEARED + np.diag([(500.0 / gate) ** 2 - own[0, 0], 0.0])
    x, P = plain(AT, P0, H, off, R)
    loop = begun(kind)
    said = loop.update(
        "smeared", SMEARED.ravel() if kind in FORMS else SMEARED, z=seen(AT) + off, gate=gate, inflate=True
    )
    near(loop, x, P, kind)
    assert said.used.all() and said.inflated.tolist() == [True, False]


@KINDS
def test_a_row_that_is_masked_stays_out_and_the_joint_gate_leaves_all_out(kind, begun):
    z, rows = seen(AT) + np.array([500.0, 0.5]), np.array([False, True])
    loop = begun(kind)
    said = loop.update("radar", NOISE, z=z, gate=3.0, inflate=True, rows=rows)
    assert said.used.tolist() == said.inflated.tolist() == [False, True]
    loop = begun(kind)
    P = loop.P
    said = loop.update("radar", NOISE, z=z, gate=3.0, inflate=True, joint=17.9)
    assert not said.used.any() and not said.inflated.any() and np.array_equal(loop.P, P)
    assert said.nis == pytest.approx(18.0, rel=1e-5)  # two rows at three sigmas


@KINDS
def test_a_larger_r_stays_while_a_measurement_is_linearised_again(kind, begun):
    """A narrow gate on a near target: R of the first linearisation, in all that follow."""
    x0, P1, gate = np.array([30.0, -40.0, 0.0, 0.0, 0.1]), np.diag([25.0, 25.0, 1.0, 1.0, 1e-4]), 0.5
    z = seen(x0) + np.array([6.0, 0.2])
    x, P, R = x0, P1, NOISE.copy()
    for i, h in enumerate(slope(x0)):
        nu = z[i] - seen(x0)[i] - h @ (x - x0)
        R[i] += max(0.0, (nu / gate) ** 2 - (h @ P @ h + R[i]))
        x, P = plain(x, P, h[None], np.array([nu]), np.array([[R[i]]]))
    assert (R > NOISE).all()
    for _ in range(9):
        at = x
        x, P = plain(x0, P1, slope(at), z - seen(at) - slope(at) @ (x0 - at), np.diag(R))
    loop = begun(kind, P1, x0)
    said = loop.update("radar", NOISE, z=z, gate=gate, inflate=True, iterations=10)
    assert said.inflated.all()
    np.testing.assert_allclose(loop.x, x, atol=0.01 * np.sqrt(np.diagonal(P)).max())
    sigma = np.sqrt(np.diagonal(P))
    np.testing.assert_allclose(loop.P / np.outer(sigma, sigma), P / np.outer(sigma, sigma), atol=0.01)


NEAR = np.array([6.0, -3.0, 0.0, 0.0, 0.1])
WIDE = np.diag([4.0, 4.0, 1.0, 1.0, 1e-2]) + 0.05
CLOSE = np.array([1e-2, 1e-3])


@KINDS
@pytest.mark.parametrize("kept", [False, True])
def test_rows_are_linearised_where_those_before_them_have_led_x(kind, kept, begun):
    z = np.array([5.0, 0.35 + np.arctan2(4.0, -3.0)])
    x, P, nus = NEAR, WIDE, []
    for i in range(2):
        h = slope(x)[i][None]
        nu = z[i : i + 1] - seen(x)[i]
        nus.append((nu.item(), (h @ P @ h.T + CLOSE[i]).item()))
        x, P = plain(x, P, h, nu, np.array([[CLOSE[i]]]))
    loop = begun(kind, WIDE, NEAR)
    if kept:  # the heading: its rows of the gain are zero, and P among itself stays
        considered = np.arange(5) == 4
        x = np.where(considered, NEAR, x)
        P[4, 4] = WIDE[4, 4]
        loop.consider(considered) if kind in FORMS else setattr(loop, "considered", considered)
    said = loop.update("radar", CLOSE, z=z, relinearize=True)
    near(loop, x, P, kind)
    same_innovation(said, np.array(nus), kind)
    once = begun(kind, WIDE, NEAR)
    once.update("radar", CLOSE, z=z)
    assert abs(once.x[4] - x[4]) > 0.005 or kept  # it makes a difference


@KINDS
def test_correlated_rows_are_freed_of_each_other_at_each_of_these_places(kind, begun):
    full = np.array([[1e-2, 2e-3], [2e-3, 1e-3]])
    z = np.array([5.0, 0.35 + np.arctan2(4.0, -3.0)])
    L = np.array([[1.0, 0.0], [0.2, 1.0]])
    D, x, P = np.array([1e-2, 1e-3 - 0.2 * 2e-3]), NEAR, WIDE
    for i in range(2):
        H, nu = np.linalg.solve(L, slope(x)), np.linalg.solve(L, z - seen(x))
        x, P = plain(x, P, H[i][None], nu[i : i + 1], D[i : i + 1, None])
    loop = begun(kind, WIDE, NEAR)
    loop.update("smeared", full.ravel() if kind in FORMS else full, z=z, relinearize=True)
    near(loop, x, P, kind)


@KINDS
def test_where_h_does_not_depend_on_x_nothing_changes(kind, begun):
    one, other = begun(kind), begun(kind)
    for loop, relinearize in ((one, False), (other, True)):
        loop.update("compass", 1e-4, z=0.25, relinearize=relinearize)
    assert np.array_equal(one.P, other.P) and np.array_equal(one.x, other.x)


@KINDS
def test_a_row_that_leads_x_out_of_its_box_refuses_the_whole_measurement(kind, begun):
    loop = begun(kind, np.diag([1e4, 1e4, 1.0, 1.0, 1e-2]), np.array([5.0, -20.0, 0.0, 0.0, 0.1]))
    P, x = loop.P.copy(), loop.x.copy()
    with pytest.raises(BoresightError):
        loop.update("radar", np.array([1e-2, 1e-3]), z=[-40.0, 0.1], relinearize=True)
    assert np.array_equal(loop.P, P) and np.array_equal(loop.x, x)


@KINDS
def test_no_rows_give_the_innovation_of_each_by_itself_and_take_nothing(kind, begun):
    off = np.array([500.0, 0.001])
    for name, R in (("radar", NOISE), ("smeared", SMEARED)):
        loop = begun(kind)
        P, x = loop.P.copy(), loop.x.copy()
        given = R.ravel() if kind in FORMS else R
        said = loop.update(name, given, z=seen(AT) + off, rows=False, gate=3.0, inflate=True)
        S = np.diagonal(slope(AT) @ P0 @ slope(AT).T) + (R if R.ndim == 1 else np.diagonal(R))
        np.testing.assert_allclose(said.nu, off, rtol=0.05 if kind == "float" else 1e-9)
        np.testing.assert_allclose(said.S, S, rtol=1e-4 if kind == "float" else 1e-12)
        assert not said.used.any() and not said.inflated.any() and said.nis == 0
        assert np.array_equal(loop.P, P) and np.array_equal(loop.x, x)


@pytest.mark.parametrize("kind", ["python", "compiled"])
def test_options_that_do_not_go_together_are_one_line(kind, begun):
    loop = begun(kind)
    with pytest.raises(BoresightError, match="radar: inflate raises R of a row beyond its gate; give a gate too"):
        loop.update("radar", NOISE, z=seen(AT), inflate=True)
    with pytest.raises(BoresightError, match="radar: relinearize takes each row once; leave iterations out"):
        loop.update("radar", NOISE, z=seen(AT), relinearize=True, iterations=2)


@pytest.mark.parametrize("form", FORMS)
def test_options_that_there_are_not_are_refused_in_c(form, begun):
    loop = begun(form)
    for bad in ({"inflate": 4}, {"relinearize": True, "iterations": 2}):
        state = loop.state.copy()
        with pytest.raises(BoresightError, match="OUT_OF_RANGE"):
            loop.update("radar", NOISE, z=seen(AT), **bad)
        assert np.array_equal(loop.state, state)


def test_runs_side_by_side_are_each_judged_alone(begun):
    """Some within the gate, some beyond it; by lanes, and in NumPy."""
    P, x = np.array([P0] * 5), np.array([AT] * 5)
    z = 0.2 + np.array([[0.0], [0.4], [0.001], [-0.6], [0.0]])
    python, compiled = begun("python", P, x), begun("compiled", P, x)
    said = [loop.update("compass", 1e-4, z=z, gate=3.0, inflate=True) for loop in (python, compiled)]
    np.testing.assert_allclose(python.x, compiled.x, rtol=1e-9)
    np.testing.assert_allclose(python.P, compiled.P, rtol=1e-9)
    for one in said:
        assert one.used.all() and one.inflated[:, 0].tolist() == [False, True, False, True, False]
