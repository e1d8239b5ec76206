"""Points at which a model is held against exact mechanics: inside the boxes and the norms that it declares.

Each variable is drawn by its own name, so that neither the name of the model nor another input moves its points.
"""

import numpy as np
from flint import arb

from boresight import BoresightError
from boresight.codegen.functions.reference import precise
from boresight.codegen.functions.samples import generator
from boresight.derive.model import Variable

TRIES = 4096  # points of a box among which those are looked for whose norm fits


def drawn(v: Variable, count: int, check: str) -> np.ndarray:
    """(count, size) in the box of v, with a norm in its range, or of exactly 1 if it is a unit vector.

    check: what is held there, as `F`.  Raises BoresightError where no point of the box with such a norm is found.
    """
    rng, low, high = generator("points", check, v.name), np.array(v.low), np.array(v.high)
    if v.norm is None:
        return low + (high - low) * rng.random((count, v.size))
    values = low + (high - low) * rng.random((TRIES, v.size))
    least, most = (1.0, 1.0) if v.unit_norm else v.norm
    lengths = least + (most - least) * rng.random((TRIES, 1))
    values *= lengths / np.linalg.norm(values, axis=1, keepdims=True)
    inside = values[((low <= values) & (values <= high)).all(axis=1)][:count]
    if len(inside) < count:
        raise BoresightError(f"{v.name}: no point of its box has a norm of {least:g} to {most:g}; widen the box")
    return inside


def exact_points(v: Variable, count: int, check: str) -> list[list[arb]]:
    """The same as exact numbers; the norm of a unit vector is 1 in all digits."""
    columns = [[arb(float(number)) for number in row] for row in drawn(v, count, check)]
    if v.unit_norm:
        with precise():
            lengths = [sum((c * c for c in column), arb(0)).sqrt() for column in columns]
            columns = [[(c / n).mid() for c in column] for column, n in zip(columns, lengths, strict=True)]
    return columns


def nearest_zero(v: Variable) -> list[arb]:
    """The values of its box that are nearest to zero."""
    return [arb(min(max(0.0, low), high)) for low, high in zip(v.low, v.high, strict=True)]
