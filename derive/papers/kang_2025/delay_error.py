"""The steady heading error of a transfer alignment that does not know how old its master's data is.

The master's data is old by tau > 0 and the filter believes that it is not.  All over a swinging hull the attitude
residual then carries the turn of the last tau seconds, and the filter has one constant with which to explain it: a
misalignment about the vertical, which mixes roll and pitch.  What is derived here is where its estimate goes.

Conventions of the model velocity-attitude: NED, error = computed - true, C_hat_b2n = (I - [phi x]) C_b2n,
C_hat_b2m = (I - [dmu x]) C_b2m with dmu in master axes.  `heading` errors are yaw_hat - yaw = -phi_d.
Roll, pitch and yaw here are their parts about the mean.
"""

from functools import cache

from sympy import (
    Matrix,
    Poly,
    S,
    Symbol,
    cos,
    diff,
    eye,
    integrate,
    linsolve,
    pi,
    simplify,
    sin,
    symbols,
    zeros,
)

from boresight.derive.ledger.equation import Derivation, Relation, Step, column, matrix, product
from boresight.derive.mechanics.rotation import dcm_from_euler, rotation_z
from boresight.derive.papers.kang_2025 import results as kang_2025

SWING = ROLL, PITCH, YAW = symbols("r p s", real=True)
RATE = ROLL_RATE, PITCH_RATE, YAW_RATE = symbols("r' p' s'", real=True)
HEADING = Symbol("psi", real=True)
DELAY = Symbol("tau", positive=True)
DMU = Matrix(symbols("dmu_x dmu_y dmu_z", real=True))
V_NORTH, V_EAST, A_NORTH, A_EAST = symbols("v_n v_e a_n a_e", real=True)
SIGMA_ANGLE, SIGMA_VELOCITY = symbols("sigma_a sigma_v", positive=True)
AMPLITUDES = ROLL_AMPLITUDE, PITCH_AMPLITUDE = symbols("R P", positive=True)
FREQUENCY, PHASE, TIME = Symbol("omega", positive=True), Symbol("epsilon", real=True), Symbol("t", real=True)
MOVING = (*SWING, *RATE, V_NORTH, V_EAST, A_NORTH, A_EAST)


def first_order(expression, *small):
    """The part of an expression that is of first order or less in all the `small` together."""
    scale = Symbol("s")
    scaled = expression.subs({symbol: scale * symbol for symbol in small}, simultaneous=True)
    return simplify(scaled.subs(scale, 0) + scaled.diff(scale).subs(scale, 0))


@cache
def residual() -> Matrix:
    """What of z_dcm varies with the swing, in level axes along the heading, 3x1 rad; the states are constant.

    z = H x of the model's own H, with x = (phi, ..., dmu, d_tau) and d_tau = 0 - tau.
    """
    C_m2n = dcm_from_euler(ROLL, PITCH, HEADING + YAW)
    # the rate of the body against the level, from its own matrix: the vector of C' C^T
    turn = sum((C_m2n.diff(angle) * rate for angle, rate in zip(SWING, RATE, strict=True)), zeros(3)) * C_m2n.T
    omega_nb = Matrix([turn[2, 1], turn[0, 2], turn[1, 0]])
    H = kang_2025.attitude_matrix(C_m2n, omega_nb)
    z = rotation_z(HEADING).T * (H[:, 12:15] * DMU - H[:, 15] * DELAY)
    # products of the misalignment with an angle, and of the delay with a rate, are the first that do not stand still
    small = SWING + RATE
    varying = z - z.subs(dict.fromkeys(small, 0))
    return varying.applyfunc(lambda entry: first_order(entry, *small))


def steady(expression):
    """The same where the yaw is constant."""
    return expression.subs({YAW: 0, YAW_RATE: 0})


def velocity_residual() -> Matrix:
    """What of z_v varies, north and east, 2x1 m/s, if the heading errs by phi_d = dmu_z: see `steady_misalignment`.

    dv' = f x phi, and f = a where the velocity changes: dv = v x phi_d; and the master's velocity is old by tau.
    """
    dv = Matrix([V_NORTH, V_EAST, 0]).cross(Matrix([0, 0, DMU[2]]))
    return dv[:2, :] + DELAY * Matrix([A_NORTH, A_EAST])


def mean(expression):
    """The mean over time: a symbol <x y> for each product of two moving quantities, which have no mean themselves."""
    total = S.Zero
    for powers, coefficient in Poly(expression, *MOVING).terms():
        factors = [symbol for symbol, power in zip(MOVING, powers, strict=True) for _ in range(power)]
        if len(factors) == 1:
            continue
        total += coefficient * (moment(*factors) if factors else 1)
    return total


def moment(a, b) -> Symbol:
    """<a b>, the mean of a product."""
    first, second = sorted((a, b), key=MOVING.index)
    return Symbol(f"<{first} {second}>", real=True)


def minimum(*weighted) -> dict:
    """The misalignment at the minimum of the mean of sum(weight residual^2).  weighted: (residual, weight)."""
    cost = mean(sum(weight * (entries.T * entries)[0] for entries, weight in weighted).expand())
    unknown = [symbol for symbol in DMU if cost.has(symbol)]
    (solution,) = linsolve([cost.diff(symbol) for symbol in unknown], unknown)
    return {symbol: simplify(value) for symbol, value in zip(unknown, solution, strict=True)}


@cache
def steady_misalignment():
    """dmu_z of attitude matching: tau (<r p'> - <p r'>) / (<r^2> + <p^2>).  Also phi_d, and minus the heading error.

    For any swing, regular or not, that is long against its own period.
    """
    return minimum((steady(residual()), 1))[DMU[2]]


def spread() -> Matrix:
    """<|e|^2 I - e e'>, 3x3, of the swing e = (r, p, s): its moment of inertia, were it a cloud of points."""
    e = Matrix(SWING)
    return (e.dot(e) * eye(3) - e * e.T).applyfunc(mean)


def spin() -> Matrix:
    """<e x e'>, 3x1: its angular momentum."""
    return Matrix(SWING).cross(Matrix(RATE)).applyfunc(mean)


@cache
def steady_misalignment_with_velocity():
    """The same where the velocity is matched as well: white noises sigma_a, sigma_v, equal on all axes."""
    return minimum((steady(residual()), SIGMA_ANGLE**-2), (velocity_residual(), SIGMA_VELOCITY**-2))[DMU[2]]


@cache
def sinusoidal():
    """dmu_z of r = R sin(omega t), p = P sin(omega t + epsilon), with no horizontal acceleration."""
    roll, pitch = ROLL_AMPLITUDE * sin(FREQUENCY * TIME), PITCH_AMPLITUDE * sin(FREQUENCY * TIME + PHASE)
    moving = {ROLL: roll, PITCH: pitch, ROLL_RATE: diff(roll, TIME), PITCH_RATE: diff(pitch, TIME)}
    period = 2 * pi / FREQUENCY

    def over_a_period(product):
        return simplify(integrate(product.rewrite(cos).expand(trig=True), (TIME, 0, period)) / period)

    means = {
        moment(a, b): over_a_period(moving[a] * moving[b])
        for a, b in ((ROLL, ROLL), (PITCH, PITCH), (ROLL, PITCH_RATE), (PITCH, ROLL_RATE))
    }
    return simplify(steady_misalignment().subs(means))


@cache
def derivation() -> Derivation:
    """From the model's H to the closed form, by named steps."""
    z = Symbol("z_dcm")
    dmu_z, heading = DMU[2], Symbol("yaw_hat - yaw")
    ratio = Symbol("rho", positive=True)
    by_ratio = simplify(sinusoidal().subs(PITCH_AMPLITUDE, ratio * ROLL_AMPLITUDE))
    largest = sinusoidal().subs({PITCH_AMPLITUDE: ROLL_AMPLITUDE, PHASE: -pi / 2})
    return Derivation(
        (
            Step(
                "substitute",
                (Relation((Symbol("d_tau"), -DELAY)),),
                "without compensation the estimate of the delay is zero, and its error minus the delay",
            ),
            Step(
                "keep first order",
                (Relation((z, matrix(residual()))),),
                "the model's z = H x in level axes along the heading: phi and dmu are constants, and what varies is "
                "e x dmu + e' tau, of the swing e = (r, p, s) of roll, pitch and yaw",
            ),
            Step(
                "leave out the mean",
                (),
                "the constants -phi + dmu take it up, whatever phi is, which is in no other term.  The vertical one "
                "holds phi_d to dmu_z, so that the heading error is -dmu_z",
            ),
            Step(
                "least squares",
                (Relation((product(matrix(spread()), matrix(DMU)), product(DELAY, matrix(spin())))),),
                "the integral of z_dcm^2 over the time is least: the limit of a filter whose prior is used up and "
                "whose three rows have equal weight, at each frequency: white noise, or the gyros' random walk "
                "between.  The left is a moment of inertia, the right an angular momentum: the misalignment errs by "
                "what the swing turns on in tau, as if it were a rigid body",
            ),
            Step(
                "keep the yaw at rest",
                (Relation((dmu_z, steady_misalignment())),),
                "dmu_x and dmu_y stay right, and the vertical row plays no part",
            ),
            Step(
                "insert sinusoids",
                (
                    Relation((column(ROLL, PITCH), column(ROLL_AMPLITUDE * sin(FREQUENCY * TIME),
                                                          PITCH_AMPLITUDE * sin(FREQUENCY * TIME + PHASE)))),
                    Relation((dmu_z, sinusoidal())),
                    Relation((heading, -sinusoidal())),
                ),
                "means over a period; pitch leads roll by epsilon",
            ),
            Step(
                "look at it",
                (Relation((dmu_z, by_ratio)), Relation((Symbol("max dmu_z"), largest))),
                "the size of the sea cancels, only the ratio rho = P / R remains, and the heading is not in it.  "
                "Largest, tau omega, for equal amplitudes a quarter of a period apart, where misalignment and delay "
                "are one and the same signal, and zero for roll and pitch in phase",
            ),
            Step(
                "add the velocity",
                (
                    Relation((Symbol("z_v"), matrix(velocity_residual()))),
                    Relation((dmu_z, steady_misalignment_with_velocity())),
                ),
                "where the hull surges and sways the velocity has a say of the same form, by its own noise; where it "
                "only heaves, none.  The lever arm is in neither: its velocity cancels where it is expected",
            ),
        )
    )  # fmt: skip
