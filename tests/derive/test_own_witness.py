"""A paper of one's own may have a witness in Python, of the shape of those that come with Boresight."""

import shutil
from dataclasses import replace

import pytest

from boresight import BoresightError
from boresight.derive.ledger.entries import entry_of, findings, ledger
from boresight.derive.papers import built_in, of_folder, paper

pytestmark = pytest.mark.usefixtures("many_digits")

PAPER = r"""
title = "Range to a beacon"
witness = "witness.py"

[letters]
"r" = { latex = 'r', unit = "m", shape = 3 }
"δr" = { latex = '\delta r', unit = "m", shape = 3 }
"ρ" = { latex = '\rho', unit = "m" }
"ρ̂" = { latex = '\hat{\rho}', unit = "m" }
"""
PRINT = r"""
\begin{equation} \hat\rho - \rho = \frac{r^T I_3 \delta r}{\rho} \tag{1} \end{equation}
\begin{equation} \hat\rho - \rho = -\frac{r^T \delta r}{\rho} \label{eq:b} \end{equation}
"""
WITNESS = """
from dataclasses import dataclass

from boresight.derive.ledger.numbers import Matrix, norm
from boresight.derive.ledger.paper import Stated, Witness
from boresight.derive.ledger.witness import draw


@dataclass(frozen=True, eq=False)
class Base:
    place: tuple
    error: tuple


@dataclass(frozen=True)
class Sizes:
    place: float = 1000.0
    error: float = 50.0


def values(base, definitions):
    r, error = Matrix(base.place), Matrix(base.error)
    return {"r": r, "δr": error, "ρ": norm(r), "ρ̂": norm(r + error)}


USUAL = Sizes(error=5.0)
WITNESS = Witness(Base, values, Sizes(), ("error",), "points in space", {"error": "the error of the place"})
SIZES = Stated(USUAL, "errors to 5 m", 4)
POINT = Stated(draw(Base, 1, USUAL), "a point with an error to 5 m")
"""


def written(folder, old="", new="", toml=PAPER):
    assert old in WITNESS
    folder.mkdir(exist_ok=True)
    for name, text in (("paper.toml", toml), ("printed.tex", PRINT), ("witness.py", WITNESS.replace(old, new, 1))):
        (folder / name).write_text(text, encoding="utf-8")
    return folder


def test_its_values_judge_the_print(tmp_path):
    one = of_folder(written(tmp_path))
    first, second = ledger(one)
    assert (first.status, second.status, second.kind) == ("first-order", "erratum", "sign")
    assert "True with one edit" in second.found and one.equation("eq:b").number == "b"
    assert not findings(one) and one.equation("1").lines == (2, 2)
    float_is_a_number = written(tmp_path, '"ρ": norm(r)', '"ρ": 0.1')
    assert {entry.status for entry in ledger(of_folder(float_is_a_number))} == {"erratum"}


def test_a_paper_that_comes_with_boresight_is_read_alike_as_a_folder_of_ones_own(tmp_path):
    shutil.copytree(built_in.HERE / "kang_2025", tmp_path / "kang-2025")
    made = (paper("kang-2025"), of_folder(tmp_path / "kang-2025"))
    here, there = (entry_of(one, one.equation("6")) for one in made)
    keep = dict.fromkeys(("origin", "note", "found", "evidence"), "")
    assert replace(here, **keep) == replace(there, **keep) and here.found.split(". ")[0] in there.found


@pytest.mark.parametrize(("old", "new", "line", "found"), [
    ("WITNESS =", "WITNES =", 1, "WITNESS is missing (did you mean 'WITNES'?); it is a Witness of boresight"),
    ("SIZES = Stated", "SIZES = tuple", 28, "TypeError: tuple expected at most 1 argument, got 3"),
    ("SIZES = Stated(USUAL, ", "SIZES = (USUAL, ", 28, "SIZES is a tuple, not a Stated"),
    ("Stated(draw(Base, 1, USUAL)", "Stated(USUAL", 29, "POINT is at a Sizes, not at a Base"),
    ("    error: float = 50.0", "    errors: float = 50.0", 26, "TypeError: Sizes.__init__() got an unexpected"),
    ("Sizes(), (", "USUAL.place, (", 27, "no point can be drawn by the sizes of WITNESS: 'float' object"),
    ('("error",)', '("eror",)', 27, "WITNESS has the error 'eror', which is no part of Base (did you mean 'error'?)"),
    ('"δr": error, ', "", 27, "δr of (1) has no value (did you mean"),
    ('"ρ": norm(r)', '"ρ": r', 27, "ρ has the shape [3], in paper.toml []"),
    ('"ρ": norm(r)', '"ρ": "7"', 27, "ρ is a str, neither a number nor a Matrix"),
    ("norm(r + error)", "nrom(r)", 23, "NameError: name 'nrom' is not defined (did you mean 'norm'?)"),
    ("norm(r + error)", "{}[3]", 23, "KeyError: 3"),
    ("return {", "return {{", 23, "'{' was never closed"),
    ("norm(r + error)", "exit(3)", 23, "SystemExit: 3"),
    ("norm(r + error)", "norm(r) * id(r)", 27, "ρ̂ is another one when it is asked for again; draw it in Base"),
])  # fmt: skip
def test_what_is_wrong_in_it_is_one_line_with_its_place(old, new, line, found, tmp_path):
    with pytest.raises(BoresightError) as refused:
        of_folder(written(tmp_path, old, new))
    text = str(refused.value)
    assert f"/witness.py:{line}: " in text and found in text and "\n" not in text, text


def test_it_is_run_only_where_it_is_named_and_there(tmp_path):
    other = PAPER.replace("witness.py", "motion").replace("shape = 3", 'value = "v_n"')
    with pytest.raises(BoresightError, match=r"paper.toml:\d+:\d+: ρ has neither a value nor a shape"):
        of_folder(written(tmp_path, WITNESS, "raise SystemExit('it ran')", other))
    with pytest.raises(BoresightError, match=r"paper.toml:3:1: no witness 'other.py'; there are .*, and witness.py"):
        of_folder(written(tmp_path, toml=PAPER.replace("witness.py", "other.py")))
    (written(tmp_path) / "witness.py").unlink()
    with pytest.raises(BoresightError, match=r"paper.toml:3:1: .*witness.py is not there; it gives WITNESS, SIZES"):
        of_folder(tmp_path)
