"""Strapdown navigation: position, velocity and attitude from inertial increments, without a filter."""

from math import pi, radians

from boresight.derive import earth, mechanization
from boresight.derive.earth import ENU, NED, Frame
from boresight.derive.model import Function, Model, Output, Struct, Variable, variable
from boresight.derive.rotation import dcm_from_quaternion

# Rates and radii have their singularity at the poles; a longitude runs on past +-180 deg rather than jump.
COORDINATES = {
    "lat": ("rad", "geodetic latitude", -radians(85), radians(85)),
    "lon": ("rad", "longitude, not wrapped", -2 * pi, 2 * pi),
    "height": ("m", "height above the ellipsoid", -500.0, 30000.0),
}


def position_variable(frame: Frame) -> Variable:
    """The geodetic coordinates in the frame's order, as one input `position`."""
    units, meanings, low, high = zip(*(COORDINATES[name] for name in frame.coordinates), strict=True)
    return variable("position", " ".join(frame.coordinates), ", ".join(units), ", ".join(meanings), low, high,
                    frame="WGS-84")  # fmt: skip


def velocity_variable(frame: Frame) -> Variable:
    names = " ".join(f"v_{axis}" for axis in frame.axes)
    return variable("v_n", names, "m/s", "velocity over the ground", -1000.0, 1000.0, frame=frame.name)


def attitude_variable(frame: Frame) -> Variable:
    return variable("q_b2n_wxyz", "q_w q_x q_y q_z", "1", "attitude", -1.001, 1.001, frame=f"body to {frame.name}",
                    norm=(0.999, 1.001))  # fmt: skip


def card(frame: Frame) -> tuple[str, ...]:
    return (
        f"Position is {', '.join(frame.coordinates)} (rad, m) on WGS-84; the body axes are {frame.body}.",
        "Quaternions are Hamilton, scalar first, body to navigation.",
    )


def strapdown(frame: Frame = ENU) -> Model:
    """One step of the integrator, the rates it follows, and the Earth under it."""
    position, v_n, q = position_variable(frame), velocity_variable(frame), attitude_variable(frame)

    def body(name: str, letter: str, unit: str, meaning: str, limit: float) -> Variable:
        names = " ".join(f"{letter}_{axis}" for axis in "xyz")
        return variable(name, names, unit, meaning, -limit, limit, frame="body")

    dtheta = body("dtheta_ib_b", "dtheta", "rad", "integral of the angular rate over the step", 0.5)
    dv = body("dv_b", "dv", "m/s", "integral of the specific force over the step", 100.0)
    dtheta_before = body("dtheta_before", "dtheta_before", "rad", "the same over the step before", 0.5)
    dv_before = body("dv_before", "dv_before", "m/s", "the same over the step before", 100.0)
    dt = variable("dt", "dt", "s", "length of the step", 1e-6, 1.0)
    f_b = body("f_b", "f", "m/s^2", "specific force", 500.0)
    omega_ib_b = body("omega_ib_b", "omega_ib", "rad/s", "angular rate against inertial space", 20.0)

    nav = (position.vector, v_n.vector, q.vector)
    p_next, v_next, q_next = mechanization.step(
        frame, *nav, dtheta.vector, dv.vector, dtheta_before.vector, dv_before.vector, dt.scalar
    )
    lat, height = frame.latitude_and_height(position.vector)
    f_n = dcm_from_quaternion(q.vector) * f_b.vector
    order = ", ".join(frame.coordinates)
    return Model(
        name="strapdown" if frame is ENU else f"strapdown-{frame.name.lower()}",
        c_prefix="sd" if frame is ENU else f"sd{frame.name.lower()}",
        title=f"strapdown navigation in {frame.name}",
        frame=f"{frame.name} with body axes {frame.body}",
        states=(),
        structs=(
            Struct("nav", "position, velocity and attitude", (position, v_n, q)),
            Struct("imu", "inertial increments of one step, and of the step before", (dtheta, dv, dtheta_before,
                                                                                     dv_before, dt)),
            Struct("motion", "instantaneous inertial data", (f_b, omega_ib_b)),
        ),
        functions=(
            Function("step", "position, velocity and attitude after one step; coning and sculling from two steps", (
                Output("position", p_next, position.unit, order, "WGS-84"),
                Output("v_n", v_next, "m/s", "velocity over the ground", frame.name),
                Output("q_b2n_wxyz", q_next, "1", "attitude, of unit norm", f"body to {frame.name}"),
            )),
            Function("rates", "the exact time derivatives that a step integrates", (
                Output("position_rate", mechanization.position_rate(frame, *nav[:2]), "rad/s, m/s", order, "WGS-84"),
                Output("v_n_rate", mechanization.velocity_rate(frame, *nav[:2], f_n), "m/s^2", "acceleration",
                       frame.name),
                Output("q_b2n_rate", mechanization.quaternion_rate(frame, *nav, omega_ib_b.vector), "1/s",
                       "rate of the quaternion", f"body to {frame.name}"),
            )),
            Function("earth", "what the Earth does to a navigator at this place and velocity", (
                Output("omega_ie_n", earth.omega_ie_n(lat, frame), "rad/s", "the Earth's rate", frame.name),
                Output("omega_en_n", earth.omega_en_n(lat, height, v_n.vector, frame), "rad/s", "transport rate",
                       frame.name),
                Output("gravity_n", earth.gravity_n(lat, height, frame), "m/s^2", "gravity", frame.name),
            )),
        ),
        card=card(frame),
    )  # fmt: skip


def strapdown_ned() -> Model:
    """The same in NED, as `boresight generate derive/models/strapdown.py:strapdown_ned`."""
    return strapdown(NED)
