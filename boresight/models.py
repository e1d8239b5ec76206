"""The built-in models, each a function that makes it, and the parts that extend velocity-attitude.

    from boresight.models import scaled, velocity_attitude

`boresight models` lists them, and `boresight show NAME` prints one.  `wandering`, `scaled` and `bent` put states on a
velocity-attitude model: biases that are not constant, scale factors and axes, a hull that bends.
"""

from boresight.derive.models.azimuth_hold import azimuth_hold
from boresight.derive.models.azimuth_hold_reference import azimuth_hold_reference
from boresight.derive.models.euler_matching import euler_matching
from boresight.derive.models.phi_error import phi_error
from boresight.derive.models.psi_error import psi_error
from boresight.derive.models.strapdown import strapdown
from boresight.derive.models.velocity_attitude import velocity_attitude
from boresight.derive.models.velocity_attitude_lever import velocity_attitude_lever
from boresight.derive.models.velocity_attitude_sensors import bent, scaled, velocity_attitude_sensors, wandering
from boresight.derive.models.velocity_dcm import velocity_dcm

__all__ = [
    "azimuth_hold",
    "azimuth_hold_reference",
    "bent",
    "euler_matching",
    "phi_error",
    "psi_error",
    "scaled",
    "strapdown",
    "velocity_attitude",
    "velocity_attitude_lever",
    "velocity_attitude_sensors",
    "velocity_dcm",
    "wandering",
]
