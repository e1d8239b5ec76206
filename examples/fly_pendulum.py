"""Let a pendulum go over the top, fly the filter on what its encoder reads, in many runs, and judge it.

python fly_pendulum.py

The filter is the generated C of pendulum.py; what it is judged by is simulated here, with shorter steps.
"""

from pathlib import Path

import numpy as np

from boresight import CompiledFilter, Consistency, generate, load, rotation

MODEL = f"{Path(__file__).parent}/pendulum.py:PENDULUM"
RUNS, SECONDS = 50, 10
DT = 0.02  # s, of the filter's steps
FINE = 10  # steps of the simulation to one of the filter
EVERY = 5  # filter's steps to a reading of the encoder

LENGTH, DAMPING = 1.0, 0.2  # m, 1/s
JITTER = 0.05  # rad/s/sqrt(s): noise density of the angular acceleration
ENCODER = 0.02  # rad, one sigma
BEGIN, START = np.array([2.0, 6.0]), np.array([0.1, 0.3])  # rad, rad/s: where it is let go, and one sigma

SHOWN = {"angle, deg": np.degrees(1), "rate, deg/s": np.degrees(1)}


def rate_of(x):
    """The equation of the pendulum, once more: d[angle, rate]/dt, (runs, 2)."""
    angle, rate = x.T
    return np.stack([rate, -9.81 / LENGTH * np.sin(angle) - DAMPING * rate], axis=-1)


def next_state(x, dt, rng):
    """The truth one step of the filter later: midpoint rule in short steps, each with its share of the noise."""
    h = dt / FINE
    for _ in range(FINE):
        x = x + h * rate_of(x + h / 2 * rate_of(x))
        x[:, 1] += JITTER * np.sqrt(h) * rng.standard_normal(len(x))
    return x


def fly(library, runs=RUNS, seed=0):
    """All runs side by side; the Consistency of their errors and innovations."""
    rng = np.random.default_rng(seed)
    truth = BEGIN + START * rng.standard_normal((runs, 2))
    loop = CompiledFilter(library, {}, P=np.diag(START**2), x=np.tile(BEGIN, (runs, 1)))
    judged = Consistency(SHOWN)

    for k in range(1, round(SECONDS / DT) + 1):
        truth = next_state(truth, DT, rng)
        loop.predict(rod=[LENGTH, DAMPING], dt=DT, torque=JITTER)
        if k % EVERY == 0:
            z = rotation.wrapped(truth[:, :1] + ENCODER * rng.standard_normal((runs, 1)))
            judged.innovation(k * DT, "encoder", loop.update("encoder", R=ENCODER**2, z=z))
            error = loop.x - truth
            error[:, 0] = rotation.wrapped(error[:, 0])
            judged.error(k * DT, error, loop.P)
    return judged


if __name__ == "__main__":
    judged = fly(load(generate(MODEL).folder))
    print(judged.report())
    print(judged.draw("pendulum.png"))
