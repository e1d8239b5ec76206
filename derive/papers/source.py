"""The files of a paper, as its folder has them: paper.toml, printed.tex and derivation.toml, each read once."""

import re
from collections.abc import Iterable, Mapping
from functools import cached_property
from pathlib import Path
from typing import Any, ClassVar, NoReturn

from boresight.derive.ledger.dimensions import Grid, of_letter
from boresight.derive.ledger.equation import Quantity, Relation
from boresight.derive.ledger.reader import UnreadError, place_of, read, short
from boresight.derive.papers.displays import Display, displays
from boresight.derive.papers.files import FILES, STEPS
from boresight.derive.papers.macros import declared, expanded
from boresight.derive.papers.steps import Steps
from boresight.derive.papers.toml import Toml, refuse, text_of
from boresight.derive.units import unit as unit_of
from boresight.errors import BoresightError, did_you_mean

TOML, PRINT = FILES
Kind = tuple[Any, str]
Keys = Mapping[str, Mapping[str, Kind]]
TEXT: Kind = (str, "a text")
TABLE: Kind = (dict, "a table")
NAMES: Kind = (list, 'a list, as ["step"]')
VALUE: Kind = ((str, int, float), "a text")
SHAPE: Kind = ((int, list), "a number, or a list of two")


class Source:
    """KEYS: by table of paper.toml what its keys are; of `letters` and `equations`, each row's."""

    KEYS: ClassVar[Keys] = {
        "": {
            "title": TEXT, "authors": TEXT, "published": TEXT, "conventions": (list, "a list of sentences"),
            "witness": TEXT, "computed": TABLE, "letters": TABLE, "equations": TABLE, "model": TABLE,
            "macros": TABLE,
        },
        "letters": {"latex": TEXT, "meaning": TEXT, "unit": TEXT, "shape": SHAPE},
        "equations": {"note": TEXT, "small": NAMES},
    }  # fmt: skip

    def __init__(self, folder: Path):
        self.folder = folder
        self.print = folder / PRINT
        self.toml = Toml(folder / TOML)
        self.data = self.toml.data
        self.check_keys()

    def refuse(self, what: str, *place: str | int, column: int | None = None) -> NoReturn:
        """Where the innermost of these keys stands in paper.toml, or at a column of its value."""
        self.toml.refuse(what, *place, column=column)

    def typed(self, value: Any, kind: Any, what: str, *place: str | int) -> Any:
        return self.toml.typed(value, kind, what, *place)

    def check_keys(self) -> None:
        self.check_row("", self.data)
        for table in ("letters", "equations"):
            for name, row in self.data.get(table, {}).items():
                if not isinstance(row, dict):
                    self.refuse(f"{name} is no table; write {{ latex = '...', value = \"...\" }}", table, name)
                self.check_row(table, row, table, name)
        for key in ("title", "witness"):
            if key not in self.data:
                raise BoresightError(f'{self.toml.path}: {key} is missing; write {key} = "..." at the top')
        for sentence in self.data.get("conventions", []):
            self.typed(sentence, str, "a list of sentences", "conventions")
        for name in self.data.get("letters", {}):
            if not name.strip():
                self.refuse("a letter has no name", "letters")
        if not self.data.get("letters"):
            raise BoresightError(f"{self.toml.path}: no letter is declared; write a table [letters]")

    def check_row(self, table: str, row: Mapping[str, Any], *place: str) -> None:
        for key in row:
            self.toml.known(self.KEYS[table], key, *place, key)
        for key, value in row.items():
            self.typed(value, *self.KEYS[table][key], *place, key)

    @property
    def reference(self) -> str:
        """As a list of papers has it: the title with its authors, before it where it is published."""
        title, authors, published = (self.data.get(key) for key in ("title", "authors", "published"))
        return ", ".join(filter(None, (authors, title, published) if published else (title, authors)))

    @property
    def letter_rows(self) -> dict[str, Any]:
        rows: dict[str, Any] = self.data["letters"]
        return rows

    @cached_property
    def equation_rows(self) -> dict[str, Any]:
        self.toml.renamed(self.labels, "equations")
        rows: dict[str, Any] = self.data.get("equations", {})
        return rows

    @cached_property
    def displays(self) -> tuple[Display, ...]:
        return tuple(displays(self.print, self.macros))

    @cached_property
    def labels(self) -> dict[str, str]:
        """By \\label the numbers of the equations that have a number beside it."""
        found = self.displays if self.print.is_file() else ()
        numbers = {one.number for one in found}
        return {label: one.number for one in found for label in one.labels if label not in numbers}

    @cached_property
    def steps(self) -> Steps:
        return Steps(self.folder / STEPS, self.macros, self.labels)

    def read(self, display: Display, latex: Iterable[str], letters: Iterable[Quantity]) -> tuple[Relation, ...]:
        """What a display says, its LaTeX as it is given.  Raises BoresightError at the place in the file."""
        try:
            relations = read(latex, letters)
        except UnreadError as error:
            self.unread(display, error)
        except RecursionError:
            what = f"({display.number}) is nested too deeply to be read"
            refuse(self.print, text_of(self.print), display.begins, what)
        if any(len(relation.sides) < 2 for relation in relations):
            refuse(self.print, text_of(self.print), display.begins, f"({display.number}) sets nothing equal")
        return relations

    def unread(self, display: Display, error: UnreadError) -> NoReturn:
        """At the place of the file up to which the reader has read: its text has no spaces."""
        text = text_of(self.print)
        if error.at >= len(error.text):
            refuse(self.print, text, display.ends, f"({display.number}) ends before a formula is whole")
        place = place_of(display.text, error, self.expanded) or 0
        why = error.why or error.hint or f"no letter of {TOML} is written so, and it is no sign that is read"
        what = f"cannot read '{short(display.text[place:])}' in ({display.number}): {why}"
        refuse(self.print, text, display.begins + place, what)

    @cached_property
    def macros(self) -> dict[str, str]:
        """Those of paper.toml and of printed.tex, by name."""
        text = text_of(self.print) if self.print.is_file() else ""
        try:
            return {**self.toml.macros(), **declared(text)}
        except ValueError as error:
            refuse(self.print, text, 0, str(error))

    def expanded(self, latex: str) -> str:
        """With macros in their places; as it is, where an argument of one is missing."""
        try:
            return expanded(latex, self.macros)
        except ValueError:
            return latex

    def check_numbers(self, numbers: Iterable[str]) -> None:
        """That paper.toml and derivation.toml speak of equations that there are."""
        known = list(numbers)
        for number in self.equation_rows:
            if number not in known:
                near = did_you_mean(number, known)
                self.refuse(f"{PRINT} has no equation {number!r}{near}; it has {', '.join(known)}", "equations", number)
        for number in self.steps.numbers:
            if number not in known:
                self.steps.refuse(number, 0, f"{PRINT} has no such equation; it has {', '.join(known)}")


def check_unit(toml: Toml, name: str, made: Quantity, unit: str) -> None:
    """That a letter's unit is one, or that it has as many as there are entries."""
    try:
        units = of_letter({made.symbol.name: unit}, made) if several(unit) else unit_of(unit)
    except BoresightError as error:
        toml.refuse(str(error), "letters", name, "unit")
    if isinstance(units, Grid) and units.shape != (*made.shape, 1, 1)[:2]:
        sizes = " x ".join(map(str, units.shape))
        toml.refuse(f"{name} has {sizes} units for the shape {list(made.shape)}", "letters", name, "unit")


def several(unit: str) -> bool:
    """Whether a unit is a list of them, or those of a matrix by its rows and columns."""
    return "," in unit or " by " in unit or " times " in unit or re.match(r"\d+ ", unit) is not None
