"""The heading error of an unknown delay: the closed form against the flown filter, wherever its variables are varied.

Sea state 5, no yaw, a fixed delay, nothing random.  derive/papers/delay_error derives the form; `predicted_heading` of
the study is its general case.  Beside it, the two ways to handle a delay that is known of.
"""

from dataclasses import replace
from itertools import chain
from typing import Any

import numpy as np

from boresight.runtime.array import Array
from boresight.runtime.simulation import hull, sea
from boresight.runtime.units import DEG, MIL
from boresight.studies.sea_state import live
from boresight.studies.sea_state.flight import GRADES, HEIGHT_M, SETTLED_S, Flight, Scenario, fly, only, signals
from boresight.studies.study import table

# What is varied, one at a time, about the first of each.
VARIED: dict[str, tuple[float, ...]] = {
    "delay_ms": (7.5, 1.0, 2.5, 5.0, 10.0, 20.0),
    "ratio": (0.5, 0.1, 0.25, 1.0, 2.0, 4.0),  # amplitude of pitch over that of roll
    "phase_deg": (90.0, 0.0, 30.0, 60.0, 120.0, 180.0, 225.0, 270.0, 315.0),  # of pitch ahead of roll
    "frequency_hz": (0.1, 0.05, 0.075, 0.15, 0.2, 0.3),
    "heading_deg": (30.0, 0.0, 75.0, 120.0, 200.0, 290.0),
    "grade": (5.0, 3.0, 4.0, 6.0),
}
ALLOWED_PART, ALLOWED_MIL = 0.05, 0.1


def closed_form(delay_s: Any, ratio: Any, phase: Any, frequency_hz: Any) -> Array:
    """yaw_hat - yaw, rad, steady: 2 tau omega rho sin(epsilon) / (1 + rho^2), pitch ahead of roll by epsilon (rad)."""
    ratio, omega = np.asarray(ratio, float), 2 * np.pi * np.asarray(frequency_hz, float)
    return 2 * np.asarray(delay_s, float) * omega * ratio * np.sin(phase) / (1 + ratio**2)


def predicted_heading(motion: hull.Motion, delay_s: Any) -> Array:
    """Steady yaw_hat - yaw (rad) of an unknown delay, by the closed form: (states, ...) of a motion of any kind.

    With e the swing (roll, pitch, yaw about their means) the misalignment errs by tau <|e|^2 - e e'>^-1 <e x e'>, whose
    third part is tau (<r p'> - <p r'>) / (<r^2> + <p^2>) without yaw; the heading by minus that.  Means over all phases
    of the sinusoids: derive/papers/delay_error.
    """
    swing = motion.freedoms.amplitude[..., 3:, :]
    rate = 1j * motion.freedoms.omega[..., None, :] * swing
    spin = np.cross(swing, np.conj(rate), axis=-2).real.sum(-1) / 2
    spread = np.einsum("...ik,...jk->...ij", swing, np.conj(swing)).real / 2
    inertia = np.trace(spread, axis1=-2, axis2=-1)[..., None, None] * np.eye(3) - spread
    # a swing about one axis says nothing about that axis
    turn = np.linalg.pinv(inertia, rcond=1e-9, hermitian=True) @ spin[..., None]
    return -turn[..., 2, 0] * np.asarray(delay_s, float)


def cases() -> list[dict[str, float]]:
    """Every variable through its values, the others at their first."""
    base = {name: values[0] for name, values in VARIED.items()}
    return [base] + [{**base, name: value} for name, values in VARIED.items() for value in values[1:]]


def swing(rows: list[dict[str, float]]) -> hull.Motion:
    """Roll of the wave's slope, pitch beside it, heave; where the frequency is varied the slope stays sea state 5's."""
    columns = {name: np.array([row[name] for row in rows]) for name in VARIED}
    steady, f = VARIED["frequency_hz"][0], columns["frequency_hz"]
    a = np.array([HEIGHT_M[int(grade) - 1] for grade in columns["grade"]]) * (steady / f) ** 2
    slope = sea.wave_number(2 * np.pi * f) * a
    zero = np.zeros_like(a)
    amplitude = np.stack([zero, zero, a, slope, columns["ratio"] * slope, zero], axis=-1)
    phase = np.stack([zero, zero, zero, zero, columns["phase_deg"] * DEG, zero], axis=-1)
    motion = hull.sinusoids(amplitude[:, None], phase[:, None], f[:, None])
    return replace(motion, heading=(columns["heading_deg"] * DEG)[:, None])


def against_simulation(model: Any, scenario: Scenario, seed: int = 0) -> dict[str, Any]:
    """One run of each case without noise; the error is the mean of the last ten seconds, a period or more.

    Returns cases: each with its variables, closed_mil, flown_mil, good (within 5 % or 0.1 mil); worst_mil and all_good.
    """
    rows = cases()
    columns = {name: np.array([row[name] for row in rows]) for name in VARIED}
    tau = columns["delay_ms"] * 1e-3
    flight = fly(
        model, swing(rows), scenario, runs=1, seed=seed, delay_s=tau[:, None], noise=0.0, belief=only("without")
    )
    last = round(10 * scenario.update_hz)
    flown = flight.heading[-last:, 0, :, 0].mean(axis=0) / MIL
    closed = closed_form(tau, columns["ratio"], columns["phase_deg"] * DEG, columns["frequency_hz"]) / MIL
    away = np.abs(flown - closed)
    good = (away <= ALLOWED_PART * np.abs(closed)) | (away <= ALLOWED_MIL)
    return {
        "cases": [
            {**row, "closed_mil": float(c), "flown_mil": float(f), "good": bool(g)}
            for row, c, f, g in zip(rows, closed, flown, good, strict=True)
        ],
        "worst_mil": float(away.max()),
        "all_good": bool(good.all()),
    }


KEYS = ("heading_mil", "delay_error_ms", "nis")
WAYS = ("the paper's", "by a buffer")
ROUGH = slice(2, None)  # of the sea states: those that show the heading
LIVE_RUNS = 10  # a run of a minute takes the live loop 30 ms


def ways(model: Any, scenario: Scenario, *, runs: int, seed: int, flown: Flight | None = None) -> dict[str, Any]:
    """A delay that is compensated, both ways, under "slope": the slave now and moved back, or as it was then.

    Once with the paper's delays and once ten times as long.  "by a buffer" is the live loop in C, LIVE_RUNS runs at
    most.  flown: by the scenario itself, under "slope", if it was.
    Returns grades (those of ROUGH), delay_ms (2 by 2), runs by way, and way -> for each of
    the two: heading_mil (mean error after 60 s), delay_error_ms (rms), nis (of six rows, after 10 s), all (2, grades).
    """
    delays = [scenario.delay_ms, (10 * scenario.delay_ms[0], 10 * scenario.delay_ms[1])]
    few = min(runs, LIVE_RUNS)
    out: dict[str, Any] = {"grades": list(GRADES)[ROUGH], "delay_ms": [list(delay) for delay in delays],
                           "runs": dict(zip(WAYS, (runs, few), strict=True))}  # fmt: skip
    out |= {name: {key: [] for key in KEYS} for name in WAYS}
    for delay in delays:
        one = replace(scenario, delay_ms=delay, delay_sigma_ms=delay[1])
        if flown is None or one != scenario:
            flown = fly(model, "slope", one, runs=runs, seed=seed, belief=only("with"))
        rough = replace(one, height_m=one.height_m[ROUGH])
        buffered = live.fly(model, signals(model, "slope", rough, runs=few, seed=seed), rough)
        # the first filter is that with compensation
        parts = (flown.error[-1, 0, ROUGH], flown.nis[:, 0, ROUGH]), (buffered.error[-1], buffered.nis)
        for name, (error, nis) in zip(WAYS, parts, strict=True):
            settled = nis[SETTLED_S * scenario.update_hz :].sum(-1)
            values = (np.abs(error[..., 2]).mean(-1) / MIL, np.sqrt(np.mean(error[..., 15] ** 2, axis=-1)) * 1e3,
                      settled.mean((0, -1)))  # fmt: skip
            for key, value in zip(KEYS, values, strict=True):
                out[name][key].append(value.tolist())
        flown = None
    return out


def report(closed: dict[str, Any], two: dict[str, Any] | None) -> list[str]:
    """The closed form variable by variable, and the two ways side by side if they were flown."""
    base, rows = closed["cases"][0], []
    for name, values in VARIED.items():
        chosen = [row for row in closed["cases"] if all(row[other] == base[other] for other in VARIED if other != name)]
        for row in (row for row in chosen if row is not base):
            rows.append((f"{name} {row[name]:g}, not {values[0]:g}", row["closed_mil"], row["flown_mil"]))
    verdict = "all" if closed["all_good"] else "NOT all"
    lines = [
        "an unknown delay: yaw_hat - yaw in mil; sea state 5, no yaw",
        *table(("", "closed form", "flown"), [("as declared", base["closed_mil"], base["flown_mil"]), *rows], ".2f"),
        f"  {verdict} within 5 % or 0.1 mil; the farthest by {closed['worst_mil']:.3f} mil",
    ]
    if two is None:
        return lines
    ways = [
        (f"{low:g} to {high:g} ms {name}", *zip(*(two[name][key][row] for key in KEYS), strict=True))
        for row, (low, high) in enumerate(two["delay_ms"])
        for name in WAYS
    ]
    return [
        *lines,
        "",
        "a delay compensated, after 60 s under slope: heading in mil, delay in ms, NIS of 6",
        "  ({}: the plain filter, {} runs; {}: the live loop, {} runs)".format(*chain(*two["runs"].items())),
        *table(("", *(f"state {g}" for g in two["grades"])), ways, ".2f"),
    ]
