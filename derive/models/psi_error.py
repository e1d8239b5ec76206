"""Errors of strapdown navigation against the computed level: the psi model, nine states."""

from boresight.derive.mechanics import error_models
from boresight.derive.mechanics.earth import ENU, NED, Frame
from boresight.derive.model import Model
from boresight.derive.models import variables as var
from boresight.derive.models.phi_error import error_model


def psi_error(frame: Frame = ENU) -> Model:
    """States: errors of the coordinates, of the velocity against the true one carried into the computed level, psi."""
    return error_model(
        "psi",
        frame,
        (
            var.position_error(frame),
            var.level(frame, "dv_c", "dvc", "m/s", "error of the velocity, v_hat - C_n2c v", 100.0),
            var.psi_angle(frame),
        ),
        error_models.psi_matrix,
        ("phi_from_psi", "states of the phi model from those of this one, x_phi = T x", error_models.phi_from_psi),
        (
            "C_n2c = I - [dtheta x]: the computed level c is the true one of the computed position.",
            "psi = phi - dtheta, where C_hat_b2n = (I - [phi x]) C_b2n.",
        ),
        computed_level=True,
    )


def psi_error_ned() -> Model:
    """The same in NED, as `boresight generate derive/models/psi_error.py:psi_error_ned`."""
    return psi_error(NED)
