"""What decides Table 1 of Song and Lee, and how far their filter can be believed.

The paper leaves motion, heading, duration, the prior and the filter's noises open.  Each is varied here around the one
declared scenario of `euler_table`, with a count of cells for each choice; then the filter's covariance is held against
its errors, with misalignments from 0.1 to 3 degrees, and beyond the paper with an exact residual.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np

from boresight.analysis.consistency import chi_square_band
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.library import load
from boresight.runtime.simulation import sensors
from boresight.runtime.units import ARCMIN, DEG
from boresight.studies.euler_table import figures
from boresight.studies.euler_table import table as euler
from boresight.studies.study import Progress, Result, Seeded, Study, option, silent, table

# Departures in what the paper does not say, one line of the report each.
ALTERNATIVES: dict[str, dict[str, Any]] = {
    "filter told 1' (R) and 10' (P0)": {"filter_angle_arcmin": 1.0},
    "filter told 2' and 5'": {"filter_angle_arcmin": 2.0, "filter_offset_arcmin": 5.0},
    "filter told 5' and 10'": {"filter_angle_arcmin": 5.0},
    "Q reaches the bias after 30 s": {"bias_time_s": 30.0},
    "Q reaches the bias after 300 s": {"bias_time_s": 300.0},
    "motion starts at its extremes": {"motion_phase_deg": (90.0, 90.0, 90.0)},
    "periods twice as long": {"motion_period_s": (14.0, 10.0, 18.0)},
    "periods four times as long": {"motion_period_s": (28.0, 20.0, 36.0)},
    "one period, phases 0, 60, 120 deg": {
        "motion_period_s": (7.0, 7.0, 7.0),
        "motion_phase_deg": (0.0, 60.0, 120.0),
    },
    "heading 30 deg, cells in n e d": {"heading_deg": 30.0},
    "heading 90 deg, cells in n e d": {"heading_deg": 90.0},
    "heading 30 deg, platform axes": {"heading_deg": 30.0, "error_axes": "platform"},
    "heading 90 deg, platform axes": {"heading_deg": 90.0, "error_axes": "platform"},
    "latitude 0": {"latitude_deg": 0.0},
    "latitude 80 deg": {"latitude_deg": 80.0},
    "misalignment 1 deg": {"misalignment_deg": 1.0},
    "misalignment 5 deg": {"misalignment_deg": 5.0},
}
COMBINED = (
    ("heading-60", "platform-axes"),
    ("heading-60", "as-printed-26-28"),
    ("heading-60", "platform-axes", "as-printed-26-28"),
    ("normal-misalignment", "exact"),
)
CONSISTENCY_DEG = (0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 3.0)
# The paper's own numbers.
PLAIN = euler.Scenario(misalignment="normal", filter_angle_arcmin=1.0, filter_offset_arcmin=1.0)


SUMMARY = ("agree", "largest_estimated", "smallest_not_estimated")


def counted(model: Any, scenario: euler.Scenario, seconds: float, runs: int, seed: int) -> dict[str, Any]:
    """Cells out of 147 and the nearest cell's factor, by linear covariance and by Monte Carlo."""
    flight = euler.fly(model, scenario, seconds, runs=runs, seed=seed)
    out: dict[str, Any] = {"seconds": seconds, "seed": seed, "lost_runs": int(flight.lost.sum())}
    for part, history in (("linear", euler.covariance(model, scenario, seconds)), ("monte_carlo", flight.error)):
        verdict = euler.judged(euler.ratios(history), scenario.threshold)
        out[part] = {key: verdict[key] for key in SUMMARY}
        out[part]["margin"] = verdict["margin"]["factor"]
    return out


def drawn_motion(number: int) -> dict[str, Any]:
    """The motion of drawn set `number`: three periods from 4 to 12 s, three phases from the whole circle."""
    draw = sensors.generator(2001, number)
    period, phase = draw.uniform(4.0, 12.0, 3), draw.uniform(-180.0, 180.0, 3)
    return {"motion_period_s": tuple(period.tolist()), "motion_phase_deg": tuple(phase.tolist())}


def durations(
    model: Any,
    scenario: euler.Scenario,
    seconds: float = 3600.0,
    causes: Iterable[Sequence[bool]] = tuple(product((True, False), repeat=3)),
) -> list[dict[str, Any]]:
    """When the table of linear covariance is the paper's, with each cause of further information switched off in turn.

    causes: which cases, each (process noise, Earth rate, second order).
    process_noise, earth_rate, second_order: bool.  from_s and to_s: the first and the last update up to which all 147
    cells agree without a break.  first_more: the first cell estimated against the paper, or None by the end.
    smallest: the lowest ratio of the paper's not estimated cells, at time_s.
    """
    out = []
    times = np.unique(np.round(np.geomspace(1, seconds / scenario.update_s, 60)).astype(int))
    for noise, earth, second_order in causes:
        case = replace(scenario, gyro_bias_deg_h=scenario.gyro_bias_deg_h * noise, earth_rate=earth)
        history = euler.covariance(model, case, seconds, first_order=not second_order)
        ratio = history / history[0]
        estimated = ratio < case.threshold
        agree = np.flatnonzero((estimated == euler.PAPER).all((1, 2, 3)))
        whole = agree[: int(np.argmin(np.append(np.diff(agree), 0) == 1)) + 1]  # without a break
        more = estimated & ~euler.PAPER
        late = np.flatnonzero(more.any((1, 2, 3)))
        out.append(
            {
                "process_noise": noise,
                "earth_rate": earth,
                "second_order": second_order,
                "from_s": int(whole[0]) * case.update_s if len(whole) else None,
                "to_s": int(whole[-1]) * case.update_s if len(whole) else None,
                "first_more": euler.cell_name(np.argwhere(more[late[0]])[0]) if len(late) else None,
                "time_s": (times * case.update_s).tolist(),
                "smallest": ratio[:, ~euler.PAPER].min(axis=1)[times].tolist(),
            }
        )
    return out


def second_order(model: Any, scenario: euler.Scenario, misalignment_deg: float) -> dict[str, float]:
    """What (15) and (18) drop, at normal misalignments: the residual of perfect attitudes, which should be zero.

    Returns, in arcmin, the rms over cases and rows of its mean in time and of its variation in time, and of what the
    substitution of the missing master's angles adds to them.
    """
    euler_m = euler.motion(scenario, 60.0, scenario.update_s)[:, None, :, None]  # (T, 1, 7, 1, 3)
    mu = sensors.standard_normals(0, np.arange(20), 3) * misalignment_deg * DEG
    euler_b = model.euler_angles(q_b2n_wxyz=rotation.turned(rotation.quaternion_from_euler(euler_m), mu))
    rows = euler.CHOSEN[:, None, None, :]
    known = model.euler_z(euler_b=euler_b, euler_m=euler_m, mu=mu)
    substituted = model.euler_z(euler_b=euler_b, euler_m=np.where(rows, euler_m, euler_b), mu=mu)

    def rms(z: Array) -> tuple[float, float]:
        used = np.broadcast_to(rows, z.shape[1:])
        return tuple(float(np.sqrt(np.mean(np.square(part[used])))) / ARCMIN for part in (z.mean(0), z.std(0)))  # type: ignore[return-value]

    constant, varying = rms(np.broadcast_to(known, substituted.shape))
    added_constant, added_varying = rms(substituted - known)
    return {
        "constant_arcmin": constant,
        "varying_arcmin": varying,
        "substitution_constant_arcmin": added_constant,
        "substitution_varying_arcmin": added_varying,
    }


def consistency(
    model: Any,
    *,
    misalignment_deg: float,
    bias: bool,
    exact: bool = False,
    iterations: int = 3,
    turn_covariance: bool = True,
    told_arcmin: tuple[float, float] = (1.0, 1.0),
    runs: int = 50,
    seed: int = 0,
    seconds: float = 120.0,
) -> dict[str, Any]:
    """NEES and NIS of the 49 cases against their 95 % bands, at misalignments of N(0, misalignment_deg) an axis.

    The filter is told what is true: 1 arcmin, the misalignment's own sigma, Q = 0 without a bias and the Q of 1 deg/h
    with one.  told_arcmin: or other values, of `filter_angle_arcmin` and `filter_offset_arcmin`.

    nees: of six states, after `seconds`, mean over runs.  nis: mean over runs, updates and rows.  Of each: band, and
    over the 49 cases inside, above, below, mean, smallest, largest; of nees also inside_by_match and above_by_match,
    counts of the 7 motions, and of_all_angles, the seven values when all three angles are matched.
    """
    scenario = replace(PLAIN, misalignment_deg=misalignment_deg, gyro_bias_deg_h=PLAIN.gyro_bias_deg_h * bias)
    scenario = replace(scenario, filter_angle_arcmin=told_arcmin[0], filter_offset_arcmin=told_arcmin[1])
    if exact:
        scenario = replace(scenario, measurement="euler_exact", iterations=iterations, turn_covariance=turn_covariance)
    flight = euler.fly(model, scenario, seconds, runs=runs, seed=seed)
    angles = euler.CHOSEN.sum(-1)[:, None]
    out: dict[str, Any] = {
        "misalignment_deg": misalignment_deg,
        "bias": bias,
        "exact": exact,
        "iterations": iterations if exact else 1,
        "turn_covariance": exact and turn_covariance,
        "told_arcmin": list(told_arcmin),
        "runs": runs,
        "lost_runs": int(flight.lost.sum()),
    }
    nees = flight.nees.mean(-1)
    out["nees"], inside, above = against_band(nees, *chi_square_band(6, runs))
    for name, which in (("inside", inside), ("above", above)):
        out["nees"][f"{name}_by_match"] = dict(zip(euler.NAMES, which.sum(-1).tolist(), strict=True))
    out["nees"]["of_all_angles"] = nees[-1].tolist()
    bands = np.array([chi_square_band(1, n * runs * len(flight.nis)) for n in angles[:, 0]])
    out["nis"], *_ = against_band(flight.nis.mean(axis=(0, -1)) / angles, bands[:, :1], bands[:, 1:])
    return out


def against_band(value: Array, low: Any, high: Any) -> tuple[dict[str, Any], Array, Array]:
    """How many of the 49 cases lie in their 95 % bands, and which lie inside and which above."""
    inside, above = (value > low) & (value < high), value >= high
    counts = {"inside": int(inside.sum()), "above": int(above.sum()), "below": int(np.sum(value <= low))}
    extent = {"mean": float(value.mean()), "smallest": float(value.min()), "largest": float(value.max())}
    return {"band": [float(np.min(low)), float(np.max(high))], **counts, **extent}, inside, above


def consistency_cases() -> Sequence[dict[str, Any]]:
    exact = {"misalignment_deg": 3.0, "bias": False, "exact": True}
    return [
        *({"misalignment_deg": size, "bias": bias} for bias in (False, True) for size in CONSISTENCY_DEG),
        {**exact, "misalignment_deg": 1.0},
        exact,
        {**exact, "bias": True},
        {"misalignment_deg": 3.0, "bias": True, "told_arcmin": (3.0, 10.0)},
        {**exact, "iterations": 1},
        {**exact, "turn_covariance": False},
    ]


@dataclass(frozen=True)
class Asked(Seeded):
    drawn: int = option(12, "Drawn sets of periods and phases.")


def run(asked: Asked, progress: Progress = silent, model: Any = None) -> Result:
    """Everything that docs/euler-matching.md counts:

    seeds, durations_monte_carlo, drawn, drawn_text_noises, alternatives, switches: lists of
    {name, ..., linear, monte_carlo} as `counted` gives them; durations, durations_text_noises, second_order,
    consistency: lists, as the functions give them; finished: false if it was interrupted, and then
    later parts are missing.
    """
    model, declared = model or load("euler-matching"), euler.Scenario()
    result: Result = {"runs": asked.runs, "seed": asked.seed, "finished": False}
    as_text = euler.SWITCHES["text-noises"].changes
    motions = [(f"set {number}", drawn_motion(number)) for number in range(asked.drawn)]
    varied: dict[str, list[tuple[str, dict[str, Any]]]] = {
        "seeds": [(f"seed {key}", {"seed": key}) for key in range(asked.seed, asked.seed + 3)],
        "durations_monte_carlo": [
            (f"{seconds:g} s", {"seconds": seconds}) for seconds in (30.0, 60.0, 120.0, 200.0, 300.0)
        ],
        "drawn": motions,
        "drawn_text_noises": [(name, {**as_text, **drawn}) for name, drawn in motions],
        "alternatives": list(ALTERNATIVES.items()),
        "switches": [(" ".join(one), {"switch": one}) for one in [*((name,) for name in euler.SWITCHES), *COMBINED]],
    }
    try:
        for part, cases in varied.items():
            for name, changes in cases:
                progress(f"{part}: {name}")
                case = replace(declared, **{"seed": asked.seed, **changes})
                other, case = euler.switched(model, case, case.switch)
                counts = counted(other, case, case.seconds, asked.runs, case.seed)
                result.setdefault(part, []).append({"name": name, **counts})
        progress("durations, to an hour")
        result["durations"] = durations(model, declared)
        result["durations_text_noises"] = durations(model, replace(declared, **as_text), 1800.0)
        progress("consistency")
        result["second_order"] = [
            {"misalignment_deg": size, **second_order(model, PLAIN, size)} for size in CONSISTENCY_DEG
        ]
        result["consistency"] = [consistency(model, seed=asked.seed, **case) for case in consistency_cases()]
        result["finished"] = True
    except KeyboardInterrupt:
        progress("interrupted")
    return result


TITLES = {
    "seeds": "Seeds, 120 s",
    "durations_monte_carlo": "Duration",
    "drawn": "Drawn periods and phases, 120 s",
    "drawn_text_noises": "The same, filter told 1' and 1'",
    "alternatives": "What the paper leaves open, 120 s",
    "switches": "Switches, 120 s",
}
UNTIL = {
    "durations": "All 147 cells by linear covariance, up to an hour",
    "durations_text_noises": "The same, filter told 1' and 1', up to half an hour",
}
CAUSES = {"process_noise": "process noise", "earth_rate": "Earth rate", "second_order": "second-order motion"}


def report(result: Result) -> str:
    """The exploration as text, section by section."""
    head: tuple[str, ...]
    lines = ["Cells out of 147; largest ratio of the paper's estimated, smallest of the others"]
    for part in (part for part in TITLES if part in result):
        rows = [
            (row["name"], *(row[kind][key] for kind in ("linear", "monte_carlo") for key in SUMMARY), row["lost_runs"])
            for row in result[part]
        ]
        head = (TITLES[part], "(a)", "O <=", "X >=", "(b)", "O <=", "X >=", "lost")
        lines += ["", *table(head, rows, ["", "d", ".3f", ".3f", "d", ".3f", ".3f", "d"])]
    for part in (part for part in UNTIL if part in result):
        rows = [
            (*(row[key] for key in CAUSES), row["from_s"], row["to_s"], row["first_more"] or "nothing")
            for row in result[part]
        ]
        lines += ["", UNTIL[part], *table((*CAUSES.values(), "from, s", "to, s", "then"), rows, "g")]
    if "second_order" in result:
        head = ("", "constant", "varying", "substitution adds: constant", "varying")
        rows = [(f"misalignment {size:g} deg", *values) for size, *values in map(dict.values, result["second_order"])]
        lines += ["", "What (15), (18) drop, arcmin, rms", *table(head, rows, ".3f")]
    if "consistency" in result:
        head = ("Consistency, 50 runs", "NEES inside", "above", "below", "mean", "max", "NIS inside", "above", "max")
        keys = [("nees", key) for key in ("inside", "above", "below", "mean", "largest")]
        keys += [("nis", key) for key in ("inside", "above", "largest")]
        formats = ["", "d", "d", "d", ".2f", ".2f", "d", "d", ".3f"]
        rows = [(says(row), *(row[part][key] for part, key in keys)) for row in result["consistency"]]
        lines += ["", *table(head, rows, formats)]
        exact = [row for row in result["consistency"] if row["exact"]]
        head = ("of 7 motions inside (above)", *(name.replace(", ", "+") for name in euler.NAMES))
        lines += table(head, [
            (says(row), *(f"{inside} ({above})" for inside, above in zip(
                *(row["nees"][f"{name}_by_match"].values() for name in ("inside", "above")), strict=True)))
            for row in exact
        ])  # fmt: skip
    if not result["finished"]:
        lines.append("interrupted: what follows is missing")
    return "\n".join(lines)


def says(row: dict[str, Any]) -> str:
    """What was flown in a row of the consistency."""
    name = f"{row['misalignment_deg']:g} deg, " + ("1 deg/h and its Q" if row["bias"] else "no bias, Q = 0")
    if row["told_arcmin"] != [1.0, 1.0]:
        name += f", told {row['told_arcmin'][0]:g}' and {row['told_arcmin'][1]:g}'"
    if row["exact"]:
        name += f", exact x{row['iterations']}" + ("" if row["turn_covariance"] else ", P not turned")
    return name


STUDY = Study("euler-exploration", ("euler-matching",), Asked, run, report, figures.explored,
              good=lambda result: result["finished"])  # fmt: skip
