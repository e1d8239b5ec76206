"""The smoother beside batch least squares, in 50 digits where it is linear, and beside truth."""

from itertools import pairwise

import numpy as np
import pytest
from conftest import ROOT
from flint import arb_mat
from scipy.optimize import least_squares
from scipy.stats import chi2

from boresight import BoresightError, CompiledFilter, Filter, Record, load, smooth
from boresight.derive.ledger.numbers import digits
from tests.analysis import test_budget_flights as flights


class Linear:
    """A model of any Phi and Q, given with each step, and one measurement of any H."""

    def __init__(self, n):
        self.states = tuple(f"s{i}" for i in range(n))
        self.Phi, self.Q, self.seen_H = given("phi"), given("q"), given("h")


def given(name):
    """A function that returns its one input."""

    def function(**inputs):
        return inputs[name]

    function.fields = (name,)
    return function


def walk(z, Q, R, P0, Phi, x0=None):
    """Smoothed states of a flight that begins with a measurement; Phi, Q: of each step between."""
    n = len(P0)
    loop = Filter(Linear(n), {}, P0, x=np.zeros(n) if x0 is None else x0)
    record = Record(loop)
    for k, value in enumerate(z):
        if k:
            loop.predict(phi=Phi[k - 1], q=Q[k - 1])
        loop.update("seen", R, z=[value], h=np.eye(n)[:1])
    return record, smooth(record), record.rows("seen")


def test_a_random_walk_has_the_published_values():
    one = np.ones((1, 1))
    _, found, rows = walk([1, 2, 3], [one] * 2, 1.0, one, [one] * 2)
    assert np.allclose(found.x[rows, 0], np.array([12, 23, 31]) / 13, rtol=0, atol=1e-15)
    assert np.allclose(found.P[rows, 0, 0], np.array([5, 6, 8]) / 13, rtol=0, atol=1e-15)


def test_unequal_steps_have_the_published_values():
    dts = [1.0, 2.0, 0.5]
    Phi = [np.array([[1, dt], [0, 1]]) for dt in dts]
    Q = [0.1 * np.array([[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]]) for dt in dts]
    _, found, rows = walk([0, 1, 3.5, 4], Q, 0.25, np.diag([1.0, 4.0]), Phi)
    assert np.allclose(found.x[rows, 0], [-0.028858, 1.092725, 3.427056, 4.016292], rtol=0, atol=5e-7)
    assert np.allclose(found.P[rows, 0, 0], [0.151355, 0.096214, 0.105031, 0.148661], rtol=0, atol=5e-7)


# ---------------------------------------------------------------- 50 digits


def batch(A, Q, P0, H, R, z, wanted):
    """Best linear estimates of some states of x_k+1 = A_k x_k + w_k, and their covariances, in 50 digits.

    Of all measurements at once: cov(x, z) cov(z, z)^-1.  H[k] is None where nothing is measured.
    """
    with digits(50):
        A, P = [exact(a) for a in A], [exact(P0)]
        for a, q in zip(A, Q, strict=True):
            P.append(a * P[-1] * a.transpose() + exact(q))
        taken = [k for k, h in enumerate(H) if h is not None]
        rows = {k: exact([H[k]]) for k in taken}
        # of each pair cov(x_i, x_j) h_j: down from the diagonal by A', up by A
        across = {}
        for j in taken:
            row = rows[j].transpose()
            across[j, j] = column = P[j] * row
            for i in range(j, len(A)):
                across[i + 1, j] = column = A[i] * column
            for i in range(j - 1, -1, -1):
                row = A[i].transpose() * row
                across[i, j] = P[i] * row
        S = arb_mat([[(rows[i] * across[i, j])[0, 0] + (R if i == j else 0) for j in taken] for i in taken])
        values = exact([[z[k]] for k in taken])
        out = []
        for k in wanted:
            C = arb_mat([[across[k, j][i, 0] for j in taken] for i in range(P[0].nrows())])
            gain = S.solve(C.transpose()).transpose()
            out.append((middles(gain * values)[:, 0], middles(P[k] - gain * C.transpose())))
    return out


def exact(rows):
    return arb_mat(np.asarray(rows, float).tolist())


def middles(found):
    """Floats, of balls whose radii 50 digits leave far below any digit that is compared."""
    rows = np.array([[(float(entry.mid()), float(entry.rad())) for entry in row] for row in found.tolist()])
    assert (rows[..., 1] <= 1e-12 * np.abs(rows[..., 0]) + 1e-30).all()
    return rows[..., 0]


def test_200_steps_agree_with_batch_least_squares_in_50_digits():
    """Sigmas over ten decades, a state without variance, rows that are missing, a reset, noise, a state left out."""
    rng, n = np.random.default_rng(0), 5
    scale = np.array([1e5, 1e2, 1e-5, 0.0, 1.0])
    F = np.zeros((n, n))
    F[0, 1], F[1, 2], F[1, 3], F[4, 4] = 1.0, 1e5, 1.0, -0.2
    Phi, q = np.eye(n) + F * 0.1 + F @ F * 0.005, np.diag([0, 1e-2, 1e-14, 0, 1e-2]) * 0.1
    start = np.array([0, 0, 0, 2.0, 0])
    loop = Filter(Linear(n), {}, np.diag(scale**2), x=start)
    record, truth = Record(loop), start + scale * rng.standard_normal(n)
    # the witness: x_k+1 = A x_k + b + noise of covariance Q
    A, Q, b, H, z, nodes = [], [], [], [None], [None], []

    def carry(kept, a, noise):
        """What is not kept is known as it is from here on, or begins there: its estimate is its mean."""
        kept = np.array(kept)
        A.append(kept[:, None] * a)
        Q.append(noise)
        b.append((1 - kept) * loop.x)
        H.append(None)
        z.append(None)

    every = [1.0] * n
    for k in range(200):
        loop.predict(phi=Phi, q=q)
        known = [1, 1, 1, 1, 0.0] if 100 < k <= 120 else every  # what is disabled
        carry(known, Phi, q * known)
        truth = Phi @ truth + np.sqrt(np.diag(q)) * rng.standard_normal(n)
        if k == 60:
            loop.set_block(1, [[25.0]])
            carry([1, 0, 1, 1, 1], np.eye(n), np.diag([0.0, 25, 0, 0, 0]))
        if k == 90:
            loop.inflate(2, [1e-10])
            carry(every, np.eye(n), np.diag([0, 0, 1e-10, 0, 0]))
        if k == 100:
            loop.disable(4)
            carry([1, 1, 1, 1, 0], np.eye(n), np.zeros((n, n)))
        if k == 120:
            loop.enable(4, [[4.0]])
            carry([1, 1, 1, 1, 0], np.eye(n), np.diag([0.0, 0, 0, 0, 4]))
        h = np.array([1.0, 0, 0, 0, 1.0])
        value = h @ truth + 0.3 * rng.standard_normal()
        loop.update("seen", 0.09, z=[value], h=h[None], rows=[k % 3 > 0])
        if k % 3:
            H[-1], z[-1] = h, value
        nodes.append(len(H) - 1)
    found, rows = smooth(record), record.rows("seen")
    means = [start]
    for a, c in zip(A, b, strict=True):
        means.append(a @ means[-1] + c)
    less = [None if h is None else value - h @ mean for h, value, mean in zip(H, z, means, strict=True)]
    wanted = [0, 20, 59, 60, 95, 110, 199]
    exact = batch(A, Q, np.diag(scale**2), H, 0.09, less, [nodes[k] for k in wanted])
    for k, (x, P) in zip(wanted, exact, strict=True):
        sigma = np.sqrt(np.diag(P))
        none = sigma < 1e-20  # where 50 digits leave nothing of it
        assert none.tolist() == [False, False, False, True, k == 110]
        sigma = np.where(none, 1.0, sigma)
        assert (np.abs(found.x[rows[k]] - means[nodes[k]] - x) / sigma).max() < 1e-8, k
        assert (np.abs(found.P[rows[k]] - P) / np.outer(sigma, sigma)).max() < 1e-8, k
    assert (found.P[:, 3] == 0).all() and np.ptp(np.log10(np.sqrt(np.diag(record.P[0]))[[0, 2]])) >= 10 - 1e-12


def test_gnss_ins_with_feedback_agrees_with_batch_least_squares_in_50_digits(folder_of, monkeypatch):
    """The recursion alone, over sigmas from 1e-7 rad to 5 m: each feedback turns nothing, as the filter has it."""
    monkeypatch.syspath_prepend(ROOT / "examples")
    import fly_gnss_ins as example

    from boresight.analysis import smoother

    records = []

    def recorded(*args, **words):
        loop = CompiledFilter(*args, **words)
        records.append(Record(loop))
        return loop

    monkeypatch.setattr(example, "CompiledFilter", recorded)
    monkeypatch.setattr(example, "SECONDS", 6)
    monkeypatch.setattr(smoother, "frames", lambda record, table: np.tile(np.eye(15), (len(table.rows), 1, 1, 1)))
    example.fly(load(folder_of(example.MODEL)), runs=1, seed=3)
    record = records[0]
    x, names, steps, found = record.x[:, 0], record.names, smoother.changes(record), smooth(record)
    # the witness takes the rows of a measurement one after the other, in sigmas
    sigma = {"position": example.FIX_M, "velocity": example.FIX_M_S}
    H = {name: record.jacobian(name)[:, 0] for name in sigma}
    K = {name: record.gain(name)[:, 0] for name in sigma}
    nu = {name: record.innovation(name).nu[:, 0] for name in sigma}
    A, Q, h, less, means, nodes = [], [], [None], [None], [x[0]], [0]
    for row in range(1, len(names)):
        name = names[row]
        if name in sigma:
            k, at = np.searchsorted(record.rows(name), row), x[row - 1]
            for i in range(3):
                A.append(np.eye(15))
                Q.append(np.zeros((15, 15)))
                means.append(means[-1])
                h.append(H[name][k, i] / sigma[name])
                less.append((nu[name][k, i] + H[name][k, i] @ (at - means[-1])) / sigma[name])
                at = at + K[name][k, :, i] * nu[name][k, i]
        else:
            a, q = (np.broadcast_to(part, (1, 15, 15))[0] for part in steps[row][:2])
            A.append(a)
            Q.append(q)
            h.append(None)
            less.append(None)
            means.append(a @ means[-1] + x[row] - a @ x[row - 1])
        nodes.append(len(h) - 1)
    wanted = [0, 30, len(names) - 1]
    for row, (exact, P) in zip(
        wanted, batch(A, Q, record.P[0, 0], h, 1, less, [nodes[k] for k in wanted]), strict=True
    ):
        scale = np.sqrt(np.diag(P))
        assert (np.abs(found.x[row, 0] - means[nodes[row]] - exact) / scale).max() < 1e-10
        assert (np.abs(found.P[row, 0] - P) / np.outer(scale, scale)).max() < 1e-10


# ---------------------------------------------------------------- feedback, lag, runs


@pytest.fixture(scope="module")
def vertical(folder_of):
    return load(folder_of(f"{ROOT / 'examples' / 'vertical.py'}:VERTICAL"))


def descent(vertical, kind, feedback, runs=(), steps=40):
    """A linear flight, corrected after every third measurement, or never; its record."""
    rng = np.random.default_rng(2)
    nav = {"height": np.full(runs, 1000.0), "speed": np.full(runs, -3.0), "bias": np.zeros(runs)}
    loop = kind(vertical, nav, np.diag([20.0, 3.0, 0.2]) ** 2)
    record = Record(loop)
    for k in range(steps):
        dv = (9.81 + 0.1) * 0.5 + 0.02 * rng.standard_normal(runs)
        loop.strapdown(dv=dv, dt=0.5)
        loop.predict(accel_noise=0.02, bias_noise=0.003, dt=0.5)
        loop.update("altitude", 4.0, baro=980.0 - 1.5 * k + 2 * rng.standard_normal(runs), rows=k % 4 != 1)
        if feedback and k % 3 == 2:
            loop.feedback()
    return record


@pytest.mark.parametrize("kind", [Filter, CompiledFilter])
def test_feedback_changes_nothing_of_a_linear_flight(vertical, kind):
    fed, open_loop = (descent(vertical, kind, feedback) for feedback in (True, False))
    at = {name: record.rows("altitude") for name, record in (("fed", fed), ("open", open_loop))}
    one, other = smooth(fed), smooth(open_loop)
    assert np.abs(fed.taken()).max() > 5  # m
    assert np.allclose(one.P[at["fed"]], other.P[at["open"]], rtol=1e-9, atol=1e-14)
    for name in ("height", "speed", "bias"):
        assert np.allclose(one.nav[name][at["fed"]], other.nav[name][at["open"]], rtol=0, atol=1e-8)
    assert np.abs(one.nav["height"][at["fed"]] - fed.nav["height"][at["fed"]]).max() > 1


def test_a_lag_is_the_smoother_of_the_flight_until_then(vertical):
    record = descent(vertical, CompiledFilter, True)
    late, names = smooth(record, lag_s=3.0), record.names
    for k in (0, 7, 40):
        last = np.flatnonzero(record.time <= record.time[k] + 3.0)[-1]
        steps = sum(names[: last + 1] == "predict")
        part = descent(vertical, CompiledFilter, True, steps=steps)
        assert len(part.names) == last + 1
        until = smooth(part)
        assert np.allclose(late.x[k], until.x[k], rtol=0, atol=1e-12)
        assert np.allclose(late.P[k], until.P[k], rtol=1e-12, atol=0)
    none, whole = smooth(record, lag_s=0.0), smooth(record, lag_s=1e9)
    assert np.allclose(whole.P, smooth(record).P, rtol=1e-13, atol=0)
    assert np.array_equal(none.P[-1], record.P[-1]) and not np.allclose(none.P, whole.P)
    with pytest.raises(BoresightError, match="lag_s is -1"):
        smooth(record, lag_s=-1)
    with pytest.raises(BoresightError, match="'a folder' is no record; give Record"):
        smooth("a folder")


def test_a_lag_needs_a_time_that_passes():
    loop = Filter(Linear(1), {}, np.eye(1))
    record = Record(loop)
    loop.predict(phi=np.eye(1), q=np.eye(1))
    with pytest.raises(BoresightError, match="no prediction has a dt"):
        smooth(record, lag_s=1.0)
    assert smooth(record).P.shape == (2, 1, 1)


def test_runs_side_by_side_are_each_by_itself(vertical):
    many = smooth(descent(vertical, CompiledFilter, True, (2, 3)))
    assert many.x.shape[1:] == (2, 3, 3) and many.nav["height"].shape[1:] == (2, 3)
    record = descent(vertical, CompiledFilter, True, (2, 3))
    assert (np.diagonal(many.P, axis1=-2, axis2=-1) <= np.diagonal(record.P, axis1=-2, axis2=-1) * (1 + 1e-12)).all()
    alone = descent(vertical, Filter, True, (2, 3))
    assert np.allclose(smooth(alone).nav["height"], many.nav["height"], rtol=0, atol=1e-8)


def test_a_restart_ends_a_piece_and_nothing_goes_across(vertical):
    first = descent(vertical, CompiledFilter, False, steps=10)
    loop, alone = first.loop, smooth(first)
    count = len(first.names)
    loop.P = np.diag([20.0, 3.0, 0.2]) ** 2
    for _ in range(5):
        loop.strapdown(dv=5.0, dt=0.5)
        loop.predict(accel_noise=0.02, bias_noise=0.003, dt=0.5)
        loop.update("altitude", 4.0, baro=900.0)
    assert first.piece[-1] == 1
    assert np.array_equal(smooth(first).P[:count], alone.P) and np.array_equal(smooth(first).x[:count], alone.x)
    assert np.array_equal(smooth(first, lag_s=2.0).P[count - 1], alone.P[-1])


def test_with_considered_states_the_covariance_is_that_of_the_errors():
    """Error by error: a flight for each source of unit variance is a column, and the squares of the columns add up."""
    n, steps = 3, 12
    Phi = np.array([[1, 0.5, 0.1], [0, 0.9, 0.3], [0, 0, 1]])
    P0, q = np.diag([2.0, 1.0, 0.5]), np.diag([0.01, 0.04, 1e-3])
    H = np.array([[1.0, 0.2, 0.5], [0, 1, -0.4]])
    sources = n + steps * (n + 2)

    def flown(unit):
        start, noise = unit[:n], unit[n:].reshape(steps, n + 2)
        loop = Filter(Linear(n), {}, P0, x=np.zeros(n))
        record, x, truth = Record(loop), np.sqrt(np.diag(P0)) * start, []
        truth.append(x)
        for k, (w, v) in enumerate(zip(noise[:, :n], noise[:, n:], strict=True)):
            x = Phi @ x + np.sqrt(np.diag(q)) * w
            truth.append(x)
            loop.predict(phi=Phi, q=q)
            kept = [False, k == 2, k % 3 > 0]  # the third is corrected by each third measurement alone
            loop.update("seen", [0.3, 0.2], z=H @ x + np.sqrt([0.3, 0.2]) * v, h=H, considered=kept)
        found = smooth(record)
        return found, found.x[np.append(0, record.rows("seen"))] - truth, record

    columns = np.array([flown(unit)[1] for unit in np.eye(sources)])
    found, _, record = flown(np.zeros(sources))
    rows = np.append(0, record.rows("seen"))
    assert np.allclose(np.einsum("ski,skj->kij", columns, columns), found.P[rows], rtol=0, atol=1e-13)
    smaller = np.diagonal(found.P[rows], axis1=1, axis2=2) / np.diagonal(record.P[rows], axis1=1, axis2=2)
    assert smaller[0].max() < 0.7 and smaller[6, 2] < 0.9


@pytest.mark.parametrize("kind", [Filter, CompiledFilter])
def test_measurements_that_are_withdrawn_count_for_nothing(vertical, kind):
    """The flight goes on in its piece as if they had never come, of one run; the other has them."""
    ends = []
    for withdraw in (True, False):
        loop = kind(vertical, {"height": np.full(2, 1e3), "speed": 0.0, "bias": 0.0}, np.diag([20.0, 3.0, 0.2]) ** 2)
        record = Record(loop)
        for k in range(6):
            loop.strapdown(dv=9.81, dt=1.0)
            loop.predict(accel_noise=0.02, bias_noise=0.003, dt=1.0)
            x, P = loop.x.copy(), np.broadcast_to(loop.P, (2, 3, 3)).copy()
            there = np.array([[k != 3 or withdraw], [True]])
            loop.update("altitude", 4.0, baro=np.array([990.0, 980.0]), rows=there)
            if k == 3 and withdraw:
                off = np.array([True, False])
                loop.x, loop.P = np.where(off[:, None], x, loop.x), np.where(off[:, None, None], P, loop.P)
                record.withdrawn()
            loop.feedback()
        assert not record.piece.any()
        done = smooth(record)
        ends.append([part[np.isin(record.names, ("begin", "feedback"))] for part in (done.P, done.nav["height"])])
    for one, other in zip(*ends, strict=True):
        assert np.allclose(one, other, rtol=1e-12, atol=0)
    loop.update("altitude", 4.0, baro=990.0)
    loop.P = 2.0 * loop.P
    record.withdrawn()
    with pytest.raises(BoresightError, match="measurements were withdrawn, and x or P is not"):
        smooth(record)


def test_a_large_correction_of_a_rotation_is_taken_with_its_frame(library):
    """The smoothed attitude is one, whichever side of a feedback it is computed from."""
    loop = CompiledFilter(library, {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}, np.diag([0.04] * 3 + [1e-6] * 3))
    record = Record(loop)
    for euler in ([0.2, -0.15, 0.3], [0.22, -0.17, 0.26]):
        angles = {"euler_b": loop.call("euler_angles"), "euler_m": np.array(euler)}
        loop.update("euler_exact", np.full(3, 1e-4), **angles)
        loop.feedback()
    found, row = smooth(record), record.rows("feedback")[0]
    taken, left = record.taken()[0], found.x[row]
    assert np.abs(taken).max() > 0.1 and 0.01 < np.abs(left).max() < 0.05
    nav = {"q_b2n_wxyz": record.nav["q_b2n_wxyz"][row - 1], "mu": record.nav["mu"][row - 1]}
    after = found.nav["q_b2n_wxyz"][row]

    def apart(q):
        return 2 * np.linalg.norm(q * np.sign(q @ after) - after)

    # without the frame it is off by half of the cross product of what was taken and what was left
    without = apart(library.feedback(**nav, x=taken + left)["q_b2n_wxyz"])
    assert 0.3 < without / (np.linalg.norm(np.cross(taken[:3], left[:3])) / 2) < 3
    assert apart(found.nav["q_b2n_wxyz"][row - 1]) < 0.2 * without


# ---------------------------------------------------------------- nonlinear


@pytest.fixture(scope="module")
def pendulum(folder_of):
    return load(folder_of(f"{ROOT / 'examples' / 'pendulum.py'}:PENDULUM"))


def swing(pendulum, part, dt=0.05, steps=40):
    """How far the smoother is from the fixed point of Gauss-Newton, in sigma times `part`, the size of all sigmas."""
    rng, given = np.random.default_rng(3), {"rod": [1.0, 0.2], "dt": dt}
    begin, P0 = np.array([3.0, 2.0]), np.diag(part**2 * np.array([0.1, 0.3]) ** 2)
    jitter, R = 0.3 * part, (0.05 * part) ** 2
    x, z = begin + np.sqrt(np.diag(P0)) * rng.standard_normal(2), []
    loop = CompiledFilter(pendulum, {}, P0, x=begin)
    record = Record(loop)
    noises = []
    for _ in range(steps):
        Q = pendulum.Q(x=x, torque=jitter, **given)
        noises.append(np.linalg.cholesky(Q))
        x = pendulum.next(x=x, **given) + noises[-1] @ rng.standard_normal(2)
        x[0] = (x[0] + np.pi) % (2 * np.pi) - np.pi
        z.append((x[0] + 0.05 * part * rng.standard_normal() + np.pi) % (2 * np.pi) - np.pi)
        loop.predict(torque=jitter, **given)
        loop.update("encoder", R, z=[z[-1]])
    rows = np.append(0, record.rows("encoder"))
    found = smooth(record)
    wrap = lambda a: (a + np.pi) % (2 * np.pi) - np.pi  # noqa: E731

    def whitened(flat):
        states = flat.reshape(-1, 2)
        parts = [wrapped_first(states[0] - begin) / np.sqrt(np.diag(P0))]
        for k, (one, other) in enumerate(pairwise(states)):
            root = np.linalg.cholesky(pendulum.Q(x=record.x[rows[k]], torque=jitter, **given))
            ahead = pendulum.next(x=np.array([wrap(one[0]), one[1]]), **given)
            parts.append(np.linalg.solve(root, wrapped_first(other - ahead)))
        return np.concatenate([*parts, wrap(np.array(z) - states[1:, 0]) / np.sqrt(R)])

    def wrapped_first(d):
        return np.array([wrap(d[0]), d[1]])

    # the Jacobian has blocks of two
    best = least_squares(whitened, found.x[rows].ravel(), method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15)
    apart = found.x[rows] - best.x.reshape(-1, 2)
    apart[:, 0] = wrap(apart[:, 0])
    return np.abs(apart / found.sigma[rows]).max() * part


def test_the_pendulum_is_the_fixed_point_of_gauss_newton_to_second_order(pendulum):
    large, small = swing(pendulum, 0.1), swing(pendulum, 0.01)
    assert small < large / 60 and large < 0.02


def smoothed_nees(example, library, monkeypatch, times, runs):
    """NEES (times, runs) of the filter and of the smoother, at rows behind which truth is known."""
    kept, flown = [], {}

    class Judged(example.Consistency):
        def error(self, time, error, P):
            super().error(time, error, P)
            kept.append((flown["record"]._count - 1, np.array(error)))

    def recorded(*args, **words):
        loop = CompiledFilter(*args, **words)
        flown["record"] = Record(loop)
        return loop

    monkeypatch.setattr(example, "Consistency", Judged)
    monkeypatch.setattr(example, "CompiledFilter", recorded)
    example.fly(library, runs=runs, seed=7)
    record = flown["record"]
    found = smooth(record)
    out = []
    for row, error in (kept[round(part * (len(kept) - 1))] for part in times):
        for x, P in ((record.x[row], record.P[row]), (found.x[row], found.P[row])):
            out.append(judged(record.loop.wrapped(error + x - record.x[row] if record.total else error - x), P))
    return out[::2], out[1::2]


def judged(left, P):
    """Mean NEES of errors (runs, n), and the root mean square of each."""
    scale = np.sqrt(np.diagonal(P, axis1=-2, axis2=-1))
    M = P / scale[..., :, None] / scale[..., None, :]
    weighed = np.linalg.solve(M, (left / scale)[..., None])[..., 0] * left / scale
    return weighed.sum(-1).mean(), np.sqrt(np.mean(left**2, axis=0))


def law(n, runs, times):
    """Between which the mean NEES of n states lies, of so many runs and at so many times together, at 99.9 %."""
    part = 0.0005 / times
    return chi2.ppf([part, 1 - part], runs * n) / runs


@pytest.mark.parametrize(("name", "runs"), [("radar", 100), ("pendulum", 100), ("gnss_ins", 40)])
def test_smoothed_errors_lie_in_the_band_of_their_covariance(name, runs, folder_of, monkeypatch):
    monkeypatch.syspath_prepend(ROOT / "examples")
    example = __import__(f"fly_{name}")
    library = load(folder_of(example.MODEL))
    filtered, smoothed = smoothed_nees(example, library, monkeypatch, (0.1, 0.3, 0.5, 0.7, 0.9), runs)
    n = len(library.states)
    low, high = law(n, runs, 5)
    values = [value for value, _ in smoothed]
    assert all(low < value < high for value in values), (values, low, high)
    early = filtered[0][1] / smoothed[0][1]
    assert early.max() > 1.5 and early.min() > 0.8  # by how much the errors shrink


def test_smoothed_errors_of_an_alignment_lie_in_the_band_of_their_covariance():
    """Velocity and attitude in an S turn, by the nonlinear C; the filter believes what is true, or too little noise."""
    model = load("velocity-attitude")
    values = {}
    for case in ("right", "noise"):
        records = []
        errors = flights.fly(model, case, 100, 5, lambda loop, kept=records: kept.append(Record(loop)))
        (record,) = records
        found, rows = smooth(record), np.append(0, record.rows("feedback"))
        at = [1, 5, 10, 15, 19]
        values[case] = [
            [judged(errors[k] - x[rows[k]], P[rows[k]]) for k in at]
            for x, P in ((record.x, record.P), (found.x, found.P))
        ]
    low, high = law(16, 100, 5)
    for nees in values["right"]:
        assert all(low < value < high for value, _ in nees), (nees, low, high)
    assert not any(low < value < high for value, _ in values["noise"][1])
    filtered, smoothed = (rms for (_, rms) in (nees[0] for nees in values["right"]))
    assert (smoothed < filtered * 1.1).all() and (filtered[12:] > 1.5 * smoothed[12:]).all()  # mounting and delay
