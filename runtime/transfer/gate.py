"""The gate where residuals are not linear in the errors yet: widened by what they are besides, never open."""

from collections.abc import Callable, Sequence

import numpy as np

from boresight.runtime.array import Array

REACH = 0.9  # of the model's range for the error state, in one trial


def second_order(z: Callable[[Array], Array], P: Array, places: Sequence[int], limit: Array) -> tuple[Array, Array]:
    """Mean (..., m) and covariance (..., m, m) of a residual's part that is of the second order in the error state.

    z: of errors (K, ..., n) the residuals (K, ..., m) of a message that says what is expected.  P: (..., n, n).
    places: states in which z bends.  limit: (..., n) up to which an error may be tried.

    Of h_i = H_i x + x' H_i'' x / 2 these are tr(H_i'' P) / 2 and tr(H_i'' P H_j'' P) / 2, by second differences of z
    along the columns of a root of P, and along their sums for the mixed ones.
    """
    count = len(places)
    size, axes = np.linalg.eigh(P[..., places, :][..., places])
    root = np.moveaxis(axes * np.sqrt(np.maximum(size, 0.0))[..., None, :], -1, 0)  # (count, ..., count), by column
    first, second = np.triu_indices(count, 1)
    along = np.concatenate([root, root[first] + root[second]])
    x = np.zeros((*along.shape[:-1], P.shape[-1]))
    x[..., places] = along
    part = 1 / np.maximum(1.0, np.max(np.abs(x) / limit, axis=-1, keepdims=True))
    both = z(np.concatenate([part * x, -part * x, np.zeros_like(x[:1])]))
    bend = (both[: len(x)] + both[len(x) : -1]) / 2 - both[-1]
    bend = bend / part**2
    own, mixed = bend[:count], bend[count:] - bend[first] - bend[second]
    each = np.concatenate([np.sqrt(2) * own, mixed])
    return own.sum(0), np.einsum("k...i,k...j->...ij", each, each)


def nis(nu: Array, H: Array, P: Array, R: Array, rows: Array, m: Array, S2: Array) -> Array:
    """(...,) of the rows (..., m) that there are: (nu - m)' (H P H' + R + S2)^-1 (nu - m)."""
    nu, H = np.where(rows, nu - m, 0.0), np.where(rows[..., None], H, 0.0)
    S = H @ P @ np.swapaxes(H, -1, -2) + np.where(rows[..., None] & rows[..., None, :], S2, 0.0)
    S = S + np.where(rows, R, 1.0)[..., None] * np.eye(R.shape[-1])
    out: Array = np.einsum("...i,...i->...", nu, np.linalg.solve(S, nu[..., None])[..., 0])
    return out
