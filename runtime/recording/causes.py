"""Which mistake explains turns or velocities that do not fit: each that is usual is undone, and the best is named."""

from itertools import permutations, product

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.frames import AXES
from boresight.runtime.recording.types import Inertial, Master
from boresight.runtime.units import DEG

FITS = 0.1  # of what is to be explained, that may be left


def left(slave: Array, turn: Array) -> float:
    """The part of the slave's turns (K, 3) that the master's do not explain as they are, but for their means."""
    slave, turn = slave - slave.mean(axis=0), turn - turn.mean(axis=0)
    return float(np.sum((slave - turn) ** 2) / np.sum(slave**2))


def of_axes(slave: Array, turn: Array) -> str:
    """How the slave's axes lie beside its master's, by turns (K, 3) of both; "" where no change of axes fits."""
    # a factor of one axis leaves as much where all axes turn alike
    best, found = min(FITS, left(slave, turn) / 4), ""
    for order in permutations(range(3)):
        for signs in product((1, -1), repeat=3):
            M = np.eye(3)[list(order)] * np.array(signs)[:, None]
            rest = left(slave, turn @ M.T)
            if rest < best:
                best, found = rest, _named(M)
    return found


def of_mounting(slave: Array, turn: Array) -> str:
    """By how much the slave is turned beside its master, by turns (K, 3) of both; "" where no turn explains them."""
    U, _, Vt = np.linalg.svd((slave - slave.mean(axis=0)).T @ (turn - turn.mean(axis=0)))
    M = U @ np.diag([1.0, 1.0, np.linalg.det(U @ Vt)]) @ Vt
    vector = np.degrees(rotation.vector_from_matrix(M))
    if left(slave, turn @ M.T) > FITS or np.linalg.norm(vector) < 8:
        return ""
    axis = int(np.abs(vector).argmax())
    size = float(np.linalg.norm(vector))
    about = AXES[axis] if abs(vector[axis]) > 0.95 * size else "[{:.2f}, {:.2f}, {:.2f}]".format(*(vector / size))
    return f"it is turned by {size:.0f} deg about {about} beside its master: mounted so, or another body"


def turned_between(time: Array, gyro: Array, ends: Array) -> Array:
    """(K, 3) sums of rates (N, 3) at `time` between neighbours of `ends` (K + 1,), as if small."""
    angle = np.cumsum(gyro * np.gradient(time)[:, None], axis=0)
    return np.diff(np.stack([np.interp(ends, time, part) for part in angle.T], axis=-1), axis=0)


def factor(imu: Inertial, master: Master) -> float:
    """By how much more the slave turns than its master, 0 where they do not turn alike."""
    C = rotation.matrix_from_euler(master.euler)
    turn = rotation.vector_from_matrix(np.swapaxes(C[:-1], -1, -2) @ C[1:])
    slave = turned_between(imu.time, imu.rates()[0], master.time)
    x, y = ((part - part.mean(axis=0)).ravel() for part in (turn, slave))
    alike = float(x @ y) / np.sqrt(float(x @ x) * float(y @ y) + 1e-300)
    return float(x @ y) / float(x @ x) if alike > 0.9 else 0.0


def of_rate(time: Array, gyro: Array, ends: Array, turn: Array) -> str:
    """Whether the slave's tags run at another rate: of rates gyro (N, 3) at `time`, turns (K, 3) between ends (K + 1,).

    Both begin together, but for a tenth of a second.
    """

    def unexplained(factor: float, shift: float) -> float:
        at = time[0] + shift + (time - time[0]) * factor
        inside = (ends[:-1] >= at[0]) & (ends[1:] <= at[-1])
        if inside.sum() < max(20, 0.4 * len(turn)):
            return 1.0
        return left(turned_between(at, gyro, ends)[inside], turn[inside])

    tried = [(float(one), 0.0) for one in np.exp(np.linspace(-0.7, 0.7, 281))]
    for width in (0.005, 0.0005):
        factor, shift = min(tried, key=lambda one: unexplained(*one))
        spans = np.linspace(-1, 1, 11)
        tried = [(factor * (1 + width * a), shift + 20 * width * b) for a in spans for b in spans]
    factor, shift = min(tried, key=lambda one: unexplained(*one))
    if unexplained(factor, shift) > FITS or abs(factor - 1) < 0.005:
        return ""
    hz = 1 / float(np.median(np.diff(time)))
    return (
        f"the turns of both fit where its tags run at {factor:.4g} times their rate: {hz / factor:.4g} Hz, not {hz:.4g}"
    )


def of_angles(time: Array, gyro: Array, ends: Array, turn: Array) -> str:
    """Whether what stands for rates is an angle."""
    moved = np.diff(np.stack([np.interp(ends, time, part) for part in gyro.T], axis=-1), axis=0)
    return "they are angles, sums of rates, and not rates" if left(moved, turn) < FITS else ""


def _named(M: Array) -> str:
    if np.linalg.det(M) < 0:
        where = [AXES[i] for i in range(3) if M[i, i] < 0]
        if len(where) == 1 and np.trace(np.abs(M)) == 3:
            return f"{where[0]} of its axes is mirrored: left-handed axes, or one sign"
        moved = [AXES[i] for i in range(3) if M[i, i] == 0]
        angles = ", or the master's roll and pitch are" if moved == ["front", "right"] else ""
        return f"{' and '.join(moved)} of its axes are exchanged, left-handed{angles}"
    vector = rotation.vector_from_matrix(M)
    angle = round(float(np.degrees(np.linalg.norm(vector))))
    main = int(np.abs(vector).argmax())
    about = AXES[main] if np.count_nonzero(np.abs(vector) > 0.1) == 1 else "a diagonal"
    names = ", as FLU beside FRD" if angle == 180 and main == 0 and about == "front" else ""
    return f"it is turned by {angle} deg about {about} beside its master{names}: another body"


def of_attitude(slave: Array, master: Master, kept: Array) -> str:
    """What was done to the attitude, so that the turns of the slave (K, 3) fit where it is undone; "" where nothing is.

    kept: (K,) numbers of the master's intervals.
    """
    q = rotation.quaternion_from_euler(master.euler)
    C = rotation.matrix_from_euler(master.euler)
    tried = {
        "roll and pitch are exchanged: another order of the angles": rotation.matrix_from_euler(
            master.euler[:, [1, 0, 2]]
        ),
        "its quaternion is the conjugate: navigation to body": np.swapaxes(C, -1, -2),
        "its quaternion is in another order: xyzw declared as wxyz": rotation.matrix_from_quaternion(np.roll(q, 1, 1)),
        "its quaternion is in another order: wxyz declared as xyzw": rotation.matrix_from_quaternion(np.roll(q, -1, 1)),
    }
    best, found = FITS, ""
    for name, one in tried.items():
        steps = np.swapaxes(one[:-1], -1, -2) @ one[1:]
        rest = left(slave, rotation.vector_from_matrix(steps)[kept])
        if rest < best:
            best, found = rest, name
    return found


MISSED = 1.5 * DEG  # rms of the sums of turns, up to which what a constant leaves is noise and a bias that wanders


def of_bias(dt: Array, slave: Array, turn: Array, angles: Array, least: float = 0.25) -> str:
    """What makes the slave turn more than its master where that is no constant: "" where a constant is as good.

    dt (K,) s; slave, turn, angles (K, 3) rad: of the slave, of its master, and the change of the master's Euler angles.
    Their sums must differ by `least` of it where it is undone; a mounting is left free.
    """
    from scipy.signal import lfilter

    since, usual = np.cumsum(dt), float(np.median(dt))
    one, angle = np.ones_like(since), np.cumsum(turn, axis=0)

    def rest(of: Array, *more: Array) -> tuple[float, Array]:
        total, found = 0.0, []
        for axis in range(3):
            X = np.column_stack([angle[:, (axis + 1) % 3], angle[:, (axis + 2) % 3], one, since, *more])
            size = np.linalg.norm(X, axis=0) + 1e-300
            y = np.cumsum(slave[:, axis]) - of[:, axis]
            parts, *_ = np.linalg.lstsq(X / size, y, rcond=1e-9)
            found.append((parts / size)[4:])
            total += float(np.sum((y - X / size @ parts) ** 2))
        return total, np.array(found)

    whole, _ = rest(angle)
    if whole < len(dt) * MISSED**2:
        return ""
    left = {"the rates of roll, pitch and yaw stand there, of Euler angles, and not those of the body":
            rest(np.cumsum(angles, axis=0))[0]}  # fmt: skip
    for tau in np.geomspace(max(1.0, 2 * usual), 2 * since[-1], 25):
        fading = np.exp(-since / tau)
        a = 1 - np.exp(-usual / tau)
        slow = np.cumsum(lfilter([a / 2, a / 2], [1, a - 1], turn, axis=0), axis=0)
        left[f"slow turns are missing, as behind a high-pass of about {tau:.2g} s"] = rest(angle - slow, fading)[0]
        mean = np.stack([np.interp(since - tau, since, part) for part in angle.T], axis=-1)
        text = f"slow turns are missing, as where a running mean of about {tau:.2g} s was taken off"
        mean = np.cumsum((angle - mean) * dt[:, None], axis=0) / tau
        left[text] = rest(angle - mean, np.minimum(since, tau) ** 2)[0]
        size, found = rest(angle, fading)
        shown = ", ".join(f"{one:+.2f}" for one in np.degrees(found[:, 0] / tau * (fading[0] - fading[-1])))
        left[f"its bias drifts by [{shown}] deg/s (front, right, down), as of one that warms up"] = size
    best = min(left, key=left.__getitem__)
    return best if left[best] < least * whole else ""


def of_halves(slave: Array, turn: Array, time: Array) -> str:
    """Turns that fit to one instant and not behind it, or the reverse; time: (K,) s."""
    factor = np.sum(slave * turn, axis=0) / np.maximum(np.sum(turn**2, axis=0), np.finfo(float).tiny)
    if left(slave, turn * factor) < FITS:
        return ""  # one factor an axis explains it all along
    miss = np.sum((slave - turn) ** 2, axis=1)
    total, power = np.cumsum(miss), np.cumsum(np.sum(slave**2, axis=1))
    for ahead in (True, False):
        early = total if ahead else total[-1] - total
        of = power if ahead else power[-1] - power
        good = np.flatnonzero((early < FITS / 10 * of) & (of > 0.2 * power[-1]))
        if len(good):
            at = time[good[-1] if ahead else good[0]]
            return f"the turns fit until {at:.0f} s and not behind it" if ahead else f"the turns fit from {at:.0f} s on"
    return ""


def of_track(master: Master) -> str:
    """By how much the level velocity is turned against the track, where nothing else differs; "" where it is not."""
    assert master.v_n is not None and master.position is not None
    lat, lon, height = master.position.T
    moved = np.diff(np.column_stack([lat, lon * np.cos(lat[0])]) * (6371e3 + height[0]), axis=0)
    v = (master.v_n[1:, :2] + master.v_n[:-1, :2]) / 2 * np.diff(master.time)[:, None]
    track, speed = moved[:, 0] + 1j * moved[:, 1], v[:, 0] + 1j * v[:, 1]
    factor = np.vdot(track, speed) / max(np.vdot(track, track).real, 1e-300)
    rest = float(np.sum(np.abs(speed - factor * track) ** 2) / max(np.sum(np.abs(speed) ** 2), 1e-300))
    angle = float(np.degrees(np.angle(factor)))
    if rest > FITS / 2 or abs(angle) < 4 or abs(abs(factor) - 1) > 0.05:
        return ""
    return f"the velocity is turned by {angle:.1f} deg against the track of the position: grid or magnetic north"


def of_velocity(master: Master) -> str:
    """What was done to the velocity or the position, so that one is the sum of the other where it is undone."""
    assert master.v_n is not None and master.position is not None
    lat, lon, height = master.position.T
    place = np.column_stack([lat, lon * np.cos(lat[0]), np.zeros_like(lat)]) * (6371e3 + height[0])
    place[:, 2] = -height
    swapped = np.column_stack([lon, lat * np.cos(lon[0]), np.zeros_like(lat)]) * (6371e3 + height[0])
    swapped[:, 2] = -height
    C, v = rotation.matrix_from_euler(master.euler), master.v_n
    # the Earth's axes turned to north, east and down: about z by the longitude, about y by latitude and a right angle
    south = np.stack([0 * lat, -lat - np.pi / 2, lon], axis=-1)
    earth = np.einsum("kji,kj->ki", rotation.matrix_from_euler(south), v)
    tried = {
        "a velocity of the body declared as one of navigation (axes)": (place, np.einsum("kij,kj->ki", C, v)),
        "a velocity of navigation declared as one of the body (axes)": (place, np.einsum("kji,kj->ki", C, v)),
        "north and east are exchanged and up is down: ENU declared as NED": (place, v[:, [1, 0, 2]] * [1, 1, -1]),
        "east has the other sign and up is down: NWU declared as NED": (place, v * [1, -1, -1]),
        "north and east are exchanged in the velocity": (place, v[:, [1, 0, 2]]),
        "latitude and longitude are exchanged": (swapped, v),
        "the sign of the latitude is lost": (place * [-1, 1, 1], v),
        "the sign of the longitude is lost": (place * [1, -1, 1], v),
        "the velocity is one of the Earth's axes, x, y, z of ECEF, declared as NED": (place, earth),
        "north of the velocity has the other sign": (place, v * [-1, 1, 1]),
        "east of the velocity has the other sign": (place, v * [1, -1, 1]),
    }
    dt = np.diff(master.time)[:, None]
    rest = {}
    for name, (at, speed) in tried.items():
        moved = np.diff(at, axis=0)
        rest[name] = float(np.sum((moved - (speed[1:] + speed[:-1]) / 2 * dt) ** 2) / np.sum(moved**2))
    best = min(rest.values())
    return " or ".join(name for name in tried if rest[name] < 1.1 * best) if best < FITS else ""  # both, where two fit
