"""The page of a difference: entry by entry before and after, with the names that a model's own page has."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from sympy import Matrix, Symbol

from boresight.codegen.difference import POINTS, Cost, Difference, Entry, Statement, swapped, together
from boresight.codegen.text.equations import unchecked
from boresight.derive.expressions import substituted, symbols_in
from boresight.derive.ledger.differences import differences, marks
from boresight.derive.model import Function, Model, Output, Struct
from boresight.derive.pages.blocks import Block, Form, Formulas, Page, Pair, Prose, Section
from boresight.derive.pages.model import Description, forms, lettered, letters_of, names_of
from boresight.derive.pages.named import nodes

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
    changed = [entry for entry in found.entries if not entry.rounding and not entry.constants]
    shown = Description(both(found, changed))
    alike(shown)
    sections = [
        *([Section("what is stated", tuple(map(stated, found.statements)))] if found.statements else []),
        *matrix_sections(found, changed, shown),
    ]
    used = {s for section in sections for form in forms(section) for s in letters_of(form.relation)}
    sections += names_of(shown, used)
    if found.cost:
        sections.append(Section("cost", tuple(cost(found.cost))))
    return lettered(shown, Page("", tuple(sections))).sections


def both(found: Difference, changed: list[Entry]) -> Model:
    """A model whose functions are the entries before and after: so the same names are put into both."""
    before, after = (
        Matrix([0 if side is None else side for side in sides])
        for sides in ([e.before for e in changed], [e.after for e in changed])
    )
    columns = ("before", substituted(before, swapped(found.old, found.new))), ("after", after)
    functions = tuple(
        Function(name, name, (Output("entries", column, "1", name),)) for name, column in columns if changed
    )
    struct = Struct("both", "what either reads", together(found.old, found.new))
    made: Model = unchecked(Model, name=found.model, states=(), structs=(struct,), measurements=(), functions=functions)
    return made


def alike(shown: Description) -> None:
    """Take back a name that stands on one side of a pair alone if the other side has terms of what it stands for: what
    differs is then seen in the same letters."""
    groups = shown.naming.groups
    values = {
        letter: value
        for one in shown.naming.named
        for letter, value in zip(one.entries, one.value, strict=True)
        if letter.is_Symbol and letter != value and value.is_Add
    }
    pairs = []
    for before, after in zip(*groups.values(), strict=True) if groups else ():
        pair = [before, after]
        for letter in reversed(values):  # outer ones first
            inside = [letter in symbols_in([side]) for side in pair]
            if inside[0] != inside[1] and terms(values[letter]) & terms(*nodes([[pair[inside[0]]]])):
                pair = list(substituted(Matrix(pair), {letter: values[letter]}))
        pairs.append(pair)
    for which, key in enumerate(groups):
        groups[key] = Matrix([pair[which] for pair in pairs])


def terms(*expressions: Any) -> set[Any]:
    """The terms of all sums among these, without their numbers."""
    return {term for e in expressions if e.is_Add for term in e.as_coefficients_dict()}


def stated(statement: Statement) -> Prose:
    what = statement.part + f", {statement.field}" * bool(statement.field)
    if statement.before is None:
        return Prose(f"new; {statement.after}", what)
    if statement.after is None:
        return Prose(f"gone; {statement.before}", what)
    return Prose(f"was {statement.before or 'not stated'}; is {statement.after or 'not stated'}", what)


def matrix_sections(found: Difference, changed: list[Entry], shown: Description) -> Iterator[Section]:
    letters = {s.name: letter for s, letter in shown.called.items()}
    for key in dict.fromkeys(entry.matrix for entry in found.entries):
        own = [(i, e) for i, e in enumerate(changed) if e.matrix == key]
        relations = []
        for i, entry in own:
            row, _, column = entry.place.partition(" by ")
            places = [letters.get(name, Symbol(name)) for name in (row, column) if name]
            letter = key.rpartition(" ")[2]
            label = shown.label(Symbol(letter), *places) if column else Symbol(f"{letter}_{places[0]}")
            for which in ("before", "after"):
                relations.append((label, shown.naming.groups[f"{which} entries"][i]))
        written = shown.formulas(relations)
        blocks: list[Block] = []
        for k, (_, entry) in enumerate(own):
            blocks += pair(entry, written[0].forms[2 * k : 2 * k + 2])
        others = [e for e in found.entries if e.matrix == key and e not in changed]
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
