"""The committed results: a file for each generated folder and each paper, an entry for each kind of evidence."""

import json
from pathlib import Path
from typing import Any

from boresight.codegen import proof
from boresight.codegen.folder import Folder
from boresight.evidence.sources import CrossChecks, Derivations, Drawn, Examples, Flights

Subject = Folder | CrossChecks | Derivations | Drawn | Examples | Flights
PLACE = proof.RESULTS
OPEN = PLACE / "open.txt"  # which results are of another text than what is here now, a line each


def place(of: Subject) -> Path:
    return proof.place(of) if isinstance(of, Folder) else PLACE / f"{of.name}.json"


def read(folder: Subject) -> dict[str, Any]:
    """By kind of evidence: `sources`, by unit a hash of all that its result depends on, `tools`, `units` by name, and
    of a folder `folder`, the hash of all its C that was there when each was found to be of it.  Empty if nothing is
    committed."""
    path = place(folder)
    return dict(json.loads(path.read_text())) if path.is_file() else {}


def write(folder: Subject, results: dict[str, Any]) -> None:
    path = place(folder)
    path.parent.mkdir(exist_ok=True)
    path.write_text(json.dumps(results, indent=1, sort_keys=True) + "\n")
