"""What motions show of the errors of transfer alignment: laws that hold before any filter is flown, and flights."""

from itertools import pairwise

import numpy as np
import pytest

from boresight.analysis.consistency import chi_square_band
from boresight.analysis.observability import Moment, along, since, with_fields
from boresight.runtime import rotation
from boresight.runtime.library import load
from boresight.runtime.simulation import hull, sensors
from boresight.runtime.units import MIL
from boresight.studies.explorations import sea_state as study
from tests.drawing import drawn

DEG = np.pi / 180


@pytest.fixture(scope="module")
def model(compiled_once):
    return load("velocity-attitude")


@pytest.fixture(scope="module")
def wide(compiled_once):
    return load("velocity-attitude-lever")


@pytest.fixture(scope="module")
def shown(wide):
    return study.shown(wide, study.DECLARED, 120.0, 0)


def cell(shown, motion, state):
    return shown["seconds_to_third"][shown["motions"].index(motion)][study.STATES.index(state)]


def test_the_first_sample_from_which_on_a_sigma_stays_below_the_threshold():
    sigma = np.array([[3.0, 3.0, 3.0], [0.9, 2.0, 3.0], [1.1, 0.9, 3.0], [0.8, 0.7, 3.0]])
    np.testing.assert_array_equal(since(sigma < sigma[0] / 3), [3.0, 2.0, np.nan])


def test_covariance_along_known_matrices_is_that_of_information(wide):
    """No dynamics and no noise: the information of all measurements and of the prior simply add up."""
    rng = np.random.default_rng(1)
    n, R = 19, np.full(4, 0.5)
    H = rng.standard_normal((5, 4, n))

    class Still:
        Phi = staticmethod(with_fields(lambda: np.eye(n)))
        Q = staticmethod(with_fields(lambda: np.zeros((n, n))))

    *_, P = along(Still(), np.eye(n), (Moment({}, part, R) for part in H))
    np.testing.assert_allclose(np.linalg.inv(P), np.eye(n) + np.einsum("kij,kil->jl", H, H) / 0.5, rtol=1e-9, atol=1e-9)


def test_a_course_moves_as_its_derivatives_say():
    time = np.linspace(0, 40, 4001)
    pose = study.underway(time, study.ramp(time, 5.0, 20.0, 90 * DEG), study.ramp(time, 2.0, 10.0, 5.0))
    step = time[1] - time[0]
    inside = slice(5, -5)
    np.testing.assert_allclose(np.gradient(pose.v_n, step, axis=0)[inside], pose.a_n[inside], atol=2e-3)
    np.testing.assert_allclose(np.gradient(pose.omega_nb_b, step, axis=0)[inside], pose.alpha_nb_b[inside], atol=0.02)
    turn = rotation.attitude_error(pose.q_b2n_wxyz[:-1], pose.q_b2n_wxyz[1:]) / step
    # a difference that spans the corner of a ramp misses a quarter of a step of the acceleration's jump there
    jump = 90 * DEG * (np.pi / 20) ** 2 / 2
    middle = (pose.omega_nb_b[1:, 0, 2] + pose.omega_nb_b[:-1, 0, 2]) / 2
    np.testing.assert_allclose(turn[:, 0, 2], middle, atol=jump * step / 4)
    np.testing.assert_allclose(pose.v_n[-1, 0], [0, 5, 0], atol=1e-12)


def test_what_a_motion_cannot_show_stays_unknown(shown):
    """From first principles: no heading without a turn of the level or a horizontal acceleration, no delay at rest, no
    lever arm along the axis of a turn, no horizontal accelerometer bias apart from the tilt."""
    for motion in ("rest", "heave 1 m", "yaw 3 deg", "straight 5 m/s"):
        assert cell(shown, motion, "phi_d") is None
        assert cell(shown, motion, "mu_z") is None
    for motion in ("roll 3 deg", "pitch 3 deg", "surge 0 to 5 m/s in 10 s", "one turn of 90 deg, 5 m/s"):
        assert cell(shown, motion, "phi_d") < 20
    assert cell(shown, "rest", "delay") is None
    assert cell(shown, "straight 5 m/s", "delay") is None
    assert cell(shown, "heave 1 m", "delay") is not None
    for motion, axis in (("roll 3 deg", "lever x"), ("pitch 3 deg", "lever y"), ("yaw 3 deg", "lever z")):
        assert cell(shown, motion, axis) is None
    for motion in ("rest", "heave 1 m", "straight 5 m/s", "surge 0 to 5 m/s in 10 s"):
        assert cell(shown, motion, "accel x") is None
        assert cell(shown, motion, "accel y") is None
        assert cell(shown, motion, "accel z") < 10
    # equal swings a quarter of a period apart: an unknown delay looks like a turn about down
    in_phase, apart = (cell(shown, f"roll + pitch {how}", "delay") for how in ("in phase", "90 deg"))
    assert in_phase < 10
    assert apart is None
    heading = dict(zip(shown["motions"], shown["heading_mil_60_s"], strict=True))
    assert heading["roll + pitch 90 deg"] > 10 * heading["roll + pitch in phase"]


def test_at_rest_the_heading_keeps_the_sigma_it_was_given(shown):
    at_rest = shown["heading_mil_60_s"][shown["motions"].index("rest")]
    assert at_rest == pytest.approx(2 * 6400 / 360, rel=2e-3)


def test_rougher_seas_show_more(shown):
    for letter in "bc":
        heading = [shown["heading_mil_60_s"][shown["motions"].index(f"({letter}) sea state {g}")] for g in range(1, 7)]
        assert all(a > b for a, b in pairwise(heading))


def test_a_manoeuvre_shows_the_heading_by_the_change_of_velocity_alone(wide):
    """Sigma times the change is one number, within what the time spent on it takes."""
    part = study.manoeuvres(wide, study.DECLARED)
    rows = part["turns"] + part["surges"]
    product = np.array([row["velocity_change_m_s"] * row["heading_mil"] for row in rows])
    assert product.min() > 0.8 * study.RULE_MIL_M_S
    assert product.max() < 1.25 * study.RULE_MIL_M_S
    for row in part["turns"]:
        # a turn by the angle leaves a chord of the circle of the speed
        assert row["velocity_change_m_s"] == pytest.approx(
            np.linalg.norm(
                row["speed_m_s"] * np.array([np.cos(row["angle_deg"] * DEG) - 1, np.sin(row["angle_deg"] * DEG)])
            )
        )


def test_closed_loops_have_the_errors_that_the_covariance_along_the_truth_foretells(model, wide):
    """Roll shows the heading, heave does not; both by the errors of forty runs."""
    runs, scenario = 40, study.QUICK
    wrong = sensors.standard_normals(1, np.arange(runs), 1)[:, 0] * 2 * DEG
    mounting = study.turned_about_down(wrong)[None]
    for name, size in (("roll", 3.0), ("heave", 1.0)):
        amplitude = np.array([size * (DEG if name == "roll" else 1.0) * (part == name) for part in hull.FREEDOMS])
        motion = hull.sinusoids(amplitude[None, None], np.zeros((1, 1, 6)), np.array([[1 / 8]]))
        belief = study.at_sea.Belief(heading_sigma=2 * DEG)
        flight = study.at_sea.fly(model, motion, scenario, mounting=mounting, belief=belief, runs=runs, seed=0)
        foretold = study.covariances(wide, study.swinging(study.sampled(60.0, scenario), **{name: size}), scenario)
        foretold_mil = foretold[-1, 0, study.HEADING] / MIL
        rms = np.sqrt(np.mean((flight.heading[-1] / MIL) ** 2))
        assert 0.75 < rms / foretold_mil < 1.3, (name, rms, foretold_mil)  # forty runs: 11 %, and the level error
        if name == "roll":
            low, high = chi_square_band(16, runs)
            assert low < flight.nees.mean() < high
        else:  # the filter's own sigma feigns a little: H at estimates that change while nothing corrects them
            assert flight.heading_sigma[-1].min() > 0.9 * foretold[0, 0, study.HEADING]


def test_every_way_of_matching_is_consistent_where_it_is_possible_and_euler_angles_are_not_near_the_vertical(
    model, monkeypatch
):
    monkeypatch.setattr(study, "PLACES", {name: study.PLACES[name] for name in ("level", "pitch 88")})
    rows = {(row["way"], row["place"]): row for row in study.matchings(model, runs=10, seed=0)}
    for way in study.WAYS:
        row = rows[way, "level"]
        assert row["nees"] < 1.15 * row["nees_band"][1]
        assert 0.9 < row["nis"] < 1.1
        steep = rows[way, "pitch 88"]
        assert steep["refused"] == way.startswith("Euler")
        assert steep["nees"] < 1.15 * steep["nees_band"][1]  # by the velocity alone
    heading = {way: rows[way, "level"]["heading_sigma_mil"] for way in study.WAYS}
    assert heading["DCM"] == pytest.approx(heading["quaternion"], rel=0.01)
    assert heading["DCM"] == pytest.approx(heading["Euler angles"], rel=0.01)
    # two angles of three cost little, one of three nearly all
    assert heading["Euler, pitch and yaw (two-antenna GPS)"] < 1.5 * heading["DCM"]
    assert heading["Euler, yaw (compass)"] > 20 * heading["DCM"]


def test_a_bank_finds_any_heading_of_the_master_and_one_filter_does_not(model, monkeypatch):
    monkeypatch.setattr(study, "SINGLE", ("dcm",))
    monkeypatch.setattr(study, "UNKNOWN_DEG", (2.0, 20.0, 45.0, 180.0))
    monkeypatch.setattr(study, "QUICK", study.replace(study.QUICK, seconds=30))
    part = study.starts(model, runs=4, seed=1)
    single = {row["unknown_deg"]: row for row in part["single"]}
    assert single[2.0]["nees"] < 1.3 * single[2.0]["nees_band"][1]
    assert single[20.0]["nees"] > 2 * single[20.0]["nees_band"][1]
    for unknown, found in ((2.0, 1.0), (20.0, 1.0), (45.0, 0.0), (180.0, 0.0)):
        assert single[unknown]["converged"] == found == 1 - single[unknown]["refused"]
    assert part["bank"]["converged"] == 1.0
    assert part["bank"]["nees"] < 1.15 * part["bank"]["nees_band"][1]


def test_the_exploration_can_be_read_and_drawn(tmp_path, monkeypatch):
    monkeypatch.setattr(study, "UNKNOWN_DEG", (2.0, 10.0))
    monkeypatch.setattr(study, "WAYS", {"DCM": study.WAYS["DCM"], "Euler angles": study.WAYS["Euler angles"]})
    monkeypatch.setattr(study, "QUICK", study.replace(study.QUICK, seconds=5))
    result = study.run(study.Asked(runs=2, seconds=60.0))
    text = study.report(result)
    assert "refused" in text and "turn of 90 deg" in text and text.count("\n") > 60
    for path in drawn(study.STUDY, result, tmp_path):
        assert path.stat().st_size > 20000
