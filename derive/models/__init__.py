"""The built-in models, one module each, by name; each is imported when it is asked for."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from boresight.derive.model import Model

MODELS = (
    "azimuth-hold",
    "azimuth-hold-reference",
    "euler-matching",
    "phi-error",
    "psi-error",
    "strapdown",
    "velocity-attitude",
    "velocity-attitude-lever",
    "velocity-attitude-sensors",
    "velocity-dcm",
)


def built_in(name: str) -> "Model":
    """The model of one of MODELS, made anew."""
    match name:
        case "azimuth-hold":
            from boresight.derive.models.azimuth_hold import azimuth_hold as make
        case "azimuth-hold-reference":
            from boresight.derive.models.azimuth_hold_reference import azimuth_hold_reference as make
        case "euler-matching":
            from boresight.derive.models.euler_matching import euler_matching as make
        case "phi-error":
            from boresight.derive.models.phi_error import phi_error as make
        case "psi-error":
            from boresight.derive.models.psi_error import psi_error as make
        case "strapdown":
            from boresight.derive.models.strapdown import strapdown as make
        case "velocity-attitude":
            from boresight.derive.models.velocity_attitude import velocity_attitude as make
        case "velocity-attitude-lever":
            from boresight.derive.models.velocity_attitude_lever import velocity_attitude_lever as make
        case "velocity-attitude-sensors":
            from boresight.derive.models.velocity_attitude_sensors import velocity_attitude_sensors as make
        case "velocity-dcm":
            from boresight.derive.models.velocity_dcm import velocity_dcm as make
        case _:
            raise ValueError(f"no model {name!r}")
    return make()
