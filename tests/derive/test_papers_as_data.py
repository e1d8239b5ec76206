"""The papers that come with Boresight are read from files, and what is wrong in one is said with its place."""

import shutil
from collections.abc import Mapping

import pytest

from boresight import BoresightError
from boresight.derive.papers import DERIVATIONS, PAPERS, built_in, python
from boresight.derive.papers.macros import expanded
from boresight.derive.papers.toml import Toml

NAME = "kang-2025"


def read(tmp_path, monkeypatch, name=NAME):
    """The paper of a copy, with all that is read when it is asked for."""
    monkeypatch.setattr(built_in, "HERE", tmp_path)
    one = built_in.built_in.__wrapped__(name, python(name))
    return one, one.equations, one.letters(), one.maps


@pytest.fixture
def copy(tmp_path):
    return shutil.copytree(built_in.HERE / "kang_2025", tmp_path / "kang_2025")


@pytest.mark.parametrize(("file", "old", "new", "found"), [
    ("paper.toml", '["arm"]', '["arn"]', "64:1: no meaning 'arn' (did you mean 'arm'?)"),
    ("paper.toml", 'kind = "lever arm"', 'kynd = "lever arm"', "28:22: no key 'kynd' here (did you mean 'kind'?)"),
    ("paper.toml", 'latex = "v_S^n", ', "", "19:1: v_S has no latex: write latex = '...'"),
    ("paper.toml", 'unit = "rad"\nleft_out', "unit = 1\nleft_out", "95:1: unit must be a text"),
    ("paper.toml", '"m", shape', '"mm", shape', "mm is 0.001 m; declare m"),
    ("paper.toml", r"meant = 'a \sin", r"meant = 'q \sin", "104:1: a reading of (6) has no meant: cannot read"),
    ("paper.toml", '"H of dcm"', '"H on dcm"', "154:1: 'H on dcm' is nothing that a model makes; write"),
    ("paper.toml", 'name = "vel', 'nome = "vel', "116:1: no key 'nome' here (did you mean 'name'?)"),
    ("paper.toml", '[equations."6"]', '[equations."7"]', "103:1: printed.tex has no equation '7'; it has 1, 2"),
    ("paper.toml", '"witness.py"', "witness.py", "6:11: Invalid value"),
    ("printed.tex", r"\delta t_d - v_M^n", r"\delta t_e - v_M^n", r"10:102: cannot read '\delta t_e - v_M^n' in (3)"),
    ("printed.tex", r"\tag{2}", "", r"5:1: the equation has no number: add \tag{1}"),
    ("derivation.toml", "- C_S^e L'", "- C_T^e L'", "13:27: step 1 of (1): cannot read 'C_T^e L'"),
    ("derivation.toml", r"\byturn - v", r"\bytern - v", r"step 7 of (3): cannot read '\bytern - v_M^n'"),
    ("derivation.toml", '["delay"]', '["delai"]', "61:28: step 1 of (2): the witness has no error 'delai' (did you"),
    ("derivation.toml", '"limit"', '"limits"', "66:5: step 3 of (2): 'limits' is no claim (did you mean 'limit'?)"),
    ("derivation.toml", '"2" = [', '"22" = [', "61:3: step 1 of (22): printed.tex has no such equation; it has 1,"),
    ("derivation.toml", "macros.old", 'macros."old-1"', "8:1: 'old-1' is no name of a macro: letters alone"),
    ("derivation.toml", "macros.old", "macros.delta", "8:1: \\delta has a meaning of its own here; call the macro"),
    ("derivation.toml", 'latex = "r_m^e"', 'latix = "r_m^e"', "189:11: no key 'latix' here (did you mean 'latex'?)"),
])  # fmt: skip
def test_what_is_wrong_in_a_file_is_one_line_with_its_place(file, old, new, found, copy, tmp_path, monkeypatch):
    text = (copy / file).read_text(encoding="utf-8")
    assert old in text
    (copy / file).write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(BoresightError) as refused:
        read(tmp_path, monkeypatch)
    message = str(refused.value)
    assert f"/{file}:" in message and found in message and "\n" not in message


def keys(value, at=()):
    """Every place of what a TOML file says."""
    inside = value.items() if isinstance(value, Mapping) else enumerate(value) if isinstance(value, list) else ()
    for key, part in inside:
        yield (*at, key)
        yield from keys(part, (*at, key))


@pytest.mark.parametrize("name", [*PAPERS, *DERIVATIONS])
@pytest.mark.parametrize("file", ["paper.toml", "derivation.toml"])
def test_every_key_of_a_file_is_found_where_it_stands(name, file):
    toml = Toml(built_in.HERE / name.replace("-", "_") / file)
    for place in keys(toml.data):
        begin, value = toml.places[place]
        assert value >= begin
        if isinstance(place[-1], str):
            assert place[-1] in toml.text[begin:].split("\n")[0], place


def test_a_macro_stands_for_its_text_and_takes_arguments():
    macros = {"late": r"C(k - \delta)", "sum": r"#2 + #1"}
    assert expanded(r"\late \theta = \later", macros) == r"C(k - \delta) \theta = \later"
    assert expanded(r"\sum{a_{1}}{\late}(1)", macros) == r"C(k - \delta) + a_{1}(1)"
    with pytest.raises(ValueError, match="wants an argument"):
        expanded(r"\sum{a}", macros)
