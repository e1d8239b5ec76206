"""The derivations of a paper: derivation.toml, the steps of each equation that the ledger carries out."""

from collections.abc import Collection, Iterator, Mapping
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any, NoReturn

from boresight.derive.ledger.equation import Claim, Line, Passage, Quantity
from boresight.derive.ledger.lines import read_lines
from boresight.derive.ledger.passages import NEEDED, NEEDS, OPERATIONS, RATE
from boresight.derive.ledger.reader import FUNCTIONS, UnreadError
from boresight.derive.papers.macros import ARGUMENT, USE, expanded
from boresight.derive.papers.toml import Toml, joined, numbered
from boresight.errors import BoresightError, did_you_mean

CLAIMS = ("exact", "definition", "identity", "first-order", "order", "limit", "approximation")
TEXTS, LISTS = ("claim", "by", "of", "dropped", "condition"), ("small", "using", "letters", "with", "each")
LONG = ("line", "why")  # a text, or a list of its parts
KEYS = (*LONG, *TEXTS, *LISTS, "order", "result")
TABLES = ("macros", "letters")  # which are no equations
READ = (
    "frac",
    "sqrt",
    "begin",
    "end",
    "left",
    "right",
    "times",
    "cdot",
    "exp",
    "vee",
    "mathrm",
    "text",
    "flown",
    "quad",
)
OWN = frozenset((*READ, *(name.strip("\\") for name in FUNCTIONS)))  # commands that no macro may hide


class Steps:
    """What derivation.toml says, by equation; nothing where there is no such file.

    Raises BoresightError with file, line and column of what is wrong.
    """

    def __init__(self, path: Path, macros: Mapping[str, str] = MappingProxyType({}),
                 labels: Mapping[str, str] = MappingProxyType({})):  # fmt: skip
        self.toml, self.known, self.labels = Toml(path, needed=False), macros, labels
        self.toml.renamed(labels)
        self.numbers = tuple(number for number in self.toml.data if number not in TABLES)

    def refuse(self, number: str, index: int, what: str, *key: str) -> NoReturn:
        """At a step, counted from 0, or a key of it."""
        self.toml.refuse(f"step {index + 1} of ({number}): {what}", number, index, *key)

    @cached_property
    def macros(self) -> dict[str, str]:
        """By name their LaTeX, with those of the paper."""
        return self.toml.macros(self.known)

    def expanded(self, latex: str) -> str:
        """With macros in their places; as it is, where an argument of one is missing."""
        try:
            return expanded(latex, self.macros)
        except ValueError:
            return latex

    @property
    def latex(self) -> Iterator[str]:
        """Of all steps what stands in letters."""
        for number in self.numbers:
            rows = self.toml.data[number]
            for step in (row for row in rows if isinstance(row, Mapping)) if isinstance(rows, list) else ():
                parts = (step.get(key, ()) for key in ("line", "dropped", "letters", "with"))
                yield from (str(one) for part in parts for one in ([part] if isinstance(part, str) else part))

    @property
    def letters(self) -> dict[str, Any]:
        """Rows of letters that the derivations need and the paper does not print."""
        return dict(self.toml.typed(self.toml.data.get("letters", {}), dict, "a table", "letters"))

    def of(
        self,
        number: str,
        quantities: tuple[Quantity, ...],
        parts: Collection[str],
        flown: Mapping[str, object] = MappingProxyType({}),
    ) -> tuple[Line, ...]:
        """The steps of an equation, read; parts: of the witness, which may be small."""
        found: list[Line] = []
        commands = OWN.union(*(USE.findall(one.latex) for one in quantities)) if self.macros else OWN
        for name in self.macros.keys() & commands:
            self.toml.refuse(f"\\{name} has a meaning of its own here; call the macro otherwise", "macros", name)
        for index, step in enumerate(self.toml.typed(self.toml.data.get(number, []), list, "a list of steps", number)):
            self.judge_keys(number, index, step, parts)
            try:
                found += read_lines([made(one) for one in self.written(step)], quantities, flown)
            except UnreadError as error:
                alone = isinstance(step["line"], str) and "\\" in step["line"] and not self.macros
                column = error.place if alone and step["line"][error.place :].startswith(error.typed) else None
                self.toml.refuse(f"step {index + 1} of ({number}): {error}", number, index, "line", column=column)
            except (BoresightError, ValueError) as error:
                self.refuse(number, index, str(error), *("line",) * ("line" in step))
        return tuple(found)

    def written(self, step: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
        """The step with its texts whole, and its macros in place; once for each row of `each`, for #1, #2, ..."""
        for row in step.get("each", ((),)):
            values = list(map(str, row)) if isinstance(row, list | tuple) else [str(row)]

            def whole(text: Any, values: list[str] = values) -> Any:
                if isinstance(text, list):
                    return [whole(part) for part in text]
                if not isinstance(text, str):
                    return text
                return ARGUMENT.sub(lambda found: values[int(found[1]) - 1], text) if values else text

            one = {key: whole(joined(value) if key in LONG else value) for key, value in step.items()}
            for key in ("line", "dropped"):
                if key in one:
                    one[key] = expanded(one[key], self.macros)
            for key in ("letters", "with"):
                if key in one:
                    one[key] = [expanded(str(part), self.macros) for part in one[key]]
            if "of" in one:
                one["of"] = numbered(one["of"], self.labels)
            if "using" in one:
                one["using"] = [numbered(str(part), self.labels) for part in one["using"]]
            yield one

    def judge_keys(self, number: str, index: int, step: Any, parts: Collection[str]) -> None:
        if not isinstance(step, Mapping):
            self.refuse(number, index, f'it is no table; begin each step by [["{number}"]]')
        for key, value in step.items():
            if key not in KEYS:
                near, all_ = did_you_mean(key, KEYS), ", ".join(KEYS)
                self.refuse(number, index, f"no key {key!r}{near}; there are {all_}", key)
            kind, what = (str, "a text") if key in TEXTS else (list, "a list") if key in LISTS else (int, "a number")
            if not isinstance(joined(value) if key in LONG else value, str if key in LONG else kind):
                self.refuse(number, index, f"{key} must be {'a text' if key in LONG else what}", key)
        if not step.get("why"):
            self.refuse(number, index, 'it has no why; say in words where the line comes from, as why = "rates add"')
        for key, what, known in (("claim", "claim", CLAIMS), ("by", "operation", OPERATIONS)):
            if key in step and step[key] not in known:
                near = did_you_mean(step[key], known)
                self.refuse(number, index, f"{step[key]!r} is no {what}{near}; there are {', '.join(known)}", key)
        if "line" in step and "claim" not in step:
            self.refuse(number, index, f"it says of its line no claim; there are {', '.join(CLAIMS)}")
        if step.get("claim") == "approximation" and not step.get("dropped"):
            self.refuse(number, index, "an approximation needs dropped = '...', the whole term that is left out: with "
                        "it added to the right side the line is true")  # fmt: skip
        for key in NEEDS.get(step.get("by", ""), ()):
            if not step.get(key):
                self.refuse(number, index, f"{step['by']} needs {NEEDED[key]}", "by")
        if step.get("by") in ("differentiate", "carry over") and len(step["letters"]) != len(step["with"]):
            why = (
                RATE if step["by"] == "differentiate" else "write in `with` for each of `letters` what takes its place"
            )
            self.refuse(
                number, index, f"{len(step['letters'])} letters, and {len(step['with'])} in `with`: {why}", "with"
            )
        for part in step.get("small", ()):
            if part not in parts:
                near = did_you_mean(str(part), parts)
                self.refuse(number, index, f"the witness has no error {part!r}{near}", "small")


def made(step: Mapping[str, Any]) -> Line:
    """A step as the ledger has it; one without a line is a remark."""
    if "line" not in step:
        return Line("", None, step["why"])
    small, order = tuple(step.get("small", ())), int(step.get("order", 1))
    of_claim = order if step["claim"] == "order" else 1
    of_passage = order if step.get("by") == "expand" else 1
    claim = Claim(step["claim"], small, of_claim, step.get("dropped", ""), step.get("condition", ""))
    passage = None
    if "by" in step:
        using, letters, with_ = (tuple(map(str, step.get(key, ()))) for key in ("using", "letters", "with"))
        passage = Passage(step["by"], str(step.get("of", "")), using, letters, with_, of_passage)
    return Line(step["line"], claim, step["why"], passage, bool(step.get("result")))
