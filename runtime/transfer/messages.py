"""What a master says, how it is read, and what became of it."""

from dataclasses import dataclass
from enum import IntEnum
from typing import Any

import numpy as np

from boresight.runtime.array import Array, wrapped
from boresight.runtime.filter import Innovation

HUGE = 1e12  # a variance, a time, a distance beyond it is no number


class Verdict(IntEnum):
    """What became of a message; from GATED on it was refused."""

    BEGUN = -1  # taken: the filter began anew from it
    TAKEN = 0
    REOPENED = 1  # taken after several refused in a row, with velocity and attitude opened
    ABSENT = 2  # nothing came: every row is masked
    GATED = 3  # NIS beyond the gate
    INVALID = 4  # nothing usable in it: not finite, or no velocity and no attitude at all
    OUT_OF_ORDER = 5  # not newer than the last one
    AHEAD = 6  # measured later than the slave's newest sample
    TOO_OLD = 7  # measured before the oldest sample kept
    REPEATED = 8  # the same numbers again although the slave has moved, or the same count
    SATURATED = 9  # measured while the slave was at full scale, or just before
    BEYOND = 10  # the slave, or the slave as the message would correct it, is beyond the model's range
    MISSED = 11  # measured while samples of the slave were missing, or before, or they still are


@dataclass(frozen=True)
class Message:
    """What a master reports at one time, for `Transfer.master`.

    Leading axes are runs; a field without them is that of all runs.  NED, SI and rad.

    Parameters
    ----------
    time : (...,) array
        s, by the slave's clock: when it was measured, or, where only that is known, when it
        arrived.
    R : (..., 6) array
        Variances of the velocity's three rows, (m/s)^2, then of the attitude's, rad^2: about north,
        east, down, or of roll, pitch, yaw with `euler_m`.
    v_m_n : (..., 3) array, optional
        Velocity of the master, m/s.
    q_m2n_wxyz : (..., 4) array, optional
        Attitude of the master, scalar first, master body to NED.
    euler_m : (..., 3) array, optional
        Roll, pitch, yaw of the master, rad, instead of the quaternion, for the measurement `euler`.
    position : (..., 3) array, optional
        Latitude and longitude, rad, and height, m.
    position_sigma : (..., 3) or (..., 1) array, or a number, optional
        m, of north, east, up, or of all three; so three numbers are one run's three axes, also
        where there are three runs.  10 is a plain satellite receiver's.
    rows : (..., 6) bool array, optional
        False for what is missing, in the order of R; all False: nothing came to this run.
    count : (...,) array, optional
        The master's own counter, if it has one: a message with the last one's is its copy.

    Notes
    -----
    A Message checks nothing; `Transfer.master` does, and gives a verdict in the place of an error.
    When not to use it: for other measurements than a master's velocity and attitude, as a GNSS
    position; write a model with `Measurement` and fly it by `CompiledFilter`.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Message
    >>> R = np.repeat([0.02, 1e-4], 3) ** 2
    >>> message = Message(12.3, R, v_m_n=[10.0, 0, 0], q_m2n_wxyz=[1, 0, 0, 0])
    >>> message.time, message.count is None
    (12.3, True)
    """

    time: Any
    R: Any
    v_m_n: Any = None
    q_m2n_wxyz: Any = None
    euler_m: Any = None
    position: Any = None
    position_sigma: Any = 10.0
    rows: Any = True
    count: Any = None


@dataclass(frozen=True)
class Result:
    """What one message did, run by run."""

    verdict: Array  # (...,) of Verdict
    innovations: dict[str, Innovation]  # by measurement; `used` is False where the message was refused
    nis: Array  # (...,) of the rows used together, nan where there is none: what was refused is in no mean
    rows: Array  # (...,) how many rows that is
    before_gate: Array  # (...,) NIS of all rows held against the slave, refused in the end or not
    lag: Array  # (...,) s, how old the message was believed to be

    @property
    def taken(self) -> Array:
        """(...,) bool."""
        return self.verdict <= Verdict.REOPENED


@dataclass(frozen=True)
class Note:
    """One line for the user."""

    time: float
    runs: Array  # (K,) flat numbers of the runs it is about
    text: str

    def __str__(self) -> str:
        return f"{self.time:.3f} s: {self.text}"


@dataclass(frozen=True)
class Heard:
    """A message as arrays of all runs, and what in it cannot be used."""

    time: Array  # (...,) s, nan where it is no number
    R: Array  # (..., 6), above zero: 1 where it cannot be used
    said: dict[str, Array]  # velocity and attitude, as far as they are there
    rows: Array  # (..., 6) bool: given, finite, within the model's range, and of a message that is not refused
    came: Array  # (...,) bool
    masked: Array  # (..., 6) bool: not given, in a message that came
    spoilt: Array  # (..., 6) bool: given, but not finite or beyond the model's range
    position: Array | None  # (..., 3), nan where it cannot be used
    position_sigma: Array  # (..., 3) m
    count: Array  # (...,), nan where there is none
    faults: list[tuple[Array, str]]  # (...,) bool, the runs whose message is refused, and why
    numbers: dict[str, Array]  # (...,) by name, what in the lines of `faults` stands in braces


def heard(message: Message, runs: tuple[int, ...], attitude: str, steepest: float) -> Heard:
    """A message read so that nothing it holds raises.

    attitude: the field that holds it.  steepest: rad, the pitch up to which Euler angles are used.
    """
    everywhere = np.ones(runs, bool)
    faults: list[tuple[Array, str]] = []

    def array(name: str, *size: int) -> Array:
        """(..., *size) as given; nan and a fault where that is impossible."""
        try:
            return np.broadcast_to(np.asarray(getattr(message, name), float), (*runs, *size))
        except (TypeError, ValueError):
            shape = "(" + ", ".join(("...", *map(str, size))) + ("" if size else ",") + ")"
            shape += " or (..., 1)" if name == "position_sigma" else ""
            faults.append((everywhere, f"its {name} is no array of numbers {shape}"))
            return np.full((*runs, *size), np.nan)

    time, R, mask = array("time"), array("R", 6), array("rows", 6)
    given = np.where(np.isnan(mask), 1.0, mask) != 0
    came = given.any(-1)
    fine = np.zeros((*runs, 6), bool)
    said = {}
    for name, part in (("v_m_n", slice(0, 3)), (attitude, slice(3, 6))):
        if getattr(message, name) is None:
            given = given.copy()
            given[..., part] = False
            continue
        value = array(name, 4 if name == "q_m2n_wxyz" else 3)
        if name == "q_m2n_wxyz":
            norm = np.linalg.norm(np.clip(np.where(np.isfinite(value), value, 2.0), -2.0, 2.0), axis=-1)
            fine[..., part] = (np.abs(norm - 1) < 1e-3)[..., None]
        elif name == "euler_m":
            value = np.where(np.abs(value) < 1e6, value, np.nan)
            value = np.stack([wrapped(value[..., 0]), value[..., 1], wrapped(value[..., 2])], axis=-1)
            # roll and yaw of a hull that points up are no two angles
            fine[..., part] = np.isfinite(value) & (np.abs(value[..., 1:2]) <= steepest)
        else:
            fine[..., part] = np.abs(value) < 1000.0
        said[name] = value
    if not said:
        faults.append((everywhere, f"it holds neither v_m_n nor {attitude}"))
    sound = (R > 0) & (R < HUGE)
    bad = ~sound & given & fine
    unsound = np.take_along_axis(R, np.argmax(bad, axis=-1)[..., None], axis=-1)[..., 0]
    faults.append((bad.any(-1), "a variance in R is {R:.3g}; each must be finite and above zero"))
    untimed = came & ~(np.abs(time) < HUGE)
    faults.append((untimed, "its time is {time}"))
    empty = came & ~(given & fine).any(-1)
    faults.append((empty, "it holds no finite value within the model's range"))
    refused = np.any([where for where, _ in faults], axis=0)
    position, position_sigma = None, array("position_sigma", 3)
    if message.position is not None:
        position = array("position", 3)
        usable = (position_sigma > 0) & (position_sigma < HUGE) & (np.abs(position) < HUGE)
        position = np.where(usable.all(-1, keepdims=True), position, np.nan)
        position_sigma = np.where(usable, position_sigma, 1.0)
    count = np.full(runs, np.nan) if message.count is None else array("count")
    whole, faults = came & ~refused, [(where & came, why) for where, why in faults]
    numbers = {"R": unsound, "time": time, "count": count}
    time = np.where(untimed, np.nan, time)
    return Heard(
        time, np.where(sound, R, 1.0), said, given & fine & whole[..., None], came, whole[..., None] & ~given,
        whole[..., None] & given & ~fine, position, position_sigma, count, faults, numbers,
    )  # fmt: skip
