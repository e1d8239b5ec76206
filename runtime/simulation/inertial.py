"""Inertial increments of a trajectory, by inverting the strapdown integrator, and the integrator over a trajectory.

`step` is the integrator in the wanted frame: `load("strapdown").step`, or `strapdown` of a model that carries position,
velocity and attitude, whose bias estimates are then zero.  Positions are in its order.  Axes: samples first, then runs.
`dtheta_ib_b` (rad) and `dv_b` (m/s) belong to the interval that ends at the sample behind them.
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
ENOUGH = 1e-14  # rad, and the same part of the velocity increments (m/s): rounding


@dataclass(frozen=True)
class Trajectory:
    """position (T+1, ..., 3), v_n (T+1, ..., 3) m/s, q_b2n_wxyz (T+1, ..., 4), at samples dt seconds apart."""

    position: Array
    v_n: Array
    q_b2n_wxyz: Array
    dt: float

    def nav(self, samples: int | slice) -> dict[str, Array]:
        """The fields of the integrator at these samples."""
        return {name: getattr(self, name)[samples] for name in ("position", "v_n", "q_b2n_wxyz")}


def before(increments: Array, first: Array | None) -> Array:
    """Of each interval the increments of the one before; those before the first are `first`, or the first ones."""
    return np.concatenate([increments[:1] if first is None else np.asarray(first, float)[None], increments[:-1]])


def intervals(dtheta: Array, dv: Array, last: tuple[Array, Array] | None = None) -> dict[str, Array]:
    """The increments of T intervals as fields of the integrator.  last: those of the interval before, if known."""
    earlier = [before(values, first) for values, first in zip((dtheta, dv), last or (None, None), strict=True)]
    return {"dtheta_ib_b": dtheta, "dv_b": dv, "dtheta_before": earlier[0], "dv_before": earlier[1]}


def unbiased(step: Unit) -> dict[str, Array]:
    """The bias estimates that the integrator reads, zero."""
    return {name: np.zeros(3) for name in ("gyro_bias", "accel_bias") if name in step.fields}


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
    v_n, q = np.asarray(v_n, float), np.asarray(q_b2n_wxyz, float)
    runs = v_n.shape[1:-1]
    p0 = np.broadcast_to(np.asarray(position, float), (*runs, 3))
    p = np.broadcast_to(p0, (len(v_n), *runs, 3)).copy()
    dtheta, dv = np.zeros(v_n[1:].shape), np.zeros(v_n[1:].shape)
    to_body = np.swapaxes(matrix_from_quaternion(q[:-1]), -1, -2)
    turn, push, gone = np.empty_like(dtheta), np.empty_like(dtheta), np.empty_like(dtheta)
    at_a_time = max(1, TOGETHER // math.prod(runs))
    for _ in range(ROUNDS):
        fields = intervals(dtheta, dv)
        for k in range(0, len(dtheta), at_a_time):
            part = slice(k, k + at_a_time)
            made = step(
                position=p[:-1][part], v_n=v_n[:-1][part], q_b2n_wxyz=q[:-1][part],
                **{name: values[part] for name, values in fields.items()}, **unbiased(step), dt=dt,
            )  # fmt: skip
            # C_made = exp(-[e x]) C_wanted: the body has to turn by e more, here in its own axes
            turn[part] = rotated(to_body[part], attitude_error(made["q_b2n_wxyz"], q[1:][part]))
            push[part] = rotated(to_body[part], v_n[1:][part] - made["v_n"])
            gone[part] = made["position"] - p[:-1][part]
        # one position after the other, as the integrator adds them up
        moved = np.cumsum(np.concatenate([p0[None], gone]), axis=0)
        away = max(np.abs(turn).max(), np.abs(push).max() / max(1.0, np.abs(v_n).max()), np.abs(moved - p).max() * 1e-3)
        dtheta, dv, p = dtheta + turn, dv + push, moved
        if away < ENOUGH:
            # The last bit of a longitude is 3e-9 m: the positions are those of a run, to the bit.
            start = {"position": p0, "v_n": v_n[0], "q_b2n_wxyz": q[0]}
            return dtheta, dv, Trajectory(integrate(step, start, dtheta, dv, dt).position, v_n, q, dt)
    raise BoresightError(
        f"no increments make this trajectory: after {ROUNDS} rounds {away:.1e} rad are left; sample it more often than "
        f"every {dt} s"
    )


def integrate(step: Unit, start: dict[str, Array], dtheta: Array, dv: Array, dt: float, first=None) -> Trajectory:
    """The integrator over T intervals.  start: position, v_n, q_b2n_wxyz at the first sample, (..., 3 or 4).

    first: (dtheta, dv) of the interval before the first one, if it is known.  Raises BoresightError on leaving the box.
    """
    dtheta, dv = np.asarray(dtheta, float), np.asarray(dv, float)
    shape = dtheta.shape[1:-1]
    out = {
        name: np.empty((len(dtheta) + 1, *shape, size))
        for name, size in (("position", 3), ("v_n", 3), ("q_b2n_wxyz", 4))
    }
    for name, values in out.items():
        values[0] = start[name]
    fields, none = intervals(dtheta, dv, first), unbiased(step)
    bound = step.bind(shape)
    bound.inputs["dt"][:] = dt
    for name, values in none.items():
        bound.inputs[name][:] = values
    given = [(bound.inputs[name], values) for name, values in (out | fields).items()]
    made = [(bound.outputs[name], values) for name, values in out.items()]
    for k in range(len(dtheta)):
        for view, values in given:
            view[...] = values[k]
        if bound():
            step(**{name: values[k] for name, values in (out | fields).items()}, **none, dt=dt)
        for view, values in made:
            values[k + 1] = view
    return Trajectory(**out, dt=dt)
