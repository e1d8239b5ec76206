"""A total state is flown by its own equation: in Python and both prints of C, one run and many, and as exported."""

import importlib.util
import subprocess

import numpy as np
import pytest
from conftest import ROOT
from scipy.integrate import solve_ivp

from boresight import BoresightError
from boresight.codegen.export import export
from boresight.runtime.filter import CompiledFilter, Filter
from boresight.runtime.library import load

FLOWN = [(Filter, "flight"), (Filter, "casadi"), (CompiledFilter, "flight")]
PENDULUM = f"{ROOT / 'examples' / 'pendulum.py'}:PENDULUM"
TANK = f"{ROOT / 'examples' / 'own_model.py'}:TANK"
SWING = {"rod": [1.0, 0.1], "torque": 0.1}  # m, 1/s
LEAK = {"tank": [1.0, 0.01], "inflow": [0.0, 0.0]}  # m^2


def example(target):
    file, name = target.rsplit(":", 1)
    spec = importlib.util.spec_from_file_location("example", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return getattr(module, name)


@pytest.fixture(scope="module")
def folder(folder_of):
    return {"PENDULUM": folder_of(PENDULUM), "TANK": folder_of(TANK)}


def integrated(f, x, seconds):
    return solve_ivp(lambda _, x: f(x), (0, seconds), x, method="DOP853", rtol=1e-12, atol=1e-12).y[:, -1]


def swinging(x):
    return [x[1], -9.81 * np.sin(x[0]) - 0.1 * x[1]]


def steps(loop, count, **inputs):
    seen = []
    for _ in range(count):
        loop.predict(**inputs)
        seen.append(loop.x.copy())
    return np.array(seen)


@pytest.mark.parametrize(("kind", "backend"), FLOWN)
def test_a_pendulum_that_is_let_go_falls(kind, backend, folder):
    loop = kind(load(folder["PENDULUM"], backend), {}, np.zeros((2, 2)), x=[2.0, 0.0])
    angle = steps(loop, 40, dt=0.01, **SWING)[:, 0]
    assert angle[[19, 39]] == pytest.approx([1.820, 1.270], abs=1e-3)
    assert loop.x == pytest.approx(integrated(swinging, [2.0, 0.0], 0.4), abs=3e-8)


@pytest.mark.parametrize(("kind", "backend"), FLOWN)
def test_a_tank_runs_out_as_Torricelli_says(kind, backend, folder):
    loop = kind(load(folder["TANK"], backend), {}, np.zeros((2, 2)), x=[4.0, 0.1])
    steps(loop, 60, dt=0.5, **LEAK)
    root = np.sqrt(4.0) - 0.01 * np.sqrt(9.81 / 2) * 30  # of the depth, which falls evenly
    assert loop.x == pytest.approx([root**2, 0.1], abs=1e-9)
    assert root**2 == pytest.approx(1.784, abs=5e-4)


@pytest.mark.parametrize(("kind", "backend"), FLOWN)
def test_many_runs_give_the_bits_of_each_alone(kind, backend, folder):
    library, rng = load(folder["PENDULUM"], backend), np.random.default_rng(5)
    x, P = rng.uniform(-3, 3, (40, 2)), np.diag([1e-2, 1e-3])
    together = kind(library, {}, P, x=x)
    steps(together, 20, dt=0.05, **SWING)
    for run in (0, 17, 39):
        alone = kind(library, {}, P, x=x[run])
        steps(alone, 20, dt=0.05, **SWING)
        assert together.x[run].tobytes() == alone.x.tobytes()
        assert together.P[run] == pytest.approx(alone.P, rel=1e-12)


def test_the_compiled_filter_is_the_python_loop_to_rounding_and_casadi_gives_its_bits(folder):
    loops = [kind(load(folder["PENDULUM"], name), {}, np.diag([1e-2, 1e-3]), x=[2.0, 1.0]) for kind, name in FLOWN]
    flown = [steps(loop, 100, dt=0.02, **SWING) for loop in loops]
    assert flown[0].tobytes() == flown[1].tobytes() == flown[2].tobytes()
    assert loops[0].P.tobytes() == loops[1].P.tobytes()
    assert pytest.approx(loops[0].P, rel=1e-12) == loops[2].P


@pytest.mark.parametrize(("kind", "backend"), FLOWN)
def test_an_angle_that_swings_over_the_top_wraps(kind, backend, folder):
    loop = kind(load(folder["PENDULUM"], backend), {}, np.zeros((2, 2)), x=[3.1, 8.0])
    seen = steps(loop, 50, dt=0.01, **SWING)
    free = [integrated(swinging, [3.1, 8.0], 0.01 * k) for k in (1, 25, 50)]
    for (angle, rate), (unwound, exact) in zip(seen[[0, 24, 49]], free, strict=True):
        turns = (unwound - angle) / (2 * np.pi)
        assert (round(turns), rate) == (pytest.approx(turns, abs=1e-7), pytest.approx(exact, abs=1e-6))
    assert free[2][0] > np.pi and ((seen[:, 0] >= -np.pi) & (seen[:, 0] < np.pi)).all()


@pytest.mark.parametrize(("kind", "backend"), FLOWN)
def test_a_state_that_leaves_its_box_changes_nothing(kind, backend, folder):
    loop = kind(load(folder["TANK"], backend), {}, np.eye(2) * 1e-4, x=[0.012, 0.0])
    with pytest.raises(BoresightError, match="leaves its box or is no number"):
        loop.predict(dt=1.0, **LEAK)
    with pytest.raises(BoresightError, match="leaves its box or is no number"):
        loop.predict(dt=10.0, tank=[0.5, 0.1], inflow=[0.0, 0.0])  # where the step takes a root of less than nothing
    assert (loop.x.tolist(), loop.P.tolist()) == ([0.012, 0.0], (np.eye(2) * 1e-4).tolist())


def test_a_total_state_begins_where_it_is_told_to(folder):
    library = load(folder["PENDULUM"])
    for kind in (Filter, CompiledFilter):
        with pytest.raises(BoresightError, match="pendulum has a total state; give x"):
            kind(library, {}, np.eye(2))
        with pytest.raises(BoresightError, match=r"x has shape .3,.; it must be \(..., 2\)"):
            kind(library, {}, np.eye(2), x=[1.0, 2.0, 3.0])
        assert kind(library, {}, np.eye(2), x=[4.0, 0.0]).x[0] == 4.0 - 2 * np.pi


@pytest.mark.parametrize("precision", ["double", "float"])
def test_the_exported_pendulum_falls_too(precision, folder, tmp_path):
    export(PENDULUM, tmp_path / "out", precision, folder["PENDULUM"])
    (tmp_path / "fall.c").write_text("""
#include <stdio.h>
#include "pendulum_filter.h"
int main(void)
{
    static const bs_real x[PD_N_STATES] = { BS_REAL(2.0), BS_REAL(0.0) };
    static const bs_real P[PD_N_STATES * PD_N_STATES] = { BS_REAL(0.0) };
    static const pd_plant plant = { { BS_REAL(1.0), BS_REAL(0.1) } };
    static const pd_step step = { BS_REAL(0.01), BS_REAL(0.1) };
    pd_filter filter;
    bs_status status = pd_filter_init(&filter, x, P);
    for (int k = 1; (k <= 40) && (status == BS_OK); ++k) {
        status = pd_filter_propagate(&filter, &plant, &step);
        if ((k % 20) == 0) {
            printf("%.9f ", (double)filter.x[PD_IX_THETA]);
        }
    }
    return (int)status;
}
""")
    out, made = tmp_path / "out", "example" if precision == "float" else "all"
    command = ["make", "-C", out, "CFLAGS=-O0 -Werror", made]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert ("60 s flown; state and sigmas within" in done.stdout) is (made == "example")
    program = str(tmp_path / "fall")
    flags = ["-std=c99", "-Wall", "-Werror", "-ffp-contract=off", f"-I{out / 'include'}"]
    sources = [tmp_path / "fall.c", out / "build" / f"libpendulum{'_f32' if precision == 'float' else ''}.a"]
    subprocess.run(["cc", *flags, *sources, "-lm", "-o", program], check=True)
    angles = [float(word) for word in subprocess.run([program], capture_output=True, check=True).stdout.split()]
    wanted = [integrated(swinging, [2.0, 0.0], seconds)[0] for seconds in (0.2, 0.4)]
    assert wanted == pytest.approx([1.820, 1.270], abs=1e-3)
    assert angles == pytest.approx(wanted, abs=4e-9 if precision == "double" else 3e-6)
