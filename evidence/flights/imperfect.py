"""Slaves whose sensors are not ideal and whose seat bends: drawn run by run, by means that the filter does not share.

Each of twelve axes leaves its place in the case by itself; a bias wanders by the exact law of a Gauss-Markov process;
a seat bends by the exact law of an oscillator that white noise drives, or as a sine.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.linalg import expm

from boresight.runtime.array import Array
from boresight.runtime.transfer.sensors import Sensors

GRID = 0.01  # s, of the bending


@dataclass
class Truth:
    """What was drawn.  The body's axes are the accelerometers' own: x' = Q x, of axes x of the case."""

    gyro: Array  # (runs, 3, 3) shown over true, in the case's axes
    accel: Array
    Q: Array  # (runs, 3, 3)
    calibration: Array  # (runs, 15) K of both triads, true = (I - K) shown, in the order of the filter's states
    drift: tuple[Array, Array]  # (steps, runs, 3) of the gyro and accelerometer biases
    bend: Any  # of time: (..., runs, 3) rad about the master's axes
    bend_rate: Any


def drawn(sizes: Sensors, rng: np.random.Generator, runs: int, times: Array, *, sine: bool = False) -> Truth:
    """times: (steps,) s, where the biases are wanted.  sine: bends by sqrt(2) sigma sin, each axis in its own phase.

    A sine's `bending_damping` is of no account.
    """
    gyro, accel = (
        np.eye(3) + axes * rng.standard_normal((runs, 3, 3)) * (1 - np.eye(3))
        + scale * rng.standard_normal((runs, 3, 1)) * np.eye(3)
        for scale, axes in ((sizes.gyro_scale, sizes.gyro_axes), (sizes.accel_scale, sizes.accel_axes))
    )  # fmt: skip
    # accel = L Q, L with a positive diagonal
    q, r = np.linalg.qr(np.swapaxes(accel, -1, -2))
    sign = np.sign(np.diagonal(r, axis1=-2, axis2=-1))
    L, Q = np.swapaxes(r * sign[..., None], -1, -2), np.swapaxes(q * sign[:, None, :], -1, -2)
    K_g, K_a = np.eye(3) - np.linalg.inv(gyro @ np.swapaxes(Q, -1, -2)), np.eye(3) - np.linalg.inv(L)
    beside = ~np.eye(3, dtype=bool)
    numbers = np.concatenate([
        np.diagonal(K_g, axis1=1, axis2=2), np.diagonal(K_a, axis1=1, axis2=2), K_g[:, beside],
        K_a[:, [1, 2, 2], [0, 0, 1]],
    ], axis=-1)  # fmt: skip

    def wandering(sigma: float) -> Array:
        step = np.exp(-np.diff(times) / sizes.correlation_s)
        out = np.empty((len(times), runs, 3))
        out[0] = rng.standard_normal((runs, 3))
        for k, factor in enumerate(step):
            out[k + 1] = factor * out[k] + np.sqrt(1 - factor**2) * rng.standard_normal((runs, 3))
        return sigma * out

    drift = wandering(sizes.gyro_instability), wandering(sizes.accel_instability)
    omega = 2 * np.pi * sizes.bending_hz
    if sine or sizes.bending == 0:
        phase, size = rng.uniform(0, 2 * np.pi, (runs, 3)), np.sqrt(2) * sizes.bending

        def angle(t: Any) -> Array:
            return size * np.sin(omega * np.asarray(t)[..., None] + phase)

        def rate(t: Any) -> Array:
            return size * omega * np.cos(omega * np.asarray(t)[..., None] + phase)

        return Truth(gyro, accel, Q, numbers, drift, angle, rate)
    grid = np.arange(times[0] - 2.0, times[-1] + 1.0, GRID)
    A = np.array([[0.0, 1.0], [-(omega**2), -2 * sizes.bending_damping * omega]])
    Phi, stationary = expm(A * GRID), sizes.bending**2 * np.diag([1.0, omega**2])
    root = np.linalg.cholesky(stationary - Phi @ stationary @ Phi.T + 1e-30 * np.eye(2))
    state = np.empty((len(grid), 2, runs, 3))
    state[0] = np.sqrt(np.diag(stationary))[:, None, None] * rng.standard_normal((2, runs, 3))
    for k in range(len(grid) - 1):
        state[k + 1] = np.einsum("ij,j...->i...", Phi, state[k]) + np.einsum(
            "ij,j...->i...", root, rng.standard_normal((2, runs, 3))
        )
    spline = CubicHermiteSpline(grid, state[:, 0], state[:, 1])
    slope = spline.derivative()

    def own(curve: Any, t: Any) -> Array:
        """Each run at its own time (runs,)."""
        t = np.asarray(t)
        return curve(t) if t.ndim == 0 else np.stack([curve(one)[r] for r, one in enumerate(t)])

    return Truth(gyro, accel, Q, numbers, drift, lambda t: own(spline, t), lambda t: own(slope, t))
