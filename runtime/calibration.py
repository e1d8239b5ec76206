"""What is known of an inertial sensor beforehand, taken off what it delivers."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array


@dataclass(frozen=True)
class Calibration:
    """true = matrix @ (delivered - bias).

    Biases (..., 3) rad/s and m/s^2; matrices (..., 3, 3), from delivered to true axes, scale factors in them.
    """

    gyro_bias: Any = (0.0, 0.0, 0.0)
    accel_bias: Any = (0.0, 0.0, 0.0)
    gyro_matrix: Any = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    accel_matrix: Any = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    known: bool = field(init=False)  # whether anything is

    def __post_init__(self) -> None:
        for name, shape in (("bias", (3,)), ("matrix", (3, 3))):
            for sensor in ("gyro", "accel"):
                value = np.asarray(getattr(self, f"{sensor}_{name}"), float)
                if value.shape[-len(shape) :] != shape or not np.isfinite(value).all():
                    raise BoresightError(
                        f"calibration: {sensor}_{name} has shape {value.shape}; it must be {shape} of finite numbers"
                    )
                if name == "matrix" and not (np.abs(np.linalg.det(value)) > 0.1).all():
                    raise BoresightError(
                        f"calibration: {sensor}_matrix makes one axis of two; it must be near the unit matrix"
                    )
                object.__setattr__(self, f"{sensor}_{name}", value)
        biased = np.any(self.gyro_bias) or np.any(self.accel_bias)
        turned = (self.gyro_matrix != np.eye(3)).any() or (self.accel_matrix != np.eye(3)).any()
        object.__setattr__(self, "known", bool(biased or turned))

    def increments(self, dtheta: Any, dv: Any, dt: Any) -> tuple[Array, Array]:
        """The same increments (..., 3) rad and m/s over dt (...) s without what is known; of rates with dt = 1."""
        if not self.known:
            return np.asarray(dtheta, float), np.asarray(dv, float)
        seconds = np.asarray(dt, float)[..., None]
        return (
            np.einsum("...ij,...j->...i", self.gyro_matrix, dtheta - self.gyro_bias * seconds),
            np.einsum("...ij,...j->...i", self.accel_matrix, dv - self.accel_bias * seconds),
        )
