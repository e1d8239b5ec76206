"""An angle less whole turns: the same in Python and in C, to the bit."""

import ctypes
import math
from pathlib import Path

import numpy as np
import pytest
from building import STRICT, run

from boresight.codegen.text.files import rendered
from boresight.runtime.array import wrapped

BELOW = np.nextafter(np.pi, 0)
INSIDE = np.array([-np.pi, -BELOW, -3.0, -1e-300, -0.0, 0.0, 5e-324, 1.0, BELOW])
BEYOND = np.array([np.pi, np.nextafter(np.pi, 4), np.nextafter(-np.pi, -4), 4.0, -4.0, 6.26, 1e3, -1e9, 3 * np.pi])


@pytest.fixture(scope="module")
def in_c(tmp_path_factory):
    folder = tmp_path_factory.mktemp("wrap")
    for path, text in rendered(("include/boresight.h", "include/boresight_precision.h"), {}, exported="").items():
        (folder / Path(path).name).write_text(text)
    (folder / "wrap.c").write_text(
        '#include "boresight.h"\nbs_real wrap(bs_real angle);\n'
        "bs_real wrap(bs_real angle)\n{\n    return bs_wrap(angle);\n}\n"
    )

    def compiled(*options):
        out = folder / f"wrap{len(options)}.so"
        done = run("cc", *STRICT, *options, "-shared", "-fPIC", folder / "wrap.c", "-o", out, "-lm")
        assert done.returncode == 0, done.stderr
        function = ctypes.CDLL(str(out)).wrap
        kind = ctypes.c_float if options else ctypes.c_double
        function.restype, function.argtypes = kind, [kind]
        return function

    return compiled


def test_what_lies_within_half_a_turn_keeps_its_bits():
    assert wrapped(INSIDE).tobytes() == INSIDE.tobytes()


def test_what_lies_beyond_comes_into_the_half_open_turn_by_whole_turns():
    got = wrapped(BEYOND)
    assert ((got >= -np.pi) & (got < np.pi)).all()
    off = np.remainder(got - BEYOND + 0.5, 2 * np.pi) - 0.5
    assert (abs(off) <= 4 * np.spacing(abs(BEYOND) + 1)).all()
    assert wrapped(np.pi) == -np.pi
    assert wrapped(3.13 + 3.13) == pytest.approx(6.26 - 2 * np.pi, abs=1e-15)
    assert math.isnan(wrapped(np.nan))


@pytest.mark.digits
def test_c_gives_the_same_bits(in_c):
    rng = np.random.default_rng(3)
    angles = np.concatenate([INSIDE, BEYOND, rng.uniform(-20, 20, 1000), np.pi * rng.integers(-9, 9, 50)])
    wrap = in_c()
    assert np.array([wrap(a) for a in angles]).tobytes() == wrapped(angles).tobytes()
    assert math.isnan(wrap(math.nan))


def test_in_single_precision_too_the_result_lies_in_the_half_open_turn(in_c):
    wrap, half = in_c("-DBORESIGHT_FLOAT"), float(np.float32(np.pi))
    angles = np.float32([*np.linspace(-40, 40, 1001), half, -half, np.nextafter(np.float32(half), np.float32(4))])
    got = np.array([wrap(a) for a in angles.tolist()])
    assert ((got >= -half) & (got < half)).all()
    assert abs(np.remainder(got - angles + 1, 2 * np.pi) - 1).max() < 1e-5
