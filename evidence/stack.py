"""Stack of each entry point by the graph of calls, flash of each unit and RAM of what a caller keeps, by core.

gcc writes beside each object what every function puts on the stack and whom it calls.  The stack of an entry point is
the deepest way through that graph over all units: a bound, whatever is called with.  Functions of the target's own
library are named and not counted; the deepest of them is the user's to add.
"""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from boresight import BoresightError
from boresight.codegen.folder import Folder
from boresight.evidence.targets import CORES, PRECISIONS, WARNINGS, Target, plain, symbol_table, text_size
from boresight.runtime.compiler import compile_sources, run

NODE = re.compile(r'^node: \{ title: "([^"]*)" label: "([^"]*)"', re.MULTILINE)
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"', re.MULTILINE)
BYTES = re.compile(r"(\d+) bytes \((\S+)\)")
INDIRECT = "__indirect_call"
# of two functions with one body the graph would have the size of one alone
FLAGS = ("-Os", "-fno-ipa-icf", "-ffunction-sections", "-fdata-sections", "-fcallgraph-info=su")


class Calls:
    """Whom each function calls, and what it puts on the stack itself."""

    def __init__(self, graphs: list[Path]):
        self.own: dict[str, int] = {}
        self.unit: dict[str, str] = {}
        self.calls: dict[str, set[str]] = {}
        for graph in graphs:
            text = graph.read_text()
            for title, label in NODE.findall(text):
                if found := BYTES.search(label):
                    if found[2] != "static":
                        raise BoresightError(f"{title}: its stack is {found[2]}, so that no bound can be given")
                    self.own[title], self.unit[title] = int(found[1]), graph.stem
            for caller, called in EDGE.findall(text):
                self.calls.setdefault(caller, set()).add(called)

    def entries(self) -> Iterator[str]:
        """Functions that other files may call: those of one file alone have its path in their title."""
        return (title for title in self.own if ":" not in title)

    def deepest(self, function: str, above: tuple[str, ...] = ()) -> int:
        """Bytes of a call and of all below it."""
        if function in above or function == INDIRECT:
            raise BoresightError(f"{above[-1]} calls {function}: no bound on its stack can be given")
        if ":" in function and function not in self.own:  # of our own files, and no library's
            raise BoresightError(
                f"{above[-1]} calls {function.rsplit(':')[-1]}, whose stack the compiler does not give"
            )
        below = (self.deepest(called, (*above, function)) for called in self.calls.get(function, ()))
        return self.own.get(function, 0) + max(below, default=0)

    def library(self, function: str) -> set[str]:
        """Functions of the target's library that are called below this one."""
        found = {called for called in self.calls.get(function, ()) if called not in self.own}
        return found.union(*(self.library(called) for called in self.calls.get(function, ())))


def built(folder: Folder, core: Target, precision: str, out: Path) -> tuple[dict[str, int], Calls]:
    """Bytes of code and constants by unit, and who calls whom; built into `out`."""
    command = [core.compiler, *WARNINGS, *core.flags, *PRECISIONS[precision], *FLAGS, "-I", folder.include]
    objects = compile_sources(command, {unit.path: () for unit in folder.units}, out)
    return {unit: text_size(path) for unit, path in objects.items()}, Calls(sorted(out.glob("*.ci")))


def structs(folder: Folder, core: Target, precision: str, out: Path) -> dict[str, int]:
    """Bytes of the filter and of the live loop, if there are such."""
    prefix, model = folder.manifest["c_prefix"], folder.manifest["model"].replace("-", "_")
    words = [word for word in ("filter", "live") if (folder.include / f"{model}_{word}.h").is_file()]
    lines = [f'#include "{model}_{word}.h"\nchar size_{word}[sizeof({prefix}_{word})];\n' for word in words]
    (out / "sizes.c").write_text("".join(lines))
    command = [core.compiler, *core.flags, *PRECISIONS[precision], "-I", folder.include, "-c", out / "sizes.c"]
    run([*command, "-o", out / "sizes.o"])
    sizes = {symbol.name: symbol["st_size"] for symbol in symbol_table(out / "sizes.o")}
    return {f"{prefix}_{word}": sizes[f"size_{word}"] for word in words}


def stack(folder: Folder, out: Path) -> dict[str, dict[str, Any]]:
    """By unit: of each entry point its stack by target, in bytes; the unit's flash; of both by -Os; RAM of the struct
    of its name.  `library` names what of the target's library is called and not counted."""
    found: dict[str, dict[str, Any]] = {
        unit.name: {"stack": {}, "flash": {}, "ram": {}, "library": []} for unit in folder.units
    }
    for core in CORES:
        for precision in PRECISIONS:
            if precision == "double" and not core.double:
                continue
            name, place = f"{core.name} {precision}", out / f"{core.name}-{precision}"
            place.mkdir()
            flash, calls = built(folder, core, precision, place)
            for unit, size in flash.items():
                found[unit]["flash"][name] = size
            for unit, size in structs(folder, core, precision, place).items():
                found[unit]["ram"][name] = size
            for entry in calls.entries():
                of = found[calls.unit[entry]]
                of["stack"].setdefault(plain(entry), {})[name] = calls.deepest(entry)
                of["library"] = sorted({*of["library"], *calls.library(entry)})
    return found
