"""Each example from its model to a verified, flown and exported filter, as `boresight new` begins one."""

import os
import re
import runpy
import subprocess
from collections.abc import Collection
from contextlib import chdir, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any

from boresight.codegen.export import export
from boresight.codegen.generate import generate
from boresight.codegen.verify import counted, verify_all
from boresight.evidence.sources import Examples

NAMES = ("pendulum", "vertical", "radar", "gnss_ins", "gnss_ins_21", "autopilot")


def examples(of: Examples, out: Path, names: Collection[str] = NAMES) -> dict[str, dict[str, Any]]:
    """By example, of these: what `verify` counts, NEES at a third and at the end, NIS by measurement, self-tests."""
    return {name: walked(of.place, name, out) for name in names}


def walked(place: Path, name: str, out: Path) -> dict[str, Any]:
    target, folder = f"{place / name}.py:{name.upper()}", out / "generated" / name
    generate(target, folder)
    checks = verify_all([(target, folder)])
    with chdir(out), redirect_stdout(StringIO()):
        judged = runpy.run_path(str(place / f"fly_{name}.py"), run_name="__main__")["judged"]
    export(target, out / name, "double", folder)
    made = subprocess.run(["make", "-s", "-C", out / name, "test"], capture_output=True, text=True, check=True)
    runs, n = judged.errors.shape[1:]
    return {
        "verify": counted(checks),
        "nees": [round(float(judged.nees[at]), 6) for at in (len(judged.nees) // 3, -1)],
        "runs": runs,
        "states": n,
        "nis": {key: [round(part, 6) for part in judged.nis_sum(key)] for key in judged.measurements},
        "figure": os.path.getsize(out / f"{name}.png") > 0,
        "self-tests": re.search(r"(\d+) passed, 0 failed", made.stdout) is not None,
    }
