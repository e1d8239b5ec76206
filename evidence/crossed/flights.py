"""What is asked of several peers: a second of flight, a turn, and steps of a filter, by our generated C."""

from functools import cache
from typing import Any

import numpy as np
from mpmath import mp

from boresight.evidence.crossed import exact
from boresight.evidence.crossed.judge import Numbers
from boresight.runtime.filter import Filter
from boresight.runtime.library import load

# A second in which the rate and the specific force of the body are constant, in ENU with right, front, up.
SECONDS, RATE_HZ = 1, 100
OMEGA, FORCE = np.array([0.1, -0.2, 0.3]), np.array([1.0, 2.0, 9.5])
PLACE, V_N, EULER = np.array([2.2, 0.63, 0.0]), np.array([20.0, 10.0, 1.0]), np.array([0.1, 0.05, 0.4])

TURN = np.array([0.3, -0.2, 0.1])  # rad
LOOP = ("euler_matching", "runtime/filter/filter.py")
SMOOTHER = (*LOOP, "analysis/record.py", "analysis/smoother.py")
SMALL = TURN * 1e-7
# The largest number and the roundings of 100 steps: of a place the sums of a longitude, of the rest 20 for each step.
ROUNDINGS = ((float(exact.AXIS) * PLACE[0], 100), (30.0, 2000), (1.0, 2000))


def start() -> tuple[np.ndarray, np.ndarray]:
    """q_b2n_wxyz, and the matrix of just this quaternion, whose norm is 1."""
    with mp.workdps(exact.DIGITS):
        C = exact.of_euler(*EULER)
    q = quaternion(np.array(C.tolist(), float))
    return q, np.array(matrix(q).tolist(), float)


def quaternion(C: np.ndarray) -> np.ndarray:
    w = np.sqrt(1 + np.trace(C)) / 2
    return np.array([w, *(C[[2, 0, 1], [1, 2, 0]] - C[[1, 2, 0], [2, 0, 1]]) / (4 * w)])


def matrix(q: Any) -> Any:
    """Of a quaternion, in the digits of mpmath; its norm is taken out."""
    w, x, y, z = (mp.mpf(float(part)) for part in q)
    v = exact.skew([x, y, z])
    return mp.eye(3) + (v * w + v * v) * 2 / (w**2 + x**2 + y**2 + z**2)


@cache
def flown() -> tuple[Any, ...]:
    """(start, end in 50 digits, end by our C), each lon, lat, height, velocity and the rows of C_b2n."""
    q, C = start()
    nav = {"lon_lat_height": PLACE, "v_n": V_N, "q_b2n_wxyz": q}
    dtheta, dv = OMEGA / RATE_HZ, FORCE / RATE_HZ
    step = load("strapdown").step
    for _ in range(SECONDS * RATE_HZ):
        nav = step(**nav, dtheta_ib_b=dtheta, dv_b=dv, dtheta_before=dtheta, dv_before=dv, dt=1 / RATE_HZ)
    begin = [*PLACE, *V_N, *C.ravel()]
    end = exact.navigated(begin, OMEGA, FORCE, SECONDS)
    return begin, end, [*nav["lon_lat_height"], *nav["v_n"], *matrix(nav["q_b2n_wxyz"])]


def turn(vector: np.ndarray, theirs: Any) -> Numbers:
    """The matrix of a turn by a rotation vector, of the quaternion that our C gives; of a small one what is not small
    in comparison: the axis."""

    def axis(C: Any) -> list[Any]:
        return [(C[2, 1] - C[1, 2]) / 2, (C[0, 2] - C[2, 0]) / 2, (C[1, 0] - C[0, 1]) / 2]

    given = {"q_b2n_wxyz": np.array([1.0, 0, 0, 0]), "omega_in_n": np.zeros(3), "dt": 1.0}
    q = load("euler-matching").strapdown(dtheta_ib_b=vector, **given)
    ours, true, size = matrix(q), exact.rotation(mp.matrix(vector)), float(max(abs(vector)))
    if size < 1e-3:
        return Numbers(axis(ours), axis(theirs), axis(true), size, 20)
    return Numbers(ours, theirs, true, 1.0, 20)


@cache
def filtered(count: int = 20) -> tuple[Any, ...]:
    """(filter, record, P0, steps of (Phi, Q, H, R, z), last innovation) of Euler matching: Phi, H and z vary."""
    from boresight.analysis.record import Record

    library, rng = load("euler-matching"), np.random.Generator(np.random.PCG64(5))
    nav = {"q_b2n_wxyz": start()[0], "mu": np.array([0.02, -0.01, 0.03])}
    P0 = np.diag(np.array([1e-2, 2e-2, 3e-2, 2e-2, 1e-2, 3e-2]) ** 2)
    loop = Filter(library, nav, P0)
    record, steps, R, found = Record(loop), [], np.diag([1e-6, 2e-6, 3e-6]), None
    for k in range(count):
        euler = EULER + 0.3 * np.sin([0.5 * k, 0.7 * k, 0.9 * k])
        angles: dict[str, Any] = {"euler_b": euler, "euler_m": euler + 0.002 * rng.standard_normal(3)}
        rate: dict[str, Any] = {"omega_in_n": 0.01 * np.sin([1.0 * k, 2.0 * k, 3.0 * k]), "dt": 2.0}
        noise = {"gyro_noise": np.full(3, 1e-4)}
        loop.predict(**rate, **noise)
        found = loop.update("euler", R, **angles)
        z = library.euler_z(mu=nav["mu"], **angles)
        Q = library.Q(q_b2n_wxyz=nav["q_b2n_wxyz"], **rate, **noise)
        steps.append((library.Phi(**rate), Q, library.euler_H(**angles), R, z))
    return loop, record, P0, steps, found
