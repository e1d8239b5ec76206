"""A sonde that falls on a parachute below a kite: a model with every function that a kernel may use."""

from sympy import Abs, Matrix, Max, Min, acos, asin, atan, cosh, exp, log, sign, sinh, tanh

from boresight.derive.model import Function, Measurement, Model, Output, Struct, constant, variable

height = variable("height", "y", "m", "height above the sea", -400.0, 9000.0)
fall = variable("fall", "v", "m/s", "speed downward", -60.0, 60.0)
heat = variable("heat", "b", "K", "error of the thermometer", -30.0, 30.0)
air = variable("air", "beta tau", "1/m, s", "drag at the ground, correlation time", (1e-3, 1.0), (1e-2, 100.0))
dt = variable("dt", "dt", "s", "length of the step", 1e-3, 1.0)
gust = variable("gust", "gust drift", "m/s/sqrt(s), K/sqrt(s)", "root densities", 0.1, 1.0)

y, v, b = height.scalar, fall.scalar, heat.scalar
beta, tau = air.symbols
gravity = constant("g_0", "9.81", "m/s^2", "gravity")
thick = constant("thick", "8500", "m", "height in which the density falls to 1/e")
ground = constant("T_0", "288.15", "K", "temperature at the sea")
lapse = constant("lapse", "0.0065", "K/m", "by how much it falls with height")
power = constant("power", "5.2559", "1", "of the temperature, that the pressure goes with")
sea = constant("p_0", "101325", "Pa", "pressure at the sea")
slow, fast, fastest = (constant(f"v_{i}", value, "m/s", "a speed") for i, value in enumerate(("2", "5", "100")))
grip = constant("grip", "0.3", "m/s^2", "of the brake")
warm, top = constant("b_1", "10", "K", "a temperature"), constant("h_1", "20000", "m", "a height")
second = constant("t_1", "1", "s", "a second")

brake = grip * sign(v - slow) * tanh((v - slow) / fast)

SONDE = Model(
    name="sonde",
    c_prefix="sn",
    title="a sonde on a parachute, 3 states",
    frame="none",
    states=(height, fall, heat),
    structs=(Struct("plant", "the sonde", (air,)), Struct("step", "one step", (dt, gust))),
    f=Matrix([-v, gravity - beta * exp(-y / thick) * v * Min(Abs(v), fastest / 2) - brake, -b / tau]),
    G=Matrix([[0, 0], [1, 0], [0, 1]]),
    noise=gust.vector,
    dt=dt.scalar,
    measurements=(
        Measurement("baro", ("p",), "Pa", "pressure", h=Matrix([sea * ((ground - lapse * y) / ground) ** power])),
        Measurement(
            "kite",
            ("sag", "pull", "lean", "turn", "bend", "flow"),
            "1",
            "the cable and the vanes",
            h=Matrix(
                [
                    cosh(y / top),
                    sinh(b / warm),
                    asin(v / fastest),
                    acos(2 * y / top),
                    atan(v * b / fastest / warm),
                    Max(v / fastest, 0, b / warm),
                ]
            ),
        ),
    ),
    functions=(
        Function(
            "markov",
            "what is left of an error after the step, and what it gains",
            (
                Output("kept", Matrix([exp(-dt.scalar / tau)]), "1", "what is left"),
                Output("gained", Matrix([1 - exp(-2 * dt.scalar / tau)]), "1", "the variance that it gains"),
                Output(
                    "decades",
                    Matrix([log(tau / second, 10), (tau / second) ** (beta * thick / 100), 2 ** (-tau / second)]),
                    "1",
                    "of the correlation time",
                ),
            ),
        ),
    ),
)
