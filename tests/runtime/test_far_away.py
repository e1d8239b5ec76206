"""A measurement that would lead the state out of its box, and one outside its own, are refused by every loop alike."""

import numpy as np
import pytest
from sympy import Matrix

from boresight import BoresightError, CompiledFilter, Filter, Measurement, Model, Struct, generate, load, variable

place = variable("place", "x v", "m, m/s", "a walker", (-1000.0, -10.0), (1000.0, 10.0))
dt = variable("dt", "dt", "s", "length of the step", 1e-3, 1.0)
gusts = variable("gusts", "q", "m/s/sqrt(s)", "noise density", 0.0, 1.0)
x, v = place.symbols
WALKER = Model(
    name="walker",
    c_prefix="wk",
    title="a walker, 2 states",
    frame="the line",
    states=(place,),
    structs=(Struct("step", "one step", (dt, gusts)),),
    f=Matrix([v, 0]),
    G=Matrix([0, 1]),
    noise=gusts.vector,
    dt=dt.scalar,
    measurements=(
        Measurement("fix", ("x",), "m", "the place", h=Matrix([x])),
        Measurement("boxed", ("x",), "m", "the place", h=Matrix([x]), low=(-500.0,), high=(500.0,)),
    ),
)


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    folder = tmp_path_factory.mktemp("walker") / "made"
    generate(WALKER, folder)
    return load(folder)


@pytest.mark.parametrize("loop", [Filter, CompiledFilter])
@pytest.mark.parametrize("runs", [(), (11,)])
@pytest.mark.parametrize(
    ("name", "z", "why"),
    [
        ("fix", 1e20, "box"),
        ("fix", 5000.0, "box"),
        ("fix", 1e200, "nis|positive|NOT_POSITIVE|number"),
        ("boxed", 501.0, "box"),
        ("boxed", float("nan"), "finite"),
    ],
)
def test_what_is_too_far_away_is_refused_and_changes_nothing(loop, runs, name, z, why, library):
    flown = loop(library, {}, np.broadcast_to(np.eye(2), (*runs, 2, 2)), x=np.zeros((*runs, 2)))
    seen = np.full((*runs, 1), 3.0)
    seen.flat[-1] = z
    before = flown.x.copy(), flown.P.copy()
    with pytest.raises(BoresightError, match=why):
        flown.update(name, 1e-6, z=seen)
    np.testing.assert_array_equal(flown.x, before[0])
    np.testing.assert_array_equal(flown.P, before[1])
    flown.update(name, 1e-6, z=np.full((*runs, 1), 3.0))
    assert np.allclose(flown.x[..., 0], 3.0, atol=1e-4)


@pytest.mark.parametrize(
    ("box", "why"),
    [
        ({"low": (0.0,)}, "1 lower and 0 upper bounds for 1 rows"),
        ({"low": (1.0,), "high": (0.0,)}, "lower bound of the box"),
    ],
)
def test_a_box_of_z_that_does_not_fit_is_refused(box, why):
    fix = Measurement("fix", ("x",), "m", "the place", h=Matrix([x]), **box)
    with pytest.raises(BoresightError, match=why):
        Model(
            **{
                **{name: getattr(WALKER, name) for name in WALKER.__dataclass_fields__ if name in NAMED},
                "measurements": (fix,),
            }
        )


NAMED = ("name", "c_prefix", "title", "frame", "states", "structs", "f", "G", "noise", "dt")
