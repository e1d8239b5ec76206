"""What a change costs: flash of each unit, RAM, stack of each entry point, instructions and operations of two exported
folders, as Markdown."""

import json
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from boresight import BoresightError
from boresight.codegen.folder import Folder
from boresight.evidence.stack import built, structs
from boresight.evidence.targets import GCC, M4F, M7, Target, plain

TELLS = ("model", "precision", "form")  # what two folders share that are compared


def exported(path: Path) -> Folder:
    """An exported folder.  Raises BoresightError where it is none, or a file of it was edited."""
    if not (path / "manifest.json").is_file():
        raise BoresightError(f"{path} is no exported folder: it has no manifest.json; give one that 'export' wrote")
    folder = Folder(path)
    assert folder.manifest  # read before anything is written
    return folder


def against(old: Path, new: Path, core: Target | None = None) -> str:
    """A page for a change request, by a core that it ships to, or by this machine where no compiler for that is.

    Raises BoresightError for folders of other models, precisions or forms.
    """
    before, after = exported(old), exported(new)
    for name in TELLS:
        one, other = (str(folder.manifest.get(name)) for folder in (before, after))
        if one != other:
            raise BoresightError(f"{old} is of another {name} than {new}, {one} and not {other}: nothing to compare")
    precision = str(after.manifest["precision"])
    if core is None:
        ships = M4F if precision == "float" else M7
        core = GCC if ships.missing else ships
    flash, stack, ram = zip(*(measured(folder, core, precision) for folder in (before, after)), strict=True)
    counts = [counted(folder, f"{core.name} {precision}") for folder in (before, after)]
    totals = {"flash, bytes": [sum(one.values()) for one in flash],
              "deepest stack, bytes": [max(one.values()) for one in stack]}  # fmt: skip
    lines = [
        f"# {after.manifest['model']}, {precision}: what the change costs",
        "",
        f"From version {before.manifest['version']}, hash {before.manifest['hash'][:12]}, to "
        f"{after.manifest['version']}, {after.manifest['hash'][:12]}.  {core.name}, `{core.version}`, -Os.",
        "",
        *table("", {name: (one, other) for name, (one, other) in totals.items()}),
    ]
    instructions, operations = zip(*counts, strict=True)
    compared = [("flash of", flash), ("stack from", stack)]
    more = {"RAM of": ram, "instructions of": instructions, "operations of": operations}
    compared += [(title, both) for title, both in more.items() if all(both)]
    for title, (one, other) in compared:
        rows = {name: (one.get(name), other.get(name)) for name in sorted({*one, *other})}
        changed = {name: row for name, row in rows.items() if row[0] != row[1]}
        lines += ["", *table(title, changed)] if changed else ["", f"No {title.split()[0]} of a function changes."]
    if not (all(instructions) and all(operations)):
        lines += [
            "",
            "Instructions or operations are not in the evidence of both folders: `boresight evidence` makes them.",
        ]
    return "\n".join(lines)


Sizes = dict[str, int]


def measured(folder: Folder, core: Target, precision: str) -> tuple[Sizes, Sizes, Sizes]:
    """Bytes by unit; by entry point; and of the structs that a caller gives memory to."""
    with tempfile.TemporaryDirectory() as out:
        flash, calls = built(folder, core, precision, Path(out))
        ram = structs(folder, core, precision, Path(out))
    return flash, {plain(entry): calls.deepest(entry) for entry in calls.entries()}, ram


def counted(folder: Folder, core: str) -> tuple[Sizes, Sizes]:
    """Instructions of the dearest call of each function on that core, and operations of each unit, as its evidence has
    them."""
    kept = json.loads((folder.path / "evidence.json").read_text())["evidence"]
    units: dict[str, Any] = kept.get("golden", {}).get("units", {}) if isinstance(kept, dict) else {}
    costs = {name: by for of in units.values() for name, by in of["cost"].items()}
    instructions = {name: int(by[core][0]) for name, by in costs.items() if core in by}
    return instructions, {name: of["operations"] for name, of in units.items() if of["operations"] is not None}


def table(title: str, rows: Mapping[str, tuple[int | None, int | None]]) -> list[str]:
    """Before, after, and by how much."""
    shown = [
        f"| {name} | {'-' if one is None else one} | {'-' if other is None else other} | "
        f"{'new' if one is None else 'gone' if other is None else f'{other - one:+d}'} |"
        for name, (one, other) in rows.items()
    ]
    return [f"| {title} | before | after | change |", "|---|---|---|---|", *shown]
