"""Converters at the border: they are rotations, they come back, and a nose that goes up goes up in every convention."""

import itertools

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from boresight import BoresightError
from boresight.runtime import frames, rotation

RNG = np.random.default_rng(7)
EULER = np.column_stack([RNG.uniform(-3, 3, 200), RNG.uniform(-1.4, 1.4, 200), RNG.uniform(-3, 3, 200)])
DEG = np.pi / 180


def test_named_axes_keep_their_physical_direction():
    v_rfu = np.array([1.0, 2.0, 3.0])  # 1 to the right, 2 forward, 3 up
    np.testing.assert_array_equal(frames.body_to_frd("RFU") @ v_rfu, [2, 1, -3])
    np.testing.assert_array_equal(frames.body_to_frd("FLU") @ v_rfu, [1, -2, -3])
    np.testing.assert_array_equal(frames.navigation_to_ned("ENU") @ v_rfu, [2, 1, -3])
    np.testing.assert_array_equal(frames.navigation_to_ned("NWU") @ v_rfu, [1, -2, -3])


@pytest.mark.parametrize(("convert", "letters"), [(frames.body_to_frd, "FBRLDU"), (frames.navigation_to_ned, "NSEWDU")])
def test_every_triad_is_a_proper_rotation_or_is_refused(convert, letters):
    accepted = 0
    for name in map("".join, itertools.product(letters, repeat=3)):
        try:
            T = convert(name)
        except BoresightError:
            continue
        np.testing.assert_array_equal(T @ T.T, np.eye(3))
        assert np.linalg.det(T) == 1
        accepted += 1
    assert accepted == 24  # 48 orders and signs of three axes, half of them left-handed
    for wrong in ("FRU", "ENX", "FR", "", "frd", "FFD"):
        with pytest.raises(BoresightError, match="right-handed"):
            convert(wrong)


def test_euler_angles_match_scipy_and_come_back():
    expected = Rotation.from_euler("ZYX", EULER[:, ::-1])
    C = rotation.matrix_from_euler(EULER)
    np.testing.assert_allclose(C, expected.as_matrix(), atol=4e-16)
    np.testing.assert_allclose(rotation.euler_from_matrix(C), EULER, atol=2e-15)
    np.testing.assert_allclose(rotation.matrix_from_quaternion(rotation.quaternion_from_euler(EULER)), C, atol=2e-15)
    np.testing.assert_allclose(rotation.matrix_from_quaternion(expected.as_quat(scalar_first=True)), C, atol=2e-15)


def test_pitch_roll_yaw_of_rfu_in_enu_is_roll_pitch_heading_of_frd_in_ned():
    """The recording's definition: C_b2n = Rz(yaw) Rx(pitch) Ry(roll), RFU to ENU, with yaw counter-clockwise."""
    pitch_roll_yaw = EULER[:, [1, 0, 2]]
    C_rfu_to_enu = Rotation.from_euler("ZXY", pitch_roll_yaw[:, [2, 0, 1]]).as_matrix()
    C_b2n = frames.attitude_to_ned(C_rfu_to_enu, "RFU", "ENU")
    euler = frames.euler_from_angles(pitch_roll_yaw, ("pitch", "roll", "yaw"), "counter-clockwise")
    np.testing.assert_allclose(rotation.matrix_from_euler(euler), C_b2n, atol=1e-15)
    np.testing.assert_allclose(rotation.euler_from_matrix(C_b2n), euler, atol=3e-15)
    back = frames.angles_from_euler(euler, ("pitch", "roll", "yaw"), "counter-clockwise")
    np.testing.assert_allclose(back, pitch_roll_yaw, atol=1e-15)


@pytest.mark.parametrize("order", list(itertools.permutations(frames.ANGLES)))
@pytest.mark.parametrize("yaw_positive", ["clockwise", "counter-clockwise"])
def test_any_order_of_angles_comes_back(order, yaw_positive):
    there = frames.angles_from_euler(EULER, order, yaw_positive)
    np.testing.assert_allclose(frames.euler_from_angles(there, order, yaw_positive), EULER, atol=1e-15)


def test_positive_angles_mean_right_side_down_nose_up_and_turn_to_the_east():
    front, right = np.eye(3)[0], np.eye(3)[1]
    assert (rotation.matrix_from_euler([10 * DEG, 0, 0]) @ right)[2] > 0.17  # right wing down
    assert (rotation.matrix_from_euler([0, 10 * DEG, 0]) @ front)[2] < -0.17  # nose up
    assert (rotation.matrix_from_euler([0, 0, 10 * DEG]) @ front)[1] > 0.17  # nose to the east
    # Ten degrees to the left of north, given counter-clockwise, is a nose to the west.
    west = frames.euler_from_angles([0, 0, 10 * DEG], yaw_positive="counter-clockwise")
    assert (rotation.matrix_from_euler(west) @ front)[1] < -0.17


def test_rotation_vector_is_the_inverse_of_the_exponential_down_to_zero():
    for size in (0.0, 1e-12, 1e-6, 0.1, 1.0, 3.0):
        v = size * EULER / np.linalg.norm(EULER, axis=1, keepdims=True)
        C = rotation.matrix_from_vector(v)
        np.testing.assert_allclose(C, Rotation.from_rotvec(v).as_matrix(), atol=2e-15)
        np.testing.assert_allclose(rotation.vector_from_matrix(C), v, rtol=0, atol=1e-14)


def test_a_wrong_order_or_sign_of_yaw_is_refused():
    with pytest.raises(BoresightError, match="roll, pitch and yaw once"):
        frames.euler_from_angles(EULER, ("roll", "pitch", "pitch"))
    with pytest.raises(BoresightError, match="clockwise"):
        frames.euler_from_angles(EULER, yaw_positive="left")
