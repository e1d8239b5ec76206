"""What `boresight many` takes, against the runs and by what flies them: python -m benchmarks.runs [--page PAGE]

The sea experiment whole, with truth, processes and summaries, once what is compiled is there; the clock's, the least of
three.  --page puts the table between the markers of a Markdown page and draws the figure beside it.  Without a GPU its
row stays as the page has it, and the GPU's name with it.
"""

import argparse
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from time import perf_counter
from typing import Any

from benchmarks.peers import report
from boresight import BoresightError, many
from boresight.runtime.gpu.card import Card
from boresight.studies.sea_state import many as sea

SEED, REPEATS = 1, 3
SIZES = (64, 1024, 8192, 32_768, 65_536, 270_336)
TITLE = "Milliseconds by the clock."
GPU = "GPU"
MOST = {"scalar C": 8192, "lanes, one process": 65_536}  # beyond it each is as before, times the runs


def candidates() -> dict[str, Callable[[int], Any]]:
    """How so many runs are flown, by the name of its row."""
    kind, jobs = sea.experiment(sea.Sea("sea", 4)), os.cpu_count() or 1
    in_c = replace(kind, fly=None)
    found: dict[str, Callable[[int], Any]] = {
        "scalar C": lambda runs: many(in_c, runs=runs, seed=SEED, chunk=64),
        "lanes, one process": lambda runs: many(kind, runs=runs, seed=SEED),
        f"lanes, {jobs} processes": lambda runs: many(kind, runs=runs, seed=SEED, jobs=jobs),
    }
    try:
        found[f"{GPU}, {Card().name}"] = lambda runs: many(kind, runs=runs, seed=SEED, device="gpu")
    except BoresightError as error:
        print(f"no GPU here: {error}")
    return found


def measured() -> report.Table:
    table = report.Table(TITLE, [f"{runs} runs" for runs in SIZES])
    for name, fly in candidates().items():
        fly(SIZES[0])  # compiles
        cells = []
        for runs in SIZES:
            times = []
            for _ in range(REPEATS * (runs <= MOST.get(name, runs))):
                sea.shared.cache_clear()
                begun = perf_counter()
                fly(runs)
                times.append(perf_counter() - begun)
            cells.append(f"{1e3 * min(times):.0f}" if times else "-")
            print(f"{name:24} {runs:8} {cells[-1]} ms", flush=True)
        table.rows.append((name, cells))
    return table


def figure(path: Path, text: str) -> None:
    """Of the page's table: a line for each row."""
    from boresight.analysis.figures import BLUE, GREEN, GREY, ORANGE, Sheets

    cells = report.read_back(text)[TITLE]
    sheets = Sheets(path.parent, "python -m benchmarks.runs", svg=True)
    with sheets("many", 5.5, 3.2) as (_, axis):
        for name, colour in zip(dict.fromkeys(name for name, _ in cells), (GREY, BLUE, GREEN, ORANGE), strict=False):
            points = [(int(column.split()[0]), ms / 1e3) for (row, column), ms in cells.items() if row == name]
            axis.loglog(*zip(*points, strict=True), marker="o", ms=4, color=colour, label=name)
        axis.set(title="the flight at sea, a minute each run", xlabel="runs", ylabel="time by the clock [s]")
        axis.legend(loc="upper left")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--page", type=Path)
    parser.add_argument("--draw", action="store_true", help="measure nothing: draw the page's figure from its table")
    chosen = parser.parse_args()
    if not chosen.draw:
        table = measured()
        print(f"\n{table.text()}")
        if chosen.page:
            kept = [row for row in chosen.page.read_text().splitlines() if row.startswith(f"| {GPU}")]
            new = any(name.startswith(GPU) for name, _ in table.rows)
            report.written(chosen.page, "\n".join([table.markdown(), *([] if new else kept)]))
    if chosen.page:
        figure(chosen.page.parent.parent / "figures" / "many.svg", chosen.page.read_text())


if __name__ == "__main__":
    main()
