"""The derivation as a value."""

from boresight.derive.ledger.paper import Paper, Stated, Witness
from boresight.derive.papers.delay_error.derived import STRUCTURE, equations, quantities
from boresight.derive.papers.delay_error.witness import (
    CONDITIONS,
    CONDITIONS_TEXT,
    ERRORS,
    PARTS,
    Base,
    Conditions,
    values,
)

PAPER = Paper(
    name="delay-error",
    reference="Heading error of an unknown delay, derived here",
    make_equations=equations,
    quantities=quantities,
    witness=Witness(Base, values, Conditions(), ERRORS, "finite rotations", PARTS),
    conditions=Stated(CONDITIONS, CONDITIONS_TEXT, 4),
    point=Stated(CONDITIONS, CONDITIONS_TEXT),
    evidence=lambda number: "",
    findings=tuple,
    structure=STRUCTURE,
    units={"x": "3 rad, 3 m/s, 3 rad/s, 3 m/s^2, 3 rad, s"},
)
