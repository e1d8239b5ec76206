"""The generated C of a model, compiled once and called from Python.

`load` takes a built-in model's name or the folder of a generated one, compiles its C on first use into a cache, and
refuses a library that is not that of the files on disk.
"""

import ctypes
import functools
import json
import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime import compiler
from boresight.runtime.arguments import whole
from boresight.runtime.compiler import PRECISIONS, in_lanes, open_library, shared_library
from boresight.runtime.manifest import built_in, folder_of, read_manifest
from boresight.runtime.status import Status

BACKENDS = ("flight", "casadi")
WIDTHS = (1, 2, 4, 8)  # runs that the C of many runs computes at a time
MANY = 64  # runs from which on a function is worth its C of many runs, which has to be compiled first


class Given(ctypes.Structure):
    """bs_given of boresight_lanes.h."""

    _fields_ = [("at", ctypes.c_void_p), ("stride", ctypes.c_size_t), ("step", ctypes.c_ssize_t)]


def build(
    folder: Path, manifest: dict[str, Any], backend: str = "flight", precision: str = "double"
) -> tuple[Path, str]:
    """The compiled library of a generated folder, as `compiler.shared_library`."""
    sources: dict[Path, list[object]] = {folder / path: [] for path in manifest["files"] if path.endswith("_batch.c")}
    for stem in (unit["file"] for unit in manifest["units"].values()):
        # CasADi's kernel has the include guard of ours: seen first, it is the one that the wrapper calls
        instead = ["-include", folder / "casadi" / f"{stem}_kernel.h"] if backend == "casadi" else []
        sources[folder / "src" / f"{stem}.c"] = instead
        if backend == "casadi":
            sources[folder / "casadi" / f"{stem}_casadi.c"] = ["-Wno-unused-parameter"]
    others = (folder / path for path in manifest["files"] if path.startswith("src/") and path.endswith(".c"))
    sources |= {path: [] for path in others if path not in sources}
    name, contents = f"{folder.name}-{backend}-{precision}", json.dumps(manifest["files"], sort_keys=True)
    return shared_library(name, contents, sources, folder / "include", PRECISIONS[precision])


def build_lanes(folder: Path, manifest: dict[str, Any], width: int) -> tuple[Path, str]:
    """The compiled library of a generated folder's functions and filter over blocks of `width` runs."""
    sources: dict[Path, tuple[str, ...]]
    sources = {folder / path: () for path in manifest["files"] if path.startswith("src/") and path.endswith(".c")}
    sources |= {folder / path: in_lanes(width) for path in manifest["files"] if path.endswith("_lanes.c")}
    contents = json.dumps(manifest["files"], sort_keys=True)
    return shared_library(f"{folder.name}-lanes{width}", contents, sources, folder / "include")


class Unit:
    """One generated function.

    Called with its fields as keywords, each (..., size), or (...) if it has one component; the leading axes are runs
    and broadcast.  Returns the output, (..., rows) or (..., rows, columns), or a dict of them if there are several; an
    output that has the name of a field has the shape of that field.
    Raises BoresightError on an input that is not finite or outside its box.
    """

    def __init__(self, library: "Library", name: str, described: dict[str, Any]):
        self.name = name
        self.described = described
        self.fields: tuple[str, ...] = tuple(described["fields"])
        self.structs: tuple[str, ...] = tuple(described["structs"])
        self.library = library
        dll = library.dll
        self._one = getattr(dll, described["c_name"] + "_bound")
        self._one.restype = ctypes.c_int
        self._many = getattr(dll, described["c_name"] + "_batch")
        self._many.restype = ctypes.c_size_t
        self._in_lanes: dict[int, Any] = {}  # width -> the function of so many runs at a time
        pointers = len(described["results"]) + 1
        self._many.argtypes = [ctypes.c_size_t, *len(self.structs) * (ctypes.c_void_p, ctypes.c_size_t),
                               *pointers * (ctypes.c_void_p,)]  # fmt: skip

    def __call__(self, **fields: Any) -> Any:
        library = self.library
        if set(fields) != set(self.fields):
            raise BoresightError(
                f"{self.name} takes {', '.join(self.fields)}; it was given {', '.join(fields) or 'nothing'}"
            )
        given, runs = library.arrange(self.name, fields)
        outputs = self.outputs(math.prod(runs))
        failed, status = self.evaluate(given, runs, outputs)
        if failed:
            library.explain(self.name, given, runs, status.reshape(runs))
        shaped = {}
        for r, output in zip(self.described["results"], outputs, strict=True):
            rows, columns = r["shape"]
            shape = (*runs, rows) if r["vector"] else (*runs, rows, columns)
            if shape == (*runs, 1) and r["name"] in library.field:
                shape = runs  # a scalar that goes out as it came in
            shaped[r["name"]] = output.reshape(shape)
        return shaped if len(shaped) > 1 else next(iter(shaped.values()))

    def outputs(self, n: int) -> list[np.ndarray]:
        """Room for the outputs of n runs, each (n, rows * columns)."""
        real = self.library.real
        return [np.empty((n, r["shape"][0] * r["shape"][1]), real) for r in self.described["results"]]

    def evaluate(
        self, given: dict[str, np.ndarray], runs: tuple[int, ...], outputs: list[np.ndarray]
    ) -> tuple[int, np.ndarray]:
        """Write `outputs` as the C does, and return how many runs it refused and the status of each, (n,).

        given, runs: of `Library.arrange`.  A run that is refused leaves its outputs as they were; nothing is raised.
        """
        n, library = len(outputs[0]), self.library
        status = np.empty(n, dtype=np.uint8)
        ends = [out.ctypes.data for out in (*outputs, status)]
        if n < MANY or library.widest == 1:
            kept = library.pack(self.structs, given, runs)
            inputs = [word for packed, stride in kept for word in (packed.ctypes.data, stride)]
            return self._many(n, *inputs, *ends), status
        each = [given[name] for name in self.fields]
        for i, array in enumerate(each):
            if array.ndim > 1 and array.shape[:-1] != runs:
                array = np.broadcast_to(array, (*runs, array.shape[-1]))
            if not (array.flags.c_contiguous and array.flags.aligned):
                array = np.require(array, requirements=("C", "A"))
            each[i] = array
        fields = [Given(array.ctypes.data, array.shape[-1] * (array.ndim > 1), 0) for array in each]
        out = (ctypes.c_void_p * len(outputs))(*ends[:-1])
        return self._lanes(n)(n, (Given * len(fields))(*fields), out, ends[-1]), status

    def walk(self, given: dict[str, np.ndarray], outputs: dict[str, np.ndarray]) -> int:
        """Call it K times, from inputs (K, ..., size), or (size,) of all, into outputs (K, ..., size).

        Inputs and outputs are read and written where they lie, so that a call can read what the one before has written:
        they must be in double and contiguous, and have all these axes.  Returns how many calls were made before one
        that refused a run.  Raises BoresightError on an array that is not so.
        """
        sources = [given[name] for name in self.fields]
        results = [outputs[r["name"]] for r in self.described["results"]]
        count, *runs = results[0].shape[:-1]
        for name, array in zip(self.fields, sources, strict=True):
            size = self.library.field[name]["size"]
            fits = array.shape == (size,) or (array.shape[1:] == (*runs, size) and len(array) >= count)
            self._readable(name, array, fits, (count, *runs, size))
        for r, array in zip(self.described["results"], results, strict=True):
            shape = (count, *runs, math.prod(r["shape"]))
            self._readable(r["name"], array, array.shape == shape, shape)
        n = math.prod(runs)
        if self.library.widest == 1:
            made = self.outputs(n)
            for k in range(count):
                if self.evaluate({name: a[k] if a.ndim > 1 else a for name, a in given.items()}, tuple(runs), made)[0]:
                    return k
                for result, out in zip(results, made, strict=True):
                    result[k] = out.reshape(result[k].shape)
            return count
        at = np.array([(a.ctypes.data, a.shape[-1] * (a.ndim > 1), 0) for a in sources], np.uintp)
        ends = np.array([out.ctypes.data for out in results], np.uintp)
        # not the stride of an array, which may be anything along an axis of one
        steps = [np.array([a.itemsize * math.prod(a.shape[1:]) * (a.ndim > 1) for a in each], np.uintp)
                 for each in (sources, results)]  # fmt: skip
        status, function = np.empty(n, np.uint8), self._lanes(MANY)
        call = functools.partial(function, n, at.ctypes.data, ends.ctypes.data, status.ctypes.data)
        for k in range(count):
            if call():
                return k
            at[:, 0] += steps[0]
            ends += steps[1]
        return count

    def _readable(self, name: str, array: np.ndarray, fits: bool, shape: tuple[int, ...]) -> None:
        """Raise BoresightError unless the C may go through this array: beyond its end is what is not ours."""
        if not (fits and array.dtype == np.float64 and array.flags.c_contiguous):
            raise BoresightError(
                f"{self.name}: {name} has shape {array.shape}, {array.dtype}; it must be {shape}, contiguous, in double"
            )

    def _lanes(self, n: int) -> Callable[..., int]:
        """Its C of so many runs."""
        width, dll = self.library.lanes(n)
        if width not in self._in_lanes:
            function = self._in_lanes[width] = getattr(dll, self.described["c_name"] + "_lanes")
            function.argtypes, function.restype = [ctypes.c_size_t, *3 * (ctypes.c_void_p,)], ctypes.c_size_t
        return self._in_lanes[width]

    def bind(self) -> "Bound":
        """The function for one run, bound to its own arrays: for loops where a microsecond counts."""
        return Bound(self)

    def __repr__(self) -> str:
        return f"<{self.described['c_name']}({', '.join(self.fields)})>"


class Bound:
    """A function with its pointers taken once.  Write `inputs`, call, read `outputs`.

    inputs: field -> (size,) view.  outputs: name -> (rows,) or (rows, columns).  The call returns the number of a
    `Status`.  The caller must look at it: with 0 all is well, and what is refused leaves the outputs as they were.
    """

    def __init__(self, unit: Unit):
        library = unit.library
        self._arrays = {struct: np.zeros(library.width[struct], library.real) for struct in unit.structs}
        self.inputs = {
            name: self._arrays[struct][part]
            for struct in unit.structs
            for name, part in library.layout[struct].items()
            if name in unit.fields
        }
        self.outputs = {
            r["name"]: np.zeros(r["shape"][:1] if r["vector"] else r["shape"], library.real)
            for r in unit.described["results"]
        }
        addresses = [array.ctypes.data for array in (*self._arrays.values(), *self.outputs.values())]
        self._pointers = (ctypes.c_void_p * len(addresses))(*addresses)
        self.call: Callable[[], int] = functools.partial(unit._one, ctypes.byref(self._pointers))

    def __call__(self) -> int:
        return self.call()


class NoFunction(BoresightError, AttributeError):
    """A name that the model has no function of."""


class Library:
    """The functions of one model as attributes; `load` makes it.

    Each takes its fields as keywords, (..., size), or (...,) if it has one component, in the
    model's units and frames; the leading axes are runs and broadcast.  It returns its output, (...,
    rows) or (..., rows, columns), or a dict of them if there are several.

    Parameters
    ----------
    manifest : dict
        What was generated: structs, units, boxes, and the hash of each file.
    dll : ctypes.CDLL
        The compiled library.
    precision : {"double", "float"}, optional
    folder : Path, optional
        Where it was generated.
    widest : int, optional
        How many runs its C computes at a time, where there are several.

    Attributes
    ----------
    name : str
    states : tuple of str
        Names of the state's components.
    wraps : list of int
        The places of those that are kept in [-pi, pi).
    measurements : dict
        By name, its `rows`, those of them that are an `angle` (True for all), and whether they are
        `correlated`.
    ceiling : (n,) array or None
        The largest variance that a filter of it lets each state have.
    field : dict
        By input, its size, unit, frame, meaning and box.
    units : dict of str to function
        All functions by name; `.fields` of one are its keywords.
    real : type
        The NumPy type of the precision, in which the numbers go to the C and come back.

    Raises
    ------
    BoresightError
        By a function: an input that is unknown, missing, not finite or outside its box, with the
        field, component and run; and for a name that is no function.

    Notes
    -----
    When not to use it: to make a Library from files of one's own; `load` checks that they are those
    that were generated.

    Examples
    --------
    >>> from boresight import load
    >>> library = load("euler-matching")
    >>> library.states[:3], library.units["F"].fields
    (('eps_n', 'eps_e', 'eps_d'), ('omega_in_n',))
    >>> library.F(omega_in_n=[[0, 0, 7e-5], [0, 0, 0]]).shape
    (2, 6, 6)
    """

    def __init__(
        self,
        manifest: dict[str, Any],
        dll: ctypes.CDLL,
        precision: str = "double",
        folder: Path | None = None,
        widest: int = 1,
    ):
        self.manifest, self.dll, self.precision = manifest, dll, precision
        self.folder, self.widest = folder, widest
        self._lanes: dict[int, ctypes.CDLL] = {}
        self.real: type[np.floating] = np.float32 if precision == "float" else np.float64
        self.name: str = manifest["model"]
        self.states: tuple[str, ...] = tuple(manifest["states"])
        self.wraps = [self.states.index(name) for name in manifest.get("wraps", ())]
        self.measurements: dict[str, dict[str, Any]] = manifest["measurements"]
        ceiling = (manifest.get("filter") or {}).get("ceiling")
        self.ceiling: np.ndarray | None = None if ceiling is None else np.array(ceiling)
        self.field: dict[str, dict[str, Any]] = {}
        self.layout: dict[str, dict[str, slice]] = {}
        self.width: dict[str, int] = {}
        for struct, fields in manifest["structs"].items():
            start = 0
            self.layout[struct] = {}
            for field in fields:
                self.field[field["name"]] = field
                self.layout[struct][field["name"]] = slice(start, start + field["size"])
                start += field["size"]
            self.width[struct] = start
        self.units = {name: Unit(self, name, described) for name, described in manifest["units"].items()}

    def arrange(self, function: str, fields: dict[str, Any]) -> tuple[dict[str, np.ndarray], tuple[int, ...]]:
        """The fields of a function as arrays, and the shape of their runs.

        Parameters
        ----------
        function : str
            Its name, for messages.
        fields : dict of str to array
            By name, (..., size), or (...,) if it has one component.

        Returns
        -------
        given : dict of str to (..., size) array
            A scalar as (..., 1).
        runs : tuple of int
            What the leading axes broadcast to.

        Raises
        ------
        BoresightError
            A shape that does not fit the field, or runs that do not go together.
        """
        given = {}
        for name, value in fields.items():
            size = self.field[name]["size"]
            vector = size > 1 or name == "x"  # the state is one even where it has one component
            array = np.asarray(value, dtype=float)
            if vector and (array.ndim == 0 or array.shape[-1] != size):
                raise BoresightError(f"{function}: {name} has shape {array.shape}; its last axis must be {size} long")
            given[name] = array if vector else array[..., None]
        try:
            shapes = {array.shape[:-1] for array in given.values()} - {()}
            return given, shapes.pop() if len(shapes) == 1 else np.broadcast_shapes(*shapes)
        except ValueError:
            listed = ", ".join(f"{name} {np.shape(value)}" for name, value in fields.items())
            raise BoresightError(f"{function}: these shapes do not go together: {listed}") from None

    def pack(
        self, structs: Sequence[str], given: dict[str, np.ndarray], runs: tuple[int, ...]
    ) -> list[tuple[np.ndarray, int]]:
        """Each struct filled from its fields, for each run or once for all.

        Parameters
        ----------
        structs : sequence of str
            Names of the structs.
        given : dict of str to (..., size) array
            Of `arrange`.
        runs : tuple of int
            Of `arrange`.

        Returns
        -------
        list of (array, int)
            The numbers of each struct, and its stride in structs: 0 where it is shared by all runs.
        """
        packed = []
        for struct in structs:
            used = [(name, part) for name, part in self.layout[struct].items() if name in given]
            shared = all(given[name].ndim == 1 for name, _ in used)
            array = np.zeros((() if shared else runs) + (self.width[struct],), self.real)
            for name, part in used:
                array[..., part] = given[name]
            # x is a plain array, whose stride counts numbers; a struct's counts structs
            packed.append((array, 0 if shared else self.width[struct] if struct == "x" else 1))
        return packed

    def lanes(self, runs: int) -> tuple[int, ctypes.CDLL]:
        """The C that computes several runs at a time, compiled when it is first needed.

        Parameters
        ----------
        runs : int
            How many there are.

        Returns
        -------
        width : int
            How many are computed at a time.
        dll : ctypes.CDLL
            The compiled library.
        """
        # a block of one run is as dear as one of two: compilers make nothing of vectors of one number
        width = min(self.widest, next((w for w in WIDTHS[1:] if w >= runs), WIDTHS[-1]))
        if width not in self._lanes:
            assert self.folder is not None
            self._lanes[width] = open_library(*build_lanes(self.folder, self.manifest, width))
        return width, self._lanes[width]

    def explain(self, function: str, given: dict[str, np.ndarray], runs: tuple[int, ...], status: np.ndarray) -> None:
        """Raise the error of the first run that the C refused.

        Parameters
        ----------
        function : str
            Its name.
        given : dict of str to (..., size) array
            Of `arrange`.
        runs : tuple of int
            Of `arrange`.
        status : (...,) array
            What the C returned for each run; at least one is not 0.

        Raises
        ------
        BoresightError
            Always: it names the field, component and run.
        """
        where = tuple(int(i) for i in np.argwhere(status != 0)[0])
        at = f" of run {where[0] if len(where) == 1 else where}" if where else ""
        for name, array in given.items():
            value = np.broadcast_to(array, (*runs, array.shape[-1]))[where]
            box = self.field[name]
            for i, v in enumerate(value):
                label = f"{name}[{i}]" if len(value) > 1 else name
                if not np.isfinite(v):
                    raise BoresightError(f"{function}: {label}{at} is {v}; give a finite number")
                if not self.real(box["low"][i]) <= self.real(v) <= self.real(box["high"][i]):
                    unit = box["unit"] if "," not in box["unit"] else ""  # a vector of several units names none
                    raise BoresightError(
                        f"{function}: {label}{at} is {v:.6g} {unit}".rstrip()
                        + f"; it must lie within {box['low'][i]:.6g} to {box['high'][i]:.6g}"
                    )
            if box["norm"] and not box["norm"][0] <= np.linalg.norm(value) <= box["norm"][1]:
                raise BoresightError(
                    f"{function}: {name}{at} has the norm {np.linalg.norm(value):.6g}; it must lie within "
                    f"{box['norm'][0]:.6g} to {box['norm'][1]:.6g}"
                )
        raise BoresightError(
            f"{function}: what it gives{at} leaves its box or is no number: BS_{Status(int(status[where])).name}"
        )

    def __getattr__(self, name: str) -> Unit:
        units = self.__dict__.get("units", {})
        if name in units:
            return units[name]
        if name.startswith("__") or not units:
            raise AttributeError(name)
        raise NoFunction(f"{self.name} has no function {name!r}; it has {', '.join(units)}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.units]

    def __repr__(self) -> str:
        states = f"states {', '.join(self.states)}; " if self.states else ""
        return f"<{self.name}, {self.precision}: {states}functions {', '.join(self.units)}>"


def load(model: str | Path, backend: str = "flight", precision: str = "double", lanes: int | None = None) -> Library:
    """The functions of a model, from its generated C, which is compiled once and kept.

    Parameters
    ----------
    model : str or Path
        A built-in model's name, as `boresight models` lists them, or the folder that `generate`
        wrote.
    backend : {"flight", "casadi"}, optional
        Our C, or CasADi's own of the same model: both have the same functions and give the same
        bits.
    precision : {"double", "float"}, optional
        Of the numbers in the C.  CasADi's C knows double alone.
    lanes : {1, 2, 4, 8}, optional
        How many runs the flight C in double computes at a time, which changes no bit of them; by
        default as many as the processor has room for, and fewer where there are fewer runs.  With 1
        a function of many runs is the exported C itself.

    Returns
    -------
    Library

    Raises
    ------
    BoresightError
        An unknown model, a file that was edited, no C compiler, a choice that does not exist or
        that the backend or precision would ignore.

    Notes
    -----
    When not to use it: to fly on a target; `export` writes C that needs nothing of Python.  A
    Python caller of one function at a time pays some microseconds for each call; `CompiledFilter`
    and `Epoch` make one call of many.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import load
    >>> library = load("euler-matching")
    >>> library
    <euler-matching, double: states eps_n, ... functions F, Phi, Q, ...>
    >>> print(library.euler_angles(q_b2n_wxyz=[1, 0, 0, 0]))
    [0. 0. 0.]
    """
    for what, given, known in (("backend", backend, BACKENDS), ("precision", precision, tuple(PRECISIONS))):
        if given not in known:
            raise BoresightError(f"no {what} {given!r}; there are {', '.join(known)}")
    if lanes is not None and (not whole(lanes) or lanes not in WIDTHS):
        raise BoresightError(f"no {lanes!r} lanes; there are {', '.join(map(str, WIDTHS))}")
    if lanes is not None and lanes > 1 and (backend, precision) != ("flight", "double"):
        raise BoresightError(f"several lanes are of the flight C in double; leave lanes={lanes} out")
    if backend == "casadi" and precision == "float":
        raise BoresightError("CasADi's C computes in double; take the backend 'flight' for float")
    folder = folder_of(model)
    manifest = read_manifest(folder)
    if "component" in manifest:
        raise BoresightError(f"{manifest['model']} comes from no model; models are {', '.join(built_in())}")
    dll = open_library(*build(folder, manifest, backend, precision))
    widest = lanes or compiler.lanes()
    return Library(manifest, dll, precision, folder, widest if (backend, precision) == ("flight", "double") else 1)
