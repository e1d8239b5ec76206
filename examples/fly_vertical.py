"""Simulate a climb, fly the vertical channel on it in many runs, and judge the filter.

python fly_vertical.py

The filter is the generated C of vertical.py; what it is judged by is simulated here.
"""

from pathlib import Path

import numpy as np

from boresight import CompiledFilter, Consistency, generate, load

MODEL = f"{Path(__file__).parent}/vertical.py:VERTICAL"
RUNS, SECONDS = 20, 60
DT = 0.02  # s, of the accelerometer
EVERY = 25  # samples to a reading of the barometer
GRAVITY = 9.81

NOISE = {"accel_noise": 2e-3, "bias_noise": 1e-4}
BARO = 1.5  # m, one sigma
START = np.array([10.0, 1.0, 0.2])  # m, m/s, m/s^2: one sigma of what is known at the start

SHOWN = {"height, m": 1.0, "speed, m/s": 1.0, "bias, m/s^2": 1.0}


def fly(library, runs=RUNS, seed=0):
    """All runs side by side; the Consistency of their errors and innovations."""
    rng = np.random.default_rng(seed)
    t = np.arange(0, SECONDS + DT / 2, DT)
    speed = 5 * np.sin(2 * np.pi * t / 30)
    height = 100 + np.concatenate([[0], np.cumsum((speed[1:] + speed[:-1]) / 2 * DT)])

    # The start, wrong by what START says: estimate = true + error.
    error = START * rng.standard_normal((runs, 3))
    bias = -error[:, 2]  # its estimate begins at zero
    nav = {"height": height[0] + error[:, 0], "speed": speed[0] + error[:, 1], "bias": np.zeros(runs)}
    loop = CompiledFilter(library, nav, P=np.diag(START**2))
    judged = Consistency(SHOWN)

    for k in range(1, len(t)):
        bias = bias + NOISE["bias_noise"] * np.sqrt(DT) * rng.standard_normal(runs)
        dv = speed[k] - speed[k - 1] + (GRAVITY + bias) * DT
        dv = dv + NOISE["accel_noise"] * np.sqrt(DT) * rng.standard_normal(runs)

        loop.strapdown(dv=dv, dt=DT)
        loop.predict(dt=DT, **NOISE)
        if k % EVERY == 0:
            baro = height[k] + BARO * rng.standard_normal(runs)
            judged.innovation(t[k], "altitude", loop.update("altitude", R=BARO**2, baro=baro))
            loop.feedback()
            carried = loop.nav
            error = [carried["height"] - height[k], carried["speed"] - speed[k], carried["bias"] - bias]
            judged.error(t[k], np.stack(error, axis=-1), loop.P)
    return judged


if __name__ == "__main__":
    judged = fly(load(generate(MODEL).folder))
    print(judged.report())
    print(judged.draw("vertical.png"))
