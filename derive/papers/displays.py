"""The displayed equations of printed.tex: verbatim, each with its number and the lines at which it stands."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from boresight.derive.papers.toml import refuse, text_of


@dataclass(frozen=True)
class Display:
    """One equation of printed.tex: its number, its LaTeX, of `gather` that of each row, and where in the file that
    begins and ends.

    lines: of the file; source: of the paper's text, by a comment, % line 76 or % lines 90-94, in the equation.
    """

    number: str
    latex: tuple[str, ...]
    begins: int
    ends: int
    lines: tuple[int, int]
    source: tuple[int, int] = (0, 0)


ENVIRONMENT = re.compile(
    r"\\begin\{(?P<name>equation|align|gather|multline|displaymath|eqnarray)\*?\}(?P<body>.*?)\\end\{(?P=name)\*?\}"
    r"|\\\[(?P<square>.*?)\\\]|\$\$(?P<dollars>.*?)\$\$",
    re.DOTALL,
)
# What an equation says beside its formula: an order, further terms, a condition in words to the end of the row.
ASIDE = re.compile(
    r"\+\s*\\mathcal\s*(?:\{\s*O\s*\}|O)\s*(?:\\left\s*)?\((?:[^()]|\([^()]*\))*\)"
    r"|\+\s*\\[cl]?dots(?=\s*(?:\\\\|\\end|$))"
    r"|(?:,|\\q?quad|\\[,;]|\s)*\\(?:text|mbox|textrm)\s*\{\s*(?:for|if|where|when|with|as|at|in)\b[^{}]*\}"
    r"(?:(?!\\\\|\\end).)*",
    re.DOTALL,
)
SOURCE = re.compile(r"%\s*lines?\s+(\d+)(?:\s*-\s*(\d+))?")
LABEL = re.compile(r"\\(?:tag|label)\{(?:eqn?:)?([^{}]*)\}")


def aside(latex: str) -> str:
    """What an equation says beside its formula, for the list of what is not held; "" where there is nothing."""
    texts = []
    for found in ASIDE.finditer(latex):
        text = re.sub(r"\\(?:text|mbox|textrm|mathcal)\s*\{?([^{}]*?)\}", r"\1", found[0]).replace(r"\cdots", "...")
        texts.append(" ".join(re.sub(r"\\(?:q?quad|left|right|[,;])", " ", text).strip(" ,+\n").split()))
    return f"what the print says beside the formula, '{', '.join(texts)}'" if texts else ""


def displays(path: Path) -> Iterator[Display]:
    """The displayed equations of a LaTeX file, each with its tag or its label.  Raises BoresightError."""
    text = text_of(path)
    bare = without_comments(text)
    known: dict[str, int] = {}
    for found in ENVIRONMENT.finditer(bare):
        body = next(part for part in ("body", "square", "dollars") if found[part] is not None)
        at, inside = found.start(body), found[body]
        marks = {mark[0].startswith(r"\tag"): mark[1] for mark in LABEL.finditer(inside)}
        number = marks.get(True, marks.get(False, "")).strip().strip("()")
        line = text.count("\n", 0, found.start()) + 1
        if not number:
            refuse(path, text, found.start(), r"the equation has no number: add \tag{1}, as the paper numbers it")
        if number in known:
            refuse(path, text, found.start(), f"two equations are called {number}; line {known[number]} has the first")
        known[number] = line
        inside = without_labels(inside)
        inside = re.sub(r"(\\(?:begin|end)\{)(?:split|alignedat)\}", r"\1aligned}", inside)
        lines = (line, text.count("\n", 0, found.end()) + 1)
        inside = inside.rstrip().rstrip(".,;").rstrip()
        if found["name"] in ("align", "eqnarray"):
            inside = rf"\begin{{aligned}}{inside}\end{{aligned}}"
        rows = tuple(rows_of(inside)) if found["name"] == "gather" else (inside.strip(),)
        stands = SOURCE.search(text, found.start(), found.end())
        source = (int(stands[1]), int(stands[2] or stands[1])) if stands else (0, 0)
        yield Display(number, rows, at, found.end(body), lines, source)
    if not known:
        refuse(path, text, 0, r"no equation is displayed; write \begin{equation} ... \tag{1} \end{equation}")


def without_comments(text: str) -> str:
    return re.sub(r"(?<!\\)%.*", lambda comment: " " * len(comment[0]), text)


def without_labels(text: str) -> str:
    return re.sub(rf"{LABEL.pattern}|\\nonumber|\\notag", lambda mark: " " * len(mark[0]), text)


def rows_of(text: str) -> Iterator[str]:
    """What stands between double backslashes, not within an environment."""
    row, depth = "", 0
    for piece in re.split(r"(\\begin\{|\\end\{|\\\\)", text):
        depth += (piece == r"\begin{") - (piece == r"\end{")
        if piece == r"\\" and not depth:
            yield row.strip()
            row = ""
        else:
            row += piece
    yield row.strip()
