"""Golden vectors: few of them tell a unit from its mutants, and they come out alike on every machine."""

import hashlib
import os
import subprocess
import sys

import casadi as ca
import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from boresight.codegen.functions.convert import to_casadi
from boresight.codegen.functions.elementary import arctangent2, hypotenuse, norm, sine_and_cosine
from boresight.codegen.functions.mutants import LEAST, distinguished, mutants, telling
from boresight.codegen.functions.tape import COMPUTE, LIBRARY, computed, evaluate, tape
from boresight.codegen.text.covariance_vectors import total
from boresight.codegen.text.names import three_digits

ALIKE = """
import hashlib, numpy as np
from boresight.codegen.functions.elementary import arctangent2, hypotenuse, norm, sine_and_cosine
from boresight.codegen.functions.tape import COMPUTE, LIBRARY
x, y = np.random.Generator(np.random.Philox(1)).random((2, 10_000)) * 12 - 6
numbers = [*sine_and_cosine(x), arctangent2(y, x), hypotenuse(x, y), norm(np.column_stack([x, y, x + y, x * y]))]
numbers += [COMPUTE[name](abs(x) / 6) for name in sorted(LIBRARY)]
alike = hashlib.sha256(b"".join(n.tobytes() for n in numbers)).hexdigest()
"""


def program(*expressions):
    """The instruction list of expressions in x, y and z."""
    symbols = sp.symbols("x y z", real=True)
    vector = ca.SX.sym("v", 3)
    (matrix,) = to_casadi([sp.Matrix(expressions)], {s: vector[i] for i, s in enumerate(symbols)})
    return tape(ca.Function("f", [vector], [ca.densify(matrix)], {"cse": True}))


x, y, z = sp.symbols("x y z", real=True)


def kept(listed, points, needs=None):
    values, bounds = evaluate(listed, [points])
    granted = [2 * bound + abs(value) * 2.0**-52 for value, bound in zip(values, bounds, strict=True)]
    turning = [False] * len(values)
    needs = np.zeros((0, len(points)), dtype=bool) if needs is None else needs
    return telling(listed, [points], granted, turning, needs), granted, turning


# ---- few vectors


def test_a_point_that_alone_tells_a_mutant_is_kept():
    listed = program(sp.Piecewise((x * y, z > 2), (x, True)))
    points = np.random.default_rng(1).uniform(0.3, 0.9, (64, 3))
    assert kept(listed, points)[0] == list(range(LEAST))
    points[40, 2] = 3.0  # there, and there only, x y is what the list gives
    assert kept(listed, points)[0] == [*range(LEAST), 40]
    needs = np.zeros((2, 64), dtype=bool)
    needs[0, [1, 50]] = needs[1, 51] = True  # the first is served by point 1 already
    assert kept(listed, points, needs)[0] == [*range(LEAST), 40, 51]


def test_the_kept_points_tell_every_mutant_that_any_point_tells():
    listed = program(x + 1e-13 * y * sp.sin(z), sp.cos(x) ** 2 / (2 + z), sp.atan2(1e-14 * z, y + 3))
    points = np.random.default_rng(2).uniform(-1, 1, (64, 3)) * 4.0 ** -np.arange(64)[::-1, None]
    chosen, granted, turning = kept(listed, points)
    every = distinguished(listed, mutants(listed), [points], granted, turning)
    some = every[:, :LEAST].any(axis=1).sum()
    assert LEAST < len(chosen) < 16 and some < every.any(axis=1).sum() == every[:, chosen].any(axis=1).sum()


@pytest.mark.parametrize(
    ("expression", "point", "seen"),
    [
        (x * y, [2.0, 1.0, 0.0], [True, False]),  # its sign; x / y is x y where y is 1
        (x + y, [2.0, 0.0, 0.0], [True, False]),
        (x * x, [1.0, 0.0, 0.0], [True, False]),  # as x / x
        (sp.sin(x), [0.5, 0.0, 0.0], [True, True]),
        (3 * x, [0.5, 0.0, 0.0], [True, True, True, True]),  # with the constant a thousandth off
        (3 * x, [0.0, 0.0, 0.0], [False, True, False, False]),  # nothing but 3 / x
    ],
)
def test_a_mutant_is_told_where_its_result_moves(expression, point, seen):
    listed = program(expression)
    found = distinguished(listed, mutants(listed), [np.array([point])], [np.array([1e-12])], [False])
    assert found[:, 0].tolist() == seen


def test_an_angle_is_the_same_after_a_turn():
    listed = program(sp.atan2(x, y))
    at = [np.array([[1e-14, -1.0, 0.0]])]  # the sign of an angle of 180 degrees
    assert distinguished(listed, mutants(listed), at, [np.array([1e-12])], [False]).all()
    assert not distinguished(listed, mutants(listed), at, [np.array([1e-12])], [True]).any()


def test_three_digits_are_never_less():
    for value in (0.1 + 0.9 * np.random.default_rng(3).random(740)) * 10.0 ** np.arange(-36, 38).repeat(10):
        text = three_digits(value)
        assert text.endswith("F") and value <= float(np.float32(text[:-1])) <= value * 1.016
    assert three_digits(0.0) == three_digits(1e-46) == "0.0F"  # of which a compiler says that it becomes zero


# ---- the same on every machine


def test_elementary_functions_err_by_less_than_four_ulp():
    rng = np.random.default_rng(4)
    angles = np.concatenate([rng.uniform(-40, 40, 2000), np.arange(-20, 21) * np.pi / 4, 10.0 ** -np.arange(1, 300, 9)])
    a, b = rng.normal(size=(2, 2000)) * 10.0 ** rng.uniform(-8, 8, (2, 2000))
    with mp.workdps(50):
        exact = [mp.sin, mp.cos, mp.atan2, mp.hypot]
        got = [*sine_and_cosine(angles), arctangent2(a, b), hypotenuse(a, b)]
        for function, values, given in zip(exact, got, [(angles,), (angles,), (a, b), (a, b)], strict=True):
            for value, *at in zip(values, *given, strict=True):
                wanted = function(*(mp.mpf(float(v)) for v in at))
                assert abs(mp.mpf(float(value)) - wanted) < 4 * np.spacing(abs(float(wanted))), (function, at)


@pytest.mark.parametrize("name", sorted(LIBRARY - {"sin", "cos"}))
def test_what_libraries_have_errs_by_less_than_four_ulp(name):
    rng = np.random.default_rng(6)
    tiny = 10.0 ** -np.arange(1, 300, 9)
    drawn = [rng.uniform(-1, 1, 500), tiny, -tiny, 1 - 10 ** rng.uniform(-16, -1, 200)]
    if name == "log":
        drawn = [abs(part) for part in drawn] + [10 ** rng.uniform(-300, 300, 500), 1 + tiny]
    elif name not in ("asin", "acos"):
        drawn += [rng.uniform(-4, 4, 500), rng.uniform(-700, 700, 500)]
    at = np.concatenate(drawn)
    with mp.workdps(50):
        for value, x in zip(COMPUTE[name](at), at, strict=True):
            wanted = getattr(mp, name)(mp.mpf(float(x)))
            assert abs(mp.mpf(float(value)) - wanted) < 4 * np.spacing(abs(float(wanted))), x


def test_what_lies_outside_a_domain_is_no_number():
    with np.errstate(invalid="ignore", over="ignore"):
        assert np.isnan([COMPUTE[name](np.array([bad]))[0] for name, bad in
                         [("log", -1.0), ("log", 0.0), ("asin", 1.0 + 2**-52), ("acos", -1.5)]]).all()  # fmt: skip
        assert COMPUTE["exp"](np.array([-np.inf, -800.0, 710.0])).tolist() == [0.0, 0.0, np.inf]
        for name in ("fmin", "fmax"):
            assert np.isnan([COMPUTE[name](*map(np.array, pair)) for pair in ((np.nan, 1.0), (1.0, np.nan))]).all()


def test_the_arctangent_knows_its_quadrants_and_zeros():
    ends = np.array([0.0, -0.0, 1.0, -1.0, 1e-300, 1e300])
    a, b = (part.ravel() for part in np.meshgrid(ends, ends))
    got, wanted = arctangent2(a, b), np.arctan2(a, b)
    np.testing.assert_allclose(got, wanted, rtol=1e-15, atol=1e-300)
    assert (np.signbit(got) == np.signbit(wanted)).all() and np.isnan(arctangent2(np.array([np.nan]), ends[:1])).all()


@pytest.mark.digits
def test_numbers_do_not_hang_on_the_processors_vector_units():
    """A process without them gives the same bits; NumPy's own arctangent does not."""
    features = np.show_config("dicts")["SIMD Extensions"]
    without = {"NPY_DISABLE_CPU_FEATURES": " ".join(features.get("found", []))}
    run = [sys.executable, "-c", ALIKE + "print(alike)"]
    other = subprocess.run(run, env={**os.environ, **without}, check=True, capture_output=True, text=True).stdout
    here: dict[str, str] = {}
    exec(ALIKE, here)
    assert other.strip() == here["alike"] and len(here["alike"]) == len(hashlib.sha256().hexdigest())


def test_a_sum_is_taken_from_the_left():
    assert total([1.0, 1e100, 1.0, -1e100]) == 0.0  # a compensated one is 2
    assert norm(np.array([[3.0, 4.0, 0.0]])).tolist() == [[5.0]]


def test_values_are_the_same_alone_and_side_by_side():
    listed = program(sp.sin(x) * y / z, sp.atan2(x, y), sp.sqrt(z))
    points = np.random.default_rng(5).uniform(0.1, 3, (37, 3))
    together = np.array([step + 0 * points[:, 0] for step in computed(listed, [points])])
    alone = np.array([computed(listed, [points[k : k + 1]]) for k in range(37)])[:, :, 0].T
    assert together.tobytes() == alone.tobytes()
