"""A printed unit called at many points at once, through the batch form that the generated folder brings along."""

import ctypes
from pathlib import Path
from typing import Any

import numpy as np

from boresight.evidence.sources import Folder, Source
from boresight.evidence.targets import GCC, PRECISIONS, compile_units, run

Points = dict[str, np.ndarray]  # struct -> (points, numbers), its fields one after another


def shared_library(folder: Folder, precision: str, out: Path, objects: dict[str, Path] | None = None) -> Path:
    """The folder's units and their batch forms for this machine; `objects` in place of compiled units, if given."""
    objects = objects or compile_units(folder, GCC, precision, out)
    image = out / f"{folder.name}-{precision}.so"
    batch = folder.files("batch/*.c")
    flags = [*GCC.flags, "-std=c99", "-O2", "-ffp-contract=off", *PRECISIONS[precision], "-I", folder.include]
    run(["gcc", "-shared", *flags, *batch, *objects.values(), "-lm", "-o", image])
    return image


class Caller:
    """One printed unit of an opened library."""

    def __init__(self, library: ctypes.CDLL, unit: Source, precision: str):
        assert unit.described is not None
        self.unit, self.described = unit, unit.described
        self.real = np.float32 if precision == "float" else np.float64
        self.function = getattr(library, self.described["c_name"] + "_batch")
        self.function.restype = ctypes.c_size_t
        self.structs: list[str] = self.described["structs"]
        self.results = self.described["results"]

    def __call__(self, points: Points, paint: float = np.nan) -> tuple[list[np.ndarray], np.ndarray]:
        """Each result, (points, rows * columns), full of `paint` where nothing was written; and the status of each."""
        count = len(next(iter(points.values()))) if points else 1
        given = [np.ascontiguousarray(points[name], dtype=self.real) for name in self.structs]
        outputs = [np.full((count, int(np.prod(r["shape"]))), paint, dtype=self.real) for r in self.results]
        status = np.full(count, 255, dtype=np.uint8)
        arguments: list[Any] = [ctypes.c_size_t(count)]
        for array in given:
            # a stride is counted in structs; the state is an array of numbers, and its stride in those
            stride = array.shape[1] if self.structs[len(arguments) // 2] == "x" else 1
            arguments += [array.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(stride)]
        arguments += [array.ctypes.data_as(ctypes.c_void_p) for array in (*outputs, status)]
        self.function(*arguments)
        return outputs, status


def layout(unit: Source) -> list[tuple[str, int, dict[str, Any]]]:
    """(struct, where it begins there, the manifest's field) of every field of the structs that are read."""
    assert unit.described is not None
    found = []
    for struct in unit.described["structs"]:
        start = 0
        for field in unit.folder.manifest["structs"][struct]:
            found.append((struct, start, field))
            start += field["size"]
    return found


def points_of(unit: Source, count: int, corners: int, rng: np.random.Generator) -> Points:
    """Points of the box, the first of them its corners; a field with a norm is scaled to within its range."""
    assert unit.described is not None
    parts: dict[str, list[np.ndarray]] = {}
    for struct, _, field in layout(unit):
        low, high = np.array(field["low"]), np.array(field["high"])
        share = np.vstack([rng.integers(0, 2, (corners, len(low))), rng.random((count - corners, len(low)))])
        values = low * (1 - share) + high * share
        if field["norm"] is not None:
            least, most = field["norm"]
            length = np.linalg.norm(values, axis=1, keepdims=True)
            wanted = least + (most - least) * rng.uniform(0.05, 0.95, (count, 1))
            values = np.clip(np.divide(values, length, out=values, where=length > 0) * wanted, low, high)
        parts.setdefault(struct, []).append(values)
    return {struct: np.hstack(values) for struct, values in parts.items()}
