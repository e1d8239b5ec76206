"""What a decision of the stationary detectors costs: the C alone, from a Python loop, and NumPy's sliding windows.

python -m benchmarks.detector
"""

from functools import partial

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from benchmarks import interleaved
from boresight.runtime import detector as d

SAMPLES = 10_000


def numpy_ratio(settings, gyro, accel):
    """The likelihood ratio of every window, as one would write it in NumPy."""
    w, f = (sliding_window_view(part, settings.window, axis=0) for part in (gyro, accel))
    mean = f.mean(axis=-1)
    u = mean / np.linalg.norm(mean, axis=-1, keepdims=True)
    off = ((f - settings.gravity * u[..., None]) ** 2).sum(axis=(1, 2)) / settings.sigma_accel**2
    return (off + (w**2).sum(axis=(1, 2)) / settings.sigma_gyro**2) / settings.window


def pushed(loop: d.Detector, gyro: np.ndarray, accel: np.ndarray) -> None:
    for w, f in zip(gyro, accel, strict=True):
        loop.push(w, f)


def main() -> None:
    rng = np.random.default_rng(0)
    gyro, accel = 1e-3 * rng.standard_normal((SAMPLES, 3)), 4e-3 * rng.standard_normal((SAMPLES, 3)) + [0, 0, -9.81]
    dll = d.library()
    print("window   C, ns a sample   Python loop, us   NumPy, likelihood ratio alone, ns a sample")
    for window in (10, 25, 50, 100, 256):
        settings = d.settings(window, 4e-3, 1e-3, 1e-3)
        loop = d.Detector(settings)
        spent = interleaved(
            {
                "whole": partial(d.evaluate, settings, gyro, accel, dll=dll),
                "loop": partial(pushed, loop, gyro, accel),
                "numpy": partial(numpy_ratio, settings, gyro, accel),
            },
            rounds=5,
        )
        whole, single, vectorised = (seconds / SAMPLES for seconds in spent.values())
        print(f"{window:6} {whole * 1e9:16.0f} {single * 1e6:17.2f} {vectorised * 1e9:20.0f}")


if __name__ == "__main__":
    main()
