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


def along(model: Any, P0: Array, steps: Iterable[Moment]) -> Iterator[Array]:
    """The covariance of a filter with H along the true motion: what a motion makes observable.

    An H at estimates that are wrong pretends to information that is not there; along the truth it
    does not.  Deterministic: no noise is drawn and no state is estimated.

    Parameters
    ----------
    model : Library, or any object with Phi and Q
        An error state, or a total state whose Phi and Q the steps give inputs for.
    P0 : (..., n, n) array
        Covariance at the start.
    steps : iterable of Moment
        Of each `inputs`, what Phi and Q are called with at the truth; and, where something is
        measured, `H` (..., m, n), `R` (..., m) variances, `rows` (..., m) bool.

    Yields
    ------
    (..., n, n) array
        P after each step, in the states' units.

    Raises
    ------
    BoresightError
        Inputs that the model does not have, P0 that is no covariance, R that is not above zero.

    Notes
    -----
    When not to use it: to ask how large the errors of a flight are; that is what `Consistency`
    shows.  A variance that falls says that a motion informs a state, not that a filter uses it
    rightly.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import load, observability
    >>> inputs = {"q_b2n_wxyz": [1, 0, 0, 0], "omega_in_n": np.zeros(3), "dt": 1.0,
    ...           "gyro_noise": np.full(3, 1e-5)}
    >>> H = np.hstack([np.eye(3), np.eye(3)])  # attitude and mounting, seen as their sum
    >>> step = observability.Moment(inputs, H, R=np.full(3, 1e-8))
    >>> *_, P = observability.along(load("euler-matching"), np.eye(6) * 1e-4, [step] * 10)
    >>> print(np.sqrt(np.diag(P)).round(4))
    [0.0071 0.0071 0.0071 0.0071 0.0071 0.0071]
    """

    def known_H(H: Array) -> Array:
        return H

    def no_z(H: Array) -> Array:
        return np.zeros(H.shape[:-1])

    known = Replaced(model, {"known_z": with_fields(no_z, "H"), "known_H": with_fields(known_H, "H")})
    flown = Filter(known, {}, P0)
    for moment in steps:
        flown.predict(**moment.inputs)
        if moment.H is not None:
            flown.update("known", moment.R, rows=moment.rows, H=moment.H)
        yield flown.P


def since(true: Array) -> Array:
    """Number of the first sample from which on (T, ...) stays true to the end; nan where the last one is not."""
    stays = np.flip(np.logical_and.accumulate(np.flip(true, axis=0), axis=0), axis=0)
    return np.where(stays.any(0), stays.argmax(0), np.nan)
