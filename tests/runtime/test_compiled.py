"""The filter in C says what the Python loop says, to rounding, in the papers' studies and with every option."""

import numpy as np
import pytest

from boresight import BoresightError
from boresight.runtime.filter import CompiledFilter, Filter
from boresight.runtime.library import load
from boresight.studies.azimuth_hold import alignment as azimuth_alignment
from boresight.studies.azimuth_hold import hold as azimuth_hold
from boresight.studies.euler_table import table as euler_table

U = np.finfo(float).eps / 2


class Disturbed(Filter):
    """The Python loop, every result of which is off by what rounding may do to it.

    A sum of n products rounds n times, and a step of the covariance is three such sums: 3 n + 10 roundings, each of
    sigma_i sigma_j in P and of sigma_i in x, with the sigmas before an update, for its differences are of that size; a
    row is a step.  How far this carries the loop is how far another order of the same operations may: condition and
    length of the run are in it.
    """

    rng = np.random.default_rng(0)

    def disturb(self, steps=1):
        n = self.P.shape[-1]
        sigma = np.sqrt(np.einsum("...ii->...i", self.P))
        noise = self.rng.uniform(-1, 1, self.P.shape) * steps * (3 * n + 10) * U
        # not symmetric: neither is what NumPy rounds of Phi P Phi'
        self.P = self.P + noise * sigma[..., :, None] * sigma[..., None, :]
        self.x = self.x + self.rng.uniform(-1, 1, self.x.shape) * steps * (3 * n + 10) * U * sigma

    def predict(self, **inputs):
        super().predict(**inputs)
        self.disturb()

    def update(self, measurement, R, **inputs):
        self.disturb(steps=np.shape(R)[-1])
        return super().update(measurement, R, **inputs)


def flown_by(kind, module, fly, monkeypatch):
    calls = []

    class Counted(kind):
        def predict(self, **inputs):
            calls.append(1)
            super().predict(**inputs)

    monkeypatch.setattr(module, "Filter" if hasattr(module, "Filter") else "CompiledFilter", Counted)
    result = fly()
    assert calls
    return result


def held_together(module, fly, names, monkeypatch):
    """Names of the results that differ by more than rounding explains, with that and what rounding does."""
    python, compiled, disturbed = (
        flown_by(kind, module, fly, monkeypatch) for kind in (Filter, CompiledFilter, Disturbed)
    )
    off = {}
    for name in names:
        base = np.asarray(getattr(python, name))
        by_c, by_rounding = (np.abs(np.asarray(getattr(other, name)) - base).max() for other in (compiled, disturbed))
        assert by_rounding > 0
        print(f"{name}: C {by_c:.1e}, rounding {by_rounding:.1e} of {np.abs(base).max():.1e}")
        if not by_c <= 2 * by_rounding:  # each of the two loops may be off by that much
            off[name] = (by_c, by_rounding)
    return off


@pytest.mark.parametrize(
    "changes", [{}, {"measurement": "euler_exact", "iterations": 3, "turn_covariance": True}], ids=["first", "exact"]
)
def test_song_lee_table_is_flown_to_rounding(changes, library, monkeypatch):
    scenario = euler_table.Scenario(**changes)
    off = held_together(
        euler_table, lambda: euler_table.fly(library, scenario, 20, runs=2, seed=1), ("error", "sigma"), monkeypatch
    )
    assert off == {}


class Second:
    """What `hold.a_second` flies in one call, by the methods of any kind of filter."""

    def __init__(self, loop, hz, noise):
        self.loop, self.hz = loop, hz
        self.strapdown, self.predict = {}, {"dt": 1.0, **noise}

    def __call__(self):
        for k in range(self.hz):
            self.loop.strapdown(**{name: values[k] for name, values in self.strapdown.items()}, dt=1 / self.hz)
        self.loop.predict(**self.predict)


def test_the_azimuth_hold_of_kim_is_flown_to_rounding(monkeypatch):
    monkeypatch.setattr(azimuth_hold, "a_second", Second)
    models, scenario = azimuth_alignment.load_models(), azimuth_alignment.Scenario(align_s=5.0)

    def fly():
        start = azimuth_alignment.align(models, scenario, runs=2, seed=1)
        return azimuth_hold.hold(models, scenario, start, 10, zaru=True)

    assert held_together(azimuth_hold, fly, ("phi", "sigma", "speed", "error", "P"), monkeypatch) == {}


def test_the_alignment_of_kim_is_flown_to_rounding(monkeypatch):
    models, scenario = azimuth_alignment.load_models(), azimuth_alignment.Scenario(align_s=10.0)

    def fly():
        return azimuth_alignment.align(models, scenario, runs=2, seed=1)

    assert held_together(azimuth_alignment, fly, ("P", "psi_history", "sigma_history"), monkeypatch) == {}


NOISE = {
    "gyro_noise": np.full(3, 1e-5),
    "accel_noise": np.full(3, 1e-3),
    "gyro_bias_noise": np.full(3, 1e-8),
    "accel_bias_noise": np.full(3, 1e-5),
}


def at_rest(kind, runs=()):
    """A filter of the azimuth hold, its covariance with every correlation."""
    nav = {
        "lon_lat_height": np.array([0.1, 0.6, 100.0]),
        "v_n": np.array([0.1, 0.2, 0.3]),
        "q_b2n_wxyz": np.array([1.0, 0, 0, 0]),
        "gyro_bias": np.zeros(3),
        "accel_bias": np.zeros(3),
    }
    root = np.random.default_rng(1).standard_normal((*runs, 15, 15))
    sigma = np.repeat([1e-6, 0.1, 1e-2, 1e-6, 1e-2], 3)
    return kind(load("azimuth-hold"), nav, root @ np.swapaxes(root, -1, -2) * sigma[:, None] * sigma)


def difference(a, b):
    """Largest of P in units of sigma, and of x."""
    sigma = np.sqrt(np.einsum("...ii->...i", a.P))
    scaled = (a.P - b.P) / (sigma[..., :, None] * sigma[..., None, :])
    return np.abs(scaled).max(), np.abs((a.x - b.x) / sigma).max()


@pytest.mark.parametrize("runs", [(), (5,), (2, 3)])
def test_masks_gates_and_runs_are_those_of_the_python_loop(runs):
    loops = at_rest(Filter, runs), at_rest(CompiledFilter, runs)
    rows = np.random.default_rng(2).random((*runs, 3)) < 0.5
    for gate in (None, 1.0, 3.0):
        said = []
        for loop in loops:
            loop.predict(f_b=np.array([0.1, 0.2, 9.8]), dt=0.1, **NOISE)
            said.append(loop.update("zupt", np.full(3, 1e-4), rows=rows, gate=gate))
            loop.update("azimuth", np.full(1, 1e-6), q_ref_wxyz=np.array([1, 0, 0, 1e-3]), gate=gate)
        assert np.array_equal(said[0].used, said[1].used)
        assert said[0].used.shape == (*runs, 3)
        assert np.allclose(said[0].nu, said[1].nu, rtol=1e-9, atol=1e-12)
        assert np.allclose(said[0].S, said[1].S, rtol=1e-9)
        assert max(difference(*loops)) < 1e-9
    for loop in loops:
        loop.feedback()
    assert not loops[1].x.any()
    for name, value in loops[0].nav.items():
        assert np.allclose(loops[1].nav[name], value, rtol=1e-9, atol=1e-12)


def test_the_covariance_stays_symmetric_and_positive():
    loop = at_rest(CompiledFilter)
    for _ in range(200):
        loop.predict(f_b=np.array([0.1, 0.2, 9.8]), dt=0.1, **NOISE)
        loop.update("zupt", np.full(3, 1e-8))
        loop.feedback()
        assert np.array_equal(loop.P, loop.P.T)
        sigma = np.sqrt(np.diag(loop.P))
        assert np.linalg.eigvalsh(loop.P / np.outer(sigma, sigma))[0] > 0


def test_what_cannot_be_flown_is_named():
    loop = at_rest(CompiledFilter, (2,))
    with pytest.raises(BoresightError, match="propagate needs f_b, dt"):
        loop.predict(**NOISE)
    with pytest.raises(BoresightError, match="no measurement 'zpt'; it has azimuth, zaru, zupt"):
        loop.update("zpt", np.ones(3))
    with pytest.raises(BoresightError, match="every variance in R"):
        loop.update("zupt", np.array([1.0, 0.0, 1.0]))
    with pytest.raises(BoresightError, match="iterations is 0"):
        loop.update("zupt", np.ones(3), iterations=0)
    before = loop.P.copy(), loop.x.copy()
    with pytest.raises(BoresightError, match=r"f_b\[1\] of run 1 is nan"):
        loop.predict(f_b=np.array([[0, 0, 9.8], [0, np.nan, 9.8]]), dt=0.1, **NOISE)
    assert np.array_equal(loop.P, before[0]) and np.array_equal(loop.x, before[1])
    loop.P[1, 3, 3] = np.inf
    with pytest.raises(BoresightError, match="of run 1 is no number"):
        loop.update("zupt", np.ones(3))
    with pytest.raises(BoresightError, match="phi-error has no filter in C"):
        CompiledFilter(load("phi-error"), {}, np.eye(9))


def test_a_model_without_navigation_brings_its_own_residual(pendulum_folder):
    model = load(pendulum_folder)
    loop = CompiledFilter(model, {}, np.diag([0.04, 0.01]), x=[0.3, -0.1])
    Phi = model.Phi(x=loop.x, plant=np.array([1.0, 0.1]), dt=0.01)
    Q = model.Q(x=loop.x, plant=np.array([1.0, 0.1]), dt=0.01, push=0.1)
    P, x = Phi @ loop.P @ Phi.T + Q, model.next(x=loop.x, plant=np.array([1.0, 0.1]), dt=0.01)
    loop.predict(plant=np.array([1.0, 0.1]), dt=0.01, push=0.1)
    assert np.allclose(loop.P, P, rtol=1e-14) and np.allclose(loop.x, x, rtol=1e-14)
    H, h = model.tip_H(x=x, plant=np.array([1.0, 0.1])), model.tip_h(x=x, plant=np.array([1.0, 0.1]))
    said = loop.update("tip", [0.01], z=[0.35], plant=np.array([1.0, 0.1]))
    S = H @ P @ H.T + 0.01
    K = P @ H.T / S
    assert np.allclose(said.S, S, rtol=1e-14) and np.allclose(said.nu, 0.35 - h, rtol=1e-12)
    assert np.allclose(loop.x, x + K[:, 0] * (0.35 - h), rtol=1e-13)
    assert np.allclose(loop.P, P - K @ S @ K.T, rtol=1e-12)
    with pytest.raises(BoresightError, match="tip needs z"):
        loop.update("tip", [0.01], plant=np.array([1.0, 0.1]))


def test_a_call_is_prepared_once_for_its_shapes_and_takes_the_numbers_of_each():
    python, compiled = (at_rest(kind, runs=(3,)) for kind in (Filter, CompiledFilter))
    pushes = [np.array([0.1, 0.2, -9.8]), np.array([3.0, 0.0, -9.0]), np.eye(3), np.array([0.0, 0.0, -9.8])]
    for k, f_b in enumerate(pushes):
        for loop in (python, compiled):
            loop.predict(f_b=f_b, dt=0.1 * (k + 1), **NOISE)
            loop.update("zupt", np.full(3, 1e-2 * (k + 1)), rows=[True, k != 1, True])
            loop.feedback()
        np.testing.assert_allclose(compiled.P, python.P, rtol=1e-9, atol=1e-18)
        np.testing.assert_allclose(compiled.nav["v_n"], python.nav["v_n"], rtol=1e-9, atol=1e-15)
    # with what the filter begins with; then for one push of all runs, and for one of each
    assert sum(key[0] == "propagate" for key in compiled._prepared) == 3
