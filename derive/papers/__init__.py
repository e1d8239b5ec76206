"""The papers and our own derivations, by the names that the ledger gives them; imported when asked for."""

from typing import TYPE_CHECKING

from boresight import BoresightError

if TYPE_CHECKING:
    from boresight.derive.ledger.paper import Paper

PAPERS = ("song-lee-2001", "kim-2018", "kang-2025")
DERIVATIONS = ("delay-error", "mechanics")  # of nobody's print


def paper(name: str) -> "Paper":
    """The paper or derivation of a name.  Raises BoresightError with the right names."""
    match name:
        case "song-lee-2001":
            from boresight.derive.papers.song_lee_2001.paper import PAPER
        case "kim-2018":
            from boresight.derive.papers.kim_2018.paper import PAPER
        case "kang-2025":
            from boresight.derive.papers.kang_2025.paper import PAPER
        case "delay-error":
            from boresight.derive.papers.delay_error.paper import PAPER
        case "mechanics":
            from boresight.derive.papers.mechanics.paper import PAPER
        case _:
            raise BoresightError(f"no paper {name!r}: the papers are {', '.join((*PAPERS, *DERIVATIONS))}")
    return PAPER
