"""Build, check, count and time the C of all tools."""

import hashlib
import re
import shutil
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median

import numpy as np

from benchmarks.peers.formulas import Problem, apart, numbers, reference

FLAGS = {"-O2": ("-O2",), "-O3 v3": ("-O3", "-march=x86-64-v3")}
LANGUAGES = {"c": ("gcc", "-std=c99", "-ffp-contract=off"), "cc": ("g++", "-std=c++17")}
EQUAL, ROUNDS, SECONDS = 1e-12, 21, 2e-3


class Differs(Exception):
    """A tool's numbers are not those of NumPy."""


@dataclass
class Task:
    """One function of one tool: its name in C, its sources (text, suffix) and what was measured of it by flags."""

    tool: str
    kind: str
    name: str
    problem: Problem
    text: str
    suffix: str
    sources: Sequence[Path] = ()
    include: Sequence[Path] = ()
    apart: float = np.nan
    ns: dict[str, float] = field(default_factory=dict)
    instructions: dict[str, int] = field(default_factory=dict)


def run(command: Sequence[object], **keywords: object) -> subprocess.CompletedProcess[bytes]:
    done = subprocess.run([str(word) for word in command], capture_output=True, check=False, **keywords)  # type: ignore[call-overload]
    if done.returncode != 0:
        raise RuntimeError(f"{command[0]}: {done.stderr.decode(errors='replace').strip()[:400]}")
    return done


def compiled(text: str, suffix: str, flags: Sequence[str], include: Sequence[Path], folder: Path, of: str = "") -> Path:
    """The object of a source, from the cache if it is there.  of: what the headers say, besides."""
    command = [*LANGUAGES[suffix], *flags, "-fPIC", *(f"-I{path}" for path in include)]
    key = hashlib.sha256("\0".join([text, of, *command]).encode()).hexdigest()[:24]
    out = folder / f"{key}.o"
    if not out.exists():
        source, aside = folder / f"{key}.{suffix}", folder / f"{key}.part"
        source.write_text(text)
        run([*command, "-c", source, "-o", aside])
        aside.rename(out)
    return out


def library(tasks: Sequence[Task], flags: Sequence[str], folder: Path) -> Path:
    """One shared library of all tasks."""
    jobs: dict[tuple[str, str, tuple[Path, ...]], str] = {}
    for task in tasks:
        headers = "".join(
            path.read_text() for source in task.sources for path in sorted(source.parent.parent.rglob("*.h"))
        )[:10_000_000] if task.sources else ""
        jobs[task.text, task.suffix, tuple(task.include)] = headers
        for path in task.sources:
            jobs[path.read_text(), "c", tuple(task.include)] = headers
    with ThreadPoolExecutor(2) as pool:
        objects = list(
            pool.map(lambda job: compiled(job[0][0], job[0][1], flags, job[0][2], folder, job[1]), jobs.items())
        )
    out = folder / "all.so"
    run(["g++", "-shared", *dict.fromkeys(objects), "-lm", "-o", out])
    return out


def driver(folder: Path, callgrind: bool) -> Path:
    out = folder / ("counted" if callgrind else "drive")
    source = Path(__file__).with_name("drive.c")
    run(["gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-O2", *(["-DCALLGRIND"] if callgrind else []), source, "-ldl", "-o", out])
    return out


def measure(tasks: list[Task], label: str, folder: Path, rounds: int = ROUNDS) -> None:
    """Check, then time and count every task under one set of flags.  All are of one problem.

    Raises Differs before anything is timed.
    """
    folder = (folder / "objects").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    p = tasks[0].problem
    shared, given, names = library(tasks, FLAGS[label], folder), numbers(p), [task.name for task in tasks]
    widest = max(p.n**2, max(p.writes(task.kind) for task in tasks))
    head = [given["v"].size, given["P"].size, widest, 0]
    np.concatenate([head, given["v"], given["P"], given["Q"]]).tofile(folder / "numbers")
    call = [driver(folder, False), shared, folder / "numbers"]
    out = np.frombuffer(run([*call, "check", 1, 0, *names]).stdout).reshape(len(tasks), widest)
    hold(tasks, out, given)
    text = run([*call, "time", rounds, SECONDS, *names]).stdout.decode()
    for task, ns in zip(tasks, medians(text), strict=True):
        task.ns[label] = ns
    if shutil.which("valgrind"):
        counted = folder / "counts"
        shutil.rmtree(counted, ignore_errors=True)
        counted.mkdir()
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={counted}/out"]
        run([*command, driver(folder, True), shared, folder / "numbers", "count", 1, 0, *names])
        counts = instructions([path.read_text() for path in counted.iterdir()])
        for task in tasks:
            task.instructions[label] = counts[task.name]


def hold(tasks: Sequence[Task], out: np.ndarray, given: dict[str, np.ndarray]) -> None:
    """Every task's numbers against those of NumPy.  Raises Differs."""
    for task, row in zip(tasks, out, strict=True):
        wanted = reference(task.problem, task.kind, given)
        task.apart = apart(task.problem, task.kind, row[: wanted.size], wanted)
        if not task.apart <= EQUAL:
            raise Differs(f"{task.tool}, {task.kind}: {task.apart:.1e} from NumPy, where {EQUAL:.0e} is allowed")


def medians(text: str) -> list[float]:
    """Of the driver's lines, one a round."""
    return [median(column) for column in zip(*([float(word) for word in line.split()] for line in text.splitlines()))]


def instructions(dumps: Sequence[str]) -> dict[str, int]:
    """Name -> instructions, of the files that callgrind leaves."""
    found = {}
    for text in dumps:
        name = re.search(r"^desc: Trigger: Client Request: (\S+)$", text, re.MULTILINE)
        total = re.search(r"^(?:totals|summary): (\d+)", text, re.MULTILINE)
        if name and total:
            found[name[1]] = int(total[1])
    return found
