"""What was refused is in no figure of the innovations, and in no likelihood by which noises are chosen."""

import numpy as np
import pytest

from boresight.studies.replays.innovations import consistency, minus_log_likelihood, most_likely


def test_figures_of_what_was_used_are_those_of_a_record_without_the_rest():
    w = np.random.default_rng(1).standard_normal((400, 6))
    used = np.ones(w.shape, bool)
    used[100:180] = False  # part of the second quarter
    spoilt = np.where(used, w, 1e3)
    said, whole = consistency(spoilt, used), consistency(w)
    kept = np.delete(w, slice(100, 180), axis=0)
    assert said["mean"] == pytest.approx(np.mean(kept**2), rel=1e-12)
    assert said["per_row"] == pytest.approx(np.mean(kept**2, axis=0), rel=1e-12)
    assert said["by_quarter"][1] == pytest.approx(np.mean(w[180:200] ** 2), rel=1e-12)
    assert said["by_quarter"][2:] == pytest.approx(whole["by_quarter"][2:], rel=1e-12)
    assert said["band"][1] - 1 == pytest.approx(1.96 * np.sqrt(2 / kept.size), rel=1e-12)
    assert said["consistent"] and said["white"]
    used[100:200] = False
    assert consistency(spoilt, used)["by_quarter"][1] is None


def test_noises_are_chosen_by_what_is_used_under_all_of_them():
    """A message that fits nothing comes every tenth time; each of the noises refuses some of the others by itself."""
    rng = np.random.default_rng(2)
    nu = 0.3 * rng.standard_normal((2000, 2))
    nu[::10] = 50.0

    def flown(noises):
        sigma = np.broadcast_to(noises[:, 0], (2000, len(noises)))
        off = np.broadcast_to(nu[:, None], (2000, len(noises), 2))
        used = (np.abs(off) < 4 * sigma[..., None]).all(-1, keepdims=True)  # the smaller a noise, the more it refuses
        S = np.broadcast_to(np.square(sigma)[..., None], off.shape)
        return {"nu": off, "S": S, "used": np.broadcast_to(used, off.shape)}

    for first in (0.1, 0.3, 1.0):
        found, *_ = most_likely(flown, np.array([first]), np.array([True]), (1e-3, 1e2))
        assert found[0] == pytest.approx(0.3, rel=0.05), first


def test_a_refused_row_adds_nothing_to_the_likelihood():
    rng = np.random.default_rng(3)
    track = {"nu": rng.standard_normal((50, 3, 6)), "S": rng.uniform(0.5, 2, (50, 3, 6))}
    used = rng.random((50, 3, 6)) < 0.8
    other = track | {"nu": np.where(used, track["nu"], 1e6), "used": used}
    assert minus_log_likelihood(other) == pytest.approx(minus_log_likelihood(track | {"used": used}), rel=1e-14)
    assert (minus_log_likelihood(other) < minus_log_likelihood(track | {"nu": other["nu"]})).all()
