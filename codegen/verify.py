"""Proof that the generated C is what the model says, computed on the C itself.

For every printed unit, at random points of its box and at its corners: our C and CasADi's C give the same bits; both
lie within a running bound on rounding errors of the SymPy expressions in 50 digits; what the C leaves out as zero is
zero.  For a measurement matrix that is a first order of an exact measurement: it is its Jacobian in the limit, and the
difference falls linearly.
"""

import multiprocessing
import os
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np

from boresight.codegen.functions.samples import answered, generator, sample
from boresight.codegen.functions.tape import evaluate
from boresight.codegen.functions.units import DIGITS, Unit, UnitMaker, units
from boresight.codegen.generate import load_model
from boresight.codegen.text.vectors import exact
from boresight.derive.model import Measurement, Model
from boresight.runtime.library import Library, load

POINTS, CORNERS = 1000, 64
REFERENCE = 1e-30  # what the 50 digits are good for where they were differentiated numerically
LIMIT = 1e-12  # of a linear H and the Jacobian of the exact measurement, where nothing is neglected


@dataclass(frozen=True)
class UnitCheck:
    """largest_error: of any output, against 50 digits.  looseness: how many times the bound was larger than the error,
    where it came closest; below 1 the bound is broken."""

    model: str
    unit: str
    points: int
    outputs: int
    same_bits: bool
    largest_error: float
    looseness: float
    zeros_are_zero: bool

    @property
    def ok(self) -> bool:
        return self.same_bits and self.looseness >= 1 and self.zeros_are_zero


@dataclass(frozen=True)
class FirstOrderCheck:
    """limit: largest difference where the neglected input is zero, over the largest element (1 or more).  ratio: by
    what the difference falls when that input is halved.  coefficient: the difference over it, as it becomes small.
    Both are None where nothing is neglected."""

    model: str
    unit: str
    limit: float
    ratio: float | None
    coefficient: float | None

    @property
    def ok(self) -> bool:
        return self.limit <= LIMIT and (self.ratio is None or abs(self.ratio - 0.5) < 0.01)


def verify(
    target: str, folder: str | Path | None = None, points: int = POINTS, progress: Callable[[str], None] | None = None
) -> list[UnitCheck | FirstOrderCheck]:
    """Every check of one model: a built-in name, or FILE.py:NAME with the folder that was generated from it."""
    model = load_model(target)
    flight, casadi = (load(folder or target, backend) for backend in ("flight", "casadi"))
    made = units(model)

    def check(index: int) -> UnitCheck:
        return check_unit(model, made[index], flight, casadi, points)

    checks: list[UnitCheck | FirstOrderCheck] = []
    for unit, done in zip(made, side_by_side(check, len(made)), strict=True):
        if progress:
            progress(f"{model.name}: {unit.name}")
        checks.append(done)
    checks += [check_first_order(model, m, made, flight) for m in model.measurements if m.first_order is not None]
    return checks


_task: Callable[[int], Any] | None = None  # what the forked processes below run


def _run_task(index: int) -> Any:
    assert _task is not None
    return _task(index)


def side_by_side(task: Callable[[int], Any], count: int) -> Iterator[Any]:
    """task(0), task(1), ... in order, computed by as many processes as there are processors.

    They are forked, because what a task needs (CasADi's functions, a loaded library) cannot be sent to a process.
    """
    global _task
    _task = task
    with multiprocessing.get_context("fork").Pool(min(count, os.cpu_count() or 1)) as pool:
        yield from pool.imap(_run_task, range(count))


def check_unit(model: Model, unit: Unit, flight: Library, casadi: Library, points: int) -> UnitCheck:
    inputs = answered(unit, CORNERS, points + CORNERS, generator("verify", model.name, unit.name))
    fields = {a.name: values if a.size > 1 else values[:, 0] for a, values in zip(unit.args, inputs, strict=True)}
    ours, theirs = (as_dict(unit, getattr(library, unit.name)(**fields)) for library in (flight, casadi))
    same = all(ours[r.name].tobytes() == theirs[r.name].tobytes() for r in unit.results)

    _, bounds = evaluate(unit.tape, inputs)
    bound = {(output, nz): bounds[i] for i, (output, nz, _) in enumerate(unit.tape.results)}
    count = len(inputs[0]) if inputs else 1
    largest, looseness = 0.0, np.inf
    turn = 2 * mp.pi
    for k in range(count):
        for o, values in enumerate(exact(unit, inputs, k)):
            result = unit.results[o]
            for nz, value in enumerate(values):
                got = ours[result.name].reshape(count, *result.shape)[(k, *result.nonzeros[nz])]
                with mp.workdps(DIGITS):
                    difference = mp.mpf(float(got)) - value
                    if result.angle:
                        difference -= turn * mp.nint(difference / turn)
                    error = float(abs(difference))
                largest = max(largest, error)
                if not np.isfinite(got):
                    looseness = 0.0
                elif error > REFERENCE * max(1.0, abs(float(got))):
                    looseness = min(looseness, bound[o, nz][k] / error)
    return UnitCheck(
        model.name,
        unit.name,
        count,
        sum(len(r.nonzeros) for r in unit.results),
        same,
        largest,
        float(looseness),
        zeros_are_zero(unit, inputs),
    )


def as_dict(unit: Unit, result: Any) -> dict[str, np.ndarray]:
    return result if isinstance(result, dict) else {unit.results[0].name: result}


def zeros_are_zero(unit: Unit, inputs: list[np.ndarray]) -> bool:
    """Elements that the kernel does not write vanish in the reference too, to 30 digits of its largest element."""
    count = len(inputs[0]) if inputs else 1
    for k in range(0, count, max(1, count // 20)):
        matrices = unit.reference({a.name: [mp.mpf(float(v)) for v in inputs[i][k]] for i, a in enumerate(unit.args)})
        for matrix, result in zip(matrices, unit.results, strict=True):
            printed = set(result.nonzeros)
            scale = max([abs(v) for v in matrix] + [mp.mpf(1)])
            for row in range(result.shape[0]):
                for column in range(result.shape[1]):
                    if (row, column) not in printed and abs(matrix[row, column]) > scale * mp.mpf(10) ** -20:
                        return False
    return True


def check_first_order(model: Model, m: Measurement, made: list[Unit], library: Library) -> FirstOrderCheck:
    """Hold the compiled H against the Jacobian of the exact measurement at x = 0, as the neglected input shrinks.

    Where the exact measurement is printed, its compiled Jacobian is taken; otherwise h is differentiated in 50 digits.
    """
    law = m.first_order
    assert law is not None
    maker = UnitMaker(model)
    unit = next(u for u in made if u.name == f"{m.name}_H")
    full = next((u for u in made if u.name == f"{law.of}_H"), None)
    count = 200 if full else 20
    exact_H = maker.differentiate(m.h) if m.h is not None else None
    read = {a.name: a for a in ((*unit.args, *full.args) if full else maker.variables)}
    rng = generator("first order", model.name, m.name)
    drawn = sample(tuple(read.values()), 0, count, rng)
    # a law of rotations holds for quaternions of the norm that is meant, the middle of its range
    values = {
        a.name: v / np.linalg.norm(v, axis=1, keepdims=True) * (sum(a.norm) / 2) if a.norm else v / 2
        for a, v in zip(read.values(), drawn, strict=True)
    }
    values["x"] = np.zeros((count, model.n))
    directions = rng.standard_normal(values[law.small].shape) if law.small else np.ones((count, 1))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    tied = [(name, maker.numeric(expression)) for name, expression in law.tied]

    def point(k: int) -> dict[str, list[Any]]:
        return {key: [mp.mpf(float(v)) for v in value[k]] for key, value in values.items()}

    def compiled(u: Unit) -> np.ndarray:
        fields = {a.name: values[a.name] if a.size > 1 else values[a.name][:, 0] for a in u.args}
        return np.asarray(getattr(library, u.name)(**fields))

    def difference(scale: float) -> tuple[float, float]:
        """Largest, and largest as a part of the matrix."""
        if law.small:
            values[law.small] = scale * directions
        for name, expression in tied:
            values[name] = np.array([[float(v) for v in expression(point(k))[0]] for k in range(count)])
        if full:
            whole = compiled(full)
        else:
            assert exact_H is not None
            whole = np.array([exact_H(point(k))[0].tolist() for k in range(count)], dtype=float)
        away = np.abs(compiled(unit) - whole).max(axis=(1, 2))
        return float(away.max()), float((away / np.abs(whole).max(axis=(1, 2), initial=1.0)).max())

    _, at_zero = difference(0.0)
    if law.small is None:
        return FirstOrderCheck(model.name, unit.name, at_zero, None, None)
    small = 1e-3
    (at_small, _), (at_half, _) = difference(small), difference(small / 2)
    return FirstOrderCheck(model.name, unit.name, at_zero, at_half / at_small, at_half / (small / 2))


def to_json(checks: list[UnitCheck | FirstOrderCheck]) -> list[dict[str, Any]]:
    """One object a check, with its fields and `ok`; looseness is null where the C is exact."""
    return [
        {key: value if value != np.inf else None for key, value in asdict(c).items()} | {"ok": c.ok} for c in checks
    ]
