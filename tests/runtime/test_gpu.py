"""An experiment in C: its text for a GPU has the bits of the host, and so has what NVRTC makes of it, as far as it can
be read without a card; a stand-in for the driver shows how it is launched."""

import json
import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from conftest import ROOT
from tools import needs, tool

from benchmarks.gpu import by_host
from boresight import BoresightError, cli, many
from boresight.runtime.gpu import machine_code, text
from boresight.runtime.library import load
from boresight.runtime.manifest import folder_of
from boresight.studies.sea_state import flight
from boresight.studies.sea_state import many as sea

SHORT = flight.Scenario(covariance_hz=1, seconds=12)
FOLDER = folder_of(sea.MODEL)
COLUMNS = 35


@pytest.mark.parametrize("motion", ["slope", "sea"])
@pytest.mark.digits
def test_a_run_in_c_has_the_bits_of_the_run_side_by_side(motion, monkeypatch):
    """Of one sea, and over the border of two."""
    monkeypatch.setattr(sea, "TOGETHER", 16)
    kind, model, runs = sea.Sea(motion, 5, SHORT), load(sea.MODEL), range(30, 50)
    rows, status = text.fly(text.host(FOLDER, sea.SOURCE), sea.numbers(model, kind, 7, runs), 7, runs, COLUMNS)
    np.testing.assert_array_equal(rows, sea.fly(model, kind, 7, runs))
    assert not status.any() and np.isfinite(rows).all()


def test_an_experiment_in_c_alone_flies_on_the_host():
    kind = sea.experiment(sea.Sea("slope", 5, SHORT))
    assert many(replace(kind, fly=None), runs=9, seed=7).columns == many(kind, runs=9, seed=7).columns


def test_a_run_that_ends_badly_has_its_status_and_the_others_go_on():
    model, runs = load(sea.MODEL), range(4)
    given = sea.numbers(model, sea.Sea("slope", 5, SHORT), 7, runs)
    library = text.host(FOLDER, sea.SOURCE)
    given[9] = 2e3  # ms of delay: those that come late leave the box of the model
    rows, status = text.fly(library, given, 7, runs, COLUMNS)
    lost = status != 0
    assert lost.any() and np.isnan(rows[lost]).all() and np.isfinite(rows[~lost]).all()


ELSEWHERE = """
#include <stdio.h>
#include "run.h"
int sea_truth(const double *given, const double *setting, uint64_t seed, uint64_t number, double *out);
static double given[1000000], setting[100], rows[4][35];
static unsigned char status[4];
int main(void)
{
    const size_t n = fread(given, sizeof given[0], 1000000, fopen("common", "rb"));
    if ((fread(setting, sizeof setting[0], 100, fopen("scene", "rb")) < 10) ||
        (sea_truth(given, setting, 7, 0, &given[n]) != 0)) {
        return 1;
    }
    boresight_runs(given, 7, 0, 4, 35, &rows[0][0], status);
    return (fwrite(rows, 1, sizeof rows, stdout) == sizeof rows) ? 0 : 1;
}
"""


@needs("aarch64-linux-gnu-gcc", "qemu-aarch64")
def test_a_sea_its_truth_and_its_flights_have_the_same_bits_on_another_processor(tmp_path):
    kind = sea.Sea("sea", 5, replace(SHORT, seconds=11))
    for name, numbers in (("common", sea.common(kind)), ("scene", sea.scene(kind))):
        (tmp_path / name).write_bytes(numbers.tobytes())
    (tmp_path / "elsewhere.c").write_text(ELSEWHERE)
    places = *text.HEADERS, sea.SOURCE.parent, FOLDER / "include"
    files = text.sources(FOLDER, text.RUNS, sea.SOURCE, sea.TRUTH, tmp_path / "elsewhere.c")
    words = ["-std=c99", "-O1", "-ffp-contract=off", "-static", *(f"-I{place}" for place in places), *files]
    subprocess.run([tool("aarch64-linux-gnu-gcc"), *words, "-lm", "-o", tmp_path / "elsewhere"], check=True)
    flown = subprocess.run([tool("qemu-aarch64"), "./elsewhere"], cwd=tmp_path, check=True, capture_output=True).stdout
    assert flown == sea.fly(load(sea.MODEL), kind, 7, range(4)).tobytes()


@needs("g++")
@pytest.mark.parametrize("precision", ["double"])  # float: benchmarks/gpu.py
def test_the_text_for_a_gpu_has_the_bits_of_scalar_c(precision, tmp_path):
    """By g++, which has the headers of a host."""
    model, runs = load(sea.MODEL), range(40)
    given = sea.numbers(model, sea.Sea("slope", 5, SHORT), 7, runs)
    apart = text.fly(text.host(FOLDER, sea.SOURCE, precision), given, 7, runs, COLUMNS)
    whole = text.fly(by_host(text.device(FOLDER, sea.SOURCE, precision), tmp_path), given, 7, runs, COLUMNS)
    for one, other in zip(whole, apart, strict=True):
        np.testing.assert_array_equal(one, other)


# ---- what NVRTC makes

BODY = """
        {
        ld.global.f64   %fd1, [%rd1];
        @%p1 bra        $L__BB0_2;
        mul.rn.f64      %fd2, %fd1, %fd1;
        add.rn.f64      %fd3, %fd2, %fd1;
        sub.rn.f32      %f3, %f2, %f1;
        mul.wide.u32    %rd2, %r1, 8;
        mad.lo.s32      %r2, %r1, %r1, %r1;
        add.s64         %rd3, %rd2, %rd1;
        div.rn.f64      %fd4, %fd3, %fd1;
        sqrt.rn.f64     %fd5, %fd4;
        call.uni (retval0), own_function, (param0, param1);
        ADDED
        ret;
        }
"""
PTX = ".func (.param .b32 func_retval0) own_function(\n .param .b64 p0\n)\n" + BODY


def test_ptx_that_rounds_each_operation_once_is_found_good():
    counts, faults = machine_code.read(PTX.replace("ADDED", ""))
    assert not faults and counts["mul.rn.f64"] == 1 and counts["mul.wide.u32"] == 1 and counts["bra"] == 1


@pytest.mark.parametrize(
    "line",
    [
        "fma.rn.f64 %fd1, %fd2, %fd3, %fd4", "@!%p2 mad.f32 %f1, %f2, %f3, %f4",
        "add.f64 %fd1, %fd2, %fd3", "sub.f32 %f1, %f2, %f3", "mul.rn.ftz.f32 %f1, %f2, %f3", "abs.ftz.f32 %f1, %f2",
        "div.approx.f32 %f1, %f2, %f3", "div.full.f32 %f1, %f2, %f3", "sqrt.approx.f32 %f1, %f2",
        "mul.rz.f64 %a, %b, %c", "ex2.approx.f32 %f1, %f2", "call.uni (retval0), __nv_sin, (param0)",
        "call.uni vprintf, (param0)",
        "call (retval0), %rd5, (param0), prototype_0",
    ],
)  # fmt: skip
def test_ptx_that_may_have_other_bits_is_refused(line):
    assert len(machine_code.read(PTX.replace("ADDED", line + ";"))[1]) == 1


SMALL = """
extern "C" __global__ void small(TYPE *x)
{
    x[0] = ((x[1] * x[2]) + x[3]) / sqrt(x[4]);
}
"""


@needs("nvrtc")
@pytest.mark.parametrize("kind", ["double", "float"])
def test_nvrtc_fuses_and_approximates_if_it_may_and_the_reader_sees_it(kind):
    small, options = SMALL.replace("TYPE", kind), machine_code.OPTIONS
    assert not machine_code.read(machine_code.compiled(small, "sm_80")[0])[1]
    fused = tuple("-fmad=true" if option == "-fmad=false" else option for option in options)
    assert machine_code.read(machine_code.compiled(small, "sm_80", fused)[0])[1]
    if kind == "float":  # of double nothing is approximated
        fast = tuple(option for option in options if not option.startswith(("-prec", "-ftz")))
        assert machine_code.read(machine_code.compiled(small, "sm_80", (*fast, "-use_fast_math"))[0])[1]


@needs("nvrtc")
def test_nvrtc_names_its_first_error_and_the_gpus_that_it_knows():
    with pytest.raises(BoresightError, match=r"^NVRTC refuses the text: flights.cu\(1\): error: [^\n]*$"):
        machine_code.compiled("no C", "sm_80")
    with pytest.raises(BoresightError, match=r"^a GPU of sm_30 is none of those .* sm_\d+ to sm_\d+$"):
        machine_code.compiled("", "sm_30")


# ---- the way there


@pytest.fixture(scope="module")
def stand_in(tmp_path_factory):
    """The environment of a process that finds tests/runtime/driver.c for a driver, and the machine code made before."""
    folder = tmp_path_factory.mktemp("driver")
    source = text.device(FOLDER, sea.SOURCE)
    library = by_host(source, folder)
    machine_code.machine_code(source, "sm_90")  # NVRTC looks for the driver too, and takes no stand-in
    driver = ["gcc", "-shared", "-fPIC", "-O1", ROOT / "tests" / "runtime" / "driver.c"]
    subprocess.run([*driver, "-ldl", "-o", folder / "libcuda.so.1"], check=True)
    return {"LD_LIBRARY_PATH": str(folder), "FAKE_FLIGHTS": library._name}


def flown(stand_in, *words, **environment):
    command = [sys.executable, "-c", "from boresight import cli; cli.main()", "many", "--motion", "slope", *words]
    env = {**os.environ, **stand_in, **environment, "PYTHONPATH": str(ROOT)}
    return subprocess.run(command, env=env, capture_output=True, text=True, check=False)


@needs("nvrtc", "g++")
def test_by_a_gpu_the_hash_is_that_of_the_host(stand_in, tmp_path, capsys):
    done = flown(stand_in, "--runs", "40", "--device", "gpu", "--chunk", "17", "--json", "-o", str(tmp_path))
    assert done.returncode == 0, done.stderr
    with pytest.raises(SystemExit):
        cli.main(["many", "--motion", "slope", "--runs", "40", "--json", "-o", str(tmp_path)])  # reads what is kept
    kept = capsys.readouterr().out
    with pytest.raises(SystemExit):
        cli.main(["many", "--motion", "slope", "--runs", "40", "--json"])
    assert json.loads(done.stdout) == json.loads(kept) == json.loads(capsys.readouterr().out)


@needs("nvrtc", "g++")
@pytest.mark.parametrize(
    ("environment", "says"),
    [
        ({"LD_LIBRARY_PATH": ""}, "no driver of an NVIDIA GPU is found here; leave device out"),
        ({"FAKE_COUNT": "0"}, "no NVIDIA GPU is found here; leave device out"),
        ({"FAKE_INIT": "100"}, "no NVIDIA GPU is found here; leave device out"),
        ({"FAKE_CAPABILITY": "35"}, "a GPU of sm_35 is none of those that this NVRTC makes code for"),
        ({"FAKE_MEMORY": "100000"}, "Stand-in has too little memory for these runs; give a chunk of fewer"),
    ],
)
def test_what_no_gpu_can_do_is_one_line(stand_in, environment, says):
    done = flown(stand_in, "--runs", "40", "--device", "gpu", **environment)
    assert done.returncode == 1 and not done.stdout
    assert done.stderr.count("\n") == 1 and says in done.stderr


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"device": "tpu"}, "device is 'tpu'; it is cpu or gpu"),
        ({"device": "gpu", "jobs": 2}, "one process"),
        ({"device": "gpu", "in_c": None}, "sea is written in Python, which flies on the host; a GPU needs it in C"),
        ({"fly": None, "in_c": None}, "sea has nothing that flies: give fly, or in_c with given"),
    ],
)
def test_what_cannot_fly_there_is_refused_before_anything_is_begun(given, says, tmp_path):
    kind = sea.experiment(sea.Sea("slope", 5))
    kind = replace(kind, **{name: given.pop(name) for name in ("fly", "in_c") if name in given})
    with pytest.raises(BoresightError, match=says):
        many(kind, runs=4, directory=tmp_path / "out", **given)
    assert not list(tmp_path.iterdir())


@needs("gpu")
@pytest.mark.parametrize("motion", ["slope", "sea"])
def test_on_a_card_4096_runs_have_the_hash_of_the_host(motion):
    kind = sea.experiment(sea.Sea(motion, 5))
    assert many(kind, runs=4096, device="gpu", chunk=1500) == many(kind, runs=4096, jobs=2)
