"""What a recording holds: NED/FRD, SI and radians."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array


@dataclass(frozen=True)
class Inertial:
    """A three-axis gyro and accelerometer, in FRD body axes.

    kind: "rates" (rad/s, m/s^2: the mean over each sample's interval) or "increments" (rad, m/s over it).
    time: (N,) s; time_marks says which instant of a sample's interval its tag is: "start", "middle" or "end".
    doubt: one sigma of what a sample that was bridged may have missed, of its angle (rad) and its velocity (m/s), each
    axis; zero where it was measured.  Over a gap they add up as if they were independent.
    """

    kind: Literal["rates", "increments"]
    time_marks: Literal["start", "middle", "end"]
    time: Array
    gyro: Array  # (N, 3)
    accel: Array  # (N, 3)
    doubt: Array | None = None  # (N, 2)

    @cached_property
    def dt(self) -> float:
        """s, the usual interval between samples: the median."""
        return float(np.median(np.diff(self.time)))

    def intervals(self) -> tuple[Array, Array]:
        """(N,), (N,) s: start and end of each sample's interval.  After a gap a sample covers the usual dt."""
        dt, before = self.dt, np.diff(self.time)
        length = np.where(np.abs(before - dt) < 0.5 * dt, before, dt)
        if self.time_marks == "start":
            return self.time, self.time + np.append(length, dt)
        if self.time_marks == "middle":
            return self.time - np.insert(length, 0, dt) / 2, self.time + np.append(length, dt) / 2
        return self.time - np.insert(length, 0, dt), self.time

    @cached_property
    def increments(self) -> tuple[Array, Array, Array, Array]:
        """start (N,), end (N,) s, dtheta (N, 3) rad, dvel (N, 3) m/s, whatever the kind."""
        start, end = self.intervals()
        scale = (end - start)[:, None] if self.kind == "rates" else 1.0
        return start, end, self.gyro * scale, self.accel * scale

    def rates(self) -> tuple[Array, Array]:
        """gyro (N, 3) rad/s, specific force (N, 3) m/s^2, whatever the kind."""
        start, end = self.intervals()
        scale = 1.0 if self.kind == "rates" else 1 / (end - start)[:, None]
        return self.gyro * scale, self.accel * scale

    def between(self, t0: float, t1: float) -> tuple[Array, Array]:
        """dt (K,) s and dtheta (K, 3) rad of the pieces of samples that cover t0 to t1; a cut sample is shared by time.

        Raises BoresightError where more than half a sample of the time between is not covered.
        """
        start, end, dtheta, _ = self.increments
        first, last = np.searchsorted(end, t0, "right"), np.searchsorted(start, t1, "left")
        piece = np.minimum(end[first:last], t1) - np.maximum(start[first:last], t0)
        missing = (t1 - t0) - piece.sum()
        if abs(missing) > 0.5 * self.dt:
            raise BoresightError(
                f"the inertial data does not cover {t0:.4f} s to {t1:.4f} s ({missing:.4f} s are missing); "
                "bridge it (bridge), or cut the recording there (from, to)"
            )
        keep = piece > 1e-6 * self.dt  # a time tag's own rounding leaves slivers
        share = piece / (end[first:last] - start[first:last])
        return piece[keep], (dtheta[first:last] * share[:, None])[keep]

    def __post_init__(self) -> None:
        for name in ("gyro", "accel"):
            shape, wanted = np.shape(getattr(self, name)), (len(self.time), 3)
            if shape != wanted:
                raise BoresightError(f"{name} has shape {shape}; with {wanted[0]} times it must be {wanted}")
        if len(self.time) < 2:
            raise BoresightError(f"the inertial data has {len(self.time)} samples; it needs at least 2")


@dataclass(frozen=True)
class Master:
    """The navigation of a master, in NED and FRD."""

    time: Array  # (M,) s, on the slave's clock
    euler: Array  # (M, 3) rad roll, pitch, yaw
    v_n: Array | None = None  # (M, 3) m/s north, east, down
    position: Array | None = None  # (M, 3) latitude rad, longitude rad, height m

    def cut(self, keep: Any) -> "Master":
        """Only the rows that KEEP selects: a slice, a mask or indices."""
        v_n, position = (None if part is None else part[keep] for part in (self.v_n, self.position))
        return Master(self.time[keep], self.euler[keep], v_n, position)


@dataclass(frozen=True)
class Recording:
    """One drive, flight or walk; made by `read`, or by hand from arrays that are NED/FRD, SI and radians already.

    reference: what is known from elsewhere, in FRD: "gyro_bias" rad/s, "accel_bias" m/s^2 (measured = true + bias),
    "misalignment" rad (mu, C_b2n = C_m2n exp([mu x])), "lever_arm" m (master to slave); each (3,).
    epoch: s, from which the times are counted where the file has dates (since 1970, of UNIX time), else 0.
    notes: what was done to the file's numbers: bridged, cut, converted, taken off.
    left_out: what of the file is not in it: rows that stand twice, messages of unknown type, each line with its count.
    axes: what took the file's columns to FRD ("imu") and to NED ("velocity"), (3, 3) each; for proposals of the check.
    noise: what the description has of the noises, by name and with their units, as "0.15 deg/sqrt(h)".
    stops: what the description has of the stops, as settings of the replay: "rest" s, "window" samples, "sway_factor",
    "latitude_deg".
    failed: how many rows of a section ("imu", "master") are zeros that a failed read left, and the first of them.
    temperature: (N, 2) s and degC (or K) of the slave, where the file has it.
    allow: names of findings that are no errors here.
    """

    name: str
    imu: Inertial
    master: Master | None = None
    reference: Mapping[str, Array] = field(default_factory=dict)
    title: str = ""
    epoch: int = 0
    notes: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()
    axes: Mapping[str, Array] = field(default_factory=dict)
    allow: tuple[str, ...] = ()
    noise: Mapping[str, str] = field(default_factory=dict)
    stops: Mapping[str, Any] = field(default_factory=dict)
    failed: Mapping[str, tuple[int, int]] = field(default_factory=dict)
    temperature: Array | None = None


@dataclass(frozen=True)
class Finding:
    """One thing that `check` saw.  An "error" stops a replay; a "warning" may be meant so; a "note" is a number.

    name: of an error, by which it can be allowed; empty where nothing can be computed with the error in it.
    """

    level: Literal["note", "warning", "error"]
    where: str
    text: str
    name: str = ""


def shifted(recording: Recording, delay: float) -> Recording:
    """The recording with its master's data taken as DELAY seconds old: each tag moved back by it."""
    if recording.master is None or delay == 0:
        return recording
    return replace(recording, master=replace(recording.master, time=recording.master.time - delay))


def thinned(master: Master, rate_hz: float | None) -> Master:
    """Every n-th sample of the master, so that it comes at rate_hz or just above."""
    if rate_hz is None:
        return master
    if not rate_hz > 0:
        raise BoresightError(f"the master's rate is {rate_hz} Hz; it must be above zero")
    usual = float(np.median(np.diff(master.time)))
    return master.cut(slice(None, None, max(1, int(1 / (rate_hz * usual) + 1e-9))))
