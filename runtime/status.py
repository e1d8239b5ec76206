"""What a generated function returns: `bs_status` of include/boresight.h, whose names have the prefix BS_."""

from enum import IntEnum


class Status(IntEnum):
    OK = 0  # the outputs are written
    NULL_POINTER = 1  # an argument is a null pointer; nothing is written
    NOT_FINITE = 2  # an input, or what it gives, is NaN or infinite; nothing is written
    OUT_OF_RANGE = 3  # an input, or the result, lies outside its box; nothing is written
    NOT_READY = 4  # too few samples so far; nothing is decided
    NOT_POSITIVE = 5  # a covariance is none, or a variance is not above zero
    AT_CEILING = 6  # as OK; a variance had reached its ceiling, and P was scaled down (D P D)
    CONTRACTED = 7  # the compiler changed the arithmetic, as bs_probe of boresight.h finds; nothing is written
