"""When does an inertial sensor stand still?  The detectors on a recording that begins at rest, then stops and goes.

The noise comes from a rest that the user states; the thresholds from that noise and a rate of false alarms; the result
holds a mask for each sample and detector, for zero-velocity updates to use.  Nothing here looks ahead or at a filter.
"""

from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.figures import BLUE, GREY, ORANGE, Sheets
from boresight.runtime import detector as d
from boresight.runtime.array import Array
from boresight.runtime.recording import Inertial, Recording
from boresight.runtime.status import Status

KIM = "kim-2018"  # the paper's decision: accel_std and gyro_mean both say rest
NAMES = (*d.DETECTORS, KIM)
UNITS = {"gyro_mean": "rad/s", "gyro_std": "rad/s", "accel_mean": "m/s^2", "accel_std": "m/s^2", "likelihood_ratio": ""}
LASTING = 0.5  # s: a movement at least this long ends a rest, a rest at least this long is listed


def noise(imu: Inertial, rest: tuple[float, float]) -> dict[str, Any]:
    """What the sensor shows during a stated rest, t0 <= time < t1 (s), in seconds of its own.

    gyro_bias (3,) rad/s: the mean.  gravity m/s^2: norm of the mean specific force.  sigma_gyro, sigma_accel: root mean
    square about the mean of the worst second, over axes: a floor is not equally quiet all the time.  rest_rate,
    gravity_error: largest departure of a second's mean from those of the whole.  lag1: correlation of neighbours per
    axis, in the whole with each second's mean removed; it would be 0 for white noise.
    """
    t0, t1 = rest
    inside = (imu.time >= t0) & (imu.time < t1)
    length = round(1 / imu.dt)
    seconds = int(inside.sum()) // length
    if seconds < 2:
        raise BoresightError(
            f"the stated rest of {t0:g} s to {t1:g} s holds {inside.sum()} samples; it needs 2 s of {length} a second"
        )
    gyro, accel = (part[inside][: seconds * length] for part in imu.rates())
    if not (np.isfinite(gyro).all() and np.isfinite(accel).all()):
        raise BoresightError(f"the stated rest of {t0:g} s to {t1:g} s holds values that are not finite; cut them out")
    bias, gravity = gyro.mean(axis=0), float(np.linalg.norm(accel.mean(axis=0)))
    by_second = [part.reshape(seconds, length, 3) for part in (gyro, accel)]
    sigma = [float(np.sqrt(part.var(axis=1).mean(axis=-1)).max()) for part in by_second]
    if min(sigma) == 0:
        raise BoresightError(f"the sensor shows no noise from {t0:g} s to {t1:g} s; no threshold follows from that")
    means = [part.mean(axis=1) for part in by_second]
    centred = [part - mean[:, None] for part, mean in zip(by_second, means, strict=True)]
    lag1 = [(c[:, 1:] * c[:, :-1]).sum(axis=(0, 1)) / (c * c).sum(axis=(0, 1)) for c in centred]
    return {
        "rest_s": [float(t0), float(t1)],
        "sigma_gyro": sigma[0],
        "sigma_accel": sigma[1],
        "gravity": gravity,
        "gyro_bias": bias.tolist(),
        "rest_rate": float(np.linalg.norm(means[0] - bias, axis=1).max()),
        "gravity_error": float(np.abs(np.linalg.norm(means[1], axis=1) - gravity).max()),
        "lag1_gyro": lag1[0].tolist(),
        "lag1_accel": lag1[1].tolist(),
    }


def run(
    recording: Recording,
    *,
    rest: tuple[float, float] = (0.0, 15.0),
    window: int = 50,
    false_alarm_rate: float = 1e-3,
) -> dict[str, Any]:
    """Every detector on a recording; rest: from when to when (s) it is known to stand still.

    false_alarm_rate: of movement declared while resting, for one window; of the paper's decision as a whole, so that
    each of its two halves, which are independent at rest, has the share 1 - sqrt(1 - rate).
    Returns what docs/stationary-detectors.md lists; `history` holds time_s (K,), rest: name -> (K,) bool for each
    sample, and statistic: name -> (K,).
    """
    imu = recording.imu
    found = noise(imu, rest)
    known = {key: found[key] for key in ("gravity", "rest_rate", "gravity_error")}
    gyro, accel = imu.rates()
    gyro = gyro - found["gyro_bias"]
    restart = d.gaps(imu.time)
    dll = d.library()

    def decide(rate: float) -> tuple[d.Settings, d.Decisions]:
        settings = d.settings(window, found["sigma_accel"], found["sigma_gyro"], rate, **known)
        return settings, d.evaluate(settings, gyro, accel, restart, dll=dll)

    settings, decisions = decide(false_alarm_rate)
    _, halves = decide(1 - np.sqrt(1 - false_alarm_rate))
    masks = {name: decisions.rest_by(name) for name in d.DETECTORS}
    masks[KIM] = halves.rest_by("accel_std", "gyro_mean")

    decided = decisions.status == Status.OK
    if not decided.any():
        raise BoresightError(f"no {window} samples in a row are free of gaps and bad values; take a shorter window")
    resting = decided & (imu.time >= rest[0]) & (imu.time < rest[1])
    detectors = {}
    for name, mask in masks.items():
        parts = segments(imu, mask, decided)
        detectors[name] = {
            "threshold": settings.threshold.get(name),
            "unit": UNITS.get(name, ""),
            "share": float(mask[decided].mean()),
            "movement_in_stated_rest": float((~mask[resting]).mean()) if resting.any() else None,
            "first_rest_end_s": parts[0][1] if parts else None,
            "segments": parts,
        }
    return {
        "recording": recording.name,
        "title": recording.title,
        "samples": len(imu.time),
        "rate_hz": 1 / imu.dt,
        "window": window,
        "window_s": window * imu.dt,
        "false_alarm_rate": false_alarm_rate,
        "undecided": int((~decided).sum()),
        "gaps_s": imu.time[restart].tolist(),
        "refused_s": imu.time[np.isin(decisions.status, (Status.NOT_FINITE, Status.OUT_OF_RANGE))].tolist(),
        "noise": found,
        "detectors": detectors,
        "history": {
            "time_s": imu.time,
            "rest": masks,
            "statistic": {name: decisions.statistic_of(name) for name in d.DETECTORS},
            "specific_force": np.linalg.norm(accel, axis=1),
            "rate": np.linalg.norm(gyro, axis=1),
        },
    }


def segments(imu: Inertial, mask: Array, decided: Array) -> list[list[float]]:
    """Rests of LASTING s and more: [first, end] in s, the end being where the movement that ends it is first declared.

    A movement shorter than LASTING does not end a rest.  Before its first full window a detector says nothing: a rest
    that is declared then began with that window.
    """
    long = max(1, round(LASTING / imu.dt))
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    runs: list[list[int]] = []
    for first, end in edges.reshape(-1, 2):
        if runs and first - runs[-1][1] < long and decided[runs[-1][1] : first].all():
            runs[-1][1] = int(end)
        else:
            runs.append([int(first), int(end)])
    time = np.append(imu.time, imu.time[-1] + imu.dt)
    return [[float(time[a]), float(time[b])] for a, b in runs if b - a >= long]


# ---------------------------------------------------------------- saying it


def report(result: dict[str, Any]) -> str:
    """The result as a text for a terminal."""
    n = result["noise"]
    lines = [
        f"{result['title'] or result['recording']}: {result['samples']} samples at {result['rate_hz']:.0f} Hz, windows "
        f"of {result['window']} ({result['window_s']:.2f} s)",
        f"noise from {n['rest_s'][0]:g} to {n['rest_s'][1]:g} s: gyro {n['sigma_gyro']:.2e} rad/s, accelerometer "
        f"{n['sigma_accel']:.2e} m/s^2, gravity {n['gravity']:.4f} m/s^2; the worst second's mean strays "
        f"{n['rest_rate']:.1e} rad/s and {n['gravity_error']:.1e} m/s^2",
        f"thresholds for movement declared while resting in {result['false_alarm_rate']:g} of the windows",
        "",
        "detector            threshold          at rest   movement in the stated rest   first rest ends   rests",
    ]
    for name, of in result["detectors"].items():
        limit = "of its two" if of["threshold"] is None else f"{of['threshold']:.3e} {of['unit']}"
        end = "-" if of["first_rest_end_s"] is None else f"{of['first_rest_end_s']:.2f} s"
        alarms = "-" if of["movement_in_stated_rest"] is None else f"{100 * of['movement_in_stated_rest']:.2f} %"
        rests = len(of["segments"])
        lines.append(f"{name:<18}  {limit:<16} {100 * of['share']:7.1f} % {alarms:>25} {end:>19} {rests:>7}")
    for what, times in (("gaps", result["gaps_s"]), ("refused samples", result["refused_s"])):
        if times:
            lines.append(f"{len(times)} {what}, the first at {times[0]:.3f} s: the window begins anew")
    return "\n".join(lines)


def figures(result: dict[str, Any], sheets: Sheets) -> None:
    """Draw the signals, each statistic over its threshold, and what each detector says."""
    history = result["history"]
    t = history["time_s"]
    heights = [1, 1, 1.6, 1.2]
    with sheets(f"stationary_{result['recording']}", 9.0, 8.0, nrows=4, sharex=True, height_ratios=heights) as (
        _,
        axes,
    ):
        axes[0].plot(t, history["specific_force"], color=BLUE, lw=0.6)
        axes[0].set_ylabel("specific force\n[m/s²]")
        axes[0].set_title(result["title"] or result["recording"], loc="left")
        axes[1].plot(t, history["rate"], color=BLUE, lw=0.6)
        axes[1].set_ylabel("angular rate\n[rad/s]")
        # steps of lightness as well as of hue, for readers who see two primaries only
        colours = {"gyro_mean": "#9ecae1", "gyro_std": BLUE, "accel_mean": "#fdd0a2", "accel_std": ORANGE}
        for name in d.DETECTORS:
            ratio = history["statistic"][name] / result["detectors"][name]["threshold"]
            axes[2].semilogy(t, ratio, lw=0.8, color=colours.get(name, "black"), label=name.replace("_", " "))
        axes[2].axhline(1.0, color=GREY, lw=0.8, ls="--")
        axes[2].set_ylabel("statistic / threshold")
        axes[2].legend(loc="upper left")
        for row, name in enumerate(reversed(NAMES)):
            at = np.where(history["rest"][name], float(row), np.nan)
            colour = colours.get(name, GREY if name == KIM else "black")
            axes[3].plot(t, at, color=colour, lw=5, solid_capstyle="butt", marker="|", ms=5, mew=0.5)
        axes[3].set_yticks(range(len(NAMES)), [name.replace("_", " ") for name in reversed(NAMES)])
        axes[3].set_ylim(-0.6, len(NAMES) - 0.4)
        axes[3].set_xlim(t[0], t[-1])
        axes[3].set_title(f"declared at rest; false alarms {result['false_alarm_rate']:g} per window", loc="left")
        axes[3].set_xlabel("time [s]")
