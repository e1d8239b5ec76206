"""MISRA C:2012 by cppcheck's add-on over the whole folder, because some rules look at all files at once."""

import re
import shutil
from pathlib import Path
from typing import Any

from boresight.evidence.sources import Folder
from boresight.runtime.compiler import run

MISSING = "" if shutil.which("cppcheck") else "cppcheck is not installed"
FINDING = re.compile(r"^misra-c2012-(\S+) (\S+)$")

# Rules that the C deviates from on purpose, each with its reason.
DEVIATED = {
    "15.5": "a guard returns at once: what follows may rely on it, and an output is written by no later line",
    "20.10": "BS_REAL joins a literal and its suffix: the one way to print it once for both precisions",
    "5.5": "in float a macro gives each function the ending _f32, so that both precisions link into one program",
    "2.5": "the headers offer the same macros to every model, and the indices of all states; no folder uses all",
}

# Rules that are broken and should not be: what the table counts.
OPEN = {
    "5.9": "static helpers of two files may have one name: each file is read by itself",
    "10.3": "boresight_math.h keeps a comparison's truth in an int",
    "10.4": "boresight_math.h compares a truth value with a comparison",
    "10.8": "boresight_math.h turns a computed whole number into another type where its range is known",
    "12.1": "a condition of two comparisons, or a chosen value, stands without further parentheses",
    "14.1": "a copy is skipped where its source is its target, by a second condition of the loop",
    "14.4": "boresight_math.h asks an int that holds a truth value",
}


def version() -> str:
    return run(["cppcheck", "--version"]).strip()


def misra(folder: Folder, out: Path) -> dict[str, dict[str, Any]]:
    """By unit, and for the headers under `include`: how often each rule is broken, the deviated ones too."""
    place = out / "findings"
    options = ["--quiet", "-UBORESIGHT_ROWS", f"--output-file={place}", "--template={id} {file}"]  # rows are for hosts
    command = ["cppcheck", "--addon=misra", *options]
    run([*command, "-I", folder.include, *folder.files("src/*.c")], cwd=out)
    found: dict[str, dict[str, Any]] = {unit.name: {"rules": {}} for unit in folder.units} | {"include": {"rules": {}}}
    for line in place.read_text().splitlines():
        match = FINDING.match(line)
        if match:
            name = Path(match[2]).stem.removesuffix("_kernel")
            rules = found[name if name in found else "include"]["rules"]
            rules[match[1]] = rules.get(match[1], 0) + 1
    return found
