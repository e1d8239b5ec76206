"""What libraries have, and norms, by + - * / and square root alone, within 4 ulp; a sine for arguments of some turns.

Those operations are rounded alike everywhere; NumPy's own functions are others on another processor.  Points and
tolerances of the self-tests hang on these numbers, and must come out the same bit for bit.
"""

from collections.abc import Sequence
from math import e as E
from math import factorial, pi
from typing import Any

import mpmath as mp
import numpy as np

SINE = [(-1) ** n / factorial(2 * n + 1) for n in range(9)]
COSINE = [(-1) ** n / factorial(2 * n) for n in range(9)]
ARCTANGENT = [(-1) ** n / (2 * n + 1) for n in range(12)]
EXPONENTIAL = [1 / factorial(n + 2) for n in range(14)]  # behind 1 + x, over x^2
HYPERBOLIC_SINE = [1 / factorial(2 * n + 1) for n in range(11)]
HYPERBOLIC_COSINE = [1 / factorial(2 * n) for n in range(11)]
LOGARITHM = [1 / (2 * n + 3) for n in range(11)]  # of (1 + f) / (1 - f): behind 2 f, over 2 f^3


def thirds(value: Any) -> tuple[float, ...]:
    """A number between 1/2 and 2 as a sum of three, of which the first two have 33 bits: twenty more may be multiplied
    exactly."""
    rest, parts = value, []
    for shift in (32, 66):
        parts.append(mp.ldexp(mp.nint(mp.ldexp(rest, shift)), -shift))
        rest -= parts[-1]
    return tuple(map(float, (*parts, rest)))


with mp.workprec(200):
    HALF_PI, LOG_2 = thirds(mp.pi / 2), thirds(mp.log(2))


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


def arctangent(x: np.ndarray) -> np.ndarray:
    return arctangent2(x, np.ones_like(x))


def arcsine(x: np.ndarray) -> np.ndarray:
    return arctangent2(x, np.sqrt((1 - x) * (1 + x)))


def arccosine(x: np.ndarray) -> np.ndarray:
    return arctangent2(np.sqrt((1 - x) * (1 + x)), x)


def exponential(x: np.ndarray) -> np.ndarray:
    rest = np.clip(x, -746, 710)  # beyond which it is zero and infinite
    doublings = np.rint(rest / sum(LOG_2))
    for part in LOG_2:
        rest = rest - doublings * part
    power = 1 + (rest + rest * rest * polynomial(EXPONENTIAL, rest))
    return np.ldexp(power, np.nan_to_num(doublings).astype(int))


def logarithm(x: np.ndarray) -> np.ndarray:
    part, doublings = np.frexp(np.where(x > 0, x, np.nan))
    low = part < np.sqrt(0.5)
    part, doublings = np.where(low, 2 * part, part), doublings - low
    f = (part - 1) / (part + 1)
    square = f * f
    # 2 f = (part - 1) - f (part - 1): the sum keeps what a rounding of f would lose
    rest = (part - 1) - f * ((part - 1) - 2 * square * polynomial(LOGARITHM, square))
    high, middle, low = LOG_2
    return doublings * high + (doublings * middle + (doublings * low + rest))


def hyperbolic_sine(x: np.ndarray) -> np.ndarray:
    power = exponential(abs(x) - 1)
    large = np.copysign(power * (E / 2) - 1 / (power * (2 * E)), x)
    return np.where(abs(x) < 1, x * polynomial(HYPERBOLIC_SINE, x * x), large)


def hyperbolic_cosine(x: np.ndarray) -> np.ndarray:
    power = exponential(abs(x) - 1)
    return power * (E / 2) + 1 / (power * (2 * E))


def hyperbolic_tangent(x: np.ndarray) -> np.ndarray:
    small = polynomial(HYPERBOLIC_SINE, x * x) / polynomial(HYPERBOLIC_COSINE, x * x) * x
    power = exponential(-2 * abs(x))
    return np.where(abs(x) < 0.5, small, np.copysign((1 - power) / (1 + power), x))


def larger(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """As C has it: the second of two zeros, and no number where one of them is none."""
    return np.where(a > b, a, np.where(a <= b, b, a + b))


def smaller(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.where(a < b, a, np.where(a >= b, b, a + b))


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
