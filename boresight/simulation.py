"""Truth and sensors that are simulated: `drive`, `hull`, `inertial`, `motions`, `sea` and `sensors`.

from boresight.simulation import sensors
"""

from boresight.runtime.simulation import drive, hull, inertial, motions, sea, sensors

__all__ = ["drive", "hull", "inertial", "motions", "sea", "sensors"]
