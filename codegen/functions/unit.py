"""A printed unit: what it reads and gives, CasADi's function of it, and a reference that shares nothing with that."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from boresight.codegen.functions.identities import alike
from boresight.codegen.functions.reference import Entries
from boresight.codegen.functions.tape import Tape, tape
from boresight.derive.model import Model, Variable

Values = Mapping[str, Sequence[Any]]  # field name -> components, floats or balls


@dataclass(frozen=True)
class Result:
    """One output of a unit: a matrix, of which the kernel writes the non-zeros (row, column)."""

    name: str
    shape: tuple[int, int]
    nonzeros: tuple[tuple[int, int], ...]
    unit: str
    meaning: str
    angle: tuple[int, ...] = ()  # the rows that are angles
    low: tuple[float, ...] = ()
    high: tuple[float, ...] = ()


@dataclass(frozen=True)
class Unit:
    name: str
    meaning: str
    args: tuple[Variable, ...]  # what it reads, in the model's order; the state, if read, is `x` and comes first
    results: tuple[Result, ...]
    equations: tuple[str, ...]
    function: Any  # casadi.Function: the single source of both prints
    reference: Callable[[Values], list[Entries]]  # the non-zeros of each result, as balls
    named: Any = None  # casadi.Function of the same args: the values that have the names
    names: tuple[str, ...] = ()
    guarded: bool = False  # whether the C answers with finite numbers only

    @cached_property
    def tape(self) -> Tape:
        return tape(self.function)

    @cached_property
    def called(self) -> dict[int, str]:
        """Positions of the tape that have a name."""
        if not self.names:
            return {}
        found = alike(self.tape, tape(self.named))
        return {position: "minus_" * minus + self.names[k] for position, (k, minus) in found.items()}


def described(name: str, unit: str, meaning: str, **rest: Any) -> Result:
    """A result before its shape is known."""
    return Result(name, (0, 0), (), unit, meaning, **rest)


def state_variable(model: Model) -> Variable:
    """The whole state as one input, named x."""
    parts = model.states
    low = tuple(value for part in parts for value in part.low)
    high = tuple(value for part in parts for value in part.high)
    meaning = model.kind.replace("-", " ")
    return Variable("x", tuple(model.x), ", ".join(part.unit for part in parts), meaning, low, high)
