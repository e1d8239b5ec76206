"""The paper's states, inputs and rows, and those of the two models that make C from it."""

from boresight.derive.ledger.map import Map, Match, Row
from boresight.derive.models.velocity_attitude import velocity_attitude
from boresight.derive.models.velocity_attitude_lever import velocity_attitude_lever

BIAS = "ours is the error of the estimate; the paper's is what the sensor shows too much, measured - true"
STATES = (
    Row(r"\phi", "phi"),
    Row(r"\delta v", "dv_n"),
    Row("b_g", "d_gyro_bias", "-1", BIAS),
    Row("b_a", "d_accel_bias", "-1", BIAS),
    Row(r"\delta\mu", "dmu"),
    Row(r"\delta t_d", "d_tau", "-1", "ours is the error of the believed age; the paper's is the age itself"),
)
INPUTS = {
    "lat_lon_height": r"\Lambda",
    "v_n": "v_s^n",
    "q_b2n_wxyz": "q_S^n",
    "q_b2m_wxyz": "q_S^M",
    "f_b": "f^b",
    "omega_ib_b": "w_{ib}^b",
    "lever_b": "L",
    "v_m_n": "v_M^n",
    "q_m2n_wxyz": "q_M^n",
}
# What the caller takes between two updates; exact in H, whose last column it is.
BETWEEN = r"\frac{1}{dt} (v_{s,k} - v_{s,k-1}) + \frac{1}{dt} (u_k - u_{k-1})"
RATE = {"a_n": r"\dot{v}_s + \dot{u}"}
TURN = r"\vee(C_S^n C_M^S C_M^{nT})"

ALIGNMENT = Map(
    model=velocity_attitude,
    states=STATES,
    inputs=INPUTS,
    measurements=(Row("z_v", "velocity"), Row("z_{DCM}", "dcm")),
    matches=(
        Match("1", r"v_s^n + [w_{in}^n \times] C_S^n L - C_S^n [w_{ib}^b \times] L", "expected.v_m_n"),
        Match(
            "3",
            r"v_S^n + u_k + \frac{v_{s,k-1} - v_{s,k}}{dt} \delta t_d + \frac{u_{k-1} - u_k}{dt} \delta t_d - v_M^n",
            "z",
            ("velocity",),
            {"a_n": BETWEEN, "lag": r"\delta t_d"},
        ),
        Match("3", "F", "F"),  # printed nowhere: the states of (3) and (5)
        Match("3", "H_v", "H", ("velocity",), RATE),
        Match("4", TURN, "z", ("dcm",), {"lag": "0"}),
        Match("5", rf"{TURN} - C_S^n w_{{nb}}^b \delta t_d", "z", ("dcm",), {"lag": r"\delta t_d"}),
        Match("5", "H_{DCM}", "H", ("dcm",)),
    ),
)
WITH_LEVER = Map(
    model=velocity_attitude_lever,
    states=(*STATES, Row(r"\delta L", "d_lever", why="the paper takes the lever arm as known")),
    inputs=INPUTS,
    measurements=ALIGNMENT.measurements,
    matches=(Match("3", "H_{v,L}", "H", ("velocity",), RATE), Match("5", "H_{DCM,L}", "H", ("dcm",))),
)
MAPS = (ALIGNMENT, WITH_LEVER)
UNFLOWN = {
    "2": "what changes between two updates is an input of the C, a_n",
    "6": "the sea is no part of a filter",
}
