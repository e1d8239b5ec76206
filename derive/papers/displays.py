"""The displayed equations of printed.tex: verbatim, each with its number and the lines at which it stands."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from string import ascii_lowercase
from types import MappingProxyType
from typing import NoReturn

from boresight.derive.papers.macros import DECLARED, expanded
from boresight.derive.papers.toml import refuse, text_of


@dataclass(frozen=True)
class Display:
    """One equation of printed.tex: its number, its LaTeX, of `gather` that of each row, and where in the file that
    begins and ends.

    lines: of the file; source: of the paper's text, by a comment, % line 76 or % lines 90-94, in the equation.
    text: what stands between, blank where it has its number; labels: as \\label has them.
    """

    number: str
    latex: tuple[str, ...]
    begins: int
    ends: int
    lines: tuple[int, int]
    source: tuple[int, int] = (0, 0)
    text: str = ""
    labels: tuple[str, ...] = ()


ROWS = ("align", "flalign", "alignat", "eqnarray", "IEEEeqnarray", "gather")  # which have a number each
ENVIRONMENT = re.compile(
    rf"\\begin\{{(?P<name>equation|multline|displaymath|{'|'.join(ROWS)})\*?\}}(?P<body>.*?)\\end\{{(?P=name)\*?\}}"
    r"|\\\[(?P<square>.*?)\\\]|\$\$(?P<dollars>.*?)\$\$",
    re.DOTALL,
)
SUBEQUATIONS = re.compile(r"\\begin\{subequations\}(.*?)\\end\{subequations\}", re.DOTALL)
# What an equation says beside its formula: an order, further terms, a condition in words to the end of the row.
ASIDE = re.compile(
    r"\+\s*\\mathcal\s*(?:\{\s*O\s*\}|O)\s*(?:\\left\s*)?\((?:[^()]|\([^()]*\))*\)"
    r"|\+\s*\\[cl]?dots(?=\s*(?:\\\\|\\end|$))"
    r"|(?:,|\\q?quad|\\[,;]|\s)*\\(?:text|mbox|textrm)\s*\{\s*(?:for|if|where|when|with|as|at|in)\b[^{}]*\}"
    r"(?:(?!\\\\|\\end).)*",
    re.DOTALL,
)
SOURCE = re.compile(r"%\s*lines?\s+(\d+)(?:\s*-\s*(\d+))?")
MARK = re.compile(
    r"\\(?P<what>tag\*?|label)\s*\{(?P<name>[^{}]*)\}|\\l?eqno\s*(?:\{(?P<braces>[^{}]*)\}|(?P<bare>\S+))"
)
LEFT = re.compile(r"\\(?:tag|label|l?eqno)(?![a-zA-Z])")  # a number that MARK does not take
BARE = re.compile(r"\\(?:nonumber|notag)(?![a-zA-Z])")
ALIGNED = re.compile(r"(\\(?:begin|end)\{)(?:aligned|split|alignedat|gathered)\}(?:\[[tbc]\]|\{\d\})?")
AT_END = re.compile(r"(?:(?<!\\)[.,;]|\\[,;:!]|\\q?quad|\s)+$")
BREAK = r"\\\\(?:\*|\s*\[\s*-?[\d.]+\s*\\?[a-z]+\s*\])?"
GOES_ON = re.compile(r"(?:&|\\q?quad|\\[,;:!]|\{\}|\s)*(?:[=+]|\\(?:times|cdot)|-(?!.*=))", re.DOTALL)


@dataclass(frozen=True)
class Row:
    """A row of a display: where it begins and ends in it, its text, its number, and its labels.

    bare: it has none, and says so.
    """

    begins: int
    ends: int
    text: str
    number: str
    labels: tuple[str, ...]
    bare: bool


def aside(latex: str) -> str:
    """What an equation says beside its formula, for the list of what is not held; "" where there is nothing."""
    texts = []
    for found in ASIDE.finditer(latex):
        text = re.sub(r"\\(?:text|mbox|textrm|mathcal)\s*\{?([^{}]*?)\}", r"\1", found[0]).replace(r"\cdots", "...")
        texts.append(" ".join(re.sub(r"\\(?:q?quad|left|right|[,;])", " ", text).strip(" ,+\n").split()))
    return f"what the print says beside the formula, '{', '.join(texts)}'" if texts else ""


def displays(path: Path, macros: Mapping[str, str] = MappingProxyType({})) -> Iterator[Display]:
    """The displayed equations of a LaTeX file, each with its tag or its label.  Raises BoresightError.

    macros: abbreviations, those that the file defines with them.
    """
    text = text_of(path)
    bare = re.sub(r"(?<!\\)%.*", blank, text)
    bare = DECLARED.sub(blank, bare)
    known: dict[str, int] = {}
    lettered = _subequations(bare)
    for found in ENVIRONMENT.finditer(bare):
        for first, one in _Environment(path, text, found, lettered.get(found.start())).equations(macros):
            if one.number in known:
                line = known[one.number]
                refuse(path, text, first, f"two equations are called {one.number}; line {line} has the first")
            known[one.number] = one.lines[0]
            yield one
    if not known:
        refuse(path, text, 0, r"no equation is displayed; write \begin{equation} ... \tag{1} \end{equation}")
    outside = SUBEQUATIONS.sub(blank, ENVIRONMENT.sub(blank, bare))
    if lost := re.search(r"\\tag\*?\s*\{|\\l?eqno(?![a-zA-Z])|\\label\s*\{eqn?:", outside):
        what = r"this number stands in no display that is read: \begin{equation}, align, gather, eqnarray or \["
        refuse(path, text, lost.start(), what)


def blank(found: re.Match) -> str:
    return re.sub(r"[^\n]", " ", found[0])


def _subequations(bare: str) -> dict[int, Iterator[str]]:
    """By where a display begins the numbers of what stands in the same subequations: 4a, 4b, ..."""
    found: dict[int, Iterator[str]] = {}
    for outer in SUBEQUATIONS.finditer(bare):
        inner = [outer.start(1) + one.start() for one in ENVIRONMENT.finditer(outer[1])]
        if inner and (mark := MARK.search(bare, outer.start(1), inner[0])):
            found |= dict.fromkeys(inner, iter([number_of(mark) + letter for letter in ascii_lowercase]))
    return found


def number_of(mark: re.Match) -> str:
    name = next(filter(None, (mark["name"], mark["braces"], mark["bare"])), "").strip()
    return re.sub(r"^eqn?:", "", name).strip("()") if mark["what"] == "label" else name.strip("()")


class _Environment:
    """One environment of a file, whose equations are its rows or all of it.  lettered: the numbers of its rows within
    subequations."""

    def __init__(self, path: Path, text: str, found: re.Match, lettered: Iterator[str] | None):
        self.path, self.file, self.found = path, text, found
        part = next(part for part in ("body", "square", "dollars") if found[part] is not None)
        self.at, self.ends, self.name = found.start(part), found.end(part), found["name"] or ""
        marked = found[part]
        if self.name in ("alignat", "IEEEeqnarray"):  # its columns
            marked = re.sub(r"\s*\{[^{}]*\}", blank, marked, count=1)
        self.body = BARE.sub(blank, MARK.sub(blank, marked))
        if lost := LEFT.search(self.body):
            self.refuse(lost.start(), r"this number cannot be read; write it as \tag{12a}")
        self.rows = [self.row(*span, marked) for span in self.spans()]
        if lettered:
            own = {i: next(lettered) for i, row in enumerate(self.rows) if not row.bare and not GOES_ON.match(row.text)}
            self.rows = [replace(row, number=row.number or own.get(i, "")) for i, row in enumerate(self.rows)]

    def refuse(self, at: int, what: str) -> NoReturn:
        refuse(self.path, self.file, self.at + at, what)

    def spans(self) -> Iterator[tuple[int, int]]:
        """Where the rows begin and end."""
        if self.name not in ROWS:
            yield 0, len(self.body)
            return
        begins = depth = 0
        for piece in re.finditer(rf"\\begin\{{|\\end\{{|{BREAK}", self.body):
            depth += (piece[0] == r"\begin{") - (piece[0] == r"\end{")
            if piece[0].startswith(r"\\") and not depth:
                yield begins, piece.start()
                begins = piece.end()
        if self.body[begins:].strip():
            yield begins, len(self.body)

    def row(self, begins: int, ends: int, marked: str) -> Row:
        marks = [mark for mark in MARK.finditer(marked, begins, ends) if number_of(mark)]
        kinds: dict[bool, re.Match] = {}
        for mark in marks:
            other = kinds.setdefault(mark["what"] == "label", mark)
            if other is not mark:
                both = f"{number_of(other)} and {number_of(mark)}"
                self.refuse(
                    mark.start(), f"one equation is called {both}: write align, and a number in each of its rows"
                )
        chosen = kinds.get(False) or kinds.get(True)
        labels = tuple(mark["name"].strip() for mark in marks if mark["what"] == "label")
        text, bare = self.body[begins:ends], bool(BARE.search(marked, begins, ends))
        begins, ends = begins + len(text) - len(text.lstrip()), ends - len(text) + len(text.rstrip())
        return Row(begins, ends, text.strip(), number_of(chosen) if chosen else "", labels, bare)

    def groups(self) -> Iterator[list[Row]]:
        """The rows of each equation: of a display with one number all of them."""
        numbered = [row for row in self.rows if row.number]
        if len(numbered) < 2:
            yield self.rows
            return
        waiting: list[Row] = []  # rows whose number stands after them
        for chunk in self.chunks():
            named = [row for row in chunk if row.number]
            if len(named) > 1 or (named and GOES_ON.match(chunk[0].text)):
                self.refuse(named[-1].begins, f"({named[-1].number}) begins with a sign: write its left side, or leave "
                            "out the number where the row goes on")  # fmt: skip
            if not named and (not any(row.bare for row in chunk) or chunk[-1] is self.rows[-1]):
                self.refuse(chunk[0].begins, r"this row has no number: add \tag{...}, or \nonumber where it belongs to "
                            "the row after it")  # fmt: skip
            waiting += chunk
            if named:
                yield waiting
                waiting = []

    def chunks(self) -> Iterator[list[Row]]:
        """Each row with those that go on from it."""
        chunk: list[Row] = []
        for row in self.rows:
            if chunk and not GOES_ON.match(row.text):
                yield chunk
                chunk = []
            chunk.append(row)
        yield chunk

    def equations(self, macros: Mapping[str, str]) -> Iterator[tuple[int, Display]]:
        """Each with where it begins in the file."""
        for group in self.groups():
            whole = group == self.rows
            begins, ends = (0, len(self.body)) if whole else (group[0].begins, group[-1].ends)
            first, last = self.found.span() if whole else (self.at + begins, self.at + ends)
            named = next((row for row in group if row.number), None)
            if named is None:
                what = r"the equation has no number: add \tag{1}, as the paper numbers it"
                refuse(self.path, self.file, first, what)
            stands = SOURCE.search(self.file, first, last)
            source = (int(stands[1]), int(stands[2] or stands[1])) if stands else (0, 0)
            lines = (self.file.count("\n", 0, first) + 1, self.file.count("\n", 0, last) + 1)
            yield first, Display(named.number, self.latex(group, macros), self.at + begins, self.at + ends, lines,
                                 source, self.body[begins:ends], named.labels)  # fmt: skip

    def latex(self, group: list[Row], macros: Mapping[str, str]) -> tuple[str, ...]:
        rows = [AT_END.sub("", ALIGNED.sub(r"\1aligned}", row.text)) for row in group]
        try:
            rows = [expanded(row, macros) for row in rows]
        except ValueError as error:
            self.refuse(group[0].begins, str(error))
        if self.name == "multline":
            rows = [re.sub(BREAK, " ", row) for row in rows]
        elif self.name in ROWS and self.name != "gather":
            rows = [r"\begin{aligned}" + r" \\ ".join(rows) + r"\end{aligned}"]
        return tuple(rows)
