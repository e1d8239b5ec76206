"""Every condition flown: the NEES beside its band, the NIS, what was refused, and what the notes say."""

import re
from pathlib import Path
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.evidence.flights.conditions import CONDITIONS, RUNS, Condition
from boresight.evidence.flights.fly import band, fly
from boresight.runtime.array import Array
from boresight.runtime.transfer import Note, Rules, Verdict
from boresight.runtime.transfer.history import PHI, TAU


def campaign(of: Any, out: Path) -> dict[str, dict[str, Any]]:
    """By condition."""
    return {condition.name: flown(condition) for condition in CONDITIONS}


def flown(condition: Condition, runs: int = RUNS) -> dict[str, Any]:
    """One condition, with so many runs."""
    settings = dict(condition.settings)
    for name in ("said", "sensed"):  # made anew for each flight: some remember
        if name in settings:
            settings[name] = settings[name]()
    if "rules" in settings:
        settings["rules"] = Rules(**settings["rules"])
    asked = {"asked": condition.asked, "told": condition.told}
    try:
        flight = fly(condition.motion(), runs=runs, **settings)
    except BoresightError as error:
        return {**asked, "error": str(error)}
    nees, count = flight.nees, len(flight.time)
    n = len(flight.states)  # that are carried
    low, high = band(runs, n)
    tau = flight.nees_of([TAU])
    late = nees[count // 2 :]
    came = flight.verdict != Verdict.ABSENT
    off, variance = flight.errors[-1][:, PHI], np.einsum("rii->ri", flight.P[-1])[:, PHI]
    return {
        **asked,
        "states": n,
        "band": [round(float(low), 3), round(float(high), 3)],
        "nees": {
            "start": round(float(flight.start_nees.mean()), 3),
            "second half": round(float(late.mean()), 3),
            "worst": round(float(late.mean(axis=1).max()), 3),
            "end": round(float(nees[-1].mean()), 3),
        },
        "delay": {
            "band": [round(float(limit), 3) for limit in band(runs, 1)],
            "second half": round(float(tau[count // 2 :].mean()), 3),
            "end": round(float(tau[-1].mean()), 3),
        },
        "attitude": {"is": milliradians(np.square(off).mean(0)), "claimed": milliradians(variance.mean(0))},
        "nis": round(float(np.nanmean(flight.nis)), 4),
        "refused": round(float((flight.verdict[came] > Verdict.REOPENED).mean()), 5),
        "notes": lines(flight.loop.notes),
    }


def milliradians(mean_square: Array) -> list[float]:
    """About north, east and down, at the end."""
    return [round(1e3 * float(value), 3) for value in np.sqrt(mean_square)]


def lines(notes: list[Note]) -> list[str]:
    """What the notes say, one of those that differ by their numbers alone."""
    first: dict[str, str] = {}
    for note in notes:
        text = note.text.split(" (run")[0]
        first.setdefault(re.sub(r"[\d.]+", "#", text), text)
    return list(first.values())
