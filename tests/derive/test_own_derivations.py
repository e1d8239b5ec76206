"""Our own derivations: what SymPy makes of exact kinematics is what makes the C, as zeros of rational functions."""

from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from sympy import Matrix, Poly, Rational, cos, diff, expand, numer, reduced, sin, sqrt, symbols, tan, together

from boresight import BoresightError
from boresight.codegen.functions.dynamics import dynamics
from boresight.codegen.functions.maker import UnitMaker
from boresight.codegen.functions.reference import precise
from boresight.derive.expressions import numeric
from boresight.derive.ledger import ellipsoid
from boresight.derive.ledger.carried import check_maps
from boresight.derive.ledger.entries import entry_of
from boresight.derive.ledger.evaluate import Point, evaluate
from boresight.derive.ledger.judge import EXACT
from boresight.derive.ledger.numbers import digits, exact, eye, largest, zeros
from boresight.derive.mechanics import earth
from boresight.derive.mechanics import error_models as em
from boresight.derive.models.phi_error import phi_error_ned
from boresight.derive.papers import paper
from boresight.derive.papers.mechanics import kinematics

PAPER = paper("mechanics")
FOLDER = Path(kinematics.__file__).parent
LAT, HEIGHT = kinematics.LAT, kinematics.HEIGHT


def test_every_row_holds_by_exact_kinematics_and_its_functions_with_it():
    vector_or_series = ("phi-1", "phi-2", "psi-1", "psi-2", "map-1", "transition-1", "transition-2")
    found = {equation.number: entry_of(PAPER, equation).status for equation in PAPER.equations}
    assert len(found) > len(vector_or_series)
    assert found == {number: "first-order" if number in vector_or_series else "exact" for number in found}


def test_every_row_has_a_function_that_flies_or_a_reason():
    matched = {match.equation for one in PAPER.maps for match in one.matches}
    assert sorted([*matched, *PAPER.unflown]) == sorted(equation.number for equation in PAPER.equations)


# ---------------------------------------------------------------- SymPy's matrices and those of error_models


@cache
def of_the_ellipsoid():
    """WGS-84 and normal gravity in letters of latitude and height; R_N as the curve's tangent has it."""
    a, f, spin = Rational(6378137), 1 / Rational("298.257223563"), Rational("7.292115e-5")
    equator, pole, mass = Rational("9.7803253359"), Rational("9.8321849379"), Rational("3.986004418e14")
    s, c, b = sin(LAT), cos(LAT), a * (1 - f)
    R_E = a / sqrt(1 - f * (2 - f) * s**2)
    R_N = -diff(R_E * c, LAT) / s
    ground = (a * equator * c**2 + b * pole * s**2) / sqrt(a**2 * c**2 + b**2 * s**2)
    outwards = 1 - 2 / a * (1 + f + spin**2 * a**2 * b / mass - 2 * f * s**2) * HEIGHT + 3 / a**2 * HEIGHT**2
    gravity = ground * outwards
    k = kinematics
    return {
        k.R_NN: diff(R_N, LAT), k.R_EE: diff(R_E, LAT), k.G_L: diff(gravity, LAT), k.G_H: diff(gravity, HEIGHT),
        k.G: gravity, k.R_N: R_N, k.R_E: R_E, k.SPIN: spin,
    }  # fmt: skip


def vanishes(expression):
    """Whether an expression of the latitude's sine and cosine and of roots over the ellipse is zero everywhere: the
    numerator, modulo s^2 + c^2 = 1 and w^2 = 1 - e^2 s^2."""
    s, c, w = symbols("s c w")
    e2 = 1 - (1 - 1 / Rational("298.257223563")) ** 2
    plain = expression.subs(of_the_ellipsoid()).subs(tan(LAT), s / c).subs({sin(LAT): s, cos(LAT): c})

    def root(power):
        base = expand(power.base.subs(c**2, 1 - s**2))
        size = base.subs(s, 0)
        assert expand(base - size * (1 - e2 * s**2)) == 0
        return (sqrt(size) * w) ** (2 * power.exp)

    plain = plain.replace(lambda x: x.is_Pow and x.exp.is_Rational and x.exp.q == 2 and not x.base.is_number, root)
    top = Poly(numer(together(plain)), s, c, w).as_expr()
    return expand(reduced(top, [c**2 + s**2 - 1, w**2 + e2 * s**2 - 1], c, w)[1]) == 0


# One frame for each: the rows of the ledger hold both.
@pytest.mark.parametrize(("model", "name"), [("phi", "NED"), ("psi", "ENU"), ("map", "NED")])
def test_the_differentiated_rates_are_the_matrices_that_fly_entry_by_entry(model, name):
    level, frame = ellipsoid.LEVELS[name], earth.FRAMES[name]
    p, v, f = kinematics.state(level)
    mine, flown = {
        "phi": (kinematics.F_phi, lambda: em.phi_matrix(frame, p, v, f)),
        "psi": (kinematics.F_psi, lambda: em.psi_matrix(frame, p, v, f)),
        "map": (kinematics.T_psi, lambda: em.psi_from_phi(frame, p, v)),
    }[model]
    difference = Matrix(mine(level)) - numeric(flown())
    assert [place for place, entry in difference.todok().items() if not vanishes(entry)] == []
    # and it would be seen: 1e-9 of one entry
    spoilt = next(e for e in numeric(flown()) if e.has(LAT) and not e.is_number)
    assert not vanishes(spoilt * Rational(1, 10**9))


def test_kinematics_takes_nothing_of_what_it_is_held_against():
    for path in FOLDER.glob("*.py"):
        text = path.read_text()
        assert "derive.mechanics" not in text and "derive.models" not in text
    for module in ("ellipsoid", "navigation", "witness"):
        assert "derive.mechanics" not in (FOLDER.parent.parent / "ledger" / f"{module}.py").read_text()


def test_an_edit_of_the_functions_is_refused_with_its_entry():
    spoilt = []
    for one in PAPER.maps:
        if one.model().name == "phi-error-ned":

            def edited(model=one.model):
                made = model()
                F = Matrix(made.F)
                F[3, 4] += earth.omega_ie_n(made.inputs[0].symbols[0])[2]  # of the 2 of Coriolis
                return replace(made, F=F)

            spoilt.append(replace(one, model=edited))
    changed = replace(PAPER, maps=tuple(spoilt))
    with pytest.raises(BoresightError, match=r"differ in \[dv_n, dv_e\]"):
        check_maps(changed, "phi-3")


# ---------------------------------------------------------------- Phi and Q


def test_the_generators_phi_is_that_of_the_row_and_its_q_differs_by_what_makes_it_squares():
    """By those terms alone, of which the first has the fourth power of the step: the row ends with the third."""
    made = phi_error_ned()
    units = {unit.name: unit.reference for unit in dynamics(UnitMaker(made))}
    inputs = {v.name: [0.3 + 0.1 * k for k in range(v.size)] for v in made.inputs}

    def matrix(name):
        found = zeros(9)
        for place, value in units[name](inputs)[0].items():
            found[place] = value
        return found

    with digits(60), precise():
        F, S, step = matrix("F"), matrix("Qc"), exact(0.3)
        at = Point({"F": F, "S": S, "Δt": step, "I_9": eye(9)})
        once = F * F * S * F.T
        squares = (once + once.T) * step**4 / 9 + once * F.T * step**5 / 27
        for number, name, higher in (("transition-1", "Phi", zeros(9)), ("transition-2", "Q", squares)):
            (row,) = PAPER.equation(number).derived
            assert largest(evaluate(row.sides[1], at) + higher - matrix(name)) < EXACT
        assert largest(squares) > 1e-6  # seen at this step
