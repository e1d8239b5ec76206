"""The C of an experiment's run with that of its model: as a library of the host, and as one text for NVRTC.

Nothing of the generated C is changed.  The text holds each header once and then each source in a namespace of its own,
in which its static functions meet no others of their name.
"""

import ctypes
import functools
import hashlib
import json
import re
from pathlib import Path

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.compiler import PRECISIONS, open_library, shared_library
from boresight.runtime.manifest import read_manifest

HERE = Path(__file__).parent
HEADERS = (HERE, HERE.parent / "simulation")
NUMBERS, RUNS = HERE.parent / "random.c", HERE / "runs.c"
OWN = (NUMBERS, RUNS)
INCLUDE = re.compile(r'^#include ([<"])([\w.]+)[>"].*\n', re.MULTILINE)
LEFT_OUT = ("_live.c", "_digest.c")  # the live loop does not fly on a GPU yet
# Functions stand once, out of line, on a GPU: all of them in one take its compiler minutes.  The strapdown, which flies
# most often, stands where it is called, but for its sines.
PROTOTYPE = re.compile(r"^(?:bs_\w+|void|size_t|int) (?!BS_|\w+_strapdown\()\w+\([^;{}]*\);", re.MULTILINE)
INSIDE = """#ifdef __CUDACC_RTC__
#undef BS_INSIDE
#define BS_INSIDE static __noinline__
static __noinline__ int bs_reduce_large(bs_real angle, bs_real *rest, bs_real *tail);
static __noinline__ void bs_sincos(bs_real angle, bs_real *sine, bs_real *cosine);
#endif
"""


def sources(folder: Path, *own: Path) -> list[Path]:
    """The C of the model, of random numbers, and these."""
    files = read_manifest(folder)["files"]
    model = [folder / name for name in files if re.fullmatch(r"src/.*\.c", name) and not name.endswith(LEFT_OUT)]
    return [*sorted(model), NUMBERS, *own]


def host(folder: Path, experiment: Path, precision: str = "double") -> ctypes.CDLL:
    """The library of the host that flies runs, as C99 and scalar."""
    return library(folder, RUNS, experiment, precision=precision)


@functools.cache
def library(folder: Path, *own: Path, precision: str = "double") -> ctypes.CDLL:
    """The C of a model, of random numbers and of these files, for the host.

    gcc 12 fuses a complex product in a loop, which its vectors add and subtract side by side, whatever -ffp-contract
    says.
    """
    places = dict.fromkeys((*HEADERS, *(file.parent for file in own)))
    read = NUMBERS, *own, *(header for place in places for header in sorted(place.glob("*.h")))
    contents = json.dumps(read_manifest(folder)["files"], sort_keys=True)
    contents += "".join(hashlib.sha256(file.read_bytes()).hexdigest() for file in read)
    flags = "-fno-tree-vectorize", *(flag for place in places for flag in ("-I", place))
    name = f"{folder.name}-{own[-1].stem}-{precision}"
    each = dict.fromkeys(sources(folder, *own), flags)
    return open_library(*shared_library(name, contents, each, folder / "include", PRECISIONS[precision]))


def fly(library: ctypes.CDLL, given: Array, seed: int, runs: range, columns: int) -> tuple[Array, Array]:
    """Final states (len(runs), columns) and statuses of neighbouring runs, by `host` or what else has its functions."""
    rows, status = np.empty((len(runs), columns)), np.empty(len(runs), np.uint8)
    integer, pointer = ctypes.c_uint64, ctypes.c_void_p
    numbers = (integer(number) for number in (seed, runs.start, len(runs), columns))
    ends = (pointer(array.ctypes.data) for array in (rows, status))
    library.boresight_runs(pointer(given.ctypes.data), *numbers, *ends)
    return rows, status


def device(folder: Path, experiment: Path, precision: str = "double") -> str:
    """The text: C++ for NVRTC, and for a C++ compiler of the host behind its own standard headers."""
    headers: dict[Path, str] = {}
    bodies = [(file, _expanded(file, folder, headers)) for file in sources(folder, RUNS, experiment)]
    parts = ["#define BORESIGHT_FLOAT\n" * (precision == "float"), "#ifdef __CUDACC_RTC__\n"]
    parts += [(HERE / "device.h").read_text(), "#endif\n"]
    for file, body in headers.items():
        parts += [body, INSIDE * (file.name == "boresight.h")]
    parts += ['#ifdef __CUDACC_RTC__\nextern "C" {\n']
    parts += [f"__noinline__ {prototype}\n" for body in headers.values() for prototype in PROTOTYPE.findall(body)]
    parts += ["}\n#endif\n"]
    for file, body in bodies:
        parts += [f'namespace of_{file.stem} {{\nextern "C" {{\n', body, "}\n}\n"]
    return "".join(parts)


def _expanded(file: Path, folder: Path, headers: dict[Path, str]) -> str:
    """A file without its includes; those that are no standard ones go into `headers`, each behind what it includes."""
    text = file.read_text()
    for mark, name in INCLUDE.findall(text):
        if mark == "<":
            continue
        found = [
            place / name
            for place in (*HEADERS, file.parent, folder / "include", folder / "src")
            if (place / name).is_file()
        ]
        if not found:
            raise BoresightError(f"{file} includes {name}, which is neither of {folder} nor of Boresight")
        if found[0] not in headers:
            body = _expanded(found[0], folder, headers)  # first what it includes
            headers[found[0]] = body
    return INCLUDE.sub("", text)
