"""What the filter costs on a Cortex-M4F in float: instructions, loads and stores, counted while the shipped self-test
runs, and text.

python -m benchmarks.instructions [generated/azimuth_hold | examples/autopilot.py:AUTOPILOT [-Os [-DBORESIGHT_UD=0]]]
"""

import sys
import tempfile
from pathlib import Path

from elftools.elf.elffile import ELFFile

from boresight.codegen.folder import Folder
from boresight.codegen.generate import generate
from boresight.evidence.machine import Machine
from boresight.evidence.targets import M4F, Build, build
from boresight.runtime.compiler import run

WATCHED = ("discretize", "joseph_predict", "ud_predict", "predict_state", "joseph_update", "ud_update", "ud_add",
           "filter_propagate", "F_nz", "Qc_nz")  # fmt: skip
MEASURED = ("zupt", "azimuth", "mag", "flow", "airspeed", "sideslip")  # of those that a model has
FLOWN = ("init", "propagate", *(f"measure_{name}" for name in MEASURED), "correct")


def main(path: str = "generated/azimuth_hold", *flags: str) -> None:
    """Least and most of each function with what it calls; the most is that of a covariance with every correlation.

    Of the filter's functions those calls count that answer BS_OK.
    """
    if ":" in path:
        with tempfile.TemporaryDirectory() as aside:
            generate(path, aside)
            return main(aside, *flags)
    folder = Folder(Path(path).resolve())
    prefix, flags = folder.manifest["c_prefix"], flags or ("-Os",)
    ending = "_f32_joseph" if "-DBORESIGHT_UD=0" in flags else "_f32"
    names = tuple(f"{prefix}_{name}{ending if name.startswith('filter') else '_f32'}" for name in WATCHED)
    with tempfile.TemporaryDirectory() as out:
        made = build(folder, M4F, "float", Path(out), *flags, "-ffunction-sections", "-fdata-sections")
        machine = Machine(made, made.image, names, tuple(name for name in names if "filter" in name))
        machine.run_tests([f"{prefix}_covariance", f"{prefix}_filter"])
        flown = [name for name in FLOWN if f"{prefix}_filter_{name}{ending}" in machine.symbols]
        text = linked(made, [f"{prefix}_filter_{name}{ending}" for name in flown])
    title = f"{folder.manifest['model']}, {' '.join(flags)}:"
    print(f"{title:30} {'least':>8} {'most':>8} {'loads':>8} {'stores':>8} {'stack, B':>9}")
    for name, cost in sorted(machine.costs.items()):
        print(f"{name:30} {cost.least:8} {cost.most:8} {cost.loads:8} {cost.stores:8} {cost.stack:9}")
    print(f"text of {', '.join(flown)}: {text} B; sines, and what is the compiler's, apart")


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
