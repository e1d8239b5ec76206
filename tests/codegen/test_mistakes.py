"""Mistakes in a user's model file, each through the command line: one line with the place, the thing and the remedy."""

from dataclasses import dataclass
from functools import cache

import pytest
from conftest import ROOT

from boresight import cli
from boresight.codegen import stamp

GOOD = """
from sympy import Matrix, Piecewise, Symbol, exp, nan, oo, pi, sin, sqrt

from boresight import Function, Measurement, Model, Output, Struct, constant, variable

angle = variable("angle", "theta", "rad", "angle from hanging down", -3.0, 3.0)
rate = variable("rate", "omega", "rad/s", "its rate", -20.0, 20.0)
rod = variable("rod", "length damping", "m, 1/s", "length and damping of the pendulum", (0.1, 0.0), (10.0, 1.0))
dt = variable("dt", "dt", "s", "length of the step", 1e-4, 0.2)
torque = variable("torque", "jitter", "rad/s/sqrt(s)", "root density of the acceleration", 0.0, 1.0)

theta, omega = angle.scalar, rate.scalar
length, damping = rod.symbols
g = constant("g", "9.81", "m/s^2", "gravity")

MODEL = Model(
    name="swing",
    c_prefix="sw",
    title="a pendulum, 2 states",
    frame="none",
    states=(angle, rate),
    structs=(Struct("plant", "the pendulum", (rod,)), Struct("step", "one step", (dt, torque))),
    f=Matrix([omega, -g / length * sin(theta) - damping * omega]),
    G=Matrix([0, 1]),
    noise=torque.vector,
    dt=dt.scalar,
    measurements=(Measurement("encoder", ("reading",), "rad", "the angle that is read", h=Matrix([theta])),),
    functions=(Function("height", "its height", (Output("rise", Matrix([sin(theta)]), "1", "over the length"),)),),
)
"""

ERROR_STATE = {
    "f=Matrix([omega, -g / length * sin(theta) - damping * omega])": "F=Matrix([[0, 1], [-g / length, -damping]])",
}


@dataclass(frozen=True)
class Mistake:
    """edits: text of the good file -> what stands there instead.  at: how the line begins that the message names.
    says: what the message holds besides."""

    name: str
    edits: dict[str, str]
    at: str
    says: tuple[str, ...]
    target: str = ":MODEL"


WHOLE = 'variable("rod", "length damping", "m, 1/s", "length and damping of the pendulum", (0.1, 0.0), (10.0, 1.0)'
F_LINE = "f=Matrix([omega, -g / length * sin(theta) - damping * omega])"
MODEL = "MODEL = Model("
ENCODER = "measurements=(Measurement("
HEIGHT = "functions=(Function("
RATE = 'rate = variable("rate"'
ANGLE = 'angle = variable("angle"'
TORQUE = 'torque = variable("torque"'
ROD = 'rod = variable("rod"'
G_LINE = "g = constant("


def mistake(name, old, new, at, *says, **more):
    return Mistake(name, {old: new}, at, says, **more)


def with_function(name, outputs):
    old = 'Function("height", "its height", (Output("rise", Matrix([sin(theta)]), "1", "over the length"),))'
    return {**ERROR_STATE, old: f'Function("{name}", "a test", ({outputs},))'}


F_OUTPUT = '(Output("rise", Matrix([sin(theta)]), "1", "over the length"),)'
MISTAKES = [
    mistake("struct of nothing", '"one step", (dt, torque)', '"one step", ()', "structs=", "fields is empty", "leave"),
    mistake("function of nothing", F_OUTPUT, "()", "functions=", "outputs is empty", "leave the function out"),
    mistake("output of nothing", "Matrix([sin(theta)])", "Matrix([])", "functions=", "value has no entry"),
    mistake("constant that is no number", '"9.81"', '"nan"', "g =", "the constant g is nan", "finite number"),
    mistake(
        "undefined Python name", "damping * omega]", "kappa * omega]", "f=Matrix", "NameError", "'kappa'", "define"
    ),
    mistake("misspelt Python name", "damping * omega]", "dampin * omega]", "f=Matrix", "did you mean 'damping'?"),
    mistake(
        "undeclared symbol", "damping * omega]", 'Symbol("kappa") * omega]', MODEL, "f[omega] uses kappa", "Struct"
    ),
    mistake("misspelt symbol", "damping * omega]", 'Symbol("dampng", real=True) * omega]', MODEL, "mean 'damping'?"),
    mistake("f of 3", F_LINE, "f=Matrix([omega, 1, 2])", MODEL, "f has shape (3, 1), not (2, 1)", "theta, omega"),
    mistake(
        "no noise of effect", "G=Matrix([0, 1])", "G=Matrix([0, 0])", MODEL, "noise jitter has no effect", "column 0"
    ),
    mistake(
        "frame that the name denies",
        WHOLE,
        WHOLE.replace('"rod"', '"rod_b"') + ', frame="NED"',
        "rod =",
        "its name ends in _b",
        "frame is 'NED'",
    ),
    mistake(
        "turn the other way",
        WHOLE,
        WHOLE.replace('"rod"', '"q_b2n"') + ', frame="NED to body"',
        "rod =",
        "its name takes b to n",
        "change one of them",
    ),
    Mistake(
        "no noise at all",
        {"G=Matrix([0, 1])": "G=Matrix(2, 0, [])", "noise=torque.vector": "noise=Matrix(0, 1, [])"},
        MODEL,
        ("give at least one noise",),
    ),
    Mistake(
        "state that nothing touches",
        {F_LINE: "f=Matrix([-theta, 0])", "G=Matrix([0, 1])": "G=Matrix([1, 0])"},
        RATE,
        ("the state omega has no dynamics and no noise", "leave it out"),
    ),
    mistake(
        "measurement of no state",
        "h=Matrix([theta])",
        "h=Matrix([length])",
        ENCODER,
        "depends on no state",
        "theta, omega",
    ),
    mistake(
        "H transposed", "h=Matrix([theta])", "H=Matrix([1, 0])", ENCODER, "H has shape (2, 1), not (1, 2)", "its .T"
    ),
    mistake(
        "field of C", '"rate", "omega"', '"double", "omega"', 'rate = variable("double"', "'double'", "choose another"
    ),
    mistake("field of the generated code", '"rate", "omega"', '"x", "omega"', 'rate = variable("x"', "'x'", "choose"),
    mistake("symbol int", "length damping", "length int", "rod = ", "symbol 'int'", "choose another"),
    mistake("symbol NULL", "length damping", "length NULL", "rod = ", "symbol 'NULL'", "choose another"),
    mistake("c_prefix of C", 'c_prefix="sw"', 'c_prefix="double"', MODEL, "c_prefix 'double'", "choose another"),
    mistake("struct of C", 'Struct("plant"', 'Struct("register"', "structs=", "'register'", "choose another"),
    mistake("measurement of C", 'Measurement("encoder"', 'Measurement("while"', ENCODER, "'while'", "choose another"),
    mistake(
        "measurement named F", 'Measurement("encoder"', 'Measurement("F"', ENCODER, "'F' is used twice", "every model"
    ),
    mistake("function named Phi", 'Function("height"', 'Function("Phi"', HEIGHT, "'Phi' is used twice", "every model"),
    mistake(
        "function as a measurement's", 'Function("height"', 'Function("encoder_h"', HEIGHT, "'encoder_h'", "encoder in"
    ),
    mistake("output of C", 'Output("rise"', 'Output("static"', HEIGHT, "'static'", "choose another"),
    mistake(
        "duplicate field",
        '"rate", "omega"',
        '"angle", "omega"',
        'rate = variable("angle"',
        "'angle' is used twice",
        ":6",
    ),
    mistake("duplicate symbol", '"rate", "omega"', '"rate", "theta"', RATE, "symbol name 'theta' is used twice", ":6"),
    mistake("duplicate but for case", '"rate", "omega"', '"rate", "Theta"', RATE, "'THETA' is used twice", ":6"),
    Mistake(
        "output beside NAME_nz",
        with_function(
            "turned", 'Output("up", Matrix([length]), "m", "up"), Output("up_nz", Matrix([damping]), "1/s", "more")'
        ),
        HEIGHT[:11],
        ("'up_nz'", "choose another"),
    ),
    mistake(
        "singular inside the box",
        "-g / length * sin(theta)",
        "g / length / theta",
        MODEL,
        "f[omega]",
        "theta = 0",
        "divides by theta",
        "-3 to 3",
        ":6",
        "narrow",
    ),
    mistake(
        "square singular inside the box",
        "-g / length * sin(theta)",
        "g / length / theta**2",
        MODEL,
        "theta = 0",
        "narrow",
    ),
    mistake(
        "root of a negative",
        "-g / length * sin(theta)",
        "g / length * sqrt(theta - 1)",
        MODEL,
        "f[omega]",
        "sqrt of theta - 1",
        "narrow",
    ),
    mistake(
        "measurement singular",
        "h=Matrix([theta])",
        "h=Matrix([theta * damping / (damping - omega)])",
        ENCODER,
        "h[reading]",
        "divides by",
        "damping",
        "narrow",
    ),
    mistake(
        "noise of no root", "G=Matrix([0, 1])", "G=Matrix([0, sqrt(sin(theta))])", MODEL, "G[omega, jitter]", "sqrt of"
    ),
    mistake(
        "output singular", "Matrix([sin(theta)])", "Matrix([damping / omega])", HEIGHT, "rise[0]", "omega = 0", "narrow"
    ),
    # units: what pint reads, and what every term must have
    mistake("unknown unit", '"rad/s", "its rate"', '"furlog/s", "its rate"', RATE, "'furlog'", "'furlong'", "m/s^2"),
    mistake(
        "unit that is not SI",
        '"rad/s", "its rate"',
        '"deg/s", "its rate"',
        RATE,
        "deg/s is 0.0174533 rad/s",
        "declare rad/s and convert",
    ),
    mistake("unit of other people", '"m, 1/s"', '"furlong, 1/s"', ROD, "furlong is 201.168 m", "declare m"),
    mistake("too many units", '"m, 1/s"', '"m, 1/s, s"', ROD, "3 units (m, 1/s, s) for 2 components", "one for each"),
    mistake(
        "one unit for two",
        '"m, 1/s"',
        '"m"',
        MODEL,
        "f[omega] adds",
        "damping*omega, which is rad*m/s",
        "g*sin(theta)/length, which is 1/s^2",
        "rad/s^2, omega per second",
    ),
    mistake(
        "box in degrees",
        "-3.0, 3.0",
        "-180, 180",
        ANGLE,
        "the box of theta goes to 180 rad, 28.6 turns",
        "radians(...)",
        "wide=True",
    ),
    mistake(
        "term of another dimension",
        "damping * omega]",
        "damping * theta]",
        MODEL,
        "f[omega] adds",
        "damping*theta, which is rad/s",
        "-g*sin(theta)/length, which is 1/s^2",
        "f[omega] is to be rad/s^2",
    ),
    mistake(
        "entry of another dimension",
        "f=Matrix([omega,",
        "f=Matrix([theta,",
        MODEL,
        "f[theta] is theta, which is rad, and not rad/s, theta per second",
    ),
    mistake("bare number", "-g / length", "-9.81 / length", MODEL, "which is 1/m", "9.81", "constant(...)"),
    mistake(
        "transposed F",
        F_LINE,
        "F=Matrix([[0, -g / length], [1, -damping]])",
        MODEL,
        "F[theta, omega]",
        "1/s^2",
        "F is transposed: give its .T",
    ),
    mistake(
        "noise per sample",
        '"rad/s/sqrt(s)"',
        '"rad/s"',
        TORQUE,
        "jitter is rad/s; the root density that drives omega has rad/s/sqrt(s)",
        "a sigma per sample is none: multiply it by the root of the sample time",
    ),
    mistake(
        "noise of another state",
        '"rad/s/sqrt(s)"',
        '"m/sqrt(s)"',
        TORQUE,
        "jitter is m/sqrt(s); the root density that drives omega has rad/s/sqrt(s)",
    ),
    mistake(
        "noise squared",
        "noise=torque.vector",
        "noise=Matrix([torque.scalar**2])",
        MODEL,
        "noise[jitter**2] is a square",
        "leave the square of jitter out",
    ),
    mistake("radians", '"rad/s", "its rate"', '"rads/s", "its rate"', RATE, "(did you mean 'rad/s'?)"),
    mistake(
        "a function of time",
        "f=Matrix([omega, ",
        "f=Matrix([__import__('sympy.physics.mechanics').physics.mechanics.dynamicsymbols('theta'), ",
        MODEL,
        "f[theta] holds theta(t), a function of t",
        "take its .scalar",
    ),
    mistake(
        "a matrix symbol",
        "f=Matrix([omega, ",
        "f=Matrix([__import__('sympy').MatrixSymbol('X', 2, 1)[1, 0], ",
        MODEL,
        "f[theta] holds X[1, 0], an entry of a MatrixSymbol",
        ".symbols",
    ),
    mistake(
        "one variable in two structs",
        'Struct("plant", "the pendulum", (rod,))',
        'Struct("plant", "the pendulum", (rod, dt))',
        "dt = variable(",
        "variable dt: it stands in struct plant and in struct step; leave it in one",
    ),
    mistake(
        "a state twice",
        "states=(angle, rate)",
        "states=(angle, rate, angle)",
        ANGLE,
        "it stands twice in the states",
    ),
    mistake(
        "a Jacobian of sign by hand",
        "h=Matrix([theta])",
        "H=Matrix([__import__('sympy').sign(omega - 1).diff(omega), 0]).T",
        ENCODER,
        "holds DiracDelta(omega - 1), the slope of a sign, which has none at 0",
        "give h and let H be derived",
    ),
    mistake(
        "a distance that may be zero",
        '"rad", "the angle that is read", h=Matrix([theta])',
        '"rad", "the angle that is read", h=Matrix([sqrt(theta**2 + (omega * dt.scalar)**2)])',
        ENCODER,
        "has no value inside the boxes",
        "write another form, as sqrt(Max(..., a constant))",
    ),
    mistake(
        "measurement of another dimension",
        "h=Matrix([theta])",
        "h=Matrix([theta * length])",
        ENCODER,
        "h[reading] is length*theta, which is rad*m, and not rad",
    ),
    mistake("degrees inside", "h=Matrix([theta])", "h=Matrix([theta * 180 / pi])", ENCODER, "pi/180", "at the border"),
    mistake(
        "angle that is no number",
        'sin(theta)]), "1"',
        'exp(theta)]), "1"',
        HEIGHT,
        "exp takes a number",
        "theta is rad",
    ),
    mistake(
        "length for an angle",
        'sin(theta)]), "1"',
        'sin(length)]), "1"',
        HEIGHT,
        "sin takes an angle or a number",
        "length is m",
    ),
    mistake("constant of an unknown unit", '"m/s^2", "gravity"', '"m/s^s", "gravity"', G_LINE, "constant g", "'m/s^s'"),
    mistake(
        "constant named as a symbol", 'constant("g"', 'constant("omega"', G_LINE, "constant omega", "its rate", "choose"
    ),
    mistake("nan", "damping * omega]", "nan * omega]", MODEL, "f[omega] holds nan", "not finite"),
    mistake("float nan", "damping * omega]", "float('nan') * omega]", MODEL, "f[omega] holds nan", "not finite"),
    mistake(
        "division by zero", "damping * omega]", "omega / (damping - damping)]", MODEL, "f[omega] holds zoo", "division"
    ),
    mistake("inf", "damping * omega]", "oo * omega]", MODEL, "f[omega] holds", "not finite"),
    mistake("inf in a box", "-20.0, 20.0", "float('-inf'), 20.0", RATE, "-inf to 20", "finite"),
    mistake("nan in a box", "-20.0, 20.0", "float('nan'), 20.0", RATE, "nan to 20", "finite"),
    mistake("box upside down", "-20.0, 20.0", "20.0, -20.0", RATE, "lower bound", "below"),
    mistake(
        "box of 3 for 2",
        "(0.1, 0.0), (10.0, 1.0)",
        "(0.1, 0.0, 0.0), (10.0, 1.0, 1.0)",
        "rod =",
        "2 components",
        "box of 3",
    ),
    mistake(
        "syntax error",
        "length, damping = rod.symbols",
        "length, damping = (rod.symbols",
        "length, damping",
        "never closed",
    ),
    mistake(
        "wrong import of Boresight",
        "from boresight import",
        "from boresight.model import",
        "from boresight.model",
        "as 'from boresight import Model, variable'",
    ),
    mistake("wrong import", "from sympy import", "from simpy import", "from simpy", "did you mean 'sympy'?"),
    mistake(
        "wrong name in an import",
        "import Function, Meas",
        "import Functions, Meas",
        "from boresight",
        "mean 'Function'?",
    ),
    mistake(
        "name of another module",
        "import Function, Meas",
        "import skew, Function, Meas",
        "from boresight",
        "in mechanics",
    ),
    mistake(
        "name with a space", 'name="swing"', 'name="My Swing"', MODEL, "lower-case words joined by '-'", "'my-swing'"
    ),
    mistake("dt forgotten", "    dt=dt.scalar,\n", "", MODEL, "dt is None", "give dt="),
    mistake("dt as a variable", "dt=dt.scalar", "dt=dt", MODEL, "dt is a Variable dt", ".scalar"),
    mistake("dt of no struct", "(dt, torque)", "(torque,)", MODEL, "dt is dt, which is no input", "Struct"),
    mistake(
        "G of wrong width", "G=Matrix([0, 1])", "G=Matrix([[0, 0], [1, 1]])", MODEL, "G has shape (2, 2), not (2, 1)"
    ),
    mistake("wrong keyword", 'c_prefix="sw"', 'prefix="sw"', MODEL, "'prefix'", "did you mean 'c_prefix'?"),
    mistake(
        "wrong keyword of variable", "-20.0, 20.0)", "-20.0, 20.0, wrap=True)", RATE, "'wrap'", "did you mean 'wraps'?"
    ),
    mistake("argument forgotten", '    title="a pendulum, 2 states",\n', "", MODEL, "missing 1 required", "'title'"),
    mistake("list for Matrix", F_LINE, "f=[omega, -sin(theta)]", MODEL, "f is a list", "Matrix([...])"),
    mistake("expression for Matrix", "h=Matrix([theta])", "h=theta", ENCODER, "h is a Symbol theta", "Matrix([...])"),
    mistake("numpy.sin", "* sin(theta) -", "* __import__('numpy').sin(theta) -", "f=", "TypeError", "from sympy"),
    mistake("math.sin", "* sin(theta) -", "* __import__('math').sin(theta) -", "f=", "TypeError", "from sympy"),
    mistake(
        "states without comma", "states=(angle, rate)", "states=(angle)", MODEL, "states is a Variable angle", "comma"
    ),
    mistake(
        "list of states", "states=(angle, rate)", "states=[angle, rate]", MODEL, "states is a list", "round brackets"
    ),
    mistake("fields without comma", "(rod,)", "(rod)", "structs=", "fields is a Variable rod", "comma"),
    mistake(
        "symbol as a state",
        "states=(angle, rate)",
        "states=(theta, omega)",
        MODEL,
        "states[0] is a Symbol theta",
        "variable",
    ),
    mistake("rows as a text", '("reading",)', '("reading")', ENCODER, "rows is 'reading', not a tuple", "('reading',)"),
    Mistake(
        "F of the state",
        {F_LINE: "F=Matrix([[0, 1], [-theta, 0]])"},
        MODEL,
        ("F[omega, theta] uses the state theta", "use f"),
    ),
    mistake(
        "own symbol",
        "damping * omega]",
        'damping * Symbol("omega")]',
        MODEL,
        "another omega",
        "declared as real",
        ".scalar",
        ":7",
    ),
    mistake("h and H", "h=Matrix([theta])", "h=Matrix([theta]), H=Matrix([[1, 0]])", ENCODER, "either h or H"),
    mistake("f and F", F_LINE, F_LINE + ", F=Matrix([[0, 1], [1, 0]])", MODEL, "given is F and f"),
    mistake(
        "condition on a symbol",
        "damping * omega]",
        "(omega if theta > 0 else damping)]",
        "f=",
        "truth value",
        "Piecewise",
    ),
    Mistake(
        "feedback of a wrong name",
        with_function("feedback", 'Output("rodd", Matrix([length, theta]), "m", "new rod")'),
        HEIGHT[:11],
        ("'rodd', which is no input", "did you mean 'rod'?"),
    ),
    Mistake(
        "feedback of a wrong size",
        with_function("feedback", 'Output("rod", Matrix([length]), "m", "new rod")'),
        HEIGHT[:11],
        ("shape (1, 1)", "(2, 1)"),
    ),
    mistake("called like a built-in", 'name="swing"', 'name="strapdown"', MODEL, "strapdown", "choose another name"),
    mistake("comment ended", '"its rate"', '"its rate */"', "rate =", "meaning", "comment in C"),
    mistake(
        "angle names no row", "h=Matrix([theta])", 'h=Matrix([theta]), angle=("readin",)', ENCODER, "mean 'reading'?"
    ),
    mistake(
        "function that C lacks", "* sin(theta) -", "* __import__('sympy').gamma(theta) -", MODEL, "f[omega]", "gamma"
    ),
    mistake("components in a list", '"rate", "omega"', '"rate", ["omega"]', RATE, "one text"),
    mistake("bounds as texts", "-20.0, 20.0", '"-20", "20"', RATE, "'-20'", "give a number"),
    mistake("scalar of two", "= rod.symbols", "= rod.scalar", "length, damping", "2 symbols", ".symbols"),
    mistake("bounds of an output", '"over the length")', '"over the length", low=(1.0,))', HEIGHT, "rise", "0 upper"),
    mistake("norm upside down", "(10.0, 1.0))", "(10.0, 1.0), norm=(2.0, 1.0))", "rod =", "norm", "least and the most"),
    mistake("norm outside", "(10.0, 1.0))", "(10.0, 1.0), norm=(20.0, 30.0))", "rod =", "norms are 0.1", "widen"),
    mistake("step backwards", "1e-4, 0.2", "-1.0, 0.2", 'dt = variable("dt"', "below zero"),
    mistake("rows of one name", '("reading",)', '("reading", "reading")', ENCODER, "one name"),
    mistake(
        "derivative left",
        "* sin(theta) -",
        "* __import__('sympy').Derivative(sin(theta), theta) -",
        MODEL,
        "f[omega] holds Derivative",
        "not evaluated",
    ),
    mistake("box of no float", "-20.0, 20.0", "-1e300, 1e300", RATE, "-1e+300", "float"),
    mistake("box without answers", "-20.0, 20.0", "1e-320, 2e-320", MODEL, "have an answer", "narrow"),
    mistake("no such NAME", "MODEL =", "MODEL =", "", "has no 'MODELL'", "did you mean 'MODEL'?", target=":MODELL"),
    mistake("not a Model", "MODEL =", "MODEL =", "", "is a Variable, not a Model", "MODEL", target=":angle"),
    mistake("no NAME", "MODEL =", "MODEL =", "", "its models are MODEL", target=""),
]


@pytest.fixture(scope="module", autouse=True)
def sources_stay():
    """Where a module of Boresight lies is looked up once, and not for each of a hundred files."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(stamp, "located", cache(stamp.located))
        yield


@pytest.fixture
def generate(tmp_path, capsys, monkeypatch):
    """`boresight generate` of a text, in an empty folder: status, output and error."""
    monkeypatch.chdir(tmp_path)

    def run(text, target=":MODEL"):
        (tmp_path / "swing.py").write_text(text)
        with pytest.raises(SystemExit) as ended:
            cli.main(["generate", f"swing.py{target}", "-o", "out"])
        return ended.value.code or 0, *capsys.readouterr()

    return run


@pytest.mark.parametrize("case", MISTAKES, ids=lambda case: case.name)
def test_a_mistake_is_one_line_with_its_place_and_what_to_do(generate, tmp_path, case):
    text = GOOD
    for old, new in case.edits.items():
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    status, out, error = generate(text, case.target)
    assert status == 1 and not out
    assert len(error.splitlines()) == 1, error
    if case.at:
        (line,) = [i for i, line in enumerate(text.splitlines(), 1) if line.strip().startswith(case.at)]
        assert error.startswith(f"boresight: swing.py:{line}: "), (line, error)
    for words in case.says:
        assert words in error, (words, error)
    assert "Traceback" not in error and "compiler" not in error
    assert {path.name for path in tmp_path.iterdir()} <= {"swing.py", "__pycache__"}


def test_the_file_without_a_mistake_is_generated(generate, tmp_path):
    status, _, error = generate(GOOD)
    assert (status, error) == (0, "")
    assert (tmp_path / "out" / "manifest.json").is_file()


def test_a_distance_that_is_kept_off_zero_passes(generate):
    near = '__import__("sympy").Max(theta**2 + (omega * dt.scalar)**2, constant("near", "1e-6", "rad^2", "least"))'
    status, _, error = generate(GOOD.replace("h=Matrix([theta])", f"h=Matrix([sqrt({near})])"))
    assert (status, error) == (0, "")


def test_the_messages_that_the_documentation_shows_are_those_that_are_given(generate):
    shown = " ".join((ROOT / "docs" / "own-model.md").read_text().split())
    for case in (one for one in MISTAKES if one.name in ("singular inside the box", "wrong keyword")):
        ((old, new),) = case.edits.items()
        _, _, error = generate(GOOD.replace(old, new))
        assert error.strip().replace("swing.py", "pendulum.py") in shown, error
