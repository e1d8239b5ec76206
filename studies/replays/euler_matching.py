"""Transfer alignment on a recording: Euler-angle matching of a slave's strapdown to its master's attitude.

The slave's attitude begins as the master's, so its first error *is* the misalignment: P0 carries eps(0) = -C dmu(0).
The model has no gyro-bias state; a calibrated bias is an input.  What is found on a real recording: docs/recordings.md.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.figures import BLUE, ORANGE, Sheets
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.filter import Filter
from boresight.runtime.library import load
from boresight.runtime.recording import Recording, best_delay, shifted, thinned
from boresight.runtime.recording.check import whole_turns
from boresight.runtime.units import ARCMIN, DEG, DEG_H
from boresight.studies.euler_table.table import first_covariance
from boresight.studies.replays.innovations import consistency, minus_log_likelihood, most_likely
from boresight.studies.study import Progress, Replay, Study, table

DEG_SQRT_H = DEG / 60  # rad/sqrt(s) of 1 deg/sqrt(h)
AXES = ("roll", "pitch", "yaw")
MEASUREMENTS = ("euler_exact", "euler")
MU_PRIOR = np.radians(1.0)  # rad, one sigma of each misalignment before the first update
NOISE_RANGE = (1e-7, 0.03)  # rad/sqrt(s) and rad: what `fit_noise` searches
FIRST_GUESS = (0.5 * DEG_SQRT_H, 1.0 * ARCMIN)  # gyro and angle noise where it begins


# ---------------------------------------------------------------- the filter on a recording


@dataclass(frozen=True)
class Leg:
    """What the filter needs of a recording, interval after interval of the master."""

    time: Array  # (K+1,) s, the instants of the master that the slave covers
    euler: Array  # (K+1, 3) rad, the master's attitude then
    omega_in_n: Array  # (K, 3) rad/s, held over each interval
    pieces: tuple[tuple[Array, Array], ...]  # K of: dt (J,) s, dtheta (J, 3) rad, the slave's samples, bias removed
    turns: Array  # (K, 3) rad, the same samples as one rotation vector
    doubt: Array  # (K,) rad^2, what samples that were bridged may have missed, each axis


def prepare(recording: Recording, model: Any, gyro_bias: Array, rate_hz: float | None = None) -> Leg:
    """Cut a recording into the master's intervals.  rate_hz: use the master no more often than this."""
    imu, master = recording.imu, recording.master
    if master is None:
        raise BoresightError(f"{recording.name}: it has no master, and matching needs one; describe it in [master]")
    if master.position is None:
        raise BoresightError(f"{recording.name}: Earth rate needs the latitude; describe master.position")
    start, end = imu.intervals()
    inside = (master.time >= start[0] - 0.01 * imu.dt) & (master.time <= end[-1] + 0.01 * imu.dt)
    master = thinned(master.cut(inside), rate_hz)
    if len(master.time) < 3:
        count = len(master.time)
        raise BoresightError(f"{recording.name}: {count} samples of the master fall into the slave's data; it needs 3")
    steepest = float(np.degrees(np.abs(master.euler[:, 1]).max()))
    if steepest > 80:
        raise BoresightError(
            f"{recording.name}: the master pitches to {steepest:.1f} deg, and Euler angles are matched up to 80; "
            "cut it (--from, --to), or use --model velocity-attitude"
        )
    v_n = np.zeros((len(master.time), 3)) if master.v_n is None else master.v_n
    assert master.position is not None
    omega = model.omega_in_n(lat=master.position[:, 0], height=master.position[:, 2], v_n=v_n)
    pieces = []
    for t0, t1 in zip(master.time[:-1], master.time[1:], strict=True):
        dt, dtheta = imu.between(t0, t1)
        pieces.append((dt, dtheta - gyro_bias * dt[:, None]))
    turns = whole_turns([dtheta for _, dtheta in pieces])
    doubt = np.zeros(len(start) + 1) if imu.doubt is None else np.append(0.0, np.cumsum(imu.doubt[:, 0] ** 2))
    doubt = np.diff(np.interp(master.time, np.append(start[0], end), doubt))
    return Leg(master.time, master.euler, omega[:-1], tuple(pieces), turns, doubt)


def fly(
    leg: Leg, model: Any, gyro_noise: Array, angle_noise: Array, measurement: str, *, every_sample: bool = True
) -> dict[str, Array]:
    """One pass of the filter; leading axes of the noises are runs side by side.

    gyro_noise: (..., 3) rad/sqrt(s).  angle_noise: (..., 3) rad, of the master's roll, pitch and yaw.
    every_sample: the strapdown takes each sample of the slave; otherwise one turn an interval, which is the same
    rotation to rounding while omega_in_n is held (it acts from the left, the samples from the right), and much faster.
    Returns arrays by name, first axis the K updates: mu, nu, S (K, ..., 3), sigma (K, ..., 6); and at the end
    P (..., 6, 6), q_b2n_wxyz (..., 4).
    """
    runs = np.broadcast_shapes(np.shape(gyro_noise), np.shape(angle_noise))[:-1]
    euler = leg.euler[0]
    P = np.broadcast_to(first_covariance(model, euler, MU_PRIOR, np.asarray(angle_noise)), (*runs, 6, 6))
    nav = {"q_b2n_wxyz": np.tile(rotation.quaternion_from_euler(euler), (*runs, 1)), "mu": np.zeros((*runs, 3))}
    ekf = Filter(model, nav, P)
    history: dict[str, list[Array]] = {"mu": [], "sigma": [], "nu": [], "S": []}
    for k, (dts, dthetas) in enumerate(leg.pieces):
        omega_in_n, interval = leg.omega_in_n[k], leg.time[k + 1] - leg.time[k]
        opened = np.sqrt(gyro_noise**2 + leg.doubt[k] / interval)
        ekf.predict(omega_in_n=omega_in_n, gyro_noise=opened, dt=interval)
        for dt, dtheta in zip(dts, dthetas, strict=True) if every_sample else [(interval, leg.turns[k])]:
            ekf.strapdown(dtheta_ib_b=dtheta, omega_in_n=omega_in_n, dt=dt)
        euler_b = ekf.call("euler_angles")
        innovation = ekf.update(measurement, angle_noise**2, euler_b=euler_b, euler_m=leg.euler[k + 1] + 0 * euler_b)
        ekf.feedback()
        history["mu"].append(ekf.nav["mu"])
        history["sigma"].append(np.sqrt(np.diagonal(ekf.P, axis1=-2, axis2=-1)))
        history["nu"].append(innovation.nu)
        history["S"].append(innovation.S)
    track = {name: np.array(values) for name, values in history.items()}
    return track | {"P": ekf.P, "q_b2n_wxyz": ekf.nav["q_b2n_wxyz"]}


# ---------------------------------------------------------------- choosing the noises


def fit_noise(
    leg: Leg, model: Any, measurement: str, gyro_noise: Array | None = None, angle_noise: Array | None = None
) -> tuple[Array, Array, int]:
    """The noises under which the innovations are most likely: of the gyro (white rate), of the master (white angle).

    From FIRST_GUESS; what is given is kept.
    Returns gyro_noise (3,) rad/sqrt(s), angle_noise (3,) rad, and the passes it took.
    Raises BoresightError if it does not settle.
    """
    first, free = np.repeat(FIRST_GUESS, 3), np.ones(6, dtype=bool)
    for part, value in ((slice(0, 3), gyro_noise), (slice(3, 6), angle_noise)):
        if value is not None:
            first[part], free[part] = value, False

    def flown(noises: Array) -> dict[str, Array]:
        return fly(leg, model, noises[:, :3], noises[:, 3:], measurement, every_sample=False)

    noises, _, passes = most_likely(flown, first, free, NOISE_RANGE)
    return noises[:3], noises[3:], passes


# ---------------------------------------------------------------- one replay


def run(
    recording: Recording,
    model: Any,
    *,
    gyro_bias: Sequence[float] | Array | None = None,
    gyro_noise: Sequence[float] | Array | None = None,
    angle_noise: Sequence[float] | Array | None = None,
    delay: float = 0.0,
    rate_hz: float | None = None,
    measurement: str = "euler_exact",
) -> dict[str, Any]:
    """Replay a recording through a filter and say what came out, as a dict that json can write.

    gyro_bias: (3,) rad/s, measured = true + bias, in FRD; None takes the recording's own, or zero if it has none.
    gyro_noise: (3,) rad/sqrt(s), angle_noise: (3,) rad; what is None is chosen by `fit_noise`.
    delay: s, how old the master's data is taken to be.  measurement: "euler_exact", or "euler" as the
    paper has it, whose second-order error shows in a misalignment that is known badly.
    Fields: docs/recordings.md.  Raises BoresightError if the recording cannot be replayed.
    """
    if measurement not in MEASUREMENTS:
        raise BoresightError(f"measurement {measurement!r} is not known; use {' or '.join(MEASUREMENTS)}")
    bias, origin = _bias(recording, gyro_bias)
    leg = prepare(shifted(recording, delay), model, bias, rate_hz)
    gyro, angle, passes = fit_noise(
        leg, model, measurement, _noise("gyro_noise", gyro_noise), _noise("angle_noise", angle_noise)
    )
    track = fly(leg, model, gyro, angle, measurement)
    estimate, sigma = track["mu"][-1], track["sigma"][-1]
    reference = recording.reference.get("misalignment")
    w = track["nu"] / np.sqrt(track["S"])
    K = len(w)
    out: dict[str, Any] = {
        "recording": recording.name,
        "title": recording.title,
        "measurement": measurement,
        "duration_s": float(leg.time[-1] - leg.time[0]),
        "notes": list(recording.notes),
        "updates": K,
        "delay_s": delay,
        "gyro_bias_deg_h": (bias / DEG_H).tolist(),
        "gyro_bias_from": origin,
        "noise": {
            "gyro_deg_sqrt_h": (gyro / DEG_SQRT_H).tolist(),
            "angle_arcmin": (angle / ARCMIN).tolist(),
            "passes": passes,
        },
        "minus_log_likelihood": float(minus_log_likelihood(track)),
        "misalignment": {
            "axes": list(AXES),
            "estimate_arcmin": (estimate / ARCMIN).tolist(),
            "sigma_arcmin": (sigma[3:] / ARCMIN).tolist(),
            "reference_arcmin": None if reference is None else (reference / ARCMIN).tolist(),
            "difference_arcmin": None if reference is None else ((estimate - reference) / ARCMIN).tolist(),
            "difference_sigmas": None if reference is None else ((estimate - reference) / sigma[3:]).tolist(),
        },
        "nis": nis(w),
        "observability": observability(leg, track["P"], track["q_b2n_wxyz"]),
        "history": {
            "time_s": leg.time[1:].tolist(),
            "mu_arcmin": (track["mu"] / ARCMIN).tolist(),
            "sigma_arcmin": (track["sigma"][:, 3:] / ARCMIN).tolist(),
            "normalised_innovation": w.tolist(),
            "master_deg": np.degrees(leg.euler[1:]).tolist(),
        },
    }
    return out


def _bias(recording: Recording, given: Any) -> tuple[Array, str]:
    if given is not None:
        bias = np.asarray(given, float)
        if bias.shape != (3,) or not np.isfinite(bias).all():
            raise BoresightError(f"gyro_bias must be three finite numbers in rad/s; it has shape {bias.shape}")
        return bias, "given"
    if "gyro_bias" in recording.reference:
        return recording.reference["gyro_bias"], "recording"
    return np.zeros(3), "none: taken as zero"


def _noise(name: str, given: Any) -> Array | None:
    if given is None:
        return None
    noise = np.asarray(given, float)
    low, high = NOISE_RANGE
    # What was printed in other units and comes back may be off by its rounding.
    if noise.shape != (3,) or not ((noise > low * (1 - 1e-9)) & (noise < high * (1 + 1e-9))).all():
        raise BoresightError(f"{name} must be three numbers from {low} to {high}, in rad and s; it is {noise.tolist()}")
    return noise


def nis(w: Array) -> dict[str, Any]:
    """`consistency` of (K, 3) normalised innovations of the master's angles."""
    judged = consistency(w)
    return {"per_angle": judged.pop("per_row"), **judged}


def observability(leg: Leg, P: Array, q_b2n_wxyz: Array) -> dict[str, Any]:
    """Why some misalignment is well known and some not: from the last covariance, and from the motion.

    The measurement sees the sum of the slave's attitude error about a body axis and the misalignment about it.  Only
    motion that turns this axis in space tells the two apart; their correlation stays at -1 otherwise.
    """
    T = np.eye(6)
    T[:3, :3] = rotation.matrix_from_quaternion(q_b2n_wxyz).T  # attitude error in body axes
    body = T @ P @ T.T
    sd = np.sqrt(np.diag(body))
    C = rotation.matrix_from_euler(leg.euler)
    mean = C.mean(axis=0)
    # How far each body axis strays in space: the rms angle from its own mean direction.
    length = np.linalg.norm(mean, axis=0)
    stray = np.sqrt(2 * (1 - np.minimum(length, 1.0)))
    return {
        "axes": ["front", "right", "down"],
        "correlation": [float(body[i, i + 3] / (sd[i] * sd[i + 3])) for i in range(3)],
        "attitude_sigma_arcmin": (sd[:3] / ARCMIN).tolist(),
        "misalignment_sigma_arcmin": (sd[3:] / ARCMIN).tolist(),
        "axis_stray_deg": np.degrees(stray).tolist(),
        "turned_rms_deg": np.degrees(np.std(leg.euler, axis=0)).tolist(),
    }


# ---------------------------------------------------------------- saying it


def report(result: dict[str, Any]) -> str:
    """The result as a text for a terminal, and the same without the bias calibration if that was flown."""
    lines = [
        f"{result['title'] or result['recording']}: {result['updates']} updates in {result['duration_s']:.1f} s, "
        f"measurement {result['measurement']}, master taken as {result['delay_s'] * 1e3:.1f} ms old",
        *result["notes"],
        f"gyro bias removed ({result['gyro_bias_from']}): {_row(result['gyro_bias_deg_h'], '.1f')} deg/h",
        f"noises of greatest likelihood ({result['noise']['passes']} passes): "
        f"gyro {_row(result['noise']['gyro_deg_sqrt_h'], '.3f')} deg/sqrt(h), "
        f"master's roll, pitch, yaw {_row(result['noise']['angle_arcmin'], '.3f')} arcmin"
        if result["noise"]["passes"]
        else f"noises as given: gyro {_row(result['noise']['gyro_deg_sqrt_h'], '.3f')} deg/sqrt(h), "
        f"master's roll, pitch, yaw {_row(result['noise']['angle_arcmin'], '.3f')} arcmin",
        "",
        _table(result),
        "",
        _consistency(result["nis"]),
        "",
        _observability(result),
    ]
    without_bias = result.get("without_bias")
    if without_bias is not None:
        off, t, axis, claimed = without_bias["excursion"]
        # Noises that were fitted again hide a bias by calling it noise; their NIS is near one and proves nothing.
        noises = "noises chosen anew" if without_bias["noise"]["passes"] else "same noises"
        lines += [
            "",
            f"Without the bias calibration, {noises}: mean NIS {without_bias['nis']['mean']:.2f};",
            f"misalignment at the end {_row(without_bias['misalignment']['estimate_arcmin'], '.1f')} arcmin,",
            f"and at {t:.1f} s its {axis} is {off:+.1f} arcmin from the estimate above and claims {claimed:.1f}.",
        ]
    return "\n".join(lines)


def worst_excursion(result: dict[str, Any], final: Sequence[float]) -> tuple[float, float, str, float]:
    """Where the estimate was furthest, in its own sigmas, from FINAL: arcmin off, time in s, axis, the sigma then."""
    history = result["history"]
    off, sigma = np.array(history["mu_arcmin"]) - final, np.array(history["sigma_arcmin"])
    k, axis = np.unravel_index(np.argmax(np.abs(off) / sigma), off.shape)
    return float(off[k, axis]), history["time_s"][k], AXES[axis], float(sigma[k, axis])


def _row(values: Sequence[float], spec: str) -> str:
    return "[" + ", ".join(format(value, spec) for value in values) + "]"


def _table(result: dict[str, Any]) -> str:
    m = result["misalignment"]
    columns = [("arcmin", "axes", ""), ("estimate", "estimate_arcmin", ".3f"), ("1 sigma", "sigma_arcmin", ".3f")]
    if m["reference_arcmin"] is not None:
        columns += [("reference", "reference_arcmin", ".3f"), ("difference", "difference_arcmin", "+.3f"),
                    ("in sigmas", "difference_sigmas", "+.2f")]  # fmt: skip
    head, keys, formats = zip(*columns, strict=True)
    return "\n".join(table(head, zip(*(m[key] for key in keys), strict=True), formats))


def _consistency(nis: dict[str, Any]) -> str:
    inside = "inside" if nis["consistent"] else "OUTSIDE"
    white = "white" if nis["white"] else "NOT white: something is not modelled, as a delay or a bias"
    return (
        f"NIS for each row {_row(nis['per_angle'], '.3f')}, mean {nis['mean']:.3f}, "
        f"{inside} its 95 % band {_row(nis['band'], '.3f')}; by quarter of the time {_row(nis['by_quarter'], '.2f')}\n"
        f"correlation of neighbours {_row(nis['lag1'], '+.3f')}, bound {nis['lag1_bound']:.3f}: {white}"
    )


def _observability(result: dict[str, Any]) -> str:
    o = result["observability"]
    worst = int(np.argmax(o["misalignment_sigma_arcmin"]))
    head = ("body axis", "strays in space, deg", "correlation of attitude error and misalignment about it")
    rows = zip(o["axes"], o["axis_stray_deg"], o["correlation"], strict=True)
    lines = table(head, rows, ("", ".2f", "+.4f"))
    lines.append(
        f"Worst known: {AXES[worst]}, to {o['misalignment_sigma_arcmin'][worst]:.2f} arcmin.  Measured is the sum of "
        "attitude error and\nmisalignment about an axis, and only turning that axis in space tells them apart."
    )
    return "\n".join(lines)


def figures(result: dict[str, Any], sheets: Sheets) -> None:
    """Draw the motion, the three estimates with their sigmas, and the innovations."""
    history = {name: np.array(values) for name, values in result["history"].items()}
    t, reference = history["time_s"], result["misalignment"]["reference_arcmin"]
    with sheets(f"replay_{result['recording']}", 11, 7.5, nrows=3, ncols=3, sharex=True) as (drawing, axes):
        for i, name in enumerate(AXES):
            motion, estimate, innovation = axes[:, i]
            motion.plot(t, history["master_deg"][:, i], color="0.3", lw=1)
            motion.set_title(name)
            mu, sigma = history["mu_arcmin"][:, i], history["sigma_arcmin"][:, i]
            estimate.fill_between(t, mu - sigma, mu + sigma, color=BLUE, alpha=0.25, lw=0, label="1 sigma")
            estimate.plot(t, mu, color=BLUE, lw=1.2, label="estimate")
            centre = mu[-1]
            if reference is not None:
                estimate.axhline(reference[i], color=ORANGE, lw=1.2, ls="--", label="reference")
                centre = (mu[-1] + reference[i]) / 2
            # The first seconds are off the scale by design: the prior is a degree.
            reach = max(6 * sigma[-1], 3.0) + abs(mu[-1] - centre)
            estimate.set_ylim(centre - reach, centre + reach)
            innovation.plot(t, history["normalised_innovation"][:, i], ".", ms=2, color=BLUE)
            for bound in (-2, 2):
                innovation.axhline(bound, color="0.5", lw=0.8, ls=":")
            innovation.set_ylim(-6, 6)
            innovation.set_xlabel("time [s]")
        for row, label in enumerate(("master's angle [deg]", "misalignment [arcmin]", "innovation / sigma")):
            axes[row, 0].set_ylabel(label)
        axes[1, 0].legend(loc="upper right", fontsize=8)
        nis_text = f"mean NIS {result['nis']['mean']:.2f} for each row"
        says = f"{result['title'] or result['recording']}; delay {result['delay_s'] * 1e3:.1f} ms; {nis_text}"
        drawing.suptitle(says, fontsize=9)


def flown(asked: Replay, progress: Progress) -> dict[str, Any]:
    """`run`, and beside it the delay that the turns show and, where a bias was removed, the same without that."""
    recording, model = asked.recording, load("euler-matching")
    result = run(recording, model, **asked.settings)
    result["delay_seen_s"], result["delay_gain"] = best_delay(recording.imu, recording.master)
    result["without_bias"] = None
    if any(result["gyro_bias_deg_h"]):
        progress("without the bias calibration")
        gyro, angle = result["noise"]["gyro_deg_sqrt_h"], result["noise"]["angle_arcmin"]
        noises = {"gyro_noise": np.array(gyro) * DEG_SQRT_H, "angle_noise": np.array(angle) * ARCMIN}
        other = run(recording, model, **{**asked.settings, "gyro_bias": np.zeros(3), **noises})
        other["excursion"] = worst_excursion(other, result["misalignment"]["estimate_arcmin"])
        result["without_bias"] = {name: value for name, value in other.items() if name != "history"}
    return result


def whole_report(result: dict[str, Any]) -> str:
    seen, gain = result["delay_seen_s"] * 1e3, result["delay_gain"]
    fit = f"The turns fit best if the master is {seen:.1f} ms old: {gain:.1f} times better than at 0 ms."
    return f"{report(result)}\n\n{fit}"


STUDY = Study("replay euler-matching", ("euler-matching",), Replay, flown, whole_report, figures,
              good=lambda result: result["nis"]["consistent"])  # fmt: skip
