"""The paper as a value."""

from boresight.derive.ledger.paper import Paper, Stated, Witness
from boresight.derive.papers.kim_2018.consequences import evidence, findings
from boresight.derive.papers.kim_2018.derived import equations
from boresight.derive.papers.kim_2018.letters import STRUCTURE, letters
from boresight.derive.papers.kim_2018.maps import MAPS, UNFLOWN
from boresight.derive.papers.kim_2018.printed import letters_of, quantities
from boresight.derive.papers.kim_2018.witness import (
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
    name="kim-2018",
    reference="S. Kim, Method for Maintaining Initial Azimuth of Tactical Grade IMU by Using Zero Velocity Update "
    "Algorithm, 2018",
    make_equations=equations,
    quantities=quantities,
    witness=Witness(Base, values, Conditions(), ERRORS, "finite errors", PARTS, LEFT_OUT),
    conditions=Stated(CONDITIONS, CONDITIONS_TEXT, 4),
    point=Stated(STATED, STATED_TEXT),
    evidence=evidence,
    findings=findings,
    letters_of=letters_of,
    conventions=(
        "n is east, north, up; b is right, front, up; p is the computed n, r the axes of the master.",
        "From (8) on φ is the attitude error: the computed attitude is C_b2p = (I - [φ x]) C_b2n.",
        "ψ is the attitude error against the axes at the computed position; (1) to (6) write φ for it.",
    ),
    tests={
        "test_system_matrix_of_ten_states_is_the_derivative_of_the_psi_rates": "2 3",
        "test_measurement_matrices_are_derivatives_of_the_residuals": "6 17 23",
        "test_d_is_how_the_level_turns_against_the_master": "5",
        "test_residuals_and_quaternion_error_are_those_of_the_witness": "4 5 21 29",
        "test_detector_statistics_are_those_of_the_pairs": "31 32",
        "test_system_matrix_of_fifteen_states_is_the_derivative_of_the_exact_rates": "7 9 10 11",
        "test_no_choice_of_rho_saves_the_position_rows": "9",
        "test_printed_sign_of_11_turns_schulers_oscillation_into_growth": "11",
        "test_delay_column_of_6_doubles_a_level_delay_and_does_not_see_a_vertical_one": "6",
        "test_first_order_transition_drops_four_orders_more_at_1_hz_than_at_100_hz": "12",
    },
    letters=letters,
    structure=STRUCTURE,
    maps=MAPS,
    unflown=UNFLOWN,
)
