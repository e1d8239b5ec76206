"""The paper as a value."""

from boresight.derive.ledger.paper import Paper, Stated, Witness
from boresight.derive.papers.song_lee_2001.consequences import evidence, findings
from boresight.derive.papers.song_lee_2001.derived import equations
from boresight.derive.papers.song_lee_2001.letters import STRUCTURE, letters
from boresight.derive.papers.song_lee_2001.maps import MAPS, UNFLOWN
from boresight.derive.papers.song_lee_2001.printed import quantities
from boresight.derive.papers.song_lee_2001.witness import (
    CONDITIONS,
    CONDITIONS_TEXT,
    ERRORS,
    LEFT_OUT,
    PARTS,
    STATED,
    STATED_TEXT,
    Base,
    Conditions,
    values,
)

PAPER = Paper(
    name="song-lee-2001",
    reference="K. W. Song and S. J. Lee, The Kalman Filter Design for the Transfer Alignment by Euler Angle Matching, "
    "Journal of Control, Automation and Systems Engineering, 2001",
    make_equations=equations,
    quantities=quantities,
    witness=Witness(Base, values, Conditions(), ERRORS, parts=PARTS, left_out=LEFT_OUT),
    conditions=Stated(CONDITIONS, CONDITIONS_TEXT, 16),
    point=Stated(STATED, STATED_TEXT),
    evidence=evidence,
    findings=findings,
    letters=letters,
    structure=STRUCTURE,
    maps=MAPS,
    unflown=UNFLOWN,
    conventions=(
        "n is north, east, down; b and r are the axes of slave and master: front, right, down.",
        "φ, θ, ψ are roll, pitch and yaw: C_b2n(φ, θ, ψ) = Rz(ψ) Ry(θ) Rx(φ).",
        "ε turns the true navigation axes to the computed ones, μ turns r to b.",
    ),
    tests={
        "test_inverses_are_inverses": "8 9 12 13",
        "test_columns_are_the_skew_parts_of_the_differentiated_matrix": "8 12",
        "test_body_and_navigation_forms_differ_by_the_attitude": "8 11 12",
        "test_measurement_matrix_is_the_gradient_of_the_measurement": "19",
        "test_error_model_turns_back_with_the_navigation_axes": "20",
        "test_feedback_of_the_true_errors_ends_at_the_truth": "22 23 24 25",
        "test_second_order_term_is_what_the_first_order_misses": "15 18",
        "test_slave_angles_in_place_of_master_angles_turn_the_second_order_error_round": "26 27 28",
    },
)
