"""Points of a unit's box: its corners first, then points drawn at random, the same for the same seed."""

import hashlib
from itertools import product

import numpy as np

from boresight import BoresightError
from boresight.codegen.tape import evaluate
from boresight.codegen.units import Unit
from boresight.derive.model import Variable


def generator(*words: str) -> np.random.Generator:
    """A random generator whose numbers depend on the words alone."""
    digest = hashlib.sha256("\n".join(words).encode()).digest()
    return np.random.Generator(np.random.Philox(int.from_bytes(digest[:8], "big")))


def sample(args: tuple[Variable, ...], corners: int, count: int, rng: np.random.Generator) -> list[np.ndarray]:
    """`count` points, at most `corners` of them corners of the box; (count, size) for each argument.

    All corners are taken if there are no more than asked for.  A variable with a norm is scaled to 1 times the middle
    of its range.
    """
    size = sum(arg.size for arg in args)
    if 2**size <= corners:
        signs = np.array(list(product((0.0, 1.0), repeat=size))).reshape(2**size, size)
    else:
        signs = rng.integers(0, 2, size=(corners, size)).astype(float)
        signs[:1], signs[1:2] = 0.0, 1.0
    unit = np.vstack([signs, rng.random((count - len(signs), size))])
    points, start = [], 0
    for arg in args:
        low, high = np.array(arg.low), np.array(arg.high)
        part = unit[:, start : start + arg.size]
        start += arg.size
        # Written so that 0 and 1 give the ends of the box exactly.
        values = low * (1 - part) + high * part
        if arg.norm is not None:
            length = np.linalg.norm(values, axis=1, keepdims=True)
            values = values / length * (sum(arg.norm) / 2)
        points.append(np.clip(values, low, high))
    return points


def single(args: tuple[Variable, ...], points: list[np.ndarray]) -> list[np.ndarray]:
    """The points moved to numbers that a float holds, inside the box."""
    moved = []
    for arg, part in zip(args, points, strict=True):
        near = part.astype(np.float32)
        near = np.where(near > np.array(arg.high), np.nextafter(near, np.float32(-np.inf)), near)
        near = np.where(near < np.array(arg.low), np.nextafter(near, np.float32(np.inf)), near)
        moved.append(near.astype(float))
    return moved


def answered(
    unit: Unit, corners: int, count: int, rng: np.random.Generator, *, in_float: bool = False
) -> list[np.ndarray]:
    """`count` points (none for a function without arguments) at which the unit answers; in_float: in either precision.

    There its results lie in their own boxes and rounding errors are bounded.  Near a singularity, such as a pitch of
    90 deg, the bound is infinite and proves nothing.
    """
    if not unit.args:
        return []  # a constant: one point without coordinates
    points = sample(unit.args, 2 * corners, 2 * count, rng)
    points = single(unit.args, points) if in_float else points
    values, bounds = evaluate(unit.tape, points, real=np.float32 if in_float else np.float64)
    keep = np.isfinite(np.array(bounds)).all(axis=0)
    for (output, nz, _), value, bound in zip(unit.tape.results, values, bounds, strict=True):
        result = unit.results[output]
        if result.low:
            keep &= (value - bound >= result.low[nz]) & (value + bound <= result.high[nz])
    chosen = np.flatnonzero(keep)[:count]
    if len(chosen) < count:
        raise BoresightError(
            f"{unit.name}: only {len(chosen)} of {2 * count} points of its box have an answer; narrow the box"
        )
    return [part[chosen] for part in points]
