"""The Earth against pymap3d, geographiclib, pyins and the closed form of normal gravity."""

import mpmath as mp
import numpy as np
import pytest
from mechanics import POSITION, V_N, differentiable, numbers, states
from sympy import Matrix, symbols

from boresight.derive.mechanics import earth, mechanization
from boresight.derive.mechanics import rotation as rot
from boresight.derive.mechanics.earth import ENU, NED

LAT, HEIGHT = Matrix(symbols("lat height", real=True))
LATITUDES = np.linspace(-1.48, 1.48, 41)
FRAMES = pytest.mark.parametrize("frame", [NED, ENU], ids=lambda frame: frame.name)


def of_latitude(*expressions):
    return numbers(Matrix(expressions), [LAT], [HEIGHT])


def test_radii_are_those_of_pymap3d():
    from pymap3d import rcurve

    ours = of_latitude(*earth.radii(LAT))
    for lat in LATITUDES:
        meridian, transverse = ours([lat], [0.0])[:, 0]
        assert abs(meridian - rcurve.meridian(lat, deg=False)) < 1e-8
        assert abs(transverse - rcurve.transverse(lat, deg=False)) < 1e-8


def test_radii_measure_the_geodesics_of_geographiclib():
    from geographiclib.geodesic import Geodesic

    ours, step = of_latitude(*earth.radii(LAT)), 1e-3  # deg: short enough for a chord, long for 15 digits
    for lat in LATITUDES:
        degrees = np.degrees(lat)
        north = Geodesic.WGS84.Inverse(degrees - step / 2, 0, degrees + step / 2, 0)["s12"]
        east = Geodesic.WGS84.Inverse(degrees, 0, degrees, step)["s12"]
        meridian, transverse = ours([lat], [0.0])[:, 0]
        assert abs(north / np.radians(step) / meridian - 1) < 1e-9
        assert abs(east / np.radians(step) / (transverse * np.cos(lat)) - 1) < 1e-9


def test_what_is_differentiated_by_hand_is_the_automatic_derivative():
    import casadi as ca

    (radii, gravity), (lat, height) = differentiable(
        [Matrix(earth.radii(LAT)), Matrix([earth.normal_gravity(LAT, HEIGHT)])], [LAT], [HEIGHT]
    )
    exact = ca.Function("d", [lat, height], [ca.jacobian(radii, lat), ca.jacobian(gravity, ca.vertcat(lat, height))])
    ours = of_latitude(*earth.radii_by_latitude(LAT), *earth.gravity_gradient(LAT, HEIGHT))
    for at in LATITUDES:
        by_lat, gradient = (np.array(part).ravel() for part in exact(at, 4321.0))
        np.testing.assert_allclose(ours([at], [4321.0])[:, 0], [*by_lat, *gradient], rtol=1e-12, atol=1e-18)


def test_gravity_is_the_closed_form_of_the_level_ellipsoid():
    """Pizzetti and Somigliana: equator and pole from GM, a, f and the rotation, in 40 digits."""
    with mp.workdps(40):
        a, f = mp.mpf(int(earth.SEMI_MAJOR_AXIS)), 1 / mp.mpf("298.257223563")
        GM, rate = mp.mpf("3.986004418e14"), mp.mpf("7.292115e-5")
        b = a * (1 - f)
        e2 = mp.sqrt(a**2 - b**2) / b  # second eccentricity
        m = rate**2 * a**2 * b / GM
        q0 = ((1 + 3 / e2**2) * mp.atan(e2) - 3 / e2) / 2
        q1 = 3 * (1 + 1 / e2**2) * (1 - mp.atan(e2) / e2) - 1
        equator = GM / (a * b) * (1 - m - m * e2 * q1 / (6 * q0))
        pole = GM / a**2 * (1 + m * e2 * q1 / (3 * q0))
    ours = of_latitude(earth.normal_gravity(LAT, HEIGHT))
    assert abs(ours([0.0], [0.0])[0, 0] - equator) < 1e-10
    assert abs(ours([np.pi / 2], [0.0])[0, 0] - pole) < 1e-10


def test_gravity_is_that_of_pyins_on_the_ellipsoid_and_above_it_to_what_is_linear_in_height():
    from pyins import earth as other

    ours = of_latitude(earth.normal_gravity(LAT, HEIGHT))
    for lat in LATITUDES:
        degrees = np.degrees(lat)
        assert abs(ours([lat], [0.0])[0, 0] - other.gravity(degrees, 0.0)) < 1e-9
        # pyins leaves 2 (f + m - 2 f sin^2) h / a out, up to 1.4 % of what height takes
        lost = other.gravity(degrees, 0.0) - other.gravity(degrees, 1000.0)
        assert abs(ours([lat], [1000.0])[0, 0] - other.gravity(degrees, 1000.0)) < 0.0141 * lost


def test_the_level_turns_as_that_of_pyins():
    from pyins import earth as other

    ours = numbers(Matrix.vstack(earth.omega_ie_n(POSITION[0]), earth.omega_en_n(POSITION[0], POSITION[2], V_N)),
                   POSITION, V_N)  # fmt: skip
    for p, v, _ in states(NED, 20):
        omega_ie, omega_en = ours(p, v)[:3, 0], ours(p, v)[3:, 0]
        np.testing.assert_allclose(omega_ie, other.rate_n(np.degrees(p[0])), rtol=0, atol=1e-18)
        np.testing.assert_allclose(omega_en, other.curvature_matrix(np.degrees(p[0]), p[2]) @ v, rtol=0, atol=1e-16)


@FRAMES
def test_the_exact_rates_keep_the_place_in_earth_fixed_axes(frame):
    """By pymap3d: the place that the rates lead to has the velocity that was integrated; v' is not used."""
    from pymap3d import enu2uvw, geodetic2ecef

    rate = numbers(mechanization.position_rate(frame, POSITION, V_N), POSITION, V_N)
    for p, v, _ in states(frame, 10):
        step = 1e-2

        def ecef(q, frame=frame):
            lat, lon, height = (q[frame.coordinates.index(name)] for name in ("lat", "lon", "height"))
            return np.array(geodetic2ecef(lat, lon, height, deg=False))

        moved = rate(p, v)[:, 0]
        velocity = (ecef(p + step * moved) - ecef(p - step * moved)) / (2 * step)
        east, north, up = (
            float(np.array(axis, dtype=float).ravel() @ v) for axis in (frame.east, frame.north, frame.up)
        )
        lat, lon = (p[frame.coordinates.index(name)] for name in ("lat", "lon"))
        np.testing.assert_allclose(velocity, enu2uvw(east, north, up, lat, lon, deg=False), atol=1e-6)


def test_ned_and_enu_are_one_mechanization():
    q = Matrix(symbols("q_:4", real=True))
    N = np.array([[0, 1, 0], [1, 0, 0], [0, 0, -1.0]])
    swap = np.abs(N)

    def rates(frame):
        C = rot.dcm_from_quaternion(q)
        f_b = Matrix([1, 2, -9])
        omega = Matrix([3, -1, 2]) / 10
        return numbers(
            Matrix.hstack(
                mechanization.position_rate(frame, POSITION, V_N),
                mechanization.velocity_rate(frame, POSITION, V_N, C * f_b),
                mechanization.dcm_rate(frame, POSITION, V_N, C, omega),
            ),
            POSITION, V_N, q,
        )  # fmt: skip

    ned, enu = rates(NED), rates(ENU)
    wxyz = np.array([0.5, 0.5, -0.1, np.sqrt(0.49)])
    # body axes are left as they are, so C_b2enu = N C_b2ned: the quaternion of N, a half turn about (1, 1, 0)
    half = np.array([0, np.sqrt(0.5), np.sqrt(0.5), 0])
    turned = np.array(rot.quaternion_product(half, wxyz), dtype=float).ravel()
    for p, v, _ in states(NED, 10):
        a, b = ned(p, v, wxyz), enu(swap @ p, N @ v, turned)
        np.testing.assert_allclose(b[:, 0], swap @ a[:, 0], rtol=1e-13)
        np.testing.assert_allclose(b[:, 1:], N @ a[:, 1:], rtol=1e-9, atol=1e-13)


@FRAMES
def test_the_quaternion_and_the_matrix_turn_alike(frame):
    q, omega = Matrix(symbols("q_:4", real=True)), Matrix(symbols("w_:3", real=True))
    C = rot.dcm_from_quaternion(q)
    rate = mechanization.quaternion_rate(frame, POSITION, V_N, q, omega)
    by_quaternion = sum((C.diff(q[i]) * rate[i] for i in range(4)), Matrix.zeros(3, 3))
    difference = numbers(
        by_quaternion - mechanization.dcm_rate(frame, POSITION, V_N, C, omega), POSITION, V_N, q, omega
    )
    for p, v, w in states(frame, 5):
        unit = np.array([0.1, -0.7, 0.5, 0.5])
        assert np.abs(difference(p, v, unit, w / 30)).max() < 1e-15


def test_frames_are_right_handed():
    for frame in (NED, ENU):
        assert Matrix(frame.east).cross(Matrix(frame.north)) == Matrix(frame.up)
