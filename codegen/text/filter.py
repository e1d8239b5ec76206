"""The whole filter as its templates see it, from a model and its units; and what its self-test flies."""

import itertools
import math
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.codegen.functions.dynamics import LARGEST
from boresight.codegen.functions.samples import generator, sample
from boresight.codegen.functions.tape import evaluate
from boresight.codegen.functions.unit import Unit, state_variable
from boresight.codegen.text.covariance import Places, arranged, nonzeros, table
from boresight.codegen.text.names import beyond, norms_beyond, number, rows_of, shared_tables
from boresight.derive.model import Model, Variable

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
    """The static functions that hold a struct, or a vector, against its box: each once, however many calls need it."""

    def __init__(self, prefix: str):
        self.prefix = prefix
        self.made: dict[tuple[Any, ...], dict[str, Any]] = {}

    def carried(self, struct: str, fields: list[Variable]) -> None:
        parameter = f"{self.prefix}_{struct} *{struct}, int clamp"
        self._add(("carried", struct), f"check_{struct}", parameter, [box(f"{struct}->{a.name}", a) for a in fields])

    def given(self, struct: str, fields: list[Variable], caller: str) -> str:
        """The call that checks these fields of a struct that a function is given."""
        parameter = f"const {self.prefix}_{struct} *{struct}"
        name = f"check_{struct}_of_{caller}"
        read = [box(f"{struct}->{a.name}", a) for a in fields]
        return f"{self._add((struct, *(a.name for a in fields)), name, parameter, read)}({struct})"

    def vector(self, v: Any, access: str) -> str:
        """The call that checks x, or a result that has a box of its own."""
        low, high = tuple(map(number, v.low)), tuple(map(number, v.high))
        one = {"name": v.name, "size": len(low), "access": v.name, "norm": None, "of": v}
        return f"{self._add(('vector', low, high), f'check_{v.name}', f'const bs_real *{v.name}', [one])}({access})"

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

    def box_of(self, function: str) -> dict[str, Any] | None:
        """The box of the vector that a function checks, if there is such a function."""
        return next((check["fields"][0] for check in self.made.values() if check["function"] == function), None)

    def _add(self, key: tuple[Any, ...], name: str, parameter: str, fields: list[dict[str, Any]]) -> str:
        if key not in self.made:
            unlike = [a for a in fields if len({*zip(a["of"].low, a["of"].high, strict=True)}) > 1]
            bounds = {f"{a['name']}_{end}": getattr(a["of"], end) for a in unlike for end in ENDS}
            self.made[key] = {
                "function": name, "parameter": parameter, "fields": fields, "carried": key[0] == "carried",
                "bounds": bounds,
            }  # fmt: skip
        return str(self.made[key]["function"])


def filter_view(model: Model, made: list[Unit], views: list[dict[str, Any]]) -> dict[str, Any]:
    """The functions of the filter: which structs it carries, which it is given, and how it calls the units."""
    checks, files = Checks(model.c_prefix), dict[str, None]()
    by_name = {unit.name: (unit, view) for unit, view in zip(made, views, strict=True)}
    owner = {field.name: struct.name for struct in model.structs for field in struct.fields}
    moving = [by_name[name][0] for name in ("feedback", "strapdown") if writes_fields(by_name, name, owner)]
    written = {owner[r.name] for unit in moving for r in unit.results}
    carried = [s.name for s in model.structs if s.name in written]
    for s in model.structs:
        if s.name in carried:
            checks.carried(s.name, list(s.fields))
    if model.kind == "total-state":
        checks.vector(state_variable(model), "x")

    def given(*names: str) -> list[str]:
        read = {struct for name in names for struct in by_name[name][1]["reads"]}
        return [s.name for s in model.structs if s.name in read and s.name not in carried]

    def fields(*names: str) -> list[str]:
        """The inputs that these units read."""
        read = {a.name for name in names for a in by_name[name][0].args}
        return [a.name for a in model.inputs if a.name in read]

    def reach(struct: str) -> str:
        return "filter->x" if struct == "x" else f"&filter->{struct}" if struct in carried else struct

    def call(name: str, out: str = "dense") -> str:
        """The call of a unit with its checks, zeros too: what the self-test holds the filter against."""
        view = by_name[name][1]
        return f"{view['c_name']}({', '.join([*(reach(struct) for struct in view['reads']), out])})"

    def path(field: Variable) -> str:
        struct = owner[field.name]
        return f"filter->{struct}.{field.name}" if struct in carried else f"{struct}->{field.name}"

    def kernel(name: str, out: list[str], state: str = "filter->x") -> str:
        """The call of a unit's kernel, whose inputs have been checked."""
        unit, view = by_name[name]
        files[view["file"]] = None
        inputs = [state if a.name == "x" else f"{'&' * (a.size == 1)}{path(a)}" for a in unit.args]
        return f"{view['c_name']}_kernel({', '.join([*inputs, *out])})"

    def run(name: str, out: list[str], dense: bool = True) -> list[str]:
        """Lines that call a unit's kernel and judge its answers; dense: whether zeros are wanted too."""
        unit, view = by_name[name]
        if dense and any(len(r.nonzeros) < r.shape[0] * r.shape[1] for r in unit.results):
            arguments = [reach(struct) for struct in view["reads"]] + out
            return [f"status = {view['c_name']}({', '.join(arguments)});"]
        lines = [f"{kernel(name, out)};"]
        for r, shown, at in zip(unit.results, view["results"], out, strict=True):
            if shown["checked"]:
                call = checks.vector(r, at) if r.low else f"bs_check_finite({at}, {len(r.nonzeros)})"
                lines.append(
                    f"status = {call};" if len(lines) == 1 else f"status = (status == BS_OK) ? {call} : status;"
                )
        return lines

    def checked(caller: str, structs: list[str], fields: list[str], x: bool = False) -> list[str]:
        """The calls that check what a function of the filter is given."""
        found = [checks.vector(state_variable(model), "filter->x")] if x else []
        for s in model.structs:
            read = [a for a in s.fields if a.name in fields]
            if s.name in structs and read:
                found.append(checks.given(s.name, read, caller))
        return found

    def change(name: str) -> dict[str, Any] | None:
        """A function whose outputs are fields: it writes into copies of the structs that it changes."""
        if not writes_fields(by_name, name, owner):
            return None
        unit, view = by_name[name]
        caller = "correct" if name == "feedback" else name
        out = [f"{'&' if len(r.nonzeros) == 1 else ''}next_{owner[r.name]}.{r.name}" for r in unit.results]
        structs = [s.name for s in model.structs if s.name in {owner[r.name] for r in unit.results}]
        arguments = ", ".join([*(reach(struct) for struct in view["reads"]), *out])
        return {
            "meaning": unit.meaning, "structs": given(name), "changed": structs, "fields": fields(name),
            "written": [r.name for r in unit.results],
            "call": f"{view['c_name']}({arguments})", "run": run(name, out),
            "checks": checked(caller, given(name), fields(name), any(a.name == "x" for a in unit.args)),
            "reads_x": any(a.name == "x" for a in unit.args),
        }  # fmt: skip

    measurements = []
    for m in model.measurements:
        if len(m.rows) > 32:
            raise BoresightError(f"measurement {m.name} has {len(m.rows)} rows; a filter in C takes 32 at most")
        H = by_name[f"{m.name}_H"][0]
        nonlinear, explicit = any(a.name == "x" for a in H.args), m.H is None
        used = [f"{m.name}_H"] + [f"{m.name}_z"] * (m.z is not None) + [f"{m.name}_h"] * explicit
        places = tuple((i, j) for i in range(len(m.rows)) for j in range(model.n))  # L^-1 H has zeros nowhere
        if nonlinear:
            checks.vector(state_variable(model), "x")
        measurements.append(
            {
                "checks": checked(f"measure_{m.name}", given(*used), fields(*used)),
                "run_z": run(f"{m.name}_z", ["z"]) if m.z is not None else None,
                "run_h": run(f"{m.name}_h", ["target"]) if explicit else None,
                "run_H": run(f"{m.name}_H", ["filter->work"], dense=m.correlated),
                "name": m.name, "meaning": m.meaning, "names": ", ".join(m.rows), "unit": m.unit, "m": len(m.rows),
                "equations": m.equations, "nonlinear": nonlinear, "structs": given(*used), "fields": fields(*used),
                "z": call(f"{m.name}_z", "z") if m.z is not None else None,
                "h": call(f"{m.name}_h", "target") if explicit else None,
                "H_dense": call(f"{m.name}_H"), "all": 2 ** len(m.rows) - 1,
                "angles": f"{sum(1 << i for i in m.angles)}U", "correlated": m.correlated,
                "size_R": len(m.rows) ** (2 if m.correlated else 1),
                # where z - h(x) goes, or a z of the caller's that is changed
                "target": explicit or (m.z is None and bool(m.angles or m.correlated)),
                **table(places if m.correlated else H.results[0].nonzeros, len(m.rows)),
            }
        )  # fmt: skip

    def length() -> tuple[Variable, int, str]:
        """dt: the input, the component and how C reaches it."""
        dt = next(v for v in model.inputs if model.dt in v.symbols)
        place = dt.symbols.index(model.dt)
        return dt, place, path(dt) if dt.size == 1 else f"{path(dt)}[{place}]"

    def linear() -> tuple[dict[str, Any], dict[str, Any]]:
        """How an error state and its covariance are carried over dt, and dt as C."""
        dt, place, value = length()
        structs = given("F", "Qc")
        if owner[dt.name] not in (*carried, *structs):
            structs = [s.name for s in model.structs if s.name in (*structs, owner[dt.name])]
        read = [*fields("F", "Qc"), dt.name]
        return {
            "structs": structs, "F_dense": call("F"), "Qc_dense": call("Qc"), "fields": read,
            "run_F": run("F", ["filter->F"], dense=False), "run_Qc": run("Qc", ["filter->Qc"], dense=False),
            "checks": checked("propagate", structs, read),
        }, box(value, dt, place) | {"value": value}  # fmt: skip

    def total() -> dict[str, Any]:
        """The same of a total state."""
        read = ("next", "Phi", "Q", *(("f", "F", "Qc") if model.loops else ()))
        printed = not model.loops
        return {
            "structs": given(*read), "fields": fields(*read), "next": call("next", "next"),
            "Phi_dense": call("Phi"), **arranged(model, made), "Q_dense": call("Q"), **scattered(nonzeros(made, "Q")),
            "checks": checked("propagate", given(*read), fields(*read), x=True),
            "run_next": run("next", ["next"]) if printed else None,
            "run_Phi": run("Phi", ["filter->work"], dense=False) if printed else None,
            "run_Q": run("Q", ["filter->work"], dense=False) if printed else None,
        }  # fmt: skip

    def looped() -> dict[str, Any]:
        """What a step by loops is made of: its kernels and their places, and what is checked after it."""
        return {
            "kernel": lambda name, state, out: kernel(name, [out], state), "dt": length()[2],
            "check": checks.vector(by_name["next"][0].results[0], "next"), "most": number(LARGEST),
            "moved": ", ".join(str(i) for i, _ in nonzeros(made, "f")), "count": len(nonzeros(made, "f")),
            **{name: table(nonzeros(made, name), model.n) for name in ("F", "Qc")},
        }  # fmt: skip

    propagate, dt = linear() if model.kind == "error-state" else (total(), None)
    correct, strapdown = change("feedback"), change("strapdown")
    loops = looped() if model.loops else None
    tables = checks.tables(model.kind == "total-state")
    if loops:
        for name in ("F", "Qc", "f"):
            files[by_name[name][1]["file"]] = None
    return {
        "total": model.kind == "total-state",
        "loops": loops,
        "files": list(files),
        "tables": tables,
        "checks": list(checks.made.values()),
        "box_of_x": checks.box_of("check_x"),
        "ceiling": ", ".join(map(number, ceilings(model))),
        "ceilings": [
            (v.name, v.unit, ", ".join(f"{math.sqrt(c):.0e}" for c in part))
            for v, part in zip(model.states, split(ceilings(model), [v.size for v in model.states]), strict=True)
        ],
        "blocks": [v.size for v in model.states],
        "squares": sum(v.size**2 for v in model.states),
        "snapshot": {
            "numbers": sum(a.size for s in model.structs if s.name in carried for a in s.fields)
            + model.n * (model.n + 3) // 2,
            # counts of two bytes, which states are considered, and the checksum
            "bytes": 2 * (len(measurements) + 1) + model.n + 4,
        },
        "wraps": [i for i, wraps in enumerate(v.wraps for v in model.states for _ in v.symbols) if wraps],
        "explicit": any(u["h"] for u in measurements),
        "angled": any(u["h"] and u["angles"] != "0U" for u in measurements),
        "turned": any(not u["h"] and u["angles"] != "0U" for u in measurements),
        "iterated": any(u["nonlinear"] for u in measurements),
        "correlated": any(u["correlated"] for u in measurements),
        "separated": any(u["nonlinear"] and u["correlated"] for u in measurements),
        "carried": carried,
        "max_rows": max(len(m.rows) for m in model.measurements),
        "least_R": repr(LEAST_R),
        "most_R": repr(MOST_R),
        "dt": dt,
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
    carry = carried_far(model, made, points)
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
                    "carried": own,  # from such an end a strapdown moves beyond it
                    # the ends of a component may not be those of the norm
                    "leaves": a.norm is not None or a.name in carry,
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
        "dt": f["dt"]
        and (
            f["dt"]["value"].replace("filter->", "flown.")
            if f["dt"]["value"].startswith("filter->")
            else f"given_{f['dt']['value'].replace('->', '.')}"
        ),
        "structs": structs,
        "spoilt": [g for g in spoilt if g["functions"]],
        "checked": [
            box("", a)
            | {part: f"{of}{s.name}.{a.name}{'[i]' * (a.size > 1)}" for part, of in PLACES.items()}
            | {"norms": [f"{number(-v)}, {number(v)}" for v in a.norm or ()], "norms_beyond": norms_beyond(a)}
            for s in model.structs
            if s.name in f["carried"]
            for a in s.fields
        ],
        "sigma": ", ".join(repr(size * 1e-4) for size in box_size),
        "start": ", ".join(map(repr, start_x)),
        "x_low": ", ".join(map(number, x.low)),
        "x_high": ", ".join(map(number, x.high)),
        "x_beyond": beyond(x),
        "x_low_numbers": ", ".join(map(repr, map(float, x.low))),
        "x_high_numbers": ", ".join(map(repr, map(float, x.high))),
        "places": {name: places(name) for name in (() if f["total"] else ("F", "Qc"))},
    }


def inside(model: Model) -> list[float]:
    """A state of zero, or where its box leaves that out, the middle of that."""
    bounds = [pair for block in model.states for pair in zip(block.low, block.high, strict=True)]
    return [0.0 if lo <= 0.0 <= hi else (lo + hi) / 2 for lo, hi in bounds]


def carried_far(model: Model, made: list[Unit], points: list[np.ndarray]) -> set[str]:
    """The inputs from an end of whose box the self-test's first measurement may carry x to a tenth of its ceilings."""
    units, start = {unit.name: unit for unit in made}, np.array(inside(model))
    sigma = np.array([(hi - lo) * 1e-4 for v in model.states for lo, hi in zip(v.low, v.high, strict=True)])
    P, most = np.outer(sigma, sigma) * (0.25 + 0.75 * np.eye(model.n)), np.sqrt(ceilings(model))
    found = set()
    for m in model.measurements:
        parts = [units[name] for part in "zhH" if (name := f"{m.name}_{part}") in units]
        for a in model.inputs:
            if not any(arg.name == a.name for unit in parts for arg in unit.args):
                continue
            for i, end in ((j, e) for j in range(a.size) for e in (a.low[j], a.high[j])):
                at = {v.name: point[:1].copy() for v, point in zip(model.inputs, points, strict=True)}
                at[a.name][0, i] = end
                at["x"] = start[None]
                nu, H = np.zeros(len(m.rows)), np.zeros((len(m.rows), model.n))
                for unit in parts:
                    results, _ = evaluate(unit.tape, [at[arg.name] for arg in unit.args])
                    for (output, nz, _), value in zip(unit.tape.results, results, strict=True):
                        row, column = unit.results[output].nonzeros[nz]
                        if unit.name.endswith("_H"):
                            H[row, column] = value[0]
                        else:
                            nu[row] += abs(value[0])
                S = np.einsum("ij,jk,ik->i", H, P, H) + 1.0
                far = abs(P @ H.T) @ (nu / S)
                if not (far <= 0.1 * most).all():
                    found.add(a.name)
    return found


def answered_by_all(model: Model, made: list[Unit]) -> list[np.ndarray]:
    """FLOWN points of all inputs, (FLOWN, size) each, at which every unit answers for x as `inside` has it."""
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
    chosen = np.flatnonzero(keep)[:FLOWN]
    if len(chosen) < FLOWN:
        raise BoresightError(
            f"{model.name}: {len(chosen)} of {count} points of its boxes have an answer everywhere; narrow them"
        )
    return [part[chosen] for part in drawn]


def writes_fields(by_name: dict[str, Any], name: str, owner: dict[str, str]) -> bool:
    """Whether the model has this function and everything it gives is an input field of the model."""
    return name in by_name and all(r.name in owner for r in by_name[name][0].results)


def box(access: str, v: Any, place: int | None = None) -> dict[str, Any]:
    """A field with its bounds as C; one component of it if `place` is given."""
    chosen = slice(None) if place is None else slice(place, place + 1)
    size = v.size if place is None else 1
    return {
        "name": v.name, "size": size, "access": access if v.size > 1 and place is None else f"&{access}",
        "low": ", ".join(map(number, v.low[chosen])), "high": ", ".join(map(number, v.high[chosen])),
        "norm": tuple(number(b * b) for b in v.norm) if v.norm else None,
        # what a vector is scaled to that is none of the norms
        "length": number(1.0 if v.norm[0] <= 1 <= v.norm[1] else sum(v.norm) / 2) if v.norm else None, "of": v,
    }  # fmt: skip
