"""From each statement of a printed kernel to the outputs that depend on it, their blocks, the equations and the test.

Read from the C text alone, and then held against the manifest, the ledger of the papers and the shipped test, both
ways: no statement without an output, no output without a statement, no field unread, none untested.
`python -m boresight.evidence.trace euler_matching em_F` prints the whole table of one unit.
"""

import re
import sys
from collections.abc import Collection
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from boresight import BoresightError
from boresight.codegen.folder import Folder, Source, folders
from boresight.codegen.text.statements import CALLS
from boresight.derive.papers import DERIVATIONS, PAPERS, paper

FUNCTION = re.compile(r"^(?:static|BS_INSIDE) void (\w+)\(([^)]*)\)\n\{\n(.*?)\n\}$", re.MULTILINE | re.DOTALL)
PARAMETER = re.compile(r"(\w+)(?:\[\d+\])?(?:,|$)")
STATEMENT = re.compile(r"^    (?:const bs_real |shared->)(\w+) = (.*);$")
DECLARED = re.compile(r"^    bs_real \w+;$")
COMMENT = re.compile(r"^ */\*.*?\*/\n?", re.MULTILINE | re.DOTALL)
PAIR = re.compile(r"^    BS_SINCOS\((.*), &((?:shared->)?\w+), &((?:shared->)?\w+)\);$")
OUTPUT = re.compile(r"^    (\w+)_nz\[(\d+)\] = (.*); /\* (.*) \*/$")
READ = re.compile(r"([A-Za-z_]\w*)(\[\d+\])?")
PLACES = re.compile(r"static const unsigned short at_(\w+)\[\d+\] = \{ ([\d,\s]*) \};")
WORDS = {"BS_REAL", "BS_SELECT", "BS_TRUTH", "e", *CALLS.values()}


@dataclass(frozen=True)
class Line:
    """One statement: its number in the kernel, its text as if the kernel were one function, and the outputs that depend
    on it, as (result, non-zero)."""

    number: int
    text: str
    outputs: tuple[tuple[str, int], ...]


@dataclass(frozen=True)
class Kernel:
    """outputs: (result, non-zero) -> the comment behind it, which names the element; read: inputs, as they stand."""

    statements: tuple[Line, ...]
    outputs: dict[tuple[str, int], str]
    read: frozenset[str]


def kernel(unit: Source) -> Kernel:
    """The printed kernel of a unit.  Raises BoresightError on a line of its body that is no statement."""
    path = unit.path.with_name(f"{unit.name}_kernel.h")
    body = statements(path)
    defined: dict[str, tuple[int, str, list[str]]] = {}
    outputs: dict[tuple[str, int], str] = {}
    needs: dict[tuple[str, int], list[str]] = {}
    read: set[str] = set()
    for number, line in enumerate(body):
        statement, output = STATEMENT.match(line), OUTPUT.match(line)
        if statement is None and output is None:
            raise BoresightError(f"{path.name}: {line.strip()!r} is no statement of a kernel")
        text = (statement[2] if statement else output[3] if output else "").replace("shared->", "")
        names = [
            f"{name}{index}" for name, index in READ.findall(re.sub(r"BS_REAL\([^)]*\)", "", text)) if name not in WORDS
        ]
        read |= {name for name in names if name not in defined}
        if statement:
            if statement[1] in defined:
                raise BoresightError(f"{path.name}: {statement[1]} is assigned twice")
            defined[statement[1]] = (number, f"const bs_real {statement[1]} = {text};", names)
        elif output:
            key = (output[1], int(output[2]))
            if key in outputs:
                raise BoresightError(f"{path.name}: {key} is written twice")
            outputs[key], needs[key] = output[4], names
    reached: dict[str, set[tuple[str, int]]] = {name: set() for name in defined}
    for key, names in needs.items():
        left = [name for name in names if name in defined]
        while left:
            name = left.pop()
            if key not in reached[name]:
                reached[name].add(key)
                left += [inner for inner in defined[name][2] if inner in defined]
    lines = tuple(Line(number, text, tuple(sorted(reached[name]))) for name, (number, text, _) in defined.items())
    return Kernel(lines, outputs, frozenset(read))


def statements(path: Path) -> list[str]:
    """The lines of a kernel.  Of one in several functions those of each, which must be called in their order, with
    arguments named as their parameters."""
    *parts, (_, _, body) = FUNCTION.findall(path.read_text())
    if not parts:
        return single(body)
    calls = [f"{name}({', '.join(PARAMETER.findall(listed))});" for name, listed, _ in parts]
    called = [line.strip() for line in re.sub(r",\n *", ", ", body).replace("&", "").splitlines()]
    if [line for line in called if not line.endswith("_shared shared;")] != calls:
        raise BoresightError(f"{path.name}: its functions are not called one after another, each with its parameters")
    return [line for _, _, lines in parts for line in single(lines)]


def single(body: str) -> list[str]:
    """The statements, without the comments before outputs, and with each call that gives a sine and a cosine as the two
    statements that it stands for."""
    lines = []
    for line in COMMENT.sub("", body).splitlines():
        pair = PAIR.match(line)
        if pair:
            for name, value in zip(("BS_SIN", "BS_COS"), pair.groups()[1:], strict=True):
                left = value if "->" in value else f"const bs_real {value}"
                lines.append(f"    {left} = {name}({pair[1]});")
        elif not DECLARED.match(line):
            lines.append(line)
    return lines


@cache
def printed(name: str) -> frozenset[str]:
    """Numbers of the equations that the ledger of a paper has."""
    return frozenset(equation.number for equation in paper(name).equations)


def known(citation: str) -> bool:
    """Whether the ledger has the cited equation, as `song-lee-2001 (20)`."""
    match = re.fullmatch(r"([\w-]+) \(([\w-]+)\)", citation)
    return match is not None and match[1] in (*PAPERS, *DERIVATIONS) and match[2] in printed(match[1])


def block(unit: Source, result: dict[str, Any], comment: str) -> str:
    """The block that an element lies in: of a matrix by states the two blocks of states, else its row."""
    row, _, column = comment.partition(", ")
    blocks = {name: of["name"] for of in unit.folder.manifest["blocks"] for name in of["components"]}
    right = blocks.get(column, column)
    left = blocks.get(row, row) if result["shape"][0] == len(unit.folder.manifest["states"]) else row
    return f"{result['name']}[{left}{', ' + right if right else ''}]"


def trace(folder: Folder, out: Path, names: Collection[str] | None = None) -> dict[str, dict[str, Any]]:
    """By printed unit: statements, blocks with how many statements each depends on, equations, and what is missing."""
    return {unit.name: of_unit(unit) for unit in folder.chosen(names) if unit.described is not None}


def of_unit(unit: Source) -> dict[str, Any]:
    assert unit.described is not None
    made, results = kernel(unit), {result["name"]: result for result in unit.described["results"]}
    missing = [f"{line.text} reaches no output" for line in made.statements if not line.outputs]
    if len(made.statements) != unit.operations:
        missing.append(f"{len(made.statements)} statements, {unit.operations} operations in the manifest")
    tested = {
        name: places.count(",") + 1 if places.strip() else 0 for name, places in PLACES.findall(unit.test.read_text())
    }
    for name, result in results.items():
        written = sorted(k for of, k in made.outputs if of == name)
        if written != list(range(result["nonzeros"])):
            missing.append(f"{name}: {len(written)} non-zeros written, {result['nonzeros']} in the manifest")
        if tested.get(name) != result["nonzeros"]:
            missing.append(f"{name}: {tested.get(name)} of {result['nonzeros']} non-zeros in the test")
    missing += [f"{name} is no result of the manifest" for name in {of for of, _ in made.outputs} - set(results)]
    fields = {name.split("[")[0] for name in made.read}
    missing += [f"field {name} is read by no statement" for name in set(unit.described["fields"]) - fields]
    missing += [
        f"{name} is read and is no field" for name in fields - set(unit.described["fields"]) if not name.isdigit()
    ]
    missing += [f"{citation} is in no ledger" for citation in unit.described["equations"] if not known(citation)]
    blocks: dict[str, set[int]] = {block(unit, results[of], text): set() for (of, _), text in made.outputs.items()}
    for line in made.statements:
        for key in line.outputs:
            blocks[block(unit, results[key[0]], made.outputs[key])].add(line.number)
    return {
        "statements": len(made.statements),
        "outputs": len(made.outputs),
        "blocks": {name: len(lines) for name, lines in sorted(blocks.items())},
        "equations": unit.described["equations"],
        "missing": missing,
    }


def table(unit: Source) -> str:
    """Every statement with its blocks, a line each; the equations and the test at the head."""
    assert unit.described is not None
    made, results = kernel(unit), {result["name"]: result for result in unit.described["results"]}
    cited = ", ".join(unit.described["equations"]) or "derived by the model alone"
    lines = [f"{unit.described['c_name']}: {cited}; tested by {unit.test.name}"]
    for line in made.statements:
        seen = sorted({block(unit, results[key[0]], made.outputs[key]) for key in line.outputs})
        lines.append(f"{line.text}  -> {' '.join(seen)}")
    for (of, k), text in made.outputs.items():
        lines.append(f"{of}_nz[{k}] at {text}  -> {block(unit, results[of], text)}")
    return "\n".join(lines)


if __name__ == "__main__":
    print(*(table(unit) for folder in folders() for unit in folder.units if [folder.name, unit.name] == sys.argv[1:]))
