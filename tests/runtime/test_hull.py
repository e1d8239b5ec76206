"""The hull in waves: kinematics against numerical differentiation, and what a hull does in waves that are long."""

import numpy as np
import pytest

from boresight.runtime import rotation
from boresight.runtime.simulation import hull, sea, sensors

DEG = np.pi / 180
STEP = 1e-4
COURSE = dict(towards=np.array([0.3, 2.1, 4.0]), heading=np.array([0.0, 0.7, 5.0]), speed=np.array([0.0, 4.0, 2.0]))


def rough_sea(runs=3, **course):
    omega, elevation = sea.components(4.0, count=50)
    streams = [sensors.generator(1, run) for run in range(runs)]
    return hull.in_sea(hull.Hull(), omega, elevation, hull.phases(streams, 50), **(course or COURSE))


def slave_of(motion, time):
    mounting = rotation.quaternion_from_euler(np.array([1.0, -2.0, 30.0]) * DEG)
    flexure = hull.bending(np.array([1.0, 2.0, 0.5]) * 1e-3, 1.0, np.linspace(0, 40, 90).reshape(1, 90))
    place = np.array([5.0, -1.0, -4.0])
    return hull.carried(hull.ride(motion, time, place), np.array([1.5, -0.7, 0.4]), mounting, flexure)


@pytest.mark.parametrize("point", [lambda m, t: hull.ride(m, t, [5.0, -1.0, -4.0]), slave_of])
def test_rates_are_the_derivatives_of_what_they_are_the_rates_of(point):
    time = np.linspace(1.0, 50.0, 40)
    motion = rough_sea()
    back, now, ahead = (point(motion, time + shift) for shift in (-STEP, 0.0, STEP))
    for value, rate in (("displacement_n", "v_n"), ("v_n", "a_n"), ("omega_nb_b", "alpha_nb_b")):
        numerical = (getattr(ahead, value) - getattr(back, value)) / (2 * STEP)
        analytic = getattr(now, rate)
        assert np.abs(analytic).max() > 0.1
        np.testing.assert_allclose(numerical, analytic, atol=2e-7 * np.abs(analytic).max())
    # attitude_error is in n: the turn that leads from back to ahead
    turn_n = rotation.attitude_error(back.q_b2n_wxyz, ahead.q_b2n_wxyz) / (2 * STEP)
    C = rotation.matrix_from_quaternion(now.q_b2n_wxyz)
    np.testing.assert_allclose(turn_n, np.einsum("...ij,...j->...i", C, now.omega_nb_b), atol=1e-7)


def test_each_run_at_its_own_time_is_the_hull_at_that_time():
    motion, time = rough_sea(), np.array([3.0, 17.0])
    late = np.array([0.0, 0.005, 0.01])
    own = hull.ride(motion, time[:, None] - late)
    for run, delay in enumerate(late):
        common = hull.ride(motion, time - delay)
        np.testing.assert_allclose(own.v_n[:, run], common.v_n[:, run], atol=1e-12)
        np.testing.assert_allclose(own.q_b2n_wxyz[:, run], common.q_b2n_wxyz[:, run], atol=1e-12)
        np.testing.assert_allclose(own.displacement_n[:, run], common.displacement_n[:, run], atol=1e-10)


def test_a_rigid_slave_keeps_lever_arm_and_mounting_and_obeys_equation_1_of_the_paper():
    motion, time = rough_sea(), np.linspace(0, 60, 7)
    lever, mounting = np.array([1.5, -0.7, 0.4]), rotation.quaternion_from_euler(np.array([1.0, -2.0, 30.0]) * DEG)
    master = hull.ride(motion, time)
    slave = hull.carried(master, lever, mounting)
    C_b2n, C_m2n = (rotation.matrix_from_quaternion(pose.q_b2n_wxyz) for pose in (slave, master))
    np.testing.assert_allclose(np.swapaxes(C_m2n, -1, -2) @ C_b2n, np.broadcast_to(
        rotation.matrix_from_quaternion(mounting), C_b2n.shape), atol=1e-12)  # fmt: skip
    arm = slave.displacement_n - master.displacement_n
    np.testing.assert_allclose(arm, C_b2n @ lever, atol=1e-9)
    # v_m = v_s - C (omega_nb x lever), in a level that stands still
    swing = np.einsum("...ij,...j->...i", C_b2n, np.cross(slave.omega_nb_b, lever))
    np.testing.assert_allclose(master.v_n, slave.v_n - swing, atol=1e-12)


@pytest.mark.parametrize("towards", np.arange(12) * 30 * DEG)
def test_in_long_waves_the_hull_is_a_chip_on_the_surface(towards):
    """The surface and the water's orbits of a wave of 1 m, differentiated here by hand at the chip."""
    omega, course = 0.005, 0.4
    omega_e, answer = hull.response(hull.Hull(), omega, towards)
    assert omega_e == omega
    motion = hull.in_sea(hull.Hull(), np.array([omega]), np.array([1.0]), np.zeros(1), towards=towards + course,
                         heading=course)  # fmt: skip
    k = omega**2 / 9.80665
    north, east = k * np.cos(towards + course), k * np.sin(towards + course)

    def elevation(t, n, e):
        return np.cos(omega * t - north * n - east * e)

    def orbit(t, n, e):
        """Displacement of the water along the waves, whose rate is omega elevation."""
        return np.sin(omega * t - north * n - east * e)

    time = np.linspace(0, 2 * np.pi / omega, 25)
    chip, h = hull.ride(motion, time), 1.0
    along, right = np.array([np.cos(course), np.sin(course)]), np.array([-np.sin(course), np.cos(course)])
    wave = np.array([north, east]) / k
    close = dict(rtol=0, atol=0.005)  # of 1 m: heave lags by 0.8 of 0.005 / 1.57 rad
    np.testing.assert_allclose(chip.displacement_n[:, 2], -elevation(time, 0, 0), **close)
    np.testing.assert_allclose(chip.displacement_n[:, :2], orbit(time, 0, 0)[:, None] * wave, **close)

    def slope(function, axis):
        return (function(time, *(h * axis)) - function(time, *(-h * axis))) / (2 * h)

    euler = rotation.euler_from_matrix(rotation.matrix_from_quaternion(chip.q_b2n_wxyz)) - [0, 0, course]
    np.testing.assert_allclose(euler[:, 1], slope(elevation, along), rtol=0, atol=0.005 * k)
    np.testing.assert_allclose(euler[:, 0], -slope(elevation, right), rtol=0, atol=0.005 * k)
    np.testing.assert_allclose(euler[:, 2], slope(orbit, along) * (wave @ right), rtol=0, atol=0.005 * k)
    assert np.abs(answer[3]) == pytest.approx(k * abs(np.sin(towards)), rel=0.002, abs=1e-9)


def test_roll_has_its_resonance_and_short_waves_move_nothing():
    one = hull.Hull()
    beam = np.pi / 2
    natural = 2 * np.pi / one.roll_period_s
    _, at = hull.response(one, np.array([0.05, natural, 12.0]), beam)
    k = sea.wave_number(np.array([0.05, natural, 12.0]))
    amplification = np.abs(at[:, 3]) / k
    forced = np.exp(-k[1] * one.draught_m) * hull.slope_of_wave(k[1] * one.beam_m / 2)
    assert amplification[1] == pytest.approx(forced / (2 * one.roll_damping), rel=1e-9)
    assert np.angle(at[1, 3] / (1j * k[1])) == pytest.approx(-np.pi / 2)  # a quarter of a period behind the slope
    assert np.all(np.abs(at[2]) < 1e-6)


def test_the_encounter_is_that_of_deep_water():
    omega, speed = 0.8, 6.0
    head, _ = hull.response(hull.Hull(), omega, np.pi, speed)
    following, _ = hull.response(hull.Hull(), omega, 0.0, speed)
    assert head == pytest.approx(omega + omega**2 * speed / 9.80665)
    assert following == pytest.approx(omega - omega**2 * speed / 9.80665)
    # a hull that keeps up with the waves: no number without bound in velocity or attitude
    _, answer = hull.response(hull.Hull(), 9.80665 / speed, 0.0, speed)
    assert np.isfinite(answer).all() and np.abs(answer[2:]).max() < 2.0


def test_mean_and_slope_over_the_hull_are_the_integrals_they_stand_for():
    x = np.linspace(-1, 1, 20001)
    for reach in (1e-3, 0.009, 0.011, 0.5, 3.0):
        assert hull.mean_of_wave(np.array(reach)) == pytest.approx(np.trapezoid(np.cos(reach * x), x) / 2, abs=1e-7)
        best = np.trapezoid(np.sin(reach * x) * x, x) / np.trapezoid(x * x, x)
        assert hull.slope_of_wave(np.array(reach)) == pytest.approx(best / reach, abs=1e-6)


def test_motion_by_slope_follows_the_slope():
    a, f = 2.5, 0.1
    motion = hull.by_slope(a, f, [1.0, 0.5, 0.2], [np.pi / 2, np.pi, 0.0], heading=1.0)
    time = np.linspace(0, 10, 41)
    euler = motion.freedoms.at(time)[:, 3:]
    k = (2 * np.pi * f) ** 2 / 9.80665
    np.testing.assert_allclose(euler[:, 0], k * a * np.cos(2 * np.pi * f * time), atol=1e-12)
    np.testing.assert_allclose(euler[:, 1], -0.5 * k * a * np.sin(2 * np.pi * f * time), atol=1e-12)
    np.testing.assert_allclose(
        hull.ride(motion, time).displacement_n[:, 2], -a * np.sin(2 * np.pi * f * time), atol=1e-12
    )


def test_bending_is_a_second_order_markov_process():
    sigma, correlation = np.array([1.0, 2.0, 0.5]) * 1e-3, 0.8
    runs = 400
    streams = [sensors.generator(3, run) for run in range(runs)]
    flexure = hull.bending(sigma, correlation, hull.phases(streams, 3 * 60))
    lag = np.array([0.0, 0.4, 0.8, 1.6])
    theta = flexure.at(5.0 + lag)
    b = 1 / correlation
    found = np.mean(theta[:1] * theta, axis=1) / sigma**2
    wanted = (1 + b * lag) * np.exp(-b * lag)
    # 400 runs: a correlation scatters by 1 / sqrt(400) of 1.4 or less; the slowest 1.3 % are spread over the rest
    np.testing.assert_allclose(found.mean(axis=1), wanted, atol=4 * 1.4 / np.sqrt(3 * runs) + 0.01)
    # in the mean over all phases, exactly
    power = np.abs(flexure.amplitude[0]) ** 2 / 2
    exact = power @ np.cos(np.outer(flexure.omega, lag)) / sigma[:, None] ** 2
    np.testing.assert_allclose(exact, np.tile(wanted, (3, 1)), atol=0.01)


def test_a_runs_motion_does_not_depend_on_the_runs_beside_it():
    time = np.linspace(0, 20, 5)
    course = dict(towards=2.0, heading=0.3)
    many, few = (hull.ride(rough_sea(runs, **course), time) for runs in (5, 2))
    np.testing.assert_array_equal(many.v_n[:, :2], few.v_n)
