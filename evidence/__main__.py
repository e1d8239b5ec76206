"""`make evidence`: what is out of date is computed anew, results and docs/evidence.md are written."""

import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from boresight.evidence import results
from boresight.evidence.golden import golden
from boresight.evidence.sources import Folder, folders
from boresight.evidence.targets import M4F

UNITS = dict[str, dict[str, Any]]


@dataclass(frozen=True)
class Kind:
    """One kind of evidence: tools names the version that its results hang on; missing says why it cannot be made."""

    name: str
    make: Callable[[Folder, Path], UNITS]
    missing: str
    tools: Callable[[], str]


KINDS = (Kind("golden", golden, M4F.missing, lambda: M4F.version),)


def main() -> int:
    names = sys.argv[1:]
    for folder in folders():
        if names and folder.name not in names:
            continue
        kept = results.read(folder)
        sources = results.sources_hash(folder)
        for kind in KINDS:
            if kind.missing:
                print(f"{folder.name}: {kind.name} skipped, {kind.missing}")
                continue
            before = kept.get(kind.name, {})
            if before.get("sources") == sources and before.get("tools") == kind.tools():
                continue
            start = time.perf_counter()
            with tempfile.TemporaryDirectory() as out:
                units = kind.make(folder, Path(out))
            kept[kind.name] = {"sources": sources, "tools": kind.tools(), "units": units}
            results.write(folder, kept)
            print(f"{folder.name}: {kind.name}, {time.perf_counter() - start:.1f} s", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
