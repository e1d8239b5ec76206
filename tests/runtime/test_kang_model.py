"""velocity-attitude on the compiled C: the strapdown against Phi, feedback against truth, noise against Van Loan."""

import numpy as np
import pytest
from numpy_euler_matching import exp, log, matrix, quaternion
from scipy.linalg import expm

from boresight.runtime.library import load

RUNS = 20
POSITION = np.array([0.61, 2.1, 12.0])


@pytest.fixture(scope="module")
def align(compiled_once):
    return load("velocity-attitude")


def attitudes(rng, runs=RUNS):
    q = rng.standard_normal((runs, 4))
    return q / np.linalg.norm(q, axis=1, keepdims=True)


def times(matrices, vectors):
    return np.einsum("...ij,...j->...i", matrices, vectors)


def estimates(truth, x):
    """What the slave believes if its errors are x, by finite rotations."""
    return {
        "v_n": truth["v_n"] + x[:, 3:6],
        "q_b2n_wxyz": quaternion(exp(-x[:, :3]) @ matrix(truth["q_b2n_wxyz"])),
        "gyro_bias": truth["gyro_bias"] + x[:, 6:9],
        "accel_bias": truth["accel_bias"] + x[:, 9:12],
        "q_b2m_wxyz": quaternion(exp(-x[:, 12:15]) @ matrix(truth["q_b2m_wxyz"])),
        "tau": truth["tau"] + x[:, 15],
    }


def errors(hat, truth):
    """x of estimates and truth, the inverse of `estimates`."""
    return np.concatenate(
        [
            log(matrix(truth["q_b2n_wxyz"]) @ np.swapaxes(matrix(hat["q_b2n_wxyz"]), -1, -2)),
            hat["v_n"] - truth["v_n"],
            hat["gyro_bias"] - truth["gyro_bias"],
            hat["accel_bias"] - truth["accel_bias"],
            log(matrix(truth["q_b2m_wxyz"]) @ np.swapaxes(matrix(hat["q_b2m_wxyz"]), -1, -2)),
            (hat["tau"] - truth["tau"])[:, None],
        ],
        axis=1,
    )


def truth_and_x(seed):
    rng = np.random.default_rng(seed)
    truth = {
        "v_n": rng.uniform(-9, 9, (RUNS, 3)), "q_b2n_wxyz": attitudes(rng), "tau": rng.uniform(-0.1, 0.1, RUNS),
        "gyro_bias": rng.uniform(-1, 1, (RUNS, 3)) * 1e-3,
        "accel_bias": rng.uniform(-0.1, 0.1, (RUNS, 3)), "q_b2m_wxyz": attitudes(rng),
    }  # fmt: skip
    x = rng.standard_normal((RUNS, 16)) * np.repeat([0.1, 1.0, 1e-3, 0.1, 0.1, 0.05], [3, 3, 3, 3, 3, 1])
    return rng, truth, x


def test_feedback_takes_out_what_was_put_in_whatever_its_size(align):
    _, truth, x = truth_and_x(1)
    out = align.feedback(x=x, **estimates(truth, x))
    assert np.abs(errors(out, truth)).max() < 1e-13


def test_errors_grow_over_a_strapdown_step_as_phi_says(align):
    """Between two strapdowns, one wrong in all sixteen states, on the same increments; a tenth leaves a hundredth."""
    rng, truth, x = truth_and_x(2)
    dt = 0.01
    omega, f = rng.uniform(-0.5, 0.5, (RUNS, 3)), rng.uniform(-12, 12, (RUNS, 3))
    dtheta, dv = (omega + truth["gyro_bias"]) * dt, (f + truth["accel_bias"]) * dt
    increments = {"dtheta_ib_b": dtheta, "dv_b": dv, "dtheta_before": dtheta, "dv_before": dv, "dt": dt}

    def carried(nav):
        fields = {
            "lat_lon_height": POSITION,
            **{name: nav[name] for name in ("v_n", "q_b2n_wxyz", "gyro_bias", "accel_bias")},
        }
        made = align.strapdown(**fields, **increments)
        return {**nav, "v_n": made["v_n"], "q_b2n_wxyz": made["q_b2n_wxyz"]}

    Phi = align.Phi(lat_lon_height=POSITION, v_n=truth["v_n"], q_b2n_wxyz=truth["q_b2n_wxyz"], f_b=f, dt=dt)
    moved = carried(truth)

    def left(size):
        grown = errors(carried(estimates(truth, size * x)), moved)
        return np.abs(grown - times(Phi, size * x))

    # First order left by Phi: the specific force, which adds up to 12 sqrt(3) dt, turns in the step by 0.5 sqrt(3) dt.
    coarse = [left(size) / size for size in (1e-2, 1e-3, 1e-6)]
    assert coarse[2][:, 3:6].max() < 0.5 * 1.8 * dt * 12 * 1.8 * dt
    # The gyro bias' error turns the axes in which a turn of omega dt follows.
    assert coarse[2][:, :3].max() < 0.5 * 1.8 * dt * 1e-3 * dt * 10
    assert np.abs(coarse[2][:, 6:]).max() < 1e-9
    # the rest is of second order in x
    first, second = (np.abs(part - coarse[2])[:, :6].max() for part in coarse[:2])
    assert 8 < first / second < 12
    # and x does grow: had Phi been the identity, more would be left
    assert np.abs(errors(carried(estimates(truth, 1e-6 * x)), moved) / 1e-6 - x)[:, 3:6].max() > 0.02


def test_the_quaternion_residual_tells_half_a_turn_from_none_and_the_dcm_residual_does_not(align):
    """The turn between expected and reported attitude, about an axis: 2 sin(angle / 2) against sin(angle)."""
    rng = np.random.default_rng(3)
    C_m2n = matrix(attitudes(rng))
    axis = rng.standard_normal((RUNS, 3))
    axis /= np.linalg.norm(axis, axis=1, keepdims=True)
    given = {"lat_lon_height": POSITION, "v_n": np.zeros(3), "q_b2m_wxyz": [1.0, 0, 0, 0], "omega_ib_b": np.zeros(3),
             "q_m2n_wxyz": quaternion(C_m2n), "lag": 0.0}  # fmt: skip
    for degrees in (1.0, 60.0, 90.0, 120.0, 179.0):
        angle = np.radians(degrees)
        q_hat = quaternion(exp(angle * axis) @ C_m2n)
        z = {name: getattr(align, f"{name}_z")(**given, q_b2n_wxyz=q_hat) for name in ("dcm", "quaternion")}
        np.testing.assert_allclose(z["dcm"], np.sin(angle) * axis, atol=1e-13)
        np.testing.assert_allclose(z["quaternion"], 2 * np.sin(angle / 2) * axis, atol=1e-13)


@pytest.mark.parametrize("dt", [0.01, 1.0])
def test_phi_and_q_approach_van_loan(align, dt):
    """Against a matrix exponential: Phi drops the third power of the step, Q the fourth, the third of its own size."""
    rng = np.random.default_rng(9)
    q = attitudes(rng, 1)[0]
    at = {"lat_lon_height": POSITION, "v_n": np.array([3.0, -4.0, 0.5])}
    at |= {"q_b2n_wxyz": q, "f_b": np.array([1.0, -2.0, 9.7])}
    noise = {"gyro_noise": np.full(3, 3e-5), "accel_noise": np.full(3, 1e-3), "gyro_bias_noise": np.full(3, 1e-7),
             "accel_bias_noise": np.full(3, 1e-5), "mu_noise": np.full(3, 1e-5), "tau_noise": 1e-4}  # fmt: skip
    F, C = align.F(**at), matrix(q)
    G = np.zeros((16, 16))
    G[:3, :3], G[3:6, 3:6], G[6:, 6:] = -C, C, np.eye(10)
    root = np.concatenate([np.atleast_1d(value) for value in noise.values()])
    S = G @ np.diag(root**2) @ G.T

    def missed(step):
        block = expm(np.block([[-F, S], [np.zeros((16, 16)), F.T]]) * step)
        Phi = block[16:, 16:].T
        exact = Phi @ block[:16, 16:]
        scale = np.sqrt(np.outer(np.diag(exact), np.diag(exact)))
        ours = align.Q(**{k: v for k, v in at.items() if k in align.Q.fields}, **noise, dt=step)
        return np.abs(align.Phi(**at, dt=step) - Phi).max(), np.abs((ours - exact) / scale).max()

    (phi, noise_missed), (phi_half, noise_half) = missed(dt), missed(dt / 2)
    assert phi < 2 * dt**3
    assert noise_missed < 2e-6 * dt**3
    assert 6 < phi / phi_half < 10
    assert 6 < noise_missed / noise_half < 10
