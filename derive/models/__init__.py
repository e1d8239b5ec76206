"""The built-in models, one module each, by name; each is imported when it is asked for."""

from importlib import import_module
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
    """The model of one of MODELS, made anew, or, as phi-error.phi_error_ned, that of another function beside it."""
    model, _, function = name.partition(".")
    if model not in MODELS:
        raise ValueError(f"no model {model!r}")
    stem = model.replace("-", "_")
    made: Model = getattr(import_module(f"{__name__}.{stem}"), function or stem)()
    return made
