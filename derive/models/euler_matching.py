"""Transfer alignment by Euler-angle matching, six states: Song and Lee 2001."""

from sympy import Matrix, zeros

from boresight.derive.mechanics import earth
from boresight.derive.mechanics.earth import NED
from boresight.derive.mechanics.rotation import (
    dcm_from_euler,
    dcm_from_quaternion,
    dcm_from_rotation_vector,
    euler_from_dcm,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
)
from boresight.derive.model import FirstOrder, Function, Measurement, Mechanics, Model, Output, Struct, variable
from boresight.derive.models import variables as var
from boresight.derive.models.variables import D_MU, DT, EULER_M, GYRO_NOISE, MU
from boresight.derive.named import named
from boresight.derive.papers.song_lee_2001 import results as paper


def euler_matching() -> Model:
    """States eps (attitude error of the slave) and dmu (error of the estimated misalignment master to slave)."""
    eps = var.level(NED, "eps", "eps", "rad", "attitude error, C_hat = (I - [eps x]) C", 0.5)
    q, v_n = var.attitude(NED), var.velocity(NED)
    dtheta = var.body("dtheta_ib_b", "dtheta", "rad", "rotation vector of the body over dt, gyro bias removed",
                      -0.5, 0.5)  # fmt: skip
    omega_in = var.level(NED, "omega_in_n", "omega_in", "rad/s", "rate of the local level against inertial space", 0.01)
    euler_b = variable("euler_b", "roll_b pitch_b yaw_b", "rad", "roll, pitch, yaw of the slave", var.ANGLES_LOW,
                       var.ANGLES_HIGH, frame="NED to body")  # fmt: skip
    lat, height = (
        variable(name, name, unit, meaning, low, high)
        for name, (unit, meaning, low, high) in var.COORDINATES.items()
        if name != "lon"
    )

    F = zeros(6, 6)
    F[:3, :3] = paper.attitude_error_matrix(omega_in.vector)
    C_b2n = named("C_b2n", dcm_from_quaternion(q.vector), "body to level")
    G = Matrix.vstack(paper.attitude_noise_matrix(C_b2n), zeros(3, 3))

    # The exact measurement: the master's angles as predicted from the slave's attitude and the misalignment, and how
    # they change when an error x is taken out of both.
    C_b = named("C_euler_b", dcm_from_euler(*euler_b.vector), "slave body to level")
    C_mu = named("C_b2m", dcm_from_rotation_vector(-MU.vector), "slave body to master body, by mu")
    C_eps = named("C_eps", dcm_from_rotation_vector(eps.vector), "of the rotation by eps")
    C_mu_true = named("C_b2m_true", dcm_from_rotation_vector(D_MU.vector - MU.vector), "C_b2m with dmu taken out")
    C_true = named("C_true", C_eps * C_b, "C_euler_b with eps taken out")
    master = euler_from_dcm(named("C_m2n", C_b * C_mu, "master body to level"))
    master_true = euler_from_dcm(named("C_m2n_true", C_true * C_mu_true, "C_m2n with eps and dmu taken out"))

    turn = named("q_level", quaternion_from_rotation_vector(-omega_in.vector * DT.scalar),
                 "of the turn of the level over the step, inverse", "w x y z")  # fmt: skip
    step = named("q_body", quaternion_from_rotation_vector(dtheta.vector), "of the rotation by dtheta", "w x y z")
    q_next = normalized(quaternion_product(turn, quaternion_product(q.vector, step)))
    q_corrected = normalized(paper.corrected_quaternion(q.vector, eps.vector))

    return Model(
        name="euler-matching",
        c_prefix="em",
        title="transfer alignment by Euler-angle matching, 6 states",
        frame="NED, front-right-down",
        states=(eps, D_MU),
        structs=(
            Struct("nav", "what the slave carries and the filter corrects", (q, MU)),
            Struct("step", "one interval of inertial data", (dtheta, omega_in, DT)),
            Struct("noise", "process noise", (GYRO_NOISE,)),
            Struct("angles", "what is matched", (euler_b, EULER_M)),
            Struct("place", "where the platform is and how it moves", (lat, height, v_n)),
        ),
        F=F,
        G=G,
        noise=GYRO_NOISE.vector,
        dt=DT.scalar,
        measurements=(
            Measurement(
                "euler",
                ("roll", "pitch", "yaw"),
                "rad",
                "Euler angles of the master, to first order in the misalignment: z = computed - measured",
                z=paper.measurement(euler_b.vector, EULER_M.vector, MU.vector),
                H=paper.measurement_matrix(euler_b.vector, EULER_M.vector),
                first_order=FirstOrder("euler_exact", small="mu", tied=(("euler_m", master),)),
                angle=True,
                equations=("song-lee-2001 (16)", "song-lee-2001 (18)", "song-lee-2001 (19)"),
            ),
            Measurement(
                "euler_exact",
                ("roll", "pitch", "yaw"),
                "rad",
                "Euler angles of the master by finite rotations: z = computed - measured",
                z=master - EULER_M.vector,
                h=master - master_true,
                angle=True,
                equations=("song-lee-2001 (14)", "song-lee-2001 (16)", "mechanics (euler-1)"),
            ),
        ),
        functions=(
            Function("euler_angles", "roll, pitch, yaw of the slave from its quaternion", (
                Output("euler_b", euler_from_dcm(C_b2n), "rad", "roll, pitch, yaw", "NED to body",
                       var.ANGLES_LOW, var.ANGLES_HIGH),
            ), ("song-lee-2001 (16)",)),
            Function("strapdown", "the slave's attitude after one interval of inertial data", (
                Output("q_b2n_wxyz", q_next, "1", "attitude of the slave, of unit norm", "body to NED"),
            ), ("mechanics (strapdown-1)",)),
            Function("feedback", "attitude and misalignment with the estimated errors taken out", (
                Output("q_b2n_wxyz", q_corrected, "1", "attitude of the slave, of unit norm", "body to NED"),
                Output("mu", paper.corrected_misalignment(MU.vector, D_MU.vector), "rad", "misalignment",
                       var.MASTER_BODY),
            ), ("song-lee-2001 (23)", "song-lee-2001 (24)", "song-lee-2001 (25)")),
            Function("omega_in_n", "rate of the local level, WGS-84", (
                Output("omega_in_n",
                       earth.omega_ie_n(lat.scalar) + earth.omega_en_n(lat.scalar, height.scalar, v_n.vector),
                       "rad/s", "Earth's rate plus transport rate", "NED"),
            ), ("mechanics (strapdown-1)",)),
        ),
        equations=("song-lee-2001 (20)", "song-lee-2001 (21)"),
        card=(
            "Error = computed - true; C_hat = (I - [eps x]) C.  C_b2n takes body components to navigation components.",
            "Quaternions are Hamilton, scalar first, body to navigation.  Euler angles: yaw about z, pitch, roll.",
            "Misalignment: C_b2n = C_m2n exp([mu x]), m the master's body axes.",
        ),
        mechanics=Mechanics(step=((dtheta, zeros(3, 1)),), driven=((GYRO_NOISE, dtheta),)),
    )  # fmt: skip
