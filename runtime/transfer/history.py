"""The slave's last samples, at any time between them."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from boresight.runtime.array import Array
from boresight.runtime.filter import Filter

PHI, DV, GYRO_BIAS, ACCEL_BIAS = (slice(k, k + 3) for k in range(0, 12, 3))  # of the error state
TAU = 15
SIZES = {"v_n": 3, "q_b2n_wxyz": 4, "angle": 3, "push": 3}  # angle, push: sums of the increments as delivered


class History:
    """The slave's samples: time (K,) s; v_n, q_b2n_wxyz, angle and push (K, R, size), R runs, oldest first."""

    def __init__(self, time: Array, **values: Array):
        self.time, self.runs = time, values["v_n"].shape[1]
        self.values = values

    def at(self, name: str, times: Array) -> Array:
        """(..., R, size) at times (..., R), on the chord between two samples, extended beyond the first and last."""
        i = self.time[1:-1].searchsorted(times, "right")
        before = self.time.take(i)
        part = ((times - before) / (self.time.take(i + 1) - before))[..., None]
        flat = self.values[name].reshape(-1, SIZES[name])
        i = i * self.runs + np.arange(self.runs)
        low, high = flat.take(i, axis=0), flat.take(i + self.runs, axis=0)
        if name == "q_b2n_wxyz":
            high = np.where(np.sum(low * high, axis=-1, keepdims=True) < 0, -high, high)
        value = low + part * (high - low)
        if name == "q_b2n_wxyz":  # 1 rad/s for 10 ms: the chord leaves the arc by 1e-8 rad
            value /= np.linalg.norm(value, axis=-1, keepdims=True)
        return value

    def mean(self, name: str, begin: Array, end: Array) -> Array:
        """(..., R, 3) mean of the rate behind `angle` or `push` between two times (..., R); biases in it."""
        first, last = self.at(name, np.array([begin, end]))
        rate: Array = (last - first) / (end - begin)[..., None]
        return rate


def moment(
    loop: Filter, history: History, at: Array, half_span_s: float, constants: Mapping[str, Any]
) -> tuple[dict[str, Any], Array]:
    """The slave at times (..., R), and its rates; and their variance over the gyros' density.

    A rate is the mean over a span about its time.  Where the span would reach beyond the newest sample it ends there,
    and the rate is extended along its change over the two last spans.
    """
    h, runs = half_span_s, loop.P.shape[:-2]
    centre = np.minimum(at, history.time[-1] - h)
    times = np.stack([at, centre + h, centre - h, centre - 3 * h])

    def rate(times: Array) -> Array:
        middle = np.minimum(times, history.time[-1] - h)
        sums = history.at("angle", np.stack([middle + h, middle - h, middle - 3 * h]))
        last, earlier = (sums[:2] - sums[1:]) / (2 * h)
        extended = last + ((times - middle) / (2 * h))[..., None] * (last - earlier)
        return extended.reshape((*times.shape[:-1], *runs, 3)) - loop.nav["gyro_bias"]

    state = {name: history.at(name, times) for name in ("v_n", "q_b2n_wxyz")}
    shape = (*at.shape[:-1], *runs)
    state = {name: value.reshape((4, *shape, value.shape[-1])) for name, value in state.items()}
    state["omega_ib_b"] = rate(times)
    _, v1, v2, v3 = loop.call("expected", **constants, **state)["v_m_n"]
    beyond = ((at - centre) / (2 * h)).reshape(shape)
    a_n = (v1 - v2) / (2 * h) + beyond[..., None] * (v1 - 2 * v2 + v3) / (2 * h)
    inputs: dict[str, Any] = {name: value[0] for name, value in state.items()}
    return {**inputs, "a_n": a_n}, ((1 + beyond) ** 2 + beyond**2) / (2 * h)
