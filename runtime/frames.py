"""Converters at the border: axes, yaw signs and attitudes of other people's data to NED and front-right-down (FRD).

Inside, everything is NED with FRD.  A frame is named by its three axes in order: FRD, RFU, FLU, ... for a body,
NED, ENU, NWU, ... for navigation.
"""

from collections.abc import Sequence
from itertools import permutations
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array

BODY = {"F": (0, 1.0), "B": (0, -1.0), "R": (1, 1.0), "L": (1, -1.0), "D": (2, 1.0), "U": (2, -1.0)}
NAVIGATION = {"N": (0, 1.0), "S": (0, -1.0), "E": (1, 1.0), "W": (1, -1.0), "D": (2, 1.0), "U": (2, -1.0)}
AXES = ("front", "right", "down")
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
    T = _signed(frame, letters)
    if np.linalg.det(T) != 1.0:
        text = f"{frame!r} is not a right-handed {kind} frame; name its three axes, as {examples}"
        if np.linalg.det(T) == -1.0 and kind == "navigation":
            order = " ".join(WORDS[letter] for letter in frame)
            text += f'; where columns are in this order, keep a right-handed frame and add order = "{order}" to them'
        raise BoresightError(text)
    return T


WORDS = {"N": "north", "S": "south", "E": "east", "W": "west", "U": "up", "D": "down",
         "F": "front", "B": "back", "R": "right", "L": "left"}  # fmt: skip


def columns_to_ned(order: str) -> Array:
    """(3, 3) matrix that takes columns in an order such as "north east up", left-handed or not, to NED."""
    return _columns(order, NAVIGATION, "north east up")


def columns_to_frd(order: str) -> Array:
    """(3, 3) matrix that takes columns in an order such as "front right up", left-handed or not, to FRD."""
    return _columns(order, BODY, "front right up")


def _signed(frame: str, letters: dict[str, tuple[int, float]]) -> Array:
    """(3, 3) of the signs of three letters; of no full rank where they are not three axes."""
    T = np.zeros((3, 3))
    if len(frame) == 3 and set(frame) <= set(letters):
        for column, letter in enumerate(frame):
            row, sign = letters[letter]
            T[row, column] = sign
    return T


def _columns(order: str, letters: dict[str, tuple[int, float]], example: str) -> Array:
    known = {WORDS[letter]: letter for letter in letters}
    T = _signed("".join(known.get(word, "?") for word in order.lower().split()), letters)
    if abs(np.linalg.det(T)) != 1.0:
        raise BoresightError(
            f"the order {order!r} must name three different axes, as {example!r}; of {', '.join(known)}"
        )
    return T


def every_body() -> dict[str, Array]:
    """The 24 right-handed body frames by name, each with its matrix to FRD."""
    names = ["".join(name) for name in permutations(BODY, 3)]
    return {name: body_to_frd(name) for name in names if np.linalg.det(_signed(name, BODY)) == 1.0}


def every_order() -> dict[str, Array]:
    """The 48 orders of columns by name, as "north east up", each with its matrix to NED."""
    signed = {name: _signed("".join(name), NAVIGATION) for name in permutations(NAVIGATION, 3)}
    return {" ".join(WORDS[letter] for letter in name): T for name, T in signed.items() if np.linalg.det(T) != 0.0}


def euler_from_angles(
    angles: Any,
    order: Sequence[str] = ANGLES,
    yaw_positive: str = "clockwise",
    pitch_positive: str = "up",
    yaw_from: str = "north",
) -> Array:
    """Roll, pitch, yaw in NED/FRD from three angles in any order of columns and other signs.

    angles: (..., 3) rad, columns named by order, applied as yaw first, then pitch, then roll.  A roll is positive with
    the right side down.  yaw_positive: "clockwise" or "counter-clockwise", seen from above; yaw_from: "north" or
    "east", where it is zero; pitch_positive: "up" or "down", where the nose goes.
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
    if yaw_from == "east":
        yaw = yaw + np.pi / 2
    if pitch_positive == "down":
        pitch = -pitch
    return np.stack([roll, pitch, (yaw + np.pi) % (2 * np.pi) - np.pi], axis=-1)


def angles_from_euler(euler: Any, order: Sequence[str] = ANGLES, yaw_positive: str = "clockwise") -> Array:
    """The way back of euler_from_angles: (..., 3) rad, columns in ORDER."""
    flipped = euler_from_angles(euler, ANGLES, yaw_positive)  # its own inverse in this order of columns
    return np.stack([flipped[..., ANGLES.index(name)] for name in order], axis=-1)


def attitude_to_ned(C: Any, body: str, navigation: str) -> Array:
    """(..., 3, 3) FRD-to-NED from C, which takes BODY components to NAVIGATION components."""
    return navigation_to_ned(navigation) @ np.asarray(C, float) @ body_to_frd(body).T
