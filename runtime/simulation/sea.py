"""Long-crested waves in deep water: the spectrum of a sea state, as a sum of sinusoids.

Frequencies are rad/s as seen from a point at rest; elevation is metres, upwards.
"""

from functools import cache
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.units import STANDARD_GRAVITY

LOWEST, HIGHEST = 0.5, 10.0  # of the peak frequency: 2e-9 of the elevation's variance lies below, 1e-4 above


def wave_number(omega: Any) -> Array:
    """rad/m of deep water."""
    return np.asarray(omega, float) ** 2 / STANDARD_GRAVITY


def fully_developed_peak(height_m: Any) -> Array:
    """Peak frequency, rad/s, of a Pierson-Moskowitz sea of this significant height.

    Its energy ends as 0.0081 g^2 / omega^5 whatever the wind, so that the height alone tells the period.
    """
    return np.sqrt(4 * np.sqrt(0.0081 / 5) * STANDARD_GRAVITY / np.asarray(height_m, float))


def density(omega: Any, height_m: Any, peak_rad_s: Any, gamma: float = 1.0) -> Array:
    """One-sided density of the elevation, m^2 s/rad: Pierson-Moskowitz, or JONSWAP with gamma above 1.

    Scaled so that 4 sqrt(m0) is the significant height: exactly with gamma = 1, else by quadrature.
    """
    peak = np.asarray(peak_rad_s, float)
    scale = 5 / 16 * np.asarray(height_m, float) ** 2 / peak
    return scale / _jonswap_area(gamma) * _shape(np.asarray(omega, float) / peak, gamma)


def _shape(ratio: Array, gamma: float) -> Array:
    """Of omega / peak.  Its integral is 1/5 with gamma = 1."""
    ratio = np.maximum(ratio, 0.1)  # where exp(-1.25 / ratio^4) is zero already, and the power is not yet too large
    width = np.where(ratio > 1, 0.09, 0.07)
    peak = gamma ** np.exp(-0.5 * ((ratio - 1) / width) ** 2)
    return ratio**-5.0 * np.exp(-1.25 * ratio**-4.0) * peak


@cache
def _jonswap_area(gamma: float) -> float:
    """How much more energy the peak brings, of that without it."""
    if gamma < 1:
        raise BoresightError(
            f"the peak of a spectrum has gamma {gamma}; it is 1 or more (1 Pierson-Moskowitz, 3.3 JONSWAP)"
        )
    ratio = np.linspace(0.2, 40.0, 200001)
    with_peak, without = (np.trapezoid(_shape(ratio, peak), ratio) for peak in (gamma, 1.0))
    return float(with_peak / without)


def components(height_m: Any, peak_rad_s: Any = None, *, gamma: float = 1.0, count: int = 120) -> tuple[Array, Array]:
    """The sea as sinusoids: frequencies (..., count) rad/s and elevation amplitudes (..., count) m.

    height_m, peak_rad_s: (...); without a peak frequency the sea is fully developed.  Bins grow geometrically from
    LOWEST to HIGHEST times the peak, so that the sum does not repeat; each carries its bin's energy at the frequency
    that keeps the bin's second moment.  The amplitudes are not random: every run has the significant height asked
    for, but for the 1e-4 of variance outside.
    """
    height = np.asarray(height_m, float)
    if not (np.isfinite(height).all() and (height > 0).all()):
        raise BoresightError("a sea has a significant height above zero; leave it out for a calm")
    peak = fully_developed_peak(height) if peak_rad_s is None else np.broadcast_to(peak_rad_s, height.shape)
    fine = 32
    edges = np.geomspace(LOWEST, HIGHEST, count * fine + 1)
    at, width = (edges[1:] + edges[:-1]) / 2, np.diff(edges)
    energy = density(at, 1.0, 1.0, gamma) * width  # 1 m with its peak at 1 rad/s: all others are images of it
    m0 = energy.reshape(count, fine).sum(-1)
    m2 = (energy * at**2).reshape(count, fine).sum(-1)
    return peak[..., None] * np.sqrt(m2 / m0), height[..., None] * np.sqrt(2 * m0)
