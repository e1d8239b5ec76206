"""What a decision of the stationary detectors costs: the C alone, from a Python loop, and NumPy's sliding windows.

python -m benchmarks.detector
"""

from time import perf_counter

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from boresight.runtime import detector as d

SAMPLES = 10_000


def best(function, rounds=5):
    """Seconds a sample, of the fastest round."""
    times = []
    for _ in range(rounds):
        start = perf_counter()
        function()
        times.append(perf_counter() - start)
    return min(times) / SAMPLES


def numpy_ratio(settings, gyro, accel):
    """The likelihood ratio of every window, as one would write it in NumPy."""
    w, f = (sliding_window_view(part, settings.window, axis=0) for part in (gyro, accel))
    mean = f.mean(axis=-1)
    u = mean / np.linalg.norm(mean, axis=-1, keepdims=True)
    off = ((f - settings.gravity * u[..., None]) ** 2).sum(axis=(1, 2)) / settings.sigma_accel**2
    return (off + (w**2).sum(axis=(1, 2)) / settings.sigma_gyro**2) / settings.window


def main() -> None:
    rng = np.random.default_rng(0)
    gyro, accel = 1e-3 * rng.standard_normal((SAMPLES, 3)), 4e-3 * rng.standard_normal((SAMPLES, 3)) + [0, 0, -9.81]
    dll = d.library()
    print("window   C, ns a sample   Python loop, us   NumPy, likelihood ratio alone, ns a sample")
    for window in (10, 25, 50, 100, 256):
        settings = d.settings(window, 4e-3, 1e-3, 1e-3)
        whole = best(lambda s=settings: d.evaluate(s, gyro, accel, dll=dll))
        vectorised = best(lambda s=settings: numpy_ratio(s, gyro, accel), 2)
        loop = d.Detector(settings)
        single = best(lambda x=loop: [x.push(w, f) for w, f in zip(gyro, accel, strict=True)], 2)
        print(f"{window:6} {whole * 1e9:16.0f} {single * 1e6:17.2f} {vectorised * 1e9:20.0f}")


if __name__ == "__main__":
    main()
