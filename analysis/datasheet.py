"""A line of a datasheet, as "ARW 0.15 deg/rt-hr": its quantity by its unit, and what it is to a filter.

Conventions hide behind one number, and a unit tells them apart; a number without one is refused.  Of a bias that
wanders, "1 deg/h" is the steady sigma, "1 deg/h/sqrt(s)" the density of the noise that drives it.  A density of the
rate, "deg/s/sqrt(Hz)", is the random walk of the angle if its spectrum has two sides, as IEEE 952 has it; of a spectrum
with one side, as an analyser draws it, the walk is 1/sqrt(2) of it.
"""

import re
from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.units import UNITS

# What a line may be, by kind of UNITS: of which sensor, what, and the unit in which a sigma of it is shown.
KINDS = {
    "gyro noise": ("gyro", "density", "deg/s"),
    "accelerometer noise": ("accel", "density", "mg"),
    "gyro bias walk": ("gyro", "walk", "deg/h"),
    "accelerometer bias walk": ("accel", "walk", "ug"),
    "angular rate": ("gyro", "sigma", "deg/h"),
    "acceleration": ("accel", "sigma", "ug"),
}
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
BANDWIDTH = re.compile(rf"[,;(]?\s*(?:noise\s+)?(?:bandwidth|bw)\s*(?:of|=|:)?\s*({NUMBER})\s*(k?)hz\)?", re.IGNORECASE)
LINE = re.compile(rf"^(?:\D*?[\s:=(])?({NUMBER})\s*(\S.*)?$")
QUALIFIERS = re.compile(r"\(?\b(rms|typ(ical)?|max(imum)?|1[\s-]*sigma)\b\.?\)?|\(?1\s*σ\)?", re.IGNORECASE)
# As people write units, to how UNITS has them; one after the other.
SPELLINGS = (
    ("°", "deg"), ("[µμ]", "u"), ("²", "^2"), ("σ", " sigma"), ("½", "^0.5"), ("√", "sqrt "), (r"\*\*", "^"),
    (r"\bdegrees?\b|\bdegs\b", "deg"), (r"\b(hours?|hrs?|hr)\b", "h"), (r"\b(seconds?|secs?|sec)\b", "s"),
    (r"\bhz\b|\bHZ\b", "Hz"), (r"\bdps\b", "deg/s"), (r"\bdph\b", "deg/h"), (r"\bmicro-?g\b", "ug"),
    (r"\b(square root|root|rt|sqrt)[\s-]*\(?\s*(hr|h|s|Hz)\s*\)?", r"sqrt(\2)"), (r"sqrt\(hr\)", "sqrt(h)"),
    (r"\b(h|s|Hz)\^\(?(0\.5|1/2)\)?", r"sqrt(\1)"), (r"m/s2|m/s/s(?!q)", "m/s^2"), (r"\s+", ""),
    (r"^\(([^()]*)\)/", r"\1/"),
)  # fmt: skip


@dataclass(frozen=True)
class Line:
    """What a line says: `what` is density, walk or sigma, of the gyro or the accel; `si` its number in SI and radians.

    rows: (name, number, unit, convention) of what follows from it; lines: to paste into a recording's description.
    """

    text: str
    sensor: str
    what: str
    value: float
    unit: str
    si: float
    bandwidth_hz: float | None
    rows: tuple[tuple[str, float, str, str], ...]
    lines: tuple[str, ...]

    def report(self) -> str:
        known = {"density": "a density", "walk": "a random walk of the bias", "sigma": "a sigma"}[self.what]
        out = [f"{self.text}: {known} of the {self.sensor}, {self.value:g} {self.unit}"]
        out += [f"  {name:<34}{number:>12.6g} {unit:<16}{note}".rstrip() for name, number, unit, note in self.rows]
        return "\n".join(out + (["", "[noise]", *self.lines] if self.lines else []))

    def document(self) -> dict[str, Any]:
        rows = [dict(zip(("name", "value", "unit", "convention"), row, strict=True)) for row in self.rows]
        return {**vars(self), "rows": rows, "lines": list(self.lines)}


def unit_of(text: str) -> str:
    """A unit as UNITS spells it, from what stands in a datasheet."""
    for written, spelled in SPELLINGS:
        text = re.sub(written, spelled, text)
    return text


def datasheet(text: str, *, rate_hz: float | None = None, correlation_s: float | None = None) -> Line:
    """A noise as a datasheet has it, as a filter takes it: per sample, and as a bias's steady sigma.

    Parameters
    ----------
    text : str
        As "0.15 deg/sqrt(h)", "ARW 0.15 deg/rt-hr", "40 ug/sqrt(Hz) rms" or
        "0.003 deg/s/sqrt(Hz), bandwidth 80 Hz".
    rate_hz : float, optional
        Samples per second, for a sigma per sample.
    correlation_s : float, optional
        Of a Gauss-Markov bias: a rate's own unit is then its steady sigma, a random walk of the
        bias the density that drives it.

    Returns
    -------
    Line
        `si`: the number in SI and rad; `rows`: what follows; `report()`, `document()`.

    Raises
    ------
    BoresightError
        No unit, an unknown one, or a sigma of which nothing says whether it is one per sample, in
        a bandwidth, or of a bias.

    Notes
    -----
    When not to use it: where a log at rest is to be had; a datasheet's number is one of a good unit
    at a steady temperature.

    Examples
    --------
    >>> from boresight import noise
    >>> sheet = noise.datasheet("1 deg/h/sqrt(s)", rate_hz=100, correlation_s=300)
    >>> for name, value, unit, _ in sheet.rows:
    ...     print(name, round(value, 4), unit)
    steady sigma 12.2474 deg/h
    per step of 0.01 s 0.1 deg/h
    """
    found = BANDWIDTH.search(text)
    bandwidth = float(found[1]) * (1000 if found[2] else 1) if found else None
    rest = QUALIFIERS.sub("", text.replace(found[0], "") if found else text).strip(" ,;:")
    parts = LINE.match(rest)
    known = {unit: kind for kind in KINDS for unit in UNITS[kind]}
    if not parts:
        raise BoresightError(f"{text!r}: there is no number in it; write it as '0.15 deg/sqrt(h)'")
    unit = unit_of(parts[2] or "")
    if unit not in known:
        lacks = f"unit {parts[2]!r} is not known" if parts[2] else "a number without a unit may be a density or a sigma"
        raise BoresightError(f"{text!r}: {lacks}; use one of {', '.join(known)}")
    for name, given in (("the rate", rate_hz), ("the correlation time", correlation_s), ("the bandwidth", bandwidth)):
        if given is not None and not 0 < given < np.inf:
            raise BoresightError(f"{text!r}: {name} is {given:g}; it must be above zero")
    value = float(parts[1])
    if not value > 0:
        raise BoresightError(f"{text!r}: a noise must be above zero")
    sensor, what, shown = KINDS[known[unit]]
    si = value * UNITS[known[unit]][unit]
    rows = {"density": _density, "walk": _walk, "sigma": _sigma}[what](
        si, sensor, shown, rate_hz, correlation_s, bandwidth
    )
    if not rows:
        raise BoresightError(
            f"{text!r}: a sigma of what?  Per sample: give the rate (--rate '100 Hz', rate_hz); in a bandwidth: add "
            "', bandwidth 80 Hz'; of a bias that wanders: give the correlation time (--correlation '300 s', "
            "correlation_s); of a bias at turn-on: it is its sigma at the start, and no noise"
        )
    lines = [f'{sensor} = "{value:g} {unit}"'] if what == "density" else []
    steady = si if what == "sigma" else si * np.sqrt((correlation_s or 0) / 2)
    if what != "density" and correlation_s:
        lines = [f'{sensor}_instability = "{_in(steady, shown):.4g} {shown}"', f'correlation = "{correlation_s:g} s"']
    return Line(text, sensor, what, value, unit, si, bandwidth, tuple(rows), tuple(lines))


Rows = list[tuple[str, float, str, str]]
TWO, ONE = "spectrum with two sides (IEEE 952)", "spectrum with one side"


def _in(si: float, unit: str) -> float:
    return float(si / (UNITS["angular rate"] | UNITS["acceleration"])[unit])


def _density(N: float, sensor: str, shown: str, rate: float | None, T: float | None, bandwidth: float | None) -> Rows:
    """N: SI, as a random walk."""
    kind = "gyro noise" if sensor == "gyro" else "accelerometer noise"
    rows: Rows = [("the same", N / factor, unit, "") for unit, factor in UNITS[kind].items()]
    sides = ((TWO, N), (ONE, N / np.sqrt(2)))
    if rate:
        rows += [(f"per sample at {rate:g} Hz, if white", _in(walk * np.sqrt(rate), shown), shown, side)
                 for side, walk in sides]  # fmt: skip
    if bandwidth:
        # one pole lets through pi/2 of its bandwidth, on either side
        rows += [(f"within {bandwidth:g} Hz, one pole", _in(walk * np.sqrt(np.pi * bandwidth), shown), shown, side)
                 for side, walk in sides]  # fmt: skip
    return rows


def _driven(q: float, shown: str, rate: float | None, T: float | None) -> Rows:
    """What a bias that is driven by a density q wanders by from one sample to the next."""
    if not rate:
        return []
    dt = 1 / rate
    step = q * np.sqrt(-T / 2 * np.expm1(-2 * dt / T)) if T else q * np.sqrt(dt)
    return [(f"per step of {dt:g} s", _in(float(step), shown), shown, "")]


def _walk(q: float, sensor: str, shown: str, rate: float | None, T: float | None, bandwidth: float | None) -> Rows:
    steady: Rows = [("steady sigma", _in(q * np.sqrt(T / 2), shown), shown, f"correlation {T:g} s")] if T else []
    rows = steady + _driven(q, shown, rate, T)
    return rows or [("the same", _in(q, shown), f"{shown}/sqrt(s)", "a walk without bound: no correlation time")]


def _sigma(sigma: float, sensor: str, shown: str, rate: float | None, T: float | None, bandwidth: float | None) -> Rows:
    if T:
        q = sigma * np.sqrt(2 / T)
        driving = ("density that drives it", _in(q, shown), f"{shown}/sqrt(s)", f"correlation {T:g} s")
        return [driving, *_driven(q, shown, rate, T)]
    unit = "deg/sqrt(h)" if sensor == "gyro" else "ug/sqrt(Hz)"
    factor = UNITS["gyro noise" if sensor == "gyro" else "accelerometer noise"][unit]
    rows: Rows = []
    if bandwidth:
        rows += [("random walk", sigma / np.sqrt(np.pi * bandwidth) / factor, unit, "the sigma within one pole")]
    if rate:
        rows += [("random walk", sigma / np.sqrt(rate) / factor, unit, "the sigma per sample, white")]
    return rows
