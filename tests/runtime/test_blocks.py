"""Blocks of P changed in flight, and states left out: Filter, CompiledFilter and each form of C, against matrices."""

import functools

import numpy as np
import pytest
from c_filter import FORMS, Flown
from conftest import ROOT

from boresight import BoresightError
from boresight.runtime.filter import CompiledFilter, Epoch, Filter
from boresight.runtime.library import load

KINDS = pytest.mark.parametrize("kind", ["python", "compiled", *FORMS])
MODELS = pytest.mark.parametrize("model", ["radar", "azimuth-hold", "euler-matching"])
NAVS = {
    "radar": {},
    "azimuth-hold": {"lon_lat_height": [0.1, 0.6, 100.0], "v_n": [0.1, 0.2, 0.3], "q_b2n_wxyz": [1.0, 0, 0, 0],
                     "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3)},
    "euler-matching": {"q_b2n_wxyz": [1.0, 0, 0, 0], "mu": np.zeros(3)},
}  # fmt: skip
SIGMAS = {
    "radar": [4.0, 3.0, 1.0, 2.0, 0.01],
    "azimuth-hold": np.repeat([1e-6, 0.1, 1e-2, 1e-6, 1e-2], 3) * [1, 1, 1e6, *np.ones(12)],
    "euler-matching": [1e-2] * 3 + [1e-3] * 3,
}
STEPS = {
    "radar": {"dt": 0.5, "gusts": [0.1, 1e-3]},
    "azimuth-hold": {"f_b": [0.1, 0.2, 9.8], "omega_ib_b": np.zeros(3), "dt": 0.1, "gyro_noise": np.full(3, 1e-5),
                     "accel_noise": np.full(3, 1e-3), "gyro_bias_noise": np.full(3, 1e-8),
                     "accel_bias_noise": np.full(3, 1e-5)},
    "euler-matching": {"omega_in_n": [1e-5, 0.0, 7e-5], "gyro_noise": np.full(3, 1e-3), "dt": 1.0},
}  # fmt: skip
TAKEN = {
    "radar": ("compass", 1e-4, {"z": 0.11}),
    "azimuth-hold": ("zupt", np.full(3, 1e-4), {}),
    "euler-matching": ("euler", np.full(3, 1e-6), {"euler_b": [0.002, 0.0, 0.001], "euler_m": np.zeros(3)}),
}
AT = np.array([300.0, -400.0, 3.0, -2.0, 0.1])


@pytest.fixture(scope="module")
def begun(radar_folder):
    """A filter of a kind and a model, with a P whose states all depend on each other, and what P is by then."""

    @functools.cache
    def library(model):
        return load(folder(model))

    def folder(model):
        return radar_folder if model == "radar" else ROOT / "generated" / model.replace("-", "_")

    def begin(kind, model, P=None):
        x = AT if model == "radar" else None
        if P is None:
            sigma = np.array(SIGMAS[model])
            root = np.random.default_rng(5).standard_normal((len(sigma), len(sigma) + 3)) * sigma[:, None]
            P = root @ root.T / len(sigma)
        if kind in FORMS:
            return Flown(folder(model), kind, NAVS[model], P, x)
        return {"python": Filter, "compiled": CompiledFilter}[kind](library(model), NAVS[model], P, x)

    return begin


def near(P, witness, kind, parts=1e-12):
    """To rounding, in parts of the sigmas; a variance of zero is zero."""
    sigma = np.sqrt(np.diagonal(witness))
    unit = np.outer(sigma, sigma)
    assert (np.abs(P - witness) <= (2e-5 if kind == "float" else parts) * unit).all()


def ranges(n):
    return [(0, 1), (n - 1, 1), (1, 2), (n - 3, 3), (0, n)]


def dropped(P, states):
    P = P.copy()
    P[states, :] = P[:, states] = 0.0
    return P


def block_of(P, states, seed=1):
    """A covariance, of about the size that these states have."""
    sigma, rng = np.sqrt(np.diagonal(P)[states]), np.random.default_rng(seed)
    root = rng.standard_normal((len(sigma), len(sigma) + 1)) * sigma[:, None]
    return root @ root.T


@KINDS
@MODELS
def test_set_block_leaves_the_marginal_of_the_others_beside_the_block(kind, model, begun):
    for first, count in ranges(len(SIGMAS[model])):
        loop, states = begun(kind, model), slice(first, first + count)
        before, x = loop.P, loop.x.copy()
        block = block_of(before, states)
        loop.set_block(first, block)
        witness = dropped(before, states)
        witness[states, states] = block
        near(loop.P, witness, kind)
        assert np.array_equal(loop.x, x)


@KINDS
@MODELS
def test_inflate_adds_to_the_variances_alone(kind, model, begun):
    for first, count in ranges(len(SIGMAS[model])):
        loop, states = begun(kind, model), slice(first, first + count)
        before = loop.P
        added = np.diagonal(before)[states] * np.array([4.0, 0.0, 0.3] * 5)[:count]
        loop.inflate(first, added)
        near(loop.P, before + np.diag(np.pad(added, (first, len(before) - first - count))), kind)


@KINDS
@MODELS
def test_a_disabled_state_is_absent_until_it_is_enabled(kind, model, begun):
    """The others fly as in a model without it, whose matrices lack its rows and columns."""
    n, (name, R, given) = len(SIGMAS[model]), TAKEN[model]
    reference = begun("python", model)
    out = np.array([1, 4]) if model == "radar" else np.array([1, 2])
    stay = np.setdiff1d(np.arange(n), out)
    loop = begun(kind, model)
    for state in out:
        loop.disable(int(state))
    assert np.flatnonzero(loop.disabled).tolist() == out.tolist()
    P, measured = loop.P[np.ix_(stay, stay)], f"{name}_H"
    for _ in range(3):
        reference.x = np.array(loop.x, dtype=float)  # where its matrices are taken
        Phi, Q = (reference.call(what, **STEPS[model])[np.ix_(stay, stay)] for what in ("Phi", "Q"))
        loop.predict(**STEPS[model])
        P = Phi @ P @ Phi.T + Q
        x = loop.x.copy()
        H = reference.call(measured, **{k: v for k, v in given.items() if k != "z"})[:, stay]
        said = loop.update(name, R, **given)
        S = H @ P @ H.T + np.diag(np.atleast_1d(R))
        P = P - P @ H.T @ np.linalg.solve(S, H @ P)
        assert said.S[0] == pytest.approx(S[0, 0], rel=1e-5)
        assert np.array_equal(loop.x[out], x[out])
    now = loop.P
    assert not now[out].any() and not now[:, out].any()
    near(now[np.ix_(stay, stay)], P, kind)
    loop.enable(int(out[0]), np.array([[0.25 * SIGMAS[model][out[0]] ** 2]]))
    assert np.flatnonzero(loop.disabled).tolist() == out[1:].tolist()
    witness = now.copy()
    witness[out[0], out[0]] = 0.25 * SIGMAS[model][out[0]] ** 2
    near(loop.P, witness, kind)
    loop.predict(**STEPS[model])
    assert loop.P[out[0], out[0]] > 0 and not loop.P[out[1]].any()


@KINDS
def test_disabled_states_and_considered_ones_go_together(kind, begun):
    """A bias of the heading is considered, a velocity disabled: P is that of the textbook without the velocity."""
    loop = begun(kind, "radar")
    loop.disable(2)
    kept = np.arange(5) == 4
    if kind in FORMS:
        loop.consider(kept)
    else:
        loop.considered = kept
    before, z = loop.P, np.array([np.hypot(*AT[:2]) + 1.0, np.arctan2(*AT[:2]) - AT[4]])
    H = begun("python", "radar").call("radar_H")
    loop.update("radar", np.array([1.0, 1e-5]), z=z)
    R = np.diag([1.0, 1e-5])
    K = np.where(kept[:, None], 0.0, before @ H.T @ np.linalg.inv(H @ before @ H.T + R))
    A = np.eye(5) - K @ H
    near(loop.P, A @ before @ A.T + K @ R @ K.T, kind)
    assert not loop.P[2].any() and loop.x[2] == np.float32(AT[2]) and np.flatnonzero(loop.disabled).tolist() == [2]


@pytest.mark.parametrize("form", ["ud", "float"])
def test_factors_keep_what_no_dense_matrix_of_their_precision_could(form, begun):
    """Of two states known to 1e3 each, and their difference to a thousandth: dense in float it would be lost."""
    loop = begun(form, "radar", np.eye(5))
    U, D = np.eye(5), np.array([1e-6, 1e6, 1.0, 1.0, 1e-4])
    U[0, 1], U[:4, 4], U[0, 3], U[1, 3] = 1.0, (3e3, 3e3, 5.0, 1.0), 7.0, 7.0
    columns, rows = np.tril_indices(5)
    loop.packed[:] = np.where(rows == columns, D[columns], U[rows, columns])
    loop.set_block(4, np.array([[1e-2]]))
    loop.disable(3)
    loop.inflate(2, np.array([2.0]))
    numbers = loop.packed.astype(float)
    U, D = np.eye(5), numbers[rows == columns]
    U[rows, columns] = np.where(rows == columns, 1.0, numbers)
    across = U.T @ [1.0, -1.0, 0.0, 0.0, 0.0]
    assert D @ across**2 == pytest.approx(1e-6, rel=1e-3)
    along = U.T @ [1.0, 0.0, 0.0, 0.0, 0.0]
    assert D @ along**2 == pytest.approx(1e6 + 49.0 + 9e6 * 1e-4, rel=1e-5)
    assert D[3] == 0 and D @ U[2] ** 2 == pytest.approx(1.0 + 25e-4 + 2.0, rel=1e-5)


BAD = {
    "no such state": (-1, [[1.0]]),
    "beyond the last": (4, np.eye(2)),
    "far beyond": (5, [[1.0]]),
    "no number": (1, [[np.nan]]),
    "infinite": (1, [[np.inf]]),
    "negative": (1, [[-1e-9]]),
    "not symmetric": (0, [[1.0, 0.5], [0.4, 1.0]]),
    "no covariance": (0, [[1.0, 2.0], [2.0, 1.0]]),
    "above its ceiling": (4, [[1e30]]),
    "disabled": (3, [[1.0]]),
}


@KINDS
@pytest.mark.parametrize("what", BAD)
def test_what_is_no_block_of_these_states_is_refused_and_changes_nothing(kind, what, begun):
    first, block = BAD[what]
    loop = begun(kind, "radar")
    loop.disable(3)
    P, x = loop.P.copy(), loop.x.copy()
    with pytest.raises(BoresightError, match="set_block"):
        loop.set_block(first, np.array(block))
    if what != "disabled":
        with pytest.raises(BoresightError, match="enable"):
            loop.enable(first, np.array(block))
    if what not in ("not symmetric", "no covariance", "above its ceiling"):
        with pytest.raises(BoresightError, match="inflate"):
            loop.inflate(first, np.diagonal(block).copy())
    if what in ("no such state", "beyond the last", "far beyond"):
        with pytest.raises(BoresightError, match="disable"):
            loop.disable(first, len(block))
    assert np.array_equal(loop.P, P) and np.array_equal(loop.x, x) and np.flatnonzero(loop.disabled).tolist() == [3]


@KINDS
def test_more_variance_than_a_state_may_have_is_lowered_as_by_a_step(kind, begun):
    loop, ceiling = begun(kind, "radar"), begun("python", "radar").model.ceiling
    witness = loop.P.copy()
    loop.inflate(1, np.array([2.5 * ceiling[1]]))
    witness[1, 1] += 2.5 * ceiling[1]
    half = np.where(np.arange(5) == 1, 0.5, 1.0)
    near(
        loop.P, witness * np.outer(half, half), kind, 1e-9
    )  # in factors its rise by 1e14 costs digits of a correlation
    if kind not in FORMS:
        assert np.all(loop.at_ceiling)


def test_runs_side_by_side_may_have_blocks_of_their_own(begun):
    P = np.array([np.diag(np.square(SIGMAS["radar"])) * k for k in (1.0, 2.0, 3.0)])
    blocks, added = np.array([[[5.0]], [[6.0]], [[7.0]]]), np.array([[0.1], [0.2], [0.3]])
    python, compiled = begun("python", "radar", P[0]), begun("compiled", "radar", P[0])
    for loop in (python, compiled):
        loop.P = P
        loop.set_block(1, blocks)
        loop.inflate(2, added)
        loop.disable(0)
        loop.predict(**STEPS["radar"])
        assert loop.P.shape == (3, 5, 5) and not loop.P[:, 0].any()
    np.testing.assert_allclose(python.P, compiled.P, rtol=1e-13)
    assert np.diagonal(python.P, axis1=-2, axis2=-1)[:, 1].argsort().tolist() == [0, 1, 2]


def test_an_epoch_refuses_a_filter_with_states_that_take_no_part(begun):
    loop = begun("compiled", "radar")
    epoch = Epoch(loop, 0, feedback=False)
    loop.disable(1)
    with pytest.raises(BoresightError, match="an Epoch corrects every state; fly a filter with disabled states"):
        epoch()
    with pytest.raises(BoresightError, match="disabled states"):
        Epoch(loop, 0, feedback=False)
