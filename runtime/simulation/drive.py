"""A recording whose truth is known: a drive, as a slave and its master would have written it."""

from pathlib import Path

import numpy as np

from boresight.runtime import frames, rotation
from boresight.runtime.array import Array
from boresight.runtime.simulation import sensors
from boresight.runtime.units import ARCMIN, DEG


def simulate(path: str | Path, seed: int, *, duration: float = 60.0, delay: float = 0.0) -> Path:
    """Write a recording like the real one: PATH.npz in RFU and ENU with degrees and increments, PATH.toml says so.

    The motion is a drive at constant velocity, small angles first, then roll to 30 deg.  Truth stands under [reference]
    in the file.  The slave samples at 100 Hz with white noise and a constant bias, the master at 10 Hz with white angle
    noise and, if delay is not zero, old by it.  Returns the path of the description.
    """
    rng = np.random.default_rng(seed)
    base = Path(path).with_suffix("")
    dt, steps, lat, height = 0.01, round(duration / 0.01), np.radians(34.4), 170.0
    v_n = np.array([12.0, -0.7, 0.0])
    bias = np.radians(rng.normal(0, 200, 3)) / 3600
    mu = rng.normal(0, 8, 3) * ARCMIN
    gyro_noise, angle_noise = 0.2 * (DEG / 60), 0.2 * ARCMIN

    def euler_at(t: Array) -> Array:
        swell = 1 / (1 + np.exp(-(t - duration / 3)))
        roll = np.radians(2 * np.sin(0.5 * t) + 28 * swell * np.sin(0.4 * t))
        pitch = np.radians(-1.5 + 2.0 * np.sin(0.11 * t + 1))
        return np.stack([roll, pitch, np.radians(-1 + 1.5 * np.sin(0.17 * t + 2))], axis=-1)

    radius = 6371e3  # enough for a transport rate that is the same on both sides of the simulation
    omega = sensors.earth_rate_n(lat) + np.array([v_n[1], -v_n[0], 0]) / radius
    t = np.arange(steps + 1) * dt
    C_m = rotation.matrix_from_euler(euler_at(t))
    C_b = C_m @ rotation.matrix_from_vector(mu)
    turn = np.swapaxes(C_b[:-1], -1, -2) @ rotation.matrix_from_vector(omega * dt) @ C_b[1:]
    dtheta = rotation.vector_from_matrix(turn) + bias * dt + gyro_noise * np.sqrt(dt) * rng.standard_normal((steps, 3))
    force = np.einsum("kji,j->ki", C_b, np.array([0, 0, -9.797]))
    dvel = (force[1:] + force[:-1]) / 2 * dt
    every = np.arange(10, steps + 1, 10)
    euler = euler_at(t[every] - delay) + angle_noise * rng.standard_normal((len(every), 3))
    position = np.column_stack([lat + v_n[0] / radius * t[every], 1.9 + 0 * t[every], height + 0 * t[every]])

    to_rfu = frames.body_to_frd("RFU").T
    np.savez(
        base.with_suffix(".npz"),
        t_imu=t[1:],
        dtheta=np.degrees(dtheta @ to_rfu.T),
        dvel=dvel @ to_rfu.T,
        t_ins=t[every],
        attitude=np.degrees(frames.angles_from_euler(euler, ("pitch", "roll", "yaw"), "counter-clockwise")),
        velocity=np.tile(frames.navigation_to_ned("ENU").T @ v_n, (len(every), 1)),
        position=np.column_stack([np.degrees(position[:, :2]), position[:, 2]]),
        true_gyro_bias=np.degrees(to_rfu @ bias) * 3600,
        true_misalignment=to_rfu @ mu / ARCMIN,
    )
    toml = base.with_suffix(".toml")
    toml.write_text(SIMULATED.format(file=base.with_suffix(".npz").name, seed=seed), encoding="utf-8")
    return toml


SIMULATED = """title = "simulated master and slave, seed {seed}"
file = "{file}"

[imu]
kind = "increments"
time_marks = "end"
body = "RFU"
time = {{ columns = "t_imu", unit = "s" }}
gyro = {{ columns = "dtheta", unit = "deg" }}
accel = {{ columns = "dvel", unit = "m/s" }}

[master]
body = "RFU"
navigation = "ENU"
time = {{ columns = "t_ins", unit = "s" }}
attitude = {{ columns = "attitude", unit = "deg", order = "pitch roll yaw", yaw_positive = "counter-clockwise" }}
velocity = {{ columns = "velocity", unit = "m/s" }}
position = {{ columns = "position", unit = "deg" }}

[reference]
gyro_bias = {{ columns = "true_gyro_bias", unit = "deg/h" }}
misalignment = {{ columns = "true_misalignment", unit = "arcmin" }}
"""
