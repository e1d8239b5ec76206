"""Transfer alignment on a recording by velocity and attitude: mounting, biases and the master's delay from nothing.

The slave takes over its master's velocity and attitude and knows of itself only what PRIOR says.  The noises that are
not given are those under which the innovations are most likely.  What is found on a real recording: docs/recordings.md.
"""

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.consistency import chi_square_band
from boresight.analysis.figures import BLUE, FAINT, ORANGE, Sheets
from boresight.analysis.record import Record
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.filter import CompiledFilter
from boresight.runtime.live import Fate
from boresight.runtime.recording import Recording, check, thinned
from boresight.runtime.transfer import Increments, Message, first
from boresight.runtime.transfer.score import GROUPS as SCORED
from boresight.runtime.transfer.score import Score, driven
from boresight.runtime.transfer.sensors import ADDED, CALIBRATION, GRADES, MODEL, Sensors, calibration, carried
from boresight.runtime.units import MILLI_G, UNITS
from boresight.studies.replays.innovations import consistency, minus_log_likelihood, most_likely
from boresight.studies.replays.passes import HALF_SPAN_S, Pass, compiled
from boresight.studies.replays.smoothed import Quantity, backwards, draw_smoothed, smoothed_lines, summary
from boresight.studies.study import Progress, Replay, Study, lasting

ROWS = ("velocity north", "velocity east", "velocity down", "attitude north", "attitude east", "attitude down")
MATCHING = ("velocity", "dcm")
BODY = ("front", "right", "down")
# One sigma before the first message, SI and rad: a MEMS unit screwed in by eye, on a clock that nobody has compared.
PRIOR = {"gyro_bias": np.radians(0.2), "accel_bias": 0.5, "misalignment": np.radians(2.0), "delay": 0.05, "lever": 1.0}
HOLD_S = 0.15  # a message is handed over so late, so that a delay that is believed negative for a while stays inside
BAND = 1.96  # sigmas, 95 %
USUAL_PASSES = 8  # of a search for noises
FIRST_PASSES, DELAY_NEAR_S = 3, 0.005
# One sigma of what a filter without states for it does not know, where nothing is told: a MEMS unit, calibrated once.
ASSUMED = Sensors(gyro_scale=1e-3, accel_scale=1e-3, gyro_axes=1e-3, accel_axes=1e-3)


@dataclass(frozen=True)
class Noise:
    """One noise that a datasheet may give: kind and unit, its parts, and where a search for it begins and ends."""

    kind: str  # of runtime.units.UNITS
    unit: str
    parts: tuple[str, ...]
    first: float  # SI and rad
    limits: tuple[float, float]


NOISES = {
    "gyro": Noise("gyro noise", "deg/sqrt(h)", ("each axis",), 5e-5, (1e-7, 0.03)),
    "accel": Noise("accelerometer noise", "m/s/sqrt(h)", ("each axis",), 2e-3, (1e-6, 1.0)),
    "velocity": Noise("velocity", "mm/s", ("level", "vertical"), 0.05, (1e-5, 3.0)),
    "attitude": Noise("angle", "arcmin", ("level", "heading"), 1e-3, (1e-7, 0.03)),
    # two clocks run apart by 1e-5 of the time or so
    "delay": Noise("delay noise", "ms/sqrt(s)", ("random walk",), 3e-5, (1e-7, 0.01)),
    # of the biases, and so small at least that a bias stays where it is; an instability sigma over T is a walk of
    # sigma sqrt(2 / T) for times that are shorter, and less than that for longer ones
    "gyro_walk": Noise("gyro bias walk", "deg/h/sqrt(h)", ("each axis",), 1e-6, (1e-10, 1e-3)),
    "accel_walk": Noise("accelerometer bias walk", "mg/sqrt(h)", ("each axis",), 1e-4, (1e-8, 0.1)),
}
LEAST = {name: NOISES[name].limits[0] for name in ("delay", "gyro_walk", "accel_walk")}  # what constant ones are given
PARTS = tuple(one for one in NOISES.values() for _ in one.parts)
# What sensors of a grade have, one sigma, SI and rad: white noise by datasheets of the classes of `sensors.GRADES`,
# bias walks by their instabilities; of the master what one has that is worth aligning to.
MASTERS = {"velocity": 0.1, "attitude": np.radians(0.3)}
NOISE_OF_GRADE = {
    name: {
        "gyro": gyro * UNITS["gyro noise"]["deg/sqrt(h)"], "accel": accel * UNITS["accelerometer noise"]["m/s/sqrt(h)"],
        "gyro_walk": GRADES[name].gyro_instability * np.sqrt(2 / GRADES[name].correlation_s),
        "accel_walk": GRADES[name].accel_instability * np.sqrt(2 / GRADES[name].correlation_s), **MASTERS,
    }
    for name, gyro, accel in (
        ("mems", 0.5, 0.25), ("industrial", 0.3, 0.1), ("tactical", 0.15, 0.07), ("navigation", 0.003, 0.02)
    )
}  # fmt: skip
WORST, MOST = "mems", 10.0
ENOUGH = 0.5  # of minus the log likelihood: the noises are then within one of their own sigmas
# Of NOISES one after the other: which number serves which of the gyros, accelerometers, rows of velocity and attitude.
SPREAD = np.array([0, 0, 0, 1, 1, 1, 2, 2, 3, 4, 4, 5])


@dataclass(frozen=True)
class Group:
    """Error states that are reported together."""

    name: str
    key: str  # of PRIOR and of a recording's reference
    first: str  # name of the first state
    unit: str
    scale: float  # of the unit, in SI and rad
    axes: tuple[str, ...] = BODY


GROUPS = (
    Group("misalignment", "misalignment", "dmu_x", "arcmin", UNITS["angle"]["arcmin"], ("roll", "pitch", "yaw")),
    Group("gyro bias", "gyro_bias", "dbg_x", "deg/h", UNITS["angular rate"]["deg/h"]),
    Group("accelerometer bias", "accel_bias", "dba_x", "mg", MILLI_G),
    Group("delay", "delay", "d_tau", "ms", 1e-3, ("",)),
    Group("lever arm", "lever", "d_lever_x", "cm", 0.01),
    Group("bending", "flexure", "d_bend_x", "mrad", 1e-3),
    Group("gyro scale factor", "gyro_scale", "dkg_x", "ppm", 1e-6),
    Group("accelerometer scale factor", "accel_scale", "dka_x", "ppm", 1e-6),
    Group("gyro axes", "gyro_axes", "dkg_xy", "mrad", 1e-3, ("xy", "xz", "yx", "yz", "zx", "zy")),
    Group("accelerometer axes", "accel_axes", "dka_yx", "mrad", 1e-3, ("yx", "zx", "zy")),
)


# ---------------------------------------------------------------- the filter on a recording


def fly(
    recording: Recording,
    model: Any,
    noises: Array,
    start: Array,
    prior: Mapping[str, float],
    delay_sigma: Any,
    sensors: Sensors | None = None,
    informs: Array | None = None,
    recorded: bool = False,
) -> dict[str, Any]:
    """One pass of the filter over a recording whose master lies inside the slave's data, by HOLD_S at both ends.

    noises: (..., 9) in SI and rad, in the order of NOISES; leading axes are runs side by side.  start: (..., 19) where
    the estimates begin, as `estimates` has them.  prior: one sigma of each by name; delay_sigma: (...,) s, the delay's.
    sensors: what a model with states for it carries of scale factors, axes, instability, bending and the lever arm.
    informs: as of `Pass`.
    Returns, first axis the K messages: time (K,) s, nu, S and used (K, ..., 6), estimate and sigma (K, ..., n), verdict
    (K, ...); and pass, how the filter ended, and its record where that is asked for, where they are one: runs that
    begin with one delay are flown side by side.
    """
    runs = np.broadcast_shapes(np.shape(noises)[:-1], np.shape(start)[:-1], np.shape(delay_sigma))
    noises, start = (np.broadcast_to(part, (*runs, np.shape(part)[-1])) for part in (noises, start))
    delay_sigma = np.broadcast_to(delay_sigma, runs)
    delays, which = np.unique(start[..., 15], return_inverse=True)
    if len(delays) == 1:
        return _fly(recording, model, noises, start, prior, delay_sigma, sensors, informs, recorded)
    each = [np.flatnonzero(which.ravel() == i) for i in range(len(delays))]
    tracks = [_fly(recording, model, noises[i], start[i], prior, delay_sigma[i], sensors, informs) for i in each]
    common = sorted(set.intersection(*(set(track["time"]) for track in tracks)))
    out: dict[str, Any] = {"time": np.array(common)}
    for part in ("nu", "S", "used", "estimate", "sigma", "verdict"):
        at = [np.isin(track["time"], common) for track in tracks]
        joined = np.concatenate([track[part][rows] for track, rows in zip(tracks, at, strict=True)], axis=1)
        out[part] = joined[:, np.argsort(np.concatenate(each))]
    return out


def _fly(
    recording: Recording, model: Any, noises: Array, start: Array, prior: Mapping[str, float], delay_sigma: Array,
    sensors: Sensors | None, informs: Array | None, recorded: bool = False,
) -> dict[str, Any]:  # fmt: skip
    imu, master = recording.imu, recording.master
    assert master is not None and master.v_n is not None and master.position is not None
    spread = noises[..., SPREAD]
    R = spread[..., 6:] ** 2
    q = rotation.quaternion_from_euler(master.euler)
    tau = float(np.ravel(start[..., 15])[0])
    constants: dict[str, Any] = {
        "gyro_noise": spread[..., :3], "accel_noise": spread[..., 3:6], "mu_noise": np.zeros(3),
        "gyro_bias_noise": np.repeat(noises[..., 7:8], 3, axis=-1), "lever_b": start[..., 16:],
        "accel_bias_noise": np.repeat(noises[..., 8:9], 3, axis=-1),
        "tau_noise": np.where(np.asarray(delay_sigma) > 0, noises[..., 6], 0.0),
    }  # fmt: skip
    estimated = {"q_b2m_wxyz": rotation.turned(np.array([1.0, 0, 0, 0]), start[..., 12:15]),
                 "gyro_bias": start[..., 6:9], "accel_bias": start[..., 9:12], "tau": start[..., 15]}  # fmt: skip
    sigmas = {"q_b2m_wxyz": prior["misalignment"], "gyro_bias": prior["gyro_bias"], "accel_bias": prior["accel_bias"],
              "tau": delay_sigma, "lever_b": prior["lever"]}  # fmt: skip
    how: dict[str, Any] = {"sigmas": sigmas}
    considered = None
    if sensors is not None:
        del sigmas["lever_b"]
        constants, P, estimated, considered = carried(sensors, constants, sigmas, estimated)
        how = {"P": P}
    elif "d_lever_x" in model.states:
        estimated["lever_b"] = constants.pop("lever_b")
    else:
        del sigmas["lever_b"]
    begin, end, dtheta, dv = imu.increments
    opened = master.time - tau
    k = int(np.argmax(opened - begin[0] > 4 * HALF_SPAN_S + 1e-6))
    i = int(np.searchsorted(end, opened[k] + HALF_SPAN_S)) + 1
    opening = Message(master.time[k], R, v_m_n=master.v_n[k], q_m2n_wxyz=q[k], position=master.position[k])
    nav, P = first(opening, model, constants, **how, estimates=estimated, matching=MATCHING,
                      increments=Increments(begin[:i], end[:i], dtheta[:i], dv[:i]))  # fmt: skip
    kept = {name for struct in model.manifest["filter"]["carried"] for name in model.layout[struct]} & set(constants)
    nav |= {name: np.broadcast_to(constants.pop(name), (*P.shape[:-2], 3)) for name in sorted(kept)}
    loop = CompiledFilter(model, nav, P)
    score = Score(loop.P.shape[:-2]) if sensors is not None and sensors.probed else None
    record = Record(loop) if recorded else None
    messages = {"time": master.time, "v_m_n": master.v_n, "q_m2n_wxyz": q, "position": master.position}
    track = Pass(loop, imu, float(end[i - 1]), messages, tau, constants, R, considered, score, informs).fly()
    return {
        "time": master.time[track.taken],
        **{part: getattr(track, part) for part in ("nu", "S", "used", "verdict")},
        "estimate": estimates(track.nav, start),
        "sigma": np.sqrt(track.variance),
        "pass": track,
        "record": record,
    }


def estimates(nav: dict[str, Array], start: Array) -> Array:
    """(..., 19 or 46) in the order of the error states: zeros for attitude and velocity, then what is estimated."""
    mu = rotation.vector_from_matrix(rotation.matrix_from_quaternion(nav["q_b2m_wxyz"]))
    none = np.zeros((*mu.shape[:-1], 6))
    lever = np.broadcast_to(nav.get("lever_b", start[..., 16:]), mu.shape)
    more = [nav[name] for name in ADDED if name != "lever_b"] if "gyro_scale" in nav else []
    return np.concatenate([none, nav["gyro_bias"], nav["accel_bias"], mu, nav["tau"][..., None], lever, *more], axis=-1)


# ---------------------------------------------------------------- one replay


def prepare(recording: Recording, rate_hz: float | None) -> Recording:
    """The recording with its master thinned and cut to what the slave covers."""
    master = recording.master
    if master is None:
        raise BoresightError(f"{recording.name}: it has no master, and matching needs one; describe it in [master]")
    for name, says in (("v_n", "velocity"), ("position", "position")):
        if getattr(master, name) is None:
            raise BoresightError(
                f"{recording.name}: its master has no {says}; describe master.{says}, or use --model euler-matching"
            )
    _, end = recording.imu.intervals()
    slack = 0.01 * recording.imu.dt
    inside = (master.time - HOLD_S >= end[0] - slack) & (master.time + HOLD_S <= end[-1] + slack)
    master = thinned(master.cut(inside), rate_hz)
    if len(master.time) < 10:
        count = len(master.time)
        raise BoresightError(f"{recording.name}: {count} samples of the master fall into the slave's data; it needs 10")
    return replace(recording, master=master)


def run(
    recording: Recording,
    model: Any,
    *,
    noise: Mapping[str, Any] | None = None,
    prior: Mapping[str, float] | None = None,
    lever_b: Any = None,
    delay: float = 0.0,
    rate_hz: float | None = None,
    sensors: Sensors | None = None,
    assumed: Sensors | None = ASSUMED,
    grade: str | None = None,
    smooth: bool = False,
    progress: Callable[[str], None] = lambda line: None,
) -> dict[str, Any]:
    """Replay a recording with the delay as a state and without it; what came out, as a dict that json can write.

    noise: what is known of NOISES, in SI and rad, one number or one for each part; the rest is chosen by likelihood,
    with the delay as a state.  prior: what is known otherwise than PRIOR has it, SI and rad.  lever_b: (3,) m, as
    believed.  delay: s, where its estimate begins.  rate_hz: use the master no more often than this.
    grade: of the slave, as of `sensors.GRADES`; a noise is held against what its sensors have.
    sensors: what is carried.  assumed: scale factors and axes that widen each sigma where none are carried; None: none.
    smooth: a last pass is recorded and smoothed.
    It is flown twice: what the first pass ends with is where the others begin, with the same sigmas, so that they are
    linear about it.  Fields: docs/recordings.md.  Raises BoresightError if the recording cannot be replayed.
    """
    prior = {**PRIOR, **(prior or {})}
    given = dict(noise or {})
    if sensors is not None:
        if lever_b is None:
            sensors = replace(sensors, lever=prior["lever"])
        prior |= sizes_of(sensors)
        # what is told of an instability is not looked for
        given |= {f"{n}_walk": LEAST[f"{n}_walk"] for n in ("gyro", "accel") if getattr(sensors, f"{n}_instability")}
    cut = prepare(recording, rate_hz)
    noises, free = noise_vector(given)
    low, high = (np.array([one.limits[i] for one in PARTS]) for i in (0, 1))
    start = np.zeros((2, 19))
    start[:, 16:] = 0.0 if lever_b is None else lever_b
    start[0, 15] = delay
    delay_sigma = np.array([prior["delay"], 0.0])
    progress("first pass")
    began = time.monotonic()
    passed = 0
    while passed < FIRST_PASSES:  # H is along the motion at the delay that a pass begins with
        passed += 1
        track = fly(cut, model, noises, start[0], prior, prior["delay"], sensors)
        moved = track["estimate"][-1, 15] - start[0, 15]
        start[0] = track["estimate"][-1, :19]
        if abs(moved) < DELAY_NEAR_S:
            break
    pass_s = (time.monotonic() - began) / passed
    start[1] = np.where(np.arange(19) == 15, 0.0, start[0])
    lasting(progress, first_look(model, track))
    informs = track["pass"].informs
    # A noise that is far too large comes down slowly; what is white in the innovations' scatter is near.
    late = slice(len(track["nu"]) // 2, None)
    whole = track["used"][late].all(-1)
    if whole.sum() < 3:
        reported = ", ".join(f"{name} {count}" for name, count in refused(track["verdict"][late]).items())
        raise BoresightError(f"{recording.name}: hardly any message of its second half was used; refused: {reported}")
    scatter = np.std(np.diff(track["nu"][late][whole], axis=0), axis=0) / np.sqrt(2)
    near = np.array([*noises[:2], scatter[:2].max(), scatter[2], scatter[3:5].max(), scatter[5], *noises[6:]])
    noises = np.where(free, np.clip(near, low, high), noises)

    def flown(noises: Array) -> dict[str, Any]:
        return fly(cut, model, noises, start[0], prior, prior["delay"], sensors, informs)

    if free.any():
        lasting(progress, f"{free.sum()} noises are to be chosen: {USUAL_PASSES} passes or so, about "
                f"{USUAL_PASSES * 1.7 * pass_s:.0f} s")  # fmt: skip
    noises, unsure, passes = most_likely(flown, noises, free, (low, high), enough=ENOUGH, progress=progress)
    progress("last pass")
    track = fly(cut, model, noises, start, prior, delay_sigma, sensors, informs)
    both = {
        name: {part: values[:, i] for part, values in track.items() if part not in ("time", "pass", "record")}
        for i, name in enumerate(("with", "without"))
    }
    bare = sensors or Sensors(lever=prior["lever"] if "d_lever_x" in model.states else 0.0)
    unheld, more = None, np.zeros(len(model.states))
    if not calibration(bare).any():
        progress("score test")
        probed = replace(bare, probed=True)
        scored = fly(cut, compiled(MODEL), noises, start[0], prior, prior["delay"], probed, informs)["pass"]
        unheld, more = unmodelled(scored, prior), unknown(scored.loop.P, scored.score, assumed)[: len(model.states)]
    found = states(model, track["time"], both, recording.reference, prior, more)
    back: dict[str, Any] = {}
    if smooth:
        progress("smoother")
        back = backwards(fly(cut, model, noises, start[0], prior, prior["delay"], sensors, informs, True)["record"])
        back |= {f"{part}estimate": estimates(back[f"{part}nav"], start[0]) for part in ("", "filter_")}
        back["of"] = quantities(model, found)
    assert cut.master is not None
    stated_noise = said_noise(noises, free, unsure, passes)
    return {
        "recording": recording.name,
        "title": recording.title,
        "read": [asdict(finding) for finding in check(recording)],
        "model": model.name,
        "duration_s": float(cut.master.time[-1] - cut.master.time[0]),
        "updates": len(track["time"]),
        "used": int((track["verdict"][:, 0] == Fate.TAKEN).sum()),
        "refused": refused(track["verdict"][:, 0]),
        "lever_given_m": None if lever_b is None else np.asarray(lever_b, float).tolist(),
        "noise": stated_noise,
        "hidden": hidden(stated_noise, grade),
        "sensors": None if sensors is None else asdict(sensors),
        "assumed": None if unheld is None or assumed is None else asdict(assumed),
        "unmodelled": unheld,
        "minus_log_likelihood": {name: float(minus_log_likelihood(part)) for name, part in both.items()},
        "states": found,
        "smoothed": summary(back) if smooth else None,
        "nis": {name: consistency(part["nu"] / np.sqrt(part["S"]), part["used"]) for name, part in both.items()},
        "notes": list(recording.notes),
        "history": {"time_s": track["time"], "states": model.states, **both, "smoothed": back},
    }


def quantities(model: Any, found: Sequence[Mapping[str, Any]]) -> list[Quantity]:
    """What is smoothed and shown: what is reported, and attitude and velocity by their sigmas."""
    out = []
    for s in found:
        group = next(g for g in GROUPS if g.name == s["state"])
        at = model.states.index(group.first) + group.axes.index(s["axis"])
        out.append(Quantity(named(s), group.unit, group.scale, at))
    for at, row in zip((3, 4, 5, 0, 1, 2), ROWS, strict=True):  # phi stands before dv
        unit, scale = ("arcmin", UNITS["angle"]["arcmin"]) if at < 3 else ("mm/s", 1e-3)
        out.append(Quantity(row, unit, scale, at, in_nav=False))
    return out


def first_look(model: Any, track: Mapping[str, Any]) -> str:
    """What one pass found with noises that no search has chosen."""
    parts = []
    for group in GROUPS[:4]:
        at = model.states.index(group.first)
        found, sigma = (track[part][-1, at : at + len(group.axes)] / group.scale for part in ("estimate", "sigma"))
        numbers = ", ".join(number(value, one) for value, one in zip(found, sigma, strict=True))
        parts.append(f"{group.name} {numbers} {group.unit}")
    return f"first pass, usual noises: {'; '.join(parts)}"


def unmodelled(flown: Pass, prior: Mapping[str, float]) -> list[dict[str, Any]]:
    """The score test of each group of sensors' errors that are not carried, and what the smallest noticed one does.

    does: by Group.name, one sigma of its worst axis in its unit, of errors of the smallest size.
    """
    assert flown.score is not None
    P = flown.loop.P
    sensitivity, states_of = driven(P), flown.loop.model.states
    out = []
    for name, one in flown.score.noticed().items():
        smallest = float(one.smallest) if np.isfinite(one.smallest) else None  # none: not in this motion
        does = {}
        for group in GROUPS[:5]:
            if prior.get(group.key) and (group.key != "lever" or P[16, 16] > 0):
                at = states_of.index(group.first)
                per_unit = np.linalg.norm(sensitivity[at : at + len(group.axes), SCORED[name]], axis=-1).max()
                value = None if smallest is None else float(smallest * per_unit / group.scale)
                does[group.name] = {"value": value, "unit": group.unit}
        out.append({"name": name, "statistic": float(one.statistic), "bound": one.bound,
                    "noticed": bool(one.statistic > one.bound), "smallest": smallest, "does": does})  # fmt: skip
    return out


def unknown(P: Array, score: Score, assumed: Sensors | None) -> Array:
    """(46,) one sigma more of each state: by what is assumed of scale factors and axes, and by what the test notices.

    Of what it notices the likeliest size counts as a sigma, that of a unit of the poorest grade: another error, as a
    lever arm that is not zero, would else be explained by sizes that no sensor has.
    """
    sensitivity = driven(P)
    variance = np.zeros(len(sensitivity))
    if assumed is not None:
        variance += np.einsum("ni,ij,nj->n", sensitivity, calibration(assumed), sensitivity)
    seen = [np.arange(15)[SCORED[name]] for name, one in score.noticed().items() if one.statistic > one.bound]
    if seen:
        at = np.concatenate(seen)
        before, information = calibration(GRADES["mems"])[np.ix_(at, at)], score.information[np.ix_(at, at)]
        likeliest = before @ np.linalg.solve(np.eye(len(at)) + information @ before, score.gradient[at])
        variance += (sensitivity[:, at] @ likeliest) ** 2
    return np.sqrt(variance)


def sizes_of(sensors: Sensors) -> dict[str, float]:
    """One sigma of each group that is estimated, as PRIOR has them; of the axes the first one's."""
    sizes = {"lever": sensors.lever, "flexure": sensors.bending}
    if sensors.estimated:
        sigma = np.sqrt(np.diag(calibration(sensors)))
        for name in ("gyro_scale", "accel_scale", "gyro_axes", "accel_axes"):
            sizes[name] = float(sigma[ADDED[name].start - CALIBRATION.start])
    return sizes


def hidden(noise: Mapping[str, Any], grade: str | None) -> list[dict[str, Any]]:
    """Chosen noises beyond MOST times what sensors of the grade have, or the worst: they stand for something else."""
    known = NOISE_OF_GRADE[grade or WORST]
    out = []
    for name, most in known.items():
        one = noise[name]
        unit = UNITS[NOISES[name].kind][NOISES[name].unit]
        if one["chosen"] and max(one["value"]) > MOST * most / unit:
            out.append({"noise": name, "value": max(one["value"]), "usual": most / unit, "unit": one["unit"]})
    return out


def noise_vector(given: Mapping[str, Any]) -> tuple[Array, Array]:
    """(9,) noises where a search begins, or as given, and (9,) whether each is to be searched for."""
    unknown = set(given) - set(NOISES)
    if unknown:
        raise BoresightError(f"no noise {sorted(unknown)[0]!r}; there are {', '.join(NOISES)}")
    values, free = [], []
    for name, one in NOISES.items():
        reported = given.get(name)
        value = np.resize(np.asarray(one.first if reported is None else reported, float), len(one.parts))
        value = np.where(value == 0, LEAST.get(name, 0.0), value)
        if not ((value >= one.limits[0]) & (value <= one.limits[1])).all():
            low, high = (f"{limit / UNITS[one.kind][one.unit]:.2g}" for limit in one.limits)
            shown = ", ".join(f"{v / UNITS[one.kind][one.unit]:.3g}" for v in value)
            raise BoresightError(f"{name} noise {shown} {one.unit} is out of range: {low} to {high}")
        values.append(value)
        free += [reported is None] * len(one.parts)
    return np.concatenate(values), np.array(free)


def said_noise(noises: Array, free: Array, unsure: Array, passes: int) -> dict[str, Any]:
    """By name: unit, parts, value, whether it was chosen, and whether it is more than the least that is looked for.

    low and high: 95 % of what was chosen, by one sigma of the logarithms, `unsure`; high is None where none is.
    """
    with np.errstate(over="ignore"):
        factor = np.exp(BAND * unsure)
    out: dict[str, Any] = {"passes": passes}
    for name, one in NOISES.items():
        mine = [i for i, part in enumerate(PARTS) if part is one]
        out[name] = {
            "unit": one.unit,
            "parts": list(one.parts),
            "value": (noises[mine] / UNITS[one.kind][one.unit]).tolist(),
            "low": (noises[mine] / factor[mine] / UNITS[one.kind][one.unit]).tolist(),
            "high": [
                float(noises[i] * factor[i] / UNITS[one.kind][one.unit]) if np.isfinite(factor[i]) else None
                for i in mine
            ],
            "chosen": bool(free[mine].any()),
            "seen": (noises[mine] > 1.05 * one.limits[0]).tolist(),
        }
    return out


def states(
    model: Any,
    time: Array,
    both: Mapping[str, Any],
    reference: Mapping[str, Array],
    prior: Mapping[str, float],
    more: Array,
) -> list[dict[str, Any]]:
    """One entry for each quantity: what it is at the end, with and without the delay state, and what else is known.

    more: (n,) sigma of each state beside the filter's own, which alone is that of the noises.
    """
    out = []
    for group in GROUPS:
        if group.first not in model.states or not prior.get(group.key):
            continue  # a state that is left out, or considered
        at = model.states.index(group.first)
        known = reference.get({"lever": "lever_arm"}.get(group.key, group.key))
        for i, axis in enumerate(group.axes):
            (estimate, noise), (bare, bare_sigma) = (
                [both[name][part][-1, at + i] / group.scale for part in ("estimate", "sigma")]
                for name in ("with", "without")
            )
            sigma = np.hypot(noise, more[at + i] / group.scale)
            wide = np.flatnonzero(both["with"]["sigma"][:, at + i] > 2 * both["with"]["sigma"][-1, at + i])
            stated = None if known is None else known[i] / group.scale
            before = prior[group.key] / group.scale
            numbers = {
                "estimate": estimate, "sigma": sigma, "noise_sigma": noise, "prior_sigma": before,
                "of_prior": sigma / before,
                "settled_s": time[wide[-1] + 1] if len(wide) else time[0], "reference": stated,
                "difference_sigmas": None if stated is None else (estimate - stated) / sigma,
                "without_delay": bare, "without_delay_sigma": bare_sigma,
            }  # fmt: skip
            reported = {name: None if value is None else float(value) for name, value in numbers.items()}
            out.append({"state": group.name, "axis": axis, "unit": group.unit} | reported)
    return out


def refused(verdict: Array) -> dict[str, int]:
    """How many messages were refused, by the name of their verdict (K,)."""
    counts = {code: int((verdict == code).sum()) for code in Fate if code > Fate.TAKEN}
    return {code.name.lower().replace("_", " "): count for code, count in counts.items() if count}


# ---------------------------------------------------------------- saying it


def number(value: float, sigma: float) -> str:
    """A value to two digits of its sigma, and no more."""
    return f"{value:.{max(0, 1 - int(np.floor(np.log10(sigma))))}f}" if sigma > 0 else f"{value:.3g}"


def named(state: Mapping[str, Any]) -> str:
    return f"{state['state']} {state['axis']}".strip()


def report(result: Mapping[str, Any]) -> str:
    """One page of Markdown, which a terminal shows as well."""
    nis, noise = result["nis"], result["noise"]
    known = [s for s in result["states"] if s["difference_sigmas"] is not None]
    table = [("", "estimate", "1 sigma", "by noise", "unit", "stated", "off, sigmas")]
    course = [("", "of the prior", "settled", "delay taken as 0")]
    for s in result["states"]:
        bare = "0, held" if s["state"] == "delay" else number(s["without_delay"], s["sigma"])
        stated = (number(s["reference"], s["sigma"]), f"{s['difference_sigmas']:+.1f}") if s in known else ("", "")
        table.append((
            named(s), number(s["estimate"], s["sigma"]), number(s["sigma"], s["sigma"]),
            number(s["noise_sigma"], s["noise_sigma"]), s["unit"], *stated,
        ))  # fmt: skip
        course.append((named(s), f"{s['of_prior']:.2g}", f"{s['settled_s']:.0f} s", bare))
    checks = [
        ("NIS per row", "mean", "95 % band", "by quarter of the time", "neighbours", "bound"),
        *((
            label, f"{reported['mean']:.3f}", "[{:.3f}, {:.3f}]".format(*reported["band"]),
            " ".join("none" if value is None else f"{value:.2f}" for value in reported["by_quarter"]),
            f"{max(reported['lag1'], key=abs):+.3f}", f"{reported['lag1_bound']:.3f}",
        ) for label, reported in (("delay a state", nis["with"]), ("delay taken as 0", nis["without"]))),
    ]  # fmt: skip
    rows = [
        ("mean NIS", *(f"{row.split()[0][0]} {row.split()[1]}" for row in ROWS)),
        *((f"{name} delay", *(f"{v:.2f}" for v in nis[name]["per_row"])) for name in ("with", "without")),
    ]
    agree = [named(s) for s in known if abs(s["difference_sigmas"]) <= 2]
    differ = [f"{named(s)} ({s['difference_sigmas']:+.1f})" for s in known if abs(s["difference_sigmas"]) > 2]
    delay = next(s for s in result["states"] if s["state"] == "delay")
    lever = "estimated" if any(s["state"] == "lever arm" for s in result["states"]) else _lever(result)
    poor = [s for s in result["states"] if s["of_prior"] > 0.5]
    lines = [
        f"# {result['title'] or result['recording']}",
        "",
        *(f"**{line}**\n" for line in hidden_lines(result["hidden"])),
        f"Model {result['model']}: {result['updates']} messages of the master in {result['duration_s']:.1f} s, "
        f"{_used(result)}; nothing calibrated beforehand.",
        f"Lever arm (front, right, down): {lever}.",
        *([] if result["sensors"] is None else [f"Sensors: {described(Sensors(**result['sensors']))}."]),
        "",
        f"**The master is {number(delay['estimate'], delay['sigma'])} +- {number(delay['sigma'], delay['sigma'])} ms "
        f"old.**  Mean NIS with this delay {nis['with']['mean']:.3f}, without it at the same noises "
        f"{nis['without']['mean']:.1f}; 95 % band {nis['with']['band'][0]:.3f} to {nis['with']['band'][1]:.3f}.",
        "",
        *markdown(table),
        "",
    ]
    if known:
        lines += [
            f"- Within 2 sigmas of what is stated: {', '.join(agree) or 'nothing'}.",
            f"- Beyond: {', '.join(differ) or 'nothing'}; in our sigmas, those of what is stated are not known.",
        ]
    lines += [
        *_sigmas(result),
        "- Stated: by the recording's description.",
        f"- Hardly shown by this motion (sigma above half of the prior): {', '.join(map(named, poor)) or 'nothing'}.",
        "",
        *markdown(course),
        "",
        "- Of the prior: the sigma by noise at the end.  Settled: from when on it is within twice its last.",
        "- Delay taken as 0: what a filter finds that does not estimate it.",
        "",
        *markdown(checks),
        "",
        *markdown(rows),
        "",
        "- Innovation: what the filter expected of the master less what the master measured.",
        "- NIS: an innovation squared over its variance; 1 on average where noises and model are right.",
        "- Neighbours: the largest correlation of one innovation with the next, which shows what is not modelled.",
        "- v, a: velocity and attitude.",
        "",
        "Noises, one sigma; in brackets 95 % of those that were chosen, by the information in the innovations:",
        "",
        *(f"- {_noise(name, one)}" for name, one in noise.items() if name != "passes"),
        "",
    ]
    if not nis["with"]["white"] and lever == "taken as zero":
        lines += ["**Neighbours correlate, and the lever arm was taken as zero: look whether it is there, by",
                  "--model velocity-attitude-lever, before anything else.**", ""]  # fmt: skip
    if result["smoothed"] is not None:
        lines += smoothed_lines(result["smoothed"], markdown, number)
    if result["unmodelled"] is not None:
        lines += score_lines(result["unmodelled"])
    if noise["passes"]:
        lines += [
            f"Chosen in {noise['passes']} passes: where the innovations with the delay as a state are most likely.",
            "Their mean NIS is then near 1 by construction; its quarters and neighbours' correlation are not chosen.",
        ]
    lines += [f"Note: {note}" for note in result["notes"]]
    lines += [
        "",
        "## What was read",
        "",
        *(f"- {one['level']}: {one['where']}: {one['text']}" for one in result["read"]),
    ]
    return "\n".join(lines)


def hidden_lines(found: Sequence[Mapping[str, Any]]) -> list[str]:
    """What noises say that no such sensor has."""
    return [
        f"{one['noise'].replace('_', ' ')} noise came out as {one['value']:.3g} {one['unit']}, and {one['usual']:.2g} "
        "is usual: it hides something else, as a wrong heading, lever arm, scale factor or axis; the estimates are not "
        "to be believed."
        for one in found
    ]


def _sigmas(result: Mapping[str, Any]) -> list[str]:
    """What the column 1 sigma holds beside the filter's own."""
    if result["unmodelled"] is None:
        return []
    parts = []
    if result["assumed"] is not None:
        parts.append(described(Sensors(**result["assumed"])).replace(", considered", "").replace(";", " and"))
        parts[0] += " (assumed; --with or --grade says better)"
    if seen := [one["name"] for one in result["unmodelled"] if one["noticed"]]:
        parts.append(f"what the innovations show of {' and '.join(seen)}")
    return [f"- 1 sigma: by noise, all that the filter knows of, and by {', and by '.join(parts)}."] if parts else []


def _used(result: Mapping[str, Any]) -> str:
    if not result["refused"]:
        return "all of them used"
    reasons = ", ".join(f"{name} {count}" for name, count in result["refused"].items())
    return f"of which {result['used']} used; refused: {reasons}"


def score_lines(found: Sequence[Mapping[str, Any]]) -> list[str]:
    """What the score test says, for the report."""
    seen = [one["name"] for one in found if one["noticed"]]
    table = [
        ("not carried", "score", "bound", "noticed from", *(f"{n}, {d['unit']}" for n, d in found[0]["does"].items())),
        *(
            (
                one["name"],
                f"{one['statistic']:.1f}",
                f"{one['bound']:.1f}",
                "never" if one["smallest"] is None
                else f"{one['smallest'] * 1e6:.0f} ppm" if "scale" in one["name"]
                else f"{one['smallest'] * 1e3:.2g} mrad",
                *("-" if d["value"] is None else f"{d['value']:.2g}" for d in one["does"].values()),
            )
            for one in found
        ),
    ]  # fmt: skip
    return [
        "",
        f"**The innovations show {' and '.join(seen)}: fly with --with or --grade.**" if seen
        else "The innovations show neither scale factors nor axes.",
        "Noticed from: the size, one sigma of each axis, that 95 % of such drives would show, 1 % falsely.",
        "To the right, by how much it drives off the worst axis of each estimate if nobody notices.",
        "",
        *markdown(table),
        "",
    ]  # fmt: skip


def described(sensors: Sensors) -> str:
    """What is carried of the sensors, with its sizes, for the report."""
    how = "estimated" if sensors.estimated else "considered"
    parts = []
    for names, unit, scale in (("scale", "ppm", 1e-6), ("axes", "mrad", 1e-3)):
        gyro, accel = (f"{getattr(sensors, f'{sensor}_{names}') / scale:.4g}" for sensor in ("gyro", "accel"))
        both = f"{gyro} {unit}" if gyro == accel else f"{gyro} {unit} of gyros and {accel} {unit} of accelerometers"
        parts += [f"{names} {both}, {how}"] if {gyro, accel} != {"0"} else []
    for name, sigma, kind, unit in (
        ("gyro", sensors.gyro_instability, "angular rate", "deg/h"),
        ("accelerometer", sensors.accel_instability, "acceleration", "ug"),
    ):
        if sigma:
            parts.append(f"{name} instability {sigma / UNITS[kind][unit]:.3g} {unit} over {sensors.correlation_s:g} s")
    if sensors.bending:
        parts.append(f"bending {sensors.bending * 1e3:.3g} mrad at {sensors.bending_hz:g} Hz")
    return "; ".join(parts)


def _interval(value: float, low: float, high: float | None, seen: bool) -> str:
    if not seen:
        return f"below {value:.1g}"
    if high is None:
        return f"{value:.3g} (the innovations do not tell)"
    return f"{value:.3g} ({low:.3g} to {high:.3g})" if high > low else f"{value:.3g}"


def _noise(name: str, one: Mapping[str, Any]) -> str:
    shown = list(map(_interval, one["value"], one["low"], one["high"], one["seen"]))
    parts = "" if len(one["parts"]) == 1 else f"{' and '.join(one['parts'])}, "
    name, whence = name.replace("_", " "), "chosen" if one["chosen"] else "given"
    if whence == "given" and not any(one["seen"]):
        return f"{name} none (given)"
    return f"{name} {' and '.join(shown)} {one['unit']} ({parts}{whence})"


def _lever(result: Mapping[str, Any]) -> str:
    given = result["lever_given_m"]
    return "taken as zero" if given is None else f"{', '.join(f'{v * 100:.3g}' for v in given)} cm, given"


def markdown(rows: Sequence[Sequence[str]]) -> list[str]:
    """A table whose columns also stand under each other as plain text."""
    width = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = ["| " + " | ".join(cell.ljust(w) for cell, w in zip(row, width, strict=True)) + " |" for row in rows]
    return [lines[0], "|" + "|".join("-" * (w + 2) for w in width) + "|", *lines[1:]]


def draw_innovations(result: Mapping[str, Any], axes: Array) -> None:
    """(2, 3) axes: velocity above, attitude below; with the delay within its bands, and without it."""
    history = result["history"]
    time = history["time_s"]
    for i, ax in enumerate(axes.ravel()):
        scale, unit = (1e-3, "mm/s") if i < 3 else (UNITS["angle"]["arcmin"], "arcmin")
        sigma = np.sqrt(history["with"]["S"][:, i]) / scale
        ax.plot(time, history["without"]["nu"][:, i] / scale, ".", ms=1.6, color=ORANGE,
                label="delay taken as 0, where inside")  # fmt: skip
        ax.fill_between(time, -BAND * sigma, BAND * sigma, color=BLUE, alpha=0.25, lw=0, label="95 % band")
        ax.plot(time, history["with"]["nu"][:, i] / scale, ".", ms=1.6, color=BLUE, label="delay a state")
        reach = 7 * float(np.median(sigma))
        ax.set_ylim(-reach, reach)  # without the delay most lie far outside
        ax.set_title(f"{ROWS[i]}: NIS {result['nis']['with']['per_row'][i]:.2f}, without "
                     f"{result['nis']['without']['per_row'][i]:.1f}")  # fmt: skip
        if i % 3 == 0:
            ax.set_ylabel(f"innovation [{unit}]")
        ax.set_xlabel("time [s]" if i >= 3 else "")


def draw_states(result: Mapping[str, Any], axes: Array) -> None:
    """(rows, 3) axes: a row for each group of three, then the delay and NIS in time."""
    history = result["history"]
    time = history["time_s"]
    places = [*axes[:-1].ravel(), axes[-1, 0]]
    ordered = sorted(result["states"], key=lambda s: s["state"] == "delay")
    for state, ax in zip(ordered, places, strict=True):
        group = next(g for g in GROUPS if g.name == state["state"])
        at = history["states"].index(group.first) + group.axes.index(state["axis"])
        value, sigma = (history["with"][part][:, at] / group.scale for part in ("estimate", "sigma"))
        # The first seconds are off the scale by design: the prior is wide.
        reach = max(12 * sigma[-1], 1.3 * abs((state["reference"] or value[-1]) - value[-1]))
        ax.fill_between(
            time,
            value - BAND * sigma,
            value + BAND * sigma,
            color=BLUE,
            alpha=0.25,
            lw=0,
            label="95 % band by noise, in the title 1 sigma",
        )
        ax.plot(time, value, color=BLUE, label="estimate")
        if group.name != "delay":
            bare = history["without"]["estimate"][:, at] / group.scale
            ax.plot(time, bare, color=ORANGE, lw=0.7, label="estimate, delay taken as 0")
        if state["reference"] is not None:
            ax.axhline(state["reference"], color="0.2", ls=(0, (5, 3)), lw=0.9, label="stated")
        ax.set_ylim(value[-1] - reach, value[-1] + reach)
        ax.set_title(f"{named(state)}: {number(state['estimate'], state['noise_sigma'])} $\\pm$ "
                     f"{number(state['noise_sigma'], state['noise_sigma'])} {state['unit']}")  # fmt: skip
        ax.set_ylabel(f"[{state['unit']}]")
    over = axes[-1, 1]
    for name, color in (("without", ORANGE), ("with", BLUE)):
        part = history[name]
        square = np.where(part["used"], part["nu"] ** 2 / part["S"], np.nan)
        count = max(1, len(time) // 50)
        whole = len(time) // count * count
        binned = np.ma.masked_invalid(square[:whole].reshape(-1, count * square.shape[1])).mean(1)
        over.semilogy(time[:whole].reshape(-1, count).mean(1), binned, color=color)
    over.axhspan(*chi_square_band(1, count * square.shape[1]), **FAINT)
    over.set_title("NIS per row in time and 95 % band; orange: delay taken as 0")
    ratio = axes[-1, 2]
    shown = result["states"][::-1]
    ratio.barh(range(len(shown)), [s["of_prior"] for s in shown], color=BLUE, height=0.7)
    ratio.set_yticks(range(len(shown)), [named(s) for s in shown], fontsize=5)
    ratio.set(xscale="log", xlim=(min(s["of_prior"] for s in shown) / 3, 1))
    ratio.set_title("sigma at the end, part of the prior")
    ratio.set_axisbelow(True)
    for ax in axes[-1, :2]:
        ax.set_xlabel("time [s]")


def write(result: Mapping[str, Any], sheets: Sheets) -> None:
    """One page of HTML that holds the report, its pictures and its numbers, and the pictures."""
    from boresight.studies.page import page

    base = f"transfer-replay-{result['recording']}"
    rows = len(result["states"]) // 3 + 1
    with sheets(f"{base}-innovations", 11, 5.5, nrows=2, ncols=3, sharex=True) as (drawing, axes):
        draw_innovations(result, axes)
        shown = axes[0, 0].get_legend_handles_labels()
        drawing.legend(*shown, loc="outside lower center", ncols=3, markerscale=4)
    with sheets(f"{base}-states", 11, 2.2 * rows, nrows=rows, ncols=3) as (drawing, axes):
        draw_states(result, axes)
        drawing.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    captions = [
        "Innovations, what the filter expected less what the master measured, within their 95 % bands",
        "Estimates in time, within the 95 % bands of the noises alone",
    ]
    if result["smoothed"] is not None:
        draw_smoothed(result["history"]["smoothed"], sheets, f"{base}-smoothed")
        captions.append("Filter and smoother, within the 95 % bands of the noises alone")
    pictures = list(zip(captions, sheets.written, strict=True))
    numbers = {name: value for name, value in result.items() if name != "history"}
    sheets.text(f"{base}.html", page(result["title"] or result["recording"], report(result), pictures, numbers))


def study(model: str) -> Study:
    """The replay by this model.  Good: NIS with the delay is consistent."""

    def flown(asked: Replay, progress: Progress) -> dict[str, Any]:
        progress("loading the filter: its C is compiled once on a machine")
        return run(asked.recording, compiled(model), **asked.settings, progress=progress)

    return Study(f"replay {model}", (model,), Replay, flown, report, write,
                 good=lambda result: result["nis"]["with"]["consistent"] and not result["hidden"],
                 markdown=True)  # fmt: skip
