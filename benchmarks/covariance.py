"""Predict and update of the filters: Python loop, C filter from Python, C alone: python -m benchmarks.covariance

The kernels are timed from an interpreted loop, less what an empty C function costs there; minima over interleaved
repeats.  The filters are those of the azimuth hold at rest, for one run and for 64.
"""

import ctypes
import functools
import time

import numpy as np

from benchmarks.hold import AT_REST, NOISE
from boresight.runtime.compiled import CompiledFilter
from boresight.runtime.filter import Filter
from boresight.runtime.library import load

REPEATS, CALLS = 9, 1000
MODELS = ("euler-matching", "velocity-dcm", "azimuth-hold", "velocity-attitude")


def seconds(functions, calls):
    """Of one call of each, by name: the least of interleaved repeats."""
    best = dict.fromkeys(functions, np.inf)
    for _ in range(REPEATS):
        for name, function in functions.items():
            start = time.perf_counter()
            for _ in range(calls):
                function()
            best[name] = min(best[name], (time.perf_counter() - start) / calls)
    return best


class Row(ctypes.Structure):
    """bs_row."""

    _fields_ = [
        ("h", ctypes.c_void_p), ("at", ctypes.c_void_p), ("count", ctypes.c_int), ("z", ctypes.c_double),
        ("R", ctypes.c_double), ("gate", ctypes.c_double), ("nu", ctypes.c_double), ("S", ctypes.c_double),
        ("used", ctypes.c_int), ("gain", ctypes.c_void_p),
    ]  # fmt: skip


def kernels(name):
    """Seconds of each kernel of a model, on a covariance with every correlation and a sparse row of two."""
    library = load(name)
    dll, prefix, n = library.dll, library.manifest["c_prefix"], len(library.states)
    root = np.random.default_rng(0).standard_normal((n, n))
    dense = root @ root.T / n
    columns, rows = np.tril_indices(n)
    Phi, next_P = np.full((n + 5) ** 2, 1e-3), np.zeros(n * (n + 1) // 2)  # the kernel reads as many as it has
    packed, Q, work, x = (
        dense[rows, columns].copy(),
        1e-3 * np.eye(n)[rows, columns],
        np.zeros(4 * (n + 5) ** 2),
        np.zeros(n),
    )
    h, at = np.array([1.0, 0.1]), np.array([0, n - 1], dtype=np.uint16)
    row = Row(h.ctypes.data, at.ctypes.data, 2, 0.0, 1e3, 0.0, 0.0, 0.0, 1)

    kept = []  # what the pointers below point to

    def bound(function, *arrays):
        kept.append(arrays)
        pointers = [ctypes.c_void_p(a.ctypes.data) if isinstance(a, np.ndarray) else a for a in arrays]
        return functools.partial(getattr(dll, f"{prefix}_{function}"), *pointers)

    made = {"an empty call": bound("filter_size")}
    for form in ("joseph", "ud"):
        begin, P, noise = bound(f"{form}_init", dense, packed, work), packed.copy(), Q.copy()
        begin()
        P[:] = packed
        made[f"{form} predict"] = bound(f"{form}_predict", P, Phi, noise, next_P, work)
        P2 = packed.copy()
        made[f"{form} update"] = bound(f"{form}_update", P2, x, ctypes.byref(row))
    best = seconds(made, CALLS)
    empty = best.pop("an empty call")
    return {name: value - empty for name, value in best.items()}


def loops(runs):
    """Seconds a run of predict and of an update of three rows, from Python, by the loop and by the C filter."""
    hold = load("azimuth-hold")
    made = {}
    for label, kind in (("Python loop", Filter), ("C filter", CompiledFilter)):
        shape = (runs,) if runs > 1 else ()
        start = {**AT_REST, "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3)}
        nav = {name: np.broadcast_to(value, (*shape, len(value))) for name, value in start.items()}
        loop = kind(hold, nav, np.broadcast_to(np.eye(15) * 1e-6, (*shape, 15, 15)))
        made[label, "predict"] = functools.partial(loop.predict, f_b=np.array([0, 0, 9.8]), dt=1.0, **NOISE)
        made[label, "update"] = functools.partial(loop.update, "zupt", np.full(3, 1e-4))
    return {key: value / runs for key, value in seconds(made, 50).items()}


def main():
    print("kernels in double, ns a call")
    print(
        f"{'model':<20}"
        + "".join(f"{name:>16}" for name in ("joseph predict", "joseph update", "ud predict", "ud update"))
    )
    for name in MODELS:
        best = kernels(name)
        print(f"{name:<20}" + "".join(f"{value * 1e9:16.0f}" for value in best.values()))
    print("azimuth-hold from Python, us a run: Phi, Q and predict; z, H and an update of three rows")
    for runs in (1, 64):
        best = loops(runs)
        for step in ("predict", "update"):
            python, c = best["Python loop", step] * 1e6, best["C filter", step] * 1e6
            print(
                f"  {runs:3d} runs  {step:<8} Python loop {python:8.2f}   C filter {c:8.2f}   ratio {python / c:6.1f}"
            )


if __name__ == "__main__":
    main()
