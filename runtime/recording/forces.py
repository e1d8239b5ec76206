"""What may be wrong with the specific force, beside a master whose turns are the slave's, as guesses that compete."""

from collections.abc import Iterator
from itertools import permutations, product

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.frames import AXES
from boresight.runtime.recording.explain import Freedom, Guess, axes_named, known, plain, turn_named
from boresight.runtime.recording.types import Inertial, Master
from boresight.runtime.units import STANDARD_GRAVITY as G

RANGE = "another range of the sensor"
FACTORS = {
    1 / G: "g declared as m/s^2", G: "m/s^2 declared as g", 1000 / G: "mg declared as m/s^2", 0.5: RANGE, 2.0: RANGE,
    100.0: "cm/s^2 declared as m/s^2", 0.25: RANGE, 4.0: RANGE,
}  # fmt: skip
SPEEDS = (3.6, 3600 / 1852, 1 / 0.3048, 1 / 0.44704)  # units that may stand for m/s
E = np.eye(3)


def of_forces(imu: Inertial, master: Master, trusted: bool) -> tuple[Iterator[Guess], Freedom] | None:
    """Guesses of the specific force in means over a second or so; None of a recording that is too short.

    trusted: whether the velocity sums up to the position.
    """
    assert master.v_n is not None
    _, end, dtheta, dvel = imu.increments
    every = max(1, round(1 / float(np.median(np.diff(master.time)))))  # of its intervals, to a second
    inside = (master.time > end[0] + 1) & (master.time < end[-1] - 1)
    count = (int(inside.sum()) - 1) // every
    if count < 15:
        return None
    time, v = master.time[inside][: count * every + 1].astype(float), master.v_n[inside][: count * every + 1]
    edges, dt = time[::every], np.diff(time)[:, None]

    def means(values: Array, at: Array, shift: float = 0.0) -> Array:
        """(K, m) between neighbours of `edges`, of sums (N, m) that stand at `at`."""
        sums = np.stack([np.interp(edges + shift, at, part) for part in values.T], axis=-1)
        out: Array = np.diff(sums, axis=0) / np.diff(edges)[:, None]
        return out

    fine = np.arange(time[0], time[-1], max(0.02, imu.dt))
    euler = np.stack([np.interp(fine, master.time, part) for part in np.unwrap(master.euler, axis=0).T], axis=-1)
    C = np.cumsum(rotation.matrix_from_euler(euler).reshape(-1, 9), axis=0) * (fine[1] - fine[0])
    C = np.diff(np.stack([np.interp(time, fine, part) for part in C.T], axis=-1), axis=0) / dt
    velocity, angle = np.cumsum(dvel, axis=0), np.cumsum(dtheta, axis=0)
    ends = [np.stack([np.interp(edges + by, end, part) for part in angle.T], axis=-1) for by in (-0.05, 0.05)]
    rate, one = (ends[1] - ends[0]) / 0.1, np.ones((count, 1))
    biases = tuple(one * axis for axis in E)
    levers = tuple(np.diff(np.cross(rate, axis), axis=0) / np.diff(edges)[:, None] for axis in E)
    free = Freedom((*biases, *levers), (0.1,) * 3 + (1.0,) * 3, 0.03, 0.1)
    late = (means(velocity, end, by) for by in np.arange(-30, 31) / 20 if by)
    made = guesses(means(velocity, end), late, v, dt, C.reshape(-1, 3, 3), biases)
    return (one for one in made if not (trusted and one.kind == "velocity")), free


def guesses(
    felt: Array, late: Iterator[Array], v: Array, dt: Array, C: Array, biases: tuple[Array, ...]
) -> Iterator[Guess]:
    """felt: (K, 3) m/s^2, and `late` the same at other times.

    v: (J + 1, 3) m/s; dt (J, 1) s between them and C (J, 3, 3), body to navigation, of so many intervals to one of K.
    """
    up, change = np.array([0, 0, -G]), np.diff(v, axis=0) / dt

    def pooled(values: Array) -> Array:
        weights = dt.reshape(len(felt), -1, 1)
        out: Array = (values.reshape(len(felt), -1, 3) * weights).sum(axis=1) / weights.sum(axis=1)
        return out

    def body(acceleration: Array) -> Array:
        return pooled(np.einsum("kji,kj->ki", C, acceleration + up))

    of = body(change)
    yield Guess("", "", "", felt, of)
    text = "they are in navigation axes already, declared as of the body"
    yield Guess("level", "imu.accel", text, felt, pooled(change + up))
    factor = float(np.sum(felt * of) / (np.sum(of * of) + 1e-300))
    if abs(abs(factor) - 1) > 0.03 and abs(factor) > 1e-5:
        text = f"they are {factor:.4g} times what they should be{known(factor, FACTORS)}"
        yield Guess("factor", "imu.accel", text, felt / factor, of)
    for i, name in enumerate(AXES):
        alone = float(felt[:, i] @ of[:, i] / (of[:, i] @ of[:, i] + 1e-300))
        if abs(alone) > 1e-5 and not 0.7 < alone < 1.4:  # a unit or a range, no scale factor
            unit = known(alone, FACTORS, 0.2).replace(": ", f": {name} alone in ", 1)
            text = f"{name} alone is {alone:.4g} times what it should be{unit}"
            yield Guess(f"factor {name}", "imu.accel", text, felt / np.where(np.arange(3) == i, alone, 1), of)
    says = "the accelerometers lie in other axes than the gyros, which turn as the master"
    for order in permutations(range(3)):
        for signs in product((1, -1), repeat=3):
            M = E[list(order)] * np.array(signs)[:, None]
            if not np.array_equal(M, E):
                text = f"{says}: {axes_named(M)}"
                text = "they have the other sign: check imu.body, or the sign" if np.array_equal(M, -E) else text
                yield Guess("axes", "imu.accel", text, felt, of @ M.T)
    U, _, Vt = np.linalg.svd(felt.T @ of)
    M = U @ np.diag([1.0, 1.0, np.linalg.det(U @ Vt)]) @ Vt
    if not plain(M):
        yield Guess("axes", "imu.accel", f"{says}: turned by {turn_named(M)}", felt, of @ M.T)
    text = "gravity was taken off; describe the specific force, with gravity in it"
    yield Guess("gravity", "imu.accel", text, felt, body(change - up))
    if np.std(v, axis=0).max() > 1:
        text = "its roll and pitch are those of accelerometers, which take each acceleration for a tilt"
        yield Guess("apparent", "master.attitude", text, felt, body(0 * change))
    text = "their bias is [{0:+.2f}, {1:+.2f}, {2:+.2f}] m/s^2 (front, right, down), or a scale factor is so far off"
    yield Guess("bias", "imu.accel", text, felt, of, biases, most=5)
    # what others judge, by the position, the turns and the delay
    for size in (*SPEEDS, *(1 / one for one in SPEEDS), -1.0):
        yield Guess("velocity", "", "", felt, body(size * change))
    for other in (v[:, [1, 0, 2]] * [1, 1, -1], v[:, [1, 0, 2]], v * [1, 1, -1], v * [1, -1, 1], v * [-1, 1, 1]):
        yield Guess("velocity", "", "", felt, body(np.diff(other, axis=0) / dt))
    for yaw in np.radians(np.arange(5, 360, 5)):
        turned = rotation.matrix_from_vector(np.array([0, 0, yaw]))
        yield Guess("heading", "", "", felt, body(change @ turned.T))
    for other in late:
        yield Guess("late", "", "", other, of)
