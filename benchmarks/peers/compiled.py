"""Build, check, count and time the C of all tools."""

import hashlib
import re
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from benchmarks.peers.formulas import Problem, apart, numbers, reference

# Beside the flags of the language, which are those of a tool's users: C++ contracts a * b + c where the machine can.
ROWS = "-DBORESIGHT_ROWS"  # of Boresight's covariance on a host
HOSTS = {"-O2": ("-O2", ROWS), "-O3 v3": ("-O3", "-march=x86-64-v3", ROWS)}
M7 = (
    *("-mcpu=cortex-m7", "-mfpu=fpv5-d16", "-mfloat-abi=hard", "-mthumb"),
    *("-O2", "-ffunction-sections", "-fdata-sections"),
)
C = ("gcc", "-std=c99", "-ffp-contract=off")
LANGUAGES = {"c": C, "cc": ("g++", "-std=c++17", "-fno-exceptions")}
EQUAL, ROUNDS, SLOT = 1e-12, 21, 2e-3


class Differs(Exception):
    """A tool's numbers are not those of NumPy."""


@dataclass
class Task:
    """One function of one tool: its name in C, its source, further sources that it calls, and what was measured."""

    tool: str
    kind: str
    name: str
    problem: Problem
    text: str
    suffix: str
    sources: Sequence[Path] = ()
    include: Sequence[Path] = ()
    apart: float = np.nan
    ns: dict[str, float] = field(default_factory=dict)  # by flags
    instructions: dict[str, int] = field(default_factory=dict)
    text_bytes: int | None = None


def run(command: Sequence[object]) -> bytes:
    """Standard output.  Raises RuntimeError with the first line of what went wrong."""
    done = subprocess.run([str(word) for word in command], capture_output=True, check=False)
    if done.returncode != 0:
        lines = done.stderr.decode(errors="replace").splitlines() or [f"ended with {done.returncode}"]
        raise RuntimeError(f"{command[0]}: {next((line for line in lines if 'error' in line), lines[0])}")
    return done.stdout


def compiled(task: Task, flags: Sequence[str], folder: Path, prefix: str = "") -> list[Path]:
    """The objects of a task, from the cache if they are there.  prefix: of the compiler's name."""
    headers = (
        "".join(path.read_text() for top in task.include for path in sorted(top.glob("*.h"))) if task.sources else ""
    )
    objects = []
    for text, suffix in ((task.text, task.suffix), *((path.read_text(), "c") for path in task.sources)):
        command = [*LANGUAGES[suffix], *flags, "-fPIC", *(f"-I{path}" for path in task.include)]
        command[0] = prefix + command[0]
        if prefix:
            command.remove("-fPIC")
        key = hashlib.sha256("\0".join([text, headers, *command]).encode()).hexdigest()[:24]
        out, source, aside = (folder / f"{key}.{end}" for end in ("o", suffix, "part"))
        if not out.exists():
            source.write_text(text)
            run([*command, "-c", source, "-o", aside])
            aside.rename(out)
        objects.append(out)
    return objects


def built(
    tasks: Sequence[Task], flags: Sequence[str], folder: Path, prefix: str = ""
) -> tuple[dict[str, list[Path]], dict[str, str]]:
    """Task -> objects; and tool -> why it does not compile."""
    folder.mkdir(parents=True, exist_ok=True)
    for first in {tuple(task.sources): task for task in tasks if task.sources}.values():
        compiled(first, flags, folder, prefix)  # what tasks share is made once, before the pool
    objects, failed = {}, {}
    with ThreadPoolExecutor(2) as pool:
        futures = {task.name: pool.submit(compiled, task, flags, folder, prefix) for task in tasks}
    for task in tasks:
        try:
            objects[task.name] = futures[task.name].result()
        except RuntimeError as error:
            if task.tool.startswith("Boresight"):
                raise
            failed[task.tool] = str(error).split("error: ")[-1]
    return objects, failed


def driver(folder: Path, callgrind: bool) -> Path:
    out, source = folder / ("counted" if callgrind else "drive"), Path(__file__).with_name("drive.c")
    flags = ["-Wall", "-Wextra", "-Werror", "-O2", *(["-DCALLGRIND"] if callgrind else [])]
    run([*C, *flags, source, "-ldl", "-o", out])
    return out


def measure(tasks: list[Task], label: str, folder: Path, rounds: int = ROUNDS) -> dict[str, str]:
    """Check, then time and count every task of one problem under one set of flags.  Returns tool -> why it is missing.

    Raises Differs before anything is timed.
    """
    folder = (folder / "objects").resolve()
    objects, missing = built(tasks, HOSTS[label], folder)
    tasks = [task for task in tasks if task.name in objects]
    p, shared = tasks[0].problem, folder / "all.so"
    run(["g++", "-shared", *dict.fromkeys(path for task in tasks for path in objects[task.name]), "-lm", "-o", shared])
    given, names = numbers(p), [task.name for task in tasks]
    widest = max(p.n**2, max(p.writes(task.kind) for task in tasks))
    head = [given["v"].size, given["P"].size, widest, 0]
    np.concatenate([head, given["v"], given["P"], given["Q"]]).tofile(folder / "numbers")
    call = [driver(folder, False), shared, folder / "numbers"]
    hold(tasks, np.frombuffer(run([*call, "check", 1, 0, *names])).reshape(len(tasks), widest), given)
    for task, ns in zip(tasks, medians(run([*call, "time", rounds, SLOT, *names]).decode()), strict=True):
        task.ns[label] = ns
    if shutil.which("valgrind"):
        counts = folder / "counts"
        shutil.rmtree(counts, ignore_errors=True)
        counts.mkdir()
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={counts}/out", driver(folder, True)]
        run([*command, shared, folder / "numbers", "count", 1, 0, *names])
        found = instructions([path.read_text() for path in counts.iterdir()])
        for task in tasks:
            task.instructions[label] = found[task.name]
    return missing


def hold(tasks: Sequence[Task], out: np.ndarray, given: Mapping[str, np.ndarray]) -> None:
    """Every task's numbers against those of NumPy.  Raises Differs."""
    for task, row in zip(tasks, out, strict=True):
        wanted = reference(task.problem, task.kind, given)
        task.apart = apart(task.problem, task.kind, row[: wanted.size], wanted)
        if not task.apart <= EQUAL:
            raise Differs(f"{task.tool}, {task.kind}: {task.apart:.1e} from NumPy, where {EQUAL:.0e} is allowed")


def medians(text: str) -> list[float]:
    """Of the driver's lines, one a round."""
    rounds = [[float(word) for word in line.split()] for line in text.splitlines()]
    return [median(column) for column in zip(*rounds, strict=True)]


def instructions(dumps: Sequence[str]) -> dict[str, int]:
    """Name -> instructions, of the files that callgrind leaves."""
    found = {}
    for text in dumps:
        name = re.search(r"^desc: Trigger: Client Request: (\S+)$", text, re.MULTILINE)
        total = re.search(r"^(?:totals|summary): (\d+)", text, re.MULTILINE)
        if name and total:
            found[name[1]] = int(total[1])
    return found


def sizes(tasks: Sequence[Task], folder: Path) -> str:
    """Bytes of code and tables on a Cortex-M7 without the C library's own.  Returns why there are none, or nothing."""
    prefix, folder = "arm-none-eabi-", (folder / "objects").resolve()
    if not shutil.which(f"{prefix}gcc"):
        return f"{prefix}gcc is not installed"
    objects, failed = built(tasks, M7, folder, prefix)
    for task in tasks:
        if task.name in objects:
            link = [f"{prefix}gcc", *M7, "-nostdlib", "-Wl,--gc-sections", "-Wl,--unresolved-symbols=ignore-all"]
            out = folder / "m7.elf"
            run([*link, f"-Wl,-e,{task.name}", *objects[task.name], "-o", out])
            task.text_bytes = text_of(run([f"{prefix}size", out]).decode())
    return "; ".join(f"{tool}: {why}" for tool, why in failed.items())


def text_of(table: str) -> int:
    """The first number below `text` of what `size` prints."""
    return int(table.splitlines()[1].split()[0])


def clock(folder: Path) -> float:
    """GHz at which additions that wait for one another run, or nan where the driver cannot say."""
    return float(run([driver((folder / "objects").resolve(), False), "clock"]) or "nan")


def limit(p: Problem, kind: str, done: Mapping[str, int], lanes: int, ghz: float) -> float:
    """ns below which no order of the operations gets: two multiplications, two additions, two loads or one store of
    `lanes` numbers a cycle, without fused operations, whichever takes longest."""
    read: Any = {"F": 0, "updates, plain": 1, "updates, Joseph": 1, "propagate": 1}.get(kind, 2) * len(p.upper)
    wanted = (done["multiply"] / 2, done.get("add", 0) / 2, read / 2, p.writes(kind))
    return max(wanted) / lanes / ghz
