"""The page of a difference: entry by entry before and after, with the names that a model's own page has."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from sympy import Matrix, Symbol

from boresight.codegen.difference import POINTS, Cost, Difference, Entry, Names, Statement, together
from boresight.codegen.text.equations import unchecked
from boresight.derive.expressions import substituted
from boresight.derive.ledger.differences import differences, marks
from boresight.derive.model import Function, Model, Output, Struct
from boresight.derive.pages.blocks import Block, Form, Formulas, Page, Pair, Prose, Section
from boresight.derive.pages.model import Description, forms, lettered, letters_of, names_of

SIZES = (
    f"Sizes are the largest at {POINTS} points of the box, in SI units and rad; as part of a row they are of "
    "the largest entry in it, each times the box of its state."
)


def differences_page(found: Sequence[Difference]) -> Page:
    """One page of what differs in one or more models; text, LaTeX and HTML are written of it."""
    different = [one for one in found if not one.same]
    sections = tuple(
        replace(section, title=f"{one.model}, {section.title}" if len(found) > 1 else section.title)
        for one in different
        for section in sections_of(one)
    )
    title = found[0].model if len(found) == 1 else f"{len(different)} of {len(found)} models"
    sections = sections or (Section("", (Prose("No difference."),)),)
    return Page(f"{title}: against {found[0].against}", sections, (SIZES,) if different else ())


def sections_of(found: Difference) -> tuple[Section, ...]:
    apart = [entry for entry in found.entries if not entry.by]
    changed = [entry for entry in apart if not entry.rounding and not entry.constants]
    names = Names(found.old, found.new)
    shown = Description(both(found, names, [*found.quantities, *changed]))
    sections = [
        *([Section("what is stated", tuple(map(stated, found.statements)))] if found.statements else []),
        *quantity_sections(found, names, shown),
        *matrix_sections(found, apart, changed, shown),
    ]
    used = {s for section in sections for form in forms(section) for s in letters_of(form.relation)}
    sections += names_of(shown, used)
    if found.cost:
        sections.append(Section("cost", tuple(cost(found.cost))))
    return lettered(shown, Page("", tuple(sections))).sections


def both(found: Difference, names: Names, changed: list[Entry]) -> Model:
    """A model whose functions are the entries before and after, with one letter for both of a name that differs."""
    before, after = (
        Matrix([0 if value is None else names.opaque(side, value) for value in values])
        for side, values in enumerate(([e.before for e in changed], [e.after for e in changed]))
    )
    columns = ("before", substituted(before, names.swap)), ("after", after)
    functions = tuple(
        Function(name, name, (Output("entries", column, "1", name),)) for name, column in columns if changed
    )
    struct = Struct("both", "what either reads", together(found.old, found.new))
    made: Model = unchecked(Model, name=found.model, states=(), structs=(struct,), measurements=(), functions=functions)
    return made


def stated(statement: Statement) -> Prose:
    what = statement.part + f", {statement.field}" * bool(statement.field)
    if statement.before is None:
        return Prose(f"new; {statement.after}", what)
    if statement.after is None:
        return Prose(f"gone; {statement.before}", what)
    return Prose(f"was {statement.before or 'not stated'}; is {statement.after or 'not stated'}", what)


def quantity_sections(found: Difference, names: Names, shown: Description) -> Iterator[Section]:
    """What differs in a named quantity itself, and the entries that move by it alone."""
    for label in dict.fromkeys(entry.matrix for entry in found.quantities):
        own = [(i, e) for i, e in enumerate(found.quantities) if e.matrix == label]
        relations = [
            (Symbol(e.place), shown.naming.groups[f"{which} entries"][i])
            for i, e in own
            for which in ("before", "after")
        ]
        written = shown.formulas(relations)
        blocks: list[Block] = []
        for k, (_, entry) in enumerate(own):
            blocks += pair(entry, written[0].forms[2 * k : 2 * k + 2])
        moved = [entry for entry in found.entries if label in entry.by]
        for key in dict.fromkeys(entry.matrix for entry in moved):
            places = [entry.place for entry in moved if entry.matrix == key]
            largest = max((e.relative or 0.0 for e in moved if e.matrix == key), default=0.0)
            blocks.append(Prose(f"{', '.join(places)}; {largest:.2g} of a row at most", f"moves {key}"))
        meaning = names.pairs[label][1].meaning
        yield Section(label + f", {meaning}" * bool(meaning), (*blocks, *written[1:]))


def matrix_sections(
    found: Difference, apart: list[Entry], changed: list[Entry], shown: Description
) -> Iterator[Section]:
    first = len(found.quantities)
    letters = {s.name: letter for s, letter in shown.called.items()}
    for key in dict.fromkeys(entry.matrix for entry in apart):
        own = [(i, e) for i, e in enumerate(changed) if e.matrix == key]
        relations = []
        for i, entry in own:
            row, _, column = entry.place.partition(" by ")
            places = [letters.get(name, Symbol(name)) for name in (row, column) if name]
            letter = key.rpartition(" ")[2]
            label = shown.label(Symbol(letter), *places) if column else Symbol(f"{letter}_{places[0]}")
            for which in ("before", "after"):
                relations.append((label, shown.naming.groups[f"{which} entries"][first + i]))
        written = shown.formulas(relations)
        blocks: list[Block] = []
        for k, (_, entry) in enumerate(own):
            blocks += pair(entry, written[0].forms[2 * k : 2 * k + 2])
        others = [e for e in apart if e.matrix == key and e not in changed]
        for entry in others:
            why = "written otherwise; no value differs beyond rounding" if entry.rounding else "a constant alone"
            blocks.append(Prose(f"{why}; {sized(entry)}" if entry.constants else why, entry.place))
        count = len(own) + len(others)
        entries = f"{count} of {found.of[key]} entries" if key in found.of else f"{count} entries, all gone"
        yield Section(f"{key}: {entries}", (*blocks, *written[1:]))


def pair(entry: Entry, forms: tuple[Form, ...]) -> Iterator[Block]:
    before, after = forms
    if entry.before is None:
        yield from (Prose("new", entry.place), Formulas((after,)))
    elif entry.after is None:
        yield from (Prose("gone", entry.place), Formulas((before,)))
    else:
        yield Prose(sized(entry), entry.place)
        found = differences([before.relation], [after.relation])
        left, right = (
            replace(form, marks=frozenset(marks([form.relation], found, which)[0]))
            for form, which in ((before, "printed"), (after, "derived"))
        )
        yield Pair(Formulas((left,), "before"), Formulas((right,), "after"))


def sized(entry: Entry) -> str:
    if entry.largest is None or entry.at is None:
        return "no point of the box was found at which both have a value"
    at = ", ".join(f"{name} = {value:.4g}" for name, value in entry.at.items())
    return f"by {entry.largest:.3g}" + f" at {at}" * bool(at) + f"; {entry.relative:.2g} of its row"


def cost(made: Cost) -> Iterator[Block]:
    for change in made.changes:
        yield Prose(str(change).partition(": ")[2], change.name)
    if made.unknown:
        yield Prose(f"unknown: {made.unknown}", "code of what differs")
    else:
        yield Prose(f"{made.before} -> {made.after} bytes, -Os on this machine", "code of what differs")
