"""Hashes and times of flights on a GPU: python -m benchmarks.gpu"""

import ctypes
from pathlib import Path

from boresight.runtime import compiler

HEADERS = "".join(f"#include <{name}.h>\n" for name in ("float", "math", "stddef", "stdint", "string"))
FLAGS = ("-std=c++17", "-O2", "-fPIC", "-shared", "-ffp-contract=off", "-w")


def by_host(source: str, folder: Path) -> ctypes.CDLL:
    """The text for a GPU, compiled by g++."""
    file, library = folder / "flights.cpp", folder / "flights.so"
    file.write_text(HEADERS + source)
    compiler.run(["g++", *FLAGS, file, "-o", library])
    return ctypes.CDLL(str(library))
