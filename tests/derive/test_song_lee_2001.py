"""The functions of Song and Lee which the model is made of: small, without tangents, and exact inverses."""

import pytest
from sympy import Float, Matrix, eye, simplify, symbols, tan, zeros

from boresight.derive.ledger.evaluate import DIGITS
from boresight.derive.ledger.numbers import digits, largest, middle
from boresight.derive.ledger.witness import vector
from boresight.derive.mechanics.rotation import dcm_from_euler, skew, vee
from boresight.derive.papers.song_lee_2001 import results as paper
from boresight.derive.papers.song_lee_2001 import witness as world

phi, theta, psi = symbols("phi theta psi", real=True)


def test_inverses_are_inverses():
    assert simplify(paper.eps_D_euler(theta, psi) * paper.euler_D_eps(theta, psi)) == eye(3)
    assert simplify(paper.beta_D_euler(phi, theta) * paper.euler_D_beta(phi, theta)) == eye(3)


@pytest.mark.parametrize("column, angle", [(0, phi), (1, theta), (2, psi)])
def test_columns_are_the_skew_parts_of_the_differentiated_matrix(column, angle):
    C = dcm_from_euler(phi, theta, psi)
    assert simplify(vee(-C.diff(angle) * C.T) - paper.eps_D_euler(theta, psi)[:, column]) == zeros(3, 1)
    assert simplify(vee(C.T * C.diff(angle)) - paper.beta_D_euler(phi, theta)[:, column]) == zeros(3, 1)


def test_body_and_navigation_forms_differ_by_the_attitude():
    """(11): beta = -C_n2b eps."""
    C = dcm_from_euler(phi, theta, psi)
    assert simplify(paper.beta_D_euler(phi, theta) + C.T * paper.eps_D_euler(theta, psi)) == zeros(3, 3)


def test_measurement_matrix_is_the_gradient_of_the_measurement():
    """Through (9) for the slave's error; mu_hat = mu + dmu for the misalignment's."""
    b, r, mu = (Matrix(symbols(names, real=True)) for names in ("p:3", "r:3", "m:3"))
    z = paper.measurement(b, r, mu)
    H = paper.measurement_matrix(b, r)
    assert H[:, 3:] == z.jacobian(mu)
    assert H[:, :3] == z.jacobian(b) * paper.euler_D_eps(b[1], b[2])


def test_measurement_is_the_difference_of_the_angles_where_nothing_is_misaligned():
    b, r = symbols("p:3"), symbols("r:3")
    assert paper.measurement(b, r, (0, 0, 0)) == Matrix(b) - Matrix(r)


def test_feedback_of_the_true_errors_ends_at_the_truth():
    """(23), (24) and (25) in the model's own functions."""
    with digits(DIGITS):
        definitions = {e.number: e.read() for e in paper.equations() if e.defines}
        values = world.world(world.draw(3, world.Conditions()), definitions)
        q = paper.corrected_quaternion(
            [Float(middle(x), DIGITS) for x in values["Q̂(k-)"]], [Float(middle(x), DIGITS) for x in values["ε"]]
        )
        assert (
            max(abs(a.evalf(DIGITS) - Float(middle(b), DIGITS)) for a, b in zip(q, values["Q̂(k+)"], strict=True))
            < 1e-28
        )
        mu, mu_hat, mu_error = (vector(*(values[f"{n}_{axis}"] for axis in "xyz")) for n in ("μ", "μ̂", "δμ"))
        assert largest(paper.corrected_misalignment(mu_hat, mu_error) - mu) < 1e-28


def test_functions_hold_only_what_the_printed_c_knows():
    b, r, mu = symbols("p:3"), symbols("r:3"), symbols("m:3")
    assert not paper.measurement(b, r, mu).has(tan) and not paper.measurement_matrix(b, r).has(tan)


def test_error_model_turns_back_with_the_navigation_axes():
    omega, eps = symbols("w:3"), Matrix(symbols("e:3"))
    assert paper.attitude_error_matrix(omega) == -skew(omega)
    assert paper.attitude_error_matrix(omega) * eps == -Matrix(omega).cross(eps)
