"""A flight given in closed form, and what ideal sensors integrate on it, in Earth-centred inertial axes.

Nothing here uses a local level's rates: specific force is the second derivative of the place in inertial space minus
gravitation, angular rate the derivative of the attitude in inertial space.
"""

from functools import cache

import numpy as np
import sympy as sp
from sympy import Matrix, Rational, cos, pi, sin

from boresight.derive.mechanics import rotation as rot

T = sp.Symbol("t", real=True)
A, E2, RATE = 6378137, sp.Float("6.69437999014132e-3", 30), Rational("7.292115e-5")
NED2ENU = np.array([[0, 1, 0], [1, 0, 0], [0, 0, -1.0]])
# A cruise at 60 m/s with turns, climbs and a rolling, pitching, yawing body; amplitudes in m and rad, periods in s.
LAT = Rational("0.63") + Rational("4e-6") * T + 60 * sin(2 * pi * T / 20) / Rational("6.37e6")
LON = Rational("2.21") + Rational("9e-6") * T + 40 * sin(2 * pi * T / 13 + 1) / Rational("5.1e6")
HEIGHT = 120 + T + 10 * sin(2 * pi * T / 11)
EULER = Matrix(
    [
        Rational("0.2") * sin(2 * pi * T / 3 + 1),
        Rational("0.1") * sin(2 * pi * T / 4),
        Rational("0.7") + Rational("0.3") * sin(2 * pi * T / 9) + T / 100,
    ]
)


def numbers(expression):
    compiled = sp.lambdify(T, expression, modules="numpy", cse=True)

    def at(t):
        """(...,) s -> (..., rows) or (..., rows, columns)"""
        t = np.asarray(t, float)
        return np.stack([np.array(compiled(float(s)), dtype=float) for s in t.ravel()]).reshape(
            *t.shape, *[n for n in expression.shape if n > 1]
        )

    return at


@cache
def flight():
    """Functions of time in ENU, body right-front-up: coordinates (lon, lat, height), v_n, C_b2n, f_b, omega_ib_b."""
    w = sp.sqrt(1 - E2 * sin(LAT) ** 2)
    normal, meridian = A / w, A * (1 - E2) / w**3
    inertial = LON + RATE * T
    r = Matrix(
        [
            (normal + HEIGHT) * cos(LAT) * cos(inertial),
            (normal + HEIGHT) * cos(LAT) * sin(inertial),
            (normal * (1 - E2) + HEIGHT) * sin(LAT),
        ]
    )
    up = Matrix([cos(LAT) * cos(inertial), cos(LAT) * sin(inertial), sin(LAT)])
    east = Matrix([-sin(inertial), cos(inertial), 0])
    C_n2i = Matrix.hstack(east, up.cross(east), up)
    N = Matrix(NED2ENU.astype(int))
    C_b2n = N * rot.dcm_from_euler(*EULER) * N
    C_b2i = C_n2i * C_b2n
    pole = Matrix([0, 0, RATE])
    gravity = normal_gravity(LAT, HEIGHT)
    gravitation = -gravity * up + pole.cross(pole.cross(r))  # what is felt at rest is gravitation minus centrifugal
    f_b = C_b2i.T * (r.diff(T, 2) - gravitation)
    omega = rot.vee(C_b2i.T * C_b2i.diff(T))
    v = Matrix([LON.diff(T) * (normal + HEIGHT) * cos(LAT), LAT.diff(T) * (meridian + HEIGHT), HEIGHT.diff(T)])
    return {
        name: numbers(value)
        for name, value in {
            "position": Matrix([LON, LAT, HEIGHT]), "v_n": v, "C_b2n": C_b2n, "f_b": f_b, "omega_ib_b": omega,
        }.items()
    }  # fmt: skip


def normal_gravity(lat, height):
    """Somigliana, to the second power of height, from the published rounded constants of WGS 84."""
    s2 = sin(lat) ** 2
    f, m = sp.Float("3.35281066474748e-3", 30), sp.Float("3.449786506841e-3", 30)
    g0 = sp.Float("9.7803253359", 30) * (1 + sp.Float("1.931852652458e-3", 30) * s2) / sp.sqrt(1 - E2 * s2)
    return g0 * (1 - 2 * (1 + f + m - 2 * f * s2) * height / A + 3 * height**2 / A**2)


@cache
def integrals(seconds, rate_hz):
    """Increments dtheta and dv over each interval (T+1, 3), the first before time 0: Gauss-Legendre, 5 points."""
    nodes, weights = np.polynomial.legendre.leggauss(5)
    dt = 1 / rate_hz
    t = (np.arange(-1, round(seconds * rate_hz)) * dt)[:, None] + dt / 2 * (1 + nodes)
    known = flight()
    return tuple(np.einsum("k,tki->ti", weights * dt / 2, known[name](t)) for name in ("omega_ib_b", "f_b"))
