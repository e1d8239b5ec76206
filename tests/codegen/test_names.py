"""Names of models, of their prefixes in C and of what they read: each is there once."""

import re
from pathlib import Path

import pytest
from conftest import PENDULUM, ROOT

from boresight import BoresightError
from boresight.codegen.generate import generate, model_names, target_names
from boresight.runtime.manifest import folder_of, read_manifest


def test_names_and_prefixes_are_those_of_one_model_alone():
    manifests = [read_manifest(folder_of(name)) for name in target_names()]
    assert [manifest["model"] for manifest in manifests] == target_names()
    prefixes = [manifest["c_prefix"] for manifest in manifests]
    assert len(set(prefixes)) == len(prefixes), sorted(prefixes)


def test_a_prefix_of_a_model_in_a_neighbouring_folder_is_refused_before_c_is_made(tmp_path, monkeypatch):
    text = Path(PENDULUM.rsplit(":", 1)[0]).read_text()
    for name in ("pendulum", "double-pendulum"):
        (tmp_path / f"{name[:6]}.py").write_text(text.replace('name="pendulum"', f'name="{name}"'))
    generate(f"{tmp_path}/pendul.py:PENDULUM", tmp_path / "one")
    monkeypatch.setattr("boresight.codegen.text.files.folder_files", lambda *_: pytest.fail("C is made"))
    with pytest.raises(BoresightError, match=r"double-pendulum: c_prefix 'pd' is that of pendulum in .*one"):
        generate(f"{tmp_path}/double.py:PENDULUM", tmp_path / "two")
    assert not (tmp_path / "two").exists()


def test_the_vocabulary_is_no_model_and_models_import_it_alone():
    """But where one is composed of another."""
    assert "variables" not in model_names()
    composed = {"azimuth_hold_reference": {"azimuth_hold"}, "velocity_attitude_lever": {"velocity_attitude"},
                "velocity_attitude_sensors": {"velocity_attitude", "velocity_attitude_lever"},
                "psi_error": {"phi_error"}}  # fmt: skip
    for name in (name.replace("-", "_") for name in model_names()):
        text = (ROOT / "derive" / "models" / f"{name}.py").read_text()
        found = re.findall(r"boresight\.derive\.models(?:\.(\w+)| import (\w+))", text)
        assert {one or other for one, other in found} - {"variables"} == composed.get(name, set()), name
