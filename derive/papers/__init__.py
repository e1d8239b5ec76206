"""The papers, by the names that the ledger gives them.  A paper's module is imported when it is asked for."""

from typing import TYPE_CHECKING

from boresight import BoresightError

if TYPE_CHECKING:
    from boresight.derive.ledger.paper import Paper

PAPERS = ("song-lee-2001", "kim-2018", "kang-2025")


def paper(name: str) -> "Paper":
    """The paper of a name.  Raises BoresightError with the right names."""
    from boresight.derive.papers.delay_error.paper import PAPER as DELAY
    from boresight.derive.papers.kang_2025.paper import PAPER as KANG
    from boresight.derive.papers.kim_2018.paper import PAPER as KIM
    from boresight.derive.papers.song_lee_2001.paper import PAPER as SONG_LEE

    for one in (SONG_LEE, KIM, KANG, DELAY):
        if one.name == name:
            return one
    raise BoresightError(f"no paper {name!r}: the papers are {', '.join(PAPERS)}")
