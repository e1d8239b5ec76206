"""A sonde that falls on a parachute below a kite: a model with every function that a kernel may use."""

from sympy import Abs, Matrix, Max, Min, Rational, acos, asin, atan, cosh, exp, log, sign, sinh, tanh

from boresight.derive.model import Function, Measurement, Model, Output, Struct, constant, variable

height = variable("height", "h", "m", "height above the sea", -400.0, 9000.0)
fall = variable("fall", "v", "m/s", "speed downward", -60.0, 60.0)
heat = variable("heat", "b", "K", "error of the thermometer", -30.0, 30.0)
air = variable("air", "beta tau", "1/m, s", "drag at the ground, correlation time", (1e-3, 1.0), (1e-2, 100.0))
dt = variable("dt", "dt", "s", "length of the step", 1e-3, 1.0)
gust = variable("gust", "gust drift", "m/s/sqrt(s), K/sqrt(s)", "root densities", 0.1, 1.0)

h, v, b = height.scalar, fall.scalar, heat.scalar
beta, tau = air.symbols
gravity = constant("g", "9.81", "m/s^2", "gravity")
thin = constant("h_air", 8500, "m", "height in which the air thins to 1/e")
warm = constant("T_0", "288.15", "K", "temperature at the sea")
lapse = constant("lapse", "0.0065", "K/m", "fall of the temperature")
pressure = constant("p_0", 101325, "Pa", "pressure at the sea")
pull = constant("a_brake", "0.3", "m/s^2", "deceleration of the brake")
slow, soft = constant("v_1", 2, "m/s", "where the brake works"), constant("v_2", 5, "m/s", "over which it sets in")
most = constant("v_3", 40, "m/s", "where the drag grows no more")
metre, kelvin, second = (constant(f"one_{u}", 1, u, "unit") for u in ("m", "K", "s"))
density = exp(-h / thin)
warmth = (warm - lapse * h) / warm
brake = pull * sign(v - slow) * tanh((v - slow) / soft)
own_h, own_v, own_b, own_tau = h / metre, v * second / metre, b / kelvin, tau / second

SONDE = Model(
    name="sonde",
    c_prefix="sn",
    title="a sonde on a parachute, 3 states",
    frame="none",
    states=(height, fall, heat),
    structs=(Struct("plant", "the sonde", (air,)), Struct("step", "one step", (dt, gust))),
    f=Matrix([-v, gravity - beta * density * v * Min(Abs(v), most) - brake, -b / tau]),
    G=Matrix([[0, 0], [1, 0], [0, 1]]),
    noise=gust.vector,
    dt=dt.scalar,
    measurements=(
        Measurement("baro", ("p",), "Pa", "pressure", h=Matrix([pressure * warmth ** Rational("5.2559")])),
        Measurement(
            "kite",
            ("sag", "pull", "lean", "turn", "bend", "flow"),
            "1",
            "the cable and the vanes",
            h=Matrix(
                [
                    cosh(own_h / 20000),
                    sinh(own_b / 10),
                    asin(own_v / 100),
                    acos(own_h / 10000),
                    atan(own_v * own_b / 99),
                    Max(own_v, 0, own_b),
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
                    Matrix([log(own_tau, 10), own_tau ** (beta * metre), 2**-own_tau]),
                    "1",
                    "of the correlation time",
                ),
            ),
        ),
    ),
)
