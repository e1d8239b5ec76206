"""Abbreviations of LaTeX: the table [macros] of derivation.toml, used as \\name or, with arguments, \\name{a}{b}."""

import re
from collections.abc import Mapping

USE = re.compile(r"\\([A-Za-z]+)")
ARGUMENT = re.compile(r"#(\d)")


def expanded(latex: str, macros: Mapping[str, str]) -> str:
    """Each macro in its place; raises ValueError if an argument of one is missing."""
    found, at = "", 0
    while macros and (use := USE.search(latex, at)):
        found, at, body = found + latex[at : use.start()], use.end(), macros.get(use[1])
        if body is None:
            found += use[0]
            continue
        given = []
        for _ in range(max((int(number) for number in ARGUMENT.findall(body)), default=0)):
            argument, at = group(latex, at)
            given.append(expanded(argument, macros))
        for n, argument in enumerate(given, 1):
            body = body.replace(f"#{n}", argument)
        found += body
    return found + latex[at:]


def group(latex: str, at: int) -> tuple[str, int]:
    """What stands in the braces that begin at a place, and where they end."""
    depth = 0
    for end in range(at, len(latex)):
        depth += (latex[end] == "{") - (latex[end] == "}")
        if depth == 0:
            break
    if depth or latex[at : at + 1] != "{":
        raise ValueError(f"{latex[:at]!r} wants an argument in braces after it")
    return latex[at + 1 : end], end + 1
