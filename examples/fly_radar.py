"""Track a target around the radar, with echoes of other things among its own, in many runs, and judge the filter.

python fly_radar.py

The filter is the generated C of radar.py; what it is judged by is simulated here, with shorter steps.
"""

from pathlib import Path

import numpy as np

from boresight import CompiledFilter, Consistency, generate, load, rotation

MODEL = f"{Path(__file__).parent}/radar.py:RADAR"
RUNS, SECONDS = 50, 120
DT = 0.5  # s, from echo to echo
FINE = 20  # steps of the simulation to one of the filter

NOISE = {"agility": np.full(2, 0.5), "turn_noise": 3e-4}  # m/s/sqrt(s), rad/s/sqrt(s)
ECHO = np.array([10.0, 0.004])  # m, rad: one sigma
CLUTTER = 0.05  # of the echoes are of something else
GATE = 5.0  # sigma, beyond which an innovation is rejected

# South-east of the radar, flying west and turning south: the bearing passes 180 deg after 10 s and after 95 s.
BEGIN = np.array([-5000.0, 1500.0, 20.0, -150.0, -0.03])
START = np.array([50.0, 50.0, 5.0, 5.0, 0.005])  # one sigma

SHOWN = {
    "north, m": 1.0,
    "east, m": 1.0,
    "velocity north, m/s": 1.0,
    "velocity east, m/s": 1.0,
    "turn, deg/s": np.degrees(1),
}


def next_state(x, rng):
    """The truth one step of the filter later: midpoint rule in short steps, each with its share of the noise."""
    h = DT / FINE
    density = np.array([0, 0, *NOISE["agility"], NOISE["turn_noise"]])
    for _ in range(FINE):
        x = x + h * rate_of(x + h / 2 * rate_of(x))
        x = x + density * np.sqrt(h) * rng.standard_normal(x.shape)
    return x


def rate_of(x):
    """The equation of the target, once more: (runs, 5)."""
    _, _, v_north, v_east, turn = x.T
    return np.stack([v_north, v_east, -turn * v_east, turn * v_north, np.zeros(len(x))], axis=-1)


def fly(library, runs=RUNS, seed=0):
    """All runs side by side; the Consistency of their errors and innovations, and the part of clutter let in."""
    rng = np.random.default_rng(seed)
    truth = BEGIN + START * rng.standard_normal((runs, 5))
    loop = CompiledFilter(library, {}, P=np.diag(START**2), x=np.tile(BEGIN, (runs, 1)))
    judged = Consistency(SHOWN)

    for k in range(1, round(SECONDS / DT) + 1):
        truth = next_state(truth, rng)
        loop.predict(dt=DT, **NOISE)

        north, east = truth[:, 0], truth[:, 1]
        z = np.stack([np.hypot(north, east), np.arctan2(east, north)], axis=-1)
        z += ECHO * rng.standard_normal((runs, 2))
        clutter = rng.random(runs) < CLUTTER
        z[clutter] = np.stack([rng.uniform(500, 50000, runs), rng.uniform(-np.pi, np.pi, runs)], axis=-1)[clutter]
        z[:, 1] = rotation.wrapped(z[:, 1])

        found = loop.update("echo", R=ECHO**2, z=z, gate=GATE)
        judged.innovation(k * DT, "echo", found)
        judged.error(k * DT, loop.x - truth, loop.P)
    return judged


if __name__ == "__main__":
    judged = fly(load(generate(MODEL).folder))
    print(judged.report())
    print(judged.draw("radar.png"))
