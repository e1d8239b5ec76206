"""Healthy recordings drawn by seed over motion, rate, grade and format, and how many the check calls wrong.

python tests/recordings_healthy.py [FIRST [COUNT]] draws them, goes the path of `boresight replay --check` with each,
prints what is called an error, and ends with the number: at most 3 of 1000 may be.
"""

import sys

import numpy as np
from recordings_falsified import DEG, G, Plan, complaints, fly
from scipy.io import savemat
from scipy.spatial.transform import Rotation

MOTIONS = ("stop and go", "aircraft", "boat", "multirotor", "straight", "circles", "walker", "on the spot", "rough")
GRADES = {  # gyro deg/sqrt(h), accelerometer m/s/sqrt(s), biases deg/h and m/s^2, sigmas of a master m/s and rad
    "mems": (0.5, 3e-3, 300, 0.08, 0.1, 1.5e-3), "industrial": (0.3, 1.5e-3, 60, 0.04, 0.05, 1e-3),
    "tactical": (0.12, 7e-4, 10, 0.02, 0.03, 4e-4), "navigation": (0.003, 3e-4, 0.1, 0.002, 0.01, 1e-4),
}  # fmt: skip
AXES = {  # rows: the named axes in FRD, or in NED
    "FRD": np.eye(3), "FLU": np.diag([1.0, -1, -1]), "RFU": np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]]),
    "NED": np.eye(3), "NWU": np.diag([1.0, -1, -1]), "ENU": np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]]),
}  # fmt: skip


def steps(t, times, sizes, widths):
    """Smooth steps, one after the other."""
    return sum(size / 2 * (1 + np.tanh((t - at) / wide)) for at, size, wide in zip(times, sizes, widths, strict=True))


def bumps(t, times, sizes, widths):
    """The rates of `steps`."""
    return sum(
        size / (2 * wide) / np.cosh((t - at) / wide) ** 2 for at, size, wide in zip(times, sizes, widths, strict=True)
    )


def motion(kind, rng, seconds):
    """speed, heading, roll, pitch, climb and crab of a kind of vehicle, as `Plan` has them."""
    phase, begin, count = rng.uniform(0, 6.28, 8), rng.uniform(0, 2 * np.pi), int(rng.integers(1, 5))
    at = np.sort(rng.uniform(0.15, 0.9, count)) * seconds
    turns, wide = rng.choice([-1, 1], count) * np.radians(rng.uniform(15, 120, count)), rng.uniform(2, 7, count)
    sway = rng.uniform(0.5, 1.5)

    def wave(size, hz, k):
        return lambda t: size * np.sin(2 * np.pi * hz * sway * t + phase[k])

    def level(t):
        return 0 * t

    def turning(t):
        return begin + steps(t, at, turns, wide) + np.radians(0.5) * np.sin(0.5 * t + phase[0])

    if kind == "stop and go":
        top, stop = rng.uniform(5, 25), rng.uniform(0.5, 0.8) * seconds
        stand = rng.uniform(5, 12)

        def speed(t):
            return top / 2 * (np.tanh((t - stand - 5) / 2) - np.tanh((t - stop) / 2.5)) * (1 + 0.1 * np.sin(0.3 * t))

        def shaken(hz, size, k):
            return lambda t: np.radians(size) * np.clip(speed(t) / top, 0, 1) * np.sin(2 * np.pi * hz * t + phase[k])

        back = np.sort(rng.uniform(*sorted((stand + 6, stop - 4)), count))
        return speed, lambda t: begin + steps(t, back, turns, wide / 2), shaken(0.9, 0.8, 1), shaken(0.7, 0.5, 2), level
    if kind == "aircraft":
        v = rng.uniform(40, 180)
        turns = turns * 0.6

        def speed(t):
            return v * (1 + 0.03 * np.sin(0.2 * t + phase[1]))

        return (
            speed, lambda t: begin + steps(t, at, turns, wide),
            lambda t: np.arctan(v * bumps(t, at, turns, wide) / G) + wave(np.radians(0.8), 0.3, 2)(t),
            lambda t: np.radians(2) + wave(np.radians(0.7), 0.15, 3)(t), wave(rng.uniform(0.5, 4), 0.05, 4),
        )  # fmt: skip
    if kind == "boat":
        swell = rng.uniform(1, 10)
        v = rng.uniform(2, 14)
        return (
            lambda t: v + wave(0.5, 0.1, 1)(t), lambda t: turning(t) + wave(np.radians(1), 0.1, 2)(t),
            wave(np.radians(swell), 0.13, 3), wave(np.radians(swell / 3), 0.16, 4), wave(swell * 0.1, 0.13, 5),
        )  # fmt: skip
    if kind == "multirotor":
        v = rng.uniform(0.5, 8)
        return (
            lambda t: v * (1.2 + np.sin(0.4 * t + phase[1])), turning, wave(np.radians(6), 0.25, 2),
            wave(np.radians(5), 0.3, 3), wave(1.0, 0.06, 4),
        )  # fmt: skip
    if kind == "straight":
        v = rng.uniform(8, 60)
        return (
            lambda t: v * (1 + 0.2 * np.sin(0.15 * t + phase[1])), lambda t: begin + wave(np.radians(0.7), 0.05, 2)(t),
            wave(np.radians(0.5), 0.6, 3), wave(np.radians(0.3), 0.8, 4), wave(0.2, 0.05, 5),
        )  # fmt: skip
    if kind == "circles":
        rate, v = rng.choice([-1, 1]) * np.radians(rng.uniform(3, 25)), rng.uniform(2, 20)
        bank = np.arctan(v * rate / G) * rng.choice([0.0, 1.0])
        return (
            lambda t: v + wave(0.3, 0.1, 1)(t), lambda t: begin + rate * t,
            lambda t: bank + wave(np.radians(0.8), 0.4, 2)(t), wave(np.radians(0.6), 0.5, 3), wave(0.2, 0.05, 4),
        )  # fmt: skip
    if kind == "walker":
        return (
            lambda t: 1.3 + wave(0.2, 1.8, 1)(t), lambda t: turning(t) + wave(np.radians(2), 0.9, 2)(t),
            wave(np.radians(2), 0.9, 3), wave(np.radians(1.5), 1.8, 4), wave(0.15, 1.8, 5),
        )  # fmt: skip
    if kind == "on the spot":
        return level, turning, wave(np.radians(0.3), 0.5, 3), wave(np.radians(0.3), 0.7, 4), level
    v = rng.uniform(4, 15)
    return (
        lambda t: v * (1 + 0.3 * np.sin(0.3 * t + phase[1])), lambda t: turning(t) + wave(np.radians(2), 0.4, 2)(t),
        wave(np.radians(7), 0.4, 3), wave(np.radians(6), 0.5, 4), wave(0.8, 0.5, 5),
    )  # fmt: skip


def healthy(seed):
    """A recording of that seed, as `Written`, and what was drawn."""
    rng = np.random.default_rng([seed, 7])
    kind, grade = MOTIONS[seed % len(MOTIONS)], list(GRADES)[seed // len(MOTIONS) % len(GRADES)]
    gyro, accel, bias, bias_f, sigma_v, sigma_a = GRADES[grade]
    seconds = rng.uniform(35, 80)
    crab = {"aircraft": 12, "boat": 8, "multirotor": 180}.get(kind, 0) * DEG * rng.uniform(-1, 1)
    speed, heading, roll, pitch, climb = motion(kind, rng, seconds)
    plan = Plan(
        speed=speed, heading=heading, roll=roll, pitch=pitch, climb=climb, crab=lambda t: crab + 0 * t, seconds=seconds,
        imu_hz=float(rng.choice([50, 100, 125, 200, 250])), master_hz=float(rng.choice([1, 2, 4, 5, 10, 12.5, 20])),
        mounting=tuple(rng.normal(0, 1.2 * DEG, 3)), lever=tuple(rng.normal(0, 0.7, 3)),
        gyro_bias=tuple(rng.normal(0, bias, 3)), accel_bias=tuple(rng.normal(0, bias_f, 3)),
        gyro_noise=gyro * DEG / 60, accel_noise=accel, velocity_noise=sigma_v * rng.uniform(0.3, 1.5),
        attitude_noise=sigma_a * rng.uniform(0.3, 1.5), delay=rng.uniform(0, 0.08), fine=4,
    )  # fmt: skip
    made = fly(plan, seed)
    return formatted(made, rng, plan), f"{kind}, {grade}, {plan.imu_hz:g} and {plan.master_hz:g} Hz"


def formatted(made, rng, plan):
    """The same recording in axes, units, tags, digits and a file of another kind."""
    c, dt = made.columns, 1 / plan.imu_hz
    if rng.random() < 0.3:  # a converter of 16 bits
        c["gyro"] = np.round(c["gyro"] / (500 * DEG / 2**15)) * (500 * DEG / 2**15)
        c["accel"] = np.round(c["accel"] / (8 * G / 2**15)) * (8 * G / 2**15)
    body = rng.choice(["FRD", "FLU", "RFU"])
    c["gyro"], c["accel"] = (c[name] @ AXES[body].T for name in ("gyro", "accel"))
    made.replace(('time_marks = "end"\nbody = "FRD"', f'time_marks = "end"\nbody = "{body}"'))
    mark = rng.choice(["start", "middle", "end"])
    c["t"] = c["t"] - {"start": 1, "middle": 0.5, "end": 0}[mark] * dt
    made.replace(('time_marks = "end"', f'time_marks = "{mark}"'))
    unit = rng.choice(["rad", "deg", "increments"])
    if unit == "deg":
        c["gyro"], c["accel"] = np.degrees(c["gyro"]), c["accel"] / G
        made.replace(('gyro", unit = "rad/s"', 'gyro", unit = "deg/s"'), ('unit = "m/s^2"', 'unit = "g"'))
    elif unit == "increments":
        c["gyro"], c["accel"] = c["gyro"] * dt, c["accel"] * dt
        made.replace(('kind = "rates"', 'kind = "increments"'), ('gyro", unit = "rad/s"', 'gyro", unit = "rad"'),
                     ('unit = "m/s^2"', 'unit = "m/s"'))  # fmt: skip
    navigation, named = rng.choice(["NED", "ENU", "NWU"]), rng.choice(["FRD", "FLU", "RFU"])
    quaternion = bool(rng.random() < 0.5)
    if quaternion:
        C = Rotation.from_euler("ZYX", c["attitude"][:, ::-1]).as_matrix()
        q = Rotation.from_matrix(AXES[navigation] @ C @ AXES[named].T).as_quat()
        c["attitude"] = q * rng.choice([-1, 1])
        made.replace(('attitude", unit = "rad"', 'attitude", unit = "1", order = "xyzw"'))
    else:
        c["attitude"] = np.degrees(c["attitude"])
        c["attitude"][:, 2] %= 360
        made.replace(('attitude", unit = "rad"', 'attitude", unit = "deg", yaw_from = "north", pitch_positive = "up"'))
    c["velocity"] = c["velocity"] @ AXES[navigation].T
    made.replace(('[master]\nbody = "FRD"\nnavigation = "NED"',
                  f'[master]\nbody = "{named}"\nnavigation = "{navigation}"'))  # fmt: skip
    tags = rng.choice(["s", "UNIX", "us"])
    if tags == "us":
        c["t"], c["tm"] = (np.round((c[name] + 20) * 1e6) for name in ("t", "tm"))
        made.replace(('columns = "t", unit = "s"', 'columns = "t", unit = "us"'),
                     ('columns = "tm", unit = "s"', 'columns = "tm", unit = "us"'))  # fmt: skip
    elif tags == "UNIX":
        c["t"], c["tm"] = c["t"] + 1.7e9, c["tm"] + 1.7e9
    made.notes["file"] = str(rng.choice(["npz", "mat", "csv"]))
    if made.notes["file"] == "csv":
        c["position"] = np.column_stack([np.degrees(c["position"][:, :2]), c["position"][:, 2]])
        made.replace(('position", unit = "rad"', 'position", unit = "deg"'))
    return made


def write(made, folder):
    """As files of the kind that was drawn; returns the path of the description."""
    kind = made.notes["file"]
    if kind == "npz":
        return made.write(folder)
    if kind == "mat":
        savemat(folder / "drive.mat", made.columns)
        text = made.toml.replace("drive.npz", "drive.mat")
    else:  # two of them, with so many digits as loggers give
        text = made.toml.replace('file = "drive.npz"\n', "")
        for section, names in (("imu", ("t", "gyro", "accel")), ("master", ("tm", "attitude", "velocity", "position"))):
            heads, parts = [], []
            for name in names:
                values = made.columns[name].reshape(len(made.columns[name]), -1)
                columns = [name] if values.shape[1] == 1 else [f"{name}{i}" for i in range(values.shape[1])]
                digits = {"t": "%.6f", "tm": "%.6f", "velocity": "%.4f", "position": "%.9f"}.get(name, "%.8f")
                heads += columns
                parts.append([[digits % value for value in row] for row in values])
                if len(columns) > 1:
                    listed = ", ".join(f'"{column}"' for column in columns)
                    text = text.replace(f'columns = "{name}"', f"columns = [{listed}]")
            rows = [",".join(word for part in row for word in part) for row in zip(*parts, strict=True)]
            (folder / f"{section}.csv").write_text("\n".join([",".join(heads), *rows]) + "\n")
            text = text.replace(f"[{section}]\n", f'[{section}]\nfile = "{section}.csv"\n')
    path = folder / "drive.toml"
    path.write_text(text)
    return path


if __name__ == "__main__":
    from pathlib import Path
    from tempfile import TemporaryDirectory

    first, count = (int(word) for word in (*sys.argv[1:], *("0", "1000")[len(sys.argv) - 1 :]))
    wrong = warned = 0
    with TemporaryDirectory() as folder:
        for seed in range(first, first + count):
            made, what = healthy(seed)
            texts = complaints(write(made, Path(folder)))
            errors = [text for text in texts if text.startswith("error")]
            wrong, warned = wrong + bool(errors), warned + bool(texts and not errors)
            for text in (errors or texts)[:1]:
                print(f"{seed} ({what}, {made.notes['file']}): {text[:260]}", flush=True)
            if (seed + 1 - first) % 50 == 0 or seed + 1 == first + count:
                print(f"{wrong} of {seed + 1 - first} are called wrong, {warned} have a warning", flush=True)
