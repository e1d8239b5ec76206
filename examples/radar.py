"""A radar that tracks a target on a winding path: range and bearing, which wraps at 180 degrees.

boresight generate radar.py:RADAR
boresight verify radar.py:RADAR
python fly_radar.py
"""

from sympy import Matrix, atan2, sqrt

from boresight import Measurement, Model, Struct, variable

# The target, seen from the radar: a total state, flown by f.
# It stays south of the radar, where the bearing wraps; at the radar itself a bearing has no value.
place = variable("place", "north east", "m, m", "place of the target", (-1e5, -1e5), (-10.0, 1e5))
velocity = variable("velocity", "v_north v_east", "m/s, m/s", "velocity of the target", -1000.0, 1000.0)
turn = variable("turn", "turn", "rad/s", "rate of turn, clockwise", -1.0, 1.0)

dt = variable("dt", "dt", "s", "length of the step", 1e-3, 2.0)
agility = variable(
    "agility", "along across", "m/s/sqrt(s), m/s/sqrt(s)", "noise density of the acceleration", 0.0, 50.0
)
turn_noise = variable("turn_noise", "turn_noise", "rad/s/sqrt(s)", "noise density of the rate of turn", 0.0, 0.1)

north, east = place.symbols
v_north, v_east = velocity.symbols
omega = turn.scalar

RADAR = Model(
    name="radar",
    c_prefix="rd",
    title="a target in the plane by range and bearing, 5 states",
    frame="north and east of the radar",
    states=(place, velocity, turn),
    structs=(Struct("step", "one step", (dt, agility, turn_noise)),),
    f=Matrix([v_north, v_east, -omega * v_east, omega * v_north, 0]),
    G=Matrix([
        [0, 0, 0],
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
    ]),
    noise=Matrix.vstack(agility.vector, turn_noise.vector),
    dt=dt.scalar,
    measurements=(
        Measurement("echo", ("range", "bearing"), "m, rad", "range and bearing, clockwise from north",
                    h=Matrix([sqrt(north**2 + east**2), atan2(east, north)]), angle=("bearing",)),
    ),
)  # fmt: skip
