"""Sensors of a master and a slave on one moving platform, made from exact rotations.

Attitude is sinusoidal about a mean; the platform does not travel.  Inertial data are increments: the rotation vector
of the whole turn from one sample to the next, of the body against inertial space, in the body's axes (at either end:
a rotation leaves its own axis alone).  They recompose the attitude to rounding, whatever the interval.

Frames: n is NED, r the master's body, b the slave's body (both FRD).  C_b2n = C_r2n exp([mu x]).
"""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

Array = np.ndarray

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


def quaternion_from_euler(euler: Array) -> Array:
    """(..., 3) rad, roll pitch yaw -> (..., 4) body to navigation, scalar first."""
    euler = np.asarray(euler, float)
    return _wxyz(Rotation.from_euler("ZYX", euler.reshape(-1, 3)[:, ::-1]), euler.shape[:-1])


def matrix_from_quaternion(q_b2n_wxyz: Array) -> Array:
    """(..., 4) -> C_b2n (..., 3, 3)."""
    q = np.asarray(q_b2n_wxyz, float)
    return _rotation(q).as_matrix().reshape((*q.shape[:-1], 3, 3))


def matrix_from_vector(rotation_vector: Array) -> Array:
    """(..., 3) rad -> exp([v x]) (..., 3, 3)."""
    v = np.asarray(rotation_vector, float)
    return Rotation.from_rotvec(v.reshape(-1, 3)).as_matrix().reshape((*v.shape, 3))


def turned(q_b2n_wxyz: Array, rotation_vector: Array) -> Array:
    """The attitude after the body has turned by `rotation_vector` (..., 3) rad, in its own axes: C exp([v x])."""
    shape = np.broadcast_shapes(np.shape(q_b2n_wxyz)[:-1], np.shape(rotation_vector)[:-1])
    turn = Rotation.from_rotvec(_full(rotation_vector, (*shape, 3)))
    return _wxyz(_rotation(_full(q_b2n_wxyz, (*shape, 4))) * turn, shape)


def attitude_error(q_b2n_hat_wxyz: Array, q_b2n_wxyz: Array) -> Array:
    """eps of C_hat = exp(-[eps x]) C, in navigation axes, (..., 3) rad: the turn that removes the error."""
    shape = np.broadcast_shapes(np.shape(q_b2n_hat_wxyz), np.shape(q_b2n_wxyz))
    hat, true = _rotation(_full(q_b2n_hat_wxyz, shape)), _rotation(_full(q_b2n_wxyz, shape))
    return (true * hat.inv()).as_rotvec().reshape((*shape[:-1], 3))


def body_increments(q_b2n_wxyz: Array, omega_in_n: Array, dt: float) -> Array:
    """What perfect gyros deliver between samples: rotation vectors of the body against inertial space.

    q_b2n_wxyz: (T+1, ..., 4) at samples dt seconds apart.  omega_in_n: (3,) rad/s, constant.  Returns (T, ..., 3) rad.
    """
    q = np.asarray(q_b2n_wxyz, float)
    frame = Rotation.from_rotvec(np.asarray(omega_in_n, float) * dt)
    turn = _rotation(q[:-1]).inv() * frame * _rotation(q[1:])
    return turn.as_rotvec().reshape((*q[1:].shape[:-1], 3))


def mounted(increments_r: Array, mu: Array) -> Array:
    """The master's increments in the axes of a slave bolted to it, C_b2r = exp([mu x]): (..., 3) rad.

    Exact: a rigid body turns about one axis, and the slave sees the same turn in other components.
    """
    return np.einsum("...ji,...j->...i", matrix_from_vector(mu), increments_r)


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


def _rotation(q_wxyz: Array) -> Rotation:
    return Rotation.from_quat(np.asarray(q_wxyz, float).reshape(-1, 4), scalar_first=True)


def _wxyz(rotation: Rotation, shape: tuple[int, ...]) -> Array:
    return rotation.as_quat(scalar_first=True).reshape((*shape, 4))


def _full(values: Array, shape: tuple[int, ...]) -> Array:
    # A copy: older SciPy refuses the read-only view that broadcasting gives.
    return np.array(np.broadcast_to(values, shape), float).reshape(-1, shape[-1])
