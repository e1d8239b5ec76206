"""A printed unit called at many points of its box at once, whatever its folder's C was compiled for."""

import ctypes
from pathlib import Path
from typing import Any

import numpy as np

from boresight.codegen.folder import Folder, Source
from boresight.evidence.targets import GCC, PRECISIONS, compile_units
from boresight.runtime.compiler import run
from boresight.runtime.library import Library, Unit

Points = dict[str, np.ndarray]  # field -> (points, size)


def shared_library(folder: Folder, precision: str, out: Path, objects: dict[str, Path] | None = None) -> Path:
    """The folder's units and their batch forms for this machine; `objects` in place of compiled units, if given."""
    objects = objects or compile_units(folder, GCC, precision, out)
    image = out / f"{folder.name}-{precision}.so"
    batch = folder.files("batch/*.c")
    flags = [*GCC.flags, "-std=c99", "-O2", "-ffp-contract=off", *PRECISIONS[precision], "-I", folder.include]
    run(["gcc", "-shared", *flags, *batch, *objects.values(), "-lm", "-o", image])
    return image


def callable_units(folder: Folder, image: Path, precision: str) -> dict[str, Unit]:
    """The printed units of a shared library of this folder, by the name of their source."""
    library = Library(folder.manifest, ctypes.CDLL(str(image)), precision)
    return {unit.described["file"]: unit for unit in library.units.values()}


def call(unit: Unit, points: Points, paint: float = np.nan) -> tuple[list[np.ndarray], np.ndarray]:
    """Each result, (points, rows * columns), full of `paint` where nothing was written; and the status of each."""
    count = len(next(iter(points.values()))) if points else 1
    outputs = unit.outputs(count)
    for output in outputs:
        output.fill(paint)
    _, status = unit.evaluate(points, (count,), outputs)
    return outputs, status


def layout(unit: Source) -> list[tuple[str, dict[str, Any]]]:
    """(struct, the manifest's field) of every field of the structs that are read, one after another."""
    assert unit.described is not None
    return [
        (struct, field) for struct in unit.described["structs"] for field in unit.folder.manifest["structs"][struct]
    ]


def points_of(unit: Source, count: int, corners: int, rng: np.random.Generator) -> Points:
    """Points of the box, the first of them its corners; a field with a norm is scaled to within its range."""
    points: Points = {}
    for _, field in layout(unit):
        low, high = np.array(field["low"]), np.array(field["high"])
        share = np.vstack([rng.integers(0, 2, (corners, len(low))), rng.random((count - corners, len(low)))])
        values = low * (1 - share) + high * share
        if field["norm"] is not None:
            least, most = field["norm"]
            length = np.linalg.norm(values, axis=1, keepdims=True)
            wanted = least + (most - least) * rng.uniform(0.05, 0.95, (count, 1))
            values = np.clip(np.divide(values, length, out=values, where=length > 0) * wanted, low, high)
        points[field["name"]] = values
    return points
