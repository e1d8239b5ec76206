"""The kinds of evidence, and what makes each."""

import os
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from boresight.derive.papers import PAPERS
from boresight.evidence import results
from boresight.evidence.attack import attack
from boresight.evidence.bits import MISSING as BITS_MISSING
from boresight.evidence.bits import MODEL, bits
from boresight.evidence.bits import version as bits_version
from boresight.evidence.eva import MISSING as EVA_MISSING
from boresight.evidence.eva import eva
from boresight.evidence.eva import version as eva_version
from boresight.evidence.examples import examples
from boresight.evidence.flights.campaign import campaign
from boresight.evidence.golden import golden
from boresight.evidence.guards import guards
from boresight.evidence.misra import MISSING as MISRA_MISSING
from boresight.evidence.misra import misra
from boresight.evidence.misra import version as misra_version
from boresight.evidence.mutants import mutants
from boresight.evidence.riscv import riscv
from boresight.evidence.rounding import rounding
from boresight.evidence.sources import Derivations, Examples, Flights, Folder
from boresight.evidence.spoilt import spoilt
from boresight.evidence.steps import steps
from boresight.evidence.targets import CLANG, GCC, M4F, RV32
from boresight.evidence.trace import trace

UNITS = dict[str, dict[str, Any]]


@dataclass(frozen=True)
class Kind:
    """One kind of evidence, of generated folders or of papers.

    tools names the version that its results hang on; missing says why it cannot be made.
    """

    name: str
    make: Callable[[Any, Path], UNITS]
    missing: str
    tools: Callable[[], str]


KINDS = (
    Kind("trace", trace, "", lambda: ""),
    Kind("guards", guards, GCC.missing, lambda: GCC.version),
    Kind("golden", golden, M4F.missing or CLANG.missing, lambda: f"{M4F.version}; {GCC.version}; {CLANG.version}"),
    Kind("mutants", mutants, GCC.missing, lambda: ""),
    Kind("rounding", rounding, GCC.missing, lambda: ""),
    Kind("misra", misra, MISRA_MISSING, misra_version),
    Kind("riscv", riscv, RV32.missing, lambda: RV32.version),
    Kind("eva", eva, EVA_MISSING, eva_version),
    Kind("bits", bits, BITS_MISSING, bits_version),
    Kind("attack", attack, GCC.missing, lambda: ""),
)

# Emulated boards, mutants and Eva cost with the third power of the states, and hours beyond so many of them.
LARGEST, DEAR = 20, ("golden", "mutants", "eva")


def kinds_for(folder: Folder) -> tuple[Kind, ...]:
    """What is made of a generated folder."""
    left_out = set() if is_small(folder) else set(DEAR)
    left_out |= set() if folder.name == MODEL else {"bits"}
    left_out |= set() if folder.manifest.get("filter") else {"attack"}
    return tuple(kind for kind in KINDS if kind.name not in left_out)


def is_small(folder: Folder) -> bool:
    """Whether its evidence that costs with the third power of the states is made."""
    return len(folder.manifest.get("states", ())) <= LARGEST


# Of papers, not of generated folders.
PAPER_KINDS = (Kind("shown", spoilt, "", lambda: ""), Kind("steps", steps, "", lambda: ""))


# Of the examples.
FLOWN = Kind("flown", examples, GCC.missing, lambda: "")

# Of the transfer alignment.
TRIED = Kind("tried", campaign, GCC.missing, lambda: "")


def kinds_of(paper: Derivations) -> tuple[Kind, ...]:
    """Every change of every formula that is shown is tried of papers; of our own derivations a test reads them back."""
    return tuple(kind for kind in PAPER_KINDS if kind.name != "shown" or paper.name in PAPERS)


def out_of_date(folder: Folder | Derivations | Examples | Flights, kind: Kind) -> bool:
    before = results.read(folder).get(kind.name, {})
    return bool(before.get("sources") != results.sources_hash(folder) or before.get("tools") != kind.tools())


def make(folder: Folder | Derivations | Examples | Flights, name: str) -> tuple[UNITS, float]:
    """One kind of evidence of one subject, and the processor time that it took, with compilers and tools."""
    kind = next(kind for kind in (*KINDS, *PAPER_KINDS, FLOWN, TRIED) if kind.name == name)
    start = sum(os.times()[:4])
    with tempfile.TemporaryDirectory() as out:
        units = kind.make(folder, Path(out))
    return units, sum(os.times()[:4]) - start
