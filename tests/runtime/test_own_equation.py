"""Every total state of the examples is flown by its own equation: SciPy's integrator of f is met to the fourth order of
the step, in Python and in both prints of C, and by the pendulum's export on an emulated Cortex-M4F."""

import importlib.util
import json
from functools import cache

import numpy as np
import pytest
import sympy as sp
from conftest import ROOT
from scipy.integrate import solve_ivp
from tools import needs

from boresight.codegen.export import export
from boresight.codegen.functions.samples import generator, sample
from boresight.derive.model import Model
from boresight.evidence.machine import Machine
from boresight.evidence.targets import M4F, OPTIMISED, WARNINGS, Build
from boresight.runtime.compiler import PRECISIONS, run
from boresight.runtime.filter import CompiledFilter, Filter
from boresight.runtime.library import load

FLIGHTS, STEPS = 4, 16  # flights, and steps of the coarsest
ROUNDING = 1e-12  # of the box of a state: below it SciPy and rounding decide


def examples():
    """The model of every total state that f flies, by FILE.py:NAME."""
    found = {}
    for file in sorted((ROOT / "examples").glob("*.py")):
        if "Model(" not in file.read_text():
            continue  # a script that flies one
        spec = importlib.util.spec_from_file_location(file.stem, file)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        for name, value in vars(module).items():
            flown_by_f = isinstance(value, Model) and value.kind == "total-state" and value.f is not None
            if flown_by_f and not any(v.norm for v in value.states):  # whose errors are a filter of their own
                found[f"{file}:{name}"] = value
    return found


EXAMPLES = examples()
PENDULUM = next(target for target in EXAMPLES if target.endswith("/pendulum.py:PENDULUM"))


@cache
def equation(target):
    """f as NumPy has it from SymPy: (x, inputs) -> rates."""
    model = EXAMPLES[target]
    symbols = [s for v in model.inputs for s in v.symbols]
    return sp.lambdify([list(model.x), symbols], list(model.f), "numpy")


def integrated(f, x, seconds):
    """SciPy's solution of x' = f(x) from x."""
    return solve_ivp(lambda _, x: f(x), (0, seconds), x, method="DOP853", rtol=1e-12, atol=1e-14, dense_output=True)


@cache
def flights(target):
    """Starts (runs, n), inputs by name (runs, size), seconds and exact ends (runs, n): from the middle of the boxes,
    half as long as it takes to leave them, but no longer than STEPS of the longest dt."""
    model, f = EXAMPLES[target], equation(target)
    boxes = (*model.states, *model.inputs)
    drawn = sample(boxes, 0, FLIGHTS, generator("flight", model.name))
    middle = [(part + (np.array(v.low) + v.high) / 2) / 2 for v, part in zip(boxes, drawn, strict=True)]
    x = np.hstack(middle[: len(model.states)])
    inputs = {v.name: part for v, part in zip(model.inputs, middle[len(model.states) :], strict=True)}
    free = np.repeat([v.wraps for v in model.states], [v.size for v in model.states])
    low, high = (
        np.where(free, end, np.hstack(box))
        for end, box in ((-np.inf, [v.low for v in model.states]), (np.inf, [v.high for v in model.states]))
    )
    longest = next(v.high[0] for v in model.inputs if model.dt in v.symbols)
    ends, seconds = [], STEPS * longest
    while len(ends) < FLIGHTS:
        given = np.hstack([part[len(ends)] for part in inputs.values()])
        with np.errstate(invalid="ignore"):  # beyond the boxes f may have no value
            exact = integrated(lambda x, u=given: f(x, u), x[len(ends)], 2 * seconds)
        seen = exact.sol(np.linspace(0, 2 * seconds, 200)).T if exact.success else np.full((1, model.n), np.nan)
        if ((seen > low) & (seen < high)).all():
            ends.append(exact.sol(seconds))
        else:
            ends, seconds = [], seconds / 2
    return x, inputs, seconds, np.array(ends)


def size(model):
    return np.array([max(abs(a), abs(b)) for v in model.states for a, b in zip(v.low, v.high, strict=True)])


def flown(kind, library, target, steps):
    """The ends of the flights in so many steps, less the exact ones: (runs, n), of the box of each state."""
    model = EXAMPLES[target]
    x, inputs, seconds, ends = flights(target)
    (dt,) = (v.name for v in model.inputs if model.dt in v.symbols)
    given = {name: part if part.shape[1] > 1 else part[:, 0] for name, part in inputs.items()}
    loop = kind(library, {}, np.zeros((model.n, model.n)), x=x)
    for _ in range(steps):
        loop.predict(**given | {dt: seconds / steps})
    off = loop.x - ends
    turns = np.array([v.wraps for v in model.states for _ in v.symbols])
    return np.where(turns, np.remainder(off + np.pi, 2 * np.pi) - np.pi, off) / size(model)


@pytest.mark.digits
@pytest.mark.parametrize("target", EXAMPLES, ids=[model.name for model in EXAMPLES.values()])
def test_every_total_state_is_flown_by_its_own_equation_to_the_fourth_order(target, folder_of):
    flight, casadi = (load(folder_of(target), backend) for backend in ("flight", "casadi"))
    coarse, fine = (np.abs(flown(CompiledFilter, flight, target, n)).max() for n in (8 * STEPS, 16 * STEPS))
    assert fine < 1e-6
    assert fine < ROUNDING or np.log2(coarse / fine) > 3.75
    ends = [
        flown(kind, made, target, STEPS)
        for kind, made in ((CompiledFilter, flight), (Filter, flight), (Filter, casadi))
    ]
    assert ends[0].tobytes() == ends[1].tobytes() == ends[2].tobytes()


def test_no_total_state_is_forgotten():
    """Of the built-in models there is none; one that comes must be flown here too."""
    manifests = [json.loads(path.read_text()) for path in (ROOT / "generated").glob("*/manifest.json")]
    assert [m["model"] for m in manifests if "next" in m["units"]] == []
    assert {model.name for model in EXAMPLES.values()} >= {"pendulum", "tank", "radar"}


FALL = """
#include "pendulum_filter.h"
int fall(void);
double flown[6];
int fall(void)
{
    static const bs_real x[PD_N_STATES] = { BS_REAL(2.0), BS_REAL(0.0) };
    static const bs_real P[PD_N_STATES * PD_N_STATES] = { BS_REAL(0.0) };
    static const pd_plant plant = { { BS_REAL(1.0), BS_REAL(0.1) } };
    pd_step step = { BS_REAL(0.05), BS_REAL(0.1) };
    pd_filter filter;
    bs_status status = BS_OK;
    for (int halved = 0, count = 8; (halved < 3) && (status == BS_OK); ++halved, count *= 2) {
        status = pd_filter_init(&filter, x, P);
        for (int k = 0; (k < count) && (status == BS_OK); ++k) {
            status = pd_filter_propagate(&filter, &plant, &step);
        }
        flown[2 * halved] = (double)filter.x[PD_IX_THETA];
        flown[2 * halved + 1] = (double)filter.x[PD_IX_OMEGA];
        step.dt /= BS_REAL(2.0);
    }
    return (int)status;
}
"""


@needs("arm-none-eabi-gcc")
@pytest.mark.parametrize("precision", ["double", "float"])
def test_the_exported_pendulum_falls_on_an_emulated_cortex_m4f(precision, folder_of, tmp_path):
    export(PENDULUM, tmp_path / "out", precision, folder_of(PENDULUM))
    (tmp_path / "fall.c").write_text(FALL)
    image, include = tmp_path / "fall.elf", tmp_path / "out" / "include"
    sources = [tmp_path / "fall.c", *sorted((tmp_path / "out" / "src").glob("*.c"))]
    run([
        *(M4F.compiler, *WARNINGS, *M4F.flags, *PRECISIONS[precision], *OPTIMISED, "-I", include, *M4F.link),
        *("-Wl,-e,fall", "-Wl,--gc-sections", "-Wl,--no-warnings", *sources, "-lm", "-o", image),
    ])  # fmt: skip
    machine = Machine(Build(None, M4F, precision, {}, image), image)
    assert machine.call("fall") == 0
    f = equation(PENDULUM)
    inputs = {"length": 1.0, "damping": 0.1}
    symbols = [s.name for v in EXAMPLES[PENDULUM].inputs for s in v.symbols]
    exact = integrated(lambda x: f(x, [inputs.get(name, 0.0) for name in symbols]), [2.0, 0.0], 0.4).y[:, -1]
    off = np.abs(machine.read("flown", np.float64, 6).reshape(3, 2) - exact).max(axis=1)
    if precision == "double":
        assert np.log2(off[:-1] / off[1:]) == pytest.approx([4, 4], abs=0.2)
    assert off[-1] < (1e-6 if precision == "double" else 1e-5), off
