"""verify looks inside the boxes and norms that a model declares, and its verdict is the same under any name."""

from dataclasses import replace

import numpy as np
import pytest
from flint import arb
from sympy import Matrix, cos, sin, sqrt, zeros
from test_mechanics import checked

from boresight import BoresightError
from boresight.codegen import points as drawing
from boresight.codegen.functions.reference import precise
from boresight.codegen.functions.samples import generator
from boresight.codegen.functions.tape import evaluate
from boresight.codegen.functions.units import units
from boresight.codegen.mechanics import Exact, exact_points, points
from boresight.codegen.verify import (
    WIDEST,
    FirstOrderCheck,
    UnitCheck,
    check_first_order,
    check_points,
    prepare,
    relative_width,
    to_json,
)
from boresight.derive.model import FirstOrder, Function, Measurement, Mechanics, Model, Output, Struct, variable
from boresight.derive.models import variables as var

step = variable("dt", "dt", "s", "step", 1e-3, 0.1)


class Interpreted:
    """A library whose functions are the lists of operations, run by NumPy."""

    def __init__(self, made):
        for unit in made:
            setattr(self, unit.name, lambda unit=unit, **fields: self.run(unit, fields))

    def run(self, unit, fields):
        shaped = [np.asarray(fields[a.name]).reshape(-1, a.size) for a in unit.args]
        (result,) = unit.results
        out = np.zeros((len(shaped[0]), *result.shape))
        for (_, nz, _), value in zip(unit.tape.results, evaluate(unit.tape, shaped)[0], strict=True):
            out[:, *result.nonzeros[nz]] = value
        return out


def first_order(model, name):
    made = units(model)
    measurement = next(m for m in model.measurements if m.name == name)
    return check_first_order(model, measurement, made, Interpreted(made))


# ---------------------------------------------------------------- norms


def at_a_distance(place, less, name="distance"):
    """A strapdown and a distance that are real where the norm is as declared; F is zero, and should not be."""
    error = variable("d", "d_x d_y d_z", "m", "error of the place", -0.1, 0.1)
    noise = variable("n", "n_x n_y n_z", "m/sqrt(s)", "noise density", 0.0, 1.0)
    one = variable("one", "one", "m", "one metre", 0.95, 1.05)
    rate = variable("rate", "rate", "1/s", "a rate", 0.5, 1.0)
    at, true = place.vector, place.vector - error.vector
    root = sqrt(at.dot(at) - less * one.scalar**2)
    return Model(
        name=name, c_prefix="nm", title="a place at some distance", frame="none", states=(error,),
        structs=(Struct("nav", "place", (place,)), Struct("step", "one step", (step, noise, one, rate))),
        F=zeros(3), G=Matrix.eye(3), noise=noise.vector, dt=step.scalar,
        measurements=(Measurement("beacon", ("r",), "m", "distance along a tangent",
                                  h=Matrix([sqrt(true.dot(true) - less * one.scalar**2)])),),
        functions=(
            Function("strapdown", "outward", (
                Output("p", at * (1 + rate.scalar * step.scalar * root / one.scalar), "m", "place"),)),
            Function("feedback", "error out", (Output("p", true, "m", "place"),)),
        ),
    )  # fmt: skip


FAR = variable("p", "p_x p_y p_z", "m", "place", -3.0, 3.0, norm=(2.0, 3.0))


@pytest.mark.parametrize("name", ["distance", "another", "a-third"])
@pytest.mark.parametrize(
    "place, less", [(FAR, 2), (replace(FAR, low=(-1.1,) * 3, high=(1.1,) * 3, norm=(0.9, 1.1)), 0.25)]
)
def test_a_wrong_F_is_found_at_the_norm_that_is_declared_and_under_any_name(place, less, name):
    check = checked(at_a_distance(place, less, name))["F"]
    assert check.ok is False
    assert check == replace(checked(at_a_distance(place, less))["F"], model=name)
    assert "stated" in check.entry and "nan" not in check.entry


UNIT = var.quaternion("q", "q", "attitude", "body to NED")
VARIABLES = {
    "a box about zero": var.BG,
    "a box beyond zero": variable("scale", "k", "1", "scale", 0.9, 1.1),
    "a norm of metres": FAR,
    "a norm that the box cuts": replace(FAR, low=(0.0, -3.0, 1.0)),
    "a quaternion": UNIT,
    "a norm about 1 in metres": replace(FAR, low=(-1.1,) * 3, high=(1.1,) * 3, norm=(0.9, 1.1)),
}


@pytest.mark.parametrize("what", VARIABLES)
def test_points_lie_in_the_box_and_the_norm(what):
    v = VARIABLES[what]
    for values in (drawing.drawn(v, 50, "F"), np.array([list(map(float, p)) for p in exact_points(v, 50, "F")])):
        assert ((values >= v.low) & (values <= v.high)).all()
        length = np.linalg.norm(values, axis=1)
        least, most = v.norm or (0.0, np.inf)
        assert ((length >= least) & (length <= most)).all()
        spread = np.ptp(values, axis=0) / (np.array(v.high) - v.low)
        assert (spread > 0.3).all()


def test_a_unit_quaternion_has_the_norm_1_in_fifty_digits():
    for column in exact_points(UNIT, 5, "F"):
        assert abs(float(sum((c * c for c in column), arb(0)) - 1)) < 1e-15
        with precise():
            assert float(abs(sum((c * c for c in column), arb(0)) - 1)) < 1e-70


def test_a_box_without_such_a_norm_is_one_line():
    v = replace(FAR, low=(-1.733,) * 3, high=(1.733,) * 3, norm=(3.0, 3.1))
    with pytest.raises(BoresightError, match="p: no point of its box has a norm"):
        drawing.drawn(v, 5, "F")


def test_each_variable_is_drawn_by_its_own_name(monkeypatch):
    words = []
    monkeypatch.setattr(drawing, "generator", lambda *w: words.append(w) or generator(*w))
    model = at_a_distance(FAR, 2)
    points(model, "F")
    assert words == [("points", "F", v.name) for v in model.inputs]


# ---------------------------------------------------------------- what step does not state


def turning(low, read="increment"):
    """An angle that an increment, or a rate times dt, adds to."""
    angle = variable("angle", "a", "rad", "an angle", -3.0, 3.0)
    error = variable("d_angle", "d_a", "rad", "its error", -0.1, 0.1)
    noise = variable("n", "n", "rad/sqrt(s)", "noise density", 0.0, 1.0)
    turn = variable("turn", "turn", "rad" if read == "increment" else "rad/s", "turn", low, low + 1.0)
    gain = cos(angle.scalar)
    added = turn.scalar * gain * (1 if read == "increment" else step.scalar)
    return Model(
        name="turning", c_prefix="tu", title="an angle", frame="none", states=(error,),
        structs=(Struct("nav", "nav", (angle,)), Struct("step", "one step", (turn, step, noise))),
        F=Matrix([0]) if read == "increment" else Matrix([-turn.scalar * sin(angle.scalar)]),
        G=Matrix([1]), noise=noise.vector, dt=step.scalar,
        measurements=(Measurement("read", ("a",), "rad", "the angle", h=angle.vector - error.vector, angle=True),),
        functions=(
            Function("strapdown", "turned", (Output("angle", Matrix([angle.scalar + added]), "rad", "angle"),)),
            Function("feedback", "error out", (Output("angle", angle.vector - error.vector, "rad", "angle"),)),
        ),
        mechanics=Mechanics(driven=((noise, turn),)) if read == "stated" else None,
    )  # fmt: skip


def test_an_increment_that_nothing_states_is_put_to_nothing_over_a_short_step():
    exact = Exact(turning(-0.5))
    assert [v.name for v in exact.unstated] == ["turn"]
    assert checked(turning(-0.5))["F"].ok


def test_a_rate_is_read_in_its_box():
    exact = Exact(turning(0.5, "rate"))
    assert exact.unstated == []
    assert checked(turning(0.5, "rate"))["F"].ok


def test_an_increment_whose_box_lies_beyond_zero_is_not_held_and_says_so():
    check = checked(turning(0.5))["F"]
    assert check.ok is None
    assert check.why == "strapdown moves a at once, however short the step; see Mechanics.step"


# ---------------------------------------------------------------- a first order


def gauge(h=None, H=None, low=0.9, small=False):
    """A speed read by a gauge whose scale lies about 1, and which neglects an offset."""
    speed = variable("v", "v", "m/s", "speed", -10.0, 10.0)
    error = variable("dv", "dv", "m/s", "its error", -1.0, 1.0)
    noise = variable("n", "n", "m/s/sqrt(s)", "noise density", 0.0, 1.0)
    scale = variable("scale", "k", "1", "scale of the gauge", 0.9, 1.1)
    bent = variable("bent", "bent", "1", "how much it is bent", low, 1.1)
    k, dv = scale.scalar * (1 + bent.scalar * int(small)), error.scalar
    return Model(
        name="gauge", c_prefix="ga", title="a speed", frame="none", states=(error,),
        structs=(Struct("nav", "carried", (speed,)), Struct("step", "one step", (step, noise, scale, bent))),
        F=zeros(1), G=Matrix([1]), noise=noise.vector, dt=step.scalar,
        measurements=(Measurement(
            "gauge", ("v",), "m/s", "speed where none is", z=k * speed.vector, h=Matrix([k * dv]) if h is None else h,
            H=scale.vector if H is None else H, first_order=FirstOrder(small="bent" if small else None)),),
        functions=(
            Function("strapdown", "stays", (Output("v", speed.vector * (1 + 0 * step.scalar), "m/s", "speed"),)),
            Function("feedback", "error out", (Output("v", speed.vector - error.vector, "m/s", "speed"),)),
        ),
    )  # fmt: skip


def test_a_first_order_is_looked_at_inside_of_boxes_that_lie_beyond_zero():
    assert first_order(gauge(), "gauge").ok
    assert not first_order(gauge(H=Matrix([variable("scale", "k", "1", "", 0, 1).scalar ** 2])), "gauge").ok


@pytest.mark.parametrize("low", [0.0, -1e-4, -1.0])
def test_what_is_neglected_shrinks_inside_of_its_box(low):
    check = first_order(gauge(low=low, small=True), "gauge")
    assert check.ok
    assert check.coefficient == pytest.approx(1.0, rel=0.2)


def test_what_is_neglected_and_never_zero_is_a_row_that_fails():
    check = first_order(gauge(low=0.5, small=True), "gauge")
    assert check.ok is False
    assert check.entry == "bent is neglected, and its box does not hold 0; widen it"
    assert checked(gauge(low=0.5, small=True))["gauge_H"].why == check.entry


# ---------------------------------------------------------------- a result that is zero


def test_a_result_that_cancels_to_zero_is_known_by_the_numbers_that_it_is_made_of():
    made = gauge()
    dv, v = made.x[0], made.inputs[0].scalar
    h = Matrix([sin(dv + v) - sin(dv) * cos(v) - cos(dv) * sin(v)])
    zero = replace(made, measurements=(Measurement("gauge", ("v",), "1", "always zero", h=h),))
    unit = next(u for u in units(zero) if u.name == "gauge_h")
    library = Interpreted([unit])
    case = prepare(zero, unit, library, library, 20)
    case.part += check_points(case, 0, 1)
    verdict = case.verdict(zero)
    assert verdict.ok and verdict.width < 1e-60, verdict.reason
    assert relative_width({(0, 0): arb(0, 1e-79)}) > WIDEST
    assert replace(verdict, width=1e-30).reason == "50 digits know the result to 1e-30 only"


def test_a_verdict_on_the_c_gives_its_reason_and_its_scale():
    check = UnitCheck("m", "F", 1, 1, False, 1e-3, 0.5, False, 1e-60, 40.0)
    assert not check.ok
    assert check.reason == (
        "the bits are not those of CasADi's C; an error of 1.0e-03 where outputs are up to 40 lies beyond the bound on "
        "rounding; an element that is left out is not zero"
    )
    assert FirstOrderCheck("m", "H", 0.1, None, None).reason.startswith("it differs by 1.0e-01 of the largest")
    assert "leaves 0.900 of the difference" in FirstOrderCheck("m", "H", 0.0, 0.9, 1.0).reason
    shown = to_json([check])[0]
    assert shown["scale"] == 40.0 and shown["reason"] == check.reason
