"""A kind of evidence, those of a generated folder, and what makes and keeps them."""

import multiprocessing
import os
import tempfile
from collections.abc import Callable, Iterable
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from boresight.codegen.folder import Folder
from boresight.codegen.generate import COMPONENTS
from boresight.evidence import results
from boresight.evidence.attack import attack
from boresight.evidence.bits import MISSING as BITS_MISSING
from boresight.evidence.bits import MODEL, bits
from boresight.evidence.bits import version as bits_version
from boresight.evidence.coverage import coverage
from boresight.evidence.eva import MISSING as EVA_MISSING
from boresight.evidence.eva import eva
from boresight.evidence.eva import version as eva_version
from boresight.evidence.golden import golden
from boresight.evidence.gpu import MISSING as GPU_MISSING
from boresight.evidence.gpu import gpu
from boresight.evidence.gpu import hashes as gpu_hashes
from boresight.evidence.gpu import version as gpu_version
from boresight.evidence.guards import guards
from boresight.evidence.misra import MISSING as MISRA_MISSING
from boresight.evidence.misra import misra
from boresight.evidence.misra import version as misra_version
from boresight.evidence.mutants import mutants
from boresight.evidence.results import Subject
from boresight.evidence.riscv import riscv
from boresight.evidence.rounding import rounding
from boresight.evidence.stack import stack
from boresight.evidence.targets import CLANG, GCC, HARNESS, M4F, RV32
from boresight.evidence.trace import trace
from boresight.evidence.verified import made_of, verified

UNITS = dict[str, dict[str, Any]]


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


def printed_named(folder: Folder) -> dict[str, str]:
    """With its self-test and the words behind what its kernel gives."""
    return {unit.name: unit.hashes["named"] for unit in folder.units if unit.described is not None}


def tested(folder: Folder) -> dict[str, str]:
    """Of all units, each with its self-test."""
    return {unit.name: unit.hash(tested=True) for unit in folder.units}


def changeable(folder: Folder) -> dict[str, str]:
    """Of those that can be told from their mutants."""
    return {unit.name: unit.hash(tested=True) for unit in folder.units if unit.test.is_file() and not unit.elementary}


def whole(folder: Folder) -> dict[str, str]:
    return {folder.name: folder.code}


def all_of_it(folder: Folder) -> dict[str, str]:
    """Of the C and the self-tests."""
    return {folder.name: folder.hash}


def by_harness(name: str) -> Callable[[Folder], dict[str, str]]:
    """Of a filter and of the C that calls it."""
    return lambda folder: {folder.name: folder.filter_hash(HARNESS / name)}


KINDS = (
    Kind("trace", trace, "", lambda: "", printed_named),
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
    Kind("coverage", coverage, GCC.missing, lambda: GCC.version, all_of_it, by_unit=False),
    Kind("stack", stack, M4F.missing, lambda: M4F.version, whole, by_unit=False),
    Kind("eva", eva, EVA_MISSING, eva_version, printed),
    Kind("bits", bits, BITS_MISSING, bits_version, by_harness("flight.c"), by_unit=False),
    Kind("verified", verified, GCC.missing, lambda: "", made_of, by_unit=False),
    Kind("attack", attack, GCC.missing, lambda: "", by_harness("attack.c"), by_unit=False),
    Kind("gpu", gpu, GPU_MISSING, gpu_version, gpu_hashes, by_unit=False),
)

# Emulated boards, mutants and Eva cost with the third power of the states, and hours beyond so many of them.
JOBS = 2
LARGEST, DEAR = 20, ("golden", "mutants", "eva")


def kinds_for(folder: Folder) -> tuple[Kind, ...]:
    """What is made of a generated folder."""
    left_out = set() if is_small(folder) else set(DEAR)
    left_out |= set() if folder.name == MODEL else {"bits"}
    left_out |= set() if folder.manifest.get("filter") else {"attack", "gpu"}
    left_out |= {"verified"} if folder.manifest["model"] in COMPONENTS else set()
    return tuple(kind for kind in KINDS if kind.name not in left_out)


def is_small(folder: Folder) -> bool:
    """Whether its evidence that costs with the third power of the states is made."""
    return len(folder.manifest.get("states", ())) <= LARGEST


def of_another_text(subject: Subject, kind: Kind) -> list[str]:
    """The units whose results are not of what is here; the subject itself of a kind that is made of the whole."""
    kept = results.read(subject).get(kind.name, {}).get("sources", {})
    return [name for name, digest in kind.hashes(subject).items() if kept.get(name) != digest]


def stale(subject: Subject, kind: Kind) -> list[str]:
    """Those, or all where other tools are here than made them."""
    other_tools = not kind.missing and results.read(subject).get(kind.name, {}).get("tools") != kind.tools()
    return list(kind.hashes(subject)) if other_tools else of_another_text(subject, kind)


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


def make(maker: Callable[..., UNITS], subject: Subject, units: list[str] | None) -> tuple[UNITS, float]:
    """One kind of evidence of one subject, of these of its units if it is made by unit; and the processor time that it
    took, with compilers and tools."""
    start = sum(os.times()[:4])
    with tempfile.TemporaryDirectory() as out:
        found = maker(subject, Path(out), **({} if units is None else {"names": units}))
    return found, sum(os.times()[:4]) - start


def make_all(pairs: Iterable[tuple[Kind, Subject]]) -> int:
    """Make and keep what is stale of these, a line for each as it is done; how many failed."""
    failed = 0
    with ProcessPoolExecutor(JOBS, mp_context=multiprocessing.get_context("spawn")) as pool:
        running = {}
        for kind, subject in pairs:
            units = stale(subject, kind)
            if not units:
                keep(subject, kind, {})
            elif not kind.missing:
                running[pool.submit(make, kind.make, subject, units if kind.by_unit else None)] = subject, kind, units
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
    return failed
