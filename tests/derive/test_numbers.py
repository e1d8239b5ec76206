"""Balls and their matrices: against mpmath, and what they refuse."""

import mpmath as mp
import pytest
from flint import arb

from boresight import BoresightError
from boresight.derive.ledger.numbers import Matrix, digits, exact, eye, largest, middle, norm, shown, sqrt, zeros
from boresight.derive.ledger.witness import finite_rotation, rotation_vector, skew, vector


@pytest.fixture(autouse=True)
def many_digits():
    with digits(50), mp.workdps(50):
        yield


def test_a_finite_rotation_is_mpmaths_exponential():
    v = [exact(x) for x in ("0.3", "-1.2", "0.7")]
    theirs = mp.expm(mp.matrix([[middle(entry) for entry in skew(v)[i, :]] for i in range(3)]))
    assert max(abs(middle(a) - b) for a, b in zip(finite_rotation(v), theirs, strict=True)) < 1e-45


@pytest.mark.parametrize("scale", [1, exact("1e-12"), exact("1e-40"), 0])
def test_a_rotation_vector_survives_the_round_trip_down_to_zero(scale):
    v = vector(exact("0.3"), exact("-1.2"), exact("0.7")) * scale
    assert largest(rotation_vector(finite_rotation(v)) - v) < 1e-45


def test_a_ball_that_knows_too_little_is_no_result():
    with digits(15), pytest.raises(BoresightError, match=r"is known to .* only: compute it with more digits"):
        middle(arb(2).sqrt())
    with pytest.raises(BoresightError, match="more digits"):
        largest([1, arb(0, 1e-20)])


@pytest.mark.parametrize("value", [arb(1) / 0, arb(2).asin(), arb("nan")])
def test_what_is_not_finite_is_no_result(value):
    with pytest.raises(ZeroDivisionError):
        middle(value)


def test_given_numbers_stay_exact():
    assert exact("0.1") * 10 == 1 and exact(0.1) != exact("0.1") and exact(exact(3)) == 3
    assert middle(exact(0.1)) == mp.mpf(0.1)
    assert shown(exact("1e-7") * 3, 2) == "3.0e-7"


def test_a_root_and_a_norm_of_what_may_be_zero_are_known():
    noise = arb(0, 1e-60)
    assert middle(sqrt(noise)) < 1e-29 and middle(norm(Matrix([noise, noise]))) < 1e-50


def test_blocks_of_a_matrix_are_read_and_set_by_slices():
    M = zeros(3, 4)
    M[0:2, 1:3] = Matrix([[1, 2], [3, 4]])
    M[2, 3] = 5
    assert [float(x) for x in M] == [0, 1, 2, 0, 0, 3, 4, 0, 0, 0, 0, 5]
    assert [float(x) for x in M[1, :]] == [0, 3, 4, 0] and [float(x) for x in M[:, 1].T] == [1, 3, 0]
    assert float(M[1:3, 2][0]) == 4


def test_a_system_that_its_balls_do_not_determine_is_refused():
    with pytest.raises(ZeroDivisionError):
        Matrix([[1, 1], [1, arb(1, 1e-40)]]).solve(vector(1, 2))
    assert largest(Matrix([[2, 1], [1, 1]]).inv() * Matrix([[2, 1], [1, 1]]) - eye(2)) == 0
