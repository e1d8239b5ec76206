"""Our own derivations as a value."""

from boresight.derive.ledger.paper import Paper, Stated, Witness
from boresight.derive.papers.mechanics.derived import equations
from boresight.derive.papers.mechanics.letters import STRUCTURE, UNITS, quantities
from boresight.derive.papers.mechanics.maps import MAPS, UNFLOWN
from boresight.derive.papers.mechanics.witness import CONDITIONS, CONDITIONS_TEXT, ERRORS, Base, Conditions, values

PAPER = Paper(
    name="mechanics",
    reference="Strapdown navigation and its errors, derived here from exact kinematics",
    make_equations=equations,
    quantities=quantities,
    witness=Witness(Base, values, Conditions(), ERRORS, "exact rates and finite rotations"),
    conditions=Stated(CONDITIONS, CONDITIONS_TEXT, 4),
    point=Stated(CONDITIONS, CONDITIONS_TEXT),
    evidence=lambda number: "",
    findings=tuple,
    structure=STRUCTURE,
    computed={"c": "n"},
    frames={"(map-1).9": "n for c: components in n and c are subtracted: that is the difference of the two errors"},
    units=UNITS,
    maps=MAPS,
    unflown=UNFLOWN,
    conventions=(
        "n is north, east, down and p is latitude, longitude, height, or where a letter says ENU east, north, up and "
        "longitude, latitude, height.",
        "Error = computed - true; C_hat = exp(-[φ x]) C against n, the true level, and exp(-[ψ x]) C_n2c C against c, "
        "the level of the computed position.",
        "States are position, velocity, attitude; of the alignment attitude, velocity, biases, mounting, delay.",
    ),
)
