"""Simulate a body that tumbles in place, fly both attitude filters on it in many runs, and judge them.

python fly_ahrs.py

The filters are the generated C of ahrs.py; what they are judged by is simulated here.  The error of
an attitude is three numbers in both, so that NEES has six.
"""

from pathlib import Path

import numpy as np

from boresight import CompiledFilter, Consistency, generate, load, rotation

MODELS = {name: f"{Path(__file__).parent}/ahrs.py:{name}" for name in ("SEVEN", "SIX")}
RUNS, SECONDS = 200, 30
DT = 0.02  # s
GRAVITY, DIP = 9.81, 1.1

NOISE = {"gyro_noise": np.full(3, 2e-3), "bias_noise": np.full(3, 2e-4)}
ACCEL, MAG = 0.05, 0.01  # one sigma of a component: m/s^2, and of a field of length 1
START = np.array([0.03] * 3 + [0.005] * 3)  # rad, rad/s: one sigma of what is known at the start

DEGREE = np.degrees(1)
SHOWN = {**{f"attitude {axis}, deg": DEGREE for axis in ("north", "east", "down")},
         **{f"gyro bias {axis}, deg/s": DEGREE for axis in "xyz"}}  # fmt: skip


def truth():
    """Attitude at each step, and the mean rate of the body between them."""
    t = np.arange(0, SECONDS + DT / 2, DT)
    euler = np.stack([0.8 * np.sin(0.9 * t), 0.6 * np.sin(0.7 * t + 1), 0.5 * t], -1)
    q = rotation.quaternion_from_euler(euler)
    return t, q, rotation.body_increments(q, np.zeros(3), DT) / DT


def fly(library, runs=RUNS, seed=0):
    """All runs side by side; the Consistency of their errors and innovations."""
    rng = np.random.default_rng(seed)
    t, q, omega = truth()
    by_caller = "accelerometer_z" not in dir(library)  # whether z is given, or made from what the sensors read
    down, north = np.array([0, 0, 1.0]), np.array([np.cos(DIP), 0, np.sin(DIP)])

    error = START * rng.standard_normal((runs, 6))
    bias = -error[:, 3:]  # its estimate begins at zero
    nav = {"q": rotation.turned(q[0], -error[:, :3]), "gyro_bias": np.zeros((runs, 3))}
    loop = CompiledFilter(library, nav, P=np.diag(START**2))
    judged = Consistency(SHOWN)

    def noise(sigma):
        return sigma * rng.standard_normal((runs, 3))

    for k in range(1, len(t)):
        bias = bias + noise(NOISE["bias_noise"] * np.sqrt(DT))
        imu = {"gyro": omega[k - 1] + bias + noise(NOISE["gyro_noise"] / np.sqrt(DT)), "dt": DT}
        loop.predict(**imu, **NOISE)
        loop.strapdown(**imu)
        C_n2b = rotation.matrix_from_quaternion(q[k]).T
        seen = {"accelerometer": C_n2b @ (-GRAVITY * down) + noise(ACCEL), "magnetometer": C_n2b @ north + noise(MAG)}
        for name, sigma in (("accelerometer", ACCEL), ("magnetometer", MAG)):
            read = {"accel": seen["accelerometer"], "mag": seen["magnetometer"]}
            given = {"z": seen[name]} if by_caller else read
            judged.innovation(t[k], name, loop.update(name, R=np.full(3, sigma**2), dip=DIP, **given))
            loop.feedback()
        off = [rotation.attitude_error(loop.nav["q"], q[k]), loop.nav["gyro_bias"] - bias]
        judged.error(t[k], np.concatenate(off, axis=-1), loop.P)
    return judged


if __name__ == "__main__":
    for name, model in MODELS.items():
        judged = fly(load(generate(model).folder))
        print(judged.report())
        print(judged.draw(f"ahrs_{name.lower()}.png"))
