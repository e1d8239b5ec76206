"""The letters of strapdown navigation and its errors, and what each is by its nature."""

from functools import cache

from boresight.derive.ledger.equation import Quantity, letter
from boresight.derive.ledger.free import of, rotation
from boresight.derive.ledger.numbers import eye, zeros


@cache
def quantities() -> tuple[Quantity, ...]:
    """Every letter, with LaTeX, kind and meaning."""
    hat, dot, both = r"\hat{%s}", r"\dot{%s}", r"\dot{\hat{%s}}"
    scalars = (
        ("δτ", r"\delta\tau", "delay error", "error of the estimated delay, s"),
        ("L", "L", "angle", "geodetic latitude, rad"),
        ("λ", r"\lambda", "angle", "longitude, rad"),
        ("h", "h", "height", "height above the ellipsoid, m"),
        *((f"v_{i}", f"v_{i}", "speed", f"velocity to the {w}, m/s") for i, w in WAYS),
        *((f"f_{i}", f"f_{i}", "force", f"specific force to the {w}, m/s^2") for i, w in WAYS),
        ("Ω", r"\Omega", "rate", "rate of the Earth, rad/s"),
        ("R_NN", "R_{NN}", "slope", "change of R_N with the latitude, m/rad"),
        ("R_EE", "R_{EE}", "slope", "change of R_E with the latitude, m/rad"),
        ("R_N", "R_N", "radius", "radius of curvature of the meridian, m"),
        ("R_E", "R_E", "radius", "radius of curvature across it, m"),
        ("γ_L", r"\gamma_L", "slope of gravity", "change of gravity with the latitude, m/s^2"),
        ("γ_h", r"\gamma_h", "slope of gravity", "change of gravity with the height, 1/s^2"),
        ("γ", r"\gamma", "gravity", "magnitude of gravity, m/s^2"),
        ("φ_b", r"\phi_b", "angle", "roll of the slave, rad"),
        ("θ_b", r"\theta_b", "angle", "pitch of the slave, rad"),
        ("ψ_b", r"\psi_b", "angle", "yaw of the slave, rad"),
        ("φ_m", r"\phi_m", "angle", "roll expected of the master, rad"),
        ("θ_m", r"\theta_m", "angle", "pitch expected of the master, rad"),
        ("ψ_m", r"\psi_m", "angle", "yaw expected of the master, rad"),
        ("Δt", r"\Delta t", "time", "step, s"),
    )
    vectors = (
        ("δb_g", r"\delta b_g", "gyro bias", "error of the gyro bias, rad/s"),
        ("δb_a", r"\delta b_a", "accelerometer bias", "error of the accelerometer bias, m/s^2"),
        ("δμ", r"\delta\mu", "rotation", "error of the estimated misalignment, rad"),
        ("ε", r"\epsilon", "rotation", "rotation vector from n to the computed n, rad"),
        ("z_v", "z_v", "velocity measurement", "velocity expected of the master less the reported one, m/s"),
        ("z_a", "z_a", "attitude measurement", "turn of the expected attitude from the reported one, rad"),
        ("z_e", "z_e", "attitude measurement", "Euler angles expected of the master less the reported ones, rad"),
        ("p", "p", "position", "latitude, longitude, height"),
        ("p̂", hat % "p", "position", "computed position"),
        ("ṗ", dot % "p", "rate of position", "its rate"),
        ("ṗ̂", both % "p", "rate of position", "its computed rate"),
        ("δp", r"\delta p", "position", "error of the position, computed - true"),
        ("δṗ", r"\delta\dot{p}", "rate of position", "its rate"),
        ("v", "v^n", "velocity", "velocity over the ground, m/s"),
        ("v̂", r"\hat{v}^n", "velocity", "computed velocity, m/s"),
        ("v̇", r"\dot{v}^n", "acceleration", "its rate, m/s^2"),
        ("v̂̇", r"\dot{\hat{v}}^n", "acceleration", "its computed rate, m/s^2"),
        ("δv", r"\delta v^n", "velocity", "error of the velocity, component by component, m/s"),
        ("δv̇", r"\delta\dot{v}^n", "acceleration", "its rate, m/s^2"),
        ("δv_c", r"\delta v^c", "velocity", "error against the true velocity carried into c, m/s"),
        ("δv̇_c", r"\delta\dot{v}^c", "acceleration", "its rate, m/s^2"),
        ("φ", r"\phi", "angle", "attitude error against n, rad"),
        ("φ̇", r"\dot{\phi}", "rate", "its rate, rad/s"),
        ("ψ", r"\psi", "angle", "attitude error against c, rad"),
        ("ψ̇", r"\dot{\psi}", "rate", "its rate, rad/s"),
        ("δθ", r"\delta\theta", "angle", "turn of n to c, the level of the computed position, rad"),
        ("δθ̇", r"\delta\dot{\theta}", "rate", "its rate, rad/s"),
        ("f_b", "f^b", "force", "specific force in the body, m/s^2"),
        ("f", "f^n", "force", "specific force, m/s^2"),
        ("f̂", r"\hat{f}^n", "force", "computed specific force, m/s^2"),
        ("δf", r"\delta f^b", "force", "error of the accelerometers, measured - true, m/s^2"),
        ("ω_ib", r"\omega_{ib}^b", "rate", "rate of the body against inertial axes, rad/s"),
        ("ω̂_ib", r"\hat{\omega}_{ib}^b", "rate", "what the gyros show, rad/s"),
        ("δω", r"\delta\omega_{ib}^b", "rate", "error of the gyros, measured - true, rad/s"),
        ("g", "g^n", "gravity vector", "gravity, m/s^2"),
        ("ĝ", r"\hat{g}^n", "gravity vector", "gravity at the computed position, m/s^2"),
        ("δg", r"\delta g^n", "gravity vector", "its error, component by component, m/s^2"),
        ("δg_c", r"\delta g^c", "gravity vector", "its error against gravity carried into c, m/s^2"),
        *((f"ω_{i}", rf"\omega_{{{i}}}^n", "rate", f"{w}, rad/s") for i, w in TURNS),
        *((f"ω̂_{i}", rf"\hat{{\omega}}_{{{i}}}^n", "rate", f"computed: {w}, rad/s") for i, w in TURNS),
        *((f"δω_{i}", rf"\delta\omega_{{{i}}}^n", "rate", f"error: {w}, rad/s") for i, w in TURNS),
        ("ṙ_e", r"\dot{r}^e", "velocity", "velocity over the ground in Earth's axes, m/s"),
        ("r̈_e", r"\ddot{r}^e", "acceleration", "its rate, m/s^2"),
        ("ω_ie_e", r"\omega_{ie}^e", "rate", "rate of the Earth in its own axes, rad/s"),
        ("f_e", "f^e", "force", "specific force in Earth's axes, m/s^2"),
        ("g_e", "g^e", "gravity vector", "gravity in Earth's axes, m/s^2"),
        ("r", "r", "arm", "lever arm from master to slave, in n, m"),
        ("u", "u", "velocity", "velocity of the slave about the master against inertial axes, in n, m/s"),
        ("lever", r"\ell^b", "arm", "lever arm in the body, m"),
        ("a", "a^n", "acceleration", "rate of change of the velocity expected of the master, m/s^2"),
        ("ω_nb", r"\omega_{nb}^n", "rate", "rate of the body against n, rad/s"),
        ("μ", r"\mu", "angle", "estimated misalignment, rad"),
        ("v ENU", r"v^{ENU}", "velocity", "velocity in east, north, up, m/s"),
        ("f ENU", r"f^{ENU}", "force", "specific force in east, north, up, m/s^2"),
        ("p ENU", r"p^{ENU}", "position", "longitude, latitude, height"),
    )
    matrices = (
        ("C", "C_b^n", "attitude", "attitude"), ("Ĉ", r"\hat{C}_b^n", "attitude", "computed attitude"),
        ("Ċ", r"\dot{C}_b^n", "rate of attitude", "its rate, 1/s"),
        ("Ĉ̇", r"\dot{\hat{C}}_b^n", "rate of attitude", "its computed rate, 1/s"),
        ("E", "E", "attitude", "turn of the true attitude to the computed one, in n"),
        ("Ė", r"\dot{E}", "rate of attitude", "its rate, 1/s"),
        ("C_n2c", "C_n^c", "attitude", "n to c"), ("C_n2e", "C_n^e", "attitude", "n to Earth's axes"),
        ("Ċ_n2e", r"\dot{C}_n^e", "rate of attitude", "its rate, 1/s"),
        ("C_m2n", "C_m^n", "attitude", "attitude expected of the master"),
        ("C_b2m", "C_b^m", "attitude", "mounting of the slave on the master"),
        ("J", "J_\\mu", "3x3", "the mean of exp(-s[μ x]) for s from 0 to 1"),
        ("D", "D", "3x3", "rates of the coordinates by velocity"),
        ("P_p", "P_p", "3x3", "rates of the coordinates by coordinates, 1/s"),
        ("Ω_p", r"\Omega_p", "3x3", "ω_ie by coordinates"), ("W_p", "W_p", "3x3", "ω_en by coordinates"),
        ("W_v", "W_v", "3x3", "ω_en by velocity, 1/m"), ("G_p", "G_p", "3x3", "gravity by coordinates"),
        ("Θ", r"\Theta", "3x3", "δθ by coordinates"),
        ("I", "I", "identity", "identity"), ("0_3", "O_3", "zeros", "zeros"),
        ("C ENU", "C_b^{ENU}", "attitude", "attitude in east, north, up"),
    )  # fmt: skip
    large = (
        *(
            (f"F_{a} {n}", rf"F_{{{x}}}^{{{n}}}", (9, 9), f"F of the {w} model in {n}")
            for a, x, w in MODELS
            for n in LEVELS
        ),
        *((f"G {n}", f"G^{{{n}}}", (9, 6), f"G of both models in {n}") for n in LEVELS),
        *((f"T {n}", f"T^{{{n}}}", (9, 9), f"psi model's states by those of the phi model, {n}") for n in LEVELS),
        ("Ṫ NED", r"\dot{T}^{NED}", (9, 9), "its rate, 1/s"),
        ("[J]", r"\Pi", (9, 9), "states in NED to those in ENU"),
        ("F_16", "F_{16}", (16, 16), "F of sixteen states"),
        ("H_v", "H_v", (3, 16), "H of the master's velocity"),
        ("H_a", "H_a", (3, 16), "H of the master's attitude"),
        ("H_e", "H_e", (3, 6), "H of the master's Euler angles"),
        ("F", "F", (9, 9), "F of the phi model in NED"),
        ("Φ", r"\Phi", (9, 9), "transition matrix over the step"),
        ("S", "S", (9, 9), "covariance of the noise in a second"),
        ("Q", "Q", (9, 9), "covariance that the noise adds over the step"),
        ("I_9", "I_9", (9, 9), "identity"),
        *((f"e_{k}", f"e_{{{k}}}", (9,), f"column {k} of the identity") for k in range(1, 10)),
    )
    quaternions = (
        ("q", "q_b^n", "quaternion of the attitude"), ("q̇", r"\dot{q}_b^n", "its rate, 1/s"),
        ("q ENU", "q_b^{ENU}", "quaternion of the attitude in east, north, up"), ("q_b2m", "q_b^m", "of the mounting"),
    )  # fmt: skip
    return (
        *(letter(name, latex, "quaternion", meaning, (4,)) for name, latex, meaning in quaternions),
        *(letter(*one) for one in scalars),
        *(letter(*one, (3,)) for one in vectors),
        *(letter(*one, (3, 3)) for one in matrices),
        *(letter(name, latex, f"{shape}", meaning, shape) for name, latex, shape, meaning in large),
    )


WAYS = (("N", "north"), ("E", "east"), ("U", "zenith"))
TURNS = (("ie", "the Earth against inertial axes"), ("en", "the level against the Earth"), ("in", "both"))
MODELS = (("φ", r"\phi", "phi"), ("ψ", r"\psi", "psi"))
LEVELS = ("NED", "ENU")

STRUCTURE = {
    **dict.fromkeys(("C", "Ĉ", "C_n2c", "C_n2e", "C_m2n", "C_b2m", "E"), rotation),
    "I": lambda generator: eye(3),
    "0_3": lambda generator: zeros(3),
    "I_9": lambda generator: eye(9),
    **{f"e_{k}": lambda generator, k=k: eye(9)[:, k - 1] for k in range(1, 10)},
    "ω_in": of("ω_ie|ω_en", lambda a, b: a + b),
    "δω_in": of("δω_ie|δω_en", lambda a, b: a + b),
}

P, P_RATE = "2 rad, m", "2 rad/s, m/s"
X9, X9_RATE = f"{P}, 3 m/s, 3 rad", f"{P_RATE}, 3 m/s^2, 3 rad/s"
X16 = "3 rad, 3 m/s, 3 rad/s, 3 m/s^2, 3 rad, s"
X16_RATE = "3 rad/s, 3 m/s^2, 3 rad/s^2, 3 m/s^3, 3 rad/s, 1"
# Of letters, or kinds of them, with several units; of a matrix, the units of its rows by those of its columns.
UNITS = {
    "position": P,
    "rate of position": P_RATE,
    "D": f"{P_RATE} by 3 m/s",
    **dict.fromkeys(("F", "F_φ NED", "F_φ ENU", "F_ψ NED", "F_ψ ENU"), f"{X9_RATE} by {X9}"),
    **dict.fromkeys(("Ṫ NED", "Ṫ ENU"), f"{X9_RATE} by {X9}"),
    **dict.fromkeys(("Φ", "T NED", "T ENU"), f"{X9} by {X9}"),
    "G NED": f"{X9_RATE} by 3 rad/s, 3 m/s^2",
    "S": f"{X9_RATE} times {X9}",
    "Q": f"{X9} times {X9}",
    "F_16": f"{X16_RATE} by {X16}",
    "H_v": f"3 m/s by {X16}",
    "H_a": f"3 rad by {X16}",
    "H_e": "3 rad by 6 rad",
}
