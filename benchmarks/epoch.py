"""A minute of one run from Python beside the loop in C: python -m benchmarks.epoch

The azimuth hold of 15 states at rest: 100 samples a second, and every second a prediction, two measurements (four rows)
and a correction.  By processor time, the candidates interleaved; the numbers that are flown are made beforehand.
"""

import ctypes
import hashlib
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from benchmarks import interleaved
from boresight.runtime.compiler import open_library, shared_library
from boresight.runtime.filter import CompiledFilter, Epoch
from boresight.runtime.library import load

MODEL, SECONDS, RATE = "azimuth-hold", 60, 100
NOISE = {"gyro_noise": 1e-4, "accel_noise": 5e-3, "gyro_bias_noise": 1e-7, "accel_bias_noise": 1e-5}
SIGMA = np.array([1e-6, 1e-6, 5, 0.1, 0.1, 0.1, 0.01, 0.01, 0.02, *3 * (1e-5,), *3 * (0.01,)])
NAV = {"lon_lat_height": np.array([0.5, 0.75, 100.0]), "v_n": np.array([0.01, -0.02, 0.0]),
       "q_b2n_wxyz": np.array([1.0, 0, 0, 0]), "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3)}  # fmt: skip
REFERENCE, R_ZUPT, R_AZIMUTH = np.array([1.0, 0, 0, 0]), np.full(3, 1e-4), np.full(1, 1e-6)
LOOP = r"""
#include "azimuth_hold_filter.h"

int minute(const ah_nav *nav, const double *sigma, const ah_increments *increments, const ah_noise *noise,
           const ah_reference *reference, const double *R, double *end);

int minute(const ah_nav *nav, const double *sigma, const ah_increments *increments, const ah_noise *noise,
           const ah_reference *reference, const double *R, double *end)
{
    static ah_filter filter;
    const ah_corrected_imu sample = { .dt = 0.01 };
    const ah_corrected_imu second = { .dt = 1.0, .f_b = { 0.0, 0.0, 9.8 } };
    ah_innovation innovation;
    int refused = ah_filter_init_sigmas(&filter, nav, sigma) != BS_OK;
    for (int k = 0; k < 60; ++k) {
        for (int i = 0; i < 100; ++i) {
            refused += ah_filter_strapdown(&filter, &sample, &increments[(100 * k) + i]) != BS_OK;
        }
        refused += ah_filter_propagate(&filter, &second, noise) != BS_OK;
        refused += ah_filter_measure_zupt(&filter, &R[0], NULL, &innovation) != BS_OK;
        refused += ah_filter_measure_azimuth(&filter, reference, &R[3], NULL, &innovation) != BS_OK;
        refused += ah_filter_correct(&filter) != BS_OK;
    }
    for (int i = 0; i < 4; ++i) {
        end[i] = filter.nav.q_b2n_wxyz[i];
    }
    return refused;
}
"""


def recorded():
    """(6000, 3) each: dtheta_ib_b, dv_b, and both of the sample before."""
    rng = np.random.default_rng(1)
    dtheta = rng.normal(0, 1e-5, (SECONDS * RATE, 3)) + np.array([0, 5.5e-7, 4.8e-7])
    dv = rng.normal(0, 1e-4, (SECONDS * RATE, 3)) + np.array([0, 0, 0.098])
    first = np.zeros((1, 3))
    return {"dtheta_ib_b": dtheta, "dv_b": dv, "dtheta_before": np.vstack([first, dtheta[:-1]]),
            "dv_before": np.vstack([first, dv[:-1]])}  # fmt: skip


def in_c(library, increments, folder):
    """The loop in C, as one call."""
    source = folder / "minute.c"
    source.write_text(LOOP)
    sources = {path: () for path in sorted((library.folder / "src").glob("*.c"))}
    digest = hashlib.sha256(LOOP.encode()).hexdigest() + library.manifest["hash"]
    made = open_library(*shared_library("bench-minute", digest, {source: (), **sources}, library.folder / "include"))

    def struct(name, values):
        array = np.zeros((*np.shape(next(iter(values.values())))[:-1], library.width[name]))
        for field, part in library.layout[name].items():
            array[..., part] = values[field]
        return array

    given = [struct("nav", NAV), SIGMA, struct("increments", increments),
             struct("noise", {name: np.full(3, value) for name, value in NOISE.items()}),
             struct("reference", {"q_ref_wxyz": REFERENCE}), np.concatenate([R_ZUPT, R_AZIMUTH])]  # fmt: skip

    def fly():
        end = np.zeros(4)
        assert not made.minute(*(ctypes.c_void_p(array.ctypes.data) for array in (*given, end)))
        return end

    return fly


def of(loop, samples, **more):
    """An Epoch whose inputs that do not change are set."""
    epoch = Epoch(loop, samples, **more)
    if samples:
        epoch.strapdown["dt"] = 1 / RATE
    for name in epoch.predict.fields:
        epoch.predict[name] = {"dt": 1.0, "f_b": np.array([0, 0, 9.8]), **NOISE}[name]
    for name, R in (("zupt", R_ZUPT), ("azimuth", R_AZIMUTH)):
        if name in epoch.measured:
            epoch.measured[name]["R"] = R
    return epoch


def by_epochs(library, increments):
    """One call a second."""

    def fly():
        loop = CompiledFilter(library, NAV, np.diag(SIGMA**2))
        epoch = of(loop, RATE, measurements=["zupt", "azimuth"])
        epoch.measured["azimuth"]["q_ref_wxyz"] = REFERENCE
        into = [(epoch.strapdown[name], increments[name]) for name in increments]
        for k in range(SECONDS):
            for view, recording in into:
                view[...] = recording[RATE * k : RATE * (k + 1)]
            assert not epoch(), epoch.refused()
        return loop.nav["q_b2n_wxyz"]

    return fly


def by_samples(library, increments):
    """The readable loop, its strapdown bound: an Epoch of one sample."""

    def fly():
        loop = CompiledFilter(library, NAV, np.diag(SIGMA**2))
        step = of(loop, 1, predict=False, feedback=False)
        dtheta, dv = step.strapdown["dtheta_ib_b"], step.strapdown["dv_b"]
        dtheta_before, dv_before = step.strapdown["dtheta_before"], step.strapdown["dv_before"]
        recordings = [increments[name] for name in ("dtheta_ib_b", "dv_b", "dtheta_before", "dv_before")]
        for k, (now, push, was, pushed) in enumerate(zip(*recordings, strict=True)):
            dtheta[0], dv[0], dtheta_before[0], dv_before[0] = now, push, was, pushed
            assert not step()
            if (k + 1) % RATE == 0:
                loop.predict(dt=1.0, f_b=np.array([0, 0, 9.8]), **{name: np.full(3, v) for name, v in NOISE.items()})
                loop.update("zupt", R_ZUPT)
                loop.update("azimuth", R_AZIMUTH, q_ref_wxyz=REFERENCE)
                loop.feedback()
        return loop.nav["q_b2n_wxyz"]

    return fly


def main():
    library, increments = load(MODEL), recorded()
    with TemporaryDirectory() as folder:
        flights = {
            "the loop in C": in_c(library, increments, Path(folder)),
            "one call an epoch": by_epochs(library, increments),
            "the readable loop, strapdown bound": by_samples(library, increments),
        }
    ends = [fly() for fly in flights.values()]
    assert all(np.array_equal(end, ends[0]) for end in ends), "the flights do not end alike"
    best = interleaved(flights)
    print(f"{'60 s of one run':<40}{'ms':>8}{'over the C':>12}")
    for name, seconds in best.items():
        print(f"{name:<40}{seconds * 1e3:8.2f}{seconds / best['the loop in C']:12.2f}")


if __name__ == "__main__":
    sys.exit(main())
