"""A paper as a value: its equations, the letters in which they stand, and the witness that judges them."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from boresight import BoresightError
from boresight.derive.ledger.equation import Equation, Quantity, Relation
from boresight.derive.ledger.witness import draw, scaled

if TYPE_CHECKING:
    from boresight.derive.ledger.map import Map


@dataclass(frozen=True, eq=False)
class Witness:
    """Numbers for every letter of a paper, from exact mechanics and finite rotations.

    base: a dataclass of what a point is made of.  values: from a base and the equations that define letters, by number,
    the value of each letter by name.  wide: the largest sizes at which an equation is judged; `errors` shrink with the
    scale unless an equation names its own.  words: what the witness is, for the evidence.  parts: what those parts of
    the base are that may be small, in words.  left_out: by number, what the witness leaves out that would be there.
    """

    base: type
    values: Callable[[Any, Mapping[str, tuple[Relation, ...]]], Mapping[str, Any]]
    wide: Any
    errors: tuple[str, ...]
    words: str = "finite rotations"
    parts: Mapping[str, str] = field(default_factory=dict)
    left_out: Mapping[str, str] = field(default_factory=dict)

    def at(self, seed: int, scale: float, small: tuple[str, ...], definitions: Mapping) -> Mapping[str, Any]:
        """Values at a random point whose errors, or those of `small`, are `scale` times the wide ones."""
        return self.values(draw(self.base, seed, scaled(self.wide, scale, small or self.errors)), definitions)


@dataclass(frozen=True, eq=False)
class Stated:
    """What sizes hold for: sizes from which `count` points are drawn, or one point; `text` says it."""

    at: Any
    text: str
    count: int = 1


@dataclass(frozen=True, eq=False)
class Apart:
    """Equations that can be read one without the others.

    make: one by its number.  small: by number what is said to be small in it, in the paper's order; defining: the
    numbers of those that define a letter.
    """

    make: Callable[[str], Equation]
    small: Mapping[str, tuple[str, ...]]
    defining: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Paper:
    """conditions: the paper's own numbers, for sizes.  point: where the numbers of an erratum are given.

    evidence: what the ledger says of an equation beyond its status; findings: what was computed about the text beside.
    letters: those of the derivations that the paper does not print; letters_of: by number, the letters as that equation
    means them, where a spelling of the page is several; structure: what letters are by their nature, see
    ledger/free.py. units: of letters with several, or of their kinds; see ledger/dimensions.py. computed: frames that
    differ by an error from those that they stand for, beside primed ones. frames: of letters whose names show none,
    or another, and of lines that take one for another; see ledger/frames.py. conventions: the paper's own axes and
    signs, a sentence each. maps: to the models that make C from it; unflown: the equations of which no function that
    flies computes a side, each with why. folder: of a paper of one's own. labels: other names of equations, with their
    numbers. apart: where they can be read one by one.
    """

    name: str
    reference: str
    make_equations: Callable[[], tuple[Equation, ...]]
    quantities: Callable[[], tuple[Quantity, ...]]
    witness: Witness
    conditions: Stated
    point: Stated
    evidence: Callable[[str], str]
    findings: Callable[[], tuple[str, ...]]
    letters: Callable[[], tuple[Quantity, ...]] = tuple
    letters_of: Callable[[str], tuple[Quantity, ...]] | None = None
    structure: Mapping[str, Any] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    computed: Mapping[str, str] = field(default_factory=dict)
    frames: Mapping[str, str] = field(default_factory=dict)
    conventions: tuple[str, ...] = ()
    maps: tuple["Map", ...] = ()
    unflown: Mapping[str, str] = field(default_factory=dict)
    folder: str = ""
    labels: Mapping[str, str] = field(default_factory=dict)
    apart: Callable[[], Apart] | None = None

    @cached_property
    def _apart(self) -> Apart | None:
        return self.apart() if self.apart else None

    @cached_property
    def equations(self) -> tuple[Equation, ...]:
        """All equations, in the paper's order."""
        return self.make_equations()

    def equation(self, number: str) -> Equation:
        """The equation of a number, with or without brackets.  Raises BoresightError with the right ones."""
        bare = self.labels.get(number.strip("()"), number.strip("()"))
        if bare not in self.numbers:
            raise BoresightError(f"{self.name} has no equation {number!r}; it has {', '.join(self.numbers)}")
        if self._apart:
            return self._apart.make(bare)
        return next(equation for equation in self.equations if equation.number == bare)

    @cached_property
    def numbers(self) -> tuple[str, ...]:
        return tuple(self._apart.small) if self._apart else tuple(one.number for one in self.equations)

    @cached_property
    def defining(self) -> tuple[Equation, ...]:
        """The equations that define a letter."""
        if self._apart:
            return tuple(map(self._apart.make, self._apart.defining))
        return tuple(equation for equation in self.equations if equation.defines)

    @cached_property
    def small(self) -> tuple[str, ...]:
        """What an equation says to be small, in their order."""
        if self._apart:
            return tuple(part for parts in self._apart.small.values() for part in parts)
        return tuple(part for equation in self.equations for part in equation.small)

    @cached_property
    def definitions(self) -> dict[str, tuple[Relation, ...]]:
        """What the paper's definitions say, corrected, by number, for the witness to take as given."""
        return {equation.number: equation.derived for equation in self.defining}

    def letter(self, name: str) -> Quantity:
        """The letter of a symbol's name.  Raises KeyError."""
        return self._letters[name]

    @cached_property
    def _letters(self) -> dict[str, Quantity]:
        return {quantity.symbol.name: quantity for quantity in (*self.quantities(), *self.letters())}

    def function(self, name: str) -> Callable:
        """A letter with arguments, as the witness has it."""
        return self.witness.at(1, 1.0, (), self.definitions)[name]
