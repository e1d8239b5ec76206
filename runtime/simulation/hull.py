"""A master and a slave on one hull in waves: attitude, rates, velocity and place, analytic in time.

    motion = hull.by_slope(2.5, 0.1, ratios, phases)     or sinusoids(...), or in_sea(Hull(), *sea.components(2.5), ...)
    master = hull.ride(motion, time)                     a Pose: arrays (T, ..., size)
    slave = hull.carried(master, lever_b, q_b2m_wxyz)    with the bending between them, if any

Frames: n is NED at the hull's mean place, m the hull's and the master's body axes, b the slave's (both FRD).  Euler
angles are roll, pitch, yaw.  C_b2n = C_m2n C_b2m.  The lever arm runs from master to slave, in the slave's axes.
Axes of arrays: time first, then runs, then components; every number of a run may have the shape (...) of the runs.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.simulation import sea

TOGETHER = 32  # instants: their waves stay in the cache, and products of this size are not split among threads
FREEDOMS = ("surge", "sway", "heave", "roll", "pitch", "yaw")


@dataclass(frozen=True)
class Harmonics:
    """Re sum_k amplitude[..., d, k] exp(i omega[..., k] t), for D quantities together.

    omega: (..., K) rad/s, of either sign.  amplitude: (..., D, K) complex.
    """

    omega: Array
    amplitude: Array

    def at(self, time: Any) -> Array:
        """(T,) s, or (T, ...) if each run has its own -> (T, ..., D)."""
        time = np.asarray(time, float)
        # Re(a w) = Re a Re w - Im a Im w, as one product of real matrices
        amplitude = np.concatenate([self.amplitude.real, -self.amplitude.imag], axis=-1)
        if time.ndim == 1:  # the frequencies may serve many runs: their sines only once
            parts = []
            for k in range(0, max(1, len(time)), TOGETHER):
                angle = self.omega[..., :, None] * time[k : k + TOGETHER]
                parts.append(amplitude @ np.concatenate([np.cos(angle), np.sin(angle)], axis=-2))
            return np.moveaxis(np.concatenate(parts, axis=-1), -1, 0)
        angle = self.omega * time[..., None]
        return (amplitude @ np.concatenate([np.cos(angle), np.sin(angle)], axis=-1)[..., None])[..., 0]

    def thrice(self, time: Any) -> tuple[Array, Array, Array]:
        """Value, rate and acceleration at these times, for little more than one of them."""
        rate = 1j * self.omega[..., None, :] * self.amplitude
        acceleration = 1j * self.omega[..., None, :] * rate
        together = replace(self, amplitude=np.concatenate([self.amplitude, rate, acceleration], axis=-2)).at(time)
        value, first, second = np.split(together, 3, axis=-1)
        return value, first, second


@dataclass(frozen=True)
class Motion:
    """The six freedoms of a hull about a steady course.

    freedoms: D = 6 in the order of FREEDOMS: surge, sway, heave in m, forward, right and down along the mean course and
    level; roll, pitch, yaw in rad, added to (0, 0, heading).
    heading: (...) rad from north; speed: (...) m/s along it.
    """

    freedoms: Harmonics
    heading: Any = 0.0
    speed: Any = 0.0


@dataclass(frozen=True)
class Pose:
    """A point of the hull and the axes there: (T, ..., 3), the attitude (T, ..., 4).

    time: (T,) or (T, ...) s.  displacement_n: m from where the motion's centre, without waves, was at time zero.
    omega_nb_b: rate of these axes against n, in these axes, and its rate of change alpha_nb_b.
    """

    time: Array
    displacement_n: Array
    v_n: Array
    a_n: Array
    q_b2n_wxyz: Array
    omega_nb_b: Array
    alpha_nb_b: Array


def ride(motion: Motion, time: Any, place_m: Any = (0.0, 0.0, 0.0)) -> Pose:
    """The hull at these times.  time: (T,) s, or (T, ...) if each run has its own.

    place_m: (..., 3) m, the point that is asked for, from the motion's centre in hull axes; a master elsewhere.
    """
    time = np.asarray(time, float)
    y, y_1, y_2 = motion.freedoms.thrice(time)
    heading, speed = np.asarray(motion.heading, float), np.asarray(motion.speed, float)
    along = np.stack([np.cos(heading), np.sin(heading), np.zeros_like(heading)], axis=-1)
    right = np.stack([-np.sin(heading), np.cos(heading), np.zeros_like(heading)], axis=-1)

    def level(part: Array) -> Array:
        return part[..., :1] * along + part[..., 1:2] * right + part[..., 2:3] * np.array([0.0, 0.0, 1.0])

    steady = speed[..., None] * along
    elapsed = time.reshape(time.shape + (1,) * (y.ndim - time.ndim))
    euler = y[..., 3:] + np.stack([np.zeros_like(heading)] * 2 + [heading], axis=-1)
    omega, alpha = body_rates(euler, y_1[..., 3:], y_2[..., 3:])
    centre = Pose(
        time=time,
        displacement_n=level(y) + steady * elapsed,
        v_n=level(y_1) + steady,
        a_n=level(y_2),
        q_b2n_wxyz=rotation.quaternion_from_euler(euler),
        omega_nb_b=omega,
        alpha_nb_b=alpha,
    )
    return centre if not np.any(place_m) else carried(centre, np.asarray(place_m, float), (1.0, 0.0, 0.0, 0.0))


def body_rates(euler: Array, rate: Array, acceleration: Array) -> tuple[Array, Array]:
    """omega_nb_b and alpha_nb_b (..., 3) from Euler angles, their rates and accelerations, (..., 3) each."""
    (roll, pitch, _), (roll_1, pitch_1, yaw_1), (roll_2, pitch_2, yaw_2) = (
        np.moveaxis(part, -1, 0) for part in (euler, rate, acceleration)
    )
    s_r, c_r, s_p, c_p = np.sin(roll), np.cos(roll), np.sin(pitch), np.cos(pitch)
    level, level_1 = yaw_1 * c_p, yaw_2 * c_p - yaw_1 * pitch_1 * s_p  # yaw's part across the roll axis
    omega = np.stack([roll_1 - yaw_1 * s_p, pitch_1 * c_r + level * s_r, level * c_r - pitch_1 * s_r], axis=-1)
    alpha = np.stack(
        [
            roll_2 - yaw_2 * s_p - yaw_1 * pitch_1 * c_p,
            pitch_2 * c_r + level_1 * s_r + roll_1 * omega[..., 2],
            level_1 * c_r - pitch_2 * s_r - roll_1 * omega[..., 1],
        ],
        axis=-1,
    )
    return omega, alpha


def carried(master: Pose, lever_b: Any, q_b2m_wxyz: Any, bending: Harmonics | None = None) -> Pose:
    """The slave on the master's hull: exact kinematics of a rigid body, and bending at the slave.

    lever_b: (..., 3) m from master to slave in the slave's axes.  q_b2m_wxyz: (..., 4) the mounting, of any size.
    bending: D = 3, theta in rad in the master's axes, of a few mrad, its runs as they broadcast with the hull: C_b2m =
    exp([theta x]) C_mounting.  It turns the slave where it stands: the lever arm stays as it is in the master's axes.
    """
    C_b2m, q_b2m = rotation.matrix_from_quaternion(q_b2m_wxyz), q_b2m_wxyz
    lever_m = np.einsum("...ij,...j->...i", C_b2m, np.asarray(lever_b, float))
    C_m2n = rotation.matrix_from_quaternion(master.q_b2n_wxyz)
    omega, alpha = master.omega_nb_b, master.alpha_nb_b
    turning = np.cross(omega, lever_m)

    def to_n(vector_m: Array) -> Array:
        return np.einsum("...ij,...j->...i", C_m2n, vector_m)

    place = {
        "displacement_n": master.displacement_n + to_n(np.broadcast_to(lever_m, turning.shape)),
        "v_n": master.v_n + to_n(turning),
        "a_n": master.a_n + to_n(np.cross(alpha, lever_m) + np.cross(omega, turning)),
    }
    if bending is not None:
        theta, theta_1, theta_2 = bending.thrice(master.time)
        C_b2m = rotation.matrix_from_vector(theta) @ C_b2m
        q_b2m = rotation.quaternion_from_matrix(C_b2m)
        # The left Jacobian of theta to third order: of 1 mrad it leaves out 1e-13.
        sweep, sweep_1 = np.cross(theta, theta_1), np.cross(theta, theta_2)
        bend = theta_1 + sweep / 2 + np.cross(theta, sweep) / 6
        bend_1 = theta_2 + sweep_1 / 2 + (np.cross(theta_1, sweep) + np.cross(theta, sweep_1)) / 6
        omega, alpha = omega + bend, alpha + bend_1 - np.cross(bend, omega)
    q_b2n = rotation.product(master.q_b2n_wxyz, q_b2m)

    def to_b(vector_m: Array) -> Array:
        return np.einsum("...ji,...j->...i", C_b2m, vector_m)

    return Pose(
        time=master.time,
        **{name: np.broadcast_to(value, (*q_b2n.shape[:-1], 3)) for name, value in place.items()},
        q_b2n_wxyz=q_b2n,
        omega_nb_b=to_b(omega),
        alpha_nb_b=to_b(alpha),
    )


# ---- motions


def sinusoids(amplitude: Any, phase: Any, frequency_hz: Any, heading: Any = 0.0, speed: Any = 0.0) -> Motion:
    """Each freedom amplitude sin(2 pi f t + phase), of one frequency.

    amplitude, phase: (..., 6) in m and rad, in the order of FREEDOMS; frequency_hz: (...).
    """
    amplitude, phase = np.broadcast_arrays(np.asarray(amplitude, float), np.asarray(phase, float))
    omega = 2 * np.pi * np.asarray(frequency_hz, float)
    return Motion(Harmonics(omega[..., None], (-1j * amplitude * np.exp(1j * phase))[..., None]), heading, speed)


def by_slope(
    elevation_m: Any,
    frequency_hz: Any,
    ratios: Any,
    phases: Any,
    heading: Any = 0.0,
) -> Motion:
    """Heave with the elevation a sin(2 pi f t) of a wave in deep water, and angles that are parts of its slope k a.

    elevation_m: (...) amplitude a.  ratios: (..., 3) amplitudes of roll, pitch, yaw over k a.  phases: (..., 3) rad, by
    which they lead the elevation; the slope itself is a quarter of a period from it.
    """
    a = np.asarray(elevation_m, float)[..., None]
    slope = sea.wave_number(2 * np.pi * np.asarray(frequency_hz, float))[..., None] * a
    angles = slope * np.asarray(ratios, float)
    a, angles = np.broadcast_arrays(a, angles)
    level = np.stack([0 * a[..., 0], 0 * a[..., 0], -a[..., 0]], axis=-1)  # heave is downwards
    phase = np.concatenate([np.zeros_like(level), np.broadcast_to(phases, angles.shape)], axis=-1)
    return sinusoids(np.concatenate([level, angles], axis=-1), phase, frequency_hz, heading)


@dataclass(frozen=True)
class Hull:
    """A slender hull, a box for the water's pressure: of 40 m, a patrol craft.

    Heave, pitch and roll are oscillators of these natural periods and damping ratios.
    """

    length_m: float = 40.0
    beam_m: float = 7.0
    draught_m: float = 2.0
    heave_period_s: float = 4.0
    heave_damping: float = 0.4
    pitch_period_s: float = 4.0
    pitch_damping: float = 0.4
    roll_period_s: float = 7.0
    roll_damping: float = 0.12


def response(hull: Hull, omega: Any, towards: Any, speed: Any = 0.0) -> tuple[Array, Array]:
    """Frequency of encounter (...) rad/s, and the freedoms (..., 6), complex, for an elevation of 1 m at the centre.

    omega: (...) rad/s of the wave.  towards: (...) rad, where the waves run to from the bow, clockwise: 0 following, pi
    head sea, pi/2 from port.  The elevation is Re exp(i (omega_e t - k (x cos + y sin))), x forward, y to the right.

    The water's surface is averaged over length and beam and fades with depth, exp(-k draught).  Surge, sway and yaw
    follow the water's orbits; heave, pitch and roll answer its height and slope as damped oscillators.  In long waves
    the hull moves as a chip on the surface does.  Slender body, long crests, small motions, no drift; speed changes
    the frequency of encounter and nothing else.
    """
    omega, towards = np.asarray(omega, float), np.asarray(towards, float)
    k = sea.wave_number(omega)
    k_x, k_y = k * np.cos(towards), k * np.sin(towards)
    omega_e = omega - np.asarray(speed, float) * k_x
    x, y = k_x * hull.length_m / 2, k_y * hull.beam_m / 2
    depth = np.exp(-k * hull.draught_m)
    height = mean_of_wave(x) * mean_of_wave(y) * depth  # the mean over the water plane
    turn_x = slope_of_wave(x) * mean_of_wave(y) * depth  # the best slope along the hull, of one that is k_x
    turn_y = mean_of_wave(x) * slope_of_wave(y) * depth

    def oscillator(period_s: float, damping: float) -> Array:
        ratio = omega_e * period_s / (2 * np.pi)
        return 1 / (1 - ratio**2 + 2j * damping * ratio)

    # At the crest the orbit has the velocity omega along the waves.  A hull that keeps up with a wave is carried on and
    # on: its velocity is what counts, and its displacement is without bound.
    still = np.where(np.abs(omega_e) < 1e-9, 1e-9, omega_e)
    orbit = -1j * omega / still * height
    heave = oscillator(hull.heave_period_s, hull.heave_damping)
    pitch = oscillator(hull.pitch_period_s, hull.pitch_damping)
    roll = oscillator(hull.roll_period_s, hull.roll_damping)
    return omega_e, np.stack(
        [
            orbit * np.cos(towards),
            orbit * np.sin(towards),
            -heave * height,  # downwards
            1j * k_y * turn_y * roll,  # the water rises to the right: the right side goes up, a negative roll
            -1j * k_x * turn_x * pitch,  # it rises ahead: nose up
            -omega / still * k_x * np.sin(towards) * turn_x,  # the water's sideways orbit differs along the hull
        ],
        axis=-1,
    )


def mean_of_wave(x: Array) -> Array:
    """sin(x) / x: the mean of cos over -x to x."""
    return np.sinc(x / np.pi)


def slope_of_wave(x: Array) -> Array:
    """3 (sin x - x cos x) / x^3: the best straight line through sin over -x to x, of its slope at 0."""
    small = np.abs(x) < 1e-2
    safe = np.where(small, 1.0, x)
    return np.where(small, 1 - x**2 / 10, 3 * (np.sin(safe) - safe * np.cos(safe)) / safe**3)


def in_sea(
    hull: Hull,
    omega: Any,
    elevation_m: Any,
    phases: Any,
    *,
    towards: Any,
    heading: Any = 0.0,
    speed: Any = 0.0,
) -> Motion:
    """The hull in long-crested waves, as `sea.components` gives them, each with its own phase.

    omega, elevation_m: (..., K) rad/s and m.  phases: (..., K) rad, `phases(streams, K)`.  towards, heading: (...) rad
    from north, where the waves run to and where the hull heads.  speed: (...) m/s.
    """
    relative = np.asarray(towards, float) - np.asarray(heading, float)
    omega_e, answer = response(hull, omega, relative[..., None], np.asarray(speed, float)[..., None])
    waves = np.asarray(elevation_m, float) * np.exp(1j * np.asarray(phases, float))
    return Motion(Harmonics(omega_e, np.moveaxis(answer, -1, -2) * waves[..., None, :]), heading, speed)


def phases(streams: Sequence[np.random.Generator], count: int) -> Array:
    """(runs, count) rad, from each run's own stream, such as simulation.generator(seed, run)."""
    return 2 * np.pi * np.array([stream.random(count) for stream in streams])


def bending(sigma: Any, correlation_s: float, phases: Any) -> Harmonics:
    """Flexure as a second-order Markov process, correlation (1 + b |t|) exp(-b |t|) with b = 1 / correlation_s.

    sigma: (3,) rad in the master's axes.  phases: (..., 3 K) rad.  The 1.3 % of
    the variance that lie below 0.01 b are spread over the rest.
    """
    phases = np.asarray(phases, float)
    phases = phases.reshape((*phases.shape[:-1], 3, -1))
    edges = np.geomspace(0.01, 30.0, phases.shape[-1] + 1)
    below = (np.arctan(edges) + edges / (1 + edges**2)) * 2 / np.pi  # the integral of 4 / (pi (1 + x^2)^2)
    part = np.sqrt(2 * np.diff(below) / (below[-1] - below[0]))
    amplitude = np.asarray(sigma, float)[:, None] * part * np.exp(1j * phases)
    return Harmonics(np.sqrt(edges[1:] * edges[:-1]) / correlation_s, amplitude)
