"""What a sea shows of the errors of transfer alignment, and what to do when it does not.

Four questions around the study sea-state: which of nineteen errors each motion of a hull makes estimable, and how
soon; which manoeuvre makes the heading estimable in a calm; what it costs to match the attitude by DCM, quaternion or
Euler angles, or by fewer angles; and how far the heading may be unknown at the start.  docs/sea-exploration.md has the
numbers.

Axes of arrays: time, then cases or motions, then runs; then components.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from boresight.analysis.consistency import chi_square_band
from boresight.analysis.figures import BLUE, ORANGE, Sheets
from boresight.analysis.observability import Moment, along, since
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.headings import SPACING
from boresight.runtime.library import load
from boresight.runtime.simulation import hull, sensors
from boresight.runtime.simulation.motions import ramp, swinging, underway
from boresight.runtime.units import DEG, MIL, STANDARD_GRAVITY
from boresight.studies.sea_state import flight as at_sea
from boresight.studies.sea_state import live
from boresight.studies.study import Claim, Progress, Result, Seeded, Study, option, silent, table

DECLARED = at_sea.Scenario()
STATES = ("phi_n", "phi_e", "phi_d", "dv_n", "dv_e", "dv_d", "gyro x", "gyro y", "gyro z", "accel x", "accel y",
          "accel z", "mu_x", "mu_y", "mu_z", "delay", "lever x", "lever y", "lever z")  # fmt: skip
HEADING = 2
THRESHOLD = 1 / 3  # as in Table 1 of Song and Lee
RULE_MIL_M_S = 7.0  # heading sigma times the change of velocity in a calm, as `manoeuvres` finds it
SEAS = 5  # random seas of one grade, of which the median is told


# ---- motions


def motions(time: Array, seed: int) -> dict[str, hull.Pose]:
    """The master's motions by name, each (T, K, ...): K = 1, or SEAS random seas."""
    out = {
        "rest": swinging(time),
        "heave 1 m": swinging(time, heave=1.0),
        "roll 3 deg": swinging(time, roll=3.0),
        "pitch 3 deg": swinging(time, pitch=3.0),
        "yaw 3 deg": swinging(time, yaw=3.0),
        "roll + pitch in phase": swinging(time, roll=3.0, pitch=3.0),
        "roll + pitch 90 deg": swinging(time, roll=3.0, pitch=3.0, phase_deg=90.0),
        "straight 5 m/s": underway(time, speed=5.0),
        "yaw turns +-30 deg, 5 m/s": underway(time, 30 * DEG * np.sin(2 * np.pi * time / 60), 5.0),
        "figure of eight, 5 m/s": underway(time, np.pi * (1 - np.cos(2 * np.pi * time / 120)), 5.0),
        "one turn of 90 deg, 5 m/s": underway(time, ramp(time, 5.0, 20.0, 90 * DEG), 5.0),
        "surge 0 to 5 m/s in 10 s": underway(time, speed=ramp(time, 5.0, 10.0, 5.0)),
    }
    streams = [sensors.generator(seed, run) for run in range(SEAS)]
    for kind, letter in (("slope", "b"), ("sea", "c")):
        poses = hull.ride(at_sea.motion_of(kind, DECLARED, streams), time)
        out |= {f"({letter}) sea state {grade}": at_grade(poses, i) for i, grade in enumerate(at_sea.GRADES)}
    return out


FIELDS = ("displacement_n", "v_n", "a_n", "q_b2n_wxyz", "omega_nb_b", "alpha_nb_b")


def at_grade(pose: hull.Pose, i: int) -> hull.Pose:
    return replace(pose, **{name: getattr(pose, name)[:, i] for name in FIELDS})


def beside(poses: list[hull.Pose]) -> hull.Pose:
    """Poses of the same times as one, side by side."""
    return hull.Pose(poses[0].time, *(np.concatenate([getattr(p, name) for p in poses], axis=1) for name in FIELDS))


# ---- what a motion shows


def initial(model: Any, C_m2n: Array, scenario: at_sea.Scenario) -> Array:
    """P0 (..., 19, 19): that of the study, and the lever arm's; the attitude is the misalignment's image."""
    return at_sea.begin(model, scenario, at_sea.Belief(), v_m_n=np.zeros((*C_m2n.shape[:-2], 3)), position=np.zeros(3),
                        q_m2n_wxyz=rotation.quaternion_from_matrix(C_m2n))[1]  # fmt: skip


def covariances(model: Any, master: hull.Pose, scenario: at_sea.Scenario) -> Array:
    """Sigmas (U + 1, K, 19) at the updates, of the filter's covariance along the true motion.

    master: sampled in the middle of the steps of the covariance and at their ends: 2 N + 1 times.  The specific force
    leaves out Coriolis and transport rate: 1e-3 m/s^2 at 5 m/s.
    """
    s = scenario
    per_update, dt = s.covariance_hz // s.update_hz, 1 / s.covariance_hz
    slave = hull.carried(master, np.array(s.lever_b), np.array([1.0, 0, 0, 0]))
    C_n2b = np.swapaxes(rotation.matrix_from_quaternion(slave.q_b2n_wxyz), -1, -2)

    def to_b(vector_n: Array) -> Array:
        return np.einsum("...ij,...j->...i", C_n2b, vector_n)

    f_b = to_b(slave.a_n - np.array([0.0, 0.0, STANDARD_GRAVITY]))
    omega_ib_b = slave.omega_nb_b + to_b(sensors.earth_rate_n(s.latitude_deg * DEG))
    position = np.array([s.latitude_deg * DEG, 0.0, 0.0])
    given = at_sea.constants(s)
    ends = slice(2 * per_update, None, 2 * per_update)
    there = {"lat_lon_height": position, "v_n": slave.v_n[ends], "q_b2n_wxyz": slave.q_b2n_wxyz[ends],
             "omega_ib_b": omega_ib_b[ends], "lever_b": given["lever_b"], "a_n": master.a_n[ends],
             "q_b2m_wxyz": np.array([1.0, 0, 0, 0]), "q_m2n_wxyz": master.q_b2n_wxyz[ends]}  # fmt: skip
    H = np.concatenate(
        [unit(**{name: there[name] for name in unit.fields}) for unit in (model.velocity_H, model.dcm_H)], axis=-2
    )
    noise = {name: value for name, value in given.items() if name != "lever_b"}
    R = at_sea.matching_variances(s)

    def moments() -> Iterator[Moment]:
        for k in range(1, len(f_b), 2):
            inputs = {"lat_lon_height": position, "v_n": slave.v_n[k], "q_b2n_wxyz": slave.q_b2n_wxyz[k], "f_b": f_b[k],
                      "dt": dt, **noise}  # fmt: skip
            update, rest = divmod(k + 1, 2 * per_update)
            yield Moment(inputs) if rest else Moment(inputs, H[update - 1], R)

    P0 = initial(model, rotation.matrix_from_quaternion(master.q_b2n_wxyz[0]), s)
    history = [P0, *(P for k, P in enumerate(along(model, P0, moments()), 1) if k % per_update == 0)]
    return np.array([np.sqrt(np.diagonal(P, axis1=-2, axis2=-1)) for P in history])


def sampled(seconds: float, scenario: at_sea.Scenario) -> Array:
    """The times at which `covariances` wants its motion."""
    return np.arange(round(2 * seconds * scenario.covariance_hz) + 1) / (2 * scenario.covariance_hz)


def shown(model: Any, scenario: at_sea.Scenario, seconds: float, seed: int) -> dict[str, Any]:
    """Of every motion and state the seconds until its sigma is below a third for good, and the sigma's part at marks.

    motions, states: names.  seconds_to_third (motions, states), None where it does not get there.  part_60_s,
    part_end: sigma after 60 s and at the end, over that at the start.  heading_mil_60_s, heading_mil_end: (motions).
    """
    known = motions(sampled(seconds, scenario), seed)
    sigma = covariances(model, beside(list(known.values())), scenario)
    after = since(sigma < THRESHOLD * sigma[0]) / scenario.update_hz
    after = np.where(np.isnan(after), np.inf, after)
    where = np.cumsum([0, *(pose.v_n.shape[1] for pose in known.values())])

    def middle(values: Array) -> Array:
        return np.array([np.median(values[a:b], axis=0) for a, b in pairwise(where)])

    mark = min(60 * scenario.update_hz, len(sigma) - 1)
    time = middle(after)
    return {
        "seconds": seconds,
        "motions": list(known),
        "states": list(STATES),
        "seconds_to_third": [[None if np.isinf(t) else float(t) for t in row] for row in time],
        "part_60_s": middle(sigma[mark] / sigma[0]).tolist(),
        "part_end": middle(sigma[-1] / sigma[0]).tolist(),
        "heading_mil_60_s": (middle(sigma[mark])[:, HEADING] / MIL).tolist(),
        "heading_mil_end": (middle(sigma[-1])[:, HEADING] / MIL).tolist(),
        "initial": (sigma[0, 0]).tolist(),
    }


# ---- which manoeuvre shows the heading in a calm


def manoeuvres(model: Any, scenario: at_sea.Scenario, seconds: float = 60.0) -> dict[str, Any]:
    """Heading sigma (mil) `seconds` after the start of one manoeuvre in a calm, which begins after 5 s.

    turns: of angle_deg in 20 s at speed_m_s.  surges: at acceleration_m_s2 (mean) for length_s.
    """
    time = sampled(seconds, scenario)
    turns = [(angle, speed) for speed in (2.5, 5.0, 10.0) for angle in (15.0, 30.0, 60.0, 90.0, 180.0)]
    surges = [(a, length) for length in (5.0, 10.0, 20.0) for a in (0.1, 0.2, 0.5, 1.0)]
    poses = [underway(time, ramp(time, 5.0, 20.0, angle * DEG), speed) for angle, speed in turns]
    poses += [underway(time, speed=ramp(time, 5.0, length, a * length)) for a, length in surges]
    sigma = covariances(model, beside(poses), scenario)[-1, :, HEADING] / MIL
    return {
        "seconds": seconds,
        "turns": [{"angle_deg": angle, "speed_m_s": speed, "velocity_change_m_s": 2 * speed * np.sin(angle * DEG / 2),
                   "heading_mil": float(value)}
                  for (angle, speed), value in zip(turns, sigma, strict=False)],
        "surges": [{"acceleration_m_s2": a, "length_s": length, "velocity_change_m_s": a * length,
                    "heading_mil": float(value)}
                   for (a, length), value in zip(surges, sigma[len(turns):], strict=True)],
    }  # fmt: skip


# ---- closed loops


def summary(flight: at_sea.Flight, case: Any = ()) -> dict[str, Any]:
    """What the tables say of the runs of one case."""
    h, nees = np.abs(flight.heading[-1][case]) / MIL, flight.nees[case]
    nis = (flight.nis.sum((0, -1)) / flight.rows.sum(0))[case].mean()
    return {
        "heading_rms_mil": float(np.sqrt(np.mean(h**2))),
        "heading_worst_mil": float(h.max()),
        "heading_sigma_mil": float(np.mean(flight.heading_sigma[-1][case]) / MIL),
        "nees": float(nees.mean()),
        "nees_band": chi_square_band(16, nees.size),
        "nis": None if np.isnan(nis) else float(nis),
    }


def turned_about_down(angle: Array) -> Array:
    """q_b2m_wxyz (..., 4) of a mounting turned by `angle` (...) rad about the master's down axis."""
    zero = np.zeros_like(angle)
    return np.stack([np.cos(angle / 2), zero, zero, np.sin(angle / 2)], axis=-1)


# The scenario's closed loops at half the rate of the increments: two thirds of the time, and no different.
QUICK = replace(DECLARED, navigation_hz=50)

# ---- one measurement of the attitude, three ways, and parts of it

WAYS = {
    "DCM": ("dcm", (True, True, True)),
    "quaternion": ("quaternion", (True, True, True)),
    "Euler angles": ("euler", (True, True, True)),
    "Euler, pitch and yaw (two-antenna GPS)": ("euler", (False, True, True)),
    "Euler, yaw (compass)": ("euler", (False, False, True)),
    "Euler, roll and pitch (inclinometer)": ("euler", (True, True, False)),
}
PLACES = {  # mean pitch of the hull and mounting about down, deg
    "level": (0.0, 2.0),
    "pitch 60": (60.0, 2.0),
    "pitch 88": (88.0, 2.0),
    "mounted at 120": (0.0, 122.0),
}


def pitched(pitch_deg: Any, period_s: float = 8.0) -> hull.Motion:
    """Roll of 3 and pitch of 2 deg in phase and heave of 0.5 m, about a mean pitch (cases, 1)."""
    pitch = np.asarray(pitch_deg, float) * DEG
    amplitude = np.zeros((*pitch.shape, 6, 2), complex)
    amplitude[..., 4, 0] = pitch
    amplitude[..., 2, 1], amplitude[..., 3, 1], amplitude[..., 4, 1] = -0.5j, -3j * DEG, -2j * DEG
    return hull.Motion(hull.Harmonics(np.array([0.0, 2 * np.pi / period_s]), amplitude), DECLARED.heading_deg * DEG)


def matchings(model: Any, *, runs: int, seed: int) -> list[dict[str, Any]]:
    """Each way in each place: what `summary` says.  The mounting is wrong by N(0, 2 deg).

    refused: whether the attitude is beyond the model's box, and the filter flies by the velocity alone.
    """
    out = []
    pitch, mount = (np.array(part)[:, None] for part in zip(*PLACES.values(), strict=True))
    wrong = sensors.standard_normals(seed + 1, np.arange(runs), 3) * np.array([0.5, 0.5, 2.0]) * DEG
    C_believed = rotation.matrix_from_quaternion(turned_about_down((mount - 2.0) * DEG))
    # C_hat = exp(-[dmu x]) C
    mounting = rotation.quaternion_from_matrix(rotation.matrix_from_vector(wrong) @ C_believed)
    belief = at_sea.Belief(rotation.quaternion_from_matrix(C_believed), 2 * DEG)
    for name, (attitude, rows) in WAYS.items():
        flight = at_sea.fly(model, pitched(pitch), QUICK, mounting=mounting, belief=belief, rows=rows,
                            attitude=attitude, runs=runs, seed=seed)  # fmt: skip
        for case, place in enumerate(PLACES):
            refused = bool((flight.rows[:, case] <= 3).all())  # of the velocity
            out.append({"way": name, "place": place, "refused": refused, **summary(flight, case)})
    return out


# ---- a heading that is not known

UNKNOWN_DEG = (2.0, 5.0, 10.0, 20.0, 30.0, 45.0, 90.0, 180.0)
SINGLE = ("dcm", "quaternion")
CONVERGED_MIL = 20.0  # four sigmas of a bank


def starts(model: Any, *, runs: int, seed: int, grade: int = 5) -> dict[str, Any]:
    """How far the heading may be unknown: single filters at true offsets of the mounting, and `Headings`.

    single: by way, at each of UNKNOWN_DEG, which is the true offset, left and right, with a sigma as large: `summary`,
    the part of runs within CONVERGED_MIL, and of those of which a correction was refused.  bank: `Headings` over the
    live loop, which is given no heading of the master, whose headings are all over the circle; the same, without NIS,
    and from when on its likeliest was within CONVERGED_MIL.
    """
    streams = [sensors.generator(seed, run) for run in range(runs)]
    six = at_sea.motion_of("sea", QUICK, streams)
    i = at_sea.GRADES.index(grade)
    motion = replace(six, freedoms=replace(six.freedoms, omega=six.freedoms.omega[i : i + 1],
                                           amplitude=six.freedoms.amplitude[i : i + 1]))  # fmt: skip
    side = np.where(np.arange(runs) % 2, 1.0, -1.0)
    out: dict[str, Any] = {"grade": grade, "single": []}
    unknown = np.array(UNKNOWN_DEG)[:, None]
    for attitude in SINGLE:
        belief = at_sea.Belief(heading_sigma=unknown * DEG, velocity_sigma=0.5)
        flight = at_sea.fly(model, motion, QUICK, mounting=turned_about_down(np.minimum(unknown, 179.0) * DEG * side),
                            belief=belief, attitude=attitude, runs=runs, seed=seed)  # fmt: skip
        out["single"] += [{"way": attitude, "unknown_deg": degrees, **summary(flight, case), **converged(flight, case)}
                          for case, degrees in enumerate(UNKNOWN_DEG)]  # fmt: skip
    around = replace(motion, heading=2 * np.pi * (np.arange(runs) + 0.5) / runs)
    flight = live.fly(model, at_sea.signals(model, around, QUICK, runs=runs, seed=seed), QUICK, bank=True)
    right = np.abs(flight.heading[:, 0]) < CONVERGED_MIL * MIL
    out["bank"] = {
        "filters": round(2 * np.pi / SPACING),
        "spacing_deg": float(np.degrees(SPACING)),
        **summary(flight, 0),
        **converged(flight, 0),
        "within_after_s": [None if np.isnan(at) else float(at) / QUICK.update_hz for at in since(right)],
    }
    return out


def converged(flight: at_sea.Flight, case: Any) -> dict[str, Any]:
    right = np.abs(flight.heading[-1][case]) < CONVERGED_MIL * MIL
    return {"converged": float(np.mean(right)), "refused": float(np.mean(flight.lost[case]))}


# ---- all of it


@dataclass(frozen=True)
class Asked(Seeded):
    seconds: float = option(600.0, "Longest time for a motion to show an error.")


def run(asked: Asked, progress: Progress = silent) -> Result:
    """The four questions: what `shown`, `manoeuvres`, `matchings` and `starts` return, under these names, runs, and
    finished; interrupted, what follows is missing.
    """
    wide, model = load("velocity-attitude-lever"), load("velocity-attitude")
    given = {"runs": asked.runs, "seed": asked.seed}
    parts: dict[str, tuple[str, Callable[[], Any]]] = {
        "shown": ("observability: 24 motions", lambda: shown(wide, DECLARED, asked.seconds, asked.seed)),
        "manoeuvres": ("manoeuvres in a calm", lambda: manoeuvres(wide, DECLARED)),
        "matchings": (f"attitude matching: {len(WAYS)} ways, {len(PLACES)} places", lambda: matchings(model, **given)),
        "starts": (f"unknown heading: {len(SINGLE)} filters and a bank", lambda: starts(model, **given)),
    }
    result: Result = {"runs": asked.runs, "finished": False}
    try:
        for name, (says, do) in parts.items():
            progress(says)
            result[name] = do()
        result["finished"] = True
    except KeyboardInterrupt:
        progress("interrupted")
    return result


SUMMARY = ("heading_rms_mil", "heading_sigma_mil", "nees", "nis")
HEAD = ("heading rms, mil", "sigma", "NEES of 16", "NIS a row")


def report(result: Result) -> str:
    """The exploration as text, section by section."""
    lines = []
    if "shown" in result:
        part = result["shown"]
        keys = ("motions", "seconds_to_third", "heading_mil_60_s", "heading_mil_end")
        rows = [(name, *times, *heading) for name, times, *heading in zip(*(part[key] for key in keys), strict=True)]
        formats = ["", *["g"] * len(part["states"]), ".2f", ".2f"]
        head = ("", *(name.replace(" ", "_") for name in part["states"]), "heading, mil, 60 s", "at the end")
        lines += [
            f"Seconds until a sigma is below a third of what it was, for good; '-': not within {part['seconds']:g} s",
            *table(head, rows, formats),
        ]
    if "manoeuvres" in result:
        part = result["manoeuvres"]
        rows = [(f"turn of {row['angle_deg']:g} deg in 20 s at {row['speed_m_s']:g} m/s",
                 row["velocity_change_m_s"], row["heading_mil"]) for row in part["turns"]]  # fmt: skip
        rows += [(f"{row['acceleration_m_s2']:g} m/s^2 for {row['length_s']:g} s",
                  row["velocity_change_m_s"], row["heading_mil"]) for row in part["surges"]]  # fmt: skip
        head = ("", "velocity change, m/s", "heading sigma, mil")
        lines += ["", f"One manoeuvre in a calm, after {part['seconds']:g} s", *table(head, rows, ".2f")]
    if "matchings" in result:
        rows = [
            (f"{row['way']}; {row['place']}" + ", refused" * bool(row["refused"]), *(row[key] for key in SUMMARY))
            for row in result["matchings"]
        ]
        lines += ["", *table(("Matching of the attitude, after 60 s", *HEAD), rows, ["", ".2f", ".2f", ".1f", ".2f"])]
        lines += ["  refused: Euler angles of a pitch beyond the model's box; the velocity alone is matched"]
    if "starts" in result:
        part = result["starts"]
        bank = part["bank"]
        named = [(f"{row['way']}, off by {row['unknown_deg']:g} deg", row) for row in part["single"]]
        named.append((f"{bank['filters']} filters {bank['spacing_deg']:g} deg apart, any heading", bank))
        rows = [(name, *(row[key] for key in (*SUMMARY, "converged", "refused"))) for name, row in named]
        head = (f"Heading unknown, (c) sea state {part['grade']}, after 60 s", *HEAD, f"within {CONVERGED_MIL:g} mil",
                "refused")  # fmt: skip
        right = np.array([np.inf if at is None else at for at in bank["within_after_s"]])
        lines += [
            "",
            *table(head, rows, ["", ".2f", ".2f", ".4g", ".4g", ".0%", ".0%"]),
            "  refused: runs of which a correction would have left the model's box",
            f"  the bank is within {CONVERGED_MIL:g} mil from {np.median(right):g} s on (median), "
            f"{right.max():g} s (worst)",
        ]
    if not result["finished"]:
        lines.append("interrupted: what follows is missing")
    return "\n".join(lines)


def claims(result: Result) -> list[Claim]:
    """What can be said of a heading in a calm, of the ways to match, and of a heading that is not known."""
    product = [row["velocity_change_m_s"] * row["heading_mil"]
               for kind in ("turns", "surges") for row in result["manoeuvres"][kind]]  # fmt: skip
    level = {row["way"]: row for row in result["matchings"] if row["place"] == "level"}
    whole = [level[form]["nees"] for form in ("DCM", "quaternion", "Euler angles")]
    bank = result["starts"]["bank"]
    low, high = bank["nees_band"]
    return [
        Claim("in a calm, heading sigma times the change of velocity is 7 mil m/s, within a quarter",
              min(product) > 0.75 * RULE_MIL_M_S and max(product) < 1.25 * RULE_MIL_M_S,
              {"least": min(product), "largest": max(product)}),
        Claim("all three ways of matching are consistent: NEES of 16 in its 95 % band",
              all(low < one < high for one in whole), {"least": min(whole), "largest": max(whole)}),
        Claim("a bank of filters finds any heading: the worst run within four of its sigmas",
              bank["heading_worst_mil"] < 4 * bank["heading_sigma_mil"],
              {"worst, mil": bank["heading_worst_mil"], "sigma, mil": bank["heading_sigma_mil"],
               "NEES of 16": bank["nees"]}),
    ]  # fmt: skip


# ---- figures


def draw_all(result: Result, sheets: Sheets) -> None:
    """The pictures of a finished exploration."""
    if result["finished"]:
        observability_figure(result["shown"], sheets)
        heading_figure(result["manoeuvres"], result["starts"], sheets)


def observability_figure(part: dict[str, Any], sheets: Sheets) -> None:
    """States by motions; the tint is the time to a third of the initial sigma."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LogNorm

    time = np.array([[np.nan if t is None else t for t in row] for row in part["seconds_to_third"]]).T
    last = part["seconds"]
    with sheets("sea_observability", 9.6, 6.6) as (drawing, ax):
        scale = ScalarMappable(LogNorm(1.0, last), "YlGnBu_r")
        image = scale.to_rgba(time)
        image[np.isnan(time)] = (0.97, 0.88, 0.80, 1.0)
        ax.imshow(image, aspect="auto")
        for (i, j), t in np.ndenumerate(time):
            if np.isfinite(t):
                dark = np.mean(image[i, j, :3]) < 0.55
                ax.text(j, i, f"{t:.0f}", ha="center", va="center", fontsize=6.5, color="white" if dark else "0.15")
        ax.set_xticks(np.arange(time.shape[1]), part["motions"], rotation=45, ha="right", rotation_mode="anchor")
        symbols = (r"$\phi_n$", r"$\phi_e$", r"$\phi_d$ (heading)", r"$\delta v_n$", r"$\delta v_e$", r"$\delta v_d$")
        names = [*symbols, *(f"{sensor} bias {axis}" for sensor in ("gyro", "accel") for axis in "xyz"),
                 r"$\mu_x$", r"$\mu_y$", r"$\mu_z$", "delay", "lever x", "lever y", "lever z"]  # fmt: skip
        ax.set_yticks(np.arange(time.shape[0]), names)
        for at in (2.5, 5.5, 8.5, 11.5, 14.5, 15.5):
            ax.axhline(at, color="white", linewidth=1.5)
        for at in (6.5, 11.5, 17.5):
            ax.axvline(at, color="white", linewidth=1.5)
        ax.grid(False)
        ax.tick_params(length=0)
        ax.spines[:].set_visible(False)
        bar = drawing.colorbar(scale, ax=ax, aspect=40, pad=0.02, ticks=[1, 3, 10, 30, 100, 300, 600])
        bar.ax.set_yticklabels(["1", "3", "10", "30", "100", "300", "600"])
        bar.ax.minorticks_off()
        bar.outline.set_visible(False)
        bar.set_label(f"seconds until sigma stays below a third of its start; pale: not within {last:g} s")


def heading_figure(manoeuvre: dict[str, Any], start: dict[str, Any], sheets: Sheets) -> None:
    """What a manoeuvre in a calm leaves of the heading, and how far the heading may be unknown."""
    with sheets("sea_heading", 9.0, 3.6, ncols=2) as (_, axes):
        for kind, color, marker in (("turns", BLUE, "o"), ("surges", ORANGE, "s")):
            change, left = (np.array([row[key] for row in manoeuvre[kind]]) for key in ("velocity_change_m_s",
                                                                                        "heading_mil"))  # fmt: skip
            axes[0].loglog(change, left, marker, color=color, markersize=4, linestyle="none",
                           label={"turns": "turn in 20 s", "surges": "speed up in 5, 10, 20 s"}[kind])  # fmt: skip
        span = np.array([0.5, 20.0])
        axes[0].loglog(
            span, RULE_MIL_M_S / span, color="0.3", linewidth=0.8, label=f"{RULE_MIL_M_S:g} mil m/s / change"
        )
        axes[0].set(xlabel="change of the velocity vector [m/s]", ylabel="heading sigma after 60 s [mil]")
        axes[0].set_xticks([0.5, 1, 2, 5, 10, 20], ["0.5", "1", "2", "5", "10", "20"])
        axes[0].set_yticks([0.5, 1, 2, 5, 10], ["0.5", "1", "2", "5", "10"])
        axes[0].minorticks_off()
        axes[0].legend()
        axes[0].set_title("one manoeuvre in a calm", loc="left")
        for form, color, marker in (("dcm", BLUE, "o"), ("quaternion", ORANGE, "s")):
            rows = [row for row in start["single"] if row["way"] == form]
            axes[1].loglog([row["unknown_deg"] for row in rows], [row["nees"] for row in rows], color=color,
                           marker=marker, markersize=4, label=f"one filter, {form.replace('dcm', 'DCM')}")  # fmt: skip
        axes[1].axhline(start["bank"]["nees"], color="0.25", linestyle=(0, (5, 2)),
                        label=f"likeliest of {start['bank']['filters']}, any heading")  # fmt: skip
        axes[1].axhspan(*start["bank"]["nees_band"], color="0.85", linewidth=0, label="95 % band")
        axes[1].set(xlabel="heading wrong at the start by [deg]", ylabel="NEES of 16 states after 60 s")
        axes[1].set_xticks([2, 5, 10, 20, 45, 90, 180], ["2", "5", "10", "20", "45", "90", "180"])
        axes[1].minorticks_off()
        axes[1].legend(loc="upper left")
        axes[1].set_title(f"unknown heading, (c) sea state {start['grade']}", loc="left")


STUDY = Study("sea-exploration", ("velocity-attitude", "velocity-attitude-lever"), Asked, run, report, draw_all, claims,
              good=lambda result: result["finished"])  # fmt: skip
