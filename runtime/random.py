"""Random numbers that depend on a seed and on a run, and on nothing else: not on chunks, processes or machines.

They are counted: number k of a run is a fixed function of seed, run, stream and k.  The words are those of
`numpy.random.Philox`.  Each word gives two normal numbers by Box and Muller: its upper 40 bits are the radius, so that
none is beyond 7.54, its lower 24 the angle.  The logarithm, the sine and the cosine are C of our own, so that every
machine has equal bits.
"""

import ctypes
import functools
import hashlib
from pathlib import Path
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime import compiler
from boresight.runtime.array import Array
from boresight.runtime.compiler import in_lanes, open_library, shared_library
from boresight.runtime.manifest import folder_of

SOURCE = Path(__file__).with_name("random.c")
HEADERS = "azimuth-hold"  # a model whose folder holds the headers, which all share


@functools.cache
def library(lanes: int) -> ctypes.CDLL:
    folder = folder_of(HEADERS)
    files = (SOURCE, folder / "batch" / "boresight_lanes.h", *sorted((folder / "include").glob("boresight*.h")))
    contents = hashlib.sha256(b"\0".join(file.read_bytes() for file in files)).hexdigest()
    flags = (*in_lanes(lanes), "-I", folder / "batch")
    return open_library(*shared_library(f"random-lanes{lanes}", contents, {SOURCE: flags}, folder / "include"))


def words(seed: int, runs: Any, count: int, first: int = 0, stream: int = 0) -> Array:
    """(len(runs), count) uint64: those of `numpy.random.Philox(key=[seed, run], counter=[0, 0, 0, stream])` from
    number `first` on.  Arguments are those of `normals`."""
    return drawn("words", seed, runs, count, first, stream, None, np.uint64, 1)


def normals(
    seed: int,
    runs: Any,
    count: int,
    first: int = 0,
    stream: int = 0,
    out: Array | None = None,
    lanes: int | None = None,
    scale: Any = 1.0,
    offset: Any = 0.0,
) -> Array:
    """(len(runs), count) standard normal numbers, of each run from its number `first` on.

    seed, stream: whole numbers from 0 to 2^64 - 1; a stream is another sequence of the same run, of another sensor say.
    runs: the numbers of the runs, (n,) whole, of the same range.
    out: where they go, (n, count) float64 of any strides; by default a new array.
    lanes: how many are computed at a time, which changes no bit; by default as many as the processor has room for.
    scale, offset: (count,) for each number what it is multiplied by, and what is added then; by default nothing.
    """
    lanes = lanes or compiler.lanes()
    return drawn("normals", seed, runs, count, first, stream, out, np.float64, lanes, (scale, offset))


def drawn(name: str, seed: int, runs: Any, count: int, first: int, stream: int, out: Array | None, kind: type,
          lanes: int, linear: tuple[Any, ...] = ()) -> Array:  # fmt: skip
    for what, value in (("seed", seed), ("first", first), ("stream", stream), ("count", count)):
        if not (isinstance(value, int | np.integer) and 0 <= value < 2**64):
            raise BoresightError(f"{what} is {value!r}; give a whole number from 0 to 2^64 - 1")
    numbers = np.asarray(runs)
    if numbers.ndim != 1 or numbers.dtype.kind not in "iu" or (numbers.dtype.kind == "i" and (numbers < 0).any()):
        raise BoresightError(f"runs is {runs!r}; give the numbers of runs, whole and not below 0")
    numbers = np.ascontiguousarray(numbers, dtype=np.uint64)
    shape = (len(numbers), int(count))
    if out is None:
        out = np.empty(shape, kind)
    if out.shape != shape or out.dtype != kind or not out.flags.writeable or any(s % 8 for s in out.strides):
        raise BoresightError(f"out is {out.dtype} of shape {out.shape}; it must be float64 of shape {shape}")
    each = [np.ascontiguousarray(np.broadcast_to(part, shape[1:]), dtype=float) for part in linear]
    function = getattr(library(lanes), f"boresight_{name}")
    function.restype = None
    integer, pointer, size, step = ctypes.c_uint64, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_ssize_t
    function.argtypes = [integer, pointer, size, integer, integer, size, pointer, step, step,
                         *len(each) * (pointer,)]  # fmt: skip
    numbered = int(seed), numbers.ctypes.data, len(numbers), int(stream), int(first), int(count)
    strides = (stride // 8 for stride in out.strides)
    function(*numbered, out.ctypes.data, *strides, *(part.ctypes.data for part in each))
    return out
