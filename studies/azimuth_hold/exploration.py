"""What decides the azimuth hold's covariance: where the level starts, what the filter is told of zero, and what
zero-angular-rate updates add.  Beyond Kim (2018), around the one declared scenario of `azimuth_alignment`.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.filter import Filter
from boresight.runtime.units import ARCMIN, DEG, MILLI_G
from boresight.studies.azimuth_hold.alignment import (
    Models,
    Scenario,
    accel_walk,
    align,
    bias_variances,
    checked,
    gyro_walk,
    load_models,
    place,
    rest_attitude,
    rest_specific_force,
)
from boresight.studies.azimuth_hold.hold import MODES, PHI, hold, root_mean_square

STARTS_ARCMIN = (0.1, 0.5, 1.0, 3.5, 10.0, 30.0)
AT_S = (0, 10, 100, 1000, 3600)
ZERO_SIGMAS_M_S = (1e-4, 1e-3, 1e-2, 1e-1)


def level_sigma(
    models: Models,
    scenario: Scenario,
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
    q, position = rest_attitude(scenario), place(scenario)
    C = rotation.matrix_from_quaternion(q)
    f_b = rest_specific_force(models, position, q)
    g = np.linalg.norm(f_b)
    floor = np.stack([C[1], -C[0]]) / g  # phi_e, phi_n per error of the bias estimate
    variances = bias_variances(scenario, f_b)
    P = np.diag([1e-10, 1e-10, 1.0, 0.01, 0.01, 0.01, 0, 0, (2.8 * ARCMIN) ** 2, *variances])
    P[6:8, 6:8] = np.eye(2) * (start_arcmin * ARCMIN) ** 2
    if levelled:
        P[6:8, 6:8] += floor @ np.diag(variances[3:]) @ floor.T
        P[6:8, 12:] = floor @ np.diag(variances[3:])
        P[12:, 6:8] = P[6:8, 12:].T
    nav = {
        "position": position,
        "v_n": np.zeros(3),
        "q_b2n_wxyz": q,
        "gyro_bias": np.zeros(3),
        "accel_bias": np.zeros(3),
    }
    loop = Filter(models.hold, nav, P)
    drift = accel_drift_ug_sqrt_h * 1e-3 * MILLI_G / 60
    noise = {"gyro_noise": np.full(3, gyro_walk(scenario)), "accel_noise": np.full(3, accel_walk(scenario)),
             "gyro_bias_noise": np.zeros(3), "accel_bias_noise": np.full(3, drift)}  # fmt: skip
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


def explore(
    models: Models | None = None,
    *,
    runs: int = 10,
    seed: int = 0,
    seconds: int = 600,
    scenario: Scenario | None = None,
    progress: Callable[[str], None] | None = None,
) -> dict[str, Any]:
    """All three.  The result can be written as JSON; its fields are stable:

    at_s; level: start_arcmin, levelled, accel_drift_ug_sqrt_h, level_arcmin, combined_arcmin (at those times);
    zero: zupt_sigma_m_s, nis (mean of three rows in the second half, zupt mode), level_error_arcmin,
    level_sigma_arcmin (rms of both axes at the end), nees (of the angles, reference mode);
    zaru: with and without, mode -> error_arcmin and sigma_arcmin (3), nees, gyro_deg_h and gyro_sigma_deg_h (rms of
    three axes); runs, seed, seconds: of the last two.
    """
    models, scenario = models or load_models(), checked(scenario or Scenario())
    say = progress or (lambda line: None)
    say("level: where it starts")
    cases = [(start, False, 0.0) for start in STARTS_ARCMIN] + [
        (0.5, True, 0.0),
        (0.5, False, 100.0),
        (0.5, True, 100.0),
    ]
    level = [
        {
            "start_arcmin": start,
            "levelled": levelled,
            "accel_drift_ug_sqrt_h": drift,
            **level_sigma(models, scenario, start, levelled=levelled, accel_drift_ug_sqrt_h=drift),
        }
        for start, levelled, drift in cases
    ]
    zero = []
    for told in ZERO_SIGMAS_M_S:
        say(f"zero velocity to {told:g} m/s")
        one = replace(scenario, zupt_sigma_m_s=told)
        held = hold(models, one, align(models, one, runs=runs, seed=seed), seconds)
        zupt, reference = MODES.index("zupt"), MODES.index("reference")
        zero.append(
            {
                "zupt_sigma_m_s": told,
                "nis": float(held.nis_zupt[seconds // 2 :, zupt].mean()),
                "level_error_arcmin": float(root_mean_square(held.phi[-1, zupt, :, :2].ravel()) / ARCMIN),
                "level_sigma_arcmin": float(root_mean_square(held.sigma[-1, zupt, :, :2].ravel()) / ARCMIN),
                "nees": float(held.nees[-1, reference].mean()),
            }
        )
    zaru: dict[str, Any] = {}
    for on in (False, True):
        say(f"zero-angular-rate updates: {'on' if on else 'off'}")
        held = hold(models, scenario, align(models, scenario, runs=runs, seed=seed), seconds, zaru=on)
        sigma = np.sqrt(np.einsum("mrii->mri", held.P))
        zaru["with" if on else "without"] = {
            mode: {
                "error_arcmin": (root_mean_square(held.phi[-1, m]) / ARCMIN).tolist(),
                "sigma_arcmin": (root_mean_square(sigma[m, :, PHI]) / ARCMIN).tolist(),
                "nees": float(held.nees[-1, m].mean()),
                "gyro_deg_h": float(root_mean_square(held.error[m, :, 9:12].ravel()) / DEG * 3600),
                "gyro_sigma_deg_h": float(root_mean_square(sigma[m, :, 9:12].ravel()) / DEG * 3600),
            }
            for m, mode in enumerate(MODES)
            if mode != "inertial"
        }
    return {"at_s": list(AT_S), "level": level, "zero": zero, "zaru": zaru, "runs": runs, "seed": seed,
            "seconds": seconds}  # fmt: skip


def report(result: dict[str, Any]) -> str:
    """Three tables."""
    lines = [f"sigma of the level in arcmin at {', '.join(f'{at} s' for at in result['at_s'])} under zero velocity"]
    for row in result["level"]:
        how = "on the accelerometers" if row["levelled"] else "independent"
        lines.append(
            f"  start {row['start_arcmin']:4.1f} {how:22} drift {row['accel_drift_ug_sqrt_h']:4.0f} ug/sqrt(h)"
            + "".join(f"{value:8.3f}" for value in row["level_arcmin"])
            + "   less the floor"
            + "".join(f"{value:8.3f}" for value in row["combined_arcmin"])
        )
    lines.append(f"zero velocity that is exactly zero, {result['seconds']} s, {result['runs']} runs")
    for row in result["zero"]:
        lines.append(
            f"  told {row['zupt_sigma_m_s']:7.4f} m/s   NIS {row['nis']:6.3f} of 3   level error "
            f"{row['level_error_arcmin']:.3f} sigma {row['level_sigma_arcmin']:.3f}   NEES {row['nees']:.2f} of 3"
        )
    lines.append("zero-angular-rate updates")
    for on, modes in result["zaru"].items():
        for mode, row in modes.items():
            error, sigma = ("".join(f"{value:7.2f}" for value in row[f"{key}_arcmin"]) for key in ("error", "sigma"))
            lines.append(
                f"  {on:8} {mode:10} error{error}  sigma{sigma}  NEES {row['nees']:7.2f} of 3  gyro "
                f"{row['gyro_deg_h']:.3f} sigma {row['gyro_sigma_deg_h']:.3f} deg/h"
            )
    return "\n".join(lines)
