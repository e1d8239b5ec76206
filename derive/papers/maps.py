"""The tables [[model]] of a paper with a witness in Python: its states, inputs and rows by those of the models that
make C from it."""

import re
from collections.abc import Iterator, Mapping
from typing import Any

from boresight.derive.ledger.map import Map, Match, Row
from boresight.derive.models import built_in
from boresight.derive.papers.macros import expanded
from boresight.derive.papers.toml import Place, Toml

MADE = re.compile(r"(?P<what>F|G)|(?P<of>[Hz]) of (?P<names>\w+(?:\s*,\s*\w+)*)|(?P<output>\w+\.\w+)")
AS = '"F", "G", "H of MEASUREMENT", "z of MEASUREMENT" or "FUNCTION.OUTPUT"'
ROWS = ("states", "noises", "measurements")
KEYS = ("name", *ROWS, "inputs", "matches")


def made(text: str) -> tuple[str, tuple[str, ...]] | None:
    """What of a model is named, and of which measurements; None if nothing is."""
    found = MADE.fullmatch(text.strip())
    if not found:
        return None
    of = tuple(re.split(r"\s*,\s*", found["names"])) if found["of"] else ()
    return found["what"] or found["of"] or found["output"], of


def maps(toml: Toml, macros: Mapping[str, str], labels: Mapping[str, str]) -> tuple[Map, ...]:
    """Of a paper.toml; labels: of equations, with their numbers.  Raises BoresightError with file, line and column."""
    for i in range(len(toml.data.get("model", ()))):
        toml.renamed(labels, "model", i, "matches")
    return tuple(_map(toml, macros, table, ("model", i)) for i, table in enumerate(toml.data.get("model", ())))


def _map(toml: Toml, macros: Mapping[str, str], table: Mapping[str, Any], at: Place) -> Map:
    def latex(text: Any, *place: str | int) -> str:
        return expanded(toml.typed(text, str, "LaTeX in the letters of the paper", *at, *place), macros)

    def rows(kind: str) -> Iterator[Row]:
        """The model's own name: LaTeX of what it is of the paper, or { is = LaTeX, why = ... }."""
        for ours, row in table.get(kind, {}).items():
            whole = row if isinstance(row, dict) else {"is": row}
            text = latex(whole.get("is"), kind, ours)
            sign = "-1" if text.startswith("-") else "1"
            yield Row(text.removeprefix("-"), ours, sign, whole.get("why", ""))

    def matches() -> Iterator[Match]:
        """By equation, LaTeX: what the model makes, or { is = ..., inputs = ... }."""
        for number, listed in table.get("matches", {}).items():
            for ours, row in listed.items():
                whole = row if isinstance(row, dict) else {"is": row}
                place = ("matches", number, ours)
                if not (found := made(str(whole.get("is")))):
                    toml.refuse(f"{whole.get('is')!r} is nothing that a model makes; write {AS}", *at, *place)
                inputs = {name: latex(text, *place) for name, text in whole.get("inputs", {}).items()}
                yield Match(number, latex(ours, *place), *found, inputs)

    for key in table:
        toml.known(KEYS, key, *at, key)
    states, noises, measurements = (tuple(rows(kind)) for kind in ROWS)
    inputs = {name: latex(text, "inputs", name) for name, text in table.get("inputs", {}).items()}
    name = str(table.get("name"))
    return Map(lambda: built_in(name), states, inputs, tuple(matches()), noises, measurements)
