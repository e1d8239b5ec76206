"""verify can fail: a constant off by 1e-12, a flipped sign, a lost bit, each turns it red."""

import os
import re
import shutil
import signal
import subprocess
import sys
from collections import defaultdict

import pytest
import sympy as sp
from building import spoil
from conftest import ROOT

from boresight import BoresightError
from boresight.codegen.functions import reference
from boresight.codegen.functions.units import units
from boresight.codegen.generate import load_model
from boresight.codegen.mechanics import MechanicsCheck
from boresight.codegen.verify import (
    WIDEST,
    FirstOrderCheck,
    Part,
    UnitCheck,
    check_points,
    prepare,
    relative_width,
    verify,
    verify_all,
)
from boresight.runtime import compiler
from boresight.runtime.library import load


@pytest.fixture(scope="module")
def failed(compiled_once, tmp_path_factory):
    """unit -> the checks that fail, of a folder in which four units are spoilt, each in its own way."""
    folder = shutil.copytree(ROOT / "generated" / "euler_matching", tmp_path_factory.mktemp("spoilt") / "em")
    for path in ("src/em_omega_in_n_kernel.h", "casadi/em_omega_in_n_casadi.c"):
        (constant,) = set(re.findall(r"7\.2921\d*e-05", (folder / path).read_text()))  # the Earth's rate
        spoil(folder, path, constant, repr(float(constant) * (1 + 1e-12)))
    spoil(folder, "src/em_euler_H_kernel.h", "= -cos_yaw_b", "= cos_yaw_b")
    # (-a) * b against -(a * b) is the same; a * b * c in another order is not
    path = "src/em_strapdown_kernel.h"
    product = "q_b2n_wxyz[0] * q_body_w"
    spoil(folder, path, f"= {product};", f"= (({product}) * BS_REAL(3.0)) / BS_REAL(3.0);")
    spoil(folder, "src/em_F_kernel.h", "F_nz[5] = ", "F_nz[5] = BS_REAL(0.0) * ")
    found = defaultdict(list)
    for check in verify("euler-matching", folder, 100):
        if not check.ok:
            found[check.unit].append(check)
    return found


def test_what_is_spoilt_is_found_and_nothing_else(failed):
    assert set(failed) == {"omega_in_n", "euler_H", "strapdown", "F"}


def test_the_committed_c_passes():
    checks = verify("euler-matching", points=40)
    assert all(check.ok for check in checks)
    assert {type(check) for check in checks} == {UnitCheck, FirstOrderCheck, MechanicsCheck}
    # a bound that is a thousand times too large would prove little
    assert all(check.looseness < 100 for check in checks if isinstance(check, UnitCheck) and check.largest_error > 0)


def test_a_constant_off_by_1e_12_is_found_in_both_prints(failed):
    (check,) = failed["omega_in_n"]
    assert check.same_bits and check.looseness < 1


def test_a_flipped_sign_is_found(failed):
    assert [type(check) for check in failed["euler_H"]] == [UnitCheck, FirstOrderCheck]


def test_one_operation_in_another_order_is_found_by_its_bits(failed):
    (check,) = failed["strapdown"]
    assert not check.same_bits and check.looseness >= 1


def test_an_element_left_out_is_found(failed):
    (check,) = failed["F"]
    assert not check.same_bits and check.looseness < 1


def test_verify_flies_what_is_on_disk(em_copy):
    (em_copy / "src" / "em_F.c").write_text("")
    with pytest.raises(BoresightError, match="edited"):
        verify("euler-matching", em_copy, 10)


def test_a_reference_of_thirty_digits_is_found(monkeypatch):
    monkeypatch.setattr(reference, "GUARD", 30 - reference.DIGITS)
    checks = [check for check in verify("euler-matching", points=40) if isinstance(check, UnitCheck)]
    found = {check.unit: check for check in checks if not check.ok}
    assert found["strapdown"].width > WIDEST
    # but not in the C, which is as good as before
    assert all(check.same_bits and check.looseness >= 1 for check in found.values())


@pytest.mark.parametrize(
    "expression, at",
    [
        ("10**50 * (sin(x)**2 + cos(x)**2 - 1) + 1", 0.3),  # the digits cancel
        ("x / x**2 - 1 / x", 0.0),  # no number
    ],
)
def test_a_reference_that_is_not_known_is_wide(expression, at):
    x = sp.Symbol("x", real=True)
    matrix = sp.Matrix([sp.sympify(expression, {"x": x}, evaluate=False)])
    (entries,) = reference.evaluator([x], [matrix])([at])
    assert relative_width(entries) > WIDEST


def test_shares_of_the_points_are_the_whole():
    model = load_model("euler-matching")
    flight, casadi = (load("euler-matching", backend, lanes=1) for backend in ("flight", "casadi"))
    unit = next(unit for unit in units(model) if unit.name == "euler_H")
    case = prepare(model, unit, flight, casadi, 50)
    whole = check_points(case, 0, 1)
    assert whole.largest_error > 0
    assert sum((check_points(case, share, 3) for share in range(3)), Part()) == whole


def test_the_progress_counts_the_functions_of_all_models():
    seen = []
    targets = [("strapdown", None), ("euler-matching", None)]
    checks = verify_all(targets, 10, lambda done, total, text: seen.append((done, total)))
    count = sum(isinstance(check, UnitCheck) for check in checks)
    assert seen == [(k, count) for k in range(1, count + 1)]
    assert [check.model for check in checks] == sorted((check.model for check in checks), reverse=True)


INTERRUPTED = """
import signal
import time
from boresight.codegen.verify import verify
from boresight.runtime import compiler
compiler.FLAGS = {}
signal.signal(signal.SIGINT, signal.default_int_handler)  # which is ignored in what a shell runs behind it
def begun(*_):
    print("begun", flush=True)
    time.sleep(60)  # it does not end before the interrupt comes, which may take its time
try:
    verify("euler-matching", points=10_000, progress=begun)
except KeyboardInterrupt:
    print("interrupted")
"""


def test_an_interrupted_verify_leaves_no_process_and_no_line():
    command = [sys.executable, "-c", INTERRUPTED.format(compiler.FLAGS)]
    with subprocess.Popen(command, stdout=-1, stderr=-1, text=True, start_new_session=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "begun\n"
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does
        out, err = process.communicate(timeout=60)
    assert out.splitlines()[-1] == "interrupted"
    assert err == ""
    with pytest.raises(ProcessLookupError):
        os.killpg(process.pid, 0)
