"""Places and axes on the ellipsoid in many digits, and their changes, by differences: for the witnesses of a ledger."""

from collections.abc import Callable

import mpmath as mp
import sympy as sp

from boresight.derive import earth
from boresight.derive.witness import skew, vector

WORKING = 110  # digits for differentiating: metres of an Earth's radius leave 28 exact ones


def exact(number) -> mp.mpf:
    """A number of the Earth as it is defined, not as a float has it."""
    rational = sp.Rational(number)
    return mp.mpf(int(rational.p)) / int(rational.q)


def axes(position) -> mp.matrix:
    """3x3 at (longitude, latitude, height), rad and m: columns east, north and up in Earth's axes."""
    lon, lat, _ = position
    up = vector(mp.cos(lat) * mp.cos(lon), mp.cos(lat) * mp.sin(lon), mp.sin(lat))
    east = vector(-mp.sin(lon), mp.cos(lon), 0)
    north = skew(up) * east
    return mp.matrix([[east[i], north[i], up[i]] for i in range(3)])


def point(position) -> mp.matrix:
    """Cartesian coordinates: the point of the ellipse whose normal has the latitude, and the height along it."""
    lon, lat, height = position
    a, flat = exact(earth.SEMI_MAJOR_AXIS), 1 - exact(earth.FLATTENING)
    reduced = mp.atan(flat * mp.tan(lat))
    radius = a * mp.cos(reduced) + height * mp.cos(lat)
    return vector(radius * mp.cos(lon), radius * mp.sin(lon), a * flat * mp.sin(reduced) + height * mp.sin(lat))


def slope(position) -> mp.matrix:
    """d(point) / d(longitude, latitude, height)."""
    return jacobian(lambda change: point(position + change), 3)


def rate(function: Callable):
    """The derivative of a function of time at zero; 60 digits of WORKING."""
    step = mp.mpf(10) ** -30
    return (function(step) - function(-step)) / (2 * step)


def jacobian(function: Callable, count: int) -> mp.matrix:
    """The derivative at zero, one column for each of `count` arguments."""
    columns = []
    for i in range(count):
        unit = mp.zeros(count, 1)
        unit[i] = 1
        columns.append(rate(lambda t, unit=unit: function(t * unit)))
    return mp.matrix([[column[i] for column in columns] for i in range(columns[0].rows)])
