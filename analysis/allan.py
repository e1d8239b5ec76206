"""Overlapping Allan deviation of a signal at rest, what its points have in common, and five noises fitted to it.

The noises are those of IEEE 952, by what the Allan variance of the rate holds of each at an average of tau: 3 Q^2/tau^2
of quantisation, N^2/tau of a random walk of the angle, 2 ln2/pi B^2 of bias instability (spectrum B^2/(2 pi f)),
K^2 tau/3 of a random walk of the rate, R^2 tau^2/2 of a ramp.

Points of one curve are made from the same samples.  Of a Gaussian process the covariance of two of them is known: it is
the sum, over all pairs of second differences, of the squared covariance of the two (Isserlis); with a ramp, of four
times its mean square more.  So the fit weighs them by that matrix, and its intervals need no independence.
"""

from dataclasses import dataclass
from functools import cache

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array

TERMS = ("quantisation", "random walk", "instability", "rate random walk", "ramp")
FLOOR = 2 * np.log(2) / np.pi  # of B^2 in the Allan variance
FEWEST = 6  # averages of the longest kind in a log
LEAST = 8  # octaves of a curve to which five noises can be fitted
SURE = 2.0  # sigmas of an interval, 95 %
RAMP = 3.0  # sigmas at which a ramp is fitted
UNFIT = 1e-3  # probability of a misfit below which the points are not those of the five noises
PER_AVERAGE = 8, 512  # lags at which their covariance is taken, in the shorter and in the longer average


def basis(tau: Array) -> Array:
    """(K, 5) Allan variance of each of TERMS with a coefficient of one, tau (K,) in s."""
    one = np.ones_like(tau)
    return np.stack([3 / tau**2, 1 / tau, FLOOR * one, tau / 3, tau**2 / 2], axis=-1)


def averages(samples: int) -> Array:
    """(K,) samples in an average: octaves, so long that FEWEST of them fit into the log."""
    return 2 ** np.arange(int(np.log2(max(1, samples // FEWEST))) + 1)


def variances(rates: Array, dt: float, lengths: Array) -> Array:
    """(K, ...) overlapping Allan variance of rates (N, ...) at averages of `lengths` (K,) samples of dt s."""
    total = np.concatenate([np.zeros((1, *rates.shape[1:])), np.cumsum(rates - rates.mean(axis=0), axis=0)])
    out = []
    for m in lengths:
        second: Array = total[2 * m :] - 2 * total[m:-m] + total[: -2 * m]
        out.append(np.einsum("k...,k...->...", second, second) / len(second) / (2.0 * m**2))
    return np.array(out)


# ---------------------------------------------------------------- what two points have in common


def _structure(lag: Array) -> Array:
    """(3, L) generalised covariance of the integral of a rate, per square of N, B and K: what differences of it have.

    Its second difference over m samples has the variance 2 m^2 sigma^2(m): -8 s(m) + 2 s(2m).
    """
    t = np.abs(lag).astype(float)
    logarithm = np.log(np.where(t > 0, t, 1.0))
    return np.stack([-t / 2, t**2 * logarithm / (2 * np.pi), t**3 / 12])


_STENCIL = np.array([1.0, -2.0, 1.0])


def _covariances(short: int, long: int, lag: Array) -> Array:
    """(3, L) covariance of second differences over `short` and `long` samples, the latter beginning `lag` later."""
    out = np.zeros((3, len(lag)))
    for i, a in enumerate(_STENCIL):
        for j, b in enumerate(_STENCIL):
            out += a * b * _structure(lag + j * long - i * short)
    return out


def _overlaps(lag: Array, short: int, long: int) -> Array:
    """How many pairs of `short` and `long` differences there are, the second beginning `lag` later than the first."""
    return np.clip(np.minimum(short, long - lag) - np.maximum(0, -lag), 0, None).astype(float)


@cache
def _pair(samples: int, short: int, long: int) -> tuple[Array, Array]:
    """Sums over all pairs of second differences, of the products of covariances (4, 4), and of covariances (4,).

    In the order of Q, N, B and K, per square of each, in samples.
    """
    counts = samples + 1 - 2 * short, samples + 1 - 2 * long
    step = max(1, short // PER_AVERAGE[0], long // PER_AVERAGE[1])
    reach = min(samples, 8 * (short + long)) // step
    lag = np.arange(-reach, reach + 1) * step
    weight = _overlaps(lag, *counts) * step
    smooth = _covariances(short, long, lag)
    # White noise of the angle is in common at single lags only.
    shifts, place = np.unique((short * np.arange(3)[:, None] - long * np.arange(3)).ravel(), return_inverse=True)
    white = np.bincount(place, np.outer(_STENCIL, _STENCIL).ravel())
    single = _overlaps(shifts, *counts)
    there = _covariances(short, long, shifts)
    products, sums = np.zeros((4, 4)), np.zeros(4)
    products[1:, 1:] = (smooth * weight) @ smooth.T
    products[0, 0] = single @ white**2
    products[0, 1:] = products[1:, 0] = there @ (white * single)
    sums[0], sums[1:] = white @ single, smooth @ weight
    return products, sums


def covariance(squares: Array, samples: int, dt: float, lengths: Array) -> Array:
    """(K, K) covariance of the overlapping Allan variances of a log of `samples`, by the process that makes it.

    squares: (5,) Q^2, N^2, B^2, K^2 and R^2.
    """
    # in samples: the angle in units of a rate times dt
    Q, N, B, K, R = squares * np.array([1 / dt**2, 1 / dt, 1.0, dt, dt**2])
    process = np.array([Q, N, B, K])
    out = np.zeros((len(lengths), len(lengths)))
    for i, short in enumerate(lengths.tolist()):
        for j, long in enumerate(lengths.tolist()[i:], i):
            products, sums = _pair(samples, short, long)
            total = 2 * process @ products @ process + 4 * R * short**2 * long**2 * process @ sums
            scale = (samples + 1 - 2 * short) * (samples + 1 - 2 * long) * 4.0 * short**2 * long**2
            out[i, j] = out[j, i] = total / scale
    return out


# ---------------------------------------------------------------- the fit


@dataclass(frozen=True)
class Fit:
    """Five noises of one signal, in s and the unit of its rate, and the curve that they were read from.

    coefficients, low, high, seen: (5,) by TERMS; low and high of 95 %, of a ramp three sigmas; what is
    not seen has its limit in high.
    tau, deviation: (K,) the measured curve; deviation_low, deviation_high: of 95 %; freedom: (K,) its equivalent
    degrees of freedom under the fitted process.  used: (K,) bool, the points that were fitted.  model: (K,) the fitted
    curve; share: (K, 5) of each noise in its square.  misfit: chi-square of what is left; probability: of one as large.
    """

    coefficients: Array
    low: Array
    high: Array
    seen: Array
    tau: Array
    deviation: Array
    deviation_low: Array
    deviation_high: Array
    freedom: Array
    used: Array
    model: Array
    share: Array
    misfit: float
    probability: float

    def read_from(self, term: int) -> tuple[float, float]:
        """s, from where to where a noise is more than half of what is fitted; where nowhere, twice where it is most."""
        share = self.share[:, term]
        most = np.flatnonzero(share > 0.5)
        most = most if len(most) else np.array([share.argmax()])
        return float(self.tau[most[0]]), float(self.tau[most[-1]])


def fitted(rates: Array, dt: float) -> Fit:
    """Five noises of a rate at rest, by generalised least squares on its overlapping Allan variances.

    No variance of the process is below zero.  A ramp is fitted only where it is seen by three sigmas: where it is not,
    it would take all that the longest averages know of the random walk of the rate.  Where the shortest averages do not
    fit, as behind a filter of the sensor, they are left out, to half of the curve.

    Parameters
    ----------
    rates : (N,) array
        Mean rates of one axis, in any unit; increments divided by dt.
    dt : float
        s, from one sample to the next.

    Returns
    -------
    Fit
        `coefficients`, `low`, `high` and `seen`, (5,) in the order quantisation, random walk, instability, rate random
        walk and ramp, in s and the unit of the rate; the curve, and which part of it each was read from.

    Raises
    ------
    BoresightError
        Too few samples, or all of them the same.

    Notes
    -----
    When not to use it: on a signal in motion, or on one that a vibration or the temperature drives: `identify` looks
    for both.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import noise
    >>> rng = np.random.default_rng(2)
    >>> white = noise.fitted(np.radians(0.05) * rng.standard_normal(20_000), dt=0.01)
    >>> limits = np.array([white.low[1], white.coefficients[1], white.high[1]])
    >>> print((np.degrees(limits) * 60).round(3), white.seen)
    [0.294 0.299 0.305] [False  True False False False]
    """
    from scipy.special import gammaincinv  # of scipy.stats, which takes a second to import, the same number

    samples, lengths = len(rates), averages(len(rates))
    if len(lengths) < LEAST:
        raise BoresightError(
            f"{samples} samples are too few for an Allan deviation; {FEWEST * 2 ** (LEAST - 1)} are not"
        )
    if not np.ptp(rates) > 0:
        raise BoresightError("all samples are the same number: its steps are too coarse, or nothing is measured")
    squares = variances(rates, dt, lengths)
    tried = []
    for first in range(len(lengths) // 2):
        with_ramp = solved = _solve(squares[first:], samples, dt, lengths[first:], 5)
        if not with_ramp.interval(4, RAMP)[2]:
            solved = _solve(squares[first:], samples, dt, lengths[first:], 4)
        tried.append((solved, with_ramp))
        if solved.probability > UNFIT:
            break
    best, with_ramp = max(tried, key=lambda one: one[0].probability)
    bounds = [*(best.interval(term, SURE) for term in range(4)), with_ramp.interval(4, RAMP)]
    low, high, seen = (np.array(one) for one in zip(*bounds, strict=True))
    tau = lengths * dt
    parts = basis(tau) * best.squares
    model = parts.sum(axis=-1)
    freedom = 2 * model**2 / np.diag(covariance(best.squares, samples, dt, lengths))
    ratio = [2 * gammaincinv(freedom / 2, q) / freedom for q in (0.975, 0.025)]
    return Fit(
        coefficients=np.sqrt(np.maximum(best.hat, 0)), low=np.sqrt(low), high=np.sqrt(high), seen=seen, tau=tau,
        deviation=np.sqrt(squares), deviation_low=np.sqrt(squares / ratio[0]),
        deviation_high=np.sqrt(squares / ratio[1]), freedom=freedom, used=tau >= best.lengths[0] * dt,
        share=parts / model[:, None], model=np.sqrt(model), misfit=best.misfit, probability=best.probability,
    )  # fmt: skip


@dataclass(frozen=True)
class _Solved:
    """Squares of the coefficients that are not below zero, (5,), and the linear estimate that knows no such bound."""

    squares: Array  # (5,)
    hat: Array  # (5,)
    rows: Array  # (5, K): hat = rows @ variances
    misfit: float
    probability: float
    samples: int
    dt: float
    lengths: Array

    def interval(self, term: int, sigmas: float) -> tuple[float, float, bool]:
        """Least and largest square of a coefficient, and whether it is above zero.

        Those values of it which the estimate is within so many sigmas of, the sigma being that of the value: the
        variance of the estimate is a quadratic form of the process, a + b value + c value^2.  Where c is large, which
        is where few averages know of it, the estimate is about a chi-square of 2/c degrees of freedom, and that
        bounds the value where the parabola does not.
        """
        from scipy.special import gammaincinv, ndtr

        row, hat, z = self.rows[term], self.hat[term], sigmas**2
        if not row.any():
            return 0.0, 0.0, False
        unit = self.squares[term] or float(np.sqrt(row @ self._covariance(term, 0.0) @ row))
        a, one, two = (float(row @ self._covariance(term, k * unit) @ row) for k in (0, 1, 2))
        c = (two - 2 * one + a) / 2 / unit**2
        b = (one - a) / unit - c * unit
        seen = hat > 0 and hat**2 > z * a
        if not seen:
            hat = max(hat, 0.0)  # a limit of what is not seen is not below what noise alone would show
        # (value - hat)^2 = z (a + b value + c value^2)
        lead, half, rest = 1 - z * c, hat + z * b / 2, hat**2 - z * a
        root = np.sqrt(max(0.0, half**2 - lead * rest))
        least = max(0.0, rest / (half + root)) if seen else 0.0
        most = (half + root) / lead if lead > 0 else np.inf
        if c > 0:
            most = min(most, (hat + sigmas * np.sqrt(a)) / (c * gammaincinv(1 / c, ndtr(-sigmas))))
        return float(least), float(most), bool(seen)

    def _covariance(self, term: int, value: float) -> Array:
        squares = self.squares.copy()
        squares[term] = value
        return covariance(squares, self.samples, self.dt, self.lengths)


def _solve(variances: Array, samples: int, dt: float, lengths: Array, terms: int) -> _Solved:
    """Generalised least squares, the weights being those of the fitted process; the first `terms` of TERMS."""
    from scipy.optimize import nnls
    from scipy.special import gammaincc

    columns = basis(lengths * dt)[:, :terms]
    scale = variances.max() / columns.max(axis=0)
    columns = columns * scale
    found, _ = nnls(columns / variances[:, None], np.ones(len(variances)))
    squares = np.zeros(5)
    for _ in range(30):
        before, squares[:terms] = found, found * scale
        V = covariance(squares, samples, dt, lengths)
        V += 1e-9 * np.diag(np.diag(V))  # of a random walk of the rate alone, neighbours hardly differ
        white = np.linalg.inv(np.linalg.cholesky(V))
        found, left = nnls(white @ columns, white @ variances)
        if np.abs(found - before).max() < 1e-6 * found.max():
            break
    squares[:terms] = found * scale
    weighted = white @ columns
    rows = np.zeros((5, len(variances)))
    rows[:terms] = scale[:, None] * np.linalg.solve(weighted.T @ weighted, weighted.T @ white)
    misfit, of = float(left**2), len(variances) - int(np.sum(found > 0))
    return _Solved(
        squares, rows @ variances, rows, misfit, float(gammaincc(of / 2, misfit / 2)), samples, dt, lengths
    )  # fmt: skip
