"""Free values: every letter drawn by itself, as if no equation held, but of its class and with its parts.

A paper's `structure` says what a letter is by its nature: a rotation, the transpose of another, the skew matrix of a
vector, a vector of components.  All else is a number, or a matrix of numbers, of its shape.
"""

import random
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from boresight.derive.ledger.evaluate import Point
from boresight.derive.ledger.numbers import Matrix, exact, eye, middle
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.witness import finite_rotation, skew, uniform


@dataclass(frozen=True)
class Of:
    """A letter that is a function of others, named by their symbols."""

    letters: tuple[str, ...]
    function: Callable


def of(letters: str, function: Callable) -> Of:
    return Of(tuple(letters.split("|")), function)


@dataclass(frozen=True)
class Kind:
    """What a letter is by itself: how it is drawn, and whether a value is of the kind."""

    drawn: Callable[[random.Random], Any]
    holds: Callable[[Any], bool]

    def __call__(self, generator: random.Random) -> Any:
        return self.drawn(generator)


def _none(M: Matrix) -> bool:
    return all(abs(middle(entry)) < 1e-28 for entry in M)


def positive(size: int) -> Kind:
    """Symmetric and positive definite."""

    def drawn(generator: random.Random) -> Matrix:
        root = Matrix([[exact(generator.uniform(-1, 1)) for _ in range(size)] for _ in range(size)])
        return root * root.T + eye(size)

    return Kind(drawn, lambda M: _none(M - M.T) and all(M[:k, :k].det() > 0 for k in range(1, size + 1)))


rotation = Kind(
    lambda generator: finite_rotation(uniform(generator, "1.2")),
    lambda C: _none(C * C.T - eye(3)) and C.det() > 0,
)
skew_symmetric = Kind(lambda generator: skew(uniform(generator, 1)), lambda M: _none(M + M.T))
positive_number = Kind(lambda generator: exact(generator.uniform(0.2, 1.2)), lambda x: x > 0)


@dataclass
class Free(Mapping):
    """Values by name, drawn when asked for; the same seed gives a letter the same value, whatever is asked before.

    changes: letters that have been given a value; those made of them follow.
    """

    paper: Paper
    seed: int
    changes: Mapping[str, Any] = field(default_factory=dict)
    made: dict[str, Any] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Any:
        if name in self.changes:
            return self.changes[name]
        if name not in self.made:
            self.made[name] = self._make(name)
        return self.made[name]

    def _make(self, name: str) -> Any:
        generator = random.Random(f"{name} {self.seed}")
        rule = self.paper.structure.get(name)
        if isinstance(rule, Of):
            return rule.function(*(self[letter] for letter in rule.letters))
        if rule is not None:
            return rule(generator)
        letter = self.paper.letter(name)
        if letter.function:
            return self.paper.function(name)
        rows, columns = (*letter.shape, 1, 1)[:2]
        drawn = [[_number(generator) for _ in range(columns)] for _ in range(rows)]
        return Matrix(drawn) if letter.shape else drawn[0][0]

    def changed(self, values: Mapping[str, Any]) -> "Free":
        kept = {name: value for name, value in self.made.items() if not self.follows(name, values)}
        return Free(self.paper, self.seed, {**self.changes, **values}, kept)

    def follows(self, name: str, letters: Collection[str]) -> bool:
        """Whether a letter is made of one of these."""
        rule = self.paper.structure.get(name)
        return isinstance(rule, Of) and any(one in letters or self.follows(one, letters) for one in rule.letters)

    def __iter__(self) -> Iterator[str]:
        return iter(self.made)

    def __len__(self) -> int:
        return len(self.made)


def _number(generator: random.Random):
    """Of either sign, and not near zero."""
    return exact(generator.choice((-1, 1)) * generator.uniform(0.2, 1.2))


@cache
def free_point(paper: Paper, seed: int) -> Point:
    return Point(Free(paper, seed))
