"""The shipped C on the machines it is for: no warning, no double, the same bits, the committed cost."""

import pytest
from committed import LIVE, SMALL, committed, comparable, folder_of, spoilt
from tools import needs

from boresight import BoresightError
from boresight.evidence.golden import faults, golden
from boresight.evidence.targets import CLANG, CORES, GCC, PRECISIONS, build, compile_units

EVERY_COMPILER = needs("clang", "arm-none-eabi-gcc")


@pytest.mark.parametrize("name", SMALL)
def test_golden_vectors_pass_with_the_same_bits_on_each_target(name):
    """Two compilers here, Cortex-M4F and M7, both precisions; that the results are of the committed C: test_results."""
    targets = {f"{target.name} {precision}" for target in (GCC, CLANG, *CORES) for precision in PRECISIONS}
    found = committed(name, "golden")
    wrong = [word for unit, of in found.items() for word in faults(unit, of)]
    wrong += [unit for unit, of in found.items() if set(of["builds"]) != targets]
    assert found and not wrong, "\n".join(wrong)


@pytest.mark.digits
@EVERY_COMPILER
def test_a_live_run_finds_what_is_committed(tmp_path):
    assert golden(folder_of(LIVE), tmp_path) == comparable(LIVE, "golden")


def test_a_warning_is_an_error(em_copy, tmp_path):
    folder = spoilt(em_copy, "src/em_F_kernel.h", "-omega_in_n[1]", "-omega_in_n[1] * 1.5")
    with pytest.raises(BoresightError, match="float"):
        compile_units(folder, GCC, "float", tmp_path)


@EVERY_COMPILER
def test_double_in_a_float_build_and_a_dearer_call_are_seen(em_copy, tmp_path):
    # a cast keeps the compilers quiet about it
    folder = spoilt(em_copy, "src/em_F_kernel.h", "-omega_in_n[1]", "(bs_real)((double)-omega_in_n[1] + 1e-30)")
    found = golden(folder, tmp_path, ("em_F", "em_Phi"))
    assert any(word.startswith("cortex-m4f float: __aeabi_dadd") for word in found["em_F"]["doubles"])
    assert any(word.startswith("cortex-m7 float: vadd.f64") for word in found["em_F"]["doubles"])
    assert not found["em_Phi"]["doubles"]
    assert any("__aeabi_dadd" in word for word in faults("em_F", found["em_F"]))
    before = comparable("euler_matching", "golden")
    assert found["em_F"]["cost"] != before["em_F"]["cost"]
    assert found["em_Phi"]["cost"] == before["em_Phi"]["cost"]


@needs("arm-none-eabi-gcc")
@pytest.mark.parametrize("core", CORES, ids=lambda core: core.name)
def test_blocks_are_counted_as_single_steps_are(core, tmp_path):
    """Instructions by blocks and their length, against a hook on each instruction.

    The hook leaves out a conditional instruction whose condition fails; the core fetches it, and so it counts.
    """
    import unicorn

    from boresight.evidence.machine import Machine
    from boresight.evidence.targets import public_functions

    made = build(folder_of("strapdown"), core, "float", tmp_path)
    machine = Machine(made, made.image, tuple(public_functions(made.objects["sd_step"])))
    steps, conditional = 0, set()

    def step(emulator, address, size, _):
        nonlocal steps
        if not machine.frames or address in conditional:
            return
        steps += 1
        half = int.from_bytes(emulator.mem_read(address, 2), "little")
        if half >> 8 == 0xBF and half & 0xF:  # if-then: its mask says for how many instructions
            for _ in range(4 - (half & -half).bit_length() + 1):
                address += size
                conditional.add(address)
                steps += 1
                size = 4 if int.from_bytes(emulator.mem_read(address, 2), "little") >> 11 in (29, 30, 31) else 2

    machine.core.hook_add(unicorn.UC_HOOK_CODE, step)
    machine.call("test_sd_step")
    assert steps == machine.counts[0] > 10000
    assert machine.costs["sd_step_f32"].calls > 64
