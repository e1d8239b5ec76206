"""`make proofs`: what is out of date is proved anew, the cheapest lists first; with --coq Coq checks the small ones."""

import argparse
import sys
import time
from functools import cache
from typing import Any

from boresight.codegen.folder import Folder, Source, folders
from boresight.codegen.functions.unit import Unit
from boresight.codegen.functions.units import units
from boresight.codegen.generate import load_model
from boresight.evidence.proofs import coq, kept, prover, search
from boresight.evidence.proofs.script import cone
from boresight.evidence.table import PAGE, page

Known = tuple[float | None, float | None, str]  # bound, worst error found, why there is none


@cache
def made(model: str) -> dict[str, Unit]:
    return {unit.name: unit for unit in units(load_model(model))}


def alone(unit: Unit, position: int) -> str:
    """What a bound hangs on: the list of one output and the boxes of what it reads; many models share some."""
    steps = search.sliced(unit.tape, position).steps
    read = sorted({step.source[0] for step in steps if step.op == "input"})
    return repr((steps, [(i, unit.args[i].low, unit.args[i].high, unit.args[i].norm) for i in read]))


def of_unit(source: Source, unit: Unit, seconds: float, known: dict[str, Known]) -> list[list[Any]]:
    """Each output: its name, the steps that it depends on, its bound, the worst error found, and why it has none.

    known: by `alone`, what earlier units gave; added to.
    """
    keys = {position: alone(unit, position) for position in sorted({p for _, _, p in unit.tape.results})}
    bounds: dict[int, float] = {}
    for position, key in keys.items():
        if key in known:
            continue
        try:
            bounds[position] = prover.bound(unit.tape, position, unit.args, seconds)
        except prover.Unproved as error:
            known[key] = None, None, str(error)
    for position, error_found in search.worst(source, unit, bounds).items():
        known[keys[position]] = bounds[position], float(f"{error_found:.3g}"), ""
    listed: list[list[Any]] = []
    for o, k, p in sorted(unit.tape.results):
        result = unit.results[o]
        name = f"{result.name}[{', '.join(map(str, result.nonzeros[k]))}]"
        listed.append([name, len(cone(unit.tape, p)), *known[keys[p]]])
    return listed


def by_coq(source: Source, unit: Unit, entry: dict[str, Any], accepted: coq.Accepted) -> dict[str, Any]:
    """How many of the unit's bounds Coq accepts, of how many; what rounds nothing needs no proof.

    Raises TimeoutError where the hours are spent.
    """
    positions = {p for _, _, p in unit.tape.results}
    bounds = dict(zip((p for _, _, p in sorted(unit.tape.results)), kept.outputs(entry), strict=True))
    tried = sorted(p for p in positions if bounds[p].bound)
    taken, refused = 0, []
    for position in tried:
        if accepted.hours > coq.HOURS:
            raise TimeoutError
        claimed = bounds[position].bound
        assert claimed is not None
        try:
            taken_it = accepted.check(coq.proof(unit.tape, position, unit.args, claimed))
        except prover.Unproved:
            taken_it = False
        taken += taken_it
        refused += [] if taken_it else [bounds[position].name]
    return {"tool": coq.version(), "accepted": taken, "of": len(tried), "refused": refused}


def check_by_coq(work: list[tuple[Folder, Source]]) -> None:
    accepted = coq.Accepted()
    for folder, source in work:
        entry = kept.read(folder)[source.name]
        assert source.described is not None
        if entry.get("coq", {}).get("tool") == coq.version():
            continue
        try:
            entry["coq"] = by_coq(source, made(folder.manifest["model"])[source.described["name"]], entry, accepted)
        except TimeoutError:
            print(f"{source.name} and larger: Coq has had its {coq.HOURS:g} hours")
            return
        kept.write(folder, {**kept.read(folder), source.name: entry})
        print(f"{source.name}: Coq accepts {entry['coq']['accepted']} of {entry['coq']['of']}", flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m boresight.evidence.proofs", description=__doc__)
    parser.add_argument("folders", nargs="*", help="all, if none is named")
    parser.add_argument("--seconds", type=float, default=prover.SECONDS, help="for one question to Gappa")
    parser.add_argument("--coq", action="store_true", help=f"check lists up to {coq.LARGEST} operations by Coq too")
    options = parser.parse_args()
    missing = prover.MISSING or (coq.MISSING if options.coq else "")
    if missing:
        print(f"proofs: {missing}")
        return 1
    tool = prover.version()
    work: list[tuple[int, Folder, Source]] = []
    for folder in folders():
        if not folder.manifest.get("component") and (not options.folders or folder.name in options.folders):
            work += [(unit.operations or 0, folder, unit) for unit in kept.wanted(folder) if kept.tried(unit)]
    work.sort(key=lambda item: item[0])
    known: dict[str, Known] = {}
    for _, folder, source in work:
        assert source.described is not None
        if kept.current(source, kept.read(folder), tool):
            continue
        start = time.monotonic()
        listed = of_unit(source, made(folder.manifest["model"])[source.described["name"]], options.seconds, known)
        entry = {"list": source.described["hash"], "tool": tool, "outputs": listed}
        kept.write(folder, {**kept.read(folder), source.name: entry})
        outputs = kept.outputs(entry)
        shares = f"{sum(o.bounded for o in outputs)} of {len(outputs)} bounded, {sum(o.tight for o in outputs)} tight"
        print(f"{source.name}: {shares}, {time.monotonic() - start:.0f} s", flush=True)
    if options.coq:
        check_by_coq([(folder, source) for operations, folder, source in work if operations <= coq.LARGEST])
    PAGE.write_text(page(PAGE.read_text()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
