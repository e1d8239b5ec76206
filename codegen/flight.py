"""What the self-test of a live loop flies, by its SHA-256: found where it is exported, and held to on a target."""

import re
from collections.abc import Iterable
from pathlib import Path

FLOWN = re.compile(r"_live: flown ([0-9a-f]{64})$", re.MULTILINE)  # as the self-test prints it
KNOWN = "known[2][16] = { { 0U }, { 0U } };"


def flies(test: Path) -> bool:
    """Whether this file of a self-test does, and does not know yet what comes of it."""
    return test.is_file() and KNOWN in test.read_text()


def from_words(words: Iterable[float]) -> str:
    """The SHA-256 of the 16 numbers that the self-test compares."""
    return "".join(f"{int(word):04x}" for word in words)


def with_flight(text: str, flown: dict[str, str]) -> str:
    """The self-test with what comes of its flight, by precision."""
    words = [re.findall("....", flown[one]) if one in flown else ["0"] for one in ("double", "float")]
    rows = ", ".join(f"{{ {', '.join(f'0x{word}U' if flown else '0U' for word in of)} }}" for of in words)
    return text.replace(KNOWN, f"known[2][16] = {{ {rows} }};")
