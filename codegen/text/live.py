"""The live loop of an error state as its templates see it: who fills each number that the filter's functions read.

An input is carried; or read off the sensors at each sample, alone or as it was a sample before; or a rate, which is
solved for in what the mechanics says that the sensors show; or the rate of change of what a function expects of a
measurement; or the age of a measurement, which is none at its own instant; or a constant of the rules; or part of a
message.
"""

import itertools
from typing import Any

import numpy as np
import sympy as sp
from scipy.stats import chi2
from scipy.stats import t as student
from sympy.printing.c import C99CodePrinter

from boresight.codegen.functions.tape import evaluate
from boresight.codegen.functions.unit import Unit
from boresight.codegen.text.covariance import nonzeros
from boresight.codegen.text.filter import (
    FLOWN,
    Wiring,
    answered,
    answered_by_all,
    changing,
    has_filter,
    measuring,
    predicting,
    stepping,
)
from boresight.codegen.text.names import number, rows_of
from boresight.derive.expressions import symbols_in
from boresight.derive.linear import is_rate
from boresight.derive.model import Model, Variable
from boresight.derive.units import RADIAN, SECOND, units

LAG, DELAY, BEFORE = "lag", "tau", "_before"
WINDOW, WINDOWS, LEVELS = 64, 4, 3  # messages over which innovations are watched, how many of these make a longer one
UNLIKELY = 1e-8  # so seldom is one window of one row called so where nothing is wrong
RESTED = 20  # steps of the strapdown without motion that a self-test of the loop begins with
OPENED = 0.1  # of the box of a state that others drive: by how much it may err for each second of missing samples


def has_live(model: Model) -> bool:
    """Whether a loop can carry and correct it by itself."""
    names = {f.name for f in model.functions}
    steps = any(model.dt in v.symbols for v in model.inputs)
    return steps and has_filter(model) and model.kind == "error-state" and {"strapdown", "feedback"} <= names


class Printer(C99CodePrinter):
    """An expression in C, its symbols by where they stand."""

    def __init__(self, places: dict[sp.Symbol, str]):
        super().__init__()
        self.places = places

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        return self.places[expr]

    def _print_Integer(self, expr: sp.Integer) -> str:
        return number(float(expr))

    def _print_Rational(self, expr: sp.Rational) -> str:
        return number(float(expr))

    def _print_Float(self, expr: sp.Float) -> str:
        return number(float(expr))


class Inputs:
    """Who fills what, of one model."""

    def __init__(self, model: Model, wiring: Wiring):
        self.model, self.wiring = model, wiring
        mechanics = model.mechanics
        self.fields = {v.name: v for v in model.inputs}
        self.carried = [v for s in model.structs if s.name in wiring.carried for v in s.fields]
        self.dt = next(v for v in model.inputs if model.dt in v.symbols)
        strapdown, moved = set(wiring.fields("strapdown")), {*map(id, self.carried)}
        stated = {v.name: column for v, column in mechanics.step} if mechanics else {}
        self.driven = {what.name: noise for noise, what in mechanics.driven} if mechanics else {}
        self.before: dict[str, str] = {}
        self.sensed: list[Variable] = []
        for v in model.inputs:
            if id(v) in moved or v is self.dt or v.name not in strapdown:
                continue
            if v.name.endswith(BEFORE):
                stem = v.name.removesuffix(BEFORE)
                alike = [w.name for w in self.sensed if w.name.startswith(stem) and w.size == v.size]
                if len(alike) == 1:
                    self.before[v.name] = alike[0]
            if v.name not in self.before and (v.name in stated or v.name in self.driven):
                self.sensed.append(v)
        self.solved = self.rates(stated)
        self.changes = self.rates_of_change()

    def integral(self, v: Variable) -> bool:
        """Whether a sensor delivers it as an integral over the step, not as a rate."""
        noise = self.driven.get(v.name)
        return noise is None or not is_rate(noise, v)

    def rates(self, stated: dict[str, sp.Matrix]) -> dict[str, list[sp.Expr]]:
        """Rate -> its components by the means of what the sensors deliver, a second, and by what is carried."""
        known = {s for v in self.carried for s in v.symbols}
        own = {s: (v.name, i) for v in self.model.inputs for i, s in enumerate(v.symbols)}
        found: dict[str, dict[int, sp.Expr]] = {}
        for v in self.sensed:
            for i, shown in enumerate(stated.get(v.name, [])):
                shown = sp.expand(shown / self.model.dt) if self.integral(v) else shown
                unknown = [s for s in symbols_in([shown]) if s not in known and s in own]
                if len(unknown) == 1 and (slope := sp.diff(shown, unknown[0])) != 0 and not slope.has(unknown[0]):
                    name, place = own[unknown[0]]
                    rest = shown.subs(unknown[0], 0)
                    found.setdefault(name, {})[place] = (sp.Symbol(f"mean_{v.name}_{i}") - rest) / slope
        return {
            name: [parts[i] for i in range(self.fields[name].size)]
            for name, parts in found.items()
            if len(parts) == self.fields[name].size
        }

    def rates_of_change(self) -> dict[str, tuple[str, str]]:
        """Field of a message -> the function and the output of it whose rate of change it is."""
        found = {}
        for f in self.model.functions:
            if f.name in ("strapdown", "feedback"):
                continue
            given = {o.name: o for o in f.outputs if o.name in self.fields and self.fields[o.name] not in self.carried}
            for name, o in given.items():
                struct = next(s for s in self.model.structs if any(v.name == name for v in s.fields))
                for v in struct.fields:
                    same = v.size == o.value.rows and v.name not in given and v.name.startswith("a_")
                    if same and (units(v.unit, v.size)[0] * SECOND).like(units(o.unit, v.size)[0]):
                        found[v.name] = f.name, name
        return found

    def filled(self, v: Variable) -> bool:
        """Whether the loop itself knows it at any instant."""
        names = {self.dt.name, LAG, *self.before, *self.solved, *self.changes, *(w.name for w in self.sensed)}
        return v.name in names

    def structs(self) -> tuple[list[str], list[str]]:
        """Those of the rules, and those of a message."""
        wiring = self.wiring
        step = ["F", "Qc"] if self.model.F is not None else ["Phi", "Q"]
        flown = {s for name in ("strapdown", "feedback", *step) for s in wiring.structs(name)}
        rules: list[str] = []
        message: list[str] = []
        for s in self.model.structs:
            if s.name in wiring.carried or all(map(self.filled, s.fields)):
                continue
            (rules if s.name in flown else message).append(s.name)
        return rules, message


def resets(model: Model, made: list[Unit]) -> list[tuple[int, int, int, float]]:
    """(i, j, k, b): how a correction by x turns the errors that are left, e' = (I - B(x)) (e - x), B(x)_ij = b x_k.

    Errors of a rotation do not add: two feedbacks are one by their sum and half of their cross product.
    """
    (unit,) = (unit for unit in made if unit.name == "feedback")
    names = [r.name for r in unit.results]
    points = answered_by_all(model, made)
    ends, n = [0, *itertools.accumulate(v.size for v in model.states)], model.n
    found: list[dict[tuple[int, int, int], float]] = []
    for point in range(FLOWN):
        here = {v.name: part[point : point + 1] for v, part in zip(model.inputs, points, strict=True)}

        def fed(base: dict[str, Any], x: Any) -> dict[str, Any]:
            values = base | {"x": x[None]}
            results, _ = evaluate(unit.tape, [values[a.name] for a in unit.args])
            out = {name: np.array(base[name]) for name in names}
            for (output, nz, _), value in zip(unit.tape.results, results, strict=True):
                out[names[output]][:, nz] = value
            return base | out

        def flat(base: dict[str, Any]) -> Any:
            return np.concatenate([base[name][0] for name in names])

        one, step = np.eye(n), 1e-4
        J = np.stack([(flat(fed(here, step * e)) - flat(fed(here, -step * e))) / (2 * step) for e in one], axis=1)
        back, small = np.linalg.pinv(J), 1e-3
        terms: dict[tuple[int, int, int], float] = {}
        for first, last in itertools.pairwise(ends):
            if last - first != 3 or units(model.states[ends.index(first)].unit, 3)[0] != RADIAN:
                continue
            for j, k in itertools.product(range(first, last), repeat=2):
                wanted = flat(fed(fed(here, small * one[k]), small * one[j]))
                whole = small * (one[j] + one[k])
                for _ in range(3):
                    whole = whole + back @ (wanted - flat(fed(here, whole)))
                bent = (whole - small * (one[j] + one[k])) / small**2
                terms |= {(i, j, k): bent[i] for i in range(first, last) if abs(bent[i]) > 0.1}
        found.append(terms)
    same = {key for key in found[0] if all(abs(2 * f.get(key, 0) - round(2 * found[0][key])) < 0.1 for f in found)}
    return [(*key, round(2 * found[0][key]) / 2) for key in sorted(same)]


def start(inputs: Inputs, made: list[Unit], dt: float) -> dict[str, str]:
    """By struct one point as C, of those at which every unit answers: the first at which the strapdown, which feels
    nothing, keeps to its boxes; or the first."""
    model = inputs.model
    points = answered(model, made)
    names = [v.name for v in model.inputs]
    values = dict(zip(names, points, strict=True)) | {inputs.dt.name: np.full((len(points[0]), 1), dt)}
    felt = [*(v.name for v in inputs.sensed), *inputs.before]
    values |= {name: np.zeros_like(values[name]) for name in felt}
    (unit,) = (unit for unit in made if unit.name == "strapdown")
    good = np.ones(len(points[0]), dtype=bool)
    for _ in range(RESTED):
        results, _ = evaluate(unit.tape, [values[a.name] for a in unit.args])
        after = {r.name: values[r.name].copy() for r in unit.results}
        for (output, nz, _), value in zip(unit.tape.results, results, strict=True):
            result = unit.results[output]
            after[result.name][:, result.nonzeros[nz][0]] = value
        for name, value in after.items():
            box = inputs.fields[name]
            good &= ((value >= np.array(box.low)) & (value <= np.array(box.high))).all(axis=1)
        values |= after
    here = int(np.argmax(good))
    drawn = iter(part[here : here + 1] for part in points)
    return {s.name: rows_of(np.hstack([next(drawn) for _ in s.fields])) for s in model.structs}


def read_by(unit: Unit) -> dict[tuple[str, int], set[tuple[str, int]]]:
    """Component of a result -> the components of the inputs that it depends on."""
    below: list[set[tuple[str, int]]] = []
    for step in unit.tape.steps:
        own = {(unit.args[step.source[0]].name, step.source[1])} if step.op == "input" else set()
        below.append(own.union(*(below[k] for k in step.args)))
    return {(unit.results[i].name, k): below[step] for i, k, step in unit.tape.results}


class Errors:
    """Of what H stands on, which states and which sensors can change it: no others are varied."""

    def __init__(self, inputs: Inputs, made: list[Unit], sensed: list[dict[str, Any]]):
        self.inputs, self.sensed, self.n = inputs, sensed, inputs.model.n
        self.units = {unit.name: unit for unit in made}
        self.owners = {s: (v.name, i) for v in inputs.carried for i, s in enumerate(v.symbols)}
        corrected = read_by(self.units["feedback"])
        self.corrects = {j: {place for place, of in corrected.items() if ("x", j) in of} for j in range(self.n)}
        self.numbers = sum(s["size"] for s in sensed)
        after = {j: {j} for j in range(self.n)}  # the states that an error of j becomes one of
        for _ in range(self.n):
            for i, j in nonzeros(made, "F" if inputs.model.F is not None else "Phi"):
                for whole in after.values():
                    whole |= {i} if j in whole else set()
        self.after = after

    def stands_on(self, places: set[tuple[str, int]]) -> tuple[set[tuple[str, int]], set[int]]:
        """Of the inputs of a function: the components that are carried, and those of the sensors' means."""
        carried, means = set(), set()
        for name, i in places:
            if (name, i) in self.owners.values():
                carried.add((name, i))
            of = next((s for s in self.sensed if s["name"] == self.inputs.before.get(name, name)), None)
            if of is not None:
                means.add(of["offset"] + i)
            for s in symbols_in([self.inputs.solved[name][i]]) if name in self.inputs.solved else ():
                if s in self.owners:
                    carried.add(self.owners[s])
                means |= {k["offset"] + j for k in self.sensed for j in range(k["size"])
                          if str(s) == f"mean_{k['name']}_{j}"}  # fmt: skip
        return carried, means

    def varied(self, name: str, changes: list[dict[str, Any]]) -> list[int]:
        """States by their numbers; then n and more: sensors; then those again where they change what is expected."""
        unit = self.units[f"{name}_H"]
        places = set().union(*read_by(unit).values())
        carried, means = self.stands_on(places)
        found = {j for j in range(self.n) if self.corrects[j] & carried} | {self.n + i for i in means}
        for change in changes:
            expecting = self.units[change["function"]]
            wanted = [of for (result, _), of in read_by(expecting).items() if result == change["output"]]
            carried, means = self.stands_on(set().union(*wanted))
            found |= {j for j in range(self.n) for i in self.after[j] if self.corrects[i] & carried}
            found |= {self.n + self.numbers + i for i in (*means, *(k for k in change["shown"] if k >= 0))}
        noisy = [s["noise"] is not None for s in self.sensed for _ in range(s["size"])]
        return sorted(k for k in found if k < self.n or noisy[(k - self.n) % self.numbers])


def path(place: str, v: Variable, i: int) -> str:
    """Component i of a field, as C reaches it."""
    return f"{place}.{v.name}" if v.size == 1 else f"{place}.{v.name}[{i}]"


def live_view(model: Model, made: list[Unit], views: list[dict[str, Any]]) -> dict[str, Any] | None:
    """What the templates of the live loop are filled with; None for a model that has none."""
    if not has_live(model):
        return None
    wiring = Wiring(model, made, views)
    inputs = Inputs(model, wiring)
    strapdown, correct = changing(wiring, "strapdown", "strapdown"), changing(wiring, "feedback", "correct")
    if strapdown is None or correct is None or not inputs.sensed:
        return None
    rules, message = inputs.structs()
    measurements = [measuring(wiring, m) for m in model.measurements]
    propagate = stepping(wiring) if model.F is None else predicting(wiring)
    places = {
        s: path(f"at->{struct.name}", v, i)
        for struct in model.structs
        if struct.name in wiring.carried
        for v in struct.fields
        for i, s in enumerate(v.symbols)
    }
    offset, sensed = 0, list[dict[str, Any]]()
    for v in inputs.sensed:
        noise = inputs.driven.get(v.name)
        of_noise = next((s.name for s in model.structs for w in s.fields if w is noise), None)
        sensed.append(
            {
                "name": v.name, "size": v.size, "offset": offset, "integral": inputs.integral(v), "unit": v.unit,
                "meaning": v.meaning, "frame": v.frame, "low": number(min(v.low)), "high": number(max(v.high)),
                "noise": noise and {"name": noise.name, "struct": of_noise, "size": noise.size},
            }
        )  # fmt: skip
        places |= {sp.Symbol(f"mean_{v.name}_{i}"): f"mean[{offset + i}]" for i in range(v.size)}
        offset += v.size
    printer = Printer(places)

    def filled_struct(name: str) -> dict[str, Any]:
        """How a struct that no filter carries comes to its numbers."""
        fields = []
        for v in next(s.fields for s in model.structs if s.name == name):
            kind: dict[str, Any] = {"name": v.name, "size": v.size}
            if v is inputs.dt:
                kind["is"] = "dt"
            elif v.name == LAG:
                kind["is"] = "lag"
            elif v.name in inputs.before:
                kind |= {"is": "before", "of": next(s for s in sensed if s["name"] == inputs.before[v.name])}
            elif v.name in inputs.solved:
                kind |= {"is": "rate", "lines": [printer.doprint(e) for e in inputs.solved[v.name]]}
            elif any(s["name"] == v.name for s in sensed):
                kind |= {"is": "sensed", "of": next(s for s in sensed if s["name"] == v.name)}
            elif v.name in inputs.changes:
                kind |= {"is": "change", "of": inputs.changes[v.name][1]}
            else:
                continue
            fields.append(kind)
        return {"name": name, "fields": fields, "place": "rules" if name in rules else
                "message" if name in message else "own"}  # fmt: skip

    structs = {s.name: filled_struct(s.name) for s in model.structs if s.name not in wiring.carried}
    moved = {i for i, j in nonzeros(made, "F" if model.F is not None else "Phi") if i != j}
    ends = [high for block in model.states for high in block.high]
    delay = next((v for v in inputs.carried if v.name == DELAY and v.size == 1), None)
    owner = {v.name: s.name for s in model.structs for v in s.fields}
    column = None
    if delay is not None:
        feedback = next(f for f in model.functions if f.name == "feedback")
        read = symbols_in(next(o.value for o in feedback.outputs if o.name == delay.name))
        column = next((i for i, s in enumerate(model.x) if s in read), None)
    expected = {f for f, _ in inputs.changes.values()}
    functions = {
        name: {
            "c_name": wiring.units[name][1]["c_name"], "reads": wiring.units[name][1]["reads"],
            "results": [{"name": r.name, "size": r.shape[0]} for r in wiring.units[name][0].results],
        }
        for name in sorted(expected)
    }  # fmt: skip
    brings = any(u["z"] is None for u in measurements)
    errors = Errors(inputs, made, sensed)
    for m, u in zip(model.measurements, measurements, strict=True):
        u["late"] = column is not None and any(j == column for _, j in nonzeros(made, f"{m.name}_H"))
        u["changes"], u["call"] = [], wiring.units[f"{m.name}_H"][1]
        for name in (name for name in inputs.changes if name in u["fields"]):
            f, o = inputs.changes[name]
            place, size = sum(c["size"] for c in u["changes"]), inputs.fields[name].size
            alike = [s for s in sensed if s["unit"] == inputs.fields[o].unit and s["size"] == size]
            shown = {s["offset"] + i: place + i for s in alike for i in range(size)}
            u["changes"].append({"name": name, "function": f, "output": o, "struct": owner[name], "size": size,
                                 "place": place, "shown": [shown.get(k, -1) for k in range(offset)]})  # fmt: skip
        u["change"] = sum(c["size"] for c in u["changes"])
        u["varied"] = errors.varied(m.name, u["changes"])
    test_dt = min(max(0.01, 1.5 * inputs.dt.low[0]), 0.9 * inputs.dt.high[0])
    read_at_once = {*propagate["structs"], *(s for u in measurements for s in u["structs"])}
    read_at_once |= {s for f in functions.values() for s in f["reads"]}
    compared = {s for u in measurements for s in (*u["structs"], *u["call"]["reads"])}
    compared |= {s for f in functions.values() for s in f["reads"]}
    return {
        "sensed": sensed, "numbers": offset, "rules": rules, "message": message, "structs": structs,
        "strapdown": strapdown | wiring.dense("strapdown"), "correct": correct | wiring.dense("feedback"),
        "propagate": propagate, "measurements": measurements, "carried": wiring.carried,
        "moving": strapdown["out"], "delay": delay and late_by(delay, owner),
        "column": column, "most_change": max(u["change"] for u in measurements),
        "compared": [s.name for s in model.structs if s.name in compared and s.name not in wiring.carried],
        "functions": functions, "brings": brings,
        "most_rows": max(u["m"] for u in measurements), "most_noise": max(u["size_R"] for u in measurements),
        "filled": [name for name, s in structs.items() if s["fields"] and name in read_at_once],
        "open": ", ".join(number(OPENED * high if i in moved else 0.0) for i, high in enumerate(ends)),
        "most": ", ".join(number(0.9 * high) for high in ends),
        "digested": [
            {"access": f"{'&' if v.size == 1 else ''}live->now.{owner[v.name]}.{v.name}", "size": v.size}
            for v in inputs.carried
        ],
        "quiet": [
            {"struct": s.name, "name": v.name, "size": v.size}
            for s in model.structs if s.name in rules for v in s.fields if max(v.low) <= 0 <= min(v.high)
        ],
        "start": start(inputs, made, test_dt), "test_dt": repr(test_dt), "test_us": round(test_dt * 1e6),
        "dt": {
            "low": number(inputs.dt.low[0]), "high": number(inputs.dt.high[0]),
            "longest_us": max(1, int(0.9e6 * inputs.dt.high[0])),
        },
        "rows": sum(u["m"] for u in measurements), "window": WINDOW, "windows": WINDOWS, "bounds": bounds(),
        "dt_us": max(1e6 * inputs.dt.high[0], 1e7) + 1,
    }  # fmt: skip


def bounds() -> list[dict[str, Any]]:
    """Of each window of white innovations: its messages, the least and the largest mean square, the square of a
    correlation.  A correlation by Student's t, which a mean and a lag of one both follow."""
    found = []
    for n in (WINDOW * WINDOWS**level for level in range(LEVELS)):
        low, high = chi2.ppf([UNLIKELY / 2, 1 - UNLIKELY / 2], n) / n
        t2 = student.isf(UNLIKELY / 2, n) ** 2
        numbers = {"low": low, "high": high, "correlation": t2 / (n + t2)}
        found.append({"messages": n} | {name: number(float(f"{x:.4g}")) for name, x in numbers.items()})
    return found


def late_by(delay: Variable, owner: dict[str, str]) -> dict[str, Any]:
    """The delay that is carried, its lower end in s, and the most microseconds that it may be."""
    most = 1e6 * max(abs(delay.low[0]), abs(delay.high[0]))
    return {"struct": owner[delay.name], "name": delay.name, "low": delay.low[0], "us": most}


def live_manifest(model: Model, made: list[Unit], views: list[dict[str, Any]]) -> dict[str, Any] | None:
    """What a caller of the loop in C must know to lay its structs out."""
    v = live_view(model, made, views)
    return v and {
        "sensed": [s["name"] for s in v["sensed"]], "rules": v["rules"], "message": v["message"],
        "variances": v["most_noise"], "z": v["most_rows"] if v["brings"] else 0,
    }  # fmt: skip
