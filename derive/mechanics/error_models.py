"""How small errors of position, velocity and attitude grow: the phi and the psi model, and the map between them.

Error = computed - true, both to first order in the errors and to nothing else: no term is dropped.

phi: C_hat_b2n = (I - [phi x]) C_b2n against the true level n.  Velocity error dv = v_hat - v, component by component.
psi: the computed level c stands where the computed position is, turned from n by dtheta: C_n2c = I - [dtheta x].
    Attitude error against c, psi = phi - dtheta; velocity error against the true velocity carried into c,
    dv_c = v_hat - C_n2c v = dv + dtheta x v.
The position error is the same in both: of the geodetic coordinates, in the frame's order.

Inputs as in mechanization.py: position (3; rad, rad, m in the frame's order), v_n (3, m/s) and f_n (3, m/s^2) in the
level.  Blocks are 3x3; those by position have columns per rad, rad and m.  Everything here is singular at the poles.
"""

from sympy import Matrix, cos, diag, eye, sin, tan, zeros

from boresight.derive.mechanics.earth import (
    EARTH_RATE,
    Frame,
    gravity_gradient,
    gravity_n,
    metres,
    omega_en_n,
    radii_at,
    radii_by_latitude,
)
from boresight.derive.mechanics.mechanization import along, omega_in_n, position_rate, turning_n
from boresight.derive.mechanics.rotation import skew
from boresight.derive.named import named

# ---------------------------------------------------------------- perturbations of what the mechanization is made of


def by_coordinate(frame: Frame, lat: Matrix, height: Matrix) -> Matrix:
    """3x3 of the columns (3) by latitude (per rad) and by height (per m), in the order of the coordinates."""
    return lat * frame.coordinate("lat").T + height * frame.coordinate("height").T


def omega_ie_by_position(frame: Frame, position) -> Matrix:
    """d omega_ie_n / d position, 3x3 (rad/s per rad or m): the Earth's axis leans as the latitude changes."""
    lat, _ = frame.latitude_and_height(position)
    return by_coordinate(frame, EARTH_RATE * frame.vector(-sin(lat), 0, cos(lat)), zeros(3, 1))


def omega_en_by_position(frame: Frame, position, v_n) -> Matrix:
    """d omega_en_n / d position, 3x3 (rad/s per rad or m): the radii grow with height and change with latitude, and
    meridians converge."""
    lat, height = frame.latitude_and_height(position)
    v_north, v_east = frame.north.dot(v_n), frame.east.dot(v_n)
    meridian, transverse = radii_at(lat, height)
    meridian_by_lat, transverse_by_lat = radii_by_latitude(lat)
    north, east = v_north / meridian, v_east / transverse

    def shrunk(by_meridian, by_transverse):
        """omega_en_n with each rate lessened in the proportion in which its radius grows."""
        less_north = north * by_meridian / meridian
        less_east = east * by_transverse / transverse
        return frame.vector(-less_east, less_north, -less_east * tan(lat))

    by_lat = shrunk(meridian_by_lat, transverse_by_lat) + frame.vector(0, 0, east / cos(lat) ** 2)
    made: Matrix = named(
        "omega_en_p", by_coordinate(frame, by_lat, shrunk(1, 1)), "derivative of omega_en_n by the position"
    )
    return made


def omega_en_by_velocity(frame: Frame, position) -> Matrix:
    """d omega_en_n / d v_n, 3x3 (1/m): the curvature of the ellipsoid."""
    lat, height = frame.latitude_and_height(position)
    meridian, transverse = radii_at(lat, height)
    eastwards = frame.vector(1, 0, tan(lat)) / transverse
    northwards = -frame.vector(0, 1, 0) / meridian
    slopes = eastwards * frame.east.T + northwards * frame.north.T
    made: Matrix = named("omega_en_v", slopes, "derivative of omega_en_n by v_n, rad/m")
    return made


def gravity_by_position(frame: Frame, position) -> Matrix:
    """d gravity_n / d position, 3x3 (m/s^2 per rad or m): stronger towards the poles, weaker with height."""
    by_lat, by_height = gravity_gradient(*frame.latitude_and_height(position))
    return by_coordinate(frame, frame.vector(0, 0, -by_lat), frame.vector(0, 0, -by_height))


def position_rate_by_velocity(frame: Frame, position) -> Matrix:
    """d position' / d v_n, 3x3 (rad/m, rad/m, 1 by row): one over the length of each coordinate's unit."""
    lengths = metres(*frame.latitude_and_height(position), frame)
    return Matrix.hstack(*(along(frame, eye(3).col(i), lengths) for i in range(3)))


def displacement_by_position(frame: Frame, position) -> Matrix:
    """The inverse of position_rate_by_velocity, 3x3: metres along the frame's axes by coordinates."""
    lengths = metres(*frame.latitude_and_height(position), frame)
    axes = Matrix.hstack(*(along(frame, eye(3).col(i), [1, 1, 1]) for i in range(3)))
    return axes.T * diag(*lengths)


def lengths_by_position(frame: Frame, position) -> Matrix:
    """3x3 (1/rad, 1/m by column): how the relative length of each coordinate's unit changes with each coordinate."""
    lat, height = frame.latitude_and_height(position)
    r_north, r_east = radii_at(lat, height)
    meridian_by_lat, transverse_by_lat = radii_by_latitude(lat)
    by_lat = frame.position(lat=meridian_by_lat / r_north, lon=transverse_by_lat / r_east - tan(lat), height=0)
    by_height = frame.position(lat=1 / r_north, lon=1 / r_east, height=0)
    return by_coordinate(frame, by_lat, by_height)


def level_by_position(frame: Frame, position) -> Matrix:
    """dtheta by position, 3x3 (rad per rad or m): how the level turns with each coordinate.

    Along a meridian it turns about west, along a parallel about the Earth's axis.
    """
    lat, _ = frame.latitude_and_height(position)
    by_lat, by_lon = frame.vector(0, -1, 0), frame.vector(cos(lat), 0, sin(lat))
    return by_lat * frame.coordinate("lat").T + by_lon * frame.coordinate("lon").T


# ---------------------------------------------------------------- the two models


def assembled(*rows) -> Matrix:
    """One matrix of rows of blocks, 3x3 or any that fit beside each other."""
    return Matrix.vstack(*(Matrix.hstack(*row) for row in rows))


def phi_matrix(frame: Frame, position, v_n, f_n) -> Matrix:
    """F of the phi model, 9x9: x' = F x + G w of the errors x = [position, dv, phi], w = [gyro, accelerometer error].

    Row: mechanics phi-3, phi-4.
    """
    ie_p, en_p = omega_ie_by_position(frame, position), omega_en_by_position(frame, position, v_n)
    en_v = omega_en_by_velocity(frame, position)

    # position' is the velocity over the length of each coordinate: a longer one is covered more slowly
    p_p = -diag(*position_rate(frame, position, v_n)) * lengths_by_position(frame, position)
    p_v = position_rate_by_velocity(frame, position)
    # v' = f_n + g - (2 omega_ie + omega_en) x v; an error d of the rate turns round: -d x v = v x d
    v_p = gravity_by_position(frame, position) + skew(v_n) * (2 * ie_p + en_p)
    v_v = -skew(turning_n(frame, position, v_n)) + skew(v_n) * en_v
    v_phi = skew(f_n)  # C_hat f_b = (I - [phi x]) f_n, and -phi x f_n = f_n x phi
    # phi' = -omega_in x phi + d omega_in - C_b2n d omega_ib
    phi_p, phi_v = ie_p + en_p, en_v
    phi_phi = -skew(omega_in_n(frame, position, v_n))
    return assembled([p_p, p_v, zeros(3)], [v_p, v_v, v_phi], [phi_p, phi_v, phi_phi])


def psi_matrix(frame: Frame, position, v_n, f_n) -> Matrix:
    """F of the psi model, 9x9, of the errors x = [position, dv_c, psi]; G as in phi_matrix.

    The computed level knows its own rate, so no d omega_in remains.
    Row: mechanics psi-3, psi-4.
    """
    lat, height = frame.latitude_and_height(position)
    omega_en = omega_en_n(lat, height, v_n, frame)

    # in metres dr' = -omega_en x dr + dv_c; a coordinate's error is dr over its length, which changes on the way
    p_v, r_p = position_rate_by_velocity(frame, position), displacement_by_position(frame, position)
    lengthening = lengths_by_position(frame, position) * position_rate(frame, position, v_n)
    p_p = -diag(*lengthening) - p_v * skew(omega_en) * r_p
    # gravity where one believes to be, against the true one carried into c: g(p_hat) - C_n2c g(p)
    v_p = gravity_by_position(frame, position) - skew(gravity_n(lat, height, frame)) * level_by_position(
        frame, position
    )
    v_v = -skew(turning_n(frame, position, v_n))
    v_psi = skew(f_n)
    psi_psi = -skew(omega_in_n(frame, position, v_n))
    return assembled([p_p, p_v, zeros(3)], [v_p, v_v, v_psi], [zeros(3), zeros(3), psi_psi])


def noise_matrix(C_b2n: Matrix) -> Matrix:
    """G of both models, 9x6, of C_b2n, 3x3: errors of the gyros (3, rad/s) and of the accelerometers (3, m/s^2),
    measured - true, in body axes.

    Row: mechanics phi-5.
    """
    return assembled([zeros(3), zeros(3)], [zeros(3), C_b2n], [-C_b2n, zeros(3)])


# ---------------------------------------------------------------- the map between them


def psi_from_phi(frame: Frame, position, v_n) -> Matrix:
    """T, 9x9: psi states = T (phi states).  A covariance goes by T P T'.

    Row: mechanics map-2, map-3.
    """
    turn = level_by_position(frame, position)
    # dv_c = dv + dtheta x v, psi = phi - dtheta
    return eye(9) - assembled([zeros(3, 9)], [skew(v_n) * turn, zeros(3, 6)], [turn, zeros(3, 6)])


def phi_from_psi(frame: Frame, position, v_n) -> Matrix:
    """The inverse of psi_from_phi, 9x9: phi states = T (psi states).

    Row: mechanics map-2, map-3.
    """
    return 2 * eye(9) - psi_from_phi(frame, position, v_n)  # T = I - N with N N = 0, so I + N
