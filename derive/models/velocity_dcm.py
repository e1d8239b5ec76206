"""Transfer alignment by velocity and DCM matching, ten states: Kim 2018, psi model in ENU."""

from sympy import Matrix, diag, eye, zeros

from boresight.derive import error_models
from boresight.derive.earth import ENU
from boresight.derive.model import FirstOrder, Function, Measurement, Model, Output, Struct, Variable, variable
from boresight.derive.models.azimuth_hold import body, root_density
from boresight.derive.models.phi_error import per_axis
from boresight.derive.models.strapdown import attitude_variable, card, position_variable, velocity_variable
from boresight.derive.papers import kim_2018 as paper
from boresight.derive.rotation import (
    dcm_from_quaternion,
    dcm_from_rotation_vector,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
)


def velocity_dcm() -> Model:
    """Errors of the slave's velocity and attitude (psi), of the misalignment and of the delay of the master's data."""
    frame = ENU
    position, v_n, q = position_variable(frame), velocity_variable(frame), attitude_variable(frame)
    mu = body("mu", "mu", "rad", "estimated misalignment, C_b2n = C_r2n exp([mu x])", -0.5, 0.5)
    tau = variable("tau", "tau", "s", "estimated age of the master's data", -1.0, 1.0)
    f_b = body("f_b", "f", "m/s^2", "specific force", -500.0, 500.0)
    dt = variable("dt", "dt", "s", "length of the step", 1e-6, 10.0)
    gyro_noise = root_density("gyro_noise", "rad/sqrt(s)", "the gyros", 0.1)
    accel_noise = root_density("accel_noise", "m/s/sqrt(s)", "the accelerometers", 10.0)

    def level(name: str, letter: str, unit: str, meaning: str, limit: float) -> Variable:
        names = " ".join(f"{letter}_{axis}" for axis in frame.axes)
        return variable(name, names, unit, meaning, -limit, limit, frame=frame.name)

    v_r = level("v_r_n", "v_r", "m/s", "velocity that the master reports", 1000.0)
    a_n = level("a_n", "a", "m/s^2", "acceleration over the ground", 500.0)
    omega_nr = level("omega_nr_n", "omega_nr", "rad/s", "rate of the master's body against the level", 20.0)
    q_r = variable("q_r2n_wxyz", "q_r_w q_r_x q_r_y q_r_z", "1", "attitude that the master reports", -1.001, 1.001,
                   frame="master body to ENU", norm=(0.999, 1.001))  # fmt: skip

    dv = per_axis(frame, "dv_n", "dv", "m/s", "error of the velocity against the true one carried into c", 100.0)
    psi = per_axis(frame, "psi", "psi", "rad", "attitude error against the computed level c", 0.5)
    dmu = body("dmu", "dmu", "rad", "misalignment error, mu_hat - mu", -0.5, 0.5)
    dtau = variable("d_tau", "d_tau", "s", "error of the delay, tau_hat - tau", -1.0, 1.0)

    C_b2n, C_r2n = dcm_from_quaternion(q.vector), dcm_from_quaternion(q_r.vector)
    F = paper.transfer_matrix(position.vector, v_n.vector, C_b2n * f_b.vector)
    G = Matrix.vstack(error_models.noise_matrix(C_b2n)[3:, :], zeros(4, 6))

    # The paper's states are the mounting itself and the delay itself; ours are errors of estimates, computed - true.
    H = paper.transfer_measurement_matrix(C_r2n, a_n.vector, omega_nr.vector) * diag(eye(6), -eye(4))
    z_dcm = paper.attitude_residual(C_r2n, dcm_from_rotation_vector(mu.vector), C_b2n)
    # The same once the errors are taken out of the slave's attitude, which is tau_hat old, and of the misalignment.
    C_then = dcm_from_rotation_vector(omega_nr.vector * dtau.scalar) * dcm_from_rotation_vector(psi.vector) * C_b2n
    z_left = paper.attitude_residual(C_r2n, dcm_from_rotation_vector(mu.vector - dmu.vector), C_then)
    q_r_hat = quaternion_product(q.vector, quaternion_from_rotation_vector(-mu.vector))
    q_next = quaternion_product(quaternion_from_rotation_vector(psi.vector), q.vector)
    return Model(
        name="velocity-dcm",
        c_prefix="vd",
        title="transfer alignment by velocity and DCM matching, 10 states",
        frame=f"{frame.name} with body axes {frame.body}",
        states=(dv, psi, dmu, dtau),
        structs=(
            Struct("nav", "what the slave carries and the filter corrects", (position, v_n, q, mu, tau)),
            Struct("imu", "inertial data over one step", (f_b, dt)),
            Struct("noise", "process noise", (gyro_noise, accel_noise)),
            Struct("master", "what the master reports, and the motion then", (v_r, q_r, a_n, omega_nr)),
        ),
        F=F,
        G=G,
        noise=Matrix.vstack(gyro_noise.vector, accel_noise.vector),
        dt=dt.scalar,
        measurements=(
            Measurement("velocity", frame.axes, "m/s", "velocity of the slave, tau_hat ago, less the master's",
                        z=paper.velocity_residual(v_n.vector, v_r.vector), H=H[:3, :],
                        equations=("kim-2018 (4)", "kim-2018 (6)")),
            Measurement("dcm", frame.axes, "rad", "turn of the predicted attitude of the master from the reported one",
                        z=z_dcm, H=H[3:, :],
                        first_order=FirstOrder("dcm_exact", small="mu", tied=(("q_r2n_wxyz", q_r_hat),)),
                        equations=("kim-2018 (5)", "kim-2018 (6)")),
            Measurement("dcm_exact", frame.axes, "rad", "the same with finite rotations in its derivative", z=z_dcm,
                        h=z_dcm - z_left,
                        equations=("kim-2018 (5)",)),
        ),
        functions=(
            Function("feedback", "the slave with the estimated errors taken out", (
                Output("v_n", v_n.vector - dv.vector, "m/s", "velocity over the ground", frame.name),
                Output("q_b2n_wxyz", normalized(q_next), "1", "attitude, of unit norm", f"body to {frame.name}"),
                Output("mu", mu.vector - dmu.vector, "rad", "misalignment", "master body"),
                Output("tau", tau.vector - dtau.vector, "s", "age of the master's data"),
            )),
        ),
        equations=("kim-2018 (2)", "kim-2018 (3)"),
        card=(
            "Error = computed - true; psi is against the computed level, C_hat_b2c = (I - [psi x]) C_b2c.",
            "Misalignment: C_b2n = C_r2n exp([mu x]), r the master's body axes.",
            "A delay tau > 0: the master's data is old by it; the slave is compared as it was tau_hat ago.",
            *card(frame),
        ),
    )  # fmt: skip
