"""Boresight beside what a user would pick instead: python -m benchmarks.peers [--page docs/benchmarks.md]

Prints one table a set of flags, and writes it, with the figures, to out/bench; into the page, if it is named.
"""

import argparse
import importlib.metadata
import re
import shutil
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from benchmarks.growth import grown
from benchmarks.peers import batch, compiled, ours, report
from benchmarks.peers.compiled import Task
from benchmarks.peers.formulas import KINDS, Problem, operations, problem
from benchmarks.peers.printers import PRINTERS, named_c
from boresight.derive.model import Model
from boresight.derive.models.azimuth_hold import azimuth_hold

STATES = (6, 15, 30, 45, 60)
GROWN = {"predict 2": ("CasADi", "Eigen, dense by hand"), "updates, Joseph": ()}  # kind -> peers beside it
PACKAGES = ("casadi", "symforce", "wrenfold", "sympy", "numpy", "numba", "jax", "filterpy", "python-ins", "simdkalman")
EIGEN = (Path("/usr/include/eigen3"), Path(sys.prefix) / "debian" / "usr" / "include" / "eigen3")
WRENFOLD = Path(sys.prefix) / "include" / "site" / f"python{sys.version_info.major}.{sys.version_info.minor}"
PAGE_KINDS = ("predict 2", "updates, Joseph", "propagate")  # whose code is weighed


def of_boresight(models: Mapping[str, Model], p: Problem, folder: Path, kinds: Sequence[str] = KINDS) -> Iterator[Task]:
    """models: what a kind is taken from, and `other` for the rest."""
    sources = {m.c_prefix: ours.printed(m, folder / m.c_prefix) for m in models.values()}
    for kind in kinds:
        model = models.get(kind, models["other"])
        top = folder / model.c_prefix
        for tool in (*ours.FORMS, ours.NON_ZEROS):
            name = named_c(f"{tool} {p.n} {kind}")
            text = ours.calls(p, model, kind, name, tool)
            if text:
                include = [top / "include", top / "src"]
                yield Task(tool, kind, name, p, text, "c", sources[model.c_prefix], include)


def of_peers(
    p: Problem, missing: dict[str, str], tools: Sequence[str] = tuple(PRINTERS), kinds: Sequence[str] = KINDS
) -> Iterator[Task]:
    """What each peer prints; what does not is put among the missing."""
    eigen = next((path for path in EIGEN if path.exists()), None)
    for tool in tools:
        for kind in kinds:
            name = named_c(f"{tool} {p.n} {kind}")
            try:
                text, suffix = PRINTERS[tool](p, kind, name)
            except Exception as error:  # whatever a foreign tool does, the others are still measured
                missing[tool] = f"{type(error).__name__}: {error}".splitlines()[0]
                break
            if "<Eigen/" in text and eigen is None:
                missing[tool] = "the headers of libeigen3-dev are not installed"
                break
            yield Task(tool, kind, name, p, text, suffix, (), [path for path in (eigen, WRENFOLD) if path])


def versions() -> str:
    """Of the tools and compilers, as one sentence's worth of words."""
    found = []
    for name in PACKAGES:
        try:
            found.append(f"{name} {importlib.metadata.version(name)}")
        except importlib.metadata.PackageNotFoundError:
            continue
    for path in EIGEN:
        macros = path / "Eigen" / "src" / "Core" / "util" / "Macros.h"
        if macros.exists():
            numbers = re.findall(r"#define EIGEN_(?:WORLD|MAJOR|MINOR)_VERSION (\d+)", macros.read_text())
            found.append(f"Eigen {'.'.join(numbers)}")
            break
    for command in ("gcc", "valgrind", "arm-none-eabi-gcc"):
        if shutil.which(command):
            head = compiled.run([command, "--version"]).decode().splitlines()[0]
            found.append(f"{command} {re.findall(r'[0-9]+[.][0-9.]*[0-9]', head)[-1]}")
    return f"Python {'.'.join(map(str, sys.version_info[:3]))}, " + ", ".join(found)


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.peers", description=__doc__)
    parser.add_argument("--page", type=Path, help="a page of Markdown with the two markers")
    parser.add_argument("--out", type=Path, default=Path("out/bench"))
    parser.add_argument("--draw", action="store_true", help="measure nothing: draw the page's figure from its tables")
    chosen = parser.parse_args()
    if chosen.draw and chosen.page:
        return draw(chosen.page)
    folder, missing = chosen.out, dict[str, str]()
    folder.mkdir(parents=True, exist_ok=True)
    second = azimuth_hold()
    first = replace(second, order=1, name="azimuth-hold-first", c_prefix="a1")
    p = problem(second)
    tasks = [*of_boresight({"predict 1": first, "other": second}, p, folder), *of_peers(p, missing)]
    for label in compiled.HOSTS:
        missing |= compiled.measure(tasks, label, folder)
    no_sizes = compiled.sizes([task for task in tasks if task.kind in PAGE_KINDS], folder)
    growing: list[Task] = []
    for n in STATES:
        model = grown(n)
        smaller = problem(model)
        some = [*of_boresight({"other": model}, smaller, folder, tuple(GROWN))]
        for kind, peers in GROWN.items():
            some += of_peers(smaller, missing, peers, (kind,))
        compiled.measure(some, "-O2", folder, rounds=9)
        compiled.sizes([task for task in some if task.tool.startswith(report.OURS)], folder)
        growing += some
    batched, absent = batch.measure(p)
    missing |= absent
    tables = [*single(tasks, p, compiled.clock(folder)), *many(batched), *growth(growing)]
    code = report.cells_of([task for task in tasks if task.kind in PAGE_KINDS], lambda task: task.text_bytes)
    if code:
        title = "Code and tables on a Cortex-M7 in double at -O2, bytes, without the C library's own."
        tables.append(report.compared(title, code, PAGE_KINDS))
    foot = [f"Measured on {report.machine(Path('/proc/cpuinfo').read_text())}; {versions()}."]
    foot.append(f"Every tool's numbers are those of NumPy within {compiled.EQUAL:.0e}; the furthest was "
                f"{max(task.apart for task in tasks):.0e}.")  # fmt: skip
    foot += [f"Missing: {tool} ({report.without_paths(why)})." for tool, why in missing.items()]
    foot += [f"No code sizes: {report.without_paths(no_sizes)}."] if no_sizes else []
    print("\n\n".join([*(table.text() for table in tables), *foot]))
    text = "\n\n".join([*(table.markdown() for table in tables), *map(wrapped, foot)])
    (folder / "benchmarks.md").write_text(text + "\n")
    report.figure(folder / "benchmarks.svg", text)
    if chosen.page:
        report.written(chosen.page, text)
        draw(chosen.page)


def draw(page: Path) -> None:
    """The figure of a page, from its tables."""
    report.figure(page.parent / "figures" / "benchmarks.svg", page.read_text(encoding="utf-8"))


def wrapped(line: str) -> str:
    import textwrap

    return textwrap.fill(line, 100, break_long_words=False, break_on_hyphens=False)


def under(what: str, label: str, task: Task) -> float | None:
    """A task's `ns` or `instructions` under these flags, if they were measured."""
    found: dict[str, float] = getattr(task, what)
    return found.get(label)


def single(tasks: list[Task], p: Problem, ghz: float) -> Iterator[report.Table]:
    """A table a set of flags: ns and instructions, with the operations of the formulas and the limit."""
    done = {kind: operations(p, kind) for kind in KINDS}
    count = {kind: str(sum(done[kind].values())) for kind in KINDS}
    for label, lanes in zip(compiled.HOSTS, (2, 4), strict=True):
        limits = {kind: f"{compiled.limit(p, kind, done[kind], lanes, ghz):.0f}" for kind in KINDS}
        further = [
            ("operations of the formulas", count),
            (f"limit of the machine, {lanes} at once, ns", limits),
        ]
        yield report.compared(
            f"**One call at {label}: ns / instructions.**",
            report.cells_of(tasks, partial(under, "ns", label)),
            KINDS,
            report.cells_of(tasks, partial(under, "instructions", label)),
            further,
        )


def many(batched: Mapping[tuple[str, str, int], float]) -> Iterator[report.Table]:
    for step in batch.STEPS:
        name = {"simdkalman": "simdkalman, plain form"} if step.startswith("updates") else {}
        cells = {(name.get(tool, tool), f"N = {N}"): ns for (tool, other, N), ns in batched.items() if other == step}
        title = f"**{step[0].upper() + step[1:]}, N runs at once from Python: ns per run.**"
        yield report.compared(title, cells, [f"N = {N}" for N in batch.SIZES])


def growth(tasks: list[Task]) -> Iterator[report.Table]:
    """A table a kind: ns and instructions of each tool by the number of states; then the code on the target."""
    columns = [f"{n} states" for n in STATES]

    def by_states(value: Callable[[Task], float | None], kind: str) -> dict[tuple[str, str], float]:
        found = {(task.tool, f"{task.problem.n} states"): value(task) for task in tasks if task.kind == kind}
        return {key: number for key, number in found.items() if number is not None}

    for kind in GROWN:
        count = {f"{t.problem.n} states": str(sum(operations(t.problem, kind).values())) for t in tasks}
        yield report.compared(
            f"**{kind[0].upper() + kind[1:]} at -O2 against the number of states: ns / instructions.**",
            by_states(partial(under, "ns", "-O2"), kind),
            columns,
            by_states(partial(under, "instructions", "-O2"), kind),
            [("operations of the formulas", count)],
        )
    for kind in GROWN:
        code = by_states(lambda task: task.text_bytes, kind)
        if code:
            yield report.compared(f"**{kind[0].upper() + kind[1:]}: code on a Cortex-M7, bytes.**", code, columns)


if __name__ == "__main__":
    main()
