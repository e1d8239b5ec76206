"""A model is checked when it is made, and a larger one is made from it by extend."""

from dataclasses import replace

import numpy as np
import pytest
from pendulum import PENDULUM, dt
from sympy import Matrix, Symbol, atan2, cos, eye, sin, zeros

from boresight import BoresightError
from boresight.codegen.generate import generate
from boresight.codegen.text.live import has_live
from boresight.derive.model import Measurement, Mechanics, Model, Struct, variable
from boresight.derive.models.euler_matching import euler_matching
from boresight.runtime.library import load

angle, rate = PENDULUM.states[0].symbols
DISCRETE = {"f": None, "G": Matrix(0, 0, []), "noise": Matrix(0, 0, []), "next": PENDULUM.x, "Q": eye(2)}


def named(name):
    return variable(name, "wind", "m/s", "wind", 0.0, 1.0)


def angled(rows):
    return {"measurements": (replace(PENDULUM.measurements[0], angle=rows),)}


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"f": Matrix([1, 2, 3])}, r"f has shape \(3, 1\), not \(2, 1\)"),
        ({"F": eye(2)}, "one of F or Phi, .*given is F and f"),
        ({"f": None}, "one of F or Phi, .*given is none"),
        ({"f": None, "F": Matrix([[0, 1], [-angle, 0]])}, "F.rate, angle. uses the state angle, .*use f"),
        ({"f": None, "F": eye(2), "G": Matrix([0, rate])}, "G.rate, push. uses the state rate, .*use f"),
        ({"f": None, "next": Matrix([angle, rate])}, "next or Phi and Q, .*belong together"),
        ({"Q": eye(2)}, "next or Phi and Q, .*belong together"),
        (DISCRETE | {"G": Matrix([0, 1]), "noise": Matrix([1])}, "next has its noise in Q"),
        (DISCRETE | {"Q": Matrix([[1, rate], [angle, 1]])}, "Q is not symmetric: rate at .0, 1. is angle at .1, 0."),
        (DISCRETE | {"Q": eye(3)}, r"Q has shape \(3, 3\), not \(2, 2\)"),
        ({"order": 3}, "order 3 is that of an error state's Phi and Q; a total state is flown by f"),
        (
            {"f": None, "F": eye(2), "loops": True},
            "loops are for .*flown by f; an error state is carried by loops already",
        ),
        (DISCRETE | {"loops": True}, "loops are for the step of a total state that is flown by f: leave loops out"),
        (
            {"loops": True, "structs": (*PENDULUM.structs, Struct("rate", "a number of the loops", (named("wind"),)))},
            "'rate' has a mean",
        ),
        ({"f": None, "F": eye(2), "order": 4}, "order is 4; it is 1, 2 or 3"),
        ({"functions": (replace(PENDULUM.functions[0], name="feedback"),)}, "feedback belongs to an error state"),
        ({"functions": (replace(PENDULUM.functions[0], name="strapdown"),)}, "strapdown belongs to an error state"),
        ({"mechanics": Mechanics()}, "mechanics belongs to an error state"),
        ({"states": (replace(PENDULUM.states[0], wraps=True),)}, "swing: it wraps, but its unit is 'rad, rad/s'"),
        ({"states": (replace(PENDULUM.states[0], wraps=True, unit="rad"),)}, r"wraps to \[-pi, pi\), which its box"),
        ({"G": Matrix([Symbol("wind"), 1])}, "wind"),
        ({"name": "Pendulum"}, "lower-case"),
        ({"c_prefix": "pd_"}, "c_prefix"),
        ({"dt": Symbol("tick")}, "dt is tick"),
        ({"structs": (Struct("step", "twice", (dt, dt)),)}, "it stands twice in struct step"),
        (
            {"structs": (*PENDULUM.structs, Struct("energy", "named as a function", (named("wind"),)))},
            "'energy' is used twice",
        ),
        ({"states": ()}, "without states"),
        ({"measurements": (Measurement("tip", ("a",), "m", "both", h=Matrix([1]), H=eye(2)),)}, "either h or H"),
        (
            {"measurements": (Measurement("tip", ("a",), "m", "none", h=Matrix([dt.scalar])),)},
            "tip: it depends on no state",
        ),
        ({"measurements": (Measurement("tip", ("a",), "m", "none", H=zeros(1, 2)),)}, "tip: it depends on no state"),
        (angled(("vertical",)), "tip: angle names 'vertical', which is no row; rows are horizontal"),
        ({"G": zeros(2, 1)}, "noise push has no effect"),
        ({"noise": Matrix([0])}, "noise 0 has no effect"),
        ({"G": zeros(2, 0), "noise": zeros(0, 1)}, "at least one noise"),
        ({"c_prefix": "bs"}, "c_prefix 'bs'"),
        (
            {"structs": (*PENDULUM.structs, Struct("register", "a keyword", (named("wind"),)))},
            "'register' has a meaning in C",
        ),
        (
            {"structs": (*PENDULUM.structs, Struct("filter", "a type of ours", (named("wind"),)))},
            "'filter' has a meaning in C",
        ),
        ({"structs": (*PENDULUM.structs, Struct("wind", "", (named("x"),)))}, "the name 'x' has a meaning in C"),
        ({"structs": (*PENDULUM.structs, Struct("wind", "", (named("t12"),)))}, "the name 't12' has a meaning in C"),
        ({"structs": (*PENDULUM.structs, Struct("wind", "", (named("sin"),)))}, "the name 'sin' has a meaning in C"),
        (
            {"structs": (*PENDULUM.structs, Struct("tip_z", "named as a function", (named("wind"),)))},
            "'tip_z' is used twice",
        ),
    ],
)
def test_what_does_not_fit_together_is_named(change, said):
    with pytest.raises(BoresightError, match=said):
        replace(PENDULUM, **change)


def test_what_a_state_is_follows_from_what_flies_it():
    assert (PENDULUM.kind, replace(PENDULUM, **DISCRETE).kind) == ("total-state", "total-state")
    assert replace(PENDULUM, **DISCRETE, dt=None).dt is None
    assert (euler_matching().kind, replace(euler_matching(), order=3).kind) == ("error-state", "error-state")
    discrete = {"F": None, "G": zeros(0, 0), "noise": zeros(0, 0), "Phi": eye(6), "Q": zeros(6, 6)}
    assert has_live(euler_matching()) and not has_live(replace(euler_matching(), **discrete, dt=None))


def test_extend_of_a_total_state_adds_to_f_and_of_an_error_state_to_F():
    wind = variable("wind", "wind", "rad/s^2", "what the wind adds", -1.0, 1.0)
    wide = PENDULUM.extend(name="windy", c_prefix="wd", states=(wind,), f=Matrix([0, wind.scalar, -wind.scalar]))
    assert wide.f == Matrix([PENDULUM.f[0], PENDULUM.f[1] + wind.scalar, -wind.scalar])
    assert Matrix([0, 1, 0]) == wide.G
    with pytest.raises(BoresightError, match="f to an f; this model is given by f"):
        PENDULUM.extend(name="windy", c_prefix="wd", states=(wind,), F=eye(3))
    with pytest.raises(BoresightError, match="f to an f; this model is given by F"):
        euler_matching().extend(name="windy", c_prefix="wd", f=zeros(6, 1))
    with pytest.raises(BoresightError, match="given by next; write the larger one"):
        replace(PENDULUM, **DISCRETE).extend(name="windy", c_prefix="wd")


def test_a_box_upside_down_is_refused():
    with pytest.raises(BoresightError, match="lower bound"):
        variable("a", "a", "m", "upside down", 1.0, -1.0)


def with_gyro_bias():
    """Euler matching with a constant gyro bias as three more states, as composition."""
    base = euler_matching()
    bias = variable(
        "gyro_bias", "bg_x bg_y bg_z", "rad/s", "gyro bias, measured - true", -0.01, 0.01, frame="slave body"
    )
    F = zeros(9, 9)
    F[:3, 6:] = base.G[:3, :]
    return base.extend(name="euler-matching-bias", c_prefix="emb", states=(bias,), F=F)


def test_extend_adds_states_behind_the_old_ones(tmp_path, library, points):
    base, wide = euler_matching(), with_gyro_bias()
    assert wide.n == 9
    assert wide.F[:6, :6] == base.F
    file = tmp_path / "mine.py"
    file.write_text(f"import sys\nsys.path.insert(0, {str(__file__.rsplit('/', 2)[0])!r})\n"
                    f"sys.path.insert(0, {str(__file__.rsplit('/', 1)[0])!r})\n"
                    "from test_model import with_gyro_bias as MODEL\n")  # fmt: skip
    generate(f"{file}:MODEL", tmp_path / "out")
    grown = load(tmp_path / "out")
    H = grown.euler_H(euler_b=points["euler_b"], euler_m=points["euler_m"])
    np.testing.assert_array_equal(H[..., :6], library.euler_H(euler_b=points["euler_b"], euler_m=points["euler_m"]))
    np.testing.assert_array_equal(H[..., 6:], 0)
    F = grown.F(q_b2n_wxyz=[1.0, 0, 0, 0], omega_in_n=[1e-5, 0, 0])
    np.testing.assert_array_equal(F[:3, 6:], -np.eye(3))


def test_rows_that_are_angles_are_named_in_a_tuple():
    with pytest.raises(BoresightError, match=r"angle is 'horizontal', .*a tuple of one has a comma: \('horizontal',\)"):
        angled("horizontal")


HEADING = variable("psi", "psi", "rad", "heading", -4.0, 4.0, wraps=True)
TURN = variable("turn", "r", "rad/s", "its rate", -5.0, 5.0)
OFFSET = variable("offset", "offset", "rad", "of the antenna", -4.0, 4.0)


def antenna(h=None, H=None, unit="rad", **more):
    """A heading that wraps, and one row that reads it."""
    dt = variable("dt", "dt", "s", "step", 1e-3, 1.0)
    gust = variable("gust", "gust", "rad/s/sqrt(s)", "noise density", 0.0, 1.0)
    return Model(
        name="antenna", c_prefix="an", title="a heading", frame="none", states=(HEADING, TURN),
        structs=(Struct("step", "one step", (dt, gust, OFFSET)),),
        f=Matrix([TURN.scalar, 0]), G=Matrix([0, 1]), noise=gust.vector, dt=dt.scalar,
        measurements=(Measurement("gnss", ("yaw",), unit, "heading", h=h and Matrix([h]), H=H, **more),),
    )  # fmt: skip


GROWS = {
    "the heading": {"h": HEADING.scalar + OFFSET.scalar},
    "less the heading": {"h": atan2(OFFSET.scalar, 1) - HEADING.scalar},
    "a linear H": {"H": Matrix([[1, 0]])},
}


@pytest.mark.parametrize("what", GROWS)
def test_a_row_that_turns_with_a_state_that_wraps_is_an_angle_or_is_said_to_be_none(what):
    with pytest.raises(
        BoresightError, match=r"measurement gnss: [hH]\[yaw\] turns with psi, which wraps; give angle=True"
    ):
        antenna(**GROWS[what])
    for angle in (True, False, ("yaw",)):
        antenna(**GROWS[what], angle=angle)


@pytest.mark.parametrize("h, unit", [
    (atan2(sin(HEADING.scalar), cos(HEADING.scalar)), "rad"), (sin(HEADING.scalar), "rad"),
    (TURN.scalar, "rad"), (HEADING.scalar, "1"),
])  # fmt: skip
def test_a_row_that_a_whole_turn_does_not_change_needs_no_word(h, unit):
    antenna(h, unit=unit)


def test_a_norm_of_a_state_is_refused_since_nothing_keeps_it():
    direction = replace(HEADING, wraps=False, norm=(0.9, 1.1))
    with pytest.raises(BoresightError, match="variable psi: it is a state with a norm, which no step and no update"):
        replace(antenna(HEADING.scalar, angle=True), states=(direction, TURN))
