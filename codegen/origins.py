"""Places and velocities that z reads: nobody measures from where places are counted, nor against what velocities are.

So z reads their differences, and what differs is a sign, a term or an axis.  Which number is a place, and whether it is
counted downwards, stands in its meaning.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

from flint import arb

from boresight.codegen.functions.reference import precise
from boresight.codegen.mechanics import NOTHING, MechanicsCheck, Values, compiled, largest, points, size, slope
from boresight.codegen.residuals import CLOSE, MANY, OF_LEVEL, estimated, letters
from boresight.derive.expressions import symbols_in
from boresight.derive.ledger.numbers import Matrix
from boresight.derive.mechanics.earth import FRAMES
from boresight.derive.model import Measurement, Model, Variable
from boresight.derive.within import within

# Of a place that is one number, by its meaning: whether it is counted downwards, upwards, or from the ground.
DOWN, UP = re.compile(r"\b(down|depth)\b"), re.compile(r"\b(height|altitude|elevation|up|above)\b")
ABOVE_GROUND, GROUND = re.compile(r"\babove (the )?(ground|terrain)\b"), re.compile(r"\b(ground|terrain)\b")
NO_PLACE = re.compile(r"\b(bias|error|offset|range|distance|length)\b")
SIGNS = {"n": 1, "e": 1, "d": 1, "u": -1}


@dataclass(frozen=True)
class Row:
    """A row of z at one point, and what it changes by as vectors grow by 1 along one axis of the level.

    vectors: for each that it reads.  numbers: for each place that is one number, as it grows by 1.  most: of any, along
    any axis.
    """

    name: str
    vectors: tuple[Any, ...]
    numbers: dict[str, Any]
    most: float

    def off(self, grows: dict[str, int]) -> float:
        """What all that grows together changes, of the largest that one changes alone."""
        parts = (*self.vectors, *(grows[name] * by for name, by in self.numbers.items()))
        return size(sum(parts, arb(0))) / self.most


def check_origins(model: Model) -> list[MechanicsCheck]:
    """A row of all z that change neither with the origin of places nor with what velocities are counted against, and a
    row of each that does."""
    free_ones: dict[str, tuple[int, ...]] = {}
    with precise():
        found = [row for m in model.measurements for unit in ("m", "m/s") for row in rows(model, m, unit, free_ones)]
        choices = (dict(zip(free_ones, choice, strict=True)) for choice in product(*free_ones.values()))
        off = min(([row.off(grows) for row in found] for grows in choices), key=lambda off: sum(e > CLOSE for e in off))
    wrong = dict.fromkeys(row.name for row, e in zip(found, off, strict=True) if not within(e, CLOSE))
    if found and not wrong:
        return [MechanicsCheck(model.name, "z", "an origin of places and velocities that is displaced", max(off))]
    why = "it changes where all places that it reads, or all velocities, grow by the same"
    return [MechanicsCheck(model.name, f"{name}_z", "", why=why) for name in wrong]


def grows(model: Model, v: Variable) -> tuple[int, ...]:
    """By what a number in m may grow as each place that is counted downwards grows by 1; nothing, if it is no place."""
    if ABOVE_GROUND.search(v.meaning):
        grounds = [one for one in estimated(model) if one.size == 1 and one.unit == "m" and GROUND.search(one.meaning)]
        return (0,) if [one for one in grounds if one is not v] else (0, -1)
    if NO_PLACE.search(v.meaning):
        return ()
    down, up = DOWN.search(v.meaning), UP.search(v.meaning)
    return (1, 0) if down else (-1, 0) if up else (0, 1, -1) if v in estimated(model) else ()


def rows(model: Model, m: Measurement, unit: str, free_ones: dict[str, tuple[int, ...]]) -> Iterator[Row]:
    """Those that read two or more places or velocities; how each number grows is noted in `free_ones`."""
    z = m.z if m.z is not None else m.h
    read = symbols_in(z) if z is not None else set()
    variables = [v for v in (*model.inputs, *model.states) if read & {*v.symbols} and v.unit == unit]
    vectors = [v for v in variables if letters(v) in OF_LEVEL and v.frame in ("", *FRAMES)]
    numbers = {v: by_words for v in variables if v.size == 1 and unit == "m" and (by_words := grows(model, v))}
    if not vectors or len(vectors) + len(numbers) < 2:
        return
    symbols, run = [s for v in (*vectors, *numbers) for s in v.symbols], compiled(z)
    for here in points(model, "z", MANY):

        def displaced(x: Sequence[Any], here: Values = here) -> Matrix:
            return run(here | {s: here[s] + e for s, e in zip(symbols, x, strict=True)})[0]

        J = slope(displaced, [arb(1)] * len(symbols))
        for i, axis in product(range(J.rows), ("n", "e", "du")):
            by = {v: [J[i, symbols.index(s)] for s in v.symbols] for v in (*vectors, *numbers)}
            by = {v: row for v, row in by.items() if largest(row) > NOTHING}
            fixed = tuple(
                SIGNS[letter] * e
                for v in vectors
                for letter, e in zip(letters(v), by.get(v, ()), strict=False)
                if letter in axis
            )
            free = {v.name: by[v][0] for v in numbers if v in by and axis == "du"}
            if fixed and len(fixed) + len(free) > 1:
                free_ones.update((v.name, by_words) for v, by_words in numbers.items())
                yield Row(m.name, fixed, free, max(map(largest, by.values())))
