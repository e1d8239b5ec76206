"""Azimuth hold whose reference may be wrong: its azimuth error is a sixteenth state."""

from dataclasses import replace

from sympy import Matrix

from boresight.derive.model import Function, Model, Output, Struct, variable
from boresight.derive.models.azimuth_hold import azimuth_hold


def azimuth_hold_reference() -> Model:
    """azimuth-hold with the constant azimuth error of the reference attitude, which the paper takes for white noise."""
    base = azimuth_hold()
    reference = next(struct for struct in base.structs if struct.name == "reference")
    azimuth = next(m for m in base.measurements if m.name == "azimuth")
    feedback = next(f for f in base.functions if f.name == "feedback")
    error = variable(
        "reference_error", "ref", "rad", "estimated azimuth error of the reference", -0.5, 0.5, frame="ENU"
    )
    d_error = variable("d_reference_error", "d_ref", "rad", "error of that estimate, estimated - true", -0.5, 0.5,
                       frame="ENU")  # fmt: skip
    corrected = Output("reference_error", error.vector - d_error.vector, "rad", "azimuth error of the reference", "ENU")
    assert azimuth.z is not None and azimuth.h is not None and azimuth.H is not None
    return base.extend(
        name="azimuth-hold-reference",
        c_prefix="ahr",
        title="azimuth hold with the error of its reference, 16 states",
        states=(d_error,),
        structs=(Struct("reference", reference.meaning, (*reference.fields, error)),),
        # The residual is phi_u less the reference's error; with the estimate added back, phi_u plus its error.
        measurements=(
            replace(azimuth, z=azimuth.z + error.vector, h=azimuth.h + d_error.vector,
                    H=Matrix.hstack(azimuth.H, Matrix([[1]]))),
        ),
        functions=(Function(feedback.name, feedback.meaning, (*feedback.outputs, corrected), feedback.equations),),
    )  # fmt: skip
