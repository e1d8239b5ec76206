"""Rotations against what defines them: the cross product, the power series, the round trip."""

import random

import mpmath as mp
import pytest
from sympy import Float, Matrix, eye, simplify, symbols, zeros

from boresight.derive.mechanics import rotation as rot

DIGITS = 40


def vector(seed, size=3, scale=1.0):
    generator = random.Random(seed)
    return Matrix([Float(scale * generator.uniform(-1, 1), DIGITS) for _ in range(size)])


def distance(A, B):
    return max(abs(a.evalf(DIGITS)) for a in A - B)


def power_series(e):
    with mp.workdps(DIGITS):
        return Matrix(3, 3, [Float(x, DIGITS) for x in mp.expm(mp.matrix(rot.skew(e).tolist()))])


def test_skew_is_the_cross_product_and_vee_its_inverse():
    v, w = Matrix(symbols("x:3")), Matrix(symbols("y:3"))
    assert rot.skew(v) * w == v.cross(w)
    assert rot.vee(rot.skew(v)) == v
    assert rot.small_rotation(v) * w == w + v.cross(w)


@pytest.mark.parametrize("axis, about", [(0, rot.rotation_x), (1, rot.rotation_y), (2, rot.rotation_z)])
def test_elementary_rotation_is_the_exponential_of_its_axis(axis, about):
    e = zeros(3, 1)
    e[axis] = Float("0.7", DIGITS)
    assert distance(about(e[axis]), power_series(e)) < 1e-29


@pytest.mark.parametrize("scale", [3.0, 0.05, 1e-6, 1e-12, 0.0])
def test_rotation_vector_gives_the_exponential_down_to_zero(scale):
    e = vector(3, scale=scale)
    assert distance(rot.dcm_from_rotation_vector(e), power_series(e)) < 1e-29


def test_zero_rotation_vector_is_the_unit_quaternion():
    assert distance(rot.quaternion_from_rotation_vector([0, 0, 0]), Matrix([1, 0, 0, 0])) < 1e-30


def test_quaternion_product_multiplies_the_matrices():
    p, q = (rot.quaternion_from_rotation_vector(vector(seed)) for seed in (4, 5))
    product = rot.dcm_from_quaternion(rot.quaternion_product(p, q))
    assert distance(product, rot.dcm_from_quaternion(p) * rot.dcm_from_quaternion(q)) < 1e-29


def test_euler_angles_survive_the_round_trip():
    angles = Matrix([Float(x, DIGITS) for x in ("-2.9", "1.5", "3.1")])
    assert distance(rot.euler_from_dcm(rot.dcm_from_euler(*angles)), angles) < 1e-29


def test_c_b2n_is_a_rotation_and_its_third_row_holds_no_yaw():
    roll, pitch, yaw = symbols("roll pitch yaw", real=True)
    C = rot.dcm_from_euler(roll, pitch, yaw)
    assert simplify(C * C.T) == eye(3)
    assert not C[2, :].has(yaw)
