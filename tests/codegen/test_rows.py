"""The covariance by straight-line rows, BORESIGHT_ROWS, against the loops of the same file: equal to the bit."""

import ctypes
import functools
import re
from pathlib import Path

import numpy as np
import pytest
from building import STRICT, run, self_test
from conftest import ROOT

from boresight.codegen.export import export
from boresight.runtime import compiler

SOURCES = sorted((ROOT / "generated").glob("*/src/*_covariance.c"))
BUILDS = [
    (cc, level, precision) for cc, level in (("gcc", "-O2"), ("clang", "-O3")) for precision in compiler.PRECISIONS
]
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
        Phi, Q, next_, work = (self.empty(name) for name in ("N_PHI", "N_PACKED", "N_PACKED", "N_WORK"))
        self.call("discretize", F, Qc, self.scalar(dt), Phi, Q, work)
        self.call("joseph_predict", P, Phi, Q, next_, work)
        in_place, after, moved = Q.copy(), P.copy(), x.copy()
        self.call("joseph_predict", P, Phi, in_place, in_place, work)
        row = np.zeros(1, self.row())
        gain = np.full(self.n, np.nan, self.real)
        row["h"], row["at"], row["gain"] = h.ctypes.data, at.ctypes.data, gain.ctypes.data
        row["count"], row["z"], row["R"], row["used"] = len(h), 0.5, R, 1
        status = self.call("joseph_update", after, moved, row)
        assert status == 0 and row["used"][0] == 1
        return Phi, Q, next_, in_place, after, moved, gain, row["nu"], row["S"]

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
    return Kernels(source, folder / f"{source.stem}-{precision}.so", "-O1", *compiler.PRECISIONS[precision])


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("loops")


@pytest.mark.parametrize("source", SOURCES, ids=lambda path: path.stem)
@pytest.mark.parametrize(("cc", "level", "precision"), BUILDS, ids=str)
def test_rows_have_the_bits_of_the_loops(source, cc, level, precision, folder, tmp_path):
    loops = loops_of(source, precision, folder)
    rows = Kernels(source, tmp_path / "rows.so", level, ROWS, *compiler.PRECISIONS[precision], cc=cc)
    assert differing(loops, rows) == 0


TERM = r"\(\w+\[\d+\](?:\[\d+\])? \*\s+{}\[\d+\]\[\w\]\)"


@pytest.mark.parametrize("vector", ["X", "Y"])
def test_a_sum_in_another_order_is_seen(vector, folder, tmp_path):
    """The last two terms of one sum, exchanged."""
    (source,) = (path for path in SOURCES if path.stem == "ah_covariance")
    loops, text, term = loops_of(source, "double", folder), source.read_text(), TERM.format(vector)
    match = re.findall(rf"({term}) \+\s+({term})(?=[;)])", text)[-1]
    (tmp_path / "src").mkdir()
    (tmp_path / "include").symlink_to(source.parent.parent / "include")
    swapped = tmp_path / "src" / source.name
    joined = re.compile(rf"{re.escape(match[0])} \+\s+{re.escape(match[1])}")
    swapped.write_text(joined.sub(f"{match[1]} + {match[0]}", text))
    assert differing(loops, Kernels(swapped, tmp_path / "rows.so", "-O2", ROWS)) > 0


def test_the_self_test_passes_by_rows(tmp_path):
    """Every golden vector, and what an export calls the macro."""
    folder = ROOT / "generated" / "euler_matching"
    done = self_test(folder, tmp_path, *STRICT, ROWS)
    assert done.returncode == 0, done.stdout[-2000:]
    out = tmp_path / "flight"
    export("euler-matching", out, "double")
    assert ROWS not in run("make", "-n", "-C", out).stdout and ROWS in run("make", "-n", "-C", out, "ROWS=1").stdout
