"""Exact rates of strapdown navigation as SymPy expressions, and what differentiating them by the errors gives.

A place on the ellipsoid is a point and three axes; rates of coordinates, of axes and of velocities are their
derivatives.  Errors are put in as they are, turns as finite rotations, scaled by a number; the derivative by that
number, at zero, is linear in the errors, and its columns are F.  Nothing of derive/mechanics is used here.
"""

from dataclasses import dataclass
from functools import cache

from sympy import (
    Derivative,
    Expr,
    Function,
    ImmutableMatrix,
    Matrix,
    Symbol,
    cos,
    count_ops,
    expand,
    eye,
    factor_terms,
    sin,
    symbols,
    tan,
    trigsimp,
    zeros,
)

from boresight.derive.ledger.ellipsoid import ENU, Level

LAT, LON, HEIGHT = symbols("L λ h", real=True)
NORTH, EAST, UP = symbols("v_N v_E v_U", real=True)
FORCES = symbols("f_N f_E f_U", real=True)
SPIN = Symbol("Ω", real=True)  # of the Earth
# Radii of curvature, gravity, and how they change with latitude and height.
R_N, R_E, G = symbols("R_N R_E γ", real=True)
R_NN, R_EE, G_L, G_H = symbols("R_NN R_EE γ_L γ_h", real=True)
_R_N, _R_E, _G = Function("R_N"), Function("R_E"), Function("g")
_SCALE = Symbol("s", real=True)


def skew(v) -> Matrix:
    x, y, z = v
    return Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def vee(M) -> Matrix:
    return Matrix([M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]]) / 2


def turned(v) -> Matrix:
    """The finite rotation by -v in Rodrigues' parameters, by 2 atan(|v| / 2); to first order exp(-[v x])."""
    return eye(3) - (skew(v) - skew(v) ** 2 / 2) / (1 + v.dot(v) / 4)


# ---- A level on the ellipsoid ----------------------------------------------------------------------------------------


def enu(vector_n, level: Level) -> Matrix:
    """East, north and up of a vector's components in the level."""
    result = zeros(3, 1)
    for entry, (which, sign) in zip(vector_n, level.along, strict=True):
        result[which] = sign * entry
    return result


def local(east_north_up, level: Level) -> Matrix:
    """The components in the level."""
    return Matrix([sign * east_north_up[which] for which, sign in level.along])


def geographic(position, level: Level) -> tuple:
    """Longitude, latitude, height."""
    return tuple(position[level.order.index(i)] for i in range(3))


def axes(position, level: Level) -> Matrix:
    """The level's axes as columns, in Earth's."""
    lon, lat, _ = geographic(position, level)
    up = Matrix([cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat)])
    columns = (Matrix([-sin(lon), cos(lon), 0]), _north(lon, lat), up)
    return Matrix.hstack(*(sign * columns[which] for which, sign in level.along))


def _north(lon, lat) -> Matrix:
    return Matrix([-sin(lat) * cos(lon), -sin(lat) * sin(lon), cos(lat)])


@cache
def _slopes() -> ImmutableMatrix:
    """East, north and up by longitude, latitude and height, m: the point of the meridian's curve and the height.

    The curve is at R_E cos(L) from the pole's axis, since its normal meets that axis after R_E; R_N is its radius of
    curvature, so its tangent, to the north, is R_N (-sin(L), cos(L)).
    """
    ground = Function("X")(LAT), Function("Z")(LAT)
    place = [(ground[0] + HEIGHT * cos(LAT)) * part for part in (cos(LON), sin(LON))]
    point = Matrix([*place, ground[1] + HEIGHT * sin(LAT)])
    tangent = {Derivative(ground[0], LAT): -R_N * sin(LAT), Derivative(ground[1], LAT): R_N * cos(LAT)}
    by = point.jacobian([LON, LAT, HEIGHT]).subs(tangent).subs(ground[0], R_E * cos(LAT))
    columns = axes((LON, LAT, HEIGHT), ENU)
    return ImmutableMatrix((columns.T * by).applyfunc(lambda e: factor_terms(_squared(e))))


@cache
def _general(level: Level) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Rates of longitude, latitude and height, and of the level against the Earth, of place and speed in letters."""
    moved = _slopes().inv() * Matrix([EAST, NORTH, UP])
    here = axes([(LON, LAT, HEIGHT)[i] for i in level.order], level)
    by_lon, by_lat = ((here.T * here.diff(coordinate)).applyfunc(_squared) for coordinate in (LON, LAT))
    turning = vee(by_lon * moved[0] + by_lat * moved[1]).applyfunc(trigsimp)
    return ImmutableMatrix(moved), ImmutableMatrix(turning)


class Rates:
    """What a navigator at a position with a velocity computes, each with its derivative; f_n its specific force."""

    def __init__(self, position: Matrix, v_n: "Varied", f_n: "Varied", level: Level):
        lon, lat, height = geographic(position, level)
        speeds = dict(zip((EAST, NORTH, UP), enu(v_n.at_zero + _SCALE * v_n.slope, level), strict=True))
        here = {LAT: lat, LON: lon, HEIGHT: height, R_N: _R_N(lat), R_E: _R_E(lat), **speeds}
        moved, turning = (varied(part.subs(here, simultaneous=True)) for part in _general(level))
        self.position = Varied(*(Matrix([part[i] for i in level.order]) for part in (moved.at_zero, moved.slope)))
        self.omega_en = turning
        self.omega_ie = varied(local(SPIN * Matrix([0, cos(lat), sin(lat)]), level))
        self.omega_in = self.omega_ie + self.omega_en
        gravity = varied(local(Matrix([0, 0, -_G(lat, height)]), level))
        # Newton: the acceleration against inertial axes, less the turn of the level and the Earth's own
        turn = self.omega_ie + self.omega_ie + self.omega_en
        self.velocity = f_n + gravity - turn.skew() * v_n


@dataclass(frozen=True)
class Varied:
    """A matrix that depends on the scale of the errors: at zero, and its derivative there by the product rule."""

    at_zero: Matrix
    slope: Matrix

    def __add__(self, other: "Varied") -> "Varied":
        return Varied(self.at_zero + other.at_zero, self.slope + other.slope)

    def __sub__(self, other: "Varied") -> "Varied":
        return Varied(self.at_zero - other.at_zero, self.slope - other.slope)

    def __mul__(self, other: "Varied") -> "Varied":
        return Varied(self.at_zero * other.at_zero, self.slope * other.at_zero + self.at_zero * other.slope)

    @property
    def T(self) -> "Varied":
        return Varied(self.at_zero.T, self.slope.T)

    def skew(self) -> "Varied":
        return Varied(skew(self.at_zero), skew(self.slope))


def varied(matrix: Matrix) -> Varied:
    """A matrix of the scale, differentiated at zero."""
    slope = matrix.diff(_SCALE).subs(_SCALE, 0).doit()
    return Varied(*(part.applyfunc(named) for part in (matrix.subs(_SCALE, 0), slope)))


def state(level: Level) -> tuple[Matrix, Matrix, Matrix]:
    """Position, velocity and specific force in letters."""
    position = Matrix([(LON, LAT, HEIGHT)[i] for i in level.order])
    return position, local((EAST, NORTH, UP), level), local((FORCES[1], FORCES[0], FORCES[2]), level)


# ---- Errors ----------------------------------------------------------------------------------------------------------

ERROR = Matrix(symbols("x_:9", real=True))


@cache
def F_phi(level: Level) -> ImmutableMatrix:
    """F of position, velocity and phi."""
    p, v, f = state(level)
    x = _SCALE * ERROR
    E = varied(turned(x[6:9, 0]))
    true = _true(level)
    hat = Rates(p + x[0:3, 0], varied(v + x[3:6, 0]), E * varied(f), level)
    # C_hat C' = E turns with the computed level and against the true one; the body's rate is in both
    E_rate = E * true.omega_in.skew() - hat.omega_in.skew() * E
    return _columns(hat.position - true.position, hat.velocity - true.velocity, _angle(E_rate))


@cache
def F_psi(level: Level) -> ImmutableMatrix:
    """F of position, velocity and psi against the computed level."""
    p, v, f = state(level)
    x = _SCALE * ERROR
    C_n2c, E = _to_computed(level), varied(turned(x[6:9, 0]))
    true = _true(level)
    hat = Rates(p + x[0:3, 0], C_n2c * varied(v) + varied(x[3:6, 0]), E * C_n2c * varied(f), level)
    C_n2c_rate = C_n2c * true.omega_en.skew() - hat.omega_en.skew() * C_n2c
    # how the level c turns against inertial axes where the body stands still in them
    carried = C_n2c * C_n2c_rate.T + C_n2c * true.omega_in.skew() * C_n2c.T
    E_rate = E * carried - hat.omega_in.skew() * E
    v_rate = C_n2c_rate * varied(v) + C_n2c * true.velocity
    return _columns(hat.position - true.position, hat.velocity - v_rate, _angle(E_rate))


@cache
def T_psi(level: Level) -> ImmutableMatrix:
    """Position, velocity error and psi by position, velocity error and phi."""
    _, v, _ = state(level)
    x = _SCALE * ERROR
    C_n2c = _to_computed(level)
    against_c = varied(turned(x[6:9, 0])) * C_n2c.T  # C_hat_b2n C' C_n2c'
    return _columns(varied(x[0:3, 0]), varied(v + x[3:6, 0]) - C_n2c * varied(v), _angle(against_c))


@cache
def _true(level: Level) -> Rates:
    """Rates without errors."""
    p, v, f = state(level)
    return Rates(p, varied(v), varied(f), level)


@cache
def _to_computed(level: Level) -> Varied:
    """C_n2c."""
    p, _, _ = state(level)
    C = varied(axes(p + _SCALE * ERROR[0:3, 0], level).T * axes(p, level))
    return Varied(C.at_zero.applyfunc(_squared), C.slope.applyfunc(_squared))


def _squared(entry: Expr) -> Expr:
    """A polynomial of sines and cosines without squares of sines: what trigsimp makes of it, sooner."""
    for angle in (LON, LAT):
        entry = expand(expand(entry).subs(sin(angle) ** 2, 1 - cos(angle) ** 2))
    return entry


def _angle(E: Varied) -> Varied:
    """Of exp(-[e x]), or of its rate, e or its rate to first order."""
    return Varied(-vee(E.at_zero), -vee(E.slope))


def _columns(*errors: Varied) -> ImmutableMatrix:
    """The derivatives, which are linear in the errors, by each error."""
    return ImmutableMatrix(Matrix.vstack(*(e.slope for e in errors)).jacobian(ERROR).applyfunc(_short))


def named(expression: Expr) -> Expr:
    letters = {
        Derivative(_R_N(LAT), LAT): R_NN,
        Derivative(_R_E(LAT), LAT): R_EE,
        Derivative(_G(LAT, HEIGHT), LAT): G_L,
        Derivative(_G(LAT, HEIGHT), HEIGHT): G_H,
        _R_N(LAT): R_N,
        _R_E(LAT): R_E,
        _G(LAT, HEIGHT): G,
    }
    return expression.subs(letters)


def _short(entry: Expr) -> Expr:
    """The shorter of the entry and its expansion, in which terms cancel; factored as far as a reader wants it."""
    entry = entry.subs(tan(LAT) ** 2 + 1, 1 / cos(LAT) ** 2)
    return min((factor_terms(e) for e in (entry, expand(entry))), key=count_ops)
