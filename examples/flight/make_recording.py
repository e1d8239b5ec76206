"""Write the recording of a minute at sea: a MEMS slave at 200 Hz, its master at 10 Hz and late.

python make_recording.py FILE

A hull of 40 m at sea state 5 (2.5 m), long waves from port ahead.  Beside what sensors do, the recording holds what
happens: a second of messages is lost, one holds a velocity that is no number, one a velocity of 3 m/s too much, and one
of the slave's increments is no number.  Instants are microseconds of the slave's clock: the end of a sample's interval,
and when a message arrived.
"""

import sys
from dataclasses import astuple, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from boresight import load, rotation, units
from boresight.simulation import hull, inertial, sea, sensors

MASTER_S = 0.0999  # its clock is 0.1 % fast, so that messages and ticks slide past each other
WIDTH = 12  # doubles of a record
SLAVE, MASTER = 0.0, 1.0  # the first of them


@dataclass(frozen=True)
class Setup:
    """The first doubles of a recording, `flight_head` of board.h: what is known beforehand."""

    dt: float = 1 / 200
    lever_b: tuple[float, ...] = (3.0, 1.0, -1.0)
    gyro_noise: tuple[float, ...] = 3 * (0.15 * units.DEG / units.HOUR**0.5,)
    accel_noise: tuple[float, ...] = 3 * (0.05 / units.HOUR**0.5,)
    velocity_variance: tuple[float, ...] = 3 * (0.01**2,)
    attitude_variance: tuple[float, ...] = 3 * ((0.003 * units.DEG) ** 2,)
    sigma: tuple[float, ...] = (
        *(3 * [0.1]),  # attitude and velocity: the first messages tell them
        *(3 * [3.0]),
        *(3 * [20 * units.DEG / units.HOUR]),
        *(3 * [2e-3 * units.STANDARD_GRAVITY]),
        *(0.5 * units.DEG, 0.5 * units.DEG, 2.0 * units.DEG),  # the mounting is believed to be straight
        0.03,  # of the delay, which is believed to be zero
    )

    def doubles(self) -> np.ndarray:
        return np.hstack(astuple(self))


@dataclass(frozen=True)
class Truth:
    """What the recording was made from."""

    q_b2n_wxyz: np.ndarray  # (N + 1, 4) at the ticks
    q_b2m_wxyz: np.ndarray  # (4,)
    tau: float


def record(seed: int = 1, seconds: float = 60.0, tau: float = 0.0337) -> tuple[Setup, np.ndarray, Truth]:
    """(what is known, the records (N, WIDTH) in the order in which they come, the truth)."""
    s = Setup()
    ticks = round(seconds / s.dt)
    time = np.arange(ticks + 1) * s.dt
    rng = sensors.generator(seed, 0)
    omega, elevation = sea.components(2.5)
    phases = hull.phases([rng], omega.shape[-1])[0]
    ship: dict[str, Any] = {"towards": 165 * units.DEG, "heading": 30 * units.DEG, "speed": 5.0}
    motion = hull.in_sea(hull.Hull(), omega, elevation, phases, **ship)
    q_b2m = rotation.quaternion_from_euler(np.array([-0.4, 0.6, 2.0]) * units.DEG)
    slave = hull.carried(hull.ride(motion, time), s.lever_b, q_b2m)
    strapdown = load("velocity-attitude").strapdown
    place = np.array([[36 * units.DEG, 0.1, 0.0]])  # an axis of runs, of one
    dtheta, dv, path = inertial.increments(strapdown, place, slave.v_n[:, None], slave.q_b2n_wxyz[:, None], s.dt)
    dtheta, dv, position = dtheta[:, 0], dv[:, 0], path.position[:, 0]

    gyro_bias, accel_bias = s.sigma[6] * rng.standard_normal(3), s.sigma[9] * rng.standard_normal(3)
    dtheta = dtheta + gyro_bias * s.dt + np.array(s.gyro_noise) * s.dt**0.5 * rng.standard_normal((ticks, 3))
    dv = dv + accel_bias * s.dt + np.array(s.accel_noise) * s.dt**0.5 * rng.standard_normal((ticks, 3))
    dtheta[round(0.6 * ticks), 1] = np.nan

    measured = np.arange(0, seconds - tau, MASTER_S)
    arrived = measured + tau
    taken = np.ceil(arrived / s.dt - 1e-9).astype(int)  # behind the first sample that ends later
    master = hull.ride(motion, measured)
    C = rotation.matrix_from_quaternion(master.q_b2n_wxyz)
    turn = np.sqrt(s.attitude_variance) * rng.standard_normal((len(measured), 3))
    message = np.column_stack(
        [
            np.round(arrived * 1e6),
            position[np.round(measured / s.dt).astype(int)],  # 3 m from the master's own
            master.v_n + np.sqrt(s.velocity_variance) * rng.standard_normal((len(measured), 3)),
            rotation.turned(master.q_b2n_wxyz, np.einsum("kji,kj->ki", C, turn)),
        ]
    )
    message[len(message) // 2, 4] = np.nan
    message[2 * len(message) // 3, 4] += 3.0
    kept = (measured < seconds / 3) | (measured > seconds / 3 + 1.0)

    records = np.zeros((ticks + kept.sum(), WIDTH))
    order = np.argsort(np.concatenate([np.arange(1, ticks + 1), taken[kept]]), kind="stable")
    records[:ticks, 1:8] = np.column_stack([np.round(time[1:] * 1e6), dtheta, dv])
    records[ticks:, 0], records[ticks:, 1:] = MASTER, message[kept]
    return s, records[order], Truth(slave.q_b2n_wxyz, q_b2m, tau)


def write(path: Path, setup: Setup, records: np.ndarray) -> None:
    with path.open("wb") as file:
        for part in (setup.doubles(), records):
            file.write(part.astype("<f8").tobytes())


def read(path: Path) -> tuple[Setup, np.ndarray]:
    """What `write` wrote."""
    doubles = np.fromfile(path, "<f8")
    head = len(Setup().doubles())
    sizes = [np.size(value) for value in astuple(Setup())]
    dt, *known = (tuple(part) for part in np.split(doubles[:head].tolist(), np.cumsum(sizes)[:-1]))
    setup = Setup(dt[0], *known)
    return setup, doubles[head:].reshape(-1, WIDTH)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python make_recording.py FILE")
    write(Path(sys.argv[1]), *record()[:2])
