"""An experiment as C: flown one run after the other on a host, and each in its thread on a GPU, with the same bits."""

from boresight.errors import EXTRAS

EXTRAS["gpu"] = ("cuda", "nvidia")  # here, so that the evidence of what flies on a host does not hang on it
