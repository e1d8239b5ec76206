"""The shipped golden vectors on this machine, by gcc and clang, and on emulated Cortex-M4F and M7: verdicts, bits,
instructions, stack.  A warning of any of the three compilers is an error.

The same objects are linked a second time with sines of the same few operations everywhere: then no library function
stands between two machines, and their bits must agree for every unit.
"""

import re
from pathlib import Path
from typing import Any

from boresight.evidence.machine import Cost, Machine
from boresight.evidence.sources import Folder
from boresight.evidence.targets import (
    CLANG,
    CORES,
    GCC,
    PRECISIONS,
    Build,
    Run,
    build,
    doubles,
    public_functions,
    run_on_host,
    same_bits,
    text_size,
    ulps_apart,
    ulps_each,
)

LIBM_ULPS = 40.0  # between two machines, in units of the last place of an output's largest number
SOFT_ULPS = 4.0  # double on a Cortex-M4F: the addition of its soft-float library rounds some sums wrongly
VECTORS = re.compile(r"^#define N_VECTORS (\d+)$", re.MULTILINE)


def allowed_ulps(build_name: str, calls_libm: bool) -> float:
    """How far a unit's outputs may be from those of this machine."""
    return max(LIBM_ULPS if calls_libm else 0.0, SOFT_ULPS if build_name == "cortex-m4f double" else 0.0)


def golden(folder: Folder, out: Path) -> dict[str, dict[str, Any]]:
    """By unit: what its golden vectors did on each target, what it costs there, and the double it holds in float.

    `builds` has one entry a target and precision, `cortex-m4f float` and so on: failures of the shipped self-test,
    whether all bits are those of this machine, by how many ulps they differ, both also with the same sines.
    """
    found: dict[str, dict[str, Any]] = {
        unit.name: {
            "operations": unit.operations,
            "libm": unit.calls_libm,
            "vectors": vectors(unit.test),
            "builds": {},
            "doubles": [],
            "cost": {},
            "text": {},
        }
        for unit in folder.units
    }
    for precision in PRECISIONS:
        host = build(folder, GCC, precision, out)
        here, here_same = run_on_host(host, host.image), run_on_host(host, host.same)
        note(found, f"x86-64 {precision}", here, here, here_same, here_same)
        other = build(folder, CLANG, precision, out)
        there, there_same = run_on_host(other, other.image), run_on_host(other, other.same)
        note(found, f"{CLANG.name} {precision}", there, here, there_same, here_same)
        for core in CORES:
            made = build(folder, core, precision, out)
            name = f"{core.name} {precision}"
            # soft-float helpers branch on the numbers: what they cost is no property of the unit
            costs, there = run_with_costs(made) if core.double or precision == "float" else ({}, plain_run(made))
            note(found, name, there, here, Machine(made, made.same).run_tests(), here_same)
            for unit in folder.units:
                found[unit.name]["text"][name] = text_size(made.objects[unit.name])
                for function in public_functions(made.objects[unit.name]):
                    if function in costs:
                        cost = costs[function]
                        found[unit.name]["cost"].setdefault(function.removesuffix("_f32"), {})[name] = [
                            cost.most,
                            cost.stack,
                        ]
            if precision == "float":
                for stem, words in doubles(made).items():
                    found[stem]["doubles"] += [f"{name}: {word}" for word in words]
    return found


def faults(unit: str, of: dict[str, Any]) -> list[str]:
    """What may not be, in words, of what `golden` found of one unit."""
    wrong = [f"{unit}: {word}" for word in of["doubles"]]
    wrong += [f"{unit} has no self-test"] * (not of["builds"])
    for where, was in of["builds"].items():
        soft = where == "cortex-m4f double"
        if was["failures"]:
            wrong.append(f"{unit} on {where}: {was['failures']} failures of its self-test")
        if not (was["same_bits"] or soft) or was["same_ulps"] > (SOFT_ULPS if soft else 0):
            wrong.append(f"{unit} on {where}: other bits than here with the same sines")
        if was["ulps"] > allowed_ulps(where, of["libm"]) or not (was["bits"] or of["libm"] or soft):
            wrong.append(f"{unit} on {where}: {was['ulps']} ulps from here")
    return wrong


def vectors(test: Path) -> int | None:
    match = VECTORS.search(test.read_text()) if test.is_file() else None
    return int(match[1]) if match else None


def plain_run(made: Build) -> dict[str, Run]:
    return Machine(made, made.image).run_tests()


def run_with_costs(made: Build) -> tuple[dict[str, Cost], dict[str, Run]]:
    watched = tuple(name for path in made.objects.values() for name in public_functions(path))
    machine = Machine(made, made.image, watched)
    runs = machine.run_tests()
    return machine.costs, runs


def note(
    found: dict[str, dict[str, Any]],
    name: str,
    there: dict[str, Run],
    here: dict[str, Run],
    there_same: dict[str, Run],
    here_same: dict[str, Run],
) -> None:
    for unit, done in there.items():
        found[unit]["builds"][name] = {
            "failures": done.failures,
            "bits": same_bits(done, here[unit]),
            "ulps": ulps_apart(done, here[unit]),
            "same_bits": same_bits(there_same[unit], here_same[unit]),
            "same_ulps": ulps_each(there_same[unit], here_same[unit]),
        }
