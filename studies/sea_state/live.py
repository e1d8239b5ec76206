"""The same flights by the live loop of the generated C, run by run: it compares at the message's own instant."""

from collections.abc import Callable
from typing import Any

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.headings import Headings
from boresight.runtime.live import Live
from boresight.studies.sea_state import flight as at_sea

US = 1_000_000
COARSE = {"phi": 0.1, "dv_n": 3.0}  # rad, m/s: the first messages decide
RULES = {"oldest_us": US // 2, "ahead_us": US // 2, "astray": 0, "gate": 0.0}  # nothing is refused


def fly(model: Any, came: at_sea.Signals, scenario: at_sea.Scenario, bank: bool = False) -> at_sea.Flight:
    """Every case and run by a loop of its own, the delay a state; axes (U + 1, cases, runs, ...).

    bank: `Headings` flies, without the master's heading; then nis is none.  The last message is not used.
    """
    s, shape = scenario, came.v_m_n.shape[1:3]
    given = at_sea.constants(s)
    lever_b, R = given.pop("lever_b"), at_sea.matching_variances(s)
    kind: Callable[..., Any] = Headings if bank else Live
    rules = RULES | {"every": s.navigation_hz // s.covariance_hz}
    loops = {place: kind(model, rules, **given) for place in np.ndindex(*shape)}
    sigmas, _ = at_sea.believed(s, at_sea.Belief())
    spread = COARSE | {f"d_{name}": sigmas[name] for name in ("gyro_bias", "accel_bias", "tau")}
    euler = rotation.euler_from_matrix(rotation.matrix_from_quaternion(came.q_m2n_wxyz))
    place_n = np.broadcast_to(came.true.slave.position[0], (*shape, 3))
    for at, loop in loops.items():
        nav = {"lat_lon_height": place_n[at], "v_n": came.v_m_n[0][at], "q_b2n_wxyz": came.q_m2n_wxyz[0][at],
               "q_b2m_wxyz": np.eye(4)[0]}  # fmt: skip
        loop.begin(0, nav, **spread, dmu=sigmas["q_b2m_wxyz"])

    samples = s.navigation_hz // s.update_hz
    interval = US * np.arange(1 - samples, 1) // s.navigation_hz
    error, sigma, nis = [], [], []
    for update in range(len(came.v_m_n)):
        at_us = update * US // s.update_hz
        if update:
            increments = np.moveaxis(came.increments(update), 0, -2)
            nis.append([step(loop, at_us + interval, increments[at], s) for at, loop in loops.items()])
        out = {at: loop.output(at_us) for at, loop in loops.items()}
        nav = {name: np.array([one[name] for one in out.values()]).reshape(*shape, *value.shape)
               for name, value in out[0, 0].items()}  # fmt: skip
        error.append(came.error(nav, update))
        sigma.append(nav["sigma"])
        for at, loop in loops.items() if update else ():
            if bank:
                loop.message("euler", at_us, R[3:], rows=3, euler_m=euler[update][at] * [1.0, 1.0, 0.0])
            else:
                loop.message("dcm", at_us, R[3:], q_m2n_wxyz=came.q_m2n_wxyz[update][at])
            loop.message("velocity", at_us, R[:3], v_m_n=came.v_m_n[update][at], lever_b=lever_b)
    P = [(loop.likeliest if bank else loop).covariance()[0] for loop in loops.values()]
    nis_of = np.array(nis).reshape(-1, *shape, 2)
    return at_sea.Flight(
        np.array(error), np.array(sigma), np.array(P).reshape(*shape, 16, 16), nis_of, np.full(nis_of.shape[:-1], 6),
        np.zeros(shape, bool), came.drawn.delay, s.update_hz,
    )  # fmt: skip


def step(loop: Any, ends_us: Array, increments: Array, s: at_sea.Scenario) -> list[float]:
    """Fly an interval (T, 6); the NIS of the attitude and of the velocity that are judged in it, NaN of a bank."""
    dt, found = 1 / s.navigation_hz, [np.nan, np.nan]
    sensed = {"dtheta_ib_b": increments[:, :3], "dv_b": increments[:, 3:]}
    if isinstance(loop, Headings):
        for k, end_us in enumerate(ends_us):
            loop.sample(int(end_us), dt, **{name: value[k] for name, value in sensed.items()})
        return found
    k, count = 0, loop.measured().get("count", 0)
    while k < len(ends_us) and np.isnan(found).any():
        loop.sample(ends_us[k], dt, background=False, **{name: value[k] for name, value in sensed.items()})
        while loop.background():
            if (one := loop.measured()) and one["count"] != count:
                count, found[one["measurement"] == "velocity"] = one["count"], one["nis"]
        k += 1
    loop.sample(ends_us[k:], dt, **{name: value[k:] for name, value in sensed.items()})
    return found
