"""The table [model] of a paper of one's own: what of a model that makes C its equations are."""

import ast
import re
from collections.abc import Callable
from functools import cached_property
from math import prod
from pathlib import Path
from typing import TYPE_CHECKING, Any

from boresight.derive.ledger.equation import Equation, Quantity, letter
from boresight.derive.ledger.map import Map, Match, Row
from boresight.derive.ledger.paper import Paper
from boresight.derive.papers.maps import AS, made
from boresight.derive.papers.own import Folder
from boresight.errors import BoresightError, did_you_mean

if TYPE_CHECKING:
    from boresight.derive.model import Model

Load = Callable[[str], "Model"]
KEYS = {"name", "states", "noises", "measurements", "inputs", "matches"}
OURS = re.compile(r"(?P<sign>-?)\s*(?P<name>\w+)")


def tied(folder: Path, load: Load) -> Paper:
    """The paper of a folder, tied to the model that its table [model] names; load: makes the model of a name."""
    whole = Folder(folder)
    if "model" not in whole.data:
        return whole.paper()
    own = OwnMap(whole, load)
    return whole.paper(own.values, beside=own.letters(), maps=(own.map(whole.equations(own.folder.folder.name)),))


def input_letter(name: str) -> str:
    """What the value of a model's input is called among the letters."""
    return f"input {name}"


class OwnMap:
    """Of a folder whose paper.toml has the table [model].  Raises BoresightError with its line."""

    def __init__(self, folder: Folder, load: Load):
        self.folder, self.data = folder, folder.data["model"]
        for key in self.data:
            if key not in KEYS:
                folder.refuse(f"no key {key!r} here{did_you_mean(key, KEYS)}; there are {', '.join(sorted(KEYS))}",
                              "model", key)  # fmt: skip
        lists = dict.fromkeys(("states", "noises", "measurements"), list)
        for key, kind in ({"name": str, "inputs": dict, "matches": dict} | lists).items():
            what = {str: 'a model, as "filter.py:FILTER"', dict: "a table", list: "a list of names"}[kind]
            folder.typed(self.data.get(key, kind()), kind, what, "model", key)
        folder.toml.renamed(folder.labels, "model", "matches")
        if not self.data.get("name") or not self.data.get("states"):
            folder.refuse('give name = "filter.py:FILTER" and states = [...], in the order of the paper', "model")
        name = self.data["name"]
        try:
            self.model = load(str(folder.folder / name) if ":" in name else name)
        except BoresightError as error:
            raise BoresightError(f"{folder.toml.path}: model: {error}") from None

    @cached_property
    def values(self) -> dict[str, ast.expr]:
        """By letter the values of the model's inputs: as they are given, or what the witness calls the same and has as
        many components."""
        known, found = self.folder.scenario.names, {}
        given = {name: str(value) for name, value in self.data.get("inputs", {}).items()}
        inputs = {item.name: item.size for item in (*self.model.inputs, *self.model.states)}
        for name in given:
            if name not in inputs:
                self.folder.refuse(f"{self.model.name} has no input {name!r}{did_you_mean(name, inputs)}",
                                   "model", "inputs", name)  # fmt: skip
        for name, size in inputs.items():
            turn = re.fullmatch(r"q_(\w+?)_wxyz", name)
            same = f"quaternion(C_{turn[1]})" if turn and f"C_{turn[1]}" in known else name if name in known else ""
            if text := given.get(name, same):
                value = self.folder.expression(text, "model", "inputs", name)
                letters = {**self.folder.bound, input_letter(name): value}
                self.folder.check(input_letter(name), letters, "model", "inputs", name)
                shape = self.folder.shape_of(input_letter(name), name, self.folder.drawn(letters))
                if prod(shape) == size:
                    found[input_letter(name)] = letters[input_letter(name)]
                elif name in given:
                    self.folder.refuse(f"{name} of {self.model.name} has {size} components, its value {prod(shape)}",
                                       "model", "inputs", name)  # fmt: skip
        return found

    def letters(self) -> tuple[Quantity, ...]:
        sizes = {item.name: item.size for item in (*self.model.inputs, *self.model.states)}
        names = [name.removeprefix("input ") for name in self.values]
        return tuple(letter(input_letter(n), latex_of(n), "1", ast.unparse(self.values[input_letter(n)]),
                            () if sizes[n] == 1 else (sizes[n],)) for n in names)  # fmt: skip

    def map(self, equations: tuple[Equation, ...]) -> Map:
        model = self.model
        inputs = {name.removeprefix("input "): latex_of(name.removeprefix("input ")) for name in self.values}
        known = {
            "states": [block.name for block in model.states],
            "noises": [item.name for item in model.inputs if set(item.symbols) & set(model.noise)],
            "measurements": [one.name for one in model.measurements],
        }
        rows = {kind: [self.row(kind, one, names) for one in self.data.get(kind, ())] for kind, names in known.items()}
        listed = {row.ours for row in rows["measurements"]}
        rows["measurements"] += [Row(one, one) for one in known["measurements"] if one not in listed]
        matches = [self.match(number, str(text), equations) for number, text in self.data.get("matches", {}).items()]
        states, noises, measurements = (tuple(listed) for listed in rows.values())
        return Map(lambda: model, states, inputs, tuple(matches), noises, measurements)

    def row(self, kind: str, text: Any, names: list[str]) -> Row:
        found = OURS.fullmatch(str(text).strip())
        if not found or found["name"] not in names:
            near = did_you_mean(str(text).strip(" -"), names)
            self.folder.refuse(f"{self.model.name} has no {text!r}{near}; its {kind} are {', '.join(names)}",
                               "model", kind)  # fmt: skip
        return Row(found["name"], found["name"], f"{found['sign']}1")

    def match(self, number: str, text: str, equations: tuple[Equation, ...]) -> Match:
        folder, found = self.folder, made(text)
        numbers = [equation.number for equation in equations]
        if number not in numbers:
            near = did_you_mean(number, numbers)
            folder.refuse(f"the paper has no equation {number!r}{near}", "model", "matches", number)
        if not found:
            folder.refuse(f"{text!r} is nothing that a model makes; write {AS}", "model", "matches", number)
        (equation,) = (one for one in equations if one.number == number)
        letters = {one.symbol.name: one.latex for one in equation.quantities}
        left = [relation.sides[0] for relation in equation.read()]
        alone = [letters[side.name] for side in left if getattr(side, "name", None) in letters]
        if len(alone) != 1:
            folder.refuse(f"({number}) has {len(alone)} letters alone on its left; give an equation with one, which is "
                          "what the model makes", "model", "matches", number)  # fmt: skip
        what, of = found
        measured = [one.name for one in self.model.measurements]
        if unknown := [one for one in of if one not in measured]:
            folder.refuse(f"{self.model.name} has no measurement {unknown[0]!r}{did_you_mean(unknown[0], measured)}; "
                          f"it has {', '.join(measured)}", "model", "matches", number)  # fmt: skip
        return Match(number, alone[0], what, of)


def latex_of(name: str) -> str:
    return rf"\mathrm{{input}}_{{{name}}}"
