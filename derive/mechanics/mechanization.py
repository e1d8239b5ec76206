"""The strapdown mechanization: exact rates of position, velocity and attitude, and the integrator that follows them.

One derivation for every Frame of earth.py.

position: (3) geodetic latitude (rad), longitude (rad) and height (m) in the frame's order.
v_n: (3, m/s) velocity over the ground, in the level.  f_n: (3, m/s^2) specific force in the level, f_n = C_b2n f_b.
q_b2n_wxyz (4), C_b2n (3x3): attitude, body to level.
omega_ib_b: (3, rad/s) angular rate of the body against inertial space, in body axes.

Everything here is singular at the poles.
"""

from sympy import Matrix, Rational, zeros

from boresight.derive.mechanics.earth import Frame, gravity_n, metres, omega_en_n, omega_ie_n
from boresight.derive.mechanics.rotation import (
    dcm_from_quaternion,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
    skew,
    small_rotation,
)
from boresight.derive.named import named

# ---------------------------------------------------------------- rates


def position_rate(frame: Frame, position, v_n) -> Matrix:
    """position' (3; rad/s, rad/s, m/s in the frame's order): the velocity over the radii of the ellipsoid.

    Row: mechanics strapdown-1.
    """
    return along(frame, v_n, metres(*frame.latitude_and_height(position), frame))


def along(frame: Frame, v_n, lengths) -> Matrix:
    """(3) the vector v_n along each coordinate, over that coordinate's length (3), in the frame's order.

    Height grows upwards in NED too.
    """
    v = frame.position(lat=frame.north.dot(v_n), lon=frame.east.dot(v_n), height=frame.up.dot(v_n))
    return Matrix([speed / length for speed, length in zip(v, lengths, strict=True)])


def omega_in_n(frame: Frame, position, v_n) -> Matrix:
    """Rate of the level against inertial space, in the level (3, rad/s): the Earth's and the transport rate."""
    lat, height = frame.latitude_and_height(position)
    rate = omega_ie_n(lat, frame) + omega_en_n(lat, height, v_n, frame)
    return frame.named("omega_in_n", rate, "rate of the level against inertial space, rad/s")


def turning_n(frame: Frame, position, v_n) -> Matrix:
    """2 omega_ie + omega_en in the level (3, rad/s): the rate of the Coriolis acceleration."""
    lat, height = frame.latitude_and_height(position)
    rate = 2 * omega_ie_n(lat, frame) + omega_en_n(lat, height, v_n, frame)
    return frame.named("omega_cor_n", rate, "2 omega_ie_n + omega_en_n of the Coriolis acceleration, rad/s")


def free_acceleration(frame: Frame, position, v_n) -> Matrix:
    """Acceleration over the ground without any specific force, in the level (3, m/s^2): gravity and Coriolis."""
    lat, height = frame.latitude_and_height(position)
    return gravity_n(lat, height, frame) - skew(turning_n(frame, position, v_n)) * v_n


def velocity_rate(frame: Frame, position, v_n, f_n) -> Matrix:
    """v_n' (3, m/s^2): specific force, gravity and Coriolis.

    Row: mechanics strapdown-1.
    """
    return f_n + free_acceleration(frame, position, v_n)


def dcm_rate(frame: Frame, position, v_n, C_b2n: Matrix, omega_ib_b) -> Matrix:
    """C_b2n' (3x3, 1/s): the body turns by omega_ib_b on its side, the level by omega_in_n on the other."""
    return C_b2n * skew(omega_ib_b) - skew(omega_in_n(frame, position, v_n)) * C_b2n


def quaternion_rate(frame: Frame, position, v_n, q_b2n_wxyz, omega_ib_b) -> Matrix:
    """q_b2n_wxyz' (4, 1/s), as dcm_rate.

    Row: mechanics strapdown-1.
    """
    body = quaternion_product(q_b2n_wxyz, Matrix([0, *omega_ib_b]))
    level = quaternion_product(Matrix([0, *omega_in_n(frame, position, v_n)]), q_b2n_wxyz)
    return (body - level) / 2


# ---------------------------------------------------------------- one step of the integrator


def rotation_increment(dtheta, dtheta_before) -> Matrix:
    """Rotation vector of the body over a step (3, rad), from the integrated rates (3, rad) of this step and of the one
    before, as long.

    Coning: where the rate is linear in time over both steps, this is exact to the fourth power of the step.
    """
    return dtheta + skew(dtheta_before) * dtheta / 12


def velocity_increment(dtheta, dv, dtheta_before, dv_before) -> Matrix:
    """Integral of the specific force over a step (3, m/s), in the body axes at its start.

    dtheta (3, rad), dv (3, m/s): what gyros and accelerometers integrate over the step, and over the one before.
    Knows the body's turn within the step, to its second power, and sculling.
    """
    turned = skew(dtheta) * dv
    sculling = (skew(dtheta_before) * dv + skew(dv_before) * dtheta) / 12
    return dv + turned / 2 + skew(dtheta) * turned / 6 + sculling


def coning_coefficients(samples: int) -> list:
    """k_1 to k_(samples - 1): the coning of a step is the sum of k_j skew(dtheta of j steps before) dtheta.

    A body that cones turns by (x - sin x) / 2 over a step where its axis turns by x, and the product of increments j
    steps apart is 2 (1 - cos x) sin(j x) = 2 sin(j x) - sin((j + 1) x) - sin((j - 1) x), amplitudes left out.  Each odd
    power q of x from 3 on gives one equation: the second difference of j^q, weighted by k_j, is 1 / 2.  What is left of
    the rate falls with the power 2 samples of the step.  Two samples: 1/12, as in rotation_increment.
    """
    js, powers = range(1, samples), range(3, 2 * samples, 2)
    differences = Matrix([[(j + 1) ** q - 2 * j**q + (j - 1) ** q for j in js] for q in powers])
    return list(differences.LUsolve(Matrix([Rational(1, 2)] * (samples - 1))))


def compensated(dtheta, dv, before) -> tuple[Matrix, Matrix]:
    """dtheta (3, rad) and dv (3, m/s) of a step with which `step` follows coning and sculling by more than two samples.

    before: (dtheta, dv) of the steps before, the last one first; so many and one are the samples.  Biases removed: what
    is left of one enters by its product with the increments.  `step` gets the result in place of dtheta and dv, and
    dtheta_before, dv_before as they were delivered; its own twelfth is taken off here.
    """
    k = coning_coefficients(len(before) + 1)
    k[0] -= Rational(1, 12)
    turned, pushed = (sum((k_j * one[i] for k_j, one in zip(k, before, strict=True)), zeros(3, 1)) for i in range(2))
    return dtheta + skew(turned) * dtheta, dv + skew(turned) * dv + skew(pushed) * dtheta


def step(frame: Frame, position, v_n, q_b2n_wxyz, dtheta, dv, dtheta_before, dv_before, dt) -> tuple:
    """Position, velocity and attitude after one interval of inertial increments; of the second order in dt.

    dtheta (3, rad), dv (3, m/s): integrals over the interval of what the gyros and accelerometers see; dtheta_before,
    dv_before: the same of the interval before, as long; at the very start give the first ones twice.  dt: s.

    Gravity, Coriolis and the turn of the level are taken at the middle of the interval, which is predicted from its
    start.
    """
    C_b2n = named("C_b2n", dcm_from_quaternion(q_b2n_wxyz), "body to level")
    increment = named("dv_sf_b", velocity_increment(dtheta, dv, dtheta_before, dv_before),
                      "specific force over the step, in the body axes at its start, m/s", "x y z")  # fmt: skip
    gained = frame.named("dv_sf_n", C_b2n * increment, "dv_sf_b in the level, m/s")
    v_middle = v_n + (gained + dt * free_acceleration(frame, position, v_n)) / 2
    v_middle = frame.named("v_mid_n", v_middle, "velocity at the middle of the step, m/s")
    p_middle = named("mid", position + dt / 2 * position_rate(frame, position, v_n),
                     "position at the middle of the step", " ".join(frame.coordinates))  # fmt: skip

    level = dt * omega_in_n(frame, p_middle, v_middle)
    level = frame.named("zeta_n", level, "rotation vector of the level over the step, rad")
    v_next = v_n + small_rotation(-level / 2) * gained + dt * free_acceleration(frame, p_middle, v_middle)
    # mean velocity: that of a constant acceleration, less what the growth of the acceleration takes from it (scrolling)
    growth = frame.named("dv_growth_n", C_b2n * (dv - dv_before + skew(dtheta) * dv),
                         "by how much dv_sf_n grows from step to step, m/s")  # fmt: skip
    lat, height = frame.latitude_and_height(p_middle)
    p_next = position + dt * along(frame, (v_n + v_next) / 2 - growth / 12, metres(lat, height, frame))

    turned = named("sigma_b", rotation_increment(dtheta, dtheta_before),
                   "rotation vector of the body over the step, rad", "x y z")  # fmt: skip
    turn = named("q_body", quaternion_from_rotation_vector(turned), "of the rotation by sigma_b", "w x y z")
    back = named("q_level", quaternion_from_rotation_vector(-level), "of the rotation by -zeta_n", "w x y z")
    return p_next, v_next, normalized(quaternion_product(back, quaternion_product(q_b2n_wxyz, turn)))
