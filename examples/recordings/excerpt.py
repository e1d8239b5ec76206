"""Cut the excerpts in this folder from the whole files, which are not shipped: python excerpt.py FOLDER_OF_THE_FILES

What was left out and rounded stands in CREDITS.txt.
"""

import sys
from pathlib import Path
from struct import unpack_from

import numpy as np
import pandas as pd
from scipy.io import loadmat, savemat

HERE = Path(__file__).parent
# topic: every how many of its messages
TOPICS = {
    "sensor_combined": 1, "vehicle_land_detected": 1, "vehicle_gps_position": 1, "vehicle_air_data": 1,
    "vehicle_magnetometer": 1,
    "vehicle_attitude": 8, "vehicle_local_position": 20, "estimator_states": 20,
    "vehicle_attitude_groundtruth": 10, "vehicle_local_position_groundtruth": 10,
}  # fmt: skip


def walk(whole: Path, out: Path) -> None:
    """Time in us as a whole number, deg/s to two decimals and g to four: below the sensor's noise by ten."""
    rows = pd.read_csv(whole).to_numpy()
    gyro, accel = np.round(rows[:, 1:4], 2).astype(np.float32), np.round(rows[:, 4:], 4).astype(np.float32)
    np.savez_compressed(out, time_us=np.round(rows[:, 0] * 1e6).astype(np.int32), gyro_deg_s=gyro, accel_g=accel)


def breaks(whole: Path, out: Path, begin_s: float, end_s: float) -> None:
    """A part of it in single precision, and the label; arrays named as in the whole file."""
    held = loadmat(whole, squeeze_me=True)
    part = slice(*(round(t * held["sampling_rate"]) for t in (begin_s, end_s)))
    arrays = {name: held[name][part].astype(np.float32) for name in ("imu_gyr", "imu_acc")}
    arrays |= {"movement": held["movement"][part], "sampling_rate": held["sampling_rate"]}
    savemat(out, arrays, do_compression=True)


def log(whole: Path, out: Path) -> None:
    """The definitions and parameters, and of the messages those of TOPICS."""
    raw, at, names, count = whole.read_bytes(), 16, {}, dict.fromkeys(TOPICS, 0)
    parts = [raw[:16]]
    while at < len(raw):
        size, kind = unpack_from("<Hc", raw, at)
        body = raw[at + 3 : at + 3 + size]
        keep = kind in b"BFPI" and (kind != b"F" or body.split(b":")[0].decode() in TOPICS)
        if kind == b"A":
            name, instance = body[3:].decode(), body[0]
            if keep := name in TOPICS and instance == 0:
                names[unpack_from("<H", body, 1)[0]] = name
        elif kind == b"D" and (name := names.get(unpack_from("<H", body)[0])):
            keep = count[name] % TOPICS[name] == 0
            count[name] += 1
        parts += [raw[at : at + 3 + size]] if keep else []
        at += 3 + size
    out.write_bytes(b"".join(parts))


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    walk(folder / "xio_foot_short_walk.csv", HERE / "walk.npz")
    breaks(folder / "broad_14_slow_translation_with_breaks_B.mat", HERE / "breaks.mat", 74.0, 115.5)
    log(folder / "pyulog_sample_tagged.ulg", HERE / "pad.ulg")
