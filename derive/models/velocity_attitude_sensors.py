"""Velocity-attitude matching with sensors that are not ideal, on a hull that bends: each part a composition of its own.

A part is a function from a model to a larger one, so that any of them alone makes a filter too.  A filter that flies
the whole leaves a part out by zero variance and zero noise of its states.
"""

from dataclasses import replace

from sympy import Expr, Matrix, Symbol, diag, eye, zeros

from boresight.derive.expressions import substituted
from boresight.derive.mechanics.rotation import dcm_from_quaternion, normalized, quaternion_product, skew
from boresight.derive.model import Function, Measurement, Model, Output, Struct, Variable, variable
from boresight.derive.models import velocity_attitude as va
from boresight.derive.models.variables import (
    ACCEL_BIAS,
    BA,
    BG,
    D_BA,
    D_BG,
    DT,
    F_B,
    GYRO_BIAS,
    INCREMENTS,
    MASTER_BODY,
    OMEGA_IB_B,
    body,
    noise_density,
)
from boresight.derive.models.velocity_attitude_lever import velocity_attitude_lever
from boresight.derive.named import named


def velocity_attitude_sensors() -> Model:
    """Lever arm, biases that wander about a constant, scale factors, axes and bending: 46 states."""
    return replace(
        wandering(scaled(bent(velocity_attitude_lever()))),
        name="velocity-attitude-sensors",
        c_prefix="vas",
        title="velocity and attitude with lever arm, sensor errors and bending, 46 states",
    )


def replaced(m: Measurement, inputs: dict[Symbol, Expr], errors: dict[Symbol, Expr]) -> Measurement:
    """The measurement with other expressions for its inputs, and in the exact h for its errors too."""
    law = m.first_order
    tied = tuple((name, substituted(e, inputs)) for name, e in law.tied) if law else ()
    return replace(
        m,
        z=None if m.z is None else substituted(m.z, inputs),
        h=None if m.h is None else substituted(m.h, errors),
        H=None if m.H is None else substituted(m.H, inputs),
        first_order=replace(law, tied=tied) if law else None,
    )


def function(model: Model, name: str, *more: Output, **inputs: dict[Symbol, Expr]) -> Function:
    """A function of the model with outputs added, or with other expressions for its inputs."""
    found = next(f for f in model.functions if f.name == name)
    outputs = tuple(replace(o, value=substituted(o.value, inputs["over"])) if inputs else o for o in found.outputs)
    names = {o.name for o in more}
    return replace(found, outputs=(*(o for o in outputs if o.name not in names), *more))


def place(model: Model, state: Variable) -> slice:
    """Where in the model's state this one stands."""
    at = list(model.x).index(state.symbols[0])
    return slice(at, at + state.size)


def less_error(estimate: Variable, error: Variable) -> Output:
    return Output(estimate.name, estimate.vector - error.vector, estimate.unit, estimate.meaning, estimate.frame)


# ---------------------------------------------------------------- bias instability

GYRO_TURN_ON = body("gyro_turn_on", "bg0", "rad/s", "estimated constant part of the gyro bias", -GYRO_BIAS, GYRO_BIAS)
ACCEL_TURN_ON = body("accel_turn_on", "ba0", "m/s^2", "estimated constant part of the accelerometer bias", -ACCEL_BIAS,
                     ACCEL_BIAS)  # fmt: skip
D_GYRO_TURN_ON = body("d_gyro_turn_on", "dbg0", "rad/s", "error of the gyro bias' constant part, estimated - true",
                      -GYRO_BIAS, GYRO_BIAS)  # fmt: skip
D_ACCEL_TURN_ON = body("d_accel_turn_on", "dba0", "m/s^2", "error of the accelerometer bias' constant part",
                       -ACCEL_BIAS, ACCEL_BIAS)  # fmt: skip
GYRO_BETA = body("gyro_bias_beta", "beta_g", "1/s", "one over the correlation time of the gyro biases", 0.0, 10.0)
ACCEL_BETA = body("accel_bias_beta", "beta_a", "1/s", "one over the correlation time of the accelerometer biases", 0.0,
                  10.0)  # fmt: skip
BIASES = (
    (BG, D_BG, GYRO_TURN_ON, D_GYRO_TURN_ON, GYRO_BETA),
    (BA, D_BA, ACCEL_TURN_ON, D_ACCEL_TURN_ON, ACCEL_BETA),
)


def wandering(base: Model) -> Model:
    """Biases that are first-order Gauss-Markov processes about a constant: b' = -beta (b - b0) + noise.

    With beta 0 the constant is of no account, and a bias walks at random, as in the base.
    """
    n = base.n
    F, carried, corrected = zeros(n + 6), [], []
    for i, (bias, error, constant, d_constant, beta) in enumerate(BIASES):
        own, rates = place(base, error), diag(*beta.symbols)
        F[own, own], F[own, n + 3 * i : n + 3 * i + 3] = -rates, rates
        # as Phi carries the error: to the second power of beta dt
        by = DT.scalar * rates
        value = bias.vector - (by - by * by / 2) * (bias.vector - constant.vector)
        carried.append(Output(bias.name, value, bias.unit, f"{bias.meaning}, after the step", "body"))
        corrected.append(less_error(constant, d_constant))
    return base.extend(
        name=f"{base.name}-instability",
        c_prefix=f"{base.c_prefix}i",
        states=(D_GYRO_TURN_ON, D_ACCEL_TURN_ON),
        structs=(Struct("biases", "how the biases wander", (GYRO_TURN_ON, ACCEL_TURN_ON, GYRO_BETA, ACCEL_BETA)),),
        F=F,
        functions=(function(base, "strapdown", *carried), function(base, "feedback", *corrected)),
    )


# ---------------------------------------------------------------- scale factors and axes

LARGEST = 0.1
GYRO_AXES, ACCEL_AXES = ("xy", "xz", "yx", "yz", "zx", "zy"), ("yx", "zx", "zy")


def axes(name: str, letter: str, pairs: tuple[str, ...], meaning: str) -> Variable:
    return variable(name, " ".join(f"{letter}_{pair}" for pair in pairs), "rad", meaning, -LARGEST, LARGEST,
                    frame="body")  # fmt: skip


GYRO_SCALE = body("gyro_scale", "kg", "1", "estimated scale factor error of the gyros", -LARGEST, LARGEST)
ACCEL_SCALE = body("accel_scale", "ka", "1", "estimated scale factor error of the accelerometers", -LARGEST, LARGEST)
GYRO_MISALIGNED = axes("gyro_axes", "kg", GYRO_AXES, "estimated share of another axis' rate in a gyro, as xy: y in x")
ACCEL_MISALIGNED = axes("accel_axes", "ka", ACCEL_AXES, "estimated share of another axis' force in an accelerometer")
D_GYRO_SCALE = body("d_gyro_scale", "dkg", "1", "error of the gyros' scale factor, estimated - true", -LARGEST, LARGEST)
D_ACCEL_SCALE = body("d_accel_scale", "dka", "1", "error of the accelerometers' scale factor", -LARGEST, LARGEST)
D_GYRO_AXES = axes("d_gyro_axes", "dkg", GYRO_AXES, "error of the gyros' axes, estimated - true")
D_ACCEL_AXES = axes("d_accel_axes", "dka", ACCEL_AXES, "error of the accelerometers' axes, estimated - true")


def triad(scale: Variable, pairs: Variable) -> Matrix:
    """(3, 3) with the scale factors on the diagonal, and a pair such as yx in row y and column x."""
    out = diag(*scale.symbols)
    for symbol in pairs.symbols:
        row, column = ("xyz".index(axis) for axis in symbol.name[-2:])
        out[row, column] = symbol
    return out


def scaled(base: Model) -> Model:
    """Scale factors and axes of both triads: true = (I - K) (measured - bias).

    The accelerometers define the body's axes: the first is x, the second lies in the plane of x and y.  Theirs are
    three axes then, and the gyros' are six.  What turns both triads together is part of the mounting.

    The caller gives rates and forces with their biases removed, as before; every function takes K off.
    """
    n = base.n
    gyro, accel = triad(GYRO_SCALE, GYRO_MISALIGNED), triad(ACCEL_SCALE, ACCEL_MISALIGNED)
    d_gyro, d_accel = triad(D_GYRO_SCALE, D_GYRO_AXES), triad(D_ACCEL_SCALE, D_ACCEL_AXES)
    sensors = (
        (gyro, d_gyro, D_BG, OMEGA_IB_B, (BG, *INCREMENTS[::2])),
        (accel, d_accel, D_BA, F_B, (BA, *INCREMENTS[1::2])),
    )
    states = (D_GYRO_SCALE, D_ACCEL_SCALE, D_GYRO_AXES, D_ACCEL_AXES)
    new = Matrix([symbol for state in states for symbol in state.symbols])
    over: dict[Symbol, Expr] = {}
    as_bias: dict[Symbol, Expr] = {}
    by_new = zeros(6, n + len(new))  # what a bias error would be in the place of the new errors, before K
    K = diag(gyro, accel)
    for i, (estimate, error, d_bias, rate, inputs) in enumerate(sensors):
        for item in (rate, *inputs):
            over |= dict(zip(item.symbols, (eye(3) - estimate) * item.vector, strict=True))
        by_new[3 * i : 3 * i + 3, n:] = (error * rate.vector).jacobian(new)
        # once the errors are taken out, K is another too: in h a bias error stands for all of that
        stands = (eye(3) - estimate + error) * (rate.vector + d_bias.vector) - (eye(3) - estimate) * rate.vector
        as_bias |= dict(zip(d_bias.symbols, stands, strict=True))
    assert base.F is not None
    biases = slice(place(base, D_BG).start, place(base, D_BA).stop)
    by_bias = substituted(base.F[:6, biases], over)
    F, G = substituted(base.F, over), base.G.copy()
    F[:6, biases], G[:6, :6] = by_bias * (eye(6) - K), -by_bias * (eye(6) - K)

    def seen(m: Measurement) -> Measurement:
        exact = replaced(m, over, over | as_bias)
        if exact.H is None:
            return exact
        H = Matrix.hstack(exact.H, zeros(exact.H.rows, len(new)))
        by = exact.H[:, biases]
        H[:, biases] = by * (eye(6) - K)
        return replace(exact, H=H + by * by_new)

    grown = zeros(n + len(new))
    grown[:6, :] = by_bias * by_new
    estimates = (GYRO_SCALE, ACCEL_SCALE, GYRO_MISALIGNED, ACCEL_MISALIGNED)
    corrected = (less_error(*both) for both in zip(estimates, states, strict=True))
    plain = replace(
        base,
        structs=(*base.structs, Struct("triads", "scale factors and axes", estimates)),
        F=F,
        G=G,
        measurements=tuple(replaced(m, over, over) for m in base.measurements),
    )
    return plain.extend(
        name=f"{base.name}-scale",
        c_prefix=f"{base.c_prefix}k",
        states=states,
        F=grown,
        measurements=tuple(seen(m) for m in base.measurements),
        functions=(
            function(base, "strapdown", over=over),
            function(base, "expected", over=over),
            function(base, "feedback", *corrected),
        ),
    )


# ---------------------------------------------------------------- bending

BEND = body("flexure", "bend", "rad", "estimated bending of the slave's seat", -0.1, 0.1, MASTER_BODY)
BEND_RATE = body("flexure_rate", "bend_rate", "rad/s", "its estimated rate", -1.0, 1.0, MASTER_BODY)
D_BEND = body("d_flexure", "d_bend", "rad", "error of the bending, estimated - true", -0.1, 0.1, MASTER_BODY)
D_BEND_RATE = body("d_flexure_rate", "d_bend_rate", "rad/s", "error of its rate", -1.0, 1.0, MASTER_BODY)
BEND_OMEGA = body("flexure_omega", "bend_omega", "rad/s", "natural frequency of the bending", 0.01, 100.0, MASTER_BODY)
BEND_DAMPING = body("flexure_damping", "bend_damping", "1", "its damping, of the critical one", 0.0, 10.0, MASTER_BODY)
BEND_NOISE = noise_density("flexure_noise", "rad/s/sqrt(s)", "what drives the bending: 2 sigma sqrt(damping omega^3)",
                           1000.0, MASTER_BODY)  # fmt: skip


def bent(base: Model) -> Model:
    """Bending, a second-order Gauss-Markov process about each of the master's axes, of standard deviation sigma:

    bend'' = -2 damping omega bend' - omega^2 bend + noise.  `strapdown` carries the estimate over a step by the same
    second power of F dt as Phi carries its error.

    C_b2m = (I + [bend x]) C_mounting, to first order in the bending, which is some mrad, and scaled to a rotation.  It
    turns the slave where it stands: its gyros feel the bending's rate and the lever arm's velocity does not.  The base
    reads true rates: `scaled` comes after this.
    """
    n = base.n
    C_m2b = named("C_b2m", dcm_from_quaternion(va.Q_MOUNT.vector), "slave body to master body").T
    by_bend = named("q_bend", normalized(Matrix([1, *(BEND.vector / 2)])), "of the bending", "w x y z")
    q_bent = named(
        "q_bent", quaternion_product(by_bend, va.Q_MOUNT.vector), "slave body to master body, bent", "w x y z"
    )
    biases, mounting = place(base, D_BG), place(base, va.D_MOUNT)
    as_bent = dict(zip((*va.Q_MOUNT.symbols, *OMEGA_IB_B.symbols),
                       (*q_bent, *(OMEGA_IB_B.vector - C_m2b * BEND_RATE.vector)), strict=True))  # fmt: skip
    # What turns the slave one way turns the mounting the other: C_hat_b2m = (I - [(dmu - d_bend) x]) C_b2m.
    less = {dmu: dmu - bend for dmu, bend in zip(va.D_MOUNT.symbols, D_BEND.symbols, strict=True)}
    # The hull turns without the rate of the bending: an error of it is one of a gyro bias, in the master's axes, which
    # are known by the mounting.
    by_turn = -skew(BEND_RATE.vector)
    as_bias = C_m2b * (D_BEND_RATE.vector + by_turn * va.D_MOUNT.vector)
    less |= dict(zip(D_BG.symbols, D_BG.vector + as_bias, strict=True))

    def seen(m: Measurement) -> Measurement:
        exact = replaced(m, as_bent, as_bent | less)
        if m.H is None:
            return exact
        H = Matrix(exact.H)
        by_bias, by_mounting = H[:, biases], H[:, mounting]
        H[:, mounting] = by_mounting + by_bias * C_m2b * by_turn
        return replace(exact, H=Matrix.hstack(H, -by_mounting, by_bias * C_m2b))

    F, G = zeros(n + 6), zeros(n + 6, base.G.cols + 3)
    F[n : n + 3, n + 3 :] = eye(3)
    F[n + 3 :, n : n + 3] = -diag(*(omega**2 for omega in BEND_OMEGA.symbols))
    F[n + 3 :, n + 3 :] = -2 * diag(*BEND_DAMPING.symbols) * diag(*BEND_OMEGA.symbols)
    G[n + 3 :, base.G.cols :] = eye(3)

    A, dt = F[n:, n:], DT.scalar
    estimate = Matrix.vstack(BEND.vector, BEND_RATE.vector)
    carried = estimate + dt * A * (estimate + dt / 2 * A * estimate)
    return base.extend(
        name=f"{base.name}-flexure",
        c_prefix=f"{base.c_prefix}f",
        states=(D_BEND, D_BEND_RATE),
        structs=(Struct("bending", "how the hull bends", (BEND, BEND_RATE, BEND_OMEGA, BEND_DAMPING, BEND_NOISE)),),
        F=F,
        G=G,
        noise=BEND_NOISE.vector,
        measurements=tuple(seen(m) for m in base.measurements),
        functions=(
            function(base, "strapdown", *(
                Output(item.name, value, item.unit, f"{item.meaning}, after the step", MASTER_BODY)
                for item, value in ((BEND, carried[:3, 0]), (BEND_RATE, carried[3:, 0]))
            )),
            function(base, "expected", over=as_bent),
            function(base, "feedback", less_error(BEND, D_BEND), less_error(BEND_RATE, D_BEND_RATE)),
        ),
    )  # fmt: skip
