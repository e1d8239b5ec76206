"""A shipped self-test assumes of a model what every model has, not what the built-in ones happen to have.

`python -m boresight.evidence.drawn` tries fifty of them, of which ten are evidence.
"""

import pytest
from conftest import PENDULUM

from boresight import BoresightError, export, generate
from boresight.codegen import export as exporting
from boresight.evidence import results
from boresight.evidence.drawn import NUMBERS, drawn
from boresight.evidence.sources import Drawn


@pytest.mark.parametrize("precision", ["double", "float"])
def test_the_self_test_of_a_drawn_model_passes(precision, tmp_path):
    model = drawn(6)  # total, in little time
    generate(model, tmp_path / "made")
    assert export(model, tmp_path / "out", precision, tmp_path / "made").files  # which runs it


def test_ten_passed_when_the_evidence_was_made():
    kept = results.read(Drawn())["drawn"]["units"]
    assert set(kept) == set(NUMBERS) and {of[p] for of in kept.values() for p in ("double", "float")} == {"passes"}


def test_an_export_whose_self_test_fails_is_refused_and_nothing_is_written(pendulum_folder, tmp_path, monkeypatch):
    manifest = exporting.read_manifest(pendulum_folder)
    paths = (path for path in manifest["files"] if path.endswith((".c", ".h", ".inc")))
    files = {path: (pendulum_folder / path).read_text() for path in paths}
    names = {"name": manifest["model"], "snake": manifest["model"], "prefix": manifest["c_prefix"]}
    files |= exporting.identity_files(files, names, True, "double")[0]
    exporting.check_self_test(files, "double")
    kernel = "src/pd_tip_hx_kernel.h"
    files[kernel] = files[kernel].replace("BS_SIN", "BS_COS", 1)
    with pytest.raises(BoresightError, match=r"self-test fails on this machine .*tip_h"):
        exporting.check_self_test(files, "double")
    check = exporting.check_self_test
    monkeypatch.setattr(exporting, "check_self_test", lambda _, precision: check(files, precision))
    with pytest.raises(BoresightError, match="self-test fails"):
        export(PENDULUM, tmp_path / "out", "double", pendulum_folder)
    assert not any(tmp_path.iterdir())
