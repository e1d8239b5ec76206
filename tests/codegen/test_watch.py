"""`boresight watch`: what it says after each save, and what it leaves behind."""

import multiprocessing
import re
import shutil
import time
from pathlib import Path

import pytest
from conftest import ROOT

from boresight import BoresightError
from boresight.cli import main
from boresight.codegen import generate as g
from boresight.codegen import watch as w
from boresight.runtime.manifest import read_manifest


@pytest.fixture
def own(tmp_path, monkeypatch):
    """The pendulum as a user's own, whose damping comes from a file beside it."""
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "examples" / "pendulum.py").read_text()
    assert text.count("- damping * omega") == 1
    text = text.replace("- damping * omega", "- friction(damping, omega)")
    (tmp_path / "own.py").write_text(f"from resistance import friction\n{text}".replace("PENDULUM =", "SWING ="))
    (tmp_path / "resistance.py").write_text("def friction(damping, omega):\n    return damping * omega\n")
    return tmp_path


def test_each_save_is_told_and_generated_and_an_error_is_one_line(own):
    helper, folder = own / "resistance.py", own / "generated" / "pendulum"
    right = helper.read_text()
    said: list[str] = []
    steps = iter([
        (helper, right.replace("damping *", "2 * damping *")),
        (helper, right.replace("return", "return (")),
        (helper, right.replace("omega)", "theta)")),
        (helper, right.replace("damping *", "2 * damping *")),
    ])  # fmt: skip
    files = []

    def say(text):
        said.append(text)
        if text.startswith(("  golden", "resistance.py", "own.py")):
            files.append(folder.is_dir() and read_manifest(folder)["files"]["equations.json"])
            said.append("=#=")
            path, content = next(steps, (None, None))
            if path is None:
                raise KeyboardInterrupt
            path.write_text(content)

    with pytest.raises(KeyboardInterrupt):
        w.watch("own.py:SWING", say)
    first, edited, broken, wrong, same = (part.strip("\n") for part in "\n".join(said).split("=#=\n")[:5])
    assert first.startswith("pendulum: a pendulum, 2 states\n") and "F: new, 5 operations" in first
    assert "before\n    F_{omega,omega} = -damping\nafter\n    F_{omega,omega} = -›2‹⋅damping\n" in edited
    assert "  held against exact mechanics: F, G, encoder_H" in edited and "F: 5 -> 6 operations (+1)" in edited
    assert broken.startswith("resistance.py:2: ") and "\n" not in broken
    assert "name 'omega' is not defined" in wrong and "\n" not in wrong
    assert same.startswith("pendulum: the same equations\n") and "  no file changed\n" in same
    assert files[0] != files[1] == files[2] == files[4]
    assert not multiprocessing.active_children()


def test_files_are_never_left_half_written(own, monkeypatch):
    """A look is ended while it moves files, here slowly: both stand there afterwards."""

    def slowly(folder: Path, files: dict, stale: list) -> None:
        folder.mkdir(parents=True)
        (folder / "one").write_text("")
        time.sleep(0.5)
        (folder / "other").write_text("")

    monkeypatch.setattr(g, "write", slowly)
    folder = own / "generated" / "pendulum"
    with w.looking("own.py:SWING", "", multiprocessing.get_context("fork").Lock()) as answers:
        while not (folder / "one").exists():
            assert not answers.poll(0.01) or answers.recv()
    assert (folder / "other").exists()
    assert not multiprocessing.active_children()


def test_ctrl_c_ends_it_with_130(own, monkeypatch, capsys):
    def interrupted(files):
        raise KeyboardInterrupt

    monkeypatch.setattr(w, "settled", interrupted)
    with pytest.raises(SystemExit) as left:
        main(["watch", "own.py:SWING"])
    assert left.value.code == 130 and "Traceback" not in capsys.readouterr().err


@pytest.mark.parametrize("target", ["nowhere.py:SWING", "azimuth", "stationary-detector"])
def test_what_is_not_there_is_refused_at_once(target, own):
    with pytest.raises(BoresightError, match=r"not found|no model|comes from no model"):
        w.watch(target, print)


def test_what_may_change_is_watched_and_no_library(own):
    import numpy

    (own / "numbers.toml").write_text("")
    files = w.watched([str(own / "numbers.toml"), numpy.__file__, "/etc/hostname", str(own / "gone.py")])
    assert own / "numbers.toml" in files and ROOT / "codegen" / "generate.py" in files
    assert not [path for path in files if "site-packages" in path.parts or path.name in ("hostname", "gone.py")]


def test_of_a_paper_each_save_says_which_statuses_are_others_and_an_error_is_one_line(tmp_path):
    folder = tmp_path / "paper"
    shutil.copytree(ROOT / "examples" / "papers" / "first", folder)
    printed = folder / "printed.tex"
    slip, right = printed.read_text(), printed.read_text().replace("[\\omega", "-[\\omega")
    steps, said = iter([right, "\\begin{equation}", right]), []

    def say(text):
        said.append(text)
        if re.search(r"^  [\d.]+ s$|^/.*tex:", text):
            step = next(steps, None)
            if step is None:
                raise KeyboardInterrupt
            printed.write_text(step)

    with pytest.raises(KeyboardInterrupt):
        w.watch(str(folder), say)
    assert slip != right and said[0] == "(1) exact" and "(2) erratum sign" in said
    mended = said.index("(2) erratum sign -> first-order")
    assert said[mended + 1].startswith("    before  ") and said[mended + 2].startswith("    after   ")
    broken = next(text for text in said if text.startswith("/"))
    assert "printed.tex" in broken and "\n" not in broken
    assert said[-2] == f"{folder}: the same statuses"
