"""What an edit of a paper of one's own changed: its statuses before and after."""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from boresight.derive.ledger.entries import findings, ledger
from boresight.derive.letters import number_label
from boresight.derive.papers import of_folder
from boresight.derive.papers.own_map import Load

Statuses = dict[str, Any]  # by number status, found and printed; what is beside the equations under ""


def statuses(folder: Path, load: Load | None = None) -> Statuses:
    """Of the paper in the folder now.  Raises BoresightError with file, line and column of what is wrong in it.

    load: as of `papers.paper`.
    """
    paper = of_folder(folder, load)
    found: Statuses = {
        entry.number: {
            "status": " ".join(filter(None, (entry.status, entry.kind))),
            "found": entry.found,
            "printed": entry.printed,
        }
        for entry in ledger(paper)
    }
    return {**found, "": list(findings(paper))}


def changed(before: Mapping[str, Any], now: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Of each equation that is another, `number`, `before` and `now`, None of one that is not there."""
    numbers = [number for number in {**now, **before} if number and before.get(number) != now.get(number)]
    return [{"number": number, "before": before.get(number), "now": now.get(number)} for number in numbers]


def lines(before: Mapping[str, Any], now: Mapping[str, Any]) -> Iterator[str]:
    """The changes as text; nothing if nothing differs."""
    for change in changed(before, now):
        old, new = change["before"], change["now"]
        sides = (old, new) if before else (new,)
        words = " -> ".join(dict.fromkeys(side["status"] if side else "not there" for side in sides))
        yield f"{number_label(change['number'])} {words}"
        if old and new and old["printed"] != new["printed"]:
            yield f"    before  {old['printed']}"
            yield f"    after   {new['printed']}"
        if new:
            yield f"    {new['found']}"
    yield from (f"  {sentence}" for sentence in now.get("", ()) if sentence not in before.get("", ()))
    yield from (f"  no more: {sentence}" for sentence in before.get("", ()) if sentence not in now.get("", ()))
