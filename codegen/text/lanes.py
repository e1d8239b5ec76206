"""The filter over blocks of runs, as its template sees it: what of it goes in lanes, and its sparse products."""

from collections.abc import Collection
from itertools import accumulate
from typing import Any

from boresight.codegen.functions.unit import Unit
from boresight.codegen.text.covariance import even, movers, nonzeros
from boresight.codegen.text.names import number
from boresight.codegen.text.places import coupled, reach
from boresight.derive.model import Model, Variable

WIDE, TALL = 5, 3  # columns and rows of a product that are summed at a time


def unit_lanes_view(model: Model, made: list[Unit], views: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Every function of something over blocks of runs: the fields that it reads, its box, and what it writes where."""
    found = []
    for unit, seen in zip(made, views, strict=True):
        if not unit.args:
            continue
        place, to = {}, 0
        for a in unit.args:
            place[a.name], to = to, to + a.size
        inputs = [f"&in[{place[a.name]}]" for a in unit.args]
        out = [f"&out[{k}][run * {r['total']}U]" for k, r in enumerate(seen["results"])]
        found.append({
            "c_name": seen["c_name"], "file": seen["file"], "count": to, "results": seen["results"],
            "box": boxes(list(unit.args), place), **called(unit, seen, inputs, [r["nz_name"] for r in seen["results"]]),
            "loads": [(shown["element"], shown["size"], place[shown["name"]]) for shown in seen["args"]],
            "structs": [struct["declaration"] for struct in seen["structs"]],
            "alone": f"{seen['c_name']}({', '.join([*([seen['inputs']] if seen['inputs'] else []), *out])})",
        })  # fmt: skip
    return found


def lanes_view(model: Model, made: list[Unit], views: list[dict[str, Any]], f: dict[str, Any]) -> dict[str, Any]:
    """f: `text.filter.filter_view` of the model.

    Of an error state given by F whose angles do not wrap the strapdown, the correction and every measurement that is
    linear in the state, of independent rows, go in lanes; so does the prediction, where Phi is of second order.
    """
    by_name = {unit.name: (unit, view) for unit, view in zip(made, views, strict=True)}
    fields = [a for s in model.structs if s.name in f["carried"] for a in s.fields]
    at, start = {}, 0
    for a in fields:
        at[a.name], start = start, start + a.size
    calls = {name: f[name] for name in ("strapdown", "propagate", "correct") if f[name]}
    wide = model.F is not None and not f["wraps"]
    view: dict[str, Any] = {
        "carried": max(1, start), "calls": calls, "wide": wide, "files": [],
        "box": boxes(fields, at) if fields else None,
    }  # fmt: skip
    if not wide:
        return view
    files: dict[str, None] = {}

    def given(call: dict[str, Any]) -> dict[str, Any]:
        """The fields that a call is given: which number of which struct goes where, and their boxes."""
        loads, used, place, to = [], [], {}, 0
        for k, name in enumerate(call["structs"]):
            (struct,) = (s for s in model.structs if s.name == name)
            offset = 0
            for a in struct.fields:
                if a.name in call["fields"]:
                    loads.append((k, offset, a.size, to))
                    used.append(a)
                    place[a.name], to = to, to + a.size
                offset += a.size
        return {"loads": loads, "count": to, "place": place, "box": boxes(used, place) if used else None}

    def kernel(name: str, given: dict[str, Any], out: list[str], now: Collection[str] = ()) -> dict[str, Any]:
        """Of a unit by its name, `called`.  now: fields that change from sample to sample."""
        unit, seen = by_name[name]
        files[seen["file"]] = None
        inputs = ["b->x" if a.name == "x" else f"&now[{at[a.name]}]" if a.name in now
                  else f"&b->carried[{at[a.name]}]" if a.name in at
                  else f"&in[{given['place'][a.name]}]" for a in unit.args]  # fmt: skip
        return called(unit, seen, inputs, out)

    def change(name: str, call: dict[str, Any], sampled: bool) -> dict[str, Any]:
        unit, _ = by_name[name]
        taken = given(call)
        out = [f"&next[{at[r.name]}]" for r in unit.results]
        changed = [a for a in fields if a.name in {r.name for r in unit.results}]
        now = [a.name for a in changed if sampled]
        return {
            **taken, "kernel": kernel(name, taken, out, now),
            "after": groups([(at[a.name], a.size) for a in changed]),
            "norms": boxes(changed, at)["norms"],
            "state": any(a.name == "x" for a in unit.args) or None,
        }  # fmt: skip

    for name, unit_name, sampled in (("strapdown", "strapdown", True), ("correct", "feedback", False)):
        if name in calls:
            view[name] = change(unit_name, calls[name], sampled)
    x = [(lo, hi) for v in model.states for lo, hi in zip(v.low, v.high, strict=True)]
    view["x"] = {"low": ", ".join(number(lo) for lo, _ in x), "high": ", ".join(number(hi) for _, hi in x)}
    view["measurements"] = {}
    for u in f["measurements"]:
        H = next(unit for unit in made if unit.name == f"{u['name']}_H").results[0].nonzeros
        full = len({row for row, _ in H}) == u["m"]  # every row measures something
        if full and not (u["nonlinear"] or u["correlated"] or u["h"]):
            taken = given(u)
            view["measurements"][u["name"]] = {
                **taken, "z": kernel(f"{u['name']}_z", taken, ["z"]) if u["z"] else None,
                "H": kernel(f"{u['name']}_H", taken, ["H"]),
                "starts": [sum(row < i for row, _ in H) for i in range(u["m"] + 1)],
            }  # fmt: skip
    sparse = discretized(model, made) if model.order == 2 else None
    if sparse:
        taken = given(calls["propagate"])
        dt, place = next((v, v.symbols.index(model.dt)) for v in model.inputs if model.dt in v.symbols)
        view["propagate"] = {
            **taken, **sparse, "F": kernel("F", taken, ["s->F"]), "Qc": kernel("Qc", taken, ["s->Qc"]),
            "dt": f"b->carried[{at[dt.name] + place}]" if dt.name in at else f"in[{taken['place'][dt.name] + place}]",
        }  # fmt: skip
    else:
        view["propagate"] = None
    view["files"] = list(files)
    return view


def called(unit: Unit, seen: dict[str, Any], inputs: list[str], out: list[str]) -> dict[str, Any]:
    """The call of a unit's kernel, and of its answers what is judged."""
    judged = [
        {"at": to, "count": len(r.nonzeros), "low": r.low and ", ".join(map(number, r.low)),
         "high": r.low and ", ".join(map(number, r.high))}
        for r, shown, to in zip(unit.results, seen["results"], out, strict=True) if shown["checked"]
    ]  # fmt: skip
    call = f"{seen['c_name']}_kernel({', '.join([*inputs, *out])})"
    return {"call": call, "elementary": seen["elementary"], "judged": judged}


def groups(ranges: list[tuple[int, int]]) -> list[dict[str, int]]:
    """Ranges of numbers, those that touch as one."""
    found: list[dict[str, int]] = []
    for at, count in ranges:
        if found and found[-1]["at"] + found[-1]["count"] == at:
            found[-1]["count"] += count
        else:
            found.append({"at": at, "count": count})
    return found


def boxes(fields: list[Variable], at: dict[str, int]) -> dict[str, Any]:
    """Ends of the numbers of fields, and where the norms stand."""
    return {
        "at": [at[a.name] + i for a in fields for i in range(a.size)],
        "low": ", ".join(number(v) for a in fields for v in a.low),
        "high": ", ".join(number(v) for a in fields for v in a.high),
        "norms": [(at[a.name], a.size, *(number(v * v) for v in a.norm)) for a in fields if a.norm],
    }


def discretized(model: Model, made: list[Unit]) -> dict[str, Any] | None:
    """`discretize` of second order and `joseph_predict` by the non-zeros alone: the sums of the loops of src/, in
    their order, less the terms that are zero.  None where noises of two states that stay have a part in common."""
    n, F, Qc = model.n, sorted(nonzeros(made, "F")), sorted(nonzeros(made, "Qc"))
    m = movers(model, made)
    first = reach(n, tuple(Qc))
    if any(m <= i for j, begin in enumerate(first) for i in range(begin, j)):
        return None
    a = {place: p for p, place in enumerate(F)}
    squared = {
        (i, j): [(a[i, k], a[k, j]) for k in range(m) if (i, k) in a and (k, j) in a]
        for i in range(m)
        for j in range(n)
    }
    squared = {place: pairs for place, pairs in squared.items() if pairs}
    Phi = sorted({*F, *squared, *((i, i) for i in range(m))})
    phi = set(Phi)
    noisy = {j for i, j in Qc if i == j} | {k for k in coupled(first)}  # states that noise drives
    # of B = I + 2/3 A + 2/9 A^2, times the factor of Qc, only the columns that meet noise
    filled = {place for place in Phi if place[1] in noisy}
    for k in coupled(first):
        filled |= {(i, k) for i, j in phi if first[k] <= j < k}
    size, wide = even(n, WIDE)
    tall, down = even(m, TALL)
    Phi_tiles, B_tiles = Tiles(phi, m, tall), Tiles(filled, m, tall)
    rows = []
    for i in range(m):
        line: dict[str, Any] = {"i": i, "begin": [], "gains": [], "end": []}
        for k in range(n):
            place = (i, k)
            own, twice = f"A[{a[place]}]" if place in a else None, f"t{k}" if place in squared else None
            if twice:
                line["begin"].append(f"const bs_lanes {twice} = {sum_of(squared[place])}")
            if place in phi:
                line["begin"].append(f"Phi[{Phi_tiles.slot[place]}] = {entry(place, own, twice, None, 0.5)}")
            if place in filled:
                value = entry(place, own, twice, 2 / 3, 2 / 9) if place in phi else "bs_all_of(0.0)"
                line["begin"].append(f"bs_lanes b{k} = {value}")
                line["end"].append((k, B_tiles.slot[place], k * down + i, k * (k + 1) // 2 + i if k >= m else None))
        for k in coupled(first):
            line["gains"] += [(k, l) for l in range(k - 1, first[k] - 1, -1) if (i, l) in phi]
        rows.append(line)
    steps: list[dict[str, Any]] = [
        {
            "k": k, "diagonal": k * (k + 3) // 2,
            "left": [
                {"l": l, "u": k * (k + 1) // 2 + l,
                 "inner": [(l * (l + 1) // 2 + i, k * (k + 1) // 2 + i) for i in range(first[k], l)]}
                for l in range(k - 1, first[k] - 1, -1)
            ],
        }
        for k in coupled(first)
    ]  # fmt: skip
    upper = sorted((i >= m, p, j * (j + 1) // 2 + i) for p, (i, j) in enumerate(Qc) if i <= j)
    noise = {at for _, _, at in upper}
    met = {at for k in steps for l in k["left"] for at in (l["u"], *(q for q, _ in l["inner"]))}
    written = noise | met | {j * (j + 1) // 2 + i for i, j in filled}
    zeros = {
        "Phi": sorted(set(range(Phi_tiles.size)) - set(Phi_tiles.slot.values())),
        "B": sorted(set(range(B_tiles.size)) - set(B_tiles.slot.values())),
        "T": [k * down + i for k in range(n) for i in range(down) if (i, k) not in filled],
        "Q": sorted({j * (j + 1) // 2 + i for j in range(m, n) for i in range(j + 1)} - written),
        "X": [i * wide + j for i in range(n) for j in range(n, wide)],
    }
    return {
        "zeros": {name: (len(at), ", ".join(map(str, at))) for name, at in zeros.items() if at},
        "met": sorted(met - noise),
        "m": m, "row": wide, "block": size, "tall": tall, "down": down, "groups": down // tall,
        "Phi": {"size": Phi_tiles.size, "start": Phi_tiles.start, **{
            name: Phi_tiles.places(stride) for name, stride in (("at", wide), ("across", down), ("x", 1))}},
        "B": {"size": B_tiles.size, "start": B_tiles.start, "at": B_tiles.places(down)},
        "rows": rows, "steps": steps,
        "noise": [(p, at) for _, p, at in upper],
        "moving": [(p, f"S[{j * down + i}]" if j < m else f"Q[{j * (j + 1) // 2 + i}]")
                   for p, (i, j) in enumerate(Qc) if i <= j and i < m],
        "staying": [(p, at) for stays, p, at in upper if stays],
        "noisy": [(k, k * (k + 3) // 2) for k in sorted(noisy)],
    }  # fmt: skip


class Tiles:
    """A sparse matrix by groups of `tall` rows: of each column that one of them meets, the elements of all, zeros
    included, one after the other.

    slot: where each element stands.  start: of each group, how many columns stand before it, as text.  size: elements.
    """

    def __init__(self, places: Collection[tuple[int, int]], m: int, tall: int):
        columns = [sorted({k for i, k in places if i // tall == group}) for group in range(-(-m // tall))]
        starts = [0, *accumulate(map(len, columns))]
        self.slot = {
            (i, k): tall * (starts[i // tall] + columns[i // tall].index(k)) + i % tall for i, k in sorted(places)
        }
        self.start = ", ".join(map(str, starts))
        self.size = tall * starts[-1]
        self._columns = [k for group in columns for k in group]

    def places(self, stride: int) -> str:
        """Where stands what the columns meet, as text."""
        return ", ".join(str(k * stride) for k in self._columns)


def sum_of(pairs: list[tuple[int, int]]) -> str:
    return " + ".join(["0.0", *(f"(A[{p}] * A[{q}])" for p, q in pairs)])


def entry(place: tuple[int, int], a: str | None, twice: str | None, of_a: float | None, of_twice: float) -> str:
    """An element of I + of_a A + of_twice A^2, zeros added as the loop adds them: they change the sign of a zero."""
    if not (a or twice):
        return "bs_all_of(1.0)"
    first = "0.0" if a is None else a if of_a is None else f"({of_a!r} * {a})"
    value = f"{first} + {f'({of_twice!r} * {twice})' if twice else '0.0'}"
    return f"({value}) + 1.0" if place[0] == place[1] else value
