"""Kang and others 2025: transfer alignment at sea by velocity and attitude, with lever arm, misalignment and delay.

    S. H. Kang, S. J. Park, J. W. Jung, T. S. Yoo, "Analysis of Transfer Alignment Based on Velocity and Attitude
    Matching for Surface Vehicles Under Various Sea States", 2025.

First the results, as pure functions, which the model and the ledger share.  The paper prints the two residuals, (3) and
(5), but neither F nor H: both are derived here.  Then the six equations as they are printed, each beside its
derivation.  Nothing is derived on import.

Conventions: NED, front-right-down, the phi model, error = computed - true: ``C_hat_b2n = (I - [phi x]) C_b2n``; the
misalignment is a rotation of any size, ``C_hat_b2m = (I - [dmu x]) C_b2m`` with dmu in master axes.  The lever arm runs
from master to slave, in slave body axes.  ``lag`` is how much older the master's data is believed to be than the
slave's; the state is the error of that belief, d_tau = tau_hat - tau.
"""

from sympy import Matrix, eye, zeros

from boresight.derive.mechanics import error_models
from boresight.derive.mechanics.earth import NED
from boresight.derive.mechanics.rotation import skew, vee

# ---- 2.1 to 2.4 What the slave expects of the master, and the two residuals ------------------------------------------


def lever_velocity(C_b2n, omega_in_n, omega_ib_b, lever_b) -> Matrix:
    """(1)  Velocity of the slave against the master, 3x1 m/s: the rate of change of the lever arm as seen from n."""
    return u_n(C_b2n, omega_ib_b, lever_b) - skew(omega_in_n) * lever_n(C_b2n, lever_b)


def lever_n(C_b2n, lever_b) -> Matrix:
    """The lever arm in the level, 3x1 m."""
    return NED.named("lever_n", C_b2n * lever_b, "the lever arm in the level, m")


def u_n(C_b2n, omega_ib_b, lever_b) -> Matrix:
    """C (omega x lever), 3x1 m/s."""
    return NED.named("u_n", C_b2n * skew(omega_ib_b) * lever_b, "C_b2n (omega_ib_b x lever_b), m/s")


def master_velocity(v_n, C_b2n, omega_in_n, omega_ib_b, lever_b) -> Matrix:
    """(1)  Velocity at the master, 3x1 m/s, from that of the slave."""
    return v_n - lever_velocity(C_b2n, omega_in_n, omega_ib_b, lever_b)


def velocity_residual(v_expected_n, a_n, lag, v_m_n) -> Matrix:
    """(3)  z_v, 3x1 m/s: the expected velocity of the master, moved back by `lag`, less the reported one.

    a_n: rate of change of the expected velocity, 3x1 m/s^2.  The paper's, (v_k-1 - v_k) / dt, is that of the slave
    alone and leaves out how the lever-arm velocity changes.
    """
    return v_expected_n - a_n * lag - v_m_n


def attitude_residual(C_expected_m2n, omega_nb_n, lag, C_m2n) -> Matrix:
    """(4), (5)  z_DCM, 3x1 rad: turn of the master's expected attitude, moved back by `lag`, from the reported one.

    C_expected_m2n: C_b2n C_m2b of the slave.  omega_nb_n: rate of the body against the level, 3x1 rad/s.
    """
    return vee(C_expected_m2n * C_m2n.T) - omega_nb_n * lag


# ---- What the paper does not print: F and H of [phi, dv, d_gyro_bias, d_accel_bias, dmu, d_tau] ----------------------


def transfer_matrix(position, v_n, C_b2n, f_n) -> Matrix:
    """F, 16x16: the phi model where the position is known; an error of a bias estimate is estimated - true."""
    F = zeros(16)
    error, sensors = error_models.phi_matrix(NED, position, v_n, f_n), error_models.noise_matrix(C_b2n)
    order = [6, 7, 8, 3, 4, 5]  # attitude before velocity
    F[:6, :6] = error.extract(order, order)
    # the estimate leaves minus its own error of what the sensor shows too much
    F[:6, 6:12] = -sensors.extract(order, list(range(6)))
    return F


def velocity_matrix(C_b2n, omega_in_n, omega_ib_b, lever_b, a_n) -> Matrix:
    """H of (3), 3x16, at the rate omega_in_n of the level, which is taken as known.

    Attitude and gyro bias enter through the lever arm: with C_hat = (I - [phi x]) C and omega_hat = omega - d_gyro_bias
    the expected velocity moves by ([omega_in x] [r x] - [u x]) phi - C [lever x] d_gyro_bias, r = C lever, u = C (omega
    x lever).
    """
    r, u = lever_n(C_b2n, lever_b), u_n(C_b2n, omega_ib_b, lever_b)
    by_phi = skew(omega_in_n) * skew(r) - skew(u)
    by_gyro_bias = -C_b2n * skew(lever_b)
    return Matrix.hstack(by_phi, eye(3), by_gyro_bias, zeros(3, 6), -a_n)


def attitude_matrix(C_m2n, omega_nb_n) -> Matrix:
    """H of (5), 3x16, at a small `lag` and a small residual."""
    return Matrix.hstack(-eye(3), zeros(3, 9), C_m2n, -omega_nb_n)
