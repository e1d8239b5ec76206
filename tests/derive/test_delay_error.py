"""The heading error of an unknown delay: the closed form against a least squares of exact rotations."""

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from boresight.derive.ledger.evaluate import Point, evaluate, solve
from boresight.derive.ledger.numbers import Matrix, exact, eye, middle, sqrt, zeros
from boresight.derive.papers import paper

PAPER = paper("delay-error")
OMEGA, TIME = 0.7, np.linspace(0, 2 * np.pi / 0.7, 200, endpoint=False)

pytestmark = pytest.mark.usefixtures("many_digits")


def closed(tau, omega, roll, pitch, phase, relation=0, **more):
    """The right side of (4), misalignment or heading error, rad."""
    values = {"τ": tau, "Ω": omega, "R": roll, "P": pitch, "ε": phase, **more}
    side = PAPER.equation("4").derived[relation].sides[1]
    return float(middle(evaluate(side, Point({name: exact(float(value)) for name, value in values.items()}))))


def averaged(**samples):
    """Letters of no mean and the second moments of samples over time, as E takes them."""
    count = exact(len(next(iter(samples.values()))))

    def number(value):
        return Matrix([exact(float(part)) for part in value]) if np.ndim(value) else exact(float(value))

    root = sqrt(count)
    columns = [tuple(number(value) / root for value in at) for at in zip(*samples.values(), strict=True)]
    mean = {name: zeros(len(v[0]), 1) if np.ndim(v[0]) else exact(0) for name, v in samples.items()}
    return {"random": {tuple(samples): columns}, "mean": mean}


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
    v, v_late = np.stack([v_north, v_east, 0 * TIME], -1), np.stack([*late, 0 * TIME], -1)
    a_north, a_east = 0.8 * OMEGA * np.cos(OMEGA * TIME), -0.5 * OMEGA * np.sin(OMEGA * TIME + 0.3)
    r, p = roll * np.sin(OMEGA * TIME), pitch * np.sin(OMEGA * TIME + phase)
    r_1, p_1 = roll * OMEGA * np.cos(OMEGA * TIME), pitch * OMEGA * np.cos(OMEGA * TIME + phase)
    moving = {"r_0": r, "p_0": p, "ṙ_0": r_1, "ṗ_0": p_1, "v_n": v_north, "v_e": v_east, "a_n": a_north, "a_e": a_east}
    means = averaged(**moving)
    for weight in (0.001, 0.03, 1.0):
        given = {"σ_a": exact(1), "σ_v": exact(1 / weight), "τ": exact(tau)}
        wanted = float(middle(evaluate(PAPER.equation("5").derived[0].sides[1], Point(means | given))))
        found = estimated(tau, roll, pitch, phase, 0.0, (v, v_late, weight))
        assert found[5] == pytest.approx(wanted, abs=0.01 * tau * OMEGA), weight
    plain = float(middle(evaluate(PAPER.equation("3").derived[0].sides[1], Point(means | {"τ": exact(tau)}))))
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
    means = averaged(e=e, **{"ė": rate})
    inertia = PAPER.equation("2").derived[1]
    wanted = solve((inertia,), {"μ̂": (3,)}, means | {"τ": exact(tau), "I": eye(3)})["μ̂"]
    np.testing.assert_allclose(found, [float(middle(part)) for part in wanted], atol=0.02 * tau * OMEGA)


def test_what_it_says_of_its_variables():
    form = closed(0.01, 0.7, 0.1, 0.05, 1.2)
    assert closed(0.01, 0.7, 0.3, 0.15, 1.2) == pytest.approx(form)  # the size of the sea cancels
    assert closed(0.01, 0.7, 0.1, 0.05, 1.2, relation=1) == -form
    assert closed(0.01, 0.7, 0.1, 0.05, 0.0) == 0
    assert closed(0.01, 0.7, 0.1, 0.1, -np.pi / 2) == pytest.approx(0.01 * 0.7)  # largest: tau omega
    sizes = [abs(closed(0.01, 0.7, 0.1, 0.1 * ratio, phase)) for ratio in (0.3, 1, 3) for phase in (-2, -1.5, 1, 3)]
    assert max(sizes) < 0.01 * 0.7
