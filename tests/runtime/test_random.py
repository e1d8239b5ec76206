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


def test_each_word_gives_two_normals_by_box_and_muller():
    """Against 40 digits: the upper 40 bits are the radius, bit 23 is half a turn, bit 22 swaps the two numbers."""
    words = random.words(5, [3], 400)[0].reshape(-1, 8)
    found = random.normals(5, [3], 800)[0].reshape(-1, 2, 8)
    with mp.workdps(40):
        for word, one, other in zip(words.ravel(), found[:, 0].ravel(), found[:, 1].ravel(), strict=True):
            upper, lower = divmod(int(word), 2**24)
            half_turn, rest = divmod(lower, 2**23)
            swapped, part = divmod(rest, 2**22)
            radius = (-1) ** half_turn * mp.sqrt(-2 * mp.log((upper + mp.mpf(0.5)) / 2**40))
            angle = mp.pi / 2 * ((part + mp.mpf(0.5)) / 2**22 - mp.mpf(0.5))
            pair = (radius * mp.cos(angle), radius * mp.sin(angle))
            for number, wanted in zip((one, other), reversed(pair) if swapped else pair, strict=True):
                assert abs(number - wanted) < 1e-15 * max(abs(radius), 1)


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
    """Bounds at 5 sigma of each estimate over ten million numbers; uncorrelated in a pair, along a run, across runs."""
    n = 10_000_000
    x = random.normals(20, np.arange(1000), n // 1000)
    power = np.ones_like(x)
    for k, moment, variance in ((1, 0, 1), (2, 1, 2), (3, 0, 15), (4, 3, 96), (5, 0, 945), (6, 15, 10170)):
        power *= x
        assert abs(power.mean() - moment) < 5 * np.sqrt(variance / n), k
    for edge in (1.0, 2.0, 3.0, 4.0, 4.5, 5.0):
        for tail in ((x > edge).sum(), (x < -edge).sum()):
            expected = n * stats.norm.sf(edge)
            assert abs(tail - expected) < 5 * np.sqrt(expected), edge
    ordered = stats.norm.cdf(np.sort(x, axis=None))
    apart = np.abs(ordered - (np.arange(n) + 0.5) / n).max() + 0.5 / n  # Kolmogorov's and Smirnov's
    assert stats.kstwobign.sf(apart * np.sqrt(n)) > 1e-4
    one, other = x.reshape(1000, -1, 2, 8).swapaxes(0, 2)[:2]
    pairs = [(one, other), (x[:, 1:], x[:, :-1]), (x[:, 16:], x[:, :-16]), (x[1:], x[:-1])]
    for a, b in (*pairs, *((a * a, b * b) for a, b in pairs), (one * one, other), (one, other * other)):
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
