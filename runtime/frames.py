"""Converters at the border: axes, yaw signs and attitudes of other people's data to NED and front-right-down (FRD).

Inside, everything is NED with FRD.  A frame is named by its three axes in order: FRD, RFU, FLU, ... for a body,
NED, ENU, NWU, ... for navigation.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from boresight import BoresightError

Array = np.ndarray

BODY = {"F": (0, 1.0), "B": (0, -1.0), "R": (1, 1.0), "L": (1, -1.0), "D": (2, 1.0), "U": (2, -1.0)}
NAVIGATION = {"N": (0, 1.0), "S": (0, -1.0), "E": (1, 1.0), "W": (1, -1.0), "D": (2, 1.0), "U": (2, -1.0)}
ANGLES = ("roll", "pitch", "yaw")


def body_to_frd(frame: str) -> Array:
    """(3, 3) matrix that takes components in the body axes FRAME, such as "RFU", to FRD.

    Raises BoresightError for a name that is not three different axes of a right-handed frame.
    """
    return _triad(frame, BODY, "body", "FRD, RFU or FLU")


def navigation_to_ned(frame: str) -> Array:
    """(3, 3) matrix that takes components in the navigation axes FRAME, such as "ENU", to NED; raises likewise."""
    return _triad(frame, NAVIGATION, "navigation", "NED, ENU or NWU")


def _triad(frame: str, letters: dict[str, tuple[int, float]], kind: str, examples: str) -> Array:
    T = np.zeros((3, 3))
    if len(frame) == 3 and set(frame) <= set(letters):
        for column, letter in enumerate(frame):
            row, sign = letters[letter]
            T[row, column] = sign
    if np.linalg.det(T) != 1.0:
        raise BoresightError(f"{frame!r} is not a right-handed {kind} frame; name its three axes, as {examples}")
    return T


def euler_from_angles(angles: Any, order: Sequence[str] = ANGLES, yaw_positive: str = "clockwise") -> Array:
    """Roll, pitch, yaw in NED/FRD from three angles in any order of columns and either sign of yaw.

    angles: (..., 3) rad, columns named by order, applied as yaw first, then pitch, then roll.  Right side down and
    nose up are positive in every such convention (RFU in ENU as well as FRD in NED); only yaw's sign differs.
    yaw_positive: "clockwise" from north seen from above, or "counter-clockwise".
    Returns (..., 3) rad, yaw in [-pi, pi).
    """
    if sorted(order) != sorted(ANGLES):
        raise BoresightError(f"the order {' '.join(order)!r} must hold roll, pitch and yaw once each")
    if yaw_positive not in ("clockwise", "counter-clockwise"):
        raise BoresightError(f"yaw_positive is {yaw_positive!r}; it must be 'clockwise' or 'counter-clockwise'")
    angles = np.asarray(angles, float)
    roll, pitch, yaw = (angles[..., list(order).index(name)] for name in ANGLES)
    if yaw_positive == "counter-clockwise":
        yaw = -yaw
    return np.stack([roll, pitch, (yaw + np.pi) % (2 * np.pi) - np.pi], axis=-1)


def angles_from_euler(euler: Any, order: Sequence[str] = ANGLES, yaw_positive: str = "clockwise") -> Array:
    """The way back of euler_from_angles: (..., 3) rad, columns in ORDER."""
    flipped = euler_from_angles(euler, ANGLES, yaw_positive)  # its own inverse in this order of columns
    return np.stack([flipped[..., ANGLES.index(name)] for name in order], axis=-1)


def C_b2n_from_euler(euler: Any) -> Array:
    """(..., 3, 3) Rz(yaw) Ry(pitch) Rx(roll), FRD to NED, from (..., 3) rad roll, pitch, yaw."""
    (sr, sp, sy), (cr, cp, cy) = (np.moveaxis(f(np.asarray(euler, float)), -1, 0) for f in (np.sin, np.cos))
    rows = [
        [cp * cy, sr * sp * cy - cr * sy, cr * sp * cy + sr * sy],
        [cp * sy, sr * sp * sy + cr * cy, cr * sp * sy - sr * cy],
        [-sp, sr * cp, cr * cp],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def euler_from_C_b2n(C_b2n: Any) -> Array:
    """(..., 3) rad roll, pitch, yaw of (..., 3, 3); at a pitch of +-90 deg roll and yaw are one angle."""
    C = np.asarray(C_b2n, float)
    roll, yaw = np.arctan2(C[..., 2, 1], C[..., 2, 2]), np.arctan2(C[..., 1, 0], C[..., 0, 0])
    return np.stack([roll, -np.arcsin(np.clip(C[..., 2, 0], -1.0, 1.0)), yaw], axis=-1)


def C_from_wxyz(q_wxyz: Any) -> Array:
    """(..., 3, 3) of a Hamilton quaternion, scalar first, of any length but zero."""
    q = np.asarray(q_wxyz, float)
    q = q / np.linalg.norm(q, axis=-1, keepdims=True)
    w, x, y, z = np.moveaxis(q, -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def wxyz_from_euler(euler: Any) -> Array:
    """(..., 4) q_b2n_wxyz, scalar part not negative for |yaw| <= pi and |pitch|, |roll| <= pi/2."""
    half = np.asarray(euler, float) / 2
    (sr, sp, sy), (cr, cp, cy) = (np.moveaxis(f(half), -1, 0) for f in (np.sin, np.cos))
    parts = [
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    ]
    return np.stack(parts, axis=-1)


def attitude_to_ned(C: Any, body: str, navigation: str) -> Array:
    """(..., 3, 3) FRD-to-NED from C, which takes BODY components to NAVIGATION components."""
    return navigation_to_ned(navigation) @ np.asarray(C, float) @ body_to_frd(body).T


def rotation_vector(C: Any) -> Array:
    """(..., 3) rad: v with C = exp([v x]), for turns below 179 deg."""
    C = np.asarray(C, float)
    twice_sine = np.stack(
        [C[..., 2, 1] - C[..., 1, 2], C[..., 0, 2] - C[..., 2, 0], C[..., 1, 0] - C[..., 0, 1]], axis=-1
    )
    sine = np.linalg.norm(twice_sine, axis=-1, keepdims=True) / 2
    cosine = ((np.trace(C, axis1=-2, axis2=-1) - 1) / 2)[..., None]
    # angle / sine tends to 1 at zero, where the quotient itself is 0/0.
    scale = np.where(sine > 1e-9, np.arctan2(sine, cosine) / np.where(sine > 1e-9, sine, 1.0), 1.0)
    return twice_sine / 2 * scale


def C_from_rotation_vector(v: Any) -> Array:
    """(..., 3, 3) exp([v x]) of (..., 3) rad."""
    v = np.asarray(v, float)
    half = np.linalg.norm(v, axis=-1, keepdims=True) / 2
    # np.sinc(x) is sin(pi x) / (pi x): right at zero.
    return C_from_wxyz(np.concatenate([np.cos(half), v / 2 * np.sinc(half / np.pi)], axis=-1))
