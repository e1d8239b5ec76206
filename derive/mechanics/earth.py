"""The rotating Earth as SymPy expressions, on the WGS-84 ellipsoid.

A local level is given by a Frame: where north, east and up lie among its axes.  Every vector below is built from those
three, so that one derivation serves NED and ENU.  Angles in rad, lengths in m.
"""

from dataclasses import dataclass
from typing import Any

from sympy import ImmutableMatrix, Matrix, cos, sin, sqrt, tan

from boresight.derive.constant import constant
from boresight.derive.named import named

# NGA.STND.0036: defining constants of WGS 84, and what follows from them.
SEMI_MAJOR_AXIS = constant("a", 6378137, "m", "semi-major axis, WGS 84")
FLATTENING = constant("f_ell", "1/298.257223563", "1", "flattening, WGS 84")
ECCENTRICITY_SQUARED = constant("e2", FLATTENING * (2 - FLATTENING), "1", "square of the first eccentricity")
EARTH_RATE = constant("omega_ie", "7.292115e-5", "rad/s", "the Earth's rate, WGS 84")
GRAVITATIONAL_CONSTANT = constant("GM", "3.986004418e14", "m^3/s^2",
                                  "the Earth's gravitational constant, its atmosphere included")  # fmt: skip
GRAVITY_EQUATOR = constant("g_e", "9.7803253359", "m/s^2", "normal gravity at the equator")
GRAVITY_POLE = constant("g_p", "9.8321849379", "m/s^2", "normal gravity at the pole")
SOMIGLIANA = constant("k", (1 - FLATTENING) * GRAVITY_POLE / GRAVITY_EQUATOR - 1, "1", "k of Somigliana's formula")
CENTRIFUGAL_RATIO = constant("m", EARTH_RATE**2 * SEMI_MAJOR_AXIS**3 * (1 - FLATTENING) / GRAVITATIONAL_CONSTANT, "1",
                             "centrifugal over gravitational acceleration, at the equator")  # fmt: skip


@dataclass(frozen=True)
class Frame:
    """A local level: the components of north, east and up, (3) each, and the order of the geodetic coordinates.

    axes: suffixes of its components.  coordinates: latitude and longitude in the order of the axes that they run
    along, then height, positive upwards in both frames.  body: the body axes that go with it.
    """

    name: str
    axes: tuple[str, str, str]
    body: str
    north: ImmutableMatrix
    east: ImmutableMatrix
    up: ImmutableMatrix
    coordinates: tuple[str, str, str]

    def coordinate(self, name: str) -> ImmutableMatrix:
        """Unit column (3) of one of `lat`, `lon`, `height` among the coordinates."""
        return ImmutableMatrix([int(name == other) for other in self.coordinates])

    def position(self, lat, lon, height) -> Matrix:
        """The coordinates (3) in this frame's order: lat and lon in rad, height in m, or three of any one kind."""
        return Matrix([{"lat": lat, "lon": lon, "height": height}[name] for name in self.coordinates])

    def latitude_and_height(self, position) -> tuple[Any, Any]:
        """The two of the coordinates (3) on which radii and gravity depend (rad, m)."""
        return tuple(position[self.coordinates.index(name)] for name in ("lat", "height"))

    def named(self, name: str, value: Matrix, meaning: str) -> Matrix:
        """The vector (3) in this level under a name, its components by the axes: f_n_d."""
        made: Matrix = named(name, value, meaning, " ".join(self.axes))
        return made

    def vector(self, north, east, up) -> Matrix:
        """The vector (3) with these components along north, east and up."""
        return north * Matrix(self.north) + east * Matrix(self.east) + up * Matrix(self.up)


def _axis(*components: int) -> ImmutableMatrix:
    return ImmutableMatrix(components)


NED: Frame = Frame("NED", ("n", "e", "d"), "front-right-down", _axis(1, 0, 0), _axis(0, 1, 0), _axis(0, 0, -1),
                   ("lat", "lon", "height"))  # fmt: skip
ENU: Frame = Frame("ENU", ("e", "n", "u"), "right-front-up", _axis(0, 1, 0), _axis(1, 0, 0), _axis(0, 0, 1),
                   ("lon", "lat", "height"))  # fmt: skip
FRAMES = {frame.name: frame for frame in (NED, ENU)}


def flattened(lat):
    """w = sqrt(1 - e^2 sin^2) of the geodetic latitude (rad), by which radii and gravity differ from a sphere's."""
    return named("w", sqrt(1 - ECCENTRICITY_SQUARED * sin(lat) ** 2), "root of 1 - e^2 sin^2 of the latitude")


def radii(lat) -> tuple:
    """Meridian and transverse radius of curvature (m, m) of the ellipsoid at the geodetic latitude (rad)."""
    w = flattened(lat)
    return (
        named("R_N", SEMI_MAJOR_AXIS * (1 - ECCENTRICITY_SQUARED) / w**3, "meridian radius of curvature, m"),
        named("R_E", SEMI_MAJOR_AXIS / w, "transverse radius of curvature, m"),
    )


def radii_at(lat, height) -> tuple:
    """Both radii of curvature (m, m) plus the height (m), at the geodetic latitude (rad)."""
    meridian, transverse = radii(lat)
    return (
        named("R_N_h", meridian + height, "meridian radius of curvature plus the height, m"),
        named("R_E_h", transverse + height, "transverse radius of curvature plus the height, m"),
    )


def radii_by_latitude(lat) -> tuple:
    """How both radii change with the geodetic latitude (rad): (m/rad, m/rad)."""
    meridian, transverse = radii(lat)
    # d/dlat of w = sqrt(1 - e^2 sin^2) is -e^2 sin cos / w; the radii go with w^-3 and w^-1.
    growth = ECCENTRICITY_SQUARED * sin(lat) * cos(lat) / (1 - ECCENTRICITY_SQUARED * sin(lat) ** 2)
    return (
        named("R_N_lat", 3 * meridian * growth, "derivative of R_N by the latitude, m/rad"),
        named("R_E_lat", transverse * growth, "derivative of R_E by the latitude, m/rad"),
    )


def omega_ie_n(lat, frame: Frame = NED) -> Matrix:
    """The Earth's rate against inertial space in the level (3, rad/s), at the geodetic latitude (rad).

    Row: mechanics strapdown-1.
    """
    return frame.named("omega_ie_n", EARTH_RATE * frame.vector(cos(lat), 0, sin(lat)), "the Earth's rate, rad/s")


def omega_en_n(lat, height, v_n, frame: Frame = NED) -> Matrix:
    """Transport rate in the level (3, rad/s): how the level turns with the motion v_n (3, m/s) over the ellipsoid.

    lat: geodetic, rad.  height: m.  Singular at the poles, where north turns without end.
    Row: mechanics strapdown-1.
    """
    v_north, v_east = frame.north.dot(v_n), frame.east.dot(v_n)
    meridian, transverse = radii_at(lat, height)
    east = v_east / transverse
    return frame.named(
        "omega_en_n", frame.vector(east, -v_north / meridian, east * tan(lat)), "the transport rate, rad/s"
    )


def metres(lat, height, frame: Frame = NED) -> Matrix:
    """(3) lengths (m/rad, m/rad, 1): what one unit of each coordinate is over the ground, in the frame's order.

    lat: geodetic, rad.  height: m.  Zero at the poles for the longitude.
    """
    meridian, transverse = radii_at(lat, height)
    return frame.position(lat=meridian, lon=transverse * cos(lat), height=1)


def normal_gravity(lat, height):
    """Normal gravity (m/s^2) at the geodetic latitude (rad) and the height (m) above the ellipsoid.

    Somigliana's formula on the ellipsoid, to the second power of the height: NGA.STND.0036.  It errs by 4.7e-8 m/s^2 at
    1 km and by 4e-7 m/s^2 at 10 km.
    """
    s2 = sin(lat) ** 2
    a, f, m = SEMI_MAJOR_AXIS, FLATTENING, CENTRIFUGAL_RATIO
    with_height = 1 - 2 * (1 + f + m - 2 * f * s2) * height / a + 3 * height**2 / a**2
    return named("g", gravity_on_ellipsoid(lat) * with_height, "normal gravity, m/s^2")


def gravity_on_ellipsoid(lat):
    """Somigliana's formula: normal gravity (m/s^2) on the ellipsoid at the geodetic latitude (rad)."""
    s2 = sin(lat) ** 2
    value = (GRAVITY_EQUATOR + GRAVITY_EQUATOR * SOMIGLIANA * s2) / flattened(lat)
    return named("g_0", value, "normal gravity on the ellipsoid, m/s^2")


def gravity_gradient(lat, height) -> tuple:
    """How normal gravity at lat (rad) and height (m) changes with either: (m/s^2 per rad, 1/s^2)."""
    s2, s_c = sin(lat) ** 2, sin(lat) * cos(lat)
    a, f, m, e2, k = SEMI_MAJOR_AXIS, FLATTENING, CENTRIFUGAL_RATIO, ECCENTRICITY_SQUARED, SOMIGLIANA
    w2 = 1 - e2 * s2
    on_ellipsoid = gravity_on_ellipsoid(lat)
    on_ellipsoid_by_lat = GRAVITY_EQUATOR * s_c / flattened(lat) * (2 * k + (e2 + e2 * k * s2) / w2)
    factor = 1 - 2 * (1 + f + m - 2 * f * s2) * height / a + 3 * height**2 / a**2
    factor_by_lat = 8 * f * s_c * height / a
    factor_by_height = -2 * (1 + f + m - 2 * f * s2) / a + 6 * height / a**2
    return (
        named("g_lat", on_ellipsoid_by_lat * factor + on_ellipsoid * factor_by_lat, "derivative of g by the latitude"),
        named("g_height", on_ellipsoid * factor_by_height, "derivative of g by the height, 1/s^2"),
    )


def gravity_n(lat, height, frame: Frame = NED) -> Matrix:
    """Gravity in the level (3, m/s^2): normal gravity, straight down; lat in rad, height in m.

    At a height h (m) it leans to the equator by 8e-9 h sin(2 lat) m/s^2, which is left out.
    Row: mechanics strapdown-1.
    """
    return frame.vector(0, 0, -normal_gravity(lat, height))
