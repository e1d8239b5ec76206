"""Which errors a motion shows, and how soon: a filter's covariance with H taken along the true motion.

An H at estimates that are wrong pretends to information that is not there; along the truth it does not.  Deterministic.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight.runtime.array import Array
from boresight.runtime.filter import Filter


@dataclass(frozen=True)
class Replaced:
    """A model with some functions exchanged, each with its `.fields`."""

    model: Any
    functions: dict[str, Any]

    def __getattr__(self, name: str) -> Any:
        return self.functions[name] if name in self.functions else getattr(self.model, name)


def with_fields(function: Any, *fields: str) -> Any:
    """The function, saying what it takes as a compiled one does."""
    function.fields = fields
    return function


@dataclass(frozen=True)
class Moment:
    """One step: what Phi and Q are called with, and then, if H is given, a measurement."""

    inputs: dict[str, Any]
    H: Array | None = None  # (..., m, n)
    R: Array | None = None  # (..., m) variances
    rows: Any = True  # (..., m) bool


def taken_over(C_b2n: Array, sigma: float) -> Array:
    """(..., 6, 6) of [eps dmu] of a slave that takes the master's attitude for its own: eps = -C dmu.

    Exact, with mu_hat = 0: exp(-[C mu x]) C exp([mu x]) = C.  sigma: rad, of the misalignment about each axis.
    """
    couple = np.concatenate([C_b2n, np.broadcast_to(-np.eye(3), C_b2n.shape)], axis=-2)
    P: Array = sigma**2 * couple @ np.swapaxes(couple, -1, -2)
    return P


def along(model: Any, P0: Array, moments: Iterable[Moment]) -> Iterator[Array]:
    """P (..., n, n) after each moment."""

    def known_H(H: Array) -> Array:
        return H

    def no_z(H: Array) -> Array:
        return np.zeros(H.shape[:-1])

    known = Replaced(model, {"known_z": with_fields(no_z, "H"), "known_H": with_fields(known_H, "H")})
    flown = Filter(known, {}, P0)
    for moment in moments:
        flown.predict(**moment.inputs)
        if moment.H is not None:
            flown.update("known", moment.R, rows=moment.rows, H=moment.H)
        yield flown.P


def since(true: Array) -> Array:
    """Number of the first sample from which on (T, ...) stays true to the end; nan where the last one is not."""
    stays = np.flip(np.logical_and.accumulate(np.flip(true, axis=0), axis=0), axis=0)
    return np.where(stays.any(0), stays.argmax(0), np.nan)
