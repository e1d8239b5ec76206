"""What is decided by hand beside a status: it is said, it is tried the other way, and the rules are kept."""

from dataclasses import replace

import pytest
from sympy import Function, S, Symbol, symbols

from boresight.derive.ledger.differences import Difference, differences, lost_mark, origin
from boresight.derive.ledger.entries import ledger, numbers_of
from boresight.derive.ledger.equation import Relation, column, product, total
from boresight.derive.ledger.evaluate import Point
from boresight.derive.ledger.judge import judge, judge_at, names
from boresight.derive.ledger.numbers import exact
from boresight.derive.papers import PAPERS, paper

pytestmark = pytest.mark.usefixtures("many_digits")

# What each of them would be, and what else was decided.
DEPENDS = {
    "song-lee-2001": {"25": "exact, if δμ is μ - μ̂ (then (19), (26), (27) and (28) would not hold)"},
    "kim-2018": {
        "2": "refuted, if φ̇ is not read as ψ̇",
        "4": "refuted, if Δv_MINS is the master's own error",
        "5": "first-order, if x, y and z are n, r and b",
        "27": "definition, if δ is δl",
        "31": "refuted, if Ω_n is taken as it is printed",
    },
    "kang-2025": {
        "1": "refuted, if the lever arm is not small; refuted, if the ship's velocity is not small",
        "3": "first-order, if the lever arm is small too",
        "6": "exact, if a is its amplitude",
    },
}


@pytest.mark.parametrize("name", PAPERS)
def test_what_depends_on_a_decision_says_so_and_all_else_is_robust(name):
    for entry in ledger(paper(name)):
        if entry.number in DEPENDS[name]:
            assert DEPENDS[name][entry.number] in entry.depends
        else:
            assert entry.depends.startswith("Robust" if entry.decisions else "Nothing."), entry.number


@pytest.mark.parametrize(
    ("number", "small", "status"),
    [
        ("1", ("lever", "v_n", "velocity_error"), "first-order"),
        ("1", ("lever", "velocity_error"), "refuted"),
        ("1", ("v_n", "velocity_error"), "refuted"),
        ("3", ("delay", "step"), "refuted"),
        ("3", ("delay", "step", "lever"), "first-order"),
    ],
)
def test_the_neighbour_decided_on_in_its_place_has_the_status_that_is_shown(number, small, status):
    one = paper("kang-2025")
    equation = replace(one.equation(number), small=small)
    assert judge(one, equation, equation.read()).status == status


def test_a_wave_of_half_the_height_satisfies_the_printed_wave():
    one = paper("kang-2025")
    six, a = one.equation("6"), Symbol("a", real=True)
    halved = tuple(relation.replaced({a: a / 2}) for relation in six.read())
    assert judge(one, six, halved).status == "exact"


@pytest.mark.parametrize("name", PAPERS)
def test_an_open_letter_means_what_saves_the_print_unless_the_derivation_has_none(name):
    order = ("exact", "definition", "first-order", "refuted")
    for equation in paper(name).equations:
        for i, meaning in enumerate(equation.meanings):
            letters = {letter for _, values in meaning.senses for letter, _ in values}
            if meaning.stated_in or not letters & names(equation.derived):
                continue
            statuses = []
            for sense in meaning.senses:
                senses = [m.senses[0] for m in equation.meanings]
                senses[i] = sense
                statuses.append(order.index(judge(paper(name), equation, equation.read(), senses).status))
            assert statuses[0] == min(statuses), equation.label


def test_decisions_are_said():
    entries = {entry.number: entry.decisions for entry in ledger(paper("kim-2018"))}
    for number, piece in (
        ("2", "φ̇ is read as ψ̇: the text over (1) names the psi model"),
        ("2", "f^n is [f_n x] here, and not f_n, which is spelled alike."),
        ("2", "The witness leaves out: errors of the sensors, of the position and of gravity."),
        ("4", "With that meaning (6) would not hold."),
        ("5", "A product of matrices set equal to a vector is the vector of its skew-symmetric part."),
        ("9", "15 other meanings are tried"),
        ("10", "what is dropped is of second order in the position error, the velocity error, the attitude error"),
        ("12", "Small: the step; what is dropped is of second order in it."),
        ("17", "O_3x18 is 0_3x18."),
        ("31", "Ω_n is taken as it is corrected."),
    ):
        assert piece in entries[number], number


# ---- First order -----------------------------------------------------------------------------------------------------


def judged(*rows):
    """The verdict on a relation of columns, each row (left, right) a function of the scale of the errors."""
    x, y = symbols("x:2", real=True), symbols("y:2", real=True)

    def point(seed, scale):
        s = exact(scale)
        values = {x[i].name: left(s) for i, (left, _) in enumerate(rows)}
        return Point(values | {y[i].name: right(s) for i, (_, right) in enumerate(rows)})

    return judge_at([Relation((column(*x[: len(rows)]), column(*y[: len(rows)])))], point)


def test_a_slip_of_first_order_does_not_hide_under_another_rows_remainder():
    large = (lambda s: s + 10**9 * s**2, lambda s: s)
    assert judged(large, (lambda s: s, lambda s: s)).status == "first-order"
    assert judged(large, (lambda s: s + s / 10**6, lambda s: s)).status == "refuted"


def test_what_states_nothing_of_first_order_is_refuted_as_empty():
    verdict = judged((lambda s: 1 + s**2, lambda s: exact(1)))
    assert (verdict.status, verdict.empty) == ("refuted", True)


# ---- Origin ----------------------------------------------------------------------------------------------------------

a, b, c = (Symbol(name, commutative=False) for name in "abc")


@pytest.mark.parametrize(
    ("printed", "derived", "lost"),
    [
        (total(a, product(S.Half, b)), product(S.Half, total(a, b)), "a pair of brackets"),
        (a, Function("norm")(a), "a pair of bars"),
        (Symbol("δ"), Symbol("δl"), "δ for δl"),
        (Symbol("0_3x18"), Symbol("0_3x9"), "0_3x18 for 0_3x9"),
        (Symbol("φ_b"), Symbol("ψ_b"), "φ_b for ψ_b"),
        (Symbol("f_n"), Symbol("v̇"), None),
        (a, -a, None),
        (total(a, b), total(a, b, c), None),
        (total(a, b), product(a, b), None),
    ],
)
def test_a_scan_loses_one_mark_or_takes_look_alikes_and_does_nothing_else(printed, derived, lost):
    (found,) = differences([Relation((a, printed))], [Relation((a, derived))])
    assert isinstance(found, Difference)
    mark = lost_mark(found)
    assert mark is None if lost is None else mark is not None and mark[0] == lost


def test_an_erratum_is_of_the_print_if_one_of_its_slips_is():
    one = paper("kim-2018")
    nine = one.equation("9")
    found = differences(nine.read(), nine.derived)
    assert origin(one, nine, found)[0] == "print"
    assert origin(one, nine, [d for d in found if d.kind == "letter"])[0] == "undecidable"


# ---- Numbers ---------------------------------------------------------------------------------------------------------


def test_numbers_stand_beside_every_slip():
    rows = {n.what: n for n in numbers_of(paper("kim-2018"), paper("kim-2018").equation("9"))}
    assert list(rows) == ["δl̇", "δL̇"]
    for row in rows.values():
        (true,), (printed,), (derived,) = row.true, row.printed, row.derived
        assert abs(derived - true) < abs(printed - true) / 10
        assert row.unit == "deg/h"
