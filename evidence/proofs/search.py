"""The worst rounding error of an output that a search finds: random points and corners of the box, then breeding.

The list itself runs in single precision, operation by operation, against double.  Sines are rounded correctly here,
which is less than what the bound allows them.
"""

from dataclasses import replace
from typing import Any

import numpy as np

from boresight.codegen.folder import Source
from boresight.codegen.functions.samples import generator
from boresight.codegen.functions.tape import COMPUTE, LIBRARY, Tape, computed
from boresight.codegen.functions.unit import Unit
from boresight.derive.model import Variable
from boresight.evidence.calls import points_of
from boresight.evidence.proofs.script import cone
from boresight.evidence.rounding import CHUNK, CORNERS, RUNS

KEPT, BRED, GENERATIONS = 100, 1000, 60
FAR, AGAIN, FEW = 8, 4, 20  # where a bound is so many times larger, so many more searches, from so few points each
Found = tuple[np.ndarray, np.ndarray]  # errors, and the points that have them


def in_single(program: Tape, inputs: list[np.ndarray]) -> list[np.ndarray]:
    """What each step gives in single precision: `+ - * /` and roots as IEEE 754 says, functions rounded correctly."""
    zero = np.zeros(len(inputs[0]) if inputs else 1, np.float32)
    value: list[np.ndarray] = []
    for step in program.steps:
        if step.op == "input":
            value.append(inputs[step.source[0]][:, step.source[1]].astype(np.float32))
        elif step.op == "const":
            value.append(zero + np.float32(step.constant))
        elif step.op in LIBRARY or step.op == "atan2":
            value.append(COMPUTE[step.op](*(value[i].astype(float) for i in step.args)).astype(np.float32))
        elif step.op == "inv":
            value.append(np.float32(1) / value[step.args[0]])
        elif step.op == "twice":
            value.append(np.float32(2) * value[step.args[0]])
        else:
            value.append((COMPUTE[step.op](*(value[i] for i in step.args)) + zero).astype(np.float32))
    return value


def sliced(program: Tape, position: int) -> Tape:
    """The list of one value alone."""
    steps = cone(program, position)
    place = {k: i for i, k in enumerate(steps)}
    moved = tuple(replace(program.steps[k], args=tuple(place[a] for a in program.steps[k].args)) for k in steps)
    return Tape(moved, ((0, 0, place[position]),))


@np.errstate(all="ignore")
def errors(program: Tape, inputs: list[np.ndarray], positions: list[int]) -> np.ndarray:
    """Of each position at each point: by how much single precision is off; 0 where either is no number."""
    single, exact = in_single(program, inputs), computed(program, inputs)
    off = np.array([np.abs(single[p].astype(float) - exact[p]) for p in positions])
    return np.where(np.isfinite(off), off, 0.0)


def begun(source: Source, unit: Unit, positions: list[int]) -> dict[int, Found]:
    """Of each position the worst of so many random points and corners of the unit's box."""
    rng = generator("proofs", source.name)
    found: dict[int, Found] = dict.fromkeys(positions, (np.zeros(0), np.zeros((0, sum(a.size for a in unit.args)))))
    for drawn in range(0, RUNS if unit.args else 0, CHUNK):
        points = points_of(source, CHUNK, CORNERS if drawn == 0 else 0, rng)
        inputs = [points[arg.name].astype(np.float32).astype(float) for arg in unit.args]
        flat = np.hstack(inputs)
        for position, off in zip(positions, errors(unit.tape, inputs, positions), strict=True):
            found[position] = keep(*added(found[position], off, flat))
    return found


def worst(source: Source, unit: Unit, bounds: dict[int, float]) -> dict[int, float]:
    """Position -> the largest error found; where its bound is far beyond that, after more effort."""
    rng = generator("bred", source.name)
    found = {}
    for position, (off, points) in begun(source, unit, sorted(bounds)).items():
        program = sliced(unit.tape, position)
        most = bred(program, unit.args, (off, points), GENERATIONS, rng) if len(off) else 0.0
        for _ in range(AGAIN):
            if most and bounds[position] > FAR * most:
                some = rng.permutation(len(off))[:FEW]
                most = max(most, bred(program, unit.args, (off[some], points[some]), 5 * GENERATIONS, rng))
        found[position] = most
    return found


def added(found: Found, off: np.ndarray, points: np.ndarray) -> Found:
    return np.append(found[0], off), np.vstack([found[1], points])


def keep(off: np.ndarray, points: np.ndarray, count: int = KEPT) -> Found:
    order = np.argsort(off)[::-1][:count]
    return off[order], points[order]


def bred(program: Tape, args: tuple[Variable, ...], found: Found, generations: int, rng: Any) -> float:
    """The largest error after some generations: children mix two parents and move in a few numbers, far or a little."""
    off, points = found
    count = len(off)
    low, high = (np.concatenate([getattr(a, end) for a in args]).astype(float) for end in ("low", "high"))
    used = sorted({sum(a.size for a in args[: s.source[0]]) + s.source[1] for s in program.steps if s.op == "input"})
    if not off.max() or not used:
        return float(off.max())
    moves = np.isin(np.arange(len(low)), used)
    cuts = np.cumsum([a.size for a in args])[:-1]
    for _ in range(generations):
        one, other = (points[rng.integers(0, len(points), BRED)] for _ in range(2))
        children = np.where(rng.random(one.shape) < 0.5, one, other)
        scale = (high - low) * 10.0 ** rng.uniform(-8, 0, (BRED, 1))
        moved = children + scale * rng.standard_normal(one.shape)
        children = np.where((rng.random(one.shape) < 2 / len(used)) & moves, moved, children)
        edge = np.where(rng.random(one.shape) < 0.5, low, high)
        children = np.where((rng.random(one.shape) < 0.1 / len(used)) & moves, edge, children)
        children = np.clip(children, low, high)
        fields = np.split(children, cuts, axis=1)
        for field, arg in zip(fields, args, strict=True):
            if arg.norm is not None:
                length = np.linalg.norm(field, axis=1, keepdims=True)
                # a little inside, so that no rounding leaves the range
                field *= np.clip(length, arg.norm[0] * (1 + 1e-6), arg.norm[1] * (1 - 1e-6)) / np.maximum(length, 1e-9)
        single = [field.astype(np.float32).astype(float) for field in fields]
        (of,) = errors(program, single, [program.results[0][2]])
        off, points = keep(*added((off, points), of, np.hstack(single)), count)
    return float(off.max())
