"""The experiment of Kang and others (2025): transfer alignment in sea states 1 to 6, with and without the delay.

240 runs under each of three motions, the paper's claims judged by numbers, the closed form of an uncompensated delay
against the simulation, and the bench.  docs/sea-state.md tells the story; `flight` flies.
"""

from itertools import pairwise
from time import perf_counter
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.consistency import chi_square_band, nees
from boresight.analysis.observability import since
from boresight.runtime.library import load
from boresight.runtime.units import MIL
from boresight.studies.sea_state import bench, delay, figures
from boresight.studies.sea_state import flight as at_sea
from boresight.studies.study import Claim, Progress, Result, Study, claim_lines, silent, table

LIMIT_MIL = 2.0  # the paper's


def marks_s(scenario: at_sea.Scenario) -> tuple[int, int]:
    """Half of a run and all of it: 30 and 60 s."""
    return scenario.seconds // 2, scenario.seconds


def table_of(flight: at_sea.Flight, scenario: at_sea.Scenario) -> dict[str, Any]:
    """What `run` says of one motion, filter by filter and sea state by sea state."""
    h, sigma = flight.heading / MIL, flight.heading_sigma / MIL
    marks = [mark * scenario.update_hz for mark in marks_s(scenario)]
    late = slice(marks[0], None)
    size = np.abs(h).mean(-1)  # (U + 1, 2, 6)
    below_s = since(size < LIMIT_MIL) / scenario.update_hz
    time = np.arange(len(h[late]))[:, None, None, None]
    line = np.polynomial.polynomial.polyfit(time.ravel(), h[late].reshape(len(time), -1), 1)
    fitted = (line[0] + line[1] * time.reshape(-1, 1)).reshape(h[late].shape)
    wander = (h[late] - fitted).std(axis=0).mean(-1)
    out: dict[str, Any] = {}
    for i, name in enumerate(at_sea.FILTERS):
        known = slice(0, 16 if name == "with" else 15)  # the delay that is not estimated is in no covariance
        e, P = flight.error[-1, i][..., known], flight.P[i][..., known, known]
        out[name] = {
            "mean_mil": size[marks, i].tolist(),
            "worst_mil": np.abs(h[marks, i]).max(-1).tolist(),
            "signed_mil": h[marks, i].mean(-1).tolist(),
            "sigma_mil": sigma[marks, i].mean(-1).tolist(),
            "below_limit_s": [None if np.isnan(at) else float(at) for at in below_s[i]],
            "wander_mil": wander[i].tolist(),
            "nis": flight.settled_nis[i].tolist(),
            "nees": nees(e, P).mean(-1).tolist(),
            "nees_of": e.shape[-1],
        }
    return out


def claims_of(one: dict[str, Any], scenario: at_sea.Scenario, motion: str) -> list[Claim]:
    """The paper's six, judged for one motion."""
    half, end = marks_s(scenario)
    w, o = (one[name] for name in at_sea.FILTERS)
    at_half, at_end, bare_end = (np.array(mean) for mean in (*w["mean_mil"][:2], o["mean_mil"][1]))
    below_s = [np.inf if at is None else at for at in w["below_limit_s"]]
    gain = bare_end - at_end
    wander, steady = np.array(o["wander_mil"])[2:], np.array(w["wander_mil"])[2:]
    rough = slice(2, None)

    def states(values: Any, first: int = 3, what: str = "") -> dict[str, float | None]:
        numbers = (float(value) if np.isfinite(value) else None for value in values)
        return {f"{what}state {first + i}": value for i, value in enumerate(numbers)}

    judged: list[tuple[str, Any, dict[str, float | None]]] = [
        (f"up to state 2 it does not converge, mil after {end} s", (at_end[:2] > LIMIT_MIL).all(),
         states(at_end[:2], 1)),
        (f"from state 3 on under 2 mil within about 30 s with compensation, mil after {half} s",
         (at_half[rough] < LIMIT_MIL).all() and (at_end[rough] < LIMIT_MIL).all(), states(at_half[rough])),
        (f"states 4 to 6 exceed 2 mil without, state 3 does not, mil after {end} s",
         (bare_end[3:] > LIMIT_MIL).all() and bare_end[2] <= LIMIT_MIL, states(bare_end[rough])),
        ("the rougher, the faster, s until for good below 2 mil",
         all(a >= b for a, b in pairwise(below_s[2:])) and below_s[2] > below_s[-1], states(below_s[2:])),
        ("compensation matters more as the sea grows, mil less",
         (np.diff(gain[rough]) > 0).all() and gain[-1] > LIMIT_MIL / 10, states(gain[rough])),
        ("uncompensated the estimate oscillates more with grade, mil about a line",
         (np.diff(wander) > 0).all() and (np.diff(wander / steady) > 0).all(),
         states(wander) | states(steady, what="with, ")),
    ]  # fmt: skip
    return [Claim(f"{motion}: {says}", bool(holds), numbers) for says, holds, numbers in judged]


def claims(result: Result) -> list[Claim]:
    """Of every motion."""
    return [Claim(**claim) for one in result["motions"].values() for claim in one["claims"]]


def run(scenario: at_sea.Scenario, progress: Progress = silent, model: Any = None) -> Result:
    """The experiment under each motion: runs, seed, grades, filters, limit_mil, marks_s;

    nees_band, nis_band: 95 % bands of the means below, of 16 and of 6 degrees of freedom;
    motions: NAME -> says; with, without: mean_mil, worst_mil, signed_mil, sigma_mil (2 marks, 6 states) of the heading
    error, below_limit_s (6, null where never), wander_mil (6, deviation from a straight line after half), nis (6, of
    six rows, after 10 s), nees (6, at the end) of nees_of states; predicted_mil (6, what an unknown delay does by the
    closed form, mean over the runs); claims; seconds: what it took;
    closed_form: of `delay.against_simulation`; ways: of `delay.ways`, under the motion "slope"; bench: of
    `bench.experiment` (both null with no bench_runs);
    history: time_s; NAME -> heading_mil (T, 2, 6, runs), sigma_mil (T, 2, 6); bench.
    """
    scenario = at_sea.checked(scenario)
    runs, seed = scenario.runs, scenario.seed
    if scenario.seconds < 2 * at_sea.SETTLED_S:
        raise BoresightError(f"sea-state: seconds is {scenario.seconds}; it must be at least {2 * at_sea.SETTLED_S}")
    if runs < 2:
        raise BoresightError(f"sea-state needs at least 2 runs; got {runs}")
    model = model or load("velocity-attitude")
    updates = scenario.seconds * scenario.update_hz
    history: dict[str, Any] = {"time_s": np.arange(updates + 1) / scenario.update_hz}
    result: Result = {
        "runs": runs,
        "seed": seed,
        "grades": list(at_sea.GRADES),
        "filters": list(at_sea.FILTERS),
        "limit_mil": LIMIT_MIL,
        "marks_s": list(marks_s(scenario)),
        "nees_band": chi_square_band(16, runs),
        "nis_band": chi_square_band(6, runs * (updates - at_sea.SETTLED_S * scenario.update_hz)),
        "motions": {},
        "history": history,
    }
    slope = None
    for kind in scenario.motions:
        progress(f"{at_sea.MOTIONS[kind]}: {2 * len(at_sea.GRADES) * runs} runs of {scenario.seconds} s")
        begun = perf_counter()
        flight = at_sea.fly(model, kind, scenario, runs=runs, seed=seed)
        slope = flight if kind == "slope" else slope
        one = {"says": at_sea.MOTIONS[kind], **table_of(flight, scenario)}
        motion = at_sea.motion_of(kind, scenario, at_sea.draw(scenario, seed, runs).streams)
        one["predicted_mil"] = (delay.predicted_heading(motion, flight.delay) / MIL).mean(-1).tolist()
        one["claims"] = [vars(claim) for claim in claims_of(one, scenario, kind)]
        one["seconds"] = round(perf_counter() - begun, 1)
        sigma = flight.heading_sigma.mean(-1) / MIL
        history[kind] = {"heading_mil": flight.heading / MIL, "sigma_mil": sigma}
        result["motions"][kind] = one
    progress("closed form of an unknown delay")
    result["closed_form"] = delay.against_simulation(model, scenario)
    result["ways"] = result["bench"] = None
    if scenario.bench_runs:
        progress("two ways to handle a delay")
        result["ways"] = delay.ways(model, scenario, runs=runs, seed=seed, flown=slope)
        progress(f"bench: {scenario.bench_runs} runs of {scenario.seconds} s, 400 Hz")
        result["bench"], history["bench"] = bench.experiment(model, scenario, runs=scenario.bench_runs, seed=seed)
    return result


def report(result: Result) -> str:
    """The sea-state table of each motion and the paper's claims under it; closed form, ways, bench."""
    half, end = result["marks_s"]
    head = ["state", *(f"{mark} s {name}" for name in at_sea.FILTERS for mark in (half, end)), "closed form",
            "NIS of 6", "w/o", "NEES of 16"]  # fmt: skip
    lines = [f"transfer alignment at sea: {result['runs']} runs a state, seed {result['seed']}"]
    for one in result["motions"].values():
        w, o = (one[name] for name in at_sea.FILTERS)
        cells = [list(zip(part["mean_mil"][i], part["worst_mil"][i], strict=True)) for part in (w, o) for i in (0, 1)]
        rows = zip(map(str, result["grades"]), *cells, one["predicted_mil"], w["nis"], o["nis"], w["nees"], strict=True)
        lines += [
            "",
            f"{one['says']}  ({one['seconds']:g} s)",
            "  heading error in mil, mean and worst of the runs",
            *table(head, rows, [*[".2f"] * 8, ".1f"]),
            *claim_lines(Claim(**claim) for claim in one["claims"]),
        ]
    lines += ["", *delay.report(result["closed_form"], result["ways"])]
    if result["bench"]:
        lines += ["", *bench.report(result["bench"])]
    bands = ("{} {:.2f} to {:.2f}".format(name, *result[f"{name.lower()}_band"]) for name in ("NEES", "NIS"))
    return "\n".join([*lines, f"95 % bands: {', '.join(bands)}"])


STUDY = Study("sea-state", ("velocity-attitude",), at_sea.Scenario, run, report, figures.draw, claims)
