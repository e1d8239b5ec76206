"""Kang 2025: functions against the witness, what is dropped, and what the errata do."""

import math
from functools import partial

import pytest
from sources import needs_source, source
from sympy import Float
from witnessed import numbers, symbols_at

from boresight.derive.ledger import ellipsoid
from boresight.derive.ledger.entries import findings, ledger
from boresight.derive.ledger.equation import Relation, negative, total
from boresight.derive.ledger.evaluate import DIGITS, Point, evaluate, residual
from boresight.derive.ledger.judge import judge, witness_point
from boresight.derive.ledger.numbers import Matrix, digits, exact, largest, middle, norm
from boresight.derive.ledger.witness import draw, scaled, skew, vector
from boresight.derive.papers import paper
from boresight.derive.papers.kang_2025 import consequences, results
from boresight.derive.papers.kang_2025.witness import ERRORS, Base, Conditions, motion
from boresight.derive.papers.kang_2025.witness import values as values_at

PAPER = paper("kang-2025")
EQUATIONS = {equation.number: equation for equation in PAPER.equations}

pytestmark = pytest.mark.usefixtures("many_digits")


@pytest.fixture(scope="module")
def entries():
    return {entry.number: entry for entry in ledger(PAPER)}


def values(seed=1, scale=1.0, small=()):
    return witness_point(PAPER, seed, scale, small).values


def unskewed(M):
    return vector(M[2, 1], M[0, 2], M[1, 0])


# ---- The ledger ------------------------------------------------------------------------------------------------------


def test_the_reading_of_6_is_there_only_because_an_arcsine_fails():
    six = EQUATIONS["6"]
    assert judge(PAPER, six, six.printed).status == "refuted"
    (relation,) = six.read()
    amplitude = Relation((relation.sides[0], relation.sides[1] / 2))
    assert judge(PAPER, six, (amplitude,)).status == "exact"


# ---- (1): the lever arm ----------------------------------------------------------------------------------------------


@pytest.mark.equations("1")
def test_lever_arm_runs_from_master_to_slave():
    """The other direction refutes (1), both lines of it."""
    one = EQUATIONS["1"]

    def worst(turned, scale):
        point = witness_point(PAPER, 1, scale, one.small)
        changed = {"L": point.values["L"] * turned, "dL/dt": point.values["dL/dt"] * turned}
        return largest(x for x in residual(one.printed[0].sides, Point(dict(point.values) | changed)))

    assert worst(1, 5e-7) / worst(1, 1e-6) == pytest.approx(0.25, rel=1e-3)
    assert worst(-1, 5e-7) / worst(-1, 1e-6) == pytest.approx(0.5, rel=1e-3)


@pytest.mark.equations("1")
def test_second_line_of_1_is_the_rate_of_the_lever_arm_exactly():
    v = values()
    arm = v["[ω_in_n x]"] * v["C_S2n"] * v["L"] - v["C_S2n"] * v["[ω_ib_b x]"] * v["L"]
    assert norm(arm + v["dL/dt"]) < 1e-28


def test_earth_rate_alone_is_exact_in_the_axes_of_one_place():
    """Two points of a body turn against the Earth, not against north; both variants leave v L / R."""
    sizes = consequences.lever_sizes()
    assert sizes["earth rate, one"] < 1e-40
    for name in ("print, own", "print, one", "earth rate, own"):
        assert 0.2 < sizes[name] / (5 * 3 / 6.37e6) < 3


# ---- (2), (3): the delay in the velocity -----------------------------------------------------------------------------


@pytest.mark.parametrize("step, delay", [(1.0, 0.01), (0.1, 0.01), (0.01, 0.005)])
@pytest.mark.equations("2")
def test_straight_line_errs_by_half_the_jerk_times_both_parts_of_the_interval(step, delay):
    """Up to the curvature of a sine over the step, 10 % at 1 s of a period of 10 s."""
    error, change = consequences.interpolation(4.0, step, delay)
    surge = 2 * math.pi * 0.1
    assert error == pytest.approx(float(4 * surge**3 * delay * (step - delay) / 2), rel=0.02)
    assert change == pytest.approx(float(4 * surge**2 * delay), rel=0.001)


@pytest.mark.equations("3")
def test_what_3_leaves_out_is_the_acceleration_of_the_lever_arm_times_the_delay():
    v = values(scale=1e-6, small=("delay", "step"))
    (relation,) = EQUATIONS["3"].printed
    missing = residual(relation.sides, Point(v))
    base = draw(Base, 1, scaled(Conditions(), 1e-6, ("delay", "step")))
    with digits(ellipsoid.WORKING):
        slave = motion(base, True)
        second = ellipsoid.rate(slave.lever_rate)  # d2L/dt2 as seen from n
    expected = second * v["δt_d"]  # z_v has -dL/dt of the earlier time, the print that of now
    assert norm(Matrix(missing) - expected) < exact("1e-5") * norm(expected)


def test_what_3_leaves_out_on_a_rolling_hull():
    assert consequences.dropped_by_3(0.1, 0.1, 2.0) == pytest.approx(
        0.01 * 2 * 0.1 * (2 * 3.14159 * 0.1) ** 2, rel=1e-3
    )


# ---- (4), (5): the attitude ------------------------------------------------------------------------------------------


@pytest.mark.equations("4")
def test_printed_brackets_of_4_give_one_and_a_half_times_the_turn():
    small = values(scale=1e-6)
    (relation,) = EQUATIONS["4"].printed
    A = evaluate(relation.sides[1], Point(small))
    ratio = unskewed(A - A.T) / 2
    assert all(abs(ratio[i] / unskewed(small["A"])[i] - exact("1.5")) < 1e-9 for i in range(3))


def test_half_of_the_symmetric_part_is_a_second_order():
    parts = []
    for scale in (1e-3, 5e-4):
        v = values(scale=scale)
        A = evaluate(EQUATIONS["4"].printed[0].sides[1], Point(v))
        parts.append(largest(A + A.T))
    assert parts[0] / parts[1] == pytest.approx(4, rel=0.01)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("frame", ["n", "b"])
@pytest.mark.equations("5")
def test_only_minus_and_only_the_body_rate_satisfy_5(sign, frame):
    five = EQUATIONS["5"]
    seen, _ = five.printed[0].sides[1].args
    term = five.derived[0].sides[1].args[1]
    late = negative(term) if sign > 0 else term
    if frame == "n":
        letters = {q.symbol.name: q.symbol for q in PAPER.quantities()}
        late = Relation((late, late)).replaced({letters["ω_nb_b"]: letters["ω_nb_n"]}).sides[0]
    status = judge(PAPER, five, (Relation((five.printed[0].sides[0], total(seen, late))),)).status
    assert status == ("first-order" if (sign, frame) == (-1, "b") else "refuted")


def test_no_meaning_of_the_delay_satisfies_both_3_and_5_as_printed():
    """Were the master's data newer by dt_d, the plus of (5) would be right, and (2) and (3) wrong."""
    five = EQUATIONS["5"]
    seen, late = five.derived[0].sides[1].args
    plus = Relation((five.derived[0].sides[0], total(seen, negative(late))))

    def worst(relation, scale, small, sign):
        point = witness_point(PAPER, 1, scale, small)
        changed = dict(point.values) | {"δt_d": point.values["δt_d"] * sign}
        return largest(x for x in residual(relation.sides, Point(changed)))

    for relation, small, right in (
        (plus, (), -1),
        (EQUATIONS["2"].printed[0], ("delay", "step"), 1),
        (EQUATIONS["3"].derived[0], ("delay", "step"), 1),
    ):
        for sign in (1, -1):
            falls = worst(relation, 5e-7, small, sign) / worst(relation, 1e-6, small, sign)
            assert falls == pytest.approx(0.25 if sign == right else 0.5, rel=1e-3)


def test_printed_5_finds_a_delay_of_the_other_sign_and_none_across():
    found = {h: consequences.delay_by_attitude("printed", h) for h in (0, 90, 180)}
    assert found == pytest.approx({0: -0.01, 90: 0, 180: 0.01}, rel=1e-3, abs=1e-6)
    for heading in (0, 90, 180):
        assert consequences.delay_by_attitude("derived", heading) == pytest.approx(0.01, rel=1e-3)


# ---- The functions against the witness -------------------------------------------------------------------------------


@pytest.mark.equations("3 4 5")
def test_functions_are_the_derived_forms():
    v = values(scale=1e-9)
    C, L, v_S = (symbols_at(v[name]) for name in ("C_S2n", "L", "v_S"))
    rates = [symbols_at(unskewed(v[name])) for name in ("[ω_in_n x]", "[ω_ib_b x]")]
    expected = results.master_velocity(v_S, C, *rates, L)
    assert norm(numbers(expected) - v["v_S"] + v["dL/dt"]) < 1e-28
    v_rate = (v["v_s(k)"] + v["u(k)"] - v["v_s(k-1)"] - v["u(k-1)"]) / v["dt"]
    lag = Float(middle(v["δt_d"]), DIGITS)
    z_v = numbers(results.velocity_residual(expected, symbols_at(v_rate), lag, symbols_at(v["v_M"])))
    assert norm(z_v - v["z_v"]) < 1e-16  # second order of 1e-10 s
    C_expected = C * symbols_at(v["C_M2S"])
    z = numbers(results.attitude_residual(C_expected, symbols_at(v["ω_nb_n"]), lag, symbols_at(v["C_M2n"])))
    assert norm(z - v["z_DCM"]) < 1e-16


def at_master(motion, t):
    """Velocity of the slave less the rate of the lever arm as seen from n."""
    return motion.velocity(motion.slave, t) - motion.lever_rate(t)


@pytest.mark.parametrize("which", ["velocity", "attitude"])
def test_measurement_matrices_are_first_order_of_the_residuals(which):
    """z = H x by the witness, all errors at once, a misalignment of any size: what is left falls fourfold.

    No delay is taken off, so the error of its estimate, 0, is minus the delay.
    """
    remainders = []
    for scale in (1e-6, 5e-7):
        base = draw(Base, 3, scaled(Conditions(), scale, ERRORS))
        v, now, delay = values_at(base, {}), exact(0), base.delay[0]
        with digits(ellipsoid.WORKING):
            truth, slave = motion(base, False), motion(base, True)
            v_m, a_n = at_master(truth, -delay), ellipsoid.rate(partial(at_master, slave))
            omega_ib, omega_in = truth.omega_ib_b(now), truth.omega_in_n(now)
        hat_ib, hat_in = unskewed(v["[ω_ib_b x]"]), unskewed(v["[ω_in_n x]"])
        if which == "velocity":
            C, L = symbols_at(v["C_S2n"]), symbols_at(v["L"])
            H = results.velocity_matrix(C, symbols_at(hat_in), symbols_at(hat_ib), L, symbols_at(a_n))
            # The rate of the level is taken as known: what its error does is no part of H.
            z = v["v_S"] - v["dL/dt"] - v_m - skew(hat_in - omega_in) * v["C_S2n"] * v["L"]
        else:
            H, z = results.attitude_matrix(symbols_at(v["C_M2n"]), symbols_at(v["ω_nb_n"])), unskewed(v["A"])
        # What the gyros show too much and is not taken off is minus the error of the bias' estimate.
        parts = (base.phi, base.velocity_error, omega_ib - hat_ib, [0, 0, 0], base.dmu, [-delay])
        x = vector(*(entry for part in parts for entry in part))
        remainders.append(middle(norm(z - numbers(H) * x)))
    assert remainders[0] / remainders[1] == pytest.approx(4, rel=0.01)


# ---- The text and the tables -----------------------------------------------------------------------------------------


@pytest.mark.equations("6")
def test_grades_of_the_code_table():
    assert [consequences.grade(h) for h in (0, 0.05, 0.1, 0.11, 0.5, 1.25, 2.5, 4, 4.01, 6, 9, 14, 15)] == [
        0, 1, 1, 2, 2, 3, 4, 5, 6, 6, 7, 8, 9,
    ]  # fmt: skip


def test_findings_and_evidence_say_what_was_computed(entries):
    text = " ".join(findings(PAPER))
    for piece in ("grades 2 to 6", "grades 1, 1, 2, 3, 4, 5", "33.8 mil are left of 35.6", "2.7 mil"):
        assert piece in text
    for number, piece in (
        ("1", "and nothing if both"),
        ("2", "4.9 mm/s, 31 % of the 15.8 mm/s"),
        ("3", "6.54 % at grade 6"),
        ("4", "1.5 times it"),
        ("5", "-10 ms at 0 deg, 0 ms at 90 deg, 10 ms at 180 deg"),
        ("6", "5 m (grade 6), 8 m (grade 7)"),
    ):
        assert piece in entries[number].evidence


@needs_source
def test_text_and_tables_stand_at_their_lines():
    lines = source(PAPER.name)
    for line, text in (
        consequences.RATE_OF_N,
        consequences.WHEN,
        consequences.BETWEEN,
        consequences.RESIDUALS,
        consequences.HEIGHT,
        consequences.GRADES_RUN,
        consequences.GRADES_READ,
        consequences.AT_REST,
        consequences.ROLLING,
    ):
        assert text in lines[line - 1], text
    for (first, last), table in (
        (consequences.TABLE_1_LINES, consequences.TABLE_1),
        (consequences.TABLE_2_LINES, consequences.TABLE_2),
    ):
        assert [tuple(line.split("\t")) for line in lines[first - 1 : last]] == list(table)
