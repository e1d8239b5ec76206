"""The master's delay: which messages inform it."""

from typing import Any

import numpy as np

from boresight.runtime.array import Array
from boresight.runtime.filter import Filter
from boresight.runtime.transfer.history import DV, TAU, History
from boresight.runtime.transfer.rules import Rules

GYRO_BIAS = slice(6, 9)  # of the error state
STRETCH_S = 0.5  # of the slave's past, in which the noise of its rates is seen


def scatter(history: History, name: str, now: float, span_s: float) -> Array:
    """(R,) variance by axis of the noise of means over `span_s` of the rate behind `angle` or `push`: what is seen.

    Third differences of neighbouring means take a motion of up to 2 Hz out (span 40 ms) and leave white noise and
    vibration, with 20 times their variance.
    """
    count = int(min(now - history.time[0], STRETCH_S) / span_s + 1e-6)
    if count < 4:
        return np.zeros(history.runs)
    times = now - span_s * np.arange(count + 1)[:, None]
    rate = np.diff(history.at(name, np.broadcast_to(times, (count + 1, history.runs))), axis=0) / span_s
    variance: Array = np.square(np.diff(rate, 3, axis=0)).mean((0, 2)) / 20
    return variance


def rate_variances(
    loop: Filter, history: History, rules: Rules, now: float, P: Array, F: Array, inputs: dict[str, Any], factor: Array
) -> dict[str, Array]:
    """Variances by axis (..., 3) of omega_ib_b and a_n as `inputs` has them: noise, and what P says of their biases.

    P, F: at the message's time.  factor: variance of such a rate over the gyros' density squared.
    """
    runs, span = P.shape[:-2], 2 * rules.half_span_s
    gyro, accel = (
        np.maximum(np.max(np.square(inputs[density]), axis=-1), span * scatter(history, name, now, span).reshape(runs))
        for density, name in (("gyro_noise", "angle"), ("accel_noise", "push"))
    )
    lever = np.sum(np.square(inputs["lever_b"] if "lever_b" in inputs else loop.nav["lever_b"]), axis=-1)
    # the lever arm's part of the acceleration is a difference of two rates
    white = accel * factor + lever * gyro * 2 * factor / span**2
    error = np.einsum("...ij,...jk,...ik->...i", F[..., DV, :], P, F[..., DV, :])
    return {
        "omega_ib_b": (gyro * factor)[..., None] + np.einsum("...ii->...i", P[..., GYRO_BIAS, GYRO_BIAS]),
        "a_n": white[..., None] + error,
    }


def uninformed(
    loop: Filter, measurement: str, R: Array, rows: Array, inputs: dict[str, Any], variances: dict[str, Array],
    sigmas: float,
) -> Array:  # fmt: skip
    """(..., n) bool: the delay, where the rates that make up its column are not clearly above their noise.

    R, rows: (..., m).  variances: of `rate_variances`.

    The noise of such a rate passes for a motion that the residual does not follow: for a delay without error, and so
    for knowledge of it.  What it adds is its variance over R, what the motion adds the rate's square over R; over all
    rows that has to be sigmas^2 times as much.  Noise alone gets there once in 1e10 messages, so that the choice of
    messages does not depend on it.
    """

    # attitude turns with the rate, velocity with the acceleration; the column is linear in them
    name = "a_n" if measurement == "velocity" else "omega_ib_b"
    steps = 1e-3 * np.concatenate([np.zeros((1, 3)), np.eye(3)]).reshape((4, *(1 for _ in loop.P.shape[:-2]), 3))
    columns = loop.call(f"{measurement}_H", **{**inputs, name: inputs[name] + steps})[..., TAU]
    now, by_axis = columns[0], (columns[1:] - columns[0]) / 1e-3
    variance = np.einsum("a...m,...a->...m", by_axis**2, variances[name])
    weight = rows / R
    out = np.zeros((*now.shape[:-1], loop.P.shape[-1]), bool)
    out[..., TAU] = np.sum(weight * now**2, axis=-1) <= sigmas**2 * np.sum(weight * variance, axis=-1)
    return out
