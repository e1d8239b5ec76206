"""What the tree promises of itself: what is committed is what its source makes, the C of every model is proven, and
style and types hold.

`boresight generate --check` and `boresight verify` of some models are run here, a model derived once for both.  Of the
others the manifest names the sources that made it, and the results of `verify` are evidence; `make generated` checks
all of them, as CI does.
"""

import subprocess
import sys

import pytest
from conftest import ROOT
from faults.__main__ import faults, place

from boresight.codegen import generate as g
from boresight.codegen import verify as v
from boresight.codegen.folder import folders
from boresight.codegen.functions.units import units
from boresight.codegen.text import files
from boresight.evidence import results
from boresight.evidence.kind import KINDS, kinds_for
from boresight.evidence.verified import by_unit

LIVE = ("strapdown", "stationary-detector", "euler-matching", "velocity-attitude")  # a component each, small, large
(VERIFIED,) = (kind for kind in KINDS if kind.name == "verified")


def folder_of(name):
    """Not read before a test runs: of a folder that was edited nothing can be read."""
    return next(folder for folder in folders() if folder.name == name.replace("-", "_"))


@pytest.fixture(scope="module", params=LIVE)
def made(request):
    """A target's name, its model and its printed units; None and nothing of a component."""
    if request.param in g.COMPONENTS:
        return request.param, None, []
    model = g.load_model(request.param)
    return request.param, model, units(model)


@pytest.mark.digits
def test_what_is_committed_is_what_its_source_makes(made, monkeypatch):
    name, model, printed = made
    monkeypatch.setattr(files, "units", lambda _: printed)
    report = g.generate(name, check=True, model=model)
    assert report.comparable, (
        f"other versions of {', '.join(g.VERSIONED)} than constraints.txt has: nothing can be said"
    )
    assert report.written == () and report.changes == () and report.strange == ()


@pytest.mark.parametrize("name", g.target_names())
def test_a_folder_was_made_by_the_sources_that_are_here(name):
    assert g.stamp(name).items() <= folder_of(name).manifest.items(), "run 'boresight generate'"


def test_the_c_of_a_model_is_proven(made, monkeypatch):
    name, model, printed = made
    if model is None:
        return  # of no model: tests/runtime/test_detector.py holds it
    monkeypatch.setattr(v, "load_model", lambda _: model)
    monkeypatch.setattr(v, "units", lambda _: printed)
    assert by_unit(v.verify(name)) == results.read(folder_of(name))["verified"]["units"]


@pytest.mark.parametrize("name", g.model_names())
def test_the_c_of_every_model_was_proven(name):
    """tests/evidence/test_results.py holds that it was this C."""
    folder = folder_of(name)
    assert VERIFIED in kinds_for(folder)
    found = results.read(folder)["verified"]["units"]
    assert found.keys() >= folder.manifest["units"].keys()
    assert [unit for unit, of in found.items() if False in of["checks"].values()] == []


def test_no_generated_file_was_edited():
    """By the hashes in the manifests: what `generate` asks before it writes."""
    folders = sorted(path.parent for path in (ROOT / "generated").glob("*/manifest.json"))
    assert len(folders) == len(g.target_names())
    for folder in folders:
        manifest = g.old_manifest(folder)
        assert g.edited(folder, manifest) == []
        assert g.strange_files(folder, {*manifest["files"], "manifest.json"}) == ()
        assert all((folder / path).is_file() for path in manifest["files"])


@pytest.mark.parametrize("words", ["ruff check .", "ruff format --check .", "mypy"])
def test_style_and_types_hold(words):
    done = subprocess.run([sys.executable, "-m", *words.split()], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_each_of_the_forty_faults_finds_its_line_and_names_the_tests_that_see_it():
    """Whether they do is for `python tests/faults run`, in some four minutes."""
    assert len(faults()) == 40
    for fault in faults():
        place(fault, ROOT)
        assert ("same" in fault) == (not fault["tests"]), fault
        for name, _, function in (word.partition("::") for word in fault["tests"] if word.startswith("tests/")):
            assert f"def {function}" in (ROOT / name).read_text(), fault
