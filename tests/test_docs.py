"""What the tutorial and the how-to pages show runs, word for word and in order, in an empty folder.

A `python FILE` block is that file.  A plain `python` block runs, block after block in one namespace; a comment behind
its last print, or a `text` block, is what was printed.  In a `console` block a line behind `$` is run, and the lines
below it are what it prints: `...` stands for anything.
"""

import io
import os
import re
import shlex
import subprocess
import sys
from contextlib import chdir, contextmanager, redirect_stdout
from pathlib import Path

import pytest
from conftest import ROOT
from tools import TOOLS, tool

from boresight import cli
from boresight.runtime.store import BLOCK

OWN = [
    ROOT / "docs" / f"{name}.md"
    for name in ("tutorial", "from-nothing", "your-paper", "smoother", "observability", "design-questions")
]
PAGES = [*OWN, *sorted((ROOT / "docs" / "how-to").glob("*.md"))]
FENCED = re.compile(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def shown(expected, printed):
    """Whether the text is what was printed, where `...` stands for anything; how wide a gap is does not matter."""
    parts, printed = [" ".join(part.split()) for part in expected.split("...")], " ".join(printed.split())
    first, last = parts[0], parts[-1]
    if len(parts) == 1:
        return printed == first
    if not (printed.startswith(first) and printed.endswith(last)):
        return False
    at = len(first)
    for part in parts[1:-1]:
        at = printed.find(part, at) + len(part)
        if at < len(part):
            return False
    return at <= len(printed) - len(last)


def command(line):
    """What a command prints; boresight runs in this process."""
    words = shlex.split(line)
    if words[0] == "boresight":
        out = io.StringIO()
        with redirect_stdout(out), pytest.raises(SystemExit) as ended:
            cli.main(words[1:])
        assert not ended.value.code or "--need" in words, line  # 1: a need that is not met
        return out.getvalue()
    if words[0] in TOOLS:
        tool(words[0])  # what stands before it on the page has run
    env = {**os.environ, "PYTHONPATH": str(ROOT), "PATH": f"{os.path.dirname(sys.executable)}:{os.environ['PATH']}"}
    done = subprocess.run(line, shell=True, capture_output=True, text=True, env=env, check=False)
    assert done.returncode == 0, (line, done.stderr)
    return done.stdout + done.stderr


@contextmanager
def own_modules():
    """What a page imports of its folder is not there for the next page."""
    before = set(sys.modules)
    sys.path.insert(0, str(Path.cwd()))  # as a prompt in this folder has it
    yield
    sys.path.remove(str(Path.cwd()))
    for name in set(sys.modules) - before:
        if str(Path.cwd()) in str(getattr(sys.modules[name], "__file__", "")):
            del sys.modules[name]


def run(page, folder, text=None):
    """Every block of the page, or of the text in its place; the last names that its Python left."""
    names, printed = {"__name__": "page"}, ""
    with chdir(folder), own_modules():
        for language, file, block in FENCED.findall(text or page.read_text()):
            if file:
                (folder / file).write_text(block)
            elif language == "python":
                out = io.StringIO()
                with redirect_stdout(out):
                    exec(compile(block, page.name, "exec"), names)
                printed = out.getvalue()
                promised = re.search(r"print\(.*\)  # (.*)\n\Z", block)
                assert not promised or shown(promised[1], printed), (block, printed)
            elif language == "console":
                for line, expected in re.findall(r"^\$ ((?:.*\\\n)*.*)\n((?:(?!\$ ).*\n)*)", block, re.MULTILINE):
                    printed = command(line)
                    assert shown(expected, printed), (line, expected, printed)
            elif language == "text":
                assert shown(block, printed), (block, printed)
            else:
                raise AssertionError(f"{page.name}: a block of {language} that nothing runs")
    return names


# The page that flies many runs: what it shows, and what it does here.
FEWER = {
    "--runs 200": "--runs 20",
    "sea: 200": "sea: 20",
    "--runs 300": "--runs 30",
    "sea: 300": "sea: 30",
    "# 300 True": "# 30 True",
    f"sea: {BLOCK} runs": "sea: 64 runs",
}


@pytest.mark.digits
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_every_block_of_the_page_runs(page, tmp_path, monkeypatch):
    monkeypatch.setenv("COLUMNS", "100")
    text = page.read_text()
    if page.stem == "fly-many-runs":
        monkeypatch.setattr("boresight.runtime.runs.BLOCK", 64)
        assert f"This is tested after {BLOCK} runs" in text
        for shown, flown in FEWER.items():
            assert text.count(shown) == 1, shown
            text = text.replace(shown, flown)
        text, own = text.split("## An experiment of your own")
        run(page, tmp_path, text)
        plain = tmp_path / "cc"  # what the page's processes compile, they compile quickly too
        plain.write_text('#!/bin/sh\nexec gcc "$@" -O0\n')
        plain.chmod(0o755)
        monkeypatch.setenv("CC", str(plain))
        text = own
    run(page, tmp_path, text)


@pytest.mark.parametrize(
    ("expected", "printed", "right"),
    [
        ("a b", "a  b\n", True),
        ("a", "ab", False),
        ("a...c", "abc", True),
        ("a...b...a", "aba", True),
        ("a...b...a", "aa", False),
        ("ab...ba", "aba", False),
        ("...b", "abc", False),
    ],
)
def test_what_is_shown_is_held_against_what_was_printed(expected, printed, right):
    assert shown(expected, printed) is right


def test_a_block_that_does_not_run_or_prints_something_else_is_seen(tmp_path):
    page = tmp_path / "page.md"
    for text in (
        "```python\n1 / 0\n```\n",
        "```python\nprint(2)  # 3\n```\n",
        "```console\n$ echo 2\n3\n```\n",
        "```console\n$ false\n```\n",
        "```python\nprint(2)\n```\n\n```text\n3\n```\n",
        "```sh\nls\n```\n",
    ):
        page.write_text(text)
        with pytest.raises((AssertionError, ZeroDivisionError)):
            run(page, tmp_path)
