"""Sensors of a master and a slave on one moving platform, made from exact rotations.

Attitude is sinusoidal about a mean; the platform does not travel.  Inertial data are increments: the rotation vector
of the whole turn from one sample to the next, of the body against inertial space, in the body's axes (at either end:
a rotation leaves its own axis alone).  They recompose the attitude to rounding, whatever the interval.

Frames: n is NED, m the master's body, b the slave's body (both FRD).  C_b2n = C_m2n exp([mu x]).
"""

from dataclasses import dataclass

import numpy as np

from boresight.runtime.array import Array
from boresight.runtime.rotation import matrix_from_vector

EARTH_RATE_RAD_S = 7.292115e-5  # WGS-84


@dataclass(frozen=True)
class Sinusoids:
    """euler(t) = mean + amplitude sin(2 pi t / period + phase), angle by angle: roll, pitch, yaw.

    Each field is (..., 3), in rad and seconds, and they broadcast; an angle of amplitude zero is at rest.
    """

    amplitude: Array
    period: Array
    phase: Array
    mean: Array

    def euler(self, time: Array) -> Array:
        """(T,) s -> (T, ..., 3) rad, roll pitch yaw, body to NED."""
        amplitude, period, phase, mean = (
            np.asarray(part, float) for part in (self.amplitude, self.period, self.phase, self.mean)
        )
        axes = np.broadcast(amplitude, period, phase, mean).ndim
        time = np.asarray(time, float).reshape((-1,) + (1,) * axes)
        return mean + amplitude * np.sin(2 * np.pi * time / period + phase)


def earth_rate_n(latitude: float) -> Array:
    """Rate of NED against inertial space at rest on the Earth, (3,) rad/s, in NED.  latitude: rad."""
    return EARTH_RATE_RAD_S * np.array([np.cos(latitude), 0.0, -np.sin(latitude)])


def mounted(increments_m: Array, mu: Array) -> Array:
    """The master's increments in the axes of a slave bolted to it, C_b2m = exp([mu x]): (..., 3) rad.

    Exact: a rigid body turns about one axis, and the slave sees the same turn in other components.
    """
    return np.einsum("...ji,...j->...i", matrix_from_vector(mu), increments_m)


def generator(seed: int, run: int) -> np.random.Generator:
    """The random numbers of one run, whatever other runs are made beside it."""
    return np.random.Generator(np.random.Philox(np.random.SeedSequence([seed, run])))


def standard_normals(seed: int, runs: Array, count: int) -> Array:
    """(..., count) standard normal numbers for run numbers of shape (...); a larger count only appends to each row."""
    runs = np.asarray(runs)
    out = np.empty((runs.size, count))
    for row, run in zip(out, runs.ravel().tolist(), strict=True):
        generator(seed, run).standard_normal(out=row)
    return out.reshape((*runs.shape, count))
