"""The ledger of Song and Lee: statuses from finite rotations, errata with kind and origin, and what it refuses."""

import math

import pytest
from sources import needs_source, source
from sympy import Float, Matrix

from boresight import BoresightError
from boresight.derive.ledger import entries as led
from boresight.derive.ledger.entries import differences, equations, findings, judge, ledger
from boresight.derive.ledger.equation import Relation, negative, total
from boresight.derive.ledger.evaluate import DIGITS, Point, residual
from boresight.derive.ledger.numbers import digits, largest, middle
from boresight.derive.papers.song_lee_2001 import printed
from boresight.derive.papers.song_lee_2001 import results as paper
from boresight.derive.papers.song_lee_2001 import witness as world

PAPER = "song-lee-2001"
EXPECTED = {
    "definition": ("1", "2", "3", "14", "16", "22"),
    "exact": ("4", "17", "21", "23", "24"),
    "first-order": ("5", "6", "12", "13", "15", "18", "19", "20"),
    "erratum": ("7", "8", "9", "10", "11", "25", "26", "27", "28"),
}


@pytest.fixture(scope="module")
def entries():
    return {entry.number: entry for entry in ledger(PAPER)}


@pytest.fixture(scope="module")
def by_number():
    return {equation.number: equation for equation in equations(PAPER)}


@pytest.fixture(autouse=True)
def many_digits():
    with digits(DIGITS):
        yield


def symbols_at(values):
    """Numbers of the witness as SymPy's, all digits kept."""
    return Matrix([Float(middle(value), DIGITS) for value in values])


def test_every_numbered_equation_is_in_the_ledger_once_and_in_order(entries):
    assert list(entries) == [str(n) for n in range(1, 29)]


@pytest.mark.parametrize("status, numbers", EXPECTED.items(), ids=list(EXPECTED))
def test_status_follows_from_the_witness(entries, status, numbers):
    assert tuple(n for n, entry in entries.items() if entry.status == status) == numbers


def test_kind_and_origin_belong_to_errata_alone_and_follow_the_rule(entries):
    origins = {n: (entry.kind, entry.origin) for n, entry in entries.items() if entry.kind or entry.origin}
    copied, scripts = ("letter", "transcription"), ("letter", "undecidable")
    assert origins == {
        **dict.fromkeys(("7", "10", "11"), scripts),
        **dict.fromkeys(("8", "9", "26", "27", "28"), copied),
        "25": ("sign", "print"),
    }


def test_an_entry_is_the_documented_row_of_strings(entries):
    row = entries["9"].to_dict()
    assert list(row) == ["paper", "number", "status", "kind", "origin", "printed", "derived", "note", "evidence"]
    assert all(isinstance(value, str) for value in row.values())
    assert r"\phi" in row["printed"] and r"\psi" in row["derived"] and "true [6.0, -12.0, 18.0]" in row["evidence"]


def test_derived_form_is_the_print_where_the_print_holds(entries, by_number):
    from boresight.derive.ledger.mutation import _free_point

    for number, equation in by_number.items():
        if entries[number].status == "erratum":
            continue
        for ours, theirs in zip(equation.derived, equation.read(), strict=False):
            point = _free_point(equation)
            pairs = zip(residual(ours.sides, point), residual(theirs.sides, point), strict=True)
            assert largest(a - b for a, b in pairs) < 1e-30, number


@pytest.mark.parametrize("number", EXPECTED["first-order"])
def test_first_order_remainder_falls_fourfold_when_errors_are_halved(by_number, number):
    equation = by_number[number]
    sizes = []
    for scale in (1e-3, 5e-4):
        point = led.witness_point(PAPER, 11, scale, equation.small)
        sizes.append(largest(x for relation in equation.derived for x in residual(relation.sides, point)))
    assert sizes[0] / sizes[1] == pytest.approx(4, rel=0.01)


@pytest.mark.parametrize("number", ["25", "26", "27", "28"])
def test_a_reading_is_there_only_because_the_letter_as_printed_fails(by_number, number):
    equation = by_number[number]
    assert judge(equation, equation.derived).status != "refuted"
    for reading in equation.readings:
        literal = tuple(relation.replaced({reading.meant: reading.printed}) for relation in equation.derived)
        assert judge(equation, literal).status == "refuted", reading


def test_an_equation_that_needs_no_reading_has_none(by_number):
    assert {n for n, equation in by_number.items() if equation.readings} == {"25", "26", "27", "28"}


def test_a_corrected_definition_contradicts_nothing_and_a_wrong_one_something(by_number):
    for number in EXPECTED["definition"]:
        equation = by_number[number]
        assert judge(equation, equation.printed).status == "definition"
        (relation,) = equation.printed
        twice = Relation((relation.sides[0], total(relation.sides[1], relation.sides[1])))
        verdict = judge(equation, (twice,))
        assert verdict.status == "refuted" and verdict.why.startswith("contradicted by ("), number


def test_reading_the_error_of_the_misalignment_the_other_way_refutes_19(by_number):
    """Which of (25) and the rest is wrong: with dmu = mu - mu_hat (25) would stand, and (19) would not."""
    other = {name: -value for name, value in world.world(world.STATED, led._definitions(PAPER)).items() if "δμ" in name}

    def holds(number, relations, scale):
        conditions = world.Conditions().scaled(scale)
        values = world.world(world.draw(1, conditions), led._definitions(PAPER))
        values |= {name: -values[name] for name in other if name in values}
        return largest(x for relation in relations for x in residual(relation.sides, Point(values)))

    assert holds("25", by_number["25"].read(), 1.0) < 1e-28
    nineteen = by_number["19"].derived[:1]
    assert holds("19", nineteen, 5e-7) > 0.4 * holds("19", nineteen, 1e-6)


KEPT = (paper.equations, led.entry_of, led.witness_point, led._sound, led._connected, led._own_definitions)


def test_a_wrong_derivation_is_named_and_not_reported(monkeypatch):
    right = paper.euler_D_eps
    monkeypatch.setattr(paper, "euler_D_eps", lambda theta, psi: right(theta, -psi))
    for cached in KEPT:
        cached.cache_clear()
    try:
        with pytest.raises(BoresightError, match=r"\(9\): the derived form itself is refuted"):
            ledger(PAPER)
    finally:
        for cached in KEPT:
            cached.cache_clear()


def test_a_wrong_name_lists_the_right_ones():
    with pytest.raises(BoresightError, match="no paper 'song-lee': the papers are song-lee-2001"):
        ledger("song-lee")


def test_kind_is_read_off_the_trees(by_number):
    (relation,) = by_number["25"].read()
    left, right = relation.sides

    def kinds(*sides):
        return {difference.kind for difference in differences([Relation(sides)], by_number["25"].derived)}

    assert kinds(left, right) == {"sign"}
    assert kinds(left, right.args[0]) == {"structure"}
    assert kinds(right.args[1], by_number["25"].derived[0].sides[1]) == {"letter"}
    assert kinds(left, total(right.args[0], negative(right.args[1]))) == set()


def test_an_erratum_in_a_letter_no_eye_confuses_is_the_print(by_number):
    nine = by_number["9"]
    swapped = nine.derived[0].replaced({s: t for s, t in zip(*_letters("ψ θ", "θ ψ"), strict=True)})
    origin, _ = led._origin(nine, differences([swapped], nine.derived))
    assert origin == "print"


def _letters(*rows):
    table = {quantity.symbol.name: quantity.symbol for quantity in paper.quantities()}
    return [[table[name] for name in row.split()] for row in rows]


# ---- What the paper drops --------------------------------------------------------------------------------------------


def test_second_order_term_is_what_the_first_order_misses():
    for scale in (1e-3, 5e-4):
        base = world.draw(5, world.Conditions().scaled(scale))
        values = world.world(base, led._definitions(PAPER))
        exact = symbols_at(values[name] for name in ("Δφ", "Δθ", "Δψ"))
        parts = [symbols_at(part) for part in (base.euler_r, base.mu)]
        terms = (paper.relative_euler(*parts), paper.relative_euler_second_order(*parts))
        missed = [exact[i] - sum(term[i].evalf(DIGITS) for term in terms) for i in range(3)]
        if scale == 1e-3:
            third = max(map(abs, missed))
        else:
            assert third / max(map(abs, missed)) == pytest.approx(8, rel=0.01)


def test_mean_of_master_and_slave_angles_has_no_second_order():
    sizes = []
    for scale in (1e-3, 5e-4):
        base = world.draw(5, world.Conditions().scaled(scale))
        values = world.world(base, led._definitions(PAPER))
        mu = symbols_at(base.mu)
        forms = (paper.relative_euler(symbols_at(values[f"{a}_{owner}"] for a in "φθψ"), mu) for owner in "rb")
        mean, exact = sum(forms, Matrix([0, 0, 0])) / 2, symbols_at(values[f"Δ{a}"] for a in "φθψ")
        sizes.append(max(map(abs, (exact - mean).evalf(DIGITS))))
    assert sizes[0] / sizes[1] == pytest.approx(8, rel=0.01)


@pytest.mark.parametrize("row", [0, 1, 2])
def test_slave_angles_in_place_of_master_angles_turn_the_second_order_error_round(row):
    with_master, with_slave = world.substitution(row)
    assert with_master * with_slave < 0
    assert abs(with_slave) == pytest.approx(abs(with_master), rel=0.1)
    assert abs(with_master) > math.pi / 10800  # arcmin: above the master's noise, not negligible


def test_table_1_obeys_its_rule_and_the_conclusion_counts_it_right():
    assert [cell for row in printed.TABLE_1 for cell in row.split()] == world.composed()
    assert "13, 12, 21, 3 cells" in findings(PAPER)[1] and "as the conclusion says" in findings(PAPER)[1]


def test_prose_formula_under_10_is_refuted_and_its_correction_exact():
    assert "off by 0.00447 at the stated point; -C_n2b E C_b2n holds" in findings(PAPER)[0]


# ---- The print -------------------------------------------------------------------------------------------------------


@needs_source
def test_table_1_and_the_prose_formula_stand_at_their_lines():
    lines = source(PAPER)
    first, last = printed.TABLE_1_LINES
    for row, line in zip(printed.TABLE_1, lines[first - 1 : last], strict=True):
        cells = [cell.replace(" ", "") for cell in line.strip().strip("|").split("|")[2:]]
        assert row.replace("o", "○").split() == cells
    assert printed.PROSE_FORMULA[1] in lines[printed.PROSE_FORMULA[0] - 1]
