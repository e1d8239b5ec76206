"""The command line as its user meets it: help, JSON and nothing else, one line for what is wrong."""

import json
import subprocess
import sys

import pytest
from conftest import ROOT


def run(*words):
    command = [sys.executable, "-m", "boresight.cli", *map(str, words)]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


def test_help_names_every_command():
    done = run("--help")
    assert done.returncode == 0
    for command in ("models", "equations", "show", "generate", "verify", "study", "replay", "export"):
        assert command in done.stdout


def test_models_as_json():
    listed = {model["model"]: model for model in json.loads(run("models", "--json").stdout)}
    assert "stationary-detector" not in listed, "a kernel is no model"
    model = listed["euler-matching"]
    assert model["states"] == ["eps_n", "eps_e", "eps_d", "dmu_x", "dmu_y", "dmu_z"]
    assert set(model["measurements"]) == {"euler", "euler_exact"}


def test_equations_as_json_have_the_documented_fields():
    entries = json.loads(run("equations", "song-lee-2001", "--json").stdout)
    assert [entry["number"] for entry in entries] == [str(k) for k in range(1, 29)]
    fields = {"paper", "number", "status", "kind", "origin", "printed", "derived", "note", "evidence"}
    for entry in entries:
        assert set(entry) == fields
        assert entry["status"] in ("exact", "first-order", "definition", "erratum")
        assert bool(entry["kind"]) == bool(entry["origin"]) == (entry["status"] == "erratum")


def test_show_prints_a_derivation_and_a_model_shows_its_own():
    for words in (("song-lee-2001", "19"), ("euler-matching", "19")):
        done = run("show", *words)
        assert done.returncode == 0, done.stderr
        assert "19" in done.stdout


def test_show_prints_the_closed_form_of_an_unknown_delay():
    done = run("show", "delay-error", "--format", "html")
    assert done.returncode == 0, done.stderr
    assert "angular momentum" in done.stdout


def test_study_as_json():
    done = run("study", "euler-table", "--runs", 4, "--json")
    assert done.returncode in (0, 1), done.stderr
    result = json.loads(done.stdout)
    assert result["cells"] == 147
    assert result["linear"]["agree"] == 147


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("equations", "song-lee-2002"), "there are song-lee-2001"),
        (("show", "song-lee-2001", "29"), "29"),
        (("show", "nothing"), "there are song-lee-2001"),
        (("show", "song-lee-2001", "--format", "word"), "there are"),
        (("show", "song-lee-2001", "--format", "pdf"), "-o"),
        (("generate", "eular"), "euler-matching, "),
        (("verify", "eular"), "euler-matching"),
        (("study", "eular"), "there are azimuth-hold, euler-table"),
        (("study", "euler-table", "--runs", "0"), "runs"),
        (("study", "euler-table", "--switch", "sideways"), "there are"),
        (("replay", "nowhere.npz"), "nowhere.npz"),
        (("replay", "pyproject.toml"), "pyproject.toml"),
        (("show", "song-lee-2001", "-o", "pyproject.toml/below"), "cannot write"),
    ],
)
def test_what_is_wrong_is_one_line_and_a_status(words, said):
    done = run(*words)
    assert done.returncode not in (0, None)
    assert said in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1, done.stderr
    assert done.stdout == ""
