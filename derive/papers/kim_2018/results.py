"""Kim 2018: holding the azimuth of a tactical-grade inertial unit at rest, after transfer alignment.

    S. Kim, "Method for Maintaining Initial Azimuth of Tactical Grade IMU by Using Zero Velocity Update
    Algorithm", 2018.

First the results, as pure functions, which tests hold against the witness of the ledger.  Then the 32 equations as they
are printed, each beside its derivation.  Nothing is derived on import.

The paper's conventions: ENU, right-front-up, error = computed - true, ``C_hat_b2n = C_b2p = (I - [phi x]) C_b2n``.
Section 2.1 has the psi model (error against the computed axes), section 2.2 the phi model (against the true ones), both
with the letter phi.  ``theta`` is the error of the mounting, ``C_hat_b2r = (I - [theta x]) C_b2r``; ``dt > 0`` says
by how much the master's data is old.  Position is longitude, latitude, height.
"""

from sympy import Matrix, eye, sqrt, zeros

from boresight.derive.mechanics import error_models
from boresight.derive.mechanics.earth import ENU
from boresight.derive.mechanics.rotation import quaternion_product, vee

# ---- 2.1 Transfer alignment: velocity and attitude error (psi), mounting error, delay --------------------------------


def transfer_matrix(position, v_n, f_n) -> Matrix:
    """(3)  F, 10x10, of [dv, psi, theta, dt]: the psi model where the position is known."""
    F = zeros(10, 10)
    F[:6, :6] = error_models.psi_matrix(ENU, position, v_n, f_n)[3:, 3:]
    return F


def velocity_residual(v_slave_n, v_master_n) -> Matrix:
    """(4)  Z_v, 3x1 m/s."""
    return Matrix(v_slave_n) - Matrix(v_master_n)


def attitude_residual(C_r2n, C_b2r, C_b2n) -> Matrix:
    """(5)  Z_dcm, 3x1 rad: from the master's attitude as it arrives, the estimated mounting, the slave's attitude."""
    return vee(Matrix(C_r2n) * Matrix(C_b2r) * Matrix(C_b2n).T)


def transfer_measurement_matrix(C_r2n, v_rate_n, omega_nr_n) -> Matrix:
    """(6)  H, 6x10, of [Z_v, Z_dcm]; v_rate_n: acceleration over the ground; omega_nr_n: rate of the master against n.

    For the delay itself.  For the error of an estimated one, tau_hat - tau, the last column changes its sign.
    """
    velocity = Matrix.hstack(eye(3), zeros(3, 6), Matrix(v_rate_n))
    attitude = Matrix.hstack(zeros(3), eye(3), -Matrix(C_r2n), -Matrix(omega_nr_n))
    return Matrix.vstack(velocity, attitude)


# ---- 2.2 Zero velocity and azimuth: position, velocity, attitude error (phi), gyro and accelerometer bias ------------


def hold_matrix(position, v_n, C_b2n, f_n) -> Matrix:
    """(9) to (11)  F_k, 15x15; a bias is what the sensor shows too much, measured - true."""
    F = zeros(15, 15)
    F[:9, :9] = error_models.phi_matrix(ENU, position, v_n, f_n)
    F[:9, 9:] = error_models.noise_matrix(C_b2n)
    return F


def zero_velocity_matrix() -> Matrix:
    """(17)  H_k, 3x15, of the computed velocity at rest."""
    return Matrix.hstack(zeros(3), eye(3), zeros(3, 9))


def hold_measurement_matrix() -> Matrix:
    """(23)  H_k, 4x15, of velocity and azimuth."""
    return Matrix.vstack(zero_velocity_matrix(), Matrix([[int(i == 8) for i in range(15)]]))


def azimuth_error(C_b2p, C_n2b_reference):
    """(21)  phi_u, rad, from the computed attitude and that of the transfer alignment; without a second order."""
    M = Matrix(C_b2p) * Matrix(C_n2b_reference)
    return (M[0, 1] - M[1, 0]) / 2


def quaternion_error(q_b2n_wxyz, phi) -> Matrix:
    """(29)  Q_hat - Q, 4x1, to first order in phi (3x1, rad); q_b2n_wxyz is the computed attitude."""
    return -quaternion_product([0, *phi], q_b2n_wxyz) / 2


# ---- 2.2.4 Detector --------------------------------------------------------------------------------------------------


def moving_deviation(samples):
    """(31)  Root mean square distance of the samples (N, each 3) from their mean."""
    rows = [Matrix(sample) for sample in samples]
    mean = sum(rows, zeros(3, 1)) / len(rows)
    return sqrt(sum((row - mean).dot(row - mean) for row in rows) / len(rows))


def moving_mean(samples):
    """(32)  Length of the mean of the samples (N, each 3): the norm which the print leaves out."""
    mean = sum((Matrix(sample) for sample in samples), zeros(3, 1)) / len(samples)
    return sqrt(mean.dot(mean))
