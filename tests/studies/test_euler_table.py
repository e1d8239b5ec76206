"""Table 1 of Song and Lee is reproduced, and what breaks it breaks it."""

import json
from dataclasses import replace

import numpy as np
import pytest

from boresight import BoresightError
from boresight.runtime import simulation
from boresight.studies import euler_table as study
from tests import numpy_euler_matching as witness

MODEL = witness.model()
DECLARED = study.Scenario()
AXES = np.arange(3)


def test_the_papers_table_obeys_the_papers_rule():
    # "apart from the matched and the moved element, the remaining one": and combinations are unions.
    for i, match in enumerate(study.COMBINATIONS):
        for j, motion in enumerate(study.COMBINATIONS):
            seen = {3 - a - b for a in match for b in motion if a != b}
            assert set(AXES[study.PAPER[i, j]]) == seen


def test_the_papers_table_has_the_papers_counts():
    estimable = study.PAPER.sum(axis=-1)
    assert [int((estimable == n).sum()) for n in (3, 2, 1, 0)] == [13, 12, 21, 3]
    assert study.PAPER[..., 2].sum() == 28


def test_the_slaves_first_error_is_the_misalignment():
    # With mu_hat = 0 and C_hat = C_r2n: eps = C dmu with the sign reversed, exactly, however large.
    mu, euler = np.array([0.3, -0.2, 0.4]), np.array([0.2, -0.3, 1.0])
    q_r = simulation.quaternion_from_euler(euler)
    eps = simulation.attitude_error(q_r, simulation.turned(q_r, mu))
    assert np.allclose(eps, -witness.dcm(euler) @ (0 - mu), rtol=0, atol=1e-14)


def test_P0_is_the_covariance_of_the_simulated_start():
    scenario = replace(DECLARED, misalignment="normal", misalignment_deg=0.5, motion_phase_deg=(40.0, 80.0, 120.0))
    scenario = replace(scenario, filter_offset_arcmin=scenario.angle_noise_arcmin, heading_deg=70.0)
    euler = study.motion(scenario, 0.0, 1.0)[0, 6]
    P0 = study.initial_covariance(MODEL, scenario, euler)
    draws = simulation.standard_normals(3, np.arange(4000), 6)
    mu, noise = draws[:, :3] * scenario.misalignment_deg * study.DEG, draws[:, 3:] * study.ARCMIN
    q_hat = simulation.quaternion_from_euler(euler + noise)
    q_b = simulation.turned(simulation.quaternion_from_euler(euler), mu)
    state = np.concatenate([simulation.attitude_error(q_hat, q_b), -mu], axis=-1)
    nees = np.einsum("ri,ij,rj->r", state, np.linalg.inv(P0), state)
    assert abs(nees.mean() - 6) < 4 * np.sqrt(12 / 4000)
    assert np.linalg.eigvalsh(P0)[0] > 0


@pytest.mark.parametrize("seconds", [30.0, 60.0, 120.0, 300.0])
def test_linear_covariance_gives_the_papers_147_cells(seconds):
    result = study.judged(study.ratios(study.covariance(MODEL, DECLARED, seconds)), DECLARED.threshold)
    assert result["agree"] == 147
    if seconds == 120.0:
        assert result["margin"]["factor"] >= 2


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_the_closed_loop_gives_the_papers_147_cells(seed):
    flight = study.fly(MODEL, DECLARED, 120.0, runs=20, seed=seed)
    result = study.judged(study.ratios(flight.error), DECLARED.threshold)
    assert result["agree"] == 147, result["disagree"]
    assert not flight.lost.any()


def test_a_run_is_the_same_whatever_is_flown_beside_it_and_however_long():
    both = study.fly(MODEL, DECLARED, 5.0, runs=2, seed=4)
    second = study.fly(MODEL, DECLARED, 8.0, runs=1, seed=4, first_run=1)
    assert np.array_equal(both.error[..., 1:, :], second.error[:6])


def linear_agree(*switches):
    model, scenario = study.switched(MODEL, DECLARED, switches)
    return study.judged(study.ratios(study.covariance(model, scenario, 60.0)), scenario.threshold)["agree"]


def test_what_the_paper_leaves_open_decides_the_table():
    assert linear_agree() == 147
    assert linear_agree("independent-prior") < 135
    assert linear_agree("in-phase") < 135
    assert linear_agree("heading-60") < 135
    assert linear_agree("heading-60", "platform-axes") == 147


def test_the_printed_26_to_28_break_the_filter():
    euler = np.array([0.2, -0.3, 1.1])
    roll, pitch = euler[:2]
    printed = [  # the slave's half of (19), with phi_b as printed in (26) to (28)
        [-np.cos(roll) / np.cos(pitch), -np.sin(roll) / np.cos(pitch), 0],
        [np.sin(roll), -np.cos(roll), 0],
        [-np.tan(pitch) * np.cos(roll), -np.tan(pitch) * np.sin(roll), -1],
    ]
    H = study.as_printed_26(MODEL).euler_H(euler_b=euler, euler_r=euler)
    assert np.allclose(H[:, :3], printed, rtol=0, atol=1e-14)
    assert linear_agree("as-printed-26-28") < 135


def test_the_printed_25_drives_the_misalignment_away():
    result = study.run(MODEL, runs=2, seconds=30.0, switches=("as-printed-25",))
    assert result["linear"]["agree"] == 147  # the covariance does not see the sign
    assert result["monte_carlo"]["agree"] < 100
    assert result["monte_carlo"]["lost_runs"] > 49


def test_the_result_is_json_and_the_report_ends_in_the_verdict():
    result = study.run(MODEL, runs=2, seconds=30.0)
    assert json.loads(json.dumps(result, allow_nan=False)) == result
    verdict = study.report(result).splitlines()[-1]
    assert f"{result['linear']['agree']} of 147" in verdict and f"{result['monte_carlo']['agree']} by" in verdict


def test_a_cell_that_disagrees_is_counted_and_named():
    ratio = np.where(study.PAPER, 0.01, 1.0)
    ratio[0, 1, 2] = 0.5
    result = study.judged(ratio, 1 / 3)
    assert result["agree"] == 146 and result["disagree"] == ["roll match; pitch motion; eps_d"]
    assert result["margin"]["factor"] == pytest.approx(2 / 3) and result["margin"]["cell"] == result["disagree"][0]


def test_bad_input_is_named():
    with pytest.raises(BoresightError, match="in-phase"):
        study.run(MODEL, switches=("inphase",))
    with pytest.raises(BoresightError, match="at least 1 run"):
        study.run(MODEL, runs=0)
    with pytest.raises(BoresightError, match="seconds"):
        study.run(MODEL, seconds=float("nan"))
