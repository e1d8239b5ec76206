"""Waves: the laws of a spectrum, and of the sum of sinusoids that stands for it."""

import numpy as np
import pytest

from boresight import BoresightError
from boresight.runtime.simulation import sea, sensors

OMEGA = np.linspace(1e-3, 30.0, 300001)


def moment(density, n):
    return np.trapezoid(density * OMEGA**n, OMEGA)


@pytest.mark.parametrize("gamma", [1.0, 3.3, 7.0])
@pytest.mark.parametrize("height, peak", [(0.5, 1.3), (4.0, 0.6)])
def test_significant_height_is_four_standard_deviations(height, peak, gamma):
    assert 4 * np.sqrt(moment(sea.density(OMEGA, height, peak, gamma), 0)) == pytest.approx(height, rel=1e-5)
    omega, amplitude = sea.components(height, peak, gamma=gamma)
    assert 4 * np.sqrt(np.sum(amplitude**2) / 2) == pytest.approx(height, rel=2e-4)
    assert np.all(np.diff(omega) > 0)


def test_zero_crossing_period_is_that_of_pierson_and_moskowitz():
    """m0 / m2 = 1 / sqrt(pi B) with B = 1.25 peak^4, in closed form."""
    peak = 0.8
    period = 2 * np.pi / (np.pi * 1.25) ** 0.25 / peak
    spectrum = sea.density(OMEGA, 2.0, peak)
    assert 2 * np.pi * np.sqrt(moment(spectrum, 0) / moment(spectrum, 2)) == pytest.approx(period, rel=1e-3)
    omega, amplitude = sea.components(2.0, peak)
    by_components = 2 * np.pi * np.sqrt(np.sum(amplitude**2) / np.sum((omega * amplitude) ** 2))
    assert by_components == pytest.approx(period, rel=0.008)  # m2 lacks 1.3 % above ten times the peak

    # and as it is counted: upward crossings in three hours of sea, whose number scatters by 2 %
    time = np.arange(0, 3 * 3600, 0.1)
    phase = 2 * np.pi * sensors.generator(0, 0).random(omega.size)
    elevation = np.concatenate([np.cos(part[:, None] * omega + phase) @ amplitude for part in np.array_split(time, 60)])
    crossings = np.sum((elevation[:-1] < 0) & (elevation[1:] >= 0))
    assert time[-1] / crossings == pytest.approx(period, rel=0.05)
    assert 4 * elevation.std() == pytest.approx(2.0, rel=0.02)


def test_a_developed_sea_of_any_height_has_the_same_tail():
    for height in (0.1, 0.5, 4.0):
        peak = float(sea.fully_developed_peak(height))
        tail = sea.density(20 * peak, height, peak)
        assert tail == pytest.approx(0.0081 * 9.80665**2 / (20 * peak) ** 5, rel=1e-4)
    # 4 m: the waves of the paper's 0.1 Hz
    assert sea.fully_developed_peak(4.0) / (2 * np.pi) == pytest.approx(0.1, rel=0.01)


def test_jonswap_has_its_peak_there_and_higher():
    high, plain = sea.density(1.0, 2.0, 1.0, 3.3), sea.density(1.0, 2.0, 1.0)
    assert 3.3 / 1.7 < high / plain < 3.3  # 3.3 times, less what the height that is kept takes away
    with pytest.raises(BoresightError, match="gamma"):
        sea.density(1.0, 2.0, 1.0, 0.5)


def test_many_seas_at_once_and_none_of_no_height():
    omega, amplitude = sea.components(np.array([[0.5], [2.0]]), count=40)
    assert omega.shape == amplitude.shape == (2, 1, 40)
    one = sea.components(2.0, count=40)
    assert np.array_equal(omega[1, 0], one[0]) and np.array_equal(amplitude[1, 0], one[1])
    with pytest.raises(BoresightError, match="above zero"):
        sea.components(np.array([1.0, 0.0]))
