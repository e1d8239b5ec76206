"""Exact strapdown navigation: rates by Newton's law on the turning ellipsoid, errors put in by finite rotations."""

from dataclasses import dataclass

from boresight.derive.ledger import ellipsoid
from boresight.derive.ledger.ellipsoid import ENU, Level
from boresight.derive.ledger.numbers import Matrix, zeros
from boresight.derive.ledger.witness import finite_rotation, rotation_vector, skew, vector


class Navigator:
    """What a perfect or an erring navigator at one state computes.

    position: in the order of the level; v_n: over the ground; f_b, omega_ib_b: what the sensors show.
    """

    def __init__(self, position, v_n, C_b2n, f_b, omega_ib_b, level: Level = ENU):
        self.C_b2n, self.v_n = C_b2n, v_n
        axes, slope = level.axes(position), level.slope(position)
        self.position_rate = slope.solve(axes * v_n)
        self.axes, self.axes_rate = axes, ellipsoid.rate(lambda t: level.axes(position + t * self.position_rate))
        self.slope = slope
        turning = axes.T * self.axes_rate
        self.omega_en_n = vector(turning[2, 1], turning[0, 2], turning[1, 0])
        spin = vector(0, 0, ellipsoid.SPIN)
        self.omega_ie_n = axes.T * spin
        self.omega_in_n = self.omega_ie_n + self.omega_en_n
        self.gravity_n = level.gravity(position)
        self.f_n = C_b2n * f_b
        # Velocity over the ground in turning axes: gravity has the centrifugal part, Coriolis twice the spin.
        self.velocity_rate = (
            self.f_n + self.gravity_n - axes.T * (2 * skew(spin) * axes * v_n) + self.axes_rate.T * axes * v_n
        )
        self.C_rate = C_b2n * skew(omega_ib_b) - skew(self.omega_in_n) * C_b2n


def stack(*parts) -> Matrix:
    return vector(*(entry for part in parts for entry in (part if isinstance(part, Matrix | tuple) else (part,))))


def rotation_rate(matrix, rate) -> Matrix:
    """The rate of e in exp(-[e x]) = matrix, whose rate is given."""
    return ellipsoid.rate(lambda t: -rotation_vector(matrix + t * rate))


@dataclass(frozen=True, eq=False)
class Truth:
    """The true state of a navigator, and what follows from it alone."""

    position: Matrix
    v_n: Matrix
    C: Matrix
    f_b: Matrix
    omega: Matrix
    exact: Navigator
    level: Level = ENU

    def hat(self, x, noise) -> Navigator:
        """The navigator with the errors x: position, velocity, phi, gyro and accelerometer bias; noise (6)."""
        return Navigator(
            self.position + x[0:3, 0],
            self.v_n + x[3:6, 0],
            finite_rotation(-x[6:9, 0]) * self.C,
            self.f_b + x[12:15, 0] + noise[3:6, 0],
            self.omega + x[9:12, 0] + noise[0:3, 0],
            self.level,
        )

    def phi_rates(self, x, noise=None) -> Matrix:
        """(15) rates of the errors x of `hat`, against the true axes."""
        hat, exact = self.hat(x, zeros(6, 1) if noise is None else noise), self.exact
        turned, rate = hat.C_b2n * self.C.T, hat.C_rate * self.C.T + hat.C_b2n * exact.C_rate.T
        return stack(
            hat.position_rate - exact.position_rate,
            hat.velocity_rate - exact.velocity_rate,
            rotation_rate(turned, rate),
            zeros(6, 1),
        )

    def computed_level(self, position_error) -> Matrix:
        """C_n2c: from the true axes to those of the computed position."""
        return self.level.axes(self.position + position_error).T * self.exact.axes

    def psi_hat(self, x) -> Navigator:
        """The navigator with perfect sensors and the errors x: position, velocity and psi against the computed axes."""
        C_n2c = self.computed_level(x[0:3, 0])
        return Navigator(
            self.position + x[0:3, 0],
            C_n2c * self.v_n + x[3:6, 0],
            finite_rotation(-x[6:9, 0]) * C_n2c * self.C,
            self.f_b,
            self.omega,
            self.level,
        )

    def psi_rates(self, x) -> Matrix:
        """(9) rates of the errors x of `psi_hat`: the computed axes turn with the computed position."""
        hat, exact = self.psi_hat(x), self.exact
        C_n2c, C_n2c_rate = hat.axes.T * exact.axes, hat.axes_rate.T * exact.axes + hat.axes.T * exact.axes_rate
        C_b2c, C_b2c_rate = C_n2c * self.C, C_n2c_rate * self.C + C_n2c * exact.C_rate
        return stack(
            hat.position_rate - exact.position_rate,
            hat.velocity_rate - C_n2c_rate * self.v_n - C_n2c * exact.velocity_rate,
            rotation_rate(hat.C_b2n * C_b2c.T, hat.C_rate * C_b2c.T + hat.C_b2n * C_b2c_rate.T),
        )


def truth(position, v_n, C_b2n, f_b, omega_ib_b, level: Level = ENU) -> Truth:
    """The truth of these parts."""
    p, v, f, omega = Matrix(position), Matrix(v_n), Matrix(f_b), Matrix(omega_ib_b)
    return Truth(p, v, C_b2n, f, omega, Navigator(p, v, C_b2n, f, omega, level), level)
