"""Sine, cosine, arctangent and norms by + - * / and square root alone, within 4 ulp for arguments of some turns.

Those operations are rounded alike everywhere; NumPy's own functions are others on another processor.  Points and
tolerances of the self-tests hang on these numbers, and must come out the same bit for bit.
"""

from collections.abc import Sequence
from math import factorial, pi

import mpmath as mp
import numpy as np

SINE = [(-1) ** n / factorial(2 * n + 1) for n in range(9)]
COSINE = [(-1) ** n / factorial(2 * n) for n in range(9)]
ARCTANGENT = [(-1) ** n / (2 * n + 1) for n in range(12)]


def thirds_of_half_pi() -> tuple[float, ...]:
    """pi / 2 as a sum of three numbers, of which the first two have 33 bits: twenty more may be multiplied exactly."""
    with mp.workprec(200):
        rest, parts = mp.pi / 2, []
        for shift in (32, 66):
            parts.append(mp.ldexp(mp.nint(mp.ldexp(rest, shift)), -shift))
            rest -= parts[-1]
        return tuple(map(float, (*parts, rest)))


HALF_PI = thirds_of_half_pi()


def polynomial(coefficients: Sequence[float], x: np.ndarray) -> np.ndarray:
    total = np.full_like(x, coefficients[-1])
    for coefficient in coefficients[-2::-1]:
        total = total * x + coefficient
    return total


def sine_and_cosine(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    quarters = np.rint(x * (2 / pi))
    rest = x
    for part in HALF_PI:
        rest = rest - quarters * part
    square = rest * rest
    s, c = rest * polynomial(SINE, square), polynomial(COSINE, square)
    turned = quarters - 4 * np.floor(quarters / 4)
    odd = (turned == 1) | (turned == 3)
    s, c = np.where(odd, c, s), np.where(odd, s, c)
    return np.where(turned >= 2, -s, s), np.where((turned == 1) | (turned == 2), -c, c)


def sine(x: np.ndarray) -> np.ndarray:
    return sine_and_cosine(x)[0]


def cosine(x: np.ndarray) -> np.ndarray:
    return sine_and_cosine(x)[1]


def slope_and_larger(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The smaller over the larger of the magnitudes, 0 if both are 0, and the larger."""
    large = np.maximum(abs(x), abs(y))
    return np.minimum(abs(x), abs(y)) / np.where(large > 0, large, large + 1), large


def arctangent2(y: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Of y / x, in the quadrant of (x, y)."""
    ratio, _ = slope_and_larger(x, y)
    steep = ratio > 0.4
    ratio = np.where(steep, (ratio - 1) / (ratio + 1), ratio)
    half = ratio / (1 + np.sqrt(1 + ratio * ratio))  # the tangent of half the angle
    angle = 2 * half * polynomial(ARCTANGENT, half * half)
    angle = np.where(steep, pi / 4 + angle, angle)
    angle = np.where(abs(y) > abs(x), pi / 2 - angle, angle)
    return np.copysign(np.where(np.signbit(x), pi - angle, angle), y)


def hypotenuse(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """sqrt(x^2 + y^2), where the squares may be too small for a double."""
    ratio, large = slope_and_larger(x, y)
    return large * np.sqrt(1 + ratio * ratio)


def norm(rows: np.ndarray) -> np.ndarray:
    """(points, 1) from (points, size), summed from the left."""
    total = np.zeros(len(rows))
    for i in range(rows.shape[1]):
        total = total + rows[:, i] * rows[:, i]
    return np.sqrt(total)[:, None]
