"""The examples that people know: the fault that `verify` finds, and the filter of attitude in both its forms.

The flights of the autopilot and of the 21 errors are evidence: tests/evidence/test_examples_flown.py.
"""

import io
import re
import runpy
from contextlib import chdir, redirect_stdout

import numpy as np
import pytest
from building import passed, self_test
from conftest import ROOT
from test_docs import shown
from test_new import consistent

from boresight import CompiledFilter, cli, export, generate, load, verify
from boresight.codegen.verify import status as status_of

EXAMPLES = ROOT / "examples"


def ended(*words):
    """What a command prints, and its status."""
    out = io.StringIO()
    with redirect_stdout(out), pytest.raises(SystemExit) as end:
        cli.main(list(words))
    return out.getvalue(), end.value.code


def test_verify_finds_the_fault_as_its_page_shows_and_nothing_where_F_follows(tmp_path, monkeypatch, folder_of):
    monkeypatch.setenv("COLUMNS", "80")
    page = (ROOT / "docs/own-model.md").read_text()
    block = re.search(r"^```console\n(\$ boresight generate \S+wrong_axes.*?)^```$", page, re.MULTILINE | re.DOTALL)
    generating, verifying, *lines = block[1].splitlines()
    (tmp_path / "examples").symlink_to(EXAMPLES)
    with chdir(tmp_path):
        assert not ended(*generating.split()[2:])[1]
        printed, status = ended(*verifying.split()[2:])
        assert status == 1 and shown("\n".join(lines), printed), printed
    right = f"{EXAMPLES / 'wrong_axes.py'}:RIGHT"
    assert status_of(verify(right, folder_of(right), 100)) == 0


def test_the_fault_turns_the_uncertainty_with_the_body(folder_of):
    """Nothing is measured over a quarter of a turn about down: the errors stand, and so must P."""
    P, off = np.zeros((6, 6)), {}
    P[:3, :3] = np.diag(np.radians([5, 0.5, 0.5]) ** 2)
    imu = {"gyro": [0, 0, np.pi / 2], "dt": 0.01}
    for name in ("WRONG", "RIGHT"):
        library = load(folder_of(f"{EXAMPLES / 'wrong_axes.py'}:{name}"))
        loop = CompiledFilter(library, {"q": [1, 0, 0, 0], "gyro_bias": np.zeros(3)}, P)
        for _ in range(100):
            loop.predict(**imu, gyro_noise=np.zeros(3), bias_noise=np.zeros(3))
            loop.strapdown(**imu)
        off[name] = np.trace(np.linalg.solve(loop.P[:3, :3], P[:3, :3])) / 3  # the mean NEES of an axis
    assert abs(off["RIGHT"] - 1) < 1e-9
    assert abs(off["WRONG"] - (100 + 0.01 + 1) / 3) < 0.01


@pytest.mark.parametrize("form", ["SEVEN", "SIX"])
def test_the_filter_of_attitude_knows_how_wrong_it_is_and_its_export_tests_itself(form, tmp_path, monkeypatch):
    target = f"{EXAMPLES / 'ahrs.py'}:{form}"
    folder = generate(target, tmp_path / "generated").folder
    script = runpy.run_path(str(EXAMPLES / "fly_ahrs.py"))
    monkeypatch.setitem(script["fly"].__globals__, "SECONDS", 10)
    assert consistent(script["fly"](load(folder), 50))
    if form == "SIX":
        return  # the larger one's export is tried
    out = tmp_path / "exported"
    export(target, out, "float", folder)
    tried = self_test(out, tmp_path, "-DBORESIGHT_FLOAT")
    assert tried.returncode == 0 and passed(out) in tried.stdout, tried.stdout + tried.stderr
