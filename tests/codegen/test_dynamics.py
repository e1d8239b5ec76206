"""What carries a state and its covariance over a step, against the equations that it is a step of."""

import importlib.util
import json
import re
from dataclasses import replace
from math import factorial

import numpy as np
import pytest
from building import STRICT, passed, run, self_test
from conftest import ROOT
from flint import arb
from scipy.integrate import solve_ivp
from sympy import Matrix, Rational, diag, lambdify, sin
from tools import tool

from boresight.codegen.functions.dynamics import left_of_Q
from boresight.codegen.functions.reference import precise
from boresight.codegen.functions.samples import sample
from boresight.codegen.functions.units import units
from boresight.codegen.generate import generate
from boresight.codegen.requirements import NUMBER
from boresight.derive.model import Measurement, Model, Struct, variable
from boresight.runtime.array import wrapped
from boresight.runtime.filter import CompiledFilter, Filter
from boresight.runtime.library import load


def example(name):
    """The Model of an example, whose module takes no name: that of the tests has the same."""
    spec = importlib.util.spec_from_file_location("example", ROOT / "examples" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return getattr(module, name.upper())


PENDULUM = example("pendulum")
AT = {"x": [2.0, 0.5], "rod": [1.0, 0.1], "torque": [0.1]}

dt = variable("dt", "dt", "s", "length of the step", 1e-4, 1.0)
spring = variable("spring", "k tau", "1/s^2, s", "stiffness, and memory of the push", (0.1, 0.5), (4.0, 5.0))
push = variable("push", "p_1 p_2", "m/s/sqrt(s), m/s^2/sqrt(s)", "root densities", 0.0, 1.0)
motion = variable("motion", "place speed force", "m, m/s, m/s^2", "errors of a mass on a spring", -10.0, 10.0)
k, tau = spring.symbols
place, speed, force = motion.symbols
STIFF = Matrix([[0, 1, 0], [-k, 0, 1], [0, 0, -1 / tau]])
SEEN = Measurement("seen", ("place",), "m", "where the mass is: z = computed - measured", H=Matrix([[1, 0, 0]]))
MASS = Model(
    name="mass",
    c_prefix="ms",
    title="a mass on a spring, 3 error states",
    frame="along the spring",
    states=(motion,),
    structs=(Struct("plant", "the spring", (spring,)), Struct("step", "one step", (dt, push))),
    F=STIFF,
    G=Matrix([[0, 0], [1, 0], [0, 1]]),
    noise=push.vector,
    dt=dt.scalar,
    measurements=(SEEN,),
)
# The same as a total state; and one whose noise grows with the state, along a way that turns.
WHOLE = replace(MASS, name="whole-mass", c_prefix="wm", title="a mass on a spring, 3 states", F=None,
                f=STIFF * motion.vector)  # fmt: skip
GUSTY = replace(WHOLE, name="gusty-mass", c_prefix="gm", f=Matrix([speed, force - k * sin(place), -force / tau]),
                G=Matrix([[sin(speed), 0], [1, place / 4], [place * speed / 8, 1]]))  # fmt: skip
# States that stay stand last; their noises have a part in common with each other and with that of one that moves.
drift = variable("drift", "b_1 b_2 b_3", "m/s^2", "constants that drive it", -1.0, 1.0)
SHARED = replace(
    MASS, name="shared-mass", c_prefix="sm", title="a mass on a spring and what drives it, 5 error states",
    states=(variable("motion", "place speed", "m, m/s", "errors of a mass on a spring", -10.0, 10.0), drift),
    F=Matrix([[0, 1, 0, 0, 0], [-k, -1 / tau, 1, 2, 0], *([[0] * 5] * 3)]),
    G=Matrix([[0, 0], [1, 0], [1 / tau, 2], [0, 1], [2 / tau, 0]]),
    measurements=(replace(SEEN, H=Matrix([[1, 0, 0, 0, 0]])),),
)  # fmt: skip
IN = {"x": [1.0, -2.0, 0.5], "spring": [2.0, 1.5], "push": [0.3, 0.7]}


MADE = {}


def printed(model, name, **fields):
    """What CasADi's function of a unit gives, as a matrix."""
    if (model.name, model.order) not in MADE:
        MADE[model.name, model.order] = {unit.name: unit for unit in units(model)}
    unit = MADE[model.name, model.order][name]
    out = np.zeros(unit.results[0].shape)
    values = np.array(unit.function(*(fields[a.name] for a in unit.args))).reshape(-1)
    for at, value in zip(unit.results[0].nonzeros, values, strict=True):
        out[at] = value
    return out


def integrated(model, seconds, **fields):
    """x, Phi and Q after `seconds`: x' = f(x), Phi' = F Phi, P' = F P + P F' + G W G' from SymPy's matrices."""
    n = model.n
    known = [s for v in model.inputs for s in v.symbols]
    given = [value for v in model.inputs for value in ([seconds] if v.name == "dt" else np.atleast_1d(fields[v.name]))]
    f = model.f if model.f is not None else model.F * model.x
    parts = lambdify([list(model.x), known], [f, f.jacobian(model.x), model.G * diag(*model.noise)])

    def rates(_, y):
        x, Phi, P = y[:n], y[n : n + n * n].reshape(n, n), y[n + n * n :].reshape(n, n)
        rate, F, L = parts(x, given)
        return np.concatenate([np.ravel(rate), (F @ Phi).ravel(), (F @ P + P @ F.T + L @ L.T).ravel()])

    begin = np.concatenate([fields["x"], np.eye(n).ravel(), np.zeros(n * n)])
    y = solve_ivp(rates, (0, seconds), begin, method="DOP853", rtol=1e-12, atol=1e-15).y[:, -1]
    return y[:n], y[n : n + n * n].reshape(n, n), y[n + n * n :].reshape(n, n)


def errors(model, name, steps, **fields):
    """How far a unit is from the integrated equation, for each length of the step."""
    place = ("next", "Phi", "Q").index(name)
    exact = [integrated(model, h, **fields)[place] for h in steps]
    got = [printed(model, name, dt=h, **fields) for h in steps]
    return np.array([np.abs(a.reshape(b.shape) - b).max() for a, b in zip(got, exact, strict=True)])


def orders(off):
    """The power of the step with which errors fall, from one halving to the next."""
    return np.log2(off[:-1] / off[1:])


HALVED = (0.1, 0.05, 0.025)


# ---- a total state


@pytest.mark.parametrize(("model", "fields"), [(PENDULUM, AT), (WHOLE, IN), (GUSTY, IN)], ids=lambda v: str(v)[:9])
def test_next_and_phi_err_by_the_fifth_power_of_a_step_and_q_by_the_fourth(model, fields):
    """So over a given time next is of fourth order and Q of third, for an F that stands and for one that moves."""
    assert orders(errors(model, "next", HALVED, **fields)) == pytest.approx([5, 5], abs=0.35)
    assert orders(errors(model, "Phi", HALVED, **fields)) == pytest.approx([5, 5], abs=0.35)
    assert orders(errors(model, "Q", HALVED, **fields)) == pytest.approx([4, 4], abs=0.35)


def test_phi_of_a_pendulum_is_ten_thousand_times_nearer_than_that_of_its_start():
    _, exact, _ = integrated(PENDULUM, 0.05, **AT)
    F = printed(PENDULUM, "F", **AT)
    A = F * 0.05
    off = np.abs(printed(PENDULUM, "Phi", dt=0.05, **AT) - exact).max()
    at_start = np.abs(np.eye(2) + A + A @ A / 2 - exact).max()
    assert off == pytest.approx(3.2e-7, rel=0.05) and at_start == pytest.approx(4.3e-3, rel=0.05)


@pytest.mark.parametrize(("model", "fields"), [(PENDULUM, AT), (GUSTY, IN)], ids=lambda v: str(v)[:9])
def test_phi_is_the_derivative_of_next(model, fields):
    """Against differences of the reference of next, in balls of 80 digits."""
    printed(model, "next", dt=0.05, **fields)
    unit = MADE[model.name, model.order]["next"]
    small = arb((1, -100))
    with precise():
        for j in range(model.n):
            x = [arb(v) for v in fields["x"]]
            ends = []
            for sign in (1, -1):
                moved = [v + sign * small * (i == j) for i, v in enumerate(x)]
                ends.append(unit.reference({**fields, "dt": [0.05], "x": moved})[0])
            slope = [float((ends[0][i, 0] - ends[1][i, 0]) / (2 * small)) for i in range(model.n)]
            assert printed(model, "Phi", dt=0.05, **fields)[:, j] == pytest.approx(slope, rel=1e-13, abs=1e-15)


@pytest.mark.parametrize("model", [PENDULUM, GUSTY], ids=lambda m: m.name)
def test_q_is_a_covariance_to_the_bit_wherever_it_is_taken(model):
    printed(model, "Q", dt=0.05, **(AT if model is PENDULUM else IN))
    unit = MADE[model.name, model.order]["Q"]
    drawn = sample(unit.args, 0, 300, np.random.default_rng(2))
    for point in zip(*drawn, strict=True):
        Q = printed(model, "Q", **{a.name: value for a, value in zip(unit.args, point, strict=True)})
        assert Q.tobytes() == Q.T.copy().tobytes()
        sigma = np.sqrt(np.diag(Q))
        assert np.linalg.eigvalsh(Q / np.outer(sigma, sigma)).min() > -1e-15 * model.n


# ---- an error state


@pytest.mark.parametrize("order", [1, 2, 3])
def test_phi_and_q_of_an_error_state_are_exact_to_their_order_of_a_standing_F(order):
    model = replace(MASS, order=order)
    assert orders(errors(model, "Phi", HALVED, **IN)) == pytest.approx([order + 1] * 2, abs=0.35)
    assert orders(errors(model, "Q", HALVED, **IN)) == pytest.approx([order + 2] * 2, abs=0.35)


@pytest.mark.parametrize("order", [1, 2, 3])
def test_what_q_leaves_out_of_the_integral_is_what_the_header_says(order):
    """The lowest power of dt of the difference, in numbers that follow the sentence itself."""
    model, h = replace(MASS, order=order), 2.0**-9
    _, _, exact = integrated(model, h, **IN)
    A = printed(model, "F", **IN) * h
    W = np.diag([0, IN["push"][0] ** 2, IN["push"][1] ** 2]) * h
    sentence = re.sub(r"A'\^(\d)", r"P(A, \1).T", left_of_Q(order)).replace("A'", "A.T")
    sentence = re.sub(r"A\^(\d)", r"P(A, \1)", sentence)
    said = eval(re.sub(r"(?<=[AWT)]) (?=[AWP])", " @ ", sentence), {"A": A, "W": W, "P": np.linalg.matrix_power})
    left = exact - printed(model, "Q", dt=h, **IN)
    assert np.abs(left - said).max() < 0.02 * np.abs(said).max()


@pytest.mark.parametrize("order", [1, 2, 3])
def test_q_is_a_covariance_however_long_the_step_is(order):
    """Where the cut series of the integral, which errs by the same power of dt, has lost it."""
    model = replace(MASS, order=order)
    stiff = {"x": IN["x"], "spring": [4.0, 0.1], "push": [0.3, 0.7]}
    F, S = printed(model, "F", **stiff), np.diag([0, 0.3**2, 0.7**2])
    least, of_series = [], []
    for h in (0.1, 0.3, 1.0):
        series, grown = 0, S * h
        for i in range(1, order + 2):
            series, grown = series + grown / factorial(i), (F @ grown + (F @ grown).T) * h
        for Q, kept in ((printed(model, "Q", dt=h, **stiff), least), (series, of_series)):
            kept.append(np.linalg.eigvalsh(Q)[0] / np.trace(np.abs(Q)))
    assert min(least) > -1e-15 and min(of_series) < -1e-4


@pytest.mark.parametrize("order", [1, 2, 3])
def test_a_covariance_of_rank_one_stays_one_where_a_series_of_its_equation_makes_it_indefinite(order):
    """P' = F P + P F' along a chain, P of rank one, by Phi P Phi' and by the series of the same order."""
    F, dt = printed(replace(MASS, order=order), "F", **IN), 0.1
    Phi = printed(replace(MASS, order=order), "Phi", dt=dt, **IN)
    P = np.outer([1.0, -2.0, 3.0], [1.0, -2.0, 3.0])
    series, grown = P, P
    for i in range(1, order + 1):
        grown = (F @ grown + (F @ grown).T) * dt
        series = series + grown / factorial(i)
    assert np.linalg.eigvalsh(series)[0] < -1e-5 * np.trace(P)
    assert np.linalg.eigvalsh(Phi @ P @ Phi.T)[0] > -1e-15 * np.trace(P)


@pytest.mark.parametrize("order", [1, 2, 3])
def test_of_an_f_that_moves_every_order_leaves_out_half_its_rate_times_the_square_of_the_step(order):
    model, h, rate = replace(MASS, order=order), 2.0**-10, np.array([[0, 0, 0], [3.0, 0, 0], [0, 0, 0]])
    F = printed(model, "F", **IN)
    y = solve_ivp(
        lambda t, y: ((F + rate * t) @ y.reshape(3, 3)).ravel(),
        (0, h),
        np.eye(3).ravel(),
        "DOP853",
        rtol=1e-12,
        atol=1e-15,
    ).y[:, -1]
    left = (y.reshape(3, 3) - printed(model, "Phi", dt=h, **IN)) / (h * h / 2)
    assert left == pytest.approx(rate + (F @ F if order == 1 else 0), abs=20 * h)


def generated(model, order, folder):
    """The folder of a model of this module, its Phi taken to another order."""
    folder.mkdir()
    (folder / "mine.py").write_text(
        f"from dataclasses import replace\nimport sys\nsys.path.insert(0, {str(ROOT / 'tests' / 'codegen')!r})\n"
        f"import test_dynamics\nMODEL = replace(test_dynamics.{model}, order={order})\n"
    )
    generate(f"{folder / 'mine.py'}:MODEL", folder / "out")
    return folder / "out"


@pytest.fixture(scope="module", params=[1, 3])  # the built-in models are of order 2
def ordered(request, compiled_once, tmp_path_factory):
    return request.param, generated("MASS", request.param, tmp_path_factory.mktemp("ordered") / "mass")


def test_the_loops_in_c_carry_what_the_printed_phi_and_q_say(ordered):
    library = load(ordered[1])
    loops = [kind(library, {}, np.diag([0.1, 0.2, 0.3])) for kind in (Filter, CompiledFilter)]
    for loop in loops:
        loop.x = np.array([1.0, 2.0, 3.0])
        for _ in range(5):
            loop.predict(spring=IN["spring"], push=IN["push"], dt=0.5)
    assert pytest.approx(loops[0].P, rel=1e-13) == loops[1].P
    assert loops[1].x == pytest.approx(loops[0].x, rel=1e-13)


# MASS is of orders 1 and 3
@pytest.mark.parametrize(("order", "form"), [(2, 0), (3, 1)])
def test_noises_in_common_of_states_that_stay_are_carried_in_both_forms(order, form, compiled_once, tmp_path):
    """discretize and both predicts against Phi P Phi' + Q of the printed units, and the self-test."""
    folder = generated("SHARED", order, tmp_path / "shared")
    assert "#define SM_N_MOVING 2 " in (folder / "include" / "shared_mass_covariance.h").read_text()
    done = self_test(folder, tmp_path, *STRICT, "-O0", f"-DBORESIGHT_UD={form}")
    assert (done.returncode, done.stdout.splitlines()[-1]) == (0, passed(folder)), done.stdout + done.stderr
    library = load(folder)
    loops = [kind(library, {}, np.diag([0.1, 0.2, 0.3, 0.4, 0.5])) for kind in (Filter, CompiledFilter)]
    for loop in loops:
        for _ in range(5):
            loop.predict(spring=IN["spring"], push=IN["push"], dt=0.5)
    assert pytest.approx(loops[0].P, rel=1e-12) == loops[1].P


def test_the_self_test_knows_the_order(ordered, tmp_path):
    done = self_test(ordered[1], tmp_path, *STRICT, "-O0", *(["-DBORESIGHT_FLOAT"] if ordered[0] == 3 else []))
    assert (done.returncode, done.stdout.splitlines()[-1]) == (0, passed(ordered[1])), done.stdout + done.stderr


COUNTED = """
#define BORESIGHT_H
#include <math.h>
#include <stddef.h>
static long operations;
struct bs_real {
    double v;
    bs_real(double value = 0.0) : v(value) {}
    explicit operator bool() const { return v != 0.0; }
};
static bs_real operator+(bs_real a, bs_real b) { ++operations; return a.v + b.v; }
static bs_real operator-(bs_real a, bs_real b) { ++operations; return a.v - b.v; }
static bs_real operator-(bs_real a) { return -a.v; }
static bs_real operator*(bs_real a, bs_real b) { ++operations; return a.v * b.v; }
static bs_real operator/(bs_real a, bs_real b) { ++operations; return a.v / b.v; }
static bs_real &operator+=(bs_real &a, bs_real b) { ++operations; a.v += b.v; return a; }
static bs_real &operator-=(bs_real &a, bs_real b) { ++operations; a.v -= b.v; return a; }
static bs_real &operator*=(bs_real &a, bs_real b) { ++operations; a.v *= b.v; return a; }
static bs_real &operator/=(bs_real &a, bs_real b) { ++operations; a.v /= b.v; return a; }
static bool operator>(bs_real a, bs_real b) { return a.v > b.v; }
static bool operator<(bs_real a, bs_real b) { return a.v < b.v; }
static bool operator>=(bs_real a, bs_real b) { return a.v >= b.v; }
static bool operator<=(bs_real a, bs_real b) { return a.v <= b.v; }
#define BS_REAL(x) bs_real(x)
#define BS_SQRT(a) bs_real(sqrt((a).v))
#define BS_FABS(a) bs_real(fabs((a).v))
#define BS_INSIDE static
#define BS_EXACT_BEGIN
#define BS_EXACT_END
static bool bs_is_finite(bs_real a) { return a.v - a.v == 0.0; }
static bool isgreaterequal(bs_real a, bs_real b) { return a.v >= b.v; }
static bool islessequal(bs_real a, bs_real b) { return a.v <= b.v; }
enum bs_status { BS_OK, BS_NULL_POINTER, BS_NOT_FINITE, BS_OUT_OF_RANGE, BS_NOT_READY, BS_NOT_POSITIVE, BS_AT_CEILING };
bs_status bs_check_finite(const bs_real *value, int n);
"""


def test_header_and_manifest_say_what_an_order_leaves_out_and_costs(ordered, tmp_path):
    """The operations are counted by numbers that count, in the C itself."""
    order, folder = ordered
    said = json.loads((folder / "manifest.json").read_text())["order"]
    header = (folder / "include" / "mass_covariance.h").read_text().replace("\n *", " ")
    header = " ".join(NUMBER.sub("", header).split())
    assert (said["Phi"], said["Q"]) == (order, order + 1)
    assert ["Phi = I + F dt, and", "+ (F dt)^2 / 2, and", "+ (F dt)^3 / 6, and"][order - 1] in header
    assert f"begins with {said['left_out']};" in header
    assert f"It costs {said['operations']} additions, mult" in header
    assert f"Q leaves out {['(A^2 W + W A', '', '(A^4 W + W A'][order - 1]}" in header
    assert said["left_out"].startswith(["(F dt)^2 / 2,", "(F dt)^3 / 6,", "(F dt)^4 / 24,"][order - 1])
    (tmp_path / "count.cpp").write_text(f"""{COUNTED}
#include <stdio.h>
#include "{folder / "src" / "ms_covariance.c"}"
int main()
{{
    static bs_real F[MS_N_F], Qc[MS_N_QC], Phi[MS_N_PHI], Q[MS_N_PACKED], work[MS_N_WORK];
    Qc[0] = Qc[MS_N_QC - 1] = 1.0; /* so that no pivot is left out */
    ms_discretize(F, Qc, 1.0, Phi, Q, work);
    printf("%ld", operations);
}}
""")
    done = run(tool("g++"), "-w", "-I", folder / "include", tmp_path / "count.cpp", "-o", tmp_path / "count")
    assert done.returncode == 0, done.stderr
    assert run(tmp_path / "count").stdout == str(said["operations"])


def test_the_cost_of_a_step_over_non_zeros_is_what_numbers_count(tmp_path):
    folder = ROOT / "generated" / "velocity_attitude_sensors"
    said = json.loads((folder / "manifest.json").read_text())
    source = (folder / "src" / "vas_covariance.c").read_text()
    tables = [re.search(rf"{name}\[\d+\] = {{([^}}]*)}}", source)[1].split(",") for name in ("from", "place")]
    variances = [p for p, at in zip(*tables, strict=True) if any(int(at) == k * (k + 3) // 2 for k in range(46))]
    assert said["filter"]["prediction"] == "non-zeros" and variances
    (tmp_path / "count.cpp").write_text(f"""{COUNTED}
#include <stdio.h>
#include "{folder / "src" / "vas_covariance.c"}"
int main()
{{
    static bs_real F[VAS_N_F], Qc[VAS_N_QC], Phi[VAS_N_PHI], Q[VAS_N_PACKED], work[VAS_N_WORK];
    static const int variances[] = {{ {",".join(variances)} }}; /* so that no pivot is left out */
    for (int p : variances) {{
        Qc[p] = 1.0;
    }}
    vas_discretize(F, Qc, 1.0, Phi, Q, work);
    printf("%ld", operations);
}}
""")
    done = run(tool("g++"), "-w", "-I", folder / "include", tmp_path / "count.cpp", "-o", tmp_path / "count")
    assert done.returncode == 0, done.stderr
    assert run(tmp_path / "count").stdout == str(said["order"]["operations"])


def test_factors_of_states_that_stay_without_noise_cost_no_operation_to_raise(tmp_path):
    """By numbers that count: the cubic part of a prediction is the noise of states that stay, and no other."""
    folder = ROOT / "generated" / "azimuth_hold"
    (tmp_path / "count.cpp").write_text(f"""{COUNTED}
#include <stdio.h>
#include "{folder / "src" / "ah_covariance.c"}"
static long of_step(bs_real noise)
{{
    static bs_real UD[AH_N_PACKED], Phi[AH_N_PHI], Q[AH_N_PACKED], next[AH_N_PACKED], work[AH_N_WORK];
    for (int i = 0; i < AH_N_PACKED; ++i) {{
        UD[i] = 0.5;
        Q[i] = 0.0;
    }}
    for (int j = AH_N_MOVING; j < AH_N_STATES; ++j) {{
        Q[column(j) + j] = noise;
    }}
    for (int i = 0; i < AH_N_MOVING; ++i) {{
        Phi[i * (AH_ROW + 1)] = 1.0;
    }}
    operations = 0;
    ah_ud_predict(UD, Phi, Q, next, work);
    return operations;
}}
int main()
{{
    const long with = of_step(1.0), without = of_step(0.0);
    bs_real UD[AH_N_PACKED], v[AH_N_STATES];
    operations = 0;
    for (int j = AH_N_MOVING; j < AH_N_STATES; ++j) {{
        UD[column(j) + j] = 1.0;
        v[j] = 1.0;
        (void)raise_by(UD, 1.0, v, j, AH_N_MOVING);
    }}
    const long raised = operations;
    operations = 0;
    (void)raise_by(UD, 0.0, v, AH_N_STATES - 1, 0);
    printf("%d %d", with - without >= raised, operations == 0);
}}
""")
    done = run(tool("g++"), "-w", "-I", folder / "include", tmp_path / "count.cpp", "-o", tmp_path / "count")
    assert done.returncode == 0, done.stderr
    assert run(tmp_path / "count").stdout == "1 1"


# ---- discrete time

TURN = Model(
    name="turn",
    c_prefix="tn",
    title="a heading that drifts, 1 state, in discrete time",
    frame="none",
    states=(heading := variable("heading", "psi", "rad", "heading", -np.pi, np.pi, wraps=True),),
    structs=(Struct("step", "one step", (turn := variable("turn", "u", "rad", "turn in the step", -1.0, 1.0),)),),
    next=Matrix([heading.scalar + turn.scalar + sin(heading.scalar) / 10]),
    Q=Matrix([[Rational("1e-4") + turn.scalar**2 / 1000]]),
    measurements=(Measurement("compass", ("psi",), "rad", "heading", h=Matrix([heading.scalar]), angle=True),),
)


def test_a_model_in_discrete_time_is_flown_as_it_is_given(tmp_path):
    folder = generated("TURN", 2, tmp_path / "turn")
    done = self_test(folder, tmp_path, *STRICT, "-O0", "-DBORESIGHT_FLOAT")
    assert (done.returncode, done.stdout.splitlines()[-1]) == (0, passed(folder)), done.stdout + done.stderr
    library, angle, P = load(folder), 3.0, 0.01
    loops = [kind(library, {}, [[P]], x=[angle]) for kind in (Filter, CompiledFilter)]
    for _ in range(20):
        slope = 1 + np.cos(angle) / 10
        angle, P = float(wrapped(angle + 0.4 + np.sin(angle) / 10)), slope * P * slope + 1e-4 + 0.4**2 / 1000
        for loop in loops:
            loop.predict(turn=0.4)
            assert loop.x == pytest.approx([angle], abs=1e-13) and pytest.approx(np.array([[P]]), rel=1e-12) == loop.P
