"""Zero-velocity updates on a recording of a single IMU that stops and goes: the fifteen-state filter of Kim (2018).

When it rests is the detector's business (studies/stationary.py), which sees the IMU alone.  Nothing is known but rest:
no heading, no position, no reference track.  Every stop shows what the filter's velocity had become before the update.
"""

from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.figures import BLUE, ORANGE, Sheets
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.detector import gaps
from boresight.runtime.filter import Filter
from boresight.runtime.library import load
from boresight.runtime.recording import Recording
from boresight.runtime.simulation import inertial
from boresight.studies.replays import stationary
from boresight.studies.study import Progress, Replay, Study, table

TO_RFU = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])  # front-right-down to right-front-up
EARTH_RADIUS_M = 6.371e6  # for a track of some metres in the figure; the filter's own Earth is the ellipsoid
DETECTOR = "likelihood_ratio"
UPDATE_S = 0.1

# What the filter is told beyond the white noise seen at rest.  A foot brings scale factors, bandwidth and shocks that
# no rest shows: stated as a factor on both noises, chosen so that the innovations at the stops are consistent.
MOTION_FACTOR = 10.0
# A loaded foot sways: a threshold set from the sensor's noise alone calls that movement.  For updates it is raised.
SWAY_FACTOR = 30.0
ZUPT_SIGMA_M_S = 0.01
GAP = {"speed_m_s": 1.0, "turn_deg_s": 20.0}  # what a walker may do while no data comes
START = {"level_deg": 0.5, "heading_deg": 1.0, "gyro_bias_deg_s": 0.05, "accel_bias_m_s2": 0.05}


def level(f_b: Array) -> Array:
    """q_b2n_wxyz (ENU from RFU) of a body at rest that feels f_b, its front towards north as nearly as it can be."""
    up = f_b / np.linalg.norm(f_b)
    north = np.array([0.0, 1.0, 0.0]) - up[1] * up
    north /= np.linalg.norm(north)
    C = np.stack([np.cross(north, up), north, up])  # rows: east, north, up in body components
    return rotation.quaternion_from_matrix(C)


def bridge(loop: Filter, seconds: float, metres: Array) -> None:
    """Go on after a gap in the inertial data, by a stated rule.

    Position and attitude stay, the velocity begins again from zero, and the covariance says what that is worth: GAP's
    speed and turn, for as long as the gap was.
    """
    loop.nav["v_n"] = np.zeros(3)
    velocity = slice(3, 6)
    loop.P[velocity, :] = loop.P[:, velocity] = 0.0
    loop.P[velocity, velocity] = np.diag(np.full(3, GAP["speed_m_s"] ** 2))
    distance, turn = GAP["speed_m_s"] * seconds / metres, np.full(3, np.radians(GAP["turn_deg_s"]) * seconds)
    loop.P[:9, :9] += np.diag(np.concatenate([distance, np.zeros(3), turn]) ** 2)


def run(
    recording: Recording,
    hold: Any,
    strapdown: Any,
    *,
    latitude_deg: float = 59.3,
    detector: str = DETECTOR,
    sway_factor: float = SWAY_FACTOR,
    updates: bool = True,
    **settings: Any,
) -> dict[str, Any]:
    """Fly the recording with a zero-velocity update at each tenth of a second of declared rest.

    latitude_deg: where, if the recording does not say; it sets gravity's and the Earth rate's model.  sway_factor: on
    the detector's threshold, for updates.  updates: False for pure inertial.  settings: of `stationary.run`.
    The result can be written as JSON without `history`: stops: from, to (s), speed before the first update (m/s) and
    its NIS (three degrees of freedom), metres from the start; end_from_start_m; nis_mean of first updates; detection:
    the result of `stationary.run`; gaps_s: times of the samples that follow a gap or repeat a tag, handled by `bridge`.
    """
    found = stationary.run(recording, **settings)
    if detector not in found["history"]["statistic"]:
        raise BoresightError(f"no detector {detector!r}; there are {', '.join(found['history']['statistic'])}")
    limit = found["detectors"][detector]["threshold"]
    rest = found["history"]["statistic"][detector] < sway_factor * limit
    time, dt = recording.imu.time, recording.imu.dt
    gyro, accel = (rate @ TO_RFU.T for rate in recording.imu.rates())
    begin = int(np.argmax(rest))  # a detector decides once its first window is full
    first = begin + int(np.argmin(np.append(rest[begin:], False)))
    start = slice(0, first)
    if first * dt < 2.0:
        raise BoresightError(
            f"{recording.name}: it must begin with two seconds of rest, for the level and the gyro bias"
        )

    lat = np.radians(latitude_deg)
    place = np.array([0.0, lat, 0.0])
    q = level(accel[start].mean(axis=0))
    C_n2b = rotation.matrix_from_quaternion(q).T
    earth = strapdown.earth(lon_lat_height=place, v_n=np.zeros(3))
    gyro_bias = gyro[start].mean(axis=0) - C_n2b @ earth["omega_ie_n"]
    accel_bias = accel[start].mean(axis=0) + C_n2b @ earth["gravity_n"]
    metres = np.array([EARTH_RADIUS_M * np.cos(lat), EARTH_RADIUS_M, 1.0])
    sigma = np.concatenate([
        0.01 / metres,
        np.full(3, 1e-3),
        np.radians([START["level_deg"], START["level_deg"], START["heading_deg"]]),
        np.full(3, np.radians(START["gyro_bias_deg_s"])),
        np.full(3, START["accel_bias_m_s2"]),
    ])  # fmt: skip
    nav = {"lon_lat_height": place, "v_n": np.zeros(3), "q_b2n_wxyz": q}
    nav |= {"gyro_bias": gyro_bias, "accel_bias": accel_bias}
    loop = Filter(hold, nav, np.diag(sigma**2))
    noise = {
        "gyro_noise": np.full(3, MOTION_FACTOR * found["noise"]["sigma_gyro"] * np.sqrt(dt)),
        "accel_noise": np.full(3, MOTION_FACTOR * found["noise"]["sigma_accel"] * np.sqrt(dt)),
        "gyro_bias_noise": np.full(3, 1e-6),
        "accel_bias_noise": np.full(3, 1e-5),
    }

    every = max(1, round(UPDATE_S / dt))
    track, speed = np.empty((len(time), 3)), np.empty(len(time))
    stops: list[dict[str, float]] = []
    f_sum, resting = np.zeros(3), False
    breaks = gaps(time)
    fields = inertial.intervals(gyro * dt, accel * dt)
    for before, now in (("dtheta_before", "dtheta_ib_b"), ("dv_before", "dv_b")):  # behind a gap as at the start
        fields[before][breaks] = fields[now][breaks]
    for k in range(len(time)):
        if breaks[k]:
            bridge(loop, max(0.0, float(time[k] - time[k - 1])), metres)
        loop.strapdown(**{name: values[k] for name, values in fields.items()}, dt=dt)
        if recording.imu.doubt is not None:  # what a sample that was bridged may have missed
            angle, velocity = recording.imu.doubt[k] ** 2
            loop.P[:9, :9] += np.diag([0, 0, 0, velocity, velocity, velocity, angle, angle, angle])
        f_sum += accel[k] - loop.nav["accel_bias"]
        if (k + 1) % every == 0:
            loop.predict(f_b=f_sum / every, dt=every * dt, **noise)
            f_sum[:] = 0
            if rest[k] and updates:
                v = float(np.linalg.norm(loop.nav["v_n"]))
                seen = loop.update("zupt", np.full(3, ZUPT_SIGMA_M_S**2))
                if not resting and k > first:
                    away = float(np.linalg.norm((loop.nav["lon_lat_height"] - place) * metres))
                    stops.append(
                        {"from_s": float(time[k]), "speed_m_s": v, "nis": float(seen.nis), "from_start_m": away}
                    )
                loop.feedback()
            if resting and not rest[k] and stops:
                stops[-1]["to_s"] = float(time[k])
            resting = bool(rest[k])
        track[k], speed[k] = (loop.nav["lon_lat_height"] - place) * metres, np.linalg.norm(loop.nav["v_n"])
    if stops:
        stops[-1].setdefault("to_s", float(time[-1]))
    return {
        "recording": recording.name,
        "detector": detector,
        "updates": updates,
        "latitude_deg": latitude_deg,
        "sway_factor": sway_factor,
        "gaps_s": time[breaks].tolist(),
        "share_updated": float(np.mean(rest)),
        "stops": stops,
        "nis_mean": float(np.mean([stop["nis"] for stop in stops])) if stops else None,
        "end_from_start_m": float(np.linalg.norm(track[-1])),
        "path_m": float(np.sum(np.linalg.norm(np.diff(track[::every], axis=0), axis=1))),
        "largest_speed_m_s": float(speed.max()),
        "detection": {key: value for key, value in found.items() if key != "history"},
        "history": {"time_s": time, "track_m": track, "speed_m_s": speed, "rest": rest, "detection": found["history"]},
    }


def report(result: dict[str, Any], inertial: dict[str, Any] | None = None) -> str:
    """The stops as a table, and how far from the start the track ends; inertial: the same run without updates."""
    rows = [
        (f"{stop['from_s']:.1f} to {stop['to_s']:.1f}", stop["speed_m_s"], stop["nis"], stop["from_start_m"])
        for stop in result["stops"]
    ]
    lines = [
        f"{result['recording']}: zero-velocity updates where the {result['detector'].replace('_', ' ')} declares rest",
        *table(("stop, s", "speed before, m/s", "NIS of 3", "from the start, m"), rows, ("", ".3f", ".1f", ".2f")),
    ]
    lines.append(
        f"path {result['path_m']:.1f} m, ends {result['end_from_start_m']:.2f} m from the start; there is no reference "
        "track, so that is plausibility only"
    )
    lines.append(
        f"gravity of {result['latitude_deg']:g} deg of latitude, updates below {result['sway_factor']:g} times the "
        "threshold; [stops] of the description says others"
    )
    if result["gaps_s"]:
        lines.append(f"gaps or repeated time tags before {', '.join(f'{t:.2f} s' for t in result['gaps_s'])}")
    if inertial is not None:
        lines.append(f"without updates it ends {inertial['end_from_start_m']:.0f} m from the start")
    return "\n".join(lines)


def figures(result: dict[str, Any], sheets: Sheets) -> None:
    """Draw the track from above and the speed."""
    history = result["history"]
    with sheets(f"zero_velocity_{result['recording']}", 11.0, 4.5, nrows=1, ncols=2) as (drawing, (above, beside)):
        track = history["track_m"]
        above.plot(track[:, 0], track[:, 1], color=BLUE, lw=1, label="estimate")
        still = history["rest"]
        above.plot(track[still, 0], track[still, 1], ".", color=ORANGE, ms=4, label="declared at rest")
        above.set_aspect("equal", "datalim")
        above.set_xlabel("right of the first heading [m]")
        above.set_ylabel("ahead of it [m]")
        t = history["time_s"]
        beside.plot(t, history["speed_m_s"], color=BLUE, lw=0.8)
        top = float(history["speed_m_s"].max())
        beside.fill_between(t, 0, top, where=still, color=ORANGE, alpha=0.2, lw=0)  # as the dots of the track
        beside.set_xlabel("time [s]")
        beside.set_ylabel("speed [m/s]")
        drawing.legend(*above.get_legend_handles_labels(), loc="outside lower center", ncols=2)


def flown(asked: Replay, progress: Progress) -> dict[str, Any]:
    """`run` with updates and, beside it, without."""
    hold, strapdown = load("azimuth-hold"), load("strapdown")
    result = run(asked.recording, hold, strapdown, **asked.settings)
    progress("without updates")
    alone = run(asked.recording, hold, strapdown, **{**asked.settings, "updates": False})
    return {**result, "without_updates": {name: value for name, value in alone.items() if name != "history"}}


def detected(result: dict[str, Any]) -> dict[str, Any]:
    """What `stationary.run` returned."""
    return {**result["detection"], "history": result["history"]["detection"]}


def draw(result: dict[str, Any], sheets: Sheets) -> None:
    figures(result, sheets)
    stationary.figures(detected(result), sheets)


STUDY = Study(
    "replay azimuth-hold", ("azimuth-hold", "strapdown"), Replay, flown,
    lambda result: f"{stationary.report(detected(result))}\n\n{report(result, result['without_updates'])}", draw,
)  # fmt: skip
