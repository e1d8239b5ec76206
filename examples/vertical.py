"""The vertical channel: height and speed from an accelerometer, aided by a barometer; errors, corrected by feedback.

boresight generate vertical.py:VERTICAL
boresight verify vertical.py:VERTICAL
python fly_vertical.py
"""

from sympy import Matrix

from boresight import Function, Measurement, Mechanics, Model, Output, Struct, constant, variable

GRAVITY = constant("g", "9.81", "m/s^2", "gravity")

# What the navigation carries.
height = variable("height", "height", "m", "height", -500.0, 20000.0)
speed = variable("speed", "speed", "m/s", "speed, upwards", -300.0, 300.0)
bias = variable("bias", "bias", "m/s^2", "estimated bias of the accelerometer, measured - true", -1.0, 1.0)

# By what it errs: the state of the filter, computed - true.
d_height = variable("d_height", "d_height", "m", "error of the height", -500.0, 500.0)
d_speed = variable("d_speed", "d_speed", "m/s", "error of the speed", -50.0, 50.0)
d_bias = variable("d_bias", "d_bias", "m/s^2", "error of the bias, estimated - true", -1.0, 1.0)

# What it reads.
dv = variable("dv", "dv", "m/s", "integral of the measured specific force over the step", -50.0, 50.0)
dt = variable("dt", "dt", "s", "length of the step", 1e-3, 1.0)
accel_noise = variable("accel_noise", "accel_noise", "m/s/sqrt(s)", "noise density of the accelerometer", 0.0, 1.0)
bias_noise = variable("bias_noise", "bias_noise", "m/s^2/sqrt(s)", "noise density of the bias", 0.0, 0.1)
baro = variable("baro", "baro", "m", "height that the barometer reads", -1000.0, 21000.0)

h, v, b, step = height.scalar, speed.scalar, bias.scalar, dt.scalar

# One step of the navigation, exact for a constant specific force.
v_next = v + dv.scalar - (b + GRAVITY) * step
h_next = h + (v + v_next) / 2 * step

VERTICAL = Model(
    name="vertical",
    c_prefix="ve",
    title="height and speed aided by a barometer, 3 states",
    frame="upwards",
    states=(d_height, d_speed, d_bias),
    structs=(
        Struct("nav", "what is carried and corrected", (height, speed, bias)),
        Struct("imu", "one step", (dv, dt)),
        Struct("noise", "process noise", (accel_noise, bias_noise)),
        Struct("air", "what the barometer says", (baro,)),
    ),
    # A bias that is estimated too large leaves too little acceleration.
    F=Matrix([
        [0, 1, 0],
        [0, 0, -1],
        [0, 0, 0],
    ]),
    G=Matrix([
        [0, 0],
        [1, 0],
        [0, 1],
    ]),
    noise=Matrix([accel_noise.scalar, bias_noise.scalar]),
    dt=step,
    measurements=(
        Measurement("altitude", ("height",), "m", "height of the barometer: z = computed - measured",
                    z=Matrix([h - baro.scalar]), h=Matrix([d_height.scalar])),
    ),
    functions=(
        Function("strapdown", "height and speed one step later", (
            Output("height", Matrix([h_next]), "m", "height"),
            Output("speed", Matrix([v_next]), "m/s", "speed, upwards"),
        )),
        Function("feedback", "navigation with the estimated errors taken out", (
            Output("height", Matrix([h - d_height.scalar]), "m", "height"),
            Output("speed", Matrix([v - d_speed.scalar]), "m/s", "speed, upwards"),
            Output("bias", Matrix([b - d_bias.scalar]), "m/s^2", "bias of the accelerometer"),
        )),
    ),
    # `verify` adds the accelerometer's noise to dv, and holds F and G against strapdown and feedback.
    mechanics=Mechanics(driven=((accel_noise, dv),)),
    unheld=(("strapdown", "how this vehicle moves is stated by the model alone; F, G and Phi follow from it"),),
)  # fmt: skip
