"""The recording that comes with Boresight, made by `motion`: what it holds is known.

`python -m boresight.evidence.flights.sample` writes it anew.
"""

from typing import Any

import numpy as np

from boresight.evidence.flights.motion import swinging, turn
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.recording.read import EXAMPLE
from boresight.runtime.units import DEG, HOUR, MILLI_G

SECONDS, IMU_HZ, MASTER_HZ = 60.0, 100, 10
DELAY_S = 0.042
MU = np.array([0.3, -0.5, 1.2]) * DEG
LEVER_B = np.array([0.8, -0.4, -1.1])
BIAS_G, BIAS_A = np.array([120.0, -60.0, 90.0]) * DEG / HOUR, np.array([4.0, -6.0, 3.0]) * MILLI_G
GYRO_NOISE, ACCEL_NOISE = 0.15 * DEG / HOUR**0.5, 0.06 / HOUR**0.5  # rad/sqrt(s), m/s/sqrt(s)
VELOCITY_NOISE, ATTITUDE_NOISE = 0.01, 1.0 / 60 * DEG


def sample(seed: int = 20) -> dict[str, Array]:
    """The arrays of the file: increments of the slave with the time of their end, what its master says, the truth."""
    rng = np.random.default_rng(seed)
    motion, dt = swinging(seconds=SECONDS), 1 / IMU_HZ
    edges = np.arange(round(SECONDS * IMU_HZ) + 1) * dt
    dtheta, dv = motion.increments(edges)
    dtheta = dtheta + BIAS_G * dt + GYRO_NOISE * np.sqrt(dt) * rng.standard_normal(dtheta.shape)
    dv = dv + BIAS_A * dt + ACCEL_NOISE * np.sqrt(dt) * rng.standard_normal(dv.shape)
    stamps = np.arange(2, round(SECONDS * MASTER_HZ)) / MASTER_HZ
    stamps = stamps[rng.random(len(stamps)) > 0.05]  # one in twenty is lost
    v, C = motion.master(stamps - DELAY_S, LEVER_B, turn(MU))
    C = turn(ATTITUDE_NOISE * rng.standard_normal(v.shape)) @ C
    return {
        "imu_time": edges[1:],
        "dtheta": dtheta.astype(np.float32),
        "dvel": dv.astype(np.float32),
        "ins_time": stamps,
        "roll_pitch_yaw": rotation.euler_from_matrix(C) / DEG,
        "velocity_ned": v + VELOCITY_NOISE * rng.standard_normal(v.shape),
        "lat_lon_height": motion.position(stamps - DELAY_S) / [DEG, DEG, 1.0],
        "true_gyro_bias": BIAS_G,
        "true_accel_bias": BIAS_A,
        "true_misalignment": MU,
        "true_lever_arm": LEVER_B,
    }


if __name__ == "__main__":
    arrays: dict[str, Any] = sample()
    np.savez_compressed(EXAMPLE, **arrays)
    print(f"{EXAMPLE.name}: {EXAMPLE.stat().st_size} bytes")
