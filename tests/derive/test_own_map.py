"""A paper of one's own tied to a model that makes C: what differs is named by its entry, what is not held listed."""

import shutil
from pathlib import Path

import pytest
from conftest import ROOT

from boresight import BoresightError, kept_ledger
from boresight.codegen.generate import load_model
from boresight.derive.ledger.entries import findings, ledger, unheld
from boresight.derive.pages.render import render
from boresight.derive.papers.own import own
from boresight.derive.papers.own_map import tied

LETTERS = r"""
"φ" = { latex = '\phi', value = "phi" }
"ω" = { latex = '\omega_{in}', value = "omega_in_n" }
"C" = { latex = 'C_b^n', value = "C_b2n" }
"F" = { latex = 'F', shape = [6, 6], unit = "3 rad/s, 3 rad/s by 3 rad, 3 rad" }
"B" = { latex = 'B', shape = [6, 3], unit = "3 rad/s, 3 rad/s by 3 rad/s" }
"q" = { latex = 'q^-', value = "quaternion(C_b2n_hat)" }
"y" = { latex = 'y', shape = 4 }
"""
ZERO = r"0_{3 \times 3}"
PRINT = rf"""
\begin{{equation}}
F = \begin{{bmatrix}} -[\omega_{{in}} \times] & {ZERO} \\ {ZERO} & {ZERO} \end{{bmatrix}} \tag{{1}}
\end{{equation}}
\begin{{equation}} B = \begin{{bmatrix}} C_b^n \\ {ZERO} \end{{bmatrix}} \tag{{2}} \end{{equation}}
\begin{{equation}} y = q^- \tag{{3}} \end{{equation}}
"""
MODEL = """
[model]
name = "euler-matching"
states = ["eps", "dmu"]
noises = ["-gyro_noise"]
inputs = { q_b2n_wxyz = "quaternion(C_b2n)" }
matches = { "1" = "F", "2" = "G" }
"""


def written(folder, model=MODEL, print_=PRINT):
    folder.mkdir(exist_ok=True)
    text = f'title = "Attitude"\nwitness = "strapdown-ned"\n[letters]{LETTERS}{model}'
    (folder / "paper.toml").write_text(text, encoding="utf-8")
    (folder / "printed.tex").write_text(print_, encoding="utf-8")
    return folder


def test_a_paper_that_a_model_flies_says_so_and_what_is_left(tmp_path):
    one = tied(written(tmp_path / "same"), load_model)
    assert findings(one) == ("euler-matching makes what (1), (2) say.",)
    assert [entry.status for entry in ledger(one)] == ["definition"] * 3
    definitions, left = (text for text in unheld(one) if "efinitions" in text or "beside" in text)
    assert definitions.endswith(": (3).")  # the others are held by the model
    assert "H of euler, z of euler," in left and left.endswith("feedback, omega_in_n.")
    text = render(one, None, "text")
    assert "In C: euler-matching" in text and "quaternion(C_b2n)" in text
    for form in ("html", "latex"):
        assert "euler-matching" in render(one, None, form)
    without = own(tmp_path / "same")  # where nothing makes models
    assert not without.maps and findings(without) == ()


@pytest.mark.parametrize(("old", "new", "found"), [
    ('"-gyro_noise"', '"gyro_noise"', "(2), B and G of euler-matching differ in [eps_n, gyro_noise_x] by 0.7"),
    ('["eps", "dmu"]', '["dmu", "eps"]', "(1), F and F of euler-matching differ in [dmu_x, dmu_y] by "),
    ('"quaternion(C_b2n)"', '"quaternion(T(C_b2n))"', "(2), B and G of euler-matching differ in [eps_n, gyro_noise_y]"),
    ('"2" = "G"', '"2" = "F"', "(2), B and F of euler-matching: 6x3 beside 6x6."),
])  # fmt: skip
def test_what_the_model_makes_otherwise_is_named(old, new, found, tmp_path):
    one = tied(written(tmp_path / "one", MODEL.replace(old, new)), load_model)
    assert any(text.startswith(found) for text in findings(one)), findings(one)


@pytest.mark.parametrize(("old", "new", "found"), [
    ("states", "staets", "14:1: no key 'staets' here (did you mean 'states'?); there are inputs, matches,"),
    ('"eps"', '"epz"', "euler-matching has no 'epz' (did you mean 'eps'?); its states are eps, dmu"),
    ('"eps", ', "", "3 of the 6 states of euler-matching are in its map"),
    ("q_b2n_wxyz", "q_b2n", "euler-matching has no input 'q_b2n' (did you mean 'q_b2n_wxyz'?)"),
    ("(C_b2n)", "(C_b2m)", "strapdown-ned has no 'C_b2m'"),
    ("quaternion(", "quat(", "no function is called 'quat'"),
    ('"2" = "G"', '"2" = "Z of euler"', "'Z of euler' is nothing that a model makes; write \"F\", \"G\", \"H of"),
    ('"2" = "G"', '"2" = "H of eulr"', "euler-matching has no measurement 'eulr' (did you mean 'euler'?)"),
    ('"2" = "G"', '"22" = "G"', "the paper has no equation '22' (did you mean '2'?)"),
    ('"quaternion(C_b2n)"', '"omega_in_n"', "q_b2n_wxyz of euler-matching has 4 components, its value 3"),
    ('"euler-matching"', '"euler"', "no model 'euler'"),
    ('"euler-matching"', '"own.py:X"', "own.py is not found"),
    ('{ "1" = "F", "2" = "G" }', '["1"]', "matches must be a table"),
])  # fmt: skip
def test_what_is_wrong_in_the_table_is_one_line(old, new, found, tmp_path):
    assert old in MODEL
    with pytest.raises(BoresightError) as raised:
        findings(tied(written(tmp_path / "one", MODEL.replace(old, new)), load_model))
    text = str(raised.value)
    assert found in text and "\n" not in text, text


@pytest.mark.parametrize(("more", "own_one"), [
    ('witness = "witness.py"', True), ('witness = "motion"', False),
    ('[model]\nname = "filter.py:F"', True), ('model = { "name" = "filter.py:F" }', True),
    ('[model]\nname = "euler-matching"', False), ("", False), ("[model", True),
])  # fmt: skip
def test_what_is_made_by_python_of_ones_own_is_not_kept(more, own_one, tmp_path):
    (tmp_path / "paper.toml").write_text(f'title = "A"\n{more}\n[letters]\n')
    assert kept_ledger.has_own_code(str(tmp_path)) == own_one


def test_a_model_of_ones_own_is_tied_by_its_file(tmp_path):
    """Its table wants no inputs: nothing that is matched reads any."""
    folder = tmp_path / "vertical"
    folder.mkdir()
    file = Path(shutil.copy(ROOT / "examples" / "vertical.py", folder))
    (folder / "paper.toml").write_text("""
title = "The vertical channel"
witness = "motion"
[letters]
"F" = { latex = 'F', shape = [3, 3] }
"h" = { latex = 'H', shape = [1, 3] }
[model]
name = "vertical.py:VERTICAL"
states = ["d_height", "d_speed", "-d_bias"]
matches = { "1" = "F", "2" = "H of altitude" }
""", encoding="utf-8")  # fmt: skip
    rows = r"\begin{bmatrix} 0 & 1 & 0 \\ 0 & 0 & 1 \\ 0 & 0 & 0 \end{bmatrix}"
    (folder / "printed.tex").write_text(
        rf"\begin{{equation}} F = {rows} \tag{{1}} \end{{equation}}"
        r"\begin{equation} H = \begin{bmatrix} 1 & 0 & 0 \end{bmatrix} \tag{2} \end{equation}",
        encoding="utf-8",
    )
    assert kept_ledger.ledger(str(folder))["findings"] == ["vertical makes what (1), (2) say."]
    file.write_text(file.read_text(encoding="utf-8").replace("[0, 0, -1]", "[0, 0, 1]"), encoding="utf-8")
    found = kept_ledger.ledger(str(folder))["findings"]  # is not kept, as nobody knows what the file reads
    assert found[1].startswith("(1), F and F of vertical differ in [d_speed, d_bias] by 2,")
