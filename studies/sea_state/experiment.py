"""The experiment of Kang and others (2025): transfer alignment in sea states 1 to 6, with and without the delay.

240 runs under each of three motions, the paper's claims judged by numbers, the closed form of an uncompensated delay
against the simulation, and the bench.  docs/sea-state.md tells the story; `sea_flight` flies.
"""

from collections.abc import Callable, Sequence
from dataclasses import asdict
from itertools import pairwise
from time import perf_counter
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.library import load
from boresight.runtime.units import MIL
from boresight.studies.consistency import chi_square_band
from boresight.studies.sea_state import bench as sea_bench
from boresight.studies.sea_state import delay as sea_delay
from boresight.studies.sea_state.flight import FILTERS, GRADES, MOTIONS, Flight, Scenario, checked, draw, fly, motion_of

LIMIT_MIL = 2.0  # the paper's
SETTLED_S = 10  # NIS counts from here on: at first the filter makes use of a start that is better than it was told


def marks_s(scenario: Scenario) -> tuple[int, int]:
    """Half of a run and all of it: 30 and 60 s."""
    return scenario.seconds // 2, scenario.seconds


def table(flight: Flight, scenario: Scenario) -> dict[str, Any]:
    """What `run` says of one motion, filter by filter and sea state by sea state."""
    h, sigma = flight.heading / MIL, flight.heading_sigma / MIL
    marks = [mark * scenario.update_hz for mark in marks_s(scenario)]
    late = slice(marks[0], None)
    settled = SETTLED_S * scenario.update_hz
    size = np.abs(h).mean(-1)  # (U + 1, 2, 6)
    below = np.flip(np.logical_and.accumulate(np.flip(size < LIMIT_MIL, axis=0), axis=0), axis=0)
    # from this update on below the limit, for good; nan if never
    since = np.where(below.any(0), below.argmax(0) / scenario.update_hz, np.nan)
    time = np.arange(len(h[late]))[:, None, None, None]
    line = np.polynomial.polynomial.polyfit(time.ravel(), h[late].reshape(len(time), -1), 1)
    fitted = (line[0] + line[1] * time.reshape(-1, 1)).reshape(h[late].shape)
    wander = (h[late] - fitted).std(axis=0).mean(-1)
    out: dict[str, Any] = {}
    for i, name in enumerate(FILTERS):
        out[name] = {
            "mean_mil": size[marks, i].tolist(),
            "worst_mil": np.abs(h[marks, i]).max(-1).tolist(),
            "signed_mil": h[marks, i].mean(-1).tolist(),
            "sigma_mil": sigma[marks, i].mean(-1).tolist(),
            "below_limit_s": [None if np.isnan(at) else float(at) for at in since[i]],
            "wander_mil": wander[i].tolist(),
            "nis": flight.nis[settled:, i].sum(-1).mean((0, 2)).tolist(),
        }
    e, P = flight.error[-1], flight.P[-1]
    known = slice(0, 15)  # the delay that is not estimated is in no covariance
    for i, name in enumerate(FILTERS):
        part = slice(None) if name == "with" else known
        e_i, P_i = e[i][..., part], P[i][..., part, part]
        nees = np.einsum("...i,...i->...", e_i, np.linalg.solve(P_i, e_i[..., None])[..., 0])
        out[name]["nees"] = nees.mean(-1).tolist()
        out[name]["nees_of"] = e_i.shape[-1]
    return out


def claims(result: dict[str, Any], scenario: Scenario) -> list[dict[str, Any]]:
    """The paper's six, judged for one motion.  Each: claim, holds, numbers (a sentence with those that decide)."""
    half, end = marks_s(scenario)
    w, o = (result[name] for name in FILTERS)
    at_half, at_end = (np.array(w["mean_mil"][i]) for i in (0, 1))
    bare_end = np.array(o["mean_mil"][1])
    since = [np.inf if at is None else at for at in w["below_limit_s"]]
    gain = bare_end - at_end
    wander, steady = np.array(o["wander_mil"])[2:], np.array(w["wander_mil"])[2:]

    def numbers(values: Any) -> str:
        return ", ".join("never" if not np.isfinite(v) else f"{v:.2f}" if v < 99.5 else f"{v:.0f}" for v in values)

    rough = slice(2, None)
    return [
        {
            "claim": "up to state 2 it does not converge",
            "holds": bool((at_end[:2] > LIMIT_MIL).all()),
            "numbers": f"states 1, 2 after {end} s: {numbers(at_end[:2])} mil",
        },
        {
            "claim": "from state 3 on under 2 mil within about 30 s with compensation",
            "holds": bool((at_half[rough] < LIMIT_MIL).all() and (at_end[rough] < LIMIT_MIL).all()),
            "numbers": f"states 3 to 6 after {half} s: {numbers(at_half[rough])} mil, worst run "
            f"{numbers(w['worst_mil'][0][rough])}",
        },
        {
            "claim": "states 4 to 6 exceed 2 mil without, state 3 does not",
            "holds": bool((bare_end[3:] > LIMIT_MIL).all() and bare_end[2] <= LIMIT_MIL),
            "numbers": f"states 3 to 6 after {end} s: {numbers(bare_end[rough])} mil",
        },
        {
            "claim": "the rougher, the faster",
            "holds": bool(all(a >= b for a, b in pairwise(since[2:])) and since[2] > since[-1]),
            "numbers": f"states 3 to 6 for good below 2 mil from {numbers(since[2:])} s on",
        },
        {
            "claim": "compensation matters more as the sea grows",
            "holds": bool((np.diff(gain[rough]) > 0).all() and gain[-1] > LIMIT_MIL / 10),
            "numbers": f"states 3 to 6: {numbers(gain[rough])} mil less, that is by the factors "
            f"{numbers(bare_end[rough] / at_end[rough])}",
        },
        {
            "claim": "uncompensated the estimate oscillates more with grade",
            "holds": bool((np.diff(wander) > 0).all() and (np.diff(wander / steady) > 0).all()),
            "numbers": f"states 3 to 6 about a line, {half} to {end} s: {numbers(wander)} mil, with compensation "
            f"{numbers(steady)}",
        },
    ]


def run(
    model: Any = None,
    *,
    runs: int = 20,
    seed: int = 0,
    scenario: Scenario | None = None,
    motions: Sequence[str] = tuple(MOTIONS),
    bench_runs: int = 10,
    histories: bool = True,
    progress: Callable[[str], None] | None = None,
) -> dict[str, Any]:
    """The experiment under each motion.  The result can be written as JSON; its fields are stable:

    study, runs, seed, scenario (every field of Scenario), grades, filters, limit_mil, marks_s;
    nees_band, nis_band: 95 % bands of the means below, of 16 and of 6 degrees of freedom;
    motions: NAME -> says; with, without: mean_mil, worst_mil, signed_mil, sigma_mil (2 marks, 6 states) of the heading
    error, below_limit_s (6, null where never), wander_mil (6, deviation from a straight line after half), nis (6, of
    six rows, after 10 s), nees (6, at the end) of nees_of states; predicted_mil (6, what an unknown delay does by the
    closed form, mean over the runs); claims: claim, holds, numbers; seconds: what it took;
    with histories also history: time_s, heading_mil (2, 6, runs, T), sigma_mil (2, 6, T);
    closed_form: of `sea_delay.against_simulation`; bench: of `sea_bench.experiment` (null with no bench_runs);
    ways: of `sea_delay.ways`, under the motion "slope".
    """
    scenario = checked(scenario or Scenario())
    if scenario.seconds < 2 * SETTLED_S:
        raise BoresightError(f"sea-state: seconds is {scenario.seconds}; it must be at least {2 * SETTLED_S}")
    if runs < 2:
        raise BoresightError(f"sea-state needs at least 2 runs; got {runs}")
    model = model or load("velocity-attitude")
    say = progress or (lambda line: None)
    updates = scenario.seconds * scenario.update_hz
    result: dict[str, Any] = {
        "study": "sea-state",
        "runs": runs,
        "seed": seed,
        "scenario": {name: list(v) if isinstance(v, tuple) else v for name, v in asdict(scenario).items()},
        "grades": list(GRADES),
        "filters": list(FILTERS),
        "limit_mil": LIMIT_MIL,
        "marks_s": list(marks_s(scenario)),
        "nees_band": chi_square_band(16, runs),
        "nis_band": chi_square_band(6, runs * (updates - SETTLED_S * scenario.update_hz)),
        "motions": {},
    }
    for kind in motions:
        say(f"{MOTIONS[kind]}: {2 * len(GRADES) * runs} runs of {scenario.seconds} s")
        begun = perf_counter()
        flight = fly(model, kind, scenario, runs=runs, seed=seed)
        one = {"says": MOTIONS[kind], **table(flight, scenario)}
        motion = motion_of(kind, scenario, draw(scenario, seed, runs).streams)
        one["predicted_mil"] = (sea_delay.predicted_heading(motion, flight.delay) / MIL).mean(-1).tolist()
        one["claims"] = claims(one, scenario)
        one["seconds"] = round(perf_counter() - begun, 1)
        if histories:
            one["history"] = {
                "time_s": (np.arange(updates + 1) / scenario.update_hz).tolist(),
                "heading_mil": np.moveaxis(flight.heading / MIL, 0, -1).round(3).tolist(),
                "sigma_mil": np.moveaxis(flight.heading_sigma.mean(-1) / MIL, 0, -1).round(3).tolist(),
            }
        result["motions"][kind] = one
    say("closed form of an unknown delay")
    result["closed_form"] = sea_delay.against_simulation(model, scenario)
    say("two ways to handle a delay")
    result["ways"] = sea_delay.ways(model, scenario, runs=runs, seed=seed)
    result["bench"] = None
    if bench_runs:
        say(f"bench: {bench_runs} runs of {scenario.seconds} s, 400 Hz")
        result["bench"] = sea_bench.experiment(model, scenario, runs=bench_runs, seed=seed)
    if not histories and result["bench"]:
        del result["bench"]["history"]
    return result


def report(result: dict[str, Any]) -> str:
    """The sea-state table of each motion and the paper's claims under it; closed form, ways, bench; a verdict."""
    lines = []
    half, end = result["marks_s"]
    for one in result["motions"].values():
        lines += [
            f"{one['says']}  ({one['seconds']:g} s)",
            "  heading error in mil, mean and worst of the runs" + " " * 27 + "closed form      NIS of 6     NEES",
            f"  state   {half} s with    {end} s with   | {half} s without {end} s without   "
            "unknown delay    with  w/o     with",
        ]
        w, o = (one[name] for name in FILTERS)
        for g, grade in enumerate(result["grades"]):
            cells = [f"{part['mean_mil'][i][g]:6.2f}{part['worst_mil'][i][g]:7.2f}" for part in (w, o) for i in (0, 1)]
            lines.append(
                f"  {grade:3}  {cells[0]} {cells[1]} |{cells[2]} {cells[3]}   {one['predicted_mil'][g]:8.2f}      "
                f"{w['nis'][g]:7.2f}{o['nis'][g]:7.2f}  {w['nees'][g]:6.1f}"
            )
        for claim in one["claims"]:
            lines.append(f"  {'holds  ' if claim['holds'] else 'not so '} {claim['claim']}: {claim['numbers']}")
        lines.append("")
    lines.append(sea_delay.report(result["closed_form"], result["ways"]))
    if result["bench"]:
        lines.append(sea_bench.report(result["bench"]))
    held = {kind: sum(claim["holds"] for claim in one["claims"]) for kind, one in result["motions"].items()}
    low, high = result["nees_band"]
    lines.append(
        f"95 % bands: NEES of 16 states {low:.1f} to {high:.1f}, NIS {result['nis_band'][0]:.2f} to "
        f"{result['nis_band'][1]:.2f}"
    )
    lines.append(
        "sea-state: of the paper's six claims "
        + ", ".join(f"{count} hold under {kind}" for kind, count in held.items())
        + f" ({result['runs']} runs a state, seed {result['seed']})"
    )
    return "\n".join(lines)
