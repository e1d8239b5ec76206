"""The heading error of an unknown delay: the closed form against a least squares of exact rotations."""

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation
from sympy import Symbol, lambdify, pi, simplify, sin

from boresight.derive.papers.kang_2025 import delay_error as d

OMEGA, TIME = 0.7, np.linspace(0, 2 * np.pi / 0.7, 200, endpoint=False)
closed = lambdify((d.DELAY, d.FREQUENCY, *d.AMPLITUDES, d.PHASE), d.sinusoidal())


def attitude(time, roll, pitch, phase, heading):
    r, p = roll * np.sin(OMEGA * time), pitch * np.sin(OMEGA * time + phase)
    return Rotation.from_euler("ZYX", np.stack([np.full_like(time, heading), p, r], axis=-1))


def estimated(tau, roll, pitch, phase, heading=0.0, velocity=None):
    """(phi, dmu) that explain best what an exact slave sees of a master that is late, as finite rotations.

    velocity: (T, 2), north and east, with its acceleration and the weight of a m/s against a rad.
    """
    now, late = (attitude(TIME - age, roll, pitch, phase, heading) for age in (0.0, tau))

    def left(x):
        phi, dmu = x[:3], x[3:]
        turn = (Rotation.from_rotvec(-phi) * now * Rotation.from_rotvec(dmu) * late.inv()).as_rotvec()
        if velocity is None:
            return turn.ravel()
        v, v_late, weight = velocity
        v_hat = Rotation.from_rotvec([0, 0, -phi[2]]).apply(v)
        return np.concatenate([turn.ravel(), weight * (v_hat - v_late)[:, :2].ravel()])

    return least_squares(left, np.zeros(6), xtol=1e-15, ftol=1e-15, gtol=1e-15).x


@pytest.mark.parametrize(
    "ratio, phase, heading", [(0.5, 1.5, 0.0), (1.0, -np.pi / 2, 2.0), (2.0, 0.6, 4.0), (0.3, 3.0, 1.0)]
)
def test_an_unknown_delay_turns_the_heading_by_the_closed_form(ratio, phase, heading):
    tau, roll = 0.008, 0.05
    x = estimated(tau, roll, ratio * roll, phase, heading)
    wanted = closed(tau, OMEGA, roll, ratio * roll, phase)
    assert x[5] == pytest.approx(wanted, abs=0.003 * tau * OMEGA)
    assert x[2] == pytest.approx(x[5], abs=0.003 * tau * OMEGA)  # phi_d = dmu_z: the heading errs by -dmu_z
    np.testing.assert_allclose(x[3:5], 0.0, atol=0.01 * tau * OMEGA)


def test_what_the_closed_form_leaves_out_falls_fourfold_when_the_sea_is_halved():
    left = [estimated(1e-3, a, 0.5 * a, 1.2)[5] - closed(1e-3, OMEGA, a, 0.5 * a, 1.2) for a in (0.2, 0.1, 0.05)]
    assert left[0] / left[1] == pytest.approx(4.0, rel=0.1)
    assert left[1] / left[2] == pytest.approx(4.0, rel=0.1)
    assert abs(left[0]) < 0.02 * 1e-3 * OMEGA


def test_the_velocity_has_its_say_by_its_weight():
    tau, roll, pitch, phase = 0.005, 0.03, 0.015, 1.0
    v_north, v_east = 0.8 * np.sin(OMEGA * TIME), 0.5 * np.cos(OMEGA * TIME + 0.3)
    late = (0.8 * np.sin(OMEGA * (TIME - tau)), 0.5 * np.cos(OMEGA * (TIME - tau) + 0.3))
    zero = np.zeros_like(TIME)
    v, v_late = np.stack([v_north, v_east, zero], -1), np.stack([*late, zero], -1)
    a_north, a_east = 0.8 * OMEGA * np.cos(OMEGA * TIME), -0.5 * OMEGA * np.sin(OMEGA * TIME + 0.3)
    r, p = roll * np.sin(OMEGA * TIME), pitch * np.sin(OMEGA * TIME + phase)
    r_1, p_1 = roll * OMEGA * np.cos(OMEGA * TIME), pitch * OMEGA * np.cos(OMEGA * TIME + phase)
    values = dict(zip(d.MOVING, (r, p, zero, r_1, p_1, zero, v_north, v_east, a_north, a_east), strict=True))
    means = {d.moment(a, b): np.mean(values[a] * values[b]) for a in values for b in values}
    for weight in (0.001, 0.03, 1.0):
        form = d.steady_misalignment_with_velocity()
        given = {**means, d.SIGMA_ANGLE: 1.0, d.SIGMA_VELOCITY: 1 / weight, d.DELAY: tau}
        wanted = float(form.subs(given))
        found = estimated(tau, roll, pitch, phase, 0.0, (v, v_late, weight))
        assert found[5] == pytest.approx(wanted, abs=0.01 * tau * OMEGA), weight
    plain = float(d.steady_misalignment().subs({**means, d.DELAY: tau}))
    assert plain == pytest.approx(closed(tau, OMEGA, roll, pitch, phase), rel=1e-6)


def test_with_yaw_the_swing_turns_on_like_a_rigid_body():
    """Roll, pitch and yaw of two frequencies each, against the least squares of exact rotations."""
    tau, scale, turn = 0.004, 0.02, np.array([1.0, 0.6, 0.4])
    phase = np.array([[0.0, 1.2, 2.5], [0.3, -0.7, 4.0]])
    wave = np.array([OMEGA, 2 * OMEGA])

    def swing(time):
        return scale * turn * np.sin(wave[:, None] * time[:, None, None] + phase).sum(axis=1)

    now, late = (Rotation.from_euler("ZYX", swing(TIME - age)[:, ::-1]) for age in (0.0, tau))

    def left(x):
        return (Rotation.from_rotvec(-x[:3]) * now * Rotation.from_rotvec(x[3:]) * late.inv()).as_rotvec().ravel()

    found = least_squares(left, np.zeros(6), xtol=1e-15, ftol=1e-15, gtol=1e-15).x[3:]
    e = swing(TIME)
    rate = scale * turn * (wave[:, None] * np.cos(wave[:, None] * TIME[:, None, None] + phase)).sum(axis=1)
    values = dict(zip(d.MOVING[:6], (*e.T, *rate.T), strict=True))
    means = {d.moment(a, b): np.mean(values[a] * values[b]) for a in values for b in values}
    J, L = (np.array(part.subs(means), float) for part in (d.spread(), d.spin()))
    np.testing.assert_allclose(found, tau * np.linalg.solve(J, L[:, 0]), atol=0.02 * tau * OMEGA)
    # and that is the minimum of the model's own residual
    dmu = d.minimum((d.residual(), 1))
    assert simplify(d.spread() * d.DMU.subs(dmu) - d.DELAY * d.spin()) == d.zeros(3, 1)


def test_what_it_says_of_its_variables():
    form, s = d.sinusoidal(), Symbol("s", positive=True)
    larger = form.subs({d.ROLL_AMPLITUDE: s * d.ROLL_AMPLITUDE, d.PITCH_AMPLITUDE: s * d.PITCH_AMPLITUDE})
    assert simplify(larger - form) == 0
    assert form.subs(d.PHASE, 0) == 0
    circle = form.subs({d.PITCH_AMPLITUDE: d.ROLL_AMPLITUDE, d.PHASE: -pi / 2})
    assert simplify(circle - d.DELAY * d.FREQUENCY) == 0
    assert simplify(form - circle * -2 * d.ROLL_AMPLITUDE * d.PITCH_AMPLITUDE * sin(d.PHASE)
                    / (d.ROLL_AMPLITUDE**2 + d.PITCH_AMPLITUDE**2)) == 0  # fmt: skip


def test_the_derivation_shows_every_step_with_a_reason():
    steps = d.derivation().steps
    assert [step.name for step in steps] == [
        "substitute", "keep first order", "leave out the mean", "least squares", "keep the yaw at rest",
        "insert sinusoids", "look at it", "add the velocity",
    ]  # fmt: skip
    assert all(step.why for step in steps)
