"""The recording that comes with Boresight: made by the simulator, small, and found again by the replay."""

import json

import numpy as np
import pytest

from boresight import cli
from boresight.evidence.flights.sample import DELAY_S, sample
from boresight.runtime.recording.read import EXAMPLE


def test_the_file_is_what_the_simulator_makes():
    assert EXAMPLE.stat().st_size < 300_000
    with np.load(EXAMPLE) as kept:
        made = sample()
        assert set(kept) == set(made)
        for name, values in made.items():
            np.testing.assert_allclose(kept[name], values, rtol=1e-6, atol=1e-9)


def test_the_replay_of_the_example_finds_its_truth(capsys, tmp_path):
    with pytest.raises(SystemExit) as ended:
        cli.main(["replay", "--example", "--to", "12 s", "--model", "velocity-attitude-lever", "--json",
                  "--gyro-noise", "0.15 deg/sqrt(h)", "--accel-noise", "0.06 m/s/sqrt(h)",
                  "--velocity-noise", "1, 1 cm/s", "--attitude-noise", "1, 1 arcmin", "--delay-noise", "0 ms/sqrt(s)",
                  "-o", str(tmp_path)])  # fmt: skip
    assert ended.value.code == 0
    out = json.loads(capsys.readouterr().out)
    result = out.get("result", out)
    off = [s["difference_sigmas"] for s in result["states"] if s["reference"] is not None]
    (delay,) = (s for s in result["states"] if s["state"] == "delay")
    off.append((delay["estimate"] - 1e3 * DELAY_S) / delay["sigma"])
    assert len(off) == 13 and np.abs(off).max() < 3.5
    (page,) = tmp_path.glob("*.html")
    assert "Simulated drive" in page.read_text()
