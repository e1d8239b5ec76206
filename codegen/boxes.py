"""Other boxes for a model's inputs and states, as a user chooses them for an export."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from boresight.errors import BoresightError, did_you_mean

if TYPE_CHECKING:
    from boresight.derive.model import Model, Variable


def parsed(words: str) -> tuple[str, float, float]:
    """NAME=LOW:HIGH as name, low and high."""
    name, _, ends = words.partition("=")
    low, _, high = ends.partition(":")
    try:
        box = float(low), float(high)
    except ValueError:
        raise BoresightError(f"--box {words}: write NAME=LOW:HIGH with two numbers, as lat=-1.2:1.2") from None
    if not (all(map(math.isfinite, box)) and box[0] < box[1]):
        raise BoresightError(f"--box {words}: the ends must be finite, the lower one below the upper one")
    return name, *box


def with_boxes(model: "Model", boxes: tuple[str, ...]) -> "Model":
    """The model with these boxes of components of its inputs and states, each in the unit of its component.

    The box of a function's output, where it has one, stays.
    Raises BoresightError on a name that is none, on ends that are none, and where the model's own checks refuse it.
    """
    chosen = {name: (low, high) for name, low, high in map(parsed, boxes)}
    variables = [*model.states, *(field for struct in model.structs for field in struct.fields)]
    known = [symbol.name for variable in variables for symbol in variable.symbols]
    for name in chosen:
        if name not in known:
            meant = did_you_mean(name, known)
            raise BoresightError(f"--box: {model.name} has no component {name!r}{meant}; there are {', '.join(known)}")

    def boxed(variable: "Variable") -> "Variable":
        old = zip(variable.symbols, variable.low, variable.high, strict=True)
        ends = [chosen.get(symbol.name, (low, high)) for symbol, low, high in old]
        if not any(symbol.name in chosen for symbol in variable.symbols):
            return variable
        if any(symbol == model.dt and low <= 0 for symbol, (low, _) in zip(variable.symbols, ends, strict=True)):
            raise BoresightError(f"--box: {model.dt} is the length of a step; its box must lie above 0")
        return replace(variable, low=tuple(low for low, _ in ends), high=tuple(high for _, high in ends))

    changed = {variable.name: boxed(variable) for variable in variables}
    return replace(
        model,
        states=tuple(changed[state.name] for state in model.states),
        structs=tuple(replace(s, fields=tuple(changed[field.name] for field in s.fields)) for s in model.structs),
    )
