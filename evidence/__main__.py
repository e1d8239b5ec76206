"""`make evidence`: what is out of date is computed anew, and written to results/ and docs/evidence.md."""

import multiprocessing
import sys
from concurrent.futures import ProcessPoolExecutor, as_completed

from boresight.errors import need

need("evidence")

from boresight.evidence import results  # noqa: E402
from boresight.evidence.kinds import FLOWN, KINDS, TRIED, Kind, kinds_for, kinds_of, make, out_of_date  # noqa: E402
from boresight.evidence.sources import Derivations, Examples, Flights, Folder, derivations, folders  # noqa: E402
from boresight.evidence.table import PAGE, page  # noqa: E402

JOBS = 2


def main() -> int:
    """Everything, or the folders and papers named on the command line."""
    named = sys.argv[1:]
    for kind in KINDS:
        if kind.missing:
            print(f"{kind.name}: skipped, {kind.missing}")
    pairs: list[tuple[Kind, Folder | Derivations | Examples | Flights]] = [
        (kind, folder) for kind in KINDS for folder in folders() if kind in kinds_for(folder)
    ]
    pairs += [(kind, paper) for paper in derivations() for kind in kinds_of(paper)]
    pairs += [(FLOWN, Examples()), (TRIED, Flights())]
    unknown = sorted({*named} - {folder.name for _, folder in pairs})
    if unknown:
        print(f"evidence: there is no {unknown[0]!r}; name any of {', '.join(dict.fromkeys(f.name for _, f in pairs))}")
        return 2
    with ProcessPoolExecutor(JOBS, mp_context=multiprocessing.get_context("spawn")) as pool:
        running = {
            pool.submit(make, folder, kind.name): (folder, kind)
            for kind, folder in pairs
            if not kind.missing and (not named or folder.name in named) and out_of_date(folder, kind)
        }
        failed = 0
        for done in as_completed(running):
            folder, kind = running[done]
            try:
                units, seconds = done.result()
            except Exception as error:  # whatever it is, what else was made is kept
                failed += 1
                print(f"{folder.name}: {kind.name} failed: {type(error).__name__}: {error}", flush=True)
                continue
            entry = {"sources": results.sources_hash(folder), "tools": kind.tools(), "units": units}
            results.write(folder, {**results.read(folder), kind.name: entry})
            print(f"{folder.name}: {kind.name}, {seconds:.1f} s", flush=True)
    PAGE.write_text(page(PAGE.read_text()))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
