"""The live loop in every condition of tests/live, by its C: NEES beside its band, what was refused, what it reports."""

import json
import sys
from pathlib import Path
from typing import Any

from boresight.codegen.stamp import PACKAGE
from boresight.runtime.compiler import run

LIVE, RUNS = PACKAGE / "tests" / "live", 100


def campaign(of: Any, out: Path) -> dict[str, dict[str, Any]]:
    """By condition."""
    kept = out / "flown.json"
    run([sys.executable, str(LIVE / "table.py"), "-r", str(RUNS), "-o", str(kept)], cwd=PACKAGE)
    return dict(json.loads(kept.read_text()))
