"""`make evidence`: what is out of date is computed anew, and written to results/ and docs/evidence.md."""

import sys

from boresight.errors import need

need("evidence")

from boresight.evidence.crossed import table as crossed  # noqa: E402
from boresight.evidence.kind import KINDS, make_all  # noqa: E402
from boresight.evidence.kinds import all_kinds, still_open  # noqa: E402
from boresight.evidence.results import OPEN  # noqa: E402
from boresight.evidence.table import PAGE, page  # noqa: E402


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
    failed = make_all((kind, subject) for kind, subject in pairs if not named or subject.name in named)
    OPEN.write_text("".join(f"{line}\n" for line in still_open()))
    PAGE.write_text(page(PAGE.read_text()))
    crossed.PAGE.write_text(crossed.page(crossed.PAGE.read_text()))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
