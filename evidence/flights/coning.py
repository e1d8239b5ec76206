"""Coning and sculling at 5 Hz: what the strapdown step makes of it by two samples, and by four.

python -m boresight.evidence.flights.coning prints the table of docs/mechanics.md: 600 s at 50, 100 and 200 Hz.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from boresight.evidence.flights.motion import DEG, A, Motion, quaternion, turn_between, waves
from boresight.runtime.array import Array
from boresight.runtime.library import load

EARLIER = ("before", "second", "third")


def vibrating(seconds: float) -> Motion:
    """50 m/s at 40 N with swings of 10, 6, 20 deg; coning of .5 deg and sculling of .03 m/s at 5 Hz."""
    return Motion(
        place=np.array([40 * DEG, 0.2, 50.0]),
        swing=waves(
            ([10 * DEG, 6 * DEG, 20 * DEG], [0.11, 0.13, 0.05], [0.3, 1.2, 2.1]),
            ([0.5 * DEG, 0.5 * DEG, 0.0], 5.0, [0.0, np.pi / 2, 0.0]),
        ),
        steady=np.array([40.0, 30.0, 0.0]),
        sway=waves(([0.03, 0.03, 0.03], 5.0, [0.0, 0.7, 1.9])),
        seconds=seconds,
    )


def compensated(dtheta: Array, dv: Array, by: Callable[..., Any]) -> tuple[Array, Array]:
    """The increments (K, 3) as `by` makes them, which takes those of the step and of three before; K - 3 of them."""
    earlier = {f"{name}_{which}": part[2 - j : len(part) - 1 - j] for j, which in enumerate(EARLIER)
               for name, part in (("dtheta", dtheta), ("dv", dv))}  # fmt: skip
    made = by(dtheta_ib_b=dtheta[3:], dv_b=dv[3:], **earlier)
    return made["dtheta_ib_b"], made["dv_b"]


def errors(motion: Motion, rate_hz: float, seconds: float, by: Callable[..., Any] | None = None) -> Array:
    """(3, 3) at the end of a flight without sensor errors: attitude rad, velocity m/s, place m; north, east, down."""
    model, steps, zero = load("velocity-attitude"), round(seconds * rate_hz), np.array(0.0)
    dtheta, dv = motion.increments(np.arange(-3, steps + 1) / rate_hz)
    taken = (dtheta[3:], dv[3:]) if by is None else compensated(dtheta, dv, by)
    nav = {"lat_lon_height": motion.position(zero), "v_n": motion.velocity(zero)[0], "gyro_bias": np.zeros(3),
           "q_b2n_wxyz": quaternion(motion.C_b2n(zero)), "accel_bias": np.zeros(3)}  # fmt: skip
    for k in range(steps):
        nav |= model.strapdown(**nav, dtheta_ib_b=taken[0][k], dv_b=taken[1][k], dtheta_before=dtheta[k + 2],
                               dv_before=dv[k + 2], dt=1 / rate_hz)  # fmt: skip
    end = np.array(steps / rate_hz)
    place = (nav["lat_lon_height"] - motion.position(end)) * [A, A * np.cos(nav["lat_lon_height"][0]), -1.0]
    return np.stack([turn_between(nav["q_b2n_wxyz"], motion.C_b2n(end)), nav["v_n"] - motion.velocity(end)[0], place])


def main() -> None:
    seconds = 600.0
    motion = vibrating(seconds)
    print("| rate | samples | attitude deg | velocity mm/s N E D | position m N E D |\n|---|---|---|---|---|")
    for rate_hz in (50, 100, 200):
        for samples, by in ((2, None), (4, load("strapdown").compensated)):
            turned, v, place = errors(motion, rate_hz, seconds, by)
            listed = " ".join(f"{1e3 * one:.2f}" for one in v), " ".join(f"{one:.3f}" for one in place)
            print(f"| {rate_hz} Hz | {samples} | {np.linalg.norm(turned) / DEG:.1e} | {listed[0]} | {listed[1]} |")


if __name__ == "__main__":
    main()
