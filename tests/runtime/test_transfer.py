"""The transfer-alignment loop on a ship whose motion is analytic: truth, both ways with a delay, and NEES."""

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest

from boresight.runtime import hull, inertial, rotation
from boresight.runtime.library import load
from boresight.runtime.simulation import generator
from boresight.runtime.transfer import Message, Transfer, Verdict, first

DEG, MIL = np.pi / 180, 2 * np.pi / 6400
RATE_HZ = 400
PLACE = np.array([0.6, 2.2, 20.0])
LEVER_B = np.array([-4.0, 2.0, 3.0])
MOUNTING = rotation.quaternion_from_euler(np.array([0.4, -0.3, 2.0]) * DEG)
V_SIGMA, A_SIGMA = 0.01, 0.3e-3  # m/s, rad of the master
NOISE = {"gyro_noise": np.full(3, 3e-5), "accel_noise": np.full(3, 1e-3), "gyro_bias_noise": np.full(3, 1e-8),
         "accel_bias_noise": np.full(3, 1e-7), "mu_noise": np.full(3, 1e-8), "tau_noise": 1e-7}  # fmt: skip
R = np.repeat([V_SIGMA, A_SIGMA], 3) ** 2
BIAS_G, BIAS_A = 5e-5, 0.01  # rad/s, m/s^2, one sigma


def sea():
    """A sea of 0.1 to 0.17 Hz: roll 6, pitch 3, yaw 3 deg, heave 1 m, and some way over the ground."""
    return hull.sinusoids(
        amplitude=[0.5, 0.6, 1.0, 6 * DEG, 3 * DEG, 3 * DEG], phase=[0.0, 1.0, 2.0, 0.3, 1.2, 2.1], frequency_hz=0.15,
        heading=0.5, speed=4.0,
    )  # fmt: skip


@dataclass(frozen=True)
class Ship:
    """Truth of one motion: the slave's increments without error, and its trajectory."""

    motion: hull.Motion
    model: object
    dtheta: np.ndarray  # (T, 3)
    dv: np.ndarray
    track: inertial.Trajectory

    def master(self, time):
        """(R,) s -> v_n (R, 3), q_m2n_wxyz (R, 4)."""
        pose = hull.ride(self.motion, np.asarray(time))
        return pose.v_n, pose.q_b2n_wxyz


def sail(motion, seconds, rate_hz=RATE_HZ, lever_b=LEVER_B):
    model = load("velocity-attitude")
    time = np.arange(round(seconds * rate_hz) + 1) / rate_hz
    slave = hull.carried(hull.ride(motion, time), lever_b, MOUNTING)
    none = {"gyro_bias": np.zeros(3), "accel_bias": np.zeros(3)}
    library = SimpleNamespace(step=lambda **fields: model.strapdown(**fields, **none))
    dtheta, dv, track = inertial.increments(library, PLACE, slave.v_n[:, None], slave.q_b2n_wxyz[:, None], 1 / rate_hz)
    return Ship(motion, model, dtheta[:, 0], dv[:, 0], track)


@pytest.fixture(scope="module")
def ship(compiled_once):
    return sail(sea(), 60.0)


@dataclass
class Flight:
    loop: Transfer
    errors: np.ndarray  # (K, runs, 16) after each message, estimated - true
    sigmas: np.ndarray
    nees: np.ndarray  # (K, runs)
    nis: np.ndarray  # (K, runs), of messages taken; nan otherwise
    verdicts: np.ndarray
    times: np.ndarray


def fly(ship, *, runs=20, seed=0, seconds=None, way="buffer", delay=None, known_age=0.0, jitter=0.003, drop=0.1,
        change=None, slave_change=None, lever_b=LEVER_B, tau_sigma=0.01, master_hz=10, gyro=None, **more):  # fmt: skip
    """Sensor errors, delays, jitter and drop-outs run by run.

    A message measured at s is stamped s + tau, and handed over known_age later, at the slave's next sample.
    change(k, message, truth) may spoil the k-th message, slave_change(time, dtheta, dv) an interval.
    """
    streams = [generator(seed, run) for run in range(runs)]

    def normals(*shape):
        return np.array([stream.standard_normal(shape) for stream in streams])

    dt = ship.track.dt
    bias_g, bias_a = BIAS_G * normals(3), BIAS_A * normals(3)
    tau = np.abs(tau_sigma * normals()) if delay is None else np.broadcast_to(delay, (runs,))
    q_m2n = ship.master(np.zeros(1))[1][0]
    start = Message(
        0.0, R, v_m_n=ship.track.v_n[0, 0] + 0.02 * normals(3),
        q_m2n_wxyz=rotation.turned(np.tile(q_m2n, (runs, 1)), A_SIGMA * normals(3)), position=PLACE,
    )  # fmt: skip
    # two degrees of heading are believed to be none
    q_believed = rotation.turned(MOUNTING, -2 * DEG * normals(3) * [0.3, 0.3, 1])
    nav, P = first(
        start, q_b2m_wxyz=q_believed, mounting_sigma=2 * DEG * np.array([0.3, 0.3, 1]), velocity_sigma=np.full(3, 0.02),
        gyro_bias_sigma=np.full(3, BIAS_G), accel_bias_sigma=np.full(3, BIAS_A), tau_sigma=tau_sigma,
    )  # fmt: skip
    loop = Transfer(ship.model, nav, P, {"lever_b": lever_b, **NOISE}, way=way, every=4, **more)

    steps = len(ship.dtheta) if seconds is None else round(seconds / dt)
    stamps = 1 / master_hz * np.arange(1, int(steps * dt * master_hz)) + jitter * np.abs(normals(10000)[:, None, 0])
    errors, sigmas, nees, nis, verdicts, times = [], [], [], [], [], []
    noise_g, noise_a = NOISE["gyro_noise"] * np.sqrt(dt), NOISE["accel_noise"] * np.sqrt(dt)
    k = 0
    for step in range(steps):
        if step % 1000 == 0:
            noise = normals(1000, 6)
        white = noise[:, step % 1000]
        dtheta = ship.dtheta[step] + bias_g * dt + noise_g * white[:, :3]
        dv = ship.dv[step] + bias_a * dt + noise_a * white[:, 3:]
        time = (step + 1) * dt
        if slave_change is not None:
            dtheta, dv = slave_change(time, dtheta, dv)
        loop.slave(time, dtheta, dv, dt)
        if k < stamps.shape[1] and time >= (k + 1) / master_hz + known_age + 0.02:
            at = stamps[:, k]
            v, q = ship.master(at - tau)
            v = v + V_SIGMA * normals(3)
            q = rotation.turned(q, A_SIGMA * normals(3))
            rows = np.array([stream.random() for stream in streams]) >= drop
            position = ship.track.position[step, 0]
            message = Message(at, R, v_m_n=v, q_m2n_wxyz=q, position=position, rows=np.repeat(rows[:, None], 6, 1))
            if change is not None:
                message = change(k, message)
            k += 1
            if message is None:
                continue
            result = loop.master(message)
            e = error(loop, ship, step + 1, bias_g, bias_a, tau)
            errors.append(e)
            sigmas.append(np.sqrt(np.einsum("rii->ri", loop.P)))
            nees.append(np.einsum("ri,ri->r", e, np.linalg.solve(loop.P, e[..., None])[..., 0]))
            nis.append(np.where(result.taken, result.nis, np.nan))
            verdicts.append(result.verdict)
            times.append(time)
    return Flight(loop, *(np.array(part) for part in (errors, sigmas, nees, nis, verdicts, times)))


def error(loop, ship, sample, bias_g, bias_a, tau):
    nav, track = loop.nav, ship.track
    return np.concatenate([
        rotation.attitude_error(nav["q_b2n_wxyz"], track.q_b2n_wxyz[sample]), nav["v_n"] - track.v_n[sample],
        nav["gyro_bias"] - bias_g, nav["accel_bias"] - bias_a,
        rotation.attitude_error(nav["q_b2m_wxyz"], MOUNTING), (nav["tau"] - tau)[:, None],
    ], axis=-1)  # fmt: skip


@pytest.fixture(scope="module")
def flights(ship):
    """Both ways, messages that arrive 20 to 30 ms after their stamp: jitter, one in ten lost, and the delay."""
    return {way: fly(ship, way=way) for way in ("buffer", "extrapolate")}


@pytest.mark.parametrize("way", ["buffer", "extrapolate"])
def test_errors_are_as_large_as_the_filter_says(flights, way):
    from scipy.stats import chi2

    flight = flights[way]
    runs = flight.nees.shape[1]
    assert set(np.unique(flight.verdicts)) == {Verdict.TAKEN, Verdict.ABSENT}
    assert not flight.loop.notes
    # NEES of 20 independent runs at one instant; NIS of all messages together, 6 rows each
    low, high = chi2.ppf([1e-4, 1 - 1e-4], 16 * runs) / runs
    assert (low < flight.nees[::100].mean(axis=1)).all() and (flight.nees[::100].mean(axis=1) < high).all()
    count = np.isfinite(flight.nis).sum()
    low, high = chi2.ppf([1e-4, 1 - 1e-4], 6 * count) / count
    assert low < np.nanmean(flight.nis) < high
    assert np.sqrt(np.mean(flight.errors[-1, :, 14] ** 2)) < 0.5 * MIL
    assert np.sqrt(np.mean(flight.errors[-1, :, 15] ** 2)) < 0.6e-3
