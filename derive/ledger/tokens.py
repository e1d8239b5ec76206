"""The tokens of LaTeX, for who reads a formula and for who writes MathML of one."""

import re
from collections.abc import Iterable

TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\d+|\s+|.", re.DOTALL)
COMMAND = re.compile(r"\\[A-Za-z]+")


def tokens(latex: str) -> list[str]:
    """Commands, numbers and characters; spaces, which only set them apart, left out."""
    return [token for token in TOKEN.findall(latex) if not token.isspace()]


def joined(parts: Iterable[str]) -> str:
    """The tokens as one text, with a space where a letter follows a command: \\sin h is not \\sinh."""
    text, after = "", False
    for part in parts:
        text += " " + part if after and part[0].isalpha() else part
        after = COMMAND.fullmatch(part) is not None
    return text
