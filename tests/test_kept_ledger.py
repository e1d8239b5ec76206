"""The command line prints a kept ledger; no test and no proof believes one."""

import json
import re
import shutil
from dataclasses import asdict
from pathlib import Path

import pytest
from typer.testing import CliRunner

from boresight import kept_ledger
from boresight.cli import app
from boresight.derive.ledger.entries import findings, ledger, unheld
from boresight.derive.papers import PAPERS, paper

PAPER = "kang-2025"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path))
    return tmp_path / "ledger"


@pytest.fixture
def calls(monkeypatch):
    """The papers that were computed, not read."""
    compute, seen = kept_ledger.compute, []
    monkeypatch.setattr(kept_ledger, "compute", lambda name, *more: seen.append(name) or compute(name))
    return seen


def computed(name):
    one = paper(name)
    entries = [asdict(entry) for entry in ledger(one)]
    texts = {"findings": list(findings(one)), "unheld": list(unheld(one))}
    texts |= {"conditions": [one.conditions.text, one.point.text], "refused": [], "labels": {}}
    return {"entries": entries, **texts}


def forge(folder):
    """Make an erratum exact in what is kept."""
    path = folder / f"{PAPER}.json"
    kept = json.loads(path.read_text())
    kept["made"]["entries"][5]["status"] = "exact"
    path.write_text(json.dumps(kept))


@pytest.mark.parametrize("name", PAPERS)
def test_a_kept_ledger_is_the_computed_one(name, folder, calls):
    assert kept_ledger.ledger(name) == kept_ledger.ledger(name) == computed(name)
    assert calls == [name]


def test_one_equation_is_a_row_of_the_ledger_and_taken_from_a_kept_one(folder, calls):
    seen = []
    alone, again = (kept_ledger.equation(PAPER, "3", lambda number, numbers: seen.append(numbers)) for _ in range(2))
    whole = kept_ledger.ledger(PAPER)
    kept = kept_ledger.equation(PAPER, "3", lambda number, numbers: seen.append(numbers))
    assert alone["entries"] == again["entries"] == kept["entries"] == [whole["entries"][2]] and calls == [PAPER]
    assert alone["conditions"] == whole["conditions"] and seen == [["1", "2", "3", "4", "5", "6"]] * 2


def test_a_forged_ledger_is_printed_and_seen_by_the_comparison(folder, calls):
    kept_ledger.ledger(PAPER)
    forge(folder)
    printed = json.loads(CliRunner().invoke(app, ["equations", PAPER, "--json"]).stdout)
    assert printed[5]["status"] == "exact" and computed(PAPER)["entries"][5]["status"] == "erratum"
    assert kept_ledger.ledger(PAPER) != computed(PAPER)
    assert calls == [PAPER]


def test_a_change_of_a_source_or_a_library_ends_what_is_kept(folder, calls, tmp_path, monkeypatch):
    kept_ledger.ledger(PAPER)
    forge(folder)
    versions = kept_ledger.version
    monkeypatch.setattr(kept_ledger, "version", lambda name: "0" if name == "sympy" else versions(name))
    assert kept_ledger.ledger(PAPER) == computed(PAPER)
    assert calls == [PAPER, PAPER]
    copy = Path(shutil.copytree(kept_ledger.DERIVE, tmp_path / "derive"))
    assert kept_ledger.key(copy) == kept_ledger.key()
    for changed in ("ledger/judge.py", "papers/kang_2025/witness.py", "papers/delay_error/derivation.toml"):
        before = kept_ledger.key(copy)
        (copy / changed).write_text((copy / changed).read_text() + "\n")
        assert kept_ledger.key(copy) != before


def test_a_kept_page_is_the_rendered_one_of_its_format_and_width(folder, monkeypatch):
    wanted = [("3", "text", 80), ("3", "text", 100), ("3", "html", 80), (None, "text", 80)]
    rendered, seen = kept_ledger.rendered, []
    monkeypatch.setattr(kept_ledger, "rendered", lambda *words: seen.append(words[1:]) or rendered(*words))
    for number, form, width in wanted * 2:
        monkeypatch.setenv("COLUMNS", str(width))
        assert kept_ledger.page(PAPER, number, form, width) == rendered(PAPER, number, form)
    assert seen == [(number, form) for number, form, _ in wanted]


def test_a_change_of_a_template_ends_what_is_kept(tmp_path):
    copy = Path(shutil.copytree(kept_ledger.DERIVE, tmp_path / "derive"))
    template = copy / "pages" / "templates" / "page.html.j2"
    template.write_text(template.read_text() + "\n")
    assert kept_ledger.key(copy) != kept_ledger.key()


@pytest.mark.parametrize("damage", ["", "{", "[]", '{"key": "0"}'])
def test_a_damaged_ledger_is_computed_anew(damage, folder, calls):
    folder.mkdir()
    (folder / f"{PAPER}.json").write_text(damage)
    assert kept_ledger.ledger(PAPER) == kept_ledger.ledger(PAPER) == computed(PAPER)
    assert calls == [PAPER] and [path.name for path in folder.iterdir()] == [f"{PAPER}.json"]


def test_where_nothing_can_be_kept_the_ledger_is_printed_all_the_same(tmp_path, monkeypatch):
    (tmp_path / "file").touch()
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "file"))
    assert kept_ledger.ledger(PAPER) == computed(PAPER)


def test_no_proof_reads_a_kept_ledger():
    """Only the command line does, and this test."""
    root = Path(__file__).parent.parent
    layers = ("derive", "codegen", "runtime", "analysis", "studies", "evidence", "tests")
    readers = {path.name for layer in layers for path in (root / layer).rglob("*.py") if reads(path)}
    assert readers == {Path(__file__).name}


def reads(path):
    return re.search(r"boresight(\.| import )kept_ledger", path.read_text()) is not None


def test_what_cannot_be_kept_leaves_nothing_behind(tmp_path, monkeypatch):
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path))
    (tmp_path / "page.json").mkdir()
    assert kept_ledger.kept("page", str, lambda: "text") == "text"
    assert [path.name for path in tmp_path.iterdir()] == ["page.json"]
