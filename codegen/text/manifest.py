"""What a reader without SymPy needs to bind and to check the generated C, as JSON."""

from typing import Any

from boresight.codegen.functions.dynamics import left_out
from boresight.codegen.functions.unit import Unit, state_variable
from boresight.codegen.text.covariance import covariance_view
from boresight.codegen.text.filter import ceilings, filter_view, has_filter
from boresight.codegen.text.live import live_manifest
from boresight.derive.model import Model, Variable

MATRICES = {"F", "Phi", "Q", "H"}  # two axes in NumPy, even for a model with one state


def filter_manifest(model: Model, made: list[Unit], views: list[dict[str, Any]]) -> dict[str, Any]:
    """What a caller of the whole filter in C must know: its sources, its structs and what each function is given."""
    f, live = filter_view(model, made, views), live_manifest(model, made, views)
    parts = ("covariance", "filter", "digest", *(["live"] if live else []))
    return {
        "sources": [f"{model.c_prefix}_{part}" for part in parts],
        "carried": f["carried"],
        "live": live,
        "ceiling": ceilings(model),
        "prediction": "non-zeros" if covariance_view(model, made)["sparse"] else "blocks",
        "propagate": {key: f["propagate"][key] for key in ("structs", "fields")}
        | ({"loops": model.loops} if f["total"] else {}),
        **{
            name: f[name] and {key: f[name][key] for key in ("structs", "fields", "written")}
            for name in ("strapdown", "correct")
        },
        "measurements": {
            m["name"]: {key: m[key] for key in ("m", "structs", "fields", "nonlinear")}
            | {"brings_z": m["z"] is None, "index": i}
            for i, m in enumerate(f["measurements"])
        },
    }


def order_of(model: Model, made: list[Unit]) -> dict[str, Any] | None:
    """Of an error state given by F: the power of F dt in Phi, what is left out, and what `discretize` costs."""
    if model.F is None:
        return None
    cost = covariance_view(model, made)["cost"] if has_filter(model) else None
    return {"Phi": model.order, "Q": model.order + 1, "left_out": left_out(model.order), "operations": cost}


def described(model: Model, made: list[Unit], views: list[dict[str, Any]]) -> dict[str, Any]:
    """Everything but the files and the versions."""

    def field(v: Variable) -> dict[str, Any]:
        return {
            "name": v.name, "size": v.size, "components": [s.name for s in v.symbols], "unit": v.unit, "frame": v.frame,
            "meaning": v.meaning, "low": v.low, "high": v.high, "norm": v.norm,
        }  # fmt: skip

    functions = {}
    for unit, u in zip(made, views, strict=True):
        functions[unit.name] = {
            "c_name": u["c_name"],
            "file": u["file"],
            "meaning": unit.meaning,
            "equations": unit.equations,
            "hash": u["hash"],
            "operations": u["operations"],
            "structs": u["reads"],
            "fields": [a.name for a in unit.args],
            "results": [
                {
                    "name": r.name, "shape": r.shape, "nonzeros": len(r.nonzeros), "unit": r.unit, "angle": r.angle,
                    "vector": r.shape[1] == 1 and r.name not in MATRICES,
                }
                for r in unit.results
            ],
        }  # fmt: skip
    return {
        "model": model.name,
        "title": model.title,
        "kind": model.kind,
        "order": order_of(model, made),
        "frame": model.frame,
        "c_prefix": model.c_prefix,
        "states": [s.name for s in model.x],
        "wraps": [s.name for v in model.states if v.wraps for s in v.symbols],
        "blocks": [field(v) for v in model.states],
        "structs": ({"x": [field(state_variable(model))]} if model.n else {})
        | {s.name: [field(v) for v in s.fields] for s in model.structs},
        "measurements": {
            m.name: {key: getattr(m, key) for key in ("rows", "unit", "meaning", "angle", "correlated", "equations")}
            | ({"low": m.low, "high": m.high} if m.low else {})
            for m in model.measurements
        },
        "units": functions,
        "filter": filter_manifest(model, made, views) if has_filter(model) else None,
    }  # fmt: skip
