"""The filter loop: the same over C, over CasADi's C and over NumPy; right against textbook matrices."""

import numpy as np
import numpy_euler_matching
import pytest

from boresight import BoresightError
from boresight.runtime.filter import Filter
from boresight.runtime.library import load


def fly(model, steps=30, **update):
    """Three runs of a small alignment on a rocking platform; returns the filter."""
    rng = np.random.default_rng(5)
    mu = np.radians([[1.0, -2.0, 0.5], [0.1, 0.2, -0.3], [-3.0, 1.0, 2.0]])
    witness = numpy_euler_matching
    omega = np.array([5e-5, 0, -5e-5])

    def platform(t):
        return np.radians([3 * np.sin(0.7 * t), 2 * np.sin(0.5 * t + 1), 2 * np.cos(0.3 * t)])

    start = np.tile(witness.quaternion(witness.dcm(platform(0.0))), (3, 1))
    P0 = np.tile(np.diag([3e-3] * 3 + [2e-3] * 3), (3, 1, 1))
    loop = Filter(model, {"q_b2n_wxyz": start, "mu": np.zeros((3, 3))}, P0)
    for k in range(steps):
        C0, C1 = (witness.dcm(platform(t)) @ witness.exp(mu) for t in (k * 1.0, k + 1.0))
        turn = witness.exp(omega)
        dtheta = witness.log(np.swapaxes(C0, -1, -2) @ turn @ C1)
        loop.strapdown(dtheta_ib_b=dtheta, omega_in_n=omega, dt=1.0)
        loop.predict(omega_in_n=omega, gyro_noise=np.full(3, 1e-5), dt=1.0)
        euler_m = platform(k + 1.0) + 3e-4 * rng.standard_normal(3)
        loop.update(update.get("name", "euler"), np.full(3, 9e-8), euler_b=loop.call("euler_angles"), euler_m=euler_m,
                    **{key: value for key, value in update.items() if key != "name"})  # fmt: skip
        loop.feedback()
    return loop, mu


@pytest.mark.digits
def test_the_loop_flies_either_c_to_the_same_bits(library):
    (a, _), (b, _) = fly(library), fly(load("euler-matching", "casadi"))
    assert a.P.tobytes() == b.P.tobytes()
    assert a.nav["mu"].tobytes() == b.nav["mu"].tobytes()


@pytest.mark.parametrize("name", ["euler", "euler_exact"])
def test_the_loop_flies_numpy_to_rounding(library, name):
    (a, _), (b, _) = fly(library, name=name), fly(numpy_euler_matching.model(), name=name)
    # the witness's numerical Jacobian is good to 1e-9
    np.testing.assert_allclose(a.nav["mu"], b.nav["mu"], atol=1e-12 if name == "euler" else 1e-8)
    np.testing.assert_allclose(a.P, b.P, atol=1e-15 if name == "euler" else 1e-10)


def test_the_misalignment_is_found(library):
    loop, mu = fly(library, steps=120, name="euler_exact", iterations=3)
    assert np.abs(loop.nav["mu"] - mu).max() < np.radians(0.1)


def reference(P, H, R, z, x):
    """The textbook update with matrices."""
    S = H @ P @ H.T + np.diag(R)
    K = P @ H.T @ np.linalg.inv(S)
    nu = z - H @ x
    return x + K @ nu, (np.eye(len(x)) - K @ H) @ P, nu @ np.linalg.solve(S, nu)


def test_row_after_row_equals_the_matrix_form(library):
    rng = np.random.default_rng(3)
    A = rng.standard_normal((6, 6))
    P0 = A @ A.T * 1e-3
    loop = Filter(library, {"q_b2n_wxyz": [1, 0, 0, 0], "mu": [0.01, 0.02, 0.03]}, (P0 + P0.T) / 2)
    loop.x = rng.standard_normal(6) * 1e-3
    euler = {"euler_b": np.array([0.1, 0.2, 0.3]), "euler_m": np.array([0.11, 0.18, 0.29])}
    R = np.array([1e-4, 2e-4, 3e-4])
    x, P, nis = reference(loop.P, library.euler_H(**euler), R, library.euler_z(**euler, mu=loop.nav["mu"]), loop.x)
    innovation = loop.update("euler", R, **euler)
    np.testing.assert_allclose(loop.x, x, rtol=1e-11)
    np.testing.assert_allclose(loop.P, P, atol=1e-14)
    np.testing.assert_allclose(innovation.nis, nis, rtol=1e-10)
    np.testing.assert_array_equal(loop.P, loop.P.T)


def test_a_masked_row_is_a_row_that_was_never_there(library):
    euler = {"euler_b": np.array([0.1, 0.2, 0.3]), "euler_m": np.array([0.11, 0.18, 0.29])}
    R = np.full(3, 1e-4)
    P0 = np.diag(np.arange(1.0, 7.0)) * 1e-3
    loop = Filter(library, {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}, P0)
    innovation = loop.update("euler", R, rows=[True, False, True], **euler)
    keep = [0, 2]
    H, z = library.euler_H(**euler)[keep], library.euler_z(**euler, mu=np.zeros(3))[keep]
    x, P, nis = reference(P0, H, R[keep], z, np.zeros(6))
    np.testing.assert_allclose(loop.x, x, rtol=1e-11)
    np.testing.assert_allclose(loop.P, P, atol=1e-15)
    np.testing.assert_allclose(innovation.nis, nis, rtol=1e-11)
    assert innovation.used.tolist() == [True, False, True]


def test_a_gate_leaves_out_what_lies_beyond(library):
    nav = {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}
    loop = Filter(library, nav, 1e-6 * np.eye(6))
    innovation = loop.update(
        "euler", np.full(3, 1e-6), gate=5.0, euler_b=np.array([0.5, 1e-4, 0.0]), euler_m=np.zeros(3)
    )
    assert innovation.used.tolist() == [False, True, True]
    assert np.abs(loop.x).max() < 1e-3


def test_angles_wrap(library):
    loop = Filter(library, {"q_b2n_wxyz": [0, 0, 0, 1], "mu": np.zeros(3)}, 1e-6 * np.eye(6))
    innovation = loop.update(
        "euler", np.full(3, 1e-6), euler_b=np.array([0, 0, 3.1415]), euler_m=np.array([0, 0, -3.1415])
    )
    np.testing.assert_allclose(innovation.nu[2], 2 * 3.1415 - 2 * np.pi, atol=1e-12)


def test_joseph_form_keeps_p_positive_over_a_long_run(library):
    loop, _ = fly(library, steps=400)
    assert np.linalg.eigvalsh(loop.P).min() > 0


@pytest.mark.parametrize(
    ("act", "said"),
    [
        (lambda f: f.update("euler", np.zeros(3), euler_b=np.zeros(3), euler_m=np.zeros(3)), "above zero"),
        (lambda f: f.update("euler", np.full(3, np.nan), euler_b=np.zeros(3), euler_m=np.zeros(3)), "finite"),
        (
            lambda f: f.update("euler", np.ones(3), iterations=0, euler_b=np.zeros(3), euler_m=np.zeros(3)),
            "from 1 to 64",
        ),
        (lambda f: f.update("euler", np.ones(3), euler_b=np.zeros(3)), "euler_z needs euler_m"),
        (
            lambda f: f.update("eular", np.ones(3)),
            "euler-matching has no measurement 'eular'; it has euler, euler_exact",
        ),
        (lambda f: f.predict(dt=1.0, omega_in_n=np.zeros(3)), "Q needs gyro_noise"),
        (lambda f: Filter(f.model, f.nav, np.ones((6, 5))), r"shape \(6, 5\)"),
        (lambda f: Filter(f.model, f.nav, np.full((6, 6), np.nan)), "not finite"),
        (lambda f: Filter(f.model, f.nav, np.eye(6) + 0.1 * np.eye(6, k=1)), "not symmetric"),
        (lambda f: Filter(f.model, f.nav, np.eye(6) - 0.6 * np.ones((6, 6))), "negative eigenvalue"),
        (lambda f: f.predict(dt=1.0, omega_in_n=np.zeros(3), gyro_noise=np.full(3, -1e-5)), "gyro_noise"),
    ],
)
def test_bad_input_is_one_line_and_leaves_the_filter_as_it_was(library, act, said):
    loop = Filter(library, {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}, np.eye(6))
    with pytest.raises(BoresightError, match=said):
        act(loop)
    np.testing.assert_array_equal(loop.P, np.eye(6))
    np.testing.assert_array_equal(loop.x, 0)


class Known:
    """A model of one measurement, whose H is known."""

    name, states = "known", ("a", "b")

    def __init__(self, H):
        self.a_H = lambda: H
        self.a_H.fields = ()


def test_many_rows_of_a_coarse_and_correlated_start_are_right():
    """Two states a thousand times as far off together as apart, six rows as good as 1e-4: P by its inverse."""
    together = np.array([1.0, 3.0])
    P, R = 2e6 * (np.outer(together, together) + 1e-8 * np.eye(2)), np.full(6, 2e-9)
    H = np.random.default_rng(0).normal(size=(6, 2))
    loop = Filter(Known(H), {}, P)
    loop.update("a", R, z=np.zeros(6))
    exact = np.linalg.inv(np.linalg.inv(P) + H.T @ np.diag(1 / R) @ H)
    np.testing.assert_allclose(loop.P, exact, rtol=1e-7)


def test_a_jacobian_that_is_known_is_taken_and_one_of_another_shape_is_refused():
    H = np.array([[1.0, 2.0], [0.0, 1.0], [3.0, 1.0]])
    loops = [Filter(Known(H if k == 0 else np.full((3, 2), np.nan)), {}, np.eye(2)) for k in range(2)]
    loops[0].update("a", np.ones(3), z=np.arange(3.0))
    loops[1].update("a", np.ones(3), z=np.arange(3.0), jacobian=H.tolist())
    assert np.array_equal(loops[0].P, loops[1].P) and np.array_equal(loops[0].x, loops[1].x)
    for other in (np.ones((5, 2)), np.ones((1, 2)), np.ones(2), np.ones((3, 1))):
        with pytest.raises(BoresightError, match=r"a: jacobian has shape .*; its last axes must be 3 and 2 long"):
            loops[0].update("a", np.ones(3), z=np.arange(3.0), jacobian=other)
