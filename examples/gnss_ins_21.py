"""GNSS/INS, loosely coupled, whose sensors have scale factors too: 21 errors, written as mechanics alone.

boresight generate gnss_ins_21.py:GNSS_INS_21
boresight verify gnss_ins_21.py:GNSS_INS_21
python fly_gnss_ins_21.py

The states are those of KF-GINS: position in metres, velocity, attitude, biases and scale factors.  Biases and scale
factors fade with a correlation time (first-order Gauss-Markov), the estimates as their errors do.  An error of a
latitude is in metres: what turns it into radians stands in `feedback`, and F, G and H follow.
"""

from sympy import Matrix

from boresight import NED, Function, Measurement, Mechanics, Model, Output, Struct, variable
from boresight import variables as var
from boresight.mechanics import (
    along,
    dcm_from_quaternion,
    displacement_by_position,
    metres,
    normalized,
    omega_in_n,
    quaternion_from_rotation_vector,
    quaternion_product,
    skew,
    step,
)

# ---------------------------------------------------------------- what the navigation estimates, and by what it errs

p, v, q = var.position(NED), var.velocity(NED), var.attitude(NED)
gyro_scale = var.body("gyro_scale", "kg", "1", "estimated scale factor of the gyros, less 1", -0.02, 0.02)
accel_scale = var.body("accel_scale", "ka", "1", "estimated scale factor of the accelerometers, less 1", -0.02, 0.02)
sensors = (var.BG, var.BA, gyro_scale, accel_scale)

d_position = variable("d_position", "dr_n dr_e dr_h", "m", "error of position, north, east and height", -1e3, 1e3)
dv, phi = var.velocity_error(NED), var.phi_angle(NED)
d_gyro_scale = var.body("d_gyro_scale", "dkg", "1", "error of the gyros' scale factors, estimated - true", -0.02, 0.02)
d_accel_scale = var.body("d_accel_scale", "dka", "1", "error of the accelerometers', estimated - true", -0.02, 0.02)
d_sensors = (var.D_BG, var.D_BA, d_gyro_scale, d_accel_scale)

# ---------------------------------------------------------------- what is measured

fading = variable("correlation_time", "t_corr", "s", "correlation time of biases and scale factors", 10.0, 1e6)
noises = (
    var.GYRO_NOISE,
    var.ACCEL_NOISE,
    var.GYRO_BIAS_NOISE,
    var.ACCEL_BIAS_NOISE,
    var.noise_density("gyro_scale_noise", "1/sqrt(s)", "what drives the gyros' scale factors", 0.1),
    var.noise_density("accel_scale_noise", "1/sqrt(s)", "what drives the accelerometers' scale factors", 0.1),
)
lever = var.body("lever_b", "lever", "m", "lever arm, from the sensors to the antenna", -100.0, 100.0)
p_fix = variable("p_fix", "lat_fix lon_fix height_fix", p.unit, "position of the antenna", p.low, p.high)
v_fix = var.level(NED, "v_fix_n", "v_fix", "m/s", "velocity of the antenna", 1000.0)

# ---------------------------------------------------------------- the sensors and the antenna

dt = var.DT.scalar


def true_increment(increment, bias, scale):
    """What a sensor with these errors should have delivered."""
    rows = zip(increment.vector, bias.vector, scale.vector, strict=True)
    return Matrix([(measured - b * dt) / (1 + k) for measured, b, k in rows])


def shown(rate, bias, scale):
    """What a sensor with these errors delivers at a constant rate."""
    rows = zip(rate.vector, bias.vector, scale.vector, strict=True)
    return dt * Matrix([(1 + k) * true + b for true, b, k in rows])


gyro, accel, gyro_before, accel_before = var.INCREMENTS
turned = step(
    NED, p.vector, v.vector, q.vector,
    true_increment(gyro, var.BG, gyro_scale), true_increment(accel, var.BA, accel_scale),
    true_increment(gyro_before, var.BG, gyro_scale), true_increment(accel_before, var.BA, accel_scale), dt,
)  # fmt: skip

C_b2n = dcm_from_quaternion(q.vector)
lengths = metres(*NED.latitude_and_height(p.vector), NED)
antenna = p.vector + along(NED, C_b2n * lever.vector, lengths)
omega_nb_b = var.OMEGA_IB_B.vector - C_b2n.T * omega_in_n(NED, p.vector, v.vector)
v_antenna = v.vector + C_b2n * skew(omega_nb_b) * lever.vector

GNSS_INS_21 = Model(
    name="gnss-ins-21",
    c_prefix="gk",
    title="GNSS/INS with biases and scale factors, 21 states",
    frame="NED with body axes front-right-down",
    states=(d_position, dv, phi, *d_sensors),
    structs=(
        Struct("nav", "what is carried and corrected", (p, v, q, *sensors)),
        Struct("imu", "inertial data, biases and scale factors removed", (var.F_B, var.OMEGA_IB_B, var.DT)),
        Struct("increments", "what the sensors deliver over one step, and over the step before", var.INCREMENTS),
        Struct("noise", "process noise", noises),
        Struct("sensors", "how long their errors last", (fading,)),
        Struct("fix", "what the receiver delivers", (p_fix, v_fix, lever)),
    ),
    noise=Matrix.vstack(*(noise.vector for noise in noises)),
    dt=dt,
    order=1,
    measurements=(
        Measurement("position", NED.axes, "m", "position of the antenna: z = computed - measured",
                    z=displacement_by_position(NED, p_fix.vector) * (antenna - p_fix.vector), at_zero=True),
        Measurement("velocity", NED.axes, "m/s", "velocity of the antenna: z = computed - measured",
                    z=v_antenna - v_fix.vector, at_zero=True),
    ),
    functions=(
        Function("strapdown", "one step of the navigation", (
            *var.nav_outputs(NED, *turned),
            *(Output(s.name, s.vector * (1 - dt / fading.scalar), s.unit, s.meaning, "body") for s in sensors),
        )),
        Function("feedback", "navigation with the errors taken out", (
            *var.nav_outputs(
                NED, p.vector - d_position.vector.multiply_elementwise(lengths.applyfunc(lambda m: 1 / m)),
                v.vector - dv.vector,
                normalized(quaternion_product(quaternion_from_rotation_vector(phi.vector), q.vector)),
            ),
            *(Output(s.name, s.vector - e.vector, s.unit, s.meaning, "body")
              for s, e in zip(sensors, d_sensors, strict=True)),
        )),
    ),
    mechanics=Mechanics(
        step=(
            (gyro, shown(var.OMEGA_IB_B, var.BG, gyro_scale)),
            (accel, shown(var.F_B, var.BA, accel_scale)),
            (gyro_before, shown(var.OMEGA_IB_B, var.BG, gyro_scale)),
            (accel_before, shown(var.F_B, var.BA, accel_scale)),
        ),
        driven=((var.GYRO_NOISE, gyro), (var.ACCEL_NOISE, accel), *zip(noises[2:], d_sensors, strict=True)),
    ),
)  # fmt: skip
