"""What innovations say: whether they are consistent, and the noises under which they are most likely."""

from collections.abc import Callable
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.likelihood import damped_step
from boresight.runtime.array import Array


def consistency(w: Array, used: Any = True) -> dict[str, Any]:
    """Of (K, m) normalised innovations: their mean square and how far they are from white.

    used: (K, m) bool, False for what was refused, which is in no figure.
    per_row, mean: 1 if consistent; band: the 95 % band of mean.  by_quarter: the mean over each quarter of the time,
    which a choice of noises does not make 1, None where nothing was used.  lag1: correlation of neighbours by row;
    lag1_bound: two sigmas of white noise.
    """
    used = np.broadcast_to(used, w.shape)
    w = np.where(used, w, 0.0)
    count = max(1, used.sum())
    half = 1.96 * np.sqrt(2 / count)

    square, pairs = w**2, (used[1:] & used[:-1]).sum(0)
    per_row, over_all = square.sum(0) / np.maximum(used.sum(0), 1), float(square.sum() / count)
    quarters = zip(np.array_split(square, 4), np.array_split(used, 4), strict=True)
    lag1 = np.sum(w[1:] * w[:-1], axis=0) / np.maximum(pairs, 1) / np.maximum(per_row, 1e-300)
    bound = 2 / np.sqrt(max(1, pairs.min()))
    return {
        "per_row": per_row.tolist(),
        "mean": over_all,
        "band": [1 - half, 1 + half],
        "consistent": bool(abs(over_all - 1) <= half),
        "by_quarter": [float(one.sum() / rows.sum()) if rows.any() else None for one, rows in quarters],
        "lag1": lag1.tolist(),
        "lag1_bound": bound,
        "white": bool(np.max(np.abs(lag1)) <= bound),
    }


def minus_log_likelihood(track: dict[str, Any]) -> Array:
    """(...,) of the innovations nu and their variances S, (K, ..., rows), up to a constant; of the rows used."""
    each = np.log(track["S"]) + track["nu"] ** 2 / track["S"]
    cost: Array = 0.5 * np.sum(np.where(track.get("used", True), each, 0.0), axis=(0, -1))
    return cost


def most_likely(
    fly: Callable[[Array], dict[str, Any]],
    first: Array,
    free: Array,
    limits: tuple[Any, Any],
    *,
    enough: float = 0.02,
    progress: Callable[[str], None] | None = None,
) -> tuple[Array, Array, int]:
    """The noises (n,) of greatest likelihood, a sigma of the logarithm of each, and the passes that it took.

    The sigmas are of the information matrix, 0 of a noise that is kept.

    fly: noises (runs, n), flown side by side -> nu, S and, where some may be refused, used, each (K, runs, rows);
    noises are compared by what was used under all of them.  first: (n,) where it begins; those whose `free` (n,) is
    False are kept.  limits: (low, high), each a number or (n,).  enough: it
    ends where the next step promises no more of minus the log likelihood than this; half of one is one sigma.
    Fisher scoring on the logarithms; the derivatives of nu and S are differences of runs.
    Raises BoresightError if it does not settle in 40 passes.
    """
    where = np.flatnonzero(free)
    start = np.log(first)
    if len(where) == 0:
        return np.exp(start), np.zeros(len(start)), 0
    low, high = (np.where(free, np.log(limit), start) for limit in limits)
    h, radius, n = 0.05, 1.5, len(where)
    bump = h * np.eye(len(start))[where]
    centre, trial = start, start
    best: dict[str, Any] = {}
    gradient, information = np.zeros(n), np.eye(n)
    for passes in range(1, 41):
        points = np.exp(np.clip(np.vstack([trial, trial + bump, trial - bump]), low, high))
        track = fly(points)
        used: Array = np.all(np.broadcast_to(track.get("used", True), track["S"].shape), axis=1, keepdims=True)
        cost = minus_log_likelihood(track | {"used": used})
        both = used & best.get("used", True)
        now = {part: track[part][:, :1] for part in ("nu", "S")}
        if not best or minus_log_likelihood(now | {"used": both}) < minus_log_likelihood(best | {"used": both}):
            centre, best, radius = trial, now | {"used": used}, min(2 * radius, 1.5)
            gradient = (cost[1 : n + 1] - cost[n + 1 :]) / (2 * h)
            S = np.where(used[:, 0], track["S"][:, 0], np.inf)  # what was not used informs of nothing
            dS = (track["S"][:, 1 : n + 1] - track["S"][:, n + 1 :]) / (2 * h)
            dnu = (track["nu"][:, 1 : n + 1] - track["nu"][:, n + 1 :]) / (2 * h)
            information = np.einsum("kim,kjm,km->ij", dS, dS, 0.5 / S**2) + np.einsum("kim,kjm,km->ij", dnu, dnu, 1 / S)
        else:  # too far
            radius /= 4
        step = np.zeros(len(start))
        step[where] = damped_step(gradient, information, radius)
        trial = np.clip(centre + step, low, high)
        if progress is not None:
            at = float(minus_log_likelihood(best)[0])
            progress(f"choosing the noises: pass {passes}, minus log likelihood {at:.1f}")
        # Settled: the step, half of whose slope is what it promises, or no step however small makes it better.
        if -gradient @ (trial - centre)[where] < enough or radius < 1e-3:
            # A limit's logarithm does not come back as the limit: 9.999999999999994e-08 of 1e-7.
            sigma = np.zeros(len(start))
            sigma[where] = np.sqrt(np.diagonal(np.linalg.pinv(information, hermitian=True)))
            return np.where(free, np.clip(np.exp(centre), *limits), first), sigma, passes
    raise BoresightError("the choice of noises did not settle in 40 passes; give some of them, or look at --check")
