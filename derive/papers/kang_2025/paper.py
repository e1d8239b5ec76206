"""The paper as a value."""

from boresight.derive.ledger.paper import Paper, Stated, Witness
from boresight.derive.papers.kang_2025.consequences import evidence, findings
from boresight.derive.papers.kang_2025.derived import STRUCTURE, equations, letters
from boresight.derive.papers.kang_2025.maps import MAPS, UNFLOWN
from boresight.derive.papers.kang_2025.printed import quantities
from boresight.derive.papers.kang_2025.witness import (
    CONDITIONS,
    CONDITIONS_TEXT,
    ERRORS,
    LEFT_OUT,
    PARTS,
    POINTS,
    STATED,
    STATED_TEXT,
    Base,
    Conditions,
    values,
)

PAPER = Paper(
    name="kang-2025",
    reference="S. H. Kang, S. J. Park, J. W. Jung, T. S. Yoo, Analysis of Transfer Alignment Based on Velocity and "
    "Attitude Matching for Surface Vehicles Under Various Sea States, 2025",
    make_equations=equations,
    quantities=quantities,
    witness=Witness(Base, values, Conditions(), ERRORS, "finite motions", PARTS, LEFT_OUT),
    conditions=Stated(CONDITIONS, CONDITIONS_TEXT, POINTS),
    point=Stated(STATED, STATED_TEXT),
    evidence=evidence,
    findings=findings,
    conventions=(
        "n is north, east, down; S and M are the axes of slave and master: front, right, down.",
        "The lever arm L runs from the master to the slave, in axes of the slave.",
        "z is computed - true, and what the master reports is old by δt_d.",
    ),
    tests={
        "test_lever_arm_runs_from_master_to_slave": "1",
        "test_second_line_of_1_is_the_rate_of_the_lever_arm_exactly": "1",
        "test_straight_line_errs_by_half_the_jerk_times_both_parts_of_the_interval": "2",
        "test_what_3_leaves_out_is_the_acceleration_of_the_lever_arm_times_the_delay": "3",
        "test_printed_brackets_of_4_give_one_and_a_half_times_the_turn": "4",
        "test_only_minus_and_only_the_body_rate_satisfy_5": "5",
        "test_functions_are_the_derived_forms": "3 4 5",
        "test_grades_of_the_code_table": "6",
    },
    letters=letters,
    structure=STRUCTURE,
    maps=MAPS,
    unflown=UNFLOWN,
)
