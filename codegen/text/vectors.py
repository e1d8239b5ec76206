"""Golden vectors of a printed unit, from the 50-digit reference."""

from typing import Any

import numpy as np
from flint import arb

from boresight.codegen.functions.mutants import LEAST, telling
from boresight.codegen.functions.samples import BEYOND, answered, edges, ends, generator
from boresight.codegen.functions.tape import evaluate
from boresight.codegen.functions.unit import Unit
from boresight.codegen.text.names import rows_of, three_digits
from boresight.derive.model import Model

CORNERS, PLAIN, SMALL = 8, 40, 24  # points that the vectors are chosen from
DIFFERENTIATED = 1e-45  # what is left of 80 digits where the reference was differentiated numerically and is zero


def exact(unit: Unit, points: list[np.ndarray], k: int) -> list[list[Any]]:
    """The non-zeros of each result at point k, from the reference, as balls."""
    found = unit.reference({a.name: points[i][k].tolist() for i, a in enumerate(unit.args)})
    return [
        [entries.get(place, arb(0)) for place in result.nonzeros]
        for entries, result in zip(found, unit.results, strict=True)
    ]


def chosen(model: Model, unit: Unit) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Points that together tell the unit from its mutants and serve the ends of its arguments' boxes, and which end
    each serves; without a norm and a box of the result any point will do, and nothing is listed."""
    rng = generator(model.name, unit.name)
    plain = answered(unit, CORNERS, PLAIN, rng, in_float=True)
    if not plain:
        return [], []
    small = answered(unit, 0, SMALL, rng, small=True, in_float=True)
    # the first are a corner, a small one and two random ones
    mixed = np.roll(np.arange(PLAIN + SMALL)[::-1], CORNERS).reshape(LEAST, -1).T.ravel()
    points = [np.vstack(both)[mixed] for both in zip(plain, small, strict=True)]
    values, bounds = evaluate(unit.tape, points)
    granted = [2 * bound + abs(value) * 2.0**-52 + DIFFERENTIATED for value, bound in zip(values, bounds, strict=True)]
    turning = [
        unit.results[output].nonzeros[nz][0] in unit.results[output].angle for output, nz, _ in unit.tape.results
    ]
    choosy = any(result.low for result in unit.results) or any(a.norm for a in unit.args)
    at_ends = ends(unit, points) if choosy else []
    needs = np.vstack([np.zeros((0, len(mixed)), dtype=bool), *at_ends])
    kept = telling(unit.tape, points, granted, turning, needs)
    return [part[kept] for part in points], [rows[:, kept] for rows in at_ends]


def vectors(model: Model, unit: Unit) -> dict[str, Any]:
    """Golden vectors as text: inputs that a float holds, expected outputs, tolerances of each precision.

    The expected value is rounded to double, which comes on top of what the C may err by.
    """
    points, at_ends = chosen(model, unit)
    count = len(points[0]) if points else 1
    references = [exact(unit, points, k) for k in range(count)]
    places = {(output, nz): i for i, (output, nz, _) in enumerate(unit.tape.results)}

    expected = [
        np.array([[float(v) for v in references[k][o]] for k in range(count)]) for o in range(len(unit.results))
    ]

    def tolerances(real: type[np.floating]) -> list[str]:
        _, bounds = evaluate(unit.tape, points, real)
        return [
            rows_of(
                np.array([bounds[places[o, nz]] for nz in range(len(result.nonzeros))]).T
                + abs(expected[o]) * 2.0**-53
                + DIFFERENTIATED,
                three_digits,
            )
            for o, result in enumerate(unit.results)
        ]

    boxed = any(result.low for result in unit.results)
    edge, outside = edges(unit, BEYOND, generator(model.name, unit.name, "edges")) if boxed else ([], [])
    return {
        "count": count,
        "outside": outside,
        "ends": [[int(row.argmax()) if row.any() else -1 for row in rows] for rows in at_ends],
        "inputs": [rows_of(np.vstack([p, edge[i]]) if outside else p) for i, p in enumerate(points)],
        "outputs": [rows_of(values) for values in expected],
        "tolerances": tolerances(np.float64),
        "float_tolerances": tolerances(np.float32),
    }
