"""Detectors by a labelled recording, and OpenShoe's formulas beside ours."""

from pathlib import Path

import labelled_rest
import numpy as np
import pytest
from tools import real_recording

from boresight.runtime import detector as d

PAGE = Path(__file__).parents[2] / "docs" / "stationary-detectors.md"


def test_shoe_is_the_likelihood_ratio_and_the_moving_variance_the_spread():
    """Theirs by the definitions, ours in the generated C; a random motion about a random gravity."""
    rng = np.random.default_rng(4)
    gyro, accel = 0.01 * rng.standard_normal((400, 3)), [1.0, -2, -9.5] + 0.05 * rng.standard_normal((400, 3))
    settings = d.settings(20, 0.04, 2e-3, 1e-3, gravity=9.79)
    ours = d.evaluate(settings, gyro, accel)
    theirs = labelled_rest.openshoe(gyro, accel, 20, 0.04, 2e-3, 9.79)[19:]
    np.testing.assert_allclose(ours.statistic_of("likelihood_ratio")[19:], theirs[:, 2], rtol=1e-11)
    np.testing.assert_allclose(ours.statistic_of("accel_std")[19:] ** 2 / 0.04**2, theirs[:, 1], rtol=1e-11)
    energy = (ours.statistic_of("gyro_std")[19:] ** 2 + ours.statistic_of("gyro_mean")[19:] ** 2) / 2e-3**2
    np.testing.assert_allclose(energy, theirs[:, 0], rtol=1e-11)


def test_white_noise_alarms_at_the_rate_of_their_laws():
    rng = np.random.default_rng(5)
    N, windows = 20, 20_000
    gyro, accel = (
        2e-3 * rng.standard_normal((windows * N, 3)),
        [0, 0, -9.8] + 0.04 * rng.standard_normal((windows * N, 3)),
    )
    found = labelled_rest.openshoe(gyro, accel, N, 0.04, 2e-3, 9.8)[N - 1 :: N]
    alarms = (found > labelled_rest.openshoe_thresholds(N, 1e-2)).mean(axis=0)
    assert (np.abs(alarms - 1e-2) < 4 * np.sqrt(1e-2 / windows)).all(), alarms


@pytest.mark.parametrize("N", [10, 50])
def test_the_page_has_what_the_labelled_recording_gives(N):
    folder = real_recording(labelled_rest.TRIAL).parent
    real_recording("broad_trials.json")
    text = PAGE.read_text()
    found = list(labelled_rest.rows(folder, N))
    assert len(found) == 8 and "\n".join(found) in text[text.index(f"| N = {N} |") :]


def test_what_the_labelled_recording_is_said_to_be():
    imu, movement, about = labelled_rest.labelled(real_recording(labelled_rest.TRIAL).parent)
    _, noise = labelled_rest.decided(imu, 50, 1e-3)
    assert about == "undisturbed, slow translational movements without rotation, three breaks of 10 seconds"
    text = " ".join(PAGE.read_text().split())
    share, seconds = f"{100 * movement.mean():.0f} %", f"{imu.time[-1]:.0f} s"
    assert f"in motion for {share} of {seconds}" in text
    assert f"{noise['sigma_gyro']:.2e} rad/s and {noise['sigma_accel']:.2e} m/s^2".replace("e-0", "e-") in text
