"""Motions by name, and what the functions of a model are called with along them: nominal, without a random error.

    still, straight, "s turn", "figure of eight", "sea 4"      `motion(name, time)`, a `hull.Pose` (T, 1, ...)

Euler angles are roll, pitch, yaw; n is NED.  Axes of arrays: time first, then one case, then components.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from boresight.errors import BoresightError, did_you_mean
from boresight.runtime import frames, rotation
from boresight.runtime.array import Array
from boresight.runtime.simulation import hull, sea, sensors
from boresight.runtime.units import DEG, STANDARD_GRAVITY

RADIUS_M = 6371e3  # enough for a rate of transport
HEIGHT_M = (
    0.01,
    0.1,
    0.5,
    1.25,
    2.5,
    4.0,
)  # of sea states 1 to 6, as Kang 2025: the lower ends of the WMO code 3700
WAVES_TO = 135.0 * DEG  # where the waves run to, from the bow


def ramp(time: Array, begin_s: float, length_s: float, height: float) -> Array:
    """From 0 to `height` by half a cosine."""
    return height * (1 - np.cos(np.pi * np.clip((time - begin_s) / length_s, 0, 1))) / 2


def underway(time: Array, heading: Any = 0.0, speed: Any = 0.0, roll: Any = 0.0) -> hull.Pose:
    """A level course along where the bow points, (T, 1, ...): rad and m/s at these times, or constant."""
    psi, u, phi = (np.broadcast_to(np.asarray(part, float), time.shape) for part in (heading, speed, roll))
    zero = np.zeros_like(time)
    euler = np.stack([phi, zero, psi], axis=-1)
    v_n = u[:, None] * np.stack([np.cos(psi), np.sin(psi), zero], axis=-1)

    def change(values: Array) -> Array:
        rate: Array = np.gradient(values, time, axis=0, edge_order=2)
        return rate

    parts = (
        np.cumsum(v_n, axis=0) * (time[1] - time[0]),
        v_n,
        change(v_n),
        rotation.quaternion_from_euler(euler),
        *hull.body_rates(euler, change(euler), change(change(euler))),
    )
    return hull.Pose(time, *(part[:, None] for part in parts))


def swinging(time: Array, period_s: float = 8.0, phase_deg: Any = 0.0, **amplitude: float) -> hull.Pose:
    """Sinusoids of the freedoms named, in m and degrees, of one period: (T, 1, ...).  phase_deg: of the pitch."""
    size = np.array([amplitude.get(name, 0.0) * (1.0 if i < 3 else DEG) for i, name in enumerate(hull.FREEDOMS)])
    phase = np.where(np.array(hull.FREEDOMS) == "pitch", phase_deg * DEG, 0.0)
    return hull.ride(hull.sinusoids(size[None], phase[None], np.array([1 / period_s])), time)


def s_turn(time: Array, speed: float = 100.0, swing: float = 30 * DEG, period_s: float = 60.0) -> hull.Pose:
    """An aircraft's: the heading swings to either side and the bank keeps the turn coordinated."""
    omega = 2 * np.pi / period_s
    rate = swing * omega * np.cos(omega * time)
    return underway(time, swing * np.sin(omega * time), speed, np.arctan(speed * rate / STANDARD_GRAVITY))


def in_sea(time: Array, grade: int, seed: int = 0) -> hull.Pose:
    """A hull of 40 m in a Pierson-Moskowitz sea of this state, waves from the port quarter ahead, (T, 1, ...)."""
    omega, elevation = sea.components(np.array([HEIGHT_M[grade - 1]]))
    phases = hull.phases([sensors.generator(seed, 0)], omega.shape[-1])
    heading = np.array(30 * DEG)
    motion = hull.in_sea(hull.Hull(), omega, elevation, phases, towards=heading + WAVES_TO, heading=heading)
    return hull.ride(motion, time)


MOTIONS: dict[str, Callable[[Array], hull.Pose]] = {
    "still": underway,
    "straight": lambda time: underway(time, 0.5, 100.0),
    "s turn": s_turn,
    "steady turn": lambda time: underway(time, 3 * DEG * time, 100.0, np.arctan(300 * DEG / STANDARD_GRAVITY)),
    "figure of eight": lambda time: underway(time, np.pi * (1 - np.cos(2 * np.pi * time / 120)), 5.0),
    "yaw 3 deg": lambda time: swinging(time, yaw=3.0),
    "roll 3 deg": lambda time: swinging(time, roll=3.0),
    "pitch 3 deg": lambda time: swinging(time, pitch=3.0),
    **{f"sea {grade}": partial(in_sea, grade=grade) for grade in range(1, 7)},
}


def motion(name: str, time: Array) -> hull.Pose:
    """The motion of this name at these times, s.  Raises BoresightError with the list for another name."""
    plain = name.strip().lower().replace("-", " ")
    if plain not in MOTIONS:
        raise BoresightError(f"no motion {name!r}{did_you_mean(plain, MOTIONS)}; there are {', '.join(MOTIONS)}")
    return MOTIONS[plain](time)


def inputs_along(
    master: hull.Pose, slave: hull.Pose, position: Any, lever_b: Any, frame: str = "NED"
) -> dict[str, Array]:
    """Inputs of the models' functions along a motion, by name, (T, size) or (T,): true, and with errors of zero.

    master, slave: (T, 1, ...) or (T, ...).  position: (3,) latitude and longitude in rad, height in m.  frame: "NED"
    with FRD, or "ENU" with RFU.  The specific force leaves out Coriolis: 1e-2 m/s^2 at 100 m/s.
    """

    def row(values: Array) -> Array:
        return values[:, 0] if values.ndim == 3 else values

    turn_n, turn_b = (np.eye(3), np.eye(3)) if frame == "NED" else (
        frames.navigation_to_ned("ENU").T, frames.body_to_frd("RFU").T)  # fmt: skip
    lat, lon, height = np.asarray(position, float)
    C_m2n, C_b2n = (rotation.matrix_from_quaternion(row(pose.q_b2n_wxyz)) for pose in (master, slave))
    v_n, a_n = row(slave.v_n), row(slave.a_n)
    zero = np.zeros_like(v_n[:, 0])
    transport = np.stack([v_n[:, 1], -v_n[:, 0], -v_n[:, 1] * np.tan(lat)], axis=-1) / RADIUS_M
    omega_in_n = sensors.earth_rate_n(float(lat)) + transport
    f_n = a_n - np.array([0.0, 0.0, STANDARD_GRAVITY])

    def to_b(vector_n: Array) -> Array:
        return np.einsum("tji,tj->ti", C_b2n, vector_n)

    def level(vector_n: Array) -> Array:
        return vector_n @ turn_n.T

    def body(vector_b: Array) -> Array:
        return vector_b @ turn_b.T

    def attitude(C: Array) -> Array:
        return rotation.quaternion_from_matrix(turn_n @ C @ turn_b.T)

    here = np.broadcast_to([lat, lon, height], v_n.shape)
    ones = np.ones_like(zero)[:, None]
    return {
        "lat_lon_height": here, "lon_lat_height": here[:, [1, 0, 2]], "lat": here[:, 0], "height": here[:, 2],
        "v_n": level(v_n), "v_m_n": level(row(master.v_n)), "a_n": level(row(master.a_n)),
        "q_b2n_wxyz": attitude(C_b2n), "q_m2n_wxyz": attitude(C_m2n), "q_ref_wxyz": attitude(C_b2n),
        "q_b2m_wxyz": rotation.quaternion_from_matrix(turn_b @ np.swapaxes(C_m2n, -1, -2) @ C_b2n @ turn_b.T),
        "mu": rotation.vector_from_matrix(np.swapaxes(C_m2n, -1, -2) @ C_b2n) @ turn_b.T,
        "euler_b": rotation.euler_from_matrix(C_b2n), "euler_m": rotation.euler_from_matrix(C_m2n),
        "f_b": body(to_b(f_n)), "f_n": level(f_n), "omega_in_n": level(omega_in_n),
        "omega_ib_b": body(row(slave.omega_nb_b) + to_b(omega_in_n)),
        "omega_nm_n": level(np.einsum("tij,tj->ti", C_m2n, row(master.omega_nb_b))),
        "lever_b": ones * (np.asarray(lever_b, float) @ turn_b.T), "lag": zero, "tau": zero,
    }  # fmt: skip
