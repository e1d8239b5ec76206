"""Attitudes in one form or another, many at once; SciPy's rotations do what no flight asks for at every step.

C_b2n takes body components to navigation components, Euler angles are roll, pitch, yaw with C_b2n = Rz(yaw) Ry(pitch)
Rx(roll), quaternions are scalar first.  Angles in rad; every array may have leading axes.
"""

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from boresight.runtime.array import Array
from boresight.runtime.array import wrapped as wrapped


def matrix_from_euler(euler: Any) -> Array:
    """(..., 3) -> C_b2n (..., 3, 3)."""
    return _matrix(_from_euler(euler), np.shape(euler)[:-1])


def quaternion_from_euler(euler: Any) -> Array:
    """(..., 3) -> q_b2n_wxyz (..., 4)."""
    # half a turn about each axis; yaw, then pitch, then roll
    (cr, cp, cy), (sr, sp, sy) = (np.moveaxis(of(np.asarray(euler, float) / 2), -1, 0) for of in (np.cos, np.sin))
    level, steep, cross, both = cy * cp, cy * sp, sy * cp, sy * sp
    return np.stack(
        [level * cr + both * sr, level * sr - both * cr, steep * cr + cross * sr, cross * cr - steep * sr], axis=-1
    )


def euler_from_matrix(C_b2n: Any) -> Array:
    """(..., 3, 3) -> (..., 3), pitch within +-90 deg, where roll and yaw are one angle."""
    C = np.asarray(C_b2n, float)
    return Rotation.from_matrix(C.reshape(-1, 3, 3)).as_euler("ZYX")[:, ::-1].reshape(C.shape[:-1])


def matrix_from_quaternion(q_b2n_wxyz: Any) -> Array:
    """(..., 4) of any norm but zero -> C_b2n (..., 3, 3)."""
    w, x, y, z = np.moveaxis(np.asarray(q_b2n_wxyz, float), -1, 0)
    ww, xx, yy, zz = w * w, x * x, y * y, z * z
    rows = [[ww + xx - yy - zz, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), ww - xx + yy - zz, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), ww - xx - yy + zz]]  # fmt: skip
    C = np.empty((*np.shape(w), 3, 3))
    for i, row in enumerate(rows):
        for j, value in enumerate(row):
            C[..., i, j] = value
    C /= (ww + xx + yy + zz)[..., None, None]
    return C


def quaternion_from_matrix(C_b2n: Any) -> Array:
    """(..., 3, 3) -> q_b2n_wxyz (..., 4)."""
    C = np.asarray(C_b2n, float)
    return _wxyz(Rotation.from_matrix(C.reshape(-1, 3, 3)), C.shape[:-2])


def matrix_from_vector(rotation_vector: Any) -> Array:
    """(..., 3) rad -> exp([v x]) (..., 3, 3)."""
    return _matrix(_from_vector(rotation_vector), np.shape(rotation_vector)[:-1])


def vector_from_matrix(C: Any) -> Array:
    """(..., 3, 3) -> (..., 3) rad: v with C = exp([v x]), of at most half a turn."""
    C = np.asarray(C, float)
    return Rotation.from_matrix(C.reshape(-1, 3, 3)).as_rotvec().reshape(C.shape[:-1])


def product(q_m2n_wxyz: Any, q_b2m_wxyz: Any) -> Array:
    """The attitude of C_m2n C_b2m, (..., 4) each as they broadcast."""
    shape = np.broadcast_shapes(np.shape(q_m2n_wxyz)[:-1], np.shape(q_b2m_wxyz)[:-1])
    return _wxyz(_from_wxyz(_full(q_m2n_wxyz, (*shape, 4))) * _from_wxyz(_full(q_b2m_wxyz, (*shape, 4))), shape)


def turned(q_b2n_wxyz: Any, rotation_vector: Any) -> Array:
    """The attitude after the body has turned by `rotation_vector` (..., 3) rad, in its own axes: C exp([v x])."""
    shape = np.broadcast_shapes(np.shape(q_b2n_wxyz)[:-1], np.shape(rotation_vector)[:-1])
    return _wxyz(_from_wxyz(_full(q_b2n_wxyz, (*shape, 4))) * _from_vector(_full(rotation_vector, (*shape, 3))), shape)


def attitude_error(q_b2n_hat_wxyz: Any, q_b2n_wxyz: Any) -> Array:
    """eps of C_hat = exp(-[eps x]) C, in navigation axes, (..., 3) rad: the turn that removes the error."""
    a, b, c, d = np.moveaxis(np.asarray(q_b2n_wxyz, float), -1, 0)
    e, f, g, h = np.moveaxis(np.asarray(q_b2n_hat_wxyz, float), -1, 0)
    # true times the inverse of hat, of any norm and sign: half the turn is the angle between its two parts
    w = a * e + b * f + c * g + d * h
    v = [b * e - a * f + d * g - c * h, c * e - a * g + b * h - d * f, d * e - a * h + c * f - b * g]
    sign, w = np.where(w < 0, -2.0, 2.0), np.abs(w)
    length = np.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    small = length < 1e-8 * w
    with np.errstate(divide="ignore", invalid="ignore"):
        scale = sign * np.where(small, 1 / w, np.arctan2(length, w) / length)
    return np.stack([scale * one for one in v], axis=-1)


def body_increments(q_b2n_wxyz: Any, omega_in_n: Any, dt: float) -> Array:
    """What perfect gyros deliver between samples: rotation vectors of the body against inertial space.

    q_b2n_wxyz: (T+1, ..., 4) at samples dt seconds apart.  omega_in_n: (3,) rad/s, constant.  Returns (T, ..., 3) rad.
    """
    q = np.asarray(q_b2n_wxyz, float)
    level = Rotation.from_rotvec(np.asarray(omega_in_n, float) * dt)
    return (_from_wxyz(q[:-1]).inv() * level * _from_wxyz(q[1:])).as_rotvec().reshape((*q[1:].shape[:-1], 3))


def _from_euler(euler: Any) -> Rotation:
    return Rotation.from_euler("ZYX", np.asarray(euler, float).reshape(-1, 3)[:, ::-1])


def _from_wxyz(q_wxyz: Any) -> Rotation:
    return Rotation.from_quat(np.asarray(q_wxyz, float).reshape(-1, 4), scalar_first=True)


def _from_vector(rotation_vector: Any) -> Rotation:
    return Rotation.from_rotvec(np.asarray(rotation_vector, float).reshape(-1, 3))


def _matrix(rotation: Rotation, shape: tuple[int, ...]) -> Array:
    return rotation.as_matrix().reshape((*shape, 3, 3))


def _wxyz(rotation: Rotation, shape: tuple[int, ...]) -> Array:
    return rotation.as_quat(scalar_first=True).reshape((*shape, 4))


def _full(values: Any, shape: tuple[int, ...]) -> Array:
    # A copy: older SciPy refuses the read-only view that broadcasting gives.
    return np.array(np.broadcast_to(values, shape), float)
