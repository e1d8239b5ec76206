"""Two compositions of velocity-attitude: a hull that bends, and sensors with scale factors.

    boresight generate examples/velocity_attitude_options.py:flexure          # writes ./generated/flexure
    boresight generate examples/velocity_attitude_options.py:scale_factors

Each adds states, what carries and corrects their estimates, and the terms by which the measurements see them.
"""

from dataclasses import replace

from sympy import Matrix, diag, eye, zeros

from boresight.derive.mechanics.rotation import dcm_from_quaternion, normalized, quaternion_product
from boresight.derive.model import Function, Measurement, Model, Output, Struct, substituted
from boresight.derive.models import velocity_attitude as va
from boresight.derive.models.variables import (
    BA,
    BG,
    D_BG,
    DT,
    F_B,
    INCREMENTS,
    MASTER_BODY,
    OMEGA_IB_B,
    body,
    noise_density,
)


def function(model: Model, name: str) -> Function:
    return next(f for f in model.functions if f.name == name)


def replaced(m: Measurement, inputs: dict, errors: dict) -> Measurement:
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


# ---------------------------------------------------------------- flexure

BEND = body("flexure", "bend", "rad", "estimated bending of the slave's seat", -0.1, 0.1, MASTER_BODY)
BEND_RATE = body("flexure_rate", "bend_rate", "rad/s", "its estimated rate", -1.0, 1.0, MASTER_BODY)
D_BEND = body("d_flexure", "d_bend", "rad", "error of the bending, estimated - true", -0.1, 0.1, MASTER_BODY)
D_BEND_RATE = body("d_flexure_rate", "d_bend_rate", "rad/s", "error of its rate", -1.0, 1.0, MASTER_BODY)
BETA = body("flexure_beta", "beta", "1/s", "one over the correlation time of the bending", 0.01, 100.0, MASTER_BODY)
BEND_NOISE = noise_density("flexure_noise", "rad/s/sqrt(s)", "what drives the bending: 2 sigma beta^1.5", 100.0,
                           MASTER_BODY)  # fmt: skip


def flexure() -> Model:
    """velocity-attitude with bending as a second-order Markov process about each of the master's axes.

    bend'' = -2 beta bend' - beta^2 bend + noise: the correlation is (1 + beta t) exp(-beta t).  `strapdown` carries the
    estimate over a step by the same second power of F dt as Phi carries its error.

    C_b2m = (I + [bend x]) C_mounting, to first order in the bending, which is some mrad, and scaled to a rotation.  It
    turns the slave where it stands: its gyros feel the bending's rate and the lever arm's velocity does not.
    """
    base = va.velocity_attitude()
    C_m2b = dcm_from_quaternion(va.Q_MOUNT.vector).T
    q_bent = quaternion_product(normalized(Matrix([1, *(BEND.vector / 2)])), va.Q_MOUNT.vector)
    omega_hull = OMEGA_IB_B.vector - C_m2b * BEND_RATE.vector
    as_bent = dict(zip((*va.Q_MOUNT.symbols, *OMEGA_IB_B.symbols), (*q_bent, *omega_hull), strict=True))
    # What turns the slave one way turns the mounting the other: C_hat_b2m = (I - [(dmu - d_bend) x]) C_b2m.
    less = {dmu: dmu - bend for dmu, bend in zip(va.D_MOUNT.symbols, D_BEND.symbols, strict=True)}
    # The hull turns without the rate of the bending: an error of it is one of a gyro bias, in the master's axes.
    less |= dict(zip(D_BG.symbols, D_BG.vector + C_m2b * D_BEND_RATE.vector, strict=True))

    def seen(m: Measurement) -> Measurement:
        exact = replaced(m, as_bent, as_bent | less)
        if m.H is None:
            return exact
        by_rate = m.H[:, 6:9] * C_m2b
        return replace(exact, H=Matrix.hstack(exact.H, -exact.H[:, 12:15], by_rate))

    F, G = zeros(22), zeros(22, 19)
    F[16:19, 19:22] = eye(3)
    F[19:22, 16:19], F[19:22, 19:22] = -diag(*(b**2 for b in BETA.symbols)), -2 * diag(*BETA.symbols)
    G[19:22, 16:19] = eye(3)

    A, dt = F[16:, 16:], DT.scalar
    estimate = Matrix.vstack(BEND.vector, BEND_RATE.vector)
    carried = estimate + dt * A * (estimate + dt / 2 * A * estimate)
    strapdown, expected, feedback = (function(base, name) for name in ("strapdown", "expected", "feedback"))

    def bending(angle: Matrix, rate: Matrix) -> tuple[Output, Output]:
        return (Output(BEND.name, angle, BEND.unit, "bending of the slave's seat", MASTER_BODY),
                Output(BEND_RATE.name, rate, BEND_RATE.unit, "its rate", MASTER_BODY))  # fmt: skip

    return base.extend(
        name="velocity-attitude-flexure",
        c_prefix="vaf",
        title="velocity and attitude matching on a hull that bends, 22 states",
        states=(D_BEND, D_BEND_RATE),
        structs=(Struct("bending", "how the hull bends", (BEND, BEND_RATE, BETA, BEND_NOISE)),),
        F=F,
        G=G,
        noise=BEND_NOISE.vector,
        measurements=tuple(seen(m) for m in base.measurements),
        functions=(
            replace(strapdown, outputs=(*strapdown.outputs, *bending(carried[:3, 0], carried[3:, 0]))),
            replace(expected, outputs=tuple(replace(o, value=substituted(o.value, as_bent)) for o in expected.outputs)),
            replace(feedback, outputs=(*feedback.outputs, *bending(BEND.vector - D_BEND.vector,
                                                                   BEND_RATE.vector - D_BEND_RATE.vector))),
        ),
    )  # fmt: skip


# ---------------------------------------------------------------- scale factors

SCALE = 0.1
GYRO_SCALE = body("gyro_scale", "gs", "1", "estimated scale factor error of the gyros", -SCALE, SCALE)
ACCEL_SCALE = body("accel_scale", "as", "1", "estimated scale factor error of the accelerometers", -SCALE, SCALE)
D_GYRO_SCALE = body("d_gyro_scale", "dgs", "1", "error of the gyros' scale factor, estimated - true", -SCALE, SCALE)
D_ACCEL_SCALE = body("d_accel_scale", "das", "1", "error of the accelerometers' scale factor", -SCALE, SCALE)


def scale_factors() -> Model:
    """velocity-attitude with scale factors: measured = (1 + scale) true + bias.

    What the caller gives has its biases removed, as before; every function divides it by the scale estimated, and so
    are the errors of the biases.
    """
    rates, forces = OMEGA_IB_B.symbols, F_B.symbols
    over = {
        symbol: symbol / (1 + s)
        for scale, inputs in ((GYRO_SCALE, (OMEGA_IB_B, BG, INCREMENTS[0], INCREMENTS[2])),
                              (ACCEL_SCALE, (F_B, BA, INCREMENTS[1], INCREMENTS[3])))
        for item in inputs
        for symbol, s in zip(item.symbols, scale.symbols, strict=True)
    }  # fmt: skip
    plain = va.velocity_attitude()
    assert plain.F is not None
    per_scale = diag(*(1 / (1 + s) for scale in (GYRO_SCALE, ACCEL_SCALE) for s in scale.symbols))
    true = per_scale * Matrix([*rates, *forces])
    by_sensor = plain.F[:6, 6:12] * per_scale
    F, G = substituted(plain.F, over), plain.G.copy()
    F[:6, 6:12], G[:6, :6] = by_sensor, -by_sensor
    # once the errors are taken out, the sensors' scale is another too: in h a bias error stands for all of that
    as_bias = {
        error: (rate + error) / (1 + s - d_s) - rate / (1 + s)
        for error, rate, s, d_s in zip(D_BG.symbols, rates, GYRO_SCALE.symbols, D_GYRO_SCALE.symbols, strict=True)
    }

    def seen(m: Measurement) -> Measurement:
        exact = replaced(m, over, over | as_bias)
        if m.name != "velocity":
            return exact
        by_bias = exact.H[:, 6:9] * per_scale[:3, :3]
        return replace(
            exact, H=Matrix.hstack(exact.H[:, :6], by_bias, exact.H[:, 9:], by_bias * diag(*true[:3, 0]), zeros(3))
        )

    base = replace(
        plain,
        structs=(*plain.structs, Struct("scale", "scale factors", (GYRO_SCALE, ACCEL_SCALE))),
        F=F,
        G=G,
        measurements=tuple(replaced(m, over, over) for m in plain.measurements),
    )
    grown = zeros(22)
    grown[:6, 16:] = by_sensor * diag(*true)  # a bias in proportion to what is measured

    strapdown, expected, feedback = (function(base, name) for name in ("strapdown", "expected", "feedback"))
    scaled = [
        replace(f, outputs=tuple(replace(output, value=substituted(output.value, over)) for output in f.outputs))
        for f in (strapdown, expected)
    ]
    corrected = tuple(
        Output(estimate.name, estimate.vector - error.vector, "1", "scale factor", "body")
        for estimate, error in ((GYRO_SCALE, D_GYRO_SCALE), (ACCEL_SCALE, D_ACCEL_SCALE))
    )
    return base.extend(
        name="velocity-attitude-scale",
        c_prefix="vas",
        title="velocity and attitude matching with scale factors, 22 states",
        states=(D_GYRO_SCALE, D_ACCEL_SCALE),
        F=grown,
        measurements=tuple(seen(m) for m in plain.measurements if m.name in ("velocity", "quaternion")),
        functions=(*scaled, replace(feedback, outputs=(*feedback.outputs, *corrected))),
    )
