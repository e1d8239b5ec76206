"""What the filter costs on a Cortex-M4F in float: instructions, counted while the shipped self-test runs, and text.

python -m benchmarks.instructions [generated/azimuth_hold [-Os [-DBORESIGHT_UD=0]]]
"""

import sys
import tempfile
from pathlib import Path

from elftools.elf.elffile import ELFFile

from boresight.evidence.machine import Machine
from boresight.evidence.sources import Folder
from boresight.evidence.targets import M4F, Build, build
from boresight.runtime.compiler import run

WATCHED = ("discretize", "joseph_predict", "ud_predict", "predict_state", "joseph_update", "ud_update", "ud_add",
           "filter_propagate", "F_nz", "Qc_nz")  # fmt: skip
FLOWN = ("init", "propagate", "measure_zupt", "measure_azimuth", "correct")


def main(path: str = "generated/azimuth_hold", *flags: str) -> None:
    """Least and most of each function with what it calls; the most is that of a covariance with every correlation.

    Of the filter's functions those calls count that answer BS_OK.
    """
    folder = Folder(Path(path).resolve())
    prefix, flags = folder.manifest["c_prefix"], flags or ("-Os",)
    ending = "_f32_joseph" if "-DBORESIGHT_UD=0" in flags else "_f32"
    names = tuple(f"{prefix}_{name}{ending if name.startswith('filter') else '_f32'}" for name in WATCHED)
    with tempfile.TemporaryDirectory() as out:
        made = build(folder, M4F, "float", Path(out), *flags, "-ffunction-sections", "-fdata-sections")
        machine = Machine(made, made.image, names, tuple(name for name in names if "filter" in name))
        machine.run_tests([f"{prefix}_covariance", f"{prefix}_filter"])
        functions = [f"{prefix}_filter_{name}{ending}" for name in FLOWN]
        text = linked(made, [name for name in functions if name in machine.symbols])
    print(f"{folder.name}, {' '.join(flags)}: {'least':>8} {'most':>8} {'stack, B':>9}")
    for name, cost in sorted(machine.costs.items()):
        print(f"{name:28} {cost.least:8} {cost.most:8} {cost.stack:9}")
    print(f"text of {', '.join(FLOWN)}: {text} B; sines, and what is the compiler's, apart")


def linked(made: Build, functions: list[str]) -> int:
    """Bytes of code and constants of these functions and of all that they call in the folder."""
    objects = [path for unit, path in made.objects.items() if not unit.endswith("_math")]
    image = made.image.with_name("flown.elf")
    kept = [f"-Wl,-e,{functions[0]}", *(f"-Wl,-u,{name}" for name in functions)]
    link = ["-nostdlib", "-Wl,--gc-sections", "-Wl,--unresolved-symbols=ignore-all", *kept]
    run([made.target.compiler, *made.target.flags, *link, *objects, "-o", image])
    with image.open("rb") as file:
        sections = ELFFile(file).iter_sections()
        return sum(s["sh_size"] for s in sections if s.name.startswith((".text", ".rodata")))


if __name__ == "__main__":
    main(*sys.argv[1:])
