"""Kim 2018: functions against the witness, and what wrong signs and dropped terms do."""

from itertools import product

import pytest
from sources import needs_source, source
from sympy import Float
from sympy import Matrix as Symbols
from witnessed import numbers, symbols_at

from boresight.derive.ledger.entries import findings, ledger
from boresight.derive.ledger.evaluate import DIGITS, Point, evaluate, residual
from boresight.derive.ledger.judge import witness_point
from boresight.derive.ledger.numbers import cos, exact, largest, middle
from boresight.derive.ledger.witness import draw, finite_rotation
from boresight.derive.papers import paper
from boresight.derive.papers.kim_2018 import consequences, results, witness

PAPER = paper("kim-2018")

pytestmark = pytest.mark.usefixtures("many_digits")


@pytest.fixture(scope="module")
def entries():
    return {entry.number: entry for entry in ledger(PAPER)}


def values(seed=1, scale=1.0):
    return witness_point(PAPER, seed, scale).values


def base():
    return draw(witness.Base, 1, witness.Conditions())


def apart(ours, theirs):
    """The largest difference of two matrices, as a share of the largest entry."""
    return largest(ours - theirs) / largest(theirs)


@pytest.mark.equations("9")
def test_no_choice_of_rho_saves_the_position_rows():
    """The text does not define ρ; each component may be either rate with either sign."""
    names = ("ρ_e", "ρ_n")
    points = [values(1, scale) for scale in (1e-6, 5e-7)]
    choices = [s * points[0][name] for name in names for s in (1, -1)]
    saved = []
    for rho_e, rho_n in product(choices, repeat=2):
        sizes = []
        for point in points:
            changed = Point(dict(point) | {"ρ_e": rho_e, "ρ_n": rho_n})
            sizes.append(max(abs(residual(r.sides, changed)[0]) for r in PAPER.equation("9").printed))
        saved.append(sizes[1] < 0.3 * sizes[0])
    assert len(saved) == 16 and not any(saved)


# ---- The functions against the witness -------------------------------------------------------------------------------


@pytest.fixture
def truth():
    return witness.truth(base())


@pytest.mark.equations("7 9 10 11")
def test_system_matrix_of_fifteen_states_is_the_derivative_of_the_exact_rates(truth):
    v = values()
    parts = [symbols_at(x) for x in (truth.position, truth.v_n)]
    C = Symbols(3, 3, symbols_at(truth.C))
    F = numbers(results.hold_matrix(*parts, C, symbols_at(v["f_n"])))
    for i, j in product(range(0, 15, 3), repeat=2):
        ours, theirs = (M[i : i + 3, j : j + 3] for M in (F, v["F_k"]))
        assert largest(ours - theirs) <= 1e-25 * largest(theirs), (i, j)


@pytest.mark.equations("2 3")
def test_system_matrix_of_ten_states_is_the_derivative_of_the_psi_rates(truth):
    v = values()
    parts = [symbols_at(x) for x in (truth.position, truth.v_n, v["f_n"])]
    assert apart(numbers(results.transfer_matrix(*parts)), v["F_X"]) < 1e-25


@pytest.mark.equations("6 17 23")
def test_measurement_matrices_are_derivatives_of_the_residuals(truth):
    v = values()
    C_r2n = Symbols(3, 3, symbols_at(v["C_r2n"]))
    H = results.transfer_measurement_matrix(C_r2n, symbols_at(v["v̇"]), -symbols_at(v["d"]))
    assert apart(numbers(H), v["H_X"]) < 1e-25
    assert apart(numbers(results.hold_measurement_matrix()), v["H_k"]) < 1e-25
    assert apart(numbers(results.zero_velocity_matrix()), v["H_v"]) < 1e-25


@pytest.mark.equations("5")
def test_d_is_how_the_level_turns_against_the_master(truth):
    v = values()
    omega_nr = v["C_r2n"] * (finite_rotation(base().mounting) * truth.omega) - truth.exact.omega_in_n
    assert apart(-omega_nr, v["d"]) < 1e-25


@pytest.mark.equations("4 5 21 29")
def test_residuals_and_quaternion_error_are_those_of_the_witness():
    v = values()
    hats = [Symbols(3, 3, symbols_at(v[name])) for name in ("Ĉ_r2n", "Ĉ_b2r", "Ĉ_n2b")]
    Z = results.attitude_residual(*hats[:2], hats[2].T)
    assert apart(numbers(Z), v["Z_dcm"]) < 1e-25
    assert (
        apart(numbers(results.velocity_residual(*(symbols_at(v[n]) for n in ("v̂_SINS", "v̂_MINS")))), v["Z_v"]) < 1e-25
    )
    small = values(scale=1e-9)
    q = symbols_at(small["Q̂_b2n"])
    assert apart(numbers(results.quaternion_error(q, symbols_at(small["φ"]))), small["ΔQ"]) < 1e-9
    M = [Symbols(3, 3, symbols_at(small[n])) for n in ("C_b2p", "C̄_n2b")]
    assert float(results.azimuth_error(*M)) == pytest.approx(float(small["φ_u"]), rel=1e-15)


@pytest.mark.equations("31 32")
def test_detector_statistics_are_those_of_the_pairs():
    window = range(witness.WINDOW_AT, witness.WINDOW_AT + witness.WINDOW_OF)
    a, w = zip(*(map(symbols_at, witness._outputs(base(), k)) for k in window), strict=True)
    v = values()
    assert abs(Float(middle(v["T_a"]), DIGITS) - results.moving_deviation(a)) < 1e-28
    assert abs(Float(middle(v["T_w"]), DIGITS) - results.moving_mean(w)) < 1e-28


# ---- What wrong signs and dropped terms do ---------------------------------------------------------------------------


@pytest.mark.equations("11")
def test_printed_sign_of_11_turns_schulers_oscillation_into_growth(entries):
    radius = 6.371e6
    assert consequences._growth(1) < 1e-20
    assert float(consequences._growth(-1)) == pytest.approx((witness.G / radius) ** 0.5, rel=0.01)
    assert "errors grow e-fold in 807 s" in entries["11"].evidence


@pytest.mark.equations("6")
def test_delay_column_of_6_doubles_a_level_delay_and_does_not_see_a_vertical_one():
    assert consequences.delay_estimate("derived") == pytest.approx((0.05, 0.05))
    level, vertical = consequences.delay_estimate("printed")
    assert level == pytest.approx(-0.05)
    assert abs(vertical) < 0.01 * 0.05


def test_half_of_the_residual_holds_twice_the_azimuth_error():
    assert consequences.held_azimuth(0.5) == pytest.approx(2 * consequences.held_azimuth(1), rel=0.1)


def test_feedback_as_printed_doubles_the_error_or_turns_the_attitude_round():
    left = {name: float(value) for name, value in consequences.feedback_readings().items()}
    assert left["[1, -φ/2] for ΔQ"] == pytest.approx(2 * left["nothing"], rel=1e-4)
    assert left["a 0 put before φ, the product kept"] > 2.5
    assert left["the sum, as derived"] < 1e-5 * left["nothing"]


@pytest.mark.equations("12")
def test_first_order_transition_drops_four_orders_more_at_1_hz_than_at_100_hz():
    fast, slow = consequences.transition_error(exact("0.01")), consequences.transition_error(exact(1))
    assert float(slow["velocity from gyro bias"]) == pytest.approx(9.8 / 2, rel=0.01)
    for block in ("velocity from gyro bias", "velocity from attitude", "attitude from attitude"):
        assert float(slow[block] / fast[block]) == pytest.approx(1e4, rel=0.01)


def test_position_rows_as_printed_differ_by_what_the_evidence_says(entries):
    v = witness.values(witness.STATED, PAPER.definitions)
    lon, lat, _ = (
        (p.sides[1], d.sides[1]) for p, d in zip(PAPER.equation("9").printed, PAPER.equation("9").derived, strict=True)
    )
    point = Point(v)
    metres = [(v["R_E"] + v["h"]) * cos(v["L"]), v["R_N"] + v["h"]]
    east, north = (
        float(1000 * (evaluate(p, point) - evaluate(d, point)) * m)
        for (p, d), m in zip((lon, lat), metres, strict=True)
    )
    assert f"{east:.3g} m into the longitude" in entries["9"].evidence
    assert north == pytest.approx(2.52 + 0.0012, abs=0.005)


def test_printed_window_shrinks_and_ends(entries):
    """N - n samples for a sum that is divided by N."""
    window = PAPER.equation("Ω_n").printed[0].sides[1]
    for n, N in ((0, 5), (2, 4), (3, 3), (5, 4)):
        point = Point({"n": exact(n), "N": exact(N), "l": 0, "index": 0, "samples": witness._between})
        assert sum(evaluate(window, point)) == len(consequences.printed_window(n, N))
    assert "50 samples at n = 50" in entries["Ω_n"].evidence and "0 from n = 100 on" in entries["Ω_n"].evidence


def test_findings_name_the_text_beside_the_equations():
    text = " ".join(findings(PAPER))
    for piece in ("Line 198", "24 states", "psi in (1) to (6)", "15.04 deg/h"):
        assert piece in text


# ---- The print and its pages -----------------------------------------------------------------------------------------


@needs_source
def test_text_between_the_equations_stands_at_its_lines():
    lines = source(PAPER.name)
    assert consequences.DETECTORS[1] in lines[consequences.DETECTORS[0] - 1]
    first, last = consequences.TABLE_1_LINES
    table = [line.split("\t")[-2:] for line in lines[first - 1 : last]]
    for i, sensor in enumerate(("gyro", "accelerometer")):
        pairs = zip(consequences.TABLE_1[sensor], consequences.TABLE_1_UNITS[sensor], strict=True)
        assert table[4 * i : 4 * i + 4] == [list(pair) for pair in pairs]
