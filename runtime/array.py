"""The one name for arrays in signatures: a docstring says their shape, unit and frame.  And what many need of them."""

from typing import Any

import numpy as np

Array = np.ndarray


def carried(P: Array, rows: slice, T: Array) -> Array:
    """T P T' of a symmetric P (..., n, n) of floats and a T that is the identity but in k rows, which are given.

    T: (..., k, n), of as many runs as P.
    """
    some = T @ P
    out = P.copy()
    out[..., rows, :] = some
    out[..., :, rows] = np.swapaxes(some, -1, -2)
    square = some @ np.swapaxes(T, -1, -2)
    out[..., rows, rows] = (square + np.swapaxes(square, -1, -2)) / 2
    return out


def wrapped(angle: Any) -> Array:
    """The angle less whole turns, in [-pi, pi): what lies there already keeps its bits, as `bs_wrap` of the C does."""
    a = np.asarray(angle, float)
    turned = a - 2 * np.pi * np.floor((a + np.pi) / (2 * np.pi))
    # rounding may end at pi itself, or beyond -pi
    turned = np.where((turned >= np.pi) | (turned < -np.pi), -np.pi, turned)
    return np.where((a >= -np.pi) & (a < np.pi), a, turned)
