"""Fly a recording tick by tick, on this machine and on emulated cores, where every instruction is counted.

python ticks.py FILTER FILE

FILTER is an exported folder; in double it is flown on a Cortex-M7, in single precision on a Cortex-M4F too.
"""

import ctypes
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol

import numpy as np
from make_recording import MASTER, Setup, read

from boresight.evidence.machine import Machine
from boresight.evidence.sources import Folder
from boresight.evidence.targets import M4F, M7, OPTIMISED, WARNINGS, Build, Target
from boresight.runtime.compiler import run

HERE = Path(__file__).parent
CALLED = ("tick_begin", "tick_slave", "tick_master", "tick_report")
NUMBERS = 7  # doubles of flight_line
KINDS = ("strapdown alone", "with the covariance", "with a message")
NOT_READY = 4
COUNTED_S = 5.0  # then the delay is known, and nothing that follows takes another way through the code


class Core(Protocol):
    """What flies: this machine or an emulated one."""

    def put(self, name: str, values: np.ndarray) -> None: ...
    def line(self) -> np.ndarray: ...
    def call(self, name: str) -> tuple[int, int]:
        """(what the function returned, instructions)."""


@dataclass
class Flown:
    """What a flight reported and cost.  lines: (S, 1 + NUMBERS), the second first.  cost, kind: (T,), by tick."""

    lines: np.ndarray
    cost: np.ndarray  # instructions
    kind: np.ndarray  # of KINDS
    statuses: list[tuple[int, int]] = field(default_factory=list)  # (tick, status) where it was not BS_OK


class Here:
    """This machine; it counts nothing."""

    def __init__(self, image: Path):
        self.library = ctypes.CDLL(str(image))

    def put(self, name: str, values: np.ndarray) -> None:
        (ctypes.c_double * len(values)).in_dll(self.library, name)[:] = values.tolist()

    def line(self) -> np.ndarray:
        return np.array((ctypes.c_double * NUMBERS).in_dll(self.library, "tick_line"))

    def call(self, name: str) -> tuple[int, int]:
        return getattr(self.library, name)(), 0


class Emulated:
    """A core of `boresight.evidence`."""

    def __init__(self, target: Target, image: Path, filter_folder: Path):
        made = Build(Folder(filter_folder), target, "", {}, image)
        self.machine = Machine(made, image, watched=("flight_slave", "flight_master"))

    def put(self, name: str, values: np.ndarray) -> None:
        self.machine.core.mem_write(self.machine.symbols[name], values.astype("<f8").tobytes())

    def line(self) -> np.ndarray:
        return self.machine.read("tick_line", np.float64, NUMBERS)

    def call(self, name: str) -> tuple[int, int]:
        before = self.machine.executed
        status = self.machine.call(name)
        return status, self.machine.executed - before

    @property
    def stack(self) -> int:
        return max(self.machine.costs[name].stack for name in ("flight_slave", "flight_master"))


def compiled(target: Target, filter_folder: Path, out: Path) -> Path:
    """flight.c, ticks.c and the filter, as a shared library or as an image of a core; a warning is an error."""
    image = out / f"{target.name}.{'elf' if target.emulated else 'so'}"
    link = [
        *target.link,
        *(f"-Wl,-u,{n}" for n in CALLED),
        "-Wl,-e,tick_begin",
        "-Wl,--gc-sections",
        "-Wl,--no-warnings",
    ]
    sources = [HERE / "flight.c", HERE / "ticks.c", *sorted((filter_folder / "src").glob("*.c"))]
    run([
        *(target.compiler, *WARNINGS, *target.flags, *OPTIMISED, "-I", filter_folder / "include"),
        *(*(link if target.emulated else ["-shared"]), *sources, "-lm", "-o", image),
    ])  # fmt: skip
    return image


def fly(core: Core, setup: Setup, records: np.ndarray) -> Flown:
    core.put("tick_setup", setup.doubles())
    core.call("tick_begin")
    lines, cost, statuses = [], [], []
    messages = np.zeros(len(records), bool)
    per_second, tick = round(1 / setup.dt), 0
    for kind, *values in records:
        if kind == MASTER:
            core.put("tick_message", np.array(values))
            status, spent = core.call("tick_master")
            if cost:
                cost[-1] += spent
                messages[tick - 1] = True
        else:
            core.put("tick_increments", np.array(values[:6]))
            status, spent = core.call("tick_slave")
            cost.append(spent)
            tick += 1
            if tick % per_second == 0 and core.call("tick_report")[0] == 0:
                lines.append([tick // per_second, *core.line()])
        if status not in (0, NOT_READY):
            statuses.append((tick, status))
    spent = np.array(cost)
    alone = ~messages[:tick]
    threshold = (spent[alone].min() + spent[alone].max()) / 2  # the covariance costs several strapdowns
    kind_of = np.where(messages[:tick], 2, np.where(spent > threshold, 1, 0))
    return Flown(np.array(lines), spent, kind_of, statuses)


def first_seconds(setup: Setup, records: np.ndarray, seconds: float = COUNTED_S) -> np.ndarray:
    return records[np.cumsum(records[:, 0] != MASTER) * setup.dt < seconds + setup.dt / 2]


def in_float(filter_folder: Path) -> bool:
    return "#define BORESIGHT_FLOAT" in (filter_folder / "include" / "boresight_precision.h").read_text()


def main(filter_folder: Path, recording: Path) -> None:
    setup, records = read(recording)
    print(f"{'core':12}{'kind of tick':22}{'ticks':>7}{'instructions, most':>20}{'stack, bytes':>14}")
    for target in (M4F, M7) if in_float(filter_folder) else (M7,):
        with tempfile.TemporaryDirectory() as aside:
            core = Emulated(target, compiled(target, filter_folder, Path(aside)), filter_folder)
            flown = fly(core, setup, first_seconds(setup, records))
        for i, name in enumerate(KINDS):
            cost = flown.cost[flown.kind == i]
            stack = str(core.stack) if i == len(KINDS) - 1 else ""
            print(f"{target.name:12}{name:22}{len(cost):7}{cost.max():20}{stack:>14}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: python ticks.py FILTER FILE")
    main(Path(sys.argv[1]), Path(sys.argv[2]))
