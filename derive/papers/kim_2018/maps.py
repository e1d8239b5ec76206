"""The paper's states, inputs and rows, and those of the two models that make C from it."""

from boresight.derive.ledger.map import Map, Match, Row
from boresight.derive.models.azimuth_hold import azimuth_hold
from boresight.derive.models.velocity_dcm import velocity_dcm

POSITION = r"[l \ L \ h]^T"

TRANSFER = Map(
    model=velocity_dcm,
    states=(
        Row(r"\delta v^n", "dv_n"),
        Row(r"\phi^n", "psi", why="section 2.1 means the psi model by this letter"),
        Row(r"\theta", "dmu", "-1", "ours is the error of the estimate, μ̂ - μ, which turns the mounting by -θ"),
        Row(r"\Delta t", "d_tau", "-1", "ours is the error of the estimated age; the paper's is the age itself"),
    ),
    inputs={
        "lon_lat_height": POSITION,
        "v_n": "v^n",
        "q_b2n_wxyz": "Q",
        "f_b": "f^b",
        "a_n": r"\dot{v}^n",
        "q_m2n_wxyz": "q_r^n",
        "omega_nm_n": r"\omega_{nr}^n",
    },
    measurements=(Row("Z_v(k)", "velocity"), Row("Z_{dcm}(k)", "dcm")),
    matches=(
        Match("3", "F", "F"),
        Match("4", "Z_v(k)", "z", ("velocity",), {"v_n": r"\hat{v}_{SINS}^n", "v_m_n": r"\hat{v}_{MINS}^n"}),
        Match(
            "5",
            "Z_{dcm}(k)",
            "z",
            ("dcm",),
            {"q_b2n_wxyz": r"\hat{Q}", "q_m2n_wxyz": r"\hat{q}_r^n", "mu": r"\hat{\mu}"},
        ),
        Match("6", "H", "H", ("velocity", "dcm")),
    ),
)

MEASURED = r"[\hat{v}_e \ \hat{v}_n \ \hat{v}_u]^T"
BIAS = "ours is the error of the estimate; the paper's is what the sensor shows too much, measured - true"
HOLD = Map(
    model=azimuth_hold,
    states=(
        Row("x_p", "d_position"),
        Row("x_v", "dv_n"),
        Row(r"x_\phi", "phi"),
        Row("x_{Cb}", "d_gyro_bias", "-1", BIAS),
        Row("x_{Ab}", "d_accel_bias", "-1", BIAS),
    ),
    noises=(Row(r"\delta \omega_{ib}^b", "gyro_noise"), Row(r"\delta f^b", "accel_noise")),
    inputs={"lon_lat_height": POSITION, "v_n": "v^n", "q_b2n_wxyz": "Q", "f_b": "f^b"},
    measurements=(Row(MEASURED, "zupt"), Row(r"\phi_u", "azimuth")),
    matches=(
        Match("7", "F_k", "F"),
        Match("7", r"\Gamma_k", "G"),
        Match("16", MEASURED, "z", ("zupt",), {"v_n": MEASURED}),
        Match("17", "H_v", "H", ("zupt",)),
        Match(
            "21",
            r"(C_b^p \overline{C}_n^b(1,2) - C_b^p \overline{C}_n^b(2,1))/2",
            "z",
            ("azimuth",),
            {"q_b2n_wxyz": r"\hat{Q}", "q_ref_wxyz": "Q"},
        ),
        Match("23", "H_k", "H", ("zupt", "azimuth")),
    ),
)

FILTER = "the filter has its own functions for every model; no model makes them"
UNFLOWN = {
    "1": "the order of the states, which the map carries over to the model's own",
    "2": "its rows are those of the matrix of (3)",
    "8": "the order of the states, which the map carries over to the model's own",
    "9": "its rows are those of the matrix of (7)",
    "10": "its rows are those of the matrices of (7)",
    "11": "its rows are those of the matrices of (7)",
    "12": "the C takes the transition to the second power of F ΔT",
    "13": FILTER,
    "14": FILTER,
    "15": "what noise is, no function computes",
    "18": "the sign of the attitude error, in which (7) is written",
    "19": "the sign of the attitude error, in which (7) is written",
    "20": "a step on the way to (21)",
    "22": "the rows of (16) and (21)",
    "24": FILTER,
    "25": FILTER,
    "26": FILTER,
    "27": "a subtraction within the function feedback",
    "28": "a subtraction within the function feedback",
    "29": "the function feedback turns the quaternion by a finite rotation, of which (29) is the first order",
    "30": "what the sensors show, no function computes",
    "31": "the detector has C of its own, stationary_detector, which no model makes",
    "32": "the detector has C of its own, stationary_detector, which no model makes",
}
MAPS = (TRANSFER, HOLD)
