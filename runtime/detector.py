"""Is the sensor at rest?  Five windowed detectors in the generated C, and thresholds from a rate of false alarms.

A detector sees the inertial sensor alone and says rest while its statistic is below its threshold.  False alarm is
always *movement declared while resting*, of one window: the only error whose rate follows from the noise.  The
reverse, rest declared while moving, needs a motion to be stated: `rest_declared`.  No threshold depends on what a
filter believes.
"""

import ctypes
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.compiler import open_library
from boresight.runtime.library import build
from boresight.runtime.manifest import folder_of, read_manifest
from boresight.runtime.status import Status
from boresight.runtime.units import STANDARD_GRAVITY

DETECTORS = ("gyro_mean", "gyro_std", "accel_mean", "accel_std", "likelihood_ratio")
MAX_WINDOW = 256  # room in the C state, in samples


@dataclass(frozen=True)
class Settings:
    """window: samples.  sigma_accel m/s^2, sigma_gyro rad/s: white noise of one sample of one axis.

    threshold: by name of the detector, in the unit of its statistic; one that is left out never says rest.
    gravity: m/s^2, the norm of what the accelerometer shows at rest.
    """

    window: int
    sigma_accel: float
    sigma_gyro: float
    threshold: Mapping[str, float]
    gravity: float = STANDARD_GRAVITY

    def __post_init__(self) -> None:
        check_noise(self.window, self.sigma_accel, self.sigma_gyro)
        one_of_them(*self.threshold)
        for what, value in (("gravity", self.gravity), *self.threshold.items()):
            if not (np.isfinite(value) and value >= 0) or (what == "gravity" and not 0.1 <= value <= 100):
                raise BoresightError(f"{what} is {value}; give a finite positive number")


def settings(
    window: int,
    sigma_accel: float,
    sigma_gyro: float,
    false_alarm_rate: float,
    *,
    gravity: float = STANDARD_GRAVITY,
    rest_rate: float = 0.0,
    gravity_error: float = 0.0,
) -> Settings:
    """Settings with `threshold` for every detector, each with this rate of false alarms."""
    thresholds = {
        name: threshold(
            name, window, sigma_accel, sigma_gyro, false_alarm_rate, rest_rate=rest_rate, gravity_error=gravity_error
        )
        for name in DETECTORS
    }
    return Settings(window, sigma_accel, sigma_gyro, thresholds, gravity)


# ---------------------------------------------------------------- thresholds


def check_noise(window: int, sigma_accel: float, sigma_gyro: float) -> None:
    if not isinstance(window, int | np.integer) or not 2 <= window <= MAX_WINDOW:
        raise BoresightError(f"a window of {window} samples; give a whole number from 2 to {MAX_WINDOW}")
    for what, value, least, unit in (
        ("sigma_accel", sigma_accel, 1e-9, "m/s^2"),
        ("sigma_gyro", sigma_gyro, 1e-12, "rad/s"),
    ):
        if not least <= value <= 1e3:  # also refuses NaN
            raise BoresightError(f"{what} is {value} {unit}; a noise must be positive, {least:g} to 1000 {unit}")


def one_of_them(*names: str) -> None:
    for name in names:
        if name not in DETECTORS:
            raise BoresightError(f"no detector {name!r}; there are {', '.join(DETECTORS)}")


def threshold(
    detector: str,
    window: int,
    sigma_accel: float,
    sigma_gyro: float,
    false_alarm_rate: float,
    *,
    rest_rate: float = 0.0,
    gravity_error: float = 0.0,
) -> float:
    """The value that the statistic of a window at rest exceeds with the probability false_alarm_rate, in (0, 1).

    False alarm: movement declared while resting.  For noise that is white, Gaussian, and alike on all axes; from the
    law of the statistic, see `law`.  rest_rate (rad/s): norm of what the gyro shows at rest, its bias and the Earth's
    rate; gravity_error (m/s^2): of the gravity in the settings, with the accelerometer's bias along it.  Rates smaller
    than these only lower the rate of false alarms.  Raises BoresightError on what has no threshold.
    """
    from scipy.stats import chi2, ncx2

    if not 0 < false_alarm_rate < 1:
        raise BoresightError(f"a false-alarm rate of {false_alarm_rate}; it lies between 0 and 1, both excluded")
    for what, value in (("rest_rate", rest_rate), ("gravity_error", gravity_error)):
        if not 0 <= value < np.inf:
            raise BoresightError(f"{what} is {value}; give a finite number, not negative")
    scale, power, freedom, offset = law(detector, window, sigma_accel, sigma_gyro, rest_rate, gravity_error)
    square = ncx2.isf(false_alarm_rate, freedom, offset) if offset > 0 else chi2.isf(false_alarm_rate, freedom)
    if not np.isfinite(square):
        raise BoresightError(f"{detector} has no threshold for a false-alarm rate of {false_alarm_rate:g}")
    return float((scale * square) ** (1 / power))


def rest_declared(
    detector: str,
    threshold: float,
    window: int,
    sigma_accel: float,
    sigma_gyro: float,
    *,
    rate: float = 0.0,
    force: float = 0.0,
    swing_rate: float = 0.0,
    swing_force: float = 0.0,
) -> float:
    """The probability that a window of this motion is declared rest: the error that harms a zero-velocity update.

    rate (rad/s): norm of a steady rate.  force (m/s^2): how far a steady specific force changes the norm of gravity.
    swing_rate, swing_force: root mean square over the window, all axes together, of what varies about its mean.
    """
    from scipy.stats import chi2, ncx2

    scale, power, freedom, offset = law(detector, window, sigma_accel, sigma_gyro, rate, force, swing_rate, swing_force)
    square = threshold**power / scale
    return float(ncx2.cdf(square, freedom, offset) if offset > 0 else chi2.cdf(square, freedom))


def law(
    detector: str,
    window: int,
    sigma_accel: float,
    sigma_gyro: float,
    rate: float = 0.0,
    force: float = 0.0,
    swing_rate: float = 0.0,
    swing_force: float = 0.0,
) -> tuple[float, int, int, float]:
    """scale, power, degrees of freedom, non-centrality: statistic^power = scale * chi-square.

    With N samples of three axes: N |mean|^2 / sigma^2 has 3 degrees, the sum of squares about the mean 3 (N - 1), and
    the norm of the mean specific force, whose direction is free, 1.  The likelihood ratio is the sum of all with only
    the direction of gravity, two angles, fitted: 6 N - 2.  The norm is taken to first order in the noise, sigma / (g
    sqrt(N)) of it is neglected.
    """
    one_of_them(detector)
    check_noise(window, sigma_accel, sigma_gyro)
    N = window
    gyro, accel = sigma_gyro**2 / N, sigma_accel**2 / N
    degrees = {"gyro_mean": 3, "gyro_std": 3 * (N - 1), "accel_mean": 1, "accel_std": 3 * (N - 1)}
    return {
        "gyro_mean": (gyro, 2, 3, rate**2 / gyro),
        "gyro_std": (gyro, 2, degrees["gyro_std"], swing_rate**2 / gyro),
        "accel_mean": (accel, 2, 1, force**2 / accel),
        "accel_std": (accel, 2, degrees["accel_std"], swing_force**2 / accel),
        "likelihood_ratio": (
            1 / N,
            1,
            sum(degrees.values()),
            (rate**2 + swing_rate**2) / gyro + (force**2 + swing_force**2) / accel,
        ),
    }[detector]


# ---------------------------------------------------------------- the C


class CSettings(ctypes.Structure):
    _fields_ = (
        ("window", ctypes.c_int),
        ("gravity", ctypes.c_double),
        ("sigma_accel", ctypes.c_double),
        ("sigma_gyro", ctypes.c_double),
        ("threshold", ctypes.c_double * len(DETECTORS)),
    )


class CDecision(ctypes.Structure):
    _fields_ = (("statistic", ctypes.c_double * len(DETECTORS)), ("rest", ctypes.c_uint))


def library() -> ctypes.PyDLL:
    """The compiled detectors; raises BoresightError as `boresight.runtime.library.load`."""
    folder = folder_of("stationary-detector")
    manifest = read_manifest(folder)
    described = manifest["component"]
    if [d["name"] for d in described["detectors"]] != list(DETECTORS) or described["max_window"] != MAX_WINDOW:
        raise BoresightError(f"{folder} holds other detectors than this version of Boresight binds; generate it again")
    dll = open_library(*build(folder, manifest))
    dll.sd_sizeof_detector.restype = ctypes.c_size_t
    return dll


def c_settings(settings: Settings) -> CSettings:
    thresholds = (ctypes.c_double * len(DETECTORS))(*(settings.threshold.get(name, 0.0) for name in DETECTORS))
    return CSettings(settings.window, settings.gravity, settings.sigma_accel, settings.sigma_gyro, thresholds)


@dataclass(frozen=True)
class Decisions:
    """What each detector said at the end of each window, over whole recordings.

    statistic: (..., K, 5), NaN where there is no full window.  rest: (..., K, 5) bool, False there.  status: (..., K)
    of `Status`: OK, NOT_READY before a window is full, NOT_FINITE or OUT_OF_RANGE for a sample that was refused, and
    then the window begins anew.  Columns are DETECTORS, or by name: `decisions.rest_by("gyro_mean", "accel_std")`.
    """

    statistic: Array
    rest: Array
    status: Array

    def rest_by(self, *detectors: str) -> Array:
        """(..., K) bool: where all of these detectors say rest."""
        one_of_them(*detectors)
        return np.all([self.rest[..., DETECTORS.index(name)] for name in detectors], axis=0)

    def statistic_of(self, detector: str) -> Array:
        one_of_them(detector)
        return self.statistic[..., DETECTORS.index(detector)]


def evaluate(
    settings: Settings, gyro: Any, accel: Any, restart: Any = None, every: int = 1, dll: ctypes.PyDLL | None = None
) -> Decisions:
    """Run the detectors over recordings: the same C, sample by sample, as in flight.

    gyro (..., K, 3) rad/s, accel (..., K, 3) m/s^2; leading axes are runs.  restart: (K,) bool, where the window begins
    anew, as after a gap (`gaps`).  every: decide at every so many samples only, the last of each group.  A decision
    stands at the last sample of its window: nothing looks ahead.
    Raises BoresightError on shapes that do not fit, and on a window that is longer than the data.
    """
    gyro, accel = (np.ascontiguousarray(part, dtype=float) for part in (gyro, accel))
    if gyro.shape != accel.shape or gyro.ndim < 2 or gyro.shape[-1] != 3:
        raise BoresightError(f"gyro has shape {gyro.shape} and accel {accel.shape}; both must be (samples, 3)")
    *runs, samples, _ = gyro.shape
    if settings.window > samples:
        raise BoresightError(
            f"the window of {settings.window} samples is longer than the data ({samples} samples); take a shorter one"
        )
    if not 1 <= every <= samples:
        raise BoresightError(f"every is {every}; decide at least once in {samples} samples, give 1 to {samples}")
    begins = None
    if restart is not None:
        begins = np.ascontiguousarray(restart, dtype=np.uint8)
        if begins.shape != (samples,):
            raise BoresightError(f"restart has shape {begins.shape}; with {samples} samples it must be ({samples},)")
    shape = (*runs, samples // every)
    statistic = np.empty((*shape, len(DETECTORS)))
    bits, status = np.empty(shape, dtype=np.uint8), np.empty(shape, dtype=np.uint8)

    def pointer(array: Array | None) -> Any:
        return ctypes.c_void_p(None if array is None else array.ctypes.data)

    refused = (dll or library()).sd_batch(
        ctypes.c_size_t(int(np.prod(runs, dtype=int))), ctypes.c_size_t(samples), ctypes.byref(c_settings(settings)),
        pointer(gyro), pointer(accel), pointer(begins), ctypes.c_size_t(every),
        pointer(statistic), pointer(bits), pointer(status),
    )  # fmt: skip
    if refused:
        raise BoresightError(f"the detectors refuse these settings (BS_{Status(refused).name}): {settings}")
    return Decisions(statistic, (bits[..., None] >> np.arange(len(DETECTORS)) & 1).astype(bool), status)


def gaps(time: Any) -> Array:
    """(K,) bool: samples that do not follow the one before by the usual interval, within half of it; a tag that repeats
    or goes back is one.  No window reaches across."""
    step = np.diff(np.asarray(time, dtype=float))
    usual = np.median(step)
    return np.insert(~(np.abs(step - usual) < 0.5 * usual), 0, False)


class Detector:
    """The detectors in a loop of one's own: write a sample, `push`, read `statistic` and `rest`.

    push(gyro, accel) returns the number of a `Status`: OK, NOT_READY (taken; too few samples so far), or NOT_FINITE,
    OUT_OF_RANGE (refused; nothing changed: call `restart` unless a window may leave out a sample).  With any but OK,
    statistic and rest are those of the last decision.
    """

    def __init__(self, settings: Settings):
        dll = library()
        self._state = ctypes.create_string_buffer(dll.sd_sizeof_detector())
        self._decision = CDecision()
        self._gyro, self._accel = np.zeros(3), np.zeros(3)
        if dll.sd_init(self._state, ctypes.byref(c_settings(settings))) != Status.OK:
            raise BoresightError(f"the detectors refuse these settings: {settings}")
        pointers = (ctypes.c_void_p * 4)(
            ctypes.addressof(self._state), self._gyro.ctypes.data, self._accel.ctypes.data,
            ctypes.addressof(self._decision),
        )  # fmt: skip
        self._pointers = pointers
        self._push = partial(dll.sd_push_bound, ctypes.byref(pointers))
        self._restart = partial(dll.sd_restart, self._state)
        self.statistic = np.ctypeslib.as_array(self._decision.statistic)

    def push(self, gyro: Any, accel: Any) -> int:
        self._gyro[:], self._accel[:] = gyro, accel
        return int(self._push())

    def restart(self) -> None:
        self._restart()

    @property
    def rest(self) -> dict[str, bool]:
        bits = self._decision.rest
        return {name: bool(bits >> i & 1) for i, name in enumerate(DETECTORS)}
