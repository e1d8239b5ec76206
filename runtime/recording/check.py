"""What is wrong or suspicious in a recording."""

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from boresight.errors import BoresightError, did_you_mean
from boresight.runtime import frames, rotation
from boresight.runtime.array import Array
from boresight.runtime.recording import axes, causes, explain, forces, motion, patterns, tags, turns
from boresight.runtime.recording.delay import NEAR_S, attitude_steps, clocks_apart, drift
from boresight.runtime.recording.rows import alone, wild
from boresight.runtime.recording.types import Finding, Inertial, Master, Recording
from boresight.runtime.units import ARCMIN, DEG, FOOT, HOUR, UNITS
from boresight.runtime.units import STANDARD_GRAVITY as G

# Judgements that may be overruled, by name.
NAMES = {
    "gap": "more missing between samples than is bridged",
    "rate": "a rate that hardly any sensor has",
    "norm": "the mean specific force is not g",
    "down": "it points down where it must point up",
    "fast": "turns faster than anything that is meant",
    "bias": "a gyro bias beyond 1 deg/s",
    "angles": "angles out of their range",
    "place": "a latitude beyond 90 deg",
    "path": "the position is not the sum of the velocity, or goes against it",
    "gravity": "in the master's axes the specific force is not gravity",
    "turns": "the slave does not turn as its master",
    "zeros": "rows of zeros that a failed read left",
    "copies": "samples or rows that repeat the one before",
    "interpolated": "samples between which a line was drawn",
    "spikes": "single samples far off their neighbours",
    "stuck": "an axis that keeps one value while the others move",
    "saturated": "an axis that stays at the end of its range",
    "rounded": "angles of the master without their digits",
    "clock": "the clocks of slave and master are apart, or one of them steps",
    "heading": "a heading that is off, against the velocity or against the slave's turns",
    "lag": "a velocity that is older than the attitude",
    "order": "three angles that turn in another order",
    "step": "a position that steps at one instant",
    "still": "a master that never moves while its slave turns",
}


def check(recording: Recording) -> list[Finding]:
    """What is wrong or suspicious in a recording, worst first; always some notes (rates, norms, biases at rest).

    Nothing here changes or repairs the data.  An empty list of "error" findings means that a replay may begin.  What
    the recording allows by name is a warning.
    Raises BoresightError where it allows what is no name of a finding.
    """
    unknown = [name for name in recording.allow if name not in NAMES]
    if unknown:
        close = did_you_mean(unknown[0], NAMES)
        raise BoresightError(
            f"{recording.name}: allow: {unknown[0]!r} is not the name of an error{close}; there are {', '.join(NAMES)}"
        )
    out = [Finding("warning", "recording", line) for line in recording.left_out]
    out += [Finding("note", "recording", note) for note in recording.notes]
    out += _check_time("imu", recording.imu.time, gap_level="error")
    out += _check_finite("imu", gyro=recording.imu.gyro, accel=recording.imu.accel)
    out += [_zeros(where, *rows) for where, rows in recording.failed.items()]
    master = recording.master
    if master:
        out += _check_time("master", master.time, gap_level="warning")
        out += _check_finite("master", attitude=master.euler, velocity=master.v_n, position=master.position)
    for name, value in recording.reference.items():
        out += _check_finite("reference", **{name: value[None]})
    # What follows computes with the numbers, so it needs sorted times and finite values; gaps it can live with.
    parts = [recording.imu.time, recording.imu.gyro, recording.imu.accel]
    parts += [part for part in vars(master).values() if part is not None] if master else []
    times = [recording.imu.time] + ([master.time] if master else [])
    # what zeros are beside motion would be named as something else
    unread = recording.failed and "zeros" not in recording.allow
    if (
        not unread
        and all(np.isfinite(part).all() for part in parts)
        and all((np.diff(time) > 0).all() for time in times)
    ):
        if (spoilt := wild(*recording.imu.rates())).any():
            many = "1 sample is" if spoilt.sum() == 1 else f"{spoilt.sum()} samples are"
            text = f"{many} beyond any sensor's range, first row {np.argmax(spoilt)}: spoilt"
            return [*out, Finding("error", "imu", f'{text}; bad_rows = "drop" leaves them out')]
        out += patterns.of_samples(recording.imu) + patterns.coarse_gyro(recording.imu)
        still = patterns.of_master(recording.imu, master) if master else []
        out += still
        out += _check_imu(recording.imu, master)
        if master and not any(one.name == "still" for one in still):
            out += _check_master(master)
            trusted = master.position is not None and not any(one.name == "path" for one in out)
            known = "gyro_bias" in recording.reference
            pair = _check_pair(recording.imu, master, calibrated=known, trusted=trusted)
            out += _counted_from_first(master, pair) + pair
            out = sorted(out, key=lambda one: one.name == "down" or one.text.endswith(UNNAMED))  # the others say why
    out = _proposed(out, recording)
    out = [
        Finding("warning", f.where, f"{f.text} (allowed: {f.name})", f.name) if f.name in recording.allow else f
        for f in out
    ]
    out = [replace(f, name="") if f.name == "side" else f for f in out]
    return sorted(out, key=lambda finding: ("error", "warning", "note").index(finding.level))


def _proposed(findings: list[Finding], recording: Recording) -> list[Finding]:
    """The findings, with the axes beside them in which the columns would fit."""
    imu, master = recording.imu, recording.master
    names = {one.name for one in findings if one.level == "error" or one.name == "side"}
    if names & axes.NAMES and "imu" in recording.axes and not names & {"norm", "clock", "still"}:
        M = recording.axes["imu"]
        force = imu.rates()[1].mean(axis=0) @ M
        _, slave, turn = attitude_increments(imu, master) if master else (None, None, None)
        fits = axes.bodies(force, None if slave is None else slave @ M, turn)
        declared = next(name for name, one in frames.every_body().items() if np.array_equal(one, M))
        findings = axes.proposed(findings, axes.of_body(force, fits, declared), axes.NAMES)
    if "path" in names and "velocity" in recording.axes and master and master.v_n is not None:
        T = recording.axes["velocity"]
        fits = axes.orders(master, master.v_n @ T)
        declared = next(name for name, one in frames.every_order().items() if np.array_equal(one, T))
        if fits and declared not in fits and not any(f'order = "{fits[0]}"' in one.text for one in findings):
            findings = axes.proposed(findings, f'order = "{fits[0]}" beside the velocity fits', {"path"})
    return findings


def shown(recording: Recording, *, as_json: bool = False) -> int:
    """Print what `check` found; returns the exit status: 1 if something is wrong."""
    findings = check(recording)
    if as_json:
        print(json.dumps({"findings": [vars(finding) for finding in findings]}, indent=1))
    else:
        for f in findings:
            named = f"  [{f.name}]" if f.name and f.level == "error" else ""
            print(f"{f.level:<8} {f.where:<16} {f.text}{named}")
    return int(any(finding.level == "error" for finding in findings))


def _check_time(where: str, time: Array, gap_level: Literal["warning", "error"]) -> list[Finding]:
    where = f"{where}.time"
    if not np.isfinite(time).all():
        rows = np.flatnonzero(~np.isfinite(time))
        text = f'{len(rows)} tags are missing or not finite, first in row {rows[0]}; bad_rows = "drop" leaves them out'
        return [Finding("error", where, text)]
    step = np.diff(time)
    out = []
    if text := tags.disorder(time, where):
        out.append(Finding("error", where, text))
    elif text := tags.coarse(time):
        advice = 'write them in double precision, or say clock = "regular"'
        out.append(Finding("warning", where, f"the tags have lost digits: {text}; {advice}"))
    dt = float(np.median(step))
    if dt <= 0:
        return out
    gap = step > 1.5 * dt
    if gap.any():
        lost = (step.max() / dt - 1) * dt
        advice = "; cut the recording there (from, to)"
        if lost < 0.2:
            advice = (
                f'; bridge them (bridge = "{np.ceil(lost * 1e3 - 1e-6):g} ms"), or cut the recording there (from, to)'
            )
        lone = np.flatnonzero(alone(time))
        if len(lone):
            advice += f'; or, {len(lone)} tags stand off their neighbours (row {lone[0]}): bad_rows = "drop"'
        far = np.flatnonzero(step > max(0.2, 10 * dt))
        if len(far) and len(far) <= 3 and not len(lone):
            set_by = ", ".join(tags.set_by(time[k], step[k] - dt) for k in far)
            advice += f"; or, if the clock was set and nothing is missing, steps = [{set_by}] in {where}"
        # As many tags are too near as are too far: they scatter, and nothing is missing.
        scatter = np.sum(step < 0.5 * dt) > gap.sum() / 2 > 1
        if scatter:
            advice = '; the tags scatter: if the clock is regular, say so (clock = "regular")'
        gaps = "1 gap" if gap.sum() == 1 else f"{gap.sum()} gaps"
        text = f"{gaps} after {tags.listed(time[:-1][gap])}, the longest {step.max():.4f} s"
        if scatter and gap_level == "warning":
            text = f"the tags scatter by {np.std(step):.2g} s from one to the next, and none is missing: those of the"
            text, advice = f'{text} arrival?  clock = "regular" puts them on their line', ""
        out.append(Finding(gap_level, where, text + (advice if gap_level == "error" else ""), "gap"))
    jitter = float(np.std(step[(step > 0) & ~gap]))
    text = f"{1 / dt:.6g} Hz, {time[0]:.3f} s to {time[-1]:.3f} s, jitter {jitter * 1e3:.3f} ms"
    out.append(Finding("note", where, text))
    if not 0.1 <= 1 / dt <= 20000:
        out.append(Finding("error", where, f"a rate of {1 / dt:.4g} Hz: is the unit of time right?", "rate"))
    return out


def _zeros(where: str, count: int, first: int) -> Finding:
    many = "1 row is" if count == 1 else f"{count} rows are"
    text = {
        "imu": "zero: failed reads, which no sensor in gravity gives",
        "master": "at 0, 0: a receiver without a fix",
    }
    advice = 'bad_rows = "drop" leaves them out'
    return Finding("error", where, f"{many} {text[where]}, the first in row {first}; {advice}", "zeros")


def _check_finite(where: str, **parts: Array | None) -> list[Finding]:
    out = []
    for name, part in parts.items():
        if part is not None and not np.isfinite(part).all():
            rows = np.flatnonzero(~np.isfinite(part).all(axis=1))
            remedy = "bridge them, or " if where == "imu" else ""
            text = f'{len(rows)} rows are not finite, first row {rows[0]}; {remedy}bad_rows = "drop" leaves them out'
            out.append(Finding("error", f"{where}.{name}", text))
    return out


def _windows(values: Array, length: int) -> Array:
    """(K, length, 3): VALUES cut into whole windows, or one window of all."""
    length = min(length, len(values))
    count = len(values) // length
    return values[: count * length].reshape(count, length, -1)


UNNAMED = "check its unit and kind"


def _check_imu(imu: Inertial, master: Master | None) -> list[Finding]:
    gyro, f = imu.rates()
    out = []
    second = max(1, round(1 / imu.dt))
    norm = float(np.median(np.linalg.norm(_windows(f, second).mean(axis=1), axis=-1)))
    rate_hz = 1 / imu.dt
    if not 0.8 * G < norm < 1.2 * G:
        guesses = {
            "g declared as m/s^2": norm * G,
            "mg declared as m/s^2": norm * G / 1000,
            "cm/s^2 declared as m/s^2": norm / 100,
            "m/s^2 declared as g": norm / G,
            "rates declared as increments": norm / rate_hz,
            "increments declared as rates": norm * rate_hz,
        }
        if imu.kind == "increments":
            # n = 2: every other row was left out when a file was thinned
            guesses |= {f"one increment in {n} is there, and the others are lost": norm * n for n in (2, 3, 4, 5, 10)}
        fits = [guess for guess, value in guesses.items() if 0.9 * G < value < 1.1 * G]
        if 0.8 * G < float(np.median(np.linalg.norm(gyro, axis=1))) < 1.2 * G and norm < 0.3 * G:
            fits = ["the gyros show gravity: gyro and accel are exchanged"]
        mean = f.mean(axis=0)
        fits += [
            f"{name} alone in g declared as m/s^2" for i, name in enumerate(("front", "right", "down"))
            if 0.9 * G < float(np.linalg.norm(np.where(np.arange(3) == i, G, 1.0) * mean)) < 1.1 * G
        ]  # fmt: skip
        if norm < 0.1 * G and not fits:
            fits = ["gravity was taken off; describe the specific force, with gravity in it"]
        text = f"the mean specific force is {norm:.4g} m/s^2, not about {G:.2f}"
        # who turns steadily feels more than g, and its master tells
        if fits or master is None or master.v_n is None or not 0.5 * G < norm < 3 * G:
            text += f": {fits[0] if fits else UNNAMED}"
            out.append(Finding("error", "imu.accel", text, "norm"))
    down = float(np.mean(f[:, 2]))
    if 0.8 * G < norm < 1.2 * G and down > 0.5 * G:
        text = f"the mean specific force along body down is {down:+.3f} m/s^2; at rest it is -{G:.2f}"
        out.append(Finding("error", "imu.accel", text + ": check imu.body or the sign", "down"))
    side = int(np.argmax(np.abs(f.mean(axis=0))))
    if master is None and 0.8 * G < norm < 1.2 * G and side != 2:
        text = f"the mean specific force is along {frames.AXES[side]}: it lies on its side, or imu.body is another one"
        out.append(Finding("warning", "imu.accel", text, "side"))
    fastest = float(np.abs(gyro).max())
    typical = float(np.median(np.linalg.norm(gyro, axis=1)))
    if fastest > 70 or typical > 5:
        text = f"turns at {typical:.3g} rad/s (median), {fastest:.3g} (largest)"
        factor = causes.factor(imu, master) if master else 0.0
        hint = patterns.of_axes(imu.gyro) or "degrees declared as radians, or rates as increments?"
        if factor > 1.3 / DEG:
            hint = f"{factor:.4g} times what its master turns: raw counts, {factor * DEG:.4g} for each deg/s?"
        out.append(Finding("error", "imu.gyro", f"{text}: {hint}", "fast"))
    mean_f = ", ".join(f"{x:+.3f}" for x in f.mean(axis=0))
    out.append(Finding("note", "imu.accel", f"mean specific force [{mean_f}] m/s^2 (front, right, down)"))
    turn = ", ".join(f"{x:.3f}" for x in np.degrees(np.sqrt(np.mean(gyro**2, axis=0))))
    out.append(Finding("note", "imu.gyro", f"rms rate [{turn}] deg/s (front, right, down)"))
    return out + _check_rest(imu, gyro, f, second, master)


REST_GYRO = 0.5 * DEG  # rad/s, standard deviation in one second below which an IMU may be at rest


REST_ACCEL = 0.15  # m/s^2, the same


REST_SPEED = 0.3  # m/s of the master, above which nothing rests


REST_TURN = 0.3 * DEG  # rad/s of the master in the mean of one second, the same


def _check_rest(imu: Inertial, gyro: Array, f: Array, second: int, master: Master | None) -> list[Finding]:
    windows_gyro, windows_f = _windows(gyro, second), _windows(f, second)
    rest = (windows_gyro.std(axis=1) < REST_GYRO).all(axis=1) & (windows_f.std(axis=1) < REST_ACCEL).all(axis=1)
    length = windows_gyro.shape[1]
    if master is not None and len(master.time) > 1:
        # A vehicle that drives straight and evenly shakes no more than one that stands: only its master knows.
        begin = imu.time[: len(rest) * length : length]
        edges = np.stack([begin, begin + length * imu.dt])
        known = (edges[0] >= master.time[0]) & (edges[1] <= master.time[-1])
        if master.v_n is not None:
            fast = np.linalg.norm(master.v_n, axis=1) > REST_SPEED
            moving = np.concatenate([[0], np.cumsum(fast)])
            first, last = np.searchsorted(master.time, edges)
            known &= moving[np.minimum(last + 1, len(fast))] == moving[np.maximum(first - 1, 0)]
        at = np.array([[np.searchsorted(master.time, t)] for t in edges]).reshape(2, -1).clip(0, len(master.time) - 1)
        C = rotation.matrix_from_euler(master.euler)
        turn = rotation.vector_from_matrix(np.swapaxes(C[at[0]], -1, -2) @ C[at[1]])
        seconds = np.maximum(master.time[at[1]] - master.time[at[0]], length * imu.dt)
        rest &= known & (np.linalg.norm(turn, axis=-1) / seconds < REST_TURN)
    if not rest.any():
        return [Finding("note", "imu", "never at rest: no norm of gravity and no static gyro bias to be had")]
    bias = windows_gyro[rest].mean(axis=(0, 1))
    norm = float(np.linalg.norm(windows_f[rest].mean(axis=1), axis=-1).mean())
    shown = ", ".join(f"{x:+.1f}" for x in np.degrees(bias) * HOUR)
    span = rest.sum() * length * imu.dt
    text = f"quiet for {span:.4g} s: specific force {norm:.4f} m/s^2, mean rate [{shown}] deg/h"
    meaning = "static bias and Earth rate" if master is not None else "static bias and Earth rate, if it stood"
    out = [Finding("note", "imu", f"{text} ({meaning})")]
    if master is None and np.abs(bias).max() > 1 * DEG:
        text = "more than 1 deg/s while quiet: a large bias, a steady turn, or a wrong unit"
        out.append(Finding("warning", "imu.gyro", text))
    return out


def _check_master(master: Master) -> list[Finding]:
    out = []
    largest = np.abs(master.euler[:, :2]).max(axis=0)
    if largest[0] > 2 * np.pi or largest[1] > np.pi / 2 + 1e-6:
        text = f"roll to {largest[0]:.3g} and pitch to {largest[1]:.3g} rad"
        out.append(
            Finding("error", "master.attitude", text + ": degrees declared as radians, or another order?", "angles")
        )
    elif largest[1] > 80 * DEG:
        text = f"pitch to {np.degrees(largest[1]):.1f} deg: models that match Euler angles refuse 80, others fly it"
        out.append(Finding("warning", "master.attitude", text))
    turn = np.degrees(np.linalg.norm(rotation.vector_from_matrix(attitude_steps(master.euler)), axis=1))
    jump = turn > 30
    if jump.any():
        text = f"{jump.sum()} steps of more than 30 deg after {tags.listed(master.time[:-1][jump])}"
        out.append(Finding("warning", "master.attitude", text + ": too slow a rate, or a wrong unit?"))
    spans = ", ".join(
        f"{name} {lo:.2f} to {hi:.2f}"
        for name, lo, hi in zip(
            frames.ANGLES, *np.degrees([master.euler.min(axis=0), master.euler.max(axis=0)]), strict=True
        )
    )
    out.append(Finding("note", "master.attitude", f"{spans} deg"))
    if master.v_n is not None:
        speed = np.linalg.norm(master.v_n, axis=1)
        out.append(Finding("note", "master.velocity", f"speed {speed.min():.2f} to {speed.max():.2f} m/s"))
    if master.position is not None:
        latitude = np.abs(master.position[:, 0]).max()
        if latitude > np.pi / 2:
            whole = np.abs(np.degrees(master.position[:, :2]))
            hint = "degrees declared as radians, or another order of columns?"
            if 100 < whole.max() < 18060 and (whole % 100 < 60).all():
                hint = "degrees and minutes in one number, ddmm.mm as NMEA has them?"
            text = f"latitude to {latitude:.4g} rad: {hint}"
            out.append(Finding("error", "master.position", text, "place"))
        elif not master.position[:, :2].all(axis=1).any():
            text = "latitude or longitude is 0 all the time: a receiver without a fix, or an origin that nobody set?"
            out.append(Finding("warning", "master.position", text))
        elif master.v_n is not None:
            out += _check_velocity(master)
    return out


SPEEDS = {unit: size for unit, size in UNITS["velocity"].items() if unit != "m/s"} | {
    "ft/s": FOOT,
    "mph": 5280 * FOOT / 3600,
}


HEIGHTS = {  # of a height by those of the vertical velocity
    1 / FOOT: "feet declared as metres?",
    1000.0: "mm declared as m?",
    100.0: "cm declared as m?",
    0.001: "km declared as m?",
    FOOT: "a vertical velocity in ft/s declared as m/s?",
    FOOT / 60: "one in ft/min declared as m/s?",
}


def _check_velocity(master: Master) -> list[Finding]:
    """Displacement from position against the integral of velocity: tells a swapped or badly scaled axis."""
    assert master.v_n is not None and master.position is not None
    if steps := _check_steps(master):
        return steps
    lat, lon, height = master.position.T
    radius = 6371e3 + height[0]
    moved = np.array([lat[-1] - lat[0], (lon[-1] - lon[0]) * np.cos(lat[0]), 0]) * radius
    moved[2] = height[0] - height[-1]
    summed = np.sum((master.v_n[1:] + master.v_n[:-1]) / 2 * np.diff(master.time)[:, None], axis=0)
    # Climbs and descents end where they began: a wrong sign of the height shows on the way only.
    fallen = np.concatenate([[0.0], np.cumsum((master.v_n[1:, 2] + master.v_n[:-1, 2]) / 2 * np.diff(master.time))])
    fallen, sunk = fallen - fallen.mean(), height.mean() - height
    if float(np.linalg.norm(moved - summed)) > max(20.0, 0.1 * float(np.linalg.norm(moved))) and (
        cause := causes.of_velocity(master)
    ):
        return [Finding("error", "master.velocity", f"the position is the sum of the velocity where {cause}", "path")]
    if np.std(fallen) > 1.0 and np.std(sunk + fallen) < np.std(sunk - fallen) / 3:
        text = f"the height goes against the vertical velocity, which alone moves by {np.ptp(fallen):.1f} m"
        hint = ': check which of them is up and which down; order = "north east up" beside its columns says so'
        return [Finding("error", "master.position", text + hint, "path")]
    level = np.linalg.norm(moved[:2])
    if level > 20 and np.linalg.norm(np.cross(moved, summed)) < 0.05 * np.linalg.norm(moved) * np.linalg.norm(summed):
        ratio = float(summed[:2] @ moved[:2] / level**2)
        if not 0.9 < ratio < 1.1:
            what = next(
                (f": {unit} declared as m/s?" for unit, size in SPEEDS.items() if abs(ratio * size - 1) < 0.05), ""
            )
            where, text = "master.velocity", f"the velocity sums to {ratio:.3g} times what the position moves"
            if abs(0.6 * ratio - 1) < 0.02:
                where, what = "master.position", ": degrees and minutes (dd.mmmm of ddmm.mm) declared as degrees?"
            return [Finding("error", where, text + (what or ": check its unit"), "path")]
    if np.std(fallen) > 1.0 and np.std(sunk) > 0:
        slope, fit = float(sunk @ fallen / (fallen @ fallen)), float(np.corrcoef(sunk, fallen)[0, 1])
        # a master at 1 Hz may see of a walker's steps what sums up, while its height stays
        if fit > 0.95 and not 0.7 < slope < 1.4 and (np.std(sunk) > 0.5 or abs(slope * 1e3 - 1) < 0.1):
            what = next(
                (f": {text}" for size, text in HEIGHTS.items() if abs(slope / size - 1) < 0.1), ": check its unit"
            )
            text = f"the height moves {slope:.3g} times as much as the vertical velocity sums to"
            return [Finding("error", "master.position", text + what, "path")]
    if not master.v_n[:, 2].any() and np.ptp(height) > 1:
        text = f"its vertical part is 0 all the time, and the height moves by {np.ptp(height):.1f} m: speed and course"
        return [Finding("warning", "master.velocity", f"{text} alone?")]
    if vertical := motion.check_vertical(master):
        return vertical
    path = float(np.linalg.norm(moved))
    if path < 20:
        return motion.check_place(master)
    if turned := causes.of_track(master):
        return [Finding("error", "master.velocity", f"{turned}, or other axes?", "path")]
    # A sphere in place of the ellipsoid is wrong by half a percent; 10 % is a wrong unit or a swapped axis.
    if float(np.linalg.norm(moved - summed)) > max(20.0, 0.1 * path):  # positions wander by metres themselves
        shown = ["[{:.0f}, {:.0f}, {:.0f}]".format(*v) for v in (moved, summed)]
        text = f"position moved {shown[0]} m (north, east, down), velocity sums to {shown[1]}"
        return [
            Finding("error", "master.velocity", text + ": check navigation, the order of columns and the units", "path")
        ]
    return motion.check_place(master)


def _check_steps(master: Master) -> list[Finding]:
    """A position or a clock that steps at one instant, or at a few: by what the velocity does not explain."""
    assert master.v_n is not None and master.position is not None
    lat, lon, height = master.position.T
    place = np.column_stack([lat, lon * np.cos(lat[0]), np.zeros_like(lat)]) * (6371e3 + height[0])
    place[:, 2] = -height
    moved, dt = np.diff(place, axis=0), np.diff(master.time)
    v = (master.v_n[1:] + master.v_n[:-1]) / 2
    usual = float(np.median(dt))
    left = moved - v * dt[:, None]
    scale = 1.5 * np.median(np.abs(left - np.median(left, axis=0)), axis=0)
    bad = (np.abs(left) > np.maximum(10.0, 12 * scale)).any(axis=1)
    if not bad.any() or bad.sum() > 3:
        return []
    k = int(np.argmax(bad))
    # as if one interval had passed, by its clock many
    if dt[k] > 3 * usual and np.linalg.norm(moved[k] - v[k] * usual) < 0.2 * np.linalg.norm(left[k]):
        text = (
            f"the master's clock steps by {dt[k] - usual:+.3f} s at {master.time[k]:.3f} s{tags.apart(dt[k] - usual)}"
        )
        steps = tags.set_by(float(master.time[k]), float(dt[k] - usual))
        text += (
            f", while the position goes on; steps = [{steps}] in master.time takes it off, or cut it there (from, to)"
        )
        return [Finding("error", "master.time", text, "clock")]
    if dt[k] > 3 * usual:
        return []
    text = "it steps by [{:.1f}, {:.1f}, {:.1f}] m (north, east, down)".format(*left[k])
    hint = ": another height, of the geoid for that of the ellipsoid?" if np.abs(left[k, :2]).max() < 3 else ""
    text = (
        f"{text} at {master.time[k + 1]:.3f} s and {bad.sum() - 1} times more{hint}; cut the recording there (from, to)"
    )
    return [Finding("error", "master.position", text, "step")]


def attitude_increments(imu: Inertial, master: Master) -> tuple[Array, Array, Array]:
    """The slave's turns and the master's over the same intervals, for as long as both run.

    Returns dt (K,) s, slave (K, 3) rad (gyro, so relative to inertial space) and master (K, 3) rad (relative to the
    Earth; 15 deg/h do not matter here), rotation vectors in FRD.  Intervals that the slave does not cover are left out.
    """
    return _increments(imu, master)[:3]


def _increments(imu: Inertial, master: Master) -> tuple[Array, Array, Array, Array]:
    """The same, and the numbers of the master's intervals (K,)."""
    dts, slave, kept = [], [], []
    for k, (t0, t1) in enumerate(zip(master.time[:-1], master.time[1:], strict=True)):
        try:
            _, dtheta = imu.between(t0, t1)
        except BoresightError:
            continue
        dts.append(t1 - t0)
        slave.append(dtheta)
        kept.append(k)
    turns = rotation.vector_from_matrix(attitude_steps(master.euler))
    return np.array(dts), whole_turns(slave), turns[kept], np.array(kept, int)


def whole_turns(pieces: Sequence[Array]) -> Array:
    """(K, 3) each turn as one rotation vector, from its pieces (J, 3) rad one after the other; J may differ."""
    steps = np.zeros((len(pieces), max((len(piece) for piece in pieces), default=0), 3))
    for step, piece in zip(steps, pieces, strict=True):
        step[: len(piece)] = piece
    C = np.tile(np.eye(3), (len(pieces), 1, 1))
    for j in range(steps.shape[1]):
        C = C @ rotation.matrix_from_vector(steps[:, j])
    return rotation.vector_from_matrix(C) if len(pieces) else np.zeros((0, 3))


def _check_pair(imu: Inertial, master: Master, *, calibrated: bool, trusted: bool) -> list[Finding]:
    """The slave's turns against the master's, axis by axis: the test that sees every wrong sign, unit and axis."""
    start, end = imu.intervals()
    common = min(end[-1], master.time[-1]) - max(start[0], master.time[0])
    if common <= 0:
        spans = f"{master.time[0]:.3f} to {master.time[-1]:.3f} s, imu {start[0]:.3f} to {end[-1]:.3f} s"
        off = master.time[0] - start[0]
        known = f": {tags.shift(off)}" if tags.apart(off) else " (shift in master.time)"
        text = f"master {spans}: no overlap, {off:+.3f} s apart{tags.apart(off)}; bring both to one clock{known}"
        return [Finding("error", "master.time", text)]
    out, delay = _check_clocks(imu, master)
    if any(one.level == "error" for one in out):
        return out  # whatever else is off follows from it
    master = replace(master, time=master.time - delay)
    if master.v_n is not None and (short := _check_cover(imu, master)):
        return short + out
    gravity = [] if master.v_n is None else _check_gravity(imu, master)
    dt, slave, turn, kept = _increments(imu, master)
    if len(turn) < 10:
        return gravity
    out += motion.check_jumps(master.time + delay, slave, turn, kept)
    if any(one.level == "error" for one in out):
        return out + gravity
    if course := motion.check_course(master, slave, turn, kept):
        return course + out + gravity
    surplus, steady = (slave - turn).sum(axis=0) / dt.sum(), turn.sum(axis=0) / dt.sum()
    slave, turn = slave - slave.mean(axis=0), turn - turn.mean(axis=0)
    for axis, name in enumerate(("front", "right", "down")):
        # 0.02 deg between samples: less motion than this is noise, and its slope says nothing.
        if float(turn[:, axis] @ turn[:, axis]) < len(turn) * (0.02 * DEG) ** 2:
            continue
        found = slope_of(turn[:, axis], slave[:, axis])
        text = f"turns about {name}: slave over master {found.slope:.4g} +- {found.sigma:.2g}"
        text += f", correlation {found.correlation:.4f}"
        if found.noise > 0:
            text += f", the master's attitude noise {found.noise / ARCMIN:.2g} arcmin taken off"
        low, high, least = found.slope - 3 * found.sigma, found.slope + 3 * found.sigma, 3 * found.spread
        if not np.isfinite(found.slope) or found.sigma > 0.3 * max(1.0, abs(found.slope)):
            text = f"turns about {name}: it moves too little beside the noise to be judged"
            out.append(Finding("note", "imu.gyro", text))
            continue
        wrong = high < 0.8 or low > 1.25 or found.correlation + least < 0.8
        if wrong and (white_differences(turn[:, axis]) or mounting_explains(turn[:, axis], slave, axis)):
            text = f"turns about {name}: it moves too little beside the noise and the mounting to be judged"
            out.append(Finding("note", "imu.gyro", text))
            continue
        factor = explain.known(found.slope, turns.FACTORS)
        hint = (
            (f"; check its unit{factor}" if factor else "; check unit, kind, body axes and the sign of yaw")
            if wrong
            else ""
        )
        out.append(Finding("error" if wrong else "note", "imu.gyro", text + hint, "turns" if wrong else ""))
    biased = np.abs(beyond_mounting(surplus, steady)).max() > 1 * DEG
    if biased and not calibrated and not any(one.name == "turns" for one in out):
        shown = ", ".join(f"{x:+.3f}" for x in np.degrees(surplus))
        text = f"it turns by [{shown}] deg/s (front, right, down) more than its master"
        text += ": models take a gyro bias of up to 1 deg/s; take what is known of it off first, as [calibration] "
        text += "gyro_bias in the axes of imu.body"
        out.append(Finding("error", "imu.gyro", text, "bias"))
    beside = any(one.level == "error" and one.name == "turns" for one in out)
    wrong = beside or any(one.level == "error" for one in out)
    cause = _of_turns(imu, master, delay, wrong)
    blamed = any(one.level == "error" for one in cause)
    felt = [] if master.v_n is None or blamed else _of_forces(imu, master, gravity, trusted)
    if beside and not cause:  # what spoilt the attitude may show in the forces
        text = (
            f"{UNKNOWN} explains how the slave turns beside its master: several at once, or a master of another drive?"
        )
        spoilt = [one for one in felt if one.where == "master.attitude"]
        cause = spoilt or [Finding("error", "imu.gyro", text, "turns")]
    if wrong or blamed:
        return cause + out + gravity
    if any(one.level == "error" for one in felt):
        return felt + gravity + cause + out
    off = motion.check_heading(imu, master, slave, turn, delay)
    if any(one.level == "error" and one.name == "heading" for one in off):
        return cause + off + out  # the force in the master's axes is turned with it
    return cause + off + felt + gravity + out


def _counted_from_first(master: Master, found: list[Finding]) -> list[Finding]:
    """What explains errors of axes where the first attitude is zero, or right angles by the change of axes."""
    first = np.abs(np.degrees(master.euler[0]))
    zero = (
        np.abs(np.append(first[:2], (first[2] + 45) % 90 - 45)).max() < 1e-6 and np.ptp(master.euler[:9], axis=0).any()
    )
    if not zero or not {"heading", "gravity", "turns"} & {one.name for one in found if one.level == "error"}:
        return []
    text = (
        "its first row is 0, 0, 0, and what follows does not fit: angles counted from the first row (tared); it takes"
    )
    return [Finding("error", "master.attitude", text + " roll and pitch from gravity, heading from north", "heading")]


UNKNOWN = "none of the single mistakes that are tried (axes, signs, units, order of angles, delays, filters, clocks)"


def _of_turns(imu: Inertial, master: Master, delay: float, wrong: bool) -> list[Finding]:
    """The single mistake that explains how the slave turns otherwise than its master, or two that do, or none.

    wrong: whether one axis is, by itself.  delay: s, that was taken off the master's tags.
    """
    if wrong and (text := patterns.of_axes(imu.gyro)):
        return [Finding("error", "imu.gyro", text, "turns")]
    guesses = turns.of_turns(imu, master, delay)
    _, found = explain.decided(*guesses) if guesses else (None, [])
    if found and found[0].text:
        best = found[0].guess
        mild = best.kind in turns.MILD and not wrong
        more = motion.counted_from_east(master) if "yaw_positive" in found[0].text else ""
        text = explain.in_words(found, more)
        return [Finding("warning" if mild else "error", best.where, text, turns.NAME.get(best.kind, "turns"))]
    return []


def _of_forces(imu: Inertial, master: Master, gravity: list[Finding], trusted: bool) -> list[Finding]:
    """The same of the specific force, of a slave that turns as its master does."""
    wrong = any(one.level == "error" for one in gravity)
    if not (guesses := forces.of_forces(imu, master, trusted)):
        return []
    as_is, found = explain.decided(*guesses, wrong)
    named = found if all(one.text for one in found) else []
    if not named:
        return []
    text = explain.in_words(named)
    level: Literal["warning", "error"] = "error" if wrong or as_is.left > LARGE_FORCE**2 else "warning"
    return [Finding(level, named[0].guess.where, text, "gravity")]


LARGE_FORCE = 0.1  # m/s^2 rms, that no sound recording has in means over a second


def _check_clocks(imu: Inertial, master: Master) -> tuple[list[Finding], float]:
    """Clocks that are apart by more than a filter's delay may be, or run apart; and by how much they are, s."""
    delay, gain = clocks_apart(imu, master)
    if abs(delay) > 0.5:  # a motion that repeats itself fits a round later as well
        far = replace(master, time=master.time - delay)
        delay, gain = (delay, gain) if turns.near(imu, far) < turns.near(imu, master) / 4 else (0.0, 1.0)
    near = gain == 1
    shift, better, filtered = turns.late(imu, master, delay)
    if near and better > 1 and not filtered:
        delay, gain = shift, better if abs(shift) > NEAR_S else 1
    elif better > 1 and filtered:
        others = f"; or, as well explained, the master's clock is {shift:+.3f} s late" if shift else ""
        return [Finding("error", "imu.gyro", filtered[0] + others, "lag")], 0.0
    if gain > 1:
        text = (
            f"the clocks are apart: the master is {delay:+.3f} s late{tags.apart(delay)}; with that taken off its time,"
        )
        text += f" the turns fit {gain:.3g} times better"
        if abs(delay) > 0.5:
            return [Finding("error", "master.time", f"{text}: {tags.shift(delay)}", "clock")], delay
        return [Finding("warning", "master.time", f"{text}; or replay with --delay-ms {delay * 1e3:.0f}")], delay
    slope, sigma, seconds = drift(imu, master)
    if abs(slope) > 8 * sigma and abs(slope) * seconds > 5e-3:
        text = f"the clocks run apart by {slope * 1e6:.0f} +- {sigma * 1e6:.0f} ppm, {slope * seconds * 1e3:+.1f} ms"
        return [Finding("warning", "master.time", text + ": a delay that walks (--delay-noise) may follow it")], delay
    return [], delay


@dataclass(frozen=True)
class Slope:
    """Of what two series show without their noise: slope, correlation, and one sigma of each that noise explains.

    noise: of the attitude behind the regressor, in its unit.  All nan where there is more noise than motion.
    """

    slope: float
    correlation: float
    sigma: float
    spread: float
    noise: float


def slope_of(x: Array, y: Array) -> Slope:
    """Slope of y, increments of a gyro, over x, increments of an attitude, (N,), with noise in both.

    White noise s of an attitude is 2 s^2 in the variance of its increments, which a plain slope takes for motion and so
    is too small.  It differs from a gyro's white noise (variance q) in what differences of y - slope x show, while
    these take out the motion: var(first differences) = 6 s^2 + 2 q, var(second) = 20 s^2 + 6 q.
    """
    both = np.stack([x, y])
    moments = [part @ part.T / part.shape[1] for part in (both, np.diff(both, 1), np.diff(both, 2))]
    (sxx, sxy), (_, syy) = moments[0]
    slope = sxy / sxx
    for _ in range(50):
        w = np.array([-slope, 1.0])
        d1, d2 = w @ moments[1] @ w, w @ moments[2] @ w
        s2 = max(0.0, (d2 - 3 * d1) / 2)
        # No more than what the attitude's own differences hold, by three sigmas of these.
        most = moments[2][0, 0] / 20 * (1 + 3 * np.sqrt(4.6 / len(x)))
        vx = 2 * min(s2 / max(slope**2, 1e-12), most)
        vy = max(0.0, min((d1 - 6 * s2) / 2, moments[1][1, 1] / 2))
        if vx > 0.9 * sxx or vy > 0.9 * syy:
            return Slope(*[np.nan] * 5)
        slope = sxy / (sxx - vx)
    moved, turned = sxx - vx, syy - vy
    # Of the regression, and of s^2, which (d2 - 3 d1) / 2 of Gaussian noise knows to 3.7 s^2 / sqrt(N).
    sigma = np.hypot(np.sqrt((vy + slope**2 * vx) * sxx), 3.7 * slope * vx) / moved / np.sqrt(len(x))
    correlation = float(np.clip(sxy / np.sqrt(moved * turned), -1, 1))
    return Slope(
        float(slope), correlation, float(sigma), float(sigma * np.sqrt(moved / turned)), float(np.sqrt(vx / 2))
    )


def mounting_explains(x: Array, slave: Array, axis: int) -> bool:
    """Whether x (N,), the master's turns about an axis, are the slave's (N, 3), turned a little, and noise.

    The gyros are the cleaner ones: by them x must have a slope of 1 within three sigmas and one of a mounting's angle
    at most about the other axes.  What is left must be small, or a difference of the white noise of an attitude, whose
    neighbours correlate by -1/2.
    """
    found, *_ = np.linalg.lstsq(slave, x, rcond=None)
    left = x - slave @ found
    size = float(left @ left)
    sigma = np.sqrt(np.diagonal(np.linalg.pinv(slave.T @ slave)) * size / len(left))
    off = np.abs(found - np.eye(3)[axis]) > np.where(np.arange(3) == axis, 0.2, 0.15) + 3 * sigma
    return not off.any() and (white_differences(left) or size < 0.1 * float(x @ x))


def white_differences(x: Array) -> bool:
    """Whether x (N,) is what white noise of an attitude makes of turns: neighbours correlate by -1/2, others not."""
    once, twice = (float(x[k:] @ x[:-k]) / float(x @ x) for k in (1, 2))
    return abs(once + 0.5) < 4 * np.sqrt(0.5 / len(x)) and abs(twice) < 4 * np.sqrt(1.5 / len(x))


MOUNTED = 5 * DEG  # a mounting that is no fault


def beyond_mounting(surplus: Array, turning: Array) -> Array:
    """(3,) rad/s by which the slave turns more than its master, less what a mounting makes of a steady turn (3,)."""
    about = turning / max(float(np.linalg.norm(turning)), 1e-300)
    across = surplus - (surplus @ about) * about
    size = float(np.linalg.norm(across))
    explained = min(1.0, MOUNTED * float(np.linalg.norm(turning)) / max(size, 1e-300))
    out: Array = surplus - explained * across
    return out


def gravity_in_ned(imu: Inertial, master: Master) -> Array:
    """(3,) m/s^2: the slave's specific force in the master's NED, averaged, less the master's mean acceleration.

    It is [0, 0, -g] but for accelerometer bias, Coriolis acceleration and misalignment, whatever the vehicle does.
    """
    assert master.v_n is not None
    start, end, _, dvel = imu.increments
    inside = (start >= master.time[0]) & (end <= master.time[-1])
    middle = ((start + end) / 2)[inside]
    C = rotation.matrix_from_euler(
        np.stack([np.interp(middle, master.time, a) for a in np.unwrap(master.euler, axis=0).T], axis=-1)
    )
    span = (end - start)[inside].sum()
    v = [np.array([np.interp(t, master.time, c) for c in master.v_n.T]) for t in (start[inside][0], end[inside][-1])]
    force: Array = np.einsum("kij,kj->i", C, dvel[inside]) / span - (v[1] - v[0]) / (end[inside][-1] - start[inside][0])
    return force


def _check_cover(imu: Inertial, master: Master) -> list[Finding]:
    """Increments that cover a part of the time between their tags alone, by what they have of gravity."""
    share = -float(gravity_in_ned(imu, master)[2]) / G if imu.kind == "increments" else 1.0
    if not 0.5 < share < 0.95:
        return []
    text = f"increments have {share:.1%} of gravity: do they cover less than the time between their tags?  interval ="
    return [Finding("error", "imu", text + " { columns = ..., unit = ... } in imu says what each covers", "gravity")]


def _check_gravity(imu: Inertial, master: Master) -> list[Finding]:
    force = gravity_in_ned(imu, master)
    # a slave that is mounted 5 degrees nose down has 0.09 g of it level
    wrong = np.hypot(*force[:2]) > 0.1 * G or abs(force[2] + G) > 0.05 * G
    text = "specific force less acceleration [{:+.3f}, {:+.3f}, {:+.3f}] m/s^2 (north, east, down)".format(*force)
    hint = f", not about [0, 0, -{G:.2f}]: check axes, signs and units of accel, attitude and velocity" if wrong else ""
    return [Finding("error" if wrong else "note", "imu.accel", text + hint, "gravity" if wrong else "")]
