"""The slave over many intervals that are as they should be, in the C of the generated filter."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.filter import CompiledFilter, Epoch
from boresight.runtime.library import Library


class Stretch:
    """Strapdown and prediction of all runs side by side, a call for each interval."""

    def __init__(self, model: Library, nav: Mapping[str, Array], P: Array, constants: Mapping[str, Any]):
        self.runs, self.constants = P.shape[:-2], constants
        self.loop = CompiledFilter(model, dict(nav), P)
        self._step = Epoch(self.loop, 1, predict=False, feedback=False, runs=self.runs, shared=("dt",))
        self._parts = {name: self.loop.memory.part[name] for name in self.loop.described["strapdown"]["written"]}
        self._changed = slice(min(p.start for p in self._parts.values()), max(p.stop for p in self._parts.values()))

    @staticmethod
    def of(model: Any, nav: Mapping[str, Array], P: Array, constants: Mapping[str, Any]) -> "Stretch | None":
        """None where the model has no filter in C that carries P in double."""
        described = isinstance(model, Library) and model.precision == "double" and model.manifest.get("filter")
        return Stretch(model, nav, P, constants) if described else None

    def begin(self, nav: Mapping[str, Array], P: Array, increments: Array, dt: Array) -> None:
        """From nav and P on.  increments: (1 + K, ..., 6) rad and m/s, first that of the interval before.  dt: (K,)."""
        loop = self.loop
        for name in loop.memory.fields:
            if name in nav or name in self.constants:
                loop.nav[name] = nav[name] if name in nav else self.constants[name]
        loop.memory.assign("P", P)  # of a filter, which is symmetric
        now, before = increments[1:], increments[:-1]
        given = {**self.constants, "dtheta_ib_b": now[..., :3], "dv_b": now[..., 3:], "dt": dt,
                 "dtheta_before": before[..., :3], "dv_before": before[..., 3:]}  # fmt: skip
        described, library = loop.described["strapdown"], loop.memory.library
        self._packed = []
        for struct, one in zip(described["structs"], self._step.strapdown.given, strict=True):
            packed = np.zeros((len(dt), *(self.runs if one.stride else ()), library.width[struct]))
            for name, part in library.layout[struct].items():
                if name in described["fields"]:
                    packed[..., part if library.field[name]["size"] > 1 else part.start] = given[name]
            self._packed.append((one, packed, packed.ctypes.data, packed.strides[0]))

    def fly(self, begin: int, end: int) -> dict[str, Array]:
        """Over the intervals [begin, end): what the strapdown writes, (end - begin, ..., size) each.

        Nothing, and all is as it was, where an interval is refused.
        """
        blocks, part = self.loop.memory.settle(self.runs), self._changed
        was = blocks.numbers[:, part].copy()
        trail = np.empty((end - begin, *was.shape))
        for k in range(begin, end):
            for one, _, address, size in self._packed:
                one.at = address + k * size
            if self._step():
                blocks.numbers[:, part] = was
                return {}
            trail[k - begin] = blocks.numbers[:, part]
        each = np.moveaxis(trail, -1, -2).reshape(end - begin, -1, was.shape[1])[:, : blocks.n]
        return {name: each[..., at.start - part.start : at.stop - part.start].reshape(end - begin, *self.runs, -1)
                for name, at in self._parts.items()}  # fmt: skip

    def predict(self, **inputs: Any) -> bool:
        """False, and all is as it was, where a run is refused."""
        try:
            self.loop.predict(**inputs)
        except BoresightError:
            return False
        return True
