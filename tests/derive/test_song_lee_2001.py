"""The functions of Song and Lee which the model is made of, and what the paper drops."""

import math

import pytest
from sources import needs_source, source
from sympy import Matrix, eye, simplify, symbols, tan, zeros
from witnessed import symbols_at

from boresight import BoresightError
from boresight.derive.ledger.entries import findings, ledger
from boresight.derive.ledger.evaluate import DIGITS, Point, residual
from boresight.derive.ledger.numbers import largest
from boresight.derive.ledger.witness import draw, scaled, vector
from boresight.derive.mechanics.rotation import dcm_from_euler, skew, vee
from boresight.derive.papers import paper, python
from boresight.derive.papers.built_in import built_in
from boresight.derive.papers.song_lee_2001 import consequences, results
from boresight.derive.papers.song_lee_2001.witness import ERRORS, Base, Conditions, values

PAPER = paper("song-lee-2001")

pytestmark = pytest.mark.usefixtures("many_digits")

phi, theta, psi = symbols("phi theta psi", real=True)


@pytest.mark.equations("8 9 12 13")
def test_inverses_are_inverses():
    assert simplify(results.eps_D_euler(theta, psi) * results.euler_D_eps(theta, psi)) == eye(3)
    assert simplify(results.beta_D_euler(phi, theta) * results.euler_D_beta(phi, theta)) == eye(3)


@pytest.mark.parametrize("column, angle", [(0, phi), (1, theta), (2, psi)])
@pytest.mark.equations("8 12")
def test_columns_are_the_skew_parts_of_the_differentiated_matrix(column, angle):
    C = dcm_from_euler(phi, theta, psi)
    assert simplify(vee(-C.diff(angle) * C.T) - results.eps_D_euler(theta, psi)[:, column]) == zeros(3, 1)
    assert simplify(vee(C.T * C.diff(angle)) - results.beta_D_euler(phi, theta)[:, column]) == zeros(3, 1)


@pytest.mark.equations("8 11 12")
def test_body_and_navigation_forms_differ_by_the_attitude():
    """(11): beta = -C_n2b eps."""
    C = dcm_from_euler(phi, theta, psi)
    assert simplify(results.beta_D_euler(phi, theta) + C.T * results.eps_D_euler(theta, psi)) == zeros(3, 3)


@pytest.mark.equations("19")
def test_measurement_matrix_is_the_gradient_of_the_measurement():
    """Through (9) for the slave's error; mu_hat = mu + dmu for the misalignment's."""
    b, r, mu = (Matrix(symbols(names, real=True)) for names in ("p:3", "r:3", "m:3"))
    z = results.measurement(b, r, mu)
    H = results.measurement_matrix(b, r)
    assert H[:, 3:] == z.jacobian(mu)
    assert H[:, :3] == z.jacobian(b) * results.euler_D_eps(b[1], b[2])


def test_measurement_is_the_difference_of_the_angles_where_nothing_is_misaligned():
    b, r = symbols("p:3"), symbols("r:3")
    assert results.measurement(b, r, (0, 0, 0)) == Matrix(b) - Matrix(r)


@pytest.mark.equations("22 23 24 25")
def test_feedback_of_the_true_errors_ends_at_the_truth():
    """(23), (24) and (25) in the model's own functions."""
    known = values(draw(Base, 3, Conditions()), PAPER.definitions)
    q = results.corrected_quaternion(symbols_at(known["Q̂(k-)"]), symbols_at(known["ε"]))
    assert max(map(abs, (Matrix(q) - symbols_at(known["Q̂(k+)"])).evalf(DIGITS))) < 1e-28
    mu, mu_hat, mu_error = (vector(*(known[f"{n}_{axis}"] for axis in "xyz")) for n in ("μ", "μ̂", "δμ"))
    assert largest(results.corrected_misalignment(mu_hat, mu_error) - mu) < 1e-28


def test_functions_hold_only_what_the_printed_c_knows():
    b, r, mu = symbols("p:3"), symbols("r:3"), symbols("m:3")
    assert not results.measurement(b, r, mu).has(tan) and not results.measurement_matrix(b, r).has(tan)


@pytest.mark.equations("20")
def test_error_model_turns_back_with_the_navigation_axes():
    omega, eps = symbols("w:3"), Matrix(symbols("e:3"))
    assert results.attitude_error_matrix(omega) == -skew(omega)
    assert results.attitude_error_matrix(omega) * eps == -Matrix(omega).cross(eps)


# ---- The ledger ------------------------------------------------------------------------------------------------------


def test_a_wrong_function_is_refused_as_a_derivation(monkeypatch):
    right = results.euler_D_eps
    monkeypatch.setattr(results, "euler_D_eps", lambda theta, psi: right(theta, -psi))
    with pytest.raises(BoresightError, match=r"\(9\), line 5, .*of the difference in row 1"):
        ledger(built_in.__wrapped__(PAPER.name, python(PAPER.name)))


def test_an_erratum_shows_print_and_derivation_as_latex_and_as_numbers():
    nine = next(entry for entry in ledger(PAPER) if entry.number == "9")
    assert nine.derived.count(r"\psi") == 7 and nine.printed.count(r"\psi") == 1
    assert "true [6.0, -12.0, 18.0]" in nine.evidence


def test_reading_the_error_of_the_misalignment_the_other_way_refutes_19():
    """Which of (25) and the rest is wrong: with dmu = mu - mu_hat (25) would stand, and (19) would not."""

    def left(relations, scale):
        known = dict(values(draw(Base, 1, scaled(Conditions(), scale, ERRORS)), PAPER.definitions))
        known |= {name: -value for name, value in known.items() if "δμ" in name}
        return largest(x for relation in relations for x in residual(relation.sides, Point(known)))

    assert left(PAPER.equation("25").read(), 1.0) < 1e-28
    nineteen = PAPER.equation("19").derived[:1]
    assert left(nineteen, 5e-7) > 0.4 * left(nineteen, 1e-6)


# ---- What the paper drops --------------------------------------------------------------------------------------------


@pytest.mark.equations("15 18")
def test_second_order_term_is_what_the_first_order_misses():
    left = []
    for scale in (1e-3, 5e-4):
        base = draw(Base, 5, scaled(Conditions(), scale, ERRORS))
        known = values(base, PAPER.definitions)
        exact = symbols_at([known[name] for name in ("Δφ", "Δθ", "Δψ")])
        parts = [symbols_at(part) for part in (base.euler_r, base.mu)]
        terms = results.relative_euler(*parts) + results.relative_euler_second_order(*parts)
        left.append(max(map(abs, (exact - terms).evalf(DIGITS))))
    assert left[0] / left[1] == pytest.approx(8, rel=0.01)


def test_mean_of_master_and_slave_angles_has_no_second_order():
    left = []
    for scale in (1e-3, 5e-4):
        base = draw(Base, 5, scaled(Conditions(), scale, ERRORS))
        known = values(base, PAPER.definitions)
        mu, exact = symbols_at(base.mu), symbols_at([known[name] for name in ("Δφ", "Δθ", "Δψ")])
        angles = (symbols_at([known[f"{a}_{owner}"] for a in "φθψ"]) for owner in "rb")
        mean = sum((results.relative_euler(euler, mu) for euler in angles), zeros(3, 1)) / 2
        left.append(max(map(abs, (exact - mean).evalf(DIGITS))))
    assert left[0] / left[1] == pytest.approx(8, rel=0.01)


@pytest.mark.parametrize("row", [0, 1, 2])
@pytest.mark.equations("26 27 28")
def test_slave_angles_in_place_of_master_angles_turn_the_second_order_error_round(row):
    with_master, with_slave = consequences.substitution(row)
    assert with_master * with_slave < 0
    assert abs(with_slave) == pytest.approx(abs(with_master), rel=0.1)
    assert abs(with_master) > math.pi / 10800  # arcmin: above the master's noise, not negligible


def test_table_1_obeys_its_rule_and_the_conclusion_counts_it_right():
    assert [cell for row in consequences.TABLE_1 for cell in row.split()] == consequences.composed()
    assert "13, 12, 21, 3 cells" in findings(PAPER)[0] and "as the conclusion says" in findings(PAPER)[0]


@needs_source
def test_table_1_stands_at_its_lines():
    lines = source(PAPER.name)
    first, last = consequences.TABLE_1_LINES
    for row, line in zip(consequences.TABLE_1, lines[first - 1 : last], strict=True):
        cells = [cell.replace(" ", "") for cell in line.strip().strip("|").split("|")[2:]]
        assert row.replace("o", "○").split() == cells
