"""What decides the azimuth hold's covariance: where the level starts, what the filter is told of zero, and what
zero-angular-rate updates add.  Beyond Kim (2018), around the one declared scenario of `azimuth_alignment`.
"""

from dataclasses import dataclass, replace

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.filter import CompiledFilter
from boresight.runtime.units import ARCMIN, MILLI_G
from boresight.studies.azimuth_hold import alignment
from boresight.studies.azimuth_hold.hold import MODES, bias_summary, hold, marked, root_mean_square
from boresight.studies.study import Progress, Result, Study, option, shown, silent, table

STARTS_ARCMIN = (0.1, 0.5, 1.0, 3.5, 10.0, 30.0)
AT_S = (0, 10, 100, 1000, 3600)
ZERO_SIGMAS_M_S = (1e-4, 1e-3, 1e-2, 1e-1)


def level_sigma(
    models: alignment.Models,
    scenario: alignment.Scenario,
    start_arcmin: float,
    *,
    accel_drift_ug_sqrt_h: float = 0.0,
    levelled: bool = False,
) -> dict[str, list[float]]:
    """Sigma of the level at AT_S seconds under zero-velocity updates: the filter's covariance alone, nothing flown.

    start_arcmin: of phi_e and phi_n at first, which know nothing of the accelerometers; or with levelled=True the tilt
    comes from these, phi = floor + an independent part of start_arcmin.  accel_drift_ug_sqrt_h: random walk of the
    accelerometer biases, 1e-6 g after an hour.
    Returns level_arcmin (about east) and combined_arcmin: sigma of phi less the tilt that cancels the accelerometer's
    error, which is what a velocity can see.
    """
    q, position = alignment.rest_attitude(scenario), alignment.place(scenario)
    C = rotation.matrix_from_quaternion(q)
    f_b = alignment.rest_specific_force(models, position, q)
    g = np.linalg.norm(f_b)
    floor = np.stack([C[1], -C[0]]) / g  # phi_e, phi_n per error of the bias estimate
    variances = alignment.bias_variances(scenario, f_b)
    P = np.diag([1e-10, 1e-10, 1.0, 0.01, 0.01, 0.01, 0, 0, (2.8 * ARCMIN) ** 2, *variances])
    P[6:8, 6:8] = np.eye(2) * (start_arcmin * ARCMIN) ** 2
    if levelled:
        P[6:8, 6:8] += floor @ np.diag(variances[3:]) @ floor.T
        P[6:8, 12:] = floor @ np.diag(variances[3:])
        P[12:, 6:8] = P[6:8, 12:].T
    nav = {"lon_lat_height": position, "q_b2n_wxyz": q} | dict.fromkeys(("v_n", "gyro_bias", "accel_bias"), np.zeros(3))
    loop = CompiledFilter(models.hold, nav, P)
    drift = accel_drift_ug_sqrt_h * 1e-3 * MILLI_G / 60
    noise = alignment.rest_noise(scenario) | {"accel_bias_noise": np.full(3, drift)}
    M = np.zeros(15)
    M[6], M[12:] = 1.0, -floor[0]
    level, combined = [], []
    for second in range(AT_S[-1] + 1):
        if second:
            loop.predict(f_b=f_b, dt=1.0, **noise)
            loop.update("zupt", np.full(3, scenario.zupt_sigma_m_s**2))
        if second in AT_S:
            level.append(float(np.sqrt(loop.P[6, 6]) / ARCMIN))
            combined.append(float(np.sqrt(M @ loop.P @ M) / ARCMIN))
    return {"level_arcmin": level, "combined_arcmin": combined}


@dataclass(frozen=True)
class Asked(alignment.Scenario):
    runs: int = option(10, "Monte Carlo runs of each case.")
    seconds: int = option(600, "At rest, of the last two tables.")


CASES = (*((start, False, 0.0) for start in STARTS_ARCMIN), (0.5, True, 0.0), (0.5, False, 100.0), (0.5, True, 100.0))


def run(scenario: Asked, progress: Progress = silent) -> Result:
    """All three: runs, seconds, at_s;

    level: start_arcmin, levelled, accel_drift_ug_sqrt_h, level_arcmin, combined_arcmin (at those times);
    zero: zupt_sigma_m_s, nis (mean of three rows in the second half, zupt mode), level_error_arcmin,
    level_sigma_arcmin (rms of both axes at the end), nees (of the angles, reference mode);
    zaru: on, mode, error_arcmin and sigma_arcmin (3), nees, gyro_deg_h and gyro_sigma_deg_h (rms of three axes).
    """
    alignment.checked(scenario)
    models = alignment.load_models()
    runs, seed, seconds = scenario.runs, scenario.seed, scenario.seconds
    progress("level: where it starts")
    level = [
        {
            "start_arcmin": start,
            "levelled": levelled,
            "accel_drift_ug_sqrt_h": drift,
            **level_sigma(models, scenario, start, levelled=levelled, accel_drift_ug_sqrt_h=drift),
        }
        for start, levelled, drift in CASES
    ]
    zero, zaru = [], []
    zupt, reference = MODES.index("zupt"), MODES.index("reference")
    for sigma in ZERO_SIGMAS_M_S:
        progress(f"zero velocity to {sigma:g} m/s")
        one = replace(scenario, zupt_sigma_m_s=sigma)
        held = hold(models, one, alignment.align(models, one, runs=runs, seed=seed), seconds)
        zero.append(
            {
                "zupt_sigma_m_s": sigma,
                "nis": float(held.nis_zupt[seconds // 2 :, zupt].mean()),
                "level_error_arcmin": float(root_mean_square(held.phi[-1, zupt, :, :2].ravel()) / ARCMIN),
                "level_sigma_arcmin": float(root_mean_square(held.sigma[-1, zupt, :, :2].ravel()) / ARCMIN),
                "nees": float(held.nees[-1, reference].mean()),
            }
        )
    for on in (False, True):
        progress(f"zero-angular-rate updates: {'on' if on else 'off'}")
        held = hold(models, scenario, alignment.align(models, scenario, runs=runs, seed=seed), seconds, zaru=on)
        for m, mode in enumerate(MODES):
            if mode != "inertial":
                end, bias = marked(held, {}, seconds, m), bias_summary(held, m)
                row = {key: end[key] for key in ("error_arcmin", "sigma_arcmin", "nees")}
                row |= {key: float(root_mean_square(np.array(bias[key]))) for key in ("gyro_deg_h", "gyro_sigma_deg_h")}
                zaru.append({"mode": mode, "on": on, **row})
    return {"runs": runs, "seconds": seconds, "at_s": list(AT_S), "level": level, "zero": zero, "zaru": zaru}


def report(result: Result) -> str:
    """Three tables."""
    rows = [(f"{row['start_arcmin']:g}", *list(row.values())[1:]) for row in result["level"]]
    ran = f"{result['seconds']} s, {result['runs']} runs"
    return "\n".join([
        f"sigma of the level in arcmin at {shown(result['at_s'], 'd').strip()} s under zero velocity",
        *table(("start", "levelled", "ug/sqrt(h)", "level", "less the floor"), rows, ["", "", "g", ".2f", ".2f"]),
        "",
        f"zero velocity that is exactly zero, {ran}",
        *table(("told, m/s", "NIS of 3", "level error", "sigma", "NEES of 3"),
               [(f"{row['zupt_sigma_m_s']:g}", *list(row.values())[1:]) for row in result["zero"]], ".2f"),
        "",
        f"zero-angular-rate updates, {ran}",
        *table(("", "on", "error", "sigma", "NEES", "deg/h", "sigma"),
               [list(row.values()) for row in result["zaru"]], ".2f"),
    ])  # fmt: skip


STUDY = Study("azimuth-exploration", alignment.MODELS, Asked, run, report)
