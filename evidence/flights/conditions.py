"""Each condition that the transfer alignment was tried in: what the units do, and what is then asked of the filter."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from boresight.evidence.flights.fly import Unit
from boresight.evidence.flights.motion import DEG, Motion, after, matrix, parked, quaternion, swinging, turn, waves
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.transfer import Headings, Message
from boresight.runtime.transfer.sensors import Sensors
from boresight.runtime.units import DEG_H, STANDARD_GRAVITY

Change = Callable[[float, Message], Message | None]
Sensed = Callable[[float, Array, Array], tuple[Array, Array] | None]
MOUNTING = matrix(np.array([0.4, -0.3, 2.0]) * DEG)  # of `fly`
MEMS = Unit(gyro_bias=0.2 * DEG, accel_bias=0.2, gyro_noise=1e-4, accel_noise=2e-3)
FINE = replace(MEMS, velocity=0.01 / 12**0.5, attitude=0.01 * DEG / 12**0.5)  # a master as fine as one printed so


@dataclass(frozen=True)
class Condition:
    """A flight, and what is asked of it.

    asked: "consistent": the NEES of all states is in its band over the second half and at the end; "told": what is
    wrong stands in the notes, and the NEES need not be in its band while it lasts; "heals": it is in its band at the
    end; "delay": the NEES of the delay alone is, over the second half and at the end; "taken": no message is refused;
    "shown": nothing, the results stand beside the others; "refused": the flight is refused by name.
    """

    name: str
    motion: Callable[[], Motion]
    asked: str = "consistent"
    told: str = ""  # a part of a note that must be there
    settings: dict[str, Any] = field(default_factory=dict)  # of `fly`


def moving(seconds: float = 42.0, **more: Any) -> Callable[[], Motion]:
    return lambda: swinging(seconds=seconds, **more)


def rolling() -> Motion:
    """Roll of 6 deg/s."""
    return Motion(
        swing=waves(([6 * DEG / (2 * np.pi * 0.17), 0, 0], 0.17, [0, 0, 0])), steady=np.array([7.0, 4.0, 0]),
        sway=waves(([1.5, 1.2, 0.8], 0.13, [0.1, 0.9, 2.5])),
    )  # fmt: skip


def at(lat_deg: float, lon_deg: float = 11.0) -> Array:
    return np.array([lat_deg * DEG, lon_deg * DEG, 50.0])


# ---------------------------------------------------------------- what a master does


def during(begin: float, end: float, change: Change) -> Change:
    return lambda time, message: change(time, message) if begin <= time < end else message


def once(begin: float, change: Change) -> Change:
    """The first message from `begin` on."""
    done: list[float] = []

    def at_first(time: float, message: Message) -> Message | None:
        if time < begin or (done and time != done[0]):
            return message
        done[:] = [time]
        return change(time, message)

    return at_first


def with_field(**fields: Callable[[Any], Any]) -> Change:
    """A message whose fields these functions change."""
    return lambda time, message: replace(
        message, **{n: f(np.array(getattr(message, n), float)) for n, f in fields.items()}
    )


def without_heading(time: float, message: Message) -> Message:
    """Roll and pitch alone."""
    euler = rotation.euler_from_matrix(rotation.matrix_from_quaternion(message.q_m2n_wxyz))
    return replace(message, q_m2n_wxyz=None, euler_m=euler * [1, 1, np.nan])


def turned(euler_deg: Any) -> Change:
    """The master's attitude turned about the level's axes."""
    C = turn(np.asarray(euler_deg, float) * DEG)
    return with_field(q_m2n_wxyz=lambda q: quaternion(C @ rotation.matrix_from_quaternion(q)))


def bent(amplitude: Any, frequency_hz: float) -> Change:
    """The slave's seat bends against the master: seen as a turn of the master about its own axes."""

    def change(time: float, message: Message) -> Message:
        angle = np.asarray(amplitude) * np.sin(2 * np.pi * frequency_hz * np.asarray(message.time)[..., None])
        C = rotation.matrix_from_quaternion(message.q_m2n_wxyz) @ np.swapaxes(turn(angle), -1, -2)
        return replace(message, q_m2n_wxyz=quaternion(C))

    return change


def printed(degrees: float, metres_per_second: float) -> Change:
    """A master whose angles and velocities are printed to so many digits."""

    def change(time: float, message: Message) -> Message:
        euler = rotation.euler_from_matrix(rotation.matrix_from_quaternion(message.q_m2n_wxyz)) / (degrees * DEG)
        return replace(
            message,
            q_m2n_wxyz=rotation.quaternion_from_euler(np.round(euler) * degrees * DEG),
            v_m_n=np.round(np.asarray(message.v_m_n) / metres_per_second) * metres_per_second,
        )

    return change


def R_of_one(run: int, value: float) -> Change:
    """The variances of one run are this, in a message that comes there."""

    def change(time: float, message: Message) -> Message:
        R = np.array(np.broadcast_to(message.R, (len(message.time), 6)))
        rows = np.array(np.broadcast_to(message.rows, R.shape))
        R[run], rows[run] = value, True
        return replace(message, R=R, rows=rows)

    return change


def turned_over(position: Array) -> Array:
    """A longitude as a master reports it, within +-180 deg."""
    return position - [0, 2 * np.pi, 0] * np.round(position / (2 * np.pi))


def latency(sigma: float) -> Change:
    """The data is late by so much more from message to message, and its stamp does not tell."""
    rng = np.random.default_rng(7)
    return with_field(time=lambda stamp: stamp + sigma * rng.standard_normal(np.shape(stamp)))


# ---------------------------------------------------------------- what a slave does


def clipped(rad_s: float, imu_hz: float = 50) -> Sensed:
    return lambda time, d, f: (np.clip(d, -rad_s / imu_hz, rad_s / imu_hz), f)


def scaled(scale: float, axes: float) -> Sensed:
    """Scale factors and axes wrong by so much, one sigma, run by run."""
    rng = np.random.default_rng(8)
    made: list[Array] = []

    def change(time: float, d: Array, f: Array) -> tuple[Array, Array]:
        if not made:
            for _ in range(2):
                M = axes * rng.standard_normal((len(d), 3, 3))
                M[:, range(3), range(3)] = scale * rng.standard_normal((len(d), 3))
                made.append(np.eye(3) + M)
        return np.einsum("rij,rj->ri", made[0], d), np.einsum("rij,rj->ri", made[1], f)

    return change


def lost_between(begin: float, end: float) -> Sensed:
    return lambda time, d, f: None if begin < time <= end else (d, f)


def spoilt_once(begin: float, change: Callable[[Array], None], imu_hz: float = 50) -> Sensed:
    def sensed(time: float, d: Array, f: Array) -> tuple[Array, Array]:
        if begin <= time < begin + 1 / imu_hz - 1e-9:
            d = d.copy()
            change(d)
        return d, f

    return sensed


def nan_axis(d: Array) -> None:
    d[:, 1] = np.nan


def spike(d: Array) -> None:
    d[:, 0] += 0.3


RUNS = 100
NORMAL = np.random.default_rng(7).standard_normal(RUNS)
THIRTY_OFF = 0.6 * DEG * np.random.default_rng(9).standard_normal((RUNS, 3))
THIRTY_OFF[:, 2] = 30 * DEG
FAST, NORTH = np.array([3.0, 0, 0]), np.array([DEG, 0, 0])
CRUISE = np.array([160.0, 120.0, 0.0])
# A hull at pitch 85 +- 4 deg; one that rolls after 100 s at rest.
STEEP = Motion(euler=np.array([0.0, 85 * DEG, 0.6]), seconds=42,
               swing=waves(([6 * DEG, 2 * DEG, 8 * DEG], 0.17, [0.3, 1.2, 2.1]), ([0, 2 * DEG, 0], 0.11, [0, 0.4, 0])),
               sway=waves(([1.5, 1.2, 0.8], 0.13, [0.1, 0.9, 2.5])))  # fmt: skip


def rest_then_roll(rest: float = 100.0) -> Motion:
    return Motion(swing=after(rest, waves(([6 * DEG, 3 * DEG, 3 * DEG], 0.17, [0.0, 1.2, 2.1]))), seconds=rest + 32)


def coning() -> Motion:
    return Motion(
        swing=waves(
            ([6 * DEG, 3 * DEG, 8 * DEG], 0.17, [0.3, 1.2, 2.1]), ([0.5 * DEG, 0.5 * DEG, 0], 5.0, [0, np.pi / 2, 0])
        ),
        steady=np.array([7.0, 4.0, 0.0]),
        sway=waves(([1.5, 1.2, 0.8], 0.13, [0.1, 0.9, 2.5])),
        seconds=42,
    )


PLAIN, POOR = (Sensors(size, size, size, size) for size in (1e-3, 3e-3))
WANDERS = Sensors(gyro_instability=3 * DEG_H, accel_instability=1e-4 * STANDARD_GRAVITY, correlation_s=100.0)
QUICK, SLOW = Sensors(bending=3e-4, bending_hz=1.0), Sensors(bending=2e-3, bending_hz=0.1)

CONDITIONS = (
    Condition("100 Hz, master 10 Hz", moving(), settings={"imu_hz": 100, "master_hz": 10}),
    Condition("50 Hz, master 5 Hz", moving()),
    Condition(
        "36 S, across 180 E",
        moving(place=at(-36, 179.9999)),
        settings={"said": lambda: with_field(position=turned_over)},
    ),
    Condition("80 N", moving(place=at(80))),
    Condition("80 S", moving(place=at(-80))),
    Condition("200 m/s", moving(steady=CRUISE)),
    Condition("200 m/s at 80 N in a full turn", moving(steady=CRUISE, place=at(80), yaw_rate=9 * DEG)),
    Condition("heading across 180 deg", moving(euler=np.array([0.0, 0.0, 179 * DEG]))),
    Condition("pitch 70 deg", moving(euler=np.array([0.0, 70 * DEG, 0.6]))),
    Condition("pitch 85 +- 4 deg", lambda: STEEP),
    Condition("86 N", moving(place=at(86)), "refused", "latitude"),
    Condition(
        "heading 30 deg off, told 30",
        moving(),
        settings={
            "unit": Unit(mounting=(0.6 * DEG, 0.6 * DEG, 30 * DEG)),
            "estimates": {"q_b2m_wxyz": quaternion(turn(THIRTY_OFF) @ MOUNTING)},
        },
    ),
    Condition(
        "heading off by 30 deg, one sigma, to 75 deg in a run",
        moving(),
        "shown",
        settings={"unit": Unit(mounting=(0.6 * DEG, 0.6 * DEG, 30 * DEG))},
    ),
    Condition("master 25 Hz", moving(), settings={"master_hz": 25}),
    Condition("master 50 Hz, 1000 Hz", moving(seconds=22), settings={"imu_hz": 1000, "master_hz": 50, "seconds": 20.0}),
    Condition("master 1 Hz", moving(), settings={"master_hz": 1}),
    Condition(
        "latency jitters by 3 ms, unknown", moving(), "told", "does not fit", settings={"said": lambda: latency(3e-3)}
    ),
    Condition(
        "latency jitters by 10 ms, unknown", moving(), "told", "does not fit", settings={"said": lambda: latency(10e-3)}
    ),
    Condition(
        "10 s without master", moving(), told="no message", settings={"said": lambda: during(15, 25, lambda t, m: None)}
    ),
    Condition(
        "heading +5 deg for good", moving(), "told", "heading", {"said": lambda: during(20, 99, turned([0, 0, -5]))}
    ),
    Condition(
        "velocity +3 m/s for good",
        moving(),
        "told",
        "velocity",
        {"said": lambda: during(20, 99, with_field(v_m_n=lambda v: v + FAST))},
    ),
    Condition("delay 35 to 135 ms", moving(), "heals", "delay", {"tau": lambda time: 0.035 if time < 20 else 0.135}),
    Condition(
        "delay 135 to 35 ms",
        moving(),
        "heals",
        "delay",
        {"tau": lambda time: 0.135 if time < 20 else 0.035, "tau_believed": 0.1},
    ),
    Condition("stamps -0.3 s", moving(), "heals", "clock", {"clock": lambda time: 0.0 if time < 20 else -0.3}),
    Condition("stamps +0.3 s", moving(), "heals", "clock", {"clock": lambda time: 0.0 if time < 20 else 0.3}),
    Condition(
        "clock back by 15 s for good", moving(), "heals", "clock", {"clock": lambda time: 0.0 if time < 20 else -15.0}
    ),
    Condition(
        "position jumps by 1 deg",
        moving(),
        told="position",
        settings={"said": lambda: once(20, with_field(position=lambda p: p + NORTH))},
    ),
    Condition(
        "latitude changes its sign",
        moving(),
        told="position",
        settings={"said": lambda: during(20, 99, with_field(position=lambda p: p * [-1, 1, 1]))},
    ),
    Condition(
        "no number in velocity",
        moving(),
        told="velocity",
        settings={"said": lambda: during(20, 21, with_field(v_m_n=lambda v: v * np.nan))},
    ),
    Condition(
        "no number in attitude",
        moving(),
        told="attitude",
        settings={"said": lambda: during(20, 21, with_field(q_m2n_wxyz=lambda q: q * np.nan))},
    ),
    Condition(
        "no number in position",
        moving(),
        told="position",
        settings={"said": lambda: during(20, 21, with_field(position=lambda p: p * np.nan))},
    ),
    Condition(
        "no number in a stamp",
        moving(),
        told="refused",
        settings={"said": lambda: during(20, 21, with_field(time=lambda s: s * np.nan))},
    ),
    Condition(
        "quaternion of length 2",
        moving(),
        told="attitude",
        settings={"said": lambda: during(20, 21, with_field(q_m2n_wxyz=lambda q: 2 * q))},
    ),
    Condition(
        "no number in R of one run",
        moving(),
        told="refused",
        settings={"said": lambda: once(20, R_of_one(3, np.nan))},
    ),
    Condition(
        "R is zero in one run",
        moving(),
        told="refused",
        settings={"said": lambda: once(20, R_of_one(3, 0.0))},
    ),
    Condition(
        "R is negative in one run",
        moving(),
        told="refused",
        settings={"said": lambda: once(20, R_of_one(3, -1.0))},
    ),
    Condition(
        "no number in a gyro sample", moving(), told="missing", settings={"sensed": lambda: spoilt_once(20, nan_axis)}
    ),
    Condition(
        "a sample of the slave is lost", moving(), told="missing", settings={"sensed": lambda: lost_between(20, 20.02)}
    ),
    Condition("10 s of the slave are lost", moving(), "heals", "anew", {"sensed": lambda: lost_between(15, 25)}),
    Condition("spike of 0.3 rad in a sample", moving(), "heals", "", {"sensed": lambda: spoilt_once(20, spike)}),
    Condition(
        "gyro clips its peaks, told",
        moving(),
        "told",
        "full scale",
        {"sensed": lambda: clipped(0.24), "rules": {"full_scale": (0.24, 100.0)}},
    ),
    Condition("gyro clips its peaks, not told", moving(), "shown", "", {"sensed": lambda: clipped(0.24)}),
    Condition("gyro clips at 0.08 rad/s, most of the time", moving(), "shown", "", {"sensed": lambda: clipped(0.08)}),
    Condition("scale 1000 ppm, axes 1 mrad", moving(), "shown", "", {"sensed": lambda: scaled(1e-3, 1e-3)}),
    Condition("scale 3000 ppm, axes 3 mrad", moving(), "shown", "", {"sensed": lambda: scaled(3e-3, 3e-3)}),
    Condition("bends by 0.3 mrad at 1 Hz", moving(), "shown", "", {"said": lambda: bent([3e-4, 3e-4, 3e-4], 1.0)}),
    Condition("bends by 2 mrad at 0.1 Hz", moving(), "shown", "", {"said": lambda: bent([2e-3, 2e-3, 2e-3], 0.1)}),
    Condition(
        "bends by 2 mrad at 0.1 Hz, mounting noise told",
        moving(),
        "shown",
        settings={"said": lambda: bent([2e-3, 2e-3, 2e-3], 0.1), "constants": {"mu_noise": np.full(3, 1e-3)}},
    ),
    Condition("scale 1000 ppm, axes 1 mrad, carried", moving(), settings={"sensors": PLAIN, "carrying": PLAIN}),
    Condition("scale 3000 ppm, axes 3 mrad, carried", moving(), settings={"sensors": POOR, "carrying": POOR}),
    Condition("instability 3 deg/h, 100 ug, carried", moving(), settings={"sensors": WANDERS, "carrying": WANDERS}),
    Condition("bends 0.3 mrad at 1 Hz, carried", moving(), settings={"sensors": QUICK, "carrying": QUICK}),
    Condition("bends 2 mrad at 0.1 Hz, carried", moving(), settings={"sensors": SLOW, "carrying": SLOW}),
    Condition("lever arm of 30 m", moving(), settings={"lever_b": (20.0, -10.0, 20.0)}),
    Condition(
        "lever arm of 30 m, known in the master's axes",
        moving(),
        settings={"lever_b": (20.0, -10.0, 20.0), "constants": {"lever_m": MOUNTING @ (20.0, -10.0, 20.0)}},
    ),
    Condition(
        "first message late by a delay that is known, 6 deg/s",
        rolling,
        settings={"tau": 0.035 + 1e-3 * NORMAL, "tau_believed": 0.035, "tau_sigma": 1e-3, "hand_over": 0.2},
    ),
    Condition(
        "delay unknown to 50 ms, 6 deg/s",
        rolling,
        settings={"tau": 0.05 * NORMAL, "hand_over": 0.2},
    ),
    Condition(
        "master without a heading",
        moving(),
        told="the heading is known to",
        settings={"start": Headings, "said": lambda: without_heading},
    ),
    Condition("coning 0.5 deg at 5 Hz", coning, "shown"),
    Condition(
        "coning 0.5 deg at 5 Hz, delay known to 3 ms",
        coning,
        "shown",
        settings={"tau_sigma": 3e-3, "tau_believed": 0.035},
    ),
    Condition("parked 100 s, then rolls", rest_then_roll, "delay", settings={"seconds": 130.0}),
    Condition("parked, MEMS", lambda: parked(seconds=62), settings={"seconds": 60.0, "unit": FINE}),
    Condition("parked 20 s, MEMS, then rolls", lambda: rest_then_roll(20.0), settings={"unit": FINE}),
    Condition(
        "parked, MEMS, printed to .01 deg and .01 m/s",
        lambda: parked(seconds=62),
        "taken",
        settings={
            "said": lambda: printed(0.01, 0.01),
            "seconds": 60.0,
            "jitter": 0.0,
            "unit": replace(MEMS, velocity=1e-9, attitude=1e-9),
            "R": np.repeat([0.01 / 12**0.5, 0.01 * DEG / 12**0.5], 3) ** 2,
        },
    ),
)
