"""The filter over blocks of runs, as its template sees it."""

from typing import Any

from boresight.codegen.functions.units import Unit
from boresight.derive.model import Model


def lanes_view(model: Model, made: list[Unit], f: dict[str, Any]) -> dict[str, Any]:
    """f: `text.filter.filter_view` of the model."""
    sizes = [a.size for s in model.structs if s.name in f["carried"] for a in s.fields]
    calls = {name: f[name] for name in ("strapdown", "propagate", "correct") if f[name]}
    return {"carried": max(1, sum(sizes)), "calls": calls}
