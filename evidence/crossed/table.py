"""The table of docs/cross-checks.md, from the committed results."""

import textwrap
from collections import Counter
from pathlib import Path
from typing import Any

from boresight.evidence import results
from boresight.evidence.crossed import PEERS
from boresight.evidence.crossed.judge import NEITHER, OURS, ROUNDING, THEIRS, Check, verdict
from boresight.evidence.sources import CrossChecks

PAGE = Path(__file__).resolve().parents[2] / "docs" / "cross-checks.md"
BEGIN, END = "<!-- from here on written by make cross-checks -->\n", "<!-- to here -->\n"
HEAD = ("what", "ours", "ours - peer", "ours - 50 digits", "peer - 50 digits", "rounding allows", "who is right")


def page(text: str) -> str:
    """The page with its tables made anew."""
    before, rest = text.split(BEGIN)
    return before + BEGIN + tables() + END + rest.split(END)[1]


def tables() -> str:
    kept = results.read(CrossChecks())
    judged = Counter(verdict(found) for peer in PEERS for found in kept.get(peer.name, {"units": {}})["units"].values())
    shares = ", ".join(f"{who} {judged[who]}" for who in (ROUNDING, OURS, THEIRS, NEITHER))
    parts = [wrapped(f"Of {judged.total()} questions to {len(PEERS)} tools, who is right: {shares}.")]
    for peer in PEERS:
        of = kept.get(peer.name, {"units": {}, "tools": "not made"})
        rows = [row(check, of["units"].get(check.name)) for check in peer.checks]
        lines = [HEAD, ("---",) * len(HEAD), *rows]
        why: dict[str, list[str]] = {}
        for check in peer.checks:
            why.setdefault(check.why, []).append(check.name)
        reasons = [wrapped(f"- {'; '.join(names).capitalize()}: {reason}.") for reason, names in why.items() if reason]
        table = "\n".join(f"| {' | '.join(line)} |" for line in lines)
        parts.append(f"\n## {of['tools']}\n\n{table}\n" + f"\n{''.join(reasons)}" * bool(reasons))
    return "".join(parts) + "\n"


def wrapped(line: str) -> str:
    return textwrap.fill(line, 100, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False) + "\n"


def row(check: Check, found: dict[str, Any] | None) -> tuple[str, ...]:
    if found is None:
        return check.name, *"-" * (len(HEAD) - 1)
    sizes = (f"`{found[key]:.1e}`" for key in ("apart", "ours", "peer", "allowed"))
    unit = f", {check.unit}" * (check.unit != "1")
    return check.name + unit, f"`{found['number']:.17g}`", *sizes, verdict(found)
