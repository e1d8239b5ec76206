"""Places, axes and gravity on the WGS-84 ellipsoid in many digits, and their changes by differences: for witnesses.

The constants stand here a second time, as NGA.STND.0036 prints them, and gravity is Somigliana's formula in its own
form of both semi-axes: a witness takes nothing from the functions that it judges.
"""

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb

from boresight.derive.ledger.numbers import Matrix, atan, cos, exact, sin, sqrt, tan, zeros
from boresight.derive.ledger.witness import skew, vector

WORKING = 120  # digits for differentiating: metres of an Earth's radius leave 28 exact ones

SEMI_MAJOR = exact(6378137)  # m
FLATTENING = 1 / exact("298.257223563")
SPIN = exact("7.292115e-5")  # rad/s
MASS = exact("3.986004418e14")  # m^3/s^2, times the gravitational constant
AT_EQUATOR, AT_POLE = exact("9.7803253359"), exact("9.8321849379")  # m/s^2, gravity on the ellipsoid
SEMI_MINOR = SEMI_MAJOR * (1 - FLATTENING)


def axes(position) -> Matrix:
    """3x3 at (longitude, latitude, height), rad and m: columns east, north and up in Earth's axes."""
    lon, lat, _ = position
    cos_lon, sin_lon, cos_lat = cos(lon), sin(lon), cos(lat)
    up = vector(cos_lat * cos_lon, cos_lat * sin_lon, sin(lat))
    east = vector(-sin_lon, cos_lon, 0)
    north = skew(up) * east
    return Matrix([[east[i], north[i], up[i]] for i in range(3)])


def point(position) -> Matrix:
    """Cartesian coordinates: the point of the ellipse whose normal has the latitude, and the height along it."""
    lon, lat, height = position
    flat = 1 - FLATTENING
    reduced = atan(flat * tan(lat))
    radius = SEMI_MAJOR * cos(reduced) + height * cos(lat)
    return vector(radius * cos(lon), radius * sin(lon), SEMI_MINOR * sin(reduced) + height * sin(lat))


def gravity(lat, height) -> arb:
    """Normal gravity (m/s^2), by Somigliana on the ellipsoid and to the second power of the height above it."""
    a, b = SEMI_MAJOR, SEMI_MINOR
    c2, s2 = cos(lat) ** 2, sin(lat) ** 2
    ground = (a * AT_EQUATOR * c2 + b * AT_POLE * s2) / sqrt(a**2 * c2 + b**2 * s2)
    centrifugal = SPIN**2 * a**2 * b / MASS
    return ground * (1 - 2 / a * (1 + FLATTENING + centrifugal - 2 * FLATTENING * s2) * height + 3 / a**2 * height**2)


def slope(position) -> Matrix:
    """d(point) / d(longitude, latitude, height)."""
    return jacobian(lambda change: point(position + change), 3)


@dataclass(frozen=True)
class Level:
    """A local level: its axes among east, north and up, as (which, sign), and the order of its coordinates among
    longitude, latitude and height."""

    name: str
    along: tuple[tuple[int, int], ...]
    order: tuple[int, int, int]

    def geographic(self, position) -> Matrix:
        """Longitude, latitude, height."""
        return vector(*(position[self.order.index(i)] for i in range(3)))

    def components(self, east_north_up) -> Matrix:
        return vector(*(sign * east_north_up[which] for which, sign in self.along))

    def axes(self, position) -> Matrix:
        """3x3: its axes as columns, in Earth's."""
        columns = axes(self.geographic(position))
        return Matrix([[sign * columns[i, which] for which, sign in self.along] for i in range(3)])

    def slope(self, position) -> Matrix:
        """d(point) / d(position)."""
        columns = slope(self.geographic(position))
        return Matrix([[columns[i, which] for which in self.order] for i in range(3)])

    def gravity(self, position) -> Matrix:
        _, lat, height = self.geographic(position)
        return self.components((0, 0, -gravity(lat, height)))


ENU: Level = Level("ENU", ((0, 1), (1, 1), (2, 1)), (0, 1, 2))
NED: Level = Level("NED", ((1, 1), (0, 1), (2, -1)), (1, 0, 2))
LEVELS = {level.name: level for level in (ENU, NED)}


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
