"""verify can fail: a constant off by 1e-12, a flipped sign, a lost bit, each turns it red."""

import hashlib
import json
import re

import pytest

from boresight import BoresightError
from boresight.codegen.verify import FirstOrderCheck, UnitCheck, verify


def spoil(folder, path, old, new):
    """Edit a generated file and sign the edit in the manifest, as if the generator had made it."""
    text = (folder / path).read_text()
    assert old in text, f"{old} is not in {path}"
    (folder / path).write_text(text.replace(old, new))
    manifest = json.loads((folder / "manifest.json").read_text())
    manifest["files"][path] = hashlib.sha256((folder / path).read_bytes()).hexdigest()
    (folder / "manifest.json").write_text(json.dumps(manifest))


def failed(folder, points=100):
    return {check.unit: check for check in verify("euler-matching", folder, points) if not check.ok}


def test_the_committed_c_passes():
    checks = verify("euler-matching", points=100)
    assert all(check.ok for check in checks)
    assert {type(check) for check in checks} == {UnitCheck, FirstOrderCheck}
    # a bound that is a thousand times too large would prove little
    assert all(check.looseness < 100 for check in checks if isinstance(check, UnitCheck) and check.largest_error > 0)


def test_a_constant_off_by_1e_12_is_found_in_both_prints(em_copy):
    for path in ("src/em_omega_in_n_kernel.h", "casadi/em_omega_in_n_casadi.c"):
        (constant,) = set(re.findall(r"7\.2921\d*e-05", (em_copy / path).read_text()))  # the Earth's rate
        spoil(em_copy, path, constant, repr(float(constant) * (1 + 1e-12)))
    found = failed(em_copy)
    assert set(found) == {"omega_in_n"}
    assert found["omega_in_n"].same_bits
    assert found["omega_in_n"].looseness < 1


def test_a_flipped_sign_is_found(em_copy):
    spoil(em_copy, "src/em_euler_H_kernel.h", "= -cos_yaw_b", "= cos_yaw_b")
    found = failed(em_copy)
    assert set(found) == {"euler_H"}
    assert {type(check) for check in verify("euler-matching", em_copy, 100) if not check.ok} == {
        UnitCheck,
        FirstOrderCheck,
    }


def test_one_operation_in_another_order_is_found_by_its_bits(em_copy):
    # (-a) * b against -(a * b) is the same; a * b * c in another order is not
    kernel = (em_copy / "src" / "em_euler_H_kernel.h").read_text()
    line = next(line.strip() for line in kernel.splitlines() if "= sin_pitch_m * t" in line)
    spoil(
        em_copy,
        "src/em_euler_H_kernel.h",
        line,
        line.replace("= sin_pitch_m *", "= (sin_pitch_m * BS_REAL(3.0)) / BS_REAL(3.0) *"),
    )
    assert not failed(em_copy)["euler_H"].same_bits


def test_an_element_left_out_is_found(em_copy):
    spoil(em_copy, "src/em_F_kernel.h", "F_nz[5] = t", "F_nz[5] = BS_REAL(0.0) * t")
    assert "F" in failed(em_copy)


def test_verify_flies_what_is_on_disk(em_copy):
    (em_copy / "src" / "em_F.c").write_text("")
    with pytest.raises(BoresightError, match="edited"):
        verify("euler-matching", em_copy, 10)
