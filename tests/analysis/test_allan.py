"""Allan deviation and what is read from it: by its definition, by formulas of others, and by logs that are known."""

import numpy as np
import pytest
from at_rest import KINDS, SI, flicker, held, least, rates
from scipy.special import gammaincinv

from boresight import BoresightError
from boresight.analysis import allan


def by_definition(values, m):
    """Half the mean square of the difference of neighbouring means, wherever two of m samples begin."""
    means = [np.mean(values[k : k + m]) for k in range(len(values) - m + 1)]
    pairs = [(means[k + m] - means[k]) ** 2 for k in range(len(values) - 2 * m + 1)]
    return sum(pairs) / len(pairs) / 2


def test_the_overlapping_variance_is_that_of_its_definition():
    values = np.random.default_rng(1).standard_normal((301, 2)).cumsum(axis=0) + 1e3
    found = allan.variances(values, 0.01, np.array([1, 2, 7, 40]))
    expected = [[by_definition(column, m) for column in values.T] for m in (1, 2, 7, 40)]
    assert found == pytest.approx(np.array(expected), rel=1e-9)


@pytest.mark.parametrize("term", range(5))
def test_each_noise_has_the_variance_that_the_standard_prints(term):
    """IEEE 952, annex C; the log is made from spectrum and recursion."""
    coefficients = np.zeros(5)
    coefficients[term] = 0.02
    rng = np.random.default_rng(term)
    samples, dt, lengths = 2**15, 0.1, np.array([1, 4, 16, 64])
    logs = np.array([rates(coefficients, samples, dt, rng) for _ in range(8)])
    found = allan.variances(logs.T, dt, lengths).mean(axis=1)
    expected = allan.basis(lengths * dt) @ coefficients**2
    sigma = np.sqrt(np.diag(allan.covariance(coefficients**2, samples, dt, lengths)) / 8)
    assert np.abs(found - expected) == pytest.approx(0, abs=1e-9 * expected.max() + 4 * sigma.max())
    assert (np.abs(found - expected) <= 4 * sigma + 1e-9 * expected).all()


@pytest.mark.parametrize(
    "squares",
    [(1, 0, 0, 0, 0), (0, 1, 0, 0, 0), (0, 0, 1, 0, 0), (0, 0, 0, 1, 0), (0.3, 1, 0.01, 1e-5, 0), (0, 1, 0, 0, 1e-4)],
)
def test_the_covariance_of_the_points_is_that_of_many_logs(squares):
    samples, logs, lengths = 512, 1500, allan.averages(512)
    rng = np.random.default_rng(3)
    made = np.array([rates(np.sqrt(squares), samples, 1.0, rng) for _ in range(logs)])
    scatter = np.cov(allan.variances(made.T, 1.0, lengths))
    V = allan.covariance(np.array(squares, float), samples, 1.0, lengths)
    sigma, found = np.sqrt(np.diag(V)), np.sqrt(np.diag(scatter))
    # A chi-square of few degrees of freedom has a kurtosis that makes its sample variance scatter the more.
    assert found / sigma == pytest.approx(1, abs=0.2) and np.abs(found / sigma - 1)[:4].max() < 0.12
    assert scatter / np.outer(found, found) == pytest.approx(V / np.outer(sigma, sigma), abs=0.13)
    assert np.linalg.eigvalsh(V / np.outer(sigma, sigma)).min() > 0


def test_degrees_of_freedom_of_white_noise_are_those_of_the_handbook():
    """Howe, Allan and Barnes 1981 for white frequency noise, N phases: an empirical fit, good to some per cent."""
    samples, lengths = 4096, allan.averages(4096)
    V = allan.covariance(np.array([0, 1.0, 0, 0, 0]), samples, 1.0, lengths)
    freedom = 2 * (1 / lengths) ** 2 / np.diag(V)
    N, m = samples + 1, lengths
    printed = (3 * (N - 1) / (2 * m) - 2 * (N - 2) / N) * 4 * m**2 / (4 * m**2 + 5)
    assert freedom == pytest.approx(printed, rel=0.06)


def test_intervals_of_the_curve_hold_its_truth():
    rng, dt, truth = np.random.default_rng(5), 0.1, np.array(KINDS["industrial"]) * SI
    inside = []
    for _ in range(25):
        fit = allan.fitted(rates(truth, 2**13, dt, rng), dt)
        expected = np.sqrt(allan.basis(fit.tau) @ truth**2)
        inside.append((fit.deviation_low <= expected) & (expected <= fit.deviation_high))
    inside = np.array(inside)
    # twelve points of a curve are perhaps four that are independent
    assert inside.mean() > least(100, 0.95) / 100
    assert (inside.mean(axis=0) > least(25, 0.95) / 25 - 1e-9).all()


def test_one_point_has_the_interval_of_its_degrees_of_freedom():
    fit = allan.fitted(np.random.default_rng(2).standard_normal(4096), 1.0)
    k = 6
    quantile = 2 * gammaincinv(fit.freedom[k] / 2, 0.975)
    assert fit.deviation_low[k] == pytest.approx(fit.deviation[k] * np.sqrt(fit.freedom[k] / quantile))
    assert fit.deviation_low[k] < fit.deviation[k] < fit.deviation_high[k]


@pytest.mark.parametrize("kind", KINDS)
def test_intervals_of_the_noises_hold_the_truth(kind):
    """At 100 logs of four hours each: tests/analysis/at_rest.py."""
    found = held(kind, 12, 2**14, 0.4, 11)
    assert (found.sum(axis=0) >= least(12, 0.9545)).all()
    assert found.sum() >= least(found.size, 0.9545)


def test_what_is_seen_is_read_where_it_is_most():
    truth = np.array([0, 1.0, 0.1, 0, 0])
    fit = allan.fitted(rates(truth, 2**17, 1.0, np.random.default_rng(8)), 1.0)
    assert list(fit.seen) == [False, True, True, False, False]
    # the two are equal where 1/tau is 2 ln2/pi B^2
    equal = 1 / (allan.FLOOR * 0.01)
    assert fit.read_from(1)[0] == 1.0 and equal / 2 <= fit.read_from(1)[1] <= equal * 1.2
    assert equal / 1.2 <= fit.read_from(2)[0] <= equal * 2


def test_a_ramp_is_seen_and_is_no_random_walk():
    truth = np.array([0, 1.0, 0, 0, 1e-4])
    fit = allan.fitted(rates(truth, 2**14, 1.0, np.random.default_rng(9)), 1.0)
    assert fit.seen[4] and fit.low[4] <= 1e-4 <= fit.high[4] and not fit.seen[3]


def test_what_a_filter_of_the_sensor_hides_is_left_out():
    rng = np.random.default_rng(4)
    white = rng.standard_normal(2**15 + 3)
    smooth = np.convolve(white, np.full(4, 0.25), mode="valid")
    fit = allan.fitted(smooth, 1.0)
    assert not fit.used[0] and fit.used[-1] and fit.probability > allan.UNFIT
    assert fit.low[1] <= 1.0 <= fit.high[1]


def test_too_few_samples_and_none_that_change_are_refused():
    with pytest.raises(BoresightError, match="500 samples are too few for an Allan deviation; 768 are not"):
        allan.fitted(np.random.default_rng(1).standard_normal(500), 1.0)
    allan.fitted(np.random.default_rng(1).standard_normal(768), 1.0)
    with pytest.raises(BoresightError, match="all samples are the same number"):
        allan.fitted(np.full(1000, 0.1), 1.0)


def test_flicker_is_made_with_the_spectrum_that_it_has():
    """The maker, by a periodogram: 1/(2 pi f) with two sides, where a sample's mean changes nothing."""
    made = np.array([flicker(4096, np.random.default_rng(k)) for k in range(60)])
    window = np.hanning(4096)
    power = np.mean(np.abs(np.fft.rfft((made - made.mean(axis=1, keepdims=True)) * window)) ** 2, axis=0)
    f = np.fft.rfftfreq(4096)[20:400]
    assert np.mean(power[20:400] / np.sum(window**2) * 2 * np.pi * f) == pytest.approx(1, abs=0.03)
