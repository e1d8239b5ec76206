"""Fly a few seconds on an emulated core, call by call, and count the instructions of each: what the loop costs.

python ticks.py FILTER

FILTER is an exported folder; in double it is flown on a Cortex-M7, in single precision on a Cortex-M4F.
"""

import sys
import tempfile
from collections import defaultdict
from pathlib import Path

import numpy as np
from make_recording import SLAVE, Setup, record

from boresight.codegen.folder import Folder
from boresight.evidence.machine import Cost, Machine
from boresight.evidence.targets import M4F, M7, OPTIMISED, WARNINGS, Build, Target, symbol_table, text_size
from boresight.runtime.compiler import run

HERE = Path(__file__).parent
CALLED = ("tick_take", "tick_background", "tick_output", "tick_end")
LOOP = tuple(f"va_live_{name}" for name in ("sample", "message", "background", "output"))
PROPAGATE = "va_filter_propagate"
MEASURE = {"va_filter_measure_velocity": "velocity", "va_filter_measure_dcm": "attitude"}
STAGES = (  # of a measurement, by `stage` before a call
    *("its start", "errors of H", "second order of the delay", "the filter"),
    *("states left alone", "its turn", "its correction"),
)
STEP, PIECE = "step of the covariance", "measurement: "
WANTED = {"sample": 2600, STEP: 32_000} | {PIECE + stage: 45_000 for stage in STAGES}  # on the M4F
SECONDS = 3.0  # in which all happens that happens in the minute


def compiled(target: Target, filter_folder: Path, out: Path) -> Path:
    """The flight, ticks.c and the filter as an image of a core; a warning is an error."""
    image = out / f"{target.name}.elf"
    kept = [*(f"-Wl,-u,{name}" for name in CALLED), "-Wl,-e,tick_take", "-Wl,--gc-sections", "-Wl,--no-warnings"]
    sources = [HERE / "main.c", HERE / "report.c", HERE / "ticks.c", *sorted((filter_folder / "src").glob("*.c"))]
    compiler = [target.compiler, *WARNINGS, *target.flags, *OPTIMISED, "-I", filter_folder / "include"]
    run([*compiler, *target.link, *kept, *sources, "-lm", "-o", image])
    run([*compiler, "-c", filter_folder / "src" / "va_live.c", "-o", image.with_suffix(".o")])
    return image


class Core:
    """An emulated core that flies.  cost: of each kind of call its instructions.  stack: bytes, the deepest.
    flash, ram: bytes of va_live.c and of va_live."""

    def __init__(self, target: Target, image: Path, filter_folder: Path, setup: Setup):
        made = Build(Folder(filter_folder), target, "", {}, image)
        names = [name + suffix for name in (*LOOP, PROPAGATE, *MEASURE) for suffix in ("", "_f32")]
        self.machine = Machine(made, image, watched=tuple(names))
        self.cost: dict[str, list[int]] = defaultdict(list)
        self.stack: dict[str, int] = defaultdict(int)
        self.whole, self.measured = 0, ""
        self.sums: dict[str, list[int]] = defaultdict(list)  # of the pieces of each measurement
        self.flash = text_size(image.with_suffix(".o"))
        self.ram = next(s["st_size"] for s in symbol_table(image) if s.name == "aboard")
        self.put("head", setup.doubles())

    def put(self, name: str, values: np.ndarray) -> None:
        self.machine.core.mem_write(self.machine.symbols[name], values.astype("<f8").tobytes())

    def call(self, name: str) -> int:
        status = self.machine.call(name)
        costs = {name.removesuffix("_f32"): cost for name, cost in self.machine.costs.items()}
        self.machine.costs.clear()
        for called in costs.keys() & LOOP:
            kind = called.removeprefix("va_live_")
            if kind == "background":
                kind = self.piece(costs)
            self.cost[kind].append(costs[called].most)
            self.stack[kind] = max(self.stack[kind], costs[called].stack)
        return status

    def piece(self, costs: dict[str, Cost]) -> str:
        """What a call of the background has done; the sum of a measurement behind its last piece."""
        before, behind = self.machine.read("tick_stage", np.uint8, 2)
        if not before and not behind:
            return STEP if PROPAGATE in costs else "background, other"
        self.whole += costs["va_live_background"].most
        self.measured = next((MEASURE[name] for name in costs if name in MEASURE), self.measured)
        if not behind:
            self.sums[f"{self.measured}, all pieces"].append(self.whole)
            self.whole = 0
        return PIECE + STAGES[before]

    def take(self, one: np.ndarray) -> None:
        self.put("tick_record", one)
        self.call("tick_take")
        if one[0] == SLAVE:
            self.call("tick_output")
            while self.call("tick_background") == 0:
                pass

    def digest(self) -> str:
        self.call("tick_end")
        return self.machine.read("tick_digest", np.uint8, 32).tobytes().hex()


def flown(target: Target, filter_folder: Path, out: Path, seconds: float = SECONDS) -> Core:
    setup, records, _ = record(seconds=seconds)
    core = Core(target, compiled(target, filter_folder, out), filter_folder, setup)
    for one in records:
        core.take(one)
    return core


def table(core: Core) -> list[str]:
    """Rows of the README: the call, what is wanted, instructions in the mean and at worst, bytes of stack."""
    return [
        f"| {kind} | {WANTED.get(kind, '')} | {np.mean(cost):.0f} | {max(cost)} | {core.stack.get(kind, '')} |"
        for kind, cost in (core.cost | core.sums).items()
    ] + [f"| bytes of code | 12288 | | {core.flash} | |", f"| bytes of `va_live` | 14336 | | {core.ram} | |"]


def main(filter_folder: Path) -> None:
    in_float = "#define BORESIGHT_FLOAT" in (filter_folder / "include" / "boresight_precision.h").read_text()
    target = M4F if in_float else M7
    with tempfile.TemporaryDirectory() as out:
        print(target.name, *table(flown(target, filter_folder, Path(out))), sep="\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python ticks.py FILTER")
    main(Path(sys.argv[1]))
