"""Euler-angle matching written by hand in NumPy and SciPy, from finite rotations: the witness beside the generated C.

The functions, their fields and their shapes are those of the compiled library; each takes any number of runs.
"""

from types import SimpleNamespace

import numpy as np
from scipy.spatial.transform import Rotation


def matrix(q):
    q = np.asarray(q, float)
    return Rotation.from_quat(q.reshape(-1, 4), scalar_first=True).as_matrix().reshape((*q.shape[:-1], 3, 3))


def quaternion(C):
    return Rotation.from_matrix(C.reshape(-1, 3, 3)).as_quat(scalar_first=True).reshape((*C.shape[:-2], 4))


def exp(v):
    v = np.asarray(v, float)
    return Rotation.from_rotvec(v.reshape(-1, 3)).as_matrix().reshape((*v.shape[:-1], 3, 3))


def log(C):
    """v with C = exp(v), (..., 3)."""
    return Rotation.from_matrix(C.reshape(-1, 3, 3)).as_rotvec().reshape(C.shape[:-1])


def dcm(euler):
    euler = np.asarray(euler, float)
    return Rotation.from_euler("ZYX", euler.reshape(-1, 3)[:, ::-1]).as_matrix().reshape((*euler.shape[:-1], 3, 3))


def angles(C):
    return np.stack(
        [np.arctan2(C[..., 2, 1], C[..., 2, 2]), -np.arcsin(C[..., 2, 0]), np.arctan2(C[..., 1, 0], C[..., 0, 0])], -1
    )


def wrap(angle):
    return (angle + np.pi) % (2 * np.pi) - np.pi


def cross(v):
    v = np.asarray(v, float)
    zero = np.zeros(v.shape[:-1])
    x, y, z = v[..., 0], v[..., 1], v[..., 2]
    return np.stack([zero, -z, y, z, zero, -x, -y, x, zero], -1).reshape((*v.shape[:-1], 3, 3))


def rate_matrix(euler):
    """d(Euler angles) / d(small rotation in body axes), inverting the rotation of each angle alone."""
    roll, pitch = np.asarray(euler, float)[..., 0], np.asarray(euler, float)[..., 1]
    zero, one = np.zeros_like(roll), np.ones_like(roll)
    columns = [
        np.stack([one, zero, zero], -1),
        np.stack([zero, np.cos(roll), -np.sin(roll)], -1),
        np.stack([-np.sin(pitch), np.sin(roll) * np.cos(pitch), np.cos(roll) * np.cos(pitch)], -1),
    ]
    return np.linalg.inv(np.stack(columns, -1))


def F(omega_in_n):
    out = np.zeros((*np.shape(omega_in_n)[:-1], 6, 6))
    out[..., :3, :3] = -cross(omega_in_n)
    return out


def Phi(omega_in_n, dt):
    f = F(omega_in_n) * np.asarray(dt)[..., None, None]
    return np.eye(6) + f + f @ f / 2


def Q(q_b2n_wxyz, omega_in_n, gyro_noise, dt):
    C, f, dt = matrix(q_b2n_wxyz), F(omega_in_n), np.asarray(dt)[..., None, None]
    G = np.concatenate([-C, np.zeros_like(C)], -2)
    q = G @ (np.asarray(gyro_noise)[..., :, None] ** 2 * np.swapaxes(G, -1, -2))
    t = np.swapaxes
    fq = f @ q
    return q * dt + (fq + t(fq, -1, -2)) * dt**2 / 2 + (f @ fq + t(f @ fq, -1, -2) + 2 * fq @ t(f, -1, -2)) * dt**3 / 6


def euler_angles(q_b2n_wxyz):
    return angles(matrix(q_b2n_wxyz))


def euler_z(euler_b, euler_m, mu):
    relative = np.einsum("...ij,...j->...i", rate_matrix(euler_m), mu)
    return wrap(np.asarray(euler_b) - euler_m - relative)


def euler_H(euler_b, euler_m):
    C_n2b = np.swapaxes(dcm(euler_b), -1, -2)
    parts = -rate_matrix(euler_b) @ C_n2b, -rate_matrix(euler_m)
    return np.concatenate(np.broadcast_arrays(*parts), -1)


def euler_exact_z(euler_b, euler_m, mu):
    return wrap(angles(dcm(euler_b) @ exp(-np.asarray(mu))) - euler_m)


def euler_exact_h(x, euler_b, mu):
    C, x = dcm(euler_b), np.asarray(x, float)
    return wrap(angles(C @ exp(-np.asarray(mu))) - angles(exp(x[..., :3]) @ C @ exp(x[..., 3:] - mu)))


def euler_exact_H(x, euler_b, mu):
    x, step = np.asarray(x, float), 1e-6
    columns = [
        (euler_exact_h(x + d, euler_b, mu) - euler_exact_h(x - d, euler_b, mu)) / (2 * step) for d in step * np.eye(6)
    ]
    return np.stack(columns, -1)


def strapdown(q_b2n_wxyz, dtheta_ib_b, omega_in_n, dt):
    turn = np.asarray(omega_in_n) * np.asarray(dt)[..., None]
    return quaternion(exp(-turn) @ matrix(q_b2n_wxyz) @ exp(dtheta_ib_b))


def feedback(q_b2n_wxyz, mu, x):
    x = np.asarray(x, float)
    return {"q_b2n_wxyz": quaternion(exp(x[..., :3]) @ matrix(q_b2n_wxyz)), "mu": np.asarray(mu) - x[..., 3:]}


def model():
    """The functions as one object; `.fields` names what each takes, as the compiled library does."""
    functions = (
        F,
        Phi,
        Q,
        euler_angles,
        euler_z,
        euler_H,
        euler_exact_z,
        euler_exact_h,
        euler_exact_H,
        strapdown,
        feedback,
    )
    for function in functions:
        function.fields = function.__code__.co_varnames[: function.__code__.co_argcount]
    return SimpleNamespace(**{function.__name__: function for function in functions})
