"""A study flown twice: as a revision has it, and as it is now."""

import json
import os
import shlex
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from rich.console import RenderableType

from boresight import BoresightError
from boresight.codegen import generate as g
from boresight.codegen.revision import worktree
from boresight.codegen.stamp import PACKAGE, made_from

EQUAL = 1e-12  # of two numbers that are taken for the same: another order of operations
MOST = 40  # results that are printed


def both_flown(words: str, revision: str, progress: Callable[[str], None]) -> dict[str, Any]:
    """`study`, its words; `before` and `after`, what it prints as JSON in the tree of the revision and in this one.

    Raises BoresightError on a study that does not run in one of them, and where the C is not that of the models.
    """
    if not g.is_checkout():
        raise BoresightError("--study needs Boresight's repository; this one was installed")
    if Path(revision).is_dir():
        raise BoresightError(f"--study needs a revision; {revision} is a folder")
    for name in g.model_names():
        if g.old_manifest(g.default_folder(name)).get("made_from") != made_from(g.source_of(name)):
            raise BoresightError(f"the C of {name} is not that of its model now; run 'boresight generate' first")
    progress(f"study {words}, in {revision} and now")
    with worktree(PACKAGE, revision) as old:
        underway = [started(folder, words) for folder in (old, PACKAGE)]
        before, after = (
            ended(process, words, where) for process, where in zip(underway, (revision, "this tree"), strict=True)
        )
    return {"study": words, "before": before, "after": after}


def started(folder: Path, words: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "boresight.cli", "study", *shlex.split(words), "--json"]
    env = {**os.environ, "PYTHONPATH": str(folder)}
    return subprocess.Popen(command, cwd=folder, env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def ended(process: subprocess.Popen[str], words: str, where: str) -> Any:
    printed, errors = process.communicate()
    try:
        return json.loads(printed)  # its exit status says whether it agrees with the paper
    except ValueError:
        last = (errors.strip().splitlines() or ["it printed nothing"])[-1]
        raise BoresightError(f"study {words} of {where}: {last.removeprefix('boresight: ')}") from None


def report(flown: dict[str, Any], revision: str) -> Iterator[RenderableType]:
    """Each result that differs, as it was and as it is; of very many those that differ most."""
    from boresight import terminal

    before, after = (dict(leaves(flown[key])) for key in ("before", "after"))
    rows = [(key, before.get(key), after.get(key)) for key in dict.fromkeys([*after, *before])]
    differing = [row for row in rows if apart(*row[1:]) > EQUAL]
    yield f"\nstudy {flown['study']}: {len(differing)} of {len(rows)} results differ"
    table = terminal.table("result", revision, "now", "by", prose="result", right=(revision, "now", "by"))
    for key, old, new in sorted(differing, key=lambda row: -apart(*row[1:]))[:MOST]:
        by = f"{new - old:+.3g}" if isinstance(old, int | float) and isinstance(new, int | float) else ""
        table.add_row(key, shown(old), shown(new), by)
    if differing:
        yield terminal.indented(table)
    if len(differing) > MOST:
        yield f"  and {len(differing) - MOST} more that differ less; --json has them all"


def leaves(value: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """Every number and word of a JSON document by its path."""
    if isinstance(value, dict | list):
        for key, item in value.items() if isinstance(value, dict) else enumerate(value, 1):
            yield from leaves(item, f"{path} {key}".strip())
    else:
        yield path, value


def apart(old: Any, new: Any) -> float:
    """How far two results are from one another, as part of the larger one."""
    if isinstance(old, int | float) and isinstance(new, int | float):
        return abs(new - old) / (max(abs(old), abs(new)) or 1)
    return 0.0 if old == new else 2.0


def shown(value: Any) -> str:
    return "-" if value is None else f"{value:.6g}" if isinstance(value, float) else str(value)
