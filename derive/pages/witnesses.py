"""The reference of the witnesses for papers of one's own, made from the scenarios.

python -m boresight.derive.pages.witnesses > docs/reference/witnesses.md
"""

import textwrap
from dataclasses import fields
from typing import Any

from boresight.derive.papers.scenarios import SCENARIOS, Scenario
from boresight.derive.papers.values import FUNCTIONS, TIMES

HEAD = """# Reference: the witnesses for a paper of your own

A witness gives every letter of a paper a number that follows from exact mechanics, in 60 digits.
`witness = "..."` in `paper.toml` chooses one; `value = "..."` binds a letter to one of its names,
or to what is made of them. [Your paper](../your-paper.md) shows how.

Values are joined by `+ - * / **`; `*` of two quaternions is Hamilton's product, and `v[0]`,
`P[0, 1]` and `x[0:3]` are parts, counted from 0. The functions are
FUNCTIONS.
Of a witness with time, `rate(x)` is the rate of change of x. In `motion`, `old(x)` is x before the
delay, and `after(x)` and `before(x)` are x a step later and earlier: of names marked with * alone.

This page is made from the sources; `python -m boresight.derive.pages.witnesses` prints it.
"""


def size_text(size: Any) -> str:
    return ", ".join(f"{one:g}" for one in size) if isinstance(size, tuple) else f"{size:g}"


def section(scenario: Scenario) -> str:
    exact = {name: f"`{name}`" + "*" * (name in scenario.exact) for name in scenario.names}
    rows = [f"| {exact[name]} | {one.unit} | {one.meaning} |" for name, one in scenario.names.items()]
    table = ["| name | unit | what it is |", "|---|---|---|", *rows]
    sizes = [
        f"| `{part.name}` | {scenario.units[part.name]} | {size_text(getattr(scenario.usual, part.name))} | "
        f"{'small' * (part.name in scenario.errors)} |"
        for part in fields(scenario.usual)
    ]
    head = ["", "Sizes, which `[sizes]` of `paper.toml` may change, and the parts that are small:", ""]
    parts = [*head, "| part | unit | size | |", "|---|---|---|---|", *sizes] if scenario.errors else []
    return "\n".join([f"## `{scenario.name}`", "", *table, *parts, ""])


def page() -> str:
    names = ", ".join(f"`{name}`" for name in sorted({*FUNCTIONS} - {*TIMES}))
    functions = textwrap.fill(names, 99, break_long_words=False)
    head = HEAD.replace("FUNCTIONS", functions)
    return "\n".join([head, *(section(scenario) for scenario in SCENARIOS.values())])


if __name__ == "__main__":
    print(page(), end="")
