"""The paper's states, inputs and rows, and those of the model that makes C from it."""

from boresight.derive.ledger.map import Map, Match, Row
from boresight.derive.models.euler_matching import euler_matching
from boresight.derive.papers.song_lee_2001.derived import (
    GAP,
    HAT_B,
    HAT_R,
    MU_HAT,
    STATE_MATRIX,
    STATE_NOISE,
    STATES_MEASURED,
    TRUE_B,
    TRUE_R,
    column,
)

BY_MU = r"A_1({})^{{-1}} R_1({})"  # of angles of the master

MATCHING = Map(
    model=euler_matching,
    states=(Row(r"\epsilon^n", "eps"), Row(r"\delta\mu^r", "dmu")),
    noises=(Row(r"\delta\omega^b", "gyro_noise"),),
    inputs={
        "omega_in_n": r"\omega_{in}^n",
        "q_b2n_wxyz": r"\hat{Q}_b^n(k^+)",
        "euler_b": column(*TRUE_B),
        "euler_m": column(*TRUE_R),
        "mu": r"\mu^r",
    },
    measurements=(Row("Z", "euler"), Row("Z", "euler_exact")),
    matches=(
        Match("14", f"{column(*TRUE_B)} - {column(*GAP)}", "z", ("euler_exact",), {"euler_m": column("0", "0", "0")}),
        Match("16", column(*HAT_B), "euler_angles.euler_b", (), {"q_b2n_wxyz": r"\hat{Q}_b^n(k^-)"}),
        Match(
            "16",
            f"{column(*HAT_B)} - {column(*HAT_R)} - {BY_MU.format(HAT_R[1], HAT_R[0])} {MU_HAT}",
            "z",
            ("euler",),
            {"euler_b": column(*HAT_B), "euler_m": column(*HAT_R), "mu": r"\hat{\mu}^r"},
        ),
        Match(
            "18",
            f"-{BY_MU.format(TRUE_R[1], TRUE_R[0])} {MU_HAT}",
            "z",
            ("euler",),
            {"euler_b": column(*TRUE_R), "mu": r"\hat{\mu}^r"},
        ),
        Match("19", STATES_MEASURED, "H", ("euler",)),
        Match("20", STATE_MATRIX, "F"),
        Match("20", STATE_NOISE, "G"),
        Match(
            "24",
            r"\hat{Q}_b^n(k^+)",
            "feedback.q_b2n_wxyz",
            (),
            {"q_b2n_wxyz": r"\hat{Q}_b^n(k^-)", "eps": r"\epsilon^n"},
        ),
        Match(
            "25",
            r"\hat{\mu}^r(k^+)",
            "feedback.mu",
            (),
            {"mu": r"\hat{\mu}^r(k^-)", "dmu": r"\delta\mu^r(k)"},
        ),
    ),
)
MAPS = (MATCHING,)

ERRORS_OF_ANGLES = "what an error is, in which all are written; no function computes an error"
ON_THE_WAY = "a step on the way to (9) and (13), the blocks of H in (19)"
UNFLOWN = {
    **dict.fromkeys("123", ERRORS_OF_ANGLES),
    **dict.fromkeys(("4", "5", "6", "7", "8", "10", "11", "12"), ON_THE_WAY),
    "9": "the first block of H in (19)",
    "13": "the second block of H in (19), at the angles of the master",
    "15": "it is (18) for the true misalignment, which no function knows",
    "17": "a step on the way to (19)",
    "21": "the zeros of F in (20)",
    "22": "the order of the states, which this map has",
    "23": "it is within the function of (24)",
    **dict.fromkeys(("26", "27", "28"), "a row of (16) and (19), which a filter takes alone"),
}
