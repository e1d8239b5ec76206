"""Golden vectors of a printed unit, from the 50-digit reference."""

from typing import Any

import numpy as np
from flint import arb

from boresight.codegen.functions.samples import BEYOND, answered, edges, ends, generator
from boresight.codegen.functions.tape import evaluate
from boresight.codegen.functions.units import Unit
from boresight.derive.model import Model

LIBM_ULPS = 4  # what the self-test grants the sine, cosine and arctangent of a target's library
VECTORS, CORNERS = 64, 24
DIFFERENTIATED = 1e-45  # what is left of 80 digits where the reference was differentiated numerically and is zero


def exact(unit: Unit, points: list[np.ndarray], k: int) -> list[list[Any]]:
    """The non-zeros of each result at point k, from the reference, as balls."""
    found = unit.reference({a.name: points[i][k].tolist() for i, a in enumerate(unit.args)})
    return [
        [entries.get(place, arb(0)) for place in result.nonzeros]
        for entries, result in zip(found, unit.results, strict=True)
    ]


def vectors(model: Model, unit: Unit) -> dict[str, Any]:
    """Golden vectors as hexadecimal text: inputs that a float holds, expected outputs, tolerances of each precision.

    The expected value is rounded to double, which comes on top of what the C may err by.
    """
    points = answered(unit, CORNERS, VECTORS, generator(model.name, unit.name), in_float=True)
    count = len(points[0]) if points else 1
    references = [exact(unit, points, k) for k in range(count)]
    places = {(output, nz): i for i, (output, nz, _) in enumerate(unit.tape.results)}

    def table(rows: np.ndarray) -> str:
        return ",\n".join("    { " + ", ".join(v.hex() for v in row) + " }" for row in rows.tolist())

    expected = [
        np.array([[float(v) for v in references[k][o]] for k in range(count)]) for o in range(len(unit.results))
    ]

    def tolerances(real: type[np.floating]) -> list[str]:
        _, bounds = evaluate(unit.tape, points, LIBM_ULPS, real)
        return [
            table(
                np.array([bounds[places[o, nz]] for nz in range(len(result.nonzeros))]).T
                + abs(expected[o]) * 2.0**-53
                + DIFFERENTIATED
            )
            for o, result in enumerate(unit.results)
        ]

    boxed = any(result.low for result in unit.results)
    edge, outside = edges(unit, BEYOND, generator(model.name, unit.name, "edges")) if boxed else ([], [])
    return {
        "count": count,
        "outside": outside,
        # where there is neither a norm nor a box of the result, any point will do
        "ends": ends(unit, points) if boxed or any(a.norm for a in unit.args) else [],
        "inputs": [table(np.vstack([p, edge[i]]) if outside else p) for i, p in enumerate(points)],
        "outputs": [table(values) for values in expected],
        "tolerances": tolerances(np.float64),
        "float_tolerances": tolerances(np.float32),
    }
