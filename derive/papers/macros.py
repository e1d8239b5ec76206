r"""Abbreviations of LaTeX: \newcommand and \def of printed.tex, and tables [macros], used as \name or, with arguments,
\name{a}{b}."""

import re
from collections.abc import Mapping

USE = re.compile(r"\\([A-Za-z]+)")
ARGUMENT = re.compile(r"#(\d)")
BRACES = r"\{((?:[^{}]|\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\})*)\}"  # to a depth of four
DECLARED = re.compile(
    r"\\(?:new|renew|provide)command\*?\s*(?:\{\s*\\([A-Za-z]+)\s*\}|\\([A-Za-z]+))\s*(?:\[\d\])?\s*" + BRACES
    + r"|\\def\s*\\([A-Za-z]+)\s*(?:#\d)*\s*" + BRACES
    + r"|\\DeclareMathOperator\*?\s*\{?\s*\\([A-Za-z]+)\s*\}?\s*" + BRACES
)  # fmt: skip


def declared(text: str) -> dict[str, str]:
    """What a LaTeX file defines, by name; in each those before it are in their places.  Raises ValueError."""
    found: dict[str, str] = {}
    for one in DECLARED.finditer(re.sub(r"(?<!\\)%.*", "", text)):
        name = one[1] or one[2] or one[4] or one[6]
        body = one[3] or one[5] or rf"\operatorname{{{one[7]}}}"
        if name in USE.findall(body):
            raise ValueError(f"\\{name} stands in its own meaning")
        found[name] = expanded(body, found)
    return found


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
