"""Statements of the syntax tree by room: `python tests/size.py`, or `python tests/size.py FOLDER` of another."""

import ast
import sys
from pathlib import Path

ROOMS = (
    "boresight",
    "derive",
    "codegen",
    "runtime",
    "analysis",
    "studies",
    "evidence",
    "examples",
    "benchmarks",
    "tests",
)
root = Path(sys.argv[1] if sys.argv[1:] else Path(__file__).parents[1])
counts = {room: [0, 0] for room in ROOMS}
for room in ROOMS:
    for path in root.glob("boresight/*.py" if room == "boresight" else f"{room}/**/*.py"):
        counts[room][0] += 1
        counts[room][1] += sum(isinstance(node, ast.stmt) for node in ast.walk(ast.parse(path.read_text())))
for room, (files, statements) in counts.items():
    print(f"{room:10} {files:4} files {statements:6} statements")
