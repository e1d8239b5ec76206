"""What a filter is given wrongly is one line that names it, in the Python filter and in the compiled one."""

import numpy as np
import pytest

from boresight import BoresightError
from boresight.runtime.filter import CompiledFilter, Filter
from boresight.runtime.library import load

NAV = {"plant": np.array([1.0, 0.1])}
STEP = {"dt": 0.01, "push": 0.1}
I = np.eye(2)
X = np.zeros(2)


@pytest.fixture(params=[Filter, CompiledFilter], ids=["python", "compiled"])
def flown(request, pendulum_folder):
    """A filter of the pendulum, which begins with nav and P."""
    return lambda nav=NAV, P=I: request.param(load(pendulum_folder), nav, P, x=X)


def test_what_is_right_is_flown(flown):
    one, many = flown(), flown({"plant": np.tile(NAV["plant"], (3, 1))}, np.tile(np.eye(2), (3, 1, 1)))
    one.predict(**STEP)
    many.predict(**STEP)
    many.predict(dt=[0.01], push=np.full(3, 0.1))
    assert one.P.shape == (2, 2) and many.P.shape == (3, 2, 2)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"pusch": 0.1}, r"pendulum has no input 'pusch' \(did you mean 'push'\?\)"),
        ({"push": [0.1]}, r"push has shape \(1,\), an axis of runs; for one run give a number"),
        ({"wind": 0.1}, "pendulum has no input 'wind'; it has .*plant, dt, push"),
        ({"plant": 1.0}, r"plant has shape \(\); its last axis must be 2 long"),
        ({"plant": [1.0, 0.1, 0.0]}, r"plant has shape \(3,\); its last axis must be 2 long"),
    ],
)
def test_an_input_of_a_wrong_name_or_shape_is_named(flown, changes, said):
    one = flown()
    with pytest.raises(BoresightError, match=said):
        one.predict(**STEP | changes)
    np.testing.assert_array_equal(one.P, I)


@pytest.mark.parametrize("step", ["strapdown", "predict", "tip"])
def test_the_state_is_no_input(flown, step):
    """It would not be read: the filter has its own."""
    given, loop = {**STEP, "x": X}, flown()
    with pytest.raises(BoresightError, match=f"{step}: x is the filter's own state; assign it, as loop.x = ..."):
        loop.update(step, 1.0, z=[0.0], **given) if step == "tip" else getattr(loop, step)(**given)


def test_a_filter_begins_with_finite_numbers(flown):
    with pytest.raises(BoresightError, match="x holds a value that is not finite"):
        type(flown())(flown().model, NAV, I, x=[0.0, np.nan])
    with pytest.raises(BoresightError, match="P holds a value that is not finite"):
        flown(P=np.full((2, 2), np.nan))


def test_a_covariance_that_became_no_number_is_not_carried_on(flown):
    loop = flown()
    loop.P = np.full((2, 2), np.nan)
    with pytest.raises(BoresightError, match=r"not finite|no number"):
        loop.predict(**STEP)


def test_the_compiled_filter_refuses_a_jacobian(pendulum_folder):
    loop = CompiledFilter(load(pendulum_folder), NAV, I, x=X)
    with pytest.raises(BoresightError, match="the C makes its own jacobian; leave it out, or fly Filter"):
        loop.update("tip", 1.0, z=[0.0], jacobian=[[1.0, 0.0]])


@pytest.mark.parametrize(
    ("nav", "P", "said"),
    [
        (NAV, np.eye(3), r"P has shape \(3, 3\); it must be \(..., 2, 2\) for the states angle, rate"),
        (NAV, np.ones(2), r"P has shape \(2,\); it must be \(..., 2, 2\)"),
        (NAV, 1.0, r"P has shape \(\); it must be"),
        ({"plants": NAV["plant"]}, I, r"nav: pendulum has no input 'plants' \(did you mean 'plant'\?\)"),
        ({"plant": np.ones(3)}, I, r"nav: plant has shape \(3,\); its last axis must be 2 long"),
    ],
)
def test_a_start_of_a_wrong_size_or_name_is_refused_at_once(flown, nav, P, said):
    with pytest.raises(BoresightError, match=said):
        flown(nav, P)


def test_what_nav_lacks_is_named_where_it_is_needed(flown):
    with pytest.raises(BoresightError, match="needs plant; pass it as a keyword"):
        flown({}).predict(**STEP)


@pytest.mark.parametrize(
    ("measurement", "R", "more", "said"),
    [
        ("tipp", [1e-4], {}, r"no measurement 'tipp'; it has tip \(did you mean 'tip'\?\)"),
        ("tip", [1e-4, 1e-4], {}, r"R has shape \(2,\); it must be \(..., 1\)"),
        ("tip", [1e-4], {"z": [0.1, 0.2]}, r"z has shape \(2,\); its last axis must be 1 long"),
        ("tip", [1e-4], {"rows": [True, True]}, r"rows has shape \(2,\); its last axis must be 1 long"),
        ("tip", [-1e-4], {}, "every variance in R must be finite and above zero"),
        ("tip", [1e-4], {"gait": 3.0}, r"no input 'gait'"),
    ],
)
def test_a_measurement_of_a_wrong_name_or_size_is_named(flown, measurement, R, more, said):
    one = flown()
    with pytest.raises(BoresightError, match=said):
        one.update(measurement, R, **{"z": [0.1]} | more)
    np.testing.assert_array_equal(one.P, I)
