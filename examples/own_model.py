"""A model of one's own: the level of a leaking tank, and the error of the meter that reads it.

boresight generate examples/own_model.py:TANK
boresight verify examples/own_model.py:TANK
"""

from sympy import Matrix, sqrt

from boresight import Measurement, Model, Struct, constant, variable

level = variable("level", "depth", "m", "depth of the water", 0.01, 5.0)
meter = variable("meter", "offset", "m", "offset of the meter", -0.5, 0.5)
tank = variable("tank", "area drain", "m^2, m^2", "areas of the tank and of the leak", (0.5, 0.0), (5.0, 0.1))
dt = variable("dt", "dt", "s", "length of the step", 1e-3, 10.0)
inflow = variable("inflow", "inflow drift", "m/sqrt(s), m/sqrt(s)", "root densities of inflow and offset", 0.0, 0.1)

GRAVITY = constant("g", "9.81", "m/s^2", "gravity")

depth, offset = level.scalar, meter.scalar
area, drain = tank.symbols

TANK = Model(
    name="tank",
    c_prefix="tk",
    title="the level of a leaking tank, 2 states",
    frame="none",
    states=(level, meter),
    structs=(Struct("plant", "the tank", (tank,)), Struct("step", "one step", (dt, inflow))),
    # Torricelli: the leak runs at sqrt(2 g depth)
    f=Matrix([-drain / area * sqrt(2 * GRAVITY * depth), 0]),
    G=Matrix([[1, 0], [0, 1]]),
    noise=inflow.vector,
    dt=dt.scalar,
    measurements=(Measurement("reading", ("depth",), "m", "the meter's reading", h=Matrix([depth + offset])),),
)
