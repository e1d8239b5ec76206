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
    computed={"r": "b"},  # but for the misalignment
    frames={
        **dict.fromkeys(("ΔQ", "ΔQ(k)"), "n to n'"),  # which the print calls one of b to n
        **dict.fromkeys(("∂C/∂φ", "∂C/∂θ", "∂C/∂ψ", "ΔC"), "b to n"),
        "(11).4": "n for n', b for b': exp(-E) turns within n",
        **dict.fromkeys(("(20).6", "(20).7"), "n for n': the rate of n is taken for that of n'"),
    },
    maps=MAPS,
    unflown=UNFLOWN,
    conventions=(
        "n is north, east, down; b and r are the axes of slave and master: front, right, down.",
        "φ, θ, ψ are roll, pitch and yaw: C_b2n(φ, θ, ψ) = Rz(ψ) Ry(θ) Rx(φ).",
        "ε turns the true navigation axes to the computed ones, μ turns r to b.",
    ),
)
