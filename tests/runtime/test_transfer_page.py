"""The page on transfer alignment: its example runs as it stands."""

import re

import numpy as np
import pytest
from conftest import ROOT

from boresight.runtime import rotation
from boresight.runtime.recording import read
from boresight.runtime.simulation.drive import simulate

PAGE = (ROOT / "docs" / "transfer-alignment.md").read_text()


def test_the_example_finds_mounting_bias_and_delay_of_a_recording(tmp_path, monkeypatch, capsys):
    simulate(tmp_path / "drive", seed=3, delay=0.03)
    monkeypatch.chdir(tmp_path)
    names: dict = {}
    exec(re.search(r"```python\n(.*?)```", PAGE, re.DOTALL)[1], names)
    out, truth = names["out"], read("drive.toml").reference
    counts = names["loop"].counts()
    assert counts["TAKEN"] > 100 and counts["TAKEN"] > 0.99 * sum(
        counts[name] for name in ("TAKEN", "IN_PART", "GATED")
    )
    mounting = rotation.vector_from_matrix(rotation.matrix_from_quaternion(out["q_b2m_wxyz"]))
    assert (np.abs(mounting - truth["misalignment"]) < 4 * out["sigma"][12:15]).all()
    assert (np.abs(out["gyro_bias"] - truth["gyro_bias"]) < 4 * out["sigma"][6:9]).all()
    assert abs(out["tau"] - 0.03) < 4 * out["sigma"][15] < 4 * 0.6e-3
    printed = capsys.readouterr().out
    assert float(re.search(r"the master is ([\d.]+) ms old", printed)[1]) == pytest.approx(30, abs=1.5)
