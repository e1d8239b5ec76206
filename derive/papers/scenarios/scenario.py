"""What a scenario is: exact values by name at a time, drawn from sizes."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from boresight.derive.ledger import ellipsoid
from boresight.derive.ledger.numbers import digits
from boresight.derive.ledger.witness import Letters


@dataclass(frozen=True)
class Name:
    """A value that a letter may be bound to: its unit, SI and rad, or of several "3 rad, 3 m/s"; and what it is."""

    unit: str
    meaning: str


@dataclass(frozen=True, eq=False)
class Scenario:
    """Exact values by name.

    sizes: of the parts that a point is drawn from, the largest at which an equation is judged; usual: those for which
    sizes of remainders are stated.  at: from a point and a time (s) groups of names, as "a|b", each with what makes
    their values.  errors: the parts that are small; parts: in words; units: of the parts.  moves: whether values change
    with time; exact: the names that have their values at any time, where all others have them near to 0, for rates.
    """

    name: str
    sizes: Any
    usual: Any
    at: Callable[[Any, Any], tuple[tuple[str, Callable], ...]]
    names: Mapping[str, Name]
    errors: tuple[str, ...] = ()
    parts: Mapping[str, str] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    moves: bool = True
    exact: frozenset[str] = frozenset()
    words: str = "finite errors"

    @property
    def base(self) -> Any:
        """The class of a point."""
        return type(self.sizes)

    def values(self, base: Any, time: Any = 0) -> Letters:
        return Letters(tuple((names, precise(make)) for names, make in self.at(base, time)), {})


def precise(make: Callable) -> Callable:
    """The same with enough digits for differences of differences."""

    def made(letters: Mapping[str, Any]) -> Any:
        with digits(ellipsoid.WORKING):
            return make(letters)

    return made
