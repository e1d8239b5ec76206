"""What a call from Python costs over the C function itself: python -m benchmarks.call

The C function alone is timed inside C, by the batch function over many runs; the bound call and the empty call are
timed in the same interpreted loop.  And what a run costs where a call by keywords has many: by the scalar function, and
in lanes.
"""

import ctypes
import functools

import numpy as np

from benchmarks import interleaved
from boresight.runtime.library import load

CALLS = 20_000
RUNS = 4096


def main():
    library, scalar = load("euler-matching"), load("euler-matching", lanes=1)
    rows = []
    for name in ("F", "euler_H", "strapdown", "euler_exact_H"):
        unit = library.units[name]
        bound = unit.bind()
        for field, view in bound.inputs.items():
            box = library.field[field]
            view[:] = 0.25 * (3 * np.array(box["low"]) + np.array(box["high"]))
            if box["norm"]:
                view[:] /= np.linalg.norm(view)
        assert bound() == 0
        widths = [library.width[s] for s in unit.structs]
        arrays = [np.ascontiguousarray(bound._arrays[s]) for s in unit.structs]
        outputs = [np.empty((CALLS, out.size)) for out in bound.outputs.values()]
        status = np.empty(CALLS, np.uint8)
        arguments = [ctypes.c_size_t(CALLS)]
        for array, _ in zip(arrays, widths, strict=True):
            arguments += [ctypes.c_void_p(array.ctypes.data), ctypes.c_size_t(0)]
        arguments += [ctypes.c_void_p(a.ctypes.data) for a in (*outputs, status)]

        fields = {key: view.copy() if library.field[key]["size"] > 1 else view[0] for key, view in bound.inputs.items()}
        many = {key: np.tile(value, (RUNS, *np.ndim(value) * (1,))) for key, value in fields.items()}
        best = interleaved(
            {"c": functools.partial(unit._many, *arguments), "bound": bound.call, "loop": int,
             "keywords": functools.partial(unit, **fields), "many": functools.partial(scalar.units[name], **many),
             "lanes": functools.partial(unit, **many)}
        )  # fmt: skip
        best["c"] /= CALLS
        rows.append((name, best))
    print(
        f"{'function':<16}{'C alone, ns':>12}{'bound call, ns':>16}{'over C, ns':>12}{'ratio':>8}{'keywords, us':>14}"
        f"{f'{RUNS} runs, ns':>16}{'in lanes, ns':>14}"
    )
    loop = min(best["loop"] for _, best in rows) * 1e9
    for name, best in rows:
        c, call = best["c"] * 1e9, best["bound"] * 1e9
        print(f"{name:<16}{c:12.0f}{call:16.0f}{call - c - loop:12.0f}{call / c:8.1f}{best['keywords'] * 1e6:14.1f}"
              f"{best['many'] / RUNS * 1e9:16.0f}{best['lanes'] / RUNS * 1e9:14.0f}")  # fmt: skip
    print(f"an empty built-in call in the same loop, taken off: {loop:.0f} ns")


if __name__ == "__main__":
    main()
