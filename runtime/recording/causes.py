"""What was done to a velocity or a position, and where turns change at an instant; explain.py has the other turns."""

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.recording.types import Inertial, Master

FITS = 0.1  # of what is to be explained, that may be left


def turned_between(time: Array, gyro: Array, ends: Array) -> Array:
    """(K, 3) sums of rates (N, 3) at `time` between neighbours of `ends` (K + 1,), as if small."""
    angle = np.cumsum(gyro * np.gradient(time)[:, None], axis=0)
    return np.diff(np.stack([np.interp(ends, time, part) for part in angle.T], axis=-1), axis=0)


def factor(imu: Inertial, master: Master) -> float:
    """By how much more the slave turns than its master, 0 where they do not turn alike."""
    C = rotation.matrix_from_euler(master.euler)
    turn = rotation.vector_from_matrix(np.swapaxes(C[:-1], -1, -2) @ C[1:])
    slave = turned_between(imu.time, imu.rates()[0], master.time)
    x, y = ((part - part.mean(axis=0)).ravel() for part in (turn, slave))
    alike = float(x @ y) / np.sqrt(float(x @ x) * float(y @ y) + 1e-300)
    return float(x @ y) / float(x @ x) if alike > 0.9 else 0.0


def of_track(master: Master) -> str:
    """By how much the level velocity is turned against the track, where nothing else differs; "" where it is not."""
    assert master.v_n is not None and master.position is not None
    lat, lon, height = master.position.T
    moved = np.diff(np.column_stack([lat, lon * np.cos(lat[0])]) * (6371e3 + height[0]), axis=0)
    v = (master.v_n[1:, :2] + master.v_n[:-1, :2]) / 2 * np.diff(master.time)[:, None]
    track, speed = moved[:, 0] + 1j * moved[:, 1], v[:, 0] + 1j * v[:, 1]
    factor = np.vdot(track, speed) / max(np.vdot(track, track).real, 1e-300)
    rest = float(np.sum(np.abs(speed - factor * track) ** 2) / max(np.sum(np.abs(speed) ** 2), 1e-300))
    angle, unsure = float(np.degrees(np.angle(factor))), float(np.degrees(np.sqrt(rest / max(len(track) - 1, 1))))
    if rest > FITS / 2 or abs(angle) < max(4, 5 * unsure) or abs(abs(factor) - 1) > 0.05:
        return ""
    return f"the velocity is turned by {angle:.1f} deg against the track of the position: grid or magnetic north"


def of_velocity(master: Master) -> str:
    """What was done to the velocity or the position, so that one is the sum of the other where it is undone."""
    assert master.v_n is not None and master.position is not None
    lat, lon, height = master.position.T
    place = np.column_stack([lat, lon * np.cos(lat[0]), np.zeros_like(lat)]) * (6371e3 + height[0])
    place[:, 2] = -height
    swapped = np.column_stack([lon, lat * np.cos(lon[0]), np.zeros_like(lat)]) * (6371e3 + height[0])
    swapped[:, 2] = -height
    C, v = rotation.matrix_from_euler(master.euler), master.v_n
    # the Earth's axes turned to north, east and down: about z by the longitude, about y by latitude and a right angle
    south = np.stack([0 * lat, -lat - np.pi / 2, lon], axis=-1)
    earth = np.einsum("kji,kj->ki", rotation.matrix_from_euler(south), v)
    tried = {
        "a velocity of the body declared as one of navigation (axes)": (place, np.einsum("kij,kj->ki", C, v)),
        "a velocity of navigation declared as one of the body (axes)": (place, np.einsum("kji,kj->ki", C, v)),
        "north and east are exchanged and up is down: ENU declared as NED": (place, v[:, [1, 0, 2]] * [1, 1, -1]),
        "east has the other sign and up is down: NWU declared as NED": (place, v * [1, -1, -1]),
        "north and east are exchanged in the velocity": (place, v[:, [1, 0, 2]]),
        "latitude and longitude are exchanged": (swapped, v),
        "the sign of the latitude is lost": (place * [-1, 1, 1], v),
        "the sign of the longitude is lost": (place * [1, -1, 1], v),
        "the velocity is one of the Earth's axes, x, y, z of ECEF, declared as NED": (place, earth),
        "north of the velocity has the other sign": (place, v * [-1, 1, 1]),
        "east of the velocity has the other sign": (place, v * [1, -1, 1]),
    }
    dt = np.diff(master.time)[:, None]
    rest = {}
    for name, (at, speed) in tried.items():
        moved = np.diff(at, axis=0)
        rest[name] = float(np.sum((moved - (speed[1:] + speed[:-1]) / 2 * dt) ** 2) / np.sum(moved**2))
    best = min(rest.values())
    return " or ".join(name for name in tried if rest[name] < 1.1 * best) if best < FITS else ""  # both, where two fit
