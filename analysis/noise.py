"""The noise of an inertial unit, from a log at rest: what a filter is given, with intervals and where each was read.

A datasheet's line is read by `datasheet`; noises of a flight are found by `likeliest`.  How the fit is made: `allan`.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.allan import FLOOR, TERMS, UNFIT, Fit, fitted
from boresight.analysis.datasheet import datasheet
from boresight.analysis.figures import AXES as COLOURS
from boresight.analysis.figures import figure
from boresight.analysis.likelihood import likeliest
from boresight.runtime.array import Array
from boresight.runtime.recording.types import Finding, Recording
from boresight.runtime.units import DEG, HOUR, MILLI_G, UNITS, quantity

__all__ = ["Identified", "datasheet", "fitted", "gauss_markov", "identify", "likeliest"]

AXES = ("front", "right", "down")
SHORTEST_S = 60.0
TOGETHER = 0.88  # a correlation that fifteen pairs of fifteen independent changes have once in 10 000 logs


@dataclass(frozen=True)
class Sensor:
    """The words and units of one kind."""

    name: str
    walk: str  # what its random walk is called
    units: tuple[tuple[str, float], ...]  # of TERMS, each with its factor to SI
    shown: tuple[str, float]  # of the deviation, in a figure
    noise: tuple[str, str]  # kind of UNITS and the unit of a description
    constants: tuple[str, str]  # units of a model's noise and of its bias's


GYRO = Sensor(
    "gyro", "angle random walk",
    (
        ("arcsec", UNITS["angle"]["arcsec"]), ("deg/sqrt(h)", UNITS["gyro noise"]["deg/sqrt(h)"]),
        ("deg/h", UNITS["angular rate"]["deg/h"]), ("deg/h/sqrt(h)", UNITS["gyro bias walk"]["deg/h/sqrt(h)"]),
        ("deg/h/h", UNITS["angular rate"]["deg/h"] / HOUR),
    ),
    ("deg/h", UNITS["angular rate"]["deg/h"]), ("gyro noise", "deg/sqrt(h)"), ("rad/sqrt(s)", "rad/s/sqrt(s)"),
)  # fmt: skip
ACCEL = Sensor(
    "accel", "velocity random walk",
    (
        ("mm/s", UNITS["velocity"]["mm/s"]), ("ug/sqrt(Hz)", UNITS["accelerometer noise"]["ug/sqrt(Hz)"]),
        ("ug", UNITS["acceleration"]["ug"]), ("ug/sqrt(h)", UNITS["accelerometer bias walk"]["ug/sqrt(h)"]),
        ("ug/h", UNITS["acceleration"]["ug"] / HOUR),
    ),
    ("ug", UNITS["acceleration"]["ug"]), ("accelerometer noise", "ug/sqrt(Hz)"), ("m/s/sqrt(s)", "m/s^2/sqrt(s)"),
)  # fmt: skip


def gauss_markov(tau: Array, sigma: Any, correlation_s: Any) -> Array:
    """(..., K) Allan variance of a first-order Gauss-Markov process of steady sigma, averaged over tau (K,) s."""
    x = tau / correlation_s
    out: Array = 2 * sigma**2 / x * (1 - (3 - 4 * np.exp(-x) + np.exp(-2 * x)) / (2 * x))
    return out


# ---------------------------------------------------------------- whether a log is one of noise


def faults(name: str, rates: Array, dt: float) -> list[Finding]:
    """What makes the samples (N, 3) of a sensor something else than its noise at rest, each in one line."""
    at = f"imu.{name}"
    out = []
    for values, axis in zip(rates.T, AXES, strict=True):
        white = float(np.std(np.diff(values))) / np.sqrt(2)
        levels, counts = np.unique(values, return_counts=True)
        step = float(np.diff(levels).min()) if len(levels) > 1 else np.inf
        if len(levels) < 3 or (step > 2 * white and len(levels) < len(values) / 20):
            text = f"{axis}: quantised: {len(levels)} different numbers, and a step above the noise; log finer ones"
            out.append(Finding("error", at, text, "quantised"))
            continue
        ends = [(levels[end], counts[end], counts[beside]) for end, beside in ((0, 1), (-1, -2))]
        for level, most, next_to_it in ends:
            if most >= 5 and most > 3 * next_to_it:
                text = f"{axis}: clipped: {most} samples are {level:.4g}, and none beyond; widen the range"
                out.append(Finding("error", at, text, "clipped"))
    return out or _moving(name, rates, dt) or _shaken(name, rates, dt)


def _moving(name: str, rates: Array, dt: float) -> list[Finding]:
    """Seconds that are livelier than the others, or whose mean is elsewhere."""
    at, length = f"imu.{name}", max(10, round(1 / dt))
    count = len(rates) // length
    windows = rates[: count * length].reshape(count, length, 3)
    spread, mean = windows.std(axis=1), windows.mean(axis=1)
    usual = np.median(spread, axis=0)
    livelier = (spread / np.where(usual > 0, usual, np.inf)).max(axis=1)
    limit = 1 + max(1.0, 7 / np.sqrt(2 * length))  # beyond what a million windows of white noise show
    if (livelier > limit).any():
        first = int(np.argmax(livelier > limit))
        text = f"not static: at {first * length * dt:.0f} s it shakes {livelier[first]:.1f} times as much as usual"
        text += f", and in {np.sum(livelier > limit)} of {count} windows; cut the log (--from, --to)"
        return [Finding("error", at, text, "static")]
    allowed, unit, factor = (0.5 * DEG, "deg/s", DEG) if name == "gyro" else (20 * MILLI_G, "mg", MILLI_G)
    ten = max(1, round(10 / (length * dt)))
    blocks = mean[: count // ten * ten].reshape(-1, ten, 3).mean(axis=1) if count >= ten else mean
    off = np.ptp(blocks, axis=0) - 10 * usual / np.sqrt(length * ten)
    if (off > allowed).any():
        axis = int(off.argmax())
        begin = (int(np.abs(np.diff(blocks[:, axis])).argmax()) + 1) * ten * length * dt
        text = f"not static: {AXES[axis]}: at {begin:.0f} s its mean changes, by {np.ptp(blocks[:, axis]) / factor:.3g}"
        return [Finding("error", at, f"{text} {unit} in all; cut the log (--from, --to)", "static")]
    return []


def _shaken(name: str, rates: Array, dt: float) -> list[Finding]:
    """A line in the spectrum: a vibration, or a swing."""
    length = 2 ** int(np.log2(len(rates) // 8))
    parts = rates[: len(rates) // length * length].reshape(-1, length, 3)
    window = np.hanning(length)[:, None]
    power = (np.abs(np.fft.rfft((parts - parts.mean(axis=1, keepdims=True)) * window, axis=1)) ** 2).mean(axis=0)
    beside = np.stack([np.roll(power, shift, axis=0) for shift in (-9, -8, -7, -6, -5, 5, 6, 7, 8, 9)])
    ratio = power / np.median(beside, axis=0)
    ratio[:16], ratio[-16:] = 0, 0
    k, axis = (int(one) for one in np.unravel_index(int(ratio.argmax()), ratio.shape))
    if ratio[k, axis] < 6:  # of 8 spectra the mean is above 4 once in 10 million
        return []
    unit, factor = GYRO.shown if name == "gyro" else ACCEL.shown
    line = power[k - 2 : k + 3, axis].sum() - 5 * np.median(beside[:, k, axis])
    amplitude = np.sqrt(4 * line / length / np.sum(window**2)) / factor
    text = f"not static: {AXES[axis]} shakes at {k / length / dt:.3g} Hz, amplitude {amplitude:.3g} {unit}"
    return [Finding("error", f"imu.{name}", text + ": a vibration or a swing", "static")]


def warmed(sensors: dict[str, Array], temperature: Array | None) -> list[Finding]:
    """Whether the means of six axes (N, 3 each) change with the temperature (N,).

    By their changes from one sixteenth of the log to the next, which of random walks are independent.  Where there is
    no temperature: whether two axes change together, or one does most of it in the first quarter.
    """
    from scipy.special import fdtrc

    change = np.hstack([_changes(rates) for rates in sensors.values()])
    names = [f"{name} {axis}" for name in sensors for axis in AXES]
    scale = np.sqrt(np.sum(change**2, axis=0))
    unit = change / np.where(scale > 0, scale, np.inf)
    text, worst = "", 0
    if temperature is not None and np.ptp(temperature) > 0:
        warmer = _changes(temperature)
        correlation = unit.T @ warmer / np.sqrt(warmer @ warmer)
        worst = int(np.abs(correlation).argmax())
        if np.abs(correlation[worst]) > TOGETHER:
            slope = float(change[:, worst] @ warmer / (warmer @ warmer))
            shown, factor = GYRO.shown if worst < 3 else ACCEL.shown
            text = f"follows it by {slope / factor:.3g} {shown} per degC over {np.ptp(temperature):.2g} degC"
    else:
        pairs = np.abs(np.triu(unit.T @ unit, 1))
        early = np.mean(change[:4] ** 2, axis=0) / np.maximum(np.mean(change[4:] ** 2, axis=0), 1e-300)
        early = np.where(np.abs(np.sign(change[:3]).sum(axis=0)) == 3, early, 0)
        if pairs.max() > TOGETHER:
            worst, other = (int(k) for k in np.unravel_index(int(pairs.argmax()), pairs.shape))
            text = f"drifts together with {names[other]}, as by temperature"
        elif fdtrc(4, len(change) - 4, early.max()) < 2e-4:
            worst = int(early.argmax())
            shown, factor = GYRO.shown if worst < 3 else ACCEL.shown
            moved = change[:4, worst].sum() / factor
            text = f"drifts by {moved:.3g} {shown} in its first quarter and hardly later, as a unit does that warms up"
    if not text:
        return []
    name, axis = names[worst].split(" ")
    text = f"driven by temperature: {axis} {text}; let it warm up, or begin later (--from)"
    return [Finding("error", f"imu.{name}", text, "temperature")]


def _changes(values: Array) -> Array:
    """(15, ...) of the mean, from one sixteenth to the next."""
    changes: Array = np.diff([part.mean(axis=0) for part in np.array_split(values, 16)], axis=0)
    return changes


# ---------------------------------------------------------------- what is identified


@dataclass(frozen=True)
class Identified:
    """The noises of a unit: `gyro` and `accel` are three fits each, `findings` what makes them doubtful."""

    name: str
    seconds: float
    rate_hz: float
    gyro: tuple[Fit, ...]
    accel: tuple[Fit, ...]
    findings: tuple[Finding, ...]

    @property
    def good(self) -> bool:
        return not any(one.level == "error" for one in self.findings)

    def sensors(self) -> tuple[tuple[Sensor, tuple[Fit, ...]], ...]:
        return (GYRO, self.gyro), (ACCEL, self.accel)

    def walk(self, fits: tuple[Fit, ...]) -> float:
        """SI, the random walk: the largest of three axes."""
        return max(float(fit.coefficients[1]) for fit in fits)

    @cached_property
    def bias(self) -> tuple[float | None, dict[str, float]]:
        """Correlation time, s, and steady sigmas, SI by sensor, of Gauss-Markov biases like the instabilities.

        Of the worst axis.  No such process has a flat floor: the sigmas and the one correlation time are those whose
        Allan deviation, with the random walk, is nearest to the fitted curve by its logarithm.  None where nothing is
        seen.
        """
        tau, T = self.gyro[0].tau, self.gyro[0].tau[:, None] / 2
        off, sigmas = np.zeros(len(tau)), {}
        for sensor, fits in self.sensors():
            seen = [fit for fit in fits if fit.seen[2]]
            if not seen:
                continue
            worst = max(seen, key=lambda fit: float(fit.coefficients[2]))
            curve = (worst.share[:, 1:4].sum(axis=-1)) * worst.model**2
            # a Gauss-Markov process at its top has 0.62 of its sigma
            trial = worst.coefficients[2] * np.sqrt(FLOOR) / 0.62 * np.linspace(0.7, 2.0, 66)[:, None, None]
            model = gauss_markov(tau, trial, T) + worst.coefficients[1] ** 2 / tau
            misfit = np.sum(np.log(model / curve) ** 2, axis=-1)
            off += misfit.min(axis=0)
            sigmas[sensor.name] = trial[misfit.argmin(axis=0), 0, 0]
        if not sigmas:
            return None, {}
        best = int(off.argmin())
        return float(T[best, 0]), {name: float(values[best]) for name, values in sigmas.items()}

    def bias_walk(self, sensor: Sensor, fits: tuple[Fit, ...]) -> float:
        """SI, of a bias that only walks: as fast as the instability begins to, or as the rate random walk is seen."""
        T, sigmas = self.bias
        begins = sigmas[sensor.name] * np.sqrt(2 / T) if T and sensor.name in sigmas else 0.0
        return max(float(begins), *(float(fit.coefficients[3] * fit.seen[3]) for fit in fits))

    def lines(self) -> str:
        """What is pasted into a recording's description, and behind it the constants of a model."""
        T, sigmas = self.bias
        out = ["[noise]"]
        for sensor, fits in self.sensors():
            kind, unit = sensor.noise
            out.append(f'{sensor.name} = "{_number(self.walk(fits) / UNITS[kind][unit])} {unit}"')
        for sensor, _ in self.sensors():
            unit, factor = sensor.shown
            if sensor.name in sigmas:
                out.append(f'{sensor.name}_instability = "{_number(sigmas[sensor.name] / factor)} {unit}"')
            else:
                out.append(f"# {sensor.name}_instability: none is seen in {self.seconds / 60:.4g} min")
        out += [f'correlation = "{_number(T)} s"'] if T else []
        out += ["", "# constants of a model, if its biases are random walks"]
        for sensor, fits in self.sensors():
            out.append(f"{sensor.name}_noise = {self.walk(fits):.4g}  # {sensor.constants[0]}")
            if walk := self.bias_walk(sensor, fits):
                out.append(f"{sensor.name}_bias_noise = {walk:.4g}  # {sensor.constants[1]}")
        return "\n".join(out)

    def report(self) -> str:
        """What was found, for a person."""
        out = [f"{one.level}: {one.where}: {one.text}" for one in self.findings]
        out += [""] if out else []
        count = len(self.gyro[0].tau)
        out.append(
            f"{self.name}: {self.seconds / 60:.4g} min at rest, {self.rate_hz:.6g} Hz; Allan deviation at {count} times"
        )
        for sensor, fits in self.sensors():
            out += ["", _row(sensor.name, AXES)]
            for term, (unit, factor) in enumerate(sensor.units):
                word = sensor.walk if term == 1 else TERMS[term]
                bounds = [(fit.low[term] / factor, fit.high[term] / factor) for fit in fits]
                seen = [bool(fit.seen[term]) for fit in fits]
                values = [
                    _number(fit.coefficients[term] / factor) if there else f"below {_number(high)}"
                    for fit, there, (_, high) in zip(fits, seen, bounds, strict=True)
                ]
                out.append(_row(f"{word}, {unit}", values))
                if any(seen):
                    spans = [_span(*bound) * there for bound, there in zip(bounds, seen, strict=True)]
                    out.append(_row("  95 %", spans))
                    out.append(
                        _row("  read from, s", [_span(*fit.read_from(term)) * bool(fit.seen[term]) for fit in fits])
                    )
        if not self.good:
            return "\n".join([*out, "", "no lines to paste: this is no log of noise alone"])
        says = "Lines to paste: the worst axis; the instability as a Gauss-Markov process, which has no flat floor."
        return "\n".join([*out, "", says, "", self.lines()])

    def document(self) -> dict[str, Any]:
        """The same for `--json`."""

        def one(sensor: Sensor, fit: Fit, axis: str) -> dict[str, Any]:
            terms = [
                {
                    "name": TERMS[k], "unit": unit, "value": fit.coefficients[k] / factor, "low": fit.low[k] / factor,
                    "high": fit.high[k] / factor, "seen": bool(fit.seen[k]), "read_from_s": fit.read_from(k),
                }
                for k, (unit, factor) in enumerate(sensor.units)
            ]  # fmt: skip
            factor = sensor.shown[1]
            curve = {name: (getattr(fit, name) / factor).tolist()
                     for name in ("deviation", "deviation_low", "deviation_high", "model")}  # fmt: skip
            curve |= {"tau_s": fit.tau.tolist(), "freedom": fit.freedom.tolist(), "used": fit.used.tolist()}
            return {"axis": axis, "terms": terms, "misfit": fit.misfit, "probability": fit.probability,
                    "unit": sensor.shown[0], "curve": curve}  # fmt: skip

        fits = {
            sensor.name: [one(sensor, fit, axis) for fit, axis in zip(fits, AXES, strict=True)]
            for sensor, fits in self.sensors()
        }
        return {
            "log": self.name, "seconds": self.seconds, "rate_hz": self.rate_hz, "good": self.good,
            "findings": [vars(one) for one in self.findings], **fits, "lines": self.lines() if self.good else None,
        }  # fmt: skip

    def draw(self, path: str | Path, made_from: str = "", stated: Mapping[str, str] | None = None) -> Path:
        """The measured curves with their intervals, the fit, and what a filter with the pasted lines expects.

        stated: [noise] of a description, of which it is drawn as well what a filter with that expects.
        """
        T, sigmas = self.bias
        with figure(Path(path), 7.2, 3.6, made_from=made_from, ncols=2) as (_, panels):
            for (sensor, fits), axes in zip(self.sensors(), panels, strict=True):
                unit, factor = sensor.shown
                for fit, label, colour in zip(fits, AXES, COLOURS, strict=True):
                    reach = [fit.deviation - fit.deviation_low, fit.deviation_high - fit.deviation]
                    axes.errorbar(
                        fit.tau, fit.deviation / factor, np.array(reach) / factor, fmt="o", ms=2.5, color=colour,
                        elinewidth=0.8, label=f"{label}, 95 %",
                    )  # fmt: skip
                    axes.plot(fit.tau[fit.used], fit.model[fit.used] / factor, color=colour, lw=0.9)
                tau = fits[0].tau
                bias = gauss_markov(tau, sigmas[sensor.name], T) if T and sensor.name in sigmas else 0.0
                expected = np.sqrt(self.walk(fits) ** 2 / tau + bias) / factor
                axes.plot(tau, expected, "--", color="black", lw=0.9, label="a filter with the lines to paste")
                if sensor.name in (stated or {}):
                    described = np.sqrt(predicted(sensor, stated or {}, tau)) / factor
                    axes.plot(
                        tau, described, ":", color="black", lw=1.2, label="a filter with [noise] of the description"
                    )
                axes.set(xscale="log", yscale="log", xlabel="average over [s]", ylabel=f"Allan deviation [{unit}]")
                axes.set_title(f"{sensor.name}: measured, and fitted (lines)", loc="left")
                worst = max(fits, key=lambda fit: float(fit.coefficients[1]))
                low = axes.get_ylim()[0]
                seen = [term for term in range(5) if worst.seen[term]]
                for place, term in enumerate(seen):
                    begin, end = worst.read_from(term)
                    height = low * 0.72 ** (place + 1)
                    axes.plot([begin / 1.2, end * 1.2], [height] * 2, color="0.55", lw=3, solid_capstyle="butt")
                    word = sensor.walk if term == 1 else TERMS[term]
                    late = begin > np.sqrt(tau[0] * tau[-1])
                    axes.annotate(
                        word, (end if late else begin, height), (0, 2), textcoords="offset points", fontsize=6.5,
                        color="0.3", ha="right" if late else "left",
                    )  # fmt: skip
                axes.legend(loc="upper right")
        return Path(path)


def predicted(sensor: Sensor, stated: Mapping[str, str], tau: Array) -> Array:
    """(K,) Allan variance that a filter expects with [noise] of a description, which has the sensor's own; SI."""
    variance: Array = quantity(stated[sensor.name], sensor.noise[0])[0] ** 2 / tau
    wander, time = stated.get(f"{sensor.name}_instability"), stated.get("correlation")
    if wander and time:
        sigma = quantity(wander, "angular rate" if sensor is GYRO else "acceleration")[0]
        variance = variance + gauss_markov(tau, sigma, quantity(time, "time")[0])
    return variance


def _row(name: str, cells: Sequence[str]) -> str:
    return f"{name:<35}{''.join(f'{cell:<17}' for cell in cells)}".rstrip()


def _number(value: float) -> str:
    """Three digits, and no exponent where it is not needed."""
    return f"{float(f'{value:.3g}'):g}"


def _span(low: float, high: float) -> str:
    return f"{_number(low)} to {_number(high)}"


def identify(recording: Recording) -> Identified:
    """The noises of a unit at rest, each with its interval and where the Allan deviation shows it.

    Parameters
    ----------
    recording : Recording
        What `read` makes of a log at rest; a master in it is not looked at.

    Returns
    -------
    Identified
        `report()`, `lines()` to paste, `document()` for JSON, `draw(path)`; `gyro` and `accel` hold
        a fit for each axis, in SI and s.  `good` is False where the log is not one of noise;
        `findings` say why.

    Raises
    ------
    BoresightError
        A log that is too short, or whose samples do not change.

    Notes
    -----
    When not to use it: on a log in motion.  Intervals are those of a Gaussian process that is a sum
    of the five noises; vibration and temperature are none of them.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import noise
    >>> from boresight.runtime.recording import Inertial, Recording
    >>> rng = np.random.default_rng(1)
    >>> gyro, accel = 1e-3 * rng.standard_normal((20_000, 3)), 0.01 * rng.standard_normal((20_000, 3))
    >>> imu = Inertial("rates", "end", np.arange(20_000) * 0.01, gyro, accel - [0, 0, 9.8])
    >>> found = noise.identify(Recording("static", imu))
    >>> print(found.good, found.lines().splitlines()[1])
    True gyro = "0.345 deg/sqrt(h)"
    """
    imu = recording.imu
    dt = (imu.time[-1] - imu.time[0]) / (len(imu.time) - 1)
    seconds = len(imu.time) * dt
    if seconds < SHORTEST_S:
        raise BoresightError(
            f"{recording.name}: {seconds:.3g} s are too short; random walks need a minute at rest, instabilities hours"
        )
    sensors = dict(zip(("gyro", "accel"), imu.rates(), strict=True))
    findings = [one for name, rates in sensors.items() for one in faults(name, rates, dt)]
    if not findings:
        known = recording.temperature
        findings = warmed(sensors, None if known is None else np.interp(imu.time, *known.T))
    doubtful = {one.where for one in findings}
    fits: dict[str, list[Fit]] = {}
    for name, rates in sensors.items():
        for values, axis in zip(rates.T, AXES, strict=True):
            try:
                fit = fitted(values, dt)
            except BoresightError as error:
                raise BoresightError(f"{recording.name}: imu.{name} {axis}: {error}") from None
            fits.setdefault(name, []).append(fit)
            if f"imu.{name}" not in doubtful:  # what is no noise does not fit either, and that is no second cause
                findings += _judged(f"imu.{name}", axis, fit, GYRO if name == "gyro" else ACCEL)
    order = sorted(findings, key=lambda one: one.level != "error")
    return Identified(
        recording.name, float(seconds), float(1 / dt), tuple(fits["gyro"]), tuple(fits["accel"]), tuple(order)
    )


def _judged(where: str, axis: str, fit: Fit, sensor: Sensor) -> list[Finding]:
    """What a fit says of its log."""
    if fit.probability < UNFIT:
        off = np.where(fit.used, np.abs(np.log(fit.deviation / fit.model)) * np.sqrt(2 * fit.freedom), 0)
        k = int(np.argmax(off))
        text = f"{axis}: not a sum of these noises: at {fit.tau[k]:.3g} s the deviation is "
        text += (
            f"{fit.deviation[k] / fit.model[k]:.3g} times the fitted one; some vibration, swing or filter of this time"
        )
        return [Finding("error", where, text, "misfit")]
    out = []
    if fit.seen[4]:
        unit, factor = sensor.units[4]
        text = f"{axis}: drifts by {fit.coefficients[4] / factor:.3g} {unit}, as a unit does that warms up"
        out.append(Finding("warning", where, text + "; begin later (--from)", "temperature"))
    if not fit.seen[2]:
        text = f"{axis}: too short to show an instability: below {fit.high[2] / sensor.units[2][1]:.3g}"
        out.append(Finding("note", where, f"{text} {sensor.units[2][0]}, at averages of up to {fit.tau[-1]:.3g} s"))
    if not fit.used.all():
        text = f"{axis}: averages below {fit.tau[fit.used][0]:.3g} s do not fit, as behind a filter, and are left out"
        out.append(Finding("note", where, text))
    return out
