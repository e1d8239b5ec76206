"""Velocity-attitude matching whose lever arm is known only roughly: its error is three more states."""

from dataclasses import replace

from sympy import Matrix, eye

from boresight.derive.mechanics import mechanization
from boresight.derive.mechanics.rotation import dcm_from_quaternion
from boresight.derive.model import Model, Output
from boresight.derive.models import velocity_attitude as va
from boresight.derive.models.variables import D_LEVER, D_TAU, LEVER_B, OMEGA_IB_B
from boresight.derive.named import named
from boresight.derive.papers.kang_2025 import results as paper


def velocity_attitude_lever() -> Model:
    """velocity-attitude with the error of a constant lever arm, which velocity sees where the hull turns."""
    base = va.velocity_attitude()
    lag_true = va.LAG.scalar - D_TAU.scalar
    true = (*va.true_state()[:4], LEVER_B.vector - D_LEVER.vector)
    omega_in = mechanization.omega_in_n(va.FRAME, va.POSITION.vector, va.V_N.vector)
    C_b2n = named("C_b2n", dcm_from_quaternion(va.Q.vector), "body to level")
    # (1) is linear in the lever arm
    by_lever = Matrix.hstack(
        *(paper.lever_velocity(C_b2n, omega_in, OMEGA_IB_B.vector, eye(3).col(i)) for i in range(3))
    )
    velocity = next(m for m in base.measurements if m.name == "velocity")
    feedback = next(f for f in base.functions if f.name == "feedback")
    assert velocity.z is not None and velocity.H is not None
    corrected = Output("lever_b", LEVER_B.vector - D_LEVER.vector, "m", "lever arm, from master to slave", "body")
    return base.extend(
        name="velocity-attitude-lever",
        c_prefix="val",
        title="velocity and attitude matching with the error of the lever arm, 19 states",
        states=(D_LEVER,),
        measurements=(
            replace(velocity, h=velocity.z - va.velocity_residual(true, lag_true),
                    H=Matrix.hstack(velocity.H, -by_lever)),
        ),
        functions=(replace(feedback, outputs=(*feedback.outputs, corrected)),),
    )  # fmt: skip
