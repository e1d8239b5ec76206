"""Physical units, each by its factor to SI and radians."""

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array

DEG = np.pi / 180
ARCMIN = DEG / 60
MIL = 360 / 6400 * DEG
HOUR = 3600.0
DEG_H = DEG / HOUR
FOOT = 0.3048
STANDARD_GRAVITY = 9.80665  # m/s^2, by definition
MILLI_G = STANDARD_GRAVITY / 1000

# Units by quantity, each with its factor to SI and radians.
UNITS: dict[str, dict[str, float]] = {
    "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9},
    "angle": {"rad": 1.0, "mrad": 1e-3, "deg": DEG, "arcmin": ARCMIN, "arcsec": DEG / 3600, "mil": MIL},
    "angular rate": {"rad/s": 1.0, "deg/s": DEG, "deg/h": DEG_H},
    "acceleration": {"m/s^2": 1.0, "g": STANDARD_GRAVITY, "mg": MILLI_G, "ug": STANDARD_GRAVITY / 1e6},
    "velocity": {"m/s": 1.0, "cm/s": 0.01, "mm/s": 1e-3, "km/h": 1 / 3.6, "kn": 1852 / 3600, "g*s": STANDARD_GRAVITY},
    "length": {"m": 1.0, "cm": 0.01, "km": 1000.0, "ft": FOOT},
    "quaternion": {"1": 1.0},
    "matrix": {"1": 1.0},
    "scale factor": {"1": 1.0, "%": 0.01, "ppm": 1e-6},
    "frequency": {"Hz": 1.0},
    "temperature": {"degC": 1.0, "K": 1.0},  # differences alone matter
    # White noise as datasheets say it: a random walk of the integral, or a density of the rate.
    "gyro noise": {
        "rad/sqrt(s)": 1.0,
        "deg/sqrt(h)": DEG / 60,
        "deg/s/sqrt(Hz)": DEG,
        "mdps/sqrt(Hz)": DEG / 1000,
        "deg/h/sqrt(Hz)": DEG_H,
    },
    "accelerometer noise": {
        "m/s/sqrt(s)": 1.0,
        "m/s/sqrt(h)": 1 / 60,
        "m/s^2/sqrt(Hz)": 1.0,
        "mg/sqrt(Hz)": MILLI_G,
        "ug/sqrt(Hz)": STANDARD_GRAVITY / 1e6,
    },
    "gyro bias walk": {"rad/s/sqrt(s)": 1.0, "deg/h/sqrt(s)": DEG_H, "deg/h/sqrt(h)": DEG_H / 60},
    "accelerometer bias walk": {
        "m/s^2/sqrt(s)": 1.0,
        "ug/sqrt(s)": STANDARD_GRAVITY / 1e6,
        "mg/sqrt(h)": MILLI_G / 60,
        "ug/sqrt(h)": STANDARD_GRAVITY / 6e7,
    },
    "delay noise": {"s/sqrt(s)": 1.0, "ms/sqrt(s)": 1e-3, "ms/sqrt(h)": 1e-3 / 60},
}


def quantity(text: str, kind: str, count: int = 1) -> Array:
    """(count,) in SI and radians from numbers with a unit, as "0.15 deg/sqrt(h)" or "0.002, 0.004 m/s".

    kind: of UNITS.  One number serves for all.  Raises BoresightError that lists the units.
    """
    numbers, _, unit = text.strip().rpartition(" ")
    if unit not in UNITS[kind] or not numbers:
        raise BoresightError(f"{text!r}: give {kind} as numbers and one of the units {', '.join(UNITS[kind])}")
    try:
        values = np.array([float(part) for part in numbers.split(",")])
    except ValueError:
        raise BoresightError(f"{text!r}: {numbers!r} is not a number, or numbers with commas between") from None
    if len(values) not in (1, count) or not np.isfinite(values).all():
        wanted = f"one number or {count}" if count > 1 else "one number"
        raise BoresightError(f"{text!r}: {wanted} must be given, finite")
    return np.resize(values, count) * UNITS[kind][unit]
