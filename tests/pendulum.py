"""A model that has nothing to do with navigation: a damped pendulum whose tip is seen from the side."""

from sympy import Matrix, sin

from boresight import Function, Measurement, Model, Output, Struct, constant, variable

swing = variable("swing", "angle rate", "rad, rad/s", "state of the pendulum", -3.0, 3.0)
plant = variable("plant", "length damping", "m, 1/s", "its length and damping", (0.1, 0.0), (10.0, 1.0))
dt = variable("dt", "dt", "s", "length of the step", 1e-4, 1.0)
push = variable("push", "push", "rad/s/sqrt(s)", "noise density of the gusts", 0.0, 1.0)
seen = variable("seen", "seen", "m", "where the tip is seen", -10.0, 10.0)

GRAVITY = constant("g", "9.81", "m/s^2", "gravity")
angle, rate = swing.symbols
length, damping = plant.symbols

ENERGY = Matrix([length**2 * rate**2 / 2 + 2 * GRAVITY * length * sin(angle / 2) ** 2])

PENDULUM = Model(
    name="pendulum",
    c_prefix="pd",
    title="a damped pendulum, 2 states",
    frame="the vertical plane of the swing",
    states=(swing,),
    structs=(
        Struct("plant", "the pendulum", (plant,)),
        Struct("step", "one step", (dt, push)),
        Struct("view", "what is seen", (seen,)),
    ),
    f=Matrix([rate, -GRAVITY / length * sin(angle) - damping * rate]),
    G=Matrix([0, 1]),
    noise=Matrix([push.scalar]),
    dt=dt.scalar,
    measurements=(
        Measurement("tip", ("horizontal",), "m", "horizontal place of the tip", h=Matrix([length * sin(angle)])),
    ),
    functions=(
        Function(
            "energy",
            "energy of the swing",
            (Output("energy", ENERGY, "J/kg", "energy"),),
        ),
    ),
)
