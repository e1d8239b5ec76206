"""The kinds of evidence, and what makes each."""

import os
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from boresight.codegen.generate import COMPONENTS
from boresight.derive.papers import PAPERS
from boresight.evidence import results
from boresight.evidence.attack import attack
from boresight.evidence.bits import MISSING as BITS_MISSING
from boresight.evidence.bits import MODEL, bits
from boresight.evidence.bits import version as bits_version
from boresight.evidence.drawn import NUMBERS, drawn_models
from boresight.evidence.eva import MISSING as EVA_MISSING
from boresight.evidence.eva import eva
from boresight.evidence.eva import version as eva_version
from boresight.evidence.examples import NAMES, examples
from boresight.evidence.flights.campaign import campaign
from boresight.evidence.golden import golden
from boresight.evidence.guards import guards
from boresight.evidence.misra import MISSING as MISRA_MISSING
from boresight.evidence.misra import misra
from boresight.evidence.misra import version as misra_version
from boresight.evidence.mutants import mutants
from boresight.evidence.pages import MISSING as PAGES_MISSING
from boresight.evidence.pages import of_model, pages
from boresight.evidence.proofs import kept as proofs
from boresight.evidence.riscv import riscv
from boresight.evidence.rounding import rounding
from boresight.evidence.sources import Derivations, Drawn, Examples, Flights, Folder, derivations, folders
from boresight.evidence.spoilt import spoilt
from boresight.evidence.steps import steps
from boresight.evidence.targets import CLANG, GCC, HARNESS, M4F, RV32
from boresight.evidence.trace import trace
from boresight.evidence.verified import made_of, verified

UNITS = dict[str, dict[str, Any]]
Subject = Folder | Derivations | Drawn | Examples | Flights


@dataclass(frozen=True)
class Kind:
    """One kind of evidence, of generated folders or of papers.

    hashes: by unit, of all that its result depends on.  by_unit: whether `make` takes the names of the units that it is
    to make; else it makes the whole, which has one hash.
    tools names the version that its results hang on; missing says why it cannot be made.
    """

    name: str
    make: Callable[..., UNITS]
    missing: str
    tools: Callable[[], str]
    hashes: Callable[[Any], dict[str, str]]
    by_unit: bool = True


def printed(folder: Folder) -> dict[str, str]:
    """Of the printed units, without their self-tests; a component has none."""
    return {unit.name: unit.hash(tested=False) for unit in folder.units if unit.described is not None}


def printed_tested(folder: Folder) -> dict[str, str]:
    return {unit.name: unit.hash(tested=True) for unit in folder.units if unit.described is not None}


def tested(folder: Folder) -> dict[str, str]:
    """Of all units, each with its self-test."""
    return {unit.name: unit.hash(tested=True) for unit in folder.units}


def changeable(folder: Folder) -> dict[str, str]:
    """Of those that can be told from their mutants."""
    return {unit.name: unit.hash(tested=True) for unit in folder.units if unit.test.is_file() and not unit.elementary}


def whole(folder: Folder) -> dict[str, str]:
    return {folder.name: folder.code}


def by_harness(name: str) -> Callable[[Folder], dict[str, str]]:
    """Of a filter and of the C that calls it."""
    return lambda folder: {folder.name: folder.filter_hash(HARNESS / name)}


KINDS = (
    Kind("trace", trace, "", lambda: "", printed_tested),
    Kind("guards", guards, GCC.missing, lambda: GCC.version, tested),
    Kind(
        "golden",
        golden,
        M4F.missing or CLANG.missing,
        lambda: f"{M4F.version}; {GCC.version}; {CLANG.version}",
        tested,
    ),
    Kind("mutants", mutants, GCC.missing, lambda: "", changeable),
    Kind("rounding", rounding, GCC.missing, lambda: "", printed),
    Kind("misra", misra, MISRA_MISSING, misra_version, whole, by_unit=False),
    Kind("riscv", riscv, RV32.missing, lambda: RV32.version, tested),
    Kind("eva", eva, EVA_MISSING, eva_version, printed),
    Kind("bits", bits, BITS_MISSING, bits_version, by_harness("flight.c"), by_unit=False),
    Kind("verified", verified, GCC.missing, lambda: "", made_of, by_unit=False),
    Kind("attack", attack, GCC.missing, lambda: "", by_harness("attack.c"), by_unit=False),
    Kind("pages", pages, PAGES_MISSING, lambda: "", of_model, by_unit=False),
)

# Emulated boards, mutants and Eva cost with the third power of the states, and hours beyond so many of them.
LARGEST, DEAR = 20, ("golden", "mutants", "eva")


def kinds_for(folder: Folder) -> tuple[Kind, ...]:
    """What is made of a generated folder."""
    left_out = set() if is_small(folder) else set(DEAR)
    left_out |= set() if folder.name == MODEL else {"bits"}
    left_out |= set() if folder.manifest.get("filter") else {"attack"}
    left_out |= {"verified", "pages"} if folder.manifest["model"] in COMPONENTS else set()
    return tuple(kind for kind in KINDS if kind.name not in left_out)


def is_small(folder: Folder) -> bool:
    """Whether its evidence that costs with the third power of the states is made."""
    return len(folder.manifest.get("states", ())) <= LARGEST


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
    pairs += [(kind, paper) for paper in derivations() for kind in kinds_of(paper)]
    return [*pairs, (FLOWN, Examples()), (DRAWN, Drawn()), (TRIED, Flights())]


def of_another_text(subject: Subject, kind: Kind) -> list[str]:
    """The units whose results are not of what is here; the subject itself of a kind that is made of the whole."""
    kept = results.read(subject).get(kind.name, {}).get("sources", {})
    return [name for name, digest in kind.hashes(subject).items() if kept.get(name) != digest]


def stale(subject: Subject, kind: Kind) -> list[str]:
    """Those, or all where other tools are here than made them."""
    other_tools = not kind.missing and results.read(subject).get(kind.name, {}).get("tools") != kind.tools()
    return list(kind.hashes(subject)) if other_tools else of_another_text(subject, kind)


def still_open() -> list[str]:
    """What is not held now, a line for each kind of a subject: results of another text than what is here."""
    found = ((kind, subject, of_another_text(subject, kind)) for kind, subject in all_kinds())
    lines = [(f"{kind.name} of {subject.name}", units) for kind, subject, units in found]
    lines += [(f"proofs of {folder.name}", proofs.of_another_list(folder)) for folder in folders()]
    return [f"{what}: {', '.join(units)}" for what, units in lines if units]


def keep(subject: Subject, kind: Kind, made: UNITS) -> None:
    """Write what was made beside what stands, without what is gone."""
    kept, now = results.read(subject), kind.hashes(subject)
    before = kept.get(kind.name, {})
    units = {name: of for name, of in before.get("units", {}).items() if name in now} if kind.by_unit else {}
    entry = {
        "sources": now,
        "tools": before.get("tools", "") if kind.missing else kind.tools(),
        "units": units | made if kind.by_unit else made or before["units"],
    }
    if isinstance(subject, Folder):
        entry["folder"] = subject.hash
    if entry != before:
        results.write(subject, {**kept, kind.name: entry})


def make(subject: Subject, name: str, units: list[str]) -> tuple[UNITS, float]:
    """One kind of evidence of one subject, of these of its units if it is made by unit; and the processor time that it
    took, with compilers and tools."""
    kind = next(kind for kind in (*KINDS, *PAPER_KINDS, FLOWN, DRAWN, TRIED) if kind.name == name)
    start = sum(os.times()[:4])
    with tempfile.TemporaryDirectory() as out:
        found = kind.make(subject, Path(out), **({"names": units} if kind.by_unit else {}))
    return found, sum(os.times()[:4]) - start
