"""Sensors that are not as the plain model says, and a hull that bends: from their sizes to what a filter carries.

`velocity-attitude-sensors` has states for all of it; what has no size has no variance either, and stays out of account.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, NamedTuple

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.units import DEG_H, STANDARD_GRAVITY, quantity

MODEL = "velocity-attitude-sensors"
N = 46
# Where in its state each part stands, and in nav the estimate of the same name.
MOUNTING = slice(12, 15)
BIASES = {"gyro": (slice(6, 9), slice(40, 43)), "accel": (slice(9, 12), slice(43, 46))}
ADDED = {
    "lever_b": slice(16, 19), "flexure": slice(19, 22), "flexure_rate": slice(22, 25), "gyro_scale": slice(25, 28),
    "accel_scale": slice(28, 31), "gyro_axes": slice(31, 37), "accel_axes": slice(37, 40),
    "gyro_turn_on": slice(40, 43), "accel_turn_on": slice(43, 46),
}  # fmt: skip
PROBE = 1e-9  # of scale factors and axes that are probed: no innovation knows it
CALIBRATION = slice(25, 40)  # scale factors and axes
MICRO_G = STANDARD_GRAVITY / 1e6


@dataclass(frozen=True)
class Sensors:
    """How far sensors and hull are from the plain model, one sigma each, SI and rad; what is zero is left out.

    scale: 1, of each gyro and accelerometer.  axes: rad, by which each sensitive axis leaves its place in the case
    towards either of the others.  instability: what a bias wanders by about its constant part, with its correlation
    time.  bending: rad about each of the master's axes, with its natural frequency and damping (1 the critical one).
    lever: m.  estimated: scale factors and axes are estimated; else they are considered, with no gain.
    probed: they have no size but one that changes nothing, for the score test.
    """

    gyro_scale: float = 0.0
    accel_scale: float = 0.0
    gyro_axes: float = 0.0
    accel_axes: float = 0.0
    gyro_instability: float = 0.0  # rad/s
    accel_instability: float = 0.0  # m/s^2
    correlation_s: float = 300.0
    bending: float = 0.0
    bending_hz: float = 0.1
    bending_damping: float = 0.3
    lever: float = 0.0
    estimated: bool = False
    probed: bool = False

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            above = field.name in ("correlation_s", "bending_hz", "bending_damping")
            if not np.isfinite(value) or value < 0 or (above and value == 0):
                asked = "above zero" if above else "zero or more"
                raise BoresightError(f"sensors: {field.name} is {value!r}; it must be a finite number, {asked}")
        for name in ("gyro_scale", "accel_scale", "gyro_axes", "accel_axes"):
            if getattr(self, name) > 0.02:
                raise BoresightError(f"sensors: {name} is {getattr(self, name):g}; the model's range is 0.02 at most")


# Of a class of units: what is said to be printed stands so in a datasheet, the rest is typical by our choice; a unit's
# own numbers are better.  A datasheet's bias instability is the floor of the Allan deviation.
GRADES = {
    # Printed: 10 deg/h, 30 ug, nonlinearity of 0.1 and 0.5 % (Xsens MTi-1); axes within 0.1 deg (Analog Devices
    # ADIS16475, Rev. D).  By our choice: scale factors, axes and accelerometers somewhat worse than these.
    "mems": Sensors(3e-3, 3e-3, 3e-3, 3e-3, 10 * DEG_H, 50 * MICRO_G),
    # By our choice, all of it: between its neighbours.
    "industrial": Sensors(1e-3, 1e-3, 1e-3, 1e-3, 5 * DEG_H, 70 * MICRO_G),
    # Printed, all but the correlation time: Sensonor STIM300 (TS1524) with accelerometers of 10 g.
    "tactical": Sensors(5e-4, 3e-4, 1e-3, 1e-3, 0.5 * DEG_H, 50 * MICRO_G),
    # Printed: below 0.01 deg/h and 100 ug for 1 nmi/h (El-Sheimy and Youssef 2020, Satellite Navigation 1:2, table 1).
    # By our choice: the numbers within, scale factors, axes (5 arcsec) and correlation time, of ring laser gyros.
    "navigation": Sensors(5e-6, 1e-4, 2.5e-5, 2.5e-5, 0.003 * DEG_H, 10 * MICRO_G, 3600.0),
}


def sized(
    words: Sequence[str] = (),
    grade: str | None = None,
    gyro_instability: str | None = None,
    accel_instability: str | None = None,
    correlation: str | None = None,
    *,
    estimated: bool = False,
) -> Sensors:
    """Sizes in words: of a grade, with what else is said in their place.

    words: such as "scale 1000 ppm", "axes 1 mrad" or "bending 2 mrad 0.1 Hz"; the others as "3 deg/h", "50 ug" and
    "300 s".  Raises BoresightError for what it cannot read, and for what has nothing to stand on.
    """
    if grade is not None and grade not in GRADES:
        raise BoresightError(f"no grade {grade!r}; there are {', '.join(GRADES)}")
    sizes: dict[str, Any] = {}
    for text in words:
        name, _, size = text.strip().partition(" ")
        if name in ("scale", "axes"):
            value = float(quantity(size, "scale factor" if name == "scale" else "angle")[0])
            sizes |= {f"gyro_{name}": value, f"accel_{name}": value}
        elif name == "bending" and len(size.split()) == 4:
            amount, hertz = " ".join(size.split()[:2]), " ".join(size.split()[2:])
            sizes |= {"bending": float(quantity(amount, "angle")[0]),
                      "bending_hz": float(quantity(hertz, "frequency")[0])}  # fmt: skip
        else:
            raise BoresightError(
                f"{text!r}: give scale, axes or bending with a size, as 'scale 1000 ppm', 'axes 1 mrad' or "
                "'bending 2 mrad 0.1 Hz'"
            )
    for field, said, kind in (
        ("gyro_instability", gyro_instability, "angular rate"),
        ("accel_instability", accel_instability, "acceleration"),
        ("correlation_s", correlation, "time"),
    ):
        if said is not None:
            sizes[field] = float(quantity(said, kind)[0])
    out = replace(GRADES[grade] if grade else Sensors(), estimated=estimated, **sizes)
    if estimated and not calibration(out).any():
        raise BoresightError("scale factors and axes are to be estimated, and have no size: give one, or a grade")
    if correlation and not (out.gyro_instability or out.accel_instability):
        raise BoresightError("a correlation time is of an instability: give one, or a grade")
    return out


class Carried(NamedTuple):
    """What `first` and `Live.begin` take of MODEL."""

    constants: dict[str, Any]
    P: Array  # (..., 46, 46), of which `first` makes attitude and velocity
    estimates: dict[str, Any]
    considered: Array  # (46,) bool, for the filter


def carried(
    sensors: Sensors, constants: Mapping[str, Any], sigmas: Mapping[str, Any], estimates: Mapping[str, Any]
) -> Carried:
    """Constants, sigmas and estimates of the plain model, as `first` takes them, widened to MODEL.

    The lever arm becomes an estimate.  What the constants say of the biases' random walk stays, beside the instability.
    Use it as::

        wide = carried(GRADES["tactical"], constants, sigmas, estimates)
        nav, P = first(message, load(MODEL), wide.constants, P=wide.P, estimates=wide.estimates, increments=...)
        loop = Live(MODEL, **wide.constants)
        loop.begin(at_us, nav, P=P, considered=wide.considered)
    """
    constants, estimates, three = dict(constants), dict(estimates), np.ones(3)
    if "lever_b" in constants:
        estimates["lever_b"] = constants.pop("lever_b")
    places = {name: BIASES[name[:-5]][0] for name in ("gyro_bias", "accel_bias")}
    places |= {"q_b2m_wxyz": MOUNTING, "tau": slice(15, 16), "lever_b": ADDED["lever_b"]}
    known = {"lever_b": sensors.lever, **sigmas}
    if unknown := set(known) - set(places):
        raise BoresightError(f"sensors: there is no sigma of {sorted(unknown)[0]!r}; there are {', '.join(places)}")
    columns = {name: np.asarray(value, float)[..., None] if name == "tau" else np.asarray(value, float)
               for name, value in known.items()}  # fmt: skip
    runs = np.broadcast_shapes(*(value.shape[:-1] for value in columns.values()))
    P = np.zeros((*runs, N, N))
    for name, value in columns.items():
        part = places[name]
        P[..., part, part] = value[..., None] ** 2 * np.eye(part.stop - part.start)

    beta = 1 / sensors.correlation_s
    for name, (bias, constant) in BIASES.items():
        sigma = getattr(sensors, f"{name}_instability")
        estimates[f"{name}_turn_on"] = estimates.get(f"{name}_bias", np.zeros(3))
        if sigma > 0:  # what was given is the constant part, which lasts
            P[..., constant, constant] = P[..., bias, constant] = P[..., constant, bias] = P[..., bias, bias]
            P[..., bias, bias] += sigma**2 * np.eye(3)
        constants[f"{name}_bias_beta"] = three * (beta if sigma > 0 else 0.0)
        walk = np.asarray(constants.get(f"{name}_bias_noise", 0.0), float)
        constants[f"{name}_bias_noise"] = np.sqrt(np.square(walk) + 2 * beta * sigma**2) * three

    P[..., CALIBRATION, CALIBRATION] = PROBE**2 * np.eye(15) if sensors.probed else calibration(sensors)
    omega, damping = 2 * np.pi * sensors.bending_hz, sensors.bending_damping
    for name, sigma in (("flexure", sensors.bending), ("flexure_rate", sensors.bending * omega)):
        P[..., ADDED[name], ADDED[name]] = sigma**2 * np.eye(3)
    constants |= {"flexure_omega": three * omega, "flexure_damping": three * damping,
                  "flexure_noise": three * 2 * sensors.bending * np.sqrt(damping * omega**3)}  # fmt: skip
    considered = np.zeros(N, bool)
    considered[CALIBRATION] = not sensors.estimated
    return Carried(constants, P, estimates, considered)


def calibration(sensors: Sensors) -> Array:
    """(15, 15) covariance of scale factors, the gyros' six axes and the accelerometers' three.

    Each of twelve axes leaves its place in the case by itself.  The body's axes are those of the accelerometers, from
    which the upper three of theirs are gone: they turn the body against the case, and the gyros' axes with it.
    """
    out = np.zeros((15, 15))
    out[:6, :6] = np.diag(np.repeat([sensors.gyro_scale, sensors.accel_scale], 3) ** 2)
    pairs = [(i, j) for i in range(3) for j in range(3) if i != j]
    lower = [(1, 0), (2, 0), (2, 1)]
    shares = np.zeros((9, 12))  # of the accelerometers' six, then of the gyros' six
    for k, (i, j) in enumerate(pairs):
        shares[k, 6 + k] = 1.0
        shares[k, pairs.index((min(i, j), max(i, j)))] = -1.0 if i < j else 1.0
    for k, (i, j) in enumerate(lower):
        shares[6 + k, [pairs.index((i, j)), pairs.index((j, i))]] = 1.0
    out[6:, 6:] = shares @ np.diag(np.repeat([sensors.accel_axes, sensors.gyro_axes], 6) ** 2) @ shares.T
    return out
