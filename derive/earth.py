"""The rotating Earth as SymPy expressions, on the WGS-84 ellipsoid."""

from sympy import Matrix, Rational, cos, sin, sqrt, tan

# NGA.STND.0036: defining constants of WGS 84, and what follows from them.
SEMI_MAJOR_AXIS = 6378137  # m
FLATTENING = 1 / Rational("298.257223563")
ECCENTRICITY_SQUARED = FLATTENING * (2 - FLATTENING)
EARTH_RATE = Rational("7.292115e-5")  # rad/s


def radii(lat) -> tuple:
    """Meridian and transverse radius of curvature (m) at the geodetic latitude (rad)."""
    w = sqrt(1 - ECCENTRICITY_SQUARED * sin(lat) ** 2)
    return SEMI_MAJOR_AXIS * (1 - ECCENTRICITY_SQUARED) / w**3, SEMI_MAJOR_AXIS / w


def omega_ie_n(lat) -> Matrix:
    """The Earth's rate (rad/s), NED."""
    return EARTH_RATE * Matrix([cos(lat), 0, -sin(lat)])


def omega_en_n(lat, height, v_n) -> Matrix:
    """Transport rate (rad/s), NED: how the local level turns with the motion v_n (m/s, NED) over the ellipsoid.

    height in m.  Singular at the poles, where north turns without end.
    """
    v_north, v_east, _ = v_n
    meridian, transverse = radii(lat)
    east = v_east / (transverse + height)
    return Matrix([east, -v_north / (meridian + height), -east * tan(lat)])
