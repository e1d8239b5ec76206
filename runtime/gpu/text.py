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
OWN = (HERE.parent / "random.c", HERE / "runs.c")
INCLUDE = re.compile(r'^#include ([<"])([\w.]+)[>"].*\n', re.MULTILINE)
LEFT_OUT = ("_live.c", "_digest.c")  # the live loop does not fly on a GPU yet
# Functions stand once, out of line, on a GPU: all of them in one take its compiler minutes.
PROTOTYPE = re.compile(r"^(?:bs_\w+|void|size_t|int) \w+\([^;{}]*\);", re.MULTILINE)
INSIDE = "#ifdef __CUDACC_RTC__\n#undef BS_INSIDE\n#define BS_INSIDE static __noinline__\n#endif\n"


def sources(folder: Path, experiment: Path) -> list[Path]:
    """The C of the model, of random numbers, and of the experiment."""
    files = read_manifest(folder)["files"]
    model = [folder / name for name in files if re.fullmatch(r"src/.*\.c", name) and not name.endswith(LEFT_OUT)]
    return [*sorted(model), *OWN, experiment]


@functools.cache
def host(folder: Path, experiment: Path, precision: str = "double") -> ctypes.CDLL:
    """The library of the host, as C99 and scalar."""
    own = *OWN, experiment, *sorted(HERE.glob("*.h"))
    contents = json.dumps(read_manifest(folder)["files"], sort_keys=True)
    contents += "".join(hashlib.sha256(file.read_bytes()).hexdigest() for file in own)
    each = dict.fromkeys(sources(folder, experiment), ("-I", HERE))
    name = f"{folder.name}-{experiment.stem}-{precision}"
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
    bodies = [(file, _expanded(file, folder, headers)) for file in sources(folder, experiment)]
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
        found = [place / name for place in (HERE, folder / "include", folder / "src") if (place / name).is_file()]
        if not found:
            raise BoresightError(f"{file} includes {name}, which is neither of {folder} nor of Boresight")
        if found[0] not in headers:
            body = _expanded(found[0], folder, headers)  # first what it includes
            headers[found[0]] = body
    return INCLUDE.sub("", text)
