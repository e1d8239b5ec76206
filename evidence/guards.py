"""Bad input: every number of every field NaN, infinite, or outside its box; every pointer null.

The status must say so, no output may be touched, and every branch of the guards must have been taken.
"""

import ctypes
import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np

from boresight.codegen.functions.samples import generator
from boresight.evidence.calls import Caller, Points, layout, points_of
from boresight.evidence.sources import Folder, Source
from boresight.evidence.targets import GCC, HARNESS, PRECISIONS, WARNINGS, run

OK, NULL_POINTER, NOT_FINITE, OUT_OF_RANGE = 0, 1, 2, 3
BEYOND = 1e-4  # how far outside its box a number is put, as a part of the end of the box or of its width
POINTS = 4000  # random points, so that results outside their own box are met too
PAINT = -1.2345678e30
DUMP = "void __gcov_dump(void);\nvoid dump(void);\nvoid dump(void) { __gcov_dump(); }\n"


def guards(folder: Folder, out: Path) -> dict[str, dict[str, Any]]:
    """By unit: bad inputs tried, those that were not refused as they should, and branches not taken."""
    found: dict[str, dict[str, Any]] = {}
    for precision in PRECISIONS:
        place = out / precision
        place.mkdir(parents=True, exist_ok=True)
        covered: list[object] = [
            *GCC.flags,
            *WARNINGS,
            *PRECISIONS[precision],
            "-O0",
            "--coverage",
            "-I",
            folder.include,
        ]
        for unit in folder.units:
            run(["gcc", *covered, "-c", unit.path, "-o", place / f"{unit.name}.o"], cwd=place)
        image = place / f"{folder.name}-guards-{precision}.so"
        plain: list[object] = [*GCC.flags, "-std=c99", "-O1", "-w", "-ffunction-sections", *PRECISIONS[precision]]
        plain += ["-I", folder.include, "-I", folder.path / "selftest"]
        tests = []
        for path in [*folder.files("batch/*.c"), *folder.files("selftest/*.c")]:
            tests.append(place / f"extra-{path.stem}.o")
            run(["gcc", *plain, "-c", path, "-o", tests[-1]])
        tests.append(place / "quiet.o")
        run(["gcc", *plain, "-fno-builtin", "-c", HARNESS / "quiet.c", "-o", tests[-1]])
        # after a run in the same process the counts have to be asked for
        (place / "dump.c").write_text(
            "void __gcov_dump(void);\nvoid dump(void);\nvoid dump(void)\n{\n    __gcov_dump();\n}\n"
        )
        objects = [place / f"{unit.name}.o" for unit in folder.units]
        run(
            [
                "gcc",
                "-shared",
                "-Wl,-Bsymbolic",
                "--coverage",
                *GCC.flags,
                place / "dump.c",
                *objects,
                *tests,
                "-lm",
                "-o",
                image,
            ]
        )
        library = ctypes.CDLL(str(image))
        for unit in folder.units:
            tried, wrong = (0, []) if unit.described is None else bad_inputs(library, unit, precision)
            entry = found.setdefault(unit.name, {"tried": 0, "wrong": [], "not_taken": []})
            entry["tried"] += tried
            entry["wrong"] += wrong
            if unit.test.is_file():
                getattr(library, unit.test_function)()
        library.dump()
        for unit in folder.units:
            for where in not_taken(unit, place):
                found[unit.name]["not_taken"].append(f"{precision}, {where}")
    return found


def bad_inputs(library: ctypes.CDLL, unit: Source, precision: str) -> tuple[int, list[str]]:
    """How many bad inputs were tried, and what was wrong with the answers."""
    caller = Caller(library, unit, precision)
    rng = generator("guards", unit.name)
    good = points_of(unit, POINTS, 64, rng)
    outputs, status = caller(good, PAINT)
    wrong = [f"status {code} inside the box" for code in sorted(set(status.tolist()) - {OK, OUT_OF_RANGE})]
    answered = np.flatnonzero(status == OK)
    if not len(answered):
        return 0, [*wrong, "no point of the box has an answer"]
    base = {name: values[answered[:1]] for name, values in good.items()}
    cases: list[tuple[Points, int, str]] = []

    def case(struct: str, column: int | slice, value: Any, expected: int, what: str) -> None:
        point = {name: values.copy() for name, values in base.items()}
        point[struct][0, column] = value
        cases.append((point, expected, what))

    assert unit.described is not None
    for struct, start, field in layout(unit):
        if field["name"] not in unit.described["fields"]:
            continue
        whole = slice(start, start + field["size"])
        for i, (low, high) in enumerate(zip(field["low"], field["high"], strict=True)):
            what = f"{struct} {field['name']}[{i}]"
            below = low - BEYOND * (abs(low) or high - low)
            above = high + BEYOND * (abs(high) or high - low)
            for value in (np.nan, -np.nan, np.inf, -np.inf):
                case(struct, start + i, value, NOT_FINITE, f"{what} {value}")
            for value in (below, above, -3e38, 3e38):
                case(struct, start + i, value, OUT_OF_RANGE, f"{what} {value}")
        for norm in field["norm"] or ():
            for sign in (-1, 1):
                share = norm * (1 + sign * BEYOND)
                expected = OK if field["norm"][0] <= share <= field["norm"][1] else OUT_OF_RANGE
                direction = base[struct][0, whole] / np.linalg.norm(base[struct][0, whole])
                case(struct, whole, direction * share, expected, f"{struct} {field['name']} of norm {share}")
        if field["norm"]:
            case(struct, whole, 0.0, OUT_OF_RANGE, f"{struct} {field['name']} of norm 0")
    if cases:
        points = {name: np.vstack([point[name] for point, _, _ in cases]) for name in base}
        outputs, status = caller(points, PAINT)
        painted = np.array([[(array[k] == caller.real(PAINT)).all() for array in outputs] for k in range(len(cases))])
        for k, (_, expected, what) in enumerate(cases):
            if status[k] != expected:
                wrong.append(f"{what}: status {status[k]}, not {expected}")
            if status[k] != OK and not painted[k].all():
                wrong.append(f"{what}: an output was touched")
    nulls, more = null_pointers(library, unit, base, caller)
    return len(cases) + nulls, wrong + more


def null_pointers(library: ctypes.CDLL, unit: Source, base: Points, caller: Caller) -> tuple[int, list[str]]:
    """The unit's functions themselves, dense and non-zeros alone, each of their pointers null in turn."""
    given = [np.ascontiguousarray(base[name], dtype=caller.real) for name in caller.structs]
    outputs = [np.full(int(np.prod(r["shape"])), PAINT, dtype=caller.real) for r in caller.results]
    tried, wrong = 0, []
    for name in (caller.described["c_name"], caller.described["c_name"] + "_nz"):
        if not hasattr(library, name):
            continue
        for k in range(len(given) + len(outputs)):
            pointers = [array.ctypes.data_as(ctypes.c_void_p) for array in (*given, *outputs)]
            pointers[k] = ctypes.c_void_p(None)
            status = getattr(library, name)(*pointers)
            tried += 1
            if status != NULL_POINTER or any((array != caller.real(PAINT)).any() for array in outputs):
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
            if own and line["count"] == 0:
                found.append(f"line {line['line_number']} is not reached")
            # the header's guards are judged where they are called with a box: in the unit that has one
            elif own and any(branch["count"] == 0 for branch in line["branches"]):
                missing = sum(branch["count"] == 0 for branch in line["branches"])
                found.append(f"line {line['line_number']}: {missing} of {len(line['branches'])} branches")
            elif not own and line.get("function_name") == "bs_check" and line["count"]:
                found += [f"bs_check, line {line['line_number']}" for b in line["branches"] if b["count"] == 0]
    return found
