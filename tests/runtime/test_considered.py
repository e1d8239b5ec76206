"""Considered states, which no measurement corrects, and unused ones, which nothing moves: held against matrices."""

import ctypes
import re
from pathlib import Path

import numpy as np
import pytest
from mpmath import mp

from boresight import BoresightError
from boresight.runtime import compiler
from boresight.runtime.filter import CompiledFilter, Filter
from boresight.runtime.library import load


class Row(ctypes.Structure):
    """bs_row."""

    _fields_ = [
        ("h", ctypes.c_void_p), ("at", ctypes.c_void_p), ("count", ctypes.c_int), ("z", ctypes.c_double),
        ("R", ctypes.c_double), ("gate", ctypes.c_double), ("nu", ctypes.c_double), ("S", ctypes.c_double),
        ("used", ctypes.c_int), ("gain", ctypes.c_void_p),
    ]  # fmt: skip


class Factored(CompiledFilter):
    """The C filter with UD factors, in double, so that they can be held as closely."""

    library = None

    def __init__(self, model, *arguments, **named):
        super().__init__(self.library, *arguments, **named)

    def _fly(self, *arguments):
        P, self.P = self.P, np.array([factors(P) for P in self.P.reshape(-1, 5, 5)]).reshape(self.P.shape)
        try:
            said = super()._fly(*arguments)
        except BoresightError:
            self.P = P
            raise
        U = np.triu(self.P, 1) + np.eye(5)
        self.P = U * np.diagonal(self.P, axis1=-2, axis2=-1)[..., None, :] @ np.swapaxes(U, -1, -2)
        return said


def factors(P):
    """U and, in the place of its diagonal, D."""
    P, U = P.copy(), np.eye(5)
    for j in range(4, -1, -1):
        if P[j, j] > 0:
            U[:j, j] = P[:j, j] / P[j, j]
            P[:j, :j] -= P[j, j] * np.outer(U[:j, j], U[:j, j])
    return U + U.T - 2 * np.eye(5) + np.diag(np.diag(P))


KINDS = pytest.mark.parametrize("kind", [Filter, CompiledFilter, Factored], ids=["python", "joseph", "ud"])
WORDS = " ".join((Path(__file__).parent.parent.parent / "docs" / "covariance.md").read_text().split())
AT = np.array([300.0, -400.0, 3.0, -2.0, 0.2])
SIGMA = np.array([4.0, 3.0, 1.0, 2.0, 0.01])
ROOT = np.random.default_rng(12).standard_normal((3, 5, 7)) * SIGMA[:, None]
P0 = ROOT @ np.swapaxes(ROOT, -1, -2)  # of three runs
KEPT = np.array([[False, False, False, False, True], [True, False, False, True, True], [False] * 5])
NOISE = np.array([1.0, 1e-5])
SMEARED = np.array([[1.0, 0.8 * np.sqrt(1e-5)], [0.8 * np.sqrt(1e-5), 1e-5]])


@pytest.fixture(scope="module")
def radar(radar_folder):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiler, "FLAGS", (*compiler.FLAGS, "-DBORESIGHT_UD=1"))
        Factored.library = load(radar_folder)
        for runs in (1, 2, 4, 8):  # compiled when they are needed, and needed with these flags
            Factored.library.lanes(runs)
    return load(radar_folder)


def begun(kind, model, P=P0, x=AT):
    return kind(model, {}, P, x=np.broadcast_to(x, (*P.shape[:-2], 5)))


def seen(x):
    """Range and bearing, by hand."""
    return np.array([np.hypot(x[0], x[1]), np.arctan2(x[0], x[1]) - x[4]])


def schmidt(P, H, R, nu, kept):
    """The correction and the covariance of the textbook, of the whole measurement at once."""
    S = H @ P @ H.T + R
    K = np.where(kept[:, None], 0.0, P @ H.T @ np.linalg.inv(S))
    A = np.eye(5) - K @ H
    return K @ nu, A @ P @ A.T + K @ R @ K.T, nu @ np.linalg.solve(S, nu)


def near(P, witness):
    sigma = np.sqrt(np.diagonal(witness, axis1=-2, axis2=-1))
    unit = sigma[..., None] * sigma[..., None, :]
    np.testing.assert_allclose(P / unit, witness / unit, atol=1e-12)


@KINDS
@pytest.mark.parametrize("by_call", [True, False])
@pytest.mark.parametrize("smeared", [False, True])
def test_a_measurement_is_that_of_its_gain_with_the_rows_of_considered_states_zeroed(kind, by_call, smeared, radar):
    z, full = seen(AT) + np.array([2.0, -0.01]), SMEARED if smeared else np.diag(NOISE)
    loop = begun(kind, radar)
    loop.considered = None if by_call else KEPT
    given = {"considered": KEPT} if by_call else {}
    said = loop.update("smeared" if smeared else "radar", full if smeared else NOISE, z=z, **given)
    H = radar.radar_H(x=AT)
    for run in range(3):
        by, P, nis = schmidt(P0[run], H, full, z - seen(AT), KEPT[run])
        np.testing.assert_allclose(loop.x[run] - AT, by, atol=1e-12 * SIGMA.max())
        near(loop.P[run], P)
        assert said.nis[run] == pytest.approx(nis, rel=1e-9)
        assert np.array_equal(loop.x[run][KEPT[run]], AT[KEPT[run]])


@KINDS
def test_what_the_call_considers_stands_instead_of_what_the_filter_does(kind, radar):
    nothing = np.zeros(5, dtype=bool)
    plain, told = begun(kind, radar), begun(kind, radar)
    told.considered = KEPT
    for loop, given in ((plain, {}), (told, {"considered": nothing})):
        loop.update("radar", NOISE, z=seen(AT) + 0.01, iterations=3, **given)
    assert np.array_equal(plain.P, told.P) and np.array_equal(plain.x, told.x)


@KINDS
def test_masked_and_gated_rows_leave_considered_states_as_they_leave_the_others(kind, radar):
    z, rows = seen(AT) + np.array([500.0, 0.01]), np.array([False, True])
    gated, masked = begun(kind, radar), begun(kind, radar)
    said = gated.update("radar", NOISE, z=z, gate=5.0, considered=KEPT)
    masked.update("radar", NOISE, z=z, rows=rows, considered=KEPT)
    assert said.used.tolist() == [[False, True]] * 3
    assert np.array_equal(gated.P, masked.P) and np.array_equal(gated.x, masked.x)


@KINDS
def test_iterations_linearise_about_what_is_corrected_and_keep_what_is_not(kind, radar):
    x, R, z = np.array([6.0, -3.0, 0.0, 0.0, 0.1]), np.diag([1e-2, 1e-3]), np.array([6.5, 0.35 + np.arctan2(4.0, -3.0)])
    P, kept = np.diag([4.0, 4.0, 1.0, 1.0, 1e-2]) + 0.05, np.array([False, False, False, False, True])
    at = x
    for _ in range(4):
        H = radar.radar_H(x=at)
        by, spread, _ = schmidt(P, H, R, z - seen(at) - H @ (x - at), kept)
        at = x + by
    loop = begun(kind, radar, P, x)
    loop.update("radar", np.diag(R), z=z, iterations=4, considered=kept)
    np.testing.assert_allclose(loop.x, at, rtol=1e-10)
    near(loop.P, spread)
    assert loop.x[4] == x[4]


@KINDS
def test_a_considered_bias_stays_honest_where_an_estimated_one_would_be_learned(kind, radar):
    """The bearing's bias is the heading: a thousand bearings later the place is no better than the heading says."""
    P = np.diag([100.0, 100.0, 0.0, 0.0, 1e-4])
    loop = begun(kind, radar, P)
    loop.considered = np.arange(5) == 4
    for _ in range(1000):
        loop.update("radar", NOISE, z=seen(AT))
    across = np.array([AT[1], -AT[0], 0, 0, 0]) / np.hypot(*AT[:2])
    assert loop.P[4, 4] == pytest.approx(1e-4, rel=1e-14)
    assert 4.0 < np.sqrt(across @ loop.P @ across) <= 5.1  # 500 m away, .01 rad


@KINDS
def test_a_state_of_no_variance_and_no_noise_stays_as_it_is(kind, radar):
    """So a state that is not needed is left out: it is known to be what it is."""
    P = P0.copy()
    P[:, 2:, :] = P[:, :, 2:] = 0.0
    loop = begun(kind, radar, P, [300.0, -400.0, 0.0, 0.0, 0.2])
    for k in range(50):
        loop.predict(dt=0.5, gusts=np.zeros(2))
        loop.update("radar", NOISE, z=seen(AT), iterations=1 + k % 3, gate=None if k % 2 else 5.0)
        loop.update("smeared", SMEARED, z=seen(AT))
        loop.update("compass", 1e-4, z=0.1)
    assert not loop.P[:, 2:, :].any() and not loop.P[:, :, 2:].any()
    assert np.array_equal(loop.x[:, 2:], np.tile([0.0, 0.0, 0.2], (3, 1)))
    assert np.isfinite(loop.P).all() and (np.diagonal(loop.P, axis1=-2, axis2=-1)[:, :2] > 0).all()


@KINDS
@pytest.mark.parametrize(
    "given, said",
    [
        ([True, False], r"considered has shape \(2,\); it must be \(\.\.\., 5\), True or False for each state"),
        ([3, 4, 0, 0, 0], r"considered is \[3, 4, 0, 0, 0\]; it must be \(\.\.\., 5\), True or False"),
        ("heading", "considered is 'heading'; it must be"),
    ],
)
def test_what_is_no_choice_of_states_is_one_line_and_changes_nothing(kind, given, said, radar):
    loop = begun(kind, radar)
    with pytest.raises(BoresightError, match=said):
        loop.update("radar", NOISE, z=seen(AT), considered=given)
    assert np.array_equal(loop.P, P0)


@pytest.mark.digits
def test_the_docs_say_how_near_to_60_digits_the_gain_that_is_left_out_comes_back(radar):
    """One row on a hundred random P over nine powers of ten, in parts of the sigmas."""
    rng, worst = np.random.default_rng(0), {"joseph": 0.0, "ud": 0.0}
    at, work = np.arange(5, dtype=np.uint16), np.zeros(200)

    def call(function, *arguments):
        pointers = [ctypes.c_void_p(a.ctypes.data) if isinstance(a, np.ndarray) else a for a in arguments]
        return getattr(radar.dll, f"rd_{function}")(*pointers)

    # whole numbers, fractions and decimals: the bits of powers, and of sums, hang on the processor
    tens = np.array([float(f"1e{k}") for k in range(-8, 1)])
    for _ in range(100):
        root, sigma = rng.integers(-128, 129, (5, 5)) / 64, rng.integers(100, 1000, 5) * rng.choice(tens, 5)
        P, kept = root @ root.T * np.outer(sigma, sigma), rng.integers(10, size=5) < 4
        h, R = rng.integers(-128, 129, 5) / 64 / sigma, float(rng.integers(100, 1000) * rng.choice(tens[2:8]))
        with mp.workdps(60):
            exact_P, exact_h = mp.matrix(P.tolist()), mp.matrix(h.tolist())
            g = exact_P * exact_h
            S = (exact_h.T * g)[0] + R
            K = mp.matrix([0 if keep else of / S for keep, of in zip(kept, g, strict=True)])
            A = mp.eye(5) - K * exact_h.T
            exact = A * exact_P * A.T + K * R * K.T
        sigma = np.sqrt(np.diag(P))
        for form in worst:
            packed, dense, x, gain = np.zeros(15), np.zeros((5, 5)), np.zeros(5), np.zeros(5)
            row = Row(h.ctypes.data, at.ctypes.data, 5, 0.0, R, 0.0, 0.0, 0.0, 1, gain.ctypes.data)
            assert call(f"{form}_init", P, packed, work) == 0
            assert call(f"{form}_update", packed, x, ctypes.byref(row)) == 0
            call(f"{form}_add", packed, ctypes.c_double(row.S), np.where(kept, gain, 0.0))
            call(f"{form}_dense", packed, dense)
            with mp.workdps(60):
                off = np.array((mp.matrix(dense.tolist()) - exact).tolist(), dtype=float)
            worst[form] = max(worst[form], np.abs(off / np.outer(sigma, sigma)).max())
    said = re.search(r"off by at most (\S+)e-16 of the sigmas in Joseph form and (\S+)e-16 in factors", WORDS)
    assert [f"{worst[form] * 1e16:.0f}" for form in worst] == list(said.groups())
