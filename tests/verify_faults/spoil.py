"""Faults of a model's expressions, each one change drawn by a seed, and a hash of all that a model says."""

import dataclasses
import hashlib
import importlib.util
import random
import sys

from sympy import Abs, Matrix, log, sqrt
from sympy.matrices import MatrixBase

from boresight import BoresightError, constant
from boresight.derive import models
from boresight.derive.expressions import substituted
from boresight.derive.linear import completed
from boresight.derive.named import Named

RATES = ("F", "G", "f", "next", "Q", "Phi")


def say(key, what):
    print("spoil:", *key, "|", what, file=sys.stderr)


def parts(model):
    """Each matrix of the model, under a key by which `with_part` changes it."""
    for name in RATES:
        if (value := getattr(model, name)) is not None and len(value):
            yield (name,), value
    for m in model.measurements:
        for name in ("z", "h", "H"):
            if getattr(m, name) is not None:
                yield (m.name, name), getattr(m, name)
    for function in model.functions:
        for output in function.outputs:
            yield (function.name, output.name), output.value


def with_part(model, key, value):
    if len(key) == 1:
        return dataclasses.replace(model, **{key[0]: value})
    owner, name = key
    measurements = tuple(dataclasses.replace(m, **{name: value}) if m.name == owner else m for m in model.measurements)
    functions = tuple(
        dataclasses.replace(f, outputs=tuple(
            dataclasses.replace(o, value=value) if o.name == name else o for o in f.outputs
        )) if f.name == owner else f
        for f in model.functions
    )  # fmt: skip
    return dataclasses.replace(model, measurements=measurements, functions=functions)


def stale_input(model, seed):
    """In one part an input, or a block of states, is read in the place of another of its size and unit."""
    rng = random.Random(seed)
    pairs = []
    known = (*model.inputs, *model.states)
    for key, value in parts(model):
        free = value.free_symbols
        for one in known:
            if free & set(one.symbols):
                pairs += [
                    (key, value, one, other)
                    for other in known
                    if other is not one and other.size == one.size and other.unit == one.unit
                ]
    key, value, one, other = rng.choice(pairs)
    say(key, f"{other.name} in the place of {one.name}")
    return with_part(model, key, Matrix(substituted(value, dict(zip(one.symbols, other.symbols, strict=True)))))


def H_row(model, seed):
    """An H that is given, or that follows, with one row changed; of a total state a row of h."""
    rng = random.Random(seed)
    error = model.kind == "error-state"
    m = rng.choice(
        [m for m in (completed(model) if error else model).measurements if m.H is not None or m.h is not None]
    )
    name = "H" if m.H is not None else "h"
    H = Matrix(getattr(m, name))
    row = rng.randrange(H.rows)
    entries = [j for j in range(H.cols) if H[row, j] != 0]
    column, other = rng.choice(entries), rng.randrange(H.cols)
    what = rng.choice(("minus", "rows", "zero", "columns", "sign"))
    if what == "minus":
        H[row, :] = -H[row, :]
    elif what == "rows":
        H = H.permute(
            [(row + 1) % H.rows if i == row else row if i == (row + 1) % H.rows else i for i in range(H.rows)]
        )
    elif what == "zero":
        H[row, column] = 0
    elif what == "columns":
        H[row, column], H[row, other] = H[row, other], H[row, column]
    else:
        H[row, column] = -H[row, column]
    say((m.name, name), f"{what} of row {row}, columns {column} and {other}")
    old = next(one for one in model.measurements if one.name == m.name)
    if getattr(old, name) is not None:
        return with_part(model, (m.name, name), H)
    given = dataclasses.replace(old, H=H, h=None, at_zero=False)
    return dataclasses.replace(model, measurements=tuple(given if one is old else one for one in model.measurements))


def undefined_point(model, seed):
    """One entry of one part has no value at a point, or in a half, of the boxes."""
    rng = random.Random(seed)
    key, value = rng.choice([(key, value) for key, value in parts(model) if value.free_symbols])
    value = Matrix(value)
    i = rng.choice([i for i in range(len(value)) if value[i].free_symbols])
    free = value[i].free_symbols
    read = [(s, v, k) for v in (*model.inputs, *model.states) for k, s in enumerate(v.symbols) if s in free]
    symbol, variable, k = rng.choice(read)
    low, high = variable.low[k], variable.high[k]
    unit = variable.unit.split(", ")[k if "," in variable.unit else 0]
    place = low + (high - low) * 0.375
    if rng.random() < 0.5:
        place = 0.0 if low < 0 < high else (low + high) / 2
    at = constant("least", repr(place), unit, "where it has no value") if place else 0
    width = constant("width", "1", unit, "of one unit")
    off = (symbol - at) / width
    what = rng.choice(("quotient", "logarithm", "root"))
    say(key, f"entry {i} has a {what} at {symbol} = {place}")
    if what == "quotient":
        value[i] = value[i] * (off**2 + off) / off / (off + 1)
    elif what == "logarithm":
        value[i] = value[i] * (1 + log(off**2) - 2 * log(Abs(off)))
    else:
        value[i] = value[i] * sqrt(off) ** 3 / sqrt(off**3)
    return with_part(model, key, value)


def noise(model, seed):
    """A density that is another one's, doubled or missing, one that drives another input or state, or a column of G."""
    rng = random.Random(seed)
    n = Matrix(model.noise)
    choices = ["double", "neighbour", "missing"]
    driven = model.mechanics.driven if model.mechanics is not None else ()
    alike = [
        (a, b) for a in range(len(driven)) for b in range(a)
        if driven[a][1].size == driven[b][1].size
    ]  # fmt: skip
    choices += ["driven"] * bool(alike) * (len(model.G) == 0) + ["column", "entry"] * (len(model.G) > 0)
    what = rng.choice(choices)
    i = rng.randrange(len(n))
    if what in ("double", "neighbour", "missing"):
        say(("noise", what), n[i])
        n[i] = {"double": 2 * n[i], "neighbour": n[(i + 1) % len(n)], "missing": 0 * n[i]}[what]
        return dataclasses.replace(model, noise=n)
    if what == "driven":
        a, b = rng.choice(alike)
        pairs = list(driven)
        say(("driven",), f"{pairs[a][1].name} and {pairs[b][1].name} exchanged")
        pairs[a], pairs[b] = (pairs[a][0], pairs[b][1]), (pairs[b][0], pairs[a][1])
        return dataclasses.replace(model, mechanics=dataclasses.replace(model.mechanics, driven=tuple(pairs)))
    G = Matrix(model.G)
    say(("G", what), i)
    if what == "column":
        G.col_swap(i, (i + 1) % G.cols)
    else:
        r, c = rng.choice([(r, c) for r in range(G.rows) for c in range(G.cols) if G[r, c] != 0])
        G[r, c] = rng.choice((0, 2 * G[r, c], -G[r, c]))
    return dataclasses.replace(model, G=G)


# ---------------------------------------------------------------- what a model says


def words(part, seen):
    """All that a part of a model says, line by line, its names with what they stand for."""
    if isinstance(part, MatrixBase):
        for entry in part:
            yield str(entry)
            for name in sorted(entry.atoms(Named), key=lambda one: one.name):
                if id(name.quantity) not in seen:
                    seen.add(id(name.quantity))
                    yield from words(name.quantity.value, seen)
    elif dataclasses.is_dataclass(part):
        for field in dataclasses.fields(part):
            if field.name not in ("where", "meaning", "title", "card"):
                yield field.name
                yield from words(getattr(part, field.name), seen)
    elif isinstance(part, tuple):
        for item in part:
            yield from words(item, seen)
    else:
        yield str(part)


def loaded(target):
    path, _, name = target.partition(":")
    if not name:
        return models.built_in(target)
    spec = importlib.util.spec_from_file_location("faulty", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return getattr(module, name)


if __name__ == "__main__":
    try:
        print(hashlib.sha256("\n".join(words(loaded(sys.argv[1]), set())).encode()).hexdigest())
    except BoresightError:
        print("refused")
