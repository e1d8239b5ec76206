"""Transfer alignment by velocity and DCM matching, ten states: Kim 2018, psi model in ENU."""

from dataclasses import replace

from sympy import Matrix, diag, eye, zeros

from boresight.derive.mechanics import error_models
from boresight.derive.mechanics.earth import ENU
from boresight.derive.mechanics.rotation import (
    dcm_from_quaternion,
    dcm_from_rotation_vector,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
)
from boresight.derive.model import FirstOrder, Function, Measurement, Model, Output, Struct
from boresight.derive.models import variables as var
from boresight.derive.models.variables import ACCEL_NOISE, D_MU, D_TAU, DT, GYRO_NOISE, MU, TAU
from boresight.derive.named import named
from boresight.derive.papers.kim_2018 import results as paper

F_B = replace(var.F_B, meaning="specific force")


def velocity_dcm() -> Model:
    """Errors of the slave's velocity and attitude (psi), of the misalignment and of the delay of the master's data."""
    frame = ENU
    position, v_n, q = var.position(frame), var.velocity(frame), var.attitude(frame)
    v_m, q_m = var.master_velocity(frame), var.master_attitude(frame)
    a_n = var.acceleration(frame, "acceleration over the ground")
    omega_nm = var.level(frame, "omega_nm_n", "omega_nm", "rad/s", "rate of the master's body against the level", 20.0)

    dv = replace(var.velocity_error(frame), meaning="error of the velocity against the true one carried into c")
    psi = var.psi_angle(frame)

    C_b2n = named("C_b2n", dcm_from_quaternion(q.vector), "body to level")
    C_m2n = named("C_m2n", dcm_from_quaternion(q_m.vector), "master body to level")
    f_n = frame.named("f_n", C_b2n * F_B.vector, "specific force in the level, m/s^2")
    F = paper.transfer_matrix(position.vector, v_n.vector, f_n)
    G = Matrix.vstack(error_models.noise_matrix(C_b2n)[3:, :], zeros(4, 6))

    # The paper's states are the mounting itself and the delay itself; ours are errors of estimates, computed - true.
    H = paper.transfer_measurement_matrix(C_m2n, a_n.vector, omega_nm.vector) * diag(eye(6), -eye(4))
    C_mu = named("C_mu", dcm_from_rotation_vector(MU.vector), "slave body to master body, by mu")
    z_dcm = paper.attitude_residual(C_m2n, C_mu, C_b2n)
    # The same once the errors are taken out of the slave's attitude, which is tau_hat old, and of the misalignment.
    C_lag = named("C_lag", dcm_from_rotation_vector(omega_nm.vector * D_TAU.scalar), "turn of the master over d_tau")
    C_psi = named("C_psi", dcm_from_rotation_vector(psi.vector), "of the rotation by psi")
    C_then = named("C_then", C_lag * C_psi * C_b2n, "C_b2n with psi and d_tau taken out")
    C_mu_true = named("C_mu_true", dcm_from_rotation_vector(MU.vector - D_MU.vector), "C_mu with dmu taken out")
    z_left = paper.attitude_residual(C_m2n, C_mu_true, C_then)
    q_m_hat = quaternion_product(q.vector, quaternion_from_rotation_vector(-MU.vector))
    q_next = quaternion_product(quaternion_from_rotation_vector(psi.vector), q.vector)
    return Model(
        name="velocity-dcm",
        c_prefix="vd",
        title="transfer alignment by velocity and DCM matching, 10 states",
        frame=f"{frame.name} with body axes {frame.body}",
        states=(dv, psi, D_MU, D_TAU),
        structs=(
            Struct("nav", "what the slave carries and the filter corrects", (position, v_n, q, MU, TAU)),
            Struct("corrected_imu", "inertial data over one step, estimated biases removed", (F_B, DT)),
            Struct("increments", "what the sensors deliver over one step, and over the step before", var.INCREMENTS),
            Struct("noise", "process noise", (GYRO_NOISE, ACCEL_NOISE)),
            Struct("master", "what the master reports, and the motion then", (v_m, q_m, a_n, omega_nm)),
        ),
        F=F,
        G=G,
        noise=Matrix.vstack(GYRO_NOISE.vector, ACCEL_NOISE.vector),
        dt=DT.scalar,
        measurements=(
            Measurement("velocity", frame.axes, "m/s",
                        "velocity of the slave tau_hat ago, where the master's is measured: z = computed - measured",
                        z=paper.velocity_residual(v_n.vector, v_m.vector),
                        h=dv.vector - a_n.vector * D_TAU.scalar,  # taken an error d_tau too early
                        H=H[:3, :], first_order=FirstOrder(),
                        equations=("kim-2018 (4)", "kim-2018 (6)")),
            Measurement("dcm", frame.axes, "rad",
                        f"attitude of the master, H to first order in the misalignment: z = +e, {var.TURN}",
                        z=z_dcm, H=H[3:, :],
                        first_order=FirstOrder("dcm_exact", small="mu", tied=(("q_m2n_wxyz", q_m_hat),)),
                        equations=("kim-2018 (5)", "kim-2018 (6)")),
            Measurement("dcm_exact", frame.axes, "rad",
                        f"attitude of the master, with h of finite rotations: z = +e, {var.TURN}", z=z_dcm,
                        h=z_dcm - z_left,
                        equations=("kim-2018 (5)",)),
        ),
        functions=(
            var.strapdown(frame),
            Function("feedback", "the slave with the estimated errors taken out", (
                Output("v_n", v_n.vector - dv.vector, "m/s", "velocity over the ground", frame.name),
                Output("q_b2n_wxyz", normalized(q_next), "1", "attitude, of unit norm", f"body to {frame.name}"),
                Output("mu", MU.vector - D_MU.vector, "rad", "misalignment", "master body"),
                Output("tau", TAU.vector - D_TAU.vector, "s", "age of the master's data"),
            )),
        ),
        equations=("kim-2018 (2)", "kim-2018 (3)"),
        card=(
            "Error = computed - true; psi is against the computed level, C_hat_b2c = (I - [psi x]) C_b2c.",
            "Misalignment: C_b2n = C_m2n exp([mu x]), m the master's body axes.",
            "A delay tau > 0: the master's data is old by it; the slave is compared as it was tau_hat ago.",
            *var.card(frame),
        ),
        mechanics=var.mechanics(frame, F_B.vector, computed_level=True),
    )  # fmt: skip
