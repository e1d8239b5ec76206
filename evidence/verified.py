"""What `boresight verify` finds of each model: the C against CasADi's and 50 digits, the model against mechanics."""

import hashlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from boresight.codegen.folder import Folder
from boresight.codegen.generate import source_of
from boresight.codegen.mechanics import MechanicsCheck
from boresight.codegen.stamp import PACKAGE, hashed, reached
from boresight.codegen.verify import Check, FirstOrderCheck, UnitCheck, verify

OF = {UnitCheck: "bits and 50 digits", FirstOrderCheck: "first order"}


def verified(folder: Folder, out: Path) -> dict[str, dict[str, Any]]:
    """By function: what was checked, and of each whether it holds; of what is not checked why."""
    return by_unit(verify(folder.target))


def by_unit(checks: Sequence[Check]) -> dict[str, dict[str, Any]]:
    found: dict[str, dict[str, Any]] = {}
    for check in checks:
        against = check.against if isinstance(check, MechanicsCheck) else OF[type(check)]
        of = found.setdefault(check.unit, {"checks": {}})
        why = (check.unheld or check.why) if isinstance(check, MechanicsCheck) else ""
        of["checks"][against] = why or check.ok
        if isinstance(check, UnitCheck):
            of |= {"points": check.points, "outputs": check.outputs}
    return found


def made_of(folder: Folder) -> dict[str, str]:
    """One hash: of the model and of what verifies it, as Python, and of the C."""
    model = source_of(folder.target)
    assert model, f"{folder.name} is of no model"
    python = hashed(reached({model.resolve(), (PACKAGE / "codegen" / "verify.py").resolve()}))
    return {folder.name: hashlib.sha256(f"{python}\n{folder.code}".encode()).hexdigest()}
