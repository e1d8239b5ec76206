"""The shipped C on the machines it is for: no warning, no double, the same bits, the committed cost."""

import importlib.util

import pytest
from committed import NAMES, folder_of, spoilt

from boresight import BoresightError
from boresight.evidence import results
from boresight.evidence.golden import SOFT_ULPS, allowed_ulps, golden
from boresight.evidence.targets import CLANG, CORES, GCC, M4F, PRECISIONS, build, compile_units, run_on_host

MISSING = M4F.missing or ("" if importlib.util.find_spec("unicorn") else "unicorn is not installed")


@pytest.mark.skipif(bool(CLANG.missing), reason="clang is not installed")
@pytest.mark.parametrize("name", NAMES)
def test_clang_has_no_warning_in_float(name, tmp_path):
    """The other three of two compilers and two precisions are built elsewhere, under the same flags."""
    compile_units(folder_of(name), CLANG, "float", tmp_path)


@pytest.mark.skipif(bool(MISSING), reason=MISSING or "-")
@pytest.mark.parametrize("name", NAMES)
def test_golden_vectors_bits_and_cost_on_each_target(name, tmp_path):
    """Compiled with every warning an error, for Cortex-M4F and M7 in both precisions, and run there."""
    found, wrong = golden(folder_of(name), tmp_path), []
    committed = results.read(folder_of(name)).get("golden")
    assert committed, f"nothing is committed of {name}: run 'make evidence'"
    comparable = committed["tools"] == M4F.version
    for unit, of in found.items():
        assert of["builds"], f"{unit} has no self-test"
        wrong += [f"{unit}: {word}" for word in of["doubles"]]
        for where, was in of["builds"].items():
            soft = where == "cortex-m4f double"
            if was["failures"]:
                wrong.append(f"{unit} on {where}: {was['failures']} failures of its self-test")
            if not (was["same_bits"] or soft) or was["same_ulps"] > (SOFT_ULPS if soft else 0):
                wrong.append(f"{unit} on {where}: other bits than here with the same sines")
            if was["ulps"] > allowed_ulps(where, of["libm"]) or not (was["bits"] or of["libm"] or soft):
                wrong.append(f"{unit} on {where}: {was['ulps']} ulps from here")
        if comparable and of["cost"] != committed["units"].get(unit, {}).get("cost"):
            wrong.append(f"{unit} costs {of['cost']}; committed is another figure: run 'make evidence'")
    assert not wrong, "\n".join(wrong)
    if not comparable:
        pytest.skip(f"everything but the cost: it is committed for {committed['tools']}, here is {M4F.version}")


def test_a_warning_is_an_error(em_copy, tmp_path):
    folder = spoilt(em_copy, "src/em_F_kernel.h", "-omega_in_n[1]", "-omega_in_n[1] * 1.5")
    with pytest.raises(BoresightError, match="float"):
        compile_units(folder, GCC, "float", tmp_path)


@pytest.mark.skipif(bool(MISSING), reason=MISSING or "-")
def test_double_in_a_float_build_and_a_dearer_call_are_seen(em_copy, tmp_path):
    # a cast keeps the compilers quiet about it
    folder = spoilt(em_copy, "src/em_F_kernel.h", "-omega_in_n[1]", "(bs_real)((double)-omega_in_n[1] + 1e-30)")
    found = golden(folder, tmp_path)
    assert any(word.startswith("cortex-m4f float: __aeabi_dadd") for word in found["em_F"]["doubles"])
    assert any(word.startswith("cortex-m7 float: vadd.f64") for word in found["em_F"]["doubles"])
    assert not found["em_Phi"]["doubles"]
    committed = results.read(folder_of("euler_matching"))["golden"]["units"]
    if M4F.version == results.read(folder_of("euler_matching"))["golden"]["tools"]:
        assert found["em_F"]["cost"] != committed["em_F"]["cost"]
        assert found["em_Phi"]["cost"] == committed["em_Phi"]["cost"]


@pytest.mark.skipif(bool(MISSING), reason=MISSING or "-")
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
    assert steps == machine.executed > 10000
    assert machine.costs["sd_step"].calls > 64


@pytest.mark.skipif(bool(CLANG.missing), reason="clang is not installed")
def test_clang_and_gcc_agree_in_every_bit_with_the_same_sines(tmp_path):
    from boresight.evidence.targets import same_bits

    for precision in PRECISIONS:
        mine, other = (build(folder_of("strapdown"), host, precision, tmp_path) for host in (GCC, CLANG))
        a, b = run_on_host(mine, mine.same), run_on_host(other, other.same)
        assert all(same_bits(a[unit], b[unit]) for unit in a)
