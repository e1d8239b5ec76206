"""The papers and our own derivations, by the names that the ledger gives them; read when asked for.

A paper is a folder: `papers.own` reads that of a reader, `papers.built_in` one of those here.
"""

from collections.abc import Callable
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from boresight import BoresightError
from boresight.derive.papers.files import holds_paper

if TYPE_CHECKING:
    from boresight.derive.ledger.paper import Paper

PAPERS = ("song-lee-2001", "kim-2018", "kang-2025")
DERIVATIONS = ("delay-error", "mechanics")  # of nobody's print


OWN: dict[str, "Paper"] = {}  # those that were read from folders, by name


def paper(name: str, load: Callable[[str], Any] | None = None) -> "Paper":
    """The paper or derivation of a name, or of a folder.  Raises BoresightError with the right names.

    load: makes the model of a name, for a folder that is tied to one; without, it is not looked at.
    """
    if name in (*PAPERS, *DERIVATIONS):
        from boresight.derive.papers.built_in import built_in

        return built_in(name, python(name))
    if not is_folder(name):
        if name in OWN:
            return OWN[name]
        raise BoresightError(f"no paper {name!r}: the papers are {', '.join((*PAPERS, *DERIVATIONS))}, or a folder")
    found = of_folder(Path(name), load)
    OWN[found.name] = found
    return found


def of_folder(folder: Path, load: Callable[[str], Any] | None = None) -> "Paper":
    """The paper of a folder of one's own; load: as of `paper`.  Raises BoresightError with the place in a file."""
    from boresight.derive.papers.own import own
    from boresight.derive.papers.own_map import tied
    from boresight.derive.papers.own_witness import has_witness, with_witness

    if has_witness(folder):
        return with_witness(folder)
    return tied(folder, load) if load else own(folder)


@cache
def python(name: str) -> Callable[[str], ModuleType]:
    """The modules of a paper that comes with Boresight, by their names."""
    return lambda module: import_module(f"{__name__}.{name.replace('-', '_')}.{module}")


def is_folder(name: str) -> bool:
    """Whether it names a paper of one's own: a folder that holds paper.toml."""
    return name not in (*PAPERS, *DERIVATIONS) and holds_paper(name)
