"""What follows from strapdown and feedback against what is written by hand, and differences in 50 digits."""

from dataclasses import replace

import pytest
from flint import arb
from sympy import Matrix, eye, zeros

from boresight import BoresightError, Function, Measurement, Mechanics, Model, Output, Struct, variable
from boresight.codegen.flown import over_step
from boresight.codegen.functions.reference import precise
from boresight.codegen.generate import load_model
from boresight.codegen.mechanics import Exact, compiled, points, slope, symbols
from boresight.derive.linear import Derivation, completed
from boresight.derive.model import NONE
from boresight.examples.autopilot import AUTOPILOT
from boresight.mechanics import normalized, quaternion_from_rotation_vector, quaternion_product

FILE = "derive/models/{}.py:{}"
HAND = ["euler-matching", "azimuth-hold", "velocity-attitude", "phi-error", "psi-error", "velocity-dcm",
        FILE.format("phi_error", "phi_error_ned"), FILE.format("psi_error", "psi_error_ned")]  # fmt: skip


def apart(a, b, model, what):
    """The largest difference of two matrices at points of the model, as a part of the largest of its row."""
    worst, both = 0.0, [compiled(one) for one in (a, b)]
    with precise():
        for values in points(model, what):
            A, B = (one(values)[0] for one in both)
            for i in range(A.rows):
                size = max(abs(float(v)) for v in A[i, :]) or 1.0
                worst = max(worst, *(abs(float(p - q)) / size for p, q in zip(A[i, :], B[i, :], strict=True)))
    return worst


@pytest.mark.parametrize("name", HAND)
def test_F_and_G_are_those_written_by_hand(name):
    model = load_model(name)
    F, G = Derivation(model).rates()
    assert apart(model.F, F, model, "F") < 1e-12
    signs = [1 if float((compiled(G)(v)[0][:, j].T * compiled(model.G)(v)[0][:, j])[0]) >= 0 else -1
             for v in points(model, "G")[:1] for j in range(G.cols)]  # fmt: skip
    assert apart(model.G, G * Matrix.diag(*signs), model, "G") < 1e-12
    zero = [(i, j) for (i, j), e in F.todok().items() if model.F[i, j] == 0]
    assert not zero, zero


@pytest.mark.parametrize("name", ["euler-matching", "azimuth-hold", "velocity-attitude"])
def test_H_at_zero_is_that_written_by_hand(name):
    """Where what a hand-written one neglects is zero, and what is tied follows."""
    model = load_model(name)
    derivation = Derivation(model)
    inputs = {v.name: v for v in model.inputs}
    tried = 0
    for m in model.measurements:
        if m.H is None or m.z is None:
            continue
        law = m.first_order
        exact = next((o for o in model.measurements if law and o.name == law.of), m)
        whole = derivation.measurement(replace(exact, H=None, first_order=None, at_zero=True))
        both = [compiled(one) for one in (m.H, whole.H)]
        with precise():
            for values in points(model, m.name):
                here = values | {s: arb(0) for s in (inputs[law.small].symbols if law and law.small else ())}
                for tied, expression in law.tied if law else ():
                    here |= dict(zip(inputs[tied].symbols, compiled(Matrix(expression))(here)[0], strict=True))
                A, B = (one(here)[0] for one in both)
                assert max(abs(float(e)) for e in A - B) < 1e-12 * max(abs(float(e)) for e in A), m.name
        tried += 1
    assert tried


@pytest.mark.parametrize("name", ["azimuth-hold", "velocity-attitude", "autopilot"])
def test_phi_of_the_exact_step_is_the_derivative_of_two_flights(name):
    model = AUTOPILOT if name == "autopilot" else load_model(name)
    Phi, Q = Derivation(model).step()
    exact, stating = Exact(model), compiled(Phi)
    with precise():
        for values in points(model, "step"):
            moving, still = over_step(exact, values, [arb(1)] * model.n)
            found = slope(lambda x, m=moving, s=still: m.parted(x, s), [arb(1)] * model.n)
            stated = stating(values)[0]
            sizes = [max(abs(float(v)) for v in found[i, :]) for i in range(model.n)]
            off = [abs(float(stated[i, j] - found[i, j])) / sizes[i] for i in range(model.n) for j in range(model.n)]
            assert max(off) < 1e-12
    assert (Q - Q.T).is_zero_matrix


V = variable("v", "v", "m/s", "speed", -10.0, 10.0)
B = variable("b", "b", "m/s^2", "bias, measured - true", -1.0, 1.0)
DV = variable("dv", "dv", "m/s", "error of the speed", -1.0, 1.0)
DB = variable("db", "db", "m/s^2", "error of the bias", -1.0, 1.0)
GAIN = variable("gain", "gain", "m/s", "velocity gained, as measured", -1.0, 1.0)
ACCEL = variable("accel", "accel", "m/s^2", "acceleration, as measured", -1.0, 1.0)
DT = variable("dt", "dt", "s", "step", 1e-3, 0.1)
N = variable("n", "n", "m/s/sqrt(s)", "noise density", 0.0, 1.0)
SEEN = variable("seen", "seen", "m/s", "speed, as measured", -10.0, 10.0)


def climb(sign=-1, gained=None, **changes):
    gained = GAIN.vector if gained is None else gained
    given = {
        "name": "climb", "c_prefix": "cl", "title": "a speed and a bias", "frame": "none", "states": (DV, DB),
        "structs": (Struct("nav", "estimates", (V, B)), Struct("imu", "a step", (GAIN, ACCEL, DT, N)),
                    Struct("gauge", "read", (SEEN,))),
        "noise": N.vector, "dt": DT.scalar,
        "measurements": (Measurement("speed", ("v",), "m/s", "speed", z=V.vector - SEEN.vector),),
        "functions": (
            Function("strapdown", "a step", (Output("v", V.vector + gained - B.vector * DT.scalar, "m/s", "speed"),)),
            Function("feedback", "errors out", (
                Output("v", V.vector + sign * DV.vector, "m/s", "speed"),
                Output("b", B.vector + sign * DB.vector, "m/s^2", "bias"))),
        ),
        "mechanics": Mechanics(driven=((N, GAIN),)),
    }  # fmt: skip
    return Model(**given | changes)


def test_the_sign_of_the_error_moves_H_and_not_F():
    usual = completed(climb())
    other = completed(climb(sign=1, error="true - computed"))
    assert usual.F == other.F == Matrix([[0, -1], [0, 0]])
    assert usual.measurements[0].h == Matrix([DV.scalar])
    assert other.measurements[0].h == Matrix([-DV.scalar])


def test_a_rate_is_driven_by_its_noise_as_an_increment_is():
    by_rate = climb(gained=ACCEL.vector * DT.scalar, mechanics=Mechanics(driven=((N, ACCEL),)))
    assert completed(by_rate).G == completed(climb()).G == Matrix([1, 0])
    Q, Q_gain = (completed(replace(one, exact=True)).Q for one in (by_rate, climb()))
    assert Q == Q_gain == Matrix([[N.scalar**2 * DT.scalar, 0], [0, 0]])


def test_a_state_is_driven_by_itself():
    walk = variable("walk", "walk", "m/s^2/sqrt(s)", "of the bias", 0.0, 1.0)
    model = climb()
    driven = Mechanics(driven=((N, GAIN), (walk, DB)))
    wide = replace(model, structs=(*model.structs, Struct("noise", "of the bias", (walk,))),
                   noise=Matrix([N.scalar, walk.scalar]), mechanics=driven)  # fmt: skip
    assert eye(2) == completed(wide).G


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"mechanics": Mechanics(step=((GAIN, GAIN.vector),))}, "nothing says what the noise n adds to; name it in"),
        ({"gained": ACCEL.vector}, "over a step of no time strapdown makes v into .*reads accel; what it reads as an"),
        ({"G": Matrix([1, 0])}, "G follows from strapdown"),
        ({"error": "wrong"}, "error is 'wrong'; it is 'computed - true' or 'true - computed'"),
        ({"exact": True, "order": 3}, "order 3 is that of a series"),
        ({"F": zeros(2), "G": eye(2)[:, :1], "exact": True}, "exact is for an error state whose Phi follows"),
        ({"measurements": (Measurement("speed", ("v",), "m/s", "", h=DV.vector, at_zero=True),)}, "at_zero is for"),
    ],
)
def test_what_does_not_follow_is_named(change, said):
    with pytest.raises(BoresightError, match=said):
        completed(climb(**change))


def test_a_feedback_that_takes_two_states_for_one_is_refused_with_its_null_vector():
    model = climb()
    strapdown, feedback = model.functions
    both = Output("v", V.vector - DV.vector - DB.vector * DT.scalar, "m/s", "speed")
    with pytest.raises(BoresightError, match=r"takes nothing out where dv = .*db = .*no full rank"):
        completed(replace(model, functions=(strapdown, replace(feedback, outputs=(both,)))))


def test_a_turn_is_left_alone_by_its_own_error():
    """An error in the axes that do not turn stays: the entry that a filter which flew had wrong."""
    q = variable("q", "qw qx qy qz", "1", "attitude", -1.001, 1.001, norm=(0.999, 1.001))
    th = variable("th", "th_x th_y th_z", "rad", "error", -0.5, 0.5)
    turn = variable("turn", "tx ty tz", "rad", "turn over the step", -0.5, 0.5)
    ng = variable("ng", "ng_x ng_y ng_z", "rad/sqrt(s)", "noise density", 0.0, 1.0)
    by = quaternion_from_rotation_vector(turn.vector)
    off = quaternion_from_rotation_vector(th.vector)

    def attitude(after, true):
        return Model(
            name="turning", c_prefix="tu", title="an attitude", frame="none", states=(th,),
            structs=(Struct("nav", "attitude", (q,)), Struct("imu", "a step", (turn, DT, ng))),
            noise=ng.vector, dt=DT.scalar,
            functions=(Function("strapdown", "a step", (Output("q", normalized(after), "1", "attitude"),)),
                       Function("feedback", "error out", (Output("q", normalized(true), "1", "attitude"),))),
            mechanics=Mechanics(driven=((ng, turn),)),
        )  # fmt: skip

    outer = completed(attitude(quaternion_product(q.vector, by), quaternion_product(off, q.vector)))
    assert outer.F.is_zero_matrix
    inner = completed(attitude(quaternion_product(q.vector, by), quaternion_product(q.vector, off)))
    tx, ty, tz = (s / DT.scalar for s in turn.symbols)
    assert Matrix([[0, tz, -ty], [-tz, 0, tx], [ty, -tx, 0]]) == inner.F
    whole = completed(
        replace(attitude(quaternion_product(q.vector, by), quaternion_product(off, q.vector)), exact=True)
    )
    assert whole.Phi == eye(3)
    assert whole.noise == NONE
    assert symbols(whole) == list(th.symbols)
