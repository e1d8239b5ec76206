"""Transfer alignment by Euler-angle matching, six states: Song and Lee 2001."""

from math import pi, radians

from sympy import Matrix, zeros

from boresight.derive import earth
from boresight.derive.model import FirstOrder, Function, Measurement, Model, Output, Struct, variable
from boresight.derive.papers import song_lee_2001 as paper
from boresight.derive.rotation import (
    dcm_from_euler,
    dcm_from_quaternion,
    dcm_from_rotation_vector,
    euler_from_dcm,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
)

PITCH = radians(80)  # Euler angles have a singularity at 90 deg, and their errors grow as 1 / cos(pitch)
ANGLES_LOW, ANGLES_HIGH = (-pi, -PITCH, -pi), (pi, PITCH, pi)


def euler_matching() -> Model:
    """States eps (attitude error of the slave) and dmu (error of the estimated misalignment master to slave)."""
    eps = variable("eps", "eps_n eps_e eps_d", "rad", "attitude error, C_hat = (I - [eps x]) C", -0.5, 0.5, frame="NED")
    dmu = variable("dmu", "dmu_x dmu_y dmu_z", "rad", "misalignment error, mu_hat - mu", -0.5, 0.5, frame="master body")

    q = variable(
        "q_b2n_wxyz",
        "q_w q_x q_y q_z",
        "1",
        "attitude of the slave",
        -1.001,
        1.001,
        frame="body to NED",
        norm=(0.999, 1.001),
    )
    mu = variable("mu", "mu_x mu_y mu_z", "rad", "estimated misalignment, C_b2n = C_r2n exp([mu x])", -0.5, 0.5,
                  frame="master body")  # fmt: skip
    dtheta = variable("dtheta_ib_b", "dtheta_x dtheta_y dtheta_z", "rad",
                      "rotation vector of the body over dt, gyro bias removed", -0.5, 0.5,
                      frame="slave body")  # fmt: skip
    omega_in = variable("omega_in_n", "omega_in_n omega_in_e omega_in_d", "rad/s",
                        "rate of the local level against inertial space", -0.01, 0.01, frame="NED")  # fmt: skip
    dt = variable("dt", "dt", "s", "length of the step", 1e-6, 10.0)
    gyro_noise = variable("gyro_noise", "gyro_noise_x gyro_noise_y gyro_noise_z", "rad/sqrt(s)",
                          "root power spectral density of the gyros", 0.0, 0.1, frame="slave body")  # fmt: skip
    euler_b = variable("euler_b", "phi_b theta_b psi_b", "rad", "roll, pitch, yaw of the slave", ANGLES_LOW,
                       ANGLES_HIGH, frame="NED to slave body")  # fmt: skip
    euler_r = variable("euler_r", "phi_r theta_r psi_r", "rad",
                       "roll, pitch, yaw of the master; where one is not measured, the slave's", ANGLES_LOW,
                       ANGLES_HIGH, frame="NED to master body")  # fmt: skip
    lat = variable("lat", "lat", "rad", "geodetic latitude", -radians(85), radians(85))
    height = variable("height", "height", "m", "height above the ellipsoid", -500.0, 30000.0)
    v_n = variable("v_n", "v_n v_e v_d", "m/s", "velocity over the ground", -1000.0, 1000.0, frame="NED")

    F = zeros(6, 6)
    F[:3, :3] = paper.attitude_error_matrix(omega_in.vector)
    C_b2n = dcm_from_quaternion(q.vector)
    G = Matrix.vstack(paper.attitude_noise_matrix(C_b2n), zeros(3, 3))

    # The exact measurement: the master's angles as predicted from the slave's attitude and the misalignment, and how
    # they change when an error x is taken out of both.
    C_b = dcm_from_euler(*euler_b.vector)
    master = euler_from_dcm(C_b * dcm_from_rotation_vector(-mu.vector))
    C_b_true = dcm_from_rotation_vector(eps.vector) * C_b
    master_true = euler_from_dcm(C_b_true * dcm_from_rotation_vector(dmu.vector - mu.vector))

    turn = quaternion_from_rotation_vector(-omega_in.vector * dt.scalar)
    step = quaternion_from_rotation_vector(dtheta.vector)
    q_next = normalized(quaternion_product(turn, quaternion_product(q.vector, step)))
    q_corrected = normalized(paper.corrected_quaternion(q.vector, eps.vector))

    return Model(
        name="euler-matching",
        c_prefix="em",
        title="transfer alignment by Euler-angle matching, 6 states",
        frame="NED, front-right-down",
        states=(eps, dmu),
        structs=(
            Struct("nav", "what the slave carries and the filter corrects", (q, mu)),
            Struct("step", "one interval of inertial data", (dtheta, omega_in, dt)),
            Struct("noise", "process noise", (gyro_noise,)),
            Struct("angles", "what is matched", (euler_b, euler_r)),
            Struct("place", "where the platform is and how it moves", (lat, height, v_n)),
        ),
        F=F,
        G=G,
        noise=gyro_noise.vector,
        dt=dt.scalar,
        measurements=(
            Measurement(
                "euler",
                ("roll", "pitch", "yaw"),
                "rad",
                "Euler angles of the slave minus those of the master, first order in the misalignment",
                z=paper.measurement(euler_b.vector, euler_r.vector, mu.vector),
                H=paper.measurement_matrix(euler_b.vector, euler_r.vector),
                first_order=FirstOrder("euler_exact", small="mu", tied=(("euler_r", master),)),
                angle=True,
                equations=("song-lee-2001 (16)", "song-lee-2001 (18)", "song-lee-2001 (19)"),
            ),
            Measurement(
                "euler_exact",
                ("roll", "pitch", "yaw"),
                "rad",
                "the master's Euler angles predicted by finite rotations minus those measured",
                z=master - euler_r.vector,
                h=master - master_true,
                angle=True,
                equations=("song-lee-2001 (14)", "song-lee-2001 (16)"),
            ),
        ),
        functions=(
            Function("euler_angles", "roll, pitch, yaw of the slave from its quaternion", (
                Output("euler_b", euler_from_dcm(C_b2n), "rad", "roll, pitch, yaw", "NED to slave body",
                       ANGLES_LOW, ANGLES_HIGH),
            )),
            Function("strapdown", "the slave's attitude after one interval of inertial data", (
                Output("q_b2n_wxyz", q_next, "1", "attitude of the slave, of unit norm", "body to NED"),
            )),
            Function("feedback", "attitude and misalignment with the estimated errors taken out", (
                Output("q_b2n_wxyz", q_corrected, "1", "attitude of the slave, of unit norm", "body to NED"),
                Output("mu", paper.corrected_misalignment(mu.vector, dmu.vector), "rad", "misalignment", "master body"),
            ), ("song-lee-2001 (23)", "song-lee-2001 (24)", "song-lee-2001 (25)")),
            Function("omega_in_n", "rate of the local level, WGS-84", (
                Output("omega_in_n",
                       earth.omega_ie_n(lat.scalar) + earth.omega_en_n(lat.scalar, height.scalar, v_n.vector),
                       "rad/s", "Earth's rate plus transport rate", "NED"),
            )),
        ),
        equations=("song-lee-2001 (20)", "song-lee-2001 (21)"),
        card=(
            "Error = computed - true; C_hat = (I - [eps x]) C.  C_b2n takes body components to navigation components.",
            "Quaternions are Hamilton, scalar first, body to navigation.  Euler angles: yaw about z, pitch, roll.",
            "Misalignment: C_b2n = C_r2n exp([mu x]), r the master's body axes.",
        ),
    )  # fmt: skip
