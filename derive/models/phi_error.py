"""Errors of strapdown navigation against the true level: the phi model, nine states."""

from collections.abc import Callable
from math import radians

from sympy import Matrix

from boresight.derive import error_models
from boresight.derive.earth import ENU, NED, Frame
from boresight.derive.model import Function, Model, Output, Struct, Variable, variable
from boresight.derive.models.strapdown import attitude_variable, card, position_variable, velocity_variable
from boresight.derive.rotation import dcm_from_quaternion

HALF_DEGREE, KILOMETRE = radians(0.5), 1e3


def error_states(frame: Frame, velocity: Variable, attitude: Variable) -> tuple[Variable, ...]:
    """Errors of the coordinates, then velocity and attitude as given."""
    limits = [KILOMETRE if name == "height" else HALF_DEGREE for name in frame.coordinates]
    names = " ".join(f"d_{name}" for name in frame.coordinates)
    unit = position_variable(frame).unit
    low = [-limit for limit in limits]
    position = variable("d_position", names, unit, "error of the position", low, limits, frame="WGS-84")
    return position, velocity, attitude


def error_model(
    name: str,
    frame: Frame,
    states: tuple[Variable, ...],
    matrix: Callable[..., Matrix],
    carried: tuple[str, str, Callable[..., Matrix]],
    lines: tuple[str, ...],
) -> Model:
    """The model x' = F x + G w.  matrix: gives F.  carried: name, meaning and matrix of the map to the other model."""
    position, v_n, q = position_variable(frame), velocity_variable(frame), attitude_variable(frame)
    f_n = variable("f_n", " ".join(f"f_{axis}" for axis in frame.axes), "m/s^2", "specific force", -500.0, 500.0,
                   frame=frame.name)  # fmt: skip
    dt = variable("dt", "dt", "s", "length of the step", 1e-6, 10.0)

    def noise(sensor: str, unit: str, plural: str, limit: float) -> Variable:
        names = " ".join(f"{sensor}_noise_{axis}" for axis in "xyz")
        return variable(f"{sensor}_noise", names, unit, f"root power spectral density of the {plural}", 0.0, limit,
                        frame="body")  # fmt: skip

    gyro_noise = noise("gyro", "rad/sqrt(s)", "gyros", 0.1)
    accel_noise = noise("accel", "m/s/sqrt(s)", "accelerometers", 10.0)
    suffix = "" if frame is ENU else frame.name.lower()
    function, meaning, T = carried
    return Model(
        name="-".join(filter(None, (name, "error", suffix))),
        c_prefix=name + suffix,
        title=f"errors of strapdown navigation, {name} model in {frame.name}, 9 states",
        frame=f"{frame.name} with body axes {frame.body}",
        states=states,
        structs=(
            Struct("nav", "position, velocity and attitude", (position, v_n, q)),
            Struct("step", "one interval", (f_n, dt)),
            Struct("noise", "process noise", (gyro_noise, accel_noise)),
        ),
        F=matrix(frame, position.vector, v_n.vector, f_n.vector),
        G=error_models.noise_matrix(dcm_from_quaternion(q.vector)),
        noise=Matrix.vstack(gyro_noise.vector, accel_noise.vector),
        dt=dt.scalar,
        functions=(
            Function(function, meaning, (
                Output("T", T(frame, position.vector, v_n.vector), "mixed", "the map; a covariance goes by T P T'"),
            )),
        ),
        card=("Error = computed - true, to first order in the errors; no other term is dropped.", *lines, *card(frame)),
    )  # fmt: skip


def per_axis(frame: Frame, name: str, letter: str, unit: str, meaning: str, limit: float) -> Variable:
    names = " ".join(f"{letter}_{axis}" for axis in frame.axes)
    return variable(name, names, unit, meaning, -limit, limit, frame=frame.name)


def phi_error(frame: Frame = ENU) -> Model:
    """States: errors of the coordinates, of the velocity component by component, and phi."""
    return error_model(
        "phi",
        frame,
        error_states(
            frame,
            per_axis(frame, "dv_n", "dv", "m/s", "error of the velocity, v_hat - v", 100.0),
            per_axis(frame, "phi", "phi", "rad", "attitude error, C_hat = (I - [phi x]) C", 0.5),
        ),
        error_models.phi_matrix,
        ("psi_from_phi", "states of the psi model from those of this one, x_psi = T x", error_models.psi_from_phi),
        ("C_hat_b2n = (I - [phi x]) C_b2n, against the true level.",),
    )


def phi_error_ned() -> Model:
    """The same in NED, as `boresight generate derive/models/phi_error.py:phi_error_ned`."""
    return phi_error(NED)
