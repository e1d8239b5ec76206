"""The ten- and fifteen-state models on the compiled C, against finite rotations and errors put in by hand."""

import numpy as np
import pytest
from numpy_euler_matching import exp, matrix, quaternion

from boresight.runtime.library import load

RUNS = 30


@pytest.fixture(scope="module")
def hold(compiled_once):
    return load("azimuth-hold")


@pytest.fixture(scope="module")
def align(compiled_once):
    return load("velocity-dcm")


def attitudes(rng):
    q = rng.standard_normal((RUNS, 4))
    return q / np.linalg.norm(q, axis=1, keepdims=True)


def turned(C, x):
    """The quaternion of C_hat = exp(-[x x]) C."""
    return quaternion(exp(-np.asarray(x)) @ C)


def order(error, fall=100):
    """error(size) must fall by `fall` when its argument falls tenfold; returns its value at 1e-3."""
    coarse, fine = error(1e-3), error(1e-4)
    assert fall / 2 < coarse / fine < fall * 2
    return coarse


def test_the_azimuth_residual_is_the_turn_about_up(hold):
    rng = np.random.default_rng(1)
    C = matrix(attitudes(rng))
    direction = rng.standard_normal((RUNS, 3))
    H = hold.azimuth_H()
    assert H.tolist() == [[0.0] * 8 + [1.0] + [0.0] * 6]

    def error(size):
        z = hold.azimuth_z(q_b2n_wxyz=turned(C, size * direction), q_ref_wxyz=quaternion(C))
        return np.abs(z[:, 0] - size * direction[:, 2]).max()

    # the skew part of a rotation is the sine of its angle: no second order is dropped
    assert order(error, fall=1000) < 1e-8
    half_degree = np.radians(0.5)
    about_up = hold.azimuth_z(q_b2n_wxyz=turned(C, [[0, 0, half_degree]] * RUNS), q_ref_wxyz=quaternion(C))
    np.testing.assert_allclose(about_up[:, 0], np.sin(half_degree), rtol=1e-12)


def test_a_resting_gyro_sees_the_earth_and_its_errors_linearly(hold):
    rng = np.random.default_rng(2)
    C, lat = matrix(attitudes(rng)), 0.63
    position = np.array([2.2, lat, 120.0])
    earth = 7.292115e-5 * np.array([0, np.cos(lat), np.sin(lat)])  # east, north, up
    phi, dbg, dlat = rng.standard_normal((RUNS, 3)), 1e-4 * rng.standard_normal((RUNS, 3)), rng.standard_normal(RUNS)

    def error(size):
        q_hat = turned(C, size * phi)
        p_hat = position + size * dlat[:, None] * [0, 1, 0]
        omega_hat = np.einsum("kji,j->ki", C, earth) - size * dbg  # what is left after the bias's estimate
        x = size * np.hstack([dlat[:, None] * [0, 1, 0], np.zeros((RUNS, 3)), phi, dbg, np.zeros((RUNS, 3))])
        z = hold.zaru_z(q_b2n_wxyz=q_hat, lon_lat_height=p_hat, omega_ib_b=omega_hat)
        H = hold.zaru_H(q_b2n_wxyz=q_hat, lon_lat_height=p_hat)
        return np.abs(z - np.einsum("kij,kj->ki", H, x)).max()

    assert order(error) < 1e-9


def test_navigation_errors_grow_as_in_the_phi_model_and_biases_enter_with_their_sign(hold):
    rng = np.random.default_rng(3)
    q = attitudes(rng)
    C = matrix(q)
    where = {"lon_lat_height": np.array([2.2, 0.6, 100.0]), "v_n": np.array([3.0, -4.0, 0.5])}
    f_b = rng.uniform(-12, 12, (RUNS, 3))
    F = hold.F(**where, q_b2n_wxyz=q, f_b=f_b)
    nine = load("phi-error").F(**where, f_n=np.einsum("kij,kj->ki", C, f_b))
    np.testing.assert_allclose(F[:, :9, :9], nine, atol=1e-14)
    # the estimate is too large: too much is taken off, and the attitude error grows by C dbg, the velocity by -C dba
    np.testing.assert_allclose(F[:, 6:9, 9:12], C, atol=1e-15)
    np.testing.assert_allclose(F[:, 3:6, 12:15], -C, atol=1e-15)
    assert not F[:, 9:].any()


def test_velocity_and_dcm_residuals_see_every_error_to_first_order(align):
    rng = np.random.default_rng(4)
    C_m, mu = matrix(attitudes(rng)), rng.uniform(-0.2, 0.2, (RUNS, 3))
    C_b = C_m @ exp(mu)
    omega, a, v = rng.uniform(-0.5, 0.5, (RUNS, 3)), rng.uniform(-3, 3, (RUNS, 3)), rng.uniform(-30, 30, (RUNS, 3))
    x = rng.standard_normal((RUNS, 10))

    def error(size):
        dv, psi, dmu, dtau = size * x[:, :3], size * x[:, 3:6], size * x[:, 6:9], size * x[:, 9:]
        # the slave is compared at tau_hat ago, which is dtau before the instant of the master's data
        C_then, v_then = exp(-omega * dtau) @ C_b, v - a * dtau
        q_hat = turned(C_then, psi)
        z = align.dcm_z(q_b2n_wxyz=q_hat, q_m2n_wxyz=quaternion(C_m), mu=mu + dmu)
        zv = align.velocity_z(v_n=v_then + dv, v_m_n=v)
        Hv = align.velocity_H(a_n=a)
        np.testing.assert_allclose(zv, size * np.einsum("kij,kj->ki", Hv, x), atol=1e-12)
        exact = align.dcm_exact_H(
            x=np.zeros(10), q_b2n_wxyz=quaternion(C_b), q_m2n_wxyz=quaternion(C_m), mu=mu, omega_nm_n=omega
        )
        return np.abs(z - size * np.einsum("kij,kj->ki", exact, x)).max()

    assert order(error) < 3e-5


def test_the_linear_dcm_matrix_is_the_exact_one_without_misalignment(align):
    rng = np.random.default_rng(5)
    q, omega = attitudes(rng), rng.uniform(-0.5, 0.5, (RUNS, 3))
    H = align.dcm_H(q_m2n_wxyz=q, omega_nm_n=omega)
    exact = align.dcm_exact_H(x=np.zeros(10), q_b2n_wxyz=q, q_m2n_wxyz=q, mu=np.zeros(3), omega_nm_n=omega)
    np.testing.assert_allclose(H, exact, atol=1e-14)


@pytest.mark.parametrize("name", ["azimuth-hold", "velocity-dcm"])
def test_feedback_takes_out_what_was_put_in(name):
    rng = np.random.default_rng(6)
    library = load(name)
    C = matrix(attitudes(rng))
    truth = {
        "lon_lat_height": np.array([2.2, 0.6, 100.0]), "v_n": rng.uniform(-3, 3, (RUNS, 3)),
        "gyro_bias": np.full(3, 1e-4), "accel_bias": np.full(3, 1e-2), "mu": np.full(3, 0.1),
        "tau": np.full(RUNS, 0.05),
    }  # fmt: skip
    x = 1e-3 * rng.standard_normal((RUNS, len(library.states)))
    turn = slice(6, 9) if name == "azimuth-hold" else slice(3, 6)
    parts = (
        {"lon_lat_height": slice(0, 3), "v_n": slice(3, 6), "gyro_bias": slice(9, 12), "accel_bias": slice(12, 15)}
        if name == "azimuth-hold"
        else {"v_n": slice(0, 3), "mu": slice(6, 9), "tau": 9}
    )
    wrong = {field: truth[field] + x[:, where] for field, where in parts.items()}
    out = library.feedback(q_b2n_wxyz=turned(C, x[:, turn]), x=x, **wrong)
    np.testing.assert_allclose(matrix(out["q_b2n_wxyz"]), C, atol=1e-14)
    for field in parts:
        value = out[field]
        np.testing.assert_allclose(value, np.broadcast_to(truth[field], value.shape), atol=1e-12)


def test_latitude_past_85_degrees_and_a_height_outside_the_box_are_refused(hold):
    from boresight import BoresightError

    fields = {"v_n": np.zeros(3), "q_b2n_wxyz": [1.0, 0, 0, 0], "f_b": np.zeros(3)}
    for position, axis in (([0, np.radians(85.1), 0], 1), ([0, 0.6, 40000.0], 2)):
        with pytest.raises(BoresightError, match=rf"lon_lat_height\[{axis}\]"):
            hold.F(lon_lat_height=np.array(position), **fields)


@pytest.mark.parametrize("dt", [0.01, 1.0])
def test_phi_and_q_approach_van_loan(hold, dt):
    """Discretised noise against the matrix exponential of Van Loan (1978): what is dropped falls with the step."""
    from scipy.linalg import expm

    rng = np.random.default_rng(9)
    q = attitudes(rng)[0]
    at = {
        "lon_lat_height": np.array([2.2, 0.6, 100.0]),
        "v_n": np.array([3.0, -4.0, 0.5]),
        "q_b2n_wxyz": q,
        "f_b": [1.0, -2.0, 9.7],
    }
    noise = {"gyro_noise": np.full(3, 3e-5), "accel_noise": np.full(3, 1e-3), "gyro_bias_noise": np.full(3, 1e-7),
             "accel_bias_noise": np.full(3, 1e-5)}  # fmt: skip
    F, C = hold.F(**at), matrix(q)
    G = np.zeros((15, 12))
    G[3:6, 3:6], G[6:9, :3], G[9:, 6:] = C, -C, np.eye(6)
    S = G @ np.diag(np.concatenate(list(noise.values())) ** 2) @ G.T

    def missed(step):
        block = expm(np.block([[-F, S], [np.zeros((15, 15)), F.T]]) * step)
        Phi = block[15:, 15:].T
        exact = Phi @ block[:15, 15:]
        scale = np.sqrt(np.outer(np.diag(exact), np.diag(exact)))
        ours = hold.Q(**{k: v for k, v in at.items() if k in hold.Q.fields}, **noise, dt=step)
        return np.abs(hold.Phi(**at, dt=step) - Phi).max(), np.abs((ours - exact) / scale).max()

    (phi, noise_missed), (phi_half, noise_half) = missed(dt), missed(dt / 2)
    # Phi drops the third power of F dt; Q, of the smallest variances, the second power of dt, 2 % of them at 1 s.
    assert phi < 2 * dt**3
    assert noise_missed < 0.02 * dt**2
    assert 6 < phi / phi_half < 10
    assert 3 < noise_missed / noise_half < 5


def test_an_unknown_error_of_the_reference_is_a_state_by_composition(hold):
    wide = load("azimuth-hold-reference")
    assert wide.states[:15] == hold.states
    assert wide.states[15] == "d_ref"
    rng = np.random.default_rng(10)
    q = attitudes(rng)
    fields = {
        "lon_lat_height": np.array([2.2, 0.6, 100.0]),
        "v_n": np.zeros(3),
        "q_b2n_wxyz": q,
        "f_b": [0.0, 0.0, 9.8],
        "dt": 1.0,
    }
    Phi = wide.Phi(**fields)
    np.testing.assert_array_equal(Phi[:, :15, :15], hold.Phi(**fields))
    np.testing.assert_array_equal(Phi[:, 15], np.eye(16)[15] * np.ones((RUNS, 1)))
    np.testing.assert_array_equal(wide.azimuth_H()[0, [8, 15]], [1.0, 1.0])
    # a reference that is wrong by e about up: told e, the residual of a perfect attitude is zero
    e = 1e-3
    q_ref = turned(matrix(q), [[0, 0, e]] * RUNS)
    z = wide.azimuth_z(q_b2n_wxyz=q, q_ref_wxyz=q_ref, reference_error=np.full(RUNS, e))
    np.testing.assert_allclose(z[:, 0], 0, atol=1e-9)
