"""False alarms and misses of the detectors by a recording in which somebody labelled rest and motion.

python tests/studies/labelled_rest.py FOLDER [FIGURE.png] prints the table of docs/stationary-detectors.md and draws its
figure.  FOLDER holds a trial of BROAD (Laidig, Caruso, Cereatti and Seel, Data 2021, 6, 72; CC BY 4.0) and
broad_trials.json.  Beside ours stand the three detectors of OpenShoe, written here from their formulas: Skog, Nilsson
and Haendel, Evaluation of zero-velocity detectors for foot-mounted inertial navigation systems, IPIN 2010.
"""

import json
import sys
from pathlib import Path

import numpy as np
from scipy.io import loadmat
from scipy.stats import chi2

from boresight.runtime import detector as d
from boresight.runtime.recording import Inertial
from boresight.runtime.status import Status
from boresight.studies.replays import stationary

TRIAL = "broad_14_slow_translation_with_breaks_B.mat"
STATED_S = 20.0  # of the first rest: noise and offsets are from there, and nothing that is counted
NEAR_S = 1.0
OPENSHOE = ("angular rate energy", "acceleration moving variance", "SHOE")


def labelled(folder):
    """imu, movement (K,) bool, and what the table of trials says of it."""
    held = loadmat(Path(folder) / TRIAL)
    rate = float(held["sampling_rate"].squeeze())
    trial = TRIAL.removeprefix("broad_").removesuffix(".mat").replace("_", "_undisturbed_", 1)
    about = json.loads((Path(folder) / "broad_trials.json").read_text())["trials"][trial]["description"]
    time = np.arange(len(held["imu_gyr"])) / rate
    imu = Inertial("rates", "end", time, held["imu_gyr"], held["imu_acc"])
    return imu, held["movement"].ravel() != 0, about


def windows(values, N):
    """(K, N, 3), the window that ends with each sample; the first N - 1 are not full."""
    return np.lib.stride_tricks.sliding_window_view(values, N, axis=0).swapaxes(-1, -2)


def openshoe(gyro, accel, N, sigma_accel, sigma_gyro, gravity):
    """(K, 3) the statistics of OPENSHOE at the last sample of each window; nan where it is not full."""
    out = np.full((len(gyro), 3), np.nan)
    w, f = windows(gyro, N), windows(accel, N)
    mean = f.mean(axis=1, keepdims=True)
    up = mean / np.linalg.norm(mean, axis=-1, keepdims=True)
    turned = (w**2).sum(-1) / sigma_gyro**2
    out[N - 1 :, 0] = turned.mean(axis=1)
    out[N - 1 :, 1] = (((f - mean) ** 2).sum(-1) / sigma_accel**2).mean(axis=1)
    out[N - 1 :, 2] = (((f - gravity * up) ** 2).sum(-1) / sigma_accel**2 + turned).mean(axis=1)
    return out


def openshoe_thresholds(N, rate):
    """Of white noise: N times the statistic is chi-square, with two angles of gravity fitted in the third."""
    return [chi2.isf(rate, freedom) / N for freedom in (3 * N, 3 * (N - 1), 6 * N - 2)]


def counted(imu, movement, rest, N):
    """Shares of false alarms and of misses, of windows of one label alone, and how late a movement is declared, s.

    Of the false alarms also the share of windows that are further than NEAR_S from labelled motion.
    """
    whole = windows(np.repeat(movement[:, None], 3, axis=1), N)[..., 0]
    resting, moving = (np.append(np.zeros(N - 1, bool), part) for part in (~whole.any(1), whole.all(1)))
    resting &= imu.time > STATED_S
    edges = imu.time[np.flatnonzero(np.diff(movement.astype(int)))]
    far = resting & (np.abs(imu.time[:, None] - edges).min(axis=1) > NEAR_S + N * imu.dt)
    begins = np.flatnonzero(np.diff(movement.astype(int)) > 0) + 1
    late = [float(np.argmax(~rest[k:]) * imu.dt) for k in begins]
    return {
        "false alarms": float((~rest[resting]).mean()), "far off": float((~rest[far]).mean()),
        "misses": float(rest[moving].mean()), "late_s": late,
        "windows at rest": int(resting.sum()), "windows in motion": int(moving.sum()),
    }  # fmt: skip


def decided(imu, N, rate):
    """Of each detector the mask of rest (K,) and statistic over threshold (K,); and the noise of the stated rest."""
    noise = stationary.noise(imu, (0.0, STATED_S))
    gyro, accel = imu.gyro - noise["gyro_bias"], imu.accel
    settings = d.settings(N, noise["sigma_accel"], noise["sigma_gyro"], rate,
                          **{key: noise[key] for key in ("gravity", "rest_rate", "gravity_error")})  # fmt: skip
    found = d.evaluate(settings, gyro, accel)
    ratios = {name: found.statistic_of(name) / settings.threshold[name] for name in d.DETECTORS}
    theirs = openshoe(gyro, accel, N, noise["sigma_accel"], noise["sigma_gyro"], noise["gravity"])
    ratios |= {name: theirs[:, i] / limit
               for i, (name, limit) in enumerate(zip(OPENSHOE, openshoe_thresholds(N, rate), strict=True))}  # fmt: skip
    full = found.status == Status.OK
    return {name: (full & (ratio < 1), ratio) for name, ratio in ratios.items()}, noise


def table(folder, sizes=(10, 50), rates=(1e-2, 1e-3)):
    """{(N, rate): {detector: counted}}."""
    imu, movement, _ = labelled(folder)
    return {
        (N, rate): {name: counted(imu, movement, rest, N) for name, (rest, _) in decided(imu, N, rate)[0].items()}
        for N in sizes
        for rate in rates
    }


def draw(folder, path, N=50, rate=1e-3):
    """What each detector declares, under the label."""
    from boresight.analysis.figures import BLUE, GREY, ORANGE, figure

    imu, movement, _ = labelled(folder)
    found, _ = decided(imu, N, rate)
    with figure(Path(path), 9.0, 5.2, made_from="labelled_rest.py", nrows=2, sharex=True, height_ratios=[1, 1.3]) as (
        _,
        axes,
    ):
        for name, colour in (("accel_mean", GREY), ("angular rate energy", ORANGE), ("likelihood_ratio", BLUE)):
            axes[0].semilogy(imu.time, found[name][1], lw=0.5, color=colour, label=name.replace("_", " "))
        axes[0].axhline(1, color="black", lw=0.8, ls="--")
        axes[0].set_ylabel("statistic / threshold")
        axes[0].legend(loc="lower left", ncols=3)
        rows = ["label", *d.DETECTORS, *OPENSHOE]
        for row, name in enumerate(reversed(rows)):
            rest = ~movement if name == "label" else found[name][0]
            colour = "black" if name == "label" else ORANGE if name in OPENSHOE else BLUE
            axes[1].plot(imu.time, np.where(rest, float(row), np.nan), color=colour, lw=5, solid_capstyle="butt")
        axes[1].set_yticks(range(len(rows)), [name.replace("_", " ") for name in reversed(rows)])
        axes[1].set_ylim(-0.6, len(rows) - 0.4)
        axes[1].set_xlim(imu.time[0], imu.time[-1])
        axes[1].set_title(f"at rest: by the label, and declared; N = {N}, false alarms {rate:g}", loc="left")
        axes[1].set_xlabel("time [s]")


def rows(folder, N, rates=(1e-2, 1e-3)):
    """The lines of the table: false alarms, those far from motion, misses, by rate, and how late the latest is."""
    found = table(folder, (N,), rates)
    for name in (*d.DETECTORS, *OPENSHOE):
        each = [found[N, rate][name] for rate in rates]
        cells = [f"{100 * one[part]:.2f}" for one in each for part in ("false alarms", "far off", "misses")]
        label = f"`{name}`" if name in d.DETECTORS else name
        yield f"| {label} | {' | '.join(cells)} | {max(each[-1]['late_s']):.2f} |"


if __name__ == "__main__":
    imu, movement, about = labelled(sys.argv[1])
    _, noise = decided(imu, 50, 1e-3)
    print(f"{about}; {imu.time[-1]:.0f} s, {movement.mean():.0%} in motion")
    print(f"sigmas {noise['sigma_gyro']:.2e} rad/s and {noise['sigma_accel']:.2e} m/s^2")
    for N in (10, 50):
        print(f"N = {N}, of {counted(imu, movement, ~movement, N)}", *rows(sys.argv[1], N), sep="\n")
    if len(sys.argv) > 2:
        draw(sys.argv[1], sys.argv[2])
