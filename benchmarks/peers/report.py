"""What was measured, as text, as Markdown between two markers, and as figures.  Holds no host, no path and no date."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from benchmarks.peers.formulas import KINDS

BEGIN, END = "<!-- measured: begin -->", "<!-- measured: end -->"
OURS = "Boresight"
Cells = Mapping[tuple[str, str], float]  # (tool, kind) -> number


@dataclass
class Table:
    title: str
    columns: Sequence[str]
    rows: list[tuple[str, Sequence[str]]] = field(default_factory=list)

    def lines(self) -> list[list[str]]:
        return [["", *self.columns], *([name, *cells] for name, cells in self.rows)]

    def markdown(self) -> str:
        head, *rest = ("| " + " | ".join(line) + " |" for line in self.lines())
        return "\n".join([self.title, "", head, "|---" * (len(self.columns) + 1) + "|", *rest])

    def text(self) -> str:
        lines = [[cell.replace("**", "") for cell in line] for line in self.lines()]
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        rows = (
            line[0].ljust(widths[0]) + "".join(f"  {cell:>{w}}" for cell, w in zip(line[1:], widths[1:], strict=True))
            for line in lines
        )
        return "\n".join([self.title.replace("**", ""), *rows])


ASIDE = {  # what has another form or result than its column says; a tool, or a tool in one column
    "Boresight, non-zeros alone",
    "Boresight, UD factors",
    "simdkalman, plain form",
    ("wrenfold", "updates, Joseph"),
}
STAND_IN = {"updates, plain": "updates, Joseph"}  # what ours is compared in a column that it has not


def aside(tool: str, column: str) -> bool:
    return tool in ASIDE or (tool, column) in ASIDE


def compared(
    title: str,
    cells: Cells,
    columns: Sequence[str],
    beside: Cells | None = None,
    further: Sequence[tuple[str, Mapping[str, str]]] = (),
    form: Callable[[float], str] = "{:.0f}".format,
) -> Table:
    """A row a tool, the least of each column in bold, and what we need over the best peer.

    What is ASIDE has a star, and no part in that.  beside: is put behind each number.  further: rows of other things,
    by column.
    """
    tools = sorted(dict.fromkeys(tool for tool, _ in cells), key=lambda tool: not tool.startswith(OURS))
    table = Table(title, columns)

    def of(column: str, mine: bool) -> dict[str, float]:
        return {
            tool: value
            for (tool, kind), value in cells.items()
            if kind == column and tool.startswith(OURS) == mine and not aside(tool, column)
        }

    for tool in tools:
        row = []
        for column in columns:
            value = cells.get((tool, column))
            text = "-" if value is None else form(value)
            if value is not None and value == min((of(column, True) | of(column, False)).values(), default=None):
                text = f"**{text}**"
            if beside and (tool, column) in beside:
                text += f" / {beside[tool, column]:.0f}"
            if value is not None and aside(tool, column):
                text += " *"
            row.append(text)
        table.rows.append((tool, row))
    verdicts = []
    for column in columns:
        mine, theirs = of(column, True) or of(STAND_IN.get(column, ""), True), of(column, False)
        if not mine or not theirs:
            verdicts.append("-")
            continue
        best = min(theirs, key=theirs.__getitem__)
        ratio = min(mine.values()) / theirs[best]
        verdicts.append(f"{ratio:.2f}, {best if ratio > 1 else OURS} wins")
    table.rows.append((f"{OURS} over the best peer", verdicts))
    table.rows += [(name, [cells.get(column, "-") for column in columns]) for name, cells in further]
    return table


def written(page: Path, text: str) -> None:
    """Put the text between the page's markers.  Raises ValueError where it has not one pair of them."""
    before = page.read_text()
    if before.count(BEGIN) != 1 or before.count(END) != 1:
        raise ValueError(f"{page.name} has not one pair of markers")
    head, tail = before.split(BEGIN)[0], before.split(END)[1]
    page.write_text(f"{head}{BEGIN}\n{text.strip()}\n{END}{tail}")


def machine(cpuinfo: str) -> str:
    """The processor's name, of /proc/cpuinfo."""
    found = re.search(r"^model name\s*: (.+)$", cpuinfo, re.MULTILINE)
    return found[1] if found else "unknown processor"


def without_paths(text: str) -> str:
    """Only the last part of each absolute path."""
    return re.sub(r"(?<![\w.])/(?:[^\s/:,;'\"()]+/)+", "", text)


# Of ours, which has one colour: how its forms are told apart, as a line and as a bar.
FORMS = {
    "Boresight": ("-", ""), "Boresight, Epoch": ("-", ""), "Boresight, CompiledFilter": ((0, (5, 2)), ""),
    "Boresight, Filter": ((0, (1, 1.5)), ""), "Boresight, non-zeros alone": ("-", "///"),
    "Boresight, UD factors": ((0, (5, 2)), "\\\\\\"),
}  # fmt: skip
ROW = re.compile(r"^\| (.+?) \|(.*)\|$", re.MULTILINE)
COUNTED = ("operations of", "limit of", "Boresight over")  # rows that are no tool's


def read_back(text: str) -> dict[str, dict[tuple[str, str], float]]:
    """Title -> (tool, column) -> the first number of the cell, of every table of a page."""
    found = {}
    for title, head, body in re.findall(r"^(\S.*)\n\n\|  \|(.*)\|\n\|[-|]+\n((?:\|.*\n?)+)", text, re.MULTILINE):
        columns = [column.strip() for column in head.split("|")]
        cells = {
            (tool, column): re.match(r"[*]*(\d+)", cell.strip())
            for tool, row in ROW.findall(body)
            if not tool.startswith(COUNTED)
            for column, cell in zip(columns, row.split("|"), strict=True)
        }
        found[title.strip("*")] = {key: float(number[1]) for key, number in cells.items() if number}
    return found


def figure(path: Path, text: str) -> None:
    """Four panels of the tables of a page: one call in C, a batch from Python, cost against states, code on a
    Cortex-M7.  A tool has one colour in all of them, and ours has one in all its forms."""
    from boresight.analysis.figures import TOOLS, Sheets

    tables = read_back(text)

    def of(begin: str) -> dict[tuple[str, str], float]:
        return next((cells for title, cells in tables.items() if title.startswith(begin)), {})

    def look(tool: str) -> tuple[str, Any]:
        return TOOLS["Boresight" if tool.startswith("Boresight") else tool], FORMS.get(tool, ("-", ""))

    def bars(axis: Any, cells: Cells, title: str, unit: str) -> None:
        kinds, tools = ([*dict.fromkeys(key[at] for key in cells)] for at in (1, 0))
        kinds.sort(key=KINDS.index)
        for k, tool in enumerate(tools):
            colour, (_, hatch) = look(tool)
            there = [(i, cells[tool, kind]) for i, kind in enumerate(kinds) if (tool, kind) in cells]
            at = [i + (0.8 * k + 0.4) / len(tools) - 0.4 for i, _ in there]
            drawn = {"facecolor": "white", "edgecolor": colour, "hatch": hatch} if hatch else {"color": colour}
            axis.bar(at, [value for _, value in there], 0.75 / len(tools), label=tool, linewidth=0.6, **drawn)
        axis.set_xticks(range(len(kinds)), [kind.replace(", ", ",\n") for kind in kinds], fontsize=7)
        axis.set_axisbelow(True)
        axis.grid(axis="x", visible=False)
        axis.set(title=title, ylabel=f"[{unit}]")

    def lines(axis: Any, cells: Cells, title: str, x: str, note: str = "", marker: str = "o") -> None:
        for tool in dict.fromkeys(tool for tool, _ in cells):
            colour, (line, _) = look(tool)
            points = [(int(re.findall(r"\d+", column)[0]), value) for (t, column), value in cells.items() if t == tool]
            axis.loglog(*zip(*points, strict=True), marker=marker, ms=4, ls=line, color=colour, label=tool + note)
        at = sorted({int(re.findall(r"\d+", column)[0]) for _, column in cells})
        axis.set_xticks(at, map(str, at))
        axis.set_xticks([], minor=True)
        axis.set(title=title, xlabel=x, ylabel="[ns]")

    measured = re.search(r"Measured on (.*?);", text)
    made_from = f"make bench, {measured[1]}" if measured else "make bench"
    sheets = Sheets(path.parent, made_from, svg=path.suffix == ".svg")
    with sheets("benchmarks", 12, 8.2, nrows=2, ncols=2) as (_, ((calls, batch), (growth, size))):
        bars(calls, of("One call at -O2"), "one call in C at -O2", "ns")
        lines(batch, of("Propagate, N runs"), "propagate from Python, of each run", "runs at once")
        lines(growth, of("Predict 2 at -O2"), "one call at -O2", "states", ", predict 2")
        lines(growth, of("Updates, Joseph at -O2"), "one call at -O2", "states", ", updates", "s")
        bars(size, of("Code and tables"), "code on a Cortex-M7", "bytes")
        size.set_yscale("log")
        for axis in (calls, batch, growth, size):
            axis.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1, 1), handlelength=3)  # beside what is drawn


def cells_of(tasks: Sequence[Any], value: Callable[[Any], Any]) -> dict[tuple[str, str], float]:
    """Of tasks, in the order of KINDS; what was not measured is left out."""
    made = {(task.tool, task.kind): value(task) for task in sorted(tasks, key=lambda task: KINDS.index(task.kind))}
    return {key: number for key, number in made.items() if number is not None}
