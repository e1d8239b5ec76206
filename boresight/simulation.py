"""Truth and sensors that are simulated: `drive`, `hull`, `inertial`, `sea` and `sensors`.

from boresight.simulation import sensors
"""

from boresight.runtime.simulation import drive, hull, inertial, sea, sensors

__all__ = ["drive", "hull", "inertial", "sea", "sensors"]
