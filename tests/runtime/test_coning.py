"""Coning and sculling by four samples, against exact quadrature of a motion that cones."""

import numpy as np
import pytest
from sympy import Matrix, Rational, lambdify, symbols

from boresight.derive.mechanics.mechanization import compensated, coning_coefficients
from boresight.evidence.flights.coning import EARLIER, errors, vibrating
from boresight.evidence.flights.motion import DEG

NAMES = [f"{part}_{which}" for which in ("now", *EARLIER) for part in ("dtheta", "dv")]

QUIET = {"lever_b": np.zeros(3), "gyro_noise": np.full(3, 1e-9), "accel_noise": np.full(3, 1e-9),
         "gyro_bias_noise": np.full(3, 1e-12), "accel_bias_noise": np.full(3, 1e-12), "mu_noise": np.full(3, 1e-12),
         "tau_noise": 1e-12}  # fmt: skip


def by(samples):
    """`compensated` of so many samples over arrays (..., 3)."""
    symbol = [Matrix(symbols(f"{name}:3")) for name in NAMES]
    made = compensated(*symbol[:2], list(zip(symbol[2::2], symbol[3::2], strict=True))[: samples - 1])
    function = lambdify([list(one) for one in symbol], [list(one) for one in made], "numpy")

    def call(dtheta_ib_b, dv_b, **earlier):
        given = {"dtheta_now": dtheta_ib_b, "dv_now": dv_b, **earlier}
        dtheta, dv = function(*(np.moveaxis(given[name], -1, 0) for name in NAMES))
        return {"dtheta_ib_b": np.stack(dtheta, -1), "dv_b": np.stack(dv, -1)}

    return call


def test_two_samples_are_what_the_step_does_itself():
    assert coning_coefficients(2) == [Rational(1, 12)]
    rng = np.random.default_rng(1)
    given = dict(zip(["dtheta_ib_b", "dv_b", *NAMES[2:]], rng.standard_normal((8, 3)), strict=True))
    made = by(2)(**given)
    assert np.array_equal(made["dtheta_ib_b"], given["dtheta_ib_b"]) and np.array_equal(made["dv_b"], given["dv_b"])


@pytest.mark.parametrize("samples", [2, 3, 4, 5])
def test_the_rate_left_of_pure_coning_falls_with_twice_the_samples(samples):
    """Against (x - sin x) / 2 in closed form, over x."""
    x = np.array([0.2, 0.1])
    k = np.array(coning_coefficients(samples), float)
    seen = sum(k[j - 1] * 2 * (1 - np.cos(x)) * np.sin(j * x) for j in range(1, samples))
    left = ((x - np.sin(x)) / 2 - seen) / x
    assert np.log2(left[0] / left[1]) == pytest.approx(2 * samples, abs=0.15)


def test_four_samples_err_a_hundredth_of_what_two_do_at_5_hz_and_50_hz_samples():
    motion = vibrating(10.0)
    two, four = (errors(motion, 50, 10.0, one) for one in (None, by(4)))
    assert 2e-3 < np.linalg.norm(two[0]) / DEG < 5e-3  # .2 deg in ten minutes
    assert np.linalg.norm(four[0]) < np.linalg.norm(two[0]) / 100
    assert np.linalg.norm(four[1]) < np.linalg.norm(two[1]) / 10
