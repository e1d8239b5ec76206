"""The slave that takes its master's velocity and attitude over."""

from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.transfer.history import PHI
from boresight.runtime.transfer.messages import Message


def first(
    message: Message,
    *,
    q_b2m_wxyz: Any = (1.0, 0.0, 0.0, 0.0),
    tau: Any = 0.0,
    mounting_sigma: Any,
    velocity_sigma: Any,
    gyro_bias_sigma: Any,
    accel_bias_sigma: Any,
    tau_sigma: Any,
) -> tuple[dict[str, Array], Array]:
    """nav and P (..., 16, 16) of a slave that takes the master's velocity and attitude over, through its mounting.

    q_b2m_wxyz: (..., 4) believed mounting, mounting_sigma: (..., 3) rad about the master's axes.  velocity_sigma:
    (..., 3) m/s, which has to cover the lever arm's velocity.  The other sigmas: (..., 3) rad/s and m/s^2, (...,) s.
    The attitude's own noise comes from R.  What is wrong with the mounting is wrong with the attitude: phi = C_m2n dmu.
    """
    for name in ("position", "v_m_n", "q_m2n_wxyz"):
        if getattr(message, name) is None:
            raise BoresightError(f"transfer: the first message holds no {name}; wait for one that does")
    C = rotation.matrix_from_quaternion(message.q_m2n_wxyz)
    q = rotation.quaternion_from_matrix(C @ rotation.matrix_from_quaternion(q_b2m_wxyz))
    runs = np.broadcast_shapes(
        q.shape[:-1], np.shape(message.R)[:-1], np.shape(tau), np.shape(tau_sigma), np.shape(message.v_m_n)[:-1],
        *(np.shape(s)[:-1] for s in (mounting_sigma, velocity_sigma, gyro_bias_sigma, accel_bias_sigma)),
    )  # fmt: skip
    nav = {
        "position": np.asarray(message.position, float), "v_n": np.asarray(message.v_m_n, float), "q_b2n_wxyz": q,
        "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3), "q_b2m_wxyz": np.asarray(q_b2m_wxyz, float),
        "tau": np.broadcast_to(np.asarray(tau, float), runs),
    }  # fmt: skip
    R = np.broadcast_to(np.asarray(message.R, float), (*runs, 6))
    P = np.zeros((*runs, 16, 16))
    i = np.arange(3)
    for at, sigma in ((3, velocity_sigma), (6, gyro_bias_sigma), (9, accel_bias_sigma), (12, mounting_sigma)):
        P[..., i + at, i + at] = np.square(np.broadcast_to(np.asarray(sigma, float), (*runs, 3)))
    P[..., 15, 15] = np.square(tau_sigma)
    P[..., PHI, 12:15] = C @ P[..., 12:15, 12:15]
    P[..., 12:15, PHI] = np.swapaxes(P[..., PHI, 12:15], -1, -2)
    P[..., PHI, PHI] = C @ P[..., 12:15, PHI] + R[..., 3:, None] * np.eye(3)
    P[..., PHI, PHI] = (P[..., PHI, PHI] + np.swapaxes(P[..., PHI, PHI], -1, -2)) / 2
    return nav, P
