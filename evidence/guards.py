"""Bad input: every number of every field NaN, infinite, or outside its box; every pointer null.

The status must say so, no output may be touched, and every branch of the guards must have been taken.  A point of the
box may be refused as not finite only where the function has no value by its formulas in 50 digits, as when a step leads
through a root of what is negative.
"""

import ctypes
import json
import subprocess
from collections.abc import Callable, Collection
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from boresight.codegen.folder import Folder, Source
from boresight.codegen.functions.samples import generator
from boresight.codegen.functions.units import units
from boresight.codegen.generate import load_model
from boresight.evidence.calls import Points, call, callable_units, layout, points_of
from boresight.evidence.mutants import lines_of
from boresight.evidence.targets import GCC, HARNESS, PRECISIONS, WARNINGS, plain
from boresight.runtime.compiler import compile_sources, run
from boresight.runtime.library import Unit
from boresight.runtime.status import Status

BEYOND = 1e-4  # how far outside its box a number is put, as a part of the end of the box or of its width
TINY = 1e-60  # for zero, which in balls hides what it multiplies
TRIED = 100  # points without an answer at which the formulas are evaluated
POINTS = 4000  # random points, so that results outside their own box are met too
PAINT = -1.2345678e30


def guards(folder: Folder, out: Path, names: Collection[str] | None = None) -> dict[str, dict[str, Any]]:
    """By unit: bad inputs tried, those that were not refused as they should, and branches that
    neither they nor the unit's self-test takes."""
    found: dict[str, dict[str, Any]] = {}
    for precision in PRECISIONS:
        place = out / precision
        place.mkdir(parents=True, exist_ok=True)
        common = [*GCC.flags, *PRECISIONS[precision], "-I", folder.include]
        covered = ["gcc", *common, *WARNINGS, "-O0", "--coverage"]
        objects = compile_sources(covered, {unit.path: () for unit in folder.units}, place)
        plain = ["gcc", *common, "-std=c99", "-O1", "-w", "-ffunction-sections", "-I", folder.path / "selftest"]
        # in the same process the counts have to be begun and asked for
        dump = place / "dump.c"
        calls = [f"void __gcov_{what}(void);\nvoid {what}(void);\nvoid {what}(void)\n{{\n    __gcov_{what}();\n}}\n"
                 for what in ("reset", "dump")]  # fmt: skip
        dump.write_text("".join(calls))
        more = [*folder.files("batch/*.c"), *folder.files("selftest/*.c"), *folder.identity, dump]
        tests = compile_sources(plain, {**dict.fromkeys(more, ()), HARNESS / "quiet.c": ("-fno-builtin",)}, place)
        image = place / f"{folder.name}-guards-{precision}.so"
        link = ["gcc", "-shared", "-Wl,-Bsymbolic", "--coverage", *GCC.flags]
        run([*link, *objects.values(), *tests.values(), "-lm", "-o", image])
        library = ctypes.CDLL(str(image))
        compiled = {} if "component" in folder.manifest else callable_units(folder, image, precision)
        for unit in folder.chosen(names):
            library.reset()
            entry = found.setdefault(unit.name, {"tried": 0, "wrong": [], "not_taken": []})
            if unit.name in compiled:
                tried, wrong, left = bad_inputs(unit, compiled[unit.name])
                entry["tried"] += tried
                entry["wrong"] += wrong
                if left:
                    entry["no_value"] = [*entry.get("no_value", ()), f"{precision}, {left}"]
            if unit.test.is_file():
                getattr(library, unit.test_function)()
            library.dump()
            entry["not_taken"] += [f"{precision}, {where}" for where in not_taken(unit, place)]
            for counts in place.glob("*.gcda"):
                counts.unlink()
    return found


@cache
def formulas(target: str) -> dict[str, Callable[..., list[Any]]]:
    """By function of a model its formulas in 50 digits, of fields."""
    return {unit.name: unit.reference for unit in units(load_model(target))}


def with_value(unit: Source, good: Points, at: np.ndarray, real: Any) -> int:
    """At how many of the first points that were refused as not finite the formulas have a value."""
    assert unit.described is not None
    of = formulas(unit.folder.target)[unit.described["name"]]
    found = 0
    for k in at[:TRIED]:
        point = {name: values[k].astype(real).astype(float) for name, values in good.items()}
        results = of({name: np.where(value == 0, TINY, value).tolist() for name, value in point.items()})
        found += all(entry.is_finite() for result in results for entry in result.values())
    return found


def bad_inputs(unit: Source, compiled: Unit) -> tuple[int, list[str], str]:
    """How many bad inputs were tried, what was wrong with the answers, and of how much of the box there is none."""
    rng = generator("guards", unit.name)
    good = points_of(unit, POINTS, 64, rng)
    outputs, status = call(compiled, good, PAINT)
    known = {Status.OK, Status.OUT_OF_RANGE, Status.NOT_FINITE}
    wrong = [f"status {code} inside the box" for code in sorted(set(status.tolist()) - known)]
    refused = np.flatnonzero(status == Status.NOT_FINITE)
    left = f"{len(refused)} of {POINTS} points of the box: there is no value, BS_NOT_FINITE" if len(refused) else ""
    if len(refused) and (more := with_value(unit, good, refused, outputs[0].dtype)):
        wrong.append(f"{more} points of the box that have a value are refused as not finite")
    answered = np.flatnonzero(status == Status.OK)
    if not len(answered):
        return 0, [*wrong, "no point of the box has an answer"], left
    base = {name: values[answered[:1]] for name, values in good.items()}
    cases: list[tuple[Points, Status, str]] = []

    def case(field: str, column: int | slice, value: Any, expected: Status, what: str) -> None:
        point = {name: values.copy() for name, values in base.items()}
        point[field][0, column] = value
        cases.append((point, expected, what))

    for struct, field in layout(unit):
        name, whole = field["name"], slice(None)
        if name not in compiled.fields:
            continue
        for i, (low, high) in enumerate(zip(field["low"], field["high"], strict=True)):
            what = f"{struct} {name}[{i}]"
            below = low - BEYOND * (abs(low) or high - low)
            above = high + BEYOND * (abs(high) or high - low)
            for value in (np.nan, -np.nan, np.inf, -np.inf):
                case(name, i, value, Status.NOT_FINITE, f"{what} {value}")
            for value in (below, above, -3e38, 3e38):
                case(name, i, value, Status.OUT_OF_RANGE, f"{what} {value}")
        for norm in field["norm"] or ():
            for sign in (-1, 1):
                share = norm * (1 + sign * BEYOND)
                expected = Status.OK if field["norm"][0] <= share <= field["norm"][1] else Status.OUT_OF_RANGE
                direction = base[name][0] / np.linalg.norm(base[name][0])
                case(name, whole, direction * share, expected, f"{struct} {name} of norm {share}")
        if field["norm"]:
            case(name, whole, 0.0, Status.OUT_OF_RANGE, f"{struct} {name} of norm 0")
    if cases:
        points = {name: np.vstack([point[name] for point, _, _ in cases]) for name in base}
        outputs, status = call(compiled, points, PAINT)
        painted = np.all([(array == array.dtype.type(PAINT)).all(axis=1) for array in outputs], axis=0)
        for k, (_, expected, what) in enumerate(cases):
            if status[k] != expected:
                wrong.append(f"{what}: status {status[k]}, not {expected}")
            if status[k] != Status.OK and not painted[k]:
                wrong.append(f"{what}: an output was touched")
    nulls, of_nulls = null_pointers(compiled, base)
    return len(cases) + nulls, wrong + of_nulls, left


def null_pointers(unit: Unit, base: Points) -> tuple[int, list[str]]:
    """The unit's functions themselves, dense and non-zeros alone, each of their pointers null in turn."""
    given = [array for array, _ in unit.library.pack(unit.structs, base, (1,))]
    outputs, dll = unit.outputs(1), unit.library.dll
    tried, wrong = 0, []
    ending = "_f32" if unit.library.precision == "float" else ""
    for name in (unit.described["c_name"] + ending, unit.described["c_name"] + "_nz" + ending):
        if not hasattr(dll, name):
            continue
        for k in range(len(given) + len(outputs)):
            for output in outputs:
                output.fill(PAINT)
            pointers = [ctypes.c_void_p(array.ctypes.data) for array in (*given, *outputs)]
            pointers[k] = ctypes.c_void_p(None)
            status = getattr(dll, name)(*pointers)
            tried += 1
            if status != Status.NULL_POINTER or any((array != array.dtype.type(PAINT)).any() for array in outputs):
                wrong.append(f"{name}, argument {k} null: status {status}, or an output was touched")
    return tried, wrong


def not_taken(unit: Source, place: Path) -> list[str]:
    """Branches and lines of the unit's C file, its kernel apart, that nothing has taken."""
    done = subprocess.run(
        ["gcov", "--json-format", "--stdout", "--branch-probabilities", f"{unit.name}.gcda"],
        cwd=place, capture_output=True, text=True, check=True,
    )  # fmt: skip
    found = []
    for file in json.loads(done.stdout.splitlines()[0])["files"]:
        path = Path(file["file"])
        own = path.name == unit.path.name
        if not own and path.name != "boresight.h":
            continue
        for line in file["lines"]:
            function = plain(str(line.get("function_name")))
            where = f"{function}: `{lines_of(str(path))[line['line_number'] - 1]}`"
            if own and line["count"] == 0:
                found.append(f"{where} is not reached")
            # the header's guards are judged where they are called with a box: in the unit that has one
            elif own and any(branch["count"] == 0 for branch in line["branches"]):
                missing = sum(branch["count"] == 0 for branch in line["branches"])
                found.append(f"{where}: {missing} of {len(line['branches'])} branches")
            elif not own and function == "bs_check" and line["count"]:
                found += [where for b in line["branches"] if b["count"] == 0]
    return found
