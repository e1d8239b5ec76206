"""Azimuth hold by zero-velocity updates, fifteen states: Kim 2018, phi model in ENU."""

from math import radians

from sympy import Matrix, eye, zeros

from boresight.derive import earth, error_models
from boresight.derive.earth import ENU
from boresight.derive.model import Function, Measurement, Model, Output, Struct, Variable, variable
from boresight.derive.models.phi_error import error_states, per_axis
from boresight.derive.models.strapdown import attitude_variable, card, position_variable, velocity_variable
from boresight.derive.papers import kim_2018 as paper
from boresight.derive.rotation import (
    dcm_from_quaternion,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
    skew,
)

GYRO_BIAS, ACCEL_BIAS = radians(1.0), 1.0  # rad/s (3600 deg/h) and m/s^2 (0.1 g)


def body(name: str, letter: str, unit: str, meaning: str, low: float, high: float) -> Variable:
    """A vector in body axes."""
    return variable(name, " ".join(f"{letter}_{axis}" for axis in "xyz"), unit, meaning, low, high, frame="body")


def root_density(name: str, unit: str, meaning: str, high: float) -> Variable:
    return body(name, name, unit, f"root power spectral density of {meaning}", 0.0, high)


def azimuth_hold() -> Model:
    """Errors of position, velocity, attitude (phi), gyro and accelerometer bias; at rest, with a known azimuth."""
    frame = ENU
    position, v_n, q = position_variable(frame), velocity_variable(frame), attitude_variable(frame)
    bg = body("gyro_bias", "bg", "rad/s", "estimated gyro bias, measured - true", -GYRO_BIAS, GYRO_BIAS)
    ba = body("accel_bias", "ba", "m/s^2", "estimated accelerometer bias, measured - true", -ACCEL_BIAS, ACCEL_BIAS)
    f_b = body("f_b", "f", "m/s^2", "specific force, bias removed", -500.0, 500.0)
    omega_ib = body("omega_ib_b", "omega", "rad/s", "angular rate, bias removed", -20.0, 20.0)
    dt = variable("dt", "dt", "s", "length of the step", 1e-6, 10.0)
    noises = (
        root_density("gyro_noise", "rad/sqrt(s)", "the gyros", 0.1),
        root_density("accel_noise", "m/s/sqrt(s)", "the accelerometers", 10.0),
        root_density("gyro_bias_noise", "rad/s/sqrt(s)", "the gyro biases' random walk", 0.1),
        root_density("accel_bias_noise", "m/s^2/sqrt(s)", "the accelerometer biases' random walk", 10.0),
    )
    q_ref = variable("q_ref_wxyz", "q_ref_w q_ref_x q_ref_y q_ref_z", "1", "attitude whose azimuth is held", -1.001,
                     1.001, frame="body to ENU", norm=(0.999, 1.001))  # fmt: skip

    dbg = body("d_gyro_bias", "dbg", "rad/s", "error of the gyro bias, estimated - true", -GYRO_BIAS, GYRO_BIAS)
    dba = body("d_accel_bias", "dba", "m/s^2", "error of the accelerometer bias, estimated - true", -ACCEL_BIAS,
               ACCEL_BIAS)  # fmt: skip
    states = error_states(
        frame,
        per_axis(frame, "dv_n", "dv", "m/s", "error of the velocity, v_hat - v", 100.0),
        per_axis(frame, "phi", "phi", "rad", "attitude error, C_hat = (I - [phi x]) C", 0.5),
    )

    C_b2n = dcm_from_quaternion(q.vector)
    sensors = error_models.noise_matrix(C_b2n)  # of the errors of gyros and accelerometers, measured - true
    F = paper.hold_matrix(position.vector, v_n.vector, C_b2n, C_b2n * f_b.vector)
    # The paper's bias is measured - true; what its estimate leaves of it is minus the estimate's error.
    F[:, 9:] = -F[:, 9:]
    G = zeros(15, 12)
    G[:9, :6] = sensors
    G[9:, 6:] = eye(6)

    lat, _ = frame.latitude_and_height(position.vector)
    omega_ie = earth.omega_ie_n(lat, frame)
    azimuth = paper.azimuth_error(C_b2n, dcm_from_quaternion(q_ref.vector).T)
    # At rest the gyros see the Earth turn, C_n2b omega_ie_n.
    zaru_H = zeros(3, 15)
    zaru_H[:, :3] = -C_b2n.T * error_models.omega_ie_by_position(frame, position.vector)
    zaru_H[:, 6:9] = C_b2n.T * skew(omega_ie)
    zaru_H[:, 9:12] = -eye(3)

    d_position, dv, phi = (block.vector for block in states)
    q_next = quaternion_product(quaternion_from_rotation_vector(phi), q.vector)
    order = ", ".join(frame.coordinates)
    return Model(
        name="azimuth-hold",
        c_prefix="ah",
        title="azimuth hold by zero-velocity updates, 15 states",
        frame=f"{frame.name} with body axes {frame.body}",
        states=(*states, dbg, dba),
        structs=(
            Struct("nav", "what is carried and corrected", (position, v_n, q, bg, ba)),
            Struct("imu", "inertial data over one step", (f_b, omega_ib, dt)),
            Struct("noise", "process noise", noises),
            Struct("reference", "what the alignment left", (q_ref,)),
        ),
        F=F,
        G=G,
        noise=Matrix.vstack(*(n.vector for n in noises)),
        dt=dt.scalar,
        measurements=(
            Measurement("zupt", frame.axes, "m/s", "velocity of a body at rest, which should be zero",
                        z=v_n.vector, H=paper.zero_velocity_matrix(),
                        equations=("kim-2018 (16)", "kim-2018 (17)")),
            Measurement("azimuth", ("up",), "rad", "turn of the attitude about up, against the reference",
                        z=Matrix([azimuth]), H=paper.hold_measurement_matrix()[3, :],
                        equations=("kim-2018 (20)", "kim-2018 (21)", "kim-2018 (23)")),
            Measurement("zaru", ("x", "y", "z"), "rad/s", "rate of a body at rest, less the Earth's",
                        z=omega_ib.vector - C_b2n.T * omega_ie, H=zaru_H),
        ),
        functions=(
            Function("feedback", "navigation with the estimated errors taken out", (
                Output("position", position.vector - d_position, position.unit, order, "WGS-84"),
                Output("v_n", v_n.vector - dv, "m/s", "velocity over the ground", frame.name),
                Output("q_b2n_wxyz", normalized(q_next), "1", "attitude, of unit norm", f"body to {frame.name}"),
                Output("gyro_bias", bg.vector - dbg.vector, "rad/s", "gyro bias", "body"),
                Output("accel_bias", ba.vector - dba.vector, "m/s^2", "accelerometer bias", "body"),
            ), ("kim-2018 (27)", "kim-2018 (28)", "kim-2018 (29)")),
        ),
        equations=("kim-2018 (9)", "kim-2018 (10)", "kim-2018 (11)"),
        card=(
            "Error = computed - true; C_hat = (I - [phi x]) C against the true level (phi model).",
            "A bias is measured - true, and its error estimated - true.",
            *card(frame),
        ),
    )  # fmt: skip
