"""The digest of a filter as its templates see it, and the vectors of its self-test."""

import hashlib
from typing import Any

import numpy as np

from boresight.derive.model import Model

# FIPS 180-4's examples of one block and of two, and the empty message.
MESSAGES = (
    "",
    "abc",
    "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
)


def root(n: int, power: int) -> int:
    """The largest integer whose power is at most n."""
    low, high = 0, n + 1
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle**power <= n else (low, middle)
    return low


def fractions(count: int, power: int) -> list[int]:
    """The first 32 bits of the fractional part of the root of the first primes."""
    primes = [n for n in range(2, 312) if all(n % k for k in range(2, n))][:count]
    return [root(p << 32 * power, power) & 0xFFFFFFFF for p in primes]


def words(values: list[int], per_row: int) -> str:
    """Words as lines of C."""
    text = [f"0x{value:08x}U" for value in values]
    return ",\n".join(" " * 8 + ", ".join(text[i : i + per_row]) for i in range(0, len(text), per_row))


def row(data: bytes) -> str:
    """The digest of bytes as C."""
    return ", ".join(f"0x{byte:02x}U" for byte in hashlib.sha256(data).digest())


def digest_view(model: Model, carried: list[str]) -> dict[str, Any]:
    """What is added, in order; carried: the structs that the filter holds."""
    fields = [(s.name, v) for s in model.structs if s.name in carried for v in s.fields]
    prefix, n = model.c_prefix.upper(), model.n
    parts: list[dict[str, Any]] = [
        {"size": v.size, "access": f"{'' if v.size > 1 else '&'}filter->{struct}.{v.name}"} for struct, v in fields
    ]
    parts += [{"size": f"{prefix}_N_STATES", "access": "filter->x"}]
    parts += [{"size": f"{prefix}_N_PACKED", "access": "filter->P"}]
    count = sum(v.size for _, v in fields) + n + n * (n + 1) // 2
    numbers = 0.5 * np.arange(count) * np.where(np.arange(count) % 2, -1.0, 1.0) + 0.0
    return {
        "K": words(fractions(64, 3), 6),
        "start": words(fractions(8, 2), 4),
        "order": ", ".join([*carried, "x and P"]),
        "parts": [part | {"mutable": part["access"].replace("filter->", "filter.")} for part in parts],
        "messages": [(text, row(text.encode())) for text in MESSAGES],
        "double": row(numbers.astype("<f8").tobytes()),
        "float": row(numbers.astype("<f4").tobytes()),
    }
