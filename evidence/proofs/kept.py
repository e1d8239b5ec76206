"""The committed results of the proofs: a file for each folder, an entry for each unit.

They hang on the instruction list and the box alone, both of which the manifest's hash of the unit covers: the C around
a list may change, and its bounds stand.
"""

import json
from dataclasses import dataclass
from math import inf
from pathlib import Path
from typing import Any

from boresight.codegen.folder import Folder, Source
from boresight.derive.within import within

PLACE = Path(__file__).resolve().parent.parent / "results" / "proofs"
WITHIN = 10  # times the worst error found, by which a bound may be larger
# Of a model of more states, lists beyond so many operations are not tried: together they would take an hour.
LARGEST, LONGEST = 20, 300
NOTHING = 1e6  # and beyond this it says nothing, and counts as none


@dataclass(frozen=True)
class Output:
    """One output of a unit.  steps: values of the list that it depends on, itself among them; bound: None if there is
    none, and then `why`; found: the worst error of the search, None where nothing was searched."""

    name: str
    steps: int
    bound: float | None
    found: float | None
    why: str = ""

    @property
    def bounded(self) -> bool:
        """Whether there is a bound that says something."""
        most = NOTHING * self.found if self.found else inf
        return self.bound is not None and self.found is not None and within(self.bound, most)

    @property
    def tight(self) -> bool:
        """Whether the bound is within WITHIN times the worst error found."""
        return self.bound is not None and self.found is not None and self.bound <= WITHIN * self.found

    @property
    def ratio(self) -> float:
        """Of bound over worst error found; 1 where there is no rounding."""
        if not self.bound:
            return 1.0
        return self.bound / self.found if self.found else inf


def wanted(folder: Folder) -> list[Source]:
    """The units to bound: F, Phi, Qc, and z and H of each measurement."""
    described = [(unit, unit.described["name"]) for unit in folder.units if unit.described is not None]
    return [unit for unit, name in described if name in ("F", "Phi", "Qc") or name.endswith(("_z", "_H"))]


def read(folder: Folder) -> dict[str, dict[str, Any]]:
    """By unit: `list` (the manifest's hash), `tool`, `outputs`, and `coq` where Coq was asked."""
    path = PLACE / f"{folder.name}.json"
    return dict(json.loads(path.read_text())) if path.is_file() else {}


def write(folder: Folder, kept: dict[str, dict[str, Any]]) -> None:
    """One line an output."""
    PLACE.mkdir(parents=True, exist_ok=True)
    text = json.dumps(kept, indent=1, sort_keys=True)
    for unit in kept.values():
        for output in unit["outputs"]:
            text = text.replace(json.dumps(output, indent=1).replace("\n", "\n   "), json.dumps(output))
    (PLACE / f"{folder.name}.json").write_text(text + "\n")


def outputs(unit: dict[str, Any]) -> list[Output]:
    return [Output(*output) for output in unit["outputs"]]


def tried(unit: Source) -> bool:
    return len(unit.folder.manifest["states"]) <= LARGEST or (unit.operations or 0) <= LONGEST


def judged(folder: Folder) -> dict[str, list[Output]]:
    """By unit what is kept, and what has no bound because it was not tried."""
    found = {name: outputs(unit) for name, unit in read(folder).items()}
    for unit in wanted(folder):
        assert unit.described is not None
        if unit.name not in found and not tried(unit):
            why = f"not tried: {unit.operations} operations, in a model of {len(folder.manifest['states'])} states"
            count = sum(result["nonzeros"] for result in unit.described["results"])
            found[unit.name] = [Output(unit.name, unit.operations or 0, None, None, why)] * count
    return found


def of_another_list(folder: Folder) -> list[str]:
    """The units whose bounds are not of the list that is printed, and the kept ones that are not bounded any more."""
    found = read(folder)
    hashes = {u.name: u.described["hash"] for u in wanted(folder) if u.described and (tried(u) or u.name in found)}
    return sorted(name for name in {*hashes, *found} if hashes.get(name) != found.get(name, {}).get("list"))


def current(unit: Source, kept: dict[str, dict[str, Any]], tool: str) -> bool:
    assert unit.described is not None
    of = kept.get(unit.name, {})
    return bool(of.get("list") == unit.described["hash"] and of.get("tool") == tool)
