"""Simulate a drive, fly the 21 errors of GNSS/INS on it in many runs, and judge the filter.

python fly_gnss_ins_21.py

The filter is the generated C of gnss_ins_21.py; what it is judged by is simulated here.
"""

from pathlib import Path

import numpy as np

from boresight import CompiledFilter, Consistency, generate, load, rotation
from boresight.simulation import inertial

MODEL = f"{Path(__file__).parent}/gnss_ins_21.py:GNSS_INS_21"
RUNS, SECONDS = 20, 120
DT = 0.02  # s, of the sensors
EVERY = 5  # samples to a propagation of the covariance

LAT, LON, HEIGHT = 0.84, 0.15, 500.0
GROUND = np.array([6.37e6, 6.39e6 * np.cos(LAT), 1.0])  # m per unit of latitude, longitude and height, nearly
LEVER = np.array([0.4, -0.3, -1.2])  # m: the antenna stands on the roof

# One sigma of each error of the sensors, and how long it lasts: Gauss-Markov of the first order.
FADING = 3600.0  # s
SENSORS = {"gyro_bias": 2e-4, "accel_bias": 0.03, "gyro_scale": 2e-3, "accel_scale": 2e-3}
NOISE = {
    "gyro_noise": np.full(3, np.radians(0.2) / 60),  # 0.2 deg/sqrt(h)
    "accel_noise": np.full(3, 1e-3),  # 100 ug/sqrt(Hz)
    **{f"{name}_noise": np.full(3, sigma * np.sqrt(2 / FADING)) for name, sigma in SENSORS.items()},
}
FIX_M, FIX_M_S = 1.0, 0.05
START = np.concatenate([[5.0] * 3, [0.2] * 3, np.radians([0.5, 0.5, 1]), np.repeat(list(SENSORS.values()), 3)])

DEGREE = np.degrees(1)
SHOWN = {
    **{f"{axis}, m": 1.0 for axis in ("north", "east", "height")},
    **{f"velocity {axis}, m/s": 1.0 for axis in ("north", "east", "down")},
    **{f"attitude {axis}, deg": DEGREE for axis in ("north", "east", "down")},
    **{f"gyro bias {axis}, deg/h": 3600 * DEGREE for axis in "xyz"},
    **{f"accel bias {axis}, mm/s^2": 1e3 for axis in "xyz"},
    **{f"{name} scale {axis}, ppm": 1e6 for name in ("gyro", "accel") for axis in "xyz"},
}


def drive(library):
    """What ideal sensors deliver on a winding road: dtheta, dv of each sample, and the Trajectory."""
    t = np.arange(0, SECONDS + DT / 2, DT)
    heading = 2.0 * np.sin(2 * np.pi * t / 40)
    speed = 15 + 5 * np.sin(2 * np.pi * t / 23)
    v_n = np.stack([speed * np.cos(heading), speed * np.sin(heading), 0.5 * np.sin(2 * np.pi * t / 31)], -1)
    roll, pitch = 0.05 * np.sin(2 * np.pi * t / 7), 0.04 * np.sin(2 * np.pi * t / 11)
    q_b2n_wxyz = rotation.quaternion_from_euler(np.stack([roll, pitch, heading], -1))
    return inertial.increments(library.strapdown, [LAT, LON, HEIGHT], v_n, q_b2n_wxyz, DT)


def fly(library, runs=RUNS, seed=0):
    """All runs side by side; the Consistency of their errors and innovations."""
    rng = np.random.default_rng(seed)
    dtheta, dv, truth = drive(library)
    C_b2n = rotation.matrix_from_quaternion(truth.q_b2n_wxyz[1:])
    p_antenna = truth.position[1:] + C_b2n @ LEVER / GROUND * [1, 1, -1]
    v_antenna = truth.v_n[1:] + np.einsum("kij,kj->ki", C_b2n, np.cross(dtheta / DT, LEVER))

    # The start, wrong by what START says: estimate = true + error, and the sensors are taken for perfect.
    error = START * rng.standard_normal((runs, 21))
    sensors = dict(zip(SENSORS, np.split(-error[:, 9:], 4, axis=-1), strict=True))
    nav = {
        "lat_lon_height": truth.position[0] + error[:, :3] / GROUND,
        "v_n": truth.v_n[0] + error[:, 3:6],
        "q_b2n_wxyz": rotation.turned(truth.q_b2n_wxyz[0], -error[:, 6:9]),
        **dict.fromkeys(SENSORS, np.zeros((runs, 3))),
    }
    loop = CompiledFilter(library, nav, P=np.diag(START**2))
    judged = Consistency(SHOWN)

    def white(name):
        return NOISE[f"{name}_noise"] * np.sqrt(DT) * rng.standard_normal((runs, 3))

    before = None
    summed = np.zeros((2, runs, 3))
    for k in range(len(dtheta)):
        # the sensors
        gyro = (1 + sensors["gyro_scale"]) * dtheta[k] + sensors["gyro_bias"] * DT + white("gyro")
        accel = (1 + sensors["accel_scale"]) * dv[k] + sensors["accel_bias"] * DT + white("accel")
        sensors = {name: value * (1 - DT / FADING) + white(name) for name, value in sensors.items()}

        # the navigation, at each sample
        earlier = before or (gyro, accel)
        loop.strapdown(
            dtheta_ib_b=gyro, dv_b=accel, dtheta_before=earlier[0], dv_before=earlier[1], dt=DT, correlation_time=FADING
        )
        before = gyro, accel
        summed += before
        if (k + 1) % EVERY:
            continue

        # the covariance, with the means since
        omega, f = summed / (EVERY * DT)
        imu = {
            "omega_ib_b": (omega - loop.nav["gyro_bias"]) / (1 + loop.nav["gyro_scale"]),
            "f_b": (f - loop.nav["accel_bias"]) / (1 + loop.nav["accel_scale"]),
        }
        loop.predict(**imu, **NOISE, correlation_time=FADING, dt=EVERY * DT)
        summed[:] = 0

        # a fix every second
        if (k + 1) * DT % 1 < DT / 2:
            fix = {
                "p_fix": p_antenna[k] + FIX_M / GROUND * rng.standard_normal((runs, 3)),
                "v_fix_n": v_antenna[k] + FIX_M_S * rng.standard_normal((runs, 3)),
                "lever_b": LEVER,
            }
            for name, sigma in (("position", FIX_M), ("velocity", FIX_M_S)):
                found = loop.update(name, R=np.full(3, sigma**2), **imu, **fix)
                judged.innovation((k + 1) * DT, name, found)
            loop.feedback()

            error = np.concatenate([
                (loop.nav["lat_lon_height"] - truth.position[k + 1]) * GROUND,
                loop.nav["v_n"] - truth.v_n[k + 1],
                rotation.attitude_error(loop.nav["q_b2n_wxyz"], truth.q_b2n_wxyz[k + 1]),
                *(loop.nav[name] - true for name, true in sensors.items()),
            ], axis=-1)  # fmt: skip
            judged.error((k + 1) * DT, error, loop.P)
    return judged


if __name__ == "__main__":
    judged = fly(load(generate(MODEL).folder))
    print(judged.report())
    print(judged.draw("gnss_ins_21.png"))
