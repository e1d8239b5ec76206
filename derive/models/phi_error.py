"""Errors of strapdown navigation against the true level: the phi model, nine states."""

from collections.abc import Callable
from dataclasses import replace

from sympy import Matrix

from boresight.derive.mechanics import error_models
from boresight.derive.mechanics.earth import ENU, NED, Frame
from boresight.derive.mechanics.rotation import (
    dcm_from_quaternion,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
)
from boresight.derive.model import Function, Model, Output, Struct, Variable
from boresight.derive.models import variables as var
from boresight.derive.named import named


def error_model(
    name: str,
    frame: Frame,
    states: tuple[Variable, ...],
    matrix: Callable[..., Matrix],
    carried: tuple[str, str, Callable[..., Matrix]],
    lines: tuple[str, ...],
    *,
    computed_level: bool = False,
) -> Model:
    """The model x' = F x + G w.  matrix: gives F.  carried: name, meaning and matrix of the map to the other model.

    computed_level: the errors of velocity and attitude stand against the level of the computed position.
    """
    position, v_n, q = var.position(frame), var.velocity(frame), var.attitude(frame)
    f_n = var.level(frame, "f_n", "f", "m/s^2", "specific force", 500.0)
    suffix = "" if frame is ENU else frame.name.lower()
    function, meaning, T = carried
    C_b2n = named("C_b2n", dcm_from_quaternion(q.vector), "body to level")
    d_position, dv, angle = (block.vector for block in states)
    q_true = normalized(quaternion_product(quaternion_from_rotation_vector(angle), q.vector))
    mechanics = replace(
        var.mechanics(frame, C_b2n.T * f_n.vector, computed_level=computed_level),
        strapdown=var.strapdown(frame),
        feedback=Function("feedback", "navigation with the errors taken out",
                          var.nav_outputs(frame, position.vector - d_position, v_n.vector - dv, q_true)),
    )  # fmt: skip
    return Model(
        name="-".join(filter(None, (name, "error", suffix))),
        c_prefix=name + suffix,
        title=f"errors of strapdown navigation, {name} model in {frame.name}, 9 states",
        frame=f"{frame.name} with body axes {frame.body}",
        states=states,
        structs=(
            Struct("nav", "position, velocity and attitude", (position, v_n, q)),
            Struct("step", "one interval", (f_n, var.DT)),
            Struct("noise", "process noise", (var.GYRO_NOISE, var.ACCEL_NOISE)),
        ),
        F=matrix(frame, position.vector, v_n.vector, f_n.vector),
        G=error_models.noise_matrix(C_b2n),
        noise=Matrix.vstack(var.GYRO_NOISE.vector, var.ACCEL_NOISE.vector),
        dt=var.DT.scalar,
        functions=(
            Function(function, meaning, (
                Output("T", T(frame, position.vector, v_n.vector), "mixed", "the map; a covariance goes by T P T'"),
            ), (f"mechanics ({'map-2' if frame is NED else 'map-3'})",)),
        ),
        equations=(f"mechanics ({name}-{3 if frame is NED else 4})", "mechanics (phi-5)"),
        card=(
            "Error = computed - true, to first order in the errors; no other term is dropped.",
            *lines,
            *var.card(frame),
        ),
        mechanics=mechanics,
    )  # fmt: skip


def phi_error(frame: Frame = ENU) -> Model:
    """States: errors of the coordinates, of the velocity component by component, and phi."""
    return error_model(
        "phi",
        frame,
        (var.position_error(frame), var.velocity_error(frame), var.phi_angle(frame)),
        error_models.phi_matrix,
        ("psi_from_phi", "states of the psi model from those of this one, x_psi = T x", error_models.psi_from_phi),
        ("C_hat_b2n = (I - [phi x]) C_b2n, against the true level.",),
    )


def phi_error_ned() -> Model:
    """The same in NED, as `boresight generate derive/models/phi_error.py:phi_error_ned`."""
    return phi_error(NED)
