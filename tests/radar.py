"""A target south of a radar that turns: angles that wrap in one row of two, and in a state; errors that depend on each
other; a range from so near that it is strongly nonlinear."""

from sympy import Matrix, atan2, sqrt

from boresight import Measurement, Model, Struct, variable

HALF_TURN = 3.141592653589793
TURN = (-4 * HALF_TURN, 4 * HALF_TURN)

place = variable("place", "east north", "m", "place of the target from the radar", (-1e4, -1e4), (1e4, -1.0))
speed = variable("speed", "v_east v_north", "m/s", "its velocity", -1e3, 1e3)
heading = variable("heading", "psi", "rad", "heading of the radar", -HALF_TURN, HALF_TURN, wraps=True)
dt = variable("dt", "dt", "s", "length of the step", 1e-4, 1.0)
gusts = variable("gusts", "gusts drift", "m/s/sqrt(s), rad/sqrt(s)", "root densities", 0.0, 10.0)
mount = variable("mount", "mount", "rad", "angle between the antenna and the compass", *TURN)

east, north = place.symbols
psi = heading.scalar
SEEN = Matrix([sqrt(east**2 + north**2), atan2(east, north) - psi])


def row(*places):
    return Matrix([[1 if j == i else 0 for j in range(5)] for i in places])


RADAR = Model(
    name="radar",
    c_prefix="rd",
    title="a target and a radar, 5 states",
    frame="east and north of the radar",
    states=(place, speed, heading),
    structs=(Struct("step", "one step", (dt, gusts)), Struct("antenna", "the antenna", (mount,))),
    f=Matrix([*speed.symbols, 0, 0, 0]),
    G=Matrix([[0] * 2] * 2 + [[1, 0], [1, 0], [0, 1]]),
    noise=gusts.vector,
    dt=dt.scalar,
    measurements=(
        Measurement("radar", ("range", "bearing"), "m, rad", "range and bearing", h=SEEN, angle=("bearing",)),
        Measurement(
            "smeared", ("range", "bearing"), "m, rad", "the same, with errors that depend on each other", h=SEEN,
            angle=("bearing",), correlated=True,
        ),
        Measurement("fix", ("east", "north"), "m", "the place as reported", H=row(0, 1), correlated=True),
        Measurement("compass", ("heading",), "rad", "the heading", H=row(4), angle=True),
        Measurement("mounted", ("heading",), "rad", "of the antenna", h=Matrix([psi + mount.scalar]), angle=True),
    ),
)  # fmt: skip
