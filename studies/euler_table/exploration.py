"""What decides Table 1 of Song and Lee, and how far their filter can be believed.

The paper leaves motion, heading, duration, the prior and the filter's noises open.  Each is varied here around the one
declared scenario of `euler_table`, with a count of cells for each choice; then the filter's covariance is held against
its errors, with misalignments from 0.1 to 3 degrees, and beyond the paper with an exact residual.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.simulation import sensors
from boresight.runtime.units import ARCMIN, DEG
from boresight.studies.euler_table.table import (
    CHOSEN,
    NAMES,
    PAPER,
    SWITCHES,
    Scenario,
    cell_name,
    covariance,
    fly,
    judged,
    motion,
    ratios,
    switched,
)

Progress = Callable[[str], None]

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
PLAIN = Scenario(misalignment="normal", filter_angle_arcmin=1.0, filter_offset_arcmin=1.0)  # the paper's own numbers


def counted(model: Any, scenario: Scenario, seconds: float, runs: int, seed: int) -> dict[str, Any]:
    """Cells out of 147 and the nearest cell's factor, by linear covariance and by Monte Carlo."""
    flight = fly(model, scenario, seconds, runs=runs, seed=seed)
    out: dict[str, Any] = {"seconds": seconds, "seed": seed, "lost_runs": int(flight.lost.sum())}
    for part, history in (("linear", covariance(model, scenario, seconds)), ("monte_carlo", flight.error)):
        verdict = judged(ratios(history), scenario.threshold)
        out[part] = {key: verdict[key] for key in ("agree", "largest_estimated", "smallest_not_estimated")}
        out[part]["margin"] = verdict["margin"]["factor"]
    return out


def drawn_motion(number: int) -> dict[str, Any]:
    """The motion of drawn set `number`: three periods from 4 to 12 s, three phases from the whole circle."""
    draw = sensors.generator(2001, number)
    period, phase = draw.uniform(4.0, 12.0, 3), draw.uniform(-180.0, 180.0, 3)
    return {"motion_period_s": tuple(period.tolist()), "motion_phase_deg": tuple(phase.tolist())}


def durations(model: Any, scenario: Scenario, seconds: float = 3600.0) -> list[dict[str, Any]]:
    """When the table of linear covariance is the paper's, with each cause of further information switched off in turn.

    process_noise, earth_rate, second_order: bool.  from_s and to_s: the first and the last update up to which all 147
    cells agree without a break.  first_more: the first cell estimated against the paper, or None by the end.
    smallest: the lowest ratio of the paper's not estimated cells, at time_s.
    """
    out = []
    times = np.unique(np.round(np.geomspace(1, seconds / scenario.update_s, 60)).astype(int))
    for bias in (scenario.gyro_bias_deg_h, 0.0):
        for earth in (True, False):
            for second_order in (True, False):
                case = replace(scenario, gyro_bias_deg_h=bias, earth_rate=earth)
                history = covariance(model, case, seconds, first_order=not second_order)
                ratio = history / history[0]
                agree = np.sum((ratio < case.threshold) == PAPER, axis=(1, 2, 3)) == PAPER.size
                more = (ratio < case.threshold) & ~PAPER
                begin = int(np.argmax(agree)) if agree.any() else None
                end = None
                if begin is not None:
                    end = len(agree) - 1 if agree[begin:].all() else begin + int(np.argmin(agree[begin:])) - 1
                late = more.any((1, 2, 3))
                out.append(
                    {
                        "process_noise": bool(bias),
                        "earth_rate": earth,
                        "second_order": second_order,
                        "from_s": begin if begin is None else begin * case.update_s,
                        "to_s": end if end is None else end * case.update_s,
                        "first_more": cell_name(np.argwhere(more[np.argmax(late)])[0]) if late.any() else None,
                        "time_s": (times * case.update_s).tolist(),
                        "smallest": ratio[:, ~PAPER].min(axis=1)[times].tolist(),
                    }
                )
    return out


def second_order(model: Any, scenario: Scenario, misalignment_deg: float) -> dict[str, float]:
    """What (15) and (18) drop, at normal misalignments: the residual of perfect attitudes, which should be zero.

    Returns, in arcmin, the rms over cases and rows of its mean in time and of its variation in time, and of what the
    substitution of the missing master's angles adds to them.
    """
    euler_m = motion(scenario, 60.0, scenario.update_s)[:, None, :, None]  # (T, 1, 7, 1, 3)
    mu = sensors.standard_normals(0, np.arange(20), 3) * misalignment_deg * DEG
    euler_b = model.euler_angles(q_b2n_wxyz=rotation.turned(rotation.quaternion_from_euler(euler_m), mu))
    rows = CHOSEN[:, None, None, :]
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
    from scipy.stats import chi2

    scenario = replace(PLAIN, misalignment_deg=misalignment_deg, gyro_bias_deg_h=PLAIN.gyro_bias_deg_h * bias)
    scenario = replace(scenario, filter_angle_arcmin=told_arcmin[0], filter_offset_arcmin=told_arcmin[1])
    if exact:
        scenario = replace(scenario, measurement="euler_exact", iterations=iterations, turn_covariance=turn_covariance)
    flight = fly(model, scenario, seconds, runs=runs, seed=seed)
    angles = CHOSEN.sum(-1)[:, None]
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
    of_rows = flight.nis.mean(axis=(0, -1)) / angles
    samples = {"nees": (flight.nees.mean(-1), np.array(6), runs), "nis": (of_rows, angles, runs * len(flight.nis))}
    for name, (value, freedom, count) in samples.items():
        unit = 1 if name == "nees" else freedom
        low, high = (chi2.ppf(p, freedom * count) / count / unit for p in (0.025, 0.975))
        out[name] = {
            "band": [float(np.min(low)), float(np.max(high))],
            "inside": int(np.sum((value > low) & (value < high))),
            "above": int(np.sum(value >= high)),
            "below": int(np.sum(value <= low)),
            "mean": float(value.mean()),
            "smallest": float(value.min()),
            "largest": float(value.max()),
        }
    low, high = out["nees"]["band"]
    value = flight.nees.mean(-1)
    out["nees"]["inside_by_match"] = dict(zip(NAMES, ((value > low) & (value < high)).sum(-1).tolist(), strict=True))
    out["nees"]["above_by_match"] = dict(zip(NAMES, (value >= high).sum(-1).tolist(), strict=True))
    out["nees"]["of_all_angles"] = value[-1].tolist()
    return out


def explore(
    model: Any,
    *,
    runs: int = 20,
    seed: int = 0,
    drawn: int = 12,
    scenario: Scenario | None = None,
    progress: Progress | None = None,
) -> dict[str, Any]:
    """Everything that docs/euler-matching.md counts.  The result can be written as JSON:

    study, runs, seed; seeds, durations_monte_carlo, drawn, drawn_text_noises, alternatives, switches: lists of
    {name, ..., linear, monte_carlo} as `counted` gives them; durations, durations_text_noises, second_order,
    consistency: lists, as the functions give them; finished: false if it was interrupted, and then
    later parts are missing.
    """
    say, declared = progress or (lambda line: None), scenario or Scenario()
    result: dict[str, Any] = {"study": "euler-table", "runs": runs, "seed": seed, "finished": False}

    def count(part: str, name: str, case: Scenario, seconds: float = 120.0, key: int = seed, using: Any = None) -> None:
        say(f"{part}: {name}")
        counts = counted(using or model, case, seconds, runs, key)
        result.setdefault(part, []).append({"name": name, **counts})

    try:
        for key in range(seed, seed + 3):
            count("seeds", f"seed {key}", declared, key=key)
        for seconds in (30.0, 60.0, 120.0, 200.0, 300.0):
            count("durations_monte_carlo", f"{seconds:g} s", declared, seconds)
        say("durations, to an hour")
        result["durations"] = durations(model, declared)
        as_text = replace(declared, **SWITCHES["text-noises"].changes)
        result["durations_text_noises"] = durations(model, as_text, 1800.0)
        for number in range(drawn):
            drawn_set = drawn_motion(number)
            count("drawn", f"set {number}", replace(declared, **drawn_set))
            result["drawn"][-1].update(drawn_set)
        for number in range(drawn):  # the noises as the text has them
            told = {**SWITCHES["text-noises"].changes, **drawn_motion(number)}
            count("drawn_text_noises", f"set {number}", replace(declared, **told))
        for name, changes in ALTERNATIVES.items():
            count("alternatives", name, replace(declared, **changes))
        for names in [(name,) for name in SWITCHES] + list(COMBINED):
            other, case = switched(model, declared, names)
            count("switches", " ".join(names), case, using=other)
        say("consistency")
        result["second_order"] = [
            {"misalignment_deg": size, **second_order(model, PLAIN, size)} for size in CONSISTENCY_DEG
        ]
        result["consistency"] = []
        for case_of in consistency_cases():
            result["consistency"].append(consistency(model, seed=seed, **case_of))
        result["finished"] = True
    except KeyboardInterrupt:
        say("interrupted")
    return result


def consistency_cases() -> Sequence[dict[str, Any]]:
    cases: list[dict[str, Any]] = []
    for bias in (False, True):
        cases += [{"misalignment_deg": size, "bias": bias} for size in CONSISTENCY_DEG]
    for bias in (False, True):
        cases += [
            {"misalignment_deg": size, "bias": bias, "exact": True} for size in ((1.0, 3.0) if not bias else (3.0,))
        ]
    cases.append({"misalignment_deg": 3.0, "bias": True, "told_arcmin": (3.0, 10.0)})
    cases.append({"misalignment_deg": 3.0, "bias": False, "exact": True, "iterations": 1})
    cases.append({"misalignment_deg": 3.0, "bias": False, "exact": True, "turn_covariance": False})
    return cases


def report(result: dict[str, Any]) -> str:
    """The exploration as text, section by section."""
    lines = [f"{'':46}{'(a) linear':>22}{'(b) Monte Carlo':>24}"]
    head = f"{'':46}{'cells':>7}{'O <=':>8}{'X >=':>7}{'cells':>9}{'O <=':>8}{'X >=':>7}   lost"
    titles = {
        "seeds": "Seeds, 120 s",
        "durations_monte_carlo": "Duration",
        "drawn": "Drawn periods and phases, 120 s",
        "drawn_text_noises": "The same, filter told 1' and 1'",
        "alternatives": "What the paper leaves open, 120 s",
        "switches": "Switches, 120 s",
    }
    lines.append(head)
    for part, title in titles.items():
        if part not in result:
            continue
        lines.append(title)
        for row in result[part]:
            cells = [
                f"{row[way]['agree']:7d}{row[way]['largest_estimated']:8.3f}{row[way]['smallest_not_estimated']:7.3f}"
                for way in ("linear", "monte_carlo")
            ]
            lines.append(f"  {row['name']:44}" + "  ".join(cells) + f"{row['lost_runs']:7d}")
    for part, title in (
        ("durations", "All 147 cells by linear covariance, up to an hour"),
        ("durations_text_noises", "The same, filter told 1' and 1', up to half an hour"),
    ):
        if part in result:
            lines += ["", title]
        for row in result.get(part, []):
            parts = [
                f"{word} {'on ' if row[key] else 'off'}"
                for word, key in (
                    ("process noise", "process_noise"),
                    ("Earth rate", "earth_rate"),
                    ("second-order motion", "second_order"),
                )
            ]
            then = f"; then {row['first_more']}" if row["first_more"] else ""
            lines.append(f"  {', '.join(parts)}: from {row['from_s']:g} s to {row['to_s']:g} s{then}")
    if "second_order" in result:
        lines += ["", "What (15), (18) drop [arcmin, rms]    constant  varying   substitution adds: constant  varying"]
        for row in result["second_order"]:
            lines.append(
                f"  misalignment {row['misalignment_deg']:4g} deg {row['constant_arcmin']:22.3f}"
                f"{row['varying_arcmin']:9.3f}{row['substitution_constant_arcmin']:29.3f}{row['substitution_varying_arcmin']:9.3f}"
            )
    if "consistency" in result:
        lines += [
            "",
            f"{'Consistency, 50 runs':52}{'NEES inside/above/below':>26}{'mean':>9}{'max':>9}   NIS in/above  max",
        ]
        for row in result["consistency"]:
            name = f"{row['misalignment_deg']:g} deg, " + ("1 deg/h and its Q" if row["bias"] else "no bias, Q = 0")
            if row["told_arcmin"] != [1.0, 1.0]:
                name += f", told {row['told_arcmin'][0]:g}' and {row['told_arcmin'][1]:g}'"
            if row["exact"]:
                name += f", exact x{row['iterations']}" + ("" if row["turn_covariance"] else ", P not turned")
            nees, nis = row["nees"], row["nis"]
            lines.append(
                f"  {name:50}{nees['inside']:12d}/{nees['above']:2d}/{nees['below']:2d}{nees['mean']:17.2f}"
                f"{nees['largest']:9.2f}   {nis['inside']:6d}/{nis['above']:2d} {nis['largest']:7.3f}"
            )
            if row["exact"]:
                lines.append(
                    "      of 7 motions inside (above): "
                    + "; ".join(f"{m} {n} ({nees['above_by_match'][m]})" for m, n in nees["inside_by_match"].items())
                )
    if not result["finished"]:
        lines.append("interrupted: what follows is missing")
    return "\n".join(lines)
