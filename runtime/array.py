"""The one name for arrays in signatures: a docstring says their shape, unit and frame.  And angles less whole turns."""

from typing import Any

import numpy as np

Array = np.ndarray


def wrapped(angle: Any) -> Array:
    """The angle less whole turns, in [-pi, pi): what lies there already keeps its bits, as `bs_wrap` of the C does."""
    a = np.asarray(angle, float)
    turned = a - 2 * np.pi * np.floor((a + np.pi) / (2 * np.pi))
    # rounding may end at pi itself, or beyond -pi
    turned = np.where((turned >= np.pi) | (turned < -np.pi), -np.pi, turned)
    return np.where((a >= -np.pi) & (a < np.pi), a, turned)
