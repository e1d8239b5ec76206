"""Transfer alignment by velocity and attitude with lever arm, misalignment and delay, sixteen states: Kang 2025."""

from sympy import Matrix, Piecewise, StrictLessThan, eye, zeros

from boresight.derive import mechanization
from boresight.derive.earth import NED
from boresight.derive.model import FirstOrder, Function, Measurement, Model, Output, Struct, Variable, variable
from boresight.derive.models.azimuth_hold import ACCEL_BIAS, GYRO_BIAS, body, root_density
from boresight.derive.models.euler_matching import ANGLES_HIGH, ANGLES_LOW
from boresight.derive.models.phi_error import per_axis
from boresight.derive.models.strapdown import attitude_variable, card, position_variable, velocity_variable
from boresight.derive.papers import kang_2025 as paper
from boresight.derive.papers.song_lee_2001 import euler_D_beta
from boresight.derive.rotation import (
    conjugate,
    dcm_from_euler,
    dcm_from_quaternion,
    euler_from_dcm,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
)

FRAME = NED
LEVER, LAG = 100.0, 1.0  # m, s


def quaternion(name: str, letter: str, meaning: str, frame: str) -> Variable:
    return variable(name, " ".join(f"{letter}_{part}" for part in "wxyz"), "1", meaning, -1.001, 1.001, frame=frame,
                    norm=(0.999, 1.001))  # fmt: skip


def level(name: str, letter: str, unit: str, meaning: str, limit: float) -> Variable:
    return per_axis(FRAME, name, letter, unit, meaning, limit)


# The inputs, which every composition of this model shares.
POSITION, V_N, Q = position_variable(FRAME), velocity_variable(FRAME), attitude_variable(FRAME)
BG = body("gyro_bias", "bg", "rad/s", "estimated gyro bias, measured - true", -GYRO_BIAS, GYRO_BIAS)
BA = body("accel_bias", "ba", "m/s^2", "estimated accelerometer bias, measured - true", -ACCEL_BIAS, ACCEL_BIAS)
Q_MOUNT = quaternion("q_b2m_wxyz", "q_mount", "estimated mounting of the slave", "slave body to master body")
TAU = variable("tau", "tau", "s", "estimated age of the master's data", -LAG, LAG)
F_B = body("f_b", "f", "m/s^2", "specific force, bias removed", -500.0, 500.0)
OMEGA_IB = body("omega_ib_b", "omega", "rad/s", "angular rate, bias removed", -20.0, 20.0)
DT = variable("dt", "dt", "s", "length of the step", 1e-6, 10.0)
INCREMENTS = (
    body("dtheta_ib_b", "dtheta", "rad", "integral of the measured angular rate over the step", -0.5, 0.5),
    body("dv_b", "dvel", "m/s", "integral of the measured specific force over the step", -100.0, 100.0),
    body("dtheta_before", "dtheta_before", "rad", "the same over the step before, as long", -0.5, 0.5),
    body("dv_before", "dvel_before", "m/s", "the same over the step before", -100.0, 100.0),
)
LEVER_B = body("lever_b", "lever", "m", "lever arm, from the master to the slave", -LEVER, LEVER)
V_M = level("v_m_n", "v_m", "m/s", "velocity that the master reports", 1000.0)
Q_M = quaternion("q_m2n_wxyz", "q_m", "attitude that the master reports", "master body to NED")
EULER_M = variable("euler_m", "roll_m pitch_m yaw_m", "rad", "roll, pitch, yaw that the master reports; where one is "
                   "not measured, the expected one", ANGLES_LOW, ANGLES_HIGH, frame="NED to master body")  # fmt: skip
A_N = level("a_n", "a", "m/s^2", "rate of change of the velocity expected of the master", 500.0)
LAG_S = variable("lag", "lag", "s", "how much older the master's data is believed to be than the slave's state given",
                 -LAG, LAG)  # fmt: skip

# The error states.
PHI = level("phi", "phi", "rad", "attitude error, C_hat = (I - [phi x]) C", 0.5)
DV = level("dv_n", "dv", "m/s", "error of the velocity, v_hat - v", 100.0)
DBG = body("d_gyro_bias", "dbg", "rad/s", "error of the gyro bias, estimated - true", -GYRO_BIAS, GYRO_BIAS)
DBA = body("d_accel_bias", "dba", "m/s^2", "error of the accelerometer bias, estimated - true", -ACCEL_BIAS, ACCEL_BIAS)
DMU = variable("dmu", "dmu_x dmu_y dmu_z", "rad", "misalignment error, C_hat_b2m = (I - [dmu x]) C_b2m", -0.5, 0.5,
               frame="master body")  # fmt: skip
D_TAU = variable("d_tau", "d_tau", "s", "error of the delay, tau_hat - tau", -LAG, LAG)


def expected(v_n: Matrix, q: Matrix, q_mount: Matrix, omega_ib_b: Matrix, lever_b: Matrix) -> tuple[Matrix, ...]:
    """Velocity and attitude (as a quaternion) that the master should report, and the rate of the body against n.

    The rate of the level is that at the estimated position and velocity: an error of 1 m/s turns it by 1.6e-7 rad/s.
    """
    omega_in = mechanization.omega_in_n(FRAME, POSITION.vector, V_N.vector)
    C_b2n = dcm_from_quaternion(q)
    return (
        paper.master_velocity(v_n, C_b2n, omega_in, omega_ib_b, lever_b),
        quaternion_product(q, conjugate(q_mount)),
        C_b2n * omega_ib_b - omega_in,
    )


def true_state() -> tuple[Matrix, ...]:
    """The arguments of `expected` once the errors x are taken out of the estimates, by finite rotations."""
    return (
        V_N.vector - DV.vector,
        quaternion_product(quaternion_from_rotation_vector(PHI.vector), Q.vector),
        quaternion_product(quaternion_from_rotation_vector(DMU.vector), Q_MOUNT.vector),
        OMEGA_IB.vector + DBG.vector,
        LEVER_B.vector,
    )


def velocity_residual(state: tuple[Matrix, ...], lag) -> Matrix:
    return paper.velocity_residual(expected(*state)[0], A_N.vector, lag, V_M.vector)


def dcm_residual(state: tuple[Matrix, ...], lag) -> Matrix:
    _, q_expected, omega_nb = expected(*state)
    return paper.attitude_residual(dcm_from_quaternion(q_expected), omega_nb, lag, dcm_from_quaternion(Q_M.vector))


def turned_back(state: tuple[Matrix, ...], lag) -> Matrix:
    """The expected attitude of the master, moved back by `lag` as a finite rotation, quaternion."""
    _, q_expected, omega_nb = expected(*state)
    return quaternion_product(quaternion_from_rotation_vector(-omega_nb * lag), q_expected)


def quaternion_residual(state: tuple[Matrix, ...], lag) -> Matrix:
    """Twice the vector part, which grows up to 180 deg; that of the DCM falls again from 90 deg on."""
    w, *xyz = quaternion_product(turned_back(state, lag), conjugate(Q_M.vector))
    sign = Piecewise((-1, StrictLessThan(w, 0, evaluate=False)), (1, True))  # q and -q are one attitude
    return 2 * sign * Matrix(xyz)


def euler_residual(state: tuple[Matrix, ...], lag) -> Matrix:
    return euler_from_dcm(dcm_from_quaternion(turned_back(state, lag))) - EULER_M.vector


def velocity_attitude() -> Model:
    """Errors of attitude, velocity, both biases, misalignment and delay; the position is taken from the master."""
    gyro_noise, accel_noise = (
        root_density("gyro_noise", "rad/sqrt(s)", "the gyros", 0.1),
        root_density("accel_noise", "m/s/sqrt(s)", "the accelerometers", 10.0),
    )
    noises = (
        gyro_noise,
        accel_noise,
        root_density("gyro_bias_noise", "rad/s/sqrt(s)", "the gyro biases' random walk", 0.1),
        root_density("accel_bias_noise", "m/s^2/sqrt(s)", "the accelerometer biases' random walk", 10.0),
        variable("mu_noise", "mu_noise_x mu_noise_y mu_noise_z", "rad/sqrt(s)",
                 "root power spectral density of the misalignment's random walk", 0, 0.1, frame="master body"),
        variable("tau_noise", "tau_noise", "sqrt(s)", "root power spectral density of the delay's random walk", 0, 0.1),
    )  # fmt: skip
    C_b2n = dcm_from_quaternion(Q.vector)
    F = paper.transfer_matrix(POSITION.vector, V_N.vector, C_b2n, C_b2n * F_B.vector)
    G = zeros(16)
    G[:6, :6] = -F[:6, 6:12]  # what a gyro or an accelerometer shows too much, minus what its bias' estimate does
    G[6:, 6:] = eye(10)

    now = (V_N.vector, Q.vector, Q_MOUNT.vector, OMEGA_IB.vector, LEVER_B.vector)
    lag, lag_true = LAG_S.scalar, LAG_S.scalar - D_TAU.scalar
    v_expected, q_expected, omega_nb = expected(*now)
    omega_in = mechanization.omega_in_n(FRAME, POSITION.vector, V_N.vector)
    z_velocity, z_dcm = velocity_residual(now, lag), dcm_residual(now, lag)
    z_quaternion = quaternion_residual(now, lag)
    z_euler = euler_residual(now, lag)
    roll_m, pitch_m, yaw_m = EULER_M.symbols
    q_reported = Q_MOUNT.vector
    for axis in ((roll_m, 0, 0), (0, pitch_m, 0), (0, 0, yaw_m)):
        q_reported = quaternion_product(quaternion_from_rotation_vector(axis), q_reported)
    C_m2n = dcm_from_euler(roll_m, pitch_m, yaw_m)
    euler_D_turn = euler_D_beta(roll_m, pitch_m) * C_m2n.T  # of a turn in n; its pitch is in the box, so never singular

    bias_g, bias_a, dt = BG.vector, BA.vector, DT.scalar
    dtheta, dvel, dtheta_before, dvel_before = (item.vector for item in INCREMENTS)
    nav_next = mechanization.step(
        FRAME, POSITION.vector, V_N.vector, Q.vector, dtheta - bias_g * dt, dvel - bias_a * dt,
        dtheta_before - bias_g * dt, dvel_before - bias_a * dt, dt,
    )  # fmt: skip
    v_true, q_true, q_mount_true, _, _ = true_state()
    order = ", ".join(FRAME.coordinates)
    return Model(
        name="velocity-attitude",
        c_prefix="va",
        title="transfer alignment by velocity and attitude with misalignment and delay, 16 states",
        frame=f"{FRAME.name} with body axes {FRAME.body}",
        states=(PHI, DV, DBG, DBA, DMU, D_TAU),
        structs=(
            Struct("nav", "what the slave carries and the filter corrects", (POSITION, V_N, Q, BG, BA, Q_MOUNT, TAU)),
            Struct("imu", "inertial data over one step", (F_B, OMEGA_IB, DT)),
            Struct("increments", "what the sensors deliver over one step, and over the step before", INCREMENTS),
            Struct("noise", "process noise", noises),
            Struct("mounting", "where the slave stands", (LEVER_B,)),
            Struct("master", "what the master reports", (V_M, Q_M, EULER_M, A_N, LAG_S)),
        ),
        F=F,
        G=G,
        noise=Matrix.vstack(*(n.vector for n in noises)),
        dt=dt,
        measurements=(
            Measurement("velocity", FRAME.axes, "m/s", "velocity expected of the master less the reported one",
                        z=z_velocity, h=z_velocity - velocity_residual(true_state(), lag_true),
                        H=paper.velocity_matrix(C_b2n, omega_in, OMEGA_IB.vector, LEVER_B.vector, A_N.vector),
                        first_order=FirstOrder(),
                        equations=("kang-2025 (1)", "kang-2025 (3)")),
            Measurement("dcm", FRAME.axes, "rad", "turn of the expected attitude of the master from the reported one",
                        z=z_dcm, h=z_dcm - dcm_residual(true_state(), lag_true),
                        # the expected attitude, not the reported one: noise in H would pass for motion of the hull
                        H=paper.attitude_matrix(dcm_from_quaternion(q_expected), omega_nb),
                        first_order=FirstOrder(small="lag", tied=(("q_m2n_wxyz", q_expected),)),
                        equations=("kang-2025 (4)", "kang-2025 (5)")),
            Measurement("quaternion", FRAME.axes, "rad",
                        "the same turn, of any size, as twice the vector part of its quaternion", z=z_quaternion,
                        h=z_quaternion - quaternion_residual(true_state(), lag_true)),
            Measurement("euler", ("roll", "pitch", "yaw"), "rad",
                        "expected Euler angles of the master less the reported", z=z_euler,
                        h=z_euler - euler_residual(true_state(), lag_true),
                        H=euler_D_turn * paper.attitude_matrix(C_m2n, omega_nb), angle=True,
                        first_order=FirstOrder(small="lag", tied=(("q_b2n_wxyz", q_reported),)),
                        equations=("song-lee-2001 (13)",)),
        ),
        functions=(
            Function("strapdown", "the slave after one step of inertial increments, estimated biases removed", (
                Output("position", nav_next[0], POSITION.unit, order, "WGS-84"),
                Output("v_n", nav_next[1], "m/s", "velocity over the ground", FRAME.name),
                Output("q_b2n_wxyz", nav_next[2], "1", "attitude, of unit norm", f"body to {FRAME.name}"),
            )),
            Function("expected", "what the master should report for this state of the slave", (
                Output("v_m_n", v_expected, "m/s", "velocity at the master", FRAME.name),
                Output("q_m2n_wxyz", normalized(q_expected), "1", "attitude of the master", f"master to {FRAME.name}"),
                Output("omega_nb_n", omega_nb, "rad/s", "rate of the body against the level", FRAME.name),
            ), ("kang-2025 (1)",)),
            Function("feedback", "the slave with the estimated errors taken out", (
                Output("v_n", v_true, "m/s", "velocity over the ground", FRAME.name),
                Output("q_b2n_wxyz", normalized(q_true), "1", "attitude, of unit norm", f"body to {FRAME.name}"),
                Output("gyro_bias", bias_g - DBG.vector, "rad/s", "gyro bias", "body"),
                Output("accel_bias", bias_a - DBA.vector, "m/s^2", "accelerometer bias", "body"),
                Output("q_b2m_wxyz", normalized(q_mount_true), "1", "mounting, of unit norm",
                       "slave body to master body"),
                Output("tau", TAU.vector - D_TAU.vector, "s", "age of the master's data"),
            )),
        ),
        card=(
            "Error = computed - true; C_hat_b2n = (I - [phi x]) C_b2n against the true level (phi model).",
            "Mounting: C_b2n = C_m2n C_b2m, of any size; C_hat_b2m = (I - [dmu x]) C_b2m, m the master's body axes.",
            "A bias is measured - true, and its error estimated - true.  The lever arm runs from master to slave.",
            "A delay tau > 0: the master's data is old by it.  The slave is given as it is now, with lag = tau, or as",
            "it was tau ago, with lag = 0.",
            *card(FRAME),
        ),
    )  # fmt: skip
