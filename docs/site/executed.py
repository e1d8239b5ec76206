"""Python and commands that run while the site is built: what they print and draw stands below them."""

import io
import json
import re
import shutil
import subprocess
import sys
from contextlib import chdir, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from matplotlib import rc_context

from boresight.analysis.figures import STYLE

BLOCK = re.compile(r"^```python(?: (\S+))?\n(.*?)^```\n(?:```text\n.*?^```\n)?", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Ran:
    """A block, what it printed, and the pictures that it left."""

    code: str
    printed: str
    pictures: tuple[Path, ...]


def pictures(folder: Path) -> list[Path]:
    return [path for path in folder.iterdir() if path.suffix in (".png", ".svg")]


def ran(code: str, names: dict[str, Any], folder: Path) -> Ran:
    """A block of Python in a folder, with the names of the blocks before it."""
    before, out = set(pictures(folder)), io.StringIO()
    sys.path.insert(0, str(folder))
    try:
        with chdir(folder), redirect_stdout(out), rc_context(STYLE):
            exec(compile(code, "block", "exec"), names)
    finally:
        sys.path.remove(str(folder))
    return Ran(code, out.getvalue(), tuple(sorted(set(pictures(folder)) - before)))


def page(text: str, folder: Path, shown: Path, prefix: str = "") -> tuple[str, str]:
    """A page whose blocks have run, and the same as a notebook.

    A ```python FILE block is that file.  shown: where pictures are copied to; prefix: how the page names that folder.
    """
    names: dict[str, Any] = {"__name__": "page"}
    cells: list[dict[str, Any]] = []
    parts: list[str] = []
    end = 0
    for block in BLOCK.finditer(text):
        prose, (file, code) = text[end : block.start()], block.groups()
        cells += [cell("markdown", prose)] if prose.strip() else []
        parts += [prose, f"```python\n{code}```\n"]
        end = block.end()
        if file:
            (folder / file).write_text(code, encoding="utf-8")
            cells.append(cell("code", f"%%writefile {file}\n{code}"))
            continue
        done = ran(code, names, folder)
        cells.append(cell("code", code, done.printed))
        parts += [f"```text\n{done.printed}```\n"] if done.printed else []
        for picture in done.pictures:
            shutil.copy(picture, shown)
            parts.append(f"\n![drawn by the lines above]({prefix}{picture.name})\n")
    cells += [cell("markdown", text[end:])] if text[end:].strip() else []
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    notebook = {"nbformat": 4, "nbformat_minor": 4, "metadata": kernel, "cells": cells}
    return "".join([*parts, text[end:]]), json.dumps(notebook, indent=1, ensure_ascii=False)


def cell(kind: str, text: str, printed: str = "") -> dict[str, Any]:
    """One of a notebook."""
    made: dict[str, Any] = {"cell_type": kind, "metadata": {}, "source": text.strip("\n")}
    if kind == "code":
        out = {"output_type": "stream", "name": "stdout", "text": printed}
        made |= {"execution_count": None, "outputs": [out] if printed else []}
    return made


def command(*words: str, folder: Path) -> tuple[str, int]:
    """What `boresight WORDS` prints in a folder, and its exit status."""
    run = [sys.executable, "-c", "import sys; from boresight.cli import main; main(sys.argv[1:])", *words]
    done = subprocess.run(run, cwd=folder, capture_output=True, text=True, check=False)
    return done.stdout + done.stderr, done.returncode
