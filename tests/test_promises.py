"""What the tree promises of itself: what is committed is what its source makes, the C of every model is proven, and
style and types hold.  These are `boresight generate --check`, `boresight verify` and `make check`, one test each, so
that they run beside the others; a model is derived once for both.
"""

import subprocess
import sys

import pytest
from conftest import ROOT

from boresight.codegen import generate as g
from boresight.codegen import verify as v
from boresight.codegen.functions.units import units
from boresight.codegen.text import files

pytestmark = pytest.mark.usefixtures("quickly")


@pytest.fixture(scope="module", params=g.target_names())
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


def test_the_c_of_every_model_is_proven(made, monkeypatch):
    name, model, printed = made
    if model is None:
        return  # of no model: tests/runtime/test_detector.py holds it
    monkeypatch.setattr(v, "load_model", lambda _: model)
    monkeypatch.setattr(v, "units", lambda _: printed)
    checks = v.verify(name)
    assert {check.unit for check in checks} >= {unit.name for unit in printed}
    assert [check for check in checks if check.ok is False] == []


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
