"""A built-in model along a nominal motion: the start by its causes, and the steps that its filter flies.

    values = settings(model, grade="tactical") | chosen({"gyro_noise": "0.1 deg/sqrt(h)"}, model)
    start, steps = flight(model, nominal_motion, values)

Sizes are one sigma, SI and rad, under the name of what has them: a noise density or another input of the model, a
measurement (of each of its rows), a block of states (of the start).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from boresight.analysis.linear import blocks
from boresight.errors import BoresightError, did_you_mean
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.simulation import hull, motions
from boresight.runtime.transfer.sensors import ADDED, MODEL, Sensors, carried, sized
from boresight.runtime.units import DEG, DEG_H, HOUR, MILLI_G, UNITS

# A MEMS slave beside a good master, as in the study of the sea.
SIZES: dict[str, Any] = {
    "gyro_noise": 0.15 * DEG / np.sqrt(HOUR), "accel_noise": 0.05 / np.sqrt(HOUR),
    "phi": 0.05 * DEG, "eps": 0.05 * DEG, "psi": 0.05 * DEG, "dv_n": 0.05, "d_position": np.array([1e-6, 1e-6, 10.0]),
    "d_gyro_bias": 20 * DEG_H, "d_accel_bias": 2 * MILLI_G, "dmu": np.array([0.5, 0.5, 2.0]) * DEG, "d_tau": 0.01,
    "d_lever": 0.1, "d_reference_error": 0.1 * DEG,
    "velocity": 0.01, "dcm": 0.003 * DEG, "dcm_exact": 0.003 * DEG, "quaternion": 0.003 * DEG,
    "euler": 0.003 * DEG, "euler_exact": 0.003 * DEG, "zupt": 0.01, "zaru": 10 * DEG_H, "azimuth": 0.01 * DEG,
}  # fmt: skip
MATCHED = (("velocity",), ("dcm", "euler_exact"), ("zupt",), ("azimuth",))  # of each the first that a model has
FOLLOWING = ("phi", "psi", "eps", "dv_n")  # blocks that a slave takes over from its master
CALIBRATION = ("d_gyro_scale", "d_accel_scale", "d_gyro_axes", "d_accel_axes")  # considered, as `carried` has it
LEVER_B = (3.0, 1.0, -1.0)  # m
LATITUDE = 36 * DEG
MOST = 1_000_000  # steps of a motion


@dataclass(frozen=True)
class Nominal:
    """A motion and what is measured along it.  times: (2 N + 1,) s, the ends of N steps and their middles.

    inputs: of the models' functions by name, (2 N + 1, ...), as of `motions.inputs_along`.  every: steps to an update.
    """

    name: str
    times: Array
    inputs: dict[str, Array]
    every: int


def frame_of(model: Any) -> str:
    return "ENU" if str(model.manifest["frame"]).startswith("ENU") else "NED"


def nominal(model: Any, name: str, seconds: float, step_hz: float = 10.0, update_hz: float = 1.0) -> Nominal:
    """A motion by its name.  Raises BoresightError with the list of names."""
    check_rates(seconds, step_hz, update_hz)
    times = np.arange(round(2 * seconds * step_hz) + 1) / (2 * step_hz)
    master = motions.motion(name, times)
    slave = hull.carried(master, np.array(LEVER_B), np.array([1.0, 0, 0, 0]))
    inputs = motions.inputs_along(master, slave, [LATITUDE, 0.0, 0.0], LEVER_B, frame_of(model))
    return Nominal(name, times, inputs, round(step_hz / update_hz))


def named_or_recorded(model: Any, motion: str, seconds: float, step_hz: float, update_hz: float) -> Nominal:
    """A motion by its name, or of the recording at this path.  Raises BoresightError on a model that no name fits."""
    if not model.measurements and "Phi" not in model.units:
        raise BoresightError(f"{model.name} has no Phi and no covariance; name a filter")
    if model.manifest["kind"] == "total-state":
        raise BoresightError(
            f"{model.name} has a total state, and a named motion has no initial state; give --motion FILE.py:NAME, "
            "a function that returns P0, steps and x (docs/error-budget.md)"
        )
    if Path(motion).suffix:
        return recorded(model, motion, seconds, step_hz, update_hz)
    return nominal(model, motion, seconds, step_hz, update_hz)


def check_rates(seconds: float, step_hz: float, update_hz: float) -> None:
    for what, value in (("seconds", seconds), ("step-hz", step_hz), ("update-hz", update_hz)):
        if not 0 < value < np.inf:
            raise BoresightError(f"{what} is {value}; it must be above zero")
    if seconds * step_hz > MOST:
        raise BoresightError(f"{seconds:g} s at {step_hz:g} Hz is more than {MOST:,} steps; give fewer seconds")
    ratio = step_hz / update_hz
    if abs(ratio - round(ratio)) > 1e-9 or seconds * update_hz < 1:
        raise BoresightError(f"step-hz {step_hz:g} must be a multiple of update-hz {update_hz:g}, and {seconds:g} s "
                             "long enough for an update")  # fmt: skip


def recorded(model: Any, path: str | Path, seconds: float, step_hz: float = 10.0, update_hz: float = 1.0) -> Nominal:
    """The motion of a recording's master, from its first sample on; the slave is beside it, in the same axes."""
    from boresight.runtime.recording import read

    check_rates(seconds, step_hz, update_hz)
    data = read(str(path))
    master = data.master
    if master is None or master.v_n is None or master.position is None:
        raise BoresightError(f"{path}: a nominal motion needs a master with attitude, velocity and position")
    long = float(master.time[-1] - master.time[0])
    times = np.arange(round(2 * min(seconds, long) * step_hz) + 1) / (2 * step_hz)
    at = master.time[0] + times
    turns = np.unwrap(master.euler, axis=0)
    euler, v_n = (np.stack([np.interp(at, master.time, column) for column in values.T], axis=-1)
                  for values in (turns, master.v_n))  # fmt: skip

    def change(values: Array) -> Array:
        return np.gradient(values, times, axis=0, edge_order=2)

    parts = (np.cumsum(v_n, axis=0) / (2 * step_hz), v_n, change(v_n), rotation.quaternion_from_euler(euler),
             *hull.body_rates(euler, change(euler), change(change(euler))))  # fmt: skip
    pose = hull.Pose(times, *(part[:, None] for part in parts))
    slave = hull.carried(pose, np.array(LEVER_B), np.array([1.0, 0, 0, 0]))
    inputs = motions.inputs_along(pose, slave, master.position[0], LEVER_B, frame_of(model))
    return Nominal(Path(path).name, times, inputs, round(step_hz / update_hz))


# ---------------------------------------------------------------- sizes


def settings(model: Any, grade: str | None = None) -> dict[str, Any]:
    """Sizes by name, of a MEMS slave and a good master, or of a grade of sensors where the model carries its errors."""
    known = {*model.field, *model.measurements, *(name for name, _ in blocks(model, len(model.states)))}
    out = {name: value for name, value in SIZES.items() if name in known}
    if grade is not None and model.name != MODEL:
        raise BoresightError(f"a grade needs {MODEL}; {model.name} has no states for sensor errors but biases")
    if model.name == MODEL:
        out["sensors"] = sized(grade=grade)
    return out


def sizes(words: Sequence[str], model: Any, negative: bool | None = None) -> dict[str, Array]:
    """Of "NAME NUMBER[, NUMBER ...] UNIT" each the name and the numbers in SI.

    negative: whether numbers may be; None: of inputs, and not of the sigmas of states and measurements.
    """
    parts = dict(blocks(model, len(model.states)))
    units = {name: field["unit"] for name, field in model.field.items()}
    units |= {name: described["unit"] for name, described in model.measurements.items()}
    units |= {block["name"]: block["unit"] for block in model.manifest["blocks"]}
    counts = {name: field["size"] for name, field in model.field.items()}
    counts |= {name: len(described["rows"]) for name, described in model.measurements.items()}
    counts |= {name: len(places) for name, places in parts.items()}
    letters = {block["components"][0]: block["name"] for block in model.manifest["blocks"] if block["size"] == 1}
    inputs = ", ".join(name for name in model.field if name not in ("x", "dt"))
    out = {}
    for text in words:
        name, _, rest = text.strip().partition(" ")
        name = name if name in units else letters.get(name, name)
        if name not in units:
            listed = f"states {', '.join(parts)}; measurements {', '.join(model.measurements)}; inputs {inputs}"
            raise BoresightError(f"{model.name} has no input or other name {name!r}{did_you_mean(name, units)}; it has "
                                 f"{listed}")  # fmt: skip
        value = amount(rest, units[name], text)
        may = name not in parts and name not in model.measurements if negative is None else negative
        if not may and (value < 0).any():
            raise BoresightError(f"{text!r}: a sigma is not negative")
        if len(value) not in (1, counts[name]):
            raise BoresightError(f"{text!r}: give one number or {counts[name]}")
        many: Array = np.resize(value, counts[name])
        out[name] = many if counts[name] > 1 else many[0]
    return out


def amount(text: str, si: str, where: str) -> Array:
    """Numbers with a unit; in `si` without one, where it is 1, or several units."""
    units = {unit: factor for of_kind in UNITS.values() if si in of_kind for unit, factor in of_kind.items()}
    units = units or ({} if "," in si else {si: 1.0})
    numbers, _, unit = text.strip().rpartition(" ")
    if unit not in units and (si == "1" or not units):
        numbers, unit = text, si
    try:
        value = np.array([float(part) for part in numbers.split(",")]) * units.get(unit, 1.0)
    except ValueError:
        value = None
    if value is None or unit not in {*units, si}:
        known = " and one of the units" if len(units) > 1 else " and the unit" if units else ", in"
        raise BoresightError(f"{where!r}: give numbers{known} {', '.join(units) or si}")
    if not np.isfinite(value).all():
        raise BoresightError(f"{where!r}: every number must be finite")
    return value


# ---------------------------------------------------------------- start and steps


def flight(model: Any, along: Nominal, values: Mapping[str, Any]) -> tuple[dict[str, Array], list[Any]]:
    """The start by cause, and the steps, with these sizes.  Raises BoresightError on a model that measures nothing."""
    values = dict(values)
    sensors = values.pop("sensors", None)
    names = taken(model, values)
    spread = rest_of(model, values, sensors)
    if not spread:
        block = model.manifest["blocks"][0]
        raise BoresightError(f"{model.name}: no state has a sigma at the start; give those that have one, as "
                             f"--set '{block['name']} 1 {block['unit'].split(',')[0]}'")  # fmt: skip
    constant = values.pop("constants", {})
    given = {name: constant_value(model, name, {**constant, **values}) for name in model.field
             if name not in along.inputs and name not in ("x", "dt")}  # fmt: skip
    given |= {name: np.asarray(value, float) for name, value in values.items() if name in along.inputs}

    def at(k: int, fields: Sequence[str]) -> dict[str, Any]:
        return {name: given[name] if name in given else along.inputs[name][k] for name in fields if name != "x"}

    needs = {f for name in ("Phi", "Q") for f in getattr(model, name).fields} - {"dt", "x"}
    reads = {
        name: {f for part in ("H", "h", "z") for f in getattr(getattr(model, f"{name}_{part}", None), "fields", ())}
        if hasattr(model, f"{name}_H") else set() for name in names
    }  # fmt: skip
    variances = {name: np.broadcast_to(np.asarray(values[name], float) ** 2, rows_of(model, name)) for name in names}
    steps: list[Any] = []
    for k in range(1, len(along.times), 2):
        dt = float(along.times[k + 1] - along.times[k - 1])
        steps.append({**at(k, sorted(needs)), "dt": dt})
        if ((k + 1) // 2) % along.every == 0:
            steps += [(name, variances[name], at(k + 1, sorted(reads[name]))) for name in names]
    start = begun(model, names, spread, variances, lambda name: at(0, sorted(reads[name])))
    return start, steps


def taken(model: Any, values: Mapping[str, Any]) -> list[str]:
    """The measurements that are flown: those that are known here, and of a model of one's own those with a size."""
    known = [next((name for name in group if name in model.measurements), "") for group in MATCHED]
    return [*filter(None, known), *(name for name in model.measurements if name in values and name not in SIZES)]


def not_taken(model: Any, values: Mapping[str, Any]) -> list[str]:
    """The measurements of one's own model that have no size and are not flown."""
    return [name for name in model.measurements if name not in SIZES and name not in taken(model, values)]


def not_taken_line(left: Sequence[str], model: Any) -> str:
    if not left:
        return ""
    unit = model.measurements[left[0]]["unit"]
    typed = f"{left[0]} 1" if unit == "1" or "," in unit else f"{left[0]} 1 {unit}"
    return f"not flown: {', '.join(left)}; give the sigma, as --set '{typed}'\n"


def rows_of(model: Any, name: str) -> int:
    return len(model.measurements[name]["rows"])


def constant_value(model: Any, name: str, values: Mapping[str, Any]) -> Array:
    """An input that no motion gives: its size, or the value of its box that is nearest to zero."""
    described = model.field[name]
    low, high, size = np.asarray(described["low"]), np.asarray(described["high"]), described["size"]
    if name in values:
        out = np.broadcast_to(np.asarray(values[name], float), (size,)).copy()
    elif described["norm"]:
        out = np.eye(size)[0]
    else:
        out = np.clip(np.zeros(size), low, high)
    return out if size > 1 else out[0]


def rest_of(model: Any, values: dict[str, Any], sensors: Sensors | None) -> dict[str, Array]:
    """Covariance (n, n) of each block of states that has a size, by itself; of sensors' errors as their sizes say.

    values: gets the constants of the sensors' errors under "constants".
    """
    n, parts = len(model.states), dict(blocks(model, len(model.states)))
    out = {}
    if sensors is not None:
        names = {"q_b2m_wxyz": "dmu", "gyro_bias": "d_gyro_bias", "accel_bias": "d_accel_bias", "tau": "d_tau",
                 "lever_b": "d_lever"}  # fmt: skip
        walks = {name: value for name, value in values.items() if name.endswith("_bias_noise")}
        wide = carried(sensors, walks, {there: values[here] for there, here in names.items()}, {})
        values["constants"] = wide.constants
        for name in walks:
            values.pop(name)
        for name in ("gyro", "accel"):  # what lasts, in the bias and in its constant part, and what wanders
            both = [*parts[f"d_{name}_bias"], *parts[f"d_{name}_turn_on"]]
            lasting = np.zeros((n, n))
            size = np.broadcast_to(np.asarray(values[f"d_{name}_bias"], float) ** 2, 3)
            lasting[np.ix_(both, both)] = np.kron(np.ones((2, 2)), np.diag(size))
            out[f"d_{name}_bias"] = lasting
            sigma = getattr(sensors, f"{name}_instability")
            wandering = np.zeros((n, n))
            wandering[parts[f"d_{name}_bias"], parts[f"d_{name}_bias"]] = sigma**2
            out[f"{name}_instability"] = wandering
        groups = {"scale": range(25, 31), "axes": range(31, 40)}
        groups |= {name: range(ADDED[name].start, ADDED[name].stop) for name in ("flexure", "flexure_rate")}
        for name, states in groups.items():
            part = np.zeros((n, n))
            part[states.start : states.stop, states.start : states.stop] = wide.P[
                states.start : states.stop, states.start : states.stop
            ]
            out[name] = part
    for name, places in parts.items():
        if name in values and name not in out:
            part = np.zeros((n, n))
            part[places, places] = np.broadcast_to(np.asarray(values[name], float) ** 2, len(places))
            out[name] = part
    return {name: part for name, part in out.items() if part.any()}


def begun(
    model: Any, names: Sequence[str], spread: dict[str, Array], variances: Mapping[str, Array], at: Any
) -> dict[str, Array]:
    """The start by cause.  A slave beside a master takes its attitude and velocity over: what else errs turns up there.

    With H x = noise at the first message, the errors taken over are D (noise - H x of all others), D the inverse of H.
    """
    parts = dict(blocks(model, len(model.states)))
    own = [i for name in FOLLOWING for i in parts.get(name, [])]
    if "dmu" not in parts or not names:
        return spread
    n = len(model.states)
    x = np.zeros(n)
    each = {}
    for name in names:
        unit, given = getattr(model, f"{name}_H"), {**at(name), "x": x}
        each[name] = unit(**{field: given[field] for field in unit.fields})
    H = np.vstack(list(each.values()))
    if np.linalg.matrix_rank(H[:, own]) < len(own):
        return spread
    D = np.linalg.pinv(H[:, own])
    through = np.eye(n)
    through[np.ix_(own, range(n))] = -D @ H
    through[np.ix_(own, own)] = 0.0
    out = {}
    for name, P in spread.items():
        out[name] = P if name in FOLLOWING else through @ P @ through.T
    first = 0
    for name, rows in each.items():
        L = np.zeros((n, len(rows)))
        L[own] = D[:, first : first + len(rows)]
        out[f"{name} taken over"] = L * variances[name] @ L.T
        first += len(rows)
    return out
