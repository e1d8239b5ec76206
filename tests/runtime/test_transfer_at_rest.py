"""At rest nothing shows the heading, and a tilt passes for a bias: what the filter then claims to know.

Held against the independent simulator; NEES in its 99.9 % band; seeds fixed beforehand.
"""

import numpy as np
import pytest

from boresight.evidence.flights.conditions import FINE
from boresight.evidence.flights.fly import band, fly
from boresight.evidence.flights.motion import Motion
from boresight.runtime.transfer.history import DOWN, MOUNT
from boresight.runtime.units import DEG

RUNS = 30


@pytest.fixture(scope="module")
def parked():
    return fly(Motion(seconds=22), runs=RUNS, unit=FINE, seconds=20.0)


def test_a_parked_slave_with_large_biases_is_as_wrong_as_P_says(parked):
    low, high = band(RUNS, 16)
    late = parked.nees[parked.time > 5.0].mean()
    assert low < late < high
    assert low < parked.nees[-1].mean() < high


def test_at_rest_the_noise_of_the_sensors_tells_nothing_of_heading_or_level(parked):
    sigma = np.sqrt(np.einsum("krii->kri", parked.P)).mean(1)
    assert sigma[-1, DOWN] > 0.98 * 2 * DEG
    assert (sigma[-1, MOUNT] > 0.97 * sigma[np.searchsorted(parked.time, 5.0), MOUNT]).all()
