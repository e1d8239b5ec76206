"""Simulate a small aircraft over rising ground, fly the autopilot's filter on it in many runs, and judge it.

python fly_autopilot.py

The filter is the generated C of autopilot.py; what it is judged by is simulated here.
"""

from pathlib import Path

import numpy as np

from boresight import CompiledFilter, Consistency, generate, load, rotation

MODEL = f"{Path(__file__).parent}/autopilot.py:AUTOPILOT"
RUNS, SECONDS = 30, 40
DT = 0.01  # s
GRAVITY = np.array([0, 0, 9.81])
OFFSET = 0.4  # rad, between the two antennas and the nose
ATTACK, SLIP, SLIP_HZ = (
    0.05,
    0.03,
    5,
)  # rad: angle of attack; one sigma of the sideslip, which is another 5 times a second

# Each state: how it is shown, one sigma of what is known at the start, and the density of its random walk.
DEGREE, uT, NED = np.degrees(1), 1e6, ("north", "east", "down")
STATES = {
    "theta": ("attitude {}, deg", NED, DEGREE, [0.01, 0.01, 0.03], 0.0),
    "vel": ("velocity {}, m/s", NED, 1.0, 0.3, 0.0),
    "pos": ("position {}, m", NED, 1.0, 2.0, 0.0),
    "gyro_bias": ("gyro bias {}, deg/s", "xyz", DEGREE, 0.005, 1e-4),
    "accel_bias": ("accel bias {}, m/s^2", "xyz", 1.0, 0.05, 1e-3),
    "mag_i": ("field {}, uT", NED, uT, 5e-7, 1e-8),
    "mag_b": ("field of body {}, uT", "xyz", uT, 5e-7, 1e-8),
    "wind": ("wind {}, m/s", NED[:2], 1.0, 0.5, 0.05),
    "terrain": ("{}, m", ("ground",), 1.0, 1.0, 0.5),
}
SHOWN = {label.format(axis): factor for label, axes, factor, *_ in STATES.values() for axis in axes}
START = np.concatenate([np.broadcast_to(sigma, len(axes)) for _, axes, _, sigma, _ in STATES.values()])
NOISE = {"gyro_noise": np.full(3, 1e-3), "accel_noise": np.full(3, 0.02)}
NOISE |= {f"{name}_noise": np.full(len(axes), walk) for name, (_, axes, *_, walk) in STATES.items() if walk}

# Each sensor: the input that it fills, how often a second, and one sigma of each row.
SENSORS = {
    "mag": ("mag", 20, [5e-7] * 3),
    "airspeed": ("airspeed", 10, [0.5]),
    "flow": ("flow", 10, [0.02] * 2),
    "height": ("hagl", 10, [0.2]),
    "velocity": ("gnss_vel", 5, [0.2] * 3),
    "position": ("gnss_pos", 5, [0.8] * 3),
    "sideslip": (None, SLIP_HZ, [SLIP]),  # nothing is measured: it is zero but for what it truly is
    "antennas": ("antenna_heading", 2, [0.02]),
    "yaw": ("yaw", 1, [0.05]),
    "declination": ("declination", 1 / SECONDS, [0.02]),  # of a table, which errs alike each time: it counts once
}


def truth(rng, runs):
    """Velocity and position of the circuit that all runs fly; of each run the wind, the ground and the attitude."""
    t = np.arange(0, SECONDS + DT / 2, DT)
    course = 0.3 * t + 0.4 * np.sin(0.5 * t)
    speed = 16 + 2 * np.sin(0.3 * t)
    vel = np.stack([speed * np.cos(course), speed * np.sin(course), -1.5 * np.sin(0.25 * t)], -1)
    pos = np.array([0, 0, -60.0]) + np.cumsum(vel * DT, 0) - vel * DT

    def walk(name, begin):
        steps = NOISE[f"{name}_noise"] * np.sqrt(DT) * rng.standard_normal((len(t), runs, len(begin)))
        return begin + np.cumsum(steps, 0)

    slow = {name: walk(name, begin) for name, begin in {
        "gyro_bias": [0.01, -0.005, 0.008], "accel_bias": [0.1, -0.05, 0.08], "mag_i": [2.1e-5, 1.5e-6, 4.3e-5],
        "mag_b": [1e-6, -2e-6, 5e-7], "wind": [3.0, -2.0], "terrain": [0.0],
    }.items()}  # fmt: skip

    # The nose into the wind but for the sideslip, and a bank that turns the path.
    air = vel[:, None] - np.concatenate([slow["wind"], np.zeros((len(t), runs, 1))], -1)
    bank = np.arctan(np.gradient(course, DT) * speed / GRAVITY[2])
    climb = np.arctan2(-air[..., 2], np.hypot(air[..., 0], air[..., 1]))
    nose = rotation.quaternion_from_euler(np.stack([
        np.broadcast_to(bank[:, None], climb.shape), climb, np.arctan2(air[..., 1], air[..., 0])
    ], -1))  # fmt: skip
    nodes = SLIP * rng.standard_normal((SECONDS * SLIP_HZ + 3, runs))
    at, part = np.divmod((t - DT) * SLIP_HZ + 1 + 1e-9, 1)  # a node where the sideslip is fused
    part = ((1 - np.cos(np.pi * part)) / 2)[:, None]
    slip = nodes[at.astype(int)] * (1 - part) + nodes[at.astype(int) + 1] * part
    q = rotation.turned(rotation.turned(nose, slip[..., None] * [0, 0, -1]), [0, ATTACK, 0])
    return t, {"q": q, "vel": np.broadcast_to(vel[:, None], q[..., 1:].shape),
               "pos": np.broadcast_to(pos[:, None], q[..., 1:].shape), **slow}  # fmt: skip


def ideal(now):
    """What each sensor would read without noise, by the input that it fills."""
    C = rotation.matrix_from_quaternion(now["q"])
    v_b = np.einsum("rji,rj->ri", C, now["vel"])
    pair = C @ [np.cos(OFFSET), np.sin(OFFSET), 0]
    height = now["terrain"] - now["pos"][:, 2:]
    return {
        "mag": np.einsum("rji,rj->ri", C, now["mag_i"]) + now["mag_b"],
        "airspeed": np.linalg.norm(now["vel"] - np.pad(now["wind"], ((0, 0), (0, 1))), axis=-1, keepdims=True),
        "flow": v_b[:, [1, 0]] * [1, -1] / height * C[:, 2, 2:],
        "hagl": height,
        "gnss_vel": now["vel"],
        "gnss_pos": now["pos"],
        "antenna_heading": np.arctan2(pair[:, 1:2], pair[:, :1]),
        "yaw": np.arctan2(C[:, 1, :1], C[:, 0, :1]),
        "declination": np.arctan2(now["mag_i"][:, 1:2], now["mag_i"][:, :1]),
    }


def fly(library, runs=RUNS, seed=0):
    """All runs side by side; the Consistency of their errors and innovations."""
    rng = np.random.default_rng(seed)
    t, true = truth(rng, runs)
    turns = rotation.body_increments(true["q"], np.zeros(3), DT)
    C = rotation.matrix_from_quaternion(true["q"])
    gains = np.einsum("krji,krj->kri", C[:-1], np.diff(true["vel"], axis=0) - GRAVITY * DT)

    # The start, wrong by what START says: estimate = true + error.
    ends = np.cumsum([len(axes) for _, axes, *_ in STATES.values()])[:-1]
    start = dict(zip(STATES, np.split(START * rng.standard_normal((runs, len(START))), ends, -1), strict=True))
    nav = {"q": rotation.turned(true["q"][0], -np.einsum("rji,rj->ri", C[0], start.pop("theta")))}
    nav |= {name: true[name][0] + error for name, error in start.items()}
    nav["terrain"] = nav["terrain"][:, 0]
    loop = CompiledFilter(library, nav, P=np.diag(START**2))
    judged = Consistency(SHOWN)

    for k in range(len(t) - 1):
        # one step of the sensors, of the covariance and of the navigation
        white = np.sqrt(DT) * rng.standard_normal((2, runs, 3))
        turn = turns[k] + true["gyro_bias"][k] * DT + white[0] * NOISE["gyro_noise"]
        gain = gains[k] + true["accel_bias"][k] * DT + white[1] * NOISE["accel_noise"]
        loop.predict(accel=gain / DT, dt=DT, **NOISE)
        loop.strapdown(delta_ang=turn, delta_vel=gain, dt=DT)

        now = {name: of[k + 1] for name, of in true.items()}
        due = [name for name, (_, rate, _) in SENSORS.items() if k % round(1 / rate / DT) == 0]
        ideals = ideal(now) if due else {}
        for name in due:
            key, _, sigma = SENSORS[name]
            read = ideals[key] + sigma * rng.standard_normal((runs, len(sigma))) if key else 0
            if name in ("antennas", "yaw", "declination"):
                read = (read + np.pi) % (2 * np.pi) - np.pi
            given = {key: read if len(sigma) > 1 else read[:, 0]} if key else {}
            given |= {"antenna_offset": OFFSET} if name == "antennas" else {}
            judged.innovation(t[k + 1], name, loop.update(name, R=np.square(sigma), **given))
            loop.feedback()

        if (k + 1) % round(1 / DT) == 0:
            off = [loop.nav[name].reshape(runs, -1) - now[name] for name in start]
            off = [rotation.attitude_error(loop.nav["q"], now["q"]), *off]
            judged.error(t[k + 1], np.concatenate(off, axis=-1), loop.P)
    return judged


if __name__ == "__main__":
    judged = fly(load(generate(MODEL).folder))
    print(judged.report())
    print(judged.draw("autopilot.png"))
