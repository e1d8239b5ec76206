"""The error-state filter of a multirotor autopilot: 24 errors, of which 9 move by themselves.

boresight generate autopilot.py:AUTOPILOT
boresight verify autopilot.py:AUTOPILOT

The states are those of PX4's ekf2: attitude, velocity, position, biases of gyros and accelerometers, the
magnetic field of the Earth and of the body, wind, and the height of the ground.  Error = computed - true,
attitude C_hat = (I - [theta x]) C, against a local level whose axes are north, east, down (NED), in metres.
"""

from sympy import Matrix, Piecewise, atan2, cos, sin, sqrt, zeros

from boresight import Function, Measurement, Mechanics, Model, Output, Struct, constant, variable
from boresight.mechanics import (
    dcm_from_quaternion,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
)

GRAVITY = constant("g", "9.81", "m/s^2", "gravity")
# What keeps roots and arguments of atan2 off zero.
LEAST_V2 = constant("least_v2", "1e-6", "m^2/s^2", "keeps a square root off zero")
LEAST_V = constant("least_v", "1e-3", "m/s", "keeps a speed off zero")
LEAST_DISTANCE = constant("least_distance", "0.1", "m", "keeps a distance off zero")
LEAST_COSINE = constant("least_cosine", "1e-6", "1", "keeps a direction off zero")
LEAST_FIELD = constant("least_field", "1e-6", "T", "keeps a field off zero")


def vector(name, letter, unit, meaning, limit, axes="xyz", low=None):
    """One component per axis, each from -limit, or from `low`, to limit."""
    names = " ".join(f"{letter}_{axis}" for axis in axes)
    return variable(name, names, unit, meaning, -limit if low is None else low, limit)


# ---------------------------------------------------------------- what the navigation estimates

q = variable("q", "q_w q_x q_y q_z", "1", "attitude, body to level", -1.001, 1.001, norm=(0.999, 1.001))
nav = {
    "vel": vector("vel", "v", "m/s", "velocity", 100.0, "ned"),
    "pos": vector("pos", "p", "m", "position in the local level", 1e4, "ned"),
    "gyro_bias": vector("gyro_bias", "bg", "rad/s", "gyro bias, measured - true", 0.5),
    "accel_bias": vector("accel_bias", "ba", "m/s^2", "accelerometer bias, measured - true", 2.0),
    "mag_i": vector("mag_i", "mi", "T", "magnetic field of the Earth, in the level", 1.0, "ned"),
    "mag_b": vector("mag_b", "mb", "T", "magnetic field of the body", 1.0),
    "wind": vector("wind", "wind", "m/s", "wind", 50.0, "ne"),
    "terrain": variable("terrain", "terrain", "m", "ground, down from the origin", -1e4, 1e4),
}

theta = vector("theta", "th", "rad", "attitude error, C_hat = (I - [theta x]) C", 0.5, "ned")
errors = {
    "vel": vector("d_vel", "dv", "m/s", "error of the velocity", 100.0, "ned"),
    "pos": vector("d_pos", "dp", "m", "error of the position", 1e3, "ned"),
    "gyro_bias": vector("d_gyro_bias", "dbg", "rad/s", "error of the gyro bias", 0.5),
    "accel_bias": vector("d_accel_bias", "dba", "m/s^2", "error of the accelerometer bias", 2.0),
    "mag_i": vector("d_mag_i", "dmi", "T", "error of the field of the Earth", 1.0, "ned"),
    "mag_b": vector("d_mag_b", "dmb", "T", "error of the field of the body", 1.0),
    "wind": vector("d_wind", "dwind", "m/s", "error of the wind", 50.0, "ne"),
    "terrain": variable("d_terrain", "dterrain", "m", "error of the ground", -1e3, 1e3),
}
states = (theta, *errors.values())

# ---------------------------------------------------------------- what the sensors deliver

accel = vector("accel", "accel", "m/s^2", "specific force", 160.0)
turn = vector("delta_ang", "dang", "rad", "turn over the step", 1.0)
gain = vector("delta_vel", "dvel", "m/s", "velocity gained over the step", 16.0)
dt = variable("dt", "dt", "s", "length of the step", 1e-4, 0.1)
noises = (
    gyro_noise := vector("gyro_noise", "ng", "rad/sqrt(s)", "noise density of the gyros", 1.0, low=0.0),
    accel_noise := vector("accel_noise", "na", "m/s/sqrt(s)", "noise density of the accelerometers", 10.0, low=0.0),
    vector("gyro_bias_noise", "nbg", "rad/s/sqrt(s)", "random walk of the gyro biases", 1.0, low=0.0),
    vector("accel_bias_noise", "nba", "m/s^2/sqrt(s)", "random walk of the accelerometer biases", 1.0, low=0.0),
    vector("mag_i_noise", "nmi", "T/sqrt(s)", "random walk of the field of the Earth", 1.0, "ned", low=0.0),
    vector("mag_b_noise", "nmb", "T/sqrt(s)", "random walk of the field of the body", 1.0, low=0.0),
    vector("wind_noise", "nwind", "m/s/sqrt(s)", "random walk of the wind", 10.0, "ne", low=0.0),
    variable("terrain_noise", "nterrain", "m/sqrt(s)", "random walk of the ground", 0.0, 10.0),
)

m_mag = vector("mag", "mag", "T", "magnetic field, measured", 2.0)
m_yaw = variable("yaw", "yaw", "rad", "heading, measured", -3.2, 3.2)
m_airspeed = variable("airspeed", "tas", "m/s", "true airspeed, measured", 0.0, 100.0)
m_flow = vector("flow", "flow", "rad/s", "optical flow less the turn of the body, measured", 10.0, "xy")
m_offset = variable("antenna_offset", "offset", "rad", "direction of the two antennas in the body", -3.2, 3.2)
m_heading = variable("antenna_heading", "heading", "rad", "direction of the two antennas over ground", -3.2, 3.2)
m_declination = variable("declination", "decl", "rad", "magnetic declination of a table", -3.2, 3.2)
m_vel = vector("gnss_vel", "gv", "m/s", "velocity of the receiver", 100.0, "ned")
m_pos = vector("gnss_pos", "gp", "m", "position of the receiver", 1e4, "ned")
m_height = variable("hagl", "hagl", "m", "height above ground, measured", -100.0, 1e4)

# ---------------------------------------------------------------- what the sensors should show


def off_zero(value, least):
    return value + Piecewise((-least, value < 0), (least, True))


def relative_to_wind(vel, wind):
    return vel - Matrix([wind[0], wind[1], 0])


def mag_body(q, mag_i, mag_b, **_):
    return dcm_from_quaternion(q).T * mag_i + mag_b


def heading(q, **_):
    C = dcm_from_quaternion(q)
    return Matrix([atan2(C[1, 0], C[0, 0] + LEAST_COSINE)])


def airspeed(vel, wind, **_):
    v = relative_to_wind(vel, wind)
    return Matrix([sqrt(v.dot(v) + LEAST_V2)])


def sideslip(q, vel, wind, **_):
    v_b = dcm_from_quaternion(q).T * relative_to_wind(vel, wind)
    return Matrix([atan2(v_b[1], off_zero(v_b[0], LEAST_V))])


def optical_flow(q, vel, pos, terrain, **_):
    C = dcm_from_quaternion(q)
    v_b = C.T * vel
    return Matrix([v_b[1], -v_b[0]]) / off_zero(terrain[0] - pos[2], LEAST_DISTANCE) * C[2, 2]


def antenna_heading(q, **_):
    a = dcm_from_quaternion(q) * Matrix([cos(m_offset.scalar), sin(m_offset.scalar), 0])
    return Matrix([atan2(a[1], off_zero(a[0], LEAST_COSINE))])


def declination(mag_i, **_):
    return Matrix([atan2(mag_i[1], off_zero(mag_i[0], LEAST_FIELD))])


computed = {"q": q.vector} | {key: v.vector for key, v in nav.items()}


def measured(name, rows, unit, meaning, predicted, value=None, angle=None):
    """H is not written: it follows from z and feedback."""
    z = predicted(**computed) - (value.vector if value else zeros(len(rows), 1))
    seen = "z = computed - measured" if value else "which is zero: z = computed"
    return Measurement(name, rows, unit, f"{meaning}: {seen}", z=z, at_zero=True, angle=bool(angle))


measurements = (
    measured("mag", ("x", "y", "z"), "T", "magnetic field in the body", mag_body, m_mag),
    measured("yaw", ("yaw",), "rad", "heading", heading, m_yaw, angle=True),
    measured("airspeed", ("tas",), "m/s", "true airspeed", airspeed, m_airspeed),
    measured("sideslip", ("beta",), "rad", "sideslip", sideslip, angle=True),
    measured("flow", ("x", "y"), "rad/s", "optical flow", optical_flow, m_flow),
    measured("antennas", ("heading",), "rad", "direction of two antennas", antenna_heading, m_heading, angle=True),
    measured("declination", ("decl",), "rad", "declination of the field", declination, m_declination, angle=True),
    measured("velocity", ("n", "e", "d"), "m/s", "velocity", lambda vel, **_: vel, m_vel),
    measured("position", ("n", "e", "d"), "m", "position", lambda pos, **_: pos, m_pos),
    measured("height", ("hagl",), "m", "height above ground", lambda terrain, pos, **_: terrain - pos[2:, :], m_height),
)

# ---------------------------------------------------------------- the navigation itself

step = dt.scalar
turned = quaternion_from_rotation_vector(turn.vector - nav["gyro_bias"].vector * step)
v_gained = (
    dcm_from_quaternion(q.vector) * (gain.vector - nav["accel_bias"].vector * step) + Matrix([0, 0, GRAVITY]) * step
)

AUTOPILOT = Model(
    name="autopilot",
    c_prefix="ap",
    title="the errors of an autopilot's navigation, 24 states",
    frame="local NED with body axes front-right-down",
    states=states,
    structs=(
        Struct("nav", "what is estimated and corrected", (q, *nav.values())),
        Struct("imu", "one step", (accel, dt)),
        Struct("increments", "what the sensors integrate over the step", (turn, gain)),
        Struct("noise", "process noise", noises),
        Struct("compass", "magnetic field", (m_mag,)),
        Struct("heading_fix", "heading", (m_yaw,)),
        Struct("air", "airspeed", (m_airspeed,)),
        Struct("camera", "optical flow", (m_flow,)),
        Struct("antenna_pair", "two antennas", (m_heading, m_offset)),
        Struct("field_model", "magnetic declination", (m_declination,)),
        Struct("receiver_vel", "velocity", (m_vel,)),
        Struct("receiver_pos", "position", (m_pos,)),
        Struct("rangefinder", "distance", (m_height,)),
    ),
    noise=Matrix.vstack(*(noise.vector for noise in noises)),
    dt=step,
    order=1,
    measurements=measurements,
    functions=(
        Function("strapdown", "one step of the navigation", (
            Output("q", normalized(quaternion_product(q.vector, turned)), "1", "attitude"),
            Output("vel", nav["vel"].vector + v_gained, "m/s", "velocity"),
            Output("pos", nav["pos"].vector + nav["vel"].vector * step, "m", "position"),
        )),
        Function("feedback", "navigation with the errors taken out", (
            Output("q", normalized(quaternion_product(quaternion_from_rotation_vector(theta.vector), q.vector)),
                   "1", "attitude"),
            *(Output(key, computed[key] - errors[key].vector, v.unit, v.meaning) for key, v in nav.items()),
        )),
    ),
    mechanics=Mechanics(
        step=((turn, nav["gyro_bias"].vector * step), (gain, accel.vector * step)),
        driven=((gyro_noise, turn), (accel_noise, gain), *zip(noises[2:], states[3:], strict=True)),
    ),
)  # fmt: skip
