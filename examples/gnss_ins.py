"""GNSS/INS, loosely coupled: fifteen errors of an inertial navigation, corrected by fixes of an antenna.

boresight generate gnss_ins.py:GNSS_INS
boresight verify gnss_ins.py:GNSS_INS
python fly_gnss_ins.py

The antenna stands a lever arm away from the inertial sensors, and a fix arrives `lag` after its instant.
Change FRAME to ENU, and everything follows: state, F, G, measurements and C.
"""

from sympy import Matrix, eye, zeros

from boresight import NED, Function, Measurement, Model, Output, Struct, variable
from boresight import variables as var
from boresight.mechanics import (
    along,
    dcm_from_quaternion,
    displacement_by_position,
    metres,
    noise_matrix,
    normalized,
    omega_in_n,
    phi_matrix,
    quaternion_from_rotation_vector,
    quaternion_product,
    skew,
    small_rotation,
    velocity_rate,
)

FRAME = NED

# What the navigation carries, and by what it errs: error = computed - true, attitude C_hat = (I - [phi x]) C.
position, v_n, q = var.position(FRAME), var.velocity(FRAME), var.attitude(FRAME)
d_position, dv, phi = var.position_error(FRAME), var.velocity_error(FRAME), var.phi_angle(FRAME)

# What a fix brings.
lever = var.body("lever_b", "lever", "m", "lever arm, from the sensors to the antenna", -100.0, 100.0)
lag = variable("lag", "lag", "s", "age of the fix", 0.0, 1.0)
p_fix = var.position(FRAME)
p_fix = variable("p_fix", " ".join(f"{name}_fix" for name in FRAME.coordinates), p_fix.unit,
                 "position of the antenna", p_fix.low, p_fix.high, frame="WGS-84")  # fmt: skip
v_fix = var.level(FRAME, "v_fix_n", "v_fix", "m/s", "velocity of the antenna", 1000.0)

# ---------------------------------------------------------------- how the errors grow

C_b2n = dcm_from_quaternion(q.vector)
sensors = noise_matrix(C_b2n)  # what errors of gyros and accelerometers do

F = zeros(15)
F[:9, :9] = phi_matrix(FRAME, position.vector, v_n.vector, C_b2n * var.F_B.vector)
F[:9, 9:] = -sensors  # a bias that is estimated too large leaves too little

G = zeros(15, 12)
G[:9, :6] = sensors
G[9:, 6:] = eye(6)

noises = (var.GYRO_NOISE, var.ACCEL_NOISE, var.GYRO_BIAS_NOISE, var.ACCEL_BIAS_NOISE)

# ---------------------------------------------------------------- what the antenna does


def antenna(p, v, q, omega_ib_b, f_b):
    """Coordinates and velocity (m/s) of the antenna `lag` ago, from the navigation of now and the mean rates since.

    Gravity, Coriolis, the turn of the level and the radii are those of the estimate: its errors do not show in them.
    """
    C_b2n, age = dcm_from_quaternion(q), lag.scalar
    acceleration = velocity_rate(FRAME, position.vector, v_n.vector, C_b2n * f_b)
    omega_nb_b = omega_ib_b - C_b2n.T * omega_in_n(FRAME, position.vector, v_n.vector)

    C_then = C_b2n * small_rotation(-age * omega_nb_b)
    v_then = v - age * acceleration
    moved = C_then * lever.vector - age * (v + v_then) / 2  # m, from the sensors of now to the antenna of then
    lengths = metres(*FRAME.latitude_and_height(position.vector), FRAME)
    return p + along(FRAME, moved, lengths), v_then + C_then * skew(omega_nb_b) * lever.vector


def computed_minus_measured(*navigation):
    """Of the position (m) and the velocity (m/s) of the antenna, along the axes of the frame."""
    p, v = antenna(*navigation)
    return displacement_by_position(FRAME, p_fix.vector) * (p - p_fix.vector), v - v_fix.vector


computed = (position.vector, v_n.vector, q.vector, var.OMEGA_IB_B.vector, var.F_B.vector)
# The same once the errors are taken out, the attitude's by a finite rotation.
true = (
    position.vector - d_position.vector,
    v_n.vector - dv.vector,
    quaternion_product(quaternion_from_rotation_vector(phi.vector), q.vector),
    var.OMEGA_IB_B.vector + var.D_BG.vector,
    var.F_B.vector + var.D_BA.vector,
)
z_position, z_velocity = computed_minus_measured(*computed)
left_position, left_velocity = computed_minus_measured(*true)

GNSS_INS = Model(
    name="gnss-ins",
    c_prefix="gi",
    title="GNSS/INS with lever arm and delay, 15 states",
    frame=f"{FRAME.name} with body axes {FRAME.body}",
    states=(d_position, dv, phi, var.D_BG, var.D_BA),
    structs=(
        Struct("nav", "what is carried and corrected", (position, v_n, q, var.BG, var.BA)),
        Struct("corrected_imu", "inertial data, estimated biases removed", (var.F_B, var.OMEGA_IB_B, var.DT)),
        Struct("increments", "what the sensors deliver over one step, and over the step before", var.INCREMENTS),
        Struct("noise", "process noise", noises),
        Struct("fix", "what the receiver delivers", (p_fix, v_fix, lever, lag)),
    ),
    F=F,
    G=G,
    noise=Matrix.vstack(*(noise.vector for noise in noises)),
    dt=var.DT.scalar,
    measurements=(
        Measurement("position", FRAME.axes, "m", "position of the antenna: z = computed - measured",
                    z=z_position, h=z_position - left_position),
        Measurement("velocity", FRAME.axes, "m/s", "velocity of the antenna: z = computed - measured",
                    z=z_velocity, h=z_velocity - left_velocity),
    ),
    functions=(
        var.strapdown(FRAME, var.BG, var.BA),
        Function("antenna", "where the antenna was `lag` ago, and how fast", (
            Output("p_fix", antenna(*computed)[0], p_fix.unit, "position of the antenna", "WGS-84"),
            Output("v_fix_n", antenna(*computed)[1], "m/s", "velocity of the antenna", FRAME.name),
        )),
        Function("feedback", "navigation with the estimated errors taken out", (
            *var.nav_outputs(FRAME, *true[:2], normalized(true[2])),
            Output("gyro_bias", var.BG.vector - var.D_BG.vector, "rad/s", "gyro bias", "body"),
            Output("accel_bias", var.BA.vector - var.D_BA.vector, "m/s^2", "accelerometer bias", "body"),
        )),
    ),
    card=(
        "Error = computed - true; C_hat_b2n = (I - [phi x]) C_b2n against the true level (phi model).",
        "A bias is measured - true, and its error estimated - true.",
        *var.card(FRAME),
    ),
    mechanics=var.mechanics(FRAME, var.F_B.vector, biased=True),
    unheld=(("antenna", "it is what z compares with the fix; each H is the Jacobian of h, which is made of it"),),
)  # fmt: skip
