"""The bench experiment of Kang and others (2025): a slave at 400 Hz, a master at 10 Hz, at rest and rolling.

The paper gives the roll's amplitudes, 0.45, 0.78 and 1.18 degrees, and not its frequency; nor the sensors.
"""

from dataclasses import replace
from typing import Any

import numpy as np

from boresight.analysis.observability import since
from boresight.runtime.simulation import hull
from boresight.runtime.units import DEG
from boresight.studies.sea_state.flight import Scenario, fly, only
from boresight.studies.study import table

AMPLITUDE_DEG = (0.0, 0.45, 0.78, 1.18)  # at rest, and the paper's three cases
CASES = ("at rest", "case 1", "case 2", "case 3")
PAPER_DEG = (1.90, 0.15, 0.15, 0.15)
FREQUENCY_HZ = 0.2
GYRO_AXES_MRAD = 3.0  # cross-axis sensitivity of a MEMS gyro, 0.3 %


def bench(frequency_hz: float = FREQUENCY_HZ) -> hull.Motion:
    """Roll alone, of each amplitude: (4, 1)."""
    amplitude = np.zeros((len(AMPLITUDE_DEG), 1, 6))
    amplitude[:, 0, 3] = np.array(AMPLITUDE_DEG) * DEG
    return hull.sinusoids(amplitude, np.zeros(6), np.full((len(AMPLITUDE_DEG), 1), frequency_hz))


def experiment(
    model: Any, scenario: Scenario, *, runs: int, seed: int, frequency_hz: float = FREQUENCY_HZ
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Heading in deg after a minute, case by case, with gyros of right axes and with those of a MEMS unit.

    Returns cases, amplitude_deg, paper_deg, frequency_hz, gyro_axes_mrad, runs; `right` and `askew` (gyro axes):
    mean_deg, worst_deg, sigma_deg (the filter's own) at the end, below_s (mean error for good below the paper's 0.15
    deg, null if never), nis (of six rows, after 10 s); rest: sigma_deg after a minute at rest, and reported_deg, what
    noise in H would make of it, 1 / sqrt(1 / sigma_0^2 + 2 updates); and the history, of right axes: time_s, roll_deg
    (T, 4), heading_deg (T, 4, runs), sigma_deg (T, 4).
    """
    motion = bench(frequency_hz)
    number = len(CASES)
    twice = hull.Motion(hull.Harmonics(*(np.tile(part, (2, *[1] * (part.ndim - 1))) for part in
                                         (motion.freedoms.omega, motion.freedoms.amplitude))))  # fmt: skip
    one = replace(
        scenario,
        navigation_hz=400,
        update_hz=10,
        covariance_hz=10,
        gyro_misalignment_mrad=(0.0,) * number + (GYRO_AXES_MRAD,) * number,
    )
    flight = fly(model, twice, one, runs=runs, seed=seed, belief=only("with"))
    heading, sigma = flight.heading[:, 0] / DEG, flight.heading_sigma[:, 0].mean(-1) / DEG
    size = np.abs(heading).mean(-1)
    below_s = since(size < PAPER_DEG[1]) / one.update_hz
    out: dict[str, Any] = {
        "cases": list(CASES),
        "amplitude_deg": list(AMPLITUDE_DEG),
        "paper_deg": list(PAPER_DEG),
        "frequency_hz": frequency_hz,
        "gyro_axes_mrad": GYRO_AXES_MRAD,
        "runs": runs,
    }
    for name, part in (("right", slice(0, number)), ("askew", slice(number, None))):
        out[name] = {
            "mean_deg": size[-1, part].tolist(),
            "worst_deg": np.abs(heading[-1, part]).max(-1).tolist(),
            "sigma_deg": sigma[-1, part].tolist(),
            "below_s": [None if np.isnan(at) else float(at) for at in below_s[part]],
            "nis": flight.settled_nis[0, part].tolist(),
        }
    time = np.arange(len(heading)) / one.update_hz
    history = {
        "time_s": time,
        "roll_deg": motion.freedoms.at(time)[:, :, 0, 3] / DEG,
        "heading_deg": heading[:, :number],
        "sigma_deg": sigma[:, :number],
    }
    # An H that held the reported attitude would take its noise for motion: two rows whose noise over their own sigma
    # adds 1 each to 1 / sigma^2 of the heading, update for update, however small the noise.
    out["rest"] = {
        "sigma_deg": out["right"]["sigma_deg"][0],
        "reported_deg": float(1 / np.sqrt((one.misalignment_deg * DEG) ** -2 + 2 * one.seconds * one.update_hz) / DEG),
    }
    return out, history


def report(result: dict[str, Any]) -> list[str]:
    """One line a case."""
    right, askew = result["right"], result["askew"]
    keys = ("mean_deg", "worst_deg", "sigma_deg", "below_s")
    columns = [result["cases"], result["amplitude_deg"], *(right[key] for key in keys), askew["mean_deg"],
               askew["worst_deg"], result["paper_deg"]]  # fmt: skip
    head = ("", "roll", "mean", "worst", "sigma", "below 0.15, s", "askew: mean", "worst", "paper")
    rest = result["rest"]
    return [
        f"bench: slave at 400 Hz, master at 10 Hz, roll at {result['frequency_hz']:g} Hz, {result['runs']} runs;",
        f"heading in deg after 60 s; askew: gyro axes by {result['gyro_axes_mrad']:g} mrad",
        *table(head, zip(*columns, strict=True), ["", ".2f", ".3f", ".3f", ".3f", ".1f", ".3f", ".3f", ".2f"]),
        f"  at rest the filter's own sigma is {rest['sigma_deg']:.2f} deg of the 2 at the start; with the reported",
        f"  attitude in H its noise alone would make it {rest['reported_deg']:.2f}",
    ]
