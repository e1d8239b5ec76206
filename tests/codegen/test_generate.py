"""Generated means generated: deterministic, checked, never half written, and only what changed."""

import hashlib
import json
import os
import shutil
import subprocess
import sys

import numpy as np
import pytest
from conftest import PENDULUM, ROOT

from boresight import BoresightError
from boresight.cli import main
from boresight.codegen.generate import generate, load_model, named
from boresight.codegen.stamp import made_from
from boresight.runtime.filter import Filter
from boresight.runtime.library import load


def contents(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def test_bytes_do_not_depend_on_the_hash_seed(pendulum_folder, tmp_path):
    """One is drawn for this process."""
    env = {**os.environ, "PYTHONHASHSEED": "77"}
    command = [sys.executable, "-m", "boresight.cli", "generate", PENDULUM, "-o", str(tmp_path / "77")]
    subprocess.run(command, cwd=ROOT, env=env, check=True, capture_output=True)
    assert contents(pendulum_folder) == contents(tmp_path / "77")


def test_python_and_the_command_line_name_a_model_alike():
    """By what it is bound to in its file, and not by its own name."""
    from pendulum import PENDULUM as model

    assert {named(one)[0].rpartition(":")[2] for one in (model, PENDULUM)} == {"PENDULUM"}


def commanded(*words):
    """What the command line ends with, run in this process."""
    with pytest.raises(SystemExit) as ended:
        main(list(words))
    return ended.value.code or 0


def test_no_date_host_or_path_in_what_is_generated():
    for path, content in contents(ROOT / "generated").items():
        text = content.decode()
        assert str(ROOT) not in text, path
        assert os.uname().nodename not in text, path
        assert not any(f"{year}-" in text for year in range(2020, 2040)), path


@pytest.mark.parametrize("place", ["the checkout", "a folder of it", "another folder"])
def test_the_generated_folder_of_the_checkout_is_found_from_any_folder(place, tmp_path, monkeypatch, capsys):
    folder = {"the checkout": ROOT, "a folder of it": ROOT / "docs", "another folder": tmp_path}[place]
    monkeypatch.chdir(folder)
    assert commanded("generate", "--check", "stationary-detector") == 0
    shown = "generated" if folder == ROOT else ROOT / "generated"
    assert capsys.readouterr().out == f"stationary-detector in {shown}/stationary_detector: nothing changed\n"
    assert not (folder / "generated").exists() or folder == ROOT


def test_an_edited_sign_changes_that_function_alone_and_moves_the_filter(checkout, library):
    copy, run = checkout
    source = copy / "derive" / "papers" / "song_lee_2001" / "results.py"
    text = source.read_text()
    right = "euler_D_eps(theta_b, psi_b), -euler_D_beta(phi_r, theta_r)"
    assert text.count(right) == 1
    source.write_text(text.replace(right, right.replace("-euler_D_beta", "euler_D_beta")))
    folder = copy / "generated" / "euler_matching"
    before = contents(folder)

    done = run("generate", "euler-matching")
    assert done.returncode == 0, done.stderr
    assert "euler_H: 28 -> " in done.stdout
    after = contents(folder)
    changed = {path for path in before | after if before.get(path) != after.get(path)}
    assert changed <= {
        "manifest.json", "equations.json", "include/euler_matching_identity.h",
        "src/em_euler_H.c", "src/em_euler_H_kernel.h",
        "casadi/em_euler_H_casadi.c", "casadi/em_euler_H_kernel.h",
        "selftest/test_em_euler_H.c",
    }  # fmt: skip
    assert "src/em_euler_H_kernel.h" in changed

    estimates = []
    for model in (library, load(folder)):
        loop = Filter(model, {"q_b2n_wxyz": [1.0, 0, 0, 0], "mu": np.zeros(3)}, 1e-3 * np.eye(6))
        loop.update("euler", np.full(3, 1e-6), euler_b=np.array([0.1, 0.05, 0.0]), euler_m=np.array([0.09, 0.06, 0.01]))
        estimates.append(loop.x)
    assert np.abs(estimates[0] - estimates[1]).max() > 1e-3

    again = run("generate", "euler-matching")
    assert "nothing changed" in again.stdout


def test_a_comment_in_a_model_changes_no_file(checkout):
    copy, run = checkout
    source = copy / "derive" / "models" / "euler_matching.py"
    source.write_text("# a remark\n" + source.read_text())
    before = contents(copy / "generated")
    assert "nothing changed" in run("generate", "euler-matching").stdout
    assert contents(copy / "generated") == before


def test_what_is_committed_is_known_to_be_up_to_date_without_being_made(checkout):
    copy, _ = checkout
    code = "import sys; from boresight.codegen.generate import generate, target_names; " \
        "assert all(generate(name).up_to_date for name in target_names()); " \
        "assert not {'sympy', 'casadi', 'numpy'} & set(sys.modules), 'imported'"  # fmt: skip
    subprocess.run([sys.executable, "-c", code], cwd=copy, check=True)


def test_a_forged_stamp_deceives_generate_but_no_check(checkout):
    """Of the component, which needs no SymPy to be made."""
    copy, run = checkout
    source = copy / "codegen" / "templates" / "src" / "stationary_detector.c.j2"
    text = source.read_text()
    assert text.count("yy += dy * dy") == 1
    source.write_text(text.replace("yy += dy * dy", "yy += dx * dy"))
    path = copy / "generated" / "stationary_detector" / "manifest.json"
    manifest = json.loads(path.read_text())
    code = "import json; from boresight.codegen.stamp import made_from; print(json.dumps(made_from(None)))"
    forged = subprocess.run([sys.executable, "-c", code], cwd=copy, check=True, capture_output=True, text=True).stdout
    assert json.loads(forged) != manifest["made_from"]
    path.write_text(json.dumps(manifest | {"made_from": json.loads(forged)}, indent=1, sort_keys=True) + "\n")
    before = contents(path.parent)
    assert "nothing changed" in run("generate", "stationary-detector").stdout
    checked = run("generate", "--check", "stationary-detector")
    assert checked.returncode == 1 and "stationary_detector: " in checked.stdout
    assert contents(path.parent) == before, "--check wrote something"


def test_a_stamp_is_moved_by_code_and_by_no_comment_and_no_place(tmp_path):
    hashes = []
    for folder, gravity in (("a", "9.81"), ("b", "9.81"), ("b", "1.62")):
        (tmp_path / folder).mkdir(exist_ok=True)
        (tmp_path / folder / "mine.py").write_text(
            f"import boresight.derive.mechanics.earth\nGRAVITY = {gravity}  # {folder}\n"
        )
        hashes.append(made_from(tmp_path / folder / "mine.py"))
    assert hashes[0] == hashes[1]
    assert hashes[1]["model"] != hashes[2]["model"]
    assert hashes[1]["generator"] == hashes[2]["generator"]


OWN = """
from pathlib import Path

from sympy import Matrix

from boresight.derive.model import Function, Model, Output, Struct, constant, variable
from spring_of_mine import stiffness

stretch = variable("stretch", "s", "m", "stretch", -1.0, 1.0)
rest = constant("rest", (Path(__file__).parent / "rest.txt").read_text(), "m", "length at rest")
force = Function("force", "force", (Output("N", Matrix([stiffness * (stretch.scalar - rest)]), "N", "force"),))
SPRING = Model(name="spring", c_prefix="sp", title="a spring", frame="none", states=(),
               structs=(Struct("given", "given", (stretch,)),), functions=(force,))
"""
STIFFNESS = """from boresight.derive.model import constant

stiffness = constant("k", "{}", "N/m", "stiffness")
"""


def test_a_model_of_ones_own_is_made_anew_by_all_that_its_file_reads_and_else_not_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "own.py").write_text(OWN)
    helper, data = tmp_path / "spring_of_mine.py", tmp_path / "rest.txt"
    helper.write_text(STIFFNESS.format("3"))
    data.write_text("2")
    assert generate("own.py:SPRING").changes
    manifest = json.loads((tmp_path / "generated" / "spring" / "manifest.json").read_text())
    assert manifest["made_from"]["read"] == ["rest.txt", "spring_of_mine.py"]
    for file, text, changed in (
        (helper, STIFFNESS.format("3") + "# a comment\n", False),
        (helper, STIFFNESS.format("30"), True),
        (data, "20", True),
        (tmp_path / "own.py", OWN + "# a comment\n", False),
        (tmp_path / "own.py", OWN.replace('"a spring"', '"an old spring"'), True),
    ):
        file.write_text(text)
        report = generate("own.py:SPRING")
        assert report.up_to_date != changed and bool(report.written) == changed, file
        assert generate("own.py:SPRING").up_to_date
    monkeypatch.setattr("boresight.codegen.text.files.folder_files", lambda *_: pytest.fail("it is derived"))
    assert generate("own.py:SPRING", tmp_path / "generated" / "spring").up_to_date
    with pytest.raises(pytest.fail.Exception):  # a check believes nothing
        generate("own.py:SPRING", check=True)


def test_nothing_heavy_is_imported_to_see_that_a_model_of_ones_own_is_unchanged(pendulum_folder):
    code = "import sys; from pathlib import Path; from boresight.codegen.generate import generate; " \
        f"assert generate({PENDULUM!r}, Path({str(pendulum_folder)!r})).up_to_date; " \
        "assert not {'sympy', 'casadi', 'numpy'} & set(sys.modules), 'imported'"  # fmt: skip
    subprocess.run([sys.executable, "-c", code], check=True)


def test_a_file_edited_by_hand_is_neither_overwritten_nor_flown(sd_copy):
    victim = sd_copy / "src" / "sd_earth_kernel.h"
    victim.write_text(victim.read_text() + "/* mine */\n")
    for attempt in (lambda: generate("strapdown", sd_copy), lambda: load(sd_copy)):
        with pytest.raises(BoresightError, match=r"sd_earth_kernel\.h was edited"):
            attempt()
    assert victim.read_text().endswith("/* mine */\n")
    victim.unlink()
    generate("strapdown", sd_copy)
    assert contents(sd_copy) == contents(ROOT / "generated" / "strapdown")


def test_after_generate_the_new_c_is_loaded(tmp_path):
    (tmp_path / "own.py").write_text(OWN)
    (tmp_path / "rest.txt").write_text("2")
    results = []
    for k in ("3", "30"):
        (tmp_path / "spring_of_mine.py").write_text(STIFFNESS.format(k))
        generate(f"{tmp_path / 'own.py'}:SPRING", tmp_path / "out")
        results.append(load(tmp_path / "out").force(stretch=0.5)[0])
    np.testing.assert_allclose(results, [3 * (0.5 - 2), 30 * (0.5 - 2)], rtol=1e-14)


def test_a_model_of_ones_own_is_generated_where_one_stands(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    shutil.copy(ROOT / "tests" / "pendulum.py", tmp_path)
    assert commanded("generate", "pendulum.py:PENDULUM") == 0
    manifest = json.loads((tmp_path / "generated" / "pendulum" / "manifest.json").read_text())
    assert manifest["states"] == ["angle", "rate"]
    capsys.readouterr()
    assert commanded("verify", "pendulum.py:PENDULUM", "--json") == 3  # nothing exact is known of its energy
    # G, held against exact mechanics, has no function of its own; what is stated alone is listed
    stated = {"equations", "constants", "noise"}
    assert {check["unit"] for check in json.loads(capsys.readouterr().out)} == {*manifest["units"], "G"} | stated


def test_other_versions_are_not_comparable(em_copy, capsys):
    path = em_copy / "manifest.json"
    manifest = json.loads(path.read_text())
    manifest["versions"]["casadi"] = "0.0.1"
    path.write_text(json.dumps(manifest))
    assert commanded("generate", "--check", "euler-matching", "-o", str(em_copy)) == 3
    assert "not comparable" in capsys.readouterr().out


def test_what_another_version_made_of_the_same_equations_is_told_before_it_is_written(sd_copy, capsys):
    """And not where the model has changed, whose operations may."""
    path, code = sd_copy / "manifest.json", contents(sd_copy)
    manifest = json.loads(path.read_text())
    manifest["version"] = "0.0.1"
    manifest["units"]["step"] |= {"hash": "0" * 64, "operations": 7}
    told = []
    for model in ("0" * 64, manifest["made_from"]["model"]):
        path.write_text(json.dumps(manifest | {"made_from": manifest["made_from"] | {"model": model}}))
        generate("strapdown", sd_copy, tell=lambda line: told.append((line, json.loads(path.read_text())["version"])))
        assert contents(sd_copy) == code
    ((line, still),) = told
    assert (
        still == "0.0.1"
        and "since Boresight 0.0.1 made it" in line
        and "is here: step: 7 -> 410 operations (+403)" in line
    )
    path.write_text(json.dumps(manifest))
    assert commanded("generate", "strapdown", "-o", str(sd_copy)) == 0
    assert capsys.readouterr().err == f"{line}\n"


@pytest.mark.parametrize(
    ("target", "said"),
    [
        ("eular-matching", "there are .*euler-matching"),
        ("nowhere.py:MODEL", "not found"),
        (f"{ROOT / 'tests' / 'pendulum.py'}:PENDULUM2", "its models are PENDULUM"),
        (f"{ROOT / 'tests' / 'pendulum.py'}:GRAVITY", "not a Model"),
    ],
)
def test_a_wrong_target_is_named_with_the_right_ones(target, said, tmp_path):
    with pytest.raises(BoresightError, match=said):
        generate(target, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_user_file_that_fails_is_one_line(tmp_path):
    file = tmp_path / "broken.py"
    file.write_text("1 / 0\n")
    with pytest.raises(BoresightError, match=r"broken\.py:1: ZeroDivisionError"):
        load_model(f"{file}:MODEL")


def test_a_folder_that_cannot_be_written_is_one_line_and_nothing_half_written(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(BoresightError, match="cannot write to"):
        generate(PENDULUM, tmp_path / "file" / "below")
    assert [p.name for p in tmp_path.iterdir()] == ["file"]


def test_a_function_that_is_gone_leaves_no_file(tmp_path):
    text = (ROOT / "tests" / "pendulum.py").read_text()
    file = tmp_path / "mine.py"
    file.write_text(text)
    generate(f"{file}:PENDULUM", tmp_path / "out")
    file.write_text(text.replace("functions=(\n", "functions=() and (\n"))
    report = generate(f"{file}:PENDULUM", tmp_path / "out")
    assert [str(c) for c in report.changes] == ["energy: removed, 9 operations"] or report.changes[0].after is None
    assert not list((tmp_path / "out").rglob("*energy*"))


def test_a_renamed_struct_reaches_the_golden_vectors(tmp_path):
    file = tmp_path / "own.py"
    (tmp_path / "rest.txt").write_text("2")
    (tmp_path / "spring_of_mine.py").write_text(STIFFNESS.format("3"))
    for name in ("given", "clock"):
        file.write_text(OWN.replace('Struct("given"', f'Struct("{name}"'))
        generate(f"{file}:SPRING", tmp_path / "out")
    generate(f"{file}:SPRING", tmp_path / "afresh")
    assert "clock" in (tmp_path / "out" / "selftest" / "test_sp_force.c").read_text()
    assert contents(tmp_path / "out") == contents(tmp_path / "afresh")


def test_the_manifest_lists_every_file():
    folder = ROOT / "generated" / "euler_matching"
    manifest = json.loads((folder / "manifest.json").read_text())
    found = {path: hashlib.sha256(content).hexdigest() for path, content in contents(folder).items()}
    del found["manifest.json"]
    assert found == manifest["files"]


def test_the_documented_example_of_a_model_works(tmp_path):
    folder = tmp_path / "tank"
    generate(f"{ROOT / 'examples' / 'own_model.py'}:TANK", folder)
    tank = load(folder)
    # Torricelli's law, differentiated: F = -drain / area * sqrt(g / (2 depth))
    F = tank.F(x=[1.0, 0.2], tank=[2.0, 0.05])
    np.testing.assert_allclose(F, [[-0.05 / 2 * np.sqrt(9.81 / 2), 0], [0, 0]], rtol=1e-14)
    np.testing.assert_array_equal(tank.reading_H(), [[1, 1]])


def test_what_judges_and_shows_a_model_is_not_loaded_to_generate_it():
    """So that the stamps of its folder need not name it; but for the words of errors, which stand beside all.

    Every model's module is loaded, and two of them are made.
    """
    code = (
        "import importlib, sys; from boresight.codegen.generate import load_model, model_names; "
        "from boresight.codegen.stamp import BESIDE; import boresight.codegen.text.files; "
        "[importlib.import_module('boresight.derive.models.' + name.replace('-', '_')) for name in model_names()]; "
        "[load_model(name) for name in ('euler-matching', 'velocity-dcm')]; "
        "print([name for name in sys.modules if BESIDE.match(name)])"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout == "['boresight.errors']\n"
