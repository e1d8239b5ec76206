"""A fault that flies: F turns an attitude error that stands still.

boresight generate wrong_axes.py:WRONG
boresight verify wrong_axes.py:WRONG

`feedback` takes the error out in the axes of the level, C_hat = (I - [theta x]) C, where its rate is that of the
gyro bias alone.  F has -[C omega x] besides, as if the error stood in axes that turn with the body.  P is then turned
by the angle of each step, and after a quarter of a turn the uncertainty stands about another axis.  RIGHT leaves F
and G out: they follow from `strapdown` and `feedback`.
"""

from dataclasses import replace

from sympy import Matrix, eye, zeros

from boresight import Function, Measurement, Mechanics, Model, Output, Struct, variable
from boresight.mechanics import (
    dcm_from_quaternion,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
    skew,
)

q = variable("q", "q_w q_x q_y q_z", "1", "attitude, body to level", -1.001, 1.001, norm=(0.999, 1.001))
bias = variable("gyro_bias", "b_x b_y b_z", "rad/s", "gyro bias, measured - true", -0.2, 0.2)
theta = variable("theta", "th_n th_e th_d", "rad", "attitude error, C_hat = (I - [theta x]) C", -1.0, 1.0)
d_bias = variable("d_gyro_bias", "db_x db_y db_z", "rad/s", "error of the gyro bias, computed - true", -0.2, 0.2)

gyro = variable("gyro", "gyro_x gyro_y gyro_z", "rad/s", "angular rate, measured", -10.0, 10.0)
dt = variable("dt", "dt", "s", "length of the step", 1e-4, 0.1)
gyro_noise = variable("gyro_noise", "ng_x ng_y ng_z", "rad/sqrt(s)", "noise density of the gyros", 0.0, 0.1)
bias_noise = variable("bias_noise", "nb_x nb_y nb_z", "rad/s/sqrt(s)", "random walk of their biases", 0.0, 0.1)
star_n = variable("star_n", "s_n s_e s_d", "1", "direction of a star, in the level", -1.0, 1.0, norm=(0.999, 1.001))
star_b = variable("star_b", "m_x m_y m_z", "1", "direction of the star in the body, measured", -2.0, 2.0)

C = dcm_from_quaternion(q.vector)
omega = gyro.vector - bias.vector
turn = quaternion_from_rotation_vector(omega * dt.scalar)
turn_back = quaternion_from_rotation_vector(theta.vector)

RIGHT = Model(
    name="right-axes",
    c_prefix="ra",
    title="attitude and gyro bias",
    frame="a level with body axes front-right-down",
    states=(theta, d_bias),
    structs=(
        Struct("nav", "what is estimated and corrected", (q, bias)),
        Struct("imu", "one step", (gyro, dt)),
        Struct("noise", "process noise", (gyro_noise, bias_noise)),
        Struct("tracker", "what a star tracker delivers", (star_n, star_b)),
    ),
    noise=Matrix.vstack(gyro_noise.vector, bias_noise.vector),
    dt=dt.scalar,
    measurements=(
        Measurement("star", ("x", "y", "z"), "1", "direction of a star: z = computed - measured",
                    z=C.T * star_n.vector - star_b.vector, at_zero=True),
    ),
    functions=(
        Function("strapdown", "the attitude a step later", (
            Output("q", normalized(quaternion_product(q.vector, turn)), "1", "attitude"),
        )),
        Function("feedback", "the estimates with their errors taken out", (
            Output("q", normalized(quaternion_product(turn_back, q.vector)), "1", "attitude"),
            Output("gyro_bias", bias.vector - d_bias.vector, "rad/s", "gyro bias"),
        )),
    ),
    mechanics=Mechanics(driven=((gyro_noise, gyro), (bias_noise, d_bias))),
)  # fmt: skip

F = zeros(6)
F[:3, :3] = -skew(C * omega)  # the fault: this block is zero
F[:3, 3:] = C

WRONG = replace(RIGHT, name="wrong-axes", c_prefix="wa", F=F, G=Matrix.diag(-C, eye(3)))
