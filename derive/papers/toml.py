"""The TOML files of a paper: read once, and whatever is wrong in one is said with file, line and column."""

import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any, NoReturn

from boresight.derive.papers.macros import USE, expanded
from boresight.errors import BoresightError, did_you_mean

Place = tuple[str | int, ...]  # keys, and numbers of what stands in a list, counted from 0
STRING = r'"""(?:[^\\]|\\.)*?"{3,5}|' + r"'''.*?'{3,5}" + r'|"(?:[^"\\\n]|\\.)*"|' + r"'[^'\n]*'"
TOKEN = re.compile(
    rf"(?P<string>{STRING})|(?P<comment>#[^\n]*)|(?P<bare>[^\s\[\]{{}}=,.#]+)|[\[\]{{}}=,.\n]", re.DOTALL
)


def text_of(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise BoresightError(f"{path}: cannot be read ({error.strerror}); it is one of the paper's files") from None
    except UnicodeDecodeError as error:
        raise BoresightError(f"{path}: byte {error.start} is not UTF-8; save the file as UTF-8") from None


def refuse(path: Path, text: str, at: int, what: str) -> NoReturn:
    """At a character of the file's text, counted from 0."""
    line, column = text.count("\n", 0, at) + 1, at - text.rfind("\n", 0, at)
    raise BoresightError(f"{path}:{line}:{column}: {what}")


class Toml:
    """What a file says.  Raises BoresightError with the place of what is wrong."""

    def __init__(self, path: Path, needed: bool = True):
        self.path = path
        self.text = text_of(path) if needed or path.exists() else ""
        try:
            self.data: dict[str, Any] = tomllib.loads(self.text)
        except tomllib.TOMLDecodeError as error:
            place = re.search(r" \(at line (\d+), column (\d+)\)", str(error))
            where = f":{place[1]}:{place[2]}" if place else ""
            raise BoresightError(f"{path}{where}: {str(error).partition(' (at ')[0]}") from None

    def refuse(self, what: str, *place: str | int, column: int | None = None) -> NoReturn:
        """Where the innermost key that there is of these stands, or at a column of its value, counted from 0."""
        while place and place not in self.places:
            place = place[:-1]
        key, value = self.places.get(place, (0, 0))
        refuse(self.path, self.text, key if column is None else value + column, what)

    @cached_property
    def places(self) -> dict[Place, tuple[int, int]]:
        """Where each key stands first, and where its value begins, within the quotes of a string."""
        found: dict[Place, tuple[int, int]] = {}
        for place, at in places(self.text):
            for k in range(1, len(place) + 1):
                found.setdefault(place[:k], at)
        return found

    def renamed(self, names: Mapping[str, str], *place: str | int) -> None:
        """The keys of a table that are called so become those names, and stand where they are written."""
        table: Any = self.data
        for key in place:
            table = table.get(key, {}) if isinstance(key, str) else table[key]
        if not isinstance(table, dict) or not names.keys() & table.keys():
            return
        for key in names.keys() & table.keys():
            if names[key] in table:
                self.refuse(f"{key!r} and {names[key]!r} are one equation: write one table of it", *place, key)
            under, new = (*place, key), (*place, names[key])
            self.places |= {(*new, *one[len(new) :]): at for one, at in self.places.items() if one[: len(new)] == under}
        rows = {names.get(key, key): row for key, row in table.items()}
        table.clear()
        table.update(rows)

    def known(self, keys: Iterable[str], key: str, *place: str | int) -> None:
        if key not in keys:
            near, all_ = did_you_mean(key, keys), ", ".join(sorted(keys))
            self.refuse(f"no key {key!r} here{near}; there are {all_}", *place)

    def macros(self, known: Mapping[str, str] = MappingProxyType({})) -> dict[str, str]:
        """Of its table [macros] by name their LaTeX, in which those before them may stand."""
        found = dict(known)
        for name, latex in self.typed(self.data.get("macros", {}), dict, "a table", "macros").items():
            if not USE.fullmatch(f"\\{name}"):
                self.refuse(f"{name!r} is no name of a macro: letters alone", "macros", name)
            text = self.typed(joined(latex), str, "a text", "macros", name)
            try:
                found[name] = expanded(text, found)
            except ValueError as error:
                self.refuse(str(error), "macros", name)
        return found

    def typed(self, value: Any, kind: Any, what: str, *place: str | int) -> Any:
        if not isinstance(value, kind):
            self.refuse(f"{place[-1]} must be {what}", *place)
        return value


def places(text: str) -> Iterator[tuple[Place, tuple[int, int]]]:
    """Of a text that is TOML: each place, where its key begins, and its value."""
    tokens = [found for found in TOKEN.finditer(text) if not found["comment"]]
    tables: dict[Place, int] = {}  # how many of an array of tables there were
    table: Place = ()
    i = 0

    def end(place: Place) -> Place:
        """With the number of the last table where a key of it names an array of tables."""
        found: Place = ()
        for key in place:
            found = (*found, key)
            found = (*found, tables[found] - 1) if found in tables else found
        return found

    def key() -> tuple[Place, int]:
        nonlocal i
        begin, names = tokens[i].start(), []
        while True:
            token = tokens[i]
            names.append(tomllib.loads(f"{token[0]} = 0").popitem()[0])
            i += 1
            if tokens[i][0] != ".":
                return tuple(names), begin
            i += 1

    def blank(*more: str) -> None:
        nonlocal i
        while i < len(tokens) and tokens[i][0] in ("\n", *more):
            i += 1

    def value(place: Place, at: int) -> Iterator[tuple[Place, tuple[int, int]]]:
        nonlocal i
        token = tokens[i]
        quotes = re.match(r"\"\"\"|'''|\"|'", token[0]) if token["string"] else None
        yield place, (at, token.start() + (len(quotes[0]) if quotes else 0))
        i += 1
        if token[0] == "[":
            blank()
            count = 0
            while tokens[i][0] != "]":
                yield from value((*place, count), tokens[i].start())
                count += 1
                blank(",")
            i += 1
        elif token[0] == "{":
            while tokens[i][0] != "}":
                names, begin = key()
                i += 1
                yield from value((*place, *names), begin)
                blank(",")
            i += 1
        else:
            while i < len(tokens) and tokens[i][0] not in (",", "]", "}", "\n"):
                i += 1  # a number or a date with dots

    blank()
    while i < len(tokens):
        begin, double = tokens[i].start(), False
        if tokens[i][0] == "[":
            double = tokens[i + 1][0] == "["
            i += 1 + double
            names, _ = key()
            if double:
                outer = (*end(names[:-1]), names[-1])
                tables[outer] = tables.get(outer, 0) + 1
                yield outer, (begin, begin)
            i += 1 + double
            table = end(names)
            yield table, (begin, begin)
        else:
            names, at = key()
            i += 1
            yield from value((*table, *names), at)
        blank()


def numbered(text: str, labels: Mapping[str, str]) -> str:
    """A line or an equation, as "(eq:x).2", by the number in the place of its label."""
    label = text[1:].partition(")")[0] if text.startswith("(") else ""
    return text.replace(label, labels[label], 1) if label in labels else text


def joined(text: Any) -> Any:
    """A text that is written in parts, as one."""
    return " ".join(text) if isinstance(text, list) and all(isinstance(part, str) for part in text) else text
