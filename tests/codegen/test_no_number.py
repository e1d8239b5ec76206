"""What is no number is a failure, in every verdict: a comparison with nan is false, on whichever side it stands."""

from math import inf, nan

import numpy as np
import pytest
from flint import arb
from sympy import Integer, Symbol

from boresight.analysis.consistency import Consistency
from boresight.codegen.flown import falls
from boresight.codegen.generate import load_model
from boresight.codegen.mechanics import Verdict
from boresight.codegen.verify import FirstOrderCheck, Part, UnitCheck, relative_width
from boresight.derive.ledger import numbers
from boresight.derive.ledger.evaluate import Point
from boresight.derive.ledger.judge import judge_at, largest_residual
from boresight.derive.ledger.numbers import Matrix
from boresight.derive.within import within
from boresight.evidence.proofs.kept import Output
from boresight.studies.replays.innovations import consistency

ONE, NOT = Matrix([[1]]), Matrix([[arb("nan")]])


@pytest.mark.parametrize("off, limit, holds", [(1, 1, True), (nan, 1, False), (1, nan, False), (inf, inf, False)])
def test_within_holds_numbers_alone(off, limit, holds):
    assert within(off, limit) is holds


def compared(stated, exact, sizes=(1.0,)):
    verdict = Verdict()
    verdict.compare(stated, exact, ["row"], ["column"], [1], list(sizes))
    return verdict


def fallen(left, less, sizes=(1.0,)):
    verdict = Verdict()
    falls(verdict, (left, less), list(sizes), 3, ["row"])
    return verdict


def noted(off):
    verdict = Verdict()
    verdict.note(off, 1.0, "it is off")
    return verdict


def remaining(left, less):
    verdict = Verdict()
    verdict.remainder((left, less), [1.0])
    return verdict


MECHANICS = {
    "what is stated": lambda: compared(NOT, ONE),
    "what is exact": lambda: compared(ONE, NOT),
    "both": lambda: compared(NOT, NOT),
    "the size of a row": lambda: compared(ONE, ONE, [inf]),
    "what a step leaves": lambda: fallen(NOT, ONE),
    "what half a step leaves": lambda: fallen(ONE, NOT),
    "the size of what falls": lambda: fallen(ONE, ONE, [inf]),
    "a correction": lambda: noted(arb("nan")),
    "a float": lambda: noted(nan),
    "the remainder": lambda: remaining(NOT, ONE),
    "half of the remainder": lambda: remaining(ONE, NOT),
}


@pytest.mark.parametrize("what", MECHANICS)
def test_exact_mechanics_fails_what_is_no_number(what):
    check = MECHANICS[what]().check(load_model("phi-error"), "F", "mechanics")
    assert check.ok is False
    assert check.entry


def test_the_same_numbers_pass():
    assert not compared(ONE, ONE).entry
    assert not fallen(Matrix([[8]]), ONE).entry
    assert not remaining(Matrix([[4]]), ONE).entry


RIGHT = {"largest_error": 1e-17, "looseness": 2.0, "zeros_are_zero": True, "width": 1e-60}


@pytest.mark.parametrize("name", ["largest_error", "looseness", "width"])
def test_the_c_fails_where_its_proof_is_no_number(name):
    assert UnitCheck("m", "F", 1, 1, True, **RIGHT).ok
    assert not UnitCheck("m", "F", 1, 1, True, **(RIGHT | {name: nan})).ok
    for parts in ((Part(**RIGHT), Part(**(RIGHT | {name: nan}))), (Part(**(RIGHT | {name: nan})), Part(**RIGHT))):
        total = parts[0] + parts[1]
        assert not UnitCheck("m", "F", 1, 1, True, **vars(total)).ok


def test_a_reference_that_is_no_number_has_no_width():
    assert relative_width({(0, 0): arb(1), (1, 0): arb("nan")}) == inf


@pytest.mark.parametrize("limit, ratio", [(nan, None), (0.0, nan), (nan, 0.5)])
def test_a_first_order_fails_what_is_no_number(limit, ratio):
    assert FirstOrderCheck("m", "H", 0.0, 0.5, 1.0).ok
    assert not FirstOrderCheck("m", "H", limit, ratio, 1.0).ok


def test_the_ledger_refutes_what_has_no_value():
    class Relation:
        sides = (Symbol("a"), Integer(0))

    assert judge_at((Relation,), lambda seed, scale: Point({"a": arb("nan")})).status == "refuted"
    with pytest.raises(ZeroDivisionError):
        largest_residual((Relation,), Point({"a": arb("nan")}))
    for judged in (numbers.middle, numbers.near):
        with pytest.raises(ZeroDivisionError):
            judged(arb("nan"))


@pytest.mark.parametrize("found", [0.0, 1e-16])
def test_a_bound_that_is_no_number_bounds_nothing(found):
    assert Output("F", 1, 1e-16, found).bounded
    assert not Output("F", 1, nan, found).bounded
    assert not Output("F", 1, nan, found).tight


def test_a_flight_that_is_no_number_is_not_consistent():
    judged = Consistency({"x": 1.0})
    for error in (nan, 0.5):
        judged.error(0.0, np.array([[error]]), np.array([[1.0]]))
    assert judged.nees_inside == 0.5
    said = consistency(np.array([[1.0], [nan], [-1.0]]))
    assert said["consistent"] is False and said["white"] is False
