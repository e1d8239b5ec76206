"""Tests ask for tools in tests/tools.py alone, by name; what is skipped says what to install."""

import ast
import os
import re
import subprocess
import sys

import pytest
import tools
from conftest import ROOT
from tools import TOOLS, needs, refused, started, why

TESTS = ROOT / "tests"
WHERE = {"needs", "given", "tool", "lacks"}
SKIPS = ("skip", "skipif", "importorskip")


def found(text):
    """(line, what stands there, what to write) of each tool that is named or looked for other than by tools.py."""
    tree = ast.parse(text)
    asked, looked = set(), {"which"}
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") in WHERE:
            asked |= {id(part) for part in ast.walk(node)}
        if isinstance(node, ast.ImportFrom):
            looked |= {"missing"} if node.module in ("boresight.evidence.targets", "boresight.evidence.bits") else set()
    for node in ast.walk(tree):
        name = getattr(node, "attr", getattr(node, "id", getattr(node, "name", "")))
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in asked:
            line = re.match(r"\S+(?=$| -)", node.value)  # a command, alone or with its options
            for command in started([line[0]] if line else []):
                yield node.lineno, repr(node.value), f'tool("{command}") or given("{command}")'
        elif isinstance(node, ast.Attribute | ast.alias) and (name in looked or "MISSING" in name):
            yield node.lineno, name, "needs(the tool's name)"
        elif isinstance(node, ast.Attribute) and name in SKIPS:
            yield node.lineno, ast.unparse(node), "needs(...), or lacks(...) of what is no tool"


def test_no_test_names_or_looks_for_a_tool_by_itself():
    lines = [
        f"{path.relative_to(ROOT)}:{line}: {what}; write {instead}"
        for path in sorted(TESTS.rglob("*.py"))
        if path.name not in ("tools.py", "test_tools.py", "quick.py", "__main__.py")  # and scripts
        for line, what, instead in found(path.read_text())
    ]
    assert not lines, "\n".join(lines)


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ('run("clang", "-O2")', 1),
        ('run(["/usr/bin/clang++", "-O2"])', 1),
        ('COMPILERS = ["gcc", "clang"]', 1),
        ('x = "arm-none-eabi-objdump -d"', 1),
        ('monkeypatch.setenv("CC", "clang -O2")', 1),
        ('run("make", "CC=clang")', 1),
        ('there = shutil.which("gappa")', 2),  # the search, and the name
        ("from shutil import which", 1),
        ("from boresight.evidence.targets import M4F\nx = M4F.missing", 1),
        ("from boresight.evidence.misra import MISSING as GONE", 1),
        ("x = eva.MISSING", 1),
        ('pytest.skip("no")', 1),
        ("@pytest.mark.skipif(gone, reason=words)\ndef test(): pass", 1),
        ('run(tool("clang"), "-O2")', 0),
        ('@needs("clang", "cmake")\ndef test(): pass', 0),
        ('X = ["gcc", given("clang", "-O2")]', 0),
        ('"""Built by gcc and clang."""', 0),
        ("x = tick.missing", 0),
    ],
)
def test_a_tool_that_is_named_or_looked_for_otherwise_is_seen(text, lines):
    assert len([*found(text)]) == lines


@pytest.mark.parametrize(
    "words", [["clang", "--version"], "clang --version", ["make", "CC=clang"], ["arm-none-eabi-ar"]]
)
def test_a_tool_that_is_started_unasked_fails_the_test(words):
    with pytest.raises(AssertionError, match=r"is started and not asked for: mark the test with needs"):
        subprocess.run(words, shell=isinstance(words, str), check=False)


def test_a_tool_that_is_not_in_the_table_is_refused():
    with pytest.raises(AssertionError, match="clnag is not in the table"):
        needs("clnag")


@pytest.mark.parametrize("name", TOOLS)
def test_a_missing_tool_says_what_to_do(name):
    assert tools.reason([name]).startswith(f"needs {name}: ") and not tools.reason([name]).endswith(": ")


def test_several_tools_are_installed_by_one_line():
    line = "needs clang, qemu-arm, clang++, x87: apt-get install clang qemu-user; a gcc for x86"
    assert tools.reason(["clang", "qemu-arm", "clang++", "x87"]) == line


class Report:
    def __init__(self, reason):
        self.longrepr = ("file", 1, f"Skipped: {reason}")


def test_a_skip_that_is_not_named_is_an_error():
    skipped = [Report(tools.reason(["frama-c"])), Report("a reason of its own")]
    assert [why(report) for report in skipped] == [["frama-c"], ["a reason of its own"]]
    assert refused(skipped[:1], 2, "cppcheck frama-c") == ""
    assert refused(skipped, 2, "frama-c").endswith("for want of a reason of its own")
    assert refused(skipped[:1], 2, "").endswith("for want of frama-c")
    assert refused(skipped, 40, "5%") == "" and refused(skipped, 39, "5%").startswith("5.1 % of the tests are skipped")


TINY = """
from tools import lacks, needs

def test_one():
    pass

def test_two():
    lacks("a lamp", "buy one")
"""


def test_a_run_ends_with_what_was_skipped_and_with_the_status_of_the_guard(tmp_path):
    (tmp_path / "test_tiny.py").write_text(TINY)
    command = [sys.executable, "-m", "pytest", "-q", "-p", "tools", "-p", "no:cacheprovider", "test_tiny.py"]
    env = {**os.environ, "PYTHONPATH": str(TESTS), "PYTEST_ADDOPTS": ""}  # not the guard's own
    for may_skip, status in (("lamp", 1), ("50%", 0)):
        done = subprocess.run(
            [*command, f"--may-skip={may_skip}"], cwd=tmp_path, env=env, capture_output=True, text=True
        )
        assert done.returncode == status, done.stdout + done.stderr
        assert "1 passed, 0 failed, 0 error, 1 skipped\n     1 skipped for want of a lamp\n" in done.stdout
        assert ("error: tests are skipped that may not be, for want of a lamp" in done.stdout) == bool(status)
