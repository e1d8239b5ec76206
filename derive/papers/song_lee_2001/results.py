"""Song and Lee 2001: transfer alignment by Euler-angle matching, equation by equation.

    K. W. Song and S. J. Lee, "The Kalman Filter Design for the Transfer Alignment by Euler Angle Matching",
    Journal of Control, Automation and Systems Engineering, 2001.

First the results, as pure functions which the model uses too; an edit here moves the model and the ledger alike.
Then the 28 numbered equations as they are printed, each beside its derivation.  Nothing is derived on import.

The paper's conventions are those of Boresight: NED, front-right-down, error = computed - true, and
``C_hat_b2n = (I - [eps x]) C_b2n``.  ``mu`` carries the axes r of the master into the axes b of the slave:
``C_b2n = C_r2n (I + [mu x])``, and ``dmu = mu_hat - mu``.  Angles in rad; euler is roll, pitch, yaw (phi, theta, psi).
"""

from sympy import Matrix, eye, symbols

from boresight.derive.mechanics.rotation import (
    quaternion_from_rotation_vector,
    quaternion_product,
    rotation_x,
    rotation_y,
    rotation_z,
    skew,
)

# ---- II. Euler-angle error and rotation vector ---------------------------------------------------------------------
#
# C_b2n = Rz(psi) Ry(theta) Rx(phi).  A change of one angle turns the body about the axis of its own elementary
# rotation: psi about the third axis of n, theta about the second axis after psi, phi about the first after both.


def eps_D_euler(theta, psi) -> Matrix:
    """(8)  d(eps) / d(Euler angles), 3x3: the error of the navigation axes which small angle errors amount to.

    C_hat = (I - [eps x]) C turns by -eps, in navigation components, and C_hat = C + dC by the three angles' axes.
    """
    return -rotation_z(psi) * axes_after_yaw(theta)


def euler_D_eps(theta, psi) -> Matrix:
    """(9)  d(Euler angles) / d(eps), 3x3: the inverse of (8), singular at a pitch of +-90 deg."""
    return -axes_after_yaw(theta).lower_triangular_solve(eye(3)) * rotation_z(psi).T


def beta_D_euler(phi, theta) -> Matrix:
    """(12)  d(beta) / d(Euler angles), 3x3: the same small rotation in body axes, C_hat = C (I + [beta x])."""
    return rotation_x(phi).T * axes_before_roll(theta)


def euler_D_beta(phi, theta) -> Matrix:
    """(13)  d(Euler angles) / d(beta), 3x3: the inverse of (12), singular at a pitch of +-90 deg."""
    return axes_before_roll(theta).upper_triangular_solve(eye(3)) * rotation_x(phi)


def axes_after_yaw(theta) -> Matrix:
    """The axes of roll, pitch and yaw as columns, in the axes which the yaw has turned: lower triangular."""
    return Matrix.hstack(rotation_y(theta)[:, 0], eye(3)[:, 1:])


def axes_before_roll(theta) -> Matrix:
    """The axes of roll, pitch and yaw as columns, in the axes before the roll: upper triangular."""
    return Matrix.hstack(eye(3)[:, :2], rotation_y(theta).T[:, 2])


# ---- III. The measurement ------------------------------------------------------------------------------------------


def relative_euler(euler_r, mu) -> Matrix:
    """(18)  Euler angles of the slave minus those of the master, 3x1 rad, for a small misalignment mu (3x1, rad).

    To first order: at 3 degrees the second order is some arcminutes, see the ledger.
    """
    phi_r, theta_r, _ = euler_r
    return euler_D_beta(phi_r, theta_r) * Matrix(mu)


def relative_euler_second_order(euler_r, mu) -> Matrix:
    """The term of second order which (15) and (18) drop, 3x1 rad.

    The slave is reached from the master by turning about mu at a constant rate for a unit of time, along which the
    angles change by euler_D_beta(angles) mu: half the second derivative at the start.  With the angles of the slave in
    euler_D_beta, as in the text under (28), the term has the other sign and, to this order, the same size.
    """
    angles = symbols("phi theta psi", real=True)
    rate = relative_euler(angles, mu)
    second = rate.jacobian(Matrix(angles)) * rate / 2
    return second.subs(dict(zip(angles, euler_r, strict=True)), simultaneous=True)


def measurement(euler_b, euler_r, mu) -> Matrix:
    """(16) with (18)  Z, 3x1 rad, not wrapped: slave's angles minus master's minus what mu explains."""
    return Matrix(euler_b) - Matrix(euler_r) - relative_euler(euler_r, mu)


def measurement_matrix(euler_b, euler_r) -> Matrix:
    """(19)  H, 3x6, of Z for the states [eps_n, eps_e, eps_d, dmu_x, dmu_y, dmu_z]."""
    _, theta_b, psi_b = euler_b
    phi_r, theta_r, _ = euler_r
    return Matrix.hstack(euler_D_eps(theta_b, psi_b), -euler_D_beta(phi_r, theta_r))


# ---- IV. The filter ------------------------------------------------------------------------------------------------


def attitude_error_matrix(omega_in_n) -> Matrix:
    """(20)  d(eps rate) / d(eps), 3x3 1/s, from the rate of the navigation axes (3x1, rad/s, navigation components)."""
    return -skew(omega_in_n)


def attitude_noise_matrix(C_b2n):
    """(20)  d(eps rate) / d(gyro error), 3x3; the gyro error is computed - true, rad/s, body components."""
    return -C_b2n


def error_quaternion(eps) -> Matrix:
    """(23)  The quaternion, 4x1, of the rotation by eps (3x1, rad), which takes the error out."""
    return quaternion_from_rotation_vector(eps)


def corrected_quaternion(q_b2n_wxyz, eps) -> Matrix:
    """(24)  The attitude after the correction by the estimated error eps, 4x1."""
    return quaternion_product(error_quaternion(eps), q_b2n_wxyz)


def corrected_misalignment(mu, dmu):
    """(25), whose print adds  The misalignment after the correction by its estimated error dmu = mu_hat - mu."""
    return mu - dmu
