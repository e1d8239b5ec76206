"""A gate that is widened by what is not linear yet, never open: outliers are refused from the first message on."""

import numpy as np
import pytest

from boresight.evidence.flights.conditions import once, turned, with_field
from boresight.evidence.flights.fly import Unit, band, fly
from boresight.evidence.flights.motion import DEG, parked, swinging
from boresight.runtime.transfer import Verdict
from boresight.runtime.transfer.gate import second_order

WIDE = {"tau_sigma": 0.0501, "lost": 0.0}  # of the delay: beyond `coarse_s`


def faster(by):
    return with_field(v_m_n=lambda v: v + np.array([by, 0.0, 0.0]))


def mounted(heading_deg):
    return Unit(mounting=(0.6 * DEG, 0.6 * DEG, heading_deg * DEG))


@pytest.mark.parametrize(
    ("fault", "known"),
    [(faster(500.0), WIDE), (turned([0, 0, 90]), WIDE),
     (turned([0, 0, 20]), {"tau_sigma": 0.02, "lost": 0.0, "unit": mounted(10)})],
    ids=["500 m/s", "90 deg", "20 deg of a mounting of 10"],
)  # fmt: skip
def test_a_parked_vehicle_refuses_one_wrong_message(fault, known):
    flight = fly(parked(seconds=58), runs=4, seconds=56.0, master_hz=2, imu_hz=25, said=once(55.0, fault), **known)
    at = np.searchsorted(flight.time, 55.0)
    assert (flight.verdict[at] == Verdict.GATED).all()
    assert (np.delete(flight.verdict, at, axis=0) == Verdict.TAKEN).all()


@pytest.mark.parametrize("at", [0.9, 4.1])
@pytest.mark.parametrize("fault", [faster(3.0), faster(20.0), turned([0, 0, 90])], ids=["3 m/s", "20 m/s", "90 deg"])
def test_one_message_that_is_off_while_the_delay_is_unknown_is_refused_and_the_rest_is_taken(fault, at):
    flight = fly(swinging(seconds=12), runs=8, seconds=9.0, said=once(at, fault), **WIDE)
    faulty = np.searchsorted(flight.time, at)
    assert (flight.verdict[faulty] == Verdict.GATED).all()
    assert (np.delete(flight.verdict, faulty, axis=0) == Verdict.TAKEN).all()
    low, high = band(8, 16)
    assert low < flight.nees[-1].mean() < high


@pytest.mark.parametrize(("deg", "most"), [(6, 0.01), (17, 0.02)])
def test_healthy_messages_of_a_heading_that_is_hardly_known_are_taken(deg, most):
    flight = fly(swinging(seconds=12), runs=60, seconds=8.0, unit=mounted(deg), **WIDE)
    assert np.mean(flight.verdict > Verdict.REOPENED) <= most
    low, high = band(60, 16)
    assert low < flight.nees[-1].mean() < high


def test_mean_and_covariance_of_the_second_order_are_those_of_a_quadratic_form():
    rng = np.random.default_rng(2)
    A, root = rng.standard_normal((2, 4, 4)), np.tril(rng.standard_normal((4, 4)))
    A, P = A + np.swapaxes(A, -1, -2), root @ root.T

    def z(x):
        return x[..., :2] + np.einsum("...i,mij,...j->...m", x, A, x) / 2

    m, S2 = second_order(z, P, range(4), np.full(4, 0.3))
    assert m == pytest.approx([np.trace(a @ P) / 2 for a in A])
    np.testing.assert_allclose(S2, [[np.trace(a @ P @ b @ P) / 2 for b in A] for a in A])
