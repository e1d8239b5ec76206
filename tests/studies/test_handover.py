"""The hand-over carries what is known, and no more, from ten states to fifteen."""

import numpy as np
import pytest

from boresight import BoresightError
from boresight.runtime.filter import check_covariance
from boresight.runtime.library import load
from boresight.studies.azimuth_hold import handover

PLACE, MOVING = np.array([2.2, 0.63, 60.0]), np.array([3.0, -2.0, 0.5])


def covariance(size, seed):
    A = np.random.default_rng(seed).normal(size=(size, size))
    return A @ A.T + 0.1 * np.eye(size)


def parts(seed=0, size_position=1e-6):
    rng = np.random.default_rng(seed)
    T = load("psi-error").phi_from_psi(lon_lat_height=PLACE, v_n=MOVING)
    return (
        covariance(10, seed),
        rng.normal(size=(10, 12)),
        covariance(12, seed + 1),
        covariance(3, seed + 2) * size_position**2,
        T,
    )


def test_the_fifteen_states_have_the_covariance_of_errors_that_were_drawn():
    P, S, P_c, P_p, T = parts()
    rng, n = np.random.default_rng(1), 200_000
    r, c = (rng.multivariate_normal(np.zeros(len(M)), M, size=n) for M in (P, P_c))
    p = rng.multivariate_normal(np.zeros(3), P_p / 1e-12, size=n) * 1e-6
    psi_model = np.concatenate([p, (r + c @ S.T)[:, :6]], axis=-1)
    x = np.concatenate([psi_model @ T.T, c[:, :6]], axis=-1)
    got = handover.hand_over(P, S, P_c, P_p, T)
    scale = np.sqrt(np.diag(got))
    difference = (np.cov(x.T) - got) / np.outer(scale, scale)
    assert np.abs(difference).max() < 6 / np.sqrt(n)


def test_phi_is_psi_and_the_turn_of_the_level():
    # 100 m north turns the level by 100 m / R about west; nothing else is in error.
    P, S, P_c = np.zeros((10, 10)), np.zeros((10, 12)), np.zeros((12, 12))
    north = np.zeros((3, 3))
    north[1, 1] = 1.5e-5**2
    got = handover.hand_over(P, S, P_c, north, load("psi-error").phi_from_psi(lon_lat_height=PLACE, v_n=np.zeros(3)))
    assert np.sqrt(got[6, 6]) == pytest.approx(1.5e-5, rel=1e-12)
    assert got[1, 6] < 0 and got[8, 8] == 0  # farther north the level leans to the west: about minus east


def test_the_hand_over_leaves_a_covariance_and_the_inflation_is_of_the_filters_part_alone():
    P, S, P_c, P_p, T = parts(seed=4)
    once, four = (handover.hand_over(P, S, P_c, P_p, T, inflation=k) for k in (1.0, 4.0))
    check_covariance("P", once, 15)
    assert np.allclose((four - once)[3:9, 3:9], 3 * (T[3:, 3:] @ P[:6, :6] @ T[3:, 3:].T))
    assert np.array_equal((four - once)[9:], np.zeros((6, 15)))


def test_runs_are_handed_over_as_each_alone():
    P, S, P_c, P_p, T = parts(seed=5)
    both = handover.hand_over(np.stack([P, 2 * P]), np.stack([S, -S]), P_c, P_p, T)
    assert both.shape == (2, 15, 15)
    assert np.allclose(both[1], handover.hand_over(2 * P, -S, P_c, P_p, T), rtol=1e-12)


def test_the_sensitivity_is_what_a_constant_error_does_to_the_loop():
    # A Kalman filter over random matrices, flown without noise but with constant c: what is left is S c.
    rng = np.random.default_rng(2)
    P, S, r = covariance(10, 3), np.zeros((10, 12)), np.zeros(10)
    C, R = np.linalg.qr(rng.normal(size=(3, 3)))[0], np.full(6, 0.5)
    c = rng.normal(size=12)
    for _ in range(5):
        Phi, H = np.eye(10) + 0.1 * rng.normal(size=(10, 10)), rng.normal(size=(6, 10))
        S = handover.predicted(S, Phi, C, 0.1)
        r = Phi @ r + 0.1 * np.concatenate([-C @ c[3:6], C @ c[:3], np.zeros(4)])
        P = Phi @ P @ Phi.T + 0.01 * np.eye(10)
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + np.diag(R))
        r = r - K @ (H @ r - c[6:])
        after = (np.eye(10) - K @ H) @ P
        S, P = handover.updated(S, P, after, H, R), after
        assert np.allclose(S @ c, r, rtol=1e-9, atol=1e-9 * np.abs(r).max())


def complete(P, nis, rows=6):
    criterion = handover.Completion(level_sigma=1e-3, azimuth_sigma=2e-3)
    return bool(handover.alignment_complete(P, np.asarray(nis), np.full(np.shape(nis), rows), criterion))


def test_an_alignment_is_complete_when_it_is_known_and_believed():
    P = np.diag([1.0, 1, 1, 0.9e-6, 0.9e-6, 3.9e-6, 1, 1, 1, 1])
    assert complete(P, [6.0] * 10)
    assert complete(P, [1.0] * 10)  # cautious, not wrong
    assert not complete(P, [12.0] * 10)  # 120 where 60 +- 11 are due
    for state in (3, 4, 5):
        worse = P.copy()
        worse[state, state] *= 1.3
        assert not complete(worse, [6.0] * 10)
    assert not complete(P, [0.0] * 10, rows=0)  # no row, no evidence


def test_a_sound_filter_is_called_unsound_as_often_as_was_asked():
    n = 20_000
    nis = np.random.default_rng(0).chisquare(6, size=(10, n))
    criterion = handover.Completion(1.0, 1.0, false_alarm=0.05)
    P = np.broadcast_to(np.eye(10) * 0.01, (n, 10, 10))
    refused = 1 - handover.alignment_complete(P, nis, np.full(nis.shape, 6), criterion).mean()
    assert abs(refused - 0.05) < 4 * np.sqrt(0.05 * 0.95 / n)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda P: P.__setitem__((0, 1), P[0, 1] + 1), "not symmetric"),
        (lambda P: P.__setitem__((2, 2), -1.0), "negative variance"),
        (lambda P: P.__setitem__((slice(0, 2), slice(0, 2)), [[1, 2], [2, 1]]), "negative eigenvalue"),
        (lambda P: P.__setitem__((0, 0), np.nan), "not finite"),
    ],
)
def test_a_matrix_that_is_no_covariance_is_refused(change, says):
    P, S, P_c, P_p, T = parts()
    change(P)
    with pytest.raises(BoresightError, match=says):
        handover.hand_over(P, S, P_c, P_p, T)


def test_bad_shapes_inflation_and_nis_are_refused():
    P, S, P_c, P_p, T = parts()
    with pytest.raises(BoresightError, match=r"\(\.\.\., 10, 10\)"):
        handover.hand_over(P[:9, :9], S, P_c, P_p, T)
    with pytest.raises(BoresightError, match="phi_from_psi"):
        handover.hand_over(P, S[:, :6], P_c, P_p, T)
    with pytest.raises(BoresightError, match="inflation"):
        handover.hand_over(P, S, P_c, P_p, T, inflation=0.5)
    with pytest.raises(BoresightError, match="nis"):
        complete(np.eye(10), [np.nan])
