"""The committed results: a file for each generated folder and each paper, an entry for each kind of evidence."""

import json
from pathlib import Path
from typing import Any

from boresight.evidence.sources import Derivations, Examples, Flights, Folder
from boresight.runtime import manifest

PLACE = Path(__file__).resolve().parent / "results"


def sources_hash(folder: Folder | Derivations | Examples | Flights) -> str:
    """Of everything that a result depends on: of a folder its C, its headers, its tests; of a paper the derivations, of
    the examples all that makes and flies them."""
    return manifest.sources_hash(folder.sources)


def read(folder: Folder | Derivations | Examples | Flights) -> dict[str, Any]:
    """By kind of evidence: `sources` (the hash above), `tools`, and `units` by name.  Empty if nothing is committed."""
    path = PLACE / f"{folder.name}.json"
    return dict(json.loads(path.read_text())) if path.is_file() else {}


def write(folder: Folder | Derivations | Examples | Flights, results: dict[str, Any]) -> None:
    PLACE.mkdir(exist_ok=True)
    text = json.dumps(results, indent=1, sort_keys=True) + "\n"
    (PLACE / f"{folder.name}.json").write_text(text)
