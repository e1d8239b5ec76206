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
    letters=letters,
    structure=STRUCTURE,
    frames={"frame S": "b"},
    maps=MAPS,
    unflown=UNFLOWN,
)
