"""The same flight in Python: the filter of `boresight.runtime.filter` on the schedule of flight.c.

python flight.py FILE
"""

import sys
from pathlib import Path

import numpy as np
from make_recording import MASTER, Setup, read

from boresight import BoresightError, Filter, load, rotation, units

PAST, HALF, EVERY, GATE, ASTRAY = 64, 4, 8, 6.0, 5  # of flight.h
LINE = "{:4d} {:12.7f} {:10.6f} {:10.6f} {:10.6f} {:10.6f} {:9.5f} {:9.5f}"


class Flight:
    """All of the slave's past in arrays, by tick; flight.c keeps the last of it in a ring."""

    def __init__(self, setup: Setup, ticks: int):
        self.setup = setup
        self.model = load("velocity-attitude")
        self.constants = {
            "lever_b": np.array(setup.lever_b),
            "gyro_noise": np.full(3, setup.gyro_noise),
            "accel_noise": np.full(3, setup.accel_noise),
            **dict.fromkeys(("gyro_bias_noise", "accel_bias_noise", "mu_noise"), np.zeros(3)),
            "tau_noise": 0.0,
        }
        self.v_n, self.q_b2n_wxyz = np.zeros((ticks + 1, 3)), np.zeros((ticks + 1, 4))
        self.dtheta, self.dv = np.zeros((ticks + 1, 3)), np.zeros((ticks + 1, 3))
        self.now = self.predicted = self.corrected = 0  # ticks
        self.astray: dict[str, int] = {}  # by measurement, messages in a row with a row beyond the gate
        self.loop: Filter | None = None

    def start(self, message: np.ndarray) -> None:
        s = self.setup
        # As flight.c: the master's velocity and attitude as they are; the setup says how wrong they are.
        C_m2n, zero = rotation.matrix_from_quaternion(message[7:11]), np.zeros(3)
        nav = {"lat_lon_height": message[1:4], "v_n": message[4:7], "q_b2n_wxyz": message[7:11]}
        nav |= {
            "gyro_bias": zero,
            "accel_bias": zero,
            "q_b2m_wxyz": np.array([1.0, 0.0, 0.0, 0.0]),
            "tau": np.array(0.0),
        }
        sigmas = (s.start_velocity_sigma, s.gyro_bias_sigma, s.accel_bias_sigma, s.mounting_sigma)
        variances = np.concatenate([np.broadcast_to(np.square(sigma), 3) for sigma in sigmas])
        P = np.diag([0.0, 0.0, 0.0, *variances, s.tau_sigma**2])
        P[:3, 12:15] = C_m2n @ P[12:15, 12:15]
        P[12:15, :3] = P[:3, 12:15].T
        P[:3, :3] = C_m2n @ P[12:15, :3] + (s.attitude_sigma**2 + s.start_angle_sigma**2) * np.eye(3)
        P[:3, :3] = (P[:3, :3] + P[:3, :3].T) / 2
        self.loop = Filter(self.model, nav, P)
        self.dtheta[self.now] = self.dv[self.now] = 0.0
        self.predicted = self.corrected = self.now
        self.astray = {}
        self.remember()

    def remember(self) -> None:
        self.v_n[self.now], self.q_b2n_wxyz[self.now] = self.loop.nav["v_n"], self.loop.nav["q_b2n_wxyz"]

    def slave(self, dtheta: np.ndarray, dv: np.ndarray) -> None:
        self.now += 1
        if self.loop is None:
            return
        k, dt = self.now, self.setup.dt
        before = {"dtheta_before": self.dtheta[k - 1], "dv_before": self.dv[k - 1]}
        if not np.isfinite([dtheta, dv]).all():
            dtheta, dv = before.values()
        self.dtheta[k], self.dv[k] = dtheta, dv
        self.loop.strapdown(dtheta_ib_b=dtheta, dv_b=dv, **before, dt=dt)
        self.remember()
        if k - self.predicted == EVERY:
            self.carry()

    def mean(self, start: int, end: int) -> dict[str, np.ndarray]:
        seconds, part, nav = (end - start) * self.setup.dt, slice(start + 1, end + 1), self.loop.nav
        return {
            "f_b": self.dv[part].sum(0) / seconds - nav["accel_bias"],
            "omega_ib_b": self.dtheta[part].sum(0) / seconds - nav["gyro_bias"],
        }

    def carry(self) -> None:
        if self.now > self.predicted:
            dt = (self.now - self.predicted) * self.setup.dt
            self.loop.predict(**self.mean(self.predicted, self.now), dt=dt, **self.constants)
            self.predicted = self.now

    def then(self, k: int) -> dict[str, np.ndarray]:
        """The slave at tick k, as the model's functions ask for it."""
        return {"v_n": self.v_n[k], "q_b2n_wxyz": self.q_b2n_wxyz[k], **self.mean(k - HALF, k + HALF), **self.constants}

    def master(self, message: np.ndarray) -> None:
        if self.loop is None:
            return self.start(message)
        s, loop = self.setup, self.loop
        fresh = min(self.now - self.corrected, PAST - 1)
        if fresh < 4 * HALF:
            return None
        self.carry()
        age = message[0] + loop.nav["tau"]
        ticks = int(np.clip(np.ceil(age / s.dt - 0.5), 2 * HALF, fresh - 2 * HALF))
        k = self.now - ticks
        early, late = (loop.call("expected", **self.then(at))["v_m_n"] for at in (k - HALF, k + HALF))
        a_n = (late - early) / (2 * HALF * s.dt)
        inputs = {**self.then(k), "lat_lon_height": message[1:4], "a_n": a_n, "lag": age - ticks * s.dt}
        used = {}
        for name, sigma, given in (
            ("velocity", s.velocity_sigma, {"v_m_n": message[4:7]}),
            ("dcm", s.attitude_sigma, {"q_m2n_wxyz": message[7:11]}),
        ):
            try:
                used[name] = loop.update(name, np.full(3, sigma**2), gate=GATE, **inputs, **given).used
            except BoresightError as error:
                print(f"{self.now * s.dt:8.4f}: {error}")
        loop.feedback()
        if used:
            loop.nav["lat_lon_height"] = message[1:4]
        self.remember()
        self.corrected = self.now
        for name, rows in used.items():
            self.astray[name] = 0 if np.all(rows) else self.astray.get(name, 0) + 1
        if len(used) == 2 and max(self.astray.values()) >= ASTRAY:
            self.loop = None
        return None

    def line(self) -> np.ndarray:
        """(7,) heading in deg, its sigma in mil, misalignment in deg, delay and its sigma in ms."""
        nav, sigma = self.loop.nav, np.sqrt(np.diag(self.loop.P))
        heading = rotation.euler_from_matrix(rotation.matrix_from_quaternion(nav["q_b2n_wxyz"]))[2] / units.DEG % 360
        mu = rotation.vector_from_matrix(rotation.matrix_from_quaternion(nav["q_b2m_wxyz"])) / units.DEG
        return np.array([heading, sigma[2] / units.MIL, *mu, 1e3 * nav["tau"], 1e3 * sigma[15]])


def fly(path: Path) -> np.ndarray:
    """(S, 8): the second, and what `Flight.line` says then."""
    setup, records = read(path)
    flight = Flight(setup, len(records))
    lines, per_second = [], round(1 / setup.dt)
    for kind, *values in records:
        if kind == MASTER:
            flight.master(np.array(values))
            continue
        flight.slave(np.array(values[:3]), np.array(values[3:6]))
        if flight.now % per_second == 0 and flight.loop is not None:
            lines.append([flight.now // per_second, *flight.line()])
    return np.array(lines)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python flight.py FILE")
    for second, *given in fly(Path(sys.argv[1])):
        print(LINE.format(int(second), *given))
