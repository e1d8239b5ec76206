"""Where in a user's file the parts of a model are written: what a message begins with."""

import os
import sys
from dataclasses import field
from types import FrameType
from typing import Any

OURS = "boresight."
# Their frames stand between a part and the line that makes it: its class, what builds it, and dataclasses.replace.
BUILDERS = (
    *(f"boresight.derive.{name}" for name in ("constant", "model", "named", "where")),
    *("dataclasses", "functools"),
)


def written_at() -> str:
    """`FILE:LINE` of the first caller outside of Boresight; of a built-in model, its own line; or nothing."""
    own: FrameType | None = None
    frame: FrameType | None = sys._getframe(1)
    while frame is not None:
        module = frame.f_globals.get("__name__", "")
        if module.startswith("boresight.derive.") and module not in BUILDERS:
            own = own or frame
        elif own is not None and module.startswith((OURS, "importlib.")):
            break  # a built-in model that is imported or loaded
        elif module not in BUILDERS:
            own = frame
            break
        frame = frame.f_back
    return line_of(own.f_code.co_filename, own.f_lineno) if own else ""


def line_of(file: str, line: int | None) -> str:
    """`FILE:LINE`, the file as seen from the current folder where it lies in it."""
    try:
        near = os.path.relpath(file)
    except (OSError, ValueError):  # a folder that is gone, another drive
        near = file
    return f"{file if near.startswith('..') or file.startswith('<') else near}:{line}"


def where_written() -> Any:
    """The field of a dataclass that holds the line; two parts that differ in it alone are equal, and print alike."""
    return field(default_factory=written_at, init=False, compare=False, repr=False)
