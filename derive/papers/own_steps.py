"""The derivations of a paper of one's own: derivation.toml, the steps of each equation that the ledger carries out."""

import re
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NoReturn

from boresight.derive.ledger.equation import Claim, Line, Passage, Quantity
from boresight.derive.ledger.lines import read_lines
from boresight.derive.ledger.passages import OPERATIONS
from boresight.errors import BoresightError, did_you_mean

CLAIMS = ("exact", "definition", "identity", "first-order", "order", "limit", "approximation")
TEXTS, LISTS = ("line", "claim", "why", "by", "of", "dropped", "condition"), ("small", "using", "letters", "with")
KEYS = (*TEXTS, *LISTS, "order", "result")


class Steps:
    """What derivation.toml says, by equation; nothing where there is no such file.

    Raises BoresightError with the file and the line of the step that is wrong.
    """

    def __init__(self, path: Path, errors: Iterable[str]):
        self.path, self.errors = path, tuple(errors)
        try:
            self.text = path.read_text(encoding="utf-8") if path.is_file() else ""
            self.data: dict[str, Any] = tomllib.loads(self.text)
        except (OSError, UnicodeDecodeError) as error:
            raise BoresightError(f"{path}: cannot be read ({error}); it is one of the paper's files") from None
        except tomllib.TOMLDecodeError as error:
            place = re.search(r" \(at line (\d+), column (\d+)\)", str(error))
            where = f":{place[1]}:{place[2]}" if place else ""
            raise BoresightError(f"{path}{where}: {str(error).partition(' (at ')[0]}") from None

    def refuse(self, number: str, index: int, what: str) -> NoReturn:
        """At the header of a step, [["2.15"]], counted from 0."""
        header = re.compile(rf"^[ \t]*\[\[\s*[\"']?{re.escape(number)}[\"']?\s*\]\]", re.MULTILINE)
        headers = [found.start() for found in header.finditer(self.text)]
        at = headers[index] if index < len(headers) else 0
        raise BoresightError(
            f"{self.path}:{self.text.count(chr(10), 0, at) + 1}: step {index + 1} of ({number}): {what}"
        )

    def of(self, number: str, quantities: tuple[Quantity, ...]) -> tuple[Line, ...]:
        """The steps of an equation, read."""
        found: list[Line] = []
        for index, step in enumerate(self.data.get(number, ())):
            self.judge_keys(number, index, step)
            try:
                found += read_lines([made(step)], quantities)
            except BoresightError as error:
                self.refuse(number, index, str(error))
        return tuple(found)

    def judge_keys(self, number: str, index: int, step: Any) -> None:
        if not isinstance(step, Mapping):
            self.refuse(number, index, f'it is no table; begin each step by [["{number}"]]')
        for key, value in step.items():
            if key not in KEYS:
                self.refuse(number, index, f"no key {key!r}{did_you_mean(key, KEYS)}; there are {', '.join(KEYS)}")
            kind, what = (str, "a text") if key in TEXTS else (list, "a list") if key in LISTS else (int, "a number")
            if not isinstance(value, kind):
                self.refuse(number, index, f"{key} must be {what}")
        if not step.get("why"):
            self.refuse(number, index, 'it has no why; say in words where the line comes from, as why = "rates add"')
        for key, what, known in (("claim", "claim", CLAIMS), ("by", "operation", OPERATIONS)):
            if key in step and step[key] not in known:
                near = did_you_mean(step[key], known)
                self.refuse(number, index, f"{step[key]!r} is no {what}{near}; there are {', '.join(known)}")
        if "line" in step and "claim" not in step:
            self.refuse(number, index, f"it says of its line no claim; there are {', '.join(CLAIMS)}")
        for part in step.get("small", ()):
            if part not in self.errors:
                self.refuse(number, index, f"the witness has no error {part!r}{did_you_mean(str(part), self.errors)}")


def made(step: Mapping[str, Any]) -> Line:
    """A step as the ledger has it; one without a line is a remark."""
    if "line" not in step:
        return Line("", None, step["why"])
    small, order = tuple(step.get("small", ())), int(step.get("order", 1))
    claim = Claim(step["claim"], small, order, step.get("dropped", ""), step.get("condition", ""))
    passage = None
    if "by" in step:
        using, letters, with_ = (tuple(map(str, step.get(key, ()))) for key in ("using", "letters", "with"))
        passage = Passage(step["by"], str(step.get("of", "")), using, letters, with_, order)
    return Line(step["line"], claim, step["why"], passage, bool(step.get("result")))
