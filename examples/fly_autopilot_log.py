"""Fly the autopilot's filter on a log of PX4, beside the log's own estimator and the ground truth in it.

python fly_autopilot_log.py [LOG.ulg]

The filter is the generated C of autopilot.py.  It has what PX4's ekf2 had on the pad: the inertial sensor, heading from
the magnetometer, height from the barometer, the receiver once it has a fix and, where the log says that the vehicle is
at rest, five times a second a velocity of zero and, until there is a fix, the first place.  Its noises are the
parameters in the log.
"""

import sys
from pathlib import Path

import numpy as np
from pyulog import ULog

from boresight import CompiledFilter, generate, load, read, rotation

HERE = Path(__file__).parent
MODEL = f"{HERE}/autopilot.py:AUTOPILOT"
LOG = HERE / "recordings" / "pad.ulg"
STEP = 0.008  # s, of ekf2: its noises are per step
GAUSS = 1e-4  # T
LOOK = {"font.size": 9, "axes.titlesize": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
        "grid.color": "0.9", "legend.frameon": False, "svg.fonttype": "none", "svg.hashsalt": "log"}  # fmt: skip
REST = (1e-3, 0.01)  # m/s, m: one sigma of a velocity of zero and of a place that is kept, as ekf2 has them at rest
EARTH = 6371e3  # m
JUDGED = {"attitude": (slice(0, 3), "deg"), "velocity": (slice(3, 6), "m/s"), "position": (slice(6, 9), "m")}


def sensors(path):
    """Inertial increments, what else was measured, the ground truth and ekf2's states, each with its times (s)."""
    imu = read(path, bridge="10 ms", strict=False).imu
    log = ULog(str(path))
    topics = {topic.name: topic.data for topic in log.data_list if topic.multi_id == 0}

    def columns(topic, *names):
        held = topics[topic]
        return held["timestamp"] / 1e6, np.stack([held[name].astype(float) for name in names], axis=-1)

    def many(name, count, first=0):
        return [f"{name}[{i}]" for i in range(first, first + count)]

    truth = topics["vehicle_local_position_groundtruth"]
    t, fix = columns("vehicle_gps_position", "lat", "lon", "alt", "vel_n_m_s", "vel_e_m_s", "vel_d_m_s", "eph", "epv",
                     "s_variance_m_s", "fix_type")  # fmt: skip
    lat, lon = truth["ref_lat"][0], truth["ref_lon"][0]
    north, east = np.radians(fix[:, 0] / 1e7 - lat) * EARTH, np.radians(fix[:, 1] / 1e7 - lon) * EARTH
    east *= np.cos(np.radians(lat))
    receiver = np.column_stack([north, east, fix[:, 3:]])[fix[:, -1] >= 3], t[fix[:, -1] >= 3]
    return {
        "imu": imu, "rest": columns("vehicle_land_detected", "at_rest"),
        "parameters": log.initial_parameters, "receiver": receiver[::-1],
        "baro": columns("vehicle_air_data", "baro_alt_meter"),
        "mag": columns("vehicle_magnetometer", *many("magnetometer_ga", 3)),
        "truth": (columns("vehicle_attitude_groundtruth", *many("q", 4)),
                  columns("vehicle_local_position_groundtruth", "vx", "vy", "vz", "x", "y", "z")),
        "ekf2": columns("estimator_states", *many("states", 24), *many("covariances", 24)),
    }  # fmt: skip


def densities(of):
    """Densities of the filter's noise, of the log's parameters."""
    sizes = {"gyro": of["GYR_NOISE"], "accel": of["ACC_NOISE"], "gyro_bias": of["GYR_B_NOISE"],
             "accel_bias": of["ACC_B_NOISE"], "mag_i": of["MAG_E_NOISE"] * GAUSS, "mag_b": of["MAG_B_NOISE"] * GAUSS,
             "wind": of["WIND_NOISE"]}  # fmt: skip
    out = {f"{name}_noise": np.full(2 if name == "wind" else 3, size * np.sqrt(STEP)) for name, size in sizes.items()}
    return out | {"terrain_noise": 0.0}


def fly(library, log):
    """Times (s), attitude, velocity and position (K, 10), and the covariance of their errors (K, 9, 9)."""
    of = {name.removeprefix("EKF2_"): value for name, value in log["parameters"].items()}
    noise, heading_sigma, baro_sigma = densities(of), of["HEAD_NOISE"], of["BARO_NOISE"]
    imu = log["imu"]
    _, end, turn, gain = imu.increments
    begin = int(np.searchsorted(end, end[0] + 0.3))  # what levels it, and points it to magnetic north
    up = gain[:begin].mean(axis=0)
    level = [np.arctan2(-up[1], -up[2]), np.arctan2(up[0], np.hypot(up[1], up[2])), 0.0]
    declination = np.radians(of["MAG_DECL"])

    def heading(q, field):
        roll, pitch, _ = rotation.euler_from_matrix(rotation.matrix_from_quaternion(q))
        flat = rotation.matrix_from_euler([roll, pitch, 0.0]) @ field
        return np.arctan2(-flat[1], flat[0]) + declination

    q = rotation.quaternion_from_euler(level)
    q = rotation.quaternion_from_euler([*level[:2], heading(q, log["mag"][1][0])])
    field = rotation.matrix_from_quaternion(q) @ log["mag"][1][0] * GAUSS
    ground = log["baro"][1][0, 0]
    nav = {"q": q, "vel": np.zeros(3), "pos": np.zeros(3), "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3),
           "mag_i": field, "mag_b": np.zeros(3), "wind": np.zeros(2), "terrain": 0.0}  # fmt: skip
    tilt = of["ANGERR_INIT"]
    start = [tilt, tilt, heading_sigma, *[0.5] * 5, baro_sigma, *[of["GBIAS_INIT"]] * 3, *[of["ABIAS_INIT"]] * 3]
    start += [*[of["MAG_NOISE"] * GAUSS] * 6, 1.0, 1.0, 1.0]
    loop = CompiledFilter(library, nav, P=np.diag(np.square(start)))

    due = [(t, "baro", value) for t, value in zip(*log["baro"], strict=True)]
    due += [(t, "mag", value) for t, value in zip(*log["mag"], strict=True)]
    due += [(t, "receiver", value) for t, value in zip(*log["receiver"], strict=True)]
    first = log["receiver"][0][0] if len(log["receiver"][0]) else np.inf
    tags, rest = log["rest"]
    beats = np.arange(end[begin], end[-1], 0.2)
    due += [(t, "still", None) for t in beats[rest[np.clip(np.searchsorted(tags, beats), 0, len(tags) - 1), 0] > 0]]
    due = sorted((one for one in due if one[0] > end[begin]), key=lambda one: one[0])

    times, found, P = [], [], []
    for k in range(begin + 1, len(end)):
        dt = end[k] - end[k - 1]
        loop.predict(accel=gain[k] / dt, dt=dt, **noise)
        loop.strapdown(delta_ang=turn[k], delta_vel=gain[k], dt=dt)
        while due and due[0][0] <= end[k]:
            _, what, value = due.pop(0)
            if what == "mag":
                off = heading(loop.nav["q"], value)
                loop.update("yaw", R=[heading_sigma**2], yaw=(off + np.pi) % (2 * np.pi) - np.pi)
            elif what == "baro":
                down = [0.0, 0.0, ground - value[0]]
                loop.update("position", R=[1.0, 1.0, baro_sigma**2], gnss_pos=down, rows=[False, False, True])
            elif what == "still":
                loop.update("velocity", R=[REST[0] ** 2] * 3, gnss_vel=np.zeros(3))
                if end[k] < first:
                    loop.update(
                        "position", R=[REST[1] ** 2] * 2 + [1.0], gnss_pos=np.zeros(3), rows=[True, True, False]
                    )
            else:
                place = max(value[5], of["GPS_P_NOISE"])
                speed = max(value[7], of["GPS_V_NOISE"])
                loop.update("velocity", R=[speed**2, speed**2, (1.5 * speed) ** 2], gnss_vel=value[2:5])
                loop.update("position", R=[place**2, place**2, 1.0], gnss_pos=[*value[:2], 0.0],
                            rows=[True, True, False])  # fmt: skip
            loop.feedback()
        times.append(end[k])
        found.append(np.concatenate([loop.nav["q"], loop.nav["vel"], loop.nav["pos"]]))
        P.append(loop.P[:9, :9].copy())
    return np.array(times), np.array(found), np.array(P)


def errors(log, times, states):
    """(K, 9) rad, m/s, m: attitude, velocity and position of (K, 10) less the ground truth, taken between its tags.

    Places count from the first.  Those of the truth are rounded to 1e-7 deg, 11 mm: where it never moves, they are one.
    """
    (tq, q), (tv, v) = log["truth"]
    v = v - [0, 0, 0, *v[0, 3:]] if v[:, :3].any() else np.zeros_like(v)
    nearest = np.clip(np.searchsorted(tq, times), 0, len(tq) - 1)
    moved = np.stack([np.interp(times, tv, part) for part in v.T], axis=-1)
    return np.column_stack([rotation.attitude_error(states[:, :4], q[nearest]), states[:, 4:] - moved])


def judged(log, found):
    """By estimator: times, errors (K, 9) and one sigma (K, 9); ekf2's attitude has that of its quaternion's parts."""
    out = {}
    for name, (times, states, P) in found.items():
        out[name] = (times, errors(log, times, states), np.sqrt(np.diagonal(P, axis1=1, axis2=2)))
    times, held = log["ekf2"]
    sigma = np.column_stack([2 * np.sqrt(held[:, 25:28]), np.sqrt(held[:, 28:34])])
    return out | {"ekf2 (PX4)": (times, errors(log, times, held[:, :10]), sigma)}


def report(of, since):
    """Root mean square of the errors, and of errors over sigma: 1 for a filter that knows how wrong it is."""
    lines = [
        "root mean square from the truth, and in sigmas",
        f"{'':<22}{'attitude':>20}{'velocity':>20}{'position':>20}",
    ]
    for name, (times, off, sigma) in of.items():
        cells = []
        for part, unit in JUDGED.values():
            use = times > since
            size = np.sqrt(np.mean(off[use, part] ** 2)) * (np.degrees(1) if unit == "deg" else 1)
            ratio = np.sqrt(np.mean((off[use, part] / sigma[use, part]) ** 2))
            cells.append(f"{size:.4f} {unit}, {ratio:.2f}")
        lines.append(f"{name:<22}" + "".join(f"{cell:>20}" for cell in cells))
    return "\n".join(lines)


def draw(of, path):
    """One row a quantity, one column an axis; the truth is zero, and the bands are the largest sigma of each 0.2 s."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    with plt.rc_context(LOOK):
        drawing, axes = plt.subplots(3, 3, figsize=(9, 6), sharex=True, layout="constrained")
        for row, (quantity, (part, unit)) in enumerate(JUDGED.items()):
            factor = np.degrees(1) if unit == "deg" else 1.0
            for column, axis in enumerate(("north", "east", "down")):
                at, k = axes[row, column], part.start + column
                for colour, (name, (times, off, sigma)) in zip(("#0b5fa5", "#d1600a"), of.items(), strict=False):
                    first = np.searchsorted(times, np.arange(times[0], times[-1], 0.2))
                    band = factor * np.maximum.reduceat(sigma[:, k], first)
                    # of many points a picture, so that an SVG stays small
                    at.plot(times, factor * off[:, k], color=colour, lw=1.0, label=name, rasterized=len(times) > 1000)
                    at.fill_between(times[first], -band, band, step="post", color=colour, alpha=0.12, lw=0)
                largest = max(np.abs(off[times > times[0] + 2, k]).max() for times, off, _ in of.values()) * factor
                at.set_ylim(-4 * largest, 4 * largest)
                at.set_title(f"{quantity} {axis} [{unit}]", loc="left")
        for at in axes[-1]:
            at.set_xlabel("time of the log [s]")
        drawing.suptitle("Errors from the ground truth; bands: one sigma")
        drawing.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
        drawing.savefig(path, dpi=150, metadata={"Date": None} if str(path).endswith(".svg") else None)
    return path


def flown(path, folder=None):
    """The flight of a log, judged, beside its own estimator."""
    library = load(generate(MODEL, folder).folder)
    log = sensors(path)
    return judged(log, {"autopilot": fly(library, log)})


if __name__ == "__main__":
    of = flown(sys.argv[1] if len(sys.argv) > 1 else LOG)
    print(report(of, since=2.0))
    print(draw(of, "autopilot_log.svg"))
