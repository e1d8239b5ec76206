"""One flight has one hash a precision, whatever compiled it and wherever it is flown."""

import pytest
from committed import committed, folder_of
from tools import TOOLS, needs

from boresight.evidence.bits import (
    EVERY,
    MACHINES,
    MODEL,
    NOT_FLOWN,
    OTHERS,
    SAMPLES,
    V3,
    X86,
    Flown,
    Machinery,
    differs,
    flown,
    in_python,
)
from boresight.evidence.targets import GCC
from boresight.runtime.compiler import PRECISIONS

FEW = 20_000
LEAST, MOST = X86[0], X86[-1]  # gcc -O0, and clang -O3 for x86-64-v3
HERE = (X86[4], MOST)  # gcc -O2


def flight(machine, precision):
    """The machine with the precision, where its compiler, its emulator and its processor are there."""
    asked = [name for name in (machine.target.compiler, machine.runs) if name in TOOLS]
    asked += ["x86-64-v3"] if V3 in machine.flags else []
    return pytest.param(machine, precision, marks=needs(*asked))


# one precision of each, alternately: both of all are committed
EVERYWHERE = [flight(m, m.precisions[k % len(m.precisions)]) for k, m in enumerate((*HERE, *OTHERS))]


@pytest.fixture(scope="module")
def first(tmp_path_factory):
    """The flight by gcc -O0, by precision."""
    out = tmp_path_factory.mktemp("first")
    return {precision: flown(folder_of(MODEL), LEAST, precision, FEW, out) for precision in PRECISIONS}


@pytest.mark.parametrize("precision", PRECISIONS)
def test_a_million_samples_have_one_hash_on_every_machine(precision):
    found = {name: of for name, of in committed(MODEL, "bits").items() if (precision in name.split())}
    found |= {"Python": committed(MODEL, "bits")["Python"]} if precision == "double" else {}
    assert {of["sha256"] for of in found.values()} == {next(iter(found.values()))["sha256"]}
    assert all(of["samples"] == SAMPLES and of["refused"] == of["differs"] == 0 for of in found.values())
    assert not any(any(of["flushed"]) for of in found.values())
    wanted = {f"{machine.name} {precision}" for machine in MACHINES if precision in machine.precisions}
    assert wanted <= set(found)


def test_what_is_not_flown_is_named():
    flown_ones = {f"{machine.name} {precision}" for machine in MACHINES for precision in machine.precisions}
    everything = {f"{machine.name} {precision}" for machine in MACHINES for precision in PRECISIONS}
    assert everything - flown_ones == set(NOT_FLOWN)


@pytest.mark.digits
@pytest.mark.parametrize(("machine", "precision"), EVERYWHERE, ids=lambda value: getattr(value, "name", value))
def test_a_flight_has_the_same_bits_everywhere(machine, precision, first, tmp_path):
    one = flown(folder_of(MODEL), machine, precision, FEW, tmp_path)
    assert differs(one, first[precision]) == 0
    assert (one.refused, one.taken, one.flushed) == (0, first[precision].taken, (False, False))


@pytest.mark.parametrize("precision", PRECISIONS)
def test_the_flight_takes_messages_and_loses_some(precision, first):
    one = first[precision]
    sent = FEW // 128 * 2
    assert one.refused == 0 and sent * 0.6 < one.taken < sent
    assert len(set(one.digests)) == FEW // EVERY


@pytest.mark.digits
def test_python_flies_the_same_bits(first):
    assert differs(in_python(EVERY), Flown(first["double"].digests[:1])) == 0


def test_the_first_ten_thousand_that_differ_are_named():
    one = Flown(("a", "b", "c"))
    assert differs(one, Flown(("a", "b", "c"))) == 0
    assert differs(one, Flown(("a", "x", "y"))) == 2 * EVERY


def test_flushing_to_zero_is_seen(first, tmp_path):
    machine = Machinery(GCC, ("-O0", "-DFLIGHT_FLUSH"))
    one = flown(folder_of(MODEL), machine, "float", FEW, tmp_path)
    assert one.flushed == (True, True) and one.control & 0x8040 == 0x8040


@needs("x86-64-v3")
def test_a_bit_elsewhere_is_seen(first, tmp_path):
    contracted = Machinery(GCC, ("-O2", V3, "-ffp-contract=fast"))
    other = flown(folder_of(MODEL), contracted, "float", FEW, tmp_path)
    assert differs(other, first["float"]) == EVERY
