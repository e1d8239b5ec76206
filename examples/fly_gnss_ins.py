"""Simulate a drive, fly GNSS/INS on it in many runs, and judge the filter.

python fly_gnss_ins.py

The filter is the generated C of gnss_ins.py; what it is judged by is simulated here.
"""

from pathlib import Path

import numpy as np

from boresight import CompiledFilter, Consistency, generate, load, rotation
from boresight.simulation import inertial

MODEL = f"{Path(__file__).parent}/gnss_ins.py:GNSS_INS"
RUNS, SECONDS = 20, 120
DT = 0.02  # s, of the sensors
EVERY = 5  # samples to a propagation of the covariance

LAT, LON, HEIGHT = 0.84, 0.15, 500.0
GROUND = np.array([6.37e6, 6.39e6 * np.cos(LAT), 1.0])  # m per unit of latitude, longitude and height, nearly
LEVER = np.array([0.4, -0.3, -1.2])  # m: the antenna stands on the roof
LATE = 6  # samples, 0.12 s

# One sigma: noise densities of the sensors, of a fix, and of what is known at the start.
NOISE = {
    "gyro_noise": np.full(3, np.radians(0.2) / 60),  # 0.2 deg/sqrt(h)
    "accel_noise": np.full(3, 1e-3),  # 100 ug/sqrt(Hz)
    "gyro_bias_noise": np.full(3, 1e-7),
    "accel_bias_noise": np.full(3, 1e-5),
}
FIX_M, FIX_M_S = 1.0, 0.05
START = np.concatenate([5.0 / GROUND[:2], [5.0], [0.2] * 3, np.radians([0.5, 0.5, 2]), [2e-4] * 3, [0.03] * 3])

DEGREE = np.degrees(1)
SHOWN = {
    **dict(zip(("north, m", "east, m", "height, m"), GROUND, strict=True)),
    **{f"velocity {axis}, m/s": 1.0 for axis in ("north", "east", "down")},
    **{f"attitude {axis}, deg": DEGREE for axis in ("north", "east", "down")},
    **{f"gyro bias {axis}, deg/h": 3600 * DEGREE for axis in "xyz"},
    **{f"accel bias {axis}, mm/s^2": 1e3 for axis in "xyz"},
}


def drive(library):
    """What ideal sensors deliver on a winding road: dtheta, dv of each sample, and the Trajectory."""
    t = np.arange(0, SECONDS + DT / 2, DT)
    heading = 0.9 * np.sin(2 * np.pi * t / 40)
    speed = 15 + 5 * np.sin(2 * np.pi * t / 23)
    v_n = np.stack([speed * np.cos(heading), speed * np.sin(heading), 0.5 * np.sin(2 * np.pi * t / 31)], -1)
    roll, pitch = 0.05 * np.sin(2 * np.pi * t / 7), 0.04 * np.sin(2 * np.pi * t / 11)
    q_b2n_wxyz = rotation.quaternion_from_euler(np.stack([roll, pitch, heading], -1))
    return inertial.increments(library.strapdown, [LAT, LON, HEIGHT], v_n, q_b2n_wxyz, DT)


def antenna(truth, dtheta):
    """Position and velocity of the antenna at each sample but the first."""
    C_b2n = rotation.matrix_from_quaternion(truth.q_b2n_wxyz[1:])
    position = truth.position[1:] + C_b2n @ LEVER / GROUND * [1, 1, -1]
    velocity = truth.v_n[1:] + np.einsum("kij,kj->ki", C_b2n, np.cross(dtheta / DT, LEVER))
    return position, velocity


def fly(library, runs=RUNS, seed=0):
    """All runs side by side; the Consistency of their errors and innovations."""
    rng = np.random.default_rng(seed)
    dtheta, dv, truth = drive(library)
    p_antenna, v_antenna = antenna(truth, dtheta)

    # The start, wrong by what START says: estimate = true + error.
    error = START * rng.standard_normal((runs, 15))
    gyro_bias, accel_bias = -error[:, 9:12], -error[:, 12:]  # the estimates begin at zero
    nav = {
        "lat_lon_height": truth.position[0] + error[:, :3],
        "v_n": truth.v_n[0] + error[:, 3:6],
        "q_b2n_wxyz": rotation.turned(truth.q_b2n_wxyz[0], -error[:, 6:9]),
        "gyro_bias": np.zeros((runs, 3)),
        "accel_bias": np.zeros((runs, 3)),
    }
    loop = CompiledFilter(library, nav, P=np.diag(START**2))
    judged = Consistency(SHOWN)

    def white(density):
        return density * np.sqrt(DT) * rng.standard_normal((runs, 3))

    before = None
    summed = np.zeros((2, runs, 3))
    for k in range(len(dtheta)):
        # the sensors
        gyro_bias = gyro_bias + white(NOISE["gyro_bias_noise"])
        accel_bias = accel_bias + white(NOISE["accel_bias_noise"])
        gyro = dtheta[k] + gyro_bias * DT + white(NOISE["gyro_noise"])
        accel = dv[k] + accel_bias * DT + white(NOISE["accel_noise"])

        # the navigation, at each sample
        earlier = before or (gyro, accel)
        loop.strapdown(dtheta_ib_b=gyro, dv_b=accel, dtheta_before=earlier[0], dv_before=earlier[1], dt=DT)
        before = gyro, accel
        summed += before
        if (k + 1) % EVERY:
            continue

        # the covariance, with the means since
        omega, f = summed / (EVERY * DT)
        imu = {"omega_ib_b": omega - loop.nav["gyro_bias"], "f_b": f - loop.nav["accel_bias"]}
        loop.predict(**imu, **NOISE, dt=EVERY * DT)
        summed[:] = 0

        # a fix every second, of LATE samples ago
        if (k + 1) * DT % 1 < DT / 2:
            then = k - LATE
            fix = {
                "p_fix": p_antenna[then] + FIX_M / GROUND * rng.standard_normal((runs, 3)),
                "v_fix_n": v_antenna[then] + FIX_M_S * rng.standard_normal((runs, 3)),
                "lever_b": LEVER,
                "lag": LATE * DT,
            }
            for name, sigma in (("position", FIX_M), ("velocity", FIX_M_S)):
                found = loop.update(name, R=np.full(3, sigma**2), **imu, **fix)
                judged.innovation((k + 1) * DT, name, found)
            loop.feedback()

            error = np.concatenate([
                loop.nav["lat_lon_height"] - truth.position[k + 1],
                loop.nav["v_n"] - truth.v_n[k + 1],
                rotation.attitude_error(loop.nav["q_b2n_wxyz"], truth.q_b2n_wxyz[k + 1]),
                loop.nav["gyro_bias"] - gyro_bias,
                loop.nav["accel_bias"] - accel_bias,
            ], axis=-1)  # fmt: skip
            judged.error((k + 1) * DT, error, loop.P)
    return judged


if __name__ == "__main__":
    judged = fly(load(generate(MODEL).folder))
    print(judged.report())
    print(judged.draw("gnss_ins.png"))
