"""Inertial increments of a trajectory, by inverting the strapdown integrator, and the integrator over a trajectory.

`step` is the integrator in the wanted frame: `load("strapdown").step`, or `strapdown` of a model that carries position,
velocity and attitude, whose estimates of sensor errors are then zero.  Positions are in its order.  Axes: samples
first, then runs.  `dtheta_ib_b` (rad) and `dv_b` (m/s) belong to the interval that ends at the sample behind them.
"""

import math
from dataclasses import dataclass

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.library import Unit
from boresight.runtime.rotation import attitude_error, matrix_from_quaternion

ROUNDS = 30  # of the inversion; each shrinks what is left by the angle turned in a step or more
TOGETHER = 8192  # intervals of all runs in one call: what the processor's cache holds
PLACES = ("lat_lon_height", "lon_lat_height")  # the integrator's position, named for the order of its coordinates
READ = (*PLACES, "v_n", "q_b2n_wxyz", "dtheta_ib_b", "dv_b", "dtheta_before", "dv_before", "dt")
ENOUGH = 1e-14  # rad, and the same part of the velocity increments (m/s): rounding


@dataclass(frozen=True)
class Trajectory:
    """position (T+1, ..., 3), v_n (T+1, ..., 3) m/s, q_b2n_wxyz (T+1, ..., 4), at samples dt seconds apart.

    place: what the integrator calls the position, lat_lon_height or lon_lat_height (rad, rad, m).
    """

    position: Array
    v_n: Array
    q_b2n_wxyz: Array
    dt: float
    place: str

    def nav(self, samples: int | slice) -> dict[str, Array]:
        """The fields of the integrator at these samples."""
        values = {self.place: self.position, "v_n": self.v_n, "q_b2n_wxyz": self.q_b2n_wxyz}
        return {name: value[samples] for name, value in values.items()}


def place_of(step: Unit) -> str:
    """What the integrator calls the position: lat_lon_height or lon_lat_height."""
    return next(name for name in PLACES if name in step.fields)


def before(increments: Array, first: Array | None) -> Array:
    """Of each interval the increments of the one before; those before the first are `first`, or the first ones."""
    known = increments[:1] if first is None else np.broadcast_to(first, (1, *increments.shape[1:]))
    return np.concatenate([known, increments[:-1]])


def intervals(dtheta: Array, dv: Array, last: tuple[Array, Array] | None = None) -> dict[str, Array]:
    """The increments of T intervals as fields of the integrator.  last: those of the interval before, if known."""
    earlier = [before(values, first) for values, first in zip((dtheta, dv), last or (None, None), strict=True)]
    return {"dtheta_ib_b": dtheta, "dv_b": dv, "dtheta_before": earlier[0], "dv_before": earlier[1]}


def ideal(step: Unit) -> dict[str, Array]:
    """What else the integrator reads, as errors of sensors: zero, or the value of its box that is nearest to zero."""
    boxes = {name: step.library.field[name] for name in step.fields if name not in READ}
    return {name: np.clip(np.zeros(box["size"]), box["low"], box["high"]) for name, box in boxes.items()}


def rotated(C: Array, vector: Array) -> Array:
    """C (..., 3, 3) times (..., 3)."""
    out: Array = np.einsum("...ij,...j->...i", C, vector)
    return out


def increments(step: Unit, position: Array, v_n: Array, q_b2n_wxyz: Array, dt: float) -> tuple:
    """What ideal sensors deliver on a trajectory: (dtheta (T, ..., 3) rad, dv (T, ..., 3) m/s, the Trajectory).

    position: (..., 3) at the first sample.  v_n (T+1, ..., 3), q_b2n_wxyz (T+1, ..., 4): at every sample.  The
    increments are those from which the integrator makes these velocities and attitudes, to rounding; the positions of
    the Trajectory are the ones it makes with them.  Raises BoresightError where no increments of its box do, and on a
    trajectory that leaves it.
    """
    v_n, q, place = np.ascontiguousarray(v_n, float), np.ascontiguousarray(q_b2n_wxyz, float), place_of(step)
    runs, count = v_n.shape[1:-1], len(v_n) - 1
    p = np.empty((count + 1, *runs, 3))
    p[:] = position
    gone = p.copy()  # from one sample to the next, and first where it begins
    dtheta, dv = np.zeros_like(p), np.zeros_like(p)  # first those before the first ones, which are as these
    to_body = np.swapaxes(matrix_from_quaternion(q[:-1]), -1, -2)
    fastest = max(1.0, np.abs(v_n).max())
    at_a_time = max(1, TOGETHER // math.prod(runs))
    for _ in range(ROUNDS):
        dtheta[0], dv[0], away = dtheta[1], dv[1], 0.0
        # the last ones first: each is found by what the one before was at the beginning of the round
        for begin in reversed(range(0, count, at_a_time)):
            end = min(begin + at_a_time, count)
            now, then = slice(begin, end), slice(begin + 1, end + 1)
            made = step(
                **{place: p[now]}, v_n=v_n[now], q_b2n_wxyz=q[now], dtheta_ib_b=dtheta[then], dv_b=dv[then],
                dtheta_before=dtheta[now], dv_before=dv[now], **ideal(step), dt=dt,
            )  # fmt: skip
            # C_made = exp(-[e x]) C_wanted: the body has to turn by e more, here in its own axes
            turn = rotated(to_body[now], attitude_error(made["q_b2n_wxyz"], q[then]))
            dv_step = rotated(to_body[now], v_n[then] - made["v_n"])
            dtheta[then] += turn
            dv[then] += dv_step
            np.subtract(made[place], p[now], out=gone[then])
            away = max(away, np.abs(turn).max(), np.abs(dv_step).max() / fastest)
        # one position after the other, as the integrator adds them up
        moved = np.cumsum(gone, axis=0)
        away, p = max(away, np.abs(moved - p).max() * 1e-3), moved
        if away < ENOUGH:
            # The last bit of a longitude is 3e-9 m: the positions are those of a run, to the bit.
            start = {place: p[0], "v_n": v_n[0], "q_b2n_wxyz": q[0]}
            position = integrate(step, start, dtheta[1:], dv[1:], dt).position
            return dtheta[1:], dv[1:], Trajectory(position, v_n, q, dt, place)
    raise BoresightError(
        f"no increments make this trajectory: after {ROUNDS} rounds {away:.1e} rad are left; sample it more often than "
        f"every {dt} s"
    )


def integrate(step: Unit, start: dict[str, Array], dtheta: Array, dv: Array, dt: float, first=None) -> Trajectory:
    """The integrator over T intervals.  start: position, v_n, q_b2n_wxyz by their names at the first sample.

    dtheta, dv: (T, ..., 3), or (T, 3) where all runs have the same.  first: (dtheta, dv) of the interval before the
    first one, (..., 3) each, if it is known.  Raises BoresightError on other shapes, and on leaving the box.
    """
    dtheta, dv = np.asarray(dtheta, float), np.asarray(dv, float)
    count = len(np.atleast_1d(dtheta))
    for name, values in (("dtheta", dtheta), ("dv", dv)):
        if values.ndim < 2 or len(values) != count or values.shape[-1] != 3:
            raise BoresightError(f"integrate: {name} has shape {values.shape}; it must be (T, ..., 3), one T of both")
    if np.ndim(dt):
        raise BoresightError(f"integrate: dt has shape {np.shape(dt)}; give one number for all intervals")
    others, returned = ideal(step), {result["name"] for result in step.described["results"]}
    carried = place_of(step), "v_n", "q_b2n_wxyz", *(name for name in others if name in returned)
    one = {name: others[name] if name in others else start[name] for name in carried}
    one |= {"dtheta_ib_b": np.empty(dtheta.shape[1:]), "dv_b": np.empty(dv.shape[1:])}
    if first is not None:
        one |= {"dtheta_before": first[0], "dv_before": first[1]}
    begun, runs = step.library.arrange("integrate", one)
    # the axes of runs that all share stand behind that of the intervals
    axes = ((count, *(1,) * (len(runs) + 2 - values.ndim), *values.shape[1:]) for values in (dtheta, dv))
    spread = (values.reshape(shape) for values, shape in zip((dtheta, dv), axes, strict=True))
    dtheta, dv = (np.ascontiguousarray(np.broadcast_to(values, (count, *runs, 3))) for values in spread)
    out = {}
    for name in carried:
        out[name] = np.empty((count + 1, *runs, begun[name].shape[-1]))
        out[name][0] = begun[name]
    inputs = {**others, **out, **intervals(dtheta, dv, first), "dt": np.array([dt], float)}
    k = step.walk(inputs, {name: values[1:] for name, values in out.items()})
    if k < count:
        try:
            step(**{name: values[k] if values.ndim > 1 else values for name, values in inputs.items()} | {"dt": dt})
        except BoresightError as error:
            raise BoresightError(f"in interval {k}: {error}") from None
    position, v_n, q = (out[name] for name in carried[:3])
    return Trajectory(position, v_n, q, dt, carried[0])
