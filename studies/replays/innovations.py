"""What innovations say: whether they are consistent, and the noises under which they are most likely."""

from collections.abc import Callable
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array


def consistency(w: Array) -> dict[str, Any]:
    """Of (K, m) normalised innovations: their mean square and how far they are from white.

    per_row, mean: 1 if consistent; band: the 95 % band of mean.  by_quarter: the mean over each quarter of the time,
    which a choice of noises does not make 1.  lag1: correlation of neighbours by row; lag1_bound: two sigmas of white
    noise.
    """
    K, m = w.shape
    half = 1.96 * np.sqrt(2 / (m * K))
    lag1 = [float(w[1:, i] @ w[:-1, i] / (w[:, i] @ w[:, i])) for i in range(m)]
    mean = float(np.mean(w**2))
    return {
        "per_row": np.mean(w**2, axis=0).tolist(),
        "mean": mean,
        "band": [1 - half, 1 + half],
        "consistent": bool(abs(mean - 1) <= half),
        "by_quarter": [float(np.mean(part**2)) for part in np.array_split(w, 4)],
        "lag1": lag1,
        "lag1_bound": 2 / np.sqrt(K),
        "white": bool(np.max(np.abs(lag1)) <= 2 / np.sqrt(K)),
    }


def minus_log_likelihood(track: dict[str, Any]) -> Array:
    """(...,) of the innovations nu and their variances S, (K, ..., rows), up to a constant."""
    cost: Array = 0.5 * np.sum(np.log(track["S"]) + track["nu"] ** 2 / track["S"], axis=(0, -1))
    return cost


def most_likely(
    fly: Callable[[Array], dict[str, Any]],
    first: Array,
    free: Array,
    limits: tuple[Any, Any],
    *,
    enough: float = 0.02,
    progress: Callable[[str], None] | None = None,
) -> tuple[Array, int]:
    """The noises (n,) of greatest likelihood, and the passes that it took.

    fly: noises (runs, n), flown side by side -> nu and S, each (K, runs, rows).  first: (n,) where it begins; those
    whose `free` (n,) is False are kept.  limits: (low, high), each a number or (n,).  enough: it
    ends where the next step promises no more of minus the log likelihood than this; half of one is one sigma.
    Fisher scoring on the logarithms; the derivatives of nu and S are differences of runs.
    Raises BoresightError if it does not settle in 40 passes.
    """
    where = np.flatnonzero(free)
    start = np.log(first)
    if len(where) == 0:
        return np.exp(start), 0
    low, high = (np.where(free, np.log(limit), start) for limit in limits)
    h, radius, n = 0.05, 1.5, len(where)
    bump = h * np.eye(len(start))[where]
    centre, best, trial = start, np.inf, start
    gradient, information = np.zeros(n), np.eye(n)
    for passes in range(1, 41):
        points = np.exp(np.clip(np.vstack([trial, trial + bump, trial - bump]), low, high))
        track = fly(points)
        cost = minus_log_likelihood(track)
        if cost[0] < best:
            centre, best, radius = trial, cost[0], min(2 * radius, 1.5)
            gradient = (cost[1 : n + 1] - cost[n + 1 :]) / (2 * h)
            S = track["S"][:, 0]
            dS = (track["S"][:, 1 : n + 1] - track["S"][:, n + 1 :]) / (2 * h)
            dnu = (track["nu"][:, 1 : n + 1] - track["nu"][:, n + 1 :]) / (2 * h)
            information = np.einsum("kim,kjm,km->ij", dS, dS, 0.5 / S**2) + np.einsum("kim,kjm,km->ij", dnu, dnu, 1 / S)
        else:  # too far
            radius /= 4
        step = np.zeros(len(start))
        step[where] = damped_step(gradient, information, radius)
        trial = np.clip(centre + step, low, high)
        if progress is not None:
            progress(f"choosing the noises: pass {passes}, minus log likelihood {best:.1f}")
        # Settled: the step, half of whose slope is what it promises, or no step however small makes it better.
        if -gradient @ (trial - centre)[where] < enough or radius < 1e-3:
            return np.exp(centre), passes
    raise BoresightError("the choice of noises did not settle in 40 passes; give some of them, or look at --check")


def damped_step(gradient: Array, information: Array, radius: float) -> Array:
    """The step downhill, no component longer than RADIUS: damping turns a step that is too long towards the gradient.

    Cutting the components instead would spoil the direction: where one noise hides another they must move together.
    """
    damping = 1e-3
    while True:
        step: Array = -np.linalg.solve(information + damping * np.eye(len(gradient)), gradient)
        if np.abs(step).max() <= radius:
            return step
        damping *= 3
