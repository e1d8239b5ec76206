"""Recordings: inertial data of a slave and, if there is one, the navigation of its master.

`read` turns a file and its TOML description into a `Recording` in NED/FRD, SI and radians; `check` lists what is
suspicious in it.
"""

from boresight.runtime.recording.check import attitude_increments, check, gravity_in_ned
from boresight.runtime.recording.delay import best_delay
from boresight.runtime.recording.read import find, read
from boresight.runtime.recording.types import Finding, Inertial, Master, Recording, shifted, thinned

__all__ = [
    "Finding", "Inertial", "Master", "Recording", "attitude_increments", "best_delay", "check", "find",
    "gravity_in_ned", "read", "shifted", "thinned",
]  # fmt: skip
