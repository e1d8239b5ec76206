"""What is known of exactly this C, by kind of evidence: the results that are kept, a verdict on each, and the lowest.

A result is of this C where the hash that it was kept with is that of the unit's files and of all that they reach now;
of a kind that looks at a whole folder, that of all its C, with or without the self-tests.
"""

import json
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from pathlib import Path
from typing import Any

from boresight.codegen import deviations
from boresight.codegen.folder import Folder, Source
from boresight.codegen.stamp import PACKAGE
from boresight.runtime.manifest import generated

RESULTS = PACKAGE / "evidence" / "results"
CORES = ("cortex-m4f float", "cortex-m7 float", "cortex-m7 double")

# What the C takes for granted, and who sees to it.
BY_COMPILER, BY_PROBE, BY_USER = "refused by the compiler", "found by bs_probe", "yours"
ASSUMED = (
    ("no -ffast-math, no reordered sums, no reciprocals in place of quotients", BY_COMPILER),
    (
        "arithmetic in the precision of its numbers: no x87, and a double of 64 bits where double is exported",
        BY_COMPILER,
    ),
    ("one precision in a program that links two: each function's name ends with its own", BY_COMPILER),
    ("no product and sum rounded as one (-ffp-contract=off)", BY_PROBE),
    ("rounding to nearest", f"{BY_PROBE} in double; in float {BY_USER}"),
    ("subnormal numbers are kept: where they are flushed to zero a flight may have other bits", BY_USER),
    ("a correctly rounded square root and quotient, of the processor or of its library", BY_USER),
    ("int of at least 32 bits; the caller's structs aligned as their types ask", BY_USER),
    ("a filter is called from one context at a time; the live loop from three, as its header says", BY_USER),
    ("memory that nobody else writes; what was spoilt is found by snapshot, restore and health alone", BY_USER),
    ("the stack below, and that of the target's own memcpy, memset, frexp and sqrt", BY_USER),
    ("the trap on an inexact result is masked; those on invalid operations may be on", BY_USER),
)


class Verdict(IntEnum):
    """In words: VERDICTS."""

    WRONG = 0
    NOT_MADE = 1
    LISTED = 2
    HELD = 3


VERDICTS = {
    Verdict.WRONG: "not held",
    Verdict.NOT_MADE: "not made of this C",
    Verdict.LISTED: "held but for what is listed",
    Verdict.HELD: "held",
}
Result = dict[str, Any]


@dataclass(frozen=True)
class Column:
    """One kind of evidence of a unit.

    how: in a sentence.  made_of: whether it is made of such a unit.  text: a result in a few words.  left: what it
    leaves open, a line each.  wrong: what it found that may not be.
    """

    kind: str
    title: str
    how: str
    made_of: Callable[[Source], bool]
    text: Callable[[Result], str]
    left: Callable[[Result], list[str]]
    wrong: Callable[[Result], list[str]] = lambda of: []

    def verdict(self, of: Result | None) -> Verdict:
        if of is None:
            return Verdict.NOT_MADE
        return Verdict.WRONG if self.wrong(of) else Verdict.LISTED if self.left(of) else Verdict.HELD


# ---------------------------------------------------------------- results in words


def bits(builds: Result, where: tuple[str, ...]) -> str:
    """Equal bits, or by how many units in the last place they differ at most; and failures, if there are any."""
    found = [builds[name] for name in where if name in builds]
    if not found:
        return "-"
    failed = sum(build["failures"] for build in found)
    off = max(build["ulps"] for build in found)
    word = "equal" if all(build["bits"] for build in found) else f"{max(off, 0.01):.2g} ulp"
    return word + (f", {failed} fail" if failed else "")


def failures(of: Result) -> list[str]:
    return [f"{where}: {was['failures']} failures" for where, was in of["builds"].items() if was["failures"]]


def other_bits(of: Result) -> list[str]:
    return [f"{where}: {was['ulps']:.2g} ulp from x86-64" for where, was in of["builds"].items() if not was["bits"]]


def killed(of: Result) -> str:
    meant = of["tried"] - of["equivalent"]
    return f"{of['killed']} of {meant} ({100 * of['killed'] / max(1, meant):.1f} %), {of['equivalent']} equivalent"


def refused(of: Result) -> str:
    by_precision: dict[str, Counter[str]] = {"double": Counter(), "float": Counter()}
    for word in of["not_taken"]:
        by_precision[word.split(", ")[0]][word.split(", ", 1)[1]] += 1
    left = (by_precision["double"] | by_precision["float"]).total()
    return f"{of['tried']}, {len(of['wrong'])} wrong" + (f", {left} lines open" if left else "")


def rounds(of: Result) -> str:
    loose = f", {of['loose']:.2g}x" if of["loose"] else ""
    return f"{of['relative']:.1e}{loose}" + (f", {of['violations']} broken" if of["violations"] else "")


def alarms(of: Result) -> str:
    return f"{of['alarms']}" + (f" ({len(of['assumed'])} assumed)" if of["assumed"] else "")


def traced(of: Result) -> str:
    return f"{of['statements']} to {of['outputs']}" + (f", {len(of['missing'])} open" if of["missing"] else "")


COUNTED = ("lines", "branches", "conditions")  # of coverage; conditions by MC/DC
ASKED = (100, 99.5, 98)  # per cent of each, of what a call can reach


def shares(units: list[Result], precisions: tuple[str, ...] = ("double", "float"), reach: bool = False) -> str:
    """Lines, branches and conditions by MC/DC that are covered, in per cent; reach: of what a call can reach."""
    found = []
    for what in COUNTED:
        counts = [(*of[p][what], of[p].get("beyond", {}).get(what, 0)) for of in units for p in precisions]
        hit, all_, beyond = (sum(count[i] for count in counts) for i in range(3))
        every = all_ - beyond if reach else all_
        found.append(f"{100 * hit / every:.4g}" if every else "-")
    return " / ".join(found)


def covered(of: Result) -> str:
    """In per cent, of both precisions together; and of what a call can reach, if that is less than all."""
    raw, reached = shares([of]), shares([of], reach=True)
    return raw if raw == reached else f"{raw}; of what can be reached {reached}"


def deepest(of: Result) -> str:
    """The deepest entry point, the flash and the RAM on a Cortex-M4F in float."""
    stack = max((cost.get(CORES[0], 0) for cost in of["stack"].values()), default=0)
    ram = of.get("ram", {}).get(CORES[0], 0)
    return ", ".join(f"{size} B" for size in (stack, of["flash"].get(CORES[0], 0), *([ram] if ram else [])))


def nothing(of: Result) -> list[str]:
    return []


def tested(unit: Source) -> bool:
    return unit.test.is_file()


def printed(unit: Source) -> bool:
    return unit.described is not None


def every(unit: Source) -> bool:
    return True


COLUMNS = (
    Column(
        kind="golden",
        title="self-test, bits",
        how="the self-test on this machine and on emulated cores: verdicts, and every number that it compares",
        made_of=tested,
        text=lambda of: bits(of["builds"], CORES),
        left=other_bits,
        wrong=failures,
    ),
    Column(
        kind="riscv",
        title="RISC-V",
        how="the same on an emulated RISC-V of 32 bits",
        made_of=tested,
        text=lambda of: bits(of["builds"], ("riscv32 float", "riscv32 double")),
        left=other_bits,
        wrong=failures,
    ),
    Column(
        kind="coverage",
        title="lines / branches / MC/DC, %",
        how="what the self-test runs, decides, and decides by one condition alone",
        made_of=tested,
        text=covered,
        left=lambda of: list(of["open"]),
    ),
    Column(
        kind="stack",
        title="stack, flash, RAM (M4F, float)",
        how="the deepest way through the graph of calls; code and constants of the object; what a caller keeps",
        made_of=every,
        text=deepest,
        left=nothing,
    ),
    Column(
        kind="mutants",
        title="mutants killed",
        how="the text changed in one place each time, and run through the self-test",
        made_of=lambda unit: tested(unit) and not unit.elementary,
        text=killed,
        left=lambda of: list(of["survivors"]),
    ),
    Column(
        kind="guards",
        title="bad input",
        how="each number NaN, infinite, beyond its box, each pointer null: refused, and nothing touched",
        made_of=tested,
        text=refused,
        left=lambda of: [*of["not_taken"], *of.get("no_value", ())],
        wrong=lambda of: list(of["wrong"]),
    ),
    Column(
        kind="rounding",
        title="rounding",
        how="a bound on each output in float, at 1e5 points, against the C in float",
        made_of=printed,
        text=rounds,
        left=nothing,
        wrong=lambda of: [f"{of['violations']} errors beyond the bound"] if of["violations"] else [],
    ),
    Column(
        kind="misra",
        title="MISRA",
        how="cppcheck's add-on over the whole folder: rules broken without a reason",
        made_of=every,
        text=lambda of: ", ".join(deviations.broken(of)) or "0",
        left=deviations.broken,
    ),
    Column(
        kind="eva",
        title="Eva",
        how="Frama-C Eva over the whole box: alarms",
        made_of=printed,
        text=alarms,
        left=lambda of: [f"{count} alarms of {kind}" for kind, count in of["kinds"].items()],
    ),
    Column(
        kind="trace",
        title="trace",
        how="each statement to the outputs and equations that it serves",
        made_of=printed,
        text=traced,
        left=lambda of: [str(word) for word in of["missing"]],
    ),
)


# ---------------------------------------------------------------- results of a whole folder


def unverified(units: Result) -> tuple[list[str], list[str]]:
    """Checks that do not hold, and those that were not made, with the reason."""
    answers = [(f"{name}, {what}", it) for name, of in units.items() for what, it in of["checks"].items()]
    return [name for name, it in answers if it is False], [
        f"{name}: {it}" for name, it in answers if isinstance(it, str)
    ]


def broken(units: Result) -> tuple[list[str], list[str]]:
    """Breaks of the sentence of the filter's header by hostile calls; and after memory was spoilt."""
    found = {
        key: [
            f"{build}: {kind} x{count}" for build, of in units.items() for kind, (count, _) in of[key].items() if count
        ]
        for key in ("breaks", "spoilt")
    }
    return found["breaks"], [f"after memory was spoilt, {line}" for line in found["spoilt"]]


def differing(units: Result) -> tuple[list[str], list[str]]:
    """Builds whose one flight had another hash."""
    return [f"{name}: other bits within {of['differs']} samples" for name, of in units.items() if of["differs"]], []


WHOLE = {
    "verified": ("verified", "the model against exact mechanics, the C against 50 digits", unverified),
    "attack": ("hostile calls", "every function with anything in it: the sentence of the filter's header", broken),
    "bits": ("one flight, one hash", "a million samples on every target", differing),
}


def place(folder: Folder) -> Path:
    """Where the results of a folder are kept: of Boresight's own models with them, of yours beside the folder."""
    if folder.results:
        return folder.results
    if folder.path.resolve().parent == generated().resolve():
        return RESULTS / f"{folder.name}.json"
    return folder.path.with_name(f"{folder.name}.evidence.json")


def kept(folder: Folder, results: Path | None = None) -> dict[str, Result]:
    """By kind, what is known of this C: `tools`, `units` by name; of a kind by unit those units alone whose text has
    not changed.  results: where they are kept, if not where the folder's are."""
    path = results or place(folder)
    found: dict[str, Result] = {}
    for kind, of in (json.loads(path.read_text()) if path.is_file() else {}).items():
        if "units" not in of:
            continue
        if list(of["sources"]) == [folder.name]:
            same = of["sources"][folder.name] in (folder.hash, folder.code) or of.get("folder") == folder.hash
            units = of["units"] if same else {}
        else:
            fresh = {u.name for u in folder.units if of["sources"].get(u.name) in u.hashes.values()}
            units = {name: result for name, result in of["units"].items() if name in fresh}
        if units:
            found[kind] = {"tools": of["tools"], "units": units}
    return found


def judged(folder: Folder, found: dict[str, Result]) -> dict[str, dict[str, Verdict]]:
    """By kind and unit, the verdict on each that is made of it; of a kind of the whole under the folder's name."""
    verdicts: dict[str, dict[str, Verdict]] = {}
    for column in COLUMNS:
        units = found.get(column.kind, {}).get("units", {})
        made = [unit for unit in folder.units if column.made_of(unit)]
        verdicts[column.kind] = {unit.name: column.verdict(units.get(unit.name)) for unit in made}
    for kind, (*_, judge) in WHOLE.items():
        if kind in found:
            wrong, left = judge(found[kind]["units"])
            verdicts[kind] = {folder.name: Verdict.WRONG if wrong else Verdict.LISTED if left else Verdict.HELD}
    return verdicts


def lowest(verdicts: dict[str, Verdict]) -> Verdict:
    return min(verdicts.values(), default=Verdict.NOT_MADE)


# ---------------------------------------------------------------- the page


def page_view(folder: Folder, found: dict[str, Result], why: str, make: str) -> dict[str, Any]:
    """What EVIDENCE.html shows.

    found: as `kept` gives it.  why: why there is none of it, or nothing.  make: how what is not made would be.
    """
    verdicts = judged(folder, found)
    results = {kind: of["units"] for kind, of in found.items()}
    stacks = list(results.get("stack", {}).values())
    return {
        "words": VERDICTS,
        "verdict": min(map(lowest, verdicts.values())),
        "why": why,
        "columns": [column.title for column in COLUMNS],
        "rows": [row(unit, results, verdicts) for unit in folder.units],
        "lowest": {column.kind: lowest(verdicts[column.kind]) for column in COLUMNS},
        "whole": [{"title": WHOLE[k][0], "verdict": lowest(verdicts[k])} for k in WHOLE if k in found],
        "open": [{"name": name, "lines": lines} for name, lines in left_open(folder, results) if lines],
        "make": make,
        "not_made": not_made(verdicts),
        "covered": coverage_of(list(results.get("coverage", {}).values())),
        "asked": ASKED,
        "cores": CORES,
        "entries": entries(stacks, results.get("golden", {})),
        "kept": [
            (name, [of["ram"].get(core, "-") for core in CORES])
            for name, of in results.get("stack", {}).items()
            if of.get("ram")
        ],
        "classes": classes(results.get("golden", {})),
        "library": sorted({name for of in stacks for name in of["library"]}),
        "assumed": ASSUMED,
        "deviated": deviations.of_folder(results.get("misra", {}).values()),
        "how": [
            *((c.title, c.how, found[c.kind]["tools"]) for c in COLUMNS if c.kind in found),
            *((WHOLE[k][0], WHOLE[k][1], found[k]["tools"]) for k in WHOLE if k in found),
        ],
    }


def row(unit: Source, results: dict[str, Result], verdicts: dict[str, dict[str, Verdict]]) -> dict[str, Any]:
    def cell(column: Column) -> dict[str, Any]:
        of, verdict = results.get(column.kind, {}).get(unit.name), verdicts[column.kind].get(unit.name)
        return {"text": column.text(of) if of else "-" if verdict is None else "not made", "verdict": verdict}

    return {"name": unit.name, "cells": [cell(column) for column in COLUMNS]}


def left_open(folder: Folder, results: dict[str, Result]) -> list[tuple[str, list[str]]]:
    """What each unit, the headers and the kinds of the whole leave open or have wrong, in words."""
    names = [unit.name for unit in folder.units]
    found = [
        (
            name,
            [
                f"{column.title}: {line}"
                for column in COLUMNS
                if (of := results.get(column.kind, {}).get(name))
                for line in (*column.wrong(of), *column.left(of))
            ],
        )
        for name in (*names, "include")
    ]
    whole = [(title, judge(results[kind])) for kind, (title, _, judge) in WHOLE.items() if kind in results]
    return found + [(title, [*wrong, *left]) for title, (wrong, left) in whole]


def not_made(verdicts: dict[str, dict[str, Verdict]]) -> list[tuple[str, str]]:
    """By column, the units that it is not made of."""
    found = []
    for column in COLUMNS:
        names = [name for name, verdict in verdicts[column.kind].items() if verdict is Verdict.NOT_MADE]
        if names:
            found.append((column.title, "all" if len(names) == len(verdicts[column.kind]) else ", ".join(names)))
    return found


def coverage_of(units: list[Result]) -> list[tuple[str, str, str]]:
    """Of a whole folder, by precision: of all, and of what a call can reach."""
    by_precision = [(one, shares(units, (one,)), shares(units, (one,), reach=True)) for one in ("double", "float")]
    return by_precision if units else []


def classes(golden: Result) -> list[dict[str, Any]]:
    """Of each function the words that its dearest call loads and stores, its divisions and roots, by core; and a bound
    in cycles on a Cortex-M4F, or nothing where none is held."""
    return [
        {"name": name, "numbers": [*(" / ".join(map(str, by.get(core, [])[:4])) for core in CORES), *by[CORES[0]][4:]]}
        for of in golden.values()
        for name, by in of.get("classes", {}).items()
        if CORES[0] in by
    ]


def entries(stacks: list[Result], golden: Result) -> list[dict[str, Any]]:
    """Stack by the graph of calls, stack that was painted over, and instructions of each entry point, by core."""
    costs = {name: cost for of in golden.values() for name, cost in of.get("cost", {}).items()}
    return [
        {
            "name": name,
            "numbers": [
                *(stack.get(core, "-") for core in CORES),
                *(costs.get(name, {}).get(core, ["-", "-"])[k] for k in (1, 0) for core in CORES),
            ],
        }
        for of in stacks
        for name, stack in of["stack"].items()
    ]
