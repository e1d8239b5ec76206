"""The page of a paper, of some of its equations, or of a derivation."""

import re
from collections.abc import Iterable, Mapping, Set
from dataclasses import replace
from functools import cache
from shlex import quote
from types import MappingProxyType
from typing import Any

from mpmath import nstr
from sympy import Symbol

from boresight import BoresightError
from boresight.derive.ledger.differences import Place, deciding, differences, marks
from boresight.derive.ledger.dimensions import grids
from boresight.derive.ledger.entries import LONG, Entry, apart, entry_of, findings, letter_units, numbers_of
from boresight.derive.ledger.equation import Derivation, Equation, Line, Passage, Quantity, Relation
from boresight.derive.ledger.evaluate import DIGITS
from boresight.derive.ledger.lines import count_steps, judge_line, standing
from boresight.derive.ledger.mends import SHOWN, mends
from boresight.derive.ledger.numbers import digits
from boresight.derive.ledger.paper import Paper
from boresight.derive.pages.blocks import Block, Form, Formulas, Page, Pair, Prose, Section, Table
from boresight.derive.pages.maps import sections as maps
from boresight.derive.units import unit as unit_of

NOTHING: Mapping[Any, str] = MappingProxyType({})
Functions = Mapping[str, Mapping[str, tuple[str, ...]]]  # "song-lee-2001 (19)": model: its C functions


def paper_page(paper: Paper, functions: Functions) -> Page:
    entries = [entry_of(paper, equation) for equation in paper.equations]
    beside = tuple(Prose(finding) for finding in findings(paper))
    page = equations_page(paper.name, [(paper, e) for e in paper.equations], functions)
    steps = str(count_steps(paper.equations))
    name = f"`{paper.name}`" if paper.folder else paper.name  # a folder's, no letter
    if paper.folder:  # nothing stands on it that is not its own
        bare = sum(not standing(paper, equation).derivation.steps for equation in paper.equations)
        steps = f"{bare} without a derivation" if bare else steps
    return replace(
        page,
        title=paper.reference,
        lead=(f"{name}: {counted(paper.equations)}: {counts(entries)}; {steps}.",),
        front=(
            Section("Conventions", (*conventions(paper), *STATUSES)),
            Section("Notation", (notation(paper),)),
        ),
        back=((Section("Beside the equations", beside),) if beside else ()) + maps(paper),
    )


def equations_page(name: str, chosen: Iterable[tuple[Paper, Equation]], functions: Functions) -> Page:
    """Equations of one paper or of several; behind them their letters, and each paper's conventions."""
    chosen = list(chosen)
    papers = list(dict.fromkeys(p for p, _ in chosen))
    back: list[Section] = []
    for paper in papers:
        of_paper = f" of {paper.name}" if len(papers) > 1 else ""
        used = [quantity for p, equation in chosen if p is paper for quantity in letters_in(equation)]
        back.append(Section(f"Notation{of_paper}", (notation(paper, used),)))
        back.append(Section(f"Conventions{of_paper}", conventions(paper)))
    return Page(
        name,
        tuple(equation_section(paper, equation, functions) for paper, equation in chosen),
        back=tuple(section for section in back if section.blocks),
        anchors={e.label: anchor(e) for _, e in chosen if e.numbered} if len(papers) == 1 else {},
        letters=tuple(quantity for one in papers for quantity in (*one.quantities(), *one.letters())),
        name=name,
    )


def conventions(paper: Paper) -> tuple[Prose, ...]:
    """Those of all papers, but for one of a reader's own, and then its own."""
    return tuple(map(Prose, paper.conventions if paper.folder else (*CONVENTIONS, *paper.conventions)))


def letters_in(equation: Equation) -> list[Quantity]:
    """Those of its print, of what is derived, and of its steps."""
    relations = (*equation.printed, *equation.derived, *(one for s in equation.derivation.steps for one in s.formulas))
    names = {symbol.name for relation in relations for side in relation.sides for symbol in side.free_symbols}
    return [quantity for quantity in equation.alphabet if quantity.symbol.name in names]


def equation_section(paper: Paper, equation: Equation, functions: Functions) -> Section:
    """What is judged, the print against what follows, the evidence, the steps; then who uses and who holds it."""
    entry, equation = entry_of(paper, equation), standing(paper, equation)
    letters = equation.alphabet
    refused = [Prose(typed(equation.refused), "Its derivation is refused")] if equation.refused else []
    blocks: list[Block] = [*refused, Prose(f"{entry.decisions} {entry.depends}".strip(), "Decided by hand")]
    blocks += [*forms(paper, equation, entry, letters), *evidence(paper, equation, entry)]
    if entry.note:
        blocks.append(Prose(entry.note, "Note"))
    decided = deciding(equation) if entry.status == "erratum" else set()
    blocks += steps(equation.derivation, letters, paper.witness.parts, dropped(paper, equation), decided)
    for model, names in functions.get(f"{equation.paper} ({equation.number})", {}).items():
        blocks.append(Prose(", ".join(names), f"In C of {model}", code=True))
    # a number in Greek letters is set by no typewriter face of LaTeX; then all of the paper is judged
    held = f"boresight equations {quote(paper.folder or paper.name)}"
    held += f" {quote(equation.number)}" * equation.number.isascii()
    blocks.append(Prose(held, "Held by", code=True))
    first, last = equation.lines
    source = f"source line {first}" if first == last else f"source lines {first} to {last}"
    source = f"printed.tex, line {first}" if paper.folder else source if first else "derived here"
    title = f"{equation.paper} {equation.label}"
    return Section(title, tuple(blocks), anchor(equation), status(entry), source)


def typed(text: str) -> str:
    """With files and LaTeX marked as what is typed."""
    text = re.sub(r"(?<!\w)'([^'`]*\\[^'`]*)'(?!\w)", r"`\1`", text)
    parts = re.split(r"(`[^`]*`)", text)
    parts[::2] = [re.sub(r"\S+\.toml(?::\d+)*|\\[A-Za-z]+(?:\{[^{}]*\})*", r"`\g<0>`", part) for part in parts[::2]]
    return "".join(parts)


def forms(paper: Paper, equation: Equation, entry: Entry, letters: tuple[Quantity, ...]) -> list[Block]:
    """The print, and beside it what is derived where the two differ."""
    found = differences(equation.printed, equation.derived)
    printed, derived, page = equation.printed, equation.derived, equation.page_letters
    as_spelled = spelled(printed, page)
    if not found:
        more = derived[len(printed) :]
        label = "printed and derived" if equation.latex else "derived"
        label = "printed" if paper.folder and not equation.derivation.steps else label
        blocks: list[Block] = [Formulas(_forms(printed, page), label, _displays(equation))]
        if as_spelled != printed:  # what is read into the letters is not of the print
            left = Formulas(_forms(as_spelled, page), "printed", _displays(equation))
            blocks = [Pair(left, Formulas(_forms(printed, page), "as read, and derived"))]
        return blocks + ([Formulas(_forms(more, letters), "derived with it")] if more else [])
    if entry.status == "erratum":  # what is only read otherwise is no slip: the note says it
        found = differences(equation.read(), derived)
    elif not equation.readings:
        left = Formulas(_forms(as_spelled, page), "printed", _displays(equation))
        return [Pair(left, Formulas(_forms(derived, page), "derived"))]
    left = Formulas(_forms(as_spelled, page, marks(printed, found, "printed")), "printed")
    return [Pair(left, Formulas(_forms(derived, page, marks(derived, found, "derived")), "derived"))]


def spelled(relations: tuple[Relation, ...], letters: Iterable[Quantity]) -> tuple[Relation, ...]:
    """Relations with the vector in the place of its cross-product matrix where the print writes no matrix."""
    latex = {quantity.symbol: quantity.latex for quantity in letters}
    bare = {
        symbol: Symbol(symbol.name[1:-3], commutative=False)
        for symbol, text in latex.items()
        if re.fullmatch(r"\[.* x\]", symbol.name) and r"\times" not in text
    }
    used = [bare.keys() & {symbol for side in r.sides for symbol in side.free_symbols} for r in relations]
    return tuple(r.replaced(bare) if some else r for r, some in zip(relations, used, strict=True))


def _displays(equation: Equation) -> tuple[str, ...]:
    """The displays as printed, those that go on joined to what they go on from."""
    joined: list[str] = []
    for display in equation.latex:
        if not display.startswith(r"\begin{aligned}"):  # a row of a display that holds several equations
            display = display.replace("&=", "=")
        if joined and display[0] in "=+-":
            joined[-1] += " " + display
        else:
            joined.append(display)
    return tuple(display.rstrip(", ") for display in joined)


def _forms(relations: Iterable[Relation], quantities: Iterable[Quantity], places: Iterable[set[Place]] = ()):
    quantities, relations = tuple(quantities), tuple(relations)
    places = list(places) or [set[Place]()] * len(relations)
    return tuple(Form(r, quantities, frozenset(p)) for r, p in zip(relations, places, strict=True))


def evidence(paper: Paper, equation: Equation, entry: Entry) -> list[Block]:
    """What was found, the numbers of each slip, and what the paper's own consequences say, as sentences."""
    own = paper.evidence(equation.number)
    judged = entry.evidence.removesuffix(f"; {own}" if own else "")
    if paper.folder and entry.status == "erratum" and not equation.derivation.steps:
        return [Prose(sentences(judged), "As printed"), *proposals(paper, equation)]
    if entry.status != "erratum":
        return [Prose(sentences(judged), "Evidence"), *([Prose(sentences(own), "Sizes")] if own else [])]
    why = judged.partition(f"; at {paper.point.text}")[0]
    blocks: list[Block] = [
        Prose(f"{sentences(why)} In numbers at {paper.point.text}:", "As printed"),
        _numbers(paper, equation),
    ]
    return blocks + ([Prose(sentences(own), "What it does")] if own else [])


def proposals(paper: Paper, equation: Equation) -> list[Block]:
    """The first single edits that make a misprint true, each where it differs marked."""
    with digits(DIGITS):
        edits = mends(paper, equation)
    if not edits:
        return [Prose("no single edit makes it true.", "Mends")]
    blocks: list[Block] = []
    for i, edit in enumerate(edits[:SHOWN], 1):
        found = differences(equation.printed, edit.relations)
        forms = _forms(edit.relations, equation.page_letters, marks(edit.relations, found, "derived"))
        blocks += [Prose(f"{edit.what}; then it is {edit.status}.", f"Mend {i} of {len(edits)}"), Formulas(forms)]
    return blocks


def _numbers(paper: Paper, equation: Equation) -> Table:
    """True, printed and derived; of more than LONG numbers only by how much the largest error is off."""
    rows: list[tuple[str | tuple[Form, ...], ...]] = []
    with digits(DIGITS):
        for n in numbers_of(paper, equation):
            letter: str | tuple[Form, ...] = ""
            if n.what:
                letter = (Form(Relation((paper.letter(n.what).symbol,)), equation.alphabet),)
            if len(n.true) > LONG:
                printed = f"off by {apart(n.true, n.printed)}" if n.printed else "no value"
                entries = f"{len(n.true)} entries"
                rows.append((letter, entries, printed, f"off by {apart(n.true, n.derived)}", n.unit))
                continue
            for k, true in enumerate(n.true):
                printed = nstr(n.printed[k], 5) if n.printed else "no value"
                rows.append((letter, nstr(true, 5), printed, nstr(n.derived[k], 5), n.unit))
                letter = ""
    return Table(("", "true", "printed", "derived", "unit"), tuple(rows))


def sentences(text: str) -> str:
    """Clauses between semicolons as a sentence."""
    begins = text[1:2].isalpha()  # with a word, not with a letter of the paper
    return (text[:1].upper() if begins else text[:1]) + text[1:] + ("" if text.endswith(".") else ".")


def dropped(paper: Paper, equation: Equation) -> dict[int, str]:
    """By step, the largest size of the term that an approximation drops, at the paper's own numbers."""
    found = {}
    for i, step in enumerate(equation.derivation.steps):
        if step.claim is not None and step.claim.kind == "approximation":
            with digits(DIGITS):
                size = judge_line(paper, equation, i).size
            unit = equation.unit
            if not isinstance(unit, str) and step.relation is not None:  # rows of several units
                unit = " and ".join(dict.fromkeys(letter_units(paper, step.relation.sides[0])))
            found[i] = f"{size} {unit}".removesuffix(" 1")
    return found


def steps(
    derivation: Derivation,
    letters: tuple[Quantity, ...],
    parts: Mapping[str, str] = NOTHING,
    sizes: Mapping[int, str] = NOTHING,
    decided: Set[int] = frozenset(),
) -> tuple[Block, ...]:
    """parts: the errors of claims, in words; sizes: by step, how large what it drops is; decided: those to mark."""
    blocks: list[Block] = []
    for i, step in enumerate(derivation.steps):
        done, claim = _done(step, letters), _claimed(step, parts)
        claim = "" if claim == done else claim + (f"; at most {sizes[i]} is dropped" if i in sizes else "")
        label = f"{i + 1}. Decides" if i in decided else f"{i + 1}."
        blocks.append(Prose(f"{done}: {step.why}." + (f" ({claim})" if claim else ""), label))
        if step.formulas:
            blocks.append(Formulas(_forms(step.formulas, letters)))
    return tuple(blocks)


def _done(step: Line, letters: tuple[Quantity, ...]) -> str:
    """The operation, from which line, about which letters and with which other lines: the line before needs no name."""
    if step.passage is None:
        return step.name.replace("first-order", "first order")
    of, using = step.passage.of, step.passage.using
    about = _about(step.passage, letters) if letters else ""
    name = step.name.removesuffix(" line") if _row(of).startswith("line") else step.name
    return name + f" {_row(of)}" * bool(of) + about + (", with " + " and ".join(map(_row, using)) if using else "")


ABOUT = {"expand": " in ", "leave out": " ", "solve": " for ", "find the minimum": " along "}
PAIRS = {"differentiate": "{1} the rate of {0}", "carry over": "{1} for {0}"}


def _about(passage: Passage, letters: tuple[Quantity, ...]) -> str:
    names = {q.latex: q.symbol.name for q in letters}
    about = [names.get(latex, latex) for latex in passage.letters]
    if passage.operation in PAIRS:
        others = [names.get(latex, latex) for latex in passage.with_]
        pairs = [PAIRS[passage.operation].format(*two) for two in zip(about, others, strict=True)]
        return f", {', '.join(pairs)}"
    return ABOUT[passage.operation] + ", ".join(about) if about and passage.operation in ABOUT else ""


def _row(name: str) -> str:
    return name if name.startswith("(") else f"line {name}"


def _claimed(step: Line, parts: Mapping[str, str]) -> str:
    claim = step.claim
    if claim is None:
        return ""
    small = f" in {', '.join(parts.get(part, part.replace('_', ' ')) for part in claim.small)}" if claim.small else ""
    order = {"order": f"through order {claim.order}", "first-order": "first order"}.get(claim.kind, claim.kind)
    return order + small + f", {claim.condition}" * bool(claim.condition)


def notation(paper: Paper, letters: Iterable[Quantity] | None = None) -> Table:
    """Letters, by default all of the paper; the unit is what stands behind the last comma of the meaning.

    Letters of one meaning share a row, unless it refers to the row before.
    """
    letters = (*paper.quantities(), *paper.letters()) if letters is None else tuple(letters)
    rows: dict[str, list[Form]] = {}
    for quantity in {quantity.symbol.name: quantity for quantity in letters}.values():
        if quantity.function or quantity.kind == "block":
            continue
        form = Form(Relation((quantity.symbol,)), letters)
        refers = quantity.meaning.startswith(("its ", "their ", "the same"))
        rows.setdefault(quantity.meaning + "\n" * len(rows) * refers, []).append(form)
    mixed = grids(paper, (one for one in letters if {one.symbol.name, one.kind} & paper.units.keys()))

    def row(forms: list[Form], meaning: str) -> tuple[str | tuple[Form, ...], ...]:
        text, unit = _with_unit(meaning, bool(paper.folder))
        own = {str(entry) for form in forms for entry in mixed.get(form.relation.sides[0].name, ()) if entry}
        return tuple(forms), text, unit if not own else own.pop() if len(own) == 1 else "by entry"

    return Table(("letter", "meaning", "unit"), tuple(row(forms, meaning) for meaning, forms in rows.items()), 1)


def _with_unit(meaning: str, any_unit: bool) -> tuple[str, str]:
    text, comma, unit = meaning.strip().rpartition(", ")
    known = comma and (re.fullmatch(UNIT, unit) or (any_unit and is_unit(unit)))
    return (text, unit) if known else (meaning.strip(), "")


@cache
def is_unit(text: str) -> bool:
    try:
        unit_of(text)
    except BoresightError:
        return False
    return True


UNIT = r"(1|m|rad|s|Hz)(/s|/s\^2)?"


def status(entry: Entry) -> str:
    return f"{entry.status}: {', '.join(filter(None, (entry.kind, entry.origin)))}" if entry.kind else entry.status


def anchor(equation: Equation) -> str:
    return f"eq-{equation.number}" if equation.numbered else f"line-{equation.lines[0]}"


def counted(equations: Iterable[Equation]) -> str:
    numbers = [equation.numbered for equation in equations]
    beside = f" and {numbers.count(False)} without a number" if False in numbers else ""
    count = numbers.count(True)
    return f"{count} equation{'s' * (count != 1)}{beside}"


def counts(entries: Iterable[Entry]) -> str:
    found = [entry.status for entry in entries]
    order = ("exact", "first-order", "definition", "erratum")
    return ", ".join(f"{found.count(status)} {status}" for status in order if status in found)


STATUSES = (
    Prose("both sides agree at finite errors, to 28 digits", "exact"),
    Prose("the sides differ by a remainder that falls fourfold when the errors are halved", "first-order"),
    Prose("it gives a letter its meaning, and no other equation of the paper contradicts it", "definition"),
    Prose("read literally with the paper's own definitions it is refuted, or it has no meaning", "erratum"),
    Prose("of the derivation of an erratum, the first step that has what the print has otherwise", "decides"),
)
CONVENTIONS = (
    "C_b2n turns components in b into components in n; papers write it with b below and n above.",
    "[v x] a is the cross product of v and a: [v x] is the skew-symmetric matrix of v.",
    "A hat marks what is computed, a dot the time derivative; an error is computed - true.",
    "ω_ie_n is the rate of e against i in components of n. Units are SI, angles are in rad.",
)
