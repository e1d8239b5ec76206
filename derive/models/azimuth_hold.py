"""Azimuth hold by zero-velocity updates, fifteen states: Kim 2018, phi model in ENU."""

from sympy import Matrix, eye, zeros

from boresight.derive.mechanics import earth, error_models
from boresight.derive.mechanics.earth import ENU
from boresight.derive.mechanics.rotation import (
    dcm_from_quaternion,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
    skew,
)
from boresight.derive.model import FirstOrder, Function, Measurement, Model, Output, Struct
from boresight.derive.models import variables as var
from boresight.derive.models.variables import ACCEL_NOISE, BA, BG, D_BA, D_BG, DT, F_B, GYRO_NOISE, OMEGA_IB_B
from boresight.derive.named import named
from boresight.derive.papers.kim_2018 import results as paper


def azimuth_hold() -> Model:
    """Errors of position, velocity, attitude (phi), gyro and accelerometer bias; at rest, with a known azimuth."""
    frame = ENU
    position, v_n, q = var.position(frame), var.velocity(frame), var.attitude(frame)
    noises = (GYRO_NOISE, ACCEL_NOISE, var.GYRO_BIAS_NOISE, var.ACCEL_BIAS_NOISE)
    q_ref = var.quaternion("q_ref_wxyz", "q_ref", "attitude whose azimuth is held", "body to ENU")
    d_position, dv, phi = var.position_error(frame), var.velocity_error(frame), var.phi_angle(frame)

    C_b2n = named("C_b2n", dcm_from_quaternion(q.vector), "body to level")
    C_ref2n = named("C_ref2n", dcm_from_quaternion(q_ref.vector), "attitude whose azimuth is held, body to level")
    f_n = frame.named("f_n", C_b2n * F_B.vector, "specific force in the level, m/s^2")
    sensors = error_models.noise_matrix(C_b2n)  # of the errors of gyros and accelerometers, measured - true
    F = paper.hold_matrix(position.vector, v_n.vector, C_b2n, f_n)
    # The paper's bias is measured - true; what its estimate leaves of it is minus the estimate's error.
    F[:, 9:] = -F[:, 9:]
    G = zeros(15, 12)
    G[:9, :6] = sensors
    G[9:, 6:] = eye(6)

    lat, _ = frame.latitude_and_height(position.vector)
    omega_ie = earth.omega_ie_n(lat, frame)
    azimuth = paper.azimuth_error(C_b2n, C_ref2n.T)
    # At rest the gyros see the Earth turn, C_n2b omega_ie_n.
    zaru_H = zeros(3, 15)
    zaru_H[:, :3] = C_b2n.T * -error_models.omega_ie_by_position(frame, position.vector)
    zaru_H[:, 6:9] = C_b2n.T * skew(omega_ie)
    zaru_H[:, 9:12] = -eye(3)

    q_phi = named("q_phi", quaternion_from_rotation_vector(phi.vector), "of the rotation by phi", "w x y z")
    q_next = named("q_true", quaternion_product(q_phi, q.vector), "q_b2n_wxyz with phi taken out", "w x y z")
    # What the exact residuals lose when the errors are taken out.
    C_true = named("C_true", dcm_from_quaternion(q_next), "C_b2n with phi taken out")
    lat_true, _ = frame.latitude_and_height(position.vector - d_position.vector)
    azimuth_left = paper.azimuth_error(C_true, C_ref2n.T)
    rate_left = OMEGA_IB_B.vector + D_BG.vector - C_true.T * earth.omega_ie_n(lat_true, frame)
    rate = OMEGA_IB_B.vector - C_b2n.T * omega_ie
    corrected = var.nav_outputs(frame, position.vector - d_position.vector, v_n.vector - dv.vector, normalized(q_next))
    return Model(
        name="azimuth-hold",
        c_prefix="ah",
        title="azimuth hold by zero-velocity updates, 15 states",
        frame=f"{frame.name} with body axes {frame.body}",
        states=(d_position, dv, phi, D_BG, D_BA),
        structs=(
            Struct("nav", "what is carried and corrected", (position, v_n, q, BG, BA)),
            Struct("corrected_imu", "inertial data over one step, estimated biases removed", (F_B, OMEGA_IB_B, DT)),
            Struct("increments", "what the sensors deliver over one step, and over the step before", var.INCREMENTS),
            Struct("noise", "process noise", noises),
            Struct("reference", "what the alignment left", (q_ref,)),
        ),
        F=F,
        G=G,
        noise=Matrix.vstack(*(n.vector for n in noises)),
        dt=DT.scalar,
        measurements=(
            Measurement("zupt", frame.axes, "m/s",
                        "velocity of a body at rest, where zero is measured: z = computed - measured",
                        z=v_n.vector, H=paper.zero_velocity_matrix(),
                        equations=("kim-2018 (16)", "kim-2018 (17)", "kim-2018 (23)")),
            Measurement("azimuth", ("up",), "rad", f"azimuth, where the reference is measured: z = +e, {var.TURN}",
                        z=Matrix([azimuth]), h=Matrix([azimuth - azimuth_left]),
                        H=paper.hold_measurement_matrix()[3, :],
                        first_order=FirstOrder(tied=(("q_ref_wxyz", q.vector),)),
                        equations=("kim-2018 (20)", "kim-2018 (21)", "kim-2018 (23)")),
            Measurement("zaru", ("x", "y", "z"), "rad/s",
                        "rate against the Earth of a body at rest, where zero is measured: z = computed - measured",
                        z=rate, h=rate - rate_left, H=zaru_H, first_order=FirstOrder()),
        ),
        functions=(
            var.strapdown(frame, BG, BA),
            Function("feedback", "navigation with the estimated errors taken out", (
                *corrected,
                Output("gyro_bias", BG.vector - D_BG.vector, "rad/s", "gyro bias", "body"),
                Output("accel_bias", BA.vector - D_BA.vector, "m/s^2", "accelerometer bias", "body"),
            ), ("kim-2018 (27)", "kim-2018 (28)", "kim-2018 (29)")),
        ),
        equations=("kim-2018 (7)", "kim-2018 (9)", "kim-2018 (10)", "kim-2018 (11)"),
        card=(
            "Error = computed - true; C_hat = (I - [phi x]) C against the true level (phi model).",
            "A bias is measured - true, and its error estimated - true.",
            *var.card(frame),
        ),
        mechanics=var.mechanics(frame, F_B.vector, biased=True),
    )  # fmt: skip
