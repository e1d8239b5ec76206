"""The papers and our own derivations, by the names that the ledger gives them; imported when asked for."""

from importlib import import_module
from typing import TYPE_CHECKING

from boresight import BoresightError

if TYPE_CHECKING:
    from boresight.derive.ledger.paper import Paper

PAPERS = ("song-lee-2001", "kim-2018", "kang-2025")
DERIVATIONS = ("delay-error", "mechanics")  # of nobody's print


def paper(name: str) -> "Paper":
    """The paper or derivation of a name.  Raises BoresightError with the right names."""
    if name not in (*PAPERS, *DERIVATIONS):
        raise BoresightError(f"no paper {name!r}: the papers are {', '.join((*PAPERS, *DERIVATIONS))}")
    found: Paper = import_module(f"{__name__}.{name.replace('-', '_')}.paper").PAPER
    return found
