"""The functions that make the C, held against the rows: the same states, inputs and signs."""

from boresight.derive.ledger.map import Map, Match, Row
from boresight.derive.models.euler_matching import euler_matching
from boresight.derive.models.phi_error import phi_error, phi_error_ned
from boresight.derive.models.psi_error import psi_error, psi_error_ned
from boresight.derive.models.strapdown import strapdown_ned
from boresight.derive.models.velocity_attitude import velocity_attitude

POSITION, VELOCITY = Row(r"\delta p", "d_position"), Row(r"\delta v^n", "dv_n")
PHI, BY_C = Row(r"\phi", "phi"), (Row(r"\delta v^c", "dv_c"), Row(r"\psi", "psi"))
NOISES = (Row(r"\delta\omega_{ib}^b", "gyro_noise"), Row(r"\delta f^b", "accel_noise"))
IN_NED = {"lat_lon_height": "p", "v_n": "v^n", "f_n": "f^n", "q_b2n_wxyz": "q_b^n"}
IN_ENU = {"lon_lat_height": "p^{ENU}", "v_n": "v^{ENU}", "f_n": "f^{ENU}", "q_b2n_wxyz": "q_b^{ENU}"}
SENSED = {"f_b": "f^b", "omega_ib_b": r"\omega_{ib}^b"}
OF_PHI = (POSITION, VELOCITY, PHI)

MAPS = (
    Map(strapdown_ned, (), {"lat_lon_height": "p", "v_n": "v^n", "q_b2n_wxyz": "q_b^n", **SENSED},
        (Match("strapdown-1", r"\dot{p}", "rates.position_rate"),
         Match("strapdown-1", r"\dot{v}^n", "rates.v_n_rate"),
         Match("strapdown-1", r"\dot{q}_b^n", "rates.q_b2n_rate"),
         Match("strapdown-1", r"\omega_{ie}^n", "earth.omega_ie_n"),
         Match("strapdown-1", r"\omega_{en}^n", "earth.omega_en_n"),
         Match("strapdown-1", "g^n", "earth.gravity_n"))),
    Map(phi_error_ned, OF_PHI, IN_NED,
        (Match("phi-3", r"F_{\phi}^{NED}", "F"), Match("phi-5", "G^{NED}", "G"),
         Match("map-2", "T^{NED}", "psi_from_phi.T")), noises=NOISES),
    Map(phi_error, OF_PHI, IN_ENU,
        (Match("phi-4", r"F_{\phi}^{ENU}", "F"), Match("phi-5", "G^{ENU}", "G"),
         Match("map-3", "T^{ENU}", "psi_from_phi.T")), noises=NOISES),
    Map(psi_error_ned, (POSITION, *BY_C), IN_NED,
        (Match("psi-3", r"F_{\psi}^{NED}", "F"), Match("map-2", "(T^{NED})^{-1}", "phi_from_psi.T")), noises=NOISES),
    Map(psi_error, (POSITION, *BY_C), IN_ENU,
        (Match("psi-4", r"F_{\psi}^{ENU}", "F"), Match("map-3", "(T^{ENU})^{-1}", "phi_from_psi.T")), noises=NOISES),
    Map(velocity_attitude,
        (PHI, VELOCITY, Row(r"\delta b_g", "d_gyro_bias"), Row(r"\delta b_a", "d_accel_bias"),
         Row(r"\delta\mu", "dmu"), Row(r"\delta\tau", "d_tau")),
        {"lat_lon_height": "p", "v_n": "v^n", "q_b2n_wxyz": "q_b^n", "q_b2m_wxyz": "q_b^m", "lever_b": r"\ell^b",
         "a_n": "a^n", **SENSED},
        (Match("alignment-1", "F_{16}", "F"), Match("alignment-2", "H_v", "H", ("velocity",)),
         Match("alignment-3", "H_a", "H", ("dcm",))),
        measurements=(Row("z_v", "velocity"), Row("z_a", "dcm"))),
    Map(euler_matching, (Row(r"\epsilon", "eps"), Row(r"\delta\mu", "dmu")),
        {"euler_b": r"[\phi_b; \theta_b; \psi_b]", "mu": r"\mu"},
        (Match("euler-1", "H_e", "H", ("euler_exact",)),), measurements=(Row("z_e", "euler_exact"),)),
)  # fmt: skip

ROWS = "its rows are in F: the matrix is held"
UNFLOWN = {
    **dict.fromkeys(("phi-1", "phi-2", "psi-1", "psi-2"), ROWS),
    "map-1": "the matrix T is held",
    "map-4": "it ties two matrices, each of which is held",
    "transition-1": "the generator makes it of F; tests hold it",
    "transition-2": "the generator's Q has these terms, and higher ones that make it a sum of squares; tests hold both",
}
