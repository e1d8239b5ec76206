"""What the committed analyses found, and that they can find something."""

import pytest
from committed import NAMES, SMALL, committed, folder_of, spoilt
from tools import needs

from boresight import BoresightError
from boresight.codegen import deviations
from boresight.evidence import eva, misra, trace
from boresight.evidence.table import PAGE, page

# The Jacobians of exact Euler angles or quaternions lose their meaning inside the box, at a pitch of 90 deg; the
# analysis is right to warn.  In a strapdown step intervals are too wide for a quotient of what belongs together.
WARNED = {"em_euler_exact_H", "va_quaternion_H", "val_quaternion_H", "sd_step"}
WARNED |= {f"{prefix}_strapdown" for prefix in ("ah", "ahr", "va", "val", "vd")}


@pytest.mark.parametrize("name", NAMES)
def test_every_statement_is_traced_both_ways(name, tmp_path):
    for unit, of in trace.trace(folder_of(name), tmp_path).items():
        assert not of["missing"], f"{unit}: {of['missing']}"
    printed = [unit.name for unit in folder_of(name).units if unit.described is not None]
    assert sorted(committed(name, "trace")) == sorted(printed)


@pytest.mark.parametrize(
    ("path", "right", "wrong", "word"),
    [
        ("src/em_F_kernel.h", "F_nz[1] = t1;", "F_nz[1] = t3;", "const bs_real t1 = -omega_in_n[1]; reaches no output"),
        (
            "src/em_F_kernel.h",
            "    F_nz[5] = t3; /* eps_d, eps_e */\n",
            "",
            "F: 5 non-zeros written, 6 in the manifest",
        ),
        ("src/em_F_kernel.h", "= -omega_in_n[1]", "= -dtheta_ib_b[1]", "dtheta_ib_b is read and is no field"),
        ("selftest/test_em_F.c", "at_F[6] = { 1, ", "at_F[6] = { ", "F: 5 of 6 non-zeros in the test"),
    ],
)
def test_a_broken_trace_is_named(path, right, wrong, word, em_copy, tmp_path):
    assert word in trace.trace(spoilt(em_copy, path, right, wrong), tmp_path)["em_F"]["missing"]


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("    em_euler_exact_h_kernel_1(x, mu, euler_b,", "    em_euler_exact_h_kernel_1(x, euler_b, mu,"),
        ("    em_euler_exact_h_kernel_1(x, mu, euler_b, &shared);\n", ""),
    ],
)
def test_functions_of_a_kernel_are_called_in_order_with_their_own_parameters(right, wrong, em_copy, tmp_path):
    with pytest.raises(BoresightError, match=r"em_euler_exact_hx_kernel\.h: its functions are not called"):
        trace.trace(spoilt(em_copy, "src/em_euler_exact_hx_kernel.h", right, wrong), tmp_path)


def test_a_citation_that_no_ledger_has_is_seen():
    assert trace.known("song-lee-2001 (20)")
    assert not trace.known("song-lee-2001 (99)")
    assert not trace.known("nobody-1900 (1)")
    assert trace.known("mechanics (phi-4)") and not trace.known("mechanics (phi-9)")


@pytest.mark.parametrize("name", NAMES)
def test_misra_is_broken_only_where_there_is_a_reason(name):
    """Kernels deviate from five rules; the loops from more, each in lines that a reason is tied to."""
    results = committed(name, "misra")
    loops = {unit for unit in results if unit == "include" or unit.endswith(("_covariance", "_filter", "_live"))}
    assert len(deviations.EVERYWHERE) <= 5
    assert not {unit: wrong for unit, of in results.items() if (wrong := deviations.broken(of))}
    assert all(set(of["rules"]) <= set(deviations.EVERYWHERE) for unit, of in results.items() if unit not in loops)


@pytest.mark.parametrize(
    ("rule", "right", "wrong"),
    [
        ("9.3", "bs_real more[N] = { BS_REAL(0.0) };", "bs_real more[N] = { BS_REAL(1.0) };"),
        ("10.3", "these += 8;", "these = 8;"),
        ("10.6", "live->opening = (live->unknown > 0) ? 1U : 0U;", "live->opening = live->seen + 1U;"),
        ("10.8", "if ((int32_t)(mail->due - live->count) <= 0) {", "x = (int32_t)(a + b);"),
        ("12.3", "uint32_t samples, missing, held; /* all */", "for (i = 0, j = 0; i < n; ++i) {"),
    ],
)
def test_a_reason_covers_no_other_line(rule, right, wrong):
    assert deviations.of_finding(rule, right)
    assert not deviations.of_finding(rule, wrong)
    assert deviations.broken({"rules": {rule: [right, wrong], "15.5": 3}}) == [f"{rule} x1"]


@needs("cppcheck")
def test_misra_sees_a_spoilt_unit(em_copy, tmp_path):
    folder = spoilt(em_copy, "src/em_F.c", "bs_status status;\n", "bs_status status;\n    int octal = 017;\n")
    folder.__dict__["manifest"] = folder.manifest | {"files": ["src/em_F.c"]}  # of one unit: a folder takes minutes
    assert "7.1" in misra.misra(folder, tmp_path)["em_F"]["rules"]


@pytest.mark.parametrize("name", SMALL)
def test_no_alarm_but_where_it_is_said(name):
    for unit, of in committed(name, "eva").items():
        assert of["alarms"] == 0 or unit in WARNED, f"{unit}: {of}"


@needs("frama-c")
@pytest.mark.parametrize(
    ("path", "right", "wrong"),
    [
        ("src/em_omega_in_n_kernel.h", "(lat[0], &sin_lat, &cos_lat)", "(lat[0], &cos_lat, &sin_lat)"),
        ("src/em_omega_in_n.c", "for (int i = 0; i < 3; ++i)", "for (int i = 0; i < 4; ++i)"),
    ],
)
def test_an_unsafe_unit_raises_an_alarm(path, right, wrong, em_copy, tmp_path):
    from boresight.codegen.functions.units import units
    from boresight.codegen.generate import load_model

    folder = spoilt(em_copy, path, right, wrong)
    unit = next(unit for unit in folder.units if unit.name == "em_omega_in_n")
    made = next(made for made in units(load_model("euler-matching")) if made.name == "omega_in_n")
    assert eva.of_unit(unit, made, tmp_path)["alarms"] > 0


@pytest.mark.parametrize("name", NAMES)
def test_riscv_had_the_same_bits(name):
    for unit, of in committed(name, "riscv").items():
        for where, was in of["builds"].items():
            assert was["bits"], f"{unit} on {where}: {was}"
            assert was["failures"] == 0, f"{unit} on {where}"


def test_the_page_is_that_of_the_results():
    assert page(PAGE.read_text()) == PAGE.read_text(), "docs/evidence.md: run 'make evidence'"
