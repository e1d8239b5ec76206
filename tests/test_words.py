"""Names and pages in the words of the field: what a reader would have to guess is no name, no argument, no prose."""

import ast
import re

import pytest
from conftest import ROOT

ROOMS = ("boresight", "derive", "codegen", "runtime", "analysis", "studies", "evidence", "benchmarks", "examples")
NOWHERE = {"said", "told", "heard", "push", "way", "pull", "world"}
NO_FUNCTION = {"moment", "again", "straight", "mixed", "outside", "moved"}
# Kept as they are until the code that has them is written anew: the live loop, and names that the C has too.
ELSEWHERE = ("runtime/transfer/", "evidence/flights/")
OF_THE_C = {("runtime/detector.py", "push"), ("benchmarks/detector.py", "push"), ("benchmarks/epoch.py", "push")}
IN_PROSE = re.compile(r"\b(told|heard|anew|of_runs)\b", re.IGNORECASE)
FLOWN_ANEW = {"docs/transfer-alignment.md", "docs/evidence.md"}  # as above


def names(text):
    """(line, name, whether it is a function's) of each name that a file gives or uses, arguments and attributes too."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            yield node.lineno, node.name, True
        elif isinstance(node, ast.Name | ast.Attribute):
            yield node.lineno, getattr(node, "id", getattr(node, "attr", "")), False
        elif isinstance(node, ast.arg | ast.keyword) and node.arg:
            yield node.lineno, node.arg, False


def private(text):
    return [
        (line, name) for line, name, function in names(text) if name in NOWHERE or (function and name in NO_FUNCTION)
    ]


@pytest.mark.parametrize("room", ROOMS)
def test_no_name_is_a_private_word(room):
    files = sorted((ROOT / room).rglob("*.py")) if room != "boresight" else sorted((ROOT / room).glob("*.py"))
    found = [
        f"{where}:{line}: {name}"
        for path in files
        if not (where := path.relative_to(ROOT).as_posix()).startswith(ELSEWHERE)
        for line, name in private(path.read_text())
        if (where, name) not in OF_THE_C
    ]
    assert files and not found, "\n".join(found)


def test_a_private_word_is_seen():
    text = "def moved(way): ...\nx.said = heard(told=1)\nmoved = straight"
    assert sorted(name for _, name in private(text)) == ["heard", "moved", "said", "told", "way"]


def test_the_pages_keep_to_the_words_of_the_field():
    pages = [
        ROOT / "README.md",
        ROOT / "CONTRIBUTING.md",
        *(ROOT / "docs").glob("*.md"),
        *(ROOT / "docs/how-to").glob("*.md"),
    ]
    found = [
        f"{path.relative_to(ROOT)}:{number}: {word[0]}"
        for path in pages
        if path.relative_to(ROOT).as_posix() not in FLOWN_ANEW
        for number, line in enumerate(path.read_text().splitlines(), 1)
        for word in IN_PROSE.finditer(line)
    ]
    assert not found, "\n".join(found)
