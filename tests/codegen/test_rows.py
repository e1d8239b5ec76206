"""The covariance by rows of vectors, BORESIGHT_ROWS, against the loops of the same file: equal to the bit."""

import ctypes
import functools
import itertools
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from building import STRICT, exported_c, run, self_test
from conftest import ROOT
from sympy import Matrix, eye, sin
from tools import given

from boresight.codegen.text.files import folder_files
from boresight.derive.linear import completed
from boresight.derive.model import Measurement, Model, Struct, variable
from boresight.derive.models.euler_matching import euler_matching
from boresight.examples.autopilot import AUTOPILOT
from boresight.runtime import compiler

SOURCES = sorted((ROOT / "generated").glob("*/src/*_covariance.c"))
OVER_NONZEROS = [path for path in SOURCES if "_OVER_NONZEROS" in path.read_text()]
BUILDS = [
    build
    for precision in compiler.PRECISIONS
    for build in (("gcc", "-O2", precision), given("clang", "-O3", precision))
]
# The text is one in both precisions: of a small and of a large model both are tried, of the others one, alternately.
OPTIMISED = [path for path in SOURCES if path.stem in ("em_covariance", "ah_covariance")]  # 6 and 15 states
TRIED = [
    pytest.param(source, precision, id=f"{precision}-{source.stem}")
    for k, source in enumerate(SOURCES)
    for j, precision in enumerate(sorted(compiler.PRECISIONS))
    if source in OPTIMISED or (j + k) % 2 == 0
]
TRIED_OVER_NONZEROS = [one for one in TRIED if one.values[0] in OVER_NONZEROS]
FLAGS = ("-std=c99", "-fPIC", "-shared", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror")
ROWS = "-DBORESIGHT_ROWS"
DRAWS = 40


class Kernels:
    """The covariance functions of one source, compiled."""

    def __init__(self, source: Path, out: Path, *flags: str, cc: str = "gcc"):
        include, prefix = source.parent.parent / "include", source.stem.removesuffix("_covariance")
        compiler.run([cc, *FLAGS, *flags, "-I", include, source, "-o", out])
        float_ = "-DBORESIGHT_FLOAT" in flags
        self.real, self.dll = (np.float32 if float_ else np.float64), ctypes.CDLL(str(out))
        self.scalar = ctypes.c_float if float_ else ctypes.c_double
        self.prefix, self.suffix = prefix, "_f32" if float_ else ""
        text = "".join(path.read_text() for path in sorted(include.glob("*.h")))
        self.size = {name: int(n) for name, n in re.findall(rf"#define {prefix.upper()}_(N_\w+) (\d+)", text)}
        self.n = self.size["N_STATES"]

    def call(self, name, *arguments):
        function = getattr(self.dll, f"{self.prefix}_{name}{self.suffix}")
        return function(*(ctypes.c_void_p(a.ctypes.data) if isinstance(a, np.ndarray) else a for a in arguments))

    def empty(self, name):
        return np.full(self.size[name], np.nan, self.real)

    def stepped(self, drawn):
        """All numbers that a step and a measurement of the draw give."""
        F, Qc, P, x, dt, h, at, R = drawn
        Q, next_, UD, ud_next, work = (
            self.empty(name) for name in ("N_PACKED", "N_PACKED", "N_PACKED", "N_PACKED", "N_WORK")
        )
        Phi = np.zeros(self.size["N_PHI"], self.real)  # of which the rows write all
        self.call("discretize", F, Qc, self.scalar(dt), Phi, Q, work)
        self.call("joseph_predict", P, Phi, Q, next_, work)
        dense = np.zeros((self.n, self.n), self.real)
        dense.T[np.tril_indices(self.n)] = P
        assert self.call("ud_init", np.triu(dense) + np.triu(dense, 1).T, UD, work) == 0
        self.call("ud_predict", UD, Phi, Q, ud_next, work)
        in_place, after, moved = Q.copy(), P.copy(), x.copy()
        self.call("joseph_predict", P, Phi, in_place, in_place, work)
        taken = [self.updated(after, moved, h, at, z=0.5, R=R, gate=gate) for gate in (0.0, -1e-6)]  # R raised by one
        assert all(status == 0 and said[0] == 1 for status, _, said in taken)
        of_rows = [part for _, gain, said in taken for part in (gain, *said)]
        return Phi, Q, next_, ud_next, in_place, after, moved, *of_rows

    def updated(self, P, x, h, at, **numbers):
        """P and x by a row; its status, its gain, and what the row says: whether it was used, nu, S and R."""
        row, gain = np.zeros(1, self.row()), np.full(self.n, np.nan, self.real)
        row["h"], row["at"], row["gain"] = h.ctypes.data, at.ctypes.data, gain.ctypes.data
        row["count"], row["used"] = len(h), 1
        for name, value in numbers.items():
            row[name] = value
        return self.call("joseph_update", P, x, row), gain, [row[name] for name in ("used", "nu", "S", "R")]

    def row(self):
        kinds = [
            ("h", "u8"),
            ("at", "u8"),
            ("count", "i4"),
            *((name, self.real) for name in ("z", "R", "gate", "nu", "S")),
        ]
        return np.dtype([*kinds, ("used", "i4"), ("gain", "u8")], align=True)


def draw(kernels, rng):
    """Numbers of one size or of all sizes, zeros of both signs among them."""
    spread = rng.choice([0.0, 3.0])

    def numbers(count, size=0.0):
        value = rng.standard_normal(count) * 10.0 ** (size + spread * rng.uniform(-1, 1, count))
        value[rng.random(count) < 0.1] = 0.0
        return (value * rng.choice([-1.0, 1.0], count)).astype(kernels.real)

    n, size = kernels.n, kernels.size
    sigma = 10.0 ** (spread * rng.uniform(-1, 1, n))
    root = rng.standard_normal((n, n))
    root[rng.random((n, n)) < 0.1] = -0.0
    P = np.triu(root) * np.outer(sigma, sigma)
    np.fill_diagonal(P, 3 * n * sigma**2)
    packed = np.concatenate([P[: j + 1, j] for j in range(n)]).astype(kernels.real)
    count = int(rng.integers(1, n + 1))
    at = rng.choice(n, count, replace=False).astype(np.uint16)
    h = rng.standard_normal(count).astype(kernels.real)
    R = 1e2 * n**2 * sigma.max() ** 2
    Qc = numbers(size["N_QC"])
    return numbers(size["N_F"]), rng.choice([Qc, np.abs(Qc)]), packed, numbers(n), rng.uniform(0.5, 2), h, at, R


def stepped_in_place(kernels, drawn):
    """P after a step in place, and after the step back."""
    F, Qc, P, _, dt, *_ = drawn
    Phi, Q, work = (np.zeros(kernels.size[name], kernels.real) for name in ("N_PHI", "N_PACKED", "N_WORK"))
    kernels.call("discretize", F, Qc, kernels.scalar(dt), Phi, Q, work)
    after = P.copy()
    kernels.call("joseph_step", after, Phi, Q, work)
    back = after.copy()
    kernels.call("joseph_back", back, Q)
    return after, back


def differing(kernels, rows):
    """How many of the draws differ in a bit."""
    rng = np.random.default_rng(0)
    count = 0
    for _ in range(DRAWS):
        drawn = draw(kernels, rng)
        pairs = list(zip(kernels.stepped(drawn), rows.stepped(drawn), strict=True))
        assert all(np.isfinite(a).all() for a, _ in pairs)
        count += any(a.tobytes() != b.tobytes() for a, b in pairs)
    return count


@functools.cache
def loops_of(source: Path, precision: str, folder: Path) -> Kernels:
    return Kernels(source, folder / f"{source.stem}-{precision}.so", "-O0", *compiler.PRECISIONS[precision])


@functools.cache
def rows_of(source: Path, precision: str, folder: Path) -> Kernels:
    """As they are written: what a level of optimisation makes of them is tried of two models alone."""
    out = folder / f"{source.stem}-{precision}-rows.so"
    return Kernels(source, out, "-O0", ROWS, *compiler.PRECISIONS[precision])


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("loops")


@pytest.mark.parametrize(("source", "precision"), TRIED)
def test_rows_of_every_model_have_the_bits_of_the_loops(source, precision, folder):
    assert differing(loops_of(source, precision, folder), rows_of(source, precision, folder)) == 0


@pytest.mark.parametrize(("source", "precision"), TRIED_OVER_NONZEROS)
def test_a_prediction_over_non_zeros_has_the_bits_of_the_blocks(source, precision, folder, tmp_path):
    """With rows of vectors it has them too, by the test above."""
    flags = compiler.PRECISIONS[precision]
    blocks = Kernels(source, tmp_path / "blocks.so", "-O0", "-DBORESIGHT_BLOCKS", *flags)
    assert differing(loops_of(source, precision, folder), blocks) == 0


@pytest.mark.parametrize(("source", "precision"), TRIED_OVER_NONZEROS)
def test_a_step_in_place_has_the_bits_of_a_prediction_and_goes_back(source, precision, folder):
    kernels, rng = loops_of(source, precision, folder), np.random.default_rng(0)
    for _ in range(DRAWS):
        drawn = draw(kernels, rng)
        P = drawn[2]
        P += 0.0  # as a filter begins: with zeros of one sign
        after, back = stepped_in_place(kernels, drawn)
        assert after.tobytes() == kernels.stepped(drawn)[2].tobytes() and back.tobytes() == P.tobytes()


@pytest.mark.parametrize("source", OPTIMISED, ids=lambda path: path.stem)
@pytest.mark.parametrize(("cc", "level", "precision"), BUILDS, ids=str)
def test_rows_have_the_bits_of_the_loops(source, cc, level, precision, folder, tmp_path):
    loops = loops_of(source, precision, folder)
    rows = Kernels(source, tmp_path / "rows.so", level, ROWS, *compiler.PRECISIONS[precision], cc=cc)
    assert differing(loops, rows) == 0


WALK = Model(
    name="walk",
    c_prefix="wk",
    title="four numbers in discrete time",
    frame="none",
    states=(walk := variable("walk", "w_0 w_1 w_2 w_3", "m", "where it is", -1.0, 1.0),),
    structs=(Struct("step", "one step", (push := variable("push", "u", "m", "push of the step", -1.0, 1.0),)),),
    next=Matrix([[walk.vector[i] + push.scalar * sin(walk.vector[(i + 1) % 4])] for i in range(4)]),
    Q=eye(4) * (1 + push.scalar**2),
    measurements=(Measurement("place", ("w_0",), "m", "one of them", h=Matrix([walk.vector[0]])),),
)


@functools.cache
def texts(make):
    """Of a model, all files but the self-tests."""
    return folder_files(make(), lambda *_: "no self-test")[1]


def printed(make, folder):
    for path, text in texts(make).items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    (source,) = (folder / "src").glob("*_covariance.c")
    return source


def first_order():
    return replace(euler_matching(), order=1)


def third_order():
    return replace(euler_matching(), order=3)


@pytest.mark.parametrize("cc", ["gcc", given("clang")])
@pytest.mark.parametrize("of_order", [first_order, third_order])
def test_another_order_has_the_bits_and_no_warning(of_order, cc, tmp_path):
    source = printed(of_order, tmp_path)
    loops, rows = (Kernels(source, tmp_path / f"{name}.so", "-O2", name, cc=cc) for name in ("-DLOOPS", ROWS))
    assert differing(loops, rows) == 0


def autopilot():
    return completed(AUTOPILOT)


@pytest.mark.parametrize("form", [ROWS, "-DBORESIGHT_BLOCKS"])
def test_a_prediction_over_non_zeros_of_first_order_has_the_bits_of_the_others(form, tmp_path):
    """Of 24 states of which 9 move."""
    source = printed(autopilot, tmp_path)
    assert "_OVER_NONZEROS" in source.read_text()
    kernels = [Kernels(source, tmp_path / f"{name}.so", "-O1", name) for name in ("-DNONZEROS", form)]
    assert differing(*kernels) == 0


@pytest.mark.parametrize("cc", ["gcc", given("clang")])
def test_a_model_in_discrete_time_has_no_warning(cc, tmp_path):
    source = printed(lambda: WALK, tmp_path)
    assert "add_run" in source.read_text()
    compiler.run([cc, *FLAGS, "-O2", ROWS, "-I", tmp_path / "include", source, "-o", tmp_path / "rows.so"])


REFUSED = {  # a row that is not taken, and its status
    "gate": ({"z": 1e9, "gate": 1e-9}, 0),
    "negative": ({"R": -1e30}, 5),
    "no variance": ({"R": 0.0}, 5),
    "no number": ({"z": np.nan}, 5),
    "infinite": ({"R": np.inf}, 5),
}


@pytest.mark.parametrize("source", SOURCES, ids=lambda path: path.stem)
def test_a_row_that_is_refused_leaves_all_as_it_was(source, folder):
    loops, rows = (of(source, "double", folder) for of in (loops_of, rows_of))
    rng = np.random.default_rng(0)
    for (case, (numbers, expected)), count in itertools.product(REFUSED.items(), {0, 1, min(2, loops.n), loops.n}):
        _, _, P, x, *_ = draw(loops, rng)
        P *= case != "no variance"
        h, at, said = np.ones(count), rng.permutation(loops.n)[:count].astype(np.uint16), []
        for kernels in (loops, rows):
            after, moved = P.copy(), x.copy()
            status, gain, words = kernels.updated(after, moved, h, at, **{"z": 0.5, "R": 1.0} | numbers)
            assert (status, words[0][0]) == (expected, 0), (case, count)
            assert after.tobytes() == P.tobytes() and moved.tobytes() == x.tobytes() and np.isnan(gain).all()
            said.append(words)
        assert np.array_equal(*said, equal_nan=True)


@pytest.mark.parametrize("vector", ["X", "Y", "U"])
def test_a_sum_in_another_order_is_seen(vector, folder, tmp_path):
    """The last term of one run of terms, before the others."""
    (source,) = (path for path in SOURCES if path.stem == "ah_covariance")
    loops, text = loops_of(source, "double", folder), source.read_text()
    run = re.search(rf"(add_run\(s, &Phi\[\d+\], &{vector}\[0\]\[0\], )1, 15(, \d+, \d+\);)", text)
    assert run
    (tmp_path / "src").mkdir()
    (tmp_path / "include").symlink_to(source.parent.parent / "include")
    swapped = tmp_path / "src" / source.name
    swapped.write_text(text.replace(run[0], f"{run[1]}14, 15{run[2]} {run[1]}1, 14{run[2]}"))
    assert differing(loops, Kernels(swapped, tmp_path / "rows.so", "-O0", ROWS)) > 0


def test_the_self_test_passes_by_rows(tmp_path):
    """Every golden vector, and what an export calls the macro."""
    folder = ROOT / "generated" / "euler_matching"
    done = self_test(folder, tmp_path, *STRICT, "-O0", ROWS)
    assert done.returncode == 0, done.stdout[-2000:]
    out = tmp_path / "flight"
    exported_c("euler-matching", out)
    assert ROWS not in run("make", "-n", "-C", out).stdout and ROWS in run("make", "-n", "-C", out, "ROWS=1").stdout
