"""MISRA C:2012 by cppcheck's add-on over the whole folder, because some rules look at all files at once."""

import re
import shutil
from pathlib import Path
from typing import Any

from boresight.codegen.folder import Folder
from boresight.runtime.compiler import run

MISSING = "" if shutil.which("cppcheck") else "cppcheck is not installed"
FINDING = re.compile(r"^misra-c2012-(\S+) (\S+)$")


def version() -> str:
    return run(["cppcheck", "--version"]).strip()


def misra(folder: Folder, out: Path) -> dict[str, dict[str, Any]]:
    """By unit, and for the headers under `include`: how often each rule is broken, the deviated ones too."""
    place = out / "findings"
    # rows are for hosts
    command = [
        "cppcheck",
        "--addon=misra",
        "--quiet",
        "--force",
        "-UBORESIGHT_ROWS",
        f"--output-file={place}",
        "--template={id} {file}",
    ]
    run([*command, "-I", folder.include, *folder.files("src/*.c")], cwd=out)
    found: dict[str, dict[str, Any]] = {unit.name: {"rules": {}} for unit in folder.units} | {"include": {"rules": {}}}
    for line in place.read_text().splitlines():
        match = FINDING.match(line)
        if match:
            name = Path(match[2]).stem.removesuffix("_kernel")
            rules = found[name if name in found else "include"]["rules"]
            rules[match[1]] = rules.get(match[1], 0) + 1
    return found
