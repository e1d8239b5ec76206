"""The whole filter as its templates see it, from a model and its units; and what its self-test flies."""

import itertools
import math
from types import SimpleNamespace
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.codegen.functions.dynamics import LARGEST
from boresight.codegen.functions.samples import generator, sample
from boresight.codegen.functions.tape import evaluate
from boresight.codegen.functions.unit import Unit, state_variable
from boresight.codegen.text.covariance import arranged, nonzeros
from boresight.codegen.text.names import beyond, norms_beyond, norms_near, number, rows_of, shared_tables
from boresight.codegen.text.places import Places, table
from boresight.codegen.text.views import pages
from boresight.derive.model import Measurement, Model, Variable

ENDS = ("low", "high")
PLACES = {"place": "given_", "held": "flown."}  # of a carried field in the self-test: as given, and in the filter
FLOWN = 2  # points at which the self-test flies the filter
LEAST_R, MOST_R = 1e-30, 1e30  # variances of measurements, within the range of a float
BEYOND_BOX = 3  # powers of ten by which a sigma may exceed its state's box, rounded up to a power of ten
WIDEST = 12  # and the most that a sigma may have: its variance times the square of Phi must stay within a float


def has_filter(model: Model) -> bool:
    """Whether there is something to predict and something to update by."""
    return model.n > 0 and bool(model.measurements)


def ceilings(model: Model) -> list[float]:
    """The largest variance that each state may have, in the square of its unit."""
    ends = [max(abs(lo), abs(hi)) for v in model.states for lo, hi in zip(v.low, v.high, strict=True)]
    return [10.0 ** (2 * min(WIDEST, math.ceil(math.log10(end or 1.0)) + BEYOND_BOX)) for end in ends]


class Checks:
    """The static functions that hold a struct, or a vector, against its box: each once, however many calls need it.

    A call of one is its `function` and what it is given: a `struct`, or of a vector its name in the C.
    """

    def __init__(self) -> None:
        self.made: dict[tuple[Any, ...], dict[str, Any]] = {}

    def carried(self, struct: str, fields: list[Variable]) -> None:
        self._add(("carried", struct), f"check_{struct}", struct, [box(a) for a in fields])

    def given(self, struct: str, fields: list[Variable], caller: str) -> dict[str, Any]:
        """The call that checks these fields of a struct that a function is given."""
        name = f"check_{struct}_of_{caller}"
        return self._add((struct, *(a.name for a in fields)), name, struct, [box(a) for a in fields])

    def vector(self, v: Any) -> dict[str, Any]:
        """The call that checks x, or a result that has a box of its own."""
        low, high = tuple(map(number, v.low)), tuple(map(number, v.high))
        one = {"name": v.name, "size": len(low), "norm": None, "of": v}
        return self._add(("vector", low, high), f"check_{v.name}", None, [one])

    def tables(self, total: bool) -> list[str]:
        """The tables of all functions: those that two of them read once, in front, and each other in its function."""
        readers: dict[tuple[str, ...], dict[str, str]] = {}
        for check in self.made.values():
            for name, values in check["bounds"].items():
                readers.setdefault(tuple(map(number, values)), {})[check["function"]] = name
        # `set_x` reads that of x too
        shared = {v for v, by in readers.items() if len(by) > 1 or (total and "check_x" in by)}
        front: dict[str, tuple[float, ...]] = {}
        for check in self.made.values():
            own: dict[str, tuple[float, ...]] = {}
            for name, values in check["bounds"].items():
                (front if tuple(map(number, values)) in shared else own)[name] = values
            check["tables"], check["table"] = shared_tables(own)
        lines, names = shared_tables(front)
        for check in self.made.values():
            table = check["table"] | {name: names[name] for name in check["bounds"] if name in names}
            for a in check["fields"]:
                a["each"] = "" if f"{a['name']}_low" in table else "_each"
                a["ends"] = [table.get(f"{a['name']}_{end}") or number(getattr(a["of"], end)[0]) for end in ENDS]
        return lines

    def _add(self, key: tuple[Any, ...], name: str, struct: str | None, fields: list[dict[str, Any]]) -> dict[str, Any]:
        if key not in self.made:
            unlike = [a for a in fields if len({*zip(a["of"].low, a["of"].high, strict=True)}) > 1]
            bounds = {f"{a['name']}_{end}": getattr(a["of"], end) for a in unlike for end in ENDS}
            self.made[key] = {
                "function": name, "struct": struct, "fields": fields, "carried": key[0] == "carried", "bounds": bounds,
            }  # fmt: skip
        return self.made[key]


class Wiring:
    """How the filter of a model calls its units: which structs it carries, which inputs they read, what is judged."""

    def __init__(self, model: Model, made: list[Unit], views: list[dict[str, Any]]):
        self.model, self.made = model, made
        self.units = {unit.name: (unit, view) for unit, view in zip(made, views, strict=True)}
        self.owner = {field.name: struct.name for struct in model.structs for field in struct.fields}
        moving = [self.units[name][0] for name in ("feedback", "strapdown") if self.writes_fields(name)]
        written = {self.owner[r.name] for unit in moving for r in unit.results}
        self.carried = [s.name for s in model.structs if s.name in written]
        self.checks, self.files = Checks(), dict[str, None]()

    def writes_fields(self, name: str) -> bool:
        """Whether the model has this function and everything it gives is an input field of the model."""
        return name in self.units and all(r.name in self.owner for r in self.units[name][0].results)

    def structs(self, *names: str) -> list[str]:
        """Those that these units read and the filter does not carry."""
        read = {struct for name in names for struct in self.units[name][1]["reads"]}
        return [s.name for s in self.model.structs if s.name in read and s.name not in self.carried]

    def fields(self, *names: str) -> list[str]:
        """The inputs that these units read."""
        read = {a.name for name in names for a in self.units[name][0].args}
        return [a.name for a in self.model.inputs if a.name in read]

    def reads_x(self, name: str) -> bool:
        return any(a.name == "x" for a in self.units[name][0].args)

    def dense(self, name: str) -> dict[str, Any]:
        """A unit with its own checks, zeros too, as the self-test calls it."""
        view = self.units[name][1]
        return {"c_name": view["c_name"], "reads": view["reads"]}

    def called(self, name: str, zeros: bool = True) -> dict[str, Any]:
        """A unit as the filter calls it: by its kernel, unless zeros are wanted that a kernel does not write."""
        unit, view = self.units[name]
        kernel = not (zeros and any(len(r.nonzeros) < r.shape[0] * r.shape[1] for r in unit.results))
        if kernel:
            self.files[view["file"]] = None
        judged = [kernel and shown["checked"] for shown in view["results"]]
        return self.dense(name) | {
            "kernel": kernel,
            "inputs": [{"name": a.name, "size": a.size, "struct": self.owner.get(a.name)} for a in unit.args],
            "results": [
                {"count": len(r.nonzeros), "checked": own, "box": self.checks.vector(r) if own and r.low else None}
                for r, own in zip(unit.results, judged, strict=True)
            ],
        }

    def checked(self, caller: str, structs: list[str], fields: list[str], x: bool = False) -> list[dict[str, Any]]:
        """The calls that check what a function of the filter is given."""
        found = [self.checks.vector(state_variable(self.model))] if x else []
        for s in self.model.structs:
            read = [a for a in s.fields if a.name in fields]
            if s.name in structs and read:
                found.append(self.checks.given(s.name, read, caller))
        return found

    def step(self) -> dict[str, Any]:
        """dt: the input that has it, and which of its components it is."""
        dt = next(v for v in self.model.inputs if self.model.dt in v.symbols)
        place = dt.symbols.index(self.model.dt)
        return box(dt, place) | {"struct": self.owner[dt.name], "place": place if dt.size > 1 else None}


def changing(wiring: Wiring, name: str, caller: str) -> dict[str, Any] | None:
    """A function whose outputs are fields: it writes into copies of the structs that it changes."""
    if not wiring.writes_fields(name):
        return None
    unit, _ = wiring.units[name]
    out = [{"name": r.name, "struct": wiring.owner[r.name], "size": len(r.nonzeros)} for r in unit.results]
    structs, fields, reads_x = wiring.structs(name), wiring.fields(name), wiring.reads_x(name)
    return {
        "meaning": unit.meaning, "structs": structs, "fields": fields, "reads_x": reads_x, "out": out,
        "changed": [s.name for s in wiring.model.structs if s.name in {o["struct"] for o in out}],
        "written": [o["name"] for o in out],
        "unit": wiring.called(name), "checks": wiring.checked(caller, structs, fields, reads_x),
    }  # fmt: skip


def measuring(wiring: Wiring, m: Measurement) -> dict[str, Any]:
    """The function of one measurement.  Raises BoresightError where it has more rows than a mask has bits."""
    if len(m.rows) > 32:
        raise BoresightError(f"measurement {m.name} has {len(m.rows)} rows; a filter in C takes 32 at most")
    (H,), explicit = wiring.units[f"{m.name}_H"][0].results, m.H is None
    nonlinear = wiring.reads_x(f"{m.name}_H")
    used = [f"{m.name}_H"] + [f"{m.name}_z"] * (m.z is not None) + [f"{m.name}_h"] * explicit
    structs, fields = wiring.structs(*used), wiring.fields(*used)
    places = tuple((i, j) for i in range(len(m.rows)) for j in range(wiring.model.n))  # L^-1 H has zeros nowhere
    if nonlinear or wiring.model.kind == "total-state":
        wiring.checks.vector(state_variable(wiring.model))
    brought = SimpleNamespace(name=f"z_of_{m.name}", low=m.low, high=m.high)
    return {
        "box_of_z": wiring.checks.vector(brought) if m.low else None,
        "checks": wiring.checked(f"measure_{m.name}", structs, fields),
        "z": wiring.called(f"{m.name}_z") if m.z is not None else None,
        "h": wiring.called(f"{m.name}_h") if explicit else None,
        "H": wiring.called(f"{m.name}_H", zeros=m.correlated),
        "name": m.name, "meaning": m.meaning, "names": ", ".join(m.rows), "unit": m.unit, "m": len(m.rows),
        "equations": m.equations, "pages": pages(wiring.model, f"{wiring.model.c_prefix}_filter", m.equations),
        "nonlinear": nonlinear, "structs": structs, "fields": fields,
        "all": 2 ** len(m.rows) - 1, "angles": sum(1 << i for i in m.angles), "correlated": m.correlated,
        "size_R": len(m.rows) ** (2 if m.correlated else 1),
        # where z - h(x) goes, or a z of the caller's that is changed
        "target": explicit or (m.z is None and bool(m.angles or m.correlated)),
        "z_low": ", ".join(map(number, m.low)), "z_high": ", ".join(map(number, m.high)),
        "z_ends": ", ".join(f"{low:.6g} to {high:.6g}" for low, high in zip(m.low, m.high, strict=True)),
        **table(places if m.correlated else H.nonzeros, len(m.rows)),
    }  # fmt: skip


def predicting(wiring: Wiring) -> dict[str, Any]:
    """How an error state and its covariance are carried over dt."""
    dt, structs = wiring.step(), wiring.structs("F", "Qc")
    if dt["struct"] not in (*wiring.carried, *structs):
        structs = [s.name for s in wiring.model.structs if s.name in (*structs, dt["struct"])]
    read = [*wiring.fields("F", "Qc"), dt["name"]]
    return {
        "structs": structs, "fields": read,
        "F": wiring.called("F", zeros=False), "Qc": wiring.called("Qc", zeros=False),
        "checks": wiring.checked("propagate", structs, read),
    }  # fmt: skip


def stepping(wiring: Wiring) -> dict[str, Any]:
    """The same by next, Phi and Q, of a total state or in discrete time; or by loops over f, F and Qc."""
    model, made = wiring.model, wiring.made
    read = ("next", "Phi", "Q", *(("f", "F", "Qc") if model.loops else ()))
    structs, fields = wiring.structs(*read), wiring.fields(*read)
    checks = wiring.checked("propagate", structs, fields, x=model.kind == "total-state")
    return {
        "structs": structs, "fields": fields, "checks": checks, **arranged(model, made),
        **scattered(nonzeros(made, "Q")),
        **{
            name: wiring.dense(name) if model.loops else wiring.called(name, zeros=name == "next")
            for name in ("next", "Phi", "Q")
        },
    }  # fmt: skip


def looping(wiring: Wiring) -> dict[str, Any]:
    """What a step by loops is made of: its kernels and their places, and what is checked after it."""
    made = wiring.made
    return {
        "check": wiring.checks.vector(wiring.units["next"][0].results[0]), "most": number(LARGEST),
        "moved": ", ".join(str(i) for i, _ in nonzeros(made, "f")), "count": len(nonzeros(made, "f")),
        "units": {name: wiring.called(name, zeros=False) for name in ("F", "Qc", "f")},
        **{name: table(nonzeros(made, name), wiring.model.n) for name in ("F", "Qc")},
    }  # fmt: skip


def filter_view(model: Model, made: list[Unit], views: list[dict[str, Any]]) -> dict[str, Any]:
    """The functions of the filter: which structs it carries, which it is given, and which units it calls."""
    wiring, total = Wiring(model, made, views), model.kind == "total-state"
    for s in model.structs:
        if s.name in wiring.carried:
            wiring.checks.carried(s.name, list(s.fields))
    measurements = [measuring(wiring, m) for m in model.measurements]
    stepped = model.F is None
    propagate = stepping(wiring) if stepped else predicting(wiring)
    correct, strapdown = changing(wiring, "feedback", "correct"), changing(wiring, "strapdown", "strapdown")
    loops = looping(wiring) if model.loops else None
    tables, checks = wiring.checks.tables(total), list(wiring.checks.made.values())
    return {
        "total": total,
        "stepped": stepped,
        "loops": loops,
        "files": list(wiring.files),
        "tables": tables,
        "checks": checks,
        "box_of_x": next((c["fields"][0] for c in checks if c["function"] == "check_x"), None),
        "ceiling": ", ".join(map(number, ceilings(model))),
        "ceilings": [
            (v.name, v.unit, ", ".join(f"{math.sqrt(c):.0e}" for c in part))
            for v, part in zip(model.states, split(ceilings(model), [v.size for v in model.states]), strict=True)
        ],
        "blocks": [v.size for v in model.states],
        "squares": sum(v.size**2 for v in model.states),
        "snapshot": {
            "numbers": sum(a.size for s in model.structs if s.name in wiring.carried for a in s.fields)
            + model.n * (model.n + 3) // 2,
            # counts of two bytes, which states are considered, and the checksum
            "bytes": 2 * (len(measurements) + 1) + model.n + 4,
        },
        "wraps": [i for i, wraps in enumerate(v.wraps for v in model.states for _ in v.symbols) if wraps],
        "explicit": any(u["h"] for u in measurements),
        "angled": any(u["h"] and u["angles"] for u in measurements),
        "turned": any(not u["h"] and u["angles"] for u in measurements),
        "iterated": any(u["nonlinear"] for u in measurements),
        "correlated": any(u["correlated"] for u in measurements),
        "keeps_R": any(u["nonlinear"] or u["correlated"] for u in measurements),
        "separated": any(u["nonlinear"] and u["correlated"] for u in measurements),
        "carried": wiring.carried,
        "max_rows": max(len(m.rows) for m in model.measurements),
        "most_noise": max(u["size_R"] for u in measurements),
        "least_R": repr(LEAST_R),
        "most_R": repr(MOST_R),
        "dt": None if stepped and not loops else wiring.step(),
        "propagate": propagate,
        "measurements": measurements,
        "correct": correct,
        "strapdown": strapdown,
    }  # fmt: skip


def split(values: list[float], sizes: list[int]) -> list[list[float]]:
    """The values in pieces of these sizes."""
    ends = list(itertools.accumulate(sizes))
    return [values[end - size : end] for end, size in zip(ends, sizes, strict=True)]


def scattered(places: Places) -> dict[str, Any]:
    """Which non-zeros of a symmetric matrix, row after row, stand in its packed upper triangle, and where."""
    kept = [(k, j * (j + 1) // 2 + i) for k, (i, j) in enumerate(sorted(places)) if i <= j]
    return {"count": len(kept), "from": ", ".join(str(k) for k, _ in kept), "to": ", ".join(str(at) for _, at in kept)}


def test_view(model: Model, made: list[Unit], f: dict[str, Any]) -> dict[str, Any]:
    """Points at which every unit answers, and which function of the filter reads what, for its self-test."""
    points = answered_by_all(model, made)
    structs, spoilt, start = [], [], 0
    for s in model.structs:
        fields, offset = [], 0
        for a in s.fields:
            fields.append({"name": a.name, "size": a.size, "offset": offset})
            offset += a.size
            item = f"{a.name}[i]" if a.size > 1 else a.name
            held = f"flown.{s.name}" if s.name in f["carried"] else f"given_{s.name}"
            own = s.name in f["carried"]
            readers = [(name, f"&given_{s.name}.{item}") for name in ("init", "set_nav")] if own else []
            functions = {"propagate": f["propagate"], "strapdown": f["strapdown"], "correct": f["correct"]}
            functions |= {f"measure_{u['name']}": u for u in f["measurements"]}
            reading = [name for name, u in functions.items() if u and (own or a.name in u["fields"])]
            readers += [(name, f"&{held}.{item}") for name in reading]
            spoilt.append(
                {
                    "name": a.name, "size": a.size, "functions": readers, "low": beyond(a)[0], "high": beyond(a)[1],
                    "ends": [", ".join(map(number, end)) for end in (a.low, a.high)],
                    "norm": "" if own else norms_near(a), "vector": f"given_{s.name}.{a.name}",
                }
            )  # fmt: skip
        rows = np.hstack(points[start : start + len(s.fields)])
        start += len(s.fields)
        structs.append({"name": s.name, "size": offset, "fields": fields, "rows": rows_of(rows)})
    start_x = inside(model)
    x = state_variable(model)
    box_size = [hi - lo for block in model.states for lo, hi in zip(block.low, block.high, strict=True)]

    def places(name: str) -> str:
        return ", ".join(str(row * model.n + column) for row, column in nonzeros(made, name))

    return {
        "count": FLOWN,
        "structs": structs,
        "spoilt": [g for g in spoilt if g["functions"]],
        "checked": [
            box(a)
            | {part: f"{of}{s.name}.{a.name}{'[i]' * (a.size > 1)}" for part, of in PLACES.items()}
            | {"norms": [f"{number(-v)}, {number(v)}" for v in a.norm or ()], "norms_beyond": norms_beyond(a)}
            | {"norms_near": norms_near(a), "struct": s.name}
            for s in model.structs
            if s.name in f["carried"]
            for a in s.fields
        ],
        "sigma": ", ".join(repr(size * 1e-4) for size in box_size),
        "start": ", ".join(map(repr, start_x)),
        "x_beyond": beyond(x),
        "x_low_numbers": ", ".join(map(repr, map(float, x.low))),
        "x_high_numbers": ", ".join(map(repr, map(float, x.high))),
        "places": {name: places(name) for name in (() if f["stepped"] else ("F", "Qc"))},
    }


def inside(model: Model) -> list[float]:
    """A state of zero, or where that lies outside its box or near an end of it, the middle."""
    bounds = [pair for block in model.states for pair in zip(block.low, block.high, strict=True)]
    return [0.0 if 7 * lo + hi <= 0.0 <= lo + 7 * hi else (lo + hi) / 2 for lo, hi in bounds]


def answered_by_all(model: Model, made: list[Unit]) -> list[np.ndarray]:
    """FLOWN points of all inputs, (FLOWN, size) each, at which every unit answers for x as `inside` has it."""
    points = answered(model, made)
    if len(points[0]) < FLOWN:
        few = f"{len(points[0])} of {128 * FLOWN} points of its boxes"
        raise BoresightError(f"{model.name}: {few} have an answer everywhere; narrow them")
    return [part[:FLOWN] for part in points]


def answered(model: Model, made: list[Unit]) -> list[np.ndarray]:
    """Those of 128 FLOWN drawn points of all inputs, (points, size) each, at which every unit answers."""
    half, rng = 64 * FLOWN, generator("filter", model.name)
    anywhere, small = (sample(model.inputs, 0, half, rng, small=small) for small in (False, True))
    drawn, count = [np.vstack(both) for both in zip(anywhere, small, strict=True)], 2 * half
    values = {v.name: part for v, part in zip(model.inputs, drawn, strict=True)} | {
        "x": np.tile(inside(model), (count, 1))
    }
    keep = np.ones(count, dtype=bool)
    boxes = {v.name: v for v in model.inputs}
    for unit in made:
        results, bounds = evaluate(unit.tape, [values[a.name] for a in unit.args])
        for (output, nz, _), value, bound in zip(unit.tape.results, results, bounds, strict=True):
            result = unit.results[output]
            keep &= np.isfinite(bound)
            if result.low:
                keep &= (value >= result.low[nz]) & (value <= result.high[nz])
            if unit.name == "strapdown" and result.name in boxes:  # what is carried on must lie in its box again
                place = result.nonzeros[nz][0]
                keep &= (value >= boxes[result.name].low[place]) & (value <= boxes[result.name].high[place])
    return [part[keep] for part in drawn]


def box(v: Any, place: int | None = None) -> dict[str, Any]:
    """A field with its bounds as C; one component of it if `place` is given."""
    chosen = slice(None) if place is None else slice(place, place + 1)
    return {
        "name": v.name, "size": v.size if place is None else 1, "low": ", ".join(map(number, v.low[chosen])),
        "high": ", ".join(map(number, v.high[chosen])),
        "norm": tuple(number(b * b) for b in v.norm) if v.norm else None,
        # what a vector is scaled to that is none of the norms
        "length": number(1.0 if v.norm[0] <= 1 <= v.norm[1] else sum(v.norm) / 2) if v.norm else None, "of": v,
    }  # fmt: skip
