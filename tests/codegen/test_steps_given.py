"""An error state in discrete time, and a total state with a quaternion: their C against NumPy, their flights against
their own P."""

import numpy as np
import pytest
from scipy.stats import chi2
from sympy import Matrix

from boresight import (
    CompiledFilter,
    Filter,
    Function,
    Measurement,
    Model,
    Output,
    Struct,
    export,
    generate,
    load,
    variable,
)
from boresight.examples import fly_ahrs

p = variable("p", "p", "m", "place", -10.0, 10.0)
v = variable("v", "v", "m/s", "speed", -10.0, 10.0)
dp = variable("dp", "dp", "m", "error of the place", -1.0, 1.0)
dv = variable("dv", "dv", "m/s", "error of the speed", -1.0, 1.0)
gain = variable("gain", "gain", "m/s", "velocity gained", -1.0, 1.0)
dt = variable("dt", "dt", "s", "step", 1e-3, 0.1)
var = variable("var", "var", "m^2/s^2", "variance of the velocity gained over a step", 0.0, 1.0)

GIVEN = Model(
    name="discrete-error",
    c_prefix="de",
    title="place and speed",
    frame="none",
    states=(dp, dv),
    structs=(Struct("nav", "carried", (p, v)), Struct("imu", "one step", (gain, dt)), Struct("noise", "noise", (var,))),
    Phi=Matrix([[1, dt.scalar], [0, 1]]),
    Q=Matrix([[0, 0], [0, var.scalar]]),
    dt=dt.scalar,
    measurements=(Measurement("place", ("p",), "m", "place: the measured value", h=p.vector),),
    functions=(
        Function("strapdown", "one step", (
            Output("p", p.vector + v.vector * dt.scalar, "m", "place"),
            Output("v", v.vector + gain.vector, "m/s", "speed"))),
        Function("feedback", "errors out", (
            Output("p", p.vector - dp.vector, "m", "place"),
            Output("v", v.vector - dv.vector, "m/s", "speed"))),
    ),
)  # fmt: skip


@pytest.fixture(scope="module")
def given(tmp_path_factory):
    folder = tmp_path_factory.mktemp("given")
    return generate(GIVEN, folder / "discrete").folder


def test_the_C_of_an_error_state_in_discrete_time_is_the_textbook_filter(given):
    library = load(given)
    nav, P = {"p": 0.3, "v": -0.2}, np.diag([0.04, 0.01])
    loops = [kind(library, nav, P=P) for kind in (Filter, CompiledFilter)]
    x, P = np.array([0.3, -0.2]), P.copy()
    Phi, Q, H, R = np.array([[1, 0.05], [0, 1]]), np.diag([0, 3e-4]), np.array([[1.0, 0]]), 1e-3
    for k in range(20):
        x, P = np.array([x[0] + 0.05 * x[1], x[1] + 0.02]), Phi @ P @ Phi.T + Q
        z = 0.1 * k
        K = P @ H.T / (H @ P @ H.T + R)
        x, P = x + K[:, 0] * (z - x[0]), (np.eye(2) - K @ H) @ P
        for loop in loops:
            loop.predict(dt=0.05, var=3e-4)
            loop.strapdown(dt=0.05, gain=0.02)
            loop.update("place", R=[R], z=[z])
            loop.feedback()
            np.testing.assert_allclose([loop.nav["p"], loop.nav["v"]], x, rtol=1e-12, atol=1e-12)
            np.testing.assert_allclose(loop.P, P, rtol=1e-11)


@pytest.mark.parametrize("precision", ["double", "float"])
def test_its_self_test_passes(given, precision, tmp_path):
    assert export(GIVEN, tmp_path / "out", precision, given).files


@pytest.mark.parametrize("name", ["SEVEN", "SIX"])
def test_a_quaternion_as_a_state_flies_in_band(name, tmp_path):
    """Mean of NEES over runs and times: times apart by a second or more count as one for each of the 30 s."""
    library = load(generate(fly_ahrs.MODELS[name], tmp_path / "made").folder)
    judged = fly_ahrs.fly(library, runs=60)
    for line in judged.report().splitlines():
        if line.startswith("NIS"):
            value, low, high = (float(line.split()[i]) for i in (3, 6, 8))
            assert low - 0.01 < value < high + 0.01, line
    nees = float(next(line for line in judged.report().splitlines() if line.startswith("NEES")).split()[1])
    low, high = chi2.ppf([1e-4, 1 - 1e-4], 6 * 60 * 3) / (60 * 3)  # biases forget in some 10 s
    assert low < nees < high, nees
