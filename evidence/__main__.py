"""`make evidence`: what is out of date is computed anew, and written to results/ and docs/evidence.md."""

import multiprocessing
import sys
from concurrent.futures import ProcessPoolExecutor, as_completed

from boresight.errors import need

need("evidence")

from boresight.evidence.kinds import KINDS, all_kinds, keep, make, stale, still_open  # noqa: E402
from boresight.evidence.results import OPEN  # noqa: E402
from boresight.evidence.table import PAGE, page  # noqa: E402

JOBS = 2


def main() -> int:
    """Everything, or the folders and papers named on the command line."""
    named = sys.argv[1:]
    for kind in KINDS:
        if kind.missing:
            print(f"{kind.name}: skipped, {kind.missing}")
    pairs = all_kinds()
    unknown = sorted({*named} - {subject.name for _, subject in pairs})
    if unknown:
        names = ", ".join(dict.fromkeys(subject.name for _, subject in pairs))
        print(f"evidence: there is no {unknown[0]!r}; name any of {names}")
        return 2
    with ProcessPoolExecutor(JOBS, mp_context=multiprocessing.get_context("spawn")) as pool:
        running = {}
        for kind, subject in pairs:
            if named and subject.name not in named:
                continue
            units = stale(subject, kind)
            if not units:
                keep(subject, kind, {})
            elif not kind.missing:
                running[pool.submit(make, subject, kind.name, units)] = subject, kind, units
        failed = 0
        for done in as_completed(running):
            subject, kind, units = running[done]
            try:
                made, seconds = done.result()
            except Exception as error:  # whatever it is, what else was made is kept
                failed += 1
                print(f"{subject.name}: {kind.name} failed: {type(error).__name__}: {error}", flush=True)
                continue
            keep(subject, kind, made)
            of = f" of {', '.join(units)}" if kind.by_unit and len(units) < len(kind.hashes(subject)) else ""
            print(f"{subject.name}: {kind.name}{of}, {seconds:.1f} s", flush=True)
    OPEN.write_text("".join(f"{line}\n" for line in still_open()))
    PAGE.write_text(page(PAGE.read_text()))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
