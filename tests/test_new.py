"""A model that `boresight new` began runs at once.

Every kind was verified, flown and exported by `make evidence`, which tests/evidence judges.
"""

import re
import runpy
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT
from scipy.stats import chi2

from boresight import BoresightError, cli
from boresight.codegen.generate import load_model
from boresight.codegen.new import KINDS, new

RARE = 1e-3  # of right filters are called wrong


def rare(total, freedom):
    """Whether a chi-square number of so many degrees of freedom is seldom so far out, on either side."""
    return bool(min(chi2.cdf(total, freedom), chi2.sf(total, freedom)) < RARE / 2)


def consistent(judged):
    """Whether errors are as large as the covariance says, and innovations as the filter expects."""
    runs, n = judged.errors.shape[1:]
    at = [len(judged.nees) // 3, -1]
    totals = [(judged.nees[k] * runs, n * runs) for k in at] + [judged.nis_sum(name) for name in judged.measurements]
    return not any(rare(*total) for total in totals)


def boresight(*words):
    with pytest.raises(SystemExit) as ended:
        cli.main([str(word) for word in words])
    assert not ended.value.code


@pytest.mark.parametrize("kind", ["total-state"])
def test_what_new_writes_is_generated_and_flown_as_it_is(tmp_path, monkeypatch, capsys, kind):
    monkeypatch.chdir(tmp_path)
    boresight("new", "my-first", "--kind", kind)
    boresight("generate", "my_first.py:MY_FIRST")
    assert consistent(runpy.run_path("fly_my_first.py", run_name="__main__")["judged"])
    assert "NEES" in capsys.readouterr().out
    assert (tmp_path / "my_first.png").stat().st_size > 10_000

    model = tmp_path / "my_first.py"
    model.write_text(model.read_text().replace("- damping * omega", "+ damping * omega"))
    with pytest.raises(SystemExit) as ended:
        cli.main(["verify", "my_first.py:MY_FIRST"])
    assert ended.value.code == 1
    said = " ".join(capsys.readouterr().out.split())
    assert "The C is not of my_first.py:MY_FIRST as it is now; 'boresight generate my_first.py:MY_FIRST'" in said


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_is_an_example_under_another_name(tmp_path, kind):
    example = KINDS[kind].replace("-", "_")
    for path in new("my-own", kind, tmp_path):
        before = (ROOT / "examples" / path.name.replace("my_own", example)).read_text().splitlines()
        differ = [now for old, now in zip(before, path.read_text().splitlines(), strict=True) if old != now]
        assert 0 < len(differ) < 10 and all(re.search("my-own|my_own|MY_OWN|mo", line) for line in differ)
        assert not re.search(rf"{example}\.(py|png)|\b{example.upper()}\b", path.read_text())
    model = load_model(f"{tmp_path / 'my_own.py'}:MY_OWN")
    assert (model.name, model.c_prefix) == ("my-own", "mo")
    assert model.kind == ("total-state" if kind == "total-state" else "error-state")


def test_a_paper_to_begin_with_runs_at_once_and_its_planted_slip_is_named(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    boresight("new", "my-paper", "--kind", "paper")
    boresight("equations", "my-paper")
    out = capsys.readouterr().out
    assert "my-paper: 2 equations, 1 exact, 1 erratum" in out and "True with one edit: sign of" in out
    boresight("equations", "my-paper", "2")
    assert "Planted: the first term has the other sign." in capsys.readouterr().out
    for name, says in (("my-paper", "my-paper/paper.toml exists"), ("kim-2018", "kim-2018 is a paper that comes with")):
        with pytest.raises(BoresightError, match=says):
            new(name, "paper", Path())


@pytest.mark.parametrize(
    ("name", "kind", "says"),
    [
        ("My", "ins", "'My' cannot name a model"),
        ("a_b", "ins", "'a_b' cannot name a model"),
        ("numpy", "ins", "numpy.py would hide Python's own module numpy"),
        ("azimuth-hold", "ins", "azimuth-hold is a built-in model"),
        ("mine", "total", "there is no kind 'total'; choose total-state, error-state, ins"),
    ],
)
def test_what_cannot_begin_is_one_line_and_leaves_nothing(tmp_path, name, kind, says):
    with pytest.raises(BoresightError, match=re.escape(says)):
        new(name, kind, tmp_path / "there")
    assert not (tmp_path / "there").exists()


@pytest.mark.parametrize("there", ["mine.py", "fly_mine.py"])
def test_nothing_is_overwritten(tmp_path, there):
    (tmp_path / there).write_text("x = 1\n")
    with pytest.raises(BoresightError, match=f"{there} exists; choose another name"):
        new("mine", "ins", tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == [there]


def test_without_matplotlib_the_numbers_are_printed_and_the_line_says_what_is_missing(tmp_path, monkeypatch):
    from boresight.analysis import consistency

    judged = consistency.Consistency({"height, m": 1.0})
    judged.error(1.0, np.array([[3.0], [-3.0]]), np.array([[4.0]]))
    monkeypatch.setattr(consistency, "find_spec", lambda name: None)
    assert "pip install" in judged.draw(tmp_path / "a.png") and not list(tmp_path.iterdir())
    assert re.search(r"height, m +3 +2\nNEES 2.25 of 1;", judged.report())


@pytest.mark.parametrize(("sigma", "right"), [(2.0, True), (1.8, False), (2.2, False)])
def test_a_covariance_that_is_wrong_by_a_tenth_of_its_sigma_is_seen(sigma, right):
    from boresight.analysis.consistency import Consistency
    from boresight.runtime.filter import Innovation

    rng, judged = np.random.default_rng(0), Consistency({"height, m": 1.0})
    for k in range(100):
        error = 2 * rng.standard_normal((500, 1))
        judged.error(k, error, np.array([[sigma**2]]))
        judged.innovation(k, "altitude", Innovation(error, np.full((500, 1), sigma**2), np.ones((500, 1), bool)))
    assert consistent(judged) is right
    low, high = judged.nis("altitude")[1]
    assert (low < judged.nis("altitude")[0] < high) is right and (judged.nees_inside > 0.8) is right
