"""Flights whose noises are known, recorded: what a filter believed of them is a factor on each.

python tests/analysis/flights.py [RUNS] prints how many intervals of how many runs hold the truth.
"""

import sys

import numpy as np

from boresight import CompiledFilter, Record, load, rotation
from boresight.analysis.likelihood import SURE, Linearised, settled
from boresight.simulation import sensors

MATCHING = {"gyro_noise": np.radians(0.5) / 60, "R of euler_exact": np.radians(0.05)}
HOLD = {"gyro_noise": 5e-4, "accel_noise": 0.02, "R of zupt": 0.02}


def matching(runs, believed, seed=1, steps=120, dt=0.5):
    """Euler angles of a slave that swings with its master; believed: (2,) over MATCHING."""
    rng, still = np.random.default_rng(seed), np.zeros(3)
    walk, sigma = MATCHING.values()
    swing = sensors.Sinusoids(np.radians([4, 3, 4]), np.array([11.0, 7.0, 17.0]), still, still)
    euler = swing.euler(dt * np.arange(steps + 1))
    q_m = rotation.quaternion_from_euler(euler)
    mu = np.radians(1) * rng.standard_normal((runs, 3))
    start = rotation.turned(q_m[0], sigma * rng.standard_normal((runs, 3)))
    P = np.eye(6) * np.radians(1) ** 2
    loop = CompiledFilter(load("euler-matching"), {"q_b2n_wxyz": start, "mu": np.zeros((runs, 3))}, P=P)
    record = Record(loop)
    for k, turn in enumerate(rotation.body_increments(q_m, still, dt), 1):
        white = walk * np.sqrt(dt) * rng.standard_normal((runs, 3))
        loop.strapdown(dtheta_ib_b=sensors.mounted(turn, mu) + white, omega_in_n=still, dt=dt)
        loop.predict(omega_in_n=still, gyro_noise=np.full(3, walk * believed[0]), dt=dt)
        angles = {"euler_b": loop.call("euler_angles"), "euler_m": euler[k] + sigma * rng.standard_normal((runs, 3))}
        loop.update("euler_exact", R=np.full(3, (sigma * believed[1]) ** 2), iterations=3, **angles)
        loop.feedback()
    return record


def hold(runs, believed, seed=2, steps=200, dt=0.2):
    """A unit that stands still, with zero-velocity updates; believed: (3,) over HOLD."""
    rng, model = np.random.default_rng(seed), load("azimuth-hold")
    gyro, accel, sigma = HOLD.values()
    place = np.array([0.2, 0.8, 100.0])
    earth = load("strapdown").earth(lon_lat_height=place, v_n=np.zeros(3))
    f, w = -earth["gravity_n"], earth["omega_ie_n"]  # RFU in ENU
    sigmas = np.concatenate([np.full(3, 1e-9), np.full(3, 1e-2), np.full(3, 5e-3), np.full(3, 1e-5), np.full(3, 5e-3)])
    off = sigmas * rng.standard_normal((runs, 15))
    nav = {
        "lon_lat_height": np.tile(place, (runs, 1)), "v_n": off[:, 3:6],
        "q_b2n_wxyz": rotation.turned(np.array([1.0, 0, 0, 0]), off[:, 6:9]),
        "gyro_bias": np.zeros((runs, 3)), "accel_bias": np.zeros((runs, 3)),
    }  # fmt: skip
    loop = CompiledFilter(model, nav, P=np.diag(sigmas**2))
    record = Record(loop)
    noises = {"gyro_noise": np.full(3, gyro * believed[0]), "accel_noise": np.full(3, accel * believed[1]),
              "gyro_bias_noise": np.zeros(3), "accel_bias_noise": np.zeros(3)}  # fmt: skip
    for _ in range(steps):
        dtheta = (w + off[:, 9:12]) * dt + gyro * np.sqrt(dt) * rng.standard_normal((runs, 3))
        dv = (f + off[:, 12:]) * dt + accel * np.sqrt(dt) * rng.standard_normal((runs, 3))
        mean = dv / dt - loop.nav["accel_bias"]
        loop.strapdown(dtheta_ib_b=dtheta, dv_b=dv, dtheta_before=dtheta, dv_before=dv, dt=dt)
        loop.predict(f_b=mean, dt=dt, **noises)
        zero = sigma * rng.standard_normal((runs, 3))  # zero velocity is measured with this error
        loop.nav["v_n"] = loop.nav["v_n"] + zero
        loop.update("zupt", R=np.full(3, (sigma * believed[2]) ** 2))
        loop.feedback()
        loop.nav["v_n"] = loop.nav["v_n"] - zero
    return record


def held(record, believed):
    """(runs, noises) bool: whether the interval of each run holds the truth; and (runs, noises) off over sigma."""
    logs, information, _, _ = settled(Linearised(record), each_run=True)
    sigma = np.sqrt(np.diagonal(np.linalg.inv(information), axis1=-2, axis2=-1))
    off = (logs + np.log(believed)) / sigma
    return np.abs(off) < SURE, off


if __name__ == "__main__":
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    for fly, believed in ((matching, (1.5, 0.7)), (hold, (0.7, 1.4, 1.5))):
        record = fly(runs, believed)
        inside, off = held(record, believed)
        for name, hit, mean, spread in zip(
            Linearised(record).names, inside.sum(0), off.mean(0), off.std(0), strict=True
        ):
            print(f"{fly.__name__}: {name}: {hit} of {runs}; off by {mean:+.2f} +- {spread:.2f} sigmas")
