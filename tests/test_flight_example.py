"""The flight in C of examples/flight: equal to its Python, here and on emulated cores, and near the truth."""

import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT
from tools import lacks, needs

from boresight.codegen.export import exported
from boresight.evidence.targets import GCC, M4F, M7, WARNINGS
from boresight.runtime import rotation, transfer
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
        import flight
        import make_recording
        import ticks
    finally:
        sys.path.remove(str(EXAMPLE))
    return make_recording, flight, ticks


@pytest.fixture(scope="module")
def filters(quickly, tmp_path_factory):
    """The C that is committed; `make generated` holds it against the model."""
    out = tmp_path_factory.mktemp("filters")
    for precision in ("double", "float"):
        exported(folder_of("velocity-attitude"), out / precision, precision, "")
    return out


@pytest.fixture(scope="module")
def minute(quickly, example):
    """(what is known, records, truth)"""
    return example[0].record()


@pytest.fixture(scope="module")
def brief(quickly, example, tmp_path_factory):
    """(file, what is known, records) of 15 s, in which all happens that happens in the minute."""
    make_recording, *_ = example
    path = tmp_path_factory.mktemp("recording") / "minute.bin"
    setup, records, _ = make_recording.record(seconds=15.0)
    make_recording.write(path, setup, records)
    return path, setup, records


def test_a_folder_in_single_precision_is_flown_on_the_m4f_too(example, filters):
    assert [example[2].in_float(filters / precision) for precision in ("double", "float")] == [False, True]


@pytest.fixture(scope="module")
def here(example, filters, tmp_path_factory):
    """A flight on this machine: of records in a precision.  Without optimisation, whose bits are the same."""
    ticks = example[2]
    cores = {}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(ticks, "OPTIMISED", ("-O0",))
        for precision in ("double", "float"):
            image = ticks.compiled(GCC, filters / precision, tmp_path_factory.mktemp(precision))
            cores[precision] = ticks.Here(image)
    return lambda setup, records, precision="double": ticks.fly(cores[precision], setup, records)


@pytest.fixture(scope="module")
def flown(minute, here):
    return {precision: here(*minute[:2], precision) for precision in ("double", "float")}


@pytest.fixture(scope="module")
def by_python(example, brief):
    return example[1].fly(brief[0])


@pytest.fixture(scope="module")
def made(filters, brief, tmp_path_factory):
    """Lines of `make TARGET`, in a copy of the example with the recording in place."""
    copy = tmp_path_factory.mktemp("make") / "flight"
    shutil.copytree(EXAMPLE, copy, ignore=shutil.ignore_patterns("build", "__pycache__"))
    (copy / "build").mkdir()
    shutil.copy(brief[0], copy / "build" / "minute.bin")

    def make(target):
        command = [
            "make",
            "-s",
            target,
            f"FILTER={filters / 'double'}",
            f"PYTHON={sys.executable}",
            "CFLAGS=-O0 -Werror",
        ]
        done = subprocess.run(command, cwd=copy, capture_output=True, text=True, timeout=100, check=False,
                              env={**os.environ, "PYTHONPATH": str(ROOT)})  # fmt: skip
        assert done.returncode == 0, done.stdout + done.stderr
        return (done.stdout + done.stderr).splitlines()

    return make


def test_python_and_c_are_the_same_flight(brief, by_python, here):
    """Bound: 6000 strapdown steps of an ulp of a quaternion's component, 1.1e-16 and twice that in angle, that all
    add up: 1.3e-12 rad, 7.6e-11 deg; a sigma, and with it what the filter takes from a message, to 1e-9 of itself."""
    python, c = by_python, here(*brief[1:]).lines
    assert python.shape == c.shape == (15, 8)
    np.testing.assert_allclose(c[:, HEADING], python[:, HEADING], rtol=0, atol=7.6e-11)
    for column in (SIGMA, DELAY_SIGMA):
        np.testing.assert_allclose(c[:, column], python[:, column], rtol=1e-9)
    bound = 1e-9 * np.column_stack([np.full((15, 3), 2.0), c[:, DELAY]])
    assert (np.abs(c[:, 3:7] - python[:, 3:7]) < bound).all()


@pytest.mark.digits
def test_the_program_prints_what_python_prints(example, by_python, made):
    printed = [line for line in made("run") if re.match(r" +\d+ ", line)]
    assert printed == [example[1].LINE.format(int(line[0]), *line[1:]) for line in by_python]


def test_its_files_compile_without_a_warning_with_optimisation(filters, tmp_path):
    for name in ("flight", "main"):
        include = ("-I", filters / "double" / "include")
        run([GCC.compiler, *WARNINGS, "-O2", "-Werror", *include, "-c", EXAMPLE / f"{name}.c", "-o", tmp_path / name])


def test_what_is_not_a_number_is_refused_and_told(example, brief, flown, made):
    # the message in the middle, velocity alone; one interval of the slave
    for precision in ("double", "float"):
        assert [status for _, status in flown[precision].statuses] == [2, 2]
    _, setup, records = brief
    messages = records[:, 0] == example[0].MASTER
    ticks = np.cumsum(~messages)
    bad = [f"{tick * setup.dt:.4f}" for tick in ticks[np.isnan(records).any(axis=1)]]
    told = [line for line in made("run") if "refused: status" in line or "refused, or" in line]
    assert [line.split(":")[0].strip() for line in told] == bad and len(bad) == 2
    taken = messages.sum() - 3  # the first starts the flight
    expected = f"{ticks[-1]} ticks, 1 held; {taken} messages taken, 2 in part, 0 refused; starts: 1"
    assert made("run")[-1] == expected


def test_heading_misalignment_and_delay_are_those_of_the_hull(minute, flown):
    setup, _, truth = minute
    lines = flown["double"].lines
    per_second = round(1 / setup.dt)
    C = rotation.matrix_from_quaternion(truth.q_b2n_wxyz[per_second::per_second])
    error = np.remainder(lines[:, HEADING] * DEG - rotation.euler_from_matrix(C)[:, 2] + np.pi, 2 * np.pi) - np.pi
    assert (np.abs(error / MIL) < 3.5 * lines[:, SIGMA]).all()
    assert np.abs(error[-1]) < 0.5 * MIL and lines[-1, SIGMA] < 0.2
    mu = rotation.vector_from_matrix(rotation.matrix_from_quaternion(truth.q_b2m_wxyz)) / DEG
    np.testing.assert_allclose(lines[-1, 3:6], mu, atol=0.03)  # deg; the level parts with the accelerometer biases
    assert (np.abs(lines[:, DELAY] - 1e3 * truth.tau) < 3.5 * lines[:, DELAY_SIGMA]).all()
    assert lines[-1, DELAY_SIGMA] < 0.15


def test_transfer_which_keeps_more_of_the_past_agrees(example, minute, flown):
    """`transfer.Transfer` carries the covariance back to the message and corrects its past; its means are longer."""
    make_recording, flight, _ = example
    setup, records, _ = minute
    R = np.repeat([setup.velocity_sigma, setup.attitude_sigma], 3) ** 2
    begun, loop, tick = flight.Flight(setup, 1), None, 0
    for kind, *values in records:
        values = np.array(values)
        if kind == make_recording.MASTER and loop is None:
            begun.start(values)
            nav, P = begun.loop.nav, begun.loop.P
            loop = transfer.Transfer(begun.model, nav, P, begun.constants, time=tick * setup.dt, every=8)
        elif kind == make_recording.MASTER:
            loop.master(transfer.Message(tick * setup.dt - values[0], R, position=values[1:4], v_m_n=values[4:7],
                                         q_m2n_wxyz=values[7:11]))  # fmt: skip
        else:
            tick += 1
            if loop is not None:
                loop.slave(tick * setup.dt, values[:3], values[3:6], setup.dt)
            if tick == 15 * 400:
                break
    line = flown["double"].lines[14]
    C = rotation.matrix_from_quaternion(loop.nav["q_b2n_wxyz"])
    heading, sigma = rotation.euler_from_matrix(C)[2], np.sqrt(np.diag(loop.P))
    assert abs(heading - line[HEADING] * DEG) < 0.5 * sigma[2]
    assert abs(loop.nav["tau"] - 1e-3 * line[DELAY]) < 0.5 * sigma[15]
    np.testing.assert_allclose([line[SIGMA] * MIL, 1e-3 * line[DELAY_SIGMA]], sigma[[2, 15]], rtol=0.1)


def test_in_float_heading_stays_within_a_fraction_of_its_sigma(flown):
    """Heading by a tenth, delay by a twentieth of its sigma; the sigmas themselves by 1e-4."""
    exact, rounded = flown["double"].lines, flown["float"].lines
    apart = np.abs(rounded - exact)
    assert (apart[:, HEADING] * DEG / MIL < 0.1 * exact[:, SIGMA]).all()
    assert (apart[:, DELAY] < 0.05 * exact[:, DELAY_SIGMA]).all()
    for column in (SIGMA, DELAY_SIGMA):
        np.testing.assert_allclose(rounded[:, column], exact[:, column], rtol=1e-4)


@pytest.mark.parametrize("precision", ["double", "float"])
def test_a_master_that_begins_wrong_is_begun_anew(example, minute, here, precision):
    """Its first message is off by 40 degrees in heading; five messages later the flight begins again."""
    make_recording, *_ = example
    setup, records, _ = minute
    wrong = records[: 10 * 411].copy()
    first = np.flatnonzero(wrong[:, 0] == make_recording.MASTER)[0]
    wrong[first, 8:12] = rotation.turned(wrong[first, 8:12], np.array([0.0, 0.0, 40 * DEG]))
    right, lines = here(setup, records[: 10 * 411], precision).lines, here(setup, wrong, precision).lines
    assert abs(lines[-1, HEADING] - right[-1, HEADING]) * DEG < 2 * lines[-1, SIGMA] * MIL
    assert not np.array_equal(lines, right)


def test_a_master_that_stays_silent_leaves_the_flight_not_begun(minute, here):
    setup, records, _ = minute
    assert here(setup, records[records[:, 0] == 0][:800]).lines.size == 0


def test_messages_that_come_too_soon_are_refused(example, minute, here):
    """The same message again at the tick that took it changes nothing."""
    make_recording, *_ = example
    setup, records, _ = minute
    part = records[: 3 * 411]
    twice = np.repeat(part, np.where(part[:, 0] == make_recording.MASTER, 2, 1), axis=0)
    np.testing.assert_array_equal(here(setup, twice).lines, here(setup, part).lines)


@needs("arm-none-eabi-gcc", "qemu-system-arm")
def test_the_program_prints_the_same_on_an_emulated_cortex_m7(made):
    assert made("m7") == made("run")


@needs("arm-none-eabi-gcc")
@pytest.mark.parametrize(("target", "precision"), [(M7, "double"), (M7, "float"), (M4F, "float")])
def test_emulated_cores_fly_the_same_bits_and_cost_what_the_readme_says(
    example, filters, minute, flown, tmp_path, target, precision
):
    ticks = example[2]
    setup, records, _ = minute
    core = ticks.Emulated(target, ticks.compiled(target, filters / precision, tmp_path), filters / precision)
    there = ticks.fly(core, setup, ticks.first_seconds(setup, records))
    # sin and cos are the target's library's; an ulp of theirs grows no more than one of the strapdown's
    np.testing.assert_allclose(there.lines, flown[precision].lines[:5], rtol=1e-10 if precision == "double" else 1e-5)
    readme = (EXAMPLE / "README.md").read_text()
    row = re.search(rf"\| {target.name} \| {precision} \|([\d |]+)\|\n", readme)
    assert row, f"the README says nothing of {target.name} in {precision}"
    most = [int(there.cost[there.kind == kind].max()) for kind in range(3)]
    said = [int(word.replace(" ", "")) for word in row[1].split("|")]
    found = [*most, core.stack]
    assert np.abs(np.array(found) / said - 1).max() < 0.25, f"the README says {said}, found {found}: see 'make ticks'"
    if M7.version not in readme:
        lacks("the compiler of the README's figures", f"to the instruction they are of another than {M7.version}")
    assert found == said, "the README's figures are of other code: take those of 'make ticks'"
