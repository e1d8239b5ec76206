"""Flights to try a filter on, made by means that it does not share: analytic motion, quadrature, an Earth of its own.

The slave's attitude and velocity are given in closed form; what its sensors deliver is the integral of the rates that
follow from them, by Gauss and Legendre's five points in each interval.  Nothing here calls the strapdown step, its
inverse, or a function of a model.  NED and front-right-down, SI and rad.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from boresight.runtime.array import Array
from boresight.runtime.units import DEG

OfTime = Callable[[Any], Array]  # value, first and second derivative, (3, ..., 3)

A, E2, EARTH_RATE = 6378137.0, 6.69437999014e-3, 7.292115e-5  # WGS 84, published digits
NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)


def radii(lat: Any) -> tuple[Any, Any]:
    """Meridian and normal radius, m."""
    w = np.sqrt(1 - E2 * np.sin(lat) ** 2)
    return A * (1 - E2) / w**3, A / w


def gravity(lat: Any, height: Any) -> Any:
    """Somigliana's formula at the ellipsoid, with the second-order change with height, m/s^2."""
    s2 = np.sin(lat) ** 2
    at_zero = 9.7803253359 * (1 + 1.931852652458e-3 * s2) / np.sqrt(1 - E2 * s2)
    flattening, m = 3.35281066474748e-3, 3.449786506841e-3
    return at_zero * (1 - 2 * (1 + flattening + m - 2 * flattening * s2) * height / A + 3 * height**2 / A**2)


def waves(*parts: tuple[Any, Any, Any]) -> OfTime:
    """A sum of amplitude sin(2 pi frequency t + phase) by axis: (amplitude (3,), frequency_hz, phase (3,)) each.

    Returns a function of t (...,) that gives value, first and second derivative, each (..., 3).
    """

    def at(t: Any) -> Array:
        out = np.zeros((3, *np.shape(t), 3))
        for amplitude, frequency, phase in parts:
            omega = 2 * np.pi * np.asarray(frequency)
            angle = omega * np.asarray(t)[..., None] + np.asarray(phase)
            amplitude = np.asarray(amplitude, float)
            out += amplitude * np.array([np.sin(angle), omega * np.cos(angle), -(omega**2) * np.sin(angle)])
        return out

    return at


def still(t: Any) -> Array:
    return np.zeros((3, *np.shape(t), 3))


@dataclass
class Motion:
    """Where the slave is: at t, latitude and longitude by quadrature of the velocity.

    euler: mean (3,) roll, pitch, yaw; swing: what is added to it; steady: (3,) m/s, NED; sway: what is added to that.
    yaw_rate: rad/s.  What is given as functions returns value, first and second derivative (3, ..., 3).
    """

    place: Array = field(default_factory=lambda: np.array([0.7, 0.2, 50.0]))
    euler: Array = field(default_factory=lambda: np.array([0.0, 0.0, 0.6]))
    swing: OfTime = still
    steady: Array = field(default_factory=lambda: np.zeros(3))
    sway: OfTime = still
    yaw_rate: float = 0.0
    seconds: float = 60.0

    def __post_init__(self) -> None:
        # the place, on a fine grid by the midpoint rule, and its spline: the rates need it to some metres
        t = np.linspace(-2.0, self.seconds + 2.0, int((self.seconds + 4) * 50) + 1)
        dt, mid = t[1] - t[0], (t[1:] + t[:-1]) / 2
        v = self.velocity(mid)[0]
        lat, lon, height = np.array(self.place, float)
        zero = np.searchsorted(t, 0.0)
        track = np.empty((len(t), 3))
        track[zero] = lat, lon, height
        for step, order in ((1, range(zero, len(t) - 1)), (-1, range(zero - 1, -1, -1))):
            lat, lon, height = track[zero]
            for k in order:
                meridian, normal = radii(lat)
                rate = np.array([v[k, 0] / (meridian + height), v[k, 1] / ((normal + height) * np.cos(lat)), -v[k, 2]])
                lat, lon, height = np.array([lat, lon, height]) + step * dt * rate
                track[k + 1 if step > 0 else k] = lat, lon, height
        self._track = CubicSpline(t, track)

    def position(self, t: Any) -> Array:
        """(..., 3) latitude, longitude, height."""
        return self._track(t)

    def velocity(self, t: Any) -> tuple[Array, Array]:
        """(..., 3) m/s, NED, and its derivative."""
        value, rate, _ = self.sway(t)
        return value + self.steady, rate

    def attitude(self, t: Any) -> tuple[Array, Array]:
        """(..., 3) roll, pitch, yaw, and their rates."""
        value, rate, _ = self.swing(t)
        turn = np.array([0.0, 0.0, self.yaw_rate])
        return value + self.euler + np.asarray(t)[..., None] * turn, rate + turn

    def C_b2n(self, t: Any) -> Array:
        return matrix(self.attitude(t)[0])

    def rates(self, t: Any) -> tuple[Array, Array, Array]:
        """omega_ib_b rad/s and f_b m/s^2 (..., 3) of ideal sensors; and omega_eb_b, against the Earth."""
        (roll, pitch, _), e_rate = np.moveaxis(self.attitude(t)[0], -1, 0), self.attitude(t)[1]
        v, v_rate = self.velocity(t)
        lat, _, height = np.moveaxis(self.position(t), -1, 0)
        meridian, normal = radii(lat)
        zero = np.zeros_like(lat)
        ie = EARTH_RATE * np.stack([np.cos(lat), zero, -np.sin(lat)], -1)
        en = np.stack(
            [
                v[..., 1] / (normal + height),
                -v[..., 0] / (meridian + height),
                -v[..., 1] * np.tan(lat) / (normal + height),
            ],
            -1,
        )
        nb = np.stack(
            [
                e_rate[..., 0] - np.sin(pitch) * e_rate[..., 2],
                np.cos(roll) * e_rate[..., 1] + np.sin(roll) * np.cos(pitch) * e_rate[..., 2],
                -np.sin(roll) * e_rate[..., 1] + np.cos(roll) * np.cos(pitch) * e_rate[..., 2],
            ],
            -1,
        )
        C = self.C_b2n(t)
        down = np.stack([zero, zero, gravity(lat, height)], -1)
        in_n = np.stack([ie + en, v_rate + np.cross(2 * ie + en, v) - down, en])
        inertial, force, transport = np.einsum("...ji,s...j->s...i", C, in_n)
        return nb + inertial, force, nb + transport

    def increments(self, edges: Array) -> tuple[Array, Array]:
        """dtheta rad and dv m/s (K, 3) of ideal sensors between the edges (K+1,) s."""
        half = np.diff(edges)[:, None] / 2
        t = edges[:-1, None] + half * (1 + NODES)
        omega, force, _ = self.rates(t)
        return np.einsum("kq,kqi->ki", half * WEIGHTS, omega), np.einsum("kq,kqi->ki", half * WEIGHTS, force)

    def master(self, t: Any, lever_b: Any, C_b2m: Array, bend_rate_b: Any = 0.0) -> tuple[Array, Array]:
        """What a master reports that sees time t: v_m_n (..., 3), C_m2n (..., 3, 3).  lever_b: master to slave, m.

        bend_rate_b: (..., 3) rad/s at which the slave turns against the master, in the slave's axes.
        """
        C, omega_eb = self.C_b2n(t), self.rates(t)[2] - bend_rate_b
        v = self.velocity(t)[0] - np.einsum("...ij,...j->...i", C, np.cross(omega_eb, lever_b))
        return v, C @ np.swapaxes(C_b2m, -1, -2)


def matrix(euler: Any) -> Array:
    """C_b2n of roll, pitch, yaw (..., 3)."""
    euler = np.asarray(euler)
    return Rotation.from_euler("ZYX", euler[..., ::-1].reshape(-1, 3)).as_matrix().reshape((*euler.shape[:-1], 3, 3))


def turn(vector: Any) -> Array:
    """The rotation matrix of a rotation vector (..., 3)."""
    vector = np.asarray(vector, float)
    return Rotation.from_rotvec(vector.reshape(-1, 3)).as_matrix().reshape((*vector.shape[:-1], 3, 3))


def quaternion(C: Any) -> Array:
    """(..., 4) scalar first, of rotation matrices (..., 3, 3)."""
    q = Rotation.from_matrix(np.reshape(C, (-1, 3, 3))).as_quat().reshape((*np.shape(C)[:-2], 4))
    return np.roll(q, 1, axis=-1)


def turn_between(q_hat: Any, C: Array) -> Array:
    """(..., 3) the rotation e with C_hat = (I - [e x]) C, of an estimated quaternion and a true matrix."""
    q_hat = np.asarray(q_hat)
    C_hat = Rotation.from_quat(np.roll(q_hat.reshape(-1, 4), -1, axis=-1))
    true = Rotation.from_matrix(np.broadcast_to(C, (*q_hat.shape[:-1], 3, 3)).reshape(-1, 3, 3))
    return (true * C_hat.inv()).as_rotvec().reshape((*q_hat.shape[:-1], 3))


# The motions that the tests share.
def swinging(steady: Any = (7.0, 4.0, 0.0), **more: Any) -> Motion:
    """A vehicle that rolls, pitches and yaws, and moves with 8 m/s."""
    return Motion(
        swing=waves(
            ([6 * DEG, 3 * DEG, 8 * DEG], 0.17, [0.3, 1.2, 2.1]), ([2 * DEG, 1 * DEG, 3 * DEG], 0.41, [1, 2, 0.5])
        ),
        steady=np.asarray(steady, float),
        sway=waves(([1.5, 1.2, 0.8], 0.13, [0.1, 0.9, 2.5])),
        **more,
    )
