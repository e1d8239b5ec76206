"""What single precision does to the covariance of fifteen states, and to the estimate: the study float-covariance.

The generated C of azimuth-hold is compiled in double and in float, with the time loops of float_covariance.c beside it,
and flown from gentle starts for an hour and from coarse ones for ten minutes, predicted at 100 Hz and updated each
second by zero velocity and by the azimuth.  docs/float.md says what came out.
"""

import ctypes
import itertools
import json
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.consistency import nees
from boresight.analysis.figures import BLUE, GREY, ORANGE, Sheets
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.compiler import PRECISIONS, open_library, shared_library
from boresight.runtime.library import load
from boresight.runtime.manifest import folder_of, read_manifest
from boresight.runtime.simulation.inertial import increments
from boresight.runtime.simulation.sensors import generator
from boresight.runtime.units import DEG, DEG_H, FOOT, MILLI_G, STANDARD_GRAVITY
from boresight.studies.study import Progress, Result, Study, option, silent, table

STEP_S, UPDATE_S = 0.01, 1.0
POSITION = np.array([0.2, 45 * DEG, 100.0])  # lon lat height
RADIUS_M = 6.38e6  # turns a distance at the start into radians
# Root densities of gyros, accelerometers and their biases' walks: 0.125 deg/sqrt(h), 0.065 ft/s/sqrt(h), 1 % of
# 1 deg/h and of 1 mg in an hour.
NOISE = np.repeat([0.125 * DEG / 60, 0.065 * FOOT / 60, 0.01 * DEG_H / 60, 0.01 * MILLI_G / 60], 3)

# The first two are shipped, and the others are written out in the driver over full matrices: the Joseph form multiplied
# out, (I - K H) P with P made symmetric, and (I - K H) P.
FORMS = ("ud", "joseph", "joseph-expanded", "symmetrized", "standard")
PACKED = ("ud", "joseph")


@dataclass(frozen=True)
class Start:
    """Sigmas at the start, and of what is measured each second."""

    name: str
    seconds: int
    position_m: float
    velocity_m_s: float
    tilt_deg: float
    azimuth_deg: float
    gyro_bias_deg_h: float
    accel_bias_mg: float
    zupt_m_s: float
    hold_rad: float  # of the measured azimuth

    @property
    def sigma(self) -> Array:
        """(15,), in the order and units of the states."""
        east = self.position_m / RADIUS_M / np.cos(POSITION[1])
        return np.array(
            [east, self.position_m / RADIUS_M, self.position_m, *[self.velocity_m_s] * 3]
            + [self.tilt_deg * DEG] * 2 + [self.azimuth_deg * DEG]
            + [self.gyro_bias_deg_h * DEG_H] * 3 + [self.accel_bias_mg * MILLI_G] * 3
        )  # fmt: skip

    @property
    def R(self) -> Array:
        return np.array([self.zupt_m_s] * 3 + [self.hold_rad]) ** 2


GENTLE = (
    Start("gentle 1", 3600, 10, 0.1, 0.5, 3, 1, 1, 5e-2, 1e-3),
    Start("gentle 2", 3600, 10, 0.1, 1, 10, 1, 1, 1e-2, 1e-3),
    Start("gentle 3", 3600, 10, 0.1, 0.5, 3, 1, 1, 1e-3, 5e-5),
    Start("middle 1", 3600, 1e3, 1, 1, 30, 1, 1, 1e-2, 1e-3),
    Start("middle 2", 3600, 1e3, 10, 2, 30, 1, 1, 1e-3, 1e-4),
)
COARSE = (
    Start("coarse 1", 600, 1e3, 10, 5, 30, 100, 50, 1e-2, 1e-4),
    Start("coarse 2", 600, 1e3, 10, 5, 30, 100, 50, 1e-3, 1e-5),
    Start("coarse 3", 600, 1e3, 10, 5, 30, 100, 50, 1e-4, 1e-6),
    Start("coarse 4", 600, 1e5, 100, 5, 180, 1000, 50, 1e-4, 1e-7),
)
# Every corner of position, azimuth, gyro bias and measurement noise.
CORNERS = tuple(
    Start(f"corner {i}", 600, position, position / 1e3 if position > 1e4 else 10, 5, azimuth, bias, 50, *noise)
    for i, (position, azimuth, bias, noise) in enumerate(
        itertools.product((1e3, 1e5), (30, 180), (100, 1000), ((1e-2, 1e-4), (1e-4, 1e-7))), 1
    )
)


@cache
def driver(precision: str) -> ctypes.PyDLL:
    """The time loops with the generated C, compiled in "double" or "float" into the cache of libraries."""
    folder, loops = folder_of("azimuth-hold"), Path(__file__).with_name("float_covariance.c")
    manifest = read_manifest(folder)
    generated = (folder / path for path in manifest["files"] if path.startswith("src/") and path.endswith(".c"))
    sources = dict.fromkeys([loops, *generated], ())
    contents = loops.read_text() + json.dumps(manifest["files"], sort_keys=True)
    name = f"float-covariance-{precision}"
    library = open_library(*shared_library(name, contents, sources, folder / "include", PRECISIONS[precision]))
    first: list[Any] = [*[ctypes.c_int] * 3, ctypes.c_double]
    library.fly.argtypes = [*first, *[ctypes.c_void_p] * 11]
    library.navigate.argtypes = [*first, *[ctypes.c_void_p] * 5, ctypes.c_int, *[ctypes.c_void_p] * 5]
    return library


def pointer(array: Array | None) -> Any:
    if array is None:
        return None
    assert array.dtype == float and array.flags.c_contiguous
    return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


def address(function: Any) -> ctypes.c_void_p:
    return ctypes.cast(function, ctypes.c_void_p)


def level(roll: Array, pitch: Array, yaw: Array) -> Array:
    """Attitude of right-front-up axes in ENU, (T, 4): yaw to the left about up, then pitch, then roll about front."""
    angles = np.stack([pitch, roll, yaw], axis=-1)
    turns = [rotation.matrix_from_vector(angles[:, [i]] * np.eye(3)[i]) for i in (2, 0, 1)]
    return rotation.quaternion_from_matrix(turns[0] @ turns[1] @ turns[2])


@lru_cache(maxsize=2)
def motion(kind: str, seconds: float, dt: float) -> Array:
    """Position, velocity, attitude and specific force in the middle of each step, (T, 13).

    kind: "rest", level and pointing north; or "circle", 20 m/s to the left once in 120 s, rocking; what zero velocity
    is to the one, a reference of velocity as good is to the other.
    """
    time = (np.arange(round(seconds / dt)) + 0.5) * dt
    still, a_n, v_n = np.zeros_like(time), np.zeros((len(time), 3)), np.zeros((len(time), 3))
    q = level(still, still, still)
    if kind == "circle":
        rate, speed = 2 * np.pi / 120, 20.0
        yaw = rate * time
        q = level(3 * DEG * np.sin(2 * np.pi * time / 90), 2.3 * DEG * np.sin(2 * np.pi * time / 130), yaw)
        v_n[:, :2] = speed * np.stack([-np.sin(yaw), np.cos(yaw)], axis=1)
        a_n[:, :2] = -speed * rate * np.stack([np.cos(yaw), np.sin(yaw)], axis=1)
    up = np.array([0.0, 0.0, STANDARD_GRAVITY])
    f_b = np.einsum("tji,tj->ti", rotation.matrix_from_quaternion(q), a_n + up)
    return np.hstack([np.broadcast_to(POSITION, v_n.shape), v_n, q, f_b])


@dataclass(frozen=True)
class Flown:
    """After each update: P (U, 15, 15) in double; the least D, or variance, since the one before, (U,); what is left of
    the error, (U, 15), if it was flown; and the first update that the kernels refused, counted from 1, or 0."""

    P: Array
    least: Array
    left: Array
    refused: int


def fly(
    precision: str,
    form: str,
    start: Start,
    kind: str = "rest",
    rate_hz: float = 1 / STEP_S,
    noise: Array = NOISE,
    errors: tuple[Array, Array, Array] | None = None,
) -> Flown:
    """One covariance.  rate_hz: of its prediction.

    errors: the error at the start (15,), what noise adds to it in each step (T, 15), errors of the measurement (U, 4).
    """
    dt, library = 1 / rate_hz, driver(precision)
    path = motion(kind, start.seconds, dt)
    every = round(UPDATE_S * rate_hz)
    updates = len(path) // every
    packed, least, left = np.zeros((updates, 15, 15)), np.zeros(updates), np.zeros((updates, 15))
    e, drawn, seen = (None, None, None) if errors is None else (errors[0].copy(), *errors[1:])
    refused = library.fly(
        FORMS.index(form), len(path), every, dt, pointer(path), pointer(noise), pointer(start.sigma), pointer(start.R),
        pointer(drawn), pointer(seen), address(driver("double").carry), pointer(packed), pointer(least), pointer(e),
        pointer(left),
    )  # fmt: skip
    if refused < 0:
        raise BoresightError(f"{start.name}: the filter refused {'its start' if refused == -1 else 'the motion'}")
    return Flown(dense(packed, form), least, left, refused)


def dense(numbers: Array, form: str) -> Array:
    """The symmetric P of what carries it, in double: (U, 15, 15); UD is multiplied out, so that nothing is rounded."""
    if form not in PACKED:
        return numbers
    upper, (columns, rows) = np.zeros_like(numbers), np.tril_indices(15)
    upper[:, rows, columns] = numbers.reshape(len(numbers), -1)[:, :120]
    if form == "joseph":
        return upper + np.swapaxes(np.triu(upper, 1), 1, 2)
    D = np.einsum("tii->ti", upper).copy()
    U = np.triu(upper, 1) + np.eye(15)
    return np.einsum("tij,tj,tkj->tik", U, D, U)


def smallest_eigenvalue(P: Array) -> Array:
    """Of the correlations, (U,); -1 where a variance is not above zero or not a number.  P need not be symmetric."""
    variance = np.einsum("tii->ti", P)
    good = np.isfinite(P).all(axis=(1, 2)) & (variance > 0).all(axis=1)
    sigma = np.sqrt(variance[good])
    C = P[good] / sigma[:, :, None] / sigma[:, None, :]
    out = np.full(len(P), -1.0)
    out[good] = np.linalg.eigvalsh((C + np.swapaxes(C, 1, 2)) / 2)[:, 0]
    return out


def deviation(P: Array, reference: Array) -> Array:
    """|sigma / its reference - 1|, (U, 15); infinite where there is no sigma."""
    with np.errstate(invalid="ignore", over="ignore"):
        ratio = np.sqrt(np.einsum("tii->ti", P) / np.einsum("tii->ti", reference))
    return np.where(np.isfinite(ratio), np.abs(ratio - 1), np.inf)


def judge(flown: Flown, reference: Flown, form: str) -> dict[str, Any]:
    """Whether it stayed a covariance and how far its sigmas went from the reference while it was one.

    dies_s: the first update after which it is none: a D, variance or eigenvalue of the correlations is not above zero.
    """
    eigenvalue = smallest_eigenvalue(flown.P)
    # U D U' with D > 0 is positive definite whatever U; no eigenvalue need be computed, nor is one as exact
    alive = (flown.least > 0) & (True if form == "ud" else eigenvalue > 0)
    dead = None if alive.all() else int(np.argmin(alive))
    away = deviation(flown.P, reference.P)[:dead]
    at, state = np.unravel_index(np.argmax(away), away.shape) if away.size else (0, 0)
    return {
        "dies_s": None if dead is None else (dead + 1) * UPDATE_S,
        "refused_s": flown.refused * UPDATE_S if flown.refused else None,
        "deviation": float(away[at, state]) if away.size else None,
        "deviation_s": float((at + 1) * UPDATE_S) if away.size else None,
        "deviation_state": load("azimuth-hold").states[state] if away.size else None,
        "least_eigenvalue": float(eigenvalue.min()),
    }


def compare(
    start: Start, kind: str, wanted: tuple[tuple[str, str, float], ...], noise: Array = NOISE, keep: bool = False
) -> list[dict[str, Any]]:
    """Each of (precision, form, rate) against UD in double at 100 Hz; keep: with histories."""
    reference = fly("double", "ud", start, kind, noise=noise)
    rows = []
    for precision, form, rate_hz in wanted:
        flown = fly(precision, form, start, kind, rate_hz, noise)
        labels = {"start": start.name, "motion": kind, "form": form, "precision": precision, "rate_hz": rate_hz}
        row = labels | judge(flown, reference, form)
        if keep:
            at = np.unique(np.geomspace(1, len(flown.P), 200).round().astype(int)) - 1
            row["history"] = {
                "time_s": ((1 + at) * UPDATE_S).tolist(),
                "eigenvalue": smallest_eigenvalue(flown.P[at]).tolist(),
                "deviation": np.minimum(deviation(flown.P[at], reference.P[at]).max(axis=1), 1e3).tolist(),
            }
        rows.append(row)
    return rows


ALL = (*(("float", form, 100.0) for form in FORMS), ("float", "ud", 10.0), ("double", "joseph", 100.0))
SHORT = (("float", "ud", 100.0), ("float", "joseph", 100.0), ("float", "ud", 10.0))


def estimates(start: Start, form: str, seed: int, runs: int) -> dict[str, Any]:
    """The estimate in float, fed back to a navigation in double, beside the same filter all in double.

    The navigation's error obeys F: it is drawn from the covariance at the start and grows by the filter's own noise.
    Returns the largest difference of the two in sigmas, in the first ten seconds and after, and NEES of both (of 15).
    """
    early, apart, weighed = round(10 / UPDATE_S), [], []
    grown = np.repeat([0.0, *NOISE[[3, 0, 6, 9]]], 3) * np.sqrt(STEP_S)  # of position, velocity, phi and biases
    for run in range(runs):
        rng = generator(seed, run)
        errors = (
            start.sigma * rng.standard_normal(15),
            grown * rng.standard_normal((round(start.seconds / STEP_S), 15)),
            np.sqrt(start.R) * rng.standard_normal((round(start.seconds / UPDATE_S), 4)),
        )
        double, single = (fly(p, f, start, errors=errors) for p, f in (("double", "ud"), ("float", form)))
        sigma = np.sqrt(np.einsum("tii->ti", double.P))
        worst = np.nan_to_num(np.abs(single.left - double.left) / sigma, nan=np.inf).max(axis=1)
        apart.append((worst[:early].max(), worst[early:].max(initial=0.0)))
        weighed.append([nees(left, double.P).mean() for left in (double.left, single.left)])
    labels = {"start": start.name, "form": form, "runs": runs}
    (first, later), (double_nees, float_nees) = np.max(apart, axis=0), np.mean(weighed, axis=0)
    found = {"first_10_s": first, "later": later, "nees_double": double_nees, "nees_float": float_nees}
    return labels | {name: float(value) if value < 1e6 else None for name, value in found.items()}


def navigations(start: Start, seed: int) -> list[dict[str, Any]]:
    """A strapdown at rest with the filter beside it: in double, with float errors, and all in float.

    The second is what is advised: the strapdown and the feedback in double, the filter in float.  The third keeps
    position, velocity and attitude in float from step to step, and computes each step exactly.
    Returns for each the rms of the errors over the last half, and how far it is from the first, in sigmas.
    """
    strapdown, hold = load("strapdown"), load("azimuth-hold")
    steps, every, rng = round(start.seconds / STEP_S), round(UPDATE_S / STEP_S), generator(seed, 0)
    q = level(*np.array([[2.0], [-1.0], [-30.0]]) * DEG)[0]
    # Between samples at rest all increments are the same.
    dtheta, dv, _ = increments(strapdown.step, POSITION, np.zeros((4, 3)), np.tile(q, (4, 1)), STEP_S)
    ideal = np.concatenate([dtheta[-1], dv[-1]])
    bias = start.sigma[9:] * rng.standard_normal(6)
    noisy = ideal + bias * STEP_S + NOISE[:6] * np.sqrt(STEP_S) * rng.standard_normal((steps, 6))
    e = start.sigma[:9] * rng.standard_normal(9)
    # C_hat = (I - [phi x]) C
    C_hat = rotation.matrix_from_vector(-e[6:]) @ rotation.matrix_from_quaternion(q)
    first = np.concatenate([POSITION + e[:3], e[3:6], rotation.quaternion_from_matrix(C_hat), np.zeros(6)])
    found, double = [], None
    for name, precision, in_float in (
        ("all in double", "double", 0),
        ("navigation in double, errors in float", "float", 0),
        ("all in float", "float", 1),
    ):
        library, updates = driver(precision), steps // every
        nav, kept, P = first.copy(), np.zeros((updates, 16)), np.zeros((updates, 15, 15))
        refused = library.navigate(
            steps, every // 10, every, STEP_S, pointer(noisy), pointer(NOISE), pointer(start.sigma), pointer(start.R),
            pointer(q), in_float, address(strapdown.dll.sd_step), address(hold.dll.ah_feedback), pointer(nav),
            pointer(kept), pointer(P),
        )  # fmt: skip
        error = np.hstack([
            kept[:, :3] - POSITION, kept[:, 3:6],
            rotation.attitude_error(kept[:, 6:10], q), kept[:, 10:] - bias,
        ])  # fmt: skip
        if double is None:
            double = error, np.sqrt(np.einsum("tii->ti", P))
        apart = np.abs(error - double[0]) / double[1]
        rms = np.sqrt(np.mean(error[updates // 2 :] ** 2, axis=0))
        found.append({
            "says": name,
            "refused_s": refused * STEP_S if refused else None,
            "north_m": float(rms[1] * RADIUS_M),
            "speed_mm_s": float(np.linalg.norm(rms[3:6]) * 1e3),
            "level_arcsec": float(np.linalg.norm(rms[6:8]) / DEG * 3600),
            "azimuth_arcsec": float(rms[8] / DEG * 3600),
            "gyro_bias_deg_h": float(np.linalg.norm(rms[9:12]) / DEG_H),
            "apart_sigmas": float(apart.max()),
            "apart_state": hold.states[int(apart.max(axis=0).argmax())],
            "nees": float(nees(error, P).mean()),
        })  # fmt: skip
    return found


@dataclass(frozen=True)
class Asked:
    seed: int = option(0, "Of the errors that the estimates are flown with.")
    estimates: int = option(3, "Runs of each flight of an estimate.")
    longest_s: int = 3600  # of any flight, for a quick look


def run(asked: Asked, progress: Progress = silent) -> Result:
    """Everything: covariances, corners and limits (rows of `compare`; limits with `noise`, the part of the process

    noise), estimates, navigations, starts, and worst, the worst deviation of UD at 100 and 10 Hz over covariances and
    corners; history: start -> rows of `compare` with theirs, at rest.
    """

    def cut(start: Start) -> Start:
        return replace(start, seconds=min(asked.longest_s, start.seconds))

    covariances, corners, limits = [], [], []
    for start, kind in itertools.product(map(cut, (*GENTLE, *COARSE)), ("rest", "circle")):
        progress(f"{start.name}, {kind}")
        # over an hour made symmetric or not is the same; it is left out for time
        forms = tuple(one for one in ALL if start.seconds <= 600 or one[1] != "symmetrized")
        covariances += compare(start, kind, forms if kind == "rest" else SHORT, keep=kind == "rest")
    for start, kind in itertools.product(map(cut, CORNERS), ("rest", "circle")):
        progress(f"{start.name}, {kind}")
        corners += compare(start, kind, SHORT)
    for start, part in itertools.product((cut(GENTLE[2]), cut(COARSE[3])), (0.1, 0.01, 0.0)):
        progress(f"{start.name}, {part:g} of the process noise")
        rows = compare(start, "rest", (ALL[0], *ALL[-2:]), noise=part * NOISE)
        limits += [{"noise": part, **row} for row in rows]
    found = []
    for start, form in ((GENTLE[2], "ud"), *((start, "ud") for start in COARSE), (COARSE[1], "joseph")):
        progress(f"{start.name}, estimates in {form}")
        found.append(estimates(cut(start), form, asked.seed, asked.estimates))
    progress("navigation")

    def worst(rate_hz: float) -> dict[str, Any]:
        return max(
            (r for r in covariances + corners if r["form"] == "ud" and r["rate_hz"] == rate_hz),
            key=lambda r: np.inf if r["dies_s"] is not None else r["deviation"],
        )

    history = [(row, row.pop("history")) for row in covariances if "history" in row]
    return {
        "starts": [vars(start) for start in (*GENTLE, *COARSE, *CORNERS)],
        "covariances": covariances,
        "corners": corners,
        "limits": limits,
        "estimates": found,
        "navigations": navigations(cut(GENTLE[1]), asked.seed),
        "worst": {f"{rate:g} Hz": worst(rate) for rate in (100.0, 10.0)},
        "history": history,
    }


def verdict(row: dict[str, Any] | None) -> str:
    """How a cell of the table reads: the worst deviation of a sigma, or when it died."""
    if row is None:
        return ""
    return f"{100 * row['deviation']:.3g} %" if row["dies_s"] is None else f"dies, {row['dies_s']:g} s"


def report(result: Result) -> str:
    """The table of starts by forms, corners, limits, estimates and navigations; the last line sums up."""
    cells: dict[tuple[str, str], dict[Any, Any]] = {}
    for row in result["covariances"]:
        key = row["precision"], row["form"], row["rate_hz"]
        cells.setdefault((row["start"], row["motion"]), {})[key] = row
    named = [(f"{start}, {kind}", *(verdict(of.get(one)) for one in ALL)) for (start, kind), of in cells.items()]
    ud, slow = ([r["deviation"] for r in result["corners"] if r["form"] == "ud" and r["rate_hz"] == rate]
                for rate in (100, 10))  # fmt: skip
    dead = [r["dies_s"] for r in result["corners"] if r["form"] == "joseph"]
    died = [d for d in dead if d is not None]
    limits = [result["limits"][k : k + 3] for k in range(0, len(result["limits"]), 3)]
    names = ("north_m", "speed_mm_s", "level_arcsec", "azimuth_arcsec", "gyro_bias_deg_h", "nees", "apart_sigmas")
    worst = result["worst"]
    return "\n".join([
        "Single precision at 100 Hz, updated each second: worst deviation of a sigma from double, or when it died",
        *table(("", *FORMS, "ud, 10 Hz", "joseph double"), named),
        "",
        f"16 corners at rest and in a circle: UD {100 * max(ud):.2g} % at most, at 10 Hz {100 * max(slow):.2g} %; "
        f"joseph died in {len(died)} of {len(dead)}, after {max(died, default=np.nan):g} s at the latest",
        "",
        *table(("less process noise, at rest", "ud", "ud, 10 Hz", "joseph double"),
               [(f"{rows[0]['start']}, {rows[0]['noise']:g} of it", *map(verdict, rows)) for rows in limits]),
        "",
        "estimates in float beside double, largest difference in sigmas; NEES of 15; '-': lost",
        *table(("", "first 10 s", "later", "NEES double", "float"),
               [(f"{row['start']}, {row['form']}", *list(row.values())[3:]) for row in result["estimates"]], ".3g"),
        "",
        "an hour of navigation at rest: rms of the last half",
        *table(("", "north, m", "mm/s", "level, arcsec", "azimuth", "gyros, deg/h", "NEES of 15", "sigmas apart"),
               [(row["says"], *(row[name] for name in names)) for row in result["navigations"]], ".3g"),
        "",
        "float-covariance: UD in float within "
        + ", ".join(f"{100 * row['deviation']:.2f} % at {rate}" for rate, row in worst.items())
        + f"; worst in {worst['100 Hz']['start']} ({worst['100 Hz']['motion']}), {worst['100 Hz']['deviation_state']}",
    ])  # fmt: skip


def good(result: Result) -> bool:
    worst = result["worst"]["100 Hz"]
    return worst["dies_s"] is None and worst["deviation"] < 0.005


# How the forms look: what is shipped for float is blue, what loses is orange and grey; and where their crosses stand.
LOOK: dict[tuple[str, str, float], tuple[str, Any, float, str]] = {
    ("float", "ud", 100.0): (BLUE, "-", 0.0, "UD"),
    ("float", "ud", 10.0): (BLUE, (0, (4, 2)), 0.0, "UD, predicted at 10 Hz"),
    ("float", "joseph", 100.0): (ORANGE, "-", 0.03, "Joseph, shipped"),
    ("float", "joseph-expanded", 100.0): (ORANGE, (0, (4, 2)), 0.03, "Joseph, multiplied out"),
    ("float", "standard", 100.0): (GREY, "-", 0.1, "(I - K H) P"),
}


def draw(result: Result, sheets: Sheets) -> None:
    """Gentle and coarse starts at rest, in float."""
    histories(result, ("gentle 1", "gentle 3", "middle 2"), "gentle", sheets)
    histories(result, ("coarse 1", "coarse 2", "coarse 4"), "coarse", sheets)


def histories(result: Result, starts: tuple[str, ...], name: str, sheets: Sheets) -> None:
    """Smallest eigenvalue of the correlations, and below the worst deviation of a sigma; a column a start."""
    from matplotlib.lines import Line2D

    labels = {start["name"]: start for start in result["starts"]}
    lived = set()
    with sheets(f"float-{name}", 9.0, 5.6, nrows=2, ncols=len(starts), sharex=True, sharey="row") as (drawing, axes):
        for (above, below), start in zip(axes.T, starts, strict=True):
            for row, history in result["history"]:
                key = (row["precision"], row["form"], row["rate_hz"])
                if row["start"] != start or key not in LOOK:
                    continue
                colour, line, height, _ = LOOK[key]
                time = np.array(history["time_s"])
                lives = time < (row["dies_s"] or np.inf)
                lived |= {key} if lives.any() else set()
                for ax, values in ((above, history["eigenvalue"]), (below, history["deviation"])):
                    ax.plot(time[lives], np.array(values)[lives], color=colour, linestyle=line)
                    if row["dies_s"] is not None:
                        y = 1 - height if ax is below else height  # towards zero, and away from double
                        ax.plot(row["dies_s"], y, "x", color=colour, transform=ax.get_xaxis_transform(), clip_on=False)
            below.axhline(0.005, color="0.3", linewidth=0.8, linestyle=(0, (1, 1.5)))
            one = labels[start]
            above.set_title(
                f"{start}: {one['position_m']:g} m, {one['azimuth_deg']:g} deg, {one['gyro_bias_deg_h']:g} deg/h\n"
                f"measured to {one['zupt_m_s'] * 1e3:g} mm/s, {one['hold_rad'] * 1e6:g} microrad",
                loc="left", fontsize=8,
            )  # fmt: skip
            for ax in (above, below):
                ax.set(xscale="log", yscale="log", xlim=(0.9, time[-1]))
            below.set_xlabel("time [s]")
        axes[0, 0].set_ylabel("smallest eigenvalue of\nthe correlations")
        axes[1, 0].set_ylabel("worst |sigma / double - 1|")
        shown = {
            label: Line2D(
                [], [], color=colour, linestyle=line if key in lived else "", marker="" if key in lived else "x"
            )
            for key, (colour, line, _, label) in LOOK.items()
        }
        shown["no covariance any more"] = Line2D([], [], color="0.3", linestyle="", marker="x")
        shown["0.5 %"] = Line2D([], [], color="0.3", linewidth=0.8, linestyle=(0, (1, 1.5)))
        drawing.legend(shown.values(), shown.keys(), loc="outside lower center", ncols=4)


STUDY = Study("float-covariance", ("azimuth-hold", "strapdown"), Asked, run, report, draw, good=good)
