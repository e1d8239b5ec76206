"""The windowed stationary detectors: what their templates are filled with, and golden vectors in exact arithmetic."""

import random
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import mpmath as mp
import numpy as np

from boresight.codegen.text.names import number, rows_of, three_digits

MAX_WINDOW = 256
DIGITS = 50
U = mp.mpf(2) ** -53  # unit roundoff of a double
U_FLOAT = mp.mpf(2) ** -24  # of a float

# name, unit, formula, meaning, where it comes from
DETECTORS = (
    ("gyro_mean", "rad/s", "|mean(w)|", "norm of the mean angular rate", "kim-2018 (32), with the norm"),
    ("gyro_std", "rad/s", "sqrt(mean(|w - mean(w)|^2))", "spread of the angular rate", "kim-2018 (31), of the rate"),
    ("accel_mean", "m/s^2", "||mean(f)| - g|", "mean specific force against gravity", "named beside kim-2018 (31)"),
    ("accel_std", "m/s^2", "sqrt(mean(|f - mean(f)|^2))", "spread of the specific force", "kim-2018 (31)"),
    (
        "likelihood_ratio",
        "1",
        "mean(|f - g mean(f)/|mean(f)||^2 / sigma_accel^2 + |w|^2 / sigma_gyro^2)",
        "generalized likelihood ratio",
        "Skog et al. 2010",
    ),
)

# What the C accepts: samples and settings, both ends included.
BOX = {
    "gyro": (-100.0, 100.0),
    "accel": (-1e4, 1e4),
    "gravity": (0.1, 100.0),
    "sigma_accel": (1e-9, 1e3),
    "sigma_gyro": (1e-12, 1e3),
    "threshold": (0.0, 1e30),
}


def description() -> dict[str, Any]:
    """Everything the templates ask for, and what the manifest says of the kernel."""
    return {
        "name": "stationary-detector",
        "title": "windowed stationary detectors of an inertial sensor",
        "prefix": "det",
        "max_window": MAX_WINDOW,
        "digits": DIGITS,
        "detectors": [
            dict(zip(("name", "unit", "formula", "meaning", "source"), detector, strict=True)) for detector in DETECTORS
        ],
        "box": {name: {"low": number(low), "high": number(high)} for name, (low, high) in BOX.items()},
        "span": {name: f"{low:.6g} to {high:.6g}" for name, (low, high) in BOX.items()},
        "cases": [golden(*case) for case in cases()],
        "manifest": {
            "max_window": MAX_WINDOW,
            "detectors": [{"name": name, "unit": unit} for name, unit, *_ in DETECTORS],
            "box": BOX,
        },
    }


# ---------------------------------------------------------------- golden vectors


Sample = tuple[float, ...]  # gyro x y z, accel x y z
Case = tuple[str, int, float, float, float, list[Sample]]  # title, window, gravity, the two sigmas, samples


def cases() -> list[Case]:
    """Short recordings: rest, a small spread on a large mean, an axis in free fall, corners of the box."""
    rng = random.Random(20)

    def noisy(count: int, mean: Sequence[float], sigma: Sequence[float]) -> list[Sample]:
        """Evenly spread over two sigmas to either side; a logarithm is another one on another machine."""
        return [tuple(m + s * (4 * rng.random() - 2) for m, s in zip(mean, sigma, strict=True)) for _ in range(count)]

    gyro, accel = (BOX[name][1] for name in ("gyro", "accel"))
    moving = [tuple(v * (1 + 0.5 * (k % 5)) for v in (0.3, -0.2, 0.1, 0.5, 1.0, -9.0)) for k in range(6)]
    return [
        ("at rest, then turning", 8, 9.81, 2e-3, 8e-4,
         noisy(10, (1e-3, -1e-3, 0, 0.1, 0, -9.8), (8e-4,) * 3 + (2e-3,) * 3) + moving),
        ("a spread of 1e-5 on a mean of 100", 25, 9.81, 1e-3, 1e-6, noisy(27, (50, -50, 1, 100, 1, -10), (1e-5,) * 6)),
        ("no force at all", 2, 9.81, 1e-2, 1e-3, [(0.0,) * 6, (0.0,) * 6, (0.1, 0, 0, 0, 0, 0), (0.0,) * 6]),
        ("ends of the box", 3, 9.81, 1e-3, 1e-3,
         [tuple(s * v for s, v in zip(signs, (gyro,) * 3 + (accel,) * 3, strict=True))
          for signs in ((1,) * 6, (-1,) * 6, (1, -1, 1, -1, 1, -1), (-1, 1, 1, 1, 1, 1))]),
    ]  # fmt: skip


def golden(
    title: str, window: int, gravity: float, sigma_accel: float, sigma_gyro: float, samples: list[Sample]
) -> Any:
    """One case as text: samples, and for each from the first full window on the statistics and their tolerances.

    All inputs are moved to numbers that a float holds, so that the case serves either precision.
    """
    gravity, sigma_accel, sigma_gyro = (single(v) for v in (gravity, sigma_accel, sigma_gyro))
    samples = [tuple(map(single, sample)) for sample in samples]
    expected, in_float = (
        [
            statistics(samples[k - window : k], gravity, sigma_accel, sigma_gyro, u)
            for k in range(window, len(samples) + 1)
        ]
        for u in (U, U_FLOAT)
    )

    def tolerances(rows: list[list[tuple[Any, Any]]]) -> str:
        """The rounding of the expected value itself comes on top."""
        return rows_of(
            [[float((bound + value * U) * (1 + 4 * U)) for value, bound in row] for row in rows], three_digits
        )

    return {
        "title": title,
        "window": window,
        "settings": ", ".join(v.hex() for v in (gravity, sigma_accel, sigma_gyro)),
        "count": len(samples),
        "decisions": len(expected),
        "samples": rows_of(samples),
        "expected": rows_of([[float(value) for value, _ in row] for row in expected]),
        "tolerances": tolerances(expected),
        "float_tolerances": tolerances(in_float),
    }


def single(value: float) -> float:
    """The nearest number that a float holds."""
    return float(np.float32(value))


def statistics(
    samples: Sequence[Sample], gravity: float, sigma_accel: float, sigma_gyro: float, u: Any = U
) -> list[tuple[Any, Any]]:
    """The five statistics of one window in 50 digits, each with a bound on the rounding errors of the C.

    u: unit roundoff of the precision that the C is compiled for.

    The likelihood ratio is taken from its definition, the residual from gravity along the mean, and not in the form
    that the C evaluates; without any force the direction is free and the residual is |f|^2 + g^2 whatever it is.
    """
    with mp.workdps(DIGITS):
        n = len(samples)
        rows = [[Fraction(v) for v in sample] for sample in samples]
        mean = [sum(column, Fraction(0)) / n for column in zip(*rows, strict=True)]
        sizes = [exact(sum((abs(v) for v in column), Fraction(0)) / n) for column in zip(*rows, strict=True)]
        error = [gamma(n, u) * size for size in sizes]
        parts = []
        for axes in (range(3), range(3, 6)):
            norm = mp.sqrt(exact(sum((mean[i] ** 2 for i in axes), Fraction(0))))
            moved = mp.sqrt(sum(error[i] ** 2 for i in axes))  # how far the computed mean may be off
            spread = exact(sum(((row[i] - mean[i]) ** 2 for row in rows for i in axes), Fraction(0)) / n)
            norm_error = moved + gamma(5, u) * (norm + moved)
            # the sum of squares about a mean that is off by d is larger by n d^2: exact, and of second order
            spread_error = moved**2 + gamma(3 * n + 4, u) * (spread + moved**2)
            parts.append((norm, norm_error, spread, spread_error))
        (gm, gm_error, gs, gs_error), (am, am_error, fs, fs_error) = parts
        off = abs(am - exact(Fraction(gravity)))
        off_error = am_error + u * (off + am_error)
        direction = [exact(mean[i]) / am for i in range(3, 6)] if am else [mp.mpf(1), mp.mpf(0), mp.mpf(0)]
        g, sa, sw = (exact(Fraction(v)) for v in (gravity, sigma_accel, sigma_gyro))
        ratio = mp.mpf(0)
        for row in rows:
            ratio += sum((exact(row[3 + i]) - g * direction[i]) ** 2 for i in range(3)) / sa**2
            ratio += sum(exact(row[i]) ** 2 for i in range(3)) / sw**2
        ratio /= n
        slack = (fs_error + (2 * off + off_error) * off_error) / sa**2
        slack += (gs_error + (2 * gm + gm_error) * gm_error) / sw**2
        return [
            (gm, gm_error),
            (mp.sqrt(gs), root_error(gs, gs_error, u)),
            (off, off_error),
            (mp.sqrt(fs), root_error(fs, fs_error, u)),
            (ratio, slack + gamma(8, u) * (ratio + slack)),
        ]


def exact(value: Fraction) -> Any:
    return mp.mpf(value.numerator) / value.denominator


def gamma(n: int, u: Any) -> Any:
    """n roundings one after another."""
    return n * u / (1 - n * u)


def root_error(square: Any, error: Any, u: Any) -> Any:
    """Of the square root of a number that is off by `error`, and of the rounding of the root."""
    high = mp.sqrt(square + error)
    low = mp.sqrt(max(square - error, mp.mpf(0)))
    return max(high - mp.sqrt(square), mp.sqrt(square) - low) + u * high
