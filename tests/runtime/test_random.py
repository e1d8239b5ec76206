"""Random numbers counted by seed and run: held against NumPy's Philox, and their law against the normal one."""

import numpy as np
import pytest
from mpmath import mp
from scipy import stats

from boresight import BoresightError
from boresight.runtime import random
from boresight.runtime.library import WIDTHS

LAST = 2**64 - 1


@pytest.mark.parametrize("seed, stream, first", [(0, 0, 0), (7, 9, 5), (LAST, LAST, 4096), (3, 1, 2)])
def test_words_are_those_of_numpy(seed, stream, first):
    runs = np.array([0, 1, 2**63, LAST], dtype=np.uint64)
    words = random.words(seed, runs, 23, first, stream)
    for run, found in zip(runs, words, strict=True):
        key = np.array([seed, run], dtype=np.uint64)
        philox = np.random.Philox(key=key, counter=np.array([0, 0, 0, stream], dtype=np.uint64))
        assert np.array_equal(philox.random_raw(first + 23)[first:], found)


def test_normals_are_of_two_words_each_two_by_box_and_muller():
    """Against 40 digits: the radius by the first word's upper 52 bits, the angle by the second's."""
    words = [int(w) for w in random.words(5, [3], 400)[0]]
    found = random.normals(5, [3], 400)[0]
    with mp.workdps(40):
        for k in range(0, 400, 2):
            radius = mp.sqrt(-2 * mp.log(1 - mp.mpf(words[k] >> 12) / 2**52))
            angle = 2 * mp.pi * (mp.mpf(words[k + 1] >> 12) / 2**52 - mp.mpf(1) / 2)
            assert abs(found[k] - radius * mp.cos(angle)) < 1e-15 * max(radius, 1)
            assert abs(found[k + 1] - radius * mp.sin(angle)) < 1e-15 * max(radius, 1)


def test_a_number_depends_on_seed_stream_run_and_place_alone():
    whole = random.normals(11, np.arange(9), 300, stream=2, lanes=1)
    for width in WIDTHS:
        assert np.array_equal(random.normals(11, np.arange(9), 300, stream=2, lanes=width), whole)
    for first in (1, 2, 3, 4, 131):
        for width in (1, 8):
            part = random.normals(11, [8, 2], 77, first, 2, lanes=width)
            assert np.array_equal(part, whole[[8, 2], first : first + 77])
    out = np.zeros((300, 3, 9)).transpose(2, 0, 1)[..., 1]
    assert np.array_equal(random.normals(11, np.arange(9), 300, stream=2, out=out), whole)
    assert not (random.normals(12, np.arange(9), 300, stream=2) == whole).any()
    assert not (random.normals(11, np.arange(9), 300, stream=3) == whole).any()


def test_moments_and_tails_are_normal():
    """Bounds at 5 sigma of each estimate over two million numbers; and uncorrelated, along a run and across runs."""
    n = 2_000_000
    x = random.normals(20, np.arange(1000), n // 1000)
    for power, moment, variance in ((1, 0, 1), (2, 1, 2), (3, 0, 15), (4, 3, 96), (6, 15, 10170)):
        assert abs((x**power).mean() - moment) < 5 * np.sqrt(variance / n), power
    for edge in (1.0, 2.0, 3.0, 4.0, 4.5):
        for tail in ((x > edge).sum(), (x < -edge).sum()):
            expected = n * stats.norm.sf(edge)
            assert abs(tail - expected) < 5 * np.sqrt(expected), edge
    assert stats.kstest(x.ravel()[:100_000], "norm").pvalue > 1e-4
    for a, b in ((x[:, 1:], x[:, :-1]), (x[:, 2:], x[:, :-2]), (x[1:], x[:-1]), (x[:, 1::2] ** 2, x[:, ::2] ** 2)):
        assert abs(np.corrcoef(a.ravel(), b.ravel())[0, 1]) < 5 / np.sqrt(a.size)


def test_what_cannot_be_drawn_is_named():
    for wrong in (-1, 2**64, 1.5):
        with pytest.raises(BoresightError, match="seed is"):
            random.normals(wrong, [0], 3)
    with pytest.raises(BoresightError, match="runs is"):
        random.normals(1, [-1], 3)
    with pytest.raises(BoresightError, match="runs is"):
        random.normals(1, 3, 3)
    with pytest.raises(BoresightError, match="out is float64 of shape"):
        random.normals(1, [0], 3, out=np.zeros(3))
    with pytest.raises(BoresightError, match="out is float32"):
        random.normals(1, [0], 3, out=np.zeros((1, 3), np.float32))


def test_normals_may_come_scaled_and_moved():
    plain = random.normals(3, range(5), 17, first=2)
    scale, offset = np.arange(17) + 0.1, np.arange(17) * 3.0
    moved = random.normals(3, range(5), 17, first=2, scale=scale, offset=offset)
    np.testing.assert_array_equal(moved, plain * scale + offset)
