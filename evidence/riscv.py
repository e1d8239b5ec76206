"""The shipped golden vectors on an emulated 32-bit RISC-V: warnings, verdicts, bits."""

from pathlib import Path
from typing import Any

from boresight.evidence.golden import note
from boresight.evidence.machine import Machine
from boresight.evidence.sources import Folder
from boresight.evidence.targets import GCC, PRECISIONS, RV32, build, run_on_host


def riscv(folder: Folder, out: Path) -> dict[str, dict[str, Any]]:
    """By unit: `builds`, as golden has them."""
    found: dict[str, dict[str, Any]] = {unit.name: {"builds": {}} for unit in folder.units}
    for precision in PRECISIONS:
        here = run_on_host(build(folder, GCC, precision, out))
        made = build(folder, RV32, precision, out)
        note(found, f"riscv32 {precision}", Machine(made, made.image).run_tests(), here)
    return found
