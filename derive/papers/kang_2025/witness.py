"""Numbers for every letter of Kang 2025 at a point: the witness of its ledger.

Two ends of a rigid lever arm move over the turning ellipsoid.  Velocities and rates are differences of places and of
axes in many digits; the delay is in them because the master is looked at earlier.  No formula of the paper makes the
numbers that judge it.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from functools import lru_cache, partial
from typing import Any

from flint import fmpq

from boresight.derive.ledger import ellipsoid, navigation
from boresight.derive.ledger.ellipsoid import WORKING
from boresight.derive.ledger.equation import Relation
from boresight.derive.ledger.free import of, rotation, skew_symmetric
from boresight.derive.ledger.numbers import Matrix, asin, digits, exact, eye, norm, pi, zeros
from boresight.derive.ledger.paper import Stated, Witness
from boresight.derive.ledger.witness import (
    Letters,
    attitude,
    degrees,
    finite_rotation,
    quaternion,
    rotation_vector,
    skew,
    vector,
)


@dataclass(frozen=True, eq=False)
class Base:  # a key of the caches by itself: `draw` gives the same one for the same seed
    """What a point is made of; all else follows.  SI and rad; three components each, NED or slave body axes."""

    position: tuple  # longitude, latitude, height
    v_n: tuple
    acceleration: tuple  # of the slave over the ground
    jerk: tuple
    euler: tuple
    rate: tuple  # of the body against the Earth
    turn: tuple  # rate of change of that rate
    lever: tuple
    mounting: tuple
    velocity_error: tuple
    phi: tuple
    gyro_error: tuple
    dmu: tuple
    delay: tuple  # the first component alone
    step: tuple  # the first component alone
    wave: tuple  # height, frequency, time


@dataclass(frozen=True)
class Conditions:
    """The largest size of each part of a Base."""

    position: tuple = (3.0, 1.2, 100.0)
    v_n: float = 10.0
    acceleration: float = 2.0
    jerk: float = 2.0
    euler: tuple = (2.5, 1.2, 2.5)
    rate: float = 1.0
    turn: float = 1.0
    lever: float = 5.0
    mounting: float = 1.0
    velocity_error: float = 1.0
    phi: float = 0.05
    gyro_error: float = 0.02
    dmu: float = 0.05
    delay: float = 0.1
    step: float = 0.3
    wave: tuple = (4.0, 0.3, 20.0)


ERRORS = ("velocity_error", "phi", "gyro_error", "dmu", "delay", "step")

PARTS = {
    "velocity_error": "the velocity error",
    "phi": "the attitude error",
    "gyro_error": "the gyro error",
    "dmu": "the error of the misalignment",
    "delay": "the delay",
    "step": "the step",
    "lever": "the lever arm",
    "v_n": "the ship's velocity",
}
DEGREE = math.pi / 180
MIL = 360 / 6400 * DEGREE
ROLL, WAVE_RATE, DELAY = 5 * DEGREE, 0.1, 0.01  # of a stated hull; Hz of Table 1; s, the longest of Table 2
SURGE = 2 * math.pi * WAVE_RATE  # rad/s
# Tables 1 and 2 at grade 6, and what the paper leaves open: a hull that rolls and pitches by 5 deg with the wave,
# 5 m/s, a lever arm of 3 m per axis.
CONDITIONS = Conditions(
    position=(3.0, 40 * DEGREE, 10.0),
    v_n=5.0,
    acceleration=4 * SURGE**2,
    jerk=4 * SURGE**3,
    euler=(ROLL, ROLL, 2.5),
    rate=ROLL * SURGE,
    turn=ROLL * SURGE**2,
    lever=3.0,
    mounting=2 * DEGREE,
    velocity_error=0.1,
    phi=2 * DEGREE,
    gyro_error=10 * DEGREE / 3600,
    dmu=2 * DEGREE,
    delay=DELAY,
    step=1.0,
    wave=(4.0, WAVE_RATE, 60.0),
)
POINTS = 8  # of these conditions, drawn for the sizes
CONDITIONS_TEXT = (
    "grade 6, a hull that rolls and pitches by 5 deg at 0.1 Hz, 5 m/s, lever arm 3 m per axis, errors to 2 deg, delay "
    "10 ms, k and k-1 apart by 1 s"
)


def _numbers(*texts) -> tuple:
    return tuple(exact(text) for text in texts)


# The point at which an erratum's numbers are given.
STATED = Base(
    position=(*degrees(127, 37), exact(10)),
    v_n=_numbers(3, 4, 0),
    acceleration=_numbers("0.2", "-0.1", 1),
    jerk=_numbers(0, 0, "0.6"),
    euler=degrees(3, -2, 60),
    rate=degrees(3, 2, 1),
    turn=degrees(2, -1, "0.5"),
    lever=_numbers(3, 1, "-0.5"),
    mounting=degrees(1, -1, 2),
    velocity_error=_numbers("0.1", "-0.1", "0.05"),
    phi=degrees("0.1", "-0.2", 2),
    gyro_error=degrees("0.003", "-0.003", "0.003"),
    dmu=degrees("0.2", "0.1", "-0.1"),
    delay=_numbers("0.01", 0, 0),
    step=_numbers("0.01", 0, 0),
    wave=_numbers(4, "0.1", 2),
)
STATED_TEXT = (
    "roll, pitch, yaw 3, -2, 60 deg turning by 3, 2, 1 deg/s and 2, -1, 0.5 deg/s^2, accelerating by 0.2, -0.1, 1 "
    "m/s^2; lever arm 3, 1, -0.5 m; errors 0.1, -0.2, 2 deg in attitude, 0.2, 0.1, -0.1 deg in misalignment; delay and "
    "step 10 ms; a wave of 4 m at 0.1 Hz after 2 s"
)


# ---- Exact motion ----------------------------------------------------------------------------------------------------


def _ned(position) -> Matrix:
    """Columns: north, east and down in Earth's axes."""
    axes = ellipsoid.axes(position)
    east, north, up = (axes[:, i] for i in range(3))
    return Matrix([[north[i], east[i], -up[i]] for i in range(3)])


def after(function: Callable, t) -> Any:
    """The derivative of a function of time at t."""
    return ellipsoid.rate(lambda change: function(t + change))


def _turning(axes: Callable, t) -> Matrix:
    """Rate at t of axes (columns) against those in which they are given, in their own components."""
    return unskewed(axes(t).T * after(axes, t))


def unskewed(W: Matrix) -> Matrix:
    """The vector of a skew-symmetric matrix, from its entries under the diagonal."""
    return vector(W[2, 1], W[0, 2], W[1, 0])


class Motion:
    """Slave and master on a rigid hull, from Earth's axes; t = 0 is k.

    v_n, acceleration, jerk: of the slave over the ground, in n at k.  rate, turn: of the body against the Earth at k.
    """

    def __init__(self, position, v_n, acceleration, jerk, C_b2n, rate, turn, lever):
        self.start, self.lever = position, lever
        level = _ned(position)
        self.path = [level * part for part in (v_n, acceleration / 2, jerk / 6)]
        self.origin, self.inverse = ellipsoid.point(position), ellipsoid.slope(position).inv()
        self.C_b2e, self.rate, self.turn = level * C_b2n, rate, turn
        self.levels: dict[tuple[str, fmpq], Matrix] = {}

    def body(self, t) -> Matrix:
        """C_b2e."""
        return self.C_b2e * finite_rotation(self.rate * t + self.turn * t * t / 2)

    def slave(self, t) -> Matrix:
        first, second, third = self.path
        return self.origin + first * t + (second + third * t) * t * t

    def master(self, t) -> Matrix:
        return self.slave(t) - self.body(t) * self.lever

    def level(self, place: Matrix) -> Matrix:
        """North, east and down at a place near the start, by Newton's method with one slope."""
        position = self.start
        while norm(missing := place - ellipsoid.point(position)) > 1e-95:
            position = position + self.inverse * missing
        return _ned(position)

    def level_at(self, where: Callable, t) -> Matrix:
        """The same where one of them is at a time; many letters ask for one."""
        if not isinstance(t, fmpq):
            return self.level(where(t))
        key = where.__name__, t
        if key not in self.levels:
            self.levels[key] = self.level(where(t))
        return self.levels[key]

    def velocity(self, where: Callable, t) -> Matrix:
        """Over the ground, in the north, east and down of that place."""
        return self.level_at(where, t).T * after(where, t)

    def attitude(self, t) -> Matrix:
        """C_b2n, n at the slave."""
        return self.level_at(self.slave, t).T * self.body(t)

    def lever_rate(self, t) -> Matrix:
        return after(lambda s: self.attitude(s) * self.lever, t)

    def omega_in_n(self, t) -> Matrix:
        return _turning(lambda s: _inertial(s) * self.level_at(self.slave, s), t)

    def omega_ib_b(self, t) -> Matrix:
        return _turning(lambda s: _inertial(s) * self.body(s), t)

    def omega_nb_b(self, t) -> Matrix:
        return _turning(self.attitude, t)


def _inertial(t) -> Matrix:
    """C_e2i."""
    return finite_rotation([0, 0, ellipsoid.SPIN * t])


def motion(base: Base, erring: bool) -> Motion:
    """The true motion, or the one that the slave computes."""
    parts = {part.name: Matrix(getattr(base, part.name)) for part in fields(base)}
    share = int(erring)
    return Motion(
        parts["position"],
        parts["v_n"] + parts["velocity_error"] * share,
        parts["acceleration"],
        parts["jerk"],
        finite_rotation(-parts["phi"] * share) * attitude(base.euler),
        parts["rate"] + parts["gyro_error"] * share,
        parts["turn"],
        parts["lever"],
    )


def values(base: Base, definitions: Mapping[str, tuple[Relation, ...]]) -> Letters:
    """Values of every letter of the paper at one point; no equation of the paper is a definition that it needs.

    The letters of the slave are what it computes, those of the master what the master reports without error.
    """
    groups: tuple[tuple[str, Callable], ...] = (
        ("H_v|H_DCM|H_vL|H_DCML", lambda letters: measured(base)),
        ("F", lambda letters: [transfer(letters)]),
    )
    return Letters(groups, _world(base))


def transfer(letters: Mapping[str, Any]) -> Matrix:
    """F of the sixteen states, where the position is known, from Newton's law with the errors put in."""
    with digits(WORKING):
        place, v_n, C, f_b, omega_ib = (letters[name] for name in ("place", "v_s", "C_S2n", "f_b", "ω_ib_b"))
        by_all = ellipsoid.jacobian(navigation.truth(place, v_n, C, f_b, omega_ib, ellipsoid.NED).phi_rates, 15)
        at = (6, 7, 8, 3, 4, 5, *range(9, 15))  # attitude before velocity, no position
        rates = [[by_all[i, j] for j in at] + [0] * 4 for i in at]
        return Matrix(rates + [[0] * 16] * 4)


def measured(base: Base) -> list[Matrix]:
    """H of velocity and attitude, 3x16, and with the lever arm 3x19, in exact motion.

    Derivatives by what is taken out of the slave's estimates: errors of attitude, velocity, both biases, misalignment,
    delay and lever arm.

    A bias is measured - true, and the delay the age itself: so what each adds is with the other sign in the estimates.
    """
    with digits(WORKING):
        parts = {part.name: Matrix(getattr(base, part.name)) for part in fields(base)}
        slave, zero = motion(base, True), exact(0)
        C_b2m = finite_rotation(-parts["dmu"]) * finite_rotation(parts["mounting"])
        C, omega_ib, omega_in = slave.attitude(zero), slave.omega_ib_b(zero), slave.omega_in_n(zero)
        spin = slave.level_at(slave.slave, zero).T * vector(0, 0, ellipsoid.SPIN)

        def expected(x) -> tuple[Matrix, Matrix]:
            """Velocity and attitude of the master once these errors are taken out."""
            turned, shown = finite_rotation(x[0:3, 0]) * C, omega_ib - x[6:9, 0]
            true = Motion(
                parts["position"], slave.velocity(slave.slave, zero) - x[3:6, 0], parts["acceleration"], parts["jerk"],
                turned, shown - turned.T * spin, parts["turn"], slave.lever - x[16:19, 0],
            )  # fmt: skip
            age = -x[15]
            # The rate of the level is taken as known: what the error of the velocity does to it is no part of H.
            known = skew(true.omega_in_n(zero) - omega_in) * turned * true.lever
            velocity = true.velocity(true.slave, age) - true.lever_rate(age) - known
            return velocity, true.attitude(age) * (finite_rotation(x[12:15, 0]) * C_b2m).T

        at_rest = expected(zeros(19, 1))[1]
        velocity = -ellipsoid.jacobian(lambda x: expected(x)[0], 19)
        turn = -ellipsoid.jacobian(lambda x: rotation_vector(expected(x)[1] * at_rest.T), 19)
        return [velocity[:, 0:16], turn[:, 0:16], velocity, turn]


@lru_cache(maxsize=256)
def _world(base: Base) -> dict:
    with digits(WORKING):
        slave, truth = motion(base, True), motion(base, False)
        zero, delay, step = exact(0), base.delay[0], base.step[0]
        C_b2m = finite_rotation(base.mounting)
        C_M2S = (finite_rotation(-Matrix(base.dmu)) * C_b2m).T
        v_M, C_M2n = truth.velocity(truth.master, -delay), truth.attitude(-delay) * C_b2m.T
        C, v_k, v_old = slave.attitude(zero), slave.velocity(slave.slave, zero), slave.velocity(slave.slave, -delay)
        C_old, C_rate, u_old = slave.attitude(-delay), after(slave.attitude, zero), -slave.lever_rate(-delay)
        omega_in_n, omega_ib_b = slave.omega_in_n(zero), slave.omega_ib_b(zero)
        C_n2e, C_n2e_master = slave.level_at(slave.slave, zero), slave.level_at(slave.master, zero)
        e = rotation_vector(C * C_M2S * C_M2n.T)
        height, frequency, time = base.wave
        # A point on a wheel as high as the wave, which turns `frequency` times a second and rises at the start.
        wheel = finite_rotation([2 * pi() * frequency * time, 0, 0]) * vector(0, height / 2, 0)
        return {
            "v_m": slave.velocity(slave.master, zero),
            "v_s": v_k,
            "v_S": v_k,
            "v_s(k)": v_k,
            "v_s(k-1)": slave.velocity(slave.slave, -step),
            "v_s(k+α)": v_old,
            "v̇_s": after(partial(slave.velocity, slave.slave), zero),
            "v_m(k+α)": slave.velocity(slave.master, -delay),
            "v_M": v_M,
            "dL/dt": slave.lever_rate(zero),
            "u(k)": -slave.lever_rate(zero),
            "u(k-1)": -slave.lever_rate(-step),
            "u(k+α)": u_old,
            "z_v": v_old + u_old - v_M,
            "L": slave.lever,
            "r_s": slave.slave(zero),
            "ṙ_s": after(slave.slave, zero),
            "ṙ_m": after(slave.master, zero),
            "ω_in_n": omega_in_n,
            "ω_ib_b": omega_ib_b,
            "[ω_in_n x]": skew(omega_in_n),
            "[ω_ib_b x]": skew(omega_ib_b),
            "ω_nb_b": slave.omega_nb_b(zero),
            "ω_nb_n": unskewed(C_rate * C.T),
            "C_S2n": C,
            "Ċ_S2n": C_rate,
            "C_S2n(k+α)": C_old,
            "u̇": -after(slave.lever_rate, zero),
            "place": vector(base.position[1], base.position[0], base.position[2]),
            "f_b": C.T * (Matrix(base.acceleration) - vector(0, 0, ellipsoid.AT_EQUATOR)),
            "Q_S2n": quaternion(C),
            "Q_S2M": quaternion(C_M2S.T),
            "Q_M2n": quaternion(C_M2n),
            "C_S2e": slave.body(zero),
            "Ċ_S2e": after(slave.body, zero),
            "C_e2n": C_n2e.T,
            "Ċ_e2n": after(lambda t: slave.level_at(slave.slave, t).T, zero),
            "ΔC_e2n": (C_n2e_master - C_n2e).T,
            "C_M2S": C_M2S,
            "C_M2n": C_M2n,
            "C_n2M": C_M2n.T,
            "e": e,
            "A": skew(e),
            "z_DCM": rotation_vector(C_old * C_M2S * C_M2n.T),
            "I": eye(3),
            "dt": step,
            "δt_d": delay,
            "t": time,
            "Seawave": wheel[2],
            "a": height,
            "f": frequency,
            "π": pi(),
            "asin": asin,
        }  # fmt: skip


# What letters are by their nature.
STRUCTURE = {
    **dict.fromkeys(("C_S2n", "C_M2S", "C_M2n", "C_S2e", "C_e2n"), rotation),
    "C_n2M": of("C_M2n", lambda C: C.T),
    "[ω_in_n x]": of("ω_in_n", skew),
    "[ω_ib_b x]": of("ω_ib_b", skew),
    "A": skew_symmetric,
    "v_s": of("v_s(k)", lambda v: v),  # the indices s and S are one label, and k is now
    "v_S": of("v_s(k)", lambda v: v),
    "I": lambda generator: eye(3),
    "π": lambda generator: pi(),
}

WITNESS = Witness(Base, values, Conditions(), ERRORS, "finite motions", PARTS)
SIZES = Stated(CONDITIONS, CONDITIONS_TEXT, POINTS)
POINT = Stated(STATED, STATED_TEXT)
