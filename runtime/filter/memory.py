"""The nav, x and P of many runs, where the C of a filter has them; and what of them a caller has read or written.

`CompiledFilter`, `Epoch` and the slave's stretch of a transfer alignment share one such memory.
"""

import ctypes
import functools
from collections.abc import Callable, Iterator, MutableMapping
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.arguments import check_nav
from boresight.runtime.array import Array
from boresight.runtime.library import Library

ALIGNED = 64  # bytes: the widest block of numbers that C reads at once


class Taking(ctypes.Structure):
    """bs_taking of boresight_lanes.h."""

    _fields_ = [
        ("rows", ctypes.c_void_p), ("stride", ctypes.c_size_t), ("gates", ctypes.c_void_p),
        ("iterations", ctypes.c_void_p), ("options", ctypes.c_void_p), ("nu", ctypes.c_void_p), ("S", ctypes.c_void_p),
        ("nis", ctypes.c_void_p), ("used", ctypes.c_void_p),
    ]  # fmt: skip


class Blocks:
    """The state of n runs as the C has it: blocks of `width` runs, number after number, each of all runs of a block."""

    def __init__(self, n: int, numbers: int, width: int):
        self.n, self.width = n, width
        blocks = -(-n // width)
        room = np.zeros(blocks * numbers * width + ALIGNED // 8)
        start = -room.ctypes.data % ALIGNED // 8
        self.numbers = room[start : start + blocks * numbers * width].reshape(blocks, numbers, width)
        self.address = self.numbers.ctypes.data
        self._backup = np.empty_like(self.numbers)

    def read(self, part: slice) -> Array:
        """(n, size), a copy."""
        runs = self.numbers[:, part].transpose(0, 2, 1)
        return runs.reshape(-1, runs.shape[-1])[: self.n].copy()

    def write(self, part: slice, value: Array) -> None:
        """value: (n, size)."""
        if self.n % self.width:  # lanes beyond the last run are as that, so that nothing odd is computed there
            value = np.concatenate([value, np.repeat(value[-1:], -self.n % self.width, axis=0)])
        self.numbers[:, part] = value.reshape(len(self.numbers), self.width, -1).transpose(0, 2, 1)

    def keep(self, part: slice) -> None:
        """Remember what stands there for `give_back`."""
        np.copyto(self._backup[:, part], self.numbers[:, part])

    def give_back(self, part: slice) -> None:
        np.copyto(self.numbers[:, part], self._backup[:, part])


class Nav(MutableMapping[str, Array]):
    """`nav` of a CompiledFilter: what is read comes out of the C, and is looked at again by the next call."""

    def __init__(self, memory: "Memory"):
        self._memory = memory
        self._names: list[str] = []

    def __getitem__(self, name: str) -> Array:
        if name not in self._names:
            raise KeyError(name)
        return self._memory.lend(name)

    def seen(self, name: str) -> Array:
        """A field to be read alone, which the next call need not look at."""
        if name not in self._names:
            raise KeyError(name)
        value = self._memory.read(name).view()
        value.flags.writeable = False
        return value

    def __setitem__(self, name: str, value: Any) -> None:
        value = np.asarray(value, dtype=float)
        check_nav(self._memory.library, {name: value}, np.empty(0))
        if name not in self._names:
            self._names.append(name)
        self._memory.assign(name, value)

    def __delitem__(self, name: str) -> None:
        self._memory.lend(name)
        self._names.remove(name)
        self._memory.forget([name])

    def __contains__(self, name: object) -> bool:
        return name in self._names

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __or__(self, other: Any) -> dict[str, Array]:
        return {**self, **other}

    def __ror__(self, other: Any) -> dict[str, Array]:
        return {**other, **self}

    def __repr__(self) -> str:
        return repr(dict(self))


class Memory:
    """Where what stands of each run of a filter, and how the caller's arrays come to and from it.

    library: compiled in double, with `described`, the manifest's "filter".
    runs: the leading axes.  blocks: all runs in the C, once `settled`.
    part: the place of x, P, each field of nav that the C keeps (`fields`), and what the C counts, in a run.
    copies: as the caller sees them; what is not there, or in `lent`, is as in the C.
    lent: names of what the caller may have changed since the last call.
    """

    def __init__(self, library: Library, described: dict[str, Any]):
        self.library = library
        self.runs: tuple[int, ...] = ()
        self.copies: dict[str, Array] = {}
        self.lent: set[str] = set()
        self.settled = False
        self.blocks = Blocks(0, 0, 1)
        self.nav = Nav(self)
        n = len(library.states)
        self.part: dict[str, slice] = {}
        start = 0
        for struct in described["carried"]:
            for name, part in library.layout[struct].items():
                self.part[name] = slice(start + part.start, start + part.stop)
            start += library.width[struct]
        self.fields = tuple(self.part)
        start = max(1, start)
        sizes = {"x": n, "P": n * (n + 1) // 2, "counts": len(described["measurements"]) + 1, "considered": 1 + n}
        for name, size in sizes.items():
            self.part[name] = slice(start, start + size)
            start += size
        self.size = start
        self._upper, self._place = packed(n)
        self._diagonal = self.part["P"].start + self._place.diagonal()

    def variances(self) -> Array:
        """(..., n) the diagonal of P."""
        if "P" in self.lent or not self.settled:
            return np.diagonal(self.lend("P"), axis1=-2, axis2=-1).copy()
        variances = self.blocks.numbers[:, self._diagonal].transpose(0, 2, 1)  # (blocks, width, n)
        return variances.reshape(-1, variances.shape[-1])[: self.blocks.n].reshape(*self.runs, -1)

    def lend(self, name: str) -> Array:
        """x, P or a field of nav, for a caller who may change it."""
        self.lent.add(name)
        return self.read(name)

    def assign(self, name: str, value: Array) -> None:
        """x, P or a field of nav is this array of the caller's from now on."""
        self.copies[name] = value
        self.lent.add(name)

    def forget(self, names: Any) -> None:
        """The values of these names stand in the C alone."""
        if not self.copies.keys().isdisjoint(names):
            for name in names:
                if self.copies.pop(name, None) is not None:
                    self.lent.discard(name)

    def read(self, name: str) -> Array:
        """x, P or a field of nav."""
        if name not in self.copies:
            value = self.blocks.read(self.part[name]).reshape(*self.runs, -1)
            if name == "P":
                value = value[..., self._place]
            elif name != "x" and self.library.field[name]["size"] == 1:
                value = value[..., 0]
            self.copies[name] = value
        return self.copies[name]

    def broadcast(self) -> tuple[int, ...]:
        """The runs of x, P and nav together, as the caller sees them."""
        held = {name: value.shape[: -self.axes(name) or None] for name, value in self.copies.items()
                if name in self.part}  # fmt: skip
        try:
            return np.broadcast_shapes(self.runs, *held.values())
        except ValueError:
            listed = ", ".join(f"{name} {runs}" for name, runs in held.items())
            raise BoresightError(f"the runs of a filter do not go together: {listed}, before {self.runs}") from None

    def settle(self, runs: tuple[int, ...]) -> Blocks:
        """The blocks of so many runs, with all that the caller has changed."""
        if not self.settled or self.runs != runs:
            for name in (*self.fields, "x", "P"):
                if self.settled or name in self.copies:
                    self.lend(name)
            width, self.dll = self.library.lanes(int(np.prod(runs, dtype=int)))
            self.blocks, self.runs = Blocks(int(np.prod(runs, dtype=int)), self.size, width), runs
            self.settled = True
            for name in self.fields:
                if name not in self.copies:  # it stands in no function that is called
                    self.write(name, inside(self.library.field[name]))
        for name in self.lent:
            if name in self.part:
                self.write(name, self.copies[name])
        self.lent.clear()
        return self.blocks

    def write(self, name: str, value: Array) -> None:
        """A value of `part` into the C, (..., size) as the caller sees it, with leading axes of the runs or none."""
        if name == "P":
            value = value[(..., *self._upper)]
        part = self.part[name]
        size = part.stop - part.start
        if name in self.fields and size == 1:
            value = value[..., None]
        self.blocks.write(part, np.broadcast_to(value, (*self.runs, size)).reshape(-1, size))

    def axes(self, name: str) -> int:
        """How many axes of a value are none of runs."""
        return 2 if name == "P" else 1 if name == "x" or self.library.field[name]["size"] > 1 else 0

    def bind(self, name: str, *asked: Any) -> Callable[[], int]:
        """The C function PREFIX_lanes_NAME for the runs as they are settled; a call of it converts no argument.

        asked: its parameters after the state, made by `byref` or `from_param`.
        """
        function = getattr(self.dll, f"{self.library.manifest['c_prefix']}_lanes_{name}")
        function.restype = ctypes.c_size_t
        n, address = ctypes.c_size_t.from_param(self.blocks.n), ctypes.c_void_p.from_param(self.blocks.address)
        return functools.partial(function, n, address, *asked)

    def changed(self, name: str) -> slice:
        """What of a run a function changes."""
        carried = slice(0, self.part["x"].start)
        if name == "strapdown":
            return carried
        return slice(0 if name == "correct" else carried.stop, self.part["counts"].stop)

    def column(self, name: str) -> Array:
        """A carried field as `Library.arrange` makes it."""
        return self.blocks.read(self.part[name]).reshape(*self.runs, -1)

    def consider(self, considered: Array | None, disabled: Array | None) -> None:
        """Tell the C which states (..., n) bool no measurement corrects, and which (n,) take no part."""
        part = self.part["considered"]
        if considered is None and disabled is None:
            if self.blocks.numbers[:, part.start].any():
                self.blocks.numbers[:, part] = 0.0
            return
        bits = np.zeros(part.stop - part.start - 1, dtype=np.uint8)
        for bit, states in ((1, considered), (2, disabled)):
            bits = bits if states is None else bits | bit * np.asarray(states, dtype=np.uint8)
        self.write(
            "considered", np.concatenate([np.bitwise_or.reduce(bits, -1, keepdims=True), bits], -1).astype(float)
        )


@functools.cache
def packed(n: int) -> tuple[tuple[Array, Array], Array]:
    """Rows and columns of a packed symmetric matrix, and (n, n) the place of each element in it."""
    columns, rows = np.tril_indices(n)  # column after column of the upper triangle
    place = np.zeros((n, n), dtype=int)
    place[rows, columns] = place[columns, rows] = np.arange(len(rows))
    return (rows, columns), place


def inside(field: dict[str, Any]) -> Array:
    """A value of a field that the filter carries and nobody has given: it stands in no function that is called."""
    low, high = np.array(field["low"]), np.array(field["high"])
    value = np.where((low <= 0) & (high >= 0), 0.0, (low + high) / 2)
    if field["norm"]:
        value[0] = sum(field["norm"]) / 2
    return value if field["size"] > 1 else value[0]
