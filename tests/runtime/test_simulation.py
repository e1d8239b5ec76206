"""The simulator obeys the laws of rigid bodies, held against NumPy written from finite rotations."""

import numpy as np
import pytest

from boresight.runtime import rotation
from boresight.runtime.simulation import sensors
from tests import numpy_euler_matching as witness

DEG = np.pi / 180
OMEGA = sensors.earth_rate_n(36 * DEG)
MOTION = sensors.Sinusoids(
    amplitude=np.array([[20.0, 10.0, 30.0], [0.0, 0.0, 0.0]]) * DEG,
    period=np.array([5.0, 7.0, 11.0]),
    phase=np.array([0.3, -1.0, 2.0]),
    mean=np.array([5.0, -10.0, 120.0]) * DEG,
)


def test_sinusoids_pass_their_mean_with_the_stated_rate_and_repeat_after_a_period():
    motion = sensors.Sinusoids(np.array([2.0, 3.0, 4.0]), np.array([4.0, 5.0, 8.0]), np.zeros(3), np.ones(3))
    assert np.allclose(motion.euler([0.0]), 1.0)
    assert np.allclose((motion.euler([1e-6]) - 1) / 1e-6, 2 * np.pi * np.array([2 / 4, 3 / 5, 4 / 8]))
    assert motion.euler([1.0])[0, 0] == pytest.approx(3.0)  # a quarter of roll's period
    assert np.allclose(motion.euler([0.7]), motion.euler([40.7]))


@pytest.mark.parametrize("dt", [0.01, 0.1, 1.0])
def test_increments_recompose_the_attitude(dt):
    q = rotation.quaternion_from_euler(MOTION.euler(np.arange(101) * dt))
    flown = q[0]
    for increment in rotation.body_increments(q, OMEGA, dt):
        flown = witness.strapdown(flown, increment, OMEGA, np.array(dt))
    assert np.abs(witness.matrix(flown) - witness.matrix(q[-1])).max() < 1e-12


def test_a_body_at_rest_senses_the_earth():
    q = rotation.quaternion_from_euler(np.tile([0.1, -0.2, 2.0], (3, 1)))
    rate = rotation.body_increments(q, OMEGA, 0.5) / 0.5
    assert np.allclose(rate, witness.matrix(q[0]).T @ OMEGA, rtol=0, atol=1e-15)
    # One turn against the stars in a stellar day, to the seven digits that WGS-84 gives the rate.
    assert np.linalg.norm(rate[0]) * 86164.0989 == pytest.approx(2 * np.pi, rel=0.5e-6 / 7.292115)
    assert OMEGA[0] > 0 > OMEGA[2]  # in the north the axis points north and up


def test_a_slave_flies_to_the_attitude_of_its_mounting():
    mu, dt = np.array([0.3, -0.2, 0.1]), 0.1
    q_m = rotation.quaternion_from_euler(MOTION.euler(np.arange(51) * dt))
    q_b = rotation.turned(q_m, mu)
    flown = q_b[0]
    for increment in sensors.mounted(rotation.body_increments(q_m, OMEGA, dt), mu):
        flown = witness.strapdown(flown, increment, OMEGA, np.array(dt))
    assert np.abs(rotation.attitude_error(flown, q_b[-1])).max() < 1e-12


def test_products_of_quaternions_are_products_of_their_matrices():
    """Of many by many, by one, and of one; of any norm."""
    rng = np.random.default_rng(3)
    for left, right in (((5, 1), (7,)), ((6,), ()), ((), ())):
        p, q, v = rng.normal(size=(*left, 4)), 3 * rng.normal(size=(*right, 4)), rng.normal(size=(*right, 3))
        turns = ((rotation.product(p, q), rotation.matrix_from_quaternion(q)),
                 (rotation.turned(p, v), rotation.matrix_from_vector(v)))  # fmt: skip
        for made, turn in turns:
            wanted = rotation.matrix_from_quaternion(p) @ turn
            assert np.abs(rotation.matrix_from_quaternion(made) - wanted).max() < 2e-15
            assert np.abs(np.linalg.norm(made, axis=-1) - 1).max() < 4e-16


def test_attitude_error_is_the_turn_that_removes_the_error():
    q = rotation.quaternion_from_euler(np.array([0.2, -0.4, 2.5]))
    eps = np.array([0.03, -0.02, 0.05])
    hat = witness.quaternion(witness.exp(-eps) @ witness.matrix(q))
    assert np.allclose(rotation.attitude_error(hat, q), eps, rtol=0, atol=1e-14)
    # Error = computed - true: to first order C_hat = (I - [eps x]) C.
    small = witness.quaternion((np.eye(3) - witness.cross(1e-6 * eps)) @ witness.matrix(q))
    assert np.allclose(rotation.attitude_error(small, q), 1e-6 * eps, rtol=0, atol=1e-13)


def test_a_runs_numbers_do_not_depend_on_the_runs_beside_it_nor_on_the_duration():
    whole = sensors.standard_normals(7, np.arange(12).reshape(3, 4), 50)
    chunks = [sensors.standard_normals(7, np.arange(a, b), 50) for a, b in ((0, 5), (5, 12))]
    assert np.array_equal(whole.reshape(12, 50), np.concatenate(chunks))
    assert np.array_equal(whole[..., :20], sensors.standard_normals(7, np.arange(12).reshape(3, 4), 20))
    assert not np.any(whole == sensors.standard_normals(8, np.arange(12).reshape(3, 4), 50))


def test_the_numbers_are_standard_normal():
    numbers = sensors.standard_normals(0, np.arange(400), 100)
    n = numbers.size
    assert abs(numbers.mean()) < 4 / np.sqrt(n)
    assert abs(numbers.var() - 1) < 4 * np.sqrt(2 / n)
    between_runs = numbers.mean(axis=1) * 10  # standard normal too, if the runs are independent
    assert abs(between_runs.var() - 1) < 4 * np.sqrt(2 / 400)
