"""The master's position against the slave's own way since the last one: a position that jumps is not taken at once.

Position enters only the Earth's rate, gravity and the level's turning.  A wrong one is wrong without any residual.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from boresight.runtime.array import Array

RADIUS = 6.378e6  # m; within 0.7 % of both radii of the ellipsoid
BEYOND = 5.0  # sigmas of an axis
FOLLOWED_S = 10.0  # a position that contradicts the slave's way is followed once it has agreed with itself so long


def metres(position: Any, other: Any) -> Array:
    """(..., 3) m north, east and up from `other` to `position`, latitude, longitude, height each."""
    position, other = np.asarray(position, float), np.asarray(other, float)
    d = position - other
    east = (d[..., 1] + np.pi) % (2 * np.pi) - np.pi
    return np.stack([RADIUS * d[..., 0], RADIUS * np.cos(other[..., 0]) * east, d[..., 2]], axis=-1)


def moved(position: Array, by: Array) -> Array:
    """The position (..., 3) so many metres north, east and up (..., 3) of another one."""
    lat, lon, height = np.moveaxis(position, -1, 0)
    east = by[..., 1] / (RADIUS * np.cos(lat))
    return np.stack([lat + by[..., 0] / RADIUS, (lon + east + np.pi) % (2 * np.pi) - np.pi, height + by[..., 2]], -1)


class PositionWatch:
    """Which of the master's positions are taken, run by run."""

    def __init__(self, runs: tuple[int, ...], time: float):
        self.runs = runs
        self.taken_at = np.full(runs, time)
        self.sigma = np.full((*runs, 3), np.nan)  # m, of the last one taken
        self.told = np.zeros(runs, bool)  # refused, and its end not yet
        self.other = np.full((*runs, 3), np.nan)  # what a refused one has become by the slave's own way
        self.other_at = np.full(runs, np.nan)
        self.last = np.full((*runs, 3), np.nan)  # the slave's position at the last message, to move `other` by

    def begin(self, where: Array, time: float, position: Array, sigma: Any) -> None:
        """These runs begin anew at this position (..., 3), which has this sigma, m."""
        for name, value in (("sigma", sigma), ("last", position), ("other", np.nan)):
            setattr(self, name, np.where(where[..., None], value, getattr(self, name)))
        self.taken_at = np.where(where, time, self.taken_at)
        self.told = self.told & ~where

    def takes(
        self,
        time: float,
        position: Array,
        sigma: Array,
        slave: Array,
        speed_sigma: Array,
        lever: Array,
        box: tuple[Array, Array],
        note: Callable[[Array, str], None],
    ) -> Array:
        """(...,) bool, which are taken; `note` is called with runs and a line where that changes.

        position, sigma (m): (..., 3) of the message, NaN where there is none to take.
        box: lowest and highest position that the model knows.
        slave: (..., 3) by dead reckoning since the last one taken; speed_sigma: (...,) m/s of its velocity, one axis.
        lever: (...,) m, between the two.
        """
        came = np.isfinite(position).all(-1)
        position = np.where(came[..., None], position, slave)
        known = came & ((position >= box[0]) & (position <= box[1])).all(-1)
        away = metres(position, slave)
        before = np.where(np.isfinite(self.sigma), self.sigma, sigma)
        drift = speed_sigma * (time - self.taken_at) + lever
        within = (np.abs(away) <= BEYOND * np.sqrt(sigma**2 + before**2 + drift[..., None] ** 2)).all(-1)
        # the other place, carried along by the slave's own way: a latitude of the wrong sign does not go with it
        self.other = np.where(np.isfinite(self.last), moved(self.other, metres(slave, self.last)), self.other)
        for_s = np.nan_to_num(time - self.other_at)
        drift = speed_sigma * for_s + lever
        agrees = np.abs(metres(position, self.other)) <= BEYOND * np.sqrt(2 * sigma**2 + drift[..., None] ** 2)
        followed = known & ~within & agrees.all(-1) & (for_s >= FOLLOWED_S)
        taken = (known & within) | followed
        anew = came & ~taken & ~agrees.all(-1)
        self.other = np.where(anew[..., None], position, np.where(taken[..., None], np.nan, self.other))
        self.other_at = np.where(anew, time, np.where(taken, np.nan, self.other_at))
        self.taken_at = np.where(taken, time, self.taken_at)
        self.sigma = np.where(taken[..., None], sigma, self.sigma)
        self.last = np.where(taken[..., None], position, slave)

        far = np.linalg.norm(away, axis=-1)
        refused = came & ~taken & ~self.told
        for where, text in (
            (refused, f"position refused: it lies {span(far, refused)} from where the slave has come since the "
             "last one that was taken; velocity and attitude still count"),
            (followed, f"position followed: it has agreed with itself for {FOLLOWED_S:g} s, {span(far, followed)} from "
             "where the slave has come"),
            (taken & ~followed & self.told, "positions are taken again"),
        ):  # fmt: skip
            note(where, text)
        self.told = (self.told | refused) & ~taken
        return taken


def span(metres: Array, where: Array) -> str:
    """The largest of these, for a line."""
    largest = float(np.max(np.where(where, metres, 0.0), initial=0.0))
    return f"{largest / 1e3:.1f} km" if largest >= 1e3 else f"{largest:.0f} m"
