"""Flights of a slave and its master for the live loop, by nothing that the loop or its models are made of.

Own Earth, own kinematics, NumPy and SciPy's rotations alone.  NED and front-right-down, SI and rad.  A motion is two
functions of time; rates and accelerations are their derivatives, by differences of the fourth order, and increments
are integrals by Gauss's rule.  Axes: time first, then runs, then components.

    error       computed - true; C_hat_b2n = exp(-[phi x]) C_b2n, C_hat_b2m = exp(-[dmu x]) C_b2m
    mounting    C_b2n = C_m2n C_b2m, as a rotation vector of C_b2m, slave body to master body
    lever arm   from the master to the slave, in the slave's body axes
    delay       a message that is stamped t tells of t - tau
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

DEG, MG, DEG_H = np.pi / 180, 9.80665e-3, np.pi / 180 / 3600
US = 1e-6

# ---- the Earth: NIMA TR8350.2, third edition, tables 3.1, 3.3, 3.4; equations (4-1), (4-3)
A, E2, F, M = 6378137.0, 6.69437999014e-3, 1 / 298.257223563, 0.00344978650684
OMEGA_IE, G_EQUATOR, K = 7.292115e-5, 9.7803253359, 0.00193185265241


def radii(lat, height):
    """(north-south, east-west) m, by which a displacement is an angle of the level."""
    w2 = 1 - E2 * np.sin(lat) ** 2
    return A * (1 - E2) / w2**1.5 + height, A / np.sqrt(w2) + height


def gravity(lat, height):
    """Normal gravity, m/s^2, downwards."""
    s2 = np.sin(lat) ** 2
    at_zero = G_EQUATOR * (1 + K * s2) / np.sqrt(1 - E2 * s2)
    return at_zero * (1 - 2 / A * (1 + F + M - 2 * F * s2) * height + 3 * (height / A) ** 2)


def omega_ie_n(lat):
    return OMEGA_IE * np.stack([np.cos(lat), 0 * lat, -np.sin(lat)], axis=-1)


def omega_en_n(place, v_n):
    meridian, normal = radii(place[..., 0], place[..., 2])
    east = v_n[..., 1] / normal
    return np.stack([east, -v_n[..., 0] / meridian, -east * np.tan(place[..., 0])], axis=-1)


def place_rate(place, v_n):
    meridian, normal = radii(place[..., 0], place[..., 2])
    return np.stack([v_n[..., 0] / meridian, v_n[..., 1] / normal / np.cos(place[..., 0]), -v_n[..., 2]], axis=-1)


# ---- rotations


def matrix(turn):
    """(..., 3) rotation vector -> (..., 3, 3)."""
    turn = np.array(turn, float)
    return Rotation.from_rotvec(turn.reshape(-1, 3)).as_matrix().reshape(*turn.shape[:-1], 3, 3)


def matrix_of_euler(euler):
    """(..., 3) roll, pitch, heading -> (..., 3, 3) body to level, Rz(heading) Ry(pitch) Rx(roll)."""
    return Rotation.from_euler("ZYX", euler.reshape(-1, 3)[:, ::-1]).as_matrix().reshape(*euler.shape[:-1], 3, 3)


def matrix_of_quaternion(q_wxyz):
    q_wxyz = np.asarray(q_wxyz, float)
    turns = Rotation.from_quat(q_wxyz.reshape(-1, 4), scalar_first=True)
    return turns.as_matrix().reshape(*q_wxyz.shape[:-1], 3, 3)


def quaternion(C):
    """(..., 3, 3) -> (..., 4), scalar first and not negative."""
    turns = Rotation.from_matrix(C.reshape(-1, 3, 3))
    return turns.as_quat(canonical=True, scalar_first=True).reshape(*C.shape[:-2], 4)


def turn_between(computed, true):
    """(..., 3) e of C_computed = exp(-[e x]) C_true, from two arrays of quaternions (..., 4)."""
    C = matrix_of_quaternion(computed) @ np.swapaxes(matrix_of_quaternion(true), -1, -2)
    return -Rotation.from_matrix(C.reshape(-1, 3, 3)).as_rotvec().reshape(*C.shape[:-2], 3)


def times(C, v):
    return (C @ v[..., None])[..., 0]


def back(C, v):
    return (np.swapaxes(C, -1, -2) @ v[..., None])[..., 0]


# ---- motions


@dataclass(frozen=True)
class Motion:
    """euler(t): (..., 3) roll, pitch, heading of the master; v_n(t): (..., 3) velocity of the slave; t: (...) s."""

    euler: Callable
    v_n: Callable
    place: tuple[float, float, float] = (0.6, 2.2, 20.0)  # rad, rad, m where the slave is at t = 0


def sines(t, *terms):
    """Sum of amplitude * sin(2 pi frequency_hz t + phase)."""
    return sum((a * np.sin(2 * np.pi * f * t + p) for a, f, p in terms), np.zeros_like(t))


def along(t, speed, heading, down=0.0):
    return np.stack(np.broadcast_arrays(speed * np.cos(heading), speed * np.sin(heading), down + 0 * t), axis=-1)


def level(roll=(), pitch=(), yaw=(), heading=0.5, rate=0.0):
    """Attitude with swings (amplitude, Hz, phase) about a heading that turns at `rate`, rad/s."""
    return lambda t: np.stack([sines(t, *roll), sines(t, *pitch), heading + rate * t + sines(t, *yaw)], axis=-1)


def ship(speed=8.0, rate=0.0, swing=1.0, heading=0.5):
    """Roll 6, pitch 3, yaw 3 deg and heave 1 m, 0.12 to 0.17 Hz, times `swing`."""
    s = swing * DEG
    euler = level([(6 * s, 0.15, 0.3)], [(3 * s, 0.17, 1.2)], [(3 * s, 0.12, 2.1)], heading, rate)
    heave, surge = (swing * 2 * np.pi * 0.15, 0.15, 2.0), (0.4 * swing, 0.13, 0.0)
    return Motion(euler, lambda t: along(t, speed + sines(t, surge), heading + rate * t, sines(t, heave)))


def turn(speed, rate, **swings):
    """A level turn at `rate`, rad/s; a part of a degree of roll if swings say so."""
    euler = level(heading=0.5, rate=rate, **swings)
    return Motion(euler, lambda t: along(t, speed, 0.5 + rate * t))


def steady_course(speed, **swings):
    return turn(speed, 0.0, **swings)


def turntable(rate, arm):
    """The master on the axis, the slave so far (m) in front of it; for a lever arm of (arm, 0, 0)."""
    return Motion(level(heading=0.5, rate=rate), lambda t: along(t, rate * arm, 0.5 + rate * t + np.pi / 2))


def s_turns(speed=100.0, load=2.0, period=20.0):
    """Coordinated turns to either side, at most `load` g."""
    most, w = 9.81 * np.sqrt(load**2 - 1) / speed, 2 * np.pi / period

    def euler(t):
        heading = 0.5 - most / w * np.cos(w * t)
        return np.stack([np.arctan(speed * most * np.sin(w * t) / 9.81), 0 * t, heading], axis=-1)

    return Motion(euler, lambda t: along(t, speed, euler(t)[..., 2]), (0.6, 2.2, 1500.0))


def catapult(at=14.0, a=30.0, span=2.0, edge=0.05):
    """At rest, then `a` m/s^2 for `span` s with soft edges, then a steady course with a slow swing."""

    def speed(t):
        def soft(x):
            return edge * np.logaddexp(0, x / edge)

        return a * (soft(t - at) - soft(t - at - span))

    def flying(t):
        return 0.5 + 0.5 * np.tanh(t - at - span - 4)

    def euler(t):
        swings = np.stack([sines(t, (10 * DEG, 0.2, 0)), sines(t, (3 * DEG, 0.17, 1)), sines(t, (5 * DEG, 0.1, 2))], -1)
        return flying(t)[..., None] * swings + np.array([0, 0, 0.5])

    return Motion(euler, lambda t: along(t, speed(t), 0.5))


MOTIONS = {
    "ship": ship(rate=1 * DEG),
    "ship, steady course": ship(),
    "calm": ship(swing=0.15),
    "steady turn": turn(8.0, 1 * DEG),
    "loiter": turn(25.0, 5 * DEG),
    "turntable": turntable(10 * DEG, 3.0),
    "small roll": turn(8.0, 0.0, roll=[(0.2 * DEG, 0.15, 0.3)]),
    "parked": turn(0.0, 0.0),
    "steady course": steady_course(8.0),
    "s-turns": s_turns(),
    "catapult": catapult(),
    "far north": replace(ship(rate=1 * DEG), place=(84 * DEG, 0.2, 20.0)),
}


def derivative(f, t, h=1e-3):
    return (8 * (f(t + h) - f(t - h)) - (f(t + 2 * h) - f(t - 2 * h))) / (12 * h)


# ---- the truth of one motion

NODES, WEIGHTS = (part / 2 for part in np.polynomial.legendre.leggauss(4))
NODES = NODES + 0.5
# INTO[i, j]: the integral to node i of the polynomial that is one at node j and zero at the others
POWERS = np.arange(1, 5)
INTO = (NODES[:, None] ** POWERS / POWERS) @ np.linalg.inv(NODES[:, None] ** (POWERS - 1))


@dataclass(frozen=True)
class Track:
    """What is true, at the K + 1 ends of the intervals of an ideal slave, and its increments."""

    motion: Motion
    C_b2m: np.ndarray  # (3, 3)
    lever_b: np.ndarray  # (3,) m
    time: np.ndarray  # (K + 1,) s
    place: np.ndarray  # (K + 1, 3) of the slave
    v_n: np.ndarray  # (K + 1, 3) of the slave
    q_b2n_wxyz: np.ndarray  # (K + 1, 4)
    dtheta: np.ndarray  # (K, 3) rad
    dv: np.ndarray  # (K, 3) m/s

    def attitude(self, t):
        """(..., 3, 3) C_m2n and C_b2n."""
        C_m2n = matrix_of_euler(self.motion.euler(np.asarray(t, float)))
        return C_m2n, C_m2n @ self.C_b2m

    def rates(self, t, place):
        """omega_ib_b, omega_eb_b, f_b (..., 3) of the slave."""
        roll, pitch, _ = np.moveaxis(self.motion.euler(t), -1, 0)
        r, p, y = np.moveaxis(derivative(self.motion.euler, t), -1, 0)
        omega_nm_m = np.stack(
            [
                r - y * np.sin(pitch),
                p * np.cos(roll) + y * np.cos(pitch) * np.sin(roll),
                -p * np.sin(roll) + y * np.cos(pitch) * np.cos(roll),
            ],
            axis=-1,
        )
        C_b2n, v_n = self.attitude(t)[1], self.motion.v_n(t)
        en, ie = omega_en_n(place, v_n), omega_ie_n(place[..., 0])
        omega_eb_b = back(self.C_b2m, omega_nm_m) + back(C_b2n, en)
        g_n = gravity(place[..., 0], place[..., 2])[..., None] * np.array([0, 0, 1.0])
        f_n = derivative(self.motion.v_n, t) + np.cross(2 * ie + en, v_n) - g_n
        return omega_eb_b + back(C_b2n, ie), omega_eb_b, back(C_b2n, f_n)

    def place_at(self, t):
        """(..., 3) of the slave, on the line between two samples: to millimetres."""
        return np.stack([np.interp(t, self.time, self.place[:, i]) for i in range(3)], axis=-1)

    def master(self, t):
        """v_m_n (..., 3), q_m2n_wxyz (..., 4), place (..., 3); the level is that of the slave."""
        t = np.asarray(t, float)
        place, (C_m2n, C_b2n), v_n = self.place_at(t), self.attitude(t), self.motion.v_n(t)
        lever_n, rate = times(C_b2n, self.lever_b), self.rates(t, place)[1]
        v_m_n = v_n - times(C_b2n, np.cross(rate, self.lever_b))
        return v_m_n, quaternion(C_m2n), place - place_rate(place, lever_n)


def track(motion, seconds, rate_hz=50, mounting=(0.0, 0.0, 0.0), lever_b=(0.0, 0.0, 0.0)):
    dt, K = 1 / rate_hz, round(seconds * rate_hz)
    time = np.arange(K + 1) / rate_hz
    at = time[:-1, None] + dt * NODES
    v_n = motion.v_n(at)
    ends = np.broadcast_to(np.asarray(motion.place, float), (K + 1, 3)).copy()
    for _ in range(5):  # each pass is better by the part of the Earth's radius that is travelled
        inside = ends[:-1, None] + dt * (INTO @ place_rate(np.broadcast_to(ends[:-1, None], v_n.shape), v_n))
        rate = place_rate(inside, v_n)
        inside = ends[:-1, None] + dt * (INTO @ rate)
        ends[1:] = ends[0] + np.cumsum(dt * (WEIGHTS @ place_rate(inside, v_n)), axis=0)
    whole = Track(
        motion,
        matrix(np.asarray(mounting)),
        np.asarray(lever_b, float),
        time,
        ends,
        motion.v_n(time),
        np.empty(0),
        np.empty(0),
        np.empty(0),
    )
    omega, _, f = whole.rates(at, inside)
    q = quaternion(whole.attitude(time)[1])
    return replace(whole, q_b2n_wxyz=q, dtheta=dt * (WEIGHTS @ omega), dv=dt * (WEIGHTS @ f))


# ---- a slave and a master with errors


@dataclass(frozen=True)
class Setting:
    """Sizes, one sigma where they are drawn for each run; the defaults are the standard flight."""

    motion: Motion = MOTIONS["ship"]
    seconds: float = 40.0
    runs: int = 30
    seed: int = 301
    slave_hz: int = 50
    master_hz: float = 5.0
    begin: float = 1.0  # s, of the first message
    gyro_bias: float = 10 * DEG_H
    accel_bias: float = 1 * MG
    gyro_noise: float = 3e-5  # rad/sqrt(s)
    accel_noise: float = 1e-3  # m/s/sqrt(s)
    mounting: tuple = (0.6 * DEG, 0.6 * DEG, 2 * DEG)  # of the belief, which is none
    lever_b: tuple = (-2.4, 1.2, 1.75)  # m, true
    lever_believed: tuple | None = None  # as true
    tau: float = 0.035  # s, true at t = 0
    tau_drift: float = 0.0  # s/s
    tau_step: tuple = (np.inf, 0.0)  # s, when, and by what the delay steps
    tau_believed: float = 0.0
    tau_sigma: float = 0.05
    tau_noise: float = 1e-7  # sqrt(s), what the loop is given
    jitter: float = 0.003  # s, of the time between messages; stamps are exact
    lost: float = 0.1
    late: float = 0.0  # s, from the stamp to the arrival
    v_sigma: float = 0.02  # m/s
    a_sigma: float = 0.3e-3  # rad

    def tau_at(self, stamp):
        """True delay of what is stamped at s, s."""
        return self.tau + self.tau_drift * stamp + self.tau_step[1] * (stamp > self.tau_step[0])

    def constants(self):
        """What the model's functions ask for, of the slave and its noise."""
        lever = self.lever_b if self.lever_believed is None else self.lever_believed
        full = {
            "gyro_noise": self.gyro_noise,
            "accel_noise": self.accel_noise,
            "gyro_bias_noise": 1e-8,
            "accel_bias_noise": 1e-7,
            "mu_noise": 1e-8,
        }
        return (
            {"lever_b": np.array(lever)} | {n: np.full(3, v) for n, v in full.items()} | {"tau_noise": self.tau_noise}
        )

    def sigmas(self):
        """Of what the filter estimates beside velocity and attitude, one sigma."""
        return {
            "q_b2m_wxyz": np.array(self.mounting),
            "gyro_bias": np.full(3, self.gyro_bias),
            "accel_bias": np.full(3, self.accel_bias),
            "tau": self.tau_sigma,
        }


@dataclass(frozen=True)
class Messages:
    """What the master sends: M messages, whose stamps, losses and contents are the runs' own."""

    after: np.ndarray  # (M,) int, arrives behind the sample of this number
    stamp_us: np.ndarray  # (M, runs) int64, of the slave's clock
    came: np.ndarray  # (M, runs) bool
    v_m_n: np.ndarray  # (M, runs, 3)
    q_m2n_wxyz: np.ndarray  # (M, runs, 4)
    position: np.ndarray  # (M, runs, 3) rad, rad, m
    R: np.ndarray  # (M, runs, 6) variances of velocity and attitude about n, e, d
    measured: np.ndarray  # (M, runs) s, when it was measured


@dataclass(frozen=True)
class Flight:
    """One setting as a loop sees it, and the truth beside it."""

    setting: Setting
    track: Track
    interval: np.ndarray  # (K,) int, of the track, that the sample is of
    end_us: np.ndarray  # (K,) int64, tags of the slave
    dt: np.ndarray  # (K,) s, which comes with the sample
    clock: np.ndarray  # (K,) s, by which stamps are ahead of the slave's tags
    dtheta: np.ndarray  # (K, runs, 3)
    dv: np.ndarray  # (K, runs, 3)
    messages: Messages
    gyro_bias: np.ndarray  # (runs, 3) true
    accel_bias: np.ndarray  # (runs, 3)
    q_believed: np.ndarray  # (runs, 4) mounting as it is believed at the start
    drift: np.ndarray | None = None  # (2, K, runs, 3) what the biases of gyros and accelerometers wander by

    @property
    def end(self):
        """(K,) s, when the samples end by a clock that is right."""
        return self.track.time[self.interval + 1]

    def truth(self, k):
        """What is true at the end of the k-th sample, by the names of nav; the delay is that by the slave's tags."""
        true, i = self.track, self.interval[k] + 1
        return {
            "lat_lon_height": true.place[i],
            "v_n": true.v_n[i],
            "q_b2n_wxyz": true.q_b2n_wxyz[i],
            "gyro_bias": self.gyro_bias + (0.0 if self.drift is None else self.drift[0][k]),
            "accel_bias": self.accel_bias + (0.0 if self.drift is None else self.drift[1][k]),
            "q_b2m_wxyz": quaternion(true.C_b2m),
            "tau": self.setting.tau_at(true.time[i]) + self.clock[k],
        }

    def events(self, run) -> Iterator[tuple]:
        """("sample", at_us, dt, dtheta, dv) and ("message", at_us, fields) of one run in order of arrival."""
        sent = self.messages
        waiting = np.argsort(sent.after, kind="stable").tolist()
        for k in range(len(self.end_us)):
            yield "sample", int(self.end_us[k]), float(self.dt[k]), self.dtheta[k, run], self.dv[k, run]
            while waiting and sent.after[waiting[0]] <= k:
                m = waiting.pop(0)
                if sent.came[m, run]:
                    fields = {name: getattr(sent, name)[m, run] for name in ("v_m_n", "q_m2n_wxyz", "position", "R")}
                    yield "message", int(sent.stamp_us[m, run]), fields


def fly(setting: Setting, **changes) -> Flight:
    """Draw the errors of all runs and what their sensors and masters send."""
    setting = replace(setting, **changes)
    runs = setting.runs
    random = np.random.default_rng(setting.seed)
    true = track(setting.motion, setting.seconds, setting.slave_hz, (0, 0, 0), setting.lever_b)
    K, dt = len(true.dtheta), 1 / setting.slave_hz
    gyro_bias, accel_bias = (
        size * random.standard_normal((runs, 3)) for size in (setting.gyro_bias, setting.accel_bias)
    )
    believed = quaternion(matrix(-np.array(setting.mounting) * random.standard_normal((runs, 3))) @ true.C_b2m)
    white = random.standard_normal((2, K, runs, 3)) * np.sqrt(dt)
    dtheta = true.dtheta[:, None] + gyro_bias * dt + setting.gyro_noise * white[0]
    dv = true.dv[:, None] + accel_bias * dt + setting.accel_noise * white[1]
    end_us = np.round(true.time[1:] / US).astype(np.int64)
    sent = send(setting, true, end_us, random)
    return Flight(
        setting=setting,
        track=true,
        interval=np.arange(K),
        end_us=end_us,
        dt=np.full(K, dt),
        clock=np.zeros(K),
        dtheta=dtheta,
        dv=dv,
        messages=sent,
        gyro_bias=gyro_bias,
        accel_bias=accel_bias,
        q_believed=believed,
    )


def send(setting, true, end_us, random):
    """The master's messages: stamped to the microsecond, measured tau before, white noise on all."""
    last = setting.seconds - setting.late - 5 * setting.jitter
    due = np.arange(setting.begin, last, 1 / setting.master_hz)
    shape = len(due), setting.runs
    stamp_us = np.round((due[:, None] + setting.jitter * np.abs(random.standard_normal(shape)).clip(0, 4)) / US)
    measured = stamp_us * US - setting.tau_at(stamp_us * US)
    v, q, place = true.master(measured)
    v = v + setting.v_sigma * random.standard_normal(v.shape)
    q = quaternion(matrix(setting.a_sigma * random.standard_normal(v.shape)) @ matrix_of_quaternion(q))
    place = place + place_rate(place, 2.0 * random.standard_normal(v.shape))
    came = random.random(shape) >= setting.lost
    came[0] = True
    after = np.searchsorted(end_us, stamp_us.max(axis=1) + setting.late / US)
    R = np.broadcast_to(np.repeat([setting.v_sigma, setting.a_sigma], 3) ** 2, (*shape, 6)).copy()
    return Messages(after, stamp_us.astype(np.int64), came, v, q, place, R, measured)


def standard(motion="ship", **changes) -> Flight:
    """The flight that conditions change: 30 runs of 40 s, 50 Hz and 5 Hz, delay 35 ms and prior 0 +- 50 ms."""
    if motion == "turntable":
        changes = {"lever_b": (3.0, 0.0, 0.0)} | changes
    return fly(Setting(motion=MOTIONS[motion]), **changes)
