"""A pendulum that is let go, and the encoder that reads its angle: a total state, flown by its own equation.

boresight generate pendulum.py:PENDULUM
boresight verify pendulum.py:PENDULUM
"""

from sympy import Matrix, pi, sin

from boresight import Measurement, Model, Struct, constant, variable

GRAVITY = constant("g", "9.81", "m/s^2", "gravity")
HALF_TURN = float(pi)

angle = variable("angle", "theta", "rad", "angle from hanging down", -HALF_TURN, HALF_TURN, wraps=True)
rate = variable("rate", "omega", "rad/s", "its rate", -20.0, 20.0)
rod = variable("rod", "length damping", "m, 1/s", "length and damping of the pendulum", (0.1, 0.0), (10.0, 1.0))
dt = variable("dt", "dt", "s", "length of the step", 1e-4, 0.2)
torque = variable("torque", "jitter", "rad/s/sqrt(s)", "root density of the angular acceleration", 0.0, 1.0)

theta, omega = angle.scalar, rate.scalar
length, damping = rod.symbols

PENDULUM = Model(
    name="pendulum",
    c_prefix="pd",
    title="a pendulum, 2 states",
    frame="none",
    states=(angle, rate),
    structs=(Struct("plant", "the pendulum", (rod,)), Struct("step", "one step", (dt, torque))),
    f=Matrix([omega, -GRAVITY / length * sin(theta) - damping * omega]),
    G=Matrix([0, 1]),
    noise=torque.vector,
    dt=dt.scalar,
    measurements=(
        Measurement("encoder", ("angle",), "rad", "the angle as the encoder reads it", h=Matrix([theta]), angle=True),
    ),
)
