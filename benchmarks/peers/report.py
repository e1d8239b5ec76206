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


Line = Sequence[tuple[float, float]]


def figure(path: Path, bars: Cells, batch: Mapping[str, Line], growth: Mapping[str, Line], bytes_of: Cells) -> None:
    """Four panels: one call in C, a batch from Python, cost against states, code on a Cortex-M7."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "benchmarks"
    from matplotlib import pyplot as plt

    fig, axes = plt.subplots(2, 2, figsize=(14, 9), constrained_layout=True)

    drawn = (*(tool for tool, _ in bars), *batch, *growth, *(tool for tool, _ in bytes_of))
    color = {tool: f"C{k % 10}" for k, tool in enumerate(dict.fromkeys(drawn))}

    def grouped(axis: Any, cells: Cells, label: str) -> None:
        kinds, tools = ([*dict.fromkeys(key[at] for key in cells)] for at in (1, 0))
        for k, tool in enumerate(tools):
            at = [i + (0.8 * k + 0.4) / len(tools) - 0.4 for i, kind in enumerate(kinds) if (tool, kind) in cells]
            axis.bar(
                at,
                [cells[tool, kind] for kind in kinds if (tool, kind) in cells],
                0.8 / len(tools),
                label=tool,
                color=color[tool],
            )
        axis.set_xticks(range(len(kinds)), [kind.replace(", ", ",\n") for kind in kinds], fontsize=8)
        axis.set_ylabel(label)

    def curves(axis: Any, lines: Mapping[str, Line], x: str, y: str) -> None:
        for tool, points in lines.items():
            axis.loglog(*zip(*points, strict=True), "o-", label=tool, color=color[tool])
        at = sorted({point for points in lines.values() for point, _ in points})
        axis.set_xticks(at, map(str, at), minor=False)
        axis.set_xticks([], minor=True)
        axis.set_xlabel(x)
        axis.set_ylabel(y)

    grouped(axes[0, 0], bars, "one call in C at -O2, ns")
    curves(axes[0, 1], batch, "runs at once", "propagate from Python, ns per run")
    curves(axes[1, 0], growth, "states", "one call at -O2, ns")
    grouped(axes[1, 1], bytes_of, "code on a Cortex-M7, bytes")
    axes[1, 1].set_yscale("log")
    for axis in axes.flat:
        axis.grid(True, alpha=0.3)
        if axis.get_legend_handles_labels()[0]:
            axis.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1, 1))  # beside what is drawn
    fig.savefig(path, dpi=90, metadata={"Software": None})
    plt.close(fig)


def cells_of(tasks: Sequence[Any], value: Callable[[Any], Any]) -> dict[tuple[str, str], float]:
    """Of tasks, in the order of KINDS; what was not measured is left out."""
    made = {(task.tool, task.kind): value(task) for task in sorted(tasks, key=lambda task: KINDS.index(task.kind))}
    return {key: number for key, number in made.items() if number is not None}
