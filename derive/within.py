"""How a number is judged: what is no number is a failure."""

from math import isfinite


def within(off: float, limit: float) -> bool:
    """Whether a difference is a number, and no larger than the limit.  False of nan and of infinity.

    Every verdict of derive, codegen and evidence asks this, since `off > limit` is false of nan.
    """
    return isfinite(off) and off <= limit
