"""A model whose functions answer for every run, also for one that is beyond the model's range."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array


class Guard:
    """A model as `load` gives it.  A number beyond its box is taken at the box's edge, and its run is marked.

    So one run that is driven off ends no batch.  `taken` gives the marks since it was asked last; their runs' results
    are to be thrown away.
    """

    def __init__(self, model: Any, runs: tuple[int, ...]):
        self.model, self.runs = model, runs
        self.outside = np.zeros(runs, bool)
        self.why = ""

    def __getattr__(self, name: str) -> Any:
        if name == "model":  # not there yet, as in a copy that is being made
            raise AttributeError(name)
        part = getattr(self.model, name)
        return Guarded(part, self) if hasattr(part, "fields") else part

    def __dir__(self) -> list[str]:
        return dir(self.model)

    def taken(self) -> tuple[Array, str]:
        """(...,) bool runs that were beyond a box, and the first of them in words."""
        outside, why = self.outside, self.why
        self.outside, self.why = np.zeros(self.runs, bool), ""
        return outside, why

    def clipped(self, nav: Mapping[str, Array]) -> dict[str, Array]:
        """nav with each number that is beyond its box at the box's edge."""
        boxes = {name: self.model.field.get(name, {"low": -np.inf, "high": np.inf}) for name in nav}
        return {name: np.clip(value, boxes[name]["low"], boxes[name]["high"]).reshape(value.shape)
                for name, value in nav.items()}  # fmt: skip

    def mark(self, outside: Array, why: str) -> None:
        """outside: (..., *runs)."""
        extra = outside.ndim - len(self.runs)
        self.outside = self.outside | outside.any(tuple(range(extra))) if extra > 0 else self.outside | outside
        self.why = self.why or why


class Guarded:
    """One function of a guarded model."""

    def __init__(self, unit: Any, guard: Guard):
        self.unit, self.guard, self.fields = unit, guard, unit.fields

    def __call__(self, **fields: Any) -> Any:
        try:
            return self.unit(**fields)
        except BoresightError as error:
            inside = {name: self._within(name, value, str(error)) for name, value in fields.items()}
            return self.unit(**inside)

    def _within(self, name: str, value: Any, why: str) -> Array:
        value, box = np.asarray(value, float), self.guard.model.field[name]
        each = value if box["size"] > 1 or name == "x" else value[..., None]
        low, high = np.array(box["low"]), np.array(box["high"])
        within = (each >= low) & (each <= high)
        outside = ~within.all(-1)
        if box["norm"]:
            norm = np.linalg.norm(np.where(within, each, 0.0), axis=-1)
            turned = (norm < box["norm"][0]) | (norm > box["norm"][1])
            each = np.where((turned | outside)[..., None], np.eye(box["size"])[0], each)
            outside = outside | turned
        if outside.any():
            self.guard.mark(outside, why)
        kept = np.clip(np.where(np.isfinite(each), each, np.clip(0.0, low, high)), low, high)
        return kept if each is value or value.ndim == each.ndim else kept[..., 0]


def mixed(where: Array, ours: Mapping[str, Array], theirs: Mapping[str, Array]) -> dict[str, Array]:
    """Quantities of nav: ours of the runs (...,) in `where`, theirs of the others."""
    return {
        name: np.where(where.reshape(where.shape + (1,) * (value.ndim - where.ndim)), ours[name], value)
        for name, value in theirs.items()
    }


def outside(model: Any, nav: Mapping[str, Array], runs: tuple[int, ...] = ()) -> tuple[Array, str]:
    """(...,) bool, whether a quantity of nav is beyond its box or no number, and the first of them in words."""
    out, why = np.zeros(runs, bool), ""
    for name, value in nav.items():
        box = model.field.get(name)
        if box is None:
            continue
        each = value if box["size"] > 1 else value[..., None]
        off = ~((each >= np.array(box["low"])) & (each <= np.array(box["high"])))
        if off.any():
            at = tuple(np.argwhere(off)[0])
            axis = at[-1] if box["size"] > 1 else 0
            label = f"{name}[{axis}]" if box["size"] > 1 else name
            if name == "lat_lon_height":
                label = ("latitude", "longitude", "height")[axis]
            span = f"{box['low'][axis]:.6g} to {box['high'][axis]:.6g}"
            advice = "; give the known bias, known=Calibration(...)" if name.endswith("_bias") else ""
            why = why or f"{label} is {each[at]:.6g}, and the model's range is {span}{advice}"
            out = out | off.any(-1)
    return out, why
