"""The shipped golden vectors on an emulated 32-bit RISC-V: warnings, verdicts, bits."""

from collections.abc import Collection
from pathlib import Path
from typing import Any

from boresight.codegen.folder import Folder
from boresight.evidence.golden import note
from boresight.evidence.machine import Machine
from boresight.evidence.targets import GCC, PRECISIONS, RV32, build, run_on_host


def riscv(folder: Folder, out: Path, names: Collection[str] | None = None) -> dict[str, dict[str, Any]]:
    """By unit: `builds`, as golden has them."""
    found: dict[str, dict[str, Any]] = {unit.name: {"builds": {}} for unit in folder.chosen(names)}
    for precision in PRECISIONS:
        here = run_on_host(build(folder, GCC, precision, out), found)
        made = build(folder, RV32, precision, out)
        note(found, f"riscv32 {precision}", Machine(made, made.image).run_tests(found), here)
    return found
