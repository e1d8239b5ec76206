"""P is the spread of a hundred flights of strapdown and filter, and their errors are those that it expects.

Each run draws its start and all noise as the model says, puts the start's errors in by `feedback`, and is read out by
the inverse of `feedback`.  The starts are so small that second orders stay below .1 sigma, which a flight with half of
every random number shows.
"""

from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from scipy.stats import chi2

from boresight.runtime.filter import Filter
from boresight.runtime.library import load

MODELS = (
    "azimuth-hold",
    "azimuth-hold-reference",
    "euler-matching",
    "velocity-attitude",
    "velocity-attitude-lever",
    "velocity-dcm",
)
RUNS, STEPS, DT = 100, 100, 0.05
UPDATE = 10  # steps between updates
RARE = 1e-3  # how often a right filter would be refused, per verdict

SIGMAS = {"rad": 1e-4, "m/s": 1e-2, "rad/s": 1e-5, "m/s^2": 1e-3, "m": 0.3, "s": 1e-3}  # of starts and of R, by unit
NOISE = {
    "gyro_noise": 3e-5,
    "accel_noise": 3e-3,
    "gyro_bias_noise": 3e-6,
    "accel_bias_noise": 3e-4,
    "mu_noise": 3e-5,
    "tau_noise": 3e-4,
}
UNIT = np.array([0.8, 0.2, -0.4, 0.4])
TRUE = {
    "q_b2n_wxyz": UNIT,
    "lat_lon_height": [0.6, 0.7, 9000.0],
    "lon_lat_height": [0.6, 0.7, 9000.0],
    "v_n": [30.0, -20.0, 1.0],
    "q_b2m_wxyz": UNIT[::-1],
    "gyro_bias": [1e-4, -2e-4, 1e-4],
    "accel_bias": [0.02, 0.01, -0.01],
    "mu": [0.0, 0.0, 0.0],  # some H are of first order in it
    "lever_b": [3.0, -2.0, 1.0],
    "tau": 0.1,
    "reference_error": 0.01,
}
KNOWN = {
    "omega_in_n": [5e-5, 1e-5, -3e-5],
    "omega_nm_n": [0.05, -0.1, 0.2],
    "a_n": [0.5, -0.3, 0.2],
    "lever_b": TRUE["lever_b"],
    "lag": 0.0,  # the slave is given as it was tau_hat ago
    "dt": DT,
}


def increments(k):
    """Of rate and specific force over the step k, exactly: a body that turns and accelerates as sinusoids."""
    start, end, phase, w = k * DT, (k + 1) * DT, np.arange(3.0), 2 * np.pi / np.array([2.0, 3.0, 5.0])

    def integral(mean, amplitude):
        return np.array(mean) * DT + amplitude * (np.cos(w * start + phase) - np.cos(w * end + phase)) / w

    return integral([0.02, -0.03, 0.1], 0.1), integral([0.5, -0.3, 9.8], 1.0)


class Changed:
    """The functions of a library, with what `change` makes of the result of some of them."""

    def __init__(self, library, change):
        self.library, self.change = library, change

    def __getattr__(self, name):
        unit = getattr(self.library, name)
        if name not in self.change:
            return unit
        called = lambda **fields: self.change[name](unit(**fields))  # noqa: E731
        called.fields = unit.fields
        return called


def unit_of(block):
    listed = block["unit"].split(", ")
    return listed if len(listed) == block["size"] else listed * block["size"]


def named(result, name):
    return result if isinstance(result, dict) else {name: result}


def took_out(library, nav, x):
    """nav with the errors x taken out."""
    known = {name: nav[name] for name in library.feedback.fields if name != "x"}
    return {**nav, **named(library.feedback(**known, x=x), "q_b2n_wxyz")}


def read_out(library, hat, true):
    """The x that feedback takes out of hat to have true, (runs, n): Newton's method."""
    n, names = len(library.states), [r["name"] for r in library.manifest["units"]["feedback"]["results"]]

    def seen(nav):
        return np.concatenate([np.reshape(nav[name], (RUNS, -1)) for name in names], -1)

    ends = [seen(took_out(library, hat, np.tile(sign * 1e-5 * e, (RUNS, 1)))) for e in np.eye(n) for sign in (1, -1)]
    slope = np.stack([(a - b) / 2e-5 for a, b in zip(ends[::2], ends[1::2], strict=True)], -1)
    inverse, x = np.linalg.pinv(slope), np.zeros((RUNS, n))
    for _ in range(3):
        x = x - np.einsum("rij,rj->ri", inverse, seen(took_out(library, hat, x)) - seen(true))
    return x


def turned(q, angle):
    """The attitude q turned by the rotation vector, in n."""
    both = Rotation.from_rotvec(angle) * Rotation.from_quat(q, scalar_first=True)
    return both.as_quat(scalar_first=True)


def euler(q):
    return Rotation.from_quat(q, scalar_first=True).as_euler("ZYX")[:, ::-1]


def reported(library, true, sensed, late):
    """What the master reports of the truth, `late` (runs) seconds after the instant of the slave."""
    q, v, omega = true["q_b2n_wxyz"], true.get("v_n", 0.0), np.array(KNOWN["omega_nm_n"])
    if "expected" in library.units:
        expected = library.expected(**{f: {**KNOWN, **sensed, **true}[f] for f in library.expected.fields})
        q, v, omega = expected["q_m2n_wxyz"], expected["v_m_n"], expected["omega_nb_n"]
    q, v = turned(q, late[:, None] * omega), v + late[:, None] * KNOWN["a_n"]
    return {"v_m_n": v, "q_m2n_wxyz": q, "euler_m": euler(q), "q_ref_wxyz": true["q_b2n_wxyz"]}


@cache
def fly(name, updates=True, size=1.0, change=None):
    """A hundred flights; size: of every random number; change: (unit, what becomes of its result)."""
    library = load(name, lanes=1)
    rng, n = np.random.default_rng([2024, MODELS.index(name)]), len(library.states)
    blocks = library.manifest["blocks"]
    sigma = np.array([SIGMAS[unit] for block in blocks for unit in unit_of(block)])
    sigma[[s in ("d_lon", "d_lat") for s in library.states]] = SIGMAS["m"] / 6.4e6
    root = np.eye(n) + 0.3 * rng.standard_normal((n, n)) / np.sqrt(n)
    P0 = size**2 * (root @ root.T) * sigma[:, None] * sigma
    noise = {f: size * NOISE[f] * np.ones(() if f == "tau_noise" else 3) for f in library.Q.fields if f in NOISE}
    quiet = {f: (0 if f in ("gyro_noise", "accel_noise") else 1) * value for f, value in noise.items()}

    fields = {*library.feedback.fields, *library.strapdown.fields} & set(TRUE)
    true = {f: np.array(np.broadcast_to(TRUE[f], (RUNS, *np.shape(TRUE[f])))) for f in TRUE if f in fields}
    # the inverse of feedback: it turns the other way, and numbers grow by x
    hat = took_out(library, true, -rng.standard_normal((RUNS, n)) @ np.linalg.cholesky(P0).T)
    filter = Filter(Changed(library, dict([change] if change else ())), hat, np.broadcast_to(P0, (RUNS, n, n)))
    taken = {r["name"] for r in library.manifest["units"]["feedback"]["results"]}
    before, innovations = None, []

    def sensors(pair, bias):
        """What the sensors deliver, and the step before."""
        pair = [one + DT * bias.get(of, 0.0) for one, of in zip(pair, ("gyro_bias", "accel_bias"), strict=True)]
        return [np.broadcast_to(one, (RUNS, 3)) for one in pair]

    for k in range(STEPS):
        # the noise of biases, misalignment, delay drives the truth, which knows its own
        walk = library.Qc(**{f: {**true, **quiet}[f] for f in library.Qc.fields})
        spread = np.sqrt(np.diagonal(walk, axis1=-2, axis2=-1) * DT)
        true = took_out(library, true, spread * rng.standard_normal((RUNS, n)))
        clean = sensors(increments(k), true)
        noisy = [
            one + noise.get(of, 0.0) * np.sqrt(DT) * rng.standard_normal((RUNS, 3))
            for one, of in zip(clean, ("gyro_noise", "accel_noise"), strict=True)
        ]
        before = before or (clean, noisy)
        names = ("dtheta_ib_b", "dv_b", "dtheta_before", "dv_before")
        given = [dict(zip(names, (*now, *old), strict=True)) for now, old in zip((clean, noisy), before, strict=True)]
        before = clean, noisy
        rate = {f: noisy[i] / DT - filter.nav.get(b, 0.0) for i, (f, b) in enumerate(SENSED)}
        if "lat_lon_height" not in taken and "lat_lon_height" in true:
            filter.nav["lat_lon_height"] = true["lat_lon_height"]  # which the filter takes from the master
        start = filter.nav
        filter.strapdown(**read(library, KNOWN | given[1]))
        end, filter.nav = filter.nav, middle(start, filter.nav)
        filter.predict(**read(library, KNOWN | rate | noise))
        filter.nav = end
        step = {f: {**KNOWN, **given[0], **true}[f] for f in library.strapdown.fields}
        true = {**true, **named(library.strapdown(**step), "q_b2n_wxyz")}
        if updates and k % UPDATE == UPDATE - 1:
            innovations += updated(library, filter, true, clean, size, rng)
            filter.feedback()
    if "lat_lon_height" not in taken and "lat_lon_height" in true:
        filter.nav["lat_lon_height"] = true["lat_lon_height"]
    return SimpleNamespace(errors=read_out(library, filter.nav, true), P=filter.P, innovations=innovations)


def updated(library, filter, true, clean, size, rng):
    """Takes every measurement of a constant H: its z beside that of the truth, and noise as R says."""
    hat, found = filter.nav, []

    def seen(nav, late):
        sensed = {f: clean[i] / DT - nav.get(b, 0.0) for i, (f, b) in enumerate(SENSED)}
        return {**KNOWN, **sensed, **reported(library, true, sensed, late), **nav, "euler_b": euler(nav["q_b2n_wxyz"])}

    at_truth, now = seen(true, np.zeros(RUNS)), seen(hat, np.reshape(hat.get("tau", 0.0) - true.get("tau", 0.0), -1))
    for name, described in library.manifest["measurements"].items():
        z, sigma = getattr(library, f"{name}_z"), size * SIGMAS[described["unit"]]
        if "x" in getattr(library, f"{name}_H").fields:
            continue
        exact = z(**{f: at_truth[f] for f in z.fields})
        noise = sigma * rng.standard_normal(exact.shape)
        filter.model.change[f"{name}_z"] = lambda value, exact=exact, noise=noise: value - exact + noise
        given = read(library, {f: v for f, v in now.items() if f not in hat})
        found.append(filter.update(name, np.full(exact.shape[-1], sigma**2), **given))
    return found


SENSED = (("omega_ib_b", "gyro_bias"), ("f_b", "accel_bias"))


def read(library, inputs):
    """Those that the model has."""
    return {name: value for name, value in inputs.items() if name in library.field}


def middle(start, end):
    """Between two instants; of a quaternion not quite of unit norm."""
    return {name: (start[name] + end[name]) / 2 for name in end}


def whitened(flown):
    """(runs, n): the errors in units of the covariance, independent and of variance one where P is right."""
    return np.linalg.solve(np.linalg.cholesky(flown.P), flown.errors[..., None])[..., 0]


def correlation(u):
    """(...): of whitened errors (..., runs, n), the sum of the squares of all mean products of two of them."""
    products = np.swapaxes(u, -1, -2) @ u / u.shape[-2]
    return np.sum(np.tril(products, -1) ** 2, axis=(-2, -1))


@cache
def largest_correlation(n):
    """What a thousandth of spreads exceeds, of as many runs of exact normal numbers."""
    drawn = np.random.default_rng(n).standard_normal((1000, RUNS, n))
    return np.quantile(correlation(drawn), 1 - RARE)


def outside(mean, count, of=1):
    """Whether the mean of `count` squares of normal numbers is a rare one, of so many that are looked at."""
    low, high = chi2.ppf([RARE / of / 2, 1 - RARE / of / 2], count) / count
    return not low < mean < high


def refused(flown):
    """The verdicts that a right filter would get once in a thousand flights."""
    u, n = whitened(flown), flown.errors.shape[-1]
    ratios = (flown.errors**2 / np.diagonal(flown.P, axis1=-2, axis2=-1)).mean(0)
    nis = sum(innovation.nis.sum() for innovation in flown.innovations)
    count = sum(innovation.nu.size for innovation in flown.innovations)
    verdicts = {
        "variance": any(outside(ratio, RUNS, n) for ratio in ratios),
        "covariance": correlation(u) > largest_correlation(n),
        "NEES": outside((u**2).mean(), u.size),
        "NIS": count > 0 and outside(nis / count, count),
    }
    return {name for name, wrong in verdicts.items() if wrong}


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("updates", [False, True], ids=["carried", "updated"])
def test_P_is_the_spread_of_a_hundred_flights(name, updates):
    assert refused(fly(name, updates)) == set()


@pytest.mark.parametrize("name", MODELS)
def test_second_orders_of_these_flights_are_below_a_tenth_of_a_sigma(name):
    whole, half = fly(name), fly(name, size=0.5)
    sigma = np.sqrt(np.diagonal(whole.P, axis1=-2, axis2=-1))
    assert np.abs((whole.errors - 2 * half.errors) / sigma).max() < 0.1


BROKEN = {
    "twice the noise": ("Q", lambda Q: 2 * Q),
    "Phi transposed": ("Phi", lambda Phi: np.swapaxes(Phi, -1, -2)),
    "Phi of the other sign": ("Phi", lambda Phi: 2 * np.eye(Phi.shape[-1]) - Phi),
}


@pytest.mark.parametrize("what", BROKEN)
def test_a_filter_that_is_wrong_is_refused(what):
    assert refused(fly("velocity-dcm", False, change=BROKEN[what]))


def test_an_update_by_a_wrong_H_is_refused():
    assert "NIS" in refused(fly("velocity-dcm", True, change=("velocity_H", lambda H: 0.7 * H)))
