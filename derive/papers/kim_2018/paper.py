"""The paper as a value."""

from boresight.derive.ledger.paper import Paper, Stated, Witness
from boresight.derive.papers.kim_2018.consequences import evidence, findings
from boresight.derive.papers.kim_2018.derived import equations
from boresight.derive.papers.kim_2018.letters import STRUCTURE, UNITS, letters
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
    letters=letters,
    structure=STRUCTURE,
    computed={"c": "n", "p": "n"},
    frames={
        **dict.fromkeys(("Φ̌", "(18).φ", "(19).φ"), "from n to p"),
        "(2).24": "e for i: where the position is known, so is the Earth's rate",
    },
    units=UNITS,
    maps=MAPS,
    unflown=UNFLOWN,
)
