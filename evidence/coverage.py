"""What the shipped self-test covers of the C that ships: lines, branches, and conditions by MC/DC.

A decision is what `if`, `?`, `for` or `while` asks, and every expression with && or ||.  Each of its conditions is
marked in the syntax tree, and the self-test run over the marked text.  A branch is a condition that was true, or false.
A condition is covered by MC/DC if it was seen both true and false with the outcome changed and every other condition
that was evaluated in both the same: unique cause, where a condition that is not evaluated counts as either.  What
stands in a header is counted once, over all units that call it, and not where none does.  A condition of constants
alone cannot change, and is none.  Lines are gcov's.  Without BORESIGHT_ROWS, which is for hosts.

What is left open is named, and why it is, where the model's own text shows that it cannot be otherwise.
"""

import itertools
import json
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pycparser import c_ast, c_generator

from boresight import BoresightError
from boresight.codegen.folder import Folder, Source
from boresight.evidence.because import argued, beyond_reach, c_of
from boresight.evidence.mutants import PROBES, Types, lines_of
from boresight.evidence.parsed import of_headers, parsed
from boresight.evidence.targets import HARNESS, PRECISIONS, plain
from boresight.runtime.compiler import compile_sources, run

LOGICAL = ("&&", "||")
MARKS = "int coverage_mark(int, int, int); int coverage_decide(int, int);\n"
QUIET = ("gcc", "-std=gnu99", "-O1", "-w", "-ffp-contract=off")
Lines = dict[tuple[int, str, str], bool]  # by number, text and function, whether it was run
Evaluation = tuple[int, int, int]  # the conditions that were evaluated, those that were true, and what came of it


@dataclass
class Decision:
    """function: where it stands.  text: its line.  conditions: how many may change.  evaluations: how it was taken."""

    file: str
    function: str
    text: str
    conditions: int = 0
    evaluations: set[Evaluation] = field(default_factory=set)


class Marker(c_generator.CGenerator):
    """Prints the unit with every decision and condition of its own functions marked, from decision `first` on."""

    def __init__(self, unit: Source, types: Types, first: int):
        super().__init__()
        self.unit, self.types, self.first = unit, types, first
        self.decisions: list[Decision] = []
        self.function, self.inside = "", False

    def visit_FuncDef(self, n: Any) -> str:
        own = Path(n.coord.file).name in (self.unit.path.name, f"{self.unit.name}_kernel.h")
        shared = n.decl.name in self.types.called and n.decl.name not in PROBES
        self.inside, self.function = shared if of_headers(n) else own, n.decl.name
        text = str(super().visit_FuncDef(n))
        self.inside = False
        return text

    def decided(self, n: Any) -> str:
        """An expression as a decision; as it is where nothing in it may change."""
        if not self.inside or n is None or not any(map(changes, conditions(n))):
            return "" if n is None else str(super().visit(n))
        file, line = n.coord.file, n.coord.line
        decision = Decision(Path(file).name, plain(self.function), lines_of(file)[line - 1])
        number = self.first + len(self.decisions)
        self.decisions.append(decision)
        return f"coverage_decide({number}, {self.marked(n, decision, number)})"

    def marked(self, n: Any, decision: Decision, number: int) -> str:
        if is_logical(n):
            return f"({self.marked(n.left, decision, number)} {n.op} {self.marked(n.right, decision, number)})"
        if is_not(n):
            return f"(!{self.marked(n.expr, decision, number)})"
        text = self.visit(n)
        if not changes(n):
            return f"({text})"
        decision.conditions += 1
        return f"coverage_mark({number}, {decision.conditions - 1}, ({text}) != 0)"

    def visit_BinaryOp(self, n: Any) -> str:
        return self.decided(n) if is_logical(n) and self.inside else str(super().visit_BinaryOp(n))

    def visit_TernaryOp(self, n: Any) -> str:
        return f"(({self.decided(n.cond)}) ? ({self.visit(n.iftrue)}) : ({self.visit(n.iffalse)}))"

    def controlled(self, n: Any, printed: Any) -> str:
        """A statement that asks, printed with its question as a decision."""
        asked = c_ast.ID(self.decided(n.cond)) if n.cond is not None else None
        return str(printed(type(n)(**{name: getattr(n, name) for name in n.__slots__[:-2]} | {"cond": asked})))

    def visit_If(self, n: Any) -> str:
        return self.controlled(n, super().visit_If)

    def visit_For(self, n: Any) -> str:
        return self.controlled(n, super().visit_For)

    def visit_While(self, n: Any) -> str:
        return self.controlled(n, super().visit_While)

    def visit_DoWhile(self, n: Any) -> str:
        return self.controlled(n, super().visit_DoWhile)


def is_logical(n: Any) -> bool:
    return isinstance(n, c_ast.BinaryOp) and n.op in LOGICAL


def is_not(n: Any) -> bool:
    return isinstance(n, c_ast.UnaryOp) and n.op == "!"


def conditions(n: Any) -> Iterator[Any]:
    """What a decision asks, one by one."""
    if is_logical(n):
        yield from (*conditions(n.left), *conditions(n.right))
    elif is_not(n):
        yield from conditions(n.expr)
    else:
        yield n


def changes(n: Any) -> bool:
    """Whether it names anything."""
    if isinstance(n, c_ast.UnaryOp) and n.op == "sizeof":
        return False
    return isinstance(n, c_ast.ID | c_ast.FuncCall) or any(changes(child) for _, child in n.children())


def coverage(folder: Folder, out: Path) -> dict[str, dict[str, Any]]:
    """By unit, and for the headers under `include`: by precision how many lines, branches and conditions are covered,
    of how many; `open`, in words, of both precisions together or of one that is named."""
    units = [unit for unit in folder.units if unit.test.is_file()]
    found: dict[str, dict[str, Any]] = {name: {} for name in (*(unit.name for unit in units), "include")}
    for precision in PRECISIONS:
        place = out / precision
        place.mkdir()
        decisions = decisions_of(folder, units, precision, place)
        lines = lines_covered(folder, units, precision, place)
        for name, of in found.items():
            files = {f"{name}.c", f"{name}_kernel.h"}
            files |= {path.name for path in folder.include.iterdir()} if name == "include" else set()
            of[precision] = counted([d for d in decisions if d.file in files], lines, files)
    text = c_of(folder)
    for of in found.values():
        left = {precision: of[precision].pop("open") for precision in PRECISIONS}
        both = set.intersection(*map(set, left.values()))
        alone = [f"{precision}: {line}" for precision in PRECISIONS for line in left[precision] if line not in both]
        of["open"] = [argued(line, text) for line in left["double"] if line in both] + alone
        for precision in PRECISIONS:
            of[precision]["beyond"] = beyond_reach(of["open"])
    return found


def counted(decisions: list[Decision], lines: dict[str, Lines], files: set[str]) -> dict[str, Any]:
    ran = [
        (function or file, text, hit)
        for file in sorted(files)
        for (_, text, function), hit in lines.get(file, {}).items()
    ]
    branches = [(d, k, value) for d in decisions for k in range(d.conditions) for value in (1, 0)]
    taken = [branch for branch in branches if was(*branch)]
    both = [(d, k) for d in decisions for k in range(d.conditions)]
    alone = [pair for pair in both if shown_alone(*pair)]
    words = [f"{where}, `{text}` is not run" for where, text, hit in ran if not hit]
    words += [
        f"{d.function}, condition {k + 1} is never {'true' if value else 'false'}: {d.text}"
        for d, k, value in branches
        if not was(d, k, value)
    ]
    words += [
        f"{d.function}, condition {k + 1} never decides alone: {d.text}"
        for d, k in both
        if not shown_alone(d, k) and was(d, k, 1) and was(d, k, 0)
    ]
    return {
        "lines": [sum(hit for *_, hit in ran), len(ran)],
        "branches": [len(taken), len(branches)],
        "conditions": [len(alone), len(both)],
        "open": words,
    }


def was(decision: Decision, k: int, value: int) -> bool:
    """Whether a condition was ever evaluated to this."""
    return any(evaluated >> k & 1 and (values >> k & 1) == value for evaluated, values, _ in decision.evaluations)


def shown_alone(decision: Decision, k: int) -> bool:
    """Whether two ways differ in this condition and in the outcome, and in no other that both evaluated."""
    for a, b in itertools.combinations(decision.evaluations, 2):
        both, differ = a[0] & b[0], a[1] ^ b[1]
        if both >> k & 1 and both & differ == 1 << k and a[2] != b[2]:
            return True
    return False


def decisions_of(folder: Folder, units: list[Source], precision: str, out: Path) -> list[Decision]:
    """Every decision of the folder's units, with the ways in which the self-test took it."""
    decisions: list[Decision] = []
    texts: dict[Path, tuple[str, ...]] = {}
    for unit in folder.units:
        tree = parsed(unit, precision)
        marker = Marker(unit, Types(tree), len(decisions))
        path = out / unit.path.name
        path.write_text("#include <math.h>\n" + MARKS + marker.visit(tree))
        decisions += marker.decisions
        texts[path] = ()
    texts[HARNESS / "coverage.c"] = (f"-DEVIDENCE_DECISIONS={max(1, len(decisions))}",)
    own = compile_sources([*QUIET, *PRECISIONS[precision], "-I", folder.include], texts, out)
    run_self_test(folder, precision, own, out)
    for line in (out / "coverage.txt").read_text().splitlines():
        number, evaluated, values, outcome = map(int, line.split())
        decisions[number].evaluations.add((evaluated, values, outcome))
    return merged(decisions)


def merged(decisions: list[Decision]) -> list[Decision]:
    """What stands in a header once, with the ways of all units that call it."""
    found: dict[tuple[str, ...], Decision] = {}
    for (*_, function), group in itertools.groupby(decisions, lambda d: (d.file, d.function)):
        for i, decision in enumerate(group):
            key = (decision.file, function, str(i))
            found.setdefault(key, decision).evaluations.update(decision.evaluations)
    return list(found.values())


def run_self_test(folder: Folder, precision: str, units: dict[str, Path], out: Path, *link: str) -> None:
    """Build the shipped self-test around these objects, and run it in `out`."""
    common = ["gcc", "-std=c99", "-O1", "-w", "-ffp-contract=off", *PRECISIONS[precision], "-I", folder.include]
    tests = dict.fromkeys([*folder.files("selftest/*.c"), *folder.identity], ())
    objects = compile_sources([*common, "-I", folder.path / "selftest"], tests, out)
    program = out / "selftest.out"
    run(["gcc", *link, *units.values(), *objects.values(), "-lm", "-o", program])
    done = subprocess.run([program], cwd=out, capture_output=True, text=True, check=False)
    if done.returncode:
        raise BoresightError(f"{folder.name}: the self-test fails in {precision}: {done.stdout.strip()[-200:]}")


def lines_covered(folder: Folder, units: list[Source], precision: str, out: Path) -> dict[str, Lines]:
    """By file of the folder, of each line that holds code whether it was run; of a header, in what some unit calls."""
    called = set[str]().union(*(Types(parsed(unit, precision)).called for unit in folder.units))
    place = out / "lines"
    place.mkdir()
    covered = ["gcc", "-std=c99", "-O0", "-w", "-ffp-contract=off", "--coverage", *PRECISIONS[precision]]
    made = compile_sources([*covered, "-I", folder.include], {unit.path: () for unit in folder.units}, place)
    run_self_test(folder, precision, made, place, "--coverage")
    found: dict[str, Lines] = {}
    for unit in units:
        done = run(["gcov", "--json-format", "--stdout", f"{unit.name}.gcda"], cwd=place)
        for file in json.loads(done.splitlines()[0])["files"]:
            path = Path(file["file"])
            own = path.name in (unit.path.name, f"{unit.name}_kernel.h")
            if not own and path.parent.name != "include":
                continue
            lines = found.setdefault(path.name, {})
            for line in file["lines"]:
                name = plain(str(line.get("function_name", "")))
                if name not in PROBES and (own or name in called or not name):
                    key = line["line_number"], lines_of(str(path))[line["line_number"] - 1], name
                    lines[key] = lines.get(key, False) or line["count"] > 0
    return found
