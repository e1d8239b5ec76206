"""Numbers for every letter of an equation, from finite rotations, and the value of an expression at them.

Rotations here are exponentials of a skew matrix, in many digits; angles and rotation vectors are read back from the
matrices.  None of the formulas that a paper prints is used to make the numbers which judge it.
"""

import math
import random
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import fields, replace
from functools import cache
from typing import Any
from unicodedata import normalize

from boresight.derive.ledger.numbers import Matrix, asin, atan2, exact, norm, sqrt


def vector(*entries) -> Matrix:
    return Matrix(entries)


def uniform(generator: random.Random, size) -> tuple:
    """Three components drawn from [-size, size]; `size` a number or three."""
    sizes = size if isinstance(size, tuple) else (size,) * 3
    return tuple(exact(s) * exact(generator.uniform(-1, 1)) for s in sizes)


def skew(v) -> Matrix:
    x, y, z = v
    return Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def finite_rotation(v) -> Matrix:
    """exp([v x]): FLINT's exponential of a matrix, a power series."""
    return skew(v).exp()


def rotation_vector(C) -> Matrix:
    """The vector v, |v| < pi, with C = exp([v x])."""
    v = vector(C[2, 1] - C[1, 2], C[0, 2] - C[2, 0], C[1, 0] - C[0, 1]) / 2
    angle = atan2(norm(v), (C[0, 0] + C[1, 1] + C[2, 2] - 1) / 2)
    return v / angle.sinc()  # which is 1 at an angle of zero


def attitude(euler) -> Matrix:
    """C_b2n of roll, pitch, yaw: three finite rotations about the axes."""
    roll, pitch, yaw = euler
    return finite_rotation([0, 0, yaw]) * finite_rotation([0, pitch, 0]) * finite_rotation([roll, 0, 0])


def angles(C) -> Matrix:
    """Roll, pitch, yaw of C_b2n."""
    return vector(atan2(C[2, 1], C[2, 2]), asin(-C[2, 0]), atan2(C[1, 0], C[0, 0]))


def quaternion(C) -> Matrix:
    """[w, x, y, z], w > 0, from the entries of a rotation that is no half turn: 4 w^2 = 1 + trace."""
    w = sqrt(1 + C[0, 0] + C[1, 1] + C[2, 2]) / 2
    return vector(w, *((C[i, j] - C[j, i]) / (4 * w) for i, j in ((2, 1), (0, 2), (1, 0))))


def hamilton(p, q) -> Matrix:
    """The quaternion product, from scalar and vector parts."""
    u, v = p[1:4, 0], q[1:4, 0]
    turned = skew(u) * v + v * p[0] + u * q[0]
    return vector(p[0] * q[0] - (u.T * v)[0], *turned)


def rate(function: Callable) -> Any:
    """The derivative at zero of a function of time, central difference: right to 1e-32."""
    step = exact("1e-16")
    return (function(step) - function(-step)) / (2 * step)


class Letters(Mapping):
    """Values by name, each group worked out when one of its letters is asked for."""

    def __init__(self, groups: tuple[tuple[str, Callable], ...], given: Mapping):
        split = [(tuple(normalize("NFC", names).split("|")), make) for names, make in groups]
        self._of = {name: (names, make) for names, make in split for name in names}
        self._known = {normalize("NFC", name): value for name, value in given.items()}
        self._open: set[str] = set()

    def __getitem__(self, name):
        if name not in self._known:
            if name not in self._of:
                raise KeyError(f"the paper does not define {name}")
            if name in self._open:
                raise KeyError(f"{name} is defined by itself")
            self._open.add(name)
            names, make = self._of[name]
            self._known.update(zip(names, make(self), strict=True))
        return self._known[name]

    def __iter__(self) -> Iterator[str]:
        return iter({*self._known, *self._of})

    def __len__(self) -> int:
        return len({*self._known, *self._of})


POSITIVE = ("delay", "step")  # of a base: their first component alone counts


@cache
def draw(kind: type, seed: int, conditions):
    """A base of `kind`, each part within its size in `conditions`; one seed gives the same directions at any scale."""
    generator = random.Random(seed)
    parts = {part.name: uniform(generator, getattr(conditions, part.name)) for part in fields(kind)}
    return kind(**{name: tuple(map(abs, part)) if name in POSITIVE else part for name, part in parts.items()})


def scaled(conditions, scale: float, parts: Iterable[str]):
    """The conditions with the sizes of `parts` times `scale`."""
    sizes = {part: getattr(conditions, part) for part in parts}
    return replace(
        conditions,
        **{
            part: tuple(s * scale for s in size) if isinstance(size, tuple) else size * scale
            for part, size in sizes.items()
        },
    )


def degrees(*angles) -> tuple:
    """Angles in rad, exactly those of the floats."""
    return tuple(exact(float(angle) * math.pi / 180) for angle in angles)
