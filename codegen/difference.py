"""Two states of a model, held against each other: what it states, every entry of its matrices, what its C costs."""

import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import sympy as sp

from boresight import BoresightError
from boresight.codegen.functions.convert import to_casadi
from boresight.codegen.functions.samples import generator, sample
from boresight.codegen.functions.tape import evaluate, tape
from boresight.codegen.generate import Change, default_folder, load_model
from boresight.codegen.revision import committed
from boresight.codegen.text.equations import FILE, Words, equations_text, labels_of, places, read_equations, unchecked
from boresight.codegen.text.equations import matrices as expressions
from boresight.codegen.text.files import folder_files
from boresight.derive.constant import behind
from boresight.derive.expressions import constants_in, names_in, substituted, symbols_in, unnamed
from boresight.derive.model import Model, Variable
from boresight.derive.named import Named, Quantity
from boresight.derive.pages.model import JACOBIAN, slopes
from boresight.derive.pages.named import operations
from boresight.runtime.compiler import compile_sources, compiler, run

POINTS = 2000  # at which entries are compared
SMALLEST = ("-std=c99", "-Os", "-ffp-contract=off")


@dataclass(frozen=True)
class Statement:
    """What is said of a part beside its expressions, before and after; None where the part is not there."""

    part: str  # as `state dv_n`
    field: str
    before: str | None
    after: str | None


@dataclass(frozen=True)
class Entry:
    """An entry of a matrix before and after; None where it has no such row or column.

    largest: by how much the values differ at most, at the point `at`.  relative: the same over the largest entry of
    its row, each times what it multiplies; where that is largest.  rounding: the values nowhere differ by more than
    double precision explains.  constants: it is the same but for the values of constants.  by: the quantities whose
    change alone moves it.
    """

    matrix: str
    place: str
    before: Any
    after: Any
    largest: float | None = None
    relative: float | None = None
    at: Mapping[str, float] | None = None
    rounding: bool = False
    constants: bool = False
    by: tuple[str, ...] = ()


@dataclass(frozen=True)
class Cost:
    """The functions whose operations differ; bytes of code of the files that differ, before and after, or why not."""

    changes: tuple[Change, ...]
    before: int | None
    after: int | None
    unknown: str = ""


@dataclass(frozen=True)
class Difference:
    """old, new: as they are read from their texts.  entries: those that differ.  of: how many each matrix has.

    quantities: what differs in a named quantity itself, whose name is the `matrix` of its entries.
    """

    model: str
    against: str
    old: Model
    new: Model
    statements: tuple[Statement, ...]
    entries: tuple[Entry, ...]
    of: Mapping[str, int]
    cost: Cost | None = None
    quantities: tuple[Entry, ...] = ()

    @property
    def same(self) -> bool:
        return not self.statements and not self.entries and not self.quantities


def difference(target: str, against: str = "HEAD") -> Difference:
    """The model as its source states it now against a revision, or against the generated folder of that name.

    Raises BoresightError where there is nothing to compare with.
    """
    model = load_model(target)
    text, name = older(default_folder(target, model), against)
    found = compared(model.name, name, read_equations(text, name), now(model))
    return found if not found.entries else replace(found, cost=cost(found.old, found.new))


def older(folder: Path, against: str) -> tuple[str, str]:
    """The text of the model's equations there, and what it is called."""
    if not Path(against).is_dir():
        return committed(folder / FILE, against), against
    for path in (Path(against) / FILE, Path(against) / folder.name / FILE):
        if path.is_file():
            return path.read_text(encoding="utf-8"), str(path.parent)
    raise BoresightError(f"{against} holds no {FILE} of {folder.name}; name a folder that 'boresight generate' wrote")


def now(model: Model) -> Model:
    """As it would be read back: the other state is read too."""
    return read_equations(equations_text(model), model.name)


def compared(model: str, against: str, old: Model, new: Model) -> Difference:
    before, after = matrices(old), matrices(new)
    names = Names(old, new)
    found = [
        (key, place, a, b)
        for key in dict.fromkeys([*after, *before])
        for place, a, b in paired(before.get(key, {}), after.get(key, {}))
        if a != b
    ]
    plain = [unnamed(sp.Matrix(len(found), 1, [one[i] or 0 for one in found])) for i in (2, 3)]
    entries = [
        Entry(key, place, a, b, constants=a is not None and names.after(a) == b, by=names.moving(a, b))
        for (key, place, a, b), *plainly in zip(found, *plain, strict=True)
        if plainly[0] != plainly[1]
    ]
    quantities = names.changed
    of: list[dict[str, Any]] = [{e.matrix: {} for e in quantities} for _ in range(2)]
    for e in quantities:
        of[0][e.matrix][e.place], of[1][e.matrix][e.place] = e.before, e.after
    measured = Measured(old, new, before | of[0], after | of[1])
    statements = tuple(stated(described(old), described(new)))
    return Difference(
        model,
        against,
        old,
        new,
        statements,
        tuple(map(measured, entries)),
        {key: len(m) for key, m in after.items()},
        quantities=tuple(map(measured, quantities)),
    )


class Names:
    """The named quantities of two models, those of one name together.

    letters: of each side what stands for the entries of those that differ, one letter for both; what the other side
    does not have is written out.
    """

    def __init__(self, old: Model, new: Model):
        self.swap = swapped(old, new)
        sides = [names_in(*expressions(model)) for model in (old, new)]
        listed = [list(dict.fromkeys(entry.quantity for entry in side)) for side in sides]
        self.pairs: dict[str, tuple[Quantity, Quantity]] = {}
        for name in dict.fromkeys(one.name for one in listed[1]):
            left, right = ([one for one in side if one.name == name] for side in listed)
            same = len([one for one in right if one in left])
            left, right = [a for a in left if a not in right], [b for b in right if b not in left]
            for i, (a, b) in enumerate(zip(left, right, strict=False), same + 1):
                if (a.value.shape, a.labels) == (b.value.shape, b.labels):
                    self.pairs[name + f"_{i}" * (i > 1)] = a, b
        self.letters: tuple[dict[Any, Any], dict[Any, Any]] = ({}, {})
        for letters, side, others, which in zip(self.letters, sides, listed[::-1], (0, 1), strict=True):
            called = {both[which]: label for label, both in self.pairs.items()}
            for entry in side:
                if entry.quantity in called:
                    letters[entry] = letter(called[entry.quantity], entry)
                elif entry.quantity not in others:
                    letters[entry] = substituted(sp.Matrix([entry.value]), letters)[0]
        # The entries of quantities that differ themselves.
        self.changed = tuple(
            Entry(label, named_entry(label, component), a, b)
            for label, (before, after) in self.pairs.items()
            for component, a, b in zip(after.labels, before.value, after.value, strict=True)
            if self.own(a, b)
        )

    def after(self, value: Any) -> Any:
        """An expression of the old model with the constants of the new one."""
        return substituted(sp.Matrix([value]), self.swap)[0]

    def opaque(self, side: int, value: Any) -> Any:
        """With letters for the names that differ."""
        return substituted(sp.Matrix([value]), self.letters[side])[0]

    def own(self, a: Any, b: Any) -> bool:
        """Whether two expressions differ themselves, and not by the names in them nor by constants alone."""
        return bool(self.after(self.opaque(0, a)) != self.opaque(1, b))

    def moving(self, a: Any, b: Any) -> tuple[str, ...]:
        """The quantities that differ themselves and that an entry reads which does not."""
        if a is None or b is None or self.own(a, b):
            return ()
        read = {entry.quantity for entry in names_in(sp.Matrix([a, b]))}
        moved = dict.fromkeys(e.matrix for e in self.changed)
        return tuple(label for label in moved if not read.isdisjoint(self.pairs[label]))


def letter(label: str, entry: Named) -> sp.Symbol:
    return sp.Symbol(named_entry(label, entry.quantity.labels[entry.index]), real=True)


def named_entry(label: str, component: str) -> str:
    return f"{label}_{component}" if component else label


def swapped(old: Model, new: Model) -> dict[Any, Any]:
    """The constants of the old model that have another value in the new one, and those."""
    values = {one.name: one for one in constants_in(*expressions(new))}
    return {one: values[one.name] for one in constants_in(*expressions(old)) if values.get(one.name, one) != one}


Matrix = Mapping[str, Any]  # entries by their place, all of them


def matrices(model: Model) -> dict[str, Matrix]:
    """Every matrix of the model by its name, as `F` or `euler H`; Jacobians of short functions too."""
    found: dict[str, Matrix] = {}

    def put(name: str, matrix: Any, of: str = "", rows: tuple[str, ...] = ()) -> None:
        if matrix is not None and len(matrix):
            labels = {**labels_of([s.name for s in model.x], list(model.noise)), "r": rows}
            named = places(name, matrix.shape, labels)
            found[f"{of} {name}".strip()] = {place: matrix[at] for place, at in named.items()}

    def jacobian(column: Any) -> Any:
        short = column is not None and operations(unnamed(column)) < JACOBIAN
        return slopes(column, model.x) if short else None

    put("F", model.F if model.F is not None else jacobian(model.f))
    for name in ("f", "next", "Phi", "G", "noise", "Q"):
        put(name, getattr(model, name))
    for m in model.measurements:
        for name, matrix in (("z", m.z), ("h", m.h), ("H", m.H if m.H is not None else jacobian(m.h))):
            put(name, matrix, m.name, m.rows)
    for function in model.functions:
        for output in function.outputs:
            put(output.name, output.value, function.name)
    return found


def paired(before: Matrix, after: Matrix) -> Iterator[tuple[str, Any, Any]]:
    """Each place with what stands there; what is zero in a matrix that has no such place is no difference."""
    for place in dict.fromkeys([*after, *before]):
        a, b = before.get(place), after.get(place)
        if not (a is None and b == 0) and not (b is None and a == 0):
            yield place, a, b


# ---------------------------------------------------------------- what is stated beside expressions


def described(model: Model) -> dict[str, dict[str, str]]:
    """What the model says of each of its parts, in words."""

    def bounds(item: Any) -> list[str]:
        return [f"{low:.6g} to {high:.6g}" for low, high in zip(item.low, item.high, strict=True)]

    def variable(v: Variable) -> dict[str, str]:
        return {
            "components": ", ".join(s.name for s in v.symbols), "unit": v.unit, "meaning": v.meaning, "frame": v.frame,
            "box": ", ".join(dict.fromkeys(bounds(v))), "norm": " to ".join(map(str, v.norm or ())),
            "wraps": "to -pi to pi" * v.wraps,
        }  # fmt: skip

    parts = {
        "model": {
            "title": model.title, "kind": model.kind, "frame": model.frame, "prefix in C": model.c_prefix,
            "step": str(model.dt), "order": str(model.order), "in C": "by loops" * model.loops,
            "equations": ", ".join(model.equations),
            "conventions": " ".join(model.conventions),
        }
    }  # fmt: skip
    parts |= {f"state {v.name}": variable(v) for v in model.states}
    parts |= {f"input {v.name}": variable(v) | {"struct": s.name} for s in model.structs for v in s.fields}
    for m in model.measurements:
        parts[f"measurement {m.name}"] = {
            "rows": ", ".join(m.rows), "unit": m.unit, "meaning": m.meaning,
            "angles": ", ".join(m.rows if m.angle is True else m.angle or ()),
            "noise": "correlated" if m.correlated else "of independent rows", "equations": ", ".join(m.equations),
            "box of z": ", ".join(bounds(m)),
        }  # fmt: skip
    for f in model.functions:
        parts[f"function {f.name}"] = {"meaning": f.meaning, "equations": ", ".join(f.equations)}
        for o in f.outputs:
            box = ", ".join(bounds(o))
            parts[f"{o.name} of {f.name}"] = {"unit": o.unit, "meaning": o.meaning, "frame": o.frame, "box": box}
    for c in behind(constants_in(*expressions(model))):
        parts[f"constant {c.name}"] = {"value": shown(c.value), "unit": c.unit, "meaning": c.meaning}
    return parts


def shown(value: Any) -> str:
    """A decimal number where there is one of few digits, else the expression."""
    decimal = f"{float(value):.15g}"
    return decimal if value.is_Rational and sp.Rational(decimal) == value else str(value)


def stated(before: dict[str, dict[str, str]], after: dict[str, dict[str, str]]) -> Iterator[Statement]:
    """A part that is new or gone is one statement, else there is one for each field that differs."""
    for part in dict.fromkeys([*after, *before]):
        if part not in before or part not in after:
            stated = ", ".join(text for text in (before | after)[part].values() if text)
            yield Statement(part, "", stated if part in before else None, stated if part in after else None)
        else:
            old, new = before[part], after[part]
            yield from (Statement(part, key, old[key], new[key]) for key in new if old[key] != new[key])
    order = [[part for part in listed if part.startswith("state ")] for listed in (before, after)]
    if order[0] != order[1] and set(order[0]) == set(order[1]):
        yield Statement("model", "order of states", *(", ".join(p.removeprefix("state ") for p in o) for o in order))


# ---------------------------------------------------------------- numbers


class Measured:
    """How far entries are apart, at points drawn from the box of the new model."""

    def __init__(self, old: Model, new: Model, before: dict[str, Matrix], after: dict[str, Matrix]):
        self.model, self.before, self.after = new, before, after
        self.variables = together(old, new)
        self.symbols = {s: ca.SX.sym(s.name) for v in self.variables for s in v.symbols}
        self.points = drawn(self.variables, generator("difference", new.name))
        self.at = {s.name: part[:, i] for v, part in zip(self.variables, self.points, strict=True)
                   for i, s in enumerate(v.symbols)}  # fmt: skip
        self.noise = {place: value for model in (old, new) for place, value in zip(
            labels_of([], list(model.noise))["w"], model.noise, strict=True)}  # fmt: skip
        self.box = {s.name: max(abs(low), abs(high)) for model in (old, new) for v in model.states
                    for s, low, high in zip(v.symbols, v.low, v.high, strict=True)}  # fmt: skip

    def __call__(self, entry: Entry) -> Entry:
        if entry.before is None or entry.after is None:
            return entry
        row, _, column = entry.place.partition(" by ")
        same_row = {
            (which, place): value
            for which, matrix in enumerate((self.before[entry.matrix], self.after[entry.matrix]))
            for place, value in matrix.items()
            if place.partition(" by ")[0] == row and value != 0
        }
        scaled = [value * self.multiplier(entry.matrix, place.partition(" by ")[2])
                  for (_, place), value in same_row.items()]  # fmt: skip
        own = self.multiplier(entry.matrix, column)
        values, bounds = self.evaluated([entry.before, entry.after, own, *scaled])
        apart = abs(values[1] - values[0])
        known = np.flatnonzero(np.isfinite(values).all(axis=0) & np.isfinite(bounds[:2]).all(axis=0))
        if not len(known):
            return entry
        worst = known[np.argmax(apart[known])]
        row_largest = abs(values[3:]).max(axis=0, initial=0.0)
        relative = np.divide(apart * abs(values[2]), row_largest, out=np.zeros_like(apart), where=row_largest > 0)
        read = {s.name for s in symbols_in(sp.Matrix([entry.before, entry.after]))}
        return replace(
            entry,
            largest=float(apart[worst]),
            relative=float(relative[known].max()),
            at={name: float(part[worst]) for name, part in self.at.items() if name in read},
            rounding=bool((apart[known] <= (bounds[0] + bounds[1])[known]).all()),
        )

    def multiplier(self, matrix: str, column: str) -> Any:
        """What an entry of this column stands before, so that a row has one unit: a noise, or the box of a state."""
        kind = matrix.rpartition(" ")[2]
        if kind == "G":
            return self.noise.get(column, sp.S.One)
        box = sp.Float(self.box.get(column, 1.0)) if kind in "FHQ" else sp.S.One
        return 1 / box if kind == "Q" else box

    def evaluated(self, expressions: list[Any]) -> tuple[np.ndarray, np.ndarray]:
        """(expressions, points) each: values, and bounds on their rounding errors."""
        (column,) = to_casadi([sp.Matrix(expressions)], self.symbols)
        inputs = [ca.vertcat(*(self.symbols[s] for s in v.symbols)) for v in self.variables]
        program = tape(ca.Function("difference", inputs, [ca.densify(column)]))
        values, bounds = evaluate(program, self.points)
        order = np.argsort([nonzero for _, nonzero, _ in program.results])
        return np.array(values)[order], np.array(bounds)[order]


def drawn(variables: tuple[Variable, ...], rng: np.random.Generator) -> list[np.ndarray]:
    """(POINTS, size) for each variable.  In half of the points a component is as often at either end of its box as
    within it, unless a norm binds it: extremes lie there."""
    points = sample(variables, 0, POINTS, rng)
    for v, part in zip(variables, points, strict=True):
        place = rng.integers(0, 3, part.shape)
        place[: POINTS // 2] = 2
        if v.norm is None:
            part[:] = np.where(place == 0, v.low, np.where(place == 1, v.high, part))
    return points


def together(old: Model, new: Model) -> tuple[Variable, ...]:
    """The variables of both; where they have the same symbols, those of the new one."""
    listed = [*new.states, *new.inputs]
    known = {s for v in listed for s in v.symbols}
    for v in (*old.states, *old.inputs):
        left = [i for i, s in enumerate(v.symbols) if s not in known]
        if left:
            symbols, low, high = (tuple(value[i] for i in left) for value in (v.symbols, v.low, v.high))
            name = v.name + "_before" * (v.name in {other.name for other in listed})
            own = {"name": name, "symbols": symbols, "low": low, "high": high}
            whole = len(left) == v.size
            listed.append(unchecked(Variable, **{**vars(v), **own, "norm": v.norm if whole else None}))
    return tuple(listed)


# ---------------------------------------------------------------- cost


def cost(old: Model, new: Model) -> Cost:
    """Both printed by this generator, so that what differs comes from the model."""
    try:
        (before, old_files), (after, new_files) = (folder_files(model, lambda *_: "not needed") for model in (old, new))
    except BoresightError as error:  # what was accepted once may be refused now
        return Cost((), None, None, str(error))
    a, b = before["units"], after["units"]
    changes = tuple(
        Change(unit, a.get(unit, {}).get("operations"), b.get(unit, {}).get("operations"))
        for unit in dict.fromkeys([*b, *a])
        if a.get(unit, {}).get("hash") != b.get(unit, {}).get("hash")
    )
    sources = {path for path in old_files.keys() | new_files.keys() if path.startswith("src/")}
    differing = {path for path in sources if old_files.get(path) != new_files.get(path)}
    try:
        return Cost(changes, text_size(old_files, differing), text_size(new_files, differing))
    except BoresightError as error:
        return Cost(changes, None, None, str(error))


def text_size(files: dict[str, str], differing: set[str]) -> int:
    """Bytes of code of those sources that differ, by themselves or by the kernel that they include."""
    stems = {Path(path).stem.removesuffix("_kernel") for path in differing}
    with tempfile.TemporaryDirectory(prefix="boresight-") as aside:
        folder = Path(aside)
        for path, text in files.items():
            if path.startswith(("src/", "include/")):
                (folder / path).parent.mkdir(exist_ok=True)
                (folder / path).write_text(text, encoding="utf-8")
        sources = [path for path in sorted((folder / "src").glob("*.c")) if path.stem in stems]
        if not sources:
            return 0
        flags = [*compiler(), *SMALLEST, f"-I{folder / 'include'}"]
        objects = compile_sources(flags, {source: () for source in sources}, folder)
        try:
            lines = run(["size", *objects.values()]).splitlines()[1:]
        except FileNotFoundError:
            raise BoresightError("'size' of binutils is not found") from None
        return sum(int(line.split()[0]) for line in lines)


# ---------------------------------------------------------------- JSON


def to_json(found: Difference) -> dict[str, Any]:
    """Expressions are as in equations.json: what stands in several places is named once, in `where`."""
    every = (*found.quantities, *found.entries)
    words = Words(e for entry in every for e in (entry.before, entry.after) if e is not None)
    numbers = ("largest", "relative", "at", "rounding", "constants", "by")

    def written(e: Entry, of: str) -> dict[str, Any]:
        sides = (("before", e.before), ("after", e.after))
        text = {name: None if value is None else words(value) for name, value in sides}
        return {of: e.matrix, "entry": e.place, **text, **{name: getattr(e, name) for name in numbers}}

    quantities = [written(e, "quantity") for e in found.quantities]
    entries = [written(e, "matrix") for e in found.entries]
    made = found.cost
    return {
        "model": found.model,
        "against": found.against,
        "same": found.same,
        "statements": [asdict(statement) for statement in found.statements],
        "quantities": quantities,
        "entries": entries,
        "named": words.named,
        "where": words.where,
        "operations": made and [{"function": c.name, "before": c.before, "after": c.after} for c in made.changes],
        "bytes": made and {"before": made.before, "after": made.after, "unknown": made.unknown},
    }
