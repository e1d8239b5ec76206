"""A paper that comes with Boresight: its files, with a witness in Python and what that alone can compute.

witness.py gives WITNESS, SIZES, POINT and STRUCTURE; flown.py, where steps name \\flown{...}, what that stands for;
consequences.py, where there is one, `evidence` and `findings`.
"""

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields, replace
from functools import cache, cached_property
from pathlib import Path
from types import ModuleType
from typing import Any, ClassVar
from unicodedata import normalize

from sympy import Function

from boresight.derive.ledger.equation import Derivation, Equation, Meaning, Quantity, Reading, letter
from boresight.derive.ledger.paper import Apart, Paper
from boresight.derive.ledger.reader import read
from boresight.derive.papers.displays import Display
from boresight.derive.papers.maps import maps
from boresight.derive.papers.source import NAMES, TABLE, TEXT, Keys, Source, check_unit, several
from boresight.derive.papers.toml import Toml, numbered
from boresight.errors import BoresightError, did_you_mean

HERE = Path(__file__).parent
SPELLINGS = (list, "a list of LaTeX")
READINGS = (list, "a list of tables, each with printed, meant and why")
TRUTH = (bool, "true or false")


@cache
def built_in(name: str, python: Callable[[str], ModuleType]) -> Paper:
    """The paper of a folder beside this file; python: its modules by their names."""
    return BuiltIn(name, HERE / name.replace("-", "_"), python).paper()


class BuiltIn(Source):
    """A paper whose letters have their values by a module in Python.  python: the modules of its folder by their
    names."""

    KEYS: ClassVar[Keys] = {
        "": {**Source.KEYS[""], "meant": NAMES, "units": TABLE, "frames": TABLE, "meanings": TABLE,
             "model": (list, "a table [[model]]")},
        "letters": {**Source.KEYS["letters"], "kind": TEXT, "function": TRUTH, "spellings": SPELLINGS},
        "equations": {
            **Source.KEYS["equations"], "unit": TEXT, "defines": NAMES, "introduces": NAMES, "leads_to": NAMES,
            "meant": NAMES, "readings": READINGS, "meanings": NAMES, "conventions": NAMES, "as_vector": TRUTH,
            "left_out": TEXT, "unflown": TEXT,
        },
    }  # fmt: skip

    def __init__(self, name: str, folder: Path, python: Callable[[str], ModuleType]):
        self.name, self.python = name, python
        super().__init__(folder)
        self.computed = python(self.data["witness"].removesuffix(".py"))
        self.made: dict[str, Equation] = {}

    def beside(self, name: str) -> ModuleType | None:
        return self.python(name) if (self.folder / f"{name}.py").is_file() else None

    # ---- letters

    def letter(self, toml: Toml, name: str, row: Mapping[str, Any]) -> Quantity:
        symbol = normalize("NFC", name)
        if "latex" not in row:
            toml.refuse(f"{name} has no latex: write latex = '...', as it is printed", "letters", name)
        unit = row.get("unit", "")
        meaning = ", ".join(filter(None, (row.get("meaning", ""), "" if several(unit) else unit)))
        shape = row.get("shape", ())
        shape = (shape,) if isinstance(shape, int) else tuple(shape)
        kind = row.get("kind", f"{unit} {shape}")
        made = letter(symbol, row["latex"], kind, meaning, shape, row.get("function", False))
        if unit:
            check_unit(toml, name, made, unit)
        return made

    @cached_property
    def declared(self) -> tuple[Quantity, ...]:
        return tuple(self.letter(self.toml, name, row) for name, row in self.letter_rows.items())

    @cached_property
    def quantities(self) -> tuple[Quantity, ...]:
        return self.declared

    @cached_property
    def units(self) -> dict[str, str]:
        """Of kinds of letters, and of letters, with several units."""
        rows = (*self.letter_rows.items(), *self.steps.letters.items())
        own = {normalize("NFC", name): row["unit"] for name, row in rows if several(row.get("unit", ""))}
        return {**self.data.get("units", {}), **own}

    @cached_property
    def by_name(self) -> dict[str, Quantity]:
        return {quantity.symbol.name: quantity for quantity in self.quantities}

    @cached_property
    def step_letters(self) -> tuple[Quantity, ...]:
        """Those of the derivations alone, and those which they spell otherwise: rows of LaTeX alone."""
        return tuple(self.step_letter(name, row) for name, row in self.steps.letters.items())

    @cached_property
    def alphabet(self) -> tuple[Quantity, ...]:
        """The letters in which derivations are written."""
        return (*self.quantities, *self.step_letters)

    def step_letter(self, name: str, row: Mapping[str, Any]) -> Quantity:
        for key in row:
            self.steps.toml.known(self.KEYS["letters"], key, "letters", name, key)
        known = self.by_name.get(normalize("NFC", name))
        if known and row.keys() == {"latex"}:
            return replace(known, latex=row["latex"])
        return self.letter(self.steps.toml, name, row)

    @property
    def alike(self) -> bool:
        """Whether the page spells letters alike, or one in several ways."""
        return "meant" in self.data or any("spellings" in row for row in self.letter_rows.values())

    def letters_of(self, number: str) -> tuple[Quantity, ...]:
        """The letters as an equation means them: later ones take precedence where the page spells two alike."""
        spelled = (
            replace(self.by_name[normalize("NFC", name)], latex=latex)
            for name, row in self.letter_rows.items()
            for latex in row.get("spellings", ())
        )
        own = self.equation_rows.get(number, {}).get("meant", ())
        meant = (*self.named(self.data.get("meant", ()), "meant"), *self.named(own, "equations", number, "meant"))
        return (*(one for one in self.quantities if not one.function), *spelled, *meant)

    def named(self, names: Iterable[str], *place: str) -> tuple[Quantity, ...]:
        found = []
        for name in names:
            if normalize("NFC", name) not in self.by_name:
                self.refuse(f"no letter {name!r}{did_you_mean(name, self.by_name)}", *place)
            found.append(self.by_name[normalize("NFC", name)])
        return tuple(found)

    # ---- equations

    @cached_property
    def shown(self) -> dict[str, Display]:
        """By number, in the order of the print; where nothing is printed, of the derivations."""
        printed = {display.number: display for display in self.displays} if self.print.is_file() else {}
        shown = printed or dict.fromkeys(self.steps.numbers, Display("", (), 0, 0, (0, 0)))
        self.check_numbers(shown)
        return shown

    @cached_property
    def flown(self) -> Mapping[str, object]:
        module = self.beside("flown")
        letters = {one.symbol.name: one.symbol for one in self.alphabet if not one.function}
        made: Mapping[str, object] = module.flown(letters) if module else {}
        return made

    def one(self, number: str) -> Equation:
        if number not in self.made:
            self.made[number] = self.equation(number, self.shown[number])
        return self.made[number]

    @cached_property
    def equations(self) -> tuple[Equation, ...]:
        return tuple(map(self.one, self.shown))

    def apart(self) -> Apart:
        rows = {number: self.equation_rows.get(number, {}) for number in self.shown}
        small = {number: tuple(row.get("small", ())) for number, row in rows.items()}
        return Apart(self.one, small, tuple(number for number, row in rows.items() if row.get("defines")))

    def equation(self, number: str, display: Display) -> Equation:
        """The derived form is what the steps marked `result` say, and where none is, the print after its readings; what
        has no print is derived here, and its print is what is derived."""
        row, place = self.equation_rows.get(number, {}), ("equations", number)
        letters = self.letters_of(number) if self.alike else self.quantities
        form = self.read(display, display.latex, letters)
        if row.get("as_vector"):
            vee = Function("vee", commutative=False)
            form = tuple(replace(r, sides=(r.sides[0], vee(r.sides[1]), *r.sides[2:])) for r in form)
        parts = [part.name for part in fields(self.computed.WITNESS.base)]
        steps = self.steps.of(number, self.alphabet, parts, self.flown)
        results = tuple(step.relation for step in steps if step.result and step.relation is not None)
        defines, introduces = (
            tuple(one.symbol for one in self.named(row.get(key, ()), *place, key)) for key in ("defines", "introduces")
        )
        equation = Equation(
            paper=self.name,
            number=number,
            latex=display.latex,
            lines=display.source if any(display.source) else display.lines,
            printed=form or results,
            derived=form,
            derivation=Derivation(steps),
            readings=tuple(self.reading(number, one) for one in row.get("readings", ())),
            defines=defines,
            introduces=introduces,
            meanings=tuple(self.meaning(name, *place, "meanings") for name in row.get("meanings", ())),
            conventions=tuple(row.get("conventions", ())),
            leads_to=tuple(self.labels.get(one, one) for one in row.get("leads_to", ())),
            note=row.get("note", ""),
            unit=units(row.get("unit", "1")),
            small=tuple(row.get("small", ())),
            quantities=self.quantities,
            step_letters=self.step_letters,
        )
        return replace(equation, derived=results or equation.read())

    def reading(self, number: str, row: Mapping[str, str]) -> Reading:
        def side(key: str) -> Any:
            try:
                (relation,) = read((row[key],), self.alphabet)
            except (BoresightError, KeyError) as error:
                self.refuse(f"a reading of ({number}) has no {key}: {error}", "equations", number, "readings")
            return relation.sides[0]

        return Reading(side("printed"), side("meant"), row.get("why", ""))

    def meaning(self, name: str, *place: str) -> Meaning:
        table = self.data.get("meanings", {})
        if name not in table:
            self.refuse(f"no meaning {name!r}{did_you_mean(name, table)}", *place)
        senses = tuple((sense, tuple(letters.items())) for sense, letters in table[name]["senses"].items())
        return Meaning(senses, table[name].get("stated_in", ""))

    # ---- all of it

    def paper(self) -> Paper:
        beside = self.beside("consequences")

        def of_equations(key: str) -> dict[str, str]:
            return {number: row[key] for number, row in self.equation_rows.items() if key in row}

        return Paper(
            name=self.name,
            reference=self.reference,
            make_equations=lambda: self.equations,
            quantities=lambda: self.quantities,
            witness=replace(self.computed.WITNESS, left_out=of_equations("left_out")),
            conditions=self.computed.SIZES,
            point=self.computed.POINT,
            evidence=beside.evidence if beside else lambda number: "",
            findings=beside.findings if beside else tuple,
            letters=lambda: self.step_letters,
            letters_of=self.letters_of if self.alike else None,
            structure=getattr(self.computed, "STRUCTURE", {}),
            units=self.units,
            computed=self.data.get("computed", {}),
            frames={numbered(where, self.labels): text for where, text in self.data.get("frames", {}).items()},
            conventions=tuple(self.data.get("conventions", ())),
            maps=maps(self.toml, self.steps.macros, self.labels) if "model" in self.data else (),
            unflown=of_equations("unflown"),
            labels=self.labels,
            apart=self.apart,
        )


def units(text: str) -> str | tuple[str, ...]:
    """Of all rows, or of each in turn: 3 m/s, 2 rad."""
    if "," not in text:
        return text
    found: list[str] = []
    for part in text.split(", "):
        count = re.match(r"(\d+) ", part)
        found += [part[count.end() :]] * int(count[1]) if count else [part]
    return tuple(found)
