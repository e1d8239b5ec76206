"""Proof that the generated C is what the model says, computed on the C itself.

For every printed unit, at random points of its box and at its corners: our C and CasADi's C give the same bits; both
lie within a running bound on rounding errors of the SymPy expressions in 50 digits; what the C leaves out as zero is
zero.  For a measurement matrix that is a first order of an exact measurement: it is its Jacobian in the limit, and the
difference falls linearly.  What the model says is held against exact mechanics in codegen/mechanics.py, and what is
flown over steps of time in codegen/flown.py.
"""

import multiprocessing
import os
import signal
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import asdict, dataclass
from math import inf, isfinite, isnan
from multiprocessing.connection import Connection, wait
from pathlib import Path
from typing import Any, Union

import numpy as np
from flint import arb

from boresight import BoresightError
from boresight.codegen.beside import check_beside
from boresight.codegen.flat import check_flat
from boresight.codegen.flown import check_flown
from boresight.codegen.functions.maker import UnitMaker
from boresight.codegen.functions.reference import Entries, precise
from boresight.codegen.functions.samples import answered, generator
from boresight.codegen.functions.tape import evaluate
from boresight.codegen.functions.unit import Unit
from boresight.codegen.functions.units import units
from boresight.codegen.generate import generated_folder, known, load_model, model_names, named
from boresight.codegen.mechanics import MechanicsCheck, check_mechanics
from boresight.codegen.noises import check_noise
from boresight.codegen.origins import check_origins
from boresight.codegen.points import drawn, nearest_zero
from boresight.codegen.residuals import check_residuals
from boresight.codegen.scales import check_scales
from boresight.codegen.unheld import with_unheld
from boresight.codegen.words import check_words
from boresight.derive.model import Measurement, Model, Variable
from boresight.derive.within import within
from boresight.runtime.library import Library, load

POINTS, CORNERS = 1000, 64
WIDEST = 1e-45  # of the largest number of a matrix: a reference that knows less proves nothing
NEGLECTED = 1e-3  # of its own unit: how small a neglected input becomes, or half of the smallest that is drawn
LIMIT = 1e-12  # of a linear H and the Jacobian of the exact measurement, where nothing is neglected

ZERO = arb(0)
ROUNDING = 2.0**-53  # of double precision

Check = Union["UnitCheck", "FirstOrderCheck", MechanicsCheck]
Progress = Callable[[int, int, str], None]  # functions done, of all, and which one is


@dataclass(frozen=True)
class UnitCheck:
    """largest_error: of any output, against 50 digits.  looseness: how many times the bound was larger than the error,
    where it came closest; below 1 the bound is broken.  width: the largest radius of what the 50 digits are known to,
    over the largest number that it is made of.  scale: the largest output."""

    model: str
    unit: str
    points: int
    outputs: int
    same_bits: bool
    largest_error: float
    looseness: float
    zeros_are_zero: bool
    width: float
    scale: float = 0.0

    @property
    def reason(self) -> str:
        """Why it is not ok."""
        known = f"of {self.largest_error:.1e} where outputs are up to {self.scale:.3g}"
        found = {
            "the bits are not those of CasADi's C": not self.same_bits,
            f"an error {known} lies beyond the bound on rounding": not self.looseness >= 1,
            f"there is an error {known}": not isfinite(self.largest_error),
            "an element that is left out is not zero": not self.zeros_are_zero,
            f"50 digits know the result to {self.width:.0e} only": not within(self.width, WIDEST),
        }
        return "; ".join(text for text, wrong in found.items() if wrong)

    @property
    def ok(self) -> bool:
        return not self.reason


@dataclass(frozen=True)
class FirstOrderCheck:
    """limit: largest difference where the neglected input is zero, over the largest element (1 or more).  ratio: by
    what the difference falls when that input is halved.  coefficient: the difference over it, as it becomes small.
    Both are None where nothing is neglected.  entry: what keeps it from being looked at; it is then no number."""

    model: str
    unit: str
    limit: float
    ratio: float | None
    coefficient: float | None
    entry: str = ""

    @property
    def reason(self) -> str:
        """Why it is not ok."""
        if self.entry:
            return self.entry
        if not within(self.limit, LIMIT):
            return f"it differs by {self.limit:.1e} of the largest element where nothing is neglected"
        falls = self.ratio is None or within(abs(self.ratio - 0.5), 0.01)
        return "" if falls else f"half of what it neglects leaves {self.ratio:.3f} of the difference, not half"

    @property
    def ok(self) -> bool:
        return not self.reason


def verify(
    target: str | Model, folder: str | Path | None = None, points: int = POINTS, progress: Progress | None = None
) -> list[Check]:
    """Prove the generated C of a model, and hold the model against exact mechanics.

    Parameters
    ----------
    target : str or Model
        A built-in name, FILE.py:NAME, or the Model itself.
    folder : str or Path, optional
        Where its C was generated, by default as for `generate`.
    points : int, optional
        Random points in the box of each function's inputs, 1 or more; its corners come besides.
    progress : function, optional
        Called with the number of functions done, that of all, and the name of the last one.

    Returns
    -------
    list of checks
        Of each, `ok` says whether it holds.  `UnitCheck`: our C has CasADi's bits and lies within
        the rounding of 50 digits.  `FirstOrderCheck`: a linear H is the first order of an exact
        measurement.  `MechanicsCheck`: F, G, Phi, Q, H and functions against mechanics; where there
        is nothing to hold them against, `ok` is None, or True if `Model.unheld` gives a reason.

    Raises
    ------
    BoresightError
        A model or folder that is not there, a file that was edited, no C compiler, points below 1.

    Notes
    -----
    When not to use it: as a test of a filter's tuning; that is `Consistency`.  It takes seconds to
    minutes and all processors: run it after an edit of the model, not in a loop.

    Examples
    --------
    The model of the example of `generate`, which has been generated:

    >>> from boresight import verify
    >>> checks = verify(model, points=10)
    >>> [check.unit for check in checks if not check.ok]
    []
    """
    if not isinstance(points, int) or points < 1:
        raise BoresightError(f"verify: points is {points!r}; give a whole number of 1 or more")
    if isinstance(target, str) and ":" not in target:
        known(target, model_names())
        return verify_all([(target, folder)], points, progress)
    name, model = named(target)
    return verify_all([(name, folder or generated_folder(name, model=model))], points, progress, {name: model})


def verify_all(
    targets: Sequence[tuple[str, str | Path | None]],
    points: int = POINTS,
    progress: Progress | None = None,
    models: Mapping[str, Model] | None = None,
) -> list[Check]:
    """Every check of the models, each with its folder (None: that of a built-in model).  models: those loaded already.

    The points of a model are shared out to as many processes as there are processors; meanwhile this one prepares the
    next model.
    """
    libraries = [
        [load(folder or target, backend, lanes=1) for backend in ("flight", "casadi")] for target, folder in targets
    ]
    total, done = sum(len(flight.units) for flight, _ in libraries), 0
    checks: list[Check] = []

    def collect(underway: "Underway") -> None:
        nonlocal done
        for case in underway.finished():
            done += 1
            if progress:
                progress(done, total, f"{underway.model.name}: {case.unit.name}")
        checks.extend(case.verdict(underway.model) for case in underway.cases)
        checks.extend(underway.laws)

    with ExitStack() as stack:
        before: Underway | None = None
        for (target, _), (flight, casadi) in zip(targets, libraries, strict=True):
            model = (models or {}).get(target) or load_model(target)
            made = units(model)
            cases = [prepare(model, unit, flight, casadi, points) for unit in made]
            if before:
                collect(before)
            before = Underway(model, cases, stack)
            before.laws = [check_first_order(model, m, made, flight) for m in model.measurements if m.first_order]
            before.laws += laws(model, made)
        if before:
            collect(before)
    return checks


def laws(model: Model, made: list[Unit]) -> list[MechanicsCheck]:
    """The expressions of a model held against exact mechanics, and what nothing holds; made: its units."""
    references = {unit.name: unit.reference for unit in made}
    checks = check_mechanics(model, references) + check_flown(model, references)
    known = {check.unit for check in checks}
    checks += [check for check in (*check_beside(model), *check_flat(model)) if check.unit not in known]
    beside = check_residuals(model) + check_origins(model) + check_scales(model) + check_noise(model)
    return with_unheld(model, checks + beside + check_words(model))


@dataclass(frozen=True)
class Part:
    """What some of the points of a unit say; the fields are those of UnitCheck."""

    largest_error: float = 0.0
    looseness: float = inf
    zeros_are_zero: bool = True
    width: float = 0.0

    def __add__(self, other: "Part") -> "Part":
        return Part(
            worst(self.largest_error, other.largest_error),
            -worst(-self.looseness, -other.looseness),
            self.zeros_are_zero and other.zeros_are_zero,
            worst(self.width, other.width),
        )


def worst(*values: float) -> float:
    """The largest; infinite where one is no number."""
    return inf if any(map(isnan, values)) else max(values)


@dataclass
class Case:
    """A unit at its points.  inputs: (points, size) each; got, bounds: (points, non-zeros) each, of our C."""

    unit: Unit
    inputs: list[np.ndarray]
    got: list[np.ndarray]
    bounds: list[np.ndarray]
    same_bits: bool
    part: Part = Part()

    @property
    def count(self) -> int:
        return len(self.inputs[0]) if self.inputs else 1

    def verdict(self, model: Model) -> UnitCheck:
        outputs = sum(len(r.nonzeros) for r in self.unit.results)
        scale = worst(*(float(np.abs(values).max(initial=0.0)) for values in self.got), 0.0)
        part = asdict(self.part)
        return UnitCheck(model.name, self.unit.name, self.count, outputs, self.same_bits, **part, scale=scale)


class Underway:
    """The cases of one model, shared out to processes: each takes every n-th point of each case.

    They are forked, because what they need (CasADi's functions, a loaded library) cannot be sent to a process, and with
    pipes alone, because a pool would start threads, beside which the next model could not fork.
    """

    def __init__(self, model: Model, cases: list[Case], stack: ExitStack):
        self.model, self.cases = model, cases
        self.laws: list[Check] = []
        self.shares = os.cpu_count() or 1
        self.processes: dict[Connection, Any] = {}
        context = multiprocessing.get_context("fork")
        for share in range(self.shares):
            receiver, sender = context.Pipe(duplex=False)
            process = context.Process(target=self.answer, args=(share, sender), daemon=True)
            process.start()
            sender.close()
            stack.callback(process.kill)
            self.processes[receiver] = process

    def answer(self, share: int, sender: Connection) -> None:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C ends the parent, which ends this one
        for index, case in enumerate(self.cases):
            sender.send((index, check_points(case, share, self.shares)))

    def finished(self) -> Iterator[Case]:
        """Each case as the last process has answered for it."""
        missing = [self.shares] * len(self.cases)
        while self.processes:
            for receiver in wait(list(self.processes)):
                assert isinstance(receiver, Connection)
                try:
                    index, part = receiver.recv()
                except EOFError:
                    self.processes.pop(receiver).join()
                    continue
                case = self.cases[index]
                case.part += part
                missing[index] -= 1
                if not missing[index]:
                    yield case
        if any(missing):
            raise BoresightError(f"{self.model.name}: a process of verify ended before its points were checked")


def called(library: Library, unit: Unit, values: Mapping[str, np.ndarray]) -> Any:
    """What the unit gives at many points; values: (points, size) of each argument.  A field of one number, which x is
    not, goes without its last axis."""
    fields = {a.name: values[a.name] if a.size > 1 or a.name == "x" else values[a.name][:, 0] for a in unit.args}
    return getattr(library, unit.name)(**fields)


def prepare(model: Model, unit: Unit, flight: Library, casadi: Library, points: int) -> Case:
    inputs = answered(unit, CORNERS, points + CORNERS, generator("verify", unit.name, *(a.name for a in unit.args)))
    values = {a.name: part for a, part in zip(unit.args, inputs, strict=True)}
    ours, theirs = (as_dict(unit, called(library, unit, values)) for library in (flight, casadi))
    same = all(ours[r.name].tobytes() == theirs[r.name].tobytes() for r in unit.results)
    count = len(inputs[0]) if inputs else 1
    got = [
        ours[r.name].reshape(count, -1)[:, [row * r.shape[1] + column for row, column in r.nonzeros]]
        for r in unit.results
    ]
    bounds = [np.empty_like(values) for values in got]
    for (output, nz, _), bound in zip(unit.tape.results, evaluate(unit.tape, inputs)[1], strict=True):
        bounds[output][:, nz] = bound
    case = Case(unit, inputs, got, bounds, same)
    unit.reference(point(case, 0))  # compiled here, once for all processes
    return case


def point(case: Case, k: int) -> dict[str, list[float]]:
    return {a.name: values[k].tolist() for a, values in zip(case.unit.args, case.inputs, strict=True)}


def check_points(case: Case, first: int, step: int) -> Part:
    """Every step-th point from `first` on.  Elements that the kernel does not write must vanish in the reference too;
    an error inside the reference's own radius is none."""
    part = Part()
    printed = [dict.fromkeys(result.nonzeros) for result in case.unit.results]
    got, bounds = [all_of[first::step] for all_of in case.got], [all_of[first::step] for all_of in case.bounds]
    errors = [np.zeros_like(bound) for bound in bounds]
    with precise():
        turn = 2 * arb.pi()
        for row, k in enumerate(range(first, case.count, step)):
            for o, entries in enumerate(case.unit.reference(point(case, k))):
                off = [entries.get(at, ZERO) - v for at, v in zip(printed[o], got[o][row].tolist(), strict=True)]
                turning = [row in case.unit.results[o].angle for row, _ in case.unit.results[o].nonzeros]
                off = [
                    d - turn * round(float(d / turn)) if angle and d.is_finite() else d
                    for d, angle in zip(off, turning, strict=True)
                ]
                errors[o][row] = [float(d.abs_lower()) for d in off]
                zeros = all(entries[at].contains(ZERO) for at in entries.keys() - printed[o].keys())
                # what the running bound follows is as large as the bound over one rounding
                made_of = worst(*bounds[o][row].tolist(), 0.0) / ROUNDING
                part += Part(zeros_are_zero=zeros, width=relative_width(entries, made_of))
    for values, bound, error in zip(got, bounds, errors, strict=True):
        loose = np.divide(bound, error, where=error > 0, out=np.full_like(bound, inf))
        loose[~(np.isfinite(values) & np.isfinite(error) & np.isfinite(bound))] = 0.0
        part += Part(float(error.max(initial=0.0)), float(loose.min(initial=inf)))
    return part


def relative_width(entries: Entries, made_of: float = 0.0) -> float:
    """The largest radius over the largest number of a matrix, or over those that it is made of; infinite where one is
    no number.  A result that is zero since large numbers cancel has no size of its own."""
    values = entries.values()
    if not all(map(arb.is_finite, values)):
        return inf
    radius = worst(*map(float, map(arb.rad, values)), 0.0)
    largest = worst(*map(abs, map(float, values)), made_of)
    return radius and (radius / largest if largest else inf)


def as_dict(unit: Unit, result: Any) -> dict[str, np.ndarray]:
    return result if isinstance(result, dict) else {unit.results[0].name: result}


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
    exact_H = maker.numeric(m.h, jacobian=True) if m.h is not None else None
    read = {a.name: a for a in ((*unit.args, *full.args) if full else maker.variables)}
    tied = [(name, maker.numeric(expression)) for name, expression in law.tied]
    values = {name: drawn(v, count, f"{unit.name} first order") for name, v in read.items()}
    values["x"] = np.zeros((count, model.n))
    if law.small and any(zero != 0 for zero in nearest_zero(read[law.small])):
        return FirstOrderCheck(
            model.name, unit.name, inf, None, None, f"{law.small} is neglected, and its box does not hold 0; widen it"
        )
    whole = values.get(law.small or "", np.ones((count, 1)))
    lengths = np.linalg.norm(whole, axis=1, keepdims=True)
    small = min(NEGLECTED, lengths.min() / 2)

    def exact(reference: Callable[..., list[Entries]], shape: tuple[int, int]) -> np.ndarray:
        """(count, *shape) in double."""
        out = np.zeros((len(values["x"]), *shape))
        for k in range(len(out)):
            for place, value in reference({key: v[k].tolist() for key, v in values.items()})[0].items():
                out[k][place] = float(value)
        return out

    def shrink(scale: float) -> None:
        """The neglected input made as long as that, and what is tied to the others."""
        if law.small:
            values[law.small] = scale * whole / lengths
        for name, expression in tied:
            values[name] = exact(expression, (read[name].size, 1))[..., 0]

    def difference(scale: float) -> tuple[float, float]:
        """Largest, and largest as a part of the matrix."""
        shrink(scale)
        ours = np.asarray(called(library, unit, values))
        if full:
            theirs = np.asarray(called(library, full, values))
        else:
            assert exact_H is not None
            theirs = exact(exact_H, (len(m.rows), model.n))
        away = np.abs(ours - theirs).max(axis=(1, 2))
        return float(away.max()), float((away / np.abs(theirs).max(axis=(1, 2), initial=1.0)).max())

    scales = (0.0, small, small / 2) if law.small else (0.0,)
    inside = np.ones(count, dtype=bool)
    for scale in scales:
        shrink(scale)
        for name, _ in law.tied:
            inside &= lies_inside(read[name], values[name])
    if not inside.any():
        names = ", ".join(name for name, _ in law.tied)
        return FirstOrderCheck(model.name, unit.name, inf, None, None, f"{names} as tied leaves its box at every point")
    values = {name: v[inside] for name, v in values.items()}
    whole, lengths = whole[inside], lengths[inside]
    try:
        found = [difference(scale) for scale in scales]
    except BoresightError as error:
        return FirstOrderCheck(model.name, unit.name, inf, None, None, str(error))
    if law.small is None:
        return FirstOrderCheck(model.name, unit.name, found[0][1], None, None)
    (_, at_zero), (at_small, _), (at_half, _) = found
    ratio = at_half / at_small if at_small else inf
    return FirstOrderCheck(model.name, unit.name, at_zero, ratio, at_half / (small / 2))


def lies_inside(v: Variable, values: np.ndarray) -> np.ndarray:
    """(points,) whether the values (points, size) lie in the box of v and in the range of its norm."""
    least, most = v.norm or (0.0, inf)
    length = np.linalg.norm(values, axis=1)
    inside: np.ndarray = ((v.low <= values) & (values <= v.high)).all(axis=1) & (least <= length) & (length <= most)
    return inside


def counted(checks: Sequence[Check]) -> dict[str, int]:
    """How many passed, failed, were not checked, and are listed by their model as what cannot be."""
    rows = [check for check in checks if not getattr(check, "stated", False)]
    listed = [check for check in rows if getattr(check, "unheld", "")]
    return {
        "passed": sum(check.ok is True for check in rows) - len(listed),
        "failed": sum(check.ok is False for check in rows),
        "not checked": sum(check.ok is None for check in rows),
        "listed": len(listed),
    }


def status(checks: Sequence[Check], strict: bool = False) -> int:
    """The exit status: 0 all held, 1 something wrong, 3 nothing wrong but not all held.

    strict: what a model lists as held against nothing is not held.
    """
    count = counted(checks)
    return 1 if count["failed"] else 3 if count["not checked"] or (strict and count["listed"]) else 0


def to_json(checks: list[Check]) -> list[dict[str, Any]]:
    """One object a check, with its fields and `ok`; what is not finite is null, as looseness where the C is exact; ok
    is null where nothing was held against exact mechanics."""

    def shown(value: Any) -> Any:
        return None if isinstance(value, float) and not isfinite(value) else value

    return [{key: shown(value) for key, value in asdict(c).items()} | {"ok": c.ok, "reason": c.reason} for c in checks]
