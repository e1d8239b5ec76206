"""MISRA C:2012 by cppcheck's add-on over the whole folder, because some rules look at all files at once."""

import re
import shutil
from pathlib import Path
from typing import Any

from boresight.codegen.deviations import EVERYWHERE
from boresight.codegen.folder import Folder
from boresight.runtime.compiler import run

MISSING = "" if shutil.which("cppcheck") else "cppcheck is not installed"
FINDING = re.compile(r"^misra-c2012-(\S+) (\d+) (.+)$")


def version() -> str:
    return run(["cppcheck", "--version"]).strip()


def misra(folder: Folder, out: Path) -> dict[str, dict[str, Any]]:
    """By unit, and for the headers under `include`: by rule the lines that break it, or how often it is broken where
    the C deviates from it everywhere."""
    place = out / "findings"
    # rows are for hosts
    command = [
        "cppcheck",
        "--addon=misra",
        "--quiet",
        "--force",
        "-UBORESIGHT_ROWS",
        f"--output-file={place}",
        "--template={id} {line} {file}",
    ]
    run([*command, "-I", folder.include, *folder.files("src/*.c")], cwd=out)
    found: dict[str, dict[str, Any]] = {unit.name: {"rules": {}} for unit in folder.units} | {"include": {"rules": {}}}
    for line in place.read_text().splitlines():
        match = FINDING.match(line)
        if match:
            rule, number, file = match[1], int(match[2]), Path(match[3])
            name = file.stem.removesuffix("_kernel")
            rules = found[name if name in found else "include"]["rules"]
            if rule in EVERYWHERE:
                rules[rule] = rules.get(rule, 0) + 1
            else:
                rules.setdefault(rule, []).append(file.read_text().splitlines()[number - 1].strip())
    return found
