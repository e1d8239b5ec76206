"""Everything of which evidence is made: the generated folders, the papers, the examples, the flights."""

from collections.abc import Callable
from functools import partial

from boresight.codegen.folder import folders
from boresight.codegen.generate import COMPONENTS
from boresight.derive.papers import PAPERS
from boresight.evidence.crossed import PEERS
from boresight.evidence.drawn import NUMBERS, drawn_models
from boresight.evidence.examples import NAMES, examples
from boresight.evidence.flights.campaign import campaign
from boresight.evidence.kind import KINDS, Kind, Subject, kinds_for, of_another_text
from boresight.evidence.pages import MISSING as PAGES_MISSING
from boresight.evidence.pages import of_model, pages
from boresight.evidence.proofs import kept as proofs
from boresight.evidence.sources import CrossChecks, Derivations, Drawn, Examples, Flights, derivations
from boresight.evidence.spoilt import spoilt
from boresight.evidence.steps import steps
from boresight.evidence.targets import GCC

# Of a model as it is shown.
PAGES = Kind("pages", pages, PAGES_MISSING, lambda: "", of_model, by_unit=False)


def of_paper(*judges: str) -> Callable[[Derivations], dict[str, str]]:
    return lambda paper: {paper.name: paper.hash(*judges)}


# Of papers, not of generated folders.
PAPER_KINDS = (
    Kind("shown", spoilt, "", lambda: "", of_paper("formula_tokens", "read_back", "spoilt"), by_unit=False),
    Kind("steps", steps, "", lambda: "", of_paper("steps"), by_unit=False),
    Kind("pages", pages, PAGES_MISSING, lambda: "", of_paper("pages"), by_unit=False),
)


# Of the examples.
FLOWN = Kind("flown", examples, GCC.missing, lambda: "", lambda of: {name: of.hash(name) for name in NAMES})

# Of drawn models.
DRAWN = Kind("drawn", drawn_models, GCC.missing, lambda: "", lambda drawn: dict.fromkeys(NUMBERS, drawn.hash))

# Of what independent tools compute too: a kind for each of them, which another version makes stale.
CROSSED = tuple(
    Kind(peer.name, peer.make, peer.missing, partial(getattr, peer, "tools"), peer.hashes) for peer in PEERS
)

# Of the transfer alignment.
TRIED = Kind("tried", campaign, GCC.missing, lambda: "", lambda flights: {flights.name: flights.hash}, by_unit=False)


def kinds_of(paper: Derivations) -> tuple[Kind, ...]:
    """Every change of every formula that is shown is tried of papers; of our own derivations a test reads them back."""
    return tuple(kind for kind in PAPER_KINDS if kind.name != "shown" or paper.name in PAPERS)


def all_kinds() -> list[tuple[Kind, Subject]]:
    """Everything of which evidence is made."""
    every = folders()
    pairs: list[tuple[Kind, Subject]] = [
        (kind, folder) for kind in KINDS for folder in every if kind in kinds_for(folder)
    ]
    pairs += [(PAGES, folder) for folder in every if folder.manifest["model"] not in COMPONENTS]
    pairs += [(kind, paper) for paper in derivations() for kind in kinds_of(paper)]
    return [
        *pairs,
        *((kind, CrossChecks()) for kind in CROSSED),
        (FLOWN, Examples()),
        (DRAWN, Drawn()),
        (TRIED, Flights()),
    ]


def still_open() -> list[str]:
    """What is not held now, a line for each kind of a subject: results of another text than what is here."""
    found = ((kind, subject, of_another_text(subject, kind)) for kind, subject in all_kinds())
    lines = [(f"{kind.name} of {subject.name}", units) for kind, subject, units in found]
    lines += [(f"proofs of {folder.name}", proofs.of_another_list(folder)) for folder in folders()]
    return [f"{what}: {', '.join(units)}" for what, units in lines if units]
