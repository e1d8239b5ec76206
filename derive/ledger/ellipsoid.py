"""Places and axes on the ellipsoid in many digits, and their changes, by differences: for the witnesses of a ledger."""

from collections.abc import Callable

import sympy as sp
from flint import fmpq

from boresight.derive.ledger.numbers import Matrix, atan, cos, exact, sin, tan, zeros
from boresight.derive.ledger.witness import skew, vector
from boresight.derive.mechanics import earth

WORKING = 120  # digits for differentiating: metres of an Earth's radius leave 28 exact ones


def defined(constant) -> fmpq:
    """A constant of the Earth as it is defined, not as a float has it."""
    rational = sp.Rational(constant)
    return fmpq(int(rational.p), int(rational.q))


def axes(position) -> Matrix:
    """3x3 at (longitude, latitude, height), rad and m: columns east, north and up in Earth's axes."""
    lon, lat, _ = position
    up = vector(cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat))
    east = vector(-sin(lon), cos(lon), 0)
    north = skew(up) * east
    return Matrix([[east[i], north[i], up[i]] for i in range(3)])


def point(position) -> Matrix:
    """Cartesian coordinates: the point of the ellipse whose normal has the latitude, and the height along it."""
    lon, lat, height = position
    a, flat = defined(earth.SEMI_MAJOR_AXIS), 1 - defined(earth.FLATTENING)
    reduced = atan(flat * tan(lat))
    radius = a * cos(reduced) + height * cos(lat)
    return vector(radius * cos(lon), radius * sin(lon), a * flat * sin(reduced) + height * sin(lat))


def slope(position) -> Matrix:
    """d(point) / d(longitude, latitude, height)."""
    return jacobian(lambda change: point(position + change), 3)


def rate(function: Callable):
    """The derivative of a function of time at zero; 60 digits of WORKING."""
    step = exact("1e-30")
    return (function(step) - function(-step)) / (2 * step)


def jacobian(function: Callable, count: int) -> Matrix:
    """The derivative at zero, one column for each of `count` arguments."""
    columns = []
    for i in range(count):
        unit = zeros(count, 1)
        unit[i, 0] = 1
        columns.append(rate(lambda t, unit=unit: function(t * unit)))
    return Matrix([list(row) for row in zip(*columns, strict=True)])
