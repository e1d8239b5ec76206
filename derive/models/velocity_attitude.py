"""Transfer alignment by velocity and attitude with lever arm, misalignment and delay, sixteen states: Kang 2025."""

from sympy import Matrix, Piecewise, StrictLessThan, eye, zeros

from boresight.derive.mechanics import mechanization
from boresight.derive.mechanics.earth import NED
from boresight.derive.mechanics.rotation import (
    conjugate,
    dcm_from_euler,
    dcm_from_quaternion,
    euler_from_dcm,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
)
from boresight.derive.model import FirstOrder, Function, Measurement, Model, Output, Struct, variable
from boresight.derive.models import variables as var
from boresight.derive.models.variables import BA, BG, D_BA, D_BG, D_TAU, DT, EULER_M, F_B, LEVER_B, OMEGA_IB_B, TAU
from boresight.derive.named import named
from boresight.derive.papers.kang_2025 import results as paper
from boresight.derive.papers.song_lee_2001.results import euler_D_beta

FRAME = NED

# The inputs, which every composition of this model shares.
POSITION, V_N, Q = var.position(FRAME), var.velocity(FRAME), var.attitude(FRAME)
Q_MOUNT = var.quaternion("q_b2m_wxyz", "q_mount", "estimated mounting of the slave", f"slave body to {var.MASTER_BODY}")
V_M, Q_M = var.master_velocity(FRAME), var.master_attitude(FRAME)
A_N = var.acceleration(FRAME, "rate of change of the velocity expected of the master")
LAG = variable("lag", "lag", "s", "how much older the master's data is believed to be than the slave's state given",
               -var.MAX_DELAY, var.MAX_DELAY)  # fmt: skip

# The error states.
PHI, DV = var.phi_angle(FRAME), var.velocity_error(FRAME)
D_MOUNT = var.body("dmu", "dmu", "rad", "misalignment error, C_hat_b2m = (I - [dmu x]) C_b2m", -0.5, 0.5,
                   var.MASTER_BODY)  # fmt: skip


def expected(v_n: Matrix, q: Matrix, q_mount: Matrix, omega_ib_b: Matrix, lever_b: Matrix) -> tuple[Matrix, ...]:
    """Velocity and attitude (as a quaternion) that the master should report, and the rate of the body against n.

    The rate of the level is that at the estimated position and velocity: an error of 1 m/s turns it by 1.6e-7 rad/s.
    """
    omega_in = mechanization.omega_in_n(FRAME, POSITION.vector, V_N.vector)
    C_b2n = named("C_b2n", dcm_from_quaternion(q), "body to level")
    q_m2n = quaternion_product(q, conjugate(q_mount))
    return (
        FRAME.named("v_m_hat_n", paper.master_velocity(v_n, C_b2n, omega_in, omega_ib_b, lever_b),
                    "velocity expected of the master, m/s"),
        named("q_m_hat", q_m2n, "attitude expected of the master", "w x y z"),
        FRAME.named("omega_nb_n", C_b2n * omega_ib_b - omega_in, "rate of the body against the level, rad/s"),
    )  # fmt: skip


def true_state() -> tuple[Matrix, ...]:
    """The arguments of `expected` once the errors x are taken out of the estimates, by finite rotations."""
    q_phi = named("q_phi", quaternion_from_rotation_vector(PHI.vector), "of the rotation by phi", "w x y z")
    q_dmu = named("q_dmu", quaternion_from_rotation_vector(D_MOUNT.vector), "of the rotation by dmu", "w x y z")
    return (
        V_N.vector - DV.vector,
        named("q_true", quaternion_product(q_phi, Q.vector), "q_b2n_wxyz with phi taken out", "w x y z"),
        named("q_mount_true", quaternion_product(q_dmu, Q_MOUNT.vector), "q_b2m_wxyz with dmu taken out", "w x y z"),
        OMEGA_IB_B.vector + D_BG.vector,
        LEVER_B.vector,
    )


def velocity_residual(state: tuple[Matrix, ...], lag) -> Matrix:
    return paper.velocity_residual(expected(*state)[0], A_N.vector, lag, V_M.vector)


def dcm_residual(state: tuple[Matrix, ...], lag) -> Matrix:
    _, q_expected, omega_nb = expected(*state)
    return paper.attitude_residual(C_m_hat(q_expected), omega_nb, lag, C_m2n())


def C_m_hat(q_expected: Matrix) -> Matrix:
    made: Matrix = named("C_m_hat", dcm_from_quaternion(q_expected), "attitude expected of the master, body to level")
    return made


def C_m2n() -> Matrix:
    made: Matrix = named("C_m2n", dcm_from_quaternion(Q_M.vector), "attitude that the master reports, body to level")
    return made


def turned_back(state: tuple[Matrix, ...], lag) -> Matrix:
    """The expected attitude of the master, moved back by `lag` as a finite rotation, quaternion."""
    _, q_expected, omega_nb = expected(*state)
    q_lag = named("q_lag", quaternion_from_rotation_vector(omega_nb * lag), "of the rotation by omega_nb_n lag",
                  "w x y z")  # fmt: skip
    made: Matrix = named("q_m_lag", quaternion_product(conjugate(q_lag), q_expected), "q_m_hat, lag ago", "w x y z")
    return made


def quaternion_residual(state: tuple[Matrix, ...], lag) -> Matrix:
    """Twice the vector part, which grows up to 180 deg; that of the DCM falls again from 90 deg on."""
    residual = quaternion_product(turned_back(state, lag), conjugate(Q_M.vector))
    w, *xyz = named("q_z", residual, "turn from the reported attitude to the expected one", "w x y z")
    sign = Piecewise((-1, StrictLessThan(w, 0, evaluate=False)), (1, True))  # q and -q are one attitude
    return 2 * sign * Matrix(xyz)


def euler_residual(state: tuple[Matrix, ...], lag) -> Matrix:
    C_m_lag = named("C_m_lag", dcm_from_quaternion(turned_back(state, lag)), "attitude expected of the master, lag ago")
    return euler_from_dcm(C_m_lag) - EULER_M.vector


def velocity_attitude() -> Model:
    """Errors of attitude, velocity, both biases, misalignment and delay; the position is taken from the master."""
    noises = (
        var.GYRO_NOISE,
        var.ACCEL_NOISE,
        var.GYRO_BIAS_NOISE,
        var.ACCEL_BIAS_NOISE,
        var.noise_density("mu_noise", "rad/sqrt(s)", "the misalignment's random walk", 0.1, var.MASTER_BODY),
        variable("tau_noise", "tau_noise", "sqrt(s)", "noise density of the delay's random walk", 0, 0.1),
    )
    C_b2n = named("C_b2n", dcm_from_quaternion(Q.vector), "body to level")
    f_n = FRAME.named("f_n", C_b2n * F_B.vector, "specific force in the level, m/s^2")
    F = paper.transfer_matrix(POSITION.vector, V_N.vector, C_b2n, f_n)
    G = zeros(16)
    G[:6, :6] = -F[:6, 6:12]  # what a gyro or an accelerometer shows too much, minus what its bias' estimate does
    G[6:, 6:] = eye(10)

    now = (V_N.vector, Q.vector, Q_MOUNT.vector, OMEGA_IB_B.vector, LEVER_B.vector)
    lag, lag_true = LAG.scalar, LAG.scalar - D_TAU.scalar
    v_expected, q_expected, omega_nb = expected(*now)
    omega_in = mechanization.omega_in_n(FRAME, POSITION.vector, V_N.vector)
    omega_bn = FRAME.named(
        "omega_bn_n", omega_in - C_b2n * OMEGA_IB_B.vector, "rate of the level against the body, rad/s"
    )
    z_velocity, z_dcm = velocity_residual(now, lag), dcm_residual(now, lag)
    z_quaternion = quaternion_residual(now, lag)
    z_euler = euler_residual(now, lag)
    roll_m, pitch_m, yaw_m = EULER_M.symbols
    q_reported = Q_MOUNT.vector
    for axis in ((roll_m, 0, 0), (0, pitch_m, 0), (0, 0, yaw_m)):
        q_reported = quaternion_product(quaternion_from_rotation_vector(axis), q_reported)
    # the slave that will have turned back to this by the lag; its own attitude turns its rate, in the second order
    turning = dcm_from_quaternion(q_reported) * OMEGA_IB_B.vector - omega_in
    q_reporting = quaternion_product(quaternion_from_rotation_vector(turning * lag), q_reported)
    C_euler_m = named(
        "C_euler_m", dcm_from_euler(roll_m, pitch_m, yaw_m), "of the master's Euler angles, body to level"
    )
    euler_D_turn = (
        euler_D_beta(roll_m, pitch_m) * C_euler_m.T
    )  # of a turn in n; its pitch is in the box, so never singular

    v_true, q_true, q_mount_true, _, _ = true_state()
    return Model(
        name="velocity-attitude",
        c_prefix="va",
        title="transfer alignment by velocity and attitude with misalignment and delay, 16 states",
        frame=f"{FRAME.name} with body axes {FRAME.body}",
        states=(PHI, DV, D_BG, D_BA, D_MOUNT, D_TAU),
        structs=(
            Struct("nav", "what the slave carries and the filter corrects", (POSITION, V_N, Q, BG, BA, Q_MOUNT, TAU)),
            Struct("corrected_imu", "inertial data over one step, estimated biases removed", (F_B, OMEGA_IB_B, DT)),
            Struct("increments", "what the sensors deliver over one step, and over the step before", var.INCREMENTS),
            Struct("noise", "process noise", noises),
            Struct("mounting", "where the slave stands", (LEVER_B,)),
            Struct("master", "what the master reports", (V_M, Q_M, EULER_M, A_N, LAG)),
        ),
        F=F,
        G=G,
        noise=Matrix.vstack(*(n.vector for n in noises)),
        equations=("mechanics (alignment-1)",),
        dt=DT.scalar,
        measurements=(
            Measurement("velocity", FRAME.axes, "m/s", "velocity of the master: z = computed - measured",
                        z=z_velocity, h=z_velocity - velocity_residual(true_state(), lag_true),
                        H=paper.velocity_matrix(C_b2n, omega_in, OMEGA_IB_B.vector, LEVER_B.vector, A_N.vector),
                        first_order=FirstOrder(),
                        equations=("kang-2025 (1)", "kang-2025 (3)", "mechanics (alignment-2)")),
            Measurement("dcm", FRAME.axes, "rad", f"attitude of the master: z = -e, {var.TURN}",
                        z=z_dcm, h=z_dcm - dcm_residual(true_state(), lag_true),
                        # the expected attitude, not the reported one: noise in H would pass for motion of the hull
                        H=paper.attitude_matrix(C_m_hat(q_expected), omega_nb),
                        first_order=FirstOrder(small="lag", tied=(("q_m2n_wxyz", turned_back(now, lag)),)),
                        equations=("kang-2025 (4)", "kang-2025 (5)", "mechanics (alignment-3)")),
            Measurement("quaternion", FRAME.axes, "rad",
                        f"attitude of the master, twice the vector part of a quaternion: z = -e, {var.TURN}",
                        z=z_quaternion, h=z_quaternion - quaternion_residual(true_state(), lag_true)),
            Measurement("euler", ("roll", "pitch", "yaw"), "rad",
                        "Euler angles of the master: z = computed - measured", z=z_euler,
                        h=z_euler - euler_residual(true_state(), lag_true),
                        H=euler_D_turn * paper.attitude_matrix(C_euler_m, -omega_bn), angle=True,
                        first_order=FirstOrder(small="lag", tied=(("q_b2n_wxyz", q_reporting),)),
                        equations=("song-lee-2001 (13)",)),
        ),
        functions=(
            var.strapdown(FRAME, BG, BA),
            Function("expected", "what the master should report for this state of the slave", (
                Output("v_m_n", v_expected, "m/s", "velocity at the master", FRAME.name),
                Output("q_m2n_wxyz", normalized(q_expected), "1", "attitude of the master", f"master to {FRAME.name}"),
                Output("omega_nb_n", omega_nb, "rad/s", "rate of the body against the level", FRAME.name),
            ), ("kang-2025 (1)",)),
            Function("feedback", "the slave with the estimated errors taken out", (
                Output("v_n", v_true, "m/s", "velocity over the ground", FRAME.name),
                Output("q_b2n_wxyz", normalized(q_true), "1", "attitude, of unit norm", f"body to {FRAME.name}"),
                Output("gyro_bias", BG.vector - D_BG.vector, "rad/s", "gyro bias", "body"),
                Output("accel_bias", BA.vector - D_BA.vector, "m/s^2", "accelerometer bias", "body"),
                Output("q_b2m_wxyz", normalized(q_mount_true), "1", "mounting, of unit norm",
                       "slave body to master body"),
                Output("tau", TAU.vector - D_TAU.vector, "s", "age of the master's data"),
            )),
        ),
        card=(
            "Error = computed - true; C_hat_b2n = (I - [phi x]) C_b2n against the true level (phi model).",
            "Mounting: C_b2n = C_m2n C_b2m, of any size; C_hat_b2m = (I - [dmu x]) C_b2m, m the master's body axes.",
            "A bias is measured - true, and its error estimated - true.  The lever arm runs from master to slave.",
            "A delay tau > 0: the master's data is old by it.  The slave is given as it is now, with lag = tau, or as "
            "it was tau ago, with lag = 0.",
            *var.card(FRAME),
        ),
        mechanics=var.mechanics(FRAME, F_B.vector, biased=True,
                                driven=((noises[4], D_MOUNT), (noises[5], D_TAU))),
        unheld=(("expected", "it is what z compares with the master; each H is held against h, which is made of it"),),
    )  # fmt: skip
