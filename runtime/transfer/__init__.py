"""Transfer alignment: how a slave begins from its master's first message, and what its sensors are.

`first` makes nav and P for a filter or for `Live.begin`; `sensors` makes of sizes what the model with states for scale
factors, axes, instability and bending carries; `score` says whether a filter's innovations show what it does not.
Units SI and rad, NED and front-right-down.
"""

from boresight.runtime.transfer import score, sensors
from boresight.runtime.transfer.start import Increments, Message, first

__all__ = ["Increments", "Message", "first", "score", "sensors"]
