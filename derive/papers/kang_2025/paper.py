"""The paper as a value."""

from boresight.derive.ledger.paper import Paper, Stated, Witness
from boresight.derive.papers.kang_2025.consequences import evidence, findings
from boresight.derive.papers.kang_2025.derived import STRUCTURE, equations, letters
from boresight.derive.papers.kang_2025.printed import quantities
from boresight.derive.papers.kang_2025.witness import (
    CONDITIONS,
    CONDITIONS_TEXT,
    ERRORS,
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
    witness=Witness(Base, values, Conditions(), ERRORS, "finite motions"),
    conditions=Stated(CONDITIONS, CONDITIONS_TEXT, POINTS),
    point=Stated(STATED, STATED_TEXT),
    evidence=evidence,
    findings=findings,
    letters=letters,
    structure=STRUCTURE,
)
