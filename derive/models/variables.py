"""What the models read, carry and estimate, each defined once: name, unit, meaning, frame and valid box.

Frame: the local level, NED or ENU.  Suffixes: b the body (the slave's), m the master's body, n the level.  An error is
computed - true.  A bias is measured - true.
"""

from math import pi, radians

from sympy import Matrix, zeros

from boresight.derive.mechanics import mechanization
from boresight.derive.mechanics.earth import Frame
from boresight.derive.mechanics.rotation import rotation_y, rotation_z
from boresight.derive.model import Function, Level, Mechanics, Output, Variable, variable

MASTER_BODY = "master body"


# ---------------------------------------------------------------- kinds of variables


def body(name: str, letter: str, unit: str, meaning: str, low: float, high: float, frame: str = "body") -> Variable:
    """A vector in body axes."""
    return variable(name, " ".join(f"{letter}_{axis}" for axis in "xyz"), unit, meaning, low, high, frame=frame)


def level(frame: Frame, name: str, letter: str, unit: str, meaning: str, limit: float) -> Variable:
    """A vector in the local level."""
    names = " ".join(f"{letter}_{axis}" for axis in frame.axes)
    return variable(name, names, unit, meaning, -limit, limit, frame=frame.name)


def quaternion(name: str, letter: str, meaning: str, frame: str) -> Variable:
    """An attitude: scalar first; frame: what it maps between, as `body to NED`."""
    return variable(name, " ".join(f"{letter}_{part}" for part in "wxyz"), "1", meaning, -1.001, 1.001, frame=frame,
                    norm=(0.999, 1.001))  # fmt: skip


def noise_density(name: str, unit: str, meaning: str, high: float, frame: str = "body") -> Variable:
    return body(name, name, unit, f"noise density of {meaning}", 0.0, high, frame)


# ---------------------------------------------------------------- navigation

# Rates and radii have their singularity at the poles; a longitude runs on past +-180 deg rather than jump.
COORDINATES = {
    "lat": ("rad", "geodetic latitude", -radians(85), radians(85)),
    "lon": ("rad", "longitude, not wrapped", -2 * pi, 2 * pi),
    "height": ("m", "height above the ellipsoid", -500.0, 30000.0),
}
POSITION_ERROR = {"rad": radians(0.5), "m": 1e3}
PITCH = radians(80)  # Euler angles have a singularity at 90 deg, and their errors grow as 1 / cos(pitch)
ANGLES_LOW, ANGLES_HIGH = (-pi, -PITCH, -pi), (pi, PITCH, pi)
GYRO_BIAS, ACCEL_BIAS = radians(1.0), 1.0  # rad/s (3600 deg/h) and m/s^2 (0.1 g)


def position(frame: Frame) -> Variable:
    """The geodetic coordinates, named for the frame's order."""
    units, meanings, low, high = zip(*(COORDINATES[name] for name in frame.coordinates), strict=True)
    name, components = (between.join(frame.coordinates) for between in ("_", " "))
    return variable(name, components, ", ".join(units), ", ".join(meanings), low, high, frame="WGS-84")


def velocity(frame: Frame) -> Variable:
    return level(frame, "v_n", "v", "m/s", "velocity over the ground", 1000.0)


def attitude(frame: Frame) -> Variable:
    return quaternion("q_b2n_wxyz", "q", "attitude", f"body to {frame.name}")


BG = body("gyro_bias", "bg", "rad/s", "estimated gyro bias, measured - true", -GYRO_BIAS, GYRO_BIAS)
BA = body("accel_bias", "ba", "m/s^2", "estimated accelerometer bias, measured - true", -ACCEL_BIAS, ACCEL_BIAS)


def position_error(frame: Frame) -> Variable:
    """Errors of the geodetic coordinates."""
    limits = [POSITION_ERROR[COORDINATES[name][0]] for name in frame.coordinates]
    names = " ".join(f"d_{name}" for name in frame.coordinates)
    return variable("d_position", names, position(frame).unit, "error of the position", [-limit for limit in limits],
                    limits, frame="WGS-84")  # fmt: skip


def velocity_error(frame: Frame) -> Variable:
    return level(frame, "dv_n", "dv", "m/s", "error of the velocity, v_hat - v", 100.0)


def phi_angle(frame: Frame) -> Variable:
    """The attitude error against the true level."""
    return level(frame, "phi", "phi", "rad", "attitude error, C_hat = (I - [phi x]) C", 0.5)


def psi_angle(frame: Frame) -> Variable:
    """The attitude error against the computed level."""
    return level(frame, "psi", "psi", "rad", "attitude error against the computed level, phi - dtheta", 0.5)


D_BG = body("d_gyro_bias", "dbg", "rad/s", "error of the gyro bias, estimated - true", -GYRO_BIAS, GYRO_BIAS)
D_BA = body("d_accel_bias", "dba", "m/s^2", "error of the accelerometer bias, estimated - true", -ACCEL_BIAS,
            ACCEL_BIAS)  # fmt: skip

# ---------------------------------------------------------------- inertial data and its noise

DT = variable("dt", "dt", "s", "length of the step", 1e-6, 10.0)
F_B = body("f_b", "f", "m/s^2", "specific force, estimated bias removed", -500.0, 500.0)
OMEGA_IB_B = body("omega_ib_b", "omega", "rad/s", "angular rate, estimated bias removed", -20.0, 20.0)
DTHETA_IB_B = body("dtheta_ib_b", "dtheta", "rad", "integral of the measured angular rate over the step", -0.5, 0.5)
DV_B = body("dv_b", "dvel", "m/s", "integral of the measured specific force over the step", -100.0, 100.0)
INCREMENTS = (
    DTHETA_IB_B,
    DV_B,
    body("dtheta_before", "dtheta_before", "rad", "dtheta_ib_b of the step before, as long", -0.5, 0.5),
    body("dv_before", "dvel_before", "m/s", "dv_b of the step before", -100.0, 100.0),
)
EARLIER = (
    body("dtheta_second", "dtheta_second", "rad", "dtheta_ib_b of two steps before, as long", -0.5, 0.5),
    body("dv_second", "dvel_second", "m/s", "dv_b of two steps before", -100.0, 100.0),
    body("dtheta_third", "dtheta_third", "rad", "dtheta_ib_b of three steps before, as long", -0.5, 0.5),
    body("dv_third", "dvel_third", "m/s", "dv_b of three steps before", -100.0, 100.0),
)

# Of the gyros this density is the angle random walk, of the accelerometers the velocity random walk.
GYRO_NOISE = noise_density("gyro_noise", "rad/sqrt(s)", "the gyros (angle random walk, ARW)", 0.1)
ACCEL_NOISE = noise_density("accel_noise", "m/s/sqrt(s)", "the accelerometers (velocity random walk, VRW)", 10.0)
GYRO_BIAS_NOISE = noise_density("gyro_bias_noise", "rad/s/sqrt(s)", "the gyro biases' random walk", 0.1)
ACCEL_BIAS_NOISE = noise_density("accel_bias_noise", "m/s^2/sqrt(s)", "the accelerometer biases' random walk", 10.0)


def strapdown(frame: Frame, gyro_bias: Variable | None = None, accel_bias: Variable | None = None) -> Function:
    """The function that carries nav over one step of increments, any estimated biases removed."""
    dtheta, dv, dtheta_before, dv_before = (item.vector for item in INCREMENTS)
    meaning = "position, velocity and attitude after one step of inertial increments"
    if gyro_bias is not None and accel_bias is not None:
        by_gyro, by_accel = gyro_bias.vector * DT.scalar, accel_bias.vector * DT.scalar
        dtheta, dtheta_before = dtheta - by_gyro, dtheta_before - by_gyro
        dv, dv_before = dv - by_accel, dv_before - by_accel
        meaning += ", estimated biases removed"
    at = (position(frame).vector, velocity(frame).vector, attitude(frame).vector)
    carried = mechanization.step(frame, *at, dtheta, dv, dtheta_before, dv_before, DT.scalar)
    return Function("strapdown", meaning, nav_outputs(frame, *carried), ("mechanics (strapdown-1)",))


def mechanics(
    frame: Frame,
    f_b,
    *,
    biased: bool = False,
    computed_level: bool = False,
    driven: tuple[tuple[Variable, Variable], ...] = (),
) -> Mechanics:
    """What F and G of a model with `strapdown` and `feedback` are the first order of.

    f_b: the specific force that its F reads, in body axes.  biased: the biases are inputs, and f_b is without them.
    computed_level: the errors of velocity and attitude stand against the level of the computed position.
    driven: further noises, and the states that they drive.
    """
    rate = OMEGA_IB_B.vector + BG.vector if biased else zeros(3, 1)  # without a bias no error knows how the body turns
    force = f_b + BA.vector if biased else f_b
    shown = (DT.scalar * rate, DT.scalar * force)
    position_n, v_n, q = position(frame), velocity(frame), attitude(frame)
    biases = ((GYRO_BIAS_NOISE, D_BG), (ACCEL_BIAS_NOISE, D_BA)) if biased else ()
    return Mechanics(
        step=tuple(zip(INCREMENTS, (*shown, *shown), strict=True)),
        driven=((GYRO_NOISE, DTHETA_IB_B), (ACCEL_NOISE, DV_B), *biases, *driven),
        level=Level(axes(frame, position_n.vector), v_n, q) if computed_level else None,
    )


def axes(frame: Frame, position) -> Matrix:
    """C_n2e, 3x3: the local level in the Earth's axes, from longitude about the pole and latitude about the west."""
    lat, lon = (position[frame.coordinates.index(name)] for name in ("lat", "lon"))
    # at latitude and longitude zero north is the pole, east the second axis, up the first
    there = Matrix([[0, 0, 1], [0, 1, 0], [1, 0, 0]]) * Matrix.hstack(frame.north, frame.east, frame.up).T
    return rotation_z(lon) * rotation_y(-lat) * there


def nav_outputs(frame: Frame, position_next: Matrix, v_next: Matrix, q_next: Matrix) -> tuple[Output, ...]:
    """Position, velocity and attitude as a function returns them; q_next is of unit norm."""
    order, unit = ", ".join(frame.coordinates), position(frame).unit
    return (
        Output(position(frame).name, position_next, unit, order, "WGS-84"),
        Output("v_n", v_next, "m/s", "velocity over the ground", frame.name),
        Output("q_b2n_wxyz", q_next, "1", "attitude, of unit norm", f"body to {frame.name}"),
    )


# ---------------------------------------------------------------- the master

MAX_DELAY, MAX_LEVER = 1.0, 100.0  # s, m
MU = body("mu", "mu", "rad", "estimated misalignment, C_b2n = C_m2n exp([mu x])", -0.5, 0.5, MASTER_BODY)
D_MU = body("dmu", "dmu", "rad", "misalignment error, mu_hat - mu", -0.5, 0.5, MASTER_BODY)
TAU = variable("tau", "tau", "s", "estimated age of the master's data", -MAX_DELAY, MAX_DELAY)
D_TAU = variable("d_tau", "d_tau", "s", "error of the delay, tau_hat - tau", -MAX_DELAY, MAX_DELAY)
LEVER_B = body("lever_b", "lever", "m", "lever arm, from the master to the slave", -MAX_LEVER, MAX_LEVER)
D_LEVER = body("d_lever", "d_lever", "m", "error of the lever arm, estimated - true", -MAX_LEVER, MAX_LEVER)
EULER_M = variable("euler_m", "roll_m pitch_m yaw_m", "rad", "roll, pitch, yaw that the master reports; where one is "
                   "not measured, the expected one", ANGLES_LOW, ANGLES_HIGH, frame="NED to master body")  # fmt: skip


def master_velocity(frame: Frame) -> Variable:
    return level(frame, "v_m_n", "v_m", "m/s", "velocity that the master reports", 1000.0)


def master_attitude(frame: Frame) -> Variable:
    return quaternion("q_m2n_wxyz", "q_m", "attitude that the master reports", f"{MASTER_BODY} to {frame.name}")


def acceleration(frame: Frame, meaning: str) -> Variable:
    return level(frame, "a_n", "a", "m/s^2", meaning, 500.0)


# How the meaning of a measurement ends: z = computed - measured, or of a turn z = +e or z = -e with this e.
TURN = "e the turn from the computed to the measured one"


def card(frame: Frame) -> tuple[str, ...]:
    """Lines of a header that hold for every model in this frame."""
    return (
        f"Position is {', '.join(frame.coordinates)} (rad, m) on WGS-84.",
        "Quaternions are Hamilton, scalar first, body to navigation.",
    )
