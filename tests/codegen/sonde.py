"""A sonde that falls on a parachute below a kite: a model with every function that a kernel may use."""

from sympy import Abs, Matrix, Max, Min, Rational, acos, asin, atan, cosh, exp, log, sign, sinh, tanh

from boresight.derive.model import Function, Measurement, Model, Output, Struct, variable

height = variable("height", "h", "m", "height above the sea", -400.0, 9000.0)
fall = variable("fall", "v", "m/s", "speed downward", -60.0, 60.0)
heat = variable("heat", "b", "K", "error of the thermometer", -30.0, 30.0)
air = variable("air", "beta tau", "1/m, s", "drag at the ground, correlation time", (1e-3, 1.0), (1e-2, 100.0))
dt = variable("dt", "dt", "s", "length of the step", 1e-3, 1.0)
gust = variable("gust", "gust drift", "m/s/sqrt(s), K/sqrt(s)", "root densities", 0.1, 1.0)

h, v, b = height.scalar, fall.scalar, heat.scalar
beta, tau = air.symbols
density = exp(-h / 8500)
warmth = (Rational("288.15") - Rational("0.0065") * h) / Rational("288.15")
brake = Rational("0.3") * sign(v - 2) * tanh((v - 2) / 5)

SONDE = Model(
    name="sonde",
    c_prefix="sn",
    title="a sonde on a parachute, 3 states",
    frame="none",
    states=(height, fall, heat),
    structs=(Struct("plant", "the sonde", (air,)), Struct("step", "one step", (dt, gust))),
    f=Matrix([-v, Rational("9.81") - beta * density * v * Min(Abs(v), 40) - brake, -b / tau]),
    G=Matrix([[0, 0], [1, 0], [0, 1]]),
    noise=gust.vector,
    dt=dt.scalar,
    measurements=(
        Measurement("baro", ("p",), "hPa", "pressure", h=Matrix([Rational("1013.25") * warmth ** Rational("5.2559")])),
        Measurement(
            "kite",
            ("sag", "pull", "lean", "turn", "bend", "flow"),
            "1",
            "the cable and the vanes",
            h=Matrix([cosh(h / 20000), sinh(b / 10), asin(v / 100), acos(h / 10000), atan(v * b / 99), Max(v, 0, b)]),
        ),
    ),
    functions=(
        Function(
            "markov",
            "what is left of an error after the step, and what it gains",
            (
                Output("kept", Matrix([exp(-dt.scalar / tau)]), "1", "what is left"),
                Output("gained", Matrix([1 - exp(-2 * dt.scalar / tau)]), "1", "the variance that it gains"),
                Output("decades", Matrix([log(tau, 10), tau**beta, 2**-tau]), "1", "of the correlation time"),
            ),
        ),
    ),
)
