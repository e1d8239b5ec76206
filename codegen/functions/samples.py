"""Points of a unit's box: its corners first, then points drawn at random, the same for the same seed."""

import hashlib
from itertools import product

import numpy as np

from boresight import BoresightError
from boresight.codegen.functions.elementary import norm
from boresight.codegen.functions.tape import computed, evaluate
from boresight.codegen.functions.unit import Unit
from boresight.derive.model import Variable

PAIRS = 200  # of points between which the edge of a result's box is looked for
FEW = 8  # points at which the ends of boxes are tried before the others
TRIES = 32  # points drawn for each that is wanted, where half of them have no answer
BEYOND = 5e-4  # how far outside its box the self-test puts a number, as a part of the bound


def generator(*words: str) -> np.random.Generator:
    """A random generator whose numbers depend on the words alone."""
    digest = hashlib.sha256("\n".join(words).encode()).digest()
    return np.random.Generator(np.random.Philox(int.from_bytes(digest[:8], "big")))


def sample(
    args: tuple[Variable, ...], corners: int, count: int, rng: np.random.Generator, *, small: bool = False
) -> list[np.ndarray]:
    """`count` points, at most `corners` of them corners of the box; (count, size) for each argument.

    All corners are taken if there are no more than asked for.  small: half of the numbers, by chance, are 2^-12 of
    themselves, or as near to that as the box allows.  A variable with a norm is scaled to one inside its range.
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
        if small:
            values = np.ldexp(values, -12 * rng.integers(0, 2, values.shape))
        if arg.norm is not None:
            least, most = arg.norm
            values = values / norm(values) * (least + (most - least) * (0.05 + 0.9 * part[:, :1]))
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
    unit: Unit, corners: int, count: int, rng: np.random.Generator, *, small: bool = False, in_float: bool = False
) -> list[np.ndarray]:
    """`count` points (none for a function without arguments) at which the unit answers; in_float: in either precision.

    There its results lie in their own boxes and rounding errors are bounded.  Near a singularity, such as a pitch of
    90 deg, the bound is infinite and proves nothing.
    """
    if not unit.args:
        return []  # a constant: one point without coordinates
    for drawn in (2 * count, TRIES * count):  # the state that a step ends in leaves its box at many
        points = sample(unit.args, 2 * corners, drawn, rng, small=small)
        points = single(unit.args, points) if in_float else points
        values, bounds = evaluate(unit.tape, points, real=np.float32 if in_float else np.float64)
        keep = np.isfinite(np.array(bounds)).all(axis=0)
        for (output, nz, _), value, bound in zip(unit.tape.results, values, bounds, strict=True):
            result = unit.results[output]
            if result.low:
                keep &= (value - bound >= result.low[nz]) & (value + bound <= result.high[nz])
        chosen = np.flatnonzero(keep)[:count]
        if len(chosen) == count:
            return [part[chosen] for part in points]
    raise BoresightError(f"{unit.name}: only {len(chosen)} of {drawn} points of its box have an answer; narrow the box")


def results(unit: Unit, points: list[np.ndarray]) -> list[np.ndarray]:
    """(points,) for each non-zero, in the order of the tape's results."""
    steps = computed(unit.tape, points)
    return [steps[position] for _, _, position in unit.tape.results]


def within(unit: Unit, points: list[np.ndarray]) -> np.ndarray:
    """(points,) 1 where the results surely lie in their own boxes, in either precision; -1 where surely not; else 0."""
    values, bounds = evaluate(unit.tape, points, real=np.float32)
    inside, outside = np.ones(len(values[0]), dtype=bool), np.zeros(len(values[0]), dtype=bool)
    for (output, nz, _), value, bound in zip(unit.tape.results, values, bounds, strict=True):
        result = unit.results[output]
        inside &= np.isfinite(bound)
        if result.low:
            inside &= (value - bound >= result.low[nz]) & (value + bound <= result.high[nz])
            outside |= (value + bound < result.low[nz]) | (value - bound > result.high[nz])
    return np.where(outside, -1, inside.astype(int))


def norm_ends(arg: Variable) -> tuple[float, ...]:
    """What one component is, the others being zero, at the ends of the norm's range; none without a norm."""
    return (-arg.norm[1], -arg.norm[0], *arg.norm) if arg.norm else ()


def ends(unit: Unit, points: list[np.ndarray]) -> list[np.ndarray]:
    """For each argument, (ends, points): whether a component may be put to an end of its box at that point so that the
    unit answers; low and high of the first component, and so on.

    Of an argument with a norm the other components are zero, and the ends are those of the norm, with either sign.
    """
    at = [
        [(which, i, end) for i in range(arg.size) for end in norm_ends(arg) or (arg.low[i], arg.high[i])]
        for which, arg in enumerate(unit.args)
    ]
    flat = [end for ends_of_one in at for end in ends_of_one]
    good = np.zeros((len(flat), len(points[0])), dtype=bool)
    for some in (slice(0, FEW), slice(FEW, None)):
        rows = [
            row
            for row, (which, i, end) in enumerate(flat)
            if unit.args[which].low[i] <= end <= unit.args[which].high[i] and not good[row].any()
        ]
        if not rows:
            break
        count = good[0, some].size
        moved = [np.tile(part[some], (len(rows), 1)) for part in points]
        for k, row in enumerate(rows):
            which, i, end = flat[row]
            if unit.args[which].norm:
                moved[which][k * count : (k + 1) * count] = 0.0
            moved[which][k * count : (k + 1) * count, i] = end
        good[rows, some] = (within(unit, moved) == 1).reshape(len(rows), count)
    return np.split(good, np.cumsum([len(ends_of_one) for ends_of_one in at])[:-1])


def edges(unit: Unit, beyond: float, rng: np.random.Generator) -> tuple[list[np.ndarray], list[int]]:
    """Points at which one result lies a part `beyond` of its bound inside or outside its own box, and which of them are
    outside (1).  A bound that no result was seen at has none."""
    tries = 20000
    drawn = sample(unit.args, tries // 10, tries, rng)
    values = results(unit, drawn)
    verdict = within(unit, drawn)
    rows: list[list[np.ndarray]] = []
    outside = []
    for k, (output, nz, _) in enumerate(unit.tape.results):
        result = unit.results[output]
        for sign, bound in ((-1, result.low[nz]), (1, result.high[nz])) if result.low else ():
            step = beyond * (abs(bound) or result.high[nz] - result.low[nz])
            near = np.flatnonzero(verdict == 1)
            for refused in (0, 1):
                target = bound + sign * step * (1 if refused else -1)
                far = np.flatnonzero(sign * (values[k] - target) > 0)
                if not (len(far) and len(near)):
                    continue
                made = between(unit, k, target, drawn, np.resize(near, PAIRS), np.resize(far, PAIRS))
                value = results(unit, made)[k]
                good = np.flatnonzero((within(unit, made) == 1 - 2 * refused) & (abs(value - target) < step / 2))
                if len(good):
                    rows.append([part[good[0]] for part in made])
                    outside.append(refused)
    return [np.array([row[i] for row in rows]) for i in range(len(unit.args))] if rows else [], outside


def between(
    unit: Unit, k: int, target: float, points: list[np.ndarray], a: np.ndarray, b: np.ndarray
) -> list[np.ndarray]:
    """Between points a and b, by halving, where result k is the target; norms go from one's to the other's."""

    def at(share: np.ndarray) -> list[np.ndarray]:
        made = []
        for arg, part in zip(unit.args, points, strict=True):
            value = part[a] * (1 - share) + part[b] * share
            if arg.norm:
                length = norm(part)
                value = value * ((length[a] * (1 - share) + length[b] * share) / norm(value))
            made.append(np.clip(value, arg.low, arg.high))
        return single(unit.args, made)

    low, high = np.zeros((len(a), 1)), np.ones((len(a), 1))
    sign = np.sign(results(unit, at(high))[k] - target)
    for _ in range(30):
        middle = (low + high) / 2
        past = (sign * (results(unit, at(middle))[k] - target) > 0)[:, None]
        low, high = np.where(past, low, middle), np.where(past, middle, high)
    return at(high)
