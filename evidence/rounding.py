"""Rounding in single precision: a bound on every output along the instruction list, held against the C in float.

The bound is a running one: at each point it follows every rounding of the printed list, and it holds there.  The C in
float runs at 1e5 random points of the box and at corners; no error may exceed the bound at its point.
"""

from collections.abc import Collection
from pathlib import Path
from typing import Any

import numpy as np

from boresight.codegen.folder import Folder, Source
from boresight.codegen.functions.samples import generator
from boresight.codegen.functions.tape import evaluate
from boresight.codegen.functions.unit import Unit
from boresight.codegen.functions.units import units
from boresight.codegen.generate import load_model
from boresight.evidence.calls import call, callable_units, points_of, shared_library
from boresight.runtime.library import Unit as CompiledUnit

RUNS, CORNERS, CHUNK = 100_000, 2_000, 4_000


def rounding(folder: Folder, out: Path, names: Collection[str] | None = None) -> dict[str, dict[str, Any]]:
    """By printed unit: runs, violations of the bound, and of each output what `of_unit` gives; no component has any."""
    if folder.manifest.get("component"):
        return {}
    model = load_model(folder.target)
    made = {unit.name: unit for unit in units(model)}
    compiled = callable_units(folder, shared_library(folder, "float", out), "float")
    return {
        source.name: of_unit(source, made[source.described["name"]], compiled[source.name])
        for source in folder.chosen(names)
        if source.described is not None
    }


def of_unit(source: Source, unit: Unit, compiled: CompiledUnit) -> dict[str, Any]:
    """`outputs`: result, row, column, and over all runs its largest size, largest bound and largest error.

    `loose`: the median of bound over error, of the outputs that err at all.  `relative`: the largest bound, as a part
    of the largest number of the same matrix.
    """
    rng = generator("rounding", source.name)
    results = unit.tape.results
    largest, bound, error = (np.zeros(len(results)) for _ in range(3))
    runs = violations = drawn = 0
    while runs < RUNS and drawn < 3 * RUNS:
        points = points_of(source, CHUNK, CORNERS if drawn == 0 else 0, rng) if unit.args else {}
        points = {name: values.astype(np.float32).astype(float) for name, values in points.items()}
        drawn += CHUNK
        outputs, status = call(compiled, points)
        inputs = [points[arg.name] for arg in unit.args]
        values, floats = evaluate(unit.tape, inputs, np.float32)
        _, doubles = evaluate(unit.tape, inputs)
        keep = (status == 0) & np.isfinite(np.array(floats)).all(axis=0)
        for i, (o, nz, _) in enumerate(results):
            result = unit.results[o]
            row, column = result.nonzeros[nz]
            got = outputs[o][keep, row * result.shape[1] + column].astype(float)
            value, most = (np.broadcast_to(x, status.shape)[keep] for x in (values[i], floats[i] + doubles[i]))
            off = np.abs(got - value)
            if row in result.angle or result.unit == "rad":
                off = np.minimum(off, np.abs(off - 2 * np.pi))  # an angle goes round
            violations += int((~(off <= most)).sum())
            if len(off):
                largest[i] = max(largest[i], np.abs(value).max())
                bound[i], error[i] = max(bound[i], most.max()), max(error[i], off.max())
        runs += int(keep.sum())
        if not unit.args:
            break
    scale = {o: max(largest[i] for i, (other, _, _) in enumerate(results) if other == o) for o, _, _ in results}
    moved = error > 0
    return {
        "runs": runs,
        "drawn": drawn if unit.args else 1,
        "violations": violations,
        "relative": rounded(max(bound[i] / (scale[o] or 1) for i, (o, _, _) in enumerate(results))),
        "loose": rounded(np.median(bound[moved] / error[moved])) if moved.any() else None,
        "outputs": [
            [unit.results[o].name, *unit.results[o].nonzeros[nz], *map(rounded, (largest[i], bound[i], error[i]))]
            for i, (o, nz, _) in enumerate(results)
        ],
    }


def rounded(value: float) -> float:
    """Three digits are enough to print."""
    return float(f"{float(value):.3g}")
