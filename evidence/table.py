"""The table of docs/evidence.md, from the committed results."""

from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

from boresight.codegen import deviations, proof
from boresight.codegen.folder import Source, folders
from boresight.derive.ledger.mutation import ALIAS, SAME, SECOND_ORDER, UNEXPLAINED
from boresight.evidence import results
from boresight.evidence.bits import MODEL, NOT_FLOWN
from boresight.evidence.proofs import kept as proved
from boresight.evidence.sources import Drawn, Flights, derivations

PAGE = Path(__file__).resolve().parent.parent / "docs" / "evidence.md"
BEGIN, END = "<!-- from here on written by make evidence -->\n", "<!-- to here -->\n"
HEAD = (
    *("unit", "operations", "bytes", "M4F float", "M7 float", "M7 double", "bits", "M4F double"),
    *(column.title for column in proof.COLUMNS if column.kind != "golden"),
)
STEPS = (
    *("paper", "steps", "evaluated", "prose", "mutants", "refuted"),
    *("say the same", "another name", "second order", "unexplained"),
)
REASONS = (SAME, ALIAS, SECOND_ORDER, UNEXPLAINED)


def page(text: str) -> str:
    """The page with its tables made anew."""
    before, rest = text.split(BEGIN)
    return before + BEGIN + tables() + END + rest.split(END)[1]


def tables() -> str:
    parts = []
    for folder in folders():
        kept = results.read(folder)
        rows = [row(unit, {kind: of["units"].get(unit.name, {}) for kind, of in kept.items()}) for unit in folder.units]
        parts.append(section(folder.name, HEAD, rows))
    more = (
        covered,
        deviated,
        verifications,
        one_flight,
        hostile,
        on_a_gpu,
        drawn,
        proofs,
        steps,
        shown,
        written,
        flights,
    )
    return "".join(parts) + "".join(made() for made in more) + "\n"


def section(title: str, head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    lines = [head, ("---",) * len(head), *rows]
    return f"\n## {title}\n\n" + "\n".join(f"| {' | '.join(line)} |" for line in lines) + "\n"


def covered() -> str:
    """Of each folder, by precision."""
    head = ("lines / branches / MC/DC, %", "precision", "of all", "of what a call can reach")
    rows: list[tuple[str, ...]] = [
        (folder.name, *row)
        for folder in folders()
        for row in proof.coverage_of(list(results.read(folder).get("coverage", {}).get("units", {}).values()))
    ]
    return section("Coverage of the self-tests", head, rows)


BAR = r"\|"  # within a cell


def deviated() -> str:
    """Where the C breaks a rule of MISRA C:2012 on purpose, with the reason."""
    units = (of for folder in folders() for of in results.read(folder).get("misra", {}).get("units", {}).values())
    rows: list[tuple[str, ...]] = [
        (one.rule, str(count), f"`{line.replace('|', BAR)}`" if line else "all", one.reason)
        for one, count, line in deviations.of_folder(units)
    ]
    return section("MISRA: deviated", ("rule", "times", "in lines like", "reason"), rows)


HASHES = ("build", "samples", "SHA-256 begins", "first difference", "refused", "flush to zero", "control register")


def one_flight() -> str:
    """What each build flew, and when it differed first."""
    (folder,) = (folder for folder in folders() if folder.name == MODEL)
    kept = results.read(folder).get("bits", {}).get("units", {})
    rows: list[tuple[str, ...]] = [
        (
            name,
            str(of["samples"]),
            of["sha256"][:16],
            f"within {of['differs']}" if of["differs"] else "none",
            str(of["refused"]),
            " and ".join(word for word, on in zip(("results", "inputs"), of["flushed"], strict=True) if on) or "no",
            hex(of["control"]) if of["control"] else "-",
        )
        for name, of in kept.items()
    ]
    rows += [(name, *"-" * 5, why) for name, why in NOT_FLOWN.items() if kept]
    return section("One flight, one hash", HASHES, rows)


VERIFIED = ("model", "functions", "checks that hold", "that do not", "not checked, and why")


def verifications() -> str:
    """What `boresight verify` finds of each model."""
    rows: list[tuple[str, ...]] = []
    for folder in folders():
        if kept := results.read(folder).get("verified", {}).get("units", {}):
            answers = [(name, answer) for name, of in kept.items() for answer in of["checks"].values()]
            held, broken = (sum(answer is wanted for _, answer in answers) for wanted in (True, False))
            why = "; ".join(f"{name}: {answer}" for name, answer in answers if isinstance(answer, str))
            rows.append((folder.name, str(len(kept)), str(held), str(broken), why or "-"))
    return section("Models and their C, verified", VERIFIED, rows)


HOSTILE = ("model", "build", "calls", "OK", "refused", "breaks", "breaks after memory was spoilt")


def hostile() -> str:
    """How often the sentence of the filter's header was broken, by model, precision and form."""
    rows: list[tuple[str, ...]] = []
    for folder in folders():
        for name, of in results.read(folder).get("attack", {}).get("units", {}).items():
            counts = (of["answers"].get("0", 0), sum(of["answers"].values()) - of["answers"].get("0", 0))
            broken = (sum(count for count, _ in of[kind].values()) for kind in ("breaks", "spoilt"))
            rows.append((folder.name, name, str(of["calls"]), *map(str, counts), *map(str, broken)))
    return section("Hostile calls", HOSTILE, rows)


BY_NVRTC = ("model", "build", "add, sub, mul", "div, rcp", "sqrt", "may differ from the host", "bytes")


def on_a_gpu() -> str:
    """The floating operations of each filter's text for a GPU, and what of it may have other bits than the host."""
    rows: list[tuple[str, ...]] = []
    for folder in folders():
        for name, of in results.read(folder).get("gpu", {}).get("units", {}).items():
            count = Counter[str]()
            for operation, often in of["operations"].items():
                count[operation.split(".")[0]] += often
            sums = (("add", "sub", "mul"), ("div", "rcp"), ("sqrt",))
            numbers = (str(sum(count[one] for one in kinds)) for kinds in sums)
            rows.append((folder.name, name, *numbers, ", ".join(of["faults"]) or "0", str(of["bytes"])))
    return section("For a GPU", BY_NVRTC, rows)


def steps() -> str:
    """How every single mutation of a step came out, by paper; a dash where nothing is kept."""
    rows: list[tuple[str, ...]] = []
    for paper in derivations():
        kept = results.read(paper).get("steps", {}).get("units", {}).values()
        numbers = [sum(of[name] for of in kept) for name in ("steps", "evaluated", "prose", "tried")]
        reasons = sum((Counter[str](of["survivors"]) for of in kept), Counter[str]())
        numbers += [numbers[-1] - reasons.total(), *(reasons[reason] for reason in REASONS)]
        rows.append((paper.name, *(map(str, numbers) if kept else "-" * len(numbers))))
    return section("Steps of the derivations", STEPS, rows)


SHOWN = ("paper", "format", "formulas", "changes", "refused", "unequal", "say the same", "left")


def shown() -> str:
    """How every single change of a shown formula came out, by paper and format."""
    rows: list[tuple[str, ...]] = []
    for paper in derivations():
        for form, of in results.read(paper).get("shown", {}).get("units", {}).items():
            counts = (of[key] for key in ("formulas", "tried", "refused", "unequal"))
            same = ", ".join(f"{count} {reason}" for reason, count in of["same"].items() if count) or "0"
            rows.append((paper.name, form, *map(str, counts), same, str(len(of["left"]))))
    return section("Formulas as they are shown", SHOWN, rows)


WRITTEN = (
    "page of",
    "lines at 60",
    "widest",
    "lines at 100",
    "widest",
    "elements of HTML",
    "characters of LaTeX",
    "PDF",
)


def written() -> str:
    """Every page in every format, and whether its LaTeX compiles."""
    rows: list[tuple[str, ...]] = []
    for kept in (*map(results.read, derivations()), *map(results.read, folders())):
        for name, of in kept.get("pages", {}).get("units", {}).items():
            texts = (str(of[f"text {width}"][what]) for width in (60, 100) for what in ("lines", "widest"))
            made = "compiles" if of["pdf"] else "FAILED"
            rows.append((name, *texts, str(of["html"]), str(of["latex"]["characters"]), made))
    return section("Pages in every format", WRITTEN, rows) if rows else ""


PROVED = ("model", "outputs", "bounded", "of these exact", "within ten", "median", "accepted by Coq")
LACKING = "Rounding over the box: without a bound, or with a wide one"
WITHOUT = ("unit", "outputs", "why")


def proofs() -> str:
    """Of each model how many outputs have a bound on their rounding over the whole box; those without, and the wide."""
    rows: list[tuple[str, ...]] = []
    lacking: list[tuple[str, ...]] = []
    everything: list[proved.Output] = []
    checked = Counter[str]()
    for folder in folders():
        kept = proved.read(folder)
        judged = proved.judged(folder)
        found = [output for outputs in judged.values() for output in outputs]
        coq = Counter[str]()
        for unit in kept.values():
            coq.update({key: unit["coq"][key] for key in ("accepted", "of") if "coq" in unit})
        if found:
            rows.append((folder.name, *proved_share(found, coq)))
        everything += found
        checked += coq
        for name, outputs in sorted(judged.items()):
            lacking += without(name, outputs)
    if not rows:
        return ""
    rows.append(("all", *proved_share(everything, checked)))
    return section("Rounding over the box", PROVED, rows) + section(LACKING, WITHOUT, lacking)


def proved_share(outputs: list[proved.Output], coq: Counter[str]) -> tuple[str, ...]:
    bounded = [output for output in outputs if output.bounded]
    tight = sum(output.tight for output in bounded)
    ratios = sorted(output.ratio for output in bounded if output.bound)
    return (
        str(len(outputs)),
        f"{len(bounded)} ({100 * len(bounded) / len(outputs):.1f} %)",
        str(sum(output.bound == 0 for output in bounded)),
        f"{tight} ({100 * tight / max(1, len(bounded)):.1f} %)",
        f"{ratios[len(ratios) // 2]:.2g}x" if ratios else "-",
        f"{coq['accepted']} of {coq['of']}" if coq["of"] else "-",
    )


def without(unit: str, outputs: list[proved.Output]) -> list[tuple[str, ...]]:
    """A line for each reason, and for the bounds that are wider than is asked, with by how much."""
    groups = [(why, [o for o in outputs if o.why == why]) for why in dict.fromkeys(o.why for o in outputs if o.why)]
    nothing = [o for o in outputs if o.bound is not None and not o.bounded]
    wide = [o for o in outputs if o.bounded and not o.tight]
    for of, words in ((nothing, "none that says anything: {} times"), (wide, "bounded, but by {} times")):
        most = max((output.ratio for output in of), default=0)
        groups.append((words.format(f"up to {most:.2g}") + " the worst error found", of))
    return [
        (unit, "all" if len(of) == len(outputs) else listed([output.name for output in of]), words)
        for words, of in groups
        if of
    ]


def listed(names: list[str]) -> str:
    return " ".join(name.replace(", ", ",") for name in names)


MODELS = ("number", "kind", "states", "double", "float")


def drawn() -> str:
    """Of models drawn by a number, whether the self-test that is printed of each passes."""
    kept = results.read(Drawn()).get("drawn", {}).get("units", {})
    rows = [(name, *(str(of[key]) for key in ("kind", "states", "double", "float"))) for name, of in kept.items()]
    return section("Self-tests of drawn models", MODELS, rows) if rows else ""


FLOWN = ("condition", "asked", "so", "NEES, second half", "last 5 s", "band", "refused", "attitude, mrad", "claimed",
         "delay, ms", "claimed", "events, of runs")  # fmt: skip


def flights() -> str:
    """What came of each condition that the live loop was tried in."""
    kept = results.read(Flights()).get("tried", {}).get("units", {})
    rows: list[tuple[str, ...]] = []
    for name, of in kept.items():
        numbers = (
            f"{of[key]:.3g}" for key in ("attitude_mrad", "attitude_mrad_claimed", "delay_ms", "delay_ms_claimed")
        )
        events = "; ".join(of["events"]).replace("|", "/")
        rows.append((
            name, of["asked"], "yes" if of["ok"] else "**no**", f"{of['nees']:.3g}", f"{of['end']:.3g}",
            f"{of['low']:.1f} to {of['high']:.1f}", f"{100 * of['refused']:.2g} %", *numbers,
            f"{events} ({100 * of['told']:.0f} %)" if events else "none",
        ))  # fmt: skip
    return section("Flights of the live loop", FLOWN, rows) if rows else ""


def row(unit: Source, of: dict[str, dict[str, Any]]) -> tuple[str, ...]:
    """One unit's line; what was not computed, or cannot be for a template, is a dash."""
    golden, builds = of.get("golden", {}), of.get("golden", {}).get("builds", {})
    costs = golden.get("cost", {})
    main = unit.described["c_name"] if unit.described else max(costs, key=lambda f: worst(costs[f]), default="")
    cost = costs.get(main, {})

    def paid(where: str) -> str:
        return f"{cost[where][0]} ({cost[where][1]} B)" if where in cost else "-"

    def words(column: str, of_unit: Callable[[dict[str, Any]], str]) -> str:
        return of_unit(of[column]) if of.get(column) else "-"

    return (
        unit.name if unit.described or not main else f"{unit.name}: {main}",
        str(golden.get("operations") or "-"),
        str(golden.get("text", {}).get("cortex-m4f float", "-")),
        *(paid(where) for where in proof.CORES),
        proof.bits(builds, proof.CORES),
        proof.bits(builds, ("cortex-m4f double",)),
        *(words(column.kind, column.text) for column in proof.COLUMNS if column.kind != "golden"),
    )


def worst(cost: dict[str, list[int]]) -> int:
    return max((instructions for instructions, _ in cost.values()), default=0)
