"""The filter in C by its own header, with the methods of `boresight.Filter`, in any precision and form."""

import ctypes
import functools
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from boresight import BoresightError
from boresight.runtime.filter import Innovation
from boresight.runtime.library import load
from boresight.runtime.status import Status

FORMS = {
    "joseph": (np.float64, "", ()),
    "ud": (np.float64, "_ud", ("-DBORESIGHT_UD=1",)),
    "float": (np.float32, "_f32", ("-DBORESIGHT_FLOAT",)),
}
PROBE = """
#include "{snake}_filter.h"
int place(int k);
int place(int k)
{{
    return (int)((k == 0) ? sizeof({p}_filter) : (k == 1) ? offsetof({p}_filter, x) : offsetof({p}_filter, P));
}}
"""


class Flown:
    """One run.  form: of FORMS."""

    def __init__(self, folder, form, nav, P, x=None):
        self.real, self.ending, _ = FORMS[form]
        self.library, self.dll = load(folder), compiled(folder, form)
        self.prefix, self.described = self.library.manifest["c_prefix"], self.library.manifest["filter"]
        size, x_at, P_at = (self.dll.place(k) // (1 if k == 0 else self.real().itemsize) for k in range(3))
        self.memory = np.zeros(size, np.uint8)
        numbers, self.n = self.memory.view(self.real), P_at - x_at
        self.carried, self.x = numbers[:x_at], numbers[x_at:P_at]
        self.packed = numbers[P_at : P_at + self.n * (self.n + 1) // 2]
        self.state = self.memory[: self.real().itemsize * (P_at + self.n * (self.n + 1) // 2)]
        start = [self.struct(name, nav) for name in self.described["carried"]]
        self.call("init", *start, *([] if x is None else [self.numbers(x)]), self.numbers(P))

    def numbers(self, value):
        return np.ascontiguousarray(value, self.real)

    def struct(self, name, inputs):
        array = np.zeros(self.library.width[name], self.real)
        for field, part in self.library.layout[name].items():
            if field in inputs:
                array[part] = inputs[field]
        return array

    def call(self, name, *arguments, refused=True):
        """The status; one that is no good raises BoresightError, unless it may be refused."""
        given = [ctypes.c_void_p(a.ctypes.data) if isinstance(a, np.ndarray) else a for a in arguments]
        function = getattr(self.dll, f"{self.prefix}_filter_{name}{self.ending}")
        status = Status(function(ctypes.c_void_p(self.memory.ctypes.data), *given))
        if refused and status not in (Status.OK, Status.AT_CEILING):
            raise BoresightError(f"{name}: {status.name}")
        return status

    @property
    def P(self):
        dense = np.zeros((self.n, self.n), self.real)
        self.call("covariance", dense)
        return dense.astype(float)

    def predict(self, **inputs):
        self.call("propagate", *(self.struct(name, inputs) for name in self.described["propagate"]["structs"]))

    def update(self, measurement, R, *, rows=True, gate=0.0, joint=0.0, iterations=1, inflate=False, relinearize=False,
               z=None, **inputs):  # fmt: skip
        described = self.described["measurements"][measurement]
        m, most = described["m"], max(one["m"] for one in self.described["measurements"].values())
        kind = ctypes.c_double if self.real is np.float64 else ctypes.c_float

        class Gates(ctypes.Structure):
            _fields_ = [("rows", ctypes.c_uint), ("gate", kind), ("joint", kind), ("iterations", ctypes.c_int),
                        ("options", ctypes.c_uint)]  # fmt: skip

        class Said(ctypes.Structure):
            _fields_ = [("nu", kind * most), ("S", kind * most), ("nis", kind), ("used", ctypes.c_uint),
                        ("inflated", ctypes.c_uint)]  # fmt: skip

        taken = sum(1 << i for i, row in enumerate(np.broadcast_to(rows, m)) if row)
        gates, said = Gates(taken, gate, joint, iterations, inflate + 2 * relinearize), Said()
        brought = [] if z is None else [self.numbers(np.atleast_1d(z))]
        structs = [self.struct(name, inputs) for name in described["structs"]]
        noise = self.numbers(np.atleast_1d(R))
        self.call(f"measure_{measurement}", *structs, *brought, noise, ctypes.byref(gates), ctypes.byref(said))
        used, inflated = (np.array([bool(mask >> i & 1) for i in range(m)]) for mask in (said.used, said.inflated))
        return Innovation(np.array(said.nu[:m]), np.array(said.S[:m]), used, np.float64(said.nis), inflated)

    def consider(self, considered):
        self.call("consider", np.array(considered, np.uint8))

    def set_block(self, first, block):
        self.call("set_block", first, len(block), self.numbers(block))

    def inflate(self, first, variance):
        self.call("inflate", first, len(variance), self.numbers(variance))

    def disable(self, first, count=1):
        self.call("disable", first, count)

    def enable(self, first, block):
        self.call("enable", first, len(block), self.numbers(block))

    @property
    def disabled(self):
        which = np.zeros(self.n, np.uint8)
        self.call("disabled", which)
        return which.astype(bool) if which.any() else None


@functools.cache
def compiled(folder, form):
    manifest = load(folder).manifest
    with tempfile.TemporaryDirectory() as out:
        probe, image = Path(out) / "probe.c", Path(out) / "probe.so"
        probe.write_text(PROBE.format(snake=manifest["model"].replace("-", "_"), p=manifest["c_prefix"]))
        command = ["gcc", "-shared", "-fPIC", "-std=c99", "-O0", "-ffp-contract=off", *FORMS[form][2]]
        sources = [*sorted((folder / "src").glob("*.c")), probe]
        subprocess.run([*command, "-I", folder / "include", *sources, "-lm", "-o", image], check=True)
        return ctypes.CDLL(str(image))
