"""Ledgers as the command line prints them: computed once, and kept in the cache folder until a source changes.

Only the command line reads what is kept.  Tests and evidence call `compute`, or boresight.derive.ledger.entries itself.
"""

import hashlib
import json
import os
import sys
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

from boresight.runtime.manifest import cache_folder

Progress = Callable[[int, int, str], None]  # how many are done, of all, and the last one
DERIVE = Path(__file__).parent / "derive"


def compute(paper: str, progress: Progress = lambda done, total, text: None) -> dict[str, Any]:
    """`entries`, the rows of `boresight equations PAPER --json`, `findings`, the sentences beside them, and
    `conditions`: what the sizes hold for, and the point at which errata are computed."""
    from boresight.derive import papers
    from boresight.derive.ledger.entries import findings, ledger

    one = papers.paper(paper)
    entries = [entry.to_dict() for entry in ledger(one, progress)]
    return {"entries": entries, "findings": list(findings(one)), "conditions": [one.conditions.text, one.point.text]}


def ledger(paper: str, progress: Progress = lambda done, total, text: None) -> dict[str, Any]:
    """As `compute` gives it, from the cache folder if nothing that reaches it has changed."""
    path, now = cache_folder() / "ledger" / f"{paper}.json", key()
    try:
        kept = json.loads(path.read_text(encoding="utf-8"))
        if kept["key"] == now:
            return {name: kept[name] for name in ("entries", "findings", "conditions")}
    except (OSError, ValueError, LookupError, TypeError):
        pass  # nothing is kept, or it is damaged
    made = compute(paper, progress)
    part = path.with_suffix(f".{os.getpid()}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        part.write_text(json.dumps({"key": now} | made, ensure_ascii=False), encoding="utf-8")
        part.replace(path)
    except OSError:
        pass  # a folder that cannot be written costs time, no result
    return made


def key(derive: Path = DERIVE) -> str:
    """A hash of all that reaches a ledger: every source of derive, this file, the libraries and Python."""
    digest = hashlib.sha256(repr(sys.version_info[:2]).encode())
    for name in ("sympy", "mpmath", "python-flint"):
        digest.update(f"{name} {version(name)}\n".encode())
    for path in (Path(__file__), *sorted(derive.rglob("*.py"))):
        content = path.read_bytes()
        digest.update(f"{path.name} {len(content)}\n".encode() + content)
    return digest.hexdigest()
