"""How old a master's data seems, by a look at the turns of both."""

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.recording.check import attitude_steps
from boresight.runtime.recording.types import Inertial, Master


def best_delay(imu: Inertial, master: Master, span: float = 0.1, step: float = 0.0025) -> tuple[float, float]:
    """s, how old the master's data seems (within +-span), and how many times smaller the misfit is than at zero.

    The slave's turns are regressed on the master's (all three axes and a bias, so misalignment and scale do not matter)
    for each trial delay; the misfit's minimum is refined by a parabola.  A look at the data, without uncertainty.
    """
    start, end, dtheta, _ = imu.increments
    edges, angle = np.append(start[:1], end), np.vstack([np.zeros(3), np.cumsum(dtheta, axis=0)])
    inside = (master.time - span >= edges[0]) & (master.time + span <= edges[-1])
    time = master.time[inside]
    turn = rotation.vector_from_matrix(attitude_steps(master.euler[inside]))
    design = np.column_stack([turn, np.diff(time)])
    delays = np.arange(-round(span / step), round(span / step) + 1) * step
    misfit = np.empty(len(delays))
    for i, delay in enumerate(delays):
        at = np.stack([np.interp(time - delay, edges, component) for component in angle.T], axis=-1)
        slave = np.diff(at, axis=0)
        left = slave - design @ np.linalg.lstsq(design, slave, rcond=None)[0]
        misfit[i] = np.sum(left**2)
    k = int(np.argmin(misfit))
    best = delays[k]
    if 0 < k < len(delays) - 1:
        before, at_k, after = misfit[k - 1 : k + 2]
        best += step * 0.5 * (before - after) / (before - 2 * at_k + after)
    return float(best), float(np.sqrt(misfit[len(delays) // 2] / misfit[k]))
