"""The flight of examples/flight: one hash here, on other processors and from Python, and near the truth."""

import re
import shutil
import subprocess
import sys
from functools import cache

import numpy as np
import pytest
from conftest import ROOT
from tools import given, lacks, needs

from boresight.codegen.export import exported
from boresight.evidence.targets import GCC, M4F, M7, WARNINGS
from boresight.runtime import rotation
from boresight.runtime.compiler import run
from boresight.runtime.manifest import folder_of

EXAMPLE = ROOT / "examples" / "flight"
DEG, MIL = np.pi / 180, 2 * np.pi / 6400
HEADING, SIGMA, DELAY, DELAY_SIGMA = 1, 2, 6, 7  # columns of a line; 3 to 5 the misalignment


@pytest.fixture(scope="module")
def example():
    """The example's modules, as its scripts see each other."""
    sys.path.insert(0, str(EXAMPLE))
    try:
        import make_recording
        import replay
        import ticks
    finally:
        sys.path.remove(str(EXAMPLE))
    return make_recording, replay.replay, ticks


@pytest.fixture(scope="module")
def filters(tmp_path_factory):
    """The C that is committed; `make generated` holds it against the model."""
    out = tmp_path_factory.mktemp("filters")
    for precision in ("double", "float"):
        exported(folder_of("velocity-attitude"), out / precision, precision, "velocity-attitude", ())
    return out


@pytest.fixture(scope="module")
def minute(example):
    """(what is known, records, truth)"""
    return example[0].record()


@pytest.fixture(scope="module")
def made(example, minute, filters, tmp_path_factory):
    """Lines of `make TARGET` with a filter, in a copy of the example with the recording in place; each flown once."""
    folders = {}

    def fly(target, precision, compiler, runs, shift, may_fail, records=None):
        key = precision, compiler
        if key not in folders:
            folders[key] = tmp_path_factory.mktemp("make") / "flight"
            shutil.copytree(EXAMPLE, folders[key], ignore=shutil.ignore_patterns("build", "__pycache__"))
            (folders[key] / "build").mkdir()
        file = folders[key] / "build" / "minute.bin"
        example[0].write(file, minute[0], minute[1] if records is None else records)
        command = ["make", "-s", target, f"FILTER={filters / precision}", f"PYTHON={sys.executable}", f"CC={compiler}",
                   f"CFLAGS=-O0 -Werror{' -static' * bool(runs)}", f"RUN={runs}", f"SHIFT={shift}"]  # fmt: skip
        done = subprocess.run(command, cwd=folders[key], capture_output=True, text=True, timeout=100, check=False)
        assert may_fail or done.returncode == 0, done.stdout + done.stderr
        return (done.stdout + done.stderr).splitlines()

    once = cache(fly)

    def make(target, precision="double", compiler="gcc", runs="", shift=3, may_fail=False, records=None):
        flight = target, precision, compiler, runs, shift, may_fail
        return once(*flight) if records is None else fly(*flight, records)

    return make


@pytest.fixture(scope="module")
def replayed(example, minute):
    """The loop that has flown the minute from Python, by precision; each flown once."""
    return cache(lambda precision: example[1](*minute[:2], precision))


@pytest.fixture(scope="module")
def flown(made):
    """Lines of the flight here, by precision: (S, 8)."""
    printed = {precision: made("run", precision) for precision in ("double", "float")}
    return {name: np.array([line.split() for line in lines if re.match(r" +\d+ ", line)], float)
            for name, lines in printed.items()}  # fmt: skip


def test_its_files_compile_without_a_warning_with_optimisation(filters, tmp_path):
    for path in EXAMPLE.glob("*.c"):
        if path.stem != "cortex_m":
            include = ("-I", filters / "double" / "include")
            run([GCC.compiler, *WARNINGS, "-O2", *include, "-c", path, "-o", tmp_path / "object"])


def test_main_is_short():
    assert len((EXAMPLE / "main.c").read_text().splitlines()) <= 80


def test_what_happens_is_printed_and_counted(made):
    for precision in ("double", "float"):
        lines = made("run", precision)
        assert [line.strip() for line in lines if line.startswith("     ")] == [
            "begun: 0",
            "a message's velocity: refused",
            "bad sample, status: 2",
            "gap, us: 5000",
            "a message's velocity: taken in part",
        ]
        assert lines[-2].endswith("1178 taken, 1 in part, 1 refused; 1179 corrections, 0 late")


MACHINES = [
    given("clang", ""),
    given("aarch64-linux-gnu-gcc", "qemu-aarch64", also=("qemu-aarch64",)),
    given("arm-linux-gnueabihf-gcc", "qemu-arm", also=("qemu-arm",)),
]


@pytest.mark.parametrize(("compiler", "runs"), MACHINES)
@pytest.mark.parametrize("precision", ["double", "float"])
def test_one_hash_on_every_processor(made, compiler, runs, precision):
    assert made("run", precision, compiler, runs) == made("run", precision)


@needs("arm-none-eabi-gcc", "qemu-system-arm")
@pytest.mark.parametrize(("core", "precision"), [("m7", "double"), ("m4f", "float")])
def test_one_hash_where_an_interrupt_takes_the_samples(made, core, precision):
    """By ticks that are 1 ms, of 250 000 and of 500 000 instructions: the background is interrupted elsewhere."""
    for shift in (2, 1):
        assert made(core, precision, shift=shift) == made("run", precision)


@needs("arm-none-eabi-gcc", "qemu-system-arm")
def test_a_core_that_is_too_slow_has_late_corrections_and_another_hash(made):
    """So the interrupt does interrupt."""
    slow, here = made("m4f", "float", shift=5, may_fail=True), made("run", "float")
    assert int(slow[-2].split()[-2]) > 100 and slow[-1] != here[-1]


@pytest.mark.parametrize("precision", ["double", "float"])
def test_python_has_the_same_hash(replayed, made, precision):
    loop = replayed(precision)
    assert loop.digest() == made("run", precision)[-1]
    assert [line.split(": ", 1)[1] for line in loop.events()][1:] == [
        "a message of velocity was not taken: a number is none, or lies outside its box",
        "a sample was left out: NOT_FINITE",
        "5000 us of samples were missing and are bridged",
        "a message of velocity was in part taken: some rows lay beyond the gate",
    ]


def test_a_billionth_of_one_increment_changes_the_hash(minute, made):
    other = minute[1].copy()
    other[7000, 2] *= 1 + 1e-9
    assert made("run", records=other)[-1] != made("run")[-1]


def test_heading_misalignment_and_delay_are_those_of_the_hull(minute, flown):
    setup, _, truth = minute
    lines = flown["double"]
    per_second = round(1 / setup.dt)
    C = rotation.matrix_from_quaternion(truth.q_b2n_wxyz[per_second::per_second])
    error = np.remainder(lines[:, HEADING] * DEG - rotation.euler_from_matrix(C)[:, 2] + np.pi, 2 * np.pi) - np.pi
    assert len(lines) == 60 and (np.abs(error / MIL) < 3.5 * lines[:, SIGMA]).all()
    assert np.abs(error[-1]) < 0.5 * MIL and lines[-1, SIGMA] < 0.2
    mu = rotation.vector_from_matrix(rotation.matrix_from_quaternion(truth.q_b2m_wxyz)) / DEG
    np.testing.assert_allclose(lines[-1, 3:6], mu, atol=0.03)  # deg; the level parts with the accelerometer biases
    assert (np.abs(lines[:, DELAY] - 1e3 * truth.tau) < 3.5 * lines[:, DELAY_SIGMA]).all()
    assert lines[-1, DELAY_SIGMA] < 0.15


def test_in_float_the_flight_stays_within_a_fraction_of_its_sigmas(replayed, flown):
    """Each sample adds the Earth's rate to a rounded quaternion, and is rounded in the same direction each time: by
    2^-25 of a component at most, 1.2e-5 rad/s at 200 Hz.  The gyro biases take it, two of their sigmas."""
    exact, rounded = flown["double"], flown["float"]
    apart = np.abs(rounded - exact)
    # in the first ten seconds what errors of H may have told is decided otherwise here and there
    part = np.where(np.arange(len(exact)) < 10, 0.5, 0.2)
    assert (apart[:, HEADING] * DEG / MIL < part * exact[:, SIGMA]).all()
    assert (apart[:, DELAY] < part * exact[:, DELAY_SIGMA]).all()
    for column in (SIGMA, DELAY_SIGMA):
        off = np.abs(rounded[:, column] / exact[:, column] - 1)
        assert off[:10].max() < 0.03 and off[10:].max() < 0.01
    bias = [replayed(precision).output(60_000_000)["gyro_bias"] for precision in ("double", "float")]
    assert np.abs(bias[1] - bias[0]).max() < 1.2e-5


def until(records, seconds):
    return records[records[:, 1] <= seconds * 1e6]


def test_a_master_that_stays_silent_leaves_the_flight_not_begun(example, minute, made):
    lines = made("run", records=until(minute[1][minute[1][:, 0] == example[0].SLAVE], 2), may_fail=True)
    assert not [line for line in lines if re.match(r" +\d+ ", line)]
    assert [line for line in lines if line.startswith("0 samples")]


def test_messages_that_come_twice_change_the_counts_alone(example, minute):
    make_recording, replay, _ = example
    part = until(minute[1], 3)
    once = replay(minute[0], part)
    again = replay(minute[0], np.repeat(part, np.where(part[:, 0] == make_recording.MASTER, 2, 1), axis=0))
    for name, value in once.output(3_000_000).items():
        np.testing.assert_array_equal(value, again.output(3_000_000)[name])
    messages = int((part[:, 0] == make_recording.MASTER).sum())
    assert again.counts()["TWICE"] == 2 * messages - 1 - 1  # the first begins the flight; its copy is measured


@needs("arm-none-eabi-gcc")
@pytest.mark.parametrize(("target", "precision"), [(M7, "double"), (M4F, "float")])
def test_a_call_costs_what_the_readme_says(example, filters, tmp_path, target, precision):
    _, replay, ticks = example
    core = ticks.flown(target, filters / precision, tmp_path)
    setup, records, _ = example[0].record(seconds=ticks.SECONDS)
    assert core.digest() == replay(setup, records, precision).digest()
    readme = (EXAMPLE / "README.md").read_text()
    lines = ticks.table(core)
    if M7.version not in readme:
        lacks("the compiler of the README's figures", f"to the instruction they are of another than {M7.version}")
    assert "\n".join(lines) in readme, "the README's figures are of other code: take those of 'make ticks'"
