"""The paper as a value."""

from boresight.derive.ledger.paper import Paper, Stated, Witness
from boresight.derive.papers.kim_2018.consequences import evidence, findings
from boresight.derive.papers.kim_2018.derived import equations
from boresight.derive.papers.kim_2018.letters import STRUCTURE, letters
from boresight.derive.papers.kim_2018.maps import MAPS, UNFLOWN
from boresight.derive.papers.kim_2018.printed import quantities
from boresight.derive.papers.kim_2018.witness import (
    CONDITIONS,
    CONDITIONS_TEXT,
    ERRORS,
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
    witness=Witness(Base, values, Conditions(), ERRORS, "finite errors"),
    conditions=Stated(CONDITIONS, CONDITIONS_TEXT, 4),
    point=Stated(STATED, STATED_TEXT),
    evidence=evidence,
    findings=findings,
    letters=letters,
    structure=STRUCTURE,
    maps=MAPS,
    unflown=UNFLOWN,
)
