"""Rotations as SymPy expressions: skew matrices, Euler angles, quaternions, rotation vectors.

Angles in rad, roll pitch yaw from navigation to body; ``C_b2n`` takes body components to navigation components;
quaternions are Hamilton, scalar first.  Every expression is free of branches and of 0/0, so that it can become C.
"""

from sympy import Matrix, atan2, cos, eye, sin, sqrt

from boresight.derive.constant import constant
from boresight.derive.named import named

# Of use where a root of squares is divided by: a rotation by zero divides by 1e-15 and not by zero.  It changes the
# quaternion of any rotation vector by less than 1e-30.
TINY_SQUARE = constant("epsilon", "1e-30", "rad^2", "added to the square of an angle before its root is taken")


def skew(v) -> Matrix:
    """[v x], 3x3, of a vector (3): skew(v) * w is the cross product v x w."""
    x, y, z = v
    return Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def vee(M) -> Matrix:
    """(3): the vector of the skew-symmetric part of a 3x3 matrix: vee(skew(v)) == v."""
    return Matrix([M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]]) / 2


def small_rotation(e) -> Matrix:
    """I + [e x], 3x3: the rotation by the vector e (3, rad) to first order; it errs by e^2 / 2."""
    return eye(3) + skew(e)


def rotation_x(angle) -> Matrix:
    """3x3: the rotation by `angle` (rad) about the first axis; takes components of the turned frame to the first's."""
    c, s = cos(angle), sin(angle)
    return Matrix([[1, 0, 0], [0, c, -s], [0, s, c]])


def rotation_y(angle) -> Matrix:
    """3x3: the rotation by `angle` (rad) about the second axis, as rotation_x."""
    c, s = cos(angle), sin(angle)
    return Matrix([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def rotation_z(angle) -> Matrix:
    """3x3: the rotation by `angle` (rad) about the third axis, as rotation_x."""
    c, s = cos(angle), sin(angle)
    return Matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def dcm_from_euler(roll, pitch, yaw) -> Matrix:
    """C_b2n, 3x3, of the Euler angles (rad): yaw about z, then pitch about y, then roll about x."""
    return rotation_z(yaw) * rotation_y(pitch) * rotation_x(roll)


def euler_from_dcm(C) -> Matrix:
    """[roll, pitch, yaw] (rad) of C_b2n, 3x3; roll and yaw in [-pi, pi], pitch in [-pi/2, pi/2].

    At a pitch of +-90 deg roll and yaw are one angle.
    """
    return Matrix(
        [
            atan2(C[2, 1], C[2, 2]),
            atan2(-C[2, 0], sqrt(C[0, 0] ** 2 + C[1, 0] ** 2)),
            atan2(C[1, 0], C[0, 0]),
        ]
    )


def dcm_from_quaternion(q_wxyz) -> Matrix:
    """The 3x3 matrix of a unit quaternion: C_b2n of q_b2n_wxyz.  Of another norm it is no rotation."""
    w, x, y, z = q_wxyz
    return Matrix(
        [
            [w**2 + x**2 - y**2 - z**2, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w**2 - x**2 + y**2 - z**2, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w**2 - x**2 - y**2 + z**2],
        ]
    )


def quaternion_product(p, q) -> Matrix:
    """p q of Hamilton, [w, x, y, z]: dcm(p q) = dcm(p) dcm(q)."""
    pw, px, py, pz = p
    qw, qx, qy, qz = q
    return Matrix(
        [
            pw * qw - px * qx - py * qy - pz * qz,
            pw * qx + px * qw + py * qz - pz * qy,
            pw * qy - px * qz + py * qw + pz * qx,
            pw * qz + px * qy - py * qx + pz * qw,
        ]
    )


def conjugate(q) -> Matrix:
    """[w, x, y, z] with the vector part turned round: the inverse of a unit quaternion."""
    w, x, y, z = q
    return Matrix([w, -x, -y, -z])


def normalized(q) -> Matrix:
    """The quaternion (4), scaled to unit norm; of the zero quaternion there is none."""
    return q / sqrt(q.dot(q))


def quaternion_from_rotation_vector(e) -> Matrix:
    """[w, x, y, z] of the finite rotation by the vector e (3, rad): exact, to 1e-30, and defined at zero."""
    x, y, z = e
    angle = named("angle", sqrt(x**2 + y**2 + z**2 + TINY_SQUARE), "of a rotation, rad")
    scale = sin(angle / 2) / angle
    return Matrix([cos(angle / 2), x * scale, y * scale, z * scale])


def dcm_from_rotation_vector(e) -> Matrix:
    """exp([e x]), 3x3: the finite rotation by the vector e (3, rad), exact to 1e-30 and defined at zero."""
    turn = named("q_turn", quaternion_from_rotation_vector(e), "the quaternion of a rotation vector", "w x y z")
    return dcm_from_quaternion(turn)
