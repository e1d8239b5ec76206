"""Kim (2018): how long a tactical-grade unit at rest keeps the attitude that a transfer alignment gave it.

Aligned on a moving bench (azimuth_alignment.py), then at rest: 100 Hz strapdown, 1 Hz filter, four ways to go on.
  inertial   no updates; height and vertical velocity are held, or they would run away within the hour
  zupt       zero-velocity updates, (16) and (17)
  azimuth    the same with the aligned azimuth, (20) to (23), its error taken for white noise as in the paper
  reference  the same with the error of that azimuth as a sixteenth state: it is one and the same all the time
The four ways fly the same runs with the same noise.  ENU, body axes right-front-up; phi is computed against true.
"""

from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.filter import Filter
from boresight.runtime.simulation import inertial
from boresight.runtime.units import ARCMIN, DEG, MILLI_G
from boresight.studies.azimuth_hold.alignment import (
    Aligned,
    Models,
    Scenario,
    accel_walk,
    align,
    bias_variances,
    checked,
    gyro_walk,
    load_models,
    rest_specific_force,
)

MODES = ("inertial", "zupt", "azimuth", "reference")
AXES = ("east", "north", "up")
ZUPT = np.array([False, True, True, True])
AZIMUTH = np.array([False, False, True, True])
STATE = np.array([False, False, False, True])  # the reference's error is a state
PHI = slice(6, 9)
REFERENCE_SIGMA = 0.1 * ARCMIN  # of the reference once its constant error is a state: the platform gives way that much


@dataclass(frozen=True)
class Held:
    """A hold: axes are seconds, modes, runs, components."""

    phi: Array  # (T+1, 4, runs, 3) rad
    sigma: Array  # (T+1, 4, runs, 3) rad, the filter's
    speed: Array  # (T+1, 4, runs, 3) m/s: v_n, which is all error
    nees: Array  # (T+1, 4, runs) of the three angles
    nis_zupt: Array  # (T, 4, runs) of three rows; 0 in a mode without
    nis_azimuth: Array  # (T, 4, runs) of one row
    error: Array  # (4, runs, 16) at the end, in the filter's states
    P: Array  # (4, runs, 16, 16) at the end


def start_filter(models: Models, scenario: Scenario, start: Aligned) -> tuple[Filter, Array]:
    """The four modes over the same runs, and the variance of the azimuth measurement, (4, runs, 1)."""
    runs = len(start.P)
    nav = {name: np.broadcast_to(value, (4, *value.shape)).copy() for name, value in start.nav.items()}
    nav["reference_error"] = np.zeros((4, runs))
    P = np.zeros((4, runs, 16, 16))
    P[..., :15, :15] = start.P
    # The reference is the attitude of the hand-over, and in error by as much: d_ref = 0 - phi_u.
    variance = start.P[:, 8, 8]
    P[3, :, :15, 15] = -start.P[:, 8, :]
    P[3, :, 15, :15] = -start.P[:, 8, :]
    P[3, :, 15, 15] = variance
    # White in the paper's mode; with the state, what moves between one second and the next.
    R = np.where(STATE[:, None], REFERENCE_SIGMA**2, variance)[..., None]
    return Filter(models.hold_reference, nav, P), R


def hold(
    models: Models,
    scenario: Scenario,
    start: Aligned,
    seconds: int,
    *,
    zaru: bool = False,
    progress: Callable[[str], None] | None = None,
) -> Held:
    """At rest for so many seconds, in all modes.  Uses up the noise streams of `start`.

    zaru: zero-angular-rate updates beside those of velocity, from the mean of each second.  Their noise is that of the
    gyros, which drives the attitude too; the filter is not told so, as usual.
    """
    hz, dt = scenario.strapdown_hz, 1 / scenario.strapdown_hz
    sensors = start.drawn.sensors
    loop, R_azimuth = start_filter(models, scenario, start)
    q_ref = loop.nav["q_b2n_wxyz"].copy()
    earth = models.strapdown.earth(position=start.position, v_n=np.zeros(3))
    C_b2n = rotation.matrix_from_quaternion(start.q_b2n_wxyz)
    omega_b = np.einsum("rji,j->ri", C_b2n, earth["omega_ie_n"])
    f_b = rest_specific_force(models, start.position, start.q_b2n_wxyz)
    R_zupt = np.full(3, scenario.zupt_sigma_m_s**2)
    noise = {
        "gyro_noise": np.full(3, gyro_walk(scenario)),
        "accel_noise": np.full(3, accel_walk(scenario)),
        "gyro_bias_noise": np.zeros(3),  # "random constants", the paper says below (8)
        "accel_bias_noise": np.zeros(3),
    }
    history: list[tuple[Array, ...]] = []
    nis: list[tuple[Array, Array]] = []

    def keep() -> None:
        phi = rotation.attitude_error(loop.nav["q_b2n_wxyz"], start.q_b2n_wxyz)
        P = loop.P[..., PHI, PHI]
        nees = np.einsum("...i,...i->...", phi, np.linalg.solve(P, phi[..., None])[..., 0])
        history.append((phi, np.sqrt(np.einsum("...ii->...i", P)), loop.nav["v_n"], nees))

    keep()
    before = None
    for second in range(1, seconds + 1):
        dtheta, dv = sensors.measured(omega_b * dt, f_b * dt, dt, hz)
        dtheta, dv = dtheta[:, None], dv[:, None]  # an axis of modes
        fields, before = inertial.intervals(dtheta, dv, before), (dtheta[-1], dv[-1])
        for k in range(hz):
            loop.strapdown(**{name: values[k] for name, values in fields.items()}, dt=dt)
        loop.predict(f_b=dv.mean(axis=0) / dt - loop.nav["accel_bias"], dt=1.0, **noise)
        zupt = loop.update("zupt", R_zupt, rows=ZUPT[:, None, None])
        azimuth = loop.update("azimuth", R_azimuth, rows=AZIMUTH[:, None, None], q_ref_wxyz=q_ref)
        if zaru:
            omega = dtheta.mean(axis=0) / dt - loop.nav["gyro_bias"]
            loop.update("zaru", noise["gyro_noise"] ** 2, rows=ZUPT[:, None, None], omega_ib_b=omega)
        loop.feedback()
        hold_vertical(loop, start)
        nis.append((zupt.nis, azimuth.nis))
        keep()
        if progress and second % 600 == 0:
            progress(f"{second} of {seconds} s at rest")

    bias = sensors.bias_at(omega_b, f_b)
    error = np.concatenate(
        [
            loop.nav["position"] - start.position,
            loop.nav["v_n"],
            history[-1][0],
            loop.nav["gyro_bias"] - bias[0],
            loop.nav["accel_bias"] - bias[1],
            loop.nav["reference_error"][..., None]
            - rotation.attitude_error(q_ref, start.q_b2n_wxyz)[..., 2:] * STATE[:, None, None],
        ],
        axis=-1,
    )
    phi, sigma, speed, nees = (np.array(part) for part in zip(*history, strict=True))
    nis_zupt, nis_azimuth = (np.array(part) for part in zip(*nis, strict=True))
    return Held(phi, sigma, speed, nees, nis_zupt, nis_azimuth, error, loop.P)


def hold_vertical(loop: Filter, start: Aligned) -> None:
    """Of the inertial mode: height and vertical velocity are known from elsewhere, as every ship's or aircraft's are.

    Left alone, 1 mg would grow to 6 km in 1000 s and to 870 km in an hour, as exp(t / 570 s).
    """
    loop.nav["position"][0, :, 2] = start.position[2]
    loop.nav["v_n"][0, :, 2] = 0.0
    for state, sigma in ((2, 1.0), (5, 1e-3)):
        loop.P[0, :, state, :] = loop.P[0, :, :, state] = 0.0
        loop.P[0, :, state, state] = sigma**2


# ---- the analytic budget


def budget(models: Models, scenario: Scenario, start: Aligned, time: Array) -> dict[str, Array]:
    """What theory says of the same runs without any filter: closed forms, and no Kalman gain in them.

    inertial_phi: (T, runs, 3) rad from each run's own errors at the start and its constant sensor errors.  About a
    level axis Schuler's phi - floor = (phi0 - floor) cos wt + rate sin wt / w, whose rate is the drift of gyro and
    Earth's rate with v0 / R, and what a ramp of the azimuth adds; about up the drift, and tan(lat) times what the
    easterly velocity makes of the drift about north.  The Earth's turning is taken of the mean tilt alone.
    walk: (T, 3) rad, sigma of the random walk beside it.
    tilt_floor: (runs, 2) rad, the tilt at which the run's accelerometer error just cancels gravity.
    """
    earth = models.strapdown.earth(position=start.position, v_n=np.zeros(3))
    g, omega_ie = -earth["gravity_n"][2], earth["omega_ie_n"]
    C = rotation.matrix_from_quaternion(start.q_b2n_wxyz)
    f_b = rest_specific_force(models, start.position, start.q_b2n_wxyz)
    gyro, accel = start.drawn.sensors.bias_at(np.einsum("rji,j->ri", C, omega_ie), f_b)
    drift, a = -np.einsum("rij,rj->ri", C, gyro), np.einsum("rij,rj->ri", C, accel)
    # f_n x phi + C b = 0 with f_n = (0, 0, g)
    floor = np.stack([-a[:, 1], a[:, 0]], axis=-1) / g
    phi0 = rotation.attitude_error(start.nav["q_b2n_wxyz"], start.q_b2n_wxyz)
    rates = models.strapdown.rates(
        position=start.position, v_n=np.ones(3), q_b2n_wxyz=[1.0, 0, 0, 0], f_b=np.zeros(3), omega_ib_b=np.zeros(3)
    )["position_rate"]
    radius = 1 / np.array([rates[1], rates[0] * np.cos(start.position[1])])  # about east: the meridian's
    omega_s = np.sqrt(g / radius)
    v0 = start.nav["v_n"]
    t = np.asarray(time, float)[:, None, None]
    # -omega_ie x phi, where the level swings about its floor and the azimuth is that of the start
    drift = drift - np.cross(omega_ie, np.concatenate([floor, phi0[:, 2:]], axis=-1))
    level_drift = drift[:, :2] + np.stack([-v0[:, 1], v0[:, 0]], axis=-1) / radius
    # What the level's rate says of the drift, Schuler's velocity makes good; its east part turns the azimuth too.
    tan_lat = np.tan(start.position[1])
    azimuth_rate = drift[:, 2] - tan_lat * drift[:, 1]
    ramp = np.stack([-omega_ie[1] * azimuth_rate, np.zeros_like(azimuth_rate)], axis=-1)  # of the drift about east
    level = (
        floor
        + (phi0[:, :2] - floor) * np.cos(omega_s * t)
        + level_drift * np.sin(omega_s * t) / omega_s
        + ramp * (1 - np.cos(omega_s * t)) / omega_s**2
    )
    up = phi0[:, 2] + azimuth_rate * t[..., 0] + tan_lat * (level[..., 1] - phi0[:, 1])
    walk = gyro_walk(scenario)
    seconds = np.asarray(time, float)[:, None]
    level_walk = walk * np.sqrt(seconds / 2 + np.sin(2 * omega_s * seconds) / (4 * omega_s))
    # the same for white noise: of w_u its integral, of w_n tan(lat) times the integral of (cos w(t - s) - 1)
    swing = 1.5 * seconds - 2 * np.sin(omega_s * seconds) / omega_s + np.sin(2 * omega_s * seconds) / (4 * omega_s)
    up_walk = walk * np.sqrt(seconds + tan_lat**2 * swing[:, 1:])
    return {
        "inertial_phi": np.concatenate([level, up[..., None]], axis=-1),
        "walk": np.concatenate([level_walk, up_walk], axis=-1),
        "tilt_floor": floor,
    }


def remaining_floor(models: Models, start: Aligned, held: Held) -> Array:
    """(4, runs, 2) rad: the tilt that cancels what is left of each run's accelerometer error at the end."""
    g = -models.strapdown.earth(position=start.position, v_n=np.zeros(3))["gravity_n"][2]
    left = -np.einsum("rij,mrj->mri", rotation.matrix_from_quaternion(start.q_b2n_wxyz), held.error[..., 12:15])
    return np.stack([-left[..., 1], left[..., 0]], axis=-1) / g


# ---- the study

MARKS_S = (1000, 3600)


def root_mean_square(values: Array, axis: int = 0) -> Array:
    return np.sqrt(np.mean(np.square(values), axis=axis))


def run(
    models: Models | None = None,
    *,
    runs: int = 20,
    seed: int = 0,
    seconds: int = 3600,
    scenario: Scenario | None = None,
    histories: bool = True,
    shock: bool | None = None,
    progress: Callable[[str], None] | None = None,
) -> dict[str, Any]:
    """The alignment and the four ways to hold.  The result can be written as JSON; its fields are stable:

    study, runs, seed, seconds, scenario (every field of Scenario), modes, axes;
    alignment: complete_s (median over runs, null if never), incomplete_runs, error_arcmin and sigma_arcmin (3, phi at
    the hand-over), mu_error_arcmin (3), delay_error_ms, nis (mean of six rows), nees (of velocity and attitude, 6);
    marks: at each of 1000 s, 3600 s and the end that was reached, second and mode -> error_arcmin, sigma_arcmin (3,
    rms over runs), largest_arcmin (3), nees (of three angles, mean), speed_m_s (3, rms), and for the inertial mode
    budget_arcmin (rms of the closed form, run by run), beside_budget_arcmin (rms of the difference) and walk_arcmin
    (the random walk that the closed form leaves out), all (3);
    floor: sigma_arcmin (one sigma of 1 mg and what belongs to it), rms_arcmin (of these runs), beside_arcmin: mode ->
    rms of the level error less the tilt that cancels what is left of the accelerometer error, 2 axes;
    bias: mode -> gyro_deg_h, gyro_sigma_deg_h, accel_mg, accel_sigma_mg (3, body axes) at the end;
    nees: mode -> of all fifteen states (sixteen for reference) at the end, mean; nis: mode -> zupt (of 3 rows) and
    azimuth (of 1), mean over the last half;
    histories (if asked): time_s, and for each mode error_arcmin (3 runs, T, 3), rms_arcmin, sigma_arcmin (T, 3);
    shock (if asked, and by default where 1000 s or more are flown): what azimuth_shock.run says of 5 runs.
    """
    from boresight.studies.azimuth_hold import shock as azimuth_shock  # which builds on this module

    if runs < 1 or not np.isfinite(seconds) or seconds != int(seconds) or not 10 <= seconds <= 36000:
        raise BoresightError(
            f"azimuth-hold needs at least 1 run and a whole number of seconds from 10 to 36000; got {runs} runs, "
            f"{seconds} seconds"
        )
    seconds = int(seconds)
    models, scenario = models or load_models(), checked(scenario or Scenario())
    say = progress or (lambda line: None)
    say(f"transfer alignment: {runs} runs of {scenario.align_s:g} s")
    start = align(models, scenario, runs=runs, seed=seed)
    say(f"hold: {len(MODES)} modes of {runs} runs, {seconds} s")
    held = hold(models, scenario, start, seconds, progress=progress)
    theory = budget(models, scenario, start, np.arange(seconds + 1))
    marks = sorted({second for second in MARKS_S if second <= seconds} | {seconds})
    result = {
        "study": "azimuth-hold",
        "runs": runs,
        "seed": seed,
        "seconds": seconds,
        "scenario": {name: list(v) if isinstance(v, tuple) else v for name, v in asdict(scenario).items()},
        "modes": list(MODES),
        "axes": list(AXES),
        "alignment": aligned_summary(start),
        "marks": [
            {"second": second, **{mode: marked(held, theory, second, m) for m, mode in enumerate(MODES)}}
            for second in marks
        ],
        **ended_summary(models, scenario, start, held, theory),
    }
    if histories:
        every = max(1, seconds // 720)
        result["histories"] = {
            "time_s": np.arange(0, seconds + 1, every).tolist(),
            **{
                mode: {
                    "error_arcmin": np.moveaxis(held.phi[::every, m, :3] / ARCMIN, 1, 0).round(4).tolist(),
                    "rms_arcmin": (root_mean_square(held.phi[::every, m], 1) / ARCMIN).round(4).tolist(),
                    "sigma_arcmin": (root_mean_square(held.sigma[::every, m], 1) / ARCMIN).round(4).tolist(),
                }
                for m, mode in enumerate(MODES)
            },
        }
    if shock if shock is not None else seconds >= 1000:
        say("disturbances at 500 s")
        result["shock"] = azimuth_shock.run(models, seed=seed, scenario=scenario, progress=progress)
    return result


def aligned_summary(start: Aligned) -> dict[str, Any]:
    phi = rotation.attitude_error(start.nav["q_b2n_wxyz"], start.q_b2n_wxyz)
    error = np.concatenate([start.nav["v_n"], phi], axis=-1)
    nees = np.einsum("ri,ri->r", error, np.linalg.solve(start.P[:, 3:9, 3:9], error[..., None])[..., 0])
    met = start.complete_s[np.isfinite(start.complete_s)]
    return {
        "complete_s": float(np.median(met)) if len(met) else None,
        "incomplete_runs": int(np.isnan(start.complete_s).sum()),
        "error_arcmin": (root_mean_square(phi) / ARCMIN).tolist(),
        "sigma_arcmin": (np.sqrt(np.einsum("rii->ri", start.P).mean(axis=0)[PHI]) / ARCMIN).tolist(),
        "mu_error_arcmin": (root_mean_square(start.mu_error) / ARCMIN).tolist(),
        "delay_error_ms": float(root_mean_square(start.delay_error) * 1e3),
        "nis": float(start.nis.mean()),
        "nees": float(nees.mean()),
    }


def marked(held: Held, theory: dict[str, Array], second: int, mode: int) -> dict[str, Any]:
    phi = held.phi[second, mode]
    out: dict[str, Any] = {
        "error_arcmin": (root_mean_square(phi) / ARCMIN).tolist(),
        "sigma_arcmin": (root_mean_square(held.sigma[second, mode]) / ARCMIN).tolist(),
        "largest_arcmin": (np.abs(phi).max(axis=0) / ARCMIN).tolist(),
        "nees": float(held.nees[second, mode].mean()),
        "speed_m_s": root_mean_square(held.speed[second, mode]).tolist(),
    }
    if MODES[mode] == "inertial":
        closed = theory["inertial_phi"][second]
        out["budget_arcmin"] = (root_mean_square(closed) / ARCMIN).tolist()
        out["beside_budget_arcmin"] = (root_mean_square(phi - closed) / ARCMIN).tolist()
        out["walk_arcmin"] = (theory["walk"][second] / ARCMIN).tolist()
    return out


def ended_summary(
    models: Models, scenario: Scenario, start: Aligned, held: Held, theory: dict[str, Array]
) -> dict[str, Any]:
    sigma = np.sqrt(np.einsum("mrii->mri", held.P))
    floor = bias_variances(scenario, rest_specific_force(models, start.position, start.q_b2n_wxyz[0]))[3:]
    g = -models.strapdown.earth(position=start.position, v_n=np.zeros(3))["gravity_n"][2]
    beside = held.phi[-1, ..., :2] - remaining_floor(models, start, held)
    half = len(held.nis_zupt) // 2
    out: dict[str, Any] = {
        "floor": {
            "sigma_arcmin": float(np.sqrt(floor[:2].mean()) / g / ARCMIN),
            "rms_arcmin": (root_mean_square(theory["tilt_floor"]) / ARCMIN).tolist(),
            "beside_arcmin": {},
        },
        "bias": {},
        "nees": {},
        "nis": {},
    }
    for m, mode in enumerate(MODES):
        states = 16 if STATE[m] else 15
        e, P = held.error[m, :, :states], held.P[m, :, :states, :states]
        out["floor"]["beside_arcmin"][mode] = (root_mean_square(beside[m]) / ARCMIN).tolist()
        out["bias"][mode] = {
            "gyro_deg_h": (root_mean_square(held.error[m, :, 9:12]) / DEG * 3600).tolist(),
            "gyro_sigma_deg_h": (root_mean_square(sigma[m, :, 9:12]) / DEG * 3600).tolist(),
            "accel_mg": (root_mean_square(held.error[m, :, 12:15]) / MILLI_G).tolist(),
            "accel_sigma_mg": (root_mean_square(sigma[m, :, 12:15]) / MILLI_G).tolist(),
        }
        out["nees"][mode] = float(np.einsum("ri,ri->r", e, np.linalg.solve(P, e[..., None])[..., 0]).mean())
        out["nis"][mode] = {
            "zupt": float(held.nis_zupt[half:, m].mean()),
            "azimuth": float(held.nis_azimuth[half:, m].mean()),
        }
    return out


def report(result: dict[str, Any]) -> str:
    """The four modes at each mark, the budget beside them, consistency, and a one-line verdict at the end."""

    def three(values: Any, digits: int = 2) -> str:
        return " ".join(f"{value:8.{digits}f}" for value in values)

    a = result["alignment"]
    never = f", {a['incomplete_runs']} never" if a["incomplete_runs"] else ""
    when = f"after {a['complete_s']:g} s (median){never}" if a["complete_s"] is not None else "never"
    lines = [
        "Azimuth hold of Kim (2018): attitude errors and the filter's sigma about east, north, up, in arcmin, rms",
        "",
        f"alignment: complete {when}; delay to {a['delay_error_ms']:.2f} ms, misalignment to"
        f" {three(a['mu_error_arcmin']).strip()}",
        f"at the hand-over      error {three(a['error_arcmin'])}   sigma {three(a['sigma_arcmin'])}   "
        f"NEES {a['nees']:.1f} of 6, NIS {a['nis']:.1f} of 6",
    ]
    for mark in result["marks"]:
        lines += ["", f"after {mark['second']} s at rest"]
        for mode in result["modes"]:
            got = mark[mode]
            lines.append(
                f"  {mode:18}  error {three(got['error_arcmin'])}   sigma {three(got['sigma_arcmin'])}   "
                f"NEES {got['nees']:.1f} of 3"
            )
        got = mark["inertial"]
        lines.append(
            f"  inertial by theory  error {three(got['budget_arcmin'])}   beside it "
            f"{three(got['beside_budget_arcmin']).strip()}; random walk {three(got['walk_arcmin']).strip()}"
        )
    floor = result["floor"]
    lines += [
        "",
        f"accelerometer floor of the level: {floor['sigma_arcmin']:.2f} (one sigma); the level less the tilt that "
        f"cancels what is left of the bias: {three(floor['beside_arcmin']['zupt']).strip()} with zupt",
    ]
    for mode in result["modes"]:
        bias, nis = result["bias"][mode], result["nis"][mode]
        lines.append(
            f"  {mode:10} NEES {result['nees'][mode]:6.1f} of {16 if mode == 'reference' else 15}; NIS zupt "
            f"{nis['zupt']:.2f} of 3, azimuth {nis['azimuth']:.3f} of 1; gyro to {three(bias['gyro_deg_h']).strip()} "
            "deg/h"
        )
    if "shock" in result:
        from boresight.studies.azimuth_hold import shock as azimuth_shock

        lines += ["", azimuth_shock.report(result["shock"]), ""]
    last = result["marks"][-1]
    says = "; ".join(f"{mode} {last[mode]['error_arcmin'][2]:.1f}" for mode in result["modes"])
    lines.append(
        f"azimuth-hold: azimuth error after {last['second']} s in arcmin: {says} "
        f"({result['runs']} runs, seed {result['seed']})"
    )
    return "\n".join(lines)
