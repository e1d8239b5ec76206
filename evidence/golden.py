"""The shipped golden vectors on this machine, by gcc and clang, and on emulated Cortex-M4F and M7: verdicts, bits,
instructions, stack.  A warning of any of the three compilers is an error.

The elementary functions are our own, so that every unit must have the same bits on every target, but in double on a
Cortex-M4F.
"""

import re
from collections.abc import Collection
from pathlib import Path
from typing import Any

from boresight.codegen.flight import flies, from_words
from boresight.codegen.folder import Folder
from boresight.evidence.machine import Cost, Machine
from boresight.evidence.targets import (
    CLANG,
    CORES,
    GCC,
    PRECISIONS,
    Build,
    Run,
    build,
    doubles,
    plain,
    public_functions,
    run_on_host,
    same_bits,
    text_size,
    ulps_apart,
)

SOFT_ULPS = 4.0  # double on a Cortex-M4F: the addition of its soft-float library rounds some sums wrongly
VECTORS = re.compile(r"^#define N_VECTORS (\d+)$", re.MULTILINE)


def golden(folder: Folder, out: Path, names: Collection[str] | None = None) -> dict[str, dict[str, Any]]:
    """By unit: what its golden vectors did on each target, what it costs there, and the double it holds in float.

    `builds` has one entry a target and precision, `cortex-m4f float` and so on: failures of the shipped self-test,
    whether all bits are those of this machine, by how many ulps they differ.  `classes`, of the dearest call, has words
    loaded and stored, divisions, square roots; and of a Cortex-M4F a bound in cycles.
    """
    found: dict[str, dict[str, Any]] = {
        unit.name: {
            "operations": unit.operations,
            "vectors": vectors(unit.test),
            "builds": {},
            "doubles": [],
            "cost": {},
            "classes": {},
            "text": {},
        }
        for unit in folder.chosen(names)
    }
    for precision in PRECISIONS:
        here = run_on_host(build(folder, GCC, precision, out), found)
        note(found, f"x86-64 {precision}", here, here)
        for one in folder.chosen(names):
            if flies(one.test):
                found[one.name].setdefault("flown", {})[precision] = from_words(here[one.name].outputs[-1])
        note(found, f"{CLANG.name} {precision}", run_on_host(build(folder, CLANG, precision, out), found), here)
        for core in CORES:
            made = build(folder, core, precision, out)
            name = f"{core.name} {precision}"
            # soft-float helpers branch on the numbers: what they cost is no property of the unit
            counted = core.double or precision == "float"
            there, costs = run_with_costs(made, found) if counted else (Machine(made, made.image).run_tests(found), {})
            note(found, name, there, here if core.double or precision == "float" else without_flight(folder, here))
            for unit, of in found.items():
                of["text"][name] = text_size(made.objects[unit])
                for function, cost in costs.get(unit, {}).items():
                    name_of = plain(function)
                    of["cost"].setdefault(name_of, {})[name] = [cost.most, cost.stack]
                    classes = [cost.loads, cost.stores, cost.divisions, cost.roots]
                    classes += [] if core.double else [cost.cycles]  # Arm has published no table for a Cortex-M7
                    of["classes"].setdefault(name_of, {})[name] = classes
            if precision == "float":
                for stem, words in doubles(made, found).items():
                    found[stem]["doubles"] += [f"{name}: {word}" for word in words]
    return found


def without_flight(folder: Folder, here: dict[str, Run]) -> dict[str, Run]:
    """But for the bits of what is flown, which a build with BORESIGHT_OTHER_BITS does not compare."""
    flying = {unit.name for unit in folder.units if flies(unit.test)}
    return {
        name: Run(run.failures, run.outputs[:-1] or [run.outputs[-1][:0]]) if name in flying else run
        for name, run in here.items()
    }


def faults(unit: str, of: dict[str, Any]) -> list[str]:
    """What may not be, in words, of what `golden` found of one unit."""
    wrong = [f"{unit}: {word}" for word in of["doubles"]]
    wrong += [f"{unit} has no self-test"] * (not of["builds"])
    for where, was in of["builds"].items():
        soft = where == "cortex-m4f double"
        if was["failures"]:
            wrong.append(f"{unit} on {where}: {was['failures']} failures of its self-test")
        if not (was["bits"] or soft) or was["ulps"] > (SOFT_ULPS if soft else 0):
            wrong.append(f"{unit} on {where}: other bits than here, {was['ulps']} ulps apart")
    return wrong


def vectors(test: Path) -> int | None:
    match = VECTORS.search(test.read_text()) if test.is_file() else None
    return int(match[1]) if match else None


def run_with_costs(made: Build, names: Collection[str]) -> tuple[dict[str, Run], dict[str, dict[str, Cost]]]:
    """What these units' tests did, and of each unit what its functions cost in its own test."""
    public = {name: public_functions(path) for name, path in made.objects.items()}
    machine = Machine(made, made.image, tuple(function for of in public.values() for function in of))
    runs: dict[str, Run] = {}
    costs: dict[str, dict[str, Cost]] = {}
    for name in names:
        machine.costs = {}
        runs |= machine.run_tests([name])
        costs[name] = {function: machine.costs[function] for function in public[name] if function in machine.costs}
    return runs, costs


def note(found: dict[str, dict[str, Any]], name: str, there: dict[str, Run], here: dict[str, Run]) -> None:
    for unit, done in there.items():
        found[unit]["builds"][name] = {
            "failures": done.failures,
            "bits": same_bits(done, here[unit]),
            "ulps": ulps_apart(done, here[unit]),
        }
