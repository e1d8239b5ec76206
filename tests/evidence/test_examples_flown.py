"""Every example was verified, flown and exported from the sources here, and its filter knows how wrong it is."""

import runpy

import numpy as np
import pytest
from test_new import rare

from boresight.evidence import results
from boresight.evidence.examples import NAMES
from boresight.evidence.sources import Examples


def test_every_example_has_a_result():
    assert set(results.read(Examples())["flown"]["units"]) == set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_an_example_is_verified_flown_and_exported(name):
    of = results.read(Examples())["flown"]["units"][name]
    assert of["verify"]["passed"] and not of["verify"]["failed"]
    assert of["self-tests"] and of["figure"]
    assert not any(rare(nees * of["runs"], of["states"] * of["runs"]) for nees in of["nees"])
    assert of["nis"] and not any(rare(total, rows) for total, rows in of["nis"].values())


def test_the_radar_rejects_what_is_no_echo_of_its_target_and_tracks_it_past_180_degrees():
    script = runpy.run_path(str(Examples().place / "fly_radar.py"))
    _, rows = results.read(Examples())["flown"]["units"]["radar"]["nis"]["echo"]
    echoes = script["RUNS"] * script["SECONDS"] / script["DT"]
    assert abs(rows / (2 * echoes) - (1 - script["CLUTTER"])) < 0.01

    rng = np.random.default_rng(0)
    truth = np.tile(script["BEGIN"], (20, 1))
    for _ in range(round(15 / script["DT"])):
        truth = script["next_state"](truth, rng)
    assert script["BEGIN"][1] > 0 > truth[:, 1].max() and truth[:, 0].max() < 0  # from east to west in the south
