"""Which single mistake explains what two series do not share: all that are usual compete, and the best is named.

A guess says what one series would be by the other one.  Each is given the freedom of a sound recording (a mounting, a
scale factor, a bias, each beside its usual size), and its misfit tells how well it explains the rest.  If two of them
explain it alike, both are named; if none does, none is.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from boresight.runtime import frames, rotation
from boresight.runtime.array import Array
from boresight.runtime.frames import AXES
from boresight.runtime.units import DEG

ROWS = 200  # at most, of what is compared
MOUNTING, SCALE = 3 * DEG, 0.02  # usual sizes
WRONG, BETTER, ALIKE = 6.0, 4.0, 1.5  # a healthy recording has a misfit of 4 at most
CHOICES = ("attitude", "Euler", "level")  # which nothing leads to by degrees: a small one is a mistake too


@dataclass(frozen=True)
class Guess:
    """`seen` (K, 3) would be `of` (K, 3), but for what a sound recording differs by, and `more` columns (K, 3)."""

    kind: str  # of which the best is taken; "" that nothing is wrong
    where: str
    text: str  # may have {0}, {1}, ...: the coefficients of `more`; none, where somebody else judges this kind
    seen: Array
    of: Array
    more: tuple[Array, ...] = ()
    cost: float = 1.0  # by which its misfit counts more than that of a simpler one
    most: float = np.inf  # of the first coefficient, beyond which nobody has it


@dataclass(frozen=True)
class Freedom:
    """What of one series in another is no mistake: columns (K, 3) with a sigma each, and the least noise, one sigma.

    fits: of the squares of what is seen, or of what is left as it is, what a guess may leave that explains it.
    """

    columns: tuple[Array, ...]
    sigmas: tuple[float, ...]
    least: float
    fits: float


@dataclass(frozen=True)
class Judged:
    """A guess with its misfit, the mean square that it leaves and the coefficients of what it has more."""

    guess: Guess
    misfit: float
    left: float
    found: Array

    @property
    def text(self) -> str:
        return self.guess.text.format(*self.found)


class Fit:
    """A guess beside what is seen, as normal equations."""

    def __init__(self, guess: Guess, free: Freedom):
        self.guess = guess
        rows = np.unique(np.linspace(0, len(guess.of) - 1, ROWS).round().astype(int))
        seen, of = guess.seen[rows], guess.of[rows]
        x, y, z = of.T
        none = np.zeros_like(x)
        turned = [np.stack(parts, axis=-1) for parts in ((none, z, -y), (-z, none, x), (y, -x, none))]
        columns = [*turned, *(of * axis for axis in np.eye(3))]
        columns += [column[rows] for column in (*free.columns, *guess.more)]
        self.sigmas = np.array([MOUNTING] * 3 + [SCALE] * 3 + [*free.sigmas] + [np.inf] * len(guess.more))
        X = np.stack([column.ravel() for column in columns], axis=-1)
        self.norm = np.sqrt(np.einsum("ij,ij->j", X, X)) + 1e-30
        self.X, self.y = X / self.norm, (seen - of).ravel()
        self.normal, self.right = self.X.T @ self.X, self.X.T @ self.y

    def judged(self, size: float) -> Judged:
        """misfit: mean square of what is left, in units of size^2, and the squares of all freedoms in their sigmas."""
        weight = len(self.y) * size**2 / (self.sigmas * self.norm) ** 2
        found = np.linalg.solve(self.normal + np.diag(weight + 1e-12), self.right)
        left = float(np.mean((self.y - self.X @ found) ** 2))
        found = found / self.norm
        more = found[len(found) - len(self.guess.more) :]
        if len(more) and abs(more[0]) > self.guess.most:
            return Judged(self.guess, np.inf, left, more)
        freedoms = float(np.sum(np.square(found / self.sigmas)))
        return Judged(self.guess, self.guess.cost * (left / size**2 + freedoms), left, more)


def ranked(fits: list[Fit], free: Freedom) -> list[Judged]:
    """The best guess of each kind, best first."""
    size = max(free.least, float(np.sqrt(min(one.judged(free.least).left for one in fits))))
    best: dict[str, Judged] = {}
    for one in fits:
        now, kind = one.judged(size), one.guess.kind
        if kind not in best or now.misfit < best[kind].misfit:
            best[kind] = now
    return sorted(best.values(), key=lambda one: one.misfit)


def decided(guesses: Iterable[Guess], free: Freedom, wrong: bool = False) -> tuple[Judged, list[Judged]]:
    """How it fits as it is, and the guesses that explain what is wrong: one, or two that do it alike, or none.

    guesses: first that nothing is wrong, then CHOICES.  wrong: whether something is known to be, so that less is asked.
    """
    every: list[Fit] = []
    for guess in guesses:
        if guess.kind not in ("", *CHOICES) and not wrong and every[0].judged(free.least).misfit < WRONG:
            break  # no other one would be believed
        every.append(Fit(guess, free))
    order = ranked(every, free)
    as_is = next(one for one in order if not one.guess.kind)
    fits = [
        one
        for one in order
        if one.guess.kind
        and one.misfit < as_is.misfit / (2 if wrong else BETTER)
        and one.left < free.fits * max(as_is.left, float(np.var(one.guess.seen, axis=0).mean()))
    ]
    if as_is.misfit < WRONG and not wrong:
        fits = [one for one in fits if one.guess.kind in CHOICES and one.left < as_is.left / BETTER]
    return as_is, [one for one in fits if one.misfit < ALIKE * fits[0].misfit][:2]


# ---------------------------------------------------------------- words


def in_words(found: list[Judged], more: str = "") -> str:
    """The best guess, with `more` of it, and what explains as well."""
    best, *others = found
    return best.text + more + "".join(f"; or, as well explained, {one.guess.where}: {one.text}" for one in others)


def known(factor: float, of: dict[float, str], within: float = 0.03) -> str:
    """What has such a factor, as the end of a sentence."""
    return next((f": {what}" for size, what in of.items() if abs(factor / size - 1) < within), "")


def plain(M: Array) -> bool:
    """Whether a matrix is a signed permutation, but for a mounting."""
    return bool(np.abs(M - np.round(M)).max() < 0.15)


def turn_named(M: Array) -> str:
    vector = np.degrees(rotation.vector_from_matrix(M))
    size, axis = max(float(np.linalg.norm(vector)), 1e-300), int(np.abs(vector).argmax())
    if abs(vector[axis]) > 0.95 * size:
        return f"{size:.0f} deg about {AXES[axis]}"
    return f"{size:.0f} deg about [{{:.2f}}, {{:.2f}}, {{:.2f}}]".format(*(vector / size))


def axes_named(M: Array) -> str:
    """What a signed permutation did to axes."""
    if np.linalg.det(M) < 0:
        where = [AXES[i] for i in range(3) if M[i, i] < 0]
        if len(where) == 1 and np.trace(np.abs(M)) == 3:
            return f"{where[0]} of its axes is mirrored: left-handed axes, or one sign"
        moved = [AXES[i] for i in range(3) if M[i, i] == 0]
        if not moved:
            return "all three of its axes are mirrored: left-handed axes, or each sign"
        angles = ", or the master's roll and pitch are" if moved == ["front", "right"] else ""
        return f"{' and '.join(moved)} of its axes are exchanged, left-handed{angles}"
    also = {"FLU": "as FLU beside FRD", "RFU": "as RFU beside FRD, and ENU beside NED"}
    named = next((f", {text}" for name, text in also.items() if np.array_equal(frames.body_to_frd(name), M.T)), "")
    vector = rotation.vector_from_matrix(M)
    angle = round(float(np.degrees(np.linalg.norm(vector))))
    lone = np.count_nonzero(np.abs(vector) > 0.1) == 1
    about = AXES[int(np.abs(vector).argmax())] if lone else "a diagonal"
    return f"it is turned by {angle} deg about {about} beside its master{named}: another body"
