"""Kim (2018): how long a tactical-grade unit at rest keeps the attitude that a transfer alignment gave it.

Aligned on a moving bench (azimuth_alignment.py), then at rest: 100 Hz strapdown, 1 Hz filter, four ways to go on.
  inertial   no updates; height and vertical velocity are held, or they would run away within the hour
  zupt       zero-velocity updates, (16) and (17)
  azimuth    the same with the aligned azimuth, (20) to (23), its error taken for white noise as in the paper
  reference  the same with the error of that azimuth as a sixteenth state: it is one and the same all the time
The four ways fly the same runs with the same noise.  ENU, body axes right-front-up; phi is computed against true.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.consistency import chi_square_band, nees
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.filter import CompiledFilter, Epoch
from boresight.runtime.simulation import inertial
from boresight.runtime.units import ARCMIN, DEG, HOUR, MILLI_G
from boresight.studies.azimuth_hold import alignment, figures
from boresight.studies.azimuth_hold.alignment import Aligned, Models, Scenario
from boresight.studies.study import Claim, Progress, Result, Study, claim_lines, shown, silent, table

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


def start_filter(models: Models, start: Aligned, state: Array) -> tuple[CompiledFilter, Array]:
    """Ways to hold beside each other over the same runs, and the variance of the azimuth measurement, (..., runs, 1).

    state: (...,) bool, of which ways the reference's error is a state; of no variance in the others.
    """
    shape, variance = (*state.shape, len(start.P)), start.P[:, 8, 8]
    nav = {name: np.broadcast_to(value, (*state.shape, *value.shape)).copy() for name, value in start.nav.items()}
    nav["reference_error"] = np.zeros(shape)
    P = np.zeros((*shape, 16, 16))
    P[..., :15, :15] = start.P
    # The reference is the attitude of the hand-over, and in error by as much: d_ref = 0 - phi_u.
    P[..., :15, 15] = P[..., 15, :15] = np.where(state[..., None, None], -start.P[:, 8, :], 0.0)
    P[..., 15, 15] = np.where(state[..., None], variance, 0.0)
    # White in the paper's mode; with the state, what moves between one second and the next.
    R = np.where(state[..., None], REFERENCE_SIGMA**2, variance)[..., None]
    return CompiledFilter(models.hold_reference, nav, P), R


def hold(
    models: Models,
    scenario: Scenario,
    start: Aligned,
    seconds: int,
    *,
    zaru: bool = False,
    progress: Progress = silent,
) -> Held:
    """At rest for so many seconds, in all modes.  Uses up the noise streams of `start`.

    zaru: zero-angular-rate updates beside those of velocity, from the mean of each second.  Their noise is that of the
    gyros, which drives the attitude too; the filter is not told so, as usual.
    """
    hz, dt = scenario.strapdown_hz, 1 / scenario.strapdown_hz
    sensors = start.drawn.sensors
    loop, R_azimuth = start_filter(models, start, STATE)
    q_ref = loop.nav["q_b2n_wxyz"].copy()
    C_b2n = rotation.matrix_from_quaternion(start.q_b2n_wxyz)
    omega_b = np.einsum("rji,j->ri", C_b2n, start.earth["omega_ie_n"])
    f_b = alignment.rest_specific_force(models, start.position, start.q_b2n_wxyz)
    R_zupt = np.full(3, scenario.zupt_sigma_m_s**2)
    noise = alignment.rest_noise(scenario)
    epoch = a_second(loop, hz, noise)
    history: list[tuple[Array, ...]] = []
    nis: list[tuple[Array, Array]] = []

    def keep() -> None:
        phi = rotation.attitude_error(loop.nav["q_b2n_wxyz"], start.q_b2n_wxyz)
        P = loop.P[..., PHI, PHI]
        history.append((phi, np.sqrt(np.einsum("...ii->...i", P)), loop.nav["v_n"], nees(phi, P)))

    keep()
    before = None
    for second in range(1, seconds + 1):
        dtheta, dv = sensors.measured(omega_b * dt, f_b * dt, dt, hz)
        dtheta, dv = dtheta[:, None], dv[:, None]  # an axis of modes
        before = carry(epoch, dtheta, dv, before)
        zupt = loop.update("zupt", R_zupt, rows=ZUPT[:, None, None])
        azimuth = loop.update("azimuth", R_azimuth, rows=AZIMUTH[:, None, None], q_ref_wxyz=q_ref)
        if zaru:
            omega = dtheta.mean(axis=0) / dt - loop.nav["gyro_bias"]
            loop.update("zaru", noise["gyro_noise"] ** 2, rows=ZUPT[:, None, None], omega_ib_b=omega)
        loop.feedback()
        hold_vertical(loop, start)
        nis.append((zupt.nis, azimuth.nis))
        keep()
        if second % 600 == 0:
            progress(f"{second} of {seconds} s at rest")

    bias = sensors.bias_at(omega_b, f_b)
    error = np.concatenate(
        [
            loop.nav["lon_lat_height"] - start.position,
            loop.nav["v_n"],
            history[-1][0],
            loop.nav["gyro_bias"] - bias[0],
            loop.nav["accel_bias"] - bias[1],
            loop.nav["reference_error"][..., None]
            - rotation.attitude_error(q_ref, start.q_b2n_wxyz)[..., 2:] * STATE[:, None, None],
        ],
        axis=-1,
    )
    return Held(*(np.array(part) for kept in (history, nis) for part in zip(*kept, strict=True)), error, loop.P)  # type: ignore[call-arg]


def a_second(loop: CompiledFilter, hz: int, noise: dict[str, Array]) -> Epoch:
    """Strapdown and covariance over a second in one call."""
    epoch = Epoch(loop, hz, feedback=False, shared=("dt", *noise))
    epoch.strapdown["dt"], epoch.predict["dt"] = 1 / hz, 1.0
    for name, value in noise.items():
        epoch.predict[name] = value
    return epoch


def carry(epoch: Epoch, dtheta: Array, dv: Array, before: tuple[Array, Array] | None) -> tuple[Array, Array]:
    """`a_second` of increments (hz, ...); before: those of the interval before it.  Returns those of its last one."""
    for name, values in inertial.intervals(dtheta, dv, before).items():
        epoch.strapdown[name] = values
    epoch.predict["f_b"] = dv.sum(axis=0) - epoch.loop.nav["accel_bias"]  # m/s over a second
    if epoch():
        raise BoresightError(f"the hold at rest: {epoch.refused()}")
    return dtheta[-1], dv[-1]


def hold_vertical(loop: CompiledFilter, start: Aligned) -> None:
    """Of the inertial mode: height and vertical velocity are known from elsewhere, as every ship's or aircraft's are.

    Left alone, 1 mg would grow to 6 km in 1000 s and to 870 km in an hour, as exp(t / 570 s).
    """
    loop.nav["lon_lat_height"][0, :, 2] = start.position[2]
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
    g, omega_ie = start.gravity, start.earth["omega_ie_n"]
    C = rotation.matrix_from_quaternion(start.q_b2n_wxyz)
    f_b = alignment.rest_specific_force(models, start.position, start.q_b2n_wxyz)
    gyro, accel = start.drawn.sensors.bias_at(np.einsum("rji,j->ri", C, omega_ie), f_b)
    drift, floor = -np.einsum("rij,rj->ri", C, gyro), cancelling_tilt(start, accel)
    phi0 = rotation.attitude_error(start.nav["q_b2n_wxyz"], start.q_b2n_wxyz)
    lon, lat, _ = alignment.coordinates_per_metre(models, start.position)
    radius = 1 / np.array([lat, lon * np.cos(start.position[1])])  # about east: the meridian's
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
    walk = alignment.gyro_walk(scenario)
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


def cancelling_tilt(start: Aligned, accel_b: Array) -> Array:
    """(..., runs, 2) rad about east and north: the tilt whose gravity cancels an accelerometer error (..., runs, 3)."""
    a = np.einsum("rij,...rj->...ri", rotation.matrix_from_quaternion(start.q_b2n_wxyz), accel_b)
    return np.stack([-a[..., 1], a[..., 0]], axis=-1) / start.gravity  # f_n x phi + C b = 0 with f_n = (0, 0, g)


def remaining_floor(start: Aligned, held: Held) -> Array:
    """(4, runs, 2) rad: the tilt that cancels what is left of each run's accelerometer error at the end."""
    return cancelling_tilt(start, -held.error[..., 12:15])


# ---- the study

MARKS_S = (1000, 3600)


def root_mean_square(values: Array, axis: int = 0) -> Array:
    return np.sqrt(np.mean(np.square(values), axis=axis))


def run(scenario: Scenario, progress: Progress = silent, models: Models | None = None) -> Result:
    """The alignment and the four ways to hold: runs, seed, seconds, modes, axes;

    alignment: complete_s (median over runs, null if never), incomplete_runs, error_arcmin and sigma_arcmin (3, phi at
    the hand-over), mu_error_arcmin (3), delay_error_ms, nis (mean of six rows), nees (of velocity and attitude, 6);
    marks: at each of 1000 s, 3600 s and the end that was reached, second and mode -> error_arcmin, change_arcmin (since
    the hand-over, as the paper's Figures 4 and 6 plot it), sigma_arcmin (3, rms over runs), largest_arcmin (3), nees
    (of three angles, mean), speed_m_s (3, rms), and for the inertial mode budget_arcmin (rms of the closed form, run by
    run), beside_budget_arcmin (rms of the difference) and walk_arcmin (the random walk that the closed form leaves
    out), all (3);
    floor: sigma_arcmin (one sigma of 1 mg and what belongs to it), rms_arcmin (of these runs), beside_arcmin: mode ->
    rms of the level error less the tilt that cancels what is left of the accelerometer error, 2 axes;
    bias: mode -> gyro_deg_h, gyro_sigma_deg_h, accel_mg, accel_sigma_mg (3, body axes) at the end;
    nees: mode -> of all fifteen states (sixteen for reference) at the end, mean; nis: mode -> zupt (of 3 rows) and
    azimuth (of 1), mean over the last half;
    history: time_s; error_arcmin (T, modes, runs, 3), sigma_arcmin (T, modes, 3), rms over the runs.
    """
    scenario, models = alignment.checked(scenario), models or alignment.load_models()
    runs, seconds = scenario.runs, scenario.seconds
    progress(f"transfer alignment: {runs} runs of {scenario.align_s:g} s")
    start = alignment.align(models, scenario, runs=runs, seed=scenario.seed)
    progress(f"hold: {len(MODES)} modes of {runs} runs, {seconds} s")
    held = hold(models, scenario, start, seconds, progress=progress)
    theory = budget(models, scenario, start, np.arange(seconds + 1))
    every = max(1, seconds // 720)
    return {
        "runs": runs,
        "seed": scenario.seed,
        "seconds": seconds,
        "modes": list(MODES),
        "axes": list(AXES),
        "alignment": aligned_summary(start),
        "marks": [
            {"second": second, **{mode: marked(held, theory, second, m) for m, mode in enumerate(MODES)}}
            for second in sorted({second for second in MARKS_S if second <= seconds} | {seconds})
        ],
        **ended_summary(models, scenario, start, held, theory),
        "history": {
            "time_s": np.arange(0, seconds + 1, every),
            "error_arcmin": held.phi[::every] / ARCMIN,
            "sigma_arcmin": root_mean_square(held.sigma[::every], 2) / ARCMIN,
        },
    }


def aligned_summary(start: Aligned) -> dict[str, Any]:
    phi = rotation.attitude_error(start.nav["q_b2n_wxyz"], start.q_b2n_wxyz)
    error = np.concatenate([start.nav["v_n"], phi], axis=-1)
    met = start.complete_s[np.isfinite(start.complete_s)]
    return {
        "complete_s": float(np.median(met)) if len(met) else None,
        "incomplete_runs": int(np.isnan(start.complete_s).sum()),
        "error_arcmin": (root_mean_square(phi) / ARCMIN).tolist(),
        "sigma_arcmin": (np.sqrt(np.einsum("rii->ri", start.P).mean(axis=0)[PHI]) / ARCMIN).tolist(),
        "mu_error_arcmin": (root_mean_square(start.mu_error) / ARCMIN).tolist(),
        "delay_error_ms": float(root_mean_square(start.delay_error) * 1e3),
        "nis": float(start.nis.mean()),
        "nees": float(nees(error, start.P[:, 3:9, 3:9]).mean()),
    }


def marked(held: Held, theory: dict[str, Array], second: int, mode: int) -> dict[str, Any]:
    phi = held.phi[second, mode]
    out: dict[str, Any] = {
        "error_arcmin": (root_mean_square(phi) / ARCMIN).tolist(),
        "change_arcmin": (root_mean_square(phi - held.phi[0, mode]) / ARCMIN).tolist(),
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
    f_b = alignment.rest_specific_force(models, start.position, start.q_b2n_wxyz[0])
    floor = alignment.bias_variances(scenario, f_b)[3:]
    beside = held.phi[-1, ..., :2] - remaining_floor(start, held)
    half = len(held.nis_zupt) // 2
    out: dict[str, Any] = {
        "floor": {
            "sigma_arcmin": float(np.sqrt(floor[:2].mean()) / start.gravity / ARCMIN),
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
        out["bias"][mode] = bias_summary(held, m)
        out["nees"][mode] = float(nees(e, P).mean())
        out["nis"][mode] = {
            "zupt": float(held.nis_zupt[half:, m].mean()),
            "azimuth": float(held.nis_azimuth[half:, m].mean()),
        }
    return out


def bias_summary(held: Held, mode: int) -> dict[str, list[float]]:
    """Error and sigma of the biases at the end, rms of the runs, body axes."""
    error, sigma = held.error[mode], np.sqrt(np.einsum("rii->ri", held.P[mode]))
    return {
        f"{sensor}_{what}{unit}": (root_mean_square(values[:, part]) / size).tolist()
        for sensor, part, unit, size in (
            ("gyro", slice(9, 12), "deg_h", DEG / HOUR),
            ("accel", slice(12, 15), "mg", MILLI_G),
        )
        for what, values in (("", error), ("sigma_", sigma))
    }


def claims(result: Result) -> list[Claim]:
    """What the paper concludes, at the end of this run.

    An axis is held where the attitude has changed since the hand-over by less than what an alignment must reach to be
    complete: 1 arcmin in the level, 2 about up (rms over the runs).
    """
    last, first, complete = result["marks"][-1], np.array(result["alignment"]["sigma_arcmin"]), alignment.COMPLETE
    limit = np.array([complete.level_sigma, complete.level_sigma, complete.azimuth_sigma]) / ARCMIN

    def by_axis(values: Any, what: str = "") -> dict[str, float | None]:
        return {f"{what}{axis}": float(value) for axis, value in zip(AXES, values, strict=True)}

    inertial, zupt, azimuth = (np.array(last[mode]["change_arcmin"]) for mode in ("inertial", "zupt", "azimuth"))
    sigma = np.array(last["azimuth"]["sigma_arcmin"])
    out = [
        Claim("pure inertial drifts in all three axes, arcmin", bool((inertial > limit).all()), by_axis(inertial)),
        Claim("zero velocity holds the level and not the azimuth, arcmin",
              bool((zupt < limit)[:2].all() and zupt[2] > limit[2]), by_axis(zupt)),
        Claim("with the azimuth all three axes hold, arcmin", bool((azimuth < limit).all()), by_axis(azimuth)),
        Claim("with the azimuth all three sigmas fall from the hand-over on, arcmin", bool((sigma < first).all()),
              by_axis(first, "first ") | by_axis(sigma, "last ")),
    ]  # fmt: skip
    low, high = chi_square_band(3, result["runs"])
    for mode, says in (("azimuth", "taken for white"), ("reference", "a state")):
        got = last[mode]
        numbers = {"NEES of 3": got["nees"], "error up": got["error_arcmin"][2], "sigma up": got["sigma_arcmin"][2],
                   "change up": got["change_arcmin"][2]}  # fmt: skip
        says = f"its error {says}, the hold is consistent: NEES of the angles in its 95 % band"
        out.append(Claim(says, low <= got["nees"] <= high, numbers))
    return out


def report(result: Result) -> str:
    """The four modes at each mark, the budget beside them, consistency, and the paper's conclusions."""
    a = result["alignment"]
    never = f", {a['incomplete_runs']} never" if a["incomplete_runs"] else ""
    when = f"after {a['complete_s']:g} s (median){never}" if a["complete_s"] is not None else "never"
    lines = [
        f"Azimuth hold of Kim (2018): {result['runs']} runs, seed {result['seed']}; east, north, up in arcmin, rms",
        f"alignment: complete {when}; delay to {a['delay_error_ms']:.2f} ms, misalignment to "
        f"{shown(a['mu_error_arcmin'], '.2f').strip()}; NEES {a['nees']:.1f} of 6, NIS {a['nis']:.1f} of 6",
    ]
    head = ("", "error", "change", "sigma", "NEES of 3")
    for mark in [{"second": 0}, *result["marks"]]:
        rows = [
            (mode, *(mark[mode][f"{key}_arcmin"] for key in ("error", "change", "sigma")), mark[mode]["nees"])
            for mode in result["modes"] if mode in mark
        ] or [("hand-over", a["error_arcmin"], None, a["sigma_arcmin"], None)]  # fmt: skip
        lines += ["", f"after {mark['second']} s at rest: error, its change since the hand-over, and sigma"]
        lines += table(head, rows, ".2f")
        if "inertial" in mark:
            names = (("theory", "budget"), ("beside it", "beside_budget"), ("random walk", "walk"))
            got = mark["inertial"]
            cells = (f"{name} {shown(got[key + '_arcmin'], '.2f').strip()}" for name, key in names)
            lines.append("  inertial by " + "; ".join(cells))
    floor = result["floor"]
    lines += [
        "",
        f"accelerometer floor of the level: {floor['sigma_arcmin']:.2f} (one sigma); the level less the tilt that",
        f"cancels what is left of the bias: {shown(floor['beside_arcmin']['zupt'], '.2f').strip()} with zupt",
        *table(
            ("at the end", "NEES", "of", "NIS zupt of 3", "azimuth of 1", "gyro, deg/h"),
            [
                (mode, result["nees"][mode], 16 if mode == "reference" else 15, *result["nis"][mode].values(),
                 result["bias"][mode]["gyro_deg_h"])
                for mode in result["modes"]
            ],
            ["", ".1f", "d", ".2f", ".3f", ".2f"],
        ),
        "",
        f"the paper's conclusions, after {result['marks'][-1]['second']} s",
        *claim_lines(claims(result)),
    ]  # fmt: skip
    return "\n".join(lines)


STUDY = Study("azimuth-hold", alignment.MODELS, Scenario, run, report, figures.draw, claims)
