"""Mutants of the C text of a unit, run through its shipped self-test.

The preprocessed unit is parsed, and each real operation or comparison swapped, each sign flipped, each constant off by
1e-3 becomes a choice that one global number makes: one executable holds all of them, and forks for each. In loops, of a
covariance and of a filter, also each statement dropped, each check of a status passed, each operation on integers and
bits swapped, each integer raised by one, each two neighbouring arguments of a kind swapped; and of the form that the
other precision has, what the first has not. What the self-test lets pass is compared with the unit itself at 1e4 points
of its box and beside the box's edges: a mutant with equal bits throughout is equivalent, and counted apart. A filter's
check of what it is started with repeats the boxes of the model: there a component's bound a thousandth further out is
equivalent if the range of the norm ends at the bound, for then the norm refuses with the same status. The elementary
functions are left out: their last coefficients count in the last bit, which tests/codegen/test_elementary.py judges, no
self-test.
"""

import ctypes
import re
from collections.abc import Collection, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from pycparser import c_ast, c_generator

from boresight import BoresightError
from boresight.codegen.flight import flies, from_words, with_flight
from boresight.codegen.folder import Folder, Source
from boresight.codegen.functions import tape
from boresight.codegen.functions.mutants import SWAPS as SWAPPED
from boresight.codegen.functions.samples import generator
from boresight.evidence.calls import Points, call, callable_units, layout, points_of, shared_library
from boresight.evidence.parsed import of_headers, parsed
from boresight.evidence.targets import GCC, HARNESS, build, compile_units, run_on_host
from boresight.runtime.compiler import PRECISIONS, compile_sources, run
from boresight.runtime.library import Unit

MOST = 2000  # mutants of a unit
POINTS, CORNERS = 10_000, 2_000  # at which a survivor is compared
FLAGS = ("-std=gnu99", "-O1", "-fPIC", "-ffp-contract=off", "-w")
OFF = 1e-3
SWAPS = {"+": "-", "-": "+", "*": "/", "/": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
BITS = {"&": "|", "|": "&", "^": "|", "<<": ">>", ">>": "<<", "%": "/"}
LOGICAL = {"&&": "||", "||": "&&"}
ASSIGNING = {"+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}
SETTING = {"|=": "&=", "&=": "|=", "^=": "|=", "<<=": ">>=", ">>=": "<<=", "+=": "-=", "-=": "+="}
SUFFIX = re.compile(r"(?<=[0-9.])F\b|_(f32_joseph|f32|ud)\b")  # of numbers and of functions
LIBRARY = {"sqrt", "atan2", "fabs", *tape.LIBRARY}
CALLS = {name: other for name, other in SWAPPED.items() if name in LIBRARY}
REAL = {"bs_real", "double"}
PROBES = {"bs_probe"}  # it sees what a compiler makes of the C, which no self-test may change


@cache
def lines_of(file: str) -> list[str]:
    """What stands in each, but for its comment."""
    return [re.sub(r"/\*.*?(\*/|$)", "", line).strip() for line in Path(file).read_text().splitlines()]


def inmost(declared: Any) -> tuple[Any, int, tuple[str, ...]]:
    """What a type is of in the end: its declaration, after how many indexings, and its words."""
    inner, depth = declared, 0
    while isinstance(inner, (c_ast.ArrayDecl, c_ast.PtrDecl, c_ast.FuncDecl)):
        depth += not isinstance(inner, c_ast.FuncDecl)
        inner = inner.type
    return inner, depth, tuple(getattr(getattr(inner, "type", None), "names", ()))


def name_of(node: Any) -> str:
    """That of a variable or a field; none of anything else."""
    last = node.field if isinstance(node, c_ast.StructRef) else node
    return str(last.name) if isinstance(last, c_ast.ID) else ""


class Types(c_ast.NodeVisitor):
    """Names that hold, point to, or return real numbers, each with its depth: how often it must be indexed to be one
    (0 for a number and for a function that returns one); and the functions that those of the unit's own files call,
    through others too."""

    def __init__(self, tree: Any):
        self.real: dict[str, int] = dict.fromkeys(LIBRARY, 0)
        self.pointers: set[str] = set()  # and arrays: names, also of fields
        self.calls: dict[str, set[str]] = {}
        self.takes: dict[str, list[tuple[Any, ...]]] = {}  # the types of a function's parameters, and how deep
        self.function = ""
        self.visit(tree)
        left = [f.decl.name for f in tree.ext if isinstance(f, c_ast.FuncDef) and not of_headers(f)]
        self.called: set[str] = set()
        while left:
            more = self.calls.get(left.pop(), set()) - self.called
            self.called |= more
            left += more

    def visit_FuncDef(self, node: Any) -> None:
        self.function = node.decl.name
        self.generic_visit(node)

    def visit_Decl(self, node: Any) -> None:
        if isinstance(node.type, c_ast.FuncDecl) and node.type.args is not None:
            self.takes[node.name] = [inmost(p.type)[1:] for p in node.type.args.params]
        if isinstance(node.type, (c_ast.PtrDecl, c_ast.ArrayDecl)):
            self.pointers.add(node.name)
        inner, depth, _ = inmost(node.type)
        if set(getattr(getattr(inner, "type", None), "names", ())) & REAL:
            self.real[node.name] = depth
        self.generic_visit(node)

    def visit_FuncCall(self, node: Any) -> None:
        if isinstance(node.name, c_ast.ID):
            self.calls.setdefault(self.function, set()).add(node.name.name)
        self.generic_visit(node)

    def is_real(self, node: Any) -> bool:
        return self.depth(node) == 0

    def depth(self, node: Any) -> int:
        """0 of a real number, n of what is one after n indexings, negative of anything else."""
        if isinstance(node, c_ast.Constant):
            return 0 if node.type in ("double", "float") else -1
        if isinstance(node, c_ast.ID):
            return self.real.get(node.name, -1)
        if isinstance(node, c_ast.ArrayRef):
            return self.depth(node.name) - 1
        if isinstance(node, c_ast.StructRef):
            return self.depth(node.field)
        if isinstance(node, c_ast.UnaryOp):
            inner = self.depth(node.expr)
            return {"-": inner, "+": inner, "*": inner - 1, "&": inner + 1 if inner >= 0 else -1}.get(node.op, -1)
        if isinstance(node, c_ast.BinaryOp):
            both = {self.depth(node.left), self.depth(node.right)}
            return 0 if node.op in ("+", "-", "*", "/") and 0 in both and max(both) == 0 else -1
        if isinstance(node, c_ast.TernaryOp):
            return self.depth(node.iftrue)
        if isinstance(node, c_ast.FuncCall):
            return self.depth(node.name)
        if isinstance(node, c_ast.Cast):
            return 0 if set(getattr(getattr(node.to_type.type, "type", None), "names", ())) & REAL else -1
        return -1


class Mutator(c_generator.CGenerator):
    """Prints the unit; where it mutates, the text chooses by evidence_mutant.

    chosen: numbers of the candidates that are to be mutants, or None to list the candidates only.
    """

    def __init__(self, unit: Source, types: Types, chosen: dict[int, int] | None):
        super().__init__()
        self.unit, self.types, self.chosen = unit, types, chosen
        self.candidates: list[str] = []
        self.statements: set[int] = set()
        self.inside = self.fixed = False
        self.function, self.loops = "", unit.described is None

    def choice(self, node: Any, what: str, otherwise: str, mutant: str) -> str:
        """`otherwise`, or the mutant's text if its number is up."""
        number = len(self.candidates)
        line = node.coord.line if node.coord else 0
        text = lines_of(node.coord.file)[line - 1] if line else ""  # a line's number moves with each comment before it
        self.candidates.append(f"{self.function}: {what}, in `{text}`")
        if self.chosen is None or number not in self.chosen:
            return otherwise
        return f"((evidence_mutant == {self.chosen[number]}) ? ({mutant}) : ({otherwise}))"

    def visit_FuncDef(self, n: Any) -> str:
        # what all units share is mutated in each that calls it, a kernel in its own unit
        file, own = Path(n.coord.file), (self.unit.path.name, f"{self.unit.name}_kernel.h")
        shared = n.decl.name in self.types.called and n.decl.name not in PROBES
        self.inside = shared if of_headers(n) else file.name in own
        self.function = n.decl.name
        text = str(super().visit_FuncDef(n))
        self.inside = False
        return text

    def visit_Compound(self, n: Any) -> str:
        if self.loops:  # in a printed list every statement's value is named again
            alone = (c_ast.Assignment, c_ast.FuncCall)
            self.statements |= {id(item) for item in n.block_items or () if isinstance(item, alone)}
        return str(super().visit_Compound(n))

    def visit(self, node: Any) -> str:
        text = str(super().visit(node))
        if self.inside and id(node) in self.statements:
            return self.choice(node, "statement dropped", f"(void)({text})", "(void)0")
        return text

    def visit_Decl(self, n: Any, no_type: bool = False) -> str:
        if self.inside and "static" in n.storage and n.init is not None:
            n.storage = [word for word in n.storage if word != "static"]  # its numbers are chosen at run time
        return str(super().visit_Decl(n, no_type))

    def visit_BinaryOp(self, n: Any) -> str:
        left, right = self.visit(n.left), self.visit(n.right)
        plain = f"(({left}) {n.op} ({right}))"
        if not self.inside:
            return plain
        if n.op in LOGICAL:  # the right side may only be looked at if the left one says so
            return self.choice(n, f"{n.op} to {LOGICAL[n.op]}", plain, f"(({left}) {LOGICAL[n.op]} ({right}))")
        pointer = isinstance(n.right, c_ast.Constant) and n.op in ("==", "!=")
        real = self.types.is_real(n.left) or self.types.is_real(n.right)
        swaps = SWAPS if not self.loops else SWAPS | BITS
        apart = n.op == "-" and all(name_of(side) in self.types.pointers for side in (n.left, n.right))
        if n.op not in swaps or self.fixed or apart or not (real or pointer or self.loops):
            return plain
        a, b = f"a{len(self.candidates)}", f"b{len(self.candidates)}"
        chosen = self.choice(n, f"{n.op} to {swaps[n.op]}", f"{a} {n.op} {b}", f"{a} {swaps[n.op]} {b}")
        if n.op == "==" and isinstance(n.right, c_ast.ID) and n.right.name == "BS_OK":
            chosen = self.choice(n, "check passed", chosen, "1")
        return f"({{ __auto_type {a} = ({left}); __auto_type {b} = ({right}); {chosen}; }})" if "?" in chosen else plain

    def _generate_type(self, *args: Any, **more: Any) -> str:
        before, self.fixed = self.fixed, True  # how many numbers an array has is no choice
        text = str(super()._generate_type(*args, **more))
        self.fixed = before
        return text

    def visit_Case(self, n: Any) -> str:
        label = c_generator.CGenerator().visit(n.expr)  # which is no choice either
        return f"case {label}:\n" + "".join(self._generate_stmt(one, add_indent=True) for one in n.stmts or ())

    def visit_UnaryOp(self, n: Any) -> str:
        text = str(super().visit_UnaryOp(n))
        if self.inside and n.op == "-" and self.types.is_real(n.expr):
            return self.choice(n, "minus dropped", text, text.split("-", 1)[1])
        if self.inside and self.loops and n.op in ("!", "~"):
            return self.choice(n, f"{n.op} dropped", text, text.split(n.op, 1)[1])
        return text

    def visit_Constant(self, n: Any) -> str:
        text = str(n.value)
        if self.inside and self.types.is_real(n) and float(n.value.rstrip("fF")) != 0:
            more = self.choice(n, f"{text} * {1 + OFF}", text, f"{text} * {1 + OFF}")
            return self.choice(n, f"{text} * {1 - OFF}", more, f"{text} * {1 - OFF}")
        if self.inside and self.loops and not self.fixed and "int" in n.type:
            return self.choice(n, f"{text} + 1", text, f"{text} + 1")
        return text

    def visit_FuncCall(self, n: Any) -> str:
        text = str(super().visit_FuncCall(n))
        if not self.inside or not isinstance(n.name, c_ast.ID) or n.name.name not in LIBRARY:
            return self.swapped(n, text) if self.inside and self.loops and n.args else text
        if n.name.name in CALLS:
            other = f"{CALLS[n.name.name]}{text[len(n.name.name) :]}"
            text = self.choice(n, f"{n.name.name} to {CALLS[n.name.name]}", text, other)
        return self.choice(n, f"sign of {n.name.name}", text, f"-({text})")

    def swapped(self, n: Any, text: str) -> str:
        """A call, or the call with two neighbouring arguments of a kind in each other's place."""
        takes = self.types.takes.get(n.name.name, [])
        plain = [c_generator.CGenerator().visit(each) for each in n.args.exprs]
        for i in range(len(takes) - 1):
            if takes[i] == takes[i + 1] and plain[i] != plain[i + 1]:
                other = [*plain[:i], plain[i + 1], plain[i], *plain[i + 2 :]]
                words = f"{n.name.name}: {plain[i]} and {plain[i + 1]} swapped"
                text = self.choice(n, words.replace(": ", " "), text, f"{n.name.name}({', '.join(other)})")
        return text

    def visit_Assignment(self, n: Any) -> str:
        if not self.inside or not self.types.is_real(n.lvalue):
            text = str(super().visit_Assignment(n))
            if not self.inside or not self.loops or n.op not in SETTING:
                return text
            left, right = c_generator.CGenerator().visit(n.lvalue), c_generator.CGenerator().visit(n.rvalue)
            return self.choice(n, f"{n.op} to {SETTING[n.op]}", text, f"{left} {SETTING[n.op]} ({right})")
        left, right = self.visit(n.lvalue), self.visit(n.rvalue)
        if n.op in ASSIGNING:
            text = f"{left} {n.op} ({right})"
            return self.choice(n, f"{n.op} to {ASSIGNING[n.op]}", text, f"{left} {ASSIGNING[n.op]} ({right})")
        if isinstance(n.rvalue, c_ast.Constant) and not n.rvalue.value.strip("0.xXeEuUlLfF+-"):
            return f"{left} {n.op} {right}"  # minus zero is no other number
        return f"{left} {n.op} {self.choice(n, 'sign of what is assigned', right, f'-({right})')}"


def candidates(unit: Source, precision: str = "double") -> list[str]:
    """Every mutant that there could be, in words."""
    tree = parsed(unit, precision, named=unit.described is not None)
    mutator = Mutator(unit, Types(tree), None)
    mutator.visit(tree)
    return mutator.candidates


def mutated(unit: Source, most: int, precision: str = "double") -> tuple[str, list[str], int]:
    """The text with at most `most` mutants, drawn evenly; what they are; of how many.  In float those that double has
    not."""
    words = candidates(unit, precision)
    known = {SUFFIX.sub("", word) for word in candidates(unit)} if precision != "double" else set()
    new = [number for number, word in enumerate(words) if SUFFIX.sub("", word) not in known]
    picked = sorted(new[i] for i in generator("mutants", unit.name).permutation(len(new))[:most].tolist())
    tree = parsed(unit, precision, named=unit.described is not None)
    mutator = Mutator(unit, Types(tree), {number: i for i, number in enumerate(picked)})
    text = mutator.visit(tree)
    return "#include <math.h>\nextern int evidence_mutant;\n" + text, [words[number] for number in picked], len(new)


def mutants(
    folder: Folder, out: Path, most: int = MOST, names: Collection[str] | None = None
) -> dict[str, dict[str, Any]]:
    """By unit: mutants tried, killed by the shipped self-test, equivalent, and the others by name; of loops also those
    that their form in float adds."""
    found: dict[str, dict[str, Any]] = {}
    for precision in ("double", "float"):  # Joseph's form and UD
        built = out / precision
        built.mkdir()
        objects = compile_units(folder, GCC, precision, built)
        common = ["gcc", "-std=c99", "-O1", "-w", "-ffunction-sections", *PRECISIONS[precision], "-I", folder.include]
        tests = compile_sources(
            [*common, "-I", folder.path / "selftest"],
            dict.fromkeys([*folder.files("selftest/*.c"), *folder.identity], ()),
            built,
        )
        run(["objcopy", "--redefine-sym=main=shipped_main", tests["selftest"]])
        for unit in folder.chosen(names):
            if unit.test.is_file() and not unit.elementary and (precision == "double" or unit.described is None):
                if flies(unit.test):
                    here = run_on_host(build(folder, GCC, precision, built), [unit.name])[unit.name]
                    test = built / unit.test.name
                    test.write_text(with_flight(unit.test.read_text(), {precision: from_words(here.outputs[-1])}))
                    tests |= compile_sources([*common, "-I", folder.path / "selftest"], {test: ()}, built)
                of = of_unit(unit, objects, list(tests.values()), built, most, precision)
                before = found.get(unit.name)
                found[unit.name] = {key: before[key] + value for key, value in of.items()} if before else of
    return found


def of_unit(
    unit: Source, objects: dict[str, Path], tests: list[Path], out: Path, most: int, precision: str
) -> dict[str, Any]:
    text, words, count = mutated(unit, most, precision)
    source, made, program = out / "mutated.c", out / "mutated.o", out / "mutants"
    source.write_text(text)
    run(["gcc", *FLAGS, *PRECISIONS[precision], "-c", source, "-o", made])
    others = {name: path for name, path in objects.items() if name != unit.name}
    harness = ["gcc", "-std=gnu99", "-O1", "-fno-builtin", f"-DEVIDENCE_TEST={unit.test_function}"]
    parts = [HARNESS / "mutants.c", HARNESS / "quiet.c", made, *others.values(), *tests]
    run([*harness, "-Wl,--gc-sections", *parts, "-lm", "-o", program])
    verdicts = run([program, len(words)])
    if len(verdicts) != len(words):
        raise BoresightError(f"{unit.name}: {len(verdicts)} verdicts for {len(words)} mutants")
    survivors = [i for i, verdict in enumerate(verdicts) if verdict == "0"]
    if unit.described:
        alike = set(equivalent(unit, {**others, unit.name: made}, survivors, out))
    else:
        implied = implied_by_norms(unit)
        alike = {i for i in survivors if SUFFIX.sub("", words[i].split(": ")[1].split(", in `")[0]) in implied}
        words = [word if precision == "double" else f"{precision}: {word}" for word in words]
    return {
        "candidates": count,
        "tried": len(words),
        "killed": verdicts.count("1"),
        "equivalent": len(alike),
        "survivors": [words[i] for i in survivors if i not in alike],
    }


def equivalent(unit: Source, objects: dict[str, Path], survivors: list[int], out: Path) -> Iterator[int]:
    """Those survivors that give the unit's own bits and status at every point."""
    if not survivors:
        return
    extra = out / "number.c"
    extra.write_text("int evidence_mutant = -1;\n")
    run(["gcc", "-fPIC", "-c", extra, "-o", out / "number.o"])
    image = shared_library(unit.folder, "double", out, objects | {"number": out / "number.o"})
    image = image.rename(out / f"equivalent-{unit.name}.so")  # a library is loaded once by its name
    compiled = callable_units(unit.folder, image, "double")[unit.name]
    number = ctypes.c_int.in_dll(compiled.library.dll, "evidence_mutant")
    rng = generator("equivalence", unit.name)
    points = [points_of(unit, POINTS, CORNERS, rng), edges(unit, rng)]
    number.value = -1
    expected = [bits(compiled, at) for at in points]
    for mutant in survivors:
        number.value = mutant
        if all(bits(compiled, at) == was for at, was in zip(points, expected, strict=True)):
            yield mutant


def implied_by_norms(unit: Source) -> set[str]:
    """Mutants that move outward a component's bound at which the range of the norm ends, in words."""
    fields = [field for struct in unit.folder.manifest.get("structs", {}).values() for field in struct if field["norm"]]
    ends = {f["norm"][1] for f in fields if {-low for low in f["low"]} | set(f["high"]) == {f["norm"][1]}}
    return {f"{end!r} * {1 + OFF}" for end in ends}


def bits(compiled: Unit, points: Points) -> list[bytes]:
    outputs, status = call(compiled, points)
    return [array.tobytes() for array in (*outputs, status)]


def edges(unit: Source, rng: np.random.Generator) -> Points:
    """Points with one number, or one norm, half of OFF inside and outside an end of its range."""
    base = points_of(unit, 1, 0, rng)
    rows: list[Points] = []
    for _, field in layout(unit):
        for share in (1 - OFF / 2, 1 + OFF / 2):
            for ends in (field["low"], field["high"]):
                for i, end in enumerate(ends):
                    point = {name: value.copy() for name, value in base.items()}
                    point[field["name"]][0, i] = end * share
                    rows.append(point)
            for norm in field["norm"] or ():
                point = {name: value.copy() for name, value in base.items()}
                point[field["name"]] *= norm * share / np.linalg.norm(point[field["name"]])
                rows.append(point)
    return {name: np.vstack([row[name] for row in rows]) for name in base}
