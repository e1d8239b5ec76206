"""Strapdown navigation: position, velocity and attitude from inertial increments, without a filter."""

from dataclasses import replace

from boresight.derive.mechanics import earth, mechanization
from boresight.derive.mechanics.earth import ENU, NED, Frame
from boresight.derive.mechanics.rotation import dcm_from_quaternion
from boresight.derive.model import Function, Model, Output, Struct
from boresight.derive.models import variables as var
from boresight.derive.named import named

F_B = replace(var.F_B, meaning="specific force")
OMEGA_IB_B = replace(var.OMEGA_IB_B, meaning="angular rate against inertial space")


def strapdown(frame: Frame = ENU) -> Model:
    """One step of the integrator, the rates it follows, and the Earth under it."""
    position, v_n, q = var.position(frame), var.velocity(frame), var.attitude(frame)
    nav = (position.vector, v_n.vector, q.vector)
    lat, height = frame.latitude_and_height(position.vector)
    C_b2n = named("C_b2n", dcm_from_quaternion(q.vector), "body to level")
    f_n = frame.named("f_n", C_b2n * F_B.vector, "specific force in the level, m/s^2")
    order = ", ".join(frame.coordinates)
    dtheta, dv, *sensed = (part.vector for part in (*var.INCREMENTS, *var.EARLIER))
    dtheta, dv = mechanization.compensated(dtheta, dv, list(zip(sensed[::2], sensed[1::2], strict=True)))
    return Model(
        name="strapdown" if frame is ENU else f"strapdown-{frame.name.lower()}",
        c_prefix="sd" if frame is ENU else f"sd{frame.name.lower()}",
        title=f"strapdown navigation in {frame.name}",
        frame=f"{frame.name} with body axes {frame.body}",
        states=(),
        structs=(
            Struct("nav", "position, velocity and attitude", (position, v_n, q)),
            Struct("imu", "inertial increments of one step, and of the step before", (*var.INCREMENTS, var.DT)),
            Struct("earlier", "inertial increments of the steps before these", var.EARLIER),
            Struct("motion", "instantaneous inertial data", (F_B, OMEGA_IB_B)),
        ),
        functions=(
            replace(var.strapdown(frame), name="step"),
            Function("compensated", "increments with which the step of any model follows coning and sculling by four "
                     "samples instead of two; biases removed, the increments before stay as delivered", (
                Output("dtheta_ib_b", dtheta, "rad", "in place of that of the step", "body"),
                Output("dv_b", dv, "m/s", "in place of that of the step", "body"),
            )),
            Function("rates", "the exact time derivatives that a step integrates", (
                Output("position_rate", mechanization.position_rate(frame, *nav[:2]), "rad/s, rad/s, m/s",
                       order, "WGS-84"),
                Output("v_n_rate", mechanization.velocity_rate(frame, *nav[:2], f_n), "m/s^2", "acceleration",
                       frame.name),
                Output("q_b2n_rate", mechanization.quaternion_rate(frame, *nav, OMEGA_IB_B.vector), "1/s",
                       "rate of the quaternion", f"body to {frame.name}"),
            ), ("mechanics (strapdown-1)",)),
            Function("earth", "what the Earth does to a navigator at this place and velocity", (
                Output("omega_ie_n", earth.omega_ie_n(lat, frame), "rad/s", "the Earth's rate", frame.name),
                Output("omega_en_n", earth.omega_en_n(lat, height, v_n.vector, frame), "rad/s", "transport rate",
                       frame.name),
                Output("gravity_n", earth.gravity_n(lat, height, frame), "m/s^2", "gravity", frame.name),
            ), ("mechanics (strapdown-1)",)),
        ),
        card=var.card(frame),
        unheld=(
            ("compensated", "four samples instead of two; a test holds them against coning motion"),
        ),
    )  # fmt: skip


def strapdown_ned() -> Model:
    """The same in NED, as `boresight generate derive/models/strapdown.py:strapdown_ned`."""
    return strapdown(NED)
