"""Attitude and gyro bias from gyros, accelerometers and a magnetometer, twice.

boresight generate ahrs.py:SEVEN
boresight generate ahrs.py:SIX

SEVEN has the quaternion itself as a state, with its rate f: seven numbers, whose errors are six.
SIX says the same as errors: how the attitude is carried, how its error is taken out, what the sensors
should show.  No Jacobian is written in either; both give the same filter, up to how a step is taken.
"""

from sympy import Matrix, cos, eye, sin, zeros

from boresight import Function, Measurement, Mechanics, Model, Output, Struct, constant, variable
from boresight.mechanics import (
    dcm_from_quaternion,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
)

GRAVITY = constant("g", "9.81", "m/s^2", "gravity")

q = variable("q", "q_w q_x q_y q_z", "1", "attitude, body to NED", -1.001, 1.001, norm=(0.999, 1.001))
bias = variable("gyro_bias", "bg_x bg_y bg_z", "rad/s", "gyro bias, measured - true", -0.2, 0.2)

gyro = variable("gyro", "gyro_x gyro_y gyro_z", "rad/s", "angular rate, measured", -20.0, 20.0)
dt = variable("dt", "dt", "s", "length of the step", 1e-4, 0.1)
gyro_noise = variable("gyro_noise", "ng_x ng_y ng_z", "rad/sqrt(s)", "noise density of the gyros", 0.0, 0.1)
bias_noise = variable("bias_noise", "nb_x nb_y nb_z", "rad/s/sqrt(s)", "random walk of their biases", 0.0, 0.1)
dip = variable("dip", "dip", "rad", "of the magnetic field, down from the horizon", -1.5, 1.5)
accel = variable("accel", "accel_x accel_y accel_z", "m/s^2", "specific force, measured", -50.0, 50.0)
mag = variable("mag", "mag_x mag_y mag_z", "1", "direction of the magnetic field, measured", -2.0, 2.0)

rate = gyro.vector - bias.vector
C_n2b = dcm_from_quaternion(q.vector).T
force = -GRAVITY * C_n2b * Matrix([0, 0, 1])  # of a body that does not accelerate
field = C_n2b * Matrix([cos(dip.scalar), 0, sin(dip.scalar)])

common = {
    "frame": "NED with body axes front-right-down",
    "noise": Matrix.vstack(gyro_noise.vector, bias_noise.vector),
    "dt": dt.scalar,
}
imu = Struct("imu", "one step", (gyro, dt))
noise = Struct("noise", "process noise", (gyro_noise, bias_noise))
earth = Struct("earth", "its magnetic field", (dip,))


# ---------------------------------------------------------------- seven numbers


def by_rate(q, omega):
    """The rate of a quaternion of a body that turns by omega (3) in its own axes."""
    return quaternion_product(q, [0, *omega]) / 2


G = zeros(7, 6)
G[:4, :3] = Matrix.hstack(*(by_rate(q.vector, eye(3).col(i)) for i in range(3)))
G[4:, 3:] = eye(3)

SEVEN = Model(
    name="ahrs-seven",
    c_prefix="as",
    title="attitude as a quaternion and gyro bias, 7 states",
    states=(q, bias),
    structs=(imu, noise, earth),
    f=Matrix.vstack(by_rate(q.vector, rate), zeros(3, 1)),
    G=G,
    measurements=(
        Measurement("accelerometer", ("x", "y", "z"), "m/s^2", "specific force", h=force),
        Measurement("magnetometer", ("x", "y", "z"), "1", "direction of the magnetic field", h=field),
    ),
    **common,
)

# ---------------------------------------------------------------- six errors

theta = variable("theta", "th_n th_e th_d", "rad", "attitude error, C_hat = (I - [theta x]) C", -1.5, 1.5)
d_bias = variable("d_gyro_bias", "dbg_x dbg_y dbg_z", "rad/s", "error of the gyro bias, computed - true", -0.4, 0.4)

turned = quaternion_from_rotation_vector(rate * dt.scalar)
turned_back = quaternion_from_rotation_vector(theta.vector)

SIX = Model(
    name="ahrs-six",
    c_prefix="ax",
    title="the errors of attitude and gyro bias, 6 states",
    states=(theta, d_bias),
    structs=(
        Struct("nav", "what is estimated and corrected", (q, bias)),
        imu,
        noise,
        earth,
        Struct("sensors", "what is measured", (accel, mag)),
    ),
    measurements=(
        Measurement("accelerometer", ("x", "y", "z"), "m/s^2", "specific force: z = computed - measured",
                    z=force - accel.vector, at_zero=True),
        Measurement("magnetometer", ("x", "y", "z"), "1", "direction of the field: z = computed - measured",
                    z=field - mag.vector, at_zero=True),
    ),
    functions=(
        Function("strapdown", "the attitude a step later", (
            Output("q", normalized(quaternion_product(q.vector, turned)), "1", "attitude"),
        )),
        Function("feedback", "the estimates with their errors taken out", (
            Output("q", normalized(quaternion_product(turned_back, q.vector)), "1", "attitude"),
            Output("gyro_bias", bias.vector - d_bias.vector, "rad/s", "gyro bias"),
        )),
    ),
    mechanics=Mechanics(driven=((gyro_noise, gyro), (bias_noise, d_bias))),
    **common,
)  # fmt: skip
