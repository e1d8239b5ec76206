"""The ledgers: statuses from the witnesses, errata with kind and origin, and what a ledger refuses."""

from dataclasses import replace

import pytest

from boresight import BoresightError
from boresight.derive.ledger.differences import differences, origin
from boresight.derive.ledger.entries import entry_of, ledger
from boresight.derive.ledger.equation import Relation, negative, total
from boresight.derive.ledger.evaluate import residual
from boresight.derive.ledger.judge import judge, largest_residual, witness_point
from boresight.derive.ledger.mutation import free_values
from boresight.derive.ledger.numbers import largest
from boresight.derive.papers import PAPERS, paper

pytestmark = pytest.mark.usefixtures("many_digits")

STATUS = {
    "song-lee-2001": {
        "definition": "1 2 3 4 14 16 δμ 22",
        "exact": "17 21 23 24",
        "first-order": "5 6 12 13 15 18 19 20",
        "erratum": "7 8 9 10 B 11 25 26 27 28",
    },
    "kim-2018": {
        "definition": "1 4 8 15 16 22 28 30",
        "exact": "3 13 14 24 25 26 31",
        "first-order": "2 7 10 12 18 19",
        "erratum": "5 6 9 11 17 20 21 23 27 29 32 Ω_n",
    },
    "kang-2025": {"definition": "", "exact": "", "first-order": "1 2", "erratum": "3 4 5 6"},
    "delay-error": {"first-order": "1 2 3 4 5"},
}
ORIGIN = {
    "song-lee-2001": {
        ("letter", "undecidable"): "7 10 B 11",
        ("letter", "transcription"): "8 9 26 27 28",
        ("sign", "print"): "25",
    },
    "kim-2018": {
        ("structure", "print"): "6 9 20 29 Ω_n",
        ("structure", "undecidable"): "32",
        ("letter", "undecidable"): "5 21 27",
        ("sign", "print"): "11",
        ("shape", "undecidable"): "17 23",
    },
    "kang-2025": {("structure", "print"): "3 5 6", ("structure", "undecidable"): "4"},
}
READINGS = {"song-lee-2001": "25 26 27 28", "kim-2018": "2 12", "kang-2025": "6"}
# Derived forms whose remainder falls fourfold when the errors are halved; eightfold: a skew-symmetric part.
FALLS = {
    4: {
        "song-lee-2001": STATUS["song-lee-2001"]["first-order"],
        "kim-2018": STATUS["kim-2018"]["first-order"] + " 5 9 11 20 29",
        "kang-2025": "1 2 3 5",
    },
    8: {"kim-2018": "21", "kang-2025": "4"},
}


def each(table):
    """(paper, number) of every number in a table of strings by paper."""
    return [(name, number) for name, numbers in table.items() for number in numbers.split()]


@pytest.mark.parametrize("name", STATUS)
def test_every_numbered_equation_is_there_once_and_in_order_with_the_status_that_follows(name):
    entries = ledger(paper(name))
    assert len(entries) == sum(len(numbers.split()) for numbers in STATUS[name].values())
    numbers = [int(entry.number) for entry in entries if entry.number.isdigit()]
    assert numbers == list(range(1, len(numbers) + 1))
    for status, numbers in STATUS[name].items():
        assert [entry.number for entry in entries if entry.status == status] == numbers.split()


@pytest.mark.parametrize("name", PAPERS)
def test_kind_and_origin_belong_to_errata_alone_and_follow_the_rule(name):
    found = {entry.number: (entry.kind, entry.origin) for entry in ledger(paper(name)) if entry.kind or entry.origin}
    assert found == {number: both for both, numbers in ORIGIN[name].items() for number in numbers.split()}


@pytest.mark.parametrize("name", PAPERS)
def test_an_entry_is_the_documented_row_of_strings(name):
    for entry in ledger(paper(name)):
        row = entry.to_dict()
        assert list(row) == [
            *("paper", "number", "status", "kind", "origin", "printed", "derived", "note", "evidence"),
            *("found", "decisions", "depends"),
        ]
        assert all(isinstance(value, str) for value in row.values())


@pytest.mark.parametrize("name", PAPERS)
def test_derived_form_is_the_print_where_the_print_holds(name):
    one = paper(name)
    for equation, entry in zip(one.equations, ledger(one), strict=True):
        if entry.status == "erratum":
            continue
        for ours, theirs in zip(equation.derived, equation.read(), strict=False):
            point = free_values(one, equation)
            try:
                pairs = list(zip(residual(ours.sides, point), residual(theirs.sides, point), strict=True))
            except ValueError:  # values drawn freely may not be below their limits
                assert ours == theirs, entry.number
            else:
                assert largest(a - b for a, b in pairs) < 1e-30, entry.number


@pytest.mark.parametrize(
    ("name", "number", "factor"),
    [(*pair, factor) for factor, table in FALLS.items() for pair in each(table)],
)
def test_remainder_of_the_derived_form_falls_at_its_order_when_the_errors_are_halved(name, number, factor):
    one = paper(name)
    equation = one.equation(number)
    sizes = [
        largest_residual(equation.derived, witness_point(one, 11, scale, equation.small)) for scale in (1e-3, 5e-4)
    ]
    assert sizes[0] / sizes[1] == pytest.approx(factor, rel=0.02)


@pytest.mark.parametrize("name", PAPERS)
def test_an_equation_that_needs_no_reading_has_none(name):
    assert [e.number for e in paper(name).equations if e.readings] == READINGS[name].split()


@pytest.mark.parametrize(("name", "number"), [pair for pair in each(READINGS) if pair[0] != "kang-2025"])
def test_a_reading_is_there_only_because_the_letter_as_printed_fails(name, number):
    one = paper(name)
    equation = one.equation(number)
    for reading in equation.readings:
        literal = tuple(relation.replaced({reading.meant: reading.printed}) for relation in equation.derived)
        assert judge(one, equation, literal).status == "refuted", reading


@pytest.mark.parametrize("number", ["1", "2", "3", "14", "16", "22"])
def test_a_definition_contradicts_nothing_and_a_wrong_one_something(number):
    one = paper("song-lee-2001")
    equation = one.equation(number)
    (relation,) = equation.printed
    twice = Relation((relation.sides[0], total(relation.sides[1], relation.sides[1])))
    verdict = judge(one, equation, (twice,))
    assert verdict.status == "refuted" and verdict.why.startswith("contradicted by ("), number


@pytest.mark.parametrize(("name", "number"), [("kim-2018", "11"), ("kang-2025", "5")])
def test_a_wrong_derivation_is_named_and_not_reported(name, number):
    """With the print taken for derived, an erratum would accuse itself."""
    one = paper(name)
    wrong = replace(one.equation(number), derived=one.equation(number).printed)
    with pytest.raises(BoresightError, match=rf"\({number}\): the derived form itself is refuted"):
        entry_of(one, wrong)


def test_a_wrong_name_lists_the_right_ones():
    with pytest.raises(BoresightError, match="no paper 'song-lee': the papers are song-lee-2001, kim-2018, kang-2025"):
        paper("song-lee")


def test_kind_is_read_off_the_trees():
    equation = paper("song-lee-2001").equation("25")
    (relation,) = equation.read()
    left, right = relation.sides

    def kinds(*sides):
        return {difference.kind for difference in differences([Relation(sides)], equation.derived)}

    assert kinds(left, right) == {"sign"}
    assert kinds(left, right.args[0]) == {"structure"}
    assert kinds(right.args[1], equation.derived[0].sides[1]) == {"letter"}
    assert kinds(left, total(right.args[0], negative(right.args[1]))) == set()


def test_an_erratum_in_a_letter_no_eye_confuses_is_the_print():
    one = paper("song-lee-2001")
    nine, letters = one.equation("9"), {quantity.symbol.name: quantity.symbol for quantity in one.quantities()}
    swapped = nine.derived[0].replaced({letters["ψ"]: letters["θ"], letters["θ"]: letters["ψ"]})
    assert origin(one, nine, differences([swapped], nine.derived))[0] == "print"
