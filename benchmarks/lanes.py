"""What a run costs in a block of runs, beside a loop of the scalar functions: python -m benchmarks.lanes

The azimuth hold of 15 states, by processor time inside C; all widths and the loop take turns in every round, and each
has the least of its rounds.  The propagation stands beside the limit of the machine, see `peers.compiled.limit`; how
many numbers it computes at a time is measured.  Normal numbers are counted by each.
"""

import ctypes
import hashlib
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from benchmarks import interleaved
from benchmarks.peers.compiled import clock, limit
from benchmarks.peers.formulas import operations, problem
from boresight.runtime import compiler, random
from boresight.runtime.compiler import open_library, shared_library
from boresight.runtime.filter import CompiledFilter, Epoch
from boresight.runtime.library import load

MODEL = "azimuth-hold"
SIZES = (16, 256)
ROUNDS = 30
SAMPLES = 50  # of the strapdown, where several go in one call
HARNESS = r"""
#define _POSIX_C_SOURCE 199309L
#include <time.h>

#include "azimuth_hold_filter.h"

typedef struct { const double *at; size_t stride; size_t step; } bs_given;
typedef size_t (*step)(size_t, void *, const bs_given *, unsigned char *);
typedef size_t (*measure)(size_t, void *, int, const bs_given *, const void *, unsigned char *);

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double in_lanes(int which, int often, size_t n, void *block, const void *function, const bs_given *given,
                const void *taking, unsigned char *status);
double in_a_loop(int which, int often, size_t n, ah_filter *filter, const bs_given *given, unsigned char *status);
double product(double factor);

/* Seconds of one multiplication of the widest numbers, where none of CHAINS waits for another. */
#define CHAINS 12
typedef double wide __attribute__((vector_size(8 * WIDEST)));
double product(double factor)
{
    const int often = 1000000;
    const double begin = now();
    volatile double kept;
    wide chain[CHAINS];
    for (int c = 0; c < CHAINS; ++c) {
        chain[c] = (wide){ 0.0 } + (factor + c);
    }
    for (int i = 0; i < often; ++i) {
        for (int c = 0; c < CHAINS; ++c) {
            chain[c] *= factor;
        }
    }
    for (int c = 0; c < CHAINS; ++c) {
        kept = chain[c][0];
    }
    (void)kept;
    return (now() - begin) / often / CHAINS;
}

double in_lanes(int which, int often, size_t n, void *block, const void *function, const bs_given *given,
                const void *taking, unsigned char *status)
{
    const double begin = now();
    for (int i = 0; i < often; ++i) {
        if (which == 2) {
            (void)((measure)function)(n, block, AH_MEASUREMENT_ZUPT, given, taking, status);
        } else {
            (void)((step)function)(n, block, given, status);
        }
    }
    return (now() - begin) / often;
}

double in_a_loop(int which, int often, size_t n, ah_filter *filter, const bs_given *given, unsigned char *status)
{
    const double begin = now();
    for (int k = 0; k < often; ++k) {
        for (size_t i = 0; i < n; ++i) {
            const double *const one = given[0].at != NULL ? &given[0].at[i * given[0].stride] : NULL;
            const double *const other = given[1].at != NULL ? &given[1].at[i * given[1].stride] : NULL;
            ah_innovation innovation;
            bs_status said = BS_OK;
            switch (which) {
            case 0:
                said = ah_filter_strapdown(&filter[i], (const ah_corrected_imu *)one, (const ah_increments *)other);
                break;
            case 1:
                said = ah_filter_propagate(&filter[i], (const ah_corrected_imu *)one, (const ah_noise *)other);
                break;
            case 2:
                said = ah_filter_measure_zupt(&filter[i], one, NULL, &innovation);
                break;
            default:
                said = ah_filter_correct(&filter[i]);
                break;
            }
            status[i] = (unsigned char)said;
        }
    }
    return (now() - begin) / often;
}
"""
CALLS = (
    ("strapdown", "strapdown"),
    ("propagate", "propagate"),
    ("update of 3 rows", "measure"),
    ("correct", "correct"),
    (f"strapdown, {SAMPLES} a call", "epoch"),
)


def harness(out):
    """The library of the text above with the scalar functions, as `load` compiles them."""
    library = load(MODEL)
    source = out / "harness.c"
    source.write_text(HARNESS)
    sources = {source: ("-O3", f"-DWIDEST={compiler.lanes()}")}
    sources |= dict.fromkeys(sorted((library.folder / "src").glob("*.c")), ())
    digest = hashlib.sha256(HARNESS.encode()).hexdigest() + library.manifest["hash"]
    made = open_library(*shared_library("bench-lanes", digest, sources, library.folder / "include"))
    for function in (made.in_lanes, made.in_a_loop, made.product):
        function.restype = ctypes.c_double
    return made


def flown(width, n):
    """A filter at rest in n runs, an Epoch of all its steps, and one of the strapdown alone."""
    rng = np.random.default_rng(1)
    sigma = np.array([1e-6, 1e-6, 5, 0.1, 0.1, 0.1, 0.01, 0.01, 0.02, *3 * (1e-5,), *3 * (0.01,)])
    q = np.array([1, 0.001, -0.002, 0.005]) + rng.normal(0, 1e-3, (n, 4))
    nav = {"lon_lat_height": np.array([0.5, 0.75, 100.0]), "v_n": rng.normal(0, 0.01, (n, 3)),
           "q_b2n_wxyz": q / np.linalg.norm(q, axis=-1, keepdims=True), "gyro_bias": np.zeros(3),
           "accel_bias": np.zeros(3)}  # fmt: skip
    loop = CompiledFilter(load(MODEL, lanes=width), nav, np.broadcast_to(np.diag(sigma**2), (n, 15, 15)))
    loop.memory.library.widest = width
    epoch = Epoch(loop, 1, ["zupt"], runs=(n,))
    steps = Epoch(loop, SAMPLES, predict=False, feedback=False, runs=(n,), shared=("dt",))
    for inputs in (epoch.strapdown, steps.strapdown):
        inputs["dt"] = 0.01
        inputs["dtheta_ib_b"] = rng.normal(0, 1e-5, (1, n, 3))
        inputs["dv_b"] = np.array([0, 0, 0.098]) + rng.normal(0, 1e-4, (1, n, 3))
        inputs["dtheta_before"], inputs["dv_before"] = 1e-5, np.array([0, 0, 0.098])
    epoch.predict["dt"] = 0.01
    epoch.predict["f_b"] = np.array([0, 0, 9.8])
    for name, value in {
        "gyro_noise": 1e-4,
        "accel_noise": 5e-3,
        "gyro_bias_noise": 1e-7,
        "accel_bias_noise": 1e-5,
    }.items():
        epoch.predict[name] = value
    epoch.measured["zupt"]["R"] = 1e-4
    return loop, epoch, steps


def measured(widths, n, made):
    """{(call, width or "loop"): ns a run}."""
    flights = {width: flown(width, n) for width in widths}
    tasks, names = {}, {}
    filters = None
    for width, (loop, epoch, steps) in flights.items():
        loop.memory.settle((n,))
        if filters is None:
            size = loop.memory.library.dll.ah_filter_size
            size.restype = ctypes.c_size_t
            filters = np.zeros((n, size()))
            filters[:, :151] = loop.memory.blocks.read(slice(0, 151))
        status = np.zeros(n, np.uint8)
        given = (
            epoch.strapdown.given,
            epoch.predict.given,
            epoch.measured["zupt"].given,
            (type(epoch.predict.given[0]) * 2)(),
            ctypes.byref(steps._cycle),
        )
        for which, (call, function) in enumerate(CALLS):
            samples = SAMPLES if function == "epoch" else 1
            often = max(1, 4096 // n // samples)
            rest = (ctypes.byref(epoch.measured["zupt"].taking), ctypes.c_void_p(status.ctypes.data))
            pointer = ctypes.cast(getattr(loop.memory.dll, f"ah_lanes_{function}"), ctypes.c_void_p)
            state = ctypes.c_void_p(loop.memory.blocks.address)
            names[call, width] = lambda w=which, o=often, s=state, p=pointer, g=given[which], r=rest, m=samples: (
                made.in_lanes(w, o, ctypes.c_size_t(n), s, p, g, *r) / m
            )
            if width == widths[0] and samples == 1:
                names[call, "loop"] = lambda w=which, o=often, g=given[which], s=status, f=filters: made.in_a_loop(
                    w, o, ctypes.c_size_t(n), ctypes.c_void_p(f.ctypes.data), g, ctypes.c_void_p(s.ctypes.data)
                )
        tasks[width] = (status, epoch)
    best = dict.fromkeys(names, np.inf)
    for _ in range(ROUNDS):
        for name, task in names.items():
            best[name] = min(best[name], task() / n * 1e9)
    assert all(not status.any() for status, _ in tasks.values())
    return {(f"strapdown, {SAMPLES} a call", "loop"): best["strapdown", "loop"], **best}


def least(made, ghz):
    """ns of a propagation at the least."""
    a_cycle = compiler.lanes() / min(made.product(ctypes.c_double(1.0)) for _ in range(ROUNDS)) / (ghz * 1e9)
    p = problem()
    done = operations(p, "propagate")
    print(f"{a_cycle:.1f} multiplications a cycle, {done['multiply']} a propagation")
    return limit(p, "propagate", done, a_cycle / 2, ghz)


def main():
    most = compiler.lanes()
    widths = [w for w in (1, 2, 4, 8) if w <= most]
    with TemporaryDirectory() as folder:
        (Path(folder) / "objects").mkdir()
        made, ghz = harness(Path(folder)), clock(Path(folder))
        bound = least(made, ghz)
    for n in SIZES:
        best = measured(widths, n, made)
        print(
            f"{n} runs, ns a run".ljust(24)
            + f"{'loop':>8}"
            + "".join(f"{f'W = {w}':>8}" for w in widths)
            + f"{'loop / best':>14}"
        )
        for call, _ in CALLS:
            row = [best[call, w] for w in ("loop", *widths)]
            print(call.ljust(24) + "".join(f"{value:8.0f}" for value in row) + f"{row[0] / min(row[1:]):14.1f}")
        share = bound / min(best["propagate", w] for w in widths)
        print(f"limit of propagate at {ghz:.2f} GHz: {bound:.0f} ns, {share:.0%} of it reached")
    runs, out = np.arange(256), np.empty((256, 600))
    best = interleaved({w: (lambda w=w: random.normals(1, runs, 600, out=out, lanes=w)) for w in widths})
    print("normal numbers, ns each".ljust(32) + "".join(f"{best[w] / out.size * 1e9:8.1f}" for w in widths))


if __name__ == "__main__":
    sys.exit(main())
