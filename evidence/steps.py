"""Every single mutation of every line of a paper's derivations: what refutes it, or why it says the same."""

from collections import Counter
from pathlib import Path
from typing import Any

from boresight.derive.ledger.lines import count_steps
from boresight.derive.ledger.mutation import UNEXPLAINED, line_survivors
from boresight.derive.papers import paper
from boresight.evidence.sources import Derivations


def steps(of: Derivations, out: Path) -> dict[str, dict[str, Any]]:
    """By equation: its steps; how many mutants its lines have, and the survivors by reason; those that have none."""
    one = paper(of.name)
    found: dict[str, dict[str, Any]] = {}
    for equation in one.equations:
        tried, reasons, unexplained = 0, Counter[str](), list[str]()
        for index, step in enumerate(equation.derivation.steps):
            if step.formulas:
                count, survivors = line_survivors(one, equation, index)
                tried += count
                reasons.update(survivor.reason for survivor in survivors)
                unexplained += [f"{s.number}: {s.what}" for s in survivors if s.reason == UNEXPLAINED]
        counted = count_steps([equation])
        found[equation.number] = {
            "steps": counted.steps, "evaluated": counted.evaluated, "prose": counted.prose,
            "tried": tried, "survivors": dict(reasons), "unexplained": unexplained,
        }  # fmt: skip
    return found
