"""Each part of a model knows the line that it was written in, and nothing else depends on it."""

import importlib.util
import os
from dataclasses import replace

from conftest import ROOT

PENDULUM = ROOT / "examples" / "pendulum.py"


def loaded(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.PENDULUM


def line(text):
    (found,) = [i for i, line in enumerate(PENDULUM.read_text().splitlines(), 1) if line.lstrip().startswith(text)]
    return f"{PENDULUM}:{found}"


def test_a_part_of_a_model_knows_the_line_that_makes_it(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    model = loaded(PENDULUM)
    assert model.where == line("PENDULUM = Model(")
    assert [state.where for state in model.states] == [line("angle = "), line("rate = ")]
    assert [struct.where for struct in model.structs] == [line("structs=(")] * 2
    assert model.measurements[0].where == line('Measurement("encoder"')


def test_a_file_below_the_current_folder_is_named_from_there(monkeypatch):
    monkeypatch.chdir(ROOT)
    assert loaded(PENDULUM).where.startswith(os.path.join("examples", "pendulum.py:"))


def test_the_line_is_no_part_of_the_value():
    model = loaded(PENDULUM)
    angle = replace(model.states[0])
    assert angle.where.startswith("tests/derive/test_where.py:") or __file__ in angle.where
    assert (angle, repr(angle), hash(angle)) == (model.states[0], repr(model.states[0]), hash(model.states[0]))
