"""`make cross-checks`: compare anew what is stale, of the peers that are installed; write results/ and the page."""

import sys

from boresight.evidence.crossed.table import PAGE, page
from boresight.evidence.kind import make_all
from boresight.evidence.kinds import CROSSED, still_open
from boresight.evidence.results import OPEN
from boresight.evidence.sources import CrossChecks


def main() -> int:
    for kind in CROSSED:
        if kind.missing:
            print(f"{kind.name}: skipped, {kind.missing}")
    failed = make_all((kind, CrossChecks()) for kind in CROSSED)
    OPEN.write_text("".join(f"{line}\n" for line in still_open()))
    PAGE.write_text(page(PAGE.read_text()))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
