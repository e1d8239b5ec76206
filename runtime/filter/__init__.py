"""A Kalman filter over a model's functions: in NumPy, in the generated C for many runs, an epoch of it in one call."""

from boresight.runtime.filter.compiled import CompiledFilter
from boresight.runtime.filter.epoch import Epoch
from boresight.runtime.filter.filter import Filter, Innovation, check_covariance

__all__ = ["CompiledFilter", "Epoch", "Filter", "Innovation", "check_covariance"]
