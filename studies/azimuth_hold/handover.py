"""From transfer alignment to azimuth hold: what ten states know, as the start of fifteen; and when it is enough.

The ten states of `velocity-dcm` are [dv_c psi dmu dtau], in the computed level; the fifteen of `azimuth-hold` are
[position dv phi dbg dba], in the true one.  What the ten leave out is considered instead: the errors
c = [dbg dba dv_m psi_m] of the slave's gyros and accelerometers (estimated - true, body axes), and of the master's
velocity and attitude.  They are constant over an alignment, so that the ten states' error is
r + S c, where r is what the filter's own P speaks of and S is carried beside it by `predicted` and `updated`.
"""

from dataclasses import dataclass

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.filter import check_covariance

CONSIDERED = 12  # dbg dba dv_m psi_m


def predicted(S: Array, Phi: Array, C_b2n: Array, dt: float) -> Array:
    """S (..., 10, 12) after a step of dt seconds, with the filter's Phi (..., 10, 10) and the attitude C_b2n."""
    S = Phi @ S
    S[..., 3:6, 0:3] += C_b2n * dt  # of the gyro bias what is not taken off turns psi the other way
    S[..., 0:3, 3:6] -= C_b2n * dt
    return S


def updated(S: Array, P_before: Array, P_after: Array, H: Array, R: Array) -> Array:
    """S after a measurement of the slave less the master: velocity and attitude, H (..., 6, 10), R (..., 6).

    P_before, P_after: (..., 10, 10) of a filter that took it with the optimal gain, P_after H' R^-1, in one row or
    another: rows that were left out show in P_after and must stand in H as zeros.
    """
    scale = np.sqrt(np.einsum("...ii->...i", P_before))  # rad against seconds: invert what is near to one
    unit = np.linalg.inv(P_before / (scale[..., :, None] * scale[..., None, :]))
    kept = P_after @ (unit / (scale[..., :, None] * scale[..., None, :]))  # I - K H
    K = P_after @ (np.swapaxes(H, -1, -2) / np.asarray(R)[..., None, :])
    S = kept @ S
    S[..., 6:] += K  # the master's error enters z with a minus, and z enters the error with another
    return S


def hand_over(
    P: Array, S: Array, P_considered: Array, P_position: Array, phi_from_psi: Array, inflation: float = 1.0
) -> Array:
    """P (..., 15, 15) of azimuth hold from P (..., 10, 10) of the alignment.

    S: (..., 10, 12).  P_considered: (..., 12, 12) of c.  P_position: (..., 3, 3) of the position error, in
    coordinates.  phi_from_psi: (..., 9, 9), the map of that name at the place and velocity.  inflation: factor on the
    alignment's own P, at least 1.  Velocity and attitude get what the biases have made of them, with the correlation
    that lets the hold find the biases again, and the master's errors.  Misalignment and delay are let go.
    Raises BoresightError for a covariance that is none, or an inflation below 1.
    """
    if not (np.isfinite(inflation) and inflation >= 1):
        raise BoresightError(f"hand-over: inflation is {inflation:g}; it must be at least 1")
    for name, matrix, size in (("P", P, 10), ("P_considered", P_considered, 12), ("P_position", P_position, 3)):
        check_covariance(f"hand-over: {name}", matrix, size)
    if np.shape(S)[-2:] != (10, CONSIDERED) or np.shape(phi_from_psi)[-2:] != (9, 9):
        raise BoresightError(
            f"hand-over: S is {np.shape(S)} and phi_from_psi {np.shape(phi_from_psi)}; "
            "they must be (..., 10, 12) and (..., 9, 9)"
        )
    runs = np.broadcast_shapes(*(np.shape(part)[:-2] for part in (P, S, P_considered, P_position, phi_from_psi)))
    S6 = S[..., :6, :]
    out = np.zeros((*runs, 15, 15))
    out[..., :3, :3] = P_position
    out[..., 3:9, 3:9] = inflation * np.asarray(P)[..., :6, :6] + S6 @ P_considered @ np.swapaxes(S6, -1, -2)
    out[..., 9:, 9:] = np.asarray(P_considered)[..., :6, :6]
    out[..., 3:9, 9:] = (S6 @ P_considered)[..., :6]
    out[..., 9:, 3:9] = np.swapaxes(out[..., 3:9, 9:], -1, -2)
    T = np.broadcast_to(np.eye(15), out.shape).copy()
    T[..., :9, :9] = phi_from_psi
    out = T @ out @ np.swapaxes(T, -1, -2)
    return (out + np.swapaxes(out, -1, -2)) / 2


@dataclass(frozen=True)
class Completion:
    """When an alignment is complete: the attitude is known well enough, and the filter is to be believed."""

    level_sigma: float  # rad, of psi about east and about north
    azimuth_sigma: float  # rad, of psi about up
    false_alarm: float = 1e-3  # probability that a sound filter is called unsound


def alignment_complete(P: Array, nis: Array, rows: Array, criterion: Completion) -> Array:
    """(...,) bool.  P: (..., 10, 10).  nis, rows: (K, ...) of the last K updates, and how many rows each of them used.

    The sum of the NIS must stay below the chi-square bound for its rows; a NIS that is too low only says that the
    filter is cautious.  Without a row there is no evidence, and the answer is no.
    Raises BoresightError for a negative or missing NIS.
    """
    from scipy.stats import chi2

    nis, rows = np.asarray(nis, float), np.asarray(rows)
    if not (np.isfinite(nis).all() and (nis >= 0).all()):
        raise BoresightError("alignment_complete: nis must be finite and not negative; give that of taken updates")
    sigma = np.sqrt(np.einsum("...ii->...i", P)[..., 3:6])
    known = (sigma <= [criterion.level_sigma, criterion.level_sigma, criterion.azimuth_sigma]).all(-1)
    count = rows.sum(axis=0)
    return known & (count > 0) & (nis.sum(axis=0) <= chi2.ppf(1 - criterion.false_alarm, np.maximum(count, 1)))
