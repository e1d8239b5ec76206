"""A unit of C as a syntax tree, with the headers of its folder and without those of the system."""

import re
from pathlib import Path
from typing import Any

from pycparser import c_parser

from boresight.codegen.folder import Source
from boresight.evidence.targets import PRECISIONS
from boresight.runtime.compiler import run

# what the headers of the system would say
WORDS = (
    "typedef unsigned char uint8_t; typedef unsigned short uint16_t; typedef unsigned int uint32_t;"
    "typedef int int32_t; typedef long int64_t; typedef unsigned long uint64_t, size_t;"
)
# what the parser does not know, and what changes no value
PLAIN = ("-DBS_LIVE_BARRIER()=((void)0)", "-D__attribute__(words)=")


def parsed(unit: Source, precision: str = "double", named: bool = False) -> Any:
    """The unit with the headers of its folder, preprocessed for this precision.

    named: the elementary functions are the library's, so that they can be told by name, as in a printed unit; a filter
    is held against its parts bit by bit, and keeps its own.
    """
    text, ours = [WORDS], False
    library = [*PRECISIONS[precision], *PLAIN, *["-DBORESIGHT_LIBM"][: int(named)]]
    for line in run(["gcc", "-E", "-std=c99", *library, "-I", unit.folder.include, unit.path]).splitlines():
        mark = re.match(r'# (\d+) "([^"]*)"', line)
        if mark:
            ours = Path(mark[2]).is_relative_to(unit.folder.path)
            if ours:
                text.append(f'#line {mark[1]} "{mark[2]}"')
        elif ours:
            text.append(line)
    return c_parser.CParser().parse("\n".join(text) + "\n", filename=str(unit.path))


def of_headers(function: Any) -> bool:
    """Whether it stands in a header that the folder's units share."""
    return Path(function.coord.file).parent.name == "include"
