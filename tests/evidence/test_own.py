"""The evidence of a model of one's own, as a user makes it and exports it."""

import json
import shutil

import pytest
from committed import folder_of

from boresight import BoresightError, export, generate
from boresight.codegen import proof
from boresight.codegen.folder import Folder
from boresight.evidence import own

NAME = "pendulum.py:PENDULUM"
SIX_AND_SIXTEEN = ("euler_matching", "velocity_attitude")  # states


@pytest.fixture
def model(tmp_path, monkeypatch, request):
    """The example in a folder of the user's, generated there."""
    shutil.copy(request.config.rootpath / "examples" / "pendulum.py", tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(own, "QUICK", ("trace", "rounding"))
    generate(NAME)
    return tmp_path


def test_it_is_made_kept_by_unit_and_exported(model, capsys, monkeypatch):
    place = own.make_own(NAME, quick=True)
    assert "not made of this C" in capsys.readouterr().out  # the other columns
    kept = proof.kept(Folder(place.with_name("pendulum")))
    assert kept.keys() == {"trace", "rounding"} and "pd_F" in kept["rounding"]["units"]
    own.make_own(NAME, quick=True)
    assert "trace: kept" in capsys.readouterr().out
    export(NAME, "c")
    written = json.loads((model / "c" / "evidence.json").read_text())
    assert written["evidence"] == kept and written["not_made"]["MISRA"] == "all"
    # of one form: what has the same text is taken over, of its own text it is made, in both precisions
    monkeypatch.setattr(own, "QUICK", ("rounding", "guards"))
    place = own.make_own(NAME, quick=True, form="ud")
    assert place.name == "pendulum-ud.evidence.json" and "rounding: kept" in capsys.readouterr().out
    export(NAME, "ud", form="ud")
    written = json.loads((model / "ud" / "evidence.json").read_text())
    assert (
        not written["evidence"]["guards"]["units"]["pd_covariance"]["wrong"] and "bad input" not in written["not_made"]
    )
    assert f"boresight evidence {NAME} --form ud" in written["make"]
    path = model / "generated" / "pendulum" / "selftest" / "test_pd_F.c"
    path.write_text(path.read_text() + "/* edited */\n")
    with pytest.raises(BoresightError, match="run 'boresight generate"):
        own.make_own(NAME, quick=True)


def test_a_built_in_model_has_its_own(model):
    with pytest.raises(BoresightError, match="'boresight export strapdown' writes it"):
        own.make_own("strapdown")


def test_a_quick_run_leaves_out_emulated_boards_where_they_take_minutes():
    names = {name: {kind.name for kind in own.chosen(folder_of(name), quick=True)} for name in SIX_AND_SIXTEEN}
    few, many = (names[name] for name in SIX_AND_SIXTEEN)
    assert "golden" in few and {"coverage", "stack", "guards", "riscv"} <= many == few - {"golden"}
