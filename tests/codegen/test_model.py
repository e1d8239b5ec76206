"""A model is checked when it is made, and a larger one is made from it by extend."""

from dataclasses import replace

import numpy as np
import pytest
from pendulum import PENDULUM, dt
from sympy import Matrix, Symbol, eye, zeros

from boresight import BoresightError
from boresight.codegen.generate import generate
from boresight.derive.model import Measurement, Struct, variable
from boresight.derive.models.euler_matching import euler_matching
from boresight.runtime.library import load


def named(name):
    return variable(name, "wind", "m/s", "wind", 0.0, 1.0)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"f": Matrix([1, 2, 3])}, r"f has shape \(3, 1\), not \(2, 1\)"),
        ({"F": eye(2)}, "either F or f"),
        ({"G": Matrix([Symbol("wind"), 1])}, "wind"),
        ({"name": "Pendulum"}, "lower-case"),
        ({"c_prefix": "pd_"}, "c_prefix"),
        ({"dt": Symbol("tick")}, "dt is tick"),
        ({"structs": (Struct("step", "twice", (dt, dt)),)}, "used twice"),
        ({"structs": (*PENDULUM.structs, Struct("energy", "named as a function", ()))}, "'energy' is used twice"),
        ({"states": ()}, "without states"),
        ({"measurements": (Measurement("tip", ("a",), "m", "both", h=Matrix([1]), H=eye(2)),)}, "either h or H"),
        (
            {"measurements": (Measurement("tip", ("a",), "m", "none", h=Matrix([dt.scalar])),)},
            "tip: it depends on no state",
        ),
        ({"measurements": (Measurement("tip", ("a",), "m", "none", H=zeros(1, 2)),)}, "tip: it depends on no state"),
        ({"G": zeros(2, 1)}, "noise push has no effect"),
        ({"noise": Matrix([0])}, "noise 0 has no effect"),
        ({"G": zeros(2, 0), "noise": zeros(0, 1)}, "at least one noise"),
        ({"c_prefix": "bs"}, "c_prefix 'bs'"),
        ({"structs": (*PENDULUM.structs, Struct("register", "a keyword", ()))}, "'register' has a meaning in C"),
        ({"structs": (*PENDULUM.structs, Struct("filter", "a type of ours", ()))}, "'filter' has a meaning in C"),
        ({"structs": (*PENDULUM.structs, Struct("wind", "", (named("x"),)))}, "the name 'x' has a meaning in C"),
        ({"structs": (*PENDULUM.structs, Struct("wind", "", (named("t12"),)))}, "the name 't12' has a meaning in C"),
        ({"structs": (*PENDULUM.structs, Struct("wind", "", (named("sin"),)))}, "the name 'sin' has a meaning in C"),
        ({"structs": (*PENDULUM.structs, Struct("tip_z", "named as a function", ()))}, "'tip_z' is used twice"),
    ],
)
def test_what_does_not_fit_together_is_named(change, said):
    with pytest.raises(BoresightError, match=said):
        replace(PENDULUM, **change)


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
