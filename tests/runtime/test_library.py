"""The compiled library from Python: both backends the same bits, NumPy the same to rounding, and every refusal."""

import os
import re

import numpy as np
import numpy_euler_matching
import pytest
from conftest import ROOT
from tools import tool

from boresight import BoresightError
from boresight.runtime.compiler import shared_library
from boresight.runtime.filter import CompiledFilter
from boresight.runtime.library import build, load
from boresight.runtime.manifest import folder_of, read_manifest
from boresight.runtime.status import Status

WITNESS = numpy_euler_matching.model()


def call(model, name, points):
    unit = getattr(model, name)
    return unit(**{field: points[field] for field in unit.fields})


def same_rotation(q):
    """q and -q are one rotation: make the scalar part positive."""
    return q * np.sign(q[..., :1])


@pytest.mark.parametrize("name", sorted(vars(WITNESS)))
def test_the_c_computes_what_finite_rotations_in_numpy_compute(library, points, name):
    ours, theirs = call(library, name, points), call(WITNESS, name, points)
    ours, theirs = (
        r if isinstance(r, dict) else {"q_b2n_wxyz" if name == "strapdown" else name: r} for r in (ours, theirs)
    )
    for key in ours:
        a, b = (same_rotation(r[key]) if key == "q_b2n_wxyz" else r[key] for r in (ours, theirs))
        # the witness differentiates numerically
        np.testing.assert_allclose(a, b, rtol=0, atol=2e-9 if name == "euler_exact_H" else 5e-14)


@pytest.mark.digits
def test_both_backends_give_the_same_bits(library, points):
    casadi = load("euler-matching", "casadi")
    for name in vars(WITNESS):
        ours, theirs = call(library, name, points), call(casadi, name, points)
        ours, theirs = (r if isinstance(r, dict) else {name: r} for r in (ours, theirs))
        for key in ours:
            assert ours[key].tobytes() == theirs[key].tobytes(), (name, key)


@pytest.mark.parametrize("name", sorted(vars(WITNESS)))
def test_in_float_it_computes_the_same_to_float_rounding(library, points, name):
    single = load("euler-matching", precision="float")
    ours, theirs, double = (call(model, name, points) for model in (single, WITNESS, library))
    ours, theirs, double = (
        r if isinstance(r, dict) else {"q_b2n_wxyz" if name == "strapdown" else name: r} for r in (ours, theirs, double)
    )
    for key, value in ours.items():
        assert value.dtype == np.float32
        a, b = (same_rotation(r[key]) if key == "q_b2n_wxyz" else r[key] for r in (ours, theirs))
        np.testing.assert_allclose(a, b, rtol=0, atol=3e-6 * np.abs(b).max())
        assert name == "omega_in_n" or (value != double[key]).any(), "this was double"
    bound = getattr(single, name).bind()
    for field, array in bound.inputs.items():
        array[:] = points[field][3]
    assert bound() == Status.OK
    for key, value in bound.outputs.items():
        whole = ours[key if key in ours else next(iter(ours))]
        assert value.tobytes() == whole[3].tobytes()


def test_in_float_the_ends_of_the_box_are_those_of_double_rounded(library):
    single = load("euler-matching", precision="float")
    high, yaw = (library.field["euler_b"]["high"][i] for i in (1, 2))
    assert float(np.float32(yaw)) > yaw  # so that yaw, rounded, would be refused in double
    with pytest.raises(BoresightError):
        library.euler_H(euler_b=[0, high, np.float32(yaw)], euler_m=np.zeros(3))
    assert np.isfinite(single.euler_H(euler_b=[0, high, np.float32(yaw)], euler_m=[0, -high, -yaw])).all()
    with pytest.raises(BoresightError, match=r"euler_b\[1\] is 1\.39\d* rad; it must lie within"):
        single.euler_H(euler_b=[0, 1.001 * high, 0], euler_m=np.zeros(3))


def test_what_is_only_there_in_double_is_refused_in_float():
    with pytest.raises(BoresightError, match="computes in double"):
        load("euler-matching", "casadi", "float")
    with pytest.raises(BoresightError, match="no precision 'half'; there are float, double"):
        load("euler-matching", precision="half")
    with pytest.raises(BoresightError, match="carries P in double"):
        CompiledFilter(load("euler-matching", precision="float"), {}, np.eye(6))


def test_the_status_is_that_of_the_header():
    text = (ROOT / "generated" / "euler_matching" / "include" / "boresight.h").read_text()
    in_c = {name: int(number) for name, number in re.findall(r"\bBS_(\w+) = (\d+)", text)}
    assert in_c == {status.name: status.value for status in Status}
    listed = re.findall(r"^\| `BS_(\w+)` \((\d+)\) \|", (ROOT / "docs" / "conventions.md").read_text(), re.M)
    assert {name: int(number) for name, number in listed} == in_c


def test_a_compile_error_is_one_line_that_names_the_first(tmp_path):
    wrong, right = tmp_path / "wrong.c", tmp_path / "right.c"
    right.write_text("int right(void);\nint right(void) { return 1; }\n")
    wrong.write_text("int wrong(void);\n\nint wrong(void) { return first; }\nint other(void) { return second; }\n")
    with pytest.raises(BoresightError, match=r"failed: .*wrong\.c:3:\d+: error: .*first") as caught:
        shared_library("test", "", {right: (), wrong: ()}, tmp_path)
    assert "\n" not in str(caught.value)


def test_one_run_is_one_of_many(library, points):
    many = call(library, "strapdown", points)
    for k in (0, 17, 39):
        one = call(library, "strapdown", {key: value[k] for key, value in points.items()})
        assert one.tobytes() == many[k].tobytes()


def test_runs_broadcast(library, points):
    q = points["q_b2n_wxyz"].reshape(8, 5, 4)
    out = library.Q(q_b2n_wxyz=q, omega_in_n=np.zeros(3), gyro_noise=np.full((5, 3), 1e-3), dt=np.ones((8, 1)))
    assert out.shape == (8, 5, 6, 6)


def test_a_bound_call_gives_the_same(library, points):
    bound = library.euler_H.bind()
    bound.inputs["euler_b"][:] = points["euler_b"][3]
    bound.inputs["euler_m"][:] = points["euler_m"][3]
    assert bound() == Status.OK
    assert bound.outputs["H"].tobytes() == call(library, "euler_H", points)[3].tobytes()
    bound.inputs["euler_b"][1] = 1.5
    before = bound.outputs["H"].copy()
    assert bound() == Status.OUT_OF_RANGE
    assert (bound.outputs["H"] == before).all()


def test_the_ends_of_the_box_are_inside(library):
    pitch = np.radians(80)
    assert np.isfinite(library.euler_H(euler_b=[0, pitch, np.pi], euler_m=[0, -pitch, -np.pi])).all()


@pytest.mark.parametrize(
    ("field", "value", "said"),
    [
        ("euler_b", [0, np.radians(80.001), 0], r"euler_b\[1\] is 1\.3962\d* rad; it must lie within"),
        ("euler_b", [0, np.nan, 0], r"euler_b\[1\] is nan; give a finite number"),
        ("euler_m", [np.inf, 0, 0], r"euler_m\[0\] is inf"),
        ("euler_m", [0, 0], r"euler_m has shape \(2,\); its last axis must be 3 long"),
        ("euler_m", np.zeros((7, 3)), "do not go together"),
    ],
)
def test_bad_input_is_one_line_that_says_where(library, field, value, said):
    fields = {"euler_b": np.zeros((4, 3)), "euler_m": np.zeros((4, 3))}
    fields[field] = np.array(value)
    if np.ndim(value) == 1:
        fields = {name: np.zeros(3) if name != field else fields[field] for name in fields}
    with pytest.raises(BoresightError, match=said) as caught:
        library.euler_H(**fields)
    assert "\n" not in str(caught.value)


def test_the_run_with_the_bad_input_is_named(library):
    euler_b = np.zeros((4, 3))
    euler_b[2, 1] = np.nan
    with pytest.raises(BoresightError, match=r"euler_b\[1\] of run 2 is nan"):
        library.euler_H(euler_b=euler_b, euler_m=np.zeros(3))


def test_a_pitch_past_80_degrees_has_no_euler_angles(library):
    half = np.radians(85) / 2
    with pytest.raises(BoresightError, match="euler_angles"):
        library.euler_angles(q_b2n_wxyz=[np.cos(half), 0, np.sin(half), 0])


def test_a_quaternion_must_have_unit_norm(library):
    with pytest.raises(BoresightError, match=r"norm 0\.5"):
        library.euler_angles(q_b2n_wxyz=[0.5, 0, 0, 0])


def test_wrong_names_list_the_right_ones(library):
    with pytest.raises(BoresightError, match="it has F, Phi"):
        _ = library.euler_G
    with pytest.raises(BoresightError, match="takes euler_b, euler_m"):
        library.euler_H(euler_b=np.zeros(3))
    with pytest.raises(BoresightError, match=r"built in are .*euler-matching"):
        load("eular")
    with pytest.raises(BoresightError, match="flight, casadi"):
        load("euler-matching", "fortran")


def test_no_compiler_is_one_line(em_copy, monkeypatch, tmp_path):
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "empty"))
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(BoresightError, match="no C compiler: 'no-such-compiler' is not found; install gcc"):
        load(em_copy)


def test_cc_is_honoured(em_copy, monkeypatch, tmp_path):
    cc = tool("clang")
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "empty"))
    monkeypatch.setenv("CC", cc)
    assert np.isfinite(load(em_copy).F(omega_in_n=np.zeros(3))).all()


def test_a_cache_that_cannot_be_written_is_one_line(em_copy, monkeypatch, tmp_path):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "file" / "below"))
    with pytest.raises(BoresightError, match="set BORESIGHT_CACHE"):
        load(em_copy)


@pytest.mark.parametrize("spoilt", ["another", "broken"])
def test_a_stale_library_is_refused(spoilt, em_copy, pendulum_folder, monkeypatch, tmp_path):
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "cache"))
    ours, _ = build(em_copy, read_manifest(em_copy), "flight")
    if spoilt == "another":
        other, _ = build(pendulum_folder, read_manifest(pendulum_folder), "flight")
        os.replace(other, ours)
    else:
        ours.write_bytes(b"not a library")
    with pytest.raises(BoresightError, match="compiled from other sources" if spoilt == "another" else "is no library"):
        load(em_copy)


def test_a_missing_generated_file_is_named(em_copy):
    (em_copy / "src" / "em_Q.c").unlink()
    with pytest.raises(BoresightError, match=r"em_Q\.c is missing; run 'boresight generate'"):
        load(em_copy)


def test_a_broken_manifest_is_one_line(em_copy):
    (em_copy / "manifest.json").write_text("{")
    with pytest.raises(BoresightError, match="cannot be read"):
        load(em_copy)


def test_the_built_in_folder_is_found_by_name():
    assert folder_of("euler-matching").resolve() == ROOT / "generated" / "euler_matching"


def test_phi_and_g_are_the_jacobians_of_the_strapdown(library):
    """(20) on the C itself: what becomes of a difference in attitude and gyros through the exact kinematics."""
    rng = np.random.default_rng(8)
    exp, matrix = numpy_euler_matching.exp, numpy_euler_matching.matrix
    q = rng.standard_normal((50, 4))
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    move = {"omega_in_n": rng.uniform(-1e-3, 1e-3, (50, 3)), "dt": np.full(50, 0.5)}
    dtheta = rng.uniform(-0.2, 0.2, (50, 3))
    C = matrix(library.strapdown(q_b2n_wxyz=q, dtheta_ib_b=dtheta, **move))

    def error(size):
        """Largest difference between the linear model and the exact one, for errors of this size (rad)."""
        eps, gyro = (size * rng.standard_normal((50, 3)) for _ in range(2))
        q_hat = numpy_euler_matching.quaternion(exp(-eps) @ matrix(q))
        # a wrong turn at the start of the step: C_hat' = C_hat exp(gyro error) exp(dtheta)
        turn_hat = numpy_euler_matching.log(exp(gyro) @ exp(dtheta))
        C_hat = matrix(library.strapdown(q_b2n_wxyz=q_hat, dtheta_ib_b=turn_hat, **move))
        after = numpy_euler_matching.log(C @ np.swapaxes(C_hat, -1, -2))
        Phi = library.Phi(**move)[:, :3, :3]
        into = eps - np.einsum("kij,kj->ki", matrix(q), gyro)  # G = -C_b2n
        return np.abs(after - np.einsum("kij,kj->ki", Phi, into)).max()

    coarse, fine = error(1e-3), error(1e-4)
    assert coarse < 2e-5
    assert 50 < coarse / fine < 200  # second order: a tenth of the error leaves a hundredth
