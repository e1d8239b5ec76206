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


def shown_after(history: Array, threshold: float) -> Array:
    """Number of the first sample from which on a sigma stays below `threshold` times the first; nan if it never does.

    history: (T+1, ...) sigmas.
    """
    below = history < threshold * history[0]
    stays = np.flip(np.logical_and.accumulate(np.flip(below, axis=0), axis=0), axis=0)
    return np.where(stays.any(0), stays.argmax(0), np.nan)
