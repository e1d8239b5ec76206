"""The page on transfer alignment: its example runs as it stands, and its table has every verdict."""

import re

import numpy as np
import pytest
from conftest import ROOT

from boresight.runtime import rotation
from boresight.runtime.recording import read
from boresight.runtime.simulation.drive import simulate
from boresight.runtime.transfer import Verdict

PAGE = (ROOT / "docs" / "transfer-alignment.md").read_text()


def test_the_example_finds_mounting_bias_and_delay_of_a_recording(tmp_path, monkeypatch, capsys):
    simulate(tmp_path / "drive", seed=3, delay=0.03)
    monkeypatch.chdir(tmp_path)
    names: dict = {}
    exec(re.search(r"```python\n(.*?)```", PAGE, re.DOTALL)[1], names)
    loop, truth = names["loop"], read("drive.toml").reference
    assert names["result"].taken
    sigma = np.sqrt(np.diag(loop.P))
    mounting = rotation.vector_from_matrix(rotation.matrix_from_quaternion(loop.nav["q_b2m_wxyz"]))
    assert (np.abs(mounting - truth["misalignment"]) < 4 * sigma[12:15]).all()
    assert (np.abs(loop.nav["gyro_bias"] - truth["gyro_bias"]) < 4 * sigma[6:9]).all()
    assert abs(loop.nav["tau"] - 0.03) < 4 * sigma[15]
    assert sigma[15] < 0.5e-3
    said = capsys.readouterr().out
    assert float(re.search(r"the master is ([\d.]+) ms old", said)[1]) == pytest.approx(30, abs=1.5)
    assert said.count("\n") == 2  # no note: an empty line, and the last


def test_the_page_has_every_verdict():
    assert {name for name in re.findall(r"`([A-Z_]+)`", PAGE)} >= set(Verdict.__members__) - {"ABSENT"}
