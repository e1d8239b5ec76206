"""What a master says, and what became of it."""

from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from boresight.runtime.array import Array
from boresight.runtime.filter import Innovation


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
    REPEATED = 8  # the same numbers again although the slave has moved
    SATURATED = 9  # measured while the slave was at full scale, or just before
    MISSED = 10  # measured while samples of the slave were missing, or before, or they still are


@dataclass(frozen=True)
class Message:
    """What the master says.  R, rows: velocity's three rows, then attitude's (axes n, or roll pitch yaw for euler)."""

    time: Any  # (...,) s, slave's clock: when it was measured, or, where only that is known, when it arrived
    R: Any  # (..., 6) variances, (m/s)^2 and rad^2
    v_m_n: Any = None  # (..., 3) m/s
    q_m2n_wxyz: Any = None  # (..., 4)
    euler_m: Any = None  # (..., 3) rad, instead of the quaternion, for the measurement `euler`
    position: Any = None  # (..., 3) latitude, longitude, height
    position_sigma: Any = 10.0  # m, (..., 3) of north, east, up, or one number; a plain satellite receiver's
    rows: Any = True  # (..., 6) bool, False for what is missing; all False: nothing came to this run


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
