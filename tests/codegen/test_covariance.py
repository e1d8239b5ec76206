"""The covariance and the filter in C: two forms and the textbook, what the self-tests see, every build."""

import ctypes
import json
import re
from pathlib import Path

import numpy as np
import pytest
from building import STRICT, c_files, program, run, self_test
from conftest import ROOT

from boresight.codegen.text.covariance import even
from boresight.codegen.text.covariance_vectors import draw_case, predicted, updated
from boresight.codegen.text.places import moving, reach, table
from boresight.runtime.compiler import compile_sources
from boresight.runtime.library import load

GENERATED = ROOT / "generated"
FILTERS = sorted(path.parent.parent.name for path in GENERATED.glob("*/src/*_filter.c"))
AH = GENERATED / "azimuth_hold"
U = np.finfo(float).eps / 2


# ---- every build


@pytest.mark.parametrize("form", [("-DBORESIGHT_UD=1",), ("-DBORESIGHT_FLOAT", "-DBORESIGHT_UD=0")])
def test_each_form_flies_in_the_other_precision(form, tmp_path):
    done = self_test(AH, tmp_path, *STRICT, "-O0", *form)
    assert done.returncode == 0, done.stdout[-2000:]


def test_no_undefined_behaviour_is_met(tmp_path):
    """Of the sources; what tests them is built without."""
    command = ["cc", "-std=c99", "-I", AH / "include"]
    watched = ["-fsanitize=undefined,address", "-fno-sanitize-recover"]
    objects = compile_sources([*command, *watched], dict.fromkeys(c_files(AH, "src"), ()), tmp_path)
    tests = compile_sources(command, dict.fromkeys(c_files(AH, "selftest", "batch"), ()), tmp_path)
    done = run("cc", *watched, *objects.values(), *tests.values(), "-lm", "-o", tmp_path / "program")
    assert done.returncode == 0, done.stderr
    done = run(tmp_path / "program")
    assert done.returncode == 0, done.stdout[-1000:] + done.stderr[-1000:]


def test_all_models_and_the_detector_link_into_one_binary(tmp_path):
    """The headers of all stand in one file, their sources define no name without the prefix of their own, and no two
    have one prefix; three folders are linked."""
    folders = sorted(path.parent for path in GENERATED.glob("*/manifest.json"))
    prefixes = [json.loads((folder / "manifest.json").read_text())["c_prefix"] for folder in folders]
    assert len(set(prefixes)) == len(folders)
    for folder, prefix in zip(folders, prefixes, strict=True):
        text = re.sub(r"/\*.*?\*/", "", "".join(path.read_text() for path in c_files(folder, "src")), flags=re.S)
        defined = re.findall(r"^(?!static |typedef )[a-z][\w ]*[ *]([a-z]\w+)(?:\(|\[|;| =)", text, re.M)
        assert defined and all(name.startswith(f"{prefix}_") for name in defined), folder
    headers = [path for folder in folders for path in sorted((folder / "include").glob("*.h"))]
    main = tmp_path / "main.c"
    names = "".join(f'#include "{path.name}"\n' for path in headers if path.name != "boresight.h")
    main.write_text(names + "int main(void)\n{\n    return 0;\n}\n")
    linked = (GENERATED / name for name in ("euler_matching", "strapdown", "stationary_detector"))
    sources = [main, *(path for folder in linked for path in c_files(folder, "src"))]
    includes = [word for folder in folders for word in ("-I", folder / "include")]
    assert run(program(tmp_path, sources, "-std=c99", "-O0", "-Wall", "-Werror", *includes)).returncode == 0


def test_the_filter_needs_a_root_and_the_exponent_of_a_number_from_outside(tmp_path):
    command = ["cc", "-std=c99", "-O1", "-I", AH / "include"]
    objects = compile_sources(command, dict.fromkeys(c_files(AH, "src"), ()), tmp_path)
    assert run("ld", "-r", *objects.values(), "-o", tmp_path / "whole.o").returncode == 0
    listed = run("nm", "-u", tmp_path / "whole.o").stdout.split()
    allowed = {"U", "sqrt", "fabs", "frexp", "memset", "memcpy", "memmove",
               "__stack_chk_fail", "_GLOBAL_OFFSET_TABLE_"}  # fmt: skip
    assert set(listed) <= allowed
    written = run("nm", tmp_path / "whole.o").stdout
    assert not [line for line in written.splitlines() if line.split()[-2] in "BbDdCGgSs"], "a global variable"


# ---- two forms and the textbook


class Loops:
    """The covariance of a model in C on NumPy arrays."""

    class Row(ctypes.Structure):
        _fields_ = [
            ("h", ctypes.c_void_p), ("at", ctypes.c_void_p), ("count", ctypes.c_int), ("z", ctypes.c_double),
            ("R", ctypes.c_double), ("gate", ctypes.c_double), ("nu", ctypes.c_double), ("S", ctypes.c_double),
            ("used", ctypes.c_int), ("gain", ctypes.c_void_p),
        ]  # fmt: skip

    def __init__(self, name):
        library = load(name)
        self.dll, self.prefix, self.n = library.dll, library.manifest["c_prefix"], len(library.states)
        self.work = np.zeros(4 * (self.n + 5) ** 2)

    def call(self, function, *arguments):
        pointers = [ctypes.c_void_p(a.ctypes.data) if isinstance(a, np.ndarray) else a for a in arguments]
        return getattr(self.dll, f"{self.prefix}_{function}")(*pointers)

    def init(self, form, P):
        packed = np.full(self.n * (self.n + 1) // 2, np.nan)
        return self.call(f"{form}_init", np.ascontiguousarray(P), packed, self.work), packed

    def dense(self, form, packed):
        P = np.zeros((self.n, self.n))
        self.call(f"{form}_dense", packed, P)
        return P

    def update(self, form, packed, x, h, z, R):
        at, h = np.arange(self.n, dtype=np.uint16), np.ascontiguousarray(h)
        row = self.Row(h.ctypes.data, at.ctypes.data, self.n, z, R, 0.0, 0.0, 0.0, 1)
        assert self.call(f"{form}_update", packed, x, ctypes.byref(row)) == 0
        return row.nu, row.S


@pytest.fixture(params=["euler-matching", "velocity-dcm", "azimuth-hold", "velocity-attitude"])
def loops(request):
    return Loops(request.param)


def scaled(difference, P):
    sigma = np.sqrt(np.diag(P))
    return np.abs(difference / np.outer(sigma, sigma)).max()


def random_covariance(n, rng):
    root = rng.standard_normal((n, n))
    sigma = 10.0 ** rng.uniform(-6, 3, n)
    return root @ root.T * np.outer(sigma, sigma), sigma


def test_both_forms_update_as_the_textbook_does(loops):
    rng = np.random.default_rng(0)
    for _ in range(20):
        P, sigma = random_covariance(loops.n, rng)
        h, x, z = rng.standard_normal(loops.n) / sigma, sigma * rng.standard_normal(loops.n), 1.0
        R = 0.1
        K = P @ h / (h @ P @ h + R)
        after, estimate = (np.eye(loops.n) - np.outer(K, h)) @ P, x + K * (z - h @ x)
        spread = np.abs(h) @ np.sqrt(np.diag(P))
        bound = 10 * loops.n**2 * U * (R + spread**2) / (h @ P @ h + R)
        for form in ("joseph", "ud"):
            status, packed = loops.init(form, P)
            assert status == 0
            moved = x.copy()
            nu, S = loops.update(form, packed, moved, h, z, R)
            assert abs(S - (h @ P @ h + R)) < bound * S and abs(nu - (z - h @ x)) < 1e-12
            assert scaled(loops.dense(form, packed) - after, P) < bound
            assert np.abs((moved - estimate) / sigma).max() < bound * 1e3


def test_the_factors_stay_positive_where_the_matrix_does_not(loops):
    """A thousand accurate measurements from a coarse start: D is never negative, and U D U' is a covariance."""
    rng = np.random.default_rng(3)
    P = np.diag(10.0 ** rng.uniform(4, 8, loops.n))
    _, packed = loops.init("ud", P)
    x = np.zeros(loops.n)
    diagonal = np.cumsum(np.arange(1, loops.n + 1)) - 1
    for _ in range(1000):
        loops.update("ud", packed, x, rng.standard_normal(loops.n), 0.0, 1e-10)
        assert (packed[diagonal] >= 0).all()
    P = loops.dense("ud", packed)
    sigma = np.sqrt(np.diag(P))
    assert (sigma > 0).all() and np.linalg.eigvalsh(P / np.outer(sigma, sigma))[0] > 0


def test_a_covariance_without_full_rank_has_factors(loops):
    rng = np.random.default_rng(4)
    for rank in (0, 1, loops.n // 2):
        root = rng.standard_normal((loops.n, rank))
        P = root @ root.T
        for form in ("joseph", "ud"):
            status, packed = loops.init(form, P)
            assert status == 0
            assert np.abs(loops.dense(form, packed) - P).max() <= 5 * loops.n**2 * U * max(1.0, P.max(initial=0))


def test_what_is_no_covariance_is_refused(loops):
    P, _ = random_covariance(loops.n, np.random.default_rng(5))
    indefinite = P - 2 * np.diag(np.diag(P)) * (np.arange(loops.n) == 1)
    crossed = P.copy()
    crossed[0, 1] *= 1.01
    for form in ("joseph", "ud"):
        for wrong, status in ((indefinite, 5), (crossed, 5), (P * np.nan, 2)):
            said, packed = loops.init(form, wrong)
            assert said == status and np.isnan(packed).all()


# ---- the golden vectors themselves


@pytest.mark.parametrize("order", [1, 2, 3, None])
def test_the_vectors_are_what_numpy_computes(order):
    """Exact fractions and floating point agree to the tolerances printed beside the vectors."""
    F, Qc = ((0, 1), (0, 2), (1, 2)), ((1, 1), (1, 2), (2, 1), (2, 2))
    places = [(i, j) for j in range(3) for i in range(j + 1)]
    for k in range(64):
        case = draw_case(k, 3, F, Qc)
        scale = 2.0 ** np.array(case.scale)
        P, x = (np.array(v, dtype=float) for v in (case.P / 2**8, case.x / 2**4))
        A, S = (np.array(v, dtype=float) / 2**12 for v in (case.A, case.B))
        powers = [np.eye(3), A, A @ A / 2, A @ A @ A / 6][: (order or 0) + 1]
        Phi = sum(powers) if order else 2**4 * A
        Q = S * 2**4
        if order:
            squares = {
                1: ((1, np.eye(3) + A / 2),),
                2: ((1 / 4, np.eye(3)), (3 / 4, np.eye(3) + 2 / 3 * A + 2 / 9 * A @ A)),
                3: ((1, np.eye(3) + A / 2 + A @ A / 6 + A @ A @ A / 24), (1 / 3, A / 2 + A @ A / 4)),
            }[order]
            Q = sum(weight * B @ S @ B.T for weight, B in squares)
        packed, moved, size, _ = predicted(case, order, 3)
        expected = (Phi @ P @ Phi.T + Q) * np.outer(scale, scale)
        for value, (i, j) in zip(packed, places, strict=True):
            assert abs(value - expected[i, j]) <= 50 * U * size[i] * size[j]
        assert np.allclose(moved, Phi @ x * scale, rtol=1e-14, atol=1e-300)
        h, R, z = np.array(case.h / 2**6, dtype=float), case.R / 2**24, case.z / 2**3
        after, estimate, size, _, (nu, innovation, _, _) = updated(case)
        assert nu == pytest.approx(z - h @ x, abs=1e-13) and innovation == pytest.approx(h @ P @ h + R, rel=1e-13)
        K = P @ h / (h @ P @ h + R)
        expected = (P - np.outer(K, K) * (h @ P @ h + R)) * np.outer(scale, scale)
        for value, (i, j) in zip(after, places, strict=True):
            assert abs(value - expected[i, j]) <= 50 * U * size[i] * size[j]
        assert np.allclose(estimate, (x + K * (z - h @ x)) * scale, rtol=1e-9, atol=1e-12)


def test_what_moves_ends_with_the_last_state_that_another_drives():
    assert moving(3, ((0, 1), (1, 2))) == 2
    assert moving(4, ((2, 0),)) == 3  # states that stay before it are carried like those that move
    assert moving(3, ()) == 1
    assert table(((0, 2), (2, 0), (0, 1)), 3) == {"nnz": 3, "start": "0, 2, 2, 3", "at": "1, 2, 0"}


def test_blocks_are_as_even_as_the_count_allows():
    assert [even(n, 5) for n in (1, 5, 6, 15, 16)] == [(1, 1), (5, 5), (3, 6), (5, 15), (4, 16)]


def test_a_factor_reaches_where_elimination_fills_it():
    assert reach(3, ((0, 0), (1, 1), (2, 2))) == [0, 1, 2]
    assert reach(3, ((0, 2), (1, 2), (2, 0), (2, 1))) == [0, 0, 0]  # (0, 1) is filled by the last column
    assert reach(4, ((0, 0), (1, 3), (3, 1))) == [0, 1, 1, 1]


def test_the_filter_is_left_out_where_nothing_is_measured():
    assert not (Path(GENERATED) / "phi_error" / "src" / "phi_filter.c").exists()
    assert {"azimuth_hold", "euler_matching", "velocity_attitude", "velocity_dcm"} <= set(FILTERS)
